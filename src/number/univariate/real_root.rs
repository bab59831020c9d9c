//! [`RealRoot`]: an isolating interval that can be narrowed without end.

use std::cmp::Ordering;
use std::sync::Arc;

use rug::{Float, Integer, Rational};

use super::descartes::Interval;
use super::factor::{Factor, log2_above, log2_below};
use super::modular;
use super::point::Point;
use super::proof::{FEW_BITS, half, root_near};
use crate::number::{Ball, Number};

/// Bits that Newton's method works with beyond the accuracy that it aims at.
const GUARD_BITS: u32 = 64;

/// A real root of a polynomial over ℚ, with its multiplicity and an interval that holds no other
/// root.
#[derive(Clone, Debug)]
pub struct RealRoot {
    factor: Arc<Factor>,
    interval: Interval,
    /// The sign of the factor at the lower end; equal for a root known exactly.
    sign_below: Ordering,
    multiplicity: usize,
}

impl RealRoot {
    pub(super) fn new(factor: Arc<Factor>, interval: Interval, multiplicity: usize) -> Self {
        let sign_below = if interval.is_point() {
            Ordering::Equal
        } else {
            factor.sign_at(&interval.low)
        };
        RealRoot {
            factor,
            interval,
            sign_below,
            multiplicity,
        }
    }

    /// Whether the root was found as one of this factor.
    pub(super) fn is_of(&self, factor: &Arc<Factor>) -> bool {
        Arc::ptr_eq(&self.factor, factor)
    }

    /// How often the polynomial vanishes there, at least 1.
    pub fn multiplicity(&self) -> usize {
        self.multiplicity
    }

    /// The lower end of the isolating interval.
    pub fn low(&self) -> &Rational {
        &self.interval.low
    }

    /// The upper end of the isolating interval; equal to the lower one where the root is known
    /// exactly, else neither end is a root.
    pub fn high(&self) -> &Rational {
        &self.interval.high
    }

    /// The root itself, where isolation hit upon it. [`rational`](Self::rational) decides whether
    /// it is rational.
    pub fn exact(&self) -> Option<&Rational> {
        self.interval.is_point().then_some(&self.interval.low)
    }

    /// The root itself, where it is rational.
    ///
    /// Its denominator divides the leading coefficient, so that an interval shorter than the
    /// inverse of that holds one candidate at most.
    pub fn rational(&self) -> Option<Rational> {
        if self.exact().is_none() && modular::has_surely_no_rational_root(self.factor.polynomial())
        {
            return None;
        }
        let leading = self.factor.polynomial().leading();
        let mut root = self.clone();
        let bits = i64::from(leading.significant_bits()) + 1;
        root.narrow_to(|interval| log2_above(&interval.width()) <= -bits, |_| bits);
        if let Some(exact) = root.exact() {
            return Some(exact.clone());
        }
        let (_, candidate) = Rational::from(root.high() * &leading).fract_floor(Integer::new());
        let candidate = Rational::from((candidate, leading));
        let inside = candidate > *root.low();
        (inside && self.factor.polynomial().sign_at(&candidate).is_eq()).then_some(candidate)
    }

    /// The order of the root and a rational number, decided exactly.
    pub fn compare(&self, x: &Rational) -> Ordering {
        if x < self.low() {
            Ordering::Greater
        } else if x > self.high() {
            Ordering::Less
        } else if self.interval.is_point() {
            Ordering::Equal
        } else {
            match self.factor.sign_at(x) {
                Ordering::Equal => Ordering::Equal,
                sign if sign == self.sign_below => Ordering::Greater,
                _ => Ordering::Less,
            }
        }
    }

    /// The sign of the root.
    pub fn sign(&self) -> Ordering {
        self.compare(&Rational::new())
    }

    /// A ball around the root with a radius of at most 2^−bits |root|; of radius 0 for the root 0.
    pub fn enclosure(&self, bits: u32) -> Number<Ball> {
        if let Some(ball) = self.leap(bits) {
            return Number(ball);
        }
        let mut root = self.clone();
        root.refine(bits);
        // Rounding the midpoint costs less than the interval does.
        let precision = bits.saturating_add(8);
        let interval = &root.interval;
        if interval.is_point() {
            return Number::rounded(&interval.low, &precision);
        }
        let radius = interval.width() >> 1;
        Number(Ball::with_radius(&interval.middle(), &radius, precision))
    }

