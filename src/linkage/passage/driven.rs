//! What the driving link moves: the coupler and the driven link, by their transmission angle.
//!
//! The transmission angle γ is at B, between coupler and driven link; of a slide, between the coupler
//! and the direction towards B₀; of a turning block, between the normal of the coupler's line, along
//! which the coupler pushes, and the line from B₀ to A, in [0, 90°]. A coupler that slides in a driving
//! block pushes along the normal of its line, towards A at infinity. The closure is |cos γ| ≤ 1, and a
//! dead centre is where γ is 0 or 180°.

use std::cmp::Ordering;

use super::joint::{dot, unit};
use super::{Joint, Passage};
use crate::number::{Number, Real};
use crate::plane::{Point, relation};

/// Coupler and driven link, by what cos γ depends on beside the place of the driving link.
pub(super) enum Driven<K> {
    /// A link about B₀, by AB and BB₀: cos γ = (AB² + BB₀² − AB₀²)/(2 AB · BB₀).
    Link {
        pivot: Point<K>,
        coupler: Number<K>,
        link: Number<K>,
    },
    /// A slide, its normal n of length 1 and n · B: cos γ = (n · A − n · B)/AB.
    Slide {
        normal: Point<K>,
        level: Number<K>,
        coupler: Number<K>,
    },
    /// A block about B₀, by the distance f of A from the coupler's line: cos γ = f/AB₀.
    Block { pivot: Point<K>, offset: Number<K> },
    /// A link about B₀ behind a driving block with the normal ν of length 1, by A₀B₀ and ν · A₀B:
    /// cos γ = (ν · A₀B₀ − ν · A₀B)/BB₀.
    LinkOfBlock {
        base: Point<K>,
        offset: Number<K>,
        link: Number<K>,
    },
    /// A slide behind a driving block, by its normal n of length 1: cos γ = ν · n.
    SlideOfBlock { normal: Point<K> },
    /// A block behind a driving block: both turn with the coupler, and there is no such angle.
    BlockOfBlock,
}

impl<K: Real> Driven<K> {
    /// Of a linkage that A₀A drives.
    pub(super) fn of(passage: &Passage<K>) -> Option<Self> {
        use Joint::{At, Towards};
        let [p, q] = &passage.pivots;
        let [a, b] = passage.joints.first()?;
        Some(match (a, b, q) {
            (At(a), At(b), At(q)) => Driven::Link {
                pivot: q.clone(),
                coupler: relation::distance(a, b),
                link: relation::distance(b, q),
            },
            (At(a), At(b), Towards(q)) => {
                let normal = unit(q);
                Driven::Slide {
                    level: dot(&normal, b),
                    normal,
                    coupler: relation::distance(a, b),
                }
            }
            (At(a), Towards(b), At(q)) => Driven::Block {
                pivot: q.clone(),
                offset: dot(&unit(b), &(a - q)).abs(),
            },
            (Towards(a), At(b), At(q)) => Driven::LinkOfBlock {
                base: q - p.point()?,
                offset: dot(&unit(a), &(b - p.point()?)),
                link: relation::distance(b, q),
            },
            (Towards(_), At(_), Towards(q)) => Driven::SlideOfBlock { normal: unit(q) },
            (Towards(_), Towards(_), At(_)) => Driven::BlockOfBlock,
            (_, Towards(_), Towards(_)) => return None,
        })
    }

    /// cos γ, where A is in this point or the normal of the driving block is this vector of length 1.
    pub(super) fn cosine(&self, driving: &Point<K>) -> Option<Number<K>> {
        Some(match self {
            Driven::Link { pivot, .. } | Driven::Block { pivot, .. } => {
                self.cosine_across(&relation::distance_squared(driving, pivot))?
            }
            Driven::Slide { normal, .. } => self.cosine_along(&dot(normal, driving))?,
            Driven::LinkOfBlock { base, .. } => self.cosine_along(&dot(base, driving))?,
            Driven::SlideOfBlock { normal } => dot(normal, driving),
            Driven::BlockOfBlock => return None,
        })
    }

    /// cos γ by AB₀².
    pub(super) fn cosine_across(&self, square: &Number<K>) -> Option<Number<K>> {
        match self {
            Driven::Link { coupler, link, .. } => {
                let product = coupler * link;
                Some((coupler.square() + link.square() - square) / (2 * product))
            }
            Driven::Block { offset, .. } => Some(offset / square.clone().sqrt()),
            _ => None,
        }
    }

    /// cos γ by n · A, or by ν · A₀B₀.
    pub(super) fn cosine_along(&self, place: &Number<K>) -> Option<Number<K>> {
        match self {
            Driven::Slide { level, coupler, .. } => Some((place - level) / coupler),
            Driven::LinkOfBlock { offset, link, .. } => Some((place - offset) / link),
            _ => None,
        }
    }

    /// The sign of sin²γ by AB₀²: less than zero where the linkage does not close.
    pub(super) fn room_across(&self, square: &Number<K>) -> Option<Ordering> {
        match self {
            Driven::Link { coupler, link, .. } => {
                let outwards = ((coupler + link).square() - square).sign()?;
                let inwards = (square - (coupler - link).square()).sign()?;
                Some(outwards.min(inwards))
            }
            Driven::Block { offset, .. } => (square - offset.square()).sign(),
            _ => None,
        }
    }

    /// The sign of sin²γ by n · A, or by ν · A₀B₀.
    pub(super) fn room_along(&self, place: &Number<K>) -> Option<Ordering> {
        match self {
            Driven::Slide { level, coupler, .. } => {
                (coupler.square() - (place - level).square()).sign()
            }
            Driven::LinkOfBlock { offset, link, .. } => {
                (link.square() - (place - offset).square()).sign()
            }
            _ => None,
        }
    }
}
