//! Three and four positions of every degenerate kind.

use serde_json::{Value, json};

use super::Problem;
use super::draw::turn;
use super::pose::{self, Position, at};
use crate::number::{Exact, array};
use crate::plane::displacement::Displacement;
use crate::plane::{Point, line};

fn one() -> Point<Exact> {
    at(1, 0)
}

fn half() -> Point<Exact> {
    at(-1, 0)
}

/// The turn of this tangent of its half.
fn by(numerator: i64, denominator: i64) -> Point<Exact> {
    turn(&(numerator, denominator).into())
}

fn to(rotation: Point<Exact>, x: i64, y: i64) -> Position {
    Displacement {
        rotation,
        translation: at(x, y),
    }
}

fn about(rotation: Point<Exact>, x: i64, y: i64) -> Position {
    Displacement::about(&at(x, y), rotation)
}

/// The rotation about a point that carries one point into another, as far from it.
fn carrying(center: &Point<Exact>, from: &Point<Exact>, to: &Point<Exact>) -> Position {
    Displacement::about(center, (to - center) / (from - center))
}

/// Four positions with the poles 12, 23, 34, 14 in these points, no two neighbours equal: D goes to
/// its mirror image in AB, to that in BC, and back.
fn of_quadrilateral([a, b, c, d]: &[Point<Exact>; 4]) -> Vec<Position> {
    let in_ab = line::mirror(d, a, b);
    let in_bc = line::mirror(d, b, c);
    let second = carrying(a, d, &in_ab);
    let third = carrying(b, &in_ab, &in_bc).after(&second);
    let fourth = carrying(c, &in_bc, d).after(&third);
    vec![Displacement::identity(), second, third, fourth]
}

fn quadrilateral(points: [(i64, i64); 4]) -> Vec<Position> {
    of_quadrilateral(&points.map(|(x, y)| at(x, y)))
}

/// A quadrilateral whose sides touch the unit circle in the points of these tangents of half angles: two
/// sides are together as long as the others, up to signs.
fn tangential(halves: [(i64, i64); 4]) -> Vec<Position> {
    let touch = halves.map(|(n, d)| by(n, d));
    // The tangents in u and v meet in 2uv/(u + v).
    of_quadrilateral(&array::sides(&touch).map(|(u, v)| 2 * u * v / (u + v)))
}

/// How positions of a kind are made.
type Make = fn() -> Vec<Position>;

/// Four positions by their kind.
pub const FOUR: [(&str, Make); 25] = [
    ("two equal positions", || {
        vec![
            to(one(), 0, 0),
            to(one(), 0, 0),
            to(by(1, 2), 3, 1),
            to(by(2, 1), 1, 5),
        ]
    }),
    ("three equal positions", || {
        vec![
            to(one(), 0, 0),
            to(one(), 0, 0),
            to(one(), 0, 0),
            to(by(2, 1), 1, 5),
        ]
    }),
    ("four equal positions", || vec![to(by(1, 3), 1, 2); 4]),
    ("one pole at infinity", || {
        vec![
            to(one(), 0, 0),
            to(one(), 3, 1),
            to(by(1, 2), 3, -1),
            to(by(2, 1), 1, 5),
        ]
    }),
    ("two poles at infinity", || {
        vec![
            to(one(), 0, 0),
            to(one(), 3, 1),
            to(by(1, 2), 3, -1),
            to(by(1, 2), 1, 5),
        ]
    }),
    ("three poles at infinity", || {
        vec![
            to(one(), 0, 0),
            to(one(), 3, 1),
            to(one(), 2, -1),
            to(by(1, 2), 1, 5),
        ]
    }),
    ("three positions along a line", || {
        vec![
            to(one(), 0, 0),
            to(one(), 3, 1),
            to(one(), 6, 2),
            to(by(1, 2), 1, 5),
        ]
    }),
    ("four translations", || translations(one())),
    ("four translations of a turned plane", || {
        translations(by(1, 2))
    }),
    ("four translations on a circle", || {
        vec![
            to(one(), 5, 0),
            to(one(), 3, 4),
            to(one(), -4, 3),
            to(one(), 0, -5),
        ]
    }),
    ("four translations along a line", || {
        vec![
            to(one(), 0, 0),
            to(one(), 3, 1),
            to(one(), 6, 2),
            to(one(), -9, -3),
        ]
    }),
    ("four rotations about a point", || {
        vec![
            about(one(), 2, 3),
            about(by(1, 2), 2, 3),
            about(by(2, 1), 2, 3),
            about(half(), 2, 3),
        ]
    }),
    ("three rotations about a point", || {
        vec![
            about(one(), 2, 3),
            about(by(1, 2), 2, 3),
            about(by(2, 1), 2, 3),
            to(half(), 1, 7),
        ]
    }),
    ("half revolutions", || {
        vec![
            to(one(), 0, 0),
            to(half(), 3, 1),
            to(one(), 2, -1),
            to(half(), 1, 5),
        ]
    }),
    ("parallelogram", || {
        quadrilateral([(0, 0), (4, 1), (6, 5), (2, 4)])
    }),
    ("rhombus", || {
        quadrilateral([(0, 0), (4, 3), (9, 3), (5, 0)])
    }),
    ("rectangle", || {
        quadrilateral([(0, 0), (4, 0), (4, 3), (0, 3)])
    }),
    ("square", || {
        quadrilateral([(1, 1), (4, 3), (2, 6), (-1, 4)])
    }),
    ("kite", || quadrilateral([(0, 0), (3, 2), (7, 0), (3, -2)])),
    ("concave kite", || {
        quadrilateral([(0, 0), (3, 2), (1, 0), (3, -2)])
    }),
    ("crossed parallelogram", || {
        quadrilateral([(-3, 0), (-1, 2), (3, 0), (1, 2)])
    }),
    ("three collinear poles", || {
        quadrilateral([(0, 0), (3, 1), (6, 2), (1, 5)])
    }),
    ("nodal, opposite", || {
        tangential([(0, 1), (1, 2), (5, 1), (-2, 3)])
    }),
    ("nodal, adjacent", || {
        tangential([(1, 7), (3, 4), (9, 2), (-1, 1)])
    }),
    ("nodal, touching from outside", || {
        tangential([(1, 7), (1, 2), (2, 3), (3, 1)])
    }),
];

