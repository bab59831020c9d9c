//! Linkages through positions, against their motion followed in small steps.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use crate::support::seed;
use std::collections::BTreeMap;

use crate::support::motion::{Chain, Dyad, Verdict};
use burmester::linkage::passage::{Degenerate, Drive, Joint, Passage, Type};
use burmester::number::{Ball, Number, Surd};
use burmester::plane::Point;
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use rug::Rational;

const BITS: u32 = 160;

fn ball(q: &Rational) -> Number<Ball> {
    Number::rounded(q, &BITS)
}

fn rational(random: &mut ChaCha8Rng, least: i64, most: i64) -> Rational {
    Rational::from((random.random_range(least * 60..=most * 60), 60))
}

/// e^{iθ} of a random rational tangent of half of it, all around.
fn direction(random: &mut ChaCha8Rng) -> Point<Ball> {
    let t = ball(&Rational::from((random.random_range(-60i64..=60), 61)));
    let square = t.square();
    let turn = Number::complex((1 - &square) / (1 + &square), 2 * t / (1 + square));
    if random.random() { turn } else { -turn }
}

fn point(random: &mut ChaCha8Rng) -> Point<Ball> {
    Number::complex(
        ball(&rational(random, -4, 4)),
        ball(&rational(random, -4, 4)),
    )
}

/// How a pair guides the coupler.
#[derive(Clone)]
enum Guide {
    /// On a circle about a center.
    Link {
        center: Point<Ball>,
        length: Number<Ball>,
    },
    /// Along the line through a point in a direction of length 1.
    Slide {
        origin: Point<Ball>,
        along: Point<Ball>,
    },
    /// A line of the coupler through this point.
    Block { center: Point<Ball> },
}

impl Guide {
    fn random(kind: u8, random: &mut ChaCha8Rng) -> Self {
        let center = point(random);
        match kind {
            0 => Guide::Link {
                center,
                length: ball(&rational(random, 1, 6).max(Rational::from((1, 2)))),
            },
            1 => Guide::Slide {
                origin: center,
                along: direction(random),
            },
            _ => Guide::Block { center },
        }
    }

    fn pivot(&self) -> Joint<Ball> {
        match self {
            Guide::Link { center, .. } | Guide::Block { center } => Joint::At(center.clone()),
            Guide::Slide { along, .. } => Joint::Towards(Number::i() * along),
        }
    }

    fn in_floats(&self) -> Dyad {
        match self {
            Guide::Link { center, length } => Dyad::Link {
                center: float(center),
                length: of(length),
            },
            Guide::Slide { origin, along } => Dyad::Slide {
                origin: float(origin),
                along: float(along),
            },
            Guide::Block { center } => Dyad::Block {
                center: float(center),
            },
        }
    }
}

fn of(x: &Number<Ball>) -> f64 {
    x.0.midpoint_rational().unwrap().to_f64()
}

fn float(z: &Point<Ball>) -> [f64; 2] {
    [of(z.re()), of(z.im())]
}

/// The coupler length or offset.
struct Example {
    guides: [Guide; 2],
    coupler: Number<Ball>,
    /// For two turning blocks, the turn from one normal to the other.
    turn: Point<Ball>,
}

fn dot(u: &Point<Ball>, v: &Point<Ball>) -> Number<Ball> {
    (u.conj() * v).re().clone()
}

impl Example {
    fn random(kinds: [u8; 2], random: &mut ChaCha8Rng) -> Self {
        Example {
            guides: kinds.map(|kind| Guide::random(kind, random)),
            coupler: ball(&rational(random, 1, 7).max(Rational::from((1, 2)))),
            turn: direction(random),
        }
    }

    /// The joints with the first link somewhere, where the linkage closes.
    fn position(&self, random: &mut ChaCha8Rng) -> Option<[Joint<Ball>; 2]> {
        let side: Number<Ball> = if random.random() { 1 } else { -1 }.into();
        let [first, second] = &self.guides;
        let a = match first {
            Guide::Link { center, length } => center + direction(random).scaled(length),
            Guide::Slide { origin, along } => {
                origin + along.scaled(&ball(&rational(random, -9, 9)))
            }
            Guide::Block { center } => {
                let normal = direction(random);
                let joint = self.beyond_block(center, &normal, &side)?;
                return Some([Joint::Towards(normal), joint]);
            }
        };
        let c = &self.coupler;
        let b = match second {
            Guide::Link { center, length } => {
                let base = center - &a;
                let square = base.norm();
                let along = (c.square() - length.square() + &square) / (2 * &square);
                let across = root(&(c.square() / &square - along.square()))? * side;
                Joint::At(&a + base * Number::complex(along, across))
            }
            Guide::Slide { origin, along } => {
                let from = origin - &a;
                let foot = &from - along.scaled(&dot(along, &from));
                let room = root(&(c.square() - foot.norm()))? * side;
                Joint::At(&a + foot + along.scaled(&room))
            }
            Guide::Block { center } => {
                let from = &a - center;
                let across = root(&(from.norm() - c.square()))? * side;
                Joint::Towards(
                    (&from * Number::complex(c.clone(), across)).scaled(&from.norm().inverse()),
                )
            }
        };
        Some([Joint::At(a), b])
    }

