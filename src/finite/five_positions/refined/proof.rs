//! The proof that there is one pair near whole numbers of some unit, on the conditions themselves.
//!
//! The conditions f of m, that is x, y, X, Y in units of 2^−k, are computed exactly. With δ from m in these
//! units Krawczyk's operator −C f(m) + (1 − C J) δ, J the derivatives in the whole box and C near the
//! inverse of those in m, leads from the box |δⱼ| ≤ wⱼ into itself: so there is one pair in it, and it is a
//! simple one. In all but f(m) few digits matter, so that machine floats with a bound for their errors do.

use rug::{Assign, Integer};

use super::super::krawczyk;
use super::conditions::Row;
use crate::number::gaussian::{Gaussian, products, scaled};
use crate::number::{Complex, Number, array, count};

/// Boxes of so many units are not tried.
const MOST_UNITS: f64 = 1e9;
/// The rounding errors of an entry of C J or C f(m) as a share of the sum of the magnitudes of its terms. A
/// term is a product of three numbers, each off by a unit in the last place, in a sum of twelve: less than
/// 32 errors, each less than 2⁻⁵¹ of the term.
const ROUNDING: f64 = 1.5e-14;
/// Less than what the bounds themselves lose, sums of positive numbers.
const BOUNDS: f64 = 1.0 + 1e-12;

/// A number near z 2^power, off by no more than 2^reach in each part.
pub struct Reached {
    pub z: Gaussian,
    pub power: i64,
    pub reach: i64,
}

type Floats = Number<Complex<f64>>;
type Matrix = krawczyk::Matrix<Complex<f64>>;

/// The conditions, exactly and in machine floats.
pub struct Judge<'a> {
    rows: &'a [Row; 4],
    /// Each row times a power of two, so that the greatest coefficient is between ½ and 1.
    floats: [[f64; 7]; 4],
    powers: [i64; 4],
    excess: [Gaussian; 4],
    products: [Gaussian; 2],
    constant: Integer,
}

impl<'a> Judge<'a> {
    pub fn new(rows: &'a [Row; 4]) -> Self {
        let powers = rows.each_ref().map(|row| {
            let longest = row.iter().map(Integer::significant_bits).max();
            -i64::from(longest.unwrap_or(0))
        });
        let floats = array::pairs(rows, &powers)
            .map(|(row, power)| row.each_ref().map(|c| scaled(c, *power)));
        Judge {
            rows,
            floats,
            powers,
            excess: Default::default(),
            products: Default::default(),
            constant: Integer::new(),
        }
    }

    /// x, y, X, Y in units of 2^−places, p, q, and how far off they are at most from those of a pair, which is
    /// alone there and simple, and real where these are. `None` where that is not proven.
    pub fn proven(&mut self, at: [Gaussian; 4], places: u32) -> Option<[Reached; 6]> {
        let reach = self.reach(&at, places)?;
        let sizes = at
            .each_ref()
            .map(|z| size(&z.to_floats(-i64::from(places))));
        let sum: f64 = sizes.iter().sum();
        // Products of short lengths are shorter still: in smaller units.
        let finer = power_above(sum.recip().clamp(1.0, MOST));
        let power = -i64::from(places);
        // Of a product of numbers that are off by so much, and whose own last places are left out.
        let most = reach.iter().fold(0.0, |a: f64, b| a.max(*b));
        let off = 2.0 * most * (sum + 2.0 * most * unit(places));
        let off = off * 2f64.powi(i32::try_from(finer).ok()?) * BOUNDS + 1.0;
        let down = i32::try_from(power + finer).ok()?;
        let [p, q] = self.products.each_ref().map(|product| {
            let mut z = Gaussian::default();
            z.set_shifted(product, down);
            z
        });
        let reached = |z, power, off| Reached {
            z,
            power,
            reach: power + power_above(off),
        };
        let [x, y, u, v] = at;
        let [of_x, of_y, of_u, of_v] = reach;
        let own = [(x, of_x), (y, of_y), (u, of_u), (v, of_v)];
        let [x, y, u, v] = own.map(|(z, off)| reached(z, power, off));
        let [p, q] = [p, q].map(|z| reached(z, power - finer, off));
        Some([x, y, u, v, p, q])
    }

    fn reach(&mut self, at: &[Gaussian; 4], places: u32) -> Option<[f64; 4]> {
        self.set_excess(at, places)?;
        let down = -i64::from(places);
        let middle = at.each_ref().map(|z| z.to_floats(down));
        if !middle.iter().all(|z| size(z) < MOST) {
            return None;
        }
        let inverse = krawczyk::inverse(self.slopes(&middle), size)?;
        let sizes = inverse.each_ref().map(|row| row.each_ref().map(size));
        let excess =
            array::pairs(&self.excess, &self.powers).map(|(z, power)| z.to_floats(down + power));
        let errors = excess.each_ref().map(|z| ROUNDING * size(z) + TINY);
        let steps = array::pairs(&inverse, &sizes).map(|(row, sizes)| {
            let step: Floats = row.iter().zip(&excess).map(|(c, z)| c * z).sum();
            size(&step) + dot(sizes, &errors)
        });
        let box_ = steps.map(|step| 2.0 * step + 1.0);
        let is_small = box_.iter().all(|w| *w <= MOST_UNITS);
        (is_small && self.stays(&middle, places, (&inverse, &sizes), (&steps, &box_)))
            .then_some(box_)
    }

