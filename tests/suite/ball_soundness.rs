//! Every operation on balls encloses what it should.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use std::cmp::Ordering;

use crate::support::seed::{generator, rounds};
use burmester::number::text::parse_rational;
use burmester::number::{Ball, Elementary, Kind, Number, Real};
use rand::Rng;
use rug::Rational;

/// A ball and an exact number that lies in it.
#[derive(Clone, Debug)]
struct Sample {
    ball: Ball,
    point: Rational,
}

fn power_of_two(power: i32) -> Rational {
    Rational::from(1) << power
}

/// Mostly ordinary magnitudes, sometimes tiny or huge ones.
fn magnitude(rng: &mut impl Rng) -> Rational {
    let power = match rng.random_range(0..10) {
        0 => rng.random_range(-3000..3000),
        1..4 => rng.random_range(-100..100),
        _ => rng.random_range(-4..4),
    };
    Rational::from((rng.random_range(1..1_000_000u32), 1_000_003)) * power_of_two(power)
}

fn signed(rng: &mut impl Rng) -> Rational {
    match rng.random_range(0..20) {
        0 => Rational::new(),
        1 => Rational::from(rng.random_range(-3..=3)),
        2..11 => magnitude(rng),
        _ => -magnitude(rng),
    }
}

/// A ball around `mid` whose radius is zero, small or large beside it, and a point in it, often one
/// of its ends.
fn ball_around(rng: &mut impl Rng, mid: &Rational, bits: u32) -> Sample {
    let radius = match rng.random_range(0..6) {
        0 => Rational::new(),
        1 => magnitude(rng),
        2 => mid * Rational::from((rng.random_range(0..300), 128)),
        _ => mid * power_of_two(-rng.random_range(1..150)),
    };
    let ball = Ball::with_radius(mid, &radius, bits);
    let point = point_in(rng, &ball);
    assert!(ball.contains(mid) && ball.contains(&point));
    Sample { ball, point }
}

fn point_in(rng: &mut impl Rng, ball: &Ball) -> Rational {
    let mid = ball.midpoint_rational().unwrap();
    let radius = ball.radius_rational().unwrap();
    let part = match rng.random_range(0..4) {
        0 => Rational::from(-1),
        1 => Rational::from(1),
        _ => Rational::from((rng.random_range(-64..=64), 64)),
    };
    mid + radius * part
}

fn sample(rng: &mut impl Rng) -> Sample {
    let mid = signed(rng);
    if rng.random_range(0..5) == 0 {
        let ball = Ball::constant(mid.clone());
        return Sample { ball, point: mid };
    }
    let bits = rng.random_range(2..200);
    ball_around(rng, &mid, bits)
}

/// Applies one operation to both, or tells that the exact one is not defined.
fn operate(a: &mut Sample, operation: u32, b: &Sample) -> bool {
    match operation % 5 {
        0 => {
            a.ball.add(&b.ball);
            a.point += &b.point;
        }
        1 => {
            a.ball.sub(&b.ball);
            a.point -= &b.point;
        }
        2 => {
            a.ball.mul(&b.ball);
            a.point *= &b.point;
        }
        3 => {
            a.ball.div(&b.ball);
            if b.point.cmp0().is_eq() {
                return false;
            }
            a.point /= &b.point;
        }
        _ => {
            a.ball.negate();
            a.point = Rational::from(-&a.point);
        }
    }
    true
}

fn assert_sound(sample: &Sample, context: &dyn std::fmt::Debug) {
    let Sample { ball, point } = sample;
    assert!(
        ball.has_value() && ball.contains(point),
        "{ball} misses {point}: {context:?}"
    );
    if let Some(sign) = ball.sign() {
        assert_eq!(sign, point.cmp0(), "{context:?}");
    }
    if ball.is_zero().is_yes() || ball.is_zero().is_no() {
        let zero = point.cmp0().is_eq();
        assert_eq!(ball.is_zero().is_yes(), zero, "{context:?}");
    }
}

#[test]
fn single_operations_contain_the_exact_result() {
    let mut rng = generator("single operations");
    for _ in 0..rounds(10_000) {
        let (a, b) = (sample(&mut rng), sample(&mut rng));
        let operation = rng.random();
        let mut result = a.clone();
        if operate(&mut result, operation, &b) {
            assert_sound(&result, &(&a, operation % 5, &b));
        }
    }
}

