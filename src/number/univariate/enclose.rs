//! All roots of whatever polynomial lies in an enclosure.

use super::Polynomial;
use super::floats::proposed;
use super::polish::Approximate;
use super::proof::{FEW_BITS, half, root_near};
use crate::number::{Ball, Complex, Kind, Number, array};

/// Bits that proposals in floats are trusted with before anything is proven.
const KNOWN_BITS: u32 = 40;

/// Simple roots, all of them, each in an enclosure of its own; no two have a number in common.
#[derive(Clone, Debug)]
pub struct EnclosedRoots {
    /// The real roots.
    pub real: Vec<Number<Ball>>,
    /// The roots above the real axis, each for itself and its conjugate.
    pub complex: Vec<Number<Complex<Ball>>>,
}

/// The roots of every polynomial whose coefficients lie in these balls; `None` where they cannot be
/// told apart with so many bits.
///
/// As many different roots as the degree has are all, each simple; and a real one is no conjugate of
/// another.
pub fn enclose(polynomial: &Polynomial<Ball>, bits: u32) -> Option<EnclosedRoots> {
    let degree = polynomial.degree()?;
    if !polynomial.leading()?.is_zero().is_no() {
        return None;
    }
    let middles = polynomial.coefficients().iter();
    let middles: Option<Vec<_>> = middles.map(|c| c.0.middle(bits)).collect();
    let approximate = Approximate::new(middles?);
    let derivative = polynomial.derivative();
    let half = half(bits);
    let slopes = [FEW_BITS, half].map(|bits| derivative.map(|c| Number(c.0.with_precision(bits))));
    let mut roots = EnclosedRoots {
        real: Vec::new(),
        complex: Vec::new(),
    };
    let proposals = proposed(approximate.coefficients())?.into_iter();
    for point in proposals.filter(|point| point.im >= 0) {
        let near = approximate.root(point, KNOWN_BITS, half);
        if !near.is_finite() {
            return None;
        }
        let root = root_near(polynomial, &slopes, &near)?;
        if near.im.is_zero() {
            roots.real.push(root.0.re);
        } else {
            roots.complex.push(root);
        }
    }
    let count = roots.real.len() + 2 * roots.complex.len();
    (count == degree && roots.are_apart()).then_some(roots)
}

impl EnclosedRoots {
    /// Whether all are different, and those that are not real above the real axis.
    fn are_apart(&self) -> bool {
        all_differ(&self.real)
            && all_differ(&self.complex)
            && self.complex.iter().all(|z| z.im().is_positive().is_yes())
    }
}

fn all_differ<K: Kind>(roots: &[Number<K>]) -> bool {
    array::every_two(roots, |root, other| root.equals(other).is_no())
}
