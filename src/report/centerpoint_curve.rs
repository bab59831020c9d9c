//! The centerpoint curve with its poles, a quadrilateral of them, focus, asymptote, midline and node.

use std::f64::consts::TAU;

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::complex::z;
use super::{contour, finite_point, numbers, poles, stretches};
use crate::number::Number;
use crate::plane::circular_cubic::Cubic;
use crate::plane::curve_type::CurveType;
use crate::plane::focal_cubic::FocalCubic;
use crate::plane::trace::Trace;

/// Points of each branch.
const STEPS: u32 = 3000;

/// The picture; `None` where the curve is not known, or all of the plane, or without a finite point.
pub fn picture(problem: &Value, answer: &Value) -> Option<String> {
    Some(canvas(problem, answer)?.to_svg())
}

/// The picture, to which more can be added.
pub fn canvas(problem: &Value, answer: &Value) -> Option<Canvas> {
    let curve = answer.get("centerpoint")?;
    let kind = curve.get("type")?.as_str()?;
    let coefficients: [f64; 10] = numbers(curve.get("coefficients")?)?;
    if kind == "every-point" {
        return None;
    }
    let mut canvas = Canvas::new(
        &format!(
            "Centerpoint curve of four positions ({})",
            kind.replace('-', " ")
        ),
        "All branches of the centerpoint curve, which passes through the six poles, with one \
         opposite-pole quadrilateral, the focus F, the asymptote, the midline halfway between the two, \
         and the node H if there is one.",
    );
    let all = poles::finite(answer.get("poles")?);
    for (_, at) in &all {
        canvas.show(*at);
    }
    let special = |name: &str| curve.get(name).and_then(finite_point);
    for at in special("focus").into_iter().chain(nodes(curve)) {
        canvas.show(at);
    }
    let cubic = Cubic::new(coefficients.map(Number));
    if let Some(region) = stretches::region(problem) {
        canvas.area(region);
    }
    for piece in pieces(&cubic, kind, canvas.window()) {
        show_closed(&mut canvas, &piece);
    }
    let window = canvas.window();
    for piece in pieces(&cubic, kind, window) {
        canvas.background(piece, Stroke::MainCurve);
    }
    let stretches = stretches::pieces(answer, &cubic, kind);
    for piece in &stretches {
        canvas.background(within(piece.clone(), window), Stroke::Stretch);
    }
    for name in ["asymptote", "midline"] {
        if let Some(line) = curve.get(name).and_then(numbers) {
            canvas.background(across(line, window), guide(name));
        }
    }
    draw_quadrilateral(&mut canvas, answer, &all);
    for (name, at) in &all {
        canvas.joint(*at, Joint::Mark, &format!("P_{name}"));
    }
    if let Some(focus) = special("focus") {
        canvas.joint(focus, Joint::Moving, "F");
    }
    for (place, node) in nodes(curve).enumerate() {
        let name = if place == 0 { "H" } else { "H'" };
        canvas.joint(node, Joint::Moving, name);
    }
    canvas.explain(Stroke::MainCurve, "centerpoint curve");
    if !stretches.is_empty() {
        canvas.explain(Stroke::Stretch, "fulfils all wishes");
    }
    canvas.explain(Stroke::Construction, "opposite-pole quadrilateral");
    if special("focus").is_some() {
        canvas.explain(Stroke::Guide, "asymptote");
        canvas.explain(Stroke::Base, "midline");
    }
    canvas.scale("units of the positions");
    Some(canvas)
}

/// Makes room for a branch of which no point is far away.
pub fn show_closed(canvas: &mut Canvas, branch: &[Point]) {
    let is_closed = branch.len() > 2 && branch.iter().flatten().all(|x| x.is_finite());
    for point in branch.iter().filter(|_| is_closed) {
        canvas.show(*point);
    }
}

fn guide(name: &str) -> Stroke {
    if name == "asymptote" {
        Stroke::Guide
    } else {
        Stroke::Base
    }
}

