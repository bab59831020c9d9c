//! Twelve links that the poles give, and the four-bars of two of them.

use super::positions::Positions;
use crate::finite::pole_system::PAIRS;
use crate::number::{Number, Surd, Truth};
use crate::plane::{Point, relation};
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::Random;

pub const CHECK: Check = Check {
    name: "twelve-links-of-the-poles",
    summary: "Four random positions. The links are O_ij^1 Q_ij and Q_ij^1 O_ij for all six ij, \
              each as long in all four positions. Of the 66 four-bars of two of them exactly the \
              six with frame O_ij Q_ij have two sides that are together as long as the other two: \
              frame and link Q_ij O_ij^1 are equally long, and so are coupler and link O_ij \
              Q_ij^1; in position 1 they lie on each other exactly if ij contains 1. Lengths are \
              compared exactly, as sums of roots. The wrong variant compares the frame with the \
              other link.",
    run,
};

const INSTANCES: usize = 20;

/// A circlepoint, by its place in position 1, and its center.
struct Link {
    circlepoint: Point<Surd>,
    center: Point<Surd>,
}

impl Link {
    fn length_squared(&self) -> Number<Surd> {
        relation::distance_squared(&self.circlepoint, &self.center)
    }

    /// Whether it is as long in all four positions.
    fn keeps_its_length(&self, positions: &Positions<Surd>) -> Truth {
        let length = self.length_squared();
        Truth::all(positions.displacements.iter().map(|displacement| {
            let there = displacement.of(&self.circlepoint);
            relation::distance_squared(&there, &self.center).equals(&length)
        }))
    }
}

/// The links O¹_ij Q_ij and Q¹_ij O_ij of a pair of positions.
struct OfPair {
    from_pole: Link,
    to_pole: Link,
    has_position_1: bool,
}

impl OfPair {
    fn frame(&self) -> Number<Surd> {
        relation::distance_squared(&self.from_pole.center, &self.to_pole.center)
    }

    fn coupler(&self) -> Number<Surd> {
        relation::distance_squared(&self.from_pole.circlepoint, &self.to_pole.circlepoint)
    }

    fn is_as_stated(&self) -> Truth {
        let (frame, coupler) = (self.frame(), self.coupler());
        let pole_is_there = self.from_pole.circlepoint.equals(&self.to_pole.center);
        frame.equals(&self.from_pole.length_squared())
            & coupler.equals(&self.to_pole.length_squared())
            & pole_is_there.iff(self.has_position_1.into())
    }

    fn has_frame_as_long_as_the_other_link(&self) -> Truth {
        self.frame().equals(&self.to_pole.length_squared())
    }
}

fn run() -> Result<Report, Unbuilt> {
    let mut free = Random::new(1970);
    let mut holds = Truth::Yes;
    let mut wrong_variant = Truth::Yes;
    for _ in 0..INSTANCES {
        let positions = Positions::free(&mut free)?;
        let pairs = pairs(&positions);
        holds = holds
            & Truth::all(pairs.iter().map(OfPair::is_as_stated))
            & Truth::all(links(&pairs).map(|link| link.keeps_its_length(&positions)))
            & six_have_equal_sums(&pairs);
        let others = pairs.iter();
        wrong_variant =
            wrong_variant & Truth::all(others.map(OfPair::has_frame_as_long_as_the_other_link));
    }
    Ok(Report {
        holds,
        wrong_variant,
        basis: Basis::Instances,
        instances: INSTANCES,
        exception: None,
    })
}

fn pairs(positions: &Positions<Surd>) -> Vec<OfPair> {
    let Positions {
        poles,
        mirror_poles,
        ..
    } = positions;
    let (meets, mirror_meets) = (
        poles.meets_of_opposite_sides(),
        mirror_poles.meets_of_opposite_sides(),
    );
    let of_pair = |[i, j]: [usize; 2]| OfPair {
        from_pole: Link {
            circlepoint: mirror_poles.of(i, j).clone(),
            center: meets.of(i, j).clone(),
        },
        to_pole: Link {
            circlepoint: mirror_meets.of(i, j).clone(),
            center: poles.of(i, j).clone(),
        },
        has_position_1: i == 1,
    };
    PAIRS.into_iter().map(of_pair).collect()
}

fn links(pairs: &[OfPair]) -> impl Iterator<Item = &Link> {
    pairs
        .iter()
        .flat_map(|pair| [&pair.from_pole, &pair.to_pole])
}

/// Whether two links of one pair, and no others, make a four-bar with equal sums of two sides.
fn six_have_equal_sums(pairs: &[OfPair]) -> Truth {
    let links: Vec<&Link> = links(pairs).collect();
    let mut all = Truth::Yes;
    for (i, first) in links.iter().enumerate() {
        for (j, second) in links.iter().enumerate().skip(i + 1) {
            let of_one_pair = i / 2 == j / 2;
            all = all & has_equal_sums(first, second).iff(of_one_pair.into());
        }
    }
    all
}

/// Whether two sides of a four-bar are together as long as the other two. These are then the
/// shortest and the longest, or the others are.
fn has_equal_sums(first: &Link, second: &Link) -> Truth {
    let frame = relation::distance(&first.center, &second.center);
    let coupler = relation::distance(&first.circlepoint, &second.circlepoint);
    let a = relation::distance(&first.circlepoint, &first.center);
    let b = relation::distance(&second.circlepoint, &second.center);
    Truth::any([
        (&frame + &coupler).equals(&(&a + &b)),
        (&frame + &a).equals(&(&coupler + &b)),
        (&frame + &b).equals(&(&coupler + &a)),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A link from (x, 0).
    fn link(x: i64, circlepoint: [i64; 2]) -> Link {
        let [u, v] = circlepoint.map(Number::<Surd>::from);
        Link {
            circlepoint: Number::complex(u, v),
            center: Number::complex(x.into(), Number::zero()),
        }
    }

    #[test]
    fn sums_of_two_sides_are_compared_in_every_way() {
        // Base and coupler, base and first link, base and second link, each alone.
        let equal = [
            [link(0, [3, 0]), link(4, [-2, 0])],
            [link(0, [-1, 0]), link(4, [1, 0])],
            [link(4, [1, 0]), link(0, [-1, 0])],
        ];
        for [first, second] in &equal {
            assert!(has_equal_sums(first, second).is_yes());
        }
        let other = [link(0, [0, 5]), link(4, [4, 2])];
        assert!(has_equal_sums(&other[0], &other[1]).is_no());
    }

    #[test]
    fn holds_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
    }
}
