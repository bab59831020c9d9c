//! `burmester vectors`: corpora of problems and their certified answers.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;

use burmester::oracle::certificate::{Defect, check_answer};
use burmester::oracle::vectors::{
    CORPORA, Corpus, Entry, Folder, StoreError, answer_line, defects_of_form,
};
use clap::Subcommand;
use serde_json::Value;

use super::outcome::{Failure, print};
use super::progress::Progress;
use super::{readable, style};

/// Without `--all`, `check` computes every so manyth answer anew.
const SAMPLE: usize = 20;

/// What to do with the corpora.
#[derive(Subcommand)]
pub enum Command {
    /// Name all corpora, with how many problems of how many kinds they hold
    List {
        #[command(flatten)]
        data: Data,
    },
    /// Show one problem, its certified answer, and what its flags mean
    ///
    /// Example: burmester vectors show degenerate-five-positions/double
    Show {
        /// The id of the problem, as in the files
        #[arg(value_name = "ID")]
        id: String,
        #[command(flatten)]
        data: Data,
    },
    /// Write problems and answers anew
    ///
    /// The same on every machine, byte by byte: problems depend on a seed, answers on the problem.
    Make {
        /// Where to write `problems` and `answers`
        #[arg(long, value_name = "DIR", default_value = "data")]
        out: PathBuf,
        /// Corpora to make (all if left out)
        #[arg(value_name = "NAME")]
        names: Vec<String>,
    },
    /// Check the form of every line, the hashes, and the answers
    ///
    /// Every answer is checked against its problem without the solver that made it, as far as there is a
    /// checker for its kind; every twentieth is computed anew. Ends with status 0 when nothing is
    /// wrong, 1 otherwise, 2 for a wrong call or a file that cannot be read.
    Check {
        /// Corpora to check (all if left out)
        #[arg(value_name = "NAME")]
        names: Vec<String>,
        /// Compute every answer anew
        #[arg(long)]
        all: bool,
        #[command(flatten)]
        data: Data,
    },
}

/// Where the files are.
#[derive(clap::Args)]
pub struct Data {
    /// The folder with `problems` and `answers`
    #[arg(long = "data", value_name = "DIR", default_value = "data")]
    folder: PathBuf,
}

impl Data {
    fn folder(&self) -> Folder {
        Folder::at(&self.folder)
    }
}

/// Runs the command.
pub fn run(command: &Command) -> Result<ExitCode, Failure> {
    match command {
        Command::List { data } => list(&data.folder()),
        Command::Show { id, data } => show(id, &data.folder()),
        Command::Make { out, names } => make(&Folder::at(out), names),
        Command::Check { names, all, data } => check(&data.folder(), names, *all),
    }
}

fn failed(error: StoreError) -> Failure {
    Failure::wrong(error.to_string())
}

fn chosen(names: &[String]) -> Result<Vec<&'static Corpus>, Failure> {
    if names.is_empty() {
        return Ok(CORPORA.iter().collect());
    }
    names.iter().map(|name| named(name)).collect()
}

fn named(name: &str) -> Result<&'static Corpus, Failure> {
    Corpus::named(name).ok_or_else(|| {
        let known: Vec<&str> = CORPORA.iter().map(|corpus| corpus.name).collect();
        Failure::wrong(format!(
            "unknown corpus `{name}`; there are {}",
            known.join(", ")
        ))
    })
}

/// Writing to a string cannot fail.
macro_rules! say {
    ($text:expr, $($argument:tt)*) => {{
        let _ = writeln!($text, $($argument)*);
    }};
}

