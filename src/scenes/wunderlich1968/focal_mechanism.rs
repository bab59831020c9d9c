//! Sections 2 and 3: the focal mechanism.

use super::position::Position;
use crate::formula::Bindings;
use crate::linkage::{
    five_bar::{self, Lengths},
    focal_mechanism,
};
use crate::number::Real;
use crate::plane::relation;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/focal-mechanism",
    "One position of the focal mechanism: the five-bar MPFQN under Hart's condition with A on the \
     line MP and B on the line NQ such that AB keeps its length, which the scene itself proves from \
     the velocities. S and T are the points of MN and AB that are equally far from F in this \
     position and for another value of omega.",
    build,
    [
        "m": "length MP",
        "p": "length PF",
        "q": "length FQ",
        "n": "length QN",
        "d": "length MN of the base",
        "a": "length MA",
        "b": "length NB",
        "c": "length AB of the coupler",
        "lambda": "the ratio a : m",
        "M": "fixed pivot, in the origin",
        "N": "fixed pivot, on the positive x-axis",
        "P": "joint of the bars MP and PF",
        "Q": "joint of the bars NQ and QF",
        "F": "joint of the bars PF, QF, SF, TF",
        "A": "joint on the line MP",
        "B": "joint on the line NQ",
        "z": "the complex coordinate x + iy of F",
        "phi": "angle from the base MN to the bar MP",
        "psi": "angle from the base to the bar NQ",
        "omega": "angle MPF",
        "u": "unit vector of the bar MP",
        "v": "unit vector of the bar NQ",
        "w": "unit vector of direction omega",
        "PA": "length PA, directed from M to A",
        "BQ": "length QB, directed from N to B",
        "PF": "length PF",
        "QF": "length QF",
        "AB": "length AB",
        "MS": "distance from M to S, directed along MN",
        "NS": "distance from N to S, directed along MN",
        "AT": "distance from A to T, directed along AB",
        "BT": "distance from B to T, directed along AB",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let position = Position::free(free)?;
    let lengths = &position.lengths;
    let (a, b) = focal_mechanism::arms(lengths);
    Unbuilt::unless_true::<K>(
        focal_mechanism::keeps_coupler(&position.chain, &a, &b),
        "the distance AB changes",
    )?;
    let (m, n) = (&lengths.m, &lengths.n);
    let pin_a = position.u.scaled(&a);
    let pin_b = position.v().scaled(&b) + crate::plane::Point::from(position.d.clone());
    let c = free.root("c", &relation::distance_squared(&pin_a, &pin_b))?;

    let other = free.angle("another omega")?;
    let s = five_bar::center_of_path(lengths, &position.d, &position.omega, &other);
    // Seen from AB, the chain BQFPA is a five-bar of the same kind, with the same ω at Q.
    let from_coupler = Lengths {
        m: &b - n,
        p: lengths.q.clone(),
        q: lengths.p.clone(),
        n: &a - m,
    };
    let t_from_b = five_bar::center_of_path(&from_coupler, &c, &position.omega, &other);

    let mut bindings = Bindings::new(free.precision());
    position.bind(&mut bindings);
    bindings.bind("PA", &a - m);
    bindings.bind("BQ", &b - n);
    bindings.bind(
        "PF",
        relation::distance(&position.chain.p, &position.chain.f),
    );
    bindings.bind(
        "QF",
        relation::distance(&position.chain.q, &position.chain.f),
    );
    bindings.bind("lambda", &a / m);
    bindings.bind("NS", &s - &position.d);
    bindings.bind("MS", s);
    bindings.bind("AT", &c - &t_from_b);
    bindings.bind("BT", -t_from_b);
    bindings.bind("AB", c.clone());
    bindings.bind("A", pin_a);
    bindings.bind("B", pin_b);
    bindings.bind("a", a);
    bindings.bind("b", b);
    bindings.bind("c", c);
    Ok(bindings)
}
