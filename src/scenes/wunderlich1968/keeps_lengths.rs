//! The focal mechanism keeps all its lengths while it moves.

use crate::linkage::{
    five_bar::{self, Lengths},
    focal_mechanism,
};
use crate::number::{Exact, Number, Truth};
use crate::plane::{Angle, Point, relation};
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::Random;
use crate::scenes::{Free, Unbuilt};

pub const CHECK: Check = Check {
    name: "focal-mechanism-keeps-its-lengths",
    summary: "Two positions of one focal mechanism, whose crank directions and angles omega are \
              random: the closure of both is solved for the lengths. AB, SF and TF must be equal in \
              both positions. The wrong variant lays PA and QB off to the other side.",
    run,
};

const INSTANCES: usize = 20;

/// The directions of one position.
struct Directions {
    u: Point<Exact>,
    v: Point<Exact>,
    omega: Angle<Exact>,
}

fn run() -> Result<Report, Unbuilt> {
    let mut free = Random::new(1968);
    let mut holds = Truth::Yes;
    let mut wrong_variant = Truth::Yes;
    for _ in 0..INSTANCES {
        let positions = [directions(&mut free)?, directions(&mut free)?];
        let (lengths, d) = close(&positions);
        let (a, b) = focal_mechanism::arms(&lengths);
        let (wrong_a, wrong_b) = (2 * &lengths.m - &a, 2 * &lengths.n - &b);
        holds = holds & keeps(&positions, &lengths, &d, &a, &b);
        wrong_variant = wrong_variant & keeps(&positions, &lengths, &d, &wrong_a, &wrong_b);
    }
    Ok(Report {
        holds,
        wrong_variant,
        basis: Basis::Instances,
        instances: INSTANCES,
        exception: None,
    })
}

fn directions(free: &mut Random) -> Result<Directions, Unbuilt> {
    Ok(Directions {
        u: free.angle("phi")?.direction().clone(),
        v: free.angle("psi")?.direction().clone(),
        omega: free.angle("omega")?,
    })
}

/// The lengths, up to scale, of the five-bar that has both positions: m u − p u w − n v − q v w = d
/// is four real linear equations; d = 1. A negative length is a bar laid off backwards.
fn close(positions: &[Directions; 2]) -> (Lengths<Exact>, Number<Exact>) {
    let columns = |directions: &Directions| {
        let Directions { u, v, omega } = directions;
        let w = omega.direction();
        [u.clone(), -(u * w), -v, -(v * w)]
    };
    let rows: Vec<[Number<Exact>; 5]> = positions
        .iter()
        .flat_map(|directions| {
            let columns = columns(directions);
            let re = columns.each_ref().map(|column| column.re().clone());
            let im = columns.each_ref().map(|column| column.im().clone());
            [(re, Number::one()), (im, Number::zero())]
        })
        .map(|([m, p, n, q], d)| [m, p, n, q, d])
        .collect();
    let [m, p, n, q] = solve(rows);
    (Lengths { m, p, q, n }, Number::one())
}

/// Solves four linear equations, each given with its right-hand side, by elimination; no value where
/// they are dependent.
#[expect(
    clippy::indexing_slicing,
    reason = "four rows of five entries, and each column takes one of the rows away"
)]
fn solve(mut rows: Vec<[Number<Exact>; 5]>) -> [Number<Exact>; 4] {
    let mut done: Vec<[Number<Exact>; 5]> = Vec::new();
    for column in 0..4 {
        let pivot = rows
            .iter()
            .position(|row| row[column].is_zero().is_no())
            .unwrap_or(0);
        let row = rows.swap_remove(pivot);
        let inverse = row[column].inverse();
        let row = row.map(|entry| entry * &inverse);
        for other in rows.iter_mut().chain(&mut done) {
            let factor = other[column].clone();
            for (entry, own) in other.iter_mut().zip(&row) {
                *entry -= &factor * own;
            }
        }
        done.push(row);
    }
    std::array::from_fn(|j| done[j][4].clone())
}

/// Whether AB, SF and TF are the same in both positions.
fn keeps(
    positions: &[Directions; 2],
    lengths: &Lengths<Exact>,
    d: &Number<Exact>,
    a: &Number<Exact>,
    b: &Number<Exact>,
) -> Truth {
    let [first, second] = positions;
    let s = five_bar::center_of_path(lengths, d, &first.omega, &second.omega);
    // T divides AB as S divides MN.
    let ratio = &s / d;
    let squares = positions.each_ref().map(|directions| {
        let Directions { u, v, omega } = directions;
        let base: Point<Exact> = d.clone().into();
        let f = u.scaled(&lengths.m) - (u * omega.direction()).scaled(&lengths.p);
        let pin_a = u.scaled(a);
        let pin_b = base + v.scaled(b);
        let t = &pin_a + (&pin_b - &pin_a).scaled(&ratio);
        [
            relation::distance_squared(&pin_a, &pin_b),
            relation::distance_squared(&f, &s.clone().into()),
            relation::distance_squared(&f, &t),
        ]
    });
    let [here, there] = squares;
    Truth::all(here.iter().zip(&there).map(|(x, y)| x.equals(y)))
}
