//! Indices that run: in `x_k = y_{k+1} for k in [1, 2, 3]` the index is each whole number of the list
//! in turn, and k + 1 is the next one of the list, after the last one the first.

use std::rc::Rc;

use super::symbol;
use super::tree::{Node, Tree};

/// A bound name and what it runs through.
#[derive(Debug)]
struct Range {
    name: String,
    /// The values as they stand in an index, where they are whole numbers.
    labels: Option<Vec<String>>,
    /// Whether there is a next one.
    ordered: bool,
}

/// A bound name at one of its values.
#[derive(Clone, Debug)]
pub(super) struct Running {
    range: Rc<Range>,
    at: usize,
}

/// The name at each of so many values.
pub(super) fn places(name: &str, values: &Tree, count: usize) -> impl Iterator<Item = Running> {
    let (labels, ordered) = match &values.node {
        Node::List(members) => (labels(members), true),
        Node::Set(members) => (labels(members), false),
        _ => (None, false),
    };
    let range = Rc::new(Range {
        name: name.to_owned(),
        labels,
        ordered,
    });
    (0..count).map(move |at| Running {
        range: Rc::clone(&range),
        at,
    })
}

/// The members as they stand in an index, where all of them are whole numbers.
fn labels(members: &[Tree]) -> Option<Vec<String>> {
    members
        .iter()
        .map(|member| match &member.node {
            Node::Number { text, .. } if is_whole(text) => Some(text.clone()),
            _ => None,
        })
        .collect()
}

/// The first and the last member of a list of consecutive whole numbers.
pub(super) fn bounds(values: &Tree) -> Option<(&str, &str)> {
    let Node::List(members) = &values.node else {
        return None;
    };
    let mut next = None;
    for member in members {
        let Node::Number { text, value } = &member.node else {
            return None;
        };
        if !is_whole(text) || next.is_some_and(|next| next != *value) {
            return None;
        }
        next = Some(value.clone() + 1_i32);
    }
    match (&members.first()?.node, &members.last()?.node) {
        (Node::Number { text: first, .. }, Node::Number { text: last, .. }) => Some((first, last)),
        _ => None,
    }
}

fn is_whole(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit())
}

/// A part of an index: a name and how far on from it.
struct Part<'a> {
    name: &'a str,
    offset: &'a str,
}

fn part(text: &str) -> Part<'_> {
    let end = text.find(['+', '-']).unwrap_or(text.len());
    let (name, offset) = text.split_at(end);
    Part { name, offset }
}

/// A name with the values of the running names in its index; else what is wrong with it.
pub(super) fn resolved(name: &str, running: &[Running]) -> Result<String, String> {
    let parts = symbol::parts(name);
    let Some(index) = parts.index.filter(|_| !running.is_empty()) else {
        return Ok(name.to_owned());
    };
    let mut changed = Vec::new();
    for text in index.split(',') {
        let part = part(text);
        let found = running
            .iter()
            .rev()
            .find(|bound| bound.range.name == part.name);
        changed.push(match found {
            Some(bound) => bound.label(part.offset)?,
            None => text,
        });
    }
    let index = changed.join(",");
    Ok(symbol::with_index(parts.stem, &index, parts.primes))
}

impl Running {
    /// The label here, or so many places on.
    fn label(&self, offset: &str) -> Result<&str, String> {
        let Range {
            name,
            labels,
            ordered,
        } = self.range.as_ref();
        let Some(labels) = labels else {
            return Err(format!(
                "`{name}` runs through values that are no whole numbers, and cannot be an index"
            ));
        };
        let count = labels.len();
        let at = match offset.split_at_checked(1) {
            None => self.at,
            Some(_) if !ordered => {
                return Err(format!(
                    "a set has no next member: write a list `[…]` for `{name}{offset}`"
                ));
            }
            Some((sign, digits)) => {
                let steps = steps(digits, count).ok_or_else(|| {
                    format!("found `{name}{offset}`, expected a whole number after `{name}{sign}`")
                })?;
                match sign {
                    "-" => self.at + count - steps,
                    _ => self.at + steps,
                }
            }
        };
        // Not empty, since this is a place in it.
        Ok(labels.get(at % count.max(1)).map_or("", String::as_str))
    }
}

/// A whole number of steps round a circle of so many places.
fn steps(digits: &str, count: usize) -> Option<usize> {
    if digits.is_empty() || !is_whole(digits) || count == 0 {
        return None;
    }
    digits.bytes().try_fold(0_usize, |steps, digit| {
        Some((steps * 10 + usize::from(digit - b'0')) % count)
    })
}

/// The names with one running index of this one a step on, for mutants; `bound` are names that may
/// be running.
pub(super) fn shifted(name: &str, bound: &[String]) -> Vec<String> {
    let parts = symbol::parts(name);
    let Some(index) = parts.index else {
        return Vec::new();
    };
    let texts: Vec<&str> = index.split(',').collect();
    let mut names = Vec::new();
    for (place, text) in texts.iter().enumerate() {
        let Part { name, offset } = part(text);
        if !bound.iter().any(|other| other == name) {
            continue;
        }
        let Some(offset) = next_offset(offset) else {
            continue;
        };
        let mut changed: Vec<String> = texts.iter().map(|&text| text.to_owned()).collect();
        if let Some(text) = changed.get_mut(place) {
            *text = format!("{name}{offset}");
        }
        let index = changed.join(",");
        names.push(symbol::with_index(parts.stem, &index, parts.primes));
    }
    names
}

/// `k` to `k+1`, `k+1` to `k+2`, `k-1` to `k`.
fn next_offset(offset: &str) -> Option<String> {
    let steps: i32 = match offset {
        "" => 0,
        _ => offset.parse().ok()?,
    };
    match steps.checked_add(1)? {
        0 => Some(String::new()),
        next => Some(format!("{next:+}")),
    }
}
