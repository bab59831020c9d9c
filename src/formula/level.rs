//! How tightly the constructs bind: one order for the reader and for everything that sets formulas.

use super::tree::{Connective, Operator, Relation};

/// From loose to tight. A construct may stand without parentheses where its own level or a looser
/// one is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Level {
    /// `P for x in {…}`
    For,
    /// `P iff Q`
    Iff,
    /// `P if Q`
    If,
    /// `P or Q`
    Or,
    /// `P and Q`
    And,
    /// `not P`
    Not,
    /// `x = y < z`
    Relation,
    /// `a : b : c`
    Ratio,
    /// `x + y`
    Sum,
    /// `−x`: of a whole product
    Negative,
    /// `x * y`, `x / y`
    Product,
    /// `x y`, `72 deg`
    Juxtaposition,
    /// `x ^ y`
    Power,
    /// What needs no parentheses anywhere.
    Atom,
}

impl Operator {
    /// How tightly it binds.
    pub(super) fn level(self) -> Level {
        match self {
            Operator::Add | Operator::Sub | Operator::PlusMinus | Operator::MinusPlus => Level::Sum,
            Operator::Mul | Operator::Div => Level::Product,
            Operator::Juxtapose => Level::Juxtaposition,
            Operator::Pow => Level::Power,
        }
    }
}

impl Connective {
    /// How tightly it binds.
    pub(super) fn level(self) -> Level {
        match self {
            Connective::And => Level::And,
            Connective::Or => Level::Or,
            Connective::If => Level::If,
            Connective::Iff => Level::Iff,
        }
    }

    /// What may stand on the left and on the right: chains of `and` lean to the left, chains of
    /// `if` and `iff` are not written.
    pub(super) fn sides(self) -> (Level, Level) {
        match self {
            Connective::And => (Level::And, Level::Not),
            Connective::Or => (Level::Or, Level::And),
            Connective::If => (Level::Or, Level::Or),
            Connective::Iff => (Level::If, Level::If),
        }
    }

    /// The word.
    pub(super) fn word(self) -> &'static str {
        match self {
            Connective::And => "and",
            Connective::Or => "or",
            Connective::If => "if",
            Connective::Iff => "iff",
        }
    }

    /// The connective of a word.
    pub(super) fn named(word: &str) -> Option<Connective> {
        [
            Connective::And,
            Connective::Or,
            Connective::If,
            Connective::Iff,
        ]
        .into_iter()
        .find(|connective| connective.word() == word)
    }
}

impl Relation {
    /// Every relation.
    const ALL: [Relation; 10] = [
        Relation::Equal,
        Relation::NotEqual,
        Relation::Less,
        Relation::LessOrEqual,
        Relation::Greater,
        Relation::GreaterOrEqual,
        Relation::Alike,
        Relation::Opposite,
        Relation::Congruent,
        Relation::Proportional,
    ];

    /// The canonical sign.
    pub(super) fn sign(self) -> &'static str {
        match self {
            Relation::Equal => "=",
            Relation::NotEqual => "≠",
            Relation::Less => "<",
            Relation::LessOrEqual => "≤",
            Relation::Greater => ">",
            Relation::GreaterOrEqual => "≥",
            Relation::Alike => "≷",
            Relation::Opposite => "≶",
            Relation::Congruent => "≡",
            Relation::Proportional => "~",
        }
    }

    /// The relation of a canonical sign.
    pub(super) fn named(sign: &str) -> Option<Relation> {
        Relation::ALL
            .into_iter()
            .find(|relation| relation.sign() == sign)
    }
}
