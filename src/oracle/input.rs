//! Reading the fields of a problem.

use rug::Rational;
use serde_json::{Map, Value};

use super::ProblemError;
use crate::number::text::parse_rational;
use crate::number::{Elementary, Number, Surd};
use crate::plane;

/// Fields that every problem may have. Nothing depends on those after the first: they say what the
/// problem is about, for corpora of problems.
const COMMON: [&str; 6] = ["problem", "id", "kind", "flags", "note", "claims"];

/// The object that a problem is.
pub struct Fields<'a> {
    object: &'a Map<String, Value>,
    /// Where the object stands in the problem; empty for the problem itself.
    place: String,
}

impl<'a> Fields<'a> {
    pub fn of(problem: &'a Value) -> Result<Self, ProblemError> {
        match problem {
            Value::Object(object) => Ok(Fields {
                object,
                place: String::new(),
            }),
            other => Err(ProblemError::new(
                "problem",
                format!("an object was expected, not {}", kind(other)),
            )),
        }
    }

    /// An object within the problem.
    pub fn at(value: &'a Value, place: &str) -> Result<Self, ProblemError> {
        match value {
            Value::Object(object) => Ok(Fields {
                object,
                place: place.to_owned(),
            }),
            other => Err(ProblemError::new(
                place,
                format!("an object was expected, not {}", kind(other)),
            )),
        }
    }

    fn path(&self, name: &str) -> String {
        if self.place.is_empty() {
            name.to_owned()
        } else {
            format!("{}.{name}", self.place)
        }
    }

    /// What is wrong with a field.
    pub fn error(&self, name: &str, message: impl Into<String>) -> ProblemError {
        ProblemError::new(&self.path(name), message)
    }

    pub fn name(&self) -> Result<&'a str, ProblemError> {
        match self.object.get("problem") {
            Some(Value::String(name)) => Ok(name),
            Some(other) => Err(ProblemError::new(
                "problem",
                format!("the name of a problem was expected, not {}", kind(other)),
            )),
            None => Err(ProblemError::new(
                "problem",
                "this field is missing; it names the kind of problem",
            )),
        }
    }

    /// Rejects fields that this kind of problem does not have.
    pub fn only(&self, expected: &[&str]) -> Result<(), ProblemError> {
        let common: &[&str] = if self.place.is_empty() { &COMMON } else { &[] };
        for name in self.object.keys() {
            if !common.contains(&name.as_str()) && !expected.contains(&name.as_str()) {
                return Err(self.error(
                    name,
                    format!("unknown field; expected {}", expected.join(", ")),
                ));
            }
        }
        Ok(())
    }

    /// One of these words; `None` where the field is missing.
    pub fn word(&self, name: &str, words: &[&str]) -> Result<Option<&'a str>, ProblemError> {
        match self.object.get(name) {
            None => Ok(None),
            Some(Value::String(word)) if words.contains(&word.as_str()) => Ok(Some(word)),
            Some(_) => Err(self.error(name, format!("one of {} was expected", words.join(", ")))),
        }
    }

    /// The field as it is.
    pub fn get(&self, name: &str) -> Result<&'a Value, ProblemError> {
        self.object
            .get(name)
            .ok_or_else(|| self.error(name, "this field is missing"))
    }

    pub fn number(&self, name: &str) -> Result<Rational, ProblemError> {
        number(self.get(name)?, &self.path(name))
    }

    /// A list of numbers.
    pub fn numbers(&self, name: &str) -> Result<Vec<Rational>, ProblemError> {
        let list = self.list(name)?.iter().enumerate();
        list.map(|(place, value)| number(value, &format!("{}[{place}]", self.path(name))))
            .collect()
    }

    /// A list.
    pub fn list(&self, name: &str) -> Result<&'a [Value], ProblemError> {
        match self.get(name)? {
            Value::Array(list) => Ok(list),
            other => Err(self.error(name, format!("a list was expected, not {}", kind(other)))),
        }
    }

    /// Whether there is such a field.
    pub fn has(&self, name: &str) -> bool {
        self.object.contains_key(name)
    }

    /// An object.
    pub fn object(&self, name: &str) -> Result<Fields<'a>, ProblemError> {
        Fields::at(self.get(name)?, &self.path(name))
    }

    /// An object that may be missing.
    pub fn optional_object(&self, name: &str) -> Result<Option<Fields<'a>>, ProblemError> {
        self.has(name).then(|| self.object(name)).transpose()
    }

    /// A point, a list of two numbers.
    pub fn point(&self, name: &str) -> Result<[Rational; 2], ProblemError> {
        point(self.get(name)?, &self.path(name))
    }

    /// A list of points.
    pub fn points(&self, name: &str) -> Result<Vec<[Rational; 2]>, ProblemError> {
        let places = self.list(name)?.iter().enumerate();
        places
            .map(|(place, value)| point(value, &format!("{}[{place}]", self.path(name))))
            .collect()
    }

    /// The points of a field that may be missing.
    pub fn optional_points(&self, name: &str) -> Result<Vec<[Rational; 2]>, ProblemError> {
        if self.has(name) {
            self.points(name)
        } else {
            Ok(Vec::new())
        }
    }

    /// True or false; false where the field is missing.
    pub fn flag(&self, name: &str) -> Result<bool, ProblemError> {
        match self.object.get(name) {
            None => Ok(false),
            Some(Value::Bool(flag)) => Ok(*flag),
            Some(other) => Err(self.error(
                name,
                format!("true or false was expected, not {}", kind(other)),
            )),
        }
    }

    pub fn positive(&self, name: &str) -> Result<Rational, ProblemError> {
        let number = self.number(name)?;
        if number.cmp0().is_gt() {
            Ok(number)
        } else {
            Err(self.error(name, "a positive length was expected"))
        }
    }

    pub fn angle(&self, name: &str) -> Result<Angle, ProblemError> {
        Angle::read(self.get(name)?, &self.path(name))
    }
}