    /// B, where the coupler slides in a first block with this normal.
    fn beyond_block(
        &self,
        center: &Point<Ball>,
        normal: &Point<Ball>,
        side: &Number<Ball>,
    ) -> Option<Joint<Ball>> {
        let foot = center + normal.scaled(&self.coupler);
        let line = Number::i() * normal;
        Some(match &self.guides[1] {
            Guide::Link { center, length } => {
                let from = center - &foot;
                let off = dot(normal, &from);
                let along = dot(&line, &from) + root(&(length.square() - off.square()))? * side;
                Joint::At(foot + line.scaled(&along))
            }
            Guide::Slide { origin, along } => {
                let place = -(dot(normal, &(origin - &foot)) / dot(normal, along));
                Joint::At(origin + along.scaled(&place))
            }
            Guide::Block { .. } => Joint::Towards(normal * &self.turn),
        })
    }

    fn passage(&self, joints: Vec<[Joint<Ball>; 2]>) -> Passage<Ball> {
        Passage {
            pivots: self.guides.each_ref().map(Guide::pivot),
            joints,
        }
    }

    fn chain(&self) -> Chain {
        Chain {
            dyads: self.guides.each_ref().map(Guide::in_floats),
            coupler: of(&self.coupler),
            turn: float(&self.turn),
        }
    }
}

fn root(square: &Number<Ball>) -> Option<Number<Ball>> {
    square.is_positive().is_yes().then(|| square.clone().sqrt())
}

/// The parameters of both links in a position.
fn parameters(example: &Example, joints: &[Joint<Ball>; 2]) -> [f64; 2] {
    std::array::from_fn(|i| match (&example.guides[i], &joints[i]) {
        (Guide::Link { center, .. }, Joint::At(joint)) => {
            let [x, y] = float(&(joint - center));
            y.atan2(x)
        }
        (Guide::Slide { origin, along }, Joint::At(joint)) => of(&dot(along, &(joint - origin))),
        (_, Joint::Towards(normal)) => {
            let [x, y] = float(normal);
            y.atan2(x)
        }
        (_, Joint::At(joint)) => panic!("{joint:?} in a turning block"),
    })
}

/// What was compared, and what was too near to a boundary to be.
#[derive(Default, Debug)]
struct Tally {
    compared: usize,
    skipped: usize,
    whole: usize,
    ordered: usize,
}

fn compare(example: &Example, joints: &[[Joint<Ball>; 2]], tally: &mut Tally) -> Option<()> {
    let passage = example.passage(joints.to_vec());
    let chain = example.chain();
    let places: Vec<[f64; 2]> = joints
        .iter()
        .map(|joints| parameters(example, joints))
        .collect();
    let Some(followed) = chain.follow(&places) else {
        tally.skipped += 1;
        return None;
    };
    tally.compared += 1;
    let what = || format!("{:?} through {places:?}", chain);
    assert_eq!(
        passage.circuit().unwrap(),
        followed.circuit,
        "circuit of {}",
        what()
    );
    for (drive, verdict) in Drive::ALL.into_iter().zip(&followed.drives) {
        let Verdict {
            crank,
            branch,
            order,
            cosines,
        } = verdict;
        assert_eq!(
            passage.is_crank(drive).unwrap(),
            *crank,
            "crank, {drive:?} of {}",
            what()
        );
        assert_eq!(
            &passage.branch(drive).unwrap(),
            branch,
            "branch, {drive:?} of {}",
            what()
        );
        if let Some(order) = order {
            tally.whole += 1;
            let found = passage.order(drive).unwrap();
            assert_eq!(&found, order, "order, {drive:?} of {}", what());
            tally.ordered += usize::from(!found.is_sorted());
        }
        if let Some(cosines) = cosines {
            let found = passage.transmission(drive).unwrap().map(|x| of(&x));
            for (x, y) in found.iter().zip(cosines) {
                assert!(
                    (x - y).abs() < 6e-3,
                    "cosines {found:?}, not {cosines:?}, {drive:?} of {}",
                    what()
                );
            }
        }
    }
    Some(())
}

