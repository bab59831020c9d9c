//! Section 6: when the coupler of a double rocker revolves.

use crate::formula::Bindings;
use crate::number::Real;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/revolving-coupler",
    "A four-bar whose base is longer than its coupler. Where AB is turned against MN by theta, the arms a and b must bridge \
     a distance whose square is c^2 + d^2 - 2 c d cos theta; its extremes belong to theta = 0 and pi.",
    build,
    not symbolic: "which of two lengths is the longer one",
    [
        "a": "length MA",
        "b": "length NB",
        "c": "length AB of the coupler",
        "d": "length MN of the base",
        "D_1": "least distance that the arms must bridge",
        "D_2": "greatest distance that the arms must bridge",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let c = free.length("c")?;
    let d = &c + free.length("d - c")?;
    let (least, greatest) = ((&d - &c).abs(), &d + &c);
    // The sum and the difference of the arms are taken up to twice the two distances, so that both
    // inequalities fail about as often as they hold.
    let sum = 2 * free.part("sum of the arms")? * &greatest;
    let difference = 2 * free.part("difference of the arms")? * &least;
    let (long, short) = ((&sum + &difference) / 2, (&sum - &difference) / 2);
    Unbuilt::unless_real(short.is_positive(), "an arm has no length")?;
    let a_is_long = free.number("a - b")?.is_positive().is_yes();
    let (a, b) = if a_is_long {
        (long, short)
    } else {
        (short, long)
    };
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("D_1", least);
    bindings.bind("D_2", greatest);
    for (name, length) in [("a", a), ("b", b), ("c", c), ("d", d)] {
        bindings.bind(name, length);
    }
    Ok(bindings)
}
