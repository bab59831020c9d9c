//! The pairs of a problem without a branch, so that problems stand side by side in the lanes of the
//! processor; with a measure of what was found, by which it is accepted or not.
//!
//! 1. The conditions are four rows of seven numbers; Householder's reflections take them to a triangle,
//!    and the last three unit vectors back to an orthonormal basis of the solutions.
//! 2. In that basis hp = xX + yY and hq = yX − xY are two conics F, G. Where det(μF + G) = 0 the conic
//!    μF + G is two lines, which for one of the three μ at least are real: that μ is taken for which
//!    the sum of the principal minors, over the square of the norm, is least.
//! 3. Each of the lines meets the conic F − μG in two points: in its principal axes λ₁x² + λ₂y² = 0 has
//!    the solutions (√|λ₂|, ±√|λ₁|), real where λ₁λ₂ < 0, otherwise (√|λ₂|, ±i√|λ₁|).
//! 4. Two of Newton's steps for F = G = 0 at right angles to the point:
//!    δ = −½ ((f r − g p) × λ̄)/(λ̄ · (p × r)) with p = Fλ, r = Gλ, f = λ·p, g = λ·r. Two real points are
//!    computed with side by side, as one is with its imaginary part.
//!
//! Accepted are four points of which each has settled, is regular, has moved by less than what
//! separates it from all others, and is not near infinity.

/// Squares of the last step, by itself and against the determinant, that count as settled: what is
/// left is about its square over the determinant.
const SETTLED: f64 = 1e-18;
const REGULAR: f64 = 1e-6;
/// How many times as far as it has moved a point is from all others.
const APART: f64 = 4.0;
/// Above this share of the largest coordinate h is not near zero.
const FINITE: f64 = 1e-11;

type Vector = [f64; 3];
type Coordinates = [f64; 7];
/// A symmetric matrix: 00, 01, 02, 11, 12, 22.
type Form = [f64; 6];

/// cos, sin, x, y of each position.
pub(super) type Problem = [[f64; 4]; 5];

/// The points of one line: both if they are real, else real and imaginary part of one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OnLine {
    /// 1 or 0.
    pub(super) is_real: f64,
    pub(super) first: Coordinates,
    pub(super) second: Coordinates,
}

/// The points of both lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Solution {
    pub(super) lines: [OnLine; 2],
    /// 1 or 0.
    pub(super) accepted: f64,
}

impl Solution {
    pub(super) const NONE: Solution = Solution {
        lines: [OnLine {
            is_real: 0.0,
            first: [0.0; 7],
            second: [0.0; 7],
        }; 2],
        accepted: 0.0,
    };
}

/// Many problems, what stands at the same place of each side by side.
#[inline(always)]
#[expect(
    clippy::indexing_slicing,
    reason = "all places are below the lengths that the types give"
)]
pub(super) fn solve_together<const N: usize>(
    problems: &[[[f64; N]; 4]; 5],
    points: &mut [[[f64; N]; 14]; 2],
    truths: &mut [[f64; N]; 3],
) {
    for n in 0..N {
        let mut problem = [[0.0; 4]; 5];
        for position in 0..5 {
            for number in 0..4 {
                problem[position][number] = problems[position][number][n];
            }
        }
        let solution = solve(&problem);
        for line in 0..2 {
            truths[line][n] = solution.lines[line].is_real;
            for place in 0..7 {
                points[line][place][n] = solution.lines[line].first[place];
                points[line][7 + place][n] = solution.lines[line].second[place];
            }
        }
        truths[2][n] = solution.accepted;
    }
}

/// One problem.
#[inline(always)]
pub(super) fn solve(problem: &Problem) -> Solution {
    let [_, _, x, y] = problem[0];
    let origin = [x, y];
    let turns = problem.map(|[cos, sin, ..]| [cos, sin]);
    let shifts = [
        shift(problem[1], origin),
        shift(problem[2], origin),
        shift(problem[3], origin),
        shift(problem[4], origin),
    ];
    let [s0, s1, s2, s3] = [
        norm(shifts[0]),
        norm(shifts[1]),
        norm(shifts[2]),
        norm(shifts[3]),
    ];
    let square = larger(larger(s0, s1), larger(s2, s3));
    let unit = Unit {
        origin,
        length: square.sqrt(),
        square,
    };
    let basis = kernel(rows(&turns, &shifts, 1.0 / unit.length));
    let [f, g] = conics(&basis);
    let (lines, conic) = split(f, g);
    let starts = [meets(&lines[0], &conic), meets(&lines[1], &conic)];
    let [(at_0, moved_0, settled_0), (at_1, moved_1, settled_1)] =
        [improved(&f, &g, starts[0]), improved(&f, &g, starts[1])];
    let way = APART * (moved_0 + moved_1);
    let (on_0, finite_0) = on_line(at_0, &basis, &unit);
    let (on_1, finite_1) = on_line(at_1, &basis, &unit);
    let apart = is_beside(at_0, &lines[1], way) * is_beside(at_1, &lines[0], way);
    Solution {
        lines: [on_0, on_1],
        accepted: settled_0 * settled_1 * apart * finite_0 * finite_1,
    }
}

