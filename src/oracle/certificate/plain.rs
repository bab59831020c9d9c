//! Poles, three and four positions: by the defining equations.

use rug::Rational;
use serde_json::Value;

use super::shown::{Shown, digits, point};
use super::{Defect, require};
use crate::finite::four_positions::loop_closure::centerpoint_cubic;
use crate::finite::positions::Positions;
use crate::number::text::parse_rational;
use crate::number::{Ball, Complex, Exact, Number};
use crate::oracle::positions::Given;
use crate::plane::displacement::Displacement;

type Entry = Number<Complex<Ball>>;

/// The poles, image poles and turns.
pub fn poles(given: &Given, answer: &Value) -> Result<(), Defect> {
    let bits = bits(answer)?;
    let positions = given.rounded::<Ball>(&bits);
    all_poles(given, &positions, answer, bits)?;
    for (i, j) in positions.pairs() {
        let label = format!("{}{}", i + 1, j + 1);
        let turn = rotation(&positions, j) * rotation(&positions, i).conj();
        let degrees = &answer["turns"][&label]["degrees"];
        let radians = Shown::read(degrees, "turns")?.ball(bits) * Number::pi(&bits) / 180;
        let right = radians.clone().cos().0.overlaps(&turn.re().0)
            && radians.sin().0.overlaps(&turn.im().0);
        require(
            right,
            "turns",
            "this is not the angle between the positions",
        )?;
    }
    Ok(())
}

fn bits(answer: &Value) -> Result<u32, Defect> {
    Ok(digits(answer)?.saturating_mul(8).saturating_add(256))
}

fn rotation(positions: &Positions<Ball>, place: usize) -> Entry {
    let position = positions.displacements().get(place);
    position.map_or_else(Number::one, |position| position.rotation.clone())
}

fn all_poles(
    given: &Given,
    positions: &Positions<Ball>,
    answer: &Value,
    bits: u32,
) -> Result<(), Defect> {
    let digits = digits(answer)?;
    let exact = given.rational();
    let inverse = positions.inverse();
    let exact_inverse = exact.as_ref().map(Positions::inverse);
    let both = [
        ("poles", &inverse, &exact_inverse),
        ("image_poles", positions, &exact),
    ];
    for (name, positions, exact) in both {
        for (i, j) in positions.pairs() {
            let shown = &answer[name][&format!("{}{}", i + 1, j + 1)];
            let two =
                |list: &[Displacement<Ball>]| Some([list.get(i)?.clone(), list.get(j)?.clone()]);
            let Some(two) = two(positions.displacements()) else {
                continue;
            };
            let exact = exact.as_ref().map(Positions::displacements);
            let exact = exact.and_then(|list| Some([list.get(i)?, list.get(j)?]));
            pole(name, shown, &two, exact, digits, bits)?;
        }
    }
    Ok(())
}

/// The point with one place in both: r z + t = s z + u.
fn pole(
    name: &str,
    shown: &Value,
    [a, b]: &[Displacement<Ball>; 2],
    exact: Option<[&Displacement<Exact>; 2]>,
    digits: u32,
    bits: u32,
) -> Result<(), Defect> {
    if shown.is_null() {
        return Err(Defect::unchecked(format!(
            "the answer leaves {name} undecided"
        )));
    }
    if shown.is_array() {
        let shown = point(shown, name, digits)?;
        let z = (&b.translation - &a.translation) / (&a.rotation - &b.rotation);
        let held = shown[0].re.holds(z.re()) && shown[1].re.holds(z.im());
        return require(held, name, "this point has two places");
    }
    let [a, b] = exact
        .ok_or_else(|| Defect::unchecked("poles that are not finite, of enclosed positions"))?;
    let shift = &b.translation - &a.translation;
    require(
        a.rotation.equals(&b.rotation).is_yes(),
        name,
        "the pole is finite",
    )?;
    if shown.get("undetermined").is_some() {
        return require(shift.is_zero().is_yes(), name, "the pole is determined");
    }
    let direction = &shown["at_infinity"];
    let [x, y] = [&direction[0], &direction[1]].map(|part| Shown::read(part, name));
    let towards: Entry = Number::complex(x?.ball(bits), y?.ball(bits));
    // The displacement seen in the plane in which the pole is.
    let seen = &shift / &a.rotation;
    let part =
        |x: &Number<Exact>| Number::<Ball>::from(x.0.rational().cloned().unwrap_or_default());
    let seen: Entry = Number::complex(part(seen.re()), part(seen.im()));
    let right =
        shift.is_zero().is_no() && (towards * seen.conj()).re().0.contains(&Rational::new());
    require(right, name, "the pole is in another direction")
}

/// Poles, and the pairs by their distances.
pub fn three_positions(given: &Given, answer: &Value) -> Result<(), Defect> {
    let bits = bits(answer)?;
    let digits = digits(answer)?;
    let positions = given.rounded::<Ball>(&bits);
    all_poles(given, &positions, answer, bits)?;
    for pair in super::shown::list(answer, "pairs")? {
        let finite = |name: &str| pair[name].is_array();
        if !finite("circlepoint") || !finite("center") {
            continue;
        }
        let z = point(&pair["circlepoint"], "pairs.circlepoint", digits)?;
        let m = point(&pair["center"], "pairs.center", digits)?;
        let ball = |p: &[super::shown::Coordinate; 2]| -> Entry {
            Number::complex(p[0].re.ball(bits), p[1].re.ball(bits))
        };
        let (z, m) = (ball(&z), ball(&m));
        let radius = Shown::read(&pair["radius"], "pairs.radius")?.ball(bits);
        for position in positions.displacements() {
            let squared = (position.of(&z) - &m).norm();
            let right = squared.0.overlaps(&radius.square().0);
            require(
                right,
                "pairs",
                "the circlepoint is not at this distance from the center",
            )?;
        }
    }
    Ok(())
}

/// The poles and the coefficients of both curves.
pub fn centerpoint_curve(given: &Given, answer: &Value) -> Result<(), Defect> {
    let bits = bits(answer)?;
    let positions = given.rounded::<Ball>(&bits);
    all_poles(given, &positions, answer, bits)?;
    let exact = given
        .rational()
        .ok_or_else(|| Defect::unchecked("curves of enclosed positions"))?;
    for (name, positions) in [
        ("centerpoint", exact.clone()),
        ("circlepoint", exact.inverse()),
    ] {
        let four = positions.first_four();
        let own = four.and_then(centerpoint_cubic);
        let own = own.ok_or_else(|| Defect::unchecked("no second route to the curve"))?;
        let shown = answer[name]["coefficients"].as_array();
        let shown: Option<Vec<Rational>> = shown.and_then(|list| {
            list.iter()
                .map(|value| parse_rational(value.as_str()?).ok())
                .collect()
        });
        let own: Option<Vec<Rational>> = own
            .coefficients()
            .iter()
            .map(|c| c.0.rational().cloned())
            .collect();
        let own = own.map(|own| crate::number::exact::primitive(&own));
        let own: Option<Vec<Rational>> =
            own.map(|own| own.into_iter().map(Rational::from).collect());
        require(
            shown.is_some() && shown == own,
            name,
            "a second route gives another curve",
        )?;
    }
    Ok(())
}
