//! The Burmester pairs in machine floats: fast, nothing certified.
//!
//! The quick way has no branch and takes many problems at once; it says which it has not solved. Those
//! take the [`careful`] way.

pub mod careful;
mod quick;

use fearless_simd::{Level, dispatch};

use self::quick::{OnLine, Problem, Solution};
use super::conditions::Coordinates;
use crate::number::{Complex, Number, array, lanes};
use crate::plane::displacement::Displacement;

/// Below this share of the largest coordinate h counts as zero: the pair is at infinity.
const NEGLIGIBLE: f64 = 1e-13;
/// Problems that are solved together.
const TOGETHER: usize = 32;
/// Problems that one core takes at a time.
#[cfg(feature = "parallel")]
const TAKEN: usize = 32 * TOGETHER;

type Pair = Coordinates<Complex<f64>>;
type Five = [Displacement<f64>; 5];

/// Two of the four pairs, by h, x, y, X, Y, p, q, of which h is zero for those at infinity.
#[derive(Clone, Debug)]
pub enum Two {
    /// Both real.
    Real([Coordinates<f64>; 2]),
    /// One of two that are conjugate to each other.
    Conjugate(Coordinates<Complex<f64>>),
}

impl Two {
    /// One of two conjugate pairs.
    fn pairs(&self) -> Vec<Pair> {
        let complex = |x: &Number<f64>| Number::from(x.clone());
        match self {
            Two::Real(both) => both
                .each_ref()
                .map(|pair| pair.each_ref().map(complex))
                .into(),
            Two::Conjugate(pair) => vec![pair.clone()],
        }
    }

    fn on_line(line: &OnLine) -> Two {
        if line.is_real > 0.0 {
            return Two::Real([line.first, line.second].map(|pair| pair.map(Number)));
        }
        let parts = array::pairs(&line.first, &line.second);
        Two::Conjugate(parts.map(|(re, im)| Number::complex(Number(*re), Number(*im))))
    }

    /// Of pairs by ones; `None` unless they are four, conjugate ones counted twice.
    fn both(pairs: Vec<Pair>) -> Option<[Two; 2]> {
        let is_real = |pair: &Pair| pair.iter().all(|z| z.im().0 == 0.0);
        let (real, complex): (Vec<Pair>, Vec<Pair>) = pairs.into_iter().partition(is_real);
        let real: Vec<Coordinates<f64>> = real
            .iter()
            .map(|pair| pair.each_ref().map(|z| z.re().clone()))
            .collect();
        let (twos, []) = real.as_chunks::<2>() else {
            return None;
        };
        let twos = twos.iter().cloned().map(Two::Real);
        let all: Vec<Two> = twos
            .chain(complex.into_iter().map(Two::Conjugate))
            .collect();
        all.try_into().ok()
    }
}

/// All pairs by h, x, y, X, Y, p, q, of which h is zero for those at infinity; real ones have real
/// coordinates, and of two conjugate ones there is one. `None` where these are not found, as in
/// families.
pub fn pairs(positions: &[Displacement<f64>; 5]) -> Option<Vec<Pair>> {
    match accepted(&quick::solve(&problem(positions))) {
        Some(both) => Some(both.iter().flat_map(Two::pairs).collect()),
        None => careful::pairs(positions),
    }
}

/// The pairs of many problems, as [`pairs`] finds them; on all cores with the feature `parallel`.
pub fn pairs_of_many(problems: &[[Displacement<f64>; 5]]) -> Vec<Option<[Two; 2]>> {
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        let chunks = problems.par_chunks(TAKEN);
        chunks.flat_map_iter(one_after_another).collect()
    }
    #[cfg(not(feature = "parallel"))]
    {
        one_after_another(problems).collect()
    }
}

fn one_after_another(problems: &[Five]) -> impl Iterator<Item = Option<[Two; 2]>> {
    problems.chunks(TOGETHER).flat_map(|together| {
        let found = quickly(lanes::level(), together);
        together.iter().zip(found).map(|(problem, solution)| {
            accepted(&solution).or_else(|| Two::both(careful::pairs(problem)?))
        })
    })
}

fn accepted(solution: &Solution) -> Option<[Two; 2]> {
    (solution.accepted > 0.0).then(|| solution.lines.each_ref().map(Two::on_line))
}

fn problem(positions: &Five) -> Problem {
    positions.each_ref().map(|position| {
        let (r, t) = (&position.rotation, &position.translation);
        [r.re().0, r.im().0, t.re().0, t.im().0]
    })
}

