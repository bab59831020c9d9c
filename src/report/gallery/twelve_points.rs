//! Twelve points of the centerpoint curve by reflection on lines through the focus.

use serde_json::Value;

use super::four_poles::{FourPoles, is_within, line, meet, mirrored};
use crate::number::Number;
use crate::plane::circular_cubic::Cubic;
use crate::report::canvas::{Canvas, Joint, Point, Stroke};
use crate::report::{centerpoint_curve, finite_point, numbers};

/// The six points, their reflections and, for comparison, their mirror images in the middle line.
pub fn svg(answer: &Value) -> Option<String> {
    let (poles, _) = FourPoles::convex(answer)?;
    let curve = answer.get("centerpoint")?;
    let coefficients: [f64; 10] = numbers(curve.get("coefficients")?)?;
    let kind = curve.get("type")?.as_str()?;
    let focus = finite_point(curve.get("focus")?)?;
    let middle_line = poles.middle_line();
    let asymptote = {
        let image = mirrored(focus, middle_line);
        let [p, q] = middle_line;
        [image, [image[0] + q[0] - p[0], image[1] + q[1] - p[1]]]
    };
    let [first, second] = poles.meets();
    let mut known: Vec<(Point, String)> = poles
        .corners
        .into_iter()
        .zip(poles.names.iter().map(|name| format!("O_{name}")))
        .collect();
    known.extend([(first, "Q".to_owned()), (second, "Q'".to_owned())]);
    let mut canvas = Canvas::new(
        "Twelve points of the curve",
        "The centerpoint curve, its focus F, the middle line and the asymptote, which is the mirror image \
         in it of the parallel through F; four poles, the two points in which opposite sides meet, and \
         the six points of the curve that are found from them on lines through F.",
    );
    for (at, _) in &known {
        canvas.show(*at);
    }
    canvas.show(focus);
    let window = canvas.window();
    for piece in centerpoint_curve::pieces(&Cubic::new(coefficients.map(Number)), kind, window) {
        canvas.background(piece, Stroke::MainCurve);
    }
    let across = |ends| centerpoint_curve::across(line(ends), window);
    canvas.background(across(middle_line), Stroke::Base);
    canvas.background(across(asymptote), Stroke::Guide);
    let size = (window.1[0] - window.0[0]) / 110.0;
    for (at, name) in &known {
        let half = meet([focus, *at], middle_line);
        let image = [2.0 * half[0] - at[0], 2.0 * half[1] - at[1]];
        if is_within(image, window) {
            canvas.line([*at, image], Stroke::Construction);
            canvas.joint(image, Joint::Moving, "");
        }
        let [x, y] = mirrored(*at, middle_line);
        if is_within([x, y], window) {
            let cross = |sign: f64| vec![[x - size, y - sign * size], [x + size, y + sign * size]];
            canvas.background(cross(1.0), Stroke::Path);
            canvas.background(cross(-1.0), Stroke::Path);
        }
        canvas.joint(*at, Joint::Mark, name);
    }
    canvas.joint(focus, Joint::Moving, "F");
    canvas.explain(Stroke::MainCurve, "centerpoint curve");
    canvas.explain(
        Stroke::Construction,
        "from a known point (dot) through F to a new one (circle); the middle line bisects it",
    );
    canvas.explain(
        Stroke::Path,
        "crosses: mirror images in the middle line, which are not on the curve",
    );
    canvas.explain(Stroke::Base, "middle line");
    canvas.explain(Stroke::Guide, "asymptote");
    canvas.scale("units of the positions");
    Some(canvas.to_svg())
}
