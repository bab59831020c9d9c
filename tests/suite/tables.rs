//! Printed tables whose cells are no numbers.
#![expect(clippy::unwrap_used, reason = "a test stops where something is wrong")]

use burmester::ledger::{Judge, Judgement, Options, Paper, PaperError, Verdict, read_paper};

const OPTIONS: Options = Options {
    digits: 10,
    mutants: false,
};

/// A paper with one table of two cells, both right, and further fields.
fn paper(fields: &str) -> Result<Paper, PaperError> {
    let text = format!(
        "[source]\nkey = \"k\"\ntitle = \"t\"\nstatements = 9\n[[table]]\nid = \"k/1\"\n\
         locus = \"l\"\nscene = \"filemon1973/any-shape\"\n{fields}"
    );
    read_paper("k.toml", &text)
}

const COLUMNS: &str = "code = \"cases-of-tangents\"\ncolumns = [\"U=Z/A\", \"U=Z/B\"]\n";
const RIGHT: &str = "rows = [{ row = \"f1>f2=\", label = \"r\", printed = [\"+\", \"-\"] }]\n";
const WRONG: &str = "rows = [{ row = \"f1>f2=\", printed = [\"+\", \"+\"] }]\n";

fn judged(paper: &Paper) -> Vec<Judgement> {
    let mut judge = Judge::new(OPTIONS);
    let statements = paper.statements.iter();
    statements.map(|one| judge.judge(one).unwrap()).collect()
}

#[test]
fn every_cell_is_a_statement() {
    let paper = paper(&format!("{COLUMNS}{RIGHT}")).unwrap();
    let ids: Vec<&str> = paper.statements.iter().map(|one| one.id.as_str()).collect();
    assert_eq!(ids, ["k/1/f1>f2=/U=Z/A", "k/1/f1>f2=/U=Z/B"]);
    assert_eq!(paper.statements[0].locus, "l, row r, column U=Z, A");
    for judgement in judged(&paper) {
        assert_eq!(judgement.verdict, Verdict::Holds);
        assert_eq!(judgement.corrected, None);
        assert!(judgement.instances > Some(0));
    }
}

#[test]
fn a_wrong_cell_is_found_and_corrected() {
    let named = "[[table.wrong]]\ncells = [\"f1>f2=/U=Z/B\"]\ncause = \"print\"\nnote = \"n\"\n";
    let paper = paper(&format!("{COLUMNS}{WRONG}{named}")).unwrap();
    let found: Vec<Verdict> = judged(&paper).iter().map(|one| one.verdict).collect();
    assert_eq!(found, [Verdict::Holds, Verdict::Fails]);
    for (statement, verdict) in paper.statements.iter().zip(found) {
        assert_eq!(statement.expected, verdict);
    }
    let wrong = &judged(&paper)[1];
    assert_eq!(wrong.corrected.as_deref(), Some("-"));
    assert_eq!(wrong.computed.as_ref().unwrap().to_string(), "-");
    assert_eq!(paper.statements[1].note.as_deref(), Some("n"));
    assert_eq!(paper.statements[0].note, None);
}

#[test]
fn a_whole_table_is_one_statement() {
    let whole = |rows: &str| paper(&format!("whole = true\n{COLUMNS}{rows}")).unwrap();
    let right = whole(RIGHT);
    assert_eq!(right.statements.len(), 1);
    assert_eq!(right.statements[0].printed, "f1>f2=: + -");
    assert_eq!(judged(&right)[0].verdict, Verdict::Holds);
    let wrong = &judged(&whole(WRONG))[0];
    assert_eq!(wrong.verdict, Verdict::Fails);
    assert_eq!(wrong.corrected.as_deref(), Some("f1>f2=: + -"));
}

#[test]
fn the_part_that_fits_is_named() {
    let rows = "code = \"tangents-by-order-of-sides\"\npart = \"c shortest, h longest\"\n\
                columns = [\"U>Z/O1\", \"U>Z/O2\"]\n\
                rows = [{ row = \"f1>\", printed = [\"2rt\", \"(blank)\"] }, \
                { row = \"f2<\", printed = [\"2is\", \"(blank)\"] }]\n";
    let judgements = judged(&paper(rows).unwrap());
    assert_eq!(judgements.len(), 4);
    let fit = "4 of the 4 printed cells are those of `c shortest, h longest`, of every other part at \
               most 4";
    assert!(judgements[0].evidence.iter().any(|one| one == fit));
}

#[test]
fn mistakes_are_named() {
    let refused = |fields: &str, expected: &str| {
        let message = paper(fields).unwrap_err().to_string();
        assert!(message.contains(expected), "{message}");
    };
    let code = COLUMNS.replace("cases", "no-cases");
    refused(
        &format!("{code}{RIGHT}"),
        "unknown table `no-cases-of-tangents`",
    );
    let short = RIGHT.replace(", \"-\"", "");
    refused(&format!("{COLUMNS}{short}"), "has 1 cells, but there are 2");
    let unknown = "[[table.wrong]]\ncells = [\"f1>f2=/U\"]\ncause = \"print\"\n";
    refused(&format!("{COLUMNS}{RIGHT}{unknown}"), "no cell `f1>f2=/U`");
    // A row that the code does not know is found when it is judged.
    let row = RIGHT.replace("f1>f2=", "f3>");
    let paper = paper(&format!("{COLUMNS}{row}")).unwrap();
    let error = Judge::new(OPTIONS).judge(&paper.statements[0]).unwrap_err();
    assert!(error.to_string().contains("f3>"), "{error}");
}
