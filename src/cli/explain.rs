//! `burmester explain`: one statement in full.

use std::fmt::Write;
use std::process::ExitCode;

use burmester::formula::Formula;
use burmester::ledger::{Content, Judge, Judgement, Options, Paper, Statement};
use burmester::scenes::find_check;

use super::outcome::{Failure, print};
use super::{Data, style};

/// Arguments of `explain`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The id of a statement, like `wunderlich1968/eq/1.6`
    #[arg(value_name = "ID")]
    id: String,
    #[command(flatten)]
    data: Data,
}

/// Writing to a string cannot fail.
macro_rules! say {
    ($text:expr, $($argument:tt)*) => {{
        let _ = writeln!($text, $($argument)*);
    }};
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let papers = arguments.data.papers()?;
    let (paper, statement) = find(&papers, &arguments.id)?;
    let judgement = Judge::new(Options {
        digits: 50,
        mutants: true,
    })
    .judge(statement)
    .map_err(|error| Failure::wrong(format!("{}: {error}", statement.place())))?;
    print(&explained(paper, statement, &judgement))?;
    Ok(ExitCode::SUCCESS)
}

fn find<'a>(papers: &'a [Paper], id: &str) -> Result<(&'a Paper, &'a Statement), Failure> {
    let all = || {
        papers.iter().flat_map(|paper| {
            paper
                .statements
                .iter()
                .map(move |statement| (paper, statement))
        })
    };
    if let Some(found) = all().find(|(_, statement)| statement.id == id) {
        return Ok(found);
    }
    let mut near: Vec<(bool, usize, &str)> = all()
        .map(|(_, statement)| {
            let other = statement.id.as_str();
            (!other.contains(id), distance(id, other), other)
        })
        .collect();
    near.sort();
    let nearest: Vec<&str> = near.iter().take(3).map(|(_, _, id)| *id).collect();
    Err(Failure::wrong(format!(
        "no statement `{id}` is decided yet; the nearest ids are {}",
        nearest.join(", ")
    )))
}

/// How many characters must be put in, taken out or changed to turn one word into the other.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().take(200).collect(), b.chars().collect());
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut before = row.first().copied().unwrap_or(0);
        if let Some(first) = row.first_mut() {
            *first = i + 1;
        }
        let mut left = i + 1;
        for (y, place) in b.iter().zip(row.iter_mut().skip(1)) {
            let changed = before + usize::from(x != y);
            before = *place;
            *place = changed.min(before + 1).min(left + 1);
            left = *place;
        }
    }
    row.last().copied().unwrap_or(0)
}

fn explained(paper: &Paper, statement: &Statement, judgement: &Judgement) -> String {
    let mut text = String::new();
    say!(text, "{}", style::bold(&statement.id));
    say!(text, "  {}", style::folded(&paper.title, 96, 2));
    say!(text, "  {}, {}", statement.locus, statement.kind);
    say!(text, "");
    contents(&mut text, statement, judgement);
    say!(text, "");
    verdict(&mut text, statement, judgement);
    say!(text, "");
    scene(&mut text, statement);
    text
}

fn formula_lines(text: &mut String, label: &str, formula: &Formula) {
    let mut label = label;
    for claim in &formula.claims {
        say!(text, "  {label:<10} {claim}");
        label = "";
    }
    for (name, expression) in &formula.definitions {
        say!(text, "  {:<10} where {name} = {expression}", "");
    }
    for assumption in &formula.assumptions {
        say!(text, "  {:<10} assuming {assumption}", "");
    }
}

fn contents(text: &mut String, statement: &Statement, judgement: &Judgement) {
    match &statement.content {
        Content::Formula(printed) => formula_lines(text, "printed", &printed.formula),
        Content::Value {
            quantity,
            explained_by,
            ..
        } => {
            say!(
                text,
                "  {:<10} {} = {}",
                "printed",
                quantity.text,
                statement.printed
            );
            if let Some(explanation) = explained_by {
                say!(text, "  {:<10} {}", "explained", explanation.text);
            }
        }
        Content::Check => say!(text, "  {:<10} {}", "claimed", statement.printed),
        Content::Garbled => say!(text, "  {:<10} {}", "verbatim", statement.printed),
        Content::Cell { .. } | Content::Table(_) => {
            say!(text, "  {:<10} {}", "printed", statement.printed);
        }
    }
    if let Some(condition) = &statement.condition {
        formula_lines(text, "only if", &condition.text.formula);
    }
    if let (Some(correct), true) = (&statement.correct, judgement.verdict.is_erratum()) {
        formula_lines(text, "right", &correct.formula);
    } else if let Some(corrected) = &judgement.corrected {
        say!(text, "  {:<10} {corrected}", "right");
    }
    if let Some(computed) = &judgement.computed {
        say!(text, "  {:<10} {computed}", "computed");
    }
    if let Some(certified) = &judgement.certified {
        say!(text, "  {:<10} {certified}", "certified");
    }
    if let Some(convention) = &statement.convention {
        say!(text, "  {:<10} {convention}", "convention");
    }
}

