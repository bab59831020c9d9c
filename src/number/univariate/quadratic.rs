//! Quadratic equations over any real kind, with every special case.

use std::cmp::Ordering;

use crate::number::{Complex, Number, Real, Truth};

/// a x² + b x + c, where a, and b too, may vanish.
#[derive(Clone, Debug)]
pub struct Quadratic<K> {
    /// Coefficient of x².
    pub a: Number<K>,
    /// Coefficient of x.
    pub b: Number<K>,
    /// Constant coefficient.
    pub c: Number<K>,
}

/// The roots of a [`Quadratic`]. Which case it is, is proven; a root may still have no value where
/// the arithmetic does not hold the square root.
#[derive(Clone, Debug)]
pub enum QuadraticRoots<K> {
    /// It cannot be told which case it is.
    Undecided,
    /// a = b = c = 0: every number is a root.
    Every,
    /// a = b = 0, c ≠ 0: no root.
    None,
    /// a = 0, b ≠ 0: one root, the other one is infinite.
    Single(Number<K>),
    /// Two real roots, ascending.
    Real([Number<K>; 2]),
    /// One real root of multiplicity two.
    Double(Number<K>),
    /// Two conjugate complex roots; this is the one with positive imaginary part.
    Conjugate(Number<Complex<K>>),
}

impl<K: Real> Quadratic<K> {
    /// a x² + b x + c.
    pub fn new(a: Number<K>, b: Number<K>, c: Number<K>) -> Self {
        Quadratic { a, b, c }
    }

    /// b² − 4 a c.
    pub fn discriminant(&self) -> Number<K> {
        self.b.square() - 4 * &self.a * &self.c
    }

    /// The roots, with the proven case.
    pub fn roots(&self) -> QuadraticRoots<K> {
        match self.a.is_zero() {
            Truth::Unknown => QuadraticRoots::Undecided,
            Truth::Yes => self.linear(),
            Truth::No => self.proper(),
        }
    }

    /// The two real roots as fractions (x, w) of x/w, for a discriminant that is surely positive,
    /// whether a vanishes or not: a root at infinity has w = 0. For b = 0 or an unknown sign of b
    /// only where a is surely not zero. `None` where nothing of this is sure.
    pub fn real_points(&self) -> Option<[(Number<K>, Number<K>); 2]> {
        let discriminant = self.discriminant();
        if discriminant.sign() != Some(Ordering::Greater) {
            return None;
        }
        let root = discriminant.sqrt();
        // The sum of two numbers of one sign loses nothing.
        let far = match self.b.sign() {
            Some(Ordering::Greater) => -(&self.b + &root) / 2,
            Some(Ordering::Less) => (&root - &self.b) / 2,
            _ if self.a.is_zero().is_no() => {
                let twice = 2 * &self.a;
                let points = [-&self.b - &root, root - &self.b];
                return Some(points.map(|x| (x, twice.clone())));
            }
            _ => return None,
        };
        Some([(far.clone(), self.a.clone()), (self.c.clone(), far)])
    }

    fn linear(&self) -> QuadraticRoots<K> {
        match (self.b.is_zero(), self.c.is_zero()) {
            (Truth::No, _) => QuadraticRoots::Single(-&self.c / &self.b),
            (Truth::Yes, Truth::Yes) => QuadraticRoots::Every,
            (Truth::Yes, Truth::No) => QuadraticRoots::None,
            _ => QuadraticRoots::Undecided,
        }
    }

    fn proper(&self) -> QuadraticRoots<K> {
        let discriminant = self.discriminant();
        let twice = 2 * &self.a;
        match discriminant.sign() {
            None => QuadraticRoots::Undecided,
            Some(Ordering::Equal) => QuadraticRoots::Double(-&self.b / twice),
            Some(Ordering::Less) => {
                let im = (-discriminant).sqrt() / twice.abs();
                QuadraticRoots::Conjugate(Number::complex(-&self.b / twice, im))
            }
            Some(Ordering::Greater) => self.two_real_roots(),
        }
    }

    fn two_real_roots(&self) -> QuadraticRoots<K> {
        let Some([(x, w), (y, v)]) = self.real_points() else {
            return QuadraticRoots::Undecided;
        };
        // With (far/a, c/far): for a > 0 the far root is below the other one where b > 0, and above
        // it where b < 0; a < 0 turns that round. For b = 0 the first one has −√.
        let far_is_lower = self.b.sign() != Some(Ordering::Less);
        let a_is_positive = self.a.sign() == Some(Ordering::Greater);
        let roots = [x / w, y / v];
        if far_is_lower == a_is_positive {
            return QuadraticRoots::Real(roots);
        }
        let [first, second] = roots;
        QuadraticRoots::Real([second, first])
    }
}
