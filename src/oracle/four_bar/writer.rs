//! The curve, the bars and their cognates, and the given position.

use serde_json::{Map, Value, json};

use super::motion::crank_word;
use crate::linkage::cognates::CouplerPoint;
use crate::linkage::coupler_curve::{Bars, CouplerCurve};
use crate::linkage::four_bar::FourBar;
use crate::number::{Number, Surd, Truth};
use crate::oracle::linkages::words;
use crate::oracle::numeral::Shown;
use crate::oracle::sharpen::Attempt;
use crate::plane::Point;

impl Attempt {
    /// All that does not depend on a position.
    pub fn curve<K: Shown>(
        &mut self,
        curve: &CouplerCurve<K>,
        lengths: &FourBar<Surd>,
    ) -> Map<String, Value> {
        let mut answer = self.bars(&curve.bars());
        // The four bars are known better than by an angle of the coupler triangle.
        let FourBar { a, b, c, d } = lengths;
        for (name, length) in [("Q", d), ("R", a), ("S", c), ("T", b)] {
            answer.insert(name.into(), self.numeral(name, &Surd::numeral(length)));
        }
        let sextic = curve.sextic();
        answer.insert(
            "sextic".into(),
            self.coefficients("sextic", sextic.coefficients()),
        );
        let foci = curve.foci();
        let foci = foci
            .each_ref()
            .map(|focus| self.finite_point("foci", focus));
        answer.insert("foci".into(), json!(foci));
        let circle = curve.circle();
        let circle = [circle.a, circle.b, circle.c, circle.d];
        answer.insert("circle".into(), self.coefficients("circle", &circle));
        answer.extend(self.double_points(curve));
        let lengths = of_cognates(lengths);
        let cognates = curve.cognate_bars();
        let cognates = cognates.iter().zip(&lengths).map(|(bars, lengths)| {
            let mut fields = self.bars(bars);
            let [q, r, ..] = &bars.squares;
            if (q.1.is_zero() | r.1.is_zero()).is_yes() {
                // D in A or in B: there is no such linkage.
                fields.extend(["type", "crank"].map(|name| (name.to_owned(), Value::Null)));
            } else {
                fields.extend(self.words(lengths));
            }
            Value::Object(fields)
        });
        answer.insert("cognates".into(), cognates.collect());
        answer
    }

    /// Pivots, lengths, and the angle of the coupler triangle.
    fn bars<K: Shown>(&mut self, bars: &Bars<K>) -> Map<String, Value> {
        let mut fields = Map::new();
        for (name, pivot) in ["O_a", "O_b"].into_iter().zip(&bars.pivots) {
            fields.insert(name.into(), self.finite_point(name, pivot));
        }
        for (name, square) in &bars.squares {
            let length = K::numeral(square).sqrt(self.bits);
            fields.insert((*name).into(), self.numeral(name, &length));
        }
        fields.insert("epsilon".into(), self.angle_of("epsilon", &bars.epsilon));
        fields
    }

    /// An angle with a bar of no length is none.
    fn angle_of<K: Shown>(&mut self, name: &str, direction: &Point<K>) -> Value {
        match direction.is_zero() {
            Truth::Yes => Value::Null,
            _ => self.turn(name, direction),
        }
    }

    /// Type and crank.
    pub fn words(&mut self, lengths: &FourBar<Surd>) -> Map<String, Value> {
        let kind = lengths.link_type().map(|kind| json!(words::name(kind)));
        let crank = crank_word(lengths).map(Value::from);
        let mut fields = Map::new();
        fields.insert("type".into(), self.decided("type", kind));
        fields.insert("crank".into(), self.decided("crank", crank));
        fields
    }

    /// The joints of the linkage and of its cognates, and the angles of its bars.
    pub fn position<K: Shown>(
        &mut self,
        linkage: &CouplerPoint<K>,
        answer: &mut Map<String, Value>,
    ) {
        answer.extend(self.joints(linkage));
        let cognates = linkage.cognates();
        let written = answer.get_mut("cognates").and_then(Value::as_array_mut);
        for (fields, cognate) in written.into_iter().flatten().zip(&cognates) {
            if let Value::Object(fields) = fields {
                fields.extend(self.joints(cognate));
            }
        }
    }

    fn joints<K: Shown>(&mut self, linkage: &CouplerPoint<K>) -> Map<String, Value> {
        let CouplerPoint {
            pivots: [o_a, o_b],
            pins: [a, b],
            point: d,
        } = linkage;
        let mut fields = Map::new();
        for (name, point) in [("A", a), ("B", b), ("D", d)] {
            fields.insert(name.into(), self.finite_point(name, point));
        }
        let base = o_b - o_a;
        for (name, bar) in [("phi0", a - o_a), ("psi0", b - o_b), ("chi0", b - a)] {
            let turn = bar * base.conj();
            fields.insert(name.into(), self.angle_of(name, &turn));
        }
        fields
    }
}

/// The lengths of the cognates up to a factor: with λ = AD : AB those on O_a and O_c are |λ| times
/// S, T, R, Q in the place of R, T, S, Q; those on O_b and O_c likewise.
fn of_cognates(lengths: &FourBar<Surd>) -> [FourBar<Surd>; 2] {
    let FourBar { a, b, c, d } = lengths;
    let bars = |[a, b, c]: [&Number<Surd>; 3]| FourBar {
        a: a.clone(),
        b: b.clone(),
        c: c.clone(),
        d: d.clone(),
    };
    [bars([c, b, a]), bars([c, a, b])]
}
