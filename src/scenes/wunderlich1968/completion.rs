//! Section 4: the focal mechanisms of a given four-bar.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::{Point, relation};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/completion",
    "One position of a four-bar MABN, and P, Q that divide its arms by a given lambda. The product \
     p q follows from the arms, and p u + q v, turned by omega, must bridge PQ. Whether there are \
     real p and q is not asked.",
    build,
    [
        "a": "length MA",
        "b": "length NB",
        "c": "length AB",
        "d": "length MN",
        "lambda": "the ratio MA : MP = NB : NQ",
        "sigma": "the square of p + q",
        "delta": "the square of p - q",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (a, b, d) = (free.length("a")?, free.length("b")?, free.length("d")?);
    let u = free.angle("phi")?.direction().clone();
    let v = free.angle("psi")?.direction().clone();
    let lambda = free.number("lambda")?;
    let base = Point::from(d.clone());
    let c = free.root(
        "c",
        &relation::distance_squared(&u.scaled(&a), &(&base + v.scaled(&b))),
    )?;
    let (m, n) = (&a / &lambda, &b / &lambda);
    let gap = relation::distance_squared(&u.scaled(&m), &(&base + v.scaled(&n)));
    // The arm goes on beyond P by p q/n.
    let product = (&a - &m) * &n;
    // |p u + q v|² = (p ± q)² + 2 p q (cos(φ − ψ) ∓ 1).
    let cos = (&u * v.conj()).re().clone();
    let square = |sign: i64| -> Number<K> { &gap - 2 * &product * (&cos - sign) };
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("sigma", square(1));
    bindings.bind("delta", square(-1));
    for (name, value) in [("a", a), ("b", b), ("c", c), ("d", d), ("lambda", lambda)] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}
