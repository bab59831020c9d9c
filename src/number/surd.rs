//! Sums of square roots of rational numbers, decided exactly.
//!
//! A number is Σ q_S ∏_{g ∈ S} √g over the subsets S of a few integers g (the generators), of which
//! no product of different ones is a perfect square. Square roots of integers in different classes
//! modulo squares are linearly independent over Q, so the form is unique: a number is zero only if
//! all q_S are. Nothing has to be factored.

use std::cmp::Ordering;
use std::fmt;

use rug::{Integer, Rational};

use super::exact::{bits, rational_sqrt};
use super::kind::EXCESSIVE_BITS;
use super::{Ball, Kind, Number, Real, Truth, degrees};

/// More generators than this (2ᵏ coefficients) are not held: the result has no value.
const MOST_GENERATORS: usize = 8;

/// A sum of square roots of rational numbers: lengths between points with rational coordinates, and
/// whatever arithmetic makes of them. A root of a sum of roots is held only where it is such a sum
/// itself.
#[derive(Clone, Debug)]
pub struct Surd(Option<Sum>);

/// Coefficients by subset: bit j of the index says that √(generator j) is a factor.
#[derive(Clone, Debug)]
struct Sum {
    generators: Vec<Integer>,
    coefficients: Vec<Rational>,
}

/// A rational multiple of a product of different generators' roots.
struct Term {
    factor: Rational,
    subset: usize,
}

impl Surd {
    /// The number as a rational, if it is one.
    pub fn rational(&self) -> Option<&Rational> {
        let sum = self.0.as_ref()?;
        sum.generators
            .is_empty()
            .then(|| sum.coefficients.first())
            .flatten()
    }

    /// The terms as pairs (q, n) of q·√n with integers n > 0; `None` after an undefined operation.
    pub fn terms(&self) -> Option<Vec<(Rational, Integer)>> {
        let sum = self.0.as_ref()?;
        Some(
            sum.terms()
                .map(|(subset, q)| (q.clone(), sum.radicand(subset)))
                .collect(),
        )
    }

    /// A ball around the number with a radius of at most 2^−bits times its magnitude, also where the
    /// terms all but cancel; no value after an undefined operation.
    pub fn enclosure(&self, bits: u32) -> Number<Ball> {
        let Some(terms) = self.terms() else {
            return Number::zero().inverse();
        };
        let bits = bits.saturating_add(2);
        if terms.is_empty() {
            return Number::rounded(&Rational::new(), &bits);
        }
        // The sum is not zero, so that some precision suffices.
        let mut working = bits.saturating_add(16);
        loop {
            let sum: Number<Ball> = terms
                .iter()
                .map(|(q, n)| {
                    let root = Number::<Ball>::rounded(&Rational::from(n), &working).sqrt();
                    Number::<Ball>::rounded(q, &working) * root
                })
                .sum();
            if sum.0.accuracy_bits() >= Some(i64::from(bits)) {
                return sum;
            }
            working = working.saturating_mul(2);
        }
    }

    fn combine(&mut self, other: &Self, operate: impl FnOnce(Sum, Sum) -> Sum) {
        self.0 = match (self.0.take(), &other.0) {
            (Some(a), Some(b)) => Sum::in_common(a, b).map(|(a, b)| operate(a, b).trimmed()),
            _ => None,
        };
    }
}

impl Sum {
    fn rational(q: Rational) -> Sum {
        Sum {
            generators: Vec::new(),
            coefficients: vec![q],
        }
    }

    fn terms(&self) -> impl Iterator<Item = (usize, &Rational)> {
        self.coefficients
            .iter()
            .enumerate()
            .filter(|(_, q)| !q.is_zero())
    }

    /// The product of the generators in a subset.
    fn radicand(&self, subset: usize) -> Integer {
        product(&self.generators, subset)
    }

