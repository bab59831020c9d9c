//! Five positions: two centerpoint curves, whose meets are the centers, and the linkages of every two
//! pairs.

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke, distance};
use super::complex::{point, z};
use super::linkage_panels::{self, Linkage};
use super::{contour, finite_point, frames};
use crate::finite::four_positions::circle_conditions;
use crate::plane::displacement::Displacement;

/// Farther away than so many times the size of the positions a pair is told, not drawn.
const FAR: f64 = 3.0;

/// A circlepoint, as it lies in position 1, and its center.
struct Pair {
    circlepoint: Point,
    center: Point,
}

/// The picture; `None` for families of pairs and where the pairs are not decided.
pub fn picture(problem: &Value, answer: &Value) -> Option<String> {
    if !answer.get("family")?.is_null() || answer.get("counts")?.is_null() {
        return None;
    }
    let positions = <[_; 5]>::try_from(frames::positions(problem)?).ok()?;
    let pairs = pairs(answer, &positions)?;
    let mut canvas = Canvas::new(
        &title(pairs.len()),
        "The five positions of the moving plane as frames, the centerpoint curves of positions 1234 and \
         1235, and of each Burmester pair the circlepoint A in position 1 with its center B, where both \
         curves meet; below, the four-bar of every two pairs in its five positions.",
    );
    let origins = positions.each_ref().map(origin);
    let size = frames::extent(&origins);
    for at in origins {
        canvas.show(at);
    }
    let near = |pair: &Pair| {
        [pair.circlepoint, pair.center]
            .iter()
            .all(|at| distance(*at, origins[0]) < FAR * size)
    };
    let shown = |(_, pair): &(usize, &Pair)| near(pair);
    for (_, pair) in pairs.iter().enumerate().filter(shown) {
        canvas.show(pair.circlepoint);
        canvas.show(pair.center);
    }
    draw_curves(&mut canvas, &positions);
    for (_, pair) in pairs.iter().enumerate().filter(shown) {
        canvas.line([pair.center, pair.circlepoint], Stroke::Construction);
    }
    frames::draw(&mut canvas, &positions, size / 14.0);
    for (place, pair) in pairs.iter().enumerate().filter(shown) {
        canvas.joint(pair.center, Joint::Fixed, &format!("B_{}", place + 1));
        canvas.joint(pair.circlepoint, Joint::Moving, &format!("A_{}", place + 1));
    }
    explain(&mut canvas, pairs.iter().any(near));
    for (place, pair) in pairs.iter().enumerate().filter(|(_, pair)| !near(pair)) {
        canvas.remark(&format!(
            "too far away: A{0} ({1}), B{0} ({2})",
            place + 1,
            coordinates(pair.circlepoint),
            coordinates(pair.center)
        ));
    }
    let linkages = linkages(answer, &pairs, &positions);
    if !linkages.is_empty() {
        canvas.below(linkage_panels::draw(&linkages));
    }
    Some(canvas.to_svg())
}

fn title(count: usize) -> String {
    match count {
        0 => "Five positions: no real Burmester pair".to_owned(),
        1 => "Five positions: one real Burmester pair".to_owned(),
        _ => format!("Five positions: {count} real Burmester pairs"),
    }
}

fn explain(canvas: &mut Canvas, has_pairs: bool) {
    canvas.explain(
        Stroke::Bar,
        "the moving plane in its positions: x-axis long, y-axis short",
    );
    canvas.explain(Stroke::Curve, "centerpoint curve of positions 1, 2, 3, 4");
    canvas.explain(Stroke::Path, "centerpoint curve of positions 1, 2, 3, 5");
    canvas.remark("both curves meet in the centers, and in the poles 12, 13, 23");
    if has_pairs {
        canvas.explain(
            Stroke::Construction,
            "circlepoint A in position 1 and its center B",
        );
    }
}

fn origin(position: &Displacement<f64>) -> Point {
    point(&position.translation)
}

/// To four digits.
fn coordinates(at: Point) -> String {
    let short = |x: f64| {
        if x.abs() < 1e5 {
            let places = (3.0 - x.abs().max(1e-3).log10().floor()).clamp(0.0, 6.0);
            #[expect(clippy::as_conversions, reason = "a whole number from 0 to 6")]
            let places = places as usize;
            format!("{x:.places$}")
        } else {
            format!("{x:.3e}")
        }
    };
    at.map(short).join(", ")
}

fn pairs(answer: &Value, positions: &[Displacement<f64>; 5]) -> Option<Vec<Pair>> {
    let read = |pair: &Value| {
        let [x, y] = finite_point(pair.get("circlepoint")?)?;
        Some(Pair {
            circlepoint: point(&positions[0].of(&z(x, y))),
            center: finite_point(pair.get("center")?)?,
        })
    };
    answer.get("pairs")?.as_array()?.iter().map(read).collect()
}

fn draw_curves(canvas: &mut Canvas, positions: &[Displacement<f64>; 5]) {
    let window = canvas.window();
    let [a, b, c, d, e] = positions;
    for (last, stroke) in [(d, Stroke::Curve), (e, Stroke::Path)] {
        let four = [a, b, c, last].map(Clone::clone);
        let Some(cubic) = circle_conditions::centerpoint_cubic(&four) else {
            continue;
        };
        let value = |[x, y]: Point| cubic.at(&z(x, y)).0;
        let gap = [f64::NAN; 2];
        let pieces = contour::zero_set(value, window).into_iter();
        canvas.background(pieces.flat_map(|[p, q]| [p, q, gap]).collect(), stroke);
    }
}

/// The four-bars of the answer in their five positions.
fn linkages(answer: &Value, pairs: &[Pair], positions: &[Displacement<f64>; 5]) -> Vec<Linkage> {
    let list = answer.get("linkages").and_then(Value::as_array);
    let read = |one: &Value| {
        let numbers = one.get("pairs")?.as_array()?;
        let [first, second] = [0, 1].map(|side: usize| {
            let index = usize::try_from(numbers.get(side)?.as_u64()?).ok()?;
            Some((index, pairs.get(index)?))
        });
        let ((i, first), (j, second)) = (first?, second?);
        let back = positions[0].inverse();
        let joints = positions.each_ref().map(|position| {
            let place = |pair: &Pair| {
                let [x, y] = pair.circlepoint;
                point(&position.of(&back.of(&z(x, y))))
            };
            [place(first), place(second)]
        });
        let kind = one.get("type").and_then(Value::as_str);
        let defects = one.get("defects").and_then(Value::as_array);
        let defects = defects.into_iter().flatten().filter_map(Value::as_str);
        Some(Linkage {
            names: [i + 1, j + 1],
            pivots: [first.center, second.center],
            joints,
            kind: kind.unwrap_or("type undecided").replace('-', " "),
            defects: defects.map(str::to_owned).collect(),
        })
    };
    list.into_iter().flatten().filter_map(read).collect()
}
