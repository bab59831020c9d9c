//! A linkage whose point keeps to a line: the linkage, and the deviation from the line and its second
//! derivative over the travel.

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::complex::{Z, point, z};
use super::plot::{Plot, block};
use super::straight_line::Linkage;
use super::{number, numbers};
use crate::linkage::cognates::CouplerPoint;
use crate::number::Number;
use crate::straight_line::design::Design;
use crate::straight_line::deviation::driven::Driven;

const STEPS: u32 = 1200;

/// The linkage in its design position with the whole path of D, and below it the diagrams on the longest
/// arc of the answer.
pub fn picture(answer: &Value) -> Option<String> {
    picture_with(answer, &Points::default())
}

/// Points from elsewhere to be compared with the curves.
#[derive(Clone, Debug, Default)]
pub struct Points {
    /// What they are.
    pub name: String,
    /// u and v.
    pub deviation: Vec<Point>,
    /// u and d²v/du².
    pub second: Vec<Point>,
}

/// What is drawn: a linkage, its lengths in unit lengths, and its arcs.
pub(super) struct Figure {
    pub(super) title: String,
    pub(super) driven: Driven<f64>,
    pub(super) arcs: Vec<Arc>,
}

/// The arc on which the deviation keeps within a bound, by the turn of the crank in degrees.
pub(super) struct Arc {
    pub(super) bound: f64,
    pub(super) ends: [f64; 2],
}

impl Arc {
    fn read(level: &Value) -> Option<Self> {
        Some(Arc {
            bound: number(&level["D"])?,
            ends: numbers(&level["phi"])?,
        })
    }
}

/// The same with points to compare.
pub fn picture_with(answer: &Value, points: &Points) -> Option<String> {
    let levels = answer["levels"].as_array()?.iter();
    let figure = Figure {
        title: "A point that keeps to a straight line".to_owned(),
        driven: driven(answer)?,
        arcs: levels.filter_map(Arc::read).collect(),
    };
    figure.draw(points)
}

impl Figure {
    pub(super) fn draw(&self, points: &Points) -> Option<String> {
        let mut canvas = Canvas::new(
            &self.title,
            "The four-bar O_aABO_b with the point D of its coupler in the design position, the whole path of \
             D and the line that it keeps to between the ends for each accuracy. Below, over the travel of D \
             along the line, its deviation from the line, and the second derivative of the deviation with \
             respect to the travel.",
        );
        self.draw_linkage(&mut canvas)?;
        if !points.name.is_empty() {
            canvas.remark(&format!("circles: {}", points.name));
        }
        canvas.below(block(&self.plots(points)?));
        Some(canvas.to_svg())
    }

    fn longest(&self) -> Option<&Arc> {
        let extent = |arc: &Arc| arc.ends[1] - arc.ends[0];
        let order = |a: &&Arc, b: &&Arc| extent(a).total_cmp(&extent(b));
        self.arcs.iter().max_by(order)
    }

    /// u and v on the longest arc after every so many degrees of the crank.
    pub(super) fn deviations(&self, step: f64) -> Vec<Point> {
        let [from, to] = self.longest().map_or([0.0; 2], |arc| arc.ends);
        let first = (from / step).ceil();
        let places = std::iter::successors(Some(first), |place| Some(place + 1.0));
        places
            .take_while(|place| step * place <= to)
            .filter_map(|place| row(&self.driven, step * place))
            .map(|[u, v, _]| [u, v])
            .collect()
    }

    /// Both diagrams on the longest arc.
    fn plots(&self, points: &Points) -> Option<[Plot; 2]> {
        let longest = self.longest()?;
        let [from, to] = longest.ends;
        let rows: Vec<[f64; 3]> = (0..=STEPS)
            .map(|step| from + (to - from) * f64::from(step) / f64::from(STEPS))
            .map(|degrees| row(&self.driven, degrees).unwrap_or([f64::NAN; 3]))
            .collect();
        let deviation: Vec<Point> = rows.iter().map(|[u, v, _]| [*u, *v]).collect();
        let second: Vec<Point> = rows
            .windows(3)
            .filter_map(|window| match window {
                [[u, _, before], [middle, ..], [w, _, after]] => {
                    Some([*middle, (after - before) / (w - u)])
                }
                _ => None,
            })
            .collect();
        let bound = longest.bound;
        let reaches = deviation.iter().any(|[_, v]| v.abs() > 0.9 * bound);
        let levels = if reaches {
            vec![-bound, bound]
        } else {
            Vec::new()
        };
        Some([
            Plot {
                title: "Deviation v, in unit lengths".to_owned(),
                across: "travel u, in unit lengths",
                points: deviation,
                levels,
                marks: points.deviation.clone(),
            },
            Plot {
                title: "Second derivative of v with respect to u, in 1/unit length".to_owned(),
                across: "travel u, in unit lengths",
                points: middle_half(second),
                levels: Vec::new(),
                marks: points.second.clone(),
            },
        ])
    }

