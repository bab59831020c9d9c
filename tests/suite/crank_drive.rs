//! The crank drive of any four-bar: closed form, reality, and which link turns fully.
#![expect(
    clippy::as_conversions,
    clippy::indexing_slicing,
    reason = "a place that is not there is a failure of the test"
)]

use burmester::linkage::crank_drive::{Crank, CrankDrive, Roots, Squares, crank_drives, drive};
use burmester::linkage::five_bar::{self, Lengths};
use burmester::linkage::focal_mechanism;
use burmester::linkage::four_bar::FourBar;
use burmester::number::poly::{Fraction, Ring};
use burmester::number::{Exact, Kind, Number, Real, Surd};
use burmester::plane::{Angle, Point, relation};

fn numbers<K: Kind, const N: usize>(values: [i64; N]) -> [Number<K>; N] {
    values.map(Number::from)
}

fn four_bar<K: Kind>(sides: [i64; 4]) -> FourBar<K> {
    let [a, b, c, d] = numbers(sides);
    FourBar { a, b, c, d }
}

fn lengths<K: Kind>(drive: &CrankDrive<K>) -> Lengths<K> {
    Lengths {
        m: drive.m.clone(),
        p: drive.p.clone(),
        q: drive.q.clone(),
        n: drive.n.clone(),
    }
}

/// The lengths belong to a focal mechanism of the four-bar with S in the right place: arms, c² from
/// the closure by the angle sum of both chains, r and t from the circles.
fn assert_is_drive<K: Real>(four_bar: &FourBar<K>, rho: &Number<K>, drive: &CrankDrive<K>) {
    let FourBar { a, b, c, d } = four_bar;
    let bars = lengths(drive);
    let Lengths { m, p, q, n } = &bars;
    let (arm_a, arm_b) = focal_mechanism::arms(&bars);
    assert!(arm_a.equals(a).is_yes() && arm_b.equals(b).is_yes(), "arms");
    assert!((m * p).equals(&(rho * n * q)).is_yes(), "ratio");
    // F seen from M and N, and from A and B, in two positions ω of both five-bars: s and SF² of the
    // base, and the same of the coupler as base.
    let omegas = [
        Angle::from_tan_half(&Number::ratio(2, 3)),
        Angle::from_tan_half(&Number::ratio(-5, 7)),
    ];
    let s = five_bar::center_of_path(&bars, d, &omegas[0], &omegas[1]);
    let r = five_bar::distance_squared_from_base_point(&bars, d, &omegas[0], &s);
    assert!(r.equals(&drive.r.square()).is_yes(), "SF");
    let seen_from_coupler = Lengths {
        m: b - n,
        p: q.clone(),
        q: p.clone(),
        n: a - m,
    };
    let t = five_bar::center_of_path(&seen_from_coupler, c, &omegas[0], &omegas[1]);
    let t_squared =
        five_bar::distance_squared_from_base_point(&seen_from_coupler, c, &omegas[0], &t);
    assert!(t_squared.equals(&drive.t.square()).is_yes(), "TF");
    assert!(
        (s / d).equals(&(1 - t / c)).is_yes(),
        "S and T divide alike"
    );
}

#[test]
fn the_closed_form_holds_for_all_lengths() {
    for rho_is_negative in [false, true] {
        let mut ring = Ring::empty();
        for name in ["a", "b", "c", "d", "root of rho"] {
            ring = ring.with_positive(name).unwrap();
        }
        let [a, b, c, d, root] = ring.numbers();
        let four_bar = FourBar { a, b, c, d };
        let FourBar { a, b, c, d } = &four_bar;
        let sign = if rho_is_negative { -1 } else { 1 };
        let rho = root.square() * sign;
        let e = (1 + &rho) * (a.square() + &rho * b.square()) / &rho;
        let first = Fraction::adjoin_root_in(&ring, "first", &((&e - (d - c).square()) * sign));
        let ring = first.0.ring().unwrap().clone();
        let second = Fraction::adjoin_root_in(&ring, "second", &((&e - (d + c).square()) * sign));
        for second in [second.clone(), -second] {
            let roots = Roots {
                rho: root.clone(),
                first: first.clone(),
                second,
                rho_is_negative,
            };
            assert_is_drive(&four_bar, &rho, &drive(&four_bar, &roots));
        }
    }
}

