//! Whether an answer to one position of a motion is right: by velocities, accelerations and what follows
//! of the paths.
//!
//! With v, a, j for the terms in t, t², t³ of a path, it has an inflection for v × a = 0, and its
//! curvature is stationary for |v|²(v × j) = 2(v · a)(v × a). Both are polynomials in the coordinates of
//! the point. Ball's point moves straight to the third order; it is the foot of the perpendicular from
//! the inflection pole to the line v × j = 0 through the pole. The polodes have in the pole the
//! curvatures a₃ + 1 (fixed) and a₃ + 2 (moving), divided by the diameter of the inflection circle.

use serde_json::{Value, json};

use super::closure::{self, Link};
use super::conditions::{Five, Group};
use super::curve::Curve;
use super::geometry::Sheet;
use super::pairs::Pairs;
use super::rest::Rest;
use super::shown::{decided, list};
use super::{Defect, all_pairs, require};
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
    rest.after(frame(&given.motion, &sheet))?;
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
    rest.after(points(given, &sheet))?;
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

/// Terms of a path.
fn term(motion: &Group<Exact>, n: usize, z: &Point) -> Point {
    motion
        .get(n)
        .map_or_else(Number::zero, |displacement| displacement.of(z))
}

fn cross(left: &Point, right: &Point) -> Number<Exact> {
    (left.conj() * right).im().clone()
}

fn dot(left: &Point, right: &Point) -> Number<Exact> {
    (left.conj() * right).re().clone()
}

fn parts(z: &Point) -> [Number<Exact>; 2] {
    [z.re().clone(), z.im().clone()]
}

/// What belongs to the motion itself.
fn frame(motion: &Group<Exact>, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let answer = sheet.answer;
    let mut rest = Rest::default();
    // v vanishes in the pole.
    let at = |n: usize| move |z: Point| term(motion, n, &z);
    let velocity = at(1)(Number::zero());
    let spin = motion
        .get(1)
        .map_or_else(Number::zero, |first| first.rotation.im().clone());
    let pole = [-velocity.im(), velocity.re().clone(), spin.clone()];
    rest.after(sheet.point(&answer["pole"], "pole", &pole))?;
    let circle = circle(|z: Point| cross(&at(1)(z.clone()), &at(2)(z)));
    rest.after(sheet.up_to_factor(&answer["inflection_circle"], "inflection_circle", &circle))?;
    if spin.is_zero().is_yes() {
        for name in ["inflection_pole", "invariants", "ball_point"] {
            require(answer[name].is_null(), name, "the pole is at infinity")?;
        }
        no_polodes(answer)?;
        return rest.finish();
    }
    let [x, y, w] = &pole;
    let pole = Number::complex(x / w, y / w);
    // The pole and the inflection pole are opposite on the circle.
    let [a, b, c, _] = &circle;
    let inflection_pole = Number::complex(-(b / a), -(c / a)) - &pole;
    rest.after(sheet.finite_point(
        &answer["inflection_pole"],
        "inflection_pole",
        &parts(&inflection_pole),
    ))?;
    let diameter = &inflection_pole - &pole;
    if diameter.is_zero().is_yes() {
        for name in ["invariants", "ball_point"] {
            require(
                answer[name].is_null(),
                name,
                "the inflection circle is a point",
            )?;
        }
        no_polodes(answer)?;
        return rest.finish();
    }
    // Seen from the pole, in diameters: with t + s₃t³ for the sine of the turn, the turn is
    // t + (s₃ + 1/6)t³.
    let seen = |n: usize| Number::i() * at(n)(pole.clone()) / &diameter;
    let bent = motion
        .get(3)
        .map_or_else(Number::zero, |third| third.rotation.im().clone());
    let third = seen(3) * 6;
    let fourth = (seen(4) - Number::i() * Point::from(bent + Number::ratio(1, 6))) * 24;
    for (name, own) in [("third", &third), ("fourth", &fourth)] {
        let shown = &answer["invariants"][name];
        rest.after(sheet.finite_point(shown, "invariants", &parts(own)))?;
    }
    let line = circle_without_square(|z: Point| cross(&at(1)(z.clone()), &at(3)(z)));
    let line = line.ok_or_else(|| Defect::unchecked("ball_point"))?;
    rest.after(sheet.point(
        &answer["ball_point"],
        "ball_point",
        &foot(&line, &inflection_pole),
    ))?;
    for (name, curvature) in [("fixed", third.re() + 1), ("moving", third.re() + 2)] {
        let center = pole.scaled(&curvature) + &diameter;
        let [x, y] = parts(&center);
        rest.after(sheet.point(&answer["polodes"][name], "polodes", &[x, y, curvature]))?;
    }
    rest.finish()
}

