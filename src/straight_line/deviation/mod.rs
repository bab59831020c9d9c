//! How long and how closely a point keeps to its line.
//!
//! - [`driven`]: a design driven by its crank O_aA,
//! - [`arc`]: the exact arc on which the deviation keeps within a bound, with all that happens on it,
//! - [`stepped`]: the same in steps of one degree, as a program of 1964 went, over the [`rows`] of a
//!   design.

pub mod arc;
pub mod driven;
pub mod rows;
pub mod stepped;
