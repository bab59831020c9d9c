//! Chapter IV: slider-cranks with alternate four-bars whose coupler curves are symmetrical.

use super::symmetric_curve::{Positions, mirrored_diagonal};
use crate::curvature::canonical::Canonical;
use crate::curvature::closure;
use crate::curvature::contact::Guide;
use crate::curvature::motion::{Motion, turning};
use crate::curvature::osculation::center_of_curvature;
use crate::formula::Bindings;
use crate::number::{Kind, Number, Real};
use crate::plane::{Angle, Point, line};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/symmetrical-alternate",
    "A slider-crank with O_aA = AD in one position, in units of the diameter of the inflection circle and seen \
     from the pole. R : PA and the angle at A are free, and the motion from the closure tells pole tangent and \
     diameter; k is positive. A third point B of the coupler is as far from A as D, and O_b is the center of its \
     path, so that the four-bar O_aABO_b has D on its inflection circle. Distances from the pole are \
     positive here.",
    build,
    [
        "k": "PO_a / sin alpha_a",
        "alpha_a": "ray of the crank pin A",
        "alpha_b": "ray of the coupler point B",
        "alpha_d": "ray of the slider's pin D",
        "alpha_d'": "ray of the other point of the inflection circle as far from A as O_a",
        "PA": "from the pole to A",
        "PB": "from the pole to B",
        "PD": "from the pole to D",
        "PO_a": "from the pole to the pivot O_a",
        "PO_b": "from the pole to the pivot O_b, along the ray of B",
        "R": "length O_aA",
        "M": "length AD",
        "S": "length AB",
        "N": "length BD",
        "O_bB": "from B to O_b, along the ray",
        "epsilon": "turn that leads from AB to AD, counterclockwise, between 0 and 180 deg",
        "Phi": "turn that leads from AD to the direction of the crank, from O_a to A",
        "phi": "turn that leads from the fixed link, from O_a to O_b, to the crank, from O_a to A",
        "turn": "turn that leads from the axis of symmetry to the ray of D, modulo 180 deg",
    ]
);

/// The linkage with PA as unit of length: the pole is the origin, A is 1.
struct Shape<K> {
    crank: Number<K>,
    pivot: Point<K>,
    rod: Point<K>,
    canonical: Canonical<K>,
}

impl<K: Kind> Shape<K> {
    fn of(crank: Number<K>, direction: &Point<K>) -> Result<Self, Unbuilt> {
        let pivot = Number::complex(1 + &crank, Number::zero());
        let rod = direction.scaled(&crank);
        let slider = 1 + &rod;
        let guides = [
            Guide::Circle {
                point: Number::one(),
                center: pivot.clone(),
            },
            Guide::Line {
                point: slider.clone(),
                normal: slider,
            },
        ];
        let canonical = closure::motion(&guides, 4)
            .and_then(|motion| Canonical::of(&motion))
            .ok_or_else(|| Unbuilt::NotReal("the coupler does not turn".to_owned()))?;
        Unbuilt::unless_true::<K>(canonical.pole.is_zero(), "the pole is the origin")?;
        Ok(Shape {
            crank,
            pivot,
            rod,
            canonical,
        })
    }

    fn slider(&self) -> Point<K> {
        1 + &self.rod
    }
}

/// Points in units of the diameter, seen from pole tangent and pole normal.
struct Places<K> {
    o_a: Point<K>,
    a: Point<K>,
    b: Point<K>,
    d: Point<K>,
}

impl<K: Kind> Places<K> {
    /// The center of the path of B.
    fn o_b(&self) -> Point<K> {
        let motion: Motion<K> = turning(&[Number::zero(), Number::i()], 2);
        let [x, y, w] = center_of_curvature(&motion.path_of(&self.b))
            .coordinates()
            .clone();
        Number::complex(x / &w, y / w)
    }

    /// The second point of the inflection circle that is as far from A as D.
    fn second_d(&self) -> Point<K> {
        let center = Number::i() / 2;
        line::mirror(&self.d, &self.a, &center)
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let crank = free.length("R/PA")?;
    let at_a = Angle::from_tan_half(&free.number("tan of half the turn from PA to AD")?);
    // More than 1: half of epsilon is less than 90°, and its cosine positive.
    let cot = 1 + free.length("cot epsilon/4 - 1")?;
    let half = Angle::from_tan_half(&cot.inverse());
    let epsilon = half.times(2);
    let shape = Shape::of(crank, &at_a.cis())?;
    let side = &shape.rod * epsilon.cis().conj();
    let point = 1 + &side;
    let scale = free
        .root("1/PA", &shape.canonical.diameter.norm())?
        .inverse();
    let at = |place: &Point<K>| shape.canonical.coordinates(place);
    let places = Places {
        o_a: at(&shape.pivot),
        a: at(&Number::one()),
        b: at(&point),
        d: at(&shape.slider()),
    };
    let mut length = |name: &str, way: &Point<K>| Ok(free.root(name, &way.norm())? * &scale);
    let pd = length("PD/PA", &shape.slider())?;
    let pb = length("PB/PA", &point)?;
    let n = length("BD/PA", &(&shape.rod - &side))?;
    let r = &shape.crank * &scale;
    let o_b = places.o_b();
    let mut bindings = Bindings::new(free.precision());
    let ray = |place: &Point<K>, length: &Number<K>| {
        Angle::of_known_length(place.clone(), length.clone())
    };
    let (alpha_a, alpha_b) = (ray(&places.a, &scale), ray(&places.b, &pb));
    let po_b = (places.b.conj() * &o_b).re() / &pb;
    bind_turns(&places, &o_b, &r, &mut bindings);
    bindings.bind("k", (&r + &scale) / alpha_a.sin());
    bindings.bind("alpha_a", alpha_a);
    bindings.bind("alpha_b", alpha_b);
    bindings.bind("alpha_d", ray(&places.d, &pd));
    bindings.bind("alpha_d'", Angle::of(places.second_d()));
    bindings.bind("epsilon", epsilon);
    for (name, value) in [
        ("O_bB", &po_b - &pb),
        ("PO_a", &r + &scale),
        ("PA", scale),
        ("PB", pb),
        ("PD", pd),
        ("PO_b", po_b),
        ("M", r.clone()),
        ("S", r.clone()),
        ("R", r),
        ("N", n),
    ] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}

/// The turns between crank, coupler and fixed link, and that from the axis of symmetry to the ray of D.
fn bind_turns<K: Real>(
    places: &Places<K>,
    o_b: &Point<K>,
    r: &Number<K>,
    bindings: &mut Bindings<K>,
) {
    let Places { o_a, a, b, d } = places;
    let (crank, link) = (a - o_a, o_b - o_a);
    let at_a = &crank * (d - a).conj();
    bindings.bind("Phi", Angle::of_known_length(at_a, r.square()));
    bindings.bind("phi", Angle::of(crank * link.conj()));
    let Positions { first, other } = mirrored_diagonal([o_a, o_b], [a, b], d);
    let axis = first + other - o_a * 2;
    bindings.bind("turn", Angle::of(d * axis.conj()));
}
