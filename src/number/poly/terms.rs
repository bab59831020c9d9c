//! Arithmetic on sorted lists of terms, as polynomials in free variables: relations are the
//! business of [`Poly`](super::Poly).
//!
//! A list is sorted by falling monomial and holds no zero coefficient, so equal polynomials have
//! equal lists.

use std::cmp::{Ordering, Reverse};
use std::collections::{BTreeMap, BinaryHeap, HashMap};
use std::hash::{BuildHasherDefault, Hash, Hasher};

use rug::Integer;
use rug::ops::Pow;

use super::coefficient::Coefficient;
use super::monomial::Monomial;
use crate::number::count;

pub(super) type Term = (Monomial, Coefficient);

/// An operation whose result would have more terms has no value: a guard for memory.
pub(super) const MAX_TERMS: usize = 2_000_000;

/// A multiplication of more products of terms has no value either: a guard for time.
const MAX_PRODUCTS: usize = 4_000_000_000;

/// Up to so many products a plain sort is the fastest way to collect like terms.
const FEW_PRODUCTS: usize = 64;

/// A table of all possible monomials is used while it is not larger than this, nor than so many
/// times the number of products.
const MAX_TABLE: u64 = 1 << 22;
const TABLE_TO_PRODUCTS: u64 = 8;

/// Up to so many products are stored and sorted by a key of one word where the table is too large.
const MAX_SORTED: usize = 1 << 23;

/// The sum `a + sign·b`.
fn merge(a: &[Term], b: &[Term], sign: impl Fn(&Coefficient) -> Coefficient) -> Option<Vec<Term>> {
    let mut sum = Vec::with_capacity(a.len() + b.len());
    let (mut a, mut b) = (a, b);
    while let ([left, after_left @ ..], [right, after_right @ ..]) = (a, b) {
        match left.0.cmp(&right.0) {
            Ordering::Greater => {
                sum.push(left.clone());
                a = after_left;
            }
            Ordering::Less => {
                sum.push((right.0, sign(&right.1)));
                b = after_right;
            }
            Ordering::Equal => {
                let coefficient = left.1.add(&sign(&right.1));
                if !coefficient.is_zero() {
                    sum.push((left.0, coefficient));
                }
                (a, b) = (after_left, after_right);
            }
        }
    }
    sum.extend_from_slice(a);
    sum.extend(b.iter().map(|(monomial, c)| (*monomial, sign(c))));
    (sum.len() <= MAX_TERMS).then_some(sum)
}

pub(super) fn add(a: &[Term], b: &[Term]) -> Option<Vec<Term>> {
    merge(a, b, Coefficient::clone)
}

pub(super) fn sub(a: &[Term], b: &[Term]) -> Option<Vec<Term>> {
    merge(a, b, Coefficient::negated)
}

pub(super) fn scale(a: &[Term], factor: &Coefficient) -> Vec<Term> {
    if factor.is_zero() {
        return Vec::new();
    }
    a.iter()
        .map(|(monomial, c)| (*monomial, c.mul(factor)))
        .collect()
}

/// The largest exponent of every variable.
pub(super) fn degrees(a: &[Term]) -> Monomial {
    a.iter()
        .fold(Monomial::ONE, |lcm, (monomial, _)| lcm.lcm(monomial))
}

/// The power product that divides every term.
pub(super) fn common_monomial(a: &[Term]) -> Monomial {
    let mut monomials = a.iter().map(|(monomial, _)| *monomial);
    let first = monomials.next().unwrap_or(Monomial::ONE);
    monomials.fold(first, |gcd, monomial| gcd.gcd(&monomial))
}

/// The greatest common divisor of the coefficients; zero for no terms.
pub(super) fn content(a: &[Term]) -> Coefficient {
    let mut gcd = Coefficient::ZERO;
    for (_, coefficient) in a {
        gcd = gcd.gcd(coefficient);
        if gcd.is_one() {
            break;
        }
    }
    gcd
}

