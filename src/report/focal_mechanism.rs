//! The focal mechanism with the fastest crank that the answer has: one position, the paths, the cubic.

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke, spread};
use super::complex::{Z, point, z};
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

    fn sweep(&self, upwards: bool) -> Vec<Option<Position>> {
        (0..=720)
            .map(|step| self.position(f64::from(step) * std::f64::consts::PI / 360.0, upwards))
            .collect()
    }
}

/// The picture; `None` where no mechanism is real.
pub fn picture(problem: &Value, answer: &Value) -> Option<String> {
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
    let sweep: Vec<_> = assemblies
        .iter()
        .map(|upwards| mechanism.sweep(*upwards))
        .collect();
    let shown = sweep
        .iter()
        .flatten()
        .flatten()
        .max_by(|x, y| ease(&mechanism, x).total_cmp(&ease(&mechanism, y)))?;
    Some(draw(&mechanism, &sweep, shown))
}

/// How far apart the joints are in a position.
fn ease(mechanism: &Mechanism, position: &Position) -> f64 {
    let fixed = [[0.0, 0.0], [mechanism.d, 0.0], [mechanism.s, 0.0]];
    let Position { f, p, q, a, b, t } = position;
    let moving = [f, p, q, a, b, t].map(point);
    spread(&[&fixed[..], &moving[..]].concat())
}

fn draw(mechanism: &Mechanism, sweep: &[Vec<Option<Position>>], shown: &Position) -> String {
    let mut canvas = Canvas::new(
        "Focal mechanism: a four-bar MABN driven by a crank SF",
        "The four-bar MABN with the points P, Q, S, T on its sides joined to F, in one position; the \
         path of the point T of the coupler, the circle of F about S, and the focal cubic of the \
         quadrilateral MABN in this position, which passes through F.",
    );
    let (m, n, s) = (z(0.0, 0.0), z(mechanism.d, 0.0), z(mechanism.s, 0.0));
    for half in sweep {
        let path = |of: fn(&Position) -> &Z| {
            half.iter().map(move |position| {
                position
                    .as_ref()
                    .map_or([f64::NAN; 2], |position| point(of(position)))
            })
        };
        canvas.line(path(|position| &position.t), Stroke::MainPath);
        canvas.line(path(|position| &position.f), Stroke::Path);
    }
    for joint in [&m, &n, &shown.a, &shown.b] {
        canvas.show(point(joint));
    }
    let cubic = focal_cubic(&n, &shown.a, &shown.b);
    for piece in contour::zero_set(cubic, canvas.window()) {
        canvas.background(piece.to_vec(), Stroke::Curve);
    }
    let bars = [
        ([&m, &n], Stroke::Base),
        ([&m, &shown.a], Stroke::Bar),
        ([&n, &shown.b], Stroke::Bar),
        ([&shown.a, &shown.b], Stroke::Bar),
        ([&shown.p, &shown.f], Stroke::Bar),
        ([&shown.q, &shown.f], Stroke::Bar),
        ([&shown.t, &shown.f], Stroke::Bar),
        ([&s, &shown.f], Stroke::Crank),
    ];
    for (ends, stroke) in bars {
        canvas.line(ends.map(point), stroke);
    }
    for (at, joint, name) in [
        (&m, Joint::Fixed, "M"),
        (&n, Joint::Fixed, "N"),
        (&s, Joint::Fixed, "S"),
        (&shown.a, Joint::Moving, "A"),
        (&shown.b, Joint::Moving, "B"),
        (&shown.p, Joint::Moving, "P"),
        (&shown.q, Joint::Moving, "Q"),
        (&shown.t, Joint::Moving, "T"),
        (&shown.f, Joint::Moving, "F"),
    ] {
        canvas.joint(point(at), joint, name);
    }
    canvas.explain(Stroke::Crank, "crank SF");
    canvas.explain(Stroke::Bar, "bars of the mechanism");
    canvas.explain(Stroke::MainPath, "path of the coupler point T");
    canvas.explain(Stroke::Path, "path of F, a circle about S");
    canvas.explain(Stroke::Curve, "focal cubic of MABN in this position");
    canvas.to_svg()
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
