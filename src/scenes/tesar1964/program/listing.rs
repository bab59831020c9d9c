//! The program's own computations, statement by statement as far as they are about numbers.
//!
//! Numbers in parentheses are those of the listing.

use std::cmp::Ordering;

use crate::number::{Elementary, Number};
use crate::scenes::{Free, Unbuilt};
use crate::straight_line::deviation::stepped::{Met, Row, between_lines};

/// What lines 23 to 106 compute.
pub struct Listing<K: Elementary> {
    /// G, a degree in radians.
    pub degree: Number<K>,
    /// A(3) in radians.
    pub alpha_d: Number<K>,
    pub q: Number<K>,
    pub r: Number<K>,
    pub s: Number<K>,
    pub t: Number<K>,
    pub m: Number<K>,
    pub n: Number<K>,
    /// E, in degrees.
    pub epsilon: Number<K>,
    /// UN
    pub unit: Number<K>,
    /// PPHIR and SSIR: R and T from the fixed link, from 0 to 2π.
    pub phi: Number<K>,
    pub psi: Number<K>,
    /// GGA and GGB, in degrees.
    pub gamma: [Number<K>; 2],
    /// THR, the fixed link from the pole tangent.
    theta: Number<K>,
    /// U(1), V(1)
    pivot: [Number<K>; 2],
    /// UP1, VP1
    point: [Number<K>; 2],
    /// PHHI, the principal value of the angle of R.
    phi_line: Number<K>,
    /// CA
    sign: i64,
}

fn undecided() -> Unbuilt {
    Unbuilt::NotHeld("a comparison of the program".to_owned())
}

/// IF x LSS y.
fn is_less<K: Elementary>(x: &Number<K>, y: &Number<K>) -> Result<bool, Unbuilt> {
    Ok(x.compare(y).ok_or_else(undecided)? == Ordering::Less)
}

fn is_negative<K: Elementary>(x: &Number<K>) -> Result<bool, Unbuilt> {
    is_less(x, &Number::zero())
}

/// ARCTAN(y/x), with W added where x is negative (60, 61), and the principal value.
fn arctan<K: Elementary>(
    y: &Number<K>,
    x: &Number<K>,
    half_turn: &Number<K>,
) -> Result<[Number<K>; 2], Unbuilt> {
    let line = (y / x).atan();
    let angle = if is_negative(x)? {
        &line + half_turn
    } else {
        line.clone()
    };
    Ok([angle, line])
}

/// With 2W added where it is negative (62).
fn positive<K: Elementary>(angle: Number<K>, half_turn: &Number<K>) -> Result<Number<K>, Unbuilt> {
    Ok(if is_negative(&angle)? {
        angle + 2 * half_turn
    } else {
        angle
    })
}

impl<K: Elementary> Listing<K> {
    /// For α_a and α_b in degrees.
    pub fn run(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let degree = Number::pi(&free.precision()) / 180;
        let half_turn = 180 * &degree;
        let [a, b] = [free.number("alpha_a")?, free.number("alpha_b")?].map(|x| x * &degree);
        let (tan_a, tan_b) = (a.clone().tan(), b.clone().tan());
        let (vew, wev) = (&tan_a + &tan_b, &tan_a * &tan_b);
        let d = (-&vew / (&wev + 3)).atan();
        let d = if is_negative(&d)? { d + &half_turn } else { d };
        // Lines 35 to 50.
        let places = |angle: &Number<K>, tan: &Number<K>| {
            let (sin, cos) = (angle.clone().sin(), angle.clone().cos());
            let to_pin = &vew * (&wev - 1) * &sin / ((&wev + 3) * tan + &vew * &wev);
            let to_pivot = &to_pin * &sin / (&sin - &to_pin);
            let at = |distance: &Number<K>| [distance * &cos, distance * &sin];
            (at(&to_pivot), at(&to_pin), [to_pivot, to_pin])
        };
        let ([u_1, v_1], [up_1, vp_1], [po_a, pa]) = places(&a, &tan_a);
        let ([u_2, v_2], [up_2, vp_2], [po_b, pb]) = places(&b, &tan_b);
        let (sin_d, cos_d) = (d.clone().sin(), d.clone().cos());
        let point = [&cos_d * &sin_d, &sin_d * &sin_d];
        // Lines 51 to 80.
        let length = |x: &Number<K>, y: &Number<K>| (x * x + y * y).sqrt();
        let (uu, vv) = (&u_2 - &u_1, &v_2 - &v_1);
        let (q, s) = (length(&uu, &vv), length(&(&up_2 - &up_1), &(&vp_2 - &vp_1)));
        let (r, t) = ((&po_a - &pa).abs(), (&po_b - &pb).abs());
        let [theta, _] = arctan(&vv, &uu, &half_turn)?;
        let theta = positive(theta, &half_turn)?;
        let (sin, cos) = (theta.clone().sin(), theta.clone().cos());
        let in_frame = |x: Number<K>, y: Number<K>| [&x * &cos + &y * &sin, -&x * &sin + &y * &cos];
        let [xxp, yyp] = in_frame(&up_1 - &u_1, &vp_1 - &v_1);
        let [xpx, ypy] = in_frame(&up_2 - &u_2, &vp_2 - &v_2);
        let [phi, phi_line] = arctan(&yyp, &xxp, &half_turn)?;
        let [psi, psi_line] = arctan(&ypy, &xpx, &half_turn)?;
        let (phi, psi) = (positive(phi, &half_turn)?, positive(psi, &half_turn)?);
        let chi_line = ((&ypy - &yyp) / (&xpx + &q - &xxp)).atan();
        let gamma = |crank: &Number<K>| {
            between_lines(&(crank / &degree), &(&chi_line / &degree)).ok_or_else(undecided)
        };
        let gamma = [gamma(&phi_line)?, gamma(&psi_line)?];
        // Lines 83 to 89 and 106: the law of cosines.
        let from_d = |distance: &Number<K>, angle: &Number<K>| {
            let cos = (angle - &d).cos();
            let square = distance * distance + &sin_d * &sin_d - 2 * (distance * &sin_d) * cos;
            square.abs().sqrt()
        };
        let (n, m) = (from_d(&pb, &b), from_d(&pa, &a));
        let apart = (&s - (&m + &n)).abs();
        let is_between = is_less(&apart, &Number::ratio(1, 100_000))?;
        let epsilon = if !is_between && is_less(&m, &n)? {
            180
        } else {
            0
        };
        let unit = (&q + &r + &s + &t + (&m + &n) / 2) / 5;
        let mut listing = Listing {
            degree,
            alpha_d: d,
            q,
            r,
            s,
            t,
            m,
            n,
            epsilon: epsilon.into(),
            unit,
            phi,
            psi,
            gamma,
            theta,
            pivot: [u_1, v_1],
            point,
            phi_line,
            sign: 1,
        };
        listing.sign = listing.sign_of_root()?;
        Ok(listing)
    }

