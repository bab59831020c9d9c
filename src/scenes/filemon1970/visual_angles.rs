//! Figure 1: circles from which opposite sides of a pole quadrilateral are seen under one angle.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::circle::Circle;
use crate::plane::{Angle, Point, line};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const RIGHT_ANGLES: Scene = scene!(
    "filemon1970/right-angles",
    "Two lines through O, one of them the x-axis, and on each a segment that is seen from a point \
     (x, y) under a right angle: the nearer ends are free, the farther ones follow.",
    build_right_angles,
    [
        "x": "abscissa of the point",
        "y": "ordinate of the point",
        "phi": "angle of the second line with the x-axis",
        "a": "distance from O to the first end of the segment on the x-axis, directed",
        "r": "from there to the other end, directed",
        "b": "distance from O to the first end of the segment on the second line, directed",
        "R": "from there to the other end, directed",
    ]
);

pub const SCENE: Scene = scene!(
    "filemon1970/visual-angles",
    "Two lines through O, one of them the x-axis, and on each a segment that is seen from a point \
     (x, y) under one angle gamma mod pi. The point, the angle and the first ends are free, the \
     other ends follow. G_1 and G_2 are the circles through the ends and the point, g_1 and g_2 \
     those with the segments as diameters; all equations have 1 before x^2 + y^2. Distances along \
     the second line are positive in the direction phi, distances from a line positive to its \
     right.",
    build,
    [
        "x": "abscissa of the point",
        "y": "ordinate of the point",
        "phi": "angle of the second line with the x-axis",
        "a": "distance from O to the first end of the segment on the x-axis, directed",
        "r": "from there to the other end, directed",
        "b": "distance from O to the first end of the segment on the second line, directed",
        "R": "from there to the other end, directed",
        "gamma": "the turn that carries the ray to the other end into the ray to the first end, \
                  mod pi the same for both segments",
        "n_1": "distance of the center of G_1 from the x-axis, positive to the right, where y < 0",
        "n_2": "distance of the center of G_2 from the second line, positive to the right",
        "g_1": "left side of the equation of the circle g_1 at the point",
        "g_2": "left side of the equation of the circle g_2 at the point",
        "G_1": "left side of the equation of the circle G_1 at the point",
        "G_2": "left side of the equation of the circle G_2 at the point",
        "lambda_1": "coefficient of y in the equation of G_1 less that of g_1",
        "lambda_2": "coefficient of x in the equation of G_2 less that of g_2",
        "lambda_2'": "coefficient of y in the equation of G_2 less that of g_2",
    ]
);

/// A segment on a line through O, seen in a frame in which the line is the x-axis.
struct Segment<K> {
    /// Unit vector of the line.
    along: Point<K>,
    /// The point that sees the segment, in the frame of the line.
    point: Point<K>,
    /// From O to the first end.
    start: Number<K>,
    /// From there to the other end.
    length: Number<K>,
}

impl<K: Real> Segment<K> {
    /// The segment from `start` on whose ends are seen from a point under a given turn, from the
    /// other end to the first.
    fn seen(point: &Point<K>, along: Point<K>, start: Number<K>, turn: &Angle<K>) -> Self {
        let point = point * along.conj();
        let first = Point::from(start.clone()) - &point;
        let toward = &point + first * turn.direction().conj();
        let end = line::meet(&point, &toward, &Number::zero(), &Number::one());
        Segment {
            length: end.re() - &start,
            along,
            point,
            start,
        }
    }

    fn ends(&self) -> [Point<K>; 2] {
        [self.start.clone(), &self.start + &self.length].map(Point::from)
    }

    /// The circle with the segment as diameter.
    fn circle_on_diameter(&self) -> Circle<K> {
        let [first, end] = self.ends();
        let center = (&first + end) / 2;
        Circle::about(&center, &(first - &center).norm())
    }

    /// The circle through the ends and the point.
    fn circle_through_point(&self) -> Circle<K> {
        let [first, end] = self.ends();
        Circle::through(&first, &end, &self.point)
    }

    /// The distance of the center of the latter from the line, positive to its right.
    fn center_to_the_right(&self) -> Number<K> {
        -self.circle_through_point().center().im()
    }

    /// The left sides of both equations at the point.
    fn values(&self) -> [Number<K>; 2] {
        [self.circle_on_diameter(), self.circle_through_point()]
            .map(|circle| circle.power(&self.point))
    }

    /// The coefficients of x and y, as a vector, in the equation of the circle through the point
    /// less that of the circle on the diameter, outside of the frame.
    fn linear_difference(&self) -> Point<K> {
        let [on_diameter, through] = [self.circle_on_diameter(), self.circle_through_point()]
            .map(|Circle { a, b, c, .. }| Number::complex(b / &a, c / &a));
        (through - on_diameter) * &self.along
    }
}

struct Figure<K> {
    point: Point<K>,
    phi: Angle<K>,
    first: Segment<K>,
    second: Segment<K>,
}

impl<K: Real> Figure<K> {
    fn free(free: &mut dyn Free<K>, gamma: &Angle<K>) -> Result<Self, Unbuilt> {
        let point = point(free, "the point")?;
        let phi = free.angle("phi")?;
        let first = Segment::seen(&point, Number::one(), free.number("a")?, gamma);
        let second = Segment::seen(&point, phi.cis(), free.number("b")?, gamma);
        Ok(Figure {
            point,
            phi,
            first,
            second,
        })
    }

    fn bind(&self, bindings: &mut Bindings<K>) {
        bindings.bind("x", self.point.re().clone());
        bindings.bind("y", self.point.im().clone());
        bindings.bind("phi", self.phi.clone());
        bindings.bind("a", self.first.start.clone());
        bindings.bind("r", self.first.length.clone());
        bindings.bind("b", self.second.start.clone());
        bindings.bind("R", self.second.length.clone());
    }
}

fn build_right_angles<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let right = Angle::from_cos_sin(Number::zero(), Number::one());
    let mut bindings = Bindings::new(free.precision());
    Figure::free(free, &right)?.bind(&mut bindings);
    Ok(bindings)
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    // The turn matters modulo π only.
    let gamma = Angle::of(Number::complex(free.number("cot gamma")?, Number::one()));
    let figure = Figure::free(free, &gamma)?;
    let mut bindings = Bindings::new(free.precision());
    figure.bind(&mut bindings);
    bindings.bind("gamma", gamma);
    for (segment, i) in [(&figure.first, 1), (&figure.second, 2)] {
        let [on_diameter, through] = segment.values();
        bindings.bind(&format!("g_{i}"), on_diameter);
        bindings.bind(&format!("G_{i}"), through);
        bindings.bind(&format!("n_{i}"), segment.center_to_the_right());
    }
    let difference = figure.first.linear_difference();
    bindings.bind("lambda_1", difference.im().clone());
    let difference = figure.second.linear_difference();
    bindings.bind("lambda_2", difference.re().clone());
    bindings.bind("lambda_2'", difference.im().clone());
    Ok(bindings)
}
