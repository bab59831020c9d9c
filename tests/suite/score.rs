//! `burmester score` with small fake candidates: good ones, wrong ones, and those that misbehave.
#![cfg(unix)]
#![expect(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test that cannot run what it tests has failed"
)]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use burmester::oracle::score::{Mark, Reference};
use serde_json::{Value, json};

const CORPUS: &str = "tests/data/score";

/// Answers with the line of its folder that the id names, or does what the script there says.
const CANDIDATE: &str = r#"while IFS= read -r question; do
    id=${question#*'"id":"'}
    id=${id%%'"'*}
    if [ -f "$0/$id.sh" ]; then . "$0/$id.sh"; else cat "$0/$id"; fi
done"#;

/// Answers by id, ready to be changed.
type Answers = BTreeMap<String, Value>;

fn lines(part: &str) -> Vec<Value> {
    let text = fs::read_to_string(format!("{CORPUS}/{part}/small.jsonl")).unwrap();
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

fn certified() -> Answers {
    let lines = lines("answers").into_iter();
    lines
        .map(|line| {
            (
                line["id"].as_str().unwrap().to_owned(),
                line["answer"].clone(),
            )
        })
        .collect()
}

/// The certified answers as a program in double precision would write them.
fn in_floats() -> Answers {
    let mut answers = certified();
    answers.values_mut().for_each(round);
    answers
}

fn round(value: &mut Value) {
    let number = value.as_object().and_then(|fields| {
        let text = fields.get("exact").or_else(|| fields.get("value"))?;
        text.as_str()
    });
    if let Some(text) = number {
        let float = burmester::number::text::parse_rational(text)
            .unwrap()
            .to_f64();
        *value = json!(float);
        return;
    }
    match value {
        Value::Array(members) => members.iter_mut().for_each(round),
        Value::Object(fields) => fields.values_mut().for_each(round),
        _ => {}
    }
}

/// A folder of this test's own with these answers.
fn folder(name: &str, answers: &Answers) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("score-{name}"));
    let _ = fs::remove_dir_all(&folder);
    for (id, answer) in answers {
        let file = folder.join(id);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, format!("{}\n", json!({"result": answer}))).unwrap();
    }
    folder
}

fn misbehaving(name: &str, id: &str, script: &str) -> PathBuf {
    let folder = folder(name, &in_floats());
    fs::write(folder.join(format!("{id}.sh")), script).unwrap();
    folder
}

fn score(options: &[&str], command: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_burmester"))
        .args(["score", "--problems", CORPUS])
        .args(options)
        .arg("--")
        .args(command)
        .output()
        .unwrap()
}

/// The status and the JSON report.
fn scored_with(options: &[&str], folder: &Path) -> (i32, Value) {
    let folder = folder.display().to_string();
    let options = [&["--format", "json"], options].concat();
    let output = score(&options, &["sh", "-c", CANDIDATE, &folder]);
    let text = String::from_utf8(output.stdout).unwrap();
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(errors.is_empty(), "{errors}");
    let report: Value = serde_json::from_str(&text).unwrap();
    let schema = fs::read_to_string("data/schema/score.json").unwrap();
    let schema: Value = serde_json::from_str(&schema).unwrap();
    let validator = jsonschema::validator_for(&schema).unwrap();
    let plain: Value = serde_json::from_str(&text).unwrap();
    let faults: Vec<String> = validator
        .iter_errors(&plain)
        .map(|fault| fault.to_string())
        .collect();
    assert!(faults.is_empty(), "{faults:?}");
    (output.status.code().unwrap(), report)
}

fn scored(folder: &Path) -> (i32, Value) {
    scored_with(&[], folder)
}

fn counts(report: &Value) -> [u64; 4] {
    ["missed", "invented", "lost", "skipped"].map(|name| report["total"][name].as_u64().unwrap())
}

fn outcome<'a>(report: &'a Value, id: &str) -> &'a Value {
    let problems = report["problems"].as_array().unwrap();
    problems.iter().find(|problem| problem["id"] == id).unwrap()
}

/// One problem is lost for this reason, and no other.
fn assert_lost(name: &str, options: &[&str], script: &str, reason: &str) {
    let id = "small/random-1";
    let (status, report) = scored_with(options, &misbehaving(name, id, script));
    assert_eq!(counts(&report), [0, 0, 1, 0], "{name}: {report}");
    assert_eq!(status, 1, "{name}");
    let problem = outcome(&report, id);
    assert_eq!(problem["outcome"], "lost", "{name}");
    let said = problem["reason"].as_str().unwrap();
    assert!(said.contains(reason), "{name}: {said}");
}

