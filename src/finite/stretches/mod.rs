//! The stretches of the centerpoint curve of four positions that fulfil a designer's wishes.
//!
//! [`congruent_pencils`] makes both curves functions of one slope and one root, [`wishes`] says where a
//! wish is on its limit and whether a pair fulfils it, [`cells`] decides between the limits.

pub mod cells;
pub mod congruent_pencils;
pub mod wishes;
