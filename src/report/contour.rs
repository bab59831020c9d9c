//! The points of a window where a function vanishes, by marching squares.

use super::canvas::Point;

/// Squares along each side of the window.
const CELLS: usize = 240;

/// Short pieces of the curve f = 0.
pub fn zero_set(f: impl Fn(Point) -> f64, (low, high): (Point, Point)) -> Vec<[Point; 2]> {
    let at = |i: usize, j: usize| -> Point {
        let part =
            |k: usize, axis: usize| low[axis] + (high[axis] - low[axis]) * k as f64 / CELLS as f64;
        [part(i, 0), part(j, 1)]
    };
    let mut pieces = Vec::new();
    for i in 0..CELLS {
        for j in 0..CELLS {
            let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            let values = corners.map(&f);
            let mut crossings = Vec::new();
            for k in 0..4 {
                let (a, b) = (values[k], values[(k + 1) % 4]);
                if (a < 0.0) != (b < 0.0) {
                    let share = a / (a - b);
                    let (p, q) = (corners[k], corners[(k + 1) % 4]);
                    crossings.push([p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])]);
                }
            }
            for pair in crossings.chunks_exact(2) {
                pieces.push([pair[0], pair[1]]);
            }
        }
    }
    pieces
}
