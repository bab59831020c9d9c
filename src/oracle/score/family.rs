//! Where there are infinitely many pairs, any of them may be given.

use super::read::{Member, Part, Stated, Statements};
use crate::number::Number;
use crate::oracle::displacements;
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// The positions of a problem with a family of pairs.
pub struct Positions(Vec<Displacement<f64>>);

impl Positions {
    /// The positions, where the certified answer has a family.
    pub fn of_family(problem: &serde_json::Value, statements: &Statements) -> Option<Self> {
        let family = statements.iter().any(|(place, stated)| {
            let Stated::One { part, .. } = stated else {
                return false;
            };
            place == "family.kind" && *part != Part::Word("none".to_owned())
        });
        family.then(|| displacements(problem).ok().map(Positions))?
    }

    /// Whether the circlepoint keeps its distance from the center, but for what an error relative to
    /// the size of circlepoint and center makes of it. Points may be complex.
    pub fn hold(&self, member: &Member, tolerance: f64) -> bool {
        let named = |name: &str| {
            let part = member.parts.iter().find(|(other, _)| *other == name);
            part.and_then(|(_, part)| finite(part))
        };
        let (Some(circlepoint), Some(center)) = (named("circlepoint"), named("center")) else {
            return false;
        };
        let places: Vec<[Complex; 2]> = self
            .0
            .iter()
            .map(|position| moved(position, &circlepoint))
            .collect();
        let squares = places.iter().map(|place| {
            let [x, y] = difference(place, &center);
            &x * &x + &y * &y
        });
        let squares: Vec<Complex> = squares.collect();
        let change = widest(&squares, |a, b| modulus(&(a - b)));
        let turn = widest(&self.0, |a, b| modulus(&(&a.rotation - &b.rotation)));
        let way = widest(&places, |a, b| length(&difference(a, b)));
        let reach = places
            .iter()
            .map(|place| length(&difference(place, &center)));
        let reach = reach.fold(0.0, f64::max);
        let sizes = places.iter().chain([&circlepoint, &center]).map(length);
        let off = tolerance * sizes.fold(0.0, f64::max);
        // Of a center off by ε the squares part by 2ε·way, of a circlepoint by 2ε(way + turn·reach), and
        // by (ε·turn)² where it should rest on its center.
        change <= off * (way + turn * reach) + (off * turn).powi(2)
    }
}

type Complex = Point<f64>;

/// The coordinates of a finite point.
fn finite(part: &Part) -> Option<[Complex; 2]> {
    let Part::Numbers(numbers) = part else {
        return None;
    };
    let values: Vec<f64> = numbers.iter().map(|known| known.value.to_f64()).collect();
    let complex = |re: f64, im: f64| Number::complex(Number(re), Number(im));
    match values.as_slice() {
        [x, y] => Some([complex(*x, 0.0), complex(*y, 0.0)]),
        [a, b, c, d] => Some([complex(*a, *b), complex(*c, *d)]),
        _ => None,
    }
}

fn moved(position: &Displacement<f64>, [x, y]: &[Complex; 2]) -> [Complex; 2] {
    let real = |number: &Number<f64>| Number::complex(number.clone(), Number(0.0));
    let [c, s] = [position.rotation.re(), position.rotation.im()].map(real);
    let [a, b] = [position.translation.re(), position.translation.im()].map(real);
    [&c * x - &s * y + a, &s * x + &c * y + b]
}

fn difference([a, b]: &[Complex; 2], [c, d]: &[Complex; 2]) -> [Complex; 2] {
    [a - c, b - d]
}

fn modulus(number: &Complex) -> f64 {
    number.re().0.hypot(number.im().0)
}

fn length([x, y]: &[Complex; 2]) -> f64 {
    modulus(x).hypot(modulus(y))
}

/// The largest of a measure over every two.
fn widest<T>(list: &[T], measure: impl Fn(&T, &T) -> f64) -> f64 {
    let mut widest = 0.0;
    for (place, one) in list.iter().enumerate() {
        for other in list.iter().skip(place + 1) {
            let measured = measure(one, other);
            // What is no number is not small.
            widest = if measured.is_nan() {
                f64::INFINITY
            } else {
                measured.max(widest)
            };
        }
    }
    widest
}