fn compare_many(kinds: [u8; 2], count: usize, test: &str) -> (Tally, BTreeMap<String, usize>) {
    let mut random = seed::generator(test);
    let mut tally = Tally::default();
    let mut types = BTreeMap::new();
    let mut rounds = 0;
    while tally.compared < count {
        rounds += 1;
        assert!(rounds < 200 * count, "too few linkages close: {tally:?}");
        let example = Example::random(kinds, &mut random);
        let mut joints = Vec::new();
        let wanted = 5;
        for _ in 0..60 {
            joints.extend(example.position(&mut random));
        }
        if joints.is_empty() || !is_a_mechanism(&example.passage(joints.clone())) {
            continue;
        }
        if random.random() {
            // Positions that one drive is said to reach: what follows tells whether it does.
            let drive = Drive::ALL[random.random_range(0..2)];
            let reached = example
                .passage(joints.clone())
                .branch(drive)
                .unwrap()
                .into_iter();
            joints = joints
                .into_iter()
                .zip(reached)
                .filter(|(_, reached)| *reached)
                .map(|(joint, _)| joint)
                .collect();
        }
        if joints.len() < wanted {
            continue;
        }
        joints.truncate(wanted);
        if compare(&example, &joints, &mut tally).is_some() {
            let kind = example.passage(joints).link_type().unwrap();
            *types.entry(format!("{kind:?}")).or_insert(0) += 1;
        }
    }
    eprintln!("{test}: {tally:?}, {types:?}");
    assert!(tally.whole > 0, "no drive reached all positions: {tally:?}");
    assert!(tally.skipped < 3 * tally.compared, "{tally:?}");
    (tally, types)
}

/// No joints coincide, no slides are parallel.
fn is_a_mechanism(passage: &Passage<Ball>) -> bool {
    passage.degenerate().is_some_and(|list| list.is_empty())
}

