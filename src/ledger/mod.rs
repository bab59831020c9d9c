//! The ledger of statements: what the sources print, and the verdicts on it.
//!
//! Data flow one way: a statement from `data/papers` and its scene give a [`Judgement`]; nothing of
//! a verdict is stored, and the `expected` one of the data is only compared with it.

mod error;
mod example;
mod formula;
mod judge;
mod judge_all;
mod judged;
mod measured;
mod mutation;
mod number;
mod paper;
mod printed;
mod raw_number_table;
mod raw_table;
mod stage;
mod table;
mod verdict;
mod words;

pub use error::JudgeError;
pub use example::Example;
pub use judge::{Judge, Options};
pub use judge_all::judge_all;
pub use judged::{Decided, Judged, NotJudged};
pub use mutation::MutantCounts;
pub use paper::{
    Condition, Content, Paper, PaperError, Statement, built_in, read_folder, read_paper,
};
pub use printed::{NoDecimal, Printed};
pub use table::{PrintedRow, PrintedTable};
pub use verdict::{Cause, Computed, Judgement, Kind, Proof, Verdict};
