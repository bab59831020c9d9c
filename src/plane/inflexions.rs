//! The real inflexions of a focal cubic, and its class.

use super::Point;
use super::curve_type::CurveType;
use super::focal_cubic::FocalCubic;
use super::projective::ProjectivePoint;
use crate::number::univariate::{Polynomial, isolate};
use crate::number::{Ball, Exact, Number};

impl CurveType {
    /// The class, the number of tangents from a point of general position, of an irreducible cubic:
    /// 6, less 2 for a node (Plücker).
    pub fn class(self) -> Option<usize> {
        match self {
            CurveType::OneBranch | CurveType::TwoBranches => Some(6),
            CurveType::Nodal => Some(4),
            _ => None,
        }
    }

    /// How many real inflexions an irreducible cubic has, at infinity included: 3 without a double
    /// point, 1 with a node of real tangents (Klein).
    pub fn real_inflexions(self) -> Option<usize> {
        match self {
            CurveType::OneBranch | CurveType::TwoBranches => Some(3),
            CurveType::Nodal => Some(1),
            _ => None,
        }
    }
}

type Poly = Polynomial<Exact>;

/// With z = φ + α(s + iv) the curve is A v² + I v + C = 0, A = as + β, C = s (A s + H), a polynomial in v
/// with coefficients in s.
struct InFrame {
    a: Number<Exact>,
    beta: Number<Exact>,
    h: Number<Exact>,
    i: Number<Exact>,
}

/// The real inflexions of an irreducible focal cubic, to so many bits: where the determinant of the
/// second derivatives vanishes too. `None` for a curve with a double point, and where the arithmetic
/// fails.
pub fn real_inflexions(curve: &FocalCubic<Exact>, bits: u32) -> Option<Vec<ProjectivePoint<Ball>>> {
    let norm = curve.alpha.norm();
    let product = curve.nu.conj() * &curve.alpha;
    let frame = InFrame {
        h: product.re() / &norm,
        i: -product.im() / &norm,
        a: norm,
        beta: curve.beta.clone(),
    };
    if curve.discriminant().is_zero().is_yes() {
        return None;
    }
    let places = if frame.i.is_zero().is_yes() {
        frame.symmetric(bits)?
    } else {
        frame.general(bits)?
    };
    let ball = |x: &Number<Exact>| Some(Number::<Ball>::rounded(x.0.rational()?, &bits));
    let point = |z: &Point<Exact>| Some(Number::complex(ball(z.re())?, ball(z.im())?));
    let (focus, alpha) = (point(&curve.focus)?, point(&curve.alpha)?);
    let mut points: Vec<ProjectivePoint<Ball>> = places
        .into_iter()
        .map(|(s, v)| ProjectivePoint::from_finite(&(&focus + &alpha * Number::complex(s, v))))
        .collect();
    if frame.i.is_zero().is_yes() {
        // Symmetric about the line through the focus across the asymptote.
        points.push(ProjectivePoint::from_direction(&(Number::i() * alpha)));
    }
    Some(points)
}

impl InFrame {
    fn linear(&self, slope: i64) -> Poly {
        Poly::new(vec![self.beta.clone(), slope * &self.a])
    }

    /// C.
    fn constant(&self) -> Poly {
        let s = Poly::variable();
        &s * &(self.linear(1) * &s + Poly::constant(self.h.clone()))
    }

    /// The determinant of the second derivatives, an eighth of it, by powers of v.
    fn hessian(&self) -> [Poly; 4] {
        let InFrame { a, beta, h, i } = self;
        let number = |x: Number<Exact>| Poly::constant(x);
        let (p, q) = (self.linear(3), self.linear(1));
        let m = Poly::new(vec![h.clone(), beta.clone()]);
        let hs = Poly::new(vec![Number::zero(), h.clone()]);
        [
            &p * &(&q * &hs - number(i.square())) - &q * &(&m * &m),
            p.scaled(i) * (&q - &number(2 * beta)) + m.scaled(&(2 * a * i)),
            m.scaled(&(2 * a * beta)) - p.scaled(&beta.square()) - hs.scaled(&a.square()),
            number(-(a.square() * i)),
        ]
    }

    /// Modulo the curve A² times the determinant is P v + Q; where it vanishes on the curve, v = −Q/P.
    fn general(&self, bits: u32) -> Option<Vec<(Number<Ball>, Number<Ball>)>> {
        let [h0, h1, h2, h3] = self.hessian();
        let (a, c) = (self.linear(1), self.constant());
        let i = Poly::constant(self.i.clone());
        let a2 = &a * &a;
        // A v² = −(I v + C), A² v³ = (I² − A C) v + I C.
        let p = &h3 * &(&i * &i - &a * &c) - &h2 * &(&a * &i) + &h1 * &a2;
        let q = &h3 * &(&i * &c) - &h2 * &(&a * &c) + &h0 * &a2;
        let mut both = &a * &(&q * &q) - &(&i * &p) * &q + &c * &(&p * &p);
        while let Some((quotient, rest)) = both.divide(&a) {
            if !rest.is_zero() || quotient.is_zero() {
                break;
            }
            both = quotient;
        }
        let roots = isolate(&both).ok()?;
        let ball = |x: &Number<Exact>| Number::<Ball>::rounded(&rational(x), &bits);
        let (p, q) = (p.map(ball), q.map(ball));
        let at = |s: Number<Ball>| {
            let v = -q.evaluate(&s) / p.evaluate(&s);
            (s, v)
        };
        Some(
            roots
                .real()
                .iter()
                .map(|root| at(root.enclosure(bits)))
                .collect(),
        )
    }

    /// For I = 0 determinant and curve are h₂v² + h₀ and A v² + C.
    fn symmetric(&self, bits: u32) -> Option<Vec<(Number<Ball>, Number<Ball>)>> {
        let [h0, _, h2, _] = self.hessian();
        let (a, c) = (self.linear(1), self.constant());
        let roots = isolate(&(&h2 * &c - &h0 * &a)).ok()?;
        let ball = |x: &Number<Exact>| Number::<Ball>::rounded(&rational(x), &bits);
        let (a, c) = (a.map(ball), c.map(ball));
        let mut places = Vec::new();
        for root in roots.real() {
            let s = root.enclosure(bits);
            let square = -c.evaluate(&s) / a.evaluate(&s);
            if square.is_positive().is_yes() {
                let v = square.sqrt();
                places.push((s.clone(), -&v));
                places.push((s, v));
            }
        }
        Some(places)
    }
}

fn rational(x: &Number<Exact>) -> rug::Rational {
    x.0.rational().cloned().unwrap_or_default()
}
