//! Places for the names of joints, apart from all that is drawn.

use super::canvas::{Point, distance, escaped};
use crate::number::count;

/// Places around a joint that are tried.
const WAYS: u32 = 24;
/// How far from its joint a name may be.
const RADII: [f64; 3] = [19.0, 24.0, 31.0];
/// Points of lines farther away than this do not matter.
const NEAR: f64 = 60.0;
/// The distance between the points by which a line is known.
const STEP: f64 = 5.0;

/// What is in the way of a name.
pub struct Labels {
    joints: Vec<Point>,
    lines: Vec<Point>,
    names: Vec<Point>,
    sides: [f64; 2],
}

impl Labels {
    /// Around these joints, between the sides of the page.
    pub fn new(joints: &[Point], sides: [f64; 2]) -> Self {
        Labels {
            joints: joints.to_vec(),
            lines: Vec::new(),
            names: Vec::new(),
            sides,
        }
    }

    /// A line that names keep away from.
    pub fn avoid(&mut self, line: &[Point]) {
        let joints = std::mem::take(&mut self.joints);
        let matters = |at: &Point| joints.iter().any(|joint| distance(*joint, *at) < NEAR);
        for ends in line.windows(2) {
            let [from, to] = ends else { continue };
            let length = distance(*from, *to);
            if !length.is_finite() || length > 1e5 {
                continue;
            }
            let steps = (length / STEP).ceil().max(1.0);
            let parts = std::iter::successors(Some(0.0), |step| Some(step + 1.0));
            for step in parts.take_while(|step| *step <= steps) {
                let part = step / steps;
                let ([x, y], [u, v]) = (from, to);
                let at = [x + part * (u - x), y + part * (v - y)];
                if matters(&at) {
                    self.lines.push(at);
                }
            }
        }
        self.joints = joints;
    }

    /// The middle of the name of the joint there.
    pub fn place(&mut self, joint: Point, name: &str) -> Point {
        let [x, y] = joint;
        let lines: Vec<Point> = self
            .lines
            .iter()
            .copied()
            .filter(|at| distance(*at, joint) < NEAR)
            .collect();
        // A name is wider than high.
        let half = 3.5 * count::to_f64(name.chars().filter(|letter| *letter != '_').count());
        let mut best = ([x + 14.0, y - 12.0], f64::NEG_INFINITY);
        for (rank, radius) in RADII.iter().enumerate() {
            for way in 0..WAYS {
                let angle = std::f64::consts::TAU * f64::from(way) / f64::from(WAYS) + 0.4;
                let at = [
                    x + (radius + half - 5.0) * angle.cos(),
                    y + radius * angle.sin(),
                ];
                let room = |points: &[Point], wanted: f64| {
                    points
                        .iter()
                        .filter(|other| **other != joint)
                        .map(|other| beside(&at, other, half) / wanted)
                        .fold(1.0, f64::min)
                };
                let [left, right] = self.sides;
                let inside = ((at[0] - left - half).min(right - half - at[0]) / 6.0).min(1.0);
                let score = room(&self.joints, 15.0)
                    .min(room(&lines, 11.0))
                    .min(room(&self.names, 24.0))
                    .min(inside)
                    - 0.12 * count::to_f64(rank);
                if score > best.1 + 1e-9 {
                    best = (at, score);
                }
            }
        }
        if !name.is_empty() {
            self.names.push(best.0);
        }
        best.0
    }
}

/// How far a point is from a name of this half width.
fn beside(name: &Point, point: &Point, half: f64) -> f64 {
    let across = ((name[0] - point[0]).abs() - (half - 4.0).max(0.0)).max(0.0);
    across.hypot(name[1] - point[1])
}

/// Names, what follows `_` in each as its index.
pub fn name_svg(names: &str) -> String {
    let mut svg = String::new();
    let mut is_below = false;
    for (place, name) in names.split(", ").enumerate() {
        let comma = match (place, is_below) {
            (0, _) => "",
            (_, true) => r#"<tspan dy="-4">, </tspan>"#,
            (_, false) => ", ",
        };
        svg.push_str(comma);
        let (name, index) = name.split_once('_').unwrap_or((name, ""));
        svg.push_str(&escaped(name));
        is_below = !index.is_empty();
        if is_below {
            let index = escaped(index);
            svg.push_str(&format!(r#"<tspan dy="4" font-size="12">{index}</tspan>"#));
        }
    }
    svg
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_keeps_away_from_lines_and_joints() {
        let joints = [[100.0, 100.0], [120.0, 100.0]];
        let mut labels = Labels::new(&joints, [0.0, 900.0]);
        labels.avoid(&[[100.0, 0.0], [100.0, 100.0], [200.0, 100.0]]);
        let [x, y] = labels.place(joints[0], "A");
        assert!(x < 90.0 || y > 110.0, "{x} {y}");
        let other = labels.place(joints[1], "B");
        assert!(distance([x, y], other) > 20.0);
    }

    #[test]
    fn an_index_is_set_below() {
        assert_eq!(name_svg("D"), "D");
        assert!(name_svg("P_12").starts_with("P<tspan"));
        assert_eq!(name_svg("P_12, P_13").matches(">12<").count(), 1);
    }
}
