//! Centerpoints from an angle: two circles over opposite sides of an opposite-pole quadrilateral.
//!
//! Where two opposite sides P₁₃P₁₄ and P₂₃P₂₄ are seen under directed angles that are equal modulo π, there
//! is a centerpoint. The points that see a side PQ under one angle lie on a circle through P and Q;
//! its center B is on the perpendicular bisector, and the angle α = QPB chooses it.

use crate::number::univariate::{Quadratic, QuadraticRoots};
use crate::number::{Kind, Number, Real, Truth};
use crate::plane::circle::Circle;
use crate::plane::displacement::Displacement;
use crate::plane::projective::{Line, ProjectivePoint};
use crate::plane::{Angle, Point};

/// Two opposite sides of an opposite-pole quadrilateral, [P₁₃, P₁₄] and [P₂₃, P₂₄].
#[derive(Clone, Debug)]
pub struct OppositeSides<K>(pub [[ProjectivePoint<K>; 2]; 2]);

/// The points that two circles share; for a line and a circle likewise.
#[derive(Clone, Debug)]
pub enum Meets<K> {
    /// Two real points.
    Two([Point<K>; 2]),
    /// One, in which they touch.
    Double(Point<K>),
    /// One, in which two lines cross.
    Single(Point<K>),
    /// None that is real and finite.
    None,
    /// Not finitely many, or it cannot be told.
    Undecided,
}

impl<K: Kind> OppositeSides<K> {
    /// The sides P₁₃P₁₄ and P₂₃P₂₄ of four positions; other orders of the positions give the others.
    pub fn of([first, second, third, fourth]: &[Displacement<K>; 4]) -> Self {
        let poles = |one: &Displacement<K>| [third, fourth].map(|other| one.projective_pole(other));
        OppositeSides([first, second].map(poles))
    }

    /// The circles about B₁ and B₂, the same angle α at the first pole of either side; for α = ±90° the
    /// lines of the sides.
    pub fn circles(&self, alpha: &Angle<K>) -> [Circle<K>; 2] {
        self.0
            .each_ref()
            .map(|[from, to]| circle_over(from, to, alpha.direction()))
    }
}

impl<K: Real> OppositeSides<K> {
    /// The centerpoints M and M' that an angle α gives.
    pub fn centerpoints(&self, alpha: &Angle<K>) -> Meets<K> {
        let [first, second] = self.circles(alpha);
        meets(&first, &second)
    }
}

/// Re e^{iα}(Q − z)(P − z)‾ = 0, with P = p/w. A pole at infinity makes it a line.
fn circle_over<K: Kind>(
    from: &ProjectivePoint<K>,
    to: &ProjectivePoint<K>,
    turn: &Point<K>,
) -> Circle<K> {
    let parts = |point: &ProjectivePoint<K>| {
        let [x, y, w] = point.coordinates();
        (Number::complex(x.clone(), y.clone()), w.clone())
    };
    let ((p, v), (q, w)) = (parts(from), parts(to));
    let (of_conj, of_z) = (turn * &q, turn * p.conj());
    Circle {
        a: turn.re() * &v * &w,
        b: -(of_conj.re() * &v + of_z.re() * &w),
        c: of_z.im() * &w - of_conj.im() * &v,
        d: (of_conj * p.conj()).re().clone(),
    }
}

fn meets<K: Real>(circle: &Circle<K>, other: &Circle<K>) -> Meets<K> {
    match (circle.is_line(), other.is_line()) {
        (Truth::No, _) => on_radical_line(circle, other),
        (_, Truth::No) => on_radical_line(other, circle),
        (Truth::Yes, Truth::Yes) => {
            let line = |c: &Circle<K>| Line::new(c.b.clone(), c.c.clone(), c.d.clone());
            let point = line(circle).meet(&line(other));
            match (point.finite(), point.is_at_infinity()) {
                (Some(point), _) => Meets::Single(point),
                (None, Truth::Yes) => Meets::None,
                _ => Meets::Undecided,
            }
        }
        _ => Meets::Undecided,
    }
}

/// Where a circle that is no line meets the line of equal powers.
fn on_radical_line<K: Real>(circle: &Circle<K>, other: &Circle<K>) -> Meets<K> {
    let line = circle.radical_line(other);
    let [a, b, c] = line.coefficients();
    let normal = Number::complex(a.clone(), b.clone());
    let square = normal.norm();
    match square.is_zero() {
        // Circles of one center.
        Truth::Yes if c.is_zero().is_no() => return Meets::None,
        Truth::No => {}
        _ => return Meets::Undecided,
    }
    let foot = normal.scaled(&(-c / &square));
    let along = Number::i() * normal;
    let middle = &circle.b * along.re() + &circle.c * along.im();
    let equation = Quadratic::new(&circle.a * square, middle, circle.at(&foot));
    let at = |t: &Number<K>| &foot + along.scaled(t);
    match equation.roots() {
        QuadraticRoots::Real(roots) => Meets::Two(roots.each_ref().map(at)),
        QuadraticRoots::Double(root) => Meets::Double(at(&root)),
        QuadraticRoots::Conjugate(_) => Meets::None,
        _ => Meets::Undecided,
    }
}
