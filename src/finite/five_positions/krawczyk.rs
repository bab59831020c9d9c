//! The judge of a Burmester pair: an interval test on the circle conditions themselves.

use crate::number::{Ball, Interval, Kind, Number, Real, array};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// Four conditions of a pair.
pub trait Conditions<K> {
    /// The four values for x, y of the circlepoint and X, Y of the center.
    fn values(&self, at: &Vector<K>) -> Vector<K>;
    /// Their derivatives: a row for each value.
    fn derivative(&self, at: &Vector<K>) -> Matrix<K>;
}

/// Conditions known by enclosures.
pub trait Enclosed: Conditions<Ball> {
    /// The same in intervals of machine floats.
    type Floats: Conditions<Interval>;
    /// The same in intervals of machine floats.
    fn in_floats(&self) -> Self::Floats;
    /// The same with so many bits.
    fn rounded(&self, bits: u32) -> Self;
}

/// Whether the boxes around circlepoint z and center M hold exactly one pair: Krawczyk's operator
/// m − Cf(m) + (1 − CJ)(box − m) of the four conditions lies inside the boxes, with C near the inverse
/// of the derivative in the middle m. `false` says nothing.
pub fn holds_one_pair(conditions: &impl Enclosed, [z, m]: [&Point<Ball>; 2], bits: u32) -> bool {
    // Boxes that are much larger than the enclosures will do, so that machine floats or few bits
    // mostly suffice.
    let unknowns = [z.re(), z.im(), m.re(), m.im()];
    if test(&conditions.in_floats(), &unknowns.map(Number::from), &()).unwrap_or(false) {
        return true;
    }
    let mut few = FIRST_BITS.min(bits);
    loop {
        let short = |x: &Number<Ball>| Number(x.0.with_precision(few));
        if test(&conditions.rounded(few), &unknowns.map(short), &few).unwrap_or(false) {
            return true;
        }
        if few >= bits {
            return false;
        }
        few = few.saturating_mul(2).min(bits);
    }
}

/// Bits that are tried after machine floats.
const FIRST_BITS: u32 = 128;

/// By x, y, X, Y.
pub type Vector<K> = [Number<K>; 4];
/// Rows.
pub type Matrix<K> = [Vector<K>; 4];

/// Sets of real numbers, one of which is their middle.
trait Box: Real {
    /// The middle.
    fn middle(&self, precision: &Self::Precision) -> Option<Self>;
    /// With a thousandfold radius, and one where it had none.
    fn widened(&self, precision: &Self::Precision) -> Option<Self>;
    /// Whether it lies inside the other, and touches neither end.
    fn is_inside(&self, other: &Self) -> Option<bool>;
    /// Greater for greater numbers, about.
    fn size(&self) -> f64;
}

impl Box for Ball {
    fn middle(&self, bits: &u32) -> Option<Self> {
        Some(Ball::rounded(&self.midpoint_rational()?, bits))
    }

    fn widened(&self, bits: &u32) -> Option<Self> {
        let mid = self.midpoint_rational()?;
        let size = mid.clone().abs() + 1;
        let least = size >> (bits / 2);
        let radius = self.radius_rational()? * 1000 + least;
        Some(Ball::with_radius(&mid, &radius, *bits))
    }

    fn is_inside(&self, other: &Self) -> Option<bool> {
        Some(self.lower()? > other.lower()? && self.upper()? < other.upper()?)
    }

    fn size(&self) -> f64 {
        let middle = self.midpoint_rational();
        middle.map_or(0.0, |middle| middle.to_f64().abs())
    }
}

impl Box for Interval {
    fn middle(&self, (): &()) -> Option<Self> {
        let middle = self.low() / 2.0 + self.high() / 2.0;
        middle.is_finite().then(|| Interval::new(middle, middle))
    }

    fn widened(&self, (): &()) -> Option<Self> {
        /// Of what has no radius, as a share of its size.
        const LEAST: f64 = 1e-8;
        let radius = 500.0 * (self.high() - self.low()) + LEAST * (self.magnitude() + 1.0);
        radius.is_finite().then(|| self.widened(radius))
    }

    fn is_inside(&self, other: &Self) -> Option<bool> {
        Some(self.low() > other.low() && self.high() < other.high())
    }

    fn size(&self) -> f64 {
        self.magnitude()
    }
}

