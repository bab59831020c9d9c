//! `slider-crank-alternates`: the two other Burmester points of a slider-crank.

use serde_json::{Map, Value, json};

use super::geometry::multiple_of_15_degrees;
use super::input::{self, Fields};
use super::sharpen::{Attempt, sharpen};
use super::{Arithmetic, ProblemError, Request, output};
use crate::curvature::slider_crank::{Alternates, Pair, Quotient, SliderCrank};
use crate::number::{Ball, Complex, Elementary, Number, Real, Surd, Truth};
use crate::plane::Angle;

/// The answer's numbers in their order.
const NUMBERS: [&str; 10] = [
    "PD", "PO_a", "PA", "N", "M", "R", "PB", "PC", "PO_b", "PO_c",
];

struct Problem {
    k: rug::Rational,
    alpha_a: input::Angle,
    alpha_d: input::Angle,
}

/// Reads and solves the problem.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    fields.only(&["k", "alpha_a", "alpha_d"])?;
    let problem = Problem {
        k: fields.number("k")?,
        alpha_a: fields.angle("alpha_a")?,
        alpha_d: fields.angle("alpha_d")?,
    };
    Ok(match request.arithmetic {
        Arithmetic::Float => problem.float(),
        Arithmetic::Certified => problem.certified(request.digits),
    })
}

impl Problem {
    fn linkage<K: Elementary>(&self, precision: &K::Precision) -> SliderCrank<K> {
        SliderCrank {
            k: Number::rounded(&self.k, precision),
            alpha_a: self.alpha_a.rounded(precision),
            alpha_d: self.alpha_d.rounded(precision),
        }
    }

    fn exact(&self) -> Option<SliderCrank<Surd>> {
        Some(SliderCrank {
            k: self.k.clone().into(),
            alpha_a: self.alpha_a.exact()?,
            alpha_d: self.alpha_d.exact()?,
        })
    }

    fn certified(&self, digits: u32) -> Map<String, Value> {
        let exact = self.exact().map(|linkage| Quantities::of(&linkage));
        sharpen(digits, |attempt| {
            let balls = Quantities::of(&self.linkage::<Ball>(&attempt.bits));
            Both {
                exact: exact.as_ref(),
                balls: &balls,
                attempt,
            }
            .answer()
        })
    }

    fn float(&self) -> Map<String, Value> {
        let quantities = Quantities::of(&self.linkage::<f64>(&()));
        let mut answer = Map::new();
        for (name, quotient) in &quantities.numbers {
            let value = quotient.as_ref().map_or(Value::Null, |quotient| {
                if quotient.is_undetermined().is_yes() {
                    undetermined()
                } else if quotient.denominator.0 == 0.0 {
                    json!({"infinite": true})
                } else {
                    output::float(quotient.value().0)
                }
            });
            answer.insert((*name).into(), value);
        }
        let degrees = |ray: &Angle<f64>| json!({"degrees": output::float(ray.sin().atan2(&ray.cos()).0.to_degrees())});
        let tangent = |tangent: &Number<Complex<f64>>| json!({"re": output::float(tangent.re().0), "im": output::float(tangent.im().0)});
        let rays = match &quantities.rays {
            Rays::Real(rays) => rays.each_ref().map(degrees),
            Rays::Complex(tangents) => tangents.each_ref().map(tangent),
            Rays::Undetermined => [undetermined(), undetermined()],
            Rays::Undecided => [Value::Null, Value::Null],
        };
        insert_rays(&mut answer, rays);
        answer
    }
}

fn insert_rays(answer: &mut Map<String, Value>, [b, c]: [Value; 2]) {
    answer.insert("alpha_b".into(), b);
    answer.insert("alpha_c".into(), c);
}

/// All quantities of the answer in one number kind.
struct Quantities<K> {
    /// `None` for those of complex points.
    numbers: Vec<(&'static str, Option<Quotient<K>>)>,
    rays: Rays<K>,
}

enum Rays<K> {
    Real([Angle<K>; 2]),
    Complex([Number<Complex<K>>; 2]),
    Undetermined,
    Undecided,
}

impl<K: Real> Quantities<K> {
    fn of(linkage: &SliderCrank<K>) -> Self {
        let (rays, [pb, pc, po_b, po_c]) = match linkage.alternates() {
            Alternates::Real(pairs) => {
                let [b, c] = *pairs;
                let (Pair { ray: ray_b, .. }, Pair { ray: ray_c, .. }) = (&b, &c);
                (
                    Rays::Real([ray_b.clone(), ray_c.clone()]),
                    [b.point, c.point, b.center, c.center].map(Some),
                )
            }
            Alternates::Complex(tangents) => (Rays::Complex(tangents), [None, None, None, None]),
            Alternates::Undetermined => {
                let none = || Quotient {
                    numerator: Number::zero(),
                    denominator: Number::zero(),
                };
                (Rays::Undetermined, std::array::from_fn(|_| Some(none())))
            }
            Alternates::Undecided => (Rays::Undecided, [None, None, None, None]),
        };
        let finite = |numerator| Quotient {
            numerator,
            denominator: Number::one(),
        };
        let values = [
            Some(finite(linkage.pd())),
            Some(finite(linkage.po_a())),
            Some(linkage.pa()),
            Some(linkage.n()),
            Some(linkage.m()),
            Some(linkage.r()),
            pb,
            pc,
            po_b,
            po_c,
        ];
        Quantities {
            numbers: NUMBERS.into_iter().zip(values).collect(),
            rays,
        }
    }
}

/// The quantities in exact numbers, as far as these hold them, and in balls.
struct Both<'a> {
    exact: Option<&'a Quantities<Surd>>,
    balls: &'a Quantities<Ball>,
    attempt: &'a mut Attempt,
}