#[test]
fn the_roots_of_the_equation_are_those_of_the_drives() {
    let four_bar: FourBar<Surd> = four_bar([5, 5, 2, 4]);
    let rho = Number::one();
    let drives = crank_drives(&four_bar, &rho).unwrap();
    assert_eq!(drives.len(), 2);
    let squares = Squares {
        a: four_bar.a.square(),
        b: four_bar.b.square(),
        c: four_bar.c.square(),
        d: four_bar.d.square(),
    };
    let [two, one, zero] = squares.equation_of_lambda(&rho);
    for drive in &drives {
        let value = (&two * &drive.lambda + &one) * &drive.lambda + &zero;
        assert!(value.is_zero().is_yes());
        assert_is_drive(&four_bar, &rho, drive);
        let bars = squares.bars(&rho, &drive.lambda);
        assert!(bars.p.equals(&drive.p.square()).is_yes());
        assert!(bars.q.equals(&drive.q.square()).is_yes());
        assert!(bars.r.equals(&drive.r.square()).is_yes());
    }
    // The printed example: r = √6 − 2.
    let r = Number::<Surd>::from(6).sqrt() - 2;
    assert!(drives[0].r.equals(&r).is_yes());
    assert!(drives[0].turns_with_coupler().is_yes());
    assert!(drives[1].turns_with_coupler().is_no());
}

#[test]
fn a_drive_with_rational_lengths() {
    let four_bar: FourBar<Exact> = four_bar([290, 145, 5, 410]);
    let drives = crank_drives(&four_bar, &Number::from(4)).unwrap();
    let expected: [Number<Exact>; 6] = numbers([232, 116, 116, 58, 4, 82]);
    let has = |drive: &CrankDrive<Exact>| {
        let found = [&drive.m, &drive.n, &drive.p, &drive.q, &drive.r, &drive.t];
        found
            .iter()
            .zip(&expected)
            .all(|(found, value)| found.equals(value).is_yes())
    };
    assert!(has(&drives[0]), "{drives:?}");
    for drive in &drives {
        assert_is_drive(&four_bar, &Number::from(4), drive);
    }
}

#[test]
fn a_revolving_coupler_has_two_drives_for_every_ratio_and_others_may_have_none() {
    let mut checked = 0;
    for a in 1..8 {
        for b in 1..8 {
            for (c, d) in [(1, 3), (2, 5), (3, 4)] {
                let four_bar: FourBar<f64> = four_bar([a, b, c, d]);
                if !four_bar.coupler_turns().is_yes() {
                    continue;
                }
                for rho in [-7.0, -2.5, -0.4, 0.3, 1.0, 4.0] {
                    let exceptional = (rho + (a * a) as f64 / (b * b) as f64).abs() < 1e-9;
                    let drives = crank_drives(&four_bar, &Number(rho)).unwrap();
                    assert_eq!(drives.len(), if exceptional { 1 } else { 2 });
                    checked += 1;
                }
            }
        }
    }
    assert!(checked > 50, "{checked}");
    let stretched: FourBar<Exact> = four_bar([1, 1, 3, 5]);
    assert!(crank_drives(&stretched, &Number::one()).unwrap().is_empty());
    // E = (c + d)²: both drives coincide.
    let single: FourBar<Surd> = four_bar([3, 3, 1, 5]);
    assert_eq!(crank_drives(&single, &Number::one()).unwrap().len(), 1);
}

/// How often SF goes round while AB turns once, followed in small steps.
fn turns_of_crank(four_bar: &FourBar<f64>, rho: f64, drive: &CrankDrive<f64>) -> Option<f64> {
    let steps = 3000;
    let s: Point<f64> = (Number(rho / (1.0 + rho)) * &four_bar.d).into();
    let base: Point<f64> = four_bar.d.clone().into();
    let directions: Option<Vec<Point<f64>>> = (0..=steps)
        .map(|step| {
            let theta = Number(f64::from(step) / f64::from(steps) * std::f64::consts::TAU);
            let w = Number::complex(theta.clone().cos(), theta.sin());
            let [position, _] = four_bar.with_coupler(&w)?;
            let u = position.a.scaled(&four_bar.a.inverse());
            let v = (&position.b - &base).scaled(&four_bar.b.inverse());
            let turn = (u.scaled(&drive.m) - v.scaled(&drive.n) - &base)
                / (u.scaled(&drive.p) + v.scaled(&drive.q));
            Some(u.scaled(&drive.m) - (u * turn).scaled(&drive.p) - &s)
        })
        .collect();
    let directions = directions?;
    let steps = directions.windows(2).map(|pair| {
        let turn = &pair[1] * pair[0].conj();
        turn.im().clone().atan2(turn.re()).0
    });
    Some(steps.sum::<f64>() / std::f64::consts::TAU)
}

