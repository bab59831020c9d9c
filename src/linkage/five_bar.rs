//! The five-bar MPFQN with M, N fixed and Hart's condition ∠MPF = ω, ∠FQN = π − ω.

use crate::number::{Kind, Number, Real};
use crate::plane::{Angle, Point};

/// The four moving lengths, MP = m, PF = p, FQ = q, QN = n.
#[derive(Clone, Debug)]
pub struct Lengths<K> {
    /// MP
    pub m: Number<K>,
    /// PF
    pub p: Number<K>,
    /// FQ
    pub q: Number<K>,
    /// QN
    pub n: Number<K>,
}

/// A configuration of the chain, with M in the origin and P on the positive x-axis: the base MN is
/// where the chain ends.
#[derive(Clone, Debug)]
pub struct Chain<K> {
    /// End of the bar MP.
    pub p: Point<K>,
    /// The joint between PF and FQ.
    pub f: Point<K>,
    /// End of the bar NQ.
    pub q: Point<K>,
    /// The second fixed pivot.
    pub n: Point<K>,
    /// Unit vector from N to Q.
    pub v: Point<K>,
    /// e^{iω}
    pub w: Point<K>,
}

/// Lays the bars end to end: `turn` is the angle from the direction MP to the direction NQ.
///
/// PF is PM turned by ω, and QN is QF turned by π − ω, both counterclockwise.
pub fn lay<K: Real>(lengths: &Lengths<K>, turn: &Angle<K>, omega: &Angle<K>) -> Chain<K> {
    let (v, w) = (turn.cis(), omega.cis());
    let p: Point<K> = lengths.m.clone().into();
    let to_m: Point<K> = Number::from(-1);
    let f = &p + (to_m * &w).scaled(&lengths.p);
    let to_n = -&v;
    // QF·e^{i(π − ω)} has the direction of QN, hence QF = −QN·e^{iω} in direction.
    let q_to_f = -(&to_n * &w);
    let q = &f - q_to_f.scaled(&lengths.q);
    let n = &q + to_n.scaled(&lengths.n);
    Chain { p, f, q, n, v, w }
}

/// How a configuration changes with one of its two angles.
#[derive(Clone, Debug)]
struct Velocity<K> {
    n: Point<K>,
    v: Point<K>,
}

impl<K: Kind> Chain<K> {
    /// Velocities of N and of the direction NQ in the motion that keeps MN at its length, as seen
    /// from the bar MP, up to a common factor.
    fn motion(&self) -> Velocity<K> {
        let i = Number::i();
        let with_turn = Velocity {
            // Only the bars FQ and QN turn.
            n: &i * (&self.n - &self.f),
            v: &i * &self.v,
        };
        let with_omega = Velocity {
            // PF, FQ turn about P; QN keeps its direction.
            n: &i * (&self.q - &self.p),
            v: Number::zero(),
        };
        // d|N|² = 2 Re(N̄ dN) must vanish.
        let rate = |velocity: &Velocity<K>| (self.n.conj() * &velocity.n).re().clone();
        let (share_of_turn, share_of_omega) = (rate(&with_omega), -rate(&with_turn));
        Velocity {
            n: with_turn.n.scaled(&share_of_turn) + with_omega.n.scaled(&share_of_omega),
            v: with_turn.v.scaled(&share_of_turn) + with_omega.v.scaled(&share_of_omega),
        }
    }

    /// The rate of |AB|² in that motion, up to the common factor, for A on the line MP at distance
    /// a from M and B on the line NQ at distance b from N.
    pub fn rate_of_distance_squared(&self, a: &Number<K>, b: &Number<K>) -> Number<K> {
        let velocity = self.motion();
        let from_a = &self.n + self.v.scaled(b) - Point::from(a.clone());
        let rate = velocity.n + velocity.v.scaled(b);
        (from_a.conj() * rate).re().clone()
    }
}

/// Where the circle that F describes has its center: at this distance from M along MN.
///
/// It is the point of the base that is equally far from F for two values of ω; |MF| and |NF| follow
/// from the triangles MPF and NQF.
pub fn center_of_path<K: Real>(
    lengths: &Lengths<K>,
    d: &Number<K>,
    omega: &Angle<K>,
    other: &Angle<K>,
) -> Number<K> {
    let [first, second] = [omega, other].map(|omega| {
        let w = omega.cis();
        let from_m = (Point::from(lengths.m.clone()) - w.scaled(&lengths.p)).norm();
        let from_n = (Point::from(lengths.n.clone()) + w.scaled(&lengths.q)).norm();
        let x = (&from_m - from_n + d.square()) / (2 * d);
        (from_m, x)
    });
    (first.0 - second.0) / (2 * (first.1 - second.1))
}

/// MS : MN for the point S of the base that keeps its distance from F, where n q : m p is given.
///
/// By the triangles MPF and NQF, |MF|² and |NF|² change with cos ω by the factors −2 m p and 2 n q;
/// (1 − σ) |MF|² + σ |NF|² is |SF|² up to a constant, by Stewart's theorem.
pub fn share_of_center<K: Kind>(ratio: &Number<K>) -> Number<K> {
    (1 + ratio).inverse()
}

/// The square of the distance from F to the point of the base at distance s from M.
pub fn distance_squared_from_base_point<K: Real>(
    lengths: &Lengths<K>,
    d: &Number<K>,
    omega: &Angle<K>,
    s: &Number<K>,
) -> Number<K> {
    let w = omega.cis();
    let from_m = (Point::from(lengths.m.clone()) - w.scaled(&lengths.p)).norm();
    let from_n = (Point::from(lengths.n.clone()) + w.scaled(&lengths.q)).norm();
    let x = (&from_m - from_n + d.square()) / (2 * d);
    from_m - 2 * s * x + s.square()
}
