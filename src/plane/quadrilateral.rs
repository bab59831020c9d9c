//! Quadrilaterals by their vertices in order, crossed ones included.

use std::cmp::Ordering;

use super::isotropic::Polynomial;
use super::{Point, relation};
use crate::number::{Kind, Number, Real, Truth, array};

/// How often the closed polygon goes round a point, counterclockwise; `None` where the point lies on
/// a side, or where this cannot be told.
pub fn winding_number<K: Real>(vertices: &[Point<K>], point: &Point<K>) -> Option<i64> {
    let next = vertices.iter().cycle().skip(1);
    let mut number = 0;
    for (from, to) in vertices.iter().zip(next) {
        number += turn_of_side(&(from - point), &(to - point))?;
    }
    Some(number)
}

/// What a side adds to the winding number about the origin: it counts where it crosses the ray to
/// the right.
fn turn_of_side<K: Real>(from: &Point<K>, to: &Point<K>) -> Option<i64> {
    let rises = (from.im().sign()?.is_le(), to.im().sign()?.is_le());
    match (
        rises,
        relation::twice_area(&Number::zero(), from, to).sign()?,
    ) {
        ((true, false), Ordering::Greater) => Some(1),
        ((false, true), Ordering::Less) => Some(-1),
        ((true, false) | (false, true), Ordering::Equal) => None,
        ((true, true), Ordering::Equal) => {
            // Through the origin, if it has an end on either side of it.
            let ends_apart = (from.conj() * to).re().sign()?.is_le();
            if ends_apart { None } else { Some(0) }
        }
        _ => Some(0),
    }
}

/// Whether a quadrilateral is convex, no three vertices on a line: it turns to the same side at all
/// four vertices.
pub fn is_convex<K: Real>(vertices: &[Point<K>; 4]) -> Truth {
    let turns = turns(vertices);
    let left = Truth::all(turns.iter().map(Number::is_positive));
    let right = Truth::all(turns.iter().map(|turn| (-turn).is_positive()));
    left | right
}

/// Twice the area of each three consecutive vertices, positive where they turn left.
fn turns<K: Kind>([a, b, c, d]: &[Point<K>; 4]) -> [Number<K>; 4] {
    [(a, b, c), (b, c, d), (c, d, a), (d, a, b)].map(|(p, q, r)| relation::twice_area(p, q, r))
}

/// The curve of the points from which the sides MA and BN of the quadrilateral M, A, B, N are seen
/// under directed angles AFM and NFB with a sum of 0 modulo π: (F − M)(F − B) : (F − A)(F − N) is
/// real.
pub fn focal_curve<K: Kind>([m, a, b, n]: &[Point<K>; 4]) -> Polynomial<K> {
    let diagonal = Polynomial::z_minus(m).times(&Polynomial::z_minus(b));
    let other = Polynomial::z_minus(a).times(&Polynomial::z_minus(n));
    let product = diagonal.times(&other.conj());
    product.minus(&product.conj())
}

/// How a quadrilateral lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
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
    for turn in turns(vertices) {
        match turn.sign()? {
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
    array::sides(vertices).map(|(from, to)| relation::distance_squared(from, to))
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
    let sides = array::sides(vertices).map(|(from, to)| to - from);
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
#[expect(
    clippy::indexing_slicing,
    reason = "the four sides are numbered 0 to 3"
)]
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
