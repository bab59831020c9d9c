//! Any four-bar, given by its lengths, in any position.

use std::cmp::Ordering;

use super::design::Design;
use super::no_design::NoDesign;
use crate::curvature::motion::coefficient;
use crate::linkage::cognates::CouplerPoint;
use crate::linkage::four_bar::third_corners;
use crate::number::{Number, Real};
use crate::plane::{Angle, Point};

/// The lengths and the design position (Tesar 1964, chapter VI).
#[derive(Clone, Debug)]
pub struct Lengths<K> {
    /// O_aO_b.
    pub q: Number<K>,
    /// O_aA.
    pub r: Number<K>,
    /// AB.
    pub s: Number<K>,
    /// O_bB.
    pub t: Number<K>,
    /// AD.
    pub m: Number<K>,
    /// From AB to AD.
    pub epsilon: Angle<K>,
    /// From O_aO_b to O_aA.
    pub phi0: Angle<K>,
}

impl<K: Real> Lengths<K> {
    /// The design in the assembly with B to the left or to the right of the line from A to O_b; if
    /// neither is asked for, in the one in which the path of D is less curved. The line is the tangent
    /// of D's path.
    ///
    /// # Errors
    /// The linkage does not close, or D stands still.
    pub fn design(&self, is_left: Option<bool>) -> Result<Design<K>, NoDesign> {
        let o_b: Point<K> = self.q.clone().into();
        let a = self.phi0.cis().scaled(&self.r);
        let corners = third_corners(&a, &o_b, &self.s.square(), &self.t.square())
            .ok_or(NoDesign::NotReal("the closure"))?;
        let [left, right] = corners.map(|b| self.with_pin(&o_b, &a, b));
        match is_left {
            Some(true) => left,
            Some(false) => right,
            None => {
                let (left, right) = (left?, right?);
                let [of_left, of_right] = [&left, &right].map(bending);
                match (of_left? - of_right?).sign() {
                    Some(Ordering::Greater) => Ok(right),
                    Some(_) => Ok(left),
                    None => Err(NoDesign::Undecided),
                }
            }
        }
    }

    fn with_pin(&self, o_b: &Point<K>, a: &Point<K>, b: Point<K>) -> Result<Design<K>, NoDesign> {
        let arm = (&b - a) * self.epsilon.cis();
        let point = a + arm.scaled(&(&self.m / &self.s));
        let standing = Design {
            linkage: CouplerPoint {
                pivots: [Number::zero(), o_b.clone()],
                pins: [a.clone(), b],
                point: point.clone(),
            },
            direction: Number::one(),
        }
        .checked()?;
        let motion = standing
            .motion(1)
            .ok_or(NoDesign::NotReal("the motion in this change point"))?;
        let velocity = coefficient(&motion.path_of(&point), 1);
        if velocity.is_zero().is_yes() {
            return Err(NoDesign::OutputAtPole);
        }
        let length = velocity.norm().sqrt();
        Ok(Design {
            direction: velocity.scaled(&length.inverse()),
            ..standing
        })
    }
}

/// The square of the curvature of D's path.
fn bending<K: Real>(design: &Design<K>) -> Result<Number<K>, NoDesign> {
    let deviation = design.deviation(2).ok_or(NoDesign::Undecided)?;
    let rate = deviation.u.coefficient(1).square();
    Ok((deviation.v.coefficient(2) / rate).square())
}
