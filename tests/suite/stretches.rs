//! Stretches of the centerpoint curve that fulfil wishes, against a direct judgement of single pairs: the
//! curve by another parametrisation, the circlepoint from three places, angles and motions in floats,
//! with a margin.
#![expect(
    clippy::unwrap_used,
    clippy::as_conversions,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test that cannot compute what it tests has failed"
)]

use crate::support::positions;
use std::f64::consts::{PI, TAU};

use crate::support::positions::{Position, degenerate, four_positions};
use burmester::number::text::parse_rational;
use burmester::number::{Complex, Exact, Number};
use burmester::oracle::{Request, solve};
use burmester::plane::circular_cubic::Cubic;
use burmester::plane::curve_type::CurveType;
use burmester::plane::focal_cubic::FocalCubic;
use burmester::plane::trace::{Branch, Trace};
use proptest::test_runner::{Config, TestRunner};
use serde_json::{Value, json};

type Z = Number<Complex<f64>>;

/// What is to be told of a pair: surely, or nothing because it is close to a limit.
type Verdict = Option<bool>;

const MARGIN: f64 = 1e-6;

fn z(x: f64, y: f64) -> Z {
    Number::complex(Number(x), Number(y))
}

fn abs(point: &Z) -> f64 {
    point.norm().0.sqrt()
}

fn parts(point: &Z) -> [f64; 2] {
    [point.re().0, point.im().0]
}

fn angle(point: &Z) -> f64 {
    let [x, y] = parts(point);
    y.atan2(x)
}

fn rational(x: &Number<Exact>) -> String {
    x.0.rational().unwrap().to_string()
}

fn problem(positions: &[Position], wishes: &Value) -> Value {
    let pose = |d: &Position| {
        json!({
            "x": rational(d.translation.re()),
            "y": rational(d.translation.im()),
            "angle": {"cos": rational(d.rotation.re()), "sin": rational(d.rotation.im())},
        })
    };
    let list: Vec<Value> = positions.iter().map(pose).collect();
    json!({"problem": "centerpoint-curve", "positions": list, "wishes": wishes})
}

fn answered(positions: &[Position], wishes: &Value) -> Value {
    let request = Request {
        digits: 15,
        ..Request::default()
    };
    solve(&problem(positions, wishes), &request).unwrap()
}

fn float(value: &Value) -> f64 {
    let text = value
        .get("exact")
        .or_else(|| value.get("value"))
        .unwrap_or(value);
    parse_rational(text.as_str().unwrap()).unwrap().to_f64()
}

fn finite(value: &Value) -> Option<Z> {
    let list = value.as_array()?;
    Some(z(float(&list[0]), float(&list[1])))
}

/// The circlepoint of a center, by the places of the center in the moving plane: of all circles through
/// three the one that is known best.
fn circlepoint(positions: &[[Z; 2]], center: &Z) -> Option<Z> {
    let places: Vec<Z> = positions
        .iter()
        .map(|[r, t]| (center - t) * r.conj())
        .collect();
    let mut best: Option<(f64, Z)> = None;
    for [i, j, k] in [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]] {
        let (u, v) = (&places[j] - &places[i], &places[k] - &places[i]);
        let area = u.conj() * &v - &u * v.conj();
        let size = abs(&u) * abs(&v) * abs(&(&u - &v));
        let quality = abs(&area) / size.cbrt().powi(2);
        if quality.is_finite() && best.as_ref().is_none_or(|(least, _)| quality > *least) {
            best = Some((quality, &places[i] + &u * &v * (&u - &v).conj() / area));
        }
    }
    best.filter(|(quality, _)| *quality > 1e-4)
        .map(|(_, point)| point)
}

/// A number that should be positive.
fn positive(x: f64, size: f64) -> Verdict {
    (x.abs() > MARGIN * size).then_some(x > 0.0)
}

fn both(a: Verdict, b: Verdict) -> Verdict {
    match (a, b) {
        (Some(false), _) | (_, Some(false)) => Some(false),
        (Some(true), Some(true)) => Some(true),
        _ => None,
    }
}

