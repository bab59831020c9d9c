//! Chapter VI: the type of the mechanism in the representative output.

use super::ball_burmester::{DoublePoint, double_point};
use super::grashof::Links;
use crate::formula::Bindings;
use crate::number::Real;
use crate::plane::relation;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/type-of-mechanism",
    "Two of the four Burmester points coincide on the inflection circle; the two others are the pins of a \
     four-bar, in units of its diameter. A crank turns fully where it has no dead centre.",
    build, not symbolic: "the length of the fixed link",
    [
        "alpha_a": "ray of the pin A",
        "alpha_b": "ray of the pin B",
        "Q": "length of the fixed link O_aO_b",
        "R": "length of the crank O_aA, number 1",
        "S": "length of the coupler AB",
        "T": "length of the crank O_bB, number 2",
        "crank_R": "+1 where R turns fully against the fixed link, -1 where it does not",
        "crank_T": "+1 where T turns fully against the fixed link, -1 where it does not",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let DoublePoint {
        alpha_a,
        alpha_b,
        pairs: [first, second],
        ..
    } = double_point(free)?;
    let at_infinity = || Unbuilt::NotReal("a pivot is at infinity".to_owned());
    let (a, b) = (first.point, second.point);
    let o_a = first.center.ok_or_else(at_infinity)?;
    let o_b = second.center.ok_or_else(at_infinity)?;
    let mut length = |name, x, y| free.root(name, &relation::distance_squared(x, y));
    let links = Links([
        length("Q", &o_a, &o_b)?,
        length("R", &o_a, &a)?,
        length("S", &a, &b)?,
        length("T", &o_b, &b)?,
    ]);
    let mut bindings = Bindings::new(free.precision());
    links.bind(&mut bindings)?;
    bindings.bind("alpha_a", alpha_a);
    bindings.bind("alpha_b", alpha_b);
    Ok(bindings)
}
