//! Scenes: what they bind, what they ask for, and that their mechanisms are what they say.
#![allow(
    clippy::unwrap_used,
    clippy::as_conversions,
    clippy::indexing_slicing,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use std::collections::{BTreeMap, BTreeSet};

use crate::support::seed::rounds;
use burmester::formula::{Bindings, Formula, Value, read};
use burmester::ledger::built_in;
use burmester::number::{Ball, Exact, Number, Real, Truth};
use burmester::plane::{Angle, relation};
use burmester::scenes::check::Basis;
use burmester::scenes::free::{Given, Random, Symbols};
use burmester::scenes::{
    Free, Scene, Unbuilt, checks, find, find_check, find_table, scenes, tables,
};
use rug::Rational;

/// Scenes without a form for all values of their parameters, and why.
const NOT_SYMBOLIC: [(&str, &str); 23] = [
    ("wunderlich1968/figure-2-of-any-shape", "the winding number"),
    (
        "wunderlich1968/focal-cubic",
        "an order that holds for all values",
    ),
    (
        "wunderlich1968/focal-cubic-of-a-parallelogram",
        "an order that holds for all values",
    ),
    ("wunderlich1968/revolving-coupler", "which of two lengths"),
    (
        "filemon1970/angle-of-the-asymptote",
        "an angle between 0 and pi",
    ),
    (
        "filemon1970/construction-of-both-pairs",
        "those of the second place",
    ),
    ("filemon1973/pole-quadrilateral", "sides without an order"),
    ("filemon1973/any-shape", "numbers of real tangents"),
    ("filemon1973/point-pairs", "numbers of real tangents"),
    ("filemon1973/tangents-of-a-kite", "numbers of real tangents"),
    ("tesar1964/slider-crank", "the sign of the discriminant"),
    ("kaufman/circuits", "the number of real roots"),
    ("tesar1964/five-positions", "the solution of four linear"),
    (
        "tesar1964/five-positions-on-a-line",
        "the solution of four linear",
    ),
    (
        "tesar1964/two-known-roots",
        "a quotient of polynomials in fourteen",
    ),
    ("tesar1964/crank", "the sign of a length"),
    (
        "tesar1964/conchoidal-fixed-link",
        "the sign of a difference",
    ),
    ("tesar1964/symmetric-linkage", "the sign of a"),
    ("tesar1964/grashof", "whether links turn fully"),
    ("tesar1964/grashof-in-order", "whether links turn fully"),
    (
        "tesar1964/type-of-mechanism",
        "the length of the fixed link",
    ),
    ("tesar1964/transmission-angle", "the sign of a cosine"),
    (
        "tesar1964/dead-centres-of-a-double-lever",
        "the type of a linkage",
    ),
];

/// Scenes that need a decision which rounded parameters do not allow.
const NOT_IN_BALLS: [&str; 5] = [
    "wunderlich1968/focal-cubic-of-a-parallelogram",
    "filemon1973/node-of-case-A",
    "filemon1973/node-of-case-B",
    "filemon1973/bisectors",
    "filemon1973/tangents-of-a-kite",
];

/// Scenes of printed examples, which random parameters have no chance to meet: what a program computed.
const OF_EXAMPLES: [&str; 11] = [
    "tesar1964/program",
    "tesar1964/program-level",
    "tesar1964/program-row",
    "tesar1964/four-bar-with-a-double-point",
    "tesar1964/alternate-of-a-and-b",
    "tesar1964/alternate-of-b-and-c",
    "tesar1964/alternate-of-c-and-a",
    "tesar1964/burmester-figure",
    "tesar1964/watt-figure",
    "tesar1964/symmetric-figure",
    "tesar1964/evans-figure",
];

/// All scenes that random parameters meet.
fn drawn() -> impl Iterator<Item = &'static Scene> {
    let of_examples = |scene: &&Scene| OF_EXAMPLES.contains(&scene.name);
    scenes().iter().filter(move |scene| !of_examples(scene))
}

/// All of them that can be built with rounded parameters.
fn scenes_of_rounded_numbers() -> impl Iterator<Item = &'static Scene> {
    drawn().filter(|scene| !NOT_IN_BALLS.contains(&scene.name))
}

/// Parameters for which everything in the slider-crank's scene is rational or a sum of roots.
const HELD_EXACTLY: [(&str, &str); 3] = [("k", "1"), ("alpha_a", "45 deg"), ("alpha_d", "90 deg")];

fn documented(scene: &Scene) -> BTreeSet<&str> {
    scene.symbols.iter().map(|symbol| symbol.name).collect()
}

#[track_caller]
fn binds_what_it_documents<K: Real>(scene: &Scene, bindings: &Bindings<K>, kind: &str) {
    let bound: BTreeSet<&str> = bindings.names().collect();
    assert_eq!(bound, documented(scene), "{} in {kind}", scene.name);
    for name in bound {
        let value = bindings.get(name).unwrap();
        assert!(
            value.has_value(),
            "{}: {name} in {kind} has no value",
            scene.name
        );
    }
}

