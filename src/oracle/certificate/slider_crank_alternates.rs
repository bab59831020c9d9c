//! Whether an answer is the two other Burmester points of a slider-crank: by what keeps a distance up to
//! the fourth order.
//!
//! The coupler goes by a(θ) + e^{iθ}z with a = iθ²/2 + (a₃ + ib₃)θ³/6 + (a₄ + ib₄)θ⁴/24 + …. On the ray of
//! direction (c, s) the point at 1/ρ keeps its distance from that at 1/σ if
//!
//! - ρ − σ = 1/s;
//! - ρ = u/s + v/c, the cubic of stationary curvature, where u = 1/M = 1 + a₃/3 and v = 1/N = b₃/3;
//! - s(−1 + 4σJ + 3ρσ − 6σs) = a₄c + b₄s for J = b₃c − a₃s.
//!
//! That A and D do so gives all four numbers by linear equations. Then B and C are where a form of
//! degree four in (c, s) vanishes beside the rays of A and D, which are divided out of it. All is taken
//! k times, the numbers of the fourth order k² times, so that k may be 0.

use std::cmp::Ordering;

use rug::Rational;
use serde_json::Value;

use super::rest::Rest;
use super::shown::{self, Shown, bits, decided, digits};
use super::{Defect, require};
use crate::number::univariate::{Polynomial, Quadratic};
use crate::number::{Ball, Elementary, Number, Real, Surd, Truth};
use crate::oracle::ProblemError;
use crate::oracle::input::{self, Fields};
use crate::plane;

/// Cosine and sine of a ray.
type Ray<K> = [Number<K>; 2];
/// What is divided, and by what.
type Quotient<K> = [Number<K>; 2];

/// The problem.
pub struct Given {
    k: Rational,
    alpha_a: input::Angle,
    alpha_d: input::Angle,
}

impl Given {
    /// Reads it.
    pub fn read(fields: &Fields<'_>) -> Result<Self, ProblemError> {
        Ok(Given {
            k: fields.number("k")?,
            alpha_a: fields.angle("alpha_a")?,
            alpha_d: fields.angle("alpha_d")?,
        })
    }

    fn rounded(&self, bits: u32) -> SliderCrank<Ball> {
        SliderCrank {
            k: Number::rounded(&self.k, &bits),
            a: ray(&self.alpha_a.rounded(&bits)),
            d: ray(&self.alpha_d.rounded(&bits)),
        }
    }

    fn exact(&self) -> Option<SliderCrank<Surd>> {
        Some(SliderCrank {
            k: self.k.clone().into(),
            a: ray(&self.alpha_a.exact()?),
            d: ray(&self.alpha_d.exact()?),
        })
    }
}

fn ray<K: Real>(angle: &plane::Angle<K>) -> Ray<K> {
    [angle.cos(), angle.sin()]
}

struct SliderCrank<K> {
    k: Number<K>,
    a: Ray<K>,
    d: Ray<K>,
}

/// Checks everything.
#[expect(clippy::indexing_slicing, reason = "the same names in both kinds")]
pub fn check(given: &Given, answer: &Value) -> Result<(), Defect> {
    let digits = digits(answer)?;
    let bits = bits(answer)?;
    let own = given.rounded(bits);
    let exact = given.exact();
    let mut rest = Rest::default();
    let named = own.named();
    let exactly = exact.as_ref().map(SliderCrank::named);
    for (place, (name, quotient)) in named.iter().enumerate() {
        let exact = exactly.as_ref().map(|list| &list[place].1);
        rest.after(number(answer, name, quotient, exact, digits))?;
    }
    rest.after(alternates(&own, exact.as_ref(), answer, digits))?;
    rest.finish()
}

/// Whether a number of the answer is a quotient, which may be infinite.
fn number(
    answer: &Value,
    name: &str,
    [numerator, denominator]: &Quotient<Ball>,
    exact: Option<&Quotient<Surd>>,
    digits: u32,
) -> Result<(), Defect> {
    let shown = decided(answer, &answer[name], name)?;
    let is_zero = |ball: &Number<Ball>, exact: Option<&Number<Surd>>| match ball.is_zero() {
        Truth::Unknown => exact.map_or(Truth::Unknown, Number::is_zero),
        known => known,
    };
    let is_infinite = is_zero(denominator, exact.map(|[_, denominator]| denominator));
    let vanishes = is_zero(numerator, exact.map(|[numerator, _]| numerator));
    match (shown["infinite"] == true, is_infinite, vanishes) {
        (_, Truth::Unknown, _) => Err(Defect::unchecked(format!("whether {name} is infinite"))),
        (_, Truth::Yes, Truth::Yes) => is_undetermined(shown, name),
        (_, Truth::Yes, Truth::Unknown) => Err(Defect::unchecked(format!(
            "whether {name} is infinite or not determined"
        ))),
        (true, Truth::No, _) => Err(Defect::wrong(name, "it is finite")),
        (false, Truth::Yes, _) => Err(Defect::wrong(name, "it is infinite")),
        (true, Truth::Yes, _) => Ok(()),
        (false, Truth::No, _) => shown::holds(shown, name, &(numerator / denominator), digits),
    }
}

