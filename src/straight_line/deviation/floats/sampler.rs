//! Travel and deviation of one linkage at many crank angles, in lanes.
//!
//! The [closed form](super::Closed) with its halves taken together: for q = σ/(2n), σ = 1 where B is to
//! the left and −1 where it is to the right,
//!
//! ```text
//! u + iv = (k + b/2) + (a − d/2) e + (b − d e) (σc + i√F) q.
//! ```
//!
//! For e, ie, −e, −ie the products with g, d and a − d/2 are the same four numbers each: a whole turn
//! takes a quarter of them.
//!
//! Let ε = 2⁻⁵³, ρ = |b − d e|, ω = (|c| + √F)/2n, and l, h the squares of the distances in the dead
//! centres. The errors are, to first order, at most δ = ε (n + 2|g|) for n, η = (h − l) δ/(4n√F) and a few
//! roundings for √F/2n, and for u and v
//!
//! ```text
//! ρ (ω δ/n + η) + ε (9ρω + 2|d|ω + 3|k + b/2| + 5|a − d/2|).
//! ```
//!
//! Near a dead centre, where F is not much larger than its own error (h − l) δ, more is lost.

use std::sync::LazyLock;

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, SimdFrom, dispatch, f64x4};

use super::Closed;
use crate::number::lanes::{self, LANES};
use crate::number::{Complex, Number, count};

/// Whole degrees in a right angle.
const QUARTER: usize = 90;
/// Whole degrees in a turn.
const TURN: usize = 4 * QUARTER;

/// Cosines and sines of the whole degrees from 0 to 359; those of a quarter turn more are the same
/// numbers exchanged.
pub fn whole_degrees() -> &'static [[f64; TURN]; 2] {
    static TABLE: LazyLock<[[f64; TURN]; 2]> = LazyLock::new(|| {
        let cis = |degrees: usize| {
            let (sin, cos) = count::to_f64(degrees % QUARTER).to_radians().sin_cos();
            match degrees / QUARTER {
                0 => [cos, sin],
                1 => [-sin, cos],
                2 => [-cos, -sin],
                _ => [sin, -cos],
            }
        };
        let turns: [[f64; 2]; TURN] = std::array::from_fn(cis);
        [turns.map(|[cos, _]| cos), turns.map(|[_, sin]| sin)]
    });
    &TABLE
}

/// The constants of one linkage.
#[derive(Clone, Debug)]
pub struct Sampler {
    /// k + b/2
    start: [f64; 2],
    /// a − d/2
    crank: [f64; 2],
    /// b
    base: [f64; 2],
    /// d
    arm: [f64; 2],
    /// m
    middle: f64,
    /// g
    swing: [f64; 2],
    /// Squares of the distances in both dead centres.
    dead: [f64; 2],
    /// σ/2
    half: f64,
    /// σc
    difference: f64,
}

impl Sampler {
    /// Of one linkage.
    pub fn new(closed: &Closed<f64>) -> Self {
        let pair = |z: &Number<Complex<f64>>| [z.re().0, z.im().0];
        let side = if closed.is_left { 1.0 } else { -1.0 };
        let half = Number(0.5);
        Sampler {
            start: pair(&(&closed.start + closed.base.scaled(&half))),
            crank: pair(&(&closed.crank - closed.arm.scaled(&half))),
            base: pair(&closed.base),
            arm: pair(&closed.arm),
            middle: closed.middle.0,
            swing: pair(&closed.swing),
            dead: closed.dead.each_ref().map(|x| x.0),
            half: side * 0.5,
            difference: side * closed.difference.0,
        }
    }

    /// u and v with the crank turned by so many angles, given by cosines and sines; no numbers where it
    /// does not come there. As many as the shortest slice holds.
    pub fn sample(&self, turns: [&[f64]; 2], places: [&mut [f64]; 2]) {
        self.sample_with(lanes::level(), turns, places);
    }

    /// u and v at all whole degrees from 0 to 359: what [`sample`](Self::sample) finds at those of
    /// [`whole_degrees`], to the last bit.
    pub fn sample_whole_degrees(&self, places: [&mut [f64; TURN]; 2]) {
        self.sample_whole_degrees_with(lanes::level(), places);
    }

    fn sample_with(&self, level: Level, turns: [&[f64]; 2], places: [&mut [f64]; 2]) {
        dispatch!(level, simd => Constants::new(simd, self).sample(turns, places));
    }

    fn sample_whole_degrees_with(&self, level: Level, places: [&mut [f64; TURN]; 2]) {
        dispatch!(level, simd => Constants::new(simd, self).sample_whole_degrees(places));
    }
}

/// x + iy
type Pair<S> = [f64x4<S>; 2];

/// The same constants in all lanes.
struct Constants<S: Simd> {
    simd: S,
    start: Pair<S>,
    crank: Pair<S>,
    base: Pair<S>,
    arm: Pair<S>,
    middle: f64x4<S>,
    swing: Pair<S>,
    dead: Pair<S>,
    half: f64x4<S>,
    difference: f64x4<S>,
}

