//! How far a given part lies from the certified one, without rounding either.

use rug::float::Round;
use rug::{Float, Rational};

use super::number::Known;
use super::read::{Member, Part};

/// The relative error of a given part, none where the two cannot be the same thing. Points are
/// measured by their largest coordinate, angles by a radian at least, numbers up to a factor by the
/// largest of them; what is zero by `scale`, the size of what it belongs to.
pub fn error(certified: &Part, given: &Part, scale: &Rational) -> Option<Rational> {
    match (certified, given) {
        (Part::Numbers(certified), Part::Numbers(given)) => {
            let own = largest(certified);
            let size = if own.is_zero() { scale } else { &own };
            farthest(certified, given.iter().map(|known| known.value.clone()))
                .map(|distance| distance / size)
        }
        (Part::Ratio(certified), Part::Ratio(given)) if largest(certified).is_zero() => {
            // An equation that every point satisfies.
            farthest(certified, given.iter().map(|known| known.value.clone()))
                .map(|distance| distance / scale)
        }
        (Part::Ratio(certified), Part::Ratio(given)) => of_ratio(certified, given),
        (Part::Degrees(certified), Part::Degrees(given)) => {
            let difference = difference_of_angles(&certified.value, &given.value);
            let distance = difference.abs() + &certified.radius;
            let size = certified.value.clone().abs().max(radian());
            Some(distance / size)
        }
        (Part::Word(certified), Part::Word(given)) => (certified == given).then(Rational::new),
        _ => None,
    }
}

/// The largest relative error of the parts that both state; none where they share no part or one of
/// them differs.
pub fn member_error(certified: &Member, given: &Member, scale: &Rational) -> Option<Rational> {
    let sizes = certified.parts.iter().map(|(_, part)| size(part));
    let own = sizes.fold(Rational::new(), Rational::max);
    let scale = if own.is_zero() { scale } else { &own };
    let mut worst = None;
    let telling = given.parts.iter().filter(|(_, part)| !part.is_remark());
    for (name, part) in telling {
        if let Some((_, right)) = certified.parts.iter().find(|(other, _)| other == name) {
            let error = error(right, part, scale)?;
            worst = Some(worst.map_or(error.clone(), |worst: Rational| worst.max(error)));
        }
    }
    worst
}

/// The largest number of a part.
pub fn size(part: &Part) -> Rational {
    match part {
        Part::Numbers(numbers) => largest(numbers),
        _ => Rational::new(),
    }
}

/// How close what is given comes to what is certified.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closeness {
    /// The relative error; points are measured by their largest coordinate.
    pub relative: f64,
    /// Units in the last place of a double: of all numbers, each in its own units, the worst. Correctly
    /// rounded is 0.5 at most.
    pub ulps: f64,
}

impl Closeness {
    /// Correct digits.
    pub fn digits(&self) -> f64 {
        digits(self.relative)
    }

    /// The error of a part.
    pub fn of_part(relative: &Rational, certified: &Part, given: &Part) -> Self {
        Closeness {
            relative: relative.to_f64(),
            ulps: ulps(certified, given),
        }
    }

    /// The error of the parts that both state.
    pub fn of_member(relative: &Rational, certified: &Member, given: &Member) -> Self {
        let worst = given.parts.iter().filter_map(|(name, part)| {
            let (_, right) = certified.parts.iter().find(|(other, _)| other == name)?;
            Some(ulps(right, part))
        });
        Closeness {
            relative: relative.to_f64(),
            ulps: worst.fold(0.0, f64::max),
        }
    }
}

/// Correct digits at this relative error: at most 50, those of the certified answers.
pub fn digits(relative: f64) -> f64 {
    const MOST: f64 = 50.0;
    if relative == 0.0 {
        return MOST;
    }
    (-relative.log10()).clamp(0.0, MOST)
}

fn ulps(certified: &Part, given: &Part) -> f64 {
    let pairs: Vec<(Rational, Rational)> = match (certified, given) {
        (Part::Numbers(certified), Part::Numbers(given)) => {
            let values = certified.iter().zip(given);
            values
                .map(|(x, y)| (x.value.clone(), y.value.clone()))
                .collect()
        }
        (Part::Ratio(certified), Part::Ratio(given)) => scaled(certified, given)
            .map(|scaled| {
                let values = certified.iter().zip(scaled);
                values.map(|(x, y)| (x.value.clone(), y)).collect()
            })
            .unwrap_or_default(),
        (Part::Degrees(certified), Part::Degrees(given)) => {
            let value = certified.value.clone();
            let near = &value + difference_of_angles(&given.value, &value);
            vec![(value, near)]
        }
        _ => Vec::new(),
    };
    let unit = |x: &Rational| Rational::from(1) << (exponent(x).max(-1022) - 52);
    let errors = pairs
        .into_iter()
        .map(|(x, y)| ((&x - y).abs() / unit(&x)).to_f64());
    errors.fold(0.0, f64::max)
}

/// e with 2^e ≤ |x| < 2^(e + 1); the least one of doubles for zero.
fn exponent(x: &Rational) -> i32 {
    let float = Float::with_val_round(53, x, Round::Zero).0;
    float.get_exp().map_or(-1022, |exponent| exponent - 1)
}

