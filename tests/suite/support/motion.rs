//! The motion of a linkage followed in small steps, in floats: nothing is decided but by looking.
#![expect(
    clippy::indexing_slicing,
    reason = "a place that is not there is a failure of the test"
)]

pub type Vector = [f64; 2];

/// How a pair guides the coupler.
#[derive(Clone, Debug)]
pub enum Dyad {
    Link { center: Vector, length: f64 },
    Slide { origin: Vector, along: Vector },
    Block { center: Vector },
}

/// Two dyads, and what the coupler keeps: a length, an offset or an angle.
#[derive(Clone, Debug)]
pub struct Chain {
    pub dyads: [Dyad; 2],
    pub coupler: f64,
    pub turn: Vector,
}

/// What one drive does.
#[derive(Debug)]
pub struct Verdict {
    pub crank: bool,
    pub branch: Vec<bool>,
    /// Only where all positions are on one branch.
    pub order: Option<Vec<usize>>,
    /// The greatest and the least cosine of the transmission angle, where there is one.
    pub cosines: Option<[f64; 2]>,
}

#[derive(Debug)]
pub struct Followed {
    pub circuit: Vec<bool>,
    pub drives: [Verdict; 2],
}

const STEP: f64 = 0.01;
/// A position this near to a dead centre or to another circuit is not judged.
const NEAR: usize = 12;
const MOST_STEPS: usize = 60_000;
/// A slider this far away does not come back.
const FAR: f64 = 150.0;

fn dot(u: Vector, v: Vector) -> f64 {
    u[0] * v[0] + u[1] * v[1]
}

fn minus(u: Vector, v: Vector) -> Vector {
    [u[0] - v[0], u[1] - v[1]]
}

fn size(u: Vector) -> f64 {
    u[0].hypot(u[1])
}

impl Dyad {
    fn turns(&self) -> bool {
        !matches!(self, Dyad::Slide { .. })
    }

    /// The joint, or the normal of the line in a block, and whether it is a joint.
    fn at(&self, t: f64) -> (Vector, bool) {
        match self {
            Dyad::Link { center, length } => (
                [center[0] + length * t.cos(), center[1] + length * t.sin()],
                true,
            ),
            Dyad::Slide { origin, along } => {
                ([origin[0] + t * along[0], origin[1] + t * along[1]], true)
            }
            Dyad::Block { .. } => ([t.cos(), t.sin()], false),
        }
    }

    fn center(&self) -> Vector {
        match self {
            Dyad::Link { center, .. } | Dyad::Block { center } => *center,
            Dyad::Slide { origin, .. } => *origin,
        }
    }
}

/// The two parameters on their way along the closure curve.
struct Trace {
    points: Vec<Vector>,
    closed: bool,
}

impl Chain {
    fn closure(&self, p: Vector) -> f64 {
        let [first, second] = &self.dyads;
        match (first.at(p[0]), second.at(p[1])) {
            ((a, true), (b, true)) => dot(minus(a, b), minus(a, b)) - self.coupler * self.coupler,
            ((a, true), (normal, false)) => dot(minus(a, second.center()), normal) - self.coupler,
            ((normal, false), (b, true)) => dot(minus(b, first.center()), normal) - self.coupler,
            ((n, false), (m, false)) => {
                // m = n · turn
                let turned = [
                    n[0] * self.turn[0] - n[1] * self.turn[1],
                    n[0] * self.turn[1] + n[1] * self.turn[0],
                ];
                turned[0] * m[1] - turned[1] * m[0]
            }
        }
    }

    fn gradient(&self, p: Vector) -> Vector {
        let h = 1e-6;
        [
            (self.closure([p[0] + h, p[1]]) - self.closure([p[0] - h, p[1]])) / (2.0 * h),
            (self.closure([p[0], p[1] + h]) - self.closure([p[0], p[1] - h])) / (2.0 * h),
        ]
    }

    fn corrected(&self, mut p: Vector) -> Option<Vector> {
        for _ in 0..8 {
            let (value, g) = (self.closure(p), self.gradient(p));
            let square = dot(g, g);
            if square < 1e-12 {
                return None;
            }
            p = [p[0] - value * g[0] / square, p[1] - value * g[1] / square];
            if value.abs() < 1e-12 * (1.0 + square) {
                return Some(p);
            }
        }
        None
    }

