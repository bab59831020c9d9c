//! Whether an answer is Hart's straight-line mechanism: by the lengths that stay while it moves.
//!
//! F is put on the claimed line, at several heights. From there MP, PF and NQ, QF close two triangles,
//! and the pins A, B on their sides MP, NQ must be at the claimed distance. The heights of both
//! triangles contain a root, which stands for itself: so nothing depends on whether the mechanism
//! reaches that point, and more heights than the degree of the conditions prove them for all.

use rug::Rational;
use serde_json::Value;

use super::shown::{exact, list};
use super::{Defect, require};
use crate::number::exact::primitive;
use crate::number::text::parse_rational;
use crate::number::{Exact, Number};
use crate::oracle::ProblemError;
use crate::oracle::input::Fields;
use crate::plane::Point;

/// The heights of F above the base; the conditions are of a lower degree in it.
const HEIGHTS: std::ops::Range<i64> = 1..16;

type Rat = Number<Exact>;

/// The problem.
pub struct Given {
    m: Rat,
    n: Rat,
    d: Rat,
    kappa: Rat,
}

impl Given {
    /// Reads it.
    pub fn read(fields: &Fields<'_>) -> Result<Self, ProblemError> {
        Ok(Given {
            m: fields.positive("m")?.into(),
            n: fields.positive("n")?.into(),
            d: fields.positive("d")?.into(),
            kappa: fields.number("kappa")?.into(),
        })
    }
}

/// The lengths of the answer, directed, and the abscissa of the line.
struct Lengths {
    m: Rat,
    p: Rat,
    q: Rat,
    n: Rat,
    a: Rat,
    b: Rat,
    c: Rat,
    d: Rat,
    x: Rat,
}

/// Checks everything.
pub fn check(given: &Given, answer: &Value) -> Result<(), Defect> {
    let lengths = Lengths::read(answer)?;
    lengths.are_asked_for(given)?;
    let orientations = [1, -1];
    let keeps = |sign: &i64| {
        HEIGHTS
            .into_iter()
            .all(|y| lengths.keep_at(&y.into(), *sign))
    };
    require(
        orientations.iter().any(keeps),
        "a, b, c, x",
        "the coupler does not keep its length while F moves along the line",
    )?;
    line(answer, &lengths.x)
}

impl Lengths {
    fn read(answer: &Value) -> Result<Self, Defect> {
        let number = |name| exact(answer, name);
        Ok(Lengths {
            m: number("m")?,
            p: number("p")?,
            q: number("q")?,
            n: number("n")?,
            a: number("a")?,
            b: number("b")?,
            c: number("c")?,
            d: number("d")?,
            x: number("x")?,
        })
    }

    /// Whether the free lengths are those of the problem, PF : NQ is κ, S is at infinity
    /// (m p + n q = 0), and the pins are none of the pivots.
    fn are_asked_for(&self, given: &Given) -> Result<(), Defect> {
        let free = [
            ("m", &self.m, &given.m),
            ("n", &self.n, &given.n),
            ("d", &self.d, &given.d),
        ];
        for (name, shown, asked) in free {
            let same = shown.equals(asked).is_yes();
            require(same, name, "the problem gives another length")?;
        }
        let ratio = self.p.equals(&(&given.kappa * &self.n));
        require(ratio.is_yes(), "p", "PF : NQ is not kappa")?;
        let far = &self.m * &self.p + &self.n * &self.q;
        require(far.is_zero().is_yes(), "q", "S is not at infinity")?;
        let arms = self.a.is_zero().is_no() && self.b.is_zero().is_no();
        require(arms, "a, b", "an arm has no length")?;
        require(self.c.is_positive().is_yes(), "c", "a coupler has a length")
    }

    /// Whether F = (x, y) closes both triangles and leaves AB its length, where the triangle about N is
    /// laid to the side that the sign tells.
    fn keep_at(&self, y: &Rat, sign: i64) -> bool {
        let pivot = Point::from(self.d.clone());
        let from_m = Number::complex(self.x.clone(), y.clone());
        let from_n = &from_m - &pivot;
        let at_m = Triangle::of(&self.m, &self.p, &from_m);
        let at_n = Triangle::of(&self.n, &self.q, &from_n);
        // A − B = u + H w, where H is twice the area of either triangle.
        let (k, l) = (&self.a / &self.m, &self.b / &self.n);
        let u = at_m.along.scaled(&k) - &pivot - at_n.along.scaled(&l);
        let w = at_m.across.scaled(&k) - at_n.across.scaled(&(l * sign));
        let mixed = (&u * w.conj()).re().is_zero();
        let length = u.norm() + &at_m.squared_area * w.norm();
        let same_area = at_m.squared_area.equals(&at_n.squared_area);
        (mixed & same_area & length.equals(&self.c.square())).is_yes()
    }
}

/// The side of a triangle from its first corner, by the two sides and the vector that closes them:
/// along + H · across, where H² is known.
struct Triangle {
    along: Point<Exact>,
    across: Point<Exact>,
    squared_area: Rat,
}

impl Triangle {
    fn of(side: &Rat, other: &Rat, closing: &Point<Exact>) -> Self {
        let square = closing.norm();
        let foot = (side.square() + &square - other.square()) / 2;
        let over = square.inverse();
        Triangle {
            along: closing.scaled(&(&foot * &over)),
            across: (Number::i() * closing).scaled(&over),
            squared_area: side.square() * square - foot.square(),
        }
    }
}

/// A x + B y + C = 0 in primitive integers holds the points of this abscissa.
fn line(answer: &Value, x: &Rat) -> Result<(), Defect> {
    let numbers: Option<Vec<Rational>> = list(answer, "line")?
        .iter()
        .map(|value| parse_rational(value["exact"].as_str()?).ok())
        .collect();
    let numbers = numbers.ok_or_else(|| Defect::wrong("line", "exact numbers were expected"))?;
    let integers: Vec<Rational> = primitive(&numbers).iter().map(Rational::from).collect();
    let [a, b, c] = numbers.as_slice() else {
        return Err(Defect::wrong("line", "three coefficients were expected"));
    };
    let at = Number::<Exact>::from(a.clone()) * x + Number::from(c.clone());
    let right = integers == numbers && *a != 0 && b.is_zero() && at.is_zero().is_yes();
    require(
        right,
        "line",
        "this is not the line of F in primitive integers",
    )
}
