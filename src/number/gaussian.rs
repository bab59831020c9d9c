//! Complex numbers by integers, changed in place.

use rug::{Assign, Integer};

use super::{Complex, Number, count};

/// re + i·im with whole parts. A place that has had a number of some size takes another one without
/// allocation; what multiplies by zero costs next to nothing, so that real ones are as quick as integers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Gaussian {
    /// Real part.
    pub re: Integer,
    /// Imaginary part.
    pub im: Integer,
}

impl Gaussian {
    /// 0, with room for parts of so many bits.
    pub fn with_room(bits: u32) -> Self {
        let [re, im] = [(), ()].map(|()| Integer::with_capacity(count::from_u32(bits)));
        Gaussian { re, im }
    }

    /// Whether nothing is imaginary.
    pub fn is_real(&self) -> bool {
        self.im.is_zero()
    }

    /// How many bits the longer part has.
    pub fn significant_bits(&self) -> u32 {
        self.re.significant_bits().max(self.im.significant_bits())
    }

    /// An integer times 2^places.
    pub fn set_integer(&mut self, integer: &Integer, places: u32) {
        self.re.assign(integer << places);
        self.im.assign(0);
    }

    /// Another one times 2^places, rounded down.
    pub fn set_shifted(&mut self, other: &Gaussian, places: i32) {
        self.re.assign(&other.re << places);
        self.im.assign(&other.im << places);
    }

    /// Times 2^places, rounded down.
    pub fn shift(&mut self, places: i32) {
        self.re <<= places;
        self.im <<= places;
    }

    /// More by another one.
    pub fn add(&mut self, other: &Gaussian) {
        self.re += &other.re;
        self.im += &other.im;
    }

    /// Less by another one.
    pub fn subtract(&mut self, other: &Gaussian) {
        self.re -= &other.re;
        self.im -= &other.im;
    }

    /// An integer times another one.
    pub fn set_multiple(&mut self, factor: &Integer, other: &Gaussian) {
        self.re.assign(factor * &other.re);
        self.im.assign(factor * &other.im);
    }

    /// More by an integer times another one.
    pub fn add_multiple(&mut self, factor: &Integer, other: &Gaussian) {
        self.re += factor * &other.re;
        self.im += factor * &other.im;
    }

    /// Less by an integer times another one.
    pub fn subtract_multiple(&mut self, factor: &Integer, other: &Gaussian) {
        self.re -= factor * &other.re;
        self.im -= factor * &other.im;
    }

    /// More by a product.
    pub fn add_product(&mut self, a: &Gaussian, b: &Gaussian) {
        if let Some(product) = long_product(a, b) {
            return self.add(&product);
        }
        self.re += &a.re * &b.re;
        self.re -= &a.im * &b.im;
        self.im += &a.re * &b.im;
        self.im += &a.im * &b.re;
    }

    /// Less by a product.
    pub fn subtract_product(&mut self, a: &Gaussian, b: &Gaussian) {
        if let Some(product) = long_product(a, b) {
            return self.subtract(&product);
        }
        self.re -= &a.re * &b.re;
        self.re += &a.im * &b.im;
        self.im -= &a.re * &b.im;
        self.im -= &a.im * &b.re;
    }

    /// a b.
    pub fn set_product(&mut self, a: &Gaussian, b: &Gaussian) {
        if let Some(product) = long_product(a, b) {
            *self = product;
            return;
        }
        self.re.assign(&a.re * &b.re);
        self.re -= &a.im * &b.im;
        self.im.assign(&a.re * &b.im);
        self.im += &a.im * &b.re;
    }

    /// a b + c d.
    pub fn set_sum(&mut self, [a, b]: [&Gaussian; 2], [c, d]: [&Gaussian; 2]) {
        self.set_product(a, b);
        self.add_product(c, d);
    }

    /// a b − c d.
    pub fn set_minor(&mut self, [a, b]: [&Gaussian; 2], [c, d]: [&Gaussian; 2]) {
        self.set_product(a, b);
        self.subtract_product(c, d);
    }

    /// Times 2^power in machine floats, to a unit in the last place: 0 below their range and infinite beyond.
    pub fn to_floats(&self, power: i64) -> Number<Complex<f64>> {
        let [re, im] = [&self.re, &self.im].map(|part| Number(scaled(part, power)));
        Number::complex(re, im)
    }

