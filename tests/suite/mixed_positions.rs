//! Five positions of which some have come together.
#![allow(
    clippy::unwrap_used,
    clippy::as_conversions,
    clippy::indexing_slicing,
    clippy::panic,
    missing_docs,
    reason = "a test that cannot compute what it tests has failed"
)]

use crate::support::positions::{points, turns};
use crate::support::seed::rounds;
use burmester::curvature::closure;
use burmester::curvature::contact::Guide;
use burmester::curvature::mixed::{Groups, pairs};
use burmester::curvature::motion::Motion;
use burmester::finite::five_positions::conditions::{of_pair, rows};
use burmester::finite::five_positions::conics::Pairs;
use burmester::number::{Exact, Number, Series};
use burmester::oracle::certificate::{Defect, check_answer};
use burmester::oracle::{Request, solve};
use burmester::plane::Point;
use burmester::plane::displacement::Displacement;
use proptest::prelude::*;
use serde_json::{Value, json};

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

fn place([x, y]: [&str; 2], angle: &Value, derivatives: &[[&str; 3]]) -> Value {
    let derivatives = derivatives
        .iter()
        .map(|[x, y, angle]| json!({"x": x, "y": y, "angle": angle}));
    let derivatives: Vec<Value> = derivatives.collect();
    json!({"x": x, "y": y, "angle": angle, "derivatives": derivatives})
}

fn tan_half(t: &str) -> Value {
    json!({"tan_half": t})
}

/// Answered, and found right by the checker.
fn family_of(positions: &Value) -> Value {
    let problem = json!({"problem": "mixed-positions", "positions": positions});
    let answer = answered(positions);
    assert!(answer.get("undecided").is_none(), "{answer}");
    let verdict = check_answer(&problem, &answer);
    let is_beside = !answer["pairs"].as_array().unwrap().is_empty()
        || !answer["at_infinity"].as_array().unwrap().is_empty();
    match verdict {
        Ok(()) => {}
        Err(Defect::Unchecked { .. }) if is_beside => {}
        Err(defect) => panic!("{defect}: {answer}"),
    }
    answer["family"].clone()
}

#[test]
fn a_turn_and_a_translation_on_a_circle_keep_every_point() {
    let plane = json!({"kind": "plane"});
    let start = tan_half("0");
    // A turn about one point; a translation as of a parallelogram.
    let turn = [
        ["0", "0", "1"],
        ["0", "0", "0"],
        ["0", "0", "0"],
        ["0", "0", "0"],
    ];
    let circle = [
        ["0", "1", "0"],
        ["-1", "0", "0"],
        ["0", "-1", "0"],
        ["1", "0", "0"],
    ];
    for derivatives in [turn, circle] {
        let positions = json!([place(["0", "0"], &start, &derivatives)]);
        assert_eq!(family_of(&positions), plane);
    }
    let apart = json!([
        place(["5", "0"], &start, &[["0", "1", "0"], ["-1/5", "0", "0"]]),
        place(["3", "4"], &start, &[["4", "-3", "0"]]),
    ]);
    assert_eq!(family_of(&apart), plane);
}

#[test]
fn translations_off_every_circle_have_lines_or_nothing() {
    let line = [
        ["1", "2", "0"],
        ["-3", "-6", "0"],
        ["0", "0", "0"],
        ["1/2", "1", "0"],
    ];
    let positions = json!([place(["1", "1"], &tan_half("1/2"), &line)]);
    assert_eq!(
        family_of(&positions),
        json!({"kind": "plane", "center": {"at_infinity": [{"exact": "2"}, {"exact": "-1"}]}})
    );
    let parabola = [
        ["1", "0", "0"],
        ["0", "2", "0"],
        ["0", "0", "0"],
        ["0", "0", "0"],
    ];
    let positions = json!([place(["1", "1"], &tan_half("1/2"), &parabola)]);
    assert!(family_of(&positions).is_null());
}

