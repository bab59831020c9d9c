//! A dyad in four positions, and the minors of its loop equations.

use crate::formula::Bindings;
use crate::number::linear::determinant;
use crate::number::{Number, Real};
use crate::plane::displacement::Displacement;
use crate::plane::{Angle, Point};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "kaufman/dyad",
    "Four positions of the moving plane, led by a dyad M K A: the center, the circlepoint, the point A \
     and all turns are free, the shifts of A follow. The Delta_j are values of the compatibility \
     determinant, in which a column of numbers stands in the place of the column of the crank.",
    build,
    [
        "M": "center",
        "K_1": "circlepoint in position 1",
        "r_1": "point A in position 1",
        "r_2": "point A in position 2",
        "r_3": "point A in position 3",
        "r_4": "point A in position 4",
        "phi_2": "turn of the moving plane to position 2",
        "phi_3": "turn of the moving plane to position 3",
        "phi_4": "turn of the moving plane to position 4",
        "gamma_2": "turn of the crank to position 2",
        "gamma_3": "turn of the crank to position 3",
        "gamma_4": "turn of the crank to position 4",
        "delta_2": "shift of A to position 2",
        "delta_3": "shift of A to position 3",
        "delta_4": "shift of A to position 4",
        "Z_1": "from the circlepoint to A, position 1",
        "Z_2": "from the circlepoint to A, position 2",
        "Z_3": "from the circlepoint to A, position 3",
        "Z_4": "from the circlepoint to A, position 4",
        "W_1": "from the center to the circlepoint, position 1",
        "W_2": "from the center to the circlepoint, position 2",
        "W_3": "from the center to the circlepoint, position 3",
        "W_4": "from the center to the circlepoint, position 4",
        "Delta_1": "the determinant with the column 1, 1, 1",
        "Delta_2": "the determinant with the column 1, 0, 0",
        "Delta_3": "the determinant with the column 0, 1, 0",
        "Delta_4": "the determinant with the column 0, 0, 1",
        "Delta": "the determinant with the column 1 - e^(i gamma_2), 1, 1",
    ]
);

/// Four positions led by a dyad; the fixed plane is the moving one in position 1.
pub(super) struct Led<K> {
    pub center: Point<K>,
    pub circlepoint: Point<K>,
    /// φ₂, φ₃, φ₄.
    pub turns: Vec<Angle<K>>,
    /// γ₂, γ₃, γ₄.
    pub cranks: Vec<Angle<K>>,
    pub positions: [Displacement<K>; 4],
}

impl<K: Real> Led<K> {
    /// The center, the circlepoint and all turns are free.
    pub(super) fn free(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let center = point(free, "M")?;
        let circlepoint = point(free, "K_1")?;
        let mut turns = Vec::new();
        let mut cranks = Vec::new();
        let mut position = |j: usize| -> Result<Displacement<K>, Unbuilt> {
            let turn = free.angle(&format!("phi_{j}"))?;
            let crank = free.angle(&format!("gamma_{j}"))?;
            let place = &center + crank.cis() * (&circlepoint - &center);
            let rotation = turn.cis();
            turns.push(turn);
            cranks.push(crank);
            Ok(Displacement {
                translation: place - &rotation * &circlepoint,
                rotation,
            })
        };
        let positions = [
            Displacement::identity(),
            position(2)?,
            position(3)?,
            position(4)?,
        ];
        Ok(Led {
            center,
            circlepoint,
            turns,
            cranks,
            positions,
        })
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let led = Led::free(free)?;
    let start = point(free, "A_1")?;
    let mut bindings = Bindings::new(free.precision());
    let mut shifts = Vec::new();
    for (position, j) in led.positions.iter().zip(1..) {
        let (pin, end) = (position.of(&led.circlepoint), position.of(&start));
        bindings.bind(&format!("Z_{j}"), &end - &pin);
        bindings.bind(&format!("W_{j}"), pin - &led.center);
        if j > 1 {
            bindings.bind(&format!("delta_{j}"), &end - &start);
            shifts.push(&end - &start);
        }
        bindings.bind(&format!("r_{j}"), end);
    }
    let turns: Vec<Point<K>> = led.turns.iter().map(|turn| turn.cis() - 1).collect();
    // Columns as rows: the determinant is the same.
    let with = |column: [Point<K>; 3]| determinant(&[turns.as_slice(), &column, &shifts]);
    let (one, zero) = (Number::one, Number::zero);
    let crank: Point<K> = led
        .cranks
        .first()
        .map_or_else(Number::zero, |crank| crank.cis());
    for (name, column) in [
        ("Delta_1", [one(), one(), one()]),
        ("Delta_2", [one(), zero(), zero()]),
        ("Delta_3", [zero(), one(), zero()]),
        ("Delta_4", [zero(), zero(), one()]),
        ("Delta", [1 - crank, one(), one()]),
    ] {
        bindings.bind(name, with(column));
    }
    for (angles, name) in [(led.turns, "phi"), (led.cranks, "gamma")] {
        for (angle, j) in angles.into_iter().zip(2..) {
            bindings.bind(&format!("{name}_{j}"), angle);
        }
    }
    bindings.bind("M", led.center);
    bindings.bind("K_1", led.circlepoint);
    Ok(bindings)
}
