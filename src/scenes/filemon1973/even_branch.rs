//! The closed branch has no inflexion.

use super::count::tangents_from;
use super::sample::quadrilaterals;
use super::side_order::Sides;
use crate::number::poly::Fraction;
use crate::number::{Exact, Number, Truth};
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::plane::tangents::Pencil;
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::Symbols;
use crate::scenes::{Free, Unbuilt};

pub const CHECK: Check = Check {
    name: "even-branch-has-no-inflexion",
    summary: "An inflexional tangent is one of the four lines through its point that touch the cubic: so it \
              is for the general cubic with an inflexion in the origin. Along a branch the number of \
              real ones among these lines does not change, as two of them coincide only in a line \
              through a double point. For U < Z it is 0 on the branch of the focus, which is the pair of \
              the point at infinity, and 4 on the other. The wrong variant says that the other branch \
              has no inflexion either.",
    run,
};

const INSTANCES: usize = 20;

fn run() -> Result<Report, Unbuilt> {
    let mut holds = inflexional_tangent_counts()?;
    let mut wrong_variant = holds;
    let mut instances = 0;
    for quadrilateral in quadrilaterals() {
        let quadrilateral = quadrilateral?;
        let sides = Sides::of(&quadrilateral)?;
        if sides.u.compare(&sides.z).is_none_or(|order| order.is_ge()) {
            continue;
        }
        let curve = quadrilateral.curve()?;
        let real = |point: &Point<Exact>| tangents_from(&curve, point).map(|count| count.real);
        let [o12, _, o34, _] = quadrilateral.poles();
        let mut pair = [real(&o12)?, real(&o34)?];
        pair.sort_unstable();
        let focus = real(&curve.singular_focus())?;
        holds = holds & Truth::from((pair, focus) == ([0, 4], 0));
        wrong_variant = wrong_variant & Truth::from(pair == [0, 0]);
        instances += 1;
        if instances == INSTANCES {
            break;
        }
    }
    Ok(Report {
        holds,
        wrong_variant,
        basis: Basis::Instances,
        instances,
        exception: None,
    })
}

/// The cubic touches the x-axis in the origin, and has no term x².
fn inflexional_tangent_counts() -> Result<Truth, Unbuilt> {
    let mut free = Symbols::default();
    let curve = Cubic::<Fraction>::new([
        free.number("xxx")?,
        free.number("xxy")?,
        free.number("xyy")?,
        free.number("yyy")?,
        Number::zero(),
        free.number("xy")?,
        free.number("yy")?,
        Number::zero(),
        free.number("y")?,
        Number::zero(),
    ]);
    let pencil = Pencil::new(&curve, &Number::zero(), [Number::one(), Number::i()]);
    Ok(pencil.discriminant().evaluate(&Number::zero()).is_zero())
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
        assert_eq!(report.instances, INSTANCES);
    }
}
