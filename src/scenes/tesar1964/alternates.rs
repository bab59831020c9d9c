//! Chapter II: the linkages that take the place of a given one.

use super::ball_burmester::motion_with;
use super::pole_frame::{Pair, fourth_tangent, inflection_point, pair_on_ray, with_burmester_rays};
use crate::curvature::closure;
use crate::curvature::contact::Guide;
use crate::curvature::motion::Motion;
use crate::number::{Exact, Number, Truth, array, count};
use crate::plane::{Angle, Point};
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::Random;
use crate::scenes::{Free, Unbuilt};

pub const SIX: Check = Check {
    name: "six-alternate-linkages",
    summary: "Motions with four rational Burmester pairs. Every two pairs are the cranks of a four-bar; the \
              motions of the six, each expanded from its own closure, agree to terms in θ⁴. The wrong variant \
              asks for agreement in θ⁵, six positions.",
    run: run_six,
};

pub const NINE: Check = Check {
    name: "nine-alternate-linkages",
    summary: "Slider-cranks with rational Burmester points B and C. The crank pin A, B and C give three four-bars, \
              each of which has two cognates by Roberts for the slider's pin D. In all nine, which differ, \
              the path of D, from the series of the closure, has contact of order four with a line. \
              The wrong variant mirrors the triangle of the coupler.",
    run: run_nine,
};

const INSTANCES: u64 = 5;

fn angle(random: &mut Random) -> Result<Point<Exact>, Unbuilt> {
    let angle: Angle<Exact> = random.angle("a ray")?;
    Ok(angle.cis())
}

fn ray_of_tangent(tan: Number<Exact>) -> Point<Exact> {
    Number::complex(Number::one(), tan)
}

fn run_six() -> Result<Report, Unbuilt> {
    let (mut five, mut six) = (Truth::Yes, Truth::No);
    for seed in 0..INSTANCES {
        let motions = six_motions(&mut Random::new(seed))?;
        five = five & agree(&motions, 4);
        six = six | agree(&motions, 5);
    }
    Ok(Report {
        holds: five,
        wrong_variant: six,
        basis: Basis::Instances,
        instances: count::from_u64(INSTANCES),
        exception: None,
    })
}

fn six_motions(random: &mut Random) -> Result<[Motion<Exact>; 6], Unbuilt> {
    let rays = [angle(random)?, angle(random)?, angle(random)?];
    let [a, b, c] = rays.each_ref();
    let ratio: Number<Exact> = random.number("a_3/b_3")?;
    let invariants = with_burmester_rays([a, b, c], &Number::complex(ratio, Number::one()), false);
    let fourth = ray_of_tangent(fourth_tangent(&invariants, [a, b, c]));
    let guides = [a, b, c, &fourth].map(|ray| pair_on_ray(&invariants, ray).guide());
    let mut motions = Vec::new();
    for (place, one) in guides.iter().enumerate() {
        for other in guides.iter().skip(place + 1) {
            motions.extend(closure::motion(&[one.clone(), other.clone()], 5));
        }
    }
    motions
        .try_into()
        .map_err(|_| Unbuilt::NotReal("a linkage is in a change point".to_owned()))
}

/// Whether all motions are the same to terms in θⁿ.
fn agree(motions: &[Motion<Exact>], order: usize) -> Truth {
    let equal = |pair: &[Motion<Exact>]| {
        let [one, other] = pair else {
            return Truth::Unknown;
        };
        let difference = &one.translation - &other.translation;
        let terms = (1..=order).map(|j| {
            difference.re().coefficient(j).is_zero() & difference.im().coefficient(j).is_zero()
        });
        Truth::all(terms)
    };
    Truth::all(motions.windows(2).map(equal))
}

/// Two cranks and a point of the coupler.
#[derive(Clone)]
struct FourBar {
    pivots: [Point<Exact>; 2],
    pins: [Point<Exact>; 2],
    point: Point<Exact>,
}

fn run_nine() -> Result<Report, Unbuilt> {
    let (mut holds, mut wrong) = (Truth::Yes, Truth::No);
    for seed in 0..INSTANCES {
        let (linkages, normal) = three_linkages(&mut Random::new(seed))?;
        let all = |ratio: fn(&FourBar) -> Point<Exact>| -> Vec<FourBar> {
            let with_cognates = |linkage: &FourBar| {
                let cognates = [linkage.cognate(&ratio(linkage)), {
                    let turned = linkage.turned();
                    turned.cognate(&ratio(&turned))
                }];
                [vec![linkage.clone()], cognates.to_vec()].concat()
            };
            linkages.iter().flat_map(with_cognates).collect()
        };
        let straight = |linkages: &[FourBar]| {
            Truth::all(linkages.iter().map(|linkage| linkage.draws_line(&normal)))
        };
        let nine = all(FourBar::shape);
        let mirrored = all(|linkage| linkage.shape().conj());
        holds = holds & straight(&nine) & all_differ(&nine) & Truth::from(nine.len() == 9);
        wrong = wrong | straight(&mirrored);
    }
    Ok(Report {
        holds,
        wrong_variant: wrong,
        basis: Basis::Instances,
        instances: count::from_u64(INSTANCES),
        exception: None,
    })
}

