//! Centerpoint curve and circlepoint curve have the same type.

use super::positions::Positions;
use crate::finite::four_positions::circle_conditions::{centerpoint_cubic, circlepoint_cubic};
use crate::finite::pole_four_bar::Joints;
use crate::number::poly::Fraction;
use crate::number::{Exact, Kind, Number, Truth};
use crate::plane::circular_cubic::Cubic;
use crate::plane::curve_type::{CurveType, curve_type};
use crate::plane::displacement::Displacement;
use crate::plane::{Angle, Point, line, relation};
use crate::scenes::check::{Basis, Check, Exception, Report};
use crate::scenes::free::{Random, Symbols, point};
use crate::scenes::{Free, Unbuilt};

pub const CHECK: Check = Check {
    name: "both-curves-have-one-type",
    summary: "A line through the vertex A of a quadrilateral ABCD meets its curve in two more \
              points. For all quadrilaterals their discriminant is AB^4 (4 p^2 q^2 - (e^2 - p^2 - \
              q^2)^2), with p = BC, q = CD and e the distance from D to the mirror image of B in \
              the line: a function of the sides and of the direction of the crank. Pole and mirror \
              pole quadrilateral have equal sides, and to each line for the one belongs the line \
              for the other with the same crank; so both discriminants have the same zeros, simple \
              and multiple, and the same signs between them, from which the type of an irreducible \
              cubic is read. On 20 instances both cubics, each from the condition that four points \
              lie on a circle, have one type, by their discriminants. On 20 \
              instances each the exceptions are found: four poles on a line, which is a part of \
              one curve, while the other has no line as a part and a double point; and a \
              parallelogram of poles with a crossed one of mirror poles, with the line at infinity \
              and a finite line as parts. The wrong variant measures e from C.",
    run,
};

const INSTANCES: usize = 20;

fn run() -> Result<Report, Unbuilt> {
    let sides = Discriminants::free()?;
    Ok(Report {
        holds: sides.found.equals(&sides.from_d) & same_type_on_instances()? & exceptions()?,
        wrong_variant: sides.found.equals(&sides.from_c),
        basis: Basis::Identity,
        instances: INSTANCES,
        exception: Some(Exception {
            condition: "both curves are irreducible",
            counterexample: "O12, O23, O34 and O14 on one line: the centerpoint curve is this line \
                             and a circle, the circlepoint curve in general an irreducible cubic \
                             with a double point. Another: a parallelogram of poles and a crossed \
                             one of mirror poles: a hyperbola, and a line with a circle",
        }),
    })
}

/// The discriminant of the two meets with a line through A, and what it should be.
struct Discriminants {
    found: Number<Fraction>,
    from_d: Number<Fraction>,
    from_c: Number<Fraction>,
}

impl Discriminants {
    /// A in the origin: this only moves the figure.
    fn free() -> Result<Self, Unbuilt> {
        let mut free = Symbols::default();
        let half =
            Angle::from_tan_half(&free.number("tan of a quarter of the crank's turn")?).cis();
        let mut vertex = |name: &str| point(&mut free, name);
        let [b, c, d] = [vertex("B")?, vertex("C")?, vertex("D")?];
        let cubic = focal(&[Number::zero(), b.clone(), c.clone(), d.clone()])?;
        // The line bisects the angle between the crank AB and its mirror image.
        let along = &b * &half;
        let moved = &b * half.square();
        let (p2, q2) = (
            relation::distance_squared(&b, &c),
            relation::distance_squared(&c, &d),
        );
        let expected = |pivot: &Point<Fraction>| {
            let e2 = relation::distance_squared(pivot, &moved);
            let of_sides = 4 * &p2 * &q2 - (e2 - &p2 - &q2).square();
            b.norm().square() * of_sides
        };
        Ok(Discriminants {
            found: discriminant(|share| cubic.at(&along.scaled(&share)) / share),
            from_d: expected(&d),
            from_c: expected(&c),
        })
    }
}

fn focal<K: Kind>(vertices: &[Point<K>; 4]) -> Result<Cubic<K>, Unbuilt> {
    real(Cubic::focal(vertices))
}

fn real<K>(cubic: Option<Cubic<K>>) -> Result<Cubic<K>, Unbuilt> {
    cubic.ok_or_else(|| Unbuilt::Contradiction("the curve is no real cubic".to_owned()))
}

/// The discriminant of a quadratic polynomial, from its values at 1, 2 and 3.
fn discriminant<K: Kind>(value: impl Fn(Number<K>) -> Number<K>) -> Number<K> {
    let [first, second, third] = [1, 2, 3].map(|x: i64| value(x.into()));
    let twice_a = third - 2 * &second + &first;
    let b = second - &first - 3 * &twice_a / 2;
    let c = first - &twice_a / 2 - &b;
    b.square() - 2 * twice_a * c
}

fn same_type_on_instances() -> Result<Truth, Unbuilt> {
    let mut free = Random::new(1970);
    let mut same = Truth::Yes;
    let mut seen = Vec::new();
    for _ in 0..INSTANCES {
        let curves = cubics(&Positions::free(&mut free)?.displacements)?;
        let [centers, circlepoints] = curves.each_ref().map(curve_type);
        same = same & (centers.is_some() && centers == circlepoints).into();
        seen.extend(centers);
    }
    let types = [CurveType::OneBranch, CurveType::TwoBranches];
    Ok(same & types.iter().all(|kind| seen.contains(kind)).into())
}

