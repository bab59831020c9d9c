//! Five positions by independent routes: the conics, two circlepoint curves, loop closure.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use crate::support::positions::{
    Position, degenerate, numbers, point, points, position, positions, turn, turns,
};
use crate::support::seed::rounds;
use burmester::finite::five_positions::certified::certified;
use burmester::finite::five_positions::conditions::{of_pair, of_slide};
use burmester::finite::five_positions::conics::{Isolated, Pair, Pairs, pairs};
use burmester::finite::five_positions::{circlepoint_curves, loop_closure};
use burmester::number::univariate::Polynomial;
use burmester::number::{Ball, Complex, Exact, Kind, Number, Truth};
use burmester::plane::displacement::Displacement;
use burmester::plane::{Point, line, relation};
use proptest::prelude::*;

type Five = [Position; 5];

const DIRECTIONS: [[i64; 2]; 3] = [[1, 0], [3, 7], [-5, 2]];
/// The positions in other orders: all that matters is which three come first.
const ORDERS: [[usize; 5]; 10] = [
    [0, 1, 2, 3, 4],
    [0, 1, 3, 2, 4],
    [0, 1, 4, 2, 3],
    [0, 2, 3, 1, 4],
    [0, 2, 4, 1, 3],
    [0, 3, 4, 1, 2],
    [1, 2, 3, 0, 4],
    [1, 2, 4, 0, 3],
    [1, 3, 4, 0, 2],
    [2, 3, 4, 0, 1],
];

fn in_order(five: &Five, order: [usize; 5]) -> Five {
    order.map(|place| five[place].clone())
}

fn isolated(five: &Five) -> Option<Isolated> {
    match pairs(five)? {
        Pairs::Isolated(isolated) => Some(*isolated),
        Pairs::Families(_) => None,
    }
}

fn proportional(a: &Polynomial<Complex<Exact>>, b: &Polynomial<Complex<Exact>>) -> Truth {
    let pairs = (0..5).flat_map(|i| (0..i).map(move |j| (i, j)));
    let minor = |(i, j)| a.coefficient(i) * b.coefficient(j) - a.coefficient(j) * b.coefficient(i);
    let same = Truth::all(pairs.map(|pair| minor(pair).is_zero()));
    same & Truth::from(!a.is_zero() && !b.is_zero())
}

/// The same up to a factor, as far as enclosures tell, and as often.
fn may_be_same<K: Kind>(a: &Pair<K>, b: &Pair<K>) -> bool {
    let minor = |i: usize, j: usize| &a.coordinates[i] * &b.coordinates[j];
    let places = (0..7).flat_map(|i| (0..i).map(move |j| (i, j)));
    let vanish = places.map(|(i, j)| (minor(i, j) - minor(j, i)).is_zero());
    !Truth::all(vanish).is_no() && a.place == b.place && a.multiplicity == b.multiplicity
}

fn may_be_all<K: Kind>(found: &[Pair<K>], known: &[Pair<K>], same: Same<K>) -> bool {
    let among = |one: &Pair<K>, all: &[Pair<K>]| all.iter().any(|other| same(one, other));
    found.len() == known.len()
        && found.iter().all(|pair| among(pair, known))
        && known.iter().all(|pair| among(pair, found))
}

type Same<K> = fn(&Pair<K>, &Pair<K>) -> bool;

/// Of a couple of conjugate pairs either one may be given.
fn may_be_same_couple(a: &Pair<Complex<Ball>>, b: &Pair<Complex<Ball>>) -> bool {
    let conjugate = Pair {
        coordinates: b.coordinates.each_ref().map(Number::conj),
        ..b.clone()
    };
    may_be_same(a, b) || may_be_same(a, &conjugate)
}

