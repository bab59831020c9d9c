//! The radius of a ball: a short float that is never rounded downwards.

use std::cmp::Ordering;

use gmp_mpfr_sys::gmp::limb_t;
use rug::float::Round;
use rug::{Float, Rational};

/// Beyond this exponent a radius counts as infinite, below its negative it is raised. MPFR's own
/// exponents end at 2³⁰; the limit is what an exact rational can be shifted by.
const EXPONENT_LIMIT: i64 = (1 << 31) - 64;
const TOP_BIT: u32 = 1 << 31;

/// A number ≥ 0, possibly infinite: `mantissa · 2^(exponent − 32)` with the top bit of the mantissa
/// set, so that it lies in [2^(exponent − 1), 2^exponent), as with MPFR.
///
/// The order of the fields makes the derived order the order of the values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Radius {
    exponent: i64,
    mantissa: u32,
}

impl Radius {
    pub const ZERO: Radius = Radius {
        exponent: i64::MIN,
        mantissa: 0,
    };
    pub const INFINITY: Radius = Radius {
        exponent: i64::MAX,
        mantissa: TOP_BIT,
    };
    pub const ONE: Radius = Radius {
        exponent: 1,
        mantissa: TOP_BIT,
    };

    /// 2^power.
    #[inline]
    pub fn power_of_two(power: i64) -> Radius {
        Radius::limited(TOP_BIT, power.saturating_add(1))
    }

    /// An upper bound of |x|; infinite unless `x` is finite.
    #[inline]
    pub fn above(x: &Float) -> Radius {
        match leading_bits(x) {
            Some(leading) => Radius::raised(
                u64::from(leading.mantissa) + u64::from(leading.more),
                leading.exponent,
            ),
            None if x.is_zero() => Radius::ZERO,
            None => Radius::INFINITY,
        }
    }

    /// A lower bound of |x|; 0 unless `x` is finite.
    #[inline]
    pub fn below(x: &Float) -> Radius {
        leading_bits(x).map_or(Radius::ZERO, |leading| Radius {
            exponent: leading.exponent,
            mantissa: leading.mantissa,
        })
    }

    /// An upper bound of |i|.
    #[inline]
    pub fn above_integer(i: i64) -> Radius {
        let Some((bits, exponent)) = normalized(i.unsigned_abs()) else {
            return Radius::ZERO;
        };
        Radius::raised((bits >> 32) + u64::from(bits << 32 != 0), exponent)
    }

    /// A lower bound of |i|.
    #[inline]
    pub fn below_integer(i: i64) -> Radius {
        normalized(i.unsigned_abs()).map_or(Radius::ZERO, |(bits, exponent)| Radius {
            exponent,
            mantissa: upper_half(bits),
        })
    }

    /// An upper bound of |q|.
    pub fn above_rational(q: &Rational) -> Radius {
        let (bound, _) = Float::with_val_round(32, q, Round::AwayZero);
        Radius::above(&bound)
    }

    #[inline]
    pub fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    #[inline]
    pub fn is_infinite(self) -> bool {
        self.exponent == i64::MAX
    }

    /// e with 2^(e − 1) ≤ radius < 2^e; the ends of `i64` for 0 and infinity.
    #[inline]
    pub fn exponent(self) -> i64 {
        self.exponent
    }

    /// An upper bound of the sum.
    #[inline]
    pub fn plus(self, other: Radius) -> Radius {
        let (large, small) = if self >= other {
            (self, other)
        } else {
            (other, self)
        };
        if small.is_zero() || large.is_infinite() {
            return large;
        }
        let distance = large.exponent - small.exponent;
        let shifted = if distance < 32 {
            let lost = small.mantissa & ((1u32 << distance) - 1);
            (small.mantissa >> distance) + u32::from(lost != 0)
        } else {
            1
        };
        Radius::raised(
            u64::from(large.mantissa) + u64::from(shifted),
            large.exponent,
        )
    }

    /// An upper bound of the product. Zero times infinity is infinite: nothing is known of a factor
    /// without bound, not even that it exists.
    #[inline]
    pub fn times(self, other: Radius) -> Radius {
        if self.is_infinite() || other.is_infinite() {
            return Radius::INFINITY;
        }
        if self.is_zero() || other.is_zero() {
            return Radius::ZERO;
        }
        let product = u64::from(self.mantissa) * u64::from(other.mantissa);
        let shift = product.leading_zeros();
        let product = product << shift;
        Radius::raised(
            (product >> 32) + u64::from(product << 32 != 0),
            self.exponent + other.exponent - i64::from(shift),
        )
    }

