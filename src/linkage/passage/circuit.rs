//! Circuits and branches: what is reached without being taken apart, and what without a dead centre.

use std::cmp::Ordering;

use super::driven::Driven;
use super::driver::{Driver, Motion};
use super::joint::cross;
use super::{Drive, Joint, Passage};
use crate::number::Real;

impl<K: Real> Passage<K> {
    /// For each position whether it is reached from the first one without the linkage being taken
    /// apart. `None` where it cannot be told.
    ///
    /// A driving link that is barred from no gate never comes to a dead centre: a circuit for each
    /// side of AB₀ on which B is. One that is barred from both moves on one side of them: a circuit
    /// for each side. All else is one circuit; the two of a change point meet there.
    pub fn circuit(&self) -> Option<Vec<bool>> {
        use Ordering::{Equal, Greater, Less};
        let driver = Driver::of(self, Drive::First)?;
        let whole = || Some(vec![true; self.joints.len()]);
        let (two_assemblies, two_sides) = match &driver.motion {
            Motion::Turn(turn) => match driver.rooms(turn) {
                [Some(Greater), Some(Greater)] => (true, false),
                [Some(Less), Some(Less)] => (false, true),
                [Some(_), Some(_)] => (false, false),
                _ => return None,
            },
            Motion::Slide(slide) => match (&driver.driven, driver.room_beside(slide)?) {
                (Driven::Slide { .. }, _) => (self.slides_are_parallel()?, false),
                (_, Less) => (false, true),
                // Beyond a turning block nothing holds the slider.
                (Driven::Block { .. }, Greater) => (true, false),
                (_, Greater | Equal) => (false, false),
            },
        };
        match (two_assemblies, two_sides) {
            (true, _) => with_the_first(&all(driver.assembly())?),
            (_, true) => with_the_first(&all(driver.sides())?),
            _ => whole(),
        }
    }

    /// For each position whether the drive reaches it from the first one without passing a dead
    /// centre, where coupler and driven link are on one line. `None` where it cannot be told.
    pub fn branch(&self, drive: Drive) -> Option<Vec<bool>> {
        let driver = Driver::of(self, drive)?;
        let here = with_the_first(&all(driver.assembly())?)?;
        let sides = all(driver.sides()).as_deref().and_then(with_the_first);
        let on_one_side = sides
            .as_ref()
            .is_some_and(|sides| sides.iter().all(|side| *side));
        if on_one_side || driver.passes_a_gate()? {
            return Some(here);
        }
        let both = here.iter().zip(sides?).map(|(here, side)| *here && side);
        Some(both.collect())
    }

    fn slides_are_parallel(&self) -> Option<bool> {
        match &self.pivots {
            [Joint::Towards(p), Joint::Towards(q)] => Some(cross(p, q).sign()?.is_eq()),
            _ => Some(false),
        }
    }
}

impl<K: Real> Driver<K> {
    /// Whether the driving link comes from one side of its gates to the other.
    fn passes_a_gate(&self) -> Option<bool> {
        match &self.motion {
            Motion::Turn(turn) => match self.rooms(turn) {
                [Some(Ordering::Greater), _] | [_, Some(Ordering::Greater)] => Some(true),
                [Some(_), Some(_)] => Some(false),
                _ => None,
            },
            Motion::Slide(slide) => Some(self.room_beside(slide)?.is_gt()),
        }
    }
}

fn all(signs: Vec<Option<Ordering>>) -> Option<Vec<Ordering>> {
    signs.into_iter().collect()
}

/// Which positions have the sign of the first; one of zero, a dead centre itself, belongs to both.
fn with_the_first(signs: &[Ordering]) -> Option<Vec<bool>> {
    let decided = signs.iter().find(|sign| sign.is_ne());
    let same = signs
        .iter()
        .map(|sign| sign.is_eq() || Some(sign) == decided);
    Some(same.collect())
}