fn verdict(text: &mut String, statement: &Statement, judgement: &Judgement) {
    let name = style::verdict(&judgement.verdict.to_string(), judgement.verdict);
    say!(
        text,
        "  {:<10} {name}: {}",
        "verdict",
        judgement.verdict.meaning()
    );
    say!(
        text,
        "  {:<10} {}: {}",
        "proof",
        judgement.proof,
        judgement.basis()
    );
    if statement.expected != judgement.verdict {
        say!(
            text,
            "  {:<10} {}, which is not what was found",
            "expected",
            statement.expected
        );
    }
    if let (Some(cause), true) = (statement.cause, judgement.verdict.is_erratum()) {
        say!(text, "  {:<10} {cause}", "cause");
    }
    let mut label = "fails for";
    for (name, value) in &judgement.counterexample {
        say!(text, "  {label:<10} {name} = {value}");
        label = "";
    }
    if let Some(counts) = &judgement.mutants {
        say!(
            text,
            "  {:<10} {} tried, {} rejected, {} proved equivalent, {} undecided",
            "mutants",
            counts.tried,
            counts.rejected,
            counts.equivalent,
            counts.undecided
        );
        for survivor in &counts.survivors {
            say!(text, "  {:<10} undecided: {survivor}", "");
        }
        if counts.rejected > 0 {
            say!(
                text,
                "  {:<10} rejected by exact configurations of the scene",
                ""
            );
        }
    }
    say!(
        text,
        "  {:<10} {}",
        "evidence",
        judgement.evidence.join(", ")
    );
    for finding in &judgement.findings {
        say!(text, "  {:<10} {}", "found", style::folded(finding, 84, 13));
    }
    if let Some(note) = &statement.note {
        say!(text, "  {:<10} {}", "note", style::folded(note, 84, 13));
    }
}

fn scene(text: &mut String, statement: &Statement) {
    let scene = statement.scene;
    say!(text, "  {:<10} {}", "scene", scene.name);
    say!(
        text,
        "  {:<10} {}",
        "",
        style::folded(scene.summary, 84, 13)
    );
    say!(text, "  {:<10} {}", "code", style::dim(scene.file));
    if let Some(example) = &statement.example {
        let given: Vec<String> = example
            .given
            .iter()
            .map(|(name, value)| format!("{name} = {value}"))
            .collect();
        say!(text, "  {:<10} {}", "given", given.join(", "));
    }
    for check in statement.checks.iter().filter_map(|name| find_check(name)) {
        say!(text, "  {:<10} {}", "check", check.name);
        say!(
            text,
            "  {:<10} {}",
            "",
            style::folded(check.summary, 84, 13)
        );
    }
    if let Content::Cell { table, .. } | Content::Table(table) = &statement.content {
        say!(text, "  {:<10} {}", "table", table.code.name);
        say!(
            text,
            "  {:<10} {}",
            "",
            style::folded(table.code.summary, 84, 13)
        );
    }
    let used = used_symbols(statement);
    let symbols = || {
        scene
            .symbols
            .iter()
            .filter(|symbol| used.is_empty() || used.iter().any(|name| name == symbol.name))
    };
    let width = symbols().map(|symbol| symbol.name.len()).max().unwrap_or(0);
    for symbol in symbols() {
        say!(
            text,
            "  {:<10} {:<width$}  {}",
            "",
            symbol.name,
            symbol.meaning
        );
    }
}

fn used_symbols(statement: &Statement) -> Vec<String> {
    let printed = match &statement.content {
        Content::Formula(printed) => Some(&printed.formula),
        Content::Value { quantity, .. } => Some(&quantity.formula),
        Content::Check | Content::Garbled | Content::Cell { .. } | Content::Table(_) => None,
    };
    printed
        .into_iter()
        .chain(statement.correct.as_ref().map(|correct| &correct.formula))
        .flat_map(Formula::symbols)
        .collect()
}
