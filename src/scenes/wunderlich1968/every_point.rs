//! Every point of the focal curve gives a focal mechanism, but for five.

use crate::linkage::focal_mechanism;
use crate::number::poly::Fraction;
use crate::number::{Exact, Kind, Number, Truth};
use crate::plane::{Point, quadrilateral};
use crate::scenes::check::{Basis, Check, Exception, Report};
use crate::scenes::free::{Random, Symbols};
use crate::scenes::{Free, Unbuilt};

pub const CHECK: Check = Check {
    name: "every-point-of-the-focal-curve",
    summary: "F, M, A, N are free, B is what the curve leaves. P and Q divide the arms by the ratio \
              that similar triangles give, and the mechanism that is then built from M, P, F, Q and \
              the length QN alone has its joints in the given A, B, N. In M, N, A, B, and in the one \
              point where P and Q go to infinity, on 20 exact instances, there is none. The wrong \
              variant lets P and Q divide the arms from the other end.",
    run,
};

const INSTANCES: usize = 20;

fn run() -> Result<Report, Unbuilt> {
    let (corners, f) = free_point_of_the_curve()?;
    let share = focal_mechanism::share_of_arms(&corners, &f);
    let exceptions = exceptions()?;
    Ok(Report {
        holds: is_mechanism(&corners, &f, &share) & exceptions,
        wrong_variant: is_mechanism(&corners, &f, &(1 - &share)),
        basis: Basis::Identity,
        instances: INSTANCES,
        exception: Some(Exception {
            condition: "F is none of M, A, B, N and not the one point (if a ≠ b) for which P and Q \
                        are at infinity",
            counterexample: "F = A, where P = A = F and the bar PF has no length",
        }),
    })
}

/// F in the origin and M in 1: this only turns and scales the figure.
fn free_point_of_the_curve() -> Result<([Point<Fraction>; 4], Point<Fraction>), Unbuilt> {
    let mut free = Symbols::default();
    let mut point = |name: &str| -> Result<Point<Fraction>, Unbuilt> {
        Ok(Number::complex(
            free.number(&format!("x of {name}"))?,
            free.number(&format!("y of {name}"))?,
        ))
    };
    let (a, n) = (point("A")?, point("N")?);
    let b = (&a * &n).scaled(&free.number("share")?);
    Ok(([Number::one(), a, b, n], Number::zero()))
}

/// Whether the mechanism of these M, P, F, Q has the given corners.
fn is_mechanism<K: Kind>(corners: &[Point<K>; 4], f: &Point<K>, share: &Number<K>) -> Truth {
    let [m, a, b, n] = corners;
    let p = m + (a - m).scaled(share);
    let q = n + (b - n).scaled(share);
    let bars = -((f - &q) * (f - &p).conj() * (m - &p));
    let nu = (n - &q) / bars;
    let joints = focal_mechanism::joints(m, &p, f, &q, nu.re());
    let found = joints.corners.iter().zip(corners);
    nu.im().is_zero() & Truth::all(found.map(|(found, given)| found.equals(given)))
}

fn exceptions() -> Result<Truth, Unbuilt> {
    let mut free = Random::new(1893);
    let mut all = Truth::Yes;
    for _ in 0..INSTANCES {
        let mut point = || -> Result<Point<Exact>, Unbuilt> {
            Ok(Number::complex(free.number("x")?, free.number("y")?))
        };
        let corners = [point()?, point()?, point()?, point()?];
        all = all & has_the_exceptions(&corners);
    }
    Ok(all)
}

/// In the corners MP : MA is 0 or 1, so that a bar vanishes; in one more point it is infinite.
fn has_the_exceptions(corners: &[Point<Exact>; 4]) -> Truth {
    let [m, a, b, n] = corners;
    let curve = quadrilateral::focal_curve(corners);
    let in_corners = Truth::all(corners.iter().map(|f| {
        let share = focal_mechanism::share_of_arms(corners, f);
        let degenerate = share.is_zero() | share.equals(&Number::one());
        curve.at(f).is_zero() & degenerate
    }));
    // (F − M)(F − N)‾ = (F − A)(F − B)‾ is linear in F: with F measured from M,
    // F (B − N)‾ + (A − M) F‾ = (A − M)(B − M)‾.
    let (k, l) = ((b - n).conj(), a - m);
    let right = &l * (b - m).conj();
    let from_m = (k.conj() * &right - &l * right.conj()) / Point::from(k.norm() - l.norm());
    let f = m + from_m;
    let no_share = !Truth::from(focal_mechanism::share_of_arms(corners, &f).has_value());
    in_corners & curve.at(&f).is_zero() & no_share
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
