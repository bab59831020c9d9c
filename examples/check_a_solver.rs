//! A solver that is wrong, and what a comparison says of it.
//!
//! It looks for the Burmester pairs of five positions by Newton's method from a few starts, and makes
//! three mistakes that are common: it takes what comes out without asking whether it has converged, it
//! takes too few starts to meet every pair, and it tells pairs apart only by a rough distance.

use burmester::testing::{Expected, Pair, Position, TestingError};

/// Prints the report.
///
/// # Errors
/// None for these positions.
pub fn main() -> Result<(), TestingError> {
    println!("{}", checked()?);
    Ok(())
}

/// The report on one problem.
///
/// # Errors
/// A number that is not finite.
pub fn checked() -> Result<String, TestingError> {
    let positions = [
        (0.0, 0.0, 0.0),
        (3.0, 1.0, 0.4),
        (5.0, 1.0, 0.65),
        (6.0, -1.0, 1.2),
        (5.0, -4.0, 1.6),
    ]
    .map(|(x, y, angle)| Position { x, y, angle });
    let expected = Expected::five_positions(&positions)?;
    let comparison = expected.compare_pairs(&solver(&positions))?;
    Ok(comparison.to_string())
}

/// The wrong solver. The unknowns are x, y of the circlepoint and X, Y of the center.
fn solver(positions: &[Position; 5]) -> Vec<Pair> {
    let starts = [
        [1.0, 1.0, -2.0, 3.0],
        [-3.0, 2.0, 1.0, -4.0],
        [-8.0, 4.0, 4.0, 9.0],
    ];
    let mut found: Vec<[f64; 4]> = Vec::new();
    for start in starts {
        let mut at = start;
        for _ in 0..8 {
            let Some(step) = newton_step(positions, &at) else {
                break;
            };
            at.iter_mut().zip(step).for_each(|(x, s)| *x += s);
        }
        let is_new = |other: &[f64; 4]| other.iter().zip(at).any(|(a, b)| (a - b).abs() > 0.5);
        if at.iter().all(|x| x.is_finite()) && found.iter().all(is_new) {
            found.push(at);
        }
    }
    let pair = |[x, y, u, v]: [f64; 4]| Pair {
        circlepoint: [x, y],
        center: [u, v],
    };
    found.into_iter().map(pair).collect()
}

/// Solves J s = −F for F_i = |D_i z − M|² − |D_1 z − M|², i = 2 to 5, by elimination.
#[expect(
    clippy::indexing_slicing,
    reason = "five positions; four rows of five entries"
)]
fn newton_step(positions: &[Position; 5], [x, y, u, v]: &[f64; 4]) -> Option<[f64; 4]> {
    // |D z − M|² and its derivatives.
    let square = |position: &Position| {
        let (sin, cos) = position.angle.sin_cos();
        let p = cos * x - sin * y + position.x - u;
        let q = sin * x + cos * y + position.y - v;
        [
            2.0 * (p * cos + q * sin),
            2.0 * (q * cos - p * sin),
            -2.0 * p,
            -2.0 * q,
            -(p * p + q * q),
        ]
    };
    let first = square(&positions[0]);
    let mut rows = [1, 2, 3, 4].map(|i| {
        let mut row = square(&positions[i]);
        row.iter_mut().zip(first).for_each(|(a, b)| *a -= b);
        row
    });
    for k in 0..4 {
        let largest = |i: &usize, j: &usize| rows[*i][k].abs().total_cmp(&rows[*j][k].abs());
        let pivot = (k..4).max_by(largest)?;
        rows.swap(k, pivot);
        let lead = rows[k];
        for (i, row) in rows.iter_mut().enumerate() {
            if i != k {
                let factor = row[k] / lead[k];
                row.iter_mut().zip(lead).for_each(|(a, b)| *a -= factor * b);
            }
        }
    }
    Some([0, 1, 2, 3].map(|k| rows[k][4] / rows[k][k]))
}
