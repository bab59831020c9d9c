//! The command line: one file per command, each thin.

mod candidate;
mod chart;
mod designer;
mod explain;
mod outcome;
mod progress;
mod readable;
mod report;
mod score;
mod solve;
mod style;
mod vectors;
mod verify;
mod whole_file;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand, ValueEnum};

use outcome::Failure;

/// A certified reference for planar linkage kinematics: what five classic sources say, decided line
/// by line, and new problems solved with proofs. Without a command it runs `verify`.
#[derive(Parser)]
#[command(version, max_term_width = 100)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    /// Decide every statement of every source (the main job)
    ///
    /// Ends with status 0 when every verdict is the expected one, 1 when one differs, 2 for a wrong
    /// call or wrong data.
    Verify(verify::Arguments),
    /// Show one statement in full: what is printed, what its symbols mean, the verdict and why
    Explain(explain::Arguments),
    /// Solve a problem given as JSON, with certified digits
    ///
    /// Problems: poles (2 to 9 positions), three-positions (positions, circlepoints, centers),
    /// centerpoint-curve (4 positions), five-positions (5 positions), mixed-positions (positions with
    /// derivatives, 5 in all), curvature (links or invariants, points), slider-crank-alternates (k,
    /// alpha_a, alpha_d), straight-line (a design: ball-burmester, watt, …), deviation (a design,
    /// levels), four-bar (O_a, A, B, O_b, D, or Q, R, S, T, M, epsilon, phi0, assembly),
    /// focal-mechanism (a, b, c, d, rho), hart (m, n, d, kappa).
    ///
    /// Numbers are strings ("3", "-5/13", "0.125") and taken exactly; angles are {"degrees": …},
    /// {"radians": …}, {"tan_half": …} or {"cos": …, "sin": …}; a position is {"x": …, "y": …,
    /// "angle": …} or, all of them, two points of the body {"points": [["x", "y"], ["x", "y"]]}.
    ///
    /// Example: echo '{"problem": "slider-crank-alternates", "k": "0.9", "alpha_a": {"degrees":
    /// "72.5"}, "alpha_d": {"degrees": "45"}}' | burmester solve
    Solve(solve::Arguments),
    /// Score another program's answers against certified ones
    ///
    /// Any program in any language is a candidate. It is started once, reads one problem a line (a
    /// JSON object) on standard input, and for each writes one line: {"result": ANSWER}, {"skipped":
    /// "why"} or {"error": "what"}. ANSWER is as `solve` gives it; numbers may be plain JSON numbers,
    /// and what the program does not know may be missing. It must flush its output after every line.
    ///
    /// Ends with status 0 when nothing is missed, invented or wrong and no problem is lost, 1
    /// otherwise, 2 for a wrong call or a command that cannot start.
    ///
    /// Example: burmester score --problems random -- python3 scripts/candidates/numpy_quartic.py
    Score(score::Arguments),
    /// Corpora of problems with certified answers, to test other programs with
    ///
    /// A corpus is a file of problems, one a line, and one of answers, joined by id. `list` names them,
    /// `show` explains one problem, `make` writes them anew and `check` compares them with what is
    /// computed.
    #[command(subcommand)]
    Vectors(vectors::Command),
    /// Make the chart of straight-line linkages with a Ball-double-Burmester point
    ///
    /// For all pairs of rays, in steps of a degree, how far the point goes within a hundredth of the
    /// linkage's size from its line, with type and proportions of the linkage: a table, and a picture with
    /// curves of equal length. Every digit is certified. What is done is kept when the command is
    /// interrupted, and the next call goes on from there.
    Chart(chart::Arguments),
    /// Write a site in which every statement of every source can be looked up
    ///
    /// A folder of static pages that need no network: one page a source, in the order of the print, with
    /// every formula, its verdict and how that is known; all errata as one list; pictures; the corpora of
    /// problems; the scores of other programs. Open index.html in a browser.
    Report(report::Arguments),
}

/// How an answer is printed.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For a person
    Text,
    /// For a program
    Json,
}

/// Where the statements come from.
#[derive(clap::Args)]
struct Data {
    /// Read the papers (*.toml) of this folder instead of those built in
    #[arg(long, value_name = "DIR")]
    data: Option<PathBuf>,
}

impl Data {
    fn papers(&self) -> Result<Vec<burmester::ledger::Paper>, Failure> {
        let papers = match &self.data {
            Some(folder) => burmester::ledger::read_folder(folder),
            None => burmester::ledger::built_in(),
        };
        papers.map_err(|error| Failure::wrong(error.to_string()))
    }
}

/// Runs the command that the arguments name.
pub fn run() -> ExitCode {
    let outcome = match Arguments::parse().command {
        None => verify::run(&verify::Arguments::default()),
        Some(Command::Verify(arguments)) => verify::run(&arguments),
        Some(Command::Explain(arguments)) => explain::run(&arguments),
        Some(Command::Solve(arguments)) => solve::run(&arguments),
        Some(Command::Score(arguments)) => score::run(&arguments),
        Some(Command::Vectors(command)) => vectors::run(&command),
        Some(Command::Chart(arguments)) => chart::run(&arguments),
        Some(Command::Report(arguments)) => report::run(&arguments),
    };
    match outcome {
        Ok(code) => code,
        Err(failure) => failure.report(),
    }
}
