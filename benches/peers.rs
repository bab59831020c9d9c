//! Our side of `python3 scripts/peers`: one row of the table "Speed to reach", on the problems of a file.
//!
//! `peers ROW FILE answers|times` prints JSON lines as every program of `scripts/peers` does: for each task
//! of the row `{"task": …, "seconds": …}`, and after the word `answers` `{"task": …, "answer": …}` for each
//! problem. A line of the file is one problem, as numbers p/q. A ball is written "m e r f" in hexadecimal,
//! m 2^e ± r 2^f, an exact number as p/q.
#![expect(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a benchmark that cannot set up has failed"
)]

use std::cell::RefCell;
use std::hint::black_box;

use burmester::finite::five_positions::certified::certified;
use burmester::finite::five_positions::conditions::{Coordinates, finite_pair};
use burmester::finite::five_positions::floats;
use burmester::finite::four_positions::circle_conditions;
use burmester::number::text::parse_rational;
use burmester::number::univariate::Polynomial;
use burmester::number::{Ball, Complex, Exact, Fraction, Kind, Number, Real, Ring};
use burmester::plane::curve_type::CurveType;
use burmester::plane::displacement::Displacement;
use burmester::plane::focal_cubic::FocalCubic;
use burmester::plane::projective::ProjectivePoint;
use burmester::plane::trace::Trace;
use burmester::plane::{Angle, Point};
use burmester::straight_line::deviation::closed::Closed;
use burmester::straight_line::deviation::floats::{Sampler, whole_degrees};
use rug::Rational;
use serde_json::{Value, json};

type Five<K> = [Displacement<K>; 5];
type Line = Vec<Rational>;

/// Bits that are asked for beyond those which are wanted.
const SPARE_BITS: u32 = 4;
/// Points of a curve.
const POINTS: i64 = 10_000;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [row, file, what, ..] = arguments.as_slice() else {
        println!("peers ROW FILE answers|times; see scripts/peers/README.md");
        return;
    };
    let text = std::fs::read_to_string(file).unwrap();
    let numbers = |line: &str| -> Line {
        let words = line.split_whitespace();
        words.map(|word| parse_rational(word).unwrap()).collect()
    };
    let run = Run {
        lines: text.lines().map(numbers).collect(),
        answers: what == "answers",
    };
    match row.split_once('-').unwrap_or((row, "")) {
        ("five", "f64") => run.five_in_floats(),
        ("five", digits) => run.five_certified(digits.parse().unwrap()),
        ("cubic", _) => run.cubic(),
        ("curve", "f64") => run.curve_in_floats(),
        ("curve", bits) => run.curve_certified(bits.parse().unwrap()),
        ("deviation", "f64") => run.deviation_in_floats(),
        ("deviation", digits) => run.deviation_certified(digits.parse().unwrap()),
        ("expansion", _) => run.expansion(),
        ("arithmetic", bits) => run.arithmetic(bits.parse().unwrap()),
        _ => panic!("no row {row}"),
    }
}

struct Run {
    lines: Vec<Line>,
    answers: bool,
}

impl Run {
    /// Solves each problem three times; its time is the quickest, that of the task their median.
    fn each<P, A>(
        &self,
        task: &str,
        problems: &[P],
        solve: impl Fn(&P) -> A,
        written: impl Fn(&A) -> Value,
    ) {
        let mut seconds: Vec<f64> = problems
            .iter()
            .map(|problem| {
                (0..3)
                    .map(|_| timed(|| solve(problem)))
                    .fold(f64::MAX, f64::min)
            })
            .collect();
        self.seconds(task, median(&mut seconds));
        if self.answers {
            for problem in problems {
                answer(task, &written(&solve(problem)));
            }
        }
    }

    /// Passes over all problems one after the other; the time is that of the quickest pass for a problem.
    fn passes<P, A>(
        &self,
        task: &str,
        problems: &[P],
        solve: impl Fn(&P) -> A,
        written: impl Fn(&A) -> Value,
    ) {
        let pass = || {
            for problem in problems {
                black_box(solve(black_box(problem)));
            }
        };
        let count = f64::from(u32::try_from(problems.len()).unwrap());
        self.seconds(task, quickest(pass) / count);
        if self.answers {
            for problem in problems {
                answer(task, &written(&solve(problem)));
            }
        }
    }

    fn seconds(&self, task: &str, seconds: f64) {
        println!("{}", json!({"task": task, "seconds": seconds}));
    }

    fn positions<const N: usize>(&self) -> Vec<[Displacement<Exact>; N]> {
        let position = |c: &[Rational]| {
            let [cos, sin, x, y] = [0, 1, 2, 3].map(|i| Number::from(c[i].clone()));
            Displacement {
                rotation: Number::complex(cos, sin),
                translation: Number::complex(x, y),
            }
        };
        let all = |line: &Line| -> Vec<_> { line.chunks(4).map(position).collect() };
        let all = self
            .lines
            .iter()
            .map(|line| all(line).try_into().ok().unwrap());
        all.collect()
    }

