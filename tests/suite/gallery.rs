//! The pictures of the report: each is drawn, and stands beside a statement that there is.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use burmester::ledger::built_in;
use burmester::report::gallery::{Exhibit, of_source};

/// Bytes that a page can bear.
const MOST_BYTES: usize = 250_000;

fn all() -> Vec<(String, Vec<Exhibit>)> {
    let papers = built_in().unwrap();
    papers
        .iter()
        .map(|paper| (paper.key.clone(), of_source(&paper.key).unwrap()))
        .collect()
}

#[test]
fn every_picture_is_drawn_beside_a_statement() {
    let papers = built_in().unwrap();
    let mut drawn = 0;
    for (key, exhibits) in all() {
        let paper = papers.iter().find(|paper| paper.key == key).unwrap();
        for exhibit in exhibits {
            let Exhibit { beside, title, .. } = &exhibit;
            let statements = paper.statements.iter();
            assert!(
                statements.clone().any(|one| one.id.starts_with(beside)),
                "{title}: no id begins with {beside}"
            );
            check(&exhibit);
            drawn += 1;
        }
    }
    let list = include_str!("../../data/pictures.toml");
    assert_eq!(drawn, list.matches("[[picture]]").count());
}

fn check(exhibit: &Exhibit) {
    let Exhibit {
        title,
        caption,
        svg,
        moving,
        ..
    } = exhibit;
    for part in [
        "<svg xmlns=",
        "viewBox=\"0 0 ",
        " width=\"",
        " height=\"",
        "<title id=\"title\">",
        "<desc id=\"description\">",
    ] {
        assert!(svg.contains(part), "{title}: no {part}");
    }
    assert!(svg.ends_with("</svg>\n"), "{title}");
    assert!(svg.len() < MOST_BYTES, "{title}: {} bytes", svg.len());
    assert!(caption.ends_with('.'), "{title}");
    assert!(!svg.contains("NaN") && !svg.contains("inf "), "{title}");
    assert_eq!(svg.contains("<animate"), *moving, "{title}");
    assert_eq!(
        svg.matches("<animate").count(),
        svg.matches("begin=\"indefinite\"").count(),
        "{title}: what moves waits until it is told to"
    );
}

/// The mechanism comes back to where it began, and no bar changes its length on the way.
#[test]
fn moving_bars_keep_their_lengths() {
    let moving: Vec<Exhibit> = of_source("wunderlich1968").unwrap();
    let mut bars = 0;
    for exhibit in moving.iter().filter(|exhibit| exhibit.moving) {
        let lines = exhibit.svg.split("attributeName=\"d\" values=\"").skip(1);
        for values in lines.map(|rest| rest.split('"').next().unwrap()) {
            let places: Vec<f64> = values.split(';').map(length).collect();
            assert!(places.len() > 60, "{}", exhibit.title);
            let first = places[0];
            for place in &places {
                // The ends are rounded to a tenth.
                assert!((place - first).abs() < 0.2, "{}", exhibit.title);
            }
            assert_eq!(values.split(';').next(), values.split(';').next_back());
            bars += 1;
        }
    }
    assert!(bars > 20);
}

fn length(path: &str) -> f64 {
    let numbers: Vec<f64> = path
        .split(['M', 'L', ' '])
        .filter(|text| !text.is_empty())
        .map(|text| text.parse().unwrap())
        .collect();
    let [x, y, u, v] = numbers.try_into().unwrap();
    (u - x).hypot(v - y)
}