fn within(region: Option<&Value>, point: &Z) -> Verdict {
    let Some(region) = region else {
        return Some(true);
    };
    let [x, y] = parts(point);
    if let Some(circle) = region.get("circle") {
        let center = finite(&circle["center"]).unwrap();
        let radius = float(&circle["radius"]);
        return positive(radius - abs(&(point - center)), radius);
    }
    if let Some(corners) = region.get("box") {
        let [p, q] = [0, 1].map(|k| parts(&finite(&corners[k]).unwrap()));
        let side = |x: f64, a: f64, b: f64| {
            let (low, high) = (a.min(b), a.max(b));
            positive((x - low).min(high - x), high - low)
        };
        return both(side(x, p[0], q[0]), side(y, p[1], q[1]));
    }
    // The angles under which the sides are seen add up to a turn or to nothing.
    let corners: Vec<Z> = region["polygon"]
        .as_array()
        .unwrap()
        .iter()
        .map(|corner| finite(corner).unwrap())
        .collect();
    let mut sum = 0.0;
    for (place, corner) in corners.iter().enumerate() {
        let next = &corners[(place + 1) % corners.len()];
        let seen = angle(&((next - point) * (corner - point).conj()));
        if seen.abs() > PI - 1e-4 {
            return None;
        }
        sum += seen;
    }
    Some(sum.abs() > PI)
}

/// Angles that go on in one direction by less than a turn in all.
fn one_way(angles: &[f64]) -> Verdict {
    let steps = |sign: f64| -> Verdict {
        let mut sum = 0.0;
        for pair in angles.windows(2) {
            let step = (sign * (pair[1] - pair[0])).rem_euclid(TAU);
            if !(1e-6..=TAU - 1e-6).contains(&step) {
                return None;
            }
            sum += step;
        }
        positive(TAU - sum, 1.0)
    };
    either(steps(1.0), steps(-1.0))
}

fn either(a: Verdict, b: Verdict) -> Verdict {
    both(a.map(|a| !a), b.map(|b| !b)).map(|neither| !neither)
}

/// Whether the four-bar goes from position to position, driven at its first pivot one way, without being
/// taken apart: the driven joint stays on its side and is always reached.
fn moves_through(pivots: &[Z; 2], joints: &[[Z; 2]]) -> Verdict {
    let [p, q] = pivots;
    let [a, b] = &joints[0];
    let (crank, coupler, driven) = (abs(&(a - p)), abs(&(b - a)), abs(&(b - q)));
    let base = abs(&(q - p));
    let size = crank + coupler + driven + base;
    let mut truth = Some(true);
    let side = |[a, b]: &[Z; 2]| ((b - a).conj() * (q - a)).im().0;
    for joint in joints {
        let same = positive(side(joint) * side(&joints[0]), size.powi(4));
        truth = both(truth, same);
    }
    let angles: Vec<f64> = joints
        .iter()
        .map(|[a, _]| angle(&((a - p) * (q - p).conj())))
        .collect();
    // Between two positions the distance of the driving joint from the other pivot is greatest or least
    // where it passes the base.
    let reached = |distance: f64| {
        let spare = (driven + coupler - distance).min(distance - (driven - coupler).abs());
        positive(spare, size)
    };
    let swept = |sign: f64| -> Verdict {
        let start = (sign * angles[0]).rem_euclid(TAU);
        let mut end = start;
        let mut truth = Some(true);
        for pair in angles.windows(2) {
            let step = (sign * (pair[1] - pair[0])).rem_euclid(TAU);
            if !(1e-6..=TAU - 1e-6).contains(&step) {
                return None;
            }
            end += step;
        }
        truth = both(truth, positive(start + TAU - end, 1.0));
        for half_turns in 1..4 {
            let passed = f64::from(half_turns) * PI;
            if start < passed && passed < end {
                let inner = half_turns % 2 == 0;
                let distance = if inner {
                    (base - crank).abs()
                } else {
                    base + crank
                };
                truth = both(truth, reached(distance));
            }
        }
        truth
    };
    both(truth, either(swept(1.0), swept(-1.0)))
}

