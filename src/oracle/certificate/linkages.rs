//! Whether what is said of a linkage of two pairs is so.
//!
//! Type and cranks are by Grashof's rule: the shortest link and the longest are together shorter than
//! the two others. With one joint at infinity two lengths are left, and the offset of the slide, or of
//! the line in its block, takes the place of the difference of the infinite ones. In a linkage that
//! obeys the rule the joints that are not on the shortest link never come to a line with their
//! neighbours: the side to which the chain turns there tells the circuit. A link drives to a dead centre
//! where the chain is stretched at the far end of the coupler, and the range between two of them is
//! connected.

use std::cmp::Ordering;

use serde_json::{Value, json};

use super::geometry::Sheet;
use super::rest::Rest;
use super::shown::decided;
use super::way::Way;
use super::{Defect, require};
use crate::number::{Ball, Exact, Number, Truth};
use crate::plane::{Point, relation};

/// A joint, finite or in a direction.
#[derive(Clone)]
pub enum Joint {
    At(Point<Ball>),
    /// Of length 1.
    Towards(Point<Ball>),
}

impl Joint {
    pub fn towards(direction: &Point<Ball>) -> Self {
        let length = direction.norm().sqrt();
        Joint::Towards(direction.scaled(&length.inverse()))
    }

    fn point(&self) -> Option<&Point<Ball>> {
        match self {
            Joint::At(point) => Some(point),
            Joint::Towards(_) => None,
        }
    }

    /// [x : y : w].
    fn homogeneous(&self) -> [Number<Ball>; 3] {
        let (point, w) = match self {
            Joint::At(point) => (point, Number::one()),
            Joint::Towards(direction) => (direction, Number::zero()),
        };
        [point.re().clone(), point.im().clone(), w]
    }
}

/// One pair: its center, and the places of its circlepoint.
#[derive(Clone)]
pub struct Dyad {
    pub center: Joint,
    pub places: Vec<Joint>,
    /// Center and first place, where they are known exactly.
    pub exact: Option<[Point<Exact>; 2]>,
}

/// The linkage of two pairs, the first of which drives.
pub struct FourBar<'a> {
    pub dyads: [&'a Dyad; 2],
    kind: Kind,
}

/// What Grashof's rule says.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// This link is the shortest, and turns fully against the others.
    Grashof(Link),
    ChangePoint,
    NoFullTurn,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Link {
    First,
    Second,
    Coupler,
    Base,
}

const LINKS: [Link; 4] = [Link::First, Link::Second, Link::Coupler, Link::Base];

/// Checks what is said of the linkage of two pairs.
pub fn check(dyads: [&Dyad; 2], shown: &Value, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let [first, second] = dyads;
    let both = [[first, second], [second, first]].map(FourBar::of);
    let [Some(four_bar), Some(exchanged)] = both else {
        return Err(Defect::unchecked("a linkage that is none, or nearly so"));
    };
    let mut rest = Rest::default();
    let mut is = |name: &str, said: &Value, own: Option<Value>| -> Result<(), Defect> {
        let place = format!("linkages.{name}");
        rest.after(match own {
            Some(own) => decided(sheet.answer, said, &place)
                .and_then(|said| require(*said == own, &place, "it is not so")),
            None => Err(Defect::unchecked(place)),
        })
    };
    is("type", &shown["type"], Some(json!(four_bar.word())))?;
    is("circuit", &shown["circuit"], known(four_bar.circuit()))?;
    let [cranks, branches, orders, ranges] =
        ["crank", "branch", "order", "transmission"].map(|name| &shown[name]);
    for (name, driven) in [("first", &four_bar), ("second", &exchanged)] {
        let way = driven.way(sheet.bits);
        let crank = way.as_ref().map(|way| json!(driven.is_crank(way)));
        is("crank", &cranks[name], crank)?;
        let reached = way.as_ref();
        let reached = reached.map_or(Truth::Unknown, |way| driven.branch(way));
        is("branch", &branches[name], known(reached))?;
        let (order, range) = (&orders[name], &ranges[name]);
        if let Some(way) = way
            && !reached.is_unknown()
        {
            way.is_shown(reached.is_yes(), order, range, sheet)?;
        }
    }
    rest.finish()
}

