//! `four-bar`: the coupler curve and the whole motion, as they are answered.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use burmester::linkage::cognates::CouplerPoint;
use burmester::linkage::coupler_curve::CouplerCurve;
use burmester::linkage::four_bar::third_corners;
use burmester::number::text::parse_rational;
use burmester::number::{Exact, Number, Surd};
use burmester::oracle::{Arithmetic, ProblemError, Request, solve};
use burmester::plane::{Angle, Point};
use proptest::prelude::*;
use serde_json::{Value, json};

type N = Number<Exact>;

fn request() -> Request {
    Request {
        digits: 12,
        ..Default::default()
    }
}

fn answered(problem: &Value) -> Value {
    let answer = solve(problem, &request()).unwrap();
    assert_eq!(answer.get("undecided"), None, "{problem}: {answer}");
    answer
}

fn wrong(problem: &Value) -> ProblemError {
    solve(problem, &request()).unwrap_err()
}

fn joints(o_a: [&str; 2], a: [&str; 2], b: [&str; 2], o_b: [&str; 2], d: [&str; 2]) -> Value {
    json!({"problem": "four-bar", "O_a": o_a, "A": a, "B": b, "O_b": o_b, "D": d})
}

fn bars([q, r, s, t, m]: [&str; 5], epsilon: &str) -> Value {
    json!({
        "problem": "four-bar", "Q": q, "R": r, "S": s, "T": t, "M": m, "epsilon": {"degrees": epsilon},
    })
}

fn exact(text: &str) -> Value {
    json!({"exact": text})
}

fn point(x: &str, y: &str) -> Value {
    json!([exact(x), exact(y)])
}

fn rational(value: &Value) -> N {
    let text = value.get("exact").unwrap_or(value).as_str().unwrap();
    parse_rational(text).unwrap().into()
}

/// The value of the polynomial with 28 coefficients by falling order, and among those by falling powers
/// of x.
fn sextic_at(answer: &Value, x: &N, y: &N) -> N {
    let mut coefficients = answer["sextic"].as_array().unwrap().iter();
    let mut sum = N::zero();
    for order in (0..=6i32).rev() {
        for k in 0..=order {
            sum += rational(coefficients.next().unwrap()) * x.power(order - k) * y.power(k);
        }
    }
    assert_eq!(coefficients.next(), None);
    sum
}

fn kinds(answer: &Value) -> Vec<&str> {
    let list = answer["double_points"].as_array().unwrap().iter();
    list.map(|found| found["kind"].as_str().unwrap()).collect()
}

#[test]
fn the_curve_goes_through_all_positions_of_the_point() {
    let answer = answered(&joints(
        ["0", "0"],
        ["1", "2"],
        ["6", "5"],
        ["7", "1"],
        ["2", "8"],
    ));
    assert_eq!(answer["type"], "crank-and-lever");
    assert_eq!(answer["crank"], "R");
    assert_eq!(answer["circuits"], 2);
    let [two, eight] = [2, 8].map(N::from);
    assert!(sextic_at(&answer, &two, &eight).is_zero().is_yes());
    assert!(sextic_at(&answer, &eight, &two).is_zero().is_no());
    assert_eq!(
        answer["foci"],
        json!([point("0", "0"), point("7", "1"), point("67/17", "106/17")])
    );
    let cubic: Vec<&str> = answer["eliminant"]
        .as_array()
        .unwrap()
        .iter()
        .map(|c| c.as_str().unwrap())
        .collect();
    // |m|² = 37, |n|² = 25, R² = 5, T² = 17, d² = 50, Re(m̄n) = 14.
    let [r, s] = [37 - 5, 25 - 17];
    let expected = [
        r * 37,
        -(2 * r * 14 + s * 37 + 50 * 37),
        r * 25 + 2 * s * 14 + 50 * 25,
        -s * 25,
    ];
    let common = expected[0] / cubic[0].parse::<i64>().unwrap();
    for (found, expected) in cubic.iter().zip(expected) {
        assert_eq!(found.parse::<i64>().unwrap() * common, expected);
    }
    // The same curve by either cognate.
    for cognate in answer["cognates"].as_array().unwrap() {
        let mut problem = json!({"problem": "four-bar"});
        for name in ["O_a", "A", "B", "O_b", "D"] {
            let [x, y] = [0, 1].map(|place| cognate[name][place]["exact"].clone());
            problem[name] = json!([x, y]);
        }
        let other = answered(&problem);
        for name in [
            "sextic",
            "circle",
            "double_points",
            "type",
            "crank",
            "circuits",
        ] {
            let expected = if name == "type" || name == "crank" {
                cognate
            } else {
                &answer
            };
            assert_eq!(other[name], expected[name], "{name}");
        }
        for name in [
            "Q", "R", "S", "T", "M", "N", "epsilon", "phi0", "psi0", "chi0",
        ] {
            assert_eq!(other[name], cognate[name], "{name}");
        }
    }
}

