//! One answer of a candidate against the certified one.

use std::fmt;

use rug::Rational;
use serde_json::Value;

use super::compare::{self, Closeness};
use super::family::Family;
use super::matching;
use super::number::Known;
use super::outline::Outline;
use super::read::{Member, Misread, Part, Source, Stated, Statements, read};
use super::shape::{self, Shape};
use crate::number::text::parse_rational;
use crate::number::{Ball, Number, count};

/// What is known for certain about a problem.
#[derive(Clone, Debug)]
pub struct Reference {
    shape: &'static Shape,
    statements: Statements,
    /// The relative error that is allowed.
    tolerance: Rational,
    /// The largest number in the answer, 1 if none is larger than 0.
    scale: Rational,
}

/// How a part of an answer came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A certified solution that is given.
    Found,
    /// A certified solution that is not given.
    Missed,
    /// A given solution that does not exist.
    Invented,
    /// A given pair that is one of infinitely many.
    OfFamily,
    /// A fact that is stated rightly.
    Right,
    /// A fact that is stated wrongly.
    Wrong,
    /// The candidate says nothing of it.
    Unstated,
}

impl fmt::Display for Mark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Mark::Found => "found",
            Mark::Missed => "missed",
            Mark::Invented => "invented",
            Mark::OfFamily => "one of infinitely many, or given once more",
            Mark::Right => "right",
            Mark::Wrong => "wrong",
            Mark::Unstated => "not stated",
        })
    }
}

impl Mark {
    /// Neither missed nor invented nor wrong.
    pub fn is_good(self) -> bool {
        !matches!(self, Mark::Missed | Mark::Invented | Mark::Wrong)
    }
}

/// Certified and given side by side.
#[derive(Clone, Debug)]
pub struct Line {
    /// The place in the answer.
    pub place: String,
    /// How it came out.
    pub mark: Mark,
    /// What is certified.
    pub certified: Option<String>,
    /// What is given.
    pub given: Option<String>,
    /// How close it is, of numbers that are found.
    pub closeness: Option<Closeness>,
    /// Of what is invented: the digits that it shares with the nearest that is certified.
    pub nearest: Option<f64>,
}

/// How often solutions without an order were compared, and in how many cases exact numbers had to decide.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Comparisons {
    /// All of them.
    pub made: usize,
    /// Those that intervals of machine floats did not decide.
    pub exact: usize,
}

/// The verdict on one answer.
#[derive(Clone, Debug, Default)]
pub struct Verdict {
    /// Part by part.
    pub lines: Vec<Line>,
    /// Of a degenerate case: whether all that makes it one is stated, and nothing is wrong.
    pub degenerate: Option<bool>,
    /// Whether the candidate stated anything that is scored.
    pub stated: bool,
    /// How its solutions were compared.
    pub comparisons: Comparisons,
}

impl Verdict {
    /// How many parts came out so.
    pub fn count(&self, mark: Mark) -> usize {
        self.lines.iter().filter(|line| line.mark == mark).count()
    }

    /// Correct digits of what is found.
    pub fn digits(&self) -> impl Iterator<Item = f64> {
        let found = self.lines.iter().filter_map(|line| line.closeness);
        found.map(|closeness| closeness.digits())
    }

    /// Nothing missed, invented or wrong.
    pub fn is_clean(&self) -> bool {
        self.lines.iter().all(|line| line.mark.is_good())
    }
}

impl Reference {
    /// Reads a certified answer to a problem of this kind; `condition` is the relative change of the
    /// answer for a relative change of the problem.
    ///
    /// # Errors
    /// A kind of problem that is not scored, or what is no answer to it.
    pub fn read(problem: &str, answer: &Value, condition: &Value) -> Result<Self, Misread> {
        let shape = shape::of(problem)
            .ok_or_else(|| Misread(format!("the problem `{problem}` cannot be scored")))?;
        let undecided = answer.get("undecided").and_then(Value::as_str);
        let source = match undecided {
            Some(_) => Source::PartlyUndecided,
            None => Source::Certified,
        };
        let mut statements = read(shape, answer, source)?;
        statements.retain(|(place, _)| !undecided.is_some_and(|names| is_open(place, names)));
        let condition = match condition {
            Value::Null => Rational::new(),
            number => Known::read(number, "condition")?.value,
        };
        let scale = scale(&statements);
        Ok(Reference {
            shape,
            statements,
            tolerance: tolerance(&condition),
            scale,
        })
    }

    /// The relative error that is allowed.
    pub fn tolerance(&self) -> f64 {
        self.tolerance.to_f64()
    }

