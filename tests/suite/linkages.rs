//! Problems made from a real linkage always find it, and find nothing wrong with it.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use crate::support::seed;
use burmester::number::text::parse_rational;
use burmester::number::{Ball, Number};
use burmester::oracle::{self, Request};
use burmester::plane::Point;
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use rug::Rational;
use serde_json::{Value, json};

const BITS: u32 = 200;

fn ball(q: &Rational) -> Number<Ball> {
    Number::rounded(q, &BITS)
}

fn middle(x: &Number<Ball>) -> Rational {
    x.0.midpoint_rational().unwrap()
}

/// Five tangents of half angles in the order of their angles, all around.
fn turning(random: &mut ChaCha8Rng) -> Vec<Rational> {
    let mut list: Vec<i64> = (-40..=40).collect();
    while list.len() > 5 {
        list.remove(random.random_range(0..list.len()));
    }
    // tan from −40/9 to 40/9.
    list.into_iter().map(|n| Rational::from((n, 9))).collect()
}

/// e^{iθ} of the tangent of the half of it.
fn turn(t: &Rational) -> [Rational; 2] {
    let square = Rational::from(t.square_ref());
    let scale = Rational::from(1 + &square);
    [(1 - square) / &scale, Rational::from(2 * t) / scale]
}

fn tan_half(direction: &Point<Ball>) -> Rational {
    let length = direction.norm().sqrt();
    middle(&(direction.im() / (length + direction.re())))
}

/// x, y and the tangent of half the angle.
type Pose = [Rational; 3];

/// The fixed plane seen from the moving one.
fn inverse([x, y, t]: &Pose) -> Pose {
    let [cos, sin] = turn(t);
    let back_x = Rational::from(&cos * x) + Rational::from(&sin * y);
    let back_y = Rational::from(&cos * y) - Rational::from(&sin * x);
    [-back_x, -back_y, Rational::from(-t)]
}

fn problem(poses: &[Pose], wishes: Value) -> Value {
    let position = |[x, y, t]: &Pose| json!({"x": x.to_string(), "y": y.to_string(), "angle": {"tan_half": t.to_string()}});
    let positions: Vec<Value> = poses.iter().map(position).collect();
    json!({"problem": "five-positions", "positions": positions, "wishes": wishes})
}

fn solved(problem: &Value) -> Value {
    let answer = oracle::solve(problem, &Request::default()).unwrap();
    assert!(answer.get("undecided").is_none(), "{answer}");
    answer
}

fn near(value: &Value, expected: &Rational) -> bool {
    let text = value
        .get("exact")
        .or(value.get("value"))
        .and_then(Value::as_str)
        .unwrap();
    (parse_rational(text).unwrap() - expected).abs() < Rational::from((1, 1_000_000_000))
}

/// The place of the pair whose point of this name is there.
fn place(list: &Value, name: &str, [x, y]: [&Rational; 2]) -> usize {
    let found = list
        .as_array()
        .unwrap()
        .iter()
        .position(|pair| near(&pair[name][0], x) && near(&pair[name][1], y));
    found.unwrap_or_else(|| panic!("no {name} {x}, {y} in {list}"))
}

/// The linkage of these pairs, and which of its drives is at the first of them.
fn linkage<'a>(
    answer: &'a Value,
    first: &Value,
    second: &Value,
) -> (usize, &'a Value, &'static str) {
    let list = answer["linkages"].as_array().unwrap();
    for (place, linkage) in list.iter().enumerate() {
        if linkage["pairs"] == json!([first, second]) {
            return (place, linkage, "first");
        }
        if linkage["pairs"] == json!([second, first]) {
            return (place, linkage, "second");
        }
    }
    panic!("no linkage of {first} and {second}: {answer}");
}

fn assert_passes(answer: &Value, first: &Value, second: &Value, kind: &str) {
    let (place, linkage, drive) = linkage(answer, first, second);
    assert_eq!(linkage["type"], json!(kind), "{linkage}");
    assert_eq!(linkage["circuit"], json!(true), "{linkage}");
    assert_eq!(linkage["crank"][drive], json!(true), "{linkage}");
    assert_eq!(linkage["branch"][drive], json!(true), "{linkage}");
    assert_eq!(linkage["order"][drive], json!([1, 2, 3, 4, 5]), "{linkage}");
    assert!(
        linkage["transmission"][drive]["least"].is_object(),
        "{linkage}"
    );
    assert_eq!(linkage["fulfils"], json!(true), "{linkage}");
    assert_eq!(linkage["misses"], json!([]), "{linkage}");
    assert!(
        answer["ranked"].as_array().unwrap().contains(&json!(place)),
        "{answer}"
    );
}

