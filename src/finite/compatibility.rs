//! Dyads for four positions by the closure of their loops.
//!
//! W leads from the center M to the circlepoint K, Z from K to a point A of the moving plane, both in
//! position 1. From there to position j the crank turns by γⱼ, the moving plane by φⱼ, and A is
//! shifted by δⱼ = (e^{iφⱼ} − 1) Z + (e^{iγⱼ} − 1) W, j = 2, 3, 4. These are three equations for Z and
//! W: they have a solution only if Σ (e^{iγⱼ} − 1) Δⱼ = 0, with known minors Δⱼ. For a given γ₂ this is a
//! triangle with known sides.

use std::cmp::Ordering;

use crate::number::{Kind, Number, Real, Truth};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// The known parts of the three loop equations.
#[derive(Clone, Debug)]
pub struct LoopClosure<K> {
    /// e^{iφⱼ} − 1 for j = 2, 3, 4.
    columns: [Point<K>; 3],
    /// δⱼ for j = 2, 3, 4.
    shifts: [Point<K>; 3],
    /// Where A is in position 1.
    start: Point<K>,
}

/// A dyad in position 1.
#[derive(Clone, Debug)]
pub struct Dyad<K> {
    /// Z, from the circlepoint to A.
    pub z: Point<K>,
    /// W, from the center to the circlepoint.
    pub w: Point<K>,
    /// K, in the fixed plane.
    pub circlepoint: Point<K>,
    /// M.
    pub center: Point<K>,
}

impl<K: Kind> LoopClosure<K> {
    /// The loops that go through a point A, given in the moving plane.
    pub fn of(positions: &[Displacement<K>; 4], point: &Point<K>) -> Self {
        let [first, rest @ ..] = positions;
        let start = first.of(point);
        let back = first.rotation.conj();
        LoopClosure {
            columns: rest
                .each_ref()
                .map(|position| &position.rotation * &back - 1),
            shifts: rest.each_ref().map(|position| position.of(point) - &start),
            start,
        }
    }

    /// |e^{iφⱼ} − 1, c; e^{iφₖ} − 1, d| with the parts c and d of a second column.
    #[expect(
        clippy::indexing_slicing,
        reason = "the places of two of three equations"
    )]
    fn minor(&self, second: &[Point<K>; 3], j: usize, k: usize) -> Point<K> {
        &self.columns[j] * &second[k] - &self.columns[k] * &second[j]
    }

    /// Δ₂, Δ₃, Δ₄: what stands with e^{iγⱼ} − 1 in the determinant of the three equations.
    pub fn minors(&self) -> [Point<K>; 3] {
        [(1, 2), (2, 0), (0, 1)].map(|(j, k)| -self.minor(&self.shifts, j, k))
    }

    /// e^{iγ₃} Δ₃ + e^{iγ₄} Δ₄ = Δ for a given e^{iγ₂}, with Δ = Δ₂ + Δ₃ + Δ₄ − e^{iγ₂} Δ₂.
    pub fn triangle(&self, crank: &Point<K>) -> Triangle<K> {
        let [second, third, fourth] = self.minors();
        Triangle {
            base: &third + &fourth + (1 - crank) * second,
            sides: [third, fourth],
        }
    }

    /// The dyad whose crank turns by γ₂, γ₃, γ₄, from two of the equations; no value where any two of
    /// them are dependent, as for γⱼ = 0 and for γⱼ = φⱼ.
    #[expect(
        clippy::indexing_slicing,
        reason = "the places of two of three equations"
    )]
    pub fn dyad(&self, cranks: &[Point<K>; 3]) -> Dyad<K> {
        let cranks = cranks.each_ref().map(|crank| crank - 1);
        let pairs = [(0, 1), (0, 2), (1, 2)];
        let independent = |(j, k): &(usize, usize)| !self.minor(&cranks, *j, *k).is_zero().is_yes();
        let (j, k) = pairs.into_iter().find(independent).unwrap_or((0, 1));
        let determinant = self.minor(&cranks, j, k);
        let w = self.minor(&self.shifts, j, k) / &determinant;
        let z = (&self.shifts[j] * &cranks[k] - &self.shifts[k] * &cranks[j]) / determinant;
        let circlepoint = &self.start - &z;
        let center = &circlepoint - &w;
        Dyad {
            z,
            w,
            circlepoint,
            center,
        }
    }
}

