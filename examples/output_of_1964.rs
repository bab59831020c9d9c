//! The table that the Burroughs 220 printed in 1964, over the curves as they are.
//!
//! Writes the picture to standard output:
//! `cargo run --release --example output_of_1964 > docs/pictures/output-of-1964.svg`.

use std::error::Error;

use burmester::ledger::{Printed, Statement, built_in};
use burmester::oracle::{Request, solve};
use burmester::report::{Points, deviation_with_points};
use serde_json::json;

/// Prints the picture.
///
/// # Errors
/// None for the data that come with the library.
pub fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", picture()?);
    Ok(())
}

/// The representative linkage of the thesis, its deviation, and the printed rows.
///
/// # Errors
/// None for the data that come with the library.
pub fn picture() -> Result<String, Box<dyn Error>> {
    let problem = json!({
        "problem": "deviation",
        "design": {
            "kind": "ball-double-burmester",
            "alpha_a": {"degrees": "65"},
            "alpha_b": {"degrees": "165"},
        },
        "levels": ["0.0001", "0.01", "0.05"],
    });
    let answer = solve(&problem, &Request::default())?;
    deviation_with_points(&answer, &printed_rows()?).ok_or_else(|| "nothing to draw".into())
}

/// The rows of the table; its column LOCATION has the travel with the opposite sign.
fn printed_rows() -> Result<Points, Box<dyn Error>> {
    let papers = built_in()?;
    let cells: Vec<&Statement> = papers
        .iter()
        .flat_map(|paper| &paper.statements)
        .filter(|statement| statement.id.starts_with("tesar1964/table/"))
        .collect();
    let mut points = Points {
        name: "the rows that the machine printed in 1964".to_owned(),
        ..Points::default()
    };
    for row in cells.chunks(4) {
        let [location, deviation, _, acceleration] = row else {
            return Err("a row of four cells was expected".into());
        };
        let u = -value(location)?;
        points.deviation.push([u, value(deviation)?]);
        points.second.push([u, value(acceleration)?]);
    }
    Ok(points)
}

fn value(cell: &Statement) -> Result<f64, Box<dyn Error>> {
    Ok(Printed::read(&cell.printed)?.value.to_f64())
}
