//! The report: a static site in which every statement of every source can be looked up. It needs no
//! network, and reads without scripts; these add search, filters and moving pictures.

mod address;
mod article;
mod code;
mod corpora;
mod digits;
mod front;
mod grid;
mod inline;
mod known;
mod layout;
mod mathematics;
mod numbers;
mod prose;
mod scores;
mod search;
mod source;
mod speed;

use rayon::prelude::*;

use super::gallery::{Exhibit, GalleryError, of_source};
use crate::ledger::Judged;
use crate::oracle::vectors::CORPORA;

/// A file of the site.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its place below the folder of the site, with `/` between names.
    pub path: String,
    /// All of it.
    pub text: String,
}

impl File {
    fn new(path: impl Into<String>, text: impl Into<String>) -> Self {
        File {
            path: path.into(),
            text: text.into(),
        }
    }
}

/// All files of the site; `step` is called whenever one of [`steps`] parts is done.
///
/// # Errors
/// A picture that cannot be drawn.
pub fn site(sources: &[Judged<'_>], step: impl Fn() + Sync) -> Result<Vec<File>, GalleryError> {
    let keys: Vec<&str> = sources
        .iter()
        .map(|source| source.paper.key.as_str())
        .collect();
    let exhibits: Result<Vec<Vec<Exhibit>>, GalleryError> = keys
        .par_iter()
        .map(|key| {
            let exhibits = of_source(key);
            step();
            exhibits
        })
        .collect();
    let corpora: Vec<File> = CORPORA
        .par_iter()
        .map(|corpus| {
            let page = corpora::page(corpus);
            step();
            page
        })
        .collect();
    let mut files = vec![
        front::page(sources),
        scores::page(),
        speed::page(),
        corpora::overview(),
    ];
    for (source, exhibits) in sources.iter().zip(exhibits?) {
        files.push(source::page(source, &exhibits));
        step();
    }
    files.extend(corpora);
    files.extend(code::pages(sources));
    files.push(search::index(sources));
    files.push(File::new("style.css", include_str!("assets/style.css")));
    files.push(File::new("site.js", include_str!("assets/site.js")));
    files.push(File::new("ERRATA.md", super::errata::markdown(sources)));
    Ok(files)
}

/// How many steps [`site`] takes.
pub fn steps(sources: &[Judged<'_>]) -> usize {
    2 * sources.len() + CORPORA.len()
}
