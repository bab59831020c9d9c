//! The stretches of the centerpoint curve on which all wishes are fulfilled, decided without sampling.
//!
//! A branch is a row of cells: between two neighbouring zeros of the limits no wish changes its truth,
//! so that one pair of a cell decides for all of it. A center or a circlepoint at infinity ends every
//! stretch. Where a wish is known within bounds, between the zeros for the one and for the other nothing
//! is told: such a cell is an end of a stretch.

use std::cmp::Ordering;

use rug::Rational;

use super::congruent_pencils::{CongruentPencils, Dyad};
use super::wishes::{Fulfilled, Wishes};
use crate::finite::positions::Positions;
use crate::number::exact::rational_sqrt;
use crate::number::univariate::{RealRoot, real_roots};
use crate::number::{Ball, Exact, Number, Polynomial, Truth};
use crate::plane::curve_type::CurveType;
use crate::plane::projective::ProjectivePoint;

/// Bits to begin with, and the most that are tried.
const BITS: [u32; 2] = [96, 96 << 6];

/// Pairs that are tried in a cell: a wish may be on the edge in a single pair by chance.
const SAMPLES: u32 = 4;

/// The slope of a line of the pencils.
#[derive(Clone, Debug)]
enum Slope {
    Rational(Rational),
    Root(RealRoot),
    Infinite,
    /// Somewhere between two others, both finite.
    Between(Box<[Slope; 2]>),
}

impl Slope {
    fn bounds(&self) -> Option<[&Rational; 2]> {
        match self {
            Slope::Rational(t) => Some([t, t]),
            Slope::Root(root) => Some([root.low(), root.high()]),
            Slope::Infinite | Slope::Between(_) => None,
        }
    }

    fn enclosure(&self, bits: u32) -> [Number<Ball>; 2] {
        match self {
            Slope::Rational(t) => [Number::one(), Number::from(t.clone())],
            Slope::Root(root) => [Number::one(), root.enclosure(bits)],
            Slope::Infinite => [Number::zero(), Number::one()],
            Slope::Between(ends) => {
                let [[_, s], [_, t]] = ends.each_ref().map(|end| end.enclosure(bits));
                let unit = Number(Ball::with_radius(
                    &Rational::new(),
                    &Rational::from(1),
                    bits,
                ));
                [Number::one(), (&s + &t + (s - t) * unit) / 2]
            }
        }
    }
}

/// A place on the curve.
#[derive(Clone, Debug)]
pub struct Spot {
    slope: Slope,
    /// The sign of s.
    sheet: Ordering,
}

/// A part of a branch.
#[derive(Clone, Debug)]
pub struct Stretch {
    /// The branch, from 1; of two the first goes to infinity.
    pub branch: usize,
    /// Both ends, in the direction of the branch; `None` for all of a closed branch.
    pub ends: Option<[Spot; 2]>,
    /// A place between the ends.
    pub sample: Spot,
}

/// A part of a branch without a limit inside.
#[derive(Clone, Copy, Debug)]
struct Cell {
    /// Between the zeros number `interval` − 1 and `interval`.
    interval: usize,
    sheet: Ordering,
    ascending: bool,
}

/// Whether the wishes are fulfilled in a cell.
#[derive(Clone, Debug)]
enum Told {
    /// They are, for instance here.
    Yes(Spot),
    No,
    /// With the lenient bounds they are, with the strict ones not.
    Between,
}

/// A branch.
struct Branch {
    cells: Vec<Cell>,
    closed: bool,
}

/// All stretches, branch by branch; `None` where that cannot be told.
pub fn stretches(
    positions: &Positions<Exact>,
    pencils: &CongruentPencils,
    wishes: &Wishes,
) -> Option<Vec<Stretch>> {
    let curve = Curve::new(positions, pencils, wishes)?;
    let mut list = Vec::new();
    for (branch, place) in curve.branches()?.iter().zip(1..) {
        list.extend(curve.stretches_of(branch, place)?);
    }
    Some(list)
}

