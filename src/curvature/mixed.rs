//! Positions of which some are infinitely near each other.
//!
//! Each group is a motion about one position, known to terms in tⁿ: n + 1 positions that have come
//! together. A point whose squared distance from its center has one value in all groups, and in each
//! does not change with t up to tⁿ, is a circlepoint of them all. So the conditions of five positions
//! stay four, whether they are apart (P-P-P-P-P), some together (PP-P-P-P, PPP-PP, …), or all (PPPPP).

use super::motion::Motion;
use crate::finite::five_positions::conditions;
use crate::finite::five_positions::conics::{Pairs, pairs_of};
use crate::finite::five_positions::krawczyk::{Conditions, Enclosed, Matrix, Vector, gradient};
use crate::number::{Ball, Exact, Interval, Kind, Number, Series};
use crate::plane::displacement::Displacement;

/// Motions about positions that are apart.
#[derive(Clone, Debug)]
pub struct Groups<K>(pub Vec<Motion<K>>);

impl<K: Kind> Groups<K> {
    /// How many positions come together in each.
    pub fn sizes(&self) -> Vec<usize> {
        self.0.iter().map(size).collect()
    }

    /// One position of each.
    pub fn positions(&self) -> Vec<Displacement<K>> {
        let first = |x: &Number<Series<K>>| x.coefficient(0);
        self.0.iter().map(|motion| motion.map(first)).collect()
    }

    /// Rows of coefficients of the coordinates of a pair: one fewer than there are positions.
    pub fn conditions(&self) -> Vec<Vec<Number<K>>> {
        let positions = self.positions();
        let Some(first) = positions.first() else {
            return Vec::new();
        };
        let first: Motion<K> = first.map(|x| x.clone().into());
        let motions = std::iter::once(first).chain(self.0.iter().cloned());
        let rows = conditions::rows(&motions.collect::<Vec<_>>());
        let of_group = |(place, row): (usize, &Vec<Number<Series<K>>>)| -> Vec<Vec<Number<K>>> {
            // In the first position of all the difference to itself says nothing.
            let terms = usize::from(place == 0)..self.0.get(place).map_or(0, size);
            let term = |j: usize| row.iter().map(|entry| entry.coefficient(j)).collect();
            terms.map(term).collect()
        };
        rows.iter().enumerate().flat_map(of_group).collect()
    }
}

/// The pairs of five positions in groups.
pub fn pairs(groups: &Groups<Exact>) -> Option<Pairs> {
    pairs_of(&groups.conditions())
}

fn size<K: Kind>(motion: &Motion<K>) -> usize {
    motion.translation.re().order().map_or(1, |order| order + 1)
}

/// The coefficients of |D(t)z − M|², without the radius.
impl<K: Kind> Conditions<K> for Groups<K> {
    fn values(&self, [x, y, u, v]: &Vector<K>) -> Vector<K> {
        let [z, m] = [[x, y], [u, v]]
            .map(|[x, y]| Number::complex(Number::<Series<K>>::from(x.clone()), y.clone().into()));
        let squares = self.0.iter().map(|motion| [(motion.of(&z) - &m).norm()]);
        let [values] = terms(self, squares);
        values
    }

    fn derivative(&self, [x, y, u, v]: &Vector<K>) -> Matrix<K> {
        let [z, m] = [[x, y], [u, v]]
            .map(|[x, y]| Number::complex(Number::<Series<K>>::from(x.clone()), y.clone().into()));
        let gradients = self.0.iter().map(|motion| gradient(motion, &z, &m));
        let columns = terms(self, gradients);
        #[expect(clippy::indexing_slicing, reason = "four rows of four columns")]
        std::array::from_fn(|row| std::array::from_fn(|column| columns[column][row].clone()))
    }
}

impl Enclosed for Groups<Ball> {
    type Floats = Groups<Interval>;

    fn in_floats(&self) -> Self::Floats {
        let float = |x: &Number<Series<Ball>>| x.map(|a| a.into());
        Groups(self.0.iter().map(|motion| motion.map(float)).collect())
    }

    fn rounded(&self, bits: u32) -> Self {
        let short = |x: &Number<Series<Ball>>| x.map(|a| Number(a.0.with_precision(bits)));
        Groups(self.0.iter().map(|motion| motion.map(short)).collect())
    }
}

/// Of several series for each group, the four terms that must vanish.
fn terms<K: Kind, const N: usize>(
    groups: &Groups<K>,
    series: impl Iterator<Item = [Number<Series<K>>; N]>,
) -> [Vector<K>; N] {
    let mut rows: [Vec<Number<K>>; N] = std::array::from_fn(|_| Vec::new());
    for (motion, series) in groups.0.iter().zip(series) {
        for (row, series) in rows.iter_mut().zip(&series) {
            row.extend((0..size(motion)).map(|j| series.coefficient(j)));
        }
    }
    let starts = groups.sizes().into_iter().scan(0, |next, size| {
        let start = *next;
        *next += size;
        Some(start)
    });
    let starts: Vec<usize> = starts.collect();
    rows.map(|row| {
        std::array::from_fn(|j| {
            let value = row.get(j + 1).cloned().unwrap_or_else(Number::zero);
            match row.first() {
                Some(radius) if starts.contains(&(j + 1)) => value - radius,
                _ => value,
            }
        })
    })
}
