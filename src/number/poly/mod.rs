//! Polynomials over ℚ in several variables with relations, and their fractions: identities that
//! hold for all values.
//!
//! A [`Ring`] names the variables and says what is known of them; a [`Fraction`] is the number
//! kind. Denominators stay lists of factors, so nothing here ever computes a greatest common
//! divisor of polynomials.
//!
//! ```
//! use burmester::number::{Fraction, Number, Ring};
//! let ring = Ring::empty().with_angle("c", "s").ok_or("too many variables")?;
//! let [c, s] = ring.numbers::<2>();
//! let half: Number<Fraction> = &s / (1 + &c); // tan α/2
//! assert!((2 * &half / (1 + half.square())).equals(&s).is_yes());
//! # Ok::<(), &str>(())
//! ```

mod coefficient;
mod denominator;
mod display;
mod fraction;
mod monomial;
mod polynomial;
mod ring;
mod root;
mod sign;
mod terms;

pub use fraction::Fraction;
pub use polynomial::Poly;
pub use ring::{Ring, Variable};
