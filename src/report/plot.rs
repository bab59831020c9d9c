//! A curve over an axis, with ticks.

use std::fmt::Write;

use super::canvas::{Block, Point, escaped};
use crate::number::count;

/// A diagram: its title, what its axes are, and the points of its curve; gaps by NaN.
pub struct Plot {
    /// Above it.
    pub title: String,
    /// Below it.
    pub across: &'static str,
    /// The curve.
    pub points: Vec<Point>,
    /// Levels drawn as dashed lines.
    pub levels: Vec<f64>,
    /// Points drawn as small circles; those beyond the curve's range are left out.
    pub marks: Vec<Point>,
}

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 260.0;
const LEFT: f64 = 90.0;
const TOP: f64 = 44.0;
/// Height of a diagram with its title and its axis.
const WHOLE: f64 = TOP + HEIGHT + 56.0;

/// All diagrams, one below the other.
pub fn block(plots: &[Plot]) -> Block {
    let mut svg = r#"<g font-size="14">"#.to_owned();
    for (place, plot) in plots.iter().enumerate() {
        plot.draw(&mut svg, WHOLE * count::to_f64(place));
    }
    svg.push_str("</g>\n");
    let height = WHOLE * count::to_f64(plots.len()) + 20.0;
    Block { svg, height }
}

/// From least to greatest, never empty.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values
        .filter(|x| x.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
    if low < high { (low, high) } else { (-1.0, 1.0) }
}

/// A little more above and below, so that the curve does not touch the edge.
fn padded((low, high): (f64, f64)) -> (f64, f64) {
    let margin = 0.05 * (high - low);
    (low - margin, high + margin)
}

/// Round numbers within a range, about so many.
fn ticks((low, high): (f64, f64), count: f64) -> Vec<f64> {
    let rough = (high - low) / count;
    let power = 10f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .map(|factor| factor * power)
        .into_iter()
        .find(|step| *step >= rough)
        .unwrap_or(rough);
    let first = (low / step).ceil();
    (0..100)
        .map(|place| (first + f64::from(place)) * step)
        .take_while(|tick| *tick <= high)
        .collect()
}

/// A tick as text, without the noise of its last digits.
fn label(tick: f64, span: f64) -> String {
    if tick.abs() < span * 1e-9 {
        return "0".to_owned();
    }
    let digits = (2.0 - span.log10().floor()).clamp(0.0, 9.0);
    if span < 1e-3 {
        return format!("{tick:.1e}");
    }
    #[expect(clippy::as_conversions, reason = "a whole number from 0 to 9")]
    let digits = digits as usize;
    let text = format!("{tick:.digits$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

impl Plot {
    fn draw(&self, svg: &mut String, top: f64) {
        let across = range(self.points.iter().map(|[x, _]| *x));
        let up = padded(range(
            self.points
                .iter()
                .map(|[_, y]| *y)
                .chain(self.levels.iter().copied()),
        ));
        let x = |value: f64| LEFT + WIDTH * (value - across.0) / (across.1 - across.0);
        let y = |value: f64| top + TOP + HEIGHT * (up.1 - value) / (up.1 - up.0);
        let (bottom, right) = (top + TOP + HEIGHT, LEFT + WIDTH);
        // Writing to a string cannot fail.
        let mut text = |at: [f64; 2], anchor: &str, words: &str| {
            let _ = writeln!(
                svg,
                r##"<text x="{:.1}" y="{:.1}" text-anchor="{anchor}" fill="#263238">{}</text>"##,
                at[0],
                at[1],
                escaped(words)
            );
        };
        text([LEFT, top + 26.0], "start", &self.title);
        text([LEFT + WIDTH / 2.0, bottom + 40.0], "middle", self.across);
        for tick in ticks(across, 8.0) {
            text(
                [x(tick), bottom + 20.0],
                "middle",
                &label(tick, across.1 - across.0),
            );
        }
        for tick in ticks(up, 5.0) {
            text(
                [LEFT - 8.0, y(tick) + 4.0],
                "end",
                &label(tick, up.1 - up.0),
            );
        }
        let mut line = |from: [f64; 2], to: [f64; 2], look: &str| {
            let _ = writeln!(
                svg,
                r#"<path d="M{:.1} {:.1} L{:.1} {:.1}" fill="none" {look}/>"#,
                from[0], from[1], to[0], to[1]
            );
        };
        let faint = r##"stroke="#e0e6e9""##;
        for tick in ticks(across, 8.0) {
            line([x(tick), top + TOP], [x(tick), bottom], faint);
        }
        for tick in ticks(up, 5.0) {
            line([LEFT, y(tick)], [right, y(tick)], faint);
        }
        let axis = r##"stroke="#90a4ae""##;
        line([LEFT, bottom], [right, bottom], axis);
        line([LEFT, top + TOP], [LEFT, bottom], axis);
        for level in &self.levels {
            let dashed = r##"stroke="#8e24aa" stroke-dasharray="5 4""##;
            line([LEFT, y(*level)], [right, y(*level)], dashed);
        }
        let mut path = String::new();
        let mut pen_up = true;
        for [u, v] in &self.points {
            if !(u.is_finite() && v.is_finite()) {
                pen_up = true;
                continue;
            }
            let command = if pen_up { 'M' } else { 'L' };
            let _ = write!(path, "{command}{:.1} {:.1} ", x(*u), y(*v));
            pen_up = false;
        }
        let _ = writeln!(
            svg,
            r##"<path d="{}" fill="none" stroke="#1565c0" stroke-width="1.8"/>"##,
            path.trim_end()
        );
        let is_within = |value: f64, (low, high): (f64, f64)| low <= value && value <= high;
        for [u, v] in &self.marks {
            if is_within(*u, across) && is_within(*v, up) {
                let _ = writeln!(
                    svg,
                    r##"<circle cx="{:.1}" cy="{:.1}" r="3" fill="none" stroke="#d84315"/>"##,
                    x(*u),
                    y(*v)
                );
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_within() {
        assert_eq!(ticks((-0.31, 0.52), 5.0), [-0.2, 0.0, 0.2, 0.4]);
        assert_eq!(label(0.2 + 0.1, 0.8), "0.3");
        assert_eq!(label(1e-17, 0.8), "0");
        assert_eq!(label(250.0, 900.0), "250");
    }

    #[test]
    fn an_empty_curve_draws() {
        let plot = Plot {
            title: "a < b".to_owned(),
            across: "u",
            points: vec![[f64::NAN; 2]],
            levels: Vec::new(),
            marks: vec![[0.0, 0.0], [7.0, 0.0]],
        };
        let block = block(&[plot]);
        assert!(block.svg.contains("a &lt; b"));
        assert_eq!(block.svg.matches("<circle").count(), 1);
    }
}
