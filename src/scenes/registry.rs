//! The tables of all scenes and checks.

use super::check::Check;
use super::scene::Scene;
use super::{filemon1973, tesar1964, wunderlich1968};

/// All scenes, grouped by source.
pub fn scenes() -> &'static [Scene] {
    &[
        wunderlich1968::five_bar::SCENE,
        wunderlich1968::coupler::SCENE,
        wunderlich1968::focal_mechanism::SCENE,
        wunderlich1968::completion::SCENE,
        wunderlich1968::figure::SCENE,
        wunderlich1968::figure::ANY_SHAPE,
        wunderlich1968::point_of_the_cubic::SCENE,
        wunderlich1968::point_of_the_cubic::QUADRILATERAL,
        wunderlich1968::focal_cubic::SCENE,
        wunderlich1968::focal_cubic::PARALLELOGRAM,
        wunderlich1968::revolving_coupler::SCENE,
        wunderlich1968::symmetric_crank_drive::SCENE,
        wunderlich1968::symmetric_position::SCENE,
        wunderlich1968::hart::SCENE,
        wunderlich1968::hart_kite::SCENE,
        filemon1973::pole_quadrilateral::SCENE,
        tesar1964::slider_crank::SCENE,
    ]
}

/// The scene of this name.
pub fn find(name: &str) -> Option<&'static Scene> {
    scenes().iter().find(|scene| scene.name == name)
}

/// All checks, grouped by source.
pub fn checks() -> &'static [Check] {
    &[
        wunderlich1968::keeps_lengths::CHECK,
        wunderlich1968::order::CHECK,
        wunderlich1968::foci::CHECK,
        wunderlich1968::every_point::CHECK,
        wunderlich1968::quadratics::CHECK,
    ]
}

/// The check of this name.
pub fn find_check(name: &str) -> Option<&'static Check> {
    checks().iter().find(|check| check.name == name)
}
