//! `burmester score`: other programs against certified answers.

mod asked;
mod json;
mod junit;
mod text;

use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use burmester::oracle::score::Case;
use burmester::oracle::score::corpus::{self, Corpus, Problem};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::Format;
use super::candidate::Candidate;
use super::outcome::{Failure, print};

/// Arguments of `score`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A folder with problems/ and answers/, or the name of a corpus in data/ (all of data/ if left out)
    #[arg(long, value_name = "DIR|NAME")]
    problems: Option<String>,
    /// Ask this problem alone, and show what is expected and what is given side by side
    #[arg(long, value_name = "ID")]
    only: Option<String>,
    /// What the candidate may take for one problem
    #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds)]
    time_limit: Duration,
    /// How to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Write a JUnit report to this file too
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// The candidate and its arguments
    #[arg(last = true, required = true, value_name = "COMMAND")]
    command: Vec<String>,
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text
        .parse()
        .map_err(|_| "a number was expected".to_owned())?;
    if !(seconds > 0.0 && seconds <= 86_400.0) {
        return Err("above 0 and at most 86400 was expected".to_owned());
    }
    Ok(Duration::from_secs_f64(seconds))
}

/// All that was asked and how it came out.
pub struct Run<'a> {
    arguments: &'a Arguments,
    corpora: Vec<String>,
    cases: Vec<Case>,
}

impl Run<'_> {
    /// Cases that are not right, and those that only their condition excuses; the worst first.
    fn worst(&self) -> Vec<&Case> {
        let few = |case: &Case| case.digits().first().is_some_and(|&digits| digits < 6.0);
        let bad = |case: &&Case| !case.is_clean() || few(case);
        let mut worst: Vec<&Case> = self.cases.iter().filter(bad).collect();
        // Stable: equally bad ones stay in the order of the corpora.
        worst.sort_by(|a, b| {
            b.badness()
                .partial_cmp(&a.badness())
                .unwrap_or(std::cmp::Ordering::Equal)
        });
        worst
    }

    /// The call that asks this problem alone.
    fn rerun(&self, case: &Case) -> String {
        let arguments = self.arguments;
        let problems = arguments
            .problems
            .as_deref()
            .filter(|given| Path::new(given).is_dir());
        let mut words = vec!["burmester", "score", "--problems"];
        words.push(problems.unwrap_or(&case.corpus));
        words.extend(["--only", &case.id, "--"]);
        words.extend(arguments.command.iter().map(String::as_str));
        let quoted: Vec<String> = words.into_iter().map(quoted).collect();
        quoted.join(" ")
    }
}

/// A word as a shell reads it.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=:,+@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let corpora = corpora(arguments)?;
    let chosen: Vec<(&Corpus, &Problem)> = corpora
        .iter()
        .flat_map(|corpus| corpus.problems.iter().map(move |problem| (corpus, problem)))
        .filter(|(_, problem)| arguments.only.as_ref().is_none_or(|id| *id == problem.id))
        .collect();
    if chosen.is_empty() {
        let id = arguments.only.as_deref().unwrap_or_default();
        let names: Vec<&str> = corpora.iter().map(|corpus| corpus.name.as_str()).collect();
        let names = names.join(", ");
        return Err(Failure::wrong(format!(
            "--only: no problem `{id}` in {names}"
        )));
    }
    let shown: Vec<String> = arguments.command.iter().map(|word| quoted(word)).collect();
    let shown = shown.join(" ");
    let mut candidate = Candidate::start(&arguments.command)
        .map_err(|error| Failure::wrong(format!("{shown}: it cannot be started: {error}")))?;
    let progress = Progress::of(chosen.len());
    let mut cases = Vec::new();
    for (corpus, problem) in &chosen {
        let asked = asked::ask(&mut candidate, corpus, problem, arguments.time_limit)
            .map_err(|reason| Failure::wrong(format!("{shown}: {reason}")))?;
        if arguments.only.is_some() && arguments.format == Format::Text {
            print(&text::side_by_side(problem, &asked))?;
        }
        cases.push(asked.case);
        progress.step();
    }
    progress.bar.finish_and_clear();
    let run = Run {
        arguments,
        corpora: corpora.into_iter().map(|corpus| corpus.name).collect(),
        cases,
    };
    if let Some(file) = &arguments.junit {
        std::fs::write(file, junit::report(&run))
            .map_err(|error| Failure::wrong(format!("{}: {error}", file.display())))?;
    }
    match (arguments.format, &arguments.only) {
        (Format::Json, _) => print(&format!("{}\n", json::report(&run)))?,
        (Format::Text, None) => print(&text::report(&run))?,
        (Format::Text, Some(_)) => {}
    }
    let clean = run.cases.iter().all(Case::is_clean);
    Ok(if clean {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(1)
    })
}

/// A named corpus must be good; of all, those that cannot be used are named and left out.
fn corpora(arguments: &Arguments) -> Result<Vec<Corpus>, Failure> {
    let wrong = |error: corpus::CorpusError| Failure::wrong(format!("--problems: {error}"));
    match arguments.problems.as_deref() {
        Some(folder) if Path::new(folder).is_dir() => {
            let folder = Path::new(folder);
            let names = corpus::names(folder).map_err(wrong)?;
            let corpora = names.iter().map(|name| corpus::read(folder, name));
            corpora.collect::<Result<_, _>>().map_err(wrong)
        }
        Some(name) => {
            let folder = data()?;
            let known = corpus::names(&folder).map_err(wrong)?;
            if !known.iter().any(|other| other == name) {
                return Err(Failure::wrong(format!(
                    "--problems: `{name}` is no folder, and no corpus in {}; there: {}",
                    folder.display(),
                    known.join(", ")
                )));
            }
            Ok(vec![corpus::read(&folder, name).map_err(wrong)?])
        }
        None => {
            let folder = data()?;
            let mut corpora = Vec::new();
            for name in corpus::names(&folder).map_err(wrong)? {
                match corpus::read(&folder, &name) {
                    Ok(corpus) => corpora.push(corpus),
                    Err(error) => {
                        // Where standard error is closed nobody wants to know.
                        let _ = writeln!(std::io::stderr(), "burmester: left out: {error}");
                    }
                }
            }
            Ok(corpora)
        }
    }
}

/// The data of the folder that the user is in, else those that the program was built with.
fn data() -> Result<PathBuf, Failure> {
    let here = PathBuf::from("data");
    let built = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    let places = [here, built];
    let found = places.iter().find(|folder| folder.join("answers").is_dir());
    found.cloned().ok_or_else(|| {
        let places = places
            .each_ref()
            .map(|folder| folder.join("answers").display().to_string());
        Failure::wrong(format!(
            "no corpora: neither {} nor {} is a folder; name one with --problems",
            places[0], places[1]
        ))
    })
}

/// A bar on a terminal, once the work takes longer than two seconds.
struct Progress {
    bar: ProgressBar,
    started: Instant,
}

impl Progress {
    fn of(total: usize) -> Self {
        let total = u64::try_from(total).unwrap_or(u64::MAX);
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        // A template that cannot be read leaves the bar in its standard form.
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} problems, {eta} left")
        {
            bar.set_style(style);
        }
        Progress {
            bar,
            started: Instant::now(),
        }
    }

    fn step(&self) {
        if self.bar.is_hidden()
            && self.started.elapsed() > Duration::from_secs(2)
            && std::io::stderr().is_terminal()
        {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.inc(1);
    }
}
