//! Curvature theory under the changes that it must follow: mirror, turn, scale, exchange of the cranks
//! and of the planes; and its special values.
#![allow(
    clippy::unwrap_used,
    clippy::as_conversions,
    clippy::indexing_slicing,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use crate::support::seed::{generator, rounds};
use burmester::curvature::burmester::by_contact;
use burmester::curvature::canonical::Canonical;
use burmester::curvature::closure;
use burmester::curvature::contact::Guide;
use burmester::curvature::motion::Motion;
use burmester::curvature::osculation::{
    center_of_curvature, cubic_of_centers, inflection_circle, stationary_cubic,
};
use burmester::curvature::slider_crank::{Alternates, SliderCrank};
use burmester::finite::five_positions::conics::{Isolated, Pairs, Place};
use burmester::number::{Ball, Complex, Exact, Number, Surd};
use burmester::plane::{Angle, Point};
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use rug::Rational;

type P = Point<Exact>;

/// The pins and the pivots of two cranks.
#[derive(Clone)]
struct FourBar {
    pins: [P; 2],
    pivots: [P; 2],
}

fn point(random: &mut ChaCha8Rng) -> P {
    let mut part = || Number::from(Rational::from((random.random_range(-50..=50), 7)));
    Number::complex(part(), part())
}

impl FourBar {
    fn random(random: &mut ChaCha8Rng) -> Self {
        FourBar {
            pins: [point(random), point(random)],
            pivots: [point(random), point(random)],
        }
    }

    fn map(&self, change: impl Fn(&P) -> P) -> Self {
        FourBar {
            pins: self.pins.each_ref().map(&change),
            pivots: self.pivots.each_ref().map(&change),
        }
    }

    /// The other plane moves.
    fn inverse(&self) -> Self {
        FourBar {
            pins: self.pivots.clone(),
            pivots: self.pins.clone(),
        }
    }

    fn motion(&self) -> Option<Motion<Exact>> {
        let guide = |i: usize| Guide::Circle {
            point: self.pins[i].clone(),
            center: self.pivots[i].clone(),
        };
        closure::motion(&[guide(0), guide(1)], 4)
    }
}

/// Random linkages with a pole that is finite and an inflection circle that is no point.
fn linkages(name: &str) -> impl Iterator<Item = (FourBar, Motion<Exact>, Canonical<Exact>)> {
    let mut random = generator(name);
    let found = std::iter::from_fn(move || Some(FourBar::random(&mut random)));
    found
        .filter_map(|linkage| {
            let motion = linkage.motion()?;
            let canonical = Canonical::of(&motion)?;
            let regular = canonical.invariants.fourth.has_value();
            regular.then_some((linkage, motion, canonical))
        })
        .take(rounds(20))
}

#[track_caller]
fn equal(left: &P, right: &P) {
    assert!(left.equals(right).is_yes(), "{left:?} and {right:?}");
}

#[test]
fn turned_scaled_and_moved_linkages_have_the_same_invariants() {
    let mut random = generator("similarity");
    for (linkage, _, canonical) in linkages("similar linkages") {
        let (factor, shift) = (point(&mut random) + 1, point(&mut random));
        let similar = |z: &P| &factor * z + &shift;
        let changed = linkage.map(similar).motion().unwrap();
        let changed = Canonical::of(&changed).unwrap();
        equal(&changed.pole, &similar(&canonical.pole));
        equal(
            &changed.inflection_pole(),
            &similar(&canonical.inflection_pole()),
        );
        equal(&changed.invariants.third, &canonical.invariants.third);
        equal(&changed.invariants.fourth, &canonical.invariants.fourth);
    }
}

#[test]
fn very_large_and_very_small_linkages_have_as_many_burmester_points() {
    let power = |n: i32| Number::<Exact>::from(10).power(n);
    for (linkage, motion, _) in linkages("sizes") {
        let expected = by_contact(&motion).map(counts);
        for n in [-30, 30] {
            let scaled = linkage.map(|z| z.scaled(&power(n))).motion().unwrap();
            assert_eq!(by_contact(&scaled).map(counts), expected, "10^{n}");
        }
    }
}

/// Real and complex pairs, families as none.
fn counts(pairs: Pairs) -> Option<(usize, usize)> {
    isolated(pairs).map(|pairs| (pairs.real(64).len(), pairs.complex(64).len()))
}

