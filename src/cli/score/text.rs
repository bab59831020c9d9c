//! The scores for a person.

use burmester::oracle::score::corpus::Problem;
use burmester::oracle::score::{Case, Line, Mark, Outcome, Tally, by_corpus, tallies};

use super::Run;
use super::asked::Asked;
use crate::cli::style;

/// So many of the worst cases are listed.
pub const WORST: usize = 10;

const HEADS: [&str; 11] = [
    "kind",
    "problems",
    "skipped",
    "lost",
    "found",
    "missed",
    "invented",
    "facts",
    "digits",
    "degenerate",
    "time",
];

const LEGEND: &str = "\
skipped     the candidate declined, or stated nothing that is scored
lost        no answer: it stopped, was too slow, wrote no answer, or gave up
found       certified solutions that the candidate gave, of all where it answered
missed      those that it did not give
invented    solutions that it gave and that do not exist
facts       words and counts that it stated rightly, of all that it stated
digits      correct digits of what was found, worst and middle
degenerate  cases out of the ordinary (infinitely many, at infinity, multiple) where all
            that makes them so was stated, and nothing wrong, of all such cases
time        of a problem, middle, and of all
A solution is found within 1e-6 of its size, or within a thousand times what double precision
allows at the problem's conditioning, whichever is larger.
A multiple one may be given once or as often as it counts, a little torn apart by rounding.
";

/// Table, legend and the worst cases.
pub fn report(run: &Run<'_>) -> String {
    let all: Vec<&Case> = run.cases.iter().collect();
    let kinds = tallies(&run.cases);
    let mut rows: Vec<Vec<String>> = vec![HEADS.map(str::to_owned).into()];
    let corpora = by_corpus(&run.cases);
    for corpus in &corpora {
        rows.push(row(&corpus.corpus, corpus));
        // Of one kind alone, and of what is declined altogether, the sum says enough.
        let kinds = kinds.iter().filter(|kind| {
            kind.corpus == corpus.corpus
                && kind.problems < corpus.problems
                && kind.skipped < kind.problems
        });
        rows.extend(kinds.map(|kind| row(&format!("  {}", kind.kind), kind)));
    }
    if corpora.len() > 1 {
        rows.push(row("all", &Tally::of(&all)));
    }
    let mut text = table(&rows);
    text += &format!("\n{LEGEND}");
    text += &compared(&run.cases);
    let worst = run.worst();
    if !worst.is_empty() {
        let head = format!(
            "Not right, or fewer than 6 digits: {} problems; one of each sort, with the call that shows it",
            worst.len()
        );
        text += &format!("\n{}\n", style::bold(&head));
        let sorts = sorts(&worst);
        for (case, count) in sorts.iter().take(WORST) {
            let like = match count {
                1 => String::new(),
                _ => format!(" (and {} more like it)", count - 1),
            };
            text += &format!("{}: {}{like}\n", case.id, summary(case));
            text += &format!("    {}\n", style::dim(&run.rerun(case)));
        }
        if sorts.len() > WORST {
            let more = sorts.len() - WORST;
            text += &format!("and {more} more sorts; all problems with --format json\n");
        }
    }
    text
}

/// How the solutions were compared.
fn compared(cases: &[Case]) -> String {
    let comparisons = cases.iter().filter_map(|case| match &case.outcome {
        Outcome::Scored(verdict) => Some(verdict.comparisons),
        _ => None,
    });
    let [mut made, mut exact] = [0, 0];
    for one in comparisons {
        made += one.made;
        exact += one.exact;
    }
    match made {
        0 => String::new(),
        _ => {
            format!("{made} pairs of solutions were compared, {exact} of them in exact numbers.\n")
        }
    }
}

/// Cases that are wrong in the same way: the first of them and their number.
fn sorts<'a>(cases: &[&'a Case]) -> Vec<(&'a Case, usize)> {
    let mut sorts: Vec<(&Case, usize)> = Vec::new();
    for &case in cases {
        match sorts
            .iter_mut()
            .find(|(first, _)| fault(first) == fault(case))
        {
            Some((_, count)) => *count += 1,
            None => sorts.push((case, 1)),
        }
    }
    sorts
}

/// Why a case is lost; else its kind, and what is worst about it.
fn fault(case: &Case) -> [String; 3] {
    let marks = [Mark::Invented, Mark::Missed, Mark::Wrong];
    match &case.outcome {
        Outcome::Lost(reason) | Outcome::Skipped(reason) => {
            [String::new(), String::new(), reason.clone()]
        }
        Outcome::Scored(_) => {
            let worst = marks.into_iter().find(|mark| case.count(*mark) > 0);
            let worst = worst.map_or("inexact".to_owned(), |mark| mark.to_string());
            [case.corpus.clone(), case.kind.clone(), worst]
        }
    }
}

