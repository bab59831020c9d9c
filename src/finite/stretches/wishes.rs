//! What a designer wishes of a center and its circlepoint.

use std::cmp::Ordering;

use super::congruent_pencils::{CongruentPencils, Dyad};
use crate::finite::positions::Positions;
use crate::linkage::passage::{Drive, Joint, Passage, Type, is_in_order};
use crate::number::{Ball, Exact, Kind, Number, Polynomial, Radical, Real, Truth, array};
use crate::plane::displacement::Displacement;
use crate::plane::region::Region;
use crate::plane::{Point, relation};

/// All wishes; what is not wished is missing or false.
#[derive(Clone, Debug, Default)]
pub struct Wishes {
    /// Where the center may be, in the fixed plane.
    pub centers: Option<Region<Exact>>,
    /// Where the circlepoint may be, in the moving plane.
    pub circlepoints: Option<Region<Exact>>,
    /// The link turns through the positions 1, 2, 3, 4 in one direction within one turn.
    pub in_order: bool,
    /// A link that is given beside the one that is sought.
    pub beside: Option<Beside>,
}

/// A link that is given, and what is wished of the four-bar that it makes with the one that is sought.
#[derive(Clone, Debug)]
pub struct Beside {
    /// Its center and circlepoint.
    pub given: Dyad<Point<Exact>>,
    /// Which link drives: the first one is the given one.
    pub drive: Drive,
    /// The driving link turns fully.
    pub crank_driven: bool,
    /// All positions are on one circuit and between the same dead centres of the driving link, which
    /// passes them in order, one way or the other.
    pub without_defects: bool,
    /// The transmission angle is at least so large while the driving link goes through all positions,
    /// which are on one circuit and between the same dead centres.
    pub least_transmission: Option<LeastTransmission>,
}

/// How small the transmission angle may become.
#[derive(Clone, Debug)]
pub struct LeastTransmission {
    /// Two bounds of the square of its cosine; equal where that is rational.
    pub square_of_cosine: [Number<Exact>; 2],
}

/// Whether wishes are fulfilled that are known within bounds.
#[derive(Clone, Copy, Debug)]
pub struct Fulfilled {
    /// With the stricter bounds: then surely.
    pub surely: Truth,
    /// With the more lenient ones: where not, then surely not.
    pub perhaps: Truth,
}

impl From<Truth> for Fulfilled {
    fn from(truth: Truth) -> Self {
        Fulfilled {
            surely: truth,
            perhaps: truth,
        }
    }
}

impl Fulfilled {
    /// Whether both are decided.
    pub fn is_decided(&self) -> bool {
        !self.surely.is_unknown() && !self.perhaps.is_unknown()
    }

    fn and(self, other: Self) -> Self {
        Fulfilled {
            surely: self.surely & other.surely,
            perhaps: self.perhaps & other.perhaps,
        }
    }
}

impl Wishes {
    /// Polynomials in the slope of the pencils: where the truth of a wish, with either of its bounds,
    /// changes along a branch, one of them vanishes, or the center or the circlepoint is at infinity. `None` where a condition holds all
    /// along the curve, so that no sign tells anything.
    pub fn limits(
        &self,
        positions: &Positions<Exact>,
        pencils: &CongruentPencils,
    ) -> Option<Vec<Polynomial<Exact>>> {
        let mut limits = Vec::new();
        if self.in_order
            || self
                .beside
                .as_ref()
                .is_some_and(|beside| beside.without_defects)
        {
            // Two places of a point on a circle about its center change their order where they are one:
            // in an image pole.
            let inverse = positions.inverse();
            let poles = positions
                .pairs()
                .filter_map(|(i, j)| inverse.pole(i, j)?.finite());
            limits.extend(poles.map(|pole| pencils.slope_of_circlepoint(&pole)));
        }
        let dyad = pencils.functions()?;
        let mut functions: Vec<Number<Radical>> = Vec::new();
        if let Some(region) = &self.centers {
            functions.extend(region.in_kind().edges(&dyad.center));
        }
        if let Some(region) = &self.circlepoints {
            functions.extend(region.in_kind().edges(&dyad.circlepoint));
        }
        if let Some(beside) = self.beside.as_ref().filter(|beside| beside.wishes()) {
            let passage = beside.passage(positions.displacements(), &dyad, |x| x);
            functions.push(passage.limit_of_type()?);
            if beside.without_defects || beside.least_transmission.is_some() {
                functions.extend(passage.limits_of_sides(beside.drive));
            }
            for square in beside.squares_of_cosines() {
                functions.extend(passage.limits_of_transmission(beside.drive, &square.in_kind())?);
            }
        }
        for function in functions {
            limits.push(function.0.norm()?);
        }
        limits
            .iter()
            .all(|limit| !limit.is_zero())
            .then_some(limits)
    }

    /// Whether a pair fulfils all wishes, in balls of so many bits.
    pub fn fulfilled(
        &self,
        positions: &[Displacement<Exact>],
        dyad: &Dyad<Point<Ball>>,
        bits: u32,
    ) -> Fulfilled {
        let within = |region: &Option<Region<Exact>>, point: &Point<Ball>| {
            region
                .as_ref()
                .map_or(Truth::Yes, |region| region.in_kind().contains(point))
        };
        let mut truth =
            within(&self.centers, &dyad.center) & within(&self.circlepoints, &dyad.circlepoint);
        if self.in_order && !truth.is_no() {
            let places = positions.iter().map(|d| d.in_kind().of(&dyad.circlepoint));
            truth = truth & one_way(&places.collect::<Vec<_>>());
        }
        match &self.beside {
            Some(beside) if !truth.is_no() => {
                Fulfilled::from(truth).and(beside.fulfilled(positions, dyad, bits))
            }
            _ => truth.into(),
        }
    }
}

