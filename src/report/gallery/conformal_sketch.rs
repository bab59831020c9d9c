//! The sketch of a centerpoint curve by rule: a nodal curve with the right node and the right middle line,
//! over the curve as it is.

use std::f64::consts::PI;

use serde_json::Value;

use super::four_poles::{FourPoles, line, meet};
use crate::number::Number;
use crate::plane::circular_cubic::Cubic;
use crate::report::canvas::{Canvas, Joint, Point, Stroke, distance};
use crate::report::{centerpoint_curve, numbers};

const STEPS: u32 = 1600;

/// What the rules give.
struct Sketch {
    poles: FourPoles,
    /// From here the longest side is seen.
    q_max: Point,
    other: Point,
    /// Another point of the bisector that leads from Q_max to the node.
    along: Point,
    /// Where this bisector meets the middle line.
    node: Point,
    rule: char,
    /// The shortest and the longest side, and the two others.
    sums: [f64; 2],
}

impl Sketch {
    #[expect(
        clippy::indexing_slicing,
        reason = "places of four corners and sides, counted modulo four"
    )]
    fn of(poles: FourPoles) -> Option<Self> {
        let sides = poles.sides();
        let by_length = |a: &usize, b: &usize| sides[*a].total_cmp(&sides[*b]);
        let longest = (0..4).max_by(by_length)?;
        let shortest = (0..4).min_by(by_length)?;
        let [first, second] = poles.meets();
        // The longest side is seen from where its neighbours meet.
        let (q_max, other) = if longest % 2 == 0 {
            (second, first)
        } else {
            (first, second)
        };
        let ends = [longest, (longest + 1) % 4].map(|place| unit(q_max, poles.corners[place]));
        let inner = [ends[0][0] + ends[1][0], ends[0][1] + ends[1][1]];
        let is_opposite = (longest + 2) % 4 == shortest;
        let direction = if is_opposite {
            inner
        } else {
            [-inner[1], inner[0]]
        };
        let along = [q_max[0] + direction[0], q_max[1] + direction[1]];
        let sum = sides[longest] + sides[shortest];
        Some(Sketch {
            node: meet([q_max, along], poles.middle_line()),
            rule: if is_opposite { 'B' } else { 'A' },
            sums: [sum, sides.iter().sum::<f64>() - sum],
            poles,
            q_max,
            other,
            along,
        })
    }

    /// With the node H as origin and the middle line as s-axis a curve with perpendicular tangents in H and
    /// an asymptote parallel to the middle line is (s² + t²) t + a (s² − t²) + b s t = 0. Of these, that one
    /// which comes nearest to the six points.
    fn helper(&self) -> Vec<Point> {
        let [p, q] = self.poles.middle_line();
        let axis = unit(p, q);
        let mut sums = [0.0; 5];
        for at in self.poles.corners.iter().chain([&self.q_max, &self.other]) {
            let [x, y] = [at[0] - self.node[0], at[1] - self.node[1]];
            let (s, t) = (x * axis[0] + y * axis[1], y * axis[0] - x * axis[1]);
            let square = s * s + t * t;
            let (u, v) = ((s * s - t * t) / square, s * t / square);
            let terms = [u * u, u * v, v * v, u * t, v * t];
            for (sum, term) in sums.iter_mut().zip(terms) {
                *sum += term;
            }
        }
        let [uu, uv, vv, ut, vt] = sums;
        let det = uu * vv - uv * uv;
        let (a, b) = ((uv * vt - vv * ut) / det, (uv * ut - uu * vt) / det);
        let place = |step: u32| {
            let angle = PI * (f64::from(step) + 0.5) / f64::from(STEPS);
            let (sin, cos) = angle.sin_cos();
            let radius = -(a * (2.0 * angle).cos() + b * sin * cos) / sin;
            let (s, t) = (radius * cos, radius * sin);
            [
                self.node[0] + s * axis[0] - t * axis[1],
                self.node[1] + s * axis[1] + t * axis[0],
            ]
        };
        (0..STEPS).map(place).collect()
    }
}

/// The direction from one point to another.
fn unit(from: Point, to: Point) -> Point {
    let length = distance(from, to);
    [(to[0] - from[0]) / length, (to[1] - from[1]) / length]
}

/// The sketch over the curve of an answer; `None` where no pole quadrilateral is convex.
pub fn svg(answer: &Value) -> Option<String> {
    let (poles, _) = FourPoles::convex(answer)?;
    let sketch = Sketch::of(poles)?;
    let curve = answer.get("centerpoint")?;
    let coefficients: [f64; 10] = numbers(curve.get("coefficients")?)?;
    let kind = curve.get("type")?.as_str()?;
    let mut canvas = Canvas::new(
        "A conformal sketch",
        "A convex pole quadrilateral with the points in which opposite sides meet, the middle line, the \
         bisector that meets it in the point H, the nodal curve with H as its node, and the centerpoint \
         curve itself.",
    );
    for at in sketch
        .poles
        .corners
        .iter()
        .chain([&sketch.q_max, &sketch.other, &sketch.node])
    {
        canvas.show(*at);
    }
    // The curve goes out beyond its points.
    let (low, high) = canvas.window();
    canvas.show(low);
    canvas.show(high);
    let window = canvas.window();
    canvas.background(
        centerpoint_curve::within(sketch.helper(), window),
        Stroke::Stretch,
    );
    for piece in centerpoint_curve::pieces(&Cubic::new(coefficients.map(Number)), kind, window) {
        canvas.background(piece, Stroke::MainCurve);
    }
    let across = |ends| centerpoint_curve::across(line(ends), window);
    canvas.background(across(sketch.poles.middle_line()), Stroke::Base);
    canvas.background(across([sketch.q_max, sketch.along]), Stroke::Guide);
    let [a, b, c, d] = sketch.poles.corners;
    canvas.line([a, b, c, d, a], Stroke::Construction);
    for (at, ends) in [
        (sketch.poles.meets()[0], [b, c]),
        (sketch.poles.meets()[1], [b, d]),
    ] {
        for end in ends {
            canvas.line([at, end], Stroke::Construction);
        }
    }
    for (name, at) in sketch.poles.names.iter().zip(sketch.poles.corners) {
        canvas.joint(at, Joint::Mark, &format!("O_{name}"));
    }
    canvas.joint(sketch.q_max, Joint::Mark, "Q_max");
    canvas.joint(sketch.other, Joint::Mark, "Q");
    let index = if sketch.rule == 'A' { 'k' } else { 'b' };
    canvas.joint(sketch.node, Joint::Moving, &format!("H_{index}"));
    canvas.explain(Stroke::MainCurve, "centerpoint curve");
    canvas.explain(
        Stroke::Stretch,
        "the sketch: the nodal curve with H as node that comes nearest to six points",
    );
    canvas.explain(Stroke::Guide, "the bisector at Q_max");
    canvas.explain(Stroke::Base, "middle line");
    canvas.explain(
        Stroke::Construction,
        "pole quadrilateral, its sides prolonged",
    );
    let [u, z] = sketch.sums;
    let order = match u.total_cmp(&z) {
        std::cmp::Ordering::Less => '<',
        std::cmp::Ordering::Equal => '=',
        std::cmp::Ordering::Greater => '>',
    };
    canvas.remark(&format!(
        "rule 1.{}: U = {u:.3} {order} Z = {z:.3}",
        sketch.rule
    ));
    canvas.scale("units of the positions");
    Some(canvas.to_svg())
}
