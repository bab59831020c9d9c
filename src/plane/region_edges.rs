//! Where a region ends.

use super::region::{Region, edges};
use super::{Point, relation};
use crate::number::{Kind, Number};

impl<K: Kind> Region<K> {
    /// Functions of a point of which one at least vanishes on the boundary: the distances from the lines
    /// along the edges, the power with respect to the circle.
    pub fn edges(&self, point: &Point<K>) -> Vec<Number<K>> {
        match self {
            Region::Box(corners) => {
                let from = corners.iter().map(|corner| point - corner);
                from.flat_map(|v| [v.re().clone(), v.im().clone()])
                    .collect()
            }
            Region::Circle { center, radius } => {
                vec![relation::distance_squared(point, center) - radius.square()]
            }
            Region::Polygon(vertices) => edges(vertices)
                .map(|(a, b)| relation::twice_area(a, b, point))
                .collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Exact, Truth};

    fn point(x: i64, y: i64) -> Point<Exact> {
        Number::complex(x.into(), y.into())
    }

    #[test]
    fn on_the_boundary_an_edge_vanishes() {
        let corners = [(0, 0), (8, 0), (8, 8), (4, 2)].map(|(x, y)| point(x, y));
        for (region, on, off) in [
            (Region::Box([point(8, 0), point(0, 8)]), (8, 3), (7, 3)),
            (
                Region::Circle {
                    center: point(1, 0),
                    radius: 5.into(),
                },
                (4, 4),
                (4, 3),
            ),
            (Region::Polygon(corners.to_vec()), (6, 5), (6, 4)),
        ] {
            let vanishes = |(x, y)| {
                let edges = region.edges(&point(x, y));
                Truth::any(edges.iter().map(Number::is_zero))
            };
            assert!(vanishes(on).is_yes(), "{region:?}");
            assert!(vanishes(off).is_no(), "{region:?}");
        }
    }
}