#[inline(always)]
fn choose(condition: bool, yes: f64, no: f64) -> f64 {
    if condition { yes } else { no }
}

#[inline(always)]
fn truth(condition: bool) -> f64 {
    choose(condition, 1.0, 0.0)
}

#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    choose(a > b, a, b)
}

#[inline(always)]
fn smaller(a: f64, b: f64) -> f64 {
    choose(a < b, a, b)
}

/// By parts that are known beforehand: chosen among places in memory, they could not stay in lanes.
#[inline(always)]
fn chosen(condition: bool, [a, b, c]: Vector, [d, e, f]: Vector) -> Vector {
    [
        choose(condition, a, d),
        choose(condition, b, e),
        choose(condition, c, f),
    ]
}

#[inline(always)]
fn chosen_form(condition: bool, yes: Form, no: Form) -> Form {
    let ([a, b, c, d, e, f], [u, v, w, x, y, z]) = (yes, no);
    let ([a, b, c], [d, e, f]) = (
        chosen(condition, [a, b, c], [u, v, w]),
        chosen(condition, [d, e, f], [x, y, z]),
    );
    [a, b, c, d, e, f]
}

/// A length and an origin with which the numbers are about one.
struct Unit {
    origin: [f64; 2],
    length: f64,
    square: f64,
}

impl Unit {
    #[inline(always)]
    fn back(&self, [h, x, y, cx, cy, p, q]: Coordinates) -> Coordinates {
        let [a, b] = self.origin;
        let (x, y) = (x * self.length, y * self.length);
        [
            h,
            x,
            y,
            cx * self.length + a * h,
            cy * self.length + b * h,
            p * self.square + x * a + y * b,
            q * self.square + y * a - x * b,
        ]
    }
}

#[inline(always)]
fn shift([_, _, x, y]: [f64; 4], [a, b]: [f64; 2]) -> [f64; 2] {
    [x - a, y - b]
}

#[inline(always)]
fn norm([x, y]: [f64; 2]) -> f64 {
    x * x + y * y
}

/// The [conditions](super::super::conditions::rows) with the first translation zero.
#[inline(always)]
#[expect(
    clippy::indexing_slicing,
    reason = "all places are below the lengths that the types give"
)]
fn rows(turns: &[[f64; 2]; 5], shifts: &[[f64; 2]; 4], scale: f64) -> [Coordinates; 4] {
    let [c0, s0] = turns[0];
    let mut rows = [[0.0; 7]; 4];
    for j in 0..4 {
        let [c, s] = turns[j + 1];
        let (x, y) = (shifts[j][0] * scale, shifts[j][1] * scale);
        rows[j] = [
            (x * x + y * y) * 0.5,
            x * c + y * s,
            y * c - x * s,
            -x,
            -y,
            c0 - c,
            s - s0,
        ];
    }
    rows
}

/// Takes all of row K from K + 1 on to zero, and the later rows with it; what is left of the row is the
/// reflection's vector v, and the factor is 2/v².
#[inline(always)]
#[expect(
    clippy::indexing_slicing,
    clippy::needless_range_loop,
    reason = "all places are below the lengths that the types give"
)]
fn reflect<const K: usize>(rows: &mut [Coordinates; 4]) -> f64 {
    let head = rows[K][K];
    let mut square = head * head;
    for i in K + 1..7 {
        square += rows[K][i] * rows[K][i];
    }
    let length = square.sqrt();
    rows[K][K] = head + length.copysign(head);
    let factor = 1.0 / (square + head.abs() * length);
    for j in K + 1..4 {
        let mut sum = rows[K][K] * rows[j][K];
        for i in K + 1..7 {
            sum += rows[K][i] * rows[j][i];
        }
        sum *= factor;
        for i in K..7 {
            rows[j][i] -= sum * rows[K][i];
        }
    }
    factor
}

