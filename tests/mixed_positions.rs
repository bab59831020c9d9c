//! Five positions of which some have come together.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "a test that cannot compute what it tests has failed"
)]

#[path = "support/seed.rs"]
mod seed;
#[path = "support/positions.rs"]
mod support;

use burmester::curvature::closure;
use burmester::curvature::contact::Guide;
use burmester::curvature::mixed::{Groups, pairs};
use burmester::curvature::motion::Motion;
use burmester::finite::five_positions::conditions::{of_pair, rows};
use burmester::finite::five_positions::conics::Pairs;
use burmester::number::{Exact, Number, Series};
use burmester::oracle::{Request, solve};
use burmester::plane::Point;
use burmester::plane::displacement::Displacement;
use proptest::prelude::*;
use seed::rounds;
use serde_json::{Value, json};
use support::{points, turns};

/// How many positions come together in each group.
const PATTERNS: [&[usize]; 7] = [
    &[1, 1, 1, 1, 1],
    &[2, 1, 1, 1],
    &[2, 2, 1],
    &[3, 1, 1],
    &[3, 2],
    &[4, 1],
    &[5],
];

fn constant(z: &Point<Exact>) -> Point<Series<Exact>> {
    Number::complex(z.re().clone().into(), z.im().clone().into())
}

/// The motion about a position that moves as another one about its place.
fn after(position: &Displacement<Exact>, local: &Motion<Exact>) -> Motion<Exact> {
    Displacement {
        rotation: &local.rotation * constant(&position.rotation),
        translation: local.of(&constant(&position.translation)),
    }
}

/// Groups in which a point z stays on a circle about m: about each place of it the motion of a linkage
/// with that link and any other one.
fn with_link(
    pattern: &[usize],
    z: &Point<Exact>,
    m: &Point<Exact>,
    turns: &[[Point<Exact>; 2]],
    others: &[[Point<Exact>; 2]],
) -> Option<Groups<Exact>> {
    let groups = pattern
        .iter()
        .zip(turns)
        .zip(others)
        .map(|((size, [r, e]), [point, center])| {
            let place = m + e.scaled(&5.into());
            let position = Displacement {
                translation: &place - r * z,
                rotation: r.clone(),
            };
            let guides = [
                Guide::Circle {
                    point: place,
                    center: m.clone(),
                },
                Guide::Circle {
                    point: point.clone(),
                    center: center.clone(),
                },
            ];
            let local = closure::motion(&guides, size - 1)?;
            Some(after(&position, &local))
        });
    groups.collect::<Option<_>>().map(Groups)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(rounds(40) as u32))]

    #[test]
    fn a_link_of_the_motion_is_among_the_pairs(
        pattern in 0..PATTERNS.len(),
        z in points(),
        m in points(),
        spins in proptest::array::uniform5([turns(), turns()]),
        others in proptest::array::uniform5([points(), points()]),
    ) {
        let Some(groups) = with_link(PATTERNS[pattern], &z, &m, &spins, &others) else {
            return Ok(());
        };
        let known = of_pair(&z, &m);
        for row in groups.conditions() {
            let value: Number<Exact> = row.iter().zip(&known).map(|(a, b)| a * b).sum();
            prop_assert!(value.is_zero().is_yes(), "{:?}", PATTERNS[pattern]);
        }
        if let Some(Pairs::Isolated(isolated)) = pairs(&groups) {
            prop_assert!(isolated.place_of(&known).is_some(), "{:?}", PATTERNS[pattern]);
        }
    }

    #[test]
    fn positions_that_are_apart_have_the_conditions_of_five_positions(
        shifts in proptest::array::uniform5(points()),
        spins in proptest::array::uniform5(turns()),
    ) {
        let five: [Displacement<Exact>; 5] = std::array::from_fn(|j| Displacement {
            rotation: spins[j].clone(),
            translation: shifts[j].clone(),
        });
        let groups = Groups(five.iter().map(|d| d.map(|x| x.clone().into())).collect());
        for (a, b) in groups.conditions().iter().zip(rows(&five)) {
            for (a, b) in a.iter().zip(&b) {
                prop_assert!(a.equals(b).is_yes());
            }
        }
    }
}

