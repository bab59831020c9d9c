//! Four positions: the routes to both curves agree, and the curves are what they are said to be.
#![allow(
    clippy::unwrap_used,
    clippy::as_conversions,
    clippy::indexing_slicing,
    clippy::expect_used,
    clippy::panic,
    clippy::needless_range_loop,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use crate::support::positions::{
    Position, degenerate, four_positions, from_quadrilateral, point, points, turns, with_poles,
};
use burmester::finite::four_positions::{
    circle_conditions, isotropic, loop_closure, viewing_angles,
};
use burmester::finite::positions::{OPPOSITE_POLES, Positions};
use burmester::finite::three_positions::{center, circlepoint};
use burmester::number::poly::{Fraction, Ring};
use burmester::number::{Ball, Exact, Number, Truth};
use burmester::plane::circular_cubic::Cubic;
use burmester::plane::curve_type::{CurveType, curve_type};
use burmester::plane::focal_cubic::FocalCubic;
use burmester::plane::inflexions::real_inflexions;
use burmester::plane::projective::{ProjectivePoint, collinear};
use burmester::plane::quadrilateral::{product_of_sums, squared_sides, u_vs_z};
use burmester::plane::trace::Trace;
use burmester::plane::{Angle, Point};
use proptest::prelude::*;

type Curves = [(&'static str, Cubic<Exact>); 4];

fn centerpoint_cubics(four: &[Position; 4]) -> Curves {
    let poles = with_poles(four);
    [
        (
            "circle conditions",
            circle_conditions::centerpoint_cubic(four).unwrap(),
        ),
        (
            "loop closure",
            loop_closure::centerpoint_cubic(four).unwrap(),
        ),
        (
            "viewing angles",
            viewing_angles::centerpoint_cubic(&poles).unwrap(),
        ),
        ("isotropic", isotropic::centerpoint_cubic(&poles).unwrap()),
    ]
}

fn circlepoint_cubics(four: &[Position; 4]) -> Curves {
    let poles = with_poles(four);
    [
        (
            "circle conditions",
            circle_conditions::circlepoint_cubic(four).unwrap(),
        ),
        (
            "loop closure",
            loop_closure::circlepoint_cubic(four).unwrap(),
        ),
        (
            "viewing angles",
            viewing_angles::circlepoint_cubic(&poles).unwrap(),
        ),
        ("isotropic", isotropic::circlepoint_cubic(&poles).unwrap()),
    ]
}

fn is_zero(cubic: &Cubic<Exact>) -> bool {
    cubic.coefficients().iter().all(|c| c.is_zero().is_yes())
}

/// Equal up to a factor that is not zero.
fn proportional(a: &Cubic<Exact>, b: &Cubic<Exact>) -> bool {
    let (a, b) = (a.coefficients(), b.coefficients());
    let Some(place) = a.iter().position(|c| c.is_zero().is_no()) else {
        return b.iter().all(|c| c.is_zero().is_yes());
    };
    b[place].is_zero().is_no()
        && (0..10).all(|i| (&a[i] * &b[place]).equals(&(&b[i] * &a[place])).is_yes())
}

fn assert_one_curve(curves: &Curves, what: &str) {
    for (name, curve) in &curves[1..] {
        assert!(
            proportional(&curves[0].1, curve),
            "{what}: {} and {name} differ: {:?} and {:?}",
            curves[0].0,
            curves[0].1.coefficients(),
            curve.coefficients()
        );
    }
}

proptest! {
    #[test]
    fn all_routes_give_the_same_curves(four in four_positions()) {
        assert_one_curve(&centerpoint_cubics(&four), "centerpoint");
        assert_one_curve(&circlepoint_cubics(&four), "circlepoint");
    }

    /// The routes take the first quadrilateral of poles, or a part of one; by renumbering, all three.
    #[test]
    fn all_routes_give_the_same_curves_of_any_quadrilateral(
        vertices in [points(), points(), points(), points()],
    ) {
        let neighbours_differ = (0..4).all(|i| {
            vertices[i].equals(&vertices[(i + 1) % 4]).is_no()
                && vertices[i].equals(&vertices[(i + 2) % 4]).is_no()
        });
        prop_assume!(neighbours_differ);
        let four = from_quadrilateral(&vertices);
        let poles = with_poles(&four);
        // A vertex D on a side AB or BC leaves two positions equal.
        prop_assume!(OPPOSITE_POLES[0].iter().all(|(i, j)| {
            poles.pole(*i, *j).unwrap().is_determined().is_yes()
        }));
        for (vertex, (i, j)) in vertices.iter().zip(OPPOSITE_POLES[0]) {
            prop_assert!(poles.pole(i, j).unwrap().equals(&ProjectivePoint::from_finite(vertex)).is_yes());
        }
        let curves = centerpoint_cubics(&four);
        assert_one_curve(&curves, "centerpoint");
        assert_one_curve(&circlepoint_cubics(&four), "circlepoint");
        prop_assert!(proportional(&curves[0].1, &Cubic::focal(&vertices).unwrap()), "focal cubic");
    }

    /// Points that are rational: third intersections of lines through poles.
    #[test]
    fn a_point_of_the_curve_has_a_circlepoint_and_back(
        four in four_positions(), first in 0usize..6, second in 0usize..6,
    ) {
        let curve = centerpoint_cubics(&four)[0].1.clone();
        prop_assume!(!is_zero(&curve) && first != second);
        let poles = with_poles(&four);
        let pole = |n: usize| {
            let (i, j) = poles.pairs().nth(n).unwrap();
            poles.pole(i, j).unwrap()
        };
        let (p, q) = (pole(first), pole(second));
        prop_assert!(curve.at_projective(&p).is_zero().is_yes(), "a pole is on the curve");
        prop_assume!(p.finite().is_some() && q.finite().is_some());
        let (p, q) = (p.finite().unwrap(), q.finite().unwrap());
        prop_assume!(p.equals(&q).is_no());
        let Some(center_) = third_point(&curve, &p, &q) else { return Ok(()) };
        let partner = circlepoint(&four, &center_);
        prop_assume!(partner.finite().is_some());
        let partner = partner.finite().unwrap();
        let distances = four.each_ref().map(|d| (d.of(&partner) - &center_).norm());
        prop_assert!(distances.iter().all(|d| d.equals(&distances[0]).is_yes()), "one circle");
        prop_assert!(circlepoint_cubics(&four)[0].1.at(&partner).is_zero().is_yes());
        let back = center(&four, &partner);
        if back.is_determined().is_yes() {
            prop_assert!(back.equals(&ProjectivePoint::from_finite(&center_)).is_yes(), "and back");
        }
    }

    #[test]
    fn a_point_off_the_curve_has_no_circlepoint(four in four_positions(), z in points()) {
        let curve = centerpoint_cubics(&four)[0].1.clone();
        prop_assume!(curve.at(&z).is_zero().is_no());
        if let Some(partner) = circlepoint(&four, &z).finite() {
            let distances = four.each_ref().map(|d| (d.of(&partner) - &z).norm());
            prop_assert!(!distances.iter().all(|d| d.equals(&distances[0]).is_yes()));
        }
    }

    /// Two decisions of the type that share nothing: by the discriminant of the cubic, and by the sides of
    /// each of the quadrilaterals.
    #[test]
    fn the_type_by_the_cubic_is_that_by_the_sides(four in four_positions()) {
        assert_types_agree(&four)?;
    }

    #[test]
    fn the_type_of_any_quadrilateral(vertices in [points(), points(), points(), points()]) {
        prop_assume!((0..4).all(|i| (1..3).all(|k| {
            vertices[i].equals(&vertices[(i + k) % 4]).is_no()
        })));
        assert_types_agree(&from_quadrilateral(&vertices))?;
    }

    #[test]
    fn moving_the_planes_moves_the_curves(
        four in four_positions(), rotation in turns(), shift in points(), mirror: bool, power in -30i32..=30,
    ) {
        let scale = Number::<Exact>::from(10).power(power);
        let map = |z: &Point<Exact>| {
            let z = if mirror { z.conj() } else { z.clone() };
            (&rotation * z + &shift).scaled(&scale)
        };
        // X ↦ map(X) in the fixed plane, and only turned and scaled alike in the moving one.
        let changed = four.each_ref().map(|d| Position {
            rotation: if mirror { d.rotation.conj() } else { d.rotation.clone() },
            translation: {
                let new = if mirror { d.rotation.conj() } else { d.rotation.clone() };
                map(&d.translation) - new * map(&Number::zero())
            },
        });
        let (old, new) = (centerpoint_cubics(&four)[0].1.clone(), centerpoint_cubics(&changed)[0].1.clone());
        prop_assert_eq!(is_zero(&old), is_zero(&new));
        prop_assert!(proportional(&old, &pulled_back(&new, &map)), "the curve moves along");
        prop_assert_eq!(curve_type(&old), curve_type(&new), "and keeps its type");
    }

    #[test]
    fn numbering_does_not_matter(four in four_positions(), seed in 0usize..24) {
        let mut places = vec![0, 1, 2, 3];
        let mut order = Vec::new();
        let mut seed = seed;
        for left in (1..=4).rev() {
            order.push(places.remove(seed % left));
            seed /= left;
        }
        let renumbered: [Position; 4] = std::array::from_fn(|i| four[order[i]].clone());
        for (old, new) in centerpoint_cubics(&four).iter().zip(&centerpoint_cubics(&renumbered)) {
            prop_assert!(proportional(&old.1, &new.1), "{}", old.0);
        }
    }

    #[test]
    fn the_inverse_motion_exchanges_the_curves(four in four_positions()) {
        let inverse = four.each_ref().map(Position::inverse);
        assert_one_curve(&[
            ("centerpoint", centerpoint_cubics(&four)[0].1.clone()),
            ("of the inverse", circlepoint_cubics(&inverse)[0].1.clone()),
            ("loop closure", circlepoint_cubics(&inverse)[1].1.clone()),
            ("isotropic", circlepoint_cubics(&inverse)[3].1.clone()),
        ], "inverse motion");
    }

    /// Both curves, where they are irreducible, have one type: the quadrilaterals of the poles and of the
    /// image poles have equal sides.
    #[test]
    fn both_irreducible_curves_have_one_type(four in four_positions()) {
        let curves = [&centerpoint_cubics(&four)[0].1, &circlepoint_cubics(&four)[0].1];
        let [center, circle] = curves.map(|curve| curve_type(curve).unwrap());
        if center.class().is_some() && circle.class().is_some() {
            prop_assert_eq!(center, circle);
        }
    }

    #[test]
    fn traced_points_lie_on_the_curve(four in four_positions(), n in 0i64..40) {
        let cubic = centerpoint_cubics(&four)[0].1.clone();
        let kind = curve_type(&cubic).unwrap();
        let balls = Cubic::new(cubic.coefficients().clone().map(|c| ball(&c)));
        let Some(trace) = FocalCubic::of(&balls).and_then(|form| Trace::new(form, kind)) else {
            return Ok(());
        };
        let at = Angle::from_tan_half(&Number::<Ball>::rounded(&rug::Rational::from((n - 20, 7)), &256)).cis();
        for branch in trace.branches() {
            for turn in [at.clone(), -&at] {
                let place = trace.point(*branch, &turn);
                let value = balls.at_projective(&place);
                prop_assert!(!value.is_zero().is_no(), "{branch:?} {value:?}");
                let sharp = place.coordinates().iter().all(|c| c.0.accuracy_bits() > Some(100) || !c.is_zero().is_no());
                prop_assert!(sharp, "{place:?}");
            }
        }
    }
}

/// As many as Klein's count says, on the curve, and on a line as real inflexions of a cubic are.
fn assert_inflexions(cubic: &Cubic<Exact>) {
    let kind = curve_type(cubic).unwrap();
    let (Some(form), Some(6)) = (FocalCubic::of(cubic), kind.class()) else {
        return;
    };
    let inflexions = real_inflexions(&form, 400).unwrap();
    assert_eq!(
        Some(inflexions.len()),
        kind.real_inflexions(),
        "{:?}",
        cubic.coefficients()
    );
    let balls = Cubic::new(cubic.coefficients().clone().map(|c| ball(&c)));
    for point in &inflexions {
        assert!(!balls.at_projective(point).is_zero().is_no(), "{point:?}");
    }
    let line = collinear(&inflexions[0], &inflexions[1], &inflexions[2]);
    assert!(!line.is_no(), "real inflexions lie on a line");
}

proptest! {
    #[test]
    fn a_curve_without_a_node_has_three_real_inflexions_on_a_line(four in four_positions()) {
        assert_inflexions(&centerpoint_cubics(&four)[0].1);
    }
}

#[test]
fn inflexions_of_symmetric_curves() {
    // Isosceles trapezoids, plain and crossed.
    for vertices in [
        [point(-3, 0), point(3, 0), point(1, 2), point(-1, 2)],
        [point(-3, 0), point(1, 2), point(-1, 2), point(3, 0)],
        [point(-3, 0), point(3, 0), point(2, 5), point(-2, 5)],
    ] {
        assert_inflexions(&Cubic::focal(&vertices).unwrap());
    }
}

fn ball(c: &Number<Exact>) -> Number<Ball> {
    Number::rounded(c.0.rational().unwrap(), &256)
}

/// Where the line through two points of a cubic meets it again; `None` at infinity or for a line that is a
/// part of it.
fn third_point(cubic: &Cubic<Exact>, p: &Point<Exact>, q: &Point<Exact>) -> Option<Point<Exact>> {
    // At p + t (q − p) the cubic is t (t − 1)(a t + b).
    let at = |t: i64| cubic.at(&(p + (q - p) * Number::from(t)));
    let (at_minus, at_two) = (at(-1) / 2, at(2) / 2);
    let a = (&at_two - &at_minus) / 3;
    let b = &at_minus + &a;
    if a.is_zero().is_yes() {
        return None;
    }
    Some(p + (q - p).scaled(&(-b / a)))
}

/// The cubic at the image of a point, as a cubic in that point: from its values.
fn pulled_back(cubic: &Cubic<Exact>, map: &impl Fn(&Point<Exact>) -> Point<Exact>) -> Cubic<Exact> {
    // Differences on the grid of the triangle of size 3.
    let value = |x: i64, y: i64| cubic.at(&map(&point(x, y)));
    let mut table: Vec<Vec<Number<Exact>>> = (0..4)
        .map(|x| (0..4 - x).map(|y| value(x, y)).collect())
        .collect();
    // Newton's form: first in y for every x, then in x.
    for row in &mut table {
        for k in 1..row.len() {
            for y in (k..row.len()).rev() {
                row[y] = (&row[y] - &row[y - 1]) / (k as i64);
            }
        }
    }
    for y in 0..4 {
        for k in 1..4 - y {
            for x in (k..4 - y).rev() {
                table[x][y] = (&table[x][y] - &table[x - 1][y]) / (k as i64);
            }
        }
    }
    // x(x−1)(x−2) = x³ − 3x² + 2x and so on, into powers.
    let falling: [[i64; 4]; 4] = [[1, 0, 0, 0], [0, 1, 0, 0], [0, -1, 1, 0], [0, 2, -3, 1]];
    let mut powers = vec![vec![Number::<Exact>::zero(); 4]; 4];
    for (x, row) in table.iter().enumerate() {
        for (y, c) in row.iter().enumerate() {
            for (i, &fx) in falling[x].iter().enumerate() {
                for (j, &fy) in falling[y].iter().enumerate() {
                    powers[i][j] += c * (fx * fy);
                }
            }
        }
    }
    let order = [
        (3, 0),
        (2, 1),
        (1, 2),
        (0, 3),
        (2, 0),
        (1, 1),
        (0, 2),
        (1, 0),
        (0, 1),
        (0, 0),
    ];
    Cubic::new(order.map(|(i, j): (usize, usize)| powers[i][j].clone()))
}

fn assert_types_agree(four: &[Position; 4]) -> Result<(), TestCaseError> {
    let kind = curve_type(&centerpoint_cubics(four)[0].1);
    prop_assert!(kind.is_some(), "undecided in exact numbers");
    let poles = with_poles(four);
    for quadrilateral in OPPOSITE_POLES {
        let vertices = quadrilateral.map(|(i, j)| poles.pole(i, j).unwrap().finite());
        let [Some(a), Some(b), Some(c), Some(d)] = vertices else {
            continue;
        };
        let vertices = [a, b, c, d];
        let product = product_of_sums(&squared_sides(&vertices)).sign().unwrap();
        let expected = match product {
            std::cmp::Ordering::Greater => vec![CurveType::TwoBranches, CurveType::ThreeLines],
            std::cmp::Ordering::Less => vec![CurveType::OneBranch],
            std::cmp::Ordering::Equal => vec![
                CurveType::Nodal,
                CurveType::LineAndCircle,
                CurveType::ThreeLines,
                CurveType::TwoLines,
                CurveType::Hyperbola,
                CurveType::EveryPoint,
            ],
        };
        let kind = kind.unwrap();
        // A parallelogram has U = Z; what is left of the cubic is a conic.
        prop_assert!(
            expected.contains(&kind),
            "{kind:?}, not one of {expected:?}"
        );
        if kind == CurveType::TwoBranches {
            prop_assert_eq!(u_vs_z(&vertices), Some(std::cmp::Ordering::Less));
        }
    }
    Ok(())
}

#[test]
fn all_routes_agree_on_every_degenerate_kind() {
    for case in degenerate() {
        assert_one_curve(&centerpoint_cubics(&case.positions), case.name);
        assert_one_curve(&circlepoint_cubics(&case.positions), case.name);
    }
}

#[test]
fn the_type_of_every_degenerate_kind() {
    let expected = [
        ("two equal positions", CurveType::EveryPoint),
        ("three equal positions", CurveType::EveryPoint),
        ("four equal positions", CurveType::EveryPoint),
        ("three poles at infinity", CurveType::LineAndCircle),
        ("three positions along a line", CurveType::ThreeLines),
        ("four translations", CurveType::NoPoint),
        ("four translations of a turned plane", CurveType::NoPoint),
        ("four translations on a circle", CurveType::EveryPoint),
        ("four translations along a line", CurveType::EveryPoint),
        ("four rotations about a point", CurveType::EveryPoint),
        ("parallelogram", CurveType::Hyperbola),
        ("rhombus", CurveType::TwoLines),
        ("rectangle", CurveType::Hyperbola),
        ("square", CurveType::TwoLines),
        ("three rotations about a point", CurveType::ThreeLines),
        ("kite", CurveType::LineAndCircle),
        ("concave kite", CurveType::LineAndCircle),
        ("crossed parallelogram", CurveType::LineAndCircle),
        ("nodal, opposite", CurveType::Nodal),
        ("nodal, adjacent", CurveType::Nodal),
        ("nodal, touching from outside", CurveType::Nodal),
    ];
    for case in degenerate() {
        let kinds = [
            centerpoint_cubics(&case.positions),
            circlepoint_cubics(&case.positions),
        ]
        .map(|curves| curve_type(&curves[0].1));
        println!("{}: {kinds:?}", case.name);
        if let Some((_, kind)) = expected.iter().find(|(name, _)| *name == case.name) {
            assert_eq!(kinds, [Some(*kind); 2], "{}", case.name);
        }
        assert!(kinds[0].is_some(), "{} is undecided", case.name);
    }
}

/// The identity that makes both decisions of the type one: for all vertices.
#[test]
fn the_discriminant_is_the_product_of_the_sums_of_sides() {
    let ring = Ring::free(&["x_B", "y_B", "x_C", "y_C", "x_D", "y_D"]).unwrap();
    let [bx, by, cx, cy, dx, dy] = ring.numbers();
    let vertices: [Point<Fraction>; 4] = [
        Number::zero(),
        Number::complex(bx, by),
        Number::complex(cx, cy),
        Number::complex(dx, dy),
    ];
    let form = FocalCubic::of(&Cubic::focal(&vertices).unwrap()).unwrap();
    let product = product_of_sums(&squared_sides(&vertices));
    assert_eq!(form.discriminant().equals(&product), Truth::Yes);
}

#[test]
fn the_product_of_the_sums_is_that_of_all_eight() {
    let ring = Ring::free(&["p", "q", "r", "s"]).unwrap();
    let sides: [Number<Fraction>; 4] = ring.numbers();
    let [p, q, r, s] = &sides;
    let mut product = Number::one();
    for signs in 0..8 {
        let signed = |bit: i32, side: &Number<Fraction>| {
            if signs >> bit & 1 == 1 {
                -side
            } else {
                side.clone()
            }
        };
        product *= p + signed(0, q) + signed(1, r) + signed(2, s);
    }
    let squares = sides.each_ref().map(Number::square);
    assert_eq!(product_of_sums(&squares).equals(&product), Truth::Yes);
}

#[test]
fn positions_of_one_place_have_no_pole() {
    let here = Position::identity();
    let poles = Positions::new(vec![here.clone(), here]);
    assert_eq!(poles.pole(0, 1).unwrap().is_determined(), Truth::No);
    assert!(poles.pole(0, 2).is_none());
}
