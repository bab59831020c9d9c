//! A drawing in the coordinates of the plane, y upwards, that fits itself onto a page.

use std::fmt::Write;

use super::labels::{Labels, name_svg};
use super::moving;
use crate::number::count;

/// A point of the drawing.
pub type Point = [f64; 2];

/// What a line stands for decides how it is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A bar of the linkage.
    Bar,
    /// The bar that drives.
    Crank,
    /// The fixed base.
    Base,
    /// The path of a point.
    Path,
    /// The path that the picture is about.
    MainPath,
    /// A curve of the theory.
    Curve,
    /// The curve that the picture is about.
    MainCurve,
    /// The part of the curve that fulfils all wishes.
    Stretch,
    /// A line of the construction.
    Construction,
    /// A line that belongs to a curve: asymptote, midline.
    Guide,
}

impl Stroke {
    fn attributes(self) -> &'static str {
        match self {
            Stroke::Bar => r##"stroke="#37474f" stroke-width="4" stroke-linecap="round""##,
            Stroke::Crank => r##"stroke="#c62828" stroke-width="5" stroke-linecap="round""##,
            Stroke::Base => {
                r##"stroke="#90a4ae" stroke-width="3" stroke-dasharray="2 6" stroke-linecap="round""##
            }
            Stroke::Path => r##"stroke="#1565c0" stroke-width="1.5""##,
            Stroke::MainPath => r##"stroke="#1565c0" stroke-width="3""##,
            Stroke::Curve => r##"stroke="#2e7d32" stroke-width="1.5""##,
            Stroke::MainCurve => r##"stroke="#2e7d32" stroke-width="2.5""##,
            Stroke::Stretch => {
                r##"stroke="#ef6c00" stroke-width="7" stroke-opacity="0.75" stroke-linecap="round""##
            }
            Stroke::Construction => r##"stroke="#8d6e63" stroke-width="1.5""##,
            Stroke::Guide => r##"stroke="#6a1b9a" stroke-width="1.2" stroke-dasharray="9 5""##,
        }
    }
}

/// How a joint looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joint {
    /// Fixed to the ground.
    Fixed,
    /// Moving.
    Moving,
    /// A point of the plane, no joint.
    Mark,
    /// A name alone.
    Name,
}

enum Shape {
    Line(Vec<Point>, Stroke),
    Joint(Point, Joint, String),
    Area(Vec<Point>),
    /// In the first of its places, and where it goes from there.
    MovingLine(Vec<[Point; 2]>, Stroke),
    MovingJoint(Vec<Point>, Joint, String),
}

/// A part of a page, as wide as the drawing.
#[derive(Default)]
pub struct Block {
    /// What it shows, from the height 0 downwards.
    pub svg: String,
    /// How high it is.
    pub height: f64,
}

/// A drawing in the making.
pub struct Canvas {
    title: String,
    description: String,
    shapes: Vec<Shape>,
    legend: Vec<(Option<Stroke>, String)>,
    below: Block,
    unit: Option<String>,
    low: Point,
    high: Point,
}

const WIDTH: f64 = 900.0;
const MOST_HEIGHT: f64 = 900.0;
const MARGIN: f64 = 50.0;
/// Between the drawing and its legend.
const BELOW: f64 = 26.0;
const LINE_HEIGHT: f64 = 22.0;

impl Canvas {
    /// An empty drawing; the description is what a reader who cannot see it is told.
    pub fn new(title: &str, description: &str) -> Self {
        Canvas {
            title: title.to_owned(),
            description: description.to_owned(),
            shapes: Vec::new(),
            legend: Vec::new(),
            below: Block::default(),
            unit: None,
            low: [f64::INFINITY; 2],
            high: [f64::NEG_INFINITY; 2],
        }
    }

    /// Makes room for a point.
    pub fn show(&mut self, point: Point) {
        for ((low, high), x) in self.low.iter_mut().zip(&mut self.high).zip(point) {
            if x.is_finite() {
                *low = low.min(x);
                *high = high.max(x);
            }
        }
    }

    /// The part of the plane that is shown, a little enlarged.
    pub fn window(&self) -> (Point, Point) {
        let [x0, y0] = self.low;
        let [x1, y1] = self.high;
        let margin = 0.1 * (x1 - x0).max(y1 - y0).max(1e-9);
        ([x0 - margin, y0 - margin], [x1 + margin, y1 + margin])
    }

    /// A line through points, all of which are shown.
    pub fn line(&mut self, points: impl IntoIterator<Item = Point>, stroke: Stroke) {
        let points: Vec<Point> = points.into_iter().collect();
        for point in &points {
            self.show(*point);
        }
        self.shapes.push(Shape::Line(points, stroke));
    }

