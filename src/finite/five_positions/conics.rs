//! The Burmester pairs as the four meets of two conics.

use rug::{Integer, Rational};

use super::chart::{Chart, MeetOnLine, Meets};
use super::conditions::{Coordinates, finite_pair, rows};
use crate::number::exact::primitive;
use crate::number::linear::{determinant, integer_kernel};
use crate::number::univariate::{ComplexRoot, Polynomial, RealRoot, isolate, surds};
use crate::number::{Ball, Complex, Exact, Kind, Number, Surd, array};
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
    /// Infinitely many: the conditions depend on each other, or the conics have a part in common;
    /// and the one pair beside them, if there is one.
    Families(Option<Box<Pair<Exact>>>),
}

/// Four pairs as the roots of a polynomial, with coordinates that are polynomials in it.
#[derive(Clone, Debug)]
pub struct Isolated {
    /// The roots s, real and complex, with multiplicities that add up to 4.
    roots: Vec<Root>,
    meet: MeetOnLine<Exact>,
    /// The polynomial of which they are the roots, by where the pairs lie.
    parts: Vec<(Place, Poly)>,
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
    pairs_of(&rows(positions))
}

/// The pairs that fulfil four conditions, each a row of exact coefficients: those of five positions, or
/// what becomes of them where positions fall together.
pub fn pairs_of(conditions: &[Vec<Number<Exact>>]) -> Option<Pairs> {
    let basis = basis(conditions)?;
    let Ok(basis) = <[_; 3]>::try_from(basis) else {
        // In a space of four or more coordinates two quadrics have no meet that is alone.
        return Some(Pairs::Families(None));
    };
    let charts = || (0..CHARTS).filter_map(|seed| Chart::new(&basis, seed));
    let isolated = charts().find_map(|chart| solved(&chart.meets()));
    if let Some(isolated) = isolated {
        return Some(Pairs::Isolated(Box::new(isolated)));
    }
    if let Some(isolated) = charts().find_map(|chart| fourfold(&chart)) {
        return Some(Pairs::Isolated(Box::new(isolated)));
    }
    // Only where the conics have a part in common all resultants vanish.
    if charts().any(|chart| !chart.meets().resultant.is_zero()) {
        return None;
    }
    let line = charts().find_map(|chart| chart.common_line());
    let beside = line.and_then(|line| line.beside).map(|coordinates| Pair {
        place: Place::of(&coordinates),
        coordinates,
        multiplicity: 1,
    });
    Some(Pairs::Families(beside.map(Box::new)))
}

/// A basis of the solutions, by integers.
fn basis(conditions: &[Vec<Number<Exact>>]) -> Option<Vec<Coordinates<Exact>>> {
    let rows: Option<Vec<_>> = conditions.iter().map(|row| integral(row)).collect();
    let kernel = integer_kernel(&rows?, 7).into_iter();
    kernel.map(numbers).collect()
}

/// One pair that counts four times, where both conics have their double point.
fn fourfold(chart: &Chart<Exact>) -> Option<Isolated> {
    let (s, pair) = chart.common_vertex(&chart.meets())?;
    Isolated::new(&Poly::linear(&s).power(4), MeetOnLine::fixed(pair))
}

impl Place {
    /// Of exact real coordinates.
    fn of([h, x, y, cx, cy, ..]: &Coordinates<Exact>) -> Self {
        let zero = |a: &Number<Exact>, b: &Number<Exact>| (a.is_zero() & b.is_zero()).is_yes();
        match (h.is_zero().is_yes(), zero(x, y), zero(cx, cy)) {
            (false, ..) => Place::Finite,
            (_, true, true) => Place::BothAtInfinity,
            (_, true, _) => Place::CenterAtInfinity,
            (_, _, true) => Place::CirclepointAtInfinity,
            // No real pair: xX + yY and yX − xY do not both vanish.
            _ => Place::Isotropic,
        }
    }
}

/// The meets, if none lies on the line e₁e₂, and no two on one line through e₂.
fn solved(meets: &Meets<Exact>) -> Option<Isolated> {
    let Meets {
        resultant, second, ..
    } = meets;
    if resultant.degree() != Some(4) {
        return None;
    }
    let resultant = resultant.primitive_part()?;
    if resultant.gcd(second)?.degree() != Some(0) {
        return None;
    }
    Isolated::new(&resultant, meets.coordinates.clone())
}

/// The integers in the same ratio as rational numbers.
fn integral(row: &[Number<Exact>]) -> Option<Vec<Integer>> {
    let rationals: Option<Vec<Rational>> = row.iter().map(|x| x.0.rational().cloned()).collect();
    Some(primitive(&rationals?))
}

fn numbers(integers: Vec<Integer>) -> Option<Coordinates<Exact>> {
    let numbers = integers
        .into_iter()
        .map(|i| Number::from(Rational::from(i)));
    numbers.collect::<Vec<_>>().try_into().ok()
}

