//! A motion near one of its positions.

use crate::number::{Kind, Number, Series, count};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// A displacement as a series in a parameter t. For t = 0 the moving plane lies on the fixed one.
pub type Motion<K> = Displacement<Series<K>>;

/// A point that moves.
pub type Path<K> = Point<Series<K>>;

/// x(t) + i y(t), coefficient by coefficient.
pub fn path<K: Kind>(coefficients: &[Point<K>], order: usize) -> Path<K> {
    let part = |of: fn(&Point<K>) -> &Number<K>| {
        Number::from_coefficients(coefficients.iter().map(|z| of(z).clone()), order)
    };
    Number::complex(part(Number::re), part(Number::im))
}

/// A point that does not move.
pub fn fixed<K: Kind>(point: &Point<K>) -> Path<K> {
    Number::complex(point.re().clone().into(), point.im().clone().into())
}

/// The coefficient of tʲ.
pub fn coefficient<K: Kind>(path: &Path<K>, j: usize) -> Point<K> {
    Number::complex(path.re().coefficient(j), path.im().coefficient(j))
}

/// The derivative with respect to t.
pub fn derivative<K: Kind>(path: &Path<K>) -> Path<K> {
    Number::complex(path.re().derivative(), path.im().derivative())
}

/// e^{iφ} for a series φ without constant term.
pub fn turn<K: Kind>(angle: &Number<Series<K>>) -> Path<K> {
    let step: Path<K> = Number::i() * Path::from(angle.clone());
    let order = count::to_i64(angle.order().unwrap_or(0));
    // Horner: 1 + iφ (1 + iφ/2 (1 + iφ/3 (…))).
    let inner = |sum: Path<K>, n: i64| 1 + &step * sum / n;
    (1..=order).rev().fold(Number::one(), inner)
}

/// The motion that turns by θ and shifts the moving origin by Σ aₙ θⁿ/n!, from a₁ on; θ is the
/// parameter.
pub fn turning<K: Kind>(derivatives: &[Point<K>], order: usize) -> Motion<K> {
    let mut factorial = 1;
    let terms = derivatives.iter().zip(1_i64..).map(|(derivative, n)| {
        factorial *= n;
        derivative / factorial
    });
    let coefficients: Vec<Point<K>> = std::iter::once(Number::zero()).chain(terms).collect();
    Displacement {
        rotation: turn(&Number::parameter(order)),
        translation: path(&coefficients, order),
    }
}

impl<K: Kind> Displacement<Series<K>> {
    /// Where a point of the moving plane goes.
    pub fn path_of(&self, point: &Point<K>) -> Path<K> {
        self.of(&fixed(point))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Exact;

    #[test]
    fn a_turn_has_length_one_and_is_its_own_rate() {
        let angle = Number::from_coefficients([0, 2, -3, 5, 1].map(Number::<Exact>::from), 4);
        let turned = turn(&angle);
        assert!(turned.norm().equals(&1.into()).is_yes());
        let rate = Number::i() * Path::from(angle.derivative()) * &turned;
        assert!(derivative(&turned).equals(&rate).is_yes());
    }

    #[test]
    fn the_derivatives_of_the_shift_come_back() {
        let derivatives = [(1, 2), (0, -3), (4, 5), (-7, 1)]
            .map(|(x, y)| Number::complex(Number::<Exact>::from(x), Number::from(y)));
        let motion = turning(&derivatives, 4);
        let mut shift = motion.translation;
        for expected in &derivatives {
            shift = derivative(&shift);
            assert!(coefficient(&shift, 0).equals(expected).is_yes());
        }
    }
}
