//! Five positions: all Burmester pairs, none missing, none invented.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use crate::support::positions::{
    Position, numbers, point, points, position, positions, turn, turns,
};
use crate::support::seed::generator;
use burmester::finite::five_positions::conditioning::conditioning;
use burmester::finite::five_positions::conics::{Isolated, Pairs, Place, pairs};
use burmester::finite::five_positions::{floats, krawczyk};
use burmester::finite::four_positions::circle_conditions;
use burmester::number::univariate::Polynomial;
use burmester::number::{Ball, Complex, Exact, Number};
use burmester::plane::displacement::Displacement;
use burmester::plane::{Angle, Point};
use proptest::prelude::*;
use rand::Rng;

type Five = [Position; 5];

fn isolated(five: &Five) -> Option<Isolated> {
    match pairs(five)? {
        Pairs::Isolated(isolated) => Some(*isolated),
        Pairs::Families(_) => None,
    }
}

const BITS: u32 = 300;

fn ball(z: &Point<Exact>) -> Point<Ball> {
    let part = |x: &Number<Exact>| Number::rounded(x.0.rational().unwrap(), &BITS);
    Number::complex(part(z.re()), part(z.im()))
}

fn float(z: &Point<Exact>) -> Point<f64> {
    let part = |x: &Number<Exact>| Number(x.0.rational().unwrap().to_f64());
    Number::complex(part(z.re()), part(z.im()))
}

fn balls(five: &Five) -> [Displacement<Ball>; 5] {
    five.each_ref().map(|d| Displacement {
        rotation: ball(&d.rotation),
        translation: ball(&d.translation),
    })
}

/// Positions in which a point z moves on a circle about M: the turns of plane and crank are free.
fn with_pair(
    z: &Point<Exact>,
    center: &Point<Exact>,
    radius: &Number<Exact>,
    turns: &[(Point<Exact>, Point<Exact>); 5],
) -> Five {
    turns.each_ref().map(|(plane, crank)| {
        let place = center + crank.scaled(radius);
        position(plane.clone(), place - plane * z)
    })
}

fn overlaps(found: &Point<Ball>, exact: &Point<Exact>) -> bool {
    let part = |a: &Number<Ball>, b: &Number<Exact>| a.0.contains(b.0.rational().unwrap());
    part(found.re(), exact.re()) && part(found.im(), exact.im())
}

/// What holds of the pairs of any five positions.
fn assert_all_pairs(five: &Five) -> Result<(), TestCaseError> {
    let Some(isolated) = isolated(five) else {
        return Ok(());
    };
    let real = isolated.real(BITS);
    let complex = isolated.complex(BITS);
    let count: usize = real.iter().map(|pair| pair.multiplicity).sum();
    let couples: usize = complex.iter().map(|pair| pair.multiplicity).sum();
    prop_assert_eq!(count + 2 * couples, 4);
    let positions = balls(five);
    let cubics = [
        [0, 1, 2, 3],
        [0, 1, 2, 4],
        [0, 1, 3, 4],
        [0, 2, 3, 4],
        [1, 2, 3, 4],
    ]
    .map(|places| {
        circle_conditions::centerpoint_cubic(&places.map(|i: usize| positions[i].clone())).unwrap()
    });
    for pair in real.iter().filter(|pair| pair.place == Place::Finite) {
        let [z, m] = pair.points();
        for cubic in &cubics {
            prop_assert!(
                !cubic.at(&m).is_zero().is_no(),
                "the center is on the curves of any four"
            );
        }
        if pair.multiplicity == 1 {
            prop_assert!(
                krawczyk::holds_one_pair(&positions, [&z, &m], BITS),
                "one pair there"
            );
        }
    }
    Ok(())
}

/// The eliminant, as text.
fn eliminant(five: &Five) -> Option<Polynomial<Exact>> {
    isolated(five)?.eliminant()
}

fn shown(eliminant: Option<Polynomial<Exact>>) -> Option<String> {
    eliminant.map(|polynomial| polynomial.to_string())
}