    /// How far two settings are apart, whole turns left out.
    fn apart(&self, p: Vector, q: Vector) -> f64 {
        let one = |i: usize| {
            let d = p[i] - q[i];
            if self.dyads[i].turns() {
                let turn = std::f64::consts::TAU;
                d - turn * (d / turn).round()
            } else {
                d
            }
        };
        one(0).hypot(one(1))
    }

    fn trace(&self, start: Vector) -> Option<Trace> {
        let start = self.corrected(start)?;
        let ahead = self.trace_one_way(start, 1.0)?;
        if ahead.closed {
            return Some(ahead);
        }
        let mut points = self.trace_one_way(start, -1.0)?.points;
        points.reverse();
        points.pop();
        points.extend(ahead.points);
        Some(Trace {
            points,
            closed: false,
        })
    }

    /// Whether a slider may go away for ever: where a block holds it.
    fn is_open(&self) -> bool {
        let [first, second] = &self.dyads;
        let slides = |dyad: &Dyad| matches!(dyad, Dyad::Slide { .. });
        let blocks = |dyad: &Dyad| matches!(dyad, Dyad::Block { .. });
        slides(first) && blocks(second) || blocks(first) && slides(second)
    }

    fn trace_one_way(&self, start: Vector, sense: f64) -> Option<Trace> {
        let mut points = vec![start];
        let mut p = start;
        let mut last: Option<Vector> = None;
        for step in 0..MOST_STEPS {
            let g = self.gradient(p);
            let length = size(g);
            if length < 1e-3 {
                return None;
            }
            let mut tangent = [-sense * g[1] / length, sense * g[0] / length];
            // Two pieces that come this near to each other could be confused.
            if last.is_some_and(|last| dot(tangent, last) < 0.9) {
                return None;
            }
            last = Some(tangent);
            // Far away steps grow with the distance.
            let scale = (0..2)
                .filter(|i| !self.dyads[*i].turns())
                .map(|i| p[i].abs() / 10.0)
                .fold(1.0, f64::max);
            tangent = tangent.map(|t| t * STEP * scale);
            p = self.corrected([p[0] + tangent[0], p[1] + tangent[1]])?;
            points.push(p);
            if step > 10 && self.apart(p, start) < 0.75 * STEP * scale {
                return Some(Trace {
                    points,
                    closed: true,
                });
            }
            if (0..2).any(|i| !self.dyads[i].turns() && p[i].abs() > FAR) {
                if !self.is_open() {
                    return None;
                }
                return Some(Trace {
                    points,
                    closed: false,
                });
            }
        }
        None
    }

    /// cos of the transmission angle, driven at one of the dyads.
    fn cosine(&self, drive: usize, p: Vector) -> Option<f64> {
        let (driver, driven) = (&self.dyads[drive], &self.dyads[1 - drive]);
        let (a, b) = (driver.at(p[drive]), driven.at(p[1 - drive]));
        if !b.1 {
            let to_a = minus(a.0, driven.center());
            return a.1.then(|| dot(b.0, to_a).abs() / size(to_a));
        }
        let push = if a.1 { minus(a.0, b.0) } else { a.0 };
        let pull = match driven {
            Dyad::Slide { along, .. } => [-along[1], along[0]],
            _ => minus(driven.center(), b.0),
        };
        Some(dot(push, pull) / (size(push) * size(pull)))
    }

    /// Follows the circuit of the first position; `None` where a position is too near to a boundary.
    pub fn follow(&self, places: &[Vector]) -> Option<Followed> {
        let away =
            |place: &Vector| (0..2).any(|i| !self.dyads[i].turns() && place[i].abs() > FAR / 2.0);
        if places.iter().any(away) {
            return None;
        }
        let trace = self.trace(*places.first()?)?;
        let mut indices = Vec::new();
        for place in places {
            let near = trace
                .points
                .iter()
                .enumerate()
                .map(|(index, p)| (self.apart(*p, *place), index))
                .min_by(|a, b| a.0.total_cmp(&b.0))?;
            let scale = (0..2)
                .filter(|i| !self.dyads[*i].turns())
                .map(|i| place[i].abs() / 10.0)
                .fold(1.0, f64::max);
            indices.push(if near.0 < 2.0 * STEP * scale {
                Some(near.1)
            } else if near.0 > 8.0 * STEP * scale {
                None
            } else {
                return None;
            });
        }
        let drives = [
            self.drive(0, &trace, places, &indices)?,
            self.drive(1, &trace, places, &indices)?,
        ];
        Some(Followed {
            circuit: indices.iter().map(Option::is_some).collect(),
            drives,
        })
    }

