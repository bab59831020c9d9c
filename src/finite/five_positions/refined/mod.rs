//! All pairs of rational positions from machine floats on: Newton's method, then a proof for each.
//!
//! A pair that is proven is simple. Four simple pairs, conjugate ones among them, are all that there are:
//! two conics have no more meets, and where they have a part in common only one that is simple.

mod conditions;
mod near;
mod newton;
mod proof;

use rug::{Integer, Rational};

use self::conditions::{Forms, rows};
use self::near::Near;
use self::newton::Newton;
use self::proof::{Judge, Reached};
use super::certified::Certified;
use super::conditions::Coordinates;
use super::conics::{Pair, Place};
use super::floats;
use crate::number::gaussian::Gaussian;
use crate::number::{Ball, Complex, Exact, Kind, Number};
use crate::plane::displacement::Displacement;

/// Bits of the forms beyond those of the pairs.
const FORM_BITS: u32 = 64;
/// How often a pair is tried to prove, with a step between.
const ATTEMPTS: usize = 4;

/// Four simple finite pairs, each with so many bits; `None` where that is not what is found.
pub fn pairs(positions: &[Displacement<Exact>; 5], bits: u32) -> Option<Certified> {
    let near = floats::pairs(&positions.each_ref().map(|position| position.map(float)))?;
    let near = near.iter().map(|pair| Near::new(pair, bits));
    let near: Vec<Near> = near.collect::<Option<_>>()?;
    let rows = rows(positions)?;
    let places = near.iter().map(|near| near.places).max()?;
    let mut newton = Newton::new(&Forms::new(&rows)?, places.checked_add(FORM_BITS)?);
    let mut judge = Judge::new(&rows);
    let mut found = Certified {
        real: Vec::new(),
        complex: Vec::new(),
    };
    for near in near {
        let point = near.refined(&mut newton)?;
        let proven = Proven::new(point, near.places, &mut newton, &mut judge)?;
        if near.is_real {
            found.real.push(proven.real());
        } else {
            found.complex.push(proven.complex());
        }
    }
    let four = found.real.len() + 2 * found.complex.len() == 4;
    (four && are_apart(&found)).then_some(found)
}

/// Nothing rests on it.
fn float(x: &Number<Exact>) -> Number<f64> {
    let float = |q: &Rational| q.numer().to_f64() / q.denom().to_f64();
    Number(x.0.rational().map_or(f64::NAN, float))
}

/// One pair, and no other, by x, y, X, Y, p, q.
struct Proven {
    coordinates: [Reached; 6],
    places: u32,
}

impl Proven {
    fn new(
        mut point: [Gaussian; 2],
        places: u32,
        newton: &mut Newton,
        judge: &mut Judge<'_>,
    ) -> Option<Self> {
        for _ in 0..ATTEMPTS {
            let [x, y] = &point;
            let [u, v] = newton.center([x, y], places)?;
            let at = [x.clone(), y.clone(), u, v];
            if let Some(coordinates) = judge.proven(at, places) {
                return Some(Proven {
                    coordinates,
                    places,
                });
            }
            newton.step(&mut point, places, 0)?;
        }
        None
    }

    fn real(&self) -> Pair<Ball> {
        self.pair(|at| self.ball(&at.z.re, at.reach))
    }

    fn complex(&self) -> Pair<Complex<Ball>> {
        self.pair(|at| {
            let [re, im] = [&at.z.re, &at.z.im].map(|part| self.ball(part, at.reach));
            Number::complex(re, im)
        })
    }

    fn ball(&self, part: &Integer, reach: i64) -> Number<Ball> {
        let unit = -i64::from(self.places);
        Number(Ball::scaled(part, unit, reach + unit))
    }

    fn pair<K: Kind>(&self, number: impl Fn(&Reached) -> Number<K>) -> Pair<K> {
        let [x, y, u, v, p, q] = self.coordinates.each_ref().map(number);
        Pair {
            coordinates: [Number::one(), x, y, u, v, p, q],
            place: Place::Finite,
            multiplicity: 1,
        }
    }
}

/// Whether all are different, and those that are not real surely not.
fn are_apart(found: &Certified) -> bool {
    let complex = || found.complex.iter().map(|pair| &pair.coordinates);
    let never_real = complex().all(|pair| pair.iter().any(|z| z.im().is_zero().is_no()));
    let conjugate = |pair: &Coordinates<Complex<Ball>>| pair.each_ref().map(|z| z.conj());
    never_real
        && every_two(&found.real, |a, b| differ(&a.coordinates, &b.coordinates))
        && every_two(&found.complex, |a, b| {
            let [a, b] = [a, b].map(|pair| &pair.coordinates);
            differ(a, b) && differ(a, &conjugate(b))
        })
}

fn differ<K: Kind>(a: &Coordinates<K>, b: &Coordinates<K>) -> bool {
    a.iter().zip(b).any(|(a, b)| a.equals(b).is_no())
}

fn every_two<T>(list: &[T], holds: impl Fn(&T, &T) -> bool) -> bool {
    let mut places = list.iter().enumerate();
    places.all(|(place, a)| list.iter().skip(place + 1).all(|b| holds(a, b)))
}
