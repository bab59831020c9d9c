//! Pictures within pages.

use maud::{Markup, PreEscaped, html};

/// An SVG document as a part of a page, where its ids must be its own.
pub fn svg(document: &str, name: &str) -> Markup {
    let start = document.find("<svg").unwrap_or(0);
    let mut text = document.get(start..).unwrap_or_default().to_owned();
    for id in ["title", "description", "window"] {
        text = text
            .replace(&format!("id=\"{id}\""), &format!("id=\"{name}-{id}\""))
            .replace(&format!("url(#{id})"), &format!("url(#{name}-{id})"));
    }
    let labels = "aria-labelledby=\"title description\"";
    text = text.replace(
        labels,
        &format!("aria-labelledby=\"{name}-title {name}-description\""),
    );
    PreEscaped(text)
}

/// A picture with its caption; one that moves has a button.
pub fn figure(document: &str, name: &str, title: &str, caption: &str, moving: bool) -> Markup {
    html! {
        figure #(name) {
            div.picture tabindex="0" role="group" aria-label=(title) { (svg(document, name)) }
            @if moving {
                button.motion type="button" data-moves=(name) aria-pressed="false" hidden { "Move" }
            }
            figcaption { strong { (title) ". " } (caption) }
        }
    }
}
