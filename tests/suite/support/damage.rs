//! Damages to answers of any kind: what is false afterwards, whatever the answer says.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot read what it damages has failed"
)]
#![expect(
    clippy::indexing_slicing,
    reason = "a place that is not there is a failure of the test"
)]

use std::collections::BTreeSet;

use burmester::number::text::parse_rational;
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use rug::Rational;
use serde_json::{Value, json};

/// Fields that claim nothing of the problem's solution, or only estimates.
const NO_CLAIMS: [&str; 9] = [
    "problem",
    "id",
    "digits",
    "undecided",
    "certificate",
    "sensitivity",
    "condition",
    "to_double",
    "defects",
];

/// The ways of damaging an answer.
pub const WAYS: [Way; 9] = [
    Way::Digit,
    Way::Sign,
    Way::Missing,
    Way::Removed,
    Way::Invented,
    Way::Count,
    Way::Swapped,
    Way::Word,
    Way::Truth,
];

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Way {
    /// A digit of a number.
    Digit,
    /// The sign of a number.
    Sign,
    /// A number is left out.
    Missing,
    /// An entry of a list is left out.
    Removed,
    /// An entry of a list twice, the second time with another number.
    Invented,
    /// A count or multiplicity.
    Count,
    /// Two numbers in each other's place.
    Swapped,
    /// Another word of the same field.
    Word,
    /// Yes for no.
    Truth,
}

/// What stands where in an answer.
#[derive(Default)]
struct Places {
    numbers: Vec<String>,
    lists: Vec<String>,
    counts: Vec<String>,
    words: Vec<String>,
    truths: Vec<String>,
}

impl Places {
    fn of(answer: &Value) -> Self {
        let mut places = Places::default();
        places.collect(answer, String::new());
        places
    }

    fn collect(&mut self, value: &Value, at: String) {
        if text_of(value).is_some() {
            self.numbers.push(at);
            return;
        }
        match value {
            Value::Object(fields) => {
                for (name, value) in fields {
                    if !NO_CLAIMS.contains(&name.as_str()) {
                        self.collect(value, format!("{at}/{name}"));
                    }
                }
            }
            Value::Array(members) => {
                if members.first().is_some_and(is_entry) {
                    self.lists.push(at.clone());
                }
                for (place, value) in members.iter().enumerate() {
                    self.collect(value, format!("{at}/{place}"));
                }
            }
            Value::Number(_) => self.counts.push(at),
            Value::Bool(_) => self.truths.push(at),
            Value::String(_) if !at.contains("/vertices/") => self.words.push(at),
            _ => {}
        }
    }
}

/// Whether a member makes its array a list, other than the coordinates of a point.
fn is_entry(value: &Value) -> bool {
    value.is_object() && text_of(value).is_none() && value.get("re").is_none()
}

/// The text of a number that goes out, also of an integer among coefficients.
fn text_of(value: &Value) -> Option<&str> {
    let fields = value.get("exact").or_else(|| value.get("value"));
    let text = fields.unwrap_or(value).as_str()?;
    parse_rational(text).ok().map(|_| text)
}

fn set_text(value: &mut Value, text: String) {
    for name in ["exact", "value"] {
        if value.get(name).is_some() {
            value[name] = json!(text);
            return;
        }
    }
    *value = json!(text);
}

fn number(value: &Value) -> Rational {
    parse_rational(text_of(value).unwrap()).unwrap()
}

fn radius(value: &Value) -> Rational {
    let radius = value.get("radius").and_then(Value::as_str);
    radius.map_or_else(Rational::new, |text| parse_rational(text).unwrap())
}

/// Whether two numbers have nothing in common.
fn differ(a: &Value, b: &Value) -> bool {
    (number(a) - number(b)).abs() > radius(a) + radius(b)
}

/// One of a list, by chance.
fn any<'a, T>(list: &'a [T], random: &mut ChaCha8Rng) -> Option<&'a T> {
    (!list.is_empty()).then(|| &list[random.random_range(0..list.len())])
}