    /// Both over one list of generators.
    fn in_common(mut a: Sum, b: &Sum) -> Option<(Sum, Sum)> {
        if a.generators == b.generators {
            return Some((a, b.clone()));
        }
        let images: Vec<Term> = b
            .generators
            .iter()
            .map(|g| a.adjoin(g))
            .collect::<Option<_>>()?;
        let mut renamed = a.zero_over_same();
        for (subset, q) in b.terms() {
            let mut image = Term {
                factor: q.clone(),
                subset: 0,
            };
            for (_, term) in members(&images, subset) {
                image = a.times(&image, term);
            }
            add_to(&mut renamed.coefficients, image);
        }
        let short = a.coefficients.len();
        a.coefficients
            .resize(1 << a.generators.len(), Rational::new());
        debug_assert!(short <= a.coefficients.len());
        renamed
            .coefficients
            .resize(1 << a.generators.len(), Rational::new());
        renamed.generators.clone_from(&a.generators);
        Some((a, renamed))
    }

    fn zero_over_same(&self) -> Sum {
        Sum {
            generators: self.generators.clone(),
            coefficients: vec![Rational::new(); 1 << self.generators.len()],
        }
    }

    /// √g over the generators, of which g becomes one if it must.
    fn adjoin(&mut self, g: &Integer) -> Option<Term> {
        for subset in 0..1usize << self.generators.len() {
            let others = self.radicand(subset);
            let together = Integer::from(g * &others);
            if together.is_perfect_square() {
                let factor = Rational::from((together.sqrt(), others));
                return Some(Term { factor, subset });
            }
        }
        if self.generators.len() == MOST_GENERATORS {
            return None;
        }
        self.generators.push(g.clone());
        self.coefficients
            .resize(1 << self.generators.len(), Rational::new());
        Some(Term {
            factor: Rational::from(1),
            subset: 1 << (self.generators.len() - 1),
        })
    }

    fn times(&self, a: &Term, b: &Term) -> Term {
        let factor = Rational::from(&a.factor * &b.factor);
        Term {
            factor: factor * self.radicand(a.subset & b.subset),
            subset: a.subset ^ b.subset,
        }
    }

    fn product(&self, other: &Sum) -> Sum {
        let mut product = self.zero_over_same();
        for (subset, q) in self.terms() {
            let left = Term {
                factor: q.clone(),
                subset,
            };
            for (subset, q) in other.terms() {
                let right = Term {
                    factor: q.clone(),
                    subset,
                };
                add_to(&mut product.coefficients, self.times(&left, &right));
            }
        }
        product
    }

    /// (A, B) of A + B√g for the last generator g; both over the other generators.
    fn split(&self) -> Option<(Sum, Sum, &Integer)> {
        let (last, others) = self.generators.split_last()?;
        let (a, b) = self.coefficients.split_at(1 << others.len());
        let over_others = |coefficients: &[Rational]| Sum {
            generators: others.to_vec(),
            coefficients: coefficients.to_vec(),
        };
        Some((over_others(a), over_others(b), last))
    }

    /// A² − g B², the product of A + B√g with its conjugate.
    fn norm(a: &Sum, b: &Sum, g: &Integer) -> Sum {
        let mut norm = a.product(a);
        for (square, q) in norm.coefficients.iter_mut().zip(b.product(b).coefficients) {
            *square -= q * g;
        }
        norm
    }

    /// 1/self for a number that is not zero.
    fn inverse(&self) -> Option<Sum> {
        let Some((a, b, g)) = self.split() else {
            return self
                .coefficients
                .first()
                .map(|q| Sum::rational(Rational::from(q.recip_ref())));
        };
        let inverse = Sum::norm(&a, &b, g).inverse()?;
        let mut result = self.zero_over_same();
        let conjugate = a
            .coefficients
            .iter()
            .cloned()
            .chain(b.coefficients.iter().map(|q| Rational::from(-q)));
        result.coefficients = conjugate.collect();
        let mut widened = self.zero_over_same();
        for (subset, q) in inverse.over(&a.generators).terms() {
            if let Some(place) = widened.coefficients.get_mut(subset) {
                place.clone_from(q);
            }
        }
        Some(result.product(&widened))
    }

    /// The same number over a list that starts with this number's generators.
    fn over(mut self, generators: &[Integer]) -> Sum {
        self.generators = generators.to_vec();
        self.coefficients
            .resize(1 << generators.len(), Rational::new());
        self
    }

