//! The checker of answers accepts what is true and rejects what is damaged.
#![expect(
    clippy::unwrap_used,
    clippy::as_conversions,
    clippy::indexing_slicing,
    reason = "a test that cannot read what it tests has failed"
)]

use crate::support::damage;
use crate::support::seed;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use burmester::oracle::certificate::{Defect, check_answer};
use burmester::oracle::vectors::{CORPORA, Corpus, Entry, Folder};
use burmester::oracle::{Request, solve};
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

use crate::support::damage::{WAYS, change_digit, change_sign};

fn entries(corpus: &Corpus) -> Vec<Entry> {
    Folder::at(Path::new("data")).entries(corpus.name).unwrap()
}

/// Every so manyth answer; all where BURMESTER_LONG is 1.
fn step() -> usize {
    if seed::rounds(1) > 1 { 1 } else { 20 }
}

#[test]
fn true_answers_are_accepted() {
    let mut accepted: BTreeMap<&str, usize> = BTreeMap::new();
    let mut unchecked: BTreeMap<(&str, String), usize> = BTreeMap::new();
    let mut wrong = Vec::new();
    for corpus in &CORPORA {
        for Entry { problem, answer } in entries(corpus).iter().step_by(step()) {
            match check_answer(problem, &answer["answer"]) {
                Ok(()) => *accepted.entry(corpus.name).or_default() += 1,
                Err(Defect::Unchecked { reason }) => {
                    *unchecked.entry((corpus.name, reason)).or_default() += 1;
                }
                Err(defect) => wrong.push(format!("{}: {defect}", problem["id"])),
            }
        }
    }
    eprintln!("accepted {accepted:?}, not checked {unchecked:#?}");
    assert!(wrong.is_empty(), "{}", wrong.join("; "));
    for name in [
        "random-five-positions",
        "five-positions-of-linkages",
        "near-degenerate-five-positions",
        "sliders",
        "random-four-positions",
        "random-poles",
        "random-three-positions",
        "hart",
        "focal-mechanisms",
        "slider-cranks",
        "degenerate-three-positions",
        "degenerate-four-positions",
        "near-degenerate-four-positions",
        "by-two-points",
        "in-degrees",
        "mixed-positions",
        "curvature",
    ] {
        let count = accepted.get(name).copied().unwrap_or_default();
        assert!(count > 0, "{name}: {accepted:?}");
        // Of long corpora most.
        let all = entries(Corpus::named(name).unwrap()).len().div_ceil(step());
        assert!(3 * count >= 2 * all, "{name}: {count} of {all} accepted");
    }
}

