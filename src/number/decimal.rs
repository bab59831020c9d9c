//! Decimal floating point of a given length and rounding: the arithmetic of a machine.
//!
//! Its predicates speak of the stored number. What a machine may print is found by carrying a
//! computation out several times with [`Rounding::Scattered`]: every result is rounded up or down as
//! chance will have it, so that the spread of the last results is that of its rounding errors.

use std::cmp::Ordering;
use std::io::Write;

use rug::{Integer, Rational};

use super::exact::rational_sqrt;
use super::{Elementary, Kind, Real, Truth, degrees};

/// How a result that has too many digits loses them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// To the nearest number, from the middle away from zero.
    Nearest,
    /// Digits are cut off.
    TowardsZero,
    /// To one of the two neighbours, which of them depends on the digits and this seed alone.
    Scattered(u64),
}

/// The length of a mantissa, and how results are brought to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Machine {
    digits: u32,
    rounding: Rounding,
}

/// The elementary functions come from floats of nearly 16 digits.
const MOST_DIGITS: u32 = 12;

impl Machine {
    /// A machine of 1 to 12 digits; others have none.
    pub fn new(digits: u32, rounding: Rounding) -> Option<Self> {
        (1..=MOST_DIGITS)
            .contains(&digits)
            .then_some(Machine { digits, rounding })
    }

    /// The number m·10ᵉ in this machine.
    fn rounded(self, mantissa: i128, exponent: i32) -> Decimal {
        let size = mantissa.unsigned_abs();
        let length = match u64::try_from(size) {
            Ok(size) => size.checked_ilog10(),
            Err(_) => size.checked_ilog10(),
        };
        let Some(length) = length.map(|log| log + 1) else {
            return self.number(0, 0);
        };
        if length <= self.digits {
            let missing = self.digits - length;
            return self.number(
                mantissa * power_of_ten(missing),
                exponent.saturating_sub_unsigned(missing),
            );
        }
        let surplus = length - self.digits;
        let unit = power_of_ten(surplus).unsigned_abs();
        // The usual numbers have less than 64 bits, which divide much faster.
        let (mut kept, cut) = match (u64::try_from(size), u64::try_from(unit)) {
            (Ok(size), Ok(unit)) => (u128::from(size / unit), u128::from(size % unit)),
            _ => (size / unit, size % unit),
        };
        let mut exponent = exponent.saturating_add_unsigned(surplus);
        if cut != 0 && self.rounds_up(kept, cut, unit) {
            kept += 1;
            if kept == power_of_ten(self.digits).unsigned_abs() {
                kept /= 10;
                exponent = exponent.saturating_add(1);
            }
        }
        // At most twelve digits.
        let kept = i128::try_from(kept).unwrap_or_default();
        self.number(kept * mantissa.signum(), exponent)
    }

    fn rounds_up(self, kept: u128, cut: u128, unit: u128) -> bool {
        match self.rounding {
            Rounding::Nearest => 2 * cut >= unit,
            Rounding::TowardsZero => false,
            Rounding::Scattered(seed) => {
                let digits = [kept, cut].map(|part| u64::try_from(part).unwrap_or(u64::MAX));
                digits.into_iter().fold(seed, scattered) & 1 == 1
            }
        }
    }

    fn number(self, mantissa: i128, exponent: i32) -> Decimal {
        match i64::try_from(mantissa) {
            Ok(mantissa) if exponent.unsigned_abs() < MOST_EXPONENT => {
                let value = Digits { mantissa, exponent };
                Decimal(State::Stored(value, self))
            }
            Ok(_) if exponent < 0 => self.number(0, 0),
            _ => Decimal::NONE,
        }
    }

    fn of_rational(self, q: &Rational) -> Decimal {
        if let (Some(whole), true) = (q.numer().to_i128(), q.is_integer()) {
            return self.rounded(whole, 0);
        }
        let bits = |i: &Integer| i64::from(i.significant_bits());
        // Three tenths are nearly log 2 to the base ten.
        let shift = (bits(q.denom()) - bits(q.numer())) * 3 / 10 + i64::from(self.digits) + 3;
        let Ok(shift) = i32::try_from(shift) else {
            return Decimal::NONE;
        };
        let scale = Rational::from(Integer::from(Integer::u_pow_u(10, shift.unsigned_abs())));
        let scaled = if shift < 0 { q / scale } else { q * scale };
        let (numerator, denominator) = scaled.into_numer_denom();
        let (whole, rest) = numerator.div_rem(denominator);
        match whole.to_i128() {
            Some(whole) => self.with_rest(whole, rest.cmp0(), -shift),
            None => Decimal::NONE,
        }
    }