/// Moved, turned, scaled by 10^±30, mirrored, renumbered and exchanged, a linkage does the same.
#[test]
fn the_choice_of_axes_and_names_does_not_matter() {
    let mut random = seed::generator("the_choice_of_axes_and_names_does_not_matter");
    let mut whole = 0;
    for round in 0..seed::rounds(150) {
        let kinds = [[0, 0], [0, 1], [2, 0], [1, 1], [2, 2], [1, 2]][round % 6];
        let example = Example::random(kinds, &mut random);
        let mut joints: Vec<_> = (0..30)
            .filter_map(|_| example.position(&mut random))
            .collect();
        if joints.is_empty() || !is_a_mechanism(&example.passage(joints.clone())) {
            continue;
        }
        let drive = Drive::ALL[random.random_range(0..2)];
        if round % 3 > 0 {
            let reached = example
                .passage(joints.clone())
                .branch(drive)
                .unwrap()
                .into_iter();
            joints = joints
                .into_iter()
                .zip(reached)
                .filter(|(_, r)| *r)
                .map(|(joint, _)| joint)
                .collect();
        }
        joints.truncate(4);
        let places: Vec<_> = joints
            .iter()
            .map(|joints| parameters(&example, joints))
            .collect();
        let twice = |(i, p): (usize, &[f64; 2])| places[..i].iter().any(|q| p == q);
        if places.iter().enumerate().any(twice) {
            continue;
        }
        let passage = example.passage(joints);
        let (kind, circuit) = (passage.link_type(), passage.circuit());
        let (crank, branch) = (
            passage.is_crank(drive).unwrap(),
            passage.branch(drive).unwrap(),
        );
        let reached = branch.iter().all(|one| *one);
        whole += usize::from(reached);
        let order = if reached {
            passage.order(drive).unwrap()
        } else {
            Vec::new()
        };
        let angle = passage.has_transmission_angle() && reached;
        let cosines = angle.then(|| passage.transmission(drive).unwrap());
        let same_angles = |other: &Passage<Ball>, drive: Drive| {
            let Some(cosines) = &cosines else { return };
            for (x, y) in cosines.iter().zip(&other.transmission(drive).unwrap()) {
                assert!(!x.equals(y).is_no(), "{cosines:?}");
            }
        };
        let turn = direction(&mut random);
        let shift = point(&mut random);
        for exponent in [-30, 0, 30] {
            let scale = Number::<Ball>::from(10).power(exponent);
            let other = mapped(&passage, &|z| (z * &turn).scaled(&scale), &shift);
            assert_eq!(
                (other.link_type(), other.circuit()),
                (kind, circuit.clone())
            );
            assert_eq!(other.is_crank(drive), Some(crank));
            assert_eq!(other.branch(drive), Some(branch.clone()));
            if reached {
                assert_eq!(other.order(drive), Some(order.clone()), "{exponent}");
            }
            same_angles(&other, drive);
        }
        let mirrored = mapped(&passage, &|z| z.conj(), &shift);
        assert_eq!(
            (mirrored.link_type(), mirrored.circuit()),
            (kind, circuit.clone())
        );
        assert_eq!(mirrored.branch(drive), Some(branch.clone()));
        if reached {
            let mut backwards: Vec<usize> = order.iter().rev().copied().collect();
            if crank {
                backwards.rotate_right(1);
            }
            assert_eq!(mirrored.order(drive), Some(backwards));
        }
        same_angles(&mirrored, drive);
        let exchanged = Passage {
            pivots: [passage.pivots[1].clone(), passage.pivots[0].clone()],
            joints: passage
                .joints
                .iter()
                .map(|[a, b]| [b.clone(), a.clone()])
                .collect(),
        };
        let other = if drive == Drive::First {
            Drive::Second
        } else {
            Drive::First
        };
        assert_eq!(
            (exchanged.link_type(), exchanged.circuit()),
            (kind, circuit.clone())
        );
        assert_eq!(exchanged.is_crank(other), Some(crank));
        assert_eq!(exchanged.branch(other), Some(branch.clone()));
        same_angles(&exchanged, other);
        let mut renumbered = passage.clone();
        renumbered.joints.rotate_left(1);
        let count = renumbered.joints.len();
        let all = |list: Vec<bool>| list.iter().all(|one| *one);
        assert_eq!(renumbered.link_type(), kind);
        assert_eq!(all(renumbered.circuit().unwrap()), all(circuit.unwrap()));
        assert_eq!(all(renumbered.branch(drive).unwrap()), reached);
        if reached {
            let mut named: Vec<usize> = renumbered
                .order(drive)
                .unwrap()
                .iter()
                .map(|place| (place + 1) % count)
                .collect();
            if crank {
                let first = named.iter().position(|place| *place == 0).unwrap();
                named.rotate_left(first);
            }
            assert_eq!(named, order);
        }
        same_angles(&renumbered, drive);
    }
    assert!(whole > 20, "{whole}");
}

fn mapped(
    passage: &Passage<Ball>,
    linear: &dyn Fn(&Point<Ball>) -> Point<Ball>,
    shift: &Point<Ball>,
) -> Passage<Ball> {
    let joint = |joint: &Joint<Ball>| match joint {
        Joint::At(z) => Joint::At(linear(z) + linear(shift)),
        // A mirror turns the sense of the direction's quarter turn, which is the direction of a slide.
        Joint::Towards(z) => Joint::Towards(linear(z)),
    };
    Passage {
        pivots: passage.pivots.each_ref().map(joint),
        joints: passage
            .joints
            .iter()
            .map(|joints| joints.each_ref().map(joint))
            .collect(),
    }
}

fn exact(list: &[(i64, i64, i64, i64)], pivots: [(i64, i64); 2]) -> Passage<Surd> {
    let at = |x: i64, y: i64| Joint::At(Number::complex(x.into(), y.into()));
    Passage {
        pivots: pivots.map(|(x, y)| at(x, y)),
        joints: list
            .iter()
            .map(|(x, y, u, v)| [at(*x, *y), at(*u, *v)])
            .collect(),
    }
}

