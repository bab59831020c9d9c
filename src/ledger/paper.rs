//! Reading `data/papers/<key>.toml`.

use std::collections::{BTreeMap, HashSet};
use std::path::Path;
use std::sync::Arc;

use serde::Deserialize;
use thiserror::Error;
use toml::Spanned;

use super::example::Example;
use super::raw_number_table::RawNumberTable;
use super::raw_table::RawTable;
use super::table::PrintedTable;
use super::{Cause, Kind, Verdict};
use crate::formula::{Formula, read};
use crate::scenes::{self, Scene};

/// A source with its statements.
#[derive(Clone, Debug)]
pub struct Paper {
    /// The word before the first `/` of its ids.
    pub key: String,
    /// Author, title, year.
    pub title: String,
    /// How many statements the source has; those that are not yet in the data are undecided.
    pub total: usize,
    /// The statements in the order of the print.
    pub statements: Vec<Statement>,
}

/// One line of a source.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Permanent, opaque, case-sensitive.
    pub id: String,
    /// Where it stands.
    pub locus: String,
    /// Equation, claim, number or cell.
    pub kind: Kind,
    /// What its symbols mean.
    pub scene: &'static Scene,
    /// The example that gives the scene's parameters; without one the line is meant for all.
    pub example: Option<Example>,
    /// As printed, in the words of the inventory.
    pub printed: String,
    /// What the line says.
    pub content: Content,
    /// Under what the line holds, where the text does not state it.
    pub condition: Option<Condition>,
    /// The right form where the print is wrong.
    pub correct: Option<Text>,
    /// Who made it wrong.
    pub cause: Option<Cause>,
    /// The id of the wrong line that this one follows from.
    pub inherited_from: Option<String>,
    /// Checks in code that belong to the line.
    pub checks: Vec<String>,
    /// The verdict that is asserted.
    pub expected: Verdict,
    /// How the printed number was made: what explains its whole column or block.
    pub convention: Option<String>,
    /// What was tried in vain to reproduce a print whose making is not known.
    pub tried: Option<String>,
    /// What a reader should know.
    pub note: Option<String>,
    /// The data file.
    pub file: String,
    /// The line there where it begins.
    pub line: usize,
}

impl Statement {
    /// File, line and id, for messages.
    pub fn place(&self) -> String {
        format!("{}:{}: {}", self.file, self.line, self.id)
    }
}

/// A formula and the text it was read from.
#[derive(Clone, Debug)]
pub struct Text {
    /// As in the data.
    pub text: String,
    /// As read.
    pub formula: Formula,
}

/// What a line says.
#[derive(Clone, Debug)]
pub enum Content {
    /// A formula.
    Formula(Text),
    /// A printed value of a quantity of the scene.
    Value {
        /// The quantity.
        quantity: Text,
        /// What else gives the printed digits where they are wrong.
        explained_by: Option<Text>,
        /// The true value, where the quantity is what a machine computed in its place.
        certified: Option<Text>,
    },
    /// What only the checks in code decide.
    Check,
    /// A line that the scan garbled beyond reading; it rests on its right form.
    Garbled,
    /// A cell of a table.
    Cell {
        /// The table.
        table: Arc<PrintedTable>,
        /// The name of its row.
        row: String,
        /// The name of its column.
        column: String,
    },
    /// All cells of a table as one statement.
    Table(Arc<PrintedTable>),
}

/// Under what a line holds that the text does not state.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Where the line holds.
    pub text: Text,
    /// Has configurations in which the condition fails: the line must fail in one of them.
    pub outside: &'static Scene,
}

