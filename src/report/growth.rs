//! How a cost grows, as a diagram with logarithmic axes.

use std::fmt::Write;

use super::canvas::{Point, escaped};

/// Measured costs, each of so many seconds for so many of something.
pub struct Growth {
    /// What is measured.
    pub title: String,
    /// What is counted.
    pub across: String,
    /// Curves with their names.
    pub curves: Vec<(String, Vec<Point>)>,
    /// The power by which the cost is expected to grow.
    pub exponent: f64,
}

const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 300.0;
const LEFT: f64 = 80.0;
const TOP: f64 = 20.0;
/// For the names of the curves.
const RIGHT: f64 = 130.0;
const BELOW: f64 = 56.0;
const COLOURS: [&str; 3] = ["#1565c0", "#d84315", "#2e7d32"];

/// Powers of ten between which all values are.
struct Axis {
    low: f64,
    high: f64,
}

impl Axis {
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values
            .filter(|value| *value > 0.0)
            .map(f64::log10)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
                (low.min(x), high.max(x))
            });
        let (low, high) = if low <= high {
            (low.floor(), high.ceil())
        } else {
            (0.0, 1.0)
        };
        Axis {
            low,
            high: high.max(low + 1.0),
        }
    }

    /// From 0 to 1.
    fn place(&self, value: f64) -> f64 {
        (value.log10() - self.low) / (self.high - self.low)
    }

    fn decades(&self) -> impl Iterator<Item = f64> {
        let (low, high) = (self.low, self.high);
        (0..40)
            .map(move |step| low + f64::from(step))
            .take_while(move |decade| *decade <= high)
    }
}

/// From a name to the next one below.
const LINE: f64 = 16.0;

/// The whole picture.
pub fn svg(growth: &Growth) -> String {
    let points = || growth.curves.iter().flat_map(|(_, points)| points);
    let across = Axis::of(points().map(|[n, _]| *n));
    let up = Axis::of(points().map(|[_, seconds]| *seconds));
    let x = |n: f64| LEFT + WIDTH * across.place(n);
    let y = |seconds: f64| TOP + HEIGHT * (1.0 - up.place(seconds));
    let (width, height) = (LEFT + WIDTH + RIGHT, TOP + HEIGHT + BELOW);
    let title = escaped(&growth.title);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         role=\"img\" aria-label=\"{title}\" font-family=\"sans-serif\" font-size=\"14\">\n"
    );
    // Writing to a string cannot fail.
    let mut text = |at: Point, anchor: &str, colour: &str, words: &str| {
        let _ = writeln!(
            svg,
            r#"<text x="{:.1}" y="{:.1}" text-anchor="{anchor}" fill="{colour}">{}</text>"#,
            at[0],
            at[1],
            escaped(words)
        );
    };
    const INK: &str = "#263238";
    for decade in across.decades() {
        let at = 10f64.powf(decade);
        text(
            [x(at), TOP + HEIGHT + 22.0],
            "middle",
            INK,
            &power_of_ten(decade),
        );
    }
    for decade in up.decades() {
        let at = 10f64.powf(decade);
        text([LEFT - 10.0, y(at) + 5.0], "end", INK, &duration(decade));
    }
    let below = [LEFT + WIDTH / 2.0, TOP + HEIGHT + 46.0];
    text(below, "middle", INK, &growth.across);
    let ends = growth.curves.iter().zip(COLOURS);
    let ends = ends.filter_map(|((name, points), colour)| {
        let [n, seconds] = points.last()?;
        Some(([x(*n) + 10.0, y(*seconds) + 5.0], name, colour))
    });
    let mut ends: Vec<_> = ends.collect();
    ends.sort_by(|([_, a], ..), ([_, b], ..)| a.total_cmp(b));
    let mut above = f64::NEG_INFINITY;
    for ([right, height], name, colour) in ends {
        above = height.max(above + LINE);
        text([right, above], "start", colour, name);
    }
    let mut path = |points: &[Point], look: &str| {
        let mut command = 'M';
        let mut way = String::new();
        for [x, y] in points {
            let _ = write!(way, "{command}{x:.1} {y:.1} ");
            command = 'L';
        }
        let _ = writeln!(svg, "<path d=\"{}\" fill=\"none\" {look}/>", way.trim_end());
    };
    let faint = r##"stroke="#e0e6e9""##;
    for at in across.decades().map(|decade| x(10f64.powf(decade))) {
        path(&[[at, TOP], [at, TOP + HEIGHT]], faint);
    }
    for at in up.decades().map(|decade| y(10f64.powf(decade))) {
        path(&[[LEFT, at], [LEFT + WIDTH, at]], faint);
    }
    if let Some(law) = expected(growth, &across, &up) {
        let law = law.map(|[n, seconds]| [x(n), y(seconds)]);
        path(&law, r##"stroke="#8e24aa" stroke-dasharray="5 4""##);
    }
    for ((_, points), colour) in growth.curves.iter().zip(COLOURS) {
        let at: Vec<Point> = points
            .iter()
            .map(|[n, seconds]| [x(*n), y(*seconds)])
            .collect();
        path(&at, &format!("stroke=\"{colour}\" stroke-width=\"1.8\""));
    }
    for ((_, points), colour) in growth.curves.iter().zip(COLOURS) {
        for [n, seconds] in points {
            let _ = writeln!(
                svg,
                r#"<circle cx="{:.1}" cy="{:.1}" r="3.5" fill="{colour}"/>"#,
                x(*n),
                y(*seconds)
            );
        }
    }
    svg.push_str("</svg>\n");
    svg
}

