//! All zeros of a real function on an interval, by enclosures.
//!
//! The function is evaluated on whole intervals, as a series: the first coefficients at the middle m and
//! one more over the whole interval X enclose its values and those of its derivative,
//! f(X) ⊂ Σ fⱼ(m)(X − m)ʲ + fₙ(X)(X − m)ⁿ. An interval on which the values miss zero, or on which the
//! function is not real, holds no zero. Where the derivative misses zero, Newton's interval
//! N(X) = m − f(m)/f'(X) decides: inside of X it holds the only zero of X, beside X there is none. All
//! else is cut in two, up to a limit; what is left then is told and not guessed.

use rug::Rational;

use super::{Ball, Number, Series, count};

/// Bits while zeros are being separated.
const BITS: u32 = 96;
/// Intervals narrower than the whole by this power of two are not halved any more.
const DEPTH: u32 = 34;
/// So many intervals are looked at.
const MOST_INTERVALS: usize = 40_000;

/// A function of one variable at whole intervals, as a series: given x + t, its coefficients at x, to
/// the order of t. It has no value where it is not real for any x of the interval.
pub trait Function: Fn(&Number<Series<Ball>>) -> Number<Series<Ball>> {}
impl<F: Fn(&Number<Series<Ball>>) -> Number<Series<Ball>>> Function for F {}

/// The zeros of a function on an interval.
#[derive(Clone, Debug, Default)]
pub struct Zeros {
    /// Each alone in its interval, in ascending order.
    pub isolated: Vec<Zero>,
    /// Where neither a zero was found nor its absence shown: double zeros, and ends of the range in
    /// which the function is real.
    pub unresolved: Vec<[Rational; 2]>,
}

/// A simple zero, the only one between two numbers.
#[derive(Clone, Debug)]
pub struct Zero {
    interval: Interval,
    order: usize,
}

#[derive(Clone, Debug)]
struct Interval {
    from: Rational,
    to: Rational,
}

/// What is known of an interval.
enum Found {
    Nothing,
    Zero(Interval),
    Unknown,
}

/// All zeros of `f` from `from` to `to`, by series of order n, from 1 on: the higher, the wider the
/// intervals on which a function that touches zero closely is told apart from it, and the longer each
/// takes.
pub fn zeros(f: &impl Function, order: usize, from: &Rational, to: &Rational) -> Zeros {
    search(f, order, from, to, false)
}

/// The first zero of `f` from `from` on, if there is one up to `to`. Where something is left
/// unresolved before it, that alone.
pub fn first_zero(f: &impl Function, order: usize, from: &Rational, to: &Rational) -> Zeros {
    search(f, order, from, to, true)
}

/// From left to right.
fn search(
    f: &impl Function,
    order: usize,
    from: &Rational,
    to: &Rational,
    first_alone: bool,
) -> Zeros {
    let mut found = Zeros::default();
    let least = Rational::from(to - from) >> DEPTH;
    let mut left = vec![Interval::new(from.clone(), to.clone())];
    let mut looked_at = 0;
    while let Some(interval) = left.pop() {
        looked_at += 1;
        match interval.look(f, order) {
            Found::Nothing => {}
            Found::Zero(within) => {
                let zero = Zero {
                    interval: within,
                    order,
                };
                found.add(zero, f, from, to);
            }
            Found::Unknown if interval.width() > least && looked_at < MOST_INTERVALS => {
                let [low, high] = interval.parts();
                left.extend([high, low]);
            }
            Found::Unknown => found.leave(interval),
        }
        if first_alone && !(found.isolated.is_empty() && found.unresolved.is_empty()) {
            break;
        }
    }
    found
}

impl Zeros {
    /// An interval may be found to hold a zero that its neighbour has already.
    fn add(&mut self, zero: Zero, f: &impl Function, from: &Rational, to: &Rational) {
        let at = zero.ball(f, BITS);
        let (Some(low), Some(high)) = (at.lower(), at.upper()) else {
            return self.leave(zero.interval);
        };
        let outside = high < *from || low > *to;
        let known = self
            .isolated
            .last()
            .is_some_and(|last| last.interval.from <= low && high <= last.interval.to);
        if !outside && !known {
            self.isolated.push(zero);
        }
    }