fn formulas<'a>(pairs: impl IntoIterator<Item = (&'a str, &'a str)>) -> BTreeMap<String, Formula> {
    pairs
        .into_iter()
        .map(|(name, text)| (name.to_owned(), read(text).unwrap()))
        .collect()
}

/// Bits of the balls.
const BITS: u32 = 200;

/// What a scene asks its source for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wanted {
    Length,
    Number,
    Angle,
    Position,
}

/// Random parameters, kept as formulas.
struct Noted {
    random: Random,
    given: BTreeMap<String, (Wanted, String)>,
}

impl Noted {
    fn new(seed: u64) -> Self {
        Noted {
            random: Random::new(seed),
            given: BTreeMap::new(),
        }
    }

    fn note(&mut self, name: &str, wanted: Wanted, text: String) {
        let before = self.given.insert(name.to_owned(), (wanted, text));
        assert!(before.is_none(), "`{name}` is asked for twice");
    }

    fn example(&self) -> BTreeMap<String, Formula> {
        formulas(
            self.given
                .iter()
                .map(|(name, (_, text))| (name.as_str(), text.as_str())),
        )
    }
}

fn rounded(exact: &Number<Exact>) -> Number<Ball> {
    Number::rounded(exact.0.rational().unwrap(), &BITS)
}

impl Free<Ball> for Noted {
    fn precision(&self) -> u32 {
        BITS
    }

    fn length(&mut self, name: &str) -> Result<Number<Ball>, Unbuilt> {
        let length: Number<Exact> = self.random.length(name)?;
        self.note(name, Wanted::Length, length.to_string());
        Ok(rounded(&length))
    }

    fn number(&mut self, name: &str) -> Result<Number<Ball>, Unbuilt> {
        let number: Number<Exact> = self.random.number(name)?;
        self.note(name, Wanted::Number, number.to_string());
        Ok(rounded(&number))
    }

    fn angle(&mut self, name: &str) -> Result<Angle<Ball>, Unbuilt> {
        let half: Number<Exact> = self.random.number(name)?;
        self.note(name, Wanted::Angle, format!("2 arctan({half})"));
        Ok(Angle::from_tan_half(&rounded(&half)))
    }

    fn position(&mut self, name: &str) -> Result<Angle<Ball>, Unbuilt> {
        let angle = self.angle(name)?;
        self.given.get_mut(name).unwrap().0 = Wanted::Position;
        Ok(angle)
    }
}

/// Parameters that the scene accepts, with what each of them is.
fn accepted(scene: &Scene) -> Noted {
    for seed in 0..500 {
        let mut noted = Noted::new(seed);
        if (scene.certified)(&mut noted).is_ok() {
            return noted;
        }
    }
    panic!("{} is built by none of 500 seeds", scene.name);
}

#[test]
fn scenes_have_different_names_and_are_found_by_them() {
    let names: BTreeSet<&str> = scenes().iter().map(|scene| scene.name).collect();
    assert_eq!(names.len(), scenes().len());
    for scene in scenes() {
        assert!(find(scene.name).is_some_and(|found| found.summary == scene.summary));
        assert_eq!(
            documented(scene).len(),
            scene.symbols.len(),
            "{}",
            scene.name
        );
        for symbol in scene.symbols {
            assert!(
                !symbol.meaning.is_empty(),
                "{}: {}",
                scene.name,
                symbol.name
            );
        }
    }
    assert!(find("no/such-scene").is_none());
}

#[test]
fn every_scene_binds_what_it_documents_in_floats() {
    for scene in scenes_of_rounded_numbers() {
        let example = accepted(scene).example();
        match (scene.float)(&mut Given::new(&example, ())) {
            Ok(bindings) => binds_what_it_documents(scene, &bindings, "f64"),
            Err(why) => panic!("{} in f64: {why}", scene.name),
        }
    }
}

#[test]
fn every_scene_binds_what_it_documents_in_balls() {
    for scene in scenes_of_rounded_numbers() {
        let example = accepted(scene).example();
        let bindings = (scene.certified)(&mut Given::new(&example, BITS)).unwrap();
        binds_what_it_documents(scene, &bindings, "balls");
    }
}

#[test]
fn every_scene_binds_what_it_documents_exactly() {
    for scene in drawn() {
        let built = (0..500).find_map(|seed| (scene.exact)(&mut Random::new(seed)).ok());
        let bindings = built.unwrap_or_else(|| {
            let example = formulas(HELD_EXACTLY);
            (scene.exact)(&mut Given::new(&example, ())).unwrap()
        });
        binds_what_it_documents(scene, &bindings, "sums of roots");
    }
}

#[test]
fn every_scene_binds_what_it_documents_with_free_symbols() {
    for scene in drawn() {
        let without = NOT_SYMBOLIC.iter().find(|(name, _)| *name == scene.name);
        match ((scene.symbolic)(&mut Symbols::default()), without) {
            (Ok(bindings), None) => binds_what_it_documents(scene, &bindings, "symbols"),
            (Err(Unbuilt::NotHeld(why)), Some((_, expected))) => {
                assert!(why.contains(expected), "{}: {why}", scene.name);
            }
            (Ok(_), Some(_)) => panic!("{} is symbolic after all", scene.name),
            (Err(why), _) => panic!("{}: {why}", scene.name),
        }
    }
}

