//! The driving link: where it is in each position, and where it can be at all.
//!
//! On its way, cos γ is least or greatest only in its *gates*: where a turning link has the direction
//! of the base (of the normal of the driven slide) or the opposite one, where a slider is next to B₀.
//! A gate is free, or barred because the linkage does not close there, or all joints are on a line in
//! it. Between gates cos γ is monotone. So the gates tell how far the driving link moves.

use std::cmp::Ordering;

use super::driven::Driven;
use super::joint::{cross, dot, twice_area, unit};
use super::{Drive, Joint, Passage};
use crate::number::{Number, Real};
use crate::plane::Point;

/// A driving link and what it drives.
pub(super) struct Driver<K> {
    /// The linkage, with A₀A as the driving link.
    pub passage: Passage<K>,
    pub driven: Driven<K>,
    pub motion: Motion<K>,
}

/// How the driving link moves.
pub(super) enum Motion<K> {
    /// It turns; a link or a block.
    Turn(Turn<K>),
    /// It slides.
    Slide(Slide<K>),
}

/// A turning link.
pub(super) struct Turn<K> {
    /// From A₀ to A in each position, or the normal of the block.
    pub directions: Vec<Point<K>>,
    /// Their length.
    pub length: Number<K>,
    /// A₀, for a link.
    pub pivot: Option<Point<K>>,
    /// The direction of the first gate; the second is opposite. `None` where all directions are alike.
    pub axis: Option<Point<K>>,
}

/// A slider.
pub(super) struct Slide<K> {
    /// The direction of the slide, of length 1: counterclockwise about A₀.
    pub along: Point<K>,
    /// A in the first position.
    pub origin: Point<K>,
    /// How far A is from there in each position.
    pub places: Vec<Number<K>>,
    /// How far the gate is from there, if there is one.
    pub gate: Option<Number<K>>,
}

/// What a gate allows; `None` where that cannot be told.
pub(super) type Room = Option<Ordering>;

impl<K: Real> Driver<K> {
    pub(super) fn of(passage: &Passage<K>, drive: Drive) -> Option<Self> {
        let passage = passage.seen_from(drive);
        let driven = Driven::of(&passage)?;
        let motion = motion(&passage)?;
        Some(Driver {
            passage,
            driven,
            motion,
        })
    }

    /// The side on which B lies of the line from A to B₀: it changes in dead centres only.
    pub(super) fn assembly(&self) -> Vec<Option<Ordering>> {
        let [_, q] = &self.passage.pivots;
        let joints = self.passage.joints.iter();
        joints.map(|[a, b]| twice_area(a, b, q).sign()).collect()
    }

    /// On which side of its gates the driving link is.
    pub(super) fn sides(&self) -> Vec<Option<Ordering>> {
        match &self.motion {
            Motion::Turn(turn) => {
                let side = |direction| cross(turn.axis.as_ref()?, direction).sign();
                turn.directions.iter().map(side).collect()
            }
            Motion::Slide(slide) => {
                let side = |place: &Number<K>| place.compare(slide.gate.as_ref()?);
                slide.places.iter().map(side).collect()
            }
        }
    }

    /// What both gates of a turning link allow.
    pub(super) fn rooms(&self, turn: &Turn<K>) -> [Room; 2] {
        if matches!(self.driven, Driven::SlideOfBlock { .. }) {
            // The slider would be at infinity.
            return [Some(Ordering::Less); 2];
        }
        if matches!(self.driven, Driven::BlockOfBlock) {
            return [Some(Ordering::Greater); 2];
        }
        self.gates(turn).map(|gate| match gate? {
            Gate::Across(square) => self.driven.room_across(&square),
            Gate::Along(place) => self.driven.room_along(&place),
        })
    }

    /// cos γ in both gates of a turning link.
    pub(super) fn cosines(&self, turn: &Turn<K>) -> [Option<Number<K>>; 2] {
        self.gates(turn).map(|gate| match gate? {
            Gate::Across(square) => self.driven.cosine_across(&square),
            Gate::Along(place) => self.driven.cosine_along(&place),
        })
    }

    fn gates(&self, turn: &Turn<K>) -> [Option<Gate<K>>; 2] {
        [-1, 1].map(|outwards| {
            let length = &turn.length;
            Some(match &self.driven {
                Driven::Link { pivot, .. } | Driven::Block { pivot, .. } => {
                    let base = (pivot - turn.pivot.as_ref()?).norm().sqrt();
                    Gate::Across((base + outwards * length).square())
                }
                Driven::Slide { normal, .. } => {
                    Gate::Along(dot(normal, turn.pivot.as_ref()?) - outwards * length)
                }
                Driven::LinkOfBlock { base, .. } => Gate::Along(-outwards * base.norm().sqrt()),
                Driven::SlideOfBlock { .. } | Driven::BlockOfBlock => return None,
            })
        })
    }

    /// What the gate of a slider allows; nothing bars one that has none.
    pub(super) fn room_beside(&self, slide: &Slide<K>) -> Room {
        match (&self.driven, &slide.gate) {
            (Driven::Link { pivot, .. } | Driven::Block { pivot, .. }, Some(_)) => {
                let across = cross(&slide.along, &(pivot - &slide.origin));
                self.driven.room_across(&across.square())
            }
            _ => Some(Ordering::Greater),
        }
    }
}

/// A place of the driving link by what cos γ depends on.
enum Gate<K> {
    /// AB₀².
    Across(Number<K>),
    /// n · A, or ν · A₀B₀.
    Along(Number<K>),
}

fn motion<K: Real>(passage: &Passage<K>) -> Option<Motion<K>> {
    let [p, q] = &passage.pivots;
    let first = passage.joints.first()?;
    let [_, b] = first;
    Some(match p {
        Joint::At(p) => {
            let directions = passage.joints.iter().map(|[a, _]| match a {
                Joint::At(a) => a - p,
                Joint::Towards(a) => unit(a),
            });
            let directions: Vec<Point<K>> = directions.collect();
            let axis = match (q, b) {
                (Joint::At(q), Joint::At(_)) => Some(q - p),
                (Joint::At(q), Joint::Towards(_)) => first[0].point().map(|_| q - p),
                (Joint::Towards(q), _) => Some(q.clone()),
            };
            Motion::Turn(Turn {
                length: match &first[0] {
                    Joint::At(_) => directions.first()?.norm().sqrt(),
                    Joint::Towards(_) => Number::one(),
                },
                pivot: first[0].point().map(|_| p.clone()),
                directions,
                axis,
            })
        }
        Joint::Towards(p) => {
            // Counterclockwise about a point far away in the direction p: p turned by −90°.
            let along = -(Number::i() * unit(p));
            let origin = first[0].point()?.clone();
            let places: Option<Vec<Number<K>>> = passage
                .joints
                .iter()
                .map(|[a, _]| Some(dot(&along, &(a.point()? - &origin))))
                .collect();
            Motion::Slide(Slide {
                gate: q.point().map(|q| dot(&along, &(q - &origin))),
                places: places?,
                origin,
                along,
            })
        }
    })
}
