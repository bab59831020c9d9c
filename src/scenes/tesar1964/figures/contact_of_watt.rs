//! How many infinitely near positions a Watt linkage has on its line.

use super::derivatives::derivatives;
use super::watt::upon;
use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::Angle;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/watt-at-right-angles",
    "Watt's linkage with crossed cranks at right angles to the coupler, in that position, from the series of \
     the closure. The output point D is on the coupler, where its path has an inflection.",
    build,
    [
        "R": "length of the crank O_aA in lengths of the coupler",
        "T": "length of the crank O_bB in lengths of the coupler",
        "v_2": "second derivative of the deviation of D over its travel",
        "v_3": "third derivative",
        "v_4": "fourth derivative",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let r = free.length("R")?;
    let t = free.length_or("T", &r)?;
    let upright = Angle::from_cos_sin(Number::zero(), Number::one());
    let design = upon(&r, &t, &upright)
        .design()
        .map_err(|reason| Unbuilt::NotReal(reason.to_string()))?;
    let change_point = || Unbuilt::NotReal("the linkage is in a change point".to_owned());
    let [second, third, fourth, _] = derivatives(&design).ok_or_else(change_point)?;
    let mut bindings = Bindings::new(free.precision());
    for (name, value) in [
        ("R", r),
        ("T", t),
        ("v_2", second),
        ("v_3", third),
        ("v_4", fourth),
    ] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}
