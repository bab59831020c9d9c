//! The arc on which D keeps within a bound of its line.
//!
//! From the design position the crank is turned both ways, until the deviation reaches the bound, the
//! travel turns back, or the crank comes to a dead centre: whichever is first. Dead centres are known
//! in closed form; the others are first zeros of functions of the crank's angle, enclosed. A sweep in
//! intervals of machine floats says where to look for them; where it cannot, all angles are searched.

use std::cell::{Cell, OnceCell};
use std::cmp::Ordering;

use rug::Rational;

use super::closed::Closed;
use super::driven::{Driven, Position};
use super::sweep::{First, Sweep};
use crate::number::zeros::{Function, Zero, first_zero, zeros};
use crate::number::{Ball, Interval, Number, Series};
use crate::plane::Point;
use crate::straight_line::turning::{cis, path};

type Dual = Number<Series<Ball>>;

/// Why an arc ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The deviation reaches the bound.
    Deviation,
    /// The travel turns back.
    Reversal,
    /// The crank cannot be turned further.
    DeadCentre,
}

impl End {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            End::Deviation => "deviation",
            End::Reversal => "reversal",
            End::DeadCentre => "dead-centre",
        }
    }
}

/// Where the arc ends on one side.
#[derive(Clone, Debug)]
pub struct Limit {
    /// The crank's angle in degrees, from the design position.
    pub degrees: Number<Ball>,
    /// Why.
    pub end: End,
}

/// An extreme of the deviation.
#[derive(Clone, Debug)]
pub struct Extreme {
    /// The crank's angle in degrees, from the design position.
    pub degrees: Number<Ball>,
    /// Where the linkage is.
    pub position: Position<Ball>,
}

/// From the lesser to the greater, outwards.
fn in_order(start: &Rational, end: &Number<Ball>) -> Option<[Rational; 2]> {
    let (low, high) = (end.0.lower()?, end.0.upper()?);
    Some(if *start < high {
        [start.clone(), high]
    } else {
        [low, start.clone()]
    })
}

/// Whether a number is surely between two others.
fn is_between(x: &Number<Ball>, a: &Number<Ball>, b: &Number<Ball>) -> bool {
    ((x - a) * (b - x)).is_positive().is_yes()
}

/// A linkage whose arcs are asked for.
pub struct Arcs {
    driven: Driven<Ball>,
    dual: Driven<Series<Ball>>,
    closed: Closed<Ball>,
    bits: u32,
    /// What ends every arc, backwards and forwards, where it has been searched for.
    outer: [OnceCell<Option<Limit>>; 2],
    searches: Cell<usize>,
}

/// Of the series by which zeros are found: the deviation touches zero in the design position.
const ORDER: usize = 6;
/// A whole turn; every closed path turns back within it.
const TURN: u32 = 360;

impl Arcs {
    /// All arcs of a linkage, to about so many bits.
    pub fn new(driven: Driven<Ball>, bits: u32) -> Self {
        Arcs {
            dual: driven.map(|x| x.clone().into()),
            closed: driven.closed(),
            driven,
            bits,
            outer: Default::default(),
            searches: Cell::new(0),
        }
    }

    /// The closed form of the linkage.
    pub fn closed(&self) -> &Closed<Ball> {
        &self.closed
    }

    /// How many ends the sweep has not found.
    pub fn searches(&self) -> usize {
        self.searches.get()
    }

    /// The first dead centre or reversal on one side.
    fn outer(&self, side: i64) -> Option<Limit> {
        let room = |degrees: &Dual| self.dual.room(&path(&(side * degrees), self.bits));
        let dead = self.first(&room, &Rational::from(TURN))?;
        let reach = match &dead {
            Some(dead) => dead.0.upper()?,
            None => Rational::from(TURN),
        };
        let travel = |degrees: &Dual| {
            self.moving(&(side * degrees), |driven, position| {
                driven.rates(position).travel
            })
        };
        let turned = self.first(&travel, &reach)?;
        let (at, end) = match (turned, dead) {
            (Some(turned), Some(dead)) => match turned.compare(&dead)? {
                Ordering::Less => (turned, End::Reversal),
                _ => (dead, End::DeadCentre),
            },
            (Some(turned), None) => (turned, End::Reversal),
            (None, Some(dead)) => (dead, End::DeadCentre),
            (None, None) => return None,
        };
        Some(Limit {
            degrees: side * at,
            end,
        })
    }

