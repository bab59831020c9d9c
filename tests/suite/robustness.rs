//! The command where the world fails: full disks, readers that go, interrupted runs, floods, masses.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot run what it tests has failed"
)]

use std::fs::{self, File};
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

const PROBLEM: &str = r#"{"problem": "hart", "m": "5", "n": "4", "d": "4", "kappa": "1/2"}"#;

/// The command within memory that the largest input must not go beyond: 2 GiB.
fn burmester(arguments: &str) -> Command {
    let program = env!("CARGO_BIN_EXE_burmester");
    let mut command = Command::new("sh");
    let script = format!("ulimit -v 2097152; exec '{program}' {arguments}");
    command.args(["-c", &script]).stdin(Stdio::null());
    command
}

/// A folder of this test's own, empty.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("robustness-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// One line on standard error that says this, and status 2.
fn assert_refused(output: &Output, expected: &str) {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
    assert!(said.contains(expected) && said.len() < 2000, "{said}");
}

fn solve_file(text: &[&str], arguments: &str) -> Output {
    let file = folder(arguments.split(' ').next_back().unwrap()).join("problem.json");
    let mut writing = File::create(&file).unwrap();
    for part in text {
        writing.write_all(part.as_bytes()).unwrap();
    }
    drop(writing);
    let command = format!("{arguments} {}", file.display());
    burmester(&command).output().unwrap()
}

#[test]
fn a_hundred_megabytes_are_refused() {
    let note = "1,".repeat(50_000_000);
    let text = [r#"{"problem": "hart", "note": ["#, &note, "1]}"];
    assert_refused(&solve_file(&text, "solve"), "longer than 16 MiB");
    assert_refused(
        &solve_file(&text, "solve --lines"),
        "problem.json:1: longer",
    );
}

#[test]
fn numbers_at_the_limit_of_digits() {
    let number = |digits: usize| format!("1.{}", "3".repeat(digits - 1));
    let problem = |digits: usize| {
        format!(
            r#"{{"problem": "hart", "m": "5", "n": "{}", "d": "4", "kappa": "1/2"}}"#,
            number(digits)
        )
    };
    let start = Instant::now();
    let limit = burmester::number::text::MOST_DIGITS;
    assert!(
        solve_file(&[&problem(limit)], "solve --digits 50")
            .status
            .success()
    );
    assert_refused(
        &solve_file(&[&problem(limit + 1)], "solve --digits 51"),
        "n:",
    );
    assert!(start.elapsed() < Duration::from_secs(60), "takes too long");
    let output = burmester("solve --digits 100001").output().unwrap();
    assert_eq!(output.status.code(), Some(2));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_said() {
    for arguments in [
        "verify kaufman",
        "explain wunderlich1968/eq/1.4",
        "vectors list",
    ] {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let output = burmester(arguments).stdout(full).output().unwrap();
        assert_refused(&output, "standard output");
    }
}

/// `/proc` takes no files, whoever asks.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_cannot_be_written_is_said() {
    let file = folder("problem").join("problem.json");
    fs::write(&file, PROBLEM).unwrap();
    let file = file.display();
    for arguments in [
        format!("solve --svg /proc/mechanism.svg {file}"),
        "report -o /proc/site".to_owned(),
        "chart --step 30 -o /proc/charts".to_owned(),
    ] {
        assert_refused(&burmester(&arguments).output().unwrap(), "/proc/");
    }
}

/// However early it is stopped, a file is there whole or not at all.
#[test]
fn interrupted_runs_leave_no_half_written_file() {
    let folder = folder("interrupted");
    for milliseconds in [0, 20, 60, 120, 250, 500] {
        let arguments = format!("solve --svg {0}/m.svg {0}/problem.json", folder.display());
        fs::write(folder.join("problem.json"), PROBLEM).unwrap();
        let mut child = burmester(&arguments).stdout(Stdio::null()).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(milliseconds));
        let _ = child.kill();
        child.wait().unwrap();
        if let Ok(picture) = fs::read_to_string(folder.join("m.svg")) {
            assert!(picture.ends_with("</svg>\n"), "after {milliseconds} ms");
            fs::remove_file(folder.join("m.svg")).unwrap();
        }
    }
}

/// A candidate that never stops writing is cut off, whether it writes lines or not.
#[test]
fn a_candidate_that_floods_its_output() {
    let start = Instant::now();
    for flood in ["yes 0", "yes | tr -d \"\\n\""] {
        let arguments =
            format!("score --problems hart --only hart/0001 --time-limit 1 -- sh -c '{flood}'");
        let output = burmester(&arguments).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{said}");
    }
    assert!(start.elapsed() < Duration::from_secs(60), "takes too long");
}