fn row(head: &str, tally: &Tally) -> Vec<String> {
    let of = |part: usize, whole: usize| match whole {
        0 => "-".to_owned(),
        _ => format!("{part}/{whole}"),
    };
    vec![
        head.to_owned(),
        tally.problems.to_string(),
        tally.skipped.to_string(),
        tally.lost.to_string(),
        of(tally.found, tally.found + tally.missed),
        tally.missed.to_string(),
        tally.invented.to_string(),
        of(tally.facts_right, tally.facts_right + tally.facts_wrong),
        tally.digits.map_or("-".to_owned(), |digits| {
            format!("{:.1} {:.1}", digits.worst, digits.median)
        }),
        of(tally.degenerate_right, tally.degenerate),
        format!(
            "{} {}",
            time(tally.seconds_median),
            time(tally.seconds_total)
        ),
    ]
}

fn time(seconds: f64) -> String {
    if seconds < 0.001 {
        format!("{:.0} µs", seconds * 1e6)
    } else if seconds < 1.0 {
        format!("{:.1} ms", seconds * 1e3)
    } else {
        format!("{seconds:.1} s")
    }
}

/// The first column to the left, the others to the right.
fn table(rows: &[Vec<String>]) -> String {
    let columns = rows.first().map_or(0, Vec::len);
    let width = |column: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for (index, row) in rows.iter().enumerate() {
        let cells = row.iter().zip(&widths).enumerate();
        let cells: Vec<String> = cells
            .map(|(column, (cell, width))| match column {
                0 => format!("{cell:<width$}"),
                _ => format!("{cell:>width$}"),
            })
            .collect();
        let line = cells.join("  ");
        text += &if index == 0 { style::bold(&line) } else { line };
        text.push('\n');
    }
    text
}

fn summary(case: &Case) -> String {
    match &case.outcome {
        Outcome::Skipped(reason) => format!("skipped: {reason}"),
        Outcome::Lost(reason) => format!("lost: {reason}"),
        Outcome::Scored(_) => {
            let marks = [
                (Mark::Found, "found"),
                (Mark::Missed, "missed"),
                (Mark::Invented, "invented"),
                (Mark::Wrong, "facts wrong"),
            ];
            let counted = marks.map(|(mark, word)| (case.count(mark), word));
            let said = counted.iter().filter(|(count, _)| *count > 0);
            let said: Vec<String> = said
                .map(|(count, word)| format!("{count} {word}"))
                .collect();
            let worst = case
                .digits()
                .first()
                .map(|digits| format!("{digits:.1} digits"));
            let said: Vec<String> = said.into_iter().chain(worst).collect();
            if said.is_empty() {
                "nothing missed or invented".to_owned()
            } else {
                said.join(", ")
            }
        }
    }
}

/// One problem with what is certified and what is given.
pub fn side_by_side(problem: &Problem, asked: &Asked) -> String {
    let case = &asked.case;
    let mut text = format!("{}\n{}\n\n", style::bold("Problem"), problem.problem);
    if let Some(line) = &asked.line {
        let line: String = line.trim().chars().take(4000).collect();
        text += &format!("{}\n{line}\n\n", style::bold("The candidate's line"));
    }
    text += &format!(
        "{} in {}; relative error allowed: {:.1e}\n",
        style::bold(&summary(case)),
        time(case.seconds),
        problem.reference.tolerance()
    );
    let Outcome::Scored(verdict) = &case.outcome else {
        return text;
    };
    let (wrong, right): (Vec<&Line>, Vec<&Line>) =
        verdict.lines.iter().partition(|line| !line.mark.is_good());
    for line in wrong.into_iter().chain(right) {
        let found = line
            .closeness
            .map(|closeness| format!(", {:.1} digits", closeness.digits()));
        let invented = line
            .nearest
            .map(|digits| format!(", {digits:.1} digits of the nearest certified"));
        text += &format!(
            "\n{}: {}{}\n",
            line.place,
            line.mark,
            found.or(invented).unwrap_or_default()
        );
        for (name, side) in [("certified", &line.certified), ("given", &line.given)] {
            text += &format!("  {name:<9}  {}\n", side.as_deref().unwrap_or("-"));
        }
    }
    text
}
