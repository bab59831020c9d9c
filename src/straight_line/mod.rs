//! Linkages of which a point goes nearly straight.
//!
//! - [`design`]: a four-bar in its design position, with the direction in which its point goes,
//! - [`no_design`]: why parameters have none,
//! - [`turning`]: angles in degrees, as series.
//!
//! By curvature theory, seen from the pole, with the pole tangent as x-axis and the diameter of the
//! inflection circle as unit:
//!
//! - [`ball_burmester`]: five infinitely near positions on the line, from three rays, from two, from a
//!   slider-crank,
//! - [`slider_crank`]: a slider-crank with its slider displaced,
//! - [`six_points`]: four infinitely near positions on the line and two more, apart or not,
//! - [`symmetrical`]: symmetrical coupler curves, and two inflections with one tangent.
//!
//! Classical ones: [`watt`], [`evans`], [`conchoid`], [`symmetric`]; and any [`four_bar`].
//!
//! - [`deviation`]: how long and how closely the point keeps to the line.

pub mod ball_burmester;
pub mod conchoid;
pub mod design;
pub mod deviation;
pub mod evans;
pub mod four_bar;
pub mod no_design;
pub mod six_points;
pub mod slider_crank;
pub mod symmetric;
pub mod symmetrical;
pub mod turning;
pub mod watt;