    /// An upper bound of |x| s + |y| r + r s, the error of the product of x ± r and y ± s.
    #[inline]
    pub fn of_product([x, y]: [&Float; 2], [r, s]: [Radius; 2]) -> Radius {
        if r.is_zero() && s.is_zero() {
            return Radius::ZERO;
        }
        match (Head::above(x), Head::above(y)) {
            (Some(x), Some(y)) if !r.is_infinite() && !s.is_infinite() => {
                let terms = [x.times(s), y.times(r), Head::of(r).times(s)];
                Head::sum(terms)
            }
            _ => {
                let (x, y) = (Radius::above(x), Radius::above(y));
                x.times(s).plus(y.plus(s).times(r))
            }
        }
    }

    /// An upper bound of the quotient; infinite for a divisor 0.
    #[inline]
    pub fn over(self, divisor: Radius) -> Radius {
        if self.is_infinite() || divisor.is_zero() || divisor.is_infinite() {
            return Radius::INFINITY;
        }
        if self.is_zero() {
            return Radius::ZERO;
        }
        let dividend = u64::from(self.mantissa) << 32;
        Radius::raised(
            dividend.div_ceil(u64::from(divisor.mantissa)),
            self.exponent - divisor.exponent,
        )
    }

    /// A lower bound of the difference, at least 0. The only operation that rounds downwards: it
    /// serves divisors.
    #[inline]
    pub fn minus_below(self, other: Radius) -> Radius {
        if other.is_zero() {
            return self;
        }
        if self <= other || self.is_infinite() {
            return Radius::ZERO;
        }
        let large = u64::from(self.mantissa) << 32;
        let small = u64::from(other.mantissa) << 32;
        let distance = self.exponent - other.exponent;
        // What is cut off lies below the half that is kept in the end, and so does 1.
        let shifted = if distance < 64 { small >> distance } else { 1 };
        let difference = large - shifted;
        let shift = difference.leading_zeros();
        if shift >= 64 {
            return Radius::ZERO;
        }
        Radius {
            exponent: self.exponent - i64::from(shift),
            mantissa: upper_half(difference << shift),
        }
    }

    /// This times 2^power, or more where that is out of range.
    #[inline]
    pub fn scaled(self, power: i64) -> Radius {
        if self.is_zero() || self.is_infinite() {
            self
        } else {
            Radius::limited(self.mantissa, self.exponent.saturating_add(power))
        }
    }

    /// |x| against this, exactly; `x` is finite.
    #[inline]
    pub fn compare_magnitude(self, x: &Float) -> Ordering {
        let Some(leading) = leading_bits(x) else {
            return if self.is_zero() {
                Ordering::Equal
            } else {
                Ordering::Less
            };
        };
        leading
            .exponent
            .cmp(&self.exponent)
            .then(leading.mantissa.cmp(&self.mantissa))
            .then(leading.more.cmp(&false))
    }

    /// As an MPFR number, not smaller than this; infinite where MPFR's exponents end.
    pub fn to_float(self) -> Float {
        if self.is_zero() {
            return Float::new(32);
        }
        let (least, most) = (rug::float::exp_min(), rug::float::exp_max());
        if self.exponent > i64::from(most) {
            return Float::with_val(32, rug::float::Special::Infinity);
        }
        // Raised to the least power of two where the exponent is too low.
        let (mantissa, exponent) = match i32::try_from(self.exponent) {
            Ok(exponent) if exponent >= least => (self.mantissa, exponent),
            _ => (TOP_BIT, least),
        };
        let mut float = Float::with_val(32, mantissa);
        // Exact: 2^-32 is far inside MPFR's range, and the target is inside it too.
        float >>= 32;
        float <<= exponent;
        float
    }

    /// Exactly; `None` for infinity.
    pub fn to_rational(self) -> Option<Rational> {
        if self.is_infinite() {
            return None;
        }
        if self.is_zero() {
            return Some(Rational::new());
        }
        let power = i32::try_from(self.exponent - 32).ok()?;
        Some(Rational::from(self.mantissa) << power)
    }

    /// A mantissa from 2³¹ to 2³³, rounded up to 32 bits.
    #[inline]
    fn raised(mantissa: u64, exponent: i64) -> Radius {
        if let Ok(mantissa) = u32::try_from(mantissa) {
            return Radius::limited(mantissa, exponent);
        }
        // At most 2³³; half of it, rounded up, may be 2³² once more.
        match u32::try_from(mantissa.div_ceil(2)) {
            Ok(half) => Radius::limited(half, exponent + 1),
            Err(_) => Radius::limited(TOP_BIT, exponent + 2),
        }
    }

