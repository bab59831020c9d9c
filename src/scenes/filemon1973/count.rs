//! Numbers of tangents from points of the centerpoint curve.

use crate::formula::Bindings;
use crate::number::{Number, Real, count};
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::plane::tangents::{Count, Pencil};
use crate::scenes::Unbuilt;

/// The tangents from a point of the curve.
pub fn tangents_from<K: Real>(curve: &Cubic<K>, point: &Point<K>) -> Result<Count, Unbuilt> {
    counted(&Pencil::new(curve, point, [Number::one(), Number::i()]))
}

/// The tangents among the lines of a pencil.
pub fn counted<K: Real>(pencil: &Pencil<K>) -> Result<Count, Unbuilt> {
    pencil
        .count()
        .ok_or_else(|| Unbuilt::NotHeld("the number of real tangents".to_owned()))
}

/// A count as a number.
pub fn number<K: Real>(count: usize) -> Number<K> {
    Number::from(count::to_i64(count))
}

/// Binds a count.
pub fn bind_number<K: Real>(bindings: &mut Bindings<K>, name: &str, count: usize) {
    bindings.bind(name, number::<K>(count));
}
