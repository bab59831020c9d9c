//! How long and how closely a point keeps to its line.
//!
//! - [`driven`]: a design driven by its crank O_aA,
//! - [`arc`]: the exact arc on which the deviation keeps within a bound, with all that happens on it,
//! - [`closed`]: u and v in closed form,
//! - [`crank`]: where the crank is in a dead centre, and where in line with the base,
//! - [`sweep`]: how far nothing ends the arc, quickly,
//! - [`floats`]: many positions, and the arcs of many linkages, in floats, with a bound of the error,
//! - [`stepped`]: the same in steps of one degree, as a program of 1964 went, over the [`rows`] of a
//!   design.

pub mod arc;
pub mod closed;
pub mod crank;
pub mod driven;
pub mod floats;
pub mod rows;
pub mod stepped;
pub mod sweep;
