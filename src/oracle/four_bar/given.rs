//! Reading a four-bar.

use rug::Rational;

use crate::linkage::cognates::CouplerPoint;
use crate::linkage::coupler_curve::CouplerCurve;
use crate::linkage::four_bar::{FourBar, third_corners};
use crate::number::{Ball, Exact, Number, Real, Surd};
use crate::oracle::ProblemError;
use crate::oracle::input::{Angle, Fields};
use crate::oracle::positions::point;
use crate::plane::{Point, relation};

const JOINTS: [&str; 5] = ["O_a", "A", "B", "O_b", "D"];
const BARS: [&str; 8] = ["Q", "R", "S", "T", "M", "epsilon", "phi0", "assembly"];
/// Bits with which a position that is known by enclosures is tried to be told from one beyond reach.
const BITS_OF_REACH: [u32; 3] = [128, 1024, 8192];

/// A four-bar with a point of its coupler.
pub enum Given {
    /// By its joints in one position.
    Joints(Box<CouplerPoint<Exact>>),
    /// By its lengths, with O_a in the origin and O_b on the positive x-axis.
    Bars(Box<Bars>),
}

/// Lengths and angles.
pub struct Bars {
    q: Rational,
    r: Rational,
    s: Rational,
    t: Rational,
    m: Rational,
    epsilon: Angle,
    position: Option<Position>,
}

/// Which position is asked for.
struct Position {
    phi0: Angle,
    /// B to the left of the line from A to O_b.
    left: bool,
}

/// Numbers and turns of one kind.
struct Kind<K: Real> {
    number: fn(&Rational, &K::Precision) -> Number<K>,
    turn: fn(&Angle, &K::Precision) -> Option<Point<K>>,
    precision: K::Precision,
}

fn exactly() -> Kind<Surd> {
    Kind {
        number: |q, ()| q.clone().into(),
        turn: |angle, ()| Some(angle.exact()?.cis()),
        precision: (),
    }
}

fn in_balls(bits: u32) -> Kind<Ball> {
    Kind {
        number: |q, bits| Number::rounded(q, bits),
        turn: |angle, bits| Some(angle.rounded(bits).cis()),
        precision: bits,
    }
}

impl Given {
    pub fn read(fields: &Fields<'_>) -> Result<Self, ProblemError> {
        if JOINTS.iter().any(|name| fields.has(name)) {
            fields.only(&JOINTS)?;
            return joints(fields);
        }
        fields.only(&BARS)?;
        let m = fields.number("M")?;
        if m.cmp0().is_lt() {
            return Err(fields.error("M", "a length that is not negative was expected"));
        }
        let bars = Bars {
            q: fields.positive("Q")?,
            r: fields.positive("R")?,
            s: fields.positive("S")?,
            t: fields.positive("T")?,
            m,
            epsilon: fields.angle("epsilon")?,
            position: Position::read(fields)?,
        };
        let given = Given::Bars(Box::new(bars));
        given.checked(fields, ["Q", "R", "S", "T"])
    }

    /// All four bars, whose squares are rational.
    pub fn bars(&self) -> FourBar<Surd> {
        let [d, a, c, b] = match self {
            Given::Joints(linkage) => {
                let [q, r, s, t, ..] = CouplerCurve::from(&**linkage).bars().squares;
                [q, r, s, t].map(|(_, square)| square.in_kind::<Surd>().sqrt())
            }
            Given::Bars(bars) => [&bars.q, &bars.r, &bars.s, &bars.t].map(|q| q.clone().into()),
        };
        FourBar { a, b, c, d }
    }

    /// The coupler curve, where sums of square roots hold it.
    pub fn curve_exactly(&self) -> Option<CouplerCurve<Surd>> {
        match self {
            Given::Joints(linkage) => {
                Some(CouplerCurve::from(&**linkage).map(|x| x.in_kind::<Surd>()))
            }
            Given::Bars(bars) => bars.curve(&exactly()),
        }
    }