/// Two equal positions, which have come together without any motion: the circlepoint curve of the four
/// that are left.
#[test]
fn a_position_at_rest_counts_once() {
    let four = [
        ("0", "0", "0"),
        ("2", "1", "1/2"),
        ("-1", "4", "2/3"),
        ("3", "-2", "-1/4"),
    ];
    let plain = four.map(|(x, y, t)| json!({"x": x, "y": y, "angle": tan_half(t)}));
    let curve = json!({"problem": "centerpoint-curve", "positions": plain});
    let curve = solve(&curve, &Request::default()).unwrap();
    let mut positions = plain.to_vec();
    positions[1]["derivatives"] = json!([{"x": 0, "y": 0, "angle": 0}]);
    let family = family_of(&json!(positions));
    assert_eq!(family["kind"], "circlepoint-cubic");
    assert_eq!(family["coefficients"], curve["circlepoint"]["coefficients"]);
}

/// The moving origin is in one place in the first three positions, and in another in the last two.
#[test]
fn a_point_at_rest_has_any_center() {
    let positions = json!([
        place(
            ["0", "0"],
            &tan_half("0"),
            &[["0", "0", "1"], ["0", "0", "2"]]
        ),
        place(["3", "1"], &tan_half("1/3"), &[["0", "0", "1"]]),
    ]);
    assert_eq!(
        family_of(&positions),
        json!({
            "kind": "point-with-any-center", "circlepoint": [{"exact": "0"}, {"exact": "0"}],
            "centers": ["3", "1", "-5"],
        })
    );
    // The inverse motion: the points of a line have the origin for their center.
    let inverse = json!([
        place(
            ["0", "0"],
            &tan_half("0"),
            &[["0", "0", "-1"], ["0", "0", "-2"]]
        ),
        // −e^{−iφ}(3 + i) for the angle −φ − t, tan φ/2 = 1/3.
        place(["-3", "1"], &tan_half("-1/3"), &[["1", "3", "-1"]]),
    ]);
    assert_eq!(
        family_of(&inverse),
        json!({
            "kind": "line", "coefficients": ["3", "1", "-5"],
            "center": [{"exact": "0"}, {"exact": "0"}],
        })
    );
}

/// No velocity, but an acceleration: (x − y − 3)(2x² + 6x + 2y² + 2y + 5) = 0.
#[test]
fn a_family_may_fall_apart() {
    let rests = [["0", "0", "0"], ["-1", "2", "-1"], ["-2", "-2", "0"]];
    let positions = json!([
        place(["2", "1"], &tan_half("1"), &rests),
        place(["2", "-2"], &tan_half("-2"), &[]),
    ]);
    let coefficients = ["2", "-2", "2", "-2", "0", "-4", "-8", "-13", "-11", "-15"];
    assert_eq!(
        family_of(&positions),
        json!({"kind": "circlepoint-cubic", "coefficients": coefficients})
    );
}

/// Two points on two lines: every point of the circle about them and the meet of the lines goes straight.
#[test]
fn a_trammel_has_a_circle() {
    let slide = |at: [i64; 2], normal: [i64; 2]| json!({"circlepoint": at, "center": {"at_infinity": normal}});
    let links = [slide([4, 0], [0, 1]), slide([0, 2], [1, 0])];
    let problem = json!({"problem": "curvature", "links": links});
    let answer = solve(&problem, &Request::default()).unwrap();
    let coefficients = ["1", "0", "1", "-4", "-2", "0"];
    assert_eq!(
        answer["family"],
        json!({"kind": "circle", "coefficients": coefficients}),
        "{answer}"
    );
    let verdict = check_answer(&problem, &answer);
    assert!(!matches!(verdict, Err(Defect::Wrong { .. })), "{verdict:?}");
    assert_eq!(answer["ball_point"], json!({"undetermined": true}));
}

#[test]
fn a_parallelogram_has_the_plane() {
    let crank = |x: i64| json!({"circlepoint": [x, 2], "center": [x - 1, 0]});
    let problem = json!({"problem": "curvature", "links": [crank(1), crank(6)]});
    let answer = solve(&problem, &Request::default()).unwrap();
    assert_eq!(answer["family"], json!({"kind": "plane"}), "{answer}");
    assert_eq!(check_answer(&problem, &answer), Ok(()));
}