impl<'a> FourBar<'a> {
    /// `None` where it cannot be told what Grashof's rule says, where joints may coincide, and with two
    /// joints at infinity.
    fn of(dyads: [&'a Dyad; 2]) -> Option<Self> {
        let kind = kind(dyads)?;
        Some(FourBar { dyads, kind })
    }

    /// Whether a center is at infinity, and whether a circlepoint is.
    fn slides(&self) -> [bool; 2] {
        let far = |joint: &Joint| joint.point().is_none();
        let places = self.dyads.map(|dyad| dyad.places.iter().any(far));
        [
            self.dyads.iter().any(|dyad| far(&dyad.center)),
            places.contains(&true),
        ]
    }

    fn word(&self) -> &'static str {
        let links_turn = [Link::First, Link::Second].map(|link| self.kind == Kind::Grashof(link));
        let a_link_turns = links_turn.contains(&true);
        let base_turns = self.kind == Kind::Grashof(Link::Base);
        match (self.kind, self.slides()) {
            (Kind::ChangePoint, _) => "change-point",
            (_, [true, _]) if a_link_turns => "slider-crank",
            (_, [true, _]) => "slider-rocker",
            (_, [_, true]) if a_link_turns || base_turns => "inverted-slider-crank",
            (_, [_, true]) => "inverted-slider-rocker",
            _ if a_link_turns => "crank-and-lever",
            _ if base_turns => "drag-link",
            _ => "double-lever",
        }
    }

    /// Whether the driving link turns fully, perhaps through a change point.
    fn is_crank(&self, way: &Way) -> bool {
        match self.kind {
            Kind::Grashof(shortest) => {
                matches!(shortest, Link::First | Link::Base) && way.is_turning()
            }
            Kind::NoFullTurn => false,
            Kind::ChangePoint => way.is_turning() && !way.is_barred(),
        }
    }

    /// Whether the chain turns to one side at a joint in all positions.
    fn turns_alike(&self, at: [Corner; 3]) -> Truth {
        let [first, second] = self.dyads;
        let positions = first.places.iter().zip(&second.places);
        let sides = positions.map(|(a, b)| {
            let corners = at.map(|corner| match corner {
                Corner::FirstPivot => &first.center,
                Corner::FirstPin => a,
                Corner::SecondPin => b,
                Corner::SecondPivot => &second.center,
            });
            determinant(corners.map(Joint::homogeneous)).sign()
        });
        alike(sides)
    }

    /// Whether all positions are on one circuit.
    fn circuit(&self) -> Truth {
        use Corner::{FirstPin, FirstPivot, SecondPin, SecondPivot};
        let corners = match self.kind {
            Kind::Grashof(Link::First) => [FirstPin, SecondPin, SecondPivot],
            Kind::Grashof(Link::Second | Link::Base) => [FirstPivot, FirstPin, SecondPin],
            Kind::Grashof(Link::Coupler) => [SecondPivot, FirstPivot, FirstPin],
            Kind::ChangePoint | Kind::NoFullTurn => return Truth::Yes,
        };
        self.turns_alike(corners)
    }

    /// Whether the first pair drives through all positions without a dead centre. In a change point
    /// both links may be on the base, where they come to a dead centre too.
    fn branch(&self, way: &Way) -> Truth {
        use Corner::{FirstPin, SecondPin, SecondPivot};
        let connected = match self.kind {
            Kind::ChangePoint if way.passes_a_gate() => Truth::Yes,
            Kind::ChangePoint => way.is_on_one_side(),
            _ => self.circuit(),
        };
        connected & self.turns_alike([FirstPin, SecondPin, SecondPivot])
    }

    fn way(&self, bits: u32) -> Option<Way> {
        let [own, other] = self.dyads;
        Way::of(own, other, bits)
    }
}

#[derive(Clone, Copy)]
enum Corner {
    FirstPivot,
    FirstPin,
    SecondPin,
    SecondPivot,
}

