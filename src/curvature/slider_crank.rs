//! The Burmester points of a slider-crank in one position.
//!
//! # From the motion to the points
//!
//! Let the coupler turn by θ: a point z of it goes to a(θ) + e^{iθ} z. With the pole in the origin,
//! the pole tangent as x-axis and the diameter of the inflection circle as unit,
//! a = iθ²/2 + (a₃ + i b₃)θ³/6 + (a₄ + i b₄)θ⁴/24 + …. A point z = r e^{iα} has its center of
//! curvature Z = R e^{iα} on the same ray. That |a + e^{iθ}z − Z|² has no term in θ², θ³, θ⁴ says,
//! with ρ = 1/r, σ = 1/R, c = cos α, s = sin α and L = a₃c + b₃s,
//!
//! - θ²: ρ − σ = 1/s (Euler and Savary);
//! - θ³: 3 s c σ = L (the cubic of stationary curvature and its centers);
//! - θ⁴: L(L + 3c)(c² + s²) − 3sc²(a₄c + b₄s) + 4scL(b₃c − a₃s) − 6s²cL − 3s²c² = 0.
//!
//! In t = tan α the last has the leading coefficient b₃², the next −b₃(2a₃ + 3) and the absolute
//! term a₃(a₃ + 3): a₄ and b₄ do not enter. So two known Burmester points give the sum and the product of the
//! tangents of the other two.
//!
//! # The slider-crank
//!
//! The crank pin A has σ_a = 1/(k sin α_a), the slider's pin D has σ_d = 0. Hence a₃ = −3 tan α_d / N
//! and b₃ = 3/N with N = k (tan α_a − tan α_d), and B, C have t² + (tan α_a + 3 tan α_d − N) t +
//! (tan α_d − N)/tan α_a = 0. Everything below is homogeneous in cosines and sines, so that no
//! tangent has to be finite.
//!
//! # A fifth position that is apart
//!
//! Let four positions be infinitely near each other, and let the fifth be a turn by θ about the pole
//! p. That the distance of z from Z is the same in it says, after division by |z||Z|(1 − cos θ) and
//! with the reciprocals ρ = σ + 1/s on the cubic, for a quartic in (c, s) of which the rays of A and D
//! are two roots, that the rays of the other two have
//!
//!   cos α_a cos α_d t² + κ(1 + k − 2kη) t + cos α_a (cos α_a sin α_d − kκ)/sin α_a = 0
//!
//! with κ = sin(α_a − α_d) and η = p_y/|p|². Nothing else of the fifth position enters: the same
//! points belong to all whose poles lie on one circle, that of diameter 1/η which touches the pole
//! tangent in the pole. The infinitely near fifth position has η = 1 − 2 tan α_d / N.

use std::cmp::Ordering;

use crate::number::{Complex, Kind, Number, Real, Truth};
use crate::plane::Angle;
use crate::plane::displacement::Displacement;

/// A number that may be infinite; not determined where both parts are zero.
#[derive(Clone, Debug)]
pub struct Quotient<K> {
    /// What is divided.
    pub numerator: Number<K>,
    /// By what; zero where the quotient is infinite.
    pub denominator: Number<K>,
}

impl<K: Kind> Quotient<K> {
    /// A quotient of two numbers.
    pub fn new(numerator: Number<K>, denominator: Number<K>) -> Self {
        Quotient {
            numerator,
            denominator,
        }
    }

    fn zero() -> Self {
        Quotient::new(Number::zero(), Number::one())
    }

    /// Whether it is 0/0.
    pub fn is_undetermined(&self) -> Truth {
        self.numerator.is_zero() & self.denominator.is_zero()
    }

    /// The number itself; no value where it is infinite.
    pub fn value(&self) -> Number<K> {
        &self.numerator / &self.denominator
    }
}

/// A Burmester point and its center on one ray through the pole.
#[derive(Clone, Debug)]
pub struct Pair<K> {
    /// The ray, as the angle from the pole tangent, modulo π.
    pub ray: Angle<K>,
    /// From the pole to the point, along the ray.
    pub point: Quotient<K>,
    /// From the pole to the center, along the ray.
    pub center: Quotient<K>,
}

