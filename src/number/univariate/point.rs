//! Complex floats, for proposals that are proven afterwards.

use rug::Float;
use rug::ops::NegAssign;

/// A complex number.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub re: Float,
    pub im: Float,
}

impl Point {
    pub fn zero(bits: u32) -> Point {
        Point {
            re: Float::new(bits),
            im: Float::new(bits),
        }
    }

    pub fn with_bits(mut self, bits: u32) -> Point {
        self.re.set_prec(bits);
        self.im.set_prec(bits);
        self
    }

    pub fn add(&mut self, other: &Point) {
        self.re += &other.re;
        self.im += &other.im;
    }

    pub fn minus(&self, other: &Point, bits: u32) -> Point {
        Point {
            re: Float::with_val(bits, &self.re - &other.re),
            im: Float::with_val(bits, &self.im - &other.im),
        }
    }

    pub fn times(&self, other: &Point, bits: u32) -> Point {
        Point {
            re: Float::with_val(bits, &self.re * &other.re - &self.im * &other.im),
            im: Float::with_val(bits, &self.re * &other.im + &self.im * &other.re),
        }
    }

    fn norm(&self, bits: u32) -> Float {
        Float::with_val(bits, &self.re * &self.re + &self.im * &self.im)
    }

    pub fn inverse(mut self, bits: u32) -> Point {
        let norm = self.norm(bits);
        self.re /= &norm;
        self.im /= norm;
        self.im.neg_assign();
        self
    }

    pub fn is_finite(&self) -> bool {
        self.re.is_finite() && self.im.is_finite()
    }

    /// An upper bound of |z|, at most √2 too large.
    pub fn size(&self) -> Float {
        Float::with_val(32, self.re.abs_ref()) + Float::with_val(32, self.im.abs_ref())
    }
}