    /// By an integer other than 0, each part to less than one unit.
    pub fn divide_by_integer(&mut self, divisor: &Integer) {
        self.re /= divisor;
        self.im /= divisor;
    }

    /// Times 2^up and by another one that is not 0, of which about so many bits matter, each part to a few
    /// units.
    pub fn divide(list: &mut [Gaussian; 2], divisor: &Gaussian, up: i32, bits: u32) {
        if divisor.is_real() {
            for z in list {
                z.shift(up);
                z.divide_by_integer(&divisor.re);
            }
            return;
        }
        let mut norm = Integer::from(divisor.re.square_ref());
        norm += divisor.im.square_ref();
        let longer = norm.significant_bits().saturating_sub(bits);
        norm >>= longer;
        let up = up - i32::try_from(longer).unwrap_or(0);
        let conjugate = Gaussian {
            re: divisor.re.clone(),
            im: Integer::from(-&divisor.im),
        };
        let mut product = Gaussian::default();
        for z in list {
            product.set_product(z, &conjugate);
            product.shift(up);
            product.divide_by_integer(&norm);
            std::mem::swap(z, &mut product);
        }
    }

    /// The sum with i times another one, or with −i times it.
    fn and_turned(&self, other: &Gaussian, backwards: bool) -> Gaussian {
        let [mut re, mut im] = [self.re.clone(), self.im.clone()];
        if backwards {
            re += &other.im;
            im -= &other.re;
        } else {
            re -= &other.im;
            im += &other.re;
        }
        Gaussian { re, im }
    }
}

/// p = xu + yv and q = yu − xv.
///
/// Of long ones p + iq = (x + iy)(u − iv) and p − iq = (x − iy)(u + iv), of which the second is the conjugate
/// of the first where all are real.
pub fn products([x, y]: [&Gaussian; 2], [u, v]: [&Gaussian; 2], [p, q]: &mut [Gaussian; 2]) {
    let all = [x, y, u, v];
    if all.iter().any(|z| z.significant_bits() < LONG) {
        p.set_sum([x, u], [y, v]);
        q.set_minor([y, u], [x, v]);
        return;
    }
    let sum = |backwards: bool| {
        let (z, m) = (x.and_turned(y, backwards), u.and_turned(v, !backwards));
        let mut product = Gaussian::default();
        product.set_product(&z, &m);
        product
    };
    let first = sum(false);
    if all.iter().all(|z| z.is_real()) {
        p.re.assign(&first.re);
        q.re.assign(&first.im);
        p.im.assign(0);
        q.im.assign(0);
        return;
    }
    let second = sum(true);
    p.re.assign(&first.re + &second.re);
    p.im.assign(&first.im + &second.im);
    q.re.assign(&first.im - &second.im);
    q.im.assign(&second.re - &first.re);
    for z in [p, q] {
        z.shift(-1);
    }
}

/// Bits from which on it pays to have fewer products and more sums.
const LONG: u32 = 1200;

/// An integer times 2^power, to a unit in the last place: 0 below the range of floats and infinite beyond.
pub fn scaled(integer: &Integer, power: i64) -> f64 {
    let (mantissa, bits) = integer.to_f64_exp();
    match i32::try_from(i64::from(bits) + power) {
        Ok(exponent @ -1000..1000) => mantissa * 2f64.powi(exponent),
        Ok(..-1000) => 0.0,
        _ if mantissa == 0.0 => 0.0,
        _ => f64::INFINITY.copysign(mantissa),
    }
}

