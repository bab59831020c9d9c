//! Angles, relations between points, displacements: exact properties on random figures.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use burmester::number::{Exact, Kind, Number, Surd, Truth};
use burmester::plane::displacement::Displacement;
use burmester::plane::{Angle, Point, relation};
use proptest::prelude::*;
use rug::Rational;

type Real = Number<Exact>;

fn real(numerator: i64, denominator: i64) -> Real {
    Number::ratio(numerator, denominator)
}

fn point(x: i64, y: i64) -> Point<Exact> {
    Number::complex(x.into(), y.into())
}

fn degrees(d: i64) -> Angle<Surd> {
    Angle::from_degrees(&Rational::from(d), &()).unwrap()
}

fn yes(truth: Truth) -> bool {
    truth == Truth::Yes
}

fn same<K: Kind>(a: &Number<K>, b: &Number<K>) -> bool {
    yes(a.equals(b))
}

fn numbers() -> impl Strategy<Value = Real> {
    (-40i64..=40, 1i64..12).prop_map(|(n, d)| real(n, d))
}

fn points() -> impl Strategy<Value = Point<Exact>> {
    (numbers(), numbers()).prop_map(|(x, y)| Number::complex(x, y))
}

/// Every angle with rational tangent of its half, 180° included.
fn angles() -> impl Strategy<Value = Angle<Exact>> {
    prop_oneof![
        9 => numbers().prop_map(|t| Angle::from_tan_half(&t)),
        1 => Just(Angle::from_cos_sin(real(-1, 1), real(0, 1))),
    ]
}

/// A motion of the plane, enlarged or not; mirrored first or not.
#[derive(Clone, Debug)]
struct Change {
    factor: Point<Exact>,
    shift: Point<Exact>,
    mirror: bool,
}

impl Change {
    fn of(&self, z: &Point<Exact>) -> Point<Exact> {
        let z = if self.mirror { z.conj() } else { z.clone() };
        &self.factor * z + &self.shift
    }

    fn of_all(&self, figure: &[Point<Exact>]) -> Vec<Point<Exact>> {
        figure.iter().map(|z| self.of(z)).collect()
    }
}

fn changes() -> impl Strategy<Value = Change> {
    (points(), points(), any::<bool>())
        .prop_filter("a factor that is not zero", |(factor, ..)| {
            factor.is_zero().is_no()
        })
        .prop_map(|(factor, shift, mirror)| Change {
            factor,
            shift,
            mirror,
        })
}

fn displacements() -> impl Strategy<Value = Displacement<Exact>> {
    (angles(), points()).prop_map(|(angle, translation)| Displacement {
        rotation: angle.cis(),
        translation,
    })
}

mod angle {
    use super::*;

