//! Conics by their points and by their tangents.

use std::cmp::Ordering;

use super::Point;
use super::projective::{Line, ProjectivePoint};
use crate::number::{Complex, Kind, Number, Real, Truth, array};

/// A quadratic form a x² + b xy + c y² + d xw + e yw + f w², as [a, b, c, d, e, f].
type Form<K> = [Number<K>; 6];

fn value<K: Kind>([a, b, c, d, e, f]: &Form<K>, [x, y, w]: &[Number<K>; 3]) -> Number<K> {
    (a * x + b * y + d * w) * x + (c * y + e * w) * y + f * w.square()
}

/// The partial derivatives of the form.
fn gradient<K: Kind>([a, b, c, d, e, f]: &Form<K>, [x, y, w]: &[Number<K>; 3]) -> [Number<K>; 3] {
    [
        2 * a * x + b * y + d * w,
        b * x + 2 * c * y + e * w,
        d * x + e * y + 2 * f * w,
    ]
}

/// The form of the adjugate of twice the matrix.
fn adjugate<K: Kind>([a, b, c, d, e, f]: &Form<K>) -> Form<K> {
    [
        4 * c * f - e.square(),
        2 * (d * e - 2 * b * f),
        4 * a * f - d.square(),
        2 * (b * e - 2 * c * d),
        2 * (b * d - 2 * a * e),
        4 * a * c - b.square(),
    ]
}

/// Half the determinant of twice the matrix.
fn determinant<K: Kind>([a, b, c, d, e, f]: &Form<K>) -> Number<K> {
    4 * a * c * f + b * d * e - a * e.square() - c * d.square() - f * b.square()
}

/// The product of two linear forms.
fn product<K: Kind>([a, b, c]: &[Number<K>; 3], [x, y, z]: &[Number<K>; 3]) -> Form<K> {
    [
        a * x,
        a * y + b * x,
        b * y,
        a * z + c * x,
        b * z + c * y,
        c * z,
    ]
}

fn combined<K: Kind>(s: &Number<K>, form: &Form<K>, t: &Number<K>, other: &Form<K>) -> Form<K> {
    array::pairs(form, other).map(|(a, b)| s * a + t * b)
}

fn all_zero<K: Kind>(form: &Form<K>) -> Truth {
    Truth::all(form.iter().map(Number::is_zero))
}

/// The conic a x² + b xy + c y² + d x + e y + f = 0, up to a common factor. It may consist of two
/// lines (real or not, the line at infinity among them); where all coefficients vanish it is none.
#[derive(Clone, Debug)]
pub struct Conic<K>(Form<K>);

/// What a conic of real points is, where it does not consist of lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ConicType {
    /// An ellipse or circle with real points.
    Ellipse,
    /// An ellipse of the real equation without real points, as x² + y² + 1 = 0.
    ImaginaryEllipse,
    /// A parabola: the line at infinity touches.
    Parabola,
    /// A hyperbola: two real points at infinity.
    Hyperbola,
    /// Two lines or one line twice.
    Degenerate,
}

impl<K: Kind> Conic<K> {
    /// The conic of the coefficients [a, b, c, d, e, f].
    pub fn new(coefficients: [Number<K>; 6]) -> Self {
        Conic(coefficients)
    }

    /// The pair of two lines.
    pub fn line_pair(line: &Line<K>, other: &Line<K>) -> Self {
        Conic(product(line.coefficients(), other.coefficients()))
    }

    /// The conic through five points; not determined where four of them are on a line or two
    /// coincide.
    pub fn through([p, q, r, s, t]: &[ProjectivePoint<K>; 5]) -> Self {
        // In the pencil of the conics through the first four, two pairs of lines are known.
        let first = Self::line_pair(&Line::through(p, q), &Line::through(r, s));
        let second = Self::line_pair(&Line::through(p, r), &Line::through(q, s));
        Conic(combined(&second.at(t), &first.0, &-first.at(t), &second.0))
    }

    /// [a, b, c, d, e, f].
    pub fn coefficients(&self) -> &[Number<K>; 6] {
        &self.0
    }

    /// Whether not all coefficients vanish.
    pub fn is_determined(&self) -> Truth {
        !all_zero(&self.0)
    }

    /// The quadratic form at the coordinates of a point, zero on the conic.
    pub fn at(&self, point: &ProjectivePoint<K>) -> Number<K> {
        value(&self.0, point.coordinates())
    }

    /// Whether a point lies on the conic; unknown where either is not determined.
    pub fn contains(&self, point: &ProjectivePoint<K>) -> Truth {
        incidence(
            self.is_determined() & point.is_determined(),
            &self.at(point),
        )
    }

    /// The polar of a point, for a point of the conic its tangent there; not determined where the
    /// point is a double point.
    pub fn polar(&self, point: &ProjectivePoint<K>) -> Line<K> {
        let [a, b, c] = gradient(&self.0, point.coordinates());
        Line::new(a, b, c)
    }

