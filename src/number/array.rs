//! Elements of arrays and lists that belong together.

use std::array;

/// What stands at the same places.
pub(crate) fn pairs<'a, A, B, const N: usize>(
    first: &'a [A; N],
    second: &'a [B; N],
) -> [(&'a A, &'a B); N] {
    #[expect(
        clippy::indexing_slicing,
        reason = "the place is below N, the length of both"
    )]
    array::from_fn(|place| (&first[place], &second[place]))
}

/// Each with the next one, the last with the first: the sides of a polygon by its corners.
pub(crate) fn sides<A, const N: usize>(corners: &[A; N]) -> [(&A, &A); N] {
    #[expect(
        clippy::indexing_slicing,
        reason = "the place is below N, and so is what is left of the next one by N"
    )]
    array::from_fn(|place| (&corners[place], &corners[(place + 1) % N]))
}

/// Each of a list with the one after it; the last has none.
pub(crate) fn neighbours<T>(list: &[T]) -> impl Iterator<Item = (&T, &T)> {
    list.iter().zip(list.iter().skip(1))
}

/// Whether something holds for each two of a list.
pub(crate) fn every_two<T>(list: &[T], holds: impl Fn(&T, &T) -> bool) -> bool {
    let mut places = list.iter().enumerate();
    places.all(|(place, a)| list.iter().skip(place + 1).all(|b| holds(a, b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_meet() {
        assert_eq!(pairs(&[1, 2], &['a', 'b']), [(&1, &'a'), (&2, &'b')]);
        assert_eq!(sides(&[1, 2, 3]), [(&1, &2), (&2, &3), (&3, &1)]);
        assert!(neighbours(&[1, 2, 3]).eq([(&1, &2), (&2, &3)]));
        assert_eq!(neighbours::<i32>(&[]).count(), 0);
        assert!(every_two(&[1, 2, 3], |a, b| a != b) && !every_two(&[1, 2, 1], |a, b| a != b));
    }
}
