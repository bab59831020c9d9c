//! Points at infinity, circles, conics and circular cubics: exact properties on random figures.
#![expect(
    clippy::indexing_slicing,
    reason = "a place that is not there is a failure of the test"
)]

use burmester::number::{Exact, Fraction, Kind, Number, Ring, Surd, Truth};
use burmester::plane::circle::Circle;
use burmester::plane::circular_cubic::Cubic;
use burmester::plane::conic::{Conic, ConicType, DualConic, Foci, Range, focus_condition};
use burmester::plane::projective::{
    Line, ProjectiveNumber, ProjectivePoint, collinear, concurrent, cross_ratio,
    cross_ratio_of_lines, harmonic_conjugate,
};
use burmester::plane::{Point, isotropic, line, relation};
use proptest::prelude::*;

type Real = Number<Exact>;
type P = ProjectivePoint<Exact>;

fn point<K: Kind>(x: i64, y: i64) -> Point<K> {
    Number::complex(x.into(), y.into())
}

fn at(x: i64, y: i64, w: i64) -> P {
    P::new(x.into(), y.into(), w.into())
}

fn straight(a: i64, b: i64, c: i64) -> Line<Exact> {
    Line::new(a.into(), b.into(), c.into())
}

fn conic(coefficients: [i64; 6]) -> Conic<Exact> {
    Conic::new(coefficients.map(Number::from))
}

fn yes(truth: Truth) -> bool {
    truth == Truth::Yes
}

fn numbers() -> impl Strategy<Value = Real> {
    (-20i64..=20, 1i64..8).prop_map(|(n, d)| Number::ratio(n, d))
}

fn points() -> impl Strategy<Value = Point<Exact>> {
    (numbers(), numbers()).prop_map(|(x, y)| Number::complex(x, y))
}

/// Points of the projective plane, some at infinity.
fn projective() -> impl Strategy<Value = P> {
    (-9i64..=9, -9i64..=9, -3i64..=3)
        .prop_filter("a point", |all| *all != (0, 0, 0))
        .prop_map(|(x, y, w)| at(x, y, w))
}

fn through(p: &Point<Exact>, q: &Point<Exact>) -> Line<Exact> {
    Line::through(&P::from_finite(p), &P::from_finite(q))
}

/// A point, not zero, and a shift: a similarity z ↦ factor · z + shift.
fn similarities() -> impl Strategy<Value = (Point<Exact>, Point<Exact>)> {
    (points(), points()).prop_filter("not zero", |(factor, _)| factor.is_zero().is_no())
}

fn moved((factor, shift): &(Point<Exact>, Point<Exact>), z: &Point<Exact>) -> Point<Exact> {
    factor * z + shift
}

/// A projective map by its matrix, invertible.
fn maps() -> impl Strategy<Value = [[i64; 3]; 3]> {
    prop::array::uniform3(prop::array::uniform3(-4i64..=4)).prop_filter("invertible", |m| {
        let minor = |i: usize, j: usize| m[1][i] * m[2][j] - m[1][j] * m[2][i];
        m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1) != 0
    })
}

fn mapped(map: &[[i64; 3]; 3], p: &P) -> P {
    let [x, y, w] = map.map(|row| {
        (row.iter().zip(p.coordinates()))
            .map(|(m, x)| x * *m)
            .sum::<Real>()
    });
    P::new(x, y, w)
}

/// s·p + t·q.
fn between(s: i64, p: &P, t: i64, q: &P) -> P {
    let [x, y, w] = std::array::from_fn(|i| &p.coordinates()[i] * s + &q.coordinates()[i] * t);
    P::new(x, y, w)
}

/// Vertices in order of the quadrilateral of four lines.
fn vertices([k, l, m, n]: &[Line<Exact>; 4]) -> Option<[Point<Exact>; 4]> {
    Some([
        n.meet(k).finite()?,
        k.meet(l).finite()?,
        l.meet(m).finite()?,
        m.meet(n).finite()?,
    ])
}

