//! Chapter III: a point of the moving plane with five positions on a line.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/point-on-a-line",
    "Five positions of the moving plane and a point with five places on a line; its center is at \
     infinity across it. The line, the places and the turns are free. In position 0 the planes \
     coincide.",
    build,
    [
        "x_o": "coordinate of the point in the moving plane",
        "y_o": "coordinate of the point in the moving plane",
        "phi_1": "turn of position 1",
        "phi_2": "turn of position 2",
        "phi_3": "turn of position 3",
        "phi_4": "turn of position 4",
        "a_1": "coordinate of the moving origin in position 1",
        "a_2": "coordinate of the moving origin in position 2",
        "a_3": "coordinate of the moving origin in position 3",
        "a_4": "coordinate of the moving origin in position 4",
        "b_1": "coordinate of the moving origin in position 1",
        "b_2": "coordinate of the moving origin in position 2",
        "b_3": "coordinate of the moving origin in position 3",
        "b_4": "coordinate of the moving origin in position 4",
        "z_0": "0",
        "z_1": "0",
        "z_2": "0",
        "z_3": "real part of the point times the conjugate direction of the center",
        "z_4": "imaginary part of the same",
        "z_5": "less the direction of the center, a multiple of it",
        "z_6": "less the direction of the center, the same multiple",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let start = point(free, "the point")?;
    let along = point(free, "the direction of the line")?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("x_o", start.re().clone());
    bindings.bind("y_o", start.im().clone());
    for j in 1..=4 {
        let phi = free.angle(&format!("phi_{j}"))?;
        let place = &start + along.scaled(&free.number(&format!("way to place {j}"))?);
        let origin = place - phi.cis() * &start;
        bindings.bind(&format!("phi_{j}"), phi);
        bindings.bind(&format!("a_{j}"), origin.re().clone());
        bindings.bind(&format!("b_{j}"), origin.im().clone());
    }
    // The center as a point at infinity: its direction takes the place of M in z M̄.
    let center = Number::i() * along;
    let product = start * center.conj();
    for name in ["z_0", "z_1", "z_2"] {
        bindings.bind(name, Number::<K>::zero());
    }
    for (name, value) in [
        ("z_3", product.re().clone()),
        ("z_4", product.im().clone()),
        ("z_5", -center.re()),
        ("z_6", -center.im()),
    ] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}
