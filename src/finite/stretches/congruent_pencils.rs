//! Both curves at once: the pencils of lines about their foci.
//!
//! The line from the focus φ of the centerpoint curve to a center and the line from the focus φ' of
//! the circlepoint curve to its circlepoint make a constant angle: two congruent pencils. Each line
//! of the one meets the curve in two more points, that belong to the two of the corresponding line.
//! So both curves are functions of one parameter t, the slope of these lines, and of one root s:
//!
//! ```text
//! z = φ + r η (1 + i t),   |η|² q L r² + β |η|² q r + N = 0,   q = 1 + t²,
//! ```
//!
//! where L = Re(ᾱη(1 + it)) and N = Re(ν̄η(1 + it)) are linear in t, and the discriminants of the two
//! curves differ by the factor k². For the centers η = α, so that t is infinite in the direction of
//! the asymptote. That the circlepoints belong to the centers is verified as an identity in t and s
//! for the positions at hand.

use std::cmp::Ordering;

use crate::finite::four_positions::viewing_angles;
use crate::finite::positions::Positions;
use crate::number::exact::{primitive, rational_sqrt};
use crate::number::{Exact, Kind, Number, Polynomial, Radical, Real, Truth, array};
use crate::plane::curve_type::{CurveType, curve_type};
use crate::plane::displacement::Displacement;
use crate::plane::focal_cubic::FocalCubic;
use crate::plane::projective::ProjectivePoint;
use crate::plane::{Point, relation};

/// A curve by the lines through its focus.
#[derive(Clone, Debug)]
pub struct Pencil {
    /// φ.
    focus: Point<Exact>,
    /// η.
    base: Point<Exact>,
    /// β.
    beta: Number<Exact>,
    /// L = l₀ + l₁ t.
    l: [Number<Exact>; 2],
    /// N = n₀ + n₁ t.
    n: [Number<Exact>; 2],
    /// What s is multiplied with in the root of this curve.
    k: Number<Exact>,
}

/// A center M in the fixed plane and its circlepoint z in the moving one.
#[derive(Clone, Debug)]
pub struct Dyad<P> {
    /// M.
    pub center: P,
    /// z.
    pub circlepoint: P,
}

/// The line of both pencils with the slope t = y/x, by x and y.
pub type Slope<K> = [Number<K>; 2];

fn scalar(x: &Point<Exact>, y: &Point<Exact>) -> Number<Exact> {
    (x.conj() * y).re().clone()
}

impl Pencil {
    fn new(curve: &FocalCubic<Exact>, base: Point<Exact>) -> Self {
        let turned = Number::i() * &base;
        Pencil {
            l: [scalar(&curve.alpha, &base), scalar(&curve.alpha, &turned)],
            n: [scalar(&curve.nu, &base), scalar(&curve.nu, &turned)],
            focus: curve.focus.clone(),
            beta: curve.beta.clone(),
            base,
            k: Number::one(),
        }
    }

    /// |η|² (β² |η|² q − 4 L N) by falling powers of x: with the factor q the discriminant.
    fn discriminant(&self) -> [Number<Exact>; 3] {
        let ([l0, l1], [n0, n1]) = (&self.l, &self.n);
        let h = self.base.norm();
        let square = self.beta.square() * &h;
        [
            &h * (&square - 4 * l0 * n0),
            -4 * &h * (l0 * n1 + l1 * n0),
            &h * (&square - 4 * l1 * n1),
        ]
    }

    /// r as a fraction: (−β|η|²q + ks)/2|η|²qL, which is also 2N/−(β|η|²q + ks).
    fn roots<K: Kind>(&self, [x, y]: &Slope<K>, s: &Number<K>) -> [[Number<K>; 2]; 2] {
        let at = |[a, b]: &[Number<Exact>; 2]| a.in_kind::<K>() * x + b.in_kind::<K>() * y;
        let h = self.base.norm().in_kind::<K>() * (x.square() + y.square());
        let middle = self.beta.in_kind::<K>() * &h;
        let root = self.k.in_kind::<K>() * s;
        [
            [&root - &middle, 2 * h * at(&self.l)],
            [2 * at(&self.n), -(root + middle)],
        ]
    }

