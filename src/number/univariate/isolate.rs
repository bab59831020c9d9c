//! All roots of a polynomial over ℚ, isolated with proof.

use std::sync::Arc;

use rug::{Float, Rational};

use super::aberth::Approximations;
use super::complex_root::{ComplexRoot, Disc};
use super::descartes::{Interval, isolate_real};
use super::factor::Factor;
use super::floats::proposed;
use super::integer::IntegerPolynomial;
use super::point::Point;
use super::real_root::RealRoot;
use super::{Polynomial, RootError, chain, square_free};
use crate::number::{Ball, Complex, Exact, Number, count};

/// More bits than this are not tried to tell complex roots apart.
const MOST_BITS: u32 = 1 << 20;

/// All roots of a polynomial.
///
/// The isolating intervals and discs are disjoint. The multiplicities of the real roots and twice
/// those of the complex ones, which stand for couples, add up to the degree.
#[derive(Clone, Debug)]
pub struct Roots {
    real: Vec<RealRoot>,
    complex: Vec<ComplexRoot>,
}

impl Roots {
    /// The real roots, ascending.
    pub fn real(&self) -> &[RealRoot] {
        &self.real
    }

    /// The roots with positive imaginary part, each for itself and its conjugate.
    pub fn complex(&self) -> &[ComplexRoot] {
        &self.complex
    }

    /// All roots in balls of a radius of at most 2^−bits |root|, with multiplicities: the real ones
    /// ascending, with an exact imaginary part 0, then the conjugate couples.
    pub fn enclosures(&self, bits: u32) -> Vec<(Number<Complex<Ball>>, usize)> {
        let real = self.real.iter();
        let real = real.map(|root| (root.enclosure(bits).into(), root.multiplicity()));
        let complex = self.complex.iter().flat_map(|root| {
            let enclosure = root.enclosure(bits);
            [enclosure.conj(), enclosure].map(|ball| (ball, root.multiplicity()))
        });
        real.chain(complex).collect()
    }
}

/// Finds all roots of a polynomial over ℚ, real and complex.
///
/// Multiplicities come from the square-free decomposition, real roots from Descartes' rule and
/// bisection, all of it exact. Complex roots are proposed by approximation and proven by counting:
/// as many disjoint discs off the real axis, each of which surely has a root, as there are roots
/// that are not real.
///
/// # Errors
/// Where a coefficient has no value, for the zero polynomial, and (never seen) where a million bits
/// do not tell complex roots apart.
pub fn isolate(polynomial: &Polynomial<Exact>) -> Result<Roots, RootError> {
    let (_, primitive) = IntegerPolynomial::from_exact(polynomial).ok_or(RootError::NoValue)?;
    if primitive.is_zero() {
        return Err(RootError::ZeroPolynomial);
    }
    let mut roots = Roots {
        real: Vec::new(),
        complex: Vec::new(),
    };
    for (factor, multiplicity) in square_free::decompose(&primitive) {
        let factor = Arc::new(Factor::new(factor));
        let (real, complex) = isolate_simple(&factor)?;
        roots.real.extend(
            real.into_iter()
                .map(|interval| RealRoot::new(factor.clone(), interval, multiplicity)),
        );
        roots.complex.extend(
            complex
                .into_iter()
                .map(|disc| ComplexRoot::new(factor.clone(), disc, multiplicity)),
        );
    }
    separate_real(&mut roots.real);
    separate_complex(&mut roots.complex);
    Ok(roots)
}

/// The different real roots of several polynomials, ascending, each with the place of the first
/// polynomial that vanishes there. The isolating intervals are disjoint.
///
/// # Errors
/// Where a coefficient has no value, and for the zero polynomial.
pub fn real_roots(polynomials: &[Polynomial<Exact>]) -> Result<Vec<(RealRoot, usize)>, RootError> {
    let mut roots: Vec<RealRoot> = Vec::new();
    // Each without what it has in common with an earlier one.
    let mut coprime: Vec<Arc<Factor>> = Vec::new();
    for polynomial in polynomials {
        let (_, primitive) = IntegerPolynomial::from_exact(polynomial).ok_or(RootError::NoValue)?;
        if primitive.is_zero() {
            return Err(RootError::ZeroPolynomial);
        }
        let repeated = chain::gcd(&primitive, &primitive.derivative());
        let mut new = primitive.quotient(&repeated);
        for earlier in &coprime {
            new = new.quotient(&chain::gcd(&new, earlier.polynomial()));
        }
        new.make_primitive();
        let factor = Arc::new(Factor::new(new));
        let intervals = match factor.degree() {
            0 => Vec::new(),
            _ => isolate_real(factor.polynomial()),
        };
        roots.extend(
            intervals
                .into_iter()
                .map(|interval| RealRoot::new(factor.clone(), interval, 1)),
        );
        coprime.push(factor);
    }
    separate_real(&mut roots);
    let first = |root: &RealRoot| coprime.iter().position(|factor| root.is_of(factor));
    let placed = roots.into_iter().map(|root| {
        let place = first(&root).unwrap_or_default();
        (root, place)
    });
    Ok(placed.collect())
}

/// Intervals for the real roots, ascending, and discs for those above the real axis, of simple roots.
fn isolate_simple(factor: &Factor) -> Result<(Vec<Interval>, Vec<Disc>), RootError> {
    let polynomial = factor.polynomial();
    let bits = first_bits(factor);
    let proposals = proposed(factor.approximate().coefficients());
    if let Some(found) = proposals.and_then(|points| proven_at_once(factor, &points, bits)) {
        return Ok(found);
    }
    let real = isolate_real(polynomial);
    let couples = (factor.degree() - real.len()) / 2;
    let complex = isolate_complex(factor, couples)?;
    Ok((real, complex))
}

