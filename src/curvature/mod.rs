//! Infinitesimally separated positions.

pub mod slider_crank;
