//! Chapter III: a point of the moving plane with five positions on a circle.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::circle::Circle;
use crate::plane::displacement::Displacement;
use crate::plane::{Angle, Point, relation};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/burmester-pair",
    "Five positions of the moving plane and a point with five places on a circle. The circle, the \
     places and the turns are free; from them follows where the moving origin is. In position 0 the \
     planes coincide.",
    build,
    [
        "x_o": "coordinate of the point in the moving plane",
        "y_o": "coordinate of the point in the moving plane",
        "x_c": "coordinate of the center in the fixed plane",
        "y_c": "coordinate of the center in the fixed plane",
        "x": "coordinate of a place of the point in the fixed plane",
        "y": "coordinate of a place of the point in the fixed plane",
        "X_0": "coordinate of the place in position 0",
        "X_1": "coordinate of the place in position 1",
        "X_2": "coordinate of the place in position 2",
        "X_3": "coordinate of the place in position 3",
        "X_4": "coordinate of the place in position 4",
        "Y_0": "coordinate of the place in position 0",
        "Y_1": "coordinate of the place in position 1",
        "Y_2": "coordinate of the place in position 2",
        "Y_3": "coordinate of the place in position 3",
        "Y_4": "coordinate of the place in position 4",
        "phi_0": "turn of position 0",
        "phi_1": "turn of position 1",
        "phi_2": "turn of position 2",
        "phi_3": "turn of position 3",
        "phi_4": "turn of position 4",
        "a_0": "coordinate of the moving origin in position 0",
        "a_1": "coordinate of the moving origin in position 1",
        "a_2": "coordinate of the moving origin in position 2",
        "a_3": "coordinate of the moving origin in position 3",
        "a_4": "coordinate of the moving origin in position 4",
        "b_0": "coordinate of the moving origin in position 0",
        "b_1": "coordinate of the moving origin in position 1",
        "b_2": "coordinate of the moving origin in position 2",
        "b_3": "coordinate of the moving origin in position 3",
        "b_4": "coordinate of the moving origin in position 4",
        "a_0'": "coordinate of the fixed origin in the moving plane in position 0; printed underlined",
        "a_1'": "coordinate of the fixed origin in the moving plane in position 1; printed underlined",
        "a_2'": "coordinate of the fixed origin in the moving plane in position 2; printed underlined",
        "a_3'": "coordinate of the fixed origin in the moving plane in position 3; printed underlined",
        "a_4'": "coordinate of the fixed origin in the moving plane in position 4; printed underlined",
        "b_0'": "coordinate of the fixed origin in the moving plane in position 0; printed underlined",
        "b_1'": "coordinate of the fixed origin in the moving plane in position 1; printed underlined",
        "b_2'": "coordinate of the fixed origin in the moving plane in position 2; printed underlined",
        "b_3'": "coordinate of the fixed origin in the moving plane in position 3; printed underlined",
        "b_4'": "coordinate of the fixed origin in the moving plane in position 4; printed underlined",
        "Q_0": "coefficient of the circle's equation, of the sum of the squares",
        "Q_1": "half of that of the abscissa",
        "Q_2": "half of that of the ordinate",
        "Q_3": "the constant",
        "Z_0": "Q_0, common factor of the coordinates of the pair",
        "Z_1": "coordinate of the pair: less x_o",
        "Z_2": "coordinate of the pair: less y_o",
        "Z_3": "coordinate of the pair: real part of the point times the conjugate center",
        "Z_4": "coordinate of the pair: imaginary part of the same",
        "Z_5": "coordinate of the pair: less x_c",
        "Z_6": "coordinate of the pair: less y_c",
        "Z_7": "the circle's equation at the place in position 0",
        "C_1": "Z_1 : Z_0",
        "C_2": "Z_2 : Z_0",
        "C_5": "Z_5 : Z_0",
        "C_6": "Z_6 : Z_0",
    ]
);

pub const ANY_START: Scene = scene!(
    "tesar1964/burmester-pair-from-any-start",
    "The same but for position 0, which is as free as the others.",
    build_any_start,
    [
        "phi_0": "turn of position 0",
        "a_0": "coordinate of the moving origin in position 0",
        "b_0": "coordinate of the moving origin in position 0",
        "Z_7": "the circle's equation at the point of the fixed plane with the coordinates of the moving point",
    ]
);

/// A point, its center and five positions that bring it to places on one circle.
pub(super) struct Pair<K> {
    pub point: Point<K>,
    pub center: Point<K>,
    pub turns: Vec<Angle<K>>,
    pub positions: Vec<Displacement<K>>,
}

