//! Linkages of which nothing is left but a joint.

use super::joint::cross;
use super::{Joint, Passage};
use crate::number::{Real, Truth};

/// What makes a linkage no mechanism of four links.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Degenerate {
    /// A₀ = B₀: the coupler only turns about it.
    SameCenter,
    /// A = B: nothing can move but the body about this point.
    SameCirclepoint,
    /// A link has no length: its circlepoint stays in its center.
    LinkOfNoLength,
    /// Two slides in one direction, or two parallel lines of the coupler in turning blocks.
    Parallel,
}

impl<K: Real> Passage<K> {
    /// All that is degenerate; `None` where it cannot be told.
    pub fn degenerate(&self) -> Option<Vec<Degenerate>> {
        let [p, q] = &self.pivots;
        let [a, b] = self.joints.first()?;
        let mut list = Vec::new();
        let mut add = |found: Truth, what| match found {
            Truth::Yes if !list.contains(&what) => {
                list.push(what);
                Some(())
            }
            Truth::Unknown => None,
            _ => Some(()),
        };
        add(coincide(p, q), of_kind(p, Degenerate::SameCenter))?;
        add(coincide(a, b), of_kind(a, Degenerate::SameCirclepoint))?;
        add(coincide(p, a), Degenerate::LinkOfNoLength)?;
        add(coincide(q, b), Degenerate::LinkOfNoLength)?;
        Some(list)
    }
}

fn of_kind<K>(joint: &Joint<K>, finite: Degenerate) -> Degenerate {
    match joint {
        Joint::At(_) => finite,
        Joint::Towards(_) => Degenerate::Parallel,
    }
}

/// Whether two joints are in one point, perhaps at infinity.
fn coincide<K: Real>(x: &Joint<K>, y: &Joint<K>) -> Truth {
    match (x, y) {
        (Joint::At(x), Joint::At(y)) => (x - y).is_zero(),
        (Joint::Towards(x), Joint::Towards(y)) => cross(x, y).is_zero(),
        _ => Truth::No,
    }
}