/// An ellipse (where `inside`) or hyperbola x²/a² ± y²/b² = 1 with rational a, b and c: c, for the
/// foci ±c, its dual conic, and four rational tangents.
fn inscribed(
    t: i64,
    inside: bool,
    parameters: &[Real; 4],
) -> (Real, DualConic<Exact>, [Line<Exact>; 4]) {
    let (sum, double, difference) = (1 + t * t, 2 * t, 1 - t * t);
    let (a, b, c) = if inside {
        (sum, double, difference)
    } else {
        (difference, double, sum)
    };
    let square = Number::from(if inside { b * b } else { -b * b });
    let lines = parameters.clone().map(|s| {
        // u a and v b are (cos, sin) for the ellipse, (cosh, sinh) for the hyperbola.
        let (first, second, third) = if inside {
            (1 - s.square(), 2 * &s, 1 + s.square())
        } else {
            (1 + s.square(), 2 * &s, 1 - s.square())
        };
        Line::new(first / a, second / b, -third)
    });
    let c = Number::from(c);
    let dual = DualConic::with_foci(&c.clone().into(), &(-&c).into(), &square);
    (c, dual, lines)
}

#[test]
fn points_at_infinity_and_undetermined_ones() {
    assert!(yes(at(1, 2, 0).is_at_infinity()) && yes(at(4, 6, 2).is_finite()));
    assert!(yes(at(4, 6, 2).finite().unwrap().equals(&point(2, 3))));
    assert!(at(1, 2, 0).finite().is_none() && at(0, 0, 0).finite().is_none());
    assert_eq!(at(0, 0, 0).is_finite(), Truth::Unknown);
    assert_eq!(at(0, 0, 0).equals(&at(1, 2, 3)), Truth::Unknown);
    let opposite = P::from_direction(&point(-2, -4));
    assert!(yes(opposite.equals(&at(1, 2, 0))));
    // Parallel lines meet in their direction, equal ones nowhere in particular.
    let (k, l) = (straight(1, 2, 3), straight(-2, -4, 1));
    assert!(yes(k.meet(&l).equals(&at(2, -1, 0))) && yes(k.is_parallel_to(&l)));
    assert!(k.meet(&k).is_determined().is_no());
    assert_eq!(k.meet(&k).is_on(&k), Truth::Unknown);
    assert!(yes(k.is_perpendicular_to(&straight(2, -1, 5))));
    assert!(k.is_perpendicular_to(&l).is_no());
    let infinity = Line::at_infinity();
    assert_eq!(k.is_parallel_to(&infinity), Truth::Unknown);
    assert!(yes(
        Line::through(&at(1, 2, 0), &at(3, 4, 0)).equals(&infinity)
    ));
    assert!(yes(infinity.is_at_infinity()) && k.is_at_infinity().is_no());
}

#[test]
fn cross_ratios_of_known_points() {
    let on_axis = |x: i64, w: i64| at(x, 0, w);
    let [a, b, c, d] = [on_axis(0, 1), on_axis(2, 1), on_axis(1, 1), on_axis(1, 0)];
    // The middle and the point at infinity are harmonic.
    assert!(yes(cross_ratio([&a, &b, &c, &d])
        .value()
        .equals(&Number::from(-1))));
    assert!(yes(harmonic_conjugate(&a, &b, &c).equals(&d)));
    assert!(cross_ratio([&a, &b, &b, &d]).value().has_value().eq(&false));
    assert!(cross_ratio([&a, &a, &a, &d]).is_determined().is_no());
}

