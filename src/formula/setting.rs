//! How formulas are set: one walk that knows where parentheses stand, for every style of setting.

use super::cis;
use super::function::Function;
use super::level::Level;
use super::running;
use super::tree::{Formula, Node, Operator, Relation, Tree};

/// What one style of setting makes of the constructs, the parts being set already.
pub(super) trait Style {
    /// Whether fractions and powers show by their shape how far they reach: then their parts need
    /// no parentheses.
    const SHAPED: bool;

    /// Digits.
    fn number(&self, text: &str) -> String;
    /// π
    fn pi(&self) -> String;
    /// i
    fn imaginary_unit(&self) -> String;
    /// The base of natural powers.
    fn euler(&self) -> String;
    /// A name in canonical spelling.
    fn symbol(&self, name: &str) -> String;
    /// `−x`
    fn negative(&self, inner: &str) -> String;
    /// Any operator but the power.
    fn binary(&self, operator: Operator, left: &str, right: &str) -> String;
    /// `x^y`
    fn power(&self, base: &str, exponent: &str) -> String;
    /// `x°`
    fn degrees(&self, inner: &str) -> String;
    /// `f(x, y)`
    fn call(&self, function: Function, arguments: &[String]) -> String;
    /// `sin x`, in shaped styles; with the exponent of the function, if any.
    fn bare_call(&self, function: Function, exponent: Option<&str>, argument: &str) -> String;
    /// Parts between brackets.
    fn fenced(&self, open: &str, parts: &[String], close: &str) -> String;
    /// `sum(x for k in […])`; where k runs through consecutive whole numbers, the first and the last
    /// of them.
    fn sum(&self, body: &str, name: &str, values: &str, bounds: Option<(&str, &str)>) -> String;
    /// `a : b`
    fn ratio(&self, parts: &[String]) -> String;
    /// The sign of a relation, with its space.
    fn relation(&self, relation: Relation) -> String;
    /// A word of the language, with space on both sides.
    fn word(&self, word: &str) -> String;
    /// What stands between two things on one level, such as `,` or `;`.
    fn separator(&self, sign: &str) -> String;
    /// The sign of a definition or of membership.
    fn sign(&self, sign: &str) -> String;
    /// A part that is set, with a mark where the style marks it.
    fn marked(&self, _part: &Tree, set: String) -> String {
        set
    }
}

/// A whole formula.
pub(super) fn formula<S: Style>(style: &S, formula: &Formula) -> String {
    let claims: Vec<String> = formula
        .claims
        .iter()
        .map(|claim| tree(style, claim, Level::For))
        .collect();
    let mut set = claims.join(&style.separator(";"));
    if !formula.definitions.is_empty() {
        let definitions: Vec<String> = formula
            .definitions
            .iter()
            .map(|(name, value)| definition(style, name, value))
            .collect();
        set += &style.word("where");
        set += &definitions.join(&style.separator(","));
    }
    if !formula.assumptions.is_empty() {
        let assumptions: Vec<String> = formula
            .assumptions
            .iter()
            .map(|assumption| tree(style, assumption, Level::For))
            .collect();
        set += &style.word("assume");
        set += &assumptions.join(&style.separator(","));
    }
    set
}

/// What a formula itself calls by a name.
pub(super) fn definition<S: Style>(style: &S, name: &str, value: &Tree) -> String {
    let value = tree(style, value, Level::Ratio);
    format!("{}{}{value}", style.symbol(name), style.sign("="))
}

/// A tree where a construct of this level or a tighter one may stand without parentheses.
pub(super) fn tree<S: Style>(style: &S, tree: &Tree, context: Level) -> String {
    let set = style.marked(tree, bare(style, tree));
    if level::<S>(tree) < context {
        return style.fenced("(", &[set], ")");
    }
    set
}

