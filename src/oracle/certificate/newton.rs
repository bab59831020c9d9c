//! The interval test of a pair on the circle conditions, real or complex.

use rug::Rational;

use super::conditions::{Conditions, Pair};
use crate::number::{Ball, Complex, Number, array};

type Entry = Number<Complex<Ball>>;
/// x, y of the circlepoint, X, Y of the center.
pub type Vector = Pair<Complex<Ball>>;
type Matrix = [Vector; 4];
type Five = Conditions<Complex<Ball>>;

/// Steps of Newton's method before a start is said to lead nowhere.
const STEPS: usize = 24;

/// The pair next to a start, enclosed: a box that provably holds exactly one solution, contracted.
/// With `is_real` a box that is its own conjugate, so that the pair is real. `None` where no such box
/// is found.
pub fn enclosed(five: &Five, start: &Vector, is_real: bool, bits: u32) -> Option<Vector> {
    let mut middle = rounded(start, is_real, bits)?;
    for _ in 0..STEPS {
        let step = newton_step(five, &middle, bits)?;
        let next: Vector = array::pairs(&middle, &step).map(|(middle, step)| middle - step);
        middle = rounded(&next, is_real, bits)?;
        let size = scale(&middle)?.max(five.reach()?);
        if scale(&step)? <= size.clone() >> (bits / 2 + 16) {
            let radius = size >> (bits / 2);
            return contracted(five, &middle, &radius, is_real, bits);
        }
    }
    None
}

/// Krawczyk's operator on the box around a middle, where it lies inside.
#[expect(
    clippy::indexing_slicing,
    reason = "four unknowns, hence four rows and columns"
)]
fn contracted(
    five: &Five,
    middle: &Vector,
    radius: &Rational,
    is_real: bool,
    bits: u32,
) -> Option<Vector> {
    let zero = Rational::new();
    let around = |x: &Number<Ball>, radius: &Rational| -> Option<Number<Ball>> {
        let mid = x.0.midpoint_rational()?;
        Some(Number(Ball::with_radius(&mid, radius, bits)))
    };
    let wide = middle.each_ref().map(|x| {
        let im = if is_real { &zero } else { radius };
        Some(Number::complex(
            around(x.re(), radius)?,
            around(x.im(), im)?,
        ))
    });
    let [a, b, c, d] = wide;
    let wide: Vector = [a?, b?, c?, d?];
    let inverse = approximate_inverse(&five.slopes(middle)?, bits)?;
    let value = applied(&inverse, &five.at(middle)?);
    let slope = five.slopes(&wide)?;
    let image: Vector = std::array::from_fn(|i| {
        let mut image = &middle[i] - &value[i];
        for k in 0..4 {
            let mut entry = Number::from(i64::from(i == k));
            for (j, row) in slope.iter().enumerate() {
                entry -= &inverse[i][j] * &row[k];
            }
            image += entry * (&wide[k] - &middle[k]);
        }
        image
    });
    let inside = |a: &Number<Ball>, b: &Number<Ball>| -> Option<bool> {
        Some(a.0.lower()? > b.0.lower()? && a.0.upper()? < b.0.upper()?)
    };
    for (image, wide) in image.iter().zip(&wide) {
        // The real operator has real images: their imaginary part is 0 exactly.
        if !inside(image.re(), wide.re())? || !(is_real || inside(image.im(), wide.im())?) {
            return None;
        }
    }
    if !is_real {
        return Some(image);
    }
    Some(image.map(|x| Number::complex(x.re().clone(), Number::zero())))
}

/// The midpoints.
fn rounded(vector: &Vector, is_real: bool, bits: u32) -> Option<Vector> {
    let middle = |x: &Number<Ball>| -> Option<Number<Ball>> {
        // First to the precision, which costs a radius; then without it.
        let short = Ball::with_radius(&x.0.midpoint_rational()?, &Rational::new(), bits);
        let exact = Ball::with_radius(&short.midpoint_rational()?, &Rational::new(), bits);
        Some(Number(exact))
    };
    let parts = vector.each_ref().map(|x| {
        let im = if is_real {
            Number::zero()
        } else {
            middle(x.im())?
        };
        Some(Number::complex(middle(x.re())?, im))
    });
    let [a, b, c, d] = parts;
    Some([a?, b?, c?, d?])
}

/// The largest part.
fn scale(vector: &Vector) -> Option<Rational> {
    let mut largest = Rational::new();
    for part in vector.iter().flat_map(|x| [x.re(), x.im()]) {
        largest = largest.max(part.0.midpoint_rational()?.abs());
    }
    Some(largest)
}

fn newton_step(five: &Five, at: &Vector, bits: u32) -> Option<Vector> {
    let inverse = approximate_inverse(&five.slopes(at)?, bits)?;
    Some(applied(&inverse, &five.at(at)?))
}

fn applied(matrix: &Matrix, vector: &Vector) -> Vector {
    matrix
        .each_ref()
        .map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum())
}

/// Near the inverse, without a radius: by elimination with the largest pivot.
#[expect(clippy::indexing_slicing, reason = "four rows of eight columns")]
fn approximate_inverse(matrix: &Matrix, bits: u32) -> Option<Matrix> {
    let mut rows: Vec<Vec<Entry>> = Vec::new();
    for (i, row) in matrix.iter().enumerate() {
        let mut row = rounded(row, false, bits)?.to_vec();
        row.extend((0..4).map(|k| Number::from(i64::from(i == k))));
        rows.push(row);
    }
    for column in 0..4 {
        let mut best = (column, Rational::new());
        for (place, row) in rows.iter().enumerate().skip(column) {
            let size = row[column].norm().0.midpoint_rational()?;
            if size > best.1 {
                best = (place, size);
            }
        }
        rows.swap(column, best.0);
        let pivot = rows[column].clone();
        let inverse = pivot[column].inverse();
        for (place, row) in rows.iter_mut().enumerate() {
            if place == column {
                continue;
            }
            let factor = &row[column] * &inverse;
            for (entry, above) in row.iter_mut().zip(&pivot) {
                *entry -= &factor * above;
            }
        }
        if let Some(row) = rows.get_mut(column) {
            for entry in row.iter_mut() {
                *entry = &*entry * &inverse;
            }
        }
    }
    let mut inverse: Vec<Vector> = Vec::new();
    for row in rows {
        let part: Vector = row.get(4..)?.to_vec().try_into().ok()?;
        inverse.push(rounded(&part, false, bits)?);
    }
    inverse.try_into().ok()
}
