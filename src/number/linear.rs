//! Systems of linear equations and determinants over any kind.

use std::collections::BTreeMap;

use rug::{Assign, Integer};

use super::exact::primitive_integers;
use super::{Kind, Number, Truth};

/// A basis of the solutions of homogeneous equations, each a row of coefficients. `None` where it
/// cannot be told which entries vanish.
pub fn kernel<K: Kind>(rows: &[Vec<Number<K>>], unknowns: usize) -> Option<Vec<Vec<Number<K>>>> {
    let order: Vec<usize> = (0..unknowns).collect();
    kernel_in_order(rows.to_vec(), &order)
}

/// The same, solved for the unknowns that come first in an order of them all.
pub fn kernel_in_order<K: Kind>(
    mut rows: Vec<Vec<Number<K>>>,
    order: &[usize],
) -> Option<Vec<Vec<Number<K>>>> {
    let unknowns = order.len();
    let mut pivots: Vec<usize> = Vec::new();
    // Columns in any order: with enclosures the first entry that is surely not zero will do.
    while let Some((row, column)) = pivot(rows.get(pivots.len()..)?, order, &pivots)? {
        let place = pivots.len();
        rows.swap(place, place + row);
        eliminate(&mut rows, place, column)?;
        pivots.push(column);
    }
    let free = (0..unknowns).filter(|column| !pivots.contains(column));
    let vector = |column: usize| {
        let mut vector = vec![Number::zero(); unknowns];
        *vector.get_mut(column)? = Number::one();
        for (row, pivot) in rows.iter().zip(&pivots) {
            let entry = row.get(column)?;
            *vector.get_mut(*pivot)? = -entry;
        }
        Some(vector)
    };
    free.map(vector).collect()
}

/// What is left of equations with integer coefficients by elimination.
pub struct Eliminated {
    /// Each with one pivot, the determinant, in a column where all others have zero.
    pub rows: Vec<Vec<Integer>>,
    /// The columns of the pivots, in the order of the rows.
    pub pivots: Vec<usize>,
    /// Of the rows in these columns.
    pub determinant: Integer,
}

/// Elimination without fractions (E. H. Bareiss 1968), with the first columns that will do.
pub fn integer_elimination(mut rows: Vec<Vec<Integer>>, unknowns: usize) -> Eliminated {
    let mut pivots: Vec<usize> = Vec::new();
    // Every entry is a minor of the rows; those of the pivots, all equal, are the last one of them.
    let mut last = Integer::from(1);
    let mut scratch = Integer::new();
    while let Some((place, column)) = first_entry(&rows, pivots.len(), unknowns) {
        rows.swap(pivots.len(), place);
        let Some(row) = rows.get_mut(pivots.len()).map(std::mem::take) else {
            break;
        };
        let pivot = row.get(column).cloned().unwrap_or_default();
        for (other, entries) in rows.iter_mut().enumerate() {
            if other != pivots.len() {
                clear_column(entries, column, (&row, &pivot), &last, &mut scratch);
            }
        }
        if let Some(place) = rows.get_mut(pivots.len()) {
            *place = row;
        }
        pivots.push(column);
        last = pivot;
    }
    Eliminated {
        rows,
        pivots,
        determinant: last,
    }
}

/// (pivot·entries − factor·row)/last, which has no remainder.
fn clear_column(
    entries: &mut [Integer],
    column: usize,
    (row, pivot): (&[Integer], &Integer),
    last: &Integer,
    scratch: &mut Integer,
) {
    let Some(factor) = entries.get_mut(column).map(std::mem::take) else {
        return;
    };
    for (place, (entry, term)) in entries.iter_mut().zip(row).enumerate() {
        // The factor itself has become zero.
        if place == column || entry.is_zero() && term.is_zero() {
            continue;
        }
        scratch.assign(&*entry * pivot);
        *scratch -= &factor * term;
        if *last != 1 {
            scratch.div_exact_mut(last);
        }
        std::mem::swap(entry, scratch);
    }
}

/// A basis of the solutions of homogeneous equations with integer coefficients, each of primitive
/// integers.
pub fn integer_kernel(rows: &[Vec<Integer>], unknowns: usize) -> Vec<Vec<Integer>> {
    let Eliminated {
        rows,
        pivots,
        determinant,
    } = integer_elimination(rows.to_vec(), unknowns);
    let free = (0..unknowns).filter(|column| !pivots.contains(column));
    let vector = |column: usize| {
        let mut vector = vec![Integer::new(); unknowns];
        if let Some(entry) = vector.get_mut(column) {
            entry.clone_from(&determinant);
        }
        for (row, pivot) in rows.iter().zip(&pivots) {
            if let (Some(entry), Some(target)) = (row.get(column), vector.get_mut(*pivot)) {
                *target = Integer::from(-entry);
            }
        }
        primitive_integers(vector)
    };
    free.map(vector).collect()
}

