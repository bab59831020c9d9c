//! Sources with what was found of all their statements.

use thiserror::Error;

use super::{JudgeError, Judgement, Options, Paper, Statement, judge_all};

/// A source with what was found of each of its statements, in order.
pub struct Judged<'a> {
    /// The source.
    pub paper: &'a Paper,
    /// One for each statement.
    pub judgements: Vec<Judgement>,
}

/// A statement and what was found of it.
#[derive(Clone, Copy, Debug)]
pub struct Decided<'a> {
    /// The statement.
    pub statement: &'a Statement,
    /// What was found.
    pub judgement: &'a Judgement,
}

/// A statement that cannot be judged.
#[derive(Debug, Error)]
#[error("{place}: {error}")]
pub struct NotJudged {
    /// File, line and id.
    pub place: String,
    /// Why.
    pub error: JudgeError,
}

impl<'a> Judged<'a> {
    /// Judges every statement of every source; `done` is told of each one.
    ///
    /// # Errors
    /// The first statement that cannot be judged.
    pub fn all(
        papers: &'a [Paper],
        options: Options,
        done: impl FnMut(),
    ) -> Result<Vec<Self>, NotJudged> {
        let judged = judge_all(papers, options, done);
        papers
            .iter()
            .zip(judged)
            .map(|(paper, of_paper)| {
                let statements = paper.statements.iter().zip(of_paper);
                let judgements: Result<Vec<Judgement>, NotJudged> = statements
                    .map(|(statement, judgement)| {
                        judgement.map_err(|error| NotJudged {
                            place: statement.place(),
                            error,
                        })
                    })
                    .collect();
                Ok(Judged {
                    paper,
                    judgements: judgements?,
                })
            })
            .collect()
    }

    /// Every statement with what was found of it.
    pub fn decided(&self) -> impl Iterator<Item = Decided<'_>> {
        let both = self.paper.statements.iter().zip(&self.judgements);
        both.map(|(statement, judgement)| Decided {
            statement,
            judgement,
        })
    }
}
