//! What is found, in one number kind.

use crate::curvature::slider_crank::SliderCrank;
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Elementary, Number, Real, Surd};
use crate::oracle::input;
use crate::plane::displacement::Displacement;
use crate::plane::{Angle, Point};
use crate::straight_line::ball_burmester::{
    Alternate, Cranks, at_inflection_pole, double, equal_cranks, of_rays, of_slider_crank,
};
use crate::straight_line::conchoid::Conchoid;
use crate::straight_line::design::Design;
use crate::straight_line::evans::Evans;
use crate::straight_line::four_bar::Lengths;
use crate::straight_line::no_design::NoDesign;
use crate::straight_line::slider_crank::{Assembly, Joints, guide};
use crate::straight_line::symmetric::Symmetric;
use crate::straight_line::symmetrical::{Symmetrical, rays_of_d};
use crate::straight_line::watt::Watt;

use super::given::{Closed, Crank};

/// Parameters of one kind, from those that were given.
pub trait Source<K: Real> {
    /// A number.
    fn number(&self, q: &rug::Rational) -> Number<K>;
    /// An angle; `None` where the kind does not hold its cosine and sine.
    fn angle(&self, angle: &input::Angle) -> Option<Angle<K>>;
}

/// Sums of square roots.
pub struct Exactly;

impl Source<Surd> for Exactly {
    fn number(&self, q: &rug::Rational) -> Number<Surd> {
        q.clone().into()
    }

    fn angle(&self, angle: &input::Angle) -> Option<Angle<Surd>> {
        angle.exact()
    }
}

/// Numbers of some precision.
pub struct Rounded<P>(pub P);

impl<K: Elementary> Source<K> for Rounded<K::Precision> {
    fn number(&self, q: &rug::Rational) -> Number<K> {
        Number::rounded(q, &self.0)
    }

    fn angle(&self, angle: &input::Angle) -> Option<Angle<K>> {
        Some(angle.rounded(&self.0))
    }
}