/// Statements about a scene give what it asks for.
#[test]
fn scenes_of_examples_bind_what_they_document() {
    for name in OF_EXAMPLES {
        let scene = find(name).unwrap();
        let papers = built_in().unwrap();
        let mut statements = papers.iter().flat_map(|paper| &paper.statements);
        let of_scene = statements.find(|statement| statement.scene.name == name);
        let given = &of_scene.unwrap().example.as_ref().unwrap().given;
        let bindings = (scene.certified)(&mut Given::new(given, BITS)).unwrap();
        binds_what_it_documents(scene, &bindings, "balls");
        let floats = (scene.float)(&mut Given::new(given, ())).unwrap();
        for name in floats.names() {
            assert!(documented(scene).contains(name), "{}: {name}", scene.name);
        }
    }
}

#[test]
fn random_parameters_are_refused_with_a_reason_at_most() {
    for scene in drawn() {
        let mut built = 0;
        for seed in 0..rounds(60) as u64 {
            for outcome in [
                (scene.exact)(&mut Random::new(seed)).err(),
                (scene.float)(&mut Random::new(seed)).err(),
            ] {
                match outcome {
                    None => built += 1,
                    Some(Unbuilt::NotReal(_) | Unbuilt::NotHeld(_)) => {}
                    // A float never meets an identity exactly.
                    Some(Unbuilt::Contradiction(_))
                        if (scene.exact)(&mut Random::new(seed)).is_ok() => {}
                    Some(why) => panic!("{}, seed {seed}: {why}", scene.name),
                }
            }
        }
        assert!(built > 0, "{} is never built", scene.name);
    }
}

/// The same parameters in every kind give the same values.
#[test]
fn floats_and_balls_agree() {
    for scene in scenes_of_rounded_numbers() {
        let example = accepted(scene).example();
        let balls = (scene.certified)(&mut Given::new(&example, BITS)).unwrap();
        let floats = (scene.float)(&mut Given::new(&example, ()))
            .unwrap_or_else(|why| panic!("{}: {why}", scene.name));
        for symbol in scene.symbols {
            let (Some(Value::Number(ball)), Some(Value::Number(float))) =
                (balls.get(symbol.name), floats.get(symbol.name))
            else {
                continue;
            };
            let exact = ball.0.midpoint_rational().unwrap().to_f64();
            let difference = (exact - float.0).abs();
            let allowed = 1e-9 * exact.abs().max(1.0);
            let place = format!("{}: {}", scene.name, symbol.name);
            assert!(
                difference <= allowed,
                "{place} is {exact}, in floats {}",
                float.0
            );
        }
    }
}

mod sources {
    use super::*;

    /// Builds from an example in balls, and says why not.
    fn refused(scene: &Scene, example: &BTreeMap<String, Formula>) -> Option<Unbuilt> {
        (scene.certified)(&mut Given::new(example, BITS)).err()
    }

    /// Every scene with each of its parameters in turn.
    fn each_parameter(what: impl Fn(&Scene, &str, Wanted, BTreeMap<String, Formula>)) {
        for scene in scenes_of_rounded_numbers() {
            let noted = accepted(scene);
            assert!(refused(scene, &noted.example()).is_none(), "{}", scene.name);
            for (name, (wanted, _)) in &noted.given {
                what(scene, name, *wanted, noted.example());
            }
        }
    }

    #[test]
    fn an_example_must_give_every_parameter_but_the_position() {
        each_parameter(|scene, name, wanted, mut example| {
            example.remove(name);
            let expected = (wanted != Wanted::Position).then(|| Unbuilt::Missing(name.to_owned()));
            assert_eq!(
                refused(scene, &example),
                expected,
                "{} without {name}",
                scene.name
            );
        });
    }

    #[test]
    fn a_length_is_positive() {
        each_parameter(|scene, name, wanted, mut example| {
            for text in ["-1", "0", "-1/1000"] {
                example.insert(name.to_owned(), read(text).unwrap());
                if wanted == Wanted::Length {
                    let expected = Unbuilt::Unfit(name.to_owned(), "is not positive".to_owned());
                    let found = refused(scene, &example);
                    assert_eq!(found, Some(expected), "{}: {name} = {text}", scene.name);
                }
            }
        });
    }

    #[test]
    fn a_number_is_no_angle_and_an_angle_no_number() {
        each_parameter(|scene, name, wanted, mut example| {
            let (text, what) = match wanted {
                Wanted::Length | Wanted::Number => ("30 deg", "not a number"),
                Wanted::Angle => ("3/7", "not an angle"),
                Wanted::Position => return,
            };
            example.insert(name.to_owned(), read(text).unwrap());
            match refused(scene, &example) {
                Some(Unbuilt::Unfit(of, why)) if of == name && why.contains(what) => {}
                other => panic!("{}: {name} = {text} gave {other:?}", scene.name),
            }
        });
    }

