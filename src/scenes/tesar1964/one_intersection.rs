//! Chapter IV: Ball's point with one prescribed intersection.

use super::pole_frame::{
    Constants, Pair, along, angle_of_tangent, inflection_point, pair_on_ray, unless_true,
};
use crate::curvature::canonical::Invariants;
use crate::formula::Bindings;
use crate::number::{Kind, Number, Real, Truth};
use crate::plane::Point;
use crate::plane::displacement::Displacement;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/one-intersection",
    "A coupler in its design position, in units of the diameter of the inflection circle and seen from the \
     pole, and in a second one. Its points A, B and C keep to circles for four infinitesimally separated \
     positions and in the second one, and D to a line: A and D are the pins of a slider-crank, and a crank B or C \
     in place of the slider moves D with contact of order three at D_1 and through D_2. The rays of A, B, C and \
     one coordinate of the pole P_12 are free.",
    build,
    [
        "alpha_a": "ray of the crank pin A",
        "alpha_b": "ray of the coupler point B",
        "alpha_c": "ray of the coupler point C, the one with the smaller tangent",
        "alpha_d": "ray of the slider's pin D",
        "N": "diameter of the circle that osculates the cubic in the pole and touches the pole normal",
        "PB": "from the pole to B, along its ray",
        "s_12": "from D_1 to D_2, in the direction of the ray of D turned by 90 deg",
        "U_b2": "coordinate of B in the second position",
        "V_b2": "coordinate of B in the second position",
        "U_12": "coordinate of the pole P_12",
        "V_12": "coordinate of the pole P_12",
    ]
);

/// The ray of Ball's point and the pole of the displacement, by the rays of A, B and C.
///
/// Of the points of the cubic of stationary curvature, those that a displacement about P_12 brings back to
/// their circles, while D stays on its line, have tangents t with
///
/// t³ − (d − N + 2hN)t² + (1 − 2gN + N²(1 − h)(g² + h²)/(dg − h))t = d − N,
///
/// where d = tan α_d and 1/P̄_12 = g + ih. With the three roots and gN free, hN is known from the sum of the
/// roots less their product, and N is linear in the sum of their products two by two.
struct Choice<K> {
    tan_d: Number<K>,
    n: Number<K>,
    pole: Point<K>,
}