#[test]
fn the_shorter_link_turns_fully() {
    for sides in [[5, 5, 2, 4], [6, 5, 1, 4], [4, 7, 1, 5], [7, 3, 1, 6]] {
        let four_bar: FourBar<f64> = four_bar(sides);
        assert!(four_bar.coupler_turns().is_yes());
        for rho in [-3.0, -0.45, 0.5, 1.0, 3.0] {
            for drive in crank_drives(&four_bar, &Number(rho)).unwrap() {
                let turns = turns_of_crank(&four_bar, rho, &drive)
                    .unwrap()
                    .abs()
                    .round();
                let expected = if drive.turns_with_coupler().is_yes() {
                    1.0
                } else {
                    0.0
                };
                assert_eq!(turns, expected, "{sides:?} {rho} {drive:?}");
            }
        }
    }
}

#[test]
fn both_assemblies_of_a_four_bar_close() {
    fn assert_closes<K: Real>(four_bar: &FourBar<K>, direction: &Point<K>) {
        let base: Point<K> = four_bar.d.clone().into();
        let positions = four_bar.with_crank(direction).unwrap();
        let of_coupler = four_bar.with_coupler(direction).unwrap();
        for position in positions.iter().chain(&of_coupler) {
            let sides = [
                (
                    relation::distance_squared(&Number::zero(), &position.a),
                    &four_bar.a,
                ),
                (
                    relation::distance_squared(&position.a, &position.b),
                    &four_bar.c,
                ),
                (relation::distance_squared(&base, &position.b), &four_bar.b),
            ];
            assert!(
                sides
                    .iter()
                    .all(|(square, side)| square.equals(&side.square()).is_yes())
            );
        }
        assert!(positions[0].b.equals(&positions[1].b).is_no());
        assert!(
            (&of_coupler[0].b - &of_coupler[0].a)
                .equals(&direction.scaled(&four_bar.c))
                .is_yes()
        );
        let side = |p: &Point<K>| relation::twice_area(&positions[0].a, &base, p).is_positive();
        assert!(side(&positions[0].b).is_yes() && side(&positions[1].b).is_no());
    }
    let four_bar: FourBar<Surd> = four_bar([5, 5, 2, 4]);
    let angle = Angle::from_tan_half(&Number::ratio(3, 4));
    assert_closes(&four_bar, angle.direction());
    let unreachable: FourBar<Exact> = FourBar {
        a: Number::one(),
        b: Number::one(),
        c: Number::one(),
        d: Number::from(4),
    };
    assert!(unreachable.with_crank(&Number::one()).is_none());
}

/// The crank's criterion against positions: turned through the whole circle, the triangle MPF closes
/// everywhere exactly if the crank turns, for four-bars of every type.
#[test]
fn a_link_that_turns_closes_everywhere() {
    let mut turning = 0;
    for a in 2..7 {
        for (b, c, d, rho) in [
            (5, 2, 4, 1.0),
            (4, 1, 3, 0.5),
            (6, 3, 2, 2.0),
            (3, 4, 5, -0.7),
        ] {
            let four_bar: FourBar<f64> = four_bar([a, b, c, d]);
            for drive in crank_drives(&four_bar, &Number(rho)).unwrap_or_default() {
                let (s, _) = drive.divisions(&four_bar);
                let closes = (0..720).all(|step| {
                    let sigma = f64::from(step) * std::f64::consts::PI / 360.0;
                    let x = s.0 + drive.r.0 * sigma.cos();
                    let y = drive.r.0 * sigma.sin();
                    let (m, p) = (drive.m.0, drive.p.0);
                    ((m * m + p * p - x * x - y * y) / (2.0 * m * p)).abs() <= 1.0
                });
                assert_eq!(
                    drive.crank(&four_bar) == Some(Crank::Turns),
                    closes,
                    "{drive:?}"
                );
                turning += usize::from(closes);
            }
        }
    }
    assert!(turning > 3, "only {turning} turning cranks tried");
}