/// The poles O12, O23, O34, O14 on the x-axis, the mirror poles not: the axis is a part of the
/// centerpoint curve, and the circlepoint curve has no line as a part. And a parallelogram.
fn exceptions() -> Result<Truth, Unbuilt> {
    let mut free = Random::new(1971);
    let mut all = Truth::Yes;
    for _ in 0..INSTANCES {
        let [centers, circlepoints] = cubics(&with_collinear_poles(&mut free)?)?;
        all = all
            & contains_asymptote(&centers)
            & !contains_asymptote(&circlepoints)
            & (curve_type(&circlepoints) == Some(CurveType::Nodal)).into();
        let [centers, circlepoints] = cubics(&with_parallelogram(&mut free)?)?;
        all = all
            & centers.contains_line_at_infinity()
            & !circlepoints.contains_line_at_infinity()
            & contains_asymptote(&circlepoints);
    }
    Ok(all)
}

/// Centerpoint curve and circlepoint curve.
fn cubics(displacements: &[Displacement<Exact>; 4]) -> Result<[Cubic<Exact>; 2], Unbuilt> {
    Ok([
        real(centerpoint_cubic(displacements))?,
        real(circlepoint_cubic(displacements))?,
    ])
}

/// Whether a centerpoint curve of order 3 contains its real asymptote; no other line can be a part of
/// it.
fn contains_asymptote(cubic: &Cubic<Exact>) -> Truth {
    match curve_type(cubic) {
        Some(CurveType::LineAndCircle | CurveType::ThreeLines) => Truth::Yes,
        Some(_) => Truth::No,
        None => Truth::Unknown,
    }
}

/// Any other position of the four-bar of collinear poles, found from a point S that sees opposite
/// sides under equal angles, is that of the mirror poles.
fn with_collinear_poles(free: &mut Random) -> Result<[Displacement<Exact>; 4], Unbuilt> {
    let s: Point<Exact> = point(free, "S")?;
    let mut on_axis = |name: &str| -> Result<Point<Exact>, Unbuilt> {
        Ok(Number::<Exact>::into(free.number(name)?))
    };
    let [a, b, c] = [on_axis("O12")?, on_axis("O23")?, on_axis("O34")?];
    // (S − A)(S − C) : (S − B)(S − D) is real.
    let toward = &s + (&s - &a) * (&s - &c) / (&s - &b);
    let d = line::meet(&s, &toward, &Number::zero(), &Number::one());
    let [mirror_b, mirror_c] =
        [(&b, &a), (&c, &d)].map(|(joint, pivot)| line::mirror(joint, pivot, &s));
    Ok(of_four_bar(&[a, d], &[b, c], &[mirror_b, mirror_c]))
}

/// Poles in a parallelogram, mirror poles in a crossed one with the same sides: one joint is
/// mirrored in a diagonal.
fn with_parallelogram(free: &mut Random) -> Result<[Displacement<Exact>; 4], Unbuilt> {
    let mut vertex = |name: &str| -> Result<Point<Exact>, Unbuilt> { point(free, name) };
    let [a, b, d] = [vertex("O12")?, vertex("O23")?, vertex("O14")?];
    let c = &b + &d - &a;
    let turn: Angle<Exact> = free.angle("phi_12")?;
    let mirror_b = &a + (&b - &a) * turn.cis();
    let uncrossed = &mirror_b + &d - &a;
    let mirror_c = line::mirror(&uncrossed, &mirror_b, &d);
    Ok(of_four_bar(&[a, d], &[b, c], &[mirror_b, mirror_c]))
}

/// The four positions with the poles O12 and O14, O23 and O34, and these mirror poles of the
/// latter.
fn of_four_bar(
    [a, d]: &Joints<Exact>,
    poles: &Joints<Exact>,
    mirror_poles: &Joints<Exact>,
) -> [Displacement<Exact>; 4] {
    let ([b, c], [mirror_b, mirror_c]) = (poles, mirror_poles);
    let crank = |pivot: &Point<Exact>, from: &Point<Exact>, to: &Point<Exact>| {
        let start = [pivot.clone(), from.clone()];
        Displacement::carrying(&start, &[pivot.clone(), to.clone()])
    };
    [
        Displacement::identity(),
        crank(a, mirror_b, b),
        Displacement::carrying(mirror_poles, poles),
        crank(d, mirror_c, c),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
    }

    #[test]
    fn a_curve_with_a_line_and_one_without() {
        // y (x² + y² − 1), and x³ + x y² + y.
        let cubic = |terms: &[(usize, i64)]| {
            let mut coefficients = std::array::from_fn(|_| Number::zero());
            for (place, value) in terms {
                coefficients[*place] = Number::from(*value);
            }
            Cubic::new(coefficients)
        };
        let with = cubic(&[(1, 1), (3, 1), (8, -1)]);
        let without = cubic(&[(0, 1), (2, 1), (8, 1)]);
        assert_eq!(contains_asymptote(&with), Truth::Yes);
        assert_eq!(contains_asymptote(&without), Truth::No);
    }
}
