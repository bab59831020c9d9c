//! What a formula is: the tree that the reader makes and that everything else walks.

use std::collections::BTreeSet;
use std::ops::Range;

use rug::Rational;

use super::function::Function;
use super::running::{self, Running};

/// A place in the text of a formula, in bytes.
pub type Span = Range<usize>;

/// A whole formula: all its claims must hold, with the local definitions, where the assumptions do.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// What is claimed; several are separated by `;`.
    pub claims: Vec<Tree>,
    /// `where x = …, y = …`: names that the text itself defines, in order.
    pub definitions: Vec<(String, Tree)>,
    /// `assume …, …`: conditions under which the claims are meant.
    pub assumptions: Vec<Tree>,
}

/// A part of a formula and its place in the text. Two trees are equal when they say the same,
/// wherever they stand.
#[derive(Clone, Debug)]
pub struct Tree {
    /// What stands here.
    pub node: Node,
    /// Where it stands.
    pub span: Span,
}

impl Tree {
    /// A part of a formula at its place.
    pub fn new(node: Node, span: Span) -> Tree {
        Tree { node, span }
    }

    /// The parts right below, from left to right.
    pub fn children(&self) -> Vec<&Tree> {
        match &self.node {
            Node::Number { .. } | Node::Pi | Node::ImaginaryUnit | Node::Symbol(_) => Vec::new(),
            Node::Negative(inner) | Node::Degrees(inner) | Node::Not(inner) => vec![inner],
            Node::Binary(_, left, right) | Node::Logic(_, left, right) => vec![left, right],
            Node::Call(_, parts) | Node::Ratio(parts) | Node::List(parts) | Node::Set(parts) => {
                parts.iter().collect()
            }
            Node::Chain {
                first,
                rest,
                modulus,
            } => std::iter::once(first.as_ref())
                .chain(rest.iter().map(|(_, side)| side))
                .chain(modulus.as_deref())
                .collect(),
            Node::For { body, values, .. } | Node::Sum { body, values, .. } => vec![body, values],
        }
    }

    /// The parts right below, from left to right, to be changed.
    pub fn children_mut(&mut self) -> Vec<&mut Tree> {
        match &mut self.node {
            Node::Number { .. } | Node::Pi | Node::ImaginaryUnit | Node::Symbol(_) => Vec::new(),
            Node::Negative(inner) | Node::Degrees(inner) | Node::Not(inner) => vec![inner],
            Node::Binary(_, left, right) | Node::Logic(_, left, right) => vec![left, right],
            Node::Call(_, parts) | Node::Ratio(parts) | Node::List(parts) | Node::Set(parts) => {
                parts.iter_mut().collect()
            }
            Node::Chain {
                first,
                rest,
                modulus,
            } => std::iter::once(first.as_mut())
                .chain(rest.iter_mut().map(|(_, side)| side))
                .chain(modulus.as_deref_mut())
                .collect(),
            Node::For { body, values, .. } | Node::Sum { body, values, .. } => vec![body, values],
        }
    }
}

impl Tree {
    /// Whether something is so at this node or anywhere below it.
    pub fn any(&self, is_so: &impl Fn(&Node) -> bool) -> bool {
        is_so(&self.node) || self.children().into_iter().any(|child| child.any(is_so))
    }

    fn collect_symbols(&self, running: &mut Vec<Running>, symbols: &mut BTreeSet<String>) {
        match &self.node {
            Node::Symbol(name) => {
                symbols.insert(running::resolved(name, running).unwrap_or_else(|_| name.clone()));
            }
            Node::For { body, name, values } | Node::Sum { body, name, values } => {
                values.collect_symbols(running, symbols);
                for place in running::places(name, values, values.children().len()) {
                    running.push(place);
                    body.collect_symbols(running, symbols);
                    running.pop();
                }
            }
            _ => {
                for child in self.children() {
                    child.collect_symbols(running, symbols);
                }
            }
        }
    }
}

impl Formula {
    /// All names in it, those that it defines itself included; a running index in all its values.
    pub fn symbols(&self) -> BTreeSet<String> {
        let mut symbols = BTreeSet::new();
        let definitions = self.definitions.iter().map(|(_, expression)| expression);
        for tree in self
            .claims
            .iter()
            .chain(definitions)
            .chain(&self.assumptions)
        {
            tree.collect_symbols(&mut Vec::new(), &mut symbols);
        }
        symbols
    }
}

impl PartialEq for Tree {
    fn eq(&self, other: &Self) -> bool {
        self.node == other.node
    }
}

/// The constructs of the language.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// `3`, `0.125`, `2.5e-7`: taken exactly; the text is kept for setting.
    Number {
        /// As written.
        text: String,
        /// The value.
        value: Rational,
    },
    /// `pi`.
    Pi,
    /// `i`.
    ImaginaryUnit,
    /// A name of the scene or of a local definition, Greek letters spelled out: `alpha_a`, `O_12`, `x'`.
    Symbol(String),
    /// `−x`.
    Negative(Box<Tree>),
    /// `x ∘ y`.
    Binary(Operator, Box<Tree>, Box<Tree>),
    /// `72.5 deg`.
    Degrees(Box<Tree>),
    /// `f(x, …)`.
    Call(Function, Vec<Tree>),
    /// `a : b : c`, equal up to a common factor to what stands on the other side.
    Ratio(Vec<Tree>),
    /// `[a, b, …]`: a list, in order.
    List(Vec<Tree>),
    /// `{a, b, …}`: a set.
    Set(Vec<Tree>),
    /// `x = y < z …`, each relation between its two neighbours; `mod` at the end is for `≡`.
    Chain {
        /// The left-most side.
        first: Box<Tree>,
        /// The relations and their right-hand sides.
        rest: Vec<(Relation, Tree)>,
        /// What stands after `mod`.
        modulus: Option<Box<Tree>>,
    },
    /// `not P`.
    Not(Box<Tree>),
    /// `P and Q`, `P or Q`, `P if Q`, `P iff Q`.
    Logic(Connective, Box<Tree>, Box<Tree>),
    /// `P for x in {…}`: for each of them.
    For {
        /// What is claimed of each.
        body: Box<Tree>,
        /// The bound name.
        name: String,
        /// A list or set.
        values: Box<Tree>,
    },
    /// `sum(x for k in […])`.
    Sum {
        /// What is added up.
        body: Box<Tree>,
        /// The bound name.
        name: String,
        /// A list.
        values: Box<Tree>,
    },
}

/// Arithmetic between two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operator {
    /// `x + y`
    Add,
    /// `x − y`
    Sub,
    /// `x * y`, `x · y`
    Mul,
    /// `x y`: a product by standing side by side
    Juxtapose,
    /// `x / y`
    Div,
    /// `x ^ y`
    Pow,
    /// `x ± y`: both values
    PlusMinus,
    /// `x ∓ y`: both values, the sign opposite to that of every `±` in the formula
    MinusPlus,
}

/// A relation between two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `=`
    Equal,
    /// `≠`, `!=`
    NotEqual,
    /// `<`
    Less,
    /// `≤`, `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `≥`, `>=`
    GreaterOrEqual,
    /// `≷`, `><`: greater, equal or less, the same one at every place of the claim
    Alike,
    /// `≶`, `<>`: the opposite of every `≷` of the claim
    Opposite,
    /// `≡ … mod …`, `==`
    Congruent,
    /// `~`: equal up to a common factor that is not zero
    Proportional,
}

/// How two claims are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Connective {
    /// both
    And,
    /// at least one
    Or,
    /// the first, wherever the second
    If,
    /// both or none
    Iff,
}
