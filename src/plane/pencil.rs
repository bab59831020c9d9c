//! Points of a focal cubic in floats, many at once: where lines through its focus meet it.
//!
//! On the line ζ = r e, e = e^{iη}, with A = Re(ᾱe), C = Re(ν̄e) it is A r² + β r + C = 0, so that
//!
//! ```text
//! q = −½ (β ± √(β² − 4AC)),   r = q/A and r = C/q,   z = φ + r e,
//! ```
//!
//! with the sign of β, so that no digits are lost: half a turn of lines gives all points. Without a
//! value are those of lines that do not meet the curve beside the focus, infinite is the first point of
//! a line along the asymptote.
//!
//! Rounding costs, with ε = 2⁻⁵³ and ζ = z − φ, no more than
//!
//! ```text
//! |Re(ᾱζ)|ζ|² + β|ζ|² + Re(ν̄ζ)| ≤ ε (22|ζ| + 3|z|) (|α||ζ|² + |β||ζ| + |ν|)
//! ```
//!
//! to first order. For, if E = |α|r² + |β r| + |ν|: A and C err by 2ε|α|, 2ε|ν|; q fulfils
//! q² + βq + AC = 0 but for 12ε q²; so A r² + β r + C is at most ε (12 + 2 + 2) E, three more E with the
//! length of e; and z errs by ε (|ζ| + |z|), where the polynomial grows by 3E a length.

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, SimdFrom, dispatch, f64x4};

use super::Point;
use super::focal_cubic::FocalCubic;
use crate::number::lanes::{self, LANES};

/// The points on lines of the directions cos η, sin η: x and y of r = q/A, the farther one from the focus
/// where both are on one side, then those of r = C/q. As many as the shortest slice holds.
pub fn meets(curve: &FocalCubic<f64>, directions: [&[f64]; 2], points: [[&mut [f64]; 2]; 2]) {
    meets_with(lanes::level(), curve, directions, points);
}

fn meets_with(
    level: Level,
    curve: &FocalCubic<f64>,
    directions: [&[f64]; 2],
    points: [[&mut [f64]; 2]; 2],
) {
    dispatch!(level, simd => Curve::new(simd, curve).meets(directions, points));
}

/// x + iy
type Pair<S> = [f64x4<S>; 2];

/// The constants of the curve in all lanes.
struct Curve<S: Simd> {
    simd: S,
    focus: Pair<S>,
    alpha: Pair<S>,
    beta: f64x4<S>,
    nu: Pair<S>,
}

impl<S: Simd> Curve<S> {
    #[inline(always)]
    fn new(simd: S, curve: &FocalCubic<f64>) -> Self {
        let all = |z: &Point<f64>| [z.re(), z.im()].map(|x| f64x4::splat(simd, x.0));
        Curve {
            simd,
            focus: all(&curve.focus),
            alpha: all(&curve.alpha),
            beta: f64x4::splat(simd, curve.beta.0),
            nu: all(&curve.nu),
        }
    }

    /// On four lines.
    #[inline(always)]
    fn on_lines(&self, [cos, sin]: [&[f64; LANES]; 2]) -> [[[f64; LANES]; 2]; 2] {
        let e = [
            f64x4::simd_from(self.simd, *cos),
            f64x4::simd_from(self.simd, *sin),
        ];
        let (a, c) = (scalar(self.alpha, e), scalar(self.nu, e));
        let root = (self.beta * self.beta - a * c * 4.0).sqrt();
        let q = (self.beta + root.copysign(self.beta)) * -0.5;
        [self.place(q / a, e), self.place(c / q, e)]
    }

    #[inline(always)]
    fn place(&self, r: f64x4<S>, e: Pair<S>) -> [[f64; LANES]; 2] {
        [
            (self.focus[0] + r * e[0]).into(),
            (self.focus[1] + r * e[1]).into(),
        ]
    }

    #[inline(always)]
    fn meets(&self, [cos, sin]: [&[f64]; 2], [first, second]: [[&mut [f64]; 2]; 2]) {
        let ((cos, last_cos), (sin, last_sin)) = (cos.as_chunks(), sin.as_chunks());
        let [[(x, last_x), (y, last_y)], [(u, last_u), (v, last_v)]] =
            [first, second].map(|point| point.map(<[f64]>::as_chunks_mut));
        let points = x.iter_mut().zip(y).zip(u.iter_mut().zip(v));
        for ((cos, sin), ((x, y), (u, v))) in cos.iter().zip(sin).zip(points) {
            [[*x, *y], [*u, *v]] = self.on_lines([cos, sin]);
        }
        let count = last_cos.len().min(last_sin.len());
        let last = self.on_lines([&lanes::filled(last_cos), &lanes::filled(last_sin)]);
        let places = [last_x, last_y, last_u, last_v];
        for (places, found) in places.into_iter().zip(last.as_flattened()) {
            let found = found.iter().take(count);
            places
                .iter_mut()
                .zip(found)
                .for_each(|(place, x)| *place = *x);
        }
    }
}

