//! Where a scene takes its free parameters from.

use std::collections::BTreeMap;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use rug::Rational;
use thiserror::Error;

use crate::formula::{Bindings, Formula, Value, evaluate_expression};
use crate::number::poly::{Fraction, Ring};
use crate::number::{Kind, Number, Real, Truth};
use crate::plane::{Angle, Point};

/// A source of free parameters in one number kind.
pub trait Free<K: Real> {
    /// To what constants are rounded.
    fn precision(&self) -> K::Precision;

    /// A length: a number that is not negative and not zero.
    fn length(&mut self, name: &str) -> Result<Number<K>, Unbuilt>;

    /// A length that may as well be one that is known: random lengths alone would never be equal.
    fn length_or(&mut self, name: &str, _known: &Number<K>) -> Result<Number<K>, Unbuilt> {
        self.length(name)
    }

    /// A ratio between 0 and 1, both excluded.
    fn part(&mut self, name: &str) -> Result<Number<K>, Unbuilt> {
        let other = self.length(name)?;
        Ok(&other / (1 + &other))
    }

    /// Any real number.
    fn number(&mut self, name: &str) -> Result<Number<K>, Unbuilt>;

    /// Any angle; its direction is a unit vector.
    fn angle(&mut self, name: &str) -> Result<Angle<K>, Unbuilt>;

    /// Any angle. Where it stays free it is held by its tangent, so that what is rational in the tangent
    /// stays small; its direction then is no unit vector.
    fn slope(&mut self, name: &str) -> Result<Angle<K>, Unbuilt> {
        self.angle(name)
    }

    /// An angle that only chooses a position of the mechanism: in an example, in which nothing that
    /// is printed depends on it, any will do.
    fn position(&mut self, name: &str) -> Result<Angle<K>, Unbuilt> {
        self.angle(name)
    }

    /// The positive square root of a number, as the length `name`.
    fn root(&mut self, name: &str, radicand: &Number<K>) -> Result<Number<K>, Unbuilt> {
        let root = radicand.clone().sqrt();
        if root.has_value() {
            Ok(root)
        } else {
            Err(Unbuilt::NotHeld(format!("the square root that is {name}")))
        }
    }

    /// The same number. Where symbols stay free, a root of it is looked for among all that there are by
    /// now, not only among those of which it was made.
    fn among_all(&self, number: Number<K>) -> Number<K> {
        number
    }
}

/// Any point, by its two free coordinates.
pub fn point<K: Real>(free: &mut dyn Free<K>, name: &str) -> Result<Point<K>, Unbuilt> {
    Ok(Number::complex(
        free.number(&format!("x of {name}"))?,
        free.number(&format!("y of {name}"))?,
    ))
}

/// Why a scene could not be built from what the source gave.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum Unbuilt {
    /// These parameters give no configuration of the kind that the scene is about; others may.
    #[error("{0}")]
    NotReal(String),
    /// The number kind does not hold a value that the scene needs.
    #[error("this arithmetic does not hold {0}")]
    NotHeld(String),
    /// The example in the data does not give a parameter.
    #[error("the example does not give `{0}`")]
    Missing(String),
    /// The example in the data gives something that is not what the scene asks for.
    #[error("`{0}` of the example {1}")]
    Unfit(String, String),
    /// A property that the scene relies on does not hold: the scene itself is wrong.
    #[error("the scene contradicts itself: {0}")]
    Contradiction(String),
}

impl Unbuilt {
    /// For a scene that needs more than sums, products and roots.
    pub fn no_functions() -> Self {
        Unbuilt::NotHeld("the elementary functions".to_owned())
    }

    /// Passes where a condition of the configuration holds, or cannot be told to fail.
    pub fn unless_real(condition: Truth, what: &str) -> Result<(), Unbuilt> {
        if condition.is_no() {
            Err(Unbuilt::NotReal(what.to_owned()))
        } else {
            Ok(())
        }
    }

    /// Passes where a property that follows from the construction holds, or cannot be told to fail.
    /// Floats, which round without saying so, cannot tell.
    pub fn unless_true<K: Kind>(property: Truth, what: &str) -> Result<(), Unbuilt> {
        if property.is_no() && !K::ROUNDS {
            Err(Unbuilt::Contradiction(what.to_owned()))
        } else {
            Ok(())
        }
    }
}

