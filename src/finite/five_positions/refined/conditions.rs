//! The conditions of five rational positions by integers.

use rug::{Integer, Rational};

use crate::number::linear::{Eliminated, integer_elimination};
use crate::number::{Exact, Number};
use crate::plane::displacement::Displacement;

/// Coefficients of X, Y, p, q, h, x, y.
pub type Row = [Integer; 7];

/// The rows of [`rows`](super::super::conditions::rows), each times some integer.
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
    let part = |x: &Number<Exact>| x.0.rational().cloned();
    let (r, t) = (&position.rotation, &position.translation);
    let ([c, s], n) = over_one_denominator([part(r.re())?, part(r.im())?]);
    let ([a, b], m) = over_one_denominator([part(t.re())?, part(t.im())?]);
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
fn over_one_denominator([x, y]: [Rational; 2]) -> ([Integer; 2], Integer) {
    let [(x, of_x), (y, of_y)] = [x, y].map(Rational::into_numer_denom);
    if of_x == of_y {
        return ([x, y], of_x);
    }
    let common = Integer::from(of_x.lcm_ref(&of_y));
    let [to_x, to_y] = [of_x, of_y].map(|own| Integer::from(common.div_exact_ref(&own)));
    ([x * to_x, y * to_y], common)
}

fn difference(Scaled { mut row, times }: Scaled, base: &Scaled) -> Row {
    let common = Integer::from(times.gcd_ref(&base.times));
    let [own, other] = [&base.times, &times].map(|x| Integer::from(x.div_exact_ref(&common)));
    for (entry, base) in row.iter_mut().zip(&base.row) {
        *entry *= &own;
        *entry -= base * &other;
    }
    row
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
        let rows = rows.each_ref().map(|row| row.to_vec());
        let Eliminated {
            rows,
            pivots,
            determinant,
        } = integer_elimination(rows.to_vec(), 7);
        if pivots != [0, 1, 2, 3] {
            return None;
        }
        let form = |row: Vec<Integer>| -> Option<[Integer; 3]> {
            let [.., h, x, y] = <[Integer; 7]>::try_from(row).ok()?;
            Some([-h, -x, -y])
        };
        let forms = rows.into_iter().map(form).collect::<Option<Vec<_>>>()?;
        Some(Forms {
            determinant,
            forms: forms.try_into().ok()?,
        })
    }

    /// In about so many bits, and how many were left out: near them only.
    pub fn rounded(&self, bits: u32) -> (Self, u32) {
        let longer = self.determinant.significant_bits().saturating_sub(bits);
        let short = |x: &Integer| Integer::from(x >> longer);
        let forms = Forms {
            determinant: short(&self.determinant),
            forms: self.forms.each_ref().map(|form| form.each_ref().map(short)),
        };
        (forms, longer)
    }
}
