//! Linkages from their closure: four-bar, its cognates and coupler curve, five-bar, focal mechanism, its crank drive, and Hart's
//! straight-line mechanism.

pub mod cognates;
pub mod coupler_curve;
pub mod crank_drive;
pub mod five_bar;
pub mod focal_mechanism;
pub mod four_bar;
pub mod hart;
pub mod passage;
pub mod whole_motion;