impl Isolated {
    fn new(resultant: &Poly, meet: MeetOnLine<Exact>) -> Option<Self> {
        let h = meet.polynomial(0);
        let mut split = Vec::new();
        for (factor, multiplicity) in resultant.square_free_factors()? {
            let power = u32::try_from(multiplicity).ok()?;
            let at_infinity = factor.gcd(&h)?;
            if at_infinity.degree() == Some(0) {
                let part = if power == 1 {
                    factor
                } else {
                    factor.power(power)
                };
                split.push((Place::Finite, part));
                continue;
            }
            let [_, x, y, cx, cy, ..] = &meet.polynomials();
            let no_z = at_infinity.gcd(x)?.gcd(y)?;
            let no_center = at_infinity.gcd(cx)?.gcd(cy)?;
            let both = no_z.gcd(&no_center)?;
            let infinite = (no_z.clone() * &no_center).divide(&both)?.0;
            let places = [
                (Place::Finite, factor.divide(&at_infinity)?.0),
                (Place::CenterAtInfinity, no_z.divide(&both)?.0),
                (Place::CirclepointAtInfinity, no_center.divide(&both)?.0),
                (Place::Isotropic, at_infinity.divide(&infinite)?.0),
                (Place::BothAtInfinity, both),
            ];
            let proper = places
                .into_iter()
                .filter(|(_, part)| part.degree() != Some(0));
            split.extend(proper.map(|(place, part)| (place, part.power(power))));
        }
        let mut roots = Vec::new();
        for (place, part) in &split {
            add_roots(part, *place, &mut roots)?;
        }
        Some(Isolated {
            roots,
            meet,
            parts: split,
        })
    }

    /// The pairs that are not known already: the other roots of the same polynomial. `None` where
    /// one of the known ones is none of them, or is listed more often than it counts.
    pub fn without(&self, known: &[Coordinates<Exact>]) -> Option<Self> {
        let parts = self.parts.iter();
        let mut rest = parts.fold(Poly::from_integers(&[1]), |all, (_, part)| all * part);
        for pair in known {
            rest = rest.divide(&self.root_of(&rest, pair)?)?.0;
        }
        Isolated::new(&rest, self.meet.clone())
    }

    /// Which of the real pairs this is, as [`real`](Self::real) lists them.
    pub fn place_of(&self, known: &Coordinates<Exact>) -> Option<usize> {
        let parts = self.parts.iter();
        let all = parts.fold(Poly::from_integers(&[1]), |all, (_, part)| all * part);
        let linear = self.root_of(&all, known)?;
        let s = rational(&-(linear.coefficient(0) / linear.coefficient(1)));
        let real = self.roots.iter().filter_map(|root| match root {
            Root::Real(root, _) => Some(root),
            Root::Complex(..) => None,
        });
        real.into_iter().position(|root| root.compare(&s).is_eq())
    }

    /// The linear factor where the coordinates are in one ratio with those of a known pair.
    fn root_of(&self, polynomial: &Poly, known: &Coordinates<Exact>) -> Option<Poly> {
        let mut same = polynomial.clone();
        let coordinates = self.meet.polynomials();
        for (i, (own, other)) in coordinates.iter().zip(known).enumerate() {
            let later = coordinates.iter().zip(known).skip(i + 1);
            for (own_later, other_later) in later {
                let minor = own.scaled(other_later) - own_later.scaled(other);
                same = same.gcd(&minor)?;
            }
        }
        same.square_free_part()
            .filter(|root| root.degree() == Some(1))
    }

    /// The polynomial in −x whose roots, with their multiplicities, belong to the finite pairs; a
    /// constant where there is none.
    pub fn eliminant(&self) -> Option<Poly> {
        let [h, x, ..] = &self.meet.polynomials();
        norm(&self.part(Place::Finite), h, &-x.clone())
    }

    /// The polynomial of the values ax + by of the finite circlepoints, whether their centers are
    /// finite or not.
    pub fn circlepoints(&self, [a, b]: [i64; 2]) -> Option<Poly> {
        let [h, x, y, cx, cy, p, q] = &self.meet.polynomials();
        let along = |x: &Poly, y: &Poly| x.scaled(&a.into()) + y.scaled(&b.into());
        let finite = norm(&self.part(Place::Finite), h, &along(x, y))?;
        // z = w/M̄ = (p + iq) (X + iY)/(X² + Y²).
        let size = cx * cx + cy * cy;
        let [x, y] = [p * cx - q * cy, p * cy + q * cx];
        let sliding = norm(&self.part(Place::CenterAtInfinity), &size, &along(&x, &y))?;
        (finite * sliding).primitive_part()
    }