impl Both<'_> {
    fn answer(&mut self) -> Map<String, Value> {
        let mut answer = Map::new();
        for (place, (name, ball)) in self.balls.numbers.iter().enumerate() {
            let exact = self
                .exact
                .and_then(|exact| exact.numbers.get(place)?.1.as_ref());
            let value = match (exact, ball) {
                (None, None) if self.are_complex() => Some(Value::Null),
                (exact, ball) => exact
                    .and_then(|quotient| self.exact_number(quotient))
                    .or_else(|| exactly_zero(exact?, ball.as_ref()?))
                    .or_else(|| self.number(ball.as_ref()?)),
            };
            answer.insert((*name).into(), self.attempt.decided(name, value));
        }
        let rays = [("alpha_b", 0), ("alpha_c", 1)].map(|(name, place)| {
            let ray = self.ray(place);
            self.attempt.decided(name, ray)
        });
        insert_rays(&mut answer, rays);
        answer
    }

    /// Whether B and C are known to be complex.
    fn are_complex(&self) -> bool {
        matches!(self.balls.rays, Rays::Complex(_))
            || self
                .exact
                .is_some_and(|exact| matches!(exact.rays, Rays::Complex(_)))
    }

    fn number(&self, quotient: &Quotient<Ball>) -> Option<Value> {
        if quotient.denominator.is_zero().is_yes() {
            return by_zero(quotient);
        }
        output::enclosure(&quotient.value(), self.attempt.digits)
    }

    fn exact_number(&self, quotient: &Quotient<Surd>) -> Option<Value> {
        if quotient.denominator.is_zero().is_yes() {
            return by_zero(quotient);
        }
        output::surd(&quotient.value(), self.attempt.digits, self.attempt.bits)
    }

    fn ray(&self, place: usize) -> Option<Value> {
        let exact = self
            .exact
            .and_then(|exact| self.exact_ray(&exact.rays, place));
        exact.or_else(|| match &self.balls.rays {
            Rays::Real(rays) => {
                let ray = rays.get(place)?;
                self.degrees(&ray.cos(), &ray.sin())
            }
            Rays::Complex(tangents) => {
                let tangent = tangents.get(place)?;
                Some(json!({
                    "re": output::enclosure(tangent.re(), self.attempt.digits)?,
                    "im": output::enclosure(tangent.im(), self.attempt.digits)?,
                }))
            }
            Rays::Undetermined => Some(undetermined()),
            Rays::Undecided => None,
        })
    }

    fn exact_ray(&self, rays: &Rays<Surd>, place: usize) -> Option<Value> {
        let Attempt { digits, bits, .. } = *self.attempt;
        match rays {
            Rays::Real(rays) => {
                let ray = rays.get(place)?;
                let known = multiple_of_15_degrees(0..=11, |angle| angle.equals_modulo_pi(ray));
                if let Some(degrees) = known {
                    return Some(json!({"degrees": output::exact(&degrees)}));
                }
                let [c, s] = [ray.cos(), ray.sin()];
                let held = c.has_value() && s.has_value();
                held.then(|| self.degrees(&c.0.enclosure(bits), &s.0.enclosure(bits)))?
            }
            Rays::Complex(tangents) => {
                let tangent = tangents.get(place)?;
                let [re, im] = [tangent.re(), tangent.im()]
                    .map(|part| part.has_value().then(|| output::surd(part, digits, bits))?);
                Some(json!({"re": re?, "im": im?}))
            }
            Rays::Undetermined => Some(undetermined()),
            Rays::Undecided => None,
        }
    }

    /// The angle of a direction in the upper half plane.
    fn degrees(&self, c: &Number<Ball>, s: &Number<Ball>) -> Option<Value> {
        let bits = self.attempt.bits;
        let degrees = if c.is_zero().is_yes() {
            output::exact(&90.into())
        } else {
            // Exact numbers alone have no precision.
            let [c, s] = [c, s].map(|part| Number(part.0.with_precision(bits)));
            let radians: Number<Ball> = s.atan2(&c);
            output::enclosure(&(radians * 180 / Number::pi(&bits)), self.attempt.digits)?
        };
        Some(json!({"degrees": degrees}))
    }
}

/// A quotient whose denominator is zero.
fn by_zero<K: Real>(quotient: &Quotient<K>) -> Option<Value> {
    match quotient.numerator.is_zero() {
        Truth::Yes => Some(undetermined()),
        Truth::No => Some(infinite()),
        Truth::Unknown => None,
    }
}

/// A quotient of which exact numbers know that the numerator is zero, and enclosures that the
/// denominator is not.
fn exactly_zero(exact: &Quotient<Surd>, ball: &Quotient<Ball>) -> Option<Value> {
    let is_zero = exact.numerator.is_zero().is_yes() && ball.denominator.is_zero().is_no();
    is_zero.then(|| output::exact(&0.into()))
}

fn undetermined() -> Value {
    json!({"undetermined": true})
}

fn infinite() -> Value {
    json!({"infinite": true})
}
