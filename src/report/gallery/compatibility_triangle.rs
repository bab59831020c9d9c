//! The triangle of three turned vectors that closes for a dyad through four positions, and the centers of
//! its two assemblies.

use std::f64::consts::PI;

use serde_json::Value;

use super::four_poles::{is_within, middle};
use crate::number::Number;
use crate::plane::displacement::Displacement;
use crate::report::canvas::{Canvas, Joint, Point, Stroke, distance, spread};
use crate::report::complex::{Z, point, z};
use crate::report::straight_line::limit;
use crate::report::{centerpoint_curve, finite_point, frames, poles};

/// Steps of a full turn.
const STEPS: u32 = 1440;

/// Δ₂(e^{iγ₂} − 1) + Δ₃(e^{iγ₃} − 1) + Δ₄(e^{iγ₄} − 1) = 0, from eliminating both links of
/// (e^{iφ_j} − 1) Z + (e^{iγ_j} − 1) W = δ_j.
struct Closure {
    start: Z,
    turns: [Z; 3],
    steps: [Z; 3],
    deltas: [Z; 3],
}

/// One assembly for one γ₂.
struct Assembly {
    /// Δ₃ and Δ₄ as they are turned.
    sides: [Z; 2],
    center: Point,
}

impl Closure {
    fn of(positions: &[Displacement<f64>]) -> Option<Self> {
        let [first, rest @ ..] = positions else {
            return None;
        };
        let rest: &[Displacement<f64>; 3] = rest.try_into().ok()?;
        let start = first.translation.clone();
        let turns = rest.each_ref().map(|p| &p.rotation * first.rotation.conj());
        let steps = rest.each_ref().map(|p| &p.translation - &start);
        let columns = |k: usize| turns.get(k).zip(steps.get(k));
        let det = |i: usize, j: usize| {
            let ((turn, step), (other_turn, other_step)) = columns(i).zip(columns(j))?;
            let one = z(1.0, 0.0);
            Some((turn - &one) * other_step - (other_turn - &one) * step)
        };
        let deltas = [-det(1, 2)?, det(0, 2)?, -det(0, 1)?];
        Some(Closure {
            start,
            turns,
            steps,
            deltas,
        })
    }

    /// Δ, the base of the triangle.
    fn base(&self, gamma: f64) -> Z {
        let [second, third, fourth] = &self.deltas;
        third + fourth + second * (z(1.0, 0.0) - turn(gamma))
    }

    /// Both assemblies for this γ₂; `None` where the triangle does not close.
    fn assemblies(&self, gamma: f64) -> Option<[Assembly; 2]> {
        let base = self.base(gamma);
        let [_, third, fourth] = &self.deltas;
        let [b, c, d] = [&base, third, fourth].map(size);
        let cos = (b * b + c * c - d * d) / (2.0 * b * c);
        if cos.abs() > 1.0 {
            return None;
        }
        let angle = cos.acos();
        let assembly = |sign: f64| {
            let turned = base.scaled(&Number(c / b)) * turn(sign * angle);
            let gamma_3 = &turned / third;
            let center = self.center([turn(gamma), gamma_3]);
            Assembly {
                sides: [turned.clone(), &base - turned],
                center,
            }
        };
        Some([assembly(-1.0), assembly(1.0)])
    }

    /// Adds both centers to their rows, or a gap; beyond a gap too where they jump by a part of the reach.
    fn add(&self, gamma: f64, reach: f64, rows: &mut [Vec<Point>; 2]) {
        let gap = [f64::NAN; 2];
        let both = self.assemblies(gamma);
        let centers = both.map_or([gap; 2], |both| both.map(|assembly| assembly.center));
        for (at, row) in centers.into_iter().zip(rows) {
            let jumps = |last: &Point| distance(*last, at) > reach / 3.0;
            if row.last().is_some_and(jumps) {
                row.push(gap);
            }
            row.push(at);
        }
    }

    /// The last angle at which the triangle closes, between one at which it does and one at which not.
    fn limit(&self, [from, to]: [f64; 2]) -> Option<f64> {
        let closes = |gamma: f64| self.assemblies(gamma).is_some();
        (closes(from) != closes(to)).then(|| limit(closes, from, to))
    }

    /// M = r₁ − Z₁ − W₁, by Cramer's rule from the positions 2 and 3.
    fn center(&self, cranks: [Z; 2]) -> Point {
        let one = z(1.0, 0.0);
        let [a, b] = [&self.turns[0] - &one, &self.turns[1] - &one];
        let [c, d] = cranks.map(|crank| crank - &one);
        let [p, q] = [&self.steps[0], &self.steps[1]];
        let det = &a * &d - &b * &c;
        let coupler = (p * &d - q * &c) / &det;
        let crank = (a * q - b * p) / det;
        point(&(&self.start - coupler - crank))
    }
}

fn turn(angle: f64) -> Z {
    let (sin, cos) = angle.sin_cos();
    z(cos, sin)
}

fn size(z: &Z) -> f64 {
    z.norm().0.sqrt()
}

