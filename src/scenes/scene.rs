//! What a scene is.

use super::{Free, Unbuilt};
use crate::formula::Bindings;
use crate::number::poly::Fraction;
use crate::number::{Ball, Decimal, Surd};

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
    /// As the machine computed it that printed the numbers, where one did.
    pub machine: Option<Emulation>,
}

/// A scene in the arithmetic of a machine.
#[derive(Clone, Copy, Debug)]
pub struct Emulation {
    /// Decimal digits of its numbers.
    pub digits: u32,
    /// The scene.
    pub build: Build<Decimal>,
}

/// Makes a [`Scene`] of a generic function. With `not symbolic: "why"` it is built with numbers only;
/// with `machine: digits` it needs the elementary functions, and is what a machine of so many decimal
/// digits computed; then the build in enclosures may show the true values beside.
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
    (
        $name:literal, $summary:literal, $certified:ident,
        machine: $digits:literal, $build:ident, [$($symbol:literal: $meaning:literal),* $(,)?]
    ) => {
        $crate::scenes::Scene {
            name: $name,
            summary: $summary,
            file: file!(),
            symbols: &[$($crate::scenes::Symbol { name: $symbol, meaning: $meaning }),*],
            symbolic: |_| Err($crate::scenes::Unbuilt::no_functions()),
            exact: |_| Err($crate::scenes::Unbuilt::no_functions()),
            certified: $certified,
            float: $build,
            machine: Some($crate::scenes::scene::Emulation { digits: $digits, build: $build }),
        }
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
            machine: None,
        }
    };
}
pub(super) use scene;
