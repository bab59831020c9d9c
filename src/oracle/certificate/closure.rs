//! The motion of a linkage, from the quadratic equations of its joints.
//!
//! Cosine c and sine s of the turn and the place x + iy of the moving origin are four series in one
//! parameter, one of s, x, y. c² + s² and what each of two links keeps are quadratic in them: what each
//! gives for tⁿ is linear in the terms in tⁿ, with the same four rows for every n.

use super::conditions::Group;
use crate::number::linear::solution;
use crate::number::{Exact, Number};
use crate::oracle::ProblemError;
use crate::oracle::input::Fields;
use crate::oracle::positions::point;
use crate::plane::displacement::Displacement;

type Point = crate::plane::Point<Exact>;
/// c, s, x, y.
type Pose = [Number<Exact>; 4];

/// A joint's link, of the places in the position that t = 0 stands for.
pub enum Link {
    /// |rz + p − M|² stays.
    Crank { circlepoint: Point, center: Point },
    /// n · (rz + p) stays.
    Slide { circlepoint: Point, normal: Point },
    /// rn · (M − p) stays.
    Block { normal: Point, center: Point },
}

impl Link {
    /// By circlepoint and center, of which one may be at infinity.
    pub fn read(fields: &Fields<'_>) -> Result<Self, ProblemError> {
        let end = |name: &str| -> Result<(bool, Point), ProblemError> {
            Ok(if fields.get(name)?.is_object() {
                let direction = fields.object(name)?.point("at_infinity")?;
                (true, point(&direction))
            } else {
                (false, point(&fields.point(name)?))
            })
        };
        Ok(match (end("circlepoint")?, end("center")?) {
            ((false, circlepoint), (true, normal)) => Link::Slide {
                circlepoint,
                normal,
            },
            ((true, normal), (_, center)) => Link::Block { normal, center },
            ((_, circlepoint), (_, center)) => Link::Crank {
                circlepoint,
                center,
            },
        })
    }

    /// What stays, as a symmetric form of order two, and a linear one.
    fn product(&self, left: &Pose, right: &Pose) -> Number<Exact> {
        match self {
            Link::Crank { circlepoint, .. } => {
                dot(&place(left, circlepoint), &place(right, circlepoint))
            }
            Link::Slide { .. } => Number::zero(),
            Link::Block { normal, .. } => {
                let part = |[c, s, ..]: &Pose, [_, _, x, y]: &Pose| {
                    let turned = Number::complex(c.clone(), s.clone()) * normal;
                    dot(&turned, &Number::complex(x.clone(), y.clone()))
                };
                -(part(left, right) + part(right, left)) / 2
            }
        }
    }

    fn linear(&self, pose: &Pose) -> Number<Exact> {
        match self {
            Link::Crank {
                circlepoint,
                center,
            } => -2 * dot(center, &place(pose, circlepoint)),
            Link::Slide {
                circlepoint,
                normal,
            } => dot(normal, &place(pose, circlepoint)),
            Link::Block { normal, center } => {
                let [c, s, ..] = pose;
                dot(&(Number::complex(c.clone(), s.clone()) * normal), center)
            }
        }
    }
}

fn dot(left: &Point, right: &Point) -> Number<Exact> {
    (left.conj() * right).re().clone()
}

/// rz + p.
fn place([c, s, x, y]: &Pose, z: &Point) -> Point {
    Number::complex(c.clone(), s.clone()) * z + Number::complex(x.clone(), y.clone())
}

/// To terms in tⁿ; t is the sine wherever the motion starts with a turn. `None` where the equations do
/// not determine it.
pub fn motion(links: &[Link; 2], order: usize) -> Option<Group<Exact>> {
    let start = pose([1, 0, 0, 0]);
    let axes = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]].map(pose);
    let mut rows: Vec<Vec<Number<Exact>>> = links
        .iter()
        .map(|link| {
            let slope = |axis: &Pose| 2 * link.product(&start, axis) + link.linear(axis);
            axes.iter().map(slope).collect()
        })
        .collect();
    // c² + s² in (1, 0).
    rows.push(pose([2, 0, 0, 0]).to_vec());
    (1..4).find_map(|parameter| {
        let mut rows = rows.clone();
        rows.push(axes.get(parameter)?.to_vec());
        let mut poses = vec![start.clone()];
        for n in 1..=order {
            let next = next(links, &rows, &poses, i64::from(n == 1))?;
            poses.push(next);
        }
        Some(poses.into_iter().map(displacement).collect())
    })
}

/// The terms in tⁿ from those before.
fn next(
    links: &[Link; 2],
    rows: &[Vec<Number<Exact>>],
    poses: &[Pose],
    parameter: i64,
) -> Option<Pose> {
    let inner = poses.get(1..).unwrap_or_default();
    let pairs = || inner.iter().zip(inner.iter().rev());
    let kept = |link: &Link| {
        -pairs()
            .map(|(a, b)| link.product(a, b))
            .sum::<Number<Exact>>()
    };
    let unit = -pairs()
        .map(|([c, s, ..], [c1, s1, ..])| c * c1 + s * s1)
        .sum::<Number<Exact>>();
    let [first, second] = links.each_ref().map(kept);
    let right = [first, second, unit, Number::from(parameter)];
    let rows: Vec<Vec<Number<Exact>>> = rows
        .iter()
        .zip(right)
        .map(|(row, right)| row.iter().cloned().chain([right]).collect())
        .collect();
    solution(&rows)?.try_into().ok()
}

fn pose(parts: [i64; 4]) -> Pose {
    parts.map(Number::from)
}

fn displacement([c, s, x, y]: Pose) -> Displacement<Exact> {
    Displacement {
        rotation: Number::complex(c, s),
        translation: Number::complex(x, y),
    }
}
