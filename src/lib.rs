//! A certified reference for planar linkage kinematics.
//!
//! `burmester` holds what five classic sources say about planar linkages, decides every line of it,
//! and answers new problems with enclosures that are rigorous. This page is a tour, from the ground
//! up; each room of the library imports only what lies below it.
//!
//! # Numbers
//!
//! A theory function is written once, for any number kind, and reads like mathematics.
//!
//! ```
//! use burmester::number::{Exact, Ball, Kind, Number, Real};
//! use rug::Rational;
//!
//! /// Euler–Savary in units of the inflection circle's diameter: 1/PO = 1/PA − 1/sin α.
//! fn center<K: Kind>(pa: &Number<K>, sin_alpha: &Number<K>) -> Number<K> {
//!     1 / (1 / pa - 1 / sin_alpha)
//! }
//!
//! // Exactly:
//! let po = center::<Exact>(&Number::ratio(9, 19), &Number::ratio(24, 25));
//! assert_eq!(po.to_string(), "72/77");
//! // Enclosed, to 200 bits:
//! let ball = |n, d| Number::<Ball>::rounded(&Rational::from((n, d)), &200);
//! let po = center(&ball(9, 19), &ball(24, 25));
//! assert!(po.0.accuracy_bits() > Some(190));
//! ```
//!
//! The kinds: `f64`, [`Exact`](number::Exact) rationals, [`Surd`](number::Surd)s (sums of square
//! roots, decided exactly), [`Ball`](number::Ball)s (rigorous enclosures),
//! [`Fraction`](number::Fraction)s of polynomials with relations (identities for all values),
//! truncated power [`Series`](number::Series) and [`Complex`](number::Complex) numbers over any of them. A predicate answers yes, no or unknown
//! ([`Truth`](number::Truth)).
//!
//! # Formulas are data
//!
//! A line of a paper stands in `data/papers` as text. It is read once and evaluated in any kind;
//! with free symbols, that it holds is an identity.
//!
//! ```
//! use burmester::formula::{Bindings, evaluate, read};
//! use burmester::number::{Fraction, Ring};
//!
//! let ring = Ring::free(&["a", "b"]).ok_or("names clash")?;
//! let [a, b] = ring.numbers();
//! let mut symbols = Bindings::<Fraction>::new(());
//! symbols.bind("a", a);
//! symbols.bind("b", b);
//! let right = read("(a + b)^2 = a^2 + 2 a b + b^2")?;
//! let wrong = read("(a + b)^2 = a^2 + a b + b^2")?;
//! assert!(evaluate(&right, &symbols)?.holds.is_yes());
//! // Not for all values; whether for some is another question.
//! assert!(!evaluate(&wrong, &symbols)?.holds.is_yes());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The [grammar](formula) has an example of every construct.
//!
//! # Theory, scenes and verdicts
//!
//! [`plane`], [`finite`], [`linkage`], [`curvature`] and [`straight_line`] hold geometry and theory,
//! derived from first principles and knowing no paper. [`scenes`] are the only place where a paper's symbols meet quantities of
//! the theory. The [`ledger`] puts statement and scene together and finds the verdict:
//!
//! ```
//! use burmester::ledger::{self, Judge, Options, Verdict};
//!
//! let papers = ledger::built_in()?;
//! let line = papers
//!     .iter()
//!     .flat_map(|paper| &paper.statements)
//!     .find(|statement| statement.id == "wunderlich1968/eq/1.8-s")
//!     .ok_or("no such line")?;
//! let mut judge = Judge::new(Options { digits: 30, mutants: false });
//! let judgement = judge.judge(line)?;
//! assert_eq!(judgement.verdict, Verdict::Fails);
//! assert_eq!(judgement.corrected.as_deref(), Some("s = m p d/(m p + n q)"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A quantity has several routes that share nothing: here the curve of all centers of four
//! positions, from the circle conditions and from the loop closure, with its type decided without
//! any root.
//!
//! ```
//! use burmester::finite::four_positions::{circle_conditions, loop_closure};
//! use burmester::number::{Exact, Number};
//! use burmester::plane::curve_type::{CurveType, curve_type};
//! use burmester::plane::displacement::Displacement;
//! use burmester::plane::{Angle, Point};
//!
//! // x, y and the tangent of half of the angle.
//! let four = [(0, 0, 0), (3, 1, 1), (5, -1, -2), (2, 4, 3)].map(|(x, y, t)| {
//!     let translation: Point<Exact> = Number::complex(x.into(), y.into());
//!     let rotation = Angle::from_tan_half(&Number::from(t)).cis();
//!     Displacement { rotation, translation }
//! });
//! let curve = circle_conditions::centerpoint_cubic(&four).ok_or("no cubic")?;
//! let other = loop_closure::centerpoint_cubic(&four).ok_or("no cubic")?;
//! let ratio = &other.coefficients()[0] / &curve.coefficients()[0];
//! for (a, b) in curve.coefficients().iter().zip(other.coefficients()) {
//!     assert!(b.equals(&(a * &ratio)).is_yes());
//! }
//! assert_eq!(curve_type(&curve), Some(CurveType::TwoBranches));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A four-bar of which a point goes nearly straight, and how nearly: by its own closure, not by the
//! formulas that it was made with.
//!
//! ```
//! use burmester::number::{Exact, Number};
//! use burmester::straight_line::symmetric::Symmetric;
//!
//! // Roberts: base 4, coupler 2, cranks √10, the point 3 below the coupler.
//! let [a, c, d] = [2, 3, 3].map(Number::<Exact>::from);
//! let design = Symmetric { a, c, d }.design()?;
//! let contact = design.contact(6).ok_or("a change point")?;
//! assert_eq!((contact.least, contact.most), (1, Some(1)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # New problems
//!
//! The [`oracle`] takes a problem as JSON and gives the certified answer:
//!
//! ```
//! use burmester::oracle::{self, Request};
//! use serde_json::json;
//!
//! let answer = oracle::solve(
//!     &json!({
//!         "problem": "slider-crank-alternates",
//!         "k": "1/2",
//!         "alpha_a": {"tan_half": "3/4"},
//!         "alpha_d": {"cos": "3/5", "sin": "4/5"},
//!     }),
//!     &Request::default(),
//! )?;
//! assert_eq!(answer["PO_a"], json!({"exact": "12/25"}));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Testing other programs
//!
//! As a development dependency, [`testing`] compares what a solver in `f64` finds with the certified
//! answer: what it missed, what it invented, and how far the rest is off, in units in the last place and
//! beside what rounding the problem may cost. `examples/check_a_solver.rs` shows what that says of a
//! solver that is wrong.

pub mod curvature;
pub mod finite;
pub mod formula;
pub mod ledger;
pub mod linkage;
pub mod number;
pub mod oracle;
pub mod plane;
pub mod report;
pub mod scenes;
pub mod straight_line;
pub mod testing;

/// The commands and the code of the README, of which the code is run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