    #[test]
    fn a_parameter_that_cannot_be_evaluated_is_named() {
        each_parameter(|scene, name, wanted, mut example| {
            if wanted == Wanted::Position {
                return;
            }
            for (text, why) in [("q_unknown", "unknown symbol"), ("1/0", "no value")] {
                example.insert(name.to_owned(), read(text).unwrap());
                match refused(scene, &example) {
                    Some(Unbuilt::Unfit(of, found)) if of == name && found.contains(why) => {}
                    other => panic!("{}: {name} = {text} gave {other:?}", scene.name),
                }
            }
        });
    }

    #[test]
    fn seeds_give_the_same_parameters_for_ever() {
        let mut random = Random::new(1968);
        let length: Number<Exact> = random.length("m").unwrap();
        let number: Number<Exact> = random.number("x").unwrap();
        let angle: Angle<Exact> = random.angle("omega").unwrap();
        let drawn = [length, number, angle.half().tan()].map(|x| x.to_string());
        assert_eq!(drawn, ["257/229", "-389/411", "537/457"]);
    }

    #[test]
    fn random_lengths_are_positive_and_numbers_have_both_signs() {
        let mut random = Random::new(3);
        let mut signs = BTreeSet::new();
        for _ in 0..200 {
            let length: Number<Exact> = random.length("x").unwrap();
            assert_eq!(length.is_positive(), Truth::Yes);
            let number: Number<Exact> = random.number("x").unwrap();
            signs.insert(number.sign());
        }
        assert_eq!(signs.len(), 2, "{signs:?}");
    }

    #[test]
    fn symbols_know_what_lengths_and_angles_satisfy() {
        let mut symbols = Symbols::default();
        let length = symbols.length("a").unwrap();
        let number = symbols.number("x").unwrap();
        let angle = symbols.angle("phi").unwrap();
        let root = symbols
            .root("c", &(length.square() + number.square()))
            .unwrap();
        assert_eq!(length.is_positive(), Truth::Yes);
        assert_eq!(number.is_positive(), Truth::Unknown);
        assert_eq!(
            (angle.cos().square() + angle.sin().square()).equals(&1.into()),
            Truth::Yes
        );
        assert_eq!(
            root.square().equals(&(length.square() + number.square())),
            Truth::Yes
        );
        assert_eq!(root.is_positive(), Truth::Yes);
        let slope = symbols.slope("psi").unwrap();
        let unit = slope.cos().square() + slope.sin().square();
        assert_eq!(unit.equals(&1.into()), Truth::Yes);
        let quotient = slope.sin() / slope.cos();
        assert_eq!(quotient.equals(&slope.tan()), Truth::Yes);
        assert!(slope.direction().re().equals(&1.into()).is_yes());
    }
}

#[test]
fn every_check_holds_and_rejects_its_wrong_variant() {
    assert!(!checks().is_empty());
    for check in checks() {
        let report = (check.run)().unwrap();
        assert_eq!(report.holds, Truth::Yes, "{}", check.name);
        assert_eq!(
            report.wrong_variant,
            Truth::No,
            "{} rejects nothing",
            check.name
        );
        assert!(
            report.basis == Basis::Identity || report.instances > 0,
            "{} ran on nothing",
            check.name
        );
        assert!(find_check(check.name).is_some_and(|found| found.summary == check.summary));
    }
    assert!(find_check("no-such-check").is_none());
}

#[test]
fn every_table_has_each_cell_once_and_rejects_its_wrong_variant() {
    assert!(!tables().is_empty());
    for table in tables() {
        let computed = (table.run)().unwrap();
        assert_eq!(computed.wrong_variant, Truth::No, "{}", table.name);
        assert!(computed.instances > 0, "{} ran on nothing", table.name);
        let places: BTreeSet<_> = computed
            .cells
            .iter()
            .map(|cell| (cell.part, cell.row, cell.column))
            .collect();
        assert_eq!(places.len(), computed.cells.len(), "{}", table.name);
        assert!(find_table(table.name).is_some_and(|found| found.summary == table.summary));
    }
    assert!(find_table("no-such-table").is_none());
}

/// The sides are those between the poles, and U and Z are what their names say.
#[test]
fn the_pole_quadrilateral_has_its_sides_and_sums() {
    let scene = find("filemon1973/pole-quadrilateral").unwrap();
    let mut seen = 0;
    for seed in 0..200 {
        let Ok(bindings) = (scene.exact)(&mut Random::new(seed)) else {
            continue;
        };
        seen += 1;
        let number = |name: &str| match bindings.get(name) {
            Some(Value::Number(x)) => x.clone(),
            other => panic!("{name} is {other:?}"),
        };
        let point = |name: &str| bindings.get(name).unwrap().to_point().unwrap();
        for (side, from, to) in [
            ("r", "O_12", "O_23"),
            ("h", "O_23", "O_34"),
            ("R", "O_34", "O_14"),
            ("c", "O_14", "O_12"),
        ] {
            let squared = relation::distance_squared(&point(from), &point(to));
            let found = number(side).square().equals(&squared);
            assert_eq!(found, Truth::Yes, "seed {seed}: {side} is {from} {to}");
        }
        let mut sides = ["r", "h", "R", "c"].map(number);
        sides.sort_by(|a, b| a.compare(b).unwrap());
        let [shortest, second, third, longest] = sides;
        let u = number("U").equals(&(shortest + longest));
        assert_eq!(
            u,
            Truth::Yes,
            "seed {seed}: U is the shortest and the longest"
        );
        let z = number("Z").equals(&(second + third));
        assert_eq!(z, Truth::Yes, "seed {seed}: Z is the other two");
    }
    assert!(seen >= 10, "only {seen} of 200 seeds");
}

