//! `+ − ×` of polynomials, owned or borrowed.

use std::ops::{Add, Mul, Neg, Sub};

use super::Polynomial;
use crate::number::Kind;

fn sum<K: Kind>(a: &Polynomial<K>, b: &Polynomial<K>) -> Polynomial<K> {
    let (long, short) = if a.coefficients().len() < b.coefficients().len() {
        (b, a)
    } else {
        (a, b)
    };
    let mut coefficients = long.coefficients().to_vec();
    for (sum, term) in coefficients.iter_mut().zip(short.coefficients()) {
        *sum += term;
    }
    Polynomial::new(coefficients)
}

fn difference<K: Kind>(a: &Polynomial<K>, b: &Polynomial<K>) -> Polynomial<K> {
    sum(a, &-b)
}

fn product<K: Kind>(a: &Polynomial<K>, b: &Polynomial<K>) -> Polynomial<K> {
    let (Some(m), Some(n)) = (a.degree(), b.degree()) else {
        return Polynomial::zero();
    };
    let (a, b) = (a.coefficients(), b.coefficients());
    let coefficient = |power: usize| {
        let first = power.saturating_sub(n);
        let left = a.iter().skip(first).take(power + 1 - first);
        let right = b.iter().take(power - first + 1).rev();
        left.zip(right).map(|(left, right)| left * right).sum()
    };
    Polynomial::new((0..=m + n).map(coefficient).collect())
}

impl<K: Kind> Neg for &Polynomial<K> {
    type Output = Polynomial<K>;
    fn neg(self) -> Polynomial<K> {
        self.map(|coefficient| -coefficient)
    }
}

impl<K: Kind> Neg for Polynomial<K> {
    type Output = Polynomial<K>;
    fn neg(self) -> Polynomial<K> {
        -&self
    }
}

/// One operator in all forms of owned and borrowed operands.
macro_rules! operator {
    ($op:ident, $method:ident, $compute:ident) => {
        operator!($op, $method, $compute, Polynomial<K>, Polynomial<K>);
        operator!($op, $method, $compute, &Polynomial<K>, Polynomial<K>);
        operator!($op, $method, $compute, Polynomial<K>, &Polynomial<K>);
        operator!($op, $method, $compute, &Polynomial<K>, &Polynomial<K>);
    };
    ($op:ident, $method:ident, $compute:ident, $left:ty, $right:ty) => {
        impl<K: Kind> $op<$right> for $left {
            type Output = Polynomial<K>;
            fn $method(self, other: $right) -> Polynomial<K> {
                $compute(&self, &other)
            }
        }
    };
}

operator!(Add, add, sum);
operator!(Sub, sub, difference);
operator!(Mul, mul, product);
