//! The curves from the closure of the loop crank, coupler, frame.

use crate::number::{Kind, Number};
use crate::plane::circular_cubic::Cubic;
use crate::plane::displacement::Displacement;
use crate::plane::polynomial::Polynomial;

/// The centerpoint curve, in the fixed plane.
///
/// A crank W about M leads in the first position to the circlepoint M + W, which from there on moves
/// with the plane: in the position that ρ and δ lead to from the first, X ↦ ρX + δ, the crank is
/// ρW + c with c = (ρ − 1)M + δ. It has the length of W where
///
/// ```text
/// 2 Re(ρ̄c W̄) + |c|² = 0,
/// ```
///
/// one line for W. Three such lines meet where the determinant of Re ρ̄c, Im ρ̄c, |c|² vanishes. Its
/// terms of order 4 in M cancel: the 1 − ρ̄ lie on a circle through the origin.
pub fn centerpoint_cubic<K: Kind>(positions: &[Displacement<K>; 4]) -> Option<Cubic<K>> {
    let [first, rest @ ..] = positions;
    let back = first.inverse();
    let [p, q, r] = rest.each_ref().map(|position| row(&position.after(&back)));
    let minor = |a: &Row<K>, b: &Row<K>| a.re.times(&b.im).minus(&a.im.times(&b.re));
    p.norm
        .times(&minor(&q, &r))
        .plus(&q.norm.times(&minor(&r, &p)))
        .plus(&r.norm.times(&minor(&p, &q)))
        .to_cubic()
}

/// The circlepoint curve, in the moving plane: the centerpoint curve of the inverse motion.
pub fn circlepoint_cubic<K: Kind>(positions: &[Displacement<K>; 4]) -> Option<Cubic<K>> {
    centerpoint_cubic(&positions.each_ref().map(Displacement::inverse))
}

/// ρ̄c = (1 − ρ̄)M + ρ̄δ by its parts, and |c|², as polynomials in the coordinates of M.
struct Row<K> {
    re: Polynomial<K>,
    im: Polynomial<K>,
    norm: Polynomial<K>,
}

fn row<K: Kind>(step: &Displacement<K>) -> Row<K> {
    let back = step.rotation.conj();
    let turn = Number::one() - &back;
    let shift = back * &step.translation;
    let mixed = turn.conj() * &shift;
    Row {
        norm: Polynomial::circle(
            turn.norm(),
            2 * mixed.re(),
            2 * mixed.im(),
            step.translation.norm(),
        ),
        re: Polynomial::linear(turn.re().clone(), -turn.im(), shift.re().clone()),
        im: Polynomial::linear(turn.im().clone(), turn.re().clone(), shift.im().clone()),
    }
}
