//! The focal mechanism with the fastest crank that the answer has: one position, the paths, the cubic.

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::complex::{Z, point, z};
use super::skeleton::{Posture, Skeleton, easiest, round_trip};
use super::{contour, number};
use crate::number::Number;

/// A mechanism in numbers.
struct Mechanism {
    a: f64,
    b: f64,
    d: f64,
    m: f64,
    n: f64,
    p: f64,
    q: f64,
    s: f64,
    r: f64,
    share: f64,
}

/// All joints in one position.
struct Position {
    f: Z,
    p: Z,
    q: Z,
    a: Z,
    b: Z,
    t: Z,
}

impl Mechanism {
    fn read(problem: &Value, mechanism: &Value) -> Option<Self> {
        let side = |name: &str| number(problem.get(name)?);
        let of = |name: &str| number(mechanism.get(name)?);
        let (d, s) = (side("d")?, of("MS")?);
        Some(Mechanism {
            a: side("a")?,
            b: side("b")?,
            d,
            m: of("m")?,
            n: of("n")?,
            p: of("p")?,
            q: of("q")?,
            s,
            r: of("r")?,
            share: s / d,
        })
    }

    /// The position of a crank angle; `None` where the triangle MPF does not close.
    fn position(&self, sigma: f64, upwards: bool) -> Option<Position> {
        let f = z(self.s + self.r * sigma.cos(), self.r * sigma.sin());
        let cos = (self.m * self.m + self.p * self.p - f.norm().0) / (2.0 * self.m * self.p);
        if cos.abs() > 1.0 + 1e-9 {
            return None;
        }
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let w = z(cos, if upwards { sin } else { -sin });
        let u = &f / (z(self.m, 0.0) - w.scaled(&Number(self.p)));
        let base = z(self.d, 0.0);
        let v = (&f - &base) / (z(self.n, 0.0) + w.scaled(&Number(self.q)));
        let a = u.scaled(&Number(self.a));
        let b = &base + v.scaled(&Number(self.b));
        Some(Position {
            p: u.scaled(&Number(self.m)),
            q: &base + v.scaled(&Number(self.n)),
            t: &a + (&b - &a).scaled(&Number(self.share)),
            f,
            a,
            b,
        })
    }

    fn sweep(&self, upwards: bool) -> Vec<Option<Posture>> {
        (0..=720)
            .map(|step| {
                let position =
                    self.position(f64::from(step) * std::f64::consts::PI / 360.0, upwards);
                position.map(|position| self.posture(&position))
            })
            .collect()
    }

    /// All joints, in the order of the skeleton.
    fn posture(&self, position: &Position) -> Posture {
        let Position { f, p, q, a, b, t } = position;
        let mut joints = vec![[0.0, 0.0], [self.d, 0.0], [self.s, 0.0]];
        joints.extend([a, b, p, q, t, f].map(point));
        joints
    }
}

const SKELETON: Skeleton = Skeleton {
    joints: &[
        (Joint::Fixed, "M"),
        (Joint::Fixed, "N"),
        (Joint::Fixed, "S"),
        (Joint::Moving, "A"),
        (Joint::Moving, "B"),
        (Joint::Moving, "P"),
        (Joint::Moving, "Q"),
        (Joint::Moving, "T"),
        (Joint::Moving, "F"),
    ],
    bars: &[
        (0, 1, Stroke::Base),
        (0, 3, Stroke::Bar),
        (0, 5, Stroke::Bar),
        (1, 4, Stroke::Bar),
        (1, 6, Stroke::Bar),
        (3, 4, Stroke::Bar),
        (3, T, Stroke::Bar),
        (5, F, Stroke::Bar),
        (6, F, Stroke::Bar),
        (T, F, Stroke::Bar),
        (2, F, Stroke::Crank),
    ],
};
const T: usize = 7;
const F: usize = 8;

