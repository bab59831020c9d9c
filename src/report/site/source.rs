//! The page of a source: its statements in the order of the print, with pictures beside them.

use std::collections::BTreeMap;
use std::sync::Arc;

use maud::{Markup, html};

use super::{File, address, article, grid, inline, layout, numbers};
use crate::ledger::{Content, Decided, Judged, Kind, PrintedTable, Statement, Verdict};
use crate::report::gallery::Exhibit;

/// The page.
pub fn page(source: &Judged<'_>, exhibits: &[Exhibit]) -> File {
    let key = &source.paper.key;
    let content = html! {
        h1 { (short_title(&source.paper.title)) }
        p.title { (source.paper.title) }
        (filter(source))
        (contents(source))
        @for section in sections(source) { (section_of(&section, exhibits)) }
    };
    layout::page(
        &address::of_source(key),
        short_title(&source.paper.title),
        &content,
    )
}

/// Author and title, without where it appeared.
pub fn short_title(title: &str) -> &str {
    let parts: Vec<(usize, &str)> = title.match_indices(", ").collect();
    match parts.get(1) {
        Some((end, _)) => title.get(..*end).unwrap_or(title),
        None => title,
    }
}

/// How many statements have each verdict.
pub fn counts(source: &Judged<'_>) -> BTreeMap<Verdict, usize> {
    let mut counts = BTreeMap::new();
    for decided in source.decided() {
        *counts.entry(decided.judgement.verdict).or_default() += 1;
    }
    counts
}

fn filter(source: &Judged<'_>) -> Markup {
    html! {
        form.filter hidden {
            fieldset {
                legend { "Show" }
                @for (verdict, count) in counts(source) {
                    label title=(verdict.meaning()) {
                        input type="checkbox" name="verdict" value=(verdict) checked;
                        " " (layout::verdict(verdict)) " " (count)
                    }
                }
                button type="button" data-show="errata" { "Errata only" }
                button type="button" data-show="all" { "All" }
            }
            p.shown role="status" {}
        }
    }
}

/// A part of a source.
struct Section<'a> {
    name: String,
    statements: Vec<Decided<'a>>,
}

/// A chapter or section as the places of its statements name it; a source without any is one.
fn section_name(locus: &str) -> Option<&str> {
    let first = locus.split([',', ':']).next()?;
    let named = ["chapter ", "section ", "appendix"];
    named
        .iter()
        .any(|name| first.starts_with(name))
        .then_some(first)
}

/// The sections in the order in which they begin; what belongs to none follows the statement before it.
fn sections<'a>(source: &'a Judged<'_>) -> Vec<Section<'a>> {
    let mut sections: Vec<Section<'a>> = Vec::new();
    let mut current = 0;
    for decided in source.decided() {
        let name = section_name(&decided.statement.locus);
        if let Some(name) = name.or(sections.is_empty().then_some("text")) {
            let known = sections.iter().position(|section| section.name == name);
            current = known.unwrap_or(sections.len());
            if known.is_none() {
                sections.push(Section {
                    name: name.to_owned(),
                    statements: Vec::new(),
                });
            }
        }
        if let Some(section) = sections.get_mut(current) {
            section.statements.push(decided);
        }
    }
    sections
}

fn contents(source: &Judged<'_>) -> Markup {
    let sections = sections(source);
    html! {
        @if sections.len() > 1 {
            nav.contents aria-label="Sections" {
                ul {
                    @for section in &sections {
                        li { a href={ "#" (place_of(section)) } { (capital(&section.name)) } }
                    }
                }
            }
        }
    }
}

fn place_of(section: &Section<'_>) -> String {
    format!("part-{}", address::encoded(&section.name.replace(' ', "-")))
}

fn capital(name: &str) -> String {
    let mut letters = name.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}