/// The product; `None` where an exponent overflows or the result is too long.
pub(super) fn multiply(a: &[Term], b: &[Term]) -> Option<Vec<Term>> {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    if short.is_empty() {
        return Some(Vec::new());
    }
    // The leading coefficients in each variable do not cancel: if the degrees fit, every product
    // fits, and if they do not, the result does not.
    let (long_degrees, short_degrees) = (degrees(long), degrees(short));
    let bounds = long_degrees.times(&short_degrees)?;
    if let [(monomial, coefficient)] = short {
        let product = long
            .iter()
            .map(|(m, c)| (m.times_unchecked(monomial), c.mul(coefficient)));
        return Some(product.collect());
    }
    let products = long.len().saturating_mul(short.len());
    if products > MAX_PRODUCTS {
        return None;
    }
    if products <= FEW_PRODUCTS {
        return Some(multiply_by_sorting(long, short));
    }
    let numbering = Numbering::new(&bounds);
    match &numbering {
        Some(numbering) if numbering.is_dense(products) => numbering.multiply(long, short),
        Some(numbering) if products <= MAX_SORTED => numbering.multiply_by_keys(long, short),
        _ => multiply_by_hashing(long, short),
    }
}

fn multiply_by_sorting(a: &[Term], b: &[Term]) -> Vec<Term> {
    let mut all: Vec<Term> = Vec::with_capacity(a.len() * b.len());
    for (m, c) in a {
        all.extend(b.iter().map(|(n, d)| (m.times_unchecked(n), c.mul(d))));
    }
    all.sort_unstable_by_key(|term| Reverse(term.0));
    let mut sum: Vec<Term> = Vec::with_capacity(all.len());
    for (monomial, coefficient) in all {
        match sum.last_mut() {
            Some(last) if last.0 == monomial => last.1 = last.1.add(&coefficient),
            _ => sum.push((monomial, coefficient)),
        }
    }
    sum.retain(|(_, coefficient)| !coefficient.is_zero());
    sum
}

fn multiply_by_hashing(a: &[Term], b: &[Term]) -> Option<Vec<Term>> {
    let mut sums: HashMap<Hashed, Coefficient, BuildHasherDefault<Mixer>> = HashMap::default();
    for (m, c) in b {
        for (n, d) in a {
            let key = Hashed(m.times_unchecked(n));
            sums.entry(key)
                .or_insert(Coefficient::ZERO)
                .add_product(c, d);
        }
        if sums.len() > MAX_TERMS {
            return None;
        }
    }
    let mut product: Vec<Term> = sums
        .into_iter()
        .filter(|(_, coefficient)| !coefficient.is_zero())
        .map(|(key, coefficient)| (key.0, coefficient))
        .collect();
    product.sort_unstable_by_key(|term| Reverse(term.0));
    Some(product)
}

#[derive(PartialEq, Eq)]
struct Hashed(Monomial);

impl Hash for Hashed {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.0.mixed());
    }
}

/// Passes on a word that is already mixed.
#[derive(Default)]
struct Mixer(u64);

impl Hasher for Mixer {
    fn finish(&self) -> u64 {
        // The table looks at the highest and at the lowest bits.
        self.0 ^ (self.0 >> 32)
    }

    fn write(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.write_u64(u64::from(*byte));
        }
    }

    fn write_u64(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }
}

/// All monomials within given degrees, numbered in their order by mixed radix.
struct Numbering {
    /// Variable, stride and largest exponent, in rising order.
    places: Vec<(usize, u64, u8)>,
    size: u64,
}

impl Numbering {
    /// `None` where there are too many for a machine word.
    fn new(bounds: &Monomial) -> Option<Self> {
        let mut places = Vec::new();
        let mut size: u64 = 1;
        for (variable, bound) in bounds.powers() {
            places.push((variable, size, bound));
            size = size.checked_mul(u64::from(bound) + 1)?;
        }
        Some(Numbering { places, size })
    }

