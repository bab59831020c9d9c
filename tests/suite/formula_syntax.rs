//! The syntax of formulas: reading, setting, mutants.
#![allow(
    clippy::unwrap_used,
    clippy::string_slice,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use std::collections::HashSet;
use std::time::{Duration, Instant};

use burmester::formula::function::{Arity, Function};
use burmester::formula::tree::{Connective, Node, Operator, Relation};
use burmester::formula::{Formula, LENGTH_LIMIT, Tree, latex, mathml, mutants, normal_form, read};
use proptest::prelude::*;

fn readable(text: &str) -> Formula {
    match read(text) {
        Ok(formula) => formula,
        Err(error) => panic!("{}", error.render(text)),
    }
}

/// The canonical text, after a check that it reads back.
fn canonical(text: &str) -> String {
    let formula = readable(text);
    let set = formula.to_string();
    assert_eq!(readable(&set), formula, "{set}");
    set
}

const PAPERS: [&str; 16] = [
    "tan^2 alpha + (tan alpha_a + 3 tan alpha_d - N) tan alpha + (tan alpha_d - N)/tan alpha_a = 0",
    "a b/(m n + p q) = a/m = b/n = (a^2 + b^2 - c^2 + d^2)/(m^2 + n^2 - p^2 - q^2 + d^2) = lambda",
    "MS : NS = s : (s - d) = m p : -n q",
    "angle(M, P, F) = omega; angle(F, Q, N) = pi - omega",
    "angle(A,F,M) + angle(N,F,B) ≡ 0 mod pi",
    "angle(A,F,M) + angle(N,F,B) ≡ 0 (mod pi)",
    "x = 2/5 (7 - 2 sqrt 6)",
    "x = -2/5 y + 1/4 (d-c)^2 - p q/m n",
    "z' = e^(i 2 x) z̄ + e^(-i phi/2) w + e^(1/2 i x) + e^2",
    "x >< y if |a| <> |b + c| |d|",
    "72.5 deg = x for x in {1, 2°} where y = 2, z = y^2 assume y > 0, z ≠ 1",
    "x^-1 = -x^2 + a^b^c + 2.5e-7 - (-a) + sin alpha_a cos alpha_a + sin 2 alpha",
    "not a = b and c = d or e = f iff g = 1 if h = 2",
    "similar([A, B, C], [A', B', C'])",
    "sum(y^3 n_k S_k - x^2 (m_{k+1} a_{k+2})/2 for k in [1, 2, 3]) = sin a sum(2 b for k in [1, 3]) c - 2 sum(-a for k in [4])",
    "1/2/(5 x) = (x/2)/(5 y) + x/(2/5 y) + (x y) (z (3)) + (2 deg) x 3",
];

#[test]
fn formulas_of_papers_read_back() {
    for text in PAPERS {
        canonical(text);
    }
}

#[test]
fn every_example_of_the_grammar_holds() {
    let grammar = include_str!("../../src/formula/grammar.md");
    let mut examples = 0;
    for line in grammar.lines() {
        if let Some((text, expected)) = line.split_once(" ⟶ ") {
            assert_eq!(canonical(text), expected, "{text}");
            assert_eq!(canonical(expected), expected);
            examples += 1;
        }
    }
    assert!(examples > 40);
}

#[test]
fn spellings_mean_the_same() {
    for (left, right) in [
        ("p q/m n = 1", "(p q)/(m n) = 1"),
        ("2/5 x = 1", "(2/5) x = 1"),
        ("-2/5 x = 1", "-((2/5) x) = 1"),
        ("-x^2 = 1", "-(x^2) = 1"),
        (
            "sin alpha_a cos alpha_a = 1",
            "(sin(alpha_a)) (cos(alpha_a)) = 1",
        ),
        ("tan^2 alpha tan beta = 1", "(tan(alpha))^2 tan(beta) = 1"),
        ("cis(x) = 1", "e^(i x) = 1"),
        ("z̄_1 = ā", "conj(z_1) = conj(a)"),
        ("a ≡ b (mod π)", "a == b mod pi"),
        ("|a|x|b| = 1", "abs(a) x abs(b) = 1"),
    ] {
        assert_eq!(readable(left), readable(right), "{left}");
    }
}

