//! A four-bar in its design position.

use super::no_design::NoDesign;
use crate::curvature::closure;
use crate::curvature::contact::{Contact, Guide};
use crate::curvature::motion::Motion;
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Kind, Number, Real, Series};
use crate::plane::{Point, relation};

/// A four-bar O_aABO_b of which the point D of the coupler goes nearly straight.
#[derive(Clone, Debug)]
pub struct Design<K> {
    /// O_a, O_b; A, B; D.
    pub linkage: CouplerPoint<K>,
    /// The direction of the straight line through D; its length does not matter.
    pub direction: Point<K>,
}

/// The path of D beside the line: along it and across it, in lengths of the direction.
#[derive(Clone, Debug)]
pub struct Deviation<K> {
    /// The travel.
    pub u: Number<Series<K>>,
    /// The deviation.
    pub v: Number<Series<K>>,
}

impl<K: Kind> Design<K> {
    /// The squares of Q = O_aO_b, R = O_aA, S = AB, T = O_bB, M = AD, N = BD (Tesar 1964, (6.5), (6.6)).
    pub fn squared_lengths(&self) -> [(&'static str, Number<K>); 6] {
        let CouplerPoint {
            pivots: [o_a, o_b],
            pins: [a, b],
            point: d,
        } = &self.linkage;
        [
            ("Q", o_a, o_b),
            ("R", o_a, a),
            ("S", a, b),
            ("T", o_b, b),
            ("M", a, d),
            ("N", b, d),
        ]
        .map(|(name, x, y)| (name, relation::distance_squared(x, y)))
    }

    /// Numbers with the angles of the linkage as arguments: ε from AB to AD; φ₀, ψ₀ and χ₀ from the
    /// base O_aO_b to O_aA, to O_bB and to AB.
    pub fn turns(&self) -> [(&'static str, Point<K>); 4] {
        let CouplerPoint {
            pivots: [o_a, o_b],
            pins: [a, b],
            point: d,
        } = &self.linkage;
        let (base, coupler) = (o_b - o_a, b - a);
        let from = |start: &Point<K>, end: Point<K>| end * start.conj();
        [
            ("epsilon", from(&coupler, d - a)),
            ("phi0", from(&base, a - o_a)),
            ("psi0", from(&base, b - o_b)),
            ("chi0", from(&base, coupler.clone())),
        ]
    }

    /// The motion of the coupler, from the closure alone. `None` in a change point.
    pub fn motion(&self, order: usize) -> Option<Motion<K>> {
        let [o_a, o_b] = &self.linkage.pivots;
        let [a, b] = &self.linkage.pins;
        let crank = |pin: &Point<K>, pivot: &Point<K>| Guide::Circle {
            point: pin.clone(),
            center: pivot.clone(),
        };
        closure::motion(&[crank(a, o_a), crank(b, o_b)], order)
    }

    /// The path of D beside its line.
    pub fn deviation(&self, order: usize) -> Option<Deviation<K>> {
        let motion = self.motion(order)?;
        let d = &self.linkage.point;
        let along = |normal: &Point<K>| {
            let guide = Guide::Line {
                point: d.clone(),
                normal: normal.clone(),
            };
            let kept = guide.along(&motion);
            &kept - Number::from(kept.coefficient(0))
        };
        Some(Deviation {
            u: along(&self.direction),
            v: along(&(Number::i() * &self.direction)),
        })
    }

    /// The order of contact of D's path with the line; `None` in a change point.
    pub fn contact(&self, order: usize) -> Option<Contact> {
        Some(Contact::of(&self.deviation(order)?.v))
    }

    /// The same in another kind.
    pub fn map<L: Kind>(&self, convert: impl Fn(&Number<K>) -> Number<L>) -> Design<L> {
        let point = |z: &Point<K>| Number::complex(convert(z.re()), convert(z.im()));
        Design {
            linkage: CouplerPoint {
                pivots: self.linkage.pivots.each_ref().map(point),
                pins: self.linkage.pins.each_ref().map(point),
                point: point(&self.linkage.point),
            },
            direction: point(&self.direction),
        }
    }

    /// The two other linkages with the same path of D.
    pub fn cognates(&self) -> [Design<K>; 2] {
        self.linkage.cognates().map(|linkage| Design {
            linkage,
            direction: self.direction.clone(),
        })
    }
}

impl<K: Real> Design<K> {
    /// The length to which a design is related: (Q + R + S + T + (M + N)/2)/5 (Tesar 1964, (6.27)).
    pub fn unit(&self) -> Number<K> {
        let [q, r, s, t, m, n] = self.squared_lengths().map(|(_, square)| square.sqrt());
        (q + r + s + t + (m + n) / 2) / 5
    }

    /// The design, if its bars have a length.
    pub fn checked(self) -> Result<Self, NoDesign> {
        let [q, r, s, t, ..] = self.squared_lengths();
        for ((_, square), reason) in [q, r, s, t].iter().zip([
            NoDesign::OnePivot,
            NoDesign::NoLength("A"),
            NoDesign::OneCrank,
            NoDesign::NoLength("B"),
        ]) {
            if square.is_zero().is_yes() {
                return Err(reason);
            }
        }
        Ok(self)
    }
}