    #[inline]
    fn limited(mantissa: u32, exponent: i64) -> Radius {
        if exponent > EXPONENT_LIMIT {
            Radius::INFINITY
        } else if exponent < -EXPONENT_LIMIT {
            Radius {
                exponent: 1 - EXPONENT_LIMIT,
                mantissa: TOP_BIT,
            }
        } else {
            Radius { exponent, mantissa }
        }
    }
}

/// At most `mantissa · 2^(exponent − 32)` with a mantissa of 33 bits, not normalized: what sums of
/// products are made of without a rounding to 32 bits each.
#[derive(Clone, Copy)]
struct Head {
    mantissa: u64,
    exponent: i64,
}

impl Head {
    const ZERO: Head = Head {
        mantissa: 0,
        exponent: i64::MIN,
    };

    #[inline]
    fn of(radius: Radius) -> Head {
        Head {
            mantissa: u64::from(radius.mantissa),
            exponent: radius.exponent,
        }
    }

    /// Not below |x|; `None` unless `x` is finite and not 0.
    #[inline]
    fn above(x: &Float) -> Option<Head> {
        let exponent = i64::from(x.get_exp()?);
        let significand = x.get_significand()?;
        let top = significand.as_limbs().last()?;
        #[expect(clippy::useless_conversion, reason = "limbs may be shorter elsewhere")]
        let mantissa = u64::from(top >> (limb_t::BITS - 32)) + 1;
        Some(Head { mantissa, exponent })
    }

    /// Not below the product with a finite radius; at least 2³⁰ unless zero.
    #[inline]
    fn times(self, radius: Radius) -> Head {
        if radius.is_zero() || self.mantissa == 0 {
            return Head::ZERO;
        }
        // At most 2³² (2³² − 1).
        let product = self.mantissa * u64::from(radius.mantissa);
        Head {
            mantissa: (product >> 32) + 1,
            exponent: self.exponent + radius.exponent,
        }
    }

    /// Not below the sum of three products, one of which is not zero.
    #[inline]
    fn sum(terms: [Head; 3]) -> Radius {
        let [a, b, c] = terms;
        let exponent = a.exponent.max(b.exponent).max(c.exponent);
        let at_exponent = |term: Head| match exponent.saturating_sub(term.exponent) {
            0 => term.mantissa,
            distance @ 1..40 => (term.mantissa >> distance) + 1,
            _ => u64::from(term.mantissa != 0),
        };
        // More than 2³⁰, less than 2³⁴.
        let sum = at_exponent(a) + at_exponent(b) + at_exponent(c);
        if sum < u64::from(TOP_BIT) {
            Radius::raised(sum << 1, exponent - 1)
        } else if sum > 1 << 33 {
            Radius::raised((sum >> 1) + 1, exponent + 1)
        } else {
            Radius::raised(sum, exponent)
        }
    }
}

/// The first 32 bits of |x|, as in [`Radius`], and whether there are more bits that are not 0.
struct Leading {
    exponent: i64,
    mantissa: u32,
    more: bool,
}

#[inline]
fn upper_half(bits: u64) -> u32 {
    #[expect(clippy::as_conversions, reason = "what is left has 32 bits")]
    {
        (bits >> 32) as u32
    }
}

/// `None` unless `x` is finite and not 0.
#[inline]
fn leading_bits(x: &Float) -> Option<Leading> {
    let exponent = i64::from(x.get_exp()?);
    let significand = x.get_significand()?;
    let (top, rest) = significand.as_limbs().split_last()?;
    // MPFR keeps the top bit of the top limb set.
    let surplus = limb_t::BITS - 32;
    let mantissa = u32::try_from(top >> surplus).ok()?;
    let lost = top ^ (limb_t::from(mantissa) << surplus);
    Some(Leading {
        exponent,
        mantissa,
        more: lost != 0 || rest.iter().any(|&limb| limb != 0),
    })
}

