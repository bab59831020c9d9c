//! The transmission angle.

use std::cmp::Ordering;

use super::driver::{Driver, Motion, Slide, Turn};
use super::{Drive, Joint, Passage};
use crate::number::{Number, Real};
use crate::plane::Point;

impl<K: Real> Passage<K> {
    /// cos of the least and of the greatest transmission angle, over the whole turn of a link that
    /// turns fully, else over the range between the positions. Without meaning where a dead centre
    /// lies between them. `None` where it cannot be told.
    pub fn transmission(&self, drive: Drive) -> Option<[Number<K>; 2]> {
        let driver = Driver::of(self, drive)?;
        let mut cosines = match &driver.motion {
            Motion::Turn(turn) => driver.over_turn(turn)?,
            Motion::Slide(slide) => driver.over_slide(slide)?,
        }
        .into_iter();
        let first = cosines.next()?;
        let ends = cosines.fold([first.clone(), first], |[greatest, least], cosine| {
            [greater(&greatest, &cosine), lesser(&least, &cosine)]
        });
        ends.iter().all(Number::has_value).then_some(ends)
    }

    /// Whether there is a transmission angle: not between two blocks, which turn together.
    pub fn has_transmission_angle(&self) -> bool {
        let blocks =
            |joints: &[Joint<K>; 2]| matches!(joints, [Joint::Towards(_), Joint::Towards(_)]);
        !self.joints.first().is_some_and(blocks)
    }
}

impl<K: Real> Driver<K> {
    /// cos γ where it can be extreme, the driving link turning.
    fn over_turn(&self, turn: &Turn<K>) -> Option<Vec<Number<K>>> {
        let opened = self.opened(turn)?;
        let Some(gate) = opened.gate else {
            return self.cosines(turn).into_iter().collect();
        };
        let mut cosines = self.in_positions(&turn.directions, turn)?;
        // The other gate is opposite to the cut: φ = 180°.
        let directions = turn.directions.iter();
        let places: Vec<Number<K>> = directions
            .map(|direction| opened.place(direction, &turn.length))
            .collect();
        match crossed(&places, &Number::zero()) {
            Crossed::No => {}
            Crossed::Yes => {
                let [inner, outer] = self.cosines(turn);
                cosines.push(if gate == 0 { outer? } else { inner? });
            }
            Crossed::Unknown(nearest) => {
                let direction = opened.direction(&nearest).scaled(&turn.length);
                cosines.extend(self.in_positions(&[direction], turn)?);
            }
        }
        Some(cosines)
    }

    fn in_positions(&self, directions: &[Point<K>], turn: &Turn<K>) -> Option<Vec<Number<K>>> {
        let driving = directions.iter().map(|direction| match &turn.pivot {
            Some(pivot) => self.driven.cosine(&(pivot + direction)),
            None => self.driven.cosine(direction),
        });
        driving.collect()
    }

    /// cos γ where it can be extreme, A sliding.
    fn over_slide(&self, slide: &Slide<K>) -> Option<Vec<Number<K>>> {
        let at = |place: &Number<K>| {
            self.driven
                .cosine(&(&slide.origin + slide.along.scaled(place)))
        };
        let mut cosines: Vec<Number<K>> = slide.places.iter().map(at).collect::<Option<_>>()?;
        if let Some(gate) = &slide.gate {
            match crossed(&slide.places, gate) {
                Crossed::No => {}
                Crossed::Yes => cosines.push(at(gate)?),
                Crossed::Unknown(nearest) => cosines.push(at(&nearest)?),
            }
        }
        Some(cosines)
    }
}

/// Whether a place lies between others.
enum Crossed<K> {
    No,
    Yes,
    /// It nearly is the first or the last of them: the nearest to it in their range, whatever it is.
    Unknown(Number<K>),
}

fn crossed<K: Real>(places: &[Number<K>], gate: &Number<K>) -> Crossed<K> {
    let sides: Vec<Option<Ordering>> = places.iter().map(|place| place.compare(gate)).collect();
    let has = |side| sides.contains(&Some(side));
    if has(Ordering::Less) && has(Ordering::Greater) {
        return Crossed::Yes;
    }
    if !sides.contains(&None) {
        return Crossed::No;
    }
    let reduced = |of: fn(&Number<K>, &Number<K>) -> Number<K>| {
        places.iter().cloned().reduce(|a, b| of(&a, &b))
    };
    match (reduced(lesser), reduced(greater)) {
        (Some(least), Some(greatest)) => {
            Crossed::Unknown(greater(&least, &lesser(&greatest, gate)))
        }
        _ => Crossed::No,
    }
}

/// The greater of two numbers, enclosed where it cannot be told which that is.
fn greater<K: Real>(x: &Number<K>, y: &Number<K>) -> Number<K> {
    match x.compare(y) {
        Some(Ordering::Less) => y.clone(),
        Some(_) => x.clone(),
        None => (x + y + (x - y).abs()) / 2,
    }
}

/// The lesser of two numbers, enclosed where it cannot be told which that is.
fn lesser<K: Real>(x: &Number<K>, y: &Number<K>) -> Number<K> {
    match x.compare(y) {
        Some(Ordering::Less) => x.clone(),
        Some(_) => y.clone(),
        None => (x + y - (x - y).abs()) / 2,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Ball;
    use rug::Rational;

    /// About 2 and 2.1, of which it cannot be told which is the greater.
    #[test]
    fn what_cannot_be_ordered_is_enclosed_by_both() {
        let ball = |p: i32, q: i32, radius: (i32, i32)| {
            Number(Ball::with_radius(
                &Rational::from((p, q)),
                &Rational::from(radius),
                100,
            ))
        };
        let [x, y] = [ball(2, 1, (1, 2)), ball(21, 10, (1, 4))];
        for (order, ends) in [
            (greater(&x, &y), [(185, 100), (25, 10)]),
            (lesser(&x, &y), [(15, 10), (235, 100)]),
        ] {
            let [low, high] = ends.map(Rational::from);
            let (lower, upper) = (order.0.lower().unwrap(), order.0.upper().unwrap());
            assert!(lower <= low && upper >= high, "{order:?}");
            assert!(upper - lower < 2, "{order:?}");
        }
        let three = ball(3, 1, (1, 9));
        assert!(greater(&x, &three).compare(&lesser(&three, &x)).is_some());
    }
}
