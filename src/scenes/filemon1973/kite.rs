//! Figure 9: two times two nearby sides of the pole quadrilateral have the same length.

use super::count::bind_number;
use super::count::counted;
use super::quadrilateral::centerpoint_curve;
use crate::formula::{Bindings, Value};
use crate::number::{Number, Real};
use crate::plane::circle::Circle;
use crate::plane::tangents::Pencil;
use crate::plane::{Point, line};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1973/kite",
    "Figure 9: a pole quadrilateral with r = c and R = h, O12 in the origin and O34 on the x-axis; the \
     directions of the sides and a size are free.",
    build,
    [
        "M": "coefficients of x^3, x^2 y, x y^2, y^3, x^2, x y, y^2, x, y, 1 of the centerpoint curve",
        "m": "abscissa of the center of the circle through O14, O23 and O1, on the x-axis",
        "n": "power of the origin for this circle, x^2 + y^2 - 2 m x + n = 0",
        "O_1": "Q_13, where the lines O12 O23 and O14 O34 meet",
        "M_1": "midpoint of O12 O34, on the middle line",
        "M_2": "midpoint of O14 O23, on the middle line",
        "e_zeta": "unit vector from O12 to O23",
        "e_eta": "unit vector from O14 to O34",
    ]
);

pub const TANGENTS: Scene = scene!(
    "filemon1973/tangents-of-a-kite",
    "The kite of figure 9 and the tangents from O1 to its centerpoint curve, counted by the real roots of \
     the equation of order four for the lines through O1.",
    build_tangents,
    not symbolic: "numbers of real tangents",
    [
        "r": "length of the side O12 O23",
        "h": "length of the side O23 O34",
        "R": "length of the side O14 O34",
        "c": "length of the side O12 O14",
        "U": "sum of the shortest and the longest side",
        "Z": "sum of the other two sides",
        "N_1": "number of real tangents from O1 to other points of the curve",
        "I_1": "number of imaginary tangents from O1",
        "nodes": "number of double points of the curve",
    ]
);

/// O₁₂ = 0, O₁₄ = c e^{iγ}, O₂₃ its mirror image, O₃₄ = O₁₄ + h e^{−iδ} on the x-axis.
struct Kite<K> {
    c: Number<K>,
    h: Number<K>,
    /// O₁₂, O₂₃, O₃₄, O₁₄
    poles: [Point<K>; 4],
    e_zeta: Point<K>,
    e_eta: Point<K>,
}

impl<K: Real> Kite<K> {
    fn free(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let (gamma, delta) = (free.angle("gamma")?, free.angle("delta")?);
        let size = free.length("size")?;
        let (c, h) = (&size * delta.sin(), &size * gamma.sin());
        Unbuilt::unless_real(c.is_positive(), "c is no length")?;
        Unbuilt::unless_real((&h - &c).is_positive(), "c is not the shorter one")?;
        let o14 = gamma.cis().scaled(&c);
        let o34 = (&gamma + &delta).sin() * size;
        Ok(Kite {
            c,
            h,
            poles: [Number::zero(), o14.conj(), o34.into(), o14],
            e_zeta: gamma.cis().conj(),
            e_eta: delta.cis().conj(),
        })
    }

    fn o1(&self) -> Point<K> {
        let [o12, o23, o34, o14] = &self.poles;
        line::meet(o12, o23, o14, o34)
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let kite = Kite::free(free)?;
    let curve = centerpoint_curve(&kite.poles)?;
    let o1 = kite.o1();
    let [o12, o23, o34, o14] = &kite.poles;
    let circle = Circle::through(o14, o23, &o1);
    let mut bindings = Bindings::new(free.precision());
    let coefficients = curve.coefficients().each_ref();
    let coefficients = coefficients.map(|coefficient| Value::Number(coefficient.clone()));
    bindings.bind("M", Value::List(coefficients.into()));
    bindings.bind("m", circle.center().re().clone());
    bindings.bind("n", circle.power(&Number::zero()));
    for (name, point) in [
        ("M_1", (o12 + o34) / 2),
        ("M_2", (o14 + o23) / 2),
        ("O_1", o1),
        ("e_zeta", kite.e_zeta),
        ("e_eta", kite.e_eta),
    ] {
        bindings.bind(name, point);
    }
    Ok(bindings)
}

fn build_tangents<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let kite = Kite::free(free)?;
    let curve = centerpoint_curve(&kite.poles)?;
    let axes = [kite.e_zeta.clone(), kite.e_eta.clone()];
    let count = counted(&Pencil::new(&curve, &kite.o1(), axes))?;
    let mut bindings = Bindings::new(free.precision());
    for (name, number) in [
        ("N_1", count.real),
        ("I_1", count.imaginary),
        ("nodes", count.double),
    ] {
        bind_number(&mut bindings, name, number);
    }
    for name in ["U", "Z"] {
        bindings.bind(name, &kite.c + &kite.h);
    }
    for name in ["r", "c"] {
        bindings.bind(name, kite.c.clone());
    }
    for name in ["R", "h"] {
        bindings.bind(name, kite.h.clone());
    }
    Ok(bindings)
}
