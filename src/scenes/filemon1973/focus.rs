//! Increasing the accuracy: focus, asymptote and middle line of the centerpoint curve.

use super::quadrilateral::centerpoint_curve;
use crate::formula::{Bindings, Value};
use crate::number::{Number, Real};
use crate::plane::circular_cubic::Cubic;
use crate::plane::tangents::Pencil;
use crate::plane::{Point, line};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1973/focus",
    "Any pole quadrilateral, moved so that O12 lies on the x-axis and the focus of its centerpoint curve \
     in the origin: O12, O14 and the product O12 O34 = O14 O23 are free. The focus is where the \
     tangents at the circular points meet. O12 can be any point of the curve, for other point pairs \
     give the same curve.",
    build,
    [
        "F": "focus of the centerpoint curve",
        "F_v": "mirror image of F in the middle line",
        "M_1": "midpoint of O12 O34, on the middle line v",
        "M_2": "midpoint of O14 O23, on the middle line v",
        "a": "the asymptote of the curve that is real",
        "O_12": "pole of the positions 1 and 2",
        "O_14": "pole of the positions 1 and 4",
        "Q_13": "where the lines O12 O23 and O14 O34 meet",
        "X_12": "where the line F O12 meets the curve once more",
        "X_14": "where the line F O14 meets the curve once more",
        "X_13": "where the line F Q_13 meets the curve once more",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let o12: Point<K> = free.length("F O_12")?.into();
    let o14 = point(free, "O_14")?;
    let product = point(free, "O_12 O_34")?;
    let (o34, o23) = (&product / &o12, &product / &o14);
    let curve = centerpoint_curve(&[o12.clone(), o23.clone(), o34.clone(), o14.clone()])?;
    let focus = curve.singular_focus();
    Unbuilt::unless_true::<K>(
        focus.is_zero() & curve.at(&focus).is_zero(),
        "the focus is not in the origin, or not on the curve",
    )?;
    let (m_1, m_2) = ((&o12 + &o34) / 2, (&o14 + &o23) / 2);
    let q_13 = line::meet(&o12, &o23, &o14, &o34);
    let mut bindings = Bindings::new(free.precision());
    let asymptote = curve.real_asymptote();
    bindings.bind("a", Value::Line(asymptote.coefficients().clone()));
    for (name, point) in [
        ("X_12", other_meet(&curve, &focus, &o12)),
        ("X_14", other_meet(&curve, &focus, &o14)),
        ("X_13", other_meet(&curve, &focus, &q_13)),
        ("F_v", line::mirror(&focus, &m_1, &m_2)),
        ("F", focus),
        ("M_1", m_1),
        ("M_2", m_2),
        ("O_12", o12),
        ("O_14", o14),
        ("Q_13", q_13),
    ] {
        bindings.bind(name, point);
    }
    Ok(bindings)
}

/// Where the line through two points of a cubic meets it once more.
fn other_meet<K: Real>(curve: &Cubic<K>, from: &Point<K>, to: &Point<K>) -> Point<K> {
    let direction = to - from;
    let across = Number::i() * &direction;
    let [first, _, third] =
        Pencil::new(curve, from, [direction.clone(), across]).along(&Number::zero());
    // F₁ + F₂ t + F₃ t² vanishes for t = 1.
    from + direction.scaled(&(first / third))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Exact, Truth};
    use crate::scenes::free::Random;

    /// The other reading of the text, which is wrong.
    #[test]
    fn mirror_images_in_the_middle_line_are_not_on_the_curve() {
        let mut free = Random::new(5);
        let [a, b, k]: [Point<Exact>; 3] = std::array::from_fn(|_| point(&mut free, "").unwrap());
        let poles = [a.clone(), &k / &b, &k / &a, b.clone()];
        let [m_1, m_2] = [(&poles[0] + &poles[2]) / 2, (&poles[1] + &poles[3]) / 2];
        let curve = centerpoint_curve(&poles).unwrap();
        for pole in &poles {
            let image = line::mirror(pole, &m_1, &m_2);
            assert_eq!(curve.at(&image).is_zero(), Truth::No);
        }
    }
}