/// The two unknown Burmester points.
#[derive(Clone, Debug)]
pub enum Alternates<K> {
    /// Real, the one with the smaller tangent first.
    Real(Box<[Pair<K>; 2]>),
    /// Conjugate complex: the tangents of their rays.
    Complex([Number<Complex<K>>; 2]),
    /// α_a = 0: pin and pivot of the crank are both in the pole, and it guides nothing.
    Undetermined,
    /// Whether they are real cannot be told in this arithmetic.
    Undecided,
}

/// The fifth position beside four that are infinitely near each other, as far as the other two
/// Burmester points depend on it.
#[derive(Clone, Debug)]
pub struct Fifth<K> {
    /// k sin(α_a − α_d) η, where the pole of the fifth position lies on a circle of diameter 1/η that
    /// touches the pole tangent in the pole.
    pub weighted_eta: Number<K>,
    /// k η.
    pub k_eta: Number<K>,
    /// Where on the pole tangent the center is that belongs to the pole, if it belongs to a pair.
    pub center_of_pole: Quotient<K>,
}

/// A slider-crank in one position, by the rays of its pins and by k = PO_a / sin α_a; the diameter
/// of the inflection circle is 1 (Tesar 1964, chapter II).
#[derive(Clone, Debug)]
pub struct SliderCrank<K> {
    /// Distance of the crank's pivot from the pole, divided by sin α_a.
    pub k: Number<K>,
    /// The ray of the crank pin A.
    pub alpha_a: Angle<K>,
    /// The ray of the slider's pin D.
    pub alpha_d: Angle<K>,
}

/// Cosines and sines of the two rays, and k sin(α_a − α_d).
struct Symbols<K> {
    ca: Number<K>,
    sa: Number<K>,
    cd: Number<K>,
    sd: Number<K>,
    k_sin: Number<K>,
}

impl<K: Real> SliderCrank<K> {
    fn symbols(&self) -> Symbols<K> {
        let (ca, sa) = (self.alpha_a.cos(), self.alpha_a.sin());
        let (cd, sd) = (self.alpha_d.cos(), self.alpha_d.sin());
        let k_sin = &self.k * (&sa * &cd - &sd * &ca);
        Symbols {
            ca,
            sa,
            cd,
            sd,
            k_sin,
        }
    }

    /// PD = sin α_d, since D lies on the inflection circle.
    pub fn pd(&self) -> Number<K> {
        self.alpha_d.sin()
    }

    /// PO_a = k sin α_a.
    pub fn po_a(&self) -> Number<K> {
        &self.k * self.alpha_a.sin()
    }

    /// PA, from 1/PA − 1/PO_a = 1/sin α_a; infinite for k = −1.
    pub fn pa(&self) -> Quotient<K> {
        Quotient::new(self.po_a(), &self.k + 1)
    }

    /// N = 3/b₃ = k (tan α_a − tan α_d).
    pub fn n(&self) -> Quotient<K> {
        let Symbols { ca, cd, k_sin, .. } = self.symbols();
        Quotient::new(k_sin, ca * cd)
    }

    /// M = 3/(a₃ + 3) = N/(N − tan α_d).
    pub fn m(&self) -> Quotient<K> {
        let Symbols {
            ca, cd, sd, k_sin, ..
        } = self.symbols();
        if cd.is_zero().is_yes() && ca.is_zero().is_no() {
            return Quotient::new(self.k.clone(), &self.k + 1);
        }
        let denominator = &k_sin - sd * ca;
        Quotient::new(k_sin, denominator)
    }

    /// Radius of curvature of the moving polode, R = M/(3 − M) = 1/(a₃ + 2).
    pub fn r(&self) -> Quotient<K> {
        let Symbols {
            ca, cd, sd, k_sin, ..
        } = self.symbols();
        if cd.is_zero().is_yes() && ca.is_zero().is_no() {
            return Quotient::new(self.k.clone(), 2 * &self.k + 3);
        }
        let denominator = 2 * &k_sin - 3 * sd * ca;
        Quotient::new(k_sin, denominator)
    }