    /// Whether a table of all monomials is in proportion to the number of products.
    fn is_dense(&self, products: usize) -> bool {
        self.size <= MAX_TABLE && self.size <= TABLE_TO_PRODUCTS * count::to_u64(products)
    }

    fn key(&self, monomial: &Monomial) -> u64 {
        let summands = self.places.iter();
        summands
            .map(|&(variable, stride, _)| stride * u64::from(monomial.exponent(variable)))
            .sum()
    }

    /// The key as an index into a table.
    fn index(&self, monomial: &Monomial) -> usize {
        // Tables have at most `MAX_TABLE` entries.
        count::from_u64(self.key(monomial))
    }

    /// Sorts the products by the sum of their keys, with the places of their factors.
    #[expect(
        clippy::as_conversions,
        clippy::indexing_slicing,
        reason = "the places of the factors are kept in few bits, for their sort is what takes time"
    )]
    fn multiply_by_keys(&self, a: &[Term], b: &[Term]) -> Option<Vec<Term>> {
        let keys =
            |terms: &[Term]| -> Vec<u64> { terms.iter().map(|(m, _)| self.key(m)).collect() };
        let (left, right) = (keys(a), keys(b));
        let mut products: Vec<(u64, u32, u32)> = Vec::with_capacity(a.len() * b.len());
        for (j, right) in (0..).zip(&right) {
            products.extend((0..).zip(&left).map(|(i, left)| (left + right, i, j)));
        }
        products.sort_unstable_by_key(|product| Reverse(product.0));
        let mut result = Vec::new();
        for like in products.chunk_by(|first, second| first.0 == second.0) {
            let mut sum = Coefficient::ZERO;
            for &(_, i, j) in like {
                sum.add_product(&a[i as usize].1, &b[j as usize].1);
            }
            if !sum.is_zero() {
                let (_, i, j) = like[0];
                let monomial = a[i as usize].0.times_unchecked(&b[j as usize].0);
                result.push((monomial, sum));
            }
        }
        (result.len() <= MAX_TERMS).then_some(result)
    }

    fn monomial(&self, index: usize) -> Monomial {
        let mut monomial = Monomial::ONE;
        for &(variable, stride, bound) in &self.places {
            let exponent = (count::to_u64(index) / stride) % (u64::from(bound) + 1);
            // At most `bound`, which is an exponent.
            let power = u8::try_from(exponent)
                .ok()
                .and_then(|exponent| Monomial::power(variable, exponent));
            if let Some(power) = power {
                monomial = monomial.times_unchecked(&power);
            }
        }
        monomial
    }

    fn multiply(&self, a: &[Term], b: &[Term]) -> Option<Vec<Term>> {
        match (self.words(a), self.words(b)) {
            (Some(a), Some(b)) if fits(&a, &b) => self.multiply_words(&a, &b),
            _ => self.multiply_coefficients(a, b),
        }
    }

    /// The terms with their indices where all coefficients are machine words.
    fn words(&self, terms: &[Term]) -> Option<Vec<(usize, i64)>> {
        let words = terms
            .iter()
            .map(|(monomial, coefficient)| match coefficient {
                Coefficient::Small(i) => Some((self.index(monomial), *i)),
                Coefficient::Big(_) => None,
            });
        words.collect()
    }

    #[expect(
        clippy::indexing_slicing,
        reason = "the number of a product is the sum of the numbers of its factors, below the size"
    )]
    fn multiply_words(&self, a: &[(usize, i64)], b: &[(usize, i64)]) -> Option<Vec<Term>> {
        let mut sums = vec![0i128; count::from_u64(self.size)];
        for &(i, c) in b {
            for &(j, d) in a {
                sums[i + j] += i128::from(c) * i128::from(d);
            }
        }
        self.collect(sums.into_iter().map(Coefficient::from))
    }

    #[expect(
        clippy::indexing_slicing,
        reason = "the number of a product is the sum of the numbers of its factors, below the size"
    )]
    fn multiply_coefficients(&self, a: &[Term], b: &[Term]) -> Option<Vec<Term>> {
        let mut sums = vec![Coefficient::ZERO; count::from_u64(self.size)];
        let a: Vec<_> = a.iter().map(|(m, c)| (self.index(m), c)).collect();
        for (m, c) in b {
            let i = self.index(m);
            for &(j, d) in &a {
                sums[i + j].add_product(c, d);
            }
        }
        self.collect(sums.into_iter())
    }

    fn collect(
        &self,
        sums: impl DoubleEndedIterator<Item = Coefficient> + ExactSizeIterator,
    ) -> Option<Vec<Term>> {
        let terms: Vec<Term> = sums
            .enumerate()
            .rev()
            .filter(|(_, sum)| !sum.is_zero())
            .map(|(index, sum)| (self.monomial(index), sum))
            .collect();
        (terms.len() <= MAX_TERMS).then_some(terms)
    }
}

