//! One position of a motion: the linkage, the pole, the inflection circle, the cubic of stationary
//! curvature and the Burmester points.

use std::f64::consts::TAU;

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::complex::z;
use super::{contour, finite_point, frames, numbers};
use crate::plane::circular_cubic::Cubic;

/// Farther away than so many times the size of the figure a pair is told, not drawn.
const FAR: f64 = 4.0;
/// Points of a circle.
const STEPS: u32 = 96;

/// A point of the moving plane with its center.
struct Pair {
    circlepoint: Option<Point>,
    center: Option<Point>,
}

/// The picture; `None` where nothing of it is finite.
pub fn picture(problem: &Value, answer: &Value) -> Option<String> {
    let links = pairs(problem.get("links"));
    let found = pairs(answer.get("pairs"));
    let pole = finite_point(&answer["pole"]);
    let inflection_pole = finite_point(&answer["inflection_pole"]);
    let mut points: Vec<Point> = links.iter().flat_map(Pair::points).collect();
    points.extend(pole);
    points.extend(inflection_pole);
    let middle = *points.first()?;
    let size = frames::extent(&points);
    let mut canvas = Canvas::new(
        "Curvature of the paths in one position",
        "The linkage with its pole P and inflection pole W, the circle of the points whose paths have an \
         inflection, the cubic of those with stationary curvature, Ball's point U, and the Burmester \
         points A with their centers B.",
    );
    let near = |at: &Point| (at[0] - middle[0]).hypot(at[1] - middle[1]) < FAR * size;
    points.iter().for_each(|at| canvas.show(*at));
    let shown = |pair: &Pair| pair.points().count() == 2 && pair.points().all(|at| near(&at));
    for pair in found.iter().filter(|pair| shown(pair)) {
        pair.points().for_each(|at| canvas.show(at));
    }
    draw_cubic(&mut canvas, &answer["circlepoint"]["coefficients"]);
    draw_circle(&mut canvas, pole, inflection_pole);
    for pair in found.iter().filter(|pair| shown(pair)) {
        canvas.line(pair.points(), Stroke::Construction);
    }
    draw_linkage(&mut canvas, &links);
    for (name, at) in [
        ("P", pole),
        ("W", inflection_pole),
        ("U", finite_point(&answer["ball_point"])),
    ] {
        if let Some(at) = at.filter(near) {
            canvas.joint(at, Joint::Mark, name);
        }
    }
    for (place, pair) in found.iter().enumerate() {
        let name = place + 1;
        if !shown(pair) {
            canvas.remark(&format!("too far away: A{name}, B{name}"));
            continue;
        }
        if let (Some(point), Some(center)) = (pair.circlepoint, pair.center) {
            canvas.joint(center, Joint::Fixed, &format!("B{name}"));
            canvas.joint(point, Joint::Moving, &format!("A{name}"));
        }
    }
    for at in answer["points"].as_array().into_iter().flatten() {
        if let Some(at) = finite_point(&at["point"]).filter(near) {
            canvas.joint(at, Joint::Mark, "");
        }
    }
    canvas.explain(Stroke::Guide, "inflection circle");
    canvas.explain(Stroke::Curve, "cubic of stationary curvature");
    canvas.explain(Stroke::Construction, "Burmester point A and its center B");
    Some(canvas.to_svg())
}

impl Pair {
    /// Those that are finite.
    fn points(&self) -> impl Iterator<Item = Point> {
        self.circlepoint.into_iter().chain(self.center)
    }
}

fn pairs(list: Option<&Value>) -> Vec<Pair> {
    let list = list.and_then(Value::as_array).into_iter().flatten();
    list.map(|pair| Pair {
        circlepoint: finite_point(&pair["circlepoint"]),
        center: finite_point(&pair["center"]),
    })
    .collect()
}

fn draw_linkage(canvas: &mut Canvas, links: &[Pair]) {
    for link in links {
        if let (Some(point), Some(center)) = (link.circlepoint, link.center) {
            canvas.line([center, point], Stroke::Crank);
        }
    }
    let joints: Vec<Point> = links.iter().filter_map(|link| link.circlepoint).collect();
    if joints.len() == 2 {
        canvas.line(joints, Stroke::Bar);
    }
    for link in links {
        if let Some(center) = link.center {
            canvas.joint(center, Joint::Fixed, "");
        }
        if let Some(point) = link.circlepoint {
            canvas.joint(point, Joint::Moving, "");
        }
    }
}

/// The circle with the pole and the inflection pole as ends of a diameter.
fn draw_circle(canvas: &mut Canvas, pole: Option<Point>, opposite: Option<Point>) {
    let (Some([x, y]), Some([u, v])) = (pole, opposite) else {
        return;
    };
    let radius = (x - u).hypot(y - v) / 2.0;
    let on_circle = |step: u32| {
        let angle = TAU * f64::from(step) / f64::from(STEPS);
        [
            f64::midpoint(x, u) + radius * angle.cos(),
            f64::midpoint(y, v) + radius * angle.sin(),
        ]
    };
    canvas.line((0..=STEPS).map(on_circle), Stroke::Guide);
}

fn draw_cubic(canvas: &mut Canvas, coefficients: &Value) {
    let Some(list) = numbers::<10>(coefficients) else {
        return;
    };
    let largest = list.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    let cubic = Cubic::new(list.map(|x| crate::number::Number(x / largest)));
    let value = |[x, y]: Point| cubic.at(&z(x, y)).0;
    let gap = [f64::NAN; 2];
    let pieces = contour::zero_set(value, canvas.window()).into_iter();
    canvas.background(
        pieces.flat_map(|[p, q]| [p, q, gap]).collect(),
        Stroke::Curve,
    );
}
