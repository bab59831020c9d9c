//! Reading positions of the moving plane, and the kinds that hold them.

use rug::Rational;
use serde_json::{Map, Value, json};

use super::input::{Angle, Fields};
use super::numeral::Shown;
use super::sharpen::{Attempt, sharpen};
use super::{Arithmetic, ProblemError, Request};
use crate::finite::positions::Positions;
use crate::number::exact::rational_sqrt;
use crate::number::{Ball, Elementary, Exact, Number, Real, Surd, array};
use crate::plane::Point;
use crate::plane::displacement::{Displacement, HalfTurn};

type Coordinates = [Rational; 2];

/// Positions as they were given.
pub enum Given {
    /// By the place of the moving origin and the angle.
    Poses(Vec<(Coordinates, Angle)>),
    /// By two points of the body; with fitted angles where their distance changes.
    Points(Vec<[Coordinates; 2]>, bool),
}

/// What is asked about positions.
pub trait Task {
    /// The answer in one kind.
    fn answer<K: Shown>(
        &self,
        positions: &Positions<K>,
        precision: &K::Precision,
        attempt: &mut Attempt,
    ) -> Map<String, Value>;
}

impl Given {
    /// Reads the field `positions`, of which there must be so many.
    pub fn read(fields: &Fields<'_>, least: usize, most: usize) -> Result<Self, ProblemError> {
        let list = fields.list("positions")?;
        if list.len() < least || list.len() > most {
            let expected = if least == most {
                format!("{least}")
            } else {
                format!("{least} to {most}")
            };
            return Err(ProblemError::new(
                "positions",
                format!("{expected} positions were expected, not {}", list.len()),
            ));
        }
        let by_points = list
            .iter()
            .filter(|one| one.get("points").is_some())
            .count();
        if by_points == 0 {
            return list
                .iter()
                .enumerate()
                .map(pose)
                .collect::<Result<_, _>>()
                .map(Given::Poses);
        }
        if by_points < list.len() {
            return Err(ProblemError::new(
                "positions",
                "either all positions by two points or all by x, y and angle: only then it is known \
                 where the points are in the moving plane",
            ));
        }
        let mut fit = false;
        let mut pairs = Vec::new();
        for (place, position) in list.iter().enumerate() {
            let (pair, fitted) = two_points(place, position)?;
            pairs.push(pair);
            fit |= fitted;
        }
        check_distances(&pairs, fit)?;
        Ok(Given::Points(pairs, fit))
    }

    /// With exact numbers, where cosines and sines are rational.
    pub fn rational(&self) -> Option<Positions<Exact>> {
        let exact = self.exact()?;
        let number = |x: &Number<Surd>| Some(Number::from(x.0.rational()?.clone()));
        let point = |z: &Point<Surd>| Some(Number::complex(number(z.re())?, number(z.im())?));
        let displacements: Option<Vec<_>> = exact
            .displacements()
            .iter()
            .map(|d| {
                Some(Displacement {
                    rotation: point(&d.rotation)?,
                    translation: point(&d.translation)?,
                })
            })
            .collect();
        Some(Positions::new(displacements?))
    }

    /// Where all angles are the same, in whatever unit, the translations, seen from a moving plane that
    /// is turned by that angle: what does not speak of points of the moving plane is the same.
    pub fn translations(&self) -> Option<Positions<Exact>> {
        let Given::Poses(poses) = self else {
            return None;
        };
        let (_, first) = poses.first()?;
        let displacements = poses.iter().map(|(place, angle)| {
            let turn = first.turn_to(angle)?;
            turn.is_zero().then(|| Displacement {
                rotation: Number::one(),
                translation: point(place),
            })
        });
        Some(Positions::new(displacements.collect::<Option<_>>()?))
    }

    /// Whether two positions are known to be turned alike, also where cosines and sines are enclosures.
    pub fn turn_alike(&self, i: usize, j: usize) -> bool {
        let Given::Poses(poses) = self else {
            return false;
        };
        let turn = poses
            .get(i)
            .zip(poses.get(j))
            .and_then(|((_, from), (_, to))| from.turn_to(to));
        turn.is_some_and(|turn| turn.is_zero())
    }

