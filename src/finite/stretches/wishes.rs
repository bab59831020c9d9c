//! What a designer wishes of a center and its circlepoint.

use std::cmp::Ordering;

use super::congruent_pencils::{CongruentPencils, Dyad, constant_point, in_kind};
use crate::finite::positions::Positions;
use crate::linkage::movability;
use crate::linkage::passage::{Drive, Passage};
use crate::number::{Ball, Exact, Kind, Number, Polynomial, Radical, Truth};
use crate::plane::Point;
use crate::plane::displacement::Displacement;
use crate::plane::region_edges::Region;

/// All wishes; what is not wished is missing or false.
#[derive(Clone, Debug, Default)]
pub struct Wishes {
    /// Where the center may be, in the fixed plane.
    pub centers: Option<Region>,
    /// Where the circlepoint may be, in the moving plane.
    pub circlepoints: Option<Region>,
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
}

fn equal(signs: Option<Vec<Ordering>>) -> Truth {
    signs.map_or(Truth::Unknown, |signs| {
        signs.windows(2).all(|pair| pair[0] == pair[1]).into()
    })
}

impl Wishes {
    /// Polynomials in the slope of the pencils: where the truth of a wish changes along a branch, one of
    /// them vanishes, or the center or the circlepoint is at infinity. `None` where a condition holds all
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
            functions.extend(region.edges(&dyad.center));
        }
        if let Some(region) = &self.circlepoints {
            functions.extend(region.edges(&dyad.circlepoint));
        }
        if let Some(beside) = &self.beside {
            let passage = beside.passage(positions.displacements(), &dyad, |x| x);
            if beside.crank_driven || beside.without_defects {
                functions.extend(movability::limits_of_turning(&passage));
            }
            if beside.without_defects {
                functions.extend(movability::limits_of_sides(&passage));
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
    ) -> Truth {
        let within = |region: &Option<Region>, point: &Point<Ball>| {
            region
                .as_ref()
                .map_or(Truth::Yes, |region| region.contains(point))
        };
        let mut truth =
            within(&self.centers, &dyad.center) & within(&self.circlepoints, &dyad.circlepoint);
        if self.in_order && !truth.is_no() {
            let places = positions.iter().map(|d| in_kind(d).of(&dyad.circlepoint));
            truth = truth & movability::in_order(&places.collect::<Vec<_>>());
        }
        match &self.beside {
            Some(beside) if !truth.is_no() => truth & beside.fulfilled(positions, dyad, bits),
            _ => truth,
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
        let given = constant_point::<K>(&self.given.circlepoint);
        let places = |position: &Displacement<Exact>| {
            let position = in_kind::<K>(position);
            [position.of(&given), position.of(&sought.circlepoint)].map(&round)
        };
        Passage {
            pivots: [constant_point(&self.given.center), sought.center.clone()].map(&round),
            joints: positions.iter().map(places).collect(),
        }
    }

    fn fulfilled(
        &self,
        positions: &[Displacement<Exact>],
        sought: &Dyad<Point<Ball>>,
        bits: u32,
    ) -> Truth {
        // Roots of constants need a precision.
        let round = |point: Point<Ball>| {
            let part = |x: &Number<Ball>| Number(x.0.with_precision(bits));
            Number::complex(part(point.re()), part(point.im()))
        };
        let passage = self.passage(positions, sought, round);
        let mut truth = Truth::Yes;
        if self.without_defects && self.drive == Drive::First && self.stands_still(positions) {
            return Truth::No;
        }
        if self.crank_driven {
            truth = movability::drive_turns(&passage, self.drive);
        }
        if self.without_defects && !truth.is_no() {
            truth = truth
                & movability::is_one_circuit(&passage)
                & equal(passage.assembly(self.drive))
                & movability::passes_in_order(&passage, self.drive);
        }
        truth
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