fn is_undetermined(shown: &Value, name: &str) -> Result<(), Defect> {
    let said = shown["undetermined"] == true;
    require(said, name, "it is not determined")
}

impl<K: Real> SliderCrank<K> {
    /// sin (α_d − α_a), not zero for pins on different rays.
    fn turn(&self) -> Number<K> {
        let [[ca, sa], [cd, sd]] = [&self.a, &self.d];
        ca * sd - sa * cd
    }

    /// k sin (α_d − α_a) times 1/M, 1/N, from the cubic of stationary curvature through A and D.
    fn cubic(&self) -> [Number<K>; 2] {
        let [[ca, sa], [cd, sd]] = [&self.a, &self.d];
        [(&self.k + 1) * ca * sd - &self.k * cd * sa, -(ca * cd)]
    }

    /// What does not belong to B and C. The moving polode has the curvature 3/M − 1, and its circle of
    /// inflections the diameter 1.
    fn named(&self) -> [(&'static str, Quotient<K>); 6] {
        let ([_, sa], [_, sd]) = (&self.a, &self.d);
        let pivot = &self.k * sa;
        let unit = &self.k * self.turn();
        let [u, v] = self.cubic();
        [
            ("PD", [sd.clone(), Number::one()]),
            ("PO_a", [pivot.clone(), Number::one()]),
            ("PA", [pivot, &self.k + 1]),
            ("N", [unit.clone(), v]),
            ("R", [unit.clone(), 3 * &u - &unit]),
            ("M", [unit, u]),
        ]
    }

    /// Whether pin and pivot of the crank are both in the pole.
    fn is_without_crank(&self) -> bool {
        let [_, sa] = &self.a;
        sa.is_zero().is_yes()
    }

    /// `None` for pins on one ray, and for a crank along the pole tangent.
    fn motion(&self) -> Option<Motion<K>> {
        let [[ca, sa], [cd, sd]] = [&self.a, &self.d];
        let turn = self.turn();
        if !(turn.is_zero().is_no() && sa.is_zero().is_no()) {
            return None;
        }
        let k = &self.k;
        let [u, v] = self.cubic().map(|part| part / &turn);
        // Exactly so, where the cubic is the inflection circle and the pole normal.
        let u = if ca.is_zero().is_yes() { k.clone() } else { u };
        let (a3, b3) = (3 * (&u - k), 3 * &v);
        let (sigma, rho) = (sa.inverse(), (k + 1) / sa);
        let j = &b3 * ca - &a3 * sa;
        let bent = 4 * &sigma * j + 3 * rho * &sigma - 6 * k * &sigma * sa;
        let at_a = sa * (bent - k.square());
        let at_d = -(sd * k.square());
        Some(Motion {
            k: k.clone(),
            a4: (&at_a * sd - &at_d * sa) / &turn,
            b4: (ca * at_d - cd * at_a) / &turn,
            u,
            v,
            a3,
            b3,
        })
    }
}

/// A motion up to the fourth order.
struct Motion<K> {
    k: Number<K>,
    u: Number<K>,
    v: Number<K>,
    a3: Number<K>,
    b3: Number<K>,
    a4: Number<K>,
    b4: Number<K>,
}

impl<K: Real> Motion<K> {
    /// The form whose zeros are the rays of the four Burmester points, by the powers of t = s/c.
    fn form(&self) -> [Number<K>; 5] {
        let linear = |c: &Number<K>, s: &Number<K>| Polynomial::new(vec![c.clone(), s.clone()]);
        let t = Polynomial::variable();
        let k = &self.k;
        let l = linear(&self.a3, &self.b3);
        let j = linear(&self.b3, &-&self.a3);
        let fourth = linear(&self.a4, &self.b4);
        let circle = Polynomial::new(vec![Number::one(), Number::zero(), Number::one()]);
        let sum = &l + &Polynomial::constant(3 * k);
        let form = &(&(&l * &sum) * &circle) - &(&t * &fourth).scaled(&3.into());
        let form = &form + &(&(&t * &l) * &j).scaled(&4.into());
        let square = &t * &t;
        let form = &form - &(&square * &l).scaled(&(6 * k));
        let form = &form - &square.scaled(&(3 * k.square()));
        std::array::from_fn(|power| form.coefficient(power))
    }

