//! Mutants: formulas that are wrong in one place. A scene on which a mutant holds too is too
//! special, or the mutant is equivalent.

use std::collections::{BTreeMap, BTreeSet};

use rug::{Integer, Rational};

use super::function::Function;
use super::reader::exact_value;
use super::running;
use super::tree::{Connective, Formula, Node, Operator, Relation, Span, Tree};
use crate::number::array;

/// A formula that differs from another in one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Mutant {
    /// The changed formula; its places are still those of the original text.
    pub formula: Formula,
    /// What was changed, in words.
    pub what: String,
    /// Where it was changed in the original text.
    pub span: Span,
}

/// All formulas that differ from this one in one place, in a fixed order: by place, outer parts
/// before inner ones. `names` are symbols that the scene knows besides those of the formula; they
/// serve where only an index is exchanged.
pub fn mutants(formula: &Formula, names: &[&str]) -> Vec<Mutant> {
    let mut maker = Maker::new(formula, names);
    for claim in 0..formula.claims.len() {
        maker.root(Root::Claim(claim));
    }
    for definition in 0..formula.definitions.len() {
        maker.root(Root::Definition(definition));
    }
    maker.made
}

/// A tree of the formula. Assumptions are not mutated: they say where the claims are meant.
#[derive(Clone, Copy)]
enum Root {
    Claim(usize),
    Definition(usize),
}

impl Root {
    #[expect(
        clippy::indexing_slicing,
        reason = "a root is a place in its own formula"
    )]
    fn of(self, formula: &Formula) -> &Tree {
        match self {
            Root::Claim(at) => &formula.claims[at],
            Root::Definition(at) => &formula.definitions[at].1,
        }
    }

    #[expect(
        clippy::indexing_slicing,
        reason = "a root is a place in its own formula"
    )]
    fn of_mut(self, formula: &mut Formula) -> &mut Tree {
        match self {
            Root::Claim(at) => &mut formula.claims[at],
            Root::Definition(at) => &mut formula.definitions[at].1,
        }
    }
}

/// What the formula as a whole says about which changes are changes.
struct Facts {
    /// Points occur: then a conjugate is no idle operation.
    complex: bool,
    /// More than one sign of both values: a single one may be flipped without effect.
    several_both_signs: bool,
    /// More than one `≷` or `≶`: likewise.
    several_alike: bool,
}

/// What the place of a tree allows.
#[derive(Clone, Copy)]
struct Place {
    /// A term: its sign and a factor may change.
    term: bool,
    /// Part of arithmetic, where a square has a meaning.
    arithmetic: bool,
}

struct Maker<'a> {
    formula: &'a Formula,
    names: &'a [&'a str],
    facts: Facts,
    made: Vec<Mutant>,
    seen: BTreeSet<String>,
}