fn turns_fully(pivots: &[Z; 2], joints: &[[Z; 2]]) -> Verdict {
    let [p, q] = pivots;
    let [a, b] = &joints[0];
    let (crank, coupler, driven) = (abs(&(a - p)), abs(&(b - a)), abs(&(b - q)));
    let base = abs(&(q - p));
    // In both places on the base line the driven joint is reached.
    let size = crank + coupler + driven + base;
    let spare = |d: f64| (driven + coupler - d).min(d - (driven - coupler).abs());
    both(
        positive(spare((base - crank).abs()), size),
        positive(spare(base + crank), size),
    )
}

/// Whether all positions are on one branch and |cos γ| stays below a bound while the link at the first
/// pivot drives from each to each, or turns fully.
fn transmits(pivots: &[Z; 2], joints: &[[Z; 2]], bound: f64) -> Verdict {
    let [p, q] = pivots;
    let [a, b] = &joints[0];
    let (crank, coupler, driven) = (abs(&(a - p)), abs(&(b - a)), abs(&(b - q)));
    let base = abs(&(q - p));
    let size = crank + coupler + driven + base;
    let side = |[a, b]: &[Z; 2]| ((b - a).conj() * (q - a)).im().0;
    let mut truth = Some(true);
    for joint in joints {
        let same = positive(side(joint) * side(&joints[0]), size.powi(4));
        truth = both(truth, same);
    }
    let spare = |f: f64| (driven + coupler - f).min(f - (driven - coupler).abs());
    let gates = [(base - crank).abs(), base + crank];
    let [Some(inner), Some(outer)] = gates.map(|f| positive(spare(f), size)) else {
        return None;
    };
    // From the direction of the base, or against it: from an open gate if there is one.
    let middle = if inner { q - p } else { p - q };
    let angles = joints
        .iter()
        .map(|[a, _]| angle(&((a - p) * middle.conj())));
    let (least, greatest) = angles.fold((PI, -PI), |(low, high), x| (low.min(x), high.max(x)));
    let crossed = positive(-least * greatest, 1.0)?;
    let mut distances: Vec<f64> = joints.iter().map(|[a, _]| abs(&(q - a))).collect();
    match (inner, outer) {
        (true, true) => distances.extend(gates),
        (false, false) if crossed => return Some(false),
        (true, false) if crossed => distances.push(gates[0]),
        (false, true) if crossed => distances.push(gates[1]),
        _ => {}
    }
    for f in distances {
        let cosine = (coupler * coupler + driven * driven - f * f) / (2.0 * coupler * driven);
        truth = both(truth, positive(bound - cosine.abs(), 1.0));
    }
    truth
}

fn fulfilled(wishes: &Value, positions: &[[Z; 2]], center: &Z, circlepoint: &Z) -> Verdict {
    let mut truth = both(
        within(wishes.get("pivots_within"), center),
        within(wishes.get("circlepoints_within"), circlepoint),
    );
    let places = |point: &Z| -> Vec<Z> { positions.iter().map(|[r, t]| r * point + t).collect() };
    let asked = |name: &str| wishes.get(name) == Some(&json!(true));
    if asked("in_order") {
        let angles: Vec<f64> = places(circlepoint)
            .iter()
            .map(|place| angle(&(place - center)))
            .collect();
        truth = both(truth, one_way(&angles));
    }
    if let Some(given) = wishes.get("beside") {
        let first = places(&finite(&given["circlepoint"]).unwrap());
        let second = places(circlepoint);
        let mut pivots = [finite(&given["center"]).unwrap(), center.clone()];
        let mut joints: Vec<[Z; 2]> = first.into_iter().zip(second).map(|(a, b)| [a, b]).collect();
        if wishes.get("driver") == Some(&json!("sought")) {
            pivots.reverse();
            joints.iter_mut().for_each(|pair| pair.reverse());
        }
        if asked("crank_driven") {
            truth = both(truth, turns_fully(&pivots, &joints));
        }
        if asked("without_defects") {
            truth = both(truth, moves_through(&pivots, &joints));
        }
        if let Some(least) = wishes.get("least_transmission_angle") {
            let bound = float(&least["degrees"]).to_radians().cos();
            truth = both(truth, transmits(&pivots, &joints, bound));
        }
    }
    truth
}

/// A branch as a closed row of pairs, infinite ones included.
struct Row {
    centers: Vec<[f64; 3]>,
    circlepoints: Vec<Option<Z>>,
}

