//! The pole quadrilateral of figure 7, closed from the directions of its sides.

use crate::number::{Kind, Number, Polynomial, Real};
use crate::plane::circular_cubic::Cubic;
use crate::plane::tangents::Pencil;
use crate::plane::{Angle, Point, line};
use crate::scenes::{Free, Unbuilt};

/// Directions of the sides against O₁₂O₂₃, which lies on the x-axis with O₁ in the origin.
#[derive(Clone)]
pub struct Directions<K> {
    /// Of O₁₄O₃₄, the η-axis.
    pub phi: Angle<K>,
    /// Of O₁₂O₁₄.
    pub alpha: Angle<K>,
    /// Of O₂₃O₃₄.
    pub beta: Angle<K>,
}

/// The quadrilateral O₁₂O₂₃O₃₄O₁₄ with its sides c < h and r < R.
pub struct PoleQuadrilateral<K> {
    pub directions: Directions<K>,
    /// O₁₂O₂₃
    pub r: Number<K>,
    /// O₂₃O₃₄
    pub h: Number<K>,
    /// O₁₄O₃₄
    pub long: Number<K>,
    /// O₁₂O₁₄
    pub c: Number<K>,
    /// Abscissa of O₁₂ on the ζ-axis.
    pub zeta_0: Number<K>,
    /// Abscissa of O₁₄ on the η-axis.
    pub eta_0: Number<K>,
}

/// Which sides add up to the same, so that U = Z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equal {
    /// h + r = c + R: the shortest and the longest side are adjacent.
    Adjacent,
    /// c + h = r + R: they are opposite.
    Opposite,
}

impl<K: Real> Directions<K> {
    pub fn free(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let mut angle = |half: &str| -> Result<Angle<K>, Unbuilt> {
            Ok(Angle::from_tan_half(&free.number(half)?))
        };
        Ok(Directions {
            phi: angle("tan(phi/2)")?,
            alpha: angle("tan(alpha/2)")?,
            beta: angle("tan(beta/2)")?,
        })
    }

    /// c and h for these r and R, of r + h e^{iβ} = c e^{iα} + R e^{iφ}.
    fn closure(&self, r: &Number<K>, long: &Number<K>) -> (Number<K>, Number<K>) {
        let Directions { phi, alpha, beta } = self;
        let scale = (beta - alpha).sin().inverse();
        let other = |side: &Angle<K>| (r * side.sin() + long * (phi - side).sin()) * &scale;
        (other(beta), other(alpha))
    }
}

impl<K: Real> PoleQuadrilateral<K> {
    /// Directions and lengths of two opposite sides are free; the closure gives the other two.
    pub fn free(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let directions = Directions::free(free)?;
        let r = free.length("r")?;
        let long = &r + free.length("R - r")?;
        Self::closed(directions, r, long)
    }

    /// Of any shape and order of the sides, half of them with U = Z.
    pub fn of_any_kind(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let mut coin = |name: &str| -> Result<bool, Unbuilt> {
            match free.number(name)?.sign() {
                Some(sign) => Ok(sign.is_gt()),
                None => Err(Unbuilt::NotHeld(format!("the sign of {name}"))),
            }
        };
        match (coin("any")?, coin("adjacent")?) {
            (true, _) => Self::free(free),
            (false, true) => Self::free_with_node(Equal::Adjacent, free),
            (false, false) => Self::free_with_node(Equal::Opposite, free),
        }
    }

    /// With U = Z: the directions and a size are free.
    pub fn free_with_node(equal: Equal, free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let directions = Directions::free(free)?;
        Self::with_node(directions, equal, &free.length("size")?)
    }

    /// With U = Z and these directions.
    pub fn with_node(
        directions: Directions<K>,
        equal: Equal,
        size: &Number<K>,
    ) -> Result<Self, Unbuilt> {
        // c and h are linear in r and R, and so is what must vanish.
        let [of_r, of_long] = [(1, 0), (0, 1)].map(|(r, long)| {
            let (r, long) = (Number::from(r), Number::from(long));
            let (c, h) = directions.closure(&r, &long);
            match equal {
                Equal::Adjacent => h + r - c - long,
                Equal::Opposite => c + h - r - long,
            }
        });
        let (r, long) = (of_long * size, -of_r * size);
        if long.is_positive().is_no() {
            return Self::closed(directions, -r, -long);
        }
        Self::closed(directions, r, long)
    }

    fn closed(directions: Directions<K>, r: Number<K>, long: Number<K>) -> Result<Self, Unbuilt> {
        Unbuilt::unless_real(r.is_positive(), "r is no length")?;
        Unbuilt::unless_real((&long - &r).is_positive(), "r is not the shorter one")?;
        let (c, h) = directions.closure(&r, &long);
        Unbuilt::unless_real(c.is_positive(), "c points backwards")?;
        Unbuilt::unless_real((&h - &c).is_positive(), "c is not the shorter one")?;
        let Directions { phi, alpha, .. } = &directions;
        // ζ₀ + c e^{iα} = η₀ e^{iφ}
        let scale = &c / phi.sin();
        Ok(PoleQuadrilateral {
            zeta_0: (alpha - phi).sin() * &scale,
            eta_0: alpha.sin() * scale,
            directions,
            r,
            h,
            long,
            c,
        })
    }
}

