//! The certified arcs against dense sampling of the finished linkage.
#![expect(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test that cannot go on has failed"
)]

use std::collections::BTreeSet;

use crate::support::seed::{generator, rounds};
use burmester::linkage::cognates::CouplerPoint;
use burmester::number::{Ball, Number, Real, text::parse_rational};
use burmester::oracle::{Request, solve};
use burmester::straight_line::design::Design;
use burmester::straight_line::deviation::arc::Arcs;
use burmester::straight_line::deviation::driven::Driven;
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

/// Of the enclosures of random linkages.
const BITS: u32 = 256;

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

/// The last sample within the arc, and the one that leaves it; none where the crank comes no further.
struct Left {
    degrees: f64,
    travel: f64,
    beyond: Option<f64>,
}

/// Samples in a degree.
fn density() -> f64 {
    if rounds(1) > 1 { 1000.0 } else { 100.0 }
}

/// The linkage in enclosures, from the answer to the design.
fn enclosed(linkage: &Value) -> Design<Ball> {
    let point = |name: &str| {
        let [x, y] = [0, 1].map(|axis| Number(ball(&linkage[name][axis])));
        Number::complex(x, y)
    };
    Design {
        linkage: CouplerPoint {
            pivots: [point("O_a"), point("O_b")],
            pins: [point("A"), point("B")],
            point: point("D"),
        },
        direction: point("direction"),
    }
}

fn middle(x: &Number<Ball>) -> f64 {
    x.0.midpoint_rational().unwrap().to_f64()
}

fn ball(value: &Value) -> Ball {
    let number = |name: &str| parse_rational(value[name].as_str().unwrap()).unwrap();
    if value.get("exact").is_some() {
        return Ball::rounded(&number("exact"), &BITS);
    }
    Ball::with_radius(&number("value"), &number("radius"), BITS)
}

/// Compares the ends of an arc with sampling.
fn compare(what: &str, driven: &Driven<f64>, unit: f64, level: f64, ends: [[f64; 2]; 2]) {
    for (side, [degrees, travel]) in [-1.0, 1.0].into_iter().zip(ends) {
        let left = sampled(driven, level * unit, side);
        let difference = (left.degrees - degrees).abs();
        assert!(
            difference < 2.1 / density(),
            "{what} within {level}: {} sampled, {degrees} certified",
            left.degrees
        );
        // A direction goes out without its sense.
        let difference = (left.travel.abs() - travel.abs()).abs();
        // Before a dead centre the travel goes with the root of what is left of the angle.
        let allowed = match left.beyond {
            Some(beyond) => 1.01 * (beyond - left.travel).abs() + 1e-6 * unit,
            None => 2e-2 * unit.max(1.0) * (1000.0 / density()).sqrt(),
        };
        assert!(
            difference < allowed,
            "{what} within {level}: {} sampled, {travel} certified",
            left.travel
        );
    }
}

/// Where sampling leaves the arc.
fn sampled(driven: &Driven<f64>, bound: f64, side: f64) -> Left {
    let mut last = Left {
        degrees: 0.0,
        travel: 0.0,
        beyond: None,
    };
    let mut direction = 0.0;
    let density = density();
    for step in 1..=360_000 {
        let degrees = side * f64::from(step) / density;
        if degrees.abs() > 360.0 {
            break;
        }
        let (sin, cos) = degrees.to_radians().sin_cos();
        let Some(position) = driven.position(&Number::complex(Number(cos), Number(sin))) else {
            break;
        };
        let [u, v] = driven.coordinates(&position).map(|x| x.0);
        if !(u.is_finite() && v.is_finite()) {
            break;
        }
        let travel = u - last.travel;
        if v.abs() > bound || travel * direction < 0.0 {
            last.beyond = Some(u);
            break;
        }
        direction = travel;
        (last.degrees, last.travel) = (degrees, u);
    }
    last
}

/// The first linkage of a design, with 60 digits; `None` where there is none.
fn linkage(design: &Value) -> Option<Value> {
    let problem = json!({"problem": "straight-line", "design": design});
    let request = Request {
        digits: 60,
        ..Request::default()
    };
    // A displacement of 0 is no design of some kinds.
    let answer = solve(&problem, &request).ok()?;
    let linkage = answer.get("solutions")?[0]["linkages"].get(0)?;
    linkage.get("O_a").map(|_| linkage.clone())
}

/// Compares every end of the arcs that are solved with sampling; the reasons why they end.
fn compared(design: &Value, levels: [&str; 2]) -> Option<Vec<String>> {
    let driven = driven(&linkage(design)?);
    let found = answer(&json!({"problem": "deviation", "design": design, "levels": levels}));
    if found.get("undecided").is_some() {
        eprintln!("{design}: undecided {}", found["undecided"]);
        return None;
    }
    let unit = float(&found["unit"]);
    let mut reasons = Vec::new();
    for level in found["levels"].as_array().unwrap() {
        let end = |end: usize| [float(&level["phi"][end]), float(&level["u"][end]) * unit];
        let ends = [end(0), end(1)];
        compare(&design.to_string(), &driven, unit, float(&level["D"]), ends);
        reasons.extend([0, 1].map(|end| level["ended_by"][end].to_string()));
    }
    Some(reasons)
}