struct Curve<'a> {
    positions: &'a Positions<Exact>,
    pencils: &'a CongruentPencils,
    wishes: &'a Wishes,
    /// The zeros of the limits, ascending.
    zeros: Vec<Slope>,
    /// The places of those where s = 0.
    turning: Vec<usize>,
}

impl<'a> Curve<'a> {
    fn new(
        positions: &'a Positions<Exact>,
        pencils: &'a CongruentPencils,
        wishes: &'a Wishes,
    ) -> Option<Self> {
        // Linear ones first, so that rational zeros are known to be rational.
        let mut limits = vec![pencils.infinite_circlepoint()];
        limits.extend(wishes.limits(positions, pencils)?);
        limits.push(pencils.discriminant());
        limits.retain(|limit| limit.degree() != Some(0));
        limits.sort_by_key(Polynomial::degree);
        let mut zeros = Vec::new();
        let mut turning = Vec::new();
        let discriminant = pencils.discriminant();
        for (place, (root, of)) in real_roots(&limits).ok()?.into_iter().enumerate() {
            let is_linear = limits.get(of)?.degree() == Some(1);
            let of_discriminant = limits.get(of)?.gcd(&discriminant)?;
            let slope = match is_linear.then(|| root.rational()).flatten() {
                Some(t) => Slope::Rational(t),
                None => Slope::Root(root),
            };
            if vanishes(&of_discriminant, &slope)? {
                turning.push(place);
            }
            zeros.push(slope);
        }
        Some(Curve {
            positions,
            pencils,
            wishes,
            zeros,
            turning,
        })
    }

    /// The branches, that to infinity first.
    ///
    /// On the side of the midline on which the asymptote lies they run as the line from the focus turns
    /// counterclockwise, on a closed branch too.
    fn branches(&self) -> Option<Vec<Branch>> {
        let last = self.zeros.len();
        let near = match self.pencils.beta().sign()? {
            Ordering::Equal => Ordering::Greater,
            sign => sign,
        };
        let far = near.reverse();
        let up = |from: usize, to: usize, sheet: Ordering| {
            (from..=to).map(move |interval| Cell {
                interval,
                sheet,
                ascending: true,
            })
        };
        let down = |from: usize, to: usize, sheet: Ordering| {
            (to..=from).rev().map(move |interval| Cell {
                interval,
                sheet,
                ascending: false,
            })
        };
        let branch = |cells: Vec<Cell>, closed: bool| Branch { cells, closed };
        let only = |cells: Vec<Cell>| Some(vec![branch(cells, false)]);
        match (self.pencils.curve_type, self.turning.as_slice()) {
            (CurveType::TwoBranches, []) => Some(vec![
                branch(up(0, last, far).collect(), false),
                branch(up(0, last, near).collect(), true),
            ]),
            // Through the node the branch goes straight on.
            (CurveType::Nodal, &[node]) => {
                let out = up(0, node, far).chain(up(node + 1, last, near));
                only(
                    out.chain(up(0, node, near))
                        .chain(up(node + 1, last, far))
                        .collect(),
                )
            }
            // Between the two zeros of the discriminant there is no point; s changes its sign in them.
            (CurveType::OneBranch, &[first, second]) => {
                let out = up(0, first, far).chain(down(first, 0, near));
                let back = down(last, second + 1, near).chain(up(second + 1, last, far));
                only(out.chain(back).collect())
            }
            // The focus is on the asymptote, and one of the two zeros is infinite.
            (CurveType::OneBranch, &[turn]) => {
                let leading = self.pencils.discriminant().leading()?.sign()?;
                only(if leading.is_lt() {
                    up(0, turn, far).chain(down(turn, 0, near)).collect()
                } else {
                    down(last, turn + 1, near)
                        .chain(up(turn + 1, last, far))
                        .collect()
                })
            }
            _ => None,
        }
    }

