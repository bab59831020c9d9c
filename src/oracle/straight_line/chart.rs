//! A chart for designers: how long the point keeps to its line within a hundredth of the linkage's
//! size, for all linkages with a Ball-double-Burmester point on a grid of their two rays.

use rug::Rational;

use super::deviation::crank;
use super::writer::passage;
use crate::number::text::round_to_decimals;
use crate::number::{Ball, Number, Real, Surd, count};
use crate::oracle::linkages::words;
use crate::plane::Angle;
use crate::straight_line::ball_burmester::{Alternate, double};
use crate::straight_line::design::Design;
use crate::straight_line::deviation::arc::Arcs;
use crate::straight_line::deviation::driven::Driven;
use crate::straight_line::no_design::NoDesign;

/// The accuracy, in unit lengths.
const LEVEL: [i32; 2] = [1, 100];
/// Bits of the first attempt at a row, and of the last.
const BITS: [u32; 2] = [128, 2048];

/// The names of the columns.
pub const COLUMNS: &str = "alpha_a,alpha_b,L,type,crank,Q,R,S,T,M,gamma,from,to,none";

/// α_a and α_b in degrees.
pub type Rays = [u32; 2];

/// All points of the grid: 0 <= α_a <= 90, α_a < α_b < 180.
pub fn grid(step: u32) -> Vec<Rays> {
    let step = count::from_u32(step.max(1));
    let row = |a: u32| {
        (0..180)
            .step_by(step)
            .filter(move |b| *b > a)
            .map(move |b| [a, b])
    };
    (0..=90).step_by(step).flat_map(row).collect()
}

/// What the columns are, as comments.
pub fn header(step: u32) -> String {
    let lines = [
        format!(
            "Four-bars with a Ball-double-Burmester point D, alpha_a and alpha_b in steps of {step} degrees."
        ),
        format!(
            "Made by burmester {} with the command: burmester chart{}",
            env!("CARGO_PKG_VERSION"),
            match step {
                1 => String::new(),
                _ => format!(" --step {step}"),
            }
        ),
        "Lengths are divided by (Q + R + S + T + (M + N)/2)/5. Every number is rounded from a rigorous enclosure."
            .to_owned(),
        "L: travel of D within 0.01 of its line about the design position, the crank R being turned."
            .to_owned(),
        "crank: which of R = O_aA and T = O_bB turns fully. Q = O_aO_b, S = AB, M = AD.".to_owned(),
        "gamma: the least acute angle between coupler AB and follower O_bB on the way, in degrees."
            .to_owned(),
        "from, to: why the way ends backwards and forwards. none: why there is no such linkage."
            .to_owned(),
    ];
    let mut text: String = lines.map(|line| format!("# {line}\n")).concat();
    text.push_str(COLUMNS);
    text.push('\n');
    text
}

/// A row of the table.
pub struct Row {
    /// The row, without its end.
    pub text: String,
    /// How many ends its arc has: two, or none where there is no linkage.
    pub ends: usize,
    /// How many of them took a search of all angles.
    pub searches: usize,
}

/// The row of a point of the grid, with more bits until all its digits are certain.
pub fn row([a, b]: Rays) -> Row {
    let mut bits = BITS[0];
    let (rest, ends, searches) = loop {
        match Member::of([a, b], bits) {
            Err(reason) if reason != NoDesign::Undecided => {
                break (format!("{}\"{reason}\"", ",".repeat(11)), 0, 0);
            }
            Ok(member) => {
                if let Some(rest) = member.written() {
                    break (rest, 2, member.arcs.searches());
                }
            }
            Err(_) => {}
        }
        if bits >= BITS[1] {
            break (
                format!("{}\"{}\"", ",".repeat(11), NoDesign::Undecided),
                0,
                0,
            );
        }
        bits *= 2;
    };
    Row {
        text: format!("{a},{b},{rest}"),
        ends,
        searches,
    }
}

/// A linkage of the chart.
pub struct Member {
    /// The linkage.
    pub design: Design<Ball>,
    /// Its unit length.
    pub unit: Number<Ball>,
    /// Its arcs.
    pub arcs: Arcs,
    bits: u32,
}

