//! The way of a driving link: in which order it passes the positions, and how the transmission angle
//! changes meanwhile.
//!
//! cos γ is extreme in the gates only, where a turning link is along the base or against it (of a slide:
//! along its normal), or where a slider is next to the other pivot. A gate with |cos γ| > 1 is barred.

use std::cmp::Ordering;

use serde_json::{Value, json};

use super::geometry::Sheet;
use super::linkages::{Dyad, Joint, alike};
use super::shown::{self, decided};
use super::{Defect, require};
use crate::number::{Ball, Number, Truth};
use crate::plane::{Point, relation};

/// A driving link.
pub struct Way {
    motion: Motion,
    /// cos γ in each position.
    cosines: Vec<Number<Ball>>,
    bits: u32,
}

enum Motion {
    /// A link or block: its direction in each position, that of the first gate, and cos γ in both.
    Turn {
        directions: Vec<Point<Ball>>,
        axis: Point<Ball>,
        gates: [Number<Ball>; 2],
    },
    /// A slider: how far it is, how far the gate is, and cos γ there.
    Slide {
        places: Vec<Number<Ball>>,
        gate: Number<Ball>,
        cosine: Number<Ball>,
    },
}

/// The scalar product.
fn dot(u: &Point<Ball>, v: &Point<Ball>) -> Number<Ball> {
    (u.conj() * v).re().clone()
}

/// cos of the angle between two sides of a triangle, the third by its square.
fn between(one: &Number<Ball>, other: &Number<Ball>, square: &Number<Ball>) -> Number<Ball> {
    (one.square() + other.square() - square) / (2 * one * other)
}

impl Way {
    /// Of the link of a pair, another pair being driven; `None` with two joints at infinity.
    pub fn of(own: &Dyad, other: &Dyad, bits: u32) -> Option<Self> {
        use Joint::{At, Towards};
        let (from, to) = (own.places.first()?, other.places.first()?);
        let chain = (&own.center, from, to, &other.center);
        let (motion, cosines) = match chain {
            (At(p), At(a), At(b), At(q)) => {
                let (coupler, link) = (relation::distance(a, b), relation::distance(b, q));
                by_distance(p, q, own, |square| between(&coupler, &link, square))?
            }
            (At(p), At(_), Towards(b), At(q)) => {
                let offset = dot(b, &(from.at()? - q)).abs();
                by_distance(p, q, own, |square| &offset / square.clone().sqrt())?
            }
            (At(p), At(a), At(b), Towards(n)) => link_of_slide([p, a, b, n], own)?,
            (At(p), Towards(_), At(b), At(q)) => block_of_link([p, b, q], own)?,
            (Towards(n), At(a), At(b), At(q)) => slide([n, a, b, q], own)?,
            _ => return None,
        };
        Some(Way {
            motion,
            cosines,
            bits,
        })
    }

    pub fn is_turning(&self) -> bool {
        matches!(self.motion, Motion::Turn { .. })
    }

    /// cos γ in the gates.
    fn gates(&self) -> &[Number<Ball>] {
        match &self.motion {
            Motion::Turn { gates, .. } => gates,
            Motion::Slide { cosine, .. } => std::slice::from_ref(cosine),
        }
    }

    /// Whether some gate is surely barred.
    pub fn is_barred(&self) -> bool {
        self.gates()
            .iter()
            .any(|cosine| (1 - cosine.square()).sign() == Some(Ordering::Less))
    }

    /// Whether some gate is surely free.
    pub fn passes_a_gate(&self) -> bool {
        self.gates().iter().any(is_free)
    }

    /// Whether all positions are on one side of the gates.
    pub fn is_on_one_side(&self) -> Truth {
        match &self.motion {
            Motion::Turn {
                directions, axis, ..
            } => {
                let across = |one: &Point<Ball>| (axis.conj() * one).im().sign();
                alike(directions.iter().map(across))
            }
            Motion::Slide { places, gate, .. } => are_beside(places, gate),
        }
    }

    /// Whether order and transmission angle are these, of a link that reaches all positions or not.
    pub fn is_shown(
        &self,
        reaches_all: bool,
        order: &Value,
        range: &Value,
        sheet: &Sheet<'_>,
    ) -> Result<(), Defect> {
        if !reaches_all {
            let none = order.is_null() && range.is_null();
            return require(none, "linkages.order", "there is no way to all positions");
        }
        let unchecked = || Defect::unchecked("the way of a linkage");
        let (own, cosines) = self.passed().ok_or_else(unchecked)?;
        let said = decided(sheet.answer, order, "linkages.order")?;
        require(
            *said == json!(own),
            "linkages.order",
            "the order is another",
        )?;
        let range = decided(sheet.answer, range, "linkages.transmission")?;
        is_range(&cosines, range, sheet)
    }

