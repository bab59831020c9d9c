//! Five positions: all Burmester pairs, to so many digits, and in machine floats.
//!
//! `cargo bench --bench five_positions` times problems of its own; with BURMESTER_PROBLEMS set to a
//! file of them, one a line (`scripts/five_positions_outside.py --write FILE`), those: printed is the
//! median of a problem, a line `digits seconds` each. `python3 scripts/peers` compares with other tools.
//!
//! For comparison, on one core of an x86-64 server with AVX-512 (medians of 2026-11-22): 266 µs at 100
//! and 1.46 ms at 1000 digits with python-flint; in f64 60 to 90 µs with numpy for one
//! problem, 4 µs a problem for many, 0.72 µs with a C++ kernel. Here, on two cores with AVX2 shared with
//! other work (2026-11-23): in f64 1.2 µs for one, of which the way of before took 9.0 µs, and 0.8 µs a
//! problem for many; the kernel alone takes 0.19 µs on one core, the same in C++ with vectors and fused
//! operations 0.16 µs.
#![expect(
    clippy::unwrap_used,
    reason = "a benchmark that cannot set up has failed"
)]

use std::hint::black_box;
use std::time::Instant;

use burmester::finite::five_positions::certified::certified;
use burmester::finite::five_positions::conditions::finite_pair;
use burmester::finite::five_positions::conics::Place;
use burmester::finite::five_positions::{floats, krawczyk};
use burmester::number::text::parse_rational;
use burmester::number::{Ball, Complex, Exact, Number};
use burmester::plane::displacement::Displacement;
use burmester::plane::{Angle, Point};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rug::Rational;
use serde_json::Value;

type Five<K> = [Displacement<K>; 5];

const DIGITS: [u32; 5] = [16, 30, 100, 1000, 10_000];
/// Problems at 10 000 digits; at less all of them.
const FEW: usize = 20;
/// Problems at once.
const MANY: u16 = 50_000;

fn main() {
    let problems =
        std::env::var("BURMESTER_PROBLEMS").map_or_else(|_| random(), |file| read(&file));
    println!("# {} problems; digits, median seconds", problems.len());
    for digits in DIGITS {
        let count = if digits > 1000 { FEW } else { problems.len() };
        let bits = digits * 10 / 3 + 16;
        let solve = |five: &Five<Exact>| points(five, bits);
        println!(
            "{digits} {:.7}",
            median(problems.get(..count).unwrap_or(&problems), solve)
        );
    }
    let rounded: Vec<Five<f64>> = problems.iter().map(in_floats).collect();
    let seconds = median(&rounded, floats::pairs);
    println!("f64 {seconds:.7}");
    println!(
        "f64-careful {:.7}",
        median(&rounded, floats::careful::pairs)
    );
    println!("f64-many {:.9}", of_many(&rounded));
    report_errors(&problems, &rounded);
    println!("judge {:.7}", judge(&problems));
}

/// The median time of a problem, each solved until the clock sees it.
fn median<P, A>(problems: &[P], solve: impl Fn(&P) -> A) -> f64 {
    let mut seconds: Vec<f64> = problems
        .iter()
        .map(|problem| {
            let time = || {
                let start = Instant::now();
                black_box(solve(black_box(problem)));
                start.elapsed().as_secs_f64()
            };
            (0..3).map(|_| time()).fold(f64::INFINITY, f64::min)
        })
        .collect();
    seconds.sort_by(f64::total_cmp);
    seconds.get(seconds.len() / 2).copied().unwrap_or(f64::NAN)
}

/// The time of a problem among many on all cores, those given over and over.
fn of_many(problems: &[Five<f64>]) -> f64 {
    let many: Vec<Five<f64>> = problems.iter().cycle().take(MANY.into()).cloned().collect();
    let time = || {
        let start = Instant::now();
        black_box(floats::pairs_of_many(black_box(&many)));
        start.elapsed().as_secs_f64()
    };
    (0..20).map(|_| time()).fold(f64::INFINITY, f64::min) / f64::from(MANY)
}

type Points = (Vec<[Point<Ball>; 2]>, Vec<[Number<Complex<Ball>>; 4]>);

/// All finite pairs, the complex ones by one of each couple.
fn points(five: &Five<Exact>, bits: u32) -> Option<Points> {
    let found = certified(five, bits)?;
    let real = found
        .real
        .into_iter()
        .filter(|pair| pair.place == Place::Finite);
    let complex = found
        .complex
        .into_iter()
        .filter(|pair| pair.place == Place::Finite);
    let quotients = |[h, x, y, cx, cy, ..]: [Number<Complex<Ball>>; 7]| {
        let inverse = h.inverse();
        [x, y, cx, cy].map(|part| part * &inverse)
    };
    Some((
        real.map(|pair| finite_pair(&pair.coordinates)).collect(),
        complex.map(|pair| quotients(pair.coordinates)).collect(),
    ))
}