/// Through the last point of the first curve, within the picture.
fn expected(growth: &Growth, across: &Axis, up: &Axis) -> Option<[Point; 2]> {
    let [n, seconds] = growth.curves.first()?.1.last()?;
    let at = |seconds_there: f64| n * (seconds_there / seconds).powf(1.0 / growth.exponent);
    let start = 10f64.powf(across.low).max(at(10f64.powf(up.low)));
    let there = seconds * (start / n).powf(growth.exponent);
    Some([[start, there], [*n, *seconds]])
}

fn power_of_ten(decade: f64) -> String {
    match decade {
        0.0 => "1".to_owned(),
        1.0 => "10".to_owned(),
        2.0 => "100".to_owned(),
        3.0 => "1000".to_owned(),
        _ => {
            let digits = format!("{decade:.0}");
            let raised = digits.chars().filter_map(|digit| {
                let place = digit.to_digit(10)?;
                "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(usize::try_from(place).ok()?)
            });
            format!("10{}", raised.collect::<String>())
        }
    }
}

fn duration(decade: f64) -> String {
    let unit = (decade / 3.0).floor();
    let name = match unit {
        0.0.. => return format!("{:.0} s", 10f64.powf(decade)),
        -1.0 => "ms",
        -2.0 => "µs",
        _ => "ns",
    };
    let unit = unit.max(-3.0);
    let places = if decade < -9.0 { 3 } else { 0 };
    format!("{:.*} {name}", places, 10f64.powf(decade - 3.0 * unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_powers_of_ten_with_units() {
        assert_eq!(duration(-4.0), "100 µs");
        assert_eq!(duration(-3.0), "1 ms");
        assert_eq!(duration(1.0), "10 s");
        assert_eq!(duration(-9.0), "1 ns");
        assert_eq!([0.0, 3.0, 5.0].map(power_of_ten), ["1", "1000", "10⁵"]);
    }

    #[test]
    fn names_of_curves_that_meet_do_not() {
        let both = Growth {
            title: "time".to_owned(),
            across: "digits".to_owned(),
            curves: ["ours", "kernel"]
                .map(|name| (name.to_owned(), vec![[10.0, 1.0], [100.0, 2.0]]))
                .into(),
            exponent: 1.0,
        };
        let drawn = svg(&both);
        let height = |name: &str| {
            let line = drawn
                .lines()
                .find(|line| line.contains(&format!(">{name}<")))
                .unwrap();
            let (_, rest) = line.split_once(" y=\"").unwrap();
            rest.split_once('"').unwrap().0.parse::<f64>().unwrap()
        };
        assert_eq!((height("ours") - height("kernel")).abs(), LINE);
    }

    #[test]
    fn nothing_measured_is_an_empty_diagram() {
        let empty = Growth {
            title: "a < b".to_owned(),
            across: "digits".to_owned(),
            curves: vec![("ours".to_owned(), Vec::new())],
            exponent: 1.0,
        };
        let drawn = svg(&empty);
        assert!(drawn.contains("a &lt; b") && !drawn.contains("NaN"));
    }
}
