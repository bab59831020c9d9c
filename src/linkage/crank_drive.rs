//! A double rocker driven by a crank: the focal mechanisms of a given four-bar whose link SF has its
//! pivot in a given point of the base.
//!
//! With ρ = MS : SN = m p : n q and E = (1 + ρ)(a² + ρ b²)/ρ the factor λ = a : m = b : n satisfies
//! d² λ² − (E + d² − c²) λ + E = 0. Its roots belong to two mechanisms, which exchange the lengths
//! of SF and TF.

use std::cmp::Ordering;

use super::four_bar::FourBar;
use crate::number::{Kind, Number, Real, Truth};

/// The squares of the sides of a four-bar, for what is rational in them.
#[derive(Clone, Debug)]
pub struct Squares<K> {
    /// MA²
    pub a: Number<K>,
    /// NB²
    pub b: Number<K>,
    /// AB²
    pub c: Number<K>,
    /// MN²
    pub d: Number<K>,
}

/// The squares of the bars at F.
#[derive(Clone, Debug)]
pub struct SquaredBars<K> {
    /// PF²
    pub p: Number<K>,
    /// QF²
    pub q: Number<K>,
    /// SF²
    pub r: Number<K>,
}

impl<K: Kind> Squares<K> {
    /// E, the part of the equation for λ in which only the arms and ρ occur.
    fn e(&self, rho: &Number<K>) -> Number<K> {
        (1 + rho) * (&self.a + rho * &self.b) / rho
    }

    /// The coefficients of λ², λ, 1.
    pub fn equation_of_lambda(&self, rho: &Number<K>) -> [Number<K>; 3] {
        let e = self.e(rho);
        [self.d.clone(), &self.c - &self.d - &e, e]
    }

    /// What follows from a root λ. By the arms, p q = m n (λ − 1); with m p = ρ n q this gives p²
    /// and q², and r = c m n/(m p + n q).
    pub fn bars(&self, rho: &Number<K>, lambda: &Number<K>) -> SquaredBars<K> {
        let (beyond, lambda_squared) = (lambda - 1, lambda.square());
        let q = &self.a * &beyond / (rho * &lambda_squared);
        SquaredBars {
            p: rho * &self.b * &beyond / &lambda_squared,
            r: &self.c * &self.a / ((1 + rho).square() * &q * lambda_squared),
            q,
        }
    }
}

/// A crank drive: all lengths positive where ρ > 0; for ρ < 0 the bar QF is laid off backwards.
#[derive(Clone, Debug)]
pub struct CrankDrive<K> {
    /// a : m = b : n
    pub lambda: Number<K>,
    /// MP
    pub m: Number<K>,
    /// NQ
    pub n: Number<K>,
    /// PF
    pub p: Number<K>,
    /// QF
    pub q: Number<K>,
    /// SF
    pub r: Number<K>,
    /// TF
    pub t: Number<K>,
}

/// The roots from which a drive is rational.
#[derive(Clone, Debug)]
pub struct Roots<K> {
    /// √|ρ|, not zero.
    pub rho: Number<K>,
    /// √|E − (d − c)²|
    pub first: Number<K>,
    /// √|E − (d + c)²|; its negative for the other mechanism.
    pub second: Number<K>,
    /// Whether ρ is negative.
    pub rho_is_negative: bool,
}

/// The mechanism to these roots.
pub fn drive<K: Kind>(four_bar: &FourBar<K>, roots: &Roots<K>) -> CrankDrive<K> {
    let FourBar { a, b, d, .. } = four_bar;
    let sign = if roots.rho_is_negative { -1 } else { 1 };
    // For ρ < 0 both radicands change sign, and with them the order of the roots.
    let (long, short) = if roots.rho_is_negative {
        (&roots.second, &roots.first)
    } else {
        (&roots.first, &roots.second)
    };
    let rho = roots.rho.square() * sign;
    let sum = long + short;
    let tau = &sum / (2 * d);
    let lambda = 1 + tau.square() * sign;
    let scale = &roots.rho / (2 * (1 + rho));
    CrankDrive {
        m: a / &lambda,
        n: b / &lambda,
        p: &roots.rho * b * &tau / &lambda,
        q: a * &tau * sign / (&roots.rho * &lambda),
        r: (long - short) * &scale,
        t: sum * scale,
        lambda,
    }
}