    proptest! {
        #[test]
        fn cosine_and_sine_lie_on_the_unit_circle(t in numbers()) {
            let angle = Angle::<Exact>::from_tan_half(&t);
            let (cos, sin) = (angle.cos(), angle.sin());
            prop_assert!(same(&(cos.square() + sin.square()), &Number::one()));
            prop_assert!(same(&(&t * (1 + &cos)), &sin), "tan of the half is sin/(1 + cos)");
            prop_assert!(same(&angle.cis(), &Number::complex(cos, sin)));
        }

        #[test]
        fn sums_and_differences_follow_the_addition_theorems(a in angles(), b in angles()) {
            let (sum, difference) = (&a + &b, &a - &b);
            let (ca, sa, cb, sb) = (a.cos(), a.sin(), b.cos(), b.sin());
            prop_assert!(same(&sum.cos(), &(&ca * &cb - &sa * &sb)));
            prop_assert!(same(&sum.sin(), &(&sa * &cb + &ca * &sb)));
            prop_assert!(same(&difference.cos(), &(&ca * &cb + &sa * &sb)));
            prop_assert!(same(&difference.sin(), &(&sa * &cb - &ca * &sb)));
            prop_assert!(same(&(-&a).cos(), &ca) && same(&(-&a).sin(), &-sa));
            prop_assert!(yes((&difference + &b).equals(&a)));
        }

        #[test]
        fn multiples_are_repeated_sums(a in angles(), n in 0i32..9) {
            let zero = Angle::from_cos_sin(Number::one(), Number::zero());
            let sum = (0..n).fold(zero, |sum, _| &sum + &a);
            prop_assert!(yes(a.times(n).equals(&sum)));
            prop_assert!(yes(a.times(-n).equals(&-&sum)));
            prop_assert!(same(&a.times(n).sin(), &sum.sin()), "the length is known as well");
            prop_assert!(same(&a.times(-n).cos(), &sum.cos()));
        }

        #[test]
        fn tangent_and_cotangent_are_the_quotients(a in angles()) {
            let (cos, sin) = (a.cos(), a.sin());
            prop_assert_eq!(a.tan().has_value(), cos.is_zero().is_no());
            prop_assert_eq!(a.cot().has_value(), sin.is_zero().is_no());
            if cos.is_zero().is_no() {
                prop_assert!(same(&a.tan(), &(&sin / &cos)));
                prop_assert!(yes(Angle::from_tan(a.tan()).equals(&a)));
            }
            if sin.is_zero().is_no() {
                prop_assert!(same(&a.cot(), &(cos / sin)));
            }
        }

        #[test]
        fn a_half_has_the_tangent_that_it_was_made_from(t in numbers()) {
            let angle = Angle::<Exact>::from_tan_half(&t);
            prop_assert!(same(&angle.half().tan(), &t));
            prop_assert!(yes(angle.half().times(2).equals(&angle)));
            prop_assert!(yes(angle.half().equals_modulo_pi(&Angle::from_tan(t))));
        }

        #[test]
        fn a_half_of_an_angle_of_any_length_is_the_same(t in numbers(), factor in 1i64..50) {
            let angle = Angle::<Exact>::from_tan_half(&t);
            let long = angle.direction().scaled(&factor.into());
            prop_assert!(same(&Angle::of(long.clone()).half().tan(), &t));
            let known = Angle::of_known_length(long, factor.into());
            prop_assert!(same(&known.half().tan(), &t));
            prop_assert!(same(&known.cos(), &angle.cos()) && same(&known.sin(), &angle.sin()));
        }

        #[test]
        fn equality_asks_for_the_sense_and_modulo_pi_does_not(a in angles(), b in angles()) {
            let equal = same(&a.cos(), &b.cos()) && same(&a.sin(), &b.sin());
            prop_assert_eq!(a.equals(&b), Truth::from(equal));
            prop_assert_eq!(a.equals_modulo_turn_over(&b, 1), Truth::from(equal));
            let opposite = Angle::from_cos_sin(-a.cos(), -a.sin());
            prop_assert_eq!(a.equals(&opposite), Truth::No);
            prop_assert_eq!(a.equals_modulo_pi(&opposite), Truth::Yes);
            prop_assert_eq!(a.equals_modulo_turn_over(&opposite, 2), Truth::Yes);
            let parallel = yes((a.sin() * b.cos() - a.cos() * b.sin()).is_zero());
            prop_assert_eq!(a.equals_modulo_pi(&b), Truth::from(parallel));
            let right = Angle::from_cos_sin(-a.sin(), a.cos());
            prop_assert_eq!(a.equals_modulo_turn_over(&right, 4), Truth::Yes);
            prop_assert_eq!(a.equals_modulo_turn_over(&right, 2), Truth::No);
        }

        #[test]
        fn a_tangent_knows_its_angle_modulo_pi(t in numbers()) {
            let known = Angle::<Exact>::from_tan(t.clone());
            let angle = Angle::of(Number::complex(Number::one(), t.clone()));
            let opposite = Angle::of(Number::complex(real(-1, 1), -&t));
            prop_assert!(yes(known.equals(&angle)) && yes(known.equals(&opposite)));
            prop_assert!(yes(known.equals_modulo_turn_over(&opposite, 1)));
            prop_assert!(yes(known.times(2).equals(&opposite.times(2))));
            let right = Angle::of(Number::complex(-t, Number::one()));
            prop_assert_eq!(known.equals(&right), Truth::No);
            prop_assert_eq!(known.equals_modulo_turn_over(&right, 4), Truth::Yes);
            prop_assert_eq!(known.times(2).equals(&right.times(2)), Truth::No);
        }

        #[test]
        fn a_vertex_angle_turns_with_nothing_but_a_mirror(
            a in points(), b in points(), c in points(), change in changes(),
        ) {
            prop_assume!(a.equals(&b).is_no() && c.equals(&b).is_no());
            let angle = Angle::at_vertex(&a, &b, &c);
            let [a1, b1, c1] = [&a, &b, &c].map(|z| change.of(z));
            let image = Angle::at_vertex(&a1, &b1, &c1);
            let expected = if change.mirror { -&angle } else { angle.clone() };
            prop_assert!(yes(image.equals(&expected)));
            prop_assert!(yes(Angle::at_vertex(&c, &b, &a).equals(&-&angle)));
        }
    }

