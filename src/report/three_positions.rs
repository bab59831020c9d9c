//! Three positions of circlepoints with their centers.

use std::f64::consts::TAU;

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::complex::{point, z};
use super::{finite_point, frames, number, poles};

/// The picture; `None` where nothing is finite.
pub fn picture(problem: &Value, answer: &Value) -> Option<String> {
    let positions = frames::positions(problem)?;
    let mut canvas = Canvas::new(
        "Three positions: circlepoints and their centers",
        "The three positions of the moving plane, the triangle of their poles with its circumscribed \
         circle, and each circlepoint in its three places with the circle through them, their \
         perpendicular bisectors, and the center.",
    );
    let triangle = poles::finite(answer.get("poles")?);
    let mut points: Vec<Point> = triangle.iter().map(|(_, at)| *at).collect();
    points.extend(
        positions
            .iter()
            .map(|p| [p.translation.re().0, p.translation.im().0]),
    );
    frames::draw(&mut canvas, &positions, frames::extent(&points) / 12.0);
    let corners: Vec<Point> = triangle.iter().map(|(_, at)| *at).collect();
    canvas.line(corners.iter().chain(corners.first()).copied(), Stroke::Base);
    for (place, pair) in answer.get("pairs")?.as_array()?.iter().enumerate() {
        draw_pair(&mut canvas, place, pair, &positions);
    }
    let circle = answer
        .get("centers_of_lines")
        .filter(|circle| !circle.is_null());
    if let Some((center, radius)) = circle.and_then(center_and_radius) {
        canvas.background(circle_points(center, radius), Stroke::Curve);
    }
    for (name, at) in &triangle {
        canvas.joint(*at, Joint::Mark, &format!("P_{name}"));
    }
    canvas.explain(
        Stroke::Bar,
        "the moving plane in its positions: x-axis long, y-axis short",
    );
    canvas.explain(Stroke::Base, "triangle of the poles");
    canvas.explain(
        Stroke::Curve,
        "centers of links that slide: circlepoint at infinity",
    );
    canvas.explain(
        Stroke::MainPath,
        "circle of a circlepoint A about its center B",
    );
    canvas.explain(Stroke::Construction, "perpendicular bisectors");
    Some(canvas.to_svg())
}

fn center_and_radius(circle: &Value) -> Option<(Point, f64)> {
    Some((
        finite_point(circle.get("center")?)?,
        number(circle.get("radius")?)?,
    ))
}

fn circle_points([x, y]: Point, radius: f64) -> Vec<Point> {
    (0..=180)
        .map(|step| {
            let angle = f64::from(step) * TAU / 180.0;
            [x + radius * angle.cos(), y + radius * angle.sin()]
        })
        .collect()
}

fn draw_pair(
    canvas: &mut Canvas,
    place: usize,
    pair: &Value,
    positions: &[crate::plane::displacement::Displacement<f64>],
) {
    let index = if place > 0 {
        (place + 1).to_string()
    } else {
        String::new()
    };
    let circlepoint = pair.get("circlepoint").and_then(finite_point);
    let center = pair.get("center").and_then(finite_point);
    let places: Vec<Point> = circlepoint
        .map(|[x, y]| positions.iter().map(|p| point(&p.of(&z(x, y)))).collect())
        .unwrap_or_default();
    if let (Some(center), Some([x, y])) = (center, places.first()) {
        let radius = (x - center[0]).hypot(y - center[1]);
        canvas.line(circle_points(center, radius), Stroke::MainPath);
        for (from, to) in places.iter().zip(places.iter().skip(1)) {
            let middle = [(from[0] + to[0]) / 2.0, (from[1] + to[1]) / 2.0];
            canvas.line([middle, center], Stroke::Construction);
        }
        canvas.line([center, [*x, *y]], Stroke::Crank);
    }
    for (number, at) in places.iter().enumerate() {
        canvas.joint(*at, Joint::Moving, &format!("A_{index}({})", number + 1));
    }
    if let Some(center) = center {
        canvas.joint(center, Joint::Fixed, &format!("B_{index}"));
    }
}
