//! Power products, packed: one byte for each variable.

/// How many variables a ring can have.
pub(super) const MAX_VARIABLES: usize = 32;

/// The largest exponent. The eighth bit of a byte stays free: it shows overflow and borrow.
const MAX_EXPONENT: u8 = 127;

const WORDS: usize = MAX_VARIABLES / 8;
const GUARDS: u64 = 0x8080_8080_8080_8080;

/// A power product of up to 32 variables with exponents up to 127.
///
/// The order is lexicographic with later variables first, so that it is compatible with products
/// and does not change when a ring is extended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Monomial([u64; WORDS]);

/// Where the byte of a variable lies; the last variables fill the first word. `None` for one that no
/// ring can have.
fn place(variable: usize) -> Option<(usize, usize)> {
    let word = (WORDS - 1).checked_sub(variable / 8)?;
    Some((word, 8 * (variable % 8)))
}

impl Monomial {
    pub const ONE: Self = Monomial([0; WORDS]);

    /// `variable^exponent`; `None` for an exponent that cannot be stored.
    pub fn power(variable: usize, exponent: u8) -> Option<Self> {
        if exponent > MAX_EXPONENT {
            return None;
        }
        let mut words = [0; WORDS];
        let (word, shift) = place(variable)?;
        *words.get_mut(word)? = u64::from(exponent) << shift;
        Some(Monomial(words))
    }

    /// The exponent of a variable; 0 for one that no ring can have.
    pub fn exponent(&self, variable: usize) -> u8 {
        let byte = |(word, shift): (usize, usize)| -> Option<u8> {
            let [byte, ..] = (self.0.get(word)? >> shift).to_le_bytes();
            Some(byte)
        };
        place(variable).and_then(byte).unwrap_or(0)
    }

    /// This with every power of a variable taken out.
    pub fn without(&self, variable: usize) -> Self {
        let mut result = *self;
        if let Some((word, shift)) = place(variable)
            && let Some(word) = result.0.get_mut(word)
        {
            *word &= !(0xff << shift);
        }
        result
    }

    #[expect(
        clippy::indexing_slicing,
        reason = "there is a word in both for every one of the result"
    )]
    fn zip(&self, other: &Self, combine: impl Fn(u64, u64) -> u64) -> Self {
        Monomial(std::array::from_fn(|i| combine(self.0[i], other.0[i])))
    }

    /// The product; `None` where an exponent overflows.
    pub fn times(&self, other: &Self) -> Option<Self> {
        let product = self.times_unchecked(other);
        product
            .0
            .iter()
            .all(|word| word & GUARDS == 0)
            .then_some(product)
    }

    /// The product of two monomials of which it is known that no exponent overflows.
    #[inline]
    pub fn times_unchecked(&self, other: &Self) -> Self {
        self.zip(other, u64::wrapping_add)
    }

    /// The quotient where it is a monomial.
    #[inline]
    pub fn divided_by(&self, other: &Self) -> Option<Self> {
        let difference = self.zip(other, |a, b| (a | GUARDS).wrapping_sub(b));
        (difference.0.iter().all(|word| word & GUARDS == GUARDS))
            .then(|| Monomial(difference.0.map(|word| word & !GUARDS)))
    }

    /// The bytes of the first where they are at least those of the second, else of the third.
    #[expect(
        clippy::indexing_slicing,
        reason = "all four have as many words as the result"
    )]
    fn choose(&self, other: &Self, [greater, less]: [&Self; 2]) -> Self {
        Monomial(std::array::from_fn(|i| {
            // The guard of a byte stays where nothing is borrowed.
            let kept = (self.0[i] | GUARDS).wrapping_sub(other.0[i]) & GUARDS;
            let mask = kept | (kept - (kept >> 7));
            (greater.0[i] & mask) | (less.0[i] & !mask)
        }))
    }

    /// The least common multiple.
    pub fn lcm(&self, other: &Self) -> Self {
        self.choose(other, [self, other])
    }

    /// The greatest common divisor.
    pub fn gcd(&self, other: &Self) -> Self {
        self.choose(other, [other, self])
    }

    /// The monomial whose square this is.
    pub fn sqrt(&self) -> Option<Self> {
        const LOWEST: u64 = GUARDS >> 7;
        (self.0.iter().all(|word| word & LOWEST == 0))
            .then(|| Monomial(self.0.map(|word| word >> 1)))
    }

    /// The variables with an exponent above 0, in rising order, with that exponent.
    pub fn powers(self) -> impl Iterator<Item = (usize, u8)> {
        (0..MAX_VARIABLES)
            .map(move |variable| (variable, self.exponent(variable)))
            .filter(|&(_, exponent)| exponent > 0)
    }

    /// Bits that are set where the given variables have an exponent above 1.
    pub fn mask_above_one(variables: impl Iterator<Item = usize>) -> Self {
        Self::mask(variables, MAX_EXPONENT - 1)
    }

    /// Bits that are set where the given variables have an exponent above 0.
    pub fn mask_above_zero(variables: impl Iterator<Item = usize>) -> Self {
        Self::mask(variables, MAX_EXPONENT)
    }

    fn mask(variables: impl Iterator<Item = usize>, bits: u8) -> Self {
        variables
            .filter_map(|variable| Self::power(variable, bits))
            .fold(Self::ONE, |mask, one| mask.zip(&one, |a, b| a | b))
    }

    /// Whether any bit of a mask is set.
    #[inline]
    pub fn meets(&self, mask: &Self) -> bool {
        self.0
            .iter()
            .zip(&mask.0)
            .any(|(word, mask)| word & mask != 0)
    }

    /// All bits mixed into one word, for hashing.
    pub fn mixed(&self) -> u64 {
        self.0.iter().fold(0, |hash: u64, word| {
            (hash.rotate_left(26) ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_overflow_into_no_value() {
        let big = Monomial::power(7, 100).unwrap();
        assert_eq!(big.times(&big), None);
        assert_eq!(Monomial::power(7, 128), None);
        assert_eq!(Monomial::power(32, 1), None);
    }

    #[test]
    fn multiples_and_divisors_go_byte_by_byte() {
        let product = |exponents: &[u8]| {
            let powers = exponents.iter().zip([0, 1, 7, 8, 31]);
            powers.fold(Monomial::ONE, |product, (exponent, variable)| {
                product
                    .times(&Monomial::power(variable, *exponent).unwrap())
                    .unwrap()
            })
        };
        let (a, b) = (product(&[3, 0, 127, 126, 5]), product(&[2, 1, 126, 127, 5]));
        for (a, b) in [(a, b), (b, a)] {
            assert_eq!(a.lcm(&b), product(&[3, 1, 127, 127, 5]));
            assert_eq!(a.gcd(&b), product(&[2, 0, 126, 126, 5]));
        }
    }

    #[test]
    fn later_variables_are_larger() {
        let [x, y, z] = [0, 7, 8].map(|i| Monomial::power(i, 1).unwrap());
        assert!(x < y && y < z);
        assert!(x.times(&y).unwrap() < z);
        assert_eq!(z.times(&y).unwrap().divided_by(&y), Some(z));
        assert_eq!(z.divided_by(&y), None);
    }
}
