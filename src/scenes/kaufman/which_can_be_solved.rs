//! The digression: which equations, and which unknowns, can be solved for.

use super::linear_equations::{EQUATIONS_IN_THREE_UNKNOWNS, THREE_EQUATIONS};
use crate::number::linear::rank;
use crate::number::{Exact, Number, Truth};
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};

pub const EQUATIONS: Check = Check {
    name: "pairs-of-equations-that-can-be-solved",
    summary: "By elimination: the three equations are consistent; the first and second determine the two \
              unknowns, and so do the second and third, but not the first and third. The wrong variant \
              says that all pairs do.",
    run: run_equations,
};

pub const UNKNOWNS: Check = Check {
    name: "unknowns-that-can-be-solved-for",
    summary: "By elimination: the coefficients and the augmented matrix have rank 2; for a given X the \
              equations determine Y and Z; for Z = 0 they are inconsistent in X and Y. The wrong \
              variant says that a given Z determines X and Y.",
    run: run_unknowns,
};

fn run_equations() -> Result<Report, Unbuilt> {
    let rows = |chosen: &[usize]| matrix(&THREE_EQUATIONS, chosen);
    let determine = |chosen: &[usize]| Solvable::of(rows(chosen)) == Solvable::Once;
    let consistent = Solvable::of(rows(&[0, 1, 2])) != Solvable::Never;
    let both = consistent && determine(&[0, 1]) && determine(&[1, 2]);
    Ok(report(
        both && !determine(&[0, 2]),
        both && determine(&[0, 2]),
    ))
}

fn run_unknowns() -> Result<Report, Unbuilt> {
    let all = matrix(&EQUATIONS_IN_THREE_UNKNOWNS, &[0, 1, 2]);
    let left: Matrix = all
        .iter()
        .map(|row| row.iter().take(3).cloned().collect())
        .collect();
    let ranks = rank(&left, 3) == Some(2) && rank(&all, 4) == Some(2);
    // A number for an unknown moves its column to the right side.
    let given = |unknown: usize, value: i64| {
        let rows = all.iter().map(|row| {
            let mut row = row.clone();
            let coefficient = row.remove(unknown);
            if let Some(right) = row.last_mut() {
                *right -= coefficient * value;
            }
            row
        });
        Solvable::of(rows.collect())
    };
    let by_x = given(0, 7) == Solvable::Once;
    let by_z = given(2, 0);
    Ok(report(
        ranks && by_x && by_z == Solvable::Never,
        ranks && by_x && by_z == Solvable::Once,
    ))
}

fn report(holds: bool, wrong_variant: bool) -> Report {
    Report {
        holds: Truth::from(holds),
        wrong_variant: Truth::from(wrong_variant),
        basis: Basis::Exact,
        instances: 1,
        exception: None,
    }
}

/// How many solutions equations have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Solvable {
    Never,
    Once,
    Often,
}

impl Solvable {
    /// Of equations given by their coefficients and their right sides.
    fn of(rows: Matrix) -> Self {
        let unknowns = rows.first().map_or(0, |row| row.len() - 1);
        let rank_of_left = rank(&rows, unknowns);
        if rank(&rows, unknowns + 1) > rank_of_left {
            Solvable::Never
        } else if rank_of_left == Some(unknowns) {
            Solvable::Once
        } else {
            Solvable::Often
        }
    }
}

type Matrix = Vec<Vec<Number<Exact>>>;

fn matrix<const N: usize>(rows: &[[i64; N]], chosen: &[usize]) -> Matrix {
    chosen
        .iter()
        .filter_map(|row| rows.get(*row))
        .map(|row| row.map(Number::from).to_vec())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_and_the_wrong_variant_is_rejected() {
        for run in [run_equations, run_unknowns] {
            let report = run().unwrap();
            assert_eq!(
                (report.holds, report.wrong_variant),
                (Truth::Yes, Truth::No)
            );
        }
    }
}
