//! The pole quadrilateral with U = Z and the double point of its centerpoint curve.

use super::quadrilateral::{Directions, Equal, PoleQuadrilateral};
use crate::formula::{Bindings, Value};
use crate::number::{Number, Real};
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const ADJACENT: Scene = scene!(
    "filemon1973/node-of-case-A",
    "Figure 7 with the directions of all four sides free and lengths such that h + r = c + R. The double \
     point is found from the equation of order four for the lines through O1 that touch the \
     centerpoint curve elsewhere: two of its roots are equal.",
    build_adjacent,
    [
        "O_1": "Q_13, where the lines O12 O23 and O14 O34 meet",
        "O_23": "pole of the positions 2 and 3",
        "O_34": "pole of the positions 3 and 4",
        "M_1": "midpoint of O12 O34",
        "M_2": "midpoint of O14 O23",
        "H": "double point of the centerpoint curve",
        "zeta_0": "abscissa of O12 on the zeta-axis, negative beyond O1",
        "eta_0": "abscissa of O14 on the eta-axis, negative beyond O1",
        "r": "length of the side O12 O23",
        "h": "length of the side O23 O34",
        "R": "length of the side O14 O34",
        "c": "length of the side O12 O14",
        "phi": "angle from the zeta-axis to the eta-axis",
        "f_1": "the greater sum of the slopes p and 1/p of two tangents from O1",
        "f_2": "the smaller sum of the slopes p and 1/p of two tangents from O1",
        "p": "slope of the line O1 H",
    ]
);

pub const OPPOSITE: Scene = scene!(
    "filemon1973/node-of-case-B",
    "Figure 7 as in node-of-case-A, but with c + h = r + R.",
    build_opposite,
    [
        "O_1": "Q_13, where the lines O12 O23 and O14 O34 meet",
        "O_23": "pole of the positions 2 and 3",
        "O_34": "pole of the positions 3 and 4",
        "M_1": "midpoint of O12 O34",
        "M_2": "midpoint of O14 O23",
        "H": "double point of the centerpoint curve",
        "zeta_0": "abscissa of O12 on the zeta-axis, negative beyond O1",
        "eta_0": "abscissa of O14 on the eta-axis, negative beyond O1",
        "r": "length of the side O12 O23",
        "h": "length of the side O23 O34",
        "R": "length of the side O14 O34",
        "c": "length of the side O12 O14",
        "phi": "angle from the zeta-axis to the eta-axis",
        "f_1": "the greater sum of the slopes p and 1/p of two tangents from O1",
        "f_2": "the smaller sum of the slopes p and 1/p of two tangents from O1",
        "p": "slope of the line O1 H",
    ]
);

pub const BISECTORS: Scene = scene!(
    "filemon1973/bisectors",
    "The quadrilaterals of node-of-case-A and node-of-case-B with the same directions of their sides, and \
     both double points; O1 is in the origin and the zeta-axis on the x-axis.",
    build_both,
    [
        "phi": "angle from the zeta-axis to the eta-axis",
        "H_k": "double point where h + r = c + R, on the line f_k through O1",
        "H_b": "double point where c + h = r + R, on the line f_b through O1",
    ]
);

fn build_adjacent<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    build(Equal::Adjacent, free)
}

fn build_opposite<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    build(Equal::Opposite, free)
}

fn build_both<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let directions = Directions::free(free)?;
    let mut bindings = Bindings::new(free.precision());
    for (name, equal) in [("H_k", Equal::Adjacent), ("H_b", Equal::Opposite)] {
        let size = free.length(&format!("size for {name}"))?;
        let quadrilateral = PoleQuadrilateral::with_node(directions.clone(), equal, &size)?;
        bindings.bind(name, double_point(&quadrilateral, &quadrilateral.curve()?)?);
    }
    bindings.bind("phi", directions.phi);
    Ok(bindings)
}

/// From the lines through O₁ that touch the curve elsewhere.
fn double_point<K: Real>(
    quadrilateral: &PoleQuadrilateral<K>,
    curve: &Cubic<K>,
) -> Result<Point<K>, Unbuilt> {
    let node = quadrilateral
        .pencil_of_o1(curve)
        .double_point()
        .ok_or_else(|| Unbuilt::NotHeld("the double point".to_owned()))?;
    Unbuilt::unless_true::<K>(
        curve.at(&node).is_zero() & curve.gradient(&node).is_zero(),
        "H is no double point",
    )?;
    Ok(node)
}

fn build<K: Real>(equal: Equal, free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let quadrilateral = PoleQuadrilateral::free_with_node(equal, free)?;
    let curve = quadrilateral.curve()?;
    let node = double_point(&quadrilateral, &curve)?;
    let [f_1, f_2] = quadrilateral.sums_of_o1(&curve)?.f;
    let [o12, o23, o34, o14] = quadrilateral.poles();
    let PoleQuadrilateral {
        directions,
        r,
        h,
        long,
        c,
        zeta_0,
        eta_0,
    } = quadrilateral;
    let axis = directions.phi.cis();
    let slope = node.im() / (node.re() * axis.im() - node.im() * axis.re());
    let mut bindings = Bindings::new(free.precision());
    let middle = |a, b| (a + b) / 2;
    for (name, point) in [
        ("M_1", middle(&o12, &o34)),
        ("M_2", middle(&o14, &o23)),
        ("O_1", Number::zero()),
        ("O_23", o23),
        ("O_34", o34),
        ("H", node),
    ] {
        bindings.bind(name, Value::Point(point));
    }
    for (name, value) in [
        ("r", r),
        ("h", h),
        ("R", long),
        ("c", c),
        ("zeta_0", zeta_0),
        ("eta_0", eta_0),
        ("f_1", f_1),
        ("f_2", f_2),
        ("p", slope),
    ] {
        bindings.bind(name, value);
    }
    bindings.bind("phi", directions.phi);
    Ok(bindings)
}
