//! Balls as a number kind.

use std::cmp::Ordering;

use rug::Rational;

use super::constant::Constant;
use super::enclosure::{Enclosure, sane_precision};
use super::{Ball, Content, angle};
use crate::number::exact::bits;
use crate::number::kind::EXCESSIVE_BITS;
use crate::number::{Elementary, Kind, Real, Truth};

/// One of the four operations, on every pair of contents.
struct Operation {
    constants: fn(&mut Constant, &Constant),
    with_integer: fn(&mut Enclosure, i64),
    /// An integer on the left.
    of_integer: fn(i64, &Enclosure) -> Enclosure,
    enclosures: fn(&mut Enclosure, &Enclosure),
    /// The same into a new enclosure.
    fresh: fn(&Enclosure, &Enclosure) -> Enclosure,
}

const ADD: Operation = Operation {
    constants: Constant::add,
    with_integer: Enclosure::add_integer,
    of_integer: |i, x| {
        let mut sum = x.clone();
        sum.add_integer(i);
        sum
    },
    enclosures: Enclosure::add,
    fresh: Enclosure::sum,
};

const SUB: Operation = Operation {
    constants: Constant::sub,
    with_integer: Enclosure::sub_integer,
    of_integer: |i, x| {
        let mut difference = x.clone();
        difference.sub_integer(i);
        difference.negate();
        difference
    },
    enclosures: Enclosure::sub,
    fresh: Enclosure::difference,
};

const MUL: Operation = Operation {
    constants: Constant::mul,
    with_integer: Enclosure::mul_integer,
    of_integer: |i, x| {
        let mut product = x.clone();
        product.mul_integer(i);
        product
    },
    enclosures: Enclosure::mul,
    fresh: Enclosure::product,
};

const DIV: Operation = Operation {
    constants: Constant::div,
    with_integer: Enclosure::div_integer,
    of_integer: Enclosure::inverse_times,
    enclosures: Enclosure::div,
    fresh: |a, b| {
        let mut quotient = a.clone();
        quotient.div(b);
        quotient
    },
};

impl Ball {
    /// Into `self`.
    #[inline(always)]
    fn combine(&mut self, other: &Ball, operation: &Operation) {
        match (&mut self.0, &other.0) {
            (Content::Enclosure(a), Content::Enclosure(b)) => (operation.enclosures)(a, b),
            (Content::Enclosure(a), Content::Constant(Constant::Integer(b))) => {
                (operation.with_integer)(a, *b);
            }
            (Content::Enclosure(a), Content::Constant(b)) => {
                (operation.enclosures)(a, &Enclosure::operand(b, a.precision()));
            }
            (Content::Constant(a), Content::Constant(b)) => (operation.constants)(a, b),
            (Content::Constant(_), Content::Enclosure(_)) => {
                *self = self.combined(other, operation);
            }
            (Content::NoValue, _) => {}
            (_, Content::NoValue) => *self = Ball::NO_VALUE,
        }
    }

    /// Into a new ball.
    #[inline(always)]
    fn combined(&self, other: &Ball, operation: &Operation) -> Ball {
        match (&self.0, &other.0) {
            (Content::Enclosure(a), Content::Enclosure(b)) => (operation.fresh)(a, b).into(),
            (Content::Constant(Constant::Integer(a)), Content::Enclosure(b)) => {
                (operation.of_integer)(*a, b).into()
            }
            (Content::Constant(a), Content::Enclosure(b)) => {
                let mut result = Enclosure::from_constant(a, b.precision());
                (operation.enclosures)(&mut result, b);
                result.into()
            }
            _ => {
                let mut result = self.clone();
                result.combine(other, operation);
                result
            }
        }
    }

    /// A function that is defined everywhere; of constants it is rational only as told.
    fn apply(
        &mut self,
        of_constant: impl FnOnce(&Constant) -> Option<i64>,
        of_enclosure: impl FnOnce(&mut Enclosure),
    ) {
        self.apply_partial(of_constant, |enclosure| {
            of_enclosure(enclosure);
            Some(())
        });
    }

    /// The same, where `None` for an enclosure means that the function is defined nowhere on it.
    fn apply_partial(
        &mut self,
        of_constant: impl FnOnce(&Constant) -> Option<i64>,
        of_enclosure: impl FnOnce(&mut Enclosure) -> Option<()>,
    ) {
        match &mut self.0 {
            Content::NoValue => {}
            Content::Constant(c) => {
                *self = of_constant(c).map_or_else(Ball::nothing_known, Ball::integer);
            }
            Content::Enclosure(enclosure) => {
                if of_enclosure(enclosure).is_none() {
                    *self = Ball::NO_VALUE;
                }
            }
        }
    }

    fn is_exactly_zero(&self) -> bool {
        match &self.0 {
            Content::NoValue => false,
            Content::Constant(c) => c.is_zero(),
            Content::Enclosure(enclosure) => enclosure.is_exactly_zero(),
        }
    }

    /// Whether this is a constant outside [−1, 1].
    fn is_constant_beyond_one(&self) -> bool {
        matches!(&self.0, Content::Constant(c) if c.to_rational().cmp_abs(&Rational::from(1)).is_gt())
    }
}

/// The value of a function that is rational at `point` only, as far as constants go.
fn only_at(point: i64, value: i64) -> impl Fn(&Constant) -> Option<i64> {
    move |c| (*c == Constant::Integer(point)).then_some(value)
}

impl Kind for Ball {
    fn constant(q: Rational) -> Self {
        Constant::from(q).into()
    }

