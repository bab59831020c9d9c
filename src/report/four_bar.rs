//! A four-bar with the whole curve of its coupler point, the singular foci and the double points.

use std::f64::consts::TAU;

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke, spread};
use super::complex::{Z, z};
use super::straight_line::Linkage;
use super::{finite_point, number};
use crate::linkage::four_bar::third_corners;
use crate::number::Number;

/// Places of the crank among which one is chosen that is easy to read.
const PLACES: u32 = 48;
const STEPS: u32 = 360;

/// The picture; `None` for an answer without the numbers that it needs.
pub fn picture(answer: &Value) -> Option<String> {
    let linkage = Linkage::read(answer).or_else(|| assembled(answer))?;
    let mut canvas = Canvas::new(
        "A four-bar and its coupler curve",
        "The four-bar O_aABO_b with the point D of its coupler in one position, the whole curve of D, \
         the pivots of the four-bar and of its cognates, which are the singular foci of the curve, and \
         its double points on the circle through them.",
    );
    for branch in linkage.path() {
        canvas.line(without_jumps(branch), Stroke::MainPath);
    }
    if let Some(radius) = about_second_pivot(answer) {
        let [.., center, _] = linkage.joints();
        canvas.line(around(center, radius), Stroke::MainPath);
    }
    let foci: Vec<Point> = points(&answer["foci"], |focus| focus);
    for [_, pin] in cognate_bars(answer) {
        canvas.show(pin);
    }
    for bar in cognate_bars(answer) {
        canvas.line(bar, Stroke::Construction);
    }
    linkage.draw(&mut canvas);
    if let [_, _, third] = foci.as_slice() {
        canvas.joint(*third, Joint::Fixed, "O_c");
    }
    let double = points(&answer["double_points"], |found| &found["point"]);
    for at in &double {
        canvas.joint(*at, Joint::Mark, "");
    }
    if let Some(circle) = circle(answer, canvas.window()) {
        match circle {
            Circle::Whole(points) => canvas.line(points, Stroke::Guide),
            Circle::Part(points) => canvas.background(points, Stroke::Guide),
        }
        canvas.explain(Stroke::Guide, "circle through the three pivots");
    }
    canvas.explain(Stroke::MainPath, "curve of D");
    canvas.explain(Stroke::Crank, "cranks");
    if cognate_bars(answer).next().is_some() {
        canvas.explain(
            Stroke::Construction,
            "the two cognates, in the same position",
        );
    }
    let kind = answer["type"].as_str().unwrap_or("four-bar");
    let circuits = match answer["circuits"].as_u64() {
        Some(2) => "two circuits",
        _ => "one circuit",
    };
    canvas.remark(&format!("{kind}, {circuits}"));
    canvas.remark(&match double.len() {
        0 => "no real double point on the circle".to_owned(),
        1 => "one real double point on the circle (a dot)".to_owned(),
        many => format!("{many} real double points on the circle (dots)"),
    });
    Some(canvas.to_svg())
}

fn points<'a>(list: &'a Value, of: impl Fn(&'a Value) -> &'a Value) -> Vec<Point> {
    let list = list.as_array().into_iter().flatten();
    list.filter_map(|found| finite_point(of(found))).collect()
}

/// Bars of the cognates that the linkage does not have.
fn cognate_bars(answer: &Value) -> impl Iterator<Item = [Point; 2]> {
    let cognates = answer["cognates"].as_array().into_iter().flatten();
    cognates.flat_map(|cognate| {
        let at = |name: &str| finite_point(&cognate[name]);
        [
            ("O_a", "A"),
            ("A", "B"),
            ("B", "O_b"),
            ("A", "D"),
            ("B", "D"),
        ]
        .into_iter()
        .filter_map(move |(from, to)| Some([at(from)?, at(to)?]))
        .collect::<Vec<_>>()
    })
}

