//! Burmester's focal mechanism: a four-bar MABN and a point F joined to its four sides, all of which
//! keep their lengths while it moves.

use super::five_bar::{self, Chain, Lengths};
use crate::number::{Kind, Number, Truth};
use crate::plane::Point;

/// The arms MA = a and NB = b whose ends keep their distance while Hart's five-bar moves.
///
/// In the finished mechanism the triangles MPF and FQB are alike, and so are NQF and FPA; hence
/// QB = p q/m and PA = p q/n, laid off beyond Q and P.
pub fn arms<K: Kind>(lengths: &Lengths<K>) -> (Number<K>, Number<K>) {
    let Lengths { m, p, q, n } = lengths;
    (m + p * q / n, n + p * q / m)
}

/// Whether the distance AB is stationary in this configuration. Where it is so in every
/// configuration of the chain, for every base MN, the distance never changes.
pub fn keeps_coupler<K: Kind>(chain: &Chain<K>, a: &Number<K>, b: &Number<K>) -> Truth {
    chain.rate_of_distance_squared(a, b).is_zero()
}

/// A configuration by its joints alone, in which every length may stay a square root.
#[derive(Clone, Debug)]
pub struct Joints<K> {
    /// The four-bar M, A, B, N.
    pub corners: [Point<K>; 4],
    /// The joint on MA.
    pub p: Point<K>,
    /// The joint on NB.
    pub q: Point<K>,
    /// The fourfold joint.
    pub f: Point<K>,
    /// The joint on MN; no value at infinity.
    pub s: Point<K>,
    /// The joint on AB; no value at infinity.
    pub t: Point<K>,
    /// MS : SN = AT : TB = m p : n q, directed.
    pub rho: Number<K>,
}

/// The configuration with these joints M, P, F, Q, in which QN = ν · MP · PF · FQ; for ν < 0 the bar
/// NQ is laid off backwards. Every configuration with m p n q ≠ 0 is one of these.
pub fn joints<K: Kind>(
    m: &Point<K>,
    p: &Point<K>,
    f: &Point<K>,
    q: &Point<K>,
    nu: &Number<K>,
) -> Joints<K> {
    let (to_m, to_f, from_q) = (m - p, f - p, f - q);
    // ∠MPF + ∠FQN = π; the product of the directions has the length m p q.
    let to_n = -(&from_q * to_f.conj() * &to_m).scaled(nu);
    let n = q + &to_n;
    // p q/(m n), what the arms lay off beyond P and Q as a part of m and n.
    let beyond = (nu * to_m.norm()).inverse();
    let a = p - to_m.scaled(&beyond);
    let b = q - to_n.scaled(&beyond);
    // n q : m p
    let ratio = nu * from_q.norm();
    let s = m + (&n - m).scaled(&five_bar::share_of_center(&ratio));
    // Seen from AB the chain BQFPA is alike, and there A P · P F : B Q · Q F = m p : n q.
    let t = &b + (&a - &b).scaled(&five_bar::share_of_center(&ratio.inverse()));
    Joints {
        corners: [m.clone(), a, b, n],
        p: p.clone(),
        q: q.clone(),
        f: f.clone(),
        s,
        t,
        rho: ratio.inverse(),
    }
}

/// MP : MA = NQ : NB for the mechanism whose fourfold joint is the point F of the focal curve of the
/// four-bar M, A, B, N; no value where F is the one point for which P and Q are at infinity.
///
/// By the similar triangles MPF and FQB, NQF and FPA, (F − A)(F − B)‾ : (F − M)(F − N)‾ is
/// 1 − λ; on the curve it is real.
pub fn share_of_arms<K: Kind>([m, a, b, n]: &[Point<K>; 4], f: &Point<K>) -> Number<K> {
    let at_pivots = (f - m) * (f - n).conj();
    let at_coupler = (f - a) * (f - b).conj();
    (&at_pivots / (&at_pivots - at_coupler)).re().clone()
}
