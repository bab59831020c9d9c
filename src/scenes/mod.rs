//! Scenes: what a paper's symbols mean, from first principles.
//!
//! A scene is a mechanism or configuration, built from closure, series or elimination and never
//! from the paper's own equations. It binds the paper's symbols to values in any number kind. Its
//! parameters come from a [`Free`] source: symbols that stay free, random exact numbers, or the
//! numbers of a printed example.

pub mod check;
#[cfg(test)]
mod example2020;
mod filemon1970;
mod filemon1973;
pub mod free;
mod kaufman;
mod registry;
mod scene;
pub mod table;
mod tesar1964;
mod wunderlich1968;

pub use check::Check;
pub use free::{Free, Unbuilt};
pub use registry::{checks, find, find_check, find_table, scenes, tables};
pub use scene::{Scene, Symbol};
pub use table::Table;
pub use tesar1964::figures::{DrawnLinkage, drawn_linkage};
