//! From the JSON of an answer, certified or given, to what is compared.

use rug::Rational;
use serde_json::{Map, Value};
use thiserror::Error;

use super::number::Known;
use super::shape::Shape;
use crate::number::count;

/// What is no answer, and where.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct Misread(pub String);

impl Misread {
    /// Something else was expected here.
    pub fn expected(what: &str, found: &Value, place: &str) -> Self {
        let shown: String = found.to_string().chars().take(60).collect();
        Misread(format!("{place}: {what} was expected, found {shown}"))
    }
}

/// A part of an answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// A number, the coordinates of a point, or the parts of complex ones.
    Numbers(Vec<Known>),
    /// Numbers up to a common factor.
    Ratio(Vec<Known>),
    /// An angle in degrees.
    Degrees(Known),
    /// A word, a count, or that something is not there (`none`).
    Word(String),
    /// A fact that does not tell which member of a set it belongs to.
    Remark(String),
}

impl Part {
    /// Whether it does not tell which member of a set it belongs to.
    pub fn is_remark(&self) -> bool {
        matches!(self, Part::Remark(_))
    }
}

/// One of several things without an order, by its parts.
#[derive(Clone, Debug)]
pub struct Member {
    /// What is stated of it, by name.
    pub parts: Vec<(&'static str, Part)>,
    /// How often it counts.
    pub multiplicity: usize,
}

/// What stands at one place of an answer.
#[derive(Clone, Debug)]
pub enum Stated {
    /// One thing.
    One {
        /// What is stated of it.
        part: Part,
        /// Whether it makes a degenerate case.
        degenerate: bool,
    },
    /// Things without an order.
    Set {
        /// The things.
        members: Vec<Member>,
        /// Whether the set must be stated.
        required: bool,
        /// Whether a member makes a degenerate case.
        degenerate: bool,
    },
}

/// An answer: what it states, by places such as `centerpoint.focus`.
pub type Statements = Vec<(String, Stated)>;

/// How an answer is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// From `solve`, with nothing undecided.
    Certified,
    /// From `solve`, where null may also mean that something was not decided.
    PartlyUndecided,
    /// From a candidate.
    Candidate,
}

/// Reads an answer.
///
/// # Errors
/// A part that is not what its place demands.
pub fn read(shape: &Shape, answer: &Value, source: Source) -> Result<Statements, Misread> {
    let mut reader = Reader {
        source,
        statements: Vec::new(),
    };
    reader.read(shape, answer, "")?;
    Ok(reader.statements)
}

struct Reader {
    source: Source,
    statements: Statements,
}

impl Reader {
    fn read(&mut self, shape: &Shape, value: &Value, place: &str) -> Result<(), Misread> {
        if value.is_null() {
            self.absent(shape, place);
            return Ok(());
        }
        match shape {
            Shape::Fields(fields) => {
                let object = object(value, place)?;
                for (name, shape) in *fields {
                    if let Some(value) = object.get(*name) {
                        self.read(shape, value, &below(place, name))?;
                    }
                }
            }
            Shape::Each(shape) => match value {
                Value::Object(object) => {
                    for (name, value) in object {
                        self.read(shape, value, &below(place, name))?;
                    }
                }
                Value::Array(list) => {
                    for (index, value) in list.iter().enumerate() {
                        self.read(shape, value, &below(place, &(index + 1).to_string()))?;
                    }
                }
                _ => return Err(Misread::expected("a list or an object", value, place)),
            },
            Shape::Set {
                member: fields,
                required,
                degenerate,
            } => {
                let list = value.as_array();
                let list = list.ok_or_else(|| Misread::expected("a list", value, place))?;
                let members = list.iter().enumerate();
                let members = members
                    .map(|(index, value)| member(fields, value, &format!("{place}[{index}]")))
                    .collect::<Result<_, _>>()?;
                let (required, degenerate) = (*required, *degenerate);
                let set = Stated::Set {
                    members,
                    required,
                    degenerate,
                };
                self.statements.push((place.to_owned(), set));
            }
            leaf => {
                let part = part(leaf, value, place)?;
                self.one(leaf, part, place);
            }
        }
        Ok(())
    }

    fn one(&mut self, shape: &Shape, part: Part, place: &str) {
        let degenerate = match (shape, &part) {
            (Shape::Fact(ordinary), Part::Word(word)) => {
                !ordinary.is_empty() && !ordinary.contains(&word.as_str())
            }
            (Shape::Point, Part::Ratio(_) | Part::Word(_)) => true,
            (Shape::Length, Part::Word(word)) => word == "infinite" || word == "undetermined",
            (Shape::Ray, Part::Word(word)) => word == "undetermined",
            _ => false,
        };
        self.statements
            .push((place.to_owned(), Stated::One { part, degenerate }));
    }

