//! The digression on linear equations.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

/// Coefficients and right sides.
pub(super) const THREE_EQUATIONS: [[i64; 3]; 3] = [[1, 1, 5], [1, -3, 1], [2, 2, 10]];

/// Coefficients and right sides.
pub(super) const EQUATIONS_IN_THREE_UNKNOWNS: [[i64; 4]; 3] =
    [[1, 1, -1, 2], [1, 1, 1, 3], [2, 2, 0, 5]];

pub const TWO: Scene = scene!(
    "kaufman/two-equations",
    "Two linear equations in two unknowns, by their coefficients.",
    build_two,
    [
        "a_11": "coefficient of X in the first equation",
        "a_12": "coefficient of Y in the first equation",
        "a_21": "coefficient of X in the second equation",
        "a_22": "coefficient of Y in the second equation",
        "b_1": "right side of the first equation",
        "b_2": "right side of the second equation",
    ]
);

pub const DEPENDENT: Scene = scene!(
    "kaufman/dependent-equations",
    "The solutions of 2 X - 3 Y = 5 and -10 X + 15 Y = -25: one of them, (1, -1), and any multiple of a \
     solution, (3, 2), of the equations with 0 on the right.",
    build_dependent,
    [
        "X": "first unknown",
        "Y": "second unknown",
    ]
);

pub const THREE: Scene = scene!(
    "kaufman/three-equations",
    "The solution of X + Y = 5, X - 3 Y = 1 and 2 X + 2 Y = 10.",
    build_three,
    [
        "X": "first unknown",
        "Y": "second unknown",
    ]
);

pub const THREE_UNKNOWNS: Scene = scene!(
    "kaufman/three-unknowns",
    "The solutions of X + Y - Z = 2, X + Y + Z = 3 and 2 X + 2 Y = 5: one of them, (5/2, 0, 1/2), and any \
     multiple of a solution, (1, -1, 0), of the equations with 0 on the right.",
    build_three_unknowns,
    [
        "X": "first unknown",
        "Y": "second unknown",
        "Z": "third unknown",
    ]
);

fn build_two<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let mut bindings = Bindings::new(free.precision());
    for name in ["a_11", "a_12", "a_21", "a_22", "b_1", "b_2"] {
        bindings.bind(name, free.number(name)?);
    }
    Ok(bindings)
}

fn build_dependent<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let multiple: Number<K> = free.number("multiple")?;
    let unknowns = [("X", 1 + 3 * &multiple), ("Y", 2 * multiple - 1)];
    solution(&[[2, -3, 5], [-10, 15, -25]], unknowns, free)
}

fn build_three<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    solution(&THREE_EQUATIONS, [("X", 4.into()), ("Y", 1.into())], free)
}

fn build_three_unknowns<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let multiple: Number<K> = free.number("multiple")?;
    let unknowns = [
        ("X", Number::ratio(5, 2) + &multiple),
        ("Y", -multiple),
        ("Z", Number::ratio(1, 2)),
    ];
    solution(&EQUATIONS_IN_THREE_UNKNOWNS, unknowns, free)
}

/// Binds unknowns that solve equations, each given by its coefficients and its right side.
fn solution<K: Real, const N: usize, const M: usize>(
    equations: &[[i64; M]],
    unknowns: [(&str, Number<K>); N],
    free: &mut dyn Free<K>,
) -> Result<Bindings<K>, Unbuilt> {
    for equation in equations {
        let terms = equation.iter().zip(&unknowns);
        let left: Number<K> = terms.map(|(coefficient, (_, x))| *coefficient * x).sum();
        let right = equation.last().copied().unwrap_or_default();
        Unbuilt::unless_true::<K>(left.equals(&right.into()), "an equation is not satisfied")?;
    }
    let mut bindings = Bindings::new(free.precision());
    for (name, value) in unknowns {
        bindings.bind(name, value);
    }
    Ok(bindings)
}