/// What is wrong with a data file, and where.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{file}{}: {message}", at_line(*line))]
pub struct PaperError {
    /// The file.
    pub file: String,
    /// The line, from 1; 0 where the file as a whole is meant.
    pub line: usize,
    /// What is wrong and what was expected.
    pub message: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawPaper {
    source: RawSource,
    #[serde(default)]
    example: BTreeMap<String, Spanned<RawExample>>,
    #[serde(default)]
    statement: Vec<Spanned<RawStatement>>,
    #[serde(default)]
    table: Vec<Spanned<RawTable>>,
    #[serde(default)]
    number_table: Vec<Spanned<RawNumberTable>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawSource {
    key: String,
    title: String,
    statements: usize,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawExample {
    scene: String,
    #[serde(default)]
    given: BTreeMap<String, String>,
    /// Printed decimals, each known to its last digit only.
    #[serde(default)]
    measured: BTreeMap<String, String>,
}

/// A statement as it stands in the data.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawStatement {
    pub id: String,
    pub locus: String,
    pub kind: Kind,
    pub scene: Option<String>,
    pub example: Option<String>,
    pub quantity: Option<String>,
    pub printed: Option<String>,
    pub verbatim: Option<String>,
    pub condition: Option<String>,
    pub outside: Option<String>,
    pub correct: Option<String>,
    pub explained_by: Option<String>,
    pub certified: Option<String>,
    pub convention: Option<String>,
    pub tried: Option<String>,
    pub cause: Option<Cause>,
    pub inherited_from: Option<String>,
    #[serde(default)]
    pub checks: Vec<String>,
    pub expected: Verdict,
    pub note: Option<String>,
}

/// The five sources as they were when this program was built.
pub fn built_in() -> Result<Vec<Paper>, PaperError> {
    [
        (
            "wunderlich1968",
            include_str!("../../data/papers/wunderlich1968.toml"),
        ),
        (
            "filemon1970",
            include_str!("../../data/papers/filemon1970.toml"),
        ),
        (
            "filemon1973",
            include_str!("../../data/papers/filemon1973.toml"),
        ),
        (
            "tesar1964",
            include_str!("../../data/papers/tesar1964.toml"),
        ),
        ("kaufman", include_str!("../../data/papers/kaufman.toml")),
    ]
    .into_iter()
    .map(|(key, text)| read_paper(&format!("data/papers/{key}.toml"), text))
    .collect()
}

/// All `.toml` files of a folder, in the order of their names.
pub fn read_folder(folder: &Path) -> Result<Vec<Paper>, PaperError> {
    let unreadable = |path: &Path, error: std::io::Error| PaperError {
        file: path.display().to_string(),
        line: 0,
        message: error.to_string(),
    };
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|error| unreadable(folder, error))? {
        let path = entry.map_err(|error| unreadable(folder, error))?.path();
        if path
            .extension()
            .is_some_and(|extension| extension == "toml")
        {
            paths.push(path);
        }
    }
    paths.sort();
    if paths.is_empty() {
        return Err(PaperError {
            file: folder.display().to_string(),
            line: 0,
            message: "holds no .toml file; a folder of papers was expected".to_owned(),
        });
    }
    paths
        .iter()
        .map(|path| {
            let text = std::fs::read_to_string(path).map_err(|error| unreadable(path, error))?;
            read_paper(&path.display().to_string(), &text)
        })
        .collect()
}

/// Reads and checks one paper; `file` is for messages.
pub fn read_paper(file: &str, text: &str) -> Result<Paper, PaperError> {
    let reader = Reader { file, text };
    let raw: RawPaper = toml::from_str(text).map_err(|error| {
        let place = error.span().map_or(0, |span| span.start);
        reader.error(place, one_line(error.message()))
    })?;
    let mut in_order = Vec::new();
    for statement in raw.statement {
        let place = statement.span().start;
        in_order.push((
            place,
            reader.statement(statement.into_inner(), place, &raw.example)?,
        ));
    }
    for table in raw.table {
        let place = table.span().start;
        let cells = reader.table(&table.into_inner(), place)?;
        in_order.extend(cells.into_iter().map(|cell| (place, cell)));
    }
    for table in raw.number_table {
        let place = table.span().start;
        let cells = reader.number_table(&table.into_inner(), place, &raw.example)?;
        in_order.extend(cells.into_iter().map(|cell| (place, cell)));
    }
    in_order.sort_by_key(|(place, _)| *place);
    let mut statements = Vec::new();
    let mut seen = HashSet::new();
    for (place, statement) in in_order {
        if statement.id.split_once('/').map(|(key, _)| key) != Some(&raw.source.key) {
            return Err(reader.error(
                place,
                format!(
                    "the id `{}` must begin with `{}/`",
                    statement.id, raw.source.key
                ),
            ));
        }
        if !seen.insert(statement.id.clone()) {
            return Err(reader.error(place, format!("the id `{}` stands twice", statement.id)));
        }
        statements.push(statement);
    }
    if statements.len() > raw.source.statements {
        return Err(reader.error(
            0,
            format!(
                "{} statements, but the source has {} by its own count",
                statements.len(),
                raw.source.statements
            ),
        ));
    }
    Ok(Paper {
        key: raw.source.key,
        title: raw.source.title,
        total: raw.source.statements,
        statements,
    })
}

/// The scenes whose names hold this one, else those of its source, else all sources.
fn near_scenes(name: &str) -> Vec<&'static str> {
    let source = |name: &'static str| name.split('/').next().unwrap_or(name);
    let names = || scenes::scenes().iter().map(|scene| scene.name);
    let holding: Vec<_> = names().filter(|known| known.contains(name)).collect();
    let of_source = names().filter(|known| name.split('/').next() == Some(source(known)));
    let mut sources: Vec<_> = names().map(source).collect();
    sources.dedup();
    [holding, of_source.collect(), sources]
        .into_iter()
        .find(|near| !near.is_empty())
        .unwrap_or_default()
}