    /// All pairs, none missing, each proven on the conditions themselves.
    fn five_certified(&self, digits: u32) {
        let bits = digits * 10 / 3 + 1;
        let problems = self.positions::<5>();
        self.each("pairs", &problems, |five| pairs(five, bits), written_pairs);
    }

    fn five_in_floats(&self) {
        let problems = self.positions::<5>();
        let problems: Vec<Five<f64>> = problems
            .iter()
            .map(|five| five.each_ref().map(|position| position.map(float)))
            .collect();
        let written = |pairs: &Option<Vec<Coordinates<Complex<f64>>>>| {
            let finite = |pair: &Coordinates<Complex<f64>>| {
                let [h, x, y, cx, cy, ..] = pair;
                [x, y, cx, cy].map(|part| {
                    let part = part / h;
                    json!([part.re().0, part.im().0])
                })
            };
            let pairs = pairs.as_ref().unwrap();
            json!(pairs.iter().map(finite).collect::<Vec<_>>())
        };
        self.each("one", &problems, floats::pairs, written);
        self.passes("many", &problems, floats::pairs, written);
    }

    fn cubic(&self) {
        self.each(
            "coefficients",
            &self.positions::<4>(),
            circle_conditions::centerpoint_cubic,
            |cubic| {
                let coefficients = cubic.as_ref().unwrap().coefficients().iter();
                json!(
                    coefficients
                        .map(|c| c.0.rational().unwrap().to_string())
                        .collect::<Vec<_>>()
                )
            },
        );
    }

    fn traces<K: Real>(&self, number: impl Fn(&Rational) -> Number<K>) -> Vec<Trace<K>> {
        let trace = |line: &Line| {
            let point = |x: usize| Number::complex(number(&line[x]), number(&line[x + 1]));
            let curve = FocalCubic {
                focus: point(0),
                alpha: point(2),
                beta: number(&line[4]),
                nu: point(5),
            };
            let two = curve.discriminant().sign().unwrap().is_gt();
            let kind = if two {
                CurveType::TwoBranches
            } else {
                CurveType::OneBranch
            };
            Trace::new(curve, kind).unwrap()
        };
        self.lines.iter().map(trace).collect()
    }

    fn curve_in_floats(&self) {
        let traces = self.traces(|q| Number(q.to_f64()));
        let all = |trace: &Trace<f64>| trace_all(trace, |t| Number(t.to_f64()));
        self.curve(&traces, all, |x| json!(x.0));
    }

    fn curve_certified(&self, bits: u32) {
        let ball = |q: &Rational| Number::<Ball>::rounded(q, &bits);
        let all = |trace: &Trace<Ball>| trace_all(trace, ball);
        self.curve(&self.traces(ball), all, written_ball);
    }

    fn curve<K: Real>(
        &self,
        traces: &[Trace<K>],
        turns: impl Fn(&Trace<K>) -> Vec<Point<K>>,
        number: impl Fn(&Number<K>) -> Value,
    ) {
        let problems: Vec<_> = traces.iter().map(|trace| (trace, turns(trace))).collect();
        let solve = |(trace, turns): &(&Trace<K>, Vec<Point<K>>)| -> Vec<ProjectivePoint<K>> {
            let branches = trace.branches().iter();
            branches
                .flat_map(|branch| turns.iter().map(|turn| trace.point(*branch, turn)))
                .collect()
        };
        self.each("points", &problems, solve, |points| {
            let coordinates = points
                .iter()
                .map(|point| point.coordinates().each_ref().map(&number));
            json!(coordinates.collect::<Vec<_>>())
        });
    }

    fn linkages<K: Kind>(&self, number: impl Fn(&Rational) -> Number<K>) -> Vec<Closed<K>> {
        let linkage = |line: &Line| {
            let number = |i: usize| number(&line[i]);
            let point = |i: usize| Number::complex(number(i), number(i + 1));
            Closed {
                start: point(0),
                crank: point(2),
                base: point(4),
                arm: point(6),
                middle: number(8),
                swing: point(9),
                difference: number(11),
                dead: [number(12), number(13)],
                is_left: line[14] > 0,
            }
        };
        self.lines.iter().map(linkage).collect()
    }

