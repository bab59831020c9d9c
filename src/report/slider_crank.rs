//! A slider-crank in one position, seen from its pole, with its two alternates.

use std::f64::consts::TAU;

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::{contour, number};
use crate::oracle::rays;

/// Farther away than so many diameters of the inflection circle a point is told, not drawn.
const FAR: f64 = 4.0;
/// Points of a circle.
const STEPS: u32 = 96;

/// A Burmester point with its center, each along its ray; infinite ones are missing.
struct Pair {
    name: char,
    point: Option<Point>,
    center: Option<Point>,
}

/// The picture, in units of the diameter of the inflection circle.
pub fn picture(problem: &Value, answer: &Value) -> Option<String> {
    let [a, d] = rays(problem).ok()?;
    let pairs = [
        Pair::new('a', Some(a), &answer["PA"], &answer["PO_a"]),
        Pair::new('b', ray(&answer["alpha_b"]), &answer["PB"], &answer["PO_b"]),
        Pair::new('c', ray(&answer["alpha_c"]), &answer["PC"], &answer["PO_c"]),
    ];
    let pin = number(&answer["PD"]).map(|length| d.map(|part| part * length))?;
    let mut canvas = Canvas::new(
        "A slider-crank and its alternates",
        "The pole P with the pole tangent as x-axis, the inflection circle, the cubic of stationary \
         curvature, the crank from its support Oa to A, the slider's pin D with its line, and the two \
         other Burmester points B and C with their centers.",
    );
    for at in [[0.0, 0.0], [0.0, 1.0], pin] {
        canvas.show(at);
    }
    for at in pairs.iter().flat_map(Pair::points).filter(near) {
        canvas.show(at);
    }
    draw_cubic(&mut canvas, number(&answer["N"]), d);
    let on_circle = |step: u32| {
        let angle = TAU * f64::from(step) / f64::from(STEPS);
        [angle.cos() / 2.0, (1.0 + angle.sin()) / 2.0]
    };
    canvas.line((0..=STEPS).map(on_circle), Stroke::Guide);
    // D goes across its ray.
    let along = [-d[1], d[0]].map(|part| part / 4.0);
    let end = |sign: f64| [pin[0] + sign * along[0], pin[1] + sign * along[1]];
    canvas.line([end(-1.0), end(1.0)], Stroke::Base);
    for pair in &pairs {
        pair.draw(&mut canvas);
    }
    canvas.joint(pin, Joint::Moving, "D");
    canvas.joint([0.0, 0.0], Joint::Mark, "P");
    canvas.scale("diameters of the inflection circle");
    canvas.explain(
        Stroke::Guide,
        "inflection circle, its diameter the unit; the pole tangent is horizontal",
    );
    canvas.explain(Stroke::Curve, "cubic of stationary curvature");
    canvas.explain(Stroke::Crank, "crank");
    canvas.explain(Stroke::Base, "line of the slider");
    canvas.explain(Stroke::Construction, "Burmester point B, C and its center");
    Some(canvas.to_svg())
}

fn near([x, y]: &Point) -> bool {
    x.hypot(*y) < FAR
}

/// The direction of an angle in degrees.
fn ray(angle: &Value) -> Option<Point> {
    let (sin, cos) = number(&angle["degrees"])?.to_radians().sin_cos();
    Some([cos, sin])
}

impl Pair {
    fn new(name: char, ray: Option<Point>, point: &Value, center: &Value) -> Self {
        let place = |length: &Value| {
            let length = number(length)?;
            Some(ray?.map(|part| part * length))
        };
        Pair {
            name,
            point: place(point),
            center: place(center),
        }
    }

    /// Those that are finite.
    fn points(&self) -> impl Iterator<Item = Point> {
        self.point.into_iter().chain(self.center)
    }

    fn draw(&self, canvas: &mut Canvas) {
        let name = self.name;
        let capital = name.to_ascii_uppercase();
        let [point, center] = [self.point, self.center].map(|at| at.filter(near));
        if let (Some(point), Some(center)) = (point, center) {
            let stroke = if name == 'a' {
                Stroke::Crank
            } else {
                Stroke::Construction
            };
            canvas.line([center, point], stroke);
        }
        match center {
            Some(center) => canvas.joint(center, Joint::Fixed, &format!("O_{name}")),
            None => canvas.remark(&format!(
                "the center of {capital} is far away, or none is real"
            )),
        }
        match point {
            Some(point) => canvas.joint(point, Joint::Moving, &capital.to_string()),
            None => canvas.remark(&format!("{capital} is far away, or not real")),
        }
    }
}

/// (x² + y²)((a₃ + 3) x + b₃ y) = 3xy with a₃ = −3 tan α_d/N and b₃ = 3/N.
fn draw_cubic(canvas: &mut Canvas, n: Option<f64>, [cos, sin]: Point) {
    let Some(n) = n.filter(|n| *n != 0.0) else {
        return;
    };
    let value = |[x, y]: Point| {
        let line = (n * cos - sin) * x + cos * y;
        (x * x + y * y) * line - n * cos * x * y
    };
    let gap = [f64::NAN; 2];
    let pieces = contour::zero_set(value, canvas.window()).into_iter();
    canvas.background(
        pieces.flat_map(|[p, q]| [p, q, gap]).collect(),
        Stroke::Curve,
    );
}
