//! The chart of linkages with a Ball-double-Burmester point: curves of equal length over the two rays.
//!
//! - [`table`]: the numbers at the points of the grid,
//! - [`level`]: the curve on which they have a value.

mod level;
mod table;

use std::fmt::Write;

use self::level::level_curves;
use self::table::Table;
use super::canvas::{Point, escaped};
use super::labels::name_svg;
use crate::number::count;

/// Pixels a degree.
const SCALE: f64 = 7.0;
const LEFT: f64 = 70.0;
const TOP: f64 = 70.0;
const WIDTH: f64 = 180.0 * SCALE;
const HEIGHT: f64 = 90.0 * SCALE;
/// Of neighbours whose lengths differ by more one arc ends early, and no curve goes between them.
const JUMP: f64 = 0.2;
/// Longest to shortest link beyond which a linkage is marked.
const MOST_RATIO: f64 = 5.0;
const LEVELS: [f64; 16] = [
    0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.6, 1.8, 2.0,
];
/// Every other level is labelled on curves of so many points.
const LABELLED: usize = 12;

/// The picture of a table; `None` where there are no rows.
pub fn picture(table: &str) -> Option<String> {
    let table = Table::read(table)?;
    let mut page = Page::default();
    page.begin();
    page.axes();
    page.marked(&table);
    let lengths = table.values(|row| Some(row.length));
    for level in LEVELS {
        page.level(level, &level_curves(&lengths, table.step, level, JUMP));
    }
    let closures = table.values(|row| Some(row.closure));
    for curve in level_curves(&closures, table.step, 0.0, f64::INFINITY) {
        page.curve(
            &curve,
            r##"stroke="#c62828" stroke-width="2.6" stroke-dasharray="9 4""##,
        );
    }
    page.labels();
    page.legend();
    page.svg.push_str("</svg>\n");
    Some(page.svg)
}

#[derive(Default)]
struct Page {
    svg: String,
    labels: Vec<(Point, String)>,
}

/// α_b across, α_a upwards.
fn place([a, b]: Point) -> Point {
    [LEFT + b * SCALE, TOP + HEIGHT - a * SCALE]
}

/// Writing to a string cannot fail.
macro_rules! draw {
    ($page:expr, $($argument:tt)*) => {{
        let _ = writeln!($page.svg, $($argument)*);
    }};
}

impl Page {
    fn begin(&mut self) {
        let (width, height) = (LEFT + WIDTH + 40.0, TOP + HEIGHT + 190.0);
        draw!(
            self,
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" aria-labelledby="title description" font-family="sans-serif">"#
        );
        draw!(
            self,
            r#"<title id="title">Travel along a straight line of linkages with a Ball-double-Burmester point</title>"#
        );
        draw!(
            self,
            r#"<desc id="description">Curves of equal travel within 0.01 of the line over the two rays of the linkage, from 0 to 90 and from 0 to 180 degrees, with the linkages of bad proportions shaded and the curve between crank-and-levers and double levers.</desc>"#
        );
        draw!(
            self,
            r##"<rect width="100%" height="100%" fill="#ffffff"/>"##
        );
        self.text(
            [LEFT, 36.0],
            "start",
            20,
            "How far the point D goes within 0.01 of a straight line (Ball-double-Burmester point)",
        );
    }

    fn text(&mut self, [x, y]: Point, anchor: &str, size: u32, words: &str) {
        draw!(
            self,
            r##"<text x="{x:.1}" y="{y:.1}" font-size="{size}" text-anchor="{anchor}" fill="#263238">{}</text>"##,
            escaped(words)
        );
    }

    /// The name of an axis.
    fn axis(&mut self, [x, y]: Point, name: &str) {
        draw!(
            self,
            r##"<text x="{x:.1}" y="{y:.1}" font-size="17" text-anchor="middle" fill="#263238">{}</text>"##,
            name_svg(name)
        );
    }

    fn line(&mut self, [from, to]: [Point; 2], look: &str) {
        draw!(
            self,
            r#"<path d="M{:.1} {:.1} L{:.1} {:.1}" fill="none" {look}/>"#,
            from[0],
            from[1],
            to[0],
            to[1]
        );
    }

