//! Five positions of a linkage that is chosen first, so that one or two of their pairs are known.

use serde_json::{Value, json};

use super::Problem;
use super::draw::Draw;
use super::pose::{self, Position, with_point_at};
use crate::number::{Exact, Number};
use crate::plane::displacement::Displacement;
use crate::plane::{Point, line};

type Pair = [Point<Exact>; 2];

fn pair([z, m]: &Pair) -> Value {
    json!({"circlepoint": pose::point(z), "center": pose::point(m)})
}

/// A problem with pairs that are known from how it was made.
fn known(kind: &str, flags: &[&'static str], positions: &[Position], pairs: &[Pair]) -> Problem {
    let pairs: Vec<Value> = pairs.iter().map(pair).collect();
    Problem::new(kind, flags, pose::problem("five-positions", positions))
        .claiming(json!({"known_pairs": pairs}))
}

pub fn links(draw: &mut Draw) -> Vec<Problem> {
    let mut problems = Vec::new();
    for round in 0..70 {
        problems.push(one_link(draw));
        problems.push(one_link_named(draw));
        problems.push(one_link(draw));
        problems.push(kite(draw));
        problems.push(antiparallelogram(draw));
        if round % 7 == 0 {
            problems.push(parallelogram(draw));
        }
    }
    problems
}

/// A link, and planes turned at random.
fn dyad(draw: &mut Draw) -> (Vec<Position>, Pair) {
    let (z, m) = (draw.point(), draw.point());
    let link = draw.direction();
    let (cranks, turns) = (draw.turns(5), draw.turns(5));
    let positions = cranks.iter().zip(&turns).map(|(crank, turn)| {
        let place = &m + crank * &link;
        with_point_at(turn, &z, &place)
    });
    (positions.collect(), [z, m])
}

fn one_link(draw: &mut Draw) -> Problem {
    let (positions, pair) = dyad(draw);
    known("one link", &["known-pair"], &positions, &[pair])
}

/// The same with the pair in the problem, so that the alternates are asked for.
fn one_link_named(draw: &mut Draw) -> Problem {
    let (positions, of_link) = dyad(draw);
    let mut problem = known(
        "one link, named",
        &["known-pair", "alternates"],
        &positions,
        std::slice::from_ref(&of_link),
    );
    if let Value::Object(fields) = &mut problem.input {
        fields.insert("known".into(), json!([pair(&of_link)]));
    }
    problem
}

/// Joints A and B of a coupler in five positions, as a problem.
fn coupler(draw: &mut Draw, kind: &str, bases: [Point<Exact>; 2], joints: &[Pair]) -> Problem {
    let z = draw.point();
    let spin = draw.turn();
    let [a0, b0] = bases;
    let Some([a, b]) = joints.first() else {
        return known(kind, &["real-linkage"], &[], &[]);
    };
    let w = &z + spin * (b - a);
    let moving = [z.clone(), w.clone()];
    let positions: Vec<Position> = joints
        .iter()
        .map(|places| Displacement::carrying(&moving, places))
        .collect();
    let flags = ["real-linkage", "known-pair"];
    known(kind, &flags, &positions, &[[z, a0], [w, b0]])
}

/// A₀A = AB, B₀B = B₀A₀: B is A₀ mirrored in AB₀.
fn kite(draw: &mut Draw) -> Problem {
    let (bases, joints) = folded(draw, |a0, _, _| a0.clone());
    coupler(draw, "kite", bases, &joints)
}

/// The parallelogram folded over its diagonal AB₀.
fn antiparallelogram(draw: &mut Draw) -> Problem {
    let (bases, joints) = folded(draw, |_, base, a| a + base);
    coupler(draw, "antiparallelogram", bases, &joints)
}

/// The pivots, and the joints A on a circle and B, a point that depends on A₀, A₀B₀ and A mirrored in
/// AB₀.
fn folded(
    draw: &mut Draw,
    point: impl Fn(&Point<Exact>, &Point<Exact>, &Point<Exact>) -> Point<Exact>,
) -> (Pair, Vec<Pair>) {
    loop {
        let (a0, base, link) = (draw.point(), draw.direction() * 3, draw.direction());
        let b0 = &a0 + &base;
        let cranks = draw.turns(5).into_iter();
        let joints: Vec<Pair> = cranks
            .map(|crank| {
                let a = &a0 + crank * &link;
                let b = line::mirror(&point(&a0, &base, &a), &a, &b0);
                [a, b]
            })
            .collect();
        // With equal sides it folds into a rhombus; A in B₀ has no diagonal.
        let is_rhombus = base.norm().equals(&link.norm()).is_yes();
        if !is_rhombus && joints.iter().all(|[_, b]| b.has_value()) {
            return ([a0, b0], joints);
        }
    }
}

/// Translations along a circle.
fn parallelogram(draw: &mut Draw) -> Problem {
    let (turn, center, link) = (draw.turn(), draw.point(), draw.direction());
    let cranks = draw.turns(5).into_iter();
    let positions: Vec<Position> = cranks
        .map(|crank| Displacement {
            rotation: turn.clone(),
            translation: &center + crank * &link,
        })
        .collect();
    let flags = ["degenerate", "parallel-positions", "family"];
    let input = pose::problem("five-positions", &positions);
    Problem::new("parallelogram", &flags, input).claiming(json!({"family": "plane"}))
}

pub fn sliders(draw: &mut Draw) -> Vec<Problem> {
    let mut problems = Vec::new();
    for _ in 0..40 {
        problems.push(slider(draw));
        problems.push(inverted(draw));
        problems.push(slider_and_link(draw));
    }
    problems
}

/// The direction across, as primitive integers may be written.
fn across(direction: &Point<Exact>) -> Point<Exact> {
    Number::i() * direction
}

/// Five different steps along a line.
fn steps(draw: &mut Draw) -> Vec<i64> {
    let mut steps: Vec<i64> = Vec::new();
    while steps.len() < 5 {
        let step = draw.integer(9);
        if !steps.contains(&step) {
            steps.push(step);
        }
    }
    steps
}

/// A point of the moving plane on a line.
fn sliding(draw: &mut Draw) -> (Vec<Position>, Point<Exact>, Point<Exact>) {
    let (z, start, along) = (draw.point(), draw.point(), draw.direction());
    let turns = draw.turns(5);
    let steps = steps(draw);
    let positions = turns.iter().zip(&steps).map(|(turn, step)| {
        let place = &start + &along * *step;
        with_point_at(turn, &z, &place)
    });
    (positions.collect(), z, across(&along))
}

fn slider(draw: &mut Draw) -> Problem {
    let (positions, z, direction) = sliding(draw);
    let slide = json!({"circlepoint": pose::point(&z), "direction": pose::point(&direction)});
    let input = pose::problem("five-positions", &positions);
    Problem::new("point on a line", &["pair-at-infinity"], input)
        .claiming(json!({"slides": [slide]}))
}

/// The inverse motion: a line of the moving plane through a fixed point.
fn inverted(draw: &mut Draw) -> Problem {
    let (positions, center, direction) = sliding(draw);
    let inverse: Vec<Position> = positions.iter().map(Displacement::inverse).collect();
    let block = json!({"direction": pose::point(&direction), "center": pose::point(&center)});
    let input = pose::problem("five-positions", &inverse);
    Problem::new("line through a point", &["pair-at-infinity"], input)
        .claiming(json!({"turning_blocks": [block]}))
}

/// A slider-crank by its joints: folded in turn over the line from the crank's pivot to the slider's
/// joint, and over the perpendicular from the crank's pin to the line of the slide.
#[expect(
    clippy::indexing_slicing,
    reason = "five positions; a field of an object"
)]
fn slider_and_link(draw: &mut Draw) -> Problem {
    let (pivot, joints) = loop {
        let pivot = Number::complex(Number::zero(), Number::from(draw.integer(5)));
        let joints = folded_in_turn(draw, &pivot);
        let places = joints.iter().enumerate();
        let mut others = places.flat_map(|(i, a)| joints.iter().skip(i + 1).map(move |b| (a, b)));
        let same = |[a, b]: &Pair, [c, d]: &Pair| (a.equals(c) & b.equals(d)).is_yes();
        if !others.any(|(one, other)| same(one, other)) {
            break (pivot, joints);
        }
    };
    let z = draw.point();
    let [first_a, first_b] = &joints[0];
    let w = &z + draw.turn() * (first_b - first_a);
    let moving = [z.clone(), w.clone()];
    let positions: Vec<Position> = joints
        .iter()
        .map(|places| Displacement::carrying(&moving, places))
        .collect();
    let slide = json!({"circlepoint": pose::point(&w), "direction": ["0", "1"]});
    let flags = ["real-linkage", "known-pair", "pair-at-infinity"];
    let mut problem = known("slider-crank", &flags, &positions, &[[z, pivot]]);
    problem.claims["slides"] = json!([slide]);
    problem
}

fn folded_in_turn(draw: &mut Draw, pivot: &Point<Exact>) -> Vec<Pair> {
    let mut a = Number::complex(draw.number().into(), Number::from(draw.positive(6) + 5));
    let mut b = Number::complex(draw.number().into(), Number::zero());
    let mut joints: Vec<Pair> = vec![[a.clone(), b.clone()]];
    for place in 0..4 {
        if place % 2 == 0 {
            a = line::mirror(&a, pivot, &b);
        } else {
            b = Number::complex(a.re() * 2 - b.re(), Number::zero());
        }
        joints.push([a.clone(), b.clone()]);
    }
    joints
}