    /// With sums of square roots, where these hold all cosines and sines.
    pub fn exact(&self) -> Option<Positions<Surd>> {
        let displacements: Option<Vec<_>> = match self {
            Given::Poses(poses) => poses
                .iter()
                .map(|(place, angle)| {
                    Some(Displacement {
                        rotation: angle.exact()?.cis(),
                        translation: point(place),
                    })
                })
                .collect(),
            Given::Points(pairs, _) => of_points(pairs, &()),
        };
        let displacements = displacements?;
        let complete = displacements.iter().all(|d| d.rotation.has_value());
        complete.then(|| Positions::new(displacements))
    }

    /// In any arithmetic with elementary functions.
    pub fn rounded<K: Elementary>(&self, precision: &K::Precision) -> Positions<K> {
        match self {
            Given::Poses(poses) => {
                let displacements = poses.iter().map(|(place, angle)| Displacement {
                    rotation: turn(angle, precision),
                    translation: point(place),
                });
                Positions::with_half_turns(displacements.collect(), |i, j| {
                    half_turn(poses, i, j, precision)
                })
            }
            Given::Points(pairs, _) => {
                Positions::new(of_points(pairs, precision).unwrap_or_default())
            }
        }
    }

    /// Does a task in the kind that is best for these positions: exact numbers where these hold all,
    /// else balls; or floats.
    pub fn solve(&self, task: &impl Task, request: &Request) -> Map<String, Value> {
        let digits = request.digits;
        let mut answer = match (request.arithmetic, self.rational(), self.exact()) {
            (Arithmetic::Float, ..) => task.answer(
                &self.rounded::<f64>(&()),
                &(),
                &mut Attempt::new(digits, 53),
            ),
            (_, Some(positions), _) => {
                sharpen(digits, |attempt| task.answer(&positions, &(), attempt))
            }
            (_, None, Some(positions)) => {
                sharpen(digits, |attempt| task.answer(&positions, &(), attempt))
            }
            _ => sharpen(digits, |attempt| {
                let bits = attempt.bits;
                task.answer(&self.rounded::<Ball>(&bits), &bits, attempt)
            }),
        };
        if let Some(angles) = self.fitted(request) {
            answer.insert("fitted_angles".into(), angles);
        }
        answer
    }

    /// The angles that were fitted, where the positions asked for that.
    pub fn fitted(&self, request: &Request) -> Option<Value> {
        matches!(self, Given::Points(_, true)).then(|| self.fitted_angles(request))
    }

    /// The angles of the positions, the first of them zero.
    fn fitted_angles(&self, request: &Request) -> Value {
        let angles = |attempt: &mut Attempt| {
            let mut fields = Map::new();
            let positions = self.rounded::<Ball>(&attempt.bits);
            let list = positions.displacements().iter();
            let list: Vec<Value> = list.map(|d| attempt.turn("angle", &d.rotation)).collect();
            fields.insert("angles".into(), json!(list));
            fields
        };
        let floats = || {
            let positions = self.rounded::<f64>(&());
            let mut attempt = Attempt::new(request.digits, 53);
            let list = positions.displacements().iter();
            list.map(|d| attempt.turn("angle", &d.rotation)).collect()
        };
        match request.arithmetic {
            Arithmetic::Float => floats(),
            Arithmetic::Certified => {
                let mut fields = sharpen(request.digits, angles);
                fields.remove("angles").unwrap_or_default()
            }
        }
    }
}

fn pose((place, position): (usize, &Value)) -> Result<(Coordinates, Angle), ProblemError> {
    let fields = Fields::at(position, &format!("positions[{place}]"))?;
    fields.only(&["x", "y", "angle"])?;
    Ok((
        [fields.number("x")?, fields.number("y")?],
        fields.angle("angle")?,
    ))
}

