//! `burmester solve`: new problems.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use burmester::oracle::{self, Arithmetic, Request};
use burmester::report;
use clap::ValueEnum;
use serde_json::Value;

use super::outcome::{Failure, print};
use super::whole_file::write_whole;
use super::{Format, readable};

/// Arguments of `solve`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A JSON file with one problem, or - for standard input
    #[arg(value_name = "FILE", default_value = "-")]
    file: PathBuf,
    /// One problem a line, one answer a line
    #[arg(long)]
    lines: bool,
    /// How to print (with --lines always json)
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Significant digits that are certified
    #[arg(long, value_name = "N", default_value_t = 30, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    digits: u32,
    /// What to compute with
    #[arg(long, value_enum, default_value_t = Chosen::Certified)]
    arithmetic: Chosen,
    /// Write a picture of the answer to this file
    #[arg(long, value_name = "FILE", conflicts_with = "lines")]
    svg: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Chosen {
    /// Exact numbers and enclosures
    Certified,
    /// Floats: fast, nothing certified
    F64,
}

/// No problem is longer than this: 16 MiB, of which a reader of JSON may make fifty times as much.
const MOST_BYTES: u64 = 1 << 24;

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let request = Request {
        digits: arguments.digits,
        arithmetic: match arguments.arithmetic {
            Chosen::Certified => Arithmetic::Certified,
            Chosen::F64 => Arithmetic::Float,
        },
    };
    let name = shown(&arguments.file);
    let input =
        open(&arguments.file).map_err(|error| Failure::wrong(format!("{name}: {error}")))?;
    if arguments.lines {
        let mut input = BufReader::new(input);
        for number in 1_u64.. {
            let place = format!("{name}:{number}");
            let line = bounded(&place, |text| {
                input.by_ref().take(MOST_BYTES + 1).read_line(text)
            })?;
            if line.is_empty() {
                break;
            }
            if !line.trim().is_empty() {
                print(&format!("{}\n", solved(&line, &place, &request)?.1))?;
            }
        }
    } else {
        let text = bounded(&name, |text| {
            input.take(MOST_BYTES + 1).read_to_string(text)
        })?;
        if text.trim().is_empty() {
            return Err(Failure::wrong(format!(
                "{name}: the input is empty; a problem as a JSON object was expected"
            )));
        }
        let (problem, answer) = solved(&text, &name, &request)?;
        if let Some(file) = &arguments.svg {
            let picture = report::picture(&problem, &answer).ok_or_else(|| {
                Failure::wrong(format!(
                    "{name}: there is no picture of this answer; solve it without --svg"
                ))
            })?;
            write_whole(file, &picture)
                .map_err(|error| Failure::wrong(format!("{}: {error}", file.display())))?;
        }
        print(&match arguments.format {
            Format::Json => format!("{answer}\n"),
            Format::Text => readable::answer(&answer),
        })?;
    }
    Ok(ExitCode::SUCCESS)
}

fn shown(file: &Path) -> String {
    if file == Path::new("-") {
        "standard input".to_owned()
    } else {
        file.display().to_string()
    }
}

/// What is read, unless it is too long or no text.
fn bounded(
    place: &str,
    read: impl FnOnce(&mut String) -> io::Result<usize>,
) -> Result<String, Failure> {
    let mut text = String::new();
    let length = read(&mut text).map_err(|error| Failure::wrong(format!("{place}: {error}")))?;
    if u64::try_from(length).is_ok_and(|length| length <= MOST_BYTES) {
        return Ok(text);
    }
    Err(Failure::wrong(format!(
        "{place}: longer than {} MiB, which no problem is",
        MOST_BYTES >> 20
    )))
}

fn open(file: &Path) -> io::Result<Box<dyn Read>> {
    if file == Path::new("-") {
        Ok(Box::new(io::stdin()))
    } else {
        Ok(Box::new(File::open(file)?))
    }
}

/// The problem and its answer.
fn solved(text: &str, place: &str, request: &Request) -> Result<(Value, Value), Failure> {
    let problem: Value = serde_json::from_str(text)
        .map_err(|error| Failure::wrong(format!("{place}: no JSON: {error}")))?;
    let answer = oracle::solve(&problem, request)
        .map_err(|error| Failure::wrong(format!("{place}: {error}")))?;
    Ok((problem, answer))
}
