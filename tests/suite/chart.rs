//! The chart of linkages with a Ball-double-Burmester point, as it is committed.
#![expect(
    clippy::unwrap_used,
    clippy::string_slice,
    reason = "a test that cannot go on has failed"
)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use burmester::number::{Ball, Number};
use burmester::oracle::chart::{Member, grid, header, row};
use burmester::straight_line::deviation::arc::{End, Limit};
use burmester::straight_line::deviation::closed::Closed;
use burmester::straight_line::deviation::floats::{FloatArc, arc};

const TABLE: &str = "data/charts/ball-double-burmester.csv";

/// Degrees between the points of the grid; all where BURMESTER_LONG is 1.
fn step(usual: u32) -> u32 {
    let is_long = std::env::var("BURMESTER_LONG").is_ok_and(|value| value == "1");
    if is_long { 1 } else { usual }
}

#[test]
fn computed_rows_are_the_committed_ones() {
    let table = fs::read_to_string(TABLE).unwrap();
    assert!(table.starts_with(&header(1)), "the header is old");
    let rows: Vec<&str> = table.strip_prefix(&header(1)).unwrap().lines().collect();
    let all = grid(1);
    assert_eq!(rows.len(), all.len());
    for rays in grid(step(30)) {
        let place = all.iter().position(|known| *known == rays).unwrap();
        assert_eq!(rows[place], row(rays).text);
    }
}

#[test]
fn the_picture_is_that_of_the_table() {
    let table = fs::read_to_string(TABLE).unwrap();
    let picture = fs::read_to_string(Path::new(TABLE).with_extension("svg")).unwrap();
    assert!(burmester::report::chart(&table).unwrap() == picture);
}

/// (α_a, α_b) and (180° − α_b, 180° − α_a) are one linkage, mirrored, with the other crank turned: only
/// dead centres can make a difference.
#[test]
fn mirrored_linkages_are_the_same() {
    let table = fs::read_to_string(TABLE).unwrap();
    let rows = table.strip_prefix(&header(1)).unwrap().lines();
    let cells: Vec<Vec<&str>> = rows.map(|row| row.split(',').collect()).collect();
    let all = grid(1);
    let (mut pairs, mut different) = (0, 0);
    for ([a, b], one) in all.iter().zip(&cells) {
        let mirrored = all
            .binary_search(&[180 - b, 180 - a])
            .map(|place| &cells[place]);
        let Some(other) = mirrored.ok().filter(|_| *b >= 90 && !one[2].is_empty()) else {
            continue;
        };
        // Q, R, S, T.
        assert_eq!(
            one[5..9],
            [other[5], other[8], other[7], other[6]],
            "{a} {b}"
        );
        if one[2] != other[2] {
            let ends = [one[11], one[12], other[11], other[12]];
            assert!(ends.contains(&"dead-centre"), "{a} {b}");
            different += 1;
        }
        pairs += 1;
    }
    assert!(pairs > 7000 && different > 4000, "{pairs} {different}");
}

fn float(x: &Number<Ball>) -> Number<f64> {
    Number(x.0.midpoint_rational().unwrap().to_f64())
}

/// The arc in floats, and the certified length.
fn both(member: &Member) -> (FloatArc, Number<Ball>) {
    let closed: Closed<f64> = member.arcs.closed().map(float);
    let floats = arc(&closed, float(&member.bound()).0).unwrap();
    let certified = member.arcs.within(&member.bound()).unwrap();
    for (edge, limit) in floats.ends.iter().zip(&certified) {
        assert_eq!(edge.end, limit.end);
    }
    let [from, to] = certified.each_ref().map(|limit| {
        let position = member.arcs.position(limit).unwrap();
        member.arcs.coordinates(&position)[0].clone()
    });
    (floats, (to - from).abs())
}

#[test]
fn floats_err_by_no_more_than_they_say() {
    let (mut compared, mut worst) = (0, 0.0f64);
    for rays in grid(step(9)) {
        // In a dead centre half of the digits are lost.
        let Ok(member) = Member::of(rays, 256) else {
            continue;
        };
        let (floats, certified) = both(&member);
        let [length, error] = floats.length();
        let length = Number::<Ball>::from(rug::Rational::from_f64(length).unwrap());
        let difference = float(&(length - certified)).0.abs();
        assert!(
            difference <= error,
            "{rays:?}: {difference:e} > {error:e}, {:?}",
            floats.ends
        );
        worst = worst.max(difference / error);
        compared += 1;
    }
    assert!(compared > 80, "{compared}");
    // A bound that is never nearly reached says nothing.
    assert!(worst > 1e-3, "{worst:e}");
}

#[test]
fn the_least_transmission_angle_is_that_of_all_positions() {
    const BITS: u32 = 128;
    let mut compared = 0;
    for rays in grid(step(15)) {
        let Ok(member) = Member::of(rays, BITS) else {
            continue;
        };
        let closed = member.arcs.closed();
        if !matches!(closed.dead_centre(true, BITS), Some(None)) {
            continue;
        }
        let at = |degrees: i64| Limit {
            degrees: degrees.into(),
            end: End::Deviation,
        };
        let least = closed
            .least_transmission(&[at(-200), at(90)], BITS)
            .unwrap();
        let angle = |degrees| {
            let position = member.arcs.position(&at(degrees)).unwrap();
            let [_, angle] = member.arcs.transmission_angles(&position);
            float(&angle).0
        };
        let sampled = (-100..=45).map(|half| angle(2 * half)).fold(90.0, f64::min);
        let least = float(&least).0;
        assert!(
            least <= sampled + 1e-9,
            "{rays:?}: {least}, sampled {sampled}"
        );
        assert!(
            least >= sampled - 4.0,
            "{rays:?}: {least}, sampled {sampled}"
        );
        compared += 1;
    }
    assert!(compared >= 4, "{compared}");
}

fn made(folder: &Path, threads: &str) -> [Vec<u8>; 2] {
    let output = Command::new(env!("CARGO_BIN_EXE_burmester"))
        .args(["chart", "--step", "30", "--threads", threads, "-o"])
        .arg(folder)
        .output()
        .unwrap();
    assert!(output.status.success(), "{output:?}");
    let read = |kind: &str| fs::read(folder.join(format!("ball-double-burmester.{kind}"))).unwrap();
    [read("csv"), read("svg")]
}

fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn an_interrupted_call_goes_on_to_the_same_files() {
    let whole = made(&folder("chart-whole"), "2");
    let text = String::from_utf8(whole[0].clone()).unwrap();
    let interrupted = folder("chart-interrupted");
    let part = interrupted.join("ball-double-burmester.csv.part");
    // Cut in the middle of a row, after rows in another order.
    let rows: Vec<&str> = text.strip_prefix(&header(30)).unwrap().lines().collect();
    let kept = format!("{}{}\n{}\n{}", header(30), rows[4], rows[1], &rows[7][..9]);
    fs::write(&part, kept).unwrap();
    assert_eq!(made(&interrupted, "1"), whole);
    assert!(!part.exists());
}
