//! Chapter IV: four-bars whose coupler curve is symmetrical.

use crate::formula::Bindings;
use crate::number::poly::Fraction;
use crate::number::{Kind, Number, Real, Truth};
use crate::plane::displacement::Displacement;
use crate::plane::line;
use crate::plane::{Angle, Point};
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::{Symbols, point};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/symmetrical-coupler-curve",
    "Any four-bar in any position whose crank O_aA is as long as AB and AD. In its other position the diagonal \
     O_aB is mirrored in the fixed link, and A is not.",
    build,
    [
        "O_a": "pivot of the crank A",
        "O_b": "pivot of the crank B",
        "epsilon": "turn that leads from AB to AD, counterclockwise",
        "D": "coupler point",
        "D'": "coupler point in the other position",
    ]
);

pub const CHECK: Check = Check {
    name: "symmetrical-coupler-curves",
    summary: "For all four-bars with R = M = S in all positions: the point D of another position, in which the \
              diagonal O_aB is mirrored in the fixed link, is the mirror image of D in one line, that through \
              O_a at half the coupler's angle from the fixed link. The wrong variant has M ≠ R.",
    run,
};

/// Two positions of a four-bar: crank pin and coupler point.
pub(super) struct Positions<K> {
    pub first: Point<K>,
    pub other: Point<K>,
}

/// Of a four-bar with O_aA = AB: the diagonal O_aB mirrored in the fixed link, A on the other side of it
/// than its mirror image would be.
pub(super) fn mirrored_diagonal<K: Kind>(
    [pivot, other_pivot]: [&Point<K>; 2],
    [a, b]: [&Point<K>; 2],
    d: &Point<K>,
) -> Positions<K> {
    let mirror = |point: &Point<K>| line::mirror(point, pivot, other_pivot);
    let diagonal = mirror(b);
    let pin = pivot + &diagonal - mirror(a);
    let moved = Displacement::carrying(&[a.clone(), b.clone()], &[pin, diagonal]);
    Positions {
        first: d.clone(),
        other: moved.of(d),
    }
}

struct FourBar<K> {
    pivots: [Point<K>; 2],
    epsilon: Angle<K>,
    positions: Positions<K>,
}

/// With AD = `side` of the crank's length.
fn four_bar<K: Real>(free: &mut dyn Free<K>, side: &Number<K>) -> Result<FourBar<K>, Unbuilt> {
    let pivots = [point(free, "O_a")?, point(free, "O_b")?];
    let length = free.length("R")?;
    let (crank, coupler) = (
        free.angle("direction of the crank")?,
        free.angle("direction of AB")?,
    );
    let epsilon = free.angle("epsilon")?;
    let a = &pivots[0] + crank.cis().scaled(&length);
    let b = &a + coupler.cis().scaled(&length);
    let d = &a + (coupler.cis() * epsilon.cis()).scaled(&(length * side));
    let positions = mirrored_diagonal(pivots.each_ref(), [&a, &b], &d);
    Ok(FourBar {
        pivots,
        epsilon,
        positions,
    })
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let FourBar {
        pivots: [o_a, o_b],
        epsilon,
        positions,
    } = four_bar(free, &Number::one())?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("O_a", o_a);
    bindings.bind("O_b", o_b);
    bindings.bind("epsilon", epsilon);
    bindings.bind("D", positions.first);
    bindings.bind("D'", positions.other);
    Ok(bindings)
}

fn run() -> Result<Report, Unbuilt> {
    let is_symmetrical = |side: &dyn Fn(&mut Symbols) -> Result<Number<Fraction>, Unbuilt>| {
        let mut free = Symbols::default();
        let side = side(&mut free)?;
        Ok(symmetrical(&four_bar(&mut free, &side)?))
    };
    Ok(Report {
        holds: is_symmetrical(&|_| Ok(Number::one()))?,
        wrong_variant: is_symmetrical(&|free| free.length("M/R"))?,
        basis: Basis::Identity,
        instances: 0,
        exception: None,
    })
}

/// Whether D' is the mirror image of D: z' = e^{iε} e^{2iφ} z̄ for the fixed link's direction φ.
fn symmetrical<K: Real>(linkage: &FourBar<K>) -> Truth {
    let FourBar {
        pivots: [o_a, o_b],
        epsilon,
        positions,
    } = linkage;
    let link = o_b - o_a;
    let [d, other] = [&positions.first, &positions.other].map(|point| point - o_a);
    (other * link.conj()).equals(&(epsilon.cis() * link * d.conj()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_holds_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
    }
}
