//! Four positions: the centerpoint curve and the circlepoint curve.
//!
//! A point of the moving plane is a circlepoint if its four places lie on a circle; the center of
//! that circle, a point of the fixed plane, is its centerpoint. Seen from the moving plane the two
//! change their names, so every route gives both curves. The routes share nothing but the
//! positions:
//!
//! - [`viewing_angles`]: opposite sides of a quadrilateral of poles are seen under equal angles,
//! - [`isotropic`]: the same locus as the focal cubic of the quadrilateral, in z and z̄,
//! - [`circle_conditions`]: equal distances from the center, as a determinant,
//! - [`loop_closure`]: the crank carried back into its first position, as a determinant.

pub mod circle_conditions;
pub mod isotropic;
pub mod loop_closure;
pub mod viewing_angles;
