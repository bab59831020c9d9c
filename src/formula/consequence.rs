//! What follows from a formula by the rules of equality alone.

use super::tree::{Formula, Node, Operator, Relation, Tree};

/// Whether a formula plainly holds wherever another does, claim by claim: it says the same, or only that
/// sides are equal which the other calls equal. `false` says nothing.
pub fn follows(formula: &Formula, given: &Formula) -> bool {
    let classes = equal_sides(&given.claims);
    formula.definitions == given.definitions
        && formula.assumptions == given.assumptions
        && formula.claims.len() == given.claims.len()
        && formula
            .claims
            .iter()
            .zip(&given.claims)
            .all(|(claim, given)| says_the_same(claim, given) || is_known(claim, &classes))
}

/// The sides of a chain of equations.
fn sides_of_equations(claim: &Tree) -> Option<Vec<&Tree>> {
    let Node::Chain {
        rest,
        modulus: None,
        ..
    } = &claim.node
    else {
        return None;
    };
    let is_equation = rest
        .iter()
        .all(|(relation, _)| *relation == Relation::Equal);
    (is_equation && !claim.any(&has_two_values)).then(|| claim.children())
}

fn has_two_values(node: &Node) -> bool {
    matches!(
        node,
        Node::Binary(Operator::PlusMinus | Operator::MinusPlus, ..)
    )
}

/// Classes of sides that the equations among the claims make equal.
fn equal_sides(claims: &[Tree]) -> Vec<Vec<&Tree>> {
    let mut classes: Vec<Vec<&Tree>> = Vec::new();
    for mut class in claims.iter().filter_map(sides_of_equations) {
        let (touched, apart) = classes
            .into_iter()
            .partition(|known| known.iter().any(|side| class.contains(side)));
        classes = apart;
        class.extend(touched.into_iter().flatten());
        classes.push(class);
    }
    classes
}

/// Whether it equates only sides of one class.
fn is_known(claim: &Tree, classes: &[Vec<&Tree>]) -> bool {
    let Some(sides) = sides_of_equations(claim) else {
        return false;
    };
    classes
        .iter()
        .any(|class| sides.iter().all(|side| class.contains(side)))
}

fn says_the_same(claim: &Tree, given: &Tree) -> bool {
    claim == given
        || match (&claim.node, &given.node) {
            (Node::Not(one), Node::Not(other)) => says_the_same(one, other),
            (Node::Logic(joined, a, b), Node::Logic(given, x, y)) => {
                joined == given && says_the_same(a, x) && says_the_same(b, y)
            }
            _ => match (compared_with_zero(claim), compared_with_zero(given)) {
                (Some((one, x)), Some((other, y))) => {
                    one == other && without_factor(x, one) == without_factor(y, one)
                }
                _ => false,
            },
        }
}

/// `x ∘ 0`: the relation and x.
fn compared_with_zero(claim: &Tree) -> Option<(Relation, &Tree)> {
    match &claim.node {
        Node::Chain {
            first,
            rest,
            modulus: None,
        } => match rest.as_slice() {
            [(relation, zero)] if is_number(zero, |value| value == &0) => {
                Some((*relation, first.as_ref()))
            }
            _ => None,
        },
        _ => None,
    }
}

fn is_number(tree: &Tree, is_so: impl Fn(&rug::Rational) -> bool) -> bool {
    matches!(&tree.node, Node::Number { value, .. } if is_so(value))
}

/// Without what does not change how it compares with zero: a positive factor, and of an equation also
/// the sign and a power.
fn without_factor(side: &Tree, relation: Relation) -> &Tree {
    let only_zero_matters = matches!(relation, Relation::Equal | Relation::NotEqual);
    let inner = match &side.node {
        Node::Binary(Operator::Mul | Operator::Juxtapose, factor, inner)
            if is_number(factor, |value| *value > 0) =>
        {
            inner
        }
        Node::Negative(inner) if only_zero_matters => inner,
        Node::Binary(Operator::Pow, inner, power)
            if only_zero_matters && is_number(power, |value| *value > 0) =>
        {
            inner
        }
        _ => return side,
    };
    without_factor(inner, relation)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::read;

    fn check(formula: &str, given: &str) -> bool {
        follows(&read(formula).expect("reads"), &read(given).expect("reads"))
    }

    #[test]
    fn equations_follow_from_equations() {
        assert!(check("a = c", "a = c"));
        assert!(check("a = a; b = c", "a = b; b = c"));
        assert!(check("a = c; b = c", "a = b; b = c"));
        assert!(check("dist(x, y) = b = b", "dist(x, y) = a = b"));
        assert!(!check("a = d; b = c", "a = b; b = c"));
        assert!(!check("a = c; c = d", "a = b; c = d"));
        assert!(!check("a = 0 ± b", "a = b"));
        assert!(!check("a = a", "a = 0 ± b"));
    }

    #[test]
    fn factors_do_not_change_how_a_side_compares_with_zero() {
        assert!(check("n^2 = 0 or m = 1", "n = 0 or m = 1"));
        assert!(check("not -n = 0", "not n = 0"));
        assert!(check("2 s >= 0 iff t > 0", "s >= 0 iff t > 0"));
        assert!(!check("s^2 >= 0 iff t > 0", "s >= 0 iff t > 0"));
        assert!(!check("-s >= 0", "s >= 0"));
        assert!(!check("n^2 = 1", "n = 1"));
        assert!(!check("0 * n = 0 iff m = 0", "n = 0 iff m = 0"));
    }

    #[test]
    fn conditions_stay_as_they_are() {
        assert!(!check("a = b assume c > 0", "a = b"));
        assert!(!check("a = b where b = 2 c", "a = b where b = c"));
    }
}