impl<K: Real> LoopClosure<K> {
    /// The dyads whose crank turns by γ₂, given as e^{iγ₂}.
    pub fn dyads(&self, crank: &Point<K>) -> Assemblies<Dyad<K>> {
        self.triangle(crank)
            .assemblies()
            .map(|[third, fourth]| self.dyad(&[crank.clone(), third, fourth]))
    }
}

/// A triangle whose base is given, and two sides that are turned until they close it:
/// e^{iγ₃} Δ₃ + e^{iγ₄} Δ₄ = Δ.
#[derive(Clone, Debug)]
pub struct Triangle<K> {
    /// Δ.
    pub base: Point<K>,
    /// Δ₃ and Δ₄, before they are turned.
    pub sides: [Point<K>; 2],
}

/// The ways in which something can be put together.
#[derive(Clone, Debug)]
pub enum Assemblies<T> {
    /// Two of them.
    Two([T; 2]),
    /// One: the two coincide, in a triangle without area.
    Flat(T),
    /// None that is real.
    None,
    /// Every direction: there is no base.
    Every,
    /// It cannot be told.
    Undecided,
}

impl<T> Assemblies<T> {
    /// What follows from each of them.
    pub fn map<U>(self, each: impl Fn(T) -> U) -> Assemblies<U> {
        match self {
            Assemblies::Two(both) => Assemblies::Two(both.map(each)),
            Assemblies::Flat(one) => Assemblies::Flat(each(one)),
            Assemblies::None => Assemblies::None,
            Assemblies::Every => Assemblies::Every,
            Assemblies::Undecided => Assemblies::Undecided,
        }
    }
}

impl<K: Kind> Triangle<K> {
    /// Sixteen times the squared area, 4|Δ|²|Δ₃|² − (|Δ|² + |Δ₃|² − |Δ₄|²)²; negative where the sides are
    /// too short or of too different lengths.
    pub fn sixteen_squared_areas(&self) -> Number<K> {
        4 * self.base.norm() * self.sides[0].norm() - self.twice_projection().square()
    }

    /// |Δ|² + |Δ₃|² − |Δ₄|², twice the scalar product of the base and the turned first side.
    fn twice_projection(&self) -> Number<K> {
        let [third, fourth] = self.sides.each_ref().map(|side| side.norm());
        self.base.norm() + third - fourth
    }
}

impl<K: Real> Triangle<K> {
    /// The turns [e^{iγ₃}, e^{iγ₄}] that close the triangle; of two, first the one that turns Δ₃ to the
    /// right of Δ. No value where a side is zero or where the arithmetic does not hold a root.
    pub fn assemblies(&self) -> Assemblies<[Point<K>; 2]> {
        match self.base.is_zero() {
            Truth::Yes => return self.without_base(),
            Truth::Unknown => return Assemblies::Undecided,
            Truth::No => {}
        }
        let square = self.sixteen_squared_areas();
        match square.sign() {
            None => Assemblies::Undecided,
            Some(Ordering::Less) => Assemblies::None,
            Some(Ordering::Equal) => Assemblies::Flat(self.turns(&Number::zero())),
            Some(Ordering::Greater) => {
                let root = square.sqrt();
                Assemblies::Two([self.turns(&-&root), self.turns(&root)])
            }
        }
    }

    /// The turns for four times the signed area, positive where Δ₃ is turned to the left of Δ.
    fn turns(&self, four_areas: &Number<K>) -> [Point<K>; 2] {
        let ratio = Number::complex(self.twice_projection(), four_areas.clone());
        let third = ratio * &self.base / Point::from(2 * self.base.norm());
        let fourth = &self.base - &third;
        [third / &self.sides[0], fourth / &self.sides[1]]
    }

    fn without_base(&self) -> Assemblies<[Point<K>; 2]> {
        let [third, fourth] = self.sides.each_ref().map(|side| side.norm());
        match third.equals(&fourth) {
            Truth::Yes => Assemblies::Every,
            Truth::No => Assemblies::None,
            Truth::Unknown => Assemblies::Undecided,
        }
    }
}