#[test]
fn expressions_contain_the_exact_result() {
    let mut rng = generator("expressions");
    for _ in 0..rounds(1_000) {
        let mut pool: Vec<Sample> = (0..4).map(|_| sample(&mut rng)).collect();
        for _ in 0..10 {
            let [i, j] = [0, 1].map(|_| rng.random_range(0..pool.len()));
            let other = pool[j].clone();
            if operate(&mut pool[i], rng.random(), &other) {
                assert_sound(&pool[i], &(i, j));
            } else {
                pool[i] = sample(&mut rng);
            }
        }
    }
}

#[test]
fn roots_contain_the_exact_root() {
    let mut rng = generator("roots");
    for _ in 0..rounds(5_000) {
        let a = sample(&mut rng);
        let mut root = a.ball.clone();
        root.sqrt();
        if a.point.cmp0().is_lt() {
            continue;
        }
        assert!(root.has_value(), "{a:?}");
        if let (Some(low), Some(high)) = (root.lower(), root.upper()) {
            let low = low.max(Rational::new());
            assert!(low.square() <= a.point && a.point <= high.square(), "{a:?}");
        }
    }
}

#[test]
fn sets_are_sound() {
    let mut rng = generator("sets");
    for _ in 0..rounds(2_000) {
        let a = sample(&mut rng);
        let around = &a.point * Rational::from((1001, 1000));
        let b = ball_around(&mut rng, &around, 90).ball;
        let shared = b.contains(&a.point);
        assert!(!shared || a.ball.overlaps(&b));
        match a.ball.intersect(&b) {
            Some(both) => {
                assert!(!shared || both.contains(&a.point));
                assert!(both.radius_rational() <= b.radius_rational());
                assert!(both.radius_rational() <= a.ball.radius_rational());
            }
            None => assert!(!shared),
        }
        let bits = rng.random_range(0..300);
        assert!(a.ball.with_precision(bits).contains(&a.point));
    }
}

#[test]
fn decimal_text_contains_the_ball() {
    let mut rng = generator("decimal text");
    for _ in 0..rounds(2_000) {
        let ball = sample(&mut rng).ball;
        let digits = rng.random_range(0..60);
        let text = ball.to_decimal(digits).unwrap();
        let value = parse_rational(&text.value).unwrap();
        let radius = parse_rational(&text.radius).unwrap();
        let (low, high) = (ball.lower().unwrap(), ball.upper().unwrap());
        assert!(Rational::from(&value - &radius) <= low, "{ball:?} {text:?}");
        assert!(value + radius >= high, "{ball:?} {text:?}");
        let shown = text.value.split('e').next().unwrap();
        let shown = shown.trim_start_matches(['-', '0', '.']);
        let significant = shown.bytes().filter(u8::is_ascii_digit).count();
        assert!(
            significant <= digits.max(1) || !shown.contains('.'),
            "{text:?}"
        );
    }
}

#[test]
fn decimal_text_by_example() {
    for (text, digits, value, radius) in [
        ("0", 5, "0", "0"),
        ("1/2", 5, "0.5", "0"),
        ("-250000", 3, "-2.5e5", "0"),
        ("-250000", 9, "-250000", "0"),
        ("1/3", 3, "0.333", "0.00034"),
        ("1e-30", 5, "1e-30", "0"),
        ("99999/100000", 2, "1", "1e-5"),
    ] {
        let ball = Ball::constant(parse_rational(text).unwrap());
        let shown = ball.to_decimal(digits).unwrap();
        assert_eq!(
            (shown.value.as_str(), shown.radius.as_str()),
            (value, radius)
        );
    }
    let ball = Ball::with_radius(&Rational::from(2), &power_of_two(-10), 50);
    assert_eq!(ball.to_string(), "2 ± 0.00098");
}

type Function = fn(&mut Ball);
const FUNCTIONS: [(&str, Function); 7] = [
    ("sqrt", Ball::sqrt),
    ("sin", Ball::sin),
    ("cos", Ball::cos),
    ("tan", Ball::tan),
    ("asin", Ball::asin),
    ("acos", Ball::acos),
    ("atan", Ball::atan),
];

#[test]
fn elementary_functions_agree_with_a_higher_precision() {
    let mut rng = generator("elementary functions");
    for round in 0..rounds(4_000) {
        let (name, function) = FUNCTIONS[round % FUNCTIONS.len()];
        let mid = signed(&mut rng);
        let bits = rng.random_range(2..200);
        let a = ball_around(&mut rng, &mid, bits);
        let mut sharp = Ball::rounded(&a.point, &700);
        function(&mut sharp);
        let mut coarse = a.ball.clone();
        function(&mut coarse);
        if sharp.has_value() {
            assert!(
                coarse.overlaps(&sharp),
                "{name} of {} is {coarse:?}, not {sharp}",
                a.ball
            );
        }
    }
}