fn isolated(pairs: Pairs) -> Option<Isolated> {
    match pairs {
        Pairs::Isolated(pairs) => Some(*pairs),
        Pairs::Families(_) => None,
    }
}

/// The mirror image turns the other way: (a₃, b₃) becomes (a₃, −b₃), (a₄, b₄) becomes (−a₄, b₄).
#[test]
fn mirrored_linkages_have_mirrored_invariants() {
    for (linkage, motion, canonical) in linkages("mirrored linkages") {
        let mirrored = linkage.map(Number::conj).motion().unwrap();
        let image = Canonical::of(&mirrored).unwrap();
        equal(&image.pole, &canonical.pole.conj());
        equal(
            &image.inflection_pole(),
            &canonical.inflection_pole().conj(),
        );
        equal(&image.invariants.third, &canonical.invariants.third.conj());
        equal(
            &image.invariants.fourth,
            &-canonical.invariants.fourth.conj(),
        );
        let (cubic, other) = (
            stationary_cubic(&motion).unwrap(),
            stationary_cubic(&mirrored).unwrap(),
        );
        let [x3, x2y, xy2, y3, x2, xy, y2, x, y, one] = cubic.coefficients().clone();
        let reflected = burmester::plane::circular_cubic::Cubic::new([
            x3, -x2y, xy2, -y3, x2, -xy, y2, x, -y, one,
        ]);
        assert!(reflected.equals(&other).is_yes());
    }
}

#[test]
fn exchanged_cranks_give_the_same_motion() {
    for (linkage, motion, _) in linkages("exchanged cranks") {
        let reversed = |[a, b]: &[P; 2]| [b.clone(), a.clone()];
        let exchanged = FourBar {
            pins: reversed(&linkage.pins),
            pivots: reversed(&linkage.pivots),
        };
        let other = exchanged.motion().unwrap();
        assert!(other.translation.equals(&motion.translation).is_yes());
        assert!(other.rotation.equals(&motion.rotation).is_yes());
    }
}

/// Circlepoints and centers change places, and with them the two cubics; the rays of the Burmester
/// pairs stay.
#[test]
fn the_inverse_motion_exchanges_the_cubic_and_its_centers() {
    for (linkage, motion, canonical) in linkages("inverse motions") {
        let inverse = linkage.inverse().motion().unwrap();
        let image = Canonical::of(&inverse).unwrap();
        equal(&image.pole, &canonical.pole);
        equal(&image.diameter, &-&canonical.diameter);
        let of_invariants = canonical.invariants.inverse();
        equal(&image.invariants.third, &of_invariants.third);
        equal(&image.invariants.fourth, &of_invariants.fourth);
        let points = stationary_cubic(&motion).unwrap();
        let centers = cubic_of_centers(&motion).unwrap();
        assert!(
            stationary_cubic(&inverse)
                .unwrap()
                .equals(&centers)
                .is_yes()
        );
        assert!(cubic_of_centers(&inverse).unwrap().equals(&points).is_yes());
        for (pin, pivot) in linkage.pins.iter().zip(&linkage.pivots) {
            assert!(points.at(pin).is_zero().is_yes());
            assert!(centers.at(pivot).is_zero().is_yes());
        }
        let rays = canonical.invariants.burmester_rays();
        let others = image.invariants.burmester_rays();
        for (i, ray) in rays.iter().enumerate() {
            for (j, other) in others.iter().enumerate() {
                let minor = ray * other - &rays[j] * &others[i];
                assert!(minor.is_zero().is_yes(), "{i}, {j}");
            }
        }
    }
}

/// Pins are Burmester points, and their pivots the centers of curvature of their paths.
#[test]
fn the_pins_are_burmester_points() {
    for (linkage, motion, canonical) in linkages("pins") {
        for (pin, pivot) in linkage.pins.iter().zip(&linkage.pivots) {
            let center = center_of_curvature(&motion.path_of(pin)).finite();
            equal(&center.unwrap(), pivot);
            let seen = canonical.coordinates(pin);
            let pair = canonical.invariants.pair_on_ray(seen.re(), seen.im());
            equal(&pair.point.finite().unwrap(), &seen);
            equal(
                &pair.center.finite().unwrap(),
                &canonical.coordinates(pivot),
            );
            let (c, s) = (seen.re(), seen.im());
            let form = canonical.invariants.burmester_rays();
            let terms = form.iter().enumerate();
            let terms = terms.map(|(j, a)| a * c.power(4 - j as i32) * s.power(j as i32));
            assert!(terms.sum::<Number<Exact>>().is_zero().is_yes());
        }
    }
}

