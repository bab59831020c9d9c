//! Chapter V: parameters that are +1 or −1.

use crate::number::{Number, Real};
use crate::scenes::{Free, Unbuilt};
use std::cmp::Ordering;

/// +1 or −1, the sign of a free number. Where symbols stay free it is any number: what holds for all
/// holds for these two.
pub(super) fn sense<K: Real>(free: &mut dyn Free<K>, name: &str) -> Result<Number<K>, Unbuilt> {
    let number = free.number(name)?;
    match number.sign() {
        Some(Ordering::Less) => Ok(-Number::one()),
        Some(Ordering::Greater) => Ok(Number::one()),
        _ if K::GENERIC => Ok(number),
        _ => Err(Unbuilt::NotHeld(format!("the sign of {name}"))),
    }
}