    /// The relative error that is allowed where so many solutions fall into one: m of them part by the
    /// m-th root of what a problem is off, here by a thousand roundings.
    fn tolerance_of(&self, multiplicity: usize) -> Rational {
        let root = thousand_roundings()
            .to_f64()
            .powf(1.0 / count::to_f64(multiplicity));
        let parting = Rational::from_f64(root).unwrap_or_default();
        if multiplicity > 1 {
            parting.max(self.tolerance.clone())
        } else {
            self.tolerance.clone()
        }
    }

    /// Whether the answer is out of the ordinary: at infinity, infinitely many, multiple.
    pub fn is_degenerate(&self) -> bool {
        self.statements.iter().any(|(_, stated)| match stated {
            Stated::One { degenerate, .. } => *degenerate,
            Stated::Set {
                members,
                degenerate,
                ..
            } => members
                .iter()
                .any(|member| *degenerate || member.multiplicity > 1),
        })
    }

    /// Judges a candidate's answer.
    ///
    /// # Errors
    /// What is no answer to such a problem.
    pub fn judge(&self, problem: &Value, answer: &Value) -> Result<Verdict, Misread> {
        if !answer.is_object() {
            return Err(Misread::expected("an object", answer, "result"));
        }
        let given = read(self.shape, answer, Source::Candidate)?;
        let mut judge = Judge {
            reference: self,
            family: Family::of(problem, &self.statements),
            verdict: Verdict::default(),
            degenerate: Vec::new(),
        };
        for (place, certified) in &self.statements {
            let stated = given.iter().find(|(other, _)| other == place);
            judge.part(place, certified, stated.map(|(_, stated)| stated));
        }
        judge.unknown(&given);
        Ok(judge.finished())
    }
}

/// Whether a place is, or lies below, one that is named as undecided. Where it is open whether there
/// are infinitely many solutions, all is.
fn is_open(place: &str, undecided: &str) -> bool {
    let mut names = undecided.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '.'));
    names.any(|name| {
        let below = place.strip_prefix(name);
        name == "family"
            || !name.is_empty()
                && below.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    })
}

/// 10⁻⁶, or a thousand times what double precision allows at this condition.
fn tolerance(condition: &Rational) -> Rational {
    (condition.clone().abs() * thousand_roundings()).max(Rational::from((1, 1_000_000)))
}

/// Of double precision.
fn thousand_roundings() -> Rational {
    Rational::from((1000, 1u64 << 53))
}

fn scale(statements: &Statements) -> Rational {
    let mut largest = Rational::new();
    for (_, stated) in statements {
        let parts: Vec<&Part> = match stated {
            Stated::One { part, .. } => vec![part],
            Stated::Set { members, .. } => {
                let parts = members.iter().flat_map(|member| &member.parts);
                parts.map(|(_, part)| part).collect()
            }
        };
        let sizes = parts.into_iter().map(compare::size);
        largest = sizes.fold(largest, Rational::max);
    }
    if largest.is_zero() {
        Rational::from(1)
    } else {
        largest
    }
}

struct Judge<'a> {
    reference: &'a Reference,
    family: Option<Family>,
    verdict: Verdict,
    /// What makes the case degenerate, and whether it is found.
    degenerate: Vec<bool>,
}

