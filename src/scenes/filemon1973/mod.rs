//! E. Filemon, Rapid conformal sketching of the centerpoint curve (1973).

pub(super) mod pole_quadrilateral;
