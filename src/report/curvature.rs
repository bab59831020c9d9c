//! One position of a motion: the linkage, the pole, the inflection circle, the cubic of stationary
//! curvature and the Burmester points.

use std::f64::consts::TAU;

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::complex::{point, z};
use super::{contour, finite_point, frames, numbers};
use crate::curvature::canonical::Invariants;
use crate::curvature::closure;
use crate::curvature::contact::Guide;
use crate::curvature::motion::{Motion, coefficient};
use crate::plane::circular_cubic::Cubic;

/// Farther away than so many times the size of the figure a pair is told, not drawn.
const FAR: f64 = 4.0;
/// Of the series of a path.
const ORDER: usize = 4;
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
    draw_circle(&mut canvas, pole, inflection_pole);
    if let Some(coefficients) = answer.pointer("/circlepoint/coefficients") {
        draw_cubic(&mut canvas, coefficients);
    }
    for pair in found.iter().filter(|pair| shown(pair)) {
        draw_pair(&mut canvas, pair);
    }
    let ball_point = finite_point(&answer["ball_point"]).filter(near);
    let asked = answer["points"].as_array().into_iter().flatten();
    let mut asked: Vec<Point> = asked
        .filter_map(|at| finite_point(&at["point"]))
        .filter(near)
        .collect();
    if asked.is_empty() {
        asked.extend(ball_point);
    }
    let has_paths = draw_paths(&mut canvas, problem, &asked, size);
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
            canvas.joint(center, Joint::Fixed, &format!("B_{name}"));
            canvas.joint(point, Joint::Moving, &format!("A_{name}"));
        }
    }
    let counts = match answer["ball_burmester"].as_str() {
        Some("burmester") => Some("five positions of U are on its tangent"),
        Some("double-burmester") => {
            Some("five positions of U are on its tangent: two Burmester points")
        }
        Some("triple-burmester") => {
            Some("five positions of U are on its tangent: three Burmester points")
        }
        _ => None,
    };
    if let Some(counts) = counts {
        canvas.remark(counts);
    }
    for at in asked.iter().filter(|at| Some(**at) != ball_point) {
        canvas.joint(*at, Joint::Mark, "");
    }
    canvas.explain(Stroke::Guide, "inflection circle");
    canvas.explain(Stroke::Curve, "cubic of stationary curvature");
    canvas.explain(
        Stroke::Construction,
        "Burmester point A, its center B and circle",
    );
    if has_paths {
        canvas.explain(Stroke::Path, "path of a point, and its tangent");
    }
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

/// A link and its circle.
fn draw_pair(canvas: &mut Canvas, pair: &Pair) {
    let (Some(point), Some(center)) = (pair.circlepoint, pair.center) else {
        return;
    };
    canvas.line([center, point], Stroke::Construction);
    let radius = (point[0] - center[0]).hypot(point[1] - center[1]);
    canvas.background(circle(center, radius), Stroke::Construction);
}

fn circle([x, y]: Point, radius: f64) -> Vec<Point> {
    let at = |step: u32| {
        let angle = TAU * f64::from(step) / f64::from(STEPS);
        [x + radius * angle.cos(), y + radius * angle.sin()]
    };
    (0..=STEPS).map(at).collect()
}

/// The paths of points near the position, by their series, with their tangents; whether there are any.
fn draw_paths(canvas: &mut Canvas, problem: &Value, points: &[Point], size: f64) -> bool {
    let Some(motion) = motion(problem) else {
        return false;
    };
    for [x, y] in points {
        let path = motion.path_of(&z(*x, *y));
        let terms: Vec<Point> = (0..=ORDER).map(|j| point(&coefficient(&path, j))).collect();
        let at = |t: f64| {
            let last_first = terms.iter().rev();
            last_first.fold([0.0; 2], |[x, y], [u, v]| [x * t + u, y * t + v])
        };
        let [start, velocity, ..] = *terms else {
            continue;
        };
        let speed = velocity[0].hypot(velocity[1]);
        if speed == 0.0 {
            continue;
        }
        // Not beyond where the last terms show.
        let small = |(j, term): (u32, &Point)| {
            let length = term[0].hypot(term[1]);
            (size / 50.0 / length).powf(1.0 / f64::from(j))
        };
        let last = (0..).zip(&terms).skip(3).map(small);
        let reach = last.fold(size / 5.0 / speed, f64::min);
        let along = |sign: f64| {
            let [x, y] = start;
            let [u, v] = velocity;
            [x + sign * reach * u, y + sign * reach * v]
        };
        canvas.line([along(-1.0), along(1.0)], Stroke::Path);
        let times =
            (0..=STEPS).map(|step| reach * (2.0 * f64::from(step) / f64::from(STEPS) - 1.0));
        canvas.background(times.map(at).collect(), Stroke::Path);
    }
    !points.is_empty()
}

/// The motion of the linkage, or of the invariants.
fn motion(problem: &Value) -> Option<Motion<f64>> {
    if let Some(invariants) = problem.get("invariants") {
        let [third, fourth] = ["third", "fourth"].map(|name| finite_point(&invariants[name]));
        let ([a, b], [c, d]) = (third?, fourth?);
        return Some(
            Invariants {
                third: z(a, b),
                fourth: z(c, d),
            }
            .motion(),
        );
    }
    let links = problem.get("links")?.as_array()?;
    let guide = |link: &Value| {
        let direction = |name: &str| {
            let at_infinity = link.get(name)?.get("at_infinity")?;
            finite_point(at_infinity).map(|[x, y]| z(x, y))
        };
        let finite = |name: &str| finite_point(&link[name]).map(|[x, y]| z(x, y));
        Some(match (direction("circlepoint"), direction("center")) {
            (Some(normal), _) => Guide::MovingLine {
                center: finite("center")?,
                normal,
            },
            (_, Some(normal)) => Guide::Line {
                point: finite("circlepoint")?,
                normal,
            },
            _ => Guide::Circle {
                point: finite("circlepoint")?,
                center: finite("center")?,
            },
        })
    };
    let [first, second] = links.as_slice() else {
        return None;
    };
    closure::motion(&[guide(first)?, guide(second)?], ORDER)
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
