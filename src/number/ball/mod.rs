//! Balls: rigorous arithmetic with a midpoint and a radius.
//!
//! An operation on balls gives a ball that holds every result of the operation on their numbers.
//! Midpoints are MPFR numbers rounded to nearest, radii are short and rounded upwards only.

mod angle;
mod constant;
mod decimal;
mod elementary;
mod enclosure;
mod kind;
mod radius;
mod sets;

use constant::Constant;
pub use decimal::BallText;
use enclosure::{Enclosure, sane_precision};

/// A real number known exactly, known to lie in a ball, or not defined.
///
/// * A bare *constant* is an exact rational without a precision. Constants combine exactly; one is
///   rounded when it meets an enclosure, to the precision of that enclosure, with the error in the
///   radius. An elementary function or a root of a constant, where not rational, says that nothing
///   is known, for there is no precision to compute it to.
/// * An *enclosure* has a precision, a midpoint and a radius. With an infinite radius it is the
///   whole line: nothing is known, as after a division by a ball that holds zero. The precision of
///   a result is the larger of the operands' precisions.
/// * *No value* is what an operation that is not defined leaves: a division by exact zero, the root
///   of a ball of negative numbers, and all that is computed from such.
///
/// A function of a ball that is partly outside its domain encloses the values on the rest.
#[derive(Clone, Debug)]
pub struct Ball(Content);

#[derive(Clone, Debug)]
enum Content {
    NoValue,
    Constant(Constant),
    Enclosure(Enclosure),
}

/// Precision of a whole line that stems from constants: the least, so that the other operand's
/// precision prevails.
const NO_PRECISION: u32 = 2;

impl Ball {
    const NO_VALUE: Ball = Ball(Content::NoValue);

    fn nothing_known() -> Ball {
        Ball::from(Enclosure::whole_line(NO_PRECISION))
    }

    fn value_exists(&self) -> bool {
        !matches!(self.0, Content::NoValue)
    }
}

impl From<Enclosure> for Ball {
    fn from(enclosure: Enclosure) -> Ball {
        Ball(Content::Enclosure(enclosure))
    }
}

impl From<Constant> for Ball {
    fn from(constant: Constant) -> Ball {
        Ball(Content::Constant(constant))
    }
}