    fn half_turn(&self) -> Number<K> {
        180 * &self.degree
    }

    /// Lines 116 to 118: A, B, C of (6.21), and A² + B² − C².
    fn closure(&self, phi: &Number<K>) -> [Number<K>; 4] {
        let Listing { q, r, s, t, .. } = self;
        let cos = phi.clone().cos();
        let la = phi.clone().sin();
        let lb = &cos - q / r;
        let lc = (q * q + r * r + t * t - s * s) / (2 * r * t) - q / t * &cos;
        let square = &la * &la + &lb * &lb - &lc * &lc;
        [la, lb, lc, square]
    }

    /// Lines 93 to 103: whether the root of (6.23) is added or taken away.
    fn sign_of_root(&self) -> Result<i64, Unbuilt> {
        let [aa, bb, cc, square] = self.closure(&self.phi);
        let tan = (aa + square.sqrt()) / (bb + cc);
        let arctan = if is_negative(&tan)? {
            self.half_turn() + tan.atan()
        } else {
            tan.atan()
        };
        let difference = (&self.psi - 2 * arctan).abs();
        let is_near = is_less(&difference, &Number::ratio(1, 1000))?;
        Ok(if is_near { 1 } else { -1 })
    }

    /// Lines 114 to 158, with the crank turned by so many degrees.
    pub fn met(&self, degrees: &Number<K>) -> Option<Met<K>> {
        let half_turn = self.half_turn();
        let phi = &self.phi + &self.degree * degrees;
        let [la, lb, lc, square] = self.closure(&phi);
        if square.sign()? == Ordering::Less {
            return Some(Met::Open);
        }
        let rocker = 2 * ((la + self.sign * square.sqrt()) / (lb + lc)).atan();
        let turned = &rocker - &self.psi;
        let psi = match rocker.sign()? {
            Ordering::Greater => turned,
            _ => turned + 2 * &half_turn,
        };
        let (ax, ay) = (&self.r * phi.clone().cos(), &self.r * phi.sin());
        let (bx, by) = (
            &self.t * rocker.clone().cos() + &self.q,
            &self.t * rocker.clone().sin(),
        );
        let [coupler, chi_line] = arctan(&(by - &ay), &(bx - &ax), &half_turn).ok()?;
        let coupler = positive(coupler, &half_turn).ok()?;
        let arm = &self.epsilon * &self.degree + coupler;
        let x = ax + &self.m * arm.clone().cos();
        let y = ay + &self.m * arm.sin();
        let [u, v] = self.travel(&x, &y);
        let quarter = &half_turn / 2;
        let rocker_line = if rocker.compare(&quarter)? == Ordering::Greater {
            &rocker - &half_turn
        } else if rocker.compare(&-&quarter)? == Ordering::Less {
            &rocker + &half_turn
        } else {
            rocker
        };
        let chi = &chi_line / &self.degree;
        let crank = (&self.phi_line + degrees * &self.degree) / &self.degree;
        Some(Met::Row(Row {
            u,
            v,
            psi: psi / &self.degree,
            gamma: [
                between_lines(&crank, &chi)?,
                between_lines(&(rocker_line / &self.degree), &chi)?,
            ],
        }))
    }

    /// Lines 141 to 145: (6.2) and (6.4).
    fn travel(&self, x: &Number<K>, y: &Number<K>) -> [Number<K>; 2] {
        let (sin, cos) = (self.theta.clone().sin(), self.theta.clone().cos());
        let [u_1, v_1] = &self.pivot;
        let [up1, vp1] = &self.point;
        let us = x * &cos - y * &sin + u_1;
        let vs = x * &sin + y * &cos + v_1;
        let (sin, cos) = (self.alpha_d.clone().sin(), self.alpha_d.clone().cos());
        let su = ((up1 - &us) * &sin + (&vs - vp1) * &cos) / &self.unit;
        let sv = (up1 - us) * cos - (vs - vp1) * sin;
        [su, sv / &self.unit]
    }
}