/// Through the pole D has a cusp: both cranks point to D.
#[test]
fn a_point_in_the_pole_is_a_cusp() {
    let answer = answered(&joints(
        ["0", "0"],
        ["1", "2"],
        ["5", "7/2"],
        ["7", "1"],
        ["3", "6"],
    ));
    let found = answer["double_points"].as_array().unwrap();
    let here = found.iter().find(|found| found["point"] == point("3", "6"));
    assert_eq!(here.unwrap()["kind"], "cusp");
    assert_eq!(
        kinds(&answer)
            .iter()
            .filter(|kind| **kind == "cusp")
            .count(),
        1
    );
}

#[test]
fn a_point_as_far_from_its_pin_as_the_pin_from_its_pivot_comes_into_the_pivot() {
    for epsilon in ["40", "60", "90"] {
        let answer = answered(&bars(["4", "2", "3", "4", "2"], epsilon));
        let found = answer["double_points"].as_array().unwrap();
        assert!(
            found.iter().any(|found| found["point"] == point("0", "0")),
            "{answer}"
        );
        let complex = answer["complex_double_points"].as_array().unwrap();
        assert_eq!(found.len() + complex.len(), 3);
    }
}

#[test]
fn a_parallelogram_comes_to_its_change_points() {
    let answer = answered(&joints(
        ["0", "0"],
        ["0", "2"],
        ["4", "2"],
        ["4", "0"],
        ["1", "2"],
    ));
    assert_eq!(answer["type"], "change-point");
    assert_eq!(answer["crank"], "both");
    assert_eq!(answer["circuits"], 1);
    let flat: Vec<&Value> = answer["change_points"]
        .as_array()
        .unwrap()
        .iter()
        .map(|flat| &flat["D"])
        .collect();
    assert_eq!(flat, [&point("3", "0"), &point("-1", "0")]);
    assert_eq!(kinds(&answer), ["change-point", "change-point"]);
}

#[test]
fn a_point_in_a_pin_moves_on_a_circle() {
    for (m, degenerate) in [("0", 0), ("5", 1)] {
        let answer = answered(&bars(["4", "2", "5", "5", m], "0"));
        assert_eq!(answer["double_points"], Value::Null);
        let cognates = &answer["cognates"];
        assert_eq!(cognates[degenerate]["type"], Value::Null);
        assert!(cognates[1 - degenerate]["type"].is_string());
    }
}

#[test]
fn dead_centres_and_limits_are_exact_where_they_can_be() {
    // In the dead centre of R the bars S and T are the hypotenuse over R and Q.
    let answer = answered(&bars(["4", "3", "2", "3", "1"], "0"));
    let crank = &answer["cranks"]["R"];
    assert_eq!(crank["turns_fully"], false);
    let right = |text: &str| json!({"degrees": exact(text)});
    assert_eq!(
        crank["dead_centres"][0],
        json!({
            "angle": right("90"), "coupler_and_driven": "stretched",
            "A": point("0", "3"), "B": point("8/5", "9/5"), "D": point("4/5", "12/5"),
        })
    );
    assert_eq!(crank["limits"][0]["from"], right("-90"));
    assert_eq!(crank["transmission"]["greatest"], right("180"));
    for range in crank["limits"].as_array().unwrap() {
        let dead = crank["dead_centres"].as_array().unwrap().iter();
        let angles: Vec<&Value> = dead.map(|dead| &dead["angle"]).collect();
        assert!(angles.contains(&&range["from"]) && angles.contains(&&range["to"]));
    }
}

