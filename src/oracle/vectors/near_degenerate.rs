//! Degenerate problems, disturbed by powers of ten: what is one thing in the limit is another near it.

use rug::Rational;
use serde_json::{Value, json};

use super::degenerate;
use super::draw::{Draw, turn};
use super::pose::{self, Position, tenth};
use super::{Corpus, Problem};
use crate::number::text::parse_rational;
use crate::number::{Exact, Number, count};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// Distances 10^−k for these k.
const DISTANCES: [u32; 6] = [1, 2, 4, 6, 9, 12];

pub fn five_positions(draw: &mut Draw) -> Vec<Problem> {
    let mut problems = Vec::new();
    for distance in 1..=12 {
        for _ in 0..3 {
            problems.push(close_positions(draw, 5, distance));
            problems.push(close_angles(draw, 5, distance));
            problems.push(nearly_equal(draw, 5, distance));
        }
    }
    for (place, (name, positions)) in bases().iter().enumerate() {
        for distance in DISTANCES {
            let turned = (place + count::from_u32(distance)).is_multiple_of(2);
            problems.push(disturbed(
                draw,
                "five-positions",
                name,
                positions,
                distance,
                turned,
            ));
        }
    }
    problems
}

pub fn four_positions(draw: &mut Draw) -> Vec<Problem> {
    let mut problems = Vec::new();
    for distance in 1..=12 {
        problems.push(close_positions(draw, 4, distance));
        problems.push(close_angles(draw, 4, distance));
        problems.push(nearly_equal(draw, 4, distance));
    }
    for (place, (name, positions)) in degenerate::FOUR.iter().enumerate() {
        for distance in DISTANCES {
            let turned = (place + count::from_u32(distance)).is_multiple_of(2);
            problems.push(disturbed(
                draw,
                "centerpoint-curve",
                name,
                &positions(),
                distance,
                turned,
            ));
        }
    }
    problems
}

/// The degenerate five positions that are given by cosine and sine.
fn bases() -> Vec<(String, Vec<Position>)> {
    let lines = Corpus::named("degenerate-five-positions").map(Corpus::lines);
    let problems = lines.unwrap_or_default().into_iter();
    let problems = problems.filter_map(|line| serde_json::from_str::<Value>(&line).ok());
    problems
        .filter_map(|problem| {
            let name = problem.get("id")?.as_str()?.rsplit('/').next()?.to_owned();
            let listed = problem.get("positions")?;
            let positions: Option<Vec<Position>> = listed.as_array()?.iter().map(read).collect();
            // Cosines and sines of too many digits would only make the file longer.
            let is_short = listed.to_string().len() < 600;
            is_short.then_some((name, positions?))
        })
        .collect()
}

fn read(position: &Value) -> Option<Position> {
    let number = |value: &Value| -> Option<Number<Exact>> {
        Some(Number::from(parse_rational(value.as_str()?).ok()?))
    };
    let angle = &position["angle"];
    Some(Displacement {
        rotation: Number::complex(number(&angle["cos"])?, number(&angle["sin"])?),
        translation: Number::complex(number(&position["x"])?, number(&position["y"])?),
    })
}

fn problem(name: &str, kind: &str, distance: u32, positions: &[Position]) -> Problem {
    let kind = format!("{kind}, 10^-{distance}");
    Problem::new(kind, &["near-degenerate"], pose::problem(name, positions))
}

fn name_of(count: usize) -> &'static str {
    if count == 4 {
        "centerpoint-curve"
    } else {
        "five-positions"
    }
}

/// A small point.
fn small(draw: &mut Draw, size: &Rational) -> Point<Exact> {
    let [x, y] = [draw.integer(9), draw.integer(9)];
    Number::complex(x.into(), y.into()).scaled(&Number::from(size.clone()))
}

/// A turn by a small angle that is not zero.
fn small_turn(draw: &mut Draw, size: &Rational) -> Point<Exact> {
    let sign = if draw.below(2) == 0 { 1 } else { -1 };
    turn(&(Rational::from(size) * (sign * draw.positive(9))))
}

/// Positions that all lie near one, which turn and move little: nearly the infinitesimal case.
fn close_positions(draw: &mut Draw, count: usize, distance: u32) -> Problem {
    let size = tenth(distance);
    let first = Displacement {
        rotation: draw.turn(),
        translation: draw.point(),
    };
    let mut positions = vec![first.clone()];
    for _ in 1..count {
        positions.push(Displacement {
            rotation: &first.rotation * small_turn(draw, &size),
            translation: &first.translation + small(draw, &size),
        });
    }
    problem(name_of(count), "close positions", distance, &positions)
}

/// Positions that are nearly translations of each other.
fn close_angles(draw: &mut Draw, count: usize, distance: u32) -> Problem {
    let size = tenth(distance);
    let first = draw.turn();
    let positions: Vec<Position> = (0..count)
        .map(|place| Displacement {
            rotation: if place == 0 {
                first.clone()
            } else {
                &first * small_turn(draw, &size)
            },
            translation: draw.point(),
        })
        .collect();
    problem(name_of(count), "close angles", distance, &positions)
}

/// The last position is nearly the first.
#[expect(clippy::indexing_slicing, reason = "there are at least two positions")]
fn nearly_equal(draw: &mut Draw, count: usize, distance: u32) -> Problem {
    let size = tenth(distance);
    let turns = draw.turns(count - 1);
    let mut positions: Vec<Position> = turns
        .into_iter()
        .map(|rotation| Displacement {
            rotation,
            translation: draw.point(),
        })
        .collect();
    let first = &positions[0];
    positions.push(Displacement {
        rotation: &first.rotation * small_turn(draw, &size),
        translation: &first.translation + small(draw, &size),
    });
    problem(
        name_of(count),
        "nearly equal positions",
        distance,
        &positions,
    )
}

/// The places moved by so much, or the last two positions turned.
fn disturbed(
    draw: &mut Draw,
    name: &str,
    base: &str,
    positions: &[Position],
    distance: u32,
    turned: bool,
) -> Problem {
    let size = tenth(distance);
    let mut list = positions.to_vec();
    let count = list.len();
    for (place, position) in list.iter_mut().enumerate() {
        if turned && place + 2 >= count {
            position.rotation = &position.rotation * small_turn(draw, &size);
        } else if !turned {
            position.translation = &position.translation + small(draw, &size);
        }
    }
    let how = if turned { "turned" } else { "moved" };
    let mut problem = problem(name, base, distance, &list);
    problem.claims = json!({});
    problem.noted(format!(
        "The degenerate problem {base}, {how} by about 10^-{distance}."
    ))
}
