//! `burmester verify`: every statement of every source.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::process::ExitCode;

use burmester::ledger::{Decided, Judged, Judgement, Options, Paper, Proof, Statement, Verdict};
use serde_json::{Map, Value, json};

use super::outcome::{Failure, print};
use super::progress::Progress;
use super::{Data, Format, style};

/// Arguments of `verify`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Sources to decide, by key (all if left out)
    #[arg(value_name = "SOURCE")]
    sources: Vec<String>,
    /// How to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Significant digits of computed values
    #[arg(long, value_name = "N", default_value_t = 30, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    digits: u32,
    /// Try the mutants of every formula too
    #[arg(long)]
    mutants: bool,
    #[command(flatten)]
    data: Data,
}

impl Default for Arguments {
    fn default() -> Self {
        Arguments {
            sources: Vec::new(),
            format: Format::Text,
            digits: 30,
            mutants: false,
            data: Data { data: None },
        }
    }
}

fn is_as_expected(decided: Decided<'_>) -> bool {
    decided.judgement.verdict == decided.statement.expected
}

/// Writing to a string cannot fail.
macro_rules! say {
    ($text:expr, $($argument:tt)*) => {{
        let _ = writeln!($text, $($argument)*);
    }};
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let papers = chosen(arguments.data.papers()?, &arguments.sources)?;
    let total = papers.iter().map(|paper| paper.statements.len()).sum();
    let progress = Progress::of(total, "statements");
    let options = Options {
        digits: usize::try_from(arguments.digits).unwrap_or(usize::MAX),
        mutants: arguments.mutants,
    };
    let decided = Judged::all(&papers, options, || progress.step())
        .map_err(|error| Failure::wrong(error.to_string()))?;
    drop(progress);
    let text = match arguments.format {
        Format::Json => json_lines(&decided),
        Format::Text => for_a_person(&decided),
    };
    print(&text)?;
    let all_as_expected = decided.iter().flat_map(Judged::decided).all(is_as_expected);
    Ok(ExitCode::from(u8::from(!all_as_expected)))
}

fn chosen(papers: Vec<Paper>, keys: &[String]) -> Result<Vec<Paper>, Failure> {
    if keys.is_empty() {
        return Ok(papers);
    }
    let known: Vec<String> = papers.iter().map(|paper| paper.key.clone()).collect();
    if let Some(unknown) = keys.iter().find(|key| !known.contains(key)) {
        return Err(Failure::wrong(format!(
            "unknown source `{unknown}`; there are {}",
            known.join(", ")
        )));
    }
    Ok(papers
        .into_iter()
        .filter(|paper| keys.contains(&paper.key))
        .collect())
}

