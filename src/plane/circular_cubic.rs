//! Real cubics, above all circular ones: those through both circular points [1 : ±i : 0].

use super::conic::Conic;
use super::isotropic::Polynomial;
use super::projective::{Line, ProjectivePoint};
use super::{Point, quadrilateral};
use crate::number::{Kind, Number, Truth};

/// A cubic by its coefficients, in the order x³, x²y, xy², y³, x², xy, y², x, y, 1. Where the first
/// four vanish, the line at infinity is a part of it.
#[derive(Clone, Debug)]
pub struct Cubic<K>([Number<K>; 10]);

impl<K: Kind> Cubic<K> {
    /// The cubic of these coefficients.
    pub fn new(coefficients: [Number<K>; 10]) -> Self {
        Cubic(coefficients)
    }

    /// The cubic of a polynomial in z and z̄ with real values, x and y put in for them. `None` where
    /// it is known that some value is not real or that the order exceeds 3. A polynomial of an
    /// inexact kind whose values are real but not known to be so is taken at its real part.
    pub fn from_isotropic(polynomial: &Polynomial<K>) -> Option<Self> {
        let too_high = polynomial.order().is_some_and(|order| order > 3);
        if too_high || polynomial.equals(&polynomial.conj()).is_no() {
            return None;
        }
        let mut coefficients = std::array::from_fn(|_| Number::zero());
        for (j, k) in (0..4).flat_map(|j| (0..4 - j).map(move |k| (j, k))) {
            let coefficient = polynomial.coefficient(j, k);
            let places = coefficients.iter_mut().skip(first_of_order(j + k));
            for (place, part) in places.zip(expanded(j, k)) {
                *place += (&coefficient * part).re();
            }
        }
        Some(Cubic(coefficients))
    }

    /// The focal cubic of the quadrilateral A, B, C, D: the points F that see opposite sides under
    /// directed angles AFB and CFD with a sum of 0 modulo π, Im (F−A)(F−C) : (F−B)(F−D) = 0; then
    /// BFC and DFA add to 0 as well. Without regard to direction the angles are equal or add to
    /// 180°. It is the locus of the foci of the conics that touch the four sides. For a
    /// parallelogram it is a conic and the line at infinity. `None` where it is known that the
    /// polynomial is no real cubic, which no quadrilateral with finite vertices leads to.
    pub fn focal(vertices: &[Point<K>; 4]) -> Option<Self> {
        // The polynomial is a difference of conjugate numbers: i times a real one.
        let curve = quadrilateral::focal_curve(vertices);
        Self::from_isotropic(&curve.times(&Polynomial::constant(-Number::i())))
    }

    /// The coefficients of x³, x²y, xy², y³, x², xy, y², x, y, 1.
    pub fn coefficients(&self) -> &[Number<K>; 10] {
        &self.0
    }

    /// Whether two cubics are the same curve: their coefficients are proportional. The zero polynomial
    /// is the same as itself only.
    pub fn equals(&self, other: &Self) -> Truth {
        let vanishes = |cubic: &Self| Truth::all(cubic.0.iter().map(Number::is_zero));
        let mut minors = Truth::Yes;
        for (i, (a, b)) in self.0.iter().zip(&other.0).enumerate() {
            for (c, d) in self.0.iter().zip(&other.0).skip(i + 1) {
                minors = minors & (a * d - b * c).is_zero();
            }
        }
        minors & vanishes(self).iff(vanishes(other))
    }

    /// The form of order 3 at [x : y : w], zero on the cubic.
    pub fn at_projective(&self, point: &ProjectivePoint<K>) -> Number<K> {
        let [x, y, w] = point.coordinates();
        let [a, b, c, d, e, f, g, h, i, j] = &self.0;
        let cubic = ((a * x + b * y) * x + c * y.square()) * x + d * y.power(3);
        let square = (e * x + f * y) * x + g * y.square();
        cubic + (square + (h * x + i * y + j * w) * w) * w
    }

    /// The polynomial at a finite point, zero on the cubic.
    pub fn at(&self, point: &Point<K>) -> Number<K> {
        self.at_projective(&ProjectivePoint::from_finite(point))
    }

