//! The deviation of a point from its line, and its second derivative, over the travel.

use serde_json::Value;

use super::canvas::Point;
use super::complex::{Z, z};
use super::number;
use super::plot::{Plot, draw};
use crate::linkage::cognates::CouplerPoint;
use crate::number::Number;
use crate::straight_line::design::Design;
use crate::straight_line::deviation::driven::Driven;

const STEPS: u32 = 1200;

/// The picture, on the longest arc of the answer.
pub fn picture(answer: &Value) -> Option<String> {
    let levels = answer["levels"].as_array()?;
    let span = |level: &&Value| -> Option<[f64; 2]> {
        Some([number(&level["phi"][0])?, number(&level["phi"][1])?])
    };
    let longest = levels
        .iter()
        .filter_map(|level| Some((level, span(&level)?)))
        .max_by(|(_, a), (_, b)| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
    let (level, [from, to]) = longest;
    let bound = number(&level["D"])?;
    let driven = driven(answer)?;
    let rows: Vec<[f64; 3]> = (0..=STEPS)
        .map(|step| from + (to - from) * f64::from(step) / f64::from(STEPS))
        .map(|degrees| row(&driven, degrees).unwrap_or([f64::NAN; 3]))
        .collect();
    let deviation: Vec<Point> = rows.iter().map(|[u, v, _]| [*u, *v]).collect();
    let second: Vec<Point> = rows
        .windows(3)
        .filter_map(|window| match window {
            [[u, _, before], [middle, ..], [w, _, after]] => {
                Some([*middle, (after - before) / (w - u)])
            }
            _ => None,
        })
        .collect();
    let reaches = deviation.iter().any(|[_, v]| v.abs() > 0.9 * bound);
    let plots = [
        Plot {
            title: "Deviation v, in unit lengths".to_owned(),
            across: "travel u, in unit lengths",
            points: deviation,
            levels: if reaches {
                vec![-bound, bound]
            } else {
                Vec::new()
            },
        },
        Plot {
            title: "Second derivative of v with respect to u".to_owned(),
            across: "travel u, in unit lengths",
            points: middle_half(second),
            levels: Vec::new(),
        },
    ];
    Some(draw(
        "Deviation from a straight line",
        "The deviation of the coupler point from its line over its travel along the line, and the second \
         derivative of the one with respect to the other, on the arc on which the deviation keeps within \
         the largest level.",
        &plots,
    ))
}

/// Where the travel turns back the derivative is infinite: what is far beyond the rest is left out.
fn middle_half(mut points: Vec<Point>) -> Vec<Point> {
    let mut sizes: Vec<f64> = points.iter().map(|[_, y]| y.abs()).collect();
    sizes.retain(|size| size.is_finite());
    sizes.sort_by(f64::total_cmp);
    let Some(typical) = sizes.get(sizes.len() * 3 / 4) else {
        return points;
    };
    for point in &mut points {
        if point[1].abs() > 4.0 * typical {
            point[1] = f64::NAN;
        }
    }
    points
}

/// u, v and dv/du.
fn row(driven: &Driven<f64>, degrees: f64) -> Option<[f64; 3]> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let position = driven.position(&z(cos, sin))?;
    let [u, v] = driven.coordinates(&position).map(|x| x.0);
    let rates = driven.rates(&position);
    Some([u, v, (rates.deviation / rates.travel).0])
}

/// The linkage from its lengths and angles.
fn driven(answer: &Value) -> Option<Driven<f64>> {
    let length = |name: &str| number(&answer[name]).map(Number);
    let turn = |name: &str| -> Option<Z> {
        let (sin, cos) = number(&answer[name]["degrees"])?.to_radians().sin_cos();
        Some(z(cos, sin))
    };
    let o_b = Z::from(length("Q")?);
    let a = turn("phi0")?.scaled(&length("R")?);
    let b = &o_b + turn("psi0")?.scaled(&length("T")?);
    let arm = turn("chi0")? * turn("epsilon")?;
    let point = &a + arm.scaled(&length("M")?);
    Driven::new(&Design {
        linkage: CouplerPoint {
            pivots: [z(0.0, 0.0), o_b],
            pins: [a, b],
            point,
        },
        direction: turn("line")?,
    })
}