const STEPS: usize = 360;

fn rows(answer: &Value, positions: &[[Z; 2]]) -> Option<Vec<Row>> {
    let curve = &answer["centerpoint"];
    let kind = match curve["type"].as_str()? {
        "one-branch" => CurveType::OneBranch,
        "two-branches" => CurveType::TwoBranches,
        "nodal" => CurveType::Nodal,
        _ => return None,
    };
    let list = curve["coefficients"].as_array()?;
    let largest = list.iter().map(|c| float(c).abs()).fold(0.0, f64::max);
    let cubic = Cubic::new(std::array::from_fn(|k| Number(float(&list[k]) / largest)));
    let trace = Trace::new(FocalCubic::of(&cubic)?, kind)?;
    let row = |branch: &Branch| {
        let whole = if *branch == Branch::Only { TAU } else { PI };
        let centers: Vec<[f64; 3]> = (0..STEPS)
            .map(|step| {
                // Not in the places with a meaning.
                let angle = whole * (step as f64 + 0.37) / STEPS as f64;
                // The trace turns round in a node, a stretch goes straight on.
                let turns = kind == CurveType::Nodal && angle > PI;
                let angle = if turns { 3.0 * PI - angle } else { angle };
                let point = trace.point(*branch, &z(angle.cos(), angle.sin()));
                point.coordinates().each_ref().map(|x| x.0)
            })
            .collect();
        let circlepoints = centers
            .iter()
            .map(|[x, y, w]| circlepoint(positions, &z(x / w, y / w)))
            .collect();
        Row {
            centers,
            circlepoints,
        }
    };
    Some(trace.branches().iter().map(row).collect())
}

impl Row {
    /// The place that is nearest to a pair; the circlepoint tells apart what is close for centers only.
    fn nearest(&self, center: &Value, circlepoint: &Value) -> usize {
        let place = |point: &Value| {
            let infinite = point.get("at_infinity").is_some();
            (!infinite).then(|| finite(point).unwrap())
        };
        let (center, circlepoint) = (place(center), place(circlepoint));
        let distance = |k: &usize| {
            let [x, y, w] = self.centers[*k];
            let of_center = match &center {
                None => return w.abs() / x.hypot(y),
                Some(center) => abs(&(z(x / w, y / w) - center)) / (1.0 + abs(center)),
            };
            match (&circlepoint, &self.circlepoints[*k]) {
                (Some(expected), Some(found)) => {
                    of_center.hypot(abs(&(found - expected)) / (1.0 + abs(expected)))
                }
                _ => of_center,
            }
        };
        let order = |a: &usize, b: &usize| distance(a).total_cmp(&distance(b));
        (0..STEPS).min_by(order).unwrap()
    }
}

/// Where a stretch is on its row: surely inside, surely not, or near an end.
fn covers(stretch: &Value, row: &Row) -> Vec<Verdict> {
    if stretch["closed"] == json!(true) {
        return vec![Some(true); STEPS];
    }
    let end = |name: &str| row.nearest(&stretch[name], &stretch[format!("circlepoint_{name}")]);
    let (from, to) = (end("from"), end("to"));
    let sample = &stretch["sample"];
    let inside = row.nearest(&sample["center"], &sample["circlepoint"]);
    let way = |a: usize, b: usize| (b + STEPS - a) % STEPS;
    let (first, last) = if way(from, inside) <= way(from, to) {
        (from, to)
    } else {
        (to, from)
    };
    let length = way(first, last);
    let near = |k: usize, end: usize| way(k, end).min(way(end, k)) <= 3;
    (0..STEPS)
        .map(|k| {
            if near(k, from) || near(k, to) {
                None
            } else if near(from, to) {
                // Nothing, or everything: too small to tell.
                (!near(inside, from)).then_some(true)
            } else {
                Some(way(first, k) < length)
            }
        })
        .collect()
}

