//! Section 7: Hart's straight-line mechanism.

use super::position::Position;
use crate::formula::Bindings;
use crate::linkage::five_bar::Lengths;
use crate::linkage::focal_mechanism;
use crate::number::{Number, Real};
use crate::plane::{Angle, Point, relation};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/hart",
    "The focal mechanism in which F keeps its distance from no finite point of MN, with M in the \
     origin and N on the x-axis. The bars m, n, p and both angles are free, q follows; it is \
     negative, a bar QF laid off backwards. kappa is the ratio p : n.",
    build,
    [
        "m": "length MP",
        "p": "length PF",
        "q": "length FQ, negative",
        "n": "length QN",
        "d": "length MN of the base",
        "a": "length MA, directed like MP",
        "b": "length NB, directed like NQ",
        "c": "length AB",
        "kappa": "the ratio p : n",
        "lambda": "the ratio a : m",
        "x": "abscissa of F",
        "x_1": "abscissa of F in another position",
        "xi": "distance from A to the foot of F on AB, directed along AB",
        "xi_1": "the same in another position",
        "AT": "distance from A to T, directed along AB, up to a common factor with BT",
        "BT": "distance from B to T, directed along AB, up to a common factor with AT",
    ]
);

/// The distance from the first of two points, c apart, to the foot of a third, by its squared
/// distances from both.
fn foot<K: Real>(squares: [Number<K>; 2], c: &Number<K>) -> Number<K> {
    let [from_first, from_second] = squares;
    (from_first - from_second + c.square()) / (2 * c)
}

/// The squared distance of the ends of two bars that include an angle.
fn across<K: Real>(x: &Number<K>, y: &Number<K>, angle: &Angle<K>) -> Number<K> {
    (Point::from(x.clone()) - angle.direction().scaled(y)).norm()
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (m, n, p) = (free.length("m")?, free.length("n")?, free.length("p")?);
    // |MF|² and |NF|² change with cos ω by the factors −2 m p and 2 n q. Where both change alike, F
    // moves across MN, and no point of MN keeps its distance.
    let q = -(&m * &p / &n);
    let (kappa, lengths) = (&p / &n, Lengths { m, p, q, n });
    let position = Position::with_lengths(lengths, free)?;
    let Lengths { m, p, q, n } = &position.lengths;
    let d = &position.d;
    let (a, b) = focal_mechanism::arms(&position.lengths);
    let pin_a: Point<K> = a.clone().into();
    let pin_b = &position.chain.n + position.chain.v.scaled(&b);
    let c = free.root("c", &relation::distance_squared(&pin_a, &pin_b))?;
    let f = &position.chain.f;
    let here = [&pin_a, &pin_b].map(|pin| relation::distance_squared(pin, f));

    // Another position by its ω; only triangles with known sides are used.
    let half_turn = Angle::from_cos_sin(Number::from(-1), Number::zero());
    let omega = free.angle("another omega")?;
    let supplement = &half_turn - &omega;
    let from_base = [across(m, p, &omega), across(n, q, &supplement)];
    let from_coupler = [
        across(&(&a - m), p, &supplement),
        across(&(&b - n), q, &omega),
    ];

    let mut bindings = Bindings::new(free.precision());
    bindings.bind("x", position.turned(f).re().clone());
    bindings.bind("x_1", foot(from_base, d));
    bindings.bind("xi", foot(here, &c));
    bindings.bind("xi_1", foot(from_coupler, &c));
    // T of the chain BQFPA as S of MPFQN: the products of the bars next to it on either side.
    bindings.bind("AT", (&a - m) * p);
    bindings.bind("BT", -((&b - n) * q));
    bindings.bind("kappa", kappa);
    bindings.bind("lambda", &a / m);
    let values = [
        ("m", m),
        ("p", p),
        ("q", q),
        ("n", n),
        ("d", d),
        ("a", &a),
        ("b", &b),
        ("c", &c),
    ];
    for (name, value) in values {
        bindings.bind(name, value.clone());
    }
    Ok(bindings)
}