    /// n, and two angles in degrees that differ by a multiple of 360°/n or not.
    #[test]
    fn equality_modulo_a_part_of_the_turn() {
        for n in [1u16, 2, 3, 4, 6, 8, 12, 24] {
            for steps in 0..24 {
                let expected = (steps * i64::from(n)) % 24 == 0;
                let (a, b) = (degrees(75), degrees(75 + 15 * steps));
                let found = a.equals_modulo_turn_over(&b, n);
                assert_eq!(found, expected.into(), "{steps} · 15° modulo 360°/{n}");
            }
        }
    }

    #[test]
    fn equality_modulo_a_part_of_the_turn_where_a_half_turn_is_unknown() {
        let a = Angle::from_tan(degrees(15).tan());
        for n in [1u16, 2, 3, 4, 6, 12] {
            for steps in 0..24 {
                let expected = [0, 12]
                    .iter()
                    .any(|half| ((steps + half) * i64::from(n)) % 24 == 0);
                let found = a.equals_modulo_turn_over(&degrees(15 + 15 * steps), n);
                assert_eq!(
                    found,
                    expected.into(),
                    "{steps} · 15° modulo 360°/{n} or 180°"
                );
            }
        }
    }

    #[test]
    fn the_half_of_an_angle_known_modulo_pi_is_known_modulo_a_quarter_turn() {
        let half = Angle::from_tan(degrees(60).tan()).half();
        for (angle, expected) in [
            (30, true),
            (120, true),
            (210, true),
            (300, true),
            (75, false),
        ] {
            let found = half.equals(&degrees(angle));
            assert_eq!(
                found,
                expected.into(),
                "half of 60° or 240°, against {angle}°"
            );
        }
        let twice = half.times(2);
        assert_eq!(twice.equals(&degrees(60)), Truth::Yes);
        assert_eq!(
            twice.equals(&degrees(240)),
            Truth::Yes,
            "twice the half knows no more"
        );
        assert_eq!(twice.equals(&degrees(150)), Truth::No);
        assert_eq!(half.times(4).equals(&degrees(300)), Truth::No);
        assert_eq!(half.times(4).equals(&degrees(120)), Truth::Yes);
    }

