//! The bars and joints of a mechanism, in one position or in all of them in turn.

use super::canvas::{Canvas, Joint, Point, Stroke, spread};

/// Positions of a whole way, at most.
const FRAMES: usize = 160;

/// What a mechanism is made of.
pub struct Skeleton {
    /// By the places of their ends among the joints.
    pub bars: &'static [(usize, usize, Stroke)],
    /// How each looks, and its name.
    pub joints: &'static [(Joint, &'static str)],
}

/// The joints in one position.
pub type Posture = Vec<Point>;

impl Skeleton {
    /// Draws one position, or the first of several that it goes through in turn.
    pub fn draw(&self, canvas: &mut Canvas, way: &[Posture]) {
        let of = |index: usize| -> Vec<Point> {
            let places = way.iter().filter_map(|posture| posture.get(index));
            places.copied().collect()
        };
        let is_fixed = |index: &usize| {
            let joint = self.joints.get(*index);
            way.len() < 2 || joint.is_some_and(|(joint, _)| *joint == Joint::Fixed)
        };
        for (from, to, stroke) in self.bars {
            let ends: Vec<[Point; 2]> = of(*from)
                .into_iter()
                .zip(of(*to))
                .map(|(from, to)| [from, to])
                .collect();
            if is_fixed(from) && is_fixed(to) {
                canvas.line(ends.into_iter().take(1).flatten(), *stroke);
            } else {
                canvas.moving_line(ends, *stroke);
            }
        }
        for (index, (joint, name)) in self.joints.iter().enumerate() {
            let places = of(index);
            match places.first() {
                Some(at) if is_fixed(&index) => canvas.joint(*at, *joint, name),
                _ => canvas.moving_joint(places, *joint, name),
            }
        }
    }
}

/// The position of a sweep that is easiest to read.
pub fn easiest(sweep: &[Vec<Option<Posture>>]) -> Option<&Posture> {
    let order = |x: &&Posture, y: &&Posture| spread(x).total_cmp(&spread(y));
    sweep.iter().flatten().flatten().max_by(order)
}

/// All positions in turn, from the easiest to read on and back to it. A sweep of one row goes round; of
/// two rows, the assemblies of a mechanism that rocks, the second leads back.
pub fn round_trip(sweep: &[Vec<Option<Posture>>]) -> Vec<Posture> {
    let mut way: Vec<Posture> = match sweep {
        [round] => round.iter().skip(1).flatten().cloned().collect(),
        [there, back, ..] => {
            let run = longest_run(there);
            let way = |row: &[Option<Posture>]| -> Vec<Posture> {
                let places = run.iter().filter_map(|place| row.get(*place)?.clone());
                places.collect()
            };
            let mut whole = way(there);
            whole.extend(way(back).into_iter().rev());
            whole
        }
        [] => Vec::new(),
    };
    let step = way.len().div_ceil(FRAMES).max(1);
    way = way.into_iter().step_by(step).collect();
    let order = |x: &(usize, &Posture), y: &(usize, &Posture)| spread(x.1).total_cmp(&spread(y.1));
    let first = way.iter().enumerate().max_by(order).map(|(place, _)| place);
    way.rotate_left(first.unwrap_or_default());
    way.extend(way.first().cloned());
    way
}

/// The places of the longest run of positions in a row of which the end leads on to the beginning.
fn longest_run(row: &[Option<Posture>]) -> Vec<usize> {
    let Some(gap) = row.iter().position(Option::is_none) else {
        return (0..row.len()).collect();
    };
    let places: Vec<_> = row.iter().enumerate().collect();
    let round = places.iter().cycle().skip(gap).take(row.len());
    let mut best: Vec<usize> = Vec::new();
    let mut run: Vec<usize> = Vec::new();
    for (place, posture) in round {
        if posture.is_some() {
            run.push(*place);
        } else {
            run.clear();
        }
        if run.len() > best.len() {
            best.clone_from(&run);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rocking_mechanism_goes_there_and_back() {
        let row = |sign: f64| -> Vec<Option<Posture>> {
            let at = |x: f64| Some(vec![[0.0, 0.0], [x, sign]]);
            vec![at(3.0), None, at(1.0), at(2.0)]
        };
        let way = round_trip(&[row(1.0), row(-1.0)]);
        assert_eq!(way.len(), 7);
        assert_eq!(way.first(), way.last());
        // The farthest position is the easiest to read; it is passed in both assemblies.
        assert_eq!(way[0][1][0], 3.0);
        assert_eq!(way[1][1][0], 2.0);
    }
}
