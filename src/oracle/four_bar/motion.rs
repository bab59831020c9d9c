//! How the linkage moves: decided in sums of square roots.

use serde_json::{Map, Value, json};

use crate::linkage::coupler_curve::CouplerCurve;
use crate::linkage::four_bar::{FourBar, Position};
use crate::linkage::passage::Drive;
use crate::linkage::whole_motion::{Alignment, DeadCentre, Limits};
use crate::number::{Ball, Kind, Number, Surd};
use crate::oracle::geometry::multiple_of_15_degrees;
use crate::oracle::numeral::{Numeral, Shown};
use crate::oracle::output;
use crate::oracle::sharpen::Attempt;
use crate::plane::Point;

/// Where the base lies, and where D is beside A and B.
pub struct Frame<K> {
    origin: Point<K>,
    /// The direction of the base, of length 1.
    base: Point<K>,
    /// AD : AB.
    shape: Point<K>,
}

impl<K: Kind> Frame<K> {
    /// Of a linkage with a base of this length.
    pub fn of(curve: &CouplerCurve<K>, length: &Number<K>) -> Self {
        let [a, b] = &curve.pivots;
        Frame {
            origin: a.clone(),
            base: (b - a).scaled(&length.inverse()),
            shape: curve.shape(),
        }
    }

    /// A, B and D in the plane.
    fn joints(&self, position: &Position<K>) -> [Point<K>; 3] {
        let Position { a, b } = position;
        let d = a + &self.shape * (b - a);
        [a.clone(), b.clone(), d].map(|z| &self.origin + &self.base * z)
    }
}

/// Which of the cranks turn fully.
pub fn crank_word(bars: &FourBar<Surd>) -> Option<&'static str> {
    let [first, second] = Drive::ALL.map(|drive| bars.turns_fully(drive));
    Some(match (first?, second?) {
        (true, true) => "both",
        (true, false) => "R",
        (false, true) => "T",
        (false, false) => "none",
    })
}

impl Attempt {
    /// Type, circuits, change points, and what each of the cranks does.
    pub fn motion(
        &mut self,
        bars: &FourBar<Surd>,
        exactly: Option<&Frame<Surd>>,
        in_balls: Option<&Frame<Ball>>,
    ) -> Map<String, Value> {
        let mut answer = self.words(bars);
        let circuits = bars.circuits().map(Value::from);
        answer.insert("circuits".into(), self.decided("circuits", circuits));
        let flat = bars.change_points().map(|positions| {
            let written = positions.iter().map(|position| match (exactly, in_balls) {
                (Some(frame), _) => self.joints_of("change_points", frame, position),
                (None, Some(frame)) => {
                    let position = rounded(position, self.bits);
                    self.joints_of("change_points", frame, &position)
                }
                (None, None) => Map::new(),
            });
            written.map(Value::Object).collect()
        });
        answer.insert("change_points".into(), self.decided("change_points", flat));
        let [first, second] = Drive::ALL.map(|drive| {
            let dead_centres = bars.dead_centres(drive).map(|list| {
                let list = list.iter().flat_map(|dead| {
                    [1, -1].map(|side| self.dead_centre(bars, drive, dead, side, exactly, in_balls))
                });
                list.collect()
            });
            json!({
                "turns_fully": self.decided("cranks", bars.turns_fully(drive).map(Value::from)),
                "limits": self.limits(bars.limits(drive).as_ref()),
                "dead_centres": self.decided("dead_centres", dead_centres),
                "transmission": self.transmission(bars.transmission(drive)),
            })
        });
        answer.insert("cranks".into(), json!({"R": first, "T": second}));
        answer
    }

    fn joints_of<K: Shown>(
        &mut self,
        name: &str,
        frame: &Frame<K>,
        position: &Position<K>,
    ) -> Map<String, Value> {
        let joints = frame.joints(position);
        let written = ["A", "B", "D"].into_iter().zip(&joints);
        written
            .map(|(joint, at)| (joint.to_owned(), self.finite_point(name, at)))
            .collect()
    }

