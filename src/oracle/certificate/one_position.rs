//! Whether an answer to one position of a motion is right.
//!
//! With v, a, j for the terms in t, t², t³ of a path, its curvature is stationary for
//! |v|²(v × j) = 2(v · a)(v × a), a polynomial in the coordinates of the point.

use serde_json::Value;

use super::closure::{self, Link};
use super::conditions::{Five, Group};
use super::curve::Curve;
use super::geometry::Sheet;
use super::pairs::Pairs;
use super::rest::Rest;
use super::shown::{decided, list};
use super::{Defect, all_pairs, frame, paths, require};
use crate::number::{Ball, Exact, Number};
use crate::oracle::ProblemError;
use crate::oracle::input::Fields;
use crate::oracle::positions::point;
use crate::plane::displacement::Displacement;
use crate::plane::polynomial::Polynomial;

type Point = crate::plane::Point<Exact>;
type Poly = Polynomial<Exact>;

/// Five positions that have fallen together are known to t⁴.
const ORDER: usize = 4;
/// Up to which the contact of a point of a linkage is told.
const CONTACT: usize = 10;

/// A motion about one of its positions, to terms in t⁴ or more, t being the sine of the turn or the turn
/// where it starts with one.
pub struct Given {
    motion: Group<Exact>,
    points: Vec<Point>,
}

impl Given {
    /// Reads links or invariants.
    pub fn read(fields: &Fields<'_>) -> Result<Self, ProblemError> {
        let points = fields.optional_points("points")?;
        let motion = if fields.has("invariants") {
            let invariants = fields.object("invariants")?;
            of_invariants(["third", "fourth"].map(|name| invariants.point(name)))?
        } else {
            let links = fields.list("links")?.iter();
            let links = links.map(|value| Link::read(&Fields::at(value, "links")?));
            let links: Vec<Link> = links.collect::<Result<_, _>>()?;
            let links: Option<[Link; 2]> = links.try_into().ok();
            let motion = links.and_then(|links| closure::motion(&links, CONTACT));
            motion.ok_or_else(|| ProblemError::new("links", "they determine no motion"))?
        };
        Ok(Given {
            motion,
            points: points.iter().map(point).collect(),
        })
    }
}

/// e^{it} and it²/2 + wt³/6 + w't⁴/24.
fn of_invariants(
    invariants: [Result<[rug::Rational; 2], ProblemError>; 2],
) -> Result<Group<Exact>, ProblemError> {
    let [third, fourth] = invariants;
    let [third, fourth]: [Point; 2] = [point(&third?), point(&fourth?)];
    let zero = Point::zero;
    let shifts = [zero(), zero(), Point::i() / 2, third / 6, fourth / 24];
    let mut turn = Point::one();
    let terms = shifts.into_iter().zip(0i64..).map(|(translation, n)| {
        if n > 0 {
            turn = Number::i() * &turn / n;
        }
        Displacement {
            rotation: turn.clone(),
            translation,
        }
    });
    Ok(terms.collect())
}

impl Five for Given {
    fn enclosed(&self, _: u32) -> Vec<Group<Ball>> {
        let first = self.motion.iter().take(ORDER + 1);
        vec![first.map(Displacement::in_kind).collect()]
    }

    fn exact(&self) -> Option<Vec<Group<Exact>>> {
        let first = self.motion.iter().take(ORDER + 1);
        Some(vec![first.cloned().collect()])
    }
}

/// Checks everything but estimates.
pub fn check(given: &Given, answer: &Value) -> Result<(), Defect> {
    let sheet = Sheet::of(answer)?;
    let mut rest = Rest::default();
    rest.after(frame::check(&given.motion, &sheet))?;
    let curves = [
        ("circlepoint", given.motion.clone()),
        ("centerpoint", inverse(&given.motion)),
    ];
    for (name, motion) in curves {
        let own = stationary(&motion).to_cubic();
        let own = own.ok_or_else(|| Defect::unchecked(format!("the {name} curve")))?;
        let shown = &answer[name];
        let place = format!("{name}.coefficients");
        rest.after(sheet.up_to_factor(&shown["coefficients"], &place, own.coefficients()))?;
        rest.after(Curve(own.coefficients()).check(name, shown, &sheet))?;
    }
    rest.after(paths::check(&given.motion, &given.points, &sheet))?;
    rest.after(pairs(given, &sheet))?;
    rest.after(ball_burmester(&sheet))?;
    rest.finish()
}

/// Points of a turning plane that keep to a line in five positions are Ball's point: it counts as often
/// as there are pairs with their centers at infinity.
fn ball_burmester(sheet: &Sheet<'_>) -> Result<(), Defect> {
    let name = "ball_burmester";
    let said = &sheet.answer[name];
    if !sheet.answer["ball_point"].is_array() {
        return require(said.is_null(), name, "there is no Ball's point");
    }
    let said = decided(sheet.answer, said, name)?;
    let slides = list(sheet.answer, "at_infinity")?.iter();
    let own = match slides.filter(|pair| pair["kind"] == "center").count() {
        0 => "none",
        1 => "burmester",
        2 => "double-burmester",
        _ => "triple-burmester",
    };
    require(*said == own, name, "it counts otherwise")
}

fn pairs(given: &Given, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let pairs = Pairs::of(given, sheet)?;
    all_pairs::check(given, &pairs, sheet)
}

/// |v|²(v × j) − 2(v · a)(v × a).
fn stationary(motion: &Group<Exact>) -> Poly {
    let path = |n: usize| -> [Poly; 2] {
        let none = || Displacement {
            rotation: Point::zero(),
            translation: Point::zero(),
        };
        let Displacement {
            rotation,
            translation,
        } = motion.get(n).cloned().unwrap_or_else(none);
        let (c, s) = (rotation.re(), rotation.im());
        [
            Poly::linear(c.clone(), -s, translation.re().clone()),
            Poly::linear(s.clone(), c.clone(), translation.im().clone()),
        ]
    };
    let [v, a, j] = [1, 2, 3].map(path);
    let dot = |[p, q]: &[Poly; 2], [r, s]: &[Poly; 2]| p.times(r).plus(&q.times(s));
    let cross = |[p, q]: &[Poly; 2], [r, s]: &[Poly; 2]| p.times(s).minus(&q.times(r));
    let bent = dot(&v, &a).times(&cross(&v, &a)).scaled(&2.into());
    dot(&v, &v).times(&cross(&v, &j)).minus(&bent)
}

/// r̄ and −r̄p.
fn inverse(motion: &Group<Exact>) -> Group<Exact> {
    let terms = (0..motion.len()).map(|n| {
        let first = motion.iter().take(n + 1);
        let pairs = first.zip(motion.iter().take(n + 1).rev());
        let shift: Point = pairs
            .map(|(one, other)| one.rotation.conj() * &other.translation)
            .sum();
        Displacement {
            rotation: motion
                .get(n)
                .map_or_else(Number::zero, |term| term.rotation.conj()),
            translation: -shift,
        }
    });
    terms.collect()
}