impl Judge<'_> {
    fn part(&mut self, place: &str, certified: &Stated, given: Option<&Stated>) {
        self.verdict.stated |= given.is_some();
        match (certified, given) {
            (Stated::One { part, degenerate }, Some(Stated::One { part: given, .. })) => {
                let good = self.one(place, part, given);
                self.degenerate.extend(degenerate.then_some(good));
            }
            (Stated::One { part, degenerate }, _) => {
                self.line(place, Mark::Unstated, Some(shown(part)), None, None);
                self.degenerate.extend(degenerate.then_some(false));
            }
            (
                Stated::Set {
                    members,
                    required,
                    degenerate,
                },
                given,
            ) => match given {
                Some(Stated::Set { members: given, .. }) => {
                    self.set(place, members, given, *degenerate);
                }
                _ => {
                    let mark = if *required {
                        Mark::Missed
                    } else {
                        Mark::Unstated
                    };
                    for member in members {
                        self.line(place, mark, Some(shown_member(member)), None, None);
                        if *degenerate || member.multiplicity > 1 {
                            self.degenerate.push(false);
                        }
                    }
                }
            },
        }
    }

    /// Whether the two agree.
    fn one(&mut self, place: &str, certified: &Part, given: &Part) -> bool {
        let distance = compare::error(certified, given, &self.reference.scale);
        let tolerance = &self.reference.tolerance;
        let error = distance.clone().filter(|error| error <= tolerance);
        let texts = (shown(certified), shown(given));
        let is_fact = matches!(certified, Part::Word(_));
        match (&error, is_fact) {
            (Some(_), true) => self.line(place, Mark::Right, Some(texts.0), Some(texts.1), None),
            (None, true) => self.line(place, Mark::Wrong, Some(texts.0), Some(texts.1), None),
            (Some(error), false) => {
                let closeness = Closeness::of_part(error, certified, given);
                self.line(
                    place,
                    Mark::Found,
                    Some(texts.0),
                    Some(texts.1),
                    Some(closeness),
                );
            }
            (None, false) => {
                self.line(place, Mark::Missed, Some(texts.0), None, None);
                // That there is none is no invention.
                if !matches!(given, Part::Word(_)) {
                    self.invented(place, texts.1, distance.as_ref());
                }
            }
        }
        error.is_some()
    }

    /// A member that counts several times may be given as often; once is enough.
    fn set(&mut self, place: &str, certified: &[Member], given: &[Member], degenerate: bool) {
        let once = certified.iter().map(|member| (member, true));
        let again = certified
            .iter()
            .flat_map(|member| std::iter::repeat_n((member, false), member.multiplicity - 1));
        let rows: Vec<(&Member, bool)> = once.chain(again).collect();
        let distances = self.distances(&rows, given);
        let error = |row: usize, column: usize| {
            let (member, _) = rows.get(row)?;
            let tolerance = self.reference.tolerance_of(member.multiplicity);
            let error = distances.get(row)?.get(column)?.as_ref()?;
            (*error <= tolerance).then_some((error, tolerance))
        };
        let cost = |row: usize, column: usize| {
            let (error, tolerance) = error(row, column)?;
            Some(Rational::from(error / &tolerance).to_f64())
        };
        let needed: Vec<bool> = rows.iter().map(|(_, needed)| *needed).collect();
        let columns = matching::assign(&needed, given.len(), cost);
        for (row, (column, (member, needed))) in columns.iter().zip(&rows).enumerate() {
            let matched =
                column.and_then(|column| Some((given.get(column)?, error(row, column)?.0)));
            let text = shown_member(member);
            match matched {
                Some((other, error)) => {
                    let closeness =
                        has_numbers(other).then(|| Closeness::of_member(error, member, other));
                    let mark = if *needed { Mark::Found } else { Mark::OfFamily };
                    self.line(
                        place,
                        mark,
                        Some(text),
                        Some(shown_member(other)),
                        closeness,
                    );
                    self.remarks(place, member, other);
                }
                None if *needed => self.line(place, Mark::Missed, Some(text), None, None),
                None => {}
            }
            if *needed && (degenerate || member.multiplicity > 1) {
                self.degenerate.push(matched.is_some());
            }
        }
        for (column, member) in given.iter().enumerate() {
            if !columns.contains(&Some(column)) {
                let text = shown_member(member);
                if self.is_of_family(place, member) {
                    self.line(place, Mark::OfFamily, None, Some(text), None);
                } else {
                    let scale = &self.reference.scale;
                    let distances = certified.iter();
                    let distances =
                        distances.filter_map(|other| compare::member_error(other, member, scale));
                    self.invented(place, text, distances.min().as_ref());
                }
            }
        }
    }

    /// The relative errors of all given ones; none of those that floats prove to be too far away.
    fn distances(
        &mut self,
        rows: &[(&Member, bool)],
        given: &[Member],
    ) -> Vec<Vec<Option<Rational>>> {
        let Reference { scale, .. } = self.reference;
        let comparisons = &mut self.verdict.comparisons;
        let given: Vec<(&Member, Outline)> = given
            .iter()
            .map(|member| (member, Outline::of(member)))
            .collect();
        let of_row = |(member, _): &(&Member, bool)| {
            let outline = Outline::of(member);
            let allowed = self.reference.tolerance_of(member.multiplicity);
            let of_column = |(other, its): &(&Member, Outline)| {
                comparisons.made += 1;
                if outline.is_far_from(its, scale, &allowed) {
                    return None;
                }
                comparisons.exact += 1;
                compare::member_error(member, other, scale)
            };
            given.iter().map(of_column).collect()
        };
        rows.iter().map(of_row).collect()
    }

    /// What two that are the same say beside that.
    fn remarks(&mut self, place: &str, certified: &Member, given: &Member) {
        let remarks = certified.parts.iter().filter(|(_, part)| part.is_remark());
        for (name, right) in remarks {
            let stated = given.parts.iter().find(|(other, _)| other == name);
            let mark = match stated {
                Some((_, part)) if part == right => Mark::Right,
                Some(_) => Mark::Wrong,
                None => Mark::Unstated,
            };
            let given = stated.map(|(_, part)| shown(part));
            let place = format!("{place}.{name}");
            self.line(&place, mark, Some(shown(right)), given, None);
        }
    }

    fn is_of_family(&self, place: &str, member: &Member) -> bool {
        let pairs = place == "pairs" || place == "complex_pairs";
        let infinitely_many = self.family.as_ref().filter(|_| pairs);
        infinitely_many
            .is_some_and(|family| family.holds(member, self.reference.tolerance.to_f64()))
    }

    fn invented(&mut self, place: &str, given: String, distance: Option<&Rational>) {
        self.verdict.lines.push(Line {
            place: place.to_owned(),
            mark: Mark::Invented,
            certified: None,
            given: Some(given),
            closeness: None,
            nearest: distance.map(|distance| compare::digits(distance.to_f64())),
        });
    }

    /// Numbers and solutions at places where nothing is certified.
    fn unknown(&mut self, given: &Statements) {
        for (place, stated) in given {
            if self
                .reference
                .statements
                .iter()
                .any(|(other, _)| other == place)
            {
                continue;
            }
            match stated {
                Stated::One { part, .. } if self.is_beside(place) => {
                    if !matches!(part, Part::Word(_)) {
                        self.invented(place, shown(part), None);
                    }
                }
                Stated::One { .. } | Stated::Set { .. } => {}
            }
        }
    }

    /// Whether others of its list are certified, so that this one does not exist.
    fn is_beside(&self, place: &str) -> bool {
        let list = place.rsplit_once('.').map(|(list, _)| format!("{list}."));
        list.is_some_and(|list| {
            matches!(list.as_str(), "poles." | "image_poles." | "turns.")
                && self
                    .reference
                    .statements
                    .iter()
                    .any(|(other, _)| other.starts_with(&list))
        })
    }

    fn line(
        &mut self,
        place: &str,
        mark: Mark,
        certified: Option<String>,
        given: Option<String>,
        closeness: Option<Closeness>,
    ) {
        self.verdict.lines.push(Line {
            place: place.to_owned(),
            mark,
            certified,
            given,
            closeness,
            nearest: None,
        });
    }

    fn finished(self) -> Verdict {
        let mut verdict = self.verdict;
        let clean = verdict.is_clean();
        let all = self.degenerate.iter().all(|found| *found);
        verdict.degenerate = (!self.degenerate.is_empty()).then_some(all && clean);
        verdict
    }
}