#[test]
fn known_conics() {
    let ellipse = conic([9, 0, 25, 0, 0, -225]);
    for (x, y, focus) in [(4, 0, true), (-4, 0, true), (0, 4, false), (3, 0, false)] {
        let vanishes = focus_condition(&ellipse, &point(x, y)).is_zero();
        assert_eq!(vanishes, Truth::from(focus));
    }
    let Some(Foci::Two(p, q)) = ellipse.dual().foci() else {
        panic!("an ellipse has two foci");
    };
    assert!(yes(p.equals(&point(4, 0))) && yes(q.equals(&point(-4, 0))));
    // y² = 4x.
    let parabola = conic([0, 0, 1, -4, 0, 0]);
    let Some(Foci::One(focus)) = parabola.dual().foci() else {
        panic!("a parabola has one focus");
    };
    assert!(yes(focus.equals(&point(1, 0))));
    assert!(yes(parabola.center().is_at_infinity()) && yes(parabola.is_parabola()));
    // xy = 1 has the foci ±(√2, √2), which the rational numbers do not hold.
    let hyperbola = Conic::<Surd>::new([0, 1, 0, 0, 0, -1].map(Number::from));
    let Some(Foci::Two(p, _)) = hyperbola.dual().foci() else {
        panic!("a hyperbola has two foci");
    };
    let root = Number::<Surd>::from(2).sqrt();
    assert!(yes(p
        .square()
        .equals(&Number::complex(root.clone(), root).square())));
    let Some(Foci::Two(p, _)) = conic([0, 1, 0, 0, 0, -1]).dual().foci() else {
        panic!("a hyperbola has two foci");
    };
    assert!(!p.has_value());
    for (coefficients, known) in [
        ([9, 0, 25, 0, 0, -225], ConicType::Ellipse),
        ([-1, 0, -1, 0, 0, 1], ConicType::Ellipse),
        ([1, 0, 1, 0, 0, 1], ConicType::ImaginaryEllipse),
        ([0, 0, 1, -4, 0, 0], ConicType::Parabola),
        ([0, 1, 0, 0, 0, -1], ConicType::Hyperbola),
        ([1, 0, -1, 0, 0, 0], ConicType::Degenerate),
        ([0, 0, 0, 1, 0, 0], ConicType::Degenerate),
    ] {
        assert_eq!(conic(coefficients).conic_type(), Some(known));
    }
    assert_eq!(conic([0; 6]).conic_type(), None);
    assert!(yes(conic([2, 0, 2, 1, 0, -1]).is_circle()));
}

#[test]
fn conics_through_points_that_do_not_determine_them() {
    let line = [
        at(0, 0, 1),
        at(1, 0, 1),
        at(2, 0, 1),
        at(3, 0, 1),
        at(0, 1, 1),
    ];
    assert!(Conic::through(&line).is_determined().is_no());
    let twice = [
        at(0, 0, 1),
        at(1, 0, 1),
        at(0, 1, 1),
        at(3, 5, 1),
        at(3, 5, 1),
    ];
    assert!(Conic::through(&twice).is_determined().is_no());
    let three = [
        at(0, 0, 1),
        at(1, 0, 1),
        at(2, 0, 1),
        at(3, 5, 1),
        at(1, 4, 1),
    ];
    let pair = Conic::through(&three);
    assert!(yes(pair.is_degenerate()) && three.iter().all(|p| yes(pair.contains(p))));
    // Both axis directions at infinity: a hyperbola with these asymptotes.
    let points = [
        at(1, 0, 0),
        at(0, 1, 0),
        at(1, 1, 1),
        at(2, 3, 1),
        at(4, 9, 1),
    ];
    let hyperbola = Conic::through(&points);
    assert_eq!(hyperbola.conic_type(), Some(ConicType::Hyperbola));
    assert!(points.iter().all(|p| yes(hyperbola.contains(p))));
}

#[test]
fn circles_that_degenerate() {
    let (o, p) = (point(0, 0), point(2, 2));
    let line = Circle::<Exact>::through(&o, &p, &point(5, 5));
    assert!(yes(line.is_line()) && yes(line.contains(&point(-1, -1))));
    assert!(!line.center().has_value() && !line.squared_radius().has_value());
    let nothing = Circle::through(&o, &p, &p);
    assert!(nothing.is_determined().is_no());
    assert_eq!(nothing.contains(&o), Truth::Unknown);
    let (small, large) = (Circle::about(&o, &1.into()), Circle::about(&o, &4.into()));
    assert!(yes(small.radical_line(&large).is_at_infinity()));
    assert!(small.radical_line(&small).is_determined().is_no());
    assert!(small.touches(&large).is_no());
    assert!(yes(large.touches(&Circle::about(&point(5, 0), &9.into()))));
    assert!(yes(large.touches(&Circle::about(&point(1, 0), &1.into()))));
    assert!(yes(
        large.is_orthogonal_to(&Circle::about(&point(3, 0), &5.into()))
    ));
}

