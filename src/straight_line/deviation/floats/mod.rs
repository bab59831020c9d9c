//! Travel and deviation in floats: many positions of one linkage, and the arcs of many linkages, each
//! with a bound of its error.

mod sampler;

use super::arc::End;
use super::closed::Closed;
use crate::number::{Complex, Number};

pub use sampler::{Sampler, whole_degrees};

/// Half a unit in the last place of 1.
const ROUNDING: f64 = f64::EPSILON / 2.0;
/// In radians.
const STEP: f64 = 0.5 * std::f64::consts::PI / 180.0;
/// Steps of a whole turn and a little more.
const STEPS: u32 = 722;
/// Secants are enough long before.
const MOST_SECANTS: usize = 200;

/// An arc on which the deviation keeps within a bound.
#[derive(Clone, Debug)]
pub struct FloatArc {
    /// Its ends, backwards and forwards.
    pub ends: [Edge; 2],
}

/// An end of it.
#[derive(Clone, Debug)]
pub struct Edge {
    /// The crank's angle from the design position, in degrees.
    pub degrees: f64,
    /// The travel.
    pub u: f64,
    /// A bound of the error of the travel.
    pub error: f64,
    /// Why it ends.
    pub end: End,
}

impl FloatArc {
    /// The travel on it, and a bound of its error.
    pub fn length(&self) -> [f64; 2] {
        let [from, to] = &self.ends;
        let length = (to.u - from.u).abs();
        [length, from.error + to.error + 2.0 * ROUNDING * length]
    }
}

/// The arc of one linkage; `None` where no end was found. Its constants and the bound are taken as
/// rounded to nearest, and the error is that against the linkage before it was rounded.
///
/// What happens and is undone again within half a degree of the crank is not seen, except for an
/// extreme of the deviation.
pub fn arc(closed: &Closed<f64>, bound: f64) -> Option<FloatArc> {
    let side = |sign: f64| {
        Side {
            closed,
            bound,
            sign,
        }
        .edge()
    };
    Some(FloatArc {
        ends: [side(-1.0)?, side(1.0)?],
    })
}

/// The arcs of many linkages, each with its bound.
pub fn arcs(linkages: &[(Closed<f64>, f64)]) -> Vec<Option<FloatArc>> {
    let of = |(closed, bound): &(Closed<f64>, f64)| arc(closed, *bound);
    linkages.iter().map(of).collect()
}

struct Side<'a> {
    closed: &'a Closed<f64>,
    bound: f64,
    sign: f64,
}

/// At one angle, in radians outwards.
#[derive(Clone, Copy)]
struct Sample {
    at: f64,
    u: f64,
    v: f64,
    /// √F times their derivatives.
    slopes: [f64; 2],
    area: f64,
    distance: f64,
}

