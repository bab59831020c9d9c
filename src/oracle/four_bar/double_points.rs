//! The double points of the curve beside those of change points.

use std::cmp::Ordering;

use serde_json::{Map, Value, json};

use crate::linkage::coupler_curve::{CouplerCurve, Crossing};
use crate::number::univariate::{Polynomial, RealRoot, enclose, isolate, surds};
use crate::number::{Ball, Complex, Exact, Number, Surd};
use crate::oracle::numeral::{Numeral, Shown, together};
use crate::oracle::sharpen::Attempt;

/// A real double point by its κ.
struct Found {
    kappa: Number<Ball>,
    exactly: Option<Number<Surd>>,
    multiplicity: usize,
    /// Whether D passes it in one way only, where that is decided exactly.
    is_single: Option<bool>,
}

/// All roots of the cubic.
struct Roots {
    real: Vec<Found>,
    complex: Vec<(Number<Complex<Ball>>, usize)>,
}

impl Attempt {
    /// The real double points and the complex ones; null where D moves on a circle.
    pub fn double_points<K: Shown>(&mut self, curve: &CouplerCurve<K>) -> Map<String, Value> {
        let mut fields = Map::new();
        let [real, complex] = if curve.has_double_points().is_no() {
            [Value::Null, Value::Null]
        } else {
            self.finite_double_points(curve).unwrap_or_else(|| {
                let none = self.decided("double_points", None);
                [none.clone(), none]
            })
        };
        let eliminant = match real {
            Value::Null => Value::Null,
            _ => self.eliminant(&curve.cubic_of_double_points()),
        };
        fields.insert("eliminant".into(), eliminant);
        fields.insert("double_points".into(), real);
        fields.insert("complex_double_points".into(), complex);
        fields
    }

    /// The cubic, the highest coefficient first.
    fn eliminant<K: Shown>(&mut self, cubic: &Polynomial<K>) -> Value {
        let coefficients = [3, 2, 1, 0].map(|power| cubic.coefficient(power));
        self.coefficients("eliminant", &coefficients)
    }

    fn finite_double_points<K: Shown>(&mut self, curve: &CouplerCurve<K>) -> Option<[Value; 2]> {
        let exactly = exactly(curve);
        let bits = self.bits;
        let in_balls = curve.map(|x| K::numeral(x).ball(bits));
        let cubic = curve.cubic_of_double_points();
        let roots = match &exactly {
            Some(exactly) => Roots::exactly(exactly, bits)?,
            None => Roots::in_balls(&cubic.map(|x| K::numeral(x).ball(bits)), bits)?,
        };
        let mut real: Vec<Value> = Vec::new();
        for found in &roots.real {
            let of_rational = exactly.as_ref().zip(found.exactly.as_ref());
            let point = match of_rational {
                Some((curve, kappa)) => {
                    let curve = curve.map(|x| x.in_kind::<Surd>());
                    self.finite_point("double_points", &curve.double_point(kappa))
                }
                None => self.finite_point("double_points", &in_balls.double_point(&found.kappa)),
            };
            let sign = match found.is_single {
                Some(true) => Some(Ordering::Equal),
                _ => in_balls.discriminant().evaluate(&found.kappa).sign(),
            };
            let crossing = sign.and_then(|sign| curve.crossing(sign));
            real.push(self.double_point(point, crossing, found.multiplicity));
        }
        let at_pivot = 3usize.saturating_sub(cubic.degree()?);
        if at_pivot > 0 {
            let [pivot, _] = &curve.pivots;
            let point = self.finite_point("double_points", pivot);
            let sign = curve.discriminant_in_first_pivot().sign();
            real.push(self.double_point(
                point,
                sign.and_then(|sign| curve.crossing(sign)),
                at_pivot,
            ));
        }
        let nested = in_balls.map(|x| Number::<Complex<Ball>>::from(x.clone()));
        let mut complex: Vec<Value> = Vec::new();
        for (kappa, multiplicity) in &roots.complex {
            for kappa in [kappa.clone(), kappa.conj()] {
                let point = nested.double_point(&kappa);
                let point = self.complex_point([point.re(), point.im()]);
                complex.push(json!({"point": point, "multiplicity": multiplicity}));
            }
        }
        Some([json!(real), json!(complex)])
    }

    fn double_point(
        &mut self,
        point: Value,
        crossing: Option<Crossing>,
        multiplicity: usize,
    ) -> Value {
        let word = crossing.map(|crossing| {
            json!(match crossing {
                Crossing::Crossing => "crossing",
                Crossing::Cusp => "cusp",
                Crossing::ChangePoint => "change-point",
                Crossing::Isolated => "isolated",
            })
        });
        json!({
            "point": point,
            "kind": self.decided("double_points.kind", word),
            "multiplicity": multiplicity,
        })
    }

    fn complex_point(&mut self, [x, y]: [&Number<Complex<Ball>>; 2]) -> Value {
        let parts = [x.re(), x.im(), y.re(), y.im()].map(|part| Numeral::Enclosed(part.clone()));
        let shown = together(&parts, self.digits, self.bits);
        let point = shown.as_deref().and_then(|list| match list {
            [a, b, c, d] => Some(json!([{"re": a, "im": b}, {"re": c, "im": d}])),
            _ => None,
        });
        self.decided("complex_double_points", point)
    }
}

/// The same in rational numbers, where all are known to be.
fn exactly<K: Shown>(curve: &CouplerCurve<K>) -> Option<CouplerCurve<Exact>> {
    let exact = curve.map(|x| {
        let no_value = || Number::zero().inverse();
        K::numeral(x).rational().map_or_else(no_value, Number::from)
    });
    let points = exact.pivots.iter().chain(&exact.arms);
    let known = points.clone().all(Number::has_value) && exact.cranks.iter().all(Number::has_value);
    known.then_some(exact)
}

impl Roots {
    fn exactly(curve: &CouplerCurve<Exact>, bits: u32) -> Option<Self> {
        let cubic = curve.cubic_of_double_points();
        let roots = isolate(&cubic).ok()?;
        let single = curve.cubic_of_cusps()?;
        let list: Vec<&RealRoot> = roots.real().iter().collect();
        let exact = surds(&cubic, &list);
        let real = roots.real().iter().zip(exact).map(|(root, exactly)| Found {
            kappa: root.enclosure(bits),
            exactly,
            multiplicity: root.multiplicity(),
            is_single: Some(is_root(&single, root)),
        });
        let complex = roots.complex().iter();
        Some(Roots {
            real: real.collect(),
            complex: complex
                .map(|root| (root.enclosure(bits), root.multiplicity()))
                .collect(),
        })
    }

    fn in_balls(cubic: &Polynomial<Ball>, bits: u32) -> Option<Self> {
        let roots = enclose(cubic, bits)?;
        let real = roots.real.into_iter().map(|kappa| Found {
            kappa,
            exactly: None,
            multiplicity: 1,
            is_single: None,
        });
        Some(Roots {
            real: real.collect(),
            complex: roots.complex.into_iter().map(|kappa| (kappa, 1)).collect(),
        })
    }
}

/// Whether a root of a polynomial is one of its divisor, which has no other root in the interval.
fn is_root(divisor: &Polynomial<Exact>, root: &RealRoot) -> bool {
    match root.exact() {
        Some(q) => divisor.evaluate(&q.clone().into()).is_zero().is_yes(),
        None => divisor
            .sturm_sequence()
            .is_some_and(|sequence| sequence.count_between(root.low(), root.high()) > 0),
    }
}
