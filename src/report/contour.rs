//! The points of a window where a function vanishes, by marching squares.

use super::canvas::Point;

/// Squares along each side of the window.
const CELLS: u32 = 240;

/// Short pieces of the curve f = 0.
pub fn zero_set(f: impl Fn(Point) -> f64, (low, high): (Point, Point)) -> Vec<[Point; 2]> {
    let at = |i: u32, j: u32| -> Point {
        let part =
            |k: u32, low: f64, high: f64| low + (high - low) * f64::from(k) / f64::from(CELLS);
        [part(i, low[0], high[0]), part(j, low[1], high[1])]
    };
    let mut pieces = Vec::new();
    for i in 0..CELLS {
        for j in 0..CELLS {
            let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            let corners = corners.map(|at| (at, f(at)));
            let next = corners.iter().cycle().skip(1);
            let mut crossings: Vec<Point> = Vec::new();
            for ((p, a), (q, b)) in corners.iter().zip(next) {
                if (*a < 0.0) != (*b < 0.0) {
                    let share = a / (a - b);
                    crossings.push([p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])]);
                }
            }
            pieces.extend(crossings.as_chunks().0);
        }
    }
    pieces
}
