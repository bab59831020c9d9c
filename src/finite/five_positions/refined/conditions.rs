//! The conditions of five rational positions by integers.

use rug::{Assign, Integer};

use crate::number::exact::divide_by_content;
use crate::number::linear::{Eliminated, integer_elimination};
use crate::number::{Exact, Number, count};
use crate::plane::displacement::Displacement;

/// Coefficients of X, Y, p, q, h, x, y.
pub type Row = [Integer; 7];

/// The rows of [`rows`](super::super::conditions::rows), each times some number, by integers alone: in
/// rationals they take as long as all the rest.
pub fn rows(positions: &[Displacement<Exact>; 5]) -> Option<[Row; 4]> {
    let [first, rest @ ..] = positions;
    let base = row(first)?;
    let rows = rest
        .iter()
        .map(|position| Some(difference(row(position)?, &base)));
    rows.collect::<Option<Vec<_>>>()?.try_into().ok()
}

/// The row of one position times 2n m², with r = (c + is)/n and t = (a + ib)/m.
struct Scaled {
    row: Row,
    times: Integer,
}

fn row(position: &Displacement<Exact>) -> Option<Scaled> {
    let (r, t) = (&position.rotation, &position.translation);
    let ([c, s], n) = over_one_denominator([r.re(), r.im()])?;
    let ([a, b], m) = over_one_denominator([t.re(), t.im()])?;
    let double = Integer::from(&m << 1);
    let square = Integer::from(&double * &m);
    let mixed = Integer::from(&double * &n);
    let h = (Integer::from(a.square_ref()) + Integer::from(b.square_ref())) * &n;
    let x = (Integer::from(&a * &c) + Integer::from(&b * &s)) * &double;
    let y = (Integer::from(&b * &c) - Integer::from(&a * &s)) * &double;
    let [cx, cy, p] = [-a * &mixed, -b * mixed, -c * &square];
    let q = s * &square;
    Some(Scaled {
        row: [cx, cy, p, q, h, x, y],
        times: square * n,
    })
}

/// Numerators over the least common denominator.
fn over_one_denominator([x, y]: [&Number<Exact>; 2]) -> Option<([Integer; 2], Integer)> {
    let (x, y) = (x.0.rational()?, y.0.rational()?);
    if x.denom() == y.denom() {
        let numerators = [x, y].map(|q| q.numer().clone());
        return Some((numerators, x.denom().clone()));
    }
    let common = Integer::from(x.denom().lcm_ref(y.denom()));
    let numerators = [x, y].map(|q| {
        let mut times = Integer::from(common.div_exact_ref(q.denom()));
        times *= q.numer();
        times
    });
    Some((numerators, common))
}

fn difference(Scaled { mut row, times }: Scaled, base: &Scaled) -> Row {
    let common = Integer::from(times.gcd_ref(&base.times));
    let [own, other] = [&base.times, &times].map(|x| Integer::from(x.div_exact_ref(&common)));
    for (entry, base) in row.iter_mut().zip(&base.row) {
        *entry *= &own;
        *entry -= base * &other;
    }
    divide_by_content(&mut row);
    row
}

/// With room for minors of all rows.
fn roomy(row: &Row) -> Vec<Integer> {
    let longest = row.iter().map(Integer::significant_bits).max();
    let room = count::from_u32(longest.unwrap_or(0)).saturating_mul(5);
    let roomy = row.iter().map(|entry| {
        let mut copy = Integer::with_capacity(room);
        copy.assign(entry);
        copy
    });
    roomy.collect()
}

/// The solutions: determinant·(X, Y, p, q) as linear forms in h, x, y.
pub struct Forms {
    /// Other than 0.
    pub determinant: Integer,
    /// Of each its coefficients.
    pub forms: [[Integer; 3]; 4],
}

impl Forms {
    /// `None` where X, Y, p, q do not follow from the others.
    pub fn new(rows: &[Row; 4]) -> Option<Self> {
        let Eliminated {
            rows,
            pivots,
            determinant,
        } = integer_elimination(rows.each_ref().map(roomy).into(), 7);
        if pivots != [0, 1, 2, 3] {
            return None;
        }
        let coefficients = rows.into_iter().flat_map(|row| row.into_iter().skip(4));
        let mut numbers: Vec<Integer> = coefficients.map(|c| -c).chain([determinant]).collect();
        // Most of the determinant, for rotations are by a sum of two squares each.
        divide_by_content(&mut numbers);
        let determinant = numbers.pop()?;
        let mut numbers = numbers.into_iter();
        let mut form = || Some([numbers.next()?, numbers.next()?, numbers.next()?]);
        Some(Forms {
            determinant,
            forms: [form()?, form()?, form()?, form()?],
        })
    }

    /// In about so many bits, and how many were left out: near them only. `None` where they have no more.
    pub fn rounded(&self, bits: u32) -> Option<(Self, u32)> {
        let longer = self.determinant.significant_bits().checked_sub(bits)?;
        let short = |x: &Integer| Integer::from(x >> longer);
        let forms = Forms {
            determinant: short(&self.determinant),
            forms: self.forms.each_ref().map(|form| form.each_ref().map(short)),
        };
        (longer > 0).then_some((forms, longer))
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::conditions;
    use super::*;
    use crate::plane::Angle;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = Number<Exact>> {
        (-30_i64..30, 1_i64..20).prop_map(|(p, q)| Number::ratio(p, q))
    }

    fn position() -> impl Strategy<Value = Displacement<Exact>> {
        (number(), number(), number()).prop_map(|(half, x, y)| Displacement {
            rotation: Angle::from_tan_half(&half).cis(),
            translation: Number::complex(x, y),
        })
    }

    proptest! {
        #[test]
        fn rows_are_those_of_the_conditions(positions in prop::array::uniform5(position())) {
            let own = rows(&positions).unwrap();
            for (own, row) in own.iter().zip(conditions::rows(&positions)) {
                let own = own.each_ref().map(|x| Number::<Exact>::from(rug::Rational::from(x)));
                let [cx, cy, p, q, h, x, y] = own;
                let own = [h, x, y, cx, cy, p, q];
                for (i, a) in own.iter().enumerate() {
                    for (j, b) in own.iter().enumerate() {
                        prop_assert!((a * &row[j] - b * &row[i]).is_zero().is_yes());
                    }
                }
                let same_zeros = own.iter().all(|x| x.is_zero().is_yes())
                    == row.iter().all(|x| x.is_zero().is_yes());
                prop_assert!(same_zeros);
            }
        }
    }
}
