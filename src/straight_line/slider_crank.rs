//! A slider-crank with its slider displaced.

use std::cmp::Ordering;

use super::no_design::NoDesign;
use crate::curvature::slider_crank::SliderCrank;
use crate::number::{Number, Real};
use crate::plane::displacement::Displacement;
use crate::plane::{Point, relation};

/// On which side of the line from the crank's pivot to the slider's pin the crank pin is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Assembly {
    /// Left, seen from the pivot.
    Left,
    /// Right.
    Right,
}

impl Assembly {
    /// Both.
    pub const ALL: [Assembly; 2] = [Assembly::Left, Assembly::Right];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Assembly::Left => "left",
            Assembly::Right => "right",
        }
    }
}

/// The joints in the design position. D slides across its ray.
#[derive(Clone, Debug)]
pub struct Joints<K> {
    /// The crank's pivot.
    pub o_a: Point<K>,
    /// The crank pin.
    pub a: Point<K>,
    /// The slider's pin.
    pub d: Point<K>,
    /// The direction in which D slides, of length 1.
    pub direction: Point<K>,
}

/// A position with the slider displaced.
#[derive(Clone, Debug)]
pub struct Displaced<K> {
    /// The displacement of the coupler.
    pub displacement: Displacement<K>,
    /// Where A and D go.
    pub a: Point<K>,
    /// Where D goes.
    pub d: Point<K>,
}

/// The joints, if the crank has a length and its pin is finite.
///
/// # Errors
/// k = −1, k = 0, α_a = 0.
pub fn guide<K: Real>(linkage: &SliderCrank<K>) -> Result<Joints<K>, NoDesign> {
    if (&linkage.k + 1).is_zero().is_yes() {
        return Err(NoDesign::PinAtInfinity("A"));
    }
    if linkage.k.is_zero().is_yes() || linkage.alpha_a.sin().is_zero().is_yes() {
        return Err(NoDesign::NoLength("A"));
    }
    Ok(joints(linkage))
}

/// The joints; no value where A is at infinity.
pub fn joints<K: Real>(linkage: &SliderCrank<K>) -> Joints<K> {
    let (a, d) = (linkage.alpha_a.cis(), linkage.alpha_d.cis());
    Joints {
        o_a: a.scaled(&linkage.po_a()),
        a: a.scaled(&linkage.pa().value()),
        direction: Number::i() * &d,
        d: d.scaled(&linkage.pd()),
    }
}

impl<K: Real> Joints<K> {
    /// The side of A in the design position; `None` where it cannot be told, or on the line itself.
    pub fn assembly(&self) -> Option<Assembly> {
        match relation::twice_area(&self.o_a, &self.d, &self.a).sign()? {
            Ordering::Greater => Some(Assembly::Left),
            Ordering::Less => Some(Assembly::Right),
            Ordering::Equal => None,
        }
    }

    /// The position with D displaced by s along its line, in one of the two assemblies: the triangle
    /// O_aAD keeps two sides and its third is known.
    pub fn displaced(&self, s: &Number<K>, assembly: Assembly) -> Result<Displaced<K>, NoDesign> {
        let d = &self.d + self.direction.scaled(s);
        let base = &d - &self.o_a;
        let square = base.norm();
        let (crank, rod) = ((&self.a - &self.o_a).norm(), (&self.a - &self.d).norm());
        let along = (&crank - rod + &square) / (2 * &square);
        let across = crank / square - along.square();
        if across.sign() == Some(Ordering::Less) {
            return Err(NoDesign::OutOfReach);
        }
        let across = match assembly {
            Assembly::Left => across.sqrt(),
            Assembly::Right => -across.sqrt(),
        };
        let a = &self.o_a + base * Number::complex(along, across);
        let rotation = (&a - &d) / (&self.a - &self.d);
        let displacement = Displacement {
            translation: &d - &rotation * &self.d,
            rotation,
        };
        Ok(Displaced { displacement, a, d })
    }

    /// The rates of a displaced position: of s, of the coupler's angle, in any unit of time; not both
    /// vanish. With A on its circle and D on its line the rod AD keeps its length.
    pub fn rates(&self, displaced: &Displaced<K>) -> (Number<K>, Number<K>) {
        let rod = &displaced.a - &displaced.d;
        let dot = |u: &Point<K>, v: &Point<K>| (u * v.conj()).re().clone();
        let around = Number::i() * (&displaced.a - &self.o_a);
        let (crank, slide) = (dot(&rod, &self.direction), dot(&rod, &around));
        let relative = around.scaled(&crank) - self.direction.scaled(&slide);
        let turn = (relative * rod.conj()).im() / rod.norm();
        (slide, turn)
    }
}