/// An enclosure proves that a contact ends, never that it goes on.
#[test]
fn contacts_of_enclosures_are_certified() {
    let mut proven = 0;
    for (linkage, ..) in linkages("enclosures") {
        let ball = |z: &P| {
            let part = |x: &Number<Exact>| Number::<Ball>::rounded(x.0.rational().unwrap(), &200);
            Number::complex(part(z.re()), part(z.im()))
        };
        let guide = |i: usize| Guide::Circle {
            point: ball(&linkage.pins[i]),
            center: ball(&linkage.pivots[i]),
        };
        let motion = closure::motion(&[guide(0), guide(1)], 4).unwrap();
        assert_eq!(guide(0).contact(&motion).most, None);
        let beside = ball(&(&linkage.pins[0] + 1));
        let center = center_of_curvature(&motion.path_of(&beside)).finite();
        let Some(center) = center else { continue };
        let order = Guide::Circle {
            point: beside,
            center,
        }
        .contact(&motion);
        assert!(order.most >= Some(2), "{order:?}");
        proven += usize::from(order.most == Some(2));
    }
    assert!(proven > 0);
}

fn slider_crank(k: i64, alpha_a: i64, alpha_d: i64) -> SliderCrank<Surd> {
    let degrees = |d: i64| Angle::from_degrees(&d.into(), &()).unwrap();
    SliderCrank {
        k: k.into(),
        alpha_a: degrees(alpha_a),
        alpha_d: degrees(alpha_d),
    }
}

/// k = −1: A at infinity; k = −3: B on the pole normal; k = −4: C at the inflection pole; N = 0; rays
/// along the pole normal.
#[test]
fn special_values_have_an_answer() {
    let answer = |linkage: &SliderCrank<Surd>| match linkage.alternates() {
        Alternates::Real(pairs) => *pairs,
        other => panic!("{other:?}"),
    };
    let zero = |x: &Number<Surd>| x.is_zero().is_yes();
    let at_infinity = slider_crank(-1, 45, 90);
    assert!(zero(&at_infinity.pa().denominator));
    let [_, c] = answer(&at_infinity);
    assert!((c.point.value() * 2 + 1).is_zero().is_yes(), "k/(2k + 4)");

    let on_normal = answer(&slider_crank(-3, 45, 90));
    assert!(on_normal.iter().all(|pair| zero(&pair.ray.cos())));

    let [_, double] = answer(&slider_crank(-4, 45, 90));
    assert!((double.point.value() - 1).is_zero().is_yes());
    assert!(zero(&double.center.denominator));

    for n_is_zero in [slider_crank(0, 45, 135), slider_crank(2, 45, 45)] {
        assert!(zero(&n_is_zero.n().numerator));
        assert!(!matches!(n_is_zero.alternates(), Alternates::Undecided));
    }
    assert!(matches!(
        slider_crank(-3, 0, 45).alternates(),
        Alternates::Undetermined
    ));
    let both_on_normal = slider_crank(-2, 90, 90);
    assert!(both_on_normal.n().is_undetermined().is_yes());
    assert!(both_on_normal.pa().is_undetermined().is_no());
    for k in [-4, -3, -1, 2] {
        let [pole, _] = answer(&slider_crank(k, 90, 45));
        assert!(zero(&pole.point.value()));
        let expected = Number::<Surd>::from(k * k) / (k - 1);
        assert!(
            (pole.center.value() - expected).is_zero().is_yes(),
            "k = {k}"
        );
    }
}

