//! A certified reference for planar linkage kinematics.

pub mod number;
pub mod plane;
