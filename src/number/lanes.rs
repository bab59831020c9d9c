//! Several machine floats in one instruction, on whatever processor runs the program.
//!
//! A kernel is a function over any [`Simd`](fearless_simd::Simd), compiled once for each instruction
//! set. Of sums, products, quotients and roots each is rounded to nearest by IEEE 754, none is fused,
//! and the order is the written one; so results are the same to the last bit on every processor.

use std::sync::LazyLock;

use fearless_simd::Level;

/// Floats in one instruction; where the processor takes fewer, two instructions or four stand for one.
pub(crate) const LANES: usize = 4;

/// The largest instruction set that the processor has.
pub(crate) fn level() -> Level {
    static LEVEL: LazyLock<Level> = LazyLock::new(Level::new);
    *LEVEL
}

/// Too few for all lanes, and zeros.
#[inline(always)]
pub(crate) fn filled(few: &[f64]) -> [f64; LANES] {
    let mut all = [0.0; LANES];
    all.iter_mut().zip(few).for_each(|(place, x)| *place = *x);
    all
}

/// All instruction sets that can be tried here.
#[cfg(test)]
pub(crate) fn levels() -> Vec<Level> {
    let level = level();
    let mut levels = vec![Level::baseline(), level];
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    levels.extend(level.as_sse4_2().map(Level::Sse4_2));
    levels
}