fn first_entry(rows: &[Vec<Integer>], from: usize, unknowns: usize) -> Option<(usize, usize)> {
    let columns = 0..unknowns;
    let mut places = columns.flat_map(|column| (from..rows.len()).map(move |row| (row, column)));
    places.find(|(row, column)| {
        let entry = rows.get(*row).and_then(|row| row.get(*column));
        entry.is_some_and(|entry| !entry.is_zero())
    })
}

/// The first entry that is surely not zero; nothing where all are zero, `None` where that cannot be
/// told.
fn pivot<K: Kind>(
    rows: &[Vec<Number<K>>],
    order: &[usize],
    taken: &[usize],
) -> Option<Option<(usize, usize)>> {
    let mut all_zero = true;
    for (place, row) in rows.iter().enumerate() {
        for &column in order.iter().filter(|column| !taken.contains(column)) {
            match row.get(column)?.is_zero() {
                Truth::No => return Some(Some((place, column))),
                Truth::Unknown => all_zero = false,
                Truth::Yes => {}
            }
        }
    }
    all_zero.then_some(None)
}

/// Makes the pivot one and the rest of its column zero.
fn eliminate<K: Kind>(rows: &mut [Vec<Number<K>>], place: usize, column: usize) -> Option<()> {
    let mut row = std::mem::take(rows.get_mut(place)?);
    let inverse = row.get(column)?.inverse();
    for entry in &mut row {
        // Zeros, as in the columns of earlier pivots, stay what they are.
        if !entry.is_zero().is_yes() {
            *entry *= &inverse;
        }
    }
    *row.get_mut(column)? = Number::one();
    for (other, entries) in rows.iter_mut().enumerate() {
        if other == place {
            continue;
        }
        let factor = std::mem::replace(entries.get_mut(column)?, Number::zero());
        if factor.is_zero().is_yes() {
            continue;
        }
        for (at, (entry, term)) in entries.iter_mut().zip(&row).enumerate() {
            if at != column && !term.is_zero().is_yes() {
                *entry -= &factor * term;
            }
        }
    }
    *rows.get_mut(place)? = row;
    Some(())
}

/// The solution of as many equations as unknowns, each a row of coefficients and the right side.
/// `None` where there is not exactly one, and where that cannot be told.
pub fn solution<K: Kind>(rows: &[Vec<Number<K>>]) -> Option<Vec<Number<K>>> {
    let unknowns = rows.len();
    let basis = kernel(rows, unknowns + 1)?;
    let [vector] = basis.as_slice() else {
        return None;
    };
    // The right side stands on the left with the factor −1.
    let (last, vector) = vector.split_last()?;
    (!last.is_zero().is_yes()).then(|| vector.iter().map(|x| -(x / last)).collect())
}

/// How many rows are independent; `None` where that cannot be told.
pub fn rank<K: Kind>(rows: &[Vec<Number<K>>], columns: usize) -> Option<usize> {
    Some(columns - kernel(rows, columns)?.len())
}

/// The determinant of a square of numbers.
///
/// Expansion by rows, in which every minor of the last rows is computed once: `minors` has, for every
/// set of as many columns as rows were taken, the minor of these.
pub fn determinant<K: Kind>(rows: &[impl AsRef<[Number<K>]>]) -> Number<K> {
    let mut minors: BTreeMap<u32, Number<K>> = BTreeMap::from([(0, Number::one())]);
    for row in rows.iter().rev() {
        let mut larger: BTreeMap<u32, Number<K>> = BTreeMap::new();
        for (columns, minor) in &minors {
            for (column, entry) in row.as_ref().iter().enumerate() {
                if columns >> column & 1 == 1 {
                    continue;
                }
                // The sign is that of the place of the new column among those taken.
                let before = (columns & ((1 << column) - 1)).count_ones();
                let term = entry * minor;
                let term = if before % 2 == 0 { term } else { -term };
                let sum = larger
                    .entry(columns | 1 << column)
                    .or_insert_with(Number::zero);
                *sum += term;
            }
        }
        minors = larger;
    }
    minors.into_values().next().unwrap_or_else(Number::one)
}

/// The determinant without a row and a column.
pub fn minor<K: Kind>(rows: &[Vec<Number<K>>], row: usize, column: usize) -> Number<K> {
    let without = |list: &Vec<Number<K>>| -> Vec<Number<K>> {
        let kept = list
            .iter()
            .enumerate()
            .filter(|(place, _)| *place != column);
        kept.map(|(_, entry)| entry.clone()).collect()
    };
    let kept = rows.iter().enumerate().filter(|(place, _)| *place != row);
    let rows: Vec<Vec<Number<K>>> = kept.map(|(_, list)| without(list)).collect();
    determinant(&rows)
}
