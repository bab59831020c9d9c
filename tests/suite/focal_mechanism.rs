//! The focal mechanism by its joints is the one by its lengths, and curves and polygons of the plane.

use burmester::linkage::five_bar::{self, Lengths};
use burmester::linkage::focal_mechanism;
use burmester::number::poly::Ring;
use burmester::number::{Exact, Fraction, Number, Real};
use burmester::plane::isotropic::Polynomial;
use burmester::plane::{Angle, Point, line, quadrilateral};

fn point(x: i64, y: i64) -> Point<Exact> {
    Number::complex(x.into(), y.into())
}

#[test]
fn joints_and_lengths_give_the_same_mechanism_for_all_values() {
    let mut ring = Ring::empty();
    for name in ["m", "p", "q", "n"] {
        ring = ring.with_positive(name).unwrap();
    }
    for name in ["t", "t1", "t2"] {
        ring = ring.with_variable(name).unwrap();
    }
    let [m, p, q, n, t, t1, t2]: [Number<Fraction>; 7] = ring.numbers();
    let [turn, omega, other] = [t, t1, t2].map(|t| Angle::from_tan_half(&t));
    let nu = &n / (&m * &p * &q);
    let lengths = Lengths { m, p, q, n };
    let chain = five_bar::lay(&lengths, &turn, &omega);
    let joints = focal_mechanism::joints(&Number::zero(), &chain.p, &chain.f, &chain.q, &nu);
    let (a, b) = focal_mechanism::arms(&lengths);
    let [_, pin_a, pin_b, pin_n] = &joints.corners;
    assert!(pin_n.equals(&chain.n).is_yes());
    assert!(pin_a.equals(&a.into()).is_yes());
    assert!(pin_b.equals(&(&chain.n + chain.v.scaled(&b))).is_yes());
    // SF keeps its length: S is equally far from F for another ω, by the triangles over the base.
    let d_squared = chain.n.norm();
    let share = (joints.s / pin_n).re().clone();
    let square = |omega: &Angle<Fraction>| {
        let from_m = (Point::from(lengths.m.clone()) - omega.direction().scaled(&lengths.p)).norm();
        let from_n = (Point::from(lengths.n.clone()) + omega.direction().scaled(&lengths.q)).norm();
        // Stewart's theorem.
        (1 - &share) * from_m + &share * from_n - &share * (1 - &share) * &d_squared
    };
    assert!(square(&omega).equals(&square(&other)).is_yes());
}

#[test]
fn a_point_of_the_focal_curve_gives_back_the_mechanism() {
    let (m, p, f, q) = (point(0, 0), point(3, 1), point(2, 5), point(9, 4));
    let joints = focal_mechanism::joints(&m, &p, &f, &q, &Number::ratio(2, 35));
    let curve = quadrilateral::focal_curve(&joints.corners);
    assert!(curve.at(&f).is_zero().is_yes());
    assert!(curve.at(&point(1, 1)).is_zero().is_no());
    let share = focal_mechanism::share_of_arms(&joints.corners, &f);
    let [m, a, _, _] = &joints.corners;
    assert!((m + (a - m).scaled(&share)).equals(&p).is_yes());
}

#[test]
fn polynomials_in_isotropic_coordinates_multiply_as_their_values_do() {
    let (a, b, z) = (point(2, -3), point(1, 7), point(4, 5));
    let (first, second) = (Polynomial::z_minus(&a), Polynomial::z_minus(&b).conj());
    let product = first.times(&second);
    assert_eq!(product.order(), Some(2));
    let value = (&z - &a) * (&z - &b).conj();
    assert!(product.at(&z).equals(&value).is_yes());
    assert!(product.conj().at(&z).equals(&value.conj()).is_yes());
    assert!(product.coefficient(1, 1).equals(&Number::one()).is_yes());
    assert!(product.coefficient(2, 0).is_zero().is_yes());
    let sum = first.plus(&second);
    assert!(sum.at(&z).equals(&((&z - &a) + (&z - &b).conj())).is_yes());
    assert!(sum.minus(&second).equals(&first).is_yes());
    assert_eq!(sum.minus(&sum).order(), None);
}

#[test]
fn polygons_turn_about_points() {
    let square = [point(0, 0), point(4, 0), point(4, 4), point(0, 4)];
    let crossed = [point(0, 0), point(4, 4), point(4, 0), point(0, 4)];
    let winding = |polygon: &[Point<Exact>], p| quadrilateral::winding_number(polygon, &p);
    assert_eq!(winding(&square, point(1, 2)), Some(1));
    assert_eq!(winding(&square, point(9, 2)), Some(0));
    assert_eq!(winding(&square, point(-1, 4)), Some(0));
    assert_eq!(winding(&square, point(-1, 0)), Some(0));
    for on_side in [
        point(4, 2),
        point(2, 0),
        point(2, 4),
        point(0, 0),
        point(4, 4),
    ] {
        assert_eq!(winding(&square, on_side), None);
    }
    let backwards: Vec<_> = square.iter().rev().cloned().collect();
    assert_eq!(winding(&backwards, point(1, 2)), Some(-1));
    assert_eq!(winding(&crossed, point(3, 2)), Some(-1));
    assert_eq!(winding(&crossed, point(1, 2)), Some(1));
    assert_eq!(winding(&crossed, point(2, 1)), Some(0));
    assert!(quadrilateral::is_convex(&square).is_yes());
    assert!(quadrilateral::is_convex(&crossed).is_no());
    let concave = [point(0, 0), point(6, 8), point(1, 1), point(6, 0)];
    assert!(quadrilateral::is_convex(&concave).is_no());
}

#[test]
fn lines_meet_and_mirror() {
    let (a, b) = (point(0, 0), point(2, 2));
    let meet = line::meet(&a, &b, &point(0, 4), &point(4, 0));
    assert!(meet.equals(&point(2, 2)).is_yes());
    let parallel = line::meet(&a, &b, &point(0, 1), &point(1, 2));
    assert!(!parallel.has_value());
    assert!(
        line::mirror(&point(5, 1), &a, &b)
            .equals(&point(1, 5))
            .is_yes()
    );
    assert!(!line::mirror(&point(5, 1), &a, &a).has_value());
}

#[test]
fn quadratic_forms_that_are_multiplied_out_have_a_sign() {
    let ring = Ring::free(&["x", "y", "z"])
        .unwrap()
        .with_positive("w")
        .unwrap();
    let [x, y, z, w]: [Number<Fraction>; 4] = ring.numbers();
    let sign = |f: &Number<Fraction>| f.0.sign();
    let sum = (&x + &y).square() + z.square();
    assert_eq!(sign(&sum), Some(std::cmp::Ordering::Greater));
    assert_eq!(sign(&(-(&sum * &w))), Some(std::cmp::Ordering::Less));
    let two = (&z + 3).square() + y.square();
    assert_eq!(
        sign(&((&x - 1).square() * &two + &two)),
        Some(std::cmp::Ordering::Greater)
    );
    // Both signs, or a factor of unknown sign.
    assert_eq!(sign(&((&x + &y).square() - z.square())), None);
    assert_eq!(sign(&(&sum * &x)), None);
    assert_eq!(sign(&(x.square() + &x)), None);
}
