//! Hart's straight-line mechanism: one position, the straight line, the path of the middle of PF.

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::complex::{Z, point, z};
use super::number;
use super::skeleton::{Posture, Skeleton, easiest, round_trip};
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

    fn sweep(&self, upwards: bool) -> Vec<Option<Posture>> {
        let reach = self.m.abs() + self.p.abs();
        let highest = (reach * reach - self.x * self.x).max(0.0).sqrt();
        (0..=800)
            .map(|step| {
                let part = (f64::from(step) / 400.0 - 1.0) * std::f64::consts::FRAC_PI_2;
                let position = self.position(highest * part.sin(), upwards);
                position.map(|position| self.posture(&position))
            })
            .collect()
    }

    /// All joints, in the order of the skeleton.
    fn posture(&self, position: &Position) -> Posture {
        let Position { f, p, q, a, b } = position;
        let mut joints = vec![[0.0, 0.0], [self.d, 0.0]];
        joints.extend([a, b, p, q, f].map(point));
        joints
    }
}

const SKELETON: Skeleton = Skeleton {
    joints: &[
        (Joint::Fixed, "M"),
        (Joint::Fixed, "N"),
        (Joint::Moving, "A"),
        (Joint::Moving, "B"),
        (Joint::Moving, "P"),
        (Joint::Moving, "Q"),
        (Joint::Moving, "F"),
    ],
    bars: &[
        (0, 1, Stroke::Base),
        (0, 2, Stroke::Bar),
        (0, P, Stroke::Bar),
        (1, 3, Stroke::Bar),
        (1, 5, Stroke::Bar),
        (2, 3, Stroke::Bar),
        (P, F, Stroke::Bar),
        (5, F, Stroke::Bar),
    ],
};
const P: usize = 4;
const F: usize = 6;

/// The picture; `None` where the mechanism cannot be assembled.
pub fn picture(answer: &Value) -> Option<String> {
    let sweep = sweep(answer)?;
    let shown = easiest(&sweep)?.clone();
    let mut canvas = Canvas::new(
        "Hart's straight-line mechanism",
        "The four-bar MABN with bars PF and QF from its rockers to F, in one position; F moves on a \
         straight line at right angles to the base MN, and the middle of PF on the curve that is \
         shown, an ellipse where MP = PF and the line passes through M.",
    );
    draw_paths(&mut canvas, &sweep);
    SKELETON.draw(&mut canvas, &[shown]);
    explain(&mut canvas);
    Some(canvas.to_svg())
}

/// The same mechanism, which goes through all of its positions when it is told to.
pub fn moving_picture(answer: &Value) -> Option<String> {
    let sweep = sweep(answer)?;
    let mut canvas = Canvas::new(
        "Hart's straight-line mechanism",
        "The four-bar MABN with bars PF and QF from its rockers to F; F moves on a straight line at right \
         angles to the base MN, and the middle of PF on the curve that is shown. The mechanism can be set \
         in motion: F goes along the whole line and back, and all bars keep their lengths.",
    );
    draw_paths(&mut canvas, &sweep);
    SKELETON.draw(&mut canvas, &round_trip(&sweep));
    explain(&mut canvas);
    Some(canvas.to_svg())
}

/// All positions, by the two assemblies of MPF.
fn sweep(answer: &Value) -> Option<[Vec<Option<Posture>>; 2]> {
    let mechanism = Mechanism::read(answer)?;
    Some([true, false].map(|upwards| mechanism.sweep(upwards)))
}

fn draw_paths(canvas: &mut Canvas, sweep: &[Vec<Option<Posture>>]) {
    let gap = [f64::NAN; 2];
    for row in sweep {
        let path = |of: fn(Point, Point) -> Point| {
            row.iter().map(move |posture| {
                let joints = posture.as_ref();
                let ends = joints.and_then(|joints| Some((joints.get(P)?, joints.get(F)?)));
                ends.map_or(gap, |(p, f)| of(*p, *f))
            })
        };
        canvas.line(path(|_, f| f), Stroke::MainPath);
        let middle = |p: Point, f: Point| [(p[0] + f[0]) / 2.0, (p[1] + f[1]) / 2.0];
        canvas.line(path(middle), Stroke::Path);
    }
}

fn explain(canvas: &mut Canvas) {
    canvas.scale("units of the lengths");
    canvas.explain(Stroke::Bar, "bars of the mechanism");
    canvas.explain(Stroke::MainPath, "straight line of F");
    canvas.explain(Stroke::Path, "path of the middle of PF");
}
