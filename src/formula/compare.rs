//! Relations between values.

use std::cmp::Ordering;

use rug::Rational;

use super::evaluate::{Failure, Scope};
use super::function::Function;
use super::tree::{Node, Relation, Tree};
use super::value::Value;
use crate::number::{Kind, Number, Real, Truth};
use crate::plane::{Angle, Point};

/// The sense in which `±` and `≷` are read at the moment.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Signs {
    /// `±` means + (or −).
    pub(super) plus: Option<bool>,
    /// `≷` means this.
    pub(super) alike: Option<Ordering>,
}

/// A chain holds when every relation in it holds between its two neighbours.
pub(super) fn chain<K: Real>(
    scope: &mut Scope<'_, K>,
    first: &Tree,
    rest: &[(Relation, Tree)],
    modulus: Option<&Tree>,
) -> Result<Truth, Failure> {
    let modulus = match modulus {
        Some(tree) => Some((scope.value(tree)?, tree)),
        None => None,
    };
    let mut truth = Truth::Yes;
    let mut left = first;
    for (relation, right) in rest {
        let step = match relation {
            Relation::Congruent => congruent(scope, left, right, modulus.as_ref())?,
            _ => related(scope, *relation, left, right)?,
        };
        truth = truth & for_all::<K>(step);
        left = right;
    }
    Ok(truth)
}

/// Where a number stands for many, that something is not true of all of them does not make its
/// contrary true of all.
pub(super) fn for_all<K: Real>(truth: Truth) -> Truth {
    if K::GENERIC && truth.is_no() {
        Truth::Unknown
    } else {
        truth
    }
}

fn related<K: Real>(
    scope: &mut Scope<'_, K>,
    relation: Relation,
    left: &Tree,
    right: &Tree,
) -> Result<Truth, Failure> {
    match relation {
        Relation::Equal => equal(scope, left, right),
        Relation::NotEqual => Ok(!for_all::<K>(equal(scope, left, right)?)),
        Relation::Proportional => {
            let (a, b) = (scope.value(left)?, scope.value(right)?);
            proportional(&members(a, left)?, &members(b, right)?, right)
        }
        _ => {
            let wanted = wanted_orders(relation, scope.signs().alike);
            let (a, b) = (scope.value(left)?, scope.value(right)?);
            let (Value::Number(a), Value::Number(b)) = (&a, &b) else {
                return Err(Failure::wrong(
                    format!("{} and {} have no order", a.kind_name(), b.kind_name()),
                    right,
                ));
            };
            // A square of a symbol has the sign of positive numbers, and is zero for one value.
            let strict = !wanted.contains(&Ordering::Equal);
            let sign = a.compare(b).filter(|_| !(K::GENERIC && strict));
            Ok(Truth::of_sign(sign, |order| wanted.contains(&order)))
        }
    }
}

fn wanted_orders(relation: Relation, alike: Option<Ordering>) -> Vec<Ordering> {
    use Ordering::{Equal, Greater, Less};
    match relation {
        Relation::Less => vec![Less],
        Relation::LessOrEqual => vec![Less, Equal],
        Relation::Greater => vec![Greater],
        Relation::GreaterOrEqual => vec![Greater, Equal],
        Relation::Alike => alike.into_iter().collect(),
        Relation::Opposite => alike.map(Ordering::reverse).into_iter().collect(),
        Relation::Equal | Relation::NotEqual | Relation::Congruent | Relation::Proportional => {
            vec![Equal]
        }
    }
}

fn equal<K: Real>(scope: &mut Scope<'_, K>, left: &Tree, right: &Tree) -> Result<Truth, Failure> {
    if let (Node::Ratio(a), Node::Ratio(b)) = (&left.node, &right.node) {
        let a = a
            .iter()
            .map(|part| scope.value(part))
            .collect::<Result<Vec<_>, _>>()?;
        let b = b
            .iter()
            .map(|part| scope.value(part))
            .collect::<Result<Vec<_>, _>>()?;
        return proportional(&a, &b, right);
    }
    if let Some((function, argument)) = inverse_function(right) {
        return equal_to_inverse(scope, left, function, argument);
    }
    if let Some((function, argument)) = inverse_function(left) {
        return equal_to_inverse(scope, right, function, argument);
    }
    let (a, b) = (scope.side(left)?, scope.side(right)?);
    same(&a, &b, scope.precision(), right)
}

/// `θ = arccos x` reads cos θ = x, and likewise for the others: the text seldom says which of the
/// angles with that cosine it means.
fn inverse_function(tree: &Tree) -> Option<(Function, &Tree)> {
    let Node::Call(function, arguments) = &tree.node else {
        return None;
    };
    let direct = match function {
        Function::Arcsin => Function::Sin,
        Function::Arccos => Function::Cos,
        Function::Arctan => Function::Tan,
        _ => return None,
    };
    Some((direct, arguments.first()?))
}

fn equal_to_inverse<K: Real>(
    scope: &mut Scope<'_, K>,
    angle: &Tree,
    function: Function,
    argument: &Tree,
) -> Result<Truth, Failure> {
    let value = scope.value(angle)?;
    let direct = super::operate::call(function, &[value], scope.precision(), angle)?;
    let argument_value = scope.side(argument)?;
    same(&direct, &argument_value, scope.precision(), argument)
}