fn no_polodes(answer: &Value) -> Result<(), Defect> {
    let none = ["fixed", "moving"]
        .iter()
        .all(|name| answer["polodes"][*name].is_null());
    require(none, "polodes", "the polodes have no curvature here")
}

/// a (x² + y²) + b x + c y + d, from values in four points.
fn circle(value: impl Fn(Point) -> Number<Exact>) -> [Number<Exact>; 4] {
    let at = |x: i64, y: i64| value(Number::complex(x.into(), y.into()));
    let (origin, right, left, up) = (at(0, 0), at(1, 0), at(-1, 0), at(0, 1));
    let a = (&right + &left) / 2 - &origin;
    let b = (right - left) / 2;
    let c = up - &a - &origin;
    [a, b, c, origin]
}

/// The same where it is known to be a line.
fn circle_without_square(value: impl Fn(Point) -> Number<Exact>) -> Option<[Number<Exact>; 3]> {
    let [a, b, c, d] = circle(value);
    a.is_zero().is_yes().then_some([b, c, d])
}

/// The foot of the perpendicular from a point to a line; not determined where all of the line vanishes.
fn foot([a, b, c]: &[Number<Exact>; 3], from: &Point) -> [Number<Exact>; 3] {
    let size = a.square() + b.square();
    let height = a * from.re() + b * from.im() + c;
    [
        from.re() * &size - a * &height,
        from.im() * &size - b * height,
        size,
    ]
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

/// The paths of the points that were asked for.
fn points(given: &Given, sheet: &Sheet<'_>) -> Result<(), Defect> {
    if given.points.is_empty() {
        let none = sheet.answer["points"].is_null();
        return require(none, "points", "no point was asked for");
    }
    let shown = list(sheet.answer, "points")?;
    let all = shown.len() == given.points.len();
    require(all, "points", "one for each point was expected")?;
    let mut rest = Rest::default();
    for (shown, z) in shown.iter().zip(&given.points) {
        rest.after(sheet.finite_point(&shown["point"], "points", &parts(z)))?;
        let path: Vec<Point> = (0..given.motion.len())
            .map(|n| term(&given.motion, n, z))
            .collect();
        rest.after(path_is_shown(&path, shown, sheet))?;
    }
    rest.finish()
}

/// Center of curvature, and how far the path keeps to its tangent and its circle.
fn path_is_shown(path: &[Point], shown: &Value, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let [place, v, a, ..] = path else {
        return Ok(());
    };
    // The lines of the points as far from the path in t and in t².
    let (near, far) = (dot(v, place), dot(a, place) + v.norm() / 2);
    let center = [
        &near * a.im() - &far * v.im(),
        v.re() * &far - a.re() * near,
        cross(v, a),
    ];
    let mut rest = Rest::default();
    rest.after(sheet.point(&shown["center"], "points", &center))?;
    let tangent = v.is_zero().is_no().then(|| {
        let across = path.iter().map(|term| cross(v, term));
        contact(across)
    });
    let [x, y, w] = &center;
    let circle = w.is_zero().is_no().then(|| {
        let center = Number::complex(x / w, y / w);
        let mut links = path.to_vec();
        if let Some(start) = links.first_mut() {
            *start = &*start - center;
        }
        let square = |n: usize| {
            let pairs = links.iter().take(n + 1).zip(links.iter().take(n + 1).rev());
            pairs.map(|(one, other)| dot(one, other)).sum()
        };
        contact((0..links.len()).map(square))
    });
    for (name, own) in [("tangent", tangent), ("circle", circle)] {
        let right = own.unwrap_or(Value::Null);
        let said = &shown["contact"][name];
        require(*said == right, "points.contact", "it is of another order")?;
    }
    rest.finish()
}

/// The number of the last term that vanishes with all before it, from that in t on; or that all do.
fn contact(terms: impl Iterator<Item = Number<Exact>>) -> Value {
    let terms: Vec<Number<Exact>> = terms.skip(1).collect();
    match terms.iter().position(|term| term.is_zero().is_no()) {
        Some(order) => json!(order),
        None => json!({"at_least": terms.len()}),
    }
}