#[expect(
    clippy::indexing_slicing,
    reason = "four unknowns, hence four rows and columns"
)]
fn test<K: Box>(
    conditions: &impl Conditions<K>,
    unknowns: &Vector<K>,
    precision: &K::Precision,
) -> Option<bool> {
    // Room around the enclosure, so that its image can lie inside.
    let wide = each(unknowns, |x| Some(Number(x.0.widened(precision)?)))?;
    let middle = each(&wide, |x| Some(Number(x.0.middle(precision)?)))?;
    let inverse = approximate_inverse(conditions.derivative(&middle), precision)?;
    let value = apply(&inverse, &conditions.values(&middle));
    let slope = conditions.derivative(&wide);
    for i in 0..4 {
        let mut image = &middle[i] - &value[i];
        for k in 0..4 {
            let mut entry = Number::from(i64::from(i == k));
            for (j, row) in slope.iter().enumerate() {
                entry -= &inverse[i][j] * &row[k];
            }
            image += entry * (&wide[k] - &middle[k]);
        }
        if !image.0.is_inside(&wide[i].0)? {
            return Some(false);
        }
    }
    Some(true)
}

fn each<K>(numbers: &Vector<K>, of: impl Fn(&Number<K>) -> Option<Number<K>>) -> Option<Vector<K>> {
    let [x, y, u, v] = numbers;
    Some([of(x)?, of(y)?, of(u)?, of(v)?])
}

/// The conditions of finite positions: |rⱼz + tⱼ − M|² − |r₁z + t₁ − M|².
impl<K: Kind> Conditions<K> for [Displacement<K>; 5] {
    fn values(&self, [x, y, u, v]: &Vector<K>) -> Vector<K> {
        let z = Number::complex(x.clone(), y.clone());
        let m = Number::complex(u.clone(), v.clone());
        let square = |position: &Displacement<K>| (position.of(&z) - &m).norm();
        let [first, rest @ ..] = self;
        let first = square(first);
        rest.each_ref().map(|position| square(position) - &first)
    }

    fn derivative(&self, [x, y, u, v]: &Vector<K>) -> Matrix<K> {
        let z = Number::complex(x.clone(), y.clone());
        let m = Number::complex(u.clone(), v.clone());
        let gradient = |position| gradient(position, &z, &m);
        let [first, rest @ ..] = self;
        let first = gradient(first);
        rest.each_ref().map(|position| {
            array::pairs(&gradient(position), &first).map(|(entry, first)| entry - first)
        })
    }
}

impl Enclosed for [Displacement<Ball>; 5] {
    type Floats = [Displacement<Interval>; 5];

    fn in_floats(&self) -> Self::Floats {
        let float = |x: &Number<Ball>| x.into();
        self.each_ref().map(|position| position.map(float))
    }

    fn rounded(&self, bits: u32) -> Self {
        let short = |x: &Number<Ball>| Number(x.0.with_precision(bits));
        self.each_ref().map(|position| position.map(short))
    }
}

/// Of |d|² with d = rz + t − M: by z the real part of 2 d̄r and of 2 d̄ri, by M that of −2d̄ and −2d̄i.
pub fn gradient<K: Kind>(position: &Displacement<K>, z: &Point<K>, m: &Point<K>) -> [Number<K>; 4] {
    let d = position.of(z) - m;
    let turned = d.conj() * &position.rotation;
    [2 * turned.re(), -2 * turned.im(), -2 * d.re(), -2 * d.im()]
}

fn apply<K: Kind>(matrix: &Matrix<K>, vector: &Vector<K>) -> Vector<K> {
    matrix.each_ref().map(|row| {
        let terms = row.iter().zip(vector);
        terms.map(|(a, b)| a * b).sum()
    })
}

/// The midpoints of an inverse; need not be exact.
fn approximate_inverse<K: Box>(matrix: Matrix<K>, precision: &K::Precision) -> Option<Matrix<K>> {
    let inverse = inverse(matrix, |x| x.0.size())?;
    let [a, b, c, d] = inverse.map(|row| each(&row, |x| Some(Number(x.0.middle(precision)?))));
    Some([a?, b?, c?, d?])
}

/// An inverse by Gauss and Jordan, with pivots that are large by some measure.
#[expect(
    clippy::indexing_slicing,
    reason = "four rows of a matrix and of the identity beside it"
)]
pub(super) fn inverse<K: Kind>(
    mut left: Matrix<K>,
    size: impl Fn(&Number<K>) -> f64,
) -> Option<Matrix<K>> {
    let mut right: Matrix<K> =
        std::array::from_fn(|i| std::array::from_fn(|k| i64::from(i == k).into()));
    for column in 0..4 {
        let size = |row: &usize| size(&left[*row][column]);
        let best = (column..4).max_by(|a, b| size(a).total_cmp(&size(b)))?;
        left.swap(column, best);
        right.swap(column, best);
        let inverse = left[column][column].inverse();
        for half in [&mut left, &mut right] {
            half[column].iter_mut().for_each(|entry| *entry *= &inverse);
        }
        for row in (0..4).filter(|row| *row != column) {
            let factor = left[row][column].clone();
            for half in [&mut left, &mut right] {
                let pivot = half[column].clone();
                for (entry, term) in half[row].iter_mut().zip(&pivot) {
                    *entry -= &factor * term;
                }
            }
        }
    }
    Some(right)
}
