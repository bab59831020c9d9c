//! Corpora of problems: named, seeded, and the same on every machine.
//!
//! A corpus is a list of problems as [`solve`] takes them, each with meta fields that
//! say what it is about, and their certified answers, joined by id. Those that are drawn come from a
//! generator that depends on nothing but its seed; those that are written by hand are kept as they
//! are. `claims` are facts that follow from how a problem was made, never from its answer.

mod condition;
mod degenerate;
mod draw;
mod five_of_linkages;
mod lint;
mod mechanisms;
mod mixed;
mod near_degenerate;
mod pose;
mod random;
mod spelled;
mod store;

use serde_json::{Map, Value, json};

use super::{ProblemError, Request, solve};
use draw::Draw;

pub use condition::condition;
pub use lint::defects_of_form;
pub use store::{Entry, Folder, StoreError, sha256};

/// Raised whenever a generator would draw other problems.
pub const GENERATOR: u32 = 2;

/// Digits of the certified answers.
pub const DIGITS: u32 = 50;

/// Where the problems of a corpus come from.
#[derive(Clone, Copy)]
enum Source {
    /// Drawn from a seed.
    Drawn(u64, fn(&mut Draw) -> Vec<Problem>),
    /// Built one by one.
    Built(fn() -> Vec<Problem>),
    /// The text itself.
    Kept(&'static str),
}

/// A named list of problems.
#[derive(Clone, Copy)]
pub struct Corpus {
    /// Its name, and that of its files.
    pub name: &'static str,
    /// What it holds, in one line.
    pub description: &'static str,
    source: Source,
}

/// All corpora, in the order of their names.
pub const CORPORA: [Corpus; 18] = [
    Corpus {
        name: "by-two-points",
        description: "positions given by two points of the body, three to five of them",
        source: Source::Drawn(1888, spelled::by_two_points),
    },
    Corpus {
        name: "curvature",
        description: "four-bars, slider-cranks and turning blocks in one position",
        source: Source::Drawn(7, mechanisms::curvature),
    },
    Corpus {
        name: "degenerate-five-positions",
        description: "five positions of every degenerate kind, with the answer that follows from the construction",
        source: Source::Kept(include_str!(
            "../../../data/problems/degenerate-five-positions.jsonl"
        )),
    },
    Corpus {
        name: "degenerate-four-positions",
        description: "four positions of every degenerate kind: equal, parallel, pole quadrilaterals with special sides",
        source: Source::Built(degenerate::four_positions),
    },
    Corpus {
        name: "degenerate-three-positions",
        description: "three positions of every degenerate kind, with circlepoints and centers on their poles",
        source: Source::Built(degenerate::three_positions),
    },
    Corpus {
        name: "five-positions-of-linkages",
        description: "five positions of a linkage that was chosen first: one or two pairs are known",
        source: Source::Drawn(1876, five_of_linkages::links),
    },
    Corpus {
        name: "focal-mechanisms",
        description: "four-bars and the ratio in which a crank's support divides their base",
        source: Source::Drawn(1968, mechanisms::focal),
    },
    Corpus {
        name: "hart",
        description: "Hart's straight-line mechanism",
        source: Source::Drawn(1877, mechanisms::hart),
    },
    Corpus {
        name: "in-degrees",
        description: "positions whose angles are degrees or radians: known by enclosures only",
        source: Source::Drawn(360, spelled::in_degrees),
    },
    Corpus {
        name: "mixed-positions",
        description: "five positions of which two to five have come together, given by derivatives",
        source: Source::Drawn(6, mixed::positions),
    },
    Corpus {
        name: "near-degenerate-five-positions",
        description: "degenerate problems disturbed by 10^-1 to 10^-12",
        source: Source::Drawn(1001, near_degenerate::five_positions),
    },
    Corpus {
        name: "near-degenerate-four-positions",
        description: "degenerate pole quadrilaterals and positions, disturbed by 10^-1 to 10^-12",
        source: Source::Drawn(1002, near_degenerate::four_positions),
    },
    Corpus {
        name: "random-five-positions",
        description: "five positions of small fractions",
        source: Source::Drawn(5, random::five_positions),
    },
    Corpus {
        name: "random-four-positions",
        description: "four positions of small fractions",
        source: Source::Drawn(4, random::four_positions),
    },
    Corpus {
        name: "random-poles",
        description: "two to nine positions of small fractions, some of them parallel or equal",
        source: Source::Drawn(2, random::poles),
    },
    Corpus {
        name: "random-three-positions",
        description: "three positions of small fractions, with circlepoints and centers",
        source: Source::Drawn(3, random::three_positions),
    },
    Corpus {
        name: "sliders",
        description: "five positions with a point on a line, or a line through a point: a center or a circlepoint at infinity",
        source: Source::Drawn(1964, five_of_linkages::sliders),
    },
    Corpus {
        name: "slider-cranks",
        description: "slider-cranks in one position, special ratios and rays among them",
        source: Source::Drawn(1965, mechanisms::slider_cranks),
    },
];

impl Corpus {
    /// The corpus of this name.
    pub fn named(name: &str) -> Option<&'static Corpus> {
        CORPORA.iter().find(|corpus| corpus.name == name)
    }

