//! Poles of four positions and the four-bar of a pole quadrilateral, on random exact positions.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use burmester::finite::four_positions::circle_conditions::{centerpoint_cubic, circlepoint_cubic};
use burmester::finite::pole_four_bar::{Joints, Pair, PoleFourBar};
use burmester::finite::pole_system::{OfPairs, PAIRS};
use burmester::number::{Exact, Kind, Number, Surd, Truth};
use burmester::plane::displacement::Displacement;
use burmester::plane::projective::{Line, ProjectivePoint, collinear};
use burmester::plane::{Angle, Point, line, relation};
use proptest::prelude::*;

/// The pole quadrilaterals, by the positions after the first.
const ORDERS: [[usize; 3]; 3] = [[2, 3, 4], [2, 4, 3], [4, 2, 3]];

type Positions<K> = [Displacement<K>; 4];

fn yes(truth: Truth) -> bool {
    truth == Truth::Yes
}

/// Rational numbers as pairs, so that a figure can be made in any exact kind.
fn ratios() -> impl Strategy<Value = (i64, i64)> {
    (-30i64..=30, 1i64..8)
}

#[derive(Clone, Debug)]
struct Drawn {
    /// x, y and tan of half the angle, for each position.
    positions: [[(i64, i64); 3]; 4],
    /// Of the crank of l.
    turn: (i64, i64),
}

fn drawn() -> impl Strategy<Value = Drawn> {
    let position = || [ratios(), ratios(), ratios()];
    ([position(), position(), position(), position()], ratios()).prop_filter_map(
        "positions with finite poles that are not all on one line",
        |(positions, turn)| {
            let drawn = Drawn { positions, turn };
            let poles = OfPairs::poles(&drawn.positions::<Exact>());
            let finite = PAIRS.iter().all(|&[i, j]| poles.of(i, j).has_value());
            let spread = || {
                let three = [poles.of(1, 2), poles.of(1, 3), poles.of(1, 4)].map(Clone::clone);
                relation::collinear(&three).is_no()
            };
            (finite && spread()).then_some(drawn)
        },
    )
}

fn number<K: Kind>((numerator, denominator): (i64, i64)) -> Number<K> {
    Number::ratio(numerator, denominator)
}

impl Drawn {
    fn positions<K: Kind>(&self) -> Positions<K> {
        self.positions.map(|[x, y, t]| Displacement {
            rotation: Angle::from_tan_half(&number::<K>(t)).direction().clone(),
            translation: Number::complex(number(x), number(y)),
        })
    }

    fn four_bar<K: Kind>(&self, order: [usize; 3]) -> PoleFourBar<K> {
        let positions = self.positions();
        let (poles, mirror_poles) = (
            OfPairs::poles(&positions),
            OfPairs::mirror_poles(&positions),
        );
        PoleFourBar::of(&poles, &mirror_poles, order)
    }

    /// l, the second joint turned about its pivot.
    fn place<K: Kind>(&self, four_bar: &PoleFourBar<K>) -> Point<K> {
        let turn = Angle::from_tan_half(&number::<K>(self.turn))
            .direction()
            .clone();
        let pivot = &four_bar.frame[1];
        pivot + (&four_bar.poles[1] - pivot) * turn
    }
}

/// The four positions of a point of the moving plane that is given in position 1.
fn places<K: Kind>(positions: &Positions<K>, point: &Point<K>) -> [Point<K>; 4] {
    let moving = positions[0].inverse().of(point);
    positions.each_ref().map(|position| position.of(&moving))
}

/// The points of the moving plane, seen in position 1, with which a fixed point coincides.
fn coincident<K: Kind>(positions: &Positions<K>, point: &Point<K>) -> [Point<K>; 4] {
    positions
        .each_ref()
        .map(|position| positions[0].of(&position.inverse().of(point)))
}

/// Whether all four positions of the circlepoint are as far from the center, a center at infinity
/// being as far from all points of a line across.
fn correspond<K: Kind>(positions: &Positions<K>, pair: &Pair<K>) -> bool {
    match (pair.circlepoint.finite(), pair.center.finite()) {
        (Some(circlepoint), Some(center)) => {
            let squares = places(positions, &circlepoint)
                .map(|place| relation::distance_squared(&place, &center));
            squares.iter().all(|square| yes(square.equals(&squares[0])))
        }
        (Some(circlepoint), None) => are_across(&places(positions, &circlepoint), &pair.center),
        (None, Some(center)) => are_across(&coincident(positions, &center), &pair.circlepoint),
        (None, None) => false,
    }
}

/// Whether points lie on a line perpendicular to a direction.
fn are_across<K: Kind>(points: &[Point<K>; 4], direction: &ProjectivePoint<K>) -> bool {
    let [x, y, w] = direction.coordinates();
    let along = |point: &Point<K>| x * point.re() + y * point.im();
    yes(w.is_zero())
        && points
            .iter()
            .all(|point| yes(along(point).equals(&along(&points[0]))))
}