/// The other Burmester points by the form of the motion that the crank and the slider make.
#[test]
fn alternates_of_a_slider_crank_are_on_rays_of_its_motion() {
    const BITS: u32 = 200;
    let mut found = [0, 0];
    let numbers = [-5, -3, -2, 2, 3, 5];
    let triples = numbers.into_iter().flat_map(|k| {
        let tangents = [[1, 2], [3, 1], [-1, 3], [1, -2], [2, 3], [-3, 2]];
        tangents.map(|[a, d]| [k, a, d])
    });
    for [k, tan_a, tan_d] in triples {
        let number = |n: i64| Number::<Ball>::rounded(&n.into(), &BITS);
        let linkage = SliderCrank {
            k: number(k),
            alpha_a: Angle::from_tan(number(tan_a)),
            alpha_d: Angle::from_tan(number(tan_d)),
        };
        let [ray_a, ray_d] = [&linkage.alpha_a, &linkage.alpha_d].map(Angle::cis);
        let guides = [
            Guide::Circle {
                point: ray_a.scaled(&linkage.pa().value()),
                center: ray_a.scaled(&linkage.po_a()),
            },
            Guide::Line {
                point: ray_d.scaled(&linkage.pd()),
                normal: ray_d,
            },
        ];
        let motion = closure::motion(&guides, 5).unwrap();
        let form = Canonical::of(&motion).unwrap().invariants.burmester_rays();
        let vanishes = |c: Number<Ball>, s: Number<Ball>, i: Number<Ball>| {
            let s = Number::complex(s, i);
            let terms = form
                .iter()
                .enumerate()
                .map(|(j, a)| s.power(j as i32).scaled(&(a * c.power(4 - j as i32))));
            let sum = terms.sum::<Number<Complex<Ball>>>();
            assert!(!sum.is_zero().is_no(), "{k}, {tan_a}, {tan_d}: {sum:?}");
            let known = sum.re().0.accuracy_bits().is_none_or(|bits| bits < 0);
            assert!(known || sum.re().abs().0.upper().unwrap() < Rational::from((1, 1_000_000)));
        };
        match linkage.alternates() {
            Alternates::Real(pairs) => {
                found[0] += 1;
                for pair in *pairs {
                    vanishes(pair.ray.cos(), pair.ray.sin(), number(0));
                }
            }
            Alternates::Complex(tangents) => {
                found[1] += 1;
                for tangent in tangents {
                    vanishes(number(1), tangent.re().clone(), tangent.im().clone());
                }
            }
            other => panic!("{other:?}"),
        }
        let fifth = linkage.infinitely_near();
        let [a, d] = [&linkage.alpha_a, &linkage.alpha_d];
        let k_sin = &linkage.k * (a.sin() * d.cos() - d.sin() * a.cos());
        let [weighted, by_k] = [&fifth.weighted_eta * &linkage.k, &fifth.k_eta * k_sin];
        assert!(
            !(weighted - by_k).is_zero().is_no(),
            "{k}, {tan_a}, {tan_d}"
        );
    }
    assert!(found.iter().all(|&count| count > 0), "{found:?}");
}

/// A and D on one ray: the crank is across the path of the slider, which is a change point.
#[test]
fn pins_on_one_ray_leave_the_motion_open() {
    let at = |x: i64, y: i64| P::complex(x.into(), y.into());
    let guides = [
        Guide::Circle {
            point: at(2, 2),
            center: at(-1, -1),
        },
        Guide::Line {
            point: at(5, 5),
            normal: at(1, 1),
        },
    ];
    assert!(closure::motion(&guides, 4).is_none());
}

/// Watt's mechanism: equal parallel cranks on both sides of the coupler. The inflection circle is a line,
/// and the coupler's middle a Burmester point on it.
#[test]
fn watt_s_mechanism() {
    let at = |x: i64, y: i64| P::complex(x.into(), y.into());
    let guides = [
        Guide::Circle {
            point: at(0, 1),
            center: at(4, 1),
        },
        Guide::Circle {
            point: at(0, -1),
            center: at(-4, -1),
        },
    ];
    let motion = closure::motion(&guides, 5).unwrap();
    assert!(Canonical::of(&motion).is_none());
    let line = inflection_circle(&motion);
    assert!(line.is_line().is_yes());
    assert!(line.contains(&at(0, 0)).is_yes());
    let middle = Guide::Line {
        point: at(0, 0),
        normal: at(1, 0),
    };
    assert!(middle.contact(&motion).least >= 4);
    let pairs = by_contact(&motion).and_then(isolated).unwrap();
    let real = pairs.real(64);
    let sliding = real
        .iter()
        .filter(|pair| pair.place == Place::CenterAtInfinity);
    assert!(sliding.count() >= 1);
}