/// Linkages that go with one choice of the angles.
pub struct Solution<K> {
    /// Angles that were not given, by name.
    pub rays: Vec<(&'static str, Angle<K>)>,
    /// The linkages, or why there is none.
    pub linkages: Vec<Found<K>>,
}

/// A linkage, or why there is none.
pub struct Found<K> {
    /// Of the three alternates, where there are such.
    pub alternate: Option<Alternate>,
    /// The design.
    pub design: Result<Design<K>, NoDesign>,
    /// How closely D's path touches the line in the design position, at least.
    pub contact: usize,
    /// Other positions in which D is on the line, or in which the slider was asked to be.
    pub places: Vec<Place<K>>,
}

/// Another position.
#[derive(Clone)]
pub struct Place<K> {
    /// How far D was displaced, and in which assembly of the slider-crank.
    pub displaced: Option<(Number<K>, Assembly)>,
    /// Of the coupler.
    pub displacement: Displacement<K>,
    /// How closely D's path meets the line there, at least; `None` where the linkage is not known to
    /// come there.
    pub contact: Option<usize>,
}

/// The solutions of a formula; `None` where the kind does not hold the angles.
pub fn closed<K: Real>(
    given: &Closed,
    alternates: &[Alternate],
    source: &impl Source<K>,
) -> Option<Result<Vec<Solution<K>>, NoDesign>> {
    let number = |q: &rug::Rational| source.number(q);
    let angle = |angle: &input::Angle| source.angle(angle);
    let five_points = |cranks: Result<Cranks<K>, NoDesign>, alternates: &[Alternate]| {
        cranks.map(|cranks| vec![Solution::of_cranks(&cranks, alternates, 4, &[])])
    };
    Some(match given {
        Closed::BallBurmester([a, b, d]) => {
            five_points(of_rays(&angle(a)?, &angle(b)?, &angle(d)?), alternates)
        }
        Closed::BallDoubleBurmester([a, b]) => {
            five_points(double(&angle(a)?, &angle(b)?), &[Alternate::First])
        }
        Closed::InflectionPole(k, a) => {
            five_points(at_inflection_pole(&number(k), &angle(a)?), alternates)
        }
        // The mirror symmetry adds a sixth point.
        Closed::EqualCranks(k) => equal_cranks(&number(k))
            .map(|cranks| vec![Solution::of_cranks(&cranks, alternates, 5, &[])]),
        Closed::SliderCrank(crank, d, displacements) => {
            let linkage = slider_crank(crank, &angle(&crank.alpha_a)?, &angle(d)?, source);
            let joints = guide(&linkage).ok();
            let places: Vec<Place<K>> = displacements
                .iter()
                .filter_map(|s| Some(places(joints.as_ref()?, &number(s), None)))
                .flatten()
                .collect();
            of_slider_crank(&linkage, &linkage.infinitely_near())
                .map(|cranks| vec![Solution::of_cranks(&cranks, alternates, 4, &places)])
        }
        Closed::Intersection(crank, d, s) => {
            let linkage = slider_crank(crank, &angle(&crank.alpha_a)?, &angle(d)?, source);
            intersection(&linkage, &number(s), alternates)
        }
        Closed::Symmetrical(crank, epsilon) => {
            let alpha_a = angle(&crank.alpha_a)?;
            let half = angle(epsilon)?.half().cis();
            let rays = guide(&slider_crank(crank, &alpha_a, &alpha_a, source))
                .and_then(|_| rays_of_d(&number(&crank.k), &alpha_a));
            rays.map(|rays| {
                let of_ray = |alpha_d: &Angle<K>| {
                    let linkage = slider_crank(crank, &alpha_a, alpha_d, source);
                    Solution::symmetrical(&linkage, &half, None)
                };
                rays.iter().map(of_ray).collect()
            })
        }
        Closed::Watt(r, t, gamma, n, k) => {
            let watt = Watt {
                r: number(r),
                t: number(t),
                gamma: angle(gamma)?,
                n: *n,
                k: number(k),
            };
            alone(watt.design(), 2, Vec::new())
        }
        Closed::Evans([alpha, beta, omega], rho, k) => {
            let evans = Evans {
                alpha: angle(alpha)?,
                beta: angle(beta)?,
                omega: angle(omega)?,
                rho: number(rho),
                k: number(k),
            };
            alone(evans.design(), 0, crossing(evans.to_mirrored()))
        }
        Closed::Conchoid(r, alpha, k, n) => {
            let conchoid = Conchoid {
                r: number(r),
                alpha: angle(alpha)?,
                k: number(k),
                n: *n,
            };
            alone(conchoid.design(), 0, crossing(conchoid.to_mirrored()))
        }
        Closed::FourBar(given) => {
            let ([q, r, s, t, m], [epsilon, phi0], is_left) = given.as_ref();
            let lengths = Lengths {
                q: number(q),
                r: number(r),
                s: number(s),
                t: number(t),
                m: number(m),
                epsilon: angle(epsilon)?,
                phi0: angle(phi0)?,
            };
            alone(lengths.design(*is_left), 1, Vec::new())
        }
        Closed::Symmetric([a, c, d]) => {
            let symmetric = Symmetric {
                a: number(a),
                c: number(c),
                d: number(d),
            };
            alone(symmetric.design(), 1, Vec::new())
        }
    })
}

/// The slider-crank of a crank and a ray of D.
pub fn slider_crank<K: Real>(
    crank: &Crank,
    alpha_a: &Angle<K>,
    alpha_d: &Angle<K>,
    source: &impl Source<K>,
) -> SliderCrank<K> {
    SliderCrank {
        k: source.number(&crank.k),
        alpha_a: alpha_a.clone(),
        alpha_d: alpha_d.clone(),
    }
}

/// The positions of a slider-crank with its slider displaced, in both assemblies.
fn places<K: Real>(joints: &Joints<K>, s: &Number<K>, contact: Option<usize>) -> Vec<Place<K>> {
    let in_assembly = |assembly: Assembly| {
        let displaced = joints.displaced(s, assembly).ok()?;
        Some(Place {
            displaced: Some((s.clone(), assembly)),
            displacement: displaced.displacement,
            contact,
        })
    };
    Assembly::ALL.into_iter().filter_map(in_assembly).collect()
}

/// Ball's point and an intersection: for each assembly of the displaced slider-crank its own pins.
fn intersection<K: Real>(
    linkage: &SliderCrank<K>,
    s: &Number<K>,
    alternates: &[Alternate],
) -> Result<Vec<Solution<K>>, NoDesign> {
    let places = places(&guide(linkage)?, s, Some(0));
    if places.is_empty() {
        return Err(NoDesign::OutOfReach);
    }
    let with = |place: &Place<K>| {
        let fifth = linkage.apart(&place.displacement);
        let place = std::slice::from_ref(place);
        match of_slider_crank(linkage, &fifth) {
            Ok(cranks) => Solution::of_cranks(&cranks, alternates, 3, place),
            Err(reason) => Solution::none(&linkage.alpha_d, reason),
        }
    };
    Ok(places.iter().map(with).collect())
}

/// Another position in which D crosses the line, if there is one.
fn crossing<K: Real>(displacement: Option<Displacement<K>>) -> Vec<Place<K>> {
    let place = displacement.map(|displacement| Place {
        displaced: None,
        displacement,
        contact: Some(0),
    });
    place.into_iter().collect()
}

/// One linkage, without alternates.
fn alone<K: Real>(
    design: Result<Design<K>, NoDesign>,
    contact: usize,
    places: Vec<Place<K>>,
) -> Result<Vec<Solution<K>>, NoDesign> {
    let found = Found {
        alternate: None,
        design: Ok(design?),
        contact,
        places,
    };
    Ok(vec![Solution {
        rays: Vec::new(),
        linkages: vec![found],
    }])
}

impl<K: Real> Solution<K> {
    /// The four-bars of three cranks.
    pub fn of_cranks(
        cranks: &Cranks<K>,
        alternates: &[Alternate],
        contact: usize,
        places: &[Place<K>],
    ) -> Self {
        let [_, b, c] = &cranks.pairs;
        let found = |alternate: &Alternate| Found {
            alternate: Some(*alternate),
            design: cranks.design(*alternate),
            contact,
            places: places.to_vec(),
        };
        Solution {
            rays: vec![
                ("alpha_b", b.ray.clone()),
                ("alpha_c", c.ray.clone()),
                ("alpha_d", cranks.alpha_d.clone()),
            ],
            linkages: alternates.iter().map(found).collect(),
        }
    }