impl<K: Real> PoleQuadrilateral<K> {
    /// O₁₂, O₂₃, O₃₄, O₁₄.
    pub fn poles(&self) -> [Point<K>; 4] {
        let eta_axis = self.directions.phi.cis();
        [
            self.zeta_0.clone().into(),
            (&self.zeta_0 + &self.r).into(),
            eta_axis.scaled(&(&self.eta_0 + &self.long)),
            eta_axis.scaled(&self.eta_0),
        ]
    }

    /// O₂ = Q₂₄, where O₁₂O₁₄ and O₂₃O₃₄ meet.
    pub fn o2(&self) -> Point<K> {
        let [o12, o23, o34, o14] = self.poles();
        line::meet(&o12, &o14, &o23, &o34)
    }

    /// The centerpoint curve.
    pub fn curve(&self) -> Result<Cubic<K>, Unbuilt> {
        centerpoint_curve(&self.poles())
    }

    /// The lines through O₁, with their slope p = η/ζ.
    pub fn pencil_of_o1(&self, curve: &Cubic<K>) -> Pencil<K> {
        let axes = [Number::one(), self.directions.phi.cis()];
        Pencil::new(curve, &Number::zero(), axes)
    }

    /// The lines through O₂, with their slope against the directions of c and h.
    pub fn pencil_of_o2(&self, curve: &Cubic<K>) -> Pencil<K> {
        let axes = [self.directions.alpha.cis(), self.directions.beta.cis()];
        Pencil::new(curve, &self.o2(), axes)
    }

    /// f₁ and f₂ for O₁.
    pub fn sums_of_o1(&self, curve: &Cubic<K>) -> Result<Sums<K>, Unbuilt> {
        let difference = 4 * &self.c * &self.h / (&self.r * &self.long);
        Sums::of(&self.pencil_of_o1(curve), &difference)
    }

    /// f₁ and f₂ for O₂.
    pub fn sums_of_o2(&self, curve: &Cubic<K>) -> Result<Sums<K>, Unbuilt> {
        let difference = 4 * &self.r * &self.long / (&self.c * &self.h);
        Sums::of(&self.pencil_of_o2(curve), &difference)
    }
}

/// The focal cubic of four poles in order: a center sees opposite sides of their quadrilateral under
/// equal or supplementary angles, halves of the same turn.
pub fn centerpoint_curve<K: Kind>(poles: &[Point<K>; 4]) -> Result<Cubic<K>, Unbuilt> {
    Cubic::focal(poles).ok_or_else(|| Unbuilt::NotHeld("the centerpoint curve".to_owned()))
}

/// The values f₁ > f₂ of f = p + 1/p for the slopes p of the four tangents.
pub struct Sums<K> {
    pub f: [Number<K>; 2],
}

impl<K: Real> Sums<K> {
    /// The equation of order 4 for p reads the same backwards, so that it is one of order 2 for f. The
    /// difference f₁ − f₂, the root of its discriminant, is proposed and proved.
    pub fn of(pencil: &Pencil<K>, difference: &Number<K>) -> Result<Self, Unbuilt> {
        let quartic: Polynomial<K> = pencil.discriminant();
        let [q0, q1, q2, q3, q4] = [0, 1, 2, 3, 4].map(|power| quartic.coefficient(power));
        Unbuilt::unless_true::<K>(
            q0.equals(&q4) & q1.equals(&q3),
            "the slopes of the tangents are not in pairs p, 1/p",
        )?;
        let last = q2 - 2 * &q4;
        let discriminant = q3.square() - 4 * &last * &q4;
        Unbuilt::unless_true::<K>(
            discriminant.equals(&(difference * &q4).square()),
            "f_1 and f_2 have another difference",
        )?;
        let sum = -&q3 / &q4;
        Ok(Sums {
            f: [(&sum + difference) / 2, (sum - difference) / 2],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Exact, Truth};
    use crate::plane::displacement::Displacement;
    use crate::scenes::free::{Random, point};

    /// Four positions that carry a point of the moving plane along a circle about a center.
    #[test]
    fn the_centerpoint_curve_goes_through_the_centers_of_circles() {
        for seed in 0..20 {
            let mut free = Random::new(seed);
            let center: Point<Exact> = point(&mut free, "center").unwrap();
            let moving: Point<Exact> = point(&mut free, "moving point").unwrap();
            let radius = free.length("radius").unwrap();
            let mut position = || {
                let rotation = free.angle("turn").unwrap().cis();
                let place = &center + free.angle("place").unwrap().cis().scaled(&radius);
                Displacement {
                    translation: place - &rotation * &moving,
                    rotation,
                }
            };
            let [one, two, three, four] = [position(), position(), position(), position()];
            let poles = [
                one.pole(&two),
                two.pole(&three),
                three.pole(&four),
                one.pole(&four),
            ];
            let curve = centerpoint_curve(&poles).unwrap();
            assert_eq!(curve.at(&center).is_zero(), Truth::Yes, "seed {seed}");
            let beside = &center + Point::<Exact>::one();
            assert_eq!(curve.at(&beside).is_zero(), Truth::No, "seed {seed}");
        }
    }
}
