//! All pairs of rational positions to so many bits, by whatever is quickest.

use super::conics::{Isolated, Pair, Pairs, Place, pairs};
use super::enclosed;
use crate::number::{Ball, Complex, Exact, Number};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// Up to here enclosures are shorter than the numbers of an exact elimination.
const MOST_ENCLOSED_BITS: u32 = 1000;
/// Bits that the elimination in enclosures loses, as a rule.
const LOST_BITS: u32 = 64;

/// All pairs, isolated, none missing.
#[derive(Clone, Debug)]
pub struct Certified {
    /// The real ones.
    pub real: Vec<Pair<Ball>>,
    /// One of each couple of conjugate ones.
    pub complex: Vec<Pair<Complex<Ball>>>,
}

/// The pairs of five positions; `None` for families. Where many bits are asked for, or the enclosures
/// cannot tell the pairs apart or from infinity, by exact elimination.
pub fn certified(positions: &[Displacement<Exact>; 5], bits: u32) -> Option<Certified> {
    if bits <= MOST_ENCLOSED_BITS
        && let Some(found) = in_enclosures(positions, bits)
    {
        return Some(found);
    }
    match pairs(positions)? {
        Pairs::Isolated(isolated) => Some(exact(&isolated, bits)),
        Pairs::Families(_) => None,
    }
}

fn exact(isolated: &Isolated, bits: u32) -> Certified {
    Certified {
        real: isolated.real(bits),
        complex: isolated.complex(bits),
    }
}

/// Four different finite pairs, to so many bits.
fn in_enclosures(positions: &[Displacement<Exact>; 5], bits: u32) -> Option<Certified> {
    let working = bits + LOST_BITS;
    let found = enclosed::pairs(&rounded(positions, working)?, working)?;
    let is_sharp = |x: &Number<Ball>| x.0.accuracy_bits() >= Some(i64::from(bits));
    let real = found.real.into_iter().map(|coordinates| {
        let sharp = coordinates[0].is_zero().is_no() && coordinates.iter().all(is_sharp);
        sharp.then_some(Pair {
            coordinates,
            place: Place::Finite,
            multiplicity: 1,
        })
    });
    let complex = found.complex.into_iter().map(|coordinates| {
        let parts_are = |z: &Number<Complex<Ball>>| is_sharp(z.re()) && is_sharp(z.im());
        let sharp = coordinates[0].is_zero().is_no() && coordinates.iter().all(parts_are);
        sharp.then_some(Pair {
            coordinates,
            place: Place::Finite,
            multiplicity: 1,
        })
    });
    Some(Certified {
        real: real.collect::<Option<_>>()?,
        complex: complex.collect::<Option<_>>()?,
    })
}

fn rounded(positions: &[Displacement<Exact>; 5], bits: u32) -> Option<[Displacement<Ball>; 5]> {
    let ball = |x: &Number<Exact>| Some(Number::<Ball>::rounded(x.0.rational()?, &bits));
    let point = |z: &Point<Exact>| Some(Number::complex(ball(z.re())?, ball(z.im())?));
    let placed = positions.iter().map(|position| {
        Some(Displacement {
            rotation: point(&position.rotation)?,
            translation: point(&position.translation)?,
        })
    });
    placed.collect::<Option<Vec<_>>>()?.try_into().ok()
}