    #[expect(
        clippy::indexing_slicing,
        reason = "all places are below the number of cells"
    )]
    fn stretches_of(&self, branch: &Branch, place: usize) -> Option<Vec<Stretch>> {
        let Branch { cells, closed } = branch;
        let count = cells.len();
        let told: Vec<Told> = cells
            .iter()
            .map(|cell| self.decided(*cell))
            .collect::<Option<_>>()?;
        let next = |here: usize| (*closed || here + 1 < count).then_some((here + 1) % count);
        let before = |here: usize| (*closed || here > 0).then_some((here + count - 1) % count);
        let is_yes = |here: usize| matches!(told[here], Told::Yes(_));
        // Whether a stretch goes on from this cell to the next one.
        let goes_on: Vec<bool> = (0..count)
            .map(|here| {
                is_yes(here)
                    && next(here).is_some_and(is_yes)
                    && self.passes(&self.end_of(&cells[here]))
            })
            .collect();
        if *closed && goes_on.iter().all(|goes_on| *goes_on) {
            let sample = told.into_iter().find_map(Told::sample);
            return Some(sample.map_or_else(Vec::new, |sample| {
                vec![Stretch {
                    branch: place,
                    ends: None,
                    sample,
                }]
            }));
        }
        // A cell of which nothing is told must be the end of one stretch.
        let mut ends_in_cells = 0;
        let mut end = |beyond: Option<usize>, otherwise: Spot| {
            let beyond = beyond.filter(|place| matches!(told[*place], Told::Between));
            ends_in_cells += usize::from(beyond.is_some());
            beyond.map_or(Some(otherwise), |place| self.within(&cells[place]))
        };
        let begins = |here: usize| is_yes(here) && !goes_on[(here + count - 1) % count];
        let mut list = Vec::new();
        for first in (0..count).filter(|here| begins(*here)) {
            let mut length = 1;
            while goes_on[(first + length - 1) % count] {
                length += 1;
            }
            let last = (first + length - 1) % count;
            list.push(Stretch {
                branch: place,
                ends: Some([
                    end(before(first), self.start_of(&cells[first]))?,
                    end(next(last), self.end_of(&cells[last]))?,
                ]),
                sample: told[(first + length / 2) % count].clone().sample()?,
            });
        }
        let between = told.iter().filter(|told| matches!(told, Told::Between));
        (between.count() == ends_in_cells).then_some(list)
    }

    /// A place somewhere in a cell.
    fn within(&self, cell: &Cell) -> Option<Spot> {
        let ends = [self.start_of(cell), self.end_of(cell)];
        let sound = |end: &Spot| end.slope.bounds().is_some() && end.sheet == cell.sheet;
        ends.iter().all(sound).then(|| Spot {
            slope: Slope::Between(Box::new(ends.map(|end| end.slope))),
            sheet: cell.sheet,
        })
    }

    fn start_of(&self, cell: &Cell) -> Spot {
        self.zero(cell, !cell.ascending)
    }

    fn end_of(&self, cell: &Cell) -> Spot {
        self.zero(cell, cell.ascending)
    }

    /// The upper or the lower end of a cell.
    fn zero(&self, cell: &Cell, upper: bool) -> Spot {
        let place = if upper {
            Some(cell.interval)
        } else {
            cell.interval.checked_sub(1)
        };
        let slope = place.and_then(|place| self.zeros.get(place));
        let turns = place.is_some_and(|place| self.turning.contains(&place));
        Spot {
            slope: slope.cloned().unwrap_or(Slope::Infinite),
            sheet: if turns { Ordering::Equal } else { cell.sheet },
        }
    }

    /// What holds in a cell; `None` where that is not decided.
    fn decided(&self, cell: Cell) -> Option<Told> {
        let bound = |upper: bool| self.zero(&cell, upper).slope;
        let (low, high) = (bound(false), bound(true));
        for attempt in 0..SAMPLES {
            let slope = between(
                low.bounds().map(|b| b[1]),
                high.bounds().map(|b| b[0]),
                attempt,
            );
            let spot = Spot {
                slope: Slope::Rational(slope),
                sheet: cell.sheet,
            };
            let Fulfilled { surely, perhaps } = self.fulfilled(&spot);
            match (surely, perhaps) {
                (Truth::Yes, _) => return Some(Told::Yes(spot)),
                (_, Truth::No) => return Some(Told::No),
                (Truth::No, Truth::Yes) => return Some(Told::Between),
                _ => {}
            }
        }
        None
    }

    /// Whether a stretch goes on through a zero of the limits: it is one by chance, or of another sheet.
    fn passes(&self, spot: &Spot) -> bool {
        let pair = spot.pair(self.pencils, BITS[0]);
        let is_finite = |point: &ProjectivePoint<Ball>| !point.is_at_infinity().is_yes();
        is_finite(&pair.center)
            && is_finite(&pair.circlepoint)
            && self.fulfilled(spot).surely.is_yes()
    }

    fn fulfilled(&self, spot: &Spot) -> Fulfilled {
        let mut fulfilled = Fulfilled::from(Truth::Unknown);
        let mut bits = BITS[0];
        while bits <= BITS[1] {
            let pair = spot.pair(self.pencils, bits);
            if let (Some(center), Some(circlepoint)) =
                (pair.center.finite(), pair.circlepoint.finite())
            {
                let dyad = Dyad {
                    center,
                    circlepoint,
                };
                let positions = self.positions.displacements();
                fulfilled = self.wishes.fulfilled(positions, &dyad, bits);
                if fulfilled.is_decided() {
                    break;
                }
            }
            bits *= 4;
        }
        fulfilled
    }
}

