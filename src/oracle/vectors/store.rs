//! The files of the corpora.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};
use thiserror::Error;

use super::{Corpus, GENERATOR};

/// Why a file of a corpus could not be read or written.
#[derive(Debug, Error)]
pub enum StoreError {
    /// The file system refused.
    #[error("{path}: {error}")]
    File {
        /// Which file.
        path: String,
        /// Why.
        error: io::Error,
    },
    /// The file is not what it should be.
    #[error("{path}: {message}")]
    Form {
        /// Which file, and the line in it.
        path: String,
        /// What is wrong.
        message: String,
    },
}

/// A folder with `problems` and `answers`.
pub struct Folder(PathBuf);

/// A problem with the line of its answer.
#[derive(Clone, Debug)]
pub struct Entry {
    /// As [`solve`](crate::oracle::solve) takes it.
    pub problem: Value,
    /// `id`, `condition` and `answer`.
    pub answer: Value,
}

impl Folder {
    /// The folder at this path, whether it exists or not.
    pub fn at(path: &Path) -> Self {
        Folder(path.to_owned())
    }

    fn problems(&self, name: &str) -> PathBuf {
        self.0.join("problems").join(format!("{name}.jsonl"))
    }

    fn answers(&self, name: &str) -> PathBuf {
        self.0.join("answers").join(format!("{name}.jsonl"))
    }

    fn register(&self) -> PathBuf {
        self.0.join("problems").join("corpora.json")
    }

    /// Problems and answers of a corpus, joined by their ids, which must be the same and in one order.
    ///
    /// # Errors
    /// A file that cannot be read, a line that is no JSON, an id without partner.
    pub fn entries(&self, name: &str) -> Result<Vec<Entry>, StoreError> {
        let problems = lines(&self.problems(name))?;
        let answers = lines(&self.answers(name))?;
        let path = self.answers(name);
        if problems.len() != answers.len() {
            let message = format!("{} answers to {} problems", answers.len(), problems.len());
            return Err(form(&path, message));
        }
        let pairs = problems.into_iter().zip(answers).enumerate();
        pairs
            .map(|(place, (problem, answer))| {
                let [expected, found] = [&problem, &answer].map(|line| &line["id"]);
                if expected != found {
                    let message = format!("line {}: {found} where {expected} was due", place + 1);
                    return Err(form(&path, message));
                }
                Ok(Entry { problem, answer })
            })
            .collect()
    }

    /// The problems of a corpus.
    ///
    /// # Errors
    /// A file that cannot be read, a line that is no JSON.
    pub fn problem_lines(&self, name: &str) -> Result<Vec<Value>, StoreError> {
        lines(&self.problems(name))
    }

    /// Every flag with what it means to fail it.
    ///
    /// # Errors
    /// A file that cannot be read or is no object.
    pub fn flags(&self) -> Result<Map<String, Value>, StoreError> {
        object(&self.0.join("problems").join("flags.json"))
    }

    /// What is recorded of every corpus.
    ///
    /// # Errors
    /// A file that cannot be read or is no object.
    pub fn recorded(&self) -> Result<Map<String, Value>, StoreError> {
        object(&self.register())
    }

    /// What should be recorded of a corpus: see [`recorded`](Self::recorded).
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn record(&self, corpus: &Corpus) -> Result<Value, StoreError> {
        let problems = read(&self.problems(corpus.name))?;
        let answers = read(&self.answers(corpus.name))?;
        Ok(json!({
            "description": corpus.description,
            "seed": corpus.seed(),
            "generator": GENERATOR,
            "problems": problems.lines().count(),
            "problems_sha256": sha256(problems.as_bytes()),
            "answers_sha256": sha256(answers.as_bytes()),
        }))
    }

    /// Writes problems and answers of a corpus and records them.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(
        &self,
        corpus: &Corpus,
        problems: &[String],
        answers: &[String],
    ) -> Result<(), StoreError> {
        write(&self.problems(corpus.name), &joined(problems))?;
        write(&self.answers(corpus.name), &joined(answers))?;
        let mut recorded = if self.register().exists() {
            self.recorded()?
        } else {
            Map::new()
        };
        recorded.insert(corpus.name.to_owned(), self.record(corpus)?);
        recorded.sort_keys();
        let text = serde_json::to_string_pretty(&recorded)
            .map_err(|error| form(&self.register(), error.to_string()))?;
        write(&self.register(), &format!("{text}\n"))
    }
}

fn joined(lines: &[String]) -> String {
    lines.iter().map(|line| format!("{line}\n")).collect()
}

fn form(path: &Path, message: String) -> StoreError {
    StoreError::Form {
        path: path.display().to_string(),
        message,
    }
}

fn failed(path: &Path) -> impl Fn(io::Error) -> StoreError {
    move |error| StoreError::File {
        path: path.display().to_string(),
        error,
    }
}

fn read(path: &Path) -> Result<String, StoreError> {
    fs::read_to_string(path).map_err(failed(path))
}

fn write(path: &Path, text: &str) -> Result<(), StoreError> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(failed(folder))?;
    }
    fs::write(path, text).map_err(failed(path))
}

fn lines(path: &Path) -> Result<Vec<Value>, StoreError> {
    let text = read(path)?;
    let lines = text.lines().enumerate();
    lines
        .map(|(place, line)| {
            serde_json::from_str(line)
                .map_err(|error| form(path, format!("line {}: no JSON: {error}", place + 1)))
        })
        .collect()
}

fn object(path: &Path) -> Result<Map<String, Value>, StoreError> {
    let value: Value =
        serde_json::from_str(&read(path)?).map_err(|error| form(path, error.to_string()))?;
    match value {
        Value::Object(object) => Ok(object),
        _ => Err(form(path, "an object was expected".to_owned())),
    }
}

/// The hash of a file's bytes in hexadecimal digits.
pub fn sha256(bytes: &[u8]) -> String {
    let hash = Sha256::digest(bytes);
    hash.iter().map(|byte| format!("{byte:02x}")).collect()
}