/// Three products of integers instead of four, where these take most of the time.
fn long_product(a: &Gaussian, b: &Gaussian) -> Option<Gaussian> {
    if a.is_real() || b.is_real() || a.significant_bits().min(b.significant_bits()) < LONG {
        return None;
    }
    let re = Integer::from(&a.re * &b.re);
    let both = Integer::from(&a.im * &b.im);
    let mut im = Integer::from(&a.re + &a.im) * Integer::from(&b.re + &b.im);
    im -= &re;
    im -= &both;
    Some(Gaussian { re: re - both, im })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gaussian(re: i64, im: i64) -> Gaussian {
        Gaussian {
            re: re.into(),
            im: im.into(),
        }
    }

    #[test]
    fn products_and_quotients() {
        let parts = [0, 1, -1, 3, -7, 20];
        let all = || {
            parts
                .iter()
                .flat_map(|re| parts.map(|im| gaussian(*re, im)))
        };
        for a in all() {
            for b in all() {
                let re = Integer::from(&a.re * &b.re) - Integer::from(&a.im * &b.im);
                let im = Integer::from(&a.re * &b.im) + Integer::from(&a.im * &b.re);
                let product = Gaussian { re, im };
                let mut sum = a.clone();
                sum.add_product(&a, &b);
                sum.subtract(&a);
                assert_eq!(sum, product);
                sum.subtract_product(&a, &b);
                assert_eq!(sum, Gaussian::default());
                sum.set_minor([&a, &b], [&b, &a]);
                assert_eq!(sum, Gaussian::default());
                sum.set_sum([&a, &b], [&b, &a]);
                sum.subtract(&product);
                assert_eq!(sum, product);
                let mut both = <[Gaussian; 2]>::default();
                products([&a, &b], [&b, &a], &mut both);
                sum.set_minor([&b, &b], [&a, &a]);
                let mut twice = product.clone();
                twice.add(&product);
                assert_eq!(both, [twice, sum.clone()]);
                if b != Gaussian::default() {
                    let mut quotients = [product.clone(), product];
                    Gaussian::divide(&mut quotients, &b, 0, 100);
                    assert_eq!(quotients, [a.clone(), a.clone()]);
                }
            }
        }
    }

    #[test]
    fn long_products_are_the_same() {
        let long = |z: &Gaussian| {
            let mut moved = Gaussian::default();
            moved.set_shifted(z, 2000);
            moved.add(&gaussian(7, -3));
            moved
        };
        let [a, b] = [long(&gaussian(5, -9)), long(&gaussian(-3, 4))];
        let re = Integer::from(&a.re * &b.re) - Integer::from(&a.im * &b.im);
        let im = Integer::from(&a.re * &b.im) + Integer::from(&a.im * &b.re);
        let mut product = Gaussian::default();
        product.set_product(&a, &b);
        assert_eq!(product, Gaussian { re, im });
        product.subtract_product(&b, &a);
        product.add_product(&a, &b);
        product.subtract_product(&a, &b);
        assert_eq!(product, Gaussian::default());
        for [a, b] in [[&a, &b], [&real(&a), &real(&b)]] {
            let mut both = <[Gaussian; 2]>::default();
            products([a, b], [b, b], &mut both);
            let mut own = <[Gaussian; 2]>::default();
            own[0].set_sum([a, b], [b, b]);
            own[1].set_minor([b, b], [a, b]);
            assert_eq!(both, own);
        }
        let mut quotients = [product.clone(), product];
        quotients[0].set_product(&a, &b);
        Gaussian::divide(&mut quotients, &b, 0, 1000);
        quotients[0].subtract(&a);
        assert!(quotients[0].significant_bits() < 1020 && quotients[1] == Gaussian::default());
    }

    fn real(z: &Gaussian) -> Gaussian {
        Gaussian {
            re: z.re.clone(),
            im: Integer::new(),
        }
    }

    #[test]
    fn floats_of_all_sizes() {
        let z = Gaussian {
            re: Integer::from(-3) << 2000,
            im: Integer::from(5),
        };
        let parts = |power| {
            let floats = z.to_floats(power);
            [floats.re().0, floats.im().0]
        };
        assert_eq!(parts(-2000)[0], -3.0);
        assert_eq!(parts(1), [f64::NEG_INFINITY, 10.0]);
        assert_eq!(parts(-1200)[1], 0.0);
    }

    #[test]
    fn multiples_and_places() {
        let z = gaussian(5, -9);
        let mut sum = gaussian(1, 1);
        sum.add_multiple(&Integer::from(3), &z);
        assert_eq!(sum, gaussian(16, -26));
        sum.subtract_multiple(&Integer::from(2), &z);
        assert_eq!(sum, gaussian(6, -8));
        let mut multiple = Gaussian::default();
        multiple.set_multiple(&Integer::from(-2), &z);
        assert_eq!(multiple, gaussian(-10, 18));
        let mut moved = Gaussian::default();
        moved.set_shifted(&sum, 2);
        assert_eq!(moved, gaussian(24, -32));
        moved.shift(-3);
        assert_eq!((moved.significant_bits(), &moved), (3, &gaussian(3, -4)));
        moved.add(&z);
        assert_eq!(moved, gaussian(8, -13));
        moved.set_integer(&Integer::from(-3), 4);
        assert!(moved.is_real() && moved == gaussian(-48, 0));
    }
}
