//! The poles of several positions.

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::{finite_point, frames};

/// The picture; `None` where neither a position nor a pole is finite.
pub fn picture(problem: &Value, answer: &Value) -> Option<String> {
    let positions = frames::positions(problem)?;
    let mut canvas = Canvas::new(
        "Poles of the positions",
        "The positions of the moving plane as frames with their numbers, and the finite poles: the \
         points about which the plane turns from one position into another.",
    );
    let poles = finite(answer.get("poles")?);
    let mut points: Vec<Point> = poles.iter().map(|(_, at)| *at).collect();
    points.extend(
        positions
            .iter()
            .map(|p| [p.translation.re().0, p.translation.im().0]),
    );
    frames::draw(&mut canvas, &positions, frames::extent(&points) / 12.0);
    for (name, at) in &poles {
        canvas.joint(*at, Joint::Mark, &format!("P_{name}"));
    }
    canvas.explain(
        Stroke::Bar,
        "the moving plane in its positions: x-axis long, y-axis short",
    );
    Some(canvas.to_svg())
}

/// The finite ones of labelled points.
pub fn finite(points: &Value) -> Vec<(String, Point)> {
    let fields = points.as_object();
    fields
        .into_iter()
        .flatten()
        .filter_map(|(name, value)| Some((name.clone(), finite_point(value)?)))
        .collect()
}