/// The reflection of a vector whose part K is zero.
#[inline(always)]
#[expect(
    clippy::indexing_slicing,
    reason = "all places are below the lengths that the types give"
)]
fn reflected<const K: usize>(axis: &mut Coordinates, rows: &[Coordinates; 4], factor: f64) {
    let mut sum = rows[K][K + 1] * axis[K + 1];
    for i in K + 2..7 {
        sum += rows[K][i] * axis[i];
    }
    sum *= -factor;
    axis[K] = sum * rows[K][K];
    for i in K + 1..7 {
        axis[i] += sum * rows[K][i];
    }
}

#[inline(always)]
#[expect(
    clippy::indexing_slicing,
    reason = "all places are below the lengths that the types give"
)]
fn axis<const M: usize>(rows: &[Coordinates; 4], factors: &[f64; 4]) -> Coordinates {
    let mut axis = [0.0; 7];
    let sum = -(factors[3] * rows[3][M]);
    for i in 3..7 {
        axis[i] = sum * rows[3][i];
    }
    axis[M] += 1.0;
    reflected::<2>(&mut axis, rows, factors[2]);
    reflected::<1>(&mut axis, rows, factors[1]);
    reflected::<0>(&mut axis, rows, factors[0]);
    axis
}

#[inline(always)]
fn kernel(mut rows: [Coordinates; 4]) -> [Coordinates; 3] {
    let factors = [
        reflect::<0>(&mut rows),
        reflect::<1>(&mut rows),
        reflect::<2>(&mut rows),
        reflect::<3>(&mut rows),
    ];
    [
        axis::<4>(&rows, &factors),
        axis::<5>(&rows, &factors),
        axis::<6>(&rows, &factors),
    ]
}

/// The [products](super::super::conditions::products) of two vectors, halved.
#[inline(always)]
fn products(l: &Coordinates, r: &Coordinates) -> [f64; 2] {
    let [h, x, y, cx, cy, p, q] = *l;
    let [h1, x1, y1, cx1, cy1, p1, q1] = *r;
    let [re, im] = [
        (h * p1 + h1 * p) - (x * cx1 + x1 * cx) - (y * cy1 + y1 * cy),
        (h * q1 + h1 * q) - (y * cx1 + y1 * cx) + (x * cy1 + x1 * cy),
    ];
    [re * 0.5, im * 0.5]
}

#[inline(always)]
fn squares(v: &Coordinates) -> [f64; 2] {
    let [h, x, y, cx, cy, p, q] = *v;
    [h * p - x * cx - y * cy, h * q - y * cx + x * cy]
}

#[inline(always)]
fn conics([a, b, c]: &[Coordinates; 3]) -> [Form; 2] {
    let (aa, bb, cc) = (squares(a), squares(b), squares(c));
    let (ab, ac, bc) = (products(a, b), products(a, c), products(b, c));
    [
        [aa[0], ab[0], ac[0], bb[0], bc[0], cc[0]],
        [aa[1], ab[1], ac[1], bb[1], bc[1], cc[1]],
    ]
}

#[inline(always)]
fn adjugate([a, b, c, d, e, f]: Form) -> Form {
    [
        d * f - e * e,
        c * e - b * f,
        b * e - c * d,
        a * f - c * c,
        b * c - a * e,
        a * d - b * b,
    ]
}

/// The trace of a product.
#[inline(always)]
fn trace(f: &Form, g: &Form) -> f64 {
    (f[0] * g[0] + f[3] * g[3] + f[5] * g[5]) + 2.0 * (f[1] * g[1] + f[2] * g[2] + f[4] * g[4])
}

#[inline(always)]
fn determinant(f: &Form, adjugate: &Form) -> f64 {
    f[0] * adjugate[0] + f[1] * adjugate[1] + f[2] * adjugate[2]
}

#[inline(always)]
fn times(f: &Form, v: &Vector) -> Vector {
    [
        f[0] * v[0] + f[1] * v[1] + f[2] * v[2],
        f[1] * v[0] + f[3] * v[1] + f[4] * v[2],
        f[2] * v[0] + f[4] * v[1] + f[5] * v[2],
    ]
}

