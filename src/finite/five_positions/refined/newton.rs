//! Newton's method for circlepoint and center, in integers. Nothing is proven here.

use rug::Integer;

use super::conditions::Forms;
use super::equations::Equations;
use crate::number::gaussian::{Gaussian, products, scaled};
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
    /// On the right what p and q have too much, on the left its derivatives by x and by y: a step solves
    /// these.
    equations: Equations,
    products: [Gaussian; 2],
    short: [Gaussian; 4],
}

/// Forms without so many of their last bits.
struct Level {
    forms: Forms,
    dropped: u32,
}

impl Newton {
    /// For x and y of so many bits.
    pub fn new(forms: Forms, bits: u32) -> Self {
        let length = forms.determinant.significant_bits();
        let float = |c| Number(scaled(c, -i64::from(length)));
        let floats = (forms.forms.each_ref()).map(|form| form.each_ref().map(float));
        let lengths = std::iter::successors(Some(bits), |bits| Some(bits / 2));
        let lengths = lengths.take_while(|length| *length >= FEWEST_BITS);
        let shorter = lengths.filter_map(|length| forms.rounded(length));
        let mut levels: Vec<Level> = shorter
            .map(|(forms, dropped)| Level { forms, dropped })
            .collect();
        // More bits than those of the pairs are of no use.
        if levels.is_empty() || length <= bits {
            levels.insert(0, Level { forms, dropped: 0 });
        }
        levels.reverse();
        let whole = || Gaussian::with_room(2 * bits);
        let product = || Gaussian::with_room(3 * bits);
        Newton {
            length,
            floats,
            levels,
            values: [(); 4].map(|()| whole()),
            equations: Equations::default(),
            products: [(); 2].map(|()| product()),
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
        self.equations.solve(bits, up + finer)?;
        for (z, moved) in point.iter_mut().zip(&self.equations.solution) {
            z.shift(finer);
            z.subtract(moved);
        }
        Some(())
    }

    /// The same where machine floats do for the derivatives.
    pub fn short_step(&mut self, point: &mut [Gaussian; 2], places: u32, finer: u32) -> Option<()> {
        let lost = self.set_excess(point, places, places.checked_add(finer)?)?;
        let unit = i64::from(lost) - i64::from(self.length) - 2 * i64::from(places);
        let [first, second] = self.equations.right.each_ref().map(|z| z.to_floats(unit));
        let [x, y] = point.each_ref().map(|z| z.to_floats(-i64::from(places)));
        let [of_u, of_v, [_, px, py], [_, qx, qy]] = &self.floats;
        let [u, v] = [of_u, of_v].map(|[constant, by_x, by_y]| {
            Floats::from(constant.clone()) + x.scaled(by_x) + y.scaled(by_y)
        });
        let ([_, ux, uy], [_, vx, vy]) = (of_u, of_v);
        let by = |[of_p, of_q, of_u, of_v]: [&Number<f64>; 4]| {
            let [of_p, of_q] = [of_p, of_q].map(|own| Floats::from(own.clone()));
            [
                of_p - x.scaled(of_u) - y.scaled(of_v),
                of_q - y.scaled(of_u) + x.scaled(of_v),
            ]
        };
        let ([a, c], [b, d]) = (by([px, qx, ux, vx]), by([py, qy, uy, vy]));
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
        for (value, form) in self.values.iter_mut().zip(&level.forms.forms) {
            set_value(value, form, [x, y], places);
        }
        let [u, v, p, q] = &self.values;
        products([x, y], [u, v], &mut self.products);
        let up = i32::try_from(places).ok()?;
        let excess = self.equations.right.iter_mut();
        for ((excess, value), product) in excess.zip([p, q]).zip(&self.products) {
            excess.set_shifted(value, up);
            excess.subtract(product);
        }
        Some(level.dropped)
    }

    /// X and Y of x and y, each to one unit of 2^−places.
    pub fn center(&mut self, point: [&Gaussian; 2], places: u32) -> Option<[Gaussian; 2]> {
        let level = self.levels.last()?;
        let [u, v, ..] = &level.forms.forms;
        Some([u, v].map(|form| {
            let mut value = Gaussian::default();
            set_value(&mut value, form, point, places);
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
        let [[p_by_x, p_by_y], [q_by_x, q_by_y]] = &mut self.equations.left;
        let columns = [
            ([&mut *p_by_x, &mut *q_by_x], [px, qx, ux, vx]),
            ([&mut *p_by_y, &mut *q_by_y], [py, qy, uy, vy]),
        ];
        for ([p, q], [of_p, of_q, of_u, of_v]) in columns {
            p.set_integer(of_p, left);
            p.subtract_multiple(of_u, x_short);
            p.subtract_multiple(of_v, y_short);
            q.set_integer(of_q, left);
            q.subtract_multiple(of_u, y_short);
            q.add_multiple(of_v, x_short);
        }
        p_by_x.subtract(u_short);
        p_by_y.subtract(v_short);
        q_by_x.add(v_short);
        q_by_y.subtract(u_short);
        Some(-down - lacking)
    }
}

/// The shortest forms that have so many bits, or the longest.
fn level(levels: &[Level], bits: u32) -> Option<&Level> {
    let bits = bits.saturating_add(GUARD_BITS);
    let enough = |level: &&Level| level.forms.determinant.significant_bits() >= bits;
    levels.iter().find(enough).or(levels.last())
}

fn set_value(
    value: &mut Gaussian,
    [constant, by_x, by_y]: &[Integer; 3],
    [x, y]: [&Gaussian; 2],
    places: u32,
) {
    value.set_integer(constant, places);
    value.add_multiple(by_x, x);
    value.add_multiple(by_y, y);
}
