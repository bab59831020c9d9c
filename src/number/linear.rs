//! Systems of linear equations over any real kind.

use super::{Number, Real, Truth};

/// A basis of the solutions of homogeneous equations, each a row of coefficients. `None` where it
/// cannot be told which entries vanish.
pub fn kernel<K: Real>(rows: &[Vec<Number<K>>], unknowns: usize) -> Option<Vec<Vec<Number<K>>>> {
    let mut rows = rows.to_vec();
    let mut pivots: Vec<usize> = Vec::new();
    // Columns in any order: with enclosures the first entry that is surely not zero will do.
    while let Some((row, column)) = pivot(rows.get(pivots.len()..)?, unknowns, &pivots)? {
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

/// The first entry that is surely not zero; nothing where all are zero, `None` where that cannot be
/// told.
fn pivot<K: Real>(
    rows: &[Vec<Number<K>>],
    unknowns: usize,
    taken: &[usize],
) -> Option<Option<(usize, usize)>> {
    let mut all_zero = true;
    for (place, row) in rows.iter().enumerate() {
        for column in (0..unknowns).filter(|column| !taken.contains(column)) {
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
fn eliminate<K: Real>(rows: &mut [Vec<Number<K>>], place: usize, column: usize) -> Option<()> {
    let row = rows.get(place)?.clone();
    let inverse = row.get(column)?.inverse();
    let row: Vec<Number<K>> = row.iter().map(|entry| entry * &inverse).collect();
    for (other, entries) in rows.iter_mut().enumerate() {
        if other == place {
            entries.clone_from(&row);
            continue;
        }
        let factor = entries.get(column)?.clone();
        for (at, (entry, term)) in entries.iter_mut().zip(&row).enumerate() {
            *entry = if at == column {
                Number::zero()
            } else {
                &*entry - &factor * term
            };
        }
    }
    Some(())
}
