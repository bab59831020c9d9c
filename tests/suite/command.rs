//! The command as a user meets it: right calls, and wrong ones.
#![expect(
    clippy::unwrap_used,
    clippy::as_conversions,
    reason = "a test that cannot run what it tests has failed"
)]

use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

fn burmester(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_burmester"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_vec();
    // A command that ends early closes its input; that is its right.
    let writer = std::thread::spawn(move || {
        let _ = stdin.write_all(&input);
    });
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    output
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A folder of this test's own, empty.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// One helpful line that says all of this, status 2, and nothing on standard output.
fn assert_refused(output: &Output, expected: &[&str]) {
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "status; said: {message}");
    assert_eq!(message.lines().count(), 1, "not one line: {message}");
    assert!(
        message.len() < 2000,
        "the line is {} bytes long",
        message.len()
    );
    assert!(
        output.stdout.is_empty(),
        "said on standard output: {}",
        text(&output.stdout)
    );
    for part in expected {
        assert!(message.contains(part), "`{part}` is not in: {message}");
    }
}

fn refused_problem(problem: &str, expected: &[&str]) {
    assert_refused(&burmester(&["solve"], problem.as_bytes()), expected);
}

const ANGLES: &str = r#""alpha_a": {"degrees": "72.5"}, "alpha_d": {"degrees": "45"}"#;