    /// Whether the operator leads into the box.
    #[expect(clippy::indexing_slicing, reason = "four rows and columns")]
    fn stays(
        &self,
        middle: &[Floats; 4],
        places: u32,
        (inverse, sizes): (&Matrix, &[[f64; 4]; 4]),
        (steps, box_): (&[f64; 4], &[f64; 4]),
    ) -> bool {
        let slopes = self.slopes(middle);
        let errors = self.errors_of_slopes(middle, places, box_);
        (0..4).all(|i| {
            let image = (0..4).map(|j| {
                let column: [f64; 4] = std::array::from_fn(|k| errors[k][j]);
                let mut entry = Floats::from(-i64::from(i == j));
                for (c, row) in inverse[i].iter().zip(&slopes) {
                    entry += c * &row[j];
                }
                (size(&entry) + ROUNDING + dot(&sizes[i], &column)) * box_[j]
            });
            (steps[i] + image.sum::<f64>()) * BOUNDS < box_[i]
        })
    }

    /// By x, y, X, Y, with p = xX + yY and q = yX − xY.
    fn slopes(&self, [x, y, u, v]: &[Floats; 4]) -> Matrix {
        self.floats.map(|row| {
            let [by_u, by_v, p, q, _, by_x, by_y] = row.map(Number);
            let sum = |own, [(p, a), (q, b)]: [(&Number<f64>, &Floats); 2]| {
                Floats::from(own) + a.scaled(p) + b.scaled(q)
            };
            let minus_q = -&q;
            [
                sum(by_x, [(&p, u), (&minus_q, v)]),
                sum(by_y, [(&p, v), (&q, u)]),
                sum(by_u, [(&p, x), (&q, y)]),
                sum(by_v, [(&p, y), (&minus_q, x)]),
            ]
        })
    }

    /// Bounds for these in the box around, and for their rounding errors in sums.
    fn errors_of_slopes(
        &self,
        middle: &[Floats; 4],
        places: u32,
        box_: &[f64; 4],
    ) -> [[f64; 4]; 4] {
        let widest = box_.iter().fold(0.0, |a: f64, b| a.max(*b));
        let unit = unit(places);
        let [x, y, u, v] = middle.each_ref().map(size);
        self.floats.map(|row| {
            let [by_u, by_v, p, q, _, by_x, by_y] = row.map(f64::abs);
            // A part in each of two.
            let around = 2.0 * widest * unit * (p + q) + TINY;
            [
                by_x + p * u + q * v,
                by_y + p * v + q * u,
                by_u + p * x + q * y,
                by_v + p * y + q * x,
            ]
            .map(|terms| ROUNDING * terms + around)
        })
    }

    /// The left sides of the conditions times 2^2k.
    fn set_excess(&mut self, [x, y, u, v]: &[Gaussian; 4], places: u32) -> Option<()> {
        let up = i32::try_from(places).ok()?;
        products([x, y], [u, v], &mut self.products);
        let [p, q] = &self.products;
        for (sum, row) in self.excess.iter_mut().zip(self.rows) {
            let [by_u, by_v, by_p, by_q, h, by_x, by_y] = row;
            sum.set_multiple(by_u, u);
            for (factor, z) in [(by_v, v), (by_x, x), (by_y, y)] {
                sum.add_multiple(factor, z);
            }
            self.constant.assign(h << places);
            sum.re += &self.constant;
            sum.shift(up);
            sum.add_multiple(by_p, p);
            sum.add_multiple(by_q, q);
        }
        Some(())
    }
}

/// More than the error of what is beyond the range of floats, with factors below [`MOST`].
const TINY: f64 = 1e-200;
/// Larger pairs are left to exact arithmetic.
const MOST: f64 = 1e60;

/// |Re z| + |Im z|, no less than |z|.
fn size(z: &Floats) -> f64 {
    z.re().0.abs() + z.im().0.abs()
}

fn dot(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// 2^−places, or more where that is beyond the range of floats.
fn unit(places: u32) -> f64 {
    2f64.powi(-i32::try_from(places.min(900)).unwrap_or(0))
}

/// The least e ≥ 0 with w ≤ 2^e.
fn power_above(w: f64) -> i64 {
    let powers = std::iter::successors(Some(1.0), |power| Some(2.0 * power));
    let below = powers.take_while(|power| *power < w);
    count::to_i64(below.count())
}