#[test]
fn mistakes_are_named_with_their_place() {
    for (text, place, message) in [
        ("", "", "found the end of the formula, expected a quantity"),
        (
            "x = ",
            "",
            "found the end of the formula, expected a quantity",
        ),
        ("x = (a + b", "(", "nothing closes this: expected `)`"),
        ("x = a + b)", ")", "this `)` closes nothing"),
        (
            "x = (a, b)",
            ",",
            "found `,` in parentheses that are no call: a list is written `[a, b]`, a set `{a, b}`",
        ),
        (
            "x = foo(a, b)",
            "foo",
            "`foo` is no function of the language, and a product has no `,`",
        ),
        (
            "x = sin",
            "",
            "found the end of the formula, expected the argument of `sin`",
        ),
        (
            "x = sin^-1 y",
            "sin^-1",
            "ambiguous: write `arcsin(x)` for the inverse function, `1/sin(x)` for the reciprocal",
        ),
        (
            "x = dist(A)",
            "dist(A)",
            "found 1, expected 2 arguments of `dist` (points)",
        ),
        ("x = dist A", "A", "found `A`, expected `(` after `dist`"),
        (
            "x = sqrt 2 y",
            "sqrt 2 y",
            "ambiguous: where does the argument of `sqrt` end? Put parentheses around it",
        ),
        (
            "x = sin a (b + c)",
            "sin a (",
            "ambiguous: where does the argument of `sin` end? Put parentheses around it",
        ),
        (
            "x = 2 3",
            "2 3",
            "two numbers side by side: write `2 * 3` for a product",
        ),
        (
            "x = a2",
            "a2",
            "a digit right after a name: write `a_2` for an index, `a 2` for a product",
        ),
        (
            "x = αβ",
            "αβ",
            "a Greek letter side by side with another letter: put a space between for a product, or `_` for an index",
        ),
        (
            "x = y/2/5 z",
            "2/5",
            "ambiguous: `2/5 y` is the fraction times y, but stands after `/`; put parentheses",
        ),
        (
            "x = 1/2 deg",
            "1/2 deg",
            "ambiguous: write `(1/2) deg` or `1/(2 deg)`",
        ),
        (
            "x = y mod pi",
            "mod",
            "`mod` needs the relation `≡` (or `==`)",
        ),
        (
            "x = .5",
            ".",
            "found `.`: a number begins with a digit: `0.5`",
        ),
        ("x = 5.", "5.", "a digit must follow the decimal point"),
        ("x = y²", "²", "found `²`: a power is written `x^2`"),
        (
            "x = ±y",
            "±",
            "a sign of both values needs a left side: write `0 ± x`",
        ),
        (
            "x = 1 if y = 2 if z = 3",
            "if",
            "ambiguous: a second `if`; put parentheses",
        ),
        (
            "x = 1 for 2 in {3}",
            "2",
            "found the number `2`, expected a name after `for`",
        ),
        (
            "x = 1 for k in a",
            "a",
            "found `a`, expected a set `{…}` or a list `[…]` after `in`",
        ),
        (
            "x = sum",
            "",
            "found the end of the formula, expected `(` after `sum`",
        ),
        (
            "x = sum(a, b)",
            ",",
            "found `,`, expected `for` after the terms of a sum",
        ),
        (
            "x = sum(a = b for k in [1])",
            "=",
            "found `=`, expected `for` after the terms of a sum",
        ),
        (
            "x = sum(a_k for k in {1, 2})",
            "{",
            "found `{`, expected a list `[…]` after `in`",
        ),
        (
            "x = sum(a for k in [1] b)",
            "b",
            "found `b`, expected an operator or `)`",
        ),
        (
            "x = a where sum = b",
            "sum",
            "found `sum`, expected a name to define; this is a word of the language",
        ),
        (
            "x = 1 assume y = 2 where z = 3",
            "where",
            "`where` stands before `assume`",
        ),
        (
            "x = 1 where pi = 3",
            "pi",
            "found `pi`, expected a name to define; this is a word of the language",
        ),
        ("x = 1 where y = 3 = 4", "=", "a definition has one `=`"),
        (
            "x = e^i y",
            "e^i",
            "write the whole exponent in parentheses: `e^(i x)`",
        ),
        (
            "x = y $ z",
            "$",
            "found `$`, which is no sign of the language",
        ),
        ("x = x_", "x_", "an index must follow `_`: `x_1`, `x_{a,b}`"),
        (
            "x = 1e1001",
            "1e1001",
            "a power of ten beyond 1000 is not read",
        ),
    ] {
        let error = read(text).expect_err(text);
        assert_eq!(error.message, message, "{text}");
        assert_eq!(
            &text[error.span.clone()],
            place,
            "{text}: {}",
            error.render(text)
        );
    }
}