    fn drive(
        &self,
        drive: usize,
        trace: &Trace,
        places: &[Vector],
        indices: &[Option<usize>],
    ) -> Option<Verdict> {
        let points = &trace.points;
        let u = |index: usize| points[index][drive];
        let steps = points.len() - 1;
        let signs: Vec<bool> = (0..steps).map(|i| u(i + 1) > u(i)).collect();
        let dead: Vec<usize> = (0..steps)
            .filter(|i| {
                let next = if i + 1 < steps {
                    i + 1
                } else if trace.closed {
                    0
                } else {
                    *i
                };
                signs[*i] != signs[next]
            })
            .map(|i| i + 1)
            .collect();
        let crank = trace.closed && dead.is_empty() && self.dyads[drive].turns();
        // Too near to a dead centre, in steps along the curve.
        let distance = |i: usize, j: usize| {
            let direct = i.abs_diff(j);
            if trace.closed {
                direct.min(steps - direct)
            } else {
                direct
            }
        };
        for index in indices.iter().flatten() {
            if dead.iter().any(|dead| distance(*index, *dead) < NEAR) {
                return None;
            }
        }
        // The branch of a point of the curve: how many dead centres come before it, around the start.
        let branch_of = |index: usize| {
            let before = dead.iter().filter(|dead| **dead <= index).count();
            if trace.closed && !dead.is_empty() {
                before % dead.len()
            } else {
                before
            }
        };
        let first = indices[0]?;
        let branch: Vec<bool> = indices
            .iter()
            .map(|index| index.is_some_and(|index| branch_of(index) == branch_of(first)))
            .collect();
        if !branch.iter().all(|reached| *reached) {
            return Some(Verdict {
                crank,
                branch,
                order: None,
                cosines: None,
            });
        }
        // Points of the curve on this branch, from the first position in both directions.
        let mut order: Vec<(f64, usize)> = Vec::new();
        for (place, index) in indices.iter().enumerate() {
            let turn = std::f64::consts::TAU;
            let way = if crank {
                (places[place][drive] - places[0][drive]).rem_euclid(turn)
            } else {
                self.way(drive, trace, &dead, first, (*index)?)
            };
            order.push((way, place));
        }
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        if order.windows(2).any(|pair| pair[1].0 - pair[0].0 < 1e-3) {
            return None;
        }
        let ways: Vec<f64> = order.iter().map(|(way, _)| *way).collect();
        let (least, greatest) = (ways[0], *ways.last()?);
        let mut cosines: Vec<f64> = Vec::new();
        for (index, point) in points.iter().enumerate() {
            let within = crank
                || branch_of(index) == branch_of(first) && {
                    let way = self.way(drive, trace, &dead, first, index);
                    least < way && way < greatest
                };
            if within {
                cosines.extend(self.cosine(drive, *point));
            }
        }
        if !crank {
            cosines.extend(places.iter().filter_map(|p| self.cosine(drive, *p)));
        }
        let cosines = (!cosines.is_empty()).then(|| {
            [
                cosines.iter().copied().fold(f64::MIN, f64::max),
                cosines.iter().copied().fold(f64::MAX, f64::min),
            ]
        });
        let order = order.into_iter().map(|(_, place)| place).collect();
        Some(Verdict {
            crank,
            branch,
            order: Some(order),
            cosines,
        })
    }

    /// How far the driving link goes on a branch from one point of the curve to another.
    fn way(&self, drive: usize, trace: &Trace, dead: &[usize], from: usize, to: usize) -> f64 {
        let u = |index: usize| trace.points[index][drive];
        let direct = u(to) - u(from);
        let (low, high) = (from.min(to), from.max(to));
        let passes = dead.iter().any(|dead| low < *dead && *dead <= high);
        if !passes || !trace.closed {
            return direct;
        }
        // The other way round, through the start of the curve.
        let last = trace.points.len() - 1;
        let around = u(last) - u(0);
        if to < from {
            direct + around
        } else {
            direct - around
        }
    }
}
