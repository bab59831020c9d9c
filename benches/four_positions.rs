//! Four positions: the ten coefficients of the centerpoint curve, and points of it.
//!
//! For comparison, on one core of an x86-64 server with AVX-512 (medians of 2026-11-22): exact
//! coefficients 47 µs with PARI; 10 000 points in f64 139 µs with numpy and 12 µs with AVX-512 by hand,
//! in 256 bits certified 45 ms with python-flint and 12.6 ms with Arb by hand. Here, on a core with AVX2
//! shared with other work (2026-11-23): 10 000 points in f64 8.3 µs on lines through the focus, 7.3 µs with
//! the same in C with fused operations, and 360 µs by the generic parametrisation.
#![expect(
    clippy::unwrap_used,
    reason = "a benchmark that cannot set up has failed"
)]

use burmester::finite::four_positions::{
    circle_conditions, isotropic, loop_closure, viewing_angles,
};
use burmester::finite::positions::Positions;
use burmester::number::{Ball, Elementary, Exact, Number, Real};
use burmester::plane::circular_cubic::Cubic;
use burmester::plane::curve_type::curve_type;
use burmester::plane::displacement::Displacement;
use burmester::plane::focal_cubic::FocalCubic;
use burmester::plane::pencil::meets;
use burmester::plane::projective::ProjectivePoint;
use burmester::plane::trace::Trace;
use burmester::plane::{Angle, Point};
use divan::{Bencher, black_box};
use rug::Rational;

fn main() {
    divan::main();
}

fn positions() -> [Displacement<Exact>; 4] {
    [(0, 1, 0, 0), (1, 2, 3, 1), (-1, 2, 5, -1), (-3, 1, 2, 4)].map(|(n, d, x, y)| Displacement {
        rotation: Angle::from_tan_half(&Number::ratio(n, d)).cis(),
        translation: Number::complex(x.into(), y.into()),
    })
}

type ByDisplacements = fn(&[Displacement<Exact>; 4]) -> Option<Cubic<Exact>>;
type ByPoles = fn(&Positions<Exact>) -> Option<Cubic<Exact>>;

#[divan::bench(args = ["circle conditions", "loop closure"])]
fn coefficients_by_displacements(bencher: Bencher<'_, '_>, route: &str) {
    let four = positions();
    let route: ByDisplacements = if route == "loop closure" {
        loop_closure::centerpoint_cubic
    } else {
        circle_conditions::centerpoint_cubic
    };
    bencher.bench_local(|| route(black_box(&four)));
}

#[divan::bench(args = ["viewing angles", "isotropic"])]
fn coefficients_by_poles(bencher: Bencher<'_, '_>, route: &str) {
    let four = positions();
    let route: ByPoles = if route == "isotropic" {
        isotropic::centerpoint_cubic
    } else {
        viewing_angles::centerpoint_cubic
    };
    // The poles are part of the work.
    bencher.bench_local(|| route(&Positions::new(black_box(&four).to_vec())));
}

const POINTS: i64 = 10_000;
const LINES: u16 = 5_000;

fn trace<K: Real>(convert: impl Fn(&Rational) -> Number<K>) -> Trace<K> {
    let cubic = circle_conditions::centerpoint_cubic(&positions()).unwrap();
    let kind = curve_type(&cubic).unwrap();
    let coefficients = cubic.coefficients().each_ref();
    let converted = Cubic::new(coefficients.map(|c| convert(c.0.rational().unwrap())));
    Trace::new(FocalCubic::of(&converted).unwrap(), kind).unwrap()
}

/// Points of the unit circle, by the tangents of their halves.
fn turns<K: Elementary>(precision: &K::Precision) -> Vec<Point<K>> {
    let half = POINTS / 4;
    (-half..half)
        .map(|n| {
            let t = Rational::from((n, half));
            Angle::from_tan_half(&Number::<K>::rounded(&t, precision)).cis()
        })
        .collect()
}

fn all_points<K: Real>(trace: &Trace<K>, turns: &[Point<K>]) -> Vec<ProjectivePoint<K>> {
    let branches = trace.branches().iter();
    branches
        .flat_map(|branch| turns.iter().map(|turn| trace.point(*branch, turn)))
        .collect()
}

#[divan::bench]
fn ten_thousand_points_f64(bencher: Bencher<'_, '_>) {
    let trace = trace::<f64>(|q| Number(q.to_f64()));
    let turns = turns::<f64>(&());
    bencher.bench_local(|| all_points(black_box(&trace), black_box(&turns)));
}

/// Both points of five thousand lines through the focus.
#[divan::bench]
fn ten_thousand_points_f64_slices(bencher: Bencher<'_, '_>) {
    let cubic = circle_conditions::centerpoint_cubic(&positions()).unwrap();
    let coefficients = cubic.coefficients().each_ref();
    let floats = coefficients.map(|c| Number(c.0.rational().unwrap().to_f64()));
    let curve = FocalCubic::of(&Cubic::<f64>::new(floats)).unwrap();
    let angle = |line: u16| f64::from(line) * std::f64::consts::PI / f64::from(LINES);
    let [cos, sin] =
        [f64::cos, f64::sin].map(|f| (0..LINES).map(|n| f(angle(n))).collect::<Vec<_>>());
    let mut points = [(); 4].map(|()| vec![0.0; LINES.into()]);
    bencher.bench_local(|| {
        let [x, y, u, v] = &mut points;
        meets(black_box(&curve), [&cos, &sin], [[x, y], [u, v]]);
        black_box(&points);
    });
}

#[divan::bench(sample_count = 20)]
fn ten_thousand_points_256_bits(bencher: Bencher<'_, '_>) {
    let trace = trace::<Ball>(|q| Number::rounded(q, &256));
    let turns = turns::<Ball>(&256);
    bencher.bench_local(|| all_points(black_box(&trace), black_box(&turns)));
}