    /// The infinitely near fifth position.
    pub fn infinitely_near(&self) -> Fifth<K> {
        let Symbols {
            ca,
            sa,
            cd,
            sd,
            k_sin,
        } = self.symbols();
        let k = &self.k;
        let weighted_eta = k_sin - 2 * &sd * &ca;
        let k_eta = if cd.is_zero().is_yes() {
            k + 2
        } else if ca.is_zero().is_yes() {
            k.clone()
        } else {
            &weighted_eta / (sa * &cd - &sd * ca)
        };
        Fifth {
            weighted_eta,
            k_eta,
            center_of_pole: Quotient::new(k.square() * cd, (k - 1) * sd),
        }
    }

    /// The fifth position that a displacement e^{iθ} z + f of the coupler gives, f ≠ 0: the pole is
    /// p = f/(1 − e^{iθ}), and η = −Im(1/p).
    pub fn apart(&self, displacement: &Displacement<K>) -> Fifth<K> {
        let shift = &displacement.translation;
        let eta = eta(displacement);
        Fifth {
            weighted_eta: self.symbols().k_sin * &eta,
            k_eta: &self.k * eta,
            // |f − Z|² = |Z|² on the pole tangent.
            center_of_pole: Quotient::new(shift.norm(), 2 * shift.re()),
        }
    }

    /// The two Burmester points that the linkage itself does not show.
    pub fn alternates(&self) -> Alternates<K> {
        self.alternates_in(&self.infinitely_near())
    }

    /// The same with any fifth position.
    pub fn alternates_in(&self, fifth: &Fifth<K>) -> Alternates<K> {
        let symbols = self.symbols();
        if symbols.sa.is_zero().is_yes() {
            return Alternates::Undetermined;
        }
        if symbols.cd.is_zero().is_yes() {
            return self.with_slider_pin_at_inflection_pole(&symbols, fifth);
        }
        if symbols.ca.is_zero().is_yes() {
            return self.with_crank_pin_on_pole_normal(fifth);
        }
        let Symbols {
            ca,
            sa,
            cd,
            sd,
            k_sin,
        } = &symbols;
        // quadratic s² + linear s c + absolute c² = 0 for the direction (c, s) of a ray
        let quadratic = sa * ca * cd;
        let linear = sa * (sa * cd - sd * ca + k_sin - 2 * &fifth.weighted_eta);
        let absolute = ca * (sd * ca - k_sin);
        let discriminant = linear.square() - 4 * &quadratic * absolute;
        let twice = 2 * quadratic;
        match discriminant.sign() {
            None => Alternates::Undecided,
            Some(Ordering::Less) => {
                let (re, im) = (-linear / &twice, (-discriminant).sqrt() / twice);
                Alternates::Complex([Number::complex(re.clone(), -&im), Number::complex(re, im)])
            }
            Some(_) => {
                let root = discriminant.sqrt();
                let rays = [-&linear - &root, -linear + root].map(|s| (twice.clone(), s));
                sorted(rays.map(|(c, s)| self.pair(c, s, &symbols)))
            }
        }
    }

    /// The pair on a ray of which it is known that it holds one, and the other one, by the product of
    /// the tangents of their rays. Neither pin is on the pole normal.
    pub fn pair_and_other(&self, ray: &Angle<K>) -> [Pair<K>; 2] {
        let symbols = self.symbols();
        let Symbols {
            ca,
            sa,
            cd,
            sd,
            k_sin,
        } = &symbols;
        let (c, s) = (sa * cd * ray.sin(), (sd * ca - k_sin) * ray.cos());
        [(ray.cos(), ray.sin()), (c, s)].map(|(c, s)| self.pair(c, s, &symbols))
    }

    /// The pair on the ray of direction (c, s): 1/PO = σ = (t − tan α_d)/(N s), 1/r = σ + 1/s.
    fn pair(&self, c: Number<K>, s: Number<K>, symbols: &Symbols<K>) -> Pair<K> {
        let Symbols {
            ca, cd, sd, k_sin, ..
        } = symbols;
        let ray = upper_half(c, s);
        let (c, s) = (ray.cos(), ray.sin());
        // Zero also where this arithmetic does not hold the ray.
        let numerator = if k_sin.is_zero().is_yes() {
            Number::zero()
        } else {
            k_sin * &c * &s
        };
        let from_d = ca * (&s * cd - sd * &c);
        Pair {
            point: Quotient::new(numerator.clone(), k_sin * c + &from_d),
            center: Quotient::new(numerator, from_d),
            ray,
        }
    }