impl<'a> Maker<'a> {
    fn new(formula: &'a Formula, names: &'a [&'a str]) -> Maker<'a> {
        Maker {
            formula,
            names,
            facts: Facts::of(formula),
            made: Vec::new(),
            seen: BTreeSet::from([normal_formula(formula)]),
        }
    }

    fn root(&mut self, root: Root) {
        let scope = self.scope(root);
        let place = Place {
            term: matches!(root, Root::Definition(_)),
            arithmetic: matches!(root, Root::Definition(_)),
        };
        self.visit(root, &mut Vec::new(), &scope, place);
    }

    /// The symbols that mean something in a tree: all of the formula, but of the definitions only
    /// the earlier ones in a definition, and no bound ones.
    fn scope(&self, root: Root) -> Vec<String> {
        let mut symbols = Vec::new();
        let defined = match root {
            Root::Claim(_) => self.formula.definitions.len(),
            Root::Definition(at) => at,
        };
        let later: Vec<&str> = self
            .formula
            .definitions
            .iter()
            .skip(defined)
            .map(|(name, _)| name.as_str())
            .collect();
        for tree in self.formula.claims.iter().chain(
            self.formula
                .definitions
                .iter()
                .map(|(_, definition)| definition),
        ) {
            free_symbols(tree, &mut Vec::new(), &mut symbols);
        }
        symbols.retain(|name| !later.contains(&name.as_str()));
        symbols
    }

    fn visit(&mut self, root: Root, path: &mut Vec<usize>, scope: &[String], place: Place) {
        let tree = follow(root.of(self.formula), path);
        for (node, what) in self.changes(tree, scope, place) {
            self.add(root, path, node, what);
        }
        let places = places_below(tree, place);
        for (at, _) in tree.children().into_iter().enumerate() {
            let inner_scope = scope_below(tree, at, scope);
            path.push(at);
            let place = places.get(at).copied().unwrap_or(place);
            self.visit(root, path, &inner_scope, place);
            path.pop();
        }
    }

    fn add(&mut self, root: Root, path: &[usize], node: Node, what: String) {
        let mut formula = self.formula.clone();
        let target = follow_mut(root.of_mut(&mut formula), path);
        target.node = node;
        let span = target.span.clone();
        if self.seen.insert(normal_formula(&formula)) {
            self.made.push(Mutant {
                formula,
                what,
                span,
            });
        }
    }

    /// All that may be put in the place of a tree.
    fn changes(&self, tree: &Tree, scope: &[String], place: Place) -> Vec<(Node, String)> {
        let mut changes = Vec::new();
        if place.term {
            change_term(tree, &mut changes);
        }
        match &tree.node {
            Node::Number { text, .. } => change_number(text, &mut changes),
            Node::Symbol(name) => self.change_symbol(tree, name, scope, place, &mut changes),
            Node::Negative(inner) => {
                changes.push((inner.node.clone(), format!("sign of `{inner}` flipped")))
            }
            Node::Binary(operator, left, right) => {
                self.change_binary(*operator, left, right, &mut changes);
            }
            Node::Call(function, arguments) => change_call(*function, arguments, &mut changes),
            Node::Ratio(parts) => change_ratio(parts, &mut changes),
            Node::Chain {
                first,
                rest,
                modulus,
            } => self.change_chain(first, rest, modulus.as_deref(), &mut changes),
            Node::Logic(Connective::If, left, right) => changes.push((
                Node::Logic(Connective::If, right.clone(), left.clone()),
                "condition and claim of `if` exchanged".to_string(),
            )),
            _ => {}
        }
        changes
    }

    fn change_symbol(
        &self,
        tree: &Tree,
        name: &str,
        scope: &[String],
        place: Place,
        changes: &mut Vec<(Node, String)>,
    ) {
        let relatives = self
            .names
            .iter()
            .map(|other| other.to_string())
            .chain(scope.iter().cloned())
            .chain(running::shifted(name, scope))
            .filter(|other| stem(other) == stem(name));
        for other in relatives.filter(|other| other != name) {
            let what = format!("index of `{name}` exchanged: `{other}`");
            changes.push((Node::Symbol(other), what));
        }
        for other in scope.iter().filter(|other| *other != name) {
            changes.push((
                Node::Symbol(other.clone()),
                format!("`{name}` replaced by `{other}`"),
            ));
        }
        if place.arithmetic {
            let square = Node::Binary(
                Operator::Pow,
                Box::new(tree.clone()),
                Box::new(number("2", tree)),
            );
            changes.push((square, format!("`{name}` squared")));
        }
        if self.facts.complex {
            changes.push((
                Node::Call(Function::Conj, vec![tree.clone()]),
                format!("`{name}` conjugated"),
            ));
        }
    }

    fn change_binary(
        &self,
        operator: Operator,
        left: &Tree,
        right: &Tree,
        changes: &mut Vec<(Node, String)>,
    ) {
        let with =
            |operator| Node::Binary(operator, Box::new(left.clone()), Box::new(right.clone()));
        let flipped = format!("sign of `{right}` flipped");
        match operator {
            Operator::Add => changes.push((with(Operator::Sub), flipped)),
            Operator::Sub => changes.push((with(Operator::Add), flipped)),
            Operator::PlusMinus if self.facts.several_both_signs => {
                changes.push((with(Operator::MinusPlus), flipped));
            }
            Operator::MinusPlus if self.facts.several_both_signs => {
                changes.push((with(Operator::PlusMinus), flipped));
            }
            Operator::Div => changes.push((
                Node::Binary(
                    Operator::Div,
                    Box::new(right.clone()),
                    Box::new(left.clone()),
                ),
                format!("numerator `{left}` and denominator `{right}` exchanged"),
            )),
            Operator::Pow => change_exponent(left, right, changes),
            _ => {}
        }
    }

    #[expect(
        clippy::indexing_slicing,
        reason = "the rest is a copy of the one that is run through"
    )]
    fn change_chain(
        &self,
        first: &Tree,
        rest: &[(Relation, Tree)],
        modulus: Option<&Tree>,
        changes: &mut Vec<(Node, String)>,
    ) {
        let chain = |first: &Tree, rest: Vec<(Relation, Tree)>| Node::Chain {
            first: Box::new(first.clone()),
            rest,
            modulus: modulus.map(|modulus| Box::new(modulus.clone())),
        };
        for (at, (relation, _)) in rest.iter().enumerate() {
            let Some(other) = self.exchanged(*relation) else {
                continue;
            };
            let mut rest = rest.to_vec();
            rest[at].0 = other;
            changes.push((
                chain(first, rest),
                format!("`{}` changed to `{}`", relation.sign(), other.sign()),
            ));
        }
        for (side, what) in swapped_symbols(first) {
            changes.push((chain(&side, rest.to_vec()), what));
        }
        for (at, (_, side)) in rest.iter().enumerate() {
            for (side, what) in swapped_symbols(side) {
                let mut rest = rest.to_vec();
                rest[at].1 = side;
                changes.push((chain(first, rest), what));
            }
        }
    }

