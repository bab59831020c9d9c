//! The compatibility triangle and its two assemblies.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::{Angle, Point};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "kaufman/compatibility-triangle",
    "A triangle with sides of any three lengths that close, laid out on its base, one side to the right \
     of it. Delta_3 and Delta_4 are the sides before they were turned, by free angles. The other \
     assembly is the mirror image in the base.",
    build,
    [
        "Delta": "base of the triangle",
        "Delta_3": "side before it is turned",
        "Delta_4": "side before it is turned",
        "mu": "direction of Delta",
        "mu_3": "direction of Delta_3",
        "mu_4": "direction of Delta_4",
        "theta_3": "interior angle between the base and the turned Delta_3",
        "theta_4": "interior angle between the base and the turned Delta_4",
        "gamma_3": "turn of Delta_3, first assembly",
        "gamma_4": "turn of Delta_4, first assembly",
        "gamma_3'": "turn of Delta_3, second assembly",
        "gamma_4'": "turn of Delta_4, second assembly",
    ]
);

/// A vector and its length.
struct Side<K> {
    vector: Point<K>,
    length: Number<K>,
}

impl<K: Real> Side<K> {
    fn direction(&self) -> Angle<K> {
        Angle::of_known_length(self.vector.clone(), self.length.clone())
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let mut tangent = |corner: &str| free.length(&format!("tangent from the {corner} corner"));
    // The tangents from the corners to the inscribed circle: any three make a triangle.
    let [first, second, apex] = [tangent("first")?, tangent("second")?, tangent("upper")?];
    let radicand = &first * &second * &apex * (&first + &second + &apex);
    let area = free.root("area", &radicand)?;
    let base = {
        let length = &first + &second;
        Side {
            vector: free.angle("mu")?.cis().scaled(&length),
            length,
        }
    };
    let third = {
        let length = &first + &apex;
        // The foot of the height from the first corner, by Pythagoras on both sides of it.
        let opposite = &second + &apex;
        let foot =
            (base.length.square() + length.square() - opposite.square()) / (2 * &base.length);
        let height = 2 * area / &base.length;
        Side {
            vector: Number::complex(foot, -height) * &base.vector
                / Point::from(base.length.clone()),
            length,
        }
    };
    let fourth = Side {
        vector: &base.vector - &third.vector,
        length: second + apex,
    };
    Unbuilt::unless_true::<K>(
        fourth.vector.norm().equals(&fourth.length.square()),
        "the sides do not have the lengths of the triangle",
    )?;
    let gammas = [free.angle("gamma_3")?, free.angle("gamma_4")?];
    let [before, after] = [(&third, &gammas[0]), (&fourth, &gammas[1])].map(|(side, gamma)| Side {
        vector: &side.vector * gamma.cis().conj(),
        length: side.length.clone(),
    });
    // The mirror image of a side in the base, over the side before it was turned.
    let mirrored = |side: &Side<K>, unturned: &Side<K>| {
        let image = (&side.vector / &base.vector).conj() * &base.vector;
        Angle::of_known_length(image / &unturned.vector, Number::one())
    };
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("gamma_3'", mirrored(&third, &before));
    bindings.bind("gamma_4'", mirrored(&fourth, &after));
    let [gamma_3, gamma_4] = gammas;
    bindings.bind("gamma_3", gamma_3);
    bindings.bind("gamma_4", gamma_4);
    bindings.bind("theta_3", &base.direction() - &third.direction());
    bindings.bind("theta_4", &fourth.direction() - &base.direction());
    bindings.bind("mu", base.direction());
    bindings.bind("mu_3", before.direction());
    bindings.bind("mu_4", after.direction());
    bindings.bind("Delta", base.vector);
    bindings.bind("Delta_3", before.vector);
    bindings.bind("Delta_4", after.vector);
    Ok(bindings)
}
