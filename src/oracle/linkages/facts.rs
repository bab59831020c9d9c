//! What is known of a linkage, from exact numbers or from enclosures.

use super::super::numeral::{Numeral, Shown};
use crate::linkage::passage::{Degenerate, Drive, Passage, Type};

/// What is known of a linkage; `None` for what could not be told.
pub struct Facts {
    pub degenerate: Option<Vec<Degenerate>>,
    pub link_type: Option<Type>,
    /// For each position, whether it is on the circuit of the first.
    pub circuit: Option<Vec<bool>>,
    /// Driven at the first pair, and at the second.
    pub drives: [Driven; 2],
}

/// What is known of a linkage that one of its links drives.
pub struct Driven {
    pub crank: Option<bool>,
    /// For each position, whether it is reached from the first without a dead centre.
    pub branch: Option<Vec<bool>>,
    /// What has meaning only where all positions are reached.
    pub order: Option<Meaning<Vec<usize>>>,
    /// cos of the least and of the greatest transmission angle.
    pub transmission: Option<Meaning<[Numeral; 2]>>,
}

/// A value, if there is such a thing.
pub type Meaning<T> = Option<T>;

impl Facts {
    pub fn of<K: Shown>(passage: &Passage<K>) -> Self {
        let degenerate = passage.degenerate();
        if degenerate.as_deref().is_some_and(is_no_mechanism) {
            return Facts {
                degenerate,
                link_type: None,
                circuit: None,
                drives: Drive::ALL.map(|_| Driven::nothing()),
            };
        }
        Facts {
            degenerate,
            link_type: passage.link_type(),
            circuit: passage.circuit(),
            drives: Drive::ALL.map(|drive| Driven::of(passage, drive)),
        }
    }

    /// These facts, and those of another source where they are missing.
    pub fn or(self, other: impl FnOnce() -> Self) -> Self {
        if self.is_whole() {
            return self;
        }
        let other = other();
        let [first, second] = self.drives;
        let [other_first, other_second] = other.drives;
        Facts {
            degenerate: self.degenerate.or(other.degenerate),
            link_type: self.link_type.or(other.link_type),
            circuit: self.circuit.or(other.circuit),
            drives: [first.or(other_first), second.or(other_second)],
        }
    }

    fn is_whole(&self) -> bool {
        self.is_no_mechanism()
            || self.degenerate.is_some()
                && self.link_type.is_some()
                && self.circuit.is_some()
                && self.drives.iter().all(Driven::is_whole)
    }

    /// Whether the joints coincide so that nothing can be asked.
    pub fn is_no_mechanism(&self) -> bool {
        self.degenerate.as_deref().is_some_and(is_no_mechanism)
    }
}

fn is_no_mechanism(list: &[Degenerate]) -> bool {
    list.iter().any(|what| *what != Degenerate::SameCenter)
}

impl Driven {
    fn nothing() -> Self {
        Driven {
            crank: None,
            branch: None,
            order: None,
            transmission: None,
        }
    }

    fn of<K: Shown>(passage: &Passage<K>, drive: Drive) -> Self {
        let branch = passage.branch(drive);
        let reached = branch.as_deref().map(all);
        // Asked only where all positions are reached.
        let order = reached.and_then(|reached| match reached {
            true => passage.order(drive).map(Some),
            false => Some(None),
        });
        let transmission = reached.and_then(|reached| {
            if !reached || !passage.has_transmission_angle() {
                return Some(None);
            }
            let cosines = passage.transmission(drive)?;
            Some(Some(cosines.each_ref().map(K::numeral)))
        });
        Driven {
            crank: passage.is_crank(drive),
            branch,
            order,
            transmission,
        }
    }

    fn or(self, other: Self) -> Self {
        Driven {
            crank: self.crank.or(other.crank),
            branch: self.branch.or(other.branch),
            order: self.order.or(other.order),
            transmission: self.transmission.or(other.transmission),
        }
    }

    fn is_whole(&self) -> bool {
        self.crank.is_some()
            && self.branch.is_some()
            && self.order.is_some()
            && self.transmission.is_some()
    }

    /// Whether all positions are reached without a dead centre.
    pub fn reaches_all(&self) -> Option<bool> {
        self.branch.as_deref().map(all)
    }
}

/// Whether all positions are reached.
pub fn all(reached: &[bool]) -> bool {
    reached.iter().all(|one| *one)
}