/// Whether every sum of products of these words fits i128.
fn fits(a: &[(usize, i64)], b: &[(usize, i64)]) -> bool {
    let bits = |terms: &[(usize, i64)]| {
        let largest = terms
            .iter()
            .map(|(_, c)| c.unsigned_abs())
            .max()
            .unwrap_or(0);
        u64::BITS - largest.leading_zeros()
    };
    // At most min(a, b) products meet in one sum.
    bits(a) + bits(b) + (usize::BITS - a.len().min(b.len()).leading_zeros()) <= 126
}

/// What stands for a monomial in a division: in the same order, and as easily multiplied.
trait Key: Copy + Ord {
    fn product(self, other: Self) -> Self;
}

impl Key for Monomial {
    fn product(self, other: Self) -> Self {
        self.times_unchecked(&other)
    }
}

/// The number in a [`Numbering`].
impl Key for u64 {
    fn product(self, other: Self) -> Self {
        self + other
    }
}

/// A product that waits in the division: index in the rest of the divisor, index in the quotient.
type Waiting<K> = (K, usize, usize);

/// The quotient where it is a polynomial with integer coefficients.
pub(super) fn divide(dividend: &[Term], divisor: &[Term]) -> Option<Vec<Term>> {
    let (lead, rest) = divisor.split_first()?;
    let (Some(last), Some(last_of_divisor)) = (dividend.last(), divisor.last()) else {
        return Some(Vec::new());
    };
    if rest.is_empty() {
        let quotients = dividend.iter().map(|(monomial, coefficient)| {
            Some((
                monomial.divided_by(&lead.0)?,
                coefficient.divide_exactly(&lead.1)?,
            ))
        });
        return quotients.collect();
    }
    // Degrees of a quotient are known in advance, and its smallest monomial as well: an attempt
    // that cannot succeed ends early, and no exponent overflows on the way.
    let degrees_of_dividend = degrees(dividend);
    let division = Division {
        dividend,
        lead,
        rest,
        bounds: degrees_of_dividend.divided_by(&degrees(divisor))?,
        smallest: last.0.divided_by(&last_of_divisor.0)?,
    };
    match Numbering::new(&degrees_of_dividend) {
        // Every term of the dividend is a product at least, and a heap takes several times as long
        // for one as a table.
        Some(numbering) if numbering.is_dense(4 * dividend.len()) => {
            division.quotient_by_table(&numbering)
        }
        Some(numbering) => division.quotient_by_heap(|monomial| numbering.key(monomial)),
        None => division.quotient_by_heap(|monomial| *monomial),
    }
}

struct Division<'a> {
    dividend: &'a [Term],
    lead: &'a Term,
    rest: &'a [Term],
    /// The largest exponents of the quotient.
    bounds: Monomial,
    /// Its last monomial.
    smallest: Monomial,
}

