//! The functions and predicates that formulas may call: one table for reader, evaluation, setting
//! and mutants.

/// A function of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    /// sine of an angle
    Sin,
    /// cosine of an angle
    Cos,
    /// tangent of an angle
    Tan,
    /// cotangent of an angle
    Cot,
    /// the angle with this sine (mod π up to the text's own choice)
    Arcsin,
    /// the angle with this cosine
    Arccos,
    /// the angle with this tangent, mod π
    Arctan,
    /// `e^(i γ)` of an angle γ
    Cis,
    /// the square root that is not negative
    Sqrt,
    /// |x|, of a number or a point
    Abs,
    /// −1, 0 or 1
    Sign,
    /// the smallest
    Min,
    /// the largest
    Max,
    /// real part of a point
    Re,
    /// imaginary part of a point
    Im,
    /// conjugate of a point
    Conj,
    /// the angle of a point seen from the origin
    Arg,
    /// `angle(A, B, C)`: the turn about B that carries the ray BA into the ray BC
    Angle,
    /// distance of two points
    Dist,
    /// the line through two points
    Line,
    /// where two lines meet, a point at infinity included
    Meet,
    /// all points on one line
    Collinear,
    /// all points on one circle (or line)
    Concyclic,
    /// two lines at right angles
    Perpendicular,
    /// two lines of one direction
    Parallel,
    /// `similar([A, B, …], [A', B', …])`: figures alike, with the same sense of turning
    Similar,
    /// determinant of a list of rows
    Det,
}

/// How many arguments a function takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arity {
    /// this many
    Exactly(usize),
    /// this many or more
    AtLeast(usize),
}

impl Arity {
    /// Whether a call with so many arguments is one.
    pub fn admits(self, count: usize) -> bool {
        match self {
            Arity::Exactly(number) => count == number,
            Arity::AtLeast(number) => count >= number,
        }
    }
}

/// What the language knows of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The canonical name.
    pub name: &'static str,
    /// Other names that papers print and the reader accepts.
    pub spellings: &'static [&'static str],
    /// How many arguments it takes.
    pub arity: Arity,
    /// What the arguments are.
    pub arguments: &'static str,
    /// What it gives.
    pub result: &'static str,
}

/// An entry of the table without other spellings.
const fn entry(
    name: &'static str,
    arity: Arity,
    arguments: &'static str,
    result: &'static str,
) -> Entry {
    Entry {
        name,
        spellings: &[],
        arity,
        arguments,
        result,
    }
}

impl Entry {
    /// The same entry with other spellings.
    const fn also(self, spellings: &'static [&'static str]) -> Entry {
        Entry { spellings, ..self }
    }
}

impl Function {
    /// Every function, in the order of the table.
    pub const ALL: [Function; 27] = [
        Function::Sin,
        Function::Cos,
        Function::Tan,
        Function::Cot,
        Function::Arcsin,
        Function::Arccos,
        Function::Arctan,
        Function::Cis,
        Function::Sqrt,
        Function::Abs,
        Function::Sign,
        Function::Min,
        Function::Max,
        Function::Re,
        Function::Im,
        Function::Conj,
        Function::Arg,
        Function::Angle,
        Function::Dist,
        Function::Line,
        Function::Meet,
        Function::Collinear,
        Function::Concyclic,
        Function::Perpendicular,
        Function::Parallel,
        Function::Similar,
        Function::Det,
    ];

    /// The row of the table. A match and not an array, so that the compiler misses no function.
    pub const fn entry(self) -> Entry {
        use Arity::{AtLeast, Exactly};
        match self {
            Function::Sin => entry("sin", Exactly(1), "angle", "number"),
            Function::Cos => entry("cos", Exactly(1), "angle", "number"),
            Function::Tan => entry("tan", Exactly(1), "angle", "number").also(&["tg"]),
            Function::Cot => entry("cot", Exactly(1), "angle", "number").also(&["ctg"]),
            Function::Arcsin => entry("arcsin", Exactly(1), "number", "angle"),
            Function::Arccos => entry("arccos", Exactly(1), "number", "angle"),
            Function::Arctan => entry("arctan", Exactly(1), "number", "angle mod π"),
            Function::Cis => entry("cis", Exactly(1), "angle", "point on the unit circle"),
            Function::Sqrt => entry("sqrt", Exactly(1), "number", "number, not negative"),
            Function::Abs => entry("abs", Exactly(1), "number or point", "number, not negative"),
            Function::Sign => {
                entry("sign", Exactly(1), "number", "number −1, 0 or 1").also(&["sgn"])
            }
            Function::Min => entry("min", AtLeast(1), "numbers, or a list or set", "number"),
            Function::Max => entry("max", AtLeast(1), "numbers, or a list or set", "number"),
            Function::Re => entry("re", Exactly(1), "point", "number"),
            Function::Im => entry("im", Exactly(1), "point", "number"),
            Function::Conj => entry("conj", Exactly(1), "point", "point"),
            Function::Arg => entry("arg", Exactly(1), "point", "angle mod 2π"),
            Function::Angle => entry(
                "angle",
                Exactly(3),
                "points; the second is the vertex",
                "angle mod 2π",
            ),
            Function::Dist => entry("dist", Exactly(2), "points", "number, not negative"),
            Function::Line => entry("line", Exactly(2), "different points", "line"),
            Function::Meet => entry("meet", Exactly(2), "lines", "point, finite or not"),
            Function::Collinear => entry("collinear", AtLeast(3), "points", "truth"),
            Function::Concyclic => entry("concyclic", AtLeast(4), "points", "truth"),
            Function::Perpendicular => entry("perpendicular", Exactly(2), "lines", "truth"),
            Function::Parallel => entry("parallel", Exactly(2), "lines", "truth"),
            Function::Similar => entry(
                "similar",
                Exactly(2),
                "lists of points in the same order",
                "truth",
            ),
            Function::Det => entry("det", Exactly(1), "list of rows, each a list", "number"),
        }
    }

    /// The canonical name.
    pub const fn name(self) -> &'static str {
        self.entry().name
    }

    /// How many arguments it takes.
    pub const fn arity(self) -> Arity {
        self.entry().arity
    }

    /// The function of this name or other spelling.
    pub fn named(name: &str) -> Option<Function> {
        Function::ALL.into_iter().find(|function| {
            let entry = function.entry();
            entry.name == name || entry.spellings.contains(&name)
        })
    }

    /// Whether it claims something instead of giving a value.
    pub const fn is_predicate(self) -> bool {
        matches!(
            self,
            Function::Collinear
                | Function::Concyclic
                | Function::Perpendicular
                | Function::Parallel
                | Function::Similar
        )
    }

    /// Whether the order of the arguments does not matter.
    pub const fn is_symmetric(self) -> bool {
        matches!(
            self,
            Function::Min
                | Function::Max
                | Function::Dist
                | Function::Line
                | Function::Meet
                | Function::Collinear
                | Function::Concyclic
                | Function::Perpendicular
                | Function::Parallel
        )
    }

    /// Whether papers print a whole product as its argument without parentheses: `sin 2 alpha`.
    pub(super) const fn is_trigonometric(self) -> bool {
        matches!(
            self,
            Function::Sin | Function::Cos | Function::Tan | Function::Cot
        )
    }
}
