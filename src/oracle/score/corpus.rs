//! Corpora: problems with their certified answers.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use thiserror::Error;

use super::verdict::Reference;

/// What is wrong with a corpus, and where.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct CorpusError(pub String);

/// A problem of a corpus.
#[derive(Clone, Debug)]
pub struct Problem {
    /// Its name in the corpus.
    pub id: String,
    /// Its kind within the corpus.
    pub kind: String,
    /// The problem as a candidate gets it: without what is said about it.
    pub problem: Value,
    /// What is certified.
    pub reference: Reference,
}

/// Problems with certified answers.
#[derive(Clone, Debug)]
pub struct Corpus {
    /// The name of its files.
    pub name: String,
    /// In the order of the file.
    pub problems: Vec<Problem>,
}

/// What is said about a problem and is no part of it.
const ABOUT: [&str; 4] = ["kind", "flags", "note", "claims"];

/// The names of all corpora of a folder that have answers.
///
/// # Errors
/// A folder without `problems` or without any answers.
pub fn names(folder: &Path) -> Result<Vec<String>, CorpusError> {
    let problems = folder.join("problems");
    let entries = fs::read_dir(&problems)
        .map_err(|error| CorpusError(format!("{}: {error}", problems.display())))?;
    let mut names: Vec<String> = entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "jsonl")
        })
        .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
        .filter(|name| file(folder, "answers", name).is_file())
        .collect();
    names.sort();
    if names.is_empty() {
        let place = folder.display();
        return Err(CorpusError(format!(
            "{place}: no corpus; problems/NAME.jsonl and answers/NAME.jsonl were expected"
        )));
    }
    Ok(names)
}

fn file(folder: &Path, part: &str, name: &str) -> PathBuf {
    folder.join(part).join(format!("{name}.jsonl"))
}

/// Reads a corpus.
///
/// # Errors
/// Files that cannot be read, lines that are no problem or no answer, a problem without an answer.
pub fn read(folder: &Path, name: &str) -> Result<Corpus, CorpusError> {
    let mut answers = HashMap::new();
    for (place, line) in lines(&file(folder, "answers", name))? {
        let id = text(&line, "id", &place)?.to_owned();
        if answers.insert(id.clone(), line).is_some() {
            return Err(CorpusError(format!("{place}: `{id}` has two answers")));
        }
    }
    let mut problems = Vec::new();
    for (place, line) in lines(&file(folder, "problems", name))? {
        let id = text(&line, "id", &place)?;
        let answer = answers.remove(id).ok_or_else(|| {
            CorpusError(format!("{place}: `{id}` has no answer, or stands twice"))
        })?;
        problems.push(problem(&line, &answer, &place)?);
    }
    Ok(Corpus {
        name: name.to_owned(),
        problems,
    })
}

fn problem(line: &Value, answer: &Value, place: &str) -> Result<Problem, CorpusError> {
    let name = text(line, "problem", place)?;
    let absent = Value::Null;
    let certified = answer.get("answer").unwrap_or(&absent);
    let condition = answer.get("condition").unwrap_or(&absent);
    let reference = Reference::read(name, certified, condition)
        .map_err(|error| CorpusError(format!("{place}: answer: {error}")))?;
    let mut problem = line.clone();
    if let Some(fields) = problem.as_object_mut() {
        fields.retain(|name, _| !ABOUT.contains(&name.as_str()));
    }
    let kind = line.get("kind").and_then(Value::as_str);
    Ok(Problem {
        id: text(line, "id", place)?.to_owned(),
        kind: kind.unwrap_or(name).to_owned(),
        problem,
        reference,
    })
}

/// The values on the lines of a file, with their places.
fn lines(file: &Path) -> Result<Vec<(String, Value)>, CorpusError> {
    let shown = file.display();
    let whole =
        fs::read_to_string(file).map_err(|error| CorpusError(format!("{shown}: {error}")))?;
    let mut values = Vec::new();
    for (number, line) in whole
        .lines()
        .enumerate()
        .filter(|(_, line)| !line.trim().is_empty())
    {
        let place = format!("{shown}:{}", number + 1);
        let value = serde_json::from_str(line)
            .map_err(|error| CorpusError(format!("{place}: no JSON: {error}")))?;
        values.push((place, value));
    }
    Ok(values)
}

fn text<'a>(line: &'a Value, name: &str, place: &str) -> Result<&'a str, CorpusError> {
    let text = line.get(name).and_then(Value::as_str);
    text.ok_or_else(|| CorpusError(format!("{place}: {name}: a text was expected")))
}
