//! D. Tesar, The analytical theory of coplanar motion applied to approximate four-bar straight line
//! mechanisms (1964).
//!
//! Chapter II: the pole is the origin, angles are measured from the pole tangent so that the pole
//! normal through the inflection pole is at 90°, distances from the pole are positive along the ray
//! of their angle, and the diameter of the inflection circle is 1.

pub(super) mod slider_crank;
