//! A design driven by its crank O_aA.

use std::cmp::Ordering;

use super::closed::Closed;
use crate::linkage::cognates::CouplerPoint;
use crate::linkage::four_bar::third_corners;
use crate::number::{Kind, Number, Real};
use crate::plane::{Point, relation};
use crate::straight_line::design::Design;

/// What the positions of a design depend on, with the direction of its line of length 1.
#[derive(Clone, Debug)]
pub struct Driven<K> {
    start: CouplerPoint<K>,
    direction: Point<K>,
    /// S² and T².
    squares: [Number<K>; 2],
    /// D's place on the coupler, (D − A)/(B − A).
    shape: Point<K>,
    /// Whether B is to the left of the line from A to O_b.
    is_left: bool,
}

/// A position.
#[derive(Clone, Debug)]
pub struct Position<K> {
    /// The crank pins.
    pub pins: [Point<K>; 2],
    /// The point of the coupler.
    pub point: Point<K>,
}

/// Rates in a unit of time in which none is infinite, not even in a dead centre.
#[derive(Clone, Debug)]
pub struct Rates<K> {
    /// Of the crank O_aA.
    pub crank: Number<K>,
    /// Of the crank O_bB.
    pub rocker: Number<K>,
    /// Of D's travel along the line.
    pub travel: Number<K>,
    /// Of D's deviation from the line.
    pub deviation: Number<K>,
}

impl<K: Real> Driven<K> {
    /// `None` where the design stands in a dead centre of O_aA, or where that cannot be told.
    pub fn new(design: &Design<K>) -> Option<Self> {
        let CouplerPoint {
            pivots: [_, o_b],
            pins: [a, b],
            point,
        } = &design.linkage;
        let is_left = match relation::twice_area(a, o_b, b).sign()? {
            Ordering::Greater => true,
            Ordering::Less => false,
            Ordering::Equal => return None,
        };
        let length = design.direction.norm().sqrt();
        Some(Driven {
            squares: [(a - b).norm(), (b - o_b).norm()],
            shape: (point - a) / (b - a),
            direction: design.direction.scaled(&length.inverse()),
            start: design.linkage.clone(),
            is_left,
        })
    }

    /// The same linkage from another of its positions on, with O_bB as the driver. `None` where this
    /// stands in a dead centre of O_bB, or where that cannot be told.
    pub fn exchanged(&self, from: &Position<K>) -> Option<Self> {
        let [o_a, o_b] = self.start.pivots.clone();
        let Position {
            pins: [a, b],
            point,
        } = from.clone();
        Driven::new(&Design {
            linkage: CouplerPoint {
                pivots: [o_b, o_a],
                pins: [b, a],
                point,
            },
            direction: self.direction.clone(),
        })
    }

    /// The position with the crank turned by e^{iφ}; `None` where it does not come there.
    pub fn position(&self, turn: &Point<K>) -> Option<Position<K>> {
        let CouplerPoint {
            pivots: [o_a, o_b],
            pins: [a, _],
            ..
        } = &self.start;
        let a = o_a + turn * (a - o_a);
        let [rod, rocker] = &self.squares;
        let [left, right] = third_corners(&a, o_b, rod, rocker)?;
        let b = if self.is_left { left } else { right };
        let point = &a + &self.shape * (&b - &a);
        Some(Position {
            pins: [a, b],
            point,
        })
    }

    /// D's travel u along the line and its deviation v.
    pub fn coordinates(&self, position: &Position<K>) -> [Number<K>; 2] {
        let place = (&position.point - &self.start.point) * self.direction.conj();
        [place.re().clone(), place.im().clone()]
    }

    /// With the coupler AB of constant length, ω_a (i(A − O_a))·(A − B) = ω_b (i(B − O_b))·(A − B).
    pub fn rates(&self, position: &Position<K>) -> Rates<K> {
        let [o_a, o_b] = &self.start.pivots;
        let [a, b] = &position.pins;
        let rod = a - b;
        let [around_a, around_b] = [a - o_a, b - o_b].map(|arm| Number::i() * arm);
        let dot = |u: &Point<K>| (u * rod.conj()).re().clone();
        let (crank, rocker) = (dot(&around_b), dot(&around_a));
        let [of_a, of_b] = [around_a.scaled(&crank), around_b.scaled(&rocker)];
        let turn = ((&of_a - of_b) * rod.conj()).im() / &self.squares[0];
        let of_d = of_a + Number::i() * (&position.point - a).scaled(&turn);
        let along = of_d * self.direction.conj();
        Rates {
            crank,
            rocker,
            travel: along.re().clone(),
            deviation: along.im().clone(),
        }
    }

    /// The closed form of u and v.
    pub fn closed(&self) -> Closed<K> {
        let CouplerPoint {
            pivots: [o_a, o_b],
            pins: [a, _],
            point,
        } = &self.start;
        let along = self.direction.conj();
        let (base, arm) = (o_b - o_a, a - o_a);
        let [rod, rocker] = &self.squares;
        let [sum, product] = [rod + rocker, 2 * (rod * rocker).sqrt()];
        Closed {
            start: (o_a - point) * &along,
            crank: &arm * &along,
            base: &self.shape * &base * &along,
            arm: &self.shape * &arm * &along,
            middle: base.norm() + arm.norm(),
            swing: 2 * base.conj() * arm,
            difference: rod - rocker,
            dead: [&sum - &product, sum + product],
            is_left: self.is_left,
        }
    }

    /// Sixteen times the square of the area of ABO_b: zero in a dead centre, negative where the
    /// crank does not come.
    pub fn room(&self, turn: &Point<K>) -> Number<K> {
        let CouplerPoint {
            pivots: [o_a, o_b],
            pins: [a, _],
            ..
        } = &self.start;
        let [rod, rocker] = &self.squares;
        let base = (o_a + turn * (a - o_a) - o_b).norm();
        4 * rod * &base - (rod - rocker + base).square()
    }
}

impl<K: Kind> Driven<K> {
    /// O_a and O_b.
    pub fn pivots(&self) -> &[Point<K>; 2] {
        &self.start.pivots
    }

    /// The direction of the line, of length 1.
    pub fn direction(&self) -> &Point<K> {
        &self.direction
    }

    /// The same in another kind.
    pub fn map<L: Kind>(&self, convert: impl Fn(&Number<K>) -> Number<L>) -> Driven<L> {
        let point = |z: &Point<K>| Number::complex(convert(z.re()), convert(z.im()));
        Driven {
            start: CouplerPoint {
                pivots: self.start.pivots.each_ref().map(point),
                pins: self.start.pins.each_ref().map(point),
                point: point(&self.start.point),
            },
            direction: point(&self.direction),
            squares: self.squares.each_ref().map(&convert),
            shape: point(&self.shape),
            is_left: self.is_left,
        }
    }
}