impl<K: Real> Choice<K> {
    fn of([a, b, c]: [&Number<K>; 3], gn: &Number<K>) -> Self {
        let sum = a + b + c;
        let pairs = a * b + b * c + c * a;
        let product = a * b * c;
        let hn = (sum - &product) / 2;
        let middle = pairs - 1 + 2 * gn;
        let square = gn.square() + hn.square();
        let n = (&middle * (&hn - &product * gn) - &hn * &square) / (middle * gn - square);
        Choice {
            tan_d: &product + &n,
            pole: Number::complex(n.clone(), Number::zero()) / Number::complex(gn.clone(), -hn),
            n,
        }
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let alpha_a = free.slope("alpha_a")?;
    let tan_c = free.number("tan alpha_c")?;
    let tan_b = &tan_c + free.length("tan alpha_b - tan alpha_c")?;
    let gn = free.number("N U_12/|P_12|^2")?;
    let Choice { tan_d, n, pole } = Choice::of([&alpha_a.tan(), &tan_b, &tan_c], &gn);
    let alpha_b = angle_of_tangent(free, "1/cos alpha_b", &tan_b)?;
    let alpha_c = angle_of_tangent(free, "1/cos alpha_c", &tan_c)?;
    let alpha_d = angle_of_tangent(free, "1/cos alpha_d", &tan_d)?;
    let invariants = with_ball_point(&tan_d, &n);
    let [a, b, c] =
        [&alpha_a, &alpha_b, &alpha_c].map(|ray| pair_on_ray(&invariants, ray.direction()));
    let d = inflection_point(alpha_d.direction());
    let second = displacement(&d, &pole);
    unless_true::<K>(
        || keep(&invariants, &second, [&a, &b, &c, &d]),
        "A, B, C and D keep to their guides",
    )?;
    let travel = along(
        &(Number::i() * alpha_d.cis()),
        &(second.of(&d.point) - &d.point),
    );
    let mut bindings = Bindings::new(free.precision());
    for (index, point) in [("b2", &second.of(&b.point)), ("12", &pole)] {
        bindings.bind(&format!("U_{index}"), point.re().clone());
        bindings.bind(&format!("V_{index}"), point.im().clone());
    }
    bindings.bind("N", Constants::of(&invariants.motion())?.n);
    bindings.bind("s_12", travel);
    bindings.bind("PB", b.to_point(&alpha_b));
    for (name, angle) in [
        ("alpha_a", alpha_a),
        ("alpha_b", alpha_b),
        ("alpha_c", alpha_c),
        ("alpha_d", alpha_d),
    ] {
        bindings.bind(name, angle);
    }
    Ok(bindings)
}

/// The motion with Ball's point on a ray, a₃ + b₃ tan α_d = 0, and N = 3/b₃.
fn with_ball_point<K: Kind>(tan_d: &Number<K>, n: &Number<K>) -> Invariants<K> {
    let direction = Number::complex(-tan_d, Number::one());
    Invariants {
        third: (direction * 3).scaled(&n.inverse()),
        fourth: Number::zero(),
    }
}

/// The turn about a point that keeps the slider's pin on its line: half of it leads from the way to the
/// pin to the ray across that line.
fn displacement<K: Kind>(slider: &Pair<K>, about: &Point<K>) -> Displacement<K> {
    let half = &slider.ray * (&slider.point - about).conj();
    Displacement::about(about, &half / half.conj())
}

/// Whether points have four infinitesimally separated positions, and the second one, on their circles or
/// lines.
fn keep<K: Kind>(
    invariants: &Invariants<K>,
    second: &Displacement<K>,
    pairs: [&Pair<K>; 4],
) -> Truth {
    let motion = invariants.motion();
    let near = |pair: &Pair<K>| {
        let kept = pair.guide().along(&motion);
        Truth::all((1..=3).map(|j| kept.coefficient(j).is_zero()))
    };
    let far = |pair: &Pair<K>| {
        let (first, second) = (&pair.point, second.of(&pair.point));
        match &pair.center {
            Some(center) => (first - center).norm().equals(&(second - center).norm()),
            None => along(&pair.ray, &(second - first)).is_zero(),
        }
    };
    Truth::all(pairs.into_iter().map(|pair| near(pair) & far(pair)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::poly::Fraction;
    use crate::scenes::free::{Symbols, point};

    /// For any ray, what the square of the crank grows by is that cubic times what vanishes for D only.
    #[test]
    fn the_cubic_is_that_of_the_points_that_are_kept() {
        let mut free = Symbols::default();
        let mut number = |name| -> Number<Fraction> { free.number(name).unwrap() };
        let (d, n, t) = (number("tan alpha_d"), number("N"), number("t"));
        let pole = point(&mut free, "P_12").unwrap();
        let ray = |tan: &Number<Fraction>| Number::complex(Number::one(), tan.clone());
        let slider = inflection_point(&ray(&d));
        let second = displacement(&slider, &pole);
        let invariants = with_ball_point(&d, &n);
        let Pair { point, center, .. } = pair_on_ray(&invariants, &ray(&t));
        let center = center.unwrap();
        let growth = (second.of(&point) - &center).norm() - (&point - &center).norm();
        let inverse = pole.conj().inverse();
        let (g, h) = (inverse.re(), inverse.im());
        let linear = 1 - 2 * g * &n + n.square() * (1 - h) * inverse.norm() / (&d * g - h);
        let square = &d - &n + 2 * h * &n;
        let cubic = t.power(3) - square * t.square() + linear * &t - (&d - &n);
        let factor = 2 * (1 - second.rotation.re()) * along(&center, &point) * pole.norm();
        let expected = factor * (&t - &d) * cubic / (&n * &t).square();
        assert!(growth.equals(&expected).is_yes());
    }
}
