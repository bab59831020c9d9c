//! Chapter III: a point of the moving plane and where it is.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::displacement::Displacement;
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/moving-plane",
    "A point of the moving plane and its place in the fixed plane, for any position of the moving \
     one.",
    build,
    [
        "x": "coordinate of the point in the moving plane",
        "y": "coordinate of the point in the moving plane",
        "X": "coordinate of the same point in the fixed plane",
        "Y": "coordinate of the same point in the fixed plane",
        "phi": "turn of the moving plane",
        "a": "coordinate of the moving origin in the fixed plane",
        "b": "coordinate of the moving origin in the fixed plane",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let moving = point(free, "the point")?;
    let phi = free.angle("phi")?;
    let (a, b) = (free.number("a")?, free.number("b")?);
    let position = Displacement {
        rotation: phi.cis(),
        translation: Number::complex(a.clone(), b.clone()),
    };
    let fixed = position.of(&moving);
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("phi", phi);
    for (name, value) in [
        ("x", moving.re()),
        ("y", moving.im()),
        ("X", fixed.re()),
        ("Y", fixed.im()),
        ("a", &a),
        ("b", &b),
    ] {
        bindings.bind(name, value.clone());
    }
    Ok(bindings)
}