/// Equality of two values of one type; sets are equal when each member of one equals some of the
/// other.
fn same<K: Real>(
    a: &Value<K>,
    b: &Value<K>,
    precision: &K::Precision,
    place: &Tree,
) -> Result<Truth, Failure> {
    let both = |a: &[Value<K>], b: &[Value<K>]| -> Result<Truth, Failure> {
        let mut all = Truth::Yes;
        for x in a {
            let mut any = Truth::No;
            for y in b {
                any = any | same(x, y, precision, place)?;
            }
            all = all & any;
        }
        Ok(all)
    };
    match (a, b) {
        (Value::Set(a), Value::Set(b)) => Ok(both(a, b)? & both(b, a)?),
        (Value::Set(a), b) => both(a, std::slice::from_ref(b)),
        (a, Value::Set(b)) => both(b, std::slice::from_ref(a)),
        (Value::List(a), Value::List(b)) => {
            if a.len() != b.len() {
                return Ok(Truth::No);
            }
            a.iter().zip(b).try_fold(Truth::Yes, |all, (x, y)| {
                Ok(all & same(x, y, precision, place)?)
            })
        }
        (Value::Line(a), Value::Line(b)) => Ok(minors_vanish(
            &a.each_ref().map(|x| x.clone().into()),
            &b.each_ref().map(|x| x.clone().into()),
        )),
        _ => {
            if let (Some(a), Some(b)) = (a.to_point(), b.to_point()) {
                return Ok(a.equals(&b));
            }
            let (a, b) = angles(a, b, precision, place)?;
            Ok(a.equals(&b))
        }
    }
}

/// Two values as angles; the number 0 is the angle 0.
fn angles<K: Real>(
    a: &Value<K>,
    b: &Value<K>,
    precision: &K::Precision,
    place: &Tree,
) -> Result<(Angle<K>, Angle<K>), Failure> {
    let angle = |value: &Value<K>| match value {
        Value::Number(zero) if zero.is_zero().is_yes() => {
            Value::Turn(Rational::new()).to_angle(precision)
        }
        value => value.to_angle(precision),
    };
    match (angle(a), angle(b)) {
        (Some(a), Some(b)) => Ok((a, b)),
        (_, None) if matches!(b, Value::Turn(_)) => Err(no_cosine(place)),
        (None, _) if matches!(a, Value::Turn(_)) => Err(no_cosine(place)),
        _ => Err(Failure::wrong(
            format!("{} cannot equal {}", a.kind_name(), b.kind_name()),
            place,
        )),
    }
}

fn no_cosine(place: &Tree) -> Failure {
    Failure::no_value(
        "this arithmetic does not hold the cosine of that angle",
        place,
    )
}

/// `a ≡ b mod m` for angles, where m is 2π/n or π/n.
fn congruent<K: Real>(
    scope: &mut Scope<'_, K>,
    left: &Tree,
    right: &Tree,
    modulus: Option<&(Value<K>, &Tree)>,
) -> Result<Truth, Failure> {
    let Some((modulus, place)) = modulus else {
        return Err(Failure::wrong("`≡` needs a modulus: `… mod pi`", right));
    };
    let (a, b) = (scope.value(left)?, scope.value(right)?);
    let (a, b) = angles(&a, &b, scope.precision(), right)?;
    let parts = match modulus {
        Value::Turn(turn) if !turn.is_zero() => Rational::from(2 / turn),
        _ => Rational::new(),
    };
    match parts.numer().to_u16() {
        Some(n) if (1..=360).contains(&n) && parts.is_integer() => {
            Ok(a.equals_modulo_turn_over(&b, n))
        }
        _ => Err(Failure::wrong(
            "the modulus must be 2 pi divided by an integer, at most 360",
            place,
        )),
    }
}

fn members<K: Kind>(value: Value<K>, place: &Tree) -> Result<Vec<Value<K>>, Failure> {
    match value {
        Value::List(members) => Ok(members),
        Value::Line(coefficients) => Ok(coefficients.map(Value::Number).into()),
        number @ (Value::Number(_) | Value::Point(_)) => Ok(vec![number]),
        other => Err(Failure::wrong(
            format!("`~` compares lists, not {}", other.kind_name()),
            place,
        )),
    }
}

/// Whether two lists are equal up to a factor that is not zero.
fn proportional<K: Kind>(a: &[Value<K>], b: &[Value<K>], place: &Tree) -> Result<Truth, Failure> {
    if a.len() != b.len() {
        return Err(Failure::wrong(
            format!("{} parts stand against {}", a.len(), b.len()),
            place,
        ));
    }
    let points = |list: &[Value<K>]| -> Result<Vec<Point<K>>, Failure> {
        list.iter()
            .map(|part| {
                part.to_point().ok_or_else(|| {
                    Failure::wrong(
                        format!("a part of a ratio is a number, not {}", part.kind_name()),
                        place,
                    )
                })
            })
            .collect()
    };
    Ok(minors_vanish(&points(a)?, &points(b)?))
}

fn minors_vanish<K: Kind>(a: &[Point<K>], b: &[Point<K>]) -> Truth {
    let mut truth =
        !Truth::all(a.iter().map(Number::is_zero)) & !Truth::all(b.iter().map(Number::is_zero));
    for (i, (a1, b1)) in a.iter().zip(b).enumerate() {
        for (a2, b2) in a.iter().zip(b).skip(i + 1) {
            truth = truth & (a1 * b2).equals(&(a2 * b1));
        }
    }
    truth
}
