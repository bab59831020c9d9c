//! Where the crank is in a dead centre and where in line with the base: n = m − |g| cos θ with θ from
//! O_aO_b to O_aA.

use std::cmp::Ordering;

use super::arc::Limit;
use super::closed::Closed;
use crate::number::{Ball, Number};
use crate::straight_line::turning::cis;

impl Closed<Ball> {
    /// The angle to the first dead centre in degrees, more than 0; `Some(None)` where there is none,
    /// `None` where that cannot be told.
    pub fn dead_centre(&self, is_forward: bool, bits: u32) -> Option<Option<Number<Ball>>> {
        let length = self.swing.norm().sqrt();
        let mut first: Option<Number<Ball>> = None;
        for distance in &self.dead {
            let cosine = (&self.middle - distance) / &length;
            match (1 - cosine.square()).sign()? {
                Ordering::Less => continue,
                Ordering::Equal => return None,
                Ordering::Greater => {}
            }
            let angle = cosine.acos();
            for at in [-&angle, angle] {
                let step = self.way_to(at, is_forward, bits)?;
                let is_nearer = match &first {
                    Some(first) => step.compare(first)?.is_lt(),
                    None => true,
                };
                if is_nearer {
                    first = Some(step);
                }
            }
        }
        Some(first)
    }

    /// The least acute angle between the coupler and the follower O_bB on an arc, in degrees. Its
    /// cosine is linear in n, which is stationary where the crank is in line with the base.
    pub fn least_transmission(&self, arc: &[Limit; 2], bits: u32) -> Option<Number<Ball>> {
        let length = self.swing.norm().sqrt();
        let mut distances: Vec<Number<Ball>> = arc
            .iter()
            .map(|limit| self.distance(&cis(&limit.degrees, bits)))
            .collect();
        let half_turn = Number::pi(&bits);
        for (at, distance) in [
            (Number::zero(), &self.middle - &length),
            (half_turn, &self.middle + &length),
        ] {
            let inside = |is_forward: bool| {
                let way = self.way_to(at.clone(), is_forward, bits)?;
                let [backward, forward] = arc;
                let end = if is_forward { forward } else { backward };
                Some(way.compare(&end.degrees.abs())?.is_lt())
            };
            if inside(true)? || inside(false)? {
                distances.push(distance);
            }
        }
        let [low, high] = &self.dead;
        let angle = |distance: &Number<Ball>| {
            let cosine = (low + high - 2 * distance).abs() / (high - low);
            cosine.acos() * 180 / Number::pi(&bits)
        };
        let bounds = distances.iter().map(|distance| {
            let angle = angle(distance);
            Some([angle.0.lower()?, angle.0.upper()?])
        });
        let bounds: Vec<_> = bounds.collect::<Option<_>>()?;
        // The least number is between the least lower and the least upper bound, whichever it is.
        let least = bounds
            .into_iter()
            .reduce(|[a, b], [c, d]| [a.min(c), b.min(d)]);
        let [low, high] = least?;
        let middle = rug::Rational::from(&low + &high) / 2u32;
        Some(Number(Ball::with_radius(
            &middle,
            &((high - low) / 2u32),
            bits,
        )))
    }

    /// The angle in degrees from the design position to where θ has a value in radians, more than 0.
    fn way_to(&self, at: Number<Ball>, is_forward: bool, bits: u32) -> Option<Number<Ball>> {
        let whole = 2 * Number::<Ball>::pi(&bits);
        let way = at - self.start_angle(&whole);
        let way = if is_forward { way } else { -way };
        Some(within_a_turn(way, &whole)? * 360 / whole)
    }

    /// θ in the design position.
    fn start_angle(&self, whole: &Number<Ball>) -> Number<Ball> {
        let [re, im] = [self.swing.re(), self.swing.im()];
        // Not where the angle jumps.
        if re.sign() == Some(Ordering::Less) {
            (-im).atan2(&-re) + whole / 2
        } else {
            im.clone().atan2(re)
        }
    }
}

/// An angle in radians, moved by whole turns until it is more than 0 and not more than a turn.
fn within_a_turn(mut angle: Number<Ball>, whole: &Number<Ball>) -> Option<Number<Ball>> {
    for _ in 0..3 {
        if angle.sign()?.is_le() {
            angle += whole;
        } else if angle.compare(whole)?.is_gt() {
            angle -= whole;
        }
    }
    Some(angle)
}
