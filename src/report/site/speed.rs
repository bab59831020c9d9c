//! The page of measured times.

use std::collections::BTreeMap;

use maud::{PreEscaped, html};
use serde::Deserialize;

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
    measured: BTreeMap<String, Curve>,
}

/// Of a program; why there is none, where it is missing.
#[derive(Deserialize)]
#[serde(untagged)]
enum Curve {
    Measured { points: Vec<[f64; 2]> },
    Missing(String),
}

fn measured() -> Vec<Growth> {
    let file: Measured = serde_json::from_str(FILE).unwrap_or_default();
    file.series.into_iter().map(drawn).collect()
}

fn drawn(series: Series) -> Growth {
    let curves = series.measured.into_iter();
    let curves = curves.map(|(name, curve)| match curve {
        Curve::Measured { points } => (name, points),
        Curve::Missing(reason) => (reason, Vec::new()),
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
                .any(|(name, points)| name == "ours" && points.len() > 5)
        }));
    }
}