    /// The numbers of the positions in order, and cos γ where it can be extreme.
    fn passed(&self) -> Option<(Vec<usize>, Vec<Number<Ball>>)> {
        match &self.motion {
            Motion::Slide {
                places,
                gate,
                cosine,
            } => {
                let mut cosines = self.cosines.clone();
                match are_beside(places, gate) {
                    Truth::No => cosines.push(cosine.clone()),
                    Truth::Yes => {}
                    Truth::Unknown => return None,
                }
                Some((sorted(places)?, cosines))
            }
            Motion::Turn { gates, .. } if gates.iter().all(is_free) => {
                Some((sorted(&self.angles(None)?)?, gates.to_vec()))
            }
            Motion::Turn { gates, .. } => {
                let [first, second] = gates;
                let cut = usize::from(is_free(first));
                let angles = self.angles(Some(cut))?;
                let mut cosines = self.cosines.clone();
                match are_beside(&angles, &Number::pi(&self.bits)) {
                    Truth::No => cosines.push(if cut == 0 { second } else { first }.clone()),
                    Truth::Yes => {}
                    Truth::Unknown => return None,
                }
                Some((sorted(&angles)?, cosines))
            }
        }
    }

    /// How far a link is turned in each position, from a gate or from the first position on.
    fn angles(&self, cut: Option<usize>) -> Option<Vec<Number<Ball>>> {
        let Motion::Turn {
            directions, axis, ..
        } = &self.motion
        else {
            return None;
        };
        let start = match cut {
            None => directions.first()?.clone(),
            Some(0) => axis.clone(),
            Some(_) => -axis,
        };
        let angles = directions.iter().enumerate().map(|(place, direction)| {
            if cut.is_none() && place == 0 {
                return Number::zero();
            }
            let turned = direction * start.conj();
            let part = |x: &Number<Ball>| Number((-x).0.with_precision(self.bits));
            part(turned.im()).atan2(&part(turned.re())) + Number::pi(&self.bits)
        });
        Some(angles.collect())
    }
}

impl Joint {
    fn at(&self) -> Option<&Point<Ball>> {
        match self {
            Joint::At(point) => Some(point),
            Joint::Towards(_) => None,
        }
    }

    fn direction(&self) -> Option<&Point<Ball>> {
        match self {
            Joint::At(_) => None,
            Joint::Towards(direction) => Some(direction),
        }
    }
}

/// A link about P, where cos γ depends on the distance of its pin from Q.
fn by_distance(
    p: &Point<Ball>,
    q: &Point<Ball>,
    own: &Dyad,
    cosine: impl Fn(&Number<Ball>) -> Number<Ball>,
) -> Option<(Motion, Vec<Number<Ball>>)> {
    let pins: Option<Vec<&Point<Ball>>> = own.places.iter().map(Joint::at).collect();
    let pins = pins?;
    let (base, link) = (
        relation::distance(p, q),
        relation::distance(p, pins.first()?),
    );
    let gates = [(&base - &link).square(), (&base + &link).square()];
    let motion = Motion::Turn {
        directions: pins.iter().map(|pin| *pin - p).collect(),
        axis: q - p,
        gates: gates.each_ref().map(&cosine),
    };
    let squares = pins.iter().map(|pin| relation::distance_squared(pin, q));
    let cosines = squares.map(|square| cosine(&square)).collect();
    Some((motion, cosines))
}

/// A link PA that drives a slider B, whose way has the normal n.
fn link_of_slide(
    [p, a, b, n]: [&Point<Ball>; 4],
    own: &Dyad,
) -> Option<(Motion, Vec<Number<Ball>>)> {
    let coupler = relation::distance(a, b);
    let cosine = |along: Number<Ball>| (along - dot(n, b)) / &coupler;
    let pins: Option<Vec<&Point<Ball>>> = own.places.iter().map(Joint::at).collect();
    let pins = pins?;
    let link = relation::distance(p, a);
    let motion = Motion::Turn {
        directions: pins.iter().map(|pin| *pin - p).collect(),
        axis: n.clone(),
        gates: [cosine(dot(n, p) + &link), cosine(dot(n, p) - &link)],
    };
    let cosines = pins.iter().map(|pin| cosine(dot(n, pin))).collect();
    Some((motion, cosines))
}