#[inline(always)]
fn scalar<S: Simd>([a, b]: Pair<S>, [x, y]: Pair<S>) -> f64x4<S> {
    a * x + b * y
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;
    use crate::number::{Ball, Complex, Number, count};
    use crate::plane::circular_cubic::Cubic;

    const ROUNDING: f64 = f64::EPSILON / 2.0;
    /// No multiple of the lanes.
    const LINES: usize = 1001;

    fn z(x: f64, y: f64) -> Number<Complex<f64>> {
        Number::complex(Number(x), Number(y))
    }

    /// With two branches, with one, far from the origin, with the focus on the asymptote.
    fn curves() -> [FocalCubic<f64>; 4] {
        let curve = |focus, alpha, beta, nu| FocalCubic {
            focus,
            alpha,
            beta: Number(beta),
            nu,
        };
        [
            curve(z(0.3, -1.2), z(0.7, 0.4), 3.0, z(0.2, -0.9)),
            curve(z(-2.0, 0.1), z(1.7, -0.4), -0.3, z(1.2, 2.9)),
            curve(z(1e4, -3e3), z(0.1, 1.4), 1.1, z(-0.6, 0.8)),
            curve(z(0.0, 0.5), z(1.0, 0.2), 0.0, z(0.4, -1.0)),
        ]
    }

    fn directions() -> [Vec<f64>; 2] {
        let angles = (0..LINES)
            .map(|n| std::f64::consts::PI * (count::to_f64(n) + 0.5) / count::to_f64(LINES));
        let angles: Vec<f64> = angles.collect();
        [f64::cos, f64::sin].map(|f| angles.iter().map(|angle| f(*angle)).collect())
    }

    fn found(level: Level, curve: &FocalCubic<f64>) -> [[Vec<f64>; 2]; 2] {
        let [cos, sin] = directions();
        let mut points = [(); 2].map(|()| [(); 2].map(|()| vec![0.0; LINES]));
        let places = points
            .each_mut()
            .map(|point| point.each_mut().map(|part| part.as_mut_slice()));
        meets_with(level, curve, [&cos, &sin], places);
        points
    }

    #[test]
    fn every_instruction_set_finds_the_same() {
        let bits = |points: &[[Vec<f64>; 2]; 2]| -> Vec<Option<u64>> {
            let all = points.as_flattened().iter().flatten();
            all.map(|x| (!x.is_nan()).then_some(x.to_bits())).collect()
        };
        for curve in curves() {
            let expected = bits(&found(Level::baseline(), &curve));
            for level in lanes::levels() {
                assert_eq!(bits(&found(level, &curve)), expected, "{level:?}");
            }
        }
    }

    #[test]
    fn points_are_on_the_curve() {
        let ball = |x: f64| Number::<Ball>::rounded(&Rational::from_f64(x).unwrap(), &300);
        let point = |x: f64, y: f64| Number::complex(ball(x), ball(y));
        let (mut compared, mut largest) = (0, 0.0_f64);
        for curve in curves() {
            let size = |z: &Point<f64>| z.re().0.hypot(z.im().0);
            let exact = [&curve.focus, &curve.alpha, &curve.nu].map(|z| point(z.re().0, z.im().0));
            let [focus, alpha, nu] = exact;
            let beta = ball(curve.beta.0);
            for [x, y] in found(lanes::level(), &curve) {
                for (x, y) in x.into_iter().zip(y) {
                    if !x.is_finite() {
                        continue;
                    }
                    let zeta = point(x, y) - &focus;
                    let square = zeta.norm();
                    let value = (alpha.conj() * &zeta).re() * &square
                        + &beta * &square
                        + (nu.conj() * &zeta).re();
                    let [value, square] =
                        [value, square].map(|x| x.0.midpoint_rational().unwrap().to_f64());
                    let length = square.sqrt();
                    let sum =
                        size(&curve.alpha) * square + curve.beta.0.abs() * length + size(&curve.nu);
                    let bound = ROUNDING * (22.0 * length + 3.0 * x.hypot(y)) * sum;
                    assert!(value.abs() < bound, "{value:e} {bound:e} {curve:?}");
                    largest = largest.max(value.abs() / bound);
                    compared += 1;
                }
            }
        }
        assert!(compared > 4 * LINES, "{compared}");
        assert!(
            largest > 0.05,
            "a bound that is never nearly reached says little: {largest}"
        );
    }

    /// The same points by the general form of the cubic.
    #[test]
    fn they_are_zeros_of_the_cubic() {
        let vertices = [z(0.0, 0.0), z(3.0, 0.4), z(3.9, 2.1), z(-0.2, 1.7)];
        let cubic = Cubic::focal(&vertices).unwrap();
        let curve = FocalCubic::of(&cubic).unwrap();
        let [[x, y], near] = found(lanes::level(), &curve);
        let far = x.into_iter().zip(y);
        let [x, y] = near;
        let mut zeros = 0;
        for (x, y) in far.chain(x.into_iter().zip(y)) {
            let scale = cubic.gradient(&z(x, y)).norm().0.sqrt();
            if x.is_finite() && x.hypot(y) < 100.0 {
                assert!((cubic.at(&z(x, y)).0 / scale).abs() < 1e-11, "{x} {y}");
                zeros += 1;
            }
        }
        assert!(zeros > LINES / 2, "{zeros}");
    }
}
