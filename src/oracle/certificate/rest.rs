//! What stays unchecked of an answer while all else of it is checked.

use super::Defect;

/// The first thing that could not be checked.
#[derive(Default)]
pub struct Rest(Option<Defect>);

impl Rest {
    /// Keeps what could not be checked for the end, and passes on what is wrong.
    pub fn after(&mut self, result: Result<(), Defect>) -> Result<(), Defect> {
        match result {
            Err(unchecked @ Defect::Unchecked { .. }) => {
                self.0.get_or_insert(unchecked);
                Ok(())
            }
            other => other,
        }
    }

    /// What is left when nothing was wrong.
    pub fn finish(self) -> Result<(), Defect> {
        self.0.map_or(Ok(()), Err)
    }
}
