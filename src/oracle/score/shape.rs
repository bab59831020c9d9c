//! The shapes that parts of answers have, and what answers to every kind of problem consist of. A new
//! kind of problem is added here and nowhere else.

use Shape::{Angle, ComplexPoint, Each, Fact, Fields, Length, Point, Ray, Remark, Set, UpToFactor};

/// What a part of an answer is, and so how it is compared.
#[derive(Debug)]
pub enum Shape {
    /// A number, or that it is infinite or not determined.
    Length,
    /// An angle, modulo 360°.
    Angle,
    /// An angle, a complex tangent, or that it is not determined.
    Ray,
    /// A point: finite, at infinity, or not determined.
    Point,
    /// A finite point with complex coordinates.
    ComplexPoint,
    /// Numbers up to a common factor: directions, coefficients of curves.
    UpToFactor,
    /// A word, a count or a truth, right or wrong. Listed are the ordinary ones: any other makes a
    /// degenerate case; with an empty list none does.
    Fact(&'static [&'static str]),
    /// Of a member of a set, a fact that does not tell which one it is.
    Remark,
    /// Members with names or with places in a list.
    Each(&'static Shape),
    /// Members without an order.
    Set {
        /// What each consists of.
        member: &'static [(&'static str, Shape)],
        /// Whether a candidate that says nothing of it has missed its members.
        required: bool,
        /// Whether a member makes a degenerate case.
        degenerate: bool,
    },
    /// Parts by their names.
    Fields(&'static [(&'static str, Shape)]),
}

const ANY: Shape = Fact(&[]);

/// The parts of an answer to a problem of this kind that are scored.
pub fn of(problem: &str) -> Option<&'static Shape> {
    Some(match problem {
        "five-positions" | "mixed-positions" => &FIVE_POSITIONS,
        "centerpoint-curve" => &CENTERPOINT_CURVE,
        "curvature" => &CURVATURE,
        "poles" => &POLES,
        "three-positions" => &THREE_POSITIONS,
        "slider-crank-alternates" => &SLIDER_CRANK_ALTERNATES,
        "focal-mechanism" => &FOCAL_MECHANISM,
        "hart" => &HART,
        _ => return None,
    })
}

const fn pairs(required: bool) -> Shape {
    Set {
        member: &[("circlepoint", Point), ("center", Point)],
        required,
        degenerate: false,
    }
}

const COMPLEX_PAIRS: Shape = Set {
    member: &[("circlepoint", ComplexPoint), ("center", ComplexPoint)],
    required: false,
    degenerate: false,
};

const AT_INFINITY: Shape = Set {
    member: &[
        ("kind", ANY),
        ("circlepoint", Point),
        ("center", Point),
        ("direction", UpToFactor),
    ],
    required: false,
    degenerate: true,
};

const COUNTS: Shape = Fields(&[("real", ANY), ("complex", ANY), ("at_infinity", ANY)]);

const FAMILY: Shape = Fields(&[
    ("kind", Fact(&["none"])),
    ("coefficients", UpToFactor),
    ("circlepoint", Point),
    ("center", Point),
    ("centers", UpToFactor),
]);

const FIVE_POSITIONS: Shape = Fields(&[
    ("pairs", pairs(true)),
    ("complex_pairs", COMPLEX_PAIRS),
    ("at_infinity", AT_INFINITY),
    ("family", FAMILY),
    ("counts", COUNTS),
]);

const CURVATURE: Shape = Fields(&[
    ("pole", Point),
    ("inflection_circle", UpToFactor),
    ("inflection_pole", Point),
    ("ball_point", Point),
    ("ball_burmester", Fact(&["none"])),
    ("circlepoint", CURVE),
    ("centerpoint", CURVE),
    ("pairs", pairs(false)),
    ("complex_pairs", COMPLEX_PAIRS),
    ("at_infinity", AT_INFINITY),
    ("family", FAMILY),
    ("counts", COUNTS),
]);

const CURVE: Shape = Fields(&[
    ("coefficients", UpToFactor),
    ("type", Fact(&["one-branch", "two-branches"])),
    (
        "nodes",
        Set {
            member: &[("point", Point)],
            required: false,
            degenerate: true,
        },
    ),
    ("focus", Point),
    ("asymptote", UpToFactor),
    ("midline", UpToFactor),
]);

const CENTERPOINT_CURVE: Shape = Fields(&[
    ("poles", Each(&Point)),
    ("image_poles", Each(&Point)),
    ("centerpoint", CURVE),
    ("circlepoint", CURVE),
    (
        "quadrilaterals",
        Each(&Fields(&[
            ("shape", ANY),
            ("sides", Each(&Length)),
            ("u_vs_z", ANY),
            ("shortest_and_longest", ANY),
        ])),
    ),
]);

const POLES: Shape = Fields(&[
    ("poles", Each(&Point)),
    ("image_poles", Each(&Point)),
    ("turns", Each(&Angle)),
]);

const CIRCLE: Shape = Fields(&[
    ("coefficients", UpToFactor),
    ("center", Point),
    ("radius", Length),
]);

const THREE_POSITIONS: Shape = Fields(&[
    ("poles", Each(&Point)),
    ("image_poles", Each(&Point)),
    ("centers_of_lines", CIRCLE),
    ("points_on_lines", CIRCLE),
    (
        "pairs",
        Each(&Fields(&[
            ("circlepoint", Point),
            ("center", Point),
            ("radius", Length),
        ])),
    ),
]);

const SLIDER_CRANK_ALTERNATES: Shape = Fields(&[
    ("PD", Length),
    ("PO_a", Length),
    ("PA", Length),
    ("N", Length),
    ("M", Length),
    ("R", Length),
    ("PB", Length),
    ("PC", Length),
    ("PO_b", Length),
    ("PO_c", Length),
    ("alpha_b", Ray),
    ("alpha_c", Ray),
]);

const FOCAL_MECHANISM: Shape = Fields(&[
    ("count", ANY),
    (
        "mechanisms",
        Set {
            member: &[
                ("lambda", Length),
                ("m", Length),
                ("n", Length),
                ("p", Length),
                ("q", Length),
                ("MS", Length),
                ("AT", Length),
                ("r", Length),
                ("t", Length),
                ("crank", Remark),
            ],
            required: false,
            degenerate: false,
        },
    ),
]);

const HART: Shape = Fields(&[
    ("m", Length),
    ("p", Length),
    ("q", Length),
    ("n", Length),
    ("a", Length),
    ("b", Length),
    ("c", Length),
    ("d", Length),
    ("x", Length),
    ("line", UpToFactor),
]);
