//! Figure 4: the quadrilaterals of any two of the three point pairs.

use super::quadrilateral::centerpoint_curve;
use super::sample::quadrilaterals;
use crate::number::{Exact, Truth};
use crate::plane::Point;
use crate::plane::quadrilateral::{Shape, shape};
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};

pub const CHECK: Check = Check {
    name: "a-point-pair-quadrilateral-is-convex",
    summary: "The four lines of the sides meet in six points, the pairs O12 O34, O14 O23 and Q13 Q24. Any two \
              pairs are the opposite vertices of a quadrilateral with its sides on these lines. Of the \
              three quadrilaterals one is convex, one concave and one crossed, whatever the shape of \
              the pole quadrilateral, and all have the same centerpoint curve. The wrong variant says \
              that the pole quadrilateral is convex.",
    run,
};

const INSTANCES: usize = 40;

fn run() -> Result<Report, Unbuilt> {
    let mut holds = Vec::new();
    let mut wrong_variant = Vec::new();
    let mut seen = Vec::new();
    for quadrilateral in quadrilaterals().take(INSTANCES) {
        let quadrilateral = quadrilateral?;
        let poles = quadrilateral.poles();
        let [o12, o23, o34, o14] = poles.clone();
        let (q13, q24) = (Point::<Exact>::zero(), quadrilateral.o2());
        let all = [
            poles,
            [o12, q13.clone(), o34, q24.clone()],
            [o14, q13, o23, q24],
        ];
        let shapes = all.each_ref().map(shape);
        let mut sorted = shapes;
        sorted.sort_unstable();
        let one_of_each = sorted == [Shape::Convex, Shape::Concave, Shape::Crossed].map(Some);
        holds.extend([one_of_each.into(), have_one_curve(&all)?]);
        wrong_variant.push(Truth::from(shapes[0] == Some(Shape::Convex)));
        seen.push(shapes[0]);
    }
    seen.sort_unstable();
    seen.dedup();
    holds.push(Truth::from(seen.len() == 3));
    Ok(Report {
        holds: Truth::all(holds),
        wrong_variant: Truth::all(wrong_variant),
        basis: Basis::Instances,
        instances: INSTANCES,
        exception: None,
    })
}

fn have_one_curve(quadrilaterals: &[[Point<Exact>; 4]; 3]) -> Result<Truth, Unbuilt> {
    let [first, second, third] = quadrilaterals.each_ref().map(centerpoint_curve);
    let first = first?;
    Ok(Truth::all([first.equals(&second?), first.equals(&third?)]))
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
}
