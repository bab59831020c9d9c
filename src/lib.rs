//! A certified reference for planar linkage kinematics.

pub mod curvature;
pub mod formula;
pub mod linkage;
pub mod number;
pub mod plane;