fn translations(rotation: Point<Exact>) -> Vec<Position> {
    [(0, 0), (3, 1), (2, -1), (1, 5)]
        .map(|(x, y)| to(rotation.clone(), x, y))
        .to_vec()
}

/// How many poles are at infinity, and how many are not determined, told from the positions alone.
fn poles(positions: &[Position]) -> Value {
    let (mut infinite, mut undetermined) = (0, 0);
    for (i, a) in positions.iter().enumerate() {
        for b in positions.iter().skip(i + 1) {
            let parallel = a.rotation.equals(&b.rotation).is_yes();
            let same = a.translation.equals(&b.translation).is_yes();
            infinite += i32::from(parallel && !same);
            undetermined += i32::from(parallel && same);
        }
    }
    json!({"poles_at_infinity": infinite, "undetermined_poles": undetermined})
}

fn flags(positions: &[Position]) -> Vec<&'static str> {
    let claims = poles(positions);
    let mut flags = vec!["degenerate"];
    if claims.get("poles_at_infinity") != Some(&json!(0)) {
        flags.push("pole-at-infinity");
    }
    if claims.get("undetermined_poles") != Some(&json!(0)) {
        flags.push("equal-positions");
    }
    flags
}

/// Words that serve in an id.
fn slug(kind: &str) -> String {
    kind.replace(", ", "-").replace(' ', "-")
}

#[expect(clippy::indexing_slicing, reason = "a field of an object")]
pub fn four_positions() -> Vec<Problem> {
    let problem = |(kind, make): &(&str, fn() -> Vec<Position>)| {
        let positions = make();
        let mut claims = poles(&positions);
        // The sides touch one circle: the curve has a node, or falls apart.
        if kind.starts_with("nodal") {
            claims["type"] = json!("nodal");
        }
        let input = pose::problem("centerpoint-curve", &positions);
        Problem::new(*kind, &flags(&positions), input)
            .named(slug(kind))
            .claiming(claims)
    };
    FOUR.iter().map(problem).collect()
}

/// Three positions by their kind, with what a person should know.
const THREE: [(&str, Make, &str); 9] = [
    (
        "two equal positions",
        || vec![to(one(), 0, 0), to(by(1, 2), 3, 1), to(one(), 0, 0)],
        "Two places of every point coincide: a whole line of centers, so that none is determined.",
    ),
    (
        "three equal positions",
        || vec![to(by(1, 2), 3, 1); 3],
        "Nothing moves: nothing is determined.",
    ),
    (
        "one pole at infinity",
        || vec![to(one(), 0, 0), to(one(), 4, 2), to(by(1, 2), 3, 1)],
        "A translation: its pole is at infinity across it.",
    ),
    (
        "three translations",
        || vec![to(one(), 0, 0), to(one(), 4, 2), to(one(), -1, 3)],
        "Every point has congruent places, and its center at the same shift from it.",
    ),
    (
        "three translations along a line",
        || vec![to(one(), 0, 0), to(one(), 4, 2), to(one(), -6, -3)],
        "Every point moves along a line: all centers are at infinity, across it.",
    ),
    (
        "rotations about a point",
        || {
            vec![
                about(one(), 2, 3),
                about(by(1, 2), 2, 3),
                about(by(-1, 3), 2, 3),
            ]
        },
        "One pole for all: the center of every point.",
    ),
    (
        "half turn",
        || vec![to(one(), 0, 0), to(half(), 4, 2), to(by(1, 2), 1, 0)],
        "A half turn has no tangent of its half.",
    ),
    (
        "collinear poles",
        || vec![to(one(), 0, 0), to(half(), 4, 0), to(one(), 6, 0)],
        "Two half turns make a translation: two poles and the direction of the third lie on a line.",
    ),
    (
        "points on the poles",
        || vec![to(one(), 0, 0), to(half(), 2, 0), to(by(1, 1), 0, 4)],
        "The first circlepoint is the pole of the first two positions in the moving plane: it has two different places only, and no center that is determined.",
    ),
];

pub fn three_positions() -> Vec<Problem> {
    let problem = |(kind, make, note): &(&str, fn() -> Vec<Position>, &str)| {
        let positions = make();
        let input = json!({
            "problem": "three-positions",
            "positions": pose::positions(&positions),
            "circlepoints": [["1", "0"], ["0", "0"], ["2", "3"], ["-1", "1/2"]],
            "centers": [["2", "3"], ["1", "0"], ["0", "5"]],
        });
        Problem::new(*kind, &flags(&positions), input)
            .named(slug(kind))
            .noted(*note)
            .claiming(poles(&positions))
    };
    THREE.iter().map(problem).collect()
}
