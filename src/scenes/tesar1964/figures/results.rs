//! What the figures list of a linkage: its dimensions, and the results of the program.

use std::cell::OnceCell;
use std::cmp::Ordering;
use std::rc::Rc;

use rug::Rational;

use crate::formula::Bindings;
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Ball, Elementary, Number};
use crate::plane::Point;
use crate::scenes::Unbuilt;
use crate::straight_line::design::Design;
use crate::straight_line::deviation::arc::{Arcs, Limit};
use crate::straight_line::deviation::driven::Driven;
use crate::straight_line::deviation::rows::Rows;
use crate::straight_line::deviation::stepped::{Record, Rule, records};

/// Where D is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// On the line through the pins, as the design wants it.
    OnLine,
    /// Anywhere.
    Anywhere,
}

/// The levels of the deviation up to which a travel counts, in unit lengths.
pub type Levels = [(i64, i64); 3];

/// Those of the linkages with five infinitely near positions on the line.
pub const FINE: Levels = [(1, 10_000), (1, 100), (1, 20)];

/// Those of the others.
pub const COARSE: Levels = [(1, 100), (1, 20), (1, 10)];

/// An angle in degrees, in (−180°, 180°].
pub fn in_degrees<K: Elementary>(direction: &Point<K>, precision: &K::Precision) -> Number<K> {
    direction.im().clone().atan2(direction.re()) * 180 / Number::pi(precision)
}

/// The same angle, or its double for lines, from 0° to a whole turn.
pub fn not_negative<K: Elementary>(degrees: Number<K>, whole: i64) -> Number<K> {
    match degrees.sign() {
        Some(Ordering::Less) => degrees + whole,
        _ => degrees,
    }
}

/// Binds the dimensions of a design and the results for three levels.
pub fn bind<K: Elementary>(
    design: &Design<K>,
    output: Output,
    levels: Levels,
    rule: Rule,
    bindings: &mut Bindings<K>,
) -> Result<(), Unbuilt> {
    let precision = bindings.precision().clone();
    let design = &rounded(design, &precision);
    let unit = design.unit();
    for (name, square) in design.squared_lengths() {
        bindings.bind(name, square.sqrt() / &unit);
    }
    let [(_, opening), (_, crank), ..] = design.turns();
    let phi = in_degrees(&crank, &precision);
    bindings.bind("phi_0", not_negative(phi, 360));
    let epsilon = match output {
        Output::Anywhere => in_degrees(&opening, &precision),
        Output::OnLine => flat(&opening)?,
    };
    bindings.bind("epsilon", epsilon);
    let undecided = || Unbuilt::NotReal("an angle or a comparison is not decided".to_owned());
    let driven = Driven::new(design).ok_or_else(undecided)?;
    let bounds = levels.map(|(numerator, denominator)| Number::ratio(numerator, denominator));
    for (place, (numerator, denominator)) in levels.into_iter().enumerate() {
        let parts = Number::<K>::from(denominator / numerator);
        bindings.bind(&format!("n_{}", place + 1), parts);
    }
    let names = (1..=levels.len()).flat_map(|level| RECORDED.map(|name| format!("{name}{level}")));
    bindings.bind_later(names, move || {
        let rows = Rows::new(&driven, &unit, &precision)?;
        let side = |side| records(|degrees| rows.met(degrees), &bounds, side, rule);
        let mut found = Vec::new();
        for (from, to) in side(-1)?.into_iter().zip(side(1)?) {
            // None where half a turn keeps within a level.
            found.extend(recorded(&from?, &to?)?);
        }
        Some(found)
    });
    Ok(())
}

/// What the program records for each level.
const RECORDED: [&str; 5] = ["L_", "phi_", "psi_", "gamma_a", "gamma_b"];

/// What a figure lists, and its linkage.
pub type Listed<K> = (Bindings<K>, Design<K>);

/// Adds the exact arcs to the results.
pub fn with_arcs(
    (mut bindings, design): Listed<Ball>,
    levels: Levels,
) -> Result<Bindings<Ball>, Unbuilt> {
    let bits = *bindings.precision();
    let design = rounded(&design, &bits);
    let undecided = || Unbuilt::NotReal("the arc of a level is not decided".to_owned());
    let driven = Driven::new(&design).ok_or_else(undecided)?;
    let (arcs, unit) = (Rc::new(Arcs::new(driven, bits)), design.unit());
    for (place, (numerator, denominator)) in levels.into_iter().enumerate() {
        let level = Rc::new(Level {
            arcs: arcs.clone(),
            bound: &unit * Number::<Ball>::ratio(numerator, denominator),
            unit: unit.clone(),
            ends: OnceCell::new(),
        });
        let numbered = |name: &str| format!("{name}{}e", place + 1);
        let at_ends = level.clone();
        let names = ["L_", "phi_", "gamma_a", "gamma_b"].map(numbered);
        bindings.bind_later(names, move || at_ends.at_ends());
        bindings.bind_later([numbered("psi_")], move || Some(vec![level.psi()?]));
    }
    Ok(bindings)
}

