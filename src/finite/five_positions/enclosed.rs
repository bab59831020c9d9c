//! The Burmester pairs of positions that are known by enclosures only.

use super::chart::{Chart, Meets};
use super::conditions::{Coordinates, rows};
use crate::number::linear::kernel;
use crate::number::univariate::{Polynomial, isolate};
use crate::number::{Ball, Complex, Exact, Number};
use crate::plane::displacement::Displacement;

/// How many charts are tried.
const CHARTS: i64 = 8;

/// All four pairs, each by h, x, y, X, Y, p, q.
pub struct Enclosed {
    /// The real ones.
    pub real: Vec<[Number<Ball>; 7]>,
    /// One of each couple of conjugate ones.
    pub complex: Vec<[Number<Complex<Ball>>; 7]>,
}

/// The pairs of whatever positions lie in the enclosures; `None` where these are too wide to tell
/// four different pairs apart.
pub fn pairs(positions: &[Displacement<Ball>; 5], bits: u32) -> Option<Enclosed> {
    let basis = kernel(&rows(positions), 7)?;
    let basis: [Coordinates<Ball>; 3] = basis
        .into_iter()
        .map(|vector| vector.try_into().ok())
        .collect::<Option<Vec<_>>>()?
        .try_into()
        .ok()?;
    let charts = (0..CHARTS).filter_map(|seed| Chart::new(&basis, seed));
    charts
        .map(|chart| solved(&chart.meets(), bits))
        .find_map(|found| found)
}

fn solved(meets: &Meets<Ball>, bits: u32) -> Option<Enclosed> {
    let Meets {
        resultant,
        second,
        coordinates,
    } = meets;
    let rounded = |x: &Number<Ball>| Number(x.0.with_precision(bits));
    let quartic = resultant.map(rounded);
    if quartic.degree() != Some(4) || !quartic.leading()?.is_zero().is_no() {
        return None;
    }
    let middle: Option<Vec<Number<Exact>>> = quartic
        .coefficients()
        .iter()
        .map(|c| Some(Number::from(c.0.midpoint_rational()?)))
        .collect();
    let near = isolate(&Polynomial::new(middle?)).ok()?;
    let derivative = quartic.derivative();
    let mut enclosed = Enclosed {
        real: Vec::new(),
        complex: Vec::new(),
    };
    let mut found: Vec<Number<Complex<Ball>>> = Vec::new();
    for root in near.real() {
        let s = real_root(&quartic, &derivative, &root.enclosure(bits), bits)?;
        if !second.evaluate(&s).is_zero().is_no() {
            return None;
        }
        enclosed
            .real
            .push(coordinates.each_ref().map(|part| part.evaluate(&s)));
    }
    for root in near.complex() {
        let s = complex_root(&quartic, &derivative, &root.enclosure(bits), bits)?;
        if !second.evaluate_complex(&s).is_zero().is_no() {
            return None;
        }
        let point = coordinates.each_ref().map(|part| part.evaluate_complex(&s));
        enclosed.complex.push(point);
        found.push(s);
    }
    // As many boxes as roots, no two of which have a point in common, each with one root: all.
    let apart = (found.iter().enumerate()).all(|(place, a)| {
        let others = found.iter().skip(place + 1);
        others.into_iter().all(|b| a.equals(b).is_no())
    });
    (apart && enclosed.real.len() + 2 * enclosed.complex.len() == 4).then_some(enclosed)
}

/// Newton's interval test: an enclosure of the only root in it, for every polynomial in the enclosure.
fn real_root(
    quartic: &Polynomial<Ball>,
    derivative: &Polynomial<Ball>,
    near: &Number<Ball>,
    bits: u32,
) -> Option<Number<Ball>> {
    let middle = near.0.midpoint_rational()?;
    let at = Number::<Ball>::rounded(&middle, &bits);
    let step = quartic.evaluate(&at) / derivative.evaluate(&at);
    let reach = step.0.midpoint_rational()?.abs() + step.0.radius_rational()?;
    let least = (middle.clone().abs() + 1) >> bits;
    let around = Number(Ball::with_radius(&middle, &(reach * 4 + least * 4), bits));
    let image = &at - quartic.evaluate(&at) / derivative.evaluate(&around);
    is_inside(&image, &around)?.then_some(image)
}

fn complex_root(
    quartic: &Polynomial<Ball>,
    derivative: &Polynomial<Ball>,
    near: &Number<Complex<Ball>>,
    bits: u32,
) -> Option<Number<Complex<Ball>>> {
    let (x, y) = (
        near.re().0.midpoint_rational()?,
        near.im().0.midpoint_rational()?,
    );
    let at = Number::complex(
        Number::<Ball>::rounded(&x, &bits),
        Number::rounded(&y, &bits),
    );
    let step = quartic.evaluate_complex(&at) / derivative.evaluate_complex(&at);
    let size =
        |part: &Number<Ball>| Some(part.0.midpoint_rational()?.abs() + part.0.radius_rational()?);
    let reach = size(step.re())? + size(step.im())?;
    let least = (x.clone().abs() + y.clone().abs() + 1) >> bits;
    let radius = reach * 4 + least * 4;
    let around = Number::complex(
        Number(Ball::with_radius(&x, &radius, bits)),
        Number(Ball::with_radius(&y, &radius, bits)),
    );
    let image = &at - quartic.evaluate_complex(&at) / derivative.evaluate_complex(&around);
    // Off the real axis, so that it is no real root met twice.
    let inside = is_inside(image.re(), around.re())? && is_inside(image.im(), around.im())?;
    (inside && image.im().is_zero().is_no()).then_some(image)
}

fn is_inside(inner: &Number<Ball>, outer: &Number<Ball>) -> Option<bool> {
    Some(inner.0.lower()? > outer.0.lower()? && inner.0.upper()? < outer.0.upper()?)
}
