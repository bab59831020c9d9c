//! Chapter III: the cubic of five positions on a line, one root of which is known.

use crate::formula::Bindings;
use crate::number::Real;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/known-center",
    "Numbers M, N for which the polynomial of the centers, t (Z_1^2 + Z_2^2) - Z_1 Z_3 - Z_2 Z_4 with \
     Z_i = M_i + N_i t, has three given roots: M_3, M_4, N_3 follow from them.",
    build,
    [
        "M_1": "coefficient of the cubic (3.32)",
        "M_2": "coefficient of the cubic (3.32)",
        "M_3": "coefficient of the cubic (3.32)",
        "M_4": "coefficient of the cubic (3.32)",
        "N_1": "coefficient of the cubic (3.32)",
        "N_2": "coefficient of the cubic (3.32)",
        "N_3": "coefficient of the cubic (3.32)",
        "N_4": "coefficient of the cubic (3.32)",
        "X_{c,a}": "coordinate of the known center: less the known root",
        "z_5": "any number",
        "z_0": "any number that is not zero",
        "rest": "the cubic at z_5/z_0, divided by its leading coefficient and by the factor of the known root",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let [m1, m2] = [free.number("M_1")?, free.number("M_2")?];
    let [n1, n2, n4] = [
        free.number("N_1")?,
        free.number("N_2")?,
        free.number("N_4")?,
    ];
    let [a, b, c] = &[
        free.number("root a")?,
        free.number("root b")?,
        free.number("root c")?,
    ];
    let (z5, z0) = (free.number("z_5")?, free.number("z_0")?);
    // (N₁² + N₂²)(t − a)(t − b)(t − c), term by term.
    let leading = n1.square() + n2.square();
    let n3 = (2 * (&m1 * &n1 + &m2 * &n2) - &n2 * &n4 + &leading * (a + b + c)) / &n1;
    // M₁M₃ + M₂M₄ and N₁M₃ + N₂M₄ are then known.
    let first = &leading * a * b * c;
    let second =
        m1.square() + m2.square() - &m1 * &n3 - &m2 * &n4 - &leading * (a * b + b * c + c * a);
    let cross = &m1 * &n2 - &m2 * &n1;
    let m3 = (&first * &n2 - &second * &m2) / &cross;
    let m4 = (&m1 * &second - &n1 * &first) / &cross;
    let at = &z5 / &z0;
    let rest = (&at - b) * (&at - c);
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("X_{c,a}", -a);
    for (name, value) in [
        ("M_1", m1),
        ("M_2", m2),
        ("M_3", m3),
        ("M_4", m4),
        ("N_1", n1),
        ("N_2", n2),
        ("N_3", n3),
        ("N_4", n4),
        ("z_5", z5),
        ("z_0", z0),
        ("rest", rest),
    ] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}