/// The bits of `i` shifted to the top, and e with 2^(e − 1) ≤ i < 2^e.
#[inline]
fn normalized(i: u64) -> Option<(u64, i64)> {
    let zeros = i.leading_zeros();
    (zeros < 64).then(|| (i << zeros, 64 - i64::from(zeros)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples() -> Vec<Radius> {
        let mantissas = [TOP_BIT, TOP_BIT + 1, 0xAAAA_AAAB, u32::MAX - 1, u32::MAX];
        let exponents = [-100, -33, -32, -31, -1, 0, 1, 2, 31, 32, 33, 64];
        let mut all = vec![Radius::ZERO];
        for mantissa in mantissas {
            for exponent in exponents {
                all.push(Radius { exponent, mantissa });
            }
        }
        all
    }

    fn exact(radius: Radius) -> Rational {
        radius.to_rational().unwrap()
    }

    /// Relative excess that rounding up twice may cause.
    fn nearly(bound: &Rational) -> Rational {
        bound + Rational::from(bound >> 29)
    }

    #[test]
    fn operations_round_up_and_not_far() {
        for a in samples() {
            for b in samples() {
                let (x, y) = (exact(a), exact(b));
                let sum = Rational::from(&x + &y);
                assert!(exact(a.plus(b)) >= sum && exact(a.plus(b)) <= nearly(&sum));
                let product = Rational::from(&x * &y);
                assert!(exact(a.times(b)) >= product && exact(a.times(b)) <= nearly(&product));
                if !b.is_zero() {
                    let quotient = Rational::from(&x / &y);
                    assert!(exact(a.over(b)) >= quotient && exact(a.over(b)) <= nearly(&quotient));
                }
                let difference = Rational::from(&x - &y).max(Rational::new());
                let below = exact(a.minus_below(b));
                let lost = Rational::from(&x >> 60);
                assert!(below <= difference && nearly(&below) + lost >= difference);
                assert_eq!(a.cmp(&b), x.cmp(&y));
                assert_eq!(b.compare_magnitude(&a.to_float()), x.cmp(&y));
            }
        }
    }

    #[test]
    fn sums_of_heads_are_bounded_and_not_far() {
        let heads = [0, 1 << 31, (1 << 31) + 1, u64::from(u32::MAX), 1 << 32];
        let distances = [0, -1, -7, -39, -40, -90];
        for [a, b, c] in heads
            .iter()
            .flat_map(|a| heads.iter().flat_map(move |b| heads.map(|c| [*a, *b, c])))
        {
            for [d, e] in distances.iter().flat_map(|d| distances.map(|e| [*d, e])) {
                let terms = [(a, 0), (b, d), (c, e)];
                if a == 0 {
                    continue;
                }
                let exact: Rational = terms
                    .iter()
                    .map(|(mantissa, exponent)| Rational::from(*mantissa) << (exponent - 32))
                    .sum();
                let bound = Head::sum(terms.map(|(mantissa, exponent)| Head {
                    mantissa,
                    exponent: i64::from(exponent),
                }));
                let bound = bound.to_rational().unwrap();
                assert!(bound >= exact && bound <= Rational::from(&exact >> 27) + &exact);
            }
        }
    }

    #[test]
    fn the_error_of_a_product_is_bounded_and_not_far() {
        let few: Vec<Radius> = samples().into_iter().step_by(5).collect();
        let mids = [0.0, 1.0, -1.0, 1.999_999, -0.3, 3e20, 5e-300];
        for (x, y) in mids.iter().flat_map(|x| mids.map(|y| (*x, y))) {
            let [x, y] = [x, y].map(|mid| Float::with_val(200, mid) / 7u32);
            let [a, b] = [&x, &y].map(|mid| mid.to_rational().unwrap().abs());
            for (r, s) in few.iter().flat_map(|r| few.iter().map(|s| (*r, *s))) {
                let error = &a * exact(s) + exact(r) * (&b + exact(s));
                let bound = exact(Radius::of_product([&x, &y], [r, s]));
                assert!(bound >= error && bound <= Rational::from(&error >> 27) + &error);
            }
        }
    }

    #[test]
    fn conversions_bound_on_both_sides() {
        for a in samples() {
            assert_eq!(a.to_float().to_rational().unwrap(), exact(a));
            assert_eq!(Radius::above_rational(&exact(a)), a);
        }
        for i in [0, 1, -1, 3, 1 << 40, (1 << 40) + 1, i64::MAX, i64::MIN] {
            let magnitude = Rational::from(i).abs();
            assert!(exact(Radius::above_integer(i)) >= magnitude);
            assert!(exact(Radius::below_integer(i)) <= magnitude);
        }
    }

    #[test]
    fn ends_of_the_exponent_stay_on_the_safe_side() {
        let tiny = Radius::power_of_two(-EXPONENT_LIMIT);
        assert!(!tiny.times(tiny).is_zero());
        assert!(tiny.times(tiny).to_rational().is_some());
        let huge = Radius::power_of_two(EXPONENT_LIMIT - 1);
        assert!(huge.times(huge).is_infinite());
        assert!(huge.to_float().is_infinite());
        assert!(tiny.to_float() > 0);
        assert!(Radius::ZERO.times(Radius::INFINITY).is_infinite());
    }
}