    /// The polynomial of the turns (r₂z + t₂ − M)/(r₁z + t₁ − M) of the links of all pairs between two
    /// positions.
    pub fn turns(&self, positions: [&Displacement<Exact>; 2]) -> Polynomial<Complex<Exact>> {
        let [h, x, y, cx, cy, ..] = &self.meet.polynomials();
        let link = |position: &Displacement<Exact>| -> [Number<Complex<Exact>>; 3] {
            let at = |power: usize| {
                let part = |p: &Poly| p.coefficient(power);
                let z = Number::complex(part(x), part(y));
                let center = Number::complex(part(cx), part(cy));
                &position.rotation * z + position.translation.scaled(&part(h)) - center
            };
            [at(0), at(1), at(2)]
        };
        let [from, to] = positions.map(link);
        let all = self.parts.iter();
        let all = all.fold(Poly::from_integers(&[1]), |all, (_, part)| all * part);
        let value = |turn: i64| {
            let turn = Number::from(turn);
            let quadratic = array::pairs(&from, &to).map(|(from, to)| from * &turn - to);
            (turn, resultant_with_quadratic(&all, &quadratic))
        };
        let values: Vec<_> = (0..5).map(value).collect();
        Polynomial::interpolated(&values)
    }

    /// The polynomial of the pairs at a place; a constant where there is none.
    fn part(&self, place: Place) -> Poly {
        let parts = self.parts.iter().filter(|(own, _)| *own == place);
        parts.fold(Poly::from_integers(&[1]), |all, (_, part)| all * part)
    }

    /// The real pairs, to so many bits of the root.
    pub fn real(&self, bits: u32) -> Vec<Pair<Ball>> {
        let real = self.roots.iter().filter_map(|root| match root {
            Root::Real(root, place) => Some((root, *place)),
            Root::Complex(..) => None,
        });
        real.map(|(root, place)| {
            let s = match root.rational() {
                Some(exact) => Number::from(exact),
                None => root.enclosure(bits),
            };
            Pair {
                coordinates: self.meet.at(&s, ball),
                place,
                multiplicity: root.multiplicity(),
            }
        })
        .collect()
    }

    /// The coordinates of the real pairs, in the same order, as sums of square roots where they are.
    pub fn surds(&self) -> Vec<Option<Coordinates<Surd>>> {
        let whole = self.parts.iter();
        let whole = whole.fold(Poly::from_integers(&[1]), |all, (_, part)| all * part);
        let real = self.roots.iter().filter_map(|root| match root {
            Root::Real(root, _) => Some(root),
            Root::Complex(..) => None,
        });
        let real: Vec<&RealRoot> = real.collect();
        let convert = |x: &Number<Exact>| Number::<Surd>::from(rational(x));
        let roots = surds(&whole, &real).into_iter();
        roots
            .map(|root| Some(self.meet.at(&root?, convert)))
            .collect()
    }

    /// One of each couple of conjugate pairs, to so many bits of the root.
    pub fn complex(&self, bits: u32) -> Vec<Pair<Complex<Ball>>> {
        let complex = self.roots.iter().filter_map(|root| match root {
            Root::Complex(root, place) => Some((root, *place)),
            Root::Real(..) => None,
        });
        complex
            .map(|(root, place)| {
                let s = root.enclosure(bits);
                Pair {
                    coordinates: self.meet.at_complex(&s, ball),
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

/// The polynomial whose roots are the values of a quotient in the roots of another one: their
/// resultant.
fn norm(part: &Poly, denominator: &Poly, numerator: &Poly) -> Option<Poly> {
    let degree = part.degree()?;
    if degree == 0 {
        return Some(Poly::from_integers(&[1]));
    }
    let order = denominator.degree().max(numerator.degree())?;
    let value = |u: i64| {
        let u = Number::from(u);
        let other = denominator.scaled(&u) - numerator;
        // Of one order for all u, also where the leading coefficient vanishes.
        let missing = order - other.degree().unwrap_or(order);
        let leading = (0..missing).fold(Number::one(), |power, _| power * part.coefficient(degree));
        (u, part.resultant(&other) * leading)
    };
    // Of that degree: from its values in 0, …, degree.
    let values: Vec<_> = (0..=i64::try_from(degree).ok()?).map(value).collect();
    Poly::interpolated(&values).primitive_part()
}

/// The resultant with c₀ + c₁s + c₂s², taken of order 2 whether c₂ vanishes or not.
fn resultant_with_quadratic(
    part: &Poly,
    quadratic: &[Number<Complex<Exact>>; 3],
) -> Number<Complex<Exact>> {
    let degree = part.degree().unwrap_or(0);
    let size = degree + 2;
    let mut rows = vec![vec![Number::zero(); size]; size];
    let place = |rows: &mut Vec<Vec<Number<Complex<Exact>>>>, row: usize, power: usize, value| {
        let entry = rows.get_mut(row).and_then(|row| row.get_mut(power));
        if let Some(entry) = entry {
            *entry = value;
        }
    };
    for shift in 0..2 {
        for power in 0..=degree {
            place(
                &mut rows,
                shift,
                shift + power,
                part.coefficient(power).into(),
            );
        }
    }
    for shift in 0..degree {
        for (power, value) in quadratic.iter().enumerate() {
            place(&mut rows, 2 + shift, shift + power, value.clone());
        }
    }
    determinant(&rows)
}

fn ball(x: &Number<Exact>) -> Number<Ball> {
    rational(x).into()
}

fn rational(x: &Number<Exact>) -> Rational {
    x.0.rational().cloned().unwrap_or_default()
}
