//! Displacements of the moving plane, and the points that they leave where they are.

use std::cmp::Ordering;

use super::Point;
use super::projective::ProjectivePoint;
use crate::number::{Exact, Kind, Number, Real};

/// X = rotation · x + translation, |rotation| = 1: where a point x of the moving plane is in the
/// fixed one.
#[derive(Clone, Debug)]
pub struct Displacement<K> {
    /// e^{iθ}
    pub rotation: Point<K>,
    /// Where the origin of the moving plane is.
    pub translation: Point<K>,
}

impl Displacement<Exact> {
    /// The same displacement in another kind that holds it exactly.
    pub fn in_kind<K: Kind>(&self) -> Displacement<K> {
        self.map(Number::<Exact>::in_kind)
    }
}

impl<K: Kind> Displacement<K> {
    /// The same displacement over another kind, each number converted.
    pub fn map<L: Kind>(&self, convert: impl Fn(&Number<K>) -> Number<L>) -> Displacement<L> {
        let point = |z: &Point<K>| Number::complex(convert(z.re()), convert(z.im()));
        Displacement {
            rotation: point(&self.rotation),
            translation: point(&self.translation),
        }
    }

    /// No displacement.
    pub fn identity() -> Self {
        Displacement {
            rotation: Number::one(),
            translation: Number::zero(),
        }
    }

    /// The turn e^{iδ} about a point.
    pub fn about(point: &Point<K>, turn: Point<K>) -> Self {
        Displacement {
            translation: point * (1 - &turn),
            rotation: turn,
        }
    }

    /// The displacement that carries a segment, by its ends, into one of the same length.
    pub fn carrying([a, b]: &[Point<K>; 2], [a1, b1]: &[Point<K>; 2]) -> Self {
        let rotation = (b1 - a1) / (b - a);
        Displacement {
            translation: a1 - &rotation * a,
            rotation,
        }
    }

    /// Where a point of the moving plane is.
    pub fn of(&self, point: &Point<K>) -> Point<K> {
        &self.rotation * point + &self.translation
    }

    /// The moving plane seen from the fixed one becomes the fixed one seen from the moving: which
    /// point of the moving plane is at a point of the fixed one.
    pub fn inverse(&self) -> Self {
        let back = self.rotation.conj();
        Displacement {
            translation: -(&back * &self.translation),
            rotation: back,
        }
    }

    /// This displacement after another one.
    pub fn after(&self, first: &Self) -> Self {
        Displacement {
            rotation: &self.rotation * &first.rotation,
            translation: self.of(&first.translation),
        }
    }

    /// The pole of two positions, the point of the fixed plane where the same point of the moving
    /// plane lies both times; no value where they differ by a translation only.
    pub fn pole(&self, other: &Self) -> Point<K> {
        let point = (&self.translation - &other.translation) / (&other.rotation - &self.rotation);
        self.of(&point)
    }

    /// Half of the turn δ that leads from this position to another.
    pub fn half_turn_to(&self, other: &Self) -> HalfTurn<K> {
        HalfTurn::of(&(&other.rotation * self.rotation.conj()))
    }

    /// The pole of two positions. It is at infinity, across the translation, where there is no turn;
    /// not determined for equal positions.
    pub fn projective_pole(&self, other: &Self) -> ProjectivePoint<K> {
        self.pole_by_half_turn(other, &self.half_turn_to(other))
    }

    /// The pole of two positions, half of the turn between them given, which may be better known
    /// than the displacements tell.
    pub fn pole_by_half_turn(&self, other: &Self, half_turn: &HalfTurn<K>) -> ProjectivePoint<K> {
        // On the perpendicular bisector of the two places T, T' of the origin, which are seen from
        // it under the angle δ: (T + T')/2 + i cot(δ/2) (T' − T)/2.
        let HalfTurn { cos, sin } = half_turn;
        let middle = (&self.translation + &other.translation).scaled(sin);
        let across = Number::i() * (&other.translation - &self.translation);
        let twice = middle + across.scaled(cos);
        ProjectivePoint::new(twice.re().clone(), twice.im().clone(), 2 * sin)
    }
}

/// Half of a turn, [cos δ/2 : sin δ/2] up to a common factor that is not zero: δ/2 is known modulo π,
/// which is all that a turn tells.
#[derive(Clone, Debug)]
pub struct HalfTurn<K> {
    /// cos δ/2; zero for half a revolution.
    pub cos: Number<K>,
    /// sin δ/2; zero where nothing turns.
    pub sin: Number<K>,
}

impl<K: Kind> HalfTurn<K> {
    /// Half of the turn e^{iδ}.
    pub fn of(turn: &Point<K>) -> Self {
        if (1 + turn.re()).is_zero().is_yes() {
            HalfTurn::of_turn_but_none(turn)
        } else {
            HalfTurn::of_turn_but_half(turn)
        }
    }

    /// [1 + cos δ : sin δ], which vanishes for δ = π.
    fn of_turn_but_half(turn: &Point<K>) -> Self {
        HalfTurn {
            cos: 1 + turn.re(),
            sin: turn.im().clone(),
        }
    }

    /// [sin δ : 1 − cos δ], which vanishes for δ = 0.
    fn of_turn_but_none(turn: &Point<K>) -> Self {
        HalfTurn {
            cos: turn.im().clone(),
            sin: 1 - turn.re(),
        }
    }
}

impl<K: Real> HalfTurn<K> {
    /// Half of the turn e^{iδ}, without the difference of two almost equal numbers, of which rounding
    /// would leave nothing.
    pub fn of_rounded(turn: &Point<K>) -> Self {
        match turn.re().sign() {
            Some(Ordering::Less) => HalfTurn::of_turn_but_none(turn),
            _ => HalfTurn::of_turn_but_half(turn),
        }
    }
}
