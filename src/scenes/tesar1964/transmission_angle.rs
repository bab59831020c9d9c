//! Chapter VI: the transmission angle at the pin A.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::{Angle, Point};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};
use std::cmp::Ordering;

pub const SCENE: Scene = scene!(
    "tesar1964/transmission-angle",
    "Crank and coupler in any directions. The transmission angle is that between their lines, without regard \
     to sense, from their scalar and cross products.",
    build, not symbolic: "the sign of a cosine",
    [
        "gamma_a": "from the line of the crank to that of the coupler, from 0 to 90 deg in either sense",
        "phi'": "from the x-axis to the line of the crank, from -90 to 90 deg",
        "chi'": "from the x-axis to the line of the coupler, from -90 to 90 deg",
        "p": "|phi'|",
        "q": "|chi'|",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (crank, coupler) = (free.angle("phi")?.cis(), free.angle("chi")?.cis());
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("gamma_a", acute(&(&coupler * crank.conj())));
    for (principal, size, direction) in [("phi'", "p", crank), ("chi'", "q", coupler)] {
        bindings.bind(size, acute(&direction));
        bindings.bind(principal, to_the_right(direction)?);
    }
    Ok(bindings)
}

/// Between the line of a unit vector and the x-axis, from 0 to 90°.
fn acute<K: Real>(direction: &Point<K>) -> Angle<K> {
    Angle::from_cos_sin(direction.re().abs(), direction.im().abs())
}

/// The principal value of the arc tangent, for the line of a unit vector.
fn to_the_right<K: Real>(direction: Point<K>) -> Result<Angle<K>, Unbuilt> {
    let [cos, sin]: [Number<K>; 2] = match direction.re().sign() {
        Some(Ordering::Less) => [-direction.re(), -direction.im()],
        Some(_) => [direction.re().clone(), direction.im().clone()],
        None => return Err(Unbuilt::NotHeld("the sign of a cosine".to_owned())),
    };
    Ok(Angle::from_cos_sin(cos, sin))
}