    /// The arc on which |v| keeps within a bound; `None` where its ends could not be decided.
    pub fn within(&self, bound: &Number<Ball>) -> Option<[Limit; 2]> {
        let limit = |side: i64| {
            self.swept(bound, side).or_else(|| {
                self.searches.set(self.searches.get() + 1);
                self.searched(bound, side)
            })
        };
        Some([limit(-1)?, limit(1)?])
    }

    /// The end on one side, by a sweep.
    fn swept(&self, bound: &Number<Ball>, side: i64) -> Option<Limit> {
        let dead = self.closed.dead_centre(side > 0, self.bits)?;
        let first = Sweep {
            closed: &self.closed.map(|x| Number(Interval::from(&x.0))),
            bound: &Interval::from(&bound.0),
            is_forward: side > 0,
            dead: dead.as_ref().map(|dead| Interval::from(&dead.0)),
        }
        .first()?;
        let closed = self.closed.map(|x| Number::<Series<Ball>>::from(x.clone()));
        let turn = |degrees: &Dual| path(&(side * degrees), self.bits);
        let (at, end) = match first {
            First::DeadCentre => (dead?, End::DeadCentre),
            First::Deviation([from, to]) => {
                let above = self.deviation_at(&to, side).is_positive().is_yes();
                let edge: Dual = if above { bound.clone() } else { -bound }.into();
                let excess = |degrees: &Dual| closed.place(&turn(degrees)).v - &edge;
                (self.only_zero(&excess, &from, &to)?, End::Deviation)
            }
            First::Reversal([from, to]) => {
                let travel = |degrees: &Dual| closed.slopes(&turn(degrees)).u;
                (self.only_zero(&travel, &from, &to)?, End::Reversal)
            }
        };
        Some(Limit {
            degrees: side * at,
            end,
        })
    }

    fn deviation_at(&self, degrees: &Rational, side: i64) -> Number<Ball> {
        let degrees = side * Number::rounded(degrees, &self.bits);
        self.closed.place(&cis(&degrees, self.bits)).v
    }

    /// The zero in a short interval in which there is one.
    fn only_zero(&self, f: &impl Function, from: &Rational, to: &Rational) -> Option<Number<Ball>> {
        let found = first_zero(f, 1, from, to);
        if !found.unresolved.is_empty() {
            return None;
        }
        let zero = found.isolated.first()?;
        Some(Number(zero.ball(f, self.bits)))
    }

    /// The end on one side, by a search of all angles.
    fn searched(&self, bound: &Number<Ball>, side: i64) -> Option<Limit> {
        let [backward, forward] = &self.outer;
        let outer = if side > 0 { forward } else { backward };
        let outer = outer.get_or_init(|| self.outer(side)).as_ref()?;
        let square: Dual = bound.square().into();
        let excess = |degrees: &Dual| {
            self.moving(&(side * degrees), |driven, position| {
                let [_, v] = driven.coordinates(position);
                v.square() - &square
            })
        };
        let reach = (side * &outer.degrees).0.upper()?;
        let Some(crossed) = self.first(&excess, &reach)? else {
            return Some(outer.clone());
        };
        // A crossing beyond the end is none.
        match crossed.compare(&(side * &outer.degrees))? {
            Ordering::Less => Some(Limit {
                degrees: side * crossed,
                end: End::Deviation,
            }),
            _ => Some(outer.clone()),
        }
    }