#[test]
fn a_parallelogram_has_a_conic_and_the_line_at_infinity() {
    let square = [(0, 0), (4, 0), (5, 2), (1, 2)].map(|(x, y)| point::<Exact>(x, y));
    let cubic = Cubic::focal(&square).unwrap();
    assert!(yes(cubic.contains_line_at_infinity()) && yes(cubic.is_circular()));
    assert!(!cubic.singular_focus().has_value());
    assert!(cubic.real_asymptote().is_determined().is_no());
    assert!(square.iter().all(|vertex| yes(cubic.at(vertex).is_zero())));
    let kite = [(0, 0), (4, 0), (5, 2), (1, 3)].map(|(x, y)| point::<Exact>(x, y));
    assert!(
        Cubic::focal(&kite)
            .unwrap()
            .contains_line_at_infinity()
            .is_no()
    );
}

#[test]
fn what_is_no_real_cubic_is_refused() {
    let z = isotropic::Polynomial::<Exact>::z_minus(&Number::zero());
    assert!(Cubic::from_isotropic(&z).is_none());
    let norm = z.times(&z.conj());
    assert!(Cubic::from_isotropic(&norm.times(&norm)).is_none());
    let circle = Cubic::from_isotropic(&norm).unwrap();
    assert!(yes(circle.at(&point(3, 4)).equals(&25.into())));
}

/// The properties of a focal cubic as identities, for all quadrilaterals with A = 0, B = 1, which
/// every other one with A ≠ B is similar to.
#[test]
fn focal_cubics_for_all_quadrilaterals() {
    let ring = Ring::free(&["p", "q", "r", "s"]).unwrap();
    let [p, q, r, s] = ring.numbers::<4>();
    let vertices: [Point<Fraction>; 4] = [
        point(0, 0),
        point(1, 0),
        Number::complex(p, q),
        Number::complex(r, s),
    ];
    let cubic = Cubic::focal(&vertices).unwrap();
    assert!(yes(cubic.is_circular()));
    assert!(
        vertices
            .iter()
            .all(|vertex| yes(cubic.at(vertex).is_zero()))
    );
    let [a, b, c, d] = &vertices;
    for (a, b, c, d) in [(a, b, c, d), (b, c, d, a)] {
        assert!(yes(cubic.at(&line::meet(a, b, c, d)).is_zero()));
    }
    assert!(yes(cubic.at(&cubic.singular_focus()).is_zero()));
}

