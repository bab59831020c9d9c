//! Figure 4: poles and mirror poles of four positions.

use super::positions::Positions;
use crate::formula::Bindings;
use crate::number::Real;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1970/pole-system",
    "Four positions of the moving plane: the poles O12, O13, O14 and the turns about them are \
     free, and the frame of the moving plane is laid on the fixed one in position 1. The other \
     poles follow, and so do the mirror poles: where the point of the moving plane that two \
     positions carry to their pole is in position 1.",
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
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let mut bindings = Bindings::new(free.precision());
    Positions::free(free)?.bind(&mut bindings);
    Ok(bindings)
}
