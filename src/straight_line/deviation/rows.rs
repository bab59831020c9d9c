//! The rows of a design at whole degrees of its crank, for [`stepped`](super::stepped).

use std::cmp::Ordering;

use rug::Rational;

use super::driven::{Driven, Position};
use super::stepped::{Met, Row, between_lines};
use crate::number::{Elementary, Number};
use crate::plane::Point;

/// A design whose crank is turned by whole degrees.
pub struct Rows<'a, K: Elementary> {
    driven: &'a Driven<K>,
    unit: &'a Number<K>,
    precision: K::Precision,
    /// R from the base, in degrees, between −90° and 90°.
    phi: Number<K>,
    /// T from the base, in degrees, between −180° and 180°.
    psi: Number<K>,
}

impl<'a, K: Elementary> Rows<'a, K> {
    /// Travel and deviation are told in this unit. `None` where an angle cannot be placed.
    pub fn new(
        driven: &'a Driven<K>,
        unit: &'a Number<K>,
        precision: &K::Precision,
    ) -> Option<Self> {
        let mut rows = Rows {
            driven,
            unit,
            precision: precision.clone(),
            phi: Number::zero(),
            psi: Number::zero(),
        };
        let start = driven.position(&Number::one())?;
        let [o_a, o_b] = driven.pivots();
        rows.phi = rows.line(&(&start.pins[0] - o_a))?;
        rows.psi = rows.angle(&(&start.pins[1] - o_b));
        Some(rows)
    }

    /// What is met with the crank turned by whole degrees; `None` where that cannot be decided.
    pub fn met(&self, degrees: i32) -> Option<Met<K>> {
        let (cos, sin) = K::cos_sin_of_degrees(&Rational::from(degrees), &self.precision)?;
        let turn = Number::complex(Number(cos), Number(sin));
        if self.driven.room(&turn).sign()? == Ordering::Less {
            return Some(Met::Open);
        }
        let position = self.driven.position(&turn)?;
        self.row(degrees, &position).map(Met::Row)
    }

    fn row(&self, degrees: i32, position: &Position<K>) -> Option<Row<K>> {
        let [u, v] = self.driven.coordinates(position).map(|x| x / self.unit);
        let o_b = &self.driven.pivots()[1];
        let [a, b] = &position.pins;
        let coupler = self.line(&(b - a))?;
        let rocker = self.angle(&(b - o_b));
        let psi = &rocker - &self.psi;
        let phi = &self.phi + i64::from(degrees);
        let gamma = [
            between_lines(&phi, &coupler)?,
            between_lines(&self.line(&(b - o_b))?, &coupler)?,
        ];
        Some(Row { u, v, psi, gamma })
    }

    /// The angle from the base to an arm in degrees, between −180° and 180°.
    fn angle(&self, arm: &Point<K>) -> Number<K> {
        let turned = self.seen(arm);
        turned.im().clone().atan2(turned.re()) * 180 / Number::pi(&self.precision)
    }

    /// The same for the arm's line, between −90° and 90°; `None` near these ends.
    fn line(&self, arm: &Point<K>) -> Option<Number<K>> {
        let turned = self.seen(arm);
        let is_upright = turned.re().sign().is_none_or(Ordering::is_eq);
        (!is_upright)
            .then(|| (turned.im() / turned.re()).atan() * 180 / Number::pi(&self.precision))
    }

    /// In the frame whose x-axis is the base.
    fn seen(&self, arm: &Point<K>) -> Point<K> {
        let [o_a, o_b] = self.driven.pivots();
        arm * (o_b - o_a).conj()
    }
}
