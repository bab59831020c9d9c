//! Reading a design.

use rug::Rational;

use crate::oracle::ProblemError;
use crate::oracle::input::{Angle, Fields};
use crate::straight_line::ball_burmester::Alternate;

/// A design as it was asked for.
pub enum Given {
    /// A formula gives it.
    Closed(Closed),
    /// One of its angles is the zero of a function.
    Iterated(Iterated),
}

/// Designs that a formula gives.
pub enum Closed {
    /// α_a, α_b, α_d.
    BallBurmester([Angle; 3]),
    /// α_a, α_b.
    BallDoubleBurmester([Angle; 2]),
    /// k, α_a.
    InflectionPole(Rational, Angle),
    /// k.
    EqualCranks(Rational),
    /// k, α_a, α_d, and how far the slider is displaced.
    SliderCrank(Crank, Angle, Vec<Rational>),
    /// k, α_a, α_d, and one displacement.
    Intersection(Crank, Angle, Rational),
    /// k, α_a, ε.
    Symmetrical(Crank, Angle),
    /// R, T, γ, n, k.
    Watt(Rational, Rational, Angle, i64, Rational),
    /// α, β, ω, ρ, k.
    Evans([Angle; 3], Rational, Rational),
    /// r, α, k, n.
    Conchoid(Rational, Angle, Rational, i64),
    /// a, c, d.
    Symmetric([Rational; 3]),
    /// Q, R, S, T, M; ε, φ₀; whether B is left of the line from A to O_b.
    FourBar(Box<([Rational; 5], [Angle; 2], Option<bool>)>),
}

/// k and α_a.
#[derive(Clone)]
pub struct Crank {
    pub k: Rational,
    pub alpha_a: Angle,
}

/// Designs of which an angle is sought in a range of degrees.
pub struct Iterated {
    pub crank: Crank,
    pub sought: Sought,
    pub range: [Rational; 2],
}

/// What is asked of D's path beside its contact with the line in the design position.
#[derive(Clone)]
pub enum Sought {
    /// Two intersections, so far from the design position.
    Intersections([Rational; 2]),
    /// A tangent.
    Tangent(Rational),
    /// A Burmester point and an intersection.
    BallBurmester(Rational),
    /// Two inflections of a symmetrical curve with one tangent.
    TwoInflections,
}

const KINDS: [&str; 16] = [
    "ball-burmester",
    "ball-double-burmester",
    "inflection-pole",
    "equal-cranks",
    "slider-crank",
    "ball-intersection",
    "ball-two-intersections",
    "ball-tangent",
    "ball-burmester-intersection",
    "symmetrical",
    "two-inflections",
    "watt",
    "evans",
    "conchoid",
    "symmetric",
    "four-bar",
];

