//! All errata as one text.

use std::fmt::Write;

use crate::ledger::{Decided, Judged, Judgement, Statement};

/// The errata of all sources in Markdown.
pub fn markdown(sources: &[Judged<'_>]) -> String {
    let mut text = "# Errata\n\n\
        Every wrong line of every source, with what is right and how that is known. Each is named by an id that \
        never changes. `burmester report` writes this file; nothing here is written by hand.\n"
        .to_owned();
    for source in sources {
        let errata = source.decided();
        let errata: Vec<_> = errata
            .filter(|one| one.judgement.verdict.is_erratum())
            .collect();
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "\n## {}\n\n{} errata.\n\n",
            source.paper.title,
            errata.len()
        );
        for Decided {
            statement,
            judgement,
        } in errata
        {
            text.push_str(&erratum(statement, judgement));
        }
    }
    text
}

fn erratum(statement: &Statement, judgement: &Judgement) -> String {
    let mut text = format!("- **`{}`** {}", statement.id, statement.locus);
    if let Some(cause) = statement.cause {
        text.push_str(", wrong: ");
        text.push_str(cause.in_words());
    }
    if let Some(id) = &statement.inherited_from {
        let _ = write!(text, ", from `{id}`");
    }
    let mut line = |name: &str, value: &str| {
        let _ = write!(text, "\n  - {name}: {value}");
    };
    line("printed", &quoted(&statement.printed));
    if let Some(right) = &judgement.corrected {
        line("right", &quoted(right));
    }
    if let Some(computed) = &judgement.computed {
        line("computed", &quoted(&computed.to_string()));
    }
    line(
        "known by",
        &format!("{} ({})", judgement.proof, judgement.basis()),
    );
    if let Some(note) = &statement.note {
        line("note", note);
    }
    text.push('\n');
    text
}

/// Text as it is, with as many quotes around it as it needs.
fn quoted(text: &str) -> String {
    let text = text.replace('\n', " ");
    if text.contains('`') {
        format!("`` {text} ``")
    } else {
        format!("`{text}`")
    }
}
