//! Chapter III: the linear equations of five positions and the two conics that they leave.

use super::burmester_pair::pair;
use super::quadratic::Quadratic;
use crate::formula::Bindings;
use crate::number::{Number, Real, linear};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/five-positions",
    "Five positions of the moving plane with a pair that is known. Z_3 to Z_6 as functions of Z_0, Z_1, \
     Z_2 come from the circle conditions by elimination, the conics from the two products that Z_3 \
     and Z_4 are.",
    build,
    not symbolic: "the solution of four linear equations with free symbols",
    [
        "phi_0": "turn of position 0",
        "phi_1": "turn of position 1",
        "phi_2": "turn of position 2",
        "phi_3": "turn of position 3",
        "phi_4": "turn of position 4",
        "a_0": "coordinate of the moving origin in position 0",
        "a_1": "coordinate of the moving origin in position 1",
        "a_2": "coordinate of the moving origin in position 2",
        "a_3": "coordinate of the moving origin in position 3",
        "a_4": "coordinate of the moving origin in position 4",
        "b_0": "coordinate of the moving origin in position 0",
        "b_1": "coordinate of the moving origin in position 1",
        "b_2": "coordinate of the moving origin in position 2",
        "b_3": "coordinate of the moving origin in position 3",
        "b_4": "coordinate of the moving origin in position 4",
        "a_0'": "coordinate of the fixed origin in the moving plane in position 0; printed underlined",
        "a_1'": "coordinate of the fixed origin in the moving plane in position 1; printed underlined",
        "a_2'": "coordinate of the fixed origin in the moving plane in position 2; printed underlined",
        "a_3'": "coordinate of the fixed origin in the moving plane in position 3; printed underlined",
        "a_4'": "coordinate of the fixed origin in the moving plane in position 4; printed underlined",
        "b_0'": "coordinate of the fixed origin in the moving plane in position 0; printed underlined",
        "b_1'": "coordinate of the fixed origin in the moving plane in position 1; printed underlined",
        "b_2'": "coordinate of the fixed origin in the moving plane in position 2; printed underlined",
        "b_3'": "coordinate of the fixed origin in the moving plane in position 3; printed underlined",
        "b_4'": "coordinate of the fixed origin in the moving plane in position 4; printed underlined",
        "Z_0": "common factor of the coordinates of a pair of these positions",
        "Z_1": "coordinate 1 of the pair",
        "Z_2": "coordinate 2 of the pair",
        "Z_3": "coordinate 3 of the pair",
        "Z_4": "coordinate 4 of the pair",
        "Z_5": "coordinate 5 of the pair",
        "Z_6": "coordinate 6 of the pair",
        "Delta": "determinant of the coefficients of Z_3 to Z_6",
        "Delta_{1,1}": "minor of the coefficient of Z_3 in the equation of position 1",
        "Delta_{1,2}": "minor of the coefficient of Z_4 in the equation of position 1",
        "Delta_{1,3}": "minor of the coefficient of Z_5 in the equation of position 1",
        "Delta_{1,4}": "minor of the coefficient of Z_6 in the equation of position 1",
        "Delta_{2,1}": "minor of the coefficient of Z_3 in the equation of position 2",
        "Delta_{2,2}": "minor of the coefficient of Z_4 in the equation of position 2",
        "Delta_{2,3}": "minor of the coefficient of Z_5 in the equation of position 2",
        "Delta_{2,4}": "minor of the coefficient of Z_6 in the equation of position 2",
        "Delta_{3,1}": "minor of the coefficient of Z_3 in the equation of position 3",
        "Delta_{3,2}": "minor of the coefficient of Z_4 in the equation of position 3",
        "Delta_{3,3}": "minor of the coefficient of Z_5 in the equation of position 3",
        "Delta_{3,4}": "minor of the coefficient of Z_6 in the equation of position 3",
        "Delta_{4,1}": "minor of the coefficient of Z_3 in the equation of position 4",
        "Delta_{4,2}": "minor of the coefficient of Z_4 in the equation of position 4",
        "Delta_{4,3}": "minor of the coefficient of Z_5 in the equation of position 4",
        "Delta_{4,4}": "minor of the coefficient of Z_6 in the equation of position 4",
        "A_1": "what multiplies Z_0 in Z_3 Delta",
        "A_2": "what multiplies Z_0 in Z_4 Delta",
        "A_3": "what multiplies Z_0 in Z_5 Delta",
        "A_4": "what multiplies Z_0 in Z_6 Delta",
        "B_1": "what multiplies Z_1 in Z_3 Delta",
        "B_2": "what multiplies Z_1 in Z_4 Delta",
        "B_3": "what multiplies Z_1 in Z_5 Delta",
        "B_4": "what multiplies Z_1 in Z_6 Delta",
        "C_1": "what multiplies Z_2 in Z_3 Delta",
        "C_2": "what multiplies Z_2 in Z_4 Delta",
        "C_3": "what multiplies Z_2 in Z_5 Delta",
        "C_4": "what multiplies Z_2 in Z_6 Delta",
        "a": "coefficient of the first conic in Z_1/Z_0 and Z_2/Z_0, that of (Z_2/Z_0)^2 being 1",
        "b": "coefficient of the first conic in Z_1/Z_0 and Z_2/Z_0, that of (Z_2/Z_0)^2 being 1",
        "c": "coefficient of the first conic in Z_1/Z_0 and Z_2/Z_0, that of (Z_2/Z_0)^2 being 1",
        "d": "coefficient of the first conic in Z_1/Z_0 and Z_2/Z_0, that of (Z_2/Z_0)^2 being 1",
        "e": "coefficient of the first conic in Z_1/Z_0 and Z_2/Z_0, that of (Z_2/Z_0)^2 being 1",
        "f": "coefficient of the second conic in Z_1/Z_0 and Z_2/Z_0, that of (Z_2/Z_0)^2 being 1",
        "g": "coefficient of the second conic in Z_1/Z_0 and Z_2/Z_0, that of (Z_2/Z_0)^2 being 1",
        "h": "coefficient of the second conic in Z_1/Z_0 and Z_2/Z_0, that of (Z_2/Z_0)^2 being 1",
        "k": "coefficient of the second conic in Z_1/Z_0 and Z_2/Z_0, that of (Z_2/Z_0)^2 being 1",
        "l": "coefficient of the second conic in Z_1/Z_0 and Z_2/Z_0, that of (Z_2/Z_0)^2 being 1",
    ]
);

