//! Curves on which values on a grid have a level, by marching squares, each in one piece.

use std::collections::BTreeMap;

use super::table::Values;
use crate::report::canvas::Point;

/// Two neighbours in the grid, between which a curve passes.
type Edge = [[u32; 2]; 2];

/// The curves; none where a value is missing or where neighbours differ by more than `jump`.
pub fn level_curves(values: &Values, step: u32, level: f64, jump: f64) -> Vec<Vec<Point>> {
    let mut neighbours: BTreeMap<Edge, Vec<Edge>> = BTreeMap::new();
    for corner in values.keys() {
        for [from, to] in pieces(values, *corner, step, level, jump) {
            neighbours.entry(from).or_default().push(to);
            neighbours.entry(to).or_default().push(from);
        }
    }
    let mut curves = Vec::new();
    // Open curves from their ends, then closed ones from anywhere.
    for is_open in [true, false] {
        let starts: Vec<Edge> = neighbours
            .iter()
            .filter(|(_, others)| !is_open || others.len() == 1)
            .map(|(edge, _)| *edge)
            .collect();
        for start in starts {
            let chain = follow(&mut neighbours, start);
            if chain.len() > 1 {
                curves.push(
                    chain
                        .iter()
                        .map(|edge| crossing(values, edge, level))
                        .collect(),
                );
            }
        }
    }
    curves
}

/// In the square with this lowest corner.
fn pieces(values: &Values, [a, b]: [u32; 2], step: u32, level: f64, jump: f64) -> Vec<Piece> {
    let corners = [[a, b], [a, b + step], [a + step, b + step], [a + step, b]];
    let known: Option<Vec<_>> = corners
        .iter()
        .map(|at| Some((*at, *values.get(at)?)))
        .collect();
    let Some(known) = known else {
        return Vec::new();
    };
    let sides = known.iter().zip(known.iter().cycle().skip(1));
    if sides.clone().any(|((_, x), (_, y))| (x - y).abs() > jump) {
        return Vec::new();
    }
    let crossed: Vec<Edge> = sides
        .filter(|((_, x), (_, y))| (*x < level) != (*y < level))
        .map(|((from, _), (to, _))| [*from.min(to), *from.max(to)])
        .collect();
    crossed.as_chunks().0.to_vec()
}

/// A piece of a curve, from edge to edge.
type Piece = [Edge; 2];

/// The curve from an edge on, taken out.
fn follow(neighbours: &mut BTreeMap<Edge, Vec<Edge>>, start: Edge) -> Vec<Edge> {
    let mut chain = vec![start];
    let mut here = start;
    while let Some(next) = neighbours.get_mut(&here).and_then(Vec::pop) {
        if let Some(back) = neighbours.get_mut(&next)
            && let Some(place) = back.iter().position(|edge| *edge == here)
        {
            back.swap_remove(place);
        }
        chain.push(next);
        here = next;
    }
    chain
}

fn crossing(values: &Values, [from, to]: &Edge, level: f64) -> Point {
    let at = |corner: &[u32; 2]| values.get(corner).copied().unwrap_or(level);
    let (low, high) = (at(from), at(to));
    let share = if low == high {
        0.5
    } else {
        (level - low) / (high - low)
    };
    let between = |x: u32, y: u32| {
        let [x, y] = [x, y].map(f64::from);
        x + share * (y - x)
    };
    [between(from[0], to[0]), between(from[1], to[1])]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(f: impl Fn(f64, f64) -> f64) -> Values {
        let points = (0..=20).flat_map(|a| (0..=20).map(move |b| [a, b]));
        points
            .map(|[a, b]| ([a, b], f(f64::from(a), f64::from(b))))
            .collect()
    }

    #[test]
    fn a_circle_is_one_closed_curve() {
        let values = grid(|a, b| (a - 10.0).hypot(b - 10.0));
        let curves = level_curves(&values, 1, 6.3, f64::INFINITY);
        assert_eq!(curves.len(), 1);
        let curve = &curves[0];
        assert_eq!(curve.first(), curve.last());
        for [a, b] in curve {
            assert!(((a - 10.0).hypot(b - 10.0) - 6.3).abs() < 0.03);
        }
    }

    #[test]
    fn a_jump_is_no_curve() {
        let values = grid(|a, _| if a < 10.5 { 0.0 } else { 1.0 });
        assert!(level_curves(&values, 1, 0.5, 0.9).is_empty());
        let line = level_curves(&values, 1, 0.5, 1.1);
        assert_eq!((line.len(), line[0].len()), (1, 21));
    }
}