    /// The first zero from the design position on; `None` where that is not decided, `Some(None)`
    /// where there is none.
    fn first(&self, f: &impl Function, reach: &Rational) -> Option<Option<Number<Ball>>> {
        let found = first_zero(f, ORDER, &Rational::new(), reach);
        if !found.unresolved.is_empty() {
            return None;
        }
        let zero = found.isolated.first();
        Some(zero.map(|zero| Number(zero.ball(f, self.bits))))
    }

    /// A quantity of the moving linkage; no value where it does not come.
    fn moving(
        &self,
        degrees: &Dual,
        of: impl Fn(&Driven<Series<Ball>>, &Position<Series<Ball>>) -> Dual,
    ) -> Dual {
        match self.dual.position(&path(degrees, self.bits)) {
            Some(position) => of(&self.dual, &position),
            None => Number::zero().inverse(),
        }
    }

    /// The position at an end. In a dead centre the sides of the triangle ABO_b are one line.
    pub fn position(&self, limit: &Limit) -> Option<Position<Ball>> {
        self.driven.position(&cis(&limit.degrees, self.bits))
    }

    /// u and v of a position.
    pub fn coordinates(&self, position: &Position<Ball>) -> [Number<Ball>; 2] {
        self.driven.coordinates(position)
    }

    /// The acute angles between the coupler and R, T, in degrees.
    pub fn transmission_angles(&self, position: &Position<Ball>) -> [Number<Ball>; 2] {
        let [o_a, o_b] = self.pivots();
        let [a, b] = &position.pins;
        let rod = (b - a).conj();
        [a - o_a, b - o_b].map(|crank| {
            let z = crank * &rod;
            z.im().abs().atan2(&z.re().abs()) * 180 / Number::pi(&self.bits)
        })
    }

    /// All extremes of v within an arc, beside the design position where v has contact of order n with
    /// 0, so that its derivative has a zero of multiplicity n. `None` where that is not decided.
    pub fn extremes(&self, arc: &[Limit; 2], contact: usize) -> Option<Vec<Extreme>> {
        let near = self.only_zero_within(contact)?;
        let mut extremes = Vec::new();
        for (limit, side) in arc.iter().zip([-1, 1]) {
            // All of a short arc is near.
            if (side * &limit.degrees).0.upper()? <= near {
                continue;
            }
            let start = Rational::from(side) * &near;
            extremes.extend(match limit.end {
                End::DeadCentre => self.extremes_to_dead_centre(&start, limit)?,
                _ => self.extremes_between(&start, &limit.degrees)?,
            });
        }
        extremes.sort_by(|x, y| {
            let order = x.degrees.compare(&y.degrees);
            order.unwrap_or(Ordering::Equal)
        });
        Some(extremes)
    }

    /// Those strictly between two angles of the crank.
    fn extremes_between(&self, start: &Rational, end: &Number<Ball>) -> Option<Vec<Extreme>> {
        let rate = |degrees: &Dual| {
            self.moving(degrees, |driven, position| driven.rates(position).deviation)
        };
        let [from, to] = in_order(start, end)?;
        if from >= to {
            return Some(Vec::new());
        }
        let found = zeros(&rate, ORDER, &from, &to);
        found.unresolved.is_empty().then_some(())?;
        let start = Number::<Ball>::from(start.clone());
        let extreme = |zero: &Zero| {
            let degrees = Number(zero.ball(&rate, self.bits));
            let inside = is_between(&degrees, &start, end);
            let position = self.driven.position(&cis(&degrees, self.bits))?;
            Some(inside.then_some(Extreme { degrees, position }))
        };
        let extremes: Option<Vec<_>> = found.isolated.iter().map(extreme).collect();
        Some(extremes?.into_iter().flatten().collect())
    }

