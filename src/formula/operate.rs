//! Operators, functions and predicates on values.

use rug::Rational;

use super::evaluate::{Failure, TOO_LARGE};
use super::function::Function;
use super::tree::{Operator, Tree};
use super::value::Value;
use crate::number::{Kind, Number, Real, Truth, linear};
use crate::plane::projective::{Line, ProjectivePoint};
use crate::plane::{Angle, Point, relation};

type Result<K> = std::result::Result<Value<K>, Failure>;

/// −x.
pub(super) fn negative<K: Kind>(value: Value<K>, tree: &Tree) -> Result<K> {
    match value {
        Value::Number(x) => Ok(Value::Number(-x)),
        Value::Point(z) => Ok(Value::Point(-z)),
        Value::Angle(angle) => Ok(Value::Angle(-&angle)),
        Value::Turn(turn) => Ok(Value::Turn(-turn)),
        other => Err(Failure::wrong(
            format!("{} has no negative", other.kind_name()),
            tree,
        )),
    }
}

/// x + y, x − y, x y, x / y.
pub(super) fn binary<K: Real>(
    operator: Operator,
    left: Value<K>,
    right: Value<K>,
    precision: &K::Precision,
    tree: &Tree,
) -> Result<K> {
    match (left, right) {
        (Value::Number(a), Value::Number(b)) => Ok(Value::Number(arithmetic(operator, a, b))),
        (Value::Turn(a), Value::Turn(b)) if adds(operator) => Ok(Value::Turn(match operator {
            Operator::Sub => a - b,
            _ => a + b,
        })),
        (a, b) => match (a.to_point(), b.to_point()) {
            (Some(a), Some(b)) => Ok(Value::Point(arithmetic(operator, a, b))),
            _ => with_angles(operator, a, b, precision, tree),
        },
    }
}

fn adds(operator: Operator) -> bool {
    matches!(operator, Operator::Add | Operator::Sub)
}

fn arithmetic<K: Kind>(operator: Operator, a: Number<K>, b: Number<K>) -> Number<K> {
    match operator {
        Operator::Add | Operator::PlusMinus => a + b,
        Operator::Sub | Operator::MinusPlus => a - b,
        Operator::Div => a / b,
        Operator::Mul | Operator::Juxtapose | Operator::Pow => a * b,
    }
}

/// Sums of angles, and angles times or divided by small integers.
fn with_angles<K: Real>(
    operator: Operator,
    left: Value<K>,
    right: Value<K>,
    precision: &K::Precision,
    tree: &Tree,
) -> Result<K> {
    let wrong = |left: &Value<K>, right: &Value<K>| {
        Failure::wrong(
            format!(
                "{} and {} do not go together here",
                left.kind_name(),
                right.kind_name()
            ),
            tree,
        )
    };
    let is_angle = |value: &Value<K>| matches!(value, Value::Angle(_) | Value::Turn(_));
    if adds(operator) && is_angle(&left) && is_angle(&right) {
        let (Some(a), Some(b)) = (left.to_angle(precision), right.to_angle(precision)) else {
            return Err(Failure::no_value(
                "this arithmetic does not hold the cosine of that angle",
                tree,
            ));
        };
        return Ok(Value::Angle(if operator == Operator::Sub {
            &a - &b
        } else {
            &a + &b
        }));
    }
    let (angle, factor) = match (operator, left, right) {
        (Operator::Mul | Operator::Juxtapose, Value::Number(n), angle) if is_angle(&angle) => {
            (angle, n)
        }
        (Operator::Mul | Operator::Juxtapose, angle, Value::Number(n)) if is_angle(&angle) => {
            (angle, n)
        }
        (Operator::Div, angle, Value::Number(n)) if is_angle(&angle) => (angle, n.inverse()),
        (_, left, right) => return Err(wrong(&left, &right)),
    };
    let factor = half_integer(&factor)
        .ok_or_else(|| Failure::wrong("an angle is multiplied by n or n/2 only", tree))?;
    match angle {
        Value::Turn(turn) => Ok(Value::Turn(turn * factor / 2)),
        Value::Angle(angle) if factor % 2 == 0 => Ok(Value::Angle(angle.times(factor / 2))),
        Value::Angle(angle) => Ok(Value::Angle(angle.half().times(factor))),
        other => Err(wrong(&other, &other)),
    }
}

/// Twice a number, where that is a small integer.
fn half_integer<K: Kind>(x: &Number<K>) -> Option<i32> {
    (-72..=72).find(|n| (2 * x - i64::from(*n)).is_zero().is_yes())
}

