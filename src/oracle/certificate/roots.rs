//! Whether a list of points is all that two circlepoint curves have in common.

use super::{Defect, require};
use crate::finite::five_positions::circlepoint_curves::circlepoints;
use crate::number::univariate::{Polynomial, isolate};
use crate::number::{Ball, Complex, Exact, Number};
use crate::plane::displacement::Displacement;

type Entry = Number<Complex<Ball>>;
type Five = [Displacement<Exact>; 5];

/// Directions in which points are told apart; two must serve.
const DIRECTIONS: [[i64; 2]; 5] = [[1, 0], [0, 1], [1, 1], [3, -1], [-2, 5]];

/// Orders of the positions: the first three share the poles that the curves have in common besides.
const ORDERS: [[usize; 5]; 6] = [
    [0, 1, 2, 3, 4],
    [0, 1, 3, 2, 4],
    [0, 3, 4, 1, 2],
    [1, 2, 4, 0, 3],
    [2, 3, 4, 0, 1],
    [0, 1, 4, 2, 3],
];

/// A finite point with how often it counts.
pub struct Listed {
    pub point: [Entry; 2],
    pub multiplicity: usize,
}

/// The polynomial of the values ax + by of the finite circlepoints, for whichever order of the
/// positions gives one.
pub fn eliminant(positions: &Five, direction: [i64; 2]) -> Option<Polynomial<Exact>> {
    ORDERS.iter().find_map(|order| {
        let ordered = order.map(|place| positions[place].clone());
        circlepoints(&ordered, direction)
    })
}

/// Passes where the points are the circlepoints of the positions, each with its multiplicity, in two
/// directions at least.
pub fn check(positions: &Five, listed: &[Listed], place: &str, bits: u32) -> Result<(), Defect> {
    let mut served = 0;
    for direction in DIRECTIONS {
        if let Some(polynomial) = eliminant(positions, direction) {
            compare(&polynomial, direction, listed, place, bits)?;
            served += 1;
        }
        if served == 3 {
            break;
        }
    }
    if served < 2 {
        return Err(Defect::unchecked(
            "no independent elimination for these positions",
        ));
    }
    Ok(())
}

fn compare(
    polynomial: &Polynomial<Exact>,
    [a, b]: [i64; 2],
    listed: &[Listed],
    place: &str,
    bits: u32,
) -> Result<(), Defect> {
    let total: usize = listed.iter().map(|one| one.multiplicity).sum();
    require(
        polynomial.degree() == Some(total),
        place,
        "an independent elimination finds another number of pairs",
    )?;
    let roots = isolate(polynomial)
        .map_err(|error| Defect::unchecked(format!("roots of the eliminant: {error}")))?;
    let roots = roots.enclosures(bits);
    let mut counts = vec![0; roots.len()];
    for one in listed {
        let [x, y] = &one.point;
        let value = x * a + y * b;
        let meets = |(root, _): &(Entry, usize)| {
            root.re().0.overlaps(&value.re().0) && root.im().0.overlaps(&value.im().0)
        };
        let mut found = roots.iter().enumerate().filter(|(_, root)| meets(root));
        match (found.next(), found.next()) {
            (Some((root, _)), None) => counts[root] += one.multiplicity,
            (None, _) => {
                return Err(Defect::wrong(
                    place,
                    "a pair is none by an independent elimination",
                ));
            }
            _ => return Err(Defect::unchecked("the digits do not tell two pairs apart")),
        }
    }
    let right = roots.iter().zip(&counts).all(|((_, m), count)| m == count);
    require(
        right,
        place,
        "an independent elimination finds other multiplicities",
    )
}