    fn leave(&mut self, interval: Interval) {
        match self.unresolved.last_mut() {
            Some([_, to]) if *to == interval.from => *to = interval.to,
            _ => self.unresolved.push([interval.from, interval.to]),
        }
    }
}

impl Zero {
    /// The zero to about so many bits.
    pub fn ball(&self, f: &impl Function, bits: u32) -> Ball {
        let mut interval = self.interval.clone();
        let mut precision = BITS.min(bits);
        loop {
            let Some(next) = interval
                .newton(f, self.order, precision)
                .and_then(|newton| newton.intersect(&interval))
            else {
                break;
            };
            let settled = next.width() * 4u32 >= interval.width() * 3u32;
            interval = next;
            if settled {
                if precision == bits {
                    break;
                }
                precision = precision.saturating_mul(2).min(bits);
            }
        }
        interval.ball(bits)
    }
}

impl Interval {
    fn new(from: Rational, to: Rational) -> Self {
        Interval { from, to }
    }

    fn width(&self) -> Rational {
        Rational::from(&self.to - &self.from)
    }

    fn middle(&self) -> Rational {
        Rational::from(&self.from + &self.to) / 2
    }

    /// Two parts; not halves, since zeros like to be at round numbers.
    fn parts(self) -> [Interval; 2] {
        let cut = self.width() * Rational::from((237, 487)) + &self.from;
        [
            Interval::new(self.from, cut.clone()),
            Interval::new(cut, self.to),
        ]
    }

    /// A quarter longer on both sides.
    fn widened(&self) -> Interval {
        let more = self.width() / 4;
        Interval::new(
            Rational::from(&self.from - &more),
            Rational::from(&self.to + &more),
        )
    }

    fn intersect(&self, other: &Interval) -> Option<Interval> {
        let from = self.from.clone().max(other.from.clone());
        let to = self.to.clone().min(other.to.clone());
        (from <= to).then(|| Interval::new(from, to))
    }

    fn ball(&self, bits: u32) -> Ball {
        Ball::with_radius(&self.middle(), &(self.width() / 2), bits)
    }

    /// x + t for all x of the interval, to terms in tⁿ.
    fn variable(&self, order: usize, bits: u32) -> Number<Series<Ball>> {
        Number::from_coefficients([Number(self.ball(bits)), Number::one()], order)
    }

    /// What the function does on the interval; `None` where it is not real, or surely not zero.
    fn image(&self, f: &impl Function, order: usize, bits: u32) -> Option<Image> {
        let over_all = f(&self.variable(order, bits));
        let value = over_all.coefficient(0);
        (value.has_value() && !value.is_zero().is_no()).then_some(())?;
        // Short numbers keep the rational ends short.
        let middle = Ball::with_radius(&self.middle(), &Rational::new(), bits);
        let middle = Number(middle);
        let variable = Number::from_coefficients([middle.clone(), Number::one()], order);
        let around = f(&variable);
        let step = Number(self.ball(bits)) - &middle;
        let last = over_all.coefficient(order);
        let terms = |derived: bool| -> Number<Ball> {
            // Horner, from the term over the whole interval down.
            let factor = |j: usize| if derived { count::to_i64(j) } else { 1 };
            let start = factor(order) * &last;
            let lowest = usize::from(derived);
            let add = |sum: Number<Ball>, j: usize| sum * &step + factor(j) * around.coefficient(j);
            (lowest..order).rev().fold(start, add)
        };
        (!terms(false).is_zero().is_no()).then_some(())?;
        Some(Image {
            slope: terms(true),
            at_middle: around.coefficient(0),
            middle,
        })
    }

    /// N(X); `None` where the derivative may vanish.
    fn newton(&self, f: &impl Function, order: usize, bits: u32) -> Option<Interval> {
        self.image(f, order, bits)?.newton()
    }