fn has_numbers(member: &Member) -> bool {
    let words = |part: &Part| matches!(part, Part::Word(_) | Part::Remark(_));
    !member.parts.iter().all(|(_, part)| words(part))
}

/// For a person: a decimal as a float shows it or a fraction where these are exact and short, else 20
/// digits.
fn shown_number(known: &Known) -> String {
    let float = known.value.to_f64().to_string();
    if float.len() <= 24 && parse_rational(&float).is_ok_and(|shown| shown == known.value) {
        return float;
    }
    let exact = known.value.to_string();
    if exact.len() <= 20 {
        return exact;
    }
    let ball = Number::<Ball>::rounded(&known.value, &128);
    ball.0.to_decimal(20).map_or(exact, |text| text.value)
}

fn shown(part: &Part) -> String {
    let listed = |numbers: &[Known], between: &str| {
        let texts: Vec<String> = numbers.iter().map(shown_number).collect();
        texts.join(between)
    };
    match part {
        Part::Numbers(numbers) => match numbers.as_slice() {
            [one] => shown_number(one),
            several => format!("({})", listed(several, ", ")),
        },
        Part::Ratio(numbers) => listed(numbers, " : "),
        Part::Degrees(known) => format!("{}°", shown_number(known)),
        Part::Word(word) | Part::Remark(word) => word.clone(),
    }
}

fn shown_member(member: &Member) -> String {
    let parts = member.parts.iter();
    let texts: Vec<String> = parts
        .map(|(name, part)| format!("{name} {}", shown(part)))
        .collect();
    let times = match member.multiplicity {
        1 => String::new(),
        times => format!(" ({times} times)"),
    };
    format!("{}{times}", texts.join(", "))
}
