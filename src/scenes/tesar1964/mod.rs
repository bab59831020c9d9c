//! D. Tesar, The analytical theory of coplanar motion applied to approximate four-bar straight line
//! mechanisms (1964).
//!
//! Chapter II: the pole is the origin, angles are measured from the pole tangent so that the pole
//! normal through the inflection pole is at 90°, distances from the pole are positive along the ray
//! of their angle, and so are those from a center to its point; the diameter of the inflection circle is 1
//! where it is not named.
//!
//! Chapter III: the coordinates are x, y in the moving plane and X, Y in the fixed one; a, b, φ are
//! the place of the moving origin and the turn.
//!
//! Chapter IV: as in chapter II, but a crank counts from its pin to its pivot. Angles are turns,
//! counterclockwise; that of the coupler, epsilon, leads from AB to AD.
//!
//! Chapter V: U, V are right-handed coordinates of the fixed plane in the design position, and angles
//! turn from U to V; O_a, O_b are the pivots, A, B the pins of the cranks R, T, S the coupler AB, Q the
//! fixed link, D the output point at the distances M from A and N from B, ε the turn from AB to AD.
//! Lengths are not directed.
//!
//! Chapter VI: as in chapter V; the x-axis leads from O_a to O_b, and the angles φ, χ, ψ of O_aA, AB and O_bB
//! are measured from it.

pub(super) mod alternates;
pub(super) mod ball_burmester;
pub(super) mod burmester_pair;
pub(super) mod burmester_points;
pub(super) mod circlepoint;
pub(super) mod conchoid;
pub(super) mod conics;
pub(super) mod contact_properties;
pub(super) mod coupler_point;
pub(super) mod coupler_triangle;
mod crank_and_slider;
pub(super) mod crank_error;
pub(super) mod dead_centres;
pub(super) mod displaced_coupler;
pub(super) mod drawn_four_bar;
pub(super) mod evans;
pub(super) mod figures;
pub(super) mod five_position_pairs;
pub(super) mod five_positions;
pub(super) mod five_positions_on_a_line;
pub(super) mod four_bar;
pub(super) mod grashof;
pub(super) mod grashof_rules;
pub(super) mod inflection_pole;
pub(super) mod input_output;
pub(super) mod known_center;
pub(super) mod moving_plane;
pub(super) mod one_intersection;
pub(super) mod origin_on_the_axis;
pub(super) mod places_on_a_line;
pub(super) mod point_on_a_line;
mod pole_frame;
pub(super) mod positions_on_a_line;
pub(super) mod precision_points;
pub(super) mod program;
mod quadratic;
pub(super) mod second_position;
mod sense;
pub(super) mod slider_crank;
pub(super) mod stationary_points;
pub(super) mod symmetric_alternate;
pub(super) mod symmetric_curve;
pub(super) mod symmetric_linkage;
pub(super) mod tangent_of_the_path;
pub(super) mod transmission_angle;
pub(super) mod travel;
pub(super) mod type_of_mechanism;
pub(super) mod watt;