proptest! {
    #[test]
    fn renumbering_moving_and_mirroring_leave_the_circlepoints(
        five in [positions(), positions(), positions(), positions(), positions()],
        moved in positions(), first in 0usize..5, second in 0usize..5,
    ) {
        let wanted = shown(eliminant(&five));
        let mut renumbered = five.clone();
        renumbered.swap(first, second);
        prop_assert_eq!(&shown(eliminant(&renumbered)), &wanted);
        let elsewhere = five.each_ref().map(|position| moved.after(position));
        prop_assert_eq!(&shown(eliminant(&elsewhere)), &wanted);
        let mirrored = five.each_ref().map(|d| position(d.rotation.conj(), d.translation.conj()));
        prop_assert_eq!(&shown(eliminant(&mirrored)), &wanted);
    }

    #[test]
    fn scaling_scales_the_circlepoints(
        five in [positions(), positions(), positions(), positions(), positions()],
        exponent in prop_oneof![Just(30i32), Just(-30)],
    ) {
        let ten = Number::<Exact>::from(10);
        let factor = (0..exponent.abs()).fold(Number::one(), |power, _| power * &ten);
        let factor = if exponent < 0 { factor.inverse() } else { factor };
        let scaled = five
            .each_ref()
            .map(|d| position(d.rotation.clone(), d.translation.scaled(&factor)));
        let stretched = eliminant(&five).map(|e| e.stretched(&factor.inverse()));
        let wanted = stretched.and_then(|e| e.primitive_part());
        prop_assert_eq!(shown(eliminant(&scaled)), shown(wanted));
    }

    #[test]
    fn floats_find_what_is_certified(
        five in [positions(), positions(), positions(), positions(), positions()],
    ) {
        let Some(isolated) = isolated(&five) else { return Ok(()) };
        let real = isolated.real(BITS).into_iter();
        let real: Vec<_> = real.filter(|pair| pair.place == Place::Finite).collect();
        let rounded = five.each_ref().map(|d| Displacement {
            rotation: float(&d.rotation),
            translation: float(&d.translation),
        });
        let positions = balls(&five);
        let found = floats::pairs(&rounded);
        for pair in real {
            let [z, m] = pair.points();
            let Some(estimate) = conditioning(&positions, [&z, &m]) else { continue };
            // Nearly double pairs, or pairs nearly at infinity, are not for floats.
            if pair.multiplicity > 1 || estimate.condition > 1e5 || estimate.to_double < 1e-6 {
                continue;
            }
            let found = found.as_ref().expect("four pairs");
            let wanted = [z.re(), z.im(), m.re(), m.im()]
                .map(|x| x.0.midpoint_rational().unwrap().to_f64());
            let size = wanted.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            let error = |pair: &[Number<Complex<f64>>; 7]| {
                let [h, x, y, cx, cy, ..] = pair.each_ref().map(|z| z.re().0);
                let given = [x / h, y / h, cx / h, cy / h];
                let distance = given.iter().zip(wanted);
                distance.fold(0.0, |a: f64, (b, c)| a.max((b - c).abs())) / size
            };
            let nearest = found.iter().map(error).fold(f64::INFINITY, f64::min);
            prop_assert!(nearest < 1e-13 * estimate.condition.max(1e3), "{nearest:e}, {estimate:?}");
        }
    }

    #[test]
    fn every_pair_passes_the_judge(five in [positions(), positions(), positions(), positions(), positions()]) {
        assert_all_pairs(&five)?;
    }

    #[test]
    fn a_known_pair_is_found(
        z in points(), center in points(), radius in numbers(),
        turns in [(turns(), turns()), (turns(), turns()), (turns(), turns()), (turns(), turns()), (turns(), turns())],
    ) {
        let five = with_pair(&z, &center, &radius, &turns);
        let Some(isolated) = isolated(&five) else { return Ok(()) };
        let found = isolated.real(BITS).iter().any(|pair| {
            pair.place == Place::Finite && {
                let [z1, m1] = pair.points();
                overlaps(&z1, &z) && overlaps(&m1, &center)
            }
        });
        prop_assert!(found);
        // The eliminant vanishes in −x.
        let x = -z.re();
        let eliminant = isolated.eliminant().unwrap();
        prop_assert!(eliminant.evaluate(&x).is_zero().is_yes());
    }

    #[test]
    fn a_slide_is_a_pair_at_infinity(
        z in points(), places in [numbers(), numbers(), numbers(), numbers(), numbers()],
        turns in [turns(), turns(), turns(), turns(), turns()],
    ) {
        // z moves along the x-axis.
        let five: Five = std::array::from_fn(|j| {
            position(turns[j].clone(), Point::from(places[j].clone()) - &turns[j] * &z)
        });
        let Some(isolated) = isolated(&five) else { return Ok(()) };
        let real = isolated.real(BITS);
        let slide = real.iter().find(|pair| pair.place == Place::CenterAtInfinity);
        prop_assert!(slide.is_some(), "{:?}", real.iter().map(|pair| pair.place).collect::<Vec<_>>());
    }
}

#[test]
fn a_textbook_case() {
    let five: Five = [
        (0, 1, 0, 0),
        (1, 5, 3, 1),
        (1, 3, 5, 1),
        (2, 3, 6, -1),
        (1, 1, 5, -4),
    ]
    .map(|(n, d, x, y)| position(turn(n, d), point(x, y)));
    let isolated = isolated(&five).unwrap();
    let eliminant = isolated.eliminant().unwrap();
    assert_eq!(eliminant.degree(), Some(4));
    println!("{eliminant}");
}

