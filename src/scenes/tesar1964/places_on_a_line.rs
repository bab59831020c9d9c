//! Chapter III: what is said of points of the moving plane with several places on a line.

use crate::number::poly::Fraction;
use crate::number::{Exact, Kind, Number, Real, Truth, count, linear};
use crate::plane::circle::Circle;
use crate::plane::displacement::Displacement;
use crate::plane::line::mirror;
use crate::plane::{Point, relation};
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::{Random, Symbols, point};
use crate::scenes::{Free, Unbuilt};

pub const COLLINEAR: Check = Check {
    name: "collinear-burmester-points",
    summary: "Five positions, all of them free, with the moving origin on the x-axis. A combination \
              of the four conditions for a circlepoint and its center, the determinant in which they \
              stand beside the numbers 1 - cos phi_j, sin phi_j, a_j, is free of the center and \
              linear in the coordinates of the circlepoint, and not zero for all: every finite pair \
              has its circlepoint on that line. The wrong variant takes the origin off the axis in \
              one position.",
    run: run_collinear,
};

pub const ONE_POINT: Check = Check {
    name: "one-point-with-four-places-on-a-line",
    summary: "Random positions. The points with three places on a line, of the positions 0, 1, 2 and \
              of 0, 1, 3, are on two circles through the image of the pole of 0 and 1, whose four \
              places are not on a line. Their other common point has all four on one. The wrong \
              variant asks for a fifth position too.",
    run: run_one_point,
};

fn run_collinear() -> Result<Report, Unbuilt> {
    Ok(Report {
        holds: have_a_line(None)?,
        wrong_variant: have_a_line(Some("b_4"))?,
        basis: Basis::Identity,
        instances: 0,
        exception: None,
    })
}

/// Whether the combination is linear in the circlepoint and free of the center; the ordinate of
/// the moving origin in the last position is zero or free.
fn have_a_line(ordinate: Option<&str>) -> Result<Truth, Unbuilt> {
    let mut free = Symbols::default();
    let mut positions = Vec::new();
    for j in 1..=4 {
        let rotation = free.angle(&format!("phi_{j}"))?.cis();
        let abscissa = free.number(&format!("a_{j}"))?;
        let ordinate = match ordinate {
            Some(name) if j == 4 => free.number(name)?,
            _ => Number::zero(),
        };
        positions.push(Displacement {
            rotation,
            translation: Number::complex(abscissa, ordinate),
        });
    }
    let [z, other, center, elsewhere] =
        ["z", "another z", "M", "another M"].map(|name| point(&mut free, name));
    let (z, other, center, elsewhere) = (z?, other?, center?, elsewhere?);
    let combined =
        |z: &Point<Fraction>, center: &Point<Fraction>| combination(&positions, z, center);
    let value = combined(&z, &center);
    let free_of_center = value.equals(&combined(&z, &elsewhere));
    let origin = Number::zero();
    let sum = combined(&(&z + &other), &center) + combined(&origin, &center);
    let linear = sum.equals(&(&value + combined(&other, &center)));
    let constant = value.equals(&combined(&origin, &center));
    Ok(free_of_center & linear & !constant)
}

/// The determinant of the rows |rz + t − M|² − |z − M|², 1 − cos φ, sin φ, a.
fn combination<K: Kind>(
    positions: &[Displacement<K>],
    z: &Point<K>,
    center: &Point<K>,
) -> Number<K> {
    let start = relation::distance_squared(z, center);
    let row = |position: &Displacement<K>| {
        vec![
            relation::distance_squared(&position.of(z), center) - &start,
            1 - position.rotation.re(),
            position.rotation.im().clone(),
            position.translation.re().clone(),
        ]
    };
    let rows: Vec<Vec<Number<K>>> = positions.iter().map(row).collect();
    linear::determinant(&rows)
}

const INSTANCES: u64 = 20;

fn run_one_point() -> Result<Report, Unbuilt> {
    let (mut holds, mut wrong) = (Truth::Yes, Truth::No);
    for seed in 0..INSTANCES {
        let positions = positions(&mut Random::new(seed))?;
        let [one, other, third, fourth] = positions.each_ref();
        let on_line = |point: &Point<Exact>, others: &[&Displacement<Exact>]| {
            let places = others.iter().map(|position| position.of(point));
            let all: Vec<_> = std::iter::once(point.clone()).chain(places).collect();
            relation::collinear(&all)
        };
        let pole = one.inverse().of(&one.pole(&Displacement::identity()));
        let [first, second] = [other, third].map(|last| three_on_a_line(one, last));
        let both = |point: &Point<Exact>| first.contains(point) & second.contains(point);
        let point = mirror(&pole, &first.center(), &second.center());
        let four = [one, other, third];
        holds = holds
            & both(&pole)
            & both(&point)
            & on_line(&point, &four)
            & !on_line(&pole, &four)
            & !first.is_line()
            & !first.center().equals(&second.center());
        wrong = wrong | on_line(&point, &[one, other, third, fourth]);
    }
    Ok(Report {
        holds,
        wrong_variant: wrong,
        basis: Basis::Instances,
        instances: count::from_u64(INSTANCES),
        exception: None,
    })
}

fn positions(random: &mut Random) -> Result<[Displacement<Exact>; 4], Unbuilt> {
    let mut position = |j: usize| -> Result<Displacement<Exact>, Unbuilt> {
        Ok(Displacement {
            rotation: Free::<Exact>::angle(random, &format!("phi_{j}"))?.cis(),
            translation: point(random, &format!("shift {j}"))?,
        })
    };
    Ok([position(1)?, position(2)?, position(3)?, position(4)?])
}

/// The circle of the points whose places in the first position, where the planes coincide, and in two
/// others are on a line, from twice the area of their triangle.
fn three_on_a_line<K: Real>(one: &Displacement<K>, other: &Displacement<K>) -> Circle<K> {
    let area = |x: i64, y: i64| {
        let point: Point<K> = Number::complex(x.into(), y.into());
        relation::twice_area(&point, &one.of(&point), &other.of(&point))
    };
    let d = area(0, 0);
    let [right, left, up] = [(1, 0), (-1, 0), (0, 1)].map(|(x, y)| area(x, y));
    let a = (&right + &left) / 2 - &d;
    Circle {
        b: (right - left) / 2,
        c: up - &d - &a,
        a,
        d,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_hold_and_the_wrong_variants_are_rejected() {
        for run in [run_collinear, run_one_point] {
            let report = run().unwrap();
            assert_eq!(
                (report.holds, report.wrong_variant),
                (Truth::Yes, Truth::No)
            );
        }
    }
}