/// The quick way to enclosures finds what the exact one does, to as many bits as are asked for.
fn check_certified(five: &Five, bits: u32) -> Result<(), TestCaseError> {
    let (known, found) = (isolated(five), certified(five, bits));
    prop_assert_eq!(known.is_some(), found.is_some(), "{} bits", bits);
    let (Some(known), Some(found)) = (known, found) else {
        return Ok(());
    };
    let [real, complex] = [
        may_be_all(&found.real, &known.real(bits), may_be_same),
        may_be_all(&found.complex, &known.complex(bits), may_be_same_couple),
    ];
    prop_assert!(
        real && complex,
        "real: {}, complex: {}, {} bits",
        real,
        complex,
        bits
    );
    let sharp = |x: &Number<Ball>| x.0.accuracy_bits() >= Some(i64::from(bits));
    let mut coordinates = found.real.iter().flat_map(|pair| &pair.coordinates);
    prop_assert!(
        coordinates.all(|x| !x.is_zero().is_no() || sharp(x)),
        "{:?}",
        found.real
    );
    Ok(())
}

/// The origin lies so near to a center that most digits of its coordinates cancel.
#[test]
fn certified_pairs_have_the_bits_asked_for() {
    let placed = |x: i64, y: i64, p: i64, q: i64| {
        let point = |x: i64, y: i64| Point::<Exact>::complex(x.into(), y.into());
        let turn = point(p, q);
        let rotation = turn.square().scaled(&turn.norm().inverse());
        Displacement {
            rotation,
            translation: point(x, y),
        }
    };
    let five = [
        placed(0, 0, 1, 0),
        placed(3, 1, 5, 1),
        placed(5, 1, 3, 1),
        placed(6, -1, 3, 2),
        placed(5, -4, 1, 1),
    ];
    let center = {
        let found = certified(&five, 400).expect("there are pairs");
        let [h, _, _, cx, cy, ..] = &found.real.first().expect("some are real").coordinates;
        [cx / h, cy / h].map(|x| Number::<Exact>::from(x.0.midpoint_rational().expect("finite")))
    };
    let [x, y] = center;
    let near = Number::complex(x, y);
    let five = five.map(|position| Displacement {
        translation: position.translation - &near,
        ..position
    });
    check_certified(&five, 100).expect("it has the bits");
}

/// How many comparisons of the circlepoints and of the turns were made, in so many orders.
fn compared(five: &Five, orders: usize) -> Result<[usize; 2], TestCaseError> {
    let mut made = [0, 0];
    let Some(isolated) = isolated(five) else {
        return Ok(made);
    };
    for order in ORDERS.into_iter().take(orders) {
        let five = in_order(five, order);
        for direction in DIRECTIONS.into_iter().take(orders.min(3)) {
            let Some(curves) = circlepoint_curves::circlepoints(&five, direction) else {
                continue;
            };
            let conics = isolated.circlepoints(direction).unwrap();
            prop_assert_eq!(
                conics.to_string(),
                curves.to_string(),
                "{:?} {:?}",
                order,
                direction
            );
            made[0] += 1;
        }
        if let Some(turns) = loop_closure::turns(&five) {
            let conics = isolated.turns([&five[0], &five[1]]);
            // A link without length, from a pole of the two to itself, has no turn.
            if conics.is_zero() {
                continue;
            }
            prop_assert!(
                proportional(&conics, &turns).is_yes(),
                "{order:?}: {conics} against {turns}"
            );
            made[1] += 1;
        }
    }
    Ok(made)
}

