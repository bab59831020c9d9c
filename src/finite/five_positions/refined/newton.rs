//! Newton's method for circlepoint and center, in integers. Nothing is proven here.

use rug::Integer;

use super::conditions::Forms;
use crate::number::gaussian::{Gaussian, scaled};
use crate::number::{Complex, Number};

/// Bits that the numbers of a step carry beyond those that it gains.
const GUARD_BITS: u32 = 24;
/// Bits of the shortest forms.
const FEWEST_BITS: u32 = 128;

type Floats = Number<Complex<f64>>;

/// With X, Y, p, q as forms in x and y there are two equations left, p = xX + yY and q = yX − xY.
///
/// All places of a step, which later steps take again without allocation.
pub struct Newton {
    /// How many bits the determinant has.
    length: u32,
    /// The forms by 2 to the power of that.
    floats: [[Number<f64>; 3]; 4],
    /// The last one with all bits, the others with half as many each.
    levels: Vec<Level>,
    /// determinant·(X, Y, p, q).
    values: [Gaussian; 4],
    /// What p and q have too much.
    excess: [Gaussian; 2],
    /// Its derivatives, by x and by y.
    slopes: [[Gaussian; 2]; 2],
    determinant: Gaussian,
    moved: [Gaussian; 2],
    short: [Gaussian; 4],
}

/// Forms without so many of their last bits.
struct Level {
    forms: Forms,
    dropped: u32,
}

impl Newton {
    /// For x and y of so many bits.
    pub fn new(forms: &Forms, bits: u32) -> Self {
        let lengths = std::iter::successors(Some(bits), |bits| Some(bits / 2));
        let lengths = lengths.take_while(|length| *length == bits || *length >= FEWEST_BITS);
        let mut levels: Vec<Level> = lengths
            .map(|length| forms.rounded(length))
            .map(|(forms, dropped)| Level { forms, dropped })
            .collect();
        levels.reverse();
        let room = |bits| move || Gaussian::with_room(bits);
        let (whole, product) = (room(2 * bits), room(3 * bits));
        let length = forms.determinant.significant_bits();
        let float = |c| Number(scaled(c, -i64::from(length)));
        Newton {
            length,
            floats: forms
                .forms
                .each_ref()
                .map(|form| form.each_ref().map(float)),
            levels,
            values: [(); 4].map(|()| whole()),
            excess: [(); 2].map(|()| product()),
            slopes: [(); 2].map(|()| [(); 2].map(|()| whole())),
            determinant: product(),
            moved: [(); 2].map(|()| product()),
            short: [(); 4].map(|()| whole()),
        }
    }

    /// One step from x and y in units of 2^−places to units that are smaller by 2^finer; `None` where the
    /// derivatives do not let it.
    pub fn step(&mut self, point: &mut [Gaussian; 2], places: u32, finer: u32) -> Option<()> {
        let bits = finer + GUARD_BITS;
        let lost = self.set_excess(point, places, places.checked_add(finer)?)?;
        let up = self.set_slopes(point, places, (bits, lost))?;
        let finer = i32::try_from(finer).ok()?;
        self.solve(bits, up + finer)?;
        for (z, moved) in point.iter_mut().zip(&self.moved) {
            z.shift(finer);
            z.subtract(moved);
        }
        Some(())
    }

    /// The same where machine floats do for the derivatives.
    pub fn short_step(&mut self, point: &mut [Gaussian; 2], places: u32, finer: u32) -> Option<()> {
        let lost = self.set_excess(point, places, places.checked_add(finer)?)?;
        let unit = i64::from(lost) - i64::from(self.length) - 2 * i64::from(places);
        let [first, second] = self.excess.each_ref().map(|z| floats(z, unit));
        let [x, y] = point.each_ref().map(|z| floats(z, -i64::from(places)));
        let [[_, ux, uy], [_, vx, vy], [_, px, py], [_, qx, qy]] = &self.floats;
        let [u, v] = [0, 1].map(|i| {
            let [constant, by_x, by_y] = &self.floats[i];
            Floats::from(constant.clone()) + x.scaled(by_x) + y.scaled(by_y)
        });
        let by = |own: &Number<f64>, of_u: &Number<f64>, of_v: &Number<f64>| {
            let own = Floats::from(own.clone());
            [
                &own - x.scaled(of_u) - y.scaled(of_v),
                own - y.scaled(of_u) + x.scaled(of_v),
            ]
        };
        let ([a, _], [b, _]) = (by(px, ux, vx), by(py, uy, vy));
        let ([_, c], [_, d]) = (by(qx, ux, vx), by(qy, uy, vy));
        let (a, b, c, d) = (a - &u, b - &v, c + v, d - u);
        let inverse = (&a * &d - &b * &c).inverse();
        let moved = [
            (&first * d - &second * b) * &inverse,
            (a * second - c * first) * inverse,
        ];
        let finest = 2f64.powi(i32::try_from(places + finer).ok()?);
        let finer = i32::try_from(finer).ok()?;
        for (z, moved) in point.iter_mut().zip(moved) {
            z.shift(finer);
            z.re -= Integer::from_f64(moved.re().0 * finest)?;
            z.im -= Integer::from_f64(moved.im().0 * finest)?;
        }
        Some(())
    }

