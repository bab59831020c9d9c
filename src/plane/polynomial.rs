//! Polynomials in the coordinates x and y.

use super::circular_cubic::Cubic;
use crate::number::{Kind, Number, Truth, array, count};

/// Σ cⱼₖ xʲ yᵏ, j + k at most the order.
#[derive(Clone, Debug)]
pub struct Polynomial<K> {
    order: usize,
    /// By falling order j + k, and among those by falling j, as the coefficients of a [`Cubic`].
    coefficients: Vec<Number<K>>,
}

/// Where the terms of an order begin.
fn start(order: usize, part: usize) -> usize {
    // Orders order, …, part + 1 have order + 1, …, part + 2 terms.
    (part + 1..=order).map(|n| n + 1).sum()
}

/// The determinant of three rows.
pub fn determinant<K: Kind>(rows: &[[Polynomial<K>; 3]; 3]) -> Polynomial<K> {
    // Without fractions, where they are slow: each row times its denominator.
    let denominators = rows.each_ref().map(|row| {
        let coefficients = row.iter().flat_map(|polynomial| &polynomial.coefficients);
        K::common_denominator(coefficients.map(|c| &c.0)).map(Number)
    });
    if denominators.iter().all(Option::is_none) {
        return expanded(rows);
    }
    let factors = denominators.map(|denominator| denominator.unwrap_or_else(Number::one));
    let whole = array::pairs(rows, &factors);
    let whole = whole.map(|(row, factor)| row.each_ref().map(|entry| entry.scaled(factor)));
    let product: Number<K> = factors.into_iter().product();
    expanded(&whole).scaled(&product.inverse())
}

fn expanded<K: Kind>([p, q, r]: &[[Polynomial<K>; 3]; 3]) -> Polynomial<K> {
    let ([q0, q1, q2], [r0, r1, r2]) = (q, r);
    let minors = [(q1, r2, q2, r1), (q2, r0, q0, r2), (q0, r1, q1, r0)];
    let [m0, m1, m2] = minors.map(|(a, b, c, d)| a.times(b).minus(&c.times(d)));
    let sum = p[0].times(&m0).plus(&p[1].times(&m1));
    sum.plus(&p[2].times(&m2))
}

impl<K: Kind> From<&Cubic<K>> for Polynomial<K> {
    fn from(cubic: &Cubic<K>) -> Self {
        Polynomial {
            order: 3,
            coefficients: cubic.coefficients().to_vec(),
        }
    }
}

impl<K: Kind> Polynomial<K> {
    /// a x + b y + c.
    pub fn linear(a: Number<K>, b: Number<K>, c: Number<K>) -> Self {
        Polynomial {
            order: 1,
            coefficients: vec![a, b, c],
        }
    }

    /// a (x² + y²) + b x + c y + d.
    pub fn circle(a: Number<K>, b: Number<K>, c: Number<K>, d: Number<K>) -> Self {
        Polynomial {
            order: 2,
            coefficients: vec![a.clone(), Number::zero(), a, b, c, d],
        }
    }

    /// The order, an upper bound of it where the highest terms vanish.
    pub fn order(&self) -> usize {
        self.order
    }

    /// By falling order j + k, and among those by falling j, as the coefficients of a [`Cubic`].
    pub fn coefficients(&self) -> &[Number<K>] {
        &self.coefficients
    }

    /// j, k and cⱼₖ of all terms, by falling order.
    pub fn terms(&self) -> impl Iterator<Item = (usize, usize, &Number<K>)> {
        let exponents = (0..=self.order)
            .rev()
            .flat_map(|n| (0..=n).rev().map(move |j| (j, n - j)));
        exponents
            .zip(&self.coefficients)
            .map(|((j, k), coefficient)| (j, k, coefficient))
    }

    /// The value in a point.
    pub fn at(&self, x: &Number<K>, y: &Number<K>) -> Number<K> {
        // In each power of x by Horner's rule in y, then the same in x.
        let rows = (0..=self.order).rev().map(|j| {
            let of_row = (0..=self.order - j).rev();
            of_row.fold(Number::zero(), |sum, k| {
                let term = self.part(j + k).get(k);
                sum * y + term.cloned().unwrap_or_else(Number::zero)
            })
        });
        rows.fold(Number::zero(), |sum, row| sum * x + row)
    }