impl Side<'_> {
    fn edge(&self) -> Option<Edge> {
        let dead = self.dead_centre();
        let mut here = self.sample(0.0);
        let going = here.slopes[0];
        for step in 1..=STEPS {
            let mut next = self.sample(f64::from(step) * STEP);
            let is_last = dead.filter(|dead| *dead <= next.at);
            if let Some(dead) = is_last {
                next = self.sample_dead(dead);
            }
            let turned = next.slopes[0] * going < 0.0;
            if turned {
                next = self.zero(here, next, |sample| sample.slopes[0]);
            }
            if let Some(crossing) = self.crossing(here, next) {
                return Some(self.found(&crossing, End::Deviation));
            }
            if turned {
                return Some(self.found(&next, End::Reversal));
            }
            if is_last.is_some() {
                return Some(self.found(&next, End::DeadCentre));
            }
            here = next;
        }
        None
    }

    /// Where the deviation reaches the bound between two angles, also if it comes back.
    fn crossing(&self, from: Sample, mut to: Sample) -> Option<Sample> {
        if to.v.abs() <= self.bound {
            if from.slopes[1] * to.slopes[1] >= 0.0 {
                return None;
            }
            to = self.zero(from, to, |sample| sample.slopes[1]);
            if to.v.abs() <= self.bound {
                return None;
            }
        }
        let edge = self.bound.copysign(to.v);
        Some(self.zero(from, to, |sample| sample.v - edge))
    }

    fn turn(&self, at: f64) -> Number<Complex<f64>> {
        let (sin, cos) = (self.sign * at).sin_cos();
        Number::complex(Number(cos), Number(sin))
    }

    fn sample(&self, at: f64) -> Sample {
        let distance = self.closed.distance(&self.turn(at));
        self.sample_with(at, distance.0)
    }

    /// In a dead centre, where the distance is known better than from the angle.
    fn sample_dead(&self, at: f64) -> Sample {
        let distance = self.closed.distance(&self.turn(at)).0;
        let [low, high] = self.closed.dead.each_ref().map(|x| x.0);
        let is_low = (distance - low).abs() < (distance - high).abs();
        self.sample_with(at, if is_low { low } else { high })
    }

    fn sample_with(&self, at: f64, distance: f64) -> Sample {
        let (turn, n) = (self.turn(at), Number(distance));
        // Just before a dead centre rounding may lead beyond it.
        let room = Number(self.closed.room(&n).0.max(0.0));
        let area = Number(room.0.sqrt());
        let slopes = self.closed.slopes_with(&turn, &n, &room, &area);
        let place = self.closed.place_with(&turn, &n, area);
        Sample {
            at,
            u: place.u.0,
            v: place.v.0,
            slopes: [slopes.u.0, slopes.v.0],
            area: place.area.0,
            distance,
        }
    }

    /// A zero of a function between two angles where it has different signs, by secants of which the
    /// end that stays counts half.
    fn zero(&self, from: Sample, to: Sample, f: impl Fn(&Sample) -> f64) -> Sample {
        let [mut low, mut high] = [from, to];
        let [mut below, mut above] = [f(&low), f(&high)];
        for _ in 0..MOST_SECANTS {
            let secant = low.at + (high.at - low.at) * (below / (below - above));
            let is_inside = secant > low.at && secant < high.at;
            let middle = if is_inside {
                secant
            } else {
                (low.at + high.at) / 2.0
            };
            if middle <= low.at || middle >= high.at {
                break;
            }
            let sample = self.sample(middle);
            let value = f(&sample);
            if value == 0.0 {
                return sample;
            }
            if (value < 0.0) == (below < 0.0) {
                (low, below) = (sample, value);
                above /= 2.0;
            } else {
                (high, above) = (sample, value);
                below /= 2.0;
            }
            if high.at - low.at <= 2.0 * ROUNDING * high.at {
                break;
            }
        }
        high
    }

    /// The angle to the first dead centre, in radians outwards.
    fn dead_centre(&self) -> Option<f64> {
        let whole = 2.0 * std::f64::consts::PI;
        let [re, im] = [self.closed.swing.re().0, self.closed.swing.im().0];
        let start = im.atan2(re);
        let cosine = |distance: &Number<f64>| (self.closed.middle.0 - distance.0) / re.hypot(im);
        let angles = self.closed.dead.iter().map(cosine);
        let both = angles
            .filter(|cosine| cosine.abs() <= 1.0)
            .flat_map(|cosine| {
                let angle = cosine.acos();
                [angle, -angle]
            });
        both.map(|angle| (self.sign * (angle - start)).rem_euclid(whole))
            .min_by(f64::total_cmp)
    }

    fn found(&self, sample: &Sample, end: End) -> Edge {
        Edge {
            degrees: (self.sign * sample.at).to_degrees(),
            u: sample.u,
            error: self.error(sample, end),
            end,
        }
    }

    /// A bound of the error of the travel at an end: what rounding does to u at this angle, and what
    /// the error of the angle does.
    fn error(&self, sample: &Sample, end: End) -> f64 {
        let of_place = self.error_of_place(sample, end == End::DeadCentre);
        let [du, dv] = sample.slopes.map(|slope| (slope / sample.area).abs());
        match end {
            // There u is stationary.
            End::Reversal => 2.0 * of_place,
            End::Deviation => {
                let of_angle = 2.0 * (of_place + 4.0 * ROUNDING * self.bound) / dv
                    + 4.0 * ROUNDING * sample.at;
                of_place + du * of_angle
            }
            End::DeadCentre => of_place + self.error_of_dead_centre(sample),
        }
    }

    /// Of u and v at an angle that is exact.
    fn error_of_place(&self, sample: &Sample, is_dead: bool) -> f64 {
        let closed = self.closed;
        let size = |z: &Number<Complex<f64>>| z.re().0.hypot(z.im().0);
        let [start, crank, arm, base] =
            [&closed.start, &closed.crank, &closed.arm, &closed.base].map(size);
        let (n, c) = (sample.distance, closed.difference.0.abs());
        let [low, high] = closed.dead.each_ref().map(|x| x.0);
        let of_n = ROUNDING * (3.0 * closed.middle.0 + 6.0 * size(&closed.swing));
        let of_factors = [low, high].map(|dead| of_n + ROUNDING * (2.0 * dead + n));
        let of_room = (high - n).abs() * of_factors[0]
            + (n - low).abs() * of_factors[1]
            + ROUNDING * sample.area * sample.area;
        let of_area = if is_dead {
            0.0
        } else {
            (of_room / (2.0 * sample.area)).min(of_room.sqrt()) + ROUNDING * sample.area
        };
        let [along, across] = [(n + closed.difference.0).abs(), sample.area].map(|x| x / (2.0 * n));
        let of_along = c * (of_n / n + ROUNDING) / (2.0 * n) + 3.0 * ROUNDING * along;
        let of_across = of_area / (2.0 * n) + across * (of_n / n + 2.0 * ROUNDING);
        let rod = size(&(&closed.base - &closed.arm * self.turn(sample.at)));
        let of_rod = ROUNDING * (2.0 * base + 6.0 * arm);
        let product = rod * (along + across);
        rod * (of_along + of_across)
            + (along + across) * of_rod
            + ROUNDING * (5.0 * start + 9.0 * crank + 7.0 * product)
    }

    /// Of u by the error of the angle, with F = 0 kept.
    fn error_of_dead_centre(&self, sample: &Sample) -> f64 {
        let closed = self.closed;
        let size = |z: &Number<Complex<f64>>| z.re().0.hypot(z.im().0);
        let (n, swing) = (sample.distance, size(&closed.swing));
        let cosine = (closed.middle.0 - n) / swing;
        let sine = ((1.0 - cosine) * (1.0 + cosine)).max(0.0).sqrt();
        let of_cosine = ROUNDING * (4.0 * (closed.middle.0 + n) / swing + 4.0);
        let of_angle = of_cosine / sine + 12.0 * ROUNDING * std::f64::consts::PI;
        let along = (n + closed.difference.0).abs() / (2.0 * n);
        let along_rate = closed.difference.0.abs() * swing * sine / (2.0 * n * n);
        let rod = size(&(&closed.base - &closed.arm * self.turn(sample.at)));
        (size(&closed.crank) + size(&closed.arm) * along + rod * along_rate) * of_angle
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linkage::cognates::CouplerPoint;
    use crate::number::Ball;
    use crate::straight_line::design::Design;
    use crate::straight_line::deviation::driven::Driven;
    use rug::Rational;

    pub(super) fn z(x: f64, y: f64) -> Number<Complex<f64>> {
        Number::complex(Number(x), Number(y))
    }

    fn linkage([o_a, o_b, a, b, d]: [[f64; 2]; 5]) -> Driven<f64> {
        let point = |[x, y]: [f64; 2]| z(x, y);
        Driven::new(&Design {
            linkage: CouplerPoint {
                pivots: [point(o_a), point(o_b)],
                pins: [point(a), point(b)],
                point: point(d),
            },
            direction: z(0.3, -0.8),
        })
        .unwrap()
    }

    pub(super) fn driven() -> Driven<f64> {
        linkage([[0.1, 0.2], [3.0, -0.4], [0.9, 1.3], [2.1, 2.2], [1.7, 2.9]])
    }

    /// On either side, of which the crank turns fully or does not, the last far from the origin.
    pub(super) fn linkages() -> [Driven<f64>; 4] {
        [
            driven(),
            linkage([[0.1, 0.2], [3.0, -0.4], [0.9, 1.3], [2.1, -2.2], [7.7, 2.9]]),
            linkage([[0.0, 0.0], [4.0, 0.3], [0.7, 0.8], [3.1, 3.2], [1.2, 5.9]]),
            linkage([
                [100.0, 0.0],
                [104.0, 0.3],
                [99.3, 0.8],
                [103.1, -3.2],
                [101.2, 1.9],
            ]),
        ]
    }

    #[test]
    fn slopes_are_derivatives() {
        let closed = driven().closed();
        let turn = |at: f64| z(at.cos(), at.sin());
        for at in [-0.4, 0.0, 0.3, 0.5] {
            let step = 1e-6;
            let [before, after] = [-step, step].map(|step| closed.place(&turn(at + step)));
            let slopes = closed.slopes(&turn(at));
            let area = closed.place(&turn(at)).area.0;
            for (slope, difference) in [
                (slopes.u.0, after.u.0 - before.u.0),
                (slopes.v.0, after.v.0 - before.v.0),
            ] {
                assert!((slope / area - difference / (2.0 * step)).abs() < 1e-7);
            }
        }
    }

    #[test]
    fn an_arc_keeps_within_its_bound() {
        let closed = driven().closed();
        let arc = arc(&closed, 0.05).unwrap();
        for edge in &arc.ends {
            let at = edge.degrees.to_radians();
            let place = closed.place(&z(at.cos(), at.sin()));
            if edge.end == End::Deviation {
                assert!((place.v.0.abs() - 0.05).abs() < 1e-13, "{edge:?}");
            }
            assert!(
                (place.u.0 - edge.u).abs() <= 1e-7 && edge.error < 1e-12,
                "{edge:?}"
            );
        }
        let [length, error] = arc.length();
        assert!(length > 0.0 && error < 1e-12);
    }

    /// Balls of as many bits carry their errors along by themselves.
    #[test]
    fn the_error_of_a_place_is_about_that_of_balls() {
        let exact = |x: f64| Number::<Ball>::rounded(&Rational::from_f64(x).unwrap(), &53);
        let mut ratios = Vec::new();
        for driven in linkages() {
            let closed = driven.closed();
            let enclosed = closed.map(|x| exact(x.0));
            let side = Side {
                closed: &closed,
                bound: 1.0,
                sign: 1.0,
            };
            for step in -20..=20 {
                let at = f64::from(step) * 0.02;
                let sample = side.sample(at);
                let angle = exact(at);
                let turn = Number::complex(angle.clone().cos(), angle.sin());
                let place = enclosed.place(&turn);
                let ends = [&place.u, &place.v].map(|x| Some((x.0.lower()?, x.0.upper()?)));
                let [Some(u), Some(v)] = ends else { continue };
                let radius = [u, v].map(|(low, high)| (high - low).to_f64() / 2.0);
                ratios.push(side.error_of_place(&sample, false) / radius[0].max(radius[1]));
            }
        }
        ratios.sort_by(f64::total_cmp);
        let [least, greatest] = [ratios[0], ratios[ratios.len() - 1]];
        assert!(
            least > 4.0 && greatest < 16.0,
            "{least} to {greatest} of {}",
            ratios.len()
        );
        assert!(ratios.len() > 100, "{}", ratios.len());
    }
}
