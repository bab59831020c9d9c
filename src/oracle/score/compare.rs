//! How far a given part lies from the certified one, without rounding either.

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
            let turn = Rational::from(360);
            let difference = Rational::from(&certified.value - &given.value);
            let turns = Rational::from(&difference / &turn).round();
            let distance = (difference - turns * turn).abs() + &certified.radius;
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
    for (name, part) in &given.parts {
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

/// Correct digits at this relative error: at most 50, those of the certified answers.
pub fn digits(error: &Rational) -> f64 {
    const MOST: f64 = 50.0;
    if error.is_zero() {
        return MOST;
    }
    let log = Float::with_val(64, error).log10().to_f64();
    (-log).clamp(0.0, MOST)
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

/// Both scaled so that the largest certified number is the same.
fn of_ratio(certified: &[Known], given: &[Known]) -> Option<Rational> {
    let place = (0..certified.len()).max_by(|&i, &j| {
        let size = |k: usize| certified.get(k).map(|known| known.value.clone().abs());
        size(i).cmp(&size(j))
    })?;
    let (leading, other) = (&certified.get(place)?.value, &given.get(place)?.value);
    if leading.is_zero() || other.is_zero() {
        return None;
    }
    let factor = Rational::from(leading / other);
    let scaled = given
        .iter()
        .map(|known| Rational::from(&known.value * &factor));
    farthest(certified, scaled).map(|distance| distance / leading.clone().abs())
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
        assert_eq!(digits(&Rational::new()), 50.0);
        assert!((digits(&Rational::from((1, 1_000_000))) - 6.0).abs() < 1e-9);
        assert_eq!(digits(&Rational::from(7)), 0.0);
    }
}
