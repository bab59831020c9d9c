//! One problem after another, in several charts where one degenerates.

use super::super::chart::Chart;
use super::super::conditions::{Coordinates, products, rows};
use super::{NEGLIGIBLE, Pair};
use crate::number::univariate::approximate_roots;
use crate::number::{Complex, Number};
use crate::plane::displacement::Displacement;

/// Newton steps that each pair is improved by.
const STEPS: usize = 3;
/// How many charts are tried.
const CHARTS: i64 = 8;

/// All pairs by h, x, y, X, Y, p, q, of which h is zero for those at infinity; real ones have real
/// coordinates, and of two conjugate ones there is one. `None` where these are not found, as in
/// families.
pub fn pairs(positions: &[Displacement<f64>; 5]) -> Option<Vec<Pair>> {
    let unit = Unit::of(positions);
    let rows = rows(&unit.measured(positions));
    let basis = orthonormal_kernel(&rows)?;
    let complex = basis
        .each_ref()
        .map(|vector| vector.each_ref().map(|x| x.clone().into()));
    (0..CHARTS).find_map(|seed| {
        let meets = Chart::new(&basis, seed)?.meets();
        let roots = approximate_roots(&meets.resultant)?;
        let above = |s: &&Number<Complex<f64>>| s.im().0 > 0.0;
        let real = |s: &&Number<Complex<f64>>| s.im().0 == 0.0;
        let count = roots.iter().filter(real).count() + 2 * roots.iter().filter(above).count();
        let roots = roots.iter().filter(|s| s.im().0 >= 0.0);
        let pairs = roots.map(|s| {
            let coordinates = meets.coordinates.at_complex(s, Number::clone);
            Some(unit.back(improved(&complex, &coordinates)?))
        });
        let pairs: Vec<Pair> = pairs.collect::<Option<_>>()?;
        (count == 4).then_some(pairs)
    })
}

/// A length and an origin with which the numbers are about one.
struct Unit {
    origin: Number<Complex<f64>>,
    length: Number<f64>,
}

impl Unit {
    fn of(positions: &[Displacement<f64>; 5]) -> Unit {
        let [first, rest @ ..] = positions;
        let shifts = rest
            .iter()
            .map(|position| &position.translation - &first.translation);
        let length = shifts
            .map(|shift| shift.norm().0.sqrt())
            .fold(0.0, f64::max);
        Unit {
            origin: first.translation.clone(),
            length: Number(if length > 0.0 { length } else { 1.0 }),
        }
    }

    fn measured(&self, positions: &[Displacement<f64>; 5]) -> [Displacement<f64>; 5] {
        let by = self.length.inverse();
        positions.each_ref().map(|position| Displacement {
            rotation: position.rotation.clone(),
            translation: (&position.translation - &self.origin).scaled(&by),
        })
    }

    fn back(&self, [h, x, y, cx, cy, p, q]: Pair) -> Pair {
        let [a, b] = [self.origin.re(), self.origin.im()].map(|x| Number::from(x.clone()));
        let length = Number::from(self.length.clone());
        let (x, y) = (x * &length, y * &length);
        let square = length.square();
        let p = p * &square + &x * &a + &y * &b;
        let q = q * &square + &y * &a - &x * &b;
        let (cx, cy) = (cx * &length + &a * &h, cy * length + b * &h);
        [h, x, y, cx, cy, p, q]
    }
}

/// Three vectors of length one, at right angles to each other and to all rows.
fn orthonormal_kernel(rows: &[Vec<Number<f64>>]) -> Option<[Coordinates<f64>; 3]> {
    let mut frame: Vec<Coordinates<f64>> = Vec::new();
    for row in rows {
        let row: Coordinates<f64> = row.clone().try_into().ok()?;
        frame.push(normal_to(&frame, row)?);
    }
    let units = (0..7).map(|k| std::array::from_fn(|i| Number(f64::from(u8::from(i == k)))));
    let mut units: Vec<Coordinates<f64>> = units.collect();
    for _ in 0..3 {
        let rest = |unit: &Coordinates<f64>| -> f64 {
            1.0 - frame.iter().map(|v| dot(v, unit).0.powi(2)).sum::<f64>()
        };
        let farthest = (0..units.len()).max_by(|&i, &j| {
            let [a, b] = [i, j].map(|i| units.get(i).map_or(0.0, rest));
            a.total_cmp(&b)
        })?;
        let unit = units.swap_remove(farthest);
        frame.push(normal_to(&frame, unit)?);
    }
    frame.split_off(rows.len()).try_into().ok()
}

fn dot(a: &Coordinates<f64>, b: &Coordinates<f64>) -> Number<f64> {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The part at right angles to all of a frame, of length one; taken twice, for the sake of rounding.
fn normal_to(frame: &[Coordinates<f64>], mut vector: Coordinates<f64>) -> Option<Coordinates<f64>> {
    for _ in 0..2 {
        for axis in frame {
            let along = dot(axis, &vector);
            for (entry, part) in vector.iter_mut().zip(axis) {
                *entry -= &along * part;
            }
        }
        let length = dot(&vector, &vector).0.sqrt();
        if length.is_nan() || length <= 0.0 {
            return None;
        }
        vector = vector.map(|entry| entry / Number(length));
    }
    Some(vector)
}

/// Newton's method on both conics, the largest of the three weights kept.
#[expect(
    clippy::indexing_slicing,
    reason = "there are three weights and axes, and seven coordinates"
)]
fn improved(basis: &[Pair; 3], start: &Pair) -> Option<Pair> {
    let weight =
        |axis: &Pair| -> Number<Complex<f64>> { axis.iter().zip(start).map(|(a, b)| a * b).sum() };
    let mut weights = basis.each_ref().map(weight);
    let size = |z: &Number<Complex<f64>>| z.norm().0;
    let kept = (0..3).max_by(|&i, &j| size(&weights[i]).total_cmp(&size(&weights[j])))?;
    let largest = weights[kept].clone();
    weights = weights.map(|weight| weight / &largest);
    let (i, j) = ((kept + 1) % 3, (kept + 2) % 3);
    let vector = |weights: &[Number<Complex<f64>>; 3]| -> Pair {
        std::array::from_fn(|k| (0..3).map(|i| &basis[i][k] * &weights[i]).sum())
    };
    for _ in 0..STEPS {
        let v = vector(&weights);
        let [f, g] = products(&v, &v).map(|twice| twice / 2);
        let ([fi, gi], [fj, gj]) = (products(&basis[i], &v), products(&basis[j], &v));
        let determinant = &fi * &gj - &fj * &gi;
        let step_i = (&f * &gj - &fj * &g) / &determinant;
        let step_j = (&fi * &g - &f * &gi) / &determinant;
        if step_i.has_value() && step_j.has_value() {
            weights[i] -= step_i;
            weights[j] -= step_j;
        }
    }
    let mut v = vector(&weights);
    let negligible = v.iter().map(size).fold(0.0, f64::max).sqrt() * NEGLIGIBLE;
    if size(&v[0]).sqrt() <= negligible {
        v[0] = Number::zero();
    }
    v.iter().all(Number::has_value).then_some(v)
}
