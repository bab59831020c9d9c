//! Chapter VI: which links of a four-bar turn fully against each other.

use super::sense::sense;
use crate::formula::Bindings;
use crate::linkage::four_bar::FourBar;
use crate::linkage::passage::Drive;
use crate::number::{Number, Real, Truth};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/grashof",
    "Any four-bar that can be assembled. Two of its links turn fully against each other where the two other \
     ones close a triangle with them for every angle between them. The links are named a, b, c, d in any way \
     in which a, b and c, d are opposing links.",
    build, not symbolic: "whether links turn fully",
    [
        "Q": "length of the fixed link",
        "R": "length of a control crank",
        "S": "length of the coupler link",
        "T": "length of the other control crank",
        "a": "length of the link that is named so",
        "b": "length of the link opposite to it",
        "c": "length of one of the two others",
        "d": "length of the link opposite to that one",
        "m": "length of the shortest link",
        "n": "how many of the six pairs of links turn fully against each other",
        "n_m": "against how many of the three others the shortest link turns fully",
        "crank_R": "+1 where R turns fully against the fixed link, -1 where it does not",
        "crank_T": "+1 where T turns fully against the fixed link, -1 where it does not",
    ]
);

pub const IN_ORDER: Scene = scene!(
    "tesar1964/grashof-in-order",
    "The same, with the names that a + b > c + d, a > b, and c > d ask for.",
    build_in_order, not symbolic: "whether links turn fully",
    [
        "Q": "length of the fixed link",
        "R": "length of a control crank",
        "S": "length of the coupler link",
        "T": "length of the other control crank",
        "a": "length of the longer link of the pair of opposing links with the larger sum",
        "b": "length of the link opposite to it",
        "c": "length of the longer one of the two others",
        "d": "length of the link opposite to that one",
        "m": "length of the shortest link",
        "n": "how many of the six pairs of links turn fully against each other",
        "n_m": "against how many of the three others the shortest link turns fully",
        "crank_R": "+1 where R turns fully against the fixed link, -1 where it does not",
        "crank_T": "+1 where T turns fully against the fixed link, -1 where it does not",
    ]
);

/// The links Q, R, S, T; those two places apart are opposing.
pub(super) struct Links<K>(pub [Number<K>; 4]);

/// Other names for the same opposing links, by their places.
const EXCHANGES: [(&str, [usize; 4]); 3] = [
    ("a, b for c, d", [2, 3, 0, 1]),
    ("a for b", [1, 0, 2, 3]),
    ("c for d", [0, 1, 3, 2]),
];

/// Q against R, S, T; R against S, T; S against T.
const PAIRS: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

impl<K: Real> Links<K> {
    /// Any links that can be assembled.
    fn of(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let links = Links([
            free.length("Q")?,
            free.length("R")?,
            free.length("S")?,
            free.length("T")?,
        ]);
        Unbuilt::unless_real(links.four_bar().moves(), "the links cannot be assembled")?;
        Ok(links)
    }