fn two_points(place: usize, position: &Value) -> Result<([Coordinates; 2], bool), ProblemError> {
    let fields = Fields::at(position, &format!("positions[{place}]"))?;
    fields.only(&["points", "fit"])?;
    let points = fields.points("points")?;
    let pair: [Coordinates; 2] = points.try_into().map_err(|list: Vec<_>| {
        fields.error(
            "points",
            format!("two points were expected, not {}", list.len()),
        )
    })?;
    Ok((pair, fields.flag("fit")?))
}

fn squared_distance([p, q]: &[Coordinates; 2]) -> Rational {
    let [x, y] = array::pairs(p, q).map(|(p, q)| Rational::from(q - p).square());
    x + y
}

fn check_distances(pairs: &[[Coordinates; 2]], fit: bool) -> Result<(), ProblemError> {
    let distances: Vec<Rational> = pairs.iter().map(squared_distance).collect();
    for (place, distance) in distances.iter().enumerate() {
        let at = |message: &str| {
            Err(ProblemError::new(
                &format!("positions[{place}].points"),
                message,
            ))
        };
        if distance.is_zero() {
            return at("the two points coincide; a position needs two different points");
        }
        if !fit && Some(distance) != distances.first() {
            return at(
                "the two points are not as far apart as in the first position; with \"fit\": true \
                 the angle is fitted",
            );
        }
    }
    Ok(())
}

/// Exact also among enclosures, until it meets one.
pub fn point<K: Real>([x, y]: &Coordinates) -> Point<K> {
    Number::complex(Number::from(x.clone()), Number::from(y.clone()))
}

/// e^{iθ}, exact also among enclosures where cosine and sine are rational.
fn turn<K: Elementary>(angle: &Angle, precision: &K::Precision) -> Point<K> {
    let rational = angle.exact().and_then(|angle| {
        let turn = angle.cis();
        Some([
            turn.re().0.rational()?.clone(),
            turn.im().0.rational()?.clone(),
        ])
    });
    match rational {
        Some(exact) => point(&exact),
        None => angle.rounded::<K>(precision).cis(),
    }
}

/// The moving plane is the fixed one in the first position. The angle is that between the lines through
/// the two points, and the middle of the two is where it should be.
fn of_points<K: Real>(
    pairs: &[[Coordinates; 2]],
    precision: &K::Precision,
) -> Option<Vec<Displacement<K>>> {
    let ends = |[p, q]: &[Coordinates; 2]| [point::<K>(p), point::<K>(q)];
    let [p, q] = ends(pairs.first()?);
    let length = squared_distance(pairs.first()?);
    let displacements = pairs.iter().map(|pair| {
        let [p1, q1] = ends(pair);
        let along = (&q1 - &p1) * (&q - &p).conj();
        // Of equal distances the product of the lengths is rational.
        let size = if squared_distance(pair) == length {
            Number::from(length.clone())
        } else {
            let square = squared_distance(pair) * &length;
            match rational_sqrt(square.clone()) {
                Some(root) => Number::from(root),
                None => Number::rounded(&square, precision).sqrt(),
            }
        };
        let rotation = along.scaled(&size.inverse());
        let half = Number::ratio(1, 2);
        let translation = (p1 + q1 - &rotation * (&p + &q)).scaled(&half);
        Displacement {
            rotation,
            translation,
        }
    });
    Some(displacements.collect())
}

/// Half of the turn between two positions, from the difference of the angles where that is known
/// better than their cosines and sines.
fn half_turn<K: Elementary>(
    poses: &[(Coordinates, Angle)],
    i: usize,
    j: usize,
    precision: &K::Precision,
) -> HalfTurn<K> {
    let angle = |place: usize| poses.get(place).map(|(_, angle)| angle);
    let (Some(from), Some(to)) = (angle(i), angle(j)) else {
        return HalfTurn::of(&Number::one());
    };
    HalfTurn::of_rounded(&match from.turn_to(to) {
        Some(difference) => turn(&difference, precision),
        None => turn::<K>(to, precision) * turn::<K>(from, precision).conj(),
    })
}
