//! [`ComplexRoot`]: an isolating disc that can be narrowed without end.

use std::sync::Arc;

use rug::{Float, Rational};

use super::descartes::times_power_of_two;
use super::factor::{Factor, log2_above, log2_below};
use super::point::Point;
use super::proof::{FEW_BITS, half, root_near};
use crate::number::{Ball, Complex, Number, Real, count};

/// Bits that Newton's method works with beyond the accuracy that it aims at.
const GUARD_BITS: u32 = 64;

/// A root with positive imaginary part of a polynomial over ℚ; it stands for the couple of this
/// root and its conjugate, which have the same multiplicity.
///
/// The root lies in a disc. The square around the disc lies in the upper half-plane and holds no
/// other root.
#[derive(Clone, Debug)]
pub struct ComplexRoot {
    factor: Arc<Factor>,
    disc: Disc,
    multiplicity: usize,
}

/// A closed disc.
#[derive(Clone, Debug)]
pub(super) struct Disc {
    pub re: Rational,
    pub im: Rational,
    pub radius: Rational,
}

impl Disc {
    /// The disc around a point in which a factor surely has a root, and the Newton step there.
    ///
    /// If n |p/p′| < |z − ζ| held for all roots ζ, then |p′/p| = |Σ 1/(z − ζ)| would be less than
    /// itself. `None` where the precision does not bound the quotient.
    pub fn around(factor: &Factor, re: Rational, im: Rational, bits: u32) -> Option<(Disc, Step)> {
        let z = Number::complex(
            Number::<Ball>::rounded(&re, &bits),
            Number::<Ball>::rounded(&im, &bits),
        );
        let step = factor.value(&z, bits) / factor.slope(&z, bits);
        let mut bound = largest(step.re())? + largest(step.im())?;
        bound *= count::to_u64(factor.degree());
        if !bound.is_zero() {
            bound = times_power_of_two(Rational::from(1), log2_above(&bound));
        }
        let step = Step {
            re: step.re().0.midpoint_rational()?,
            im: step.im().0.midpoint_rational()?,
        };
        let disc = Disc {
            re,
            im,
            radius: bound,
        };
        Some((disc, step))
    }

    /// The larger of the distances of the centers along the axes.
    pub fn distance(&self, other: &Disc) -> Rational {
        let re = Rational::from(&self.re - &other.re).abs();
        let im = Rational::from(&self.im - &other.im).abs();
        re.max(im)
    }

    pub fn conjugate(&self) -> Disc {
        let mut result = self.clone();
        result.im = Rational::from(-&self.im);
        result
    }

    /// Whether the squares around the discs have a point in common.
    pub fn touches(&self, other: &Disc) -> bool {
        self.distance(other) <= Rational::from(&self.radius + &other.radius)
    }

    fn holds(&self, other: &Disc) -> bool {
        let gap = Rational::from(&self.radius - &other.radius);
        let re = Rational::from(&self.re - &other.re);
        let im = Rational::from(&self.im - &other.im);
        gap.cmp0().is_ge() && re.square() + im.square() <= gap.square()
    }

    /// A lower bound of log₂(|z| / radius).
    fn relative_bits(&self) -> i64 {
        let size = self.re.clone().abs().max(self.im.clone().abs());
        let nearest = size - &self.radius;
        if nearest.cmp0().is_le() {
            return i64::MIN / 4;
        }
        if self.radius.is_zero() {
            return i64::MAX;
        }
        log2_below(&nearest) - log2_above(&self.radius)
    }
}

/// A Newton step, to be subtracted.
pub(super) struct Step {
    re: Rational,
    im: Rational,
}

impl ComplexRoot {
    pub(super) fn new(factor: Arc<Factor>, disc: Disc, multiplicity: usize) -> Self {
        ComplexRoot {
            factor,
            disc,
            multiplicity,
        }
    }

    /// How often the polynomial vanishes there, at least 1.
    pub fn multiplicity(&self) -> usize {
        self.multiplicity
    }

    /// The square around the isolating disc, of so many bits at most as its center needs.
    pub fn isolating(&self) -> Number<Complex<Ball>> {
        let bits = |q: &Rational| q.numer().significant_bits();
        square(
            &self.disc,
            bits(&self.disc.re).max(bits(&self.disc.im)).max(2),
        )
    }

