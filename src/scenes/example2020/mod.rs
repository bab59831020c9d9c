//! The example of `CONTRIBUTING.md`: in no list of scenes, but compiled and built by the tests.

pub(super) mod circle;

#[cfg(test)]
mod tests {
    use super::circle::SCENE;
    use crate::formula::{evaluate, read};
    use crate::number::Truth;
    use crate::scenes::free::{Random, Symbols};

    #[test]
    fn the_documentation_shows_this_file() {
        let shown = include_str!("../../../CONTRIBUTING.md");
        assert!(shown.contains(include_str!("circle.rs")));
    }

    #[test]
    fn the_point_is_on_this_circle_and_on_no_other() {
        let symbols = (SCENE.symbolic)(&mut Symbols::default()).unwrap();
        let on = evaluate(&read("z conj(z) = r^2").unwrap(), &symbols).unwrap();
        assert_eq!(on.holds, Truth::Yes);
        let numbers = (SCENE.exact)(&mut Random::new(1)).unwrap();
        let off = evaluate(&read("z conj(z) = r").unwrap(), &numbers).unwrap();
        assert_eq!(off.holds, Truth::No);
    }
}