/// How tightly a construct holds together as it is set.
fn level<S: Style>(tree: &Tree) -> Level {
    match &tree.node {
        Node::Number { .. } | Node::Pi | Node::ImaginaryUnit | Node::Symbol(_) => Level::Atom,
        Node::List(_) | Node::Set(_) => Level::Atom,
        Node::Call(Function::Cis, _) => Level::Power,
        Node::Call(..) if S::SHAPED && trigonometric(tree).is_some() => Level::Power,
        Node::Call(..) => Level::Atom,
        Node::Negative(_) => Level::Negative,
        // What follows the sign of a sum could be taken for a part of it.
        Node::Sum { .. } if S::SHAPED => Level::Negative,
        Node::Sum { .. } => Level::Atom,
        Node::Degrees(_) => Level::Juxtaposition,
        // A fraction with its bar is a factor like others.
        Node::Binary(Operator::Div, ..) if S::SHAPED => Level::Power,
        Node::Binary(operator, ..) => operator.level(),
        Node::Ratio(_) => Level::Ratio,
        Node::Chain { .. } => Level::Relation,
        Node::Not(_) => Level::Not,
        Node::Logic(connective, ..) => connective.level(),
        Node::For { .. } => Level::For,
    }
}

/// A tree without parentheses around it.
fn bare<S: Style>(style: &S, whole: &Tree) -> String {
    match &whole.node {
        Node::Number { text, .. } => style.number(text),
        Node::Pi => style.pi(),
        Node::ImaginaryUnit => style.imaginary_unit(),
        Node::Symbol(name) => style.symbol(name),
        Node::Negative(inner) => style.negative(&tree(style, inner, Level::Product)),
        Node::Binary(Operator::Juxtapose, ..) => product(style, whole),
        Node::Binary(Operator::Pow, base, exponent) => power(style, base, exponent, true),
        Node::Binary(Operator::Div, left, right) => quotient(style, left, right),
        Node::Binary(operator, left, right) => binary(style, *operator, left, right),
        Node::Degrees(inner) => degrees(style, inner),
        Node::Call(function, arguments) => call(style, *function, arguments, true),
        Node::Ratio(parts) => style.ratio(&each(style, parts, Level::Negative)),
        Node::List(parts) => style.fenced("[", &each(style, parts, Level::For), "]"),
        Node::Set(parts) => style.fenced("{", &each(style, parts, Level::For), "}"),
        Node::Chain {
            first,
            rest,
            modulus,
        } => chain(style, first, rest, modulus.as_deref()),
        Node::Not(inner) => {
            style.word("not").trim_start().to_string() + &tree(style, inner, Level::Not)
        }
        Node::Logic(connective, left, right) => {
            let (left_level, right_level) = connective.sides();
            tree(style, left, left_level)
                + &style.word(connective.word())
                + &tree(style, right, right_level)
        }
        Node::For { body, name, values } => [
            tree(style, body, Level::For),
            style.word("for"),
            style.symbol(name),
            style.sign("in"),
            tree(style, values, Level::Atom),
        ]
        .concat(),
        Node::Sum { body, name, values } => sum(style, body, name, values),
    }
}

fn sum<S: Style>(style: &S, body: &Tree, name: &str, values: &Tree) -> String {
    let context = if S::SHAPED {
        Level::Product
    } else {
        Level::Sum
    };
    style.sum(
        &tree(style, body, context),
        &style.symbol(name),
        &tree(style, values, Level::Atom),
        running::bounds(values),
    )
}

fn each<S: Style>(style: &S, parts: &[Tree], context: Level) -> Vec<String> {
    parts
        .iter()
        .map(|part| tree(style, part, context))
        .collect()
}

/// `deg` stands after a number or a parenthesis, nothing else.
fn degrees<S: Style>(style: &S, inner: &Tree) -> String {
    let set = bare(style, inner);
    match inner.node {
        Node::Number { .. } => style.degrees(&set),
        _ => style.degrees(&style.fenced("(", &[set], ")")),
    }
}

fn chain<S: Style>(
    style: &S,
    first: &Tree,
    rest: &[(Relation, Tree)],
    modulus: Option<&Tree>,
) -> String {
    let mut set = tree(style, first, Level::Ratio);
    for (relation, side) in rest {
        set += &style.relation(*relation);
        set += &tree(style, side, Level::Ratio);
    }
    if let Some(modulus) = modulus {
        set += &style.word("mod");
        set += &tree(style, modulus, Level::Sum);
    }
    set
}