    pub(super) fn disc(&self) -> &Disc {
        &self.disc
    }

    /// Balls around the real and the imaginary part, each with a radius of at most 2^−bits |root|.
    pub fn enclosure(&self, bits: u32) -> Number<Complex<Ball>> {
        if let Some(found) = self.leap(bits) {
            return found;
        }
        let mut root = self.clone();
        root.refine(bits.saturating_add(2));
        square(&root.disc, bits.saturating_add(8))
    }

    /// Newton's method without proof to half of the bits, a proof there, and one step more; `None`
    /// where that does not work out.
    fn leap(&self, bits: u32) -> Option<Number<Complex<Ball>>> {
        let disc = &self.disc;
        let known = disc.relative_bits().clamp(0, i64::from(bits));
        let known = u32::try_from(known).ok()?;
        let start = Point {
            re: Float::with_val(known + GUARD_BITS, &disc.re),
            im: Float::with_val(known + GUARD_BITS, &disc.im),
        };
        let half = half(bits.checked_add(16)?);
        let near = self.factor.approximate().root(start, known, half);
        if !near.is_finite() {
            return None;
        }
        let whole = self.factor.in_balls(bits.checked_add(16 + GUARD_BITS)?);
        let slopes = [FEW_BITS, half].map(|bits| self.factor.slope_in_balls(bits));
        let root = root_near(&whole, &slopes, &near)?;
        let wide = known + GUARD_BITS;
        let ball = |part: &Rational| Number::<Ball>::rounded(part, &wide);
        let x = Number(root.re().0.with_precision(wide)) - ball(&disc.re);
        let y = Number(root.im().0.with_precision(wide)) - ball(&disc.im);
        let inside = (ball(&disc.radius).square() - x.square() - y.square()).is_positive();
        if !inside.is_yes() {
            return None;
        }
        let size = i64::from(near.re.get_exp().max(near.im.get_exp())?) - 1;
        let spread = root.re().0.spread()?.max(root.im().0.spread()?);
        let bits = bits.saturating_add(8);
        (spread < size - i64::from(bits) + 7).then(|| {
            let rounded = |x: &Number<Ball>| Number(x.0.with_precision(bits));
            Number::complex(rounded(root.re()), rounded(root.im()))
        })
    }

    /// Narrows the isolating disc to a radius of at most 2^−bits |root|.
    ///
    /// Newton's method converges quadratically from the disc's center, for isolation went on until
    /// all other roots were 4n radii away. A smaller disc inside the old one that surely has a root
    /// has this one.
    pub fn refine(&mut self, bits: u32) {
        let aim = i64::from(bits);
        let mut extra = 0;
        let (mut re, mut im) = (self.disc.re.clone(), self.disc.im.clone());
        while self.disc.relative_bits() < aim {
            let before = self.disc.relative_bits();
            let accurate = (2 * before.max(16)).min(aim + 8);
            let precision = u32::try_from(accurate).unwrap_or(0) + GUARD_BITS + extra;
            let next = Disc::around(&self.factor, re.clone(), im.clone(), precision);
            if let Some((disc, step)) = next {
                // The step is short, so that its error is far below the last place of the sum.
                re = rounded(&(re - step.re), 2 * precision);
                im = rounded(&(im - step.im), 2 * precision);
                if self.disc.holds(&disc) {
                    self.disc = disc;
                }
            }
            if self.disc.relative_bits() <= before + 1 {
                extra = 2 * extra + GUARD_BITS;
            }
        }
    }
}

/// The square around a disc.
fn square(disc: &Disc, bits: u32) -> Number<Complex<Ball>> {
    let part = |mid: &Rational| Number(Ball::with_radius(mid, &disc.radius, bits));
    Number::complex(part(&disc.re), part(&disc.im))
}

fn largest(ball: &Number<Ball>) -> Option<Rational> {
    Some(ball.0.lower()?.abs().max(ball.0.upper()?.abs()))
}

/// A point near by of so many bits: which one does not matter.
pub(super) fn rounded(q: &Rational, bits: u32) -> Rational {
    Ball::rounded(q, &bits)
        .midpoint_rational()
        .unwrap_or_else(|| q.clone())
}