impl Beside {
    fn passage<K: Kind>(
        &self,
        positions: &[Displacement<Exact>],
        sought: &Dyad<Point<K>>,
        round: impl Fn(Point<K>) -> Point<K>,
    ) -> Passage<K> {
        let joints = |pair: [Point<K>; 2]| pair.map(|point| Joint::At(round(point)));
        let given = self.given.circlepoint.in_kind::<K>();
        let places = |position: &Displacement<Exact>| {
            let position = position.in_kind::<K>();
            joints([position.of(&given), position.of(&sought.circlepoint)])
        };
        Passage {
            pivots: joints([self.given.center.in_kind(), sought.center.clone()]),
            joints: positions.iter().map(places).collect(),
        }
    }

    /// Whether anything is wished of the linkage.
    fn wishes(&self) -> bool {
        self.crank_driven || self.without_defects || self.least_transmission.is_some()
    }

    /// The bounds of the square of the cosine of the transmission angle, each once.
    fn squares_of_cosines(&self) -> Vec<&Number<Exact>> {
        let Some(LeastTransmission { square_of_cosine }) = &self.least_transmission else {
            return Vec::new();
        };
        let [low, high] = square_of_cosine;
        if low.equals(high).is_yes() {
            vec![low]
        } else {
            vec![low, high]
        }
    }

    fn fulfilled(
        &self,
        positions: &[Displacement<Exact>],
        sought: &Dyad<Point<Ball>>,
        bits: u32,
    ) -> Fulfilled {
        // Roots of constants need a precision.
        let round = |point: Point<Ball>| {
            let part = |x: &Number<Ball>| Number(x.0.with_precision(bits));
            Number::complex(part(point.re()), part(point.im()))
        };
        let passage = self.passage(positions, sought, round);
        let known = |value: Option<bool>| value.map_or(Truth::Unknown, Truth::from);
        let turns_fully = match passage.is_crank(self.drive) {
            // In a change point the motion is not determined.
            Some(true) => passage.link_type().map(|kind| kind != Type::ChangePoint),
            other => other,
        };
        let mut truth = Truth::Yes;
        if self.crank_driven {
            truth = known(turns_fully);
        }
        if self.without_defects && !truth.is_no() {
            truth = truth & known(self.passes(&passage, turns_fully, positions));
        }
        match &self.least_transmission {
            Some(least) if !truth.is_no() => {
                Fulfilled::from(truth).and(self.transmits(&passage, least))
            }
            _ => truth.into(),
        }
    }

    /// Whether the transmission angle stays large enough.
    fn transmits(&self, passage: &Passage<Ball>, least: &LeastTransmission) -> Fulfilled {
        match passage.branch(self.drive) {
            None => return Truth::Unknown.into(),
            Some(reached) if reached.contains(&false) => return Truth::No.into(),
            Some(_) => {}
        }
        let cosines = passage.transmission(self.drive);
        let [surely, perhaps] = least.square_of_cosine.each_ref().map(|bound| {
            let bound = bound.in_kind::<Ball>();
            cosines.as_ref().map_or(Truth::Unknown, |cosines| {
                let within = |cosine: &Number<Ball>| {
                    Truth::of_sign(cosine.square().compare(&bound), Ordering::is_le)
                };
                Truth::all(cosines.iter().map(within))
            })
        });
        Fulfilled { surely, perhaps }
    }

    /// Whether the driving link reaches all positions without a dead centre, one after the other.
    fn passes(
        &self,
        passage: &Passage<Ball>,
        turns_fully: Option<bool>,
        positions: &[Displacement<Exact>],
    ) -> Option<bool> {
        if self.drive == Drive::First && self.stands_still(positions) {
            return Some(false);
        }
        let reaches_all = passage.branch(self.drive)?.into_iter().all(|one| one);
        if !reaches_all {
            return Some(false);
        }
        Some(is_in_order(&passage.order(self.drive)?, turns_fully?))
    }

    /// Whether the given link is in one place in two of the positions.
    fn stands_still(&self, positions: &[Displacement<Exact>]) -> bool {
        let places: Vec<Point<Exact>> = positions
            .iter()
            .map(|d| d.of(&self.given.circlepoint))
            .collect();
        let mut rest = places.as_slice();
        while let Some((first, others)) = rest.split_first() {
            if others.iter().any(|other| first.equals(other).is_yes()) {
                return true;
            }
            rest = others;
        }
        false
    }
}

/// Whether three or more points of a circle are passed one after the other by one turn, one way or the
/// other: the triangles of the first one and two neighbours turn alike. Not where two coincide.
fn one_way<K: Real>(places: &[Point<K>]) -> Truth {
    let Some((first, rest)) = places.split_first() else {
        return Truth::Yes;
    };
    let turns: Vec<Option<Ordering>> = array::neighbours(rest)
        .map(|(one, next)| relation::twice_area(first, one, next).sign())
        .collect();
    let all = |wanted: Ordering| {
        let is = |sign: &Option<Ordering>| Truth::of_sign(*sign, |sign| sign == wanted);
        Truth::all(turns.iter().map(is))
    };
    all(Ordering::Less) | all(Ordering::Greater)
}
