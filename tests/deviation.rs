//! The certified arcs against dense sampling of the finished linkage.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use burmester::linkage::cognates::CouplerPoint;
use burmester::number::{Number, text::parse_rational};
use burmester::oracle::{Request, solve};
use burmester::straight_line::design::Design;
use burmester::straight_line::deviation::driven::Driven;
use serde_json::{Value, json};

fn answer(problem: &Value) -> Value {
    let request = Request {
        digits: 12,
        ..Request::default()
    };
    solve(problem, &request).unwrap()
}

fn float(value: &Value) -> f64 {
    let text = value.get("exact").or_else(|| value.get("value"));
    parse_rational(text.and_then(Value::as_str).unwrap())
        .unwrap()
        .to_f64()
}

fn point(value: &Value) -> Number<burmester::number::Complex<f64>> {
    Number::complex(Number(float(&value[0])), Number(float(&value[1])))
}

/// The linkage in floats, from the answer to the design.
fn driven(linkage: &Value) -> Driven<f64> {
    let design = Design {
        linkage: CouplerPoint {
            pivots: [point(&linkage["O_a"]), point(&linkage["O_b"])],
            pins: [point(&linkage["A"]), point(&linkage["B"])],
            point: point(&linkage["D"]),
        },
        direction: point(&linkage["direction"]),
    };
    Driven::new(&design).unwrap()
}

/// Where sampling leaves the arc, in degrees and as travel; each step a thousandth of a degree.
fn sampled(driven: &Driven<f64>, bound: f64, side: f64) -> (f64, f64) {
    let mut last = (0.0, 0.0);
    let mut direction = 0.0;
    for step in 1..=360_000 {
        let degrees = side * f64::from(step) / 1000.0;
        let (sin, cos) = degrees.to_radians().sin_cos();
        let Some(position) = driven.position(&Number::complex(Number(cos), Number(sin))) else {
            break;
        };
        let [u, v] = driven.coordinates(&position).map(|x| x.0);
        let travel = u - last.1;
        if !v.is_finite() || v.abs() > bound || travel * direction < 0.0 {
            break;
        }
        direction = travel;
        last = (degrees, u);
    }
    last
}

#[test]
fn certified_arcs_agree_with_sampling() {
    let degrees = |angle: &str| json!({"degrees": angle});
    let mut ends = std::collections::BTreeSet::new();
    for design in [
        json!({"kind": "ball-double-burmester", "alpha_a": degrees("65"), "alpha_b": degrees("165")}),
        json!({"kind": "ball-burmester", "alpha_a": degrees("50"), "alpha_b": degrees("110"),
            "alpha_d": degrees("80"), "alternate": "1,2"}),
        json!({"kind": "inflection-pole", "k": "-5", "alpha_a": degrees("40"), "alternate": "1,2"}),
        json!({"kind": "watt", "R": "1", "T": "2", "gamma": degrees("70"), "n": "1", "k": "0.2"}),
        json!({"kind": "evans", "alpha": degrees("90"), "beta": degrees("0"), "omega": degrees("20"),
            "rho": "0.2", "k": "9"}),
        json!({"kind": "conchoid", "r": "0.4", "alpha": degrees("20"), "k": "5", "n": "1"}),
        json!({"kind": "symmetric", "a": "3/2", "c": "5", "d": "3/2"}),
    ] {
        let linkages = answer(&json!({"problem": "straight-line", "design": design}));
        let driven = driven(&linkages["solutions"][0]["linkages"][0]);
        let found = answer(&json!({"problem": "deviation", "design": design,
            "levels": ["0.001", "0.05"]}));
        assert_eq!(found.get("undecided"), None, "{design}: {found}");
        let unit = float(&found["unit"]);
        for level in found["levels"].as_array().unwrap() {
            let bound = float(&level["D"]) * unit;
            for (end, side) in [(0, -1.0), (1, 1.0)] {
                let (degrees, travel) = sampled(&driven, bound, side);
                let expected = float(&level["phi"][end]);
                assert!(
                    (degrees - expected).abs() < 0.0021,
                    "{design} {level}: {degrees}"
                );
                // A direction goes out without its sense.
                let expected = (float(&level["u"][end]) * unit).abs();
                let difference = (travel.abs() - expected).abs();
                // Before a dead centre the travel goes with the root of what is left of the angle.
                let allowed = match level["ended_by"][end] == "dead-centre" {
                    true => 2e-2,
                    false => 2e-4,
                };
                assert!(difference < allowed, "{design} {level}: {travel}");
                ends.insert(level["ended_by"][end].to_string());
            }
        }
    }
    assert!(ends.len() > 1, "{ends:?}");
}

/// The printed output of 1964 for the representative linkage (Tesar, chapter VI).
#[test]
fn the_steps_of_one_degree() {
    let design = json!({"kind": "ball-double-burmester",
        "alpha_a": {"degrees": "65"}, "alpha_b": {"degrees": "165"}});
    // The order of the levels does not matter to the answer.
    let levels = ["0.05", "0.0001", "0.01"];
    let found = answer(&json!({"problem": "deviation", "design": design, "levels": levels}));
    for (level, phi, length) in [
        (0, [-153, 81], 1.320_072),
        (1, [-32, 30], 0.397_530),
        (2, [-91, 72], 1.009_698),
    ] {
        let stepped = &found["levels"][level]["stepped"];
        assert_eq!(stepped["phi"], json!(phi));
        assert!(
            (stepped["length"].as_f64().unwrap() - length).abs() < 2e-6,
            "{stepped}"
        );
    }
}

/// Chebyshev's linkage 5 : 2 : 4 touches its line in the middle and at both ends, where the crank is in
/// a dead centre or the coupler upright.
#[test]
fn all_extremes_of_chebyshevs_linkage() {
    let design = json!({"kind": "symmetric", "a": "-2", "c": "0", "d": "4"});
    let found = answer(&json!({"problem": "deviation", "design": design, "levels": ["0.01"]}));
    assert_eq!(found.get("undecided"), None, "{found}");
    let level = &found["levels"][0];
    assert_eq!(level["ended_by"], json!(["deviation", "dead-centre"]));
    let extremes = level["extremes"].as_array().unwrap();
    let values: Vec<f64> = extremes.iter().map(|one| float(&one["v"])).collect();
    assert_eq!(values.len(), 3, "{values:?}");
    assert!(
        values[0].abs() < 1e-12 && (values[1] - values[2]).abs() < 1e-12,
        "{values:?}"
    );
}
