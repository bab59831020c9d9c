//! What a scene is.

use super::{Free, Unbuilt};
use crate::formula::Bindings;
use crate::number::poly::Fraction;
use crate::number::{Ball, Surd};

/// What a symbol of a scene means.
#[derive(Clone, Copy, Debug)]
pub struct Symbol {
    /// As formulas write it.
    pub name: &'static str,
    /// Meaning, with unit and sign convention where there is one.
    pub meaning: &'static str,
}

/// Builds a scene in one number kind.
pub type Build<K> = fn(&mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt>;

/// A scene in the number kinds in which statements are judged.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// The name by which data refer to it.
    pub name: &'static str,
    /// What it shows and how it is built.
    pub summary: &'static str,
    /// The source file that holds it.
    pub file: &'static str,
    /// All symbols, in a sensible reading order.
    pub symbols: &'static [Symbol],
    /// With free symbols: for identities.
    pub symbolic: Build<Fraction>,
    /// With exact numbers: for decisions.
    pub exact: Build<Surd>,
    /// With enclosures: for certified values.
    pub certified: Build<Ball>,
    /// With floats: for comparison only.
    pub float: Build<f64>,
}

/// Makes a [`Scene`] of a generic function. With `not symbolic: "why"` it is built with numbers only.
macro_rules! scene {
    ($name:literal, $summary:literal, $build:ident, [$($symbol:literal: $meaning:literal),* $(,)?]) => {
        $crate::scenes::scene::scene!(@ $name, $summary, $build, $build, [$($symbol: $meaning),*])
    };
    (
        $name:literal, $summary:literal, $build:ident, not symbolic: $why:literal,
        [$($symbol:literal: $meaning:literal),* $(,)?]
    ) => {
        $crate::scenes::scene::scene!(
            @ $name, $summary, $build,
            |_| Err($crate::scenes::Unbuilt::NotHeld($why.to_owned())),
            [$($symbol: $meaning),*]
        )
    };
    (@ $name:literal, $summary:literal, $build:ident, $symbolic:expr, [$($symbol:literal: $meaning:literal),*]) => {
        $crate::scenes::Scene {
            name: $name,
            summary: $summary,
            file: file!(),
            symbols: &[$($crate::scenes::Symbol { name: $symbol, meaning: $meaning }),*],
            symbolic: $symbolic,
            exact: $build,
            certified: $build,
            float: $build,
        }
    };
}
pub(super) use scene;
