//! The index of the search box.

use serde_json::json;

use super::{File, address};
use crate::ledger::Judged;

/// A script that holds the id, place, address, verdict and words of every statement.
pub fn index(sources: &[Judged<'_>]) -> File {
    let mut text = "window.burmesterIndex = [\n".to_owned();
    for decided in sources.iter().flat_map(Judged::decided) {
        let statement = decided.statement;
        let words = [Some(&statement.printed), statement.note.as_ref()];
        let words: Vec<&str> = words.into_iter().flatten().map(String::as_str).collect();
        let line = json!([
            statement.id,
            statement.locus,
            address::of_statement(&statement.id),
            decided.judgement.verdict,
            words.join(" "),
        ]);
        // A closing tag within a text must not end the script where it is put into a page.
        text.push_str(&line.to_string().replace("</", "<\\/"));
        text.push_str(",\n");
    }
    text.push_str("];\n");
    File::new("search.js", text)
}
