//! Polynomials in one variable: arithmetic over any kind, exact decisions and certified roots over
//! ℚ.
//!
//! [`Polynomial`] holds numbers of any kind. Over [`Exact`](super::Exact) it also knows its
//! greatest common divisors, square-free parts, resultants and Sturm sequences, and
//! [`isolate`] finds all its roots, real and complex, with multiplicities and proof.
//!
//! ```
//! use burmester::number::univariate::{Polynomial, isolate};
//! use burmester::number::Exact;
//! // (x − 1)² (x² + 1)
//! let p = Polynomial::<Exact>::from_integers(&[1, -2, 2, -2, 1]);
//! let roots = isolate(&p)?;
//! assert_eq!(roots.real().len(), 1);
//! assert_eq!(roots.real()[0].multiplicity(), 2);
//! assert_eq!(roots.complex().len(), 1); // i, with its conjugate
//! # Ok::<(), burmester::number::univariate::RootError>(())
//! ```

mod aberth;
mod chain;
mod complex_root;
mod descartes;
mod division;
mod enclose;
mod error;
mod exact;
mod factor;
mod floats;
mod integer;
mod interpolation;
mod isolate;
mod modular;
mod operators;
mod point;
mod polish;
mod polynomial;
mod proof;
mod quadratic;
mod radical;
mod real_root;
mod square_free;
mod sturm;
mod surds;

pub use complex_root::ComplexRoot;
pub use division::PseudoQuotient;
pub use enclose::{EnclosedRoots, enclose};
pub use error::RootError;
pub use floats::approximate_roots;
pub use isolate::{Roots, isolate, real_roots};
pub use polynomial::Polynomial;
pub use quadratic::{Quadratic, QuadraticRoots};
pub use radical::Radical;
pub use real_root::RealRoot;
pub use sturm::SturmSequence;
pub use surds::surds;
