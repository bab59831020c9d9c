//! Straight-line designs: the finished linkages, by the series of their own closure.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use burmester::curvature::slider_crank::SliderCrank;
use burmester::number::{Ball, Number, Surd};
use burmester::plane::Angle;
use burmester::plane::line::mirror;
use burmester::straight_line::ball_burmester::{
    Alternate, at_inflection_pole, double, equal_cranks, of_rays, of_slider_crank,
};
use burmester::straight_line::conchoid::Conchoid;
use burmester::straight_line::design::Design;
use burmester::straight_line::evans::Evans;
use burmester::straight_line::no_design::NoDesign;
use burmester::straight_line::slider_crank::{Assembly, joints};
use burmester::straight_line::symmetric::Symmetric;
use burmester::straight_line::symmetrical::{Symmetrical, rays_of_d};
use burmester::straight_line::watt::Watt;
use proptest::prelude::*;
use rug::Rational;
use serde_json::{Value, json};

type N = Number<Surd>;

fn n(numerator: i64, denominator: i64) -> N {
    N::ratio(numerator, denominator)
}

/// By the tangent of half of the angle.
fn angle(numerator: i64, denominator: i64) -> Angle<Surd> {
    Angle::from_tan_half(&n(numerator, denominator))
}

fn ratio() -> impl Strategy<Value = N> {
    (-40i64..=40, 1i64..=12).prop_map(|(p, q)| n(p, q))
}

fn ray() -> impl Strategy<Value = Angle<Surd>> {
    (1i64..=40, 1i64..=12).prop_map(|(p, q)| angle(p, q))
}

/// The order of contact, where it is known exactly.
fn order(design: &Design<Surd>) -> usize {
    let contact = design.contact(8).unwrap();
    assert_eq!(contact.most, Some(contact.least), "{design:?}");
    contact.least
}

fn solve(design: Value) -> Value {
    let problem = json!({"problem": "straight-line", "design": design});
    let request = burmester::oracle::Request {
        digits: 12,
        ..Default::default()
    };
    let answer = burmester::oracle::solve(&problem, &request).unwrap();
    assert_eq!(answer.get("undecided"), None, "{problem}: {answer}");
    answer
}

fn float(value: &Value) -> f64 {
    let text = value.get("exact").or_else(|| value.get("value"));
    let text = text.and_then(Value::as_str).unwrap();
    burmester::number::text::parse_rational(text)
        .unwrap()
        .to_f64()
}

fn linkages(answer: &Value) -> Vec<&Value> {
    let solutions = answer["solutions"].as_array().unwrap().iter();
    solutions
        .flat_map(|one| one["linkages"].as_array().unwrap())
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn three_rays_give_five_points_on_the_line(a in ray(), b in ray(), d in ray()) {
        let Ok(cranks) = of_rays(&a, &b, &d) else { return Ok(()) };
        for alternate in Alternate::ALL {
            let Ok(design) = cranks.design(alternate) else { continue };
            prop_assert!(design.contact(6).is_none_or(|contact| contact.least >= 4));
            for cognate in design.cognates() {
                prop_assert!(cognate.contact(6).is_none_or(|contact| contact.least >= 4));
            }
        }
    }

    /// The two known rays put back: the same linkage from three rays as from k.
    #[test]
    fn a_slider_crank_is_the_linkage_of_its_rays(k in ratio(), a in ray(), d in ray()) {
        let linkage = SliderCrank { k, alpha_a: a.clone(), alpha_d: d.clone() };
        let Ok(cranks) = of_slider_crank(&linkage, &linkage.infinitely_near()) else { return Ok(()) };
        let Ok(design) = cranks.design(Alternate::First) else { return Ok(()) };
        let ray = &cranks.pairs[1].ray;
        if !ray.cis().has_value() { return Ok(()) }
        let again = of_rays(&a, ray, &d).and_then(|again| again.design(Alternate::First));
        if matches!(again, Err(NoDesign::Rays(_))) { return Ok(()) }
        let again = again.unwrap();
        for (x, y) in design.linkage.pivots.iter().zip(&again.linkage.pivots) {
            prop_assert!(!x.equals(y).is_no());
        }
    }

    /// By the conditions on five positions, of which four come together and one is apart: B and C are
    /// two of the four Burmester points, beside A and D.
    #[test]
    fn a_fifth_position_apart_has_the_pairs_of_mixed_positions(
        k in 1i64..=9, a in 1i64..=9, d in 1i64..=9, turn in 1i64..=9, sign in any::<bool>(),
    ) {
        prop_assume!(a != d);
        let (alpha_a, alpha_d) = (angle(a, 5), angle(d, 7));
        let linkage = SliderCrank { k: n(if sign { k } else { -k - 10 }, 4), alpha_a, alpha_d };
        let joints = joints(&linkage);
        // The crank turned by a rational angle; D then is where the rod meets the line, rational or not.
        let crank = (&joints.a - &joints.o_a) * angle(turn, 11).cis();
        let a = &joints.o_a + crank;
        let from = ((&a - &joints.d) * joints.direction.conj()).re().clone();
        let across = ((&a - &joints.d) * joints.direction.conj()).im().clone();
        let rest = (&joints.a - &joints.d).norm() - across.square();
        prop_assume!(rest.sign().is_some_and(std::cmp::Ordering::is_gt));
        let s = from - rest.sqrt();
        let near = |assembly| {
            let displaced = joints.displaced(&s, assembly).ok()?;
            (displaced.a.equals(&a).is_yes()).then_some(displaced)
        };
        let Some(displaced) = Assembly::ALL.into_iter().find_map(near) else { return Ok(()) };
        let Ok(cranks) = of_slider_crank(&linkage, &linkage.apart(&displaced.displacement)) else {
            return Ok(());
        };
        for pair in &cranks.pairs {
            let [z, m] = [&pair.point, &pair.center].map(|of| pair.ray.cis().scaled(&of.value()));
            let distance = (displaced.displacement.of(&z) - &m).norm() - (&z - &m).norm();
            prop_assert!(!distance.is_zero().is_no(), "{distance}");
        }
    }
}

