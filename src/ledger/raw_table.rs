//! Reading a `[[table]]` of the data.

use std::sync::Arc;

use serde::Deserialize;

use super::paper::listed;
use super::table::{PrintedRow, PrintedTable};
use super::{Cause, Content, Kind, Statement, Verdict};
use crate::scenes::{self, Scene};

/// A table as it stands in the data.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawTable {
    pub id: String,
    locus: String,
    pub scene: String,
    code: String,
    #[serde(default)]
    part: String,
    /// Whether the table as a whole is one statement.
    #[serde(default)]
    whole: bool,
    columns: Vec<String>,
    rows: Vec<RawRow>,
    #[serde(default)]
    wrong: Vec<RawWrong>,
    note: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawRow {
    row: String,
    /// As in the print, where that is longer than the name.
    label: Option<String>,
    printed: Vec<String>,
}

/// Cells that are wrong, as row and column.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawWrong {
    cells: Vec<String>,
    cause: Cause,
    note: Option<String>,
}

/// What a statement of the table does not share with the others.
struct Part<'a> {
    id: String,
    locus: String,
    kind: Kind,
    printed: String,
    content: Content,
    wrong: Option<&'a RawWrong>,
}

impl RawTable {
    /// One statement for each cell, by rows, or one for all of them; or what is wrong. `place` is the
    /// data file and the line.
    pub fn statements(
        &self,
        scene: &'static Scene,
        place: (&str, usize),
    ) -> Result<Vec<Statement>, String> {
        let table = Arc::new(self.printed()?);
        self.check_names(&table)?;
        let parts = if self.whole {
            vec![self.whole(&table)]
        } else {
            self.cells(&table)
        };
        let statement = |part| self.statement(part, scene, place);
        Ok(parts.into_iter().map(statement).collect())
    }

    fn printed(&self) -> Result<PrintedTable, String> {
        let code = scenes::find_table(&self.code).ok_or_else(|| {
            let known: Vec<&str> = scenes::tables().iter().map(|table| table.name).collect();
            let known = listed(&known);
            format!("unknown table `{}`; there are {known}", self.code)
        })?;
        let width = self.columns.len();
        if let Some(row) = self.rows.iter().find(|row| row.printed.len() != width) {
            return Err(format!(
                "the row `{}` has {} cells, but there are {width} columns",
                row.row,
                row.printed.len()
            ));
        }
        let rows = self.rows.iter().map(|row| PrintedRow {
            name: row.row.clone(),
            cells: row.printed.clone(),
        });
        Ok(PrintedTable {
            code,
            part: self.part.clone(),
            columns: self.columns.clone(),
            rows: rows.collect(),
        })
    }

    /// Every cell that is said to be wrong must exist.
    fn check_names(&self, table: &PrintedTable) -> Result<(), String> {
        let exists = |name: &str| {
            table
                .places()
                .any(|(row, column, _)| cell_name(row, column) == name)
        };
        match self
            .wrong
            .iter()
            .flat_map(|wrong| &wrong.cells)
            .find(|name| !exists(name))
        {
            Some(unknown) => Err(format!("there is no cell `{unknown}`")),
            None => Ok(()),
        }
    }

    fn whole<'a>(&'a self, table: &Arc<PrintedTable>) -> Part<'a> {
        Part {
            id: self.id.clone(),
            locus: self.locus.clone(),
            kind: Kind::Claim,
            printed: table.text(),
            content: Content::Table(table.clone()),
            wrong: self.wrong.first(),
        }
    }

    fn cells<'a>(&'a self, table: &Arc<PrintedTable>) -> Vec<Part<'a>> {
        let places = self.rows.iter().flat_map(|row| {
            let cells = self.columns.iter().zip(&row.printed);
            cells.map(move |(column, printed)| (row, column, printed))
        });
        let part = |(row, column, printed): (&RawRow, &String, &String)| {
            let name = cell_name(&row.row, column);
            let label = row.label.as_ref().unwrap_or(&row.row);
            let column_label = column.replace('/', ", ");
            Part {
                id: format!("{}/{name}", self.id),
                locus: format!("{}, row {label}, column {column_label}", self.locus),
                kind: Kind::TableCell,
                printed: printed.clone(),
                content: Content::Cell {
                    table: table.clone(),
                    row: row.row.clone(),
                    column: column.clone(),
                },
                wrong: self.wrong.iter().find(|wrong| wrong.cells.contains(&name)),
            }
        };
        places.map(part).collect()
    }

    fn statement(
        &self,
        part: Part<'_>,
        scene: &'static Scene,
        (file, line): (&str, usize),
    ) -> Statement {
        let of_cell = part.wrong.and_then(|wrong| wrong.note.as_deref());
        let notes: Vec<&str> = self.note.as_deref().into_iter().chain(of_cell).collect();
        Statement {
            file: file.to_owned(),
            line,
            id: part.id,
            locus: part.locus,
            kind: part.kind,
            scene,
            example: None,
            printed: part.printed,
            content: part.content,
            condition: None,
            correct: None,
            cause: part.wrong.map(|wrong| wrong.cause),
            inherited_from: None,
            checks: Vec::new(),
            expected: match part.wrong {
                Some(_) => Verdict::Fails,
                None => Verdict::Holds,
            },
            convention: None,
            tried: None,
            note: (!notes.is_empty()).then(|| notes.join(" ")),
        }
    }
}

fn cell_name(row: &str, column: &str) -> String {
    format!("{row}/{column}")
}