fn wishes() -> Value {
    json!({"crank_driven": true, "without_defects": true, "in_order": true,
        "pivots_within": {"circle": {"center": ["0", "0"], "radius": "50"}}})
}

/// Crank-and-levers and drag-links, the crank turning counterclockwise.
#[test]
fn four_bars_are_found() {
    let mut random = seed::generator("four_bars_are_found");
    let mut found = 0;
    while found < seed::rounds(10) {
        let [a, b, c, d]: [i64; 4] = std::array::from_fn(|_| random.random_range(2..15));
        // The crank with the longest of the others is shorter than the remaining two, or the base is.
        let others = |s: i64| s + [a, b, c, d].into_iter().max().unwrap() < (a + b + c + d) / 2;
        let kind = if a < b.min(c).min(d) && others(a) {
            "crank-and-lever"
        } else if d < a.min(b).min(c) && others(d) {
            "drag-link"
        } else {
            continue;
        };
        let side: i64 = if random.random() { 1 } else { -1 };
        let base: Point<Ball> = Number::complex(ball(&d.into()), Number::zero());
        let poses: Vec<Pose> = turning(&mut random)
            .iter()
            .map(|t| {
                let [cos, sin] = turn(t);
                let [x, y] = [cos * a, sin * a];
                let pin = Number::complex(ball(&x), ball(&y));
                let to_n = &base - &pin;
                let square = to_n.norm();
                let along = (c * c - b * b + &square) / (2 * &square);
                let across = (c * c / &square - along.square()).sqrt() * side;
                [x, y, tan_half(&(to_n * Number::complex(along, across)))]
            })
            .collect();
        let answer = solved(&problem(&poses, wishes()));
        let zero = Rational::new();
        let crank = place(&answer["pairs"], "circlepoint", [&zero, &zero]);
        let lever = place(&answer["pairs"], "circlepoint", [&c.into(), &zero]);
        assert_passes(&answer, &json!(crank), &json!(lever), kind);
        found += 1;
    }
}

/// The origin of the moving plane slides along a line, a second point is on a crank.
fn slider_crank(random: &mut ChaCha8Rng) -> ([i64; 3], Vec<Pose>) {
    let (r, e) = (random.random_range(1..6), random.random_range(-4i64..=4));
    let l = r + e.abs() + random.random_range(1..5);
    let side: i64 = if random.random() { 1 } else { -1 };
    let poses = turning(random).into_iter().map(|t| {
        let [cos, sin] = turn(&t);
        let pin = Number::complex(ball(&(cos * r)), ball(&(sin * r)));
        let room = (l * l - (pin.im() - e).square()).sqrt() * side;
        let x = middle(&(pin.re() + room));
        let slider = Number::complex(ball(&x), e.into());
        [x, Rational::from(e), tan_half(&(pin - slider))]
    });
    ([r, l, e], poses.collect())
}

#[test]
fn slider_cranks_are_found() {
    let mut random = seed::generator("slider_cranks_are_found");
    for _ in 0..seed::rounds(8) {
        let ([_, l, _], poses) = slider_crank(&mut random);
        let answer = solved(&problem(&poses, wishes()));
        let zero = Rational::new();
        assert_eq!(
            answer["at_infinity"][0]["kind"],
            json!("center"),
            "{answer}"
        );
        let crank = place(&answer["pairs"], "circlepoint", [&l.into(), &zero]);
        assert_passes(
            &answer,
            &json!(crank),
            &json!({"at_infinity": 0}),
            "slider-crank",
        );
    }
}

/// The same linkages with another link held fast: the crank's point becomes the pivot.
#[test]
fn inverted_slider_cranks_are_found() {
    let mut random = seed::generator("inverted_slider_cranks_are_found");
    for _ in 0..seed::rounds(8) {
        let ([_, l, _], poses) = slider_crank(&mut random);
        let poses: Vec<Pose> = poses.iter().map(inverse).collect();
        let answer = solved(&problem(&poses, json!({"without_defects": true})));
        let zero = Rational::new();
        assert_eq!(
            answer["at_infinity"][0]["kind"],
            json!("circlepoint"),
            "{answer}"
        );
        let link = place(&answer["pairs"], "center", [&l.into(), &zero]);
        let (_, linkage, drive) = linkage(&answer, &json!(link), &json!({"at_infinity": 0}));
        // The connecting rod is the base now: the crank is shortest and turns fully against it.
        assert_eq!(linkage["type"], json!("inverted-slider-crank"), "{linkage}");
        assert_eq!(
            (
                &linkage["crank"][drive],
                &linkage["circuit"],
                &linkage["branch"][drive]
            ),
            (&json!(true), &json!(true), &json!(true)),
            "{linkage}"
        );
        assert_eq!(linkage["fulfils"], json!(true), "{linkage}");
    }
}

