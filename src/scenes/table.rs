//! Tables: printed tables whose cells are no numbers, computed by named functions.

use super::Unbuilt;
use crate::number::Truth;

/// A cell of a computed table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Which of several tables of one form it belongs to.
    pub part: &'static str,
    /// The name of its row.
    pub row: &'static str,
    /// The name of its column.
    pub column: &'static str,
    /// What stands in it, in the signs of the print; `(blank)` for nothing.
    pub text: String,
    /// On how many exact instances that rests.
    pub instances: usize,
}

/// All cells, and what they rest on.
#[derive(Clone, Debug)]
pub struct Cells {
    /// Each place once.
    pub cells: Vec<Cell>,
    /// How many exact instances were tried for all of them.
    pub instances: usize,
    /// Whether a deliberately wrong variant has the same cells; the table says something only if
    /// this is [`Truth::No`].
    pub wrong_variant: Truth,
}

impl Cells {
    /// What stands in a place.
    pub fn cell(&self, part: &str, row: &str, column: &str) -> Option<&Cell> {
        self.cells
            .iter()
            .find(|cell| cell.part == part && cell.row == row && cell.column == column)
    }

    /// The names of the parts, in order.
    pub fn parts(&self) -> Vec<&'static str> {
        let mut parts: Vec<&'static str> = self.cells.iter().map(|cell| cell.part).collect();
        parts.dedup();
        parts
    }
}

/// A named table.
#[derive(Clone, Copy, Debug)]
pub struct Table {
    /// The name by which data refer to it.
    pub name: &'static str,
    /// What its cells say, and how they are computed.
    pub summary: &'static str,
    /// Computes it.
    pub run: fn() -> Result<Cells, Unbuilt>,
}
