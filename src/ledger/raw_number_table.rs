//! Reading a `[[number_table]]` of the data: numbers that one scene gives, in rows and columns.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::paper::RawStatement;
use super::{Cause, Kind, Verdict};

/// A table as it stands in the data: a row gives parameters, a column says what is printed.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawNumberTable {
    pub id: String,
    locus: String,
    example: String,
    columns: Vec<RawColumn>,
    rows: Vec<RawRow>,
    /// The verdict on all cells but those under `other`.
    expected: Verdict,
    #[serde(default)]
    other: Vec<RawOther>,
    note: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawColumn {
    column: String,
    quantity: String,
    certified: Option<String>,
    convention: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawRow {
    row: String,
    given: BTreeMap<String, String>,
    printed: Vec<String>,
}

/// Cells with a verdict of their own, as row and column.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawOther {
    cells: Vec<String>,
    expected: Verdict,
    cause: Option<Cause>,
    tried: Option<String>,
    note: Option<String>,
}

/// A cell as a statement, and what its row gives.
pub type Cell<'a> = (RawStatement, &'a BTreeMap<String, String>);

impl RawNumberTable {
    /// The cells by rows; or what is wrong.
    pub fn cells(&self) -> Result<Vec<Cell<'_>>, String> {
        let width = self.columns.len();
        if let Some(row) = self.rows.iter().find(|row| row.printed.len() != width) {
            return Err(format!(
                "the row `{}` has {} cells, but there are {width} columns",
                row.row,
                row.printed.len()
            ));
        }
        let cells: Vec<_> = self
            .rows
            .iter()
            .flat_map(|row| {
                let cells = self.columns.iter().zip(&row.printed);
                cells.map(move |(column, printed)| (row, column, printed))
            })
            .collect();
        let exists = |name: &&String| {
            cells
                .iter()
                .any(|(row, column, _)| **name == cell_name(row, column))
        };
        let mut named = self.other.iter().flat_map(|other| &other.cells);
        if let Some(unknown) = named.find(|name| !exists(name)) {
            return Err(format!("there is no cell `{unknown}`"));
        }
        let statement = |(row, column, printed): (&'_ RawRow, &RawColumn, &String)| {
            self.statement(row, column, printed)
        };
        Ok(cells
            .iter()
            .map(|&(row, column, printed)| (statement((row, column, printed)), &row.given))
            .collect())
    }

    fn statement(&self, row: &RawRow, column: &RawColumn, printed: &str) -> RawStatement {
        let name = cell_name(row, column);
        let other = self.other.iter().find(|other| other.cells.contains(&name));
        let of_cell = other.and_then(|other| other.note.as_deref());
        let notes: Vec<&str> = self.note.as_deref().into_iter().chain(of_cell).collect();
        RawStatement {
            id: format!("{}/{name}", self.id),
            locus: format!("{}, row {}, column {}", self.locus, row.row, column.column),
            kind: Kind::Number,
            scene: None,
            example: Some(self.example.clone()),
            quantity: Some(column.quantity.clone()),
            printed: Some(printed.to_owned()),
            verbatim: None,
            condition: None,
            outside: None,
            correct: None,
            explained_by: None,
            certified: column.certified.clone(),
            convention: column.convention.clone(),
            tried: other.and_then(|other| other.tried.clone()),
            cause: other.and_then(|other| other.cause),
            inherited_from: None,
            checks: Vec::new(),
            expected: other.map_or(self.expected, |other| other.expected),
            note: (!notes.is_empty()).then(|| notes.join(" ")),
        }
    }
}

fn cell_name(row: &RawRow, column: &RawColumn) -> String {
    format!("{}/{}", row.row, column.column)
}
