//! Points, lengths, and what counts up to a factor, as an answer shows them.

use rug::Rational;
use serde_json::Value;

use super::known::{Known, root, vanish};
use super::shown::{self, Shown, decided, point, size};
use super::{Defect, require};
use crate::number::exact::primitive;
use crate::number::text::parse_rational;
use crate::number::{Number, Truth};

/// An answer and how sharply it is checked.
#[derive(Clone, Copy)]
pub struct Sheet<'a> {
    pub answer: &'a Value,
    pub digits: u32,
    pub bits: u32,
}

impl<'a> Sheet<'a> {
    pub fn of(answer: &'a Value) -> Result<Self, Defect> {
        Ok(Sheet {
            answer,
            digits: shown::digits(answer)?,
            bits: shown::bits(answer)?,
        })
    }

    /// Whether this is the point [x : y : w]; not determined where all three are zero.
    pub fn point<K: Known>(
        &self,
        shown: &Value,
        place: &str,
        [x, y, w]: &[Number<K>; 3],
    ) -> Result<(), Defect> {
        let shown = decided(self.answer, shown, place)?;
        let is_undetermined = vanish(&[x.clone(), y.clone(), w.clone()]);
        match (is_undetermined, w.is_zero()) {
            (Truth::Yes, _) => {
                let said = shown["undetermined"] == true;
                require(said, place, "it is not determined")
            }
            (_, Truth::No) => self.finite_point(shown, place, &[x / w, y / w]),
            (Truth::No, Truth::Yes) => {
                let direction = &shown["at_infinity"];
                require(!direction.is_null(), place, "it is at infinity")?;
                self.up_to_factor(direction, place, &[x.clone(), y.clone()])
            }
            _ => Err(Defect::unchecked(format!("whether {place} is finite"))),
        }
    }

    /// Whether this is the point (x, y).
    pub fn finite_point<K: Known>(
        &self,
        shown: &Value,
        place: &str,
        truth: &[Number<K>; 2],
    ) -> Result<(), Defect> {
        let shown = decided(self.answer, shown, place)?;
        require(shown.is_array(), place, "it is a finite point")?;
        let shown = point(shown, place, self.digits)?;
        for (coordinate, truth) in shown.iter().zip(truth) {
            let enclosed = K::enclosed(truth, self.bits);
            if enclosed.0.is_whole_line() {
                return Err(Defect::unchecked(format!("{place} is not known sharply")));
            }
            let held = coordinate.re.holds(&enclosed);
            require(held, place, "it is another point")?;
        }
        Ok(())
    }

    /// Whether this is the root that is not negative.
    pub fn root<K: Known>(
        &self,
        shown: &Value,
        place: &str,
        square: &Number<K>,
    ) -> Result<(), Defect> {
        let value = decided(self.answer, shown, place)?;
        let number = Shown::read(value, place)?;
        if number.is_exact() {
            let left = square - Number::from(number.value.clone().square());
            let right = !left.is_zero().is_no() && number.value.cmp0().is_ge();
            return require(right, place, "it is another length");
        }
        shown::holds(value, place, &root(square, self.bits), self.digits)
    }

    /// Whether these are the coefficients up to a factor, in their normal form: primitive integers, the
    /// first positive, or scaled so that the largest is 1.
    #[expect(
        clippy::indexing_slicing,
        reason = "the unit is one of the coefficients, and both lists have as many"
    )]
    pub fn up_to_factor<K: Known>(
        &self,
        shown: &Value,
        place: &str,
        truth: &[Number<K>],
    ) -> Result<(), Defect> {
        let shown = decided(self.answer, shown, place)?;
        let shown = coefficients(shown, place)?;
        let same_count = shown.len() == truth.len();
        require(same_count, place, "another number of coefficients")?;
        let is_zero = shown
            .iter()
            .all(|one| one.is_exact() && one.value.is_zero());
        match vanish(truth) {
            Truth::Yes => return require(is_zero, place, "all of it vanishes"),
            Truth::Unknown => return Err(Defect::unchecked(format!("whether {place} vanishes"))),
            Truth::No => {}
        }
        let unit = unit(&shown);
        let unit = unit.ok_or_else(|| Defect::wrong(place, "this is not the normal form"))?;
        for (one, truth_of_one) in shown.iter().zip(truth) {
            let right = self.is_multiple(one, truth_of_one, &shown[unit], &truth[unit]);
            require(right, place, "it is another one")?;
        }
        Ok(())
    }

    /// Whether one : unit is the true ratio.
    fn is_multiple<K: Known>(
        &self,
        one: &Shown,
        truth: &Number<K>,
        unit: &Shown,
        truth_of_unit: &Number<K>,
    ) -> bool {
        if truth_of_unit.is_zero().is_yes() {
            return false;
        }
        if one.is_exact() {
            let number = |shown: &Shown| Number::<K>::from(shown.value.clone());
            let left = truth * number(unit) - truth_of_unit * number(one);
            return !left.is_zero().is_no();
        }
        let ratio = K::enclosed(&(truth / truth_of_unit), self.bits);
        one.is_sharp(&unit.value, self.digits) && one.holds(&ratio)
    }
}

/// Coefficients as numbers, or as strings where they are integers.
fn coefficients(value: &Value, place: &str) -> Result<Vec<Shown>, Defect> {
    let list = value.as_array();
    let list = list.ok_or_else(|| Defect::wrong(place, "a list was expected"))?;
    let one = |value: &Value| match value.as_str() {
        Some(text) => match parse_rational(text) {
            Ok(value) => Ok(Shown {
                value,
                radius: Rational::new(),
            }),
            Err(error) => Err(Defect::wrong(place, error.to_string())),
        },
        None => Shown::read(value, place),
    };
    list.iter().map(one).collect()
}

/// A coefficient that the others are multiples of; `None` where the form is not normal.
fn unit(list: &[Shown]) -> Option<usize> {
    if list.iter().all(Shown::is_exact) {
        let rationals: Vec<Rational> = list.iter().map(|one| one.value.clone()).collect();
        let integers: Vec<Rational> = primitive(&rationals).iter().map(Rational::from).collect();
        let is_scaled = rationals.contains(&Rational::from(1)) && size(list) == 1;
        let place = rationals.iter().position(|value| !value.is_zero());
        return place.filter(|_| integers == rationals || is_scaled);
    }
    let is_one = |one: &Shown| one.is_exact() && one.value == 1;
    let fits = |one: &Shown| Rational::from(one.value.abs_ref()) <= Rational::from(1 + &one.radius);
    let place = list.iter().position(is_one);
    place.filter(|_| list.iter().all(fits))
}