impl Division<'_> {
    /// The monomial of the quotient for the largest monomial that is left.
    fn factor(&self, monomial: &Monomial) -> Option<Monomial> {
        let factor = monomial.divided_by(&self.lead.0)?;
        self.bounds.divided_by(&factor)?;
        (factor >= self.smallest).then_some(factor)
    }

    /// What is left of the dividend stands in a table of all its monomials.
    #[expect(
        clippy::indexing_slicing,
        reason = "a product with a monomial of the quotient has no larger exponents than the dividend"
    )]
    fn quotient_by_table(&self, numbering: &Numbering) -> Option<Vec<Term>> {
        let mut left = vec![Coefficient::ZERO; count::from_u64(numbering.size)];
        for (monomial, coefficient) in self.dividend {
            left[numbering.index(monomial)] = coefficient.clone();
        }
        let lead = numbering.index(&self.lead.0);
        let rest = self.rest.iter();
        let rest: Vec<_> = rest.map(|(m, c)| (numbering.index(m), c)).collect();
        let mut quotient = Vec::new();
        for index in (lead..left.len()).rev() {
            if left[index].is_zero() {
                continue;
            }
            let factor = self.factor(&numbering.monomial(index))?;
            let coefficient = left[index].divide_exactly(&self.lead.1)?;
            for (place, c) in &rest {
                left[index - lead + place].sub_product(c, &coefficient);
            }
            quotient.push((factor, coefficient));
        }
        let is_whole = left[..lead].iter().all(Coefficient::is_zero);
        (is_whole && quotient.len() <= MAX_TERMS).then_some(quotient)
    }

    #[expect(
        clippy::indexing_slicing,
        reason = "products wait by the places of their factors, and the divisor has a term beside its first"
    )]
    fn quotient_by_heap<K: Key>(&self, key: impl Fn(&Monomial) -> K) -> Option<Vec<Term>> {
        let keys: Vec<K> = self.rest.iter().map(|term| key(&term.0)).collect();
        let mut quotient: Vec<Term> = Vec::new();
        let mut keys_of_quotient: Vec<K> = Vec::new();
        let mut waiting: BinaryHeap<Waiting<K>> = BinaryHeap::new();
        let mut next = self
            .dividend
            .iter()
            .map(|term| (key(&term.0), term))
            .peekable();
        loop {
            let largest = match (next.peek(), waiting.peek()) {
                (Some((term, _)), Some((product, ..))) => *term.max(product),
                (Some((term, _)), None) => *term,
                (None, Some((product, ..))) => *product,
                (None, None) => return Some(quotient),
            };
            let mut monomial = Monomial::ONE;
            let mut coefficient = Coefficient::ZERO;
            if let Some((_, term)) = next.next_if(|(key, _)| *key == largest) {
                monomial = term.0;
                coefficient = term.1.clone();
            }
            while let Some((_, i, j)) = pop_equal(&mut waiting, largest) {
                monomial = self.rest[i].0.times_unchecked(&quotient[j].0);
                coefficient.sub_product(&self.rest[i].1, &quotient[j].1);
                if let Some(key) = keys.get(i + 1) {
                    waiting.push((key.product(keys_of_quotient[j]), i + 1, j));
                }
            }
            if coefficient.is_zero() {
                continue;
            }
            let factor = self.factor(&monomial)?;
            if quotient.len() >= MAX_TERMS {
                return None;
            }
            let factor_key = key(&factor);
            waiting.push((keys[0].product(factor_key), 0, quotient.len()));
            quotient.push((factor, coefficient.divide_exactly(&self.lead.1)?));
            keys_of_quotient.push(factor_key);
        }
    }
}

fn pop_equal<K: Key>(waiting: &mut BinaryHeap<Waiting<K>>, key: K) -> Option<Waiting<K>> {
    if waiting.peek()?.0 == key {
        waiting.pop()
    } else {
        None
    }
}

