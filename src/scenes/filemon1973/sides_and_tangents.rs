//! Appendix, (3) to (6): the tangents from O₁ and the lengths of the sides.

use super::quadrilateral::{Sums, centerpoint_curve};
use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::tangents::Pencil;
use crate::plane::{Point, relation};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1973/sides-and-tangents",
    "Figure 7 with the sides r and R, the abscissas of O12 and O14 and the angle phi free; c and h are \
     distances. A line eta = p zeta through O1 meets the centerpoint curve in two more points, and \
     these coincide for four values of p; the equation for them reads the same backwards and is one \
     of order two for f = p + 1/p.",
    build,
    [
        "phi": "angle from the zeta-axis to the eta-axis",
        "r": "length of the side O12 O23",
        "h": "length of the side O23 O34",
        "R": "length of the side O14 O34",
        "c": "length of the side O12 O14",
        "zeta_0": "abscissa of O12 on the zeta-axis",
        "eta_0": "abscissa of O14 on the eta-axis",
        "f_1": "the greater sum of the slopes p and 1/p of two tangents from O1",
        "f_2": "the smaller sum of the slopes p and 1/p of two tangents from O1",
        "D": "discriminant of the equation for f, its leading coefficient being R^2 r^2",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let phi = free.angle("phi")?;
    let (zeta_0, eta_0) = (free.number("zeta_0")?, free.number("eta_0")?);
    let (r, long) = (free.length("r")?, free.length("R")?);
    let eta_axis = phi.cis();
    let poles: [Point<K>; 4] = [
        zeta_0.clone().into(),
        (&zeta_0 + &r).into(),
        eta_axis.scaled(&(&eta_0 + &long)),
        eta_axis.scaled(&eta_0),
    ];
    let c = free.root("c", &relation::distance_squared(&poles[0], &poles[3]))?;
    let h = free.root("h", &relation::distance_squared(&poles[1], &poles[2]))?;
    let curve = centerpoint_curve(&poles)?;
    let pencil = Pencil::new(&curve, &Number::zero(), [Number::one(), eta_axis]);
    let Sums { f: [f_1, f_2] } = Sums::of(&pencil, &(4 * &c * &h / (&r * &long)))?;
    let leading = (&r * &long).square();
    let d = (leading * (&f_1 - &f_2)).square();
    let mut bindings = Bindings::new(free.precision());
    for (name, value) in [
        ("r", r),
        ("h", h),
        ("R", long),
        ("c", c),
        ("zeta_0", zeta_0),
        ("eta_0", eta_0),
        ("f_1", f_1),
        ("f_2", f_2),
        ("D", d),
    ] {
        bindings.bind(name, value);
    }
    bindings.bind("phi", phi);
    Ok(bindings)
}