/// The exact arc of a level.
struct Level {
    arcs: Rc<Arcs>,
    bound: Number<Ball>,
    unit: Number<Ball>,
    ends: OnceCell<Option<[Limit; 2]>>,
}

impl Level {
    fn ends(&self) -> Option<&[Limit; 2]> {
        let within = || self.arcs.within(&self.bound);
        self.ends.get_or_init(within).as_ref()
    }

    /// Travel, turn of R, and the lesser of both angles at either pin.
    fn at_ends(&self) -> Option<Vec<Number<Ball>>> {
        let Level { arcs, unit, .. } = self;
        let ends = self.ends()?;
        let [from, to] = ends.each_ref().map(|end| arcs.position(end));
        let (from, to) = (from?, to?);
        let [at_from, at_to] = [&from, &to].map(|end| arcs.coordinates(end));
        let [first, second] = [&from, &to].map(|end| arcs.transmission_angles(end));
        let mut found = vec![
            (&at_to[0] - &at_from[0]).abs() / unit,
            &ends[1].degrees - &ends[0].degrees,
        ];
        for (x, y) in first.into_iter().zip(second) {
            let is_first = x.compare(&y)? == Ordering::Less;
            found.push(if is_first { x } else { y });
        }
        Some(found)
    }

    /// The turn of T.
    fn psi(&self) -> Option<Number<Ball>> {
        let ends = self.ends()?.each_ref();
        let [back, forth] = ends.map(|end| self.arcs.turn_of_rocker(end));
        Some(back?.abs() + forth?.abs())
    }
}

/// The same design in numbers of this precision: roots of exact ones would have none.
fn rounded<K: Elementary>(design: &Design<K>, precision: &K::Precision) -> Design<K> {
    let one = Number::rounded(&Rational::from(1), precision);
    let point = |z: &Point<K>| z.scaled(&one);
    let CouplerPoint {
        pivots,
        pins,
        point: d,
    } = &design.linkage;
    Design {
        linkage: CouplerPoint {
            pivots: pivots.each_ref().map(point),
            pins: pins.each_ref().map(point),
            point: point(d),
        },
        direction: point(&design.direction),
    }
}

/// 0 or 180, for an angle whose sides are on one line.
fn flat<K: Elementary>(opening: &Point<K>) -> Result<Number<K>, Unbuilt> {
    Unbuilt::unless_true::<K>(opening.im().is_zero(), "D is on the line through A and B")?;
    match opening.re().sign() {
        Some(Ordering::Greater) => Ok(Number::zero()),
        Some(Ordering::Less) => Ok(Number::from(180)),
        _ => Err(Unbuilt::NotReal("D is in A".to_owned())),
    }
}

/// What is recorded at both ends of a level; `None` where a comparison is not decided.
fn recorded<K: Elementary>(from: &Record<K>, to: &Record<K>) -> Option<[Number<K>; 5]> {
    let lesser = |i: usize| -> Option<Number<K>> {
        let [x, y] = [from.row.gamma.get(i)?, to.row.gamma.get(i)?];
        let is_first = x.compare(y)? == Ordering::Less;
        Some(if is_first { x } else { y }.clone())
    };
    let turn = to.degrees.max(0) - from.degrees.min(0);
    let psi = from.row.psi.abs() + to.row.psi.abs();
    Some([
        from.row.u.abs() + to.row.u.abs(),
        i64::from(turn).into(),
        to_whole(&psi)?,
        lesser(0)?,
        lesser(1)?,
    ])
}

/// A number that is not negative and less than 720 to the nearest whole one.
fn to_whole<K: Elementary>(x: &Number<K>) -> Option<Number<K>> {
    for whole in 0..720 {
        let ends_below = x.compare(&Number::ratio(2 * whole + 1, 2))?;
        if ends_below == Ordering::Less {
            return Some(Number::from(whole));
        }
    }
    None
}
