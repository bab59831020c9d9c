//! How far nothing ends an arc, in intervals of machine floats.
//!
//! From the design position the crank is turned in steps that grow where they succeed and shrink where
//! they fail. A step succeeds where intervals prove that on all of it the travel goes on and the
//! deviation keeps within the bound. Just before the first end all steps fail, and what ends the arc is
//! looked for right there.

use std::sync::LazyLock;

use rug::Rational;

use super::closed::{Closed, Slopes};
use crate::number::{Interval, Number, Real, count};
use crate::plane::Point;

type Real64 = Number<Interval>;

/// The longest step in degrees; each finer one is half of the one before.
const LONGEST: u32 = 8;
/// Halvings down to the finest step.
const FINEST: usize = 34;
/// A whole turn in finest steps.
#[expect(
    clippy::as_conversions,
    reason = "`From` is not for constants; more bits hold all that fewer hold"
)]
const TURN: u64 = 360 / LONGEST as u64 * (1 << FINEST);
/// Steps after which it is given up.
const MOST_STEPS: usize = 100_000;
/// So many doublings of the finest step are looked at for what ends the arc.
const AHEAD: usize = 18;

/// e^{iφ} for all steps.
static TURNS: LazyLock<Vec<Point<Interval>>> = LazyLock::new(|| {
    let turn = |halvings: usize| {
        let degrees = Rational::from(LONGEST) >> count::to_u32(halvings);
        let known = Interval::cos_sin_of_degrees(&degrees, &());
        let (cos, sin) = known.unwrap_or((Interval::UNIT, Interval::UNIT));
        Number::complex(Number(cos), Number(sin))
    };
    (0..=FINEST).map(turn).collect()
});

/// What ends an arc first.
#[derive(Clone, Debug)]
pub enum First {
    /// The dead centre.
    DeadCentre,
    /// The deviation, between these angles in degrees.
    Deviation([Rational; 2]),
    /// The travel, between these.
    Reversal([Rational; 2]),
}

/// One side of an arc.
pub struct Sweep<'a> {
    /// The linkage.
    pub closed: &'a Closed<Interval>,
    /// The bound of the deviation.
    pub bound: &'a Interval,
    /// Whether the crank is turned forwards.
    pub is_forward: bool,
    /// The angle to the first dead centre, in degrees, if there is one.
    pub dead: Option<Interval>,
}

/// A crank angle on the way.
struct Here {
    /// In finest steps.
    at: u64,
    turn: Point<Interval>,
    distance: Real64,
    deviation: Real64,
}

/// A stretch of crank angles.
struct Stretch {
    deviation: Real64,
    slopes: Slopes<Interval>,
    area: Real64,
    /// Its length in radians, or more.
    length: f64,
}

