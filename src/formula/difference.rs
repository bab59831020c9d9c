//! In what two formulas differ: the smallest parts of each that the other does not have.

use super::tree::{Formula, Node, Operator, Span, Tree};

/// The places in the text of each formula that differ from the other.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Difference {
    /// In the first.
    pub left: Vec<Span>,
    /// In the second.
    pub right: Vec<Span>,
}

/// Compares two formulas part by part. Terms of sums and factors of products that both have in the same
/// order are common to them.
pub fn difference(left: &Formula, right: &Formula) -> Difference {
    let mut found = Difference::default();
    found.lists(&plain(&left.claims), &plain(&right.claims));
    let definitions = |formula: &Formula| -> Vec<Tree> {
        let values = formula.definitions.iter();
        values.map(|(_, value)| value.clone()).collect()
    };
    let [of_left, of_right] = [definitions(left), definitions(right)];
    found.lists(&plain(&of_left), &plain(&of_right));
    found.lists(&plain(&left.assumptions), &plain(&right.assumptions));
    found
}

/// A part of a list, and whether it is taken with the opposite sign.
type Part<'a> = (bool, &'a Tree);

fn plain(trees: &[Tree]) -> Vec<Part<'_>> {
    trees.iter().map(|tree| (false, tree)).collect()
}

impl Difference {
    fn mark(&mut self, left: &[Part<'_>], right: &[Part<'_>]) {
        self.left
            .extend(left.iter().map(|(_, tree)| tree.span.clone()));
        self.right
            .extend(right.iter().map(|(_, tree)| tree.span.clone()));
    }

    fn trees(&mut self, left: &Tree, right: &Tree) {
        if left == right {
            return;
        }
        for parts in [terms, factors] {
            let [of_left, of_right] = [parts(left), parts(right)];
            if of_left.len() > 1 || of_right.len() > 1 {
                return self.lists(&of_left, &of_right);
            }
        }
        let [of_left, of_right] = [left.children(), right.children()];
        if of_left.is_empty() || of_left.len() != of_right.len() || !same_head(left, right) {
            return self.mark(&[(false, left)], &[(false, right)]);
        }
        for (left, right) in of_left.into_iter().zip(of_right) {
            self.trees(left, right);
        }
    }

    /// Splits both lists at a longest row of common parts, and compares what is between.
    fn lists(&mut self, left: &[Part<'_>], right: &[Part<'_>]) {
        let mut rest = (left, right);
        for (i, j) in common(left, right) {
            let between = (
                i - (left.len() - rest.0.len()),
                j - (right.len() - rest.1.len()),
            );
            let (before_left, after_left) = rest.0.split_at(between.0);
            let (before_right, after_right) = rest.1.split_at(between.1);
            self.gap(before_left, before_right);
            rest = (
                after_left
                    .split_first()
                    .map_or(after_left, |(_, rest)| rest),
                after_right
                    .split_first()
                    .map_or(after_right, |(_, rest)| rest),
            );
        }
        self.gap(rest.0, rest.1);
    }

    fn gap(&mut self, left: &[Part<'_>], right: &[Part<'_>]) {
        let alike = |(x, y): (&Part<'_>, &Part<'_>)| x.0 == y.0;
        if left.len() != right.len() || !left.iter().zip(right).all(alike) {
            return self.mark(left, right);
        }
        for ((_, left), (_, right)) in left.iter().zip(right) {
            self.trees(left, right);
        }
    }
}

fn opposite(parts: Vec<Part<'_>>) -> Vec<Part<'_>> {
    parts
        .into_iter()
        .map(|(sign, tree)| (!sign, tree))
        .collect()
}

/// The terms of a sum with their signs; a tree that is none is its only term.
fn terms(tree: &Tree) -> Vec<Part<'_>> {
    match &tree.node {
        Node::Binary(Operator::Add, left, right) => [terms(left), terms(right)].concat(),
        Node::Binary(Operator::Sub, left, right) => {
            let right: Vec<Part<'_>> = match terms(right) {
                single if single.len() == 1 => opposite(single),
                _ => vec![(true, right)],
            };
            [terms(left), right].concat()
        }
        Node::Negative(inner) => match terms(inner) {
            single if single.len() == 1 => opposite(single),
            _ => vec![(true, inner)],
        },
        _ => vec![(false, tree)],
    }
}