    /// What p and q have too much, without rounding: of a point of few bits it has few. With forms that
    /// have about so many bits; says how many of the determinant's they lack.
    fn set_excess(&mut self, [x, y]: &[Gaussian; 2], places: u32, bits: u32) -> Option<u32> {
        let level = level(&self.levels, bits)?;
        set_values(&mut self.values, level, [x, y], places);
        let [u, v, p, q] = &self.values;
        let [first, second] = &mut self.excess;
        let up = i32::try_from(places).ok()?;
        first.set_shifted(p, up);
        first.subtract_product(x, u);
        first.subtract_product(y, v);
        second.set_shifted(q, up);
        second.subtract_product(y, u);
        second.add_product(x, v);
        Some(level.dropped)
    }

    /// X and Y of x and y, each to one unit of 2^−places.
    pub fn center(&mut self, point: [&Gaussian; 2], places: u32) -> Option<[Gaussian; 2]> {
        let level = self.levels.last()?;
        set_values(&mut self.values, level, point, places);
        let [u, v, ..] = &self.values;
        Some([u, v].map(|value| {
            let mut value = value.clone();
            value.divide_by_integer(&level.forms.determinant);
            value
        }))
    }

    /// Of so many bits, for of derivatives no more matter than are gained; the values lack some bits of the
    /// determinant. Says the power of two that the slopes lack beyond what the values do.
    fn set_slopes(
        &mut self,
        [x, y]: &[Gaussian; 2],
        places: u32,
        (bits, lost): (u32, u32),
    ) -> Option<i32> {
        let [x_short, y_short, u_short, v_short] = &mut self.short;
        let [u, v, ..] = &self.values;
        let level = level(&self.levels, bits)?;
        let left = places.min(bits);
        let down = i32::try_from(places - left).ok()?;
        let lacking = i32::try_from(level.dropped).ok()? - i32::try_from(lost).ok()?;
        x_short.set_shifted(x, -down);
        y_short.set_shifted(y, -down);
        u_short.set_shifted(u, -down - lacking);
        v_short.set_shifted(v, -down - lacking);
        let [[_, ux, uy], [_, vx, vy], [_, px, py], [_, qx, qy]] = &level.forms.forms;
        let [[p_by_x, p_by_y], [q_by_x, q_by_y]] = &mut self.slopes;
        p_by_x.set_integer(px, left);
        p_by_x.subtract_multiple(ux, x_short);
        p_by_x.subtract_multiple(vx, y_short);
        p_by_x.subtract(u_short);
        p_by_y.set_integer(py, left);
        p_by_y.subtract_multiple(uy, x_short);
        p_by_y.subtract_multiple(vy, y_short);
        p_by_y.subtract(v_short);
        q_by_x.set_integer(qx, left);
        q_by_x.subtract_multiple(ux, y_short);
        q_by_x.add_multiple(vx, x_short);
        q_by_x.add(v_short);
        q_by_y.set_integer(qy, left);
        q_by_y.subtract_multiple(uy, y_short);
        q_by_y.add_multiple(vy, x_short);
        q_by_y.subtract(u_short);
        Some(-down - lacking)
    }

    /// The excess by the slopes, of which so many bits matter, times 2^up.
    fn solve(&mut self, bits: u32, up: i32) -> Option<()> {
        let cut = |longest: u32| i32::try_from(longest.saturating_sub(bits)).ok();
        let longest = self.excess.iter().map(Gaussian::significant_bits).max()?;
        let off_excess = cut(longest)?;
        let slopes = || self.slopes.iter().flatten();
        let off_slopes = cut(slopes().map(Gaussian::significant_bits).max()?)?;
        self.excess.iter_mut().for_each(|z| z.shift(-off_excess));
        for slope in self.slopes.iter_mut().flatten() {
            slope.shift(-off_slopes);
        }
        let [[a, b], [c, d]] = &self.slopes;
        let [first, second] = &self.excess;
        self.determinant.set_minor([a, d], [b, c]);
        if self.determinant == Gaussian::default() {
            return None;
        }
        let [dx, dy] = &mut self.moved;
        dx.set_minor([first, d], [second, b]);
        dy.set_minor([a, second], [c, first]);
        let up = up + off_excess - off_slopes - self.determinant.shorten(bits);
        for z in &mut self.moved {
            let off = z.shorten(bits);
            z.shift(up + off);
            z.divide(&self.determinant);
        }
        Some(())
    }
}

/// The shortest forms that have so many bits, or the longest.
fn level(levels: &[Level], bits: u32) -> Option<&Level> {
    let bits = bits.saturating_add(GUARD_BITS);
    let enough = |level: &&Level| level.forms.determinant.significant_bits() >= bits;
    levels.iter().find(enough).or(levels.last())
}

fn set_values(values: &mut [Gaussian; 4], level: &Level, [x, y]: [&Gaussian; 2], places: u32) {
    for (value, [constant, by_x, by_y]) in values.iter_mut().zip(&level.forms.forms) {
        value.set_integer(constant, places);
        value.add_multiple(by_x, x);
        value.add_multiple(by_y, y);
    }
}

fn floats(z: &Gaussian, power: i64) -> Floats {
    let [re, im] = z.to_floats(power).map(Number);
    Number::complex(re, im)
}
