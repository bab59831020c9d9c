//! Chapter V: linkages that are symmetric in their central position.

use super::sense::sense;
use crate::curvature::closure;
use crate::curvature::contact::Guide;
use crate::curvature::motion::coefficient;
use crate::formula::Bindings;
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Number, Real, array};
use crate::plane::{Angle, Point, relation};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/symmetric-linkage",
    "A four-bar in its central position, with the coupler from A to B of length 2, and any point of \
     the plane. The x-axis leads from the pivot O_a, the origin, to O_b, the coupler is parallel to \
     it, and the output point D is on the axis of symmetry. The u-axis is the tangent of the path of \
     D, in the direction of x; D is the origin. Angles turn from x to y.",
    build,
    not symbolic: "the sign of a",
    [
        "a": "half the distance of the pivots, negative where O_aO_b and AB have opposite directions",
        "c": "height of the triangle ABD, positive where D is on the right of the way from A to B",
        "d": "ordinate of the coupler",
        "M": "distance of D from A",
        "N": "distance of D from B",
        "R": "length of the crank O_aA",
        "T": "length of the crank O_bB",
        "Q": "distance of the pivots",
        "epsilon": "from AB to AD",
        "x": "coordinate of the point",
        "y": "coordinate of the point",
        "u": "coordinate of the same point",
        "v": "coordinate of the same point",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let half = free.length("|a|")?;
    let sense = sense(free, "sign of a")?;
    let (c, d) = (free.number("c")?, free.number("d")?);
    let place = point(free, "the point")?;
    let CouplerPoint {
        pivots,
        pins,
        point: output,
    } = central_position(&half, &sense, &c, &d);
    moves_along_x(&pivots, &pins, &output)?;
    let length = relation::distance::<K>;
    let ([o_a, o_b], [pin_a, pin_b]) = (&pivots, &pins);
    let from_d = &place - &output;
    let mut bindings = Bindings::new(free.precision());
    let m = length(&output, pin_a);
    let opening = (&output - pin_a) * (pin_b - pin_a).conj();
    bindings.bind("epsilon", Angle::of_known_length(opening, 2 * &m));
    for (name, value) in [
        ("a", half * sense),
        ("c", c),
        ("d", d.clone()),
        ("M", m),
        ("N", length(&output, pin_b)),
        ("R", length(o_a, pin_a)),
        ("T", length(o_b, pin_b)),
        ("Q", length(o_a, o_b)),
        ("x", place.re().clone()),
        ("y", place.im().clone()),
        ("u", from_d.re().clone()),
        ("v", from_d.im().clone()),
    ] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}

/// The linkage with half of the base and its sense, the height of the triangle and that of the coupler.
pub(super) fn central_position<K: Real>(
    half: &Number<K>,
    sense: &Number<K>,
    c: &Number<K>,
    d: &Number<K>,
) -> CouplerPoint<K> {
    let axis = Point::from(half.clone());
    let coupler = |along: Number<K>, across: Number<K>| {
        &axis
            + Number::complex(Number::zero(), d.clone())
            + Number::complex(along, across).scaled(sense)
    };
    CouplerPoint {
        pivots: [Number::zero(), &axis * 2],
        pins: [-1, 1].map(|along| coupler(along.into(), Number::zero())),
        point: coupler(Number::zero(), -c),
    }
}

/// That the path of the output point starts parallel to the x-axis.
fn moves_along_x<K: Real>(
    pivots: &[Point<K>; 2],
    pins: &[Point<K>; 2],
    output: &Point<K>,
) -> Result<(), Unbuilt> {
    let guides = array::pairs(pins, pivots).map(|(pin, pivot)| Guide::Circle {
        point: pin.clone(),
        center: pivot.clone(),
    });
    let motion = closure::motion(&guides, 1)
        .ok_or_else(|| Unbuilt::NotReal("the linkage is in a change point".to_owned()))?;
    let velocity = coefficient(&motion.path_of(output), 1);
    Unbuilt::unless_true::<K>(velocity.im().is_zero(), "the path of D starts along x")
}