    fn with_root<K: Kind>(&self, [x, y]: &Slope<K>, root: &[Number<K>; 2]) -> ProjectivePoint<K> {
        let [r, w] = root;
        let line = self.base.in_kind::<K>() * Number::complex(x.clone(), y.clone());
        let point = self.focus.in_kind::<K>().scaled(w) + line.scaled(r);
        ProjectivePoint::new(point.re().clone(), point.im().clone(), w.clone())
    }

    /// The point for a line and a root.
    fn point<K: Real>(&self, slope: &Slope<K>, s: &Number<K>) -> ProjectivePoint<K> {
        let [first, second] = self.roots(slope, s);
        let root = self.k.in_kind::<K>() * s;
        // That sum is taken which loses nothing; for s = 0 that which is not zero twice.
        let use_second = match (self.beta.in_kind::<K>().sign(), root.sign()) {
            (Some(Ordering::Equal), Some(Ordering::Equal)) => first[1].is_zero().is_yes(),
            (Some(beta), Some(root)) if beta.is_ne() && root.is_ne() => beta == root,
            _ => false,
        };
        self.with_root(slope, if use_second { &second } else { &first })
    }

    /// The slope of the line towards a point, of the tangent in the focus for that itself.
    fn slope_towards(&self, point: &Point<Exact>) -> Slope<Exact> {
        let direction = self.base.conj() * (point - &self.focus);
        if direction.is_zero().is_yes() {
            // Re(ν̄η(x + iy)) = 0.
            return [self.n[1].clone(), -&self.n[0]];
        }
        [direction.re().clone(), direction.im().clone()]
    }
}

/// The two pencils.
#[derive(Clone, Debug)]
pub struct CongruentPencils {
    /// One branch, two, or one with a node.
    pub curve_type: CurveType,
    centers: Pencil,
    circlepoints: Pencil,
    /// d, by falling powers of x; s² = q d.
    discriminant: [Number<Exact>; 3],
}

impl CongruentPencils {
    /// The pencils of four positions; `None` unless the centerpoint curve has no line or circle as a
    /// part, and where no circlepoint tells the angle between the pencils.
    pub fn of(positions: &Positions<Exact>) -> Option<Self> {
        let cubic = viewing_angles::centerpoint_cubic(positions)?;
        let curve_type = curve_type(&cubic).filter(|curve_type| {
            use CurveType::{Nodal, OneBranch, TwoBranches};
            [OneBranch, TwoBranches, Nodal].contains(curve_type)
        })?;
        let curve = FocalCubic::of(&cubic)?;
        let twin = FocalCubic::of(&viewing_angles::centerpoint_cubic(&positions.inverse())?)?;
        let centers = Pencil::new(&curve, curve.alpha.clone());
        let poles = positions
            .pairs()
            .filter_map(|(i, j)| positions.pole(i, j)?.finite());
        let known: Vec<Point<Exact>> = std::iter::once(curve.focus.clone()).chain(poles).collect();
        let candidates = known.iter().filter_map(|center| {
            let circlepoint = circlepoint_of(positions.first_four()?, center)?;
            let [x, y] = centers.slope_towards(center);
            let along = circlepoint - &twin.focus;
            reduced(&(along * Number::complex(x, -y)))
        });
        candidates
            .flat_map(|base| [1, -1].map(|sign| (base.clone(), sign)))
            .find_map(|(base, sign)| {
                let mut circlepoints = Pencil::new(&twin, base);
                let discriminant = centers.discriminant();
                circlepoints.k = sign * ratio_root(&circlepoints.discriminant(), &discriminant)?;
                let pencils = CongruentPencils {
                    curve_type,
                    centers: centers.clone(),
                    circlepoints,
                    discriminant,
                };
                pencils.is_verified(positions).is_yes().then_some(pencils)
            })
    }

    /// d as a polynomial in t.
    pub fn discriminant(&self) -> Polynomial<Exact> {
        Polynomial::new(self.discriminant.to_vec())
    }

    /// s² = q d as a polynomial in t.
    fn radicand(&self) -> Polynomial<Exact> {
        self.discriminant() * Polynomial::from_integers(&[1, 0, 1])
    }

    /// s² for a line.
    pub fn square<K: Kind>(&self, [x, y]: &Slope<K>) -> Number<K> {
        let [a, b, c] = self
            .discriminant
            .each_ref()
            .map(Number::<Exact>::in_kind::<K>);
        (a * x.square() + b * x * y + c * y.square()) * (x.square() + y.square())
    }

