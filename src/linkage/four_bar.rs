//! The four-bar M, A, B, N with M in the origin and N on the positive x-axis.

use crate::number::{Kind, Number, Real, Truth};
use crate::plane::{Point, relation};

/// Its sides.
#[derive(Clone, Debug)]
pub struct FourBar<K> {
    /// MA
    pub a: Number<K>,
    /// NB
    pub b: Number<K>,
    /// AB
    pub c: Number<K>,
    /// MN
    pub d: Number<K>,
}

/// A position, by the ends of the coupler.
#[derive(Clone, Debug)]
pub struct Position<K> {
    /// On the circle of radius a about M.
    pub a: Point<K>,
    /// On the circle of radius b about N.
    pub b: Point<K>,
}

impl<K: Real> FourBar<K> {
    /// The two assemblies for a direction u of MA, |u| = 1: with B to the left and to the right of
    /// the line from A to N. `None` where B cannot be reached, or where that cannot be told or held.
    pub fn with_crank(&self, u: &Point<K>) -> Option<[Position<K>; 2]> {
        let a = u.scaled(&self.a);
        let corners = third_corners(&a, &self.base(), &self.c.square(), &self.b.square())?;
        Some(corners.map(|b| Position { a: a.clone(), b }))
    }

    /// The two assemblies for a direction w of AB, |w| = 1; as for [`FourBar::with_crank`].
    pub fn with_coupler(&self, w: &Point<K>) -> Option<[Position<K>; 2]> {
        // NB moved by BA ends in A.
        let along = w.scaled(&self.c);
        let moved = self.base() - &along;
        let corners = third_corners(&Number::zero(), &moved, &self.a.square(), &self.b.square())?;
        Some(corners.map(|a| Position { b: &a + &along, a }))
    }

    /// Whether the coupler turns fully: a triangle with the sides a, b and |d − c e^{iθ}| exists, and
    /// is no segment, for every θ.
    pub fn coupler_turns(&self) -> Truth {
        let FourBar { a, b, c, d } = self;
        let less = |x: Number<K>, y: Number<K>| (y - x).is_positive();
        less((a - b).abs(), (d - c).abs()) & less(c + d, a + b)
    }
}

impl<K: Kind> FourBar<K> {
    fn base(&self) -> Point<K> {
        self.d.clone().into()
    }
}

/// The third corners of the triangles over XY with given squares of the distances from X and Y,
/// left one first. `None` where there are none, or where that cannot be told or held.
pub fn third_corners<K: Real>(
    x: &Point<K>,
    y: &Point<K>,
    from_x: &Number<K>,
    from_y: &Number<K>,
) -> Option<[Point<K>; 2]> {
    let base = y - x;
    let square = relation::distance_squared(x, y);
    let along = (from_x - from_y + &square) / (2 * &square);
    let across = (from_x / &square - along.square()).sqrt();
    across.has_value().then(|| {
        let corner = |across: Number<K>| x + &base * Number::complex(along.clone(), across);
        [corner(across.clone()), corner(-&across)]
    })
}