/// Parameters that stay free: every length is a positive variable, every angle a pair of variables
/// with c² + s² = 1, every root a variable with its relation.
pub struct Symbols {
    ring: Ring,
}

impl Default for Symbols {
    fn default() -> Self {
        Symbols {
            ring: Ring::empty(),
        }
    }
}

impl Symbols {
    /// Takes over an extended ring and gives its last variable.
    fn extend(&mut self, name: &str, ring: Option<Ring>) -> Result<Number<Fraction>, Unbuilt> {
        self.ring = ring.ok_or_else(|| Unbuilt::NotHeld(format!("{name} as one more symbol")))?;
        Ok(Number::variable(&self.ring, self.ring.len() - 1))
    }
}

impl Free<Fraction> for Symbols {
    fn precision(&self) {}

    fn length(&mut self, name: &str) -> Result<Number<Fraction>, Unbuilt> {
        self.extend(name, self.ring.with_positive(name))
    }

    fn number(&mut self, name: &str) -> Result<Number<Fraction>, Unbuilt> {
        self.extend(name, self.ring.with_variable(name))
    }

    fn angle(&mut self, name: &str) -> Result<Angle<Fraction>, Unbuilt> {
        let ring = self
            .ring
            .with_angle(&format!("cos {name}"), &format!("sin {name}"));
        let sin = self.extend(name, ring)?;
        let cos = Number::variable(&self.ring, self.ring.len() - 2);
        Ok(Angle::from_cos_sin(cos, sin))
    }

    fn slope(&mut self, name: &str) -> Result<Angle<Fraction>, Unbuilt> {
        let tan = self.number(&format!("tan {name}"))?;
        let length = self.root(&format!("1/cos {name}"), &(1 + tan.square()))?;
        Ok(Angle::of_known_length(
            Number::complex(Number::one(), tan),
            length,
        ))
    }

    fn root(
        &mut self,
        name: &str,
        radicand: &Number<Fraction>,
    ) -> Result<Number<Fraction>, Unbuilt> {
        let root = Fraction::adjoin_root_in(&self.ring, name, radicand);
        match (root.has_value(), root.0.ring()) {
            (true, ring) => {
                if let Some(ring) = ring.filter(|ring| ring.len() > self.ring.len()) {
                    self.ring = ring.clone();
                }
                Ok(root)
            }
            _ => Err(Unbuilt::NotHeld(format!("the square root that is {name}"))),
        }
    }

    fn among_all(&self, number: Number<Fraction>) -> Number<Fraction> {
        match self.ring.len() {
            0 => number,
            len => {
                let last = Number::variable(&self.ring, len - 1);
                number + &last - last
            }
        }
    }
}

/// Random exact parameters: quotients of primes, so that nothing cancels by coincidence.
pub struct Random {
    generator: ChaCha8Rng,
}

/// Primes without a pattern; enough that the parameters of one scene rarely share one.
const PRIMES: [u32; 64] = [
    101, 103, 107, 109, 113, 127, 131, 137, 139, 149, 151, 157, 163, 167, 173, 179, 181, 191, 193,
    197, 199, 211, 223, 227, 229, 233, 239, 241, 251, 257, 263, 269, 271, 277, 281, 283, 293, 307,
    311, 313, 317, 331, 337, 347, 349, 353, 359, 367, 373, 379, 383, 389, 397, 401, 409, 419, 421,
    431, 433, 439, 443, 449, 457, 461,
];

impl Random {
    /// The same seed gives the same parameters, always.
    pub fn new(seed: u64) -> Self {
        Random {
            generator: ChaCha8Rng::seed_from_u64(seed),
        }
    }

    fn below(&mut self, bound: u32) -> u32 {
        self.generator.next_u32() % bound
    }

    fn prime(&mut self) -> u32 {
        self.one_of(&PRIMES).unwrap_or(101)
    }

    fn one_of<T: Copy>(&mut self, list: &[T]) -> Option<T> {
        let place = self.below(u32::try_from(list.len()).ok()?);
        list.get(usize::try_from(place).ok()?).copied()
    }