    /// A line that is drawn where it falls into the picture, without making room for it.
    pub fn background(&mut self, points: Vec<Point>, stroke: Stroke) {
        self.shapes.push(Shape::Line(points, stroke));
    }

    /// A part of the plane, shaded below all lines, all of which is shown.
    pub fn area(&mut self, corners: Vec<Point>) {
        for corner in &corners {
            self.show(*corner);
        }
        self.shapes.push(Shape::Area(corners));
    }

    /// A joint and its name.
    pub fn joint(&mut self, at: Point, joint: Joint, name: &str) {
        self.show(at);
        self.shapes.push(Shape::Joint(at, joint, name.to_owned()));
    }

    /// A bar that goes through these places in turn; it begins in the first one and moves when it is told
    /// to.
    pub fn moving_line(&mut self, places: Vec<[Point; 2]>, stroke: Stroke) {
        for point in places.iter().flatten() {
            self.show(*point);
        }
        self.shapes.push(Shape::MovingLine(places, stroke));
    }

    /// A joint that goes through these places in turn, with its name.
    pub fn moving_joint(&mut self, places: Vec<Point>, joint: Joint, name: &str) {
        for point in &places {
            self.show(*point);
        }
        self.shapes
            .push(Shape::MovingJoint(places, joint, name.to_owned()));
    }

    /// What the unit of the coordinates is: a scale is drawn.
    pub fn scale(&mut self, unit: &str) {
        self.unit = Some(unit.to_owned());
    }

    /// A line of the legend.
    pub fn explain(&mut self, stroke: Stroke, text: &str) {
        self.legend.push((Some(stroke), text.to_owned()));
    }

    /// A line of the legend that explains no stroke.
    pub fn remark(&mut self, text: &str) {
        self.legend.push((None, text.to_owned()));
    }

    /// What follows below the legend.
    pub fn below(&mut self, block: Block) {
        self.below = block;
    }

