//! Section 4: the angles of the focal mechanism.

use crate::formula::Bindings;
use crate::linkage::focal_mechanism::{self, Joints};
use crate::number::{Number, Real, Truth};
use crate::plane::{Angle, Point, line, quadrilateral};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/figure-2",
    "A focal mechanism by its joints: M, P, F, Q and A are free but for a turn of the whole, N lies where \
     the angles MPF and FQN add to pi and where the length PA demands it, B where the arm NB ends, S and T where the distances from F \
     are kept. Positive lengths, as in the figure. Angles turn counterclockwise in the order of \
     their letters.",
    build,
    [
        "M": "fixed pivot of the arm MA",
        "A": "joint of MA and AB",
        "B": "joint of AB and NB",
        "N": "fixed pivot of the arm NB",
        "P": "joint on MA",
        "Q": "joint on NB",
        "S": "joint on MN",
        "T": "joint on AB",
        "F": "the fourfold joint",
        "X": "where the lines MA and NB meet",
        "Y": "where the lines MN and AB meet",
        "omega": "angle MPF",
        "alpha": "angle PAF",
        "beta": "angle FBQ",
        "chi": "angle AFM",
    ]
);

pub const ANY_SHAPE: Scene = scene!(
    "wunderlich1968/figure-2-of-any-shape",
    "A focal mechanism by its joints as in figure-2, but with bars that may also be laid off \
     backwards: the quadrilateral MABN is convex, concave or crossed, and F inside or outside.",
    build_any_shape,
    not symbolic: "the winding number of a polygon about a point",
    [
        "M": "fixed pivot of the arm MA",
        "A": "joint of MA and AB",
        "B": "joint of AB and NB",
        "N": "fixed pivot of the arm NB",
        "F": "the fourfold joint",
        "W": "how often the polygon MABN goes round F, 0 for a point outside",
        "rho": "the ratio MS : SN, directed",
        "convex": "1 for a convex quadrilateral MABN, else 0",
    ]
);

/// PA is given, positive beyond P; the bar MP lies along the x-axis.
fn free_joints<K: Real>(free: &mut dyn Free<K>, beyond: &Number<K>) -> Result<Joints<K>, Unbuilt> {
    let bar = free.length("MP")?;
    let mut point = |name: &str| -> Result<Point<K>, Unbuilt> {
        Ok(Number::complex(
            free.number(&format!("x of {name}"))?,
            free.number(&format!("y of {name}"))?,
        ))
    };
    let f = point("F")?;
    let (p, q) = (&f + point("FP")?, &f + point("FQ")?);
    let m = &p - Point::from(bar.clone());
    // p q/n lies beyond P, and n = ν m p q.
    let nu = (bar * beyond).inverse();
    Ok(focal_mechanism::joints(&m, &p, &f, &q, &nu))
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let beyond = free.length("PA")?;
    let Joints {
        corners: [m, a, b, n],
        p,
        q,
        f,
        s,
        t,
        ..
    } = free_joints(free, &beyond)?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("omega", Angle::at_vertex(&m, &p, &f));
    bindings.bind("alpha", Angle::at_vertex(&p, &a, &f));
    bindings.bind("beta", Angle::at_vertex(&f, &b, &q));
    bindings.bind("chi", Angle::at_vertex(&a, &f, &m));
    bindings.bind("X", line::meet(&m, &a, &n, &b));
    bindings.bind("Y", line::meet(&m, &n, &a, &b));
    let joints = [
        ("M", m),
        ("A", a),
        ("B", b),
        ("N", n),
        ("P", p),
        ("Q", q),
        ("F", f),
        ("S", s),
        ("T", t),
    ];
    for (name, joint) in joints {
        bindings.bind(name, joint);
    }
    Ok(bindings)
}

fn build_any_shape<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let beyond = free.number("PA")?;
    let Joints {
        corners, f, rho, ..
    } = free_joints(free, &beyond)?;
    let winding = quadrilateral::winding_number(&corners, &f)
        .ok_or_else(|| Unbuilt::NotReal("F lies on a side".to_owned()))?;
    let convex = match quadrilateral::is_convex(&corners) {
        Truth::Yes => 1,
        Truth::No => 0,
        Truth::Unknown => {
            return Err(Unbuilt::NotHeld(
                "the shape of the quadrilateral".to_owned(),
            ));
        }
    };
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("W", Number::<K>::from(winding));
    bindings.bind("convex", Number::<K>::from(convex));
    bindings.bind("rho", rho);
    bindings.bind("F", f);
    for (name, corner) in ["M", "A", "B", "N"].into_iter().zip(corners) {
        bindings.bind(name, corner);
    }
    Ok(bindings)
}