proptest! {
    #[test]
    fn joining_and_meeting_are_dual(p in projective(), q in projective(), r in projective(), map in maps()) {
        let (pq, pr) = (Line::through(&p, &q), Line::through(&p, &r));
        if collinear(&p, &q, &r).is_no() {
            prop_assert!(yes(p.is_on(&pq)) && yes(q.is_on(&pq)) && r.is_on(&pq).is_no());
            prop_assert!(yes(pq.meet(&pr).equals(&p)));
            prop_assert!(yes(concurrent(&pq, &pr, &Line::through(&p, &between(2, &q, 3, &r)))));
            prop_assert!(concurrent(&pq, &pr, &Line::through(&q, &r)).is_no());
        }
        let images = [&p, &q, &r].map(|point| mapped(&map, point));
        prop_assert_eq!(collinear(&p, &q, &r), collinear(&images[0], &images[1], &images[2]));
    }

    #[test]
    fn cross_ratios_are_projective(
        p in projective(), q in projective(), center in projective(), map in maps(),
        factors in prop::array::uniform4(-5i64..=5),
    ) {
        prop_assume!(collinear(&p, &q, &center).is_no());
        let [s, t, u, v] = factors;
        prop_assume!((s, t) != (0, 0) && (u, v) != (0, 0));
        let (c, d) = (between(s, &p, t, &q), between(u, &p, v, &q));
        let four = [&p, &q, &c, &d];
        // C = sA + tB and D = uA + vB have (AB, CD) = tu : sv.
        let known = ProjectiveNumber { numerator: Number::from(t * u), denominator: Number::from(s * v) };
        let ratio = cross_ratio(four);
        let lines = four.map(|point| Line::through(&center, point));
        let images = four.map(|point| mapped(&map, point));
        if yes(known.is_determined()) {
            prop_assert!(yes(ratio.equals(&known)));
            prop_assert!(yes(ratio.equals(&cross_ratio(images.each_ref()))));
            prop_assert!(yes(ratio.equals(&cross_ratio_of_lines(lines.each_ref()))));
        } else {
            prop_assert!(ratio.is_determined().is_no());
        }
        let harmonic = harmonic_conjugate(&p, &q, &c);
        prop_assert!(yes(harmonic.equals(&between(s, &p, -t, &q))));
    }

    #[test]
    fn circles_through_three_points(p in points(), q in points(), r in points(), other in points(), change in similarities()) {
        prop_assume!(relation::twice_area(&p, &q, &r).is_zero().is_no());
        let circle = Circle::through(&p, &q, &r);
        let center = circle.center();
        for point in [&p, &q, &r] {
            prop_assert!(yes(circle.contains(point)));
            prop_assert!(yes((point - &center).norm().equals(&circle.squared_radius())));
            let tangent = circle.tangent(point);
            prop_assert!(yes(P::from_finite(point).is_on(&tangent)));
            prop_assert!(yes(tangent.is_perpendicular_to(&through(&center, point))));
        }
        prop_assert_eq!(circle.contains(&other), relation::concyclic(&[p.clone(), q.clone(), r.clone(), other.clone()]));
        let power = (&other - &center).norm() - circle.squared_radius();
        prop_assert!(yes(circle.power(&other).equals(&power)));
        let [p1, q1, r1] = [&p, &q, &r].map(|point| moved(&change, point));
        let image = Circle::through(&p1, &q1, &r1);
        prop_assert!(yes(image.center().equals(&moved(&change, &center))));
        prop_assert!(yes(image.squared_radius().equals(&(circle.squared_radius() * change.0.norm()))));
        // The radical line goes through common points; a circle about a point is orthogonal where its
        // squared radius is the power of the point.
        let second = Circle::about(&other, &(&other - &p).norm());
        let radical = circle.radical_line(&second);
        if yes(radical.is_determined()) {
            prop_assert!(yes(P::from_finite(&p).is_on(&radical)));
        }
        prop_assert!(yes(circle.is_orthogonal_to(&Circle::about(&other, &power))));
    }

    #[test]
    fn conics_through_five_points_and_their_tangents(five in prop::array::uniform5(projective()), other in projective(), map in maps()) {
        let conic = Conic::through(&five);
        prop_assume!(yes(conic.is_determined()));
        for point in &five {
            prop_assert!(yes(conic.contains(point)));
        }
        let images = five.each_ref().map(|point| mapped(&map, point));
        let image = Conic::through(&images);
        prop_assert_eq!(conic.contains(&other), image.contains(&mapped(&map, &other)));
        prop_assert_eq!(conic.is_degenerate(), image.is_degenerate());
        prop_assume!(conic.is_degenerate().is_no());
        let dual = conic.dual();
        let tangents = five.each_ref().map(|point| conic.polar(point));
        for (point, tangent) in five.iter().zip(&tangents) {
            prop_assert!(yes(point.is_on(tangent)) && yes(dual.touches(tangent)));
            prop_assert!(yes(dual.pole(tangent).equals(point)));
        }
        // The dual of the dual, and the conic from its five tangents, are the conic.
        for again in [dual.conic(), DualConic::touching(&tangents).conic()] {
            prop_assert!(five.iter().all(|point| yes(again.contains(point))));
        }
        prop_assert!(yes(conic.center().equals(&dual.center())));
    }

    #[test]
    fn conics_with_given_foci(f in points(), g in points(), k in numbers()) {
        let dual = DualConic::with_foci(&f, &g, &k);
        for focus in [&f, &g] {
            prop_assert!(yes(dual.focus_condition(focus).is_zero()));
        }
        prop_assert!(yes(dual.center().finite().unwrap().equals(&((&f + &g) / 2))));
        let Some(Foci::Two(p, q)) = dual.foci() else { panic!("two foci") };
        prop_assert!(yes((&p + &q).equals(&(&f + &g))) && yes((p * q).equals(&(&f * &g))));
        // The condition of the conic itself is that of its tangents, where neither degenerates.
        let conic = dual.conic();
        if conic.is_degenerate().is_no() {
            prop_assert!(yes(focus_condition(&conic, &f).is_zero()));
        }
    }

    #[test]
    fn foci_of_inscribed_conics_lie_on_the_focal_cubic(
        t in 2i64..6, inside: bool, parameters in prop::array::uniform4(numbers()), change in similarities(),
    ) {
        let (c, dual, lines) = inscribed(t, inside, &parameters);
        for line in &lines {
            prop_assert!(yes(dual.touches(line)));
        }
        let Some(corners) = vertices(&lines) else { return Ok(()) };
        let corners = corners.map(|corner| moved(&change, &corner));
        let cubic = Cubic::focal(&corners).unwrap();
        let [a, b, c1, d] = &corners;
        prop_assume!([(a, b), (b, c1), (c1, d), (d, a)].iter().all(|(p, q)| p.equals(q).is_no()));
        let sides = [through(a, b), through(b, c1), through(c1, d), through(d, a)];
        let range = Range::touching(sides.each_ref());
        let foci = [Point::from(c.clone()), Point::from(-c)].map(|focus| moved(&change, &focus));
        for focus in &foci {
            prop_assert!(yes(cubic.at(focus).is_zero()));
        }
        // From one focus the range gives back the conic, and with it the other one.
        let member = range.member_with_focus(&foci[0]).unwrap();
        if yes(member.is_determined()) {
            prop_assert!(yes(member.focus_condition(&foci[1]).is_zero()));
            prop_assert!(sides.iter().all(|side| yes(member.touches(side))));
        }
    }

    #[test]
    fn only_points_of_the_focal_cubic_are_foci(corners in prop::array::uniform4(points()), other in points(), change in similarities()) {
        let [a, b, c, d] = &corners;
        let sides = [through(a, b), through(b, c), through(c, d), through(d, a)];
        prop_assume!([(a, b, c), (b, c, d), (c, d, a), (d, a, b)].iter().all(|(p, q, r)| relation::twice_area(p, q, r).is_zero().is_no()));
        let cubic = Cubic::focal(&corners).unwrap();
        let range = Range::touching(sides.each_ref());
        prop_assert_eq!(range.member_with_focus(&other).is_some(), yes(cubic.at(&other).is_zero()));
        // The cubic goes along with the figure.
        let images = corners.each_ref().map(|corner| moved(&change, corner));
        let image = Cubic::focal(&images).unwrap();
        prop_assert_eq!(cubic.at(&other).is_zero(), image.at(&moved(&change, &other)).is_zero());
        prop_assert_eq!(cubic.contains_line_at_infinity(), image.contains_line_at_infinity());
        if cubic.contains_line_at_infinity().is_no() {
            let focus = cubic.singular_focus();
            prop_assert!(yes(image.singular_focus().equals(&moved(&change, &focus))));
            prop_assert!(yes(cubic.at(&focus).is_zero()));
            let infinity = cubic.real_point_at_infinity();
            prop_assert!(yes(cubic.at_projective(&infinity).is_zero()));
            prop_assert!(yes(infinity.is_on(&cubic.real_asymptote())));
        }
    }

    #[test]
    fn cubics_have_their_values_and_gradients(coefficients in prop::array::uniform10(-9i64..=9), z in points(), direction in points()) {
        let cubic = Cubic::<Exact>::new(coefficients.map(Number::from));
        let (x, y) = (z.re(), z.im());
        let powers = [(3, 0), (2, 1), (1, 2), (0, 3), (2, 0), (1, 1), (0, 2), (1, 0), (0, 1), (0, 0)];
        let value: Real = (powers.iter().zip(coefficients)).map(|((i, j), c)| x.power(*i) * y.power(*j) * c).sum();
        prop_assert!(yes(cubic.at(&z).equals(&value)));
        // For a cubic the difference quotient over ±2h and ±h, extrapolated, is the derivative.
        let slope = |h: i64| {
            let ahead = cubic.at(&(&z + &direction * h)) - cubic.at(&(&z - &direction * h));
            ahead / (2 * h)
        };
        let derivative = (4 * slope(1) - slope(2)) / 3;
        let product = (cubic.gradient(&z).conj() * &direction).re().clone();
        prop_assert!(yes(derivative.equals(&product)));
    }
}