/// The polynomial with positive leading coefficient whose square this is.
pub(super) fn square_root(square: &[Term]) -> Option<Vec<Term>> {
    let (Some((first, others)), Some(last)) = (square.split_first(), square.last()) else {
        return Some(Vec::new());
    };
    let lead: Term = (first.0.sqrt()?, first.1.sqrt()?);
    last.1.sqrt()?;
    let smallest = last.0.sqrt()?;
    let bounds = degrees(square).sqrt()?;
    if square.len() == 1 {
        return Some(vec![lead]);
    }
    if ![1, 4]
        .iter()
        .all(|&shift| value_at_integers(square, shift).is_perfect_square())
    {
        return None;
    }
    let mut remainder: BTreeMap<Monomial, Coefficient> = others.iter().cloned().collect();
    let leading = lead.0;
    let twice_lead = lead.1.mul(&Coefficient::Small(2));
    let mut root = vec![lead];
    while let Some((monomial, coefficient)) = remainder.pop_last() {
        let factor = monomial.divided_by(&leading)?;
        bounds.divided_by(&factor)?;
        if factor < smallest || root.len() >= MAX_TERMS {
            return None;
        }
        let term = (factor, coefficient.divide_exactly(&twice_lead)?);
        // (root + term)² = root² + 2·root·term + term²; the leading product is already gone.
        for (m, c) in root.iter().skip(1) {
            let doubled = c.mul(&Coefficient::Small(2));
            subtract(
                &mut remainder,
                m.times_unchecked(&factor),
                &doubled,
                &term.1,
            );
        }
        subtract(
            &mut remainder,
            factor.times_unchecked(&factor),
            &term.1,
            &term.1,
        );
        root.push(term);
    }
    Some(root)
}

fn subtract(
    remainder: &mut BTreeMap<Monomial, Coefficient>,
    monomial: Monomial,
    a: &Coefficient,
    b: &Coefficient,
) {
    let entry = remainder.entry(monomial).or_insert(Coefficient::ZERO);
    entry.sub_product(a, b);
    if entry.is_zero() {
        remainder.remove(&monomial);
    }
}

/// Where polynomials are evaluated to see early that they do not divide or are no squares. Any
/// integers do.
const POINT: [u8; super::monomial::MAX_VARIABLES] = [
    7, 11, 5, 13, 3, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97,
    101, 103, 107, 109, 113, 127, 131, 137,
];

fn point(variable: usize) -> u8 {
    POINT.get(variable).copied().unwrap_or(1)
}

/// The value where every variable is a fixed integer moved by `shift`.
pub(super) fn value_at_integers(a: &[Term], shift: u8) -> Integer {
    let mut sum = Integer::new();
    for (monomial, coefficient) in a {
        let mut value = coefficient.to_integer();
        for (variable, exponent) in monomial.powers() {
            let base = u32::from(point(variable)) + u32::from(shift);
            value *= Integer::from(base).pow(u32::from(exponent));
        }
        sum += value;
    }
    sum
}

