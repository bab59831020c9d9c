//! Whether an answer lists all focal mechanisms of a four-bar and nothing else.
//!
//! What must be, from the positions in which the four-bar goes to infinity, in isotropic coordinates
//! f = x + iy, g = x − iy of F, which run apart there. With μ = m : a = n : b and MS = s = ρd/(1 + ρ):
//!
//! - both arms infinite, a e^{iα} − b e^{iβ} → d − c²/d: then g → s, and what is left of PF and QF is
//!   p²/s + q²/(d − s) = d − μ(d − c²/d);
//! - crank and coupler infinite: (s − d − r²/s + μb²/d)(μ − 1)d = q²;
//! - rocker and coupler infinite: (s + r²/(d − s) − μa²/d)(1 − μ)d = p².
//!
//! With m p = ρ n q this leaves q² = a²μ(1 − μ)/ρ, r² = σ(μ(b² + a²/ρ) − d²/(1 + ρ)) for σ = ρ/(1 + ρ), and
//! the quadratic Gμ² (1 + ρ) − (d² − c² + G (1 + ρ)) μ + d² = 0 for G = b² + a²/ρ. Seen from the coupler the
//! mechanism is one with 1 − μ, c, d in place of μ, d, c, which gives t.
//!
//! That this suffices is seen on the mechanism itself: in several positions, real or not, F is where
//! its powers for the circles about P, Q, S are zero, and must be on that about T too.

use std::cmp::Ordering;

use rug::Rational;
use serde_json::{Value, json};

use super::shown::{self, Shown, bits, decided, digits, list};
use super::{Defect, require};
use crate::number::univariate::{Quadratic, QuadraticRoots};
use crate::number::{Ball, Complex, Number, Surd};
use crate::oracle::ProblemError;
use crate::oracle::input::Fields;

type Entry = Number<Complex<Ball>>;
type Vector = [Entry; 2];
type Root = Number<Surd>;

/// Tangents of half the crank angle at which mechanisms are laid; two must serve.
const HALF_ANGLES: [[i64; 2]; 4] = [[1, 2], [-3, 5], [7, 3], [-4, 1]];

/// The problem.
pub struct Given {
    a: Root,
    b: Root,
    c: Root,
    d: Root,
    rho: Root,
}

impl Given {
    /// Reads it.
    pub fn read(fields: &Fields<'_>) -> Result<Self, ProblemError> {
        Ok(Given {
            a: fields.positive("a")?.into(),
            b: fields.positive("b")?.into(),
            c: fields.positive("c")?.into(),
            d: fields.positive("d")?.into(),
            rho: fields.number("rho")?.into(),
        })
    }

    /// σ = MS : MN = AT : AB.
    fn share(&self) -> Root {
        &self.rho / (1 + &self.rho)
    }

    /// b² + a²/ρ.
    fn arms(&self) -> Root {
        self.b.square() + self.a.square() / &self.rho
    }

    /// All μ of real mechanisms.
    fn scales(&self) -> Option<Vec<Root>> {
        let (from_arms, base) = (self.arms() * (1 + &self.rho), self.d.square());
        let linear = self.c.square() - &base - &from_arms;
        let roots = match Quadratic::new(from_arms, linear, base).roots() {
            QuadraticRoots::Real([one, other]) => vec![one, other],
            QuadraticRoots::Double(one) | QuadraticRoots::Single(one) => vec![one],
            QuadraticRoots::Conjugate(_) | QuadraticRoots::None => Vec::new(),
            QuadraticRoots::Undecided | QuadraticRoots::Every => return None,
        };
        let mut real = Vec::new();
        for scale in roots {
            // The sign of q² and with it of p².
            if (&scale * (1 - &scale) * &self.rho).sign()?.is_gt() {
                real.push(scale);
            }
        }
        Some(real)
    }
}

/// Squares of the lengths of one mechanism.
struct Squares {
    scale: Root,
    p: Root,
    q: Root,
    r: Root,
    t: Root,
}

impl Squares {
    fn of(given: &Given, scale: &Root) -> Self {
        let beyond = 1 - scale;
        let q = given.a.square() * scale * &beyond / &given.rho;
        let link = |scale: &Root, base: &Root| {
            let from_base = base.square() / (1 + &given.rho);
            given.share() * (scale * given.arms() - from_base)
        };
        Squares {
            p: given.rho.square() * given.b.square() / given.a.square() * &q,
            q,
            r: link(scale, &given.d),
            t: link(&beyond, &given.c),
            scale: scale.clone(),
        }
    }
}