    #[inline]
    fn integer(i: i64) -> Self {
        Constant::Integer(i).into()
    }

    #[inline]
    fn add(&mut self, other: &Self) {
        self.combine(other, &ADD);
    }

    #[inline]
    fn sub(&mut self, other: &Self) {
        self.combine(other, &SUB);
    }

    #[inline]
    fn mul(&mut self, other: &Self) {
        self.combine(other, &MUL);
    }

    #[inline]
    fn div(&mut self, other: &Self) {
        if other.is_exactly_zero() {
            *self = Ball::NO_VALUE;
        } else {
            self.combine(other, &DIV);
        }
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        self.combined(other, &ADD)
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        self.combined(other, &SUB)
    }

    #[inline]
    fn times(&self, other: &Self) -> Self {
        self.combined(other, &MUL)
    }

    #[inline]
    fn over(&self, other: &Self) -> Self {
        if other.is_exactly_zero() {
            Ball::NO_VALUE
        } else {
            self.combined(other, &DIV)
        }
    }

    #[inline]
    fn negate(&mut self) {
        match &mut self.0 {
            Content::NoValue => {}
            Content::Constant(c) => c.negate(),
            Content::Enclosure(enclosure) => enclosure.negate(),
        }
    }

    fn is_zero(&self) -> Truth {
        if self.is_exactly_zero() {
            Truth::Yes
        } else if self.sign().is_some() {
            Truth::No
        } else {
            Truth::Unknown
        }
    }

    fn has_value(&self) -> bool {
        self.value_exists()
    }

    fn is_excessive(&self) -> bool {
        matches!(&self.0, Content::Constant(c) if bits(&c.to_rational()) > EXCESSIVE_BITS)
    }
}

impl Real for Ball {
    /// Bits of the midpoint; from 2 to 2³⁰, others are taken as the nearer end.
    type Precision = u32;

    fn rounded(q: &Rational, precision: &u32) -> Self {
        Enclosure::from_rational(q, sane_precision(*precision)).into()
    }

    fn sign(&self) -> Option<Ordering> {
        match &self.0 {
            Content::NoValue => None,
            Content::Constant(c) => Some(c.sign()),
            Content::Enclosure(enclosure) => enclosure.sign(),
        }
    }

    /// No value for a ball of negative numbers only; where the ball holds zero, the roots of the
    /// numbers that are not negative.
    fn sqrt(&mut self) {
        if self.sign() == Some(Ordering::Less) {
            *self = Ball::NO_VALUE;
        }
        match &mut self.0 {
            Content::NoValue => {}
            Content::Constant(c) => *self = c.sqrt().map_or_else(Ball::nothing_known, Ball::from),
            Content::Enclosure(enclosure) => enclosure.sqrt(),
        }
    }

    /// Exact for multiples of 90°, one of them exact for other multiples of 30°.
    fn cos_sin_of_degrees(q: &Rational, precision: &u32) -> Option<(Self, Self)> {
        let (cos, sin) = angle::cos_sin(q, sane_precision(*precision));
        Some((cos.into(), sin.into()))
    }
}

/// Angles beyond about 2^(65536 + 4·precision) are not reduced: sine and cosine are then only known
/// to be in [−1, 1], of the tangent nothing is known.
impl Elementary for Ball {
    fn pi(precision: &u32) -> Self {
        Enclosure::pi(sane_precision(*precision)).into()
    }

    fn sin(&mut self) {
        self.apply(only_at(0, 0), Enclosure::sin);
    }

    fn cos(&mut self) {
        self.apply(only_at(0, 1), Enclosure::cos);
    }

    /// Nothing is known where the ball may hold a pole.
    fn tan(&mut self) {
        self.apply(only_at(0, 0), Enclosure::tan);
    }

    /// No value for a ball outside [−1, 1].
    fn asin(&mut self) {
        if self.is_constant_beyond_one() {
            *self = Ball::NO_VALUE;
        }
        self.apply_partial(only_at(0, 0), Enclosure::asin);
    }

    /// No value for a ball outside [−1, 1].
    fn acos(&mut self) {
        if self.is_constant_beyond_one() {
            *self = Ball::NO_VALUE;
        }
        self.apply_partial(only_at(1, 0), Enclosure::acos);
    }

    fn atan(&mut self) {
        self.apply(only_at(0, 0), Enclosure::atan);
    }

    /// [−π, π] where the balls touch the negative x axis from below or hold the origin.
    fn atan2(&mut self, x: &Self) {
        let result = match (&self.0, &x.0) {
            (Content::NoValue, _) | (_, Content::NoValue) => Some(Ball::NO_VALUE),
            (Content::Constant(y), Content::Constant(x)) => match (y.is_zero(), x.sign()) {
                (true, Ordering::Equal) => Some(Ball::NO_VALUE),
                (true, Ordering::Greater) => Some(Ball::integer(0)),
                _ => Some(Ball::nothing_known()),
            },
            (Content::Constant(y), Content::Enclosure(x)) => {
                angle_of(Enclosure::from_constant(y, x.precision()), x)
            }
            (Content::Enclosure(y), Content::Constant(x)) => {
                angle_of(y.clone(), &Enclosure::from_constant(x, y.precision()))
            }
            (Content::Enclosure(y), Content::Enclosure(x)) => angle_of(y.clone(), x),
        };
        *self = result.unwrap_or(Ball::NO_VALUE);
    }
}

/// The angle of (x, y), `None` for the origin itself.
fn angle_of(mut y: Enclosure, x: &Enclosure) -> Option<Ball> {
    y.atan2(x)?;
    Some(y.into())
}
