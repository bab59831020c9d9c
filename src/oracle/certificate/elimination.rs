//! The circlepoints of four conditions as what two curves have in common.
//!
//! A condition is linear in the center, A X + B Y + C = 0 with A, B, C linear in the circlepoint. Three of
//! them have a center in common on a cubic, det(A, B, C) = 0. The cubics of the conditions 1, 2, 3 and
//! 1, 2, 4 meet in nine points: the two circular ones, the three where the conditions 1 and 2 are one, and
//! the four that are sought. Those three are where A₁B₂ = A₂B₁ meets A₁C₂ = A₂C₁, but for A₁ = A₂ = 0.

use super::conditions::Form;
use crate::number::univariate::Polynomial;
use crate::number::{Exact, Number};

type Poly = Polynomial<Exact>;
/// A, B and C on a line.
pub type Row = [Poly; 3];

/// The polynomial of the values ax + by of the finite circlepoints, whether their centers are finite or
/// not. `None` where the curves have a part in common, where the conditions 1 and 2 are one for a point at
/// infinity, and where the line ax + by = 0 points towards a point at infinity of one of the curves.
pub fn circlepoints(forms: &[Form<Exact>; 4], direction: [i64; 2]) -> Option<Poly> {
    // Two of the nine meets are at infinity, and none of the four.
    let meets = resultant(8, forms, direction, |[p, q, r, s]| {
        let cubics = [determinant(p, q, r), determinant(p, q, s)];
        of_degree(3, cubics)
    })?;
    let besides = resultant(5, forms, direction, |[p, q, ..]| {
        let quadrics = [minor(p, q, 0, 1), minor(p, q, 0, 2)];
        of_degree(2, quadrics)
    })?;
    let alone = Polynomial::linear(&without_x(forms, direction)?);
    let (besides, rest) = besides.divide(&alone)?;
    if !rest.is_zero() || besides.degree() != Some(3) {
        return None;
    }
    let (sought, rest) = meets.divide(&besides)?;
    (rest.is_zero()).then(|| sought.primitive_part())?
}

/// The resultant of two curves along the lines ax + by = u, from so many values of u.
fn resultant(
    values: i64,
    forms: &[Form<Exact>; 4],
    direction: [i64; 2],
    curves: impl Fn(&[Row; 4]) -> Option<[Poly; 2]>,
) -> Option<Poly> {
    let value = |u: i64| {
        let rows = forms.each_ref().map(|form| on_line(form, direction, u));
        let [first, second] = curves(&rows)?;
        Some((Number::from(u), first.resultant(&second)))
    };
    let values: Option<Vec<(Number<Exact>, Number<Exact>)>> = (0..values).map(value).collect();
    let found = Polynomial::interpolated(&values?);
    (!found.is_zero()).then_some(found)
}

/// On the points u (a, b)/(a² + b²) + v (−b, a).
fn on_line(form: &Form<Exact>, [a, b]: [i64; 2], u: i64) -> Row {
    let size = Number::from(a * a + b * b);
    let foot = [a, b].map(|part| Number::from(u * part) / &size);
    row(form, &foot, [-b, a])
}

/// A, B and C on a line, by the powers of the way from a point of it along a direction.
pub fn row(form: &Form<Exact>, [x, y]: &[Number<Exact>; 2], [dx, dy]: [i64; 2]) -> Row {
    form.by_center().map(|[one, by_x, by_y]| {
        let constant = one + &by_x * x + &by_y * y;
        Polynomial::new(vec![constant, by_x * dx + by_y * dy])
    })
}

#[expect(
    clippy::indexing_slicing,
    reason = "a condition has three coefficients"
)]
fn minor(p: &Row, q: &Row, i: usize, j: usize) -> Poly {
    &p[i] * &q[j] - &p[j] * &q[i]
}

/// Vanishes where three conditions have a center in common.
pub fn determinant(p: &Row, q: &Row, r: &Row) -> Poly {
    let [a, b, c] = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| minor(p, q, i, j));
    a * &r[0] + b * &r[1] + c * &r[2]
}

fn of_degree(degree: usize, curves: [Poly; 2]) -> Option<[Poly; 2]> {
    let fits = curves.iter().all(|curve| curve.degree() == Some(degree));
    fits.then_some(curves)
}

/// ax + by in the point A₁ = A₂ = 0.
fn without_x(forms: &[Form<Exact>; 4], direction: [i64; 2]) -> Option<Number<Exact>> {
    let [[p, a, b], [q, c, d]] = {
        let [first, second, ..] = forms;
        [first, second].map(|form| {
            let [by_x, ..] = form.by_center();
            by_x
        })
    };
    let area = &a * &d - &b * &c;
    if !area.is_zero().is_no() {
        return None;
    }
    let (x, y) = ((&b * &q - &d * &p) / &area, (c * p - a * q) / area);
    Some(x * direction[0] + y * direction[1])
}
