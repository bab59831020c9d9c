//! Single operations on balls of 128 bits, and the expansion of Tesar's (3.25) from (3.24).
//!
//! `python3 scripts/peers` times the same beside other tools.
#![expect(
    clippy::unwrap_used,
    reason = "a benchmark that cannot set up has failed"
)]

use burmester::number::{Ball, Fraction, Number, Polynomial, Ring};
use divan::{Bencher, black_box};
use rug::Rational;

type B = Number<Ball>;

fn main() {
    divan::main();
}

const BITS: u32 = 128;

fn operands() -> [B; 2] {
    [(355, 452), (-271, 1000)].map(|q| Number::rounded(&Rational::from(q), &BITS))
}

#[divan::bench_group]
mod balls_of_128_bits {
    use super::*;

    #[divan::bench(args = ["+", "·", "/"])]
    fn operation(bencher: Bencher<'_, '_>, sign: &str) {
        let [a, b] = operands();
        let operate: fn(&B, &B) -> B = match sign {
            "+" => |a, b| a + b,
            "·" => |a, b| a * b,
            _ => |a, b| a / b,
        };
        bencher.bench(|| operate(black_box(&a), black_box(&b)));
    }

    #[divan::bench(args = ["sqrt", "sin", "cos", "atan"])]
    fn function(bencher: Bencher<'_, '_>, name: &str) {
        let [a, _] = operands();
        let apply: fn(B) -> B = match name {
            "sqrt" => B::sqrt,
            "sin" => B::sin,
            "cos" => B::cos,
            _ => B::atan,
        };
        bencher.bench(|| apply(black_box(&a).clone()));
    }
}

/// The resultant of y² + (ax + b)y + (cx² + dx + e) and y² + (fx + g)y + (hx² + kx + l), by powers of x.
#[divan::bench]
fn expansion_of_3_25(bencher: Bencher<'_, '_>) {
    let names = ["a", "b", "c", "d", "e", "f", "g", "h", "k", "l"];
    let [a, b, c, d, e, f, g, h, k, l]: [Number<Fraction>; 10] =
        Ring::free(&names).unwrap().numbers();
    bencher.bench(|| {
        let polynomial = |parts: &[&Number<Fraction>]| {
            Polynomial::new(parts.iter().map(|part| (*part).clone()).collect())
        };
        let [p, p1] = [polynomial(&[&b, &a]), polynomial(&[&g, &f])];
        let [q, q1] = [polynomial(&[&e, &d, &c]), polynomial(&[&l, &k, &h])];
        let difference = &q - &q1;
        &difference * &difference + &(&p - &p1) * &(&p * &q1 - &p1 * &q)
    });
}
