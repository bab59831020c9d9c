//! The four-bar of a pole quadrilateral, each position of which gives a circlepoint and its center.
//!
//! The pole quadrilateral O_1j O_jk O_kl O_1l and the mirror pole quadrilateral O_1j O¹_jk O¹_kl
//! O_1l have equal sides: they are two positions of one four-bar on the frame O_1j O_1l. It is
//! moved to any third position. The pole of its coupler is, for the displacement from the first of
//! the two, a center M, and for that from the second the circlepoint K of this center: at O_1j and
//! O_1l the midnormals of both, which go to M and K, differ by −φ_1j/2 and −φ_1l/2.

use super::pole_system::OfPairs;
use crate::linkage::four_bar::third_corners;
use crate::number::{Kind, Real, array};
use crate::plane::displacement::Displacement;
use crate::plane::projective::ProjectivePoint;
use crate::plane::{Point, line, relation};

/// The moving joints: the end of the crank at O_1j, then that of the crank at O_1l.
pub type Joints<K> = [Point<K>; 2];

/// A four-bar in two positions, that of the poles and that of the mirror poles.
#[derive(Clone, Debug)]
pub struct PoleFourBar<K> {
    /// O_1j and O_1l.
    pub frame: [Point<K>; 2],
    /// O_jk and O_kl.
    pub poles: Joints<K>,
    /// O¹_jk and O¹_kl.
    pub mirror_poles: Joints<K>,
}

/// A circlepoint, by its place in position 1, and the center of its circle. One of them may be at
/// infinity: the circle is then a line.
#[derive(Clone, Debug)]
pub struct Pair<K> {
    /// K.
    pub circlepoint: ProjectivePoint<K>,
    /// M.
    pub center: ProjectivePoint<K>,
}

impl<K: Kind> PoleFourBar<K> {
    /// The four-bar of the positions 1, j, k, l in this order.
    pub fn of(poles: &OfPairs<K>, mirror_poles: &OfPairs<K>, [j, k, l]: [usize; 3]) -> Self {
        let joints = |of: &OfPairs<K>| [of.of(j, k).clone(), of.of(k, l).clone()];
        PoleFourBar {
            frame: [poles.of(1, j).clone(), poles.of(1, l).clone()],
            poles: joints(poles),
            mirror_poles: joints(mirror_poles),
        }
    }

    /// The pair that another position of the four-bar gives.
    pub fn pair(&self, moved: &Joints<K>) -> Pair<K> {
        Pair {
            circlepoint: pole_of_coupler(&self.mirror_poles, moved),
            center: pole_of_coupler(&self.poles, moved),
        }
    }

    /// The direction of the real asymptote of the centerpoint curve: O_1j O_jk O_kl completed to a
    /// parallelogram, its fourth corner seen from O_1l. Zero for a parallelogram.
    pub fn center_asymptote(&self) -> Point<K> {
        self.asymptote(&self.poles)
    }

    /// The direction of the real asymptote of the circlepoint curve, from the mirror poles.
    pub fn circlepoint_asymptote(&self) -> Point<K> {
        self.asymptote(&self.mirror_poles)
    }

    fn asymptote(&self, [b, c]: &Joints<K>) -> Point<K> {
        let [a, d] = &self.frame;
        a + c - b - d
    }

    /// The joints in the position that gives the center at infinity: the midnormals of both joints
    /// are parallel to the asymptote.
    pub fn moved_for_infinite_center(&self) -> Joints<K> {
        self.mirrored(&self.poles, &self.center_asymptote())
    }

    /// The joints in the position that gives the circlepoint at infinity.
    pub fn moved_for_infinite_circlepoint(&self) -> Joints<K> {
        self.mirrored(&self.mirror_poles, &self.circlepoint_asymptote())
    }

    fn mirrored(&self, joints: &Joints<K>, direction: &Point<K>) -> Joints<K> {
        array::pairs(joints, &self.frame)
            .map(|(joint, pivot)| line::mirror(joint, pivot, &(pivot + direction)))
    }
}

impl<K: Real> PoleFourBar<K> {
    /// The joints for a place l of the second one on its circle about O_1l: with the first to the
    /// left and to the right of the line from O_1j to l. `None` where the first cannot be reached,
    /// or where that cannot be told or held.
    pub fn with_second_joint_at(&self, l: &Point<K>) -> Option<[Joints<K>; 2]> {
        let [b, c] = &self.poles;
        let crank = relation::distance_squared(&self.frame[0], b);
        let coupler = relation::distance_squared(b, c);
        let corners = third_corners(&self.frame[0], l, &crank, &coupler)?;
        Some(corners.map(|first| [first, l.clone()]))
    }
}

/// Where the midnormals of both joints meet. It is at infinity where the coupler is only shifted,
/// and is a joint that stays where it is; not determined for equal positions.
fn pole_of_coupler<K: Kind>(from: &Joints<K>, to: &Joints<K>) -> ProjectivePoint<K> {
    Displacement::identity().projective_pole(&Displacement::carrying(from, to))
}
