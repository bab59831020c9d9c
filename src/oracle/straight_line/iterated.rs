//! Designs of which an angle is the zero of a function.

use rug::Rational;

use super::given::{Iterated, Sought};
use super::solution::{Place, Rounded, Solution, Source, slider_crank};
use crate::curvature::slider_crank::SliderCrank;
use crate::number::zeros::{Function, Zeros, zeros};
use crate::number::{Ball, Number, Series};
use crate::plane::Angle;
use crate::straight_line::ball_burmester::{Alternate, of_slider_crank};
use crate::straight_line::no_design::NoDesign;
use crate::straight_line::six_points::{Sixth, equation};
use crate::straight_line::slider_crank::{Assembly, guide, joints};
use crate::straight_line::symmetrical::{Symmetrical, rays_of_d};
use crate::straight_line::turning;

type Dual = Series<Ball>;

/// All solutions in the range, and where none could be shown or excluded.
pub struct Outcome {
    pub solutions: Vec<Solution<Ball>>,
    pub unresolved: Vec<[Rational; 2]>,
}

impl Outcome {
    fn add(
        &mut self,
        zeros: Zeros,
        solution: impl Fn(Ball) -> Solution<Ball>,
        f: &impl Function,
        bits: u32,
    ) {
        let found = zeros
            .isolated
            .iter()
            .map(|zero| solution(zero.ball(f, bits)));
        self.solutions.extend(found);
        self.unresolved.extend(zeros.unresolved);
    }
}

impl Iterated {
    /// All solutions, to about so many bits.
    pub fn solve(&self, alternates: &[Alternate], bits: u32) -> Result<Outcome, NoDesign> {
        let mut outcome = Outcome {
            solutions: Vec::new(),
            unresolved: Vec::new(),
        };
        let alpha_a = self.alpha_a(bits);
        guide(&slider_crank(
            &self.crank,
            &alpha_a,
            &alpha_a,
            &Rounded(bits),
        ))?;
        match &self.sought {
            Sought::TwoInflections => self.two_inflections(bits, &mut outcome)?,
            _ => {
                for sixth in self.sixths() {
                    self.six_points(&sixth, alternates, bits, &mut outcome);
                }
            }
        }
        Ok(outcome)
    }

    /// What is sought, in every assembly.
    fn sixths(&self) -> Vec<Sixth<Rational>> {
        let every = Assembly::ALL;
        match &self.sought {
            Sought::Intersections([s, t]) => every
                .into_iter()
                .flat_map(|first| every.map(|second| (first, second)))
                .map(|(first, second)| {
                    Sixth::Intersections([(s.clone(), first), (t.clone(), second)])
                })
                .collect(),
            Sought::Tangent(s) => every.map(|side| Sixth::Tangent(s.clone(), side)).into(),
            Sought::BallBurmester(s) => every
                .map(|side| Sixth::BallBurmester(s.clone(), side))
                .into(),
            Sought::TwoInflections => Vec::new(),
        }
    }

    fn alpha_a(&self, bits: u32) -> Angle<Ball> {
        self.crank.alpha_a.rounded(&bits)
    }

    fn six_points(
        &self,
        sixth: &Sixth<Rational>,
        alternates: &[Alternate],
        bits: u32,
        outcome: &mut Outcome,
    ) {
        let source = Rounded(bits);
        let alpha_a = self.alpha_a(bits);
        let constant = |q: &Rational| Number::<Ball>::rounded(q, &bits);
        let wide = sixth.map(|s| Number::<Dual>::from(constant(s)));
        let linkage = SliderCrank {
            k: constant(&self.crank.k).into(),
            alpha_a: in_dual(&alpha_a),
            alpha_d: in_dual(&alpha_a),
        };
        let f = |degrees: &Number<Dual>| {
            let linkage = SliderCrank {
                alpha_d: angle(degrees, bits),
                ..linkage.clone()
            };
            equation(&linkage, &wide).unwrap_or_else(|_| Number::zero().inverse())
        };
        let narrow = sixth.map(constant);
        let solution = |degrees: Ball| {
            let alpha_d = input_angle(degrees, bits);
            let linkage = slider_crank(&self.crank, &alpha_a, &alpha_d, &source);
            six_points(&linkage, &narrow, alternates)
                .unwrap_or_else(|reason| Solution::none(&alpha_d, reason))
        };
        let [from, to] = &self.range;
        outcome.add(zeros(&f, 1, from, to), solution, &f, bits);
    }

    fn two_inflections(&self, bits: u32, outcome: &mut Outcome) -> Result<(), NoDesign> {
        let source = Rounded(bits);
        let k = source.number(&self.crank.k);
        let alpha_a = self.alpha_a(bits);
        for alpha_d in rays_of_d(&k, &alpha_a)? {
            let linkage = slider_crank(&self.crank, &alpha_a, &alpha_d, &source);
            let wide = SliderCrank {
                k: k.clone().into(),
                alpha_a: in_dual(&alpha_a),
                alpha_d: in_dual(&alpha_d),
            };
            let f = |degrees: &Number<Dual>| {
                let half = angle(&(degrees / 2), bits).cis();
                Symmetrical::new(&wide, &half).tangents_differ()
            };
            let [from, to] = &self.range;
            let mut zeros = zeros(&f, 1, from, to);
            // For ε = 0 it vanishes without a linkage.
            zeros
                .isolated
                .retain(|zero| !zero.ball(&f, bits).contains(&Rational::new()));
            let solution = |degrees: Ball| {
                let half = input_angle((Number(degrees) / 2).0, bits).cis();
                Solution::symmetrical(&linkage, &half, Some(2))
            };
            outcome.add(zeros, solution, &f, bits);
        }
        Ok(())
    }
}

/// The linkages with six points: the fifth position gives their cranks.
fn six_points(
    linkage: &SliderCrank<Ball>,
    sixth: &Sixth<Number<Ball>>,
    alternates: &[Alternate],
) -> Result<Solution<Ball>, NoDesign> {
    let joints = joints(linkage);
    let place = |(s, side): &(Number<Ball>, Assembly), contact: usize| {
        Ok(Place {
            displaced: Some((s.clone(), *side)),
            displacement: joints.displaced(s, *side)?.displacement,
            contact: Some(contact),
        })
    };
    let (places, contact) = match sixth {
        Sixth::Intersections([first, second]) => (vec![place(first, 0)?, place(second, 0)?], 3),
        Sixth::Tangent(s, side) => (vec![place(&(s.clone(), *side), 1)?], 3),
        Sixth::BallBurmester(s, side) => (vec![place(&(s.clone(), *side), 0)?], 4),
    };
    let fifth = linkage.apart(&places.first().ok_or(NoDesign::Undecided)?.displacement);
    let cranks = of_slider_crank(linkage, &fifth)?;
    Ok(Solution::of_cranks(&cranks, alternates, contact, &places))
}

/// An angle in degrees, as a series.
fn angle(degrees: &Number<Dual>, bits: u32) -> Angle<Dual> {
    let direction = turning::path(degrees, bits);
    Angle::from_cos_sin(direction.re().clone(), direction.im().clone())
}

fn input_angle(degrees: Ball, bits: u32) -> Angle<Ball> {
    let direction = turning::cis(&Number(degrees), bits);
    Angle::from_cos_sin(direction.re().clone(), direction.im().clone())
}

fn in_dual(angle: &Angle<Ball>) -> Angle<Dual> {
    Angle::from_cos_sin(angle.cos().into(), angle.sin().into())
}
