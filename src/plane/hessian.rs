//! The number of real inflexions of any cubic: where it meets its Hessian.

use super::circular_cubic::Cubic;
use crate::number::{Exact, Number, Polynomial};

/// Inflexions of a cubic without a double point, real and complex.
const INFLEXIONS: usize = 9;

/// How many real inflexions there are, all nine being finite and of different ordinates: then a real
/// ordinate is that of a real inflexion. `None` where they are not, as for a cubic with a double
/// point.
pub fn count_real(cubic: &Cubic<Exact>) -> Option<usize> {
    let ordinates = ordinates(cubic)?;
    let all = ordinates.degree()? == INFLEXIONS;
    let simple = ordinates.square_free_part()?.degree()? == INFLEXIONS;
    let count = ordinates.sturm_sequence()?.count();
    (all && simple).then_some(count)
}

/// The polynomial of degree 9 with the ordinates of the inflexions as roots, from its values at some
/// more ordinates than that.
fn ordinates(cubic: &Cubic<Exact>) -> Option<Polynomial<Exact>> {
    let forms = |y: i64| {
        let y = Number::from(y);
        [on_line(cubic, &y), hessian_on_line(cubic, &y)]
    };
    let degrees = |y: i64| forms(y).map(|form| form.degree());
    // Where a leading coefficient vanishes, the resultant would lack factors.
    let highest = (1..20).map(degrees).max()?;
    let points: Vec<(Number<Exact>, Number<Exact>)> = (1..40)
        .filter(|y| degrees(*y) == highest)
        .map(|y| {
            let [cubic, hessian] = forms(y);
            (Number::from(y), cubic.resultant(&hessian))
        })
        .take(INFLEXIONS + 2)
        .collect();
    Some(Polynomial::interpolated(&points))
}

/// The cubic on the line of this ordinate, as a polynomial in x.
fn on_line(cubic: &Cubic<Exact>, y: &Number<Exact>) -> Polynomial<Exact> {
    let [a, b, c, d, e, f, g, h, i, j] = cubic.coefficients();
    Polynomial::new(vec![
        ((d * y + g) * y + i) * y + j,
        (c * y + f) * y + h,
        b * y + e,
        a.clone(),
    ])
}

/// The determinant of the second derivatives of the form of order 3, on the line of this ordinate.
fn hessian_on_line(cubic: &Cubic<Exact>, y: &Number<Exact>) -> Polynomial<Exact> {
    let [a, b, c, d, e, f, g, h, i, j] = cubic.coefficients();
    let linear = |constant: Number<Exact>, x: Number<Exact>| Polynomial::new(vec![constant, x]);
    let xx = linear(2 * (b * y + e), 6 * a);
    let xy = linear(2 * c * y + f, 2 * b);
    let yy = linear(6 * d * y + 2 * g, 2 * c);
    let xw = linear(f * y + 2 * h, 2 * e);
    let yw = linear(2 * (g * y + i), f.clone());
    let ww = linear(2 * i * y + 6 * j, 2 * h);
    &xx * (&yy * &ww - &yw * &yw) - &xy * (&xy * &ww - &yw * &xw) + &xw * (&xy * &yw - &yy * &xw)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_without_a_double_point_has_three() {
        // (y + 1)(x² + y²) + 2x + b y, with one branch and with two.
        for b in [3, -3, 20, -20] {
            let coefficients = [0, 1, 0, 1, 1, 0, 1, 2, b, 0].map(Number::from);
            assert_eq!(count_real(&Cubic::new(coefficients)), Some(3), "{b}");
        }
    }

    #[test]
    fn others_are_not_counted() {
        // x³ + y³ = 3xy has a node, x³ + y³ = 1 inflexions at infinity.
        let folium = [1, 0, 0, 1, 0, -3, 0, 0, 0, 0].map(Number::from);
        assert_eq!(count_real(&Cubic::new(folium)), None);
        let fermat = [1, 0, 0, 1, 0, 0, 0, 0, 0, -1].map(Number::from);
        assert_eq!(count_real(&Cubic::new(fermat)), None);
    }

    #[test]
    fn the_hessian_is_the_determinant_of_second_derivatives() {
        let coefficients = [2, -3, 5, 7, -11, 13, -17, 19, 23, -29].map(Number::<Exact>::from);
        let cubic = Cubic::new(coefficients.clone());
        let form = |[x, y, w]: [i64; 3]| -> Number<Exact> {
            let powers = [
                [3, 0, 0],
                [2, 1, 0],
                [1, 2, 0],
                [0, 3, 0],
                [2, 0, 1],
                [1, 1, 1],
                [0, 2, 1],
                [1, 0, 2],
                [0, 1, 2],
                [0, 0, 3],
            ];
            let terms = coefficients.iter().zip(powers);
            terms.fold(Number::zero(), |sum, (c, [i, j, k])| {
                sum + c * Number::from(x.pow(i) * y.pow(j) * w.pow(k))
            })
        };
        for (x, y) in [(0, 0), (1, 2), (-3, 5), (4, -7)] {
            // A second difference of a cubic form around a point is its second derivative.
            let second = |u: usize, v: usize| {
                let moved = |s: i64, t: i64| {
                    let mut at = [x, y, 1];
                    at[u] += s;
                    at[v] += t;
                    form(at)
                };
                (moved(1, 1) - moved(1, -1) - moved(-1, 1) + moved(-1, -1)) / 4
            };
            let rows: Vec<Vec<Number<Exact>>> = (0..3)
                .map(|u| (0..3).map(|v| second(u, v)).collect())
                .collect();
            let expected = crate::number::linear::determinant(&rows);
            let found = hessian_on_line(&cubic, &y.into()).evaluate(&x.into());
            assert!(
                found.equals(&expected).is_yes(),
                "({x}, {y}): {found:?}, expected {expected:?}"
            );
        }
    }
}
