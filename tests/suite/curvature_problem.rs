//! The problem `curvature`: one position of a motion.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "a test that cannot compute what it tests has failed"
)]

use burmester::oracle::{Request, solve};
use serde_json::{Value, json};

fn link(circlepoint: [i64; 2], center: &Value) -> Value {
    json!({"circlepoint": circlepoint, "center": center})
}

fn answered(problem: &Value) -> Value {
    solve(problem, &Request::default()).unwrap()
}

fn exact([x, y]: [&str; 2]) -> Value {
    json!([{"exact": x}, {"exact": y}])
}

fn four_bar() -> Value {
    json!({
        "problem": "curvature",
        "links": [link([1, 2], &json!([0, 0])), link([4, 3], &json!([5, 0]))],
        "points": [[1, 2], [4, 3], [2, 5]],
    })
}

#[test]
fn the_links_of_a_four_bar_are_two_of_its_burmester_pairs() {
    let answer = answered(&four_bar());
    for (point, center) in [(["1", "2"], ["0", "0"]), (["4", "3"], ["5", "0"])] {
        let pairs = answer["pairs"].as_array().unwrap();
        let is_link =
            |pair: &&Value| pair["circlepoint"] == exact(point) && pair["center"] == exact(center);
        assert!(
            pairs.iter().any(|pair| is_link(&pair)),
            "{point:?}: {answer}"
        );
    }
    assert!(answer.get("undecided").is_none(), "{answer}");
}

#[test]
fn the_ends_of_the_links_stay_on_their_circles() {
    let answer = answered(&four_bar());
    let points = answer["points"].as_array().unwrap();
    assert_eq!(points[0]["center"], exact(["0", "0"]));
    assert_eq!(points[1]["center"], exact(["5", "0"]));
    for end in &points[..2] {
        assert_eq!(
            end["contact"],
            json!({"tangent": 1, "circle": {"at_least": 10}})
        );
    }
    assert_eq!(points[2]["contact"], json!({"tangent": 1, "circle": 2}));
}

#[test]
fn the_pole_is_where_the_links_meet() {
    // y = 2x and y = −3x + 15.
    assert_eq!(answered(&four_bar())["pole"], exact(["3", "6"]));
    let parallel = json!({
        "problem": "curvature",
        "links": [link([0, 2], &json!([0, 0])), link([4, 3], &json!([4, 0]))],
    });
    let answer = answered(&parallel);
    assert_eq!(answer["pole"]["at_infinity"], exact(["0", "1"]));
    assert_eq!(
        answer["inflection_circle"][0],
        json!("0"),
        "no line: {answer}"
    );
    assert!(answer["inflection_pole"].is_null() && answer["invariants"].is_null());
    assert!(!answer["pairs"].is_null(), "{answer}");
}

#[test]
fn a_point_of_a_slide_goes_straight() {
    let answer = answered(&json!({
        "problem": "curvature",
        "links": [link([1, 2], &json!([0, 0])), link([4, 0], &json!({"at_infinity": [0, 1]}))],
        "points": [[4, 0]],
    }));
    let slide = &answer["points"][0];
    assert_eq!(slide["center"]["at_infinity"], exact(["0", "1"]));
    assert_eq!(
        slide["contact"],
        json!({"tangent": {"at_least": 10}, "circle": null})
    );
}

#[test]
fn invariants_say_the_same_as_the_linkage() {
    let answer = answered(&four_bar());
    let plain = |name: &str| -> Vec<String> {
        let list = answer["invariants"][name].as_array().unwrap();
        list.iter()
            .map(|x| x["exact"].as_str().unwrap().to_owned())
            .collect()
    };
    let canonical = answered(&json!({
        "problem": "curvature",
        "invariants": {"third": plain("third"), "fourth": plain("fourth")},
    }));
    assert_eq!(canonical["counts"], answer["counts"]);
    assert_eq!(canonical["invariants"], answer["invariants"]);
    assert_eq!(canonical["pole"], exact(["0", "0"]));
    assert_eq!(canonical["inflection_pole"], exact(["0", "1"]));
}

/// A link by its circlepoint and its center, either of them perhaps at infinity.
fn ends(circlepoint: &Value, center: &Value) -> Value {
    json!({"circlepoint": circlepoint, "center": center})
}

/// The slider's pin is always Ball's point; for k = −1 the crank pin is at infinity on its ray, for k = −4
/// and the pin D in the inflection pole another point falls into D.
#[test]
fn ball_s_point_of_a_slider_crank_is_a_burmester_point() {
    let slider = |at: Value, normal: Value| ends(&at, &json!({"at_infinity": normal}));
    let inclined = slider(json!(["12/25", "16/25"]), json!([3, 4]));
    let at_inflection_pole = slider(json!([0, 1]), json!([0, 1]));
    let k_is_minus_1 = ends(&json!({"at_infinity": [1, 1]}), &json!(["-1/2", "-1/2"]));
    let k_is_minus_4 = ends(&json!(["2/3", "2/3"]), &json!([-2, -2]));
    for (crank, slider, expected, ball_point) in [
        (&k_is_minus_1, &inclined, "burmester", ["12/25", "16/25"]),
        (&k_is_minus_4, &inclined, "burmester", ["12/25", "16/25"]),
        (&k_is_minus_1, &at_inflection_pole, "burmester", ["0", "1"]),
        (
            &k_is_minus_4,
            &at_inflection_pole,
            "double-burmester",
            ["0", "1"],
        ),
    ] {
        let answer = answered(&json!({"problem": "curvature", "links": [crank, slider]}));
        assert_eq!(answer["pole"], exact(["0", "0"]));
        assert_eq!(answer["inflection_pole"], exact(["0", "1"]));
        assert_eq!(answer["ball_point"], exact(ball_point));
        assert_eq!(answer["ball_burmester"], json!(expected), "{answer}");
    }
}

#[test]
fn ball_s_point_need_not_be_a_burmester_point() {
    assert_eq!(answered(&four_bar())["ball_burmester"], json!("none"));
    let of_invariants = |third: [&str; 2], fourth: [&str; 2]| {
        let invariants = json!({"third": third, "fourth": fourth});
        answered(&json!({"problem": "curvature", "invariants": invariants}))
    };
    let thrice = of_invariants(["-1", "1"], ["-8/3", "5/3"]);
    assert_eq!(thrice["ball_burmester"], json!("triple-burmester"));
    let open = of_invariants(["0", "0"], ["6", "2"]);
    assert_eq!(open["ball_point"], json!({"undetermined": true}));
    assert!(open["ball_burmester"].is_null() && open.get("undecided").is_none());
}

#[test]
fn wrong_problems_are_refused_with_their_place() {
    let center = json!([0, 0]);
    for (problem, expected) in [
        (
            json!({"problem": "curvature"}),
            "links: this field is missing",
        ),
        (
            json!({"problem": "curvature", "links": [link([1, 2], &center)]}),
            "links: two links were expected, not 1",
        ),
        (
            json!({"problem": "curvature", "links": [link([1, 2], &center), link([0, 0], &center)]}),
            "links[1].center: the link has no length",
        ),
        (
            json!({"problem": "curvature", "links": [link([1, 2], &center), link([2, 4], &center)]}),
            "links: the motion is not determined here",
        ),
        (
            json!({"problem": "curvature", "links": [link([1, 2], &center), link([2, 4], &json!({"at_infinity": [0, 0]}))]}),
            "links[1].center: a direction that is not zero",
        ),
    ] {
        let error = solve(&problem, &Request::default())
            .unwrap_err()
            .to_string();
        assert!(error.starts_with(expected), "{error}, not {expected}");
    }
}