/// Hart's five-bar and the focal mechanism, against their definitions.
mod five_bar {
    use burmester::linkage::five_bar::{
        Chain, Lengths, center_of_path, distance_squared_from_base_point, lay,
    };
    use burmester::linkage::focal_mechanism;
    use burmester::plane::Point;

    use super::*;

    fn lengths<K: Real<Precision = ()>>(random: &mut Random) -> Lengths<K> {
        let mut length = |name| random.length(name).unwrap();
        Lengths {
            m: length("m"),
            p: length("p"),
            q: length("q"),
            n: length("n"),
        }
    }

    fn holds(what: &str, truth: Truth) {
        assert_eq!(truth, Truth::Yes, "{what}");
    }

    #[test]
    fn a_chain_has_its_bars_and_angles() {
        for seed in 0..20 {
            let mut random = Random::new(seed);
            let bars: Lengths<Exact> = lengths(&mut random);
            let (turn, omega): (Angle<Exact>, Angle<Exact>) = (
                random.angle("turn").unwrap(),
                random.angle("omega").unwrap(),
            );
            let Chain { p, f, q, n, .. } = lay(&bars, &turn, &omega);
            let origin = Point::<Exact>::zero();
            for (what, from, to, length) in [
                ("MP", &origin, &p, &bars.m),
                ("PF", &p, &f, &bars.p),
                ("FQ", &f, &q, &bars.q),
                ("QN", &q, &n, &bars.n),
            ] {
                holds(
                    what,
                    relation::distance_squared(from, to).equals(&length.square()),
                );
            }
            holds("P on the x-axis", p.im().is_zero() & p.re().is_positive());
            let straight = Angle::from_cos_sin(Number::from(-1), Number::zero());
            holds(
                "angle MPF",
                Angle::at_vertex(&origin, &p, &f).equals(&omega),
            );
            holds(
                "angle FQN",
                Angle::at_vertex(&f, &q, &n).equals(&(&straight - &omega)),
            );
            holds("the turn", Angle::of(&q - &n).equals(&turn));
        }
    }

    /// F for a base of length d: on a circle about M by ω alone, and on one about N.
    #[test]
    fn the_center_of_the_path_is_as_far_from_f_for_every_omega() {
        for seed in 0..20 {
            let mut random = Random::new(seed);
            let bars: Lengths<Exact> = lengths(&mut random);
            let d: Number<Exact> = random.length("d").unwrap();
            let omegas: [Angle<Exact>; 3] = std::array::from_fn(|_| random.angle("omega").unwrap());
            let s = center_of_path(&bars, &d, &omegas[0], &omegas[1]);
            let squares = omegas.each_ref().map(|omega| {
                // Law of cosines in MPF and FQN, where cos(π − ω) = −cos ω.
                let from_m =
                    bars.m.square() + bars.p.square() - 2 * &bars.m * &bars.p * omega.cos();
                let from_n =
                    bars.n.square() + bars.q.square() + 2 * &bars.n * &bars.q * omega.cos();
                let x = (&from_m - from_n + d.square()) / (2 * &d);
                let y_squared = &from_m - x.square();
                let expected = (x - &s).square() + y_squared;
                let found = distance_squared_from_base_point(&bars, &d, omega, &s);
                holds("SF²", found.equals(&expected));
                expected
            });
            holds("the same for two", squares[0].equals(&squares[1]));
            holds("and for a third", squares[0].equals(&squares[2]));
        }
    }

    /// The rate of |AB|², against the difference over a small step of a motion that keeps the base.
    #[test]
    fn the_rate_of_a_distance_is_that_of_the_motion() {
        for seed in 0..20 {
            let mut random = Random::new(seed);
            let bars: Lengths<f64> = lengths(&mut random);
            let mut angle = || {
                let half: Number<f64> = random.number("angle").unwrap();
                2.0 * half.0.atan()
            };
            let (turn, omega) = (angle(), angle());
            let (a, b): (Number<f64>, Number<f64>) =
                (random.number("a").unwrap(), random.number("b").unwrap());
            let at = |turn: f64, omega: f64| {
                let angle = |x: f64| Angle::from_cos_sin(Number(x.cos()), Number(x.sin()));
                lay(&bars, &angle(turn), &angle(omega))
            };
            let base = |turn: f64, omega: f64| at(turn, omega).n.norm().0;
            let coupler = |turn: f64, omega: f64| {
                let chain = at(turn, omega);
                let pin = &chain.n + chain.v.scaled(&b);
                relation::distance_squared(&pin, &Point::from(a.clone())).0
            };
            type Of<'a> = &'a dyn Fn(f64, f64) -> f64;
            let h = 1e-5;
            let by_turn = |f: Of| (f(turn + h, omega) - f(turn - h, omega)) / (2.0 * h);
            let by_omega = |f: Of| (f(turn, omega + h) - f(turn, omega - h)) / (2.0 * h);
            // Along the motion the two angles change as ∂/∂ω and −∂/∂turn of |MN|²; each rate in
            // the library is half of that of the square, so that of the product is a quarter.
            let expected =
                (by_turn(&coupler) * by_omega(&base) - by_omega(&coupler) * by_turn(&base)) / 4.0;
            let found = at(turn, omega).rate_of_distance_squared(&a, &b).0;
            let size = found.abs().max(expected.abs()).max(1.0);
            assert!(
                (found - expected).abs() < 1e-5 * size,
                "seed {seed}: {found}, by differences {expected}"
            );
        }
    }