/// Compares all places of all branches; how many were inside and outside.
fn compare(positions: &[Position], wishes: &Value) -> [usize; 2] {
    let answer = answered(positions, wishes);
    let floats: Vec<[Z; 2]> = positions
        .iter()
        .map(|d| {
            [&d.rotation, &d.translation].map(|point| {
                let part = |x: &Number<Exact>| x.0.rational().unwrap().to_f64();
                z(part(point.re()), part(point.im()))
            })
        })
        .collect();
    let Some(rows) = rows(&answer, &floats) else {
        let named = answer["undecided"].as_str().unwrap_or_default();
        assert!(
            answer["stretches"].is_null() && named.contains("stretches"),
            "{answer}"
        );
        return [0, 0];
    };
    let stretches = answer["stretches"]
        .as_array()
        .unwrap_or_else(|| panic!("{answer}"));
    let mut count = [0, 0];
    for (row, branch) in rows.iter().zip(1..) {
        let of_branch = stretches
            .iter()
            .filter(|stretch| stretch["branch"] == json!(branch));
        let all: Vec<Vec<Verdict>> = of_branch.map(|stretch| covers(stretch, row)).collect();
        for k in 0..STEPS {
            let mut inside = Some(false);
            for covered in &all {
                inside = either(inside, covered[k]);
            }
            let [x, y, w] = row.centers[k];
            let center = z(x / w, y / w);
            let Some(circlepoint) = &row.circlepoints[k] else {
                continue;
            };
            let expected = fulfilled(wishes, &floats, &center, circlepoint);
            if let (Some(inside), Some(expected)) = (inside, expected) {
                assert_eq!(
                    inside,
                    expected,
                    "branch {branch}, place {k}, center {center:?}, circlepoint {circlepoint:?} of {}",
                    problem(positions, wishes)
                );
                count[usize::from(!inside)] += 1;
            }
        }
    }
    count
}

fn cases(count: u32, mut check: impl FnMut([Position; 4], u8, [i64; 4]) -> [usize; 2]) {
    let strategy = (
        four_positions(),
        0u8..8,
        [-9i64..9, -9i64..9, 3i64..12, 3i64..12],
    );
    let mut runner = TestRunner::new_with_rng(
        Config::with_cases(count),
        proptest::test_runner::TestRng::deterministic_rng(
            proptest::test_runner::RngAlgorithm::ChaCha,
        ),
    );
    let total = std::cell::RefCell::new([0, 0]);
    let check = std::cell::RefCell::new(&mut check);
    runner
        .run(&strategy, |(positions, choice, numbers)| {
            let count = (check.borrow_mut())(positions, choice, numbers);
            let mut total = total.borrow_mut();
            total[0] += count[0];
            total[1] += count[1];
            Ok(())
        })
        .unwrap();
    let [inside, outside] = *total.borrow();
    assert!(
        inside > 100 && outside > 100,
        "{inside} places inside, {outside} outside"
    );
}

#[test]
fn regions_and_order() {
    cases(20, |positions, choice, [x, y, w, h]| {
        let rectangle = json!({"box": [
            [x.to_string(), y.to_string()], [(x + w).to_string(), (y - h).to_string()],
        ]});
        let circle = json!({"circle": {
            "center": [format!("{y}/3"), format!("{x}/3")], "radius": format!("{w}/2"),
        }});
        let polygon = json!({"polygon": [
            [x.to_string(), y.to_string()], [(x + w).to_string(), y.to_string()],
            [format!("{}/4", 4 * x + w), format!("{}/4", 4 * y + h)],
            [x.to_string(), (y + h).to_string()],
        ]});
        let wishes = match choice {
            0 => json!({"pivots_within": rectangle}),
            1 => json!({"circlepoints_within": rectangle}),
            2 => json!({"pivots_within": circle}),
            3 => json!({"circlepoints_within": circle}),
            4 => json!({"pivots_within": polygon}),
            5 => json!({"in_order": true}),
            6 => json!({"pivots_within": circle, "circlepoints_within": rectangle}),
            _ => json!({"in_order": true, "circlepoints_within": polygon}),
        };
        compare(&positions, &wishes)
    });
}

