//! The nodal centerpoint curve, from its double point.

use super::quadrilateral::centerpoint_curve;
use crate::formula::Bindings;
use crate::number::{Kind, Number, Real};
use crate::plane::Point;
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1973/nodal-curve",
    "Any centerpoint curve with a double point: this is put into the origin and the middle line on the \
     x-axis. Point pairs X, X' have their midpoint on the middle line and, as the double point is a \
     pair with coincident elements and the focus F one with the point at infinity, \
     (X - F)(X' - F) = F^2. F and the slopes of the lines to O12 and O14 are free.",
    build,
    [
        "H": "double point",
        "F": "focus",
        "O_12": "pole of the positions 1 and 2",
        "O_14": "pole of the positions 1 and 4",
        "t_xx": "of the tangents t_xx x^2 + t_xy x y + t_yy y^2 = 0 in H",
        "t_xy": "of the tangents t_xx x^2 + t_xy x y + t_yy y^2 = 0 in H",
        "t_yy": "of the tangents t_xx x^2 + t_xy x y + t_yy y^2 = 0 in H",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let focus = point(free, "F")?;
    let o12 = point_of_slope(&focus, &free.number("slope of H O_12")?);
    let o14 = point_of_slope(&focus, &free.number("slope of H O_14")?);
    let partner = |x: &Point<K>| &focus * x / (x - &focus);
    let curve = centerpoint_curve(&[o12.clone(), partner(&o14), partner(&o12), o14.clone()])?;
    let node = Point::<K>::zero();
    Unbuilt::unless_true::<K>(
        curve.at(&node).is_zero() & curve.gradient(&node).is_zero(),
        "H is no double point",
    )?;
    let mut bindings = Bindings::new(free.precision());
    for (name, coefficient) in ["t_xx", "t_xy", "t_yy"]
        .into_iter()
        .zip(curve.coefficients().iter().skip(4))
    {
        bindings.bind(name, coefficient.clone());
    }
    for (name, point) in [("H", node), ("F", focus), ("O_12", o12), ("O_14", o14)] {
        bindings.bind(name, point);
    }
    Ok(bindings)
}

/// X = λ(1 + im) for which X + X' = X²/(X − F) is real, |X|² Im X = Im (X² F̄).
fn point_of_slope<K: Kind>(focus: &Point<K>, slope: &Number<K>) -> Point<K> {
    let direction = Number::complex(Number::one(), slope.clone());
    let size = (direction.square() * focus.conj()).im() / (direction.norm() * slope);
    direction.scaled(&size)
}
