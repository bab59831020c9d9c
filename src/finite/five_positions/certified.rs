//! All pairs of rational positions to so many bits, by whatever is quickest.

use super::conics::{Isolated, Pair, Pairs, Place, first_meets, pairs};
use super::enclosed::{self, Enclosed};
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
    let working = bits.checked_add(LOST_BITS)?;
    let found = if bits <= MOST_ENCLOSED_BITS {
        in_enclosures(positions, working)
    } else {
        by_exact_conics(positions, working)
    };
    if let Some(found) = found.and_then(|found| sharp(found, bits)) {
        return Some(found);
    }
    match pairs(positions)? {
        Pairs::Isolated(isolated) => Some(exact(&isolated, bits)),
        Pairs::Families(_) => None,
    }
}

/// How often the bits of the roots are doubled for coordinates in which terms cancel. One that is zero
/// for a root that is not rational never gets sharp.
const DOUBLINGS: u32 = 3;

fn exact(isolated: &Isolated, bits: u32) -> Certified {
    let from = |working: u32| Certified {
        real: isolated.real(working),
        complex: isolated.complex(working),
    };
    let attempts = (0..DOUBLINGS).map(|doublings| from(bits.saturating_mul(1 << doublings)));
    let sharp = |found: &Certified| found.has_bits(bits);
    let mut attempts = attempts.skip_while(|found| !sharp(found));
    attempts
        .next()
        .unwrap_or_else(|| from(bits.saturating_mul(1 << DOUBLINGS)))
}

impl Certified {
    /// Whether every coordinate is zero or known to so many bits.
    fn has_bits(&self, bits: u32) -> bool {
        let real = self.real.iter().flat_map(|pair| &pair.coordinates);
        let complex = self.complex.iter().flat_map(|pair| &pair.coordinates);
        let mut parts = real.chain(complex.flat_map(|z| [z.re(), z.im()]));
        parts.all(|x| x.is_zero().is_yes() || has_bits(x, bits))
    }
}

fn has_bits(x: &Number<Ball>, bits: u32) -> bool {
    x.0.accuracy_bits() >= Some(i64::from(bits))
}

/// Four different pairs, from enclosures on.
fn in_enclosures(positions: &[Displacement<Exact>; 5], working: u32) -> Option<Enclosed> {
    enclosed::pairs(&rounded(positions, working)?, working)
}

/// The same from the exact resultant on: with many bits its coefficients are short.
fn by_exact_conics(positions: &[Displacement<Exact>; 5], working: u32) -> Option<Enclosed> {
    // What a coefficient needs, and one or zero as such.
    let short = |x: &Number<Exact>| {
        let q = x.0.rational().cloned().unwrap_or_default();
        let bits = q.numer().significant_bits();
        if bits < 64 || !q.is_integer() {
            Number::from(q)
        } else {
            Number::rounded(&q, &bits.min(working))
        }
    };
    let whole = |x: &Number<Exact>| {
        let q = x.0.rational().cloned().unwrap_or_default();
        Number::rounded(&q, &working)
    };
    enclosed::solved(&first_meets(positions)?.map(short, whole), working)
}

/// If they are finite and known to so many bits.
fn sharp(found: Enclosed, bits: u32) -> Option<Certified> {
    let is_sharp = |x: &Number<Ball>| has_bits(x, bits);
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