    fn axes(&mut self) {
        let faint = r##"stroke="#e0e6e9""##;
        for b in (0..=180).step_by(10).map(f64::from) {
            self.line([place([0.0, b]), place([b.min(90.0), b])], faint);
            let [x, y] = place([0.0, b]);
            self.text([x, y + 22.0], "middle", 15, &format!("{b}°"));
        }
        for a in (0..=90).step_by(10).map(f64::from) {
            self.line([place([a, a]), place([a, 180.0])], faint);
            let [x, y] = place([a, 0.0]);
            self.text([x - 8.0, y + 5.0], "end", 15, &format!("{a}°"));
        }
        let border = r##"stroke="#263238" stroke-width="1.2""##;
        let corners = [
            [0.0, 0.0],
            [90.0, 90.0],
            [90.0, 180.0],
            [0.0, 180.0],
            [0.0, 0.0],
        ];
        for pair in corners.windows(2) {
            if let [from, to] = pair {
                self.line([place(*from), place(*to)], border);
            }
        }
        let [x, y] = place([0.0, 90.0]);
        self.axis([x, y + 46.0], "α_b");
        let [x, y] = place([45.0, 0.0]);
        self.axis([x - 48.0, y], "α_a");
    }

    /// Linkages of bad proportions, and none, in rows.
    fn marked(&mut self, table: &Table) {
        let step = f64::from(table.step);
        draw!(self, r##"<g fill="#cfd8dc" fill-opacity="0.75">"##);
        for (a, runs) in table.runs(|row| row.ratio > MOST_RATIO) {
            for [from, to] in runs {
                let [x, y] = place([f64::from(a) + step / 2.0, f64::from(from) - step / 2.0]);
                let width = (f64::from(to - from) + step) * SCALE;
                let height = step * SCALE;
                draw!(
                    self,
                    r#"<rect x="{x:.1}" y="{y:.1}" width="{width:.1}" height="{height:.1}"/>"#
                );
            }
        }
        draw!(self, "</g>");
    }

    fn level(&mut self, level: f64, curves: &[Vec<Point>]) {
        let is_main = (level * 10.0).round() % 2.0 == 0.0;
        let width = if is_main { 2.0 } else { 1.0 };
        let look = format!(r##"stroke="#1565c0" stroke-width="{width}""##);
        for curve in curves {
            self.curve(curve, &look);
            if is_main && curve.len() > LABELLED {
                let middle = curve.get(curve.len() / 2);
                self.labels
                    .extend(middle.map(|middle| (*middle, format!("{level:.1}"))));
            }
        }
    }

    fn curve(&mut self, points: &[Point], look: &str) {
        let mut path = String::new();
        for (index, point) in points.iter().enumerate() {
            let [x, y] = place(*point);
            let command = if index == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{command}{x:.1} {y:.1}");
        }
        draw!(
            self,
            r#"<path d="{path}" fill="none" stroke-linejoin="round" {look}/>"#
        );
    }

    /// Above all curves, each apart from those before it.
    fn labels(&mut self) {
        let mut taken: Vec<Point> = Vec::new();
        for (at, words) in std::mem::take(&mut self.labels) {
            let [x, y] = place(at);
            let is_free =
                |other: &Point| (other[0] - x).abs() > 30.0 || (other[1] - y).abs() > 16.0;
            if taken.iter().all(is_free) {
                taken.push([x, y]);
                // The halo is a text of its own: not every viewer paints outlines below fillings.
                for halo in [r##"stroke="#ffffff" stroke-width="5""##, ""] {
                    draw!(
                        self,
                        r##"<text x="{x:.1}" y="{:.1}" font-size="14" text-anchor="middle" fill="#0d47a1" {halo}>{words}</text>"##,
                        y + 5.0
                    );
                }
            }
        }
    }

    fn legend(&mut self) {
        let top = TOP + HEIGHT + 80.0;
        let looks = [
            r##"stroke="#1565c0" stroke-width="2""##,
            r##"stroke="#c62828" stroke-width="2.6" stroke-dasharray="9 4""##,
            r##"stroke="#cfd8dc" stroke-width="14""##,
        ];
        let words = [
            "travel L in units (Q + R + S + T + (M + N)/2)/5, in steps of 0.1, the crank R at A being turned",
            "change points: crank-and-lever on one side, double lever on the other",
            "longest link more than five times the shortest, or no linkage",
        ];
        for (row, (look, words)) in looks.iter().zip(words).enumerate() {
            let y = top + 24.0 * count::to_f64(row);
            self.line([[LEFT, y], [LEFT + 46.0, y]], look);
            self.text([LEFT + 60.0, y + 5.0], "start", 15, words);
        }
        self.text(
            [LEFT, top + 24.0 * 3.0 + 8.0],
            "start",
            15,
            "Of (α_a, α_b) and (180° − α_b, 180° − α_a) the linkages are mirror images, with the other link turned. Curves end where the travel jumps.",
        );
    }
}
