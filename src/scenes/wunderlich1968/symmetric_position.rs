//! Section 6: the symmetric position of a symmetric focal mechanism.

use crate::formula::Bindings;
use crate::linkage::five_bar::{self, Lengths};
use crate::linkage::focal_mechanism;
use crate::number::{Number, Real};
use crate::plane::{Angle, Point};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/symmetric-position",
    "The focal mechanism with m = n, p = q in the position in which NQ is the mirror image of MP. The \
     base is taken so long that the chain closes for some omega; that omega follows. A, B, S and T \
     lie where they do in any focal mechanism.",
    build,
    [
        "m": "length MP = NQ",
        "p": "length PF = QF",
        "d": "length MN",
        "M": "fixed pivot, in the origin",
        "N": "fixed pivot, on the x-axis",
        "A": "joint of MA and AB",
        "B": "joint of AB and NB",
        "P": "joint on MA",
        "Q": "joint on NB",
        "S": "joint on MN",
        "T": "joint on AB",
        "F": "the fourfold joint",
        "omega": "angle MPF",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (m, p) = (free.length("m")?, free.length("p")?);
    let u = free.angle("phi")?.direction().clone();
    // The mirror image, in a line across the base, of u.
    let v = -u.conj();
    // The closure m u − n v − d = w (p u + q v) holds for a w of length 1 only if |2 m cos φ − d| is
    // |2 p sin φ|. Of both bases the one with which ω is positive.
    let d = 2 * &m * u.re() + 2 * &p * u.im();
    let closing = (&u - &v).scaled(&m) - Point::from(d.clone());
    let w = closing / (&u + &v).scaled(&p);
    Unbuilt::unless_true::<K>(w.norm().equals(&Number::one()), "the chain does not close")?;
    let lengths = Lengths {
        m: m.clone(),
        p: p.clone(),
        q: p.clone(),
        n: m.clone(),
    };
    let (a, b) = focal_mechanism::arms(&lengths);
    let base: Point<K> = d.clone().into();
    let pin_p = u.scaled(&m);
    let f = &pin_p - (&u * &w).scaled(&p);
    let (pin_a, pin_b) = (u.scaled(&a), &base + v.scaled(&b));
    let share = five_bar::share_of_center(&(&lengths.n * &lengths.q / (&m * &p)));
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("omega", Angle::at_vertex(&Number::zero(), &pin_p, &f));
    bindings.bind("S", base.scaled(&share));
    bindings.bind("T", &pin_a + (&pin_b - &pin_a).scaled(&share));
    bindings.bind("Q", &base + v.scaled(&m));
    bindings.bind("P", pin_p);
    bindings.bind("F", f);
    bindings.bind("A", pin_a);
    bindings.bind("B", pin_b);
    bindings.bind("M", Point::<K>::zero());
    bindings.bind("N", base);
    for (name, length) in [("m", m), ("p", p), ("d", d)] {
        bindings.bind(name, length);
    }
    Ok(bindings)
}