    fn deviation_in_floats(&self) {
        let linkages = self.linkages(|q| Number(q.to_f64()));
        let samplers: Vec<_> = linkages.iter().map(Sampler::new).collect();
        let [cos, sin] = whole_degrees();
        let places = RefCell::new([[0.0; 360]; 2]);
        let solve = |sampler: &Sampler| {
            let [u, v] = &mut *places.borrow_mut();
            sampler.sample([cos, sin], [u, v]);
            black_box((u, v));
        };
        self.passes("places", &samplers, solve, |()| {
            json!(places.borrow().each_ref().map(|part| part.as_slice()))
        });
    }

    fn deviation_certified(&self, digits: u32) {
        let bits = digits * 10 / 3 + 2;
        let linkages = self.linkages(|q| Number::<Ball>::rounded(q, &bits));
        let turn = |degrees: u32| {
            let (cos, sin) = Ball::cos_sin_of_degrees(&degrees.into(), &bits).unwrap();
            Number::complex(Number(cos), Number(sin))
        };
        let turns: Vec<Point<Ball>> = (0..360).map(turn).collect();
        let solve = |closed: &Closed<Ball>| -> Vec<_> {
            turns.iter().map(|turn| closed.place(turn)).collect()
        };
        self.each("places", &linkages, solve, |places| {
            let u = places.iter().map(|place| written_ball(&place.u));
            let v = places.iter().map(|place| written_ball(&place.v));
            json!([u.collect::<Vec<_>>(), v.collect::<Vec<_>>()])
        });
    }

    /// The resultant of y² + (ax + b)y + (cx² + dx + e) and y² + (fx + g)y + (hx² + kx + l), by powers of x.
    fn expansion(&self) {
        let names = ["a", "b", "c", "d", "e", "f", "g", "h", "k", "l"];
        let numbers: [Number<Fraction>; 10] = Ring::free(&names).unwrap().numbers();
        let solve = |[a, b, c, d, e, f, g, h, k, l]: &[Number<Fraction>; 10]| {
            let polynomial = |parts: &[&Number<Fraction>]| {
                Polynomial::new(parts.iter().map(|part| (*part).clone()).collect())
            };
            let [p, p1] = [polynomial(&[b, a]), polynomial(&[g, f])];
            let [q, q1] = [polynomial(&[e, d, c]), polynomial(&[l, k, h])];
            let difference = &q - &q1;
            &difference * &difference + &(&p - &p1) * &(&p * &q1 - &p1 * &q)
        };
        let problems = vec![numbers; 20];
        self.each("expansion", &problems, solve, |resultant| {
            let parts = resultant.coefficients().iter();
            json!(parts.map(|part| part.0.to_string()).collect::<Vec<_>>())
        });
    }

    fn arithmetic(&self, bits: u32) {
        let operands: Vec<[Number<Ball>; 2]> = self
            .lines
            .iter()
            .map(|line| [0, 1].map(|i| Number::rounded(&line[i], &bits)))
            .collect();
        let one = |x: &Number<Ball>| json!([written_ball(x)]);
        self.passes("add", &operands, |[a, b]| a + b, one);
        self.passes("mul", &operands, |[a, b]| a * b, one);
        self.passes("div", &operands, |[a, b]| a / b, one);
        self.passes("sqrt", &operands, |[a, _]| a.clone().sqrt(), one);
        let both = |[a, _]: &[Number<Ball>; 2]| [a.clone().sin(), a.clone().cos()];
        self.passes("sin+cos", &operands, both, |x| {
            json!(x.each_ref().map(written_ball))
        });
        self.passes("atan", &operands, |[a, _]| a.clone().atan(), one);
    }
}

struct Pairs {
    real: Vec<[Point<Ball>; 2]>,
    complex: Vec<[Number<Complex<Ball>>; 4]>,
}

/// All finite pairs, every point known to so many bits of its larger coordinate.
fn pairs(five: &Five<Exact>, bits: u32) -> Pairs {
    let mut working = bits + SPARE_BITS;
    loop {
        let found = pairs_of_roots(five, working);
        if found.are_sharp(bits) {
            return found;
        }
        working += 8 * SPARE_BITS;
    }
}

fn pairs_of_roots(five: &Five<Exact>, bits: u32) -> Pairs {
    let found = certified(five, bits).unwrap();
    let quotients = |[h, x, y, cx, cy, ..]: &Coordinates<Complex<Ball>>| {
        let inverse = h.inverse();
        [x, y, cx, cy].map(|part| part * &inverse)
    };
    Pairs {
        real: (found.real.iter())
            .map(|pair| finite_pair(&pair.coordinates))
            .collect(),
        complex: (found.complex.iter())
            .map(|pair| quotients(&pair.coordinates))
            .collect(),
    }
}

impl Pairs {
    fn are_sharp(&self, bits: u32) -> bool {
        let mut real = self.real.iter().flatten();
        let mut complex = self.complex.iter().flat_map(|pair| pair.chunks(2));
        real.all(|point| is_sharp(&[point.re(), point.im()], bits))
            && complex.all(|point| {
                let parts: Vec<_> = point.iter().flat_map(|z| [z.re(), z.im()]).collect();
                is_sharp(&parts, bits)
            })
    }
}

