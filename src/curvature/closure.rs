//! The motion of a linkage from its closure.
//!
//! Two joints keep one quantity each. The motion has three coordinates: the angle φ by which the
//! moving plane turns, and the place x + iy of its origin. One of them drives; the two others follow
//! as series in it, coefficient by coefficient, from linear equations that are the same for each.

use super::contact::Guide;
use super::motion::{Motion, path, turn};
use crate::number::{Kind, Number};
use crate::plane::displacement::Displacement;

/// The coordinates in the order in which they are tried as the driver.
const ANGLE: usize = 0;

/// The motion that keeps to two guides, to terms in tⁿ. The angle drives where it can; then t is the
/// angle. Else the linkage starts with a translation, and x or y drives. `None` where no coordinate
/// is known to drive: in a change point, and where the guides are one and the same.
#[expect(
    clippy::indexing_slicing,
    reason = "there are three coordinates, and terms up to the order"
)]
pub fn motion<K: Kind>(guides: &[Guide<K>; 2], order: usize) -> Option<Motion<K>> {
    let [g, h] = guides.each_ref().map(Guide::gradient);
    let minor = |i: usize, j: usize| &g[i] * &h[j] - &g[j] * &h[i];
    let followers = [(ANGLE, (1, 2)), (1, (ANGLE, 2)), (2, (ANGLE, 1))];
    let (driver, (i, j)) = followers
        .into_iter()
        .find(|(_, (i, j))| minor(*i, *j).is_zero().is_no())?;
    let determinant = minor(i, j);
    let mut coordinates: [Vec<Number<K>>; 3] =
        std::array::from_fn(|_| vec![Number::zero(); order + 1]);
    if order > 0 {
        coordinates[driver][1] = Number::one();
    }
    for n in 1..=order {
        let motion = of_coordinates(&coordinates, n);
        let [u, v] = guides
            .each_ref()
            .map(|guide| guide.along(&motion).coefficient(n));
        coordinates[i][n] = (&g[j] * &v - &h[j] * &u) / &determinant;
        coordinates[j][n] = (&h[i] * &u - &g[i] * &v) / &determinant;
    }
    Some(of_coordinates(&coordinates, order))
}

fn of_coordinates<K: Kind>([angle, x, y]: &[Vec<Number<K>>; 3], order: usize) -> Motion<K> {
    let place = x.iter().zip(y);
    let place: Vec<_> = place
        .map(|(x, y)| Number::complex(x.clone(), y.clone()))
        .collect();
    Displacement {
        rotation: turn(&Number::from_coefficients(angle.iter().cloned(), order)),
        translation: path(&place, order),
    }
}

impl<K: Kind> Guide<K> {
    /// How the kept quantity changes with φ, x and y at the start.
    fn gradient(&self) -> [Number<K>; 3] {
        let (place, across) = match self {
            Guide::Circle { point, center } => (point, 2 * (point - center)),
            Guide::Line { point, normal } => (point, normal.clone()),
            Guide::MovingLine { center, normal } => (center, -normal),
        };
        let by_turn = (across.conj() * Number::i() * place).re().clone();
        [by_turn, across.re().clone(), across.im().clone()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curvature::motion::coefficient;
    use crate::number::Exact;
    use crate::plane::Point;

    fn at(x: i64, y: i64) -> Point<Exact> {
        Number::complex(x.into(), y.into())
    }

    fn keeps_both(guides: &[Guide<Exact>; 2]) -> Motion<Exact> {
        let motion = motion(guides, 6).unwrap();
        for guide in guides {
            let contact = guide.contact(&motion);
            assert_eq!((contact.least, contact.most), (6, None), "{guide:?}");
        }
        motion
    }

    #[test]
    fn every_two_guides_are_kept() {
        let circle = Guide::Circle {
            point: at(3, 1),
            center: at(7, -2),
        };
        let guides = [
            Guide::Circle {
                point: at(-2, 5),
                center: at(1, 1),
            },
            Guide::Line {
                point: at(2, 2),
                normal: at(3, -1),
            },
            Guide::MovingLine {
                center: at(4, 4),
                normal: at(1, 5),
            },
        ];
        for guide in guides {
            let motion = keeps_both(&[circle.clone(), guide]);
            assert!(
                coefficient(&motion.rotation, 1)
                    .equals(&Number::i())
                    .is_yes()
            );
        }
    }

    #[test]
    fn parallel_cranks_start_with_a_translation() {
        let crank = |point: Point<Exact>, center| Guide::Circle { point, center };
        let unequal = [crank(at(0, 2), at(0, 0)), crank(at(5, 3), at(5, 0))];
        let motion = keeps_both(&unequal);
        assert!(coefficient(&motion.rotation, 1).is_zero().is_yes());
        assert!(coefficient(&motion.rotation, 2).is_zero().is_no());
        let parallelogram = [crank(at(0, 2), at(0, 0)), crank(at(5, 2), at(5, 0))];
        let motion = keeps_both(&parallelogram);
        assert!((motion.rotation - 1).is_zero().is_yes());
    }

    #[test]
    fn a_change_point_has_no_driver() {
        let crank = |x: i64, pivot: i64| Guide::Circle {
            point: at(x, 0),
            center: at(pivot, 0),
        };
        assert!(motion(&[crank(1, 0), crank(3, 5)], 4).is_none());
        assert!(motion(&[crank(1, 0), crank(1, 0)], 4).is_none());
    }
}