impl<S: Simd> Constants<S> {
    #[inline(always)]
    fn new(simd: S, of: &Sampler) -> Self {
        let all = |[x, y]: [f64; 2]| [f64x4::splat(simd, x), f64x4::splat(simd, y)];
        Constants {
            simd,
            start: all(of.start),
            crank: all(of.crank),
            base: all(of.base),
            arm: all(of.arm),
            middle: f64x4::splat(simd, of.middle),
            swing: all(of.swing),
            dead: all(of.dead),
            half: f64x4::splat(simd, of.half),
            difference: f64x4::splat(simd, of.difference),
        }
    }

    /// u and v from n, b − d e and k + b/2 + (a − d/2) e.
    #[inline(always)]
    fn place(&self, distance: f64x4<S>, rod: Pair<S>, crank: Pair<S>) -> [[f64; LANES]; 2] {
        let quotient = self.half / distance;
        let room = (distance - self.dead[0]) * (self.dead[1] - distance);
        let bent = [self.difference * quotient, room.sqrt() * quotient];
        let moved = product(rod, bent);
        [(crank[0] + moved[0]).into(), (crank[1] + moved[1]).into()]
    }

    /// The products of g, d and a − d/2 with e.
    #[inline(always)]
    fn turned(&self, [cos, sin]: [&[f64; LANES]; 2]) -> [Pair<S>; 3] {
        let e = [
            f64x4::simd_from(self.simd, *cos),
            f64x4::simd_from(self.simd, *sin),
        ];
        [
            product(self.swing, e),
            product(self.arm, e),
            product(self.crank, e),
        ]
    }

    /// With e.
    #[inline(always)]
    fn places(&self, turn: [&[f64; LANES]; 2]) -> [[f64; LANES]; 2] {
        let [[g, _], d, a] = self.turned(turn);
        let ([b0, b1], [k0, k1]) = (self.base, self.start);
        self.place(
            self.middle - g,
            [b0 - d[0], b1 - d[1]],
            [k0 + a[0], k1 + a[1]],
        )
    }

    /// With e, ie, −e and −ie.
    #[inline(always)]
    fn places_by_quarters(&self, turn: [&[f64; LANES]; 2]) -> [[[f64; LANES]; 2]; 4] {
        let [g, d, a] = self.turned(turn);
        let (m, [b0, b1], [k0, k1]) = (self.middle, self.base, self.start);
        [
            self.place(m - g[0], [b0 - d[0], b1 - d[1]], [k0 + a[0], k1 + a[1]]),
            self.place(m + g[1], [b0 + d[1], b1 - d[0]], [k0 - a[1], k1 + a[0]]),
            self.place(m + g[0], [b0 + d[0], b1 + d[1]], [k0 - a[0], k1 - a[1]]),
            self.place(m - g[1], [b0 - d[1], b1 + d[0]], [k0 + a[1], k1 - a[0]]),
        ]
    }

    #[inline(always)]
    fn sample(&self, [cos, sin]: [&[f64]; 2], [u, v]: [&mut [f64]; 2]) {
        let ((cos, last_cos), (sin, last_sin)) = (cos.as_chunks(), sin.as_chunks());
        let ((u, last_u), (v, last_v)) = (u.as_chunks_mut(), v.as_chunks_mut());
        for ((cos, sin), (u, v)) in cos.iter().zip(sin).zip(u.iter_mut().zip(v)) {
            [*u, *v] = self.places([cos, sin]);
        }
        if last_u.is_empty() || last_v.is_empty() {
            return;
        }
        let last = self.places([&lanes::filled(last_cos), &lanes::filled(last_sin)]);
        for (places, found) in [last_u, last_v].into_iter().zip(last) {
            places
                .iter_mut()
                .zip(found)
                .for_each(|(place, x)| *place = x);
        }
    }

    #[inline(always)]
    fn sample_whole_degrees(&self, mut places: [&mut [f64; TURN]; 2]) {
        let turns = whole_degrees();
        // The last four are not the next four: two of them are found twice.
        for first in (0..QUARTER - LANES).step_by(LANES).chain([QUARTER - LANES]) {
            let turn = turns.each_ref().map(|part| four_from(part, first));
            let found = self.places_by_quarters(turn);
            for (quarter, found) in found.iter().enumerate() {
                for (places, found) in places.iter_mut().zip(found) {
                    put(places, quarter * QUARTER + first, found);
                }
            }
        }
    }
}

#[inline(always)]
fn product<S: Simd>([a, b]: Pair<S>, [x, y]: Pair<S>) -> Pair<S> {
    [a * x - b * y, a * y + b * x]
}

#[inline(always)]
fn four_from(all: &[f64; TURN], first: usize) -> &[f64; LANES] {
    let rest = all.get(first..).and_then(|rest| rest.first_chunk());
    rest.unwrap_or(&[0.0; LANES])
}

