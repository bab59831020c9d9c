//! The elementary functions of an enclosure.
//!
//! Monotone functions take the ends of the ball with directed rounding; sine and cosine take the
//! midpoint and a bound of the slope. A `None` says that no number of the ball is in the domain.

use std::cmp::Ordering;

use rug::Float;
use rug::float::{Constant, Round};

use super::enclosure::Enclosure;
use super::radius::Radius;

/// A function of MPFR, in place with a direction of rounding.
pub(super) type Rounded = fn(&mut Float, Round) -> Ordering;

impl Enclosure {
    /// π.
    pub fn pi(precision: u32) -> Enclosure {
        Enclosure::from_rounded(Float::with_val_round(
            precision,
            Constant::Pi,
            Round::Nearest,
        ))
    }

    pub fn sin(&mut self) {
        self.wave(Float::sin_round, Radius::ONE);
    }

    /// The slope is at most |x|, which matters near 0.
    pub fn cos(&mut self) {
        self.wave(Float::cos_round, self.farthest().min(Radius::ONE));
    }

    /// Sine or cosine, whose slope on the ball is at most `slope`.
    fn wave(&mut self, function: Rounded, slope: Radius) {
        if self.radius.exponent() > 2 || self.is_too_far_to_reduce() {
            *self = Enclosure::unit_interval(self.precision());
            return;
        }
        self.radius = self.radius.times(slope);
        let rounding = function(&mut self.mid, Round::Nearest);
        self.absorb(rounding);
        if self.radius.exponent() > -8 {
            self.clip_to_unit_interval();
        }
    }

    fn clip_to_unit_interval(&mut self) {
        let (low, high) = self.ends();
        if low < -1 || high > 1 {
            let (low, high) = (at_least(low, -1), at_most(high, 1));
            *self = Enclosure::hull(&low, &high, self.precision());
        }
    }

    /// The whole line where the ball may hold a pole.
    pub fn tan(&mut self) {
        if self.radius.exponent() > 2 || self.is_too_far_to_reduce() {
            *self = Enclosure::whole_line(self.precision());
        } else if self.radius.is_zero() || self.lies_between_poles() {
            self.increasing(Float::tan_round);
        } else {
            *self = Enclosure::whole_line(self.precision());
        }
    }

    /// Zeros of the cosine are π apart and it changes sign at each: none lies in an interval
    /// shorter than 3 with equal signs at its ends.
    fn lies_between_poles(&self) -> bool {
        let (low, high) = self.ends();
        let (width, _) = Float::with_val_round(32, &high - &low, Round::Up);
        let [low, high] = [low, high].map(|end| Float::with_val(32, end.cos_ref()).cmp0());
        width < 3 && low == high && low != Some(Ordering::Equal)
    }

    pub fn atan(&mut self) {
        self.increasing(Float::atan_round);
    }

    pub fn asin(&mut self) -> Option<()> {
        self.inverse_of_wave(Float::asin_round, Enclosure::increasing_hull)
    }

    pub fn acos(&mut self) -> Option<()> {
        self.inverse_of_wave(Float::acos_round, |function, low, high, precision| {
            Enclosure::increasing_hull(function, high, low, precision)
        })
    }

    /// arcsin or arccos on what the ball shares with [−1, 1].
    fn inverse_of_wave(
        &mut self,
        function: Rounded,
        hull: fn(Rounded, Float, Float, u32) -> Enclosure,
    ) -> Option<()> {
        let (low, high) = self.ends();
        if low > 1 || high < -1 {
            return None;
        }
        if self.radius.is_zero() {
            let rounding = function(&mut self.mid, Round::Nearest);
            self.absorb(rounding);
        } else {
            let (low, high) = (at_least(low, -1), at_most(high, 1));
            *self = hull(function, low, high, self.precision());
        }
        Some(())
    }

