//! All pairs of rational positions from machine floats on: Newton's method, then a proof for each.
//!
//! A pair that is proven is simple. Four simple pairs, conjugate ones among them, are all that there are:
//! two conics have no more meets, and where they have a part in common only one that is simple.

mod conditions;
mod equations;
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
use crate::number::{Ball, Complex, Exact, Kind, Number, array};
use crate::plane::displacement::Displacement;

/// Bits of the forms beyond those of the pairs.
const FORM_BITS: u32 = 64;
/// With fewer, pairs might not be apart.
const FEWEST_BITS: u32 = 53;
/// How often a pair is tried to prove, with a step between.
const ATTEMPTS: usize = 4;

/// Four simple finite pairs, as a rule with so many bits; `None` where that is not what is found.
pub fn pairs(positions: &[Displacement<Exact>; 5], bits: u32) -> Option<Certified> {
    let size = size(positions);
    if (SMALLEST..=LARGEST).contains(&size) {
        return pairs_of_usual_size(positions, bits);
    }
    let power = Number::from(Rational::from_f64(size.log2().round().exp2())?);
    let inverse = power.inverse();
    let smaller = positions.each_ref().map(|position| Displacement {
        rotation: position.rotation.clone(),
        translation: position.translation.scaled(&inverse),
    });
    let found = pairs_of_usual_size(&smaller, bits)?;
    let power = power.in_kind::<Ball>();
    let real = found.real.into_iter();
    let complex = found.complex.into_iter();
    Some(Certified {
        real: real.map(|pair| scaled(pair, |x| x * &power)).collect(),
        complex: complex
            .map(|pair| scaled(pair, |x| x.scaled(&power)))
            .collect(),
    })
}

/// The same pair with another unit of length.
fn scaled<K: Kind>(pair: Pair<K>, by: impl Fn(&Number<K>) -> Number<K>) -> Pair<K> {
    let [h, x, y, u, v, p, q] = &pair.coordinates;
    let [x, y, u, v] = [x, y, u, v].map(&by);
    let [p, q] = [p, q].map(|product| by(&by(product)));
    Pair {
        coordinates: [h.clone(), x, y, u, v, p, q],
        ..pair
    }
}

/// The largest shift, about.
fn size(positions: &[Displacement<Exact>; 5]) -> f64 {
    let parts = positions.iter().map(|position| &position.translation);
    let parts = parts.flat_map(|t| [t.re(), t.im()]);
    parts.map(|x| float(x).0.abs()).fold(0.0, f64::max)
}

/// Shifts that are large or small against the rotations, of 1, cost digits.
const SMALLEST: f64 = 1.0 / 256.0;
const LARGEST: f64 = 256.0;