/// The pair of free places and turns.
pub(super) fn pair<K: Real>(free: &mut dyn Free<K>) -> Result<Pair<K>, Unbuilt> {
    let center = point(free, "the center")?;
    let start = point(free, "the point")?;
    let mut turns = vec![Angle::from_cos_sin(Number::one(), Number::zero())];
    let mut positions = vec![Displacement::identity()];
    for position in 1..=4 {
        let phi = free.angle(&format!("phi_{position}"))?;
        let swing = free.angle(&format!("swing to place {position}"))?.cis();
        let place = &center + swing * (&start - &center);
        positions.push(Displacement {
            rotation: phi.cis(),
            translation: place - phi.cis() * &start,
        });
        turns.push(phi);
    }
    Ok(Pair {
        point: start,
        center,
        turns,
        positions,
    })
}

impl<K: Real> Pair<K> {
    /// Binds turns and moving origins.
    pub fn bind_positions(&self, bindings: &mut Bindings<K>) {
        for (j, (turn, position)) in self.turns.iter().zip(&self.positions).enumerate() {
            let back = position.inverse().translation;
            bindings.bind(&format!("phi_{j}"), turn.clone());
            for (name, value) in [
                (format!("a_{j}"), position.translation.re()),
                (format!("b_{j}"), position.translation.im()),
                (format!("a_{j}'"), back.re()),
                (format!("b_{j}'"), back.im()),
            ] {
                bindings.bind(&name, value.clone());
            }
        }
    }

    /// Coordinates Z₀ to Z₆ of the pair, with the factor Z₀.
    pub fn coordinates(&self, factor: &Number<K>) -> [Number<K>; 7] {
        let product = &self.point * self.center.conj();
        let (point, center) = (&self.point, &self.center);
        [
            factor.clone(),
            -(factor * point.re()),
            -(factor * point.im()),
            factor * product.re(),
            factor * product.im(),
            -(factor * center.re()),
            -(factor * center.im()),
        ]
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let pair = pair(free)?;
    let factor = free.number("Q_0")?;
    let mut bindings = Bindings::new(free.precision());
    pair.bind_positions(&mut bindings);
    let squared_radius = relation::distance_squared(&pair.point, &pair.center);
    let circle = Circle::about(&pair.center, &squared_radius);
    for (name, coefficient) in [
        ("Q_0", circle.a.clone()),
        ("Q_1", &circle.b / 2),
        ("Q_2", &circle.c / 2),
        ("Q_3", circle.d.clone()),
    ] {
        bindings.bind(name, coefficient * &factor);
    }
    let places: Vec<Point<K>> = pair.positions.iter().map(|d| d.of(&pair.point)).collect();
    let third = places
        .get(3)
        .ok_or_else(|| Unbuilt::Contradiction("no position 3".to_owned()))?;
    for (j, place) in places.iter().enumerate() {
        bindings.bind(&format!("X_{j}"), place.re().clone());
        bindings.bind(&format!("Y_{j}"), place.im().clone());
    }
    for (names, point) in [
        (["x_o", "y_o"], &pair.point),
        (["x_c", "y_c"], &pair.center),
        (["x", "y"], third),
    ] {
        bindings.bind(names[0], point.re().clone());
        bindings.bind(names[1], point.im().clone());
    }
    let coordinates = pair.coordinates(&factor);
    let [z0, z1, z2, _, _, z5, z6] = &coordinates;
    for (name, coordinate) in [("C_1", z1), ("C_2", z2), ("C_5", z5), ("C_6", z6)] {
        bindings.bind(name, coordinate / z0);
    }
    for (i, coordinate) in coordinates.into_iter().enumerate() {
        bindings.bind(&format!("Z_{i}"), coordinate);
    }
    bindings.bind("Z_7", circle.at(&pair.point) * &factor);
    Ok(bindings)
}

fn build_any_start<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (center, start) = (point(free, "the center")?, point(free, "the point")?);
    let place = point(free, "place 0")?;
    let phi = free.angle("phi_0")?;
    let factor = free.number("Q_0")?;
    let origin = &place - phi.cis() * &start;
    let circle = Circle::about(&center, &relation::distance_squared(&place, &center));
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("phi_0", phi);
    bindings.bind("a_0", origin.re().clone());
    bindings.bind("b_0", origin.im().clone());
    bindings.bind("Z_7", circle.at(&start) * factor);
    Ok(bindings)
}
