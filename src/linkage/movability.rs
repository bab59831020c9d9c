//! What a four-bar can do, by signs that no tie between two lengths disturbs, and the functions whose
//! zeros bound each verdict while the linkage changes.

use std::cmp::Ordering;

use super::passage::{Drive, Passage};
use crate::number::{Kind, Number, Real, Truth};
use crate::plane::{Point, relation};

/// For the links that turn fully and for the circuits: shortest and longest link are together as long as
/// the others, or a link at a joint is as long as the next one. Where no such function vanishes, no
/// verdict changes; where one does, none need change.
pub fn limits_of_turning<K: Kind>(passage: &Passage<K>) -> Vec<Number<K>> {
    let Some([a, b, c, d]) = squared_lengths(passage) else {
        return Vec::new();
    };
    // ∏ (√a ± √b ± √c ± √d) over all signs, by (√a ± √b)² − (√c ± √d)² = e ± 2√ab ± 2√cd.
    let e = &a + &b - &c - &d;
    let product = &a * &b;
    let sums = (e.square() + 4 * &product - 4 * &c * &d).square() - 16 * e.square() * product;
    vec![sums, &a - &b, a - &c, &b - &c, b - &d, c - d]
}

/// For circuits, dead centres, and the order in which a link that rocks passes the positions: in one of
/// them three joints lie on a line.
pub fn limits_of_sides<K: Kind>(passage: &Passage<K>) -> Vec<Number<K>> {
    let [p, q] = &passage.pivots;
    let joints = passage.joints.iter();
    joints
        .flat_map(|[a, b]| [[a, b, q], [a, b, p], [p, q, a], [p, q, b]])
        .map(|[x, y, z]| relation::twice_area(x, y, z))
        .collect()
}

/// The squares of the lengths A₀A, AB, BB₀, A₀B₀.
fn squared_lengths<K: Kind>(passage: &Passage<K>) -> Option<[Number<K>; 4]> {
    let [p, q] = &passage.pivots;
    let [a, b] = passage.joints.first()?;
    Some([[p, a], [a, b], [b, q], [p, q]].map(|[x, y]| relation::distance_squared(x, y)))
}

fn less<K: Real>(x: &Number<K>, y: &Number<K>) -> Truth {
    (y - x).is_positive()
}

/// The sign of shortest + longest − the others: whichever they are, that of
/// (a + b − c − d)(a + c − b − d)(a + d − b − c), unless the lengths are equal in pairs.
fn excess<K: Real>([a, b, c, d]: &[Number<K>; 4]) -> Option<Ordering> {
    ((a + b - c - d) * (a + c - b - d) * (a + d - b - c)).sign()
}

/// Whether shortest and longest link are together shorter than the others.
fn some_link_turns<K: Real>(lengths: &[Number<K>; 4]) -> Truth {
    Truth::of_sign(excess(lengths), Ordering::is_lt)
}

/// Whether the driving link turns fully: some link does, and the shortest is this one or the base.
pub fn drive_turns<K: Real>(passage: &Passage<K>, drive: Drive) -> Truth {
    let Some(lengths) = passage.lengths() else {
        return Truth::Unknown;
    };
    let [a, b, c, d] = &lengths;
    let (driving, driven) = match drive {
        Drive::First => (a, c),
        Drive::Second => (c, a),
    };
    let shorter = |x: &Number<K>| less(x, b) & less(x, driven);
    some_link_turns(&lengths) & (shorter(driving) | shorter(d))
}

/// Whether all positions are on one circuit. Where some link turns fully, a joint that is not on the
/// shortest link never stretches or folds, and the side to which it bends is that of the circuit.
pub fn is_one_circuit<K: Real>(passage: &Passage<K>) -> Truth {
    let Some(lengths) = passage.lengths() else {
        return Truth::Unknown;
    };
    let [a, b, c, d] = &lengths;
    let shorter = |x: &Number<K>, others: [&Number<K>; 2]| less(x, others[0]) & less(x, others[1]);
    let [p, q] = &passage.pivots;
    let bends = |triple: &dyn Fn(&[Point<K>; 2]) -> Number<K>| -> Truth {
        let signs: Option<Vec<Ordering>> = passage
            .joints
            .iter()
            .map(|joints| triple(joints).sign())
            .collect();
        signs.map_or(Truth::Unknown, |signs| {
            signs.windows(2).all(|pair| pair[0] == pair[1]).into()
        })
    };
    let at_end = shorter(a, [b, c]) | shorter(d, [b, c]);
    let on_circuit = if at_end.is_yes() {
        bends(&|[a, b]| relation::twice_area(a, b, q))
    } else if (shorter(b, [a, c]) & less(b, d)).is_yes() {
        bends(&|[a, _]| relation::twice_area(q, p, a))
    } else if (shorter(c, [a, b]) | shorter(d, [a, b])).is_yes() {
        bends(&|[a, b]| relation::twice_area(p, a, b))
    } else {
        Truth::Unknown
    };
    match some_link_turns(&lengths) {
        Truth::No => Truth::of_sign(excess(&lengths), Ordering::is_gt),
        truth => truth & on_circuit,
    }
}

/// Whether four or more points of a circle are passed in this order by one turn, one way or the other:
/// the triangles of the first one and two neighbours turn alike. Not where two coincide.
pub fn in_order<K: Real>(places: &[Point<K>]) -> Truth {
    let Some((first, rest)) = places.split_first() else {
        return Truth::Yes;
    };
    let turns: Vec<Option<Ordering>> = rest
        .windows(2)
        .map(|pair| relation::twice_area(first, &pair[0], &pair[1]).sign())
        .collect();
    let all = |wanted: Ordering| {
        let is = |sign: &Option<Ordering>| Truth::of_sign(*sign, |sign| sign == wanted);
        Truth::all(turns.iter().map(is))
    };
    all(Ordering::Less) | all(Ordering::Greater)
}

/// Whether the driving link passes the positions in order, one way or the other: within one turn where it
/// turns fully; else the direction that it cannot take, away from the other pivot or towards it, lies
/// between the last position and the first.
pub fn passes_in_order<K: Real>(passage: &Passage<K>, drive: Drive) -> Truth {
    let [p, q] = &passage.pivots;
    let Some([a, b, c, d]) = passage.lengths() else {
        return Truth::Unknown;
    };
    let (pivot, other, driving, driven, place) = match drive {
        Drive::First => (p, q, a, c, 0),
        Drive::Second => (q, p, c, a, 1),
    };
    let joints = passage.joints.iter().map(|joints| joints[place].clone());
    match drive_turns(passage, drive) {
        Truth::Unknown => Truth::Unknown,
        Truth::Yes => in_order(&joints.collect::<Vec<_>>()),
        Truth::No => {
            let Some(reach) = (&driving + &d).compare(&(b + driven)) else {
                return Truth::Unknown;
            };
            let outwards = (pivot - other).scaled(&(driving / d));
            let barred = if reach.is_gt() {
                pivot + outwards
            } else {
                pivot - outwards
            };
            let places: Vec<Point<K>> = std::iter::once(barred).chain(joints).collect();
            in_order(&places)
        }
    }
}
