//! Problems about one mechanism: Hart's, focal mechanisms, slider-cranks, any linkage in one position.

use rug::Rational;
use serde_json::{Value, json};

use super::Problem;
use super::draw::Draw;
use super::pose;
use crate::number::Exact;
use crate::plane::Point;

pub fn hart(draw: &mut Draw) -> Vec<Problem> {
    let mut problems = Vec::new();
    while problems.len() < 80 {
        let kappa = draw.number();
        if kappa.is_zero() || Rational::from(kappa.square_ref()) == 1 {
            continue;
        }
        let [m, n, d] = [draw.length(), draw.length(), draw.length()];
        let kind = if kappa.cmp0().is_gt() {
            "positive ratio"
        } else {
            "negative ratio"
        };
        let input = json!({
            "problem": "hart",
            "m": m.to_string(),
            "n": n.to_string(),
            "d": d.to_string(),
            "kappa": kappa.to_string(),
        });
        problems.push(Problem::new(kind, &[], input));
    }
    problems
}

pub fn focal(draw: &mut Draw) -> Vec<Problem> {
    let mut problems = Vec::new();
    while problems.len() < 120 {
        let rho = draw.number();
        if rho.is_zero() || rho == -1 {
            continue;
        }
        let [mut a, b, c, mut d] = [draw.length(), draw.length(), draw.length(), draw.length()];
        let (kind, flags): (&str, &[&'static str]) = match problems.len() % 6 {
            4 => {
                a.clone_from(&b);
                ("equal links", &["equal-coordinates"])
            }
            5 => {
                // a + b = c + d: all in one line.
                d = Rational::from(&a + &b) - &c;
                if d.cmp0().is_le() {
                    continue;
                }
                ("change-point four-bar", &["degenerate"])
            }
            _ => ("any four-bar", &[]),
        };
        let input = json!({
            "problem": "focal-mechanism",
            "a": a.to_string(),
            "b": b.to_string(),
            "c": c.to_string(),
            "d": d.to_string(),
            "rho": rho.to_string(),
        });
        problems.push(Problem::new(kind, flags, input));
    }
    problems
}

fn ray(draw: &mut Draw, round: usize) -> Value {
    match round % 3 {
        0 => json!({"tan_half": draw.half().to_string()}),
        1 => json!({"degrees": draw.positive(179).to_string()}),
        _ => json!({"degrees": (draw.positive(11) * 15).to_string()}),
    }
}

#[expect(clippy::indexing_slicing, reason = "a place modulo the length")]
pub fn slider_cranks(draw: &mut Draw) -> Vec<Problem> {
    let mut problems = Vec::new();
    for round in 0..160 {
        let (alpha_a, alpha_d) = (ray(draw, round), ray(draw, round / 3));
        let special = ["-1", "1", "0", "-3", "-4", "2"];
        let (k, kind) = if round % 5 == 4 {
            let k = special[(round / 5) % special.len()];
            (k.to_owned(), format!("k = {k}"))
        } else {
            (draw.number().to_string(), "any ratio".to_owned())
        };
        let flags: &[&'static str] = if round % 5 == 4 { &["degenerate"] } else { &[] };
        let input = json!({
            "problem": "slider-crank-alternates",
            "k": k,
            "alpha_a": alpha_a,
            "alpha_d": alpha_d,
        });
        problems.push(Problem::new(kind, flags, input));
    }
    problems
}

/// Linkages in one position.
#[expect(clippy::indexing_slicing, reason = "a place modulo the length")]
pub fn curvature(draw: &mut Draw) -> Vec<Problem> {
    let mut problems = Vec::new();
    while problems.len() < 120 {
        let [a, b, p, q] = [draw.point(), draw.point(), draw.point(), draw.point()];
        let kinds: [(&str, &[&str]); 4] = [
            ("four-bar", &[]),
            ("slider-crank", &["pair-at-infinity"]),
            ("turning block", &["pair-at-infinity"]),
            ("parallel cranks", &["pole-at-infinity"]),
        ];
        let (kind, flags) = kinds[problems.len() % kinds.len()];
        let infinite = |z: &Point<Exact>| json!({"at_infinity": pose::point(z)});
        let finite = pose::point;
        // The links lie on lines through one of their ends in these directions, which must meet in one
        // point: the pole.
        let along = [&a - &p, &b - &q];
        let (second, directions) = match kind {
            "slider-crank" => ([finite(&b), infinite(&q)], [along[0].clone(), q.clone()]),
            "turning block" => ([infinite(&b), finite(&q)], [along[0].clone(), b.clone()]),
            "parallel cranks" => {
                let b = &q + along[0].scaled(&(draw.positive(3) + 1).into());
                let base = &q - &p;
                ([finite(&b), finite(&q)], [along[0].clone(), base])
            }
            _ => ([finite(&b), finite(&q)], along),
        };
        let [d, e] = &directions;
        if (d.conj() * e).im().is_zero().is_yes() {
            continue;
        }
        let [circlepoint, center] = second;
        let input = json!({
            "problem": "curvature",
            "links": [
                {"circlepoint": finite(&a), "center": finite(&p)},
                {"circlepoint": circlepoint, "center": center},
            ],
        });
        problems.push(Problem::new(kind, flags, input));
    }
    problems
}