fn binary<S: Style>(style: &S, operator: Operator, left: &Tree, right: &Tree) -> String {
    let (left_level, right_level) = match operator {
        Operator::Mul => (Level::Product, Level::Juxtaposition),
        _ => (Level::Sum, Level::Product),
    };
    style.binary(
        operator,
        &tree(style, left, left_level),
        &tree(style, right, right_level),
    )
}

fn quotient<S: Style>(style: &S, left: &Tree, right: &Tree) -> String {
    if S::SHAPED {
        let (left, right) = (
            tree(style, left, Level::For),
            tree(style, right, Level::For),
        );
        return style.binary(Operator::Div, &left, &right);
    }
    let right_level = if denominator_misreads(left, right) {
        Level::Atom
    } else {
        Level::Juxtaposition
    };
    style.binary(
        Operator::Div,
        &tree(style, left, Level::Product),
        &tree(style, right, right_level),
    )
}

/// Whether `2/5 x` would come of it, which is the fraction times x, or `a/2/5 x`, which is nothing.
fn denominator_misreads(numerator: &Tree, denominator: &Tree) -> bool {
    let several = matches!(
        denominator.node,
        Node::Binary(Operator::Juxtapose, ..) | Node::Degrees(_)
    );
    several
        && (begins_with_fraction(denominator)
            || (ends_with_number(numerator) && begins_with_number(denominator)))
}

fn begins_with_fraction(tree: &Tree) -> bool {
    match &tree.node {
        Node::Binary(Operator::Juxtapose, left, _) => {
            is_fraction(left) || begins_with_fraction(left)
        }
        _ => false,
    }
}

/// The quotient of two whole numbers.
fn is_fraction(tree: &Tree) -> bool {
    match &tree.node {
        Node::Binary(Operator::Div, left, right) => is_whole(left) && is_whole(right),
        _ => false,
    }
}

fn is_whole(tree: &Tree) -> bool {
    match &tree.node {
        Node::Number { text, .. } => text.bytes().all(|byte| byte.is_ascii_digit()),
        _ => false,
    }
}

/// Whether the first word of its text is a number.
fn begins_with_number(tree: &Tree) -> bool {
    match &tree.node {
        Node::Number { .. } => true,
        Node::Binary(Operator::Div, ..) => is_fraction(tree),
        Node::Binary(Operator::Juxtapose, left, _) => begins_with_number(left),
        Node::Binary(Operator::Pow, inner, _) | Node::Degrees(inner) => {
            matches!(inner.node, Node::Number { .. })
        }
        _ => false,
    }
}

/// Whether the last word of its text is a number.
fn ends_with_number(tree: &Tree) -> bool {
    match &tree.node {
        Node::Number { .. } => true,
        Node::Negative(inner) => ends_with_number(inner),
        Node::Binary(_, _, right) => ends_with_number(right),
        _ => false,
    }
}

/// Whether two factors side by side would be two numbers side by side.
fn numbers_touch<S: Style>(before: &Tree, after: &Tree) -> bool {
    let open_end = level::<S>(before) >= Level::Power || is_fraction(before);
    open_end && ends_with_number(before) && begins_with_number(after)
}

/// Factors side by side. Two numbers may not touch, and a function without parentheses around its
/// argument must not swallow the next factor.
fn product<S: Style>(style: &S, whole: &Tree) -> String {
    let factors = factors(whole);
    let mut set = String::new();
    for (at, factor) in factors.iter().enumerate() {
        let next = factors.get(at + 1);
        let before = at.checked_sub(1).and_then(|at| factors.get(at));
        let open_end = next.is_none_or(|next| is_call(next));
        let piece = if at == 0 && !S::SHAPED && is_fraction(factor) {
            bare(style, factor)
        } else if before.is_some_and(|before| numbers_touch::<S>(before, factor)) {
            style.fenced("(", &[bare(style, factor)], ")")
        } else {
            let context = if at == 0 {
                Level::Juxtaposition
            } else {
                Level::Power
            };
            factor_piece(style, factor, context, open_end)
        };
        set = if at == 0 {
            piece
        } else {
            style.binary(Operator::Juxtapose, &set, &piece)
        };
    }
    set
}