fn same_sides<K: Kind>(four_bar: &PoleFourBar<K>, moved: &Joints<K>) -> bool {
    let squares = |[b, c]: &Joints<K>| {
        let [a, d] = &four_bar.frame;
        [(a, b), (b, c), (c, d)].map(|(p, q)| relation::distance_squared(p, q))
    };
    let moved = squares(moved);
    [squares(&four_bar.poles), squares(&four_bar.mirror_poles)]
        .iter()
        .all(|at_rest| at_rest.iter().zip(&moved).all(|(x, y)| yes(x.equals(y))))
}

fn midnormal<K: Kind>(p: &Point<K>, q: &Point<K>) -> Line<K> {
    let direction = q - p;
    Line::new(2 * direction.re(), 2 * direction.im(), p.norm() - q.norm())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn mirror_poles_are_mirror_images(drawn in drawn()) {
        let positions = drawn.positions::<Exact>();
        let (poles, mirror) = (OfPairs::poles(&positions), OfPairs::mirror_poles(&positions));
        for [i, j] in PAIRS {
            let expected = if i == 1 {
                poles.of(1, j).clone()
            } else {
                line::mirror(poles.of(i, j), poles.of(1, i), poles.of(1, j))
            };
            prop_assert!(yes(mirror.of(i, j).equals(&expected)), "{i}{j}");
            prop_assert!(yes(mirror.of(j, i).equals(&expected)), "{j}{i}");
        }
    }

    #[test]
    fn both_quadrilaterals_are_positions_of_one_four_bar(drawn in drawn()) {
        for order in ORDERS {
            let four_bar = drawn.four_bar::<Exact>(order);
            prop_assert!(same_sides(&four_bar, &four_bar.poles), "{order:?}");
        }
    }

    /// Vertices and meets of opposite sides, of all three quadrilaterals.
    #[test]
    fn poles_and_meets_of_opposite_sides_are_on_the_curves(drawn in drawn()) {
        let positions = drawn.positions::<Exact>();
        let back = positions[0].inverse();
        let centers = centerpoint_cubic(&positions).unwrap();
        let circlepoints = circlepoint_cubic(&positions).unwrap();
        let (poles, mirror) = (OfPairs::poles(&positions), OfPairs::mirror_poles(&positions));
        let (meets, mirror_meets) = (
            poles.meets_of_opposite_sides(),
            mirror.meets_of_opposite_sides(),
        );
        for [i, j] in PAIRS {
            for point in [poles.of(i, j), meets.of(i, j)] {
                prop_assert!(!point.has_value() || yes(centers.at(point).is_zero()), "{i}{j}");
            }
            for point in [mirror.of(i, j), mirror_meets.of(i, j)] {
                let value = circlepoints.at(&back.of(point));
                prop_assert!(!point.has_value() || yes(value.is_zero()), "{i}{j}");
            }
        }
    }

    #[test]
    fn poles_and_meets_correspond(drawn in drawn()) {
        let positions = drawn.positions::<Exact>();
        let (poles, mirror) = (OfPairs::poles(&positions), OfPairs::mirror_poles(&positions));
        let (meets, mirror_meets) = (
            poles.meets_of_opposite_sides(),
            mirror.meets_of_opposite_sides(),
        );
        for [i, j] in PAIRS {
            for (circlepoint, center) in [
                (mirror.of(i, j), meets.of(i, j)),
                (mirror_meets.of(i, j), poles.of(i, j)),
            ] {
                let pair = Pair {
                    circlepoint: ProjectivePoint::from_finite(circlepoint),
                    center: ProjectivePoint::from_finite(center),
                };
                let finite = circlepoint.has_value() && center.has_value();
                prop_assert!(!finite || correspond(&positions, &pair), "{i}{j}");
            }
        }
    }

    /// Both assemblies for any place of l, with the root that they need held exactly.
    #[test]
    fn every_position_gives_a_circlepoint_and_its_center(drawn in drawn()) {
        let positions = drawn.positions::<Surd>();
        let centers = centerpoint_cubic(&positions).unwrap();
        let circlepoints = circlepoint_cubic(&positions).unwrap();
        let mut within_reach = false;
        for order in ORDERS {
            let four_bar = drawn.four_bar::<Surd>(order);
            let l = drawn.place(&four_bar);
            let Some(assemblies) = four_bar.with_second_joint_at(&l) else {
                continue;
            };
            within_reach = true;
            for joints in assemblies {
                prop_assert!(same_sides(&four_bar, &joints));
                let pair = four_bar.pair(&joints);
                let determined = pair.center.is_determined() & pair.circlepoint.is_determined();
                if determined.is_no() {
                    continue;
                }
                prop_assert!(yes(centers.at_projective(&pair.center).is_zero()));
                if let Some(circlepoint) = pair.circlepoint.finite() {
                    let moving = positions[0].inverse().of(&circlepoint);
                    prop_assert!(yes(circlepoints.at(&moving).is_zero()));
                }
                prop_assert!(correspond(&positions, &pair));
                for (at_rest, point) in [
                    (&four_bar.poles, &pair.center),
                    (&four_bar.mirror_poles, &pair.circlepoint),
                ] {
                    for (from, to) in at_rest.iter().zip(&joints) {
                        let midnormal = midnormal(from, to);
                        prop_assert!(yes(point.is_on(&midnormal)) || yes(from.equals(to)));
                    }
                }
            }
        }
        prop_assume!(within_reach);
    }

    #[test]
    fn infinite_links_are_found_along_the_asymptotes(drawn in drawn()) {
        let positions = drawn.positions::<Exact>();
        let center_end = centerpoint_cubic(&positions).unwrap().real_point_at_infinity();
        let circle_end = circlepoint_cubic(&positions).unwrap().real_point_at_infinity();
        let [x, y, _] = circle_end.coordinates();
        let circle_end = &positions[0].rotation * Number::complex(x.clone(), y.clone());
        for order in ORDERS {
            let four_bar = drawn.four_bar::<Exact>(order);
            if four_bar.center_asymptote().is_zero().is_no() {
                let moved = four_bar.moved_for_infinite_center();
                let pair = four_bar.pair(&moved);
                prop_assert!(same_sides(&four_bar, &moved));
                prop_assert!(yes(pair.center.equals(&center_end)), "{order:?}");
                prop_assert!(correspond(&positions, &pair), "{order:?}");
            }
            if four_bar.circlepoint_asymptote().is_zero().is_no() {
                let moved = four_bar.moved_for_infinite_circlepoint();
                let pair = four_bar.pair(&moved);
                let expected = ProjectivePoint::from_direction(&circle_end);
                prop_assert!(same_sides(&four_bar, &moved));
                prop_assert!(yes(pair.circlepoint.equals(&expected)), "{order:?}");
                prop_assert!(correspond(&positions, &pair), "{order:?}");
            }
        }
    }

    /// A joint that comes to rest on its pole makes the pole a center, and its partner a meet.
    #[test]
    fn a_joint_on_a_pole_gives_the_characteristic_points(drawn in drawn()) {
        let positions = drawn.positions::<Surd>();
        let four_bar = drawn.four_bar::<Surd>([2, 3, 4]);
        let mirror = OfPairs::mirror_poles(&positions);
        let partner = mirror.meets_of_opposite_sides();
        let at_rest = four_bar.with_second_joint_at(&four_bar.poles[1]).unwrap();
        for joints in at_rest {
            let pair = four_bar.pair(&joints);
            if yes(joints[0].equals(&four_bar.poles[0])) {
                prop_assert!(pair.center.is_determined().is_no());
                continue;
            }
            let pole = ProjectivePoint::from_finite(&four_bar.poles[1]);
            prop_assert!(yes(pair.center.equals(&pole)));
            let expected = partner.of(3, 4);
            if expected.has_value() {
                let expected = ProjectivePoint::from_finite(expected);
                prop_assert!(yes(pair.circlepoint.equals(&expected)));
            }
        }
    }
}

