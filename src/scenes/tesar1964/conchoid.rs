//! Chapter V: the conchoidal linkage.

use super::sense::sense;
use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::projective::{Line, ProjectivePoint};
use crate::plane::{Angle, Point, relation};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const CURVE: Scene = scene!(
    "tesar1964/conchoid",
    "A line through a fixed point, which is the origin of polar coordinates, meets a fixed line in D \
     and carries a point at a fixed distance from D.",
    build_curve,
    [
        "rho": "from the fixed point to the point of the curve, along the ray towards D",
        "phi": "from the perpendicular to the fixed line to the ray",
        "a": "from D to the point of the curve, along the ray; positive away from the fixed point",
        "b": "distance of the fixed point from the fixed line",
    ]
);

pub const SCENE: Scene = scene!(
    "tesar1964/conchoidal-linkage",
    "A line through the fixed point O_b = (0, 1) meets the U-axis in the output point D and carries \
     the pin A at the distance r from D, on the side of O_b. It makes an angle alpha with the \
     V-axis, less than a right one. O_a is the point of the V-axis that is as far from A as from A', \
     where A is for alpha = 0; A' is always on its positive side. B is on the perpendicular to the \
     line in O_b. Angles turn from U to V.",
    build,
    [
        "r": "distance of A from D",
        "alpha": "from the V-axis to the line, positive where D is on the positive U-axis",
        "k": "length of the crank O_bB",
        "n": "-1 where B is below O_b for a positive alpha, else +1",
        "R": "length of the crank O_aA",
        "U": "coordinate of any point of the circle of A",
        "V": "coordinate of any point of the circle of A",
        "V_1": "coordinate of O_a",
        "UP_1": "coordinate of A",
        "VP_1": "coordinate of A",
        "UP_2": "coordinate of B",
        "VP_2": "coordinate of B",
        "S": "length of the coupler AB",
        "M": "distance of D from A",
        "N": "distance of D from B",
        "epsilon": "from AB to AD",
    ]
);

pub const FIXED_LINK: Scene = scene!(
    "tesar1964/conchoidal-fixed-link",
    "The same, and its fixed link, from O_a to O_b.",
    build_fixed_link,
    not symbolic: "the sign of a difference of free symbols",
    [
        "r": "distance of A from D",
        "alpha": "from the V-axis to the line, positive where D is on the positive U-axis",
        "R": "length of the crank O_aA",
        "V_1": "coordinate of O_a",
        "V_2": "coordinate of O_b",
        "Q": "length of the fixed link",
        "theta": "direction from O_a to O_b",
    ]
);

fn build_curve<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (a, b) = (free.number("a")?, free.length("b")?);
    let phi = free.angle("phi")?;
    let d = meet(&Number::zero(), &phi.cis(), &b.clone().into(), &Number::i());
    let point = d + phi.cis().scaled(&a);
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("rho", (point * phi.cis().conj()).re().clone());
    bindings.bind("phi", phi);
    bindings.bind("a", a);
    bindings.bind("b", b);
    Ok(bindings)
}

/// Where two lines meet, each by a point and its direction.
fn meet<K: Real>(p: &Point<K>, along: &Point<K>, q: &Point<K>, direction: &Point<K>) -> Point<K> {
    let line = |point, direction| {
        let point = ProjectivePoint::from_finite(point);
        Line::through(&point, &ProjectivePoint::from_direction(direction))
    };
    let meet = line(p, along).meet(&line(q, direction));
    let [x, y, w] = meet.coordinates();
    Number::complex(x / w, y / w)
}

struct Linkage<K> {
    r: Number<K>,
    alpha: Angle<K>,
    /// Of the V-axis.
    o_a: Number<K>,
    crank: Number<K>,
    a: Point<K>,
    d: Point<K>,
}

fn o_b<K: Real>() -> Point<K> {
    Number::i()
}

fn linkage<K: Real>(free: &mut dyn Free<K>) -> Result<Linkage<K>, Unbuilt> {
    let r = free.length("r")?;
    let alpha = free.slope("alpha")?;
    Unbuilt::unless_real(
        alpha.cos().is_positive(),
        "alpha is less than a right angle",
    )?;
    let upwards = Point::<K>::i() * alpha.cis();
    let d = meet(&o_b(), &upwards, &Number::zero(), &Number::one());
    let a = &d + upwards.scaled(&r);
    // |A|² − 2v Im A = r² − 2vr.
    let o_a = (a.norm() - r.square()) / (2 * (a.im() - &r));
    let crank = &r - &o_a;
    Unbuilt::unless_true::<K>(crank.is_positive(), "A' is on the positive side of O_a")?;
    Ok(Linkage {
        r,
        alpha,
        o_a,
        crank,
        a,
        d,
    })
}

impl<K: Real> Linkage<K> {
    fn bind(self, bindings: &mut Bindings<K>) {
        bindings.bind("alpha", self.alpha);
        bindings.bind("r", self.r);
        bindings.bind("V_1", self.o_a);
        bindings.bind("R", self.crank);
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let linkage = linkage(free)?;
    let k = free.length("k")?;
    let sense = sense(free, "n")?;
    let Linkage { a, d, .. } = &linkage;
    let b = o_b::<K>() + linkage.alpha.cis().scaled(&(&k * &sense));
    let m = free.root("M", &relation::distance_squared(a, d))?;
    let s = free.root("S", &relation::distance_squared(a, &b))?;
    let n = free.root("N", &relation::distance_squared(&b, d))?;
    let around = free.angle("place on the circle")?.cis();
    let on_circle = Point::<K>::i().scaled(&linkage.o_a) + around.scaled(&linkage.crank);
    let mut bindings = Bindings::new(free.precision());
    for (u, v, point) in [
        ("U", "V", &on_circle),
        ("UP_1", "VP_1", a),
        ("UP_2", "VP_2", &b),
    ] {
        bindings.bind(u, free.among_all(point.re().clone()));
        bindings.bind(v, free.among_all(point.im().clone()));
    }
    let opening = (d - a) * (&b - a).conj();
    bindings.bind("epsilon", Angle::of_known_length(opening, &m * &s));
    for (name, value) in [("k", k), ("n", sense), ("M", m), ("S", s), ("N", n)] {
        bindings.bind(name, value);
    }
    linkage.bind(&mut bindings);
    Ok(bindings)
}

fn build_fixed_link<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let linkage = linkage(free)?;
    let fixed_link = o_b::<K>() - Point::<K>::i().scaled(&linkage.o_a);
    let length = relation::distance(&Number::zero(), &fixed_link);
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("V_2", o_b::<K>().im().clone());
    bindings.bind("theta", Angle::of_known_length(fixed_link, length.clone()));
    bindings.bind("Q", length);
    linkage.bind(&mut bindings);
    Ok(bindings)
}