/// The three four-bars of a slider-crank, and the direction across the path of its slider's pin.
fn three_linkages(random: &mut Random) -> Result<([FourBar; 3], Point<Exact>), Unbuilt> {
    let rays = [angle(random)?, angle(random)?, angle(random)?];
    let [a, b, d] = rays.each_ref();
    let invariants = motion_with(a, b, d);
    let c = ray_of_tangent(fourth_tangent(&invariants, [a, b, d]));
    let [a, b, c] = [a, b, &c].map(|ray| pair_on_ray(&invariants, ray));
    let point = inflection_point(d).point;
    let linkage = |first: &Pair<Exact>, second: &Pair<Exact>| -> Result<FourBar, Unbuilt> {
        let center = |pair: &Pair<Exact>| {
            let infinite = || Unbuilt::NotReal("a center is at infinity".to_owned());
            pair.center.clone().ok_or_else(infinite)
        };
        Ok(FourBar {
            pivots: [center(first)?, center(second)?],
            pins: [first.point.clone(), second.point.clone()],
            point: point.clone(),
        })
    };
    Ok((
        [linkage(&a, &b)?, linkage(&b, &c)?, linkage(&c, &a)?],
        d.clone(),
    ))
}

impl FourBar {
    /// The coupler's triangle: the point as a multiple of the way from the first pin to the second.
    fn shape(&self) -> Point<Exact> {
        let [a, b] = &self.pins;
        (&self.point - a) / (b - a)
    }

    /// The same linkage read from its other crank.
    fn turned(&self) -> FourBar {
        let reversed = |[a, b]: &[Point<Exact>; 2]| [b.clone(), a.clone()];
        FourBar {
            pivots: reversed(&self.pivots),
            pins: reversed(&self.pins),
            point: self.point.clone(),
        }
    }

    /// The cognate at the first pivot: a parallelogram with the crank and the point, a coupler similar to the
    /// given one, and the third pivot, which makes such a triangle with the two others.
    fn cognate(&self, shape: &Point<Exact>) -> FourBar {
        let ([pivot, other], [pin, _]) = (&self.pivots, &self.pins);
        let first = pivot + &self.point - pin;
        let second = &first + shape * (&self.point - &first);
        FourBar {
            pivots: [pivot.clone(), pivot + shape * (other - pivot)],
            pins: [first, second],
            point: self.point.clone(),
        }
    }

    /// Whether five infinitesimally separated positions of the point are on a line.
    fn draws_line(&self, normal: &Point<Exact>) -> Truth {
        let [first, second] =
            array::pairs(&self.pins, &self.pivots).map(|(pin, pivot)| Guide::Circle {
                point: pin.clone(),
                center: pivot.clone(),
            });
        let Some(motion) = closure::motion(&[first, second], 4) else {
            return Truth::Unknown;
        };
        let line = Guide::Line {
            point: self.point.clone(),
            normal: normal.clone(),
        };
        let kept = line.along(&motion);
        Truth::all((1..=4).map(|j| kept.coefficient(j).is_zero()))
    }

    fn equals(&self, other: &FourBar) -> Truth {
        let pivots = array::pairs(&self.pivots, &other.pivots);
        let pins = array::pairs(&self.pins, &other.pins);
        let both = pivots.into_iter().chain(pins);
        Truth::all(both.map(|(one, other)| one.equals(other)))
    }
}

fn all_differ(linkages: &[FourBar]) -> Truth {
    let differ = |(place, one): (usize, &FourBar)| {
        let later = linkages.iter().skip(place + 1);
        Truth::all(later.map(|other| !one.equals(other) & !one.equals(&other.turned())))
    };
    Truth::all(linkages.iter().enumerate().map(differ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_hold_and_the_wrong_variants_are_rejected() {
        for run in [run_six, run_nine] {
            let report = run().unwrap();
            assert_eq!(
                (report.holds, report.wrong_variant),
                (Truth::Yes, Truth::No)
            );
        }
    }
}
