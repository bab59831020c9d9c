//! A short run of what `fuzz/` runs for long: its corpus, then random bytes.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot read what it tests has failed"
)]

use std::fs;
use std::path::PathBuf;

use crate::fuzz;
use crate::support::seed::{generator, rounds};
use burmester::oracle::PROBLEMS;
use rand::RngCore;

/// The corpus and what was once a crash, then random bytes up to a length.
fn run(target: &str, subject: impl Fn(&[u8]), cases: usize, longest: u32) {
    let folder = PathBuf::from("fuzz/corpus").join(target);
    let mut files: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    files.sort();
    assert!(!files.is_empty(), "no corpus of {target}");
    for file in files {
        subject(&fs::read(file).unwrap());
    }
    let mut random = generator(target);
    for _ in 0..rounds(cases) {
        let length = usize::try_from(random.next_u32() % longest).unwrap();
        let mut bytes = vec![0; length];
        random.fill_bytes(&mut bytes);
        subject(&bytes);
    }
}

#[test]
fn formula_text() {
    run("formula_text", fuzz::formula_text, 500, 60);
}

#[test]
fn formula_words() {
    run("formula_words", fuzz::formula_words, 2000, 12);
}

#[test]
fn data_text() {
    run("data_text", fuzz::data_text, 500, 60);
}

#[test]
fn damaged_papers() {
    run("damaged_paper", fuzz::damaged_paper, 15, 40);
}

/// All kinds but `deviation`, of which a strange design takes up to a minute; `fuzz/` draws it too.
#[test]
fn problems() {
    let quick = |bytes: &[u8]| {
        let kind = bytes
            .first()
            .map(|byte| usize::from(*byte) % PROBLEMS.len());
        if kind.and_then(|kind| PROBLEMS.get(kind)) != Some(&"deviation") {
            fuzz::problem(bytes);
        }
    };
    run("problem", quick, 80, 80);
}