/// A rational pair: a pole is a center, and its circlepoint the center of its places in the moving plane.
fn beside(positions: &[Position; 4]) -> Option<Value> {
    let pole = positions[0].projective_pole(&positions[1]).finite()?;
    let places = positions.each_ref().map(|d| d.inverse().of(&pole));
    let (u, v) = (&places[2] - &places[0], &places[3] - &places[0]);
    let area = u.conj() * &v - &u * v.conj();
    if !area.is_zero().is_no() {
        return None;
    }
    let circlepoint = &places[0] + &u * &v * (&u - &v).conj() / area;
    let shown =
        |point: &Number<Complex<Exact>>| json!([rational(point.re()), rational(point.im())]);
    Some(json!({"circlepoint": shown(&circlepoint), "center": shown(&pole)}))
}

#[test]
fn linkages() {
    cases(18, |positions, choice, _| {
        let Some(given) = beside(&positions) else {
            return [0, 0];
        };
        let driver = if choice % 2 == 0 { "given" } else { "sought" };
        let wishes = match choice / 2 {
            0 => json!({"beside": given, "driver": driver, "crank_driven": true}),
            1 | 2 => json!({"beside": given, "driver": driver, "without_defects": true}),
            _ => json!({
                "beside": given, "driver": driver, "without_defects": true, "crank_driven": true,
                "in_order": true,
            }),
        };
        compare(&positions, &wishes)
    });
}

#[test]
fn transmission_angles() {
    cases(14, |positions, choice, [_, _, degrees, _]| {
        let Some(given) = beside(&positions) else {
            return [0, 0];
        };
        let driver = if choice % 2 == 0 { "given" } else { "sought" };
        // The square of the cosine of 30° is rational, of 10° not.
        let degrees = if [1, 4].contains(&choice) {
            30
        } else {
            degrees
        };
        let mut wishes = json!({
            "beside": given, "driver": driver,
            "least_transmission_angle": {"degrees": degrees.to_string()},
        });
        if choice % 4 == 0 {
            wishes["without_defects"] = json!(true);
        }
        compare(&positions, &wishes)
    });
}

#[test]
fn degenerate_positions_are_named() {
    for case in degenerate() {
        let wishes = json!({
            "pivots_within": {"box": [["-7", "-5"], ["6", "5"]]}, "in_order": true,
        });
        eprintln!("{}", case.name);
        compare(&case.positions, &wishes);
    }
}

/// All ends as numbers, each stretch with the lesser end first.
fn ends(answer: &Value, map: impl Fn(Z) -> Z) -> Vec<[[f64; 2]; 2]> {
    let end = |value: &Value| finite(value).map_or([f64::INFINITY; 2], |point| parts(&map(point)));
    let mut list: Vec<[[f64; 2]; 2]> = answer["stretches"]
        .as_array()
        .unwrap()
        .iter()
        .map(|stretch| {
            let mut pair = [end(&stretch["from"]), end(&stretch["to"])];
            pair.sort_by(|a, b| a.partial_cmp(b).unwrap());
            pair
        })
        .collect();
    list.sort_by(|a, b| a.partial_cmp(b).unwrap());
    list
}

fn assert_same(a: &[[[f64; 2]; 2]], b: &[[[f64; 2]; 2]]) {
    assert_eq!(a.len(), b.len(), "{a:?} {b:?}");
    for (x, y) in a
        .iter()
        .flatten()
        .flatten()
        .zip(b.iter().flatten().flatten())
    {
        let close = x == y || (x - y).abs() < 1e-9 * (1.0 + x.abs());
        assert!(close, "{a:?} {b:?}");
    }
}

