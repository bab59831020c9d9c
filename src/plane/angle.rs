//! Angles as directions: exact in every kind, without any inverse function.

use std::ops::{Add, Neg, Sub};

use rug::Rational;

use super::Point;
use crate::number::{Kind, Number, Real, Truth};

/// An angle, held as a complex number of that argument. Sums, differences, multiples, tangents and
/// comparisons need no root; cosine and sine need the length of the complex number, which is known
/// to be 1 where the angle came with them.
///
/// An angle made from its tangent alone is known modulo π only, the half of an angle modulo half of
/// what was known, and so is what is computed from them. Their cosine and sine are those of the
/// direction that is held, one of those possible.
#[derive(Clone, Debug)]
pub struct Angle<K> {
    direction: Point<K>,
    length: Option<Number<K>>,
    /// The angle is known modulo 2π divided by this.
    ambiguity: u32,
}

impl<K: Kind> Angle<K> {
    /// The angle of this cosine and sine, cos² + sin² = 1.
    pub fn from_cos_sin(cos: Number<K>, sin: Number<K>) -> Self {
        Angle {
            direction: Number::complex(cos, sin),
            length: Some(Number::one()),
            ambiguity: 1,
        }
    }

    /// The argument of a complex number that is not zero.
    pub fn of(direction: Point<K>) -> Self {
        Angle {
            direction,
            length: None,
            ambiguity: 1,
        }
    }

    /// The argument of a complex number whose absolute value is known.
    pub fn of_known_length(direction: Point<K>, length: Number<K>) -> Self {
        Angle {
            direction,
            length: Some(length),
            ambiguity: 1,
        }
    }

    /// The angle with this tangent, modulo π.
    pub fn from_tan(tan: Number<K>) -> Self {
        Angle {
            direction: Number::complex(Number::one(), tan),
            length: None,
            ambiguity: 2,
        }
    }

    /// The angle 2 arctan t, for t = tan of half of it: never 180°.
    pub fn from_tan_half(t: &Number<K>) -> Self {
        let scale = 1 + t.square();
        Self::from_cos_sin((1 - t.square()) / &scale, 2 * t / &scale)
    }

    /// The turn about `vertex` that carries the ray to `from` into the ray to `to`, positive
    /// counterclockwise.
    pub fn at_vertex(from: &Point<K>, vertex: &Point<K>, to: &Point<K>) -> Self {
        Self::of((to - vertex) * (from - vertex).conj())
    }

    /// A complex number whose argument is this angle.
    pub fn direction(&self) -> &Point<K> {
        &self.direction
    }

    /// n where the angle is known modulo 2π/n: 1 for most, 2 for one made from its tangent.
    pub fn ambiguity(&self) -> u32 {
        self.ambiguity
    }

    /// `false` for the angle of the zero vector and of what has no value.
    pub fn has_value(&self) -> bool {
        self.direction.has_value() && !self.direction.is_zero().is_yes()
    }

    /// tan; no value at ±90°.
    pub fn tan(&self) -> Number<K> {
        self.direction.im() / self.direction.re()
    }

    /// cot; no value at 0° and 180°.
    pub fn cot(&self) -> Number<K> {
        self.direction.re() / self.direction.im()
    }

    /// The angle times an integer.
    pub fn times(&self, n: i32) -> Self {
        Angle {
            direction: if n < 0 {
                self.direction.conj().power(-n)
            } else {
                self.direction.power(n)
            },
            length: self.length.as_ref().map(|length| length.power(n.abs())),
            ambiguity: self.ambiguity / gcd(self.ambiguity, n.unsigned_abs()),
        }
    }

    /// Whether two angles differ by a multiple of π.
    pub fn equals_modulo_pi(&self, other: &Self) -> Truth {
        self.between(other).im().is_zero()
    }

    /// The direction of `self − other`.
    fn between(&self, other: &Self) -> Point<K> {
        &self.direction * other.direction.conj()
    }
}

impl<K: Real> Angle<K> {
    /// An angle in degrees, where the kind holds its cosine and sine.
    pub fn from_degrees(degrees: &Rational, precision: &K::Precision) -> Option<Self> {
        let (cos, sin) = K::cos_sin_of_degrees(degrees, precision)?;
        Some(Self::from_cos_sin(Number(cos), Number(sin)))
    }

    fn length(&self) -> Number<K> {
        match &self.length {
            Some(length) => length.clone(),
            None => self.direction.norm().sqrt(),
        }
    }

    /// cos; no value where the kind does not hold the root in it.
    pub fn cos(&self) -> Number<K> {
        self.direction.re() / self.length()
    }

    /// sin; no value where the kind does not hold the root in it.
    pub fn sin(&self) -> Number<K> {
        self.direction.im() / self.length()
    }

    /// e^{iγ}.
    pub fn cis(&self) -> Point<K> {
        self.direction.scaled(&self.length().inverse())
    }

    /// The same angle with a unit vector as its direction; no value where the kind does not hold it.
    pub fn normalized(&self) -> Self {
        Angle {
            direction: self.cis(),
            length: Some(Number::one()),
            ambiguity: self.ambiguity,
        }
    }

    /// Half the angle, known modulo half of what the angle is: its direction is that of e^{iγ} + 1; no
    /// value for 180°.
    pub fn half(&self) -> Self {
        let sum = Number::complex(
            self.direction.re() + self.length(),
            self.direction.im().clone(),
        );
        Angle {
            direction: sum,
            length: None,
            ambiguity: self.ambiguity.saturating_mul(2),
        }
    }

    /// Whether two angles are equal, modulo 2π, or modulo as much as is known of both.
    pub fn equals(&self, other: &Self) -> Truth {
        self.equals_modulo_turn_over(other, 1)
    }

    /// Whether two angles differ by a multiple of 2π/n, or of as much as is known of both.
    pub fn equals_modulo_turn_over(&self, other: &Self, n: u16) -> Truth {
        let parts = lcm(lcm(self.ambiguity, other.ambiguity), n.max(1).into());
        let Ok(parts) = i32::try_from(parts) else {
            return Truth::Unknown;
        };
        // z² is positive where z is real: one square less.
        if parts % 2 == 0 {
            return self.between(other).power(parts / 2).im().is_zero();
        }
        let power = self.between(other).power(parts);
        power.im().is_zero() & power.re().is_positive()
    }
}

fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The least common multiple of two numbers, the first not zero.
fn lcm(a: u32, b: u32) -> u32 {
    (a / gcd(a, b)).saturating_mul(b)
}

impl<K: Kind> Angle<K> {
    fn combined(&self, other: &Self, direction: Point<K>) -> Self {
        let length = match (&self.length, &other.length) {
            (Some(a), Some(b)) => Some(a * b),
            _ => None,
        };
        Angle {
            direction,
            length,
            ambiguity: lcm(self.ambiguity, other.ambiguity),
        }
    }
}

impl<K: Kind> Add for &Angle<K> {
    type Output = Angle<K>;
    #[expect(
        clippy::suspicious_arithmetic_impl,
        reason = "angles add where their directions multiply"
    )]
    fn add(self, other: &Angle<K>) -> Angle<K> {
        self.combined(other, &self.direction * &other.direction)
    }
}

impl<K: Kind> Sub for &Angle<K> {
    type Output = Angle<K>;
    fn sub(self, other: &Angle<K>) -> Angle<K> {
        self.combined(other, self.between(other))
    }
}

impl<K: Kind> Neg for &Angle<K> {
    type Output = Angle<K>;
    fn neg(self) -> Angle<K> {
        self.times(-1)
    }
}