#[test]
fn special_linkages_of_curvature_theory() {
    let of = |cranks: Result<_, NoDesign>, alternate| {
        cranks.and_then(
            |cranks: burmester::straight_line::ball_burmester::Cranks<Surd>| {
                cranks.design(alternate)
            },
        )
    };
    let [ab, bc, ca] = Alternate::ALL;
    assert_eq!(
        order(&of(double(&angle(3, 5), &angle(7, 2)), ab).unwrap()),
        4
    );
    for alternate in Alternate::ALL {
        let design = of(at_inflection_pole(&n(3, 7), &angle(2, 5)), alternate);
        assert_eq!(order(&design.unwrap()), 4);
        // Mirror symmetry adds a sixth point.
        assert_eq!(order(&of(equal_cranks(&n(3, 7)), alternate).unwrap()), 5);
    }
    let quadruple = || at_inflection_pole(&n(-4, 1), &angle(2, 5));
    assert_eq!(order(&of(quadruple(), ab).unwrap()), 4);
    for alternate in [bc, ca] {
        let reason = of(quadruple(), alternate).unwrap_err();
        assert_eq!(reason, NoDesign::PivotAtInfinity("C"));
    }
    let minus_one = of(at_inflection_pole(&n(-1, 1), &angle(2, 5)), ab);
    assert_eq!(minus_one.unwrap_err(), NoDesign::PinAtInfinity("A"));
    for k in [n(-3, 2), n(-5, 2)] {
        assert!(matches!(equal_cranks(&k), Err(NoDesign::NotReal(_))), "{k}");
    }
    let same = of_rays(&angle(1, 2), &angle(1, 3), &angle(1, 2));
    assert!(matches!(same, Err(NoDesign::Rays(_))));
}

