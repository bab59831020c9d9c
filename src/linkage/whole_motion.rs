//! A four-bar over its whole motion: where its cranks come to a dead centre, how far they turn, between
//! which transmission angles, and in how many circuits.
//!
//! Of the four-bar M, A, B, N one of the links MA and NB drives, the other one is driven; f is the
//! diagonal from the driving pin to the other pivot, with the coupler c and the driven link b in a
//! triangle: |b − c| ≤ f ≤ b + c. It grows with the angle between the driving link and the base, from
//! |d − a| to d + a.

use super::four_bar::{FourBar, Position};
use super::passage::{Drive, Type, four_bar_type};
use crate::number::{Kind, Number, Real, Truth};
use crate::plane::Point;

/// How coupler and driven link are on one line in a dead centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Alignment {
    /// f = b + c.
    Stretched,
    /// f = |b − c|.
    Folded,
}

impl Alignment {
    /// Both.
    pub const ALL: [Alignment; 2] = [Alignment::Stretched, Alignment::Folded];

    fn sign(self) -> i64 {
        match self {
            Alignment::Stretched => 1,
            Alignment::Folded => -1,
        }
    }
}

/// Two positions, mirrored at the base, in which coupler and driven link are on one line.
#[derive(Clone, Debug)]
pub struct DeadCentre<K> {
    /// How they are.
    pub alignment: Alignment,
    /// cos of the angle from the base MN to the driving link, MA or NB.
    pub cosine: Number<K>,
}

/// How far a driving link turns from the direction of the base MN.
#[derive(Clone, Debug)]
pub struct Limits<K> {
    /// cos of the least angle; `None` where it comes into the direction of the base.
    pub least: Option<Number<K>>,
    /// cos of the greatest angle up to 180°; `None` where it comes into the opposite direction.
    pub greatest: Option<Number<K>>,
}

/// The parts of a linkage for one of its drives.
struct Parts<'a, K> {
    driving: &'a Number<K>,
    driven: &'a Number<K>,
    coupler: &'a Number<K>,
    base: &'a Number<K>,
    /// 1 for the link at M; −1 for that at N, whose angle is counted from the base prolonged.
    sign: i64,
}

impl<K: Kind> FourBar<K> {
    fn parts(&self, drive: Drive) -> Parts<'_, K> {
        let (driving, driven, sign) = match drive {
            Drive::First => (&self.a, &self.b, 1),
            Drive::Second => (&self.b, &self.a, -1),
        };
        Parts {
            driving,
            driven,
            coupler: &self.c,
            base: &self.d,
            sign,
        }
    }

    /// cos of the angle from the base to the driving link where coupler and driven link are on one
    /// line; beyond ±1 where they never are.
    pub fn cosine_of_alignment(&self, drive: Drive, alignment: Alignment) -> Number<K> {
        let Parts {
            driving,
            driven,
            coupler,
            base,
            sign,
        } = self.parts(drive);
        let diagonal = driven + alignment.sign() * coupler;
        let sum = base.square() + driving.square() - diagonal.square();
        sign * sum / (2 * base * driving)
    }

    /// The position where the driving link has a direction, of length 1, in which coupler and driven
    /// link are on one line.
    pub fn aligned(&self, drive: Drive, alignment: Alignment, direction: &Point<K>) -> Position<K> {
        let Parts {
            driving,
            driven,
            coupler,
            ..
        } = self.parts(drive);
        let part = driven / (driven + alignment.sign() * coupler);
        let arm = direction.scaled(driving);
        let base: Point<K> = self.d.clone().into();
        match drive {
            Drive::First => Position {
                b: &base + (&arm - &base).scaled(&part),
                a: arm,
            },
            Drive::Second => {
                let b = base + arm;
                Position {
                    a: b.scaled(&part),
                    b,
                }
            }
        }
    }
}

impl<K: Real> FourBar<K> {
    /// Whether it can be assembled and moves: each bar is shorter than the other three together.
    pub fn moves(&self) -> Truth {
        let FourBar { a, b, c, d } = self;
        let whole = a + b + c + d;
        Truth::all([a, b, c, d].map(|bar| (&whole - 2 * bar).is_positive()))
    }

    /// The type; `None` where it cannot be told.
    pub fn link_type(&self) -> Option<Type> {
        let [a, b, c, d] = [&self.a, &self.b, &self.c, &self.d].map(Number::clone);
        four_bar_type(&[a, c, b, d])
    }

