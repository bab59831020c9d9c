//! Chapter III: two conics and their eliminant.

use crate::formula::Bindings;
use crate::number::univariate::Polynomial;
use crate::number::{Number, Real};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const ELIMINANT: Scene = scene!(
    "tesar1964/eliminant",
    "Any two conics in which the square of the ordinate has the factor 1, and the polynomial in the \
     abscissa that vanishes where they meet: their resultant.",
    build_eliminant,
    [
        "a": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "b": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "c": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "d": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "e": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "f": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "g": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "h": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "k": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "l": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "R_0": "coefficient of x^0 in the eliminant of both conics",
        "R_1": "coefficient of x^1 in the eliminant of both conics",
        "R_2": "coefficient of x^2 in the eliminant of both conics",
        "R_3": "coefficient of x^3 in the eliminant of both conics",
        "R_4": "coefficient of x^4 in the eliminant of both conics",
    ]
);

pub const KNOWN_ROOTS: Scene = scene!(
    "tesar1964/two-known-roots",
    "Two conics through two known points, and the polynomial for the abscissae of the two others.",
    build_known_roots,
    not symbolic: "a quotient of polynomials in fourteen free symbols",
    [
        "a": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "b": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "c": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "d": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "e": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "f": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "g": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "h": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "k": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "l": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "x_{o,a}": "coordinate of one known point: less the root",
        "x_{o,b}": "coordinate of the other known point",
        "z_1": "any number",
        "z_0": "any number that is not zero",
        "rest": "the eliminant at z_1/z_0, divided by its leading coefficient and by the factors of the known roots",
        "E": "linear coefficient of this polynomial in z_1/z_0",
        "F": "its constant",
    ]
);

pub const COMMON_POINT: Scene = scene!(
    "tesar1964/common-point",
    "Two conics through a point.",
    build_common_point,
    [
        "a": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "b": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "c": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "d": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "e": "coefficient of the first conic y^2 + (a x + b) y + (c x^2 + d x + e)",
        "f": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "g": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "h": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "k": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "l": "coefficient of the second conic y^2 + (f x + g) y + (h x^2 + k x + l)",
        "Z_0": "common factor of a common point",
        "Z_1": "abscissa of the common point, times Z_0",
        "Z_2": "ordinate of the common point, times Z_0",
    ]
);

/// y² + (p x + q) y + (r x² + s x + t)
struct Conic<K> {
    linear: Polynomial<K>,
    constant: Polynomial<K>,
}

impl<K: Real> Conic<K> {
    /// By p, q, r, s, t.
    fn new([p, q, r, s, t]: [Number<K>; 5]) -> Self {
        Conic {
            linear: Polynomial::new(vec![q, p]),
            constant: Polynomial::new(vec![t, s, r]),
        }
    }

    /// Through points: s and t, or t alone, are what is left of the conic with these other letters.
    fn value(&self, x: &Number<K>, y: &Number<K>) -> Number<K> {
        y.square() + self.linear.evaluate(x) * y + self.constant.evaluate(x)
    }

    fn bind(&self, names: [&str; 5], bindings: &mut Bindings<K>) {
        let coefficients = [
            self.linear.coefficient(1),
            self.linear.coefficient(0),
            self.constant.coefficient(2),
            self.constant.coefficient(1),
            self.constant.coefficient(0),
        ];
        for (name, coefficient) in names.into_iter().zip(coefficients) {
            bindings.bind(name, coefficient);
        }
    }
}

const FIRST: [&str; 5] = ["a", "b", "c", "d", "e"];
const SECOND: [&str; 5] = ["f", "g", "h", "k", "l"];

/// The resultant of y² + By + C and y² + B'y + C' is (C − C')² + (B − B')(BC' − B'C).
fn eliminant<K: Real>(first: &Conic<K>, second: &Conic<K>) -> Polynomial<K> {
    let (b, c) = (&first.linear, &first.constant);
    let (b1, c1) = (&second.linear, &second.constant);
    let difference = c - c1;
    &difference * &difference + &(b - b1) * &(b * c1 - b1 * c)
}