fn kind(value: &Value) -> &'static str {
    match value {
        Value::Null => "null",
        Value::Bool(_) => "true or false",
        Value::Number(_) => "a number",
        Value::String(_) => "a string",
        Value::Array(_) => "a list",
        Value::Object(_) => "an object",
    }
}

/// A list of two numbers.
fn point(value: &Value, place: &str) -> Result<[Rational; 2], ProblemError> {
    match value {
        Value::Array(pair) => match pair.as_slice() {
            [x, y] => Ok([
                number(x, &format!("{place}[0]"))?,
                number(y, &format!("{place}[1]"))?,
            ]),
            list => Err(ProblemError::new(
                place,
                format!(
                    "a point [\"x\", \"y\"] was expected, not a list of {}",
                    list.len()
                ),
            )),
        },
        other => Err(ProblemError::new(
            place,
            format!("a point [\"x\", \"y\"] was expected, not {}", kind(other)),
        )),
    }
}

/// A number: a string, or a JSON number taken as the decimal that is written.
fn number(value: &Value, place: &str) -> Result<Rational, ProblemError> {
    let written;
    let text = match value {
        Value::String(text) => text,
        Value::Number(number) => {
            written = number.to_string();
            &written
        }
        other => {
            return Err(ProblemError::new(
                place,
                format!(
                    "a number was expected (\"3\", \"-5/13\", \"0.125\"), not {}",
                    kind(other)
                ),
            ));
        }
    };
    parse_rational(text).map_err(|error| ProblemError::new(place, error.to_string()))
}

/// An angle as it was given.
#[derive(Clone, Debug)]
pub enum Angle {
    /// In degrees.
    Degrees(Rational),
    /// In radians.
    Radians(Rational),
    /// By its cosine and sine.
    CosSin(Rational, Rational),
}

