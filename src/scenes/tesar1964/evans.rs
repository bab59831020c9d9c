//! Chapter V: Evans' linkage, from the motion of a circle of radius 1 that rolls in one of radius 2.
//!
//! Where the center of the rolling circle is in the direction ω, it has turned by −ω: the point z of it
//! is at e^{iω} + e^{−iω} z. That of z = e^{2iα} is at 2 cos(ω − α) e^{iα}: each point of its edge moves
//! along a diameter of the fixed circle.

use crate::formula::Bindings;
use crate::number::{Kind, Number, Real};
use crate::plane::displacement::Displacement;
use crate::plane::projective::{Line, ProjectivePoint};
use crate::plane::{Angle, Point};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/evans",
    "A circle of radius 1 that rolls in a circle of radius 2 about the origin, in the initial \
     position. B and D are points of its edge, and move on the U-axis and on the line through the \
     origin in the direction alpha. A is on the diameter whose end moves on the line OP_c, in the \
     direction beta. O_a is where that line meets the normal of the path of A, through the point P_o \
     where the circles touch. O_b is above the midpoint of B and the end of its path.",
    build,
    [
        "omega": "direction of the center of the rolling circle",
        "beta": "direction of OP_c, an axis of symmetry of the ellipse of A",
        "alpha": "direction of the path of D",
        "rho": "from the center of the rolling circle to A, positive towards the end of the diameter",
        "k": "height of O_b above the path of B",
        "m": "slope of the line A_oP_o",
        "U_1": "coordinate of O_a",
        "V_1": "coordinate of O_a",
        "U_2": "coordinate of O_b",
        "V_2": "coordinate of O_b",
        "UP_1": "coordinate of A",
        "VP_1": "coordinate of A",
        "U_d": "coordinate of D",
        "V_d": "coordinate of D",
    ]
);

pub const NORMAL: Scene = scene!(
    "tesar1964/evans-normal",
    "The same, and any point of the line A_oP_o.",
    build_normal,
    [
        "omega": "direction of the center of the rolling circle",
        "m": "slope of the line A_oP_o",
        "U": "coordinate of the point",
        "V": "coordinate of the point",
    ]
);

pub const AXIS: Scene = scene!(
    "tesar1964/evans-axis",
    "The same, and any point of the line OP_c.",
    build_axis,
    [
        "beta": "direction of OP_c",
        "U": "coordinate of the point",
        "V": "coordinate of the point",
    ]
);

pub const SPECIAL: Scene = scene!(
    "tesar1964/evans-special-cases",
    "The same with the axis OP_c along the U-axis, beta = 0, and with the path of D along the \
     V-axis, alpha = 90 deg. The places of B and D in a second position show their paths. A_s and \
     O_s are A and O_a for rho = 0.",
    build_special,
    [
        "A": "pin of the crank",
        "B": "point of the edge",
        "B'": "the same point in another position",
        "D": "point of the edge",
        "D'": "the same point in another position",
        "V_1": "coordinate of O_a",
        "O": "center of the fixed circle",
        "A_s": "pin of the crank for rho = 0",
        "O_s": "pivot O_a for rho = 0",
    ]
);

/// The rolling circle with its center in this direction.
pub(super) fn rolling<K: Real>(omega: &Angle<K>) -> Displacement<K> {
    Displacement {
        rotation: omega.cis().conj(),
        translation: omega.cis(),
    }
}

/// The point of the edge that moves along the diameter in this direction.
pub(super) fn on_edge<K: Real>(direction: &Angle<K>) -> Point<K> {
    direction.times(2).cis()
}

/// Where the circles touch.
fn pole<K: Real>(omega: &Angle<K>) -> Point<K> {
    omega.cis() * 2
}

/// Where the normal of a path meets the axis through the origin.
fn pivot<K: Kind>(pin: &Point<K>, pole: &Point<K>, axis: &Point<K>) -> Point<K> {
    let [pin, pole] = [pin, pole].map(ProjectivePoint::from_finite);
    let origin = ProjectivePoint::from_finite(&Number::zero());
    let axis = Line::through(&origin, &ProjectivePoint::from_direction(axis));
    let meet = Line::through(&pin, &pole).meet(&axis);
    let [x, y, w] = meet.coordinates();
    Number::complex(x / w, y / w)
}

