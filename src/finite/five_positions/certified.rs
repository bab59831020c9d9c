//! All pairs of rational positions to so many bits, by whatever is quickest.

use super::conics::{Isolated, Pair, Pairs, pairs};
use super::refined;
use crate::number::{Ball, Complex, Exact, Number};
use crate::plane::displacement::Displacement;

/// All pairs, isolated, none missing.
#[derive(Clone, Debug)]
pub struct Certified {
    /// The real ones.
    pub real: Vec<Pair<Ball>>,
    /// One of each couple of conjugate ones.
    pub complex: Vec<Pair<Complex<Ball>>>,
}

/// Where pairs move much with the positions their radii are larger than was foreseen.
const MORE_BITS: u32 = 64;

/// The pairs of five positions; `None` for families. Where four finite pairs cannot be told apart from
/// machine floats on, by exact elimination.
pub fn certified(positions: &[Displacement<Exact>; 5], bits: u32) -> Option<Certified> {
    let attempts = [bits, bits.saturating_add(MORE_BITS)].into_iter();
    let mut found = attempts.map_while(|bits| refined::pairs(positions, bits));
    if let Some(found) = found.find(|found| found.has_bits(bits)) {
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
    pub(super) fn has_bits(&self, bits: u32) -> bool {
        let real = self.real.iter().flat_map(|pair| &pair.coordinates);
        let complex = self.complex.iter().flat_map(|pair| &pair.coordinates);
        let mut parts = real.chain(complex.flat_map(|z| [z.re(), z.im()]));
        parts.all(|x| x.is_zero().is_yes() || has_bits(x, bits))
    }
}

fn has_bits(x: &Number<Ball>, bits: u32) -> bool {
    x.0.accuracy_bits() >= Some(i64::from(bits))
}
