//! The page of measured times.

use std::collections::BTreeMap;

use maud::{PreEscaped, html};
use serde::Deserialize;
use serde_json::Value;

use super::prose::prose;
use super::{File, layout};
use crate::report::growth::{self, Growth};

const FILE: &str = include_str!("../../../data/speed/growth.json");

/// The page.
pub fn page() -> File {
    let content = html! {
        (PreEscaped(prose(include_str!("../../../docs/speed.md"))))
        h2 { "How the cost grows" }
        p {
            "Measured by " code { "python3 scripts/peers growth" }
            ". The dashed line is the law that is expected, through the last point."
        }
        @for growth in measured() {
            figure {
                (PreEscaped(growth::svg(&growth)))
                figcaption { (growth.title) }
            }
        }
    };
    layout::page("speed.html", "Speed", &html! { div.prose { (content) } })
}

#[derive(Default, Deserialize)]
struct Measured {
    series: Vec<Series>,
}

#[derive(Deserialize)]
struct Series {
    what: String,
    across: String,
    exponent: f64,
    /// Of each program the points, or why there is none.
    measured: BTreeMap<String, Value>,
}

fn measured() -> Vec<Growth> {
    let file: Measured = serde_json::from_str(FILE).unwrap_or_default();
    file.series.into_iter().map(drawn).collect()
}

fn drawn(series: Series) -> Growth {
    let curves = series.measured.into_iter();
    let curves = curves.map(|(name, curve)| match curve.as_str() {
        Some(reason) => (reason.to_owned(), Vec::new()),
        None => (name, points(curve.get("points"))),
    });
    let mut curves: Vec<_> = curves.collect();
    curves.sort_by_key(|(name, _)| name != "ours");
    Growth {
        title: series.what,
        across: series.across,
        curves,
        exponent: series.exponent,
    }
}

fn points(list: Option<&Value>) -> Vec<[f64; 2]> {
    let points = list.and_then(Value::as_array).into_iter().flatten();
    let points = points.map(|point| Some([point.get(0)?.as_f64()?, point.get(1)?.as_f64()?]));
    points.flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_series_are_read() {
        let read = measured();
        assert_eq!(read.len(), 3);
        assert!(read.iter().all(|growth| {
            growth
                .curves
                .iter()
                .any(|(name, points)| name == "ours" && points.len() >= 5)
        }));
    }
}