    /// The conic of the tangents, the adjugate of the matrix; of two lines, the point where they
    /// meet, twice; not determined for one line twice.
    pub fn dual(&self) -> DualConic<K> {
        DualConic(adjugate(&self.0))
    }

    /// The pole of the line at infinity, [be − 2cd : bd − 2ae : 4ac − b²]: at infinity for a
    /// parabola.
    pub fn center(&self) -> ProjectivePoint<K> {
        let [.., d, e, f] = adjugate(&self.0);
        ProjectivePoint::new(d, e, 2 * f)
    }

    /// 4acf + bde − ae² − cd² − fb², zero where the conic consists of lines.
    pub fn determinant(&self) -> Number<K> {
        determinant(&self.0)
    }

    /// b² − 4ac: the sign tells how many points at infinity are real.
    pub fn discriminant(&self) -> Number<K> {
        let [a, b, c, ..] = &self.0;
        b.square() - 4 * a * c
    }

    /// Whether the conic consists of lines.
    pub fn is_degenerate(&self) -> Truth {
        incidence(self.is_determined(), &self.determinant())
    }

    /// Whether the conic is a circle that does not degenerate: a = c and b = 0.
    pub fn is_circle(&self) -> Truth {
        let [a, b, c, ..] = &self.0;
        !self.is_degenerate() & b.is_zero() & a.equals(c)
    }

    /// Whether the conic is a parabola: it does not degenerate, and b² = 4ac.
    pub fn is_parabola(&self) -> Truth {
        !self.is_degenerate() & self.discriminant().is_zero()
    }
}

fn incidence<K: Kind>(determined: Truth, value: &Number<K>) -> Truth {
    match (determined, value.is_zero()) {
        (Truth::Yes, zero) => zero,
        (_, Truth::No) => Truth::No,
        _ => Truth::Unknown,
    }
}

impl<K: Real> Conic<K> {
    /// Whether the conic is a hyperbola: it does not degenerate, and b² > 4ac.
    pub fn is_hyperbola(&self) -> Truth {
        !self.is_degenerate() & self.discriminant().is_positive()
    }

    /// Whether the conic is an ellipse with real points: b² < 4ac, and the determinant and a + c
    /// differ in sign.
    pub fn is_ellipse(&self) -> Truth {
        let [a, _, c, ..] = &self.0;
        let real = (-(a + c) * self.determinant()).is_positive();
        (-self.discriminant()).is_positive() & real
    }

    /// What the conic is; `None` where that cannot be told.
    pub fn conic_type(&self) -> Option<ConicType> {
        match self.is_degenerate() {
            Truth::Yes => return Some(ConicType::Degenerate),
            Truth::Unknown => return None,
            Truth::No => {}
        }
        match (self.discriminant().sign()?, self.is_ellipse()) {
            (Ordering::Greater, _) => Some(ConicType::Hyperbola),
            (Ordering::Equal, _) => Some(ConicType::Parabola),
            (Ordering::Less, Truth::Yes) => Some(ConicType::Ellipse),
            (Ordering::Less, Truth::No) => Some(ConicType::ImaginaryEllipse),
            (Ordering::Less, Truth::Unknown) => None,
        }
    }
}

/// The lines ux + vy + w = 0 with A u² + B uv + C v² + D uw + E vw + F w² = 0, up to a common
/// factor: the tangents of a conic, or the lines through either of two points.
#[derive(Clone, Debug)]
pub struct DualConic<K>(Form<K>);

impl<K: Kind> DualConic<K> {
    /// The dual conic of the coefficients [A, B, C, D, E, F].
    pub fn new(coefficients: [Number<K>; 6]) -> Self {
        DualConic(coefficients)
    }

    /// The lines through either of two points.
    pub fn point_pair(point: &ProjectivePoint<K>, other: &ProjectivePoint<K>) -> Self {
        DualConic(product(point.coordinates(), other.coordinates()))
    }

    /// The conic with these foci, whose tangents have distances from them of this product, positive
    /// for foci on one side of the tangents: the squared minor axis of an ellipse, the negative one
    /// of a hyperbola.
    pub fn with_foci(focus: &Point<K>, other: &Point<K>, distances: &Number<K>) -> Self {
        let points = [focus, other].map(ProjectivePoint::from_finite);
        let mut form = product(points[0].coordinates(), points[1].coordinates());
        form[0] -= distances;
        form[2] -= distances;
        DualConic(form)
    }

    /// The conic that touches five lines; not determined where four of them go through a point or
    /// two coincide.
    pub fn touching([k, l, m, n, o]: &[Line<K>; 5]) -> Self {
        let range = Range::touching([k, l, m, n]);
        range.member(&range.second.at(o), &-range.first.at(o))
    }

    /// [A, B, C, D, E, F].
    pub fn coefficients(&self) -> &[Number<K>; 6] {
        &self.0
    }

    /// Whether not all coefficients vanish.
    pub fn is_determined(&self) -> Truth {
        !all_zero(&self.0)
    }

    /// The quadratic form at the coefficients of a line, zero for a tangent.
    pub fn at(&self, line: &Line<K>) -> Number<K> {
        value(&self.0, line.coefficients())
    }