/// A position of a linkage that was given by its lengths.
fn assembled(answer: &Value) -> Option<Linkage> {
    let length = |name: &str| number(&answer[name]);
    let at = |name: &str| finite_point(&answer[name]).map(|[x, y]| z(x, y));
    let (o_a, o_b) = (at("O_a")?, at("O_b")?);
    let (r, s, t, m) = (length("R")?, length("S")?, length("T")?, length("M")?);
    let epsilon = answer
        .pointer("/epsilon/degrees")
        .and_then(number)
        .unwrap_or(0.0);
    let (sin, cos) = epsilon.to_radians().sin_cos();
    let shape = z(cos * m / s, sin * m / s);
    let linkage = |step: u32| -> Option<Linkage> {
        let (sin, cos) = (TAU * f64::from(step) / f64::from(PLACES)).sin_cos();
        let a: Z = &o_a + z(r * cos, r * sin);
        let [b, _] = third_corners(&a, &o_b, &Number(s * s), &Number(t * t))?;
        let (o_a, o_b) = (o_a.clone(), o_b.clone());
        let d = &a + &shape * (&b - &a);
        let linkage = Linkage { o_a, a, b, o_b, d };
        let known = linkage
            .joints()
            .as_flattened()
            .iter()
            .all(|x| x.is_finite());
        known.then_some(linkage)
    };
    let ease = |linkage: &Linkage| spread(&linkage.joints());
    (0..PLACES)
        .filter_map(linkage)
        .max_by(|x, y| ease(x).total_cmp(&ease(y)))
}

/// Where A passes through O_b, B is not determined, and left and right change places.
fn without_jumps(path: Vec<Point>) -> Vec<Point> {
    let known = path.iter().filter(|[x, y]| x.is_finite() && y.is_finite());
    let size = known
        .flat_map(|[x, y]| [x.abs(), y.abs()])
        .fold(0.0, f64::max);
    let mut whole: Vec<Point> = Vec::with_capacity(path.len());
    for at in path {
        let jumps = whole
            .last()
            .is_some_and(|[x, y]| (x - at[0]).hypot(y - at[1]) > size / 8.0);
        if jumps {
            whole.push([f64::NAN; 2]);
        }
        whole.push(at);
    }
    whole
}

/// The radius of the part of the curve in which A stays in O_b, in a kite or rhombus.
fn about_second_pivot(answer: &Value) -> Option<f64> {
    let length = |name: &str| number(&answer[name]);
    let alike = |x: f64, y: f64| (x - y).abs() < 1e-9 * x;
    let kite = alike(length("Q")?, length("R")?) && alike(length("S")?, length("T")?);
    kite.then(|| length("M"))?
}

fn around(center: Point, radius: f64) -> Vec<Point> {
    let at = |step: u32| {
        let (sin, cos) = (TAU * f64::from(step) / f64::from(STEPS)).sin_cos();
        [center[0] + radius * cos, center[1] + radius * sin]
    };
    (0..=STEPS).map(at).collect()
}

/// The circle through the foci.
enum Circle {
    /// It fits into the picture.
    Whole(Vec<Point>),
    /// A line, or too large.
    Part(Vec<Point>),
}

/// a (x² + y²) + b x + c y + d = 0, a line across the window for a = 0.
fn circle(answer: &Value, (low, high): (Point, Point)) -> Option<Circle> {
    let [a, b, c, d] = super::numbers::<4>(&answer["circle"])?;
    let size = (high[0] - low[0]).hypot(high[1] - low[1]);
    let straight = b.hypot(c);
    if a.abs() * size < 1e-6 * straight {
        let foot = [-b * d / straight.powi(2), -c * d / straight.powi(2)];
        let along = [-c / straight, b / straight];
        let end = |far: f64| [foot[0] + far * along[0], foot[1] + far * along[1]];
        let far = size + foot[0].hypot(foot[1]) + low[0].hypot(low[1]) + high[0].hypot(high[1]);
        return Some(Circle::Part(vec![end(-far), end(far)]));
    }
    let center = [-b / (2.0 * a), -c / (2.0 * a)];
    let square = center[0].powi(2) + center[1].powi(2) - d / a;
    let radius = (square >= 0.0).then(|| square.sqrt())?;
    let points = around(center, radius);
    Some(if 2.0 * radius < size {
        Circle::Whole(points)
    } else {
        Circle::Part(points)
    })
}
