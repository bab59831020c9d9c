//! The focal cubic by its focus: a circular cubic that passes through its own singular focus.
//!
//! Every centerpoint curve is one. With the focus φ as origin it has three terms only,
//!
//! ```text
//! Re(ᾱζ) |ζ|² + β |ζ|² + Re(ν̄ζ) = 0,   ζ = z − φ,
//! ```
//!
//! so that a line through the focus, ζ = r e with |e| = 1, meets it in two more points,
//!
//! ```text
//! Re(ᾱe) r² + β r + Re(ν̄e) = 0.
//! ```
//!
//! The middle of the two lies on a line, the midline, and from this quadratic all else follows: the
//! type without any root, the node, and a parametrisation without a gap.

use super::Point;
use super::circular_cubic::Cubic;
use super::projective::Line;
use crate::number::{Kind, Number, Real, Truth};

/// Re(ᾱζ) |ζ|² + β |ζ|² + Re(ν̄ζ) = 0 for ζ = z − φ, α not zero.
#[derive(Clone, Debug)]
pub struct FocalCubic<K> {
    /// φ, the singular focus, a point of the curve.
    pub focus: Point<K>,
    /// α, across the asymptote.
    pub alpha: Point<K>,
    /// β, the directed distance of the focus from the asymptote times |α|.
    pub beta: Number<K>,
    /// ν, across the tangent in the focus; zero where the curve is a line and the focus.
    pub nu: Point<K>,
}

/// Re(x̄y), the scalar product of two vectors.
fn scalar<K: Kind>(x: &Point<K>, y: &Point<K>) -> Number<K> {
    x.re() * y.re() + x.im() * y.im()
}

impl<K: Kind> FocalCubic<K> {
    /// The focal form of a circular cubic; `None` where the cubic part is not known to differ from
    /// zero, and where it is known that the cubic does not pass through its singular focus.
    pub fn of(cubic: &Cubic<K>) -> Option<Self> {
        if !cubic.contains_line_at_infinity().is_no() {
            return None;
        }
        let focus = cubic.singular_focus();
        if cubic.at(&focus).is_zero().is_no() && !K::ROUNDS {
            return None;
        }
        let [a, b, _, _, e, _, g, h, i, _] = cubic.coefficients();
        let alpha = Number::complex(a.clone(), b.clone());
        let lambda = Number::complex(h.clone(), i.clone());
        // With τ|z|² for the part of x² + y² in the square terms; their other part, the multiples of
        // Re z² and Im z², is what the choice of the origin removes.
        let tau = (e + g) / 2;
        let along = scalar(&alpha, &focus);
        Some(FocalCubic {
            nu: lambda - alpha.scaled(&focus.norm()) + focus.scaled(&(2 * (&along + &tau))),
            beta: 2 * along + tau,
            focus,
            alpha,
        })
    }

    /// The line Re(ᾱζ) = −β t.
    fn parallel(&self, t: &Number<K>) -> Line<K> {
        let constant = &self.beta * t - scalar(&self.alpha, &self.focus);
        Line::new(self.alpha.re().clone(), self.alpha.im().clone(), constant)
    }

    /// The real asymptote, Re(ᾱζ) + β = 0.
    pub fn asymptote(&self) -> Line<K> {
        self.parallel(&Number::one())
    }

    /// The midline, Re(ᾱζ) + β/2 = 0: halfway between the focus and the asymptote.
    pub fn midline(&self) -> Line<K> {
        self.parallel(&Number::ratio(1, 2))
    }

    /// m = β² − 2 Re(ᾱν): the quadratic of the direction e has the discriminant
    /// m − 2 Re(ᾱν̄e²), which runs from m − 2|αν| to m + 2|αν|.
    pub fn mean_discriminant(&self) -> Number<K> {
        self.beta.square() - 2 * scalar(&self.alpha, &self.nu)
    }

    /// m² − 4|αν|² = β⁴ − 4β² Re(ᾱν) − 4 Im(ᾱν)²: positive where every line through the focus meets
    /// the curve in two more real points, so that it has two branches; negative where some do
    /// not, so that it has one; zero where two branches meet in a node.
    ///
    /// For the focal cubic Im (z−A)(z−C)(z̄−B̄)(z̄−D̄) = 0 of a quadrilateral, with the factor 2, it is
    /// the product of all eight sums s₁ ± s₂ ± s₃ ± s₄ of its sides.
    pub fn discriminant(&self) -> Number<K> {
        self.mean_discriminant().square() - 4 * self.alpha.norm() * self.nu.norm()
    }

    /// Where a curve of two factors or of one branch with a loop has its double point, if it is not a
    /// line and a circle: ζ = −α (β/2 + i Im(ᾱν)/β)/|α|², on the midline. No value for β = 0.
    pub fn node(&self) -> Point<K> {
        let across = (self.alpha.conj() * &self.nu).im() / &self.beta;
        let turned = Number::complex(&self.beta / 2, across);
        &self.focus - (&self.alpha * turned).scaled(&self.alpha.norm().inverse())
    }
}

impl<K: Real> FocalCubic<K> {
    /// −q, the squared radius of the circle about the focus where the curve is a line and a circle
    /// (β = 0, ν = qα); they meet at ζ = ± i√−q α/|α|.
    pub fn squared_radius(&self) -> Number<K> {
        -scalar(&self.alpha, &self.nu) / self.alpha.norm()
    }

    /// Whether the curve is a line through the focus and a circle about it, which may be a point or
    /// not real.
    pub fn is_line_and_circle(&self) -> Truth {
        self.beta.is_zero() & (self.alpha.conj() * &self.nu).im().is_zero()
    }
}
