//! Chapter III: five positions in which the moving origin is on the X-axis, by their coordinates.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/origin-on-the-axis",
    "Four positions of the moving plane in which its origin is on the X-axis, beside the position 0, \
     in which the planes coincide. Turns and abscissas are free.",
    build,
    [
        "phi_1": "turn of position 1",
        "phi_2": "turn of position 2",
        "phi_3": "turn of position 3",
        "phi_4": "turn of position 4",
        "a_1": "abscissa of the moving origin in position 1",
        "a_2": "abscissa of the moving origin in position 2",
        "a_3": "abscissa of the moving origin in position 3",
        "a_4": "abscissa of the moving origin in position 4",
        "b_1": "ordinate of the moving origin in position 1: 0",
        "b_2": "ordinate of the moving origin in position 2: 0",
        "b_3": "ordinate of the moving origin in position 3: 0",
        "b_4": "ordinate of the moving origin in position 4: 0",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let mut bindings = Bindings::new(free.precision());
    for j in 1..=4 {
        bindings.bind(&format!("phi_{j}"), free.angle(&format!("phi_{j}"))?);
        bindings.bind(&format!("a_{j}"), free.number(&format!("a_{j}"))?);
        bindings.bind(&format!("b_{j}"), Number::<K>::zero());
    }
    Ok(bindings)
}
