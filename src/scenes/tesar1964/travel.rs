//! Chapter IV: a slider-crank in the two positions that one place of the slider allows.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::{Angle, Point, line};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/travel-of-the-slider",
    "A slider-crank with its pivot in the origin; the slider moves along the x-axis at the height d. The \
     crank and where the slider's pin D is, seen from it, are free. For this place of D the crank has a \
     second position, the mirror image of the first in the line through pivot and D. B is any point of the \
     coupler.",
    build,
    [
        "R": "length of the crank O_2 A",
        "M": "length AD",
        "S": "length AB",
        "s": "abscissa of the slider's pin D, of any sign",
        "d": "ordinate of the slider's pin D",
        "omega": "direction of the crank whose pin A is to the right of the line O_2 D, seen from O_2 to D",
        "omega'": "direction of the crank in the second position, with A to the left of that line",
        "beta": "direction from A to D",
        "epsilon": "turn that leads from AB to AD, counterclockwise",
        "x_a": "coordinate of the crank pin A",
        "y_a": "coordinate of the crank pin A",
        "x_d": "coordinate of the slider's pin D",
        "y_d": "coordinate of the slider's pin D",
        "x_b": "coordinate of the coupler point B",
        "y_b": "coordinate of the coupler point B",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let crank = free.length("R")?;
    let omega = free.angle("omega")?;
    let from_crank: Point<K> = Number::complex(
        free.number("D along the crank")?,
        free.length("D beside it")?,
    );
    let (pin, slider) = (omega.cis().scaled(&crank), omega.cis() * from_crank);
    let other = line::mirror(&pin, &Number::zero(), &slider);
    let rod = &slider - &pin;
    let length = free.root("M", &rod.norm())?;
    let side = free.length("S")?;
    let epsilon = free.angle("epsilon")?;
    let point = &pin + (epsilon.cis().conj() * &rod).scaled(&(&side / &length));
    let mut bindings = Bindings::new(free.precision());
    for (name, place) in [("a", &pin), ("b", &point), ("d", &slider)] {
        bindings.bind(&format!("x_{name}"), place.re().clone());
        bindings.bind(&format!("y_{name}"), place.im().clone());
    }
    bindings.bind("s", slider.re().clone());
    bindings.bind("d", slider.im().clone());
    bindings.bind("omega", omega);
    bindings.bind("omega'", Angle::of_known_length(other, crank.clone()));
    bindings.bind("beta", Angle::of_known_length(rod, length.clone()));
    bindings.bind("epsilon", epsilon);
    bindings.bind("R", crank);
    bindings.bind("M", length);
    bindings.bind("S", side);
    Ok(bindings)
}