fn json_lines(decided: &[Judged<'_>]) -> String {
    let mut text = String::new();
    for one in decided.iter().flat_map(Judged::decided) {
        text.push_str(&Value::Object(line(one)).to_string());
        text.push('\n');
    }
    text
}

/// One line of the JSON output; fields that say nothing are left out.
fn line(decided: Decided<'_>) -> Map<String, Value> {
    let Decided {
        statement,
        judgement,
    } = decided;
    let mut line = Map::new();
    let mut put = |name: &str, value: Value| {
        if !value.is_null() {
            line.insert(name.to_owned(), value);
        }
    };
    put("id", json!(statement.id));
    put("verdict", json!(judgement.verdict));
    put("proof", json!(judgement.proof));
    put("scene", json!(statement.scene.name));
    put("printed", json!(statement.printed));
    put("computed", json!(judgement.computed));
    put("certified", json!(judgement.certified));
    put("convention", json!(statement.convention));
    put("corrected", json!(judgement.corrected));
    if judgement.verdict.is_erratum() {
        put("cause", json!(statement.cause));
        put("inherited_from", json!(statement.inherited_from));
    }
    put("instances", json!(judgement.instances));
    put("samples", json!(judgement.samples));
    put("mutants", json!(judgement.mutants));
    put("evidence", json!(judgement.evidence));
    if !judgement.counterexample.is_empty() {
        let values = judgement.counterexample.iter().cloned();
        let object: Map<String, Value> = values
            .map(|(name, value)| (name, Value::String(value)))
            .collect();
        put("counterexample", Value::Object(object));
    }
    let notes: Vec<&str> = statement
        .note
        .iter()
        .chain(&judgement.findings)
        .map(String::as_str)
        .collect();
    if !notes.is_empty() {
        put("note", json!(notes.join(" ")));
    }
    line
}

fn for_a_person(decided: &[Judged<'_>]) -> String {
    let mut text = String::new();
    push(&mut text, &table(decided));
    push(&mut text, &errata(decided));
    push(&mut text, &mutants(decided));
    push(&mut text, &differences(decided));
    text
}

fn push(text: &mut String, part: &str) {
    if !part.is_empty() {
        if !text.is_empty() {
            text.push('\n');
        }
        text.push_str(part);
    }
}

/// A row for each source, a column for each verdict that occurs.
fn table(decided: &[Judged<'_>]) -> String {
    let all = || decided.iter().flat_map(Judged::decided);
    let verdicts: BTreeSet<Verdict> = all().map(|one| one.judgement.verdict).collect();
    let left = |source: &Judged<'_>| source.paper.total - source.judgements.len();
    let open = decided.iter().any(|source| left(source) > 0);
    let width = decided
        .iter()
        .map(|source| source.paper.key.len())
        .max()
        .unwrap_or(0);
    let mut text = String::new();
    let mut head = format!("{:width$}  statements", "");
    for verdict in &verdicts {
        let name = verdict.to_string();
        let column = name.len().max(5);
        let _ = write!(
            head,
            "  {}",
            style::verdict(&format!("{name:>column$}"), *verdict)
        );
    }
    if open {
        head.push_str("  not yet decided");
    }
    say!(text, "{head}");
    for source in decided {
        let mut row = format!(
            "{}  {:>10}",
            style::bold(&format!("{:width$}", source.paper.key)),
            source.paper.total
        );
        for verdict in &verdicts {
            let count = source
                .judgements
                .iter()
                .filter(|judgement| judgement.verdict == *verdict)
                .count();
            let column = verdict.to_string().len().max(5);
            let _ = write!(row, "  {:>column$}", number(count));
        }
        if open {
            let _ = write!(row, "  {:>15}", number(left(source)));
        }
        say!(text, "{row}");
    }
    let mut proofs: BTreeMap<Proof, usize> = BTreeMap::new();
    for one in all() {
        *proofs.entry(one.judgement.proof).or_default() += 1;
    }
    let proofs: Vec<String> = proofs
        .iter()
        .map(|(proof, count)| format!("{count} {proof}"))
        .collect();
    say!(text, "{:width$}  {}", "proofs", proofs.join(", "));
    text
}

/// Nothing is quieter than a zero.
fn number(count: usize) -> String {
    if count == 0 {
        "·".to_owned()
    } else {
        count.to_string()
    }
}

fn errata(decided: &[Judged<'_>]) -> String {
    let mut text = String::new();
    for one in decided.iter().flat_map(Judged::decided) {
        if one.judgement.verdict.is_erratum() {
            if text.is_empty() {
                say!(text, "{}", style::bold("Errata"));
            }
            text.push_str(&erratum(one));
        }
    }
    text
}

fn erratum(decided: Decided<'_>) -> String {
    let Decided {
        statement,
        judgement,
    } = decided;
    let mut text = String::new();
    let name = style::verdict(&judgement.verdict.to_string(), judgement.verdict);
    say!(
        text,
        "  {}  {}, {name}{}",
        style::bold(&statement.id),
        statement.locus,
        cause(statement)
    );
    say!(text, "      printed   {}", statement.printed);
    if let Some(corrected) = &judgement.corrected {
        say!(text, "      right     {corrected}");
    }
    if let Some(computed) = &judgement.computed {
        say!(text, "      computed  {computed}");
    }
    if let Some(certified) = &judgement.certified {
        say!(text, "      certified {certified}");
    }
    say!(text, "      known by  {}", known_by(judgement));
    for finding in &judgement.findings {
        say!(text, "      found     {}", style::folded(finding, 84, 16));
    }
    if let Some(note) = &statement.note {
        say!(text, "      note      {}", style::folded(note, 84, 16));
    }
    text
}

fn cause(statement: &Statement) -> String {
    let cause = statement.cause;
    cause.map_or(String::new(), |cause| format!(", {}", cause.in_words()))
}

/// How a wrong line is known to be wrong.
fn known_by(judgement: &Judgement) -> String {
    let what = match judgement.proof {
        Proof::Identity => "an identity",
        Proof::Exact => "exact arithmetic",
        Proof::Instances => "exact instances",
        Proof::Certified => "a rigorous enclosure",
        Proof::Numeric => "samples",
    };
    let values: Vec<String> = judgement
        .counterexample
        .iter()
        .filter(|(_, value)| value.len() < 20)
        .take(6)
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    if values.is_empty() {
        what.to_owned()
    } else {
        format!("{what}; it fails where {}", values.join(", "))
    }
}

fn mutants(decided: &[Judged<'_>]) -> String {
    let mut text = String::new();
    let (mut tried, mut rejected, mut equivalent) = (0, 0, 0);
    for one in decided.iter().flat_map(Judged::decided) {
        let Some(counts) = &one.judgement.mutants else {
            continue;
        };
        tried += counts.tried;
        rejected += counts.rejected;
        equivalent += counts.equivalent;
        for survivor in &counts.survivors {
            say!(text, "      undecided  {}  {survivor}", one.statement.id);
        }
    }
    if tried == 0 {
        return text;
    }
    let undecided = tried - rejected - equivalent;
    let summary = format!(
        "  {tried} tried, {rejected} rejected, {equivalent} proved equivalent, {undecided} undecided\n"
    );
    format!("{}\n{summary}{text}", style::bold("Mutants"))
}

fn differences(decided: &[Judged<'_>]) -> String {
    let mut text = String::new();
    let mut count = 0;
    for one in decided.iter().flat_map(Judged::decided) {
        count += 1;
        if !is_as_expected(one) {
            say!(
                text,
                "  {}: expected {}, found {}{}",
                one.statement.place(),
                one.statement.expected,
                style::verdict(&one.judgement.verdict.to_string(), one.judgement.verdict),
                one.judgement
                    .findings
                    .iter()
                    .map(|finding| format!("; {finding}"))
                    .collect::<String>(),
            );
        }
    }
    if text.is_empty() {
        return format!("All {count} verdicts are the expected ones.\n");
    }
    format!("{}\n{text}", style::bold("Not as expected"))
}
