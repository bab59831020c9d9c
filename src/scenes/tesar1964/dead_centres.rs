//! Chapter VI: double levers where coupler and follower are on one line.

use crate::formula::Bindings;
use crate::linkage::four_bar::FourBar;
use crate::linkage::passage::{Drive, Type};
use crate::number::{Number, Real, Truth};
use crate::plane::{Angle, Point, relation};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const TURNING_COUPLER: Scene = scene!(
    "tesar1964/dead-centres-of-a-turning-coupler",
    "A double lever whose coupler turns fully. Fixed link, input lever and both angles of its dead centres are \
     free: the distances of O_b from the two places of A are sum and difference of follower and coupler. \
     There are no other dead centres but the mirror images.",
    build_turning_coupler,
    [
        "Q": "length of the fixed link O_aO_b",
        "R": "length of the input lever O_aA",
        "S": "length of the coupler AB",
        "T": "length of the follower O_bB",
        "phi_{+}": "from O_aO_b to O_aA where B is between O_b and A",
        "phi_{-}": "from O_aO_b to O_aA where A is between O_b and B",
    ]
);

pub const DOUBLE_LEVER: Scene = scene!(
    "tesar1964/dead-centres-of-a-double-lever",
    "A double lever in which no link turns fully against another. Fixed link, input lever, the angle of a dead centre, \
     and where B is on the line O_bA in it are free. There is no other dead centre but its mirror image.",
    build_double_lever, not symbolic: "the type of a linkage",
    [
        "Q": "length of the fixed link O_aO_b",
        "R": "length of the input lever O_aA",
        "S": "length of the coupler AB",
        "T": "length of the follower O_bB",
        "phi_{+}": "from O_aO_b to O_aA in the dead centre",
        "phi_{-}": "from O_aO_b to O_aA in its mirror image",
    ]
);

/// Fixed link and input lever.
struct Input<K> {
    q: Number<K>,
    r: Number<K>,
}

impl<K: Real> Input<K> {
    fn of(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        Ok(Input {
            q: free.length("Q")?,
            r: free.length("R")?,
        })
    }

    /// From O_b to A.
    fn diagonal(&self, phi: &Angle<K>) -> Point<K> {
        phi.cis().scaled(&self.r) - Point::from(self.q.clone())
    }

    fn four_bar(&self, s: &Number<K>, t: &Number<K>) -> FourBar<K> {
        FourBar {
            a: self.r.clone(),
            b: t.clone(),
            c: s.clone(),
            d: self.q.clone(),
        }
    }

    fn bind(self, bindings: &mut Bindings<K>, s: Number<K>, t: Number<K>) {
        for (name, value) in [("Q", self.q), ("R", self.r), ("S", s), ("T", t)] {
            bindings.bind(name, value);
        }
    }
}

/// Whether the linkage has so many dead centres besides mirror images.
fn has_dead_centres<K: Real>(four_bar: &FourBar<K>, count: usize) -> Truth {
    match four_bar.dead_centres(Drive::First) {
        Some(found) => Truth::from(found.len() == count),
        None => Truth::Unknown,
    }
}

fn build_turning_coupler<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let input = Input::of(free)?;
    let (stretched, folded) = (free.angle("phi_+")?, free.angle("phi_-")?);
    let diagonals = [&stretched, &folded].map(|phi| input.diagonal(phi));
    let sum = free.root("T + S", &diagonals[0].norm())?;
    let difference = free.root("T - S", &diagonals[1].norm())?;
    let (s, t) = ((&sum - &difference) / 2, (&sum + &difference) / 2);
    Unbuilt::unless_real(s.is_positive(), "the coupler has no length")?;
    for (diagonal, length) in diagonals.iter().zip([&sum, &difference]) {
        let follower = diagonal.scaled(&(&t / length));
        let closed = relation::distance_squared(&follower, diagonal).equals(&s.square())
            & follower.norm().equals(&t.square());
        Unbuilt::unless_true::<K>(closed, "B is on the line O_bA")?;
    }
    let four_bar = input.four_bar(&s, &t);
    let class = four_bar.coupler_turns() & has_dead_centres(&four_bar, 2);
    Unbuilt::unless_true::<K>(class, "the coupler turns fully between two dead centres")?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("phi_{+}", stretched);
    bindings.bind("phi_{-}", folded);
    input.bind(&mut bindings, s, t);
    Ok(bindings)
}

fn build_double_lever<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let input = Input::of(free)?;
    let phi = free.angle("phi_+")?;
    let part = free.number("O_bB : O_bA")?;
    let diagonal = input.diagonal(&phi);
    let length = free.root("O_bA", &diagonal.norm())?;
    let (s, t) = (&length * (1 - &part).abs(), length * part.abs());
    let four_bar = input.four_bar(&s, &t);
    match four_bar.link_type() {
        Some(Type::DoubleLever) => {}
        Some(_) => return Err(Unbuilt::NotReal("a link turns fully".to_owned())),
        None => return Err(Unbuilt::NotHeld("the type of a linkage".to_owned())),
    }
    let only = has_dead_centres(&four_bar, 1);
    Unbuilt::unless_true::<K>(only, "there is one dead centre and its mirror image")?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("phi_{-}", -&phi);
    bindings.bind("phi_{+}", phi);
    input.bind(&mut bindings, s, t);
    Ok(bindings)
}