    #[test]
    fn directions_of_the_axes() {
        let (a, b, c) = (point(1, 0), point(0, 0), point(0, 1));
        let right = Angle::at_vertex(&a, &b, &c);
        assert!(
            same(&right.sin(), &Number::one()),
            "counterclockwise is positive"
        );
        assert!(same(&right.cos(), &Number::zero()));
        assert!(!right.tan().has_value(), "tan 90° has no value");
        assert!(same(&right.cot(), &Number::zero()));
        let straight = right.times(2);
        assert!(same(&straight.cos(), &real(-1, 1)));
        assert!(
            !straight.half().has_value(),
            "the half of 180° has no direction here"
        );
        assert!(!straight.cot().has_value());
    }

    #[test]
    fn a_vertex_that_is_an_end_gives_no_angle() {
        let (a, b) = (point(1, 2), point(3, 4));
        assert!(!Angle::at_vertex(&a, &a, &b).has_value());
        assert!(!Angle::at_vertex(&b, &a, &a).has_value());
        assert!(Angle::at_vertex(&b, &a, &b).has_value(), "0° is an angle");
    }
}

mod relations {
    use super::*;

    proptest! {
        #[test]
        fn area_and_distance(a in points(), b in points(), c in points(), change in changes()) {
            let area = relation::twice_area(&a, &b, &c);
            prop_assert!(same(&relation::twice_area(&b, &c, &a), &area));
            prop_assert!(same(&relation::twice_area(&b, &a, &c), &-&area));
            let shoelace = a.re() * (b.im() - c.im()) + b.re() * (c.im() - a.im())
                + c.re() * (a.im() - b.im());
            prop_assert!(same(&shoelace, &area));
            let [a1, b1, c1] = [&a, &b, &c].map(|z| change.of(z));
            let sign = if change.mirror { -1 } else { 1 };
            let expected = sign * change.factor.norm() * area;
            prop_assert!(same(&relation::twice_area(&a1, &b1, &c1), &expected));
            let (dx, dy) = (a.re() - b.re(), a.im() - b.im());
            let squared = relation::distance_squared(&a, &b);
            prop_assert!(same(&squared, &(dx.square() + dy.square())));
            prop_assert!(same(
                &relation::distance_squared(&a1, &b1),
                &(change.factor.norm() * squared)
            ));
        }

        #[test]
        fn points_of_a_line_are_collinear_and_others_are_not(
            a in points(), direction in points(), steps in prop::collection::vec(numbers(), 3..6),
            change in changes(), which in 0usize..6,
        ) {
            let mut figure: Vec<_> = steps.iter().map(|t| &a + direction.scaled(t)).collect();
            prop_assert!(yes(relation::collinear(&figure)));
            prop_assert!(yes(relation::collinear(&change.of_all(&figure))));
            // One point off the line: then no line holds all, unless the others coincide.
            let which = which % figure.len();
            let others: Vec<_> = figure.iter().enumerate().filter(|(i, _)| *i != which).collect();
            let distinct = others.iter().any(|(_, z)| z.equals(others[0].1).is_no());
            figure[which] = &figure[which] + &direction * Number::i();
            let expected = Truth::from(!distinct || yes(direction.is_zero()));
            prop_assert_eq!(relation::collinear(&figure), expected);
            prop_assert_eq!(relation::collinear(&change.of_all(&figure)), expected);
        }

        #[test]
        fn points_of_a_circle_are_concyclic_and_others_are_not(
            center in points(), arm in points(), turns in prop::collection::vec(angles(), 4..6),
            change in changes(), outwards in 2i64..5,
        ) {
            prop_assume!(arm.is_zero().is_no());
            let mut figure: Vec<_> = turns.iter().map(|t| &center + &arm * t.cis()).collect();
            prop_assert!(yes(relation::concyclic(&figure)));
            prop_assert!(yes(relation::concyclic(&change.of_all(&figure))));
            let distinct = (1..figure.len()).all(|i| {
                (1..i).all(|j| figure[i].equals(&figure[j]).is_no())
            });
            prop_assume!(distinct);
            figure[0] = &center + (&figure[0] - &center).scaled(&outwards.into());
            prop_assert_eq!(relation::concyclic(&figure), Truth::No);
            prop_assert_eq!(relation::concyclic(&change.of_all(&figure)), Truth::No);
        }

        #[test]
        fn figures_alike(
            figure in prop::collection::vec(points(), 3..6), change in changes(), off in points(),
        ) {
            let spread = relation::collinear(&figure).is_no();
            let mut image = change.of_all(&figure);
            let expected = Truth::from(!change.mirror || !spread);
            if spread || !change.mirror {
                prop_assert_eq!(relation::similar(&figure, &image), expected);
                prop_assert_eq!(relation::similar(&image, &figure), expected);
            }
            prop_assume!(spread && off.is_zero().is_no() && !change.mirror);
            let last = image.len() - 1;
            image[last] = &image[last] + &off;
            let apart = figure[0].equals(&figure[1]).is_no();
            if apart {
                prop_assert_eq!(relation::similar(&figure, &image), Truth::No);
            }
        }
    }

