//! The stretches of the centerpoint curve that fulfil all wishes.

use std::f64::consts::{PI, TAU};

use serde_json::Value;

use super::canvas::Point;
use super::complex::z;
use super::{centerpoint_curve, finite_point, number};
use crate::plane::circular_cubic::Cubic;
use crate::plane::trace::Branch;

/// Points of each branch.
const STEPS: u32 = 4000;

/// The stretches as rows of points.
pub fn pieces(answer: &Value, cubic: &Cubic<f64>, kind: &str) -> Vec<Vec<Point>> {
    let Some(trace) = centerpoint_curve::trace(cubic, kind) else {
        return Vec::new();
    };
    let list = answer.get("stretches").and_then(Value::as_array);
    let stretches = list.into_iter().flatten();
    stretches
        .filter_map(|stretch| {
            let place = stretch.get("branch")?.as_u64()?.checked_sub(1)?;
            let branch = *trace.branches().get(usize::try_from(place).ok()?)?;
            // Opposite points of the circle have one image on each of two branches.
            let whole = if branch == Branch::Only { TAU } else { PI };
            let points: Vec<[f64; 3]> = (0..STEPS)
                .map(|step| {
                    let angle = whole * f64::from(step) / f64::from(STEPS);
                    // The trace turns round in a node, a stretch goes straight on.
                    let turns = kind == "nodal" && angle > PI;
                    let angle = if turns { 3.0 * PI - angle } else { angle };
                    let at = trace.point(branch, &z(angle.cos(), angle.sin()));
                    at.coordinates().each_ref().map(|x| x.0)
                })
                .collect();
            part(stretch, &points)
        })
        .collect()
}

/// The points of a closed row between the ends of a stretch, on that way which passes its sample.
fn part(stretch: &Value, points: &[[f64; 3]]) -> Option<Vec<Point>> {
    let finite = |[x, y, w]: &[f64; 3]| [x / w, y / w];
    let sample = nearest(stretch.get("sample")?.get("center")?, points)?;
    let count = points.len();
    let ends = ["from", "to"].map(|end| nearest(stretch.get(end)?, points));
    let [Some(from), Some(to)] = ends else {
        let round = points.iter().chain(points.first());
        return Some(round.map(finite).collect());
    };
    let way = |first: usize, last: usize| (last + count - first) % count;
    let (first, last) = if way(from, sample) <= way(from, to) {
        (from, to)
    } else {
        (to, from)
    };
    let length = if first == last {
        count
    } else {
        way(first, last)
    };
    let round = points.iter().cycle().skip(first);
    let mut piece: Vec<Point> = round.take(length + 1).map(finite).collect();
    // The row only comes near the ends.
    let [start, end] = if first == from {
        ["from", "to"]
    } else {
        ["to", "from"]
    };
    let given = |name: &str| stretch.get(name).and_then(finite_point);
    if let (Some(place), Some(start)) = (piece.first_mut(), given(start)) {
        *place = start;
    }
    if let (Some(place), Some(end)) = (piece.last_mut(), given(end)) {
        *place = end;
    }
    Some(piece)
}

/// The place of the point that is nearest to one of the answer, finite or not.
fn nearest(point: &Value, points: &[[f64; 3]]) -> Option<usize> {
    let target = finite_point(point);
    if target.is_none() && point.get("at_infinity").is_none() {
        return None;
    }
    let distance = |[x, y, w]: &[f64; 3]| match target {
        Some([u, v]) => (x / w - u).hypot(y / w - v),
        None => w.abs() / x.hypot(*y),
    };
    let distances = points.iter().map(distance).enumerate();
    let (place, _) = distances.min_by(|(_, one), (_, other)| one.total_cmp(other))?;
    Some(place)
}

/// The region where centers are wished, by its corners.
pub fn region(problem: &Value) -> Option<Vec<Point>> {
    let region = problem.get("wishes")?.get("pivots_within")?;
    let corners = |name: &str| -> Option<Vec<Point>> {
        region
            .get(name)?
            .as_array()?
            .iter()
            .map(finite_point)
            .collect()
    };
    if let Some(circle) = region.get("circle") {
        let [x, y] = finite_point(circle.get("center")?)?;
        let radius = number(circle.get("radius")?)?;
        let angle = |step: u32| TAU * f64::from(step) / 120.0;
        let at = |angle: f64| [x + radius * angle.cos(), y + radius * angle.sin()];
        return Some((0..120).map(|step| at(angle(step))).collect());
    }
    match corners("box").as_deref() {
        Some([[x0, y0], [x1, y1]]) => Some(vec![[*x0, *y0], [*x1, *y0], [*x1, *y1], [*x0, *y1]]),
        _ => corners("polygon"),
    }
}
