//! Chapter III: a point of the moving plane with four positions on a circle.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::circle::Circle;
use crate::plane::{Angle, Point, relation};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/circlepoint",
    "Four positions of the moving plane and a point with four places on a circle. The circle, the \
     places and the turns are free; from them follows where the moving origin is. In position 0 the \
     planes coincide.",
    build,
    [
        "x": "coordinate of the point in the moving plane, and in the fixed one in position 0",
        "y": "coordinate of the point in the moving plane, and in the fixed one in position 0",
        "X": "coordinate of the center of the circle",
        "Y": "coordinate of the center of the circle",
        "phi_0": "turn of position 0: none",
        "phi_1": "turn of position 1",
        "phi_2": "turn of position 2",
        "phi_3": "turn of position 3",
        "a_0": "coordinate of the moving origin in position 0: 0",
        "a_1": "coordinate of the moving origin in position 1",
        "a_2": "coordinate of the moving origin in position 2",
        "a_3": "coordinate of the moving origin in position 3",
        "b_0": "coordinate of the moving origin in position 0: 0",
        "b_1": "coordinate of the moving origin in position 1",
        "b_2": "coordinate of the moving origin in position 2",
        "b_3": "coordinate of the moving origin in position 3",
        "Q_0": "coefficient of the circle's equation, of the sum of the squares",
        "Q_1": "coefficient of the circle's equation, half of that of the abscissa",
        "Q_2": "coefficient of the circle's equation, half of that of the ordinate",
        "Q_3": "coefficient of the circle's equation, the constant",
        "D_1": "coefficient of Q_0 in the circle's equation at position 1 less that at position 0",
        "D_2": "coefficient of Q_0 in the circle's equation at position 2 less that at position 0",
        "D_3": "coefficient of Q_0 in the circle's equation at position 3 less that at position 0",
        "E_1": "coefficient of Q_1 likewise",
        "E_2": "coefficient of Q_1 likewise",
        "E_3": "coefficient of Q_1 likewise",
        "F_1": "coefficient of Q_2 likewise",
        "F_2": "coefficient of Q_2 likewise",
        "F_3": "coefficient of Q_2 likewise",
    ]
);

pub const THREE_PLACES: Scene = scene!(
    "tesar1964/three-places-on-a-circle",
    "A point of the moving plane whose places in the positions 1, 2 and 3 are on a circle; where it \
     is in position 0, in which the planes coincide, is free.",
    build_three_places,
    [
        "x": "coordinate of the point in the moving plane",
        "y": "coordinate of the point in the moving plane",
        "phi_0": "turn of position 0: none",
        "phi_1": "turn of position 1",
        "phi_2": "turn of position 2",
        "phi_3": "turn of position 3",
        "a_0": "coordinate of the moving origin in position 0: 0",
        "a_1": "coordinate of the moving origin in position 1",
        "a_2": "coordinate of the moving origin in position 2",
        "a_3": "coordinate of the moving origin in position 3",
        "b_0": "coordinate of the moving origin in position 0: 0",
        "b_1": "coordinate of the moving origin in position 1",
        "b_2": "coordinate of the moving origin in position 2",
        "b_3": "coordinate of the moving origin in position 3",
        "Q_0": "coefficient of the circle's equation, of the sum of the squares",
        "Q_1": "coefficient of the circle's equation, half of that of the abscissa",
        "Q_2": "coefficient of the circle's equation, half of that of the ordinate",
        "Q_3": "coefficient of the circle's equation, the constant",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let center = point(free, "the center")?;
    let start = point(free, "the point")?;
    let mut bindings = Bindings::new(free.precision());
    let squared_radius = relation::distance_squared(&center, &start);
    bind_circle(&center, &squared_radius, free, &mut bindings)?;
    bindings.bind("X", center.re().clone());
    bindings.bind("Y", center.im().clone());
    for (position, place) in bind_positions(&start, &start, &center, free, &mut bindings)? {
        // What multiplies Q₀, Q₁ and Q₂ in Q₀(X² + Y²) + 2Q₁X + 2Q₂Y + Q₃.
        let coefficients = [
            ("D", place.norm() - start.norm()),
            ("E", 2 * (place.re() - start.re())),
            ("F", 2 * (place.im() - start.im())),
        ];
        for (name, coefficient) in coefficients {
            bindings.bind(&format!("{name}_{position}"), coefficient);
        }
    }
    Ok(bindings)
}

fn build_three_places<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let center = point(free, "the center")?;
    let on_circle = point(free, "a point of the circle")?;
    let start = point(free, "the point")?;
    let mut bindings = Bindings::new(free.precision());
    let squared_radius = relation::distance_squared(&center, &on_circle);
    bind_circle(&center, &squared_radius, free, &mut bindings)?;
    bind_positions(&start, &on_circle, &center, free, &mut bindings)?;
    Ok(bindings)
}

/// Any multiple of the circle's equation.
fn bind_circle<K: Real>(
    center: &Point<K>,
    squared_radius: &Number<K>,
    free: &mut dyn Free<K>,
    bindings: &mut Bindings<K>,
) -> Result<(), Unbuilt> {
    let factor = free.number("Q_0")?;
    let circle = Circle::about(center, squared_radius);
    for (name, coefficient) in [
        ("Q_0", circle.a),
        ("Q_1", circle.b / 2),
        ("Q_2", circle.c / 2),
        ("Q_3", circle.d),
    ] {
        bindings.bind(name, coefficient * &factor);
    }
    Ok(())
}

/// Binds position 0 and three positions that bring the point, which is at `start` in the moving
/// plane, to places on the circle about `center` through `on_circle`; gives these places.
fn bind_positions<K: Real>(
    start: &Point<K>,
    on_circle: &Point<K>,
    center: &Point<K>,
    free: &mut dyn Free<K>,
    bindings: &mut Bindings<K>,
) -> Result<Vec<(usize, Point<K>)>, Unbuilt> {
    bindings.bind("x", start.re().clone());
    bindings.bind("y", start.im().clone());
    bindings.bind("phi_0", Angle::from_cos_sin(Number::one(), Number::zero()));
    bindings.bind("a_0", Number::<K>::zero());
    bindings.bind("b_0", Number::<K>::zero());
    let mut places = Vec::new();
    for position in 1..=3 {
        let phi = free.angle(&format!("phi_{position}"))?;
        let swing = free.angle(&format!("swing to place {position}"))?.cis();
        let place = center + swing * (on_circle - center);
        let origin = &place - phi.cis() * start;
        bindings.bind(&format!("phi_{position}"), phi);
        bindings.bind(&format!("a_{position}"), origin.re().clone());
        bindings.bind(&format!("b_{position}"), origin.im().clone());
        places.push((position, place));
    }
    Ok(places)
}
