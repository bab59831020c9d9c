//! The projective plane: points at infinity and the line at infinity are like all others.

use super::Point;
use crate::number::{Kind, Number, Truth};

type Triple<K> = [Number<K>; 3];

fn cross<K: Kind>([a, b, c]: &Triple<K>, [x, y, z]: &Triple<K>) -> Triple<K> {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn dot<K: Kind>(left: &Triple<K>, right: &Triple<K>) -> Number<K> {
    left.iter().zip(right).map(|(a, b)| a * b).sum()
}

fn all_zero<K: Kind>(triple: &Triple<K>) -> Truth {
    Truth::all(triple.iter().map(Number::is_zero))
}

/// A relation that vanishing coordinates would satisfy by themselves holds only where it is known
/// that they do not vanish.
fn provided(determined: Truth, relation: Truth) -> Truth {
    match (determined, relation) {
        (Truth::Yes, _) | (_, Truth::No) => relation,
        _ => Truth::Unknown,
    }
}

/// [x : y : w] up to a common factor: the finite point (x/w, y/w), for w = 0 the point at infinity
/// in the direction (x, y). [0 : 0 : 0] is no point; predicates on it answer unknown.
#[derive(Clone, Debug)]
pub struct ProjectivePoint<K>(Triple<K>);

impl<K: Kind> ProjectivePoint<K> {
    /// [x : y : w], real coordinates.
    pub fn new(x: Number<K>, y: Number<K>, w: Number<K>) -> Self {
        ProjectivePoint([x, y, w])
    }

    /// The finite point x + iy, as [x : y : 1].
    pub fn from_finite(point: &Point<K>) -> Self {
        Self::new(point.re().clone(), point.im().clone(), Number::one())
    }

    /// The point at infinity in a direction that is not zero; the opposite direction leads to the
    /// same point.
    pub fn from_direction(direction: &Point<K>) -> Self {
        Self::new(
            direction.re().clone(),
            direction.im().clone(),
            Number::zero(),
        )
    }

    /// x, y and w.
    pub fn coordinates(&self) -> &[Number<K>; 3] {
        &self.0
    }

    /// Whether not all coordinates vanish.
    pub fn is_determined(&self) -> Truth {
        !all_zero(&self.0)
    }

    /// Whether w ≠ 0; unknown for [0 : 0 : 0].
    pub fn is_finite(&self) -> Truth {
        !self.is_at_infinity()
    }

    /// Whether w = 0; unknown for [0 : 0 : 0].
    pub fn is_at_infinity(&self) -> Truth {
        provided(self.is_determined(), self.0[2].is_zero())
    }

    /// (x/w, y/w); `None` where it is not known that the point is finite.
    pub fn finite(&self) -> Option<Point<K>> {
        let [x, y, w] = &self.0;
        (self.is_finite().is_yes() && w.has_value()).then(|| Number::complex(x / w, y / w))
    }

    /// The same point as [x/w : y/w : 1], where it is known to be finite.
    pub fn normalized(self) -> Self {
        match self.finite() {
            Some(point) => Self::from_finite(&point),
            None => self,
        }
    }

    /// Whether two points are the same: their coordinates are proportional.
    pub fn equals(&self, other: &Self) -> Truth {
        let determined = self.is_determined() & other.is_determined();
        provided(determined, all_zero(&cross(&self.0, &other.0)))
    }

    /// Whether the point lies on a line: A x + B y + C w = 0.
    pub fn is_on(&self, line: &Line<K>) -> Truth {
        let determined = self.is_determined() & line.is_determined();
        provided(determined, line.at(self).is_zero())
    }
}

/// The line A x + B y + C w = 0, up to a common factor of [A : B : C]; [0 : 0 : 1] is the line at
/// infinity. [0 : 0 : 0] is no line; predicates on it answer unknown.
#[derive(Clone, Debug)]
pub struct Line<K>(Triple<K>);

impl<K: Kind> Line<K> {
    /// [A : B : C].
    pub fn new(a: Number<K>, b: Number<K>, c: Number<K>) -> Self {
        Line([a, b, c])
    }

    /// The line at infinity, w = 0.
    pub fn at_infinity() -> Self {
        Self::new(Number::zero(), Number::zero(), Number::one())
    }

    /// The line through two points; not determined where they coincide.
    pub fn through(p: &ProjectivePoint<K>, q: &ProjectivePoint<K>) -> Self {
        Line(cross(&p.0, &q.0))
    }

    /// A, B and C.
    pub fn coefficients(&self) -> &[Number<K>; 3] {
        &self.0
    }

    /// Whether not all coefficients vanish.
    pub fn is_determined(&self) -> Truth {
        !all_zero(&self.0)
    }

    /// Whether this is the line at infinity, A = B = 0.
    pub fn is_at_infinity(&self) -> Truth {
        let [a, b, _] = &self.0;
        provided(self.is_determined(), a.is_zero() & b.is_zero())
    }

    /// A x + B y + C w, zero on the line. Its size depends on the factors of the coordinates.
    pub fn at(&self, point: &ProjectivePoint<K>) -> Number<K> {
        dot(&self.0, &point.0)
    }

    /// Where two lines meet: at infinity where they are parallel, not determined where they
    /// coincide.
    pub fn meet(&self, other: &Self) -> ProjectivePoint<K> {
        ProjectivePoint(cross(&self.0, &other.0))
    }

    /// Whether two lines are the same.
    pub fn equals(&self, other: &Self) -> Truth {
        let determined = self.is_determined() & other.is_determined();
        provided(determined, all_zero(&cross(&self.0, &other.0)))
    }

    /// The point at infinity of the line, [B : −A : 0]; not determined for the line at infinity.
    pub fn direction(&self) -> ProjectivePoint<K> {
        self.meet(&Self::at_infinity())
    }

    /// Whether two finite lines have the same direction, A₁B₂ = A₂B₁; a line is parallel to itself.
    /// Unknown where one of them is the line at infinity.
    pub fn is_parallel_to(&self, other: &Self) -> Truth {
        self.direction().equals(&other.direction())
    }

    /// Whether two finite lines meet at right angles, A₁A₂ + B₁B₂ = 0. Unknown where one of them is
    /// the line at infinity.
    pub fn is_perpendicular_to(&self, other: &Self) -> Truth {
        let (p, q) = (self.direction(), other.direction());
        let determined = p.is_determined() & q.is_determined();
        provided(determined, dot(&p.0, &q.0).is_zero())
    }
}

/// Whether three points lie on one line; so do any, two of which coincide.
pub fn collinear<K: Kind>(
    a: &ProjectivePoint<K>,
    b: &ProjectivePoint<K>,
    c: &ProjectivePoint<K>,
) -> Truth {
    let determined = Truth::all([a, b, c].map(ProjectivePoint::is_determined));
    provided(determined, Line::through(a, b).at(c).is_zero())
}

/// Whether three lines go through one point, or have one direction.
pub fn concurrent<K: Kind>(a: &Line<K>, b: &Line<K>, c: &Line<K>) -> Truth {
    let determined = Truth::all([a, b, c].map(Line::is_determined));
    provided(determined, dot(&cross(&a.0, &b.0), &c.0).is_zero())
}

/// A number or infinity, as numerator : denominator; 0 : 0 is undetermined.
#[derive(Clone, Debug)]
pub struct ProjectiveNumber<K> {
    /// Zero for the number 0.
    pub numerator: Number<K>,
    /// Zero for infinity.
    pub denominator: Number<K>,
}

impl<K: Kind> ProjectiveNumber<K> {
    /// Whether this is a number or infinity, and not 0 : 0.
    pub fn is_determined(&self) -> Truth {
        !(self.numerator.is_zero() & self.denominator.is_zero())
    }

    /// The quotient; no value for infinity.
    pub fn value(&self) -> Number<K> {
        &self.numerator / &self.denominator
    }

    /// Whether two are the same.
    pub fn equals(&self, other: &Self) -> Truth {
        let difference =
            &self.numerator * &other.denominator - &other.numerator * &self.denominator;
        let determined = self.is_determined() & other.is_determined();
        provided(determined, difference.is_zero())
    }
}

/// With A × C and so on all multiples of one real triple, products of the multiples are scalar
/// products of the triples, up to one positive factor that cancels.
fn ratio<K: Kind>([a, b, c, d]: [&Triple<K>; 4]) -> ProjectiveNumber<K> {
    ProjectiveNumber {
        numerator: dot(&cross(a, c), &cross(b, d)),
        denominator: dot(&cross(a, d), &cross(b, c)),
    }
}

/// The cross ratio (A B, C D) = AC/BC : AD/BD of four points on a line; −1 where they are harmonic,
/// infinite for A = D or B = C, undetermined where three coincide.
pub fn cross_ratio<K: Kind>(points: [&ProjectivePoint<K>; 4]) -> ProjectiveNumber<K> {
    ratio(points.map(|point| &point.0))
}

/// The cross ratio of four lines through a point, that of the points where they meet any line.
pub fn cross_ratio_of_lines<K: Kind>(lines: [&Line<K>; 4]) -> ProjectiveNumber<K> {
    ratio(lines.map(|line| &line.0))
}

/// The point D on the line AB with (A B, C D) = −1, for C on that line: where C = αA + βB, it is
/// αA − βB. Not determined for A = B.
pub fn harmonic_conjugate<K: Kind>(
    a: &ProjectivePoint<K>,
    b: &ProjectivePoint<K>,
    c: &ProjectivePoint<K>,
) -> ProjectivePoint<K> {
    let line = cross(&a.0, &b.0);
    let alpha = dot(&cross(&c.0, &b.0), &line);
    let beta = dot(&cross(&a.0, &c.0), &line);
    let [x, y, w] = &a.0;
    let [x1, y1, w1] = &b.0;
    ProjectivePoint::new(
        &alpha * x - &beta * x1,
        &alpha * y - &beta * y1,
        &alpha * w - &beta * w1,
    )
}