/// Change points are decided where the numbers are exact, and never by enclosures.
#[test]
fn change_points() {
    // A parallelogram with arms (3, 4), (4, 3), (-3, 4), then (3, -4) beyond the base line.
    let above = exact(
        &[(3, 4, 10, 4), (4, 3, 11, 3), (-3, 4, 4, 4)],
        [(0, 0), (7, 0)],
    );
    assert_eq!(above.link_type(), Some(Type::ChangePoint));
    for drive in Drive::ALL {
        assert_eq!(above.is_crank(drive), Some(true));
        assert_eq!(above.branch(drive), Some(vec![true; 3]));
        assert_eq!(above.order(drive), Some(vec![1, 0, 2]));
        // γ is the angle of the arm, from 36.9° to 126.9°, or what is left of 180°.
        let [greatest, least] = above.transmission(drive).unwrap();
        let expected = match drive {
            Drive::First => [Number::ratio(4, 5), Number::ratio(-3, 5)],
            Drive::Second => [Number::ratio(3, 5), Number::ratio(-4, 5)],
        };
        assert!(greatest.equals(&expected[0]).is_yes());
        assert!(least.equals(&expected[1]).is_yes());
    }
    assert_eq!(above.circuit(), Some(vec![true; 3]));
    let both = exact(&[(3, 4, 10, 4), (3, -4, 10, -4)], [(0, 0), (7, 0)]);
    assert_eq!(both.circuit(), Some(vec![true; 2]));
    assert_eq!(both.branch(Drive::First), Some(vec![true, false]));
    // A square root of the base: the same parallelogram along (1, 1).
    let skew = exact(&[(3, 4, 4, 5), (4, 3, 5, 4)], [(0, 0), (1, 1)]);
    assert_eq!(skew.link_type(), Some(Type::ChangePoint));
    // A kite that folds: a = d, b = c.
    let kite = exact(&[(3, 4, 6, 3), (3, -4, 6, -3)], [(0, 0), (5, 0)]);
    assert_eq!(kite.link_type(), Some(Type::ChangePoint));
    assert_eq!(kite.branch(Drive::First), Some(vec![true, false]));
    // Equal links alone are no change point.
    let equal = exact(&[(3, 4, 2, 3)], [(0, 0), (6, 0)]);
    assert_eq!(equal.link_type(), Some(Type::GrashofDoubleLever));
    // In enclosures a parallelogram stays undecided.
    let rounded = |z: &Joint<Surd>| {
        let part = |x: &Number<Surd>| ball(&(x.0.rational().unwrap().clone() / 3u32));
        Joint::At(Number::complex(
            part(z.point().unwrap().re()),
            part(z.point().unwrap().im()),
        ))
    };
    let enclosed = Passage {
        pivots: above.pivots.each_ref().map(rounded),
        joints: above
            .joints
            .iter()
            .map(|joints| joints.each_ref().map(rounded))
            .collect(),
    };
    assert_eq!(enclosed.link_type(), None);
    assert_eq!(enclosed.circuit(), None);
}

#[test]
fn joints_that_coincide() {
    let same_center = exact(&[(3, 4, 4, 3), (-3, 4, -4, 3)], [(0, 0), (0, 0)]);
    assert_eq!(same_center.degenerate(), Some(vec![Degenerate::SameCenter]));
    assert_eq!(same_center.circuit(), Some(vec![true, false]));
    assert_eq!(same_center.is_crank(Drive::First), Some(true));
    let same_circlepoint = exact(&[(3, 4, 3, 4)], [(0, 0), (6, 0)]);
    assert_eq!(
        same_circlepoint.degenerate(),
        Some(vec![Degenerate::SameCirclepoint])
    );
    let no_link = exact(&[(0, 0, 3, 4)], [(0, 0), (6, 0)]);
    assert_eq!(no_link.degenerate(), Some(vec![Degenerate::LinkOfNoLength]));
    for passage in [&same_circlepoint, &no_link] {
        for drive in Drive::ALL {
            let _ = (
                passage.order(drive),
                passage.transmission(drive),
                passage.branch(drive),
            );
        }
    }
}

#[test]
fn four_bars() {
    let (_, types) = compare_many([0, 0], seed::rounds(400), "four_bars");
    for kind in [
        Type::CrankAndLever,
        Type::DragLink,
        Type::GrashofDoubleLever,
        Type::DoubleLever,
    ] {
        assert!(types.contains_key(&format!("{kind:?}")), "no {kind:?}");
    }
}

#[test]
fn slider_cranks() {
    compare_many([0, 1], seed::rounds(120), "slider_cranks");
    compare_many([1, 0], seed::rounds(60), "slider_cranks, exchanged");
}

#[test]
fn inverted_slider_cranks() {
    compare_many([0, 2], seed::rounds(120), "inverted_slider_cranks");
    compare_many(
        [2, 0],
        seed::rounds(60),
        "inverted_slider_cranks, exchanged",
    );
}

#[test]
fn double_sliders() {
    compare_many([1, 1], seed::rounds(60), "double_sliders");
}

#[test]
fn two_turning_blocks() {
    compare_many([2, 2], seed::rounds(30), "two_turning_blocks");
}

#[test]
fn slides_and_turning_blocks() {
    compare_many([1, 2], seed::rounds(80), "slides_and_turning_blocks");
    compare_many(
        [2, 1],
        seed::rounds(80),
        "slides_and_turning_blocks, exchanged",
    );
}
