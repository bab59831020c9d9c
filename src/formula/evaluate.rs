//! Evaluation of a formula in any number kind.

use std::cmp::Ordering;

use rug::Rational;
use thiserror::Error;

use super::bindings::Bindings;
use super::compare::{self, Signs};
use super::function::Function;
use super::operate;
use super::running::{self, Running};
use super::tree::{Connective, Formula, Node, Operator, Relation, Span, Tree};
use super::value::Value;
use crate::number::{Number, Real, Truth};

/// Why a formula could not be evaluated.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Failure {
    /// The formula itself is wrong: an unknown name, or types that do not go together.
    #[error("{message}")]
    Wrong {
        /// What is wrong and what was expected.
        message: String,
        /// Where.
        span: Span,
    },
    /// An operation is not defined here, or the number kind does not hold its result.
    #[error("no value: {message}")]
    NoValue {
        /// Which operation.
        message: String,
        /// Where.
        span: Span,
    },
}

impl Failure {
    /// The place in the text of the formula.
    pub fn span(&self) -> &Span {
        match self {
            Failure::Wrong { span, .. } | Failure::NoValue { span, .. } => span,
        }
    }

    pub(super) fn wrong(message: impl Into<String>, tree: &Tree) -> Failure {
        Failure::Wrong {
            message: message.into(),
            span: tree.span.clone(),
        }
    }

    pub(super) fn no_value(message: impl Into<String>, tree: &Tree) -> Failure {
        Failure::NoValue {
            message: message.into(),
            span: tree.span.clone(),
        }
    }
}

/// What a formula says of one binding of its symbols.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// Whether the assumptions hold.
    pub assumed: Truth,
    /// Whether all claims hold.
    pub holds: Truth,
}

/// Evaluates a formula. Everything is evaluated, also what could not change the outcome, so that a
/// wrong formula never goes unnoticed.
pub fn evaluate<K: Real>(formula: &Formula, bindings: &Bindings<K>) -> Result<Outcome, Failure> {
    let mut scope = Scope::new(bindings);
    scope.define(formula)?;
    Ok(Outcome {
        assumed: scope.all(&formula.assumptions)?,
        holds: scope.all(&formula.claims)?,
    })
}

/// Evaluates an expression: a claim list of one member that claims nothing.
pub fn evaluate_expression<K: Real>(
    formula: &Formula,
    bindings: &Bindings<K>,
) -> Result<Value<K>, Failure> {
    let mut scope = Scope::new(bindings);
    scope.define(formula)?;
    match formula.claims.as_slice() {
        [expression] => scope.value(expression),
        _ => Err(Failure::Wrong {
            message: "an expression was expected here, not a list of claims".to_owned(),
            span: 0..0,
        }),
    }
}

/// Bindings with the formula's own definitions on top.
pub(super) struct Scope<'a, K: Real> {
    bindings: &'a Bindings<K>,
    locals: Vec<(String, Value<K>)>,
    running: Vec<Running>,
    signs: Signs,
}

impl<'a, K: Real> Scope<'a, K> {
    fn new(bindings: &'a Bindings<K>) -> Self {
        Scope {
            bindings,
            locals: Vec::new(),
            running: Vec::new(),
            signs: Signs::default(),
        }
    }

    fn define(&mut self, formula: &Formula) -> Result<(), Failure> {
        for (name, expression) in &formula.definitions {
            let value = self.value(expression)?;
            self.locals.push((name.clone(), value));
        }
        Ok(())
    }

    pub(super) fn precision(&self) -> &K::Precision {
        self.bindings.precision()
    }

    pub(super) fn signs(&self) -> Signs {
        self.signs
    }

    fn all(&mut self, claims: &[Tree]) -> Result<Truth, Failure> {
        claims.iter().try_fold(Truth::Yes, |all, claim| {
            Ok(all & self.claim_in_all_senses(claim)?)
        })
    }

    /// A claim with `≷` is three claims.
    fn claim_in_all_senses(&mut self, claim: &Tree) -> Result<Truth, Failure> {
        if !says_alike(claim) {
            return self.claim(claim);
        }
        let mut truth = Truth::Yes;
        for order in [Ordering::Greater, Ordering::Equal, Ordering::Less] {
            self.signs.alike = Some(order);
            truth = truth & self.claim(claim)?;
        }
        self.signs.alike = None;
        Ok(truth)
    }

