//! What all pages have in common.

use maud::{DOCTYPE, Markup, html};

use super::File;
use crate::ledger::Verdict;

/// The pages that every page leads to.
const NAVIGATION: [(&str, &str); 5] = [
    ("index.html", "All sources"),
    ("index.html#errata", "Errata"),
    ("corpora.html", "Problems"),
    ("scores.html", "Scores"),
    ("speed.html", "Speed"),
];

/// A page; `path` is where it will be.
pub fn page(path: &str, title: &str, content: &Markup) -> File {
    let root = "../".repeat(path.matches('/').count());
    let text = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title) " · burmester" }
                link rel="stylesheet" href={ (root) "style.css" };
                link rel="icon" href="data:,";
                script src={ (root) "search.js" } defer {}
                script src={ (root) "site.js" } defer {}
            }
            body data-root=(root) {
                a.skip href="#content" { "To the content" }
                header {
                    a.name href={ (root) "index.html" } { "burmester" }
                    nav aria-label="Pages" {
                        ul {
                            @for (file, name) in NAVIGATION {
                                li {
                                    a href={ (root) (file) } aria-current=[(file == path).then_some("page")] { (name) }
                                }
                            }
                        }
                    }
                    form.search role="search" hidden {
                        label for="query" { "Search" }
                        input #query type="search" name="q" autocomplete="off" spellcheck="false"
                            placeholder="3.25, cognate, 0.4613 …" aria-describedby="found";
                        p #found role="status" {}
                        ul #results {}
                    }
                }
                main #content tabindex="-1" { (content) }
                footer {
                    p {
                        "Every verdict here was computed; none is written by hand. "
                        code { "burmester explain ID" }
                        " shows a statement in full."
                    }
                }
            }
        }
    };
    File::new(path, text.into_string())
}

/// A verdict as a coloured word.
pub fn verdict(verdict: Verdict) -> Markup {
    html! { span class={ "verdict " (class(verdict)) } { (verdict) } }
}

/// What colours a verdict.
pub fn class(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds | Verdict::Reproduced => "right",
        Verdict::Truncated | Verdict::Noise | Verdict::Consistent => "near",
        Verdict::HoldsIf | Verdict::Unclear | Verdict::NotReproducible => "doubt",
        Verdict::Fails | Verdict::Contradicted => "wrong",
    }
}
