//! `burmester report`: a static site with every statement, its verdict and how that is known.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use burmester::ledger::{self, Judged, Options, Paper};
use burmester::report::site::{File, site, steps};

use super::outcome::{Failure, print};
use super::progress::Progress;
use super::whole_file::write_whole;

/// Arguments of `report`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The folder to write
    #[arg(short, long, value_name = "DIR", default_value = "site")]
    output: PathBuf,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let folder = &arguments.output;
    let unwritable = |path: &Path, error: io::Error| {
        Failure::wrong(format!(
            "{}: {error}; -o names the folder to write",
            path.display()
        ))
    };
    // Before the work, not after it.
    fs::create_dir_all(folder).map_err(|error| unwritable(folder, error))?;
    let papers = ledger::built_in().map_err(|error| Failure::wrong(error.to_string()))?;
    let sources = judged(&papers)?;
    let progress = Progress::of(steps(&sources), "parts of the site");
    let files =
        site(&sources, || progress.step()).map_err(|error| Failure::wrong(error.to_string()))?;
    drop(progress);
    for file in &files {
        let path = folder.join(&file.path);
        write(&path, file).map_err(|error| unwritable(&path, error))?;
    }
    let pages = files
        .iter()
        .filter(|file| file.path.ends_with(".html"))
        .count();
    print(&format!(
        "{pages} pages; open {}\n",
        folder.join("index.html").display()
    ))?;
    Ok(ExitCode::SUCCESS)
}

fn write(path: &Path, file: &File) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    write_whole(path, &file.text)
}

fn judged(papers: &[Paper]) -> Result<Vec<Judged<'_>>, Failure> {
    let total = papers.iter().map(|paper| paper.statements.len()).sum();
    let progress = Progress::of(total, "statements");
    let options = Options {
        digits: 30,
        mutants: false,
    };
    Judged::all(papers, options, || progress.step())
        .map_err(|error| Failure::wrong(error.to_string()))
}