/// xⁿ for a constant n that is an integer or half of one.
pub(super) fn power<K: Real>(
    base: &Value<K>,
    exponent: Option<Rational>,
    tree: &Tree,
    exponent_tree: &Tree,
) -> Result<K> {
    let twice: Option<Rational> = exponent.map(|q| q * 2);
    let n = twice
        .as_ref()
        .filter(|q| q.is_integer() && q.numer().clone().abs() <= 512)
        .and_then(|q| q.numer().to_i32())
        .ok_or_else(|| {
            Failure::wrong(
                "an exponent is an integer or half of one, at most 256",
                exponent_tree,
            )
        })?;
    let root = n % 2 != 0;
    let power = match base {
        Value::Number(x) if root => Value::Number(x.clone().sqrt().power(n)),
        Value::Number(x) => Value::Number(x.power(n / 2)),
        Value::Point(z) if !root => Value::Point(z.power(n / 2)),
        other => {
            return Err(Failure::wrong(
                format!("{} has no such power", other.kind_name()),
                tree,
            ));
        }
    };
    // Of what has a value every positive power has one, unless it is too large.
    if n > 0 && !root && !power.has_value() {
        return Err(Failure::no_value(TOO_LARGE, tree));
    }
    Ok(power)
}

/// A function on its arguments.
pub(super) fn call<K: Real>(
    function: Function,
    arguments: &[Value<K>],
    precision: &K::Precision,
    tree: &Tree,
) -> Result<K> {
    let arguments = Arguments {
        values: arguments,
        precision,
        tree,
    };
    match function {
        Function::Sin => Ok(arguments.angle(0)?.sin().into()),
        Function::Cos => Ok(arguments.angle(0)?.cos().into()),
        Function::Tan => Ok(arguments.angle(0)?.tan().into()),
        Function::Cot => Ok(arguments.angle(0)?.cot().into()),
        Function::Cis => Ok(arguments.angle(0)?.cis().into()),
        Function::Arctan => Ok(Angle::from_tan(arguments.number(0)?).into()),
        Function::Arcsin => {
            let sin = arguments.number(0)?;
            Ok(Angle::from_cos_sin((1 - sin.square()).sqrt(), sin).into())
        }
        Function::Arccos => {
            let cos = arguments.number(0)?;
            let sin = (1 - cos.square()).sqrt();
            Ok(Angle::from_cos_sin(cos, sin).into())
        }
        Function::Sqrt => Ok(arguments.number(0)?.sqrt().into()),
        Function::Abs => match arguments.get(0)? {
            Value::Point(z) => Ok(z.norm().sqrt().into()),
            _ => Ok(arguments.number(0)?.abs().into()),
        },
        Function::Sign => match arguments.number(0)?.sign() {
            Some(sign) => Ok(Value::Number(Number::from(
                i64::from(sign.is_gt()) - i64::from(sign.is_lt()),
            ))),
            None => Err(Failure::no_value("a sign that cannot be told", tree)),
        },
        Function::Min => arguments.extreme(std::cmp::Ordering::Less),
        Function::Max => arguments.extreme(std::cmp::Ordering::Greater),
        Function::Re => Ok(arguments.point(0)?.re().clone().into()),
        Function::Im => Ok(arguments.point(0)?.im().clone().into()),
        Function::Conj => Ok(arguments.point(0)?.conj().into()),
        Function::Arg => Ok(Angle::of(arguments.point(0)?).into()),
        Function::Angle => {
            let (a, b, c) = (
                arguments.point(0)?,
                arguments.point(1)?,
                arguments.point(2)?,
            );
            Ok(Angle::at_vertex(&a, &b, &c).into())
        }
        Function::Dist => Ok(relation::distance(&arguments.point(0)?, &arguments.point(1)?).into()),
        Function::Line => {
            let (a, b) = (arguments.point(0)?, arguments.point(1)?);
            if (&a - &b).is_zero().is_yes() {
                return Err(Failure::no_value("a point with itself has no line", tree));
            }
            Ok(Value::Line(line(&a, &b)))
        }
        Function::Meet => Ok(Value::Point(meet(arguments.line(0)?, arguments.line(1)?))),
        Function::Det => arguments.determinant(),
        Function::Collinear
        | Function::Concyclic
        | Function::Perpendicular
        | Function::Parallel
        | Function::Similar => Err(Failure::wrong(
            "a claim stands where a value is needed",
            tree,
        )),
    }
}

/// A predicate on its arguments.
pub(super) fn predicate<K: Real>(
    function: Function,
    values: &[Value<K>],
    tree: &Tree,
) -> std::result::Result<Truth, Failure> {
    let points = |value: &Value<K>| -> std::result::Result<Vec<Point<K>>, Failure> {
        let Value::List(members) = value else {
            return Err(Failure::wrong("a list of points was expected", tree));
        };
        members
            .iter()
            .map(|member| as_point(member, tree))
            .collect()
    };
    match (function, values) {
        (Function::Collinear, values) => {
            let all = values.iter().map(|value| as_point(value, tree));
            Ok(relation::collinear(
                &all.collect::<std::result::Result<Vec<_>, _>>()?,
            ))
        }
        (Function::Concyclic, values) => {
            let all = values.iter().map(|value| as_point(value, tree));
            Ok(relation::concyclic(
                &all.collect::<std::result::Result<Vec<_>, _>>()?,
            ))
        }
        (Function::Perpendicular, [Value::Line(a), Value::Line(b)]) => {
            Ok(projective_line(a).is_perpendicular_to(&projective_line(b)))
        }
        (Function::Parallel, [Value::Line(a), Value::Line(b)]) => {
            Ok(projective_line(a).is_parallel_to(&projective_line(b)))
        }
        (Function::Similar, [a, b]) => Ok(relation::similar(&points(a)?, &points(b)?)),
        _ => Err(Failure::wrong(
            "these arguments do not fit this predicate",
            tree,
        )),
    }
}

