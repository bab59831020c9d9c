//! Chapter II: motions seen from the pole, and the constants of their curves.

use crate::curvature::canonical::{Invariants, moving_polode};
use crate::curvature::contact::Guide;
use crate::curvature::motion::Motion;
use crate::curvature::osculation::{center_of_curvature, stationary_cubic};
use crate::formula::Bindings;
use crate::number::linear::determinant;
use crate::number::{Kind, Number, Real, Truth};
use crate::plane::{Angle, Point};
use crate::scenes::{Free, Unbuilt};

/// A point on a ray through the pole, and the center of its path.
#[derive(Clone)]
pub(super) struct Pair<K> {
    /// A direction of the ray, of any length.
    pub ray: Point<K>,
    pub point: Point<K>,
    /// `None` where it is at infinity.
    pub center: Option<Point<K>>,
}

impl<K: Kind> Pair<K> {
    /// What the joint in the point keeps.
    pub fn guide(&self) -> Guide<K> {
        let (point, normal) = (self.point.clone(), self.ray.clone());
        match self.center.clone() {
            Some(center) => Guide::Circle { point, center },
            None => Guide::Line { point, normal },
        }
    }

    /// How the θ⁴ of the joint would change with a₄: that of Re(ē a₄)/24, with e the ray, counts 1.
    fn excess(&self, motion: &Motion<K>) -> Number<K> {
        let term = self.guide().along(motion).coefficient(4);
        match &self.center {
            Some(center) => {
                let link = along(&self.ray, &(&self.point - center)) / self.ray.norm();
                term / (2 * link)
            }
            None => term,
        }
    }
}

impl<K: Real> Pair<K> {
    /// From the pole to the point, along the ray of this angle.
    pub fn to_point(&self, angle: &Angle<K>) -> Number<K> {
        along(&angle.cis(), &self.point)
    }

    /// From the pole to the center; no value where that is at infinity.
    pub fn to_center(&self, angle: &Angle<K>) -> Number<K> {
        match &self.center {
            Some(center) => along(&angle.cis(), center),
            None => Number::one() / Number::zero(),
        }
    }
}

/// The scalar product of two directions.
pub(super) fn along<K: Kind>(ray: &Point<K>, point: &Point<K>) -> Number<K> {
    (ray.conj() * point).re().clone()
}

/// M and N, the diameters of the circles that osculate the cubic of stationary curvature in the pole,
/// and the radius of curvature R of the moving polode. The pole is the origin, its tangent the x-axis.
pub(super) struct Constants<K> {
    pub m: Number<K>,
    pub n: Number<K>,
    pub r: Number<K>,
}

impl<K: Kind> Constants<K> {
    /// The cubic is (x² + y²)(x/M + y/N) = xy up to a factor.
    pub fn of(motion: &Motion<K>) -> Result<Self, Unbuilt> {
        let cubic = stationary_cubic(motion)
            .ok_or_else(|| Unbuilt::NotHeld("the cubic of stationary curvature".to_owned()))?;
        let [x3, _, _, y3, _, xy, ..] = cubic.coefficients();
        let center = center_of_curvature(&moving_polode(motion));
        let [_, y, w] = center.coordinates();
        Ok(Constants {
            m: -xy / x3,
            n: -xy / y3,
            r: y / w,
        })
    }

    pub fn bind(self, bindings: &mut Bindings<K>)
    where
        K: Real,
    {
        bindings.bind("M", self.m);
        bindings.bind("N", self.n);
        bindings.bind("R", self.r);
    }
}