/// From the second to the first, by half a turn at most.
fn difference_of_angles(x: &Rational, y: &Rational) -> Rational {
    let turn = Rational::from(360);
    let difference = Rational::from(x - y);
    let turns = Rational::from(&difference / &turn).round();
    difference - turns * turn
}

fn radian() -> Rational {
    Rational::from((180 * 113, 355))
}

fn largest(numbers: &[Known]) -> Rational {
    let sizes = numbers.iter().map(|known| known.value.clone().abs());
    sizes.fold(Rational::new(), Rational::max)
}

/// The largest difference, radii included.
fn farthest(
    certified: &[Known],
    given: impl ExactSizeIterator<Item = Rational>,
) -> Option<Rational> {
    if certified.len() != given.len() {
        return None;
    }
    let differences = certified
        .iter()
        .zip(given)
        .map(|(known, given)| (given - &known.value).abs() + &known.radius);
    Some(differences.fold(Rational::new(), Rational::max))
}

/// By how much two lists of numbers differ that are known up to a factor.
fn of_ratio(certified: &[Known], given: &[Known]) -> Option<Rational> {
    let distance = farthest(certified, scaled(certified, given)?.into_iter())?;
    Some(distance / largest(certified))
}

/// The second, scaled so that the largest certified number is the same.
fn scaled(certified: &[Known], given: &[Known]) -> Option<Vec<Rational>> {
    let place = (0..certified.len()).max_by(|&i, &j| {
        let size = |k: usize| certified.get(k).map(|known| known.value.clone().abs());
        size(i).cmp(&size(j))
    })?;
    let (leading, other) = (&certified.get(place)?.value, &given.get(place)?.value);
    if leading.is_zero() || other.is_zero() {
        return None;
    }
    let factor = Rational::from(leading / other);
    let scaled = given.iter().map(|known| (&known.value * &factor).into());
    Some(scaled.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(value: i64, unit: u64) -> Known {
        Known {
            value: Rational::from((value, unit)),
            radius: Rational::new(),
        }
    }

    fn one() -> Rational {
        Rational::from(1)
    }

    #[test]
    fn points_are_measured_by_their_largest_coordinate() {
        let right = Part::Numbers(vec![known(1, 1000), known(100, 1)]);
        let given = Part::Numbers(vec![known(2, 1000), known(100, 1)]);
        assert_eq!(error(&right, &given, &one()), Some((1, 100_000).into()));
        let origin = Part::Numbers(vec![known(0, 1), known(0, 1)]);
        let near = Part::Numbers(vec![known(1, 1000), known(0, 1)]);
        assert_eq!(error(&origin, &near, &10.into()), Some((1, 10_000).into()));
    }

    #[test]
    fn a_factor_does_not_matter_where_it_is_free() {
        let right = Part::Ratio(vec![known(3, 1), known(-4, 1)]);
        for (x, y, expected) in [
            (-6, 8, Some(Rational::new())),
            (3, -5, Some((3, 20).into())),
            (1, 0, None),
        ] {
            let given = Part::Ratio(vec![known(x, 1), known(y, 1)]);
            assert_eq!(error(&right, &given, &one()), expected, "{x}, {y}");
        }
        let nothing = Part::Ratio(vec![known(0, 1), known(0, 1)]);
        assert_eq!(error(&nothing, &nothing, &one()), Some(Rational::new()));
        assert_eq!(error(&right, &nothing, &one()), None);
        assert_eq!(error(&nothing, &right, &one()), Some(4.into()));
        let numbers = Part::Numbers(vec![known(3, 1), known(-4, 1)]);
        assert_eq!(error(&right, &numbers, &one()), None);
    }

    #[test]
    fn angles_are_taken_modulo_a_turn() {
        let right = Part::Degrees(known(-180, 1));
        let given = Part::Degrees(known(540, 1));
        assert_eq!(error(&right, &given, &one()), Some(Rational::new()));
    }

    #[test]
    fn digits_of_errors_far_below_floats() {
        assert_eq!(digits(0.0), 50.0);
        assert!((digits(1e-6) - 6.0).abs() < 1e-9);
        assert_eq!(digits(7.0), 0.0);
    }

    #[test]
    fn units_in_the_last_place_are_those_of_each_number() {
        let third = Rational::from((1, 3));
        let known = |value: &Rational| Known {
            value: value.clone(),
            radius: Rational::new(),
        };
        let double = |x: f64| Rational::from_f64(x).unwrap();
        let next = f64::from_bits((1.0f64 / 3.0).to_bits() + 1);
        let right = Part::Numbers(vec![known(&third), known(&Rational::from(1000))]);
        let given = |x: f64, y: f64| Part::Numbers(vec![known(&double(x)), known(&double(y))]);
        assert!(ulps(&right, &given(1.0 / 3.0, 1000.0)) <= 0.5);
        let of_next = ulps(&right, &given(next, 1000.0));
        assert!((0.5..1.0).contains(&of_next), "{of_next}");
        assert_eq!(ulps(&right, &given(1.0 / 3.0, 1000.0 + 2e-12)), 18.0);
        // Of a power of two the unit is that above it.
        let one = Part::Numbers(vec![known(&Rational::from(1))]);
        let above = Part::Numbers(vec![known(&double(1.0 + f64::EPSILON))]);
        assert_eq!(ulps(&one, &above), 1.0);
    }
}
