//! Every data file, and everything that the program prints for other programs, has its schema.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot read what it tests has failed"
)]

use std::fs;
use std::process::Command;

use crate::support::schemas::{assert_valid, validator};
use serde_json::{Value, json};

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
fn straight_line_designs() {
    let alpha_a = json!({"degrees": "72.5"});
    for design in [
        json!({"kind": "ball-burmester", "alpha_a": alpha_a, "alpha_b": {"tan_half": "2"},
            "alpha_d": {"degrees": "45"}, "alternate": "2,3"}),
        json!({"kind": "ball-double-burmester", "alpha_a": {"degrees": "65"}, "alpha_b": {"degrees": "165"}}),
        json!({"kind": "inflection-pole", "k": "-4", "alpha_a": alpha_a}),
        json!({"kind": "equal-cranks", "k": "-2.5"}),
        json!({"kind": "equal-cranks", "k": "1"}),
        json!({"kind": "slider-crank", "k": "0.9", "alpha_a": alpha_a, "alpha_d": {"degrees": "45"}, "s": ["0.1", "9"]}),
        json!({"kind": "slider-crank", "k": "1", "alpha_a": {"degrees": "50"}, "alpha_d": {"degrees": "50"}}),
        json!({"kind": "ball-intersection", "k": "0.9", "alpha_a": alpha_a, "alpha_d": {"degrees": "45"}, "s": "0.1"}),
        json!({"kind": "ball-intersection", "k": "0.9", "alpha_a": alpha_a, "alpha_d": {"degrees": "45"}, "s": "9"}),
        json!({"kind": "ball-tangent", "k": "0.9", "alpha_a": alpha_a, "s": "0.5", "alpha_d": {"from": "20", "to": "30"}}),
        json!({"kind": "ball-tangent", "k": "0.9", "alpha_a": alpha_a, "s": "9"}),
        json!({"kind": "symmetrical", "k": "0.9", "alpha_a": alpha_a, "epsilon": {"degrees": "50"}}),
        json!({"kind": "symmetrical", "k": "0.9", "alpha_a": alpha_a, "epsilon": {"degrees": "0"}}),
        json!({"kind": "two-inflections", "k": "0.9", "alpha_a": alpha_a}),
        json!({"kind": "watt", "R": "1", "T": "2", "gamma": {"degrees": "40"}, "n": "1", "k": "0"}),
        json!({"kind": "watt", "R": "1", "T": "2", "gamma": {"degrees": "0"}, "n": -1, "k": "0"}),
        json!({"kind": "evans", "alpha": {"degrees": "90"}, "beta": {"degrees": "0"}, "omega": {"degrees": "20"},
            "rho": "0.2", "k": "9"}),
        json!({"kind": "conchoid", "r": "0.4", "alpha": {"degrees": "20"}, "k": "5", "n": "-1"}),
        json!({"kind": "symmetric", "a": "-2", "c": "0", "d": "4"}),
        json!({"kind": "four-bar", "Q": "4", "R": "5", "S": "2", "T": "5", "M": "1",
            "epsilon": {"degrees": "0"}, "phi0": {"cos": "3/5", "sin": "4/5"}, "assembly": "right"}),
    ] {
        answered(
            "straight-line",
            json!({"problem": "straight-line", "design": design}),
        );
    }
}

