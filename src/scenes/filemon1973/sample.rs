//! Random exact pole quadrilaterals of every shape and order of sides.

use super::quadrilateral::PoleQuadrilateral;
use crate::number::{Exact, Truth};
use crate::plane::quadrilateral::is_convex;
use crate::plane::{Point, relation};
use crate::scenes::Unbuilt;
use crate::scenes::free::Random;

/// More are not drawn.
const MOST_SEEDS: u64 = 1 << 16;

/// One after another, half of them with U = Z.
pub fn quadrilaterals() -> impl Iterator<Item = Result<PoleQuadrilateral<Exact>, Unbuilt>> {
    (0..MOST_SEEDS).filter_map(|seed| {
        match PoleQuadrilateral::of_any_kind(&mut Random::new(seed)) {
            Err(Unbuilt::NotReal(_)) => None,
            outcome => Some(outcome),
        }
    })
}

/// Shape of a quadrilateral.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shape {
    Convex,
    Concave,
    Crossed,
}

/// By the turns at the vertices: all to one side, three of them, or two.
pub fn shape(vertices: &[Point<Exact>; 4]) -> Shape {
    let left = (0..4).filter(|i| {
        let [a, b, c] = [0, 1, 2].map(|j| &vertices[(i + j) % 4]);
        relation::twice_area(a, b, c).is_positive() == Truth::Yes
    });
    match (is_convex(vertices), left.count()) {
        (Truth::Yes, _) => Shape::Convex,
        (_, 2) => Shape::Crossed,
        _ => Shape::Concave,
    }
}
