//! Four-bars in all of their positions, small, side by side.

use std::fmt::Write;

use super::canvas::{Block, Point, escaped};
use crate::number::count;

/// A four-bar B₁A₁A₂B₂ in five positions.
pub struct Linkage {
    /// The numbers of its pairs.
    pub names: [usize; 2],
    /// B₁ and B₂.
    pub pivots: [Point; 2],
    /// A₁ and A₂ in each position.
    pub joints: [[Point; 2]; 5],
    /// Its type.
    pub kind: String,
    /// Why it does not pass through all positions.
    pub defects: Vec<String>,
}

const COLUMNS: usize = 3;
const LEFT: f64 = 50.0;
const WIDTH: f64 = 246.0;
const GAP: f64 = 31.0;
const HEIGHT: f64 = 190.0;
const LINE: f64 = 16.0;
/// Letters of a caption that fit beside each other.
const LETTERS: usize = 40;

/// All panels, three in a row.
pub fn draw(linkages: &[Linkage]) -> Block {
    let mut svg = String::new();
    let mut top = 20.0;
    for row in linkages.chunks(COLUMNS) {
        let captions: Vec<Vec<String>> = row.iter().map(caption).collect();
        for (column, (linkage, lines)) in row.iter().zip(&captions).enumerate() {
            let left = LEFT + count::to_f64(column) * (WIDTH + GAP);
            draw_linkage(&mut svg, linkage, [left, top]);
            draw_caption(&mut svg, lines, [left, top + HEIGHT + 22.0]);
        }
        let most = captions.iter().map(Vec::len).max().unwrap_or_default();
        top += HEIGHT + 22.0 + LINE * count::to_f64(most) + 24.0;
    }
    Block { svg, height: top }
}

fn draw_linkage(svg: &mut String, linkage: &Linkage, [left, top]: Point) {
    let all: Vec<Point> = linkage
        .joints
        .iter()
        .flatten()
        .chain(&linkage.pivots)
        .copied()
        .collect();
    let bound = |of: fn(f64, f64) -> f64, start: f64| {
        all.iter()
            .fold([start; 2], |[x, y], [u, v]| [of(x, *u), of(y, *v)])
    };
    let [x0, y0] = bound(f64::min, f64::INFINITY);
    let [x1, y1] = bound(f64::max, f64::NEG_INFINITY);
    let span = [x1 - x0, y1 - y0].map(|length| length.max(f64::MIN_POSITIVE));
    let inner = [WIDTH - 28.0, HEIGHT - 28.0];
    let scale = (inner[0] / span[0]).min(inner[1] / span[1]);
    let middle = [x1 + x0, y1 + y0].map(|sum| sum / 2.0);
    let place = |[x, y]: Point| {
        [
            left + WIDTH / 2.0 + (x - middle[0]) * scale,
            top + HEIGHT / 2.0 - (y - middle[1]) * scale,
        ]
    };
    // Writing to a string cannot fail.
    let _ = writeln!(
        svg,
        r##"<rect x="{left:.1}" y="{top:.1}" width="{WIDTH}" height="{HEIGHT}" rx="6" fill="#fafafa" stroke="#eceff1"/>"##
    );
    let [first, second] = linkage.pivots.map(place);
    path(
        svg,
        &[first, second],
        r##"stroke="#90a4ae" stroke-width="1.5" stroke-dasharray="1 4" stroke-linecap="round""##,
    );
    for (number, joints) in linkage.joints.iter().enumerate().rev() {
        let [a, b] = joints.map(place);
        let (arm, coupler) = if number == 0 {
            (
                r##"stroke="#c62828" stroke-width="2.5" stroke-linecap="round""##,
                r##"stroke="#37474f" stroke-width="2.5" stroke-linecap="round""##,
            )
        } else {
            (
                r##"stroke="#e6a8a8" stroke-width="1.3" stroke-linecap="round""##,
                r##"stroke="#b0bec5" stroke-width="1.3" stroke-linecap="round""##,
            )
        };
        path(svg, &[first, a], arm);
        path(svg, &[b, second], arm);
        path(svg, &[a, b], coupler);
        let dot = if number == 0 { "#263238" } else { "#90a4ae" };
        for [x, y] in [a, b] {
            let radius = if number == 0 { 3.0 } else { 2.0 };
            let _ = writeln!(
                svg,
                r#"<circle cx="{x:.1}" cy="{y:.1}" r="{radius}" fill="{dot}"/>"#
            );
        }
    }
    for [x, y] in [first, second] {
        let _ = writeln!(
            svg,
            r##"<path d="M{x:.1} {y:.1} l-6 10 h12 z" fill="#eceff1" stroke="#546e7a"/><circle cx="{x:.1}" cy="{y:.1}" r="3" fill="#ffffff" stroke="#263238" stroke-width="1.5"/>"##
        );
    }
}

fn path(svg: &mut String, points: &[Point], look: &str) {
    let steps: Vec<String> = points
        .iter()
        .map(|[x, y]| format!("{x:.1} {y:.1}"))
        .collect();
    let _ = writeln!(
        svg,
        r#"<path d="M{}" fill="none" {look}/>"#,
        steps.join(" L")
    );
}

fn caption(linkage: &Linkage) -> Vec<String> {
    let [i, j] = linkage.names;
    let mut lines = vec![format!("B{i}A{i}A{j}B{j}: {}", linkage.kind)];
    if linkage.defects.is_empty() {
        lines.push("no defect".to_owned());
    }
    for defect in &linkage.defects {
        lines.extend(wrapped(defect));
    }
    lines
}

/// Lines of whole words.
fn wrapped(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= LETTERS => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

fn draw_caption(svg: &mut String, lines: &[String], [left, top]: Point) {
    for (place, line) in lines.iter().enumerate() {
        let (size, colour) = if place == 0 {
            (14, "#263238")
        } else {
            (12, "#546e7a")
        };
        let y = top + LINE * count::to_f64(place);
        let _ = writeln!(
            svg,
            r#"<text x="{left:.1}" y="{y:.1}" font-size="{size}" fill="{colour}">{}</text>"#,
            escaped(line)
        );
    }
}
