//! The poles of four positions and which of them are opposite.

use crate::number::Truth;
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};

pub const CHECK: Check = Check {
    name: "opposite-pole-pairs",
    summary: "Of the six pairs of four positions, two without a common position make an opposite pair of \
              poles: exactly the three pairs that the text lists. Any two of these are the diagonals of a \
              quadrilateral, each of whose sides joins two poles with a common position; there are \
              three. The wrong variant takes the pairs with a common position.",
    run,
};

type Pole = [u8; 2];

/// As the text lists them.
const LISTED: [[Pole; 2]; 3] = [[[1, 2], [3, 4]], [[2, 3], [1, 4]], [[2, 4], [1, 3]]];

fn run() -> Result<Report, Unbuilt> {
    Ok(Report {
        holds: claim(|pole, other| !share(pole, other)),
        wrong_variant: claim(share),
        basis: Basis::Exact,
        instances: 1,
        exception: None,
    })
}

fn share(pole: Pole, other: Pole) -> bool {
    pole.iter().any(|position| other.contains(position))
}

fn poles() -> Vec<Pole> {
    (1..=4)
        .flat_map(|i| (i + 1..=4).map(move |j| [i, j]))
        .collect()
}

fn pairs_of<T: Copy>(list: &[T]) -> Vec<[T; 2]> {
    list.iter()
        .enumerate()
        .flat_map(|(i, a)| list.iter().skip(i + 1).map(move |b| [*a, *b]))
        .collect()
}

fn claim(is_opposite: impl Fn(Pole, Pole) -> bool) -> Truth {
    let pairs: Vec<[Pole; 2]> = pairs_of(&poles())
        .into_iter()
        .filter(|[pole, other]| is_opposite(*pole, *other))
        .collect();
    let listed = |[pole, other]: &[Pole; 2]| {
        LISTED.contains(&[*pole, *other]) || LISTED.contains(&[*other, *pole])
    };
    let quadrilaterals = pairs_of(&pairs);
    let has_sides = |[[a, c], [b, d]]: &[[Pole; 2]; 2]| {
        [(a, b), (b, c), (c, d), (d, a)]
            .iter()
            .all(|(pole, next)| share(**pole, **next))
    };
    let right = pairs.len() == LISTED.len()
        && pairs.iter().all(listed)
        && quadrilaterals.len() == 3
        && quadrilaterals.iter().all(has_sides);
    right.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
    }
}
