//! Two linear equations in Gaussian integers, solved near enough.

use crate::number::gaussian::Gaussian;

/// The places of a solution, which the next one takes again.
#[derive(Default)]
pub struct Equations {
    /// Coefficients of the unknowns.
    pub left: [[Gaussian; 2]; 2],
    /// Right sides.
    pub right: [Gaussian; 2],
    /// The solution.
    pub solution: [Gaussian; 2],
    determinant: Gaussian,
}

impl Equations {
    /// The solution times 2^up, of which so many bits matter; `None` where the determinant is too small. The
    /// equations lose what does not matter.
    pub fn solve(&mut self, bits: u32, up: i32) -> Option<()> {
        let up =
            up + shorten(&mut self.right, bits)? - shorten(self.left.as_flattened_mut(), bits)?;
        let [[a, b], [c, d]] = &self.left;
        let [first, second] = &self.right;
        self.determinant.set_minor([a, d], [b, c]);
        if self.determinant == Gaussian::default() {
            return None;
        }
        let [x, y] = &mut self.solution;
        x.set_minor([first, d], [second, b]);
        y.set_minor([a, second], [c, first]);
        let off_determinant = shorten(std::slice::from_mut(&mut self.determinant), bits)?;
        let up = up - off_determinant + shorten(&mut self.solution, bits)?;
        Gaussian::divide(&mut self.solution, &self.determinant, up, bits);
        Some(())
    }
}

/// Without the last bits where the longest has more than so many; says how many these are.
fn shorten(list: &mut [Gaussian], bits: u32) -> Option<i32> {
    let longest = list.iter().map(Gaussian::significant_bits).max()?;
    let off = i32::try_from(longest.saturating_sub(bits)).ok()?;
    if off > 0 {
        list.iter_mut().for_each(|z| z.shift(-off));
    }
    Some(off)
}

#[cfg(test)]
mod tests {
    use rug::Integer;

    use super::*;

    /// 2^places times a number of few bits and some more bits.
    fn long(re: i64, im: i64, places: u32) -> Gaussian {
        let part = |x: i64| (Integer::from(x) << places) + Integer::from(x * x + 1);
        Gaussian {
            re: part(re),
            im: part(im),
        }
    }

    #[test]
    fn solutions_have_the_bits_that_matter() {
        for (bits, imaginary) in [(50, 0), (50, 3), (700, 5), (1100, 0), (1100, 7), (4000, 1)] {
            let places = bits + 100;
            let z = |re: i64, im: i64| long(re, im * imaginary, places);
            let left = [[z(5, 2), z(-3, 1)], [z(4, -9), z(8, 3)]];
            let expected = [z(7, -1), z(-2, 6)];
            let right = left.each_ref().map(|[a, b]| {
                let mut sum = Gaussian::default();
                sum.set_sum([a, &expected[0]], [b, &expected[1]]);
                sum
            });
            let mut equations = Equations {
                left,
                right,
                ..Equations::default()
            };
            equations
                .solve(bits, 0)
                .expect("a determinant other than 0");
            for (found, expected) in equations.solution.iter_mut().zip(&expected) {
                found.subtract(expected);
                let most = expected.significant_bits() + 20 - bits;
                assert!(
                    found.significant_bits() < most,
                    "{bits} bits: {}",
                    found.significant_bits()
                );
            }
        }
    }

    #[test]
    fn only_last_bits_are_left_out() {
        let mut list = [long(-3, 5, 2000), long(1, 0, 0)];
        assert_eq!(shorten(&mut list, 10), Some(1993));
        assert_eq!(list.each_ref().map(Gaussian::significant_bits), [10, 0]);
        assert_eq!(shorten(&mut list, 10), Some(0));
    }

    #[test]
    fn no_solution_without_a_determinant() {
        for bits in [60, 1500] {
            let z = long(3, 4, 2000);
            let row = [z.clone(), z];
            let mut equations = Equations {
                left: [row.clone(), row.clone()],
                right: row,
                ..Equations::default()
            };
            assert!(equations.solve(bits, 0).is_none());
        }
    }
}