fn five_positions() -> impl Strategy<Value = Five> {
    [
        positions(),
        positions(),
        positions(),
        positions(),
        positions(),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(u32::try_from(rounds(40)).unwrap_or(u32::MAX)))]

    #[test]
    fn the_routes_agree(five in five_positions()) {
        compared(&five, 2)?;
        check_certified(&five, 100)?;
        check_certified(&five, 1200)?;
    }

    #[test]
    fn they_agree_beside_every_degenerate_kind_of_four(kind in 0..degenerate().len(), fifth in positions()) {
        let [p, q, r, s] = degenerate().swap_remove(kind).positions;
        let five = [p, q, r, s, fifth];
        compared(&five, 2)?;
        check_certified(&five, 100)?;
    }

    #[test]
    fn they_agree_where_a_point_slides(
        z in points(), places in [numbers(), numbers(), numbers(), numbers(), numbers()],
        turns in [turns(), turns(), turns(), turns(), turns()],
    ) {
        let five: Five = std::array::from_fn(|j| {
            position(turns[j].clone(), Point::from(places[j].clone()) - &turns[j] * &z)
        });
        compared(&five, 2)?;
        // The slide is known, and three pairs are left.
        if let Some(all) = isolated(&five) {
            let rest = all.without(&[of_slide(&z, &point(0, 1))]);
            prop_assert!(rest.is_some_and(|rest| count(&rest) == 3));
        }
    }

    #[test]
    fn alternates_of_kites_and_antiparallelograms(
        crank in [turns(), turns(), turns(), turns(), turns()],
        base in points(), length in numbers(), crossed in any::<bool>(),
    ) {
        let pivots = [point(0, 0), base];
        let joints = crank.each_ref().map(|turn| if crossed {
            antiparallelogram(&pivots, &length, turn)
        } else {
            kite(&pivots, &length, turn)
        });
        let usable = joints.iter().flatten().all(Number::has_value)
            && joints.iter().all(|[a, b]| a.equals(b).is_no());
        prop_assume!(usable);
        let start = &joints[0];
        let five: Five = joints.each_ref().map(|place| Displacement::carrying(start, place));
        compared(&five, 2)?;
        let Some(all) = isolated(&five) else { return Ok(()) };
        let known = [of_pair(&start[0], &pivots[0]), of_pair(&start[1], &pivots[1])];
        let rest = all.without(&known);
        prop_assert!(rest.is_some_and(|rest| count(&rest) == 2));
        prop_assert!(all.without(&[of_pair(&start[0], &(&pivots[0] + point(1, 0)))]).is_none());
    }
}

fn count(isolated: &Isolated) -> usize {
    let real: usize = isolated.real(64).iter().map(|pair| pair.multiplicity).sum();
    let couples: usize = isolated
        .complex(64)
        .iter()
        .map(|pair| pair.multiplicity)
        .sum();
    real + 2 * couples
}

/// A and B of a kite: A₀A as long as the base, AB as long as BB₀.
fn kite(
    [p, q]: &[Point<Exact>; 2],
    length: &Number<Exact>,
    turn: &Point<Exact>,
) -> [Point<Exact>; 2] {
    let b = q + turn.scaled(length);
    [line::mirror(q, p, &b), b]
}

/// A and B of a four-bar with A₀A as long as BB₀ and AB as long as the base, which it crosses.
fn antiparallelogram(
    [p, q]: &[Point<Exact>; 2],
    length: &Number<Exact>,
    turn: &Point<Exact>,
) -> [Point<Exact>; 2] {
    let a = p + turn.scaled(length);
    let middle = (&a + q).scaled(&Number::ratio(1, 2));
    let b = line::mirror(p, &middle, &(&middle + Number::i() * (q - &a)));
    [a, b]
}

#[test]
fn kites_and_antiparallelograms_have_equal_sides() {
    let pivots = [point(0, 0), point(5, 0)];
    let (length, turn) = (Number::from(3), turn(2, 3));
    let [a, b] = kite(&pivots, &length, &turn);
    let square = relation::distance_squared::<Exact>;
    assert!(square(&a, &pivots[0]).equals(&25.into()).is_yes());
    assert!(square(&a, &b).equals(&square(&b, &pivots[1])).is_yes());
    let [a, b] = antiparallelogram(&pivots, &length, &turn);
    assert!(square(&b, &pivots[1]).equals(&9.into()).is_yes());
    assert!(square(&a, &b).equals(&25.into()).is_yes());
}

#[test]
fn every_route_is_compared() {
    let five: Five = [
        (0, 1, 0, 0),
        (1, 5, 3, 1),
        (1, 3, 5, 1),
        (2, 3, 6, -1),
        (1, 1, 5, -4),
    ]
    .map(|(n, d, x, y)| position(turn(n, d), point(x, y)));
    assert_eq!(compared(&five, 10).unwrap(), [30, 10]);
}
