//! Polynomials in one variable: arithmetic, exact decisions, certified roots.

#![allow(
    clippy::unwrap_used,
    clippy::as_conversions,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "helpers of tests may panic as tests do"
)]

use std::cmp::Ordering;

use crate::support::seed::{generator, rounds};
use burmester::number::text::parse_rational;
use burmester::number::univariate::{
    Polynomial, Quadratic, QuadraticRoots, RootError, Roots, isolate,
};
use burmester::number::{Ball, Complex, Exact, Number, Real, Surd};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use rand::{Rng, RngCore};
use rug::ops::Pow;
use rug::{Integer, Rational};

type Poly = Polynomial<Exact>;
type CaseResult = Result<(), TestCaseError>;

/// Runs a property with the logged seed.
fn check<S: Strategy>(
    name: &str,
    cases: usize,
    strategy: &S,
    test: impl Fn(S::Value) -> CaseResult,
) {
    let mut seed = [0; 32];
    generator(name).fill_bytes(&mut seed);
    let config = ProptestConfig {
        cases: rounds(cases) as u32,
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    let random = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    TestRunner::new_with_rng(config, random)
        .run(strategy, test)
        .unwrap_or_else(|failure| panic!("{name}: {failure}"));
}

fn ratio(numerator: i64, denominator: i64) -> Rational {
    Rational::from((numerator, denominator))
}

fn ten(power: i32) -> Rational {
    Rational::from(10).pow(power)
}

fn rationals(size: i64) -> impl Strategy<Value = Rational> + Clone {
    (-size..=size, 1..=size).prop_map(|(p, q)| ratio(p, q))
}

fn polynomials(most: usize) -> impl Strategy<Value = Poly> + Clone {
    prop::collection::vec(rationals(30), 0..=most + 1).prop_map(Polynomial::from_rationals)
}

fn linear(root: &Rational) -> Poly {
    Polynomial::linear(&root.clone().into())
}

/// (x − re)² + im².
fn couple(re: &Rational, im: &Rational) -> Poly {
    linear(re).power(2) + Polynomial::constant(Rational::from(im.square_ref()).into())
}

fn same(a: &Poly, b: &Poly) -> bool {
    (a - b).is_zero()
}

fn degree(p: &Poly) -> usize {
    p.degree().unwrap_or(0)
}

// Arithmetic.

#[test]
fn division_multiplies_back() {
    let pairs = (polynomials(8), polynomials(4));
    check("division", 200, &pairs, |(a, b)| {
        let Some((quotient, remainder)) = a.divide(&b) else {
            prop_assert!(b.is_zero() && a.pseudo_divide(&b).is_none());
            return Ok(());
        };
        prop_assert!(same(&(&quotient * &b + &remainder), &a));
        prop_assert!(remainder.degree() < b.degree());
        let pseudo = a.pseudo_divide(&b).unwrap();
        let left = a.scaled(&pseudo.multiplier);
        prop_assert!(same(&(&pseudo.quotient * &b + &pseudo.remainder), &left));
        prop_assert!(pseudo.remainder.degree() < b.degree());
        Ok(())
    });
}

#[test]
fn values_follow_arithmetic() {
    let cases = (polynomials(6), polynomials(6), rationals(20), rationals(20));
    check("values", 200, &cases, |(a, b, x, y)| {
        let [x, y] = [x, y].map(Number::<Exact>::from);
        let at = |p: &Poly| p.evaluate(&x);
        prop_assert!(at(&(&a * &b)).equals(&(at(&a) * at(&b))).is_yes());
        prop_assert!(at(&(&a - &b)).equals(&(at(&a) - at(&b))).is_yes());
        prop_assert!(at(&a.shifted(&y)).equals(&a.evaluate(&(&x + &y))).is_yes());
        prop_assert!(
            at(&a.stretched(&y))
                .equals(&a.evaluate(&(&x * &y)))
                .is_yes()
        );
        let leibniz = a.derivative() * &b + &a * b.derivative();
        prop_assert!(same(&(&a * &b).derivative(), &leibniz));
        let z = Number::complex(x.clone(), y.clone());
        let product = a.evaluate_complex(&z) * b.evaluate_complex(&z);
        prop_assert!((&a * &b).evaluate_complex(&z).equals(&product).is_yes());
        let balls: Polynomial<Ball> = a.map(|c| Number::rounded(c.0.rational().unwrap(), &60));
        let ball = balls.evaluate(&Number::rounded(x.0.rational().unwrap(), &60));
        prop_assert!(ball.0.contains(at(&a).0.rational().unwrap()));
        Ok(())
    });
}

#[test]
fn a_leading_ball_that_holds_zero_stays_and_does_not_divide() {
    let around_zero = Number(Ball::with_radius(&Rational::new(), &ratio(1, 9), 60));
    let p = Polynomial::new(vec![Number::from(1), around_zero]);
    assert_eq!(p.degree(), Some(1));
    assert!(Polynomial::variable().divide(&p).is_none());
    assert_eq!(Poly::from_integers(&[1, 2, 0, 0]).degree(), Some(1));
}

// Exact decisions.

#[test]
fn common_factors_are_found() {
    let cases = (polynomials(4), polynomials(4), polynomials(4));
    check("gcd", 200, &cases, |(a, b, common)| {
        let (p, q) = (&a * &common, &b * &common);
        let gcd = p.gcd(&q).unwrap();
        if gcd.is_zero() {
            prop_assert!(p.is_zero() && q.is_zero());
            return Ok(());
        }
        prop_assert!(p.divide(&gcd).unwrap().1.is_zero());
        prop_assert!(q.divide(&gcd).unwrap().1.is_zero());
        prop_assert!(common.is_zero() || gcd.divide(&common).unwrap().1.is_zero());
        let primitive = gcd.primitive_part().unwrap();
        prop_assert!(same(&primitive, &gcd));
        // The cofactors are coprime: their resultant says so, by another chain.
        let cofactor = |p: &Poly| p.divide(&gcd).unwrap().0;
        if !p.is_zero() && !q.is_zero() {
            let resultant = cofactor(&p).resultant(&cofactor(&q));
            prop_assert!(resultant.is_zero().is_no());
        }
        Ok(())
    });
}

#[test]
fn content_times_primitive_part() {
    check("content", 100, &polynomials(6), |p| {
        let content = Number::from(p.content().unwrap());
        prop_assert!(same(&p.primitive_part().unwrap().scaled(&content), &p));
        Ok(())
    });
}

/// Roots that differ, with multiplicities.
fn root_sets(most: usize) -> impl Strategy<Value = Vec<(Rational, usize)>> + Clone {
    prop::collection::btree_map(rationals(12), 1..=6usize, 0..=most)
        .prop_map(|map| map.into_iter().collect())
}

fn from_roots(leading: &Rational, roots: &[(Rational, usize)]) -> Poly {
    let start = Polynomial::constant(leading.clone().into());
    roots.iter().fold(start, |p, (root, multiplicity)| {
        p * linear(root).power(*multiplicity as u32)
    })
}

#[test]
fn resultants_are_products_of_differences() {
    let leading = (1..30i64).prop_map(|i| ratio(i, 7));
    let cases = (leading.clone(), root_sets(3), leading, root_sets(3));
    check("resultant", 200, &cases, |(a, roots, b, others)| {
        let (p, q) = (from_roots(&a, &roots), from_roots(&b, &others));
        let mut expected = a.pow(degree(&q) as i32) * b.pow(degree(&p) as i32);
        for (x, m) in &roots {
            for (y, n) in &others {
                expected *= Rational::from(x - y).pow((m * n) as i32);
            }
        }
        prop_assert!(p.resultant(&q).equals(&expected.into()).is_yes());
        Ok(())
    });
}

#[test]
fn discriminants_are_products_of_squared_differences() {
    let cases = ((1..30i64).prop_map(|i| ratio(-i, 7)), root_sets(6));
    check("discriminant", 100, &cases, |(a, mut roots)| {
        for (_, multiplicity) in &mut roots {
            *multiplicity = 1;
        }
        let p = from_roots(&a, &roots);
        let Some(n @ 1..) = p.degree() else {
            prop_assert!(!p.discriminant().has_value());
            return Ok(());
        };
        let mut expected = a.pow(2 * n as i32 - 2);
        for (i, (x, _)) in roots.iter().enumerate() {
            for (y, _) in &roots[..i] {
                expected *= Rational::from(x - y).square();
            }
        }
        prop_assert!(p.discriminant().equals(&expected.into()).is_yes());
        Ok(())
    });
    // −4 p³ − 27 q².
    let cubic = Poly::from_integers(&[5, 2, 0, 1]);
    let expected = Number::from(-4 * 8 - 27 * 25);
    assert!(cubic.discriminant().equals(&expected).is_yes());
}

#[test]
fn square_free_factors_carry_multiplicities() {
    check("square-free", 100, &root_sets(5), |roots| {
        let p = from_roots(&ratio(-3, 2), &roots);
        let factors = p.square_free_factors().unwrap();
        for (factor, multiplicity) in &factors {
            let expected = from_roots(
                &Rational::from(1),
                &roots
                    .iter()
                    .filter(|(_, m)| m == multiplicity)
                    .map(|(root, _)| (root.clone(), 1))
                    .collect::<Vec<_>>(),
            );
            prop_assert!(same(factor, &expected.primitive_part().unwrap()));
        }
        let total: usize = factors.iter().map(|(factor, m)| degree(factor) * m).sum();
        prop_assert_eq!(total, degree(&p));
        Ok(())
    });
}

#[test]
fn sturm_and_descartes_count_known_roots() {
    let couples = prop::collection::vec((rationals(9), 1..9i64), 0..3);
    let cases = (root_sets(5), couples, rationals(12), rationals(12));
    check("sturm", 100, &cases, |(roots, couples, low, high)| {
        let mut p = from_roots(&ratio(-3, 2), &roots);
        for (re, im) in &couples {
            p = p * couple(re, &ratio(*im, 4));
        }
        let sturm = p.sturm_sequence().unwrap();
        prop_assert_eq!(sturm.count(), roots.len());
        let inside = roots.iter().filter(|(x, _)| low < *x && *x <= high).count();
        prop_assert_eq!(sturm.count_between(&low, &high), inside);
        let positive: usize = roots
            .iter()
            .filter(|(x, _)| x.cmp0().is_gt())
            .map(|(_, m)| m)
            .sum();
        let bound = p.descartes_count().unwrap();
        prop_assert!(bound >= positive && (bound - positive).is_multiple_of(2));
        // Without complex roots Descartes' rule is sharp.
        prop_assert!(!couples.is_empty() || bound == positive);
        Ok(())
    });
}

// Roots.

/// What must hold of all roots of any polynomial.
fn assert_complete(p: &Poly, roots: &Roots) {
    let real: usize = roots.real().iter().map(|root| root.multiplicity()).sum();
    let complex: usize = roots.complex().iter().map(|root| root.multiplicity()).sum();
    assert_eq!(real + 2 * complex, degree(p));
    for pair in roots.real().windows(2) {
        assert!(pair[0].high() < pair[1].low());
    }
    for root in roots.real() {
        assert_eq!(root.exact().is_some(), root.low() == root.high());
        if let Some(exact) = root.exact() {
            assert_eq!(p.sign_at(exact), Some(Ordering::Equal));
        } else {
            assert!(p.sign_at(root.low()) != Some(Ordering::Equal));
            let changes = p.sign_at(root.low()) != p.sign_at(root.high());
            assert_eq!(changes, root.multiplicity() % 2 == 1);
        }
    }
    let squares: Vec<_> = roots
        .complex()
        .iter()
        .map(|root| root.isolating())
        .collect();
    for (i, square) in squares.iter().enumerate() {
        assert!(square.im().0.lower().unwrap().cmp0().is_gt());
        for other in &squares[..i] {
            assert!(!touch(square, other));
        }
    }
}

fn touch(a: &Number<Complex<Ball>>, b: &Number<Complex<Ball>>) -> bool {
    a.re().0.overlaps(&b.re().0) && a.im().0.overlaps(&b.im().0)
}

fn holds(ball: &Number<Complex<Ball>>, (re, im): (&Rational, &Rational)) -> bool {
    ball.re().0.contains(re) && ball.im().0.contains(im)
}

fn assert_small(ball: &Ball, size: &Rational, bits: u32) {
    let radius = ball.radius_rational().unwrap();
    assert!(radius <= Rational::from(size.abs_ref()) >> bits, "{ball}");
}

/// Checks isolation and enclosures against the known factors.
fn assert_roots(
    p: &Poly,
    real: &[(Rational, usize)],
    couples: &[((Rational, Rational), usize)],
    bits: u32,
) {
    let roots = isolate(p).unwrap();
    assert_complete(p, &roots);
    assert_eq!(roots.real().len(), real.len());
    for (root, (expected, multiplicity)) in roots.real().iter().zip(real) {
        assert_eq!(root.multiplicity(), *multiplicity);
        assert_eq!(root.compare(expected), Ordering::Equal);
        assert_eq!(root.sign(), expected.cmp0());
        assert_eq!(root.rational().as_ref(), Some(expected));
        let ball = root.enclosure(bits).0;
        assert!(ball.contains(expected));
        assert_small(&ball, expected, bits);
    }
    assert_eq!(roots.complex().len(), couples.len());
    for ((re, im), multiplicity) in couples {
        let mut found = roots
            .complex()
            .iter()
            .filter(|root| holds(&root.isolating(), (re, im)));
        let (root, None) = (found.next().unwrap(), found.next()) else {
            panic!("two squares hold one root");
        };
        assert_eq!(root.multiplicity(), *multiplicity);
        let ball = root.enclosure(bits);
        assert!(holds(&ball, (re, im)));
        let size = re.clone().abs() + im;
        assert_small(&ball.re().0, &size, bits);
        assert_small(&ball.im().0, &size, bits);
    }
}

#[test]
fn products_of_known_factors() {
    let couples =
        prop::collection::btree_map((rationals(9), (1..40i64, 1..9i64)), 1..=6usize, 0..4);
    let cases = (root_sets(4), couples, 20..400u32, -30..30i32);
    check(
        "products",
        60,
        &cases,
        |(mut real, couples, bits, power)| {
            let scale = ten(power);
            for (root, _) in &mut real {
                *root *= &scale;
            }
            let mut couples: Vec<_> = couples
                .into_iter()
                .map(|((re, (p, q)), m)| ((re * &scale, ratio(p, q) * &scale), m))
                .collect();
            couples.dedup_by(|a, b| a.0 == b.0);
            let mut p = from_roots(&ratio(-5, 3), &real);
            for ((re, im), multiplicity) in &couples {
                p = p * couple(re, im).power(*multiplicity as u32);
            }
            assert_roots(&p, &real, &couples, bits);
            Ok(())
        },
    );
}

#[test]
fn roots_very_close_to_each_other() {
    for gap in [ten(-40), ten(-300)] {
        let (a, b) = (ratio(1, 3), ratio(1, 3) + &gap);
        let real = |m, n| [(a.clone(), m), (b.clone(), n)];
        assert_roots(
            &from_roots(&ratio(1, 1), &real(1, 1)),
            &real(1, 1),
            &[],
            100,
        );
        assert_roots(
            &from_roots(&ratio(1, 1), &real(6, 5)),
            &real(6, 5),
            &[],
            100,
        );
        // A couple as close to the axis, with a real root between.
        let p = linear(&a) * couple(&a, &gap) * couple(&a, &ratio(2, 1)).power(3);
        let couples = [((a.clone(), gap.clone()), 1), ((a.clone(), ratio(2, 1)), 3)];
        assert_roots(&p, &[(a.clone(), 1)], &couples, 100);
        // Two couples that close, of equal and of different multiplicity.
        for n in [1, 4] {
            let p = couple(&a, &ratio(1, 1)) * couple(&b, &ratio(1, 1)).power(n);
            let couples = [
                ((a.clone(), ratio(1, 1)), 1),
                ((b.clone(), ratio(1, 1)), n as usize),
            ];
            assert_roots(&p, &[], &couples, 100);
        }
    }
}

#[test]
fn the_root_zero_beside_complex_roots() {
    let couples = [(ratio(-1, 1), ratio(7, 4)), (ratio(3, 1), ratio(1, 2))].map(|pair| (pair, 1));
    let zero = Polynomial::variable();
    let p = couples
        .iter()
        .fold(zero, |p, ((re, im), _)| p * couple(re, im));
    assert_roots(&p, &[(Rational::new(), 1)], &couples, 100);
}

#[test]
fn close_irrational_roots_keep_their_factors() {
    let near_two = 2 + ten(-40);
    let square =
        |q: &Rational| Polynomial::variable().power(2) - Polynomial::constant(q.clone().into());
    let p = square(&ratio(2, 1)).power(2) * square(&near_two).power(3);
    let roots = isolate(&p).unwrap();
    assert_complete(&p, &roots);
    let found: Vec<usize> = roots
        .real()
        .iter()
        .map(|root| root.multiplicity())
        .collect();
    assert_eq!(found, [3, 2, 2, 3]);
    for root in roots.real() {
        assert_eq!(root.rational(), None);
        let expected = if root.multiplicity() == 2 {
            ratio(2, 1)
        } else {
            near_two.clone()
        };
        assert!(root.enclosure(200).square().0.contains(&expected));
    }
}

#[test]
fn special_polynomials() {
    assert_eq!(
        isolate(&Poly::zero()).err(),
        Some(RootError::ZeroPolynomial)
    );
    let undefined = Polynomial::new(vec![Number::zero().inverse(), Number::one()]);
    assert_eq!(isolate(&undefined).err(), Some(RootError::NoValue));
    assert!(undefined.gcd(&Poly::variable()).is_none());
    assert!(!undefined.resultant(&Poly::variable()).has_value());
    let constant = isolate(&Poly::from_integers(&[7])).unwrap();
    assert!(constant.real().is_empty() && constant.complex().is_empty());
    assert_roots(&Poly::variable().power(6), &[(Rational::new(), 6)], &[], 50);
}

fn wilkinson() -> Poly {
    (1..=20).fold(Poly::from_integers(&[1]), |p, k| p * linear(&ratio(k, 1)))
}

#[test]
fn wilkinsons_polynomial_and_its_perturbation() {
    let known: Vec<_> = (1..=20).map(|k| (ratio(k, 1), 1)).collect();
    assert_roots(&wilkinson(), &known, &[], 300);
    // J. H. Wilkinson 1963: with −(210 + 2⁻²³) x¹⁹ ten roots become complex.
    let change = Polynomial::constant(ratio(-1, 1 << 23).into());
    let p = wilkinson() + Poly::variable().power(19) * change;
    let roots = isolate(&p).unwrap();
    assert_complete(&p, &roots);
    assert_eq!((roots.real().len(), roots.complex().len()), (10, 5));
    assert_eq!(p.sturm_sequence().unwrap().count(), 10);
    let printed = ["20.846908101", "8.917250249"];
    let last = roots.real().last().unwrap().enclosure(60).0;
    let value = parse_rational(printed[0]).unwrap();
    assert!(Ball::with_radius(&value, &ten(-9), 80).overlaps(&last));
    let value = parse_rational(printed[1]).unwrap();
    let near = Ball::with_radius(&value, &ten(-9), 80);
    assert!(
        roots
            .real()
            .iter()
            .any(|root| near.overlaps(&root.enclosure(60).0))
    );
}

/// xⁿ − 2 (a x − 1)²: two real roots about a^(−n/2 − 1) apart.
fn mignotte(n: u32, a: &Integer) -> Poly {
    let line = Polynomial::new(vec![Number::from(-1), Rational::from(a).into()]);
    Poly::variable().power(n) - line.power(2).scaled(&Number::from(2))
}

#[test]
fn mignottes_polynomials() {
    for (n, power) in [(5, 3u32), (20, 5), (31, 20), (60, 3)] {
        let a = Integer::from(10).pow(power);
        let p = mignotte(n, &a);
        let roots = isolate(&p).unwrap();
        assert_complete(&p, &roots);
        let expected = if n % 2 == 0 { 4 } else { 3 };
        assert_eq!(roots.real().len(), expected);
        // The close ones are on either side of 1/a.
        let inverse = Rational::from((Integer::from(1), a));
        let below = roots
            .real()
            .iter()
            .filter(|root| root.compare(&inverse).is_lt())
            .count();
        assert_eq!(below, expected - 2);
        roots.enclosures(100);
    }
}

fn chebyshev(n: usize) -> Poly {
    let (mut a, mut b) = (Poly::from_integers(&[1]), Poly::variable());
    for _ in 0..n {
        let next = Poly::from_integers(&[0, 2]) * &b - &a;
        a = std::mem::replace(&mut b, next);
    }
    a
}

#[test]
fn chebyshevs_roots_are_cosines() {
    let p = chebyshev(60);
    let roots = isolate(&p).unwrap();
    assert_complete(&p, &roots);
    assert_eq!(roots.real().len(), 60);
    for bits in [100, 333] {
        for (k, root) in roots.real().iter().rev().enumerate() {
            let angle = Number::<Ball>::pi(&(bits + 20)) * (2 * k as i64 + 1) / 120;
            let ball = root.enclosure(bits).0;
            assert!(ball.overlaps(&angle.cos().0));
            assert!(ball.accuracy_bits().unwrap() >= i64::from(bits) - 1);
        }
    }
}

#[test]
fn roots_of_unity() {
    for n in [3usize, 4, 7, 12, 17, 60] {
        let p = Poly::variable().power(n as u32) - Poly::from_integers(&[1]);
        let roots = isolate(&p).unwrap();
        assert_complete(&p, &roots);
        let enclosures = roots.enclosures(200);
        assert_eq!(enclosures.len(), n);
        for k in 0..n {
            let angle = Number::<Ball>::pi(&260) * (2 * k as i64) / n as i64;
            let z = Number::complex(angle.clone().cos(), angle.sin());
            assert_eq!(
                enclosures
                    .iter()
                    .filter(|(ball, _)| touch(ball, &z))
                    .count(),
                1
            );
        }
    }
}

#[test]
fn refinement_to_many_digits() {
    let cube = isolate(&Poly::from_integers(&[-2, 0, 0, 1])).unwrap();
    let golden = isolate(&Poly::from_integers(&[-1, -1, 1])).unwrap();
    for digits in [30u32, 100, 1000] {
        let bits = digits * 3322 / 1000 + 1;
        for (ball, multiplicity) in cube.enclosures(bits) {
            assert_eq!(multiplicity, 1);
            let cubed = ball.power(3);
            assert!(holds(&cubed, (&ratio(2, 1), &Rational::new())));
            assert!(cubed.re().0.accuracy_bits().unwrap() > i64::from(bits) - 6);
        }
        // (1 + √5)/2, by a sum of roots.
        let expected = (Number::<Surd>::from(5).sqrt() + 1) / 2;
        let ball = golden.real()[1].enclosure(bits).0;
        assert!(ball.overlaps(&expected.0.enclosure(bits).0));
        assert!(ball.accuracy_bits().unwrap() >= i64::from(bits) - 1);
    }
}

#[test]
fn random_polynomials_of_degree_60_and_of_1000_digits() {
    let mut random = generator("large");
    let digits = |random: &mut rand_chacha::ChaCha8Rng, count: usize| {
        let text: String = (0..count).map(|_| random.random_range('0'..='9')).collect();
        let value = Integer::from_str_radix(&text, 10).unwrap() + 1u32;
        Rational::from(if random.random() { value } else { -value })
    };
    for (n, size) in [(60, 6), (8, 1000), (60, 1000)] {
        let p = Polynomial::from_rationals((0..=n).map(|_| digits(&mut random, size)));
        let roots = isolate(&p).unwrap();
        assert_complete(&p, &roots);
        if n * size < 10_000 {
            assert_eq!(p.sturm_sequence().unwrap().count(), roots.real().len());
        }
        // The sum and the product of all roots; their number is even.
        let all = roots.enclosures(150);
        let sum: Number<Complex<Ball>> = all.iter().map(|(z, _)| z.clone()).sum();
        let product: Number<Complex<Ball>> = all.iter().map(|(z, _)| z.clone()).product();
        let quotient = |power: usize| (p.coefficient(power) / p.coefficient(n)).0;
        let vieta = [
            -quotient(n - 1).rational().unwrap().clone(),
            quotient(0).rational().unwrap().clone(),
        ];
        assert!(holds(&sum, (&vieta[0], &Rational::new())));
        assert!(holds(&product, (&vieta[1], &Rational::new())));
    }
}

// Quadratics.

fn quadratic<K: Real>(
    [a, b, c]: [Rational; 3],
    of: impl Fn(&Rational) -> Number<K>,
) -> Quadratic<K> {
    Quadratic::new(of(&a), of(&b), of(&c))
}

#[test]
fn quadratics_in_every_case() {
    let exact = |q: [i64; 3]| {
        quadratic(q.map(Rational::from), |q| Number::<Exact>::from(q.clone())).roots()
    };
    assert!(matches!(exact([0, 0, 0]), QuadraticRoots::Every));
    assert!(matches!(exact([0, 0, 3]), QuadraticRoots::None));
    assert!(
        matches!(exact([0, 2, 3]), QuadraticRoots::Single(x) if x.equals(&Number::ratio(-3, 2)).is_yes())
    );
    assert!(
        matches!(exact([1, 2, 1]), QuadraticRoots::Double(x) if x.equals(&Number::from(-1)).is_yes())
    );
    assert!(matches!(exact([1, 0, -2]), QuadraticRoots::Real([x, _]) if !x.has_value()));
    let surd = quadratic([1, -2, -1].map(Rational::from), |q| {
        Number::<Surd>::from(q.clone())
    });
    let QuadraticRoots::Real([x, y]) = surd.roots() else {
        panic!()
    };
    let root = Number::<Surd>::from(2).sqrt();
    assert!(x.equals(&(1 - &root)).is_yes() && y.equals(&(1 + root)).is_yes());
}

#[test]
fn quadratic_roots_satisfy_and_ascend() {
    let coefficients = [rationals(30), rationals(30), rationals(30)];
    check("quadratic", 300, &coefficients, |coefficients| {
        let balls = quadratic(coefficients.clone(), |q| Number::<Ball>::rounded(q, &90));
        let p = Poly::from_rationals(coefficients.iter().rev().cloned());
        let value = |x: &Number<Ball>| balls.a.clone() * x * x + &balls.b * x + &balls.c;
        if let Some(points) = balls.real_points() {
            for (x, w) in points {
                let form = &balls.a * x.square() + &balls.b * &x * &w + &balls.c * w.square();
                prop_assert!(!form.is_zero().is_no());
            }
        }
        let Ok(roots) = isolate(&p) else {
            prop_assert!(matches!(
                balls.roots(),
                QuadraticRoots::Every | QuadraticRoots::Undecided
            ));
            return Ok(());
        };
        match balls.roots() {
            QuadraticRoots::Undecided => {}
            QuadraticRoots::Every => prop_assert!(false),
            QuadraticRoots::None => prop_assert_eq!(p.degree(), Some(0)),
            QuadraticRoots::Single(x) => {
                prop_assert!(x.0.overlaps(&roots.real()[0].enclosure(90).0))
            }
            QuadraticRoots::Real(found) => {
                prop_assert_eq!(roots.real().len(), 2);
                for (x, root) in found.iter().zip(roots.real()) {
                    prop_assert!(x.0.overlaps(&root.enclosure(90).0));
                    prop_assert!(!value(x).is_zero().is_no());
                }
            }
            QuadraticRoots::Double(x) => {
                prop_assert_eq!(roots.real()[0].multiplicity(), 2);
                prop_assert!(x.0.overlaps(&roots.real()[0].enclosure(90).0));
            }
            QuadraticRoots::Conjugate(z) => {
                prop_assert!(touch(&z, &roots.complex()[0].enclosure(90)));
            }
        }
        Ok(())
    });
}

#[test]
fn a_vanishing_leading_coefficient_sends_one_root_to_infinity() {
    let small = Number(Ball::with_radius(&Rational::new(), &ten(-20), 80));
    let q = Quadratic::new(small, Number::from(2), Number::rounded(&ratio(-6, 1), &80));
    assert!(matches!(q.roots(), QuadraticRoots::Undecided));
    let [(x, w), (y, v)] = q.real_points().unwrap();
    assert!(w.is_zero().is_yes() || w.0.contains(&Rational::new()) && x.is_zero().is_no());
    assert!((y / v).0.contains(&ratio(3, 1)));
    let f = Quadratic::new(Number(1e-300), Number(-1.0), Number(1e-300));
    assert!(matches!(f.roots(), QuadraticRoots::Real([x, _]) if x.0 == 1e-300));
}

// A second implementation.

const VALUES: &str = include_str!("../data/univariate_values.txt");

fn stored(text: &str) -> Poly {
    Polynomial::from_rationals(text.split(' ').map(|c| parse_rational(c).unwrap()))
}

fn stored_root(cell: &str) -> (usize, Number<Complex<Ball>>) {
    let parts: Vec<Rational> = cell
        .split(' ')
        .map(|q| parse_rational(q).unwrap())
        .collect();
    let part = |at: usize| Number(Ball::with_radius(&parts[at], &parts[at + 1], 300));
    let multiplicity = parts[0].to_f64() as usize;
    (multiplicity, Number::complex(part(1), part(3)))
}

fn assert_stored_roots(p: &Poly, cells: &[&str]) {
    let roots = isolate(p).unwrap();
    assert_complete(p, &roots);
    let ours = roots.enclosures(170);
    assert_eq!(ours.len(), cells.len());
    for cell in cells {
        let (multiplicity, theirs) = stored_root(cell);
        let mut found = ours.iter().filter(|(ball, _)| touch(ball, &theirs));
        assert_eq!(found.next().map(|(_, m)| *m), Some(multiplicity), "{cell}");
        assert!(found.next().is_none());
    }
}

#[test]
fn values_of_another_implementation() {
    let mut compared = 0;
    for line in VALUES.lines().filter(|line| !line.starts_with('#')) {
        let cells: Vec<&str> = line.split(';').collect();
        let number = |text: &str| Number::<Exact>::from(parse_rational(text).unwrap());
        let p = stored(cells[1]);
        match cells[0] {
            "roots" => assert_stored_roots(&p, &cells[2..]),
            "sturm" => {
                let count = p.sturm_sequence().unwrap().count();
                assert_eq!(count.to_string(), cells[2]);
            }
            "resultant" => {
                let value = p.resultant(&stored(cells[2]));
                assert!(value.equals(&number(cells[3])).is_yes(), "{line}");
            }
            "discriminant" => assert!(p.discriminant().equals(&number(cells[2])).is_yes()),
            "gcd" => assert!(same(&p.gcd(&stored(cells[2])).unwrap(), &stored(cells[3]))),
            other => panic!("unknown line {other}"),
        }
        compared += 1;
    }
    assert!(compared > 100);
}