    /// The coupler curve in balls.
    pub fn curve_in_balls(&self, bits: u32) -> Option<CouplerCurve<Ball>> {
        match self {
            Given::Joints(linkage) => {
                Some(CouplerCurve::from(&**linkage).map(|x| x.in_kind::<Ball>()))
            }
            Given::Bars(bars) => bars.curve(&in_balls(bits)),
        }
    }

    /// Whether a position was given.
    pub fn has_position(&self) -> bool {
        match self {
            Given::Joints(_) => true,
            Given::Bars(bars) => bars.position.is_some(),
        }
    }

    /// The given position, where sums of square roots hold it.
    pub fn position_exactly(&self) -> Option<CouplerPoint<Surd>> {
        match self {
            Given::Joints(linkage) => {
                let to_surds = |z: &Point<Exact>| z.in_kind::<Surd>();
                Some(CouplerPoint {
                    pivots: linkage.pivots.each_ref().map(to_surds),
                    pins: linkage.pins.each_ref().map(to_surds),
                    point: to_surds(&linkage.point),
                })
            }
            Given::Bars(bars) => bars.position_exactly(),
        }
    }

    /// The given position in balls.
    pub fn position_in_balls(&self, bits: u32) -> Option<CouplerPoint<Ball>> {
        match self {
            Given::Joints(_) => None,
            Given::Bars(bars) => bars.position_in_balls(bits),
        }
    }

    fn checked(self, fields: &Fields<'_>, names: [&str; 4]) -> Result<Self, ProblemError> {
        let FourBar { a, b, c, d } = self.bars();
        let bars = [&d, &a, &c, &b];
        let whole = bars.into_iter().fold(Number::zero(), |sum, bar| sum + bar);
        for (bar, name) in bars.into_iter().zip(names) {
            if !(&whole - 2 * bar).is_positive().is_yes() {
                return Err(fields.error(
                    name,
                    "a bar shorter than the other three together was expected: this linkage does \
                     not move",
                ));
            }
        }
        match &self {
            Given::Bars(bars) => bars.check_position(fields)?,
            Given::Joints(_) => {}
        }
        Ok(self)
    }
}

fn joints(fields: &Fields<'_>) -> Result<Given, ProblemError> {
    let at = |name: &str| -> Result<Point<Exact>, ProblemError> { Ok(point(&fields.point(name)?)) };
    let linkage = CouplerPoint {
        pivots: [at("O_a")?, at("O_b")?],
        pins: [at("A")?, at("B")?],
        point: at("D")?,
    };
    let [o_a, o_b] = &linkage.pivots;
    let [a, b] = &linkage.pins;
    for (name, x, y, what) in [
        ("A", o_a, a, "A lies in O_a: a crank of no length"),
        ("B", a, b, "B lies in A: a coupler of no length"),
        ("B", o_b, b, "B lies in O_b: a crank of no length"),
        ("O_b", o_a, o_b, "O_b lies in O_a: a base of no length"),
    ] {
        if x.equals(y).is_yes() {
            return Err(fields.error(name, what));
        }
    }
    Given::Joints(Box::new(linkage)).checked(fields, ["O_b", "A", "B", "B"])
}

impl Position {
    fn read(fields: &Fields<'_>) -> Result<Option<Self>, ProblemError> {
        let assembly = fields.word("assembly", &["left", "right"])?;
        if !fields.has("phi0") {
            return match assembly {
                Some(_) => Err(fields.error("assembly", "it needs an angle `phi0` of the crank R")),
                None => Ok(None),
            };
        }
        Ok(Some(Position {
            phi0: fields.angle("phi0")?,
            left: assembly != Some("right"),
        }))
    }
}

impl Bars {
    fn curve<K: Real>(&self, kind: &Kind<K>) -> Option<CouplerCurve<K>> {
        // AD lies along the x-axis, so that its length is exact whatever ε is.
        let number = |q: &Rational| Number::<K>::from(q.clone());
        let turn = (kind.turn)(&self.epsilon, &kind.precision)?;
        let to_b = turn.conj().scaled(&number(&self.s));
        let to_d = Point::from(number(&self.m));
        let square = |q: &Rational| number(&Rational::from(q.square_ref()));
        Some(CouplerCurve {
            pivots: [Point::zero(), number(&self.q).into()],
            arms: [-&to_d, to_b - to_d],
            cranks: [square(&self.r), square(&self.t)],
        })
    }

