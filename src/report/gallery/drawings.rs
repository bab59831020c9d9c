//! Pictures that no problem asks for, by their names.

use serde_json::Value;

use super::{compatibility_triangle, conformal_sketch, opposite_sides, twelve_points};

/// The drawing of this name, of a problem with its answer where it needs one.
pub fn svg(name: &str, solved: Option<(&Value, &Value)>) -> Option<String> {
    match (name, solved) {
        ("nomograph", _) => {
            Some(include_str!("../../../data/charts/ball-double-burmester.svg").to_owned())
        }
        ("output-of-1964", _) => {
            Some(include_str!("../../../docs/pictures/output-of-1964.svg").to_owned())
        }
        ("focus-by-circles", Some((problem, answer))) => opposite_sides::focus(problem, answer),
        ("equal-angles", Some((problem, answer))) => opposite_sides::equal_angles(problem, answer),
        ("conformal-sketch", Some((_, answer))) => conformal_sketch::svg(answer),
        ("twelve-points", Some((_, answer))) => twelve_points::svg(answer),
        ("compatibility-triangle", Some((problem, answer))) => {
            compatibility_triangle::triangle(problem, answer)
        }
        ("sweeps", Some((problem, answer))) => compatibility_triangle::sweeps(problem, answer),
        _ => None,
    }
}
