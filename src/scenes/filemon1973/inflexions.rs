//! Asymptote and inflexions of a centerpoint curve without a double point.

use std::cmp::Ordering;

use super::quadrilateral::{PoleQuadrilateral, centerpoint_curve};
use super::sample::quadrilaterals;
use super::side_order::Sides;
use crate::number::{Exact, Truth};
use crate::plane::circular_cubic::Cubic;
use crate::plane::hessian::count_real;
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};

pub const CHECK: Check = Check {
    name: "asymptote-and-inflexions",
    summary: "Curves with U > Z and with U < Z, turned so that the middle line is parallel to the x-axis and \
              the focus in the origin. On the asymptote the terms of order 3 and 2 vanish and that of \
              order 1 does not, so that it meets the curve once; and the polynomial of degree nine whose \
              roots are the ordinates of the inflexions has three real ones. The wrong variant says that \
              there is one, as for a curve with a double point.",
    run,
};

/// Of either kind.
const INSTANCES: usize = 10;

fn run() -> Result<Report, Unbuilt> {
    let mut holds = Truth::Yes;
    let mut wrong_variant = Truth::Yes;
    let mut left = [INSTANCES; 2];
    for quadrilateral in quadrilaterals() {
        let quadrilateral = quadrilateral?;
        let sides = Sides::of(&quadrilateral)?;
        let [where_u_is_larger, where_z_is_larger] = &mut left;
        let left_of_kind = match sides.u.compare(&sides.z) {
            Some(Ordering::Greater) => where_u_is_larger,
            Some(Ordering::Less) => where_z_is_larger,
            _ => continue,
        };
        if *left_of_kind == 0 {
            continue;
        }
        *left_of_kind -= 1;
        let curve = turned(&quadrilateral)?;
        let inflexions = count_real(&curve);
        holds = holds & asymptote_meets_once(&curve) & Truth::from(inflexions == Some(3));
        wrong_variant = wrong_variant & Truth::from(inflexions == Some(1));
        if left == [0; 2] {
            break;
        }
    }
    Ok(Report {
        holds: holds & Truth::from(left == [0; 2]),
        wrong_variant,
        basis: Basis::Instances,
        instances: 2 * INSTANCES,
        exception: None,
    })
}

/// The curve with its focus in the origin and the middle line parallel to the x-axis.
fn turned(quadrilateral: &PoleQuadrilateral<Exact>) -> Result<Cubic<Exact>, Unbuilt> {
    let focus = quadrilateral.curve()?.singular_focus();
    let poles = quadrilateral.poles();
    let [o12, o23, o34, o14] = &poles;
    let back = (o12 + o34 - o14 - o23).conj();
    centerpoint_curve(&poles.each_ref().map(|pole| (pole - &focus) * &back))
}

/// With x² (b y + e) + x (c y² + f y + h) + … and a = 0 the asymptote is y = −e/b.
fn asymptote_meets_once(curve: &Cubic<Exact>) -> Truth {
    let [a, b, c, _, e, f, _, h, ..] = curve.coefficients();
    let y = -e / b;
    let linear = (c * &y + f) * y + h;
    a.is_zero() & !linear.is_zero()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Number;

    #[test]
    fn holds_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
    }

    /// (y + 1)(x² + y²) + 3y is symmetric about the y-axis.
    #[test]
    fn a_symmetric_curve_meets_its_asymptote_at_infinity_only() {
        let symmetric = [0, 1, 0, 1, 1, 0, 1, 0, 3, 0].map(Number::from);
        assert_eq!(asymptote_meets_once(&Cubic::new(symmetric)), Truth::No);
        let other = [0, 1, 0, 1, 1, 0, 1, 2, 3, 0].map(Number::from);
        assert_eq!(asymptote_meets_once(&Cubic::new(other)), Truth::Yes);
    }
}