    /// Whether a line touches; unknown where either is not determined.
    pub fn touches(&self, line: &Line<K>) -> Truth {
        incidence(self.is_determined() & line.is_determined(), &self.at(line))
    }

    /// The point where a tangent touches; of any other line, the pole.
    pub fn pole(&self, line: &Line<K>) -> ProjectivePoint<K> {
        let [x, y, w] = gradient(&self.0, line.coefficients());
        ProjectivePoint::new(x, y, w)
    }

    /// The conic with these tangents; not determined where they go through one point, twice.
    pub fn conic(&self) -> Conic<K> {
        Conic(adjugate(&self.0))
    }

    /// [D : E : 2F], at infinity for a parabola.
    pub fn center(&self) -> ProjectivePoint<K> {
        self.pole(&Line::at_infinity())
    }

    /// F z² − (D + iE) z + A − C + iB: zero where the isotropic line through z touches, and with it
    /// the conjugate one, that is, exactly at the foci.
    pub fn focus_condition(&self, z: &Point<K>) -> Point<K> {
        let [constant, linear, square] = self.focus_coefficients();
        (square * z + linear) * z + constant
    }

    fn focus_coefficients(&self) -> [Number<Complex<K>>; 3] {
        let [a, b, c, d, e, f] = &self.0;
        [
            Number::complex(a - c, b.clone()),
            Number::complex(-d, -e),
            f.clone().into(),
        ]
    }
}

/// The real foci of a conic that does not degenerate.
#[derive(Clone, Debug)]
pub enum Foci<K> {
    /// Of an ellipse or hyperbola; equal for a circle.
    Two(Point<K>, Point<K>),
    /// Of a parabola; the other one is at infinity.
    One(Point<K>),
}

impl<K: Real> DualConic<K> {
    /// The roots of [`focus_condition`](Self::focus_condition), without value where the kind does not
    /// hold them; `None` where it cannot be told whether the conic is a parabola.
    pub fn foci(&self) -> Option<Foci<K>> {
        let [constant, linear, square] = self.focus_coefficients();
        match square.is_zero() {
            Truth::Unknown => None,
            Truth::Yes => Some(Foci::One(-constant / linear)),
            Truth::No => {
                let root = complex_sqrt(linear.square() - 4 * constant * &square);
                let double = 2 * square;
                let one = (&root - &linear) / &double;
                Some(Foci::Two(one, (-root - linear) / double))
            }
        }
    }
}

/// One of the roots of a complex number; no value where the kind does not hold it.
fn complex_sqrt<K: Real>(z: Point<K>) -> Point<K> {
    if z.is_zero().is_yes() {
        return z;
    }
    let length = z.norm().sqrt();
    // The part of the root that is not small is found first, the other one from the product.
    if z.re().sign() == Some(Ordering::Less) {
        let im = ((length - z.re()) / 2).sqrt();
        Number::complex(z.im() / (2 * &im), im)
    } else {
        let re = ((length + z.re()) / 2).sqrt();
        let im = z.im() / (2 * &re);
        Number::complex(re, im)
    }
}

/// The foci of a conic: F z² − (D + iE) z + A − C + iB in terms of its
/// [tangents](DualConic::focus_condition). Vanishes exactly where z is a focus.
pub fn focus_condition<K: Kind>(conic: &Conic<K>, z: &Point<K>) -> Point<K> {
    conic.dual().focus_condition(z)
}

/// The conics that touch four lines, a family linear in its dual conics.
#[derive(Clone, Debug)]
pub struct Range<K> {
    first: DualConic<K>,
    second: DualConic<K>,
}

impl<K: Kind> Range<K> {
    /// The conics that touch the lines k, l, m and n, different and no three of them through one
    /// point.
    pub fn touching([k, l, m, n]: [&Line<K>; 4]) -> Self {
        Range {
            first: DualConic::point_pair(&k.meet(l), &m.meet(n)),
            second: DualConic::point_pair(&k.meet(m), &l.meet(n)),
        }
    }

    /// λ times the pair of points kl, mn and μ times the pair km, ln.
    pub fn member(&self, lambda: &Number<K>, mu: &Number<K>) -> DualConic<K> {
        DualConic(combined(lambda, &self.first.0, mu, &self.second.0))
    }

    /// The member with a given focus; only points of the focal cubic of the lines are foci, and
    /// `None` is the answer where it is known that the point is none.
    pub fn member_with_focus(&self, focus: &Point<K>) -> Option<DualConic<K>> {
        let (s, t) = (
            self.first.focus_condition(focus),
            self.second.focus_condition(focus),
        );
        if (s.conj() * &t).im().is_zero().is_no() {
            return None;
        }
        // Both parts are proportional; the one that does not vanish tells the factors.
        if s.re().is_zero().is_yes() && t.re().is_zero().is_yes() {
            return Some(self.member(t.im(), &-s.im()));
        }
        Some(self.member(t.re(), &-s.re()))
    }
}
