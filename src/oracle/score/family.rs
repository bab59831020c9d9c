//! Where there are infinitely many pairs, any of them may be given.

use serde_json::Value;

use super::read::{Member, Part, Stated, Statements};
use crate::number::{Complex, Number};
use crate::oracle::certificate::conditions::{Conditions, Pair};
use crate::oracle::certificate::conditions_in_floats;

type Entry = Number<Complex<f64>>;

/// What the pairs of a family fulfil.
pub struct Family(Conditions<Complex<f64>>);

impl Family {
    /// Of a problem whose certified answer has a family.
    pub fn of(problem: &Value, statements: &Statements) -> Option<Self> {
        let family = statements.iter().any(|(place, stated)| {
            let Stated::One { part, .. } = stated else {
                return false;
            };
            place == "family.kind" && *part != Part::Word("none".to_owned())
        });
        family.then(|| conditions_in_floats(problem).map(Family))?
    }

    /// Whether circlepoint and center fulfil the conditions, but for what an error relative to their
    /// size makes of these. Points may be complex.
    pub fn holds(&self, member: &Member, tolerance: f64) -> bool {
        self.are_small(member, tolerance) == Some(true)
    }

    fn are_small(&self, member: &Member, tolerance: f64) -> Option<bool> {
        let named = |name: &str| {
            let mut parts = member.parts.iter();
            let (_, part) = parts.find(|(other, _)| *other == name)?;
            finite(part)
        };
        let ([x, y], [cx, cy]) = (named("circlepoint")?, named("center")?);
        let pair: Pair<Complex<f64>> = [x, y, cx, cy];
        let sizes = pair.iter().map(modulus);
        let off = tolerance * sizes.fold(0.0, f64::max).max(self.0.reach_in_floats());
        let (values, slopes) = (self.0.at(&pair)?, self.0.slopes(&pair)?);
        let forms = self.0.forms()?;
        let all = values.iter().zip(&slopes).zip(&forms);
        let rooms = all.map(|((value, slopes), form)| {
            let slope: f64 = slopes.iter().map(modulus).sum();
            let bend: f64 = form.products().into_iter().map(modulus).sum();
            (modulus(value), off * slope + off * off * bend)
        });
        // What is no number is not small.
        Some(rooms.into_iter().all(|(value, room)| value <= room))
    }
}

fn modulus(number: &Entry) -> f64 {
    number.re().0.hypot(number.im().0)
}

/// The coordinates of a finite point.
fn finite(part: &Part) -> Option<[Entry; 2]> {
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