    /// From the pole to the point and to the center on a ray that is neither tangent nor normal.
    fn pair(&self, [c, s]: &Ray<K>) -> [Quotient<K>; 2] {
        let numerator = &self.k * c * s;
        let point = &self.u * c + &self.v * s;
        let center = &point - &self.k * c;
        [[numerator.clone(), point], [numerator, center]]
    }

    /// The pair on the pole normal beside one whose center is at k/σ: their σ have a sum.
    fn pair_on_normal(&self, sigma: &Number<K>) -> [Quotient<K>; 2] {
        let other = &self.k + 4 * &self.a3 / 3 - sigma;
        let point = &other + &self.k;
        [[self.k.clone(), point], [self.k.clone(), other]]
    }

    /// The fourth point gone into the pole, for a₃ = 0: |iθ²/2 + (a₄ + ib₄)θ⁴/24 − X|² has no term in θ⁴
    /// for the X = 3/a₄ of the pole tangent.
    fn pair_in_pole(&self) -> [Quotient<K>; 2] {
        let point = [Number::zero(), Number::one()];
        [point, [3 * self.k.square(), self.a4.clone()]]
    }
}

/// The form without the zero (c, s): from both ends, so that zeros on the tangent and on the normal stay
/// exact.
fn without<K: Real>(form: &[Number<K>], [c, s]: &Ray<K>) -> Vec<Number<K>> {
    let count = form.len().saturating_sub(1);
    let from_below = match (c.is_zero(), s.is_zero()) {
        (Truth::Yes, _) => count,
        (_, Truth::Yes) => 0,
        _ => count.div_ceil(2),
    };
    let mut below: Vec<Number<K>> = Vec::new();
    for coefficient in form.iter().take(from_below) {
        let carried = below.last().map_or_else(Number::zero, |last| c * last);
        below.push((coefficient + carried) / s);
    }
    let mut above: Vec<Number<K>> = Vec::new();
    for coefficient in form.iter().rev().take(count - from_below) {
        let carried = above.last().map_or_else(Number::zero, |last| s * last);
        above.push((carried - coefficient) / c);
    }
    below.extend(above.into_iter().rev());
    below
}

/// Whether the rays and the distances on them are those of B and C.
fn alternates(
    own: &SliderCrank<Ball>,
    exact: Option<&SliderCrank<Surd>>,
    answer: &Value,
    digits: u32,
) -> Result<(), Defect> {
    if exact.is_some_and(SliderCrank::is_without_crank) {
        let names = ["alpha_b", "alpha_c", "PB", "PC", "PO_b", "PO_c"];
        let mut all = names.iter();
        return all.try_for_each(|name| is_undetermined(&answer[*name], name));
    }
    let unchecked = || Defect::unchecked("B and C of pins on one ray or on the pole tangent");
    let motion = own.motion().ok_or_else(unchecked)?;
    let quadratic = quadratic(own, &motion).ok_or_else(unchecked)?;
    let discriminant = quadratic.discriminant();
    match discriminant.sign() {
        Some(Ordering::Less) => complex(&quadratic, answer, digits),
        Some(Ordering::Greater) => {
            let found = Found {
                own,
                motion: &motion,
                exact: exact.and_then(exact_pairs),
            };
            found.are_shown(&quadratic, answer, digits)
        }
        _ => Err(Defect::unchecked("whether B and C are real and different")),
    }
}

/// The rays of B and C, by t = s/c.
fn quadratic<K: Real>(own: &SliderCrank<K>, motion: &Motion<K>) -> Option<Quadratic<K>> {
    let rest = without(&without(&motion.form(), &own.a), &own.d);
    let [absolute, linear, square] = <[Number<K>; 3]>::try_from(rest).ok()?;
    Some(Quadratic::new(square, linear, absolute))
}

/// Both tangents, and no real distances.
fn complex(quadratic: &Quadratic<Ball>, answer: &Value, digits: u32) -> Result<(), Defect> {
    let twice = 2 * &quadratic.a;
    let re = -&quadratic.b / &twice;
    let im = (-quadratic.discriminant()).sqrt() / twice;
    let first = decided(answer, &answer["alpha_b"], "alpha_b")?;
    let is_first = Shown::read(&first["im"], "alpha_b")?.holds(&im);
    let im = if is_first { im } else { -im };
    for (name, im) in [("alpha_b", im.clone()), ("alpha_c", -im)] {
        let shown = decided(answer, &answer[name], name)?;
        shown::holds(&shown["re"], name, &re, digits)?;
        shown::holds(&shown["im"], name, &im, digits)?;
    }
    for name in ["PB", "PC", "PO_b", "PO_c"] {
        require(answer[name].is_null(), name, "it is not real")?;
    }
    Ok(())
}

/// Rays with the quotients of point and center.
type Pairs<K> = [(Ray<K>, [Quotient<K>; 2]); 2];

/// What tells B and C apart from what an answer claims them to be.
struct Found<'a> {
    own: &'a SliderCrank<Ball>,
    motion: &'a Motion<Ball>,
    exact: Option<Pairs<Surd>>,
}