#[test]
fn angles_of_directions_agree_with_a_higher_precision() {
    let mut rng = generator("atan2");
    for _ in 0..rounds(4_000) {
        let (y, x) = (sample(&mut rng), sample(&mut rng));
        let mut sharp = Ball::rounded(&y.point, &700);
        sharp.atan2(&Ball::rounded(&x.point, &700));
        let mut coarse = y.ball.clone();
        coarse.atan2(&x.ball);
        if sharp.has_value() {
            assert!(coarse.overlaps(&sharp), "{y:?} {x:?}: {coarse:?}, {sharp}");
        }
    }
}

#[test]
fn angles_in_degrees_agree_with_a_higher_precision() {
    let mut rng = generator("degrees");
    for round in 0..rounds(1_000) {
        let angle = match round % 3 {
            0 => signed(&mut rng),
            1 => Rational::from(rng.random_range(-100..100) * 15),
            _ => Rational::from(rng.random_range(-9..9) * 30) + magnitude(&mut rng) / 1_000_000_000,
        };
        let bits = rng.random_range(2..200);
        let (cos, sin) = Ball::cos_sin_of_degrees(&angle, &bits).unwrap();
        let sharp = Number(Ball::pi(&4000)) * Number::from(angle.clone()) / 180;
        assert!(cos.overlaps(&sharp.clone().cos().0), "cos {angle}");
        assert!(sin.overlaps(&sharp.sin().0), "sin {angle}");
        for value in [cos, sin] {
            let accuracy = value.accuracy_bits().unwrap();
            assert!(
                accuracy >= i64::from(bits) - 2,
                "{angle}: {accuracy} of {bits}"
            );
        }
    }
}

#[test]
fn rational_cosines_and_sines_are_exact() {
    for (degrees, cos, sin) in [
        (0, Some("1"), Some("0")),
        (-90, Some("0"), Some("-1")),
        (3600, Some("1"), Some("0")),
        (60, Some("1/2"), None),
        (240, Some("-1/2"), None),
        (-60, Some("1/2"), None),
        (30, None, Some("1/2")),
        (210, None, Some("-1/2")),
        (-390, None, Some("-1/2")),
    ] {
        let found = Ball::cos_sin_of_degrees(&Rational::from(degrees), &100).unwrap();
        for (value, exact) in [(found.0, cos), (found.1, sin)] {
            if let Some(exact) = exact {
                assert_eq!(value.radius_rational(), Some(Rational::new()));
                assert!(value.contains(&parse_rational(exact).unwrap()), "{degrees}");
            }
        }
    }
}

#[test]
fn narrow_arguments_give_narrow_results() {
    let bits = 200;
    let mid = Rational::from((3, 7));
    for (name, function) in FUNCTIONS {
        let mut ball = Ball::with_radius(&mid, &power_of_two(-150), bits);
        function(&mut ball);
        let accuracy = ball.accuracy_bits().unwrap();
        assert!(accuracy >= 145, "{name}: {accuracy} bits");
    }
}

#[test]
fn wide_arguments_are_kept_in_the_range() {
    let wide = |mid: i64, radius: i64| Number(Ball::with_radius(&mid.into(), &radius.into(), 64));
    let close = |ball: &Number<Ball>, low: f64, high: f64| {
        let found = (
            ball.0.lower().unwrap().to_f64(),
            ball.0.upper().unwrap().to_f64(),
        );
        assert!(
            (found.0 - low).abs() < 1e-6 && (found.1 - high).abs() < 1e-6,
            "{ball:?}"
        );
    };
    use std::f64::consts::{FRAC_PI_2, PI};
    close(&wide(0, 1000).sin(), -1.0, 1.0);
    close(&wide(0, 1).cos(), 0.0, 1.0);
    close(&wide(2, 1).asin(), FRAC_PI_2, FRAC_PI_2);
    close(&wide(0, 5).acos(), 0.0, PI);
    close(&wide(3, 5).sqrt(), 0.0, 8f64.sqrt());
    close(&wide(0, 1).atan2(&wide(-3, 1)), -PI, PI);
    close(&wide(1, 1).atan2(&wide(-3, 1)), 3.0 * PI / 4.0, PI);
    close(&wide(0, 1).atan2(&wide(0, 1)), -PI, PI);
    close(&wide(0, 1).atan2(&wide(1, 0)), -PI / 4.0, PI / 4.0);
    close(&wide(-2, 1).atan2(&wide(0, 1)), -3.0 * PI / 4.0, -PI / 4.0);
    assert!(wide(0, 2).tan().0.is_whole_line());
    assert!(wide(2, 1).tan().0.is_whole_line());
    assert!(!wide(0, 1).tan().0.is_whole_line());
}

