//! Figures 5 to 7: circlepoints and centers from a position of the pole four-bar.

use super::positions::{Positions, free_poles};
use crate::finite::pole_four_bar::{Joints, PoleFourBar};
use crate::formula::Bindings;
use crate::number::{Number, Real, array};
use crate::plane::projective::ProjectivePoint;
use crate::plane::{Point, line};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1970/construction",
    "Four positions, and a position of the four-bar O12 O23 O34 O14 of their poles. So that all is \
     rational, the poles O12, O13, O14 are free and the turns about them are such that a point \
     keeps its distance from a center; l' and l are the mirror images of O23 and O34 in the lines \
     from O12 and O14 to the center. M' and K' are constructed from l' and l. The center is the \
     origin and the point 1, which only moves and scales the figure.",
    build,
    [
        "O_12": "pole of the positions 1 and 2",
        "O_13": "pole of the positions 1 and 3",
        "O_14": "pole of the positions 1 and 4",
        "O_23": "pole of the positions 2 and 3",
        "O_24": "pole of the positions 2 and 4",
        "O_34": "pole of the positions 3 and 4",
        "O_23'": "mirror pole O_23^1, the pole of the moving plane in position 1",
        "O_24'": "mirror pole O_24^1",
        "O_34'": "mirror pole O_34^1",
        "phi_12": "turn from position 1 to position 2",
        "phi_13": "turn from position 1 to position 3",
        "phi_14": "turn from position 1 to position 4",
        "l": "the joint of the link at O14, moved away from O34",
        "l'": "the joint of the link at O12 for it",
        "M'": "where the midnormals m of O23 l' and O34 l meet",
        "K'": "where the midnormals k of O23^1 l' and O34^1 l meet",
    ]
);

pub const BOTH_PLACES: Scene = scene!(
    "filemon1970/construction-of-both-pairs",
    "Four positions and a position of the four-bar of their poles as in the scene construction, \
     and the other place that the bars allow the joint of the link at O12 for the same l. The \
     center and the point that keeps its distance from it are free.",
    build_both_places,
    not symbolic: "polynomials as large as those of the second place",
    [
        "O_12": "pole of the positions 1 and 2",
        "O_13": "pole of the positions 1 and 3",
        "O_14": "pole of the positions 1 and 4",
        "O_23": "pole of the positions 2 and 3",
        "O_24": "pole of the positions 2 and 4",
        "O_34": "pole of the positions 3 and 4",
        "O_23'": "mirror pole O_23^1, the pole of the moving plane in position 1",
        "O_24'": "mirror pole O_24^1",
        "O_34'": "mirror pole O_34^1",
        "phi_12": "turn from position 1 to position 2",
        "phi_13": "turn from position 1 to position 3",
        "phi_14": "turn from position 1 to position 4",
        "l": "the joint of the link at O14, moved away from O34",
        "l'": "a place of the joint of the link at O12 for it",
        "l''": "the other place",
        "M'": "where the midnormals of O23 l' and O34 l meet",
        "K'": "where the midnormals of O23^1 l' and O34^1 l meet",
        "M''": "where the midnormals of O23 l'' and O34 l meet",
        "K''": "where the midnormals of O23^1 l'' and O34^1 l meet",
    ]
);

/// A four-bar of poles, in another position than those of the poles.
struct Moved<K> {
    positions: Positions<K>,
    four_bar: PoleFourBar<K>,
    joints: Joints<K>,
}

impl<K: Real> Moved<K> {
    fn free(
        free: &mut dyn Free<K>,
        center: &Point<K>,
        circlepoint: &Point<K>,
    ) -> Result<Self, Unbuilt> {
        let poles = free_poles(free)?;
        let half_tangents = poles.each_ref().map(|pole| {
            // The pole sees the center half-way from the circlepoint to its place after the turn.
            let half = (center - pole) * (circlepoint - pole).conj();
            half.im() / half.re()
        });
        let positions = Positions::of(poles, half_tangents);
        let four_bar = PoleFourBar::of(&positions.poles, &positions.mirror_poles, [2, 3, 4]);
        let joints = array::pairs(&four_bar.poles, &four_bar.frame)
            .map(|(pole, frame)| line::mirror(pole, frame, center));
        Ok(Moved {
            positions,
            four_bar,
            joints,
        })
    }

    /// The joints with the first one at its other place for the same second one.
    fn other_joints(&self) -> Joints<K> {
        let [first, second] = &self.joints;
        let other = line::mirror(first, &self.four_bar.frame[0], second);
        [other, second.clone()]
    }

    fn bind(&self, bindings: &mut Bindings<K>) -> Result<(), Unbuilt> {
        self.positions.bind(bindings);
        bindings.bind("l", self.joints[1].clone());
        self.bind_pair(&self.joints, "'", bindings)
    }

    fn bind_pair(
        &self,
        joints: &Joints<K>,
        primes: &str,
        bindings: &mut Bindings<K>,
    ) -> Result<(), Unbuilt> {
        let pair = self.four_bar.pair(joints);
        bindings.bind(&format!("l{primes}"), joints[0].clone());
        bindings.bind(&format!("M{primes}"), finite(&pair.center)?);
        bindings.bind(&format!("K{primes}"), finite(&pair.circlepoint)?);
        Ok(())
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let mut bindings = Bindings::new(free.precision());
    Moved::free(free, &Number::zero(), &Number::one())?.bind(&mut bindings)?;
    Ok(bindings)
}

fn build_both_places<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (center, circlepoint) = (point(free, "a center")?, point(free, "its circlepoint")?);
    let moved = Moved::free(free, &center, &circlepoint)?;
    let mut bindings = Bindings::new(free.precision());
    moved.bind(&mut bindings)?;
    moved.bind_pair(&moved.other_joints(), "''", &mut bindings)?;
    Ok(bindings)
}

/// A point that the construction must find in the finite.
pub fn finite<K: Real>(point: &ProjectivePoint<K>) -> Result<Point<K>, Unbuilt> {
    let parallel = || Unbuilt::NotReal("two midnormals are parallel".to_owned());
    point.finite().ok_or_else(parallel)
}