    fn exchanged(&self, relation: Relation) -> Option<Relation> {
        match relation {
            Relation::Less => Some(Relation::Greater),
            Relation::Greater => Some(Relation::Less),
            Relation::LessOrEqual => Some(Relation::GreaterOrEqual),
            Relation::GreaterOrEqual => Some(Relation::LessOrEqual),
            Relation::Alike if self.facts.several_alike => Some(Relation::Opposite),
            Relation::Opposite if self.facts.several_alike => Some(Relation::Alike),
            _ => None,
        }
    }
}

impl Facts {
    fn of(formula: &Formula) -> Facts {
        let mut complex = false;
        let mut both_signs = 0;
        let mut alike = 0;
        let mut open: Vec<&Tree> = formula.claims.iter().collect();
        open.extend(formula.definitions.iter().map(|(_, value)| value));
        while let Some(tree) = open.pop() {
            match &tree.node {
                Node::ImaginaryUnit
                | Node::Call(
                    Function::Conj | Function::Re | Function::Im | Function::Arg | Function::Cis,
                    _,
                ) => complex = true,
                Node::Binary(Operator::PlusMinus | Operator::MinusPlus, ..) => both_signs += 1,
                Node::Chain { rest, .. } => {
                    alike += rest
                        .iter()
                        .filter(|(relation, _)| {
                            matches!(relation, Relation::Alike | Relation::Opposite)
                        })
                        .count();
                }
                _ => {}
            }
            open.extend(tree.children());
        }
        Facts {
            complex,
            several_both_signs: both_signs > 1,
            several_alike: alike > 1,
        }
    }
}

/// The tree at the end of a path.
fn follow<'a>(tree: &'a Tree, path: &[usize]) -> &'a Tree {
    // A path is made of places of children, so each step finds one.
    path.iter()
        .fold(tree, |tree, at| tree.children().swap_remove(*at))
}

fn follow_mut<'a>(tree: &'a mut Tree, path: &[usize]) -> &'a mut Tree {
    path.iter()
        .fold(tree, |tree, at| tree.children_mut().swap_remove(*at))
}

