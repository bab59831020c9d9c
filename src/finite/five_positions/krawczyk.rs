//! The judge of a Burmester pair: an interval test on the circle conditions themselves.

use crate::number::{Ball, Kind, Number, array};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// Four conditions of a pair, known by enclosures.
pub trait Conditions {
    /// The same with so many bits.
    fn rounded(&self, bits: u32) -> Self;
    /// The four values for x, y of the circlepoint and X, Y of the center.
    fn values(&self, at: &Vector) -> Vector;
    /// Their derivatives: a row for each value.
    fn derivative(&self, at: &Vector) -> Matrix;
}

/// Whether the boxes around circlepoint z and center M hold exactly one pair: Krawczyk's operator
/// m − Cf(m) + (1 − CJ)(box − m) of the four conditions lies inside the boxes, with C near the inverse
/// of the derivative in the middle m. `false` says nothing.
pub fn holds_one_pair(conditions: &impl Conditions, [z, m]: [&Point<Ball>; 2], bits: u32) -> bool {
    // Boxes that are much larger than the enclosures will do, so that few bits mostly suffice.
    let mut few = FIRST_BITS.min(bits);
    loop {
        let short = |x: &Number<Ball>| Number(x.0.with_precision(few));
        let point = |z: &Point<Ball>| Number::complex(short(z.re()), short(z.im()));
        if test(&conditions.rounded(few), [&point(z), &point(m)], few).unwrap_or(false) {
            return true;
        }
        if few >= bits {
            return false;
        }
        few = few.saturating_mul(2).min(bits);
    }
}

/// Bits that are tried first.
const FIRST_BITS: u32 = 128;

/// By x, y, X, Y.
pub type Vector = [Number<Ball>; 4];
/// Rows.
pub type Matrix = [Vector; 4];

#[expect(
    clippy::indexing_slicing,
    reason = "four unknowns, hence four rows and columns"
)]
fn test(conditions: &impl Conditions, [z, m]: [&Point<Ball>; 2], bits: u32) -> Option<bool> {
    let unknowns = [z.re(), z.im(), m.re(), m.im()];
    // Room around the enclosure, so that its image can lie inside.
    let wide: Vec<Number<Ball>> = unknowns
        .iter()
        .map(|x| widened(x, bits))
        .collect::<Option<_>>()?;
    let wide: Vector = wide.try_into().ok()?;
    let middle: Vec<Number<Ball>> = wide
        .iter()
        .map(|x| Some(Number::rounded(&x.0.midpoint_rational()?, &bits)))
        .collect::<Option<_>>()?;
    let middle: Vector = middle.try_into().ok()?;
    let inverse = approximate_inverse(&conditions.derivative(&middle), bits)?;
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
        let inside =
            image.0.lower()? > wide[i].0.lower()? && image.0.upper()? < wide[i].0.upper()?;
        if !inside {
            return Some(false);
        }
    }
    Some(true)
}

/// An enclosure with a thousandfold radius, and one where it had none.
fn widened(x: &Number<Ball>, bits: u32) -> Option<Number<Ball>> {
    let mid = x.0.midpoint_rational()?;
    let size = mid.clone().abs() + 1;
    let least = size >> (bits / 2);
    let radius = x.0.radius_rational()? * 1000 + least;
    Some(Number(Ball::with_radius(&mid, &radius, bits)))
}

/// The conditions of finite positions: |rⱼz + tⱼ − M|² − |r₁z + t₁ − M|².
impl Conditions for [Displacement<Ball>; 5] {
    fn rounded(&self, bits: u32) -> Self {
        let short = |x: &Number<Ball>| Number(x.0.with_precision(bits));
        self.each_ref().map(|position| position.map(short))
    }

    fn values(&self, [x, y, u, v]: &Vector) -> Vector {
        let z = Number::complex(x.clone(), y.clone());
        let m = Number::complex(u.clone(), v.clone());
        let square = |position: &Displacement<Ball>| (position.of(&z) - &m).norm();
        let [first, rest @ ..] = self;
        let first = square(first);
        rest.each_ref().map(|position| square(position) - &first)
    }

    fn derivative(&self, [x, y, u, v]: &Vector) -> Matrix {
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

/// Of |d|² with d = rz + t − M: by z the real part of 2 d̄r and of 2 d̄ri, by M that of −2d̄ and −2d̄i.
pub fn gradient<K: Kind>(position: &Displacement<K>, z: &Point<K>, m: &Point<K>) -> [Number<K>; 4] {
    let d = position.of(z) - m;
    let turned = d.conj() * &position.rotation;
    [2 * turned.re(), -2 * turned.im(), -2 * d.re(), -2 * d.im()]
}

fn apply(matrix: &Matrix, vector: &Vector) -> Vector {
    matrix.each_ref().map(|row| {
        let terms = row.iter().zip(vector);
        terms.map(|(a, b)| a * b).sum()
    })
}

/// The midpoints of an inverse by Gauss and Jordan; need not be exact.
fn approximate_inverse(matrix: &Matrix, bits: u32) -> Option<Matrix> {
    let mut rows: Vec<Vec<Number<Ball>>> = matrix
        .iter()
        .enumerate()
        .map(|(i, row)| {
            let unit = (0..4).map(|k| Number::from(i64::from(i == k)));
            row.iter().cloned().chain(unit).collect()
        })
        .collect();
    for column in 0..4 {
        let size = |row: &Vec<Number<Ball>>| -> Option<rug::Rational> {
            Some(row.get(column)?.0.midpoint_rational()?.abs())
        };
        let mut best = column;
        for place in column..4 {
            if size(rows.get(place)?)? > size(rows.get(best)?)? {
                best = place;
            }
        }
        rows.swap(column, best);
        let pivot = rows.get(column)?.clone();
        let inverse = pivot.get(column)?.inverse();
        let pivot: Vec<Number<Ball>> = pivot.iter().map(|entry| entry * &inverse).collect();
        for (place, row) in rows.iter_mut().enumerate() {
            if place == column {
                row.clone_from(&pivot);
                continue;
            }
            let factor = row.get(column)?.clone();
            for (entry, term) in row.iter_mut().zip(&pivot) {
                *entry = &*entry - &factor * term;
            }
        }
    }
    let middle = |x: &Number<Ball>| Some(Number::rounded(&x.0.midpoint_rational()?, &bits));
    let mut inverse: Matrix = std::array::from_fn(|_| std::array::from_fn(|_| Number::zero()));
    for (target, row) in inverse.iter_mut().zip(&rows) {
        for (entry, value) in target.iter_mut().zip(row.get(4..)?) {
            *entry = middle(value)?;
        }
    }
    Some(inverse)
}
