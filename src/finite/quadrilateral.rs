//! Opposite-pole quadrilaterals: shape, sides, and what the sides tell of the curve.

use std::cmp::Ordering;

use crate::number::{Kind, Number, Real, Truth};
use crate::plane::{Point, relation};

/// The three opposite-pole quadrilaterals of positions 0 to 3, by the poles in order: the ends of a
/// diagonal have no position in common.
pub const OPPOSITE_POLES: [[(usize, usize); 4]; 3] = [
    [(0, 1), (1, 2), (2, 3), (0, 3)],
    [(0, 1), (1, 3), (2, 3), (0, 2)],
    [(0, 3), (1, 3), (1, 2), (0, 2)],
];

/// How a quadrilateral lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shape {
    /// It turns to the same side in all vertices.
    Convex,
    /// It turns to the other side in one vertex.
    Concave,
    /// Two opposite sides cross.
    Crossed,
    /// Three vertices lie on a line.
    Degenerate,
}

/// The shape; `None` where it cannot be told.
pub fn shape<K: Real>(vertices: &[Point<K>; 4]) -> Option<Shape> {
    let mut left = 0;
    for i in 0..4 {
        let [a, b, c] = [i, i + 1, i + 2].map(|j| &vertices[j % 4]);
        match relation::twice_area(a, b, c).sign()? {
            Ordering::Equal => return Some(Shape::Degenerate),
            Ordering::Greater => left += 1,
            Ordering::Less => {}
        }
    }
    Some(match left {
        0 | 4 => Shape::Convex,
        2 => Shape::Crossed,
        _ => Shape::Concave,
    })
}

/// The squares of the sides AB, BC, CD, DA.
pub fn squared_sides<K: Kind>(vertices: &[Point<K>; 4]) -> [Number<K>; 4] {
    std::array::from_fn(|i| relation::distance_squared(&vertices[i], &vertices[(i + 1) % 4]))
}

/// The product of the eight sums s₁ ± s₂ ± s₃ ± s₄, from the squares of the sides:
/// (Σ s⁴ − 2 Σ s²t²)² − 64 (s₁s₂s₃s₄)².
pub fn product_of_sums<K: Kind>(squares: &[Number<K>; 4]) -> Number<K> {
    let sum: Number<K> = squares.iter().cloned().sum();
    let of_squares: Number<K> = squares.iter().map(Number::square).sum();
    let product: Number<K> = squares.iter().cloned().product();
    (2 * of_squares - sum.square()).square() - 64 * product
}

/// How U, the sum of the shortest and the longest side, compares with Z, the sum of the two others;
/// `None` where it cannot be told.
///
/// It is the sign of −[product of sums](product_of_sums): a side is shorter than the three others
/// together, so that of the eight sums those with at most one minus are positive and that with three
/// is negative; of those with two, s₁ the shortest side, one is ±(U − Z) with the longest side
/// positive, and the two others are negative, or zero together with it. Only where all vertices are on
/// one line can a side be as long as the others together; there the sides have rational ratios.
pub fn u_vs_z<K: Real>(vertices: &[Point<K>; 4]) -> Option<Ordering> {
    match product_of_sums(&squared_sides(vertices)).sign()? {
        Ordering::Equal => match relation::collinear(vertices) {
            Truth::Yes => u_vs_z_on_a_line(vertices),
            Truth::No => Some(Ordering::Equal),
            Truth::Unknown => None,
        },
        sign => Some(sign.reverse()),
    }
}

/// The sides as multiples of the length of one of them.
fn u_vs_z_on_a_line<K: Real>(vertices: &[Point<K>; 4]) -> Option<Ordering> {
    let sides: [Point<K>; 4] = std::array::from_fn(|i| &vertices[(i + 1) % 4] - &vertices[i]);
    let Some(unit) = sides.iter().find(|side| side.is_zero().is_no()) else {
        return Some(Ordering::Equal);
    };
    let mut lengths = Vec::new();
    for side in &sides {
        lengths.push((unit.conj() * side).re().abs());
    }
    let sum: Number<K> = lengths.iter().cloned().sum();
    let extreme = |wanted: Ordering| {
        let mut best = lengths.first()?;
        for length in lengths.iter().skip(1) {
            if length.compare(best)? == wanted {
                best = length;
            }
        }
        Some(best)
    };
    let u = extreme(Ordering::Less)? + extreme(Ordering::Greater)?;
    (2 * u).compare(&sum)
}

/// Where the shortest and the longest side lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Extremes {
    /// Next to each other.
    Adjacent,
    /// Opposite to each other.
    Opposite,
    /// Sides of equal length allow both.
    Both,
}

/// Where the shortest and the longest side lie; `None` where it cannot be told. Of four equal sides
/// every one is both.
pub fn extremes<K: Real>(squares: &[Number<K>; 4]) -> Option<Extremes> {
    let is = |i: usize, wanted: Ordering| -> Truth {
        Truth::all((0..4).filter(|j| *j != i).map(|j| {
            let order = squares[i].compare(&squares[j]);
            Truth::of_sign(order, |order| order == wanted || order.is_eq())
        }))
    };
    let at_distance = |distance: usize| {
        let places = (0..4).flat_map(|i| [(i, (i + distance) % 4), (i, (i + 4 - distance) % 4)]);
        Truth::any(places.map(|(i, j)| is(i, Ordering::Less) & is(j, Ordering::Greater)))
    };
    match (at_distance(1), at_distance(2)) {
        (Truth::Yes, Truth::Yes) => Some(Extremes::Both),
        (Truth::Yes, Truth::No) => Some(Extremes::Adjacent),
        (Truth::No, Truth::Yes) => Some(Extremes::Opposite),
        _ => None,
    }
}