/// The triangle in both assemblies beside the curve with the two centers that it gives.
pub fn triangle(problem: &Value, answer: &Value) -> Option<String> {
    let closure = Closure::of(&frames::positions(problem)?)?;
    let mut canvas = centerpoint_curve::canvas(problem, answer)?;
    let window = canvas.window();
    let known: Vec<Point> = poles::finite(answer.get("poles")?)
        .into_iter()
        .map(|(_, at)| at)
        .collect();
    let found = (1..72).filter_map(|step| {
        let gamma = PI * f64::from(step) / 36.0;
        let both = closure.assemblies(gamma)?;
        let centers = both.each_ref().map(|one| one.center);
        let is_near = centers.iter().all(|at| is_within(*at, window));
        let flatness = (&both[0].sides[0] * both[0].sides[1].conj()).im().0.abs()
            / closure.base(gamma).norm().0;
        let room = spread(&[&known[..], &centers[..]].concat()) * flatness.min(0.4);
        is_near.then_some((room, gamma, both))
    });
    let (_, gamma, both) = found.max_by(|x, y| x.0.total_cmp(&y.0))?;
    for (one, name) in both.iter().zip(["K", "K'"]) {
        canvas.joint(one.center, Joint::Fixed, name);
    }
    draw_triangle(&mut canvas, &closure.base(gamma), &both, window);
    canvas.explain(Stroke::Bar, "the triangle that gives K");
    canvas.explain(Stroke::Path, "its other assembly, which gives K'");
    canvas.remark(&format!(
        "γ₂ = {:.0}°; the triangle is drawn beside the curve, in a scale of its own",
        gamma.to_degrees()
    ));
    Some(canvas.to_svg())
}

/// To the right of the window, as high as a part of it.
fn draw_triangle(canvas: &mut Canvas, base: &Z, both: &[Assembly; 2], (low, high): (Point, Point)) {
    let width = 0.55 * (high[0] - low[0]).min(high[1] - low[1]);
    // The base is drawn level.
    let scale = base.conj().scaled(&Number(width / base.norm().0));
    let origin = [high[0] + 0.35 * width, (low[1] + high[1]) / 2.0];
    let place = |at: &Z| {
        let [x, y] = point(&(at * &scale));
        [origin[0] + x, origin[1] + y]
    };
    let (from, to) = (place(&z(0.0, 0.0)), place(base));
    for (one, stroke) in both.iter().zip([Stroke::Bar, Stroke::Path]) {
        let apex = place(&one.sides[0]);
        canvas.line([from, apex, to], stroke);
        canvas.joint(apex, Joint::Mark, "");
    }
    canvas.line([from, to], Stroke::Crank);
    let apex = place(&both[0].sides[0]);
    for (p, q, name) in [(from, to, "Δ"), (from, apex, "Δ_3"), (apex, to, "Δ_4")] {
        canvas.joint(middle(p, q), Joint::Name, name);
    }
    for (corner, ends, name) in [(from, [to, apex], "θ_3"), (to, [from, apex], "θ_4")] {
        let radius = 0.16 * width;
        let arc = arc(corner, ends, radius);
        if let Some(at) = arc.get(arc.len() / 2) {
            canvas.joint(*at, Joint::Name, name);
        }
        canvas.line(arc, Stroke::Construction);
        canvas.joint(corner, Joint::Mark, "");
    }
}

/// The smaller arc about a corner from one leg to the other.
fn arc(corner: Point, [from, to]: [Point; 2], radius: f64) -> Vec<Point> {
    let angle = |at: Point| (at[1] - corner[1]).atan2(at[0] - corner[0]);
    let start = angle(from);
    let mut whole = angle(to) - start;
    if whole.abs() > PI {
        whole -= 2.0 * PI * whole.signum();
    }
    let at = |step: u32| {
        let (sin, cos) = (start + whole * f64::from(step) / 24.0).sin_cos();
        [corner[0] + radius * cos, corner[1] + radius * sin]
    };
    (0..=24).map(at).collect()
}

/// What K and what K' run over for all γ₂.
pub fn sweeps(problem: &Value, answer: &Value) -> Option<String> {
    let closure = Closure::of(&frames::positions(problem)?)?;
    let mut canvas = Canvas::new(
        "The centers of both assemblies for all angles",
        "The part of the centerpoint curve on which the center of the first assembly runs while the angle \
         of the crank makes a full turn, and that of the second assembly, with the poles.",
    );
    let known = poles::finite(answer.get("poles")?);
    for (_, at) in &known {
        canvas.show(*at);
    }
    if let Some(focus) = answer
        .get("centerpoint")
        .and_then(|curve| finite_point(&curve["focus"]))
    {
        canvas.show(focus);
    }
    let window = canvas.window();
    let reach = distance(window.0, window.1);
    let mut rows = [Vec::new(), Vec::new()];
    let mut flat = Vec::new();
    let angle = |step: u32| 2.0 * PI * (f64::from(step) + 0.5) / f64::from(STEPS);
    for step in 0..=STEPS {
        let ends = [angle(step), angle(step + 1)];
        closure.add(ends[0], reach, &mut rows);
        if let Some(limit) = closure.limit(ends) {
            closure.add(limit, reach, &mut rows);
            flat.extend(closure.assemblies(limit).map(|[one, _]| one.center));
        }
    }
    let rows = rows.map(|row| centerpoint_curve::within(row, window));
    for row in &rows {
        centerpoint_curve::show_closed(&mut canvas, row);
    }
    for (row, stroke) in rows.into_iter().zip([Stroke::MainPath, Stroke::Stretch]) {
        canvas.background(row, stroke);
    }
    for (name, at) in &known {
        canvas.joint(*at, Joint::Mark, &format!("P_{name}"));
    }
    for at in flat.into_iter().filter(|at| is_within(*at, window)) {
        canvas.joint(at, Joint::Moving, "");
    }
    canvas.explain(Stroke::MainPath, "K, from the first assembly");
    canvas.explain(Stroke::Stretch, "K', from the second assembly");
    canvas.remark("circles: where the triangle is flat, and K is K'");
    canvas.scale("units of the positions");
    Some(canvas.to_svg())
}