/// The same for the arcs alone.
fn arcs_compared(design: &Value, levels: [&str; 2]) -> Option<()> {
    let linkage = linkage(design)?;
    let enclosed = enclosed(&linkage);
    let unit = enclosed.unit();
    let arcs = Arcs::new(Driven::new(&enclosed)?, BITS);
    for level in levels {
        let bound = &unit * Number::<Ball>::rounded(&parse_rational(level).unwrap(), &BITS);
        let Some(arc) = arcs.within(&bound) else {
            eprintln!("{design}: the arc within {level} is undecided");
            return None;
        };
        let ends = arc.each_ref().map(|limit| {
            let position = arcs.position(limit).unwrap();
            [&limit.degrees, &arcs.coordinates(&position)[0]].map(middle)
        });
        let level = level.parse().unwrap();
        compare(
            &design.to_string(),
            &driven(&linkage),
            middle(&unit),
            level,
            ends,
        );
    }
    Some(())
}

#[test]
fn certified_arcs_agree_with_sampling() {
    let degrees = |angle: &str| json!({"degrees": angle});
    let mut ends = BTreeSet::new();
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
        let compared = compared(&design, ["0.001", "0.05"]);
        ends.extend(compared.unwrap_or_else(|| panic!("{design} is not decided")));
    }
    assert!(ends.len() > 1, "{ends:?}");
}

/// A random design of one of all sixteen kinds.
fn random_design(random: &mut ChaCha8Rng, kind: usize) -> Value {
    let mut angle = |least: i32, most: i32| {
        let hundredths = random.random_range(100 * least..100 * most);
        format!("{}", f64::from(hundredths) / 100.0)
    };
    let [a, b, d] = [angle(5, 85), angle(5, 175), angle(5, 175)];
    let (omega, start) = (angle(10, 80), angle(5, 175));
    let from: f64 = start.parse().unwrap();
    let range = json!({"from": start, "to": format!("{:.2}", from + 5.0)});
    let [a, b, d, omega] = [a, b, d, omega].map(|degrees| json!({"degrees": degrees}));
    let mut size = |least: i32, most: i32| {
        let hundredths = random.random_range(100 * least..100 * most);
        format!("{}", f64::from(hundredths) / 100.0)
    };
    let (k, s, length) = (size(-6, 6), size(-1, 1), size(1, 4));
    let [other, third, far] = [size(1, 4), size(1, 4), size(2, 9)];
    let n = if random.random_range(0..2) == 0 {
        "1"
    } else {
        "-1"
    };
    let alternate = ["1,2", "2,3", "3,1"][random.random_range(0..3)];
    match kind {
        0 => json!({"kind": "ball-double-burmester", "alpha_a": a, "alpha_b": b}),
        1 => json!({"kind": "ball-burmester", "alpha_a": a, "alpha_b": b, "alpha_d": d,
            "alternate": alternate}),
        2 => json!({"kind": "inflection-pole", "k": k, "alpha_a": a, "alternate": alternate}),
        3 => json!({"kind": "equal-cranks", "k": k, "alternate": alternate}),
        4 => json!({"kind": "slider-crank", "k": k, "alpha_a": a, "alpha_d": d, "s": [s],
            "alternate": alternate}),
        5 => json!({"kind": "ball-intersection", "k": k, "alpha_a": a, "alpha_d": d, "s": s,
            "alternate": alternate}),
        6 => json!({"kind": "symmetrical", "k": k, "alpha_a": a, "epsilon": omega}),
        7 => json!({"kind": "watt", "R": length, "T": other, "gamma": d, "n": n, "k": s}),
        8 => json!({"kind": "evans", "alpha": {"degrees": "90"}, "beta": {"degrees": "0"},
            "omega": omega, "rho": s, "k": far}),
        9 => json!({"kind": "conchoid", "r": length, "alpha": omega, "k": far, "n": n}),
        10 => json!({"kind": "symmetric", "a": k, "c": s, "d": length}),
        11 => {
            json!({"kind": "four-bar", "Q": length, "R": other, "S": third, "T": far, "M": length,
            "epsilon": omega, "phi0": d})
        }
        12 => json!({"kind": "ball-tangent", "k": k, "alpha_a": a, "s": s, "alpha_d": range,
            "alternate": alternate}),
        13 => json!({"kind": "ball-burmester-intersection", "k": k, "alpha_a": a, "s": s,
            "alpha_d": range, "alternate": alternate}),
        14 => json!({"kind": "two-inflections", "k": k, "alpha_a": a}),
        _ => json!({"kind": "ball-two-intersections", "k": k, "alpha_a": a, "s": [s, "0.7"],
            "alpha_d": range, "alternate": alternate}),
    }
}

/// Designs that have a linkage are compared, a thousand in the long run.
#[test]
fn arcs_of_random_designs_agree_with_sampling() {
    let mut random = generator("arcs_of_random_designs_agree_with_sampling");
    let wanted = if rounds(1) > 1 { 1000 } else { 40 };
    let (mut count, mut tried) = (0, 0);
    let mut kinds = BTreeSet::new();
    while count < wanted && tried < 20 * wanted {
        let kind = tried % 16;
        tried += 1;
        let design = random_design(&mut random, kind);
        if arcs_compared(&design, ["0.001", "0.05"]).is_some() {
            kinds.insert(kind);
            count += 1;
            if count % 100 == 0 {
                eprintln!("{count} designs agree");
            }
        }
    }
    eprintln!(
        "{count} designs of {} kinds agree, {tried} were drawn",
        kinds.len()
    );
    assert_eq!(count, wanted);
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
