//! Positions of the moving plane for tests: random ones and every degenerate kind.
#![expect(
    clippy::indexing_slicing,
    reason = "a place that is not there is a failure of the test"
)]

use burmester::finite::positions::Positions;
use burmester::number::{Exact, Number};
use burmester::plane::displacement::Displacement;
use burmester::plane::{Angle, Point, line};
use proptest::prelude::*;

pub type Rational = Number<Exact>;
pub type Position = Displacement<Exact>;

pub fn number(numerator: i64, denominator: i64) -> Rational {
    Number::ratio(numerator, denominator)
}

pub fn point(x: i64, y: i64) -> Point<Exact> {
    Number::complex(x.into(), y.into())
}

/// The turn of this tangent of its half.
pub fn turn(numerator: i64, denominator: i64) -> Point<Exact> {
    Angle::from_tan_half(&number(numerator, denominator)).cis()
}

pub fn position(rotation: Point<Exact>, translation: Point<Exact>) -> Position {
    Displacement {
        rotation,
        translation,
    }
}

pub fn numbers() -> impl Strategy<Value = Rational> {
    (-40i64..=40, 1i64..12).prop_map(|(n, d)| number(n, d))
}

pub fn points() -> impl Strategy<Value = Point<Exact>> {
    (numbers(), numbers()).prop_map(|(x, y)| Number::complex(x, y))
}

/// Turns, half a revolution and none at all included.
pub fn turns() -> impl Strategy<Value = Point<Exact>> {
    prop_oneof![
        12 => numbers().prop_map(|t| Angle::from_tan_half(&t).cis()),
        1 => Just(point(-1, 0)),
        1 => Just(point(1, 0)),
    ]
}

pub fn positions() -> impl Strategy<Value = Position> {
    (turns(), points()).prop_map(|(rotation, translation)| position(rotation, translation))
}

pub fn four_positions() -> impl Strategy<Value = [Position; 4]> {
    [positions(), positions(), positions(), positions()]
}

pub fn with_poles(positions: &[Position; 4]) -> Positions<Exact> {
    Positions::new(positions.to_vec())
}

/// The rotation about a point that carries one point into another, as far from it.
fn rotation(about: &Point<Exact>, from: &Point<Exact>, to: &Point<Exact>) -> Position {
    Displacement::about(about, (to - about) / (from - about))
}

/// Four positions with the poles P₁₂, P₂₃, P₃₄, P₁₄ in these points, no two neighbours equal: D goes to
/// its mirror image in AB, to that in BC, and back.
pub fn from_quadrilateral([a, b, c, d]: &[Point<Exact>; 4]) -> [Position; 4] {
    let in_ab = line::mirror(d, a, b);
    let in_bc = line::mirror(d, b, c);
    let second = rotation(a, d, &in_ab);
    let third = rotation(b, &in_ab, &in_bc).after(&second);
    let fourth = rotation(c, &in_bc, d).after(&third);
    [Displacement::identity(), second, third, fourth]
}

/// A quadrilateral whose sides touch the unit circle in the points of these tangents of half angles: two
/// opposite sides are together as long as the others, up to signs.
pub fn tangential(halves: [(i64, i64); 4]) -> [Point<Exact>; 4] {
    let touch = halves.map(|(n, d)| turn(n, d));
    std::array::from_fn(|i| {
        // The tangents in u and v meet in 2uv/(u + v).
        let (u, v) = (&touch[i], &touch[(i + 1) % 4]);
        2 * u * v / (u + v)
    })
}

/// A degenerate configuration and its name.
pub struct Degenerate {
    pub name: &'static str,
    pub positions: [Position; 4],
}

