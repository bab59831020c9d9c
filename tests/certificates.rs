//! The checker of answers accepts what is true and rejects what is damaged.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot read what it tests has failed"
)]

#[path = "support/damage.rs"]
mod damage;
#[path = "support/seed.rs"]
mod seed;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use burmester::oracle::certificate::{Defect, check_answer};
use burmester::oracle::vectors::{CORPORA, Corpus, Entry, Folder};
use burmester::oracle::{Request, solve};
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

use damage::{WAYS, change_digit, change_sign};

fn entries(corpus: &Corpus) -> Vec<Entry> {
    Folder::at(Path::new("data")).entries(corpus.name).unwrap()
}

/// Every so manyth answer; all where BURMESTER_LONG is 1.
fn step() -> usize {
    if seed::rounds(1) > 1 { 1 } else { 10 }
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
        _ => false,
    };
    changed.then_some(answer)
}

#[test]
fn damaged_answers_are_rejected() {
    let mut random = seed::generator("damaged_answers_are_rejected");
    let names = [
        "random-five-positions",
        "five-positions-of-linkages",
        "near-degenerate-five-positions",
        "degenerate-five-positions",
        "sliders",
    ];
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
    while tried.values().sum::<usize>() < 500 {
        let Entry { problem, answer } = &all[random.random_range(0..all.len())];
        let way = random.random_range(0..9);
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
    assert_eq!(tried.len(), 9, "{tried:?}");
}

/// Answers of these corpora that are proven, damaged in every way, must all be found wrong.
fn assert_damages_are_rejected(names: &[&str], least: usize) {
    let mut random = seed::generator(names[0]);
    let all: Vec<Entry> = names
        .iter()
        .flat_map(|name| entries(Corpus::named(name).unwrap()))
        .collect();
    let words: BTreeSet<(String, String)> = all
        .iter()
        .flat_map(|entry| damage::words(&entry.answer["answer"]))
        .collect();
    let mut proven: BTreeMap<usize, bool> = BTreeMap::new();
    let mut tried: BTreeMap<damage::Way, usize> = BTreeMap::new();
    let mut accepted = Vec::new();
    while tried.values().sum::<usize>() < least {
        let place = random.random_range(0..all.len());
        let Entry { problem, answer } = &all[place];
        let answer = &answer["answer"];
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
            accepted.push(format!("{} {way:?}: {verdict:?}", problem["id"]));
        }
    }
    eprintln!("{names:?}: {tried:?}");
    assert!(
        accepted.is_empty(),
        "{}:\n{}",
        accepted.len(),
        accepted.join("\n")
    );
    let proven = proven.values().filter(|proven| **proven).count();
    assert!(proven >= 20, "{names:?}: only {proven} proven");
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
    let all = entries(Corpus::named("slider-cranks").unwrap());
    let is_undecided = |entry: &&Entry| entry.answer["answer"].get("undecided").is_some();
    let entry = all.iter().find(is_undecided).unwrap();
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
