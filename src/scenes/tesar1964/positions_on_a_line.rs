//! Chapter III: four positions of the moving plane in which its origin is on the X-axis, and a point
//! of it with four places on a circle: the coupler of a slider-crank.

use super::quadratic::Quadratic;
use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::Point;
use crate::plane::displacement::Displacement;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/positions-on-a-line",
    "Four positions of the coupler of a slider-crank: the pin of the slider, which moves along the \
     X-axis, is the origin of the moving plane, the pin of the crank is the point (x, y) of it. The \
     lengths of crank and rod, the height of the crank's pivot and the directions of the rod are free. In \
     position 0 the planes coincide. D_j is the squared distance of a point from the fixed origin in \
     position j less that in position 0, F_j twice the difference of its ordinates; both are linear in \
     the coordinates of the point. P_k = (D_(k+1) F_(k+2) - F_(k+1) D_(k+2))/(-2), with cyclic k, is the \
     part of the determinant (3.6) that stands with E_k.",
    build,
    [
        "x": "coordinate of the point in the moving plane",
        "y": "coordinate of the point in the moving plane",
        "phi_1": "turn of position 1",
        "phi_2": "turn of position 2",
        "phi_3": "turn of position 3",
        "a_1": "abscissa of the moving origin in position 1",
        "a_2": "abscissa of the moving origin in position 2",
        "a_3": "abscissa of the moving origin in position 3",
        "g_1": "coefficient of x in D_1",
        "g_2": "coefficient of x in D_2",
        "g_3": "coefficient of x in D_3",
        "h_1": "coefficient of -y in D_1",
        "h_2": "coefficient of -y in D_2",
        "h_3": "coefficient of -y in D_3",
        "m_1": "coefficient of -2 y in F_1",
        "m_2": "coefficient of -2 y in F_2",
        "m_3": "coefficient of -2 y in F_3",
        "n_1": "coefficient of -2 x in F_1",
        "n_2": "coefficient of -2 x in F_2",
        "n_3": "coefficient of -2 x in F_3",
        "R_1": "coefficient of x^2 in P_1",
        "R_2": "coefficient of x^2 in P_2",
        "R_3": "coefficient of x^2 in P_3",
        "S_1": "coefficient of y^2 in P_1",
        "S_2": "coefficient of y^2 in P_2",
        "S_3": "coefficient of y^2 in P_3",
        "T_1": "coefficient of x y in P_1",
        "T_2": "coefficient of x y in P_2",
        "T_3": "coefficient of x y in P_3",
        "U_1": "coefficient of y in P_1",
        "U_2": "coefficient of y in P_2",
        "U_3": "coefficient of y in P_3",
        "V_1": "coefficient of x in P_1",
        "V_2": "coefficient of x in P_2",
        "V_3": "coefficient of x in P_3",
    ]
);

/// What multiplies Q₀ and Q₂ in the equation of a circle at a position less that at position 0.
struct Row<K> {
    d: Number<K>,
    f: Number<K>,
}

fn row<K: Real>(position: &Displacement<K>, point: &Point<K>) -> Row<K> {
    let place = position.of(point);
    Row {
        d: place.norm() - point.norm(),
        f: 2 * (place.im() - point.im()),
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (rod, crank) = (free.length("rod")?, free.length("crank")?);
    let height = free.number("height of the pivot")?;
    let mut directions = Vec::new();
    let mut sliders = Vec::new();
    for j in 0..=3 {
        let direction = free.angle(&format!("direction {j} of the rod"))?;
        let pin = direction.cis().scaled(&rod);
        // The crank reaches the pin where their heights agree.
        let sin = (pin.im() - &height) / &crank;
        let cos = free.root(&format!("cosine {j} of the crank"), &(1 - sin.square()))?;
        sliders.push(&crank * cos - pin.re());
        directions.push(direction);
    }
    let (Some(start), Some(origin)) = (directions.first(), sliders.first()) else {
        return Err(Unbuilt::Contradiction("no position".to_owned()));
    };
    let point = start.cis().scaled(&rod);
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("x", point.re().clone());
    bindings.bind("y", point.im().clone());
    let mut positions = Vec::new();
    for (k, (direction, slider)) in directions.iter().zip(&sliders).enumerate().skip(1) {
        let (phi, a) = (direction - start, slider - origin);
        positions.push(Displacement {
            rotation: phi.cis(),
            translation: a.clone().into(),
        });
        bindings.bind(&format!("phi_{k}"), phi);
        bindings.bind(&format!("a_{k}"), a);
    }
    for k in 0..3 {
        bind_coefficients(k, &positions, &mut bindings);
    }
    Ok(bindings)
}

#[expect(
    clippy::indexing_slicing,
    reason = "k % 3 is a place among the three positions"
)]
fn bind_coefficients<K: Real>(k: usize, positions: &[Displacement<K>], bindings: &mut Bindings<K>) {
    let [own, next, last] = [k, k + 1, k + 2].map(|k| &positions[k % 3]);
    let at = |x: i64, y: i64| -> Point<K> { Number::complex(x.into(), y.into()) };
    let d = Quadratic::interpolated(|x, y| row(own, &at(x, y)).d);
    let f = Quadratic::interpolated(|x, y| row(own, &at(x, y)).f);
    let product = Quadratic::interpolated(|x, y| {
        let (next, last) = (row(next, &at(x, y)), row(last, &at(x, y)));
        (next.d * last.f - next.f * last.d) / -2
    });
    for (name, coefficient) in [
        ("g", d.x),
        ("h", -d.y),
        ("m", f.y / -2),
        ("n", f.x / -2),
        ("R", product.x2),
        ("S", product.y2),
        ("T", product.xy),
        ("U", product.y),
        ("V", product.x),
    ] {
        bindings.bind(&format!("{name}_{}", k + 1), coefficient);
    }
}
