//! The crank drive of a four-bar needs quadratic equations only.

use crate::linkage::crank_drive::Squares;
use crate::linkage::five_bar::{self, Lengths};
use crate::linkage::focal_mechanism;
use crate::number::poly::Fraction;
use crate::number::{Number, Truth};
use crate::plane::{Point, relation};
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::Symbols;
use crate::scenes::{Free, Unbuilt};

pub const CHECK: Check = Check {
    name: "crank-drive-needs-only-quadratic-equations",
    summary: "For every focal mechanism, with bars and angles free, lambda satisfies one quadratic \
              equation whose coefficients are rational in a^2, b^2, c^2, d^2 and the ratio rho that S \
              gives, and p^2, q^2, r^2 are rational in these and lambda. The wrong variant exchanges \
              the base and the coupler in it.",
    run,
};

fn run() -> Result<Report, Unbuilt> {
    let mut free = Symbols::default();
    let lengths = Lengths {
        m: free.length("m")?,
        p: free.length("p")?,
        q: free.length("q")?,
        n: free.length("n")?,
    };
    let turn = free.angle("psi - phi")?;
    let omega = free.angle("omega")?;
    let chain = five_bar::lay(&lengths, &turn, &omega);
    let (a, b) = focal_mechanism::arms(&lengths);
    let pin_a: Point<Fraction> = a.clone().into();
    let pin_b = &chain.n + chain.v.scaled(&b);
    let Lengths { m, p, q, n } = &lengths;
    let rho = m * p / (n * q);
    let lambda = &a / m;
    let squares = Squares {
        a: a.square(),
        b: b.square(),
        c: relation::distance_squared(&pin_a, &pin_b),
        d: chain.n.norm(),
    };
    let s = chain.n.scaled(&five_bar::share_of_center(&rho.inverse()));
    let r_squared = relation::distance_squared(&s, &chain.f);
    let found = squares.bars(&rho, &lambda);
    let bars = [
        found.p.equals(&p.square()),
        found.q.equals(&q.square()),
        found.r.equals(&r_squared),
    ];
    let exchanged = Squares {
        c: squares.d.clone(),
        d: squares.c.clone(),
        ..squares.clone()
    };
    let root = |squares: &Squares<Fraction>| -> Truth {
        let [two, one, zero] = squares.equation_of_lambda(&rho);
        let value: Number<Fraction> = (two * &lambda + one) * &lambda + zero;
        value.is_zero()
    };
    Ok(Report {
        holds: root(&squares) & Truth::all(bars),
        wrong_variant: root(&exchanged),
        basis: Basis::Identity,
        instances: 0,
        exception: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
    }
}