#[test]
fn a_running_index_names_all_its_symbols() {
    let formula = readable("x = sum(a_{k+1} y_j for k in [1, 2, 3]) for j in {4, 5}");
    let names: Vec<String> = formula.symbols().into_iter().collect();
    assert_eq!(names, ["a_1", "a_2", "a_3", "x", "y_4", "y_5"]);
    let telescope = readable("sum(a_k - a_{k+1} for k in [1, 2, 3])");
    assert_eq!(normal_form(&telescope).unwrap().to_string(), "0");
}

#[test]
fn every_part_knows_its_place() {
    let text = "x = (a + b) c/sin^2 d - |f| z̄ where x = tan 2 y";
    let mut open: Vec<Tree> = readable(text).claims;
    let mut places = Vec::new();
    while let Some(tree) = open.pop() {
        places.push(text[tree.span.clone()].to_string());
        open.extend(tree.children().into_iter().rev().cloned());
    }
    assert_eq!(
        places,
        [
            "x = (a + b) c/sin^2 d - |f| z̄",
            "x",
            "(a + b) c/sin^2 d - |f| z̄",
            "(a + b) c/sin^2 d",
            "(a + b) c",
            "(a + b)",
            "a",
            "b",
            "c",
            "sin^2 d",
            "sin^2 d",
            "d",
            "2",
            "|f| z̄",
            "|f|",
            "f",
            "z̄",
            "z̄",
        ]
    );
}

#[test]
fn an_error_is_shown_in_its_line() {
    let text = "x = a;\nz̄ = φ2";
    let error = read(text).expect_err(text);
    assert_eq!(
        error.render(text),
        "2 | z̄ = φ2\n        ^^\na digit right after a name: write `phi_2` for an index, `phi 2` for a product"
    );
}

#[test]
fn what_is_too_deep_or_too_long_is_an_error_at_once() {
    let start = Instant::now();
    let operators = " iff a if b or c and d = e : f + g * h i^(";
    for text in [
        "(".repeat(10_000),
        "-".repeat(10_000).replace("--", "- -"),
        "[".repeat(10_000),
        "|".repeat(10_000),
        "not ".repeat(4_000),
        "sin ".repeat(4_000),
        "sin^".repeat(4_000),
        "x^".repeat(9_000),
        "e^(-".repeat(4_000),
        "a(".repeat(9_000),
        format!("1{}", "+1".repeat(9_000)),
        format!("x{}", " x".repeat(9_000)),
        format!("x{}", "/x".repeat(9_000)),
        format!("x{}", " for x in {1}".repeat(1_000)),
        format!("a{}", operators.repeat(450)),
        format!("1{}", "+1".repeat(100_000)),
        format!("x = {}", "1".repeat(1001)),
        "x".repeat(LENGTH_LIMIT + 1),
    ] {
        let error = read(&text).expect_err("too deep or too long");
        assert!(!error.render(&text).is_empty());
    }
    assert!(start.elapsed() < Duration::from_secs(5));
}

#[test]
fn what_is_deep_and_allowed_is_walked_on_a_small_stack() {
    let walk = || {
        let sum = format!("1{} = x", "+y".repeat(398));
        let formula = readable(&sum);
        assert_eq!(formula.clone(), formula);
        canonical(&sum);
        assert!(!latex(&formula).is_empty() && !mathml(&formula).is_empty());
        canonical(&format!("{}x{} = 1", "(".repeat(790), ")".repeat(790)));
        for (open, close, count) in [
            ("sin(", ")", 398),
            ("-", "", 398),
            ("[", "]", 398),
            ("x - -(y ", ")", 132),
            ("x^(y ", ")", 198),
        ] {
            let (before, after) = (open.repeat(count), close.repeat(count));
            canonical(&format!("{before}x{after} = 1"));
        }
        canonical(&format!("{}x = 1", "not ".repeat(398)));
        canonical(&format!("x^2 = y for x in {{1{}}}", ", y".repeat(2_000)));
    };
    std::thread::Builder::new()
        .stack_size(2 << 20)
        .spawn(walk)
        .expect("a thread")
        .join()
        .expect("no overflow");
}