fn answered(positions: &Value) -> Value {
    let problem = json!({"problem": "mixed-positions", "positions": positions});
    solve(&problem, &Request::default()).unwrap()
}

/// Some motion with so many positions about each of several places.
fn groups(pattern: &[usize]) -> Value {
    let places = pattern.iter().enumerate().map(|(j, size)| {
        let j = j as i64;
        let derivatives = (1..*size as i64).map(|order| {
            json!({"x": 2 - j * order, "y": order * order - 3 * j, "angle": 1 + (j + order) % 3})
        });
        json!({
            "x": 3 * j, "y": j * (4 - j), "angle": {"tan_half": format!("{j}/5")},
            "derivatives": derivatives.collect::<Vec<_>>(),
        })
    });
    places.collect()
}

#[test]
fn every_pattern_has_four_pairs_with_proof() {
    for pattern in PATTERNS {
        let answer = answered(&groups(pattern));
        let counts =
            ["real", "complex", "at_infinity"].map(|name| answer["counts"][name].as_u64().unwrap());
        assert_eq!(counts.iter().sum::<u64>(), 4, "{pattern:?}: {answer}");
        let proven = answer["certificate"]["krawczyk"].as_array().unwrap();
        assert_eq!(proven.len(), answer["pairs"].as_array().unwrap().len());
        assert!(
            proven.iter().all(|one| one == true),
            "{pattern:?}: {answer}"
        );
        assert!(answer.get("undecided").is_none(), "{pattern:?}: {answer}");
    }
}

#[test]
fn enclosed_angles_give_the_same_pairs() {
    // A right angle in radians, rounded to forty digits, beside the exact one.
    let near = "1.570796326794896619231321691639751442099";
    for pattern in PATTERNS {
        let mut exact = groups(pattern);
        exact[0]["angle"] = json!({"degrees": "90"});
        let mut rounded = exact.clone();
        rounded[0]["angle"] = json!({"radians": near});
        let [a, b] = [exact, rounded].map(|positions| answered(&positions));
        assert_eq!(a["counts"], b["counts"], "{pattern:?}");
        let first = |answer: &Value| {
            let coordinate = &answer["pairs"][0]["circlepoint"][0];
            let text = coordinate.get("value").or_else(|| coordinate.get("exact"));
            text.map(|text| text.as_str().unwrap().chars().take(20).collect::<String>())
        };
        assert_eq!(first(&a), first(&b), "{pattern:?}");
    }
}

#[test]
fn wrong_problems_are_refused_with_their_place() {
    let place = json!({"x": 0, "y": 0, "angle": {"degrees": 0}});
    let mut with_unknown = place.clone();
    with_unknown["velocity"] = json!(1);
    let mut with_missing = place.clone();
    with_missing["derivatives"] = json!([{"x": 1, "y": 1}]);
    for (positions, expected) in [
        (
            json!([place, place]),
            "positions: five positions were expected",
        ),
        (
            json!([with_unknown]),
            "positions[0].velocity: unknown field",
        ),
        (
            json!([place, with_missing]),
            "positions[1].derivatives[0].angle: this field is missing",
        ),
        (json!(3), "positions: a list was expected"),
    ] {
        let problem = json!({"problem": "mixed-positions", "positions": positions});
        let error = solve(&problem, &Request::default())
            .unwrap_err()
            .to_string();
        assert!(error.contains(expected), "{error}, not {expected}");
    }
}

#[test]
fn infinitely_many_pairs_are_not_called_none() {
    // A turn about one point, in all five positions.
    let answer = answered(&json!([{
        "x": 0, "y": 0, "angle": {"degrees": 0},
        "derivatives": [
            {"x": 0, "y": 0, "angle": 1}, {"x": 0, "y": 0, "angle": 0},
            {"x": 0, "y": 0, "angle": 0}, {"x": 0, "y": 0, "angle": 0},
        ],
    }]));
    assert!(
        answer["pairs"].is_null() && answer["undecided"].is_string(),
        "{answer}"
    );
}
