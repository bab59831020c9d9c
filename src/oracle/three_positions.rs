//! `three-positions`: circlepoint to center and back.

use rug::Rational;
use serde_json::{Map, Value, json};

use super::input::Fields;
use super::numeral::Shown;
use super::poles;
use super::positions::{Given, Task, point};
use super::sharpen::Attempt;
use super::{ProblemError, Request};
use crate::finite::positions::Positions;
use crate::finite::three_positions::{center, centers_of_lines, circlepoint, points_on_lines};
use crate::plane::Point;
use crate::plane::circle::Circle;
use crate::plane::displacement::Displacement;
use crate::plane::projective::ProjectivePoint;

/// Reads and solves the problem.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    fields.only(&["positions", "circlepoints", "centers"])?;
    let task = ThreePositions {
        circlepoints: fields.optional_points("circlepoints")?,
        centers: fields.optional_points("centers")?,
    };
    Ok(Given::read(fields, 3, 3)?.solve(&task, request))
}

struct ThreePositions {
    circlepoints: Vec<[Rational; 2]>,
    centers: Vec<[Rational; 2]>,
}

impl Task for ThreePositions {
    fn answer<K: Shown>(
        &self,
        positions: &Positions<K>,
        _: &K::Precision,
        attempt: &mut Attempt,
    ) -> Map<String, Value> {
        let mut answer = poles::both(positions, attempt);
        if let Some(three) = positions.displacements().first_chunk::<3>() {
            let circles = [
                ("centers_of_lines", centers_of_lines(three)),
                ("points_on_lines", points_on_lines(three)),
            ];
            for (name, circle) in circles {
                answer.insert(name.into(), circle_fields(name, &circle, attempt));
            }
        }
        let displacements = positions.displacements();
        let mut pairs = Vec::new();
        for given in self.circlepoints.iter().map(point) {
            let center = center(displacements, &given);
            pairs.push(pair(displacements, &finite(&given), &center, attempt));
        }
        for given in self.centers.iter().map(point) {
            let circlepoint = circlepoint(displacements, &given);
            pairs.push(pair(displacements, &circlepoint, &finite(&given), attempt));
        }
        answer.insert("pairs".into(), json!(pairs));
        answer
    }
}

fn finite<K: Shown>(point: &Point<K>) -> ProjectivePoint<K> {
    ProjectivePoint::from_finite(point)
}

fn pair<K: Shown>(
    positions: &[Displacement<K>],
    circlepoint: &ProjectivePoint<K>,
    center: &ProjectivePoint<K>,
    attempt: &mut Attempt,
) -> Value {
    let radius = match (circlepoint.finite(), center.finite(), positions.first()) {
        (Some(point), Some(center), Some(first)) => {
            let square = K::numeral(&(first.of(&point) - center).norm());
            let bits = attempt.bits;
            attempt.numeral("pairs.radius", &square.sqrt(bits))
        }
        _ => Value::Null,
    };
    json!({
        "circlepoint": attempt.point("pairs.circlepoint", circlepoint),
        "center": attempt.point("pairs.center", center),
        "radius": radius,
    })
}

/// A circle by its equation a (x² + y²) + b x + c y + d = 0, center and radius; null where every point
/// satisfies the equation.
fn circle_fields<K: Shown>(name: &str, circle: &Circle<K>, attempt: &mut Attempt) -> Value {
    if circle.is_determined().is_no() {
        return Value::Null;
    }
    let Circle { a, b, c, d } = circle;
    let coefficients = [a.clone(), b.clone(), c.clone(), d.clone()];
    let coefficients = attempt.coefficients(&format!("{name}.coefficients"), &coefficients);
    let (center, radius) = if circle.is_line().is_yes() {
        (Value::Null, Value::Null)
    } else {
        let bits = attempt.bits;
        let radius = K::numeral(&circle.squared_radius()).sqrt(bits);
        (
            attempt.finite_point(&format!("{name}.center"), &circle.center()),
            attempt.numeral(&format!("{name}.radius"), &radius),
        )
    };
    json!({"coefficients": coefficients, "center": center, "radius": radius})
}
