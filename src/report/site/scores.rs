//! The page of other programs' scores.

use maud::{PreEscaped, html};

use super::prose::prose;
use super::{File, layout};

/// What the documentation says of candidates, from here on.
const FIRST_HEADING: &str = "## The candidates here";

/// The page.
pub fn page() -> File {
    let text = include_str!("../../../docs/candidates.md");
    let start = text.find(FIRST_HEADING).unwrap_or(0);
    let content = html! {
        h1 { "What other programs find, miss and invent" }
        p {
            "Each program was asked every problem of the "
            a href="corpora.html" { "corpora" }
            " by " code { "burmester score" }
            ", and its answers were compared with certified ones."
        }
        div.prose { (PreEscaped(prose(text.get(start..).unwrap_or_default()))) }
    };
    layout::page("scores.html", "Scores of other programs", &content)
}
