//! A pair in machine floats, and with how many places it is to be known.

use rug::Integer;

use super::super::conditions::Coordinates;
use super::newton::Newton;
use crate::number::gaussian::Gaussian;
use crate::number::{Complex, Number};

/// Bits of machine floats.
const FLOAT_BITS: u32 = 53;
/// Bits that they are trusted with at first; nothing rests on it.
const KNOWN_BITS: u32 = 40;
/// Bits that a step of Newton's method may fall behind twice as many.
const LAG: u32 = 6;
/// Bits that a step gains with derivatives in machine floats.
const FLOAT_STEP: u32 = 40;
/// Bits for the radius.
const SPARE_BITS: i64 = 14;
/// What is smaller than its like by so many powers of two may be zero.
const NEGLIGIBLE: i64 = 40;
/// At least.
const FEWEST_PLACES: u32 = 16;

type Floats = Number<Complex<f64>>;

/// Circlepoint and center by floats.
pub struct Near {
    /// Whether all coordinates are real.
    pub is_real: bool,
    /// The pair is wanted in units of 2^−places.
    pub places: u32,
    point: [Floats; 2],
    /// Above the exponents of all coordinates.
    size: i64,
}

impl Near {
    /// `None` at infinity and where a coordinate may be zero.
    pub fn new([h, x, y, cx, cy, p, q]: &Coordinates<Complex<f64>>, bits: u32) -> Option<Self> {
        let own = [x, y, cx, cy].map(|z| z / h);
        let products = [p, q].map(|z| z / h);
        let is_real = own.iter().all(|z| z.im().0 == 0.0);
        let exponents = |list: &[Floats]| -> Option<[i64; 2]> {
            let parts = list.iter().flat_map(|z| [z.re().0, z.im().0]);
            let parts = parts
                .enumerate()
                .filter(|(place, _)| !is_real || place % 2 == 0);
            let exponents: Vec<i64> = parts.map(|(_, x)| exponent(x)).collect::<Option<_>>()?;
            let [least, most] = [*exponents.iter().min()?, *exponents.iter().max()?];
            (most - least < NEGLIGIBLE).then_some([least, most])
        };
        let [least, size] = exponents(&own)?;
        let [least_product, _] = exponents(&products)?;
        // The radius of a product is that of a factor times the sum of all coordinates.
        let finest = least.min(least_product - size - 2);
        let places = i64::from(bits) + SPARE_BITS - finest;
        let places = u32::try_from(places).ok()?.max(FEWEST_PLACES);
        let [x, y, ..] = own;
        Some(Near {
            is_real,
            places,
            point: [x, y],
            size: size + 1,
        })
    }

    /// x and y by Newton's method.
    pub fn refined(&self, newton: &mut Newton) -> Option<[Gaussian; 2]> {
        let ladder = self.ladder()?;
        let mut places = self.places_of(FLOAT_BITS)?.min(*ladder.first()?);
        let [x, y] = &self.point;
        let mut point = [rounded(x, places)?, rounded(y, places)?];
        for next in ladder {
            let finer = next.checked_sub(places)?;
            if finer <= FLOAT_STEP {
                newton.short_step(&mut point, places, finer)?;
            } else {
                newton.step(&mut point, places, finer)?;
            }
            places = next;
        }
        Some(point)
    }

    /// The places after each step.
    fn ladder(&self) -> Option<Vec<u32>> {
        let mut bits = u32::try_from(i64::from(self.places) + self.size).ok()?;
        let mut steps = vec![self.places];
        loop {
            bits = if bits > 3 * FLOAT_STEP {
                bits / 2 + LAG
            } else {
                bits.saturating_sub(FLOAT_STEP)
            };
            if bits <= KNOWN_BITS {
                steps.reverse();
                return Some(steps);
            }
            steps.push(self.places_of(bits)?);
        }
    }

    /// For so many bits of the largest coordinate.
    fn places_of(&self, bits: u32) -> Option<u32> {
        u32::try_from((i64::from(bits) - self.size).max(0)).ok()
    }
}

/// An e with 2^e ≤ |x| < 2^(e + 1); `None` for zero, for what is not finite, and near either.
fn exponent(x: f64) -> Option<i64> {
    let exponent = x.abs().to_bits() >> 52;
    let exponent = i64::try_from(exponent).ok()? - 1023;
    (exponent.abs() < 1000).then_some(exponent)
}

/// In units of 2^−places.
fn rounded(z: &Floats, places: u32) -> Option<Gaussian> {
    let unit = 2f64.powi(i32::try_from(places).ok()?);
    let [re, im] = [z.re(), z.im()].map(|part| Integer::from_f64(part.0 * unit));
    Some(Gaussian { re: re?, im: im? })
}
