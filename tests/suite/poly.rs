//! Polynomials with relations and their fractions, against the laws and by evaluation.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use std::cmp::Ordering;

use burmester::number::{EXCESSIVE_BITS, Fraction, Kind, Number, Poly, Real, Ring};
use proptest::prelude::*;
use rug::Rational;

type Symbol = Number<Fraction>;

/// x and y free, m positive, (c, s) an angle, r > 0 with r² = x² + m².
fn ring() -> Ring {
    let ring = Ring::free(&["x", "y"]).unwrap();
    let ring = ring
        .with_positive("m")
        .unwrap()
        .with_angle("c", "s")
        .unwrap();
    let [x, _, m] = ring.numbers();
    let square = x.square() + m.square();
    ring.with_root("r", true, square.0.polynomial().unwrap())
        .unwrap()
}

/// Values that satisfy the relations of [`ring`]: x and r from m and the tangent of half an angle.
fn values(point: &[i64; 4]) -> [Rational; 6] {
    let [u, t, y, m] = point.map(Rational::from);
    let t = t / 97u32;
    let angle = |t: &Rational| {
        let square = Rational::from(t * t);
        let below = Rational::from(1 + &square);
        (
            Rational::from(1 - &square) / &below,
            Rational::from(2 * t) / &below,
            square,
        )
    };
    let (c, s, _) = angle(&t);
    // m : x : r = 2u : u² − 1 : u² + 1
    let square = Rational::from(&u * &u);
    let scale = m / Rational::from(2 * &u);
    let m = Rational::from(2 * &u) * &scale;
    let x = Rational::from(&square - 1) * &scale;
    let r = Rational::from(&square + 1) * &scale;
    [x, y, m, c, s, r]
}

fn points() -> impl Strategy<Value = [i64; 4]> {
    [2..1000i64, -1000..1000i64, -1000..1000i64, 1..1000i64]
}

type Recipe = Vec<(i64, [u8; 6])>;

fn recipes() -> impl Strategy<Value = Recipe> {
    let exponents = [0..3u8, 0..3u8, 0..2u8, 0..2u8, 0..2u8, 0..2u8];
    prop::collection::vec((-9..10i64, exponents), 0..4)
}

fn build(ring: &Ring, recipe: &Recipe) -> Symbol {
    let variables: [Symbol; 6] = ring.numbers();
    let terms = recipe.iter().map(|(coefficient, exponents)| {
        let powers = variables
            .iter()
            .zip(exponents)
            .map(|(v, &e)| v.power(e.into()));
        powers.product::<Symbol>() * *coefficient
    });
    terms.sum()
}

