//! The tangents that go from a point of a cubic to its other points.
//!
//! On the line P + t d through a point P of the cubic its polynomial is t (F₁ + F₂ t + F₃ t²), with
//! forms Fⱼ of order j in the direction d. The line touches the cubic elsewhere, or goes through a
//! double point, where F₂² = 4 F₁ F₃.

use std::cmp::Ordering;

use super::Point;
use super::circular_cubic::Cubic;
use crate::number::{Kind, Number, Polynomial, Real, Truth, array};

/// The lines through a point of a cubic, with the directions a + p b, b itself for p = ∞.
#[derive(Clone, Debug)]
pub struct Pencil<K> {
    point: Point<K>,
    axes: [Point<K>; 2],
    /// F₁, F₂, F₃ as polynomials in p.
    forms: [Polynomial<K>; 3],
}

/// The four lines of a pencil that touch a cubic elsewhere or go through a double point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// Real tangents.
    pub real: usize,
    /// Imaginary tangents, in conjugate couples.
    pub imaginary: usize,
    /// Lines through a double point, each of which counts for two tangents.
    pub double: usize,
}

impl<K: Kind> Pencil<K> {
    /// The lines through a point of a cubic, by two directions a, b that are not parallel.
    pub fn new(cubic: &Cubic<K>, point: &Point<K>, axes: [Point<K>; 2]) -> Self {
        let [dx, dy] = [Point::re, Point::im].map(|part: fn(&Point<K>) -> &Number<K>| {
            Polynomial::new(vec![part(&axes[0]).clone(), part(&axes[1]).clone()])
        });
        let [a, b, c, d, e, f, g, ..] = cubic.coefficients();
        let (x, y) = (point.re(), point.im());
        let gradient = cubic.gradient(point);
        let first = dx.scaled(gradient.re()) + dy.scaled(gradient.im());
        // Half of the second derivative along (dx, dy).
        let second = (&dx * &dx).scaled(&(3 * a * x + b * y + e))
            + (&dx * &dy).scaled(&(2 * (b * x + c * y) + f))
            + (&dy * &dy).scaled(&(c * x + 3 * d * y + g));
        let third =
            (dx.scaled(a) + dy.scaled(b)) * &dx * &dx + (dx.scaled(c) + dy.scaled(d)) * &dy * &dy;
        Pencil {
            point: point.clone(),
            axes,
            forms: [first, second, third],
        }
    }

    /// F₂² − 4 F₁ F₃, of order 4 in p.
    pub fn discriminant(&self) -> Polynomial<K> {
        let [first, second, third] = &self.forms;
        second * second - (first * third).scaled(&Number::from(4))
    }

    /// F₁, F₂ and F₃ in the direction a + p b: the line meets the cubic where F₁ + F₂ t + F₃ t² = 0,
    /// t (a + p b) away from the point.
    pub fn along(&self, p: &Number<K>) -> [Number<K>; 3] {
        self.forms.each_ref().map(|form| form.evaluate(p))
    }

    /// Where a line for which the discriminant vanishes meets the cubic twice; no value where that is
    /// at infinity.
    pub fn contact(&self, p: &Number<K>) -> Point<K> {
        let [_, second, third] = self.along(p);
        let t = second / (-2 * third);
        &self.point + (&self.axes[0] + self.axes[1].scaled(p)).scaled(&t)
    }

    /// The double point, where the cubic has a single one and it does not lie in direction b; `None`
    /// where it has none, or that cannot be told.
    pub fn double_point(&self) -> Option<Point<K>> {
        let repeated = repeated_roots(&self.discriminant())?;
        let [constant, linear] = repeated.coefficients() else {
            return None;
        };
        Some(self.contact(&(-constant / linear)))
    }
}

impl<K: Real> Pencil<K> {
    /// How many of the four lines are real; `None` where that cannot be told, or where the cubic has
    /// a cusp or the point is a double one.
    pub fn count(&self) -> Option<Count> {
        if self.forms[0].is_zero() {
            return None;
        }
        let quartic = self.discriminant();
        let at_infinity = 4usize.checked_sub(quartic.degree()?)?;
        let repeated = repeated_roots(&quartic)?;
        let mut double = repeated.degree()?;
        if double > 0 && square_free(&repeated)?.is_no() {
            return None;
        }
        let mut real = count_real_roots(&quartic)? - count_real_roots(&repeated)?;
        match at_infinity {
            0 => {}
            1 => real += 1,
            2 => double += 1,
            _ => return None,
        }
        Some(Count {
            real,
            imaginary: 4usize.checked_sub(2 * double + real)?,
            double,
        })
    }
}