    #[test]
    fn counterclockwise_is_positive() {
        let area = relation::twice_area(&point(0, 0), &point(1, 0), &point(0, 1));
        assert!(same(&area, &Number::one()));
    }

    #[test]
    fn distances_that_are_irrational_have_no_value_in_rationals() {
        let (a, b) = (point(0, 0), point(1, 1));
        assert!(!relation::distance(&a, &b).has_value());
        assert!(same(&relation::distance(&a, &point(3, 4)), &real(5, 1)));
        let root =
            relation::distance::<Surd>(&Number::zero(), &Number::complex(1.into(), 1.into()));
        assert!(same(&root.square(), &2.into()));
    }

    #[test]
    fn coincident_points() {
        let (a, b, c, d) = (point(1, 2), point(3, 5), point(-4, 1), point(0, 7));
        let clone = |list: &[&Point<Exact>]| list.iter().map(|z| (*z).clone()).collect::<Vec<_>>();
        for (list, expected) in [
            (vec![&a, &a, &b], Truth::Yes),
            (vec![&a, &a, &a], Truth::Yes),
            (vec![&a, &a, &b, &c], Truth::No),
            (vec![&a, &b], Truth::Yes),
            (vec![], Truth::Yes),
        ] {
            assert_eq!(relation::collinear(&clone(&list)), expected, "{list:?}");
        }
        for (list, expected) in [
            (vec![&a, &a, &b, &c], Truth::Yes),
            (vec![&a, &b, &c, &d], Truth::No),
            (vec![&a, &a, &b, &c, &d], Truth::No),
            (vec![&a, &b, &c], Truth::Yes),
        ] {
            assert_eq!(relation::concyclic(&clone(&list)), expected, "{list:?}");
        }
        for (figure, other, expected) in [
            (vec![&a, &a, &b], vec![&c, &c, &d], Truth::Yes),
            (vec![&a, &a, &b], vec![&c, &d, &d], Truth::No),
            (vec![&a, &b, &c], vec![&a, &b], Truth::No),
            (vec![&a, &b], vec![&c, &d], Truth::Yes),
            (vec![], vec![], Truth::Unknown),
        ] {
            let found = relation::similar(&clone(&figure), &clone(&other));
            assert_eq!(found, expected, "{figure:?} and {other:?}");
        }
    }

    #[test]
    fn points_of_a_line_count_as_concyclic() {
        let line: Vec<_> = [0, 1, 3, 7].map(|t| point(t, 2 * t + 1)).into();
        assert_eq!(relation::concyclic(&line), Truth::Yes);
    }
}

mod displacement {
    use super::*;

