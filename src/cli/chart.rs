//! `burmester chart`: how long linkages with a Ball-double-Burmester point keep to their lines.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use burmester::oracle::chart::{Rays, grid, header, row};
use burmester::report;
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;

use super::outcome::{Failure, print};
use super::progress::Progress;
use super::whole_file::write_whole;

const NAME: &str = "ball-double-burmester";

/// Arguments of `chart`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Where to write the table and the picture
    #[arg(short, long, value_name = "DIR", default_value = "data/charts")]
    out: PathBuf,
    /// Degrees between neighbours
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=45))]
    step: u32,
    /// How many processors to use (all if left out)
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let failed = |file: &Path| {
        let name = file.display().to_string();
        move |error: io::Error| Failure::wrong(format!("{name}: {error}"))
    };
    fs::create_dir_all(&arguments.out).map_err(failed(&arguments.out))?;
    let [table, picture] = ["csv", "svg"].map(|kind| arguments.out.join(format!("{NAME}.{kind}")));
    let part = table.with_extension("csv.part");
    let header = header(arguments.step);
    let mut rows = resumed(&part, &header).map_err(failed(&part))?;
    let (new, [ends, searches]) = computed(arguments, &rows, &part)?;
    rows.extend(new);
    let mut text = header;
    for row in rows.values() {
        text.push_str(row);
        text.push('\n');
    }
    write_whole(&table, &text).map_err(failed(&table))?;
    let drawn = report::chart(&text)
        .ok_or_else(|| Failure::wrong("there is nothing to draw in the table"))?;
    write_whole(&picture, &drawn).map_err(failed(&picture))?;
    fs::remove_file(&part).map_err(failed(&part))?;
    print(&format!(
        "{}: {} rows\n{}\nends of arcs that intervals of machine floats left open: {searches} of {ends}\n",
        table.display(),
        rows.len(),
        picture.display()
    ))?;
    Ok(ExitCode::SUCCESS)
}

type Rows = BTreeMap<Rays, String>;

/// The whole rows of an interrupted call with the same header, left alone in the file.
fn resumed(part: &Path, header: &str) -> io::Result<Rows> {
    let kept = match fs::read_to_string(part) {
        Ok(text) => text,
        Err(error) if error.kind() == io::ErrorKind::NotFound => String::new(),
        Err(error) => return Err(error),
    };
    let mut rows = Rows::new();
    if let Some(lines) = kept.strip_prefix(header) {
        // The last line may have been cut off.
        let whole = lines.rsplit_once('\n').map_or("", |(whole, _)| whole);
        rows.extend(
            whole
                .lines()
                .filter_map(|line| Some((rays(line)?, line.to_owned()))),
        );
    }
    let mut text = header.to_owned();
    for row in rows.values() {
        text.push_str(row);
        text.push('\n');
    }
    write_whole(part, &text)?;
    Ok(rows)
}

fn rays(line: &str) -> Option<Rays> {
    let mut columns = line.split(',');
    Some([columns.next()?.parse().ok()?, columns.next()?.parse().ok()?])
}

/// The rows that are missing, each written down as soon as it is there; how many ends their arcs have, and
/// how many of these took a search.
fn computed(
    arguments: &Arguments,
    known: &Rows,
    part: &Path,
) -> Result<(Rows, [usize; 2]), Failure> {
    let missing: Vec<Rays> = grid(arguments.step)
        .into_iter()
        .filter(|rays| !known.contains_key(rays))
        .collect();
    let beside = File::options().append(true).open(part);
    let beside = beside.map_err(|error| Failure::wrong(format!("{}: {error}", part.display())))?;
    let beside = Mutex::new(beside);
    let [ends, searches] = [AtomicUsize::new(0), AtomicUsize::new(0)];
    let progress = Progress::of(missing.len(), "linkages");
    let one = |rays: &Rays| -> io::Result<(Rays, String)> {
        let row = row(*rays);
        ends.fetch_add(row.ends, Ordering::Relaxed);
        searches.fetch_add(row.searches, Ordering::Relaxed);
        let mut file = beside
            .lock()
            .map_err(|_| io::Error::other("a thread failed"))?;
        file.write_all(format!("{}\n", row.text).as_bytes())?;
        progress.step();
        Ok((*rays, row.text))
    };
    let pool = ThreadPoolBuilder::new()
        .num_threads(arguments.threads.unwrap_or(0))
        .build()
        .map_err(|error| Failure::wrong(error.to_string()))?;
    let rows: io::Result<Rows> = pool.install(|| missing.par_iter().map(one).collect());
    let rows = rows.map_err(|error| Failure::wrong(format!("{}: {error}", part.display())))?;
    Ok((rows, [ends.into_inner(), searches.into_inner()]))
}
