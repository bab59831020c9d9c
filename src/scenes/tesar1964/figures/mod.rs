//! Chapter VII: the linkages of the figures, and what the program of chapter VI found of them.

pub mod ball_burmester;
pub mod contact_of_watt;
pub mod derivatives;
mod drawn;
mod drawn_linkage;
pub mod evans;
pub mod intersections;
pub mod nomograph;
pub mod precision_points;
pub mod quoted_angles;
mod results;
pub mod stars;
pub mod symmetric;
pub mod watt;

pub use drawn_linkage::{DrawnLinkage, drawn_linkage};

/// A scene with its parameters and with all that a figure lists.
macro_rules! listed {
    (
        $name:literal, $summary:literal, $certified:ident, $build:ident,
        [$($symbol:literal: $meaning:literal),* $(,)?]
    ) => {
        $crate::scenes::scene::scene!(
            $name, $summary, $certified, machine: 8, $build,
            [
                $($symbol: $meaning,)*
                "Q": "distance of the pivots, in unit lengths",
                "R": "length of the crank O_aA, in unit lengths",
                "S": "length of the coupler AB, in unit lengths",
                "T": "length of the crank O_bB, in unit lengths",
                "M": "distance of the output point D from A, in unit lengths",
                "N": "distance of D from B, in unit lengths",
                "epsilon": "from AB to AD, in degrees, more than -180 and not more than 180",
                "phi_0": "from O_aO_b to O_aA in the design position, in degrees from 0 to 360",
                "n_1": "the first level, the deviation up to which a travel counts, is this part of the unit length",
                "n_2": "the same for the second level",
                "n_3": "the same for the third level",
                "L_1": "travel within the first level, in unit lengths",
                "L_2": "travel within the second level, in unit lengths",
                "L_3": "travel within the third level, in unit lengths",
                "phi_1": "turn of R within the first level, in degrees",
                "phi_2": "turn of R within the second level, in degrees",
                "phi_3": "turn of R within the third level, in degrees",
                "psi_1": "turn of T within the first level, to whole degrees",
                "psi_2": "turn of T within the second level, to whole degrees",
                "psi_3": "turn of T within the third level, to whole degrees",
                "gamma_a1": "acute angle between R and the coupler at an end of the first level, the lesser \
                    one, in degrees",
                "gamma_a2": "the same for the second level",
                "gamma_a3": "the same for the third level",
                "gamma_b1": "acute angle between T and the coupler at an end of the first level, the lesser \
                    one, in degrees",
                "gamma_b2": "the same for the second level",
                "gamma_b3": "the same for the third level",
            ]
        )
    };
}
use listed;

/// The same with the exact arcs that the program's results approximate.
macro_rules! figure {
    (
        $name:literal, $summary:literal, $certified:ident, $build:ident,
        [$($symbol:literal: $meaning:literal),* $(,)?]
    ) => {
        $crate::scenes::tesar1964::figures::listed!(
            $name, $summary, $certified, $build,
            [
                $($symbol: $meaning,)*
                "L_1e": "exact travel within the first level",
                "L_2e": "exact travel within the second level",
                "L_3e": "exact travel within the third level",
                "phi_1e": "exact turn of R within the first level",
                "phi_2e": "exact turn of R within the second level",
                "phi_3e": "exact turn of R within the third level",
                "psi_1e": "exact turn of T within the first level",
                "psi_2e": "exact turn of T within the second level",
                "psi_3e": "exact turn of T within the third level",
                "gamma_a1e": "exact angle that gamma_a1 stands for",
                "gamma_a2e": "exact angle that gamma_a2 stands for",
                "gamma_a3e": "exact angle that gamma_a3 stands for",
                "gamma_b1e": "exact angle that gamma_b1 stands for",
                "gamma_b2e": "exact angle that gamma_b2 stands for",
                "gamma_b3e": "exact angle that gamma_b3 stands for",
            ]
        )
    };
}
use figure;