/// A block about P that drives, by a line of the coupler, a link QB.
fn block_of_link([p, b, q]: [&Point<Ball>; 3], own: &Dyad) -> Option<(Motion, Vec<Number<Ball>>)> {
    let directions: Option<Vec<&Point<Ball>>> = own.places.iter().map(Joint::direction).collect();
    let directions = directions?;
    let base = q - p;
    let (length, link) = (relation::distance(p, q), relation::distance(q, b));
    let offset = dot(directions.first()?, &(b - p));
    let cosine = |along: &Number<Ball>| (along - &offset) / &link;
    let cosines = directions.iter().map(|normal| cosine(&dot(normal, &base)));
    let cosines = cosines.collect();
    let motion = Motion::Turn {
        gates: [cosine(&length), cosine(&-length.clone())],
        directions: directions.into_iter().cloned().collect(),
        axis: base,
    };
    Some((motion, cosines))
}

/// A slider A with the normal n of its way, which drives a link QB; counterclockwise about the point far
/// away along n.
fn slide([n, a, b, q]: [&Point<Ball>; 4], own: &Dyad) -> Option<(Motion, Vec<Number<Ball>>)> {
    let along = -(Number::i() * n);
    let (coupler, link) = (relation::distance(a, b), relation::distance(b, q));
    let pins: Option<Vec<&Point<Ball>>> = own.places.iter().map(Joint::at).collect();
    let pins = pins?;
    let cosine = |square: &Number<Ball>| between(&coupler, &link, square);
    let motion = Motion::Slide {
        places: pins.iter().map(|pin| dot(&along, pin)).collect(),
        gate: dot(&along, q),
        cosine: cosine(&dot(n, &(q - a)).square()),
    };
    let squares = pins.iter().map(|pin| relation::distance_squared(pin, q));
    let cosines = squares.map(|square| cosine(&square)).collect();
    Some((motion, cosines))
}

fn is_free(cosine: &Number<Ball>) -> bool {
    (1 - cosine.square()).is_positive().is_yes()
}

/// Whether all are before a place, or all after it.
fn are_beside(places: &[Number<Ball>], gate: &Number<Ball>) -> Truth {
    alike(places.iter().map(|place| place.compare(gate)))
}

/// The numbers of the positions in ascending order, counted from 1.
fn sorted(places: &[Number<Ball>]) -> Option<Vec<usize>> {
    let mut ranks = Vec::new();
    for (i, place) in places.iter().enumerate() {
        let mut rank = 0;
        for (j, other) in places.iter().enumerate() {
            rank += usize::from(i != j && place.compare(other)?.is_gt());
        }
        ranks.push(rank);
    }
    let mut order: Vec<(usize, usize)> = ranks.into_iter().zip(1..).collect();
    order.sort_by_key(|(rank, _)| *rank);
    Some(order.into_iter().map(|(_, number)| number).collect())
}

/// Whether least and greatest angle and the deviation from 90° are those of the cosines.
fn is_range(cosines: &[Number<Ball>], shown: &Value, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let degrees = |cosine: &Number<Ball>| {
        Number(cosine.0.with_precision(sheet.bits)).acos() * 180 / Number::pi(&sheet.bits)
    };
    let angles: Vec<Number<Ball>> = cosines.iter().map(degrees).collect();
    let pick = |wanted: Ordering| {
        let angles = angles.iter().cloned();
        angles.reduce(|best, one| match one.compare(&best) {
            Some(order) if order == wanted => one,
            _ => best,
        })
    };
    let (Some(least), Some(greatest)) = (pick(Ordering::Less), pick(Ordering::Greater)) else {
        return Ok(());
    };
    let [below, above] = [90 - &least, &greatest - 90];
    let deviation = match below.compare(&above) {
        Some(Ordering::Less) => above,
        _ => below,
    };
    let all = [
        ("least", least),
        ("greatest", greatest),
        ("deviation", deviation),
    ];
    for (name, own) in all {
        let place = format!("linkages.transmission.{name}");
        let said = decided(sheet.answer, &shown[name], "linkages.transmission")?;
        shown::holds(said, &place, &own, sheet.digits)?;
    }
    Ok(())
}
