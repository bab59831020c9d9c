//! How a four-bar passes through given positions: its type, whether it reaches all of them without
//! being taken apart, in which order, and with which transmission angles. All by signs of exact
//! expressions, none by sampling.

use std::cmp::Ordering;

use crate::number::{Number, Real};
use crate::plane::{Point, relation};

/// A four-bar A₀ABB₀ with its joints A, B in each of several positions.
#[derive(Clone, Debug)]
pub struct Passage<K> {
    /// A₀ and B₀.
    pub pivots: [Point<K>; 2],
    /// A and B in each position.
    pub joints: Vec<[Point<K>; 2]>,
}

/// What the links can do (Grashof): the shortest and the longest together are shorter than the others
/// together, or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// The link at A₀ or at B₀ is the shortest and turns fully; the other one rocks.
    CrankAndLever,
    /// The base is the shortest; both links turn fully.
    DragLink,
    /// The coupler is the shortest and turns fully; both links rock.
    GrashofDoubleLever,
    /// No link turns fully against another.
    DoubleLever,
    /// The sums are equal: all links can lie on one line.
    ChangePoint,
}

/// Which of the two links at the base drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Drive {
    /// The link A₀A.
    First,
    /// The link B₀B.
    Second,
}

impl<K: Real> Passage<K> {
    /// The same linkage with A and B exchanged.
    fn exchanged(&self) -> Self {
        let [a, b] = &self.pivots;
        let joints = self.joints.iter().map(|[a, b]| [b.clone(), a.clone()]);
        Passage {
            pivots: [b.clone(), a.clone()],
            joints: joints.collect(),
        }
    }

    fn seen_from(&self, drive: Drive) -> Self {
        match drive {
            Drive::First => self.clone(),
            Drive::Second => self.exchanged(),
        }
    }

    /// The lengths A₀A, AB, BB₀, A₀B₀; no value where the kind does not hold the roots.
    pub fn lengths(&self) -> Option<[Number<K>; 4]> {
        let [p, q] = &self.pivots;
        let [a, b] = self.joints.first()?;
        Some([
            relation::distance(p, a),
            relation::distance(a, b),
            relation::distance(b, q),
            relation::distance(p, q),
        ])
    }

    /// The place of the shortest length and the sign of shortest + longest − the others; `None` where
    /// it cannot be told.
    fn grashof(&self) -> Option<(usize, Ordering)> {
        let lengths = self.lengths()?;
        let extreme = |wanted: Ordering| {
            let mut best = 0;
            for place in 1..4 {
                if lengths.get(place)?.compare(lengths.get(best)?)? == wanted {
                    best = place;
                }
            }
            Some(best)
        };
        let (shortest, longest) = (extreme(Ordering::Less)?, extreme(Ordering::Greater)?);
        let sum: Number<K> = lengths.iter().cloned().sum();
        let extremes = lengths.get(shortest)? + lengths.get(longest)?;
        Some((shortest, (2 * extremes).compare(&sum)?))
    }

    /// The type; `None` where it cannot be told.
    pub fn link_type(&self) -> Option<Type> {
        Some(match self.grashof()? {
            (_, Ordering::Equal) => Type::ChangePoint,
            (_, Ordering::Greater) => Type::DoubleLever,
            (0 | 2, Ordering::Less) => Type::CrankAndLever,
            (1, Ordering::Less) => Type::GrashofDoubleLever,
            (_, Ordering::Less) => Type::DragLink,
        })
    }

    /// Whether the driving link turns fully; `None` where it cannot be told.
    pub fn is_crank(&self, drive: Drive) -> Option<bool> {
        match self.seen_from(drive).grashof()? {
            (0 | 3, Ordering::Less) => Some(true),
            (_, Ordering::Equal) => None,
            _ => Some(false),
        }
    }

    /// For each position the side on which the joint B lies of the line from A to B₀, while A₀A drives:
    /// it changes only where A, B, B₀ are on a line, and there the drive is dead.
    pub fn assembly(&self, drive: Drive) -> Option<Vec<Ordering>> {
        let passage = self.seen_from(drive);
        let [_, q] = &passage.pivots;
        let joints = passage.joints.iter();
        joints
            .map(|[a, b]| relation::twice_area(a, b, q).sign())
            .collect()
    }

