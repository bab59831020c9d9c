//! E. Filemon, Rapid conformal sketching of the centerpoint curve (1973).
//!
//! Sides are lengths, not directed; η₀ and ζ₀ are abscissas, which have a sign. The angle φ turns
//! from the ζ-axis to the η-axis, which point from O₁₂ to O₂₃ and from O₁₄ to O₃₄.

pub(super) mod any_shape;
pub(super) mod convex_quadrilateral;
mod count;
pub(super) mod discriminant;
pub(super) mod disintegrating;
pub(super) mod even_branch;
pub(super) mod focus;
pub(super) mod focus_divides;
pub(super) mod inflexions;
pub(super) mod inner_arcs;
pub(super) mod kite;
pub(super) mod nodal_curve;
pub(super) mod node;
pub(super) mod oblique_axes;
pub(super) mod pole_quadrilateral;
mod quadrilateral;
mod sample;
mod side_order;
pub(super) mod sides_and_tangents;
pub(super) mod slopes;
pub(super) mod tables;
pub(super) mod tangents_of_pairs;
