//! Infinitesimally separated positions.
//!
//! A motion near one of its positions is a displacement whose rotation and translation are power
//! [series](crate::number::Series). That n + 1 infinitesimally separated positions of a point lie on a
//! circle says that the coefficients of t, …, tⁿ vanish in its squared distance from the center: a
//! statement about coefficients, not about small numbers.
//!
//! - [`motion`]: motions as series, and where they carry a point,
//! - [`closure`]: the motion of a linkage from what its joints keep,
//! - [`contact`]: order of contact of a path with a circle or a line,
//! - [`osculation`]: centers of curvature, the inflection circle and the cubic of stationary curvature,
//!   from the paths,
//! - [`canonical`]: the pole, the polodes, and the motion seen from the pole: its instantaneous
//!   invariants,
//! - [`burmester`]: the points with five positions on a circle, by two routes,
//! - [`mixed`]: five positions of which some are infinitely near each other,
//! - [`slider_crank`]: those of a slider-crank, where no tangent has to be finite.

pub mod burmester;
pub mod canonical;
pub mod closure;
pub mod contact;
pub mod mixed;
pub mod motion;
pub mod osculation;
pub mod slider_crank;
