//! Order of contact of a path with a circle or a line.

use super::motion::{Motion, Path, fixed};
use crate::number::{Kind, Number, Series};
use crate::plane::Point;

/// A point of one plane and a curve of the other on which it stays, or to which it keeps close.
#[derive(Clone, Debug)]
pub enum Guide<K> {
    /// A point of the moving plane at a fixed distance from a point of the fixed one.
    Circle {
        /// Of the moving plane.
        point: Point<K>,
        /// Of the fixed plane.
        center: Point<K>,
    },
    /// A point of the moving plane on a line of the fixed one: the center is at infinity.
    Line {
        /// Of the moving plane.
        point: Point<K>,
        /// Across the line.
        normal: Point<K>,
    },
    /// A point of the fixed plane on a line of the moving one: the circlepoint is at infinity.
    MovingLine {
        /// Of the fixed plane.
        center: Point<K>,
        /// Across the line.
        normal: Point<K>,
    },
}

impl<K: Kind> Guide<K> {
    /// What stays constant as long as the point keeps to the curve: its squared distance from the
    /// center, or its place across the line.
    pub fn along(&self, motion: &Motion<K>) -> Number<Series<K>> {
        let across = |path: Path<K>, normal: &Point<K>| (path * fixed(normal).conj()).re().clone();
        match self {
            Guide::Circle { point, center } => (motion.path_of(point) - fixed(center)).norm(),
            Guide::Line { point, normal } => across(motion.path_of(point), normal),
            Guide::MovingLine { center, normal } => {
                across(motion.inverse().path_of(center), normal)
            }
        }
    }

    /// How far the motion keeps to the curve.
    pub fn contact(&self, motion: &Motion<K>) -> Contact {
        Contact::of(&self.along(motion))
    }
}

/// An order of contact n: n + 1 infinitesimally separated positions of the point lie on the curve. Of
/// a path with a cusp, which only the pole has, twice as many terms in t go into one in the length of
/// the path; n then counts the terms in t.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contact {
    /// The order is proven to be this at least.
    pub least: usize,
    /// And this at most; `None` where no term is proven not to vanish.
    pub most: Option<usize>,
}

impl Contact {
    /// By the terms of a series that would be constant on the curve.
    pub fn of<K: Kind>(kept: &Number<Series<K>>) -> Self {
        let zero = |j: usize| kept.coefficient(j).is_zero();
        let terms = 1..=kept.order().unwrap_or(0);
        Contact {
            least: terms.clone().take_while(|&j| zero(j).is_yes()).count(),
            most: terms.clone().find(|&j| zero(j).is_no()).map(|j| j - 1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curvature::motion::turning;
    use crate::number::{Ball, Exact};

    fn at<K: Kind>(x: i64, y: i64) -> Point<K> {
        Number::complex(x.into(), y.into())
    }

    #[test]
    fn a_point_of_a_rolling_circle() {
        // A wheel about i with the pole, where it touches the road, in the origin: i goes straight.
        let motion = turning(&[at::<Exact>(0, 0), at(0, 1), at(-1, 0), at(0, -1)], 4);
        let center = Guide::Line {
            point: at(0, 1),
            normal: at(0, 1),
        };
        assert_eq!(
            center.contact(&motion),
            Contact {
                least: 4,
                most: None
            }
        );
        let beside = Guide::Line {
            point: at(1, 1),
            normal: at(0, 1),
        };
        assert_eq!(
            beside.contact(&motion),
            Contact {
                least: 0,
                most: Some(0)
            }
        );
    }

    #[test]
    fn what_an_enclosure_leaves_open_is_left_open() {
        let near = Number(Ball::with_radius(
            &rug::Rational::new(),
            &rug::Rational::from((1, 1000)),
            64,
        ));
        let kept = Number::from_coefficients(
            [Number::one(), Number::zero(), near, Number::<Ball>::one()],
            3,
        );
        assert_eq!(
            Contact::of(&kept),
            Contact {
                least: 1,
                most: Some(2)
            }
        );
    }
}