    /// How many circuits there are: two where the shortest and the longest bar are together shorter
    /// than the others (Grashof), else one; the two of a change point meet there. `None` where that
    /// cannot be told.
    pub fn circuits(&self) -> Option<usize> {
        Some(match self.link_type()? {
            Type::CrankAndLever | Type::DragLink | Type::GrashofDoubleLever => 2,
            _ => 1,
        })
    }

    /// The positions with all bars on one line. `None` where that cannot be told.
    pub fn change_points(&self) -> Option<Vec<Position<K>>> {
        let mut found = Vec::new();
        for [sa, sc, sb] in signs() {
            let (a, b) = (sa * &self.a, &self.d + sb * &self.b);
            match (&a + sc * &self.c - &b).is_zero() {
                Truth::Yes => found.push(Position {
                    a: a.into(),
                    b: b.into(),
                }),
                Truth::No => {}
                Truth::Unknown => return None,
            }
        }
        Some(found)
    }

    /// The dead centres of a drive, change points aside. `None` where that cannot be told.
    pub fn dead_centres(&self, drive: Drive) -> Option<Vec<DeadCentre<K>>> {
        let mut found = Vec::new();
        for alignment in Alignment::ALL {
            let cosine = self.cosine_of_alignment(drive, alignment);
            if (1 - cosine.square()).sign()?.is_gt() {
                found.push(DeadCentre { alignment, cosine });
            }
        }
        Some(found)
    }

    /// How far a driving link turns. `None` where that cannot be told.
    pub fn limits(&self, drive: Drive) -> Option<Limits<K>> {
        let [stretched, folded] =
            Alignment::ALL.map(|alignment| self.cosine_of_alignment(drive, alignment));
        let (nearest, farthest) = match drive {
            Drive::First => (folded, stretched),
            Drive::Second => (stretched, folded),
        };
        let least = (1 - &nearest).sign()?.is_gt().then_some(nearest);
        let greatest = (&farthest + 1).sign()?.is_gt().then_some(farthest);
        Some(Limits { least, greatest })
    }

    /// Whether a driving link turns fully, perhaps through change points. `None` where that cannot be
    /// told.
    pub fn turns_fully(&self, drive: Drive) -> Option<bool> {
        let limits = self.limits(drive)?;
        Some(limits.least.is_none() && limits.greatest.is_none())
    }

    /// cos of the least and of the greatest transmission angle, between coupler and driven link. `None`
    /// where it cannot be told which they are.
    pub fn transmission(&self, drive: Drive) -> Option<[Number<K>; 2]> {
        let Parts {
            driving,
            driven,
            coupler,
            base,
            ..
        } = self.parts(drive);
        let [near, closed] = [base - driving, driven - coupler].map(|x| x.square());
        let [far, open] = [base + driving, driven + coupler].map(|x| x.square());
        let greater = |x: Number<K>, y: Number<K>| Some(if x.compare(&y)?.is_lt() { y } else { x });
        let lesser = |x: Number<K>, y: Number<K>| Some(if x.compare(&y)?.is_lt() { x } else { y });
        let cosine = |square: Number<K>| {
            (driven.square() + coupler.square() - square) / (2 * driven * coupler)
        };
        Some([cosine(greater(near, closed)?), cosine(lesser(far, open)?)])
    }
}