impl Found<'_> {
    #[expect(
        clippy::indexing_slicing,
        reason = "the rays of B and C, with two distances each"
    )]
    fn are_shown(
        &self,
        quadratic: &Quadratic<Ball>,
        answer: &Value,
        digits: u32,
    ) -> Result<(), Defect> {
        let unchecked = || Defect::unchecked("the rays of B and C");
        let pairs = pairs(self.own, self.motion, quadratic).ok_or_else(unchecked)?;
        let mut rest = Rest::default();
        let names = [("alpha_b", "PB", "PO_b"), ("alpha_c", "PC", "PO_c")];
        for (place, (of_ray, of_point, of_center)) in names.into_iter().enumerate() {
            let (ray, [point, center]) = &pairs[place];
            rest.after(angle(answer, of_ray, ray, digits))?;
            let exact = self.exact.as_ref().map(|pairs| &pairs[place].1);
            let [exact_point, exact_center] = [0, 1].map(|part| exact.map(|both| &both[part]));
            rest.after(number(answer, of_point, point, exact_point, digits))?;
            rest.after(number(answer, of_center, center, exact_center, digits))?;
        }
        rest.finish()
    }
}

fn exact_pairs(exact: &SliderCrank<Surd>) -> Option<Pairs<Surd>> {
    let motion = exact.motion()?;
    let quadratic = quadratic(exact, &motion)?;
    let pairs = pairs(exact, &motion, &quadratic)?;
    let held = pairs
        .iter()
        .all(|([c, s], _)| c.has_value() && s.has_value());
    held.then_some(pairs)
}

/// B and C, the smaller tangent first, an infinite one last.
fn pairs<K: Real>(
    own: &SliderCrank<K>,
    motion: &Motion<K>,
    quadratic: &Quadratic<K>,
) -> Option<Pairs<K>> {
    let [(s, c), (other_s, other_c)] = quadratic.real_points()?;
    let mut rays = [upwards([c, s])?, upwards([other_c, other_s])?];
    let [[c, s], [other_c, other_s]] = &rays;
    let is_sorted = match (c.is_zero(), other_c.is_zero()) {
        (Truth::No, Truth::No) => (s / c).compare(&(other_s / other_c))?.is_le(),
        (known, _) => known.is_no(),
    };
    if !is_sorted {
        rays.reverse();
    }
    let [b, c] = rays;
    let of_ray = |ray: &Ray<K>| distances(own, motion, ray);
    let (of_b, of_c) = (of_ray(&b)?, of_ray(&c)?);
    Some([(b, of_b), (c, of_c)])
}

/// The direction of a ray in the upper half plane, of the tangent to the right.
fn upwards<K: Real>([c, s]: Ray<K>) -> Option<Ray<K>> {
    let sign = match s.sign()? {
        Ordering::Equal => c.sign()?,
        sign => sign,
    };
    let length = (c.square() + s.square()).sqrt();
    let length = if sign.is_lt() { -length } else { length };
    Some([c / &length, s / length])
}

/// From the pole to the point and the center of a ray.
fn distances<K: Real>(
    own: &SliderCrank<K>,
    motion: &Motion<K>,
    ray: &Ray<K>,
) -> Option<[Quotient<K>; 2]> {
    let [[ca, _], [cd, _]] = [&own.a, &own.d];
    match (ray[0].is_zero(), ray[1].is_zero()) {
        (Truth::No, Truth::No) => Some(motion.pair(ray)),
        (Truth::Yes, _) if cd.is_zero().is_yes() => Some(motion.pair_on_normal(&Number::zero())),
        (Truth::Yes, _) if ca.is_zero().is_yes() => Some(motion.pair_on_normal(&Number::one())),
        (_, Truth::Yes) if ca.is_zero().is_yes() => Some(motion.pair_in_pole()),
        _ => None,
    }
}

/// Whether a field is the angle of a ray in degrees.
fn angle(answer: &Value, name: &str, [c, s]: &Ray<Ball>, digits: u32) -> Result<(), Defect> {
    let shown = decided(answer, &answer[name], name)?;
    let bits = bits(answer)?;
    let degrees = if c.is_zero().is_yes() {
        Number::from(90)
    } else if s.is_zero().is_yes() {
        Number::zero()
    } else {
        let [c, s] = [c, s].map(|part| Number(part.0.with_precision(bits)));
        s.atan2(&c) * 180 / pi(bits)
    };
    shown::holds(&shown["degrees"], name, &degrees, digits)
}

fn pi(bits: u32) -> Number<Ball> {
    Number(<Ball as Elementary>::pi(&bits))
}