#[test]
fn latex_of_papers() {
    for (text, expected) in [
        (
            PAPERS[0],
            r"\tan^{2} \alpha + \left( \tan \alpha_{a} + 3 \, \tan \alpha_{d} - N \right) \, \tan \alpha + \frac{\tan \alpha_{d} - N}{\tan \alpha_{a}} = 0",
        ),
        (
            PAPERS[1],
            r"\frac{a \, b}{m \, n + p \, q} = \frac{a}{m} = \frac{b}{n} = \frac{a^{2} + b^{2} - c^{2} + d^{2}}{m^{2} + n^{2} - p^{2} - q^{2} + d^{2}} = \lambda",
        ),
        (
            PAPERS[2],
            r"\mathit{MS} : \mathit{NS} = s : \left( s - d \right) = m \, p : -n \, q",
        ),
        (
            PAPERS[3],
            r"\angle\left( M, P, F \right) = \omega; \quad \angle\left( F, Q, N \right) = \pi - \omega",
        ),
        (
            PAPERS[4],
            r"\angle\left( A, F, M \right) + \angle\left( N, F, B \right) \equiv 0 \;\text{mod}\; \pi",
        ),
        (
            "O_12' = e^(i x) z̄ sqrt(2/3) |x| {1, 2}",
            r"O_{12}' = \mathrm{e}^{\mathrm{i} \, x} \, \overline{z} \, \sqrt{\frac{2}{3}} \, \left| x \right| \, \left\{ 1, 2 \right\}",
        ),
        (
            "sin(x) y = sin(a + b)^2 (1/2)^n 2.5e-7",
            r"\sin\left( x \right) \, y = \sin^{2} \left( a + b \right) \, \left( \frac{1}{2} \right)^{n} \, 2.5 \cdot 10^{-7}",
        ),
        (
            "sum(a_k b_{k+1} for k in [1, 2, 3]) = 2 sum(k - 1 for k in [2, 4])",
            r"\sum_{k = 1}^{3} a_{k} \, b_{k+1} = 2 \, \left( \sum_{k \in \left[ 2, 4 \right]} \left( k - 1 \right) \right)",
        ),
    ] {
        assert_eq!(latex(&readable(text)), expected);
    }
}

#[test]
fn mathml_of_papers() {
    assert_eq!(
        mathml(&readable("O_12' < a/x^2 z̄")),
        "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\" \
         alttext=\"O_12&#39; &lt; a/x^2 conj(z)\"><mrow>\
         <msubsup><mi>O</mi><mn>12</mn><mo>′</mo></msubsup><mo>&lt;</mo>\
         <mfrac><mrow><mi>a</mi></mrow><mrow><msup><mrow><mi>x</mi></mrow><mrow><mn>2</mn></mrow></msup>\
         <mo>\u{2062}</mo><mover accent=\"true\"><mrow><mi>z</mi></mrow><mo stretchy=\"true\">¯</mo></mover>\
         </mrow></mfrac></mrow></math>"
    );
    for text in PAPERS {
        well_formed(&mathml(&readable(text)));
    }
}

/// Tags open and close in order, no sign of the markup stands bare, scripts have their parts.
fn well_formed(xml: &str) {
    let mut open: Vec<(String, usize)> = vec![("top".into(), 0)];
    let mut rest = xml;
    while let Some(at) = rest.find('<') {
        assert!(!rest[..at].contains('>'), "{xml}");
        let end = at + rest[at..].find('>').expect("the tag ends");
        let tag = &rest[at + 1..end];
        rest = &rest[end + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            let (opened, children) = open.pop().expect("a tag is open");
            assert_eq!(opened, name, "{xml}");
            match name {
                "msup" | "msub" | "mfrac" | "mover" | "munder" => assert_eq!(children, 2, "{xml}"),
                "msubsup" | "munderover" => assert_eq!(children, 3, "{xml}"),
                _ => {}
            }
            continue;
        }
        open.last_mut().expect("the top stays").1 += 1;
        if !tag.ends_with('/') {
            let name = tag.split(' ').next().unwrap_or(tag);
            open.push((name.to_string(), 0));
        }
    }
    assert_eq!(open, [("top".to_string(), 1)]);
}

fn whats(text: &str, names: &[&str]) -> Vec<String> {
    mutants(&readable(text), names)
        .into_iter()
        .map(|mutant| format!("{} ({})", mutant.formula, mutant.what))
        .collect()
}

#[test]
fn mutants_of_a_small_formula() {
    assert_eq!(whats("x_1 = 2 y^2 - z", &["x_2"]), MUTANTS_OF_SMALL);
}