#[test]
fn classical_linkages_have_the_contact_of_their_closure() {
    let watt = |gamma, sign, k| {
        let watt = Watt {
            r: n(1, 1),
            t: n(2, 1),
            gamma,
            n: sign,
            k: n(k, 3),
        };
        order(&watt.design().unwrap())
    };
    for sign in [1, -1] {
        for k in [0, 2] {
            assert_eq!(watt(angle(1, 3), sign, k), 2);
            assert_eq!(watt(angle(1, 1), sign, k), 3);
        }
    }
    let parallelogram = Watt {
        r: n(1, 1),
        t: n(1, 1),
        gamma: angle(1, 3),
        n: -1,
        k: n(0, 1),
    };
    assert!(matches!(parallelogram.design(), Err(NoDesign::NotReal(_))));
    let evans = |alpha, beta, omega| {
        let evans = Evans {
            alpha,
            beta,
            omega,
            rho: n(1, 3),
            k: n(9, 1),
        };
        order(&evans.design().unwrap())
    };
    assert_eq!(evans(angle(1, 2), angle(1, 7), angle(1, 5)), 0);
    // Centric and rectangular, in its central position.
    assert_eq!(evans(angle(1, 1), angle(0, 1), angle(0, 1)), 3);
    let conchoid = |alpha, n: i64| {
        let conchoid = Conchoid {
            r: N::ratio(1, 3),
            alpha,
            k: N::from(3),
            n,
        };
        order(&conchoid.design().unwrap())
    };
    for side in [1, -1] {
        assert_eq!(conchoid(angle(1, 4), side), 0);
        assert_eq!(conchoid(angle(0, 1), side), 3);
    }
    let symmetric = |a: i64, c: i64, d: i64| {
        let [a, c, d] = [a, c, d].map(N::from);
        order(&Symmetric { a, c, d }.design().unwrap())
    };
    // Chebyshev, 5 : 2 : 4, and Roberts.
    assert_eq!(symmetric(-2, 0, 4), 1);
    assert_eq!(symmetric(2, 3, 3), 1);
}

/// Tesar's figure 37.
#[test]
fn the_representative_linkage() {
    let answer = solve(json!({"kind": "ball-double-burmester",
        "alpha_a": {"degrees": "65"}, "alpha_b": {"degrees": "165"}}));
    let linkage = linkages(&answer)[0];
    let [q, r, s, t, m] = ["Q", "R", "S", "T", "M"].map(|name| float(&linkage[name]));
    for (found, printed) in [
        (q, 1.13015),
        (r, 0.39118),
        (s, 1.03814),
        (t, 1.53773),
        (m, 1.42187),
    ] {
        assert!((found / 0.693_218_22 - printed).abs() < 1e-5, "{found}");
    }
    assert_eq!(linkage["type"], "crank-and-lever");
    assert_eq!(linkage["contact"]["order"], 4);
}

/// At every solution all three alternates meet the line where they were asked to.
#[test]
fn six_points_on_the_line() {
    let crank = json!({"k": "0.9", "alpha_a": {"degrees": "72.5"}});
    let with = |more: Value| {
        let mut design = crank.clone();
        let fields = design.as_object_mut().unwrap();
        fields.extend(more.as_object().unwrap().clone());
        solve(design)
    };
    let range = |from: &str, to: &str| json!({"from": from, "to": to});
    for (more, here, there) in [
        (
            json!({"kind": "ball-burmester-intersection", "s": "0.5", "alpha_d": range("30", "40")}),
            4,
            vec![0],
        ),
        (
            json!({"kind": "ball-tangent", "s": "0.5", "alpha_d": range("20", "30")}),
            3,
            vec![1],
        ),
        (
            json!({"kind": "ball-two-intersections", "s": ["0.5", "-0.3"], "alpha_d": range("40", "50")}),
            3,
            vec![0, 0],
        ),
        (json!({"kind": "two-inflections"}), 2, vec![2]),
    ] {
        let answer = with(more.clone());
        assert_eq!(answer["unresolved"], json!([]), "{more}");
        let found = linkages(&answer);
        assert!(!found.is_empty(), "{more}");
        for linkage in found.iter().filter(|linkage| linkage.get("none").is_none()) {
            assert_eq!(linkage["contact"]["order"], here, "{more}");
            let places = linkage["places"].as_array().unwrap();
            let orders: Vec<_> = places
                .iter()
                .map(|place| place["contact"]["order"].clone())
                .collect();
            assert_eq!(json!(orders), json!(there), "{more}");
        }
    }
    let none = with(json!({"kind": "ball-tangent", "s": "9"}));
    assert!(none.get("none").is_some(), "{none}");
}

/// An intersection that comes near the Ball point: the linkages go over into those of five infinitely
/// near positions.
#[test]
fn an_intersection_goes_over_into_a_burmester_point() {
    let design = |kind: &str, s: Option<&str>| {
        let mut design = json!({"kind": kind, "k": "0.9", "alternate": "1,2",
            "alpha_a": {"degrees": "72.5"}, "alpha_d": {"degrees": "45"}});
        if let Some(s) = s {
            design["s"] = json!(s);
        }
        solve(design)
    };
    let limit = design("slider-crank", None);
    let limit = float(&limit["solutions"][0]["alpha_b"]["degrees"]);
    let nearest = |s: &str| {
        let answer = design("ball-intersection", Some(s));
        let solutions = answer["solutions"].as_array().unwrap().iter();
        let distances = solutions.map(|one| (float(&one["alpha_b"]["degrees"]) - limit).abs());
        distances.fold(f64::INFINITY, f64::min)
    };
    let [far, near] = [nearest("0.001"), nearest("0.00001")];
    assert!(far < 0.1 && near < far / 50.0, "{far} {near}");
}

