//! All that was found of five positions, whatever the route.

use rug::Rational;

use super::known::{Alternates, Known};
use crate::finite::five_positions::conics::{Isolated, Pair, Pairs, Place};
use crate::finite::five_positions::enclosed;
use crate::finite::five_positions::families::{self, Family};
use crate::number::{Ball, Complex, Exact, Number, Surd};
use crate::plane::Point;

/// A real pair with its coordinates h, x, y, X, Y, p, q.
pub struct Real {
    pub coordinates: [Number<Ball>; 7],
    pub place: Place,
    pub multiplicity: usize,
    /// How often it is not known already.
    pub left: usize,
    /// The coordinates, where they are known to be sums of square roots.
    pub surds: Option<[Number<Surd>; 7]>,
}

impl Real {
    fn exact(pair: &Pair<Exact>) -> Self {
        let ball =
            |x: &Number<Exact>| Number::<Ball>::from(x.0.rational().cloned().unwrap_or_default());
        Real {
            coordinates: pair.coordinates.each_ref().map(ball),
            place: pair.place,
            multiplicity: pair.multiplicity,
            left: pair.multiplicity,
            surds: None,
        }
    }

    /// The finite point of a pair whose other point is at infinity.
    pub fn beside_infinity(&self) -> Point<Ball> {
        let [_, x, y, cx, cy, p, q] = &self.coordinates;
        let w = Number::complex(p.clone(), q.clone());
        match self.place {
            Place::CirclepointAtInfinity => (w / Number::complex(x.clone(), y.clone())).conj(),
            _ => w / Number::complex(cx.clone(), -cy),
        }
    }
}

/// One of two conjugate pairs.
pub struct Couple {
    pub coordinates: [Number<Complex<Ball>>; 7],
    pub place: Place,
    pub multiplicity: usize,
}

/// What there is beside isolated pairs.
pub enum Families {
    None,
    Known(Family),
    /// Something that has no name here yet.
    Unknown,
}

/// All that was found, whatever the route.
pub struct Found {
    pub real: Vec<Real>,
    pub complex: Vec<Couple>,
    pub family: Families,
    pub eliminant: Option<Vec<Rational>>,
    pub method: &'static str,
    /// What is left beside the pairs that the problem names.
    pub alternates: Option<Alternates>,
}

impl Found {
    /// Whether there are more pairs than are known.
    pub fn is_undecided(&self) -> bool {
        matches!(self.family, Families::Unknown)
    }

    /// Of rational conditions, whatever they come from.
    pub fn exact(
        conditions: &[Vec<Number<Exact>>],
        pairs: Option<&Pairs>,
        known: &Known,
        bits: u32,
    ) -> Option<Found> {
        let pairs = pairs?;
        Some(match pairs {
            Pairs::Isolated(isolated) => Found::isolated(isolated, known, bits),
            Pairs::Families(beside) => Found {
                real: beside.iter().map(|pair| Real::exact(pair)).collect(),
                complex: Vec::new(),
                family: families::family(conditions).map_or(Families::Unknown, Families::Known),
                eliminant: None,
                method: "exact linear algebra: the conditions depend on each other, or the two conics \
                         have a part in common",
                alternates: None,
            },
        })
    }

    /// Adds to the real pairs what they are as sums of square roots.
    pub fn with_surds(mut self, pairs: &Pairs) -> Self {
        if let Pairs::Isolated(isolated) = pairs {
            for (pair, surds) in self.real.iter_mut().zip(isolated.surds()) {
                pair.surds = surds;
            }
        }
        self
    }

    fn isolated(isolated: &Isolated, known: &Known, bits: u32) -> Found {
        let real = isolated.real(bits).into_iter().map(|pair| Real {
            coordinates: pair.coordinates,
            place: pair.place,
            multiplicity: pair.multiplicity,
            left: pair.multiplicity,
            surds: None,
        });
        let mut real: Vec<Real> = real.collect();
        let alternates = if known.is_empty() {
            None
        } else {
            Alternates::new(isolated, known, &mut real)
        };
        let complex = isolated.complex(bits).into_iter().map(|pair| Couple {
            coordinates: pair.coordinates,
            place: pair.place,
            multiplicity: pair.multiplicity,
        });
        let coefficients = isolated.eliminant().map(|eliminant| {
            let coefficients = eliminant.coefficients().iter().rev();
            coefficients
                .filter_map(|c| c.0.rational().cloned())
                .collect()
        });
        Found {
            real,
            complex: complex.collect(),
            family: Families::None,
            eliminant: coefficients,
            method: "exact eliminant of two conics, all of its four roots isolated",
            alternates,
        }
    }

    /// Of machine floats, taken for exact.
    pub fn floats(pairs: &[[Number<Complex<f64>>; 7]]) -> Found {
        let is_real =
            |pair: &&[Number<Complex<f64>>; 7]| pair.iter().all(|z| z.im().is_zero().is_yes());
        let exactly =
            |x: &Number<f64>| Number::<Ball>::from(Rational::from_f64(x.0).unwrap_or_default());
        let real = pairs.iter().filter(is_real).map(|pair| {
            let coordinates = pair.each_ref().map(|z| exactly(z.re()));
            let [h, x, y, cx, cy, ..] = pair.each_ref().map(|z| z.re().0);
            let place = if h != 0.0 {
                Place::Finite
            } else if x.hypot(y) < cx.hypot(cy) {
                Place::CenterAtInfinity
            } else {
                Place::CirclepointAtInfinity
            };
            Real {
                coordinates,
                place,
                multiplicity: 1,
                left: 1,
                surds: None,
            }
        });
        let complex = pairs.iter().filter(|pair| !is_real(pair)).map(|pair| {
            let coordinates = pair
                .each_ref()
                .map(|z| Number::complex(exactly(z.re()), exactly(z.im())));
            Couple {
                place: if pair[0].is_zero().is_yes() {
                    Place::Isotropic
                } else {
                    Place::Finite
                },
                coordinates,
                multiplicity: 1,
            }
        });
        Found {
            real: real.collect(),
            complex: complex.collect(),
            family: Families::None,
            eliminant: None,
            method: "two conics in machine floats: nothing certified",
            alternates: None,
        }
    }

    /// `None` where the enclosures cannot tell whether a pair is at infinity.
    pub fn enclosed(conditions: &[Vec<Number<Ball>>], bits: u32) -> Option<Found> {
        let pairs = enclosed::pairs_of(conditions, bits)?;
        let finite = |h: crate::number::Truth| h.is_no().then_some(Place::Finite);
        let real = pairs.real.into_iter().map(|coordinates| {
            Some(Real {
                place: finite(coordinates[0].is_zero())?,
                coordinates,
                multiplicity: 1,
                left: 1,
                surds: None,
            })
        });
        let complex = pairs.complex.into_iter().map(|coordinates| {
            Some(Couple {
                place: finite(coordinates[0].is_zero())?,
                coordinates,
                multiplicity: 1,
            })
        });
        Some(Found {
            real: real.collect::<Option<_>>()?,
            complex: complex.collect::<Option<_>>()?,
            family: Families::None,
            eliminant: None,
            method: "eliminant of two conics in enclosures, Newton's interval test for all four roots",
            alternates: None,
        })
    }
}
