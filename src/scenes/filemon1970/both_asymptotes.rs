//! Figure 2: the real asymptotes of the curves of four positions, beside the poles.

use super::positions::Positions;
use crate::finite::four_positions::circle_conditions;
use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1970/asymptotes",
    "Four positions as in the scene pole-system, and the directions of the real asymptotes of the \
     centerpoint curve and the circlepoint curve, both taken from the condition that four \
     positions of a point lie on a circle.",
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
        "v": "direction of the real asymptote of the centerpoint curve",
        "v'": "direction of the real asymptote of the circlepoint curve in position 1",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let positions = Positions::free(free)?;
    let displacements = &positions.displacements;
    let mut bindings = Bindings::new(free.precision());
    positions.bind(&mut bindings);
    let centers = circle_conditions::centerpoint_cubic(displacements);
    bindings.bind("v", direction(centers)?);
    let circlepoints = circle_conditions::circlepoint_cubic(displacements);
    bindings.bind("v'", direction(circlepoints)?);
    Ok(bindings)
}

fn direction<K: Real>(cubic: Option<Cubic<K>>) -> Result<Point<K>, Unbuilt> {
    let cubic =
        cubic.ok_or_else(|| Unbuilt::Contradiction("the curve is no real cubic".to_owned()))?;
    let at_infinity = cubic.real_point_at_infinity();
    let [x, y, _] = at_infinity.coordinates();
    Ok(Number::complex(x.clone(), y.clone()))
}
