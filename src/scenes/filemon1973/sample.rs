//! Random exact pole quadrilaterals of every shape and order of sides.

use super::quadrilateral::PoleQuadrilateral;
use crate::number::Exact;
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
