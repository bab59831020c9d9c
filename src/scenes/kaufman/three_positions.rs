//! Three positions: the turns of the crank are free.

use crate::formula::Bindings;
use crate::number::{Real, array};
use crate::plane::displacement::Displacement;
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "kaufman/three-positions",
    "Three positions of the moving plane and two turns of a crank, all of them free; the shifts are given \
     by what they are multiples of. The two loop equations are solved for the dyad by elimination.",
    build,
    [
        "r_1": "point A in position 1",
        "delta_2": "shift of A to position 2",
        "delta_3": "shift of A to position 3",
        "phi_2": "turn of the moving plane to position 2",
        "phi_3": "turn of the moving plane to position 3",
        "gamma_2": "turn of the crank to position 2",
        "gamma_3": "turn of the crank to position 3",
        "Z_1": "from the circlepoint to A, position 1",
        "W_1": "from the center to the circlepoint, position 1",
        "M": "center",
        "K_1": "the point of the moving plane that is at the end of W_1, position 1",
        "K_2": "the same point in position 2",
        "K_3": "the same point in position 3",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let start = point(free, "A_1")?;
    let shares = [
        point(free, "share of delta_2")?,
        point(free, "share of delta_3")?,
    ];
    let turns = [free.angle("phi_2")?, free.angle("phi_3")?];
    let cranks = [free.angle("gamma_2")?, free.angle("gamma_3")?];
    let [u, v] = turns.each_ref().map(|turn| turn.cis() - 1);
    let [g, h] = cranks.each_ref().map(|crank| crank.cis() - 1);
    // u Z + g W = δ₂ and v Z + h W = δ₃, Z and W eliminated in turn. Shifts that are multiples of what
    // would be divided by are any shifts, and leave no denominators.
    let divisor = &u * &h - &v * &g;
    let shifts = shares.each_ref().map(|share| share * &divisor);
    let z = &shares[0] * h - &shares[1] * g;
    let w = u * &shares[1] - v * &shares[0];
    let circlepoint = &start - &z;
    let center = &circlepoint - &w;
    let [second, third] = array::pairs(&turns, &shifts).map(|(turn, shift)| {
        let rotation = turn.cis();
        Displacement {
            translation: &start + shift - &rotation * &start,
            rotation,
        }
        .of(&circlepoint)
    });
    let mut bindings = Bindings::new(free.precision());
    let [phi_2, phi_3] = turns;
    let [gamma_2, gamma_3] = cranks;
    for (name, angle) in [
        ("phi_2", phi_2),
        ("phi_3", phi_3),
        ("gamma_2", gamma_2),
        ("gamma_3", gamma_3),
    ] {
        bindings.bind(name, angle);
    }
    let [delta_2, delta_3] = shifts;
    for (name, value) in [
        ("r_1", start),
        ("delta_2", delta_2),
        ("delta_3", delta_3),
        ("Z_1", z),
        ("W_1", w),
        ("M", center),
        ("K_1", circlepoint),
        ("K_2", second),
        ("K_3", third),
    ] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}