    fn sign(&self) -> Ordering {
        let Some((a, b, g)) = self.split() else {
            return self
                .coefficients
                .first()
                .map_or(Ordering::Equal, Rational::cmp0);
        };
        match (a.sign(), b.sign()) {
            (Ordering::Equal, b) => b,
            (a, Ordering::Equal) => a,
            (a, b) if a == b => a,
            // A and B√g pull apart: the larger square decides.
            (sign, _) => match Sum::norm(&a, &b, g).sign() {
                Ordering::Greater => sign,
                Ordering::Equal => Ordering::Equal,
                Ordering::Less => sign.reverse(),
            },
        }
    }

    /// Without the generators that no term uses.
    fn trimmed(self) -> Sum {
        let used = self.terms().fold(0, |used, (subset, _)| used | subset);
        if used + 1 == self.coefficients.len() {
            return self;
        }
        let kept: Vec<usize> = (0..self.generators.len())
            .filter(|j| used >> j & 1 == 1)
            .collect();
        let mut trimmed = Sum::rational(Rational::new()).over(
            &kept
                .iter()
                .filter_map(|&j| self.generators.get(j).cloned())
                .collect::<Vec<_>>(),
        );
        for (subset, q) in self.terms() {
            let renamed = kept.iter().enumerate().fold(0, |renamed, (new, old)| {
                renamed | (subset >> old & 1) << new
            });
            if let Some(place) = trimmed.coefficients.get_mut(renamed) {
                place.clone_from(q);
            }
        }
        trimmed
    }

    /// The root of a positive number a + b√g with rational a, b, where it is a sum √s ± √t:
    /// (√s ± √t)² = s + t ± 2√(st).
    fn denested_root(&self) -> Option<Surd> {
        let (a, b, g) = self.split()?;
        let [a, b] = [a, b].map(|part| match part.coefficients.as_slice() {
            [q] => Some(q.clone()),
            _ => None,
        });
        let (a, b) = (a?, b?);
        let discriminant = Rational::from(a.square_ref()) - Rational::from(b.square_ref()) * g;
        let root = rational_sqrt(discriminant)?;
        let [s, t] =
            [Rational::from(&a + &root), a - root].map(|twice| root_of_rational(twice / 2));
        let (s, mut t) = (s?, t?);
        if b.cmp0().is_lt() {
            t.negate();
        }
        let mut sum = s;
        sum.add(&t);
        Some(sum)
    }
}

fn product(generators: &[Integer], subset: usize) -> Integer {
    members(generators, subset).fold(Integer::from(1), |product, (_, g)| product * g)
}

/// The members of a list whose bit is set.
fn members<T>(list: &[T], subset: usize) -> impl Iterator<Item = (usize, &T)> {
    list.iter()
        .enumerate()
        .filter(move |(j, _)| subset >> j & 1 == 1)
}

fn add_to(coefficients: &mut Vec<Rational>, term: Term) {
    if coefficients.len() <= term.subset {
        coefficients.resize(term.subset + 1, Rational::new());
    }
    if let Some(place) = coefficients.get_mut(term.subset) {
        *place += term.factor;
    }
}

/// √q for a rational q ≥ 0.
fn root_of_rational(q: Rational) -> Option<Surd> {
    if q.cmp0().is_lt() {
        return None;
    }
    let (numerator, denominator) = q.into_numer_denom();
    let (outside, inside) = square_part(numerator * &denominator);
    let factor = Rational::from((outside, denominator));
    if inside == 1 || inside == 0 {
        return Some(Surd::constant(factor * inside));
    }
    Some(Surd(Some(Sum {
        generators: vec![inside],
        coefficients: vec![Rational::new(), factor],
    })))
}

/// n = outside² · inside; squares of small primes only, which keeps roots readable, and n itself
/// where it is a square.
fn square_part(n: Integer) -> (Integer, Integer) {
    if n.is_perfect_square() {
        return (n.sqrt(), Integer::from(1));
    }
    let mut outside = Integer::from(1);
    let mut inside = n;
    for prime in [2u32, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31] {
        while inside.is_divisible_u(prime * prime) {
            inside.div_exact_u_mut(prime * prime);
            outside *= prime;
        }
    }
    (outside, inside)
}

impl Kind for Surd {
    fn constant(q: Rational) -> Self {
        Surd(Some(Sum::rational(q)))
    }

    fn add(&mut self, other: &Self) {
        self.combine(other, |mut a, b| {
            for (sum, q) in a.coefficients.iter_mut().zip(b.coefficients) {
                *sum += q;
            }
            a
        });
    }

