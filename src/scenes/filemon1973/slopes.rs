//! Appendix, (7) and what belongs to it: the slopes of the tangents from O₁, and those from O₂.

use super::quadrilateral::PoleQuadrilateral;
use crate::formula::{Bindings, Value};
use crate::number::{Number, Real};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1973/slopes",
    "Figure 7 with the directions of all four sides and the lengths r and R free; the closure gives c and \
     h. The slopes p are the roots of the equation of order four that says that the line \
     eta = p zeta meets the centerpoint curve twice in one more point. About O2 the axes have the \
     directions from O12 to O14 and from O23 to O34.",
    build,
    [
        "phi": "angle from the zeta-axis to the eta-axis",
        "r": "length of the side O12 O23",
        "h": "length of the side O23 O34",
        "R": "length of the side O14 O34",
        "c": "length of the side O12 O14",
        "zeta_0": "abscissa of O12 on the zeta-axis",
        "eta_0": "abscissa of O14 on the eta-axis",
        "f_1": "the greater sum of the slopes p and 1/p of two tangents from O1",
        "f_2": "the smaller sum of the slopes p and 1/p of two tangents from O1",
        "f_1'": "f_1 for the tangents from O2",
        "f_2'": "f_2 for the tangents from O2",
        "p": "slope of a tangent from O1",
        "p_{1,2}": "the slopes of the two tangents from O1 with the sum f_1",
        "p_{3,4}": "the slopes of the two tangents from O1 with the sum f_2",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let quadrilateral = PoleQuadrilateral::free(free)?;
    let curve = quadrilateral.curve()?;
    let [f_1, f_2] = quadrilateral.sums_of_o1(&curve)?.f;
    let [f_1_of_o2, f_2_of_o2] = quadrilateral.sums_of_o2(&curve)?.f;
    let quartic = quadrilateral.pencil_of_o1(&curve).discriminant();
    let mut slopes = |f: &Number<K>, name: &str| -> Result<[Number<K>; 2], Unbuilt> {
        let root = free.root(name, &(f.square() - 4))?;
        let both = [(f + &root) / 2, (f - root) / 2];
        for p in &both {
            Unbuilt::unless_true::<K>(quartic.evaluate(p).is_zero(), "p is no tangent's slope")?;
        }
        Ok(both)
    };
    let first = slopes(&f_1, "difference of p_1 and p_2")?;
    let second = slopes(&f_2, "difference of p_3 and p_4")?;
    // The sums once more, so that they know the roots.
    let [f_1, f_2] = [&first, &second].map(|[p, q]| p + q);
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("p", first[0].clone());
    let set = |both: [Number<K>; 2]| Value::Set(both.map(Value::Number).into());
    bindings.bind("p_{1,2}", set(first));
    bindings.bind("p_{3,4}", set(second));
    let PoleQuadrilateral {
        directions,
        r,
        h,
        long,
        c,
        zeta_0,
        eta_0,
    } = quadrilateral;
    for (name, value) in [
        ("r", r),
        ("h", h),
        ("R", long),
        ("c", c),
        ("zeta_0", zeta_0),
        ("eta_0", eta_0),
        ("f_1", f_1),
        ("f_2", f_2),
        ("f_1'", f_1_of_o2),
        ("f_2'", f_2_of_o2),
    ] {
        bindings.bind(name, value);
    }
    bindings.bind("phi", directions.phi);
    Ok(bindings)
}