/// Twice the area of a triangle, up to a positive factor.
fn determinant([[a, b, c], [d, e, f], [g, h, i]]: [[Number<Ball>; 3]; 3]) -> Number<Ball> {
    let (first, second, third) = (&e * &i - &f * &h, &f * &g - &d * &i, d * h - e * g);
    a * first + b * second + c * third
}

/// By the sum of the shortest and the longest link against the others.
fn kind(dyads: [&Dyad; 2]) -> Option<Kind> {
    let [p, q] = dyads.map(|dyad| &dyad.center);
    let [a, b] = dyads.map(|dyad| dyad.places.first());
    let (a, b) = (a?, b?);
    let distance = |x: &Joint, y: &Joint| Some(relation::distance(x.point()?, y.point()?));
    let lengths = [
        distance(p, a),
        distance(q, b),
        distance(a, b),
        distance(p, q),
    ];
    let mut finite: Vec<(Link, Number<Ball>)> = LINKS
        .into_iter()
        .zip(lengths)
        .filter_map(|(link, length)| Some((link, length?)))
        .collect();
    for (_, length) in &finite {
        length.is_positive().is_yes().then_some(())?;
    }
    finite.sort_by(|(_, x), (_, y)| x.compare(y).unwrap_or(Ordering::Equal));
    let room = match finite.as_slice() {
        [(_, least), (_, x), (_, y), (_, most)] => x + y - least - most,
        [(_, least), (_, most)] => most - least - offset([p, a, b, q])?,
        _ => return None,
    };
    let (shortest, least) = finite.first()?;
    match room.sign() {
        Some(Ordering::Less) => Some(Kind::NoFullTurn),
        Some(Ordering::Greater) => {
            let (_, next) = finite.get(1)?;
            let is_shortest = least.compare(next) == Some(Ordering::Less);
            is_shortest.then_some(Kind::Grashof(*shortest))
        }
        _ => can_be_on_a_line(dyads).then_some(Kind::ChangePoint),
    }
}

/// How far the chain is beside a slide or the line in a block.
fn offset(chain: [&Joint; 4]) -> Option<Number<Ball>> {
    let along = |normal: &Point<Ball>, from: &Joint, to: &Joint| {
        let way = to.point()? - from.point()?;
        Some((normal.conj() * way).re().abs())
    };
    match chain {
        [Joint::Towards(normal), a, _, q] => along(normal, a, q),
        [p, _, b, Joint::Towards(normal)] => along(normal, b, p),
        [p, Joint::Towards(normal), b, _] => along(normal, p, b),
        [_, a, Joint::Towards(normal), q] => along(normal, q, a),
        _ => None,
    }
}

/// Whether some lengths are together exactly as long as the others: (k² + 4uv − 4xy)² = 16k²uv for
/// k = u + v − x − y, from the squares.
fn can_be_on_a_line([first, second]: [&Dyad; 2]) -> bool {
    let (Some([m, a]), Some([n, b])) = (&first.exact, &second.exact) else {
        return false;
    };
    let square = relation::distance_squared;
    let [u, v, x, y] = [square(m, a), square(n, b), square(a, b), square(m, n)];
    let k = &u + &v - &x - &y;
    let sum = k.square() + 4 * &u * &v - 4 * x * y;
    let left: Number<Exact> = sum.square() - 16 * k.square() * u * v;
    left.is_zero().is_yes()
}

/// What is known, as it is shown.
fn known(truth: Truth) -> Option<Value> {
    (!truth.is_unknown()).then(|| json!(truth.is_yes()))
}

/// Whether all signs are the same, and none zero.
pub fn alike(signs: impl IntoIterator<Item = Option<Ordering>>) -> Truth {
    let signs: Vec<Option<Ordering>> = signs.into_iter().collect();
    let has = |sign| signs.contains(&Some(sign));
    if has(Ordering::Less) && has(Ordering::Greater) {
        return Truth::No;
    }
    let are_known = signs.iter().all(|sign| sign.is_some_and(Ordering::is_ne));
    if are_known {
        Truth::Yes
    } else {
        Truth::Unknown
    }
}
