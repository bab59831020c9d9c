//! Pages of the documentation as parts of the site.

use pulldown_cmark::{Event, LinkType, Options, Parser, Tag, html::push_html};

/// Text with headings, lists and tables as HTML. Links into the repository keep their words only.
pub fn prose(text: &str) -> String {
    let parser = Parser::new_ext(text, Options::ENABLE_TABLES);
    let is_kept = |event: &Event<'_>| match event {
        Event::Start(Tag::Link {
            dest_url,
            link_type,
            ..
        }) => *link_type != LinkType::Autolink && dest_url.starts_with("https:"),
        _ => true,
    };
    let mut depth_of_left_out = Vec::new();
    let events = parser.filter(|event| match event {
        Event::Start(Tag::Link { .. }) => {
            depth_of_left_out.push(is_kept(event));
            is_kept(event)
        }
        Event::End(pulldown_cmark::TagEnd::Link) => depth_of_left_out.pop().unwrap_or(true),
        Event::Html(_) | Event::InlineHtml(_) => false,
        _ => true,
    });
    let mut html = String::new();
    push_html(&mut html, events);
    html.replace(
        "<table>",
        "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Table\"><table>",
    )
    .replace("</table>", "</table></div>")
}