    /// An increasing function of the ball, all of which is in its domain.
    fn increasing(&mut self, function: Rounded) {
        if self.radius.is_zero() {
            let rounding = function(&mut self.mid, Round::Nearest);
            self.absorb(rounding);
        } else {
            let (low, high) = self.ends();
            *self = Enclosure::increasing_hull(function, low, high, self.precision());
        }
    }

    /// The hull of the values at `low`, rounded down, and at `high`, rounded up.
    fn increasing_hull(
        function: Rounded,
        mut low: Float,
        mut high: Float,
        precision: u32,
    ) -> Enclosure {
        function(&mut low, Round::Down);
        function(&mut high, Round::Up);
        Enclosure::hull(&low, &high, precision)
    }

    /// The angle of the directions (x, y), `self` being y; `None` if both are exactly zero.
    ///
    /// The angle is monotone along every edge of the rectangle, so its extremes are at corners.
    pub fn atan2(&mut self, x: &Enclosure) -> Option<()> {
        if self.is_exactly_zero() && x.is_exactly_zero() {
            return None;
        }
        let precision = self.precision().max(x.precision());
        let (low_y, high_y) = self.ends();
        // MPFR's atan2 knows a negative zero, on the other side of the cut.
        let (low_y, high_y) = (unsigned_zero(low_y), unsigned_zero(high_y));
        let (low_x, high_x) = x.ends();
        let choose = |condition: bool, yes, no| if condition { yes } else { no };
        let (least, greatest) = if low_y > 0 || low_y == 0 && (low_x > 0 || high_x < 0) {
            // The upper half plane, with the axis where the origin is not on it.
            (
                (choose(high_x >= 0, &low_y, &high_y), &high_x),
                (choose(low_x >= 0, &high_y, &low_y), &low_x),
            )
        } else if high_y < 0 {
            (
                (choose(low_x >= 0, &low_y, &high_y), &low_x),
                (choose(high_x >= 0, &high_y, &low_y), &high_x),
            )
        } else if low_x > 0 {
            (
                (&low_y, choose(low_y >= 0, &high_x, &low_x)),
                (&high_y, choose(high_y >= 0, &low_x, &high_x)),
            )
        } else {
            *self = Enclosure::full_turn(precision);
            return Some(());
        };
        *self = corner_hull(least, greatest, precision);
        Some(())
    }

    /// [−π, π].
    fn full_turn(precision: u32) -> Enclosure {
        Enclosure {
            mid: Float::new(precision),
            radius: Enclosure::pi(32).farthest(),
        }
    }

    /// Whether reducing the angle would take a π far longer than the ball itself.
    fn is_too_far_to_reduce(&self) -> bool {
        let limit = 4 * i64::from(self.precision()) + (1 << 16);
        self.mid
            .get_exp()
            .is_some_and(|exponent| i64::from(exponent) > limit)
    }
}

/// The hull of the angles at two corners (y, x).
fn corner_hull(least: (&Float, &Float), greatest: (&Float, &Float), precision: u32) -> Enclosure {
    let guarded = least.0.prec().max(least.1.prec());
    if least == greatest {
        let (y, x) = least;
        return Enclosure::from_rounded(Float::with_val_round(
            precision,
            y.atan2_ref(x),
            Round::Nearest,
        ));
    }
    let (low, _) = Float::with_val_round(guarded, least.0.atan2_ref(least.1), Round::Down);
    let (high, _) = Float::with_val_round(guarded, greatest.0.atan2_ref(greatest.1), Round::Up);
    Enclosure::hull(&low, &high, precision)
}

fn unsigned_zero(x: Float) -> Float {
    if x.is_zero() { x.abs() } else { x }
}

fn at_least(x: Float, bound: i32) -> Float {
    if x < bound {
        Float::with_val(x.prec(), bound)
    } else {
        x
    }
}

fn at_most(x: Float, bound: i32) -> Float {
    if x > bound {
        Float::with_val(x.prec(), bound)
    } else {
        x
    }
}
