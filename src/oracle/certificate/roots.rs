//! Whether a list of points is all that two circlepoint curves have in common.

use super::conditions::Form;
use super::{Defect, elimination, require};
use crate::number::univariate::{Polynomial, isolate};
use crate::number::{Ball, Complex, Exact, Number};

type Entry = Number<Complex<Ball>>;
type Forms = [Form<Exact>; 4];

/// Directions in which points are told apart; two must serve.
const DIRECTIONS: [[i64; 2]; 5] = [[1, 0], [0, 1], [1, 1], [3, -1], [-2, 5]];

/// How the conditions are mixed: the first two share the points that the curves have in common besides.
const MIXTURES: [[[i64; 4]; 4]; 5] = [
    [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
    [[0, 0, 1, 0], [0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0]],
    [[1, 2, 0, 1], [0, 1, 3, -1], [0, 0, 1, 1], [0, 0, 0, 1]],
    [[2, 0, 1, 3], [1, 1, 0, 2], [0, 1, 1, 0], [0, 0, 1, 2]],
    [[1, -1, 2, 5], [0, 3, 1, -2], [1, 0, 0, 1], [0, 1, 0, 0]],
];

/// A finite point with how often it counts.
pub struct Listed {
    pub point: [Entry; 2],
    pub multiplicity: usize,
}

/// The polynomial of the values ax + by of the finite circlepoints, for whichever mixture of the
/// conditions gives one.
pub fn eliminant(forms: &Forms, direction: [i64; 2]) -> Option<Polynomial<Exact>> {
    MIXTURES.iter().find_map(|mixture| {
        let mixed = mixture.map(|factors| Form::sum(forms, factors));
        elimination::circlepoints(&mixed, direction)
    })
}

/// Passes where the points are the circlepoints of the conditions, each with its multiplicity, in two
/// directions at least.
pub fn check(forms: &Forms, listed: &[Listed], place: &str, bits: u32) -> Result<(), Defect> {
    let mut served = 0;
    for direction in DIRECTIONS {
        if let Some(polynomial) = eliminant(forms, direction) {
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

#[expect(clippy::indexing_slicing, reason = "there is a count for every root")]
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