#[test]
fn a_place_out_of_reach_has_no_assembly() {
    let point = |x: i64, y: i64| -> Point<Exact> { Number::complex(x.into(), y.into()) };
    let joints = [point(1, 0), point(9, 1)];
    let four_bar = PoleFourBar {
        frame: [point(0, 0), point(10, 0)],
        poles: joints.clone(),
        mirror_poles: joints,
    };
    assert!(four_bar.with_second_joint_at(&point(11, 1)).is_none());
}

#[test]
fn a_parallelogram_has_no_asymptote() {
    let point = |x: i64, y: i64| -> Point<Exact> { Number::complex(x.into(), y.into()) };
    let joints = [point(1, 2), point(5, 2)];
    let four_bar = PoleFourBar {
        frame: [point(0, 0), point(4, 0)],
        poles: joints.clone(),
        mirror_poles: joints,
    };
    assert!(yes(four_bar.center_asymptote().is_zero()));
}

/// Four equal poles of four turns about one point: every point is a circlepoint, so that the
/// condition vanishes.
#[test]
fn turns_about_one_point_make_every_point_a_circlepoint() {
    let positions: Positions<Exact> = [0, 1, 2, 3].map(|t: i64| Displacement {
        rotation: Angle::from_tan_half(&Number::<Exact>::from(t)).cis(),
        translation: Number::zero(),
    });
    let cubic = circlepoint_cubic(&positions).unwrap();
    assert!(cubic.coefficients().iter().all(|c| yes(c.is_zero())));
    let poles = OfPairs::poles(&positions);
    let points = PAIRS.map(|[i, j]| ProjectivePoint::from_finite(poles.of(i, j)));
    assert!(yes(collinear(&points[0], &points[1], &points[2])));
}