impl Member {
    /// The linkage of two rays.
    ///
    /// # Errors
    /// There is none, or that cannot be told.
    pub fn of([a, b]: Rays, bits: u32) -> Result<Self, NoDesign> {
        // What balls cannot tell: sin(α_a + α_b) = 0 is sin α_d = 0, cos(α_a + α_b) = 0 is k = 0.
        if a + b == 180 {
            return Err(NoDesign::OutputAtPole);
        }
        if a + b == 90 && a > 0 {
            return Err(NoDesign::OnePivot);
        }
        // Other rays that fall on one another are multiples of 15°.
        if let Some(Err(reason)) = of_rays::<Surd>([a, b], &())
            && reason != NoDesign::Undecided
        {
            return Err(reason);
        }
        let design = of_rays::<Ball>([a, b], &bits).ok_or(NoDesign::Undecided)??;
        let driven = Driven::new(&design).ok_or(NoDesign::Undecided)?;
        Ok(Member {
            unit: design.unit(),
            arcs: Arcs::new(driven, bits),
            design,
            bits,
        })
    }

    /// The bound of the deviation.
    pub fn bound(&self) -> Number<Ball> {
        let level = Rational::from((LEVEL[0], LEVEL[1]));
        &self.unit * Number::<Ball>::rounded(&level, &self.bits)
    }

    /// The columns from L on; `None` where a digit is not certain.
    fn written(&self) -> Option<String> {
        let arc = self.arcs.within(&self.bound())?;
        let [from, to] = arc.each_ref().map(|limit| {
            let position = self.arcs.position(limit)?;
            let [u, _] = self.arcs.coordinates(&position);
            Some(u)
        });
        let length = (to? - from?).abs() / &self.unit;
        let passage = passage(&self.design, &[]);
        let kind = passage.link_type().map_or("undecided", words::name);
        let crank = crank(&passage).unwrap_or("undecided");
        let mut columns = vec![decimals(&length, 5)?, kind.to_owned(), crank.to_owned()];
        for (_, square) in &self.design.squared_lengths()[..5] {
            columns.push(decimals(&(square.clone().sqrt() / &self.unit), 4)?);
        }
        let gamma = self.arcs.closed().least_transmission(&arc, self.bits)?;
        columns.push(decimals(&gamma, 1)?);
        columns.extend(arc.each_ref().map(|limit| limit.end.name().to_owned()));
        columns.push(String::new());
        Some(columns.join(","))
    }
}

/// The design; `None` where the kind does not hold the angles.
fn of_rays<K: Real>(rays: Rays, precision: &K::Precision) -> Option<Result<Design<K>, NoDesign>> {
    let angle = |degrees: u32| Angle::from_degrees(&degrees.into(), precision);
    let [a, b] = rays.map(angle);
    Some(double(&a?, &b?).and_then(|cranks| cranks.design(Alternate::First)))
}

/// Rounded to so many decimals; `None` where that is not the same for all numbers of the ball.
fn decimals(number: &Number<Ball>, places: u32) -> Option<String> {
    let low = round_to_decimals(&number.0.lower()?, places);
    let high = round_to_decimals(&number.0.upper()?, places);
    (low == high).then_some(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_certain_or_missing() {
        let ball = |p: i32, q: i32, radius: i32| {
            let radius = Rational::from((1, radius));
            Number(Ball::with_radius(&Rational::from((p, q)), &radius, 100))
        };
        assert_eq!(
            decimals(&ball(1, 3, 1_000_000), 4).as_deref(),
            Some("0.3333")
        );
        assert_eq!(
            decimals(&ball(-5, 2, 1_000_000), 3).as_deref(),
            Some("-2.500")
        );
        assert_eq!(decimals(&ball(0, 1, 1_000_000), 1).as_deref(), Some("0.0"));
        assert_eq!(decimals(&ball(5, 100, 1_000_000), 1), None);
    }

    #[test]
    fn the_grid_is_half_of_the_rays() {
        assert_eq!(grid(1).len(), 12_194);
        assert_eq!(grid(90), [[0, 90]]);
        assert!(grid(30).contains(&[90, 150]) && !grid(30).contains(&[30, 30]));
    }
}