fn list(folder: &Folder) -> Result<ExitCode, Failure> {
    let mut text = String::new();
    let mut total = 0;
    for corpus in &CORPORA {
        let problems = folder.problem_lines(corpus.name).map_err(failed)?;
        let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
        for problem in &problems {
            *kinds
                .entry(problem["kind"].as_str().unwrap_or_default())
                .or_default() += 1;
        }
        total += problems.len();
        let counts = format!("{} problems, {} kinds", problems.len(), kinds.len());
        say!(
            text,
            "{}  {}",
            style::bold(corpus.name),
            style::dim(&counts)
        );
        say!(text, "    {}", style::folded(corpus.description, 92, 4));
        if kinds.len() <= 12 {
            let listed: Vec<&str> = kinds.keys().copied().collect();
            let line = format!("kinds: {}", listed.join(", "));
            say!(text, "    {}", style::dim(&style::folded(&line, 92, 4)));
        }
    }
    say!(text, "{total} problems in {} corpora", CORPORA.len());
    print(&text)?;
    Ok(ExitCode::SUCCESS)
}

fn show(id: &str, folder: &Folder) -> Result<ExitCode, Failure> {
    let (corpus, _) = id.split_once('/').ok_or_else(|| {
        Failure::wrong(format!(
            "`{id}` is no id of a problem; they look like hart/0001"
        ))
    })?;
    let corpus = named(corpus)?;
    let entries = folder.entries(corpus.name).map_err(failed)?;
    let entry = entries
        .into_iter()
        .find(|entry| entry.problem.get("id").is_some_and(|own| own == id))
        .ok_or_else(|| {
            Failure::wrong(format!(
                "there is no problem `{id}` in the corpus {}",
                corpus.name
            ))
        })?;
    let flags = folder.flags().map_err(failed)?;
    print(&shown(&entry, &flags))?;
    Ok(ExitCode::SUCCESS)
}

fn shown(entry: &Entry, flags: &serde_json::Map<String, Value>) -> String {
    let Entry { problem, answer } = entry;
    let mut text = String::new();
    let word = |name: &str| problem[name].as_str().unwrap_or_default();
    say!(text, "{}  {}", style::bold(word("id")), word("kind"));
    if let Some(note) = problem["note"].as_str() {
        say!(text, "{}", style::folded(note, 96, 0));
    }
    for flag in problem["flags"].as_array().into_iter().flatten() {
        let flag = flag.as_str().unwrap_or_default();
        let meaning = flags.get(flag).and_then(Value::as_str).unwrap_or("?");
        say!(text, "flag {flag}: {}", style::folded(meaning, 84, 4));
    }
    if problem["claims"]
        .as_object()
        .is_some_and(|claims| !claims.is_empty())
    {
        say!(text, "claims: {}", problem["claims"]);
    }
    let mut input = problem.clone();
    if let Value::Object(fields) = &mut input {
        for meta in ["id", "kind", "flags", "note", "claims"] {
            fields.shift_remove(meta);
        }
    }
    say!(text, "{}\n{input}", style::bold("problem"));
    say!(text, "{}", style::bold("answer"));
    text.push_str(&readable::answer(&answer["answer"]));
    let condition = &answer["condition"];
    if condition.is_null() {
        say!(
            text,
            "condition: none, the answer does not change smoothly with the problem"
        );
    } else {
        say!(
            text,
            "condition: {condition} (relative change of the answer per relative change of the problem)"
        );
    }
    text
}

fn make(folder: &Folder, names: &[String]) -> Result<ExitCode, Failure> {
    let corpora = chosen(names)?;
    let drawn: Vec<(&Corpus, Vec<String>)> = corpora
        .into_iter()
        .map(|corpus| (corpus, corpus.lines()))
        .collect();
    let total = drawn.iter().map(|(_, lines)| lines.len()).sum();
    let progress = Progress::of(total, "problems");
    let mut text = String::new();
    for (corpus, problems) in &drawn {
        let mut answers = Vec::new();
        for line in problems {
            answers.push(answered(line)?.to_string());
            progress.step();
        }
        folder.write(corpus, problems, &answers).map_err(failed)?;
        say!(text, "{}: {} problems", corpus.name, problems.len());
    }
    drop(progress);
    print(&text)?;
    Ok(ExitCode::SUCCESS)
}

