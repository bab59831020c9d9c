//! Constructions with opposite sides of a pole quadrilateral, over the centerpoint curve.

use serde_json::Value;

use super::four_poles::{FourPoles, around, circle_through, is_within, middle};
use crate::report::canvas::{Joint, Point, Stroke, distance, spread};
use crate::report::centerpoint_curve;

/// Where opposite sides meet there is a centerpoint; the circles through it and the ends of one of the
/// other two sides meet again in the focus.
pub fn focus(problem: &Value, answer: &Value) -> Option<String> {
    let mut canvas = centerpoint_curve::canvas(problem, answer)?;
    let (poles, _) = FourPoles::of(answer).into_iter().next()?;
    let [a, b, c, d] = poles.corners;
    let window = canvas.window();
    let [first, second] = poles.meets();
    let near = |at: &Point| is_within(*at, window);
    for (at, sides) in [(first, [[b, c], [a, d]]), (second, [[a, b], [c, d]])] {
        if !near(&at) {
            continue;
        }
        for [p, q] in sides {
            canvas.background(around(circle_through(at, p, q)), Stroke::Curve);
            for end in [p, q] {
                canvas.background(vec![at, end], Stroke::Construction);
            }
        }
        canvas.joint(at, Joint::Mark, if at == first { "Q" } else { "Q'" });
    }
    canvas.explain(
        Stroke::Curve,
        "thin circles through a point Q in which opposite sides meet: they meet again in F",
    );
    Some(canvas.to_svg())
}

/// Two centers K from which the first and the third side are seen under one angle, with the circles over
/// these sides.
pub fn equal_angles(problem: &Value, answer: &Value) -> Option<String> {
    let mut canvas = centerpoint_curve::canvas(problem, answer)?;
    let (poles, _) = FourPoles::of(answer).into_iter().next()?;
    let [a, b, c, d] = poles.corners;
    let window = canvas.window();
    // From a centerpoint AB and DC are seen under equal angles.
    let found = (1..36).filter_map(|step| {
        let degrees = 5.0 * f64::from(step);
        let circles = [[a, b], [d, c]].map(|side| seen_under(side, degrees.to_radians()));
        let centers = common_points(circles)?;
        let room = spread(&[&poles.corners[..], &centers[..]].concat());
        let is_near = centers.iter().all(|at| is_within(*at, window));
        is_near.then_some((room, degrees, circles, centers))
    });
    let (_, degrees, circles, centers) = found.max_by(|x, y| x.0.total_cmp(&y.0))?;
    for circle in circles {
        canvas.background(around(circle), Stroke::Curve);
        canvas.joint(circle.0, Joint::Mark, "");
    }
    for (center, name) in centers.into_iter().zip(["K", "K'"]) {
        for corner in poles.corners {
            canvas.background(vec![center, corner], Stroke::Path);
        }
        canvas.joint(center, Joint::Fixed, name);
    }
    let [first, second, third, fourth] = &poles.names;
    canvas.explain(
        Stroke::Curve,
        &format!(
            "thin circles: the points that see P{first}P{second} and P{fourth}P{third} under {degrees}° (mod 180°)"
        ),
    );
    canvas.explain(Stroke::Path, "the two pairs of equal angles at K and at K'");
    Some(canvas.to_svg())
}

/// The circle of the points from which a segment is seen under this directed angle, mod π.
fn seen_under([p, q]: [Point; 2], angle: f64) -> (Point, f64) {
    let at = middle(p, q);
    let part = 0.5 / angle.tan();
    let center = [at[0] - (q[1] - p[1]) * part, at[1] + (q[0] - p[0]) * part];
    (center, distance(center, p))
}

fn common_points([(c, r), (d, s)]: [(Point, f64); 2]) -> Option<[Point; 2]> {
    let base = distance(c, d);
    let along = (base * base + r * r - s * s) / (2.0 * base);
    let square = r * r - along * along;
    let unit = [(d[0] - c[0]) / base, (d[1] - c[1]) / base];
    let across = square.sqrt();
    let at = |sign: f64| {
        [
            c[0] + along * unit[0] - sign * across * unit[1],
            c[1] + along * unit[1] + sign * across * unit[0],
        ]
    };
    (square > 0.0).then(|| [at(1.0), at(-1.0)])
}