#[inline(always)]
fn put(places: &mut [f64; TURN], first: usize, found: &[f64; LANES]) {
    let rest = places.get_mut(first..);
    if let Some(four) = rest.and_then(|rest| rest.first_chunk_mut()) {
        *four = *found;
    }
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;
    use crate::number::Ball;
    use crate::straight_line::deviation::floats::tests::{driven, linkages, z};

    /// 2⁻⁵³
    const ROUNDING: f64 = f64::EPSILON / 2.0;

    #[test]
    fn samples_are_those_of_the_linkage() {
        let driven = driven();
        let [cos, sin] = whole_degrees();
        let [mut u, mut v] = [[0.0; TURN]; 2];
        Sampler::new(&driven.closed()).sample([cos, sin], [&mut u, &mut v]);
        let mut reached = 0;
        for degrees in 0..TURN {
            let Some(position) = driven.position(&z(cos[degrees], sin[degrees])) else {
                assert!(u[degrees].is_nan());
                continue;
            };
            let expected = driven.coordinates(&position).map(|x| x.0);
            assert!((u[degrees] - expected[0]).abs() < 1e-13);
            assert!((v[degrees] - expected[1]).abs() < 1e-13);
            reached += 1;
        }
        assert!(reached > 90, "{reached}");
    }

    /// No number is equal to itself if it is none.
    fn bits(places: &[[f64; TURN]; 2]) -> [[Option<u64>; TURN]; 2] {
        places.map(|part| part.map(|x| (!x.is_nan()).then_some(x.to_bits())))
    }

    #[test]
    fn every_instruction_set_finds_the_same() {
        let [cos, sin] = whole_degrees();
        for driven in linkages() {
            let sampler = Sampler::new(&driven.closed());
            let mut expected = [[0.0; TURN]; 2];
            let [u, v] = &mut expected;
            sampler.sample_with(Level::baseline(), [cos, sin], [u, v]);
            for level in lanes::levels() {
                let [mut all, mut one_by_one] = [[[0.0; TURN]; 2]; 2];
                sampler.sample_whole_degrees_with(level, all.each_mut());
                assert_eq!(bits(&all), bits(&expected), "{level:?}");
                let [u, v] = &mut one_by_one;
                for at in 0..TURN {
                    let turns = [&cos[at..=at], &sin[at..=at]];
                    sampler.sample_with(level, turns, [&mut u[at..=at], &mut v[at..=at]]);
                }
                assert_eq!(bits(&one_by_one), bits(&expected), "{level:?}");
            }
        }
    }

    /// The bound of the error, and the relative error of F.
    fn bound(closed: &Closed<f64>, cos: f64, sin: f64) -> [f64; 2] {
        let size = |z: &Number<Complex<f64>>| z.re().0.hypot(z.im().0);
        let e = z(cos, sin);
        let n = closed.distance(&e).0;
        let room = closed.room(&Number(n)).0.abs();
        let [low, high] = closed.dead.each_ref().map(|x| x.0);
        let rod = size(&(&closed.base - &closed.arm * &e));
        let sum = (closed.difference.0.abs() + room.sqrt()) / (2.0 * n);
        let of_n = ROUNDING * (n + 2.0 * size(&closed.swing));
        let of_room = (high - low) * of_n;
        let half = Number(0.5);
        let start = size(&(&closed.start + closed.base.scaled(&half)));
        let crank = size(&(&closed.crank - closed.arm.scaled(&half)));
        let bound = rod * (sum * of_n / n + of_room / (4.0 * n * room.sqrt()))
            + ROUNDING
                * (9.0 * rod * sum + 2.0 * size(&closed.arm) * sum + 3.0 * start + 5.0 * crank);
        [bound, of_room / room]
    }

    #[test]
    fn errors_are_within_the_bound() {
        let bits = 200;
        let ball = |x: f64| Number::<Ball>::rounded(&Rational::from_f64(x).unwrap(), &bits);
        let [cos, sin] = whole_degrees();
        let (mut compared, mut largest) = (0, 0.0_f64);
        for driven in linkages() {
            let closed = driven.closed();
            let exact = closed.map(|x| ball(x.0));
            let mut places = [[0.0; TURN]; 2];
            Sampler::new(&closed).sample_whole_degrees(places.each_mut());
            for degrees in 0..TURN {
                let place = exact.place(&Number::complex(ball(cos[degrees]), ball(sin[degrees])));
                let [bound, of_room] = bound(&closed, cos[degrees], sin[degrees]);
                if !place.u.has_value() || of_room > 1e-4 {
                    continue;
                }
                for (found, expected) in places.iter().zip([place.u, place.v]) {
                    let error = (ball(found[degrees]) - expected).0.midpoint_rational();
                    let share = error.unwrap().to_f64().abs() / bound;
                    assert!(share < 1.001, "{share} at {degrees} degrees of {closed:?}");
                    largest = largest.max(share);
                }
                compared += 1;
            }
        }
        assert!(compared > 1000, "{compared}");
        // A bound that is never nearly reached says little.
        assert!(largest > 0.02, "{largest}");
    }
}
