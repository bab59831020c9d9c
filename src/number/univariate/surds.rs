//! Roots that are sums of square roots.

use rug::{Integer, Rational};

use super::{Polynomial, RealRoot};
use crate::number::exact::{bits, primitive};
use crate::number::{Ball, Exact, Number, Surd};

/// The real roots of a polynomial that are rational or roots of a quadratic factor over ℚ, exactly;
/// `None` for the others. The roots are some of those of the polynomial.
#[expect(clippy::indexing_slicing, reason = "there is an entry for every root")]
pub fn surds(polynomial: &Polynomial<Exact>, roots: &[&RealRoot]) -> Vec<Option<Number<Surd>>> {
    let mut list: Vec<Option<Number<Surd>>> = roots
        .iter()
        .map(|root| root.rational().map(Number::from))
        .collect();
    for low in 0..roots.len() {
        for high in low + 1..roots.len() {
            if list[low].is_some() || list[high].is_some() {
                continue;
            }
            if let Some([first, second]) = quadratic(polynomial, [roots[low], roots[high]]) {
                list[low] = Some(first);
                list[high] = Some(second);
            }
        }
    }
    list
}

/// Both roots, the lesser first, where they are those of one quadratic factor.
fn quadratic(polynomial: &Polynomial<Exact>, roots: [&RealRoot; 2]) -> Option<[Number<Surd>; 2]> {
    let coefficients: Option<Vec<Rational>> = polynomial
        .coefficients()
        .iter()
        .map(|c| c.0.rational().cloned())
        .collect();
    let integers = primitive(&coefficients?);
    let leading = integers.last()?;
    // By Gauss's lemma the factor is integral with a leading coefficient that divides this one, so that
    // these are integers; each root is at most 1 + the ratio of the largest coefficient to the leading.
    let largest = integers.iter().map(|c| bits(&Rational::from(c))).max()?;
    let needed = 4 * largest + 64;
    let [x, y] = roots.map(|root| root.enclosure(needed));
    let scale = Number::<Ball>::from(Rational::from(leading));
    let sum = integer(&(&scale * (&x + &y)))?;
    let product = integer(&(scale * x * y))?;
    let factor =
        Polynomial::from_rationals([&product, &Integer::from(-&sum), leading].map(Rational::from));
    let (_, rest) = polynomial.divide(&factor)?;
    if !rest.is_zero() {
        return None;
    }
    let discriminant = Integer::from(sum.square_ref()) - Integer::from(4 * &product) * leading;
    let root = Number::<Surd>::from(Rational::from(discriminant)).sqrt();
    let [sum, divisor] =
        [sum, Integer::from(2 * leading)].map(|n| Number::<Surd>::from(Rational::from(n)));
    let mut both = [(&sum - &root) / &divisor, (sum + root) / divisor];
    if both[0].compare(&both[1])?.is_gt() {
        both.reverse();
    }
    Some(both)
}

/// The integer in a ball that holds one at most.
fn integer(ball: &Number<Ball>) -> Option<Integer> {
    let nearest = Integer::from(ball.0.midpoint_rational()?.round_ref());
    let narrow = ball.0.radius_rational()? < Rational::from((1, 4));
    (narrow && ball.0.contains(&Rational::from(&nearest))).then_some(nearest)
}

#[cfg(test)]
mod tests {
    use super::super::real_roots;
    use super::*;

    fn exact(coefficients: &[i64]) -> Vec<Option<String>> {
        let polynomial = Polynomial::from_integers(coefficients);
        let roots = real_roots(std::slice::from_ref(&polynomial)).unwrap();
        let roots: Vec<&RealRoot> = roots.iter().map(|(root, _)| root).collect();
        let list = surds(&polynomial, &roots).into_iter();
        list.map(|root| root.map(|root| format!("{:?}", root.0.terms().unwrap())))
            .collect()
    }

    #[test]
    fn roots_of_quadratic_factors_are_found() {
        // (x² − 2)(x² − 4x + 1) and (x − 1)(x² − x − 1).
        let all = exact(&[-2, 8, -1, -4, 1]);
        assert_eq!(all.len(), 4);
        assert!(all.iter().all(Option::is_some), "{all:?}");
        assert!(exact(&[1, 0, -2, 1]).iter().all(Option::is_some));
        // 3x² − 5x + 1 with a factor.
        assert!(exact(&[7, -35, 21]).iter().all(Option::is_some));
    }

    #[test]
    fn others_are_not() {
        // x³ − 3x + 1 and x⁴ − 10x² + 1, the latter with roots ±√2 ± √3 and no quadratic factor.
        assert!(exact(&[1, -3, 0, 1]).iter().all(Option::is_none));
        assert!(exact(&[1, 0, -10, 0, 1]).iter().all(Option::is_none));
    }
}
