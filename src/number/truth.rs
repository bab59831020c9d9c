//! Three-valued truth: what a predicate on an enclosure can answer.

use std::cmp::Ordering;
use std::ops::{BitAnd, BitOr, Not};

/// The answer of a predicate. `Unknown` means that the arithmetic cannot tell; it is never turned
/// into either of the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Truth {
    /// Proven false.
    No,
    /// Cannot be told in this arithmetic.
    Unknown,
    /// Proven true.
    Yes,
}

impl Truth {
    /// `true` only for [`Truth::Yes`].
    pub fn is_yes(self) -> bool {
        self == Truth::Yes
    }

    /// `true` only for [`Truth::No`].
    pub fn is_no(self) -> bool {
        self == Truth::No
    }

    /// `true` where it cannot be told.
    pub fn is_unknown(self) -> bool {
        self == Truth::Unknown
    }

    /// Whether a sign (`None`: cannot be told) satisfies a condition.
    pub fn of_sign(sign: Option<Ordering>, condition: impl Fn(Ordering) -> bool) -> Truth {
        sign.map_or(Truth::Unknown, |sign| condition(sign).into())
    }

    /// Both directions: true when the two are equally true.
    pub fn iff(self, other: Truth) -> Truth {
        (self & other) | (!self & !other)
    }

    /// Conjunction over many; [`Truth::Yes`] for none.
    pub fn all(truths: impl IntoIterator<Item = Truth>) -> Truth {
        truths.into_iter().fold(Truth::Yes, |all, one| all & one)
    }

    /// Disjunction over many; [`Truth::No`] for none.
    pub fn any(truths: impl IntoIterator<Item = Truth>) -> Truth {
        truths.into_iter().fold(Truth::No, |any, one| any | one)
    }
}

impl From<bool> for Truth {
    fn from(value: bool) -> Truth {
        if value { Truth::Yes } else { Truth::No }
    }
}

impl BitAnd for Truth {
    type Output = Truth;
    fn bitand(self, other: Truth) -> Truth {
        match (self, other) {
            (Truth::No, _) | (_, Truth::No) => Truth::No,
            (Truth::Yes, Truth::Yes) => Truth::Yes,
            _ => Truth::Unknown,
        }
    }
}

impl BitOr for Truth {
    type Output = Truth;
    fn bitor(self, other: Truth) -> Truth {
        !(!self & !other)
    }
}

impl Not for Truth {
    type Output = Truth;
    fn not(self) -> Truth {
        match self {
            Truth::No => Truth::Yes,
            Truth::Unknown => Truth::Unknown,
            Truth::Yes => Truth::No,
        }
    }
}