    /// The drawing as an SVG document.
    pub fn to_svg(&self) -> String {
        let ([x0, y0], [x1, y1]) = self.window();
        let scale =
            ((WIDTH - 2.0 * MARGIN) / (x1 - x0)).min((MOST_HEIGHT - 2.0 * MARGIN) / (y1 - y0));
        let height = (y1 - y0) * scale + MARGIN + BELOW;
        let left = (WIDTH - (x1 - x0) * scale) / 2.0;
        let place = |[x, y]: Point| [left + (x - x0) * scale, MARGIN + (y1 - y) * scale];
        let below = height + LINE_HEIGHT * (count::to_f64(self.legend.len()) + 1.0);
        let whole = below + self.below.height;
        let mut svg = String::new();
        // Writing to a string cannot fail.
        let _ = writeln!(
            svg,
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {whole:.0}" width="{WIDTH}" height="{whole:.0}" role="img" aria-labelledby="title description" font-family="sans-serif">"#
        );
        let _ = writeln!(svg, r#"<title id="title">{}</title>"#, escaped(&self.title));
        let _ = writeln!(
            svg,
            r#"<desc id="description">{}</desc>"#,
            escaped(&self.description)
        );
        let _ = writeln!(
            svg,
            r##"<rect width="100%" height="100%" fill="#ffffff"/>"##
        );
        let _ = writeln!(
            svg,
            r##"<text x="{MARGIN}" y="32" font-size="20" fill="#263238">{}</text>"##,
            escaped(&self.title)
        );
        let _ = writeln!(
            svg,
            r#"<clipPath id="window"><rect x="{left:.1}" y="{MARGIN}" width="{:.1}" height="{:.1}"/></clipPath><g clip-path="url(#window)">"#,
            (x1 - x0) * scale,
            (y1 - y0) * scale
        );
        for shape in &self.shapes {
            if let Shape::Area(corners) = shape {
                shade(&mut svg, corners.iter().map(|corner| place(*corner)));
            }
        }
        for shape in &self.shapes {
            match shape {
                Shape::Line(points, stroke) => {
                    polyline(&mut svg, points.iter().map(|point| place(*point)), *stroke);
                }
                Shape::MovingLine(places, stroke) => {
                    let places: Vec<[Point; 2]> =
                        places.iter().map(|ends| ends.map(place)).collect();
                    moving::line(&mut svg, &places, stroke.attributes());
                }
                Shape::Joint(..) | Shape::MovingJoint(..) | Shape::Area(_) => {}
            }
        }
        svg.push_str("</g>\n");
        if let Some(unit) = &self.unit {
            scale_bar(&mut svg, unit, scale, [WIDTH - MARGIN, height + 6.0]);
        }
        self.draw_joints(&mut svg, place);
        for (row, (stroke, text)) in self.legend.iter().enumerate() {
            let y = height + LINE_HEIGHT * (count::to_f64(row) + 0.5);
            if let Some(stroke) = stroke {
                let line = [[MARGIN, y - 5.0], [MARGIN + 44.0, y - 5.0]];
                polyline(&mut svg, line.into_iter(), *stroke);
            }
            let _ = writeln!(
                svg,
                r##"<text x="{}" y="{y}" font-size="15" fill="#263238">{}</text>"##,
                MARGIN + 56.0,
                escaped(text)
            );
        }
        if !self.below.svg.is_empty() {
            let _ = writeln!(
                svg,
                r#"<g transform="translate(0 {below:.0})">{}</g>"#,
                self.below.svg
            );
        }
        svg.push_str("</svg>\n");
        svg
    }

    fn draw_joints(&self, svg: &mut String, place: impl Fn(Point) -> Point) {
        let joints: Vec<Point> = self.joints().map(|(at, ..)| place(at)).collect();
        let mut labels = Labels::new(&joints, [0.0, WIDTH]);
        for shape in &self.shapes {
            match shape {
                Shape::Line(points, _) => {
                    let points: Vec<Point> = points.iter().map(|point| place(*point)).collect();
                    labels.avoid(&points);
                }
                Shape::MovingLine(places, _) => {
                    if let Some(ends) = places.first() {
                        labels.avoid(&ends.map(&place));
                    }
                }
                Shape::Joint(..) | Shape::MovingJoint(..) | Shape::Area(_) => {}
            }
        }
        let fixed = self.joints().filter(|(_, joint, _)| *joint == Joint::Fixed);
        for (at, ..) in fixed {
            let [x, y] = place(at);
            labels.avoid(&[[x, y], [x - 11.0, y + 18.0], [x + 11.0, y + 18.0], [x, y]]);
        }
        let names = self.names(&joints);
        let places: Vec<Point> = joints
            .iter()
            .zip(&names)
            .map(|(at, name)| labels.place(*at, name))
            .collect();
        let shapes = self.joint_shapes().zip(&joints);
        for ((shape, at), (name, label)) in shapes.zip(names.iter().zip(places)) {
            match shape {
                Shape::Joint(_, joint, _) => draw_joint(svg, *at, *joint, name, label),
                Shape::MovingJoint(places, joint, _) => {
                    svg.push_str("<g>");
                    draw_joint(svg, *at, *joint, name, label);
                    let places: Vec<Point> = places.iter().map(|point| place(*point)).collect();
                    moving::joint(svg, &places);
                    svg.push_str("</g>\n");
                }
                Shape::Line(..) | Shape::MovingLine(..) | Shape::Area(_) => {}
            }
        }
    }

    /// The names of the joints; of those in one place the last one has all names.
    fn names(&self, places: &[Point]) -> Vec<String> {
        let all: Vec<&str> = self.joints().map(|(_, _, name)| name).collect();
        let is_here = |at: &Point, other: &Point| (at[0] - other[0]).hypot(at[1] - other[1]) < 0.5;
        let named = |index: usize| -> String {
            let Some((at, after)) = places.get(index..).and_then(<[Point]>::split_first) else {
                return String::new();
            };
            if after.iter().any(|other| is_here(at, other)) {
                return String::new();
            }
            let together = places
                .iter()
                .zip(&all)
                .filter(|(other, _)| is_here(at, other));
            let names: Vec<&str> = together.map(|(_, name)| *name).collect();
            let names: Vec<&str> = names.into_iter().filter(|name| !name.is_empty()).collect();
            names.join(", ")
        };
        (0..places.len()).map(named).collect()
    }

    fn joint_shapes(&self) -> impl Iterator<Item = &Shape> {
        self.shapes
            .iter()
            .filter(|shape| matches!(shape, Shape::Joint(..) | Shape::MovingJoint(..)))
    }

    fn joints(&self) -> impl Iterator<Item = (Point, Joint, &str)> {
        self.shapes.iter().filter_map(|shape| match shape {
            Shape::Joint(at, joint, name) => Some((*at, *joint, name.as_str())),
            Shape::MovingJoint(places, joint, name) => {
                let at = places.first().copied().unwrap_or_default();
                Some((at, *joint, name.as_str()))
            }
            Shape::Line(..) | Shape::MovingLine(..) | Shape::Area(_) => None,
        })
    }
}

/// A round length in the unit, as long as is easy to read, ending at this point.
fn scale_bar(svg: &mut String, unit: &str, scale: f64, [right, y]: Point) {
    let power = 10f64.powf((160.0 / scale).log10().floor());
    let length = [5.0, 2.0, 1.0]
        .map(|factor| factor * power)
        .into_iter()
        .find(|length| length * scale <= 160.0)
        .unwrap_or(power);
    let left = right - length * scale;
    let one = unit.replacen("units", "unit", 1);
    let unit = if length.to_string() == "1" {
        &one
    } else {
        unit
    };
    let _ = writeln!(
        svg,
        r##"<path d="M{left:.1} {:.1} v8 M{left:.1} {y:.1} H{right:.1} M{right:.1} {:.1} v8" fill="none" stroke="#263238" stroke-width="1.5"/><text x="{right:.1}" y="{:.1}" font-size="14" text-anchor="end" fill="#263238">{length} {}</text>"##,
        y - 4.0,
        y - 4.0,
        y - 9.0,
        escaped(unit)
    );
}

fn polyline(svg: &mut String, points: impl Iterator<Item = Point>, stroke: Stroke) {
    let mut path = String::new();
    let mut pen_down = false;
    for [x, y] in points {
        // A gap in the data is a gap in the line.
        if !(x.is_finite() && y.is_finite()) || x.abs() > 1e6 || y.abs() > 1e6 {
            pen_down = false;
            continue;
        }
        let _ = write!(path, "{}{x:.1} {y:.1}", if pen_down { " L" } else { " M" });
        pen_down = true;
    }
    if !path.is_empty() {
        let _ = writeln!(
            svg,
            r#"<path d="{}" fill="none" {}/>"#,
            path.trim_start(),
            stroke.attributes()
        );
    }
}

fn shade(svg: &mut String, corners: impl Iterator<Item = Point>) {
    let list: Vec<String> = corners.map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
    let _ = writeln!(
        svg,
        r##"<polygon points="{}" fill="#fff3e0" stroke="#ffb74d" stroke-width="1"/>"##,
        list.join(" ")
    );
}

fn draw_joint(svg: &mut String, [x, y]: Point, joint: Joint, name: &str, [u, v]: Point) {
    if joint == Joint::Fixed {
        let _ = writeln!(
            svg,
            r##"<path d="M{x:.1} {y:.1} l-11 18 h22 z" fill="#eceff1" stroke="#546e7a" stroke-width="1.5"/>"##
        );
    }
    let look = match joint {
        Joint::Name => return draw_name(svg, name, [x, y]),
        Joint::Mark => r##"r="4" fill="#263238""##,
        Joint::Fixed | Joint::Moving => {
            r##"r="5" fill="#ffffff" stroke="#263238" stroke-width="2""##
        }
    };
    let _ = writeln!(svg, r##"<circle cx="{x:.1}" cy="{y:.1}" {look}/>"##);
    draw_name(svg, name, [u, v]);
}

fn draw_name(svg: &mut String, name: &str, [u, v]: Point) {
    if name.is_empty() {
        return;
    }
    // An index is a text of its own: not every viewer centers a text of several parts.
    let (letters, index, middle) = match name.split_once('_') {
        Some((letters, index)) if !index.contains(['_', ',']) => {
            let count = |text: &str| count::to_f64(text.chars().count());
            (
                letters,
                index,
                u + 5.0 * count(letters) - 3.3 * count(index),
            )
        }
        _ => (name, "", u),
    };
    let anchor = if index.is_empty() { "middle" } else { "end" };
    // The halo is a text of its own: not every viewer paints outlines below fillings.
    for halo in [r##"stroke="#ffffff" stroke-width="4""##, ""] {
        let _ = writeln!(
            svg,
            r##"<text x="{middle:.1}" y="{:.1}" font-size="17" font-style="italic" text-anchor="{anchor}" fill="#263238" {halo}>{}</text>"##,
            v + 6.0,
            name_svg(letters)
        );
        if !index.is_empty() {
            let _ = writeln!(
                svg,
                r##"<text x="{:.1}" y="{:.1}" font-size="12" font-style="italic" fill="#263238" {halo}>{}</text>"##,
                middle + 0.5,
                v + 10.0,
                escaped(index)
            );
        }
    }
}

/// How far two points are apart.
pub fn distance([x, y]: Point, [u, v]: Point) -> f64 {
    (x - u).hypot(y - v)
}

/// The smallest distance between two of these points: a position in which it is large is easy to
/// read.
pub fn spread(points: &[Point]) -> f64 {
    let mut least = f64::INFINITY;
    for (i, [x, y]) in points.iter().enumerate() {
        for [u, v] in points.iter().skip(i + 1) {
            least = least.min((x - u).hypot(y - v));
        }
    }
    least
}

/// Text as SVG has it.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