fn is_sharp(parts: &[&Number<Ball>], bits: u32) -> bool {
    if (parts.iter()).all(|x| x.0.accuracy_bits() > Some(i64::from(bits))) {
        return true;
    }
    let middles = parts.iter().map(|x| x.0.midpoint_rational().unwrap().abs());
    let most = middles.max().unwrap() >> bits;
    (parts.iter()).all(|x| x.0.radius_rational().unwrap() <= most)
}

/// The number of real pairs, and x, y, X, Y of all.
fn written_pairs(pairs: &Pairs) -> Value {
    let real =
        (pairs.real.iter()).map(|[z, m]| json!([z.re(), z.im(), m.re(), m.im()].map(written_ball)));
    let part = |z: &Number<Complex<Ball>>| [z.re(), z.im()].map(written_ball);
    let complex = pairs
        .complex
        .iter()
        .map(|pair| json!(pair.each_ref().map(part)));
    json!([pairs.real.len(), real.chain(complex).collect::<Vec<_>>()])
}

/// Points of the unit circle: half of it for each of two branches, as for one.
fn trace_all<K: Real>(trace: &Trace<K>, number: impl Fn(&Rational) -> Number<K>) -> Vec<Point<K>> {
    let half = POINTS / 2 / i64::try_from(trace.branches().len()).unwrap();
    (-half..half)
        .map(|n| {
            let turn = Angle::from_tan_half(&Number::<Exact>::ratio(n, half)).cis();
            let part = |x: &Number<Exact>| number(x.0.rational().unwrap());
            Number::complex(part(turn.re()), part(turn.im()))
        })
        .collect()
}

fn float(x: &Number<Exact>) -> Number<f64> {
    Number(x.0.rational().unwrap().to_f64())
}

/// "m e r f", or "p/q" where it is exact but no binary number.
fn written_ball(x: &Number<Ball>) -> Value {
    let [middle, radius] = [x.0.midpoint_rational(), x.0.radius_rational()].map(Option::unwrap);
    if !middle.denom().is_power_of_two() {
        assert_eq!(radius, 0, "a midpoint is a binary number");
        return json!(middle.to_string());
    }
    let binary = |q: Rational| {
        let (p, q) = q.into_numer_denom();
        format!("{p:x} -{:x}", q.significant_bits() - 1)
    };
    json!(format!("{} {}", binary(middle), binary(radius)))
}

fn answer(task: &str, answer: &Value) {
    println!("{}", json!({"task": task, "answer": answer}));
}

/// Seconds that this thread has had a processor for: others on the machine do not count.
#[cfg(all(target_os = "linux", target_pointer_width = "64"))]
#[expect(unsafe_code, reason = "the standard library has no such clock")]
fn clock() -> f64 {
    #[repr(C)]
    struct Time {
        seconds: i64,
        nanoseconds: i64,
    }
    unsafe extern "C" {
        fn clock_gettime(clock: i32, time: *mut Time) -> i32;
    }
    const THREAD_CPU_TIME: i32 = 3;
    let mut time = Time {
        seconds: 0,
        nanoseconds: 0,
    };
    // SAFETY: the C library's function of this name, given room for its result.
    let status = unsafe { clock_gettime(THREAD_CPU_TIME, &raw mut time) };
    assert_eq!(status, 0, "no clock");
    let [seconds, nanoseconds] = [time.seconds, time.nanoseconds].map(u64::try_from);
    std::time::Duration::new(
        seconds.unwrap(),
        u32::try_from(nanoseconds.unwrap()).unwrap(),
    )
    .as_secs_f64()
}

#[cfg(not(all(target_os = "linux", target_pointer_width = "64")))]
fn clock() -> f64 {
    static START: std::sync::LazyLock<std::time::Instant> =
        std::sync::LazyLock::new(std::time::Instant::now);
    START.elapsed().as_secs_f64()
}

fn timed<A>(solve: impl Fn() -> A) -> f64 {
    let start = clock();
    black_box(solve());
    clock() - start
}

/// The quickest of many passes, in a tenth of a second.
fn quickest(pass: impl Fn()) -> f64 {
    let start = clock();
    let mut best = f64::MAX;
    while clock() - start < 0.1 {
        best = best.min(timed(&pass));
    }
    best
}

fn median(seconds: &mut [f64]) -> f64 {
    seconds.sort_by(f64::total_cmp);
    let half = seconds.len() / 2;
    if seconds.len() % 2 == 1 {
        return seconds[half];
    }
    f64::midpoint(seconds[half - 1], seconds[half])
}
