//! E. Filemon, Some connections of the Burmester designing process (1970).
//!
//! O_ij is the pole of the positions i and j. What the print marks with an upper index 1, a point
//! of the moving plane where it is in position 1, has a prime in formulas: O_23' is the mirror pole
//! O_23^1. Angles turn counterclockwise in the order of their letters.

pub(super) mod asymptote;
pub(super) mod both_asymptotes;
pub(super) mod characteristic_points;
pub(super) mod construction;
pub(super) mod infinite_links;
pub(super) mod pole_system;
mod positions;
pub(super) mod same_type;
pub(super) mod twelve_links;
pub(super) mod two_positions;
pub(super) mod visual_angles;
