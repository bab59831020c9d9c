//! The closed form of travel and deviation: one root and one division a position.
//!
//! With e = e^{iφ}, n = |O_bA|² and c = S² − T² the corner B of the triangle A B O_b gives
//!
//! - n = m − Re(g e), m = Q² + R², g = 2 (O_b − O_a)‾ (A₀ − O_a),
//! - u + iv = k + a e + (b − d e) (n + c ± i √F)/(2n), F = (n − (S − T)²) ((S + T)² − n),
//!
//! where k, a, b, d are constants of the linkage, turned into the direction of the line. F is sixteen
//! times the square of the area of the triangle: zero in a dead centre.

use crate::number::{Kind, Number, Real};
use crate::plane::Point;

/// The constants of one linkage.
#[derive(Clone, Debug)]
pub struct Closed<K> {
    /// k
    pub start: Point<K>,
    /// a
    pub crank: Point<K>,
    /// b
    pub base: Point<K>,
    /// d
    pub arm: Point<K>,
    /// m
    pub middle: Number<K>,
    /// g
    pub swing: Point<K>,
    /// c
    pub difference: Number<K>,
    /// Squares of the distances |O_bA| in both dead centres, (S − T)² and (S + T)².
    pub dead: [Number<K>; 2],
    /// Whether B is to the left of the line from A to O_b.
    pub is_left: bool,
}

/// A position.
#[derive(Clone, Debug)]
pub struct Place<K> {
    /// The travel.
    pub u: Number<K>,
    /// The deviation.
    pub v: Number<K>,
    /// √F
    pub area: Number<K>,
}

/// √F times the derivatives with respect to the crank's angle in radians, so that they are finite in a
/// dead centre.
#[derive(Clone, Debug)]
pub struct Slopes<K> {
    /// Of the travel.
    pub u: Number<K>,
    /// Of the deviation.
    pub v: Number<K>,
}

impl<K: Kind> Closed<K> {
    /// n
    pub fn distance(&self, turn: &Point<K>) -> Number<K> {
        let [g, e] = [&self.swing, turn];
        &self.middle - (g.re() * e.re() - g.im() * e.im())
    }

    /// F from n.
    pub fn room(&self, distance: &Number<K>) -> Number<K> {
        (distance - &self.dead[0]) * (&self.dead[1] - distance)
    }

    /// The position with the crank turned by e, from n and √F there.
    pub fn place_with(&self, turn: &Point<K>, distance: &Number<K>, area: Number<K>) -> Place<K> {
        let half = (2 * distance).inverse();
        let along = (distance + &self.difference) * &half;
        let across = self.sided(&area * &half);
        let rod = &self.base - &self.arm * turn;
        let crank = &self.crank * turn;
        let u = self.start.re() + crank.re() + rod.re() * &along - rod.im() * &across;
        let v = self.start.im() + crank.im() + rod.re() * &across + rod.im() * &along;
        Place { u, v, area }
    }

    /// The slopes in the position with the crank turned by e, from n, F and √F there.
    pub fn slopes_with(
        &self,
        turn: &Point<K>,
        distance: &Number<K>,
        room: &Number<K>,
        area: &Number<K>,
    ) -> Slopes<K> {
        let [g, e] = [&self.swing, turn];
        let rate = g.re() * e.im() + g.im() * e.re();
        let half = (2 * distance).inverse();
        let along = (distance + &self.difference) * &half;
        let across = self.sided(area * &half);
        let relative = &rate * &half;
        // √F times the derivatives of the two.
        let along_rate = -(&self.difference * &relative * (2 * &half) * area);
        let [low, high] = &self.dead;
        let room_rate = (low + high) / 2 - distance - 2 * room * &half;
        let across_rate = self.sided(relative * room_rate);
        let moved = &self.arm * e;
        let rod = &self.base - &moved;
        // The derivative of e is i e.
        let crank = &self.crank * e;
        let own = Number::complex(
            -crank.im() + moved.im() * &along + moved.re() * &across,
            crank.re() - moved.re() * &along + moved.im() * &across,
        );
        let u = own.re() * area + rod.re() * &along_rate - rod.im() * &across_rate;
        let v = own.im() * area + rod.re() * across_rate + rod.im() * along_rate;
        Slopes { u, v }
    }

    fn sided(&self, across: Number<K>) -> Number<K> {
        if self.is_left { across } else { -across }
    }

    /// The same in another kind.
    pub fn map<L: Kind>(&self, convert: impl Fn(&Number<K>) -> Number<L>) -> Closed<L> {
        let point = |z: &Point<K>| Number::complex(convert(z.re()), convert(z.im()));
        Closed {
            start: point(&self.start),
            crank: point(&self.crank),
            base: point(&self.base),
            arm: point(&self.arm),
            middle: convert(&self.middle),
            swing: point(&self.swing),
            difference: convert(&self.difference),
            dead: self.dead.each_ref().map(&convert),
            is_left: self.is_left,
        }
    }
}

impl<K: Real> Closed<K> {
    /// The position with the crank turned by e; no value where it does not come there.
    pub fn place(&self, turn: &Point<K>) -> Place<K> {
        let distance = self.distance(turn);
        let area = self.room(&distance).sqrt();
        self.place_with(turn, &distance, area)
    }

    /// The slopes with the crank turned by e; no value where it does not come there.
    pub fn slopes(&self, turn: &Point<K>) -> Slopes<K> {
        let distance = self.distance(turn);
        let room = self.room(&distance);
        let area = room.clone().sqrt();
        self.slopes_with(turn, &distance, &room, &area)
    }
}
