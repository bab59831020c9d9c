//! The pole quadrilateral of any shape and order of sides, and the tangents from O₁ and O₂.

use super::count::{bind_number, counted};
use super::quadrilateral::PoleQuadrilateral;
use super::side_order::Sides;
use crate::formula::Bindings;
use crate::number::Real;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1973/any-shape",
    "Figure 7 with the directions of all four sides free, and with the lengths r and R free or such that \
     U = Z; the closure gives c and h. The quadrilateral is convex, concave or crossed. The tangents are \
     counted by the real roots of the equation of order four for the lines through a point of the \
     centerpoint curve; what is neither a real tangent nor a line through a double point is an imaginary \
     one.",
    build,
    not symbolic: "numbers of real tangents",
    [
        "r": "length of the side O12 O23",
        "h": "length of the side O23 O34",
        "R": "length of the side O14 O34",
        "c": "length of the side O12 O14",
        "U": "sum of the shortest and the longest side",
        "Z": "sum of the other two sides",
        "f_1": "the greater sum of the slopes p and 1/p of two tangents from O1",
        "f_2": "the smaller sum of the slopes p and 1/p of two tangents from O1",
        "f_1'": "f_1 for the tangents from O2",
        "f_2'": "f_2 for the tangents from O2",
        "N_1": "number of real tangents from O1 to other points of the curve, of four",
        "N_2": "number of real tangents from O2",
        "nodes": "number of double points of the curve, each of which takes the place of two tangents",
        "class": "class of the curve: tangents from O1 to other points and twice that in O1",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let quadrilateral = PoleQuadrilateral::of_any_kind(free)?;
    let curve = quadrilateral.curve()?;
    let Sides { u, z, .. } = Sides::of(&quadrilateral)?;
    let [f_1, f_2] = quadrilateral.sums_of_o1(&curve)?.f;
    let [f_1_of_o2, f_2_of_o2] = quadrilateral.sums_of_o2(&curve)?.f;
    let from_o1 = counted(&quadrilateral.pencil_of_o1(&curve))?;
    let from_o2 = counted(&quadrilateral.pencil_of_o2(&curve))?;
    let mut bindings = Bindings::new(free.precision());
    for (name, count) in [
        ("N_1", from_o1.real),
        ("N_2", from_o2.real),
        ("nodes", from_o1.double),
        ("class", from_o1.real + from_o1.imaginary + 2),
    ] {
        bind_number(&mut bindings, name, count);
    }
    let PoleQuadrilateral { r, h, long, c, .. } = quadrilateral;
    for (name, value) in [
        ("r", r),
        ("h", h),
        ("R", long),
        ("c", c),
        ("U", u),
        ("Z", z),
        ("f_1", f_1),
        ("f_2", f_2),
        ("f_1'", f_1_of_o2),
        ("f_2'", f_2_of_o2),
    ] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}