/// The relative errors of real pairs in floats: of each the largest coordinate against the distance of
/// the nearest certified pair.
fn report_errors(problems: &[Five<Exact>], rounded: &[Five<f64>]) {
    let mut errors = Vec::new();
    let mut missed = 0;
    for (exact, floats) in problems.iter().zip(rounded) {
        let Some((real, _)) = points(exact, 128) else {
            continue;
        };
        let found = floats::pairs(floats).unwrap_or_default();
        for pair in real {
            let [z, m] = pair;
            let wanted = [z.re(), z.im(), m.re(), m.im()].map(middle);
            let size = wanted.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            let distance = |pair: &[Number<Complex<f64>>; 7]| {
                let [h, x, y, cx, cy, ..] = pair.each_ref().map(|z| z.re().0);
                let given = [x / h, y / h, cx / h, cy / h];
                given
                    .iter()
                    .zip(wanted)
                    .fold(0.0, |a: f64, (b, c)| a.max((b - c).abs()))
            };
            let nearest = found.iter().map(distance).fold(f64::INFINITY, f64::min) / size;
            if nearest < 1e-3 {
                errors.push(nearest);
            } else {
                missed += 1;
            }
        }
    }
    errors.sort_by(f64::total_cmp);
    let at = |hundredths: usize| {
        let place = errors.len().saturating_sub(1) * hundredths / 100;
        errors.get(place).copied().unwrap_or(f64::NAN)
    };
    println!(
        "# relative errors of {} real pairs in f64: median {:.1e}, 99 of 100 below {:.1e}, worst {:.1e}; \
         {missed} missed",
        errors.len(),
        at(50),
        at(99),
        at(100)
    );
}

fn middle(x: &Number<Ball>) -> f64 {
    x.0.midpoint_rational().unwrap().to_f64()
}

/// The median time of the interval test of one pair.
fn judge(problems: &[Five<Exact>]) -> f64 {
    let bits = 400;
    let tasks: Vec<(Five<Ball>, [Point<Ball>; 2])> = problems
        .iter()
        .filter_map(|five| {
            let pair = points(five, bits)?.0.into_iter().next()?;
            let ball = |x: &Number<Exact>| Number::<Ball>::rounded(x.0.rational().unwrap(), &bits);
            let point = |z: &Point<Exact>| Number::complex(ball(z.re()), ball(z.im()));
            let balls = five.each_ref().map(|d| Displacement {
                rotation: point(&d.rotation),
                translation: point(&d.translation),
            });
            Some((balls, pair))
        })
        .collect();
    median(&tasks, |(five, [z, m])| {
        krawczyk::holds_one_pair(five, [z, m], bits)
    })
}

fn in_floats(five: &Five<Exact>) -> Five<f64> {
    let float = |x: &Number<Exact>| Number(x.0.rational().unwrap().to_f64());
    let point = |z: &Point<Exact>| Number::complex(float(z.re()), float(z.im()));
    five.each_ref().map(|d| Displacement {
        rotation: point(&d.rotation),
        translation: point(&d.translation),
    })
}

fn random() -> Vec<Five<Exact>> {
    let mut random = ChaCha8Rng::seed_from_u64(1888);
    let mut fraction = || -> Number<Exact> {
        Number::ratio(random.random_range(-60..=60), random.random_range(1..=12))
    };
    let mut position = || Displacement {
        rotation: Angle::from_tan_half(&fraction()).cis(),
        translation: Number::complex(fraction(), fraction()),
    };
    (0..200)
        .map(|_| std::array::from_fn(|_| position()))
        .collect()
}

fn read(file: &str) -> Vec<Five<Exact>> {
    let text = std::fs::read_to_string(file).unwrap();
    text.lines()
        .map(|line| problem(&serde_json::from_str(line).unwrap()))
        .collect()
}

fn problem(problem: &Value) -> Five<Exact> {
    let number = |value: &Value| -> Number<Exact> {
        let exact: Rational = parse_rational(value.as_str().unwrap()).unwrap();
        exact.into()
    };
    let position = |value: &Value| {
        let angle = &value["angle"];
        let rotation = match angle.get("tan_half") {
            Some(half) => Angle::from_tan_half(&number(half)).cis(),
            None => Number::complex(number(&angle["cos"]), number(&angle["sin"])),
        };
        Displacement {
            rotation,
            translation: Number::complex(number(&value["x"]), number(&value["y"])),
        }
    };
    let positions: Vec<_> = problem["positions"]
        .as_array()
        .unwrap()
        .iter()
        .map(position)
        .collect();
    positions.try_into().ok().unwrap()
}