/// The larger one of the errors of z and M, relative to their size, of every real pair that is not
/// nearly double or nearly at infinity; infinite where there is none nearby.
fn errors(five: &Five, solve: impl Fn(&[Displacement<f64>; 5]) -> Vec<[f64; 4]>) -> Vec<f64> {
    let Some(isolated) = isolated(five) else {
        return Vec::new();
    };
    let found = solve(&five.each_ref().map(|d| Displacement {
        rotation: float(&d.rotation),
        translation: float(&d.translation),
    }));
    let real = isolated.real(BITS).into_iter();
    let finite = real.filter(|pair| pair.place == Place::Finite && pair.multiplicity == 1);
    finite
        .map(|pair| {
            let [z, m] = pair.points();
            let wanted =
                [z.re(), z.im(), m.re(), m.im()].map(|x| x.0.midpoint_rational().unwrap().to_f64());
            let size = wanted.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
            let error = |given: &[f64; 4]| {
                let distance = given.iter().zip(wanted);
                distance.fold(0.0, |a: f64, (b, c)| a.max((b - c).abs())) / size
            };
            found.iter().map(error).fold(f64::INFINITY, f64::min)
        })
        .collect()
}

fn quotients(pair: &[Number<Complex<f64>>; 7]) -> Option<[f64; 4]> {
    let [h, x, y, cx, cy, ..] = pair.each_ref().map(|z| z.re().0);
    let is_real = pair.iter().all(|z| z.im().0 == 0.0);
    (is_real && h != 0.0).then(|| [x / h, y / h, cx / h, cy / h])
}

/// Random problems, and nearby ones of each degenerate kind: two positions nearly equal, turns nearly
/// nothing, a pair nearly at infinity, places far from the origin or very small.
fn hard_problems() -> Vec<(&'static str, Vec<Five>)> {
    let mut random = generator("hard problems");
    let mut fraction = move || -> Number<Exact> {
        Number::ratio(random.random_range(-60..=60), random.random_range(1..=12))
    };
    let mut one = move || -> Five {
        std::array::from_fn(|_| {
            let turn = Angle::from_tan_half(&fraction()).cis();
            position(turn, Number::complex(fraction(), fraction()))
        })
    };
    let mut many = |change: &dyn Fn(Five) -> Five| (0..60).map(|_| change(one())).collect();
    let tiny = || Number::<Exact>::ratio(1, 1_000_000);
    let factor = |power: i32| Number::<Exact>::from(10).power(power);
    vec![
        ("random", many(&|five| five)),
        (
            "nearly equal",
            many(&|[a, b, c, d, e]| {
                let turn = Angle::from_tan_half(&tiny()).cis();
                let b = position(
                    &a.rotation * turn,
                    &a.translation + b.translation.scaled(&tiny()),
                );
                [a, b, c, d, e]
            }),
        ),
        (
            "nearly without turns",
            many(&|five| {
                five.map(|d| {
                    let half = d.rotation.im() * tiny();
                    position(Angle::from_tan_half(&half).cis(), d.translation)
                })
            }),
        ),
        (
            "nearly a slide",
            many(&|five| {
                five.map(|d| {
                    let [x, y] = [d.translation.re().clone(), d.translation.im() * tiny()];
                    position(d.rotation, Number::complex(x, y))
                })
            }),
        ),
        (
            "far away",
            many(&|five| five.map(|d| position(d.rotation, d.translation + Number::from(100_000)))),
        ),
        (
            "small",
            many(&|five| five.map(|d| position(d.rotation, d.translation.scaled(&factor(-30))))),
        ),
        (
            "large",
            many(&|five| five.map(|d| position(d.rotation, d.translation.scaled(&factor(30))))),
        ),
    ]
}

/// By the same measure the quick way, with what it leaves to the careful one, errs as little as the
/// careful one alone.
#[test]
fn quick_pairs_err_no_more_than_careful_ones() {
    let list = |pairs: Option<Vec<[Number<Complex<f64>>; 7]>>| -> Vec<[f64; 4]> {
        pairs.iter().flatten().filter_map(quotients).collect()
    };
    let at = |errors: &[f64], hundredths: usize| errors[(errors.len() - 1) * hundredths / 100];
    for (name, problems) in hard_problems() {
        let mut both = [Vec::new(), Vec::new()];
        for five in &problems {
            both[0].extend(errors(five, |five| list(floats::pairs(five))));
            both[1].extend(errors(five, |five| list(floats::careful::pairs(five))));
        }
        let [quick, careful] = both.each_mut().map(|errors| {
            errors.sort_by(f64::total_cmp);
            [50, 90, 97].map(|hundredths| at(errors, hundredths))
        });
        let shown = |errors: [f64; 3]| errors.map(|error| format!("{error:.1e}")).join(" ");
        println!(
            "{name}: {} pairs, quick {}, careful {}",
            both[0].len(),
            shown(quick),
            shown(careful)
        );
        assert!(both[0].len() > 20, "{name}");
        for (quick, careful) in quick.into_iter().zip(careful) {
            assert!(quick <= 4.0 * careful, "{name}: {quick:e}, {careful:e}");
        }
    }
}