/// What the places of the children allow.
fn places_below(tree: &Tree, place: Place) -> Vec<Place> {
    let term = Place {
        term: true,
        arithmetic: true,
    };
    let factor = Place {
        term: false,
        arithmetic: true,
    };
    let closed = Place {
        term: false,
        arithmetic: false,
    };
    let count = tree.children().len();
    match &tree.node {
        Node::Binary(operator, left, right) => match operator {
            Operator::Add | Operator::Sub | Operator::PlusMinus | Operator::MinusPlus => {
                // A sum is no term. The second term negated is the operator flipped, and is made
                // only once.
                vec![term_unless_sum(left), term_unless_sum(right)]
            }
            Operator::Pow => vec![closed, factor],
            _ => vec![factor, factor],
        },
        Node::Negative(inner) => vec![Place {
            term: false,
            ..if place.term {
                term_unless_sum(inner)
            } else {
                factor
            }
        }],
        Node::Ratio(_) => vec![term; count],
        // The sign of all terms is that of the sum.
        Node::Sum { .. } => vec![factor, closed],
        Node::Chain { first, rest, .. } => {
            let mut places = vec![term; count];
            if let [(relation, right)] = rest.as_slice() {
                // Both sides of `x = 0` and `x ~ y` may be multiplied by anything.
                let free = *relation == Relation::Proportional
                    || (*relation == Relation::Equal && (is_zero(first) || is_zero(right)));
                if free {
                    places = vec![factor; count];
                }
            }
            places
        }
        Node::Call(function, _) if is_odd(*function) => vec![term; count],
        Node::Call(function, _) if takes_numbers(*function) => vec![factor; count],
        _ => vec![closed; count],
    }
}

fn term_unless_sum(tree: &Tree) -> Place {
    Place {
        term: !is_sum(tree),
        arithmetic: true,
    }
}

fn is_sum(tree: &Tree) -> bool {
    matches!(
        tree.node,
        Node::Binary(
            Operator::Add | Operator::Sub | Operator::PlusMinus | Operator::MinusPlus,
            ..
        )
    )
}

fn is_zero(tree: &Tree) -> bool {
    matches!(&tree.node, Node::Number { value, .. } if *value == 0)
}

/// Functions whose argument may be negated to some effect.
fn is_odd(function: Function) -> bool {
    use Function::{Arccos, Arcsin, Arctan, Cis, Cot, Im, Re, Sign, Sin, Tan};
    matches!(
        function,
        Sin | Tan | Cot | Arcsin | Arccos | Arctan | Cis | Sign | Re | Im
    )
}

/// Functions of numbers, not of points and lines.
fn takes_numbers(function: Function) -> bool {
    is_odd(function)
        || matches!(
            function,
            Function::Cos | Function::Sqrt | Function::Abs | Function::Min | Function::Max
        )
}

/// The symbols that mean something in a child: a bound name only in what it is bound in.
fn scope_below(tree: &Tree, child: usize, scope: &[String]) -> Vec<String> {
    let mut scope = scope.to_vec();
    if let Node::For { name, .. } | Node::Sum { name, .. } = &tree.node
        && child == 0
        && !scope.contains(name)
    {
        scope.push(name.clone());
    }
    scope
}

fn free_symbols(tree: &Tree, bound: &mut Vec<String>, symbols: &mut Vec<String>) {
    match &tree.node {
        Node::Symbol(name) if !bound.contains(name) && !symbols.contains(name) => {
            symbols.push(name.clone());
        }
        Node::For { body, name, values } | Node::Sum { body, name, values } => {
            free_symbols(values, bound, symbols);
            bound.push(name.clone());
            free_symbols(body, bound, symbols);
            bound.pop();
        }
        _ => {
            for child in tree.children() {
                free_symbols(child, bound, symbols);
            }
        }
    }
}

/// The name without index and primes.
fn stem(name: &str) -> &str {
    name.split(['_', '\'']).next().unwrap_or(name)
}

fn number(text: &str, place: &Tree) -> Tree {
    let node = Node::Number {
        text: text.to_string(),
        // Only digits come here, so a value there is; zero would show in every test.
        value: exact_value(text).unwrap_or_default(),
    };
    Tree::new(node, place.span.clone())
}