#[test]
fn right_answers() {
    let all = lines("problems").len();
    for (name, answers, least) in [
        ("floats", in_floats(), 14.5),
        ("certified", certified(), 48.0),
    ] {
        let (status, report) = scored(&folder(name, &answers));
        assert_eq!(counts(&report), [0, 0, 0, 0], "{name}: {report}");
        assert_eq!(status, 0);
        let total = &report["total"];
        assert_eq!(total["answered"], json!(all));
        assert_eq!(total["facts"]["wrong"], json!(0));
        assert_eq!(
            total["degenerate"]["cases"], total["degenerate"]["right"],
            "{report}"
        );
        assert!(total["degenerate"]["cases"].as_u64() > Some(8));
        assert!(total["digits"]["worst"].as_f64() > Some(least), "{total}");
        assert_eq!(report["worst"], json!([]));
    }
}

#[test]
fn the_solver_itself() {
    let command = r#""$0" solve --lines | while IFS= read -r answer; do printf '{"result":%s}\n' "$answer"; done"#;
    let output = score(&[], &["sh", "-c", command, env!("CARGO_BIN_EXE_burmester")]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{text}");
    for part in [
        "kind",
        "found",
        "invented",
        "degenerate",
        "isotropic pair",
        "correct digits",
    ] {
        assert!(text.contains(part), "`{part}` is not in {text}");
    }
}

#[test]
fn a_missing_pair_and_an_invented_one() {
    let mut answers = in_floats();
    let pairs = answers.get_mut("small/random-1").unwrap()["pairs"]
        .as_array_mut()
        .unwrap();
    pairs.remove(2);
    let (status, report) = scored(&folder("missing", &answers));
    assert_eq!(counts(&report), [1, 0, 0, 0]);
    assert_eq!(status, 1);
    assert_eq!(report["worst"][0]["id"], "small/random-1");
    let rerun = report["worst"][0]["rerun"].as_str().unwrap();
    assert!(
        rerun.starts_with(
            "burmester score --problems tests/data/score --only small/random-1 -- sh -c '"
        ),
        "{rerun}"
    );

    let mut answers = in_floats();
    let pairs = answers.get_mut("small/random-1").unwrap()["pairs"]
        .as_array_mut()
        .unwrap();
    pairs.insert(0, json!({"circlepoint": [1, 2], "center": ["1/3", -4]}));
    let (status, report) = scored(&folder("invented", &answers));
    assert_eq!(counts(&report), [0, 1, 0, 0]);
    assert_eq!(status, 1);

    // Nothing said of pairs misses them all; of other things it is not scored.
    let mut answers = in_floats();
    let answer = answers.get_mut("small/random-1").unwrap();
    *answer = json!({"counts": {"real": 4.0}});
    answers
        .get_mut("small/random-0")
        .unwrap()
        .as_object_mut()
        .unwrap()
        .remove("complex_pairs");
    let (_, report) = scored(&folder("silent", &answers));
    assert_eq!(counts(&report), [4, 0, 0, 0]);
}

#[test]
fn close_is_a_matter_of_the_condition() {
    for (shift, missed) in [(1.0 + 1e-7, 0), (1.0 + 1e-5, 1)] {
        let mut answers = in_floats();
        let pair = &mut answers.get_mut("small/random-1").unwrap()["pairs"][0];
        let point = pair["center"].as_array_mut().unwrap();
        for coordinate in point {
            *coordinate = json!(coordinate.as_f64().unwrap() * shift);
        }
        let (_, report) = scored(&folder(&format!("near-{missed}"), &answers));
        assert_eq!(counts(&report), [missed, missed, 0, 0], "{shift}");
    }
    let answer = json!({"pairs": [{"circlepoint": [{"exact": "1"}, {"exact": "0"}], "center": [{"exact": "2"}, {"exact": "2"}]}]});
    let given = json!({"pairs": [{"circlepoint": [1.001, 0.001], "center": [2, 2]}]});
    for (condition, mark) in [
        (json!(null), Mark::Missed),
        (json!({"value": "1e9", "radius": "1e3"}), Mark::Missed),
        (json!({"exact": "100000000000"}), Mark::Found),
    ] {
        let reference = Reference::read("five-positions", &answer, &condition).unwrap();
        let verdict = reference.judge(&json!({}), &given).unwrap();
        assert_eq!(verdict.count(mark), 1, "{condition}: {:?}", verdict.lines);
    }
}

/// Where m pairs fall into one, what is off by a rounding parts them by its m-th root.
#[test]
fn multiple_pairs_may_be_torn_apart() {
    for (times, shift, marks) in [
        (1, 1e-5, [0, 0, 1, 1]),
        (3, 1e-5, [1, 1, 0, 0]),
        (3, 1e-3, [0, 0, 1, 2]),
        (4, 1e-4, [1, 1, 0, 0]),
    ] {
        let pair = |x: f64| json!({"circlepoint": [x, 1], "center": [2, 2]});
        let mut certified = pair(1.0);
        certified["multiplicity"] = json!(times);
        let answer = json!({"pairs": [certified]});
        let reference = Reference::read("five-positions", &answer, &Value::Null).unwrap();
        let given = match times {
            1 => json!({"pairs": [pair(1.0 + shift)]}),
            _ => json!({"pairs": [pair(1.0 + shift), pair(1.0 - shift)]}),
        };
        let verdict = reference.judge(&json!({}), &given).unwrap();
        let counted = [Mark::Found, Mark::OfFamily, Mark::Missed, Mark::Invented]
            .map(|mark| verdict.count(mark));
        assert_eq!(counted, marks, "{times}, {shift}");
    }
}

/// A parallelogram in one position, and a turn about a point whose positions have all come together.
#[test]
fn pairs_of_families_of_positions_that_came_together_are_not_invented() {
    let crank = |x: i64| json!({"circlepoint": [x, 2], "center": [x - 1, 0]});
    let parallelogram = json!({"problem": "curvature", "links": [crank(1), crank(6)]});
    let derivatives = [1, 0, 0, 0].map(|angle| json!({"x": 0, "y": 0, "angle": angle}));
    let turn = json!({
        "problem": "mixed-positions",
        "positions": [{"x": 0, "y": 0, "angle": {"degrees": 0}, "derivatives": derivatives}],
    });
    for (problem, circlepoint, center) in [
        (parallelogram, [4.0, -3.0], [3.0, -5.0]),
        (turn, [3.0, 4.0], [0.0, 0.0]),
    ] {
        let kind = problem["problem"].as_str().unwrap();
        let answer = json!({"pairs": [], "family": {"kind": "plane"}});
        let reference = Reference::read(kind, &answer, &Value::Null).unwrap();
        let [x, y] = center;
        for (center, mark) in [([x, y], Mark::OfFamily), ([x, y + 1e-3], Mark::Invented)] {
            let given = json!({"pairs": [{"circlepoint": circlepoint, "center": center}]});
            let verdict = reference.judge(&problem, &given).unwrap();
            assert_eq!(verdict.count(mark), 1, "{kind}: {center:?}");
        }
    }
}

/// Of turns about one point this point of the moving plane rests there, but for roundings.
#[test]
fn a_resting_point_is_of_the_family() {
    let turns = [
        ["1", "0"],
        ["3/5", "4/5"],
        ["0", "1"],
        ["-1", "0"],
        ["4/5", "-3/5"],
    ];
    let places = [
        ["-1", "-2"],
        ["1", "-2"],
        ["2", "-1"],
        ["1", "2"],
        ["-2", "-1"],
    ];
    let positions = turns
        .iter()
        .zip(places)
        .map(|([cos, sin], [x, y])| json!({"x": x, "y": y, "angle": {"cos": cos, "sin": sin}}));
    let problem = json!({"problem": "five-positions", "positions": positions.collect::<Vec<_>>()});
    let answer = json!({"pairs": [], "family": {"kind": "plane"}});
    let reference = Reference::read("five-positions", &answer, &Value::Null).unwrap();
    for (circlepoint, center, mark) in [
        (
            [1.000_000_000_000_000_4, 2.0],
            [7e-18, -2e-18],
            Mark::OfFamily,
        ),
        ([1.0, 2.0], [3.0, 4.0], Mark::OfFamily),
        ([5.0, 3.0], [1e-9, 0.0], Mark::OfFamily),
        ([5.0, 3.0], [1e-3, 0.0], Mark::Invented),
        ([1.001, 2.0], [3.0, 4.0], Mark::Invented),
    ] {
        let given = json!({"pairs": [{"circlepoint": circlepoint, "center": center}]});
        let verdict = reference.judge(&problem, &given).unwrap();
        assert_eq!(
            verdict.count(mark),
            1,
            "{circlepoint:?} {:?}",
            verdict.lines
        );
    }
}

/// Right lengths stay right beside a wrong word.
#[test]
fn a_wrong_word_about_a_right_mechanism() {
    let answer = json!({"mechanisms": [{"lambda": "2", "m": "3", "crank": "change-point"}]});
    let reference = Reference::read("focal-mechanism", &answer, &Value::Null).unwrap();
    for (given, found, right, wrong) in [
        (json!({"lambda": 2, "m": 3, "crank": "turns"}), 1, 0, 1),
        (
            json!({"lambda": 2, "m": 3, "crank": "change-point"}),
            1,
            1,
            0,
        ),
        (json!({"lambda": 2, "m": 3}), 1, 0, 0),
        (
            json!({"lambda": 2, "m": 4, "crank": "change-point"}),
            0,
            0,
            0,
        ),
        (json!({"crank": "change-point"}), 0, 0, 0),
    ] {
        let verdict = reference
            .judge(&json!({}), &json!({"mechanisms": [given]}))
            .unwrap();
        let counted = [Mark::Found, Mark::Right, Mark::Wrong].map(|mark| verdict.count(mark));
        assert_eq!(counted, [found, right, wrong], "{given}");
    }
}

#[test]
fn order_factors_and_repetitions_do_not_matter() {
    let mut answers = in_floats();
    for answer in answers.values_mut() {
        for name in ["pairs", "complex_pairs", "at_infinity"] {
            if answer["problem"] != "three-positions"
                && let Some(list) = answer[name].as_array_mut()
            {
                list.reverse();
            }
        }
        if let Some(list) = answer["at_infinity"].as_array_mut() {
            for pair in list {
                if let Some(direction) = pair["direction"].as_array_mut() {
                    for part in direction {
                        *part = json!(part.as_f64().unwrap() * -0.1);
                    }
                }
            }
        }
    }
    // A double pair, torn apart as floats do.
    let pairs = answers.get_mut("small/double").unwrap()["pairs"]
        .as_array_mut()
        .unwrap();
    let mut other = pairs
        .iter()
        .find(|pair| pair["multiplicity"] == 2)
        .unwrap()
        .clone();
    let x = other["circlepoint"][0].as_f64().unwrap();
    other["circlepoint"][0] = json!(x + 1e-9);
    pairs.push(other);
    let (status, report) = scored(&folder("order", &answers));
    assert_eq!(counts(&report), [0, 0, 0, 0], "{report}");
    assert_eq!(status, 0);
    assert_eq!(report["total"]["of_family"], json!(1));
}

/// A pole at infinity is none at the origin, and a wrong word is no solution.
#[test]
fn degenerate_parts_and_facts() {
    let mut answers = in_floats();
    answers.get_mut("small/poles").unwrap()["poles"]["13"] = json!([0, 0]);
    answers.get_mut("small/two-equal").unwrap()["family"] = Value::Null;
    answers.get_mut("small/curve-generic").unwrap()["centerpoint"]["type"] = json!("nodal");
    let (status, report) = scored(&folder("facts", &answers));
    assert_eq!(counts(&report), [1, 1, 0, 0], "{report}");
    assert_eq!(status, 1);
    assert_eq!(report["total"]["facts"]["wrong"], json!(2));
    let degenerate = &report["total"]["degenerate"];
    let [cases, right] = ["cases", "right"].map(|name| degenerate[name].as_u64().unwrap());
    assert_eq!(cases, right + 2);
}

#[test]
fn a_pair_of_a_family_is_not_invented() {
    let mut answers = in_floats();
    // Of three positions every point has a center: (1, 0) comes to (1, 0), (3.6, 1.8), (5.8, -0.4).
    let [(a, b), (c, d), (e, f)] = [(1.0_f64, 0.0_f64), (3.6, 1.8), (5.8, -0.4)];
    let twice = 2.0 * (a * (d - f) + c * (f - b) + e * (b - d));
    let [p, q, r] = [a * a + b * b, c * c + d * d, e * e + f * f];
    let x = (p * (d - f) + q * (f - b) + r * (b - d)) / twice;
    let y = (p * (e - c) + q * (a - e) + r * (c - a)) / twice;
    answers.get_mut("small/three-equal").unwrap()["pairs"] = json!([
        {"circlepoint": [1, 0], "center": [x, y]},
        {"circlepoint": [1, 0], "center": [x, y + 0.01]},
    ]);
    let (_, report) = scored(&folder("family", &answers));
    assert_eq!(counts(&report), [0, 1, 0, 0]);
    assert_eq!(report["total"]["of_family"], json!(1));
}

#[test]
fn who_misbehaves_loses_one_problem() {
    assert_lost("hang", &["--time-limit", "0.5"], "sleep 60", "within 0.5 s");
    assert_lost(
        "crash",
        &[],
        "echo out of ideas >&2; exit 3",
        "out of ideas",
    );
    assert_lost("closed", &[], "exec 1>&-; sleep 60", "closed");
    assert_lost("rubbish", &[], "echo Hello, here are the pairs:", "Hello");
    assert_lost(
        "nan",
        &[],
        r#"echo '{"result": {"pairs": [{"circlepoint": [NaN, 1]}]}}'"#,
        "no JSON",
    );
    assert_lost(
        "type",
        &[],
        r#"echo '{"result": {"pairs": [{"circlepoint": [null, 1]}]}}'"#,
        "pairs[0].circlepoint",
    );
    assert_lost("empty", &[], "echo '{}'", "neither result");
    assert_lost(
        "list",
        &[],
        r#"echo '{"result": []}'"#,
        "an object was expected",
    );
    assert_lost(
        "deep",
        &[],
        "printf '%100000s' | tr ' ' '['; echo",
        "no JSON",
    );
    assert_lost("huge", &[], "printf '%5000000s\\n' x", "longer than");
    assert_lost(
        "digits",
        &[],
        r#"printf '{"result": {"pairs": [{"center": [1e999999999, 1]}]}}\n'"#,
        "exponent",
    );
    assert_lost("binary", &[], r"printf '\377\376\n'", "UTF-8");
    assert_lost(
        "error",
        &[],
        r#"echo '{"error": "singular matrix"}'"#,
        "singular matrix",
    );
    assert_lost(
        "stranger",
        &[],
        r#"echo '{"id": "small/other", "result": {"pairs": []}}'"#,
        "small/other",
    );
}

#[test]
fn who_declines_loses_nothing() {
    for (name, line) in [
        ("skip", r#"{"skipped": "four pairs are too many"}"#),
        ("nothing", r#"{"result": {"remark": 1}}"#),
    ] {
        let id = "small/poles";
        let (status, report) = scored(&misbehaving(name, id, &format!("echo '{line}'")));
        assert_eq!(counts(&report), [0, 0, 0, 1], "{report}");
        assert_eq!(status, 0);
        assert_eq!(outcome(&report, id)["outcome"], "skipped");
    }
}

/// One line on standard error, status 2.
fn assert_refused(output: &Output, expected: &str) {
    let message = String::from_utf8(output.stderr.clone()).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
    assert!(message.contains(expected), "{message}");
    assert!(output.stdout.is_empty());
}

#[test]
fn wrong_calls() {
    assert_refused(&score(&[], &["/no/such/program"]), "cannot be started");
    assert_refused(
        &score(&[], &["sh", "-c", "no-such-program-either"]),
        "no-such-program",
    );
    assert_refused(&score(&["--only", "nobody"], &["true"]), "nobody");
    let call = |problems: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_burmester"));
        command
            .args(["score", "--problems", problems, "--", "true"])
            .output()
            .unwrap()
    };
    assert_refused(&call("tests/data"), "tests/data/problems");
    let broken = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("score-broken");
    for part in ["problems", "answers"] {
        fs::create_dir_all(broken.join(part)).unwrap();
        fs::write(broken.join(part).join("x.jsonl"), "{\"id\": \"a\"}\n").unwrap();
    }
    assert_refused(&call(&broken.display().to_string()), "x.jsonl:1: problem");
    for arguments in [
        &["score"][..],
        &["score", "--time-limit", "0", "--", "true"],
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_burmester"))
            .args(arguments)
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(2));
    }
}

/// A missing module, say: no start is ever answered, and the whole corpus need not be waited for.
#[test]
fn who_never_says_a_word_is_refused() {
    let never = |options: &[&str], script: &str, expected: &str| {
        let output = score(options, &["sh", "-c", script]);
        assert_refused(&output, "started 3 times, it never wrote a line");
        assert_refused(&output, expected);
    };
    never(
        &[],
        "echo Traceback >&2; echo no module named linkages >&2; exit 3",
        "it stopped (exit status: 3): no module named linkages",
    );
    never(
        &["--time-limit", "0.2"],
        "sleep 60",
        "no answer within 0.2 s",
    );
    never(
        &["--time-limit", "0.2"],
        "cat > /dev/null; echo '{}'",
        "is every line flushed?",
    );
}

/// Two problems lost before the first answer are two problems lost.
#[test]
fn who_answers_late_is_scored() {
    let late = folder("late", &in_floats());
    for line in &lines("problems")[..2] {
        let id = line["id"].as_str().unwrap();
        fs::write(late.join(format!("{id}.sh")), "exit 1").unwrap();
    }
    let (status, report) = scored(&late);
    assert_eq!(counts(&report), [0, 0, 2, 0], "{report}");
    assert_eq!(status, 1);
}

#[test]
fn a_problem_alone_is_shown_side_by_side() {
    let folder = folder("alone", &in_floats()).display().to_string();
    let output = score(
        &["--only", "small/slider"],
        &["sh", "-c", CANDIDATE, &folder],
    );
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{text}");
    for part in [
        "certified",
        "given",
        "at_infinity: found",
        "direction",
        "digits",
        "counts.real: right",
    ] {
        assert!(text.contains(part), "`{part}` is not in {text}");
    }
    // What is said about a problem does not go to the candidate.
    assert!(!text.contains("claims"), "{text}");
}

/// A pair that is a little off stands beside the one that is meant, and before what is right.
#[test]
fn what_is_wrong_is_shown_first() {
    let mut answers = in_floats();
    let pair = &mut answers.get_mut("small/random-1").unwrap()["pairs"][1];
    for coordinate in pair["center"].as_array_mut().unwrap() {
        *coordinate = json!(coordinate.as_f64().unwrap() * 1.00001);
    }
    let folder = folder("off", &answers).display().to_string();
    let command = ["sh", "-c", CANDIDATE, &folder];
    let output = score(&["--only", "small/random-1"], &command);
    let text = String::from_utf8(output.stdout).unwrap();
    let [missed, invented, found] = [
        "pairs: missed",
        "pairs: invented, 5.0 digits of the nearest certified",
        "pairs: found",
    ]
    .map(|part| text.find(part).unwrap());
    assert!(missed < invented && invented < found, "{text}");
}

/// What fails in the same way stands there once.
#[test]
fn failures_are_listed_by_sort() {
    let silent = "while read -r question; do echo '{\"error\": \"singular matrix\"}'; done";
    let output = score(&[], &["sh", "-c", silent]);
    let text = String::from_utf8(output.stdout).unwrap();
    let (_, listed) = text.split_once("Not right").unwrap();
    let more = lines("problems").len() - 1;
    assert!(
        listed.contains(&format!("singular matrix (and {more} more like it)")),
        "{text}"
    );
    assert_eq!(listed.matches("--only").count(), 1, "{text}");
}

/// Tags that open and close in turn, and attributes in quotes.
fn assert_well_formed(xml: &str) {
    let mut open: Vec<&str> = Vec::new();
    let body = xml
        .strip_prefix("<?xml version=\"1.0\" encoding=\"UTF-8\"?>")
        .unwrap();
    for piece in body.split('<').skip(1) {
        let (tag, text) = piece.split_once('>').unwrap();
        assert!(!text.contains(['"', '>']), "{text}");
        assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name));
        } else if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap());
        }
    }
    assert!(open.is_empty(), "{open:?}");
}

#[test]
fn junit() {
    let mut answers = in_floats();
    answers.get_mut("small/random-0").unwrap()["pairs"] = json!([]);
    let folder = folder("junit", &answers);
    fs::write(
        folder.join("small/random-1.sh"),
        r#"echo '{"skipped": "<&\"> no"}'"#,
    )
    .unwrap();
    fs::write(
        folder.join("small/random-2.sh"),
        r#"echo '<rubbish & "more">'"#,
    )
    .unwrap();
    let file = folder.join("report.xml");
    let file = file.display().to_string();
    let folder = folder.display().to_string();
    let output = score(&["--junit", &file], &["sh", "-c", CANDIDATE, &folder]);
    assert_eq!(output.status.code(), Some(1));
    let text = fs::read_to_string(file).unwrap();
    assert_well_formed(&text);
    let all = lines("problems").len();
    assert_eq!(text.matches("<testcase ").count(), all);
    assert!(
        text.contains(&format!(
            r#"tests="{all}" failures="1" errors="1" skipped="1""#
        )),
        "{text}"
    );
    assert!(text.contains("2 missed"), "{text}");
}
