//! Whether what is said of a circular cubic is so, from its coefficients alone.
//!
//! Second derivatives tell the lines that meet the curve once less than others of their direction: the
//! isotropic ones through the focus, and the asymptote. The lines parallel to the asymptote meet the
//! curve in two more points, for t with A(h)t² + B(h)t + C(h) = 0 on the line of height h, which is no
//! line through the focus: the four zeros of B² − 4AC are all real or all not where there are two
//! branches, two of them real where there is one, and two the same for a double point.

use std::cmp::Ordering;

use serde_json::Value;

use super::geometry::Sheet;
use super::known::{Known, vanish};
use super::rest::Rest;
use super::shown::{decided, point};
use super::{Defect, require};
use crate::number::univariate::Polynomial;
use crate::number::{Number, Truth, array};

/// The coefficients of x³, x²y, xy², y³, x², xy, y², x, y, 1.
pub struct Curve<'a, K>(pub &'a [Number<K>; 10]);

/// a x + b y + c.
type Linear<K> = [Number<K>; 3];

impl<K: Known> Curve<'_, K> {
    /// Checks type, nodes, focus, asymptote and midline.
    pub fn check(&self, name: &str, shown: &Value, sheet: &Sheet<'_>) -> Result<(), Defect> {
        let at = |part: &str| format!("{name}.{part}");
        let mut rest = Rest::default();
        let own = self.type_and_double_points();
        rest.after(match &own {
            Some((kind, _)) => {
                let said = match kind {
                    Some(_) => decided(sheet.answer, &shown["type"], &at("type"))?,
                    None => &shown["type"],
                };
                require(said.as_str() == *kind, &at("type"), "it is of another type")
            }
            None => Err(Defect::unchecked(format!("the type of the {name} curve"))),
        })?;
        let count = own.and_then(|(_, count)| count);
        rest.after(self.nodes(name, &shown["nodes"], count, sheet))?;
        let parts = ["focus", "asymptote", "midline"];
        if self.has_conic_only().is_yes() {
            for part in parts {
                let none = shown[part].is_null();
                require(none, &at(part), "the line at infinity is a part of it")?;
            }
            return rest.finish();
        }
        let none_shown = parts.iter().all(|part| shown[*part].is_null());
        if none_shown && self.has_conic_only().is_unknown() {
            let open = "whether the line at infinity is a part of it";
            rest.after(Err(Defect::unchecked(format!("{name}: {open}"))))?;
            return rest.finish();
        }
        let focus = self.focus();
        rest.after(sheet.finite_point(&shown["focus"], &at("focus"), &focus))?;
        let asymptote = self.asymptote();
        rest.after(sheet.up_to_factor(&shown["asymptote"], &at("asymptote"), &asymptote))?;
        let midline = self.midline(&focus);
        rest.after(sheet.up_to_factor(&shown["midline"], &at("midline"), &midline))?;
        rest.finish()
    }

    fn has_conic_only(&self) -> Truth {
        let [a, b, c, d, ..] = self.0;
        vanish(&[a.clone(), b.clone(), c.clone(), d.clone()])
    }

    /// The second derivatives by x twice, by x and y, by y twice.
    fn second(&self) -> [Linear<K>; 3] {
        let [a, b, c, d, e, f, g, ..] = self.0;
        [
            [6 * a, 2 * b, 2 * e],
            [2 * b, 2 * c, f.clone()],
            [2 * c, 6 * d, 2 * g],
        ]
    }

    /// Where no isotropic line has a term of order two: F_xx − F_yy = F_xy = 0.
    fn focus(&self) -> [Number<K>; 2] {
        let [xx, [p, q, r], yy] = self.second();
        let [u, v, w] = minus(&xx, &yy);
        let area = &u * &q - &v * &p;
        [(&v * &r - &w * &q) / &area, (w * p - u * r) / area]
    }

    /// Where the lines along (b, −a), on which the curve has no term of order three, have none of order
    /// two.
    #[expect(
        clippy::indexing_slicing,
        reason = "a linear form has three coefficients"
    )]
    fn asymptote(&self) -> Linear<K> {
        let [a, b, ..] = self.0;
        let [xx, xy, yy] = self.second();
        std::array::from_fn(|i| b.square() * &xx[i] - 2 * a * b * &xy[i] + a.square() * &yy[i])
    }

    /// The middles of the chords through the focus φ: a (x − φx) + b (y − φy) + F_xx(φ)/4 = 0.
    fn midline(&self, [x, y]: &[Number<K>; 2]) -> Linear<K> {
        let [a, b, ..] = self.0;
        let [[p, q, r], ..] = self.second();
        let bend = (p * x + q * y + r) / 4;
        [a.clone(), b.clone(), bend - a * x - b * y]
    }

    /// F_x, F_y and F.
    fn at(&self, [x, y]: &[Number<K>; 2]) -> [Number<K>; 3] {
        let [a, b, c, d, e, f, g, h, i, j] = self.0;
        let (xx, xy, yy) = (x.square(), x * y, y.square());
        [
            3 * a * &xx + 2 * b * &xy + c * &yy + 2 * e * x + f * y + h,
            b * &xx + 2 * c * &xy + 3 * d * &yy + f * x + 2 * g * y + i,
            (a * x + b * y + e) * &xx + (c * x + d * y + g) * &yy + f * xy + h * x + i * y + j,
        ]
    }

    /// The type, none for a curve without a finite point, and how many double points are listed, if that
    /// is known; `None` where the type cannot be told.
    fn type_and_double_points(&self) -> Option<(Option<&'static str>, Option<usize>)> {
        match self.has_conic_only() {
            Truth::Yes => self.type_of_conic(),
            Truth::No => self.type_of_cubic(),
            Truth::Unknown => None,
        }
    }

    fn type_of_cubic(&self) -> Option<(Option<&'static str>, Option<usize>)> {
        let [square, linear, absolute] = self.on_parallels();
        let branching = &(&linear * &linear) - &(&square * &absolute).scaled(&4.into());
        match discriminant_sign(&branching) {
            Some(Ordering::Less) => return Some((Some("one-branch"), Some(0))),
            Some(Ordering::Greater) => return Some((Some("two-branches"), Some(0))),
            Some(Ordering::Equal) => {}
            None => return None,
        }
        let at_focus = vanish(&self.at(&self.focus()));
        // The line of height h with A(h) = 0 is the asymptote.
        let [constant, slope] = [0, 1].map(|power| square.coefficient(power));
        let height = -constant / slope;
        let along = [&linear, &absolute].map(|part| part.evaluate(&height));
        match (at_focus, vanish(&along)) {
            (Truth::Yes, _) => Some((Some("three-lines"), Some(1))),
            (Truth::No, Truth::Yes) => {
                Some((Some("line-and-circle"), self.meeting_points(&height)))
            }
            (Truth::No, Truth::No) => Some((Some("nodal"), Some(1))),
            _ => None,
        }
    }

    /// A, B and C as polynomials of the height, on the lines through h (a, b) along (b, −a).
    fn on_parallels(&self) -> [Polynomial<K>; 3] {
        let [a, b, ..] = self.0;
        let height = |part: &Number<K>| Polynomial::new(vec![Number::zero(), part.clone()]);
        let fixed = |part: Number<K>| Polynomial::constant(part);
        // x = a h + b t, y = b h − a t, the powers of t apart.
        let x = [height(a), fixed(b.clone())];
        let y = [height(b), fixed(-a)];
        let one = [fixed(Number::one()), Polynomial::zero()];
        let exponents = (0..=3u32)
            .rev()
            .flat_map(|n| (0..=n).map(move |k| [n - k, k, 3 - n]));
        let mut sums: [Polynomial<K>; 3] = std::array::from_fn(|_| Polynomial::zero());
        for (coefficient, exponents) in self.0.iter().zip(exponents) {
            let mut product = vec![fixed(coefficient.clone())];
            for (factor, times) in [&x, &y, &one].into_iter().zip(exponents) {
                for _ in 0..times {
                    product = times_linear(&product, factor);
                }
            }
            for (sum, part) in sums.iter_mut().zip(product) {
                *sum = &*sum + &part;
            }
        }
        sums.reverse();
        sums
    }

    /// In how many points the line of this height, a part of the curve, meets the rest.
    fn meeting_points(&self, height: &Number<K>) -> Option<usize> {
        let [a, b, ..] = self.0;
        // The derivative across the line, at three of its points.
        let at = |t: i64| {
            let point = [a * height + b * t, b * height - a * t];
            let [x, y, _] = self.at(&point);
            a * x + b * y
        };
        let (below, middle, above) = (at(-1), at(0), at(1));
        let square = (&below + &above) / 2 - &middle;
        let linear = (above - below) / 2;
        let discriminant = linear.square() - 4 * square * middle;
        match discriminant.sign()? {
            Ordering::Greater => Some(2),
            Ordering::Equal => None,
            Ordering::Less => Some(0),
        }
    }

    fn type_of_conic(&self) -> Option<(Option<&'static str>, Option<usize>)> {
        let [.., e, f, g, h, i, j] = self.0;
        let is_circle = e.equals(g) & f.is_zero();
        let is_rectangular = (e + g).is_zero();
        let area = 4 * e * g - f.square();
        let determinant = area * j - e * i.square() + f * h * i - g * h.square();
        let lines = vanish(&[h.clone(), i.clone()]);
        let name = match (is_circle, is_rectangular, determinant.is_zero()) {
            (Truth::Yes, Truth::Yes, _) => match (lines, j.is_zero()) {
                (Truth::No, _) => Some("three-lines"),
                (Truth::Yes, Truth::Yes) => Some("every-point"),
                (Truth::Yes, Truth::No) => None,
                _ => return None,
            },
            (Truth::Yes, Truth::No, Truth::Yes) => Some("three-lines"),
            (Truth::Yes, Truth::No, Truth::No) => Some("line-and-circle"),
            (Truth::No, Truth::Yes, Truth::Yes) => return Some((Some("two-lines"), Some(1))),
            (Truth::No, Truth::Yes, Truth::No) => Some("hyperbola"),
            _ => return None,
        };
        Some((name, Some(0)))
    }

    /// Whether all points of a list are different double points, and so many.
    fn nodes(
        &self,
        name: &str,
        shown: &Value,
        count: Option<usize>,
        sheet: &Sheet<'_>,
    ) -> Result<(), Defect> {
        let place = format!("{name}.nodes");
        let listed = decided(sheet.answer, shown, &place)?.as_array();
        let listed = listed.ok_or_else(|| Defect::wrong(&place, "a list was expected"))?;
        let mut points: Vec<[Number<K>; 2]> = Vec::new();
        for value in listed {
            let value = decided(sheet.answer, value, "nodes")?;
            self.is_double_point(value, &place, sheet)?;
            let shown = point(value, &place, sheet.digits)?;
            let middle = shown
                .each_ref()
                .map(|part| Number::from(part.re.value.clone()));
            let is_new = points.iter().all(|other| {
                let same = middle.iter().zip(other).map(|(a, b)| a.equals(b));
                Truth::all(same).is_no()
            });
            require(is_new, &place, "one point is listed twice")?;
            points.push(middle);
        }
        match count {
            Some(count) => require(listed.len() == count, &place, "there are more or fewer"),
            None => Err(Defect::unchecked(format!("how many {place}"))),
        }
    }

    /// Whether the derivatives and the value are zero, as far as the digits tell.
    fn is_double_point(&self, value: &Value, place: &str, sheet: &Sheet<'_>) -> Result<(), Defect> {
        let shown = point(value, place, sheet.digits)?;
        let [x, y] = shown.each_ref().map(|part| &part.re);
        let is_zero = if x.is_exact() && y.is_exact() {
            let exact = [x, y].map(|part| Number::<K>::from(part.value.clone()));
            !vanish(&self.at(&exact)).is_no()
        } else {
            let balls = [x, y].map(|part| part.ball(sheet.bits));
            let enclosed = self.0.each_ref().map(|c| K::enclosed(c, sheet.bits));
            !vanish(&Curve(&enclosed).at(&balls)).is_no()
        };
        require(is_zero, place, "this is no double point")
    }
}

fn minus<K: Known>(one: &Linear<K>, other: &Linear<K>) -> Linear<K> {
    array::pairs(one, other).map(|(one, other)| one - other)
}

/// A polynomial in t times p + q t.
fn times_linear<K: Known>(
    list: &[Polynomial<K>],
    [p, q]: &[Polynomial<K>; 2],
) -> Vec<Polynomial<K>> {
    let mut product: Vec<Polynomial<K>> = list.iter().map(|part| part * p).collect();
    product.push(Polynomial::zero());
    for (entry, lower) in product.iter_mut().skip(1).zip(list) {
        *entry = &*entry + &(lower * q);
    }
    product
}

/// The sign of the discriminant of a form of degree four, positive for four real zeros or none.
fn discriminant_sign<K: Known>(form: &Polynomial<K>) -> Option<Ordering> {
    let [a, b, c, d, e] = [4, 3, 2, 1, 0].map(|power| form.coefficient(power));
    let square = 12 * &a * &e - 3 * &b * &d + c.square();
    let cube = 72 * &a * &c * &e + 9 * &b * &c * &d
        - 27 * &a * d.square()
        - 27 * &e * b.square()
        - 2 * c.power(3);
    (4 * square.power(3) - cube.square()).sign()
}
