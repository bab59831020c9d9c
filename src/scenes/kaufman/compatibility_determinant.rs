//! When three loop equations have a solution.

use crate::number::linear;
use crate::number::poly::Fraction;
use crate::number::{Kind, Truth};
use crate::plane::Point;
use crate::scenes::check::{Basis, Check, Exception, Report};
use crate::scenes::free::{Symbols, point};
use crate::scenes::{Free, Unbuilt};

pub const CHECK: Check = Check {
    name: "compatibility-determinant",
    summary: "With all turns and shifts free: the determinant vanishes where the shifts come from a dyad. \
              Where Z and W solve two of the equations, the third misses by the determinant over the \
              minor of the two, so that a determinant that vanishes suffices where a minor does not \
              vanish. It vanishes as well for gamma_j = 0 and for gamma_j = phi_j, where all these minors \
              vanish while others do not: no solution. The wrong variant takes all cofactors with one \
              sign.",
    run,
};

type P = Point<Fraction>;

fn run() -> Result<Report, Unbuilt> {
    let mut free = Symbols::default();
    let mut turns = Vec::new();
    let mut cranks = Vec::new();
    let mut shifts = Vec::new();
    for j in 2..=4 {
        turns.push(free.angle(&format!("phi_{j}"))?.cis() - 1);
        cranks.push(free.angle(&format!("gamma_{j}"))?.cis() - 1);
        shifts.push(point(&mut free, &format!("delta_{j}"))?);
    }
    let (z, w) = (point(&mut free, "Z_1")?, point(&mut free, "W_1")?);
    let led: Vec<P> = turns
        .iter()
        .zip(&cranks)
        .map(|(turn, crank)| turn * &z + crank * &w)
        .collect();
    let holds = determinant(&turns, &cranks, &led).is_zero()
        & residual_is_determinant(&turns, &cranks, &shifts)
        & has_no_solution(&turns, &shifts);
    Ok(Report {
        holds,
        wrong_variant: permanent(&turns, &cranks, &led).is_zero(),
        basis: Basis::Identity,
        instances: 0,
        exception: Some(Exception {
            condition: "the crank neither stands still (gamma_j = 0) nor turns with the plane (gamma_j = \
                        phi_j) in all positions",
            counterexample: "gamma_j = phi_j for j = 2, 3, 4 and shifts not proportional to e^(i phi_j) - 1: \
                             the determinant vanishes, and there is no solution",
        }),
    })
}

#[expect(
    clippy::indexing_slicing,
    reason = "columns of three entries, for three positions beside the first"
)]
fn minor<K: Kind>(a: &[Point<K>], b: &[Point<K>], j: usize, k: usize) -> Point<K> {
    &a[j] * &b[k] - &a[k] * &b[j]
}

/// m (δ₄ − u₄ Z − g₄ W) = |u g δ| for the solution of the first two equations, m their minor; the minor
/// is not zero throughout.
fn residual_is_determinant(turns: &[P], cranks: &[P], shifts: &[P]) -> Truth {
    let first = minor(turns, cranks, 0, 1);
    let (z, w) = (minor(shifts, cranks, 0, 1), minor(turns, shifts, 0, 1));
    let ([_, _, u], [_, _, g], [_, _, delta]) = (turns, cranks, shifts) else {
        return Truth::Unknown;
    };
    let residual = &first * delta - u * z - g * w;
    residual.equals(&determinant(turns, cranks, shifts)) & !first.is_zero()
}

/// With the turns of the plane, or none, as those of the crank.
fn has_no_solution(turns: &[P], shifts: &[P]) -> Truth {
    let none = vec![P::zero(); 3];
    let unsolved = !minor(turns, shifts, 0, 1).is_zero();
    Truth::all([turns, none.as_slice()].map(|cranks| {
        let dependent = [(0, 1), (0, 2), (1, 2)].map(|(j, k)| minor(turns, cranks, j, k).is_zero());
        determinant(turns, cranks, shifts).is_zero() & Truth::all(dependent)
    })) & unsolved
}

/// The determinant of three columns.
fn determinant(a: &[P], b: &[P], c: &[P]) -> P {
    linear::determinant(&[a, b, c])
}

/// The determinant with plus for every minus.
#[expect(
    clippy::indexing_slicing,
    reason = "columns of three entries, for three positions beside the first"
)]
fn permanent(a: &[P], b: &[P], c: &[P]) -> P {
    (0..3)
        .map(|i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            &b[i] * (&a[j] * &c[k] + &a[k] * &c[j])
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
    }
}