    /// For each position a sign that is the same throughout a circuit and different on the two of
    /// them; of one circuit only, zeros. `None` where it cannot be told.
    ///
    /// Where one link turns fully, the angle in a joint that is not on that link never comes to 0 or
    /// 180°, and its sign is that of the circuit.
    pub fn circuit(&self) -> Option<Vec<Ordering>> {
        let [p, q] = &self.pivots;
        let (shortest, sum) = self.grashof()?;
        match sum {
            Ordering::Greater => return Some(vec![Ordering::Equal; self.joints.len()]),
            Ordering::Equal => return None,
            Ordering::Less => {}
        }
        let joints = self.joints.iter();
        joints
            .map(|[a, b]| {
                match shortest {
                    0 | 3 => relation::twice_area(a, b, q),
                    1 => relation::twice_area(q, p, a),
                    _ => relation::twice_area(p, a, b),
                }
                .sign()
            })
            .collect()
    }

    /// The places of the positions in the order in which the driving link passes them, turning
    /// counterclockwise: from the first position on where it turns fully, from one end of its range
    /// to the other where it rocks. `None` where it cannot be told.
    pub fn order(&self, drive: Drive) -> Option<Vec<usize>> {
        let passage = self.seen_from(drive);
        let [p, q] = &passage.pivots;
        let from = if self.is_crank(drive)? {
            passage.joints.first()?[0].clone() - p
        } else {
            // A direction that a link that rocks cannot take: away from the other pivot or towards it.
            let [a, b, c, d] = passage.lengths()?;
            if (&a + &d).compare(&(b + c))?.is_gt() {
                p - q
            } else {
                q - p
            }
        };
        // Angles from there, in one turn.
        let mut turned = Vec::new();
        for (place, [a, _]) in passage.joints.iter().enumerate() {
            turned.push((place, (a - p) * from.conj()));
        }
        let mut sorted: Vec<(usize, Point<K>)> = Vec::new();
        for (place, direction) in turned {
            let mut at = sorted.len();
            for (index, (_, other)) in sorted.iter().enumerate() {
                if compare_angles(&direction, other)?.is_lt() {
                    at = index;
                    break;
                }
            }
            sorted.insert(at, (place, direction));
        }
        Some(sorted.into_iter().map(|(place, _)| place).collect())
    }

    /// cos of the least and of the greatest transmission angle, between coupler and driven link, over
    /// the whole turn of a link that turns fully, else over the range between the positions.
    pub fn transmission(&self, drive: Drive) -> Option<[Number<K>; 2]> {
        let passage = self.seen_from(drive);
        let [p, q] = &passage.pivots;
        let [a, b, c, d] = passage.lengths()?;
        let mut squares: Vec<Number<K>> = Vec::new();
        let (inner, outer) = ((&d - &a).square(), (&d + &a).square());
        if self.is_crank(drive)? {
            squares.extend([inner, outer]);
        } else {
            let mut sides = Vec::new();
            for [joint, _] in &passage.joints {
                squares.push(relation::distance_squared(joint, q));
                sides.push(relation::twice_area(p, q, joint).sign()?);
            }
            let crosses = sides.contains(&Ordering::Less) && sides.contains(&Ordering::Greater);
            if crosses {
                // The base line is passed where the link can take that direction.
                let reaches_out = !(&a + &d).compare(&(&b + &c))?.is_gt();
                squares.push(if reaches_out { outer } else { inner });
            }
        }
        let cosine = |square: &Number<K>| (b.square() + c.square() - square) / (2 * &b * &c);
        let extreme = |wanted: Ordering| {
            let mut best = squares.first()?;
            for square in squares.iter().skip(1) {
                if square.compare(best)? == wanted {
                    best = square;
                }
            }
            Some(cosine(best))
        };
        Some([extreme(Ordering::Less)?, extreme(Ordering::Greater)?])
    }
}

/// The order of two angles in [0, 2π).
fn compare_angles<K: Real>(u: &Point<K>, v: &Point<K>) -> Option<Ordering> {
    let half = |z: &Point<K>| -> Option<u8> {
        Some(match z.im().sign()? {
            Ordering::Greater => 0,
            Ordering::Less => 1,
            Ordering::Equal if z.re().sign()?.is_gt() => 0,
            Ordering::Equal => 1,
        })
    };
    match half(u)?.cmp(&half(v)?) {
        Ordering::Equal => Some((u.conj() * v).im().sign()?.reverse()),
        order => Some(order),
    }
}