    fn claim(&mut self, tree: &Tree) -> Result<Truth, Failure> {
        match &tree.node {
            Node::Chain {
                first,
                rest,
                modulus,
            } => compare::chain(self, first, rest, modulus.as_deref()),
            Node::Not(claim) => Ok(!self.claim(claim)?),
            Node::Logic(connective, left, right) => {
                let (left, right) = (self.claim(left)?, self.claim(right)?);
                Ok(match connective {
                    Connective::And => left & right,
                    Connective::Or => left | right,
                    Connective::If => left | !right,
                    Connective::Iff => left.iff(right),
                })
            }
            Node::For { body, name, values } => self.for_each(body, name, values),
            Node::Call(function, arguments) if function.is_predicate() => {
                let arguments = self.values(arguments)?;
                let truth = operate::predicate(*function, &arguments, tree)?;
                Ok(compare::for_all::<K>(truth))
            }
            _ => {
                self.value(tree)?;
                Err(Failure::wrong(
                    "this is a value; a claim (an equation, a relation) was expected",
                    tree,
                ))
            }
        }
    }

    fn for_each(&mut self, body: &Tree, name: &str, values: &Tree) -> Result<Truth, Failure> {
        let claims = self.at_each(name, values, |scope| scope.claim(body))?;
        Ok(Truth::all(claims))
    }

    /// What a part says for each of the values of a bound name.
    fn at_each<T>(
        &mut self,
        name: &str,
        values: &Tree,
        mut part: impl FnMut(&mut Self) -> Result<T, Failure>,
    ) -> Result<Vec<T>, Failure> {
        let (Value::List(members) | Value::Set(members)) = self.value(values)? else {
            return Err(Failure::wrong("a list or set was expected here", values));
        };
        let mut found = Vec::new();
        let places = running::places(name, values, members.len());
        for (member, place) in members.into_iter().zip(places) {
            self.locals.push((name.to_owned(), member));
            self.running.push(place);
            let one = part(self);
            self.running.pop();
            self.locals.pop();
            found.push(one?);
        }
        Ok(found)
    }

    fn sum(&mut self, body: &Tree, name: &str, values: &Tree) -> Result<Value<K>, Failure> {
        let terms = self.at_each(name, values, |scope| scope.value(body))?;
        let sum = terms.into_iter().try_fold(None, |sum, term| match sum {
            None if term.has_sum() => Ok(Some(term)),
            None => Err(Failure::wrong(
                format!("{} cannot be added up", term.kind_name()),
                body,
            )),
            Some(sum) => {
                operate::binary(Operator::Add, sum, term, self.precision(), body).map(Some)
            }
        })?;
        Ok(sum.unwrap_or_else(|| Value::Number(Number::zero())))
    }

    fn values(&mut self, trees: &[Tree]) -> Result<Vec<Value<K>>, Failure> {
        trees.iter().map(|tree| self.value(tree)).collect()
    }

    /// Both values of a side with `±`, as a set; any other side as it is.
    pub(super) fn side(&mut self, tree: &Tree) -> Result<Value<K>, Failure> {
        if self.signs.plus.is_some() || !says_plus_minus(tree) {
            return self.value(tree);
        }
        let mut both = Vec::new();
        for plus in [true, false] {
            self.signs.plus = Some(plus);
            let value = self.value(tree);
            self.signs.plus = None;
            both.push(value?);
        }
        Ok(Value::Set(both))
    }

    pub(super) fn value(&mut self, tree: &Tree) -> Result<Value<K>, Failure> {
        let value = self.any_value(tree)?;
        if value.is_excessive() {
            Err(Failure::no_value(TOO_LARGE, tree))
        } else if value.has_value() {
            Ok(value)
        } else {
            Err(Failure::no_value(
                "a division by zero, or a root that this arithmetic does not hold",
                tree,
            ))
        }
    }

