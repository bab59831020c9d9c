//! The scores as a JUnit report: a suite per corpus, a test per problem.

use burmester::oracle::score::{Case, Mark, Outcome};

use super::Run;

/// The whole file.
pub fn report(run: &Run<'_>) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"burmester score\">\n",
    );
    for corpus in &run.corpora {
        let cases: Vec<&Case> = run
            .cases
            .iter()
            .filter(|case| case.corpus == *corpus)
            .collect();
        if cases.is_empty() {
            continue;
        }
        let count = |is: fn(&Case) -> bool| cases.iter().filter(|case| is(case)).count();
        let seconds: f64 = cases.iter().map(|case| case.seconds).sum();
        text += &format!(
            "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{seconds:.6}\">\n",
            escaped(corpus),
            cases.len(),
            count(|case| matches!(case.outcome, Outcome::Scored(_)) && !case.is_clean()),
            count(|case| matches!(case.outcome, Outcome::Lost(_))),
            count(|case| matches!(case.outcome, Outcome::Skipped(_))),
        );
        for case in cases {
            text += &test(case, run);
        }
        text += "  </testsuite>\n";
    }
    text + "</testsuites>\n"
}

fn test(case: &Case, run: &Run<'_>) -> String {
    let head = format!(
        "    <testcase name=\"{}\" classname=\"{}\" time=\"{:.6}\"",
        escaped(&case.id),
        escaped(&format!("{}.{}", case.corpus, case.kind)),
        case.seconds
    );
    let body = match &case.outcome {
        Outcome::Scored(verdict) if !verdict.is_clean() => {
            let message = format!(
                "{} missed, {} invented, {} facts wrong",
                verdict.count(Mark::Missed),
                verdict.count(Mark::Invented),
                verdict.count(Mark::Wrong)
            );
            let rerun = run.rerun(case);
            format!(
                "<failure message=\"{message}\">{}</failure>",
                escaped(&rerun)
            )
        }
        Outcome::Scored(_) => return format!("{head}/>\n"),
        Outcome::Skipped(reason) => format!("<skipped message=\"{}\"/>", escaped(reason)),
        Outcome::Lost(reason) => format!("<error message=\"{}\"/>", escaped(reason)),
    };
    format!("{head}>{body}</testcase>\n")
}

/// As XML text and attribute; what XML cannot hold is replaced.
fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for character in text.chars() {
        match character {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            '\n' | '\t' | '\r' => escaped.push(' '),
            '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            other => escaped.push(other),
        }
    }
    escaped
}