    /// (whole + rest)·10ᵉ, of whose rest only the sign is known, that of the number itself. It stands as
    /// one more digit: what matters of it is that it is not zero.
    fn with_rest(self, whole: i128, rest: Ordering, exponent: i32) -> Decimal {
        let last = match rest {
            Ordering::Less => -1,
            Ordering::Equal => 0,
            Ordering::Greater => 1,
        };
        self.rounded(whole * 10 + last, exponent.saturating_sub(1))
    }

    /// A float's digits, as far as it has them.
    fn of_float(self, x: f64) -> Decimal {
        if x == 0.0 {
            return self.number(0, 0);
        }
        let parts = digits_of(x);
        match parts {
            Some((mantissa, exponent)) => self.rounded(mantissa, exponent),
            None => Decimal::NONE,
        }
    }
}

/// 17 digits of a float as a whole number, and the power of ten that it is to be multiplied by.
fn digits_of(x: f64) -> Option<(i128, i32)> {
    let mut bytes = [0; 32];
    let mut rest = bytes.as_mut_slice();
    write!(rest, "{:.16e}", x.abs()).ok()?;
    let left = rest.len();
    let written = bytes.get(..bytes.len() - left)?;
    let (digits, exponent) = str::from_utf8(written).ok()?.split_once('e')?;
    let mut mantissa: i64 = 0;
    for digit in digits.bytes().filter(|byte| *byte != b'.') {
        let digit = digit.is_ascii_digit().then(|| i64::from(digit - b'0'))?;
        mantissa = 10 * mantissa + digit;
    }
    let sign = if x < 0.0 { -1 } else { 1 };
    let exponent: i32 = exponent.parse().ok()?;
    Some((i128::from(sign * mantissa), exponent - 16))
}

/// 10ⁿ for n up to 38.
fn power_of_ten(n: u32) -> i128 {
    #[expect(
        clippy::indexing_slicing,
        reason = "the compiler evaluates it, and refuses an index out of bounds"
    )]
    const POWERS: [i128; 39] = {
        let mut powers = [1; 39];
        let mut n = 1;
        while n < powers.len() {
            powers[n] = 10 * powers[n - 1];
            n += 1;
        }
        powers
    };
    let power = usize::try_from(n).ok().and_then(|n| POWERS.get(n));
    match power {
        Some(power) => *power,
        None => 10_i128.pow(n),
    }
}