/// Sign and factor of a term.
fn change_term(tree: &Tree, changes: &mut Vec<(Node, String)>) {
    if is_zero(tree) || !is_quantity(tree) {
        return;
    }
    if !matches!(tree.node, Node::Negative(_)) {
        changes.push((
            Node::Negative(Box::new(tree.clone())),
            format!("sign of `{tree}` flipped"),
        ));
    }
    let doubled = Node::Binary(
        Operator::Mul,
        Box::new(number("2", tree)),
        Box::new(tree.clone()),
    );
    changes.push((doubled, format!("`{tree}` doubled")));
}

/// Lists, lines and truths have no sign.
fn is_quantity(tree: &Tree) -> bool {
    match &tree.node {
        Node::Ratio(_)
        | Node::List(_)
        | Node::Set(_)
        | Node::Chain { .. }
        | Node::Not(_)
        | Node::Logic(..)
        | Node::For { .. } => false,
        Node::Call(function, _) => !matches!(
            function,
            Function::Line
                | Function::Meet
                | Function::Collinear
                | Function::Concyclic
                | Function::Perpendicular
                | Function::Parallel
                | Function::Similar
        ),
        _ => true,
    }
}

fn change_number(text: &str, changes: &mut Vec<(Node, String)>) {
    if let Some((text_after, value)) = next_number(text) {
        let what = format!("`{text}` changed to `{text_after}`");
        changes.push((
            Node::Number {
                text: text_after,
                value,
            },
            what,
        ));
    }
}

/// The next whole number, or one unit more in the last printed digit.
fn next_number(text: &str) -> Option<(String, Rational)> {
    let (mantissa, power) = match text.find(['e', 'E']) {
        Some(at) => text.split_at(at),
        None => (text, ""),
    };
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: Integer = format!("{whole}{decimals}").parse().ok()?;
    let next = format!(
        "{:0>width$}",
        (digits + 1_i32).to_string(),
        width = whole.len() + decimals.len()
    );
    let (whole_after, decimals_after) = next.split_at(next.len() - decimals.len());
    let point = if decimals.is_empty() { "" } else { "." };
    let text = format!("{whole_after}{point}{decimals_after}{power}");
    let value = exact_value(&text)?;
    Some((text, value))
}

fn change_exponent(base: &Tree, exponent: &Tree, changes: &mut Vec<(Node, String)>) {
    let Node::Number { text, value } = &exponent.node else {
        return;
    };
    if !value.is_integer() {
        return;
    }
    let one = Integer::from(1);
    let up = Integer::from(value.numer() + &one).to_string();
    let down = Integer::from(value.numer() - &one);
    let mut put = |after: Node, name: String| {
        changes.push((
            after,
            format!("exponent {text} of `{base}` changed to {name}"),
        ));
    };
    let power = |exponent_after: &str| {
        Node::Binary(
            Operator::Pow,
            Box::new(base.clone()),
            Box::new(number(exponent_after, exponent)),
        )
    };
    put(power(&up), up.clone());
    if down == 1 {
        put(base.node.clone(), "1".to_string());
    } else if down > 1 {
        let down = down.to_string();
        put(power(&down), down.clone());
    }
}

fn change_call(function: Function, arguments: &[Tree], changes: &mut Vec<(Node, String)>) {
    for other in exchanged_functions(function) {
        changes.push((
            Node::Call(*other, arguments.to_vec()),
            format!("`{}` changed to `{}`", function.name(), other.name()),
        ));
    }
    match (function, arguments) {
        (Function::Conj, [argument]) => changes.push((
            argument.node.clone(),
            format!("conjugate of `{argument}` dropped"),
        )),
        (Function::Angle, [from, vertex, to]) => changes.push((
            Node::Call(function, vec![to.clone(), vertex.clone(), from.clone()]),
            format!("turn of the angle at `{vertex}` reversed"),
        )),
        _ => {}
    }
}