    fn any_value(&mut self, tree: &Tree) -> Result<Value<K>, Failure> {
        match &tree.node {
            Node::Number { value, .. } => Ok(Value::Number(Number::rounded(
                value,
                self.bindings.precision(),
            ))),
            Node::Pi => Ok(Value::Turn(Rational::from(1))),
            Node::ImaginaryUnit => Ok(Value::Point(Number::i())),
            Node::Symbol(name) => self.symbol(name, tree),
            Node::Negative(inner) => operate::negative(self.value(inner)?, tree),
            Node::Binary(operator, left, right) => self.binary(*operator, left, right, tree),
            Node::Degrees(inner) => match constant(inner) {
                Some(degrees) => Ok(Value::Turn(degrees / 180)),
                None => Err(Failure::wrong("a number was expected before `deg`", inner)),
            },
            Node::Call(function, arguments) => self.call(*function, arguments, tree),
            Node::List(members) => Ok(Value::List(self.values(members)?)),
            Node::Set(members) => Ok(Value::Set(self.values(members)?)),
            Node::Sum { body, name, values } => self.sum(body, name, values),
            Node::Ratio(_) => Err(Failure::wrong(
                "a ratio stands only on a side of an equation",
                tree,
            )),
            Node::Chain { .. } | Node::Not(_) | Node::Logic(..) | Node::For { .. } => Err(
                Failure::wrong("a value was expected here, not a claim", tree),
            ),
        }
    }

    fn symbol(&self, written: &str, tree: &Tree) -> Result<Value<K>, Failure> {
        let name = running::resolved(written, &self.running)
            .map_err(|message| Failure::wrong(message, tree))?;
        let local = self.locals.iter().rev().find(|(local, _)| *local == name);
        match local
            .map(|(_, value)| value)
            .or_else(|| self.bindings.get(&name))
        {
            Some(value) => Ok(value.clone()),
            None => {
                let known: Vec<&str> = self.bindings.names().collect();
                Err(Failure::wrong(
                    format!(
                        "unknown symbol `{name}`; the scene has {}",
                        known.join(", ")
                    ),
                    tree,
                ))
            }
        }
    }

    fn call(
        &mut self,
        function: Function,
        arguments: &[Tree],
        tree: &Tree,
    ) -> Result<Value<K>, Failure> {
        if function.is_predicate() {
            return Err(Failure::wrong(
                "a value was expected here, not a claim",
                tree,
            ));
        }
        let values = self.values(arguments)?;
        operate::call(function, &values, self.precision(), tree)
    }

    fn binary(
        &mut self,
        operator: Operator,
        left: &Tree,
        right: &Tree,
        tree: &Tree,
    ) -> Result<Value<K>, Failure> {
        if operator == Operator::Pow {
            let base = self.value(left)?;
            return operate::power(&base, constant(right), tree, right);
        }
        let operator = match (operator, self.signs.plus) {
            (Operator::PlusMinus, Some(true)) | (Operator::MinusPlus, Some(false)) => Operator::Add,
            (Operator::PlusMinus, Some(false)) | (Operator::MinusPlus, Some(true)) => Operator::Sub,
            (Operator::PlusMinus | Operator::MinusPlus, None) => {
                return Err(Failure::wrong(
                    "± stands only on a side of an equation",
                    tree,
                ));
            }
            (operator, _) => operator,
        };
        let (a, b) = (self.value(left)?, self.value(right)?);
        // A part or multiple of pi by a constant is one whatever the constant.
        match (operator, &a, &b, constant(left), constant(right)) {
            (Operator::Mul | Operator::Juxtapose, Value::Turn(turn), _, _, Some(factor))
            | (Operator::Mul | Operator::Juxtapose, _, Value::Turn(turn), Some(factor), _) => {
                Ok(Value::Turn(factor * turn))
            }
            (Operator::Div, Value::Turn(turn), _, _, Some(divisor)) if !divisor.is_zero() => {
                Ok(Value::Turn(turn / divisor))
            }
            _ => operate::binary(operator, a, b, self.precision(), tree),
        }
    }
}

/// Why an exact number is not computed.
pub(super) const TOO_LARGE: &str =
    "a number or polynomial that is too large to be computed with exactly";

/// The value of a tree of numbers only.
pub(super) fn constant(tree: &Tree) -> Option<Rational> {
    match &tree.node {
        Node::Number { value, .. } => Some(value.clone()),
        Node::Negative(inner) => Some(-constant(inner)?),
        Node::Binary(Operator::Div, left, right) => {
            let divisor = constant(right).filter(|divisor| !divisor.is_zero())?;
            Some(constant(left)? / divisor)
        }
        _ => None,
    }
}

fn says_alike(tree: &Tree) -> bool {
    tree.any(&|node| {
        matches!(node, Node::Chain { rest, .. }
            if rest.iter().any(|(relation, _)| matches!(relation, Relation::Alike | Relation::Opposite)))
    })
}

fn says_plus_minus(tree: &Tree) -> bool {
    tree.any(&|node| {
        matches!(
            node,
            Node::Binary(Operator::PlusMinus | Operator::MinusPlus, ..)
        )
    })
}
