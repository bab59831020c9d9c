//! Appendix, (1) and (2): a point of the centerpoint curve in the axes through O₁.

use super::quadrilateral::centerpoint_curve;
use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::{Point, line};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1973/oblique-axes",
    "Figure 7 with any point P of the centerpoint curve: P, the direction of the eta-axis, O12, O23 and \
     O14 are free, and O34 lies where P sees O14 O34 under the same angle (mod pi) as O12 O23. The \
     x-axis and the zeta-axis go from O1 in the direction from O12 to O23, the eta-axis in that \
     from O14 to O34. r and R are lengths, eta_0 and zeta_0 abscissas, negative where O1 lies \
     beyond O34 and O23.",
    build,
    [
        "O_1": "origin, where the lines O12 O23 and O14 O34 meet (Q_13)",
        "O_12": "pole of the positions 1 and 2",
        "O_14": "pole of the positions 1 and 4",
        "phi": "angle from the zeta-axis to the eta-axis",
        "r": "length of the side O12 O23",
        "R": "length of the side O14 O34",
        "zeta_0": "abscissa of O12 on the zeta-axis",
        "eta_0": "abscissa of O14 on the eta-axis",
        "x": "rectangular coordinate of P along the zeta-axis",
        "y": "rectangular coordinate of P across the zeta-axis",
        "zeta": "oblique coordinate of P along the zeta-axis",
        "eta": "oblique coordinate of P along the eta-axis",
        "G_1": "power of P for the circle over the diameter O14 O34",
        "g_1": "power of P for the circle over the diameter O12 O23",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let p = point(free, "P")?;
    let phi = free.angle("phi")?;
    let (zeta_0, eta_0) = (free.number("zeta_0")?, free.number("eta_0")?);
    let r = free.length("r")?;
    let (origin, x_axis, eta_axis): (Point<K>, Point<K>, _) =
        (Number::zero(), Number::one(), phi.cis());
    let along_eta = |q: &Point<K>| (q * eta_axis.conj()).re().clone();
    let (o12, o23): (Point<K>, Point<K>) = (zeta_0.clone().into(), (&zeta_0 + &r).into());
    let o14 = eta_axis.scaled(&eta_0);
    let sight = (&o14 - &p) * (&o23 - &p) / (&o12 - &p);
    let o34 = line::meet(&p, &(&p + sight), &origin, &eta_axis);
    let long = along_eta(&o34) - &eta_0;
    Unbuilt::unless_real(long.is_positive(), "R points backwards")?;
    let curve = centerpoint_curve(&[o12.clone(), o23.clone(), o34.clone(), o14.clone()])?;
    Unbuilt::unless_true::<K>(curve.at(&p).is_zero(), "P is not on the centerpoint curve")?;
    let power = |a: &Point<K>, b: &Point<K>| ((a - &p) * (b - &p).conj()).re().clone();
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("G_1", power(&o14, &o34));
    bindings.bind("g_1", power(&o12, &o23));
    let beside = line::meet(&p, &(&p + &eta_axis), &origin, &x_axis);
    let above = line::meet(&p, &(&p + &x_axis), &origin, &eta_axis);
    bindings.bind("zeta", beside.re().clone());
    bindings.bind("eta", along_eta(&above));
    bindings.bind("x", p.re().clone());
    bindings.bind("y", p.im().clone());
    for (name, value) in [("r", r), ("R", long), ("zeta_0", zeta_0), ("eta_0", eta_0)] {
        bindings.bind(name, value);
    }
    for (name, value) in [("O_1", origin), ("O_12", o12), ("O_14", o14)] {
        bindings.bind(name, value);
    }
    bindings.bind("phi", phi);
    Ok(bindings)
}
