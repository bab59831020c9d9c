//! Number kinds and their laws; knows no geometry.
//!
//! A theory function is written once, for [`Number<K>`](Number) with any [`Kind`], and then runs in
//! `f64`, in [`Exact`] rationals, in complex numbers over either, and so on.

pub(crate) mod array;
mod ball;
pub mod complex;
pub(crate) mod count;
pub mod decimal;
pub mod degrees;
pub mod exact;
mod float;
pub(crate) mod gaussian;
mod interval;
mod kind;
pub(crate) mod lanes;
pub mod linear;
pub mod poly;
mod series;
pub mod surd;
pub mod text;
mod truth;
pub mod univariate;
mod wrapper;
pub mod zeros;

pub use ball::{Ball, BallText};
pub use complex::Complex;
pub use decimal::Decimal;
pub use exact::Exact;
pub use interval::Interval;
pub use kind::{EXCESSIVE_BITS, EXCESSIVE_TERMS, Elementary, Kind, Real};
pub use poly::{Fraction, Poly, Ring, Variable};
pub use series::Series;
pub use surd::Surd;
pub use truth::Truth;
pub use univariate::{Polynomial, Quadratic, QuadraticRoots, Radical};
pub use wrapper::Number;