impl Told {
    fn sample(self) -> Option<Spot> {
        match self {
            Told::Yes(spot) => Some(spot),
            Told::No | Told::Between => None,
        }
    }
}

impl Spot {
    /// The pair there, enclosed with so many bits.
    pub fn pair(&self, pencils: &CongruentPencils, bits: u32) -> Dyad<ProjectivePoint<Ball>> {
        let slope = self.slope.enclosure(bits);
        let square = pencils.square(&slope);
        let s = match self.sheet {
            Ordering::Equal => Number::zero(),
            Ordering::Greater => root(&square, bits),
            Ordering::Less => -root(&square, bits),
        };
        pencils.pair(&slope, &s)
    }
}

/// √x, exact where x is known to be the square of a rational number.
fn root(x: &Number<Ball>, bits: u32) -> Number<Ball> {
    let exact = || {
        let x = &x.0;
        x.radius_rational().filter(Rational::is_zero)?;
        rational_sqrt(x.midpoint_rational().filter(|x| x.cmp0().is_ge())?)
    };
    match exact() {
        Some(root) => Number::from(root),
        None => Number(x.0.with_precision(bits)).sqrt(),
    }
}

/// Whether a polynomial without roots near that slope, other than perhaps there, vanishes there.
fn vanishes(polynomial: &Polynomial<Exact>, slope: &Slope) -> Option<bool> {
    match slope {
        Slope::Rational(t) => Some(polynomial.sign_at(t)?.is_eq()),
        Slope::Root(root) if polynomial.degree() > Some(0) => {
            let (low, high) = (root.low(), root.high());
            let sequence = polynomial.sturm_sequence()?;
            let inside = sequence.count_between(low, high);
            Some(inside > 0 || polynomial.sign_at(low)?.is_eq())
        }
        _ => Some(false),
    }
}

/// A simple number between two others, each time a different one.
fn between(low: Option<&Rational>, high: Option<&Rational>, attempt: u32) -> Rational {
    let beyond = Rational::from((1 + attempt, 1 + attempt / 2));
    let (low, high) = match (low, high) {
        (Some(low), Some(high)) => (low.clone(), high.clone()),
        (Some(low), None) => (low.clone(), low + beyond * 2u32),
        (None, Some(high)) => (high - beyond * 2u32, high.clone()),
        (None, None) => (-beyond.clone() * 2u32, beyond * 3u32),
    };
    let width = Rational::from(&high - &low);
    let target = low + Rational::from(&width * &Rational::from((3 + attempt, 7)));
    // Few binary digits, so that it stays within a seventh of the width.
    let margin = width / 8u32;
    let mut bits = 0;
    loop {
        let simple = Rational::from(&target << bits).round() >> bits;
        if Rational::from(&simple - &target).abs() < margin {
            return simple;
        }
        bits += 1;
    }
}
