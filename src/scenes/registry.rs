//! The lists of all scenes, checks and tables.

use super::check::Check;
use super::scene::Scene;
use super::table::Table;
use super::{filemon1970, filemon1973, kaufman, tesar1964, wunderlich1968};

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
        filemon1970::visual_angles::RIGHT_ANGLES,
        filemon1970::visual_angles::SCENE,
        filemon1970::asymptote::ANY_DIRECTION,
        filemon1970::asymptote::SCENE,
        filemon1970::asymptote::ANGLE,
        filemon1970::both_asymptotes::SCENE,
        filemon1970::two_positions::SCENE,
        filemon1970::pole_system::SCENE,
        filemon1970::characteristic_points::SCENE,
        filemon1970::characteristic_points::CENTERS,
        filemon1970::construction::SCENE,
        filemon1970::construction::BOTH_PLACES,
        filemon1970::infinite_links::CENTER,
        filemon1970::infinite_links::CIRCLEPOINT,
        filemon1973::pole_quadrilateral::SCENE,
        filemon1973::oblique_axes::SCENE,
        filemon1973::sides_and_tangents::SCENE,
        filemon1973::slopes::SCENE,
        filemon1973::any_shape::SCENE,
        filemon1973::tangents_of_pairs::SCENE,
        filemon1973::node::ADJACENT,
        filemon1973::node::OPPOSITE,
        filemon1973::node::BISECTORS,
        filemon1973::nodal_curve::SCENE,
        filemon1973::kite::SCENE,
        filemon1973::kite::TANGENTS,
        filemon1973::focus::SCENE,
        tesar1964::coupler_point::SCENE,
        tesar1964::coupler_point::INFLECTION,
        tesar1964::four_bar::SCENE,
        tesar1964::four_bar::BALL,
        tesar1964::burmester_points::SCENE,
        tesar1964::ball_burmester::SCENE,
        tesar1964::ball_burmester::DOUBLE,
        tesar1964::slider_crank::SCENE,
        tesar1964::inflection_pole::SCENE,
        tesar1964::inflection_pole::EQUAL_CRANKS,
        tesar1964::inflection_pole::DOUBLE,
        tesar1964::moving_plane::SCENE,
        tesar1964::circlepoint::SCENE,
        tesar1964::circlepoint::THREE_PLACES,
        tesar1964::burmester_pair::SCENE,
        tesar1964::burmester_pair::ANY_START,
        tesar1964::point_on_a_line::SCENE,
        tesar1964::five_positions::SCENE,
        tesar1964::conics::ELIMINANT,
        tesar1964::conics::KNOWN_ROOTS,
        tesar1964::conics::COMMON_POINT,
        tesar1964::five_positions_on_a_line::SCENE,
        tesar1964::origin_on_the_axis::SCENE,
        tesar1964::known_center::SCENE,
        tesar1964::positions_on_a_line::SCENE,
        tesar1964::travel::SCENE,
        tesar1964::coupler_triangle::SCENE,
        tesar1964::coupler_triangle::FIXED_LINK,
        tesar1964::symmetric_curve::SCENE,
        tesar1964::symmetric_alternate::SCENE,
        tesar1964::stationary_points::CRANK,
        tesar1964::stationary_points::SCENE,
        tesar1964::displaced_coupler::SCENE,
        tesar1964::second_position::SCENE,
        tesar1964::second_position::TANGENT,
        tesar1964::displaced_coupler::DEVIATION,
        tesar1964::one_intersection::SCENE,
        tesar1964::watt::SCENE,
        tesar1964::watt::ANY_POINT,
        tesar1964::evans::SCENE,
        tesar1964::evans::NORMAL,
        tesar1964::evans::AXIS,
        tesar1964::evans::SPECIAL,
        tesar1964::conchoid::CURVE,
        tesar1964::conchoid::SCENE,
        tesar1964::conchoid::FIXED_LINK,
        tesar1964::symmetric_linkage::SCENE,
        tesar1964::precision_points::SCENE,
        tesar1964::drawn_four_bar::SCENE,
        tesar1964::tangent_of_the_path::SCENE,
        tesar1964::grashof::SCENE,
        tesar1964::grashof::IN_ORDER,
        tesar1964::type_of_mechanism::SCENE,
        tesar1964::transmission_angle::SCENE,
        tesar1964::input_output::SCENE,
        tesar1964::dead_centres::TURNING_COUPLER,
        tesar1964::dead_centres::DOUBLE_LEVER,
        tesar1964::program::LINKAGE,
        tesar1964::program::LEVEL,
        tesar1964::program::ROW,
        tesar1964::figures::ball_burmester::DOUBLE,
        tesar1964::figures::ball_burmester::FIRST,
        tesar1964::figures::ball_burmester::SECOND,
        tesar1964::figures::ball_burmester::INFLECTION_POLE,
        tesar1964::figures::precision_points::SCENE,
        tesar1964::figures::watt::SCENE,
        tesar1964::figures::symmetric::SCENE,
        tesar1964::figures::evans::SCENE,
        kaufman::poles::SCENE,
        kaufman::two_poles::SCENE,
        kaufman::dyad::SCENE,
        kaufman::three_positions::SCENE,
        kaufman::compatibility_triangle::SCENE,
        kaufman::circuits::SCENE,
        kaufman::linear_equations::TWO,
        kaufman::linear_equations::DEPENDENT,
        kaufman::linear_equations::THREE,
        kaufman::linear_equations::THREE_UNKNOWNS,
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
        tesar1964::contact_properties::INFLECTIONS,
        tesar1964::contact_properties::STATIONARY,
        tesar1964::alternates::SIX,
        tesar1964::alternates::NINE,
        tesar1964::symmetric_curve::CHECK,
        tesar1964::five_position_pairs::FOUR,
        tesar1964::five_position_pairs::SIX,
        tesar1964::places_on_a_line::COLLINEAR,
        tesar1964::places_on_a_line::ONE_POINT,
        tesar1964::grashof_rules::CHECK,
        tesar1964::crank_error::COMPENSATION,
        kaufman::opposite_pole_pairs::CHECK,
        kaufman::equal_angles::CENTERPOINTS,
        kaufman::equal_angles::CIRCLEPOINTS,
        kaufman::construction_from_an_angle::CHECK,
        kaufman::compatibility_determinant::CHECK,
        kaufman::which_can_be_solved::EQUATIONS,
        kaufman::which_can_be_solved::UNKNOWNS,
        filemon1973::discriminant::CHECK,
        filemon1973::inner_arcs::CHECK,
        filemon1973::convex_quadrilateral::CHECK,
        filemon1973::focus_divides::CHECK,
        filemon1973::inflexions::CHECK,
        filemon1973::even_branch::CHECK,
        filemon1973::disintegrating::CHECK,
        filemon1970::same_type::CHECK,
        filemon1970::twelve_links::CHECK,
    ]
}

/// The check of this name.
pub fn find_check(name: &str) -> Option<&'static Check> {
    checks().iter().find(|check| check.name == name)
}

/// All tables, grouped by source.
pub fn tables() -> &'static [Table] {
    &[filemon1973::tables::TANGENTS, filemon1973::tables::CASES]
}

/// The table of this name.
pub fn find_table(name: &str) -> Option<&'static Table> {
    tables().iter().find(|table| table.name == name)
}