/// [`value_at_integers`] with shift 0, modulo a word that is not 0.
pub(super) fn value_modulo(a: &[Term], modulus: u64) -> u64 {
    #[expect(clippy::as_conversions, reason = "a remainder modulo a u64 fits u64")]
    let reduce = |product: u128| (product % u128::from(modulus)) as u64;
    let mut powers: Vec<(usize, Vec<u64>)> = Vec::new();
    for (variable, bound) in degrees(a).powers() {
        let mut power = 1 % modulus;
        let mut table = vec![power];
        for _ in 0..bound {
            power = reduce(u128::from(power) * u128::from(point(variable)));
            table.push(power);
        }
        powers.push((variable, table));
    }
    a.iter().fold(0, |sum, (monomial, coefficient)| {
        let mut value = coefficient.modulo(modulus);
        for (variable, table) in &powers {
            let exponent = usize::from(monomial.exponent(*variable));
            if exponent > 0
                && let Some(power) = table.get(exponent)
            {
                value = reduce(u128::from(value) * u128::from(*power));
            }
        }
        reduce(u128::from(sum) + u128::from(value))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Terms of a polynomial in three variables with small or large coefficients, reproducibly.
    fn sample(count: u64, seed: u64, large: bool) -> Vec<Term> {
        let mut state = seed;
        let mut next = |below: u64| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % below
        };
        let mut sums: BTreeMap<Monomial, Coefficient> = BTreeMap::new();
        for _ in 0..count {
            let powers =
                [0, 9, 31].map(|i| Monomial::power(i, u8::try_from(next(9)).unwrap()).unwrap());
            let monomial = powers
                .iter()
                .fold(Monomial::ONE, |m, power| m.times(power).unwrap());
            let scale = Coefficient::Small(if large { i64::MAX } else { 1 });
            sums.insert(
                monomial,
                Coefficient::Small(i64::try_from(next(200)).unwrap() - 100).mul(&scale),
            );
        }
        sums.into_iter()
            .rev()
            .filter(|(_, c)| !c.is_zero())
            .collect()
    }

    #[test]
    fn all_multiplications_agree() {
        for large in [false, true] {
            let (a, b) = (sample(40, 1, large), sample(30, 2, large));
            let expected = multiply_by_sorting(&a, &b);
            let numbering = Numbering::new(&degrees(&a).times(&degrees(&b)).unwrap()).unwrap();
            assert_eq!(multiply_by_hashing(&a, &b).unwrap(), expected);
            assert_eq!(numbering.multiply(&a, &b).unwrap(), expected);
            assert_eq!(numbering.multiply_coefficients(&a, &b).unwrap(), expected);
            assert_eq!(numbering.multiply_by_keys(&a, &b).unwrap(), expected);
            assert_eq!(multiply(&a, &b).unwrap(), expected);
        }
    }

    #[test]
    fn products_divide_and_their_neighbours_do_not() {
        for large in [false, true] {
            let (a, b) = (sample(40, 3, large), sample(30, 4, large));
            let product = multiply(&a, &b).unwrap();
            assert_eq!(divide(&product, &a).unwrap(), b);
            assert_eq!(divide(&product, &b).unwrap(), a);
            let one = [(Monomial::ONE, Coefficient::ONE)];
            assert_eq!(divide(&add(&product, &one).unwrap(), &a), None);
            assert_eq!(divide(&[], &a), Some(Vec::new()));
            assert_eq!(divide(&a, &[]), None);
        }
    }

    #[test]
    fn both_divisions_agree() {
        let one = [(Monomial::ONE, Coefficient::ONE)];
        for large in [false, true] {
            let (a, b) = (sample(40, 7, large), sample(30, 8, large));
            let product = multiply(&a, &b).unwrap();
            for dividend in [&product, &add(&product, &one).unwrap()] {
                let degrees_of_dividend = degrees(dividend);
                let division = Division {
                    dividend,
                    lead: &a[0],
                    rest: &a[1..],
                    bounds: degrees_of_dividend.divided_by(&degrees(&a)).unwrap(),
                    smallest: Monomial::ONE,
                };
                let numbering = Numbering::new(&degrees_of_dividend).unwrap();
                let quotient = division.quotient_by_table(&numbering);
                assert_eq!(quotient, division.quotient_by_heap(|m| numbering.key(m)));
                assert_eq!(quotient, division.quotient_by_heap(|m| *m));
                assert_eq!(quotient.is_some(), *dividend == product);
            }
        }
    }

    #[test]
    fn squares_and_their_neighbours() {
        for large in [false, true] {
            let a = sample(40, 5, large);
            let square = multiply(&a, &a).unwrap();
            let root = square_root(&square).unwrap();
            assert!(root == a || root == scale(&a, &Coefficient::Small(-1)));
            let one = [(Monomial::ONE, Coefficient::ONE)];
            assert_eq!(square_root(&add(&square, &one).unwrap()), None);
            assert_eq!(square_root(&scale(&square, &Coefficient::Small(-1))), None);
        }
    }

    #[test]
    fn values_modulo_a_word_are_those_of_integers() {
        let a = sample(40, 6, true);
        let modulus = 1_000_000_007;
        let value = Coefficient::from(value_at_integers(&a, 0));
        assert_eq!(value_modulo(&a, modulus), value.modulo(modulus));
    }
}
