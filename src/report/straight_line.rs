//! A straight-line linkage in its design position, with the whole path of its point.

use std::f64::consts::TAU;

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::complex::{Z, point, z};
use super::{finite_point, number};
use crate::linkage::four_bar::third_corners;
use crate::plane::relation::distance_squared;

/// Steps of a full turn of the crank.
const STEPS: u32 = 1440;

/// The joints.
pub(super) struct Linkage {
    pub(super) o_a: Z,
    pub(super) a: Z,
    pub(super) b: Z,
    pub(super) o_b: Z,
    pub(super) d: Z,
}

/// The picture of the first linkage of the answer; `None` where there is none.
pub fn picture(answer: &Value) -> Option<String> {
    let linkages: Vec<&Value> = answer["solutions"]
        .as_array()?
        .iter()
        .filter_map(|solution| solution["linkages"].as_array())
        .flatten()
        .filter(|linkage| linkage.get("none").is_none())
        .collect();
    let shown = linkages.first()?;
    let linkage = Linkage::read(shown)?;
    let mut canvas = Canvas::new(
        "A straight-line linkage",
        "The four-bar O_aABO_b with the point D of its coupler in the design position, the whole path \
         of D, and the line that it keeps to.",
    );
    let joints = linkage.joints();
    for branch in linkage.path() {
        canvas.line(branch, Stroke::MainPath);
    }
    let direction = finite_point(&shown["direction"])?;
    let [.., end] = joints;
    let met: Vec<Point> = shown["places"]
        .as_array()
        .into_iter()
        .flatten()
        .filter(|place| place.get("contact").is_some())
        .filter_map(|place| finite_point(&place["D"]))
        .collect();
    let far = met
        .iter()
        .map(|[x, y]| [2.2 * x - 1.2 * end[0], 2.2 * y - 1.2 * end[1]]);
    let size = joints
        .into_iter()
        .chain(far)
        .map(|[x, y]| (x - end[0]).hypot(y - end[1]) / 2.0)
        .fold(0.0, f64::max);
    let along = |sign: f64| {
        let [x, y] = point(&linkage.d);
        let [u, v] = direction.map(|part| part * sign * size / direction[0].hypot(direction[1]));
        [x + u, y + v]
    };
    canvas.line([along(-1.0), along(1.0)], Stroke::Guide);
    linkage.draw(&mut canvas);
    for (number, at) in met.into_iter().enumerate() {
        canvas.joint(at, Joint::Mark, &format!("D_{}", number + 2));
    }
    canvas.scale("units of the design");
    canvas.explain(Stroke::MainPath, "path of D");
    canvas.explain(Stroke::Guide, "the line that it keeps to");
    canvas.explain(Stroke::Crank, "cranks");
    if let Some(order) = shown.pointer("/contact/order").and_then(Value::as_u64) {
        let points = order + 1;
        canvas.remark(&match order {
            0 => "D crosses the line in the design position".to_owned(),
            _ => format!("in D the path has {points} infinitely near points on the line"),
        });
    }
    if linkages.len() > 1 {
        let others = linkages.len() - 1;
        canvas.remark(&format!(
            "the first of the linkages of the answer; it has {others} more"
        ));
    }
    Some(canvas.to_svg())
}

impl Linkage {
    pub(super) fn read(linkage: &Value) -> Option<Self> {
        let at = |name: &str| finite_point(&linkage[name]).map(|[x, y]| z(x, y));
        number(&linkage["Q"])?;
        Some(Linkage {
            o_a: at("O_a")?,
            a: at("A")?,
            b: at("B")?,
            o_b: at("O_b")?,
            d: at("D")?,
        })
    }

    pub(super) fn joints(&self) -> [Point; 5] {
        [&self.o_a, &self.a, &self.b, &self.o_b, &self.d].map(point)
    }

    /// Base, cranks and coupler with the joints.
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let [o_a, a, b, o_b, d] = self.joints();
        canvas.line([o_a, o_b], Stroke::Base);
        canvas.line([o_a, a], Stroke::Crank);
        canvas.line([o_b, b], Stroke::Crank);
        canvas.line([a, b, d, a], Stroke::Bar);
        for (at, joint, name) in [
            (o_a, Joint::Fixed, "O_a"),
            (o_b, Joint::Fixed, "O_b"),
            (a, Joint::Moving, "A"),
            (b, Joint::Moving, "B"),
            (d, Joint::Moving, "D"),
        ] {
            canvas.joint(at, joint, name);
        }
    }

    /// The path of D, with B to the left and to the right of the line from A to O_b.
    pub(super) fn path(&self) -> [Vec<Point>; 2] {
        let crank = &self.a - &self.o_a;
        let shape = (&self.d - &self.a) / (&self.b - &self.a);
        let [rod, rocker] = [
            distance_squared(&self.a, &self.b),
            distance_squared(&self.b, &self.o_b),
        ];
        let at = |angle: f64| -> Option<[Point; 2]> {
            let (sin, cos) = angle.sin_cos();
            let a = &self.o_a + &crank * z(cos, sin);
            let corners = third_corners(&a, &self.o_b, &rod, &rocker)?;
            let places = corners.map(|b| point(&(&a + &shape * (b - &a))));
            places
                .as_flattened()
                .iter()
                .all(|x| x.is_finite())
                .then_some(places)
        };
        let angle = |step: u32| TAU * f64::from(step) / f64::from(STEPS);
        let mut angles = vec![0.0];
        for step in 0..STEPS {
            let (from, to) = (angle(step), angle(step + 1));
            if at(from).is_some() != at(to).is_some() {
                angles.push(limit(|angle| at(angle).is_some(), from, to));
            }
            angles.push(to);
        }
        let gap = [[f64::NAN; 2]; 2];
        let places = angles.into_iter().map(|angle| at(angle).unwrap_or(gap));
        places.map(<(Point, Point)>::from).unzip().into()
    }
}

/// The last angle at which the linkage closes, between one at which it does and one at which not.
pub fn limit(closes: impl Fn(f64) -> bool, from: f64, to: f64) -> f64 {
    let (mut inside, mut outside) = if closes(from) { (from, to) } else { (to, from) };
    for _ in 0..50 {
        let middle = (inside + outside) / 2.0;
        if closes(middle) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    inside
}
