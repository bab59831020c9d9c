//! A linkage whose point keeps to a line: the linkage, and the deviation from the line and its second
//! derivative over the travel.

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::complex::{Z, point, z};
use super::plot::{Plot, block};
use super::straight_line::Linkage;
use super::{number, numbers};
use crate::linkage::cognates::CouplerPoint;
use crate::number::Number;
use crate::straight_line::design::Design;
use crate::straight_line::deviation::driven::Driven;

const STEPS: u32 = 1200;

/// The linkage in its design position with the whole path of D, and below it the diagrams on the longest
/// arc of the answer.
pub fn picture(answer: &Value) -> Option<String> {
    picture_with(answer, &Points::default())
}

/// Points from elsewhere to be compared with the curves.
#[derive(Clone, Debug, Default)]
pub struct Points {
    /// What they are.
    pub name: String,
    /// u and v.
    pub deviation: Vec<Point>,
    /// u and d²v/du².
    pub second: Vec<Point>,
}

/// The same with points to compare.
pub fn picture_with(answer: &Value, points: &Points) -> Option<String> {
    let levels = answer["levels"].as_array()?;
    let span = |level: &&Value| -> Option<[f64; 2]> { numbers(&level["phi"]) };
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
            marks: points.deviation.clone(),
        },
        Plot {
            title: "Second derivative of v with respect to u".to_owned(),
            across: "travel u, in unit lengths",
            points: middle_half(second),
            levels: Vec::new(),
            marks: points.second.clone(),
        },
    ];
    let mut canvas = Canvas::new(
        "A point that keeps to a straight line",
        "The four-bar O_aABO_b with the point D of its coupler in the design position, the whole path of D and \
         the line that it keeps to between the ends for each accuracy. Below, over the travel of D along \
         the line, its deviation from the line, and the second derivative of the deviation with respect to \
         the travel.",
    );
    draw_linkage(&mut canvas, answer, &driven)?;
    if !points.name.is_empty() {
        canvas.remark(&format!("circles: {}", points.name));
    }
    canvas.below(block(&plots));
    Some(canvas.to_svg())
}

fn draw_linkage(canvas: &mut Canvas, answer: &Value, driven: &Driven<f64>) -> Option<()> {
    let at = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        driven.position(&z(cos, sin))
    };
    let [o_a, o_b] = driven.pivots().clone();
    let start = at(0.0)?;
    let [a, b] = start.pins;
    let linkage = Linkage {
        o_a,
        a,
        b,
        o_b,
        d: start.point,
    };
    for branch in linkage.path() {
        canvas.line(branch, Stroke::MainPath);
    }
    let mut accuracies = Vec::new();
    let mut ends = Vec::new();
    for level in answer["levels"].as_array()? {
        let limits = level["phi"].as_array().into_iter().flatten();
        let limits: Vec<_> = limits.filter_map(number).filter_map(at).collect();
        if let ([from, to], Some(accuracy)) = (limits.as_slice(), number(&level["D"])) {
            ends.extend([point(&from.point), point(&to.point)]);
            let decimals = format!("{accuracy:.12}");
            accuracies.push(decimals.trim_end_matches('0').to_owned());
        }
    }
    let [.., d] = linkage.joints();
    let direction = point(&turn(answer, "line")?);
    let along = |length: f64| [d[0] + length * direction[0], d[1] + length * direction[1]];
    let travels = ends
        .iter()
        .map(|end| (end[0] - d[0]) * direction[0] + (end[1] - d[1]) * direction[1]);
    let (low, high) = travels.fold((0.0, 0.0), |(low, high): (f64, f64), u| {
        (low.min(u), high.max(u))
    });
    canvas.line([along(1.15 * low), along(1.15 * high)], Stroke::Guide);
    linkage.draw(canvas);
    for end in ends {
        canvas.joint(end, Joint::Mark, "");
    }
    canvas.explain(Stroke::MainPath, "path of D");
    canvas.explain(Stroke::Guide, "the line that it keeps to");
    canvas.explain(Stroke::Crank, "cranks");
    canvas.remark(&format!(
        "dots: where D leaves the line by {} unit lengths, or stops before",
        accuracies.join(", ")
    ));
    Some(())
}

/// A direction that is given by its angle.
fn turn(answer: &Value, name: &str) -> Option<Z> {
    let degrees = number(answer.get(name)?.get("degrees")?)?;
    let (sin, cos) = degrees.to_radians().sin_cos();
    Some(z(cos, sin))
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
    let o_b = Z::from(length("Q")?);
    let a = turn(answer, "phi0")?.scaled(&length("R")?);
    let b = &o_b + turn(answer, "psi0")?.scaled(&length("T")?);
    let arm = turn(answer, "chi0")? * turn(answer, "epsilon")?;
    let point = &a + arm.scaled(&length("M")?);
    Driven::new(&Design {
        linkage: CouplerPoint {
            pivots: [z(0.0, 0.0), o_b],
            pins: [a, b],
            point,
        },
        direction: turn(answer, "line")?,
    })
}