    /// A and B; `None` where the kind does not hold them, or where they do not exist.
    fn pins<K: Real>(&self, kind: &Kind<K>) -> Option<[Point<K>; 2]> {
        let Position { phi0, left } = self.position.as_ref()?;
        let number = |q: &Rational| (kind.number)(q, &kind.precision);
        let a = (kind.turn)(phi0, &kind.precision)?.scaled(&number(&self.r));
        let [s, t] = [&self.s, &self.t].map(|q| number(q).square());
        let [on_left, on_right] = third_corners(&a, &number(&self.q).into(), &s, &t)?;
        let pins = [a, if *left { on_left } else { on_right }];
        pins.iter().all(Number::has_value).then_some(pins)
    }

    /// The joints, from A and B; `None` where the kind does not hold D.
    fn with_pins<K: Real>(&self, [a, b]: [Point<K>; 2], kind: &Kind<K>) -> Option<CouplerPoint<K>> {
        let number = |q: &Rational| (kind.number)(q, &kind.precision);
        let turn = (kind.turn)(&self.epsilon, &kind.precision)?;
        let shape = turn.scaled(&(number(&self.m) / number(&self.s)));
        let point = &a + shape * (&b - &a);
        point.has_value().then(|| CouplerPoint {
            pivots: [Point::zero(), number(&self.q).into()],
            pins: [a, b],
            point,
        })
    }

    fn position_exactly(&self) -> Option<CouplerPoint<Surd>> {
        self.with_pins(self.pins(&exactly())?, &exactly())
    }

    fn position_in_balls(&self, bits: u32) -> Option<CouplerPoint<Ball>> {
        let enclosed = |x: &Number<Surd>| match x.0.rational() {
            Some(q) => Number::from(q.clone()),
            None => x.0.enclosure(bits),
        };
        // In a dead centre only exact pins are known not to be beyond it.
        let exactly = self
            .pins(&exactly())
            .map(|pins| pins.map(|pin| Number::complex(enclosed(pin.re()), enclosed(pin.im()))));
        let kind = in_balls(bits);
        self.with_pins(exactly.or_else(|| self.pins(&kind))?, &kind)
    }

    /// 4 S² A O_b² (sin² of the angle at A): less than zero where the linkage does not close.
    fn reach<K: Real>(&self, kind: &Kind<K>) -> Option<(Number<K>, Number<K>)> {
        let position = self.position.as_ref()?;
        let number = |q: &Rational| (kind.number)(q, &kind.precision);
        let a = (kind.turn)(&position.phi0, &kind.precision)?.scaled(&number(&self.r));
        let diagonal = relation::distance_squared(&a, &number(&self.q).into());
        let [s, t] = [&self.s, &self.t].map(|q| number(q).square());
        let reach = 4 * &s * &diagonal - (&s + &diagonal - t).square();
        Some((reach, diagonal))
    }

    fn check_position(&self, fields: &Fields<'_>) -> Result<(), ProblemError> {
        if self.position.is_none() {
            return Ok(());
        }
        let closes = match self.reach(&exactly()) {
            Some((_, diagonal)) if diagonal.is_zero().is_yes() => {
                return Err(fields.error("phi0", "A comes into O_b, where B is not determined"));
            }
            Some((reach, _)) => reach.sign(),
            None => BITS_OF_REACH
                .into_iter()
                .find_map(|bits| self.reach(&in_balls(bits))?.0.sign()),
        };
        if closes.is_some_and(std::cmp::Ordering::is_lt) {
            return Err(fields.error(
                "phi0",
                "an angle at which the linkage closes was expected; \"cranks\" of the answer without \
                 it has the limits",
            ));
        }
        Ok(())
    }
}
