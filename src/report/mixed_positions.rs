//! Five positions of which some have come together: the pairs with their circles, and how the points
//! touch them.

use std::f64::consts::TAU;

use serde_json::{Value, json};

use super::canvas::{Canvas, Joint, Point, Stroke, distance};
use super::complex::{point, z};
use super::{finite_point, frames, number};
use crate::plane::displacement::Displacement;

/// Farther away than so many times the size of the positions a pair is told, not drawn.
const FAR: f64 = 3.0;
/// Points of a circle or a path.
const STEPS: u32 = 96;

/// A position with the derivatives of x, y and the angle.
struct Group {
    position: Displacement<f64>,
    derivatives: Vec<[f64; 3]>,
}

/// The picture; `None` where the pairs are not decided.
pub fn picture(problem: &Value, answer: &Value) -> Option<String> {
    let groups = groups(problem)?;
    let pairs: Vec<[Point; 2]> = answer
        .get("pairs")?
        .as_array()?
        .iter()
        .map(|pair| {
            Some([
                finite_point(&pair["circlepoint"])?,
                finite_point(&pair["center"])?,
            ])
        })
        .collect::<Option<_>>()?;
    let mut canvas = Canvas::new(
        &title(&groups, pairs.len()),
        "The positions of the moving plane as frames, and of each Burmester pair the circlepoint A in \
         these positions, its center B, the circle, and the path of A near each position, which touches \
         the circle as closely as positions have come together there.",
    );
    let origins: Vec<Point> = groups
        .iter()
        .map(|group| point(&group.position.translation))
        .collect();
    let size = size(&groups, &origins);
    let first = *origins.first()?;
    let is_near = |pair: &[Point; 2]| {
        let [circlepoint, center] = pair;
        let place = groups.first().map(|group| group.at(0.0, circlepoint));
        place.is_some_and(|place| distance(place, first) < FAR * size)
            && distance(*center, first) < FAR * size
    };
    for at in &origins {
        canvas.show(*at);
    }
    for pair in pairs.iter().filter(|pair| is_near(pair)) {
        canvas.show(pair[1]);
        groups
            .iter()
            .for_each(|group| canvas.show(group.at(0.0, &pair[0])));
    }
    for (place, pair) in pairs.iter().enumerate() {
        if is_near(pair) {
            draw(&mut canvas, &groups, pair, place + 1, size);
        } else {
            canvas.remark(&format!("too far away: A{0}, B{0}", place + 1));
        }
    }
    let positions: Vec<Displacement<f64>> =
        groups.into_iter().map(|group| group.position).collect();
    frames::draw(&mut canvas, &positions, size / 14.0);
    canvas.explain(
        Stroke::Bar,
        "the moving plane in its positions: x-axis long, y-axis short",
    );
    canvas.explain(Stroke::Guide, "circle about the center B");
    canvas.explain(
        Stroke::Path,
        "path of the circlepoint A near a position, by the given derivatives",
    );
    Some(canvas.to_svg())
}

/// The circle of a pair, and the paths that touch it.
fn draw(
    canvas: &mut Canvas,
    groups: &[Group],
    [circlepoint, center]: &[Point; 2],
    name: usize,
    size: f64,
) {
    let Some(start) = groups.first().map(|group| group.at(0.0, circlepoint)) else {
        return;
    };
    let radius = distance(start, *center);
    let on_circle = |step: u32| {
        let angle = TAU * f64::from(step) / f64::from(STEPS);
        [
            center[0] + radius * angle.cos(),
            center[1] + radius * angle.sin(),
        ]
    };
    canvas.background((0..=STEPS).map(on_circle).collect(), Stroke::Guide);
    for group in groups {
        if let Some(reach) = group.reach(circlepoint, size / 4.0) {
            let at = |step: u32| {
                let t = reach * (2.0 * f64::from(step) / f64::from(STEPS) - 1.0);
                group.at(t, circlepoint)
            };
            canvas.background((0..=STEPS).map(at).collect(), Stroke::Path);
        }
    }
    canvas.joint(*center, Joint::Fixed, &format!("B_{name}"));
    for (place, group) in groups.iter().enumerate() {
        let label = if place == 0 {
            format!("A_{name}")
        } else {
            String::new()
        };
        canvas.joint(group.at(0.0, circlepoint), Joint::Moving, &label);
    }
}

impl Group {
    /// Where a point of the moving plane is for a parameter, by the Taylor polynomials.
    fn at(&self, t: f64, [x, y]: &Point) -> Point {
        let mut sums = [0.0; 3];
        let mut power = 1.0;
        for (derivative, order) in self.derivatives.iter().zip(1..) {
            power *= t / f64::from(order);
            sums.iter_mut()
                .zip(derivative)
                .for_each(|(sum, d)| *sum += d * power);
        }
        let [dx, dy, angle] = sums;
        let turned = z(angle.cos(), angle.sin()) * &self.position.rotation * z(*x, *y);
        point(&(turned + &self.position.translation + z(dx, dy)))
    }

    /// The parameter at which a point has moved so far, by the first derivatives.
    fn reach(&self, at: &Point, length: f64) -> Option<f64> {
        let [dx, dy, angle] = self.derivatives.first()?;
        let [x, y] = point(&(&self.position.rotation * z(at[0], at[1])));
        let speed = (dx - angle * y).hypot(dy + angle * x);
        (speed > 0.0).then(|| length / speed)
    }
}

fn groups(problem: &Value) -> Option<Vec<Group>> {
    let list = problem.get("positions")?.as_array()?;
    let places = list
        .iter()
        .map(|one| json!({"x": one["x"], "y": one["y"], "angle": one["angle"]}));
    let positions = frames::positions(&json!({"positions": places.collect::<Vec<_>>()}))?;
    let groups = list.iter().zip(positions).map(|(one, position)| {
        let derivatives = one.get("derivatives").and_then(Value::as_array);
        let derivatives = derivatives.into_iter().flatten().map(|derivative| {
            Some([
                number(&derivative["x"])?,
                number(&derivative["y"])?,
                number(&derivative["angle"])?,
            ])
        });
        Some(Group {
            position,
            derivatives: derivatives.collect::<Option<_>>()?,
        })
    });
    groups.collect()
}

/// Of all positions, or of the motion about the only one: by how much the pole is away.
fn size(groups: &[Group], origins: &[Point]) -> f64 {
    match groups {
        [Group { derivatives, .. }] => match derivatives.first() {
            Some([x, y, angle]) if x.hypot(*y) > 0.0 && *angle != 0.0 => x.hypot(*y) / angle.abs(),
            _ => 1.0,
        },
        _ => frames::extent(origins),
    }
}

/// By how many positions have come together in each: PPP-P-P.
fn title(groups: &[Group], count: usize) -> String {
    let sizes = groups
        .iter()
        .map(|group| "P".repeat(group.derivatives.len() + 1));
    let pattern = sizes.collect::<Vec<_>>().join("-");
    match count {
        1 => format!("{pattern}: one real Burmester pair"),
        _ => format!("{pattern}: {count} real Burmester pairs"),
    }
}