    /// What its problems are drawn from; `None` where nothing is drawn.
    pub fn seed(&self) -> Option<u64> {
        match self.source {
            Source::Drawn(seed, _) => Some(seed),
            Source::Built(_) | Source::Kept(_) => None,
        }
    }

    /// The lines of its file of problems.
    pub fn lines(&self) -> Vec<String> {
        let problems = match self.source {
            Source::Drawn(seed, make) => make(&mut Draw::new(seed)),
            Source::Built(make) => make(),
            Source::Kept(text) => return text.lines().map(str::to_owned).collect(),
        };
        let numbered = problems.iter().enumerate();
        numbered
            .map(|(place, problem)| problem.line(self.name, place + 1).to_string())
            .collect()
    }
}

/// A problem before it has its id.
struct Problem {
    /// The last part of the id; the number of the problem where it is empty.
    name: String,
    kind: String,
    flags: Vec<&'static str>,
    note: Option<String>,
    /// What [`solve`] reads: the field `problem` and the input.
    input: Value,
    claims: Value,
}

impl Problem {
    fn new(kind: impl Into<String>, flags: &[&'static str], input: Value) -> Self {
        Problem {
            name: String::new(),
            kind: kind.into(),
            flags: flags.to_vec(),
            note: None,
            input,
            claims: json!({}),
        }
    }

    fn claiming(self, claims: Value) -> Self {
        Problem { claims, ..self }
    }

    fn named(self, name: impl Into<String>) -> Self {
        Problem {
            name: name.into(),
            ..self
        }
    }

    fn noted(self, note: impl Into<String>) -> Self {
        Problem {
            note: Some(note.into()),
            ..self
        }
    }

    fn line(&self, corpus: &str, number: usize) -> Value {
        let name = if self.name.is_empty() {
            format!("{number:04}")
        } else {
            self.name.clone()
        };
        let mut line = Map::new();
        line.insert("id".into(), json!(format!("{corpus}/{name}")));
        line.insert("kind".into(), json!(self.kind));
        line.insert("flags".into(), json!(self.flags));
        if let Some(note) = &self.note {
            line.insert("note".into(), json!(note));
        }
        if let Value::Object(input) = &self.input {
            line.extend(input.clone());
        }
        line.insert("claims".into(), self.claims.clone());
        Value::Object(line)
    }
}

/// The line of the file of answers that belongs to a problem.
///
/// # Errors
/// A problem that [`solve`] refuses.
pub fn answer_line(problem: &Value) -> Result<Value, ProblemError> {
    let request = Request {
        digits: DIGITS,
        ..Request::default()
    };
    let answer = solve(problem, &request)?;
    let condition = condition(problem, &answer);
    let id = problem.get("id").cloned().unwrap_or_default();
    Ok(json!({"id": id, "condition": condition, "answer": answer}))
}
