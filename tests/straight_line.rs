//! Straight-line designs: the finished linkages, by the series of their own closure.
#![expect(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on has failed"
)]

use burmester::curvature::contact::Contact;
use burmester::curvature::slider_crank::SliderCrank;
use burmester::linkage::cognates::CouplerPoint;
use burmester::number::zeros::zeros;
use burmester::number::{Ball, Exact, Kind, Number, Surd};
use burmester::plane::Angle;
use burmester::straight_line::ball_burmester::{
    Alternate, Cranks, at_inflection_pole, double, equal_cranks, of_rays, of_slider_crank,
};
use burmester::straight_line::conchoid::Conchoid;
use burmester::straight_line::design::Design;
use burmester::straight_line::evans::Evans;
use burmester::straight_line::no_design::NoDesign;
use burmester::straight_line::symmetric::Symmetric;
use burmester::straight_line::watt::Watt;
use proptest::prelude::*;

type N = Number<Surd>;

fn ratio() -> impl Strategy<Value = N> {
    (-40i64..=40, 1i64..=12).prop_map(|(n, d)| N::ratio(n, d))
}

fn ray() -> impl Strategy<Value = Angle<Surd>> {
    (1i64..=40, 1i64..=12).prop_map(|(n, d)| Angle::from_tan_half(&N::ratio(n, d)))
}

fn touches(design: &Design<Surd>, order: usize) -> Contact {
    let contact = design.contact(8).unwrap();
    assert!(contact.least >= order, "{contact:?} {design:?}");
    contact
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn three_rays_give_five_points_on_the_line(a in ray(), b in ray(), d in ray()) {
        let Ok(cranks) = of_rays(&a, &b, &d) else { return Ok(()) };
        for alternate in Alternate::ALL {
            if let Ok(design) = cranks.design(alternate) {
                touches(&design, 4);
                for cognate in design.cognates() {
                    touches(&cognate, 4);
                }
            }
        }
    }
}

#[test]
fn explore() {
    let t = |n, d| Angle::from_tan_half(&N::ratio(n, d));
    let show = |name: &str, design: Result<Design<Surd>, NoDesign>| match design {
        Ok(design) => println!("{name}: {:?}", design.contact(8)),
        Err(reason) => println!("{name}: {reason}"),
    };
    for alternate in Alternate::ALL {
        show(
            "double",
            double(&t(3, 5), &t(7, 2)).and_then(|c| c.design(alternate)),
        );
        show(
            "pole",
            at_inflection_pole(&N::ratio(3, 7), &t(2, 5)).and_then(|c| c.design(alternate)),
        );
        show(
            "equal",
            equal_cranks(&N::ratio(3, 7)).and_then(|c| c.design(alternate)),
        );
        show(
            "equal -4",
            equal_cranks(&N::ratio(-4, 1)).and_then(|c| c.design(alternate)),
        );
        show(
            "equal -2",
            equal_cranks(&N::ratio(-2, 1)).and_then(|c| c.design(alternate)),
        );
        show(
            "equal -3",
            equal_cranks(&N::ratio(-3, 1)).and_then(|c| c.design(alternate)),
        );
        show(
            "equal -1",
            equal_cranks(&N::ratio(-1, 1)).and_then(|c| c.design(alternate)),
        );
    }
    for n in [1, -1] {
        for gamma in [t(0, 1), t(1, 3), t(1, 1)] {
            for k in [0, 1] {
                show(
                    &format!("watt {n} {k} {gamma:?}"),
                    Watt {
                        r: N::from(1),
                        t: N::from(2),
                        gamma: gamma.clone(),
                        n,
                        k: N::from(k),
                    }
                    .design(),
                );
            }
        }
    }
    show(
        "evans",
        Evans {
            alpha: t(1, 2),
            beta: t(1, 7),
            omega: t(1, 5),
            rho: N::ratio(1, 3),
            k: N::from(9),
        }
        .design(),
    );
    show(
        "evans w=b",
        Evans {
            alpha: t(1, 2),
            beta: t(1, 7),
            omega: t(1, 7),
            rho: N::ratio(1, 3),
            k: N::from(9),
        }
        .design(),
    );
    show(
        "evans w=b=0",
        Evans {
            alpha: t(1, 1),
            beta: t(0, 7),
            omega: t(0, 7),
            rho: N::ratio(1, 3),
            k: N::from(9),
        }
        .design(),
    );
    show(
        "evans b=0",
        Evans {
            alpha: t(1, 1),
            beta: t(0, 7),
            omega: t(1, 7),
            rho: N::ratio(1, 3),
            k: N::from(9),
        }
        .design(),
    );
    for n in [1, -1] {
        show(
            "conchoid",
            Conchoid {
                r: N::ratio(1, 3),
                alpha: t(1, 4),
                k: N::from(3),
                n,
            }
            .design(),
        );
        show(
            "conchoid 0",
            Conchoid {
                r: N::ratio(1, 3),
                alpha: t(0, 4),
                k: N::from(3),
                n,
            }
            .design(),
        );
    }
    let sym = |a: i64, c: N, d: N| {
        Symmetric {
            a: N::from(a),
            c,
            d,
        }
        .design()
    };
    show("chebyshev", sym(-2, N::zero(), N::from(4)));
    show("roberts", sym(2, N::from(3), N::from(3)));
}
