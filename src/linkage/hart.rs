//! Hart's straight-line mechanism: the focal mechanism whose point S is at infinity.
//!
//! S at infinity says mp + nq = 0, hence p = κn and q = −κm. In that case the squares of the circle's
//! equation mp|F − N|² + nq|F − M|² = mp(n² + q²) + nq(m² + p²) cancel, and it is the line
//! 2dx = d² + (m² + p²) − (n² + q²), at right angles to the base.

use super::five_bar::Lengths;
use super::focal_mechanism;
use crate::number::{Kind, Number, Real};

/// The mechanism by its free lengths MP = m, NQ = n, MN = d and the ratio κ = PF : NQ.
#[derive(Clone, Debug)]
pub struct Hart<K> {
    /// MP
    pub m: Number<K>,
    /// NQ
    pub n: Number<K>,
    /// MN
    pub d: Number<K>,
    /// PF : NQ
    pub kappa: Number<K>,
}

impl<K: Kind> Hart<K> {
    /// PF
    pub fn p(&self) -> Number<K> {
        &self.kappa * &self.n
    }

    /// QF, directed backwards for a positive κ.
    pub fn q(&self) -> Number<K> {
        -(&self.kappa * &self.m)
    }

    /// All four bars.
    pub fn lengths(&self) -> Lengths<K> {
        Lengths {
            m: self.m.clone(),
            p: self.p(),
            q: self.q(),
            n: self.n.clone(),
        }
    }

    /// MA and NB.
    pub fn arms(&self) -> (Number<K>, Number<K>) {
        focal_mechanism::arms(&self.lengths())
    }

    /// The abscissa of the straight line of F, with M in the origin and N on the x-axis.
    pub fn abscissa(&self) -> Number<K> {
        let from_m = self.m.square() + self.p().square();
        let from_n = self.n.square() + self.q().square();
        (self.d.square() + from_m - from_n) / (2 * &self.d)
    }
}

impl<K: Real> Hart<K> {
    /// AB = |κ| d.
    pub fn coupler(&self) -> Number<K> {
        self.kappa.abs() * &self.d
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linkage::five_bar;
    use crate::number::poly::Ring;
    use crate::plane::{Angle, Point, relation};

    /// In every position of every mechanism with mp + nq = 0: F is on the line, and AB = |κ| MN.
    #[test]
    fn line_and_coupler_are_identities() {
        let ring = Ring::free(&["m", "n", "k"]).unwrap();
        let ring = ring
            .with_angle("cos", "sin")
            .unwrap()
            .with_angle("c", "s")
            .unwrap();
        let [m, n, kappa, cos, sin, c, s] = ring.numbers();
        let lengths = Lengths {
            p: &kappa * &n,
            q: -(&kappa * &m),
            m,
            n,
        };
        let turn = Angle::from_cos_sin(cos, sin);
        let chain = five_bar::lay(&lengths, &turn, &Angle::from_cos_sin(c, s));
        let base = chain.n.norm();
        let (a, b) = focal_mechanism::arms(&lengths);
        let pin_b = &chain.n + chain.v.scaled(&b);
        let coupler = relation::distance_squared(&Point::from(a), &pin_b);
        assert!(coupler.equals(&(kappa.square() * &base)).is_yes());
        // x d = Re(F N̄); 2 d x of the line, from the squares of the sides alone.
        let twice = 2 * (&chain.f * chain.n.conj()).re();
        let from_m = lengths.m.square() + lengths.p.square();
        let from_n = lengths.n.square() + lengths.q.square();
        assert!(twice.equals(&(base + from_m - from_n)).is_yes());
    }
}
