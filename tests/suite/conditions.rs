//! Lines that hold under a condition, and lines that cannot be read.

use burmester::ledger::{self, Judge, Judgement, Options, Verdict, read_paper};

const OPTIONS: Options = Options {
    digits: 10,
    mutants: false,
};

fn paper(fields: &str) -> Result<ledger::Paper, ledger::PaperError> {
    let text = format!(
        "[source]\nkey = \"k\"\ntitle = \"t\"\nstatements = 1\n[[statement]]\nid = \"k/1\"\n\
         locus = \"l\"\nkind = \"equation\"\n{fields}"
    );
    read_paper("k.toml", &text)
}

fn judged(fields: &str) -> Option<Judgement> {
    let paper = paper(fields).ok()?;
    Judge::new(OPTIONS).judge(paper.statements.first()?).ok()
}

const ORDER: &str = "scene = \"wunderlich1968/focal-cubic\"\nprinted = \"order = 3\"\n\
                     expected = \"holds-if\"\n";

#[test]
fn a_condition_needs_both_halves() {
    let outside = "outside = \"wunderlich1968/focal-cubic-of-a-parallelogram\"\n";
    let right = judged(&format!("{ORDER}condition = \"z_B - z_A ≠ d\"\n{outside}")).unwrap();
    assert_eq!(right.verdict, Verdict::HoldsIf);
    assert!(right.counterexample.iter().any(|(name, _)| name == "order"));
    // Without a configuration in which the line fails it simply holds.
    let idle = judged(&format!("{ORDER}condition = \"z_B - z_A ≠ d\"\n")).unwrap();
    assert_eq!(idle.verdict, Verdict::Holds);
    // A condition that has nothing to do with the failure is met there.
    let other = judged(&format!("{ORDER}condition = \"d > 0\"\n{outside}")).unwrap();
    assert_eq!(other.verdict, Verdict::Holds);
    // A condition under which the line fails.
    let wrong = ORDER.replace("order = 3", "order = 2");
    let wrong = judged(&format!("{wrong}condition = \"z_B - z_A ≠ d\"\n{outside}")).unwrap();
    assert_eq!(wrong.verdict, Verdict::Fails);
}

#[test]
fn a_garbled_line_rests_on_its_right_form() {
    let garbled = "scene = \"wunderlich1968/hart\"\nverbatim = \"mp+&*\"\ncause = \"copy\"\n\
                   expected = \"fails\"\n";
    let right = judged(&format!("{garbled}correct = \"m p + n q = 0\"\n")).unwrap();
    assert_eq!(right.verdict, Verdict::Fails);
    assert_eq!(right.corrected.as_deref(), Some("m p + n q = 0"));
    let wrong = paper(&format!("{garbled}correct = \"p n + q m = 0\"\n")).unwrap();
    assert!(Judge::new(OPTIONS).judge(&wrong.statements[0]).is_err());
    assert!(paper(garbled).is_err());
    assert!(
        paper(&format!(
            "{garbled}printed = \"m = n\"\ncorrect = \"m = m\"\n"
        ))
        .is_err()
    );
    assert!(paper(&format!("{ORDER}outside = \"wunderlich1968/hart\"\n")).is_err());
}