/// At most [`TOGETHER`] problems.
#[expect(
    clippy::indexing_slicing,
    reason = "the places are those of arrays of known lengths, and no more problems than lanes"
)]
fn quickly(level: Level, problems: &[Five]) -> [Solution; TOGETHER] {
    let mut given = [[[0.0; TOGETHER]; 4]; 5];
    for (n, positions) in problems.iter().take(TOGETHER).enumerate() {
        for (place, position) in problem(positions).into_iter().enumerate() {
            for (number, value) in position.into_iter().enumerate() {
                given[place][number][n] = value;
            }
        }
    }
    let mut points = [[[0.0; TOGETHER]; 14]; 2];
    let mut truths = [[0.0; TOGETHER]; 3];
    dispatch!(level, _ => quick::solve_together(&given, &mut points, &mut truths));
    let mut solutions = [Solution::NONE; TOGETHER];
    for (n, solution) in solutions.iter_mut().enumerate() {
        solution.accepted = truths[2][n];
        for (line, found) in solution.lines.iter_mut().enumerate() {
            found.is_real = truths[line][n];
            found.first = std::array::from_fn(|place| points[line][place][n]);
            found.second = std::array::from_fn(|place| points[line][7 + place][n]);
        }
    }
    solutions
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::finite::five_positions::conditions::{products, rows};

    /// Numbers between −1 and 1 without a pattern.
    struct Dice(u64);

    impl Dice {
        fn next(&mut self) -> f64 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            f64::from(u32::try_from(self.0 >> 32).unwrap()) / f64::from(1u32 << 31) - 1.0
        }

        fn position(&mut self) -> Displacement<f64> {
            let (sin, cos) = (4.0 * self.next()).sin_cos();
            let [x, y] = [self.next(), self.next()].map(Number);
            Displacement {
                rotation: Number::complex(Number(cos), Number(sin)),
                translation: Number::complex(x, y),
            }
        }
    }

    fn problems(count: usize) -> Vec<Five> {
        let mut dice = Dice(1888);
        let one = |_| std::array::from_fn(|_| dice.position());
        (0..count).map(one).collect()
    }

    #[test]
    fn every_instruction_set_finds_the_same() {
        let problems = problems(TOGETHER);
        let one_by_one: Vec<Solution> = problems
            .iter()
            .map(|five| quick::solve(&problem(five)))
            .collect();
        for level in lanes::levels() {
            assert_eq!(
                quickly(level, &problems).as_slice(),
                one_by_one,
                "{level:?}"
            );
        }
    }

    #[test]
    fn nearly_all_are_solved_quickly() {
        let problems = problems(1000);
        let is_quick = |five: &&Five| accepted(&quick::solve(&problem(five))).is_some();
        let quick = problems.iter().filter(is_quick).count();
        assert!(quick > 990, "{quick}");
    }

    #[test]
    fn pairs_fulfil_the_conditions() {
        let problems = problems(100);
        let found = pairs_of_many(&problems);
        assert_eq!(found.len(), problems.len());
        for (five, found) in problems.iter().zip(found) {
            let complex = five.each_ref().map(|d| d.map(|x| x.clone()));
            let rows = rows(&complex);
            let pairs: Vec<Pair> = found.iter().flatten().flat_map(Two::pairs).collect();
            assert!(pairs.len() >= 2, "{pairs:?}");
            for pair in pairs {
                let size = |z: &Number<Complex<f64>>| z.norm().0.sqrt();
                let largest = pair.iter().map(size).fold(0.0, f64::max);
                for row in &rows {
                    let terms = row.iter().zip(&pair);
                    let sum: Number<Complex<f64>> =
                        terms.map(|(a, z)| Number::from(a.clone()) * z).sum();
                    assert!(size(&sum) < 1e-14 * largest, "{sum:?}");
                }
                for product in products(&pair, &pair) {
                    assert!(size(&product) < 1e-13 * largest * largest, "{product:?}");
                }
            }
        }
    }

    /// Two equal positions, five equal ones and translations are left to the careful way.
    #[test]
    fn degenerate_problems_are_not_solved_quickly() {
        let [a, b, c, d, e] = problems(1).remove(0);
        let equal = [a.clone(), a.clone(), b.clone(), c.clone(), d.clone()];
        let still = [(); 5].map(|()| a.clone());
        let mut dice = Dice(7);
        let translations = [a, b, c, d, e].map(|five| Displacement {
            rotation: Number::one(),
            translation: five.translation.scaled(&Number(dice.next())),
        });
        for five in [equal, still, translations] {
            assert!(accepted(&quick::solve(&problem(&five))).is_none());
            assert_eq!(
                pairs(&five).map(|pairs| pairs.len()),
                careful::pairs(&five).map(|pairs| pairs.len())
            );
        }
    }

    #[test]
    fn both_ways_find_the_pairs_of_most_problems() {
        let problems = problems(300);
        let quickly = problems
            .iter()
            .filter(|five| accepted(&quick::solve(&problem(five))).is_some());
        let carefully = problems
            .iter()
            .filter(|five| careful::pairs(five).is_some());
        let [quickly, carefully] = [quickly.count(), carefully.count()];
        assert!(quickly >= 295, "quickly: {quickly} of 300");
        assert_eq!(carefully, 300);
    }
}
