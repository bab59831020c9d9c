//! The poles of four positions that a dyad leads.

use super::dyad::Led;
use crate::formula::Bindings;
use crate::number::Real;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "kaufman/poles",
    "Four positions of the moving plane, led by a dyad whose center, circlepoint and turns are free, \
     with all their poles and image poles.",
    build,
    [
        "M": "center",
        "K_1": "circlepoint in position 1",
        "phi_2": "turn of the moving plane to position 2",
        "phi_3": "turn of the moving plane to position 3",
        "phi_4": "turn of the moving plane to position 4",
        "P_12": "pole of the positions 1 and 2, also its own image",
        "P_13": "pole of the positions 1 and 3, also its own image",
        "P_14": "pole of the positions 1 and 4, also its own image",
        "P_23": "pole of the positions 2 and 3",
        "P_24": "pole of the positions 2 and 4",
        "P_34": "pole of the positions 3 and 4",
        "P_23'": "image pole: where the point at P_23 in position 2 is in position 1",
        "P_24'": "image pole: where the point at P_24 in position 2 is in position 1",
        "P_34'": "image pole: where the point at P_34 in position 3 is in position 1",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let led = Led::free(free)?;
    let mut bindings = Bindings::new(free.precision());
    for (i, first) in led.positions.iter().enumerate() {
        for (j, second) in led.positions.iter().enumerate().skip(i + 1) {
            let pole = first.pole(second);
            let name = format!("P_{}{}", i + 1, j + 1);
            if i > 0 {
                // Position 1 is the moving plane itself.
                bindings.bind(&format!("{name}'"), first.inverse().of(&pole));
            }
            bindings.bind(&name, pole);
        }
    }
    for (turn, j) in led.turns.into_iter().zip(2..) {
        bindings.bind(&format!("phi_{j}"), turn);
    }
    bindings.bind("M", led.center);
    bindings.bind("K_1", led.circlepoint);
    Ok(bindings)
}