    proptest! {
        #[test]
        fn the_pole_is_where_the_relative_displacement_leaves_it(
            first in displacements(), second in displacements(),
        ) {
            let pole = first.pole(&second);
            let same_turn = yes(first.rotation.equals(&second.rotation));
            prop_assert_eq!(pole.has_value(), !same_turn);
            if same_turn {
                return Ok(());
            }
            // The point of the moving plane that lies on the pole in the first position.
            let moving = (&pole - &first.translation) * first.rotation.conj();
            prop_assert!(same(&first.of(&moving), &pole), "first position");
            prop_assert!(same(&second.of(&moving), &pole), "second position");
            prop_assert!(same(&second.pole(&first), &pole), "of either before the other");
            // Seen from the pole every point turns by the difference of the two angles.
            let other = &moving + point(2, 1);
            let turn = &second.rotation * first.rotation.conj();
            prop_assert!(same(
                &(second.of(&other) - &pole),
                &((first.of(&other) - &pole) * turn)
            ));
        }

        #[test]
        fn the_pole_moves_with_the_fixed_plane(
            first in displacements(), second in displacements(), by in displacements(),
        ) {
            prop_assume!(first.rotation.equals(&second.rotation).is_no());
            let moved = |d: &Displacement<Exact>| Displacement {
                rotation: &by.rotation * &d.rotation,
                translation: by.of(&d.translation),
            };
            let pole = moved(&first).pole(&moved(&second));
            prop_assert!(same(&pole, &by.of(&first.pole(&second))));
        }
    }

    proptest! {
        #[test]
        fn the_projective_pole_is_the_pole_or_at_infinity_across_the_translation(
            first in displacements(), second in displacements(),
        ) {
            let pole = first.projective_pole(&second);
            let shift = &second.translation - &first.translation;
            if yes(first.rotation.equals(&second.rotation)) {
                prop_assert_eq!(pole.is_determined(), !shift.is_zero());
                let [x, y, w] = pole.coordinates();
                prop_assert!(yes(w.is_zero()), "at infinity");
                prop_assert!(yes((x * shift.re() + y * shift.im()).is_zero()), "across");
            } else {
                prop_assert!(same(&pole.finite().unwrap(), &first.pole(&second)));
            }
            let back = second.projective_pole(&first);
            prop_assert_ne!(pole.equals(&back), Truth::No, "of either before the other");
        }

        #[test]
        fn inverse_and_product_are_those_of_maps(
            first in displacements(), second in displacements(), z in points(),
        ) {
            prop_assert!(same(&first.inverse().of(&first.of(&z)), &z));
            prop_assert!(same(&first.after(&second).of(&z), &first.of(&second.of(&z))));
        }
    }

    #[test]
    fn half_a_revolution_has_its_pole_in_the_middle() {
        let here = Displacement::<Exact>::identity();
        let there = Displacement {
            rotation: Number::from(-1),
            translation: point(4, 6),
        };
        let pole = here.projective_pole(&there);
        assert!(same(&pole.finite().unwrap(), &point(2, 3)));
    }

    #[test]
    fn a_quarter_turn_then_a_shift() {
        let displacement = Displacement::<Exact> {
            rotation: Number::i(),
            translation: point(5, 7),
        };
        assert!(same(&displacement.of(&point(2, 3)), &point(2, 9)));
        // X = i X + 5 + 7i
        assert!(same(
            &Displacement::identity().pole(&displacement),
            &point(-1, 6)
        ));
    }

    #[test]
    fn equal_positions_and_translations_have_no_pole() {
        let here = Displacement::<Exact>::identity();
        let there = Displacement {
            rotation: Number::one(),
            translation: point(1, 2),
        };
        assert!(!here.pole(&here).has_value(), "equal positions");
        assert!(!here.pole(&there).has_value(), "a translation");
    }
}

#[test]
fn angles_know_modulo_what_they_are_known() {
    let tangent = Angle::from_tan(real(1, 2));
    assert_eq!(tangent.ambiguity(), 2);
    assert_eq!(Angle::of(point(1, 2)).ambiguity(), 1);
    assert_eq!(Angle::from_cos_sin(real(3, 5), real(4, 5)).ambiguity(), 1);
}
