//! The two conics of five positions in coordinates of the plane of solutions.

use super::conditions::{Coordinates, products};
use crate::number::univariate::Polynomial;
use crate::number::{Complex, Kind, Number};

/// Coordinates e₀ + s e₁ + n e₂ of the solutions: on each line of one s both conics are quadratic
/// equations in n.
pub struct Chart<K> {
    basis: [Coordinates<K>; 3],
    /// A, B(s), C(s) of A n² + B n + C for each conic.
    conics: [[Polynomial<K>; 3]; 2],
}

/// What a chart says of the meets of both conics.
pub struct Meets<K> {
    /// Of order 4 in s: zero on the lines through e₂ with a meet, where both equations have a common
    /// root.
    pub resultant: Polynomial<K>,
    /// Where this is zero too, the equations are the same.
    pub second: Polynomial<K>,
    /// h, x, y, X, Y, p, q of the meet on a line, where the equations differ.
    pub coordinates: MeetOnLine<K>,
}

/// The meet on the line of one s: second (e₀ + s e₁) − first e₂.
#[derive(Clone, Debug)]
pub struct MeetOnLine<K> {
    basis: [Coordinates<K>; 3],
    weights: [Polynomial<K>; 3],
}

impl<K: Kind> MeetOnLine<K> {
    fn new(basis: &[Coordinates<K>; 3], first: &Polynomial<K>, second: &Polynomial<K>) -> Self {
        MeetOnLine {
            basis: basis.clone(),
            weights: [
                second.clone(),
                second * &Polynomial::variable(),
                -first.clone(),
            ],
        }
    }

    /// One point for all s.
    pub fn fixed(point: Coordinates<K>) -> Self {
        let nothing = || std::array::from_fn(|_| Number::zero());
        MeetOnLine {
            basis: [point, nothing(), nothing()],
            weights: [
                Polynomial::from_integers(&[1]),
                Polynomial::zero(),
                Polynomial::zero(),
            ],
        }
    }

    /// As polynomials in s.
    pub fn polynomials(&self) -> [Polynomial<K>; 7] {
        std::array::from_fn(|i| self.polynomial(i))
    }

    /// One of the coordinates as a polynomial in s.
    #[expect(clippy::indexing_slicing, reason = "there are seven coordinates")]
    pub fn polynomial(&self, place: usize) -> Polynomial<K> {
        let terms = self.weights.iter().zip(&self.basis);
        let terms = terms.filter(|(_, axis)| !axis[place].is_zero().is_yes());
        let terms = terms.map(|(weight, axis)| weight.scaled(&axis[place]));
        terms.fold(Polynomial::zero(), |sum, term| sum + term)
    }

    /// In one s of any kind.
    pub fn at<L: Kind>(
        &self,
        s: &Number<L>,
        convert: impl Fn(&Number<K>) -> Number<L>,
    ) -> Coordinates<L> {
        let weights = (self.weights.each_ref()).map(|weight| weight.map(&convert).evaluate(s));
        self.combined(&convert, |axis| {
            let terms = weights.iter().zip(axis);
            let terms = terms.filter(|(_, axis)| !axis.is_zero().is_yes());
            terms.map(|(weight, axis)| weight * axis).sum()
        })
    }

    /// In one s that is not real.
    pub fn at_complex<L: Kind>(
        &self,
        s: &Number<Complex<L>>,
        convert: impl Fn(&Number<K>) -> Number<L>,
    ) -> Coordinates<Complex<L>> {
        let weights =
            (self.weights.each_ref()).map(|weight| weight.map(&convert).evaluate_complex(s));
        self.combined(&convert, |axis| {
            let terms = weights.iter().zip(axis);
            let terms = terms.filter(|(_, axis)| !axis.is_zero().is_yes());
            terms.map(|(weight, axis)| weight.scaled(axis)).sum()
        })
    }

    /// Each coordinate from those of the basis.
    #[expect(clippy::indexing_slicing, reason = "there are seven coordinates")]
    fn combined<L, M>(
        &self,
        convert: impl Fn(&Number<K>) -> Number<L>,
        combine: impl Fn(&[Number<L>; 3]) -> Number<M>,
    ) -> Coordinates<M> {
        std::array::from_fn(|i| combine(&self.basis.each_ref().map(|axis| convert(&axis[i]))))
    }
}

/// A line of pairs, and the one meet of the conics beside it.
#[derive(Clone, Debug)]
pub struct CommonLine<K> {
    /// Two of its points.
    pub through: [Coordinates<K>; 2],
    /// The meet of what is left of the conics, where it is not on the line.
    pub beside: Option<Coordinates<K>>,
}

