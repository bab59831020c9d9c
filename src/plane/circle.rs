//! Circles, and the lines among them.

use super::Point;
use super::projective::Line;
use crate::number::{Kind, Number, Truth};

/// a (x² + y²) + b x + c y + d = 0, up to a common factor: a circle, for a = 0 a line. Its squared
/// radius may be zero (a point) or negative (no real point).
#[derive(Clone, Debug)]
pub struct Circle<K> {
    /// Of x² + y²; zero for a line.
    pub a: Number<K>,
    /// Of x.
    pub b: Number<K>,
    /// Of y.
    pub c: Number<K>,
    /// The constant.
    pub d: Number<K>,
}

impl<K: Kind> Circle<K> {
    /// The circle about a point; the squared radius may have any sign.
    pub fn about(center: &Point<K>, squared_radius: &Number<K>) -> Self {
        Circle {
            a: Number::one(),
            b: -2 * center.re(),
            c: -2 * center.im(),
            d: center.norm() - squared_radius,
        }
    }

    /// The circle through three points, the line where they are collinear. Where two coincide, all
    /// coefficients vanish.
    pub fn through(p: &Point<K>, q: &Point<K>, r: &Point<K>) -> Self {
        // Seen from P, so that the determinants have two rows only; then moved back.
        let (u, v) = (q - p, r - p);
        let (u2, v2) = (u.norm(), v.norm());
        let a = u.re() * v.im() - u.im() * v.re();
        let b = u.im() * &v2 - v.im() * &u2;
        let c = v.re() * &u2 - u.re() * &v2;
        let d = &a * p.norm() - &b * p.re() - &c * p.im();
        Circle {
            b: b - 2 * &a * p.re(),
            c: c - 2 * &a * p.im(),
            a,
            d,
        }
    }

    /// a (x² + y²) + b x + c y + d, zero on the circle.
    pub fn at(&self, point: &Point<K>) -> Number<K> {
        &self.a * point.norm() + &self.b * point.re() + &self.c * point.im() + &self.d
    }

    /// Whether not all coefficients vanish.
    pub fn is_determined(&self) -> Truth {
        let Circle { a, b, c, d } = self;
        !Truth::all([a, b, c, d].map(Number::is_zero))
    }

    /// Whether a point lies on the circle; unknown where all coefficients vanish.
    pub fn contains(&self, point: &Point<K>) -> Truth {
        match (self.is_determined(), self.at(point).is_zero()) {
            (Truth::Yes, on) => on,
            (_, Truth::No) => Truth::No,
            _ => Truth::Unknown,
        }
    }

    /// Whether this is a line: a = 0.
    pub fn is_line(&self) -> Truth {
        self.a.is_zero()
    }

    /// −(b + ic)/(2a); no value for a line.
    pub fn center(&self) -> Point<K> {
        let double = -2 * &self.a;
        Number::complex(&self.b / &double, &self.c / &double)
    }

    /// (b² + c² − 4ad)/(4a²); no value for a line.
    pub fn squared_radius(&self) -> Number<K> {
        self.product(self) / (4 * self.a.square())
    }

    /// The power of a point, its squared distance from the center less the squared radius; no value
    /// for a line.
    pub fn power(&self, point: &Point<K>) -> Number<K> {
        self.at(point) / &self.a
    }

    /// The tangent at a point of the circle; at any other point, its polar.
    pub fn tangent(&self, point: &Point<K>) -> Line<K> {
        let Circle { a, b, c, d } = self;
        let (x, y) = (point.re(), point.im());
        Line::new(2 * a * x + b, 2 * a * y + c, b * x + c * y + 2 * d)
    }

    /// b₁b₂ + c₁c₂ − 2(a₁d₂ + a₂d₁): for circles 2a₁a₂(r₁² + r₂² − e²), e the distance of the centers.
    fn product(&self, other: &Self) -> Number<K> {
        &self.b * &other.b + &self.c * &other.c - 2 * (&self.a * &other.d + &other.a * &self.d)
    }

    /// Whether two circles meet at right angles: r₁² + r₂² = e² for centers at distance e. A line is
    /// orthogonal to the circles about its points.
    pub fn is_orthogonal_to(&self, other: &Self) -> Truth {
        self.product(other).is_zero()
    }

    /// Whether two circles touch (from outside or inside), (r₁² + r₂² − e²)² = 4r₁²r₂²; parallel lines
    /// touch at infinity, and a circle touches itself.
    pub fn touches(&self, other: &Self) -> Truth {
        let squares = self.product(self) * other.product(other);
        self.product(other).square().equals(&squares)
    }

    /// The line of the points with equal power for both circles; the line at infinity for circles of
    /// one center, not determined for equal circles and for two lines.
    pub fn radical_line(&self, other: &Self) -> Line<K> {
        Line::new(
            &other.a * &self.b - &self.a * &other.b,
            &other.a * &self.c - &self.a * &other.c,
            &other.a * &self.d - &self.a * &other.d,
        )
    }
}
