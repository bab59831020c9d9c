//! [`Radical`]: functions on the curve s² = S(t), a number kind.
//!
//! The field ℚ(t, √S) with its two values for every t. What is computed in it holds on both sheets of
//! the curve at once, and where a function vanishes on either of them is decided by one polynomial,
//! its norm.

use std::fmt;
use std::sync::Arc;

use rug::Rational;

use super::Polynomial;
use crate::number::{Exact, Kind, Number, Truth};

type P = Polynomial<Exact>;

/// (a + b s)/c with s² = S(t) and polynomials a, b, c in t without a common divisor; or no value. S
/// must not be a square.
#[derive(Clone)]
pub struct Radical {
    value: Option<Value>,
    /// S; constants have none.
    radicand: Option<Arc<P>>,
}

#[derive(Clone)]
struct Value {
    a: P,
    b: P,
    c: P,
}

impl Radical {
    /// t and s as functions on the curve s² = S(t).
    pub fn coordinates(radicand: &P) -> [Number<Radical>; 2] {
        let radicand = Arc::new(radicand.clone());
        let (zero, one, t) = (P::zero(), P::from_integers(&[1]), P::variable());
        [(t, zero.clone()), (zero, one.clone())].map(|(a, b)| {
            Number(Radical {
                value: Some(Value {
                    a,
                    b,
                    c: one.clone(),
                }),
                radicand: Some(radicand.clone()),
            })
        })
    }

    /// The numerator of a² − S b², the product of the values on both sheets: it vanishes where the
    /// function does on one of them. `None` where there is no value.
    pub fn norm(&self) -> Option<P> {
        let Value { a, b, .. } = self.value.as_ref()?;
        match &self.radicand {
            Some(radicand) if !b.is_zero() => Some(a * a - &**radicand * &(b * b)),
            _ => Some(a.clone()),
        }
    }

    /// Combines two values; the radicand is that of either.
    fn combine(&mut self, other: &Self, operate: impl FnOnce(&Value, &Value, &P) -> Option<Value>) {
        if self.radicand.is_none() {
            self.radicand.clone_from(&other.radicand);
        }
        let none = P::zero();
        let radicand = self.radicand.as_deref().unwrap_or(&none);
        self.value = match (&self.value, &other.value) {
            (Some(x), Some(y)) => operate(x, y, radicand).and_then(Value::reduced),
            _ => None,
        };
    }
}

impl Value {
    /// Without common divisors, the denominator primitive.
    fn reduced(self) -> Option<Self> {
        let Value { a, b, c } = self;
        let common = c.gcd(&a)?.gcd(&b)?;
        let [a, b, c] = if common.degree() == Some(0) {
            [a, b, c]
        } else {
            let quotient = |p: &P| Some(p.divide(&common)?.0);
            [quotient(&a)?, quotient(&b)?, quotient(&c)?]
        };
        let scale = Number::from(c.content()?).inverse();
        let [a, b, c] = [a, b, c].map(|p| p.scaled(&scale));
        Some(Value { a, b, c })
    }

    fn plus(&self, other: &Self, minus: bool) -> Value {
        let (a, b) = if minus {
            (-&other.a, -&other.b)
        } else {
            (other.a.clone(), other.b.clone())
        };
        Value {
            a: &self.a * &other.c + a * &self.c,
            b: &self.b * &other.c + b * &self.c,
            c: &self.c * &other.c,
        }
    }

    fn times(&self, other: &Self, radicand: &P) -> Value {
        Value {
            a: &self.a * &other.a + radicand * &(&self.b * &other.b),
            b: &self.a * &other.b + &self.b * &other.a,
            c: &self.c * &other.c,
        }
    }

    /// c (a − b s)/(a² − S b²); `None` for zero.
    fn inverse(&self, radicand: &P) -> Option<Value> {
        let norm = &self.a * &self.a - radicand * &(&self.b * &self.b);
        (!norm.is_zero()).then(|| Value {
            a: &self.c * &self.a,
            b: -(&self.c * &self.b),
            c: norm,
        })
    }
}

impl Kind for Radical {
    const GENERIC: bool = true;

    fn constant(q: Rational) -> Self {
        Radical {
            value: Some(Value {
                a: P::constant(q.into()),
                b: P::zero(),
                c: P::from_integers(&[1]),
            }),
            radicand: None,
        }
    }

    fn add(&mut self, other: &Self) {
        self.combine(other, |x, y, _| Some(x.plus(y, false)));
    }

    fn sub(&mut self, other: &Self) {
        self.combine(other, |x, y, _| Some(x.plus(y, true)));
    }

    fn mul(&mut self, other: &Self) {
        self.combine(other, |x, y, radicand| Some(x.times(y, radicand)));
    }

    fn div(&mut self, other: &Self) {
        self.combine(other, |x, y, radicand| {
            Some(x.times(&y.inverse(radicand)?, radicand))
        });
    }

    fn negate(&mut self) {
        if let Some(value) = &mut self.value {
            value.a = -&value.a;
            value.b = -&value.b;
        }
    }

    fn is_zero(&self) -> Truth {
        self.value.as_ref().map_or(Truth::Unknown, |value| {
            (value.a.is_zero() && value.b.is_zero()).into()
        })
    }

    fn has_value(&self) -> bool {
        self.value.is_some()
    }
}

impl fmt::Debug for Radical {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.value {
            Some(Value { a, b, c }) => write!(f, "({a} + ({b}) s)/({c})"),
            None => f.write_str("no value"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_a_field_with_the_root_of_its_radicand() {
        let radicand = P::from_integers(&[3, 0, -1, 0, 2]);
        let [t, s] = Radical::coordinates(&radicand);
        assert!(
            s.square()
                .equals(&(2 * t.power(4) - t.square() + 3))
                .is_yes()
        );
        let x = (&t * &s + 1) / (&s - &t);
        assert!((&x * (&s - &t)).equals(&(&t * &s + 1)).is_yes());
        assert!((&x / &x).equals(&Number::one()).is_yes());
        assert!((&x - &x).is_zero().is_yes());
        assert!(!(Number::<Radical>::one() / (&x - &x)).has_value());
    }

    #[test]
    fn the_norm_vanishes_where_the_function_does_on_a_sheet() {
        // s = t − 1 on s² = t² + 3: at t = −1, where s is −2, the negative root.
        let [t, s] = Radical::coordinates(&P::from_integers(&[3, 0, 1]));
        let norm = (s - t + 1).0.norm().unwrap();
        assert_eq!(
            norm.sign_at(&Rational::from(-1)).unwrap(),
            std::cmp::Ordering::Equal
        );
        assert_eq!(norm.degree(), Some(1));
    }
}