/// Every degenerate kind.
pub fn degenerate() -> Vec<Degenerate> {
    let one = || point(1, 0);
    let half = || point(-1, 0);
    let of = |name, positions| Degenerate { name, positions };
    let at = |rotation: Point<Exact>, x, y| position(rotation, point(x, y));
    let about = |rotation: Point<Exact>, x, y| {
        position(rotation.clone(), point(x, y) - rotation * point(x, y))
    };
    vec![
        of(
            "two equal positions",
            [
                at(one(), 0, 0),
                at(one(), 0, 0),
                at(turn(1, 2), 3, 1),
                at(turn(2, 1), 1, 5),
            ],
        ),
        of(
            "three equal positions",
            [
                at(one(), 0, 0),
                at(one(), 0, 0),
                at(one(), 0, 0),
                at(turn(2, 1), 1, 5),
            ],
        ),
        of(
            "four equal positions",
            [
                at(turn(1, 3), 1, 2),
                at(turn(1, 3), 1, 2),
                at(turn(1, 3), 1, 2),
                at(turn(1, 3), 1, 2),
            ],
        ),
        of(
            "one pole at infinity",
            [
                at(one(), 0, 0),
                at(one(), 3, 1),
                at(turn(1, 2), 3, -1),
                at(turn(2, 1), 1, 5),
            ],
        ),
        of(
            "two poles at infinity",
            [
                at(one(), 0, 0),
                at(one(), 3, 1),
                at(turn(1, 2), 3, -1),
                at(turn(1, 2), 1, 5),
            ],
        ),
        of(
            "three poles at infinity",
            [
                at(one(), 0, 0),
                at(one(), 3, 1),
                at(one(), 2, -1),
                at(turn(1, 2), 1, 5),
            ],
        ),
        of(
            "three positions along a line",
            [
                at(one(), 0, 0),
                at(one(), 3, 1),
                at(one(), 6, 2),
                at(turn(1, 2), 1, 5),
            ],
        ),
        of(
            "four translations",
            [
                at(one(), 0, 0),
                at(one(), 3, 1),
                at(one(), 2, -1),
                at(one(), 1, 5),
            ],
        ),
        of(
            "four translations of a turned plane",
            [
                at(turn(1, 2), 0, 0),
                at(turn(1, 2), 3, 1),
                at(turn(1, 2), 2, -1),
                at(turn(1, 2), 1, 5),
            ],
        ),
        of(
            "four translations on a circle",
            [
                at(one(), 5, 0),
                at(one(), 3, 4),
                at(one(), -4, 3),
                at(one(), 0, -5),
            ],
        ),
        of(
            "four translations along a line",
            [
                at(one(), 0, 0),
                at(one(), 3, 1),
                at(one(), 6, 2),
                at(one(), -9, -3),
            ],
        ),
        of(
            "four rotations about a point",
            [
                about(one(), 2, 3),
                about(turn(1, 2), 2, 3),
                about(turn(2, 1), 2, 3),
                about(half(), 2, 3),
            ],
        ),
        of(
            "three rotations about a point",
            [
                about(one(), 2, 3),
                about(turn(1, 2), 2, 3),
                about(turn(2, 1), 2, 3),
                at(half(), 1, 7),
            ],
        ),
        of(
            "half revolutions",
            [
                at(one(), 0, 0),
                at(half(), 3, 1),
                at(one(), 2, -1),
                at(half(), 1, 5),
            ],
        ),
        of(
            "parallelogram",
            from_quadrilateral(&[point(0, 0), point(4, 1), point(6, 5), point(2, 4)]),
        ),
        of(
            "rhombus",
            from_quadrilateral(&[point(0, 0), point(4, 3), point(9, 3), point(5, 0)]),
        ),
        of(
            "rectangle",
            from_quadrilateral(&[point(0, 0), point(4, 0), point(4, 3), point(0, 3)]),
        ),
        of(
            "square",
            from_quadrilateral(&[point(1, 1), point(4, 3), point(2, 6), point(-1, 4)]),
        ),
        of(
            "kite",
            from_quadrilateral(&[point(0, 0), point(3, 2), point(7, 0), point(3, -2)]),
        ),
        of(
            "concave kite",
            from_quadrilateral(&[point(0, 0), point(3, 2), point(1, 0), point(3, -2)]),
        ),
        of(
            "crossed parallelogram",
            from_quadrilateral(&[point(-3, 0), point(-1, 2), point(3, 0), point(1, 2)]),
        ),
        of(
            "three collinear poles",
            from_quadrilateral(&[point(0, 0), point(3, 1), point(6, 2), point(1, 5)]),
        ),
        of(
            "nodal, opposite",
            from_quadrilateral(&tangential([(0, 1), (1, 2), (5, 1), (-2, 3)])),
        ),
        of(
            "nodal, adjacent",
            from_quadrilateral(&tangential([(1, 7), (3, 4), (9, 2), (-1, 1)])),
        ),
        of(
            "nodal, touching from outside",
            from_quadrilateral(&tangential([(1, 7), (1, 2), (2, 3), (3, 1)])),
        ),
    ]
}