#[test]
fn a_position_is_found_from_its_crank_angle() {
    let mut problem = bars(["4", "2", "3", "3", "2"], "60");
    problem["phi0"] = json!({"cos": "3/5", "sin": "4/5"});
    let left = answered(&problem);
    problem["assembly"] = json!("right");
    let right = answered(&problem);
    assert_eq!(left["A"], point("6/5", "8/5"));
    assert_eq!(left["A"], right["A"]);
    assert_ne!(left["B"], right["B"]);
    assert_eq!(left["sextic"], right["sextic"]);
    // As it is by its joints.
    let at = |x: i64, y: i64| -> Point<Surd> { Number::complex(x.into(), y.into()) };
    let pin = Number::complex(Number::ratio(6, 5), Number::ratio(8, 5));
    let [expected, _] = third_corners(&pin, &at(4, 0), &9.into(), &9.into()).unwrap();
    let [x, y] = [expected.re(), expected.im()].map(|part| part.0.enclosure(60).0);
    for (coordinate, expected) in left["B"].as_array().unwrap().iter().zip([x, y]) {
        let text = coordinate["value"].as_str().unwrap();
        let radius = parse_rational(coordinate["radius"].as_str().unwrap()).unwrap();
        let found = parse_rational(text).unwrap();
        let (low, high) = (expected.lower().unwrap(), expected.upper().unwrap());
        assert!(low >= rug::Rational::from(&found - &radius) && high <= found + radius);
    }
}

#[test]
fn a_position_in_a_dead_centre_is_found() {
    // S and T stretched over R and Q; D is known by enclosures.
    let mut problem = bars(["4/7", "3/7", "2/7", "3/7", "1/7"], "40");
    problem["phi0"] = json!({"degrees": "90"});
    let answer = answered(&problem);
    assert_eq!(answer["A"], point("0", "3/7"));
    assert_eq!(answer["B"], point("8/35", "9/35"));
}

#[test]
fn wrong_four_bars() {
    let four = bars(["4", "2", "3", "3", "2"], "40");
    let with = |name: &str, value: Value| {
        let mut problem = four.clone();
        problem[name] = value;
        problem
    };
    for (problem, place, part) in [
        (with("Q", json!("9")), "Q", "does not move"),
        (with("T", json!("-3")), "T", "positive"),
        (with("M", json!("-3")), "M", "not negative"),
        (with("assembly", json!("left")), "assembly", "phi0"),
        (with("A", json!(["1", "2"])), "Q", "unknown field"),
        (with("N", json!("3")), "N", "unknown field"),
        (
            joints(["0", "0"], ["0", "0"], ["6", "5"], ["7", "1"], ["2", "8"]),
            "A",
            "no length",
        ),
        (
            joints(["0", "0"], ["1", "0"], ["2", "0"], ["3", "0"], ["2", "8"]),
            "O_b",
            "does not move",
        ),
    ] {
        let error = wrong(&problem);
        assert_eq!(error.place, place, "{error}");
        assert!(error.message.contains(part), "{error}");
    }
    // It does not close at 170°, nor at 2.9 radians, and at 0° A comes into O_b.
    let mut lever = bars(["4", "4", "2", "3", "1"], "0");
    for (phi0, part) in [
        (json!({"degrees": "170"}), "closes"),
        (json!({"radians": "2.9"}), "closes"),
        (json!({"degrees": "0"}), "not determined"),
    ] {
        lever["phi0"] = phi0;
        let error = wrong(&lever);
        assert_eq!(error.place, "phi0");
        assert!(error.message.contains(part), "{error}");
    }
}