const MUTANTS_OF_SMALL: [&str; 20] = [
    "x_1 = 2 z^2 - y (`y` and `z` exchanged in `2 y^2 - z`)",
    "-x_1 = 2 y^2 - z (sign of `x_1` flipped)",
    "2 * x_1 = 2 y^2 - z (`x_1` doubled)",
    "x_2 = 2 y^2 - z (index of `x_1` exchanged: `x_2`)",
    "y = 2 y^2 - z (`x_1` replaced by `y`)",
    "z = 2 y^2 - z (`x_1` replaced by `z`)",
    "x_1^2 = 2 y^2 - z (`x_1` squared)",
    "x_1 = 2 * (2 y^2 - z) (`2 y^2 - z` doubled)",
    "x_1 = 2 y^2 + z (sign of `z` flipped)",
    "x_1 = -2 y^2 - z (sign of `2 y^2` flipped)",
    "x_1 = 2 * 2 y^2 - z (`2 y^2` doubled)",
    "x_1 = 3 y^2 - z (`2` changed to `3`)",
    "x_1 = 2 y^3 - z (exponent 2 of `y` changed to 3)",
    "x_1 = 2 y - z (exponent 2 of `y` changed to 1)",
    "x_1 = 2 x_1^2 - z (`y` replaced by `x_1`)",
    "x_1 = 2 z^2 - z (`y` replaced by `z`)",
    "x_1 = 2 y^2 - 2 * z (`z` doubled)",
    "x_1 = 2 y^2 - x_1 (`z` replaced by `x_1`)",
    "x_1 = 2 y^2 - y (`z` replaced by `y`)",
    "x_1 = 2 y^2 - z^2 (`z` squared)",
];

#[test]
fn each_kind_of_mutant_is_made() {
    for (text, expected) in [
        ("x = sin(a)", "x = cos(a)"),
        ("x = sin(a)", "x = sin(-a)"),
        ("x = arctan(a)", "x = arcsin(a)"),
        ("x = min(a, b)", "x = max(a, b)"),
        ("x = re(z)", "x = im(z)"),
        ("x = conj(z)", "x = z"),
        ("x = conj(z) w", "x = conj(z) conj(w)"),
        ("x = a/b", "x = b/a"),
        ("x < y", "x > y"),
        ("x ≤ y", "x ≥ y"),
        ("x ≷ y if a ≷ b", "x ≷ y if a ≶ b"),
        ("x = y if a = b", "a = b if x = y"),
        ("a : b = c : d", "b : a = c : d"),
        ("x = a ± b; y = a ± c", "x = a ± b; y = a ∓ c"),
        ("x = y where y = a^2", "x = y where y = a^3"),
        ("x = y where y = a + b", "x = y where y = a - b"),
        ("angle(A, B, C) ≡ 0 mod pi", "angle(C, B, A) ≡ 0 mod pi"),
        ("x_k = a for k in {1, 2}", "a = a for k in {1, 2}"),
        ("x_k = a for k in [1, 2]", "x_{k+1} = a for k in [1, 2]"),
        ("x_k = y_{k-1} for k in [1, 2]", "x_k = y_k for k in [1, 2]"),
        (
            "x = sum(a_k b_{k+1} for k in [1, 2, 3])",
            "x = sum(a_k b_{k+2} for k in [1, 2, 3])",
        ),
        (
            "x = sum(a_k b_{k+1} for k in [1, 2, 3])",
            "-x = sum(a_k b_{k+1} for k in [1, 2, 3])",
        ),
        (
            "x = sum(a_k - b for k in [1, 2])",
            "x = sum(a_k + b for k in [1, 2])",
        ),
        (
            "x = sum(a_k for k in [1, 2])",
            "x = sum(a_k for k in [1, 3])",
        ),
        ("x = 0.099", "x = 0.100"),
        ("x = 9.9e-3", "x = 10.0e-3"),
    ] {
        let made: Vec<String> = mutants(&readable(text), &[])
            .iter()
            .map(|mutant| mutant.formula.to_string())
            .collect();
        assert!(
            made.contains(&expected.to_string()),
            "{expected} not in {made:#?}"
        );
    }
}