#[test]
fn renumbering_mirroring_and_scaling_map_stretches() {
    let position =
        |x: i64, y: i64, n: i64| positions::position(positions::turn(n, 7), positions::point(x, y));
    let positions = [
        position(0, 0, 0),
        position(4, 1, 2),
        position(7, 3, 5),
        position(9, -2, 9),
    ];
    let wishes = json!({
        "in_order": true,
        "pivots_within": {"box": [["-20", "-19"], ["18", "17"]]},
        "circlepoints_within": {"circle": {"center": ["1", "-2"], "radius": "25"}},
    });
    let answer = answered(&positions, &wishes);
    let plain = ends(&answer, |point| point);
    assert!(!plain.is_empty(), "{answer}");
    let [a, b, c, d] = positions.clone();
    for renumbered in [
        [b.clone(), c.clone(), d.clone(), a.clone()],
        [d.clone(), c.clone(), b.clone(), a.clone()],
    ] {
        assert_same(
            &plain,
            &ends(&answered(&renumbered, &wishes), |point| point),
        );
    }
    let mirrored = positions.each_ref().map(|d| Position {
        rotation: d.rotation.conj(),
        translation: d.translation.conj(),
    });
    let mirrored_wishes = json!({
        "in_order": true,
        "pivots_within": {"box": [["-20", "19"], ["18", "-17"]]},
        "circlepoints_within": {"circle": {"center": ["1", "2"], "radius": "25"}},
    });
    assert_same(
        &plain,
        &ends(&answered(&mirrored, &mirrored_wishes), |point| point.conj()),
    );
    let scale = positions::number(1, 1_000_000_000) * positions::number(1, 1_000_000_000);
    let scaled = positions.each_ref().map(|d| Position {
        rotation: d.rotation.clone(),
        translation: d.translation.scaled(&scale),
    });
    let scaled_wishes = json!({
        "in_order": true,
        "pivots_within": {"box": [["-20e-18", "-19e-18"], ["18e-18", "17e-18"]]},
        "circlepoints_within": {"circle": {"center": ["1e-18", "-2e-18"], "radius": "25e-18"}},
    });
    let back = |point: Z| point.scaled(&Number(1e18));
    assert_same(&plain, &ends(&answered(&scaled, &scaled_wishes), back));
}

#[test]
fn a_wish_that_all_fulfil_leaves_whole_branches() {
    let position =
        |x: i64, y: i64, n: i64| positions::position(positions::turn(n, 2), positions::point(x, y));
    // The closed branch has all its circlepoints finite, or is cut where one is not.
    let positions = [
        position(0, 0, 0),
        position(3, 1, 1),
        position(5, -1, -4),
        position(2, 4, -6),
    ];
    let far = json!({"pivots_within": {"circle": {"center": ["0", "0"], "radius": "1e9"}}});
    let answer = answered(&positions, &far);
    let stretches = answer["stretches"].as_array().unwrap();
    assert!(stretches.iter().any(|one| one["branch"] == json!(1)));
    let all = answered(&positions, &json!({}));
    for one in all["stretches"].as_array().unwrap() {
        let infinite = |name: &str| one[name].get("at_infinity").is_some();
        let cut = ["from", "circlepoint_from"].into_iter().any(infinite);
        assert!(cut || one["closed"] == json!(true), "{one}");
    }
}

#[test]
fn wrong_wishes_are_refused_with_their_place() {
    let position =
        |x: i64, y: i64, n: i64| positions::position(positions::turn(n, 2), positions::point(x, y));
    let positions = [
        position(0, 0, 0),
        position(3, 1, 1),
        position(5, -1, -4),
        position(2, 4, -6),
    ];
    for (wishes, expected) in [
        (json!([]), "wishes: an object was expected"),
        (
            json!({"least_transmission_angle": {"degrees": 40}}),
            "wishes.least_transmission_angle: this needs a link",
        ),
        (json!({"least_angle": {"degrees": 40}}), "unknown field"),
        (
            json!({"crank_driven": true}),
            "wishes.crank_driven: this needs a link",
        ),
        (json!({"pivots_within": {}}), "one of box, circle, polygon"),
        (
            json!({"pivots_within": {"box": [["0", "0"], ["0", "1"]]}}),
            "no inside",
        ),
        (
            json!({"pivots_within": {"box": [["0", "0"]]}}),
            "two opposite corners",
        ),
        (
            json!({"circlepoints_within": {"circle": {"center": ["0", "0"], "radius": "-1"}}}),
            "positive",
        ),
        (
            json!({"pivots_within": {"polygon": [["0","0"],["2","2"],["2","0"],["0","2"]]}}),
            "the polygon meets itself",
        ),
        (
            json!({"beside": {"circlepoint": ["1", "0"], "center": ["0", "0"]}}),
            "wishes.beside: the circlepoint must be equally far",
        ),
        (json!({"in_order": 1}), "true or false"),
    ] {
        let error = solve(&problem(&positions, &wishes), &Request::default()).unwrap_err();
        assert!(error.to_string().contains(expected), "{error}");
    }
}