fn same(a: &Symbol, b: &Symbol) -> bool {
    a.equals(b).is_yes()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn ring_laws(a in recipes(), b in recipes(), c in recipes()) {
        let ring = ring();
        let [a, b, c] = [a, b, c].map(|recipe| build(&ring, &recipe));
        prop_assert!(same(&(&a + &b), &(&b + &a)));
        prop_assert!(same(&(&a * &b), &(&b * &a)));
        prop_assert!(same(&(&a * &(&b * &c)), &(&(&a * &b) * &c)));
        prop_assert!(same(&(&a * &(&b + &c)), &(&a * &b + &a * &c)));
        prop_assert!((&a - &a).is_zero().is_yes());
        prop_assert!(same(&-(-&a), &a));
    }

    #[test]
    fn a_product_divides(a in recipes(), b in recipes()) {
        let ring = ring();
        let [a, b] = [a, b].map(|recipe| build(&ring, &recipe));
        let product = (&a * &b).0.polynomial().unwrap().clone();
        let quotient = product.divide_exactly(b.0.polynomial().unwrap());
        if b.is_zero().is_yes() {
            prop_assert!(quotient.is_none());
            prop_assert!(!(&a / &b).has_value());
        } else {
            prop_assert_eq!(&quotient.unwrap(), a.0.polynomial().unwrap());
        }
    }

    #[test]
    fn field_laws(a in recipes(), b in recipes(), c in recipes()) {
        let ring = ring();
        let [a, b, c] = [a, b, c].map(|recipe| build(&ring, &recipe));
        prop_assume!(b.is_zero().is_no() && c.is_zero().is_no());
        let quotient = &a / &b;
        prop_assert!(quotient.has_value());
        prop_assert!(same(&(&quotient * &b), &a));
        prop_assert!(same(&(&a / &b / &c), &(&a / (&b * &c))));
        prop_assert!(same(&(&quotient + &a / &c), &(&a * (&b + &c) / (&b * &c))));
        if a.is_zero().is_no() {
            prop_assert!(same(&quotient.inverse(), &(&b / &a)));
        }
    }

    #[test]
    fn evaluation_is_a_homomorphism(
        a in recipes(), b in recipes(), c in recipes(), point in points()
    ) {
        let ring = ring();
        let values = values(&point);
        let [a, b, c] = [a, b, c].map(|recipe| build(&ring, &recipe));
        let at = |number: &Symbol| number.0.evaluate(&values);
        let [va, vb, vc] = [&a, &b, &c].map(|number| at(number).unwrap());
        prop_assert_eq!(at(&(&a + &b)).unwrap(), Rational::from(&va + &vb));
        prop_assert_eq!(at(&(&a - &b)).unwrap(), Rational::from(&va - &vb));
        prop_assert_eq!(at(&(&a * &b)).unwrap(), Rational::from(&va * &vb));
        let number = (&a + &b / &c) / (&b + &a / &c);
        let below = Rational::from(&vb * &vc) + &va;
        // The symbolic denominator may vanish at a point where the quotient does not.
        if !vc.is_zero() && !below.is_zero() && let Some(value) = at(&number) {
            prop_assert_eq!(value, (Rational::from(&va * &vc) + &vb) / below);
        }
    }

    #[test]
    fn squares_have_their_root(a in recipes()) {
        let a = build(&ring(), &a);
        let a = a.0.polynomial().unwrap();
        let root = a.mul(a).unwrap().sqrt().unwrap();
        prop_assert!(root == *a || root == a.negated());
        let more = a.mul(a).unwrap().add(&Poly::from(1)).unwrap();
        if let Some(root) = more.sqrt() {
            prop_assert_eq!(root.mul(&root).unwrap(), more);
        }
    }

    #[test]
    fn a_sign_is_that_of_every_value(a in recipes(), b in recipes(), point in points()) {
        let ring = ring();
        let [a, b] = [a, b].map(|recipe| build(&ring, &recipe));
        for number in [a.square() / &b, &a / &b, (a.square() + b.square()) * (1 - ring.numbers::<4>()[3].square())] {
            if let (Some(sign), Some(value)) = (number.sign(), number.0.evaluate(&values(&point))) {
                prop_assert!(value.cmp0() == sign || value.is_zero());
            }
        }
    }

    #[test]
    fn parts_make_the_whole(a in recipes(), index in 0..6usize) {
        let ring = ring();
        let a = build(&ring, &a);
        let a = a.0.polynomial().unwrap();
        let variable = Poly::variable(&ring, index).unwrap();
        prop_assert_eq!(&a.substitute(index, &variable).unwrap(), a);
        let mut sum = Poly::from(0);
        for power in 0..=a.degree_in(index) {
            let part = a.coefficient_of(index, power).mul(&variable.power(power.into()).unwrap());
            sum = sum.add(&part.unwrap()).unwrap();
        }
        prop_assert_eq!(&sum, a);
        let content = Poly::from(a.content());
        let whole = a.primitive_part().mul(&content).unwrap();
        prop_assert!(whole == *a || whole == a.negated());
    }
}

