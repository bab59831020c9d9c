//! Colours, on terminals only.

use anstyle::{AnsiColor, Style};
use burmester::ledger::Verdict;

/// A style for text of this verdict.
fn of(verdict: Verdict) -> Style {
    let colour = match verdict {
        Verdict::Holds | Verdict::Reproduced => AnsiColor::Green,
        Verdict::Fails | Verdict::Contradicted => AnsiColor::Red,
        Verdict::HoldsIf | Verdict::Truncated | Verdict::Noise | Verdict::Consistent => {
            AnsiColor::Cyan
        }
        Verdict::Unclear | Verdict::NotReproducible => AnsiColor::Yellow,
    };
    colour.on_default()
}

/// Text in the colour of a verdict.
pub fn verdict(text: &str, verdict: Verdict) -> String {
    painted(text, of(verdict))
}

/// A heading.
pub fn bold(text: &str) -> String {
    painted(text, Style::new().bold())
}

/// What matters less.
pub fn dim(text: &str) -> String {
    painted(text, Style::new().dimmed())
}

fn painted(text: &str, style: Style) -> String {
    format!("{style}{text}{style:#}")
}

/// Text folded to lines of at most `width` characters, each after the first indented.
pub fn folded(text: &str, width: usize, indent: usize) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut line = String::new();
    for word in text.split_whitespace() {
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > width {
            lines.push(std::mem::take(&mut line));
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    lines.push(line);
    lines.join(&format!("\n{}", " ".repeat(indent)))
}
