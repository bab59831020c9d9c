//! W. Wunderlich, On Burmester's focal mechanism and Hart's straight-line motion (1968).
//!
//! Lengths of bars are positive, except where section 7 makes one negative; MS, NS, AT, BT are
//! directed along MN and AB. Angles turn counterclockwise: ∠XYZ carries the ray YX into the ray YZ.

pub(super) mod completion;
pub(super) mod coupler;
pub(super) mod every_point;
pub(super) mod figure;
pub(super) mod five_bar;
pub(super) mod focal_cubic;
pub(super) mod focal_mechanism;
pub(super) mod foci;
pub(super) mod hart;
pub(super) mod hart_kite;
pub(super) mod keeps_lengths;
pub(super) mod order;
pub(super) mod point_of_the_cubic;
mod position;
pub(super) mod quadratics;
pub(super) mod revolving_coupler;
pub(super) mod symmetric_crank_drive;
pub(super) mod symmetric_position;
