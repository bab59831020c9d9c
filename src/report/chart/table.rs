//! The numbers of the chart at the points of its grid.

use std::collections::BTreeMap;

use crate::number::array;

/// Lengths are rounded to so much.
const LEAST: f64 = 1e-4;

/// What is drawn of a linkage.
pub struct Row {
    /// L
    pub length: f64,
    /// Twice the longest and the shortest link of the four-bar less all four, by its magnitude: zero in
    /// change points; negative where a link at the base turns fully.
    pub closure: f64,
    /// The longest to the shortest link, (M + N)/2 and M + N for the coupler point.
    pub ratio: f64,
}

/// All rows, by α_a and α_b.
pub struct Table {
    rows: BTreeMap<[u32; 2], Row>,
    /// Where there is no linkage.
    none: Vec<[u32; 2]>,
    /// Degrees between neighbours.
    pub step: u32,
}

/// Values at the points of a grid of degrees.
pub type Values = BTreeMap<[u32; 2], f64>;

impl Table {
    /// `None` where there are no rows.
    pub fn read(text: &str) -> Option<Self> {
        let mut rows = BTreeMap::new();
        let mut none = Vec::new();
        let mut degrees = Vec::new();
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let names: Vec<&str> = lines.next()?.split(',').collect();
        for line in lines {
            let cells: Vec<&str> = line.split(',').collect();
            let word = |name: &str| {
                let place = names.iter().position(|known| *known == name)?;
                cells.get(place).copied()
            };
            let cell = |name: &str| word(name)?.parse::<f64>().ok();
            let ray = |name: &str| word(name)?.parse::<u32>().ok();
            let rays = [ray("alpha_a")?, ray("alpha_b")?];
            degrees.push(rays[1]);
            let has_crank = word("crank").is_some_and(|crank| crank != "none");
            let read = || Some((cell("L")?, [cell("Q")?, cell("R")?, cell("S")?, cell("T")?]));
            match read() {
                Some((length, links)) => {
                    rows.insert(rays, Row::of(length, links, has_crank));
                }
                None => none.push(rays),
            }
        }
        degrees.sort_unstable();
        degrees.dedup();
        let step = array::neighbours(&degrees)
            .map(|(here, next)| next - here)
            .min()?;
        Some(Table { rows, none, step })
    }

    /// A value of each row.
    pub fn values(&self, of: impl Fn(&Row) -> Option<f64>) -> Values {
        let rows = self.rows.iter();
        rows.filter_map(|(rays, row)| Some((*rays, of(row)?)))
            .collect()
    }

    /// For each α_a the ranges of α_b in which all rows are chosen, or where there is no linkage.
    pub fn runs(&self, is_chosen: impl Fn(&Row) -> bool) -> BTreeMap<u32, Vec<[u32; 2]>> {
        let rows = self.rows.iter().filter(|(_, row)| is_chosen(row));
        let mut chosen: Vec<_> = rows.map(|(rays, _)| rays).chain(&self.none).collect();
        chosen.sort_unstable();
        let mut runs: BTreeMap<u32, Vec<[u32; 2]>> = BTreeMap::new();
        for [a, b] in chosen {
            let of_row = runs.entry(*a).or_default();
            match of_row.last_mut() {
                Some([_, to]) if *to + self.step == *b => *to = *b,
                _ => of_row.push([*b, *b]),
            }
        }
        runs
    }
}

impl Row {
    fn of(length: f64, links: [f64; 4], has_crank: bool) -> Self {
        let sum: f64 = links.iter().sum();
        let longest = links.into_iter().fold(0.0, f64::max);
        let shortest = links.into_iter().fold(f64::INFINITY, f64::min);
        // The unit is a fifth of Q + R + S + T + (M + N)/2.
        let half = 5.0 - sum;
        let closure = (2.0 * (longest + shortest) - sum).abs().max(LEAST);
        Row {
            length,
            closure: if has_crank { -closure } else { closure },
            ratio: longest.max(half) / shortest.min(2.0 * half),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "# made up\nalpha_a,alpha_b,L,crank,Q,R,S,T\n\
        0,10,,,,,,\n10,20,1.5,R,1,0.5,1,1\n10,30,1.25,none,1,1,1,1\n";

    #[test]
    fn rows_and_steps_are_read() {
        let table = Table::read(TABLE).unwrap();
        assert_eq!((table.step, table.rows.len()), (10, 2));
        let row = &table.rows[&[10, 20]];
        assert_eq!((row.length, row.closure, row.ratio), (1.5, -0.5, 3.0));
        assert_eq!(table.runs(|row| row.ratio < 4.0)[&10], [[20, 30]]);
        assert_eq!(table.runs(|_| false)[&0], [[10, 10]]);
        assert!(Table::read("").is_none());
    }
}