/// All choices of three signs.
fn signs() -> impl Iterator<Item = [i64; 3]> {
    let sign = |bits: i64, place: u32| if bits >> place & 1 == 0 { 1 } else { -1 };
    (0..8).map(move |bits| [0, 1, 2].map(|place| sign(bits, place)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linkage::passage::{Joint, Passage};
    use crate::number::Surd;
    use crate::plane::relation;
    use proptest::prelude::*;

    fn four_bar([a, b, c, d]: [i64; 4]) -> FourBar<Surd> {
        FourBar {
            a: a.into(),
            b: b.into(),
            c: c.into(),
            d: d.into(),
        }
    }

    fn lengths() -> impl Strategy<Value = [i64; 4]> {
        proptest::array::uniform4(1i64..=9)
    }

    /// A linkage in a position of its first crank in which it closes.
    fn passage(bars: &FourBar<Surd>) -> Option<Passage<Surd>> {
        let crank = (0..12).find_map(|step| {
            let turn = crate::plane::Angle::from_degrees(&rug::Rational::from(15 * step), &())?;
            // The square root of a sum of roots is not always such a sum.
            bars.with_crank(&turn.cis())
        });
        let [Position { a, b }, _] = crank?;
        let at = Joint::At;
        Some(Passage {
            pivots: [at(Point::zero()), at(bars.d.clone().into())],
            joints: vec![[at(a), at(b)]],
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, cases: 64, ..ProptestConfig::default() })]

        #[test]
        fn in_a_dead_centre_the_linkage_closes_on_a_line(lengths in lengths()) {
            let bars = four_bar(lengths);
            for drive in Drive::ALL {
                for DeadCentre { alignment, cosine } in bars.dead_centres(drive).unwrap() {
                    let sine = (1 - cosine.square()).sqrt();
                    let direction = Number::complex(cosine, sine);
                    let Position { a, b } = bars.aligned(drive, alignment, &direction);
                    let n: Point<Surd> = bars.d.clone().into();
                    let m = Point::zero();
                    for (x, y, bar) in [(&m, &a, &bars.a), (&a, &b, &bars.c), (&n, &b, &bars.b)] {
                        let square = relation::distance_squared(x, y);
                        prop_assert!(square.equals(&bar.square()).is_yes());
                    }
                    let line = match drive {
                        Drive::First => [a, b, n],
                        Drive::Second => [b, a, m],
                    };
                    prop_assert!(relation::collinear(&line).is_yes());
                }
            }
        }

        #[test]
        fn it_is_as_it_passes_through_a_position(lengths in lengths()) {
            let bars = four_bar(lengths);
            prop_assume!(bars.moves().is_yes());
            let Some(passage) = passage(&bars) else { return Ok(()) };
            prop_assert_eq!(bars.link_type(), passage.link_type());
            for drive in Drive::ALL {
                prop_assert_eq!(bars.turns_fully(drive), passage.is_crank(drive));
                if bars.turns_fully(drive) == Some(true) {
                    prop_assert!(bars.dead_centres(drive).unwrap().is_empty());
                    if bars.link_type() == Some(Type::ChangePoint) {
                        // From the one position alone the passage does not go through change points.
                        continue;
                    }
                    let [here, there] = [bars.transmission(drive), passage.transmission(drive)];
                    for (x, y) in here.unwrap().iter().zip(there.unwrap()) {
                        prop_assert!(x.equals(&y).is_yes());
                    }
                } else {
                    // It turns back in dead centres, with γ = 0 or 180°.
                    let ends = bars.transmission(drive).unwrap();
                    prop_assert!(ends.iter().any(|cosine| cosine.square().equals(&Number::one()).is_yes()));
                }
            }
        }

        /// Two circuits are those of the two assemblies of a crank, or of two mirrored ranges.
        #[test]
        fn circuits_by_grashof(lengths in lengths()) {
            let bars = four_bar(lengths);
            prop_assume!(bars.moves().is_yes());
            let mut sorted = lengths;
            sorted.sort_unstable();
            let [least, second, third, most] = sorted;
            let expected = if least + most < second + third { 2 } else { 1 };
            prop_assert_eq!(bars.circuits(), Some(expected));
            let flat = bars.change_points().unwrap();
            prop_assert_eq!(flat.is_empty(), least + most != second + third);
            prop_assert_eq!(flat.is_empty(), bars.link_type() != Some(Type::ChangePoint));
        }
    }

    #[test]
    fn a_crank_and_lever_and_a_double_lever() {
        let crank = four_bar([2, 4, 4, 5]);
        assert_eq!(crank.turns_fully(Drive::First), Some(true));
        assert_eq!(crank.turns_fully(Drive::Second), Some(false));
        let limits = crank.limits(Drive::Second).unwrap();
        assert!(limits.least.is_some() && limits.greatest.is_some());
        let lever = four_bar([4, 4, 7, 5]);
        for drive in Drive::ALL {
            assert_eq!(lever.turns_fully(drive), Some(false));
        }
        assert_eq!(lever.circuits(), Some(1));
    }

    #[test]
    fn a_longer_bar_than_the_others_together_does_not_move() {
        assert!(four_bar([1, 2, 3, 7]).moves().is_no());
        assert!(four_bar([1, 2, 3, 6]).moves().is_no());
        assert!(four_bar([1, 2, 3, 5]).moves().is_yes());
    }

    #[test]
    fn change_points_of_a_parallelogram_and_a_rhombus() {
        assert_eq!(four_bar([2, 2, 5, 5]).change_points().unwrap().len(), 2);
        assert_eq!(four_bar([2, 2, 2, 2]).change_points().unwrap().len(), 3);
        assert_eq!(four_bar([2, 3, 4, 3]).change_points().unwrap().len(), 1);
    }
}