#[test]
fn angles_add() {
    let ring = Ring::empty()
        .with_angle("c_1", "s_1")
        .unwrap()
        .with_angle("c_2", "s_2")
        .unwrap();
    let [c1, s1, c2, s2] = ring.numbers();
    assert!(same(&(c1.square() + s1.square()), &Symbol::one()));
    let (c, s) = (&c1 * &c2 - &s1 * &s2, &s1 * &c2 + &c1 * &s2);
    assert!(same(&(c.square() + s.square()), &Symbol::one()));
    let (t1, t2) = (&s1 / &c1, &s2 / &c2);
    assert!(same(&(&s / &c), &((&t1 + &t2) / (1 - &t1 * &t2))));
    // tan α/2 in two ways, the second with a sine below.
    assert!(same(&(&s1 / (1 + &c1)), &((1 - &c1) / &s1)));
    assert!(!same(&(&s1 / (1 + &c1)), &((1 + &c1) / &s1)));
}

#[test]
fn brahmagupta() {
    let ring = Ring::free(&["a", "b", "c", "d", "n"]).unwrap();
    let [a, b, c, d, n] = ring.numbers();
    let form = |x: &Symbol, y: &Symbol| x.square() + &n * y.square();
    let product = form(&(&a * &c - &n * &b * &d), &(&a * &d + &b * &c));
    assert!(same(&(form(&a, &b) * form(&c, &d)), &product));
}

#[test]
fn heron() {
    let ring = Ring::empty().with_positive("a").unwrap();
    let ring = ring.with_positive("b").unwrap().with_positive("c").unwrap();
    let [a, b, c] = ring.numbers();
    let p = (&a + &b + &c) / 2;
    let area = Fraction::adjoin_root("A", &(&p * (&p - &a) * (&p - &b) * (&p - &c)));
    assert_eq!(area.sign(), Some(Ordering::Greater));
    // With the foot of the altitude on c: x = (b² + c² − a²)/2c, h = 2A/c.
    let x = (b.square() + c.square() - a.square()) / (2 * &c);
    let h = 2 * &area / &c;
    assert!(same(&(x.square() + h.square()), &b.square()));
    assert!(same(&((&c - &x).square() + h.square()), &a.square()));
    // The tangent law of half angles: tan α/2 · tan β/2 = (p − c)/p.
    let r = &area / &p;
    assert!(same(
        &(&r / (&p - &a) * (&r / (&p - &b))),
        &((&p - &c) / &p)
    ));
}