#[test]
fn true_answers_of_other_digits_are_accepted() {
    let mut wrong = Vec::new();
    for corpus in &CORPORA {
        for Entry { problem, .. } in entries(corpus).iter().step_by(4 * step()) {
            for digits in [7, 90] {
                let request = Request {
                    digits,
                    ..Request::default()
                };
                let answer = solve(problem, &request).unwrap();
                if let Err(defect @ Defect::Wrong { .. }) = check_answer(problem, &answer) {
                    wrong.push(format!("{} {digits}: {defect}", problem["id"]));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("; "));
}

/// A number of a pair, by a random choice.
fn number_of_pair<'a>(answer: &'a mut Value, random: &mut ChaCha8Rng) -> Option<&'a mut Value> {
    let list = if answer["pairs"].as_array()?.is_empty() {
        "complex_pairs"
    } else {
        "pairs"
    };
    let count = answer[list].as_array()?.len();
    if count == 0 {
        return None;
    }
    let pair = &mut answer[list][random.random_range(0..count)];
    let point = &mut pair[if random.random() {
        "circlepoint"
    } else {
        "center"
    }];
    let number = &mut point[random.random_range(0..2)];
    if number.get("re").is_some() {
        return number.get_mut(if random.random() { "re" } else { "im" });
    }
    Some(number)
}

/// Damages an answer to five positions in one way; `None` where it has nothing of that kind.
fn damaged_pairs(answer: &Value, way: u32, random: &mut ChaCha8Rng) -> Option<Value> {
    let mut answer = answer.clone();
    let real = answer["pairs"].as_array()?.len();
    let changed = match way {
        0 => change_digit(number_of_pair(&mut answer, random)?, random),
        1 => change_sign(number_of_pair(&mut answer, random)?),
        2 if real > 0 => {
            // A missing pair, with counts that fit.
            let place = random.random_range(0..real);
            let pair = answer["pairs"].as_array_mut()?.remove(place);
            let count = answer["counts"]["real"].as_u64()? - pair["multiplicity"].as_u64()?;
            answer["counts"]["real"] = json!(count);
            answer["certificate"]["krawczyk"]
                .as_array_mut()?
                .remove(place);
            true
        }
        3 if real > 0 => {
            // An invented pair, with counts that fit.
            let mut pair = answer["pairs"][real - 1].clone();
            for name in ["circlepoint", "center"] {
                pair[name] =
                    json!([{"exact": "1001"}, {"exact": random.random_range(1..99).to_string()}]);
            }
            pair["multiplicity"] = json!(1);
            answer["pairs"].as_array_mut()?.push(pair);
            answer["counts"]["real"] = json!(answer["counts"]["real"].as_u64()? + 1);
            answer["certificate"]["krawczyk"]
                .as_array_mut()?
                .push(json!(true));
            true
        }
        4 => {
            let name = ["real", "complex", "at_infinity"][random.random_range(0..3)];
            answer["counts"][name] = json!(answer["counts"][name].as_u64()? + 1);
            true
        }
        5 if real > 1 => {
            let center = answer["pairs"][0]["center"].take();
            answer["pairs"][0]["center"] = answer["pairs"][1]["center"].take();
            answer["pairs"][1]["center"] = center;
            true
        }
        6 if real > 1 => {
            answer["pairs"].as_array_mut()?.swap(0, 1);
            true
        }
        7 => {
            // A digit of the eliminant.
            let list = answer["eliminant"].as_array_mut()?;
            let place = random.random_range(0..list.len());
            let text = list[place].as_str()?.to_owned();
            list[place] = json!(format!("{text}1"));
            list.len() > 1
        }
        8 if real > 0 => {
            // A pair in place of one with another.
            answer["pairs"][0]["multiplicity"] = json!(2);
            answer["counts"]["real"] = json!(answer["counts"]["real"].as_u64()? + 1);
            true
        }
        9 => {
            // More digits than there are.
            let number = number_of_pair(&mut answer, random)?;
            let has_radius = number.get("radius").is_some();
            number["radius"] = json!("1e-300");
            has_radius
        }
        10 if real > 0 => {
            let pair = &mut answer["pairs"][random.random_range(0..real)];
            let center = pair["center"].take();
            pair["center"] = pair["circlepoint"].take();
            pair["circlepoint"] = center;
            true
        }
        _ => false,
    };
    changed.then_some(answer)
}

/// How many ways there are.
const WAYS_OF_PAIRS: u32 = 11;

#[test]
fn damaged_answers_are_rejected() {
    assert_damaged_pairs_are_rejected(
        &[
            "random-five-positions",
            "five-positions-of-linkages",
            "near-degenerate-five-positions",
            "degenerate-five-positions",
            "sliders",
        ],
        500,
    );
}

#[test]
fn damaged_pairs_of_positions_that_came_together_are_rejected() {
    assert_damaged_pairs_are_rejected(&["mixed-positions"], 200);
    assert_damaged_pairs_are_rejected(&["curvature"], 200);
}

fn assert_damaged_pairs_are_rejected(names: &[&str], least: usize) {
    let mut random = seed::generator(names[0]);
    let all: Vec<Entry> = names
        .iter()
        .flat_map(|name| entries(Corpus::named(name).unwrap()))
        .filter(|entry| {
            let answer = &entry.answer["answer"];
            answer["undecided"]
                .as_str()
                .is_none_or(|text| text.starts_with("linkages"))
                && answer["family"].is_null()
        })
        .collect();
    let mut tried: BTreeMap<u32, usize> = BTreeMap::new();
    while tried.values().sum::<usize>() < least {
        let Entry { problem, answer } = &all[random.random_range(0..all.len())];
        let way = random.random_range(0..WAYS_OF_PAIRS);
        let Some(damaged) = damaged_pairs(&answer["answer"], way, &mut random) else {
            continue;
        };
        if damaged == answer["answer"] {
            continue;
        }
        let verdict = check_answer(problem, &damaged);
        assert!(
            matches!(verdict, Err(Defect::Wrong { .. })),
            "{}, way {way}: {verdict:?}",
            problem["id"]
        );
        *tried.entry(way).or_default() += 1;
    }
    assert_eq!(tried.len(), WAYS_OF_PAIRS as usize, "{tried:?}");
}

/// Answers of these corpora that are proven, damaged in every way, must all be found wrong.
fn assert_damages_are_rejected(names: &[&str], least: usize) {
    let all: Vec<Entry> = names
        .iter()
        .flat_map(|name| entries(Corpus::named(name).unwrap()))
        .collect();
    let all = all
        .into_iter()
        .map(|Entry { problem, answer }| (problem, answer["answer"].clone()));
    let proven = assert_all_damages_are_rejected(names, &all.collect::<Vec<_>>(), least);
    assert!(proven >= 20, "{names:?}: only {proven} proven");
}

/// The same of problems with their answers; how many of those that were tried are proven.
fn assert_all_damages_are_rejected(names: &[&str], all: &[(Value, Value)], least: usize) -> usize {
    let mut random = seed::generator(names[0]);
    let words: BTreeSet<(String, String)> = all
        .iter()
        .flat_map(|(_, answer)| damage::words(answer))
        .collect();
    let mut proven: BTreeMap<usize, bool> = BTreeMap::new();
    let mut tried: BTreeMap<damage::Way, usize> = BTreeMap::new();
    let mut accepted = Vec::new();
    while tried.values().sum::<usize>() < least {
        let place = random.random_range(0..all.len());
        let (problem, answer) = &all[place];
        if !*proven
            .entry(place)
            .or_insert_with(|| check_answer(problem, answer).is_ok())
        {
            continue;
        }
        let way = WAYS[random.random_range(0..WAYS.len())];
        let Some(damaged) = damage::damage(answer, way, &words, &mut random) else {
            continue;
        };
        *tried.entry(way).or_default() += 1;
        let verdict = check_answer(problem, &damaged);
        if !matches!(verdict, Err(Defect::Wrong { .. })) {
            accepted.push(format!("{problem} {way:?}: {verdict:?} {damaged}"));
        }
    }
    eprintln!("{names:?}: {tried:?}");
    assert!(
        accepted.is_empty(),
        "{}:\n{}",
        accepted.len(),
        accepted.join("\n")
    );
    proven.values().filter(|proven| **proven).count()
}

/// Positions that came together in ways that the corpora leave out.
fn rare_positions() -> Vec<Value> {
    let invariants = |third: [&str; 2], fourth: [&str; 2]| {
        json!({
            "problem": "curvature", "invariants": {"third": third, "fourth": fourth},
            "points": [[0, 0], [0, 1], [3, "1/2"]],
        })
    };
    let crank = json!({"circlepoint": [1, 2], "center": [0, 0]});
    let linkage = |other: Value| {
        json!({
            "problem": "curvature", "links": [crank, other],
            "points": [[1, 2], [4, 0], [2, 5], ["-1/3", 7]],
        })
    };
    let turning = |angle: Value| {
        json!({
            "x": 1, "y": "2/3", "angle": angle,
            "derivatives": [{"x": 2, "y": -1, "angle": 1}, {"x": 0, "y": 3, "angle": "1/2"}],
        })
    };
    let shifted = json!({"x": -2, "y": 5, "angle": {"tan_half": "2/3"}});
    let third = json!({"x": 4, "y": 1, "angle": {"tan_half": "-1/5"}});
    let mixed =
        |first: Value| json!({"problem": "mixed-positions", "positions": [first, shifted, third]});
    vec![
        // Four simple pairs; two equal ones; one in the pole; Ball's point one of them, two, or three.
        invariants(["2", "5"], ["-3", "7"]),
        invariants(["1", "0"], ["5", "-61/12"]),
        invariants(["0", "0"], ["6", "2"]),
        invariants(["2", "5"], ["16/5", "7"]),
        invariants(["-3/4", "0"], ["9", "-1"]),
        invariants(["-1", "1"], ["-8/3", "5/3"]),
        linkage(json!({"circlepoint": [4, 0], "center": [5, -3]})),
        linkage(json!({"circlepoint": [4, 0], "center": {"at_infinity": [0, 1]}})),
        linkage(json!({"circlepoint": {"at_infinity": [1, 3]}, "center": [5, -3]})),
        linkage(json!({"circlepoint": [4, 3], "center": [6, 7]})),
        mixed(turning(json!({"tan_half": "1/3"}))),
        mixed(turning(json!({"degrees": "30"}))),
        mixed(turning(json!({"radians": "1.5"}))),
    ]
}

#[test]
fn damaged_answers_to_rare_positions_are_rejected() {
    let request = Request {
        digits: 20,
        ..Request::default()
    };
    let all = rare_positions().into_iter().map(|problem| {
        let answer = solve(&problem, &request).unwrap();
        let verdict = check_answer(&problem, &answer);
        assert!(verdict.is_ok(), "{problem}: {verdict:?} {answer}");
        (problem, answer)
    });
    let all: Vec<(Value, Value)> = all.collect();
    assert_all_damages_are_rejected(&["rare positions"], &all, 600);
}

/// A motion of small integers, so that much of it degenerates, in one position or in several.
fn small_motion(random: &mut ChaCha8Rng) -> Value {
    fn small(random: &mut ChaCha8Rng) -> i64 {
        random.random_range(-2..3)
    }
    let pair = |random: &mut ChaCha8Rng| json!([small(random), small(random)]);
    let links = |random: &mut ChaCha8Rng| {
        let link = |random: &mut ChaCha8Rng| {
            let (point, center) = (pair(random), pair(random));
            match random.random_range(0..4) {
                0 => json!({"circlepoint": point, "center": {"at_infinity": center}}),
                1 => json!({"circlepoint": {"at_infinity": point}, "center": center}),
                _ => json!({"circlepoint": point, "center": center}),
            }
        };
        json!([link(random), link(random)])
    };
    match random.random_range(0..4) {
        0 => json!({
            "problem": "curvature", "points": [pair(random), pair(random)],
            "invariants": {"third": pair(random), "fourth": pair(random)},
        }),
        1 => json!({"problem": "curvature", "links": links(random), "points": [pair(random)]}),
        _ => {
            let sizes: &[usize] = [
                &[2, 1, 1, 1][..],
                &[2, 2, 1],
                &[3, 1, 1],
                &[3, 2],
                &[4, 1],
                &[5],
            ][random.random_range(0..6)];
            let position = |random: &mut ChaCha8Rng, size: usize| {
                let derivatives: Vec<Value> = (1..size)
                    .map(|_| {
                        let [x, y, angle] = [small(random), small(random), small(random)];
                        json!({"x": x, "y": y, "angle": angle / 2})
                    })
                    .collect();
                json!({
                    "x": small(random), "y": small(random),
                    "angle": {"tan_half": small(random)}, "derivatives": derivatives,
                })
            };
            let positions: Vec<Value> = sizes.iter().map(|size| position(random, *size)).collect();
            json!({"problem": "mixed-positions", "positions": positions})
        }
    }
}

#[test]
fn answers_to_small_motions_are_not_found_wrong() {
    let mut random = seed::generator("small motions");
    let request = Request {
        digits: 15,
        ..Request::default()
    };
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for _ in 0..seed::rounds(50) {
        let problem = small_motion(&mut random);
        let Ok(answer) = solve(&problem, &request) else {
            continue;
        };
        let verdict = match check_answer(&problem, &answer) {
            Ok(()) => "right".to_owned(),
            Err(Defect::Unchecked { reason }) => reason,
            Err(defect) => panic!("{problem}: {defect} {answer}"),
        };
        *counts.entry(verdict).or_default() += 1;
        let family = &answer["family"]["kind"];
        if !family.is_null() {
            *counts.entry(family.to_string()).or_default() += 1;
        }
    }
    eprintln!("{counts:#?}");
    assert!(counts["right"] > 15, "{counts:?}");
}

/// k, α_a, α_d of slider-cranks, and what of them is 0/0.
#[test]
fn zero_by_zero_is_undetermined() {
    let all = ["PB", "PC", "PO_b", "PO_c", "alpha_b", "alpha_c"];
    let cases: [(i64, i64, i64, &[&str]); 5] = [
        (0, 90, 135, &["N", "M", "R"]),
        (0, 45, 90, &["N"]),
        (-3, 0, 45, &all),
        (-2, 90, 90, &["N", "M", "R"]),
        (-2, 105, 105, &[]),
    ];
    for (k, alpha_a, alpha_d, undetermined) in cases {
        let problem = json!({
            "problem": "slider-crank-alternates", "k": k,
            "alpha_a": {"degrees": alpha_a}, "alpha_d": {"degrees": alpha_d},
        });
        let answer = solve(&problem, &Request::default()).unwrap();
        assert!(answer.get("undecided").is_none(), "{answer}");
        let fields = answer.as_object().unwrap();
        let found = fields
            .iter()
            .filter(|(_, value)| value["undetermined"] == true)
            .map(|(name, _)| name.as_str());
        let expected: BTreeSet<&str> = undetermined.iter().copied().collect();
        assert_eq!(found.collect::<BTreeSet<_>>(), expected, "{answer}");
        assert!(!matches!(
            check_answer(&problem, &answer),
            Err(Defect::Wrong { .. })
        ));
        for name in fields
            .keys()
            .filter(|name| !["problem", "digits"].contains(&name.as_str()))
        {
            let mut damaged = answer.clone();
            damaged[name] = if expected.contains(name.as_str()) {
                json!({"infinite": true})
            } else {
                json!({"undetermined": true})
            };
            let verdict = check_answer(&problem, &damaged);
            let is_of_alternates = all.contains(&name.as_str());
            // Of pins on one ray B and C are not checked.
            let is_open = is_of_alternates && alpha_a == alpha_d;
            assert!(
                is_open || matches!(verdict, Err(Defect::Wrong { .. })),
                "{name}: {verdict:?} {damaged}"
            );
        }
    }
}

#[test]
fn damaged_mechanisms_of_hart_are_rejected() {
    assert_damages_are_rejected(&["hart"], 300);
}

#[test]
fn damaged_focal_mechanisms_are_rejected() {
    assert_damages_are_rejected(&["focal-mechanisms"], 300);
}

#[test]
fn damaged_alternates_of_slider_cranks_are_rejected() {
    assert_damages_are_rejected(&["slider-cranks"], 300);
}

#[test]
fn damaged_mixed_positions_are_rejected() {
    assert_damages_are_rejected(&["mixed-positions"], 500);
}

#[test]
fn damaged_answers_to_one_position_are_rejected() {
    assert_damages_are_rejected(&["curvature"], 1000);
}

#[test]
fn damaged_poles_are_rejected() {
    assert_damages_are_rejected(&["random-poles"], 300);
}

#[test]
fn damaged_answers_to_three_positions_are_rejected() {
    assert_damages_are_rejected(
        &["random-three-positions", "degenerate-three-positions"],
        500,
    );
}

#[test]
fn damaged_answers_in_degrees_and_by_two_points_are_rejected() {
    assert_damages_are_rejected(&["in-degrees", "by-two-points"], 500);
}

#[test]
fn damaged_answers_to_five_positions_are_rejected() {
    let names = [
        "five-positions-of-linkages",
        "sliders",
        "random-five-positions",
    ];
    assert_damages_are_rejected(&names, 500);
}

#[test]
fn damaged_answers_to_four_positions_are_rejected() {
    let names = [
        "random-four-positions",
        "near-degenerate-four-positions",
        "degenerate-four-positions",
    ];
    assert_damages_are_rejected(&names, 500);
}

#[test]
fn the_checker_does_not_ask_the_solver() {
    let folder = Path::new("src/oracle/certificate");
    for file in fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        let code: String = text
            .lines()
            .map(|line| line.split("//").next().unwrap().to_owned() + "\n")
            .collect();
        for forbidden in [
            "conics",
            "chart",
            "enclosed::",
            "five_positions::krawczyk",
            "five_positions::families",
            "oracle::five_positions",
            "circle_conditions",
            "linkage::",
            "curvature::",
            "solve(",
        ] {
            assert!(
                !code.contains(forbidden),
                "{} names {forbidden}",
                path.display()
            );
        }
    }
}

#[test]
fn what_cannot_be_checked_is_said() {
    let mut entry = entries(Corpus::named("slider-cranks").unwrap())[0].clone();
    entry.answer["answer"]["N"] = Value::Null;
    entry.answer["answer"]["undecided"] = json!("N");
    let verdict = check_answer(&entry.problem, &entry.answer["answer"]);
    assert!(
        matches!(verdict, Err(Defect::Unchecked { .. })),
        "{verdict:?}"
    );
    let mut wished = entries(Corpus::named("random-five-positions").unwrap())[0].clone();
    wished.problem["wishes"] = json!({});
    let verdict = check_answer(&wished.problem, &wished.answer["answer"]);
    assert!(
        matches!(verdict, Err(Defect::Unchecked { .. })),
        "{verdict:?}"
    );
    let wrong = check_answer(&entry.problem, &json!({"problem": "poles"}));
    assert!(matches!(wrong, Err(Defect::Wrong { .. })), "{wrong:?}");
}