/// Checks everything.
pub fn check(given: &Given, answer: &Value) -> Result<(), Defect> {
    let (digits, bits) = (digits(answer)?, bits(answer)?);
    let scales = given
        .scales()
        .ok_or_else(|| Defect::unchecked("how many mechanisms are real"))?;
    let mut own: Vec<Squares> = scales.iter().map(|one| Squares::of(given, one)).collect();
    own.sort_by(|one, other| one.r.compare(&other.r).unwrap_or(Ordering::Equal));
    let listed = list(answer, "mechanisms")?;
    let count = *decided(answer, &answer["count"], "count")? == json!(own.len());
    require(
        count && listed.len() == own.len(),
        "count",
        "there is another number of real mechanisms",
    )?;
    for (own, shown) in own.iter().zip(listed) {
        Mechanism::of(given, own, bits).is_shown(shown, answer, digits)?;
        let crank = decided(answer, &shown["crank"], "crank")?;
        let right = *crank == own.crank(given, bits)?;
        require(right, "crank", "SF moves in another way")?;
        keeps_its_lengths(given, shown, bits)?;
    }
    Ok(())
}

fn enclosed(root: &Root, bits: u32) -> Number<Ball> {
    root.0.enclosure(bits)
}

/// The length of a square that is known.
fn length(square: &Root, bits: u32) -> Number<Ball> {
    enclosed(square, bits).sqrt()
}