#[inline(always)]
fn dot(a: &Vector, b: &Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// μF + G
#[inline(always)]
fn combined(mu: f64, f: &Form, g: &Form) -> Form {
    [
        mu * f[0] + g[0],
        mu * f[1] + g[1],
        mu * f[2] + g[2],
        mu * f[3] + g[3],
        mu * f[4] + g[4],
        mu * f[5] + g[5],
    ]
}

/// How much a conic is two lines: the less, the more they are real and apart.
#[inline(always)]
fn splitting(s: &Form) -> f64 {
    let minors =
        (s[0] * s[3] + s[0] * s[5] + s[3] * s[5]) - (s[1] * s[1] + s[2] * s[2] + s[4] * s[4]);
    minors / trace(s, s)
}

/// Two lines through the meets of two conics, and a third conic through them.
#[inline(always)]
fn split(f: Form, g: Form) -> ([Vector; 2], Form) {
    let (df, dg) = (adjugate(f), adjugate(g));
    let (fff, ggg) = (determinant(&f, &df), determinant(&g, &dg));
    let (ffg, fgg) = (trace(&df, &g), trace(&f, &dg));
    // The leading coefficient is not the smaller one.
    let keep = fff.abs() >= ggg.abs();
    let by = 1.0 / choose(keep, fff, ggg);
    let (f, g) = (chosen_form(keep, f, g), chosen_form(keep, g, f));
    let [r1, r2, r3] = cubic_roots(
        by * choose(keep, ffg, fgg),
        by * choose(keep, fgg, ffg),
        by * choose(keep, ggg, fff),
    );
    let s1 = splitting(&combined(r1, &f, &g));
    let s2 = splitting(&combined(r2, &f, &g));
    let s3 = splitting(&combined(r3, &f, &g));
    let (root, least) = (choose(s2 < s1, r2, r1), choose(s2 < s1, s2, s1));
    let root = choose(s3 < least, r3, root);
    (lines(combined(root, &f, &g)), combined(-root, &g, &f))
}

/// To a few hundredths: a third of the exponent.
#[inline(always)]
fn about_cube_root(x: f64) -> f64 {
    let third = ((x.to_bits() >> 32) * 0x5555_5556) >> 32;
    f64::from_bits((third << 32) + 0x2a9f_7893_0000_0000)
}

/// The real roots of t³ + bt² + ct + d; where there is one only, it stands for the others.
///
/// With s = t + b/3 it is s³ + ps + q, and the root of s³ + ps = |q| is the largest, to which Newton's
/// steps descend from above: it is at most 2√(−p/3) where all are real, and at most ∛(4|q|) where one
/// is, ∛|q| for p > 0.
#[inline(always)]
fn cubic_roots(b: f64, c: f64, d: f64) -> Vector {
    let third = b * (1.0 / 3.0);
    let p = c - b * third;
    let q = (2.0 * (third * third) - c) * third + d;
    let (size, down) = (q.abs(), larger(-p, 0.0));
    let above = about_cube_root(size) * choose(p < 0.0, 1.7, 1.07);
    let mut s = larger((down * (4.0 / 3.0)).sqrt(), above);
    for _ in 0..5 {
        let square = s * s;
        s = (2.0 * (square * s) + size) / (3.0 * square + p);
    }
    let s1 = s.copysign(-q);
    let discriminant = -(3.0 * (s1 * s1) + 4.0 * p);
    let is_real = discriminant >= 0.0;
    let s2 = -0.5 * (s1 + larger(discriminant, 0.0).sqrt().copysign(s1));
    let s3 = -q / (s1 * s2);
    [
        s1 - third,
        choose(is_real, s2, s1) - third,
        choose(is_real, s3, s1) - third,
    ]
}

#[inline(always)]
fn unit(v: Vector) -> Vector {
    let by = 1.0 / dot(&v, &v).sqrt();
    [v[0] * by, v[1] * by, v[2] * by]
}

#[inline(always)]
fn longest(a: Vector, b: Vector, c: Vector) -> Vector {
    let (aa, bb, cc) = (dot(&a, &a), dot(&b, &b), dot(&c, &c));
    chosen(larger(aa, bb) >= cc, chosen(aa >= bb, a, b), c)
}

/// The lines l, m of S = lmᵀ + mlᵀ: the adjugate is −ppᵀ with p = l × m, and S + [p]ₓ = 2mlᵀ.
#[inline(always)]
fn lines(s: Form) -> [Vector; 2] {
    let a = adjugate(s);
    let (x, y, z) = (a[0].abs(), a[3].abs(), a[5].abs());
    let column = chosen(x >= y, [a[0], a[1], a[2]], [a[1], a[3], a[4]]);
    let column = chosen(larger(x, y) >= z, column, [a[2], a[4], a[5]]);
    let by = 1.0 / larger(larger(x, y), z).sqrt();
    let p = [column[0] * by, column[1] * by, column[2] * by];
    let (a, b, c) = (s[0], s[1] - p[2], s[2] + p[1]);
    let (d, e, f) = (s[1] + p[2], s[3], s[4] - p[0]);
    let (g, h, i) = (s[2] - p[1], s[4] + p[0], s[5]);
    [
        unit(longest([a, b, c], [d, e, f], [g, h, i])),
        unit(longest([a, d, g], [b, e, h], [c, f, i])),
    ]
}

/// Two unit vectors at right angles to a unit vector and to each other.
#[inline(always)]
fn across([x, y, z]: Vector) -> [Vector; 2] {
    let sign = 1.0_f64.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    [
        [1.0 + sign * x * x * a, sign * b, -sign * x],
        [b, sign + y * y * a, -y],
    ]
}

/// Two real numbers, or real and imaginary part of one.
#[derive(Clone, Copy)]
struct Both {
    is_real: bool,
    x: f64,
    y: f64,
}

impl Both {
    #[inline(always)]
    fn with(self, x: f64, y: f64) -> Both {
        Both { x, y, ..self }
    }

    #[inline(always)]
    fn times(self, other: Both) -> Both {
        let (xx, yy) = (self.x * other.x, self.y * other.y);
        let mixed = self.x * other.y + self.y * other.x;
        self.with(
            choose(self.is_real, xx, xx - yy),
            choose(self.is_real, yy, mixed),
        )
    }

    #[inline(always)]
    fn plus(self, other: Both) -> Both {
        self.with(self.x + other.x, self.y + other.y)
    }

    #[inline(always)]
    fn minus(self, other: Both) -> Both {
        self.with(self.x - other.x, self.y - other.y)
    }

    #[inline(always)]
    fn scaled(self, by: f64) -> Both {
        self.with(self.x * by, self.y * by)
    }

    #[inline(always)]
    fn conj(self) -> Both {
        self.with(self.x, choose(self.is_real, self.y, -self.y))
    }

    #[inline(always)]
    fn inverse(self) -> Both {
        let norm = self.x * self.x + self.y * self.y;
        let (x, y) = (
            choose(self.is_real, 1.0, self.x),
            choose(self.is_real, 1.0, -self.y),
        );
        self.with(
            x / choose(self.is_real, self.x, norm),
            y / choose(self.is_real, self.y, norm),
        )
    }

    /// The square of the larger one, or of the absolute value; at most twice as much.
    #[inline(always)]
    fn most(self) -> f64 {
        self.x * self.x + self.y * self.y
    }

    /// The square of the smaller one, or of the absolute value.
    #[inline(always)]
    fn least(self) -> f64 {
        let (xx, yy) = (self.x * self.x, self.y * self.y);
        choose(self.is_real, smaller(xx, yy), xx + yy)
    }
}

type Point = [Both; 3];

/// With numbers that are real throughout.
#[inline(always)]
fn sum(a: f64, b: f64, c: f64, [x, y, z]: Point) -> Both {
    x.scaled(a).plus(y.scaled(b)).plus(z.scaled(c))
}

#[inline(always)]
fn image(f: &Form, at: Point) -> Point {
    [
        sum(f[0], f[1], f[2], at),
        sum(f[1], f[3], f[4], at),
        sum(f[2], f[4], f[5], at),
    ]
}

#[inline(always)]
fn cross([a, b, c]: Point, [x, y, z]: Point) -> Point {
    [
        b.times(z).minus(c.times(y)),
        c.times(x).minus(a.times(z)),
        a.times(y).minus(b.times(x)),
    ]
}

#[inline(always)]
fn scalar([a, b, c]: Point, [x, y, z]: Point) -> Both {
    a.times(x).plus(b.times(y)).plus(c.times(z))
}

/// The points of a line.
#[derive(Clone, Copy)]
struct Meets {
    at: Point,
    /// Half of the sine of the angle between both, or of that between conjugate ones.
    apart: f64,
}

/// Where a line meets a conic: of absolute value one, the imaginary part at right angles to the real
/// one.
#[inline(always)]
fn meets(line: &Vector, conic: &Form) -> Meets {
    let [u, v] = across(*line);
    let (cu, cv) = (times(conic, &u), times(conic, &v));
    let (a, b, c) = (dot(&u, &cu), dot(&v, &cu), dot(&v, &cv));
    let (mean, half) = ((a + c) * 0.5, (a - c) * 0.5);
    let radius = (half * half + b * b).sqrt();
    let by = 1.0 / radius;
    // The axis of λ₁ has half the argument of half + ib.
    let (cos, sin) = (half * by, b * by);
    let long = ((1.0 + cos.abs()) * 0.5).sqrt();
    let short = sin / (2.0 * long);
    let (cos, sin) = (
        choose(cos >= 0.0, long, short),
        choose(cos >= 0.0, short, long),
    );
    let product = a * c - b * b;
    let large = mean + radius.copysign(mean);
    let small = (product / large).abs();
    let large = large.abs();
    let (l1, l2) = (
        choose(mean >= 0.0, large, small),
        choose(mean >= 0.0, small, large),
    );
    let by = 1.0 / (l1 + l2);
    let (x, y) = ((l2 * by).sqrt(), (l1 * by).sqrt());
    let is_real = product < 0.0;
    let part = |u: f64, v: f64| {
        let (a, b) = ((u * cos + v * sin) * x, (v * cos - u * sin) * y);
        Both {
            is_real,
            x: choose(is_real, a + b, a),
            y: choose(is_real, a - b, b),
        }
    };
    Meets {
        at: [part(u[0], v[0]), part(u[1], v[1]), part(u[2], v[2])],
        apart: x * y,
    }
}

/// After one of Newton's steps; its squared size, and the squared determinant, at the worse of both.
#[inline(always)]
fn step(f: &Form, g: &Form, at: Point, conj: Point) -> (Point, f64, f64) {
    let (p, r) = (image(f, at), image(g, at));
    let (fv, gv) = (scalar(at, p), scalar(at, r));
    let part = |p: Both, r: Both| fv.times(r).minus(gv.times(p));
    let across = cross([part(p[0], r[0]), part(p[1], r[1]), part(p[2], r[2])], conj);
    let determinant = scalar(conj, cross(p, r));
    let by = determinant.inverse().scaled(-0.5);
    let [x, y, z] = [
        across[0].times(by),
        across[1].times(by),
        across[2].times(by),
    ];
    let next = [at[0].plus(x), at[1].plus(y), at[2].plus(z)];
    (next, x.most() + y.most() + z.most(), determinant.least())
}

/// After two steps; how far the points have moved, and whether they are those that they started for.
#[inline(always)]
fn improved(f: &Form, g: &Form, start: Meets) -> (Point, f64, f64) {
    let [x, y, z] = start.at;
    let conj = [x.conj(), y.conj(), z.conj()];
    let (at, first, _) = step(f, g, start.at, conj);
    let (at, second, determinant) = step(f, g, at, conj);
    let moved = first.sqrt() + second.sqrt();
    let settled = truth(second <= SETTLED)
        * truth(second <= REGULAR * determinant)
        * truth(APART * moved <= start.apart);
    (at, moved, settled)
}

/// Whether both points are farther from a line than a distance.
#[inline(always)]
fn is_beside(at: Point, line: &Vector, distance: f64) -> f64 {
    truth(distance * distance < sum(line[0], line[1], line[2], at).least())
}

/// The coordinates of the points, and whether they are far from infinity.
#[inline(always)]
#[expect(clippy::indexing_slicing, reason = "there are seven coordinates")]
fn on_line(at: Point, [a, b, c]: &[Coordinates; 3], unit: &Unit) -> (OnLine, f64) {
    let (mut first, mut second) = ([0.0; 7], [0.0; 7]);
    for i in 0..7 {
        let coordinate = sum(a[i], b[i], c[i], at);
        (first[i], second[i]) = (coordinate.x, coordinate.y);
    }
    let h = sum(a[0], b[0], c[0], at);
    let found = OnLine {
        is_real: truth(at[0].is_real),
        first: unit.back(first),
        second: unit.back(second),
    };
    (found, truth(h.least() > FINITE * FINITE))
}