    #[test]
    fn the_arms_keep_the_coupler_and_no_others_do() {
        for seed in 0..20 {
            let mut random = Random::new(seed);
            let bars: Lengths<Exact> = lengths(&mut random);
            let (turn, omega): (Angle<Exact>, Angle<Exact>) = (
                random.angle("turn").unwrap(),
                random.angle("omega").unwrap(),
            );
            let chain = lay(&bars, &turn, &omega);
            let (a, b) = focal_mechanism::arms(&bars);
            assert_eq!(
                focal_mechanism::keeps_coupler(&chain, &a, &b),
                Truth::Yes,
                "seed {seed}"
            );
            for (a, b) in [
                (2 * &bars.m - &a, 2 * &bars.n - &b),
                (&a + 1, b.clone()),
                (a.clone(), -&b),
            ] {
                let found = focal_mechanism::keeps_coupler(&chain, &a, &b);
                assert_eq!(found, Truth::No, "seed {seed}, {a} and {b}");
            }
        }
    }
}

/// The Burmester points of the slider-crank, against a slider-crank that moves: its closure is
/// solved for the coupler's motion as a power series in the angle by which the coupler turns.
mod slider_crank {
    use burmester::curvature::slider_crank::{Alternates, Pair, Quotient, SliderCrank};
    use burmester::plane::Point;

    use super::*;

    const BITS: u32 = 400;
    /// Terms 1, θ, …, θ⁴.
    const TERMS: usize = 5;

    type Series = Vec<Point<Ball>>;

    fn exactly(q: impl Into<Rational>) -> Number<Ball> {
        Number::rounded(&q.into(), &BITS)
    }

    fn constant(z: &Point<Ball>) -> Series {
        let mut series = vec![Point::<Ball>::zero(); TERMS];
        series[0] = z.clone();
        series
    }

    fn plus(a: &Series, b: &Series) -> Series {
        a.iter().zip(b).map(|(x, y)| x + y).collect()
    }

    fn times(a: &Series, b: &Series) -> Series {
        (0..TERMS)
            .map(|n| (0..=n).map(|j| &a[j] * &b[n - j]).sum())
            .collect()
    }

    fn conjugate(a: &Series) -> Series {
        a.iter().map(Number::conj).collect()
    }

    /// e^{iθ}.
    fn turn() -> Series {
        let mut term: Point<Ball> = exactly(1).into();
        let mut series = Vec::new();
        for n in 0..TERMS as i64 {
            series.push(term.clone());
            term = (term * Number::i()).scaled(&exactly(Rational::from((1, n + 1))));
        }
        series
    }

    /// Where a coupler point z is: a(θ) + e^{iθ} z.
    fn path(motion: &Series, z: &Point<Ball>) -> Series {
        plus(motion, &times(&turn(), &constant(z)))
    }

    /// Where a fixed point is, seen from the coupler: e^{−iθ}(Z − a(θ)).
    fn seen(motion: &Series, z: &Point<Ball>) -> Series {
        let away: Series = motion.iter().map(|x| -x).collect();
        times(&conjugate(&turn()), &plus(&constant(z), &away))
    }

    /// A quantity that the closure keeps.
    enum Keeps {
        /// The distance of a coupler point from a fixed one.
        Distance {
            point: Point<Ball>,
            center: Point<Ball>,
        },
        /// The place of a coupler point along a direction: it moves on a line.
        Line {
            point: Point<Ball>,
            normal: Point<Ball>,
        },
        /// The same of a fixed point in the coupler.
        LineInCoupler {
            center: Point<Ball>,
            normal: Point<Ball>,
        },
    }

    impl Keeps {
        /// Of a ray through the pole: the point at p and the center at q along it, one of which may
        /// be infinitely far.
        fn of(ray: &Point<Ball>, point: &Quotient<Ball>, center: &Quotient<Ball>) -> Keeps {
            let place = |q: &Quotient<Ball>| ray.scaled(&q.value());
            let infinite = |q: &Quotient<Ball>| q.denominator.is_zero().is_yes();
            match (infinite(point), infinite(center)) {
                (false, false) => Keeps::Distance {
                    point: place(point),
                    center: place(center),
                },
                (false, true) => Keeps::Line {
                    point: place(point),
                    normal: ray.clone(),
                },
                (true, false) => Keeps::LineInCoupler {
                    center: place(center),
                    normal: ray.clone(),
                },
                (true, true) => panic!("point and center are both infinitely far"),
            }
        }

