//! The construction of two centerpoints from an angle.

use crate::finite::equal_angles::{Meets, OppositeSides};
use crate::number::{Surd, Truth};
use crate::plane::displacement::Displacement;
use crate::plane::{Angle, Point, relation};
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::{Random, point};
use crate::scenes::{Free, Unbuilt};

pub const CHECK: Check = Check {
    name: "centerpoints-from-an-angle",
    summary: "For random exact positions and angles alpha, the circles over the sides P_13 P_14 and P_23 \
              P_24 meet in two points or not at all, and the four places in the moving plane of each of \
              these points are on a circle. The wrong variant lays out -alpha on the second side.",
    run,
};

const INSTANCES: usize = 20;

type Positions = [Displacement<Surd>; 4];

fn run() -> Result<Report, Unbuilt> {
    let mut free = Random::new(1985);
    let mut holds = Truth::Yes;
    let mut wrong_variant = Truth::Yes;
    let mut instances = 0;
    while instances < INSTANCES {
        let positions = [(); 4].map(|()| position(&mut free));
        let [Ok(a), Ok(b), Ok(c), Ok(d)] = positions else {
            return Err(Unbuilt::NotHeld("four positions".to_owned()));
        };
        let positions = [a, b, c, d];
        let alpha: Angle<Surd> = free.angle("alpha")?;
        let sides = OppositeSides::of(&positions);
        let right = points(&sides.centerpoints(&alpha))?;
        instances += usize::from(!right.is_empty());
        holds = holds & are_centerpoints(&right, &positions);
        // The angle at the other end of a side is the opposite one.
        let [first, [from, to]] = sides.0;
        let turned = OppositeSides([first, [to, from]]);
        let wrong = points(&turned.centerpoints(&alpha))?;
        wrong_variant = wrong_variant & are_centerpoints(&wrong, &positions);
    }
    Ok(Report {
        holds,
        wrong_variant,
        basis: Basis::Instances,
        instances,
        exception: None,
    })
}

fn position(free: &mut Random) -> Result<Displacement<Surd>, Unbuilt> {
    Ok(Displacement {
        rotation: Free::<Surd>::angle(free, "theta")?.cis(),
        translation: point(free, "T")?,
    })
}

/// Both points, or none.
fn points(meets: &Meets<Surd>) -> Result<Vec<Point<Surd>>, Unbuilt> {
    match meets {
        Meets::Two(both) => Ok(both.to_vec()),
        Meets::None => Ok(Vec::new()),
        Meets::Double(_) | Meets::Single(_) | Meets::Undecided => Err(Unbuilt::NotReal(
            "the circles touch or are lines".to_owned(),
        )),
    }
}

fn are_centerpoints(points: &[Point<Surd>], positions: &Positions) -> Truth {
    Truth::all(points.iter().map(|point| {
        let places = positions.each_ref().map(|one| one.inverse().of(point));
        relation::concyclic(&places)
    }))
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
