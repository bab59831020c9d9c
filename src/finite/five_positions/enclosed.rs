//! The Burmester pairs where the conditions are known by enclosures only.

use super::chart::{Chart, Meets};
use super::conditions::Coordinates;
use crate::number::linear::kernel_in_order;
use crate::number::univariate::enclose;
use crate::number::{Ball, Complex, Number};

/// How many charts are tried.
const CHARTS: i64 = 8;

/// All four pairs, each by h, x, y, X, Y, p, q.
pub struct Enclosed {
    /// The real ones.
    pub real: Vec<[Number<Ball>; 7]>,
    /// One of each couple of conjugate ones.
    pub complex: Vec<[Number<Complex<Ball>>; 7]>,
}

/// Solved for the center and the products, so that most of a basis is zeros and ones.
const ORDER: [usize; 7] = [6, 5, 4, 3, 2, 1, 0];

/// The pairs that fulfil four conditions, each a row of coefficients in enclosures; `None` where these are
/// too wide to tell four different pairs apart.
pub fn pairs_of(conditions: &[Vec<Number<Ball>>], bits: u32) -> Option<Enclosed> {
    let basis = kernel_in_order(conditions.to_vec(), &ORDER)?;
    let basis: [Coordinates<Ball>; 3] = basis
        .into_iter()
        .map(|vector| vector.try_into().ok())
        .collect::<Option<Vec<_>>>()?
        .try_into()
        .ok()?;
    let charts = (0..CHARTS).filter_map(|seed| Chart::new(&basis, seed));
    charts
        .map(|chart| solved(&chart.meets(), bits))
        .find_map(|found| found)
}

/// The pairs of a chart; `None` where it cannot tell four different ones apart.
fn solved(meets: &Meets<Ball>, bits: u32) -> Option<Enclosed> {
    let Meets {
        resultant,
        second,
        coordinates,
    } = meets;
    if resultant.degree() != Some(4) {
        return None;
    }
    let roots = enclose(resultant, bits)?;
    let differ = roots
        .real
        .iter()
        .all(|s| second.evaluate(s).is_zero().is_no())
        && (roots.complex.iter()).all(|s| second.evaluate_complex(s).is_zero().is_no());
    let real = roots.real.iter().map(|s| coordinates.at(s, Number::clone));
    let complex = (roots.complex.iter()).map(|s| coordinates.at_complex(s, Number::clone));
    differ.then(|| Enclosed {
        real: real.collect(),
        complex: complex.collect(),
    })
}
