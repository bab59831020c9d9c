//! Figures 12 and 13: links of infinite length.

use super::construction::finite;
use super::positions::Positions;
use crate::finite::pole_four_bar::{Joints, PoleFourBar};
use crate::formula::{Bindings, Value};
use crate::number::Real;
use crate::plane::Point;
use crate::plane::projective::{Line, ProjectivePoint};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const CENTER: Scene = scene!(
    "filemon1970/center-at-infinity",
    "Four positions as in the scene pole-system, and the position of the four-bar O12 O23 O34 O14 \
     in which the midnormals of O23 l' and O34 l are parallel to the real asymptote of the \
     centerpoint curve: l' and l are mirror images. K is constructed from it.",
    build_center,
    [
        "O_12": "pole of the positions 1 and 2",
        "O_13": "pole of the positions 1 and 3",
        "O_31": "the same pole, as the print writes it here",
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
        "l": "the point 1_∞ of the link at O14",
        "l'": "the joint of the link at O12 for it",
        "m": "the midnormal m_∞, line through O14 in the direction of the center M_∞",
        "K": "the circlepoint K_∞ in position 1, where the midnormals of O23^1 l' and O34^1 l meet",
    ]
);

pub const CIRCLEPOINT: Scene = scene!(
    "filemon1970/circlepoint-at-infinity",
    "Four positions as in the scene pole-system, and the position of the four-bar O12 O23 O34 O14 \
     in which the midnormals of O23^1 l' and O34^1 l are parallel to the real asymptote of the \
     circlepoint curve: l' and l are mirror images. M is constructed from it.",
    build_circlepoint,
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
        "l": "the point 1_∞ of the link at O14",
        "l'": "the joint of the link at O12 for it",
        "k": "the midnormal k_∞, line through O14 in the direction of K_∞ in position 1",
        "M": "the center, where the midnormals of O23 l' and O34 l meet",
    ]
);

fn build_center<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let positions = Positions::free(free)?;
    let four_bar = PoleFourBar::of(&positions.poles, &positions.mirror_poles, [2, 3, 4]);
    let moved = four_bar.moved_for_infinite_center();
    let pair = four_bar.pair(&moved);
    at_infinity(&pair.center)?;
    let mut bindings = Bindings::new(free.precision());
    positions.bind(&mut bindings);
    bind_moved(&moved, &mut bindings);
    bindings.bind("K", finite(&pair.circlepoint)?);
    bindings.bind("O_31", positions.poles.of(3, 1).clone());
    let [_, pivot] = &four_bar.frame;
    bindings.bind("m", line_from(pivot, &four_bar.center_asymptote()));
    Ok(bindings)
}

fn build_circlepoint<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let positions = Positions::free(free)?;
    let four_bar = PoleFourBar::of(&positions.poles, &positions.mirror_poles, [2, 3, 4]);
    let moved = four_bar.moved_for_infinite_circlepoint();
    let pair = four_bar.pair(&moved);
    at_infinity(&pair.circlepoint)?;
    let mut bindings = Bindings::new(free.precision());
    positions.bind(&mut bindings);
    bind_moved(&moved, &mut bindings);
    bindings.bind("M", finite(&pair.center)?);
    let [_, pivot] = &four_bar.frame;
    bindings.bind("k", line_from(pivot, &four_bar.circlepoint_asymptote()));
    Ok(bindings)
}

fn at_infinity<K: Real>(point: &ProjectivePoint<K>) -> Result<(), Unbuilt> {
    Unbuilt::unless_true::<K>(point.is_at_infinity(), "the midnormals are not parallel")
}

fn bind_moved<K: Real>([first, second]: &Joints<K>, bindings: &mut Bindings<K>) {
    bindings.bind("l'", first.clone());
    bindings.bind("l", second.clone());
}

/// The line through a point in a direction.
fn line_from<K: Real>(point: &Point<K>, direction: &Point<K>) -> Value<K> {
    let through = |point: &Point<K>| ProjectivePoint::from_finite(point);
    let line = Line::through(&through(point), &ProjectivePoint::from_direction(direction));
    Value::Line(line.coefficients().clone())
}
