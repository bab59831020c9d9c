//! Five positions: the Burmester pairs, a circlepoint and its center each.
//!
//! There are four in general, real or not, some at infinity, some equal; or families of them.
//!
//! - [`conditions`]: what a pair must fulfil, linear in the coordinates of both points and in two
//!   products of them,
//! - [`conics`]: the solutions of these in a projective plane, where the two products make two
//!   conics; their four meets, with an eliminant in which no point is lost,
//! - [`circlepoint_curves`]: the meets of two circlepoint curves,
//! - [`loop_closure`]: a link whose turns close the loops,
//! - [`enclosed`]: the conics where the conditions are known by enclosures only,
//! - [`certified`]: the pairs of rational positions to so many bits, the quickest way, which begins with
//!   machine floats and ends with a proof in them,
//! - [`floats`]: the conics in machine floats,
//! - [`families`]: what there is where the pairs are infinitely many,
//! - [`conditioning`]: how much a pair moves with the positions,
//! - [`krawczyk`]: the judge, an interval test on the original conditions.

pub mod certified;
pub mod chart;
pub mod circlepoint_curves;
pub mod conditioning;
pub mod conditions;
pub mod conics;
pub mod enclosed;
pub mod families;
pub mod floats;
pub mod krawczyk;
pub mod loop_closure;
mod refined;
