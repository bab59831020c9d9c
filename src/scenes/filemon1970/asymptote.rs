//! Figures 1 and 2: the curve of the points that see two segments under one angle, at infinity.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::circular_cubic::Cubic;
use crate::plane::projective::ProjectivePoint;
use crate::plane::{Angle, Point};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const ANY_DIRECTION: Scene = scene!(
    "filemon1970/curve-in-a-direction",
    "Two lines through O at the angle phi, one of them the x-axis, on each a segment AB and DC, \
     and the cubic of the points P from which both are seen under equal angles mod pi: the \
     imaginary part of (P - B) (P - D) conj(P - A) conj(P - C) is 0. It is looked at in any \
     direction.",
    build_any_direction,
    [
        "phi": "angle of the second line with the x-axis",
        "r": "length of the segment on the x-axis",
        "R": "length of the segment on the second line",
        "x_1": "abscissa of the direction",
        "x_2": "ordinate of the direction",
        "F": "value of the left side of that equation, made homogeneous, at [x_1, x_2, 0]",
        "m": "slope of a line y = m x + n, n being any number",
        "A": "coefficient of x^3 in the same with m x + n in the place of y",
        "m_0": "slope of the real asymptote",
    ]
);

pub const SCENE: Scene = scene!(
    "filemon1970/asymptote",
    "The cubic of the scene curve-in-a-direction, its real asymptote and its real point at \
     infinity, both taken from the cubic's coefficients.",
    build,
    [
        "phi": "angle of the second line with the x-axis",
        "r": "length of the segment on the x-axis",
        "R": "length of the segment on the second line",
        "x_1": "first homogeneous coordinate of the real point at infinity",
        "x_2": "second homogeneous coordinate of the real point at infinity",
        "m": "slope of the real asymptote",
    ]
);

pub const ANGLE: Scene = scene!(
    "filemon1970/angle-of-the-asymptote",
    "The real asymptote of the cubic of the scene curve-in-a-direction, the lines being drawn so \
     that 0 < phi < pi; and the asymptote for a segment on the x-axis that is as long as the \
     projection of the other.",
    build_angle,
    not symbolic: "an angle between 0 and pi; which one belongs to the scene",
    [
        "phi": "angle of the second line with the x-axis, between 0 and pi",
        "r": "length of the segment on the x-axis",
        "R": "length of the segment on the second line",
        "m": "slope of the real asymptote",
        "delta": "angle of the real asymptote with the x-axis, between 0 and pi",
        "delta_0": "the same for a segment of length R cos phi on the x-axis",
    ]
);

/// Two segments on lines through O.
struct Segments<K> {
    phi: Angle<K>,
    /// From O to the first ends.
    starts: [Number<K>; 2],
    r: Number<K>,
    long: Number<K>,
}

impl<K: Real> Segments<K> {
    fn free(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        Ok(Segments {
            starts: [free.number("a")?, free.number("b")?],
            r: free.length("r")?,
            long: free.length("R")?,
            phi: free.angle("phi")?,
        })
    }

    /// The cubic of the points P with equal angles APB and DPC mod π, for the segments AB and DC:
    /// twice Im (P − B)(P − D)(P̄ − Ā)(P̄ − C̄).
    fn cubic(&self) -> Result<Cubic<K>, Unbuilt> {
        let along = self.phi.cis();
        let [a, d] = &self.starts;
        let vertices: [Point<K>; 4] = [
            (a + &self.r).into(),
            along.scaled(&(d + &self.long)),
            along.scaled(d),
            a.clone().into(),
        ];
        Cubic::focal(&vertices)
            .ok_or_else(|| Unbuilt::Contradiction("the curve is no real cubic".to_owned()))
    }

    fn bind(self, bindings: &mut Bindings<K>) {
        bindings.bind("phi", self.phi);
        bindings.bind("r", self.r);
        bindings.bind("R", self.long);
    }
}

/// A direction in which the real asymptote leads.
fn direction<K: Real>(cubic: &Cubic<K>) -> Point<K> {
    let asymptote = cubic.real_asymptote();
    let [a, b, _] = asymptote.coefficients();
    Number::complex(b.clone(), -a)
}

fn slope<K: Real>(direction: &Point<K>) -> Number<K> {
    direction.im() / direction.re()
}

fn build_any_direction<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let segments = Segments::free(free)?;
    let (x_1, x_2) = (free.number("x_1")?, free.number("x_2")?);
    let (m, n) = (free.number("m")?, free.number("n")?);
    let cubic = segments.cubic()?;
    let at_infinity = ProjectivePoint::new(x_1.clone(), x_2.clone(), Number::zero());
    // The third difference of a cubic polynomial is six times its leading coefficient; the cubic is
    // held as twice the left side.
    let [f0, f1, f2, f3] =
        [0, 1, 2, 3].map(|x: i64| cubic.at(&Number::complex(x.into(), &m * x + &n)));
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("F", cubic.at_projective(&at_infinity) / 2);
    bindings.bind("A", (f3 - 3 * f2 + 3 * f1 - f0) / 12);
    bindings.bind("m_0", slope(&direction(&cubic)));
    segments.bind(&mut bindings);
    for (name, value) in [("x_1", x_1), ("x_2", x_2), ("m", m)] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let segments = Segments::free(free)?;
    let cubic = segments.cubic()?;
    let at_infinity = cubic.real_point_at_infinity();
    let [x_1, x_2, _] = at_infinity.coordinates();
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("x_1", x_1.clone());
    bindings.bind("x_2", x_2.clone());
    bindings.bind("m", slope(&direction(&cubic)));
    segments.bind(&mut bindings);
    Ok(bindings)
}

fn build_angle<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let segments = Segments::free(free)?;
    Unbuilt::unless_real(
        segments.phi.sin().is_positive(),
        "phi is not between 0 and pi",
    )?;
    let towards = direction(&segments.cubic()?);
    let projected = Segments {
        phi: segments.phi.clone(),
        starts: segments.starts.clone(),
        r: &segments.long * segments.phi.cos(),
        long: segments.long.clone(),
    };
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("m", slope(&towards));
    bindings.bind("delta", upwards(&towards)?);
    bindings.bind("delta_0", upwards(&direction(&projected.cubic()?))?);
    segments.bind(&mut bindings);
    Ok(bindings)
}

/// The angle between 0 and π of a line that is not parallel to the x-axis.
fn upwards<K: Real>(direction: &Point<K>) -> Result<Angle<K>, Unbuilt> {
    match direction.im().sign() {
        Some(sign) if sign.is_lt() => Ok(Angle::of(-direction)),
        Some(_) => Ok(Angle::of(direction.clone())),
        None => Err(Unbuilt::NotHeld("the upper half of a line".to_owned())),
    }
}