/// Statements that are shown together.
enum Block<'a> {
    Article(Decided<'a>),
    Numbers(String, Vec<(String, Decided<'a>)>),
    Grid(Arc<PrintedTable>, Vec<Decided<'a>>),
}

fn blocks<'a>(section: &Section<'a>) -> Vec<Block<'a>> {
    let mut blocks: Vec<Block<'a>> = Vec::new();
    for decided in &section.statements {
        let statement = decided.statement;
        match (&statement.content, blocks.last_mut()) {
            (Content::Cell { table, .. }, Some(Block::Grid(last, cells)))
                if Arc::ptr_eq(table, last) =>
            {
                cells.push(*decided);
            }
            (Content::Cell { table, .. }, _) => {
                blocks.push(Block::Grid(Arc::clone(table), vec![*decided]));
            }
            _ if statement.kind == Kind::Number => {
                let (heading, place) = heading_and_place(statement, &section.name);
                match blocks.last_mut() {
                    Some(Block::Numbers(last, rows)) if *last == heading => {
                        rows.push((place, *decided))
                    }
                    _ => blocks.push(Block::Numbers(heading, vec![(place, *decided)])),
                }
            }
            _ => blocks.push(Block::Article(*decided)),
        }
    }
    blocks
}

/// `chapter VI, figure 37, Q` is the number `Q` of `figure 37`; where the place says no more than the heading,
/// the end of its id does.
fn heading_and_place(statement: &Statement, section: &str) -> (String, String) {
    let within = within(&statement.locus, section);
    match within.split_once(", ") {
        Some((heading, place)) => (heading.to_owned(), place.to_owned()),
        None => {
            let name = statement.id.rsplit('/').next();
            (within.to_owned(), name.unwrap_or_default().to_owned())
        }
    }
}

/// A place without the section that it is under.
fn within<'a>(locus: &'a str, section: &str) -> &'a str {
    let rest = locus.strip_prefix(section);
    rest.and_then(|rest| rest.strip_prefix(", ").or(rest.strip_prefix(": ")))
        .unwrap_or(locus)
}

impl Block<'_> {
    /// The ids of its statements.
    fn ids(&self) -> Vec<&str> {
        match self {
            Block::Article(decided) => vec![&decided.statement.id],
            Block::Numbers(_, rows) => rows
                .iter()
                .map(|(_, one)| one.statement.id.as_str())
                .collect(),
            Block::Grid(_, cells) => cells.iter().map(|one| one.statement.id.as_str()).collect(),
        }
    }
}

fn section_of(section: &Section<'_>, exhibits: &[Exhibit]) -> Markup {
    let mut shown: Vec<usize> = Vec::new();
    html! {
        section aria-labelledby=(place_of(section)) {
            h2 #(place_of(section)) { (capital(&section.name)) }
            @for block in blocks(section) {
                @for (number, exhibit) in beside(&block, exhibits) {
                    @if first_time(&mut shown, number) { (figure(number, exhibit)) }
                }
                (shown_block(&block, section))
            }
        }
    }
}

/// Pictures that stand before this block.
fn beside<'e>(block: &Block<'_>, exhibits: &'e [Exhibit]) -> Vec<(usize, &'e Exhibit)> {
    let ids = block.ids();
    let stands = |exhibit: &Exhibit| ids.iter().any(|id| id.starts_with(&exhibit.beside));
    let numbered = exhibits.iter().enumerate();
    numbered.filter(|(_, exhibit)| stands(exhibit)).collect()
}

fn first_time(shown: &mut Vec<usize>, number: usize) -> bool {
    let is_new = !shown.contains(&number);
    shown.push(number);
    is_new
}

fn figure(number: usize, exhibit: &Exhibit) -> Markup {
    let name = format!("picture-{}", number + 1);
    inline::figure(
        &exhibit.svg,
        &name,
        &exhibit.title,
        &exhibit.caption,
        exhibit.moving,
    )
}

fn shown_block(block: &Block<'_>, section: &Section<'_>) -> Markup {
    match block {
        Block::Article(decided) => article::article(
            *decided,
            &capital(within(&decided.statement.locus, &section.name)),
        ),
        Block::Numbers(heading, rows) => html! {
            h3 { (capital(heading)) }
            (numbers::table(&capital(heading), rows))
        },
        Block::Grid(table, cells) => {
            let heading = cells
                .first()
                .map_or(String::new(), |cell| cell_heading(&cell.statement.locus));
            html! {
                h3 { (capital(within(&heading, &section.name))) }
                (grid::grid(&heading, table, cells))
            }
        }
    }
}

/// The place of a cell without its row and column.
fn cell_heading(locus: &str) -> String {
    let parts: Vec<&str> = locus.split(", ").collect();
    let is_of_cell = |part: &&str| part.starts_with("row ") || part.starts_with("column ");
    let kept: Vec<&str> = parts
        .into_iter()
        .take_while(|part| !is_of_cell(part))
        .collect();
    kept.join(", ")
}