    /// Those up to a dead centre of O_aA. There its angle is stationary, and the other crank O_bB serves
    /// as the driver on the last part of the way, where it does not turn back.
    fn extremes_to_dead_centre(&self, start: &Rational, limit: &Limit) -> Option<Vec<Extreme>> {
        let end = limit.degrees.0.midpoint_rational()?;
        let whole = Rational::from(&end - start);
        let from = (1..12).find_map(|halvings| {
            let middle: Rational = &end - (whole.clone() >> halvings);
            let from = Limit {
                degrees: Number::rounded(&middle, &self.bits),
                end: limit.end,
            };
            let rest = if whole.cmp0().is_gt() {
                [from.clone(), limit.clone()]
            } else {
                [limit.clone(), from.clone()]
            };
            let turns_back =
                self.positions_where(&rest, |driven, position| driven.rates(position).rocker);
            turns_back?.is_empty().then_some(from)
        })?;
        let mut extremes = self.extremes_between(start, &from.degrees)?;
        let turn = self.turn_of_rocker(limit)? - self.turn_of_rocker(&from)?;
        let here = self.driven.position(&cis(&from.degrees, self.bits))?;
        let exchanged = self.driven.exchanged(&here)?;
        let dual = exchanged.map(|x| x.clone().into());
        let rate = |degrees: &Dual| match dual.position(&path(degrees, self.bits)) {
            Some(position) => dual.rates(&position).deviation,
            None => Number::zero().inverse(),
        };
        let [low, high] = in_order(&Rational::new(), &turn)?;
        let found = zeros(&rate, ORDER, &low, &high);
        found.unresolved.is_empty().then_some(())?;
        let o_a = &self.driven.pivots()[0];
        for zero in &found.isolated {
            let turned = Number(zero.ball(&rate, self.bits));
            if !is_between(&turned, &Number::zero(), &turn) {
                continue;
            }
            let Position {
                pins: [b, a],
                point,
            } = exchanged.position(&cis(&turned, self.bits))?;
            let step = (&a - o_a) * (&here.pins[0] - o_a).conj();
            let step = step.im().clone().atan2(step.re()) * 180 / Number::pi(&self.bits);
            extremes.push(Extreme {
                degrees: &from.degrees + step,
                position: Position {
                    pins: [a, b],
                    point,
                },
            });
        }
        Some(extremes)
    }

    /// An angle within which the derivative of order n + 1 of v does not vanish: there v' has no other
    /// zeros than the n of the design position.
    fn only_zero_within(&self, contact: usize) -> Option<Rational> {
        let order = contact + 1;
        (0..24).find_map(|halvings| {
            let near = Rational::from(16) >> halvings;
            let interval = Ball::with_radius(&Rational::new(), &near, self.bits);
            let degrees = Number::from_coefficients([Number(interval), Number::one()], order);
            let v = self.moving(&degrees, |driven, position| {
                let [_, v] = driven.coordinates(position);
                v
            });
            v.coefficient(order).is_zero().is_no().then_some(near)
        })
    }

    /// O_a and O_b.
    pub fn pivots(&self) -> &[Point<Ball>; 2] {
        self.driven.pivots()
    }