    fn sub(&mut self, other: &Self) {
        self.combine(other, |mut a, b| {
            for (sum, q) in a.coefficients.iter_mut().zip(b.coefficients) {
                *sum -= q;
            }
            a
        });
    }

    fn mul(&mut self, other: &Self) {
        self.combine(other, |a, b| a.product(&b));
    }

    fn div(&mut self, other: &Self) {
        let inverse = other
            .0
            .as_ref()
            .filter(|divisor| divisor.sign() != Ordering::Equal)
            .and_then(Sum::inverse);
        self.mul(&Surd(inverse));
    }

    fn negate(&mut self) {
        if let Some(sum) = &mut self.0 {
            for q in &mut sum.coefficients {
                *q = Rational::from(-&*q);
            }
        }
    }

    fn is_zero(&self) -> Truth {
        match &self.0 {
            Some(sum) => sum.terms().next().is_none().into(),
            None => Truth::Unknown,
        }
    }

    fn has_value(&self) -> bool {
        self.0.is_some()
    }

    fn is_excessive(&self) -> bool {
        self.0.as_ref().is_some_and(|sum| {
            let sizes = sum.coefficients.iter().map(bits);
            sizes.fold(0, u32::saturating_add) > EXCESSIVE_BITS
        })
    }
}

impl Real for Surd {
    type Precision = ();

    fn rounded(q: &Rational, (): &()) -> Self {
        Self::constant(q.clone())
    }

    fn sign(&self) -> Option<Ordering> {
        self.0.as_ref().map(Sum::sign)
    }

    /// No value for a negative number, and for a root of a sum of roots that is no such sum itself.
    fn sqrt(&mut self) {
        let root = match (self.sign(), self.rational()) {
            (Some(Ordering::Equal | Ordering::Greater), Some(q)) => root_of_rational(q.clone()),
            (Some(Ordering::Greater), None) => self.0.as_ref().and_then(Sum::denested_root),
            _ => None,
        };
        *self = root.unwrap_or(Surd(None));
    }

    /// Multiples of 15°.
    fn cos_sin_of_degrees(q: &Rational, (): &()) -> Option<(Self, Self)> {
        let step = degrees::whole_steps(q, 15, 24)?;
        let (cos, sin) = degrees::cos_sin_of_quarter_turns(step / 6);
        let (c, s) = match step % 6 {
            0 => (Surd::integer(1), Surd::integer(0)),
            1 => (quarter_sum(6, 2), quarter_sum(6, -2)),
            2 => (quarter_sum(12, 0), quarter_sum(4, 0)),
            3 => (quarter_sum(8, 0), quarter_sum(8, 0)),
            4 => (quarter_sum(4, 0), quarter_sum(12, 0)),
            _ => (quarter_sum(6, -2), quarter_sum(6, 2)),
        };
        Some((rotated(&c, cos, &s, -sin), rotated(&s, cos, &c, sin)))
    }
}

/// (√a ± √|b|)/4, with the sign of b.
fn quarter_sum(a: u32, b: i32) -> Surd {
    let root = |n: u32| root_of_rational(Rational::from((n, 16))).unwrap_or(Surd(None));
    let mut sum = root(a);
    if b < 0 {
        sum.sub(&root(b.unsigned_abs()));
    } else {
        sum.add(&root(b.unsigned_abs()));
    }
    sum
}

/// a·x + b·y.
fn rotated(a: &Surd, x: i64, b: &Surd, y: i64) -> Surd {
    let mut left = a.clone();
    left.mul(&Surd::integer(x));
    let mut right = b.clone();
    right.mul(&Surd::integer(y));
    left.add(&right);
    left
}

