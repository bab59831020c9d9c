//! Seeds and sizes of the randomised tests.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// The generator of a test; its seed is `BURMESTER_SEED` where set, and is logged.
pub fn generator(test: &str) -> ChaCha8Rng {
    let seed = std::env::var("BURMESTER_SEED")
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(1888);
    eprintln!("{test}: BURMESTER_SEED={seed}");
    ChaCha8Rng::seed_from_u64(seed)
}

/// `usual`, a hundred times as many where `BURMESTER_LONG` is 1.
pub fn rounds(usual: usize) -> usize {
    if std::env::var("BURMESTER_LONG").is_ok_and(|value| value == "1") {
        100 * usual
    } else {
        usual
    }
}