struct Crank<K> {
    omega: Angle<K>,
    beta: Angle<K>,
    rho: Number<K>,
    pin: Point<K>,
}

impl<K: Real> Crank<K> {
    fn of(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let (omega, beta) = (free.angle("omega")?, free.angle("beta")?);
        let rho = free.number("rho")?;
        let pin = rolling(&omega).of(&on_edge(&beta).scaled(&rho));
        Ok(Crank {
            omega,
            beta,
            rho,
            pin,
        })
    }

    fn normal(&self) -> Point<K> {
        pole(&self.omega) - &self.pin
    }

    fn slope(&self) -> Number<K> {
        let normal = self.normal();
        normal.im() / normal.re()
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let crank = Crank::of(free)?;
    let alpha = free.angle("alpha")?;
    let k = free.number("k")?;
    let position = rolling(&crank.omega);
    let d = position.of(&on_edge(&alpha));
    let b = position.of(&Number::one());
    for (point, along) in [(&d, &alpha.cis()), (&b, &Number::one())] {
        Unbuilt::unless_true::<K>(
            (point * along.conj()).im().is_zero(),
            "points of the edge move along diameters",
        )?;
    }
    // B is farthest out where the circles touch in it.
    let end = Point::<K>::one() * 2;
    let o_b = (b + end) / 2 + Point::<K>::i().scaled(&k);
    let o_a = pivot(&crank.pin, &pole(&crank.omega), &crank.beta.cis());
    let mut bindings = Bindings::new(free.precision());
    for (u, v, point) in [
        ("U_1", "V_1", &o_a),
        ("U_2", "V_2", &o_b),
        ("UP_1", "VP_1", &crank.pin),
        ("U_d", "V_d", &d),
    ] {
        bindings.bind(u, point.re().clone());
        bindings.bind(v, point.im().clone());
    }
    bindings.bind("m", crank.slope());
    bindings.bind("k", k);
    bindings.bind("rho", crank.rho);
    for (name, angle) in [
        ("omega", crank.omega),
        ("beta", crank.beta),
        ("alpha", alpha),
    ] {
        bindings.bind(name, angle);
    }
    Ok(bindings)
}

fn bind_point<K: Real>(point: &Point<K>, bindings: &mut Bindings<K>) {
    bindings.bind("U", point.re().clone());
    bindings.bind("V", point.im().clone());
}

fn build_normal<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let crank = Crank::of(free)?;
    let along = free.number("place on the normal")?;
    let mut bindings = Bindings::new(free.precision());
    bind_point(&(&crank.pin + crank.normal().scaled(&along)), &mut bindings);
    bindings.bind("m", crank.slope());
    bindings.bind("omega", crank.omega);
    Ok(bindings)
}

fn build_axis<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let beta = free.angle("beta")?;
    let along = free.number("place on the axis")?;
    let mut bindings = Bindings::new(free.precision());
    bind_point(&beta.cis().scaled(&along), &mut bindings);
    bindings.bind("beta", beta);
    Ok(bindings)
}

fn build_special<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (omega, other) = (free.angle("omega")?, free.angle("another position")?);
    let rho = free.number("rho")?;
    let axis = Point::<K>::one();
    let [b, d] = [Number::one(), -Point::<K>::one()];
    let (here, there) = (rolling(&omega), rolling(&other));
    let pivot_of = |pin: &Point<K>| pivot(&here.of(pin), &pole(&omega), &axis);
    let (a, middle) = (axis.scaled(&rho), Number::zero());
    let mut bindings = Bindings::new(free.precision());
    for (name, point) in [
        ("A", here.of(&a)),
        ("B", here.of(&b)),
        ("B'", there.of(&b)),
        ("D", here.of(&d)),
        ("D'", there.of(&d)),
        ("O", Number::zero()),
        ("A_s", here.of(&middle)),
        ("O_s", pivot_of(&middle)),
    ] {
        bindings.bind(name, point);
    }
    bindings.bind("V_1", pivot_of(&a).im().clone());
    Ok(bindings)
}
