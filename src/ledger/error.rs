//! Why a statement could not be judged.

use thiserror::Error;

use super::printed::NoDecimal;
use crate::formula::{Failure, ReadError};
use crate::scenes::Unbuilt;

/// Why a statement could not be judged: the data or the scene is wrong.
#[derive(Clone, Debug, Error)]
pub enum JudgeError {
    /// A formula names what the scene does not have, or mixes types.
    #[error("column {}: {}", .failure.span().start + 1, .failure)]
    Formula {
        /// What is wrong.
        failure: Failure,
    },
    /// A printed expression cannot be read.
    #[error("printed: {0}")]
    Reading(ReadError),
    /// A printed number cannot be read.
    #[error("printed: {0}")]
    NoDecimal(#[from] NoDecimal),
    /// The scene could not be built.
    #[error("scene: {0}")]
    Scene(#[from] Unbuilt),
    /// A table in the data has a cell that its code does not compute.
    #[error("the table `{table}` has no cell {place}")]
    NoCell {
        /// Its name.
        table: &'static str,
        /// Part, row and column.
        place: String,
    },
    /// A correction in the data does not hold itself.
    #[error("the correction `{text}` does not hold: {why}")]
    WrongCorrection {
        /// As in the data.
        text: String,
        /// What was found of it.
        why: String,
    },
    /// What the data say explains a print does not give it.
    #[error("`{text}` does not give the printed `{printed}`")]
    WrongExplanation {
        /// As in the data.
        text: String,
        /// As printed.
        printed: String,
    },
}

impl JudgeError {
    pub(super) fn formula(failure: Failure) -> Self {
        JudgeError::Formula { failure }
    }

    pub(super) fn reading(error: ReadError) -> Self {
        JudgeError::Reading(error)
    }
}
