//! Section 7: Hart's straight-line mechanism in the case of an elliptic motion of PF.

use crate::formula::Bindings;
use crate::linkage::{five_bar::Lengths, focal_mechanism};
use crate::number::{Number, Real};
use crate::plane::{Point, relation};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/hart-kite",
    "Hart's straight-line mechanism: the center S of the circle of F is at infinity, so that \
     MP.PF and NQ.QF are opposite, with PF = kappa NQ, in which MP = PF and the straight line of F \
     passes through M. All lengths follow from n and kappa; q is negative. AB is measured in one \
     position of the mechanism.",
    build,
    [
        "n": "length NQ",
        "kappa": "the ratio PF : NQ, less than 1",
        "m": "length MP",
        "p": "length PF",
        "q": "length QF, negative since S is at infinity",
        "d": "length MN",
        "a": "length MA",
        "b": "length NB",
        "c": "length AB",
        "G": "the middle of PF, with M in the origin and N on the x-axis",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (n, kappa) = (free.length("n")?, free.part("kappa")?);
    let p = &kappa * &n;
    let m = p.clone();
    // S at infinity: in m p |F − N|² + n q |F − M|² = const the squares cancel.
    let q = -(&m * &p / &n);
    // F reaches M where ω = 0, and then N, Q and F are in line: MN = n + q.
    let d = &n + &q;
    let lengths = Lengths {
        m: m.clone(),
        p: p.clone(),
        q: q.clone(),
        n: n.clone(),
    };
    let (a, b) = focal_mechanism::arms(&lengths);
    let (c, g) = coupler(&lengths, &a, &b, &d, free)?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("G", g);
    let values = [
        ("n", n),
        ("kappa", kappa),
        ("m", m),
        ("p", p),
        ("q", q),
        ("d", d),
        ("a", a),
        ("b", b),
        ("c", c),
    ];
    for (name, value) in values {
        bindings.bind(name, value);
    }
    Ok(bindings)
}

/// AB and the middle of PF in the position of any ω. F is on the y-axis, at the distance 2 m sin(ω/2) from M that the
/// triangle MPF gives it; that the bars NQ and QF reach it there is the straight line.
fn coupler<K: Real>(
    lengths: &Lengths<K>,
    a: &Number<K>,
    b: &Number<K>,
    d: &Number<K>,
    free: &mut dyn Free<K>,
) -> Result<(Number<K>, Point<K>), Unbuilt> {
    let half = free.position("omega/2")?;
    let w = half.times(2).direction().clone();
    let f: Point<K> = Number::i().scaled(&(2 * &lengths.m * half.sin()));
    let base: Point<K> = d.clone().into();
    let u = &f / (Point::from(lengths.m.clone()) - w.scaled(&lengths.p));
    let v = (&f - &base) / (Point::from(lengths.n.clone()) + w.scaled(&lengths.q));
    for direction in [&u, &v] {
        Unbuilt::unless_true::<K>(
            direction.norm().equals(&Number::one()),
            "the bars do not reach F on the line",
        )?;
    }
    let ends = relation::distance_squared(&u.scaled(a), &(base + v.scaled(b)));
    let middle = (u.scaled(&lengths.m) + f) / 2;
    Ok((free.root("c", &ends)?, middle))
}