/// All crank drives of a four-bar with m p : n q = ρ: two, one where they coincide, or none; the one
/// with the shorter link SF first. `None` where a sign cannot be told or this arithmetic does not
/// hold a root; ρ = 0 and ρ = −1 (S in M or at infinity, Hart's mechanism) have no crank.
pub fn crank_drives<K: Real>(four_bar: &FourBar<K>, rho: &Number<K>) -> Option<Vec<CrankDrive<K>>> {
    let FourBar { a, b, c, d } = four_bar;
    let rho_is_negative = rho.sign()?.is_lt();
    if rho.is_zero().is_yes() || (rho + 1).is_zero().is_yes() {
        return Some(Vec::new());
    }
    let squares = Squares {
        a: a.square(),
        b: b.square(),
        c: c.square(),
        d: d.square(),
    };
    let e = squares.e(rho);
    let orient = |x: Number<K>| if rho_is_negative { -x } else { x };
    let first = orient(&e - (d - c).square());
    let second = orient(&e - (d + c).square());
    // The smaller of the two radicands decides whether there is a real mechanism.
    let least = if rho_is_negative { &first } else { &second };
    let single = match least.sign()? {
        Ordering::Less => return Some(Vec::new()),
        Ordering::Equal => true,
        Ordering::Greater => false,
    };
    let roots = Roots {
        rho: rho.abs().sqrt(),
        first: first.sqrt(),
        second: second.sqrt(),
        rho_is_negative,
    };
    let other = if rho_is_negative {
        Roots {
            first: -&roots.first,
            ..roots.clone()
        }
    } else {
        Roots {
            second: -&roots.second,
            ..roots.clone()
        }
    };
    let mut drives = vec![drive(four_bar, &roots)];
    if !single {
        drives.push(drive(four_bar, &other));
    }
    let mut finite = Vec::new();
    for drive in drives {
        match drive.lambda.is_zero() {
            Truth::Yes => {}
            Truth::No => finite.push(drive),
            Truth::Unknown => return None,
        }
    }
    let held = |drive: &CrankDrive<K>| drive.p.has_value() && drive.r.has_value();
    finite.iter().all(held).then_some(finite)
}

impl<K: Real> CrankDrive<K> {
    /// Whether SF turns fully when the coupler of the four-bar does. Seen from the coupler SFT is a
    /// triangle whose angle at F is the supplement of the angle between AB and MN; while that makes
    /// a full turn the line ST comes back without one, and of SF and TF the shorter one goes round.
    pub fn turns_with_coupler(&self) -> Truth {
        Truth::of_sign(self.r.abs().compare(&self.t.abs()), Ordering::is_lt)
    }

    /// MS and AT, directed along MN and AB, which S and T divide alike.
    pub fn divisions(&self, four_bar: &FourBar<K>) -> (Number<K>, Number<K>) {
        let share = &self.m * &self.p / (&self.m * &self.p + &self.n * &self.q);
        (&four_bar.d * &share, &four_bar.c * share)
    }

    /// How the link SF can move, for any four-bar.
    ///
    /// F runs on the circle about S. For the angle σ of SF with the base the triangle MPF has
    /// |MF|² = s² + r² + 2 s r cos σ = m² + p² − 2 m p cos ω, and NQF closes with the same ω. So SF turns
    /// fully exactly if |s + r| and |s − r| lie between |m − p| and |m + p|; where one of them is just
    /// such a limit, the mechanism passes through a change point.
    pub fn crank(&self, four_bar: &FourBar<K>) -> Option<Crank> {
        let (s, _) = self.divisions(four_bar);
        let (one, other) = ((&self.m - &self.p).square(), (&self.m + &self.p).square());
        let (low, high) = match one.compare(&other)? {
            Ordering::Greater => (other, one),
            _ => (one, other),
        };
        let mut crank = Crank::Turns;
        for reach in [(&s + &self.r).square(), (&s - &self.r).square()] {
            for room in [&reach - &low, &high - &reach] {
                match room.sign()? {
                    Ordering::Less => return Some(Crank::Rocks),
                    Ordering::Equal => crank = Crank::ChangePoint,
                    Ordering::Greater => {}
                }
            }
        }
        Some(crank)
    }
}

/// How the driving link can move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crank {
    /// It turns fully.
    Turns,
    /// It turns fully, but in one position the mechanism may pass into its other assembly.
    ChangePoint,
    /// It does not turn fully.
    Rocks,
}
