//! One position of Hart's five-bar in the paper's coordinates: M in the origin, N on the x-axis.

use crate::formula::Bindings;
use crate::linkage::five_bar::{self, Chain, Lengths};
use crate::number::{Number, Real};
use crate::plane::{Angle, Point};
use crate::scenes::{Free, Unbuilt};

/// A position and the parameters it was made from.
pub struct Position<K> {
    pub lengths: Lengths<K>,
    pub omega: Angle<K>,
    /// In the frame of the bar MP.
    pub chain: Chain<K>,
    /// MN
    pub d: Number<K>,
    /// Unit vector of MP in the paper's frame.
    pub u: Point<K>,
}

impl<K: Real> Position<K> {
    /// All four bars and both angles are free; the base is where the chain ends, and the whole is
    /// turned until the base lies on the x-axis.
    pub fn free(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let lengths = Lengths {
            m: free.length("m")?,
            p: free.length("p")?,
            q: free.length("q")?,
            n: free.length("n")?,
        };
        Self::with_lengths(lengths, free)
    }

    /// The bars are given; both angles are free.
    pub fn with_lengths(lengths: Lengths<K>, free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let turn = free.angle("psi - phi")?;
        let omega = free.angle("omega")?;
        let chain = five_bar::lay(&lengths, &turn, &omega);
        let d = free.root("d", &chain.n.norm())?;
        let u = chain.n.conj().scaled(&d.inverse());
        Ok(Position {
            lengths,
            omega,
            chain,
            d,
            u,
        })
    }

    /// A point of the frame of the bar MP, in the paper's frame.
    pub fn turned(&self, point: &Point<K>) -> Point<K> {
        point * &self.u
    }

    /// Unit vector of NQ in the paper's frame.
    pub fn v(&self) -> Point<K> {
        self.turned(&self.chain.v)
    }

    /// Binds what sections 1 to 3 share.
    pub fn bind(&self, bindings: &mut Bindings<K>) {
        let Lengths { m, p, q, n } = &self.lengths;
        for (name, length) in [("m", m), ("p", p), ("q", q), ("n", n), ("d", &self.d)] {
            bindings.bind(name, length.clone());
        }
        let base: Point<K> = self.d.clone().into();
        let [p, f, q] = [&self.chain.p, &self.chain.f, &self.chain.q].map(|z| self.turned(z));
        bindings.bind("phi", Angle::at_vertex(&base, &Number::zero(), &p));
        bindings.bind("psi", Angle::of(&q - &base));
        bindings.bind("omega", self.omega.clone());
        bindings.bind("u", self.u.clone());
        bindings.bind("v", self.v());
        bindings.bind("w", self.chain.w.clone());
        bindings.bind("M", Point::<K>::zero());
        bindings.bind("N", base);
        bindings.bind("P", p);
        bindings.bind("Q", q);
        bindings.bind("z", f.clone());
        bindings.bind("F", f);
    }
}
