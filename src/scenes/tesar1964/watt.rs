//! Chapter V: Watt's linkage where its cranks are parallel.

use super::sense::sense;
use crate::curvature::closure;
use crate::curvature::contact::Guide;
use crate::curvature::motion::{Motion, coefficient, derivative};
use crate::formula::Bindings;
use crate::number::{Number, Real, array};
use crate::plane::{Angle, Point, relation};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/watt",
    "A four-bar with parallel cranks in the design position, its coupler of length 1. The V-axis is \
     parallel to the cranks, from the pivot O_a to the pin A; the origin is the output point C, \
     where the path of a point of the coupler line has an inflection, from the series of the \
     closure. The output point D is on the V-axis, where all paths have one. Angles turn from U to \
     V.",
    build,
    [
        "R": "length of the crank O_aA",
        "T": "length of the crank O_bB",
        "n": "+1 where the cranks are crossed, that is of opposite directions, -1 where they are open",
        "gamma": "from the coupler AB to the direction of the crank O_aA",
        "r": "from A to C along the coupler line",
        "k": "from C to D along the V-axis",
        "U_1": "coordinate of O_a",
        "V_1": "coordinate of O_a",
        "U_2": "coordinate of O_b",
        "V_2": "coordinate of O_b",
        "UP_1": "coordinate of A",
        "VP_1": "coordinate of A",
        "UP_2": "coordinate of B",
        "VP_2": "coordinate of B",
        "U_d": "coordinate of D",
        "V_d": "coordinate of D",
        "M": "distance of D from A",
        "N": "distance of D from B",
        "Q": "distance of the pivots",
        "theta": "direction from O_a to O_b",
        "epsilon": "from AB to AD",
    ]
);

pub const ANY_POINT: Scene = scene!(
    "tesar1964/watt-coupler-point",
    "The same with a coupler of any length, and any point of the coupler plane. The curvature of its \
     path is that of the series of the closure.",
    build_any_point,
    [
        "R": "length of the crank O_aA",
        "S": "length of the coupler AB",
        "T": "length of the crank O_bB",
        "n": "+1 where the cranks are crossed, that is of opposite directions, -1 where they are open",
        "gamma": "from the coupler AB to the direction of the crank O_aA",
        "r": "from A to C along the coupler line",
        "U": "coordinate of the point",
        "V": "coordinate of the point",
        "kappa": "curvature of its path, positive where it turns towards the V-axis",
    ]
);

struct Watt<K> {
    r: Number<K>,
    crank_a: Number<K>,
    crank_b: Number<K>,
    sense: Number<K>,
    gamma: Angle<K>,
    coupler: Number<K>,
    pivots: [Point<K>; 2],
    pins: [Point<K>; 2],
    motion: Motion<K>,
}

fn watt<K: Real>(free: &mut dyn Free<K>, coupler: Number<K>) -> Result<Watt<K>, Unbuilt> {
    let (crank_a, crank_b) = (free.length("R")?, free.length("T")?);
    let sense = sense(free, "n")?;
    let gamma = free.angle("gamma")?;
    let upwards = Point::<K>::i();
    let pins = [
        Number::zero(),
        (&upwards * gamma.cis().conj()).scaled(&coupler),
    ];
    let pivots = [
        -upwards.scaled(&crank_a),
        &pins[1] + upwards.scaled(&(&sense * &crank_b)),
    ];
    let motion = translating(&pivots, &pins)?;
    let [bend_a, bend_b] = pins.each_ref().map(|pin| bend(&motion, pin));
    let part = &bend_a / (&bend_a - bend_b);
    if !part.has_value() {
        return Err(Unbuilt::NotReal(
            "the linkage is a parallelogram".to_owned(),
        ));
    }
    // From now on C is the origin.
    let c = pins[1].scaled(&part);
    let from_c = |points: [Point<K>; 2]| points.map(|point| point - &c);
    let (pivots, pins) = (from_c(pivots), from_c(pins));
    Ok(Watt {
        r: &coupler * part,
        crank_a,
        crank_b,
        sense,
        gamma,
        coupler,
        motion: translating(&pivots, &pins)?,
        pivots,
        pins,
    })
}

/// The motion of a coupler whose cranks are parallel to the V-axis; the U-coordinate drives.
fn translating<K: Real>(
    pivots: &[Point<K>; 2],
    pins: &[Point<K>; 2],
) -> Result<Motion<K>, Unbuilt> {
    let guides = array::pairs(pins, pivots).map(|(pin, pivot)| Guide::Circle {
        point: pin.clone(),
        center: pivot.clone(),
    });
    closure::motion(&guides, 2)
        .ok_or_else(|| Unbuilt::NotReal("the linkage is in a change point".to_owned()))
}

/// The term of order two along the cranks in the path of a point.
fn bend<K: Real>(motion: &Motion<K>, point: &Point<K>) -> Number<K> {
    coefficient(&motion.path_of(point), 2).im().clone()
}

impl<K: Real> Watt<K> {
    fn bind(self, bindings: &mut Bindings<K>) {
        bindings.bind("gamma", self.gamma);
        for (name, value) in [
            ("R", self.crank_a),
            ("T", self.crank_b),
            ("n", self.sense),
            ("r", self.r),
        ] {
            bindings.bind(name, value);
        }
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let watt = watt(free, Number::one())?;
    let k = free.number("k")?;
    let d = Point::<K>::i().scaled(&k);
    for point in [&Number::zero(), &d] {
        Unbuilt::unless_true::<K>(
            bend(&watt.motion, point).is_zero(),
            "paths of the V-axis have an inflection",
        )?;
    }
    let ([o_a, o_b], [a, b]) = (&watt.pivots, &watt.pins);
    let m = free.root("M", &relation::distance_squared(&d, a))?;
    let n = free.root("N", &relation::distance_squared(&d, b))?;
    let q = free.root("Q", &relation::distance_squared(o_a, o_b))?;
    let mut bindings = Bindings::new(free.precision());
    for (u, v, point) in [
        ("U_1", "V_1", o_a),
        ("U_2", "V_2", o_b),
        ("UP_1", "VP_1", a),
        ("UP_2", "VP_2", b),
        ("U_d", "V_d", &d),
    ] {
        bindings.bind(u, free.among_all(point.re().clone()));
        bindings.bind(v, free.among_all(point.im().clone()));
    }
    let opening = (&d - a) * (b - a).conj();
    bindings.bind("epsilon", Angle::of_known_length(opening, m.clone()));
    bindings.bind("theta", Angle::of(o_b - o_a));
    for (name, value) in [("k", k), ("M", m), ("N", n), ("Q", q)] {
        bindings.bind(name, value);
    }
    watt.bind(&mut bindings);
    Ok(bindings)
}

fn build_any_point<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let coupler = free.length("S")?;
    let watt = watt(free, coupler)?;
    let point = crate::scenes::free::point(free, "the point")?;
    let velocity = derivative(&watt.motion.path_of(&point));
    let turn = (velocity.conj() * derivative(&velocity))
        .im()
        .coefficient(0);
    let speed = coefficient(&velocity, 0);
    Unbuilt::unless_true::<K>(speed.equals(&Number::one()), "the coupler starts along U")?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("kappa", turn);
    bindings.bind("U", point.re().clone());
    bindings.bind("V", point.im().clone());
    bindings.bind("S", watt.coupler.clone());
    watt.bind(&mut bindings);
    Ok(bindings)
}