impl Sweep<'_> {
    /// What ends the arc first; `None` where that was not found out.
    pub fn first(&self) -> Option<First> {
        let mut here = self.here(0, Number::one());
        let mut halvings = 1;
        for _ in 0..MOST_STEPS {
            let next = self.after(&here, halvings);
            let stretch = self.stretch(&here, &next, halvings);
            if self.is_free(&here, &next, &stretch) {
                if self.is_beyond_dead_centre(next.at) {
                    return Some(First::DeadCentre);
                }
                here = next;
                halvings = halvings.saturating_sub(1);
            } else if halvings < FINEST {
                halvings += 1;
            } else {
                return self.ahead(&here);
            }
            if here.at > TURN {
                return None;
            }
        }
        None
    }

    fn here(&self, at: u64, turn: Point<Interval>) -> Here {
        let distance = self.closed.distance(&turn);
        let area = root(&self.closed.room(&distance));
        let deviation = self.closed.place_with(&turn, &distance, area).v;
        Here {
            at,
            turn,
            distance,
            deviation,
        }
    }

    #[expect(
        clippy::indexing_slicing,
        reason = "no step is halved more often than the finest"
    )]
    fn after(&self, here: &Here, halvings: usize) -> Here {
        let step = &TURNS[halvings];
        let turn = if self.is_forward {
            &here.turn * step
        } else {
            &here.turn * step.conj()
        };
        self.here(here.at + (1 << (FINEST - halvings)), turn)
    }

    /// Between two angles. A function whose second derivative is at most s differs from its chord by at
    /// most s h²/8.
    fn stretch(&self, from: &Here, to: &Here, halvings: usize) -> Stretch {
        let length = f64::from(LONGEST).to_radians()
            * 0.5f64.powi(i32::try_from(halvings).unwrap_or(i32::MAX))
            * 1.000_001;
        let bulge = length * length / 8.0 * 1.000_001;
        let over = |a: &Real64, b: &Real64, second: f64| Number(a.0.hull(&b.0).widened(second));
        let turn = Number::complex(
            over(from.turn.re(), to.turn.re(), bulge),
            over(from.turn.im(), to.turn.im(), bulge),
        );
        let swing = &self.closed.swing;
        let swing = swing.re().0.magnitude() + swing.im().0.magnitude();
        let distance = over(&from.distance, &to.distance, swing * bulge * 1.000_001);
        let room = Number(self.closed.room(&distance).0.not_negative());
        let area = root(&room);
        Stretch {
            slopes: self.closed.slopes_with(&turn, &distance, &room, &area),
            deviation: self.closed.place_with(&turn, &distance, area.clone()).v,
            area,
            length,
        }
    }

    /// Whether nothing ends the arc on the stretch from `from` to `to`, or up to a dead centre on it.
    fn is_free(&self, from: &Here, to: &Here, stretch: &Stretch) -> bool {
        stretch.slopes.u.is_zero().is_no() && self.keeps_within(from, to, stretch)
    }

    fn keeps_within(&self, from: &Here, to: &Here, stretch: &Stretch) -> bool {
        let bound = self.bound.low();
        if stretch.deviation.0.magnitude() < bound {
            return true;
        }
        let ends = [from, to].map(|end| end.deviation.0.magnitude());
        if !self.is_before_dead_centre(to.at) || !ends.iter().all(|end| *end < bound) {
            return false;
        }
        if stretch.slopes.v.is_zero().is_no() {
            // It rises or falls throughout.
            return true;
        }
        // No point is farther than half of the length from an end.
        let steepest = (&stretch.slopes.v / &stretch.area).0.magnitude();
        let more = (steepest * stretch.length / 2.0).next_up().next_up();
        ends.iter().all(|end| (end + more).next_up() < bound)
    }

    fn is_before_dead_centre(&self, at: u64) -> bool {
        self.dead.is_none_or(|dead| degrees(at) < dead.low())
    }

    fn is_beyond_dead_centre(&self, at: u64) -> bool {
        self.dead.is_some_and(|dead| degrees(at) > dead.high())
    }

    /// What ends the arc a little further on.
    fn ahead(&self, here: &Here) -> Option<First> {
        let going = self.closed.slopes(&here.turn).u.sign()?;
        for halvings in (FINEST - AHEAD..=FINEST).rev() {
            let next = self.after(here, halvings);
            if !self.is_before_dead_centre(next.at) {
                return None;
            }
            let between =
                [here.at, next.at].map(|at| Rational::from((at, 1u64 << FINEST)) * LONGEST);
            let stretch = self.stretch(here, &next, halvings);
            if least_magnitude(&next.deviation) > self.bound.high() {
                let goes_on = stretch.slopes.u.is_zero().is_no();
                let has_one_sign = stretch.deviation.is_zero().is_no();
                return (goes_on && has_one_sign).then_some(First::Deviation(between));
            }
            let turned = self.closed.slopes(&next.turn).u.sign();
            if turned.is_some_and(|turned| turned != going) {
                let keeps_within = stretch.deviation.0.magnitude() < self.bound.low();
                return keeps_within.then_some(First::Reversal(between));
            }
        }
        None
    }
}

#[expect(clippy::as_conversions, reason = "exact: fewer than 53 bits")]
fn degrees(at: u64) -> f64 {
    at as f64 * f64::from(LONGEST) / (1u64 << FINEST) as f64
}

/// The root of what is not negative.
fn root(room: &Real64) -> Real64 {
    Number(room.0.not_negative()).sqrt()
}

fn least_magnitude(x: &Real64) -> f64 {
    x.0.low().max(-x.0.high())
}