fn exchanged_functions(function: Function) -> &'static [Function] {
    match function {
        Function::Sin => &[Function::Cos],
        Function::Cos => &[Function::Sin],
        Function::Tan => &[Function::Cot],
        Function::Cot => &[Function::Tan],
        Function::Arcsin => &[Function::Arccos, Function::Arctan],
        Function::Arccos => &[Function::Arcsin, Function::Arctan],
        Function::Arctan => &[Function::Arcsin, Function::Arccos],
        Function::Min => &[Function::Max],
        Function::Max => &[Function::Min],
        Function::Re => &[Function::Im],
        Function::Im => &[Function::Re],
        Function::Perpendicular => &[Function::Parallel],
        Function::Parallel => &[Function::Perpendicular],
        _ => &[],
    }
}

fn change_ratio(parts: &[Tree], changes: &mut Vec<(Node, String)>) {
    for (first, one) in parts.iter().enumerate() {
        for (second, other) in parts.iter().enumerate().skip(first + 1) {
            let mut swapped = parts.to_vec();
            swapped.swap(first, second);
            changes.push((
                Node::Ratio(swapped),
                format!("`{one}` and `{other}` exchanged in the ratio"),
            ));
        }
    }
}

/// The side with two of its symbols exchanged throughout, for every two.
fn swapped_symbols(side: &Tree) -> Vec<(Tree, String)> {
    let mut symbols = Vec::new();
    free_symbols(side, &mut Vec::new(), &mut symbols);
    let mut swapped = Vec::new();
    for (at, first) in symbols.iter().enumerate() {
        for second in symbols.iter().skip(at + 1) {
            let mut side_after = side.clone();
            swap(&mut side_after, first, second);
            swapped.push((
                side_after,
                format!("`{first}` and `{second}` exchanged in `{side}`"),
            ));
        }
    }
    swapped
}

fn swap(tree: &mut Tree, first: &str, second: &str) {
    if let Node::Symbol(name) = &mut tree.node {
        if name == first {
            *name = second.to_string();
        } else if name == second {
            *name = first.to_string();
        }
    }
    for child in tree.children_mut() {
        swap(child, first, second);
    }
}

/// A text that is the same for formulas that differ only in the order of terms and factors, in
/// where a sign stands in a product, in the order of sides that may be exchanged.
fn normal_formula(formula: &Formula) -> String {
    let definitions: Vec<String> = formula
        .definitions
        .iter()
        .map(|(name, value)| format!("{name}={}", normal(value)))
        .collect();
    format!(
        "{}|{}|{}",
        joined(&formula.claims),
        definitions.join(";"),
        joined(&formula.assumptions)
    )
}

fn joined(trees: &[Tree]) -> String {
    let normal: Vec<String> = trees.iter().map(normal).collect();
    normal.join(";")
}

fn sorted(mut parts: Vec<String>) -> String {
    parts.sort();
    parts.join(",")
}

/// The normal text of the negative.
fn negated(text: &str) -> String {
    text.strip_prefix('-')
        .map_or_else(|| format!("-{text}"), str::to_string)
}

