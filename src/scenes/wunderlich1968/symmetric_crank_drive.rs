//! Section 6: the symmetric double rocker driven by a crank.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::{Point, relation};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/symmetric-crank-drive",
    "The focal mechanism of a four-bar with equal rockers, S in the middle of MN, in its symmetric \
     open position. Mirror symmetry makes the angles omega and pi - omega at P and Q equal, so PF is \
     perpendicular to MA; F lies on the axis and AB keeps its length. Of the two solutions it is the \
     one with the shorter crank SF.",
    build,
    [
        "a": "length MA = NB of the rockers",
        "c": "length AB of the coupler",
        "d": "length MN of the base",
        "h_1": "distance of AB from MN in the open parallel position",
        "h_2": "distance of AB from MN in the crossed parallel position",
        "m": "length MP = NQ",
        "p": "length PF = QF",
        "r": "length SF of the crank",
        "F_1": "F in the open parallel position",
        "T_1": "the middle of AB in the open parallel position",
        "F_2": "F in the crossed parallel position",
        "T_2": "the middle of AB in the crossed parallel position",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (a, c, d) = (free.length("a")?, free.length("c")?, free.length("d")?);
    let half = |x: Number<K>| x / 2;
    let h_1 = free.root("h_1", &(a.square() - half(&d - &c).square()))?;
    let h_2 = free.root("h_2", &(a.square() - half(&d + &c).square()))?;
    // P is the foot of F on MA, so MF² = m² + p². That AB keeps its length says a m = m² + p².
    // With F = (d/2, y) this is F·A = F·F, a quadratic equation for y with the roots (h₁ ± h₂)/2.
    let pin_a: Point<K> = Number::complex(half(&d - &c), h_1.clone());
    let y = half(&h_1 - &h_2);
    let f: Point<K> = Number::complex(half(d.clone()), y.clone());
    Unbuilt::unless_true::<K>(
        (f.conj() * &pin_a).re().equals(&f.norm()),
        "AB does not keep its length",
    )?;
    let m = (f.conj() * &pin_a).re() / &a;
    // Not negative: four times the area is (c + d) h₁ + (d − c) h₂, and h₁ > h₂.
    let p = relation::twice_area(&Number::zero(), &f, &pin_a) / &a;
    let base = half(d.clone());
    let on_axis = |y: Number<K>| -> Point<K> { Number::complex(base.clone(), y) };
    // In the crossed position PF is as long as before where F lies on the axis at this height.
    let crossed = (&h_2 - &h_1) / 2;
    let crossed_a: Point<K> = Number::complex(half(&d + &c), h_2.clone());
    let crossed_p = crossed_a.scaled(&(&m / &a));
    Unbuilt::unless_true::<K>(
        relation::distance_squared(&crossed_p, &on_axis(crossed.clone())).equals(&p.square()),
        "PF changes its length",
    )?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("F_1", f);
    bindings.bind("T_1", on_axis(h_1.clone()));
    bindings.bind("F_2", on_axis(crossed));
    bindings.bind("T_2", on_axis(h_2.clone()));
    let values = [
        ("a", a),
        ("c", c),
        ("d", d),
        ("h_1", h_1),
        ("h_2", h_2),
        ("m", m),
        ("p", p),
        ("r", y),
    ];
    for (name, value) in values {
        bindings.bind(name, value);
    }
    Ok(bindings)
}