    /// One of the two positions of a dead centre; the mirrored one for the side −1.
    fn dead_centre(
        &mut self,
        bars: &FourBar<Surd>,
        drive: Drive,
        dead: &DeadCentre<Surd>,
        side: i64,
        exactly: Option<&Frame<Surd>>,
        in_balls: Option<&Frame<Ball>>,
    ) -> Value {
        let DeadCentre { alignment, cosine } = dead;
        let alignment = *alignment;
        let direction = cosine.0.rational().map(|_| {
            let sine = (1 - cosine.square()).sqrt();
            Number::complex(cosine.clone(), side * sine)
        });
        let mut fields = match (exactly, direction, in_balls) {
            (Some(frame), Some(direction), _) => {
                let position = bars.aligned(drive, alignment, &direction);
                self.joints_of("dead_centres", frame, &position)
            }
            (_, _, Some(frame)) => {
                let bits = self.bits;
                let lengths = rounded_bars(bars, bits);
                let cosine = enclosed(cosine, bits);
                let sine = (1 - cosine.square()).sqrt();
                let direction = Number::complex(cosine, side * sine);
                let position = lengths.aligned(drive, alignment, &direction);
                self.joints_of("dead_centres", frame, &position)
            }
            _ => Map::new(),
        };
        let angle = self.angle_with_cosine("dead_centres", cosine);
        fields.insert(
            "angle".into(),
            self.degrees("dead_centres", &angle, 0, side),
        );
        let name = match alignment {
            Alignment::Stretched => "stretched",
            Alignment::Folded => "folded",
        };
        fields.insert("coupler_and_driven".into(), json!(name));
        Value::Object(fields)
    }

    /// The ranges of the angle of a crank, none for one that turns fully.
    fn limits(&mut self, limits: Option<&Limits<Surd>>) -> Value {
        let Some(Limits { least, greatest }) = limits else {
            return self.decided("limits", None);
        };
        let angles = [least, greatest].map(|cosine| {
            let cosine = cosine.as_ref()?;
            Some(self.angle_with_cosine("limits", cosine))
        });
        let mut range = |[from, to]: [(&Numeral, i64, i64); 2]| {
            let [from, to] =
                [from, to].map(|(angle, start, side)| self.degrees("limits", angle, start, side));
            json!({"from": from, "to": to})
        };
        match angles {
            [None, None] => json!([]),
            [None, Some(greatest)] => json!([range([(&greatest, 0, -1), (&greatest, 0, 1)])]),
            [Some(least), None] => json!([range([(&least, 0, 1), (&least, 360, -1)])]),
            [Some(least), Some(greatest)] => json!([
                range([(&greatest, 0, -1), (&least, 0, -1)]),
                range([(&least, 0, 1), (&greatest, 0, 1)]),
            ]),
        }
    }

    fn transmission(&mut self, cosines: Option<[Number<Surd>; 2]>) -> Value {
        let Some([greatest, least]) = cosines else {
            return self.decided("transmission", None);
        };
        let [least, greatest] = [greatest, least].map(|cosine| {
            let angle = self.angle_with_cosine("transmission", &cosine);
            self.degrees("transmission", &angle, 0, 1)
        });
        json!({"least": least, "greatest": greatest})
    }

    /// The degrees of an angle up to 180°, exactly for multiples of 15°.
    fn angle_with_cosine(&mut self, name: &str, cosine: &Number<Surd>) -> Numeral {
        let exact = multiple_of_15_degrees(0..=12, |angle| angle.cos().equals(cosine));
        if let Some(degrees) = exact {
            return Numeral::Exact(degrees.into());
        }
        let angle = enclosed(cosine, self.bits).acos();
        if !angle.has_value() {
            self.decided(name, None);
        }
        Numeral::Enclosed(angle * 180 / Number::pi(&self.bits))
    }

    /// start ± an angle.
    fn degrees(&mut self, name: &str, angle: &Numeral, start: i64, side: i64) -> Value {
        let turned = match angle {
            Numeral::Exact(degrees) => Numeral::Exact(start + side * degrees),
            Numeral::Enclosed(degrees) => Numeral::Enclosed(start + side * degrees),
            Numeral::Float(degrees) => {
                Numeral::Float(f64::integer(start) + f64::integer(side) * degrees)
            }
        };
        let degrees = turned
            .rational()
            .map(|degrees| output::exact(&degrees))
            .or_else(|| turned.shown(self.digits, self.bits));
        json!({"degrees": self.decided(name, degrees)})
    }
}

fn enclosed(number: &Number<Surd>, bits: u32) -> Number<Ball> {
    match number.0.rational() {
        Some(q) => Number::rounded(q, &bits),
        None => number.0.enclosure(bits),
    }
}

fn rounded(position: &Position<Surd>, bits: u32) -> Position<Ball> {
    let point = |z: &Point<Surd>| Number::complex(enclosed(z.re(), bits), enclosed(z.im(), bits));
    Position {
        a: point(&position.a),
        b: point(&position.b),
    }
}

fn rounded_bars(bars: &FourBar<Surd>, bits: u32) -> FourBar<Ball> {
    let FourBar { a, b, c, d } = bars;
    let [a, b, c, d] = [a, b, c, d].map(|bar| enclosed(bar, bits));
    FourBar { a, b, c, d }
}
