//! The center that belongs to a circlepoint, and the circlepoint that belongs to a center, seen from
//! the poles.
//!
//! From the pole P₁ⱼ the circlepoint in position 1 and its center are seen under half of the turn φⱼ from
//! position 1 to j, modulo π: the center is on the perpendicular bisector of two places that are
//! seen under φⱼ.

use crate::number::{Kind, Number};
use crate::plane::Point;
use crate::plane::displacement::{Displacement, HalfTurn};
use crate::plane::projective::{Line, ProjectivePoint};

/// A pole of position 1 and another one, with half of the turn.
#[derive(Clone, Debug)]
pub struct Sight<K> {
    /// P₁ⱼ.
    pub pole: ProjectivePoint<K>,
    /// φⱼ/2.
    pub half_turn: HalfTurn<K>,
}

impl<K: Kind> Sight<K> {
    /// From the pole of two positions.
    pub fn of(first: &Displacement<K>, other: &Displacement<K>) -> Self {
        Sight {
            pole: first.projective_pole(other),
            half_turn: first.half_turn_to(other),
        }
    }

    /// The line through the pole that makes half of the turn with the line to a point; not determined
    /// where that point is the pole, and where the pole is at infinity.
    fn line(&self, point: &Point<K>, half_turn: Point<K>) -> Line<K> {
        let [x, y, w] = self.pole.coordinates();
        let ray = point.scaled(w) - Number::complex(x.clone(), y.clone());
        let direction = ProjectivePoint::from_direction(&(ray * half_turn));
        Line::through(&self.pole, &direction)
    }

    /// The line of the possible centers of a circlepoint in position 1.
    pub fn line_of_center(&self, circlepoint: &Point<K>) -> Line<K> {
        let HalfTurn { cos, sin } = &self.half_turn;
        self.line(circlepoint, Number::complex(cos.clone(), sin.clone()))
    }

    /// The line of the possible circlepoints, in position 1, of a center.
    pub fn line_of_circlepoint(&self, center: &Point<K>) -> Line<K> {
        let HalfTurn { cos, sin } = &self.half_turn;
        self.line(center, Number::complex(cos.clone(), -sin))
    }
}

/// The center of a circlepoint in position 1, from two poles. At infinity where the places of the
/// circlepoint are on a line; not determined where one of the lines is not, and where both are one.
pub fn center<K: Kind>(circlepoint: &Point<K>, sights: &[Sight<K>; 2]) -> ProjectivePoint<K> {
    let [first, second] = sights
        .each_ref()
        .map(|sight| sight.line_of_center(circlepoint));
    first.meet(&second)
}

/// The circlepoint of a center, in position 1, from two poles; at infinity or not determined as the
/// center is in [`center()`].
pub fn circlepoint<K: Kind>(center: &Point<K>, sights: &[Sight<K>; 2]) -> ProjectivePoint<K> {
    let [first, second] = sights
        .each_ref()
        .map(|sight| sight.line_of_circlepoint(center));
    first.meet(&second)
}
