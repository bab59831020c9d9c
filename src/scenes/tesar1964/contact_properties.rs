//! Chapter II: what is said of the points on the inflection circle and on the cubic of stationary
//! curvature.

use crate::curvature::canonical::Invariants;
use crate::curvature::contact::Guide;
use crate::curvature::motion::{Motion, Path, coefficient, derivative};
use crate::curvature::osculation::{center_of_curvature, inflection_circle, stationary_cubic};
use crate::number::poly::Fraction;
use crate::number::{Exact, Kind, Number, Truth};
use crate::plane::Point;
use crate::scenes::check::{Basis, Check, Exception, Report};
use crate::scenes::free::{Symbols, point};
use crate::scenes::{Free, Unbuilt};

pub const INFLECTIONS: Check = Check {
    name: "points-of-the-inflection-circle",
    summary: "For any motion and the point of its inflection circle on any ray: the center of curvature is at \
              infinity, the path has contact of order two with its tangent, the direction of the \
              tangent is stationary, and the term of order three does not vanish, so that the path \
              crosses its tangent. At Ball's point, in one motion, that term vanishes and the next does not. The \
              wrong variant takes the point at twice the distance.",
    run: run_inflections,
};

pub const STATIONARY: Check = Check {
    name: "points-of-the-stationary-cubic",
    summary: "For any motion and the point of the cubic of stationary curvature on any ray, from the \
              determinant of the paths' terms up to order three: the path has contact of order three with the \
              circle of curvature, whose center and radius are stationary. The wrong variant takes the point \
              at twice the distance.",
    run: run_stationary,
};

/// A motion with free invariants and a free ray.
fn motion_and_ray() -> Result<(Motion<Fraction>, Point<Fraction>), Unbuilt> {
    let mut free = Symbols::default();
    let invariants = Invariants {
        third: point(&mut free, "the third shift")?,
        fourth: Number::zero(),
    };
    Ok((invariants.motion(), free.angle("alpha")?.cis()))
}

fn run_inflections() -> Result<Report, Unbuilt> {
    let (motion, ray) = motion_and_ray()?;
    let circle = inflection_circle(&motion);
    let r = -(&circle.b * ray.re() + &circle.c * ray.im()) / &circle.a;
    let point = ray.scaled(&r);
    let crosses = terms_across(&motion, &point)[2].is_zero().is_no();
    let ball = exceptional_point()?;
    Ok(Report {
        holds: has_inflection(&motion, &point) & Truth::from(crosses) & ball,
        wrong_variant: has_inflection(&motion, &(point * 2)),
        basis: Basis::Identity,
        instances: 0,
        exception: Some(Exception {
            condition: "the point is neither the pole nor Ball's point",
            counterexample: "Ball's point: its path has contact of order three with the tangent, does not \
                             cross it, and has no inflection there",
        }),
    })
}

/// The terms in θ, θ², θ³, θ⁴ across the direction in which a point starts.
fn terms_across<K: Kind>(motion: &Motion<K>, point: &Point<K>) -> [Number<K>; 4] {
    let path = motion.path_of(point);
    let normal = Number::i() * coefficient(&path, 1);
    let kept = Guide::Line {
        point: point.clone(),
        normal,
    }
    .along(motion);
    [1, 2, 3, 4].map(|j| kept.coefficient(j))
}

fn has_inflection<K: Kind>(motion: &Motion<K>, point: &Point<K>) -> Truth {
    let path = motion.path_of(point);
    let [first, second, ..] = terms_across(motion, point).map(|term| term.is_zero());
    let tangent = derivative(&path);
    let turn = (tangent.conj() * derivative(&tangent)).im().coefficient(0);
    center_of_curvature(&path).coordinates()[2].is_zero() & first & second & turn.is_zero()
}

/// That Ball's point of one motion has contact of order three and no more.
fn exceptional_point() -> Result<Truth, Unbuilt> {
    let at = |x: i64, y: i64| Point::<Exact>::complex(x.into(), y.into());
    let invariants = Invariants {
        third: at(2, 5),
        fourth: at(-3, 7),
    };
    let point = invariants
        .ball_point()
        .finite()
        .ok_or_else(|| Unbuilt::Contradiction("Ball's point is finite".to_owned()))?;
    let [_, second, third, fourth] = terms_across(&invariants.motion(), &point);
    Ok(Truth::all([
        second.is_zero(),
        third.is_zero(),
        !fourth.is_zero(),
    ]))
}

fn run_stationary() -> Result<Report, Unbuilt> {
    let (motion, ray) = motion_and_ray()?;
    let cubic = stationary_cubic(&motion)
        .ok_or_else(|| Unbuilt::NotHeld("the cubic of stationary curvature".to_owned()))?;
    // On a ray through its node the cubic has one more point; it is linear in 1/r.
    let [one, two] = [1, 2].map(|r| cubic.at(&(&ray * r)) / (r * r));
    let r = (2 * &one - &two) / (one - two);
    let point = ray.scaled(&r);
    Ok(Report {
        holds: is_stationary(&motion, &point),
        wrong_variant: is_stationary(&motion, &(point * 2)),
        basis: Basis::Identity,
        instances: 0,
        exception: None,
    })
}

/// Whether the circle of curvature is the same for two infinitesimally separated positions.
fn is_stationary<K: Kind>(motion: &Motion<K>, point: &Point<K>) -> Truth {
    let path = motion.path_of(point);
    let [x, y, w] = center_of_curvature(&path).coordinates().clone();
    let center = Number::complex(x / &w, y / w);
    let guide = Guide::Circle {
        point: point.clone(),
        center,
    };
    let kept = guide.along(motion);
    let contact = Truth::all((1..=3).map(|j| kept.coefficient(j).is_zero()));
    let evolute = evolute(&path);
    let radius = (&path - &evolute).norm();
    contact & coefficient(&evolute, 1).is_zero() & radius.coefficient(1).is_zero()
}

/// The centers of curvature, one after the other: p + ip'|p'|²/Im(p̄'p'').
fn evolute<K: Kind>(path: &Path<K>) -> Path<K> {
    let first = derivative(path);
    let second = derivative(&first);
    let bend = (first.conj() * second).im().clone();
    let scale = first.norm() / bend;
    path + Path::<K>::i() * first.scaled(&scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_hold_and_the_wrong_variants_are_rejected() {
        for run in [run_inflections, run_stationary] {
            let report = run().unwrap();
            assert_eq!(
                (report.holds, report.wrong_variant),
                (Truth::Yes, Truth::No)
            );
        }
    }
}