/// An antiparallelogram, rational in every position: decided exactly, and at the first precision.
#[test]
fn a_change_point_is_told_exactly() {
    let base = [Rational::from(5), Rational::new()];
    let poses: Vec<Pose> = [(1, 3), (1, 2), (2, 3), (1, 1), (3, 2)]
        .iter()
        .map(|(n, m)| {
            let [cos, sin] = turn(&Rational::from((*n, *m)));
            let [x, y] = [cos * 3, sin * 3];
            // B is the mirror image of A + N in the line AN: the direction of AB that of AN, squared.
            let to_n = [Rational::from(&base[0] - &x), Rational::from(-&y)];
            let t = Rational::from(&to_n[1] / &to_n[0]);
            [x, y, t]
        })
        .collect();
    let answer = solved(&problem(&poses, json!({"in_order": true})));
    let zero = Rational::new();
    let first = place(&answer["pairs"], "circlepoint", [&zero, &zero]);
    let second = place(&answer["pairs"], "circlepoint", [&base[0], &zero]);
    let (_, linkage, drive) = linkage(&answer, &json!(first), &json!(second));
    assert_eq!(linkage["type"], json!("change-point"), "{linkage}");
    assert_eq!(linkage["order"][drive], json!([1, 2, 3, 4, 5]), "{linkage}");
    assert_eq!(linkage["defects"].as_array().unwrap().len(), 1, "{linkage}");
    assert_eq!(linkage["fulfils"], json!(true), "{linkage}");
    assert_eq!(answer["certificate"]["bits"], json!(184));
}

#[test]
fn wishes_are_read_and_judged() {
    let mut random = seed::generator("wishes_are_read_and_judged");
    let ([r, l, _], poses) = slider_crank(&mut random);
    let zero = Rational::new();
    let judged = |wishes: Value| {
        let answer = solved(&problem(&poses, wishes));
        let crank = place(&answer["pairs"], "circlepoint", [&l.into(), &zero]);
        let (_, linkage, _) = linkage(&answer, &json!(crank), &json!({"at_infinity": 0}));
        (linkage["fulfils"].clone(), linkage["misses"].clone())
    };
    let yes = (json!(true), json!([]));
    // The pivot is near the origin: inside of what holds that with room.
    assert_eq!(
        judged(json!({"pivots_within": {"box": [["-1", "-1"], ["1", "1"]]}})),
        yes
    );
    assert_eq!(
        judged(json!({"pivots_within": {"polygon": [["-1", "-1"], ["1", "-1"], ["0", "2"]]}})),
        yes
    );
    assert_eq!(judged(json!({})), yes);
    let (fulfils, misses) = judged(
        json!({"pivots_within": {"box": [["1", "1"], [2, 2]]}, "least_transmission_angle": {"degrees": "89.9"}}),
    );
    assert_eq!(fulfils, json!(false), "{r}");
    assert!(
        misses.to_string().contains("lies outside") && misses.to_string().contains("too small"),
        "{misses}"
    );
    let refused = |wishes: Value, place: &str| {
        let error = oracle::solve(&problem(&poses, wishes), &Request::default()).unwrap_err();
        assert_eq!(error.place, place, "{error}");
    };
    refused(json!({"crank": true}), "wishes.crank");
    refused(json!({"id": "a"}), "wishes.id");
    refused(json!({"crank_driven": 1}), "wishes.crank_driven");
    refused(json!([]), "wishes");
    refused(json!({"pivots_within": {}}), "wishes.pivots_within.box");
    refused(
        json!({"pivots_within": {"box": [["1", "1"]]}}),
        "wishes.pivots_within.box",
    );
    refused(
        json!({"pivots_within": {"circle": {"center": ["1"], "radius": "1"}}}),
        "wishes.pivots_within.circle.center",
    );
    refused(
        json!({"pivots_within": {"circle": {"center": ["1", "2"], "radius": "-1"}}}),
        "wishes.pivots_within.circle.radius",
    );
    refused(
        json!({"pivots_within": {"polygon": [["0", "0"], ["1", "1"], ["1", "0"], ["0", "1"]]}}),
        "wishes.pivots_within.polygon",
    );
    refused(
        json!({"least_transmission_angle": {"degrees": "91"}}),
        "wishes.least_transmission_angle",
    );
}
