//! Constructions of centerpoints and circlepoints for four positions.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use burmester::finite::compatibility::{Assemblies, Dyad, LoopClosure, Triangle};
use burmester::finite::equal_angles::{Meets, OppositeSides};
use burmester::finite::half_angles::{self, Sight};
use burmester::number::{Ball, Exact, Kind, Number, Real, Surd, Truth};
use burmester::plane::circular_cubic::Cubic;
use burmester::plane::displacement::Displacement;
use burmester::plane::projective::ProjectivePoint;
use burmester::plane::{Angle, Point, relation};
use proptest::prelude::*;
use rug::Rational;

/// A small rational number.
type Small = (i32, i32);

fn number<K: Kind>((numerator, denominator): Small) -> Number<K> {
    Rational::from((numerator, denominator)).into()
}

fn point<K: Kind>([x, y]: [Small; 2]) -> Point<K> {
    Number::complex(number(x), number(y))
}

/// e^{iθ} with tan θ/2 given.
fn turn<K: Real>(half_tangent: Small) -> Point<K> {
    Angle::from_tan_half(&number(half_tangent))
        .direction()
        .clone()
}

/// A position by tan θ/2 and the place of the moving origin.
type Place = (Small, [Small; 2]);

fn position<K: Real>((half_tangent, origin): Place) -> Displacement<K> {
    Displacement {
        rotation: turn(half_tangent),
        translation: point(origin),
    }
}

fn positions<K: Real>(places: [Place; 4]) -> [Displacement<K>; 4] {
    places.map(position)
}

/// Whether a circlepoint, given where it is in position 1, is at one distance from its center in all
/// positions.
fn is_pair<K: Kind>(
    positions: &[Displacement<K>; 4],
    circlepoint: &Point<K>,
    center: &Point<K>,
) -> Truth {
    let moving = positions[0].inverse().of(circlepoint);
    let square = relation::distance_squared(circlepoint, center);
    let same = |position: &Displacement<K>| {
        relation::distance_squared(&position.of(&moving), center).equals(&square)
    };
    Truth::all(positions.iter().map(same))
}

fn pole<K: Kind>(one: &Displacement<K>, other: &Displacement<K>) -> ProjectivePoint<K> {
    one.projective_pole(other)
}

/// The centerpoint curve: vertices that follow each other share a position.
fn curve<K: Kind>([one, two, three, four]: &[Displacement<K>; 4]) -> Option<Cubic<K>> {
    let vertices = [(one, three), (two, three), (two, four), (one, four)]
        .map(|(from, to)| pole(from, to).finite());
    let [Some(a), Some(b), Some(c), Some(d)] = vertices else {
        return None;
    };
    Cubic::focal(&[a, b, c, d])
}

fn is_on_curve<K: Kind>(positions: &[Displacement<K>; 4], center: &Point<K>) -> bool {
    curve(positions).is_none_or(|cubic| cubic.at(center).is_zero().is_yes())
}

fn sights<K: Kind>([one, two, three, _]: &[Displacement<K>; 4]) -> [Sight<K>; 2] {
    [Sight::of(one, two), Sight::of(one, three)]
}

fn small() -> impl Strategy<Value = Small> + Clone {
    (-30..=30, 1..=12).prop_map(|(numerator, denominator)| (numerator, denominator))
}

fn corner() -> impl Strategy<Value = [Small; 2]> + Clone {
    [small(), small()]
}

fn places() -> impl Strategy<Value = [Place; 4]> {
    let place = (small(), corner());
    [place.clone(), place.clone(), place.clone(), place]
}

/// Positions that share turns, places, or both.
fn degenerate_places() -> impl Strategy<Value = [Place; 4]> {
    let few = prop::sample::select(vec![(0, 1), (1, 1), (-1, 1)]);
    let place = (few.clone(), [few.clone(), few]);
    [place.clone(), place.clone(), place.clone(), place]
}

