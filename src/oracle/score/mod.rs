//! Scores the answers of other programs against certified ones.
//!
//! An answer is read by its [shape](Shape) into statements at places such as `pairs` or
//! `centerpoint.focus`; the certified one and the candidate's are read by the same code. Solutions
//! without an order are matched one to one, numbers are compared as exact rationals (unless floats prove
//! them far apart), facts (words and counts) are right or wrong. What a candidate does not state is not scored, except what a shape
//! requires.

mod compare;
pub mod corpus;
mod family;
mod matching;
mod number;
mod outline;
mod read;
mod shape;
mod tally;
mod verdict;

pub use compare::Closeness;
pub use read::Misread;
pub use shape::Shape;
pub use tally::{Case, Outcome, Spread, Tally, by_corpus, tallies};
pub use verdict::{Comparisons, Line, Mark, Reference, Verdict};