fn answered(line: &str) -> Result<Value, Failure> {
    let problem: Value =
        serde_json::from_str(line).map_err(|error| Failure::wrong(error.to_string()))?;
    answer_line(&problem).map_err(|error| {
        let id = problem.get("id").unwrap_or(&Value::Null);
        Failure::wrong(format!("{id}: {error}"))
    })
}

/// What a check found of a corpus.
#[derive(Default)]
struct Findings {
    wrong: Vec<String>,
    certified: usize,
    /// Answers without a checker, by the reason.
    unchecked: BTreeMap<String, usize>,
    computed: usize,
}

fn check(folder: &Folder, names: &[String], all: bool) -> Result<ExitCode, Failure> {
    let corpora = chosen(names)?;
    let flags = folder.flags().map_err(failed)?;
    let recorded = folder.recorded().map_err(failed)?;
    let mut loaded = Vec::new();
    for corpus in corpora {
        loaded.push((corpus, folder.entries(corpus.name).map_err(failed)?));
    }
    let total = loaded.iter().map(|(_, entries)| entries.len()).sum();
    let progress = Progress::of(total, "answers");
    let mut text = String::new();
    let mut is_right = true;
    for (corpus, entries) in &loaded {
        let mut findings = Findings::default();
        let record = folder.record(corpus).map_err(failed)?;
        if recorded.get(corpus.name) != Some(&record) {
            findings.wrong.push(
                "corpora.json says something else of its files: they, or it, are old".to_owned(),
            );
        }
        let made = corpus.lines();
        for (place, entry) in entries.iter().enumerate() {
            let line = made.get(place).map(String::as_str).unwrap_or_default();
            let anew = all || place % SAMPLE == 0;
            examine(corpus, entry, &flags, line, anew, &mut findings);
            progress.step();
        }
        if made.len() != entries.len() {
            findings.wrong.push(format!(
                "{} problems instead of {}",
                entries.len(),
                made.len()
            ));
        }
        is_right &= findings.wrong.is_empty();
        report(corpus, entries.len(), &findings, &mut text);
    }
    drop(progress);
    print(&text)?;
    Ok(ExitCode::from(u8::from(!is_right)))
}

fn examine(
    corpus: &Corpus,
    entry: &Entry,
    flags: &serde_json::Map<String, Value>,
    made: &str,
    anew: bool,
    findings: &mut Findings,
) {
    let Entry { problem, answer } = entry;
    let id = problem["id"].as_str().unwrap_or("a line without id");
    let mut wrong = defects_of_form(corpus.name, entry, flags);
    if serde_json::from_str::<Value>(made).ok().as_ref() != Some(problem) {
        wrong.push("the problem is not the one that its generator makes".to_owned());
    }
    if anew {
        findings.computed += 1;
        match answer_line(problem) {
            Ok(line) if line == *answer => {}
            Ok(_) => wrong.push("the answer is not what is computed".to_owned()),
            Err(error) => wrong.push(error.to_string()),
        }
    }
    match check_answer(problem, &answer["answer"]) {
        Ok(()) => findings.certified += 1,
        Err(Defect::Unchecked { reason }) => *findings.unchecked.entry(reason).or_default() += 1,
        Err(defect) => wrong.push(defect.to_string()),
    }
    let wrong = wrong.into_iter().map(|message| format!("{id}: {message}"));
    findings.wrong.extend(wrong);
}

fn report(corpus: &Corpus, count: usize, findings: &Findings, text: &mut String) {
    let verdict = if findings.wrong.is_empty() {
        "right".to_owned()
    } else {
        format!("{} wrong", findings.wrong.len())
    };
    say!(
        text,
        "{}: {verdict}; {count} problems, {} answers computed anew, {} proven by the checker",
        style::bold(corpus.name),
        findings.computed,
        findings.certified,
    );
    for (reason, count) in &findings.unchecked {
        say!(text, "    {count} not checked: {reason}");
    }
    for line in &findings.wrong {
        say!(text, "    {line}");
    }
}
