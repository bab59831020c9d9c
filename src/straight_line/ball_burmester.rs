//! Five infinitely near positions of D on the line: D is Ball's point and a Burmester point.
//!
//! Then the three other Burmester points A, B, C, each with its center, serve as cranks, two at a
//! time. The pole is the origin, the pole tangent the x-axis, the diameter of the inflection circle 1.

use super::design::Design;
use super::no_design::NoDesign;
use crate::curvature::slider_crank::{Alternates, Fifth, Pair, Quotient, SliderCrank};
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Kind, Number, Real};
use crate::plane::{Angle, Point};

/// Which two of the three points A, B, C are the pins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alternate {
    /// A and B.
    First,
    /// B and C.
    Second,
    /// C and A.
    Third,
}

impl Alternate {
    /// All three.
    pub const ALL: [Alternate; 3] = [Alternate::First, Alternate::Second, Alternate::Third];

    /// The pins by their numbers.
    pub fn name(self) -> &'static str {
        match self {
            Alternate::First => "1,2",
            Alternate::Second => "2,3",
            Alternate::Third => "3,1",
        }
    }

    fn places(self) -> [usize; 2] {
        match self {
            Alternate::First => [0, 1],
            Alternate::Second => [1, 2],
            Alternate::Third => [2, 0],
        }
    }
}

/// The slider's pin D and the three points that can be pins of cranks instead.
#[derive(Clone, Debug)]
pub struct Cranks<K> {
    /// The ray of D.
    pub alpha_d: Angle<K>,
    /// A, B, C with their centers.
    pub pairs: [Pair<K>; 3],
}

/// A, B and C of a slider-crank with any fifth position.
pub fn of_slider_crank<K: Real>(
    linkage: &SliderCrank<K>,
    fifth: &Fifth<K>,
) -> Result<Cranks<K>, NoDesign> {
    match linkage.alternates_in(fifth) {
        Alternates::Real(pairs) => {
            let [b, c] = *pairs;
            Ok(Cranks::of(linkage, b, c))
        }
        Alternates::Complex(_) => Err(NoDesign::Complex),
        Alternates::Undetermined => Err(NoDesign::NoLength("A")),
        Alternates::Undecided => Err(NoDesign::Undecided),
    }
}

/// The linkage of three rays. The condition on the rays of the Burmester points (see
/// [`slider_crank`](crate::curvature::slider_crank)) is linear in k; C follows from the product of
/// the tangents.
pub fn of_rays<K: Real>(
    alpha_a: &Angle<K>,
    alpha_b: &Angle<K>,
    alpha_d: &Angle<K>,
) -> Result<Cranks<K>, NoDesign> {
    let (ca, sa) = (alpha_a.cos(), alpha_a.sin());
    let (cb, sb) = (alpha_b.cos(), alpha_b.sin());
    let (cd, sd) = (alpha_d.cos(), alpha_d.sin());
    if sa.is_zero().is_yes() {
        return Err(NoDesign::NoLength("A"));
    }
    let apart = &sa * &cd - &sd * &ca;
    if apart.is_zero().is_yes() {
        return Err(NoDesign::Rays("A and D are on one ray"));
    }
    let weighted = &sa * &ca * &cd * sb.square()
        + &sa * (&sa * &cd + 3 * &sd * &ca) * &sb * &cb
        + ca.square() * &sd * cb.square();
    let weight = &cb * (&sa * &sb + &ca * &cb);
    if weight.is_zero().is_yes() {
        return Err(if weighted.is_zero().is_yes() {
            NoDesign::Rays("these rays leave k open: any will do")
        } else {
            NoDesign::PivotAtInfinity("A")
        });
    }
    let k = weighted / weight / apart;
    with_k(k, alpha_a, alpha_b, alpha_d)
}

/// The linkage of three rays, of which k is known.
fn with_k<K: Real>(
    k: Number<K>,
    alpha_a: &Angle<K>,
    alpha_b: &Angle<K>,
    alpha_d: &Angle<K>,
) -> Result<Cranks<K>, NoDesign> {
    let linkage = SliderCrank {
        k,
        alpha_a: alpha_a.clone(),
        alpha_d: alpha_d.clone(),
    };
    if alpha_d.cos().is_zero().is_yes() {
        let cranks = of_slider_crank(&linkage, &linkage.infinitely_near())?;
        return Ok(cranks.with_second_off_the_normal());
    }
    let [b, c] = linkage.pair_and_other(alpha_b);
    Ok(Cranks::of(&linkage, b, c))
}

