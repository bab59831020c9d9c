//! Chapter III: five positions in which the moving origin is on the X-axis.

use super::five_positions::{bind_minors, solution};
use crate::formula::Bindings;
use crate::number::{Number, Real, linear};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/five-positions-on-a-line",
    "Five positions of the moving plane, its origin on the X-axis in all of them. Z_1 to Z_4 come from \
     the circle conditions by elimination for any Z_0, Z_5, and Z_6 from the first of the two \
     products; the second then holds for three values of Z_5/Z_0 only, those of the pairs.",
    build,
    not symbolic: "the solution of four linear equations with free symbols",
    [
        "phi_1": "turn of position 1",
        "phi_2": "turn of position 2",
        "phi_3": "turn of position 3",
        "phi_4": "turn of position 4",
        "a_1": "abscissa of the moving origin in position 1",
        "a_2": "abscissa of the moving origin in position 2",
        "a_3": "abscissa of the moving origin in position 3",
        "a_4": "abscissa of the moving origin in position 4",
        "Z_0": "common factor",
        "Z_1": "solution of the four linear equations for these Z_0, Z_5",
        "Z_2": "solution of the four linear equations for these Z_0, Z_5",
        "Z_3": "solution of the four linear equations for these Z_0, Z_5",
        "Z_4": "solution of the four linear equations for these Z_0, Z_5",
        "Z_5": "any number",
        "Z_6": "what the first product Z_0 Z_3 = Z_1 Z_5 + Z_2 Z_6 needs",
        "excess": "Z_0 Z_4 - Z_2 Z_5 + Z_1 Z_6 over Z_0^2: zero for a pair",
        "Delta": "determinant of the coefficients of Z_1 to Z_4",
        "Delta_{1,1}": "minor of the coefficient of Z_1 in the equation of position 1",
        "Delta_{1,2}": "minor of the coefficient of Z_2 in the equation of position 1",
        "Delta_{1,3}": "minor of the coefficient of Z_3 in the equation of position 1",
        "Delta_{1,4}": "minor of the coefficient of Z_4 in the equation of position 1",
        "Delta_{2,1}": "minor of the coefficient of Z_1 in the equation of position 2",
        "Delta_{2,2}": "minor of the coefficient of Z_2 in the equation of position 2",
        "Delta_{2,3}": "minor of the coefficient of Z_3 in the equation of position 2",
        "Delta_{2,4}": "minor of the coefficient of Z_4 in the equation of position 2",
        "Delta_{3,1}": "minor of the coefficient of Z_1 in the equation of position 3",
        "Delta_{3,2}": "minor of the coefficient of Z_2 in the equation of position 3",
        "Delta_{3,3}": "minor of the coefficient of Z_3 in the equation of position 3",
        "Delta_{3,4}": "minor of the coefficient of Z_4 in the equation of position 3",
        "Delta_{4,1}": "minor of the coefficient of Z_1 in the equation of position 4",
        "Delta_{4,2}": "minor of the coefficient of Z_2 in the equation of position 4",
        "Delta_{4,3}": "minor of the coefficient of Z_3 in the equation of position 4",
        "Delta_{4,4}": "minor of the coefficient of Z_4 in the equation of position 4",
        "M_1": "what multiplies Z_0 in Z_1 Delta",
        "M_2": "what multiplies Z_0 in Z_2 Delta",
        "M_3": "what multiplies Z_0 in Z_3 Delta",
        "M_4": "what multiplies Z_0 in Z_4 Delta",
        "N_1": "what multiplies Z_5 in Z_1 Delta",
        "N_2": "what multiplies Z_5 in Z_2 Delta",
        "N_3": "what multiplies Z_5 in Z_3 Delta",
        "N_4": "what multiplies Z_5 in Z_4 Delta",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let mut bindings = Bindings::new(free.precision());
    let mut square = Vec::new();
    let mut right = [const { Vec::new() }; 2];
    for j in 1..=4 {
        let phi = free.angle(&format!("phi_{j}"))?;
        let a = free.number(&format!("a_{j}"))?;
        let r = phi.cis();
        // ½|t|²h + Re(t̄rz) − Re(t̄M) − Re((r − 1)w) = 0 for a real t.
        square.push(vec![
            -(&a * r.re()),
            &a * r.im(),
            1 - r.re(),
            r.im().clone(),
        ]);
        for (column, entry) in right.iter_mut().zip([a.square() / -2, -&a]) {
            column.push(entry);
        }
        bindings.bind(&format!("phi_{j}"), phi);
        bindings.bind(&format!("a_{j}"), a);
    }
    bind_minors(&square, &mut bindings);
    let whole = linear::determinant(&square);
    let (z0, z5) = (free.number("Z_0")?, free.number("Z_5")?);
    let mut z: [Number<K>; 4] = std::array::from_fn(|_| Number::zero());
    for (column, (name, factor)) in right.iter().zip([("M", &z0), ("N", &z5)]) {
        let rows: Vec<Vec<Number<K>>> = (square.iter().zip(column))
            .map(|(row, right)| row.iter().chain([right]).cloned().collect())
            .collect();
        for (i, (z, part)) in z.iter_mut().zip(solution(&rows)?).enumerate() {
            *z += factor * &part;
            bindings.bind(&format!("{name}_{}", i + 1), part * &whole);
        }
    }
    let [z1, z2, z3, z4] = &z;
    let z6 = (&z0 * z3 - z1 * &z5) / z2;
    let excess = (&z0 * z4 - z2 * &z5 + z1 * &z6) / z0.square();
    for (i, value) in z.into_iter().enumerate() {
        bindings.bind(&format!("Z_{}", i + 1), value);
    }
    for (name, value) in [("Z_0", z0), ("Z_5", z5), ("Z_6", z6), ("excess", excess)] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}