#[test]
fn mutants_that_say_the_same_are_not_made() {
    for (text, unwanted) in [
        ("x = a b", "x = b a"),
        ("x = a + b", "x = b + a"),
        ("a + b = 0", "-(a + b) = 0"),
        ("a b = 0", "2 * a b = 0"),
        ("x = a ± b", "x = a ∓ b"),
        ("x ≷ y", "x ≶ y"),
        ("x = y where x = a, y = b", "x = y where x = y, y = b"),
        ("x = sum(a for k in [1, 2])", "x = sum(-a for k in [1, 2])"),
        ("x = y", "y = x"),
        ("collinear(A, B, C)", "collinear(B, A, C)"),
    ] {
        let formula = readable(text);
        for mutant in mutants(&formula, &[]) {
            assert_ne!(mutant.formula.to_string(), unwanted, "{}", mutant.what);
        }
    }
}

#[test]
fn mutants_differ_read_back_and_come_in_the_same_order() {
    for text in PAPERS {
        let formula = readable(text);
        let made = mutants(&formula, &["alpha_b", "m_1"]);
        assert!(!made.is_empty(), "{text}");
        let mut seen = HashSet::from([formula.to_string()]);
        for mutant in &made {
            let set = mutant.formula.to_string();
            assert_eq!(readable(&set), mutant.formula, "{set}");
            assert!(text.get(mutant.span.clone()).is_some());
            assert!(seen.insert(set), "{} of {text}", mutant.what);
        }
        assert_eq!(made, mutants(&formula, &["alpha_b", "m_1"]));
    }
}

/// A tree without a place.
fn tree(node: Node) -> Tree {
    Tree::new(node, 0..0)
}

fn boxed(tree: Tree) -> Box<Tree> {
    Box::new(tree)
}

fn leaves() -> impl Strategy<Value = Tree> {
    let symbol = prop::sample::select(vec![
        "a",
        "b",
        "e",
        "mp",
        "alpha_a",
        "O_12'",
        "x_{a,b}''",
        "x_{k+1}",
    ]);
    let number = prop::sample::select(vec!["0", "2", "5", "17", "0.125", "2.5e-7"]);
    prop_oneof![
        symbol.prop_map(|name| tree(Node::Symbol(name.to_string()))),
        number.prop_map(|text| readable(text).claims.remove(0)),
        Just(tree(Node::Pi)),
        Just(tree(Node::ImaginaryUnit)),
    ]
}

fn call(function: Function, mut arguments: Vec<Tree>) -> Tree {
    let count = match function.arity() {
        Arity::Exactly(count) | Arity::AtLeast(count) => count,
    };
    while arguments.len() < count {
        arguments.push(tree(Node::Pi));
    }
    arguments.truncate(count);
    tree(Node::Call(function, arguments))
}

fn trees() -> impl Strategy<Value = Tree> {
    let operators = prop::sample::select(vec![
        Operator::Add,
        Operator::Sub,
        Operator::Mul,
        Operator::Juxtapose,
        Operator::Juxtapose,
        Operator::Div,
        Operator::Div,
        Operator::Pow,
        Operator::PlusMinus,
        Operator::MinusPlus,
    ]);
    let relations = prop::sample::select(vec![
        Relation::Equal,
        Relation::NotEqual,
        Relation::LessOrEqual,
        Relation::Alike,
        Relation::Opposite,
        Relation::Proportional,
        Relation::Congruent,
    ]);
    let connectives = prop::sample::select(vec![
        Connective::And,
        Connective::Or,
        Connective::If,
        Connective::Iff,
    ]);
    leaves().prop_recursive(6, 40, 4, move |inner| {
        let list = prop::collection::vec(inner.clone(), 0..4);
        let several = prop::collection::vec(inner.clone(), 2..4);
        let functions = prop::sample::select(Function::ALL.to_vec());
        prop_oneof![
            6 => (operators.clone(), inner.clone(), inner.clone())
                .prop_map(|(operator, left, right)| tree(Node::Binary(operator, boxed(left), boxed(right)))),
            1 => inner.clone().prop_map(|inner| tree(Node::Negative(boxed(inner)))),
            1 => inner.clone().prop_map(|inner| tree(Node::Degrees(boxed(inner)))),
            2 => (functions, list.clone()).prop_map(|(function, arguments)| call(function, arguments)),
            1 => several.prop_map(|parts| tree(Node::Ratio(parts))),
            1 => list.clone().prop_map(|parts| tree(Node::List(parts))),
            1 => list.clone().prop_map(|parts| tree(Node::Set(parts))),
            1 => (inner.clone(), prop::collection::vec((relations.clone(), inner.clone()), 1..3), prop::option::of(inner.clone()))
                .prop_map(|(first, rest, modulus)| {
                    let congruent = rest.iter().any(|(relation, _)| *relation == Relation::Congruent);
                    tree(Node::Chain { first: boxed(first), rest, modulus: modulus.filter(|_| congruent).map(boxed) })
                }),
            1 => inner.clone().prop_map(|inner| tree(Node::Not(boxed(inner)))),
            1 => (connectives.clone(), inner.clone(), inner.clone())
                .prop_map(|(connective, left, right)| tree(Node::Logic(connective, boxed(left), boxed(right)))),
            1 => (inner.clone(), list.clone()).prop_map(|(body, values)| tree(Node::For {
                body: boxed(body),
                name: "k".to_string(),
                values: boxed(tree(Node::List(values))),
            })),
            1 => (inner, list).prop_map(|(body, values)| tree(Node::Sum {
                body: boxed(body),
                name: "k".to_string(),
                values: boxed(tree(Node::List(values))),
            })),
        ]
    })
}