    /// β of the centerpoint curve: the root s of its sign gives the point on that side of the midline
    /// on which the focus lies.
    pub fn beta(&self) -> &Number<Exact> {
        &self.centers.beta
    }

    /// L of the circlepoint curve, as a polynomial in t: for its zero one of the two circlepoints is
    /// at infinity.
    pub fn infinite_circlepoint(&self) -> Polynomial<Exact> {
        Polynomial::new(self.circlepoints.l.to_vec())
    }

    /// The slope of the lines towards a circlepoint, as the polynomial x t − y.
    pub fn slope_of_circlepoint(&self, point: &Point<Exact>) -> Polynomial<Exact> {
        let [x, y] = self.circlepoints.slope_towards(point);
        Polynomial::new(vec![-y, x])
    }

    /// The pair for a line and a root s.
    pub fn pair<K: Real>(&self, slope: &Slope<K>, s: &Number<K>) -> Dyad<ProjectivePoint<K>> {
        Dyad {
            center: self.centers.point(slope, s),
            circlepoint: self.circlepoints.point(slope, s),
        }
    }

    /// The pair as functions of t and s.
    pub fn functions(&self) -> Option<Dyad<Point<Radical>>> {
        let [t, s] = Radical::coordinates(&self.radicand());
        let slope = [Number::one(), t];
        let point = |pencil: &Pencil| {
            let [root, _] = pencil.roots(&slope, &s);
            pencil.with_root(&slope, &root).finite()
        };
        Some(Dyad {
            center: point(&self.centers)?,
            circlepoint: point(&self.circlepoints)?,
        })
    }

    /// Whether the circlepoint is equally far from its center in all positions, for all t and s.
    fn is_verified(&self, positions: &Positions<Exact>) -> Truth {
        let Some(Dyad {
            center,
            circlepoint,
        }) = self.functions()
        else {
            return Truth::No;
        };
        let squares = positions.displacements().iter().map(|position| {
            let position = position.in_kind::<Radical>();
            relation::distance_squared(&position.of(&circlepoint), &center)
        });
        let squares: Vec<Number<Radical>> = squares.collect();
        Truth::all(array::neighbours(&squares).map(|(one, next)| one.equals(next)))
    }
}

/// The circlepoint that has its center in a point of the curve, the center of the circle through the
/// places of that point in the moving plane. `None` where it is at infinity or not determined.
fn circlepoint_of(
    positions: &[Displacement<Exact>; 4],
    center: &Point<Exact>,
) -> Option<Point<Exact>> {
    let [a, b, c, d] = &positions
        .each_ref()
        .map(|position| position.inverse().of(center));
    [[a, b, c], [a, b, d], [a, c, d], [b, c, d]]
        .into_iter()
        .find_map(|[p, q, r]| {
            let (u, v) = (q - p, r - p);
            let area = u.conj() * &v - &u * v.conj();
            area.is_zero()
                .is_no()
                .then(|| p + &u * &v * (&u - &v).conj() / area)
        })
}

/// A direction by primitive integers; `None` for zero.
fn reduced(direction: &Point<Exact>) -> Option<Point<Exact>> {
    let parts = [
        direction.re().0.rational()?.clone(),
        direction.im().0.rational()?.clone(),
    ];
    let integers = primitive(&parts);
    let part = |place: usize| Some(Number::from(rug::Rational::from(integers.get(place)?)));
    let result = Number::complex(part(0)?, part(1)?);
    result.is_zero().is_no().then_some(result)
}

/// k > 0 with a = k² b for two forms; `None` where there is none that is rational.
fn ratio_root(a: &[Number<Exact>; 3], b: &[Number<Exact>; 3]) -> Option<Number<Exact>> {
    let (numerator, denominator) = a.iter().zip(b).find(|(_, b)| b.is_zero().is_no())?;
    let ratio = numerator / denominator;
    let proportional = a.iter().zip(b).map(|(a, b)| a.equals(&(&ratio * b)));
    if !Truth::all(proportional).is_yes() {
        return None;
    }
    Some(
        rational_sqrt(
            ratio
                .0
                .rational()
                .filter(|ratio| ratio.cmp0().is_gt())?
                .clone(),
        )?
        .into(),
    )
}
