//! Every data file, and everything that the program prints for other programs, has its schema.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot read what it tests has failed"
)]

use std::fs;
use std::path::Path;
use std::process::Command;

use jsonschema::{Resource, Validator};
use serde_json::{Value, json};

fn schema(name: &str) -> Value {
    let path = Path::new("data/schema").join(format!("{name}.json"));
    serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap()
}

fn validator(name: &str) -> Validator {
    jsonschema::options()
        .with_resource(
            "burmester:number",
            Resource::from_contents(schema("number")).unwrap(),
        )
        .build(&schema(name))
        .unwrap()
}

fn assert_valid(validator: &Validator, value: &Value, what: &str) {
    let errors: Vec<String> = validator
        .iter_errors(value)
        .map(|error| format!("{}: {error}", error.instance_path))
        .collect();
    assert!(errors.is_empty(), "{what}: {}", errors.join("; "));
}

/// Everything through plain JSON, as another program would read it.
fn plain(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn burmester(arguments: &[&str], input: &Value) -> Value {
    use std::io::Write;
    let mut child = Command::new(env!("CARGO_BIN_EXE_burmester"))
        .args(arguments)
        .stdin(std::process::Stdio::piped())
        .stdout(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    stdin.write_all(input.to_string().as_bytes()).unwrap();
    drop(stdin);
    plain(&String::from_utf8(child.wait_with_output().unwrap().stdout).unwrap())
}

#[test]
fn papers() {
    let validator = validator("paper");
    for entry in fs::read_dir("data/papers").unwrap() {
        let path = entry.unwrap().path();
        let paper: toml::Value = toml::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        let paper = plain(&serde_json::to_string(&paper).unwrap());
        assert_valid(&validator, &paper, &path.display().to_string());
    }
}

#[test]
fn lines_of_verify() {
    let validator = validator("verdict");
    let output = Command::new(env!("CARGO_BIN_EXE_burmester"))
        .args(["verify", "--format", "json"])
        .output()
        .unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.lines().count() > 0, "no line at all");
    for line in text.lines() {
        assert_valid(&validator, &plain(line), line);
    }
}

#[test]
fn slider_crank_alternates() {
    let problems = validator("slider-crank-alternates.problem");
    let answers = validator("slider-crank-alternates.answer");
    let degrees = |text: &str| json!({"degrees": text});
    for (k, alpha_a, alpha_d) in [
        (json!("0.9"), degrees("72.5"), degrees("45")),
        (json!(0.9), degrees("72.5"), degrees("45")),
        (json!("-1"), degrees("60"), degrees("45")),
        (json!("-3"), degrees("60"), degrees("90")),
        (json!("-4"), degrees("60"), degrees("90")),
        (json!("2"), degrees("90"), degrees("30")),
        (json!("1"), degrees("50"), degrees("50")),
        (
            json!("-1/2"),
            json!({"tan_half": "1/3"}),
            json!({"cos": "5/13", "sin": "12/13"}),
        ),
        (
            json!("3"),
            json!({"radians": "1.2"}),
            json!({"radians": "2.5"}),
        ),
    ] {
        let problem = json!({
            "problem": "slider-crank-alternates", "k": k, "alpha_a": alpha_a, "alpha_d": alpha_d,
        });
        let problem = plain(&problem.to_string());
        assert_valid(&problems, &problem, "problem");
        let answer = burmester(&["solve", "--format", "json"], &problem);
        assert_valid(&answers, &answer, &format!("answer to {problem}"));
    }
}

/// Problem and answer of a kind against their schemas.
fn answered(kind: &str, problem: Value) -> Value {
    let problem = plain(&problem.to_string());
    assert_valid(&validator(&format!("{kind}.problem")), &problem, "problem");
    let answer = burmester(&["solve", "--format", "json"], &problem);
    let what = format!("answer to {problem}");
    assert_valid(&validator(&format!("{kind}.answer")), &answer, &what);
    answer
}

#[test]
fn focal_mechanisms() {
    for (sides, rho, count) in [
        (["5", "5", "2", "4"], "1", 2),
        (["6", "5", "2", "4"], "-1/2", 2),
        (["1", "1", "5", "6"], "1", 0),
        // E = (c + d)²: both mechanisms coincide.
        (["3", "3", "2", "4"], "1", 1),
        (["290", "145", "5", "410"], "4", 2),
        (["5e30", "5e30", "2e30", "4e30"], "1", 2),
    ] {
        let [a, b, c, d] = sides;
        let answer = answered(
            "focal-mechanism",
            json!({"problem": "focal-mechanism", "a": a, "b": b, "c": c, "d": d, "rho": rho}),
        );
        assert_eq!(answer["count"], json!(count), "{sides:?}, {rho}: {answer}");
        assert!(answer.get("undecided").is_none(), "{answer}");
    }
}

#[test]
fn hart() {
    let answer = answered(
        "hart",
        json!({"problem": "hart", "m": "4", "n": "8", "d": "6", "kappa": "1/2"}),
    );
    for (name, value) in [
        ("p", "4"),
        ("q", "-2"),
        ("a", "3"),
        ("b", "6"),
        ("c", "3"),
        ("x", "0"),
    ] {
        assert_eq!(answer[name], json!({"exact": value}), "{name}");
    }
    answered(
        "hart",
        json!({"problem": "hart", "m": "5", "n": "7", "d": "6", "kappa": "-3"}),
    );
}