/// Changes one digit; false where what results has no meaning or the same.
pub fn change_digit(value: &mut Value, random: &mut ChaCha8Rng) -> bool {
    let old = value.clone();
    let Some(text) = text_of(value) else {
        return false;
    };
    let mut characters: Vec<char> = text.split(['e', 'E']).next().unwrap().chars().collect();
    let rest: String = text.chars().skip(characters.len()).collect();
    let digits: Vec<usize> = (0..characters.len())
        .filter(|place| characters[*place].is_ascii_digit())
        .collect();
    let place = *any(&digits, random).unwrap();
    let digit = characters[place].to_digit(10).unwrap();
    let other = (digit + random.random_range(1..10)) % 10;
    characters[place] = char::from_digit(other, 10).unwrap();
    set_text(value, characters.into_iter().collect::<String>() + &rest);
    text_of(value).is_some() && differ(&old, value)
}

/// Changes the sign; false for zero.
pub fn change_sign(value: &mut Value) -> bool {
    let old = value.clone();
    let Some(text) = text_of(value) else {
        return false;
    };
    let changed = match text.strip_prefix('-') {
        Some(rest) => rest.to_owned(),
        None => format!("-{text}"),
    };
    set_text(value, changed);
    differ(&old, value)
}

/// Damages an answer; `None` where it has nothing of that kind. Words are those that other answers have.
pub fn damage(
    answer: &Value,
    way: Way,
    words: &BTreeSet<(String, String)>,
    random: &mut ChaCha8Rng,
) -> Option<Value> {
    let places = Places::of(answer);
    let mut answer = answer.clone();
    let changed = match way {
        Way::Digit => change_digit(at(&mut answer, any(&places.numbers, random)?), random),
        Way::Sign => change_sign(at(&mut answer, any(&places.numbers, random)?)),
        Way::Missing => {
            *at(&mut answer, any(&places.numbers, random)?) = Value::Null;
            true
        }
        Way::Removed => {
            let list = at(&mut answer, any(&places.lists, random)?).as_array_mut()?;
            list.remove(random.random_range(0..list.len()));
            true
        }
        Way::Invented => {
            let list = at(&mut answer, any(&places.lists, random)?);
            let mut entry = any(list.as_array()?, random)?.clone();
            let inner = Places::of(&entry);
            let number = any(&inner.numbers, random)?;
            let changed = change_digit(at(&mut entry, number), random);
            list.as_array_mut()?.push(entry);
            changed
        }
        Way::Count => {
            let count = at(&mut answer, any(&places.counts, random)?);
            *count = json!(count.as_u64()? + random.random_range(1..3));
            true
        }
        Way::Swapped => {
            let [one, other] = [any(&places.numbers, random)?, any(&places.numbers, random)?];
            let (a, b) = (answer.pointer(one)?.clone(), answer.pointer(other)?.clone());
            *at(&mut answer, one) = b.clone();
            *at(&mut answer, other) = a.clone();
            // Two conjugate numbers have no order.
            let conjugate = [one, other].iter().all(|place| place.ends_with("/im"));
            !conjugate && differ(&a, &b)
        }
        Way::Word => {
            let place = any(&places.words, random)?;
            let old = answer.pointer(place)?.as_str()?.to_owned();
            let others: Vec<&String> = words
                .iter()
                .filter(|(name, word)| *name == field(place) && *word != old)
                .map(|(_, word)| word)
                .collect();
            *at(&mut answer, place) = json!(any(&others, random)?);
            true
        }
        Way::Truth => {
            let truth = at(&mut answer, any(&places.truths, random)?);
            *truth = json!(!truth.as_bool()?);
            true
        }
    };
    changed.then_some(answer)
}

fn at<'a>(answer: &'a mut Value, place: &str) -> &'a mut Value {
    answer.pointer_mut(place).unwrap()
}

/// The name of the field in which a place is.
fn field(place: &str) -> String {
    let names = place.rsplit('/');
    let mut names = names.filter(|part| part.parse::<usize>().is_err());
    names.next().unwrap_or_default().to_owned()
}

/// The words of an answer, with the fields in which they stand.
pub fn words(answer: &Value) -> BTreeSet<(String, String)> {
    let places = Places::of(answer).words.into_iter();
    let word = |place: String| Some((field(&place), answer.pointer(&place)?.as_str()?.to_owned()));
    places.filter_map(word).collect()
}
