//! The pole quadrilateral O₁₄O₁₂O₂₃O₃₄ of four positions and its sides.

use crate::formula::Bindings;
use crate::number::{Number, Real, array};
use crate::plane::displacement::Displacement;
use crate::plane::{Point, relation};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1973/pole-quadrilateral",
    "Four positions of the moving plane, all of them free, and the pole quadrilateral O14, O12, O23, \
     O34 that they give. Its sides are named as in figure 7: r and R lie on the lines through O1, \
     c and h on those through O2; O1 faces h and O2 faces R, so that c < h and r < R.",
    build,
    not symbolic: "sides without an order; which ones are shorter belongs to the scene",
    [
        "O_12": "pole of the positions 1 and 2",
        "O_23": "pole of the positions 2 and 3",
        "O_34": "pole of the positions 3 and 4",
        "O_14": "pole of the positions 1 and 4",
        "r": "length of the side O12 O23",
        "h": "length of the side O23 O34",
        "R": "length of the side O34 O14",
        "c": "length of the side O14 O12",
        "U": "sum of the shortest and the longest side",
        "Z": "sum of the other two sides",
        "adjacent": "1 where the shortest and the longest side have a pole in common, else 0",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let mut positions = Vec::new();
    for name in ["1", "2", "3", "4"] {
        positions.push(Displacement {
            rotation: free.angle(&format!("theta_{name}"))?.cis(),
            translation: Number::complex(
                free.number(&format!("x_{name}"))?,
                free.number(&format!("y_{name}"))?,
            ),
        });
    }
    let [first, second, third, fourth] = positions.as_slice() else {
        return Err(Unbuilt::Contradiction("not four positions".to_owned()));
    };
    let poles: [(&str, Point<K>); 4] = [
        ("O_12", first.pole(second)),
        ("O_23", second.pole(third)),
        ("O_34", third.pole(fourth)),
        ("O_14", first.pole(fourth)),
    ];
    let [r, h, long, c] =
        array::sides(&poles).map(|((_, a), (_, b))| relation::distance_squared(a, b));
    let r = free.root("r", &r)?;
    let h = free.root("h", &h)?;
    let long = free.root("R", &long)?;
    let c = free.root("c", &c)?;
    Unbuilt::unless_real((&h - &c).is_positive(), "c is not the shorter one")?;
    Unbuilt::unless_real((&long - &r).is_positive(), "r is not the shorter one")?;
    let total = &r + &h + &long + &c;
    // Of the two shorter ones of the pairs one is the shortest, and likewise for the longest.
    let r_is_shortest = is_less(&r, &c)?;
    let h_is_longest = is_less(&long, &h)?;
    let u = if r_is_shortest { &r } else { &c } + if h_is_longest { &h } else { &long };
    let adjacent = i64::from(r_is_shortest == h_is_longest);
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("adjacent", Number::<K>::from(adjacent));
    bindings.bind("Z", total - &u);
    bindings.bind("U", u);
    for (name, length) in [("r", r), ("h", h), ("R", long), ("c", c)] {
        bindings.bind(name, length);
    }
    for (name, pole) in poles {
        bindings.bind(name, pole);
    }
    Ok(bindings)
}

fn is_less<K: Real>(x: &Number<K>, y: &Number<K>) -> Result<bool, Unbuilt> {
    match x.compare(y) {
        Some(order) => Ok(order.is_lt()),
        None => Err(Unbuilt::NotHeld("the order of two sides".to_owned())),
    }
}