impl<K: Kind> Chart<K> {
    /// A chart of a number; the first is that of the basis as it is. `None` where both conics pass
    /// through e₂.
    pub fn new(basis: &[Coordinates<K>; 3], seed: i64) -> Option<Self> {
        let basis = if seed == 0 {
            basis.clone()
        } else {
            mixed(basis, seed)
        };
        let [e0, e1, e2] = &basis;
        let [p00, p01, p11] = [(e0, e0), (e0, e1), (e1, e1)].map(|(u, v)| products(u, v));
        let [p02, p12, p22] = [(e0, e2), (e1, e2), (e2, e2)].map(|(u, v)| products(u, v));
        // Twice a quadratic form is the bilinear form of a vector with itself.
        #[expect(
            clippy::indexing_slicing,
            reason = "there are two products, for two conics"
        )]
        let conic = |which: usize| {
            let [p00, p01, p11, p02, p12, p22] =
                [&p00, &p01, &p11, &p02, &p12, &p22].map(|both| both[which].clone());
            [
                Polynomial::new(vec![p22 / 2]),
                Polynomial::new(vec![p02, p12]),
                Polynomial::new(vec![p00 / 2, p01, p11 / 2]),
            ]
        };
        let conics = [conic(0), conic(1)];
        let through = conics.iter().all(|[a, ..]| a.is_zero());
        (!through).then_some(Chart { basis, conics })
    }

    /// The meets.
    pub fn meets(&self) -> Meets<K> {
        let [[a, b, c], [a1, b1, c1]] = &self.conics;
        let first = a * c1 - a1 * c;
        let second = a * b1 - a1 * b;
        let third = b * c1 - b1 * c;
        Meets {
            resultant: &first * &first - &second * &third,
            coordinates: MeetOnLine::new(&self.basis, &first, &second),
            second,
        }
    }

    /// A line that both conics have in common, where all that [`meets`](Self::meets) finds is zero;
    /// `None` where they are one conic, and where the meet beside the line is not on a line of one s.
    ///
    /// On it A n² + Bn + C = (n − ℓ(s)) (A n + B + A ℓ(s)), with the n that solves both equations.
    pub fn common_line(&self) -> Option<CommonLine<K>> {
        let [[a, b, c], [a1, b1, c1]] = &self.conics;
        let first = a * c1 - a1 * c;
        let second = a * b1 - a1 * b;
        if second.degree() != Some(1) {
            return None;
        }
        let (quotient, remainder) = first.divide(&second)?;
        if !remainder.is_zero() {
            return None;
        }
        let along = quotient.scaled(&Number::from(-1));
        let s = -(second.coefficient(0) / second.coefficient(1));
        let (a, b) = if a.is_zero() { (a1, b1) } else { (a, b) };
        let n = -((b + a * &along).evaluate(&s) / a.coefficient(0));
        let beside = !along.evaluate(&s).equals(&n).is_yes();
        let at = |s: i64| self.point(&s.into(), &along.evaluate(&s.into()));
        Some(CommonLine {
            through: [at(0), at(1)],
            beside: beside.then(|| self.point(&s, &n)),
        })
    }

    /// The only meet of two conics that both have their double point there: on every line through it
    /// both equations have it as a double root, so that no chart tells it from two. `None` where that
    /// is not so in this chart.
    pub fn common_vertex(&self, meets: &Meets<K>) -> Option<(Number<K>, Coordinates<K>)> {
        let second = &meets.second;
        if second.degree() != Some(1) || meets.resultant.degree() != Some(4) {
            return None;
        }
        let s = -(second.coefficient(0) / second.coefficient(1));
        let power = Polynomial::linear(&s)
            .power(4)
            .scaled(meets.resultant.leading()?);
        if !(power - &meets.resultant).is_zero() {
            return None;
        }
        let [[a, b, c], [a1, b1, c1]] = &self.conics;
        let (a, b, c) = if a.is_zero() { (a1, b1, c1) } else { (a, b, c) };
        let (a, b, c) = (a.coefficient(0), b.evaluate(&s), c.evaluate(&s));
        if !(b.square() - 4 * &a * c).is_zero().is_yes() {
            return None;
        }
        let n = -b / (2 * a);
        Some((s.clone(), self.point(&s, &n)))
    }

    #[expect(clippy::indexing_slicing, reason = "there are seven coordinates")]
    fn point(&self, s: &Number<K>, n: &Number<K>) -> Coordinates<K> {
        let [e0, e1, e2] = &self.basis;
        std::array::from_fn(|i| &e0[i] + &e1[i] * s + &e2[i] * n)
    }
}

/// Small integer combinations, independent, another for each seed.
#[expect(clippy::indexing_slicing, reason = "there are seven coordinates")]
fn mixed<K: Kind>(basis: &[Coordinates<K>; 3], seed: i64) -> [Coordinates<K>; 3] {
    let [a, b, c] = basis;
    let combine = |k: [i64; 3]| -> Coordinates<K> {
        std::array::from_fn(|i| &a[i] * k[0] + &b[i] * k[1] + &c[i] * k[2])
    };
    // A lower times an upper triangular matrix with ones on the diagonal.
    let (u, v, w) = (seed % 5, (seed * 3) % 7, (seed * 5 + 2) % 11 - 5);
    let (d, e, f) = ((seed * 2) % 3, (seed * 7) % 5 - 2, (seed * 4) % 9 - 4);
    [
        combine([1, u, v]),
        combine([d, d * u + 1, d * v + w]),
        combine([e, e * u + f, e * v + f * w + 1]),
    ]
}
