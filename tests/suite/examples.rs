//! What the documentation shows is run.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot compute what it tests has failed"
)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

#[path = "../../examples/check_a_solver.rs"]
mod check_a_solver;
#[path = "../../examples/coming_together.rs"]
mod coming_together;
#[path = "../../examples/output_of_1964.rs"]
mod output_of_1964;

#[test]
fn the_wrong_solver_is_told_what_is_wrong() {
    check_a_solver::main().unwrap();
    let report = check_a_solver::checked().unwrap();
    for expected in ["pairs: missed", "pairs: invented", "ulp"] {
        assert!(report.contains(expected), "no {expected:?} in\n{report}");
    }
}

#[test]
fn five_positions_that_come_together() {
    coming_together::main().unwrap();
    let rows = coming_together::distances().unwrap();
    // The distance goes to zero like h.
    for pair in rows.windows(2) {
        let ratio = pair[1].1 / pair[0].1;
        assert!((0.005..0.02).contains(&ratio), "{rows:?}");
    }
}

/// All rows are in the picture of the documentation but those at the ends of the second derivative, and
/// it is the one that the program draws.
#[test]
fn the_printed_table_over_the_curves() {
    output_of_1964::main().unwrap();
    let picture = output_of_1964::picture().unwrap();
    assert!(picture.matches("<circle").count() > 47 + 35, "{picture}");
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/pictures/output-of-1964.svg");
    assert!(fs::read_to_string(kept).unwrap() == picture, "draw it anew");
}

/// The blocks of commands of a page.
fn blocks(page: &str) -> Vec<String> {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(page)).unwrap();
    let fenced = text.split("```").skip(1).step_by(2);
    let commands = fenced.filter_map(|block| {
        block
            .strip_prefix('\n')
            .or_else(|| block.strip_prefix("sh\n"))
    });
    commands.map(str::to_owned).collect()
}

/// Runs a block as it stands, with what it writes in another folder, another program in place of the reader's,
/// and a coarse chart.
fn run(block: &str, folder: &Path) -> String {
    let program = env!("CARGO_BIN_EXE_burmester");
    let folder = folder.to_str().unwrap();
    let candidate = "score --problems hart -- sh scripts/candidates/burmester_f64.sh";
    let script = block
        .replace("score -- python3 mine.py", candidate)
        .replace("--svg ", &format!("--svg {folder}/"))
        .replace("-- report ", &format!("-- report -o {folder}/site "))
        .replace("chart -o ", &format!("chart --step 30 -o {folder}/"))
        .replace("cargo run --release --", program);
    let output = Command::new("sh")
        .args(["-e", "-c", &script])
        .env("BURMESTER", program)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{block}\n{said}");
    String::from_utf8(output.stdout).unwrap()
}

fn empty_folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn the_first_minute_of_the_readme() {
    let folder = empty_folder("readme");
    let mut count = 0;
    for block in blocks("README.md") {
        if !block.contains("cargo run --release -- ") {
            continue;
        }
        let said = run(&block, &folder);
        assert!(!said.is_empty(), "{block}");
        count += 1;
        // A picture is there if one was asked for.
        for name in block
            .split_whitespace()
            .filter(|word| word.ends_with(".svg"))
        {
            let picture = fs::read_to_string(folder.join(name)).unwrap();
            assert!(
                picture.starts_with("<svg") || picture.starts_with("<?xml"),
                "{name}"
            );
        }
    }
    assert!(count > 5, "{count} blocks");
}
