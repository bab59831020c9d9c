//! A certified reference for planar linkage kinematics.

pub mod curvature;
pub mod formula;
pub mod ledger;
pub mod linkage;
pub mod number;
pub mod plane;
pub mod scenes;