    /// The partial derivatives (∂/∂x, ∂/∂y) at a point, as a vector: normal to the curve, zero at a
    /// double point.
    pub fn gradient(&self, point: &Point<K>) -> Point<K> {
        let tangent = self.tangent(&ProjectivePoint::from_finite(point));
        let [x, y, _] = tangent.coefficients();
        Number::complex(x.clone(), y.clone())
    }

    /// The tangent at a point of the cubic, finite or not; not determined at a double point.
    pub fn tangent(&self, point: &ProjectivePoint<K>) -> Line<K> {
        let [x, y, w] = point.coordinates();
        let [a, b, c, d, e, f, g, h, i, j] = &self.0;
        let (x2, xy, y2) = (x.square(), x * y, y.square());
        Line::new(
            3 * a * &x2 + 2 * b * &xy + c * &y2 + (2 * e * x + f * y + h * w) * w,
            b * &x2 + 2 * c * &xy + 3 * d * &y2 + (f * x + 2 * g * y + i * w) * w,
            e * &x2 + f * &xy + g * &y2 + (2 * (h * x + i * y) + 3 * j * w) * w,
        )
    }

    /// Whether the cubic part vanishes: the cubic is a conic (or less) and the line at infinity.
    pub fn contains_line_at_infinity(&self) -> Truth {
        Truth::all(self.0.iter().take(4).map(Number::is_zero))
    }

    /// Where the line at infinity is a part of the cubic, what is left: the terms of order 2 at most.
    pub fn beside_line_at_infinity(&self) -> Conic<K> {
        let [_, _, _, _, e, f, g, h, i, j] = &self.0;
        Conic::new([e, f, g, h, i, j].map(Number::clone))
    }

    /// Whether the cubic part is divisible by x² + y², so that it is (a x + b y)(x² + y²): the
    /// coefficients of x³ and xy² are equal, and those of x²y and y³. So it is where it vanishes.
    pub fn is_circular(&self) -> Truth {
        let [a, b, c, d, ..] = &self.0;
        a.equals(c) & b.equals(d)
    }

    /// Of a circular cubic, the point at infinity that is real, [−b : a : 0] for the cubic part
    /// (a x + b y)(x² + y²); not determined where that vanishes.
    pub fn real_point_at_infinity(&self) -> ProjectivePoint<K> {
        let [a, b, ..] = &self.0;
        ProjectivePoint::new(-b, a.clone(), Number::zero())
    }

    /// Of a circular cubic, the asymptote that is real: the tangent at its real point at infinity;
    /// not determined where the cubic part vanishes.
    pub fn real_asymptote(&self) -> Line<K> {
        self.tangent(&self.real_point_at_infinity())
    }

    /// Of a circular cubic, the point where the tangents at the circular points meet; for the cubic
    /// part (a x + b y)(x² + y²) and the square part e x² + f xy + g y² it is
    /// −(e − g + if)/(2(a + ib)). No value where the cubic part vanishes.
    pub fn singular_focus(&self) -> Point<K> {
        let [a, b, _, _, e, f, g, ..] = &self.0;
        let linear = Number::complex(a.clone(), b.clone());
        Number::complex(g - e, -f) / (2 * linear)
    }
}

/// Where the coefficients of an order start, 3 at most.
fn first_of_order(order: usize) -> usize {
    match order {
        3 => 0,
        2 => 4,
        1 => 7,
        _ => 9,
    }
}

/// The coefficients of xⁿ, xⁿ⁻¹y, …, yⁿ in (x + iy)ʲ (x − iy)ᵏ, n = j + k.
fn expanded<K: Kind>(j: usize, k: usize) -> Vec<Point<K>> {
    let mut product = vec![Number::one()];
    for factor in 0..j + k {
        let turn = if factor < j {
            Number::i()
        } else {
            -Number::i()
        };
        product.push(Number::zero());
        for place in (1..product.len()).rev() {
            let (lower, upper) = product.split_at_mut(place);
            if let (Some(before), Some(here)) = (lower.last(), upper.first_mut()) {
                *here += before * &turn;
            }
        }
    }
    product
}