/// Mixes a number into a seed (the finalizer of SplitMix64).
fn scattered(seed: u64, part: u64) -> u64 {
    let mut z = (seed ^ part).wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Beyond this exponent a number is too large to have a value, or zero.
const MOST_EXPONENT: u32 = 1_000_000;

/// The mantissa has as many digits as its machine holds, or is zero.
#[derive(Clone, Copy, Debug)]
struct Digits {
    mantissa: i64,
    exponent: i32,
}

impl Digits {
    fn wide(self) -> i128 {
        i128::from(self.mantissa)
    }
}

#[derive(Clone, Debug)]
enum State {
    /// Exact until it meets a number of a machine.
    Constant(Rational),
    /// The same for an integer, of which there are many.
    Whole(i64),
    Stored(Digits, Machine),
    None,
}

/// A number of a [`Machine`].
#[derive(Clone, Debug)]
pub struct Decimal(State);

impl Decimal {
    const NONE: Self = Decimal(State::None);

    /// The stored number.
    pub fn rational(&self) -> Option<Rational> {
        match &self.0 {
            State::Constant(q) => Some(q.clone()),
            State::Whole(i) => Some(Rational::from(*i)),
            State::Stored(Digits { mantissa, exponent }, _) => {
                let power = Rational::from(Integer::u_pow_u(10, exponent.unsigned_abs()));
                let mantissa = Rational::from(*mantissa);
                Some(if *exponent < 0 {
                    mantissa / power
                } else {
                    mantissa * power
                })
            }
            State::None => None,
        }
    }

    fn to_float(&self) -> f64 {
        match &self.0 {
            State::Constant(q) => q.to_f64(),
            State::Whole(i) => f64::integer(*i),
            // Both are exact where the machine's exponents are moderate.
            State::Stored(Digits { mantissa, exponent }, _) if *exponent < 0 => {
                f64::integer(*mantissa) / 10_f64.powi(-exponent)
            }
            State::Stored(Digits { mantissa, exponent }, _) => {
                f64::integer(*mantissa) * 10_f64.powi(*exponent)
            }
            State::None => f64::NAN,
        }
    }

    fn machine(&self) -> Option<Machine> {
        match self.0 {
            State::Stored(_, machine) => Some(machine),
            _ => None,
        }
    }

    /// Both operands in the machine of one of them.
    fn stored(&self, other: &Self) -> Option<([Digits; 2], Machine)> {
        let machine = self.machine().or_else(|| other.machine())?;
        Some((
            [self.digits_in(machine)?, other.digits_in(machine)?],
            machine,
        ))
    }

    fn digits_in(&self, machine: Machine) -> Option<Digits> {
        match &self.0 {
            State::Constant(q) => machine.of_rational(q).digits(),
            State::Whole(i) => machine.rounded((*i).into(), 0).digits(),
            State::Stored(digits, _) => Some(*digits),
            State::None => None,
        }
    }

    /// An exact number that has not met a machine.
    fn exact(&self) -> Option<Rational> {
        self.machine().is_none().then(|| self.rational()).flatten()
    }

    fn digits(&self) -> Option<Digits> {
        match self.0 {
            State::Stored(digits, _) => Some(digits),
            _ => None,
        }
    }

    /// An operation on constants, or on numbers of a machine.
    fn combine(
        &mut self,
        other: &Self,
        of_constants: impl FnOnce(&Rational, &Rational) -> Option<Rational>,
        of_digits: impl FnOnce(Digits, Digits, Machine) -> Decimal,
    ) {
        *self = match self.stored(other) {
            Some(([a, b], machine)) => of_digits(a, b, machine),
            None => {
                let operands = self.exact().zip(other.exact());
                let result = operands.and_then(|(a, b)| of_constants(&a, &b));
                result.map_or(Self::NONE, Self::constant)
            }
        };
    }

    fn apply(&mut self, f: impl FnOnce(f64) -> f64) {
        *self = match &self.0 {
            State::Stored(_, machine) => machine.of_float(f(self.to_float())),
            _ => Self::NONE,
        };
    }
}

fn sum(a: Digits, b: Digits, machine: Machine) -> Decimal {
    if b.mantissa == 0 {
        return machine.rounded(a.wide(), a.exponent);
    }
    if a.mantissa == 0 {
        return machine.rounded(b.wide(), b.exponent);
    }
    let (high, low) = if a.exponent >= b.exponent {
        (a, b)
    } else {
        (b, a)
    };
    let shift = high.exponent.abs_diff(low.exponent);
    // Beyond the digits of the high one only the sign of the low one matters.
    let reach = machine.digits + 2;
    if shift > reach {
        let high_end = high.exponent.saturating_sub_unsigned(reach);
        let whole = high.wide() * power_of_ten(reach);
        return machine.with_rest(whole, low.mantissa.cmp(&0), high_end);
    }
    machine.rounded(high.wide() * power_of_ten(shift) + low.wide(), low.exponent)
}

fn product(a: Digits, b: Digits, machine: Machine) -> Decimal {
    machine.rounded(a.wide() * b.wide(), a.exponent.saturating_add(b.exponent))
}

fn quotient(a: Digits, b: Digits, machine: Machine) -> Decimal {
    if b.mantissa == 0 {
        return Decimal::NONE;
    }
    let reach = machine.digits + 2;
    let dividend = a.wide() * power_of_ten(reach);
    let rest = (dividend % b.wide()).signum() * b.wide().signum();
    let exponent = a
        .exponent
        .saturating_sub(b.exponent)
        .saturating_sub_unsigned(reach);
    machine.with_rest(dividend / b.wide(), rest.cmp(&0), exponent)
}

fn root(x: Digits, machine: Machine) -> Decimal {
    let Ok(mantissa) = u128::try_from(x.mantissa) else {
        return Decimal::NONE;
    };
    let shift = machine.digits + 4 + u32::from(x.exponent & 1 == 1) + (machine.digits & 1);
    let radicand = mantissa * power_of_ten(shift).unsigned_abs();
    let whole = radicand.isqrt();
    let rest = (radicand - whole * whole).cmp(&0);
    let exponent = x.exponent.saturating_sub_unsigned(shift) / 2;
    machine.with_rest(i128::try_from(whole).unwrap_or_default(), rest, exponent)
}

impl Kind for Decimal {
    const ROUNDS: bool = true;

    fn constant(q: Rational) -> Self {
        Decimal(State::Constant(q))
    }

    fn integer(i: i64) -> Self {
        Decimal(State::Whole(i))
    }

    fn add(&mut self, other: &Self) {
        self.combine(other, |a, b| Some(Rational::from(a + b)), sum);
    }

    fn sub(&mut self, other: &Self) {
        let mut negative = other.clone();
        negative.negate();
        self.add(&negative);
    }

    fn mul(&mut self, other: &Self) {
        self.combine(other, |a, b| Some(Rational::from(a * b)), product);
    }

    fn div(&mut self, other: &Self) {
        let of_constants =
            |a: &Rational, b: &Rational| (!b.cmp0().is_eq()).then(|| Rational::from(a / b));
        self.combine(other, of_constants, quotient);
    }

    fn negate(&mut self) {
        match &mut self.0 {
            State::Constant(q) => *q = Rational::from(-&*q),
            State::Whole(i) => match i.checked_neg() {
                Some(negative) => *i = negative,
                None => *self = Self::constant(-Rational::from(*i)),
            },
            State::Stored(digits, _) => digits.mantissa = -digits.mantissa,
            State::None => {}
        }
    }

    fn is_zero(&self) -> Truth {
        Truth::of_sign(self.sign(), Ordering::is_eq)
    }

    fn has_value(&self) -> bool {
        !matches!(self.0, State::None)
    }
}

impl Real for Decimal {
    type Precision = Machine;

    fn rounded(q: &Rational, machine: &Machine) -> Self {
        machine.of_rational(q)
    }

    fn sign(&self) -> Option<Ordering> {
        match &self.0 {
            State::Constant(q) => Some(q.cmp0()),
            State::Whole(i) => Some(i.cmp(&0)),
            State::Stored(digits, _) => Some(digits.mantissa.cmp(&0)),
            State::None => None,
        }
    }

    /// A constant keeps its root where that is rational.
    fn sqrt(&mut self) {
        *self = match &self.0 {
            State::Stored(digits, machine) => root(*digits, *machine),
            _ => match self.exact().and_then(rational_sqrt) {
                Some(root) => Self::constant(root),
                None => Self::NONE,
            },
        };
    }

    /// Exact for multiples of 90°.
    fn cos_sin_of_degrees(q: &Rational, machine: &Machine) -> Option<(Self, Self)> {
        if let Some(quarter) = degrees::quarter_turns(q) {
            let (cos, sin) = degrees::cos_sin_of_quarter_turns(quarter);
            return Some((Self::integer(cos), Self::integer(sin)));
        }
        let (sin, cos) = q.to_f64().to_radians().sin_cos();
        Some((machine.of_float(cos), machine.of_float(sin)))
    }
}

/// Each value of a float function, rounded; a constant has no machine to round it.
impl Elementary for Decimal {
    fn pi(machine: &Machine) -> Self {
        machine.of_float(std::f64::consts::PI)
    }

    fn sin(&mut self) {
        self.apply(f64::sin);
    }

    fn cos(&mut self) {
        self.apply(f64::cos);
    }

    fn tan(&mut self) {
        self.apply(f64::tan);
    }

    fn asin(&mut self) {
        self.apply(f64::asin);
    }

    fn acos(&mut self) {
        self.apply(f64::acos);
    }

    fn atan(&mut self) {
        self.apply(f64::atan);
    }

    fn atan2(&mut self, x: &Self) {
        let x = x.to_float();
        if x == 0.0 && self.to_float() == 0.0 {
            *self = Self::NONE;
        } else {
            self.apply(|y| y.atan2(x));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    type Operation = fn(&mut Decimal, &Decimal);

    fn stored(mantissa: i64, exponent: i32, machine: Machine) -> Decimal {
        machine.rounded(mantissa.into(), exponent)
    }

    fn machines() -> impl Strategy<Value = Machine> {
        let rounding = prop_oneof![Just(Rounding::Nearest), Just(Rounding::TowardsZero)];
        (1..=MOST_DIGITS, rounding).prop_filter_map("has digits", |(digits, rounding)| {
            Machine::new(digits, rounding)
        })
    }

    proptest! {
        /// Every operation gives its exact result, rounded once.
        #[test]
        fn operations_round_the_exact_result(
            machine in machines(),
            [m, n] in [-99_999_999_i64..99_999_999, -99_999_999..99_999_999],
            [e, f] in [-20..20, -20..20],
        ) {
            let (x, y) = (stored(m, e, machine), stored(n, f, machine));
            let [a, b] = [&x, &y].map(|number| number.rational().unwrap());
            let mut results: Vec<(Operation, Rational)> = vec![
                (Decimal::add, Rational::from(&a + &b)),
                (Decimal::sub, Rational::from(&a - &b)),
                (Decimal::mul, Rational::from(&a * &b)),
            ];
            if !b.cmp0().is_eq() {
                results.push((Decimal::div, Rational::from(&a / &b)));
            }
            for (operation, exact) in results {
                let mut result = x.clone();
                operation(&mut result, &y);
                prop_assert_eq!(result.rational(), machine.of_rational(&exact).rational());
            }
        }

        /// The square of a root, and that of the next number, enclose the radicand.
        #[test]
        fn roots_are_cut(digits in 1..=MOST_DIGITS, m in 1_i64..99_999_999, e in -20..20) {
            let machine = Machine::new(digits, Rounding::TowardsZero).unwrap();
            let x = stored(m, e, machine);
            let mut root = x.clone();
            root.sqrt();
            let last = Digits { mantissa: 1, exponent: root.digits().unwrap().exponent };
            let next = Decimal(State::Stored(last, machine)).rational().unwrap() + root.rational().unwrap();
            prop_assert!(root.rational().unwrap().square() <= x.rational().unwrap());
            prop_assert!(x.rational().unwrap() < next.square());
        }

        /// A scattered result is one of the two neighbours, and the same every time.
        #[test]
        fn scattered_results_are_neighbours(seed: u64, m in 1_i64..99_999_999, n in 1_i64..99_999_999) {
            let of = |rounding| {
                let machine = Machine::new(8, rounding).unwrap();
                let mut quotient = stored(m, 0, machine);
                quotient.div(&stored(n, 0, machine));
                quotient.rational().unwrap()
            };
            let (cut, scattered) = (of(Rounding::TowardsZero), of(Rounding::Scattered(seed)));
            prop_assert_eq!(&scattered, &of(Rounding::Scattered(seed)));
            let exact = Rational::from((m, n));
            if scattered != cut {
                prop_assert!(cut < exact && exact < scattered);
                prop_assert!(Rational::from(&scattered - &cut) < Rational::from((11, 100_000_000)) * exact);
            }
        }
    }

    #[test]
    fn a_machine_holds_at_most_twelve_digits() {
        assert_eq!(Machine::new(0, Rounding::Nearest), None);
        assert_eq!(Machine::new(13, Rounding::Nearest), None);
    }

    #[test]
    fn both_neighbours_come_up() {
        let thirds = (0..100).map(|seed| {
            let machine = Machine::new(8, Rounding::Scattered(seed)).unwrap();
            machine.of_rational(&Rational::from((1, 3))).rational()
        });
        let up = thirds
            .filter(|third| *third > Some(Rational::from((1, 3))))
            .count();
        assert!((20..80).contains(&up), "{up} of 100 were rounded up");
    }

    #[test]
    fn functions_are_rounded_once() {
        let machine = Machine::new(8, Rounding::TowardsZero).unwrap();
        let mut sine = machine.of_rational(&Rational::from(1));
        sine.sin();
        assert_eq!(sine.to_float(), 0.841_470_98);
    }
}
