//! The pairs that linkages are made of, finite and at infinity, in exact numbers where these are known.

use serde_json::{Value, json};

use super::super::numeral::Numeral;
use super::super::output;
use crate::linkage::passage::{Joint, Passage};
use crate::number::{Ball, Exact, Number, Surd};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// A pair as a chain of two links, from the moving plane to the fixed one.
#[derive(Clone)]
pub struct Dyad {
    /// How the answer names it: its place in `pairs`, or in `at_infinity`.
    pub name: Value,
    /// In the moving plane.
    pub circlepoint: Joint<Ball>,
    /// In the fixed plane.
    pub center: Joint<Ball>,
    /// Both in exact numbers, where they are known.
    exact: Option<[Joint<Surd>; 2]>,
}

impl Dyad {
    fn new(name: Value, circlepoint: Joint<Ball>, center: Joint<Ball>) -> Self {
        let exact = rational(&circlepoint).zip(rational(&center));
        Dyad {
            name,
            circlepoint,
            center,
            exact: exact.map(Into::into),
        }
    }

    /// The same pair in exact numbers.
    pub fn exactly(self, points: [Point<Surd>; 2]) -> Self {
        Dyad {
            exact: Some(points.map(Joint::At)),
            ..self
        }
    }

    /// A finite pair.
    pub fn finite(place: usize, [circlepoint, center]: [Point<Ball>; 2]) -> Self {
        Dyad::new(json!(place), Joint::At(circlepoint), Joint::At(center))
    }

    /// A point on a straight line; the center is in the direction in which the answer shows it.
    pub fn slide(
        place: usize,
        circlepoint: Point<Ball>,
        direction: &Point<Ball>,
        shown: &Value,
    ) -> Self {
        let center = Joint::Towards(oriented(direction, shown));
        Dyad::new(
            json!({"at_infinity": place}),
            Joint::At(circlepoint),
            center,
        )
    }

    /// A line through a fixed point.
    pub fn block(
        place: usize,
        direction: &Point<Ball>,
        shown: &Value,
        center: Point<Ball>,
    ) -> Self {
        let circlepoint = Joint::Towards(oriented(direction, shown));
        Dyad::new(
            json!({"at_infinity": place}),
            circlepoint,
            Joint::At(center),
        )
    }
}

/// A joint of rational coordinates.
fn rational(joint: &Joint<Ball>) -> Option<Joint<Surd>> {
    let number = |x: &Number<Ball>| {
        let rational = Numeral::Enclosed(x.clone()).rational()?;
        Some(Number::<Surd>::from(rational))
    };
    let point = |z: &Point<Ball>| Some(Number::complex(number(z.re())?, number(z.im())?));
    Some(match joint {
        Joint::At(z) => Joint::At(point(z)?),
        Joint::Towards(z) => Joint::Towards(point(z)?),
    })
}

/// A direction turned to the side on which it is shown.
fn oriented(direction: &Point<Ball>, shown: &Value) -> Point<Ball> {
    let part = |axis: usize| {
        let float = output::as_float(shown.get(axis)?)?;
        Some(Number::<Ball>::from(rug::Rational::from_f64(float)?))
    };
    let along = match (part(0), part(1)) {
        (Some(x), Some(y)) => direction.re() * x + direction.im() * y,
        _ => Number::zero(),
    };
    if along.sign().is_some_and(std::cmp::Ordering::is_lt) {
        -direction
    } else {
        direction.clone()
    }
}

/// The linkage of two dyads, in balls of so many bits.
pub fn in_balls(
    [first, second]: [&Dyad; 2],
    positions: &[Displacement<Ball>],
    bits: u32,
) -> Passage<Ball> {
    let round = |z: &Point<Ball>| {
        let part = |x: &Number<Ball>| Number(x.0.with_precision(bits));
        Number::complex(part(z.re()), part(z.im()))
    };
    let joint = |joint: &Joint<Ball>| match joint {
        Joint::At(point) => Joint::At(round(point)),
        Joint::Towards(direction) => Joint::Towards(round(direction)),
    };
    let joints = [joint(&first.circlepoint), joint(&second.circlepoint)];
    Passage {
        pivots: [joint(&first.center), joint(&second.center)],
        joints: positions.iter().map(|d| moved(d, &joints)).collect(),
    }
}

/// The linkage of two dyads that are known exactly, in exact positions.
pub fn exactly(
    [first, second]: [&Dyad; 2],
    positions: &[Displacement<Exact>],
) -> Option<Passage<Surd>> {
    let [[a, p], [b, q]] = [first.exact.clone()?, second.exact.clone()?];
    let surd = |x: &Number<Exact>| Some(Number::<Surd>::from(x.0.rational()?.clone()));
    let vector = |z: &Point<Exact>| Some(Number::complex(surd(z.re())?, surd(z.im())?));
    let joints = [a, b];
    let place = |d: &Displacement<Exact>| {
        let d = Displacement {
            rotation: vector(&d.rotation)?,
            translation: vector(&d.translation)?,
        };
        Some(moved(&d, &joints))
    };
    Some(Passage {
        pivots: [p, q],
        joints: positions.iter().map(place).collect::<Option<_>>()?,
    })
}

/// Two joints of the moving plane in one of its positions.
fn moved<K: crate::number::Kind>(
    displacement: &Displacement<K>,
    joints: &[Joint<K>; 2],
) -> [Joint<K>; 2] {
    joints.each_ref().map(|joint| match joint {
        Joint::At(point) => Joint::At(displacement.of(point)),
        Joint::Towards(direction) => Joint::Towards(&displacement.rotation * direction),
    })
}