impl Angle {
    fn read(value: &Value, place: &str) -> Result<Self, ProblemError> {
        let forms = "one of {\"degrees\": …}, {\"radians\": …}, {\"tan_half\": …}, {\"cos\": …, \"sin\": …}";
        let Value::Object(object) = value else {
            return Err(ProblemError::new(
                place,
                format!("an angle was expected, {forms}, not {}", kind(value)),
            ));
        };
        let at = |name: &str| format!("{place}.{name}");
        let field = |name: &str| object.get(name).map(|value| number(value, &at(name)));
        let names: Vec<&str> = object.keys().map(String::as_str).collect();
        match names.as_slice() {
            ["degrees"] => Ok(Angle::Degrees(
                field("degrees").transpose()?.unwrap_or_default(),
            )),
            ["radians"] => Ok(Angle::Radians(
                field("radians").transpose()?.unwrap_or_default(),
            )),
            ["tan_half"] => {
                let t = field("tan_half").transpose()?.unwrap_or_default();
                let square = Rational::from(t.square_ref());
                let scale = Rational::from(1 + &square);
                let cos = (1 - square) / &scale;
                Ok(Angle::CosSin(cos, t * 2 / scale))
            }
            ["cos", "sin"] | ["sin", "cos"] => {
                let cos = field("cos").transpose()?.unwrap_or_default();
                let sin = field("sin").transpose()?.unwrap_or_default();
                let sum = Rational::from(cos.square_ref()) + Rational::from(sin.square_ref());
                if sum != 1 {
                    return Err(ProblemError::new(
                        place,
                        "cos² + sin² must be exactly 1; for rounded values give degrees or radians",
                    ));
                }
                Ok(Angle::CosSin(cos, sin))
            }
            _ => Err(ProblemError::new(
                place,
                format!("an angle is {forms}, not an object with {}", listed(&names)),
            )),
        }
    }

    /// With exact cosine and sine, where these are sums of square roots.
    pub fn exact(&self) -> Option<plane::Angle<Surd>> {
        match self {
            Angle::Degrees(degrees) => plane::Angle::from_degrees(degrees, &()),
            Angle::Radians(radians) if radians.is_zero() => {
                Some(plane::Angle::from_cos_sin(Number::one(), Number::zero()))
            }
            Angle::Radians(_) => None,
            Angle::CosSin(cos, sin) => Some(plane::Angle::from_cos_sin(
                cos.clone().into(),
                sin.clone().into(),
            )),
        }
    }

    /// The turn from this angle to another, where it is better known than their cosines and sines
    /// tell: two angles in one unit.
    pub fn turn_to(&self, other: &Self) -> Option<Self> {
        match (self, other) {
            (Angle::Degrees(a), Angle::Degrees(b)) => Some(Angle::Degrees(Rational::from(b - a))),
            (Angle::Radians(a), Angle::Radians(b)) => Some(Angle::Radians(Rational::from(b - a))),
            _ => None,
        }
    }

    /// Whether this is no turn at all.
    pub fn is_zero(&self) -> bool {
        match self {
            Angle::Degrees(q) | Angle::Radians(q) => q.is_zero(),
            Angle::CosSin(cos, sin) => *cos == 1 && sin.is_zero(),
        }
    }

    /// In any arithmetic with elementary functions.
    pub fn rounded<K: Elementary>(&self, precision: &K::Precision) -> plane::Angle<K> {
        let number = |q: &Rational| Number::<K>::rounded(q, precision);
        match self {
            Angle::Degrees(degrees) => match K::cos_sin_of_degrees(degrees, precision) {
                Some((cos, sin)) => plane::Angle::from_cos_sin(Number(cos), Number(sin)),
                None => of_radians(&(number(degrees) * Number::pi(precision) / 180)),
            },
            Angle::Radians(radians) if radians.is_zero() => {
                plane::Angle::from_cos_sin(Number::one(), Number::zero())
            }
            Angle::Radians(radians) => of_radians(&number(radians)),
            Angle::CosSin(cos, sin) => plane::Angle::from_cos_sin(number(cos), number(sin)),
        }
    }
}

fn of_radians<K: Elementary>(radians: &Number<K>) -> plane::Angle<K> {
    plane::Angle::from_cos_sin(radians.clone().cos(), radians.clone().sin())
}

fn listed(names: &[&str]) -> String {
    if names.is_empty() {
        "no fields".to_owned()
    } else {
        names.join(", ")
    }
}
