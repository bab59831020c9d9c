//! The circuits of the circlepoint curve, and what a turning crank sweeps of them.

use std::cmp::Ordering;

use crate::finite::compatibility::LoopClosure;
use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::plane::displacement::Displacement;
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "kaufman/circuits",
    "Four positions of the moving plane, all of them free. The crank angles of flat triangles are the \
     real roots of an equation of order 4 for tan gamma_2/2. The circuits of the circlepoint curve, \
     which is the focal cubic of the image poles, are found from its tangents parallel to the \
     asymptote: a curve of one circuit has two, a curve of two circuits four.",
    build,
    not symbolic: "the number of real roots",
    [
        "R_1": "length of Delta_1",
        "R_2": "length of Delta_2",
        "R_3": "length of Delta_3",
        "R_4": "length of Delta_4",
        "N": "how many crank angles gamma_2 of a full turn make the compatibility triangle flat",
        "B": "how many circuits the circlepoint curve has",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let mut position = |j: usize| -> Result<Displacement<K>, Unbuilt> {
        Ok(Displacement {
            rotation: free.angle(&format!("phi_{j}"))?.cis(),
            translation: point(free, &format!("delta_{j}"))?,
        })
    };
    let positions = [
        Displacement::identity(),
        position(2)?,
        position(3)?,
        position(4)?,
    ];
    let [second, third, fourth] = LoopClosure::of(&positions, &Number::zero()).minors();
    let minors = [&second + &third + &fourth, second, third, fourth];
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("N", counted(&flat_triangles(&minors))?);
    let circuits = counted(&parallel_tangents(&circlepoint_curve(&positions)?))? / 2;
    bindings.bind("B", circuits);
    for (name, minor) in ["R_1", "R_2", "R_3", "R_4"].into_iter().zip(minors) {
        bindings.bind(name, free.root(name, &minor.norm())?);
    }
    Ok(bindings)
}

/// The coefficients of a polynomial of order 4, the highest first.
struct Quartic<K>([Number<K>; 5]);

impl<K: Real> Quartic<K> {
    /// How many different real roots there are; `None` where this cannot be told, or where the order
    /// is lower or roots coincide.
    fn real_roots(&self) -> Option<i64> {
        let Quartic([a, b, c, d, e]) = self;
        let i = 12 * a * e - 3 * b * d + c.square();
        let j = 72 * a * c * e + 9 * b * c * d
            - 27 * (a * d.square() + e * b.square())
            - 2 * c.power(3);
        // 27 times the discriminant.
        let discriminant = 4 * i.power(3) - j.square();
        let p = 8 * a * c - 3 * b.square();
        let q = 64 * a.power(3) * e - 16 * (a * c).square() + 16 * a * b.square() * c
            - 16 * a.square() * b * d
            - 3 * b.power(4);
        match (a.sign()?, discriminant.sign()?) {
            (Ordering::Equal, _) | (_, Ordering::Equal) => None,
            (_, Ordering::Less) => Some(2),
            _ if p.sign()?.is_lt() && q.sign()?.is_lt() => Some(4),
            _ => Some(0),
        }
    }
}

fn counted<K: Real>(quartic: &Quartic<K>) -> Result<Number<K>, Unbuilt> {
    match quartic.real_roots() {
        Some(count) => Ok(count.into()),
        None => Err(Unbuilt::NotHeld("the number of real roots".to_owned())),
    }
}

/// (|Δ|² − |Δ₃|² − |Δ₄|²)² = 4|Δ₃|²|Δ₄|² for Δ = Δ₁ − e^{iγ₂} Δ₂, times (1 + t²)², t = tan γ₂/2.
fn flat_triangles<K: Real>([first, second, third, fourth]: &[Point<K>; 4]) -> Quartic<K> {
    let product = first.conj() * second;
    // (1 + t²)(|Δ|² − |Δ₃|² − |Δ₄|²) = k + l t + m t².
    let sum = first.norm() + second.norm() - third.norm() - fourth.norm();
    let (k, l, m) = (
        &sum - 2 * product.re(),
        4 * product.im(),
        &sum + 2 * product.re(),
    );
    let both = 4 * third.norm() * fourth.norm();
    Quartic([
        m.square() - &both,
        2 * &l * &m,
        l.square() + 2 * &k * &m - 2 * &both,
        2 * &k * &l,
        k.square() - both,
    ])
}

