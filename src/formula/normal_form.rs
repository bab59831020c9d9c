//! The normal form of an expression or equation in its own symbols.

use super::bindings::Bindings;
use super::evaluate::{Failure, evaluate_expression};
use super::tree::{Formula, Node, Operator, Relation, Span, Tree};
use super::value::Value;
use crate::number::{Fraction, Number, Ring};

/// An expression, or the difference of the sides of an equation, as a fraction of polynomials in its
/// symbols, each of which stands for a real number. Two expressions are equal for all values of
/// their symbols exactly if their difference has the normal form 0.
///
/// ```
/// use burmester::formula::{normal_form, read};
/// let form = normal_form(&read("(a^2 - b^2)/(a - b)")?)?;
/// assert_eq!(form.to_string(), "a + b");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// A formula of several claims or of another relation than one `=`; functions that are no fraction
/// of polynomials; a denominator that is zero.
pub fn normal_form(formula: &Formula) -> Result<Number<Fraction>, Failure> {
    let expression = Formula {
        claims: vec![difference(formula)?],
        definitions: formula.definitions.clone(),
        assumptions: Vec::new(),
    };
    let bindings = free_symbols(&expression)?;
    match evaluate_expression(&expression, &bindings)? {
        Value::Number(number) => Ok(number),
        other => Err(unfit(
            format!("{} has no normal form", other.kind_name()),
            0..0,
        )),
    }
}

fn unfit(message: impl Into<String>, span: Span) -> Failure {
    Failure::Wrong {
        message: message.into(),
        span,
    }
}

/// The expression itself, or left side minus right side.
fn difference(formula: &Formula) -> Result<Tree, Failure> {
    let [claim] = formula.claims.as_slice() else {
        return Err(unfit("one expression or equation was expected", 0..0));
    };
    match &claim.node {
        Node::Chain {
            first,
            rest,
            modulus: None,
        } => match rest.as_slice() {
            [(Relation::Equal, right)] => Ok(Tree::new(
                Node::Binary(Operator::Sub, first.clone(), Box::new(right.clone())),
                claim.span.clone(),
            )),
            _ => Err(unfit("one `=` was expected", claim.span.clone())),
        },
        _ => Ok(claim.clone()),
    }
}

/// A variable for each symbol that the formula does not define itself.
fn free_symbols(formula: &Formula) -> Result<Bindings<Fraction>, Failure> {
    let defined = |name: &str| formula.definitions.iter().any(|(own, _)| own == name);
    let symbols = formula.symbols();
    let names: Vec<&str> = symbols
        .iter()
        .map(String::as_str)
        .filter(|name| !defined(name))
        .collect();
    let ring =
        Ring::free(&names).ok_or_else(|| unfit("more symbols than a polynomial can have", 0..0))?;
    let mut bindings = Bindings::new(());
    for name in names {
        bindings.bind(name, Number::<Fraction>::named(&ring, name));
    }
    Ok(bindings)
}