/// Bits of the first proposals.
fn first_bits(factor: &Factor) -> u32 {
    64 + 2 * count::to_u32(factor.degree())
}

/// Real and complex roots at once, where the points are good enough: as many discs as roots, disjoint,
/// and each surely with a root, have one each; where the center is real, so is the root, for its
/// conjugate lies in the same disc.
fn proven_at_once(
    factor: &Factor,
    points: &[Point],
    bits: u32,
) -> Option<(Vec<Interval>, Vec<Disc>)> {
    let mut intervals = Vec::new();
    let mut above = Vec::new();
    let mut all = Vec::with_capacity(points.len());
    for point in points.iter().filter(|point| point.im >= 0) {
        let [re, im] = [&point.re, &point.im].map(Float::to_rational);
        let (disc, _) = Disc::around(factor, re?, im?, bits + 16)?;
        if point.im.is_zero() {
            intervals.push(Interval::around(&disc.re, &disc.radius));
        } else {
            all.push(disc.conjugate());
            above.push(disc.clone());
        }
        all.push(disc);
    }
    let reach = Rational::from(4 * count::to_u64(factor.degree()));
    let apart = all.iter().enumerate().all(|(place, a)| {
        let others = all.iter().skip(place + 1);
        others.into_iter().all(|b| {
            let larger = if a.radius < b.radius {
                &b.radius
            } else {
                &a.radius
            };
            a.distance(b) > Rational::from(larger * &reach) + &a.radius + &b.radius
        })
    });
    intervals.sort_by(|a, b| a.low.cmp(&b.low));
    (apart && all.len() == factor.degree()).then_some((intervals, above))
}

/// A disc for each of the roots with positive imaginary part, of which there are so many.
fn isolate_complex(factor: &Factor, couples: usize) -> Result<Vec<Disc>, RootError> {
    if couples == 0 {
        return Ok(Vec::new());
    }
    let polynomial = factor.polynomial();
    let mut bits = first_bits(factor);
    // Not from floats: points that these made equal would stay so.
    let mut approximations = Approximations::start(polynomial, bits);
    loop {
        approximations.improve(polynomial, bits);
        if let Some(discs) = proven_discs(factor, couples, &approximations.points, bits) {
            return Ok(discs);
        }
        bits *= 2;
        if bits > MOST_BITS {
            return Err(RootError::NotSeparated { bits: bits / 2 });
        }
    }
}

/// The discs around those points that lie above the real axis, if they prove all roots there.
///
/// Discs that have a root each, are disjoint and do not meet the real axis, and are as many as
/// there are roots above it, have exactly one each. More is asked, for Newton's method: all other
/// roots are at least 4n radii away from the center.
fn proven_discs(factor: &Factor, couples: usize, points: &[Point], bits: u32) -> Option<Vec<Disc>> {
    let mut discs = Vec::with_capacity(couples);
    for point in points.iter().filter(|point| point.im > 0) {
        let [re, im] = [&point.re, &point.im].map(Float::to_rational);
        let (disc, _) = Disc::around(factor, re?, im?, bits + 16)?;
        if disc.im > disc.radius {
            discs.push(disc);
        }
    }
    (discs.len() == couples && are_far_apart(&discs, factor.degree())).then_some(discs)
}

fn are_far_apart(discs: &[Disc], degree: usize) -> bool {
    let reach = Rational::from(4 * count::to_u64(degree));
    discs.iter().enumerate().all(|(index, disc)| {
        let reached = Rational::from(&disc.radius * &reach);
        let is_far =
            |other: &Disc| disc.distance(other) >= Rational::from(&reached + &other.radius);
        // Real roots are on the axis, whichever they are.
        disc.im > reached
            && is_far(&disc.conjugate())
            && discs
                .iter()
                .enumerate()
                .filter(|(other, _)| *other != index)
                .all(|(_, other)| is_far(other) && is_far(&other.conjugate()))
    })
}

/// Sorts roots of different factors and narrows their intervals until they are disjoint.
fn separate_real(roots: &mut [RealRoot]) {
    loop {
        roots.sort_by(|a, b| a.low().cmp(b.low()).then_with(|| a.high().cmp(b.high())));
        let mut disjoint = true;
        for index in 1..roots.len() {
            let (before, after) = roots.split_at_mut(index);
            if let (Some(a), Some(b)) = (before.last_mut(), after.first_mut())
                && a.high() >= b.low()
            {
                disjoint = false;
                a.bisect();
                b.bisect();
            }
        }
        if disjoint {
            return;
        }
    }
}

/// Narrows discs of different factors until the squares around them are disjoint.
#[expect(clippy::indexing_slicing, reason = "there is a mark for every root")]
fn separate_complex(roots: &mut [ComplexRoot]) {
    let mut bits = 16;
    loop {
        let mut close = vec![false; roots.len()];
        for (i, a) in roots.iter().enumerate() {
            for (j, b) in roots.iter().enumerate().skip(i + 1) {
                if a.disc().touches(b.disc()) {
                    close[i] = true;
                    close[j] = true;
                }
            }
        }
        if !close.contains(&true) {
            return;
        }
        for (root, _) in roots.iter_mut().zip(close).filter(|(_, close)| *close) {
            root.refine(bits);
        }
        bits *= 2;
    }
}
