//! The Burmester pairs as the four meets of two conics.

use rug::Rational;

use super::chart::{Chart, Meets};
use super::conditions::{Coordinates, finite_pair, rows};
use crate::number::exact::primitive;
use crate::number::linear::kernel;
use crate::number::univariate::{ComplexRoot, Polynomial, RealRoot, isolate};
use crate::number::{Ball, Complex, Exact, Kind, Number};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

type Poly = Polynomial<Exact>;

/// How often other coordinates are tried before the conics are said to have a part in common.
const CHARTS: i64 = 24;

/// What five positions have in common.
#[derive(Clone, Debug)]
pub enum Pairs {
    /// Four pairs, counted with their multiplicities.
    Isolated(Box<Isolated>),
    /// Infinitely many: the conditions depend on each other, or the conics have a part in common.
    Families,
}

/// Four pairs as the roots of a polynomial, with coordinates that are polynomials in it.
#[derive(Clone, Debug)]
pub struct Isolated {
    /// The roots s, real and complex, with multiplicities that add up to 4.
    roots: Vec<Root>,
    /// h, x, y, X, Y, p, q as polynomials in s.
    coordinates: [Poly; 7],
    eliminant: Option<Poly>,
}

#[derive(Clone, Debug)]
enum Root {
    Real(RealRoot, Place),
    Complex(ComplexRoot, Place),
}

/// Where a pair lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// Both points are finite.
    Finite,
    /// The center is at infinity.
    CenterAtInfinity,
    /// The circlepoint is at infinity.
    CirclepointAtInfinity,
    /// Both are, in one direction each.
    BothAtInfinity,
    /// Isotropic directions: not real, and at infinity.
    Isotropic,
}

/// One pair.
#[derive(Clone, Debug)]
pub struct Pair<K> {
    /// h, x, y, X, Y, p, q.
    pub coordinates: [Number<K>; 7],
    /// Where it lies.
    pub place: Place,
    /// How often it counts.
    pub multiplicity: usize,
}

/// The pairs of five exact positions.
pub fn pairs(positions: &[Displacement<Exact>; 5]) -> Option<Pairs> {
    let basis = kernel(&rows(positions), 7)?;
    let [a, b, c] = basis.as_slice() else {
        return Some(Pairs::Families);
    };
    let basis = [a, b, c].map(|vector| integral(vector));
    let [Some(a), Some(b), Some(c)] = basis else {
        return None;
    };
    let basis = [a, b, c];
    let charts = (0..CHARTS).filter_map(|seed| Chart::new(&basis, seed));
    let isolated = charts
        .map(|chart| solved(&chart.meets()))
        .find_map(|found| found);
    Some(isolated.map_or(Pairs::Families, |isolated| {
        Pairs::Isolated(Box::new(isolated))
    }))
}

/// The meets, if none lies on the line e₁e₂, and no two on one line through e₂.
fn solved(meets: &Meets<Exact>) -> Option<Isolated> {
    let Meets {
        resultant, second, ..
    } = meets;
    if resultant.degree() != Some(4) || resultant.gcd(second)?.degree() != Some(0) {
        return None;
    }
    let reduced = meets
        .coordinates
        .iter()
        .map(|part| Some(part.divide(resultant)?.1));
    let coordinates = reduced.collect::<Option<Vec<_>>>()?.try_into().ok()?;
    Isolated::new(resultant, coordinates)
}

/// A vector by integers.
fn integral(vector: &[Number<Exact>]) -> Option<Coordinates<Exact>> {
    let rationals: Option<Vec<Rational>> = vector.iter().map(|x| x.0.rational().cloned()).collect();
    let integers = primitive(&rationals?).into_iter();
    let numbers: Vec<Number<Exact>> = integers.map(|i| Number::from(Rational::from(i))).collect();
    numbers.try_into().ok()
}