#[test]
fn nested_definitions_stay_small() {
    let names: Vec<String> = (1..=12).map(|i| format!("x_{i}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let x: [Symbol; 12] = Ring::free(&names).unwrap().numbers();
    let fraction = x
        .iter()
        .rev()
        .skip(1)
        .fold(x[11].clone(), |inner, x| x + 1 / inner);
    // Euler's continuants have a Fibonacci number of terms.
    assert_eq!(fraction.0.number_of_terms(), 233 + 144);
    // Back again, from the outside.
    let back = x.iter().take(11).fold(fraction, |outer, x| 1 / (outer - x));
    assert!(same(&back, &x[11]));
    assert_eq!(back.0.number_of_terms(), 1);
}

fn determinant(rows: &[Vec<Symbol>]) -> Symbol {
    if rows.is_empty() {
        return Symbol::one();
    }
    let minors = (0..rows.len()).map(|column| {
        let minor: Vec<Vec<Symbol>> = rows[1..]
            .iter()
            .map(|row| {
                row.iter()
                    .enumerate()
                    .filter(|(i, _)| *i != column)
                    .map(|(_, x)| x.clone())
                    .collect()
            })
            .collect();
        let product = &rows[0][column] * determinant(&minor);
        if column % 2 == 0 { product } else { -product }
    });
    minors.sum()
}

#[test]
fn resultant_of_two_conics() {
    let ring = Ring::free(&["a", "b", "c", "d", "e", "f"]).unwrap();
    let [a, b, c, d, e, f] = ring.numbers();
    let o = Symbol::zero();
    let rows = [
        [&a, &b, &c, &o],
        [&o, &a, &b, &c],
        [&d, &e, &f, &o],
        [&o, &d, &e, &f],
    ];
    let rows = rows.map(|row| row.map(Clone::clone).to_vec());
    let resultant = (&a * &f - &c * &d).square() - (&a * &e - &b * &d) * (&b * &f - &c * &e);
    assert!(same(&determinant(&rows), &resultant));
    assert_eq!(resultant.0.number_of_terms(), 7);
}

#[test]
fn rings_extend_and_do_not_mix() {
    let base = Ring::free(&["x"]).unwrap();
    let (left, right) = (
        base.with_variable("y").unwrap(),
        base.with_variable("y").unwrap(),
    );
    let [x] = base.numbers();
    let (y, z) = (Symbol::named(&left, "y"), Symbol::named(&right, "y"));
    assert!((&x + &y).has_value());
    assert_eq!((&x * &y).to_string(), "x y");
    assert!(!(&y + &z).has_value());
    assert!(!((1 / &y) * (1 / &z)).has_value());
    assert!((&y - &z).is_zero() == burmester::number::Truth::Unknown);
    assert!(base.is_prefix_of(&left) && !left.is_prefix_of(&right));
    assert!(!Symbol::variable(&base, 1).has_value());
    assert!(base.with_variable("x").is_none());
    let names: Vec<String> = (0..33).map(|i| i.to_string()).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    assert!(Ring::free(&names).is_none());
    assert_eq!(Ring::free(&names[..32]).unwrap().len(), 32);
}

#[test]
fn what_is_too_large_has_no_value() {
    let ring = Ring::free(&["x", "y"]).unwrap();
    let [x, y] = ring.numbers();
    assert!(x.power(127).has_value());
    assert!(!(x.power(127) * &x).has_value());
    assert!(!((1 + &x).power(100) * (1 + &x * &y).power(28)).has_value());
    assert!((x.power(127) / x.power(126)).equals(&x).is_yes());
    let wide = Ring::free(&["a", "b", "c", "d", "e", "f", "g", "h", "i", "j"]).unwrap();
    let [a, b, c, d, e, f, g, h, i, j] = wide.numbers();
    let (first, second) = (
        (1 + a + b + c + d + e).power(6),
        (1 + f + g + h + i + j).power(9),
    );
    assert_eq!(first.0.number_of_terms(), 462);
    assert_eq!(second.0.number_of_terms(), 2002);
    assert!((&first * &second).has_value());
    // The square of the first has 6188 terms, and no two products have the same monomial.
    assert!(!(&second * &first.square()).has_value());
}

#[test]
fn coefficients_grow() {
    let ring = Ring::free(&["x"]).unwrap();
    let [x] = ring.numbers();
    let big = (x + i64::MAX).power(4);
    let value = big.0.evaluate(&[Rational::from(1)]).unwrap();
    assert_eq!(
        value.to_string(),
        (rug::Integer::from(1) << 252u32).to_string()
    );
    let root = big.sqrt().sqrt();
    assert!(!root.has_value(), "its sign is not known");
}

#[test]
fn undefined_operations() {
    let [x, c, s] = {
        let ring = Ring::free(&["x"]).unwrap().with_angle("c", "s").unwrap();
        ring.numbers()
    };
    assert!(!(1 / (c.square() + s.square() - 1)).has_value());
    assert!(!(&x / (&x - &x)).has_value());
    assert!(!((&x / 0) + 1).has_value());
    assert_eq!((&x / 0).to_string(), "no value");
    assert_eq!((x / 0).sign(), None);
}

#[test]
fn signs() {
    let ring = Ring::empty()
        .with_positive("m")
        .unwrap()
        .with_variable("x")
        .unwrap();
    let ring = ring.with_angle("c", "s").unwrap();
    let [m, x, c, s] = ring.numbers();
    assert_eq!((&m + &x * &x).sign(), Some(Ordering::Greater));
    assert_eq!((-1 / (&m * x.square() + 1)).sign(), Some(Ordering::Less));
    assert_eq!((&m - &m).sign(), Some(Ordering::Equal));
    assert_eq!((&m - 1).sign(), None);
    assert_eq!(x.sign(), None);
    assert_eq!((&m - &x).square().sign(), Some(Ordering::Greater));
    assert_eq!((1 / (&m - &x).square()).sign(), Some(Ordering::Greater));
    assert_eq!((1 / (&m - &x)).sign(), None);
    assert_eq!((&m * s.square()).sign(), Some(Ordering::Greater));
    assert_eq!((1 - &c * &c).sign(), Some(Ordering::Greater));
    assert_eq!((1 - &c).sign(), None);
    let root = Fraction::adjoin_root("r", &(m.square() + x.square()));
    assert_eq!((&root - &m).sign(), Some(Ordering::Greater));
    assert_eq!((&root - &x).sign(), None);
}

#[test]
fn roots_in_the_ring() {
    let ring = ring();
    let [x, _, m, c, s, r] = ring.numbers();
    assert!(same(&m.square().sqrt(), &m));
    assert!(same(&(4 * m.square() / 9).sqrt(), &(2 * &m / 3)));
    assert!(same(&(x.square() + m.square()).sqrt(), &r));
    assert!(same(&r.square().sqrt(), &r));
    // (m + r)² has mixed terms; the root is found modulo the relation.
    assert!(same(&(&m + &r).square().sqrt(), &(&m + &r)));
    assert!(same(&(1 / (&m + &r)).square().sqrt().inverse(), &(&m + &r)));
    assert!(!x.square().sqrt().has_value());
    assert!(!s.square().sqrt().has_value());
    assert!(!(1 + &c).sqrt().has_value());
    assert!(same(&(x.square().square()).sqrt(), &x.square()));
    assert!(same(&(-&m).abs(), &m));
}

#[test]
fn adjoined_roots() {
    let ring = Ring::empty()
        .with_positive("m")
        .unwrap()
        .with_variable("x")
        .unwrap();
    let [m, x] = ring.numbers();
    for radicand in [
        &m + 1,
        &m / 3,
        1 / (&m + 2),
        &x / 12,
        m.square() + x.square(),
    ] {
        let root = Fraction::adjoin_root("y", &radicand);
        assert!(same(&root.square(), &radicand), "{radicand}");
        assert_eq!(root.sign(), Some(Ordering::Greater));
        assert!(same(&radicand.square(), &root.power(4)));
        // Asked for again in the new ring, the root is there already.
        let again = Fraction::adjoin_root_in(root.0.ring().unwrap(), "z", &radicand);
        assert!(same(&again, &root));
    }
    let carried = Fraction::adjoin_root("y", &(&m / &x));
    assert!(same(&carried.square(), &(&m / &x)));
    assert_eq!(carried.sign(), None);
    let carried = Fraction::adjoin_root("y", &(8 / (&m * x.square())));
    assert!(same(&carried.square(), &(8 / (&m * x.square()))));
    assert_eq!(carried.sign(), None);
    // Squares give their root, and none where its sign is open.
    assert!(same(
        &Fraction::adjoin_root("y", &(&m + 1).square()),
        &(&m + 1)
    ));
    assert!(!Fraction::adjoin_root("y", &x.square()).has_value());
    assert!(!Fraction::adjoin_root("y", &(-&m - 1)).has_value());
    assert!(!Fraction::adjoin_root("x", &(&m + &x)).has_value());
    assert!(
        Fraction::adjoin_root("y", &Symbol::zero())
            .is_zero()
            .is_yes()
    );
    // Nested: √(2 + √3) = (√6 + √2)/2 lies in no new field once √2 and √3 are there.
    let two = Fraction::adjoin_root("t", &Symbol::from(2));
    let three = Fraction::adjoin_root_in(two.0.ring().unwrap(), "h", &Symbol::from(3));
    let nested = Fraction::adjoin_root_in(three.0.ring().unwrap(), "n", &(2 + &three));
    assert!(same(&nested, &(&two * (1 + &three) / 2)));
}

#[test]
fn sixteen_angles() {
    let names: Vec<[String; 2]> = (0..16)
        .map(|i| [format!("c_{i}"), format!("s_{i}")])
        .collect();
    let ring = names
        .iter()
        .try_fold(Ring::empty(), |ring, [c, s]| ring.with_angle(c, s))
        .unwrap();
    assert_eq!(ring.len(), 32);
    // The square of every sine is taken already, also those of their products.
    let [c, s, d, t] = ring.numbers();
    let both = (1 - c.square()) * (1 - d.square());
    assert!(
        ring.with_root("y", false, both.0.polynomial().unwrap())
            .is_none()
    );
    let root = both.0.polynomial().unwrap().sqrt().unwrap();
    assert!(same(&root.into(), &(s * t)));
}

#[test]
fn squares_are_no_new_roots() {
    let ring = Ring::empty().with_angle("c", "s").unwrap();
    let [c, s] = ring.numbers();
    let open = |radicand: &Symbol| {
        ring.with_root("y", false, radicand.0.polynomial().unwrap())
            .is_some()
    };
    assert!(open(&(1 - &c)) && open(&(1 + &s)) && open(&Symbol::from(-1)) && open(&s));
    assert!(!open(&(1 - &c * &c)) && !open(&(&c * &c)) && !open(&Symbol::zero()));
    // 1 + 2cs = (c + s)²; 2 − 2c² = 2s² is none.
    assert!(!open(&(1 + 2 * &c * &s)) && open(&(2 - 2 * &c * &c)));
}

#[test]
fn text() {
    let ring = Ring::free(&["m", "n", "p", "q", "d"]).unwrap();
    let [m, n, p, q, d] = ring.numbers();
    assert_eq!(
        ((&m * &p + &n * &q) / d.square()).to_string(),
        "(m p + n q)/(d^2)"
    );
    assert_eq!((&m / 2).to_string(), "m/2");
    assert_eq!((1 / (&m - &n)).to_string(), "-1/(-m + n)");
    assert_eq!((3 - 2 * &m).to_string(), "-2 m + 3");
}

#[test]
fn quarter_turns() {
    let (c, s) = Fraction::cos_sin_of_degrees(&Rational::from(-90), &()).unwrap();
    assert!(Number(c).is_zero().is_yes());
    assert!(Number(s).equals(&Symbol::from(-1)).is_yes());
    assert!(Fraction::cos_sin_of_degrees(&Rational::from(60), &()).is_none());
    assert!(same(
        &Number(Fraction::constant(Rational::from((1, 3)))),
        &Symbol::ratio(1, 3)
    ));
}

#[test]
fn what_is_too_large_says_so() {
    let largest = Rational::from(1) << (EXCESSIVE_BITS - 1);
    for (constant, excessive) in [
        (Rational::from(3), false),
        (largest.clone(), false),
        (largest.clone() << 1, true),
        (largest.recip() >> 1, true),
    ] {
        let x = Number::<Fraction>::variable(&ring(), 0);
        let number = x * Number(Fraction::constant(constant.clone()));
        assert_eq!(number.0.is_excessive(), excessive);
    }
}

#[test]
fn rings_know_their_variables() {
    let empty = Ring::empty();
    assert!(empty.is_empty() && empty.is_prefix_of(&ring()));
    assert!(!ring().is_empty() && !ring().is_prefix_of(&empty));
    assert_eq!(ring().len(), 6);
    assert_eq!(ring().position("m"), Some(2));
    assert_eq!(ring().position("z"), None);
}
