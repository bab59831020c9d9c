//! The checker of answers accepts what is true and rejects what is damaged.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot read what it tests has failed"
)]

#[path = "support/seed.rs"]
mod seed;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use burmester::oracle::certificate::{Defect, check_answer};
use burmester::oracle::vectors::{CORPORA, Corpus, Entry, Folder};
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

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
    let mut wrong = Vec::new();
    for corpus in &CORPORA {
        for Entry { problem, answer } in entries(corpus).iter().step_by(step()) {
            match check_answer(problem, &answer["answer"]) {
                Ok(()) => *accepted.entry(corpus.name).or_default() += 1,
                Err(Defect::Unchecked { .. }) => {}
                Err(defect) => wrong.push(format!("{}: {defect}", problem["id"])),
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("; "));
    for name in [
        "random-five-positions",
        "five-positions-of-linkages",
        "near-degenerate-five-positions",
        "sliders",
        "random-four-positions",
        "random-poles",
        "random-three-positions",
    ] {
        let count = accepted.get(name).copied().unwrap_or_default();
        assert!(count >= 10, "{name}: only {count} accepted: {accepted:?}");
    }
}

/// Changes one of the first 40 digits of a number that goes out; false where it has none to change.
fn change_digit(number: &mut Value, random: &mut ChaCha8Rng) -> bool {
    let name = if number.get("exact").is_some() {
        "exact"
    } else {
        "value"
    };
    let Some(text) = number[name].as_str() else {
        return false;
    };
    let mut characters: Vec<char> = text.split(['e', 'E']).next().unwrap().chars().collect();
    let rest: String = text.chars().skip(characters.len()).collect();
    let digits: Vec<usize> = (0..characters.len())
        .filter(|place| characters[*place].is_ascii_digit())
        .take(40)
        .collect();
    let place = digits[random.random_range(0..digits.len())];
    let old = characters[place].to_digit(10).unwrap();
    let new = (old + random.random_range(1..10)) % 10;
    characters[place] = char::from_digit(new, 10).unwrap();
    number[name] = json!(characters.into_iter().collect::<String>() + &rest);
    true
}

fn change_sign(number: &mut Value) -> bool {
    let name = if number.get("exact").is_some() {
        "exact"
    } else {
        "value"
    };
    let Some(text) = number[name].as_str() else {
        return false;
    };
    if text == "0" {
        return false;
    }
    number[name] = json!(match text.strip_prefix('-') {
        Some(rest) => rest.to_owned(),
        None => format!("-{text}"),
    });
    true
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
fn damage(answer: &Value, way: u32, random: &mut ChaCha8Rng) -> Option<Value> {
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
        let Some(damaged) = damage(&answer["answer"], way, &mut random) else {
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

#[test]
fn damaged_poles_and_curves_are_rejected() {
    let mut random = seed::generator("damaged_poles_and_curves_are_rejected");
    let mut tried = 0;
    for (name, kind) in [
        ("random-poles", "poles"),
        ("random-four-positions", "centerpoint-curve"),
    ] {
        for Entry { problem, answer } in entries(Corpus::named(name).unwrap()).iter().step_by(9) {
            let mut damaged = answer["answer"].clone();
            let pole = &mut damaged["poles"]["12"];
            if pole.is_array() && change_digit(&mut pole[0], &mut random) {
                let verdict = check_answer(problem, &damaged);
                assert!(
                    matches!(verdict, Err(Defect::Wrong { .. })),
                    "{}: {verdict:?}",
                    problem["id"]
                );
                tried += 1;
            }
            if kind == "centerpoint-curve" {
                let mut damaged = answer["answer"].clone();
                damaged["circlepoint"]["coefficients"][9] = json!("123456789");
                let verdict = check_answer(problem, &damaged);
                assert!(
                    matches!(verdict, Err(Defect::Wrong { .. })),
                    "{}: {verdict:?}",
                    problem["id"]
                );
                tried += 1;
            }
        }
    }
    assert!(tried > 40, "{tried}");
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
    let entry = &entries(Corpus::named("hart").unwrap())[0];
    let verdict = check_answer(&entry.problem, &entry.answer["answer"]);
    assert!(
        matches!(verdict, Err(Defect::Unchecked { .. })),
        "{verdict:?}"
    );
    let wrong = check_answer(&entry.problem, &json!({"problem": "poles"}));
    assert!(matches!(wrong, Err(Defect::Wrong { .. })), "{wrong:?}");
}
