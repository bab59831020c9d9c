//! Four positions of the moving plane, whose frame is laid on the fixed one in position 1.

use crate::finite::pole_system::{OfPairs, PAIRS};
use crate::formula::Bindings;
use crate::number::{Number, Real, array};
use crate::plane::displacement::Displacement;
use crate::plane::{Angle, Point};
use crate::scenes::free::point;
use crate::scenes::{Free, Unbuilt};

/// Four positions by what leads from the first to the others.
pub struct Positions<K> {
    pub displacements: [Displacement<K>; 4],
    /// φ_12, φ_13, φ_14: the turns from position 1.
    pub turns: [Angle<K>; 3],
    pub poles: OfPairs<K>,
    pub mirror_poles: OfPairs<K>,
}

impl<K: Real> Positions<K> {
    /// Any four positions none of which is translated from the first: by the poles O_12, O_13, O_14
    /// and the turns about them.
    pub fn free(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let mut half_tangent = |j: u8| free.number(&format!("tan phi_1{j}/2"));
        let half_tangents = [half_tangent(2)?, half_tangent(3)?, half_tangent(4)?];
        Ok(Self::of(free_poles(free)?, half_tangents))
    }

    /// By the poles O_12, O_13, O_14 and the tangents of half the turns about them.
    pub fn of(poles: [Point<K>; 3], half_tangents: [Number<K>; 3]) -> Self {
        let turns = half_tangents.each_ref().map(Angle::from_tan_half);
        let [first, second, third] =
            array::pairs(&poles, &turns).map(|(pole, turn)| Displacement::about(pole, turn.cis()));
        let displacements = [Displacement::identity(), first, second, third];
        Positions {
            poles: OfPairs::poles(&displacements),
            mirror_poles: OfPairs::mirror_poles(&displacements),
            displacements,
            turns,
        }
    }

    /// Binds the poles, the mirror poles that are not poles, and the turns from position 1.
    pub fn bind(&self, bindings: &mut Bindings<K>) {
        for (j, turn) in (2..).zip(&self.turns) {
            bindings.bind(&format!("phi_1{j}"), turn.clone());
        }
        for [i, j] in PAIRS {
            bindings.bind(&format!("O_{i}{j}"), self.poles.of(i, j).clone());
            if i > 1 {
                let mirror_pole = self.mirror_poles.of(i, j).clone();
                bindings.bind(&format!("O_{i}{j}'"), mirror_pole);
            }
        }
    }
}

/// O_12, O_13 and O_14.
pub fn free_poles<K: Real>(free: &mut dyn Free<K>) -> Result<[Point<K>; 3], Unbuilt> {
    let mut pole = |j: u8| point(free, &format!("O_1{j}"));
    Ok([pole(2)?, pole(3)?, pole(4)?])
}