/// The invariants of a motion with two Burmester points on given rays and a third one, which may be
/// the one on the inflection circle.
///
/// a₃ + ib₃ is β times a given complex number. For each β the three rays hold a point with four
/// positions on a circle each; the fifth asks for a₄ and b₄ in three linear equations, which agree for
/// one β ≠ 0: their determinant, divided by β, is linear in β.
pub(super) fn with_burmester_rays<K: Kind>(
    rays: [&Point<K>; 3],
    third: &Point<K>,
    third_on_inflection_circle: bool,
) -> Invariants<K> {
    let pairs = |invariants: &Invariants<K>| {
        let last = if third_on_inflection_circle {
            inflection_point(rays[2])
        } else {
            pair_on_ray(invariants, rays[2])
        };
        [
            pair_on_ray(invariants, rays[0]),
            pair_on_ray(invariants, rays[1]),
            last,
        ]
    };
    let excesses = |beta: &Number<K>| {
        let invariants = Invariants {
            third: third.scaled(beta),
            fourth: Number::zero(),
        };
        let motion = invariants.motion();
        pairs(&invariants).map(|pair| pair.excess(&motion))
    };
    let row =
        |ray: &Point<K>, excess: &Number<K>| [excess.clone(), ray.re().clone(), ray.im().clone()];
    let disagreement = |beta: i64| {
        let [u, v, w] = excesses(&beta.into());
        determinant(&[row(rays[0], &u), row(rays[1], &v), row(rays[2], &w)]) / beta
    };
    let (one, two) = (disagreement(1), disagreement(2));
    let beta = (2 * &one - &two) / (one - two);
    let [u, v, _] = excesses(&beta);
    let [a, b] = [rays[0], rays[1]];
    let across = a.re() * b.im() - a.im() * b.re();
    let fourth = Number::complex(
        24 * (&v * a.im() - &u * b.im()) / &across,
        24 * (&u * b.re() - &v * a.re()) / across,
    );
    Invariants {
        third: third.scaled(&beta),
        fourth,
    }
}

/// The point of a ray with four positions on a circle.
pub(super) fn pair_on_ray<K: Kind>(invariants: &Invariants<K>, ray: &Point<K>) -> Pair<K> {
    let pair = invariants.pair_on_ray(ray.re(), ray.im());
    let [[x, y, w], [cx, cy, cw]] =
        [pair.point, pair.center].map(|point| point.coordinates().clone());
    Pair {
        ray: ray.clone(),
        point: Number::complex(x / &w, y / w),
        center: Some(Number::complex(cx / &cw, cy / cw)),
    }
}

/// The point of a ray of any length on the inflection circle of diameter 1.
pub(super) fn inflection_point<K: Kind>(ray: &Point<K>) -> Pair<K> {
    Pair {
        ray: ray.clone(),
        point: ray.scaled(&(ray.im() / ray.norm())),
        center: None,
    }
}

/// The tangent of the fourth ray, from those of three: the sum of all four is that of the roots. The
/// pole normal is none of them.
pub(super) fn fourth_tangent<K: Kind>(
    invariants: &Invariants<K>,
    rays: [&Point<K>; 3],
) -> Number<K> {
    let [_, _, _, third, fourth] = invariants.burmester_rays();
    let known: Number<K> = rays.into_iter().map(|ray| ray.im() / ray.re()).sum();
    -third / fourth - known
}

/// The ray of a tangent, with the root that makes its direction a unit vector.
pub(super) fn angle_of_tangent<K: Real>(
    free: &mut dyn Free<K>,
    name: &str,
    tan: &Number<K>,
) -> Result<Angle<K>, Unbuilt> {
    let length = free.root(name, &(1 + tan.square()))?;
    let direction = Number::complex(Number::one(), tan.clone());
    Ok(Angle::of_known_length(direction, length))
}

/// A property that follows from the construction. With free symbols it is left to the formulas: it would
/// take longer than their proofs.
pub(super) fn unless_true<K: Kind>(
    property: impl FnOnce() -> Truth,
    what: &str,
) -> Result<(), Unbuilt> {
    if K::GENERIC {
        return Ok(());
    }
    Unbuilt::unless_true::<K>(property(), what)
}

/// That points have contact of order four with their circles.
pub(super) fn unless_contact<'a, K: Kind + 'a>(
    motion: &Motion<K>,
    pairs: impl IntoIterator<Item = &'a Pair<K>>,
) -> Result<(), Unbuilt> {
    let zero = |pair: &Pair<K>| {
        let kept = pair.guide().along(motion);
        Truth::all((1..=4).map(|j| kept.coefficient(j).is_zero()))
    };
    unless_true::<K>(
        || Truth::all(pairs.into_iter().map(zero)),
        "five positions of a Burmester point lie on a circle",
    )
}
