//! Why parameters have no design.

use thiserror::Error;

/// A reason.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum NoDesign {
    /// A pivot would have to be at infinity.
    #[error("the pivot of {0} is at infinity: a slide, no crank")]
    PivotAtInfinity(&'static str),
    /// A pin would have to be at infinity.
    #[error("the pin {0} is at infinity")]
    PinAtInfinity(&'static str),
    /// A crank without length.
    #[error("the crank of {0} has no length")]
    NoLength(&'static str),
    /// Both cranks are the same.
    #[error("both cranks are the same")]
    OneCrank,
    /// Both pivots are the same.
    #[error("both cranks have one pivot, and the coupler turns about it")]
    OnePivot,
    /// Two of the Burmester points are not real.
    #[error("the two other Burmester points are complex")]
    Complex,
    /// Different rays fall on one another.
    #[error("{0}")]
    Rays(&'static str),
    /// The output point would be the pole, which stands still.
    #[error("the output point is the pole: its path has a cusp")]
    OutputAtPole,
    /// An equation has no real root.
    #[error("{0} has no real solution")]
    NotReal(&'static str),
    /// No position with the slider displaced so far.
    #[error("the slider does not come so far")]
    OutOfReach,
    /// The numbers at hand cannot tell.
    #[error("this cannot be decided at this precision")]
    Undecided,
}