/// The roots of a polynomial that are multiple, each once less; `None` where that cannot be told.
fn repeated_roots<K: Kind>(polynomial: &Polynomial<K>) -> Option<Polynomial<K>> {
    let (mut a, mut b) = (polynomial.clone(), polynomial.derivative());
    while !b.is_zero() {
        let (_, rest) = a.divide(&b)?;
        (a, b) = (b, rest);
    }
    Some(a)
}

fn square_free<K: Kind>(polynomial: &Polynomial<K>) -> Option<Truth> {
    Some((repeated_roots(polynomial)?.degree()? == 0).into())
}

/// How many different real roots there are, by Sturm's sequence.
fn count_real_roots<K: Real>(polynomial: &Polynomial<K>) -> Option<usize> {
    let mut members = vec![polynomial.clone()];
    let mut next = polynomial.derivative();
    while !next.is_zero() {
        let (_, rest) = members.last()?.divide(&next)?;
        members.push(next);
        next = -rest;
    }
    let mut signs = Vec::new();
    for member in &members {
        signs.push((member.leading()?.sign()?, member.degree()? % 2 == 1));
    }
    let above = changes(signs.iter().map(|&(sign, _)| sign));
    let below = changes(
        signs
            .iter()
            .map(|&(sign, odd)| if odd { sign.reverse() } else { sign }),
    );
    below.checked_sub(above)
}

/// How often neighbours differ.
fn changes(signs: impl Iterator<Item = Ordering>) -> usize {
    let signs: Vec<Ordering> = signs.collect();
    array::neighbours(&signs)
        .filter(|(one, next)| one != next)
        .count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Exact;

    /// x³ + a x² + b x − y² with the lines through (x, 0).
    fn pencil(a: i64, b: i64, x: i64) -> Pencil<Exact> {
        let coefficients = [1, 0, 0, 0, a, 0, -1, b, 0, 0].map(Number::from);
        let point = Point::from(Number::<Exact>::from(x));
        Pencil::new(
            &Cubic::new(coefficients),
            &point,
            [Number::one(), Number::i()],
        )
    }

    fn counted(a: i64, b: i64, x: i64) -> [usize; 3] {
        let count = pencil(a, b, x).count().unwrap();
        [count.real, count.imaginary, count.double]
    }

    #[test]
    fn two_branches_one_and_a_node() {
        // y² = x³ − x: (0, 0) lies on the closed branch, (1, 0) on the other.
        assert_eq!(counted(0, -1, 0), [0, 4, 0]);
        assert_eq!(counted(0, -1, 1), [4, 0, 0]);
        // y² = x³ + x has one branch.
        assert_eq!(counted(0, 1, 0), [2, 2, 0]);
        // y² = x³ + x² has a loop, and y² = x³ − x² an isolated point.
        assert_eq!(counted(1, 0, -1), [0, 2, 1]);
        assert_eq!(counted(-1, 0, 1), [2, 0, 1]);
    }

    #[test]
    fn axes_do_not_matter() {
        let coefficients = [1, 0, 0, 0, 0, 0, -1, -1, 0, 0].map(Number::from);
        let curve = Cubic::<Exact>::new(coefficients);
        let axis = |x: i64, y: i64| Point::<Exact>::complex(Number::from(x), Number::from(y));
        for axes in [[axis(3, 1), axis(-1, 2)], [axis(0, 1), axis(1, 0)]] {
            let pencil = Pencil::new(&curve, &axis(1, 0), axes);
            assert_eq!(pencil.count().unwrap().real, 4);
        }
        // Along the axis of the curve as direction b the node is a root at infinity.
        let nodal = [1, 0, 0, 0, 1, 0, -1, 0, 0, 0].map(Number::from);
        let axes = [axis(0, 1), axis(1, 0)];
        let pencil = Pencil::new(&Cubic::<Exact>::new(nodal), &axis(-1, 0), axes);
        assert_eq!(pencil.count().unwrap().double, 1);
    }

    #[test]
    fn the_node_is_found_and_its_own_pencil_not_counted() {
        let node = pencil(1, 0, -1).double_point().unwrap();
        assert!(node.is_zero().is_yes());
        assert!(pencil(0, -1, 0).double_point().is_none());
        assert!(pencil(1, 0, 0).count().is_none());
        // A cusp.
        assert!(pencil(0, 0, 0).count().is_none());
    }
}
