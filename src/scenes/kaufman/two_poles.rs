//! A circlepoint and its center seen from two poles.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::{Angle, Point, line};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "kaufman/two-poles",
    "A circlepoint, its center and two poles of position 1, all of them free. The turn about a pole that \
     keeps the circlepoint on its circle is the one to the mirror image of the circlepoint in the line \
     of the pole and the center.",
    build,
    [
        "M": "center",
        "K_1": "circlepoint in position 1",
        "K_2": "circlepoint in position 2",
        "K_3": "circlepoint in position 3",
        "P_12": "pole of the positions 1 and 2",
        "P_13": "pole of the positions 1 and 3",
        "phi_2": "turn about P_12",
        "phi_3": "turn about P_13",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (center, first) = (point(free, "M")?, point(free, "K_1")?);
    let mut bindings = Bindings::new(free.precision());
    for j in [2, 3] {
        let pole: Point<K> = point(free, &format!("P_1{j}"))?;
        let place = line::mirror(&first, &pole, &center);
        let turn = (&place - &pole) / (&first - &pole);
        bindings.bind(
            &format!("phi_{j}"),
            Angle::of_known_length(turn, Number::one()),
        );
        bindings.bind(&format!("K_{j}"), place);
        bindings.bind(&format!("P_1{j}"), pole);
    }
    bindings.bind("M", center);
    bindings.bind("K_1", first);
    Ok(bindings)
}