        /// The kept quantity along a motion, as a series.
        fn along(&self, motion: &Series) -> Vec<Number<Ball>> {
            let (from, to) = match self {
                Keeps::Distance { point, center } => {
                    let difference = plus(&path(motion, point), &constant(&-center));
                    (conjugate(&difference), difference)
                }
                Keeps::Line { point, normal } => (constant(&normal.conj()), path(motion, point)),
                Keeps::LineInCoupler { center, normal } => {
                    (constant(&normal.conj()), seen(motion, center))
                }
            };
            times(&from, &to).iter().map(|z| z.re().clone()).collect()
        }

        /// How its coefficient n depends on the coefficient n of the motion: as the real part of the
        /// product with the conjugate of this.
        fn gradient(&self) -> Point<Ball> {
            match self {
                Keeps::Distance { point, center } => 2 * (point - center),
                Keeps::Line { normal, .. } => normal.clone(),
                Keeps::LineInCoupler { normal, .. } => -normal,
            }
        }
    }

    /// The motion a(θ) that keeps two quantities, coefficient by coefficient.
    fn motion(first: &Keeps, second: &Keeps) -> Series {
        let mut motion = vec![Point::<Ball>::zero(); TERMS];
        let (g, h) = (first.gradient(), second.gradient());
        let determinant = g.re() * h.im() - g.im() * h.re();
        for n in 1..TERMS {
            let (x, y) = (-&first.along(&motion)[n], -&second.along(&motion)[n]);
            motion[n] = Number::complex(
                (&x * h.im() - &y * g.im()) / &determinant,
                (&y * g.re() - &x * h.re()) / &determinant,
            );
        }
        motion
    }

    fn crank(linkage: &SliderCrank<Ball>) -> Keeps {
        // The center is given by k; Euler and Savary give the pin, with the diameter 1.
        let (sin, k) = (linkage.alpha_a.sin(), &linkage.k);
        let center = linkage.alpha_a.cis().scaled(&(k * &sin));
        let curvature = (k * &sin).inverse() + sin.inverse();
        if (k + 1).is_zero().is_yes() {
            return Keeps::LineInCoupler {
                center,
                normal: linkage.alpha_a.cis(),
            };
        }
        Keeps::Distance {
            point: linkage.alpha_a.cis().scaled(&curvature.inverse()),
            center,
        }
    }

    fn slider(linkage: &SliderCrank<Ball>) -> Keeps {
        // The inflection circle has the diameter from the pole to i.
        let normal = linkage.alpha_d.cis();
        Keeps::Line {
            point: normal.scaled(&linkage.alpha_d.sin()),
            normal,
        }
    }

    /// All that is known of it is very close to zero.
    fn vanishes(x: &Number<Ball>) -> bool {
        let bound = Rational::from((1, 10u64.pow(18)));
        let bound = Rational::from(bound.square_ref()) * bound;
        x.0.contains(&Rational::new())
            && x.0.lower().is_some_and(|low| low > Rational::from(-&bound))
            && x.0.upper().is_some_and(|high| high < bound)
    }

    /// Which of the coefficients of θ¹ … θ⁴ do not vanish, of the point's distance from its center.
    fn deviations(pair: &Pair<Ball>, motion: &Series) -> Vec<usize> {
        let kept = Keeps::of(&pair.ray.cis(), &pair.point, &pair.center).along(motion);
        (1..TERMS).filter(|&n| !vanishes(&kept[n])).collect()
    }

    fn check(what: &str, linkage: &SliderCrank<Ball>) -> Option<[Pair<Ball>; 2]> {
        let motion = motion(&crank(linkage), &slider(linkage));
        assert!(
            vanishes(motion[1].re()) && vanishes(motion[1].im()),
            "{what}: the pole"
        );
        let half: Point<Ball> = Number::complex(Number::zero(), exactly((1, 2)));
        let off = &motion[2] - half;
        assert!(
            vanishes(off.re()) && vanishes(off.im()),
            "{what}: the inflection circle"
        );
        let pairs = match linkage.alternates() {
            Alternates::Real(pairs) => *pairs,
            Alternates::Complex(_) => return None,
            other => panic!("{what}: {other:?} at {BITS} bits"),
        };
        for (name, pair) in ["B", "C"].iter().zip(&pairs) {
            let found = deviations(pair, &motion);
            // The test itself can fail: a point a little further out is none.
            let wrong = Pair {
                point: Quotient {
                    numerator: &pair.point.numerator + exactly((1, 1_000_000)),
                    denominator: pair.point.denominator.clone(),
                },
                ..pair.clone()
            };
            if pair.point.numerator.is_zero().is_yes() {
                continue;
            }
            assert!(
                found.is_empty(),
                "{what}: {name} fails in θ^{found:?}; {pair:?}"
            );
            if pair.point.denominator.is_zero().is_no() {
                assert!(
                    !deviations(&wrong, &motion).is_empty(),
                    "{what}: {name} moved"
                );
            }
        }
        Some(pairs)
    }

    fn linkage(
        k: impl Into<Rational>,
        alpha_a: Angle<Ball>,
        alpha_d: Angle<Ball>,
    ) -> SliderCrank<Ball> {
        SliderCrank {
            k: exactly(k),
            alpha_a,
            alpha_d,
        }
    }