#[test]
fn deviations() {
    let levels = json!(["0.01", "0.05"]);
    for design in [
        json!({"kind": "ball-double-burmester", "alpha_a": {"degrees": "65"}, "alpha_b": {"degrees": "165"}}),
        json!({"kind": "inflection-pole", "k": "-4", "alpha_a": {"degrees": "40"}, "alternate": "2,3"}),
        json!({"kind": "four-bar", "Q": "4", "R": "5", "S": "2", "T": "5", "M": "1",
            "epsilon": {"degrees": "0"}, "phi0": {"cos": "3/5", "sin": "4/5"}}),
    ] {
        answered(
            "deviation",
            json!({"problem": "deviation", "design": design, "levels": levels}),
        );
    }
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
fn four_bars() {
    let joints = |a: [&str; 2], b: [&str; 2], o_b: [&str; 2], d: [&str; 2]| json!({"problem": "four-bar", "O_a": ["0", "0"], "A": a, "B": b, "O_b": o_b, "D": d});
    let bars = |lengths: [&str; 5], epsilon: Value| {
        let [q, r, s, t, m] = lengths;
        json!({"problem": "four-bar", "Q": q, "R": r, "S": s, "T": t, "M": m, "epsilon": epsilon})
    };
    let mut placed = bars(["4", "2", "3", "3", "2.5"], degrees("40"));
    placed["phi0"] = degrees("72.5");
    placed["assembly"] = json!("right");
    for problem in [
        joints(["1", "2"], ["6", "5"], ["7", "1"], ["2", "8"]),
        // Parallel cranks, D on AB.
        joints(["0", "2"], ["4", "2"], ["4", "0"], ["1", "2"]),
        // D in A.
        joints(["1", "2"], ["6", "5"], ["7", "1"], ["1", "2"]),
        bars(["4", "2", "5", "5", "5"], degrees("0")),
        bars(["4", "2", "3", "3", "2.5"], degrees("60")),
        bars(
            ["2", "2", "2", "2", "1"],
            json!({"cos": "3/5", "sin": "-4/5"}),
        ),
        bars(["2", "3", "4", "5", "0"], json!({"radians": "1"})),
        placed,
    ] {
        let answer = answered("four-bar", problem);
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

/// Positions by x, y and their angles.
fn positions(list: &[(&str, &str, Value)]) -> Value {
    let position = |(x, y, angle): &(&str, &str, Value)| json!({"x": x, "y": y, "angle": angle});
    list.iter().map(position).collect()
}

fn degrees(text: &str) -> Value {
    json!({"degrees": text})
}

#[test]
fn poles() {
    let answer = answered(
        "poles",
        json!({"problem": "poles", "positions": positions(&[
            ("0", "0", degrees("0")),
            ("2", "0", degrees("90")),
            ("4", "6", degrees("0")),
            ("4", "6", degrees("360")),
            ("1", "1", json!({"radians": "0.3"})),
        ])}),
    );
    assert_eq!(
        answer["poles"]["12"],
        json!([{"exact": "1"}, {"exact": "1"}])
    );
    // The pole of a translation lies across it.
    let across = json!({"at_infinity": [{"exact": "3"}, {"exact": "-2"}]});
    assert_eq!(answer["poles"]["13"], across);
    assert_eq!(answer["poles"]["34"], json!({"undetermined": true}));
    assert_eq!(answer["turns"]["12"], json!({"degrees": {"exact": "90"}}));
    let by_points = answered(
        "poles",
        json!({"problem": "poles", "positions": [
            {"points": [["0", "0"], ["1", "0"]]}, {"points": [["3", "0"], ["3", "1"]]},
        ]}),
    );
    assert_eq!(
        by_points["poles"]["12"],
        json!([{"exact": "3/2"}, {"exact": "3/2"}])
    );
    let fitted = answered(
        "poles",
        json!({"problem": "poles", "positions": [
            {"points": [["0", "0"], ["1", "0"]], "fit": true},
            {"points": [["3", "0"], ["3", "1.01"]]},
        ]}),
    );
    assert_eq!(
        fitted["fitted_angles"][1],
        json!({"degrees": {"exact": "90"}})
    );
}

#[test]
fn three_positions() {
    let answer = answered(
        "three-positions",
        json!({
            "problem": "three-positions",
            "positions": positions(&[
                ("0", "0", degrees("0")),
                ("2", "0", degrees("90")),
                ("4", "6", degrees("17.5")),
            ]),
            "circlepoints": [["1", "1"], [0.25, "-7/3"]],
            "centers": [["3", "1"]],
        }),
    );
    assert_eq!(answer["pairs"].as_array().unwrap().len(), 3);
    assert!(answer.get("undecided").is_none(), "{answer}");
    // A point that moves along a line, exactly: translations.
    let answer = answered(
        "three-positions",
        json!({
            "problem": "three-positions",
            "positions": positions(&[
                ("0", "0", degrees("72.5")), ("2", "0", degrees("72.5")), ("5", "0", degrees("72.5")),
            ]),
            "circlepoints": [["0", "0"]],
        }),
    );
    let upwards = json!({"at_infinity": [{"exact": "0"}, {"exact": "1"}]});
    assert_eq!(answer["pairs"][0]["center"], upwards);
}

#[test]
fn centerpoint_curves() {
    let tan_half = |text: &str| json!({"tan_half": text});
    for (list, expected) in [
        (
            [
                ("0", "0", degrees("0")),
                ("3", "1", tan_half("1/2")),
                ("5", "-1", json!({"cos": "3/5", "sin": "-4/5"})),
                ("2", "4", tan_half("-3")),
            ],
            json!("two-branches"),
        ),
        (
            [
                ("0", "0", degrees("0")),
                ("3", "1", degrees("45")),
                ("5", "-1", json!({"cos": "3/5", "sin": "-4/5"})),
                ("2", "4", degrees("77.7")),
            ],
            json!("one-branch"),
        ),
        (
            [
                ("0", "0", degrees("0")),
                ("2", "2", degrees("180")),
                ("6", "4", degrees("0")),
                ("1", "7", degrees("180")),
            ],
            json!("hyperbola"),
        ),
        (
            [
                ("0", "0", degrees("72.5")),
                ("2", "2", degrees("72.5")),
                ("6", "4", degrees("72.5")),
                ("1", "7", degrees("72.5")),
            ],
            Value::Null,
        ),
        (
            [
                ("0", "0", degrees("72.5")),
                ("0", "0", degrees("72.5")),
                ("6", "4", degrees("17")),
                ("1", "7", degrees("72.5")),
            ],
            json!("every-point"),
        ),
        (
            [
                ("0", "0", degrees("0")),
                ("2", "2", degrees("0")),
                ("6", "4", degrees("0")),
                ("1", "7", degrees("80")),
            ],
            json!("line-and-circle"),
        ),
    ] {
        let problem = json!({"problem": "centerpoint-curve", "positions": positions(&list)});
        let answer = answered("centerpoint-curve", problem);
        assert_eq!(answer["centerpoint"]["type"], expected, "{answer}");
        assert_eq!(answer["circlepoint"]["type"], expected, "{answer}");
        // Of two equal positions known by enclosures the poles with a third are equal, but their
        // distance is not known to be zero.
        let undecided = answer.get("undecided").and_then(Value::as_str);
        let allowed = (expected == "every-point").then_some("quadrilaterals.sides");
        assert_eq!(undecided, allowed, "{answer}");
    }
}

#[test]
fn stretches_of_centerpoint_curves() {
    let tan_half = |text: &str| json!({"tan_half": text});
    let of = |last: Value, wishes: Value| {
        let list = [
            ("0", "0", tan_half("0")),
            ("1", "1/2", tan_half("1/5")),
            ("2", "1/3", tan_half("1/2")),
            ("3", "-1/2", last),
        ];
        answered(
            "centerpoint-curve",
            json!({"problem": "centerpoint-curve", "positions": positions(&list), "wishes": wishes}),
        )
    };
    for wishes in [
        json!({}),
        json!({"in_order": true, "pivots_within": {"box": [["-4", -4], ["4", "4"]]}}),
        json!({"circlepoints_within": {"circle": {"center": ["0", "0"], "radius": "3"}}}),
        json!({"pivots_within": {"polygon": [["-4", "-4"], ["4", "-4"], ["0", "4.5"]]}}),
        json!({
            "beside": {"circlepoint": ["1925/498", "-125/83"], "center": ["-3/4", "11/4"]},
            "driver": "sought", "crank_driven": false, "without_defects": false,
        }),
        json!({
            "beside": {"circlepoint": ["1925/498", "-125/83"], "center": ["-3/4", "11/4"]},
            "driver": "sought", "least_transmission_angle": degrees("1"),
        }),
    ] {
        let answer = of(tan_half("3/4"), wishes);
        assert!(
            !answer["stretches"].as_array().unwrap().is_empty(),
            "{answer}"
        );
    }
    let answer = of(degrees("70"), json!({"in_order": true}));
    assert!(
        answer["stretches"].is_null() && answer["undecided"].is_string(),
        "{answer}"
    );
}

#[test]
fn five_positions() {
    let by_points = |pairs: [[[&str; 2]; 2]; 5]| -> Value {
        pairs
            .iter()
            .map(|points| json!({"points": points}))
            .collect()
    };
    let problem = |positions: Value| json!({"problem": "five-positions", "positions": positions});
    let list = [
        ("0", "0", json!({"tan_half": "0"})),
        ("3", "1", json!({"tan_half": "1/5"})),
        ("5", "1", json!({"tan_half": "1/3"})),
        ("6", "-1", json!({"tan_half": "2/3"})),
        ("5", "-4", json!({"tan_half": "1"})),
    ];
    let answer = answered("five-positions", problem(positions(&list)));
    assert_eq!(
        answer["counts"],
        json!({"real": 2, "complex": 2, "at_infinity": 0})
    );
    assert_eq!(answer["certificate"]["krawczyk"], json!([true, true]));
    assert!(answer.get("undecided").is_none(), "{answer}");
    // The same in degrees, known by enclosures.
    let mut near = list.clone();
    near[1].2 = degrees("22.6");
    let answer = answered("five-positions", problem(positions(&near)));
    assert_eq!(
        answer["counts"],
        json!({"real": 2, "complex": 2, "at_infinity": 0})
    );
    // Translations: on no circle, on one, along a line.
    for (places, family) in [
        (
            [["0", "0"], ["1", "0"], ["0", "1"], ["2", "3"], ["5", "1"]],
            Value::Null,
        ),
        (
            [
                ["5", "0"],
                ["3", "4"],
                ["-3", "4"],
                ["0", "-5"],
                ["4", "-3"],
            ],
            json!({"kind": "plane"}),
        ),
        (
            [
                ["0", "0"],
                ["1", "2"],
                ["2", "4"],
                ["-1", "-2"],
                ["5", "10"],
            ],
            json!({"kind": "plane", "center": {"at_infinity": [{"exact": "2"}, {"exact": "-1"}]}}),
        ),
    ] {
        let shifted = places.map(|[x, y]| {
            let along = (x.parse::<i64>().unwrap() + 1).to_string();
            [[x.to_owned(), y.to_owned()], [along, y.to_owned()]]
        });
        let shifted = shifted.each_ref().map(|pair| {
            pair.each_ref()
                .map(|point| point.each_ref().map(String::as_str))
        });
        let answer = answered("five-positions", problem(by_points(shifted)));
        assert_eq!(answer["family"], family, "{answer}");
        assert_eq!(answer["pairs"], json!([]));
        assert_eq!(answer["at_infinity"], json!([]));
    }
}

/// Slides and turning blocks among the linkages, and wishes.
#[test]
fn mixed_positions() {
    let derivative = |x: &str, y: &str, angle: &str| json!({"x": x, "y": y, "angle": angle});
    for positions in [
        json!([
            {"x": "0", "y": "0", "angle": {"degrees": "0"}, "derivatives": [derivative("1", "0", "1")]},
            {"x": "3", "y": "1", "angle": {"tan_half": "1/3"}},
            {"x": "5", "y": "-1", "angle": {"cos": "3/5", "sin": "4/5"}, "derivatives": [derivative("2", "1", "-1")]},
        ]),
        json!([{
            "x": "1", "y": "2", "angle": {"degrees": "10"},
            "derivatives": [
                derivative("0", "0", "1"), derivative("0", "1", "0"),
                derivative("1/2", "-3", "0"), derivative("2", "1", "0"),
            ],
        }]),
    ] {
        answered(
            "mixed-positions",
            json!({"problem": "mixed-positions", "positions": positions}),
        );
    }
}

#[test]
fn curvature() {
    let link = |point: [&str; 2], center: Value| json!({"circlepoint": point, "center": center});
    for links in [
        json!([
            link(["1", "2"], json!(["0", "0"])),
            link(["4", "3"], json!(["5", "0"]))
        ]),
        json!([
            link(["1", "2"], json!(["0", "0"])),
            link(["4", "0"], json!({"at_infinity": ["0", "1"]}))
        ]),
        // Parallel cranks.
        json!([
            link(["0", "2"], json!(["0", "0"])),
            link(["4", "3"], json!(["4", "0"]))
        ]),
        // An isosceles trapezium.
        json!([
            link(["1", "2"], json!(["0", "0"])),
            link(["4", "2"], json!(["5", "0"]))
        ]),
    ] {
        answered(
            "curvature",
            json!({"problem": "curvature", "links": links, "points": [["2", "3"], ["1", "2"]]}),
        );
    }
    answered(
        "curvature",
        json!({"problem": "curvature", "invariants": {"third": ["1", "-2"], "fourth": ["1/2", "3"]}}),
    );
}

#[test]
fn five_positions_with_wishes() {
    let tan_half = |text: &str| json!({"tan_half": text});
    // The origin slides along the x-axis.
    let along_a_line = [
        ("0", "0", tan_half("0")),
        ("3", "0", tan_half("1/5")),
        ("5", "0", tan_half("1/3")),
        ("6", "0", tan_half("2/3")),
        ("2", "0", tan_half("1")),
    ];
    let slide = json!({"kind": "center", "circlepoint": [{"exact": "0"}, {"exact": "0"}], "direction": [{"exact": "0"}, {"exact": "1"}]});
    for wishes in [
        json!({}),
        json!({"pivots_within": {"box": [["-9", -9], ["9", "9"]]}, "crank_driven": true}),
        json!({"pivots_within": {"circle": {"center": ["0", "0"], "radius": "1/2"}}, "in_order": true}),
        json!({"pivots_within": {"polygon": [["0", "0"], ["1", "0"], ["0", "1"]]}, "without_defects": true,
            "least_transmission_angle": {"degrees": "45"}}),
    ] {
        let problem = json!({"problem": "five-positions", "positions": positions(&along_a_line), "wishes": wishes});
        let answer = answered("five-positions", problem);
        assert!(answer.get("undecided").is_none(), "{answer}");
        assert_eq!(answer["at_infinity"][0], slide, "{answer}");
        let linkages = answer["linkages"].as_array().unwrap();
        assert!(
            linkages
                .iter()
                .any(|linkage| linkage["pairs"][1] == json!({"at_infinity": 0})),
            "{answer}"
        );
        assert!(
            linkages
                .iter()
                .all(|linkage| linkage["fulfils"].is_boolean()),
            "{answer}"
        );
        assert!(answer["ranked"].is_array());
    }
}