/// In position 1.
fn circlepoint_curve<K: Real>(positions: &[Displacement<K>; 4]) -> Result<Cubic<K>, Unbuilt> {
    let [first, second, third, fourth] = positions;
    let opposite = [
        (first, third),
        (second, third),
        (second, fourth),
        (first, fourth),
    ];
    let vertices = opposite.map(|(one, other)| one.inverse().of(&one.pole(other)));
    Cubic::focal(&vertices).ok_or_else(|| Unbuilt::NotHeld("the circlepoint curve".to_owned()))
}

/// With coordinates s across the asymptote and t along it, scaled so that x = as − bt, y = bs + at for
/// the cubic part (ax + by)(x² + y²), the curve is α t² + β t + γ = 0. A parallel to the asymptote is a
/// tangent where β² = 4αγ.
fn parallel_tangents<K: Real>(curve: &Cubic<K>) -> Quartic<K> {
    let [a, b, _, _, e, f, g, h, i, j] = curve.coefficients();
    let (a2, ab, b2) = (a.square(), a * b, b.square());
    let cubic = (&a2 + &b2).square();
    let s2 = e * &a2 + f * &ab + g * &b2;
    let st = 2 * (g - e) * &ab + f * (&a2 - &b2);
    let t2 = e * &b2 - f * &ab + g * &a2;
    let (s, t) = (h * a + i * b, i * a - h * b);
    // α = cubic s + t2, β = st s + t, γ = cubic s³ + s2 s² + s s + j.
    Quartic([
        -4 * cubic.square(),
        -4 * &cubic * (&s2 + &t2),
        st.square() - 4 * (&cubic * &s + &t2 * s2),
        2 * st * &t - 4 * (cubic * j + &t2 * s),
        t.square() - 4 * t2 * j,
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::univariate::Polynomial;
    use crate::number::{Exact, Surd};
    use crate::scenes::free::Random;

    #[test]
    fn real_roots_are_counted_as_by_sturm() {
        let mut counts = [0; 5];
        for seed in 0..200 {
            let mut random = Random::new(seed);
            let coefficients: [Number<Exact>; 5] =
                [(); 5].map(|()| random.number("coefficient").unwrap());
            let ascending = coefficients.iter().rev().cloned().collect();
            let sturm = Polynomial::new(ascending).sturm_sequence().unwrap().count();
            let count = Quartic(coefficients).real_roots().unwrap();
            assert_eq!(usize::try_from(count), Ok(sturm));
            counts[sturm] += 1;
        }
        assert!(
            counts[0] > 5 && counts[2] > 5 && counts[4] > 5,
            "{counts:?}"
        );
    }

    #[test]
    fn tangents_are_counted_where_the_curve_is_known() {
        let cubic = |tail: [(i64, i64); 6]| {
            let mut coefficients = [1, 0, 1, 0, 0, 0, 0, 0, 0, 0].map(Number::<Exact>::from);
            for (place, (n, d)) in coefficients.iter_mut().skip(4).zip(tail) {
                *place = Number::ratio(n, d);
            }
            Cubic::new(coefficients)
        };
        // x (x² + y²) = 1.
        let one = cubic([(0, 1), (0, 1), (0, 1), (0, 1), (0, 1), (-1, 1)]);
        assert_eq!(parallel_tangents(&one).real_roots(), Some(2));
        // (x + 1) y² = −x (x − 1)(x − 2): an oval between 1 and 2, and a branch.
        let two = cubic([(-3, 1), (0, 1), (1, 1), (2, 1), (0, 1), (0, 1)]);
        assert_eq!(parallel_tangents(&two).real_roots(), Some(4));
    }

    #[test]
    fn every_number_of_flat_triangles_occurs() {
        let mut found = std::collections::BTreeSet::new();
        for seed in 0..200 {
            if let Ok(bindings) = build::<Surd>(&mut Random::new(seed)) {
                found.insert(format!("{:?}", bindings.get("N")));
            }
        }
        assert_eq!(found.len(), 3, "{found:?}");
    }
}