fn as_point<K: Kind>(value: &Value<K>, tree: &Tree) -> std::result::Result<Point<K>, Failure> {
    value.to_point().ok_or_else(|| {
        Failure::wrong(
            format!("a point was expected, not {}", value.kind_name()),
            tree,
        )
    })
}

/// The line through two points.
fn line<K: Kind>(a: &Point<K>, b: &Point<K>) -> [Number<K>; 3] {
    let [a, b] = [a, b].map(ProjectivePoint::from_finite);
    Line::through(&a, &b).coefficients().clone()
}

fn projective_line<K: Kind>([a, b, c]: &[Number<K>; 3]) -> Line<K> {
    Line::new(a.clone(), b.clone(), c.clone())
}

/// Where two lines meet; no value for parallel ones.
fn meet<K: Kind>(first: &[Number<K>; 3], second: &[Number<K>; 3]) -> Point<K> {
    let meet = projective_line(first).meet(&projective_line(second));
    let [x, y, w] = meet.coordinates();
    Number::complex(x / w, y / w)
}

/// The arguments of a call, asked for by place and type.
struct Arguments<'a, K: Real> {
    values: &'a [Value<K>],
    precision: &'a K::Precision,
    tree: &'a Tree,
}

impl<K: Real> Arguments<'_, K> {
    fn get(&self, place: usize) -> std::result::Result<&Value<K>, Failure> {
        self.values
            .get(place)
            .ok_or_else(|| Failure::wrong("an argument is missing", self.tree))
    }

    fn unexpected<T>(&self, place: usize, expected: &str) -> std::result::Result<T, Failure> {
        let found = self.get(place)?.kind_name();
        Err(Failure::wrong(
            format!("{expected} was expected, not {found}"),
            self.tree,
        ))
    }

    fn number(&self, place: usize) -> std::result::Result<Number<K>, Failure> {
        match self.get(place)? {
            Value::Number(x) => Ok(x.clone()),
            _ => self.unexpected(place, "a number"),
        }
    }

    fn point(&self, place: usize) -> std::result::Result<Point<K>, Failure> {
        as_point(self.get(place)?, self.tree)
    }

    fn line(&self, place: usize) -> std::result::Result<&[Number<K>; 3], Failure> {
        match self.get(place)? {
            Value::Line(line) => Ok(line),
            _ => self.unexpected(place, "a line"),
        }
    }

    fn angle(&self, place: usize) -> std::result::Result<Angle<K>, Failure> {
        let value = self.get(place)?;
        match value.to_angle(self.precision) {
            Some(angle) => Ok(angle),
            None if matches!(value, Value::Turn(_)) => Err(Failure::no_value(
                "this arithmetic does not hold the cosine of that angle",
                self.tree,
            )),
            None => self.unexpected(place, "an angle"),
        }
    }

    fn extreme(&self, wanted: std::cmp::Ordering) -> Result<K> {
        let members = match self.values {
            [Value::List(members) | Value::Set(members)] => members,
            values => values,
        };
        let members = Arguments {
            values: members,
            ..*self
        };
        let mut best = members.number(0)?;
        for place in 1..members.values.len() {
            let other = members.number(place)?;
            match other.compare(&best) {
                Some(order) if order == wanted => best = other,
                Some(_) => {}
                None => return Err(Failure::no_value("an order that cannot be told", self.tree)),
            }
        }
        Ok(best.into())
    }

    fn determinant(&self) -> Result<K> {
        let rows: Vec<Vec<Point<K>>> = match self.get(0)? {
            Value::List(rows) => rows
                .iter()
                .map(|row| match row {
                    Value::List(row) => {
                        row.iter().map(|entry| as_point(entry, self.tree)).collect()
                    }
                    _ => Err(Failure::wrong("a list of rows was expected", self.tree)),
                })
                .collect::<std::result::Result<_, _>>()?,
            _ => return self.unexpected(0, "a list of rows"),
        };
        if rows.is_empty() || rows.iter().any(|row| row.len() != rows.len()) || rows.len() > 8 {
            return Err(Failure::wrong(
                "a determinant has as many columns as rows, at most 8",
                self.tree,
            ));
        }
        let determinant = linear::determinant(&rows);
        Ok(if determinant.im().is_zero().is_yes() {
            Value::Number(determinant.re().clone())
        } else {
            Value::Point(determinant)
        })
    }
}
