//! The pictures beside the statements of a source, drawn from our own results.
//!
//! Which there are is said in `data/pictures.toml`: each is a problem with its answer, a linkage of a
//! printed example, or a drawing that no problem asks for.

mod compatibility_triangle;
mod conformal_sketch;
mod drawings;
mod figure;
mod four_poles;
mod opposite_sides;
mod twelve_points;

use serde::Deserialize;
use serde_json::Value;
use thiserror::Error;

use super::canvas::escaped;
use crate::ledger::{Paper, PaperError, built_in};
use crate::oracle::{Arithmetic, ProblemError, Request, solve};
use crate::scenes::Unbuilt;

/// A picture with what is said about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exhibit {
    /// It stands before the first statement whose id begins so.
    pub beside: String,
    /// Its heading.
    pub title: String,
    /// What to see in it.
    pub caption: String,
    /// An SVG document.
    pub svg: String,
    /// Whether something in it can be moved.
    pub moving: bool,
}

/// Why there is no picture.
#[derive(Debug, Error)]
pub enum GalleryError {
    /// The list of pictures cannot be read.
    #[error("data/pictures.toml: {0}")]
    List(#[from] toml::de::Error),
    /// A problem that is no JSON.
    #[error("the picture `{0}`: {1}")]
    Json(String, serde_json::Error),
    /// A problem that cannot be solved.
    #[error("the picture `{0}`: {1}")]
    Problem(String, ProblemError),
    /// The statements of a source cannot be read.
    #[error(transparent)]
    Paper(#[from] PaperError),
    /// The linkage of an example does not exist.
    #[error("the picture `{0}`: {1}")]
    Unbuilt(String, Unbuilt),
    /// An answer, or a name of a drawing, for which there is no picture.
    #[error("the picture `{0}`: there is nothing to draw")]
    Nothing(String),
}

/// The list of all pictures.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    picture: Vec<Entry>,
}

/// One of them.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    source: String,
    beside: String,
    title: String,
    caption: String,
    /// What is solved, as JSON.
    problem: Option<String>,
    /// How it is drawn, if not as every answer to such a problem.
    drawing: Option<String>,
    /// The example of the source that has the numbers of a drawing.
    example: Option<String>,
    #[serde(default)]
    moving: bool,
}

/// All pictures of a source, in the order of the list.
///
/// # Errors
/// None for the data that come with the library.
pub fn of_source(key: &str) -> Result<Vec<Exhibit>, GalleryError> {
    let list: List = toml::from_str(include_str!("../../../data/pictures.toml"))?;
    let entries = list.picture.into_iter();
    let entries: Vec<Entry> = entries.filter(|entry| entry.source == key).collect();
    let papers = if entries.iter().any(|entry| entry.example.is_some()) {
        built_in()?
    } else {
        Vec::new()
    };
    let drawn = entries.into_iter().map(|entry| entry.drawn(&papers));
    drawn.collect()
}

impl Entry {
    fn drawn(self, papers: &[Paper]) -> Result<Exhibit, GalleryError> {
        let svg = titled(&self.svg(papers)?, &self.title);
        Ok(Exhibit {
            beside: self.beside,
            title: self.title,
            caption: self.caption,
            svg,
            moving: self.moving,
        })
    }

    fn svg(&self, papers: &[Paper]) -> Result<String, GalleryError> {
        let problem = self.problem()?;
        let nothing = || GalleryError::Nothing(self.title.clone());
        match (self.drawing.as_deref(), &problem) {
            (Some("figure"), _) => figure::of_example(self, papers),
            (Some(drawing), problem) => {
                let answer = problem.as_ref().map(|problem| self.solved(problem));
                let answer = answer.transpose()?;
                drawings::svg(drawing, problem.as_ref().zip(answer.as_ref())).ok_or_else(nothing)
            }
            (None, Some(problem)) if problem["problem"] == "deviation" => {
                figure::of_design(self, problem)
            }
            (None, Some(problem)) => {
                let answer = self.solved(problem)?;
                let draw = if self.moving {
                    super::moving_picture
                } else {
                    super::picture
                };
                draw(problem, &answer).ok_or_else(nothing)
            }
            (None, None) => Err(nothing()),
        }
    }

    fn problem(&self) -> Result<Option<Value>, GalleryError> {
        let problem = self.problem.as_deref().map(serde_json::from_str);
        problem
            .transpose()
            .map_err(|error| GalleryError::Json(self.title.clone(), error))
    }

    fn solved(&self, problem: &Value) -> Result<Value, GalleryError> {
        let request = Request {
            digits: 15,
            arithmetic: Arithmetic::Certified,
        };
        solve(problem, &request).map_err(|error| GalleryError::Problem(self.title.clone(), error))
    }
}

/// The same picture with this title, in place of that which all of its kind have.
fn titled(svg: &str, title: &str) -> String {
    let old = svg
        .split_once(r#"<title id="title">"#)
        .and_then(|(_, rest)| rest.split_once("</title>"));
    match old {
        Some((old, _)) => svg.replace(&format!(">{old}</"), &format!(">{}</", escaped(title))),
        None => svg.to_owned(),
    }
}