fn one_line(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}

struct Reader<'a> {
    file: &'a str,
    text: &'a str,
}

impl Reader<'_> {
    fn line(&self, place: usize) -> usize {
        let before = self.text.as_bytes().iter().take(place);
        1 + before.filter(|byte| **byte == b'\n').count()
    }

    fn error(&self, place: usize, message: impl Into<String>) -> PaperError {
        PaperError {
            file: self.file.to_owned(),
            line: self.line(place),
            message: message.into(),
        }
    }

    fn formula(&self, place: usize, field: &str, text: &str) -> Result<Text, PaperError> {
        match read(text) {
            Ok(formula) => Ok(Text {
                text: text.to_owned(),
                formula,
            }),
            Err(error) => Err(self.error(
                place,
                format!(
                    "{field} `{}`, column {}: {error}",
                    shortened(text),
                    error.span.start + 1
                ),
            )),
        }
    }

    fn example(
        &self,
        place: usize,
        name: &str,
        examples: &BTreeMap<String, Spanned<RawExample>>,
    ) -> Result<(String, Example), PaperError> {
        let Some(raw) = examples.get(name) else {
            let known: Vec<&str> = examples.keys().map(String::as_str).collect();
            return Err(self.error(
                place,
                format!("unknown example `{name}`; this file has {}", listed(&known)),
            ));
        };
        let inner = raw.get_ref();
        let mut example = Example::new(format!("{}: {name}", self.file));
        for (parameter, text) in &inner.given {
            let value = self.formula(raw.span().start, parameter, text)?;
            example.given.insert(parameter.clone(), value.formula);
        }
        for (parameter, text) in &inner.measured {
            example
                .measure(parameter, text)
                .map_err(|error| self.error(raw.span().start, format!("{parameter}: {error}")))?;
        }
        Ok((inner.scene.clone(), example))
    }

    fn condition(
        &self,
        place: usize,
        raw: &RawStatement,
        scene: &'static Scene,
    ) -> Result<Option<Condition>, PaperError> {
        match (&raw.condition, &raw.outside) {
            (Some(text), outside) => Ok(Some(Condition {
                text: self.formula(place, "condition", text)?,
                outside: match outside {
                    Some(name) => self.scene(place, name)?,
                    None => scene,
                },
            })),
            (None, None) => Ok(None),
            (None, Some(_)) => Err(self.error(
                place,
                format!(
                    "{}: `outside` is where a `condition` fails; there is none",
                    raw.id
                ),
            )),
        }
    }

    fn scene(&self, place: usize, name: &str) -> Result<&'static Scene, PaperError> {
        scenes::find(name).ok_or_else(|| {
            let near = listed(&near_scenes(name));
            self.error(place, format!("unknown scene `{name}`; there are {near}"))
        })
    }

    fn table(&self, raw: &RawTable, place: usize) -> Result<Vec<Statement>, PaperError> {
        let scene = self.scene(place, &raw.scene)?;
        raw.statements(scene, (self.file, self.line(place)))
            .map_err(|message| self.error(place, format!("{}: {message}", raw.id)))
    }

    /// Every cell as the statement that it would be alone.
    fn number_table(
        &self,
        raw: &RawNumberTable,
        place: usize,
        examples: &BTreeMap<String, Spanned<RawExample>>,
    ) -> Result<Vec<Statement>, PaperError> {
        let error = |message: String| self.error(place, format!("{}: {message}", raw.id));
        let mut statements = Vec::new();
        for (cell, given) in raw.cells().map_err(error)? {
            let mut statement = self.statement(cell, place, examples)?;
            if let Some(example) = &mut statement.example {
                for (parameter, text) in given {
                    let value = self.formula(place, parameter, text)?;
                    example.name = format!("{}, {parameter} = {text}", example.name);
                    example.given.insert(parameter.clone(), value.formula);
                }
            }
            statements.push(statement);
        }
        Ok(statements)
    }

    fn statement(
        &self,
        raw: RawStatement,
        place: usize,
        examples: &BTreeMap<String, Spanned<RawExample>>,
    ) -> Result<Statement, PaperError> {
        let error = |message: String| self.error(place, format!("{}: {message}", raw.id));
        let (scene, example) = match (&raw.scene, &raw.example) {
            (Some(scene), None) => (scene.clone(), None),
            (None, Some(name)) => {
                let (scene, example) = self.example(place, name, examples)?;
                (scene, Some(example))
            }
            _ => {
                return Err(error(
                    "either `scene` or `example` was expected, and not both".to_owned(),
                ));
            }
        };
        let scene = self.scene(place, &scene)?;
        if !raw.expected.fits(raw.kind) {
            return Err(error(format!(
                "`expected = \"{}\"` does not fit the kind `{}`",
                raw.expected, raw.kind
            )));
        }
        let wrong = raw.expected.is_erratum();
        if wrong != raw.cause.is_some() || raw.correct.is_some() && !wrong {
            return Err(error(
                "a line that is wrong (`fails`, `contradicted`) has a `cause` and may have a \
                 `correct` form; no other line has either"
                    .to_owned(),
            ));
        }
        if (raw.cause == Some(Cause::Inherited)) != raw.inherited_from.is_some() {
            return Err(error(
                "`inherited_from` names the wrong line of a cause `inherited`, and of no other"
                    .to_owned(),
            ));
        }
        let (printed, garbled) = match (&raw.printed, &raw.verbatim) {
            (Some(printed), None) => (printed.clone(), false),
            (None, Some(verbatim)) => (verbatim.clone(), true),
            _ => {
                return Err(error(
                    "either `printed` or, for a line that cannot be read, `verbatim` was expected"
                        .to_owned(),
                ));
            }
        };
        let as_expected = raw.cause == Some(Cause::Copy) && raw.expected == Verdict::Fails;
        if garbled && !(as_expected && raw.correct.is_some()) {
            return Err(error(
                "a line stored verbatim fails with cause `copy`, and has its right form in `correct`"
                    .to_owned(),
            ));
        }
        let condition = self.condition(place, &raw, scene)?;
        let optional = |field: &str, text: &Option<String>| {
            let read = |text: &String| self.formula(place, field, text);
            text.as_ref().map(read).transpose()
        };
        let content = match (&raw.quantity, raw.kind) {
            _ if garbled => Content::Garbled,
            (Some(quantity), _) => {
                if example.is_none() {
                    return Err(error(
                        "a printed value of a quantity needs an `example`".to_owned(),
                    ));
                }
                Content::Value {
                    quantity: self.formula(place, "quantity", quantity)?,
                    explained_by: optional("explained_by", &raw.explained_by)?,
                    certified: optional("certified", &raw.certified)?,
                }
            }
            (None, Kind::Number) => {
                return Err(error("a number needs a `quantity`".to_owned()));
            }
            (None, Kind::Claim) if !raw.checks.is_empty() && condition.is_none() => Content::Check,
            (None, _) => Content::Formula(self.formula(place, "printed", &printed)?),
        };
        let correct = optional("correct", &raw.correct)?;
        if let Some(unknown) = raw
            .checks
            .iter()
            .find(|name| scenes::find_check(name).is_none())
        {
            let known: Vec<&str> = scenes::checks().iter().map(|check| check.name).collect();
            return Err(error(format!(
                "unknown check `{unknown}`; there are {}",
                listed(&known)
            )));
        }
        Ok(Statement {
            file: self.file.to_owned(),
            line: self.line(place),
            id: raw.id,
            locus: raw.locus,
            kind: raw.kind,
            scene,
            example,
            printed,
            content,
            condition,
            correct,
            cause: raw.cause,
            inherited_from: raw.inherited_from,
            checks: raw.checks,
            expected: raw.expected,
            convention: raw.convention,
            tried: raw.tried,
            note: raw.note,
        })
    }
}

pub(super) fn listed(names: &[&str]) -> String {
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}

/// A text that fits into a message.
fn shortened(text: &str) -> String {
    const MOST: usize = 200;
    if text.chars().count() <= MOST {
        return text.to_owned();
    }
    let start: String = text.chars().take(MOST).collect();
    format!("{start}…")
}

fn at_line(line: usize) -> String {
    if line == 0 {
        String::new()
    } else {
        format!(":{line}")
    }
}
