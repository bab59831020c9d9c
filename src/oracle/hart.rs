//! `hart`: Hart's straight-line mechanism.

use rug::Rational;
use serde_json::{Map, Value, json};

use super::input::Fields;
use super::{Arithmetic, ProblemError, Request, output};
use crate::linkage::hart::Hart;
use crate::number::{Exact, Number};

/// Reads and solves the problem. All of it is rational.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    fields.only(&["m", "n", "d", "kappa"])?;
    let kappa = fields.number("kappa")?;
    if kappa.is_zero() || Rational::from(kappa.square_ref()) == 1 {
        return Err(ProblemError::new("kappa", "kappa is none of 0, 1, -1"));
    }
    let number = |q: Rational| Number::<Exact>::from(q);
    let hart = Hart {
        m: number(fields.positive("m")?),
        n: number(fields.positive("n")?),
        d: number(fields.positive("d")?),
        kappa: number(kappa),
    };
    let value = |number: &Number<Exact>| match (number.0.rational(), request.arithmetic) {
        (None, _) => Value::Null,
        (Some(q), Arithmetic::Certified) => output::exact(q),
        (Some(q), Arithmetic::Float) => output::float(q.to_f64()),
    };
    let (a, b) = hart.arms();
    let mut answer = Map::new();
    let numbers = [
        ("m", hart.m.clone()),
        ("p", hart.p()),
        ("q", hart.q()),
        ("n", hart.n.clone()),
        ("a", a),
        ("b", b),
        ("c", hart.coupler()),
        ("d", hart.d.clone()),
        ("x", hart.abscissa()),
    ];
    for (name, number) in &numbers {
        answer.insert((*name).into(), value(number));
    }
    answer.insert("line".into(), json!(line(&hart.abscissa())));
    Ok(answer)
}

/// The line x = const as primitive integers A, B, C of A x + B y + C = 0.
fn line(x: &Number<Exact>) -> Option<[Value; 3]> {
    let q = x.0.rational()?;
    let zero = Rational::new();
    let constant = Rational::from(-q.numer());
    Some([&Rational::from(q.denom()), &zero, &constant].map(output::exact))
}
