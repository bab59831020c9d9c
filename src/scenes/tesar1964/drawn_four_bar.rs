//! Chapter VI: a four-bar drawn beside pole tangent and pole normal.

use crate::formula::Bindings;
use crate::number::{Number, Real, count};
use crate::plane::{Angle, Point, relation};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/drawn-four-bar",
    "Any four-bar in any position, anywhere in the U,V plane. The x-axis leads from the pivot O_a, its \
     origin, to O_b. Fixed link, crank, coupler and the side AD of the coupler triangle are free by \
     lengths and directions; the other crank and BD are what remains. One more point is given in both \
     systems.",
    build,
    [
        "U_i": "coordinate of the pivot O_a",
        "V_i": "coordinate of the pivot O_a",
        "U_{i+1}": "coordinate of the pivot O_b",
        "V_{i+1}": "coordinate of the pivot O_b",
        "UP_i": "coordinate of the pin A",
        "VP_i": "coordinate of the pin A",
        "UP_{i+1}": "coordinate of the pin B",
        "VP_{i+1}": "coordinate of the pin B",
        "UP_1": "coordinate of the output point D, also where i is 1",
        "VP_1": "coordinate of the output point D, also where i is 1",
        "Q": "length of the fixed link O_aO_b",
        "R": "length of the crank O_aA",
        "S": "length of the coupler AB",
        "T": "length of the crank O_bB",
        "M": "distance of D from A",
        "N": "distance of D from B",
        "epsilon": "from AB to AD",
        "theta_i": "from the U-axis to the x-axis",
        "phi_0": "from the x-axis to the direction from O_a to A",
        "psi_0": "from the x-axis to the direction from O_b to B",
        "chi_0": "from the x-axis to the direction from A to B",
        "xJ": "coordinate of D",
        "yJ": "coordinate of D",
        "Mx": "component of AD along the x-axis",
        "My": "component of AD along the y-axis",
        "xxP": "component of O_aA along the x-axis",
        "yyP": "component of O_aA along the y-axis",
        "xPx": "component of O_bB along the x-axis",
        "yPy": "component of O_bB along the y-axis",
        "x_i": "coordinate of any point",
        "y_i": "coordinate of any point",
        "U": "coordinate of the same point",
        "V": "coordinate of the same point",
        "unit": "average of Q, R, S, T and of the average of M and N",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (origin, theta) = (point(free, "O_a")?, free.angle("theta_i")?);
    let (q, r) = (free.length("Q")?, free.length("R")?);
    let (s, m) = (free.length("S")?, free.length("M")?);
    let (phi, chi) = (free.angle("phi_0")?, free.angle("chi_0")?);
    let epsilon = free.angle("epsilon")?;
    let any = point(free, "any point")?;
    // In the x,y system.
    let o_b = Point::from(q.clone());
    let crank = phi.cis().scaled(&r);
    let side = (&chi + &epsilon).cis().scaled(&m);
    let (b, d) = (&crank + chi.cis().scaled(&s), &crank + &side);
    let other_crank = &b - &o_b;
    let t = free.root("T", &other_crank.norm())?;
    let n = free.root("N", &relation::distance_squared(&b, &d))?;
    let psi = Angle::of_known_length(other_crank.clone(), t.clone());
    let unit = mean([
        q.clone(),
        r.clone(),
        s.clone(),
        t.clone(),
        mean([m.clone(), n.clone()]),
    ]);
    let drawn = |point: &Point<K>| &origin + theta.cis() * point;
    let places = [
        ("U_i", "V_i", origin.clone()),
        ("U_{i+1}", "V_{i+1}", drawn(&o_b)),
        ("UP_i", "VP_i", drawn(&crank)),
        ("UP_{i+1}", "VP_{i+1}", drawn(&b)),
        ("UP_1", "VP_1", drawn(&d)),
        ("U", "V", drawn(&any)),
        ("x_i", "y_i", any),
        ("xJ", "yJ", d),
        ("Mx", "My", side),
        ("xxP", "yyP", crank),
        ("xPx", "yPy", other_crank),
    ];
    let mut bindings = Bindings::new(free.precision());
    for (x, y, place) in places {
        bindings.bind(x, free.among_all(place.re().clone()));
        bindings.bind(y, free.among_all(place.im().clone()));
    }
    for (name, value) in [
        ("Q", q),
        ("R", r),
        ("S", s),
        ("T", t),
        ("M", m),
        ("N", n),
        ("unit", unit),
    ] {
        bindings.bind(name, value);
    }
    for (name, angle) in [
        ("theta_i", theta),
        ("phi_0", phi),
        ("chi_0", chi),
        ("psi_0", psi),
        ("epsilon", epsilon),
    ] {
        bindings.bind(name, angle);
    }
    Ok(bindings)
}

fn mean<K: Real, const COUNT: usize>(lengths: [Number<K>; COUNT]) -> Number<K> {
    lengths.into_iter().sum::<Number<K>>() / count::to_i64(COUNT)
}