#[test]
fn no_value_and_nothing_known_are_different() {
    let ball = |mid: i64, radius: i64| Number(Ball::with_radius(&mid.into(), &radius.into(), 64));
    let constant = Number::<Ball>::from;
    for undefined in [
        ball(1, 0) / 0,
        ball(1, 0) / ball(0, 0),
        constant(1) / 0,
        ball(-2, 1).sqrt() + ball(-3, 1).sqrt(),
        constant(-1).sqrt(),
        ball(3, 1).asin(),
        constant(2).acos(),
        constant(0).atan2(&ball(0, 0)),
        constant(0) * (constant(1) / 0),
        (constant(1) / 0).sin(),
    ] {
        assert!(!undefined.has_value());
        assert_eq!(undefined.to_string(), "no value");
    }
    for unknown in [
        ball(1, 0) / ball(0, 1),
        ball(0, 0) * (constant(1) / ball(0, 1)),
        constant(2).sqrt(),
        constant(1).sin(),
    ] {
        assert!(unknown.has_value() && unknown.0.is_whole_line());
        assert_eq!(unknown.to_string(), "nothing known");
        assert_eq!(unknown.sign(), None);
    }
    assert!(constant(4).sqrt().equals(&constant(2)).is_yes());
}

#[test]
fn constants_stay_exact_until_they_meet_a_precision() {
    let third = Number::<Ball>::ratio(1, 3);
    assert!((&third * 3).equals(&Number::one()).is_yes());
    let seven = Number(Ball::rounded(&7.into(), &300));
    let quotient = (third * 3 / seven).0;
    assert_eq!(quotient.precision(), Some(300));
    assert!(quotient.accuracy_bits().unwrap() >= 299);
}

#[test]
fn the_ends_of_the_exponent_range_give_no_false_certainty() {
    for start in [power_of_two(-1000), power_of_two(1000)] {
        for radius in [Rational::new(), &start * power_of_two(-20)] {
            let mut ball = Number(Ball::with_radius(&start, &radius, 53));
            for _ in 0..40 {
                ball = ball.square();
                assert!(ball.has_value());
                assert!(matches!(ball.sign(), None | Some(Ordering::Greater)));
                let inverse = 1 / &ball;
                assert!(matches!(inverse.sign(), None | Some(Ordering::Greater)));
            }
            assert_eq!(ball.sign(), None);
            for (name, function) in FUNCTIONS {
                let mut result = ball.0.clone();
                function(&mut result);
                assert!(
                    result.has_value() && result.sign().is_none_or(Ordering::is_gt),
                    "{name}"
                );
            }
        }
    }
}

/// One line of the file: function, exact arguments, the value and the radius to it.
fn outside_value(line: &str) -> (String, Vec<Rational>, Ball) {
    let fields: Vec<&str> = line.split(';').collect();
    let [name, arguments @ .., value, radius] = fields.as_slice() else {
        panic!("{line}");
    };
    let read = |text: &&str| parse_rational(text).unwrap();
    let ball = Ball::with_radius(&read(value), &read(radius), 400);
    (
        (*name).to_owned(),
        arguments.iter().map(read).collect(),
        ball,
    )
}

#[test]
fn values_of_another_ball_arithmetic_overlap() {
    let bits = 200;
    let text = include_str!("../data/ball_values.txt");
    let mut count = 0;
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let (name, arguments, outside) = outside_value(line);
        let argument = |i: usize| Ball::rounded(&arguments[i], &bits);
        let mut result = argument(0);
        match name.as_str() {
            "atan2" => result.atan2(&argument(1)),
            "cos_degrees" => result = Ball::cos_sin_of_degrees(&arguments[0], &bits).unwrap().0,
            "sin_degrees" => result = Ball::cos_sin_of_degrees(&arguments[0], &bits).unwrap().1,
            _ => {
                let (_, function) = FUNCTIONS.iter().find(|f| f.0 == name).unwrap();
                function(&mut result);
            }
        }
        assert!(result.overlaps(&outside), "{line}: {result:.60}");
        count += 1;
    }
    assert!(count >= 400, "{count} values");
}