    /// The positions within an arc in which the angle between crank and coupler is stationary, at A
    /// and at B. That at A belongs to the distance O_aB, which is stationary where O_bB is in line with
    /// the base, and where O_bB stands still; that at B belongs to O_bA, stationary where O_aA is in
    /// line with the base. `None` where they are not decided.
    #[expect(
        clippy::indexing_slicing,
        reason = "the pins and pivots are numbered 0 and 1"
    )]
    pub fn transmission_extremes(&self, arc: &[Limit; 2]) -> Option<[Vec<Position<Ball>>; 2]> {
        let [o_a, o_b] = self.dual.pivots();
        let base = o_b - o_a;
        let in_line = |pin: usize| {
            self.positions_where(arc, |_, position| {
                let arm = &position.pins[pin] - &self.dual.pivots()[pin];
                (arm * base.conj()).im().clone()
            })
        };
        let standing = self.positions_where(arc, |driven, position| driven.rates(position).rocker);
        let [at_b, mut at_a] = [in_line(0)?, in_line(1)?];
        at_a.extend(standing?);
        Some([at_a, at_b])
    }

    /// The positions within an arc in which a quantity vanishes.
    fn positions_where(
        &self,
        arc: &[Limit; 2],
        of: impl Fn(&Driven<Series<Ball>>, &Position<Series<Ball>>) -> Dual,
    ) -> Option<Vec<Position<Ball>>> {
        let [from, to] = arc.each_ref().map(|limit| &limit.degrees);
        let f = |degrees: &Dual| self.moving(degrees, &of);
        let found = zeros(&f, ORDER, &from.0.lower()?, &to.0.upper()?);
        let position = |zero: &Zero| {
            let degrees = Number(zero.ball(&f, self.bits));
            self.driven.position(&cis(&degrees, self.bits))
        };
        let positions = found.isolated.iter().map(position).collect();
        found.unresolved.is_empty().then_some(positions)?
    }

    /// The turn of T from the design position to an end, in degrees, not reduced by whole turns.
    pub fn turn_of_rocker(&self, limit: &Limit) -> Option<Number<Ball>> {
        let o_b = self.driven.pivots()[1].clone();
        let arm = |degrees: &Number<Ball>| {
            let position = self.driven.position(&cis(degrees, self.bits))?;
            Some(&position.pins[1] - &o_b)
        };
        let degrees = limit.degrees.0.midpoint_rational()?;
        let mut total = Number::<Ball>::zero();
        let mut from = arm(&Number::zero())?;
        let mut left = vec![(Rational::new(), degrees.clone())];
        let mut looked_at = 0;
        while let Some((start, end)) = left.pop() {
            looked_at += 1;
            let middle = Rational::from(&start + &end) / 2u32;
            let radius = Rational::from(&end - &start).abs() / 2u32;
            let over = Number(Ball::with_radius(&middle, &radius, self.bits));
            let turned = arm(&over)? * from.conj();
            let is_end = end == degrees;
            // Within a half plane the angle has one value.
            if turned.re().is_positive().is_yes() {
                let at = if is_end {
                    limit.degrees.clone()
                } else {
                    Number::rounded(&end, &self.bits)
                };
                let to = arm(&at)?;
                let step = &to * from.conj();
                total += step.im().clone().atan2(step.re());
                from = to;
            } else if looked_at < 4000 {
                left.push((middle.clone(), end));
                left.push((start, middle));
            } else {
                return None;
            }
        }
        Some(total * 180 / Number::pi(&self.bits))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::Angle;
    use crate::straight_line::ball_burmester::{Alternate, double};

    const BITS: u32 = 128;

    fn arcs(alpha_a: i64, alpha_b: i64) -> (Arcs, Number<Ball>) {
        let angle = |degrees: i64| {
            let radians = Number::pi(&BITS) * degrees / 180;
            Angle::from_cos_sin(radians.clone().cos(), radians.sin())
        };
        let cranks = double::<Ball>(&angle(alpha_a), &angle(alpha_b)).unwrap();
        let design = cranks.design(Alternate::First).unwrap();
        let lengths = design.squared_lengths();
        let size: Number<Ball> = lengths[..4].iter().map(|(_, x)| x.clone().sqrt()).sum();
        (Arcs::new(Driven::new(&design).unwrap(), BITS), size / 4)
    }

    #[test]
    fn the_sweep_finds_what_the_search_finds() {
        let mut ends = std::collections::BTreeSet::new();
        for (alpha_a, alpha_b, divisor) in
            [(65, 165, 5), (65, 165, 100), (35, 160, 100), (20, 100, 9)]
        {
            let (arcs, size) = arcs(alpha_a, alpha_b);
            let bound = size / divisor;
            for side in [-1, 1] {
                let swept = arcs.swept(&bound, side).unwrap();
                let searched = arcs.searched(&bound, side).unwrap();
                assert_eq!(swept.end, searched.end, "{alpha_a} {alpha_b}");
                let difference = &swept.degrees - &searched.degrees;
                assert!(!difference.is_zero().is_no(), "{difference}");
                assert!(
                    difference.0.radius_rational().unwrap() < 1e-15,
                    "{difference}"
                );
                ends.insert(swept.end.name());
            }
        }
        assert_eq!(ends.len(), 3, "{ends:?}");
    }
}
