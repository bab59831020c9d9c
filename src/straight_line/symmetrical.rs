//! Symmetrical coupler curves from a slider-crank whose slider is replaced by a crank.
//!
//! If R = M, O_aA = AD, any B on the circle about A through O_a and D makes the curve of D
//! symmetrical: O_a, B and D are on a circle about A, so that O_aD encloses half of the angle
//! ε = ∠BAD with O_aB, and the position with O_aB mirrored in the base has O_aD mirrored in the line
//! through O_a that makes ε/2 with the base. B gets as pivot its center of curvature, so that D keeps
//! its inflection.

use std::cmp::Ordering;

use super::design::Design;
use super::no_design::NoDesign;
use super::slider_crank::{Joints, joints};
use crate::curvature::slider_crank::SliderCrank;
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Number, Quadratic, QuadraticRoots, Real};
use crate::plane::displacement::Displacement;
use crate::plane::line::mirror;
use crate::plane::{Angle, Point};

/// The rays of D with R = M: the roots t = tan α_d of
/// (k²(1 − k)s² − 2ks² + k + 1) t² − 2ksc t + k²(1 − k)s² = 0 with c, s = cos α_a, sin α_a.
///
/// # Errors
/// No real root, or only the pole.
pub fn rays_of_d<K: Real>(k: &Number<K>, alpha_a: &Angle<K>) -> Result<Vec<Angle<K>>, NoDesign> {
    let (c, s) = (alpha_a.cos(), alpha_a.sin());
    let square = s.square();
    let last = k.square() * (1 - k) * &square;
    let first = &last - 2 * k * &square + k + 1;
    let middle = -2 * k * &s * &c;
    let tangents = match Quadratic::new(first.clone(), middle, last).roots() {
        QuadraticRoots::Undecided => return Err(NoDesign::Undecided),
        QuadraticRoots::Every | QuadraticRoots::None => Vec::new(),
        QuadraticRoots::Conjugate(_) => return Err(NoDesign::NotReal("R = M")),
        QuadraticRoots::Single(root) | QuadraticRoots::Double(root) => vec![root],
        QuadraticRoots::Real(roots) => roots.to_vec(),
    };
    let finite = tangents
        .into_iter()
        .filter(|tangent| !tangent.is_zero().is_yes())
        .map(|tangent| upwards(Number::one(), tangent));
    let infinite = first
        .is_zero()
        .is_yes()
        .then(|| upwards(Number::zero(), Number::one()));
    let rays: Vec<Angle<K>> = finite.chain(infinite).collect();
    if rays.is_empty() {
        return Err(NoDesign::OutputAtPole);
    }
    Ok(rays)
}

/// A ray in [0°, 180°).
fn upwards<K: Real>(c: Number<K>, s: Number<K>) -> Angle<K> {
    let length = (c.square() + s.square()).sqrt();
    let length = if s.sign() == Some(Ordering::Less) {
        -length
    } else {
        length
    };
    Angle::from_cos_sin(c / &length, s / length)
}

/// A linkage with a symmetrical curve, before it is known that B's pivot is finite.
#[derive(Clone, Debug)]
pub struct Symmetrical<K> {
    joints: Joints<K>,
    /// e^{iε/2}.
    half: Point<K>,
    b: Point<K>,
}

impl<K: Real> Symmetrical<K> {
    /// From a slider-crank with R = M and e^{iε/2}.
    pub fn new(linkage: &SliderCrank<K>, half: &Point<K>) -> Self {
        let joints = joints(linkage);
        let b = &joints.a + (&joints.d - &joints.a) * half.conj().square();
        Symmetrical {
            joints,
            half: half.clone(),
            b,
        }
    }

    /// By Euler and Savary in z = |B|e^{iβ}: the center is z · Im z/(Im z − |z|²).
    fn center(&self) -> (Point<K>, Number<K>) {
        let height = self.b.im();
        (self.b.scaled(height), height - self.b.norm())
    }

    /// The design.
    ///
    /// # Errors
    /// B on the inflection circle, or where D or O_a are.
    pub fn design(&self) -> Result<Design<K>, NoDesign> {
        let (numerator, denominator) = self.center();
        if denominator.is_zero().is_yes() {
            return Err(NoDesign::PivotAtInfinity("B"));
        }
        let Joints {
            o_a,
            a,
            d,
            direction,
        } = &self.joints;
        Design {
            linkage: CouplerPoint {
                pivots: [o_a.clone(), numerator.scaled(&denominator.inverse())],
                pins: [a.clone(), self.b.clone()],
                point: d.clone(),
            },
            direction: direction.clone(),
        }
        .checked()
    }

    /// What vanishes where the axis of symmetry is at right angles to D's line: then D mirrored in the
    /// axis has the same tangent. It vanishes also for ε = 0, where B falls on D.
    pub fn tangents_differ(&self) -> Number<K> {
        let (numerator, denominator) = self.center();
        let base = numerator - self.joints.o_a.scaled(&denominator);
        let axis = base * &self.half;
        (axis * self.joints.direction.conj()).re().clone()
    }
}

impl<K: Real> Design<K> {
    /// The direction of the axis of symmetry through O_a, where R = S = M.
    pub fn axis(&self, half: &Point<K>) -> Point<K> {
        let [o_a, o_b] = &self.linkage.pivots;
        (o_b - o_a) * half
    }

    /// The displacement to the position that is mirrored: B goes to its mirror image in the base, and
    /// the triangle O_aAB turns with it.
    pub fn to_mirrored(&self) -> Displacement<K> {
        let [o_a, o_b] = &self.linkage.pivots;
        let from = &self.linkage.pins[1] - o_a;
        let to = mirror(&self.linkage.pins[1], o_a, o_b) - o_a;
        Displacement::about(o_a, to / from)
    }
}
