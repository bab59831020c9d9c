//! What five positions ask of a pair, also where some of them have fallen together.
//!
//! A position and those that have fallen together with it are a motion D(t) to some power of t. The
//! squared link |D(t)z − M|² has one value in all of them: the terms without t are equal, the others
//! vanish.

use rug::Rational;

use crate::number::{Ball, Complex, Exact, Kind, Number, array};
use crate::oracle::positions::Given;
use crate::plane::displacement::Displacement;

/// What 1, t, t², … are multiplied with in a displacement: one for each position.
pub type Group<K> = Vec<Displacement<K>>;

/// x, y of the circlepoint, X, Y of the center.
pub type Pair<K> = [Number<K>; 4];

/// Five positions as a problem gives them.
pub trait Five {
    /// To so many bits.
    fn enclosed(&self, bits: u32) -> Vec<Group<Ball>>;
    /// Where all cosines and sines are rational.
    fn exact(&self) -> Option<Vec<Group<Exact>>>;
}

/// Five that are apart.
impl Five for Given {
    fn enclosed(&self, bits: u32) -> Vec<Group<Ball>> {
        let positions = self.rounded::<Ball>(&bits);
        let each = positions.displacements().iter();
        each.map(|position| vec![position.clone()]).collect()
    }

    fn exact(&self) -> Option<Vec<Group<Exact>>> {
        let positions = self.rational()?;
        let each = positions.displacements().iter();
        Some(each.map(|position| vec![position.clone()]).collect())
    }
}

/// One position of each group.
pub fn apart<K: Kind>(groups: &[Group<K>]) -> Vec<Displacement<K>> {
    groups
        .iter()
        .filter_map(|group| group.first().cloned())
        .collect()
}

/// Four conditions on a pair.
pub struct Conditions<K>(Vec<Vec<Term<K>>>);

/// Cosine, sine, and the place of the moving origin.
type Term<K> = [Number<K>; 4];

impl Conditions<Complex<Ball>> {
    pub fn enclosed(five: &impl Five, bits: u32) -> Self {
        Conditions::of(&five.enclosed(bits), |x| Number::from(x.clone()))
    }

    /// How far the positions go: a size also where both points are the origins of their planes.
    pub fn reach(&self) -> Option<Rational> {
        let mut largest = Rational::new();
        for [_, _, x, y] in self.0.iter().flatten() {
            for part in [x, y] {
                largest = largest.max(part.re().0.midpoint_rational()?.abs());
            }
        }
        Some(largest)
    }
}

impl Conditions<Complex<f64>> {
    /// The numbers next to those of enclosures.
    pub fn in_floats(groups: &[Group<Ball>]) -> Self {
        let nearest = |x: &Number<Ball>| x.0.midpoint_rational().map_or(f64::NAN, |q| q.to_f64());
        Conditions::of(groups, |x| Number::from(Number(nearest(x))))
    }

    /// The largest coordinate of the positions themselves.
    pub fn reach_in_floats(&self) -> f64 {
        let first = self.0.iter().filter_map(|group| group.first());
        let parts = first.flat_map(|[_, _, x, y]| [x.re().0.abs(), y.re().0.abs()]);
        parts.fold(0.0, f64::max)
    }
}

impl Conditions<Exact> {
    pub fn exact(five: &impl Five) -> Option<Self> {
        Some(Conditions::of(&five.exact()?, Number::clone))
    }
}

impl<K: Kind> Conditions<K> {
    fn of<L: Kind>(groups: &[Group<L>], convert: impl Fn(&Number<L>) -> Number<K>) -> Self {
        let term = |part: &Displacement<L>| {
            let (turn, shift) = (&part.rotation, &part.translation);
            [turn.re(), turn.im(), shift.re(), shift.im()].map(&convert)
        };
        let groups = groups.iter();
        Conditions(
            groups
                .map(|group| group.iter().map(term).collect())
                .collect(),
        )
    }

    /// All zero for a pair; `None` for other than five positions.
    pub fn at(&self, pair: &Pair<K>) -> Option<Pair<K>> {
        let squares = self.0.iter().map(|group| {
            let links = links(group, pair);
            let term = |n: usize| [product(&links, &links, n)];
            (0..group.len()).map(term).collect()
        });
        Some(differences(squares)?.map(|[value]| value))
    }

    /// Their derivatives by x, y, X, Y, row by row.
    pub fn slopes(&self, pair: &Pair<K>) -> Option<[Pair<K>; 4]> {
        let slopes = self.0.iter().map(|group| {
            let links = links(group, pair);
            // D(t) and iD(t): how the link changes with x and with y.
            let turns = || group.iter().map(|[cos, sin, ..]| (cos, sin));
            let by_x: Vec<[Number<K>; 2]> = turns().map(|(c, s)| [c.clone(), s.clone()]).collect();
            let by_y: Vec<[Number<K>; 2]> = turns().map(|(c, s)| [-s, c.clone()]).collect();
            let slopes = links.iter().enumerate().map(|(n, [u, v])| {
                let along = |other: &[[Number<K>; 2]]| product(&links, other, n) * 2;
                [along(&by_x), along(&by_y), u * -2, v * -2]
            });
            slopes.collect()
        });
        differences(slopes)
    }