/// The linkage of two rays of which D is a double Burmester point, α_c = α_d:
/// tan α_d = −(tan α_a + tan α_b)/(3 + tan α_a tan α_b). The product of the tangents of B and C = D
/// gives k = sin α_d cos(α_a + α_b)/(cos α_b sin(α_a − α_d)), also where three rays leave it open.
pub fn double<K: Real>(alpha_a: &Angle<K>, alpha_b: &Angle<K>) -> Result<Cranks<K>, NoDesign> {
    let (ca, sa) = (alpha_a.cos(), alpha_a.sin());
    let (cb, sb) = (alpha_b.cos(), alpha_b.sin());
    let direction = Number::complex(3 * &ca * &cb + &sa * &sb, -(&sa * &cb + &sb * &ca));
    if direction.is_zero().is_yes() {
        return Err(NoDesign::Rays("every ray of D would do"));
    }
    let upwards = if direction.im().is_positive().is_yes() {
        direction
    } else {
        -direction
    };
    if sa.is_zero().is_yes() {
        return Err(NoDesign::NoLength("A"));
    }
    // Before any root: no kind holds all of them.
    let off = |c: &Number<K>, s: &Number<K>| s * upwards.re() - c * upwards.im();
    if off(&ca, &sa).is_zero().is_yes() {
        return Err(NoDesign::Rays("A and D are on one ray"));
    }
    if off(&cb, &sb).is_zero().is_yes() {
        return Err(NoDesign::Rays("B and D are on one ray"));
    }
    if cb.is_zero().is_yes() {
        return Err(NoDesign::PivotAtInfinity("A"));
    }
    let length = upwards.norm().sqrt();
    let (cd, sd) = (upwards.re() / &length, upwards.im() / length);
    let apart = &sa * &cd - &sd * &ca;
    let k = &sd * (&ca * &cb - &sa * &sb) / (&cb * apart);
    let alpha_d = Angle::from_cos_sin(cd, sd);
    with_k(k, alpha_a, alpha_b, &alpha_d)
}

/// D at the inflection pole, with cranks of equal length: tan² α_a = (k + 1)/(k + 3), α_b = −α_a.
pub fn equal_cranks<K: Real>(k: &Number<K>) -> Result<Cranks<K>, NoDesign> {
    let whole = 2 * (k + 2);
    let squares = [(k + 3) / &whole, (k + 1) / whole];
    let real = squares
        .iter()
        .all(|square| !square.sign().is_some_and(std::cmp::Ordering::is_lt));
    if !real {
        return Err(NoDesign::NotReal("tan² alpha_a = (k + 1)/(k + 3)"));
    }
    let [cos, sin] = squares.map(Number::sqrt);
    at_inflection_pole(k, &Angle::from_cos_sin(cos, sin))
}

/// D at the inflection pole; C is on the pole normal.
pub fn at_inflection_pole<K: Real>(
    k: &Number<K>,
    alpha_a: &Angle<K>,
) -> Result<Cranks<K>, NoDesign> {
    let linkage = SliderCrank {
        k: k.clone(),
        alpha_a: alpha_a.clone(),
        alpha_d: Angle::from_cos_sin(Number::zero(), Number::one()),
    };
    let cranks = of_slider_crank(&linkage, &linkage.infinitely_near())?;
    Ok(cranks.with_second_off_the_normal())
}

impl<K: Real> Cranks<K> {
    fn of(linkage: &SliderCrank<K>, b: Pair<K>, c: Pair<K>) -> Self {
        let a = Pair {
            ray: linkage.alpha_a.clone(),
            point: linkage.pa(),
            center: Quotient::new(linkage.po_a(), Number::one()),
        };
        Cranks {
            alpha_d: linkage.alpha_d.clone(),
            pairs: [a, b, c],
        }
    }

    fn with_second_off_the_normal(self) -> Self {
        let [a, b, c] = self.pairs;
        let swapped = b.ray.cos().is_zero().is_yes();
        Cranks {
            alpha_d: self.alpha_d,
            pairs: if swapped { [a, c, b] } else { [a, b, c] },
        }
    }

    /// The four-bar with two of them.
    #[expect(
        clippy::indexing_slicing,
        reason = "an alternate has two of the three places"
    )]
    pub fn design(&self, alternate: Alternate) -> Result<Design<K>, NoDesign> {
        if self.alpha_d.sin().is_zero().is_yes() {
            return Err(NoDesign::OutputAtPole);
        }
        const NAMES: [&str; 3] = ["A", "B", "C"];
        let [first, second] = alternate.places().map(|place| {
            let (pair, name) = (&self.pairs[place], NAMES[place]);
            Ok([
                on_ray(&pair.ray, &pair.center).ok_or(NoDesign::PivotAtInfinity(name))?,
                on_ray(&pair.ray, &pair.point).ok_or(NoDesign::PinAtInfinity(name))?,
            ])
        });
        let ([o_a, a], [o_b, b]) = (first?, second?);
        let ray = self.alpha_d.cis();
        Design {
            linkage: CouplerPoint {
                pivots: [o_a, o_b],
                pins: [a, b],
                point: ray.scaled(&self.alpha_d.sin()),
            },
            direction: Number::i() * ray,
        }
        .checked()
    }
}

/// The point so far along a ray; `None` where it is at infinity.
fn on_ray<K: Kind + Real>(ray: &Angle<K>, distance: &Quotient<K>) -> Option<Point<K>> {
    let finite = !distance.denominator.is_zero().is_yes();
    finite.then(|| ray.cis().scaled(&distance.value()))
}