    /// The link in one of the places 0 to 3.
    #[expect(
        clippy::indexing_slicing,
        reason = "all places in this file are below 4"
    )]
    pub(super) fn at(&self, place: usize) -> &Number<K> {
        &self.0[place]
    }

    /// The pair of the larger sum first, the longer link of each first.
    pub(super) fn in_order(&self) -> Option<[usize; 4]> {
        let [q, r, s, t] = &self.0;
        let [first, second] = [(q, s, [0, 2]), (r, t, [1, 3])].map(|(x, y, [i, j])| {
            let order = x.compare(y)?;
            Some(if order.is_lt() { [j, i] } else { [i, j] })
        });
        let ([a, b], [c, d]) = (first?, second?);
        let order = (q + s).compare(&(r + t))?;
        Some(if order.is_lt() {
            [c, d, a, b]
        } else {
            [a, b, c, d]
        })
    }

    /// With the names a, b, c, d for the links in these places.
    fn named(self, free: &dyn Free<K>, named: [usize; 4]) -> Result<Bindings<K>, Unbuilt> {
        let mut bindings = Bindings::new(free.precision());
        for (name, count) in [
            ("n", self.count_of_all()),
            ("n_m", self.count_of_shortest()),
        ] {
            bindings.bind(name, Number::<K>::from(count.ok_or_else(untold)?));
        }
        let shortest = self.shortest().ok_or_else(untold)?;
        bindings.bind("m", self.at(shortest).clone());
        for (name, place) in ["a", "b", "c", "d"].into_iter().zip(named) {
            bindings.bind(name, self.at(place).clone());
        }
        self.bind(&mut bindings)?;
        Ok(bindings)
    }

    /// The lengths, and which of R and T are cranks.
    pub(super) fn bind(self, bindings: &mut Bindings<K>) -> Result<(), Unbuilt> {
        let four_bar = self.four_bar();
        for (name, drive) in [("crank_R", Drive::First), ("crank_T", Drive::Second)] {
            let sign = match four_bar.turns_fully(drive) {
                Some(true) => 1,
                Some(false) => -1,
                None => return Err(untold()),
            };
            bindings.bind(name, Number::<K>::from(sign));
        }
        for (name, length) in ["Q", "R", "S", "T"].into_iter().zip(self.0) {
            bindings.bind(name, length);
        }
        Ok(())
    }

    pub(super) fn four_bar(&self) -> FourBar<K> {
        let [d, a, c, b] = self.0.clone();
        FourBar { a, b, c, d }
    }

    /// Whether two links turn fully against each other: in a closed chain all pairs are alike, so they
    /// take the place of coupler and base.
    fn turn_fully(&self, pair: [usize; 2]) -> Truth {
        let [c, d] = pair.map(|place| self.at(place).clone());
        let mut others = (0..4).filter(|place| !pair.contains(place));
        let mut other = || {
            others
                .next()
                .map_or_else(Number::zero, |place| self.at(place).clone())
        };
        FourBar {
            a: other(),
            b: other(),
            c,
            d,
        }
        .coupler_turns()
    }

    fn shortest(&self) -> Option<usize> {
        let mut shortest = 0;
        for place in 1..4 {
            if self.at(place).compare(self.at(shortest))?.is_lt() {
                shortest = place;
            }
        }
        Some(shortest)
    }

    /// Against how many of the others the shortest link turns fully.
    pub(super) fn count_of_shortest(&self) -> Option<i64> {
        let shortest = self.shortest()?;
        let others = (0..4).filter(|place| *place != shortest);
        self.count(others.map(|place| [shortest, place]))
    }

    /// How many pairs of links turn fully against each other.
    pub(super) fn count_of_all(&self) -> Option<i64> {
        self.count(PAIRS.into_iter())
    }

    /// How many of these pairs turn fully; `None` where that cannot be told.
    fn count(&self, pairs: impl Iterator<Item = [usize; 2]>) -> Option<i64> {
        let mut count = 0;
        for pair in pairs {
            match self.turn_fully(pair) {
                Truth::Yes => count += 1,
                Truth::No => {}
                Truth::Unknown => return None,
            }
        }
        Some(count)
    }
}

pub(super) fn untold() -> Unbuilt {
    Unbuilt::NotHeld("whether links turn fully".to_owned())
}

#[expect(
    clippy::indexing_slicing,
    reason = "an exchange holds the places 0 to 3"
)]
fn exchanged(named: [usize; 4], exchange: [usize; 4]) -> [usize; 4] {
    exchange.map(|place| named[place])
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let links = Links::of(free)?;
    let mut named = [0, 2, 1, 3];
    for (what, exchange) in EXCHANGES {
        if sense(free, what)?.is_positive().is_no() {
            named = exchanged(named, exchange);
        }
    }
    links.named(free, named)
}

fn build_in_order<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let links = Links::of(free)?;
    let named = links.in_order().ok_or_else(untold)?;
    links.named(free, named)
}
