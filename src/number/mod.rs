//! Number kinds and their laws; knows no geometry.
//!
//! A theory function is written once, for [`Number<K>`](Number) with any [`Kind`], and then runs in
//! `f64`, in [`Exact`] rationals, in complex numbers over either, and so on.

pub mod complex;
pub mod degrees;
pub mod exact;
mod float;
mod kind;
mod truth;
mod wrapper;

pub use complex::Complex;
pub use exact::Exact;
pub use kind::{Elementary, Kind, Real};
pub use truth::Truth;
pub use wrapper::Number;