/// The solution of linear equations, each a row of coefficients and the right side.
pub(super) fn solution<K: Real>(rows: &[Vec<Number<K>>]) -> Result<Vec<Number<K>>, Unbuilt> {
    linear::solution(rows).ok_or_else(|| Unbuilt::NotReal("dependent positions".to_owned()))
}

/// Binds the determinant of a square of numbers and its minors Δ_{j,i}.
pub(super) fn bind_minors<K: Real>(rows: &[Vec<Number<K>>], bindings: &mut Bindings<K>) {
    for j in 0..rows.len() {
        for i in 0..rows.len() {
            let name = format!("Delta_{{{},{}}}", j + 1, i + 1);
            bindings.bind(&name, linear::minor(rows, j, i));
        }
    }
    bindings.bind("Delta", linear::determinant(rows));
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let pair = pair(free)?;
    let factor = free.number("Z_0")?;
    let mut bindings = Bindings::new(free.precision());
    pair.bind_positions(&mut bindings);
    for (i, coordinate) in pair.coordinates(&factor).into_iter().enumerate() {
        bindings.bind(&format!("Z_{i}"), coordinate);
    }
    // ½|t|²h + Re(t̄rz) − Re(t̄M) − Re((r − 1)w) = 0 with z, w, −M by the coordinates of the pair.
    let mut square = Vec::new();
    let mut right = [const { Vec::new() }; 3];
    for position in pair.positions.iter().skip(1) {
        let (r, t) = (&position.rotation, &position.translation);
        let mixed = t.conj() * r;
        square.push(vec![
            1 - r.re(),
            r.im().clone(),
            t.re().clone(),
            t.im().clone(),
        ]);
        let entries = [t.norm() / -2, mixed.re().clone(), -mixed.im()];
        for (column, entry) in right.iter_mut().zip(entries) {
            column.push(entry);
        }
    }
    bind_minors(&square, &mut bindings);
    let whole = linear::determinant(&square);
    let mut parts = Vec::new();
    for (column, name) in right.iter().zip(["A", "B", "C"]) {
        let rows: Vec<Vec<Number<K>>> = (square.iter().zip(column))
            .map(|(row, right)| row.iter().chain([right]).cloned().collect())
            .collect();
        let part: Vec<Number<K>> = solution(&rows)?.iter().map(|x| x * &whole).collect();
        for (i, value) in part.iter().enumerate() {
            bindings.bind(&format!("{name}_{}", i + 1), value.clone());
        }
        parts.push(part);
    }
    bind_conics(&parts, &whole, &mut bindings);
    Ok(bindings)
}

/// With Z₀ = 1, Z₁ = u, Z₂ = v, Z₃ to Z₆ linear in u and v: Z₃ − uZ₅ − vZ₆ and Z₄ − vZ₅ + uZ₆, by their
/// values.
#[expect(
    clippy::indexing_slicing,
    reason = "three parts of Z₃ to Z₆ each, and no other Z is asked for"
)]
fn bind_conics<K: Real>(parts: &[Vec<Number<K>>], whole: &Number<K>, bindings: &mut Bindings<K>) {
    let z = |i: usize, u: i64, v: i64| {
        (&parts[0][i - 3] + &parts[1][i - 3] * u + &parts[2][i - 3] * v) / whole
    };
    let first = |u: i64, v: i64| z(3, u, v) - u * z(5, u, v) - v * z(6, u, v);
    let second = |u: i64, v: i64| z(4, u, v) - v * z(5, u, v) + u * z(6, u, v);
    bind_conic(first, ["a", "b", "c", "d", "e"], bindings);
    bind_conic(second, ["f", "g", "h", "k", "l"], bindings);
}

/// By the values of a polynomial of order 2 in u and v: the coefficients of uv, v, u², u, 1 over that
/// of v².
fn bind_conic<K: Real>(
    conic: impl Fn(i64, i64) -> Number<K>,
    names: [&str; 5],
    bindings: &mut Bindings<K>,
) {
    let Quadratic {
        x2,
        xy,
        y2,
        x,
        y,
        constant,
    } = Quadratic::interpolated(conic);
    for (name, coefficient) in names.into_iter().zip([xy, y, x2, x, constant]) {
        bindings.bind(name, coefficient / &y2);
    }
}
