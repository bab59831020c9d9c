//! The deviation of one linkage: u and v at 360 crank angles, and how long an arc is.
//!
//! For comparison, 360 points on one core of an x86-64 server with AVX-512: in f64 11.9 µs with numpy,
//! 0.58 µs written by hand in C (47 operations and 6 cycles a point); with 50 certified digits 3.5 ms
//! with python-flint, 0.55 ms with Arb by hand. Here, built for any x86-64 (two
//! cores with AVX2 shared with other work): 0.44 µs in f64 at whole degrees, where 0.40 to 0.41 µs is what
//! that C takes there (2026-11-23), and 1.27 ms certified (2026-11-22); an arc 30 µs in f64 and 2.9 ms
//! certified to 128 bits, of which a search of all angles took about a second. No crate offers a coupler curve; what a user would
//! write instead is the linkage position by position, which `position_by_position` times.
#![expect(
    clippy::unwrap_used,
    reason = "a benchmark that cannot set up has failed"
)]

use burmester::number::{Ball, Number, Real};
use burmester::plane::{Angle, Point};
use burmester::straight_line::ball_burmester::{Alternate, double};
use burmester::straight_line::design::Design;
use burmester::straight_line::deviation::arc::Arcs;
use burmester::straight_line::deviation::closed::Closed;
use burmester::straight_line::deviation::driven::Driven;
use burmester::straight_line::deviation::floats::{Sampler, arc, whole_degrees};
use divan::{Bencher, black_box};

/// 50 digits.
const BITS: u32 = 168;

fn main() {
    divan::main();
}

fn turn(degrees: u32, bits: u32) -> Point<Ball> {
    let (cos, sin) = Ball::cos_sin_of_degrees(&degrees.into(), &bits).unwrap();
    Number::complex(Number(cos), Number(sin))
}

/// The representative linkage of Tesar's thesis, of which the crank turns fully.
fn design(bits: u32) -> Design<Ball> {
    let [a, b] = [65, 165].map(|degrees| {
        let turn = turn(degrees, bits);
        Angle::from_cos_sin(turn.re().clone(), turn.im().clone())
    });
    double(&a, &b).unwrap().design(Alternate::First).unwrap()
}

fn driven(bits: u32) -> Driven<Ball> {
    Driven::new(&design(bits)).unwrap()
}

fn float(x: &Number<Ball>) -> Number<f64> {
    Number(x.0.midpoint_rational().unwrap().to_f64())
}

fn unit(bits: u32) -> Number<Ball> {
    design(bits).unit()
}

#[divan::bench_group]
mod points_360 {
    use super::*;

    #[divan::bench]
    fn f64_whole_degrees(bencher: Bencher<'_, '_>) {
        let sampler = Sampler::new(&driven(BITS).closed().map(float));
        let [mut u, mut v] = [[0.0; 360]; 2];
        bencher.bench_local(|| {
            black_box(&sampler).sample_whole_degrees([&mut u, &mut v]);
            black_box((&u, &v));
        });
    }

    #[divan::bench]
    fn f64_slices(bencher: Bencher<'_, '_>) {
        let sampler = Sampler::new(&driven(BITS).closed().map(float));
        let [cos, sin] = whole_degrees();
        let [mut u, mut v] = [[0.0; 360]; 2];
        bencher.bench_local(|| {
            black_box(&sampler).sample([cos, sin], [&mut u, &mut v]);
            black_box((&u, &v));
        });
    }

    #[divan::bench]
    fn f64_position_by_position(bencher: Bencher<'_, '_>) {
        let driven = driven(BITS).map(float);
        let [cos, sin] = whole_degrees();
        bencher.bench_local(|| {
            for (cos, sin) in cos.iter().zip(sin) {
                let turn = Number::complex(Number(*cos), Number(*sin));
                let position = black_box(&driven).position(&turn);
                black_box(position.map(|position| driven.coordinates(&position)));
            }
        });
    }

    #[divan::bench]
    fn certified_50_digits(bencher: Bencher<'_, '_>) {
        let closed = driven(BITS).closed();
        let turns: Vec<Point<Ball>> = (0..360).map(|degrees| turn(degrees, BITS)).collect();
        bencher.bench_local(|| {
            for turn in &turns {
                black_box(black_box(&closed).place(turn));
            }
        });
    }

    #[divan::bench]
    fn certified_50_digits_position_by_position(bencher: Bencher<'_, '_>) {
        let driven = driven(BITS);
        let turns: Vec<Point<Ball>> = (0..360).map(|degrees| turn(degrees, BITS)).collect();
        bencher.bench_local(|| {
            for turn in &turns {
                let position = black_box(&driven).position(turn);
                black_box(position.map(|position| driven.coordinates(&position)));
            }
        });
    }
}

/// The arc on which |v| keeps within a hundredth of the linkage's size.
#[divan::bench_group]
mod arc_001 {
    use super::*;

    #[divan::bench]
    fn f64_arc(bencher: Bencher<'_, '_>) {
        let closed: Closed<f64> = driven(BITS).closed().map(float);
        let bound = float(&unit(BITS)).0 / 100.0;
        bencher.bench_local(|| arc(black_box(&closed), bound));
    }

    #[divan::bench(args = [128, 264])]
    fn certified(bencher: Bencher<'_, '_>, bits: u32) {
        let driven = driven(bits);
        let bound = unit(bits) / 100;
        bencher.bench_local(|| Arcs::new(black_box(&driven).clone(), bits).within(&bound));
    }
}
