//! Points of a focal cubic: each branch as the image of a circle, without a gap.
//!
//! The line through the focus in the direction e = e^{iψ} e^{iη}, where 2ψ is the argument of αν, has
//! the discriminant m + d − 2d cos² η with d = 2|αν|. Where it is positive throughout, each of its
//! roots gives one branch, η running through half a turn. Where it is not, cos η = κ cos θ with
//! κ² = (m + d)/2d makes it (m + d) sin² θ, so that its root, too, changes sign where two points
//! on the line meet: a whole turn of θ passes the one branch once.

use std::cmp::Ordering;

use super::Point;
use super::curve_type::CurveType;
use super::focal_cubic::FocalCubic;
use super::projective::ProjectivePoint;
use crate::number::{Number, Real};

/// One branch of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// The closed one of two; it passes through the focus.
    Closed,
    /// That of two with both ends at infinity.
    Open,
    /// The only one, with a loop or without.
    Only,
}

/// What all points of a focal cubic have in common.
#[derive(Clone, Debug)]
pub struct Trace<K> {
    curve: FocalCubic<K>,
    branches: &'static [Branch],
    /// e^{iψ}
    axis: Point<K>,
    /// κ, where there is one branch.
    kappa: Number<K>,
    /// 2d/(m + d) = 1/κ²
    modulus: Number<K>,
    /// √(m + d), the largest root of the discriminant.
    reach: Number<K>,
}

impl<K: Real> Trace<K> {
    /// Prepares for a curve of a type with branches: one, two, or one with a node. `None` for every
    /// other type.
    pub fn new(curve: FocalCubic<K>, curve_type: CurveType) -> Option<Self> {
        let branches: &[Branch] = match curve_type {
            CurveType::OneBranch | CurveType::Nodal => &[Branch::Only],
            CurveType::TwoBranches => &[Branch::Open, Branch::Closed],
            _ => return None,
        };
        let product = &curve.alpha * &curve.nu;
        let length = product.norm().sqrt();
        let top = curve.mean_discriminant() + 2 * &length;
        let kappa = if curve_type == CurveType::Nodal {
            Number::one()
        } else {
            (&top / (4 * &length)).sqrt()
        };
        Some(Trace {
            axis: direction_of_root(&product, &length),
            modulus: 4 * &length / &top,
            reach: top.sqrt(),
            kappa,
            branches,
            curve,
        })
    }

    /// The branches.
    pub fn branches(&self) -> &'static [Branch] {
        self.branches
    }

    /// The point of a branch that belongs to a point cos θ + i sin θ of the unit circle. On the closed
    /// and on the open branch opposite points of the circle have one image.
    pub fn point(&self, branch: Branch, turn: &Point<K>) -> ProjectivePoint<K> {
        let (cos, sin) = (turn.re(), turn.im());
        if branch == Branch::Only {
            let cos_eta = &self.kappa * cos;
            let sin_eta = (1 - cos_eta.square()).sqrt();
            return self.on_line(&cos_eta, &sin_eta, &(&self.reach * sin));
        }
        let root = &self.reach * (1 - &self.modulus * cos.square()).sqrt();
        let towards_far = self.curve.beta.sign() == Some(Ordering::Less);
        let root = if towards_far == (branch == Branch::Open) {
            root
        } else {
            -root
        };
        self.on_line(cos, sin, &root)
    }

    /// The root r = (−β + √)/2 Re(ᾱe) of Re(ᾱe) r² + β r + Re(ν̄e) = 0 on the line of direction η, also
    /// written 2 Re(ν̄e)/(−β − √): whichever of the two sums loses nothing.
    fn on_line(&self, cos: &Number<K>, sin: &Number<K>, root: &Number<K>) -> ProjectivePoint<K> {
        let FocalCubic {
            focus,
            alpha,
            beta,
            nu,
        } = &self.curve;
        let [a, b] = [self.axis.re(), self.axis.im()];
        let (x, y) = (a * cos - b * sin, a * sin + b * cos);
        let opposite = match (beta.sign(), root.sign()) {
            (Some(Ordering::Less | Ordering::Greater), Some(sign)) => beta.sign() != Some(sign),
            _ => true,
        };
        let (r, w) = if opposite {
            (root - beta, 2 * (alpha.re() * &x + alpha.im() * &y))
        } else {
            (2 * (nu.re() * &x + nu.im() * &y), -(root + beta))
        };
        ProjectivePoint::new(focus.re() * &w + &r * x, focus.im() * &w + r * y, w)
    }
}

/// A unit vector of half the argument of z, one of the two; |z| is given. For zero, any will do.
fn direction_of_root<K: Real>(z: &Point<K>, length: &Number<K>) -> Point<K> {
    if length.is_zero().is_yes() {
        return Number::one();
    }
    // (|z| + x, y) and (y, |z| − x) have that argument modulo π; that sum is taken which loses nothing.
    let half = if z.re().sign() == Some(Ordering::Less) {
        Number::complex(z.im().clone(), length - z.re())
    } else {
        Number::complex(length + z.re(), z.im().clone())
    };
    let size = half.norm().sqrt();
    Number::complex(half.re() / &size, half.im() / size)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Complex;

    #[test]
    fn directions_of_roots_have_the_square_of_the_argument() {
        for (x, y) in [
            (4, 0),
            (-4, 0),
            (3, 4),
            (-3, 4),
            (-3, -4),
            (3, -4),
            (0, 5),
            (0, -5),
            (0, 0),
        ] {
            let z = Number::<Complex<f64>>::complex(Number::from(x), Number::from(y));
            let length = z.norm().sqrt();
            let root = direction_of_root(&z, &length);
            let square = (&root * &root).scaled(&length);
            let error = (square - z).norm().0;
            assert!(
                error < 1e-28 && (root.norm().0 - 1.0).abs() < 1e-15,
                "{x} + {y} i: {root:?}"
            );
        }
    }
}