    /// null says that something is not there; of a whole object, that it has no kind, no type.
    fn absent(&mut self, shape: &Shape, place: &str) {
        if self.source == Source::PartlyUndecided {
            return;
        }
        match shape {
            Shape::Fields(fields) => {
                for (name, shape) in *fields {
                    if let Shape::Fact([_, ..]) = shape {
                        self.absent(shape, &below(place, name));
                    }
                }
            }
            Shape::Each(_) | Shape::Set { .. } => {}
            // A candidate that does not know a fact may write null.
            Shape::Fact([]) if self.source == Source::Candidate => {}
            leaf => self.one(leaf, Part::Word("none".to_owned()), place),
        }
    }
}

fn below(place: &str, name: &str) -> String {
    if place.is_empty() {
        name.to_owned()
    } else {
        format!("{place}.{name}")
    }
}

fn object<'a>(value: &'a Value, place: &str) -> Result<&'a Map<String, Value>, Misread> {
    let object = value.as_object();
    object.ok_or_else(|| Misread::expected("an object", value, place))
}

/// A member without any part says nothing and is refused. A set of points has them bare.
fn member(
    fields: &'static [(&'static str, Shape)],
    value: &Value,
    place: &str,
) -> Result<Member, Misread> {
    if let [(name, shape @ Shape::Point)] = fields {
        return Ok(Member {
            parts: vec![(name, part(shape, value, place)?)],
            multiplicity: 1,
        });
    }
    let object = object(value, place)?;
    let mut parts = Vec::new();
    for (name, shape) in fields {
        if let Some(value) = object.get(*name).filter(|value| !value.is_null()) {
            parts.push((*name, part(shape, value, &below(place, name))?));
        }
    }
    if parts.is_empty() {
        let names: Vec<&str> = fields.iter().map(|(name, _)| *name).collect();
        return Err(Misread::expected(&names.join(" or "), value, place));
    }
    let multiplicity = object.get("multiplicity").and_then(Value::as_u64);
    Ok(Member {
        parts,
        multiplicity: multiplicity.map_or(1, |times| count::from_u64(times.clamp(1, 4))),
    })
}

fn part(shape: &Shape, value: &Value, place: &str) -> Result<Part, Misread> {
    match shape {
        Shape::Length | Shape::Ray | Shape::Point if flag(value, "undetermined") => {
            Ok(Part::Word("undetermined".to_owned()))
        }
        Shape::Length if flag(value, "infinite") => Ok(Part::Word("infinite".to_owned())),
        Shape::Length => Ok(Part::Numbers(vec![Known::read(value, place)?])),
        Shape::Angle => {
            let degrees = value.get("degrees").unwrap_or(value);
            Ok(Part::Degrees(Known::read(degrees, place)?))
        }
        Shape::Ray if value.get("re").is_some() => Ok(Part::Numbers(complex(value, place)?.into())),
        Shape::Ray => part(&Shape::Angle, value, place),
        Shape::Point => match value.get("at_infinity") {
            Some(direction) => Ok(Part::Ratio(numbers(direction, Some(2), place)?)),
            None => Ok(Part::Numbers(numbers(value, Some(2), place)?)),
        },
        Shape::ComplexPoint => match value.as_array().map(Vec::as_slice) {
            Some([x, y]) => {
                let [a, b] = complex(x, place)?;
                let [c, d] = complex(y, place)?;
                Ok(Part::Numbers(vec![a, b, c, d]))
            }
            _ => Err(Misread::expected("two complex numbers", value, place)),
        },
        Shape::UpToFactor => Ok(Part::Ratio(numbers(value, None, place)?)),
        Shape::Remark => Ok(Part::Remark(word(value, place)?)),
        Shape::Fact(_) | Shape::Each(_) | Shape::Set { .. } | Shape::Fields(_) => {
            Ok(Part::Word(word(value, place)?))
        }
    }
}

fn flag(value: &Value, name: &str) -> bool {
    value.get(name) == Some(&Value::Bool(true))
}

fn numbers(value: &Value, count: Option<usize>, place: &str) -> Result<Vec<Known>, Misread> {
    let list = value.as_array();
    let list = list.filter(|list| count.is_none_or(|count| list.len() == count));
    let list = list.ok_or_else(|| Misread::expected("a list of numbers", value, place))?;
    list.iter().map(|value| Known::read(value, place)).collect()
}

/// `{"re", "im"}`, or a real number.
fn complex(value: &Value, place: &str) -> Result<[Known; 2], Misread> {
    match (value.get("re"), value.get("im")) {
        (Some(re), Some(im)) => Ok([Known::read(re, place)?, Known::read(im, place)?]),
        _ => {
            let real = Known::read(value, place)?;
            let zero = Known {
                value: Rational::new(),
                radius: Rational::new(),
            };
            Ok([real, zero])
        }
    }
}

fn word(value: &Value, place: &str) -> Result<String, Misread> {
    match value {
        Value::String(word) => Ok(word.clone()),
        Value::Bool(truth) => Ok(truth.to_string()),
        // 2 and 2.0 are one count.
        Value::Number(_) => Ok(Known::read(value, place)?.value.to_string()),
        _ => Err(Misread::expected("a word or a count", value, place)),
    }
}
