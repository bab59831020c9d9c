//! Which given solution is which certified one: the assignment with the most matches, and among
//! these the one with the smallest errors in total.

/// What it costs to leave a row without a column that needs one.
const UNMATCHED: f64 = 1e6;
/// The same of a row that can do without: still more than any sum of errors, which are at most 1.
const SPARE: f64 = 1e3;
/// Of a column that cannot be this row's.
const FORBIDDEN: f64 = 1e12;

/// The column of each row, by whether it needs one and by the cost (0 to 1) of every possible match; the
/// Hungarian method.
#[expect(
    clippy::indexing_slicing,
    reason = "rows and columns of one rectangle of costs"
)]
pub fn assign(
    needed: &[bool],
    columns: usize,
    cost: impl Fn(usize, usize) -> Option<f64>,
) -> Vec<Option<usize>> {
    let rows = needed.len();
    // A column of its own for each row stands for no match.
    let width = columns + rows;
    let costs: Vec<Vec<f64>> = needed
        .iter()
        .enumerate()
        .map(|(row, needed)| {
            let unmatched = if *needed { UNMATCHED } else { SPARE };
            let real = (0..columns).map(|column| cost(row, column).unwrap_or(FORBIDDEN));
            let own = (0..rows).map(|other| if other == row { unmatched } else { FORBIDDEN });
            real.chain(own).collect()
        })
        .collect();
    let mut matching = Matching {
        costs,
        row_price: vec![0.0; rows],
        column_price: vec![0.0; width],
        row_of: vec![None; width],
    };
    for row in 0..rows {
        matching.add(row);
    }
    let mut column_of = vec![None; rows];
    for (column, row) in matching.row_of.iter().enumerate().take(columns) {
        if let Some(row) = *row
            && cost(row, column).is_some()
        {
            column_of[row] = Some(column);
        }
    }
    column_of
}

struct Matching {
    costs: Vec<Vec<f64>>,
    row_price: Vec<f64>,
    column_price: Vec<f64>,
    row_of: Vec<Option<usize>>,
}

impl Matching {
    /// Adds a row along the cheapest alternating path to a free column.
    #[expect(
        clippy::indexing_slicing,
        reason = "rows and columns of one rectangle of costs"
    )]
    fn add(&mut self, first: usize) {
        let width = self.column_price.len();
        let mut distance = vec![f64::INFINITY; width];
        let mut before: Vec<Option<usize>> = vec![None; width];
        let mut done = vec![false; width];
        let (mut row, mut reached, mut last) = (first, 0.0, None);
        let free = loop {
            let mut next: Option<usize> = None;
            for column in (0..width).filter(|&column| !done[column]) {
                let reduced =
                    self.costs[row][column] - self.row_price[row] - self.column_price[column];
                if reached + reduced < distance[column] {
                    distance[column] = reached + reduced;
                    before[column] = last;
                }
                if next.is_none_or(|next| distance[column] < distance[next]) {
                    next = Some(column);
                }
            }
            // Every row has a column of its own, so that there always is a next one.
            let Some(next) = next else { return };
            done[next] = true;
            reached = distance[next];
            last = Some(next);
            match self.row_of[next] {
                None => break next,
                Some(other) => row = other,
            }
        };
        for column in (0..width).filter(|&column| done[column]) {
            let gain = reached - distance[column];
            self.column_price[column] -= gain;
            if let Some(row) = self.row_of[column] {
                self.row_price[row] += gain;
            }
        }
        self.row_price[first] += reached;
        let mut column = free;
        while let Some(previous) = before[column] {
            self.row_of[column] = self.row_of[previous];
            column = previous;
        }
        self.row_of[column] = Some(first);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solved(costs: &[&[Option<f64>]]) -> Vec<Option<usize>> {
        let columns = costs.first().map_or(0, |row| row.len());
        assign(&vec![true; costs.len()], columns, |row, column| {
            costs[row][column]
        })
    }

    #[test]
    fn more_matches_go_before_smaller_errors() {
        let found = solved(&[&[Some(0.1), Some(0.9)], &[Some(0.0), None]]);
        assert_eq!(found, [Some(1), Some(0)]);
        let spare = assign(&[false, true], 1, |_, _| Some(0.5));
        assert_eq!(spare, [None, Some(0)]);
        assert_eq!(solved(&[&[None, None]]), [None]);
        assert_eq!(solved(&[]), []);
        assert_eq!(solved(&[&[], &[]]), [None, None]);
    }

    /// Against all permutations.
    #[test]
    fn no_assignment_is_better() {
        let mut state = 1964u64;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            f64::from(u32::try_from(state >> 40).unwrap()) / f64::from(1_u32 << 24)
        };
        for _ in 0..300 {
            let costs: Vec<Vec<Option<f64>>> = (0..4)
                .map(|_| {
                    (0..5)
                        .map(|_| Some(random()).filter(|_| random() < 0.6))
                        .collect()
                })
                .collect();
            let found = assign(&[true; 4], 5, |row, column| costs[row][column]);
            let value = |columns: &[Option<usize>]| -> f64 {
                let each = columns.iter().enumerate();
                each.map(|(row, column)| column.and_then(|c| costs[row][c]).unwrap_or(UNMATCHED))
                    .sum()
            };
            let mut best = f64::INFINITY;
            for code in 0..6usize.pow(4) {
                let columns: Vec<Option<usize>> = (0..4)
                    .map(|k| Some(code / 6usize.pow(k) % 6).filter(|&c| c < 5))
                    .collect();
                let once = (0..5).all(|c| columns.iter().filter(|&&d| d == Some(c)).count() <= 1);
                if once {
                    best = best.min(value(&columns));
                }
            }
            assert!((value(&found) - best).abs() < 1e-6, "{costs:?}: {found:?}");
        }
    }
}
