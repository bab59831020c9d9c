//! A quadrilateral of poles, and lines and circles that belong to it.

use serde_json::Value;

use crate::report::canvas::{Point, distance};
use crate::report::poles;

/// Its corners with their names, in their order round it.
pub struct FourPoles {
    pub corners: [Point; 4],
    pub names: [String; 4],
}

impl FourPoles {
    /// Those quadrilaterals of an answer whose poles are all finite, with their shapes.
    pub fn of(answer: &Value) -> Vec<(FourPoles, &Value)> {
        let poles = answer.get("poles").map(poles::finite).unwrap_or_default();
        let list = answer.get("quadrilaterals").and_then(Value::as_array);
        let read = |one: &Value| -> Option<FourPoles> {
            let labels = one.get("vertices")?.as_array()?.iter();
            let corners: Option<Vec<(String, Point)>> = labels
                .map(|label| {
                    let found = poles
                        .iter()
                        .find(|(name, _)| Some(name.as_str()) == label.as_str());
                    found.cloned()
                })
                .collect();
            let (names, corners): (Vec<String>, Vec<Point>) = corners?.into_iter().unzip();
            Some(FourPoles {
                corners: corners.try_into().ok()?,
                names: names.try_into().ok()?,
            })
        };
        let list = list.into_iter().flatten();
        list.filter_map(|one| Some((read(one)?, one))).collect()
    }

    /// The convex one.
    pub fn convex(answer: &Value) -> Option<(FourPoles, &Value)> {
        let mut all = FourPoles::of(answer).into_iter();
        all.find(|(_, one)| one["shape"] == "convex")
    }

    /// Where the first and the third side meet, and the second and the fourth.
    pub fn meets(&self) -> [Point; 2] {
        let [a, b, c, d] = self.corners;
        [meet([a, b], [c, d]), meet([b, c], [d, a])]
    }

    /// Two points of the line through the midpoints of the diagonals.
    pub fn middle_line(&self) -> [Point; 2] {
        let [a, b, c, d] = self.corners;
        [middle(a, c), middle(b, d)]
    }

    /// The lengths of the sides.
    pub fn sides(&self) -> [f64; 4] {
        let [a, b, c, d] = self.corners;
        [
            distance(a, b),
            distance(b, c),
            distance(c, d),
            distance(d, a),
        ]
    }
}

pub fn middle(p: Point, q: Point) -> Point {
    [(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0]
}

/// Where two lines meet; not finite where they are parallel.
pub fn meet([p, q]: [Point; 2], [r, s]: [Point; 2]) -> Point {
    let (u, v) = ([q[0] - p[0], q[1] - p[1]], [s[0] - r[0], s[1] - r[1]]);
    let area = u[0] * v[1] - u[1] * v[0];
    let t = ((r[0] - p[0]) * v[1] - (r[1] - p[1]) * v[0]) / area;
    [p[0] + t * u[0], p[1] + t * u[1]]
}

/// The coefficients A, B, C of the line through two points.
pub fn line([p, q]: [Point; 2]) -> [f64; 3] {
    let [a, b] = [q[1] - p[1], p[0] - q[0]];
    [a, b, -(a * p[0] + b * p[1])]
}

/// The mirror image of a point in a line.
pub fn mirrored(point: Point, ends: [Point; 2]) -> Point {
    let [a, b, c] = line(ends);
    let twice = 2.0 * (a * point[0] + b * point[1] + c) / (a * a + b * b);
    [point[0] - a * twice, point[1] - b * twice]
}

/// The circle through three points: its center and its radius.
pub fn circle_through(p: Point, q: Point, r: Point) -> (Point, f64) {
    let across = |from: Point, to: Point| {
        let at = middle(from, to);
        [at, [at[0] + from[1] - to[1], at[1] + to[0] - from[0]]]
    };
    let center = meet(across(p, q), across(q, r));
    (center, distance(center, p))
}

/// Points of a circle.
pub fn around((center, radius): (Point, f64)) -> Vec<Point> {
    let at = |step: u32| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(step) / 180.0).sin_cos();
        [center[0] + radius * cos, center[1] + radius * sin]
    };
    (0..=180).map(at).collect()
}

/// Whether a point is in the window.
pub fn is_within([x, y]: Point, ([x0, y0], [x1, y1]): (Point, Point)) -> bool {
    x > x0 && x < x1 && y > y0 && y < y1
}