impl fmt::Display for Surd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(terms) = self.terms() else {
            return f.write_str("no value");
        };
        if terms.is_empty() {
            return f.write_str("0");
        }
        for (place, (q, n)) in terms.iter().enumerate() {
            let sign = match (place, q.cmp0().is_lt()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            };
            f.write_str(sign)?;
            let size = Rational::from(q.abs_ref());
            match (size == 1, *n == 1) {
                (_, true) => write!(f, "{size}")?,
                (true, false) => write!(f, "sqrt({n})")?,
                (false, false) => write!(f, "{size} sqrt({n})")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(n: i64) -> Number<Surd> {
        Number::from(n).sqrt()
    }

    #[test]
    fn different_classes_are_independent_and_equal_ones_merge() {
        assert!((root(2) * root(3) - root(6)).is_zero().is_yes());
        assert!((root(2) + root(3) - root(5)).is_zero().is_no());
        assert!((root(8) - 2 * root(2)).is_zero().is_yes());
        assert!(
            (root(1_000_003 * 4) - 2 * root(1_000_003))
                .is_zero()
                .is_yes()
        );
    }

    #[test]
    fn division_undoes_multiplication() {
        let x = root(2) + root(3) - 5 * root(7) + 1;
        let y = root(6) - root(14) + Number::ratio(1, 3);
        assert!((&x / &y * &y - &x).is_zero().is_yes());
        assert!(!(x / Number::zero()).has_value());
    }

    #[test]
    fn signs_are_decided_where_floats_fail() {
        // √a + √(a+2) < 2 √(a+1), by about a^(-3/2)/4.
        let a = 1_000_000_000_000i64;
        let difference = root(a) + root(a + 2) - 2 * root(a + 1);
        assert_eq!(difference.sign(), Some(Ordering::Less));
    }

    /// √(a² + 1) − a − 1/(2a) + 1/(8a³), about 1/(16 a⁵).
    fn tiny(a: &Integer) -> Number<Surd> {
        let a = Number::<Surd>::from(Rational::from(a));
        (a.square() + 1).sqrt() - &a - 1 / (2 * &a) + 1 / (8 * a.power(3))
    }

    #[test]
    fn very_close_values_are_compared_exactly() {
        use rug::ops::Pow;
        for digits in [5u32, 40, 300] {
            let a = Integer::from(10).pow(digits);
            assert_eq!(tiny(&a).sign(), Some(Ordering::Greater));
            let b = Integer::from(&a + 1);
            assert_eq!(tiny(&a).compare(&tiny(&b)), Some(Ordering::Greater));
            // √a + √(a + 3) and √(a + 1) + √(a + 2) agree to half as many digits again.
            let [r, s, t, u] = [0, 1, 2, 3]
                .map(|i| Number::<Surd>::from(Rational::from(Integer::from(&a + i))).sqrt());
            assert_eq!((r + u).compare(&(s + t)), Some(Ordering::Less));
        }
    }

    #[test]
    fn enclosures_are_accurate_in_spite_of_cancellation() {
        use rug::ops::Pow;
        let a = Integer::from(10).pow(100u32);
        let ball = tiny(&a).0.enclosure(200).0;
        assert!(ball.accuracy_bits() >= Some(200));
        // 16 a⁵ times this is 1 − O(a⁻²).
        let [low, high] = [ball.lower(), ball.upper()]
            .map(|end| end.unwrap() * Rational::from(a.clone().pow(5u32)) * 16);
        let below_one = Rational::from((Integer::from(&a - 1), a));
        assert!(below_one < low && high < Rational::from((11, 10)));
        let nothing = (root(2) / Number::zero()).0.enclosure(50);
        assert!(!nothing.has_value());
        let zero = Surd::integer(0).enclosure(50).0;
        assert_eq!(zero.radius_rational(), Some(Rational::new()));
    }

    #[test]
    fn nested_roots_are_resolved_where_they_can_be() {
        assert!(((3 + 2 * root(2)).sqrt() - 1 - root(2)).is_zero().is_yes());
        assert!(((3 - 2 * root(2)).sqrt() + 1 - root(2)).is_zero().is_yes());
        assert!(!(1 + root(2)).sqrt().has_value());
        assert!(!(1 - root(2)).sqrt().has_value());
    }

    #[test]
    fn multiples_of_15_degrees_are_exact() {
        for step in -30i64..30 {
            let at = |step: i64| {
                let (c, s) = Surd::cos_sin_of_degrees(&Rational::from(15 * step), &()).unwrap();
                (Number(c), Number(s))
            };
            let (c, s) = at(step);
            let (c1, s1) = at(1);
            let (next_c, next_s) = at(step + 1);
            assert!((&c * &c1 - &s * &s1 - next_c).is_zero().is_yes());
            assert!((&s * &c1 + &c * &s1 - next_s).is_zero().is_yes());
        }
    }
}
