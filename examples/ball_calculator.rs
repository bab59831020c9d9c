//! A calculator on balls, for comparison with other interval libraries.
//!
//! Each line of the input is a computation in postfix notation. A word is an operation (`add`, `sub`,
//! `mul`, `div`, `neg`, `sqrt`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`, `atan2` with y before x) or
//! a ball `m,e,r,s,bits`: midpoint m·2^e, radius r·2^s, working precision; m and r are hexadecimal.
//! Each line of the output is the enclosure of the result, `m,e,r,s`, or `unknown` (nothing is known of
//! the value), `none` (there is no value) or `error`.
//!
//! ```text
//! $ echo '1,0,0,0,64 3,0,0,0,64 div' | cargo run --release --example ball_calculator
//! aaaaaaaaaaaaaaab,-65,80000000,-97
//! ```

use std::io::{self, BufRead, BufWriter, Write};

use burmester::number::{Ball, Elementary, Kind, Real};
use rug::{Integer, Rational};

/// Answers every line of the standard input.
///
/// # Errors
/// Input that cannot be read, output that cannot be written.
pub fn main() -> io::Result<()> {
    let mut out = BufWriter::new(io::stdout().lock());
    for line in io::stdin().lock().lines() {
        writeln!(out, "{}", result(&line?))?;
    }
    out.flush()
}

/// The enclosure of a computation, in words.
pub fn result(line: &str) -> String {
    match computed(line) {
        None => "error".to_owned(),
        Some(ball) if !ball.has_value() => "none".to_owned(),
        Some(ball) => in_words(&ball).unwrap_or_else(|| "unknown".to_owned()),
    }
}

fn computed(line: &str) -> Option<Ball> {
    let mut stack: Vec<Ball> = Vec::new();
    for word in line.split_whitespace() {
        if let Some(operate) = unary(word) {
            operate(stack.last_mut()?);
        } else if let Some(operate) = binary(word) {
            let second = stack.pop()?;
            operate(stack.last_mut()?, &second);
        } else {
            stack.push(ball(word)?);
        }
    }
    let last = stack.pop()?;
    stack.is_empty().then_some(last)
}

fn unary(word: &str) -> Option<fn(&mut Ball)> {
    Some(match word {
        "neg" => Ball::negate,
        "sqrt" => Ball::sqrt,
        "sin" => Ball::sin,
        "cos" => Ball::cos,
        "tan" => Ball::tan,
        "asin" => Ball::asin,
        "acos" => Ball::acos,
        "atan" => Ball::atan,
        _ => return None,
    })
}

fn binary(word: &str) -> Option<fn(&mut Ball, &Ball)> {
    Some(match word {
        "add" => Ball::add,
        "sub" => Ball::sub,
        "mul" => Ball::mul,
        "div" => Ball::div,
        "atan2" => Ball::atan2,
        _ => return None,
    })
}

fn ball(word: &str) -> Option<Ball> {
    let mut fields = word.split(',');
    let mut dyadic = || {
        let mantissa = Integer::from_str_radix(fields.next()?, 16).ok()?;
        let exponent: i32 = fields.next()?.parse().ok()?;
        Some(Rational::from(mantissa) << exponent)
    };
    let (mid, radius) = (dyadic()?, dyadic()?);
    let bits = fields.next()?.parse().ok()?;
    fields
        .next()
        .is_none()
        .then(|| Ball::with_radius(&mid, &radius, bits))
}

fn in_words(ball: &Ball) -> Option<String> {
    let [mid, radius] = [ball.midpoint_rational()?, ball.radius_rational()?].map(|q| shown(&q));
    Some(format!("{mid},{radius}"))
}

/// A dyadic number as `m,e` with odd m, or 0.
fn shown(q: &Rational) -> String {
    let mut mantissa = q.numer().clone();
    let zeros = mantissa.find_one(0).unwrap_or(0);
    mantissa >>= zeros;
    let down = q.denom().significant_bits().saturating_sub(1);
    format!("{mantissa:x},{}", i64::from(zeros) - i64::from(down))
}