/// The numbers of a mechanism by their names.
struct Mechanism([(&'static str, Number<Ball>); 9]);

impl Mechanism {
    /// PF is directed like MP, and m p : n q is ρ.
    fn of(given: &Given, own: &Squares, bits: u32) -> Self {
        let in_ball = |root: Root| enclosed(&root, bits);
        let directed = |length: Number<Ball>, like: &Root| match like.sign() {
            Some(Ordering::Less) => -length,
            _ => length,
        };
        let across = &own.scale * &given.rho;
        Mechanism([
            ("lambda", in_ball(own.scale.inverse())),
            ("m", in_ball(&given.a * &own.scale)),
            ("n", in_ball(&given.b * &own.scale)),
            ("p", directed(length(&own.p, bits), &own.scale)),
            ("q", directed(length(&own.q, bits), &across)),
            ("MS", in_ball(&given.d * given.share())),
            ("AT", in_ball(&given.c * given.share())),
            ("r", length(&own.r, bits)),
            ("t", length(&own.t, bits)),
        ])
    }

    fn is_shown(&self, shown: &Value, answer: &Value, digits: u32) -> Result<(), Defect> {
        for (name, truth) in &self.0 {
            let value = decided(answer, &shown[name], name)?;
            shown::holds(value, name, truth, digits)?;
        }
        Ok(())
    }
}

impl Squares {
    /// How SF moves: the chain N, S, F, Q closes in all of its directions if NF, between |NS − SF| and
    /// NS + SF, stays between |NQ − QF| and NQ + QF; where it comes to an end of that room, Q may turn
    /// over.
    fn crank(&self, given: &Given, bits: u32) -> Result<&'static str, Defect> {
        let base = (&given.d * (1 - given.share())).square();
        let arm = (&given.b * &self.scale).square();
        let squares = [&base, &self.r, &self.q, &arm];
        let [base, link, bar, arm] = squares.map(|square| length(square, bits));
        let rooms = [
            &arm + &bar - &base - &link,
            (base - link).abs() - (arm - bar).abs(),
        ];
        let may_turn_over = product_of_sums(squares).is_zero().is_yes();
        let mut word = "turns";
        for room in rooms {
            match room.sign() {
                Some(Ordering::Greater) => {}
                Some(Ordering::Less) => return Ok("rocks"),
                _ if may_turn_over => word = "change-point",
                _ => return Err(Defect::unchecked("whether SF turns fully")),
            }
        }
        Ok(word)
    }
}

/// Of all u ± v ± x ± y, from their squares: zero where all four can lie on one line.
fn product_of_sums([u, v, x, y]: [&Root; 4]) -> Root {
    let k = u + v - x - y;
    let (uv, xy) = (u * v, x * y);
    let sum = k.square() + 4 * &uv - 4 * xy;
    sum.square() - 16 * k.square() * uv
}

/// Whether F keeps its distances from P, Q, S, T in several positions of the four-bar.
fn keeps_its_lengths(given: &Given, shown: &Value, bits: u32) -> Result<(), Defect> {
    let number = |name: &str| -> Result<Entry, Defect> {
        Ok(Shown::read(&shown[name], name)?.ball(bits).into())
    };
    let lengths = ["p", "q", "r", "t"].map(|name| Ok(number(name)?.square()));
    let [p, q, r, t] = lengths;
    let squares = [p?, q?, r?, t?];
    let scale = number("lambda")?.inverse();
    let mut served = 0;
    for [sine, cosine] in HALF_ANGLES {
        let half = Rational::from((sine, cosine));
        let joints = joints(given, &scale, &half, bits);
        let Some(f) = radical_center(&joints, &squares) else {
            continue;
        };
        for (joint, square) in joints.iter().zip(&squares) {
            let left = scalar(&apart(&f, joint), &apart(&f, joint)) - square;
            require(
                !left.is_zero().is_no(),
                "mechanisms",
                "F does not keep its distance from all four joints",
            )?;
        }
        served += 1;
    }
    if served < 2 {
        return Err(Defect::unchecked("positions in which F is determined"));
    }
    Ok(())
}

/// P, Q, S, T in the position of this half crank angle; B on one side of AN, in complex coordinates
/// where the circles do not meet.
fn joints(given: &Given, scale: &Entry, half: &Rational, bits: u32) -> [Vector; 4] {
    let side = |root: &Root| -> Entry { enclosed(root, bits).into() };
    let [a, b, c, d] = [&given.a, &given.b, &given.c, &given.d].map(side);
    let share = side(&given.share());
    let t: Entry = Number::<Ball>::rounded(half, &bits).into();
    let over = (1 + t.square()).inverse();
    let pin_a = [&a * (1 - t.square()) * &over, &a * 2 * t * over];
    let pivot = [d, Number::zero()];
    let to_a = apart(&pin_a, &pivot);
    let square = scalar(&to_a, &to_a);
    let foot = (b.square() + &square - c.square()) / 2;
    let height = root(&(b.square() * &square - foot.square()), bits);
    let [x, y] = &to_a;
    let arm = [
        (&foot * x - &height * y) / &square,
        (foot * y + height * x) / &square,
    ];
    let pin_b = plus(&pivot, &arm);
    [
        times(&pin_a, scale),
        plus(&pivot, &times(&arm, scale)),
        times(&pivot, &share),
        plus(&pin_a, &times(&apart(&pin_b, &pin_a), &share)),
    ]
}

/// The point whose powers for the circles about the first three joints are zero, if the joints are not
/// on a line.
fn radical_center([p, q, s, _]: &[Vector; 4], [pp, qq, rr, _]: &[Entry; 4]) -> Option<Vector> {
    let (u, v) = (apart(p, s), apart(q, s));
    let line = |u: &Vector, square: &Entry| (scalar(u, u) - square + rr) / 2;
    let (k, l) = (line(&u, pp), line(&v, qq));
    let area = &u[0] * &v[1] - &u[1] * &v[0];
    let from_s = [
        (&k * &v[1] - &l * &u[1]) / &area,
        (&l * &u[0] - &k * &v[0]) / &area,
    ];
    area.is_zero().is_no().then(|| plus(s, &from_s))
}

/// A root of a real number.
fn root(square: &Entry, bits: u32) -> Entry {
    let square = Number(square.re().0.with_precision(bits));
    match square.sign() {
        Some(Ordering::Less) => Number::complex(Number::zero(), (-square).sqrt()),
        _ => square.sqrt().into(),
    }
}

fn apart(a: &Vector, b: &Vector) -> Vector {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

fn plus(a: &Vector, b: &Vector) -> Vector {
    [&a[0] + &b[0], &a[1] + &b[1]]
}

fn times(a: &Vector, factor: &Entry) -> Vector {
    [&a[0] * factor, &a[1] * factor]
}

fn scalar(a: &Vector, b: &Vector) -> Entry {
    &a[0] * &b[0] + &a[1] * &b[1]
}
