//! What the links can do.

use std::cmp::Ordering;

use super::driver::{Driver, Motion};
use super::{Drive, Joint, Passage};
use crate::number::{Number, Real};
use crate::plane::relation;

/// The type of a linkage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// The link at A₀ or at B₀ is the shortest and turns fully; the other one rocks.
    CrankAndLever,
    /// The base is the shortest; both links turn fully.
    DragLink,
    /// The coupler is the shortest and turns fully; both links rock.
    GrashofDoubleLever,
    /// No link turns fully against another.
    DoubleLever,
    /// All links can lie on one line, and the motion is not determined there.
    ChangePoint,
    /// One joint slides, its link turns fully: crank + offset < connecting rod.
    SliderCrank,
    /// One joint slides, and the link rocks.
    SliderRocker,
    /// A line of the coupler slides in a turning block, and the link turns fully.
    InvertedSliderCrank,
    /// A line of the coupler slides in a turning block, and the link rocks.
    InvertedSliderRocker,
    /// Both joints slide: the elliptic trammel.
    DoubleSlider,
    /// Two lines of the coupler slide in turning blocks: Oldham's coupling.
    TwoTurningBlocks,
    /// One joint slides, and a line of the coupler slides in a turning block: Rapson's slide.
    SliderAndTurningBlock,
}

impl<K: Real> Passage<K> {
    /// The lengths A₀A, AB, BB₀, A₀B₀ of a four-bar; no value where the kind does not hold the roots.
    pub fn lengths(&self) -> Option<[Number<K>; 4]> {
        let [p, q] = &self.pivots;
        let [a, b] = self.joints.first()?;
        let distance =
            |x: &Joint<K>, y: &Joint<K>| Some(relation::distance(x.point()?, y.point()?));
        Some([
            distance(p, a)?,
            distance(a, b)?,
            distance(b, q)?,
            distance(p, q)?,
        ])
    }

    /// The type; `None` where it cannot be told.
    pub fn link_type(&self) -> Option<Type> {
        use Joint::{At, Towards};
        let [p, q] = &self.pivots;
        let [a, b] = self.joints.first()?;
        match [p, a, b, q] {
            [At(_), At(_), At(_), At(_)] => four_bar_type(&self.lengths()?),
            [Towards(_), _, _, Towards(_)] => Some(Type::DoubleSlider),
            [_, Towards(_), Towards(_), _] => Some(Type::TwoTurningBlocks),
            [Towards(_), _, Towards(_), _] | [_, Towards(_), _, Towards(_)] => {
                Some(Type::SliderAndTurningBlock)
            }
            [At(_), At(_), At(_), Towards(_)] => self.with_a_slide(Drive::First),
            [Towards(_), At(_), At(_), At(_)] => self.with_a_slide(Drive::Second),
            [At(_), At(_), Towards(_), At(_)] => self.with_a_block(Drive::First),
            [At(_), Towards(_), At(_), At(_)] => self.with_a_block(Drive::Second),
            // A pair with both points at infinity is none.
            [Towards(_), Towards(_), At(_), At(_)] | [At(_), At(_), Towards(_), Towards(_)] => None,
        }
    }

    fn with_a_slide(&self, link: Drive) -> Option<Type> {
        self.by_link(link, [Type::SliderCrank, Type::SliderRocker])
    }

    fn with_a_block(&self, link: Drive) -> Option<Type> {
        self.by_link(
            link,
            [Type::InvertedSliderCrank, Type::InvertedSliderRocker],
        )
    }

    fn by_link(&self, link: Drive, [crank, rocker]: [Type; 2]) -> Option<Type> {
        let driver = Driver::of(self, link)?;
        let Motion::Turn(turn) = &driver.motion else {
            return None;
        };
        let [inner, outer] = driver.rooms(turn);
        Some(match (inner?, outer?) {
            (Ordering::Equal, _) | (_, Ordering::Equal) => Type::ChangePoint,
            (Ordering::Greater, Ordering::Greater) => crank,
            _ => rocker,
        })
    }

    /// Whether the driving link turns fully, perhaps through change points; a slider never does.
    /// `None` where it cannot be told.
    pub fn is_crank(&self, drive: Drive) -> Option<bool> {
        let driver = Driver::of(self, drive)?;
        let Motion::Turn(turn) = &driver.motion else {
            return Some(false);
        };
        match driver.rooms(turn) {
            [Some(Ordering::Less), _] | [_, Some(Ordering::Less)] => Some(false),
            [Some(_), Some(_)] => Some(true),
            _ => None,
        }
    }
}

/// The type of a four-bar by its lengths A₀A, AB, BB₀, A₀B₀; `None` where it cannot be told.
///
/// By the signs of the sums of two lengths against the others: only a change point has one of zero.
/// In a linkage with a shortest link that turns fully, this one and any other are together shorter
/// than the remaining two.
pub fn four_bar_type<K: Real>([a, c, b, d]: &[Number<K>; 4]) -> Option<Type> {
    use Ordering::{Equal, Greater, Less};
    let sums_with_a = [
        (a + b - c - d).sign()?,
        (a + c - b - d).sign()?,
        (a + d - b - c).sign()?,
    ];
    Some(match sums_with_a {
        [Equal, ..] | [_, Equal, _] | [.., Equal] => Type::ChangePoint,
        [Less, Less, Less] | [Less, Greater, Greater] => Type::CrankAndLever,
        [Greater, Less, Greater] => Type::GrashofDoubleLever,
        [Greater, Greater, Less] => Type::DragLink,
        _ => Type::DoubleLever,
    })
}
