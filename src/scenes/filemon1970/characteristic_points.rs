//! Figures 8 to 11: poles, mirror poles, and where opposite sides of their quadrilaterals meet.

use super::positions::Positions;
use crate::finite::pole_system::{OfPairs, PAIRS};
use crate::formula::Bindings;
use crate::number::Real;
use crate::plane::{Point, circle::Circle};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1970/characteristic-points",
    "Four positions as in the scene pole-system. Q_ij is where two opposite sides of a pole \
     quadrilateral meet whose names, without the number that they have in common, are ij: O_ik \
     O_jk and O_il O_jl. With a prime likewise for the mirror poles.",
    build,
    [
        "O_12": "pole of the positions 1 and 2",
        "O_13": "pole of the positions 1 and 3",
        "O_14": "pole of the positions 1 and 4",
        "O_23": "pole of the positions 2 and 3",
        "O_24": "pole of the positions 2 and 4",
        "O_34": "pole of the positions 3 and 4",
        "O_23'": "mirror pole O_23^1, the pole of the moving plane in position 1",
        "O_24'": "mirror pole O_24^1",
        "O_34'": "mirror pole O_34^1",
        "phi_12": "turn from position 1 to position 2",
        "phi_13": "turn from position 1 to position 3",
        "phi_14": "turn from position 1 to position 4",
        "Q_12": "meet of O13 O23 and O14 O24",
        "Q_13": "meet of O12 O23 and O14 O34",
        "Q_14": "meet of O12 O24 and O13 O34",
        "Q_23": "meet of O12 O13 and O24 O34",
        "Q_24": "meet of O12 O14 and O23 O34",
        "Q_34": "meet of O13 O14 and O23 O24",
        "Q_12'": "Q_12^1, as Q_12 of the mirror poles",
        "Q_13'": "Q_13^1, as Q_13 of the mirror poles",
        "Q_14'": "Q_14^1, as Q_14 of the mirror poles",
        "Q_23'": "Q_23^1, as Q_23 of the mirror poles",
        "Q_24'": "Q_24^1, as Q_24 of the mirror poles",
        "Q_34'": "Q_34^1, as Q_34 of the mirror poles",
    ]
);

pub const CENTERS: Scene = scene!(
    "filemon1970/partners-of-the-poles",
    "Four positions as in the scene pole-system. Q_ij is the center of the circle through the \
     positions of the circlepoint O_ij^1, of which two coincide, and Q_ij^1 is, in position 1, the \
     circlepoint whose center is O_ij.",
    build_centers,
    [
        "O_12": "pole of the positions 1 and 2",
        "O_13": "pole of the positions 1 and 3",
        "O_14": "pole of the positions 1 and 4",
        "O_23": "pole of the positions 2 and 3",
        "O_24": "pole of the positions 2 and 4",
        "O_34": "pole of the positions 3 and 4",
        "O_23'": "mirror pole O_23^1, the pole of the moving plane in position 1",
        "O_24'": "mirror pole O_24^1",
        "O_34'": "mirror pole O_34^1",
        "phi_12": "turn from position 1 to position 2",
        "phi_13": "turn from position 1 to position 3",
        "phi_14": "turn from position 1 to position 4",
        "Q_12": "center of the circlepoint O_12",
        "Q_13": "center of the circlepoint O_13",
        "Q_14": "center of the circlepoint O_14",
        "Q_23": "center of the circlepoint O_23^1",
        "Q_24": "center of the circlepoint O_24^1",
        "Q_34": "center of the circlepoint O_34^1",
        "Q_12'": "circlepoint of the center O_12",
        "Q_13'": "circlepoint of the center O_13",
        "Q_14'": "circlepoint of the center O_14",
        "Q_23'": "circlepoint of the center O_23",
        "Q_24'": "circlepoint of the center O_24",
        "Q_34'": "circlepoint of the center O_34",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let positions = Positions::free(free)?;
    let mut bindings = Bindings::new(free.precision());
    positions.bind(&mut bindings);
    let meets = positions.poles.meets_of_opposite_sides();
    let mirror_meets = positions.mirror_poles.meets_of_opposite_sides();
    bind_meets(&meets, &mirror_meets, &mut bindings);
    Ok(bindings)
}

fn build_centers<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let positions = Positions::free(free)?;
    let mut bindings = Bindings::new(free.precision());
    positions.bind(&mut bindings);
    let there = positions.displacements.each_ref();
    let back = there.map(|displacement| displacement.inverse());
    let centers = OfPairs::from_fn(|[i, j]| {
        let circlepoint = positions.mirror_poles.of(i, j);
        center(&there.map(|displacement| displacement.of(circlepoint)), i)
    });
    let circlepoints = OfPairs::from_fn(|[i, j]| {
        let center_point = positions.poles.of(i, j);
        center(&back.each_ref().map(|back| back.of(center_point)), i)
    });
    bind_meets(&centers, &circlepoints, &mut bindings);
    Ok(bindings)
}

/// The center of the circle through the four places but that of position i, which is another one
/// as well.
fn center<K: Real>(places: &[Point<K>; 4], i: usize) -> Point<K> {
    let mut round = places.each_ref();
    round.rotate_left(i - 1);
    let [_, p, q, r] = round;
    Circle::through(p, q, r).center()
}

fn bind_meets<K: Real>(meets: &OfPairs<K>, mirror: &OfPairs<K>, bindings: &mut Bindings<K>) {
    for [i, j] in PAIRS {
        bindings.bind(&format!("Q_{i}{j}"), meets.of(i, j).clone());
        bindings.bind(&format!("Q_{i}{j}'"), mirror.of(i, j).clone());
    }
}