/// The picture; `None` where no mechanism is real.
pub fn picture(problem: &Value, answer: &Value) -> Option<String> {
    let sweep = chosen(problem, answer)?;
    let shown = easiest(&sweep)?.clone();
    let mut canvas = Canvas::new(
        "Focal mechanism: a four-bar MABN driven by a crank SF",
        "The four-bar MABN with the points P, Q, S, T on its sides joined to F, in one position; the \
         path of the point T of the coupler, the circle of F about S, and the focal cubic of the \
         quadrilateral MABN in this position, which passes through F.",
    );
    draw_paths(&mut canvas, &sweep);
    for joint in shown.iter().take(5) {
        canvas.show(*joint);
    }
    if let [_, n, _, a, b, ..] = shown.as_slice() {
        let [n, a, b] = [n, a, b].map(|[x, y]| z(*x, *y));
        for piece in contour::zero_set(focal_cubic(&n, &a, &b), canvas.window()) {
            canvas.background(piece.to_vec(), Stroke::Curve);
        }
    }
    SKELETON.draw(&mut canvas, &[shown]);
    explain(&mut canvas);
    canvas.explain(Stroke::Curve, "focal cubic of MABN in this position");
    Some(canvas.to_svg())
}

/// The same mechanism, which goes through all of its positions when it is told to.
pub fn moving_picture(problem: &Value, answer: &Value) -> Option<String> {
    let sweep = chosen(problem, answer)?;
    let mut canvas = Canvas::new(
        "Focal mechanism: a four-bar MABN driven by a crank SF",
        "The four-bar MABN with the points P, Q, S, T on its sides joined to F, the path of the point T \
         of the coupler, and the circle of F about S. The mechanism can be set in motion: the crank turns, \
         or rocks where it cannot turn, and all bars keep their lengths.",
    );
    draw_paths(&mut canvas, &sweep);
    SKELETON.draw(&mut canvas, &round_trip(&sweep));
    explain(&mut canvas);
    Some(canvas.to_svg())
}

/// All positions of the mechanism that is shown, by its assemblies.
fn chosen(problem: &Value, answer: &Value) -> Option<Vec<Vec<Option<Posture>>>> {
    let list = answer.get("mechanisms")?.as_array()?;
    let turning = list
        .iter()
        .find(|one| one.get("crank").and_then(Value::as_str) == Some("turns"));
    let chosen = turning.or(list.first())?;
    let mechanism = Mechanism::read(problem, chosen)?;
    // A crank that turns stays in one assembly; one that rocks passes from one into the other.
    let assemblies: &[bool] = if turning.is_some() {
        &[true]
    } else {
        &[true, false]
    };
    let rows = assemblies.iter();
    Some(rows.map(|upwards| mechanism.sweep(*upwards)).collect())
}

fn draw_paths(canvas: &mut Canvas, sweep: &[Vec<Option<Posture>>]) {
    for row in sweep {
        for (joint, stroke) in [(T, Stroke::MainPath), (F, Stroke::Path)] {
            let at = |posture: &Option<Posture>| {
                let place = posture.as_ref().and_then(|posture| posture.get(joint));
                place.copied().unwrap_or([f64::NAN; 2])
            };
            canvas.line(row.iter().map(at), stroke);
        }
    }
}

fn explain(canvas: &mut Canvas) {
    canvas.scale("units of the lengths");
    canvas.explain(Stroke::Crank, "crank SF");
    canvas.explain(Stroke::Bar, "bars of the mechanism");
    canvas.explain(Stroke::MainPath, "path of the coupler point T");
    canvas.explain(Stroke::Path, "path of F, a circle about S");
}

/// F lies on it where opposite sides of MABN are seen under angles whose sum is a multiple of π.
fn focal_cubic(n: &Z, a: &Z, b: &Z) -> impl Fn(Point) -> f64 {
    let (n, a, b) = (n.clone(), a.clone(), b.clone());
    move |[x, y]| {
        let f = z(x, y);
        let product = &f * (&f - &n).conj() * (&f - &a).conj() * (&f - &b);
        product.im().0
    }
}