    fn draw_linkage(&self, canvas: &mut Canvas) -> Option<()> {
        let at = |degrees: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            self.driven.position(&z(cos, sin))
        };
        let [o_a, o_b] = self.driven.pivots().clone();
        let start = at(0.0)?;
        let [a, b] = start.pins;
        let linkage = Linkage {
            o_a,
            a,
            b,
            o_b,
            d: start.point,
        };
        for branch in linkage.path() {
            canvas.line(branch, Stroke::MainPath);
        }
        let mut accuracies = Vec::new();
        let mut ends = Vec::new();
        for arc in &self.arcs {
            // In a dead centre rounding may lead beyond the end.
            let is_finite = |at: &Point| at.iter().all(|x| x.is_finite());
            let place = |end: f64| {
                let tried = [end, end * (1.0 - 1e-7)].map(at).into_iter().flatten();
                tried.map(|end| point(&end.point)).find(is_finite)
            };
            ends.extend(arc.ends.into_iter().filter_map(place));
            let decimals = format!("{:.12}", arc.bound);
            accuracies.push(decimals.trim_end_matches('0').to_owned());
        }
        let [.., d] = linkage.joints();
        let direction = point(self.driven.direction());
        let along = |length: f64| [d[0] + length * direction[0], d[1] + length * direction[1]];
        let travels = ends
            .iter()
            .map(|end| (end[0] - d[0]) * direction[0] + (end[1] - d[1]) * direction[1]);
        let (low, high) = travels.fold((0.0, 0.0), |(low, high): (f64, f64), u| {
            (low.min(u), high.max(u))
        });
        canvas.line([along(1.15 * low), along(1.15 * high)], Stroke::Guide);
        linkage.draw(canvas);
        for end in ends {
            canvas.joint(end, Joint::Mark, "");
        }
        canvas.scale("unit lengths");
        canvas.explain(Stroke::MainPath, "path of D");
        canvas.explain(Stroke::Guide, "the line that it keeps to");
        canvas.explain(Stroke::Crank, "cranks");
        canvas.remark(&format!(
            "dots: where D leaves the line by {} unit lengths, or stops before",
            accuracies.join(", ")
        ));
        Some(())
    }
}

/// A direction that is given by its angle.
fn turn(answer: &Value, name: &str) -> Option<Z> {
    let (sin, cos) = number(answer[name].get("degrees")?)?.to_radians().sin_cos();
    Some(z(cos, sin))
}

/// Where the travel turns back the derivative is infinite: what is far beyond the rest is left out.
fn middle_half(mut points: Vec<Point>) -> Vec<Point> {
    let mut sizes: Vec<f64> = points.iter().map(|[_, y]| y.abs()).collect();
    sizes.retain(|size| size.is_finite());
    sizes.sort_by(f64::total_cmp);
    let Some(typical) = sizes.get(sizes.len() * 3 / 4) else {
        return points;
    };
    for point in &mut points {
        if point[1].abs() > 4.0 * typical {
            point[1] = f64::NAN;
        }
    }
    points
}

/// u, v and dv/du.
fn row(driven: &Driven<f64>, degrees: f64) -> Option<[f64; 3]> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let position = driven.position(&z(cos, sin))?;
    let [u, v] = driven.coordinates(&position).map(|x| x.0);
    let rates = driven.rates(&position);
    Some([u, v, (rates.deviation / rates.travel).0])
}

/// The linkage from its lengths and angles.
fn driven(answer: &Value) -> Option<Driven<f64>> {
    let length = |name: &str| number(&answer[name]).map(Number);
    let o_b = Z::from(length("Q")?);
    let a = turn(answer, "phi0")?.scaled(&length("R")?);
    let b = &o_b + turn(answer, "psi0")?.scaled(&length("T")?);
    let arm = turn(answer, "chi0")? * turn(answer, "epsilon")?;
    let point = &a + arm.scaled(&length("M")?);
    Driven::new(&Design {
        linkage: CouplerPoint {
            pivots: [z(0.0, 0.0), o_b],
            pins: [a, b],
            point,
        },
        direction: turn(answer, "line")?,
    })
}