fn normal(tree: &Tree) -> String {
    match &tree.node {
        Node::Number { value, .. } => value.to_string(),
        Node::Pi => "pi".to_string(),
        Node::ImaginaryUnit => "i".to_string(),
        Node::Symbol(name) => format!("`{name}`"),
        Node::Binary(Operator::PlusMinus, left, right) => {
            format!("(±{},{})", normal(left), normal(right))
        }
        Node::Binary(Operator::MinusPlus, left, right) => {
            format!("(∓{},{})", normal(left), normal(right))
        }
        Node::Binary(Operator::Pow, left, right) => {
            format!("(^{},{})", normal(left), normal(right))
        }
        Node::Binary(Operator::Add | Operator::Sub, ..) => {
            let mut terms = Vec::new();
            add_terms(tree, false, &mut terms);
            format!("(+{})", sorted(terms))
        }
        Node::Negative(_) | Node::Binary(..) => {
            let mut factors = BTreeMap::new();
            let mut negative = false;
            add_factors(tree, false, &mut negative, &mut factors);
            let product = match factors.first_key_value() {
                Some((factor, 1)) if factors.len() == 1 => factor.clone(),
                _ => format!("(*{factors:?})"),
            };
            if negative { negated(&product) } else { product }
        }
        Node::Call(function, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(normal).collect();
            let arguments = if function.is_symmetric() {
                sorted(arguments)
            } else {
                arguments.join(",")
            };
            format!("{}({arguments})", function.name())
        }
        Node::Ratio(parts) => format!("(:{})", joined(parts)),
        Node::List(parts) => format!("[{}]", joined(parts)),
        Node::Set(parts) => format!("{{{}}}", sorted(parts.iter().map(normal).collect())),
        Node::Degrees(inner) => format!("(°{})", normal(inner)),
        Node::Chain {
            first,
            rest,
            modulus,
        } => normal_chain(first, rest, modulus.as_deref()),
        Node::Not(inner) => format!("(not{})", normal(inner)),
        Node::Logic(connective, left, right) => {
            let sides = vec![normal(left), normal(right)];
            let sides = match connective {
                Connective::If => sides.join(","),
                _ => sorted(sides),
            };
            format!("({}{sides})", connective.word())
        }
        Node::For { body, name, values } => {
            format!("(for{name},{},{})", normal(body), normal(values))
        }
        Node::Sum { body, name, values } => {
            format!("(sum{name},{},{})", normal(body), normal(values))
        }
    }
}

fn add_terms(tree: &Tree, negative: bool, terms: &mut Vec<String>) {
    match &tree.node {
        Node::Binary(Operator::Add, left, right) => {
            add_terms(left, negative, terms);
            add_terms(right, negative, terms);
        }
        Node::Binary(Operator::Sub, left, right) => {
            add_terms(left, negative, terms);
            add_terms(right, !negative, terms);
        }
        Node::Negative(inner) => add_terms(inner, !negative, terms),
        _ => {
            // A product brings its own sign along.
            let text = normal(tree);
            let (sign, text) = match text.strip_prefix('-') {
                Some(text) => (!negative, text.to_string()),
                None => (negative, text),
            };
            terms.push(format!("{}{text}", if sign { '-' } else { '+' }));
        }
    }
}

/// Factors with their powers, those of denominators negative.
fn add_factors(tree: &Tree, below: bool, negative: &mut bool, factors: &mut BTreeMap<String, i32>) {
    match &tree.node {
        Node::Binary(Operator::Mul | Operator::Juxtapose, left, right) => {
            add_factors(left, below, negative, factors);
            add_factors(right, below, negative, factors);
        }
        Node::Binary(Operator::Div, left, right) => {
            add_factors(left, below, negative, factors);
            add_factors(right, !below, negative, factors);
        }
        Node::Negative(inner) => {
            *negative = !*negative;
            add_factors(inner, below, negative, factors);
        }
        _ => {
            *factors.entry(normal(tree)).or_insert(0) += if below { -1 } else { 1 };
        }
    }
}

fn normal_chain(first: &Tree, rest: &[(Relation, Tree)], modulus: Option<&Tree>) -> String {
    let symmetric = array::neighbours(rest).all(|((one, _), (other, _))| one == other)
        && rest.first().is_some_and(|(relation, _)| {
            matches!(
                relation,
                Relation::Equal | Relation::Congruent | Relation::Proportional
            )
        });
    let modulus = modulus.map(normal).unwrap_or_default();
    if symmetric {
        let sides: Vec<String> = std::iter::once(first)
            .chain(rest.iter().map(|(_, side)| side))
            .map(normal)
            .collect();
        // `−x = y` and `x = −y` are the same claim: of the two texts, the smaller.
        let turned = sorted(sides.iter().map(|side| negated(side)).collect());
        let sides = sorted(sides).min(turned);
        let sign = rest.first().map_or("", |(relation, _)| relation.sign());
        return format!("({sign}{sides}mod{modulus})");
    }
    let rest: Vec<String> = rest
        .iter()
        .map(|(relation, side)| format!("{}{}", relation.sign(), normal(side)))
        .collect();
    format!("({}{}mod{modulus})", normal(first), rest.concat())
}