    /// What 1, x, y, X, Y, xX + yY and yX − xY are multiplied with, from the values in a few pairs.
    #[expect(
        clippy::indexing_slicing,
        reason = "there are four values in every pair"
    )]
    pub fn forms(&self) -> Option<[Form<K>; 4]> {
        let at = |pair: [i64; 4]| self.at(&pair.map(Number::from));
        let origin = at([0, 0, 0, 0])?;
        let axes = [
            at([1, 0, 0, 0])?,
            at([0, 1, 0, 0])?,
            at([0, 0, 1, 0])?,
            at([0, 0, 0, 1])?,
        ];
        let mixed = [at([1, 0, 1, 0])?, at([0, 1, 1, 0])?];
        Some(std::array::from_fn(|row| {
            let constant = &origin[row];
            let [x, y, cx, cy] = axes.each_ref().map(|values| &values[row] - constant);
            let [p, q] = mixed.each_ref().map(|values| &values[row] - constant);
            let (p, q) = (p - &x - &cx, q - &y - &cx);
            Form([constant.clone(), x, y, cx, cy, p, q])
        }))
    }
}

/// The link from the center to the circlepoint, by powers of t.
fn links<K: Kind>(group: &[Term<K>], [x, y, cx, cy]: &Pair<K>) -> Vec<[Number<K>; 2]> {
    let parts = group.iter().enumerate().map(|(power, [cos, sin, a, b])| {
        let [u, v] = [cos * x - sin * y + a, sin * x + cos * y + b];
        if power == 0 { [u - cx, v - cy] } else { [u, v] }
    });
    parts.collect()
}

/// What tⁿ is multiplied with in a scalar product.
fn product<K: Kind>(left: &[[Number<K>; 2]], right: &[[Number<K>; 2]], n: usize) -> Number<K> {
    let pairs = left.iter().take(n + 1).zip(right.iter().take(n + 1).rev());
    pairs.map(|([a, b], [c, d])| a * c + b * d).sum()
}

/// What must vanish: every term after the first, those without t less the first.
fn differences<K: Kind, const N: usize>(
    groups: impl Iterator<Item = Vec<[Number<K>; N]>>,
) -> Option<[[Number<K>; N]; 4]> {
    let groups: Vec<Vec<[Number<K>; N]>> = groups.collect();
    let first = groups.first()?.first()?.clone();
    let terms = groups.into_iter().flat_map(|group| {
        let first = &first;
        group.into_iter().enumerate().map(move |(power, term)| {
            let base = (power == 0).then_some(first);
            base.map_or(term.clone(), |base| {
                array::pairs(&term, base).map(|(term, base)| term - base)
            })
        })
    });
    let rest: Vec<[Number<K>; N]> = terms.skip(1).collect();
    rest.try_into().ok()
}

/// A condition by what 1, x, y, X, Y, xX + yY and yX − xY are multiplied with.
#[derive(Clone)]
pub struct Form<K>([Number<K>; 7]);

impl<K: Kind> Form<K> {
    /// The same where circlepoint and center have exchanged their names.
    pub fn exchanged(&self) -> Self {
        let [one, x, y, cx, cy, p, q] = self.0.clone();
        Form([one, cx, cy, x, y, p, -q])
    }

    /// What X, Y and 1 are multiplied with, each by what it has of 1, x and y.
    pub fn by_center(&self) -> [[Number<K>; 3]; 3] {
        let [one, x, y, cx, cy, p, q] = self.0.clone();
        [[cx, p.clone(), q.clone()], [cy, -q, p], [one, x, y]]
    }

    /// Of several forms, each so often.
    #[expect(clippy::indexing_slicing, reason = "a form has seven coefficients")]
    pub fn sum(forms: &[Self; 4], factors: [i64; 4]) -> Self {
        Form(std::array::from_fn(|i| {
            let terms = forms.iter().zip(factors);
            terms.map(|(form, factor)| &form.0[i] * factor).sum()
        }))
    }

    pub fn minus(&self, other: &Self) -> Self {
        Form(array::pairs(&self.0, &other.0).map(|(one, other)| one - other))
    }

    /// Whether no product of circlepoint and center stands in it.
    pub fn is_of_translation(&self) -> bool {
        let [.., p, q] = &self.0;
        (p.is_zero() & q.is_zero()).is_yes()
    }

    /// What xX + yY and yX − xY are multiplied with.
    pub fn products(&self) -> [&Number<K>; 2] {
        let [.., p, q] = &self.0;
        [p, q]
    }

    /// What 1, x, y, X, Y are multiplied with.
    pub fn linear(&self) -> [Number<K>; 5] {
        let [one, x, y, cx, cy, ..] = self.0.clone();
        [one, x, y, cx, cy]
    }
}