fn formulas() -> impl Strategy<Value = Formula> {
    (
        prop::collection::vec(trees(), 1..3),
        prop::collection::vec(trees(), 0..2),
        prop::collection::vec(trees(), 0..2),
    )
        .prop_map(|(claims, values, assumptions)| Formula {
            claims,
            definitions: values
                .into_iter()
                .map(|value| ("q".to_string(), value))
                .collect(),
            assumptions,
        })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_printed_reads_back(formula in formulas()) {
        let text = formula.to_string();
        match read(&text) {
            Ok(again) => prop_assert_eq!(&again, &formula, "{}", text),
            Err(error) => prop_assert!(false, "{}", error.render(&text)),
        }
        well_formed(&mathml(&formula));
    }

    #[test]
    fn any_text_is_answered(text in "\\PC{0,60}") {
        if let Err(error) = read(&text) {
            error.render(&text);
            prop_assert!(text.get(error.span).is_some());
        }
    }

    #[test]
    fn any_bytes_are_answered(bytes in prop::collection::vec(any::<u8>(), 0..60)) {
        let text = String::from_utf8_lossy(&bytes);
        if let Err(error) = read(&text) {
            error.render(&text);
        }
    }

    #[test]
    fn any_words_are_answered(words in prop::collection::vec(prop::sample::select(WORDS.to_vec()), 0..24)) {
        let text = words.concat();
        match read(&text) {
            Ok(formula) => {
                let set = formula.to_string();
                match read(&set) {
                    Ok(again) => prop_assert_eq!(&again, &formula, "{} ⟶ {}", text, set),
                    Err(error) => prop_assert!(false, "{}\n{}", text, error.render(&set)),
                }
                for mutant in mutants(&formula, &["x_1"]) {
                    prop_assert!(mutant.formula != formula);
                    prop_assert!(read(&mutant.formula.to_string()) == Ok(mutant.formula.clone()), "{}", mutant.formula);
                }
            }
            Err(error) => {
                error.render(&text);
                prop_assert!(text.get(error.span).is_some());
            }
        }
    }
}

const WORDS: [&str; 61] = [
    "x",
    "x",
    "a",
    "e",
    "i",
    "2",
    "5",
    "3.5",
    "1e3",
    " ",
    " ",
    " ",
    " ",
    " ",
    "+",
    "-",
    "*",
    "/",
    "/",
    "^",
    "(",
    ")",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "|",
    "|",
    ",",
    ";",
    ":",
    "=",
    " ≡ ",
    " mod ",
    " < ",
    "~",
    " sin ",
    " sqrt ",
    " tan^2 ",
    " angle(",
    " deg ",
    "°",
    " if ",
    " iff ",
    " and ",
    " or ",
    " not ",
    " for k in ",
    " sum(",
    " where ",
    " assume ",
    "z̄",
    "α",
    "_1",
    "'",
    "±",
    " pi ",
    "2/5 ",
    "e^(i ",
];

#[test]
fn what_the_grammar_refuses_is_refused() {
    for text in [
        "a2",
        "αβ",
        "2 3",
        "sin^-1 x",
        "sqrt 2 x",
        "sin a (b + c)",
        "x/2/5 y",
        "1/2 deg",
        "e^i x",
        "P if Q if R",
    ] {
        assert!(read(text).is_err(), "{text}");
    }
}
