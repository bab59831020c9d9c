//! Section 1: the five-bar MPFQN under Hart's condition, and the circle that F describes.

use super::position::Position;
use crate::formula::Bindings;
use crate::linkage::five_bar;
use crate::number::Real;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/five-bar",
    "One position of the five-bar MPFQN with angle MPF = omega and angle FQN = pi - omega. The four \
     bars and the two angles are free and the base closes the chain. S is the point of the base \
     that is equally far from F in this position and for another value of omega.",
    build,
    [
        "m": "length MP",
        "p": "length PF",
        "q": "length FQ",
        "n": "length QN",
        "d": "length MN of the base",
        "M": "fixed pivot, in the origin",
        "N": "fixed pivot, on the positive x-axis",
        "P": "joint of the bars MP and PF",
        "Q": "joint of the bars NQ and QF",
        "F": "joint of the bars PF and QF",
        "z": "the complex coordinate x + iy of F",
        "phi": "angle from the base MN to the bar MP",
        "psi": "angle from the base to the bar NQ",
        "omega": "angle MPF",
        "u": "unit vector of the bar MP",
        "v": "unit vector of the bar NQ",
        "w": "unit vector of direction omega",
        "s": "abscissa of S",
        "r": "length SF",
        "MS": "distance from M to S, directed along MN",
        "NS": "distance from N to S, directed along MN",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let position = Position::free(free)?;
    let other = free.angle("another omega")?;
    let (lengths, d, omega) = (&position.lengths, &position.d, &position.omega);
    let s = five_bar::center_of_path(lengths, d, omega, &other);
    let r_squared = five_bar::distance_squared_from_base_point(lengths, d, omega, &s);
    let r = free.root("r", &r_squared)?;
    let mut bindings = Bindings::new(free.precision());
    position.bind(&mut bindings);
    bindings.bind("NS", &s - d);
    bindings.bind("MS", s.clone());
    bindings.bind("s", s);
    bindings.bind("r", r);
    Ok(bindings)
}