    fn look(&self, f: &impl Function, order: usize) -> Found {
        let Some(image) = self.image(f, order, BITS) else {
            return Found::Nothing;
        };
        match image.newton() {
            None => return Found::Unknown,
            Some(newton) if newton.intersect(self).is_none() => return Found::Nothing,
            Some(_) => {}
        }
        let wide = self.widened();
        match wide.newton(f, order, BITS) {
            Some(newton) if wide.from < newton.from && newton.to < wide.to => Found::Zero(wide),
            _ => Found::Unknown,
        }
    }
}

/// A function on an interval.
struct Image {
    /// All values of the derivative.
    slope: Number<Ball>,
    /// The middle of the interval.
    middle: Number<Ball>,
    /// The value there.
    at_middle: Number<Ball>,
}

impl Image {
    fn newton(&self) -> Option<Interval> {
        self.slope.is_zero().is_no().then_some(())?;
        let next = &self.middle - &self.at_middle / &self.slope;
        Some(Interval::new(next.0.lower()?, next.0.upper()?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Exact;

    type S = Number<Series<Ball>>;

    fn found(f: impl Fn(&S) -> S, from: i64, to: i64) -> (Vec<f64>, usize) {
        let zeros = zeros(&f, 3, &from.into(), &to.into());
        let isolated = zeros.isolated.iter().map(|zero| {
            let ball = zero.ball(&f, 200);
            assert!(
                ball.accuracy_bits().is_none_or(|bits| bits > 150),
                "{ball:?}"
            );
            ball.midpoint_rational().map_or(f64::NAN, |q| q.to_f64())
        });
        (isolated.collect(), zeros.unresolved.len())
    }

    fn is(found: &[f64], expected: &[f64]) -> bool {
        found.len() == expected.len()
            && found
                .iter()
                .zip(expected)
                .all(|(a, b)| (a - b).abs() < 1e-12)
    }

    #[test]
    fn all_zeros_of_a_polynomial() {
        let (zeros, unresolved) = found(|x| (x.square() - 2) * (x - 1) * (x + 3), -5, 5);
        let root = 2f64.sqrt();
        assert!(is(&zeros, &[-3.0, -root, 1.0, root]), "{zeros:?}");
        assert_eq!(unresolved, 0);
    }

    #[test]
    fn a_double_zero_is_left_open_and_a_near_miss_is_none() {
        let double = |x: &S| (x - 1).square() * (x - 2);
        assert!(is(&found(double, 0, 3).0, &[2.0]));
        assert_eq!(found(double, 0, 3).1, 1);
        let missed = |x: &S| x.square() + Number::ratio(1, 1_000_000);
        assert_eq!(found(missed, -1, 1), (vec![], 0));
    }

    #[test]
    fn where_the_function_is_not_real_there_is_none() {
        // √(x − 1) − 1/2 from 0 on: the slope at 1 is infinite, the value there is not 0.
        let f = |x: &S| (x - 1).sqrt() - Number::ratio(1, 2);
        let (zeros, unresolved) = found(f, 0, 3);
        assert!(
            is(&zeros, &[1.25]) && unresolved == 0,
            "{zeros:?} {unresolved}"
        );
    }

    #[test]
    fn a_zero_at_the_end_or_at_a_cut_is_found_once() {
        assert!(is(&found(|x| x.clone(), 0, 1).0, &[0.0]));
        let cut = Number::<Exact>::ratio(237, 487).0;
        let cut = cut.rational().cloned().unwrap_or_default();
        let at_cut = move |x: &S| x.square() - S::from(cut.clone()).square();
        assert_eq!(found(at_cut, 0, 1).0.len(), 1);
    }

    #[test]
    fn a_pole_is_no_zero() {
        let (zeros, unresolved) = found(|x| 1 / x - 3, -1, 1);
        assert!(is(&zeros, &[1.0 / 3.0]), "{zeros:?}");
        assert!(unresolved <= 1);
    }
}
