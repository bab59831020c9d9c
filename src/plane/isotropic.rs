//! Algebraic curves in isotropic coordinates z = x + iy, z̄ = x − iy.

use super::Point;
use crate::number::{Kind, Number, Truth};

/// A polynomial Σ cⱼₖ zʲ z̄ᵏ.
#[derive(Clone, Debug)]
pub struct Polynomial<K> {
    /// The coefficient of zʲ z̄ᵏ at `[j][k]`; all rows are equally long.
    rows: Vec<Vec<Point<K>>>,
}

impl<K: Kind> Polynomial<K> {
    fn from_fn((rows, columns): (usize, usize), entry: impl Fn(usize, usize) -> Point<K>) -> Self {
        let row = |j| (0..columns).map(|k| entry(j, k)).collect();
        Polynomial {
            rows: (0..rows).map(row).collect(),
        }
    }

    fn size(&self) -> (usize, usize) {
        (self.rows.len(), self.rows.first().map_or(0, Vec::len))
    }

    /// A constant.
    pub fn constant(value: Point<K>) -> Self {
        Self::from_fn((1, 1), |_, _| value.clone())
    }

    /// z − a.
    pub fn z_minus(a: &Point<K>) -> Self {
        Self::linear(Number::one(), -a)
    }

    /// a z + b.
    pub fn linear(a: Point<K>, b: Point<K>) -> Self {
        Polynomial {
            rows: vec![vec![b], vec![a]],
        }
    }

    /// The polynomial whose values are the conjugate ones: z and z̄ change places.
    pub fn conj(&self) -> Self {
        let (rows, columns) = self.size();
        Self::from_fn((columns, rows), |j, k| self.coefficient(k, j).conj())
    }

    /// The coefficient of zʲ z̄ᵏ.
    pub fn coefficient(&self, j: usize, k: usize) -> Point<K> {
        let row = self.rows.get(j);
        row.and_then(|row| row.get(k))
            .cloned()
            .unwrap_or_else(Number::zero)
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        let ((a, b), (c, d)) = (self.size(), other.size());
        Self::from_fn((a.max(c), b.max(d)), |j, k| {
            self.coefficient(j, k) + other.coefficient(j, k)
        })
    }

    /// The difference.
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.times(&Self::constant(Number::from(-1))))
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        let ((a, b), (c, d)) = (self.size(), other.size());
        Self::from_fn((a + c - 1, b + d - 1), |j, k| {
            let mut sum = Number::zero();
            for (j1, row) in self.rows.iter().enumerate().take(j + 1) {
                for (k1, entry) in row.iter().enumerate().take(k + 1) {
                    sum += entry * other.coefficient(j - j1, k - k1);
                }
            }
            sum
        })
    }

    /// The value at a point.
    pub fn at(&self, z: &Point<K>) -> Point<K> {
        let conj = z.conj();
        // Horner in z, and in each row in z̄.
        self.rows.iter().rev().fold(Number::zero(), |sum, row| {
            let value = (row.iter().rev()).fold(Number::zero(), |sum, c| sum * &conj + c);
            sum * z + value
        })
    }

    /// Whether all terms of this order vanish, for all values of the parameters.
    pub fn has_no_term_of_order(&self, order: usize) -> Truth {
        Truth::all((0..=order).map(|j| self.coefficient(j, order - j).is_zero()))
    }

    /// The order of the curve on which the polynomial vanishes: the highest with a term that is not
    /// zero; `None` for the zero polynomial and where that cannot be told.
    pub fn order(&self) -> Option<usize> {
        let (rows, columns) = self.size();
        for order in (0..rows + columns).rev() {
            match self.has_no_term_of_order(order) {
                Truth::Yes => {}
                Truth::No => return Some(order),
                Truth::Unknown => return None,
            }
        }
        None
    }

    /// Whether two polynomials are the same.
    pub fn equals(&self, other: &Self) -> Truth {
        let difference = self.minus(other);
        Truth::all(difference.rows.iter().flatten().map(Number::is_zero))
    }
}
