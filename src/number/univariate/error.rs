//! Why roots were not isolated.

/// Why the roots of a polynomial were not isolated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RootError {
    /// A coefficient is the result of an undefined operation.
    #[error("a coefficient of the polynomial has no value")]
    NoValue,
    /// The polynomial is zero: every number is a root.
    #[error("every number is a root of the zero polynomial")]
    ZeroPolynomial,
    /// The roots were not told apart with so many bits. In theory some precision always suffices;
    /// this one is far beyond what any polynomial met so far has needed.
    #[error("the complex roots could not be told apart with {bits} bits")]
    NotSeparated {
        /// The largest working precision that was tried.
        bits: u32,
    },
}
