//! Relations between points: on a line, on a circle, alike. Each is the vanishing of a polynomial.

use super::Point;
use crate::number::{Kind, Number, Real, Truth};

/// Twice the area of the triangle, positive where A, B, C turn counterclockwise.
pub fn twice_area<K: Kind>(a: &Point<K>, b: &Point<K>, c: &Point<K>) -> Number<K> {
    ((b - a).conj() * (c - a)).im().clone()
}

/// The square of the distance of two points.
pub fn distance_squared<K: Kind>(a: &Point<K>, b: &Point<K>) -> Number<K> {
    (a - b).norm()
}

/// The distance of two points; no value where the kind does not hold the root.
pub fn distance<K: Real>(a: &Point<K>, b: &Point<K>) -> Number<K> {
    distance_squared(a, b).sqrt()
}

/// Whether all points lie on one line; fewer than three always do.
pub fn collinear<K: Kind>(points: &[Point<K>]) -> Truth {
    // Every triple, not those of the first two points alone: these may coincide.
    triples(points).fold(Truth::Yes, |all, (a, b, c)| {
        all & twice_area(a, b, c).is_zero()
    })
}

fn triples<T>(list: &[T]) -> impl Iterator<Item = (&T, &T, &T)> {
    list.iter().enumerate().flat_map(move |(i, a)| {
        list.iter()
            .enumerate()
            .skip(i + 1)
            .flat_map(move |(j, b)| list.iter().skip(j + 1).map(move |c| (a, b, c)))
    })
}

/// Whether all points lie on one circle or line; fewer than four always do. Of every four the cross
/// ratio is real.
pub fn concyclic<K: Kind>(points: &[Point<K>]) -> Truth {
    let mut truth = Truth::Yes;
    for (i, d) in points.iter().enumerate() {
        for (a, b, c) in triples(points.get(..i).unwrap_or_default()) {
            let cross = (a - c) * (b - d) * ((b - c) * (a - d)).conj();
            truth = truth & cross.im().is_zero();
        }
    }
    truth
}

/// Whether two figures are alike with the same sense of turning: all quotients of corresponding
/// sides are one complex number.
pub fn similar<K: Kind>(figure: &[Point<K>], other: &[Point<K>]) -> Truth {
    let (Some((a, rest)), Some((a1, rest1))) = (figure.split_first(), other.split_first()) else {
        return Truth::Unknown;
    };
    if rest.len() != rest1.len() {
        return Truth::No;
    }
    let mut truth = Truth::Yes;
    for (b, b1) in rest.iter().zip(rest1) {
        for (c, c1) in rest.iter().zip(rest1) {
            truth = truth & ((b - a) * (c1 - a1)).equals(&((c - a) * (b1 - a1)));
        }
    }
    truth
}
