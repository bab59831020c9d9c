//! Hart's straight-line mechanism: one position, the straight line, the path of the middle of PF.

use serde_json::Value;

use super::canvas::{Canvas, Joint, Stroke, spread};
use super::complex::{Z, point, z};
use super::number;
use crate::number::Number;

/// The lengths, and the abscissa of the line.
struct Mechanism {
    m: f64,
    n: f64,
    p: f64,
    q: f64,
    a: f64,
    b: f64,
    d: f64,
    x: f64,
}

/// The joints in one position.
struct Position {
    f: Z,
    p: Z,
    q: Z,
    a: Z,
    b: Z,
}

impl Mechanism {
    fn read(answer: &Value) -> Option<Self> {
        let of = |name: &str| number(answer.get(name)?);
        Some(Mechanism {
            m: of("m")?,
            n: of("n")?,
            p: of("p")?,
            q: of("q")?,
            a: of("a")?,
            b: of("b")?,
            d: of("d")?,
            x: of("x")?,
        })
    }

    /// The position with F at this height on its line; `None` where the bars do not reach it.
    fn position(&self, y: f64, upwards: bool) -> Option<Position> {
        let f = z(self.x, y);
        let cos = (self.m * self.m + self.p * self.p - f.norm().0) / (2.0 * self.m * self.p);
        if cos.abs() > 1.0 + 1e-9 {
            return None;
        }
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let w = z(cos, if upwards { sin } else { -sin });
        let u = &f / (z(self.m, 0.0) - w.scaled(&Number(self.p)));
        let base = z(self.d, 0.0);
        let v = (&f - &base) / (z(self.n, 0.0) + w.scaled(&Number(self.q)));
        let position = Position {
            p: u.scaled(&Number(self.m)),
            q: &base + v.scaled(&Number(self.n)),
            a: u.scaled(&Number(self.a)),
            b: &base + v.scaled(&Number(self.b)),
            f,
        };
        // F in M leaves the direction of MP open.
        (u.norm().0 - 1.0).abs().lt(&1e-6).then_some(position)
    }

    fn sweep(&self, upwards: bool) -> Vec<Option<Position>> {
        let reach = self.m.abs() + self.p.abs();
        let highest = (reach * reach - self.x * self.x).max(0.0).sqrt();
        (0..=800)
            .map(|step| {
                let part = (f64::from(step) / 400.0 - 1.0) * std::f64::consts::FRAC_PI_2;
                self.position(highest * part.sin(), upwards)
            })
            .collect()
    }
}

/// How far apart the joints are in a position.
fn ease(mechanism: &Mechanism, position: &Position) -> f64 {
    let fixed = [[0.0, 0.0], [mechanism.d, 0.0]];
    let Position { f, p, q, a, b } = position;
    let moving = [f, p, q, a, b].map(point);
    spread(&[&fixed[..], &moving[..]].concat())
}

/// The picture; `None` where the mechanism cannot be assembled.
pub fn picture(answer: &Value) -> Option<String> {
    let mechanism = Mechanism::read(answer)?;
    let sweep = [true, false].map(|upwards| mechanism.sweep(upwards));
    let shown = sweep
        .iter()
        .flatten()
        .flatten()
        .max_by(|x, y| ease(&mechanism, x).total_cmp(&ease(&mechanism, y)))?;
    let mut canvas = Canvas::new(
        "Hart's straight-line mechanism",
        "The four-bar MABN with bars PF and QF from its rockers to F, in one position; F moves on a \
         straight line at right angles to the base MN, and the middle of PF on the curve that is \
         shown, an ellipse where MP = PF and the line passes through M.",
    );
    for half in &sweep {
        let path = |of: fn(&Position) -> Z| {
            half.iter().map(move |position| {
                position
                    .as_ref()
                    .map_or([f64::NAN; 2], |position| point(&of(position)))
            })
        };
        canvas.line(path(|position| position.f.clone()), Stroke::MainPath);
        canvas.line(
            path(|position| (&position.p + &position.f) / 2),
            Stroke::Path,
        );
    }
    let (m, n) = (z(0.0, 0.0), z(mechanism.d, 0.0));
    for (ends, stroke) in [
        ([&m, &n], Stroke::Base),
        ([&m, &shown.a], Stroke::Bar),
        ([&m, &shown.p], Stroke::Bar),
        ([&n, &shown.b], Stroke::Bar),
        ([&n, &shown.q], Stroke::Bar),
        ([&shown.a, &shown.b], Stroke::Bar),
        ([&shown.p, &shown.f], Stroke::Bar),
        ([&shown.q, &shown.f], Stroke::Bar),
    ] {
        canvas.line(ends.map(point), stroke);
    }
    for (at, joint, name) in [
        (&m, Joint::Fixed, "M"),
        (&n, Joint::Fixed, "N"),
        (&shown.a, Joint::Moving, "A"),
        (&shown.b, Joint::Moving, "B"),
        (&shown.p, Joint::Moving, "P"),
        (&shown.q, Joint::Moving, "Q"),
        (&shown.f, Joint::Moving, "F"),
    ] {
        canvas.joint(point(at), joint, name);
    }
    canvas.explain(Stroke::Bar, "bars of the mechanism");
    canvas.explain(Stroke::MainPath, "straight line of F");
    canvas.explain(Stroke::Path, "path of the middle of PF");
    Some(canvas.to_svg())
}