impl Isolated {
    fn new(resultant: &Poly, coordinates: [Poly; 7]) -> Option<Self> {
        let [h, x, y, cx, cy, ..] = &coordinates;
        let mut roots = Vec::new();
        let mut finite = Poly::constant(Number::one());
        for (factor, multiplicity) in resultant.square_free_factors()? {
            let at_infinity = factor.gcd(h)?;
            let here = factor.divide(&at_infinity)?.0;
            finite = finite * here.power(u32::try_from(multiplicity).ok()?);
            let no_z = at_infinity.gcd(x)?.gcd(y)?;
            let no_center = at_infinity.gcd(cx)?.gcd(cy)?;
            let both = no_z.gcd(&no_center)?;
            let rest = at_infinity
                .divide(&(no_z.clone() * &no_center).divide(&both)?.0)?
                .0;
            let parts = [
                (here, Place::Finite),
                (no_z.divide(&both)?.0, Place::CenterAtInfinity),
                (no_center.divide(&both)?.0, Place::CirclepointAtInfinity),
                (both, Place::BothAtInfinity),
                (rest, Place::Isotropic),
            ];
            for (part, place) in parts {
                add_roots(
                    &part.power(u32::try_from(multiplicity).ok()?),
                    place,
                    &mut roots,
                )?;
            }
        }
        let eliminant = norm(&finite, h, x);
        Some(Isolated {
            roots,
            coordinates,
            eliminant,
        })
    }

    /// The polynomial in −x whose roots, with their multiplicities, belong to the finite pairs; a
    /// constant where there is none.
    pub fn eliminant(&self) -> Option<&Polynomial<Exact>> {
        self.eliminant.as_ref()
    }

    /// The real pairs, to so many bits of the root.
    pub fn real(&self, bits: u32) -> Vec<Pair<Ball>> {
        let parts = self.coordinates.each_ref();
        let real = self.roots.iter().filter_map(|root| match root {
            Root::Real(root, place) => Some((root, *place)),
            Root::Complex(..) => None,
        });
        real.map(|(root, place)| {
            let s = match root.rational() {
                Some(exact) => Number::from(exact),
                None => root.enclosure(bits),
            };
            let ball = |x: &Number<Exact>| Number::<Ball>::from(rational(x));
            Pair {
                coordinates: parts.map(|part| part.map(ball).evaluate(&s)),
                place,
                multiplicity: root.multiplicity(),
            }
        })
        .collect()
    }

    /// One of each couple of conjugate pairs, to so many bits of the root.
    pub fn complex(&self, bits: u32) -> Vec<Pair<Complex<Ball>>> {
        let parts = self.coordinates.each_ref();
        let complex = self.roots.iter().filter_map(|root| match root {
            Root::Complex(root, place) => Some((root, *place)),
            Root::Real(..) => None,
        });
        complex
            .map(|(root, place)| {
                let s = root.enclosure(bits);
                let ball = |x: &Number<Exact>| Number::<Ball>::from(rational(x));
                Pair {
                    coordinates: parts.map(|part| part.map(ball).evaluate_complex(&s)),
                    place,
                    multiplicity: root.multiplicity(),
                }
            })
            .collect()
    }
}

impl<K: Kind> Pair<K> {
    /// Circlepoint and center of a finite pair.
    pub fn points(&self) -> [Point<K>; 2] {
        finite_pair(&self.coordinates)
    }
}

fn add_roots(part: &Poly, place: Place, roots: &mut Vec<Root>) -> Option<()> {
    if part.degree()? == 0 {
        return Some(());
    }
    let found = isolate(part).ok()?;
    roots.extend(
        found
            .real()
            .iter()
            .map(|root| Root::Real(root.clone(), place)),
    );
    roots.extend(
        found
            .complex()
            .iter()
            .map(|root| Root::Complex(root.clone(), place)),
    );
    Some(())
}

/// The polynomial in u whose roots are −x(s)/h(s) for the roots s of another one: their resultant,
/// the determinant of u + x/h as a map of the residues.
fn norm(finite: &Poly, h: &Poly, x: &Poly) -> Option<Poly> {
    let degree = finite.degree()?;
    // Of degree `degree` in u: from its values in 0, …, degree.
    let values: Vec<(Number<Exact>, Number<Exact>)> = (0..=i64::try_from(degree).ok()?)
        .map(Number::from)
        .map(|u| (u.clone(), finite.resultant(&(h.scaled(&u) + x.clone()))))
        .collect();
    Poly::interpolated(&values).primitive_part()
}

fn rational(x: &Number<Exact>) -> Rational {
    x.0.rational().cloned().unwrap_or_default()
}