fn pairs_of_usual_size(positions: &[Displacement<Exact>; 5], bits: u32) -> Option<Certified> {
    let near = floats::pairs(&positions.each_ref().map(|position| position.map(float)))?;
    let bits = bits.max(FEWEST_BITS);
    let near = near.iter().map(|pair| Near::new(pair, bits));
    let near: Vec<Near> = near.collect::<Option<_>>()?;
    let rows = rows(positions)?;
    let places = near.iter().map(|near| near.places).max()?;
    let mut newton = Newton::new(Forms::new(&rows)?, places.checked_add(FORM_BITS)?);
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
                return Some(Proven { coordinates });
            }
            newton.step(&mut point, places, 0)?;
        }
        None
    }

    fn real(&self) -> Pair<Ball> {
        self.pair(|at| at.ball(&at.z.re))
    }

    fn complex(&self) -> Pair<Complex<Ball>> {
        self.pair(|at| Number::complex(at.ball(&at.z.re), at.ball(&at.z.im)))
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

impl Reached {
    fn ball(&self, part: &Integer) -> Number<Ball> {
        Number(Ball::scaled(part, self.power, self.reach))
    }
}

/// Whether all are different, and those that are not real surely not.
fn are_apart(found: &Certified) -> bool {
    let complex = || found.complex.iter().map(|pair| &pair.coordinates);
    let never_real = complex().all(|pair| pair.iter().any(|z| z.im().is_zero().is_no()));
    let conjugate = |pair: &Coordinates<Complex<Ball>>| pair.each_ref().map(|z| z.conj());
    never_real
        && array::every_two(&found.real, |a, b| differ(&a.coordinates, &b.coordinates))
        && array::every_two(&found.complex, |a, b| {
            let [a, b] = [a, b].map(|pair| &pair.coordinates);
            differ(a, b) && differ(a, &conjugate(b))
        })
}

fn differ<K: Kind>(a: &Coordinates<K>, b: &Coordinates<K>) -> bool {
    a.iter().zip(b).any(|(a, b)| a.equals(b).is_no())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::Angle;

    fn five(numbers: [[i64; 3]; 5]) -> [Displacement<Exact>; 5] {
        numbers.map(|[x, y, half]| Displacement {
            rotation: Angle::from_tan_half(&Number::ratio(half, 12)).cis(),
            translation: Number::complex(x.into(), y.into()),
        })
    }

    fn two_real() -> [Displacement<Exact>; 5] {
        five([[0, 0, 0], [3, 1, 2], [5, 1, 4], [6, -1, 8], [5, -4, 12]])
    }

    fn larger(by: &Number<Exact>) -> [Displacement<Exact>; 5] {
        two_real().map(|position| Displacement {
            translation: position.translation.scaled(by),
            ..position
        })
    }

    #[test]
    fn many_bits_lie_within_few() {
        let mut complex = 0;
        let long = Number::<Exact>::from(1 << 40);
        for positions in [two_real(), larger(&long), larger(&long.inverse())] {
            let all = [1, 60, 130, 500, 4000].map(|bits| {
                let found = pairs(&positions, bits).expect("four pairs that are apart");
                assert!(found.has_bits(bits.saturating_sub(30)), "{bits} bits");
                found
            });
            for (few, many) in
                array::pairs(&[0, 1, 2, 3], &[1, 2, 3, 4]).map(|(a, b)| (&all[*a], &all[*b]))
            {
                assert_eq!(few.real.len(), many.real.len());
                for (few, many) in few.real.iter().zip(&many.real) {
                    let both = array::pairs(&few.coordinates, &many.coordinates);
                    assert!(both.iter().all(|(few, many)| few.0.overlaps(&many.0)));
                }
                for (few, many) in few.complex.iter().zip(&many.complex) {
                    complex += 1;
                    let both = array::pairs(&few.coordinates, &many.coordinates);
                    assert!(both.iter().all(|(few, many)| {
                        few.re().0.overlaps(&many.re().0) && few.im().0.overlaps(&many.im().0)
                    }));
                }
            }
        }
        assert!(complex > 0, "some are complex");
    }

    #[test]
    fn whatever_number_of_pairs_is_real() {
        let mut met = [false; 5];
        for n in 1..60i64 {
            let place = |k: i64| {
                [
                    (n * k * 7 + k * k) % 11 - 5,
                    (n * n + 3 * k) % 7 - 3,
                    (n + 5 * k) % 23,
                ]
            };
            if let Some(found) = pairs(&five([0, 1, 2, 3, 4].map(place)), 80) {
                assert_eq!(found.real.len() + 2 * found.complex.len(), 4);
                met[found.real.len()] = true;
            }
        }
        assert_eq!(met, [true, false, true, false, true]);
    }

    #[test]
    fn a_family_is_not_four_pairs() {
        let turns = five([[1, 2, 0], [1, 2, 3], [1, 2, 5], [1, 2, 7], [1, 2, 9]]);
        assert!(pairs(&turns, 100).is_none());
    }

    #[test]
    fn only_what_is_near_is_proven() {
        let positions = two_real();
        let rows = rows(&positions).expect("rational positions");
        let near = floats::pairs(&positions.each_ref().map(|position| position.map(float)));
        let near = near
            .expect("pairs")
            .iter()
            .find_map(|pair| Near::new(pair, 200))
            .expect("one finite");
        let bits = near.places + FORM_BITS;
        let mut newton = Newton::new(Forms::new(&rows).expect("a determinant"), bits);
        let point = near.refined(&mut newton).expect("steps");
        let mut judge = Judge::new(&rows);
        let [x, y] = &point;
        let [u, v] = newton.center([x, y], near.places).expect("a center");
        let at = |off: i64| {
            let mut moved = x.clone();
            moved.re += off;
            [moved, y.clone(), u.clone(), v.clone()]
        };
        let units = |reached: &[Reached; 6]| {
            let [x, ..] = reached;
            x.reach - x.power
        };
        let of_x = units(&judge.proven(at(0), near.places).expect("it is one"));
        assert!(of_x <= 6);
        for off in [1 << 32, -(1 << 40), 1 << 50] {
            assert!(judge.proven(at(off), near.places).is_none(), "off by {off}");
        }
        // Where it is proven farther away, it is still within reach.
        for off in [5, -9, 20, 1000] {
            let Some(moved) = judge.proven(at(off), near.places) else {
                continue;
            };
            assert!(
                off.abs() <= (1 << units(&moved)) + (1 << of_x),
                "off by {off}"
            );
        }
    }
}