/// The design, and which alternates are asked for.
pub fn read(fields: &Fields<'_>) -> Result<(Given, Vec<Alternate>), ProblemError> {
    let kind = fields.word("kind", &KINDS)?.ok_or_else(|| {
        fields.error(
            "kind",
            format!(
                "this field is missing; expected one of {}",
                KINDS.join(", ")
            ),
        )
    })?;
    let only = |names: &[&str]| fields.only(&[&["kind"], names].concat());
    let angle = |name: &str| fields.angle(name);
    let number = |name: &str| fields.number(name);
    let crank = || -> Result<Crank, ProblemError> {
        Ok(Crank {
            k: number("k")?,
            alpha_a: angle("alpha_a")?,
        })
    };
    let iterated = |sought: Sought, range: [i32; 2]| -> Result<Given, ProblemError> {
        Ok(Given::Iterated(Iterated {
            crank: crank()?,
            sought,
            range: read_range(fields, range)?,
        }))
    };
    let given = match kind {
        "ball-burmester" => {
            only(&["alpha_a", "alpha_b", "alpha_d", "alternate"])?;
            Given::Closed(Closed::BallBurmester([
                angle("alpha_a")?,
                angle("alpha_b")?,
                angle("alpha_d")?,
            ]))
        }
        "ball-double-burmester" => {
            only(&["alpha_a", "alpha_b"])?;
            Given::Closed(Closed::BallDoubleBurmester([
                angle("alpha_a")?,
                angle("alpha_b")?,
            ]))
        }
        "inflection-pole" => {
            only(&["k", "alpha_a", "alternate"])?;
            Given::Closed(Closed::InflectionPole(number("k")?, angle("alpha_a")?))
        }
        "equal-cranks" => {
            only(&["k", "alternate"])?;
            Given::Closed(Closed::EqualCranks(number("k")?))
        }
        "slider-crank" => {
            only(&["k", "alpha_a", "alpha_d", "s", "alternate"])?;
            let displacements = match fields.has("s") {
                true => fields.numbers("s")?,
                false => Vec::new(),
            };
            Given::Closed(Closed::SliderCrank(
                crank()?,
                angle("alpha_d")?,
                displacements,
            ))
        }
        "ball-intersection" => {
            only(&["k", "alpha_a", "alpha_d", "s", "alternate"])?;
            Given::Closed(Closed::Intersection(
                crank()?,
                angle("alpha_d")?,
                displacement(fields)?,
            ))
        }
        "ball-two-intersections" => {
            only(&["k", "alpha_a", "s", "alpha_d", "alternate"])?;
            iterated(Sought::Intersections(two_displacements(fields)?), [0, 180])?
        }
        "ball-tangent" => {
            only(&["k", "alpha_a", "s", "alpha_d", "alternate"])?;
            iterated(Sought::Tangent(displacement(fields)?), [0, 180])?
        }
        "ball-burmester-intersection" => {
            only(&["k", "alpha_a", "s", "alpha_d", "alternate"])?;
            iterated(Sought::BallBurmester(displacement(fields)?), [0, 180])?
        }
        "symmetrical" => {
            only(&["k", "alpha_a", "epsilon"])?;
            Given::Closed(Closed::Symmetrical(crank()?, angle("epsilon")?))
        }
        "two-inflections" => {
            only(&["k", "alpha_a", "epsilon"])?;
            iterated(Sought::TwoInflections, [-180, 180])?
        }
        "watt" => {
            only(&["R", "T", "gamma", "n", "k"])?;
            Given::Closed(Closed::Watt(
                fields.positive("R")?,
                fields.positive("T")?,
                angle("gamma")?,
                sign(fields)?,
                number("k")?,
            ))
        }
        "evans" => {
            only(&["alpha", "beta", "omega", "rho", "k"])?;
            Given::Closed(Closed::Evans(
                [angle("alpha")?, angle("beta")?, angle("omega")?],
                number("rho")?,
                number("k")?,
            ))
        }
        "conchoid" => {
            only(&["r", "alpha", "k", "n"])?;
            Given::Closed(Closed::Conchoid(
                fields.positive("r")?,
                angle("alpha")?,
                fields.positive("k")?,
                sign(fields)?,
            ))
        }
        "four-bar" => {
            only(&["Q", "R", "S", "T", "M", "epsilon", "phi0", "assembly"])?;
            let positive = |name: &str| fields.positive(name);
            let lengths = [
                positive("Q")?,
                positive("R")?,
                positive("S")?,
                positive("T")?,
                number("M")?,
            ];
            let side = fields.word("assembly", &["left", "right"])?;
            Given::Closed(Closed::FourBar(Box::new((
                lengths,
                [angle("epsilon")?, angle("phi0")?],
                side.map(|side| side == "left"),
            ))))
        }
        _ => {
            only(&["a", "c", "d"])?;
            Given::Closed(Closed::Symmetric([
                number("a")?,
                number("c")?,
                number("d")?,
            ]))
        }
    };
    Ok((given, alternates(fields)?))
}

/// n: 1 or −1.
fn sign(fields: &Fields<'_>) -> Result<i64, ProblemError> {
    let n = fields.number("n")?;
    match n.to_f64() {
        1.0 => Ok(1),
        -1.0 => Ok(-1),
        _ => Err(fields.error("n", "1 or -1 was expected")),
    }
}

/// A displacement of the slider; none is no intersection of its own.
fn displacement(fields: &Fields<'_>) -> Result<Rational, ProblemError> {
    let s = fields.number("s")?;
    if s.is_zero() {
        return Err(fields.error(
            "s",
            "a displacement other than 0 was expected; for s = 0 the intersection falls on the \
             Ball point, which then is a Burmester point: `slider-crank`",
        ));
    }
    Ok(s)
}

fn two_displacements(fields: &Fields<'_>) -> Result<[Rational; 2], ProblemError> {
    let list = fields.numbers("s")?;
    let [first, second] = list.as_slice() else {
        return Err(fields.error("s", "a list of two displacements was expected"));
    };
    if first.is_zero() || second.is_zero() {
        return Err(fields.error(
            "s",
            "displacements other than 0 were expected; for one of 0 ask for \
             `ball-burmester-intersection`",
        ));
    }
    if first == second {
        return Err(fields.error(
            "s",
            "two different displacements were expected; for equal ones ask for `ball-tangent`",
        ));
    }
    Ok([first.clone(), second.clone()])
}

/// Where the angle is sought, in degrees.
fn read_range(fields: &Fields<'_>, whole: [i32; 2]) -> Result<[Rational; 2], ProblemError> {
    let name = if whole == [0, 180] {
        "alpha_d"
    } else {
        "epsilon"
    };
    let whole = whole.map(Rational::from);
    let Some(range) = fields.optional_object(name)? else {
        return Ok(whole);
    };
    range.only(&["from", "to"])?;
    let [least, most] = &whole;
    let [from, to] = [range.number("from")?, range.number("to")?];
    if from < to && *least <= from && to <= *most {
        Ok([from, to])
    } else {
        Err(fields.error(
            name,
            format!("a range in degrees within {least} to {most} was expected"),
        ))
    }
}

fn alternates(fields: &Fields<'_>) -> Result<Vec<Alternate>, ProblemError> {
    let names = Alternate::ALL.map(Alternate::name);
    Ok(match fields.word("alternate", &names)? {
        None => Alternate::ALL.to_vec(),
        Some(name) => Alternate::ALL
            .into_iter()
            .filter(|alternate| alternate.name() == name)
            .collect(),
    })
}
