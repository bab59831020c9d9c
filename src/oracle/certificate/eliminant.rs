//! Polynomials with primitive integers, by their roots.

use rug::{Integer, Rational};
use serde_json::Value;

use super::{Defect, require};
use crate::number::exact::primitive;
use crate::number::{Ball, Complex, Number};

type Entry = Number<Complex<Ball>>;

/// Primitive integers, the first positive.
pub fn integers(shown: &Value, place: &str) -> Result<Vec<Integer>, Defect> {
    let list = shown.as_array();
    let list =
        list.ok_or_else(|| Defect::unchecked(format!("the answer leaves {place} undecided")))?;
    let integers: Option<Vec<Integer>> = list
        .iter()
        .map(|value| value.as_str()?.parse::<Integer>().ok())
        .collect();
    let integers = integers.ok_or_else(|| Defect::wrong(place, "integers were expected"))?;
    let rationals: Vec<Rational> = integers.iter().map(Rational::from).collect();
    require(
        primitive(&rationals) == integers,
        place,
        "primitive integers were expected, the first positive",
    )?;
    Ok(integers)
}

/// Whether these are, the highest power first, the product of z + x over all roots x, each so often.
pub fn is_of_roots(shown: &Value, place: &str, roots: &[(&Entry, usize)]) -> Result<(), Defect> {
    let integers = integers(shown, place)?;
    let degree: usize = roots.iter().map(|(_, times)| times).sum();
    require(
        integers.len() == degree + 1,
        place,
        "its degree is not the number of finite pairs",
    )?;
    let one: Entry = Number::one();
    let mut product = vec![one];
    for (x, times) in roots {
        for _ in 0..*times {
            product = times_linear(&product, x);
        }
    }
    let leading = integers.first().cloned().unwrap_or_default();
    let right = product.iter().zip(&integers).all(|(own, integer)| {
        let quotient = Rational::from((integer, &leading));
        own.re().0.contains(&quotient) && own.im().0.contains(&Rational::new())
    });
    require(right, place, "it does not belong to the pairs")
}

/// Times z + x, the highest power first.
fn times_linear(polynomial: &[Entry], x: &Entry) -> Vec<Entry> {
    let mut product: Vec<Entry> = polynomial.to_vec();
    product.push(Number::zero());
    for (entry, lower) in product.iter_mut().skip(1).zip(polynomial) {
        *entry += lower * x;
    }
    product
}