    /// A ray of D without a linkage.
    pub fn none(alpha_d: &Angle<K>, reason: NoDesign) -> Self {
        let found = Found {
            alternate: None,
            design: Err(reason),
            contact: 0,
            places: Vec::new(),
        };
        Solution {
            rays: vec![("alpha_d", alpha_d.clone())],
            linkages: vec![found],
        }
    }

    /// The four-bar with a symmetrical curve; its mirrored position, if the contact there is known.
    pub fn symmetrical(linkage: &SliderCrank<K>, half: &Point<K>, mirrored: Option<usize>) -> Self {
        let design = Symmetrical::new(linkage, half).design();
        let place = |design: &Design<K>| Place {
            displaced: None,
            displacement: design.to_mirrored(),
            contact: mirrored,
        };
        let found = Found {
            alternate: None,
            places: match &design {
                Ok(design) if mirrored.is_some() => vec![place(design)],
                _ => Vec::new(),
            },
            design,
            contact: 2,
        };
        Solution {
            rays: vec![("alpha_d", linkage.alpha_d.clone())],
            linkages: vec![found],
        }
    }

    /// Whether all numbers of it are held.
    pub fn is_whole(&self) -> bool {
        let rays = self.rays.iter().all(|(_, ray)| ray.cis().has_value());
        rays && self.linkages.iter().all(|found| match &found.design {
            Err(reason) => *reason != NoDesign::Undecided,
            Ok(design) => {
                let CouplerPoint {
                    pivots,
                    pins,
                    point,
                } = &design.linkage;
                pivots.iter().chain(pins).all(Number::has_value) && point.has_value()
            }
        })
    }
}
