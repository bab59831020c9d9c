//! Printed tables whose cells code computes.

use std::collections::HashMap;
use std::rc::Rc;

use super::error::JudgeError;
use super::{Computed, Judgement, Proof, Verdict};
use crate::scenes;
use crate::scenes::table::{Cell, Cells};

/// A printed table, or a part of one.
#[derive(Clone, Debug)]
pub struct PrintedTable {
    /// What computes it.
    pub code: &'static scenes::Table,
    /// Which part of what the code computes; found from the text and the cells.
    pub part: String,
    /// The names of the columns.
    pub columns: Vec<String>,
    /// The rows from above.
    pub rows: Vec<PrintedRow>,
}

/// A row of a printed table.
#[derive(Clone, Debug)]
pub struct PrintedRow {
    /// Its name.
    pub name: String,
    /// What stands in its cells, `(blank)` for nothing.
    pub cells: Vec<String>,
}

impl PrintedTable {
    /// The rows as one text.
    pub fn text(&self) -> String {
        joined(
            self.rows
                .iter()
                .map(|row| (row.name.as_str(), row.cells.join(" "))),
        )
    }

    /// All places, as row and column, with what is printed there.
    pub fn places(&self) -> impl Iterator<Item = (&str, &str, &str)> {
        self.rows.iter().flat_map(move |row| {
            let cells = self.columns.iter().zip(&row.cells);
            cells.map(|(column, text)| (row.name.as_str(), column.as_str(), text.as_str()))
        })
    }

    fn computed_text(&self, cells: &Cells) -> Result<String, JudgeError> {
        let mut rows = Vec::new();
        for row in &self.rows {
            let mut texts = Vec::new();
            for column in &self.columns {
                let cell = self.cell(cells, &self.part, &row.name, column)?;
                texts.push(cell.text.as_str());
            }
            rows.push((row.name.as_str(), texts.join(" ")));
        }
        Ok(joined(rows.into_iter()))
    }

    fn cell<'a>(
        &self,
        cells: &'a Cells,
        part: &str,
        row: &str,
        column: &str,
    ) -> Result<&'a Cell, JudgeError> {
        cells
            .cell(part, row, column)
            .ok_or_else(|| JudgeError::NoCell {
                table: self.code.name,
                place: [part, row, column].join(", "),
            })
    }

    /// In how many places the print agrees with a part of what is computed.
    fn agreement(&self, cells: &Cells, part: &str) -> Result<usize, JudgeError> {
        let mut count = 0;
        for (row, column, printed) in self.places() {
            let cell = self.cell(cells, part, row, column)?;
            count += usize::from(cell.text == printed);
        }
        Ok(count)
    }

    /// How well the print fits its part and, if there are several, the next best.
    fn fit(&self, cells: &Cells) -> Result<String, JudgeError> {
        let own = self.agreement(cells, &self.part)?;
        let mut next = None;
        for part in cells.parts() {
            if part != self.part {
                next = next.max(Some(self.agreement(cells, part)?));
            }
        }
        let places = self.places().count();
        Ok(match next {
            Some(next) => format!(
                "{own} of the {places} printed cells are those of `{}`, of every other part at most {next}",
                self.part
            ),
            None => format!("{own} of the {places} printed cells are right"),
        })
    }
}

fn joined<'a>(rows: impl Iterator<Item = (&'a str, String)>) -> String {
    rows.map(|(name, cells)| format!("{name}: {cells}"))
        .collect::<Vec<_>>()
        .join("; ")
}

/// Computed tables, each once.
#[derive(Default)]
pub struct Tables {
    computed: HashMap<&'static str, Rc<Cells>>,
}

impl Tables {
    fn cells(&mut self, table: &'static scenes::Table) -> Result<Rc<Cells>, JudgeError> {
        if let Some(cells) = self.computed.get(table.name) {
            return Ok(cells.clone());
        }
        let cells = Rc::new((table.run)()?);
        self.computed.insert(table.name, cells.clone());
        Ok(cells)
    }

    /// Whether a cell is what is computed.
    pub fn judge_cell(
        &mut self,
        table: &PrintedTable,
        row: &str,
        column: &str,
        printed: &str,
    ) -> Result<Judgement, JudgeError> {
        let cells = self.cells(table.code)?;
        let cell = table.cell(&cells, &table.part, row, column)?;
        judged(table, &cells, printed, cell.text.clone(), cell.instances)
    }

    /// Whether all cells are what is computed.
    pub fn judge_whole(&mut self, table: &PrintedTable) -> Result<Judgement, JudgeError> {
        let cells = self.cells(table.code)?;
        let right = table.computed_text(&cells)?;
        judged(table, &cells, &table.text(), right, cells.instances)
    }
}

fn judged(
    table: &PrintedTable,
    cells: &Cells,
    printed: &str,
    right: String,
    instances: usize,
) -> Result<Judgement, JudgeError> {
    let holds = printed == right;
    let mut judgement = Judgement {
        computed: Some(Computed::Text(right.clone())),
        corrected: (!holds).then_some(right),
        instances: Some(instances),
        evidence: vec![format!("table {}", table.code.name), table.fit(cells)?],
        ..Judgement::bare(
            if holds {
                Verdict::Holds
            } else {
                Verdict::Fails
            },
            Proof::Instances,
        )
    };
    if !cells.wrong_variant.is_no() {
        judgement
            .findings
            .push(format!("the table {} cannot fail", table.code.name));
        judgement.verdict = Verdict::Unclear;
    }
    Ok(judgement)
}
