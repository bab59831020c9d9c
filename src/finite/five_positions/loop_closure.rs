//! The Burmester pairs from loop closure (G. N. Sandor, A. G. Erdman).
//!
//! A link W from the center to the circlepoint z turns by bⱼ = e^{iβⱼ} while the plane turns from r₁
//! to rⱼ: W (bⱼ − 1) − (rⱼ − r₁) z = tⱼ − t₁ for j = 2, …, 5. Three of these have a solution where
//!
//! ```text
//! Δ₂ b₂ + Δ₃ b₃ + Δⱼ bⱼ = Δ₂ + Δ₃ + Δⱼ,      j = 4 or 5,
//! ```
//!
//! with the minors Δ of their last two columns. That bⱼ is a turn gives two equations of the form
//! A b₃ + B + A*/b₃ = 0; both have the root b₃ in common where their resultant, of order 6 in b₂,
//! vanishes. It has the roots b₂ = 1 and b₂ = r₂/r₁ of links that do not turn or do not move in the
//! plane; the other four belong to the pairs.

use crate::number::univariate::Polynomial;
use crate::number::{Complex, Exact, Number};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

type Poly = Polynomial<Complex<Exact>>;

/// The polynomial, of order 4 at most, of the turns of the links of all pairs between the first two
/// positions: 1 where the center is at infinity, the turn of the plane where the circlepoint is.
/// `None` where the resultant vanishes, as it does for these positions in another order as well if
/// there are families.
pub fn turns(positions: &[Displacement<Exact>; 5]) -> Option<Poly> {
    let [first, second, ..] = positions;
    let fourth = Condition::new(positions, 3);
    let fifth = Condition::new(positions, 4);
    let resultant = fourth.resultant(&fifth);
    let plane = &second.rotation / &first.rotation;
    let mut rest = resultant;
    for trivial in [Number::zero(), Number::one(), plane] {
        let (quotient, remainder) = rest.divide(&Polynomial::linear(&trivial))?;
        if !remainder.is_zero() {
            return None;
        }
        rest = quotient;
    }
    (!rest.is_zero()).then_some(rest)
}

/// A b₃ + B + A*/b₃ = 0, each times b₂, as polynomials in b₂.
struct Condition {
    a: Poly,
    b: Poly,
    a_star: Poly,
}

impl Condition {
    /// Of the second, third and another position: |D + Δ₂b₂ + Δ₃b₃|² = |Δⱼ|², D = −Δ₂ − Δ₃ − Δⱼ.
    fn new(positions: &[Displacement<Exact>; 5], other: usize) -> Self {
        let [first, ..] = positions;
        let row = |place: usize| -> [Point<Exact>; 2] {
            let position = positions.get(place).unwrap_or(first);
            [
                &position.rotation - &first.rotation,
                &position.translation - &first.translation,
            ]
        };
        let minor = |[r, d]: [Point<Exact>; 2], [r1, d1]: [Point<Exact>; 2]| r * d1 - r1 * d;
        let delta_2 = minor(row(2), row(other));
        let delta_3 = minor(row(other), row(1));
        let delta_j = minor(row(1), row(2));
        let rest = -(&delta_2 + &delta_3 + &delta_j);
        let norm = |z: &Point<Exact>| Number::from(z.norm());
        let constant = norm(&rest) + norm(&delta_2) + norm(&delta_3) - norm(&delta_j);
        let mixed = &rest * delta_2.conj();
        Condition {
            a: Polynomial::new(vec![&delta_3 * delta_2.conj(), &delta_3 * rest.conj()]),
            b: Polynomial::new(vec![mixed.clone(), constant, mixed.conj()]),
            a_star: Polynomial::new(vec![
                Number::zero(),
                delta_3.conj() * &rest,
                delta_3.conj() * &delta_2,
            ]),
        }
    }

    /// Of the two quadratic equations in b₃.
    fn resultant(&self, other: &Self) -> Poly {
        let outer = &self.a * &other.a_star - &other.a * &self.a_star;
        let left = &self.a * &other.b - &other.a * &self.b;
        let right = &self.b * &other.a_star - &other.b * &self.a_star;
        &outer * &outer - left * right
    }
}