    /// The derivatives with respect to x and to y.
    pub fn gradient(&self) -> [Self; 2] {
        let order = self.order.saturating_sub(1);
        let mut both = [Self::zero(order), Self::zero(order)];
        for (j, k, coefficient) in self.terms() {
            let n = (j + k).saturating_sub(1);
            // Terms of one order stand by falling j, that is by growing k.
            for (derivative, exponent, place) in [(0, j, k), (1, k, k.saturating_sub(1))] {
                let sum = both
                    .get_mut(derivative)
                    .filter(|_| exponent > 0)
                    .and_then(|of| of.coefficients.get_mut(start(order, n) + place));
                if let Some(sum) = sum {
                    *sum += count::to_i64(exponent) * coefficient;
                }
            }
        }
        both
    }

    /// All xʲ yᵏ with j + k at most the order.
    pub fn monomials(order: usize) -> Vec<Self> {
        let count = start(order, 0) + 1;
        let monomial = |place: usize| {
            let mut monomial = Self::zero(order);
            if let Some(coefficient) = monomial.coefficients.get_mut(place) {
                *coefficient = Number::one();
            }
            monomial
        };
        (0..count).map(monomial).collect()
    }

    /// This times a number.
    pub fn scaled(&self, factor: &Number<K>) -> Self {
        Polynomial {
            order: self.order,
            coefficients: self.coefficients.iter().map(|c| c * factor).collect(),
        }
    }

    /// Whether all coefficients vanish for sure.
    pub fn is_zero(&self) -> bool {
        self.coefficients.iter().all(|c| c.is_zero().is_yes())
    }

    /// The same of the lowest order possible: without the line at infinity as a part.
    pub fn finite_part(mut self) -> Self {
        while self.order > 0 && self.part(self.order).iter().all(|c| c.is_zero().is_yes()) {
            self.coefficients.drain(..=self.order);
            self.order -= 1;
        }
        self
    }

    /// The polynomial that vanishes everywhere.
    pub fn zero(order: usize) -> Self {
        Polynomial {
            order,
            coefficients: vec![Number::zero(); start(order, 0) + 1],
        }
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::zero(self.order + other.order);
        for n in 0..=self.order {
            for m in 0..=other.order {
                let rows = (self.part(n), other.part(m));
                let place = start(product.order, n + m);
                for (k, left) in rows.0.iter().enumerate() {
                    let sums = product.coefficients.iter_mut().skip(place + k);
                    for (sum, right) in sums.zip(rows.1) {
                        *sum += left * right;
                    }
                }
            }
        }
        product
    }

    /// The terms of order n, by falling powers of x.
    fn part(&self, n: usize) -> &[Number<K>] {
        let place = start(self.order, n);
        self.coefficients
            .get(place..place + n + 1)
            .unwrap_or_default()
    }

    /// The sum of two polynomials of one order.
    pub fn plus(mut self, other: &Self) -> Self {
        for n in 0..=self.order.min(other.order) {
            let place = start(self.order, n);
            for (sum, term) in (self.coefficients.iter_mut().skip(place)).zip(other.part(n)) {
                *sum += term;
            }
        }
        self
    }

    /// The difference of two polynomials of one order.
    pub fn minus(mut self, other: &Self) -> Self {
        for n in 0..=self.order.min(other.order) {
            let place = start(self.order, n);
            for (sum, term) in (self.coefficients.iter_mut().skip(place)).zip(other.part(n)) {
                *sum -= term;
            }
        }
        self
    }

    /// As a cubic; `None` where a term of higher order is known not to vanish.
    pub fn to_cubic(&self) -> Option<Cubic<K>> {
        let higher = (4..=self.order).flat_map(|n| self.part(n));
        if Truth::all(higher.map(Number::is_zero)).is_no() && !K::ROUNDS {
            return None;
        }
        let mut coefficients = std::array::from_fn(|_| Number::zero());
        for n in 0..=self.order.min(3) {
            let places = coefficients.iter_mut().skip(start(3, n));
            for (place, term) in places.zip(self.part(n)) {
                *place = term.clone();
            }
        }
        Some(Cubic::new(coefficients))
    }
}