    fn quotient(&mut self) -> Rational {
        let (numerator, mut denominator) = (self.prime(), self.prime());
        while denominator == numerator {
            denominator = self.prime();
        }
        // Sizes from a tenth to ten, so that long and short bars meet.
        let (up, down) = self.one_of(&[(1, 3), (1, 1), (3, 1)]).unwrap_or((1, 1));
        Rational::from((numerator * up, denominator * down))
    }

    fn signed(&mut self) -> Rational {
        let q = self.quotient();
        if self.below(2) == 0 { q } else { -q }
    }
}

impl<K: Real<Precision = ()>> Free<K> for Random {
    fn precision(&self) {}

    fn length(&mut self, _: &str) -> Result<Number<K>, Unbuilt> {
        Ok(self.quotient().into())
    }

    fn length_or(&mut self, name: &str, known: &Number<K>) -> Result<Number<K>, Unbuilt> {
        if self.below(3) == 0 {
            Ok(known.clone())
        } else {
            self.length(name)
        }
    }

    fn number(&mut self, _: &str) -> Result<Number<K>, Unbuilt> {
        Ok(self.signed().into())
    }

    fn angle(&mut self, _: &str) -> Result<Angle<K>, Unbuilt> {
        Ok(Angle::from_tan_half(&self.signed().into()))
    }
}

/// The parameters of a printed example, as formulas by name.
pub struct Given<'a, K: Real> {
    parameters: &'a BTreeMap<String, Formula>,
    precision: K::Precision,
}

impl<'a, K: Real> Given<'a, K> {
    /// Parameters by name, to be evaluated to this precision.
    pub fn new(parameters: &'a BTreeMap<String, Formula>, precision: K::Precision) -> Self {
        Given {
            parameters,
            precision,
        }
    }

    fn value(&self, name: &str) -> Result<Value<K>, Unbuilt> {
        let formula = self
            .parameters
            .get(name)
            .ok_or_else(|| Unbuilt::Missing(name.to_owned()))?;
        evaluate_expression(formula, &Bindings::new(self.precision.clone()))
            .map_err(|failure| Unbuilt::Unfit(name.to_owned(), failure.to_string()))
    }
}

impl<K: Real> Free<K> for Given<'_, K> {
    fn precision(&self) -> K::Precision {
        self.precision.clone()
    }

    fn length(&mut self, name: &str) -> Result<Number<K>, Unbuilt> {
        let length: Number<K> = self.number(name)?;
        if length.is_positive().is_no() {
            return Err(Unbuilt::Unfit(name.to_owned(), "is not positive".into()));
        }
        Ok(length)
    }

    fn part(&mut self, name: &str) -> Result<Number<K>, Unbuilt> {
        let part = self.length(name)?;
        if (1 - &part).is_positive().is_no() {
            return Err(Unbuilt::Unfit(name.to_owned(), "is not less than 1".into()));
        }
        Ok(part)
    }

    fn number(&mut self, name: &str) -> Result<Number<K>, Unbuilt> {
        match self.value(name)? {
            Value::Number(number) => Ok(number),
            other => Err(Unbuilt::Unfit(
                name.to_owned(),
                format!("is {}, not a number", other.kind_name()),
            )),
        }
    }

    fn angle(&mut self, name: &str) -> Result<Angle<K>, Unbuilt> {
        match self.value(name)? {
            turn @ (Value::Turn(_) | Value::Angle(_)) => turn
                .to_angle(&self.precision)
                .map(|angle| angle.normalized())
                .filter(Angle::has_value)
                .ok_or_else(|| Unbuilt::NotHeld(format!("the cosine of {name}"))),
            other => Err(Unbuilt::Unfit(
                name.to_owned(),
                format!("is {}, not an angle", other.kind_name()),
            )),
        }
    }

    fn position(&mut self, _: &str) -> Result<Angle<K>, Unbuilt> {
        let arbitrary = Number::rounded(&Rational::from((3, 7)), &self.precision);
        Ok(Angle::from_tan_half(&arbitrary))
    }
}
