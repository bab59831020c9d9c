//! Chapter III: how many pairs five positions have, and the linkages that they make.

use crate::finite::five_positions::conics::{Isolated, Pairs, pairs};
use crate::finite::five_positions::krawczyk::holds_one_pair;
use crate::number::{Ball, Exact, Number, Truth, count};
use crate::plane::Point;
use crate::plane::displacement::Displacement;
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::{Random, point};
use crate::scenes::{Free, Unbuilt};

pub const FOUR: Check = Check {
    name: "four-burmester-pairs",
    summary: "Random positions. The eliminant of the conditions for a pair has the degree four and \
              no double root, so that there are four different pairs, real or not; all four, two and \
              none of them are real in some of the instances. The wrong variant asks for four real \
              ones.",
    run: run_four,
};

pub const SIX: Check = Check {
    name: "six-linkages-through-five-positions",
    summary: "Random positions with four real pairs. An interval test on the conditions themselves \
              proves each pair: its point keeps its distance from its center in all five positions. \
              The points and the centers are different, so that every two pairs are the cranks of a \
              four-bar, six in all. The wrong variant takes the center of another pair.",
    run: run_six,
};

const INSTANCES: u64 = 40;
const LINKAGES: u64 = 3;
const BITS: u32 = 192;

type Five = [Displacement<Exact>; 5];

fn positions(random: &mut Random) -> Result<Five, Unbuilt> {
    let mut positions = vec![Displacement::identity()];
    for j in 1..=4 {
        let turn = Free::<Exact>::angle(random, &format!("phi_{j}"))?;
        positions.push(Displacement {
            rotation: turn.cis(),
            translation: point(random, &format!("shift {j}"))?,
        });
    }
    positions
        .try_into()
        .map_err(|_| Unbuilt::Contradiction("five positions".to_owned()))
}

fn isolated(positions: &Five) -> Option<Box<Isolated>> {
    match pairs(positions)? {
        Pairs::Isolated(isolated) => Some(isolated),
        Pairs::Families(_) => None,
    }
}

fn run_four() -> Result<Report, Unbuilt> {
    let mut holds = Truth::Yes;
    let mut numbers = Vec::new();
    for seed in 0..INSTANCES {
        let positions = positions(&mut Random::new(seed))?;
        let Some(pairs) = isolated(&positions) else {
            holds = Truth::No;
            continue;
        };
        let finite = pairs.eliminant().filter(|eliminant| {
            eliminant.degree() == Some(4) && eliminant.discriminant().is_zero().is_no()
        });
        holds = holds & Truth::from(finite.is_some());
        numbers.push(pairs.real(BITS).len());
    }
    let every_number = [0, 2, 4].iter().all(|number| numbers.contains(number));
    Ok(Report {
        holds: holds & Truth::from(every_number),
        wrong_variant: Truth::from(numbers.iter().all(|&number| number == 4)),
        basis: Basis::Instances,
        instances: count::from_u64(INSTANCES),
        exception: None,
    })
}

/// Circlepoint and center.
type Pair = [Point<Ball>; 2];

fn run_six() -> Result<Report, Unbuilt> {
    let (mut holds, mut wrong, mut instances) = (Truth::Yes, Truth::No, 0);
    for seed in 0..INSTANCES {
        let positions = positions(&mut Random::new(seed))?;
        let Some(found) = isolated(&positions).map(|pairs| pairs.real(BITS)) else {
            continue;
        };
        if found.len() != 4 {
            continue;
        }
        let pairs: Vec<Pair> = found.iter().map(|pair| pair.points()).collect();
        let enclosed = positions.each_ref().map(|position| {
            position.map(|x| match x.0.rational() {
                Some(q) => Number::rounded(q, &BITS),
                None => Number::one() / Number::zero(),
            })
        });
        let proved = |[point, center]: [&Point<Ball>; 2]| {
            Truth::from(holds_one_pair(&enclosed, [point, center], BITS))
        };
        holds = holds & Truth::all(pairs.iter().map(|[point, center]| proved([point, center])));
        holds = holds & Truth::from(linkages(&pairs) == 6);
        let next = pairs.iter().cycle().skip(1);
        let mixed = pairs.iter().zip(next);
        wrong = wrong
            | mixed.fold(Truth::No, |any, (own, other)| {
                any | proved([&own[0], &other[1]])
            });
        instances += 1;
        if instances == LINKAGES {
            break;
        }
    }
    Ok(Report {
        holds: holds & Truth::from(instances > 0),
        wrong_variant: wrong,
        basis: Basis::Instances,
        instances: count::from_u64(instances),
        exception: None,
    })
}

/// How many four-bars the pairs make, two pairs each with different points and different centers.
fn linkages(pairs: &[Pair]) -> usize {
    let differ = |one: &Pair, other: &Pair| {
        one.iter()
            .zip(other)
            .all(|(own, other)| own.equals(other).is_no())
    };
    let couples = pairs.iter().enumerate();
    couples
        .map(|(place, one)| {
            pairs
                .iter()
                .skip(place + 1)
                .filter(|other| differ(one, other))
                .count()
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_hold_and_the_wrong_variants_are_rejected() {
        for run in [run_four, run_six] {
            let report = run().unwrap();
            assert_eq!(
                (report.holds, report.wrong_variant),
                (Truth::Yes, Truth::No)
            );
            assert!(report.instances > 0);
        }
    }
}
