//! What moves in a picture: nothing does until it is told to begin.

use std::fmt::Write;

use super::canvas::Point;

/// How long the whole way takes.
const SECONDS: u32 = 8;

/// A line that goes through these places.
pub fn line(svg: &mut String, places: &[[Point; 2]], look: &str) {
    let path = |[[x, y], [u, v]]: &[Point; 2]| format!("M{x:.1} {y:.1}L{u:.1} {v:.1}");
    let Some(first) = places.first() else { return };
    let values: Vec<String> = places.iter().map(path).collect();
    // Writing to a string cannot fail.
    let _ = writeln!(
        svg,
        r#"<path d="{}" fill="none" {look}><animate attributeName="d" values="{}" dur="{SECONDS}s" begin="indefinite" repeatCount="indefinite"/></path>"#,
        path(first),
        values.join(";")
    );
}

/// What has been drawn at the first of these places goes through all of them.
pub fn joint(svg: &mut String, places: &[Point]) {
    let Some([x, y]) = places.first() else { return };
    let values: Vec<String> = places
        .iter()
        .map(|[u, v]| format!("{:.1} {:.1}", u - x, v - y))
        .collect();
    let _ = write!(
        svg,
        r#"<animateTransform attributeName="transform" type="translate" values="{}" dur="{SECONDS}s" begin="indefinite" repeatCount="indefinite"/>"#,
        values.join(";")
    );
}