fn letters<K: Real>(names: [&str; 5], free: &mut dyn Free<K>) -> Result<[Number<K>; 5], Unbuilt> {
    let mut numbers = Vec::new();
    for name in names {
        numbers.push(free.number(name)?);
    }
    numbers
        .try_into()
        .map_err(|_| Unbuilt::Contradiction("not five letters".to_owned()))
}

fn build_eliminant<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let first = Conic::new(letters(FIRST, free)?);
    let second = Conic::new(letters(SECOND, free)?);
    let mut bindings = Bindings::new(free.precision());
    first.bind(FIRST, &mut bindings);
    second.bind(SECOND, &mut bindings);
    let eliminant = eliminant(&first, &second);
    for n in 0..=4 {
        bindings.bind(&format!("R_{n}"), eliminant.coefficient(n));
    }
    Ok(bindings)
}

/// The conic with free p, q, r through two points: s and t are linear in them.
fn through<K: Real>(
    points: &[[Number<K>; 2]; 2],
    names: [&str; 5],
    free: &mut dyn Free<K>,
) -> Result<Conic<K>, Unbuilt> {
    let [p, q, r] = [
        free.number(names[0])?,
        free.number(names[1])?,
        free.number(names[2])?,
    ];
    let letters = [p, q, r, Number::zero(), Number::zero()];
    let partial = Conic::new(letters.clone());
    let [[x, y], [x1, y1]] = points;
    let (value, value1) = (partial.value(x, y), partial.value(x1, y1));
    let s = -((&value - &value1) / (x - x1));
    let t = -(value + &s * x);
    let [p, q, r, ..] = letters;
    Ok(Conic::new([p, q, r, s, t]))
}

fn build_known_roots<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let mut points = Vec::new();
    for name in ["a", "b"] {
        points.push([
            free.number(&format!("abscissa of {name}"))?,
            free.number(&format!("ordinate of {name}"))?,
        ]);
    }
    let points: [[Number<K>; 2]; 2] = points
        .try_into()
        .map_err(|_| Unbuilt::Contradiction("not two points".to_owned()))?;
    let first = through(&points, FIRST, free)?;
    let second = through(&points, SECOND, free)?;
    let (z1, z0) = (free.number("z_1")?, free.number("z_0")?);
    let at = &z1 / &z0;
    let quartic = eliminant(&first, &second);
    let rest = |at: &Number<K>| {
        let factors = quartic.coefficient(4) * (at - &points[0][0]) * (at - &points[1][0]);
        quartic.evaluate(at) / factors
    };
    let constant = rest(&Number::zero());
    let mut bindings = Bindings::new(free.precision());
    first.bind(FIRST, &mut bindings);
    second.bind(SECOND, &mut bindings);
    bindings.bind("x_{o,a}", -&points[0][0]);
    bindings.bind("x_{o,b}", -&points[1][0]);
    bindings.bind("rest", rest(&at));
    bindings.bind("E", rest(&Number::one()) - 1 - &constant);
    bindings.bind("F", constant);
    bindings.bind("z_1", z1);
    bindings.bind("z_0", z0);
    Ok(bindings)
}

fn build_common_point<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (x, y) = (free.number("abscissa")?, free.number("ordinate")?);
    let factor = free.number("Z_0")?;
    let mut bindings = Bindings::new(free.precision());
    for names in [FIRST, SECOND] {
        let [p, q, r, s] = [names[0], names[1], names[2], names[3]].map(|name| free.number(name));
        let letters = [p?, q?, r?, s?, Number::zero()];
        let missing = -Conic::new(letters.clone()).value(&x, &y);
        let [p, q, r, s, _] = letters;
        Conic::new([p, q, r, s, missing]).bind(names, &mut bindings);
    }
    bindings.bind("Z_1", x * &factor);
    bindings.bind("Z_2", y * &factor);
    bindings.bind("Z_0", factor);
    Ok(bindings)
}