    /// α_d = 90°: the cubic is the circle σ = 1/(k s) and the pole normal, on which the fifth position
    /// leaves, beside σ = 0 of D, σ = 2η − 1.
    fn with_slider_pin_at_inflection_pole(
        &self,
        symbols: &Symbols<K>,
        fifth: &Fifth<K>,
    ) -> Alternates<K> {
        let (k, k_eta) = (&self.k, &fifth.k_eta);
        let (c, s) = (&symbols.sa * (1 + k - 2 * k_eta), (k + 1) * &symbols.ca);
        let scale = to_upper_half(&c, &s);
        let ray = Angle::from_cos_sin(c * &scale, s * &scale);
        // k sin α/(k + 1), also for k = −1, where the point is on the pole tangent.
        let on_circle = Pair {
            point: Quotient::new(k * &symbols.ca * scale, Number::one()),
            center: Quotient::new(k * ray.sin(), Number::one()),
            ray,
        };
        let on_normal = Pair {
            ray: Angle::from_cos_sin(Number::zero(), Number::one()),
            point: Quotient::new(k.clone(), 2 * k_eta),
            center: Quotient::new(k.clone(), 2 * k_eta - k),
        };
        sorted([on_circle, on_normal])
    }

    /// α_a = 90°: the cubic is the inflection circle and the pole normal, on which the fifth position
    /// leaves, beside σ = 1/k of A, σ = 2η − 1 − 1/k. The fourth point is the pole. Its path has a cusp, and
    /// a = iθ²/2 + (a₄ + ib₄)θ⁴/24 keeps to the circle about 3/a₄ on the pole tangent to terms in θ⁴; with
    /// b₄ + 1 = 3(1 − k)/k² from A and a₄ = −(b₄ + 1) tan α_d from D that center is k²/((k − 1) tan α_d). It is the
    /// limit for α_a → 90° as well.
    fn with_crank_pin_on_pole_normal(&self, fifth: &Fifth<K>) -> Alternates<K> {
        let (k, k_eta) = (&self.k, &fifth.k_eta);
        let at_pole = Pair {
            ray: Angle::from_cos_sin(Number::one(), Number::zero()),
            point: Quotient::zero(),
            center: fifth.center_of_pole.clone(),
        };
        let on_normal = Pair {
            ray: Angle::from_cos_sin(Number::zero(), Number::one()),
            point: Quotient::new(k.clone(), 2 * k_eta - 1),
            center: Quotient::new(k.clone(), 2 * k_eta - k - 1),
        };
        sorted([at_pole, on_normal])
    }
}

/// η of a displacement e^{iθ} z + f with f ≠ 0: Im((e^{iθ} − 1) f̄)/|f|².
pub fn eta<K: Kind>(displacement: &Displacement<K>) -> Number<K> {
    let shift = &displacement.translation;
    ((&displacement.rotation - 1) * shift.conj()).im() / shift.norm()
}

/// The direction of a ray, modulo π, as an angle in [0°, 180°).
fn upper_half<K: Real>(c: Number<K>, s: Number<K>) -> Angle<K> {
    let scale = to_upper_half(&c, &s);
    Angle::from_cos_sin(c * &scale, s * scale)
}

/// What brings a direction to length 1 and into the upper half plane.
fn to_upper_half<K: Real>(c: &Number<K>, s: &Number<K>) -> Number<K> {
    let downwards = match s.sign() {
        Some(Ordering::Less) => true,
        Some(Ordering::Equal) => c.sign() == Some(Ordering::Less),
        _ => false,
    };
    let scale = (c.square() + s.square()).sqrt().inverse();
    if downwards { -scale } else { scale }
}

/// The smaller tangent first, where that can be told; a tangent that is infinite comes last.
fn sorted<K: Real>([first, second]: [Pair<K>; 2]) -> Alternates<K> {
    let vertical = |pair: &Pair<K>| pair.ray.cos().is_zero().is_yes();
    let out_of_order = vertical(&first)
        || !vertical(&second)
            && first.ray.tan().compare(&second.ray.tan()) == Some(Ordering::Greater);
    Alternates::Real(Box::new(if out_of_order {
        [second, first]
    } else {
        [first, second]
    }))
}