#[test]
fn floats_are_plain_numbers() {
    let request = Request {
        arithmetic: Arithmetic::Float,
        ..request()
    };
    let answer = solve(&bars(["4", "2", "3", "3", "2.5"], "40"), &request).unwrap();
    assert!(answer["N"].is_number() && answer["foci"][2][0].is_number());
    assert!(answer["cranks"]["T"]["limits"][0]["from"]["degrees"].is_number());
}

fn number() -> impl Strategy<Value = N> {
    (-20i64..=20, 1i64..=6).prop_map(|(p, q)| Number::ratio(p, q))
}

fn place() -> impl Strategy<Value = Point<Exact>> {
    (number(), number()).prop_map(|(x, y)| Number::complex(x, y))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 32, ..ProptestConfig::default() })]

    /// Another position of the coupler, which closes by the choice of O_b: free symbols for both would
    /// make too many terms.
    #[test]
    fn the_sextic_vanishes_in_every_position(
        a in place(), b in place(), d in place(), half in number(), crank in number(), o_a in place(),
    ) {
        let turn = |t: &N| Angle::from_tan_half(t).cis();
        let [coupler, crank] = [turn(&half), turn(&crank)];
        let moved_a = &o_a + (&a - &o_a) * &crank;
        let moved_b = &moved_a + (&b - &a) * &coupler;
        let moved_d = &moved_a + (&d - &a) * &coupler;
        // On the perpendicular bisector of both places of B.
        let across = Number::i() * (&moved_b - &b);
        let o_b = (&b + &moved_b) / 2 + across.scaled(&Number::ratio(3, 4));
        let first = CouplerPoint { pivots: [o_a.clone(), o_b.clone()], pins: [a, b], point: d.clone() };
        let second = CouplerPoint { pivots: [o_a, o_b], pins: [moved_a, moved_b], point: moved_d.clone() };
        let [here, there] = [&first, &second].map(|linkage| CouplerCurve::from(linkage).sextic());
        prop_assert!(here.clone().minus(&there).is_zero());
        for point in [&d, &moved_d] {
            prop_assert!(here.at(point.re(), point.im()).is_zero().is_yes());
        }
    }

    /// With exact crank angles too: all roots of the cubic add up to three double points.
    #[test]
    fn three_double_points_with_their_multiplicities(
        a in place(), b in place(), d in place(), o_b in place(),
    ) {
        let text = |z: &Point<Exact>| {
            let part = |x: &N| x.0.rational().unwrap().to_string();
            json!([part(z.re()), part(z.im())])
        };
        let problem = json!({
            "problem": "four-bar", "O_a": ["0", "0"],
            "A": text(&a), "B": text(&b), "O_b": text(&o_b), "D": text(&d),
        });
        let Ok(answer) = solve(&problem, &request()) else { return Ok(()) };
        prop_assert_eq!(answer.get("undecided"), None);
        prop_assert!(sextic_at(&answer, d.re(), d.im()).is_zero().is_yes());
        let count = |name: &str| -> Option<u64> {
            let list = answer[name].as_array()?.iter();
            list.map(|found| found["multiplicity"].as_u64()).sum()
        };
        let Some(real) = count("double_points") else {
            let on_pin = [&a, &b].iter().any(|pin| pin.equals(&d).is_yes());
            prop_assert!(on_pin);
            return Ok(());
        };
        prop_assert_eq!(real + count("complex_double_points").unwrap(), 3);
        let crank = answer["crank"].as_str().unwrap();
        for (name, words) in [("R", ["R", "both"]), ("T", ["T", "both"])] {
            let drive = &answer["cranks"][name];
            prop_assert_eq!(drive["turns_fully"].as_bool().unwrap(), words.contains(&crank));
            let limits = drive["limits"].as_array().unwrap();
            prop_assert_eq!(limits.is_empty(), words.contains(&crank));
        }
    }
}
