//! `e^(i γ)`: how the factor i is found in an exponent, and where it is put back for setting.

use super::tree::{Node, Operator, Tree};

/// The exponent without its factor `i`; nothing if it has none, or is nothing else.
pub(super) fn without_unit(exponent: &Tree) -> Option<Tree> {
    match &exponent.node {
        Node::Negative(inner) => {
            let rest = without_unit(inner)?;
            Some(Tree::new(
                Node::Negative(Box::new(rest)),
                exponent.span.clone(),
            ))
        }
        Node::Binary(operator @ (Operator::Juxtapose | Operator::Mul), left, right) => {
            if left.node == Node::ImaginaryUnit {
                return Some(right.as_ref().clone());
            }
            if let Some(rest) = without_unit(left) {
                return Some(binary(*operator, rest, right.as_ref().clone(), exponent));
            }
            (right.node == Node::ImaginaryUnit).then(|| left.as_ref().clone())
        }
        Node::Binary(Operator::Div, left, right) => {
            let rest = without_unit(left)?;
            Some(binary(
                Operator::Div,
                rest,
                right.as_ref().clone(),
                exponent,
            ))
        }
        _ => None,
    }
}

/// The exponent of `e` for an angle: the inverse of [`without_unit`].
pub(super) fn with_unit(angle: &Tree) -> Tree {
    let unit = Tree::new(Node::ImaginaryUnit, angle.span.clone());
    match &angle.node {
        Node::Negative(inner) => Tree::new(
            Node::Negative(Box::new(with_unit(inner))),
            angle.span.clone(),
        ),
        Node::Binary(Operator::Juxtapose, left, right) if is_coefficient(left) => {
            let unit_after = binary(Operator::Juxtapose, left.as_ref().clone(), unit, angle);
            binary(
                Operator::Juxtapose,
                unit_after,
                right.as_ref().clone(),
                angle,
            )
        }
        Node::Binary(
            operator @ (Operator::Juxtapose | Operator::Mul | Operator::Div),
            left,
            right,
        ) => binary(*operator, with_unit(left), right.as_ref().clone(), angle),
        _ => binary(Operator::Juxtapose, unit, angle.clone(), angle),
    }
}

/// A number or a fraction of two numbers.
fn is_coefficient(tree: &Tree) -> bool {
    match &tree.node {
        Node::Number { .. } => true,
        Node::Binary(Operator::Div, left, right) => {
            matches!(left.node, Node::Number { .. }) && matches!(right.node, Node::Number { .. })
        }
        _ => false,
    }
}

fn binary(operator: Operator, left: Tree, right: Tree, place: &Tree) -> Tree {
    Tree::new(
        Node::Binary(operator, Box::new(left), Box::new(right)),
        place.span.clone(),
    )
}