#[test]
fn wrong_problems_get_one_helpful_line() {
    let with_k =
        |k: &str| format!(r#"{{"problem": "slider-crank-alternates", "k": {k}, {ANGLES}}}"#);
    refused_problem("", &["standard input", "empty"]);
    refused_problem("{", &["standard input", "no JSON", "line 1"]);
    refused_problem("[]", &["an object was expected", "a list"]);
    refused_problem("{}", &["problem", "missing"]);
    refused_problem(
        r#"{"problem": "slider-crank"}"#,
        &["unknown problem", "slider-crank-alternates"],
    );
    refused_problem(
        &format!(r#"{{"problem": "slider-crank-alternates", {ANGLES}}}"#),
        &["k: this field is missing"],
    );
    refused_problem(&with_k(r#""x""#), &["k:", "'x'"]);
    refused_problem(&with_k("null"), &["k:", "a number was expected", "null"]);
    refused_problem(&with_k(r#""1/0""#), &["k:", "zero"]);
    refused_problem(&with_k(r#""1e999999999""#), &["k:", "exponent"]);
    refused_problem(&with_k("1e999999999"), &["k:", "exponent"]);
    refused_problem(
        r#"{"problem": "slider-crank-alternates", "k": 1, "alpha_a": {"cos": "0.6", "sin": "0.81"}, "alpha_d": {"degrees": 4}}"#,
        &["alpha_a", "cos² + sin²"],
    );
    refused_problem(
        r#"{"problem": "slider-crank-alternates", "k": 1, "alpha_a": {"grad": "0.6"}, "alpha_d": {"degrees": 4}}"#,
        &["alpha_a", "grad", "degrees"],
    );
    refused_problem(&with_k(r#"1, "kk": 2"#), &["kk: unknown field", "alpha_a"]);
    refused_problem(&"[".repeat(100_000), &["no JSON"]);
}

#[test]
fn ten_megabytes_of_rubbish_are_refused() {
    let rubbish: Vec<u8> = (0u32..10_000_000)
        .map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8)
        .collect();
    assert_refused(&burmester(&["solve"], &rubbish), &["standard input"]);
    let digits = format!(
        r#"{{"problem": "slider-crank-alternates", "k": "{}", {ANGLES}}}"#,
        "7".repeat(10_000_000)
    );
    assert_refused(&burmester(&["solve"], digits.as_bytes()), &["k:", "digits"]);
    let file = folder("rubbish");
    fs::write(file.join("paper.toml"), &rubbish).unwrap();
    let data = file.display().to_string();
    assert_refused(
        &burmester(&["verify", "--data", &data], b""),
        &["paper.toml"],
    );
}

#[test]
fn missing_files_and_wrong_names_are_named() {
    assert_refused(
        &burmester(&["solve", "no-such-file.json"], b""),
        &["no-such-file.json"],
    );
    assert_refused(
        &burmester(&["verify", "--data", "no-such-folder"], b""),
        &["no-such-folder"],
    );
    assert_refused(
        &burmester(&["verify", "tesar"], b""),
        &["unknown source `tesar`", "tesar1964"],
    );
    assert_refused(
        &burmester(&["explain", "wunderlich1968/eq/1.8"], b""),
        &["wunderlich1968/eq/1.8-s", "wunderlich1968/eq/1.8-r2"],
    );
    assert_eq!(
        burmester(&["solve", "--digits", "0"], b"").status.code(),
        Some(2)
    );
    assert_eq!(burmester(&["no-such-command"], b"").status.code(), Some(2));
}

#[test]
fn without_a_command_the_main_job_runs() {
    let output = burmester(&[], b"");
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let said = text(&output.stdout);
    assert!(said.contains("Errata"), "{said}");
    assert!(said.contains("verdicts are the expected ones"), "{said}");
    assert!(!said.contains('\u{1b}'), "colours outside a terminal");
}

#[test]
fn explain_shows_formula_symbols_and_proof() {
    let output = burmester(&["explain", "wunderlich1968/eq/2.2"], b"");
    let said = text(&output.stdout);
    for part in [
        "holds",
        "identity",
        "length MP",
        "unit vector of the bar NQ",
        "rejected",
    ] {
        assert!(said.contains(part), "`{part}` is not in:\n{said}");
    }
}

#[test]
fn problems_by_the_line_are_answered_in_order() {
    let problem = |k: u32| {
        format!(
            "{{\"problem\": \"slider-crank-alternates\", \"id\": \"p{k}\", \"k\": {k}, {ANGLES}}}\n"
        )
    };
    let input: String = (1..=5).map(problem).collect();
    for arithmetic in ["certified", "f64"] {
        let output = burmester(
            &["solve", "--lines", "--arithmetic", arithmetic],
            input.as_bytes(),
        );
        let ids: Vec<String> = text(&output.stdout)
            .lines()
            .map(|line| {
                let answer: serde_json::Value = serde_json::from_str(line).unwrap();
                answer["id"].as_str().unwrap().to_owned()
            })
            .collect();
        assert_eq!(ids, ["p1", "p2", "p3", "p4", "p5"]);
    }
}

#[test]
fn pictures_are_written_whole_or_not_at_all() {
    let folder = folder("pictures");
    let file = folder.join("mechanism.svg");
    let path = file.display().to_string();
    let problem =
        br#"{"problem": "focal-mechanism", "a": "5", "b": "5", "c": "2", "d": "4", "rho": "1"}"#;
    assert!(
        burmester(&["solve", "--svg", &path], problem)
            .status
            .success()
    );
    let picture = fs::read_to_string(&file).unwrap();
    for part in [
        "<svg",
        "<title",
        "<desc",
        "path of the coupler point T",
        "</svg>",
    ] {
        assert!(picture.contains(part), "`{part}` is not in the picture");
    }
    assert!(
        !picture.contains("NaN") && !picture.contains("inf"),
        "no number"
    );
    let nowhere = folder
        .join("no-such-folder")
        .join("a.svg")
        .display()
        .to_string();
    assert_refused(
        &burmester(&["solve", "--svg", &nowhere], problem),
        &["a.svg"],
    );
    let none =
        br#"{"problem": "focal-mechanism", "a": "1", "b": "1", "c": "5", "d": "6", "rho": "1"}"#;
    assert_refused(
        &burmester(&["solve", "--svg", &path], none),
        &["no picture"],
    );
    assert_eq!(
        fs::read_dir(&folder).unwrap().count(),
        1,
        "something is left over"
    );
}

/// Before any work is done.
#[test]
fn a_report_needs_a_folder_that_can_be_written() {
    let folder = folder("report");
    let file = folder.join("file");
    fs::write(&file, "").unwrap();
    let inside = file.join("site");
    let output = burmester(&["report", "-o", inside.to_str().unwrap()], b"");
    assert_refused(&output, &["file/site"]);
}

#[test]
fn wrong_mechanisms_get_one_helpful_line() {
    refused_problem(
        r#"{"problem": "focal-mechanism", "a": "-5", "b": "5", "c": "2", "d": "4", "rho": "1"}"#,
        &["a:", "positive"],
    );
    refused_problem(
        r#"{"problem": "focal-mechanism", "a": "5", "b": "5", "c": "2", "d": "4", "rho": "-1"}"#,
        &["rho", "hart"],
    );
    refused_problem(
        r#"{"problem": "hart", "m": "5", "n": "5", "d": "4", "kappa": "1"}"#,
        &["kappa"],
    );
}

#[test]
fn more_digits_agree_with_fewer() {
    let problem = format!(r#"{{"problem": "slider-crank-alternates", "k": "0.9", {ANGLES}}}"#);
    let value = |digits: &str| {
        let output = burmester(
            &["solve", "--format", "json", "--digits", digits],
            problem.as_bytes(),
        );
        let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        answer["PB"]["value"].as_str().unwrap().to_owned()
    };
    let (few, many) = (value("10"), value("1000"));
    assert!(
        many.starts_with(few.get(..12).unwrap()),
        "{few} against {many}"
    );
    assert!(many.len() > 1000);
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_burmester"))
        .args(["verify", "filemon1970", "--format", "json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert!(output.stderr.is_empty(), "{}", text(&output.stderr));
    assert!(output.status.success());
}

/// The examples of the documentation on adding a paper.
fn documented(place: usize) -> String {
    let documentation = fs::read_to_string("docs/adding-a-paper.md").unwrap();
    let after = documentation.split("```toml\n").nth(place).unwrap();
    after.split_once("```").unwrap().0.to_owned()
}

/// Its three lines: one right, one misprinted with its correction, one number.
fn made_up_paper() -> String {
    documented(1)
}

fn verify_made_up(name: &str, paper: &str) -> Output {
    let folder = folder(name);
    for entry in fs::read_dir("data/papers").unwrap() {
        let path = entry.unwrap().path();
        fs::copy(&path, folder.join(path.file_name().unwrap())).unwrap();
    }
    fs::write(folder.join("example2020.toml"), paper).unwrap();
    burmester(
        &[
            "verify",
            "example2020",
            "--format",
            "json",
            "--data",
            &folder.display().to_string(),
        ],
        b"",
    )
}

#[test]
fn a_paper_is_added_without_any_code() {
    let output = verify_made_up("made-up", &made_up_paper());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let verdicts: Vec<(String, String)> = text(&output.stdout)
        .lines()
        .map(|line| {
            let line: serde_json::Value = serde_json::from_str(line).unwrap();
            (line["verdict"].to_string(), line["proof"].to_string())
        })
        .collect();
    let expected = [
        ("holds", "identity"),
        ("fails", "exact"),
        ("reproduced", "exact"),
    ];
    assert_eq!(
        verdicts,
        expected.map(|(a, b)| (format!("\"{a}\""), format!("\"{b}\"")))
    );
}

#[test]
fn a_table_is_added_without_any_code() {
    let paper = made_up_paper().replace("statements = 3", "statements = 7");
    let paper = format!("{paper}\n{}", documented(2));
    let output = verify_made_up("made-up-table", &paper);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let cells: Vec<(String, String)> = text(&output.stdout)
        .lines()
        .skip(3)
        .map(|line| {
            let line: serde_json::Value = serde_json::from_str(line).unwrap();
            (line["verdict"].to_string(), line["computed"].to_string())
        })
        .collect();
    let expected = [
        ("holds", "+"),
        ("fails", "-"),
        ("holds", "-"),
        ("holds", "+"),
    ];
    assert_eq!(
        cells,
        expected.map(|(a, b)| (format!("\"{a}\""), format!("\"{b}\"")))
    );
}

#[test]
fn a_table_of_numbers_is_one_entry() {
    let paper = made_up_paper().replacen("statements = 3", "statements = 5", 1);
    let paper = format!("{paper}\n{}", documented(3));
    let output = verify_made_up("made-up-numbers", &paper);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let cells: Vec<serde_json::Value> = text(&output.stdout)
        .lines()
        .skip(3)
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let verdicts: Vec<&serde_json::Value> = cells.iter().map(|cell| &cell["verdict"]).collect();
    assert_eq!(verdicts, ["reproduced", "contradicted"]);
    assert_eq!(cells[1]["id"], "example2020/table2/d=5/r");
    assert_eq!(cells[1]["convention"], "The positive one.");
    // No such cell, a row that is too long.
    for (from, to, message) in [
        ("\"d=5/r\"", "\"d=6/r\"", "there is no cell `d=6/r`"),
        (
            "[\"0.4495\"] },\n]",
            "[\"0.4495\", \"1\"] },\n]",
            "has 2 cells",
        ),
    ] {
        let output = verify_made_up("made-up-numbers", &paper.replacen(from, to, 1));
        assert_eq!(output.status.code(), Some(2));
        assert!(
            text(&output.stderr).contains(message),
            "{}",
            text(&output.stderr)
        );
    }
}

/// A printed input is known to its last digit.
#[test]
fn measured_inputs_are_intervals() {
    let paper = made_up_paper();
    let measured = |witness: &str| {
        let paper = paper.replacen(
            "d = \"4\" }",
            &format!("{witness} }}\nmeasured = {{ d = \"4.00\" }}"),
            1,
        );
        paper.replacen("expected = \"reproduced\"", "expected = \"consistent\"", 1)
    };
    let output = verify_made_up("measured", &measured("d = \"4.0001\""));
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains("\"verdict\":\"consistent\""));
    let output = verify_made_up("measured", &measured("d = \"4.01\""));
    assert_eq!(output.status.code(), Some(2));
    assert!(
        text(&output.stderr).contains("not within the digits"),
        "{}",
        text(&output.stderr)
    );
}

#[test]
fn an_unexpected_verdict_ends_with_status_1() {
    let paper =
        made_up_paper().replacen("expected = \"reproduced\"", "expected = \"truncated\"", 1);
    let output = verify_made_up("unexpected", &paper);
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
}

#[test]
fn wrong_data_gets_file_line_and_advice() {
    let paper = made_up_paper();
    let trials: [(&str, &str, &[&str]); 13] = [
        ("locus = ", "place = ", &["unknown field `place`", "locus"]),
        ("example2020/eq/2", "example2020/eq/1", &["stands twice"]),
        (
            "example2020/eq/2",
            "other/eq/1",
            &["must begin with `example2020/`"],
        ),
        ("a^2 + b^2", "a^2 + y^2", &["unknown symbol `y`", "column"]),
        ("a^2 + b^2", "a^2 + + b^2", &["column", "expected"]),
        ("a^2 + b^2", "a^2 + u", &["example2020/eq"]),
        (
            "scene = \"wunderlich1968/coupler\"",
            "scene = \"couple\"",
            &["unknown scene `couple`", "wunderlich1968/coupler"],
        ),
        (
            "expected = \"holds\"",
            "expected = \"reproduced\"",
            &["does not fit the kind `equation`"],
        ),
        (
            "expected = \"holds\"",
            "expected = \"true\"",
            &["unknown variant `true`"],
        ),
        ("cause = \"print\"\n", "", &["`cause`"]),
        (
            "kind = \"number\"",
            "kind = \"numeral\"",
            &["unknown variant `numeral`"],
        ),
        ("statements = 3", "statements = 2", &["3 statements"]),
        ("given = {", "given = [", &["example2020.toml"]),
    ];
    for (place, (from, to, expected)) in trials.iter().enumerate() {
        let wrong = paper.replace(from, to);
        assert_ne!(wrong, paper, "`{from}` is not in the made-up paper");
        let output = verify_made_up(&format!("wrong-{place}"), &wrong);
        assert_refused(&output, &[&["example2020.toml:"], *expected].concat());
    }
}

#[test]
fn a_correction_that_is_wrong_itself_is_refused() {
    let wrong = made_up_paper().replace("correct = \"", "correct = \"1 + ");
    let output = verify_made_up("wrong-correction", &wrong);
    assert_refused(&output, &["does not hold"]);
}

#[test]
fn a_formula_nested_ten_thousand_deep_is_refused() {
    for (depth, expected) in [(10_000, "at most 20000"), (5_000, "deep")] {
        let deep = format!("{}a{}", "(".repeat(depth), ")".repeat(depth));
        let wrong = made_up_paper().replace("a^2 + b^2", &deep);
        assert_refused(&verify_made_up("deep", &wrong), &[expected]);
    }
}

#[test]
fn corpora_are_listed_shown_and_made() {
    let listed = burmester(&["vectors", "list"], b"");
    assert_eq!(listed.status.code(), Some(0));
    let said = text(&listed.stdout);
    assert!(
        said.contains("random-five-positions  400 problems"),
        "{said}"
    );
    assert!(
        !said.contains('\u{1b}'),
        "colours where there is no terminal"
    );
    let shown = burmester(
        &["vectors", "show", "degenerate-five-positions/double"],
        b"",
    );
    let said = text(&shown.stdout);
    for part in ["multiple pair", "flag multiple-pair:", "claims", "pairs"] {
        assert!(said.contains(part), "`{part}` is not in: {said}");
    }
    let folder = folder("vectors");
    let out = folder.to_str().unwrap();
    let made = burmester(
        &[
            "vectors",
            "make",
            "hart",
            "degenerate-three-positions",
            "--out",
            out,
        ],
        b"",
    );
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    for file in [
        "problems/hart.jsonl",
        "answers/hart.jsonl",
        "answers/degenerate-three-positions.jsonl",
    ] {
        let own = fs::read(folder.join(file)).unwrap();
        assert!(
            own == fs::read(PathBuf::from("data").join(file)).unwrap(),
            "{file}"
        );
    }
    // The folder has no flags, and cannot be checked.
    let checked = burmester(&["vectors", "check", "hart", "--data", out], b"");
    assert_refused(&checked, &["flags.json"]);
    fs::copy(
        "data/problems/flags.json",
        folder.join("problems/flags.json"),
    )
    .unwrap();
    let checked = burmester(&["vectors", "check", "hart", "--all", "--data", out], b"");
    assert_eq!(checked.status.code(), Some(0), "{}", text(&checked.stdout));
    let answers = folder.join("answers/hart.jsonl");
    let damaged =
        fs::read_to_string(&answers)
            .unwrap()
            .replacen("\"exact\":\"", "\"exact\":\"7", 1);
    fs::write(&answers, damaged).unwrap();
    let checked = burmester(&["vectors", "check", "hart", "--data", out], b"");
    assert_eq!(checked.status.code(), Some(1));
    let said = text(&checked.stdout);
    assert!(
        said.contains("corpora.json") && said.contains("hart/0001"),
        "{said}"
    );
}

#[test]
fn unknown_corpora_get_one_helpful_line() {
    for (arguments, expected) in [
        (["vectors", "make", "harts"], "unknown corpus `harts`"),
        (["vectors", "check", "harts"], "unknown corpus `harts`"),
        (["vectors", "show", "hart"], "no id of a problem"),
        (["vectors", "show", "hart/abc"], "no problem `hart/abc`"),
    ] {
        assert_refused(&burmester(&arguments, b""), &[expected]);
    }
}
