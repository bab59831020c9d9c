//! The linkages of the figures that were designed, not measured.

use rug::Rational;

use super::super::symmetric_linkage::central_position;
use super::{evans, watt};
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Ball, Number};
use crate::plane::{Angle, Point};
use crate::scenes::Unbuilt;
use crate::straight_line::ball_burmester::{Alternate, at_inflection_pole, double, of_rays};
use crate::straight_line::design::Design;
use crate::straight_line::no_design::NoDesign;

/// Bits of the enclosures.
pub const BITS: u32 = 128;

/// A linkage with its figure's number.
pub type Drawn = (u32, Design<Ball>);

pub fn undecided() -> Unbuilt {
    Unbuilt::NotHeld("a decision on a linkage of the figures".to_owned())
}

fn none(reason: NoDesign) -> Unbuilt {
    Unbuilt::NotReal(reason.to_string())
}

/// A whole angle in degrees.
pub fn angle(degrees: i64) -> Result<Angle<Ball>, Unbuilt> {
    Angle::from_degrees(&degrees.into(), &BITS).ok_or_else(undecided)
}

pub fn number(numerator: i64, denominator: i64) -> Number<Ball> {
    Number::rounded(&Rational::from((numerator, denominator)), &BITS)
}

/// The linkage with a double Burmester point, for rays in whole degrees.
pub fn with_double_point([a, b]: [i64; 2]) -> Result<Design<Ball>, Unbuilt> {
    double(&angle(a)?, &angle(b)?)
        .and_then(|cranks| cranks.design(Alternate::First))
        .map_err(none)
}

/// The alternates of one slider-crank, figures 39, 41, 43.
pub fn alternates() -> Result<[Design<Ball>; 3], Unbuilt> {
    let cranks = of_rays(&angle(50)?, &angle(20)?, &angle(80)?).map_err(none)?;
    let design = |alternate| cranks.design(alternate).map_err(none);
    let [first, second, third] = Alternate::ALL.map(design);
    Ok([first?, second?, third?])
}

/// Evans' three configurations, figures 65, 67, 69.
pub fn evans() -> Result<[Drawn; 3], Unbuilt> {
    let design = |omega: i64, rho: Number<Ball>, k: Number<Ball>| {
        evans::design(&angle(omega)?, &rho, &k).map_err(none)
    };
    Ok([
        (65, design(-25, number(1, 6), number(5, 3))?),
        (67, design(-20, number(-13, 7), number(40, 7))?),
        (69, design(-20, number(8, 3), number(10, 3))?),
    ])
}

fn watt(r: &Number<Ball>) -> Result<Design<Ball>, Unbuilt> {
    let linkage = watt::upon(r, &number(1, 1), &angle(90)?);
    linkage.design().map_err(none)
}

fn symmetric(sense: i64, c: [i64; 2], d: [i64; 2]) -> Design<Ball> {
    let ratio = |[numerator, denominator]: [i64; 2]| number(numerator, denominator);
    let linkage: CouplerPoint<Ball> =
        central_position(&number(3, 2), &number(sense, 1), &ratio(c), &ratio(d));
    Design {
        linkage,
        direction: Point::one().scaled(&number(1, 1)),
    }
}

/// All of them of which a figure lists the dimensions.
pub fn all() -> Result<Vec<Drawn>, Unbuilt> {
    let [first, second, _] = alternates()?;
    let pole = at_inflection_pole(&number(-5, 2), &angle(75)?)
        .and_then(|cranks| cranks.design(Alternate::Third))
        .map_err(none)?;
    let [configuration_1, configuration_2, configuration_3] = evans()?;
    Ok(vec![
        (37, with_double_point([65, 165])?),
        (39, first),
        (41, second),
        (49, pole),
        (57, watt(&number(1, 1))?),
        (59, watt(&number(1, 2))?),
        (61, symmetric(-1, [-1, 2], [9, 2])),
        (63, symmetric(1, [5, 1], [3, 2])),
        configuration_1,
        configuration_2,
        configuration_3,
        (72, with_double_point([5, 40])?),
    ])
}