/// A factor; calls keep their parentheses unless the end after them is open.
fn factor_piece<S: Style>(style: &S, factor: &Tree, context: Level, open_end: bool) -> String {
    if open_end {
        return tree(style, factor, context);
    }
    match &factor.node {
        Node::Call(function, arguments) => call(style, *function, arguments, false),
        Node::Binary(Operator::Pow, base, exponent) => power(style, base, exponent, false),
        _ => tree(style, factor, context),
    }
}

/// The factors of products without sign, from left to right.
fn factors(tree: &Tree) -> Vec<&Tree> {
    let mut factors = Vec::new();
    let mut rest = tree;
    while let Node::Binary(Operator::Juxtapose, left, right) = &rest.node {
        factors.push(right.as_ref());
        rest = left;
    }
    factors.push(rest);
    factors.reverse();
    factors
}

/// A function, or a power of one: what ends a bare argument before it.
fn is_call(tree: &Tree) -> bool {
    match &tree.node {
        Node::Call(Function::Cis | Function::Abs | Function::Conj | Function::Sqrt, _) => false,
        Node::Call(..) => true,
        Node::Binary(Operator::Pow, base, _) => is_call(base),
        _ => false,
    }
}

/// The function and argument of a trigonometric call.
fn trigonometric(tree: &Tree) -> Option<(Function, &Tree)> {
    match &tree.node {
        Node::Call(function, arguments) if function.is_trigonometric() => match &arguments[..] {
            [argument] => Some((*function, argument)),
            _ => None,
        },
        _ => None,
    }
}

/// A symbol, or a number times a symbol.
fn is_bare_argument(tree: &Tree) -> bool {
    match &tree.node {
        Node::Number { .. } | Node::Pi | Node::Symbol(_) => true,
        Node::Binary(Operator::Juxtapose, left, right) => {
            matches!(left.node, Node::Number { .. })
                && matches!(right.node, Node::Symbol(_) | Node::Pi)
        }
        _ => false,
    }
}

fn power<S: Style>(style: &S, base: &Tree, exponent: &Tree, open_end: bool) -> String {
    if S::SHAPED {
        let exponent = tree(style, exponent, Level::For);
        if let Some((function, argument)) = trigonometric(base) {
            let argument_set = bare(style, argument);
            let argument_set = if open_end && is_bare_argument(argument) {
                argument_set
            } else {
                style.fenced("(", &[argument_set], ")")
            };
            return style.bare_call(function, Some(&exponent), &argument_set);
        }
        return style.power(&tree(style, base, Level::Atom), &exponent);
    }
    let base_set = if is_euler_power(base, exponent) {
        style.fenced("(", &[bare(style, base)], ")")
    } else {
        tree(style, base, Level::Atom)
    };
    style.power(&base_set, &exponent_piece(style, exponent))
}

/// Whether the reader would take the power of the symbol `e` for `e^(i γ)`.
fn is_euler_power(base: &Tree, exponent: &Tree) -> bool {
    let inner = match &exponent.node {
        Node::Negative(inner) => inner,
        _ => exponent,
    };
    matches!(&base.node, Node::Symbol(name) if name == "e")
        && (inner.node == Node::ImaginaryUnit || cis::without_unit(exponent).is_some())
}

fn exponent_piece<S: Style>(style: &S, exponent: &Tree) -> String {
    if S::SHAPED {
        return tree(style, exponent, Level::For);
    }
    match &exponent.node {
        Node::Negative(inner) if level::<S>(inner) == Level::Atom => {
            style.negative(&bare(style, inner))
        }
        _ => tree(style, exponent, Level::Power),
    }
}

fn call<S: Style>(style: &S, function: Function, arguments: &[Tree], open_end: bool) -> String {
    if let (Function::Cis, [angle]) = (function, arguments) {
        let exponent = tree(style, &cis::with_unit(angle), Level::For);
        let exponent = if S::SHAPED {
            exponent
        } else {
            style.fenced("(", &[exponent], ")")
        };
        return style.power(&style.euler(), &exponent);
    }
    match arguments {
        [argument]
            if S::SHAPED
                && open_end
                && function.is_trigonometric()
                && is_bare_argument(argument) =>
        {
            style.bare_call(function, None, &bare(style, argument))
        }
        _ => style.call(function, &each(style, arguments, Level::For)),
    }
}
