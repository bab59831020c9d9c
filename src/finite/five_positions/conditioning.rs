//! How much a pair moves with the positions, and how far it is from meeting another one. Estimates of
//! first and second order: nothing certified.

use crate::number::linear::solution;
use crate::number::{Ball, Number};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// Bits that the estimates are computed with.
const BITS: u32 = 128;

/// What small changes of the positions do to a pair.
#[derive(Clone, Debug)]
pub struct Conditioning {
    /// For each position: by how much the coordinate that moves most changes with x, with y, and with
    /// the angle in radians.
    pub sensitivity: [[f64; 3]; 5],
    /// The relative change of a coordinate, against the largest one of its point, that relative changes
    /// of all data cause together; angles count by radians, lengths against the largest shift.
    pub condition: f64,
    /// The relative change of the positions at which the pair meets another one, were the conditions of
    /// second order.
    pub to_double: f64,
}

type Vector = [Number<Ball>; 4];

/// Of a real pair; `None` where it is multiple or not known well enough.
#[expect(
    clippy::indexing_slicing,
    reason = "five positions by three numbers each, and four numbers of a pair"
)]
pub fn conditioning(
    positions: &[Displacement<Ball>; 5],
    [z, m]: [&Point<Ball>; 2],
) -> Option<Conditioning> {
    let short = |x: &Number<Ball>| Number(x.0.with_precision(BITS));
    let point = |z: &Point<Ball>| Number::complex(short(z.re()), short(z.im()));
    let (z, m) = (point(z), point(m));
    let links: Vec<Link> = positions
        .iter()
        .map(|position| {
            Link::new(
                &point(&position.rotation),
                &point(&position.translation),
                &z,
                &m,
            )
        })
        .collect();
    let (first, rest) = links.split_first()?;
    let jacobian: Vec<Vector> = rest
        .iter()
        .map(|link| std::array::from_fn(|k| &link.by_pair[k] - &first.by_pair[k]))
        .collect();
    let inverse = inverse(&jacobian)?;
    let response = |right: &Vector| -> Option<[f64; 4]> {
        let mut moved = [0.0; 4];
        for (value, column) in right.iter().zip(&inverse) {
            let value = middle(value)?;
            for (sum, entry) in moved.iter_mut().zip(column) {
                *sum += value * entry;
            }
        }
        Some(moved)
    };
    // |d₁|² stands in all four conditions, |dⱼ|² in one.
    let column = |place: usize, value: &Number<Ball>| -> Vector {
        std::array::from_fn(|row| match place {
            0 => value.clone(),
            _ if row + 1 == place => -value,
            _ => Number::zero(),
        })
    };
    let largest_of = |list: &[f64]| list.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    let coordinates: Vec<f64> = [z.re(), z.im(), m.re(), m.im()]
        .into_iter()
        .map(middle)
        .collect::<Option<_>>()?;
    let sizes: Vec<f64> = coordinates.chunks(2).map(largest_of).collect();
    let shifts = positions.iter().flat_map(|position| {
        let shift = &position.translation - &positions[0].translation;
        [shift.re().clone(), shift.im().clone()]
    });
    let shifts: Vec<f64> = shifts.map(|x| middle(&x)).collect::<Option<_>>()?;
    let length = largest_of(&shifts);
    let mut sensitivity = [[0.0; 3]; 5];
    let mut relative = [0.0; 4];
    let mut steepest = (0.0, [0.0; 4]);
    for (place, link) in links.iter().enumerate() {
        for (datum, value) in link.by_datum.iter().enumerate() {
            let moved = response(&column(place, value))?;
            sensitivity[place][datum] = largest_of(&moved);
            let unit = if datum == 2 { 1.0 } else { length };
            for (k, change) in moved.iter().enumerate() {
                relative[k] += change.abs() * unit / sizes[k / 2].max(f64::MIN_POSITIVE);
            }
            let size = largest_of(&moved) * unit;
            if size > steepest.0 {
                steepest = (size, moved);
            }
        }
    }
    // Along the steepest direction δ the pair moves by s − ½ |J⁻¹ F″(δ, δ)| s²: it turns at the double
    // pair.
    let along = steepest.1.map(|x| x / largest_of(&steepest.1));
    let bend: Vec<Number<Ball>> = links.iter().map(|link| link.second_order(&along)).collect();
    let curvature: Vector = std::array::from_fn(|j| &bend[j + 1] - &bend[0]);
    let bending = largest_of(&response(&curvature)?);
    let condition = largest_of(&relative);
    let to_double = 1.0 / (2.0 * bending * steepest.0);
    Some(Conditioning {
        sensitivity,
        condition,
        to_double,
    })
}

/// By columns.
fn inverse(matrix: &[Vector]) -> Option<[[f64; 4]; 4]> {
    let column = |place: usize| -> Option<[f64; 4]> {
        let rows = matrix.iter().enumerate().map(|(row, entries)| {
            let unit = Number::from(i64::from(row == place));
            entries.iter().cloned().chain([unit]).collect()
        });
        let rows: Vec<Vec<Number<Ball>>> = rows.collect();
        let found: Vec<f64> = solution(&rows)?.iter().map(middle).collect::<Option<_>>()?;
        found.try_into().ok()
    };
    Some([column(0)?, column(1)?, column(2)?, column(3)?])
}

fn middle(x: &Number<Ball>) -> Option<f64> {
    Some(x.0.midpoint_rational()?.to_f64())
}

/// |d|² of a link d = rz + t − M and its derivatives.
struct Link {
    rotation: Point<Ball>,
    /// By x, y of the circlepoint and of the center.
    by_pair: Vector,
    /// By x, y and the angle of the position.
    by_datum: [Number<Ball>; 3],
}

impl Link {
    fn new(r: &Point<Ball>, t: &Point<Ball>, z: &Point<Ball>, m: &Point<Ball>) -> Link {
        let turned = r * z;
        let d = &turned + t - m;
        let by_z = d.conj() * r;
        // By the angle rz moves in the direction of irz.
        let by_angle = -(d.conj() * turned).im() * 2;
        Link {
            rotation: r.clone(),
            by_pair: [2 * by_z.re(), -2 * by_z.im(), -2 * d.re(), -2 * d.im()],
            by_datum: [2 * d.re(), 2 * d.im(), by_angle],
        }
    }

    /// 2 |r δz − δM|².
    fn second_order(&self, [x, y, u, v]: &[f64; 4]) -> Number<Ball> {
        let ball = |x: &f64| Number::<Ball>::from(rug::Rational::from_f64(*x).unwrap_or_default());
        let z = Number::complex(ball(x), ball(y));
        let m = Number::complex(ball(u), ball(v));
        2 * (&self.rotation * z - m).norm()
    }
}
