//! The focal curve is the locus of the foci of the inscribed conics.

use crate::number::poly::Fraction;
use crate::number::{Number, Truth, array};
use crate::plane::{Angle, Point, line, quadrilateral, relation};
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::Symbols;
use crate::scenes::{Free, Unbuilt};

pub const CHECK: Check = Check {
    name: "foci-of-the-inscribed-conics",
    summary: "The mirror images of a focus in the tangents of a conic lie on a circle about the other \
              focus. From a focus to the curve: four points on a circle give four tangents, whose \
              meets are M, A, B, N. From the curve to a focus: the mirror images of a point of the \
              curve in the four sides lie on a circle. The wrong variant takes the diagonals for \
              two of the sides.",
    run,
};

fn run() -> Result<Report, Unbuilt> {
    let images = images_of_a_point_of_the_curve()?;
    Ok(Report {
        holds: focus_is_on_the_curve()? & relation::concyclic(&images.in_sides),
        wrong_variant: relation::concyclic(&images.in_diagonals),
        basis: Basis::Identity,
        instances: 0,
        exception: None,
    })
}

/// Focus in the origin, the other in 1, any radius of the circle and any four points on it.
fn focus_is_on_the_curve() -> Result<Truth, Unbuilt> {
    let mut free = Symbols::default();
    let radius = free.length("radius")?;
    let mut image = |name: &str| -> Result<Point<Fraction>, Unbuilt> {
        let direction = Angle::from_tan_half(&free.number(name)?);
        Ok(direction.direction().scaled(&radius) + Number::one())
    };
    let images = [image("t1")?, image("t2")?, image("t3")?, image("t4")?];
    // The tangents are the perpendicular bisectors of the focus and its images.
    let corners = array::sides(&images).map(|(g, h)| circumcenter_with_origin(g, h));
    let curve = quadrilateral::focal_curve(&corners);
    Ok(curve.at(&Number::zero()).is_zero() & curve.at(&Number::one()).is_zero())
}

/// The center of the circle through the origin and two points.
fn circumcenter_with_origin(g: &Point<Fraction>, h: &Point<Fraction>) -> Point<Fraction> {
    (g * h * (g - h).conj()) / (g.conj() * h - g * h.conj())
}

struct Images {
    in_sides: [Point<Fraction>; 4],
    in_diagonals: [Point<Fraction>; 4],
}

/// F in the origin and M in 1; A and N are free, and B is what the curve leaves.
fn images_of_a_point_of_the_curve() -> Result<Images, Unbuilt> {
    let mut free = Symbols::default();
    let mut point = |name: &str| -> Result<Point<Fraction>, Unbuilt> {
        Ok(Number::complex(
            free.number(&format!("x of {name}"))?,
            free.number(&format!("y of {name}"))?,
        ))
    };
    let (a, n) = (point("A")?, point("N")?);
    let share = free.number("share")?;
    let (f, m): (Point<Fraction>, Point<Fraction>) = (Number::zero(), Number::one());
    let b = (&a * &n).scaled(&share);
    let image = |from: &Point<Fraction>, to: &Point<Fraction>| line::mirror(&f, from, to);
    Ok(Images {
        in_sides: [image(&m, &a), image(&a, &b), image(&b, &n), image(&n, &m)],
        in_diagonals: [image(&m, &b), image(&a, &b), image(&a, &n), image(&n, &m)],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
    }
}
