//! The parts of a name in canonical spelling.

/// Stem, index and primes.
pub(super) struct Parts<'a> {
    /// What stands before the index.
    pub stem: &'a str,
    /// The index without its braces.
    pub index: Option<&'a str>,
    /// How many primes follow.
    pub primes: usize,
}

/// Takes a name apart.
pub(super) fn parts(name: &str) -> Parts<'_> {
    let unprimed = name.trim_end_matches('\'');
    let primes = name.len() - unprimed.len();
    match unprimed.split_once('_') {
        Some((stem, index)) => Parts {
            stem,
            index: Some(
                index
                    .strip_prefix('{')
                    .and_then(|inner| inner.strip_suffix('}'))
                    .unwrap_or(index),
            ),
            primes,
        },
        None => Parts {
            stem: unprimed,
            index: None,
            primes,
        },
    }
}

/// The name of this stem, index and so many primes, without needless braces.
pub(super) fn with_index(stem: &str, index: &str, primes: usize) -> String {
    let primes = "'".repeat(primes);
    let plain = index
        .chars()
        .all(|character| character.is_ascii_alphanumeric());
    if plain {
        format!("{stem}_{index}{primes}")
    } else {
        format!("{stem}_{{{index}}}{primes}")
    }
}