    /// Newton's method without proof to half of the bits, a proof there, and one step more; `None`
    /// where that does not work out.
    fn leap(&self, bits: u32) -> Option<Ball> {
        // Where 0 is inside, the size of the root is not known.
        if self.interval.is_point() || self.interval.low.cmp0() != self.interval.high.cmp0() {
            return None;
        }
        let known = relative_bits(&self.interval).clamp(0, i64::from(bits));
        let known = u32::try_from(known).ok()?;
        let start = Float::with_val(known + GUARD_BITS, self.interval.middle());
        let half = half(bits.checked_add(16)?);
        let start = Point {
            re: start,
            im: Float::new(2),
        };
        let near = self.factor.approximate().root(start, known, half);
        if !near.is_finite() {
            return None;
        }
        let whole = self.factor.in_balls(bits.checked_add(16 + GUARD_BITS)?);
        let slopes = [FEW_BITS, half].map(|bits| self.factor.slope_in_balls(bits));
        let root = root_near(&whole, &slopes, &near)?;
        let size = magnitude(&self.interval);
        let wide = known + GUARD_BITS;
        let rough = Number(root.re().0.with_precision(wide));
        let [low, high] = [&self.interval.low, &self.interval.high]
            .map(|end| &rough - Number::<Ball>::rounded(end, &wide));
        if !low.is_positive().is_yes() || !(-high).is_positive().is_yes() {
            return None;
        }
        let ball = root.0.re.0;
        let is_small = ball.spread()? < size - i64::from(bits);
        is_small.then(|| ball.with_precision(bits.saturating_add(8)))
    }

    /// Narrows the isolating interval to a width of at most 2^−bits |root|.
    pub fn refine(&mut self, bits: u32) {
        let bits = i64::from(bits);
        self.narrow_to(
            |interval| relative_bits(interval) >= bits,
            |interval| bits - magnitude(interval),
        );
    }

    /// Halves the interval at least.
    pub(super) fn bisect(&mut self) {
        if self.interval.is_point() {
            return;
        }
        let middle = self.interval.middle();
        match self.factor.sign_at(&middle) {
            Ordering::Equal => self.set_exact(middle),
            sign if sign == self.sign_below => self.interval.low = middle,
            _ => self.interval.high = middle,
        }
    }

    /// Interval Newton with growing precision, and bisection where that does not contract. `aim`
    /// tells for an interval how many bits after the point will do.
    fn narrow_to(&mut self, done: impl Fn(&Interval) -> bool, aim: impl Fn(&Interval) -> i64) {
        let mut extra = 0;
        while !self.interval.is_point() && !done(&self.interval) {
            let before = log2_below(&self.interval.width());
            // Slow progress alone does not call for precision: it would grow without bounds.
            if self.newton(aim(&self.interval), extra) {
                extra = 2 * extra + GUARD_BITS;
            }
            if log2_above(&self.interval.width()) >= before - 1 {
                self.bisect();
            }
        }
    }

    /// Intersects the interval with a Newton step; whether that suffered from rounding.
    fn newton(&mut self, aim: i64, extra: u32) -> bool {
        let width = self.interval.width();
        let middle = self.interval.middle();
        let accuracy = -log2_below(&width);
        // The number of accurate bits doubles at best.
        let after_point = (2 * accuracy).max(accuracy + 16).min(aim.max(accuracy) + 8);
        let size = log2_above(&middle.clone().abs()).max(-after_point);
        let bits = u32::try_from(after_point + size).unwrap_or(0) + GUARD_BITS + extra;
        let around = Number(Ball::with_radius(&middle, &(width >> 1), bits));
        let step = self.factor.newton(&middle, &around, bits);
        if let Some(ball) = step.ball
            && let (Some(mid), Some(radius)) = (ball.midpoint_rational(), ball.radius_rational())
        {
            self.cut_to(&mid, &radius);
        }
        step.is_noise
    }

    /// Narrows the interval to a ball that holds the root, made twice as large: so its ends are no
    /// roots, and no sign has to be computed.
    fn cut_to(&mut self, mid: &Rational, radius: &Rational) {
        if radius.is_zero() {
            self.set_exact(mid.clone());
            return;
        }
        let margin = Rational::from(radius << 1);
        let low = Rational::from(mid - &margin);
        if low > self.interval.low {
            self.interval.low = low;
        }
        let high = Rational::from(mid + &margin);
        if high < self.interval.high {
            self.interval.high = high;
        }
    }

    fn set_exact(&mut self, root: Rational) {
        self.interval.low.clone_from(&root);
        self.interval.high = root;
        self.sign_below = Ordering::Equal;
    }
}

/// A lower bound of log₂(|root| / width); of no meaning, but small, where 0 is inside.
fn relative_bits(interval: &Interval) -> i64 {
    magnitude(interval).saturating_sub(log2_above(&interval.width()))
}

/// A lower bound of log₂ |x| in the interval.
fn magnitude(interval: &Interval) -> i64 {
    let straddles = interval.low.cmp0() != interval.high.cmp0();
    if straddles {
        return log2_below(&interval.width()) - 16;
    }
    let nearer = if interval.low.cmp0().is_lt() {
        &interval.high
    } else {
        &interval.low
    };
    log2_below(&nearer.clone().abs())
}
