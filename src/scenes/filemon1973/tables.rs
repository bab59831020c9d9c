//! Tables I and II: the tangents from O₁ and O₂ for every order of the sides.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::count::counted;
use super::quadrilateral::{PoleQuadrilateral, Sums};
use super::sample::quadrilaterals;
use super::side_order::Sides;
use crate::number::{Exact, Number, Truth};
use crate::plane::circular_cubic::Cubic;
use crate::plane::tangents::Pencil;
use crate::scenes::Unbuilt;
use crate::scenes::table::{Cell, Cells, Table};

pub const TANGENTS: Table = Table {
    name: "tangents-by-order-of-sides",
    summary: "Random exact quadrilaterals of every shape, for each of the six orders of the sides with c < h \
              and r < R and for U > Z, U = Z and U < Z; the orders with the same shortest and the same \
              longest side are one part. The tangents from O1 and O2 are counted by the real roots of \
              the equation of order four, their pairs p, 1/p told apart by f_1 > f_2, and a double root \
              belongs to a double point. A cell says what a pair is where the sign of its row occurs, \
              and is blank where it does not. The wrong variant exchanges f_1 and f_2.",
    run: tangents,
};

pub const CASES: Table = Table {
    name: "cases-of-tangents",
    summary: "As in tangents-by-order-of-sides for O1 and h > R, with the shortest and the longest side \
              adjacent (A) or opposite (B): + where the signs of a row occur together, - where they do \
              not. The wrong variant exchanges A and B.",
    run: cases,
};

/// Of each order of the sides and each of U > Z, U = Z, U < Z.
const INSTANCES: usize = 6;

/// r, h, R, c by their place in the quadrilateral.
const PARTS: [(&str, usize, usize); 4] = [
    ("c shortest, h longest", 3, 1),
    ("c shortest, R longest", 3, 2),
    ("r shortest, R longest", 0, 2),
    ("r shortest, h longest", 0, 1),
];

const ORDERS: [Ordering; 3] = [Ordering::Greater, Ordering::Equal, Ordering::Less];

/// What was found of a quadrilateral.
#[derive(Clone, Debug)]
struct Observed {
    shortest: usize,
    longest: usize,
    u_against_z: Ordering,
    /// The signs of f₁² − 4 and f₂² − 4 for O₁ and for O₂.
    signs: [[Ordering; 2]; 2],
}

fn observed_quadrilaterals() -> Result<Vec<Observed>, Unbuilt> {
    let mut left: BTreeMap<(usize, usize, Ordering, Ordering), usize> = BTreeMap::new();
    let mut found = Vec::new();
    // Two orders of the sides each in the parts with the longest side adjacent to the shortest.
    let classes = 6 * ORDERS.len();
    for quadrilateral in quadrilaterals() {
        let quadrilateral = quadrilateral?;
        let sides = Sides::of(&quadrilateral)?;
        let u_against_z = order_of(&sides.u, &sides.z)?;
        let between = order_of_the_others(&quadrilateral, &sides)?;
        let class = (sides.shortest, sides.longest, u_against_z, between);
        let left_of_class = left.entry(class).or_insert(INSTANCES);
        if *left_of_class == 0 {
            continue;
        }
        *left_of_class -= 1;
        found.push(observe(&quadrilateral, &sides, u_against_z)?);
        if left.len() == classes && left.values().all(|left| *left == 0) {
            return Ok(found);
        }
    }
    Err(Unbuilt::NotHeld(
        "quadrilaterals of every order of the sides".to_owned(),
    ))
}

fn order_of(x: &Number<Exact>, y: &Number<Exact>) -> Result<Ordering, Unbuilt> {
    x.compare(y)
        .ok_or_else(|| Unbuilt::NotHeld("the order of two lengths".to_owned()))
}

/// The two sides that are neither shortest nor longest, in the order r, h, R, c.
fn order_of_the_others(
    quadrilateral: &PoleQuadrilateral<Exact>,
    sides: &Sides<Exact>,
) -> Result<Ordering, Unbuilt> {
    let PoleQuadrilateral { r, h, long, c, .. } = quadrilateral;
    let mut others = [r, h, long, c].into_iter().enumerate();
    let mut next = || others.find(|(place, _)| *place != sides.shortest && *place != sides.longest);
    match (next(), next()) {
        (Some((_, one)), Some((_, other))) => order_of(one, other),
        _ => Err(Unbuilt::Contradiction("fewer than four sides".to_owned())),
    }
}

fn observe(
    quadrilateral: &PoleQuadrilateral<Exact>,
    sides: &Sides<Exact>,
    u_against_z: Ordering,
) -> Result<Observed, Unbuilt> {
    let curve = quadrilateral.curve()?;
    let o1 = signs(
        &quadrilateral.sums_of_o1(&curve)?,
        &quadrilateral.pencil_of_o1(&curve),
        &curve,
    )?;
    let o2 = signs(
        &quadrilateral.sums_of_o2(&curve)?,
        &quadrilateral.pencil_of_o2(&curve),
        &curve,
    )?;
    Ok(Observed {
        shortest: sides.shortest,
        longest: sides.longest,
        u_against_z,
        signs: [o1, o2],
    })
}

