//! Five positions: all Burmester pairs with their full certificate, and in machine floats.
//!
//! `python3 scripts/peers` times the same beside other tools.
#![expect(
    clippy::unwrap_used,
    reason = "a benchmark that cannot set up has failed"
)]

use burmester::finite::five_positions::certified::certified;
use burmester::finite::five_positions::conics;
use burmester::finite::five_positions::floats;
use burmester::finite::five_positions::krawczyk::holds_one_pair;
use burmester::number::{Ball, Exact, Number};
use burmester::plane::Angle;
use burmester::plane::displacement::Displacement;
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

type Five<K> = [Displacement<K>; 5];

fn main() {
    divan::main();
}

/// Random problems, the same each time.
fn problems(count: usize) -> Vec<Five<Exact>> {
    let mut random = ChaCha8Rng::seed_from_u64(1888);
    let mut fraction = || -> Number<Exact> {
        Number::ratio(random.random_range(-60..=60), random.random_range(1..=12))
    };
    let mut position = || Displacement {
        rotation: Angle::from_tan_half(&fraction()).cis(),
        translation: Number::complex(fraction(), fraction()),
    };
    (0..count)
        .map(|_| std::array::from_fn(|_| position()))
        .collect()
}

fn in_floats(five: &Five<Exact>) -> Five<f64> {
    let float = |x: &Number<Exact>| Number(x.0.rational().unwrap().to_f64());
    five.each_ref().map(|position| position.map(float))
}

fn bits(digits: u32) -> u32 {
    digits * 10 / 3 + 1
}

/// One after the other, each time the next.
fn each<P, A>(bencher: Bencher<'_, '_>, problems: &[P], solve: impl Fn(&P) -> A + Sync)
where
    P: Sync,
{
    let mut place = 0;
    bencher.bench_local(|| {
        place = (place + 1) % problems.len();
        solve(black_box(problems.get(place).unwrap()))
    });
}

#[divan::bench(args = [70, 100, 1000, 10_000])]
fn full_certificate(bencher: Bencher<'_, '_>, digits: u32) {
    each(bencher, &problems(200), |five| {
        certified(five, bits(digits))
    });
}

/// The way of `solve`, which also tells what is multiple, at infinity and in families.
#[divan::bench]
fn by_exact_elimination(bencher: Bencher<'_, '_>) {
    each(bencher, &problems(200), conics::pairs);
}

/// The judge of one pair.
#[divan::bench(args = [100])]
fn judge(bencher: Bencher<'_, '_>, digits: u32) {
    let bits = bits(digits);
    let ball = |x: &Number<Exact>| Number::<Ball>::rounded(x.0.rational().unwrap(), &bits);
    let tasks = problems(200).into_iter().filter_map(|five| {
        let pair = certified(&five, bits)?.real.into_iter().next()?;
        Some((five.map(|position| position.map(ball)), pair.points()))
    });
    let tasks: Vec<_> = tasks.collect();
    each(bencher, &tasks, |(five, [z, m])| {
        holds_one_pair(five, [z, m], bits)
    });
}

#[divan::bench]
fn f64_one_problem(bencher: Bencher<'_, '_>) {
    let problems: Vec<Five<f64>> = problems(200).iter().map(in_floats).collect();
    each(bencher, &problems, floats::pairs);
}

/// On all cores.
#[divan::bench(sample_count = 20)]
fn f64_many_problems(bencher: Bencher<'_, '_>) {
    let many: Vec<Five<f64>> = problems(200).iter().map(in_floats).collect();
    let many: Vec<Five<f64>> = many.iter().cycle().take(50_000).cloned().collect();
    bencher
        .counter(ItemsCount::new(many.len()))
        .bench(|| floats::pairs_of_many(black_box(&many)));
}