fn nodes(curve: &Value) -> impl Iterator<Item = Point> {
    let list = curve.get("nodes").and_then(Value::as_array);
    list.into_iter().flatten().filter_map(finite_point)
}

/// The branches of a curve that has no line or circle as a part.
pub fn trace(cubic: &Cubic<f64>, kind: &str) -> Option<Trace<f64>> {
    let curve_type = match kind {
        "one-branch" => CurveType::OneBranch,
        "two-branches" => CurveType::TwoBranches,
        "nodal" => CurveType::Nodal,
        _ => return None,
    };
    Trace::new(FocalCubic::of(cubic)?, curve_type)
}

/// The curve in pieces, each a connected row of points.
pub fn pieces(cubic: &Cubic<f64>, kind: &str, window: (Point, Point)) -> Vec<Vec<Point>> {
    let Some(trace) = trace(cubic, kind) else {
        // Lines, circles and hyperbolas.
        let value = |[x, y]: Point| cubic.at(&z(x, y)).0;
        let pieces = contour::zero_set(value, window).into_iter();
        return pieces.map(|piece| piece.to_vec()).collect();
    };
    let branches = trace.branches().iter();
    branches
        .map(|branch| {
            let points = (0..=STEPS).map(|step| {
                let angle = TAU * f64::from(step) / f64::from(STEPS);
                let place = trace.point(*branch, &z(angle.cos(), angle.sin()));
                let [x, y, w] = place.coordinates();
                [x.0 / w.0, y.0 / w.0]
            });
            within(points.collect(), window)
        })
        .collect()
}

/// Points far outside of the window become gaps, so that no line crosses it from one end of the curve to
/// the other.
pub fn within(points: Vec<Point>, (low, high): (Point, Point)) -> Vec<Point> {
    let margin = (high[0] - low[0]).max(high[1] - low[1]);
    let is_between = |x: f64, low: f64, high: f64| x > low - margin && x < high + margin;
    let is_near =
        |[x, y]: &Point| is_between(*x, low[0], high[0]) && is_between(*y, low[1], high[1]);
    points
        .into_iter()
        .map(|point| {
            if is_near(&point) {
                point
            } else {
                [f64::NAN; 2]
            }
        })
        .collect()
}

/// The part of a line that is in the window.
pub fn across([a, b, c]: [f64; 3], (low, high): (Point, Point)) -> Vec<Point> {
    let middle = [(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0];
    let norm = a * a + b * b;
    let from_line = (a * middle[0] + b * middle[1] + c) / norm;
    let foot = [middle[0] - a * from_line, middle[1] - b * from_line];
    let direction = [-b, a];
    let mut ends = [f64::NEG_INFINITY, f64::INFINITY];
    for (((low, high), foot), direction) in low.into_iter().zip(high).zip(foot).zip(direction) {
        let [p, q] = [low, high].map(|side| (side - foot) / direction);
        if p.is_finite() && q.is_finite() {
            ends = [ends[0].max(p.min(q)), ends[1].min(p.max(q))];
        }
    }
    if ends[0] >= ends[1] {
        return Vec::new();
    }
    ends.map(|t| [foot[0] + t * direction[0], foot[1] + t * direction[1]])
        .to_vec()
}

/// The first quadrilateral whose poles are all finite.
fn draw_quadrilateral(canvas: &mut Canvas, answer: &Value, poles: &[(String, Point)]) {
    let list = answer.get("quadrilaterals").and_then(Value::as_array);
    let corners = list.into_iter().flatten().find_map(|one| {
        let labels = one.get("vertices")?.as_array()?;
        let corner = |label: &Value| {
            let found = poles
                .iter()
                .find(|(name, _)| Some(name.as_str()) == label.as_str());
            found.map(|(_, at)| *at)
        };
        labels.iter().map(corner).collect::<Option<Vec<Point>>>()
    });
    if let Some(corners) = corners {
        canvas.line(
            corners.iter().chain(corners.first()).copied(),
            Stroke::Construction,
        );
    }
}