/// The signs of f² − 4, which say what the roots of p² − f p + 1 = 0 are; together they must be what
/// the equation of order four has.
fn signs(
    sums: &Sums<Exact>,
    pencil: &Pencil<Exact>,
    curve: &Cubic<Exact>,
) -> Result<[Ordering; 2], Unbuilt> {
    let mut signs = [Ordering::Equal; 2];
    for (sign, f) in signs.iter_mut().zip(&sums.f) {
        *sign = order_of(&f.square(), &Number::from(4))?;
    }
    let count = counted(pencil)?;
    let pairs = |wanted: Ordering| signs.iter().filter(|sign| **sign == wanted).count();
    let agree = (count.real, count.imaginary, count.double)
        == (
            2 * pairs(Ordering::Greater),
            2 * pairs(Ordering::Less),
            pairs(Ordering::Equal),
        );
    let node = match pencil.double_point() {
        Some(node) => curve.at(&node).is_zero() & curve.gradient(&node).is_zero(),
        None => Truth::from(count.double == 0),
    };
    Unbuilt::unless_true::<Exact>(
        Truth::from(agree) & node,
        "the pairs of tangents are not those of the curve",
    )?;
    Ok(signs)
}

fn tangents() -> Result<Cells, Unbuilt> {
    let found = observed_quadrilaterals()?;
    let cells = cells_of_tangents(&found, [0, 1]);
    let wrong = cells_of_tangents(&found, [1, 0]);
    Ok(Cells {
        wrong_variant: Truth::from(cells == wrong),
        cells,
        instances: found.len(),
    })
}

#[expect(
    clippy::indexing_slicing,
    reason = "all of these places are 0 or 1, in arrays of two"
)]
fn cells_of_tangents(found: &[Observed], [first, second]: [usize; 2]) -> Vec<Cell> {
    use Ordering::{Equal, Greater, Less};
    const ROWS: [(&str, usize, Ordering); 6] = [
        ("f1>", 0, Greater),
        ("f1=", 0, Equal),
        ("f1<", 0, Less),
        ("f2>", 1, Greater),
        ("f2=", 1, Equal),
        ("f2<", 1, Less),
    ];
    const COLUMNS: [(&str, Ordering, usize); 6] = [
        ("U>Z/O1", Greater, 0),
        ("U>Z/O2", Greater, 1),
        ("U=Z/O1", Equal, 0),
        ("U=Z/O2", Equal, 1),
        ("U<Z/O1", Less, 0),
        ("U<Z/O2", Less, 1),
    ];
    let mut cells = Vec::new();
    for (part, shortest, longest) in PARTS {
        for (row, f, sign) in ROWS {
            for (column, u_against_z, origin) in COLUMNS {
                let f = [first, second][f];
                let occurs = found
                    .iter()
                    .filter(|one| (one.shortest, one.longest) == (shortest, longest))
                    .filter(|one| one.u_against_z == u_against_z)
                    .map(|one| one.signs[origin][f] == sign);
                let mark = match sign {
                    Greater => "2rt",
                    Equal => "1dp",
                    Less => "2is",
                };
                cells.push(cell([part, row, column], occurs, [mark, "(blank)"]));
            }
        }
    }
    cells
}

/// The mark of what occurs always, or never.
fn cell(
    [part, row, column]: [&'static str; 3],
    occurs: impl Iterator<Item = bool>,
    [always, never]: [&str; 2],
) -> Cell {
    let occurs: Vec<bool> = occurs.collect();
    let text = match (occurs.contains(&true), occurs.contains(&false)) {
        (true, false) => always.to_owned(),
        (false, true) => never.to_owned(),
        _ => format!("{always} sometimes"),
    };
    Cell {
        part,
        row,
        column,
        text,
        instances: occurs.len(),
    }
}

fn cases() -> Result<Cells, Unbuilt> {
    let found = observed_quadrilaterals()?;
    let cells = cells_of_cases(&found, [0, 3]);
    let wrong = cells_of_cases(&found, [3, 0]);
    Ok(Cells {
        wrong_variant: Truth::from(cells == wrong),
        cells,
        instances: found.len(),
    })
}

/// A and B by their shortest sides.
fn cells_of_cases(found: &[Observed], [adjacent, opposite]: [usize; 2]) -> Vec<Cell> {
    use Ordering::{Equal, Greater, Less};
    const ROWS: [(&str, [Ordering; 2]); 8] = [
        ("f1>f2>", [Greater, Greater]),
        ("f1<f2<", [Less, Less]),
        ("f1>f2<", [Greater, Less]),
        ("f1<f2>", [Less, Greater]),
        ("f1=f2>", [Equal, Greater]),
        ("f1>f2=", [Greater, Equal]),
        ("f1=f2<", [Equal, Less]),
        ("f1<f2=", [Less, Equal]),
    ];
    const COLUMNS: [(&str, Ordering, bool); 6] = [
        ("U>Z/A", Greater, true),
        ("U>Z/B", Greater, false),
        ("U=Z/A", Equal, true),
        ("U=Z/B", Equal, false),
        ("U<Z/A", Less, true),
        ("U<Z/B", Less, false),
    ];
    let mut cells = Vec::new();
    for (row, signs) in ROWS {
        for (column, u_against_z, is_a) in COLUMNS {
            let shortest = if is_a { adjacent } else { opposite };
            let occurs = found
                .iter()
                .filter(|one| (one.shortest, one.longest) == (shortest, 1))
                .filter(|one| one.u_against_z == u_against_z)
                .map(|one| one.signs[0] == signs);
            cells.push(cell(["", row, column], occurs, ["+", "-"]));
        }
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wrong_variants_have_other_cells() {
        for table in [TANGENTS, CASES] {
            let cells = (table.run)().unwrap();
            assert_eq!(cells.wrong_variant, Truth::No, "{}", table.name);
            assert!(cells.instances >= 18 * INSTANCES, "{}", table.name);
        }
    }

    #[test]
    fn every_cell_is_one_thing_always() {
        for table in [TANGENTS, CASES] {
            for cell in (table.run)().unwrap().cells {
                assert!(!cell.text.contains("sometimes"), "{cell:?}");
            }
        }
    }
}