    fn degrees(d: impl Into<Rational>) -> Angle<Ball> {
        Angle::from_degrees(&d.into(), &BITS).unwrap()
    }

    #[test]
    fn the_printed_example() {
        let example = linkage((9, 10), degrees((145, 2)), degrees(45));
        assert!(
            check("k = 0.9, 72.5°, 45°", &example).is_some(),
            "B and C are real"
        );
    }

    #[test]
    fn random_examples() {
        let mut real = 0;
        for seed in 0..60 {
            let mut random = Random::new(seed);
            let mut draw = || {
                let number: Number<Exact> = random.number("x").unwrap();
                number.0.rational().unwrap().clone()
            };
            let (k, a, d) = (draw(), draw(), draw());
            let what = format!("k = {k}, tan α_a/2 = {a}, tan α_d/2 = {d}");
            let [a, d] = [a, d].map(|t| Angle::from_tan_half(&exactly(t)));
            real += usize::from(check(&what, &linkage(k, a, d)).is_some());
        }
        assert!(real >= 15, "only {real} of 60 have real points");
    }

    #[test]
    fn special_examples() {
        for k in [
            (1, 1),
            (-1, 1),
            (-2, 1),
            (-3, 1),
            (-4, 1),
            (1, 2),
            (9, 10),
            (-7, 3),
        ] {
            let k = Rational::from(k);
            for (a, d) in [
                (60, 90),
                (45, 90),
                (110, 90),
                (72, 45),
                (30, 135),
                (135, 20),
                (100, 100 + 45),
            ] {
                let what = format!("k = {k}, {a}°, {d}°");
                let _ = check(&what, &linkage(k.clone(), degrees(a), degrees(d)));
            }
        }
    }

    #[test]
    fn the_slider_pin_at_the_inflection_pole() {
        for k in [1, 2, 5, -1, -3, -4, -5] {
            let what = format!("k = {k}, 60°, 90°");
            assert!(
                check(&what, &linkage(k, degrees(60), degrees(90))).is_some(),
                "{what}"
            );
        }
    }

    /// One of the four points is then the pole itself: its path has a cusp, a(θ) = iθ²/2 + …, and keeps to a
    /// circle about a point of the pole tangent to terms in θ⁴.
    #[test]
    fn the_crank_pin_on_the_pole_normal() {
        for k in [2, 3, -1, -3, -4] {
            for d in [30, 45, 120] {
                let what = format!("k = {k}, 90°, {d}°");
                let linkage = linkage(k, degrees(90), degrees(d));
                let pairs = check(&what, &linkage).unwrap();
                let motion = motion(&crank(&linkage), &slider(&linkage));
                let poles = pairs
                    .iter()
                    .filter(|pair| pair.point.numerator.is_zero().is_yes());
                let poles: Vec<_> = poles.collect();
                assert_eq!(poles.len(), 1, "{what}: one point is the pole");
                let none: [usize; 0] = [];
                assert_eq!(deviations(poles[0], &motion), none, "{what}: the pole");
                let mut elsewhere = poles[0].clone();
                elsewhere.center.numerator = elsewhere.center.numerator * 2;
                assert_eq!(
                    deviations(&elsewhere, &motion),
                    [4],
                    "{what}: another center"
                );
            }
        }
    }

    /// The points near that case tend to it.
    #[test]
    fn a_crank_pin_near_the_pole_normal() {
        for power in [3u32, 6, 9] {
            let near = Rational::from((1, 10u64.pow(power)));
            let alpha_a = Angle::from_tan_half(&exactly(Rational::from(1 - &near)));
            let what = format!("k = 2, 90° − 10^-{power}, 45°");
            let [b, c] = check(&what, &linkage(2, alpha_a, degrees(45))).unwrap();
            let smallest = [b, c].map(|pair| pair.point.value().abs().0.upper().unwrap());
            let closest = smallest.into_iter().min().unwrap();
            assert!(closest < near * 100, "{what}: {closest}");
        }
    }

    #[test]
    fn the_distances_of_the_linkage_itself() {
        let linkage = linkage((9, 10), degrees((145, 2)), degrees(45));
        let (sin, k) = (linkage.alpha_a.sin(), &linkage.k);
        let pa = linkage.pa().value();
        let savary = pa.inverse() - linkage.po_a().inverse() - sin.inverse();
        assert!(vanishes(&savary), "Euler and Savary for A");
        assert!(vanishes(&(linkage.po_a() - k * sin)));
        assert!(vanishes(&(linkage.pd().square() - exactly((1, 2)))));
        // a'''(0) = a₃ + i b₃ of the real motion, from which N = 3/b₃, M = 3/(a₃ + 3), R = 1/(a₃ + 2).
        let third = motion(&crank(&linkage), &slider(&linkage))[3].clone() * 6;
        assert!(vanishes(&(linkage.n().value() * third.im() - 3)), "N");
        assert!(vanishes(&(linkage.m().value() * (third.re() + 3) - 3)), "M");
        assert!(vanishes(&(linkage.r().value() * (third.re() + 2) - 1)), "R");
    }
}