/// The factors of a product; a tree that is none is its only factor.
fn factors(tree: &Tree) -> Vec<Part<'_>> {
    match &tree.node {
        Node::Binary(Operator::Mul | Operator::Juxtapose, left, right) => {
            [factors(left), factors(right)].concat()
        }
        _ => vec![(false, tree)],
    }
}

/// Whether two trees are the same construct, whatever their parts.
fn same_head(left: &Tree, right: &Tree) -> bool {
    match (&left.node, &right.node) {
        (Node::Binary(x, ..), Node::Binary(y, ..)) => x == y,
        (Node::Call(x, _), Node::Call(y, _)) => x == y,
        (Node::Logic(x, ..), Node::Logic(y, ..)) => x == y,
        (
            Node::Chain {
                rest: x,
                modulus: m,
                ..
            },
            Node::Chain {
                rest: y,
                modulus: n,
                ..
            },
        ) => {
            m.is_some() == n.is_some()
                && x.iter()
                    .map(|(sign, _)| sign)
                    .eq(y.iter().map(|(sign, _)| sign))
        }
        (Node::For { name: x, .. }, Node::For { name: y, .. })
        | (Node::Sum { name: x, .. }, Node::Sum { name: y, .. }) => x == y,
        (x, y) => std::mem::discriminant(x) == std::mem::discriminant(y),
    }
}

/// Places of a longest common row of parts.
fn common(left: &[Part<'_>], right: &[Part<'_>]) -> Vec<(usize, usize)> {
    // How long it is from (i, j) on, from behind.
    let mut longest = vec![vec![0_usize; right.len() + 1]; left.len() + 1];
    let at = |table: &[Vec<usize>], i: usize, j: usize| -> usize {
        table
            .get(i)
            .and_then(|row| row.get(j))
            .copied()
            .unwrap_or(0)
    };
    for (i, x) in left.iter().enumerate().rev() {
        for (j, y) in right.iter().enumerate().rev() {
            let best = if x == y {
                1 + at(&longest, i + 1, j + 1)
            } else {
                at(&longest, i + 1, j).max(at(&longest, i, j + 1))
            };
            if let Some(place) = longest.get_mut(i).and_then(|row| row.get_mut(j)) {
                *place = best;
            }
        }
    }
    let (mut i, mut j) = (0, 0);
    let mut places = Vec::new();
    while let (Some(x), Some(y)) = (left.get(i), right.get(j)) {
        if x == y {
            places.push((i, j));
            (i, j) = (i + 1, j + 1);
        } else if at(&longest, i + 1, j) >= at(&longest, i, j + 1) {
            i += 1;
        } else {
            j += 1;
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::read;

    /// What is marked in both texts.
    fn marked(left: &str, right: &str) -> [Vec<String>; 2] {
        let found = difference(&read(left).unwrap(), &read(right).unwrap());
        let texts = |text: &str, spans: &[Span]| -> Vec<String> {
            spans
                .iter()
                .map(|span| text.get(span.clone()).unwrap().to_owned())
                .collect()
        };
        [texts(left, &found.left), texts(right, &found.right)]
    }

    #[test]
    fn only_what_differs_is_marked() {
        let cases = [
            ("x = a + b", "x = a + b", vec![], vec![]),
            ("x = a + b", "x = a - b", vec!["b"], vec!["b"]),
            ("x = 2 a b", "x = 3 a b", vec!["2"], vec!["3"]),
            ("x = sin(2 a)", "x = sin(a)", vec!["2"], vec![]),
            ("x = a^2/b", "x = a^3/b", vec!["2"], vec!["3"]),
            ("x = a + c d", "x = a + b + c d", vec![], vec!["b"]),
            ("x = cos a", "x = sin a", vec!["cos a"], vec!["sin a"]),
            ("x = a; y = b", "x = a; y = c", vec!["b"], vec!["c"]),
            (
                "x = (a + b)(c + d) + e",
                "x = a c + b d + e",
                vec!["(a + b)(c + d)"],
                vec!["a c", "b d"],
            ),
        ];
        for (left, right, of_left, of_right) in cases {
            assert_eq!(marked(left, right), [of_left, of_right], "{left} | {right}");
        }
    }
}