/// Positions that bring a point to given directions from a center.
fn led<K: Real>(
    center: &Point<K>,
    start: &Point<K>,
    turns: [Small; 3],
    cranks: &[Point<K>; 3],
) -> [Displacement<K>; 4] {
    let at = |j: usize| {
        let rotation = turn(turns[j]);
        let place = center + &cranks[j] * (start - center);
        Displacement {
            translation: place - &rotation * start,
            rotation,
        }
    };
    [Displacement::identity(), at(0), at(1), at(2)]
}

fn finite_pair<K: Kind>(pair: &Dyad<K>) -> bool {
    pair.center.has_value() && pair.circlepoint.has_value()
}

/// The constructed points, where there are any.
fn found<K: Clone>(meets: &Meets<K>) -> Vec<Point<K>>
where
    Point<K>: Clone,
{
    match meets {
        Meets::Two(both) => both.to_vec(),
        Meets::Double(one) | Meets::Single(one) => vec![one.clone()],
        Meets::None | Meets::Undecided => Vec::new(),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    /// Both dyads of every crank angle lead their circlepoint on a circle.
    #[test]
    fn dyads_of_a_crank_angle(places in places(), along in corner(), crank in small()) {
        let positions = positions::<Surd>(places);
        let loops = LoopClosure::of(&positions, &point(along));
        if let Assemblies::Two(dyads) = loops.dyads(&turn(crank)) {
            for dyad in dyads.iter().filter(|dyad| finite_pair(dyad)) {
                prop_assert_eq!(is_pair(&positions, &dyad.circlepoint, &dyad.center), Truth::Yes);
                prop_assert!(is_on_curve(&positions, &dyad.center));
                let w = &dyad.circlepoint - &dyad.center;
                prop_assert_eq!(w.equals(&dyad.w), Truth::Yes);
                // In position 2 the crank has turned by the given angle.
                let moving = positions[0].inverse().of(&dyad.circlepoint);
                let second = &dyad.center + turn::<Surd>(crank) * &dyad.w;
                prop_assert_eq!(positions[1].of(&moving).equals(&second), Truth::Yes);
            }
        }
    }

    /// The dyad that led the plane is found again, whatever point the loop goes through.
    #[test]
    fn the_dyad_that_was_chosen(
        center in corner(), start in corner(), along in corner(),
        turns in [small(), small(), small()], cranks in [small(), small(), small()],
    ) {
        let (center, start) = (point::<Exact>(center), point(start));
        let cranks = cranks.map(turn);
        let positions = led(&center, &start, turns, &cranks);
        let loops = LoopClosure::of(&positions, &point(along));
        let dyads = match loops.dyads(&cranks[0]) {
            Assemblies::Two(both) => both.to_vec(),
            Assemblies::Flat(one) => vec![one],
            _ => Vec::new(),
        };
        let determined = dyads.iter().all(finite_pair);
        prop_assert!(!dyads.is_empty() || loops.triangle(&cranks[0]).base.is_zero().is_yes());
        let is_chosen = |dyad: &Dyad<Exact>| {
            (dyad.center.equals(&center) & dyad.circlepoint.equals(&start)).is_yes()
        };
        prop_assert!(!determined || dyads.is_empty() || dyads.iter().any(is_chosen));
    }

    /// The triangle closes in both assemblies, mirror images in its base.
    #[test]
    fn triangles_close(base in corner(), first in corner(), second in corner()) {
        let triangle = Triangle::<Surd> { base: point(base), sides: [point(first), point(second)] };
        let [a, b] = &triangle.sides;
        let [long, short] = [relation::distance(&Number::zero(), a), relation::distance(&Number::zero(), b)];
        let base = relation::distance(&Number::zero(), &triangle.base);
        let reaches = (&long + &short - &base).sign().unwrap().is_ge()
            && (&base - (&long - &short).abs()).sign().unwrap().is_ge();
        match triangle.assemblies() {
            Assemblies::Two(both) => {
                prop_assert!(reaches);
                let [one, other] = both.each_ref().map(|[third, _]| third * a / &triangle.base);
                if one.has_value() {
                    prop_assert_eq!(one.equals(&other.conj()), Truth::Yes);
                    prop_assert_eq!((-one.im()).is_positive(), Truth::Yes);
                    for [third, fourth] in &both {
                        prop_assert_eq!(third.norm().equals(&Number::one()), Truth::Yes);
                        prop_assert_eq!((third * a + fourth * b).equals(&triangle.base), Truth::Yes);
                    }
                }
            }
            Assemblies::None => prop_assert!(!reaches || base.is_zero().is_yes()),
            Assemblies::Flat(_) | Assemblies::Every => prop_assert!(reaches),
            Assemblies::Undecided => prop_assert!(false, "decided exactly"),
        }
    }

    /// The circles over opposite sides meet in centerpoints, and the poles tell their circlepoints.
    #[test]
    fn centerpoints_from_an_angle(places in places(), alpha in small()) {
        let positions = positions::<Surd>(places);
        let sides = OppositeSides::of(&positions);
        let alpha = Angle::from_tan_half(&number(alpha));
        for center in found(&sides.centerpoints(&alpha)) {
            prop_assert!(is_on_curve(&positions, &center));
            if let Some(circlepoint) = half_angles::circlepoint(&center, &sights(&positions)).finite() {
                prop_assert_eq!(is_pair(&positions, &circlepoint, &center), Truth::Yes);
            }
        }
        for (circle, [from, to]) in sides.circles(&alpha).iter().zip(&sides.0) {
            let (Some(p), Some(q)) = (from.finite(), to.finite()) else { continue };
            prop_assert_eq!(circle.contains(&p) & circle.contains(&q), Truth::Yes);
            let center = circle.center();
            if circle.is_line().is_no() && p.equals(&q).is_no() {
                let at_pole = Angle::at_vertex(&q, &p, &center);
                prop_assert!(center.equals(&p).is_yes() || at_pole.equals_modulo_pi(&alpha).is_yes());
                let apart = relation::distance_squared(&center, &p);
                prop_assert_eq!(apart.equals(&relation::distance_squared(&center, &q)), Truth::Yes);
            }
        }
    }

    /// From circlepoint to center and back.
    #[test]
    fn half_angles_match_pairs(
        center in corner(), start in corner(),
        turns in [small(), small(), small()], cranks in [small(), small(), small()],
    ) {
        let (center, start) = (point::<Exact>(center), point(start));
        let positions = led(&center, &start, turns, &cranks.map(turn));
        let sights = sights(&positions);
        if let Some(found) = half_angles::center(&start, &sights).finite() {
            prop_assert_eq!(found.equals(&center), Truth::Yes);
        }
        if let Some(found) = half_angles::circlepoint(&center, &sights).finite() {
            prop_assert_eq!(found.equals(&start), Truth::Yes);
        }
    }

    /// Equal turns, equal places, equal positions: an answer or none, and what is found is right.
    #[test]
    fn degenerate_positions(places in degenerate_places(), along in corner(), angle in small()) {
        let positions = positions::<Surd>(places);
        let loops = LoopClosure::of(&positions, &point(along));
        if let Assemblies::Two(dyads) = loops.dyads(&turn(angle)) {
            for dyad in dyads.iter().filter(|dyad| finite_pair(dyad)) {
                prop_assert_eq!(is_pair(&positions, &dyad.circlepoint, &dyad.center), Truth::Yes);
            }
        }
        let alpha = Angle::from_tan_half(&number(angle));
        let centers = found(&OppositeSides::of(&positions).centerpoints(&alpha));
        let sights = sights(&positions);
        for center in centers.into_iter().chain([point(along)]) {
            let _ = half_angles::circlepoint(&center, &sights).is_determined();
            let _ = half_angles::center(&center, &sights).is_determined();
        }
    }

    /// Floats and balls give what exact numbers give.
    #[test]
    fn other_kinds_agree(places in places(), along in corner(), crank in small()) {
        let exact = LoopClosure::of(&positions::<Surd>(places), &point(along)).dyads(&turn(crank));
        let ball = LoopClosure::of(&positions::<Ball>(places), &point(along)).dyads(&turn(crank));
        match (exact, ball) {
            (Assemblies::Two(exact), Assemblies::Two(balls)) => {
                for (exact, ball) in exact.iter().zip(&balls).filter(|(exact, _)| finite_pair(exact)) {
                    let [x, y] = [exact.center.re(), exact.center.im()].map(|x| x.0.enclosure(64));
                    prop_assert!(!x.equals(ball.center.re()).is_no());
                    prop_assert!(!y.equals(ball.center.im()).is_no());
                }
            }
            (_, Assemblies::Undecided) | (Assemblies::None, Assemblies::None) => {}
            (exact, ball) => prop_assert!(
                matches!((exact, ball), (Assemblies::Flat(_), Assemblies::Flat(_)) | (Assemblies::Every, Assemblies::Every))
            ),
        }
    }
}

/// For γ₂ = 0 and for γ₂ = φ₂ one assembly is a crank that does not turn, or that turns with the
/// plane: it solves the compatibility equation and belongs to no dyad.
#[test]
fn trivial_solutions_are_no_dyads() {
    let places = [
        ((0, 1), [(0, 1), (0, 1)]),
        ((1, 3), [(2, 1), (1, 1)]),
        ((-2, 5), [(1, 2), (3, 1)]),
        ((3, 2), [(-1, 1), (2, 3)]),
    ];
    let positions = positions::<Surd>(places);
    let loops = LoopClosure::of(&positions, &Number::zero());
    for (crank, trivial) in [
        (Number::one(), [Number::one(), Number::one()]),
        (turn((1, 3)), [turn((-2, 5)), turn((3, 2))]),
    ] {
        let Assemblies::Two(both) = loops.triangle(&crank).assemblies() else {
            panic!("the triangle closes");
        };
        let is_trivial = |[third, fourth]: &[Point<Surd>; 2]| {
            third.equals(&trivial[0]).is_yes() && fourth.equals(&trivial[1]).is_yes()
        };
        assert_eq!(both.iter().filter(|turns| is_trivial(turns)).count(), 1);
        let Assemblies::Two(dyads) = loops.dyads(&crank) else {
            panic!("the triangle closes");
        };
        assert_eq!(dyads.iter().filter(|dyad| finite_pair(dyad)).count(), 1);
    }
}

#[test]
fn a_pole_at_infinity_makes_a_line_of_its_circle() {
    let places = [
        ((0, 1), [(0, 1), (0, 1)]),
        ((1, 2), [(1, 1), (2, 1)]),
        ((0, 1), [(3, 1), (1, 1)]),
        ((-1, 3), [(2, 1), (-1, 1)]),
    ];
    let positions = positions::<Surd>(places);
    let sides = OppositeSides::of(&positions);
    assert_eq!(sides.0[0][0].is_at_infinity(), Truth::Yes);
    let sights = [
        Sight::of(&positions[0], &positions[1]),
        Sight::of(&positions[0], &positions[3]),
    ];
    let mut count = 0;
    for half_tangent in -6..=6 {
        let alpha = Angle::from_tan_half(&number((half_tangent, 7)));
        let [line, circle] = sides.circles(&alpha);
        assert_eq!((line.is_line(), circle.is_line()), (Truth::Yes, Truth::No));
        for center in found(&sides.centerpoints(&alpha)) {
            let circlepoint = half_angles::circlepoint(&center, &sights).finite().unwrap();
            assert_eq!(is_pair(&positions, &circlepoint, &center), Truth::Yes);
            count += 1;
        }
    }
    assert!(count >= 6, "only {count} centerpoints");
}

/// A point that is moved along a line has its center at infinity.
#[test]
fn a_slide_has_its_center_at_infinity() {
    let start = point::<Exact>([(1, 1), (2, 1)]);
    let at = |half_tangent: Small, along: i64| {
        let rotation: Point<Exact> = turn(half_tangent);
        let place = &start + Number::from(along);
        Displacement {
            translation: place - &rotation * &start,
            rotation,
        }
    };
    let first = Displacement::identity();
    let sights = [
        Sight::of(&first, &at((1, 3), 4)),
        Sight::of(&first, &at((-2, 5), 7)),
    ];
    let center = half_angles::center(&start, &sights);
    assert_eq!(center.is_at_infinity(), Truth::Yes);
    let across = ProjectivePoint::from_direction(&Number::i());
    assert_eq!(center.equals(&across), Truth::Yes);
}