/// Two intersections that come together become a tangent.
#[test]
fn two_intersections_go_over_into_a_tangent() {
    let of = |kind: &str, s: Value| {
        let answer = solve(
            json!({"kind": kind, "k": "0.9", "alpha_a": {"degrees": "72.5"}, "s": s,
            "alpha_d": {"from": "20", "to": "30"}}),
        );
        let solutions = answer["solutions"].as_array().unwrap().iter();
        let rays = solutions.map(|one| float(&one["alpha_d"]["degrees"]));
        rays.collect::<Vec<f64>>()
    };
    let tangent = of("ball-tangent", json!("0.5"));
    let near = of("ball-two-intersections", json!(["0.4999", "0.5001"]));
    assert!(tangent.len() == 1 && !near.is_empty());
    assert!(
        near.iter().any(|ray| (ray - tangent[0]).abs() < 1e-4),
        "{tangent:?} {near:?}"
    );
}

/// Where R = S = M the mirrored position has D mirrored, for every linkage of the family.
#[test]
fn a_symmetrical_curve_is_symmetrical() {
    let ball = |(p, q): (i64, i64)| Number::<Ball>::rounded(&Rational::from((p, q)), &200);
    let is_apart = |x: &Number<Ball>| {
        let near = Rational::from((1, 1_000_000_000_000i64));
        x.is_zero().is_no() || x.0.radius_rational().is_none_or(|radius| radius > near)
    };
    let vanishes = |x: Number<Ball>| assert!(!is_apart(&x), "{x}");
    let parameters = [
        ((9, 10), (3, 4), (1, 5)),
        ((6, 5), (1, 2), (-2, 3)),
        ((11, 10), (7, 9), (4, 1)),
    ];
    let mut tried = 0;
    for (k, a, half) in parameters {
        let (k, alpha_a) = (ball(k), Angle::from_tan_half(&ball(a)));
        let half = Angle::from_tan_half(&ball(half)).cis();
        let Ok(rays) = rays_of_d(&k, &alpha_a) else {
            continue;
        };
        for alpha_d in rays {
            tried += 1;
            let linkage = SliderCrank {
                k: k.clone(),
                alpha_a: alpha_a.clone(),
                alpha_d,
            };
            let design = Symmetrical::new(&linkage, &half).design().unwrap();
            let [_, (_, r), (_, s), _, (_, m), _] = design.squared_lengths();
            vanishes(&r - s);
            vanishes(r - m);
            let [o_a, o_b] = &design.linkage.pivots;
            let moved = design.to_mirrored();
            for (pivot, pin) in design.linkage.pivots.iter().zip(&design.linkage.pins) {
                vanishes((moved.of(pin) - pivot).norm() - (pin - pivot).norm());
            }
            let on_axis = o_a + (o_b - o_a) * &half;
            let mirrored = mirror(&design.linkage.point, o_a, &on_axis);
            vanishes((moved.of(&design.linkage.point) - mirrored).norm());
            let deviation = design.deviation(3).unwrap();
            vanishes(deviation.v.coefficient(1));
            vanishes(deviation.v.coefficient(2));
        }
    }
    assert!(tried > 2, "{tried}");
}

/// A guide that is none is said to be none, not that no angle will do.
#[test]
fn a_guide_without_crank_says_why() {
    let with = |kind: &str, k: &str, alpha_a: &str| {
        let answer =
            solve(json!({"kind": kind, "k": k, "alpha_a": {"degrees": alpha_a}, "s": "0.5"}));
        answer["none"].as_str().unwrap().to_owned()
    };
    for kind in ["ball-tangent", "ball-burmester-intersection"] {
        assert_eq!(
            with(kind, "-1", "30"),
            NoDesign::PinAtInfinity("A").to_string()
        );
        assert_eq!(with(kind, "0", "30"), NoDesign::NoLength("A").to_string());
        assert_eq!(with(kind, "2", "0"), NoDesign::NoLength("A").to_string());
    }
    let one_pivot = solve(json!({"kind": "symmetric", "a": "0", "c": "1", "d": "1"}));
    assert_eq!(one_pivot["none"], NoDesign::OnePivot.to_string());
}
