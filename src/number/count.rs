//! Counts and places as numbers of other types.

/// No collection has more elements than `i64` holds.
pub(crate) fn to_i64(count: usize) -> i64 {
    i64::try_from(count).unwrap_or(i64::MAX)
}

/// No collection has more elements than `u64` holds.
pub(crate) fn to_u64(count: usize) -> u64 {
    u64::try_from(count).unwrap_or(u64::MAX)
}

/// What does not fit memory is as good as infinite.
pub(crate) fn to_u32(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}

/// Exact up to 2⁵³.
pub(crate) fn to_f64(count: usize) -> f64 {
    #[expect(
        clippy::as_conversions,
        reason = "there is no other way from an integer of this size to a double; it rounds"
    )]
    {
        count as f64
    }
}

/// What a collection cannot have is as good as infinite.
pub(crate) fn from_u32(count: u32) -> usize {
    usize::try_from(count).unwrap_or(usize::MAX)
}

/// What a collection cannot have is as good as infinite.
pub(crate) fn from_u64(count: u64) -> usize {
    usize::try_from(count).unwrap_or(usize::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_keep_their_value_or_become_the_largest() {
        assert_eq!((to_i64(7), to_u64(7), to_u32(7)), (7, 7, 7));
        assert_eq!((from_u32(7), from_u64(7)), (7, 7));
        assert_eq!(to_u32(usize::MAX), u32::MAX);
        assert!((to_f64(1 << 20) - f64::from(1 << 20)).abs() < 0.5);
    }
}
