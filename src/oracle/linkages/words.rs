//! What is wrong with a linkage, in words.

use super::facts::Facts;
use crate::linkage::passage::{Degenerate, Type};

/// The name of a type.
pub fn name(kind: Type) -> &'static str {
    match kind {
        Type::CrankAndLever => "crank-and-lever",
        Type::DragLink => "drag-link",
        Type::GrashofDoubleLever | Type::DoubleLever => "double-lever",
        Type::ChangePoint => "change-point",
        Type::SliderCrank => "slider-crank",
        Type::SliderRocker => "slider-rocker",
        Type::InvertedSliderCrank => "inverted-slider-crank",
        Type::InvertedSliderRocker => "inverted-slider-rocker",
        Type::DoubleSlider => "double-slider",
        Type::TwoTurningBlocks => "two-turning-blocks",
        Type::SliderAndTurningBlock => "slider-and-turning-block",
    }
}

/// Why the linkage does not pass through all positions, and what else is wrong with it.
pub fn defects(facts: &Facts) -> Vec<String> {
    let degenerate = facts.degenerate.iter().flatten().map(|what| match what {
        Degenerate::SameCenter => "both pairs have the same center: the coupler only turns about it",
        Degenerate::SameCirclepoint => {
            "both pairs have the same circlepoint: a coupler of length 0, nothing moves but about it"
        }
        Degenerate::LinkOfNoLength => "a circlepoint lies in its center: a link of length 0",
        Degenerate::Parallel => "both slides are parallel: the coupler does not turn",
    });
    let mut list: Vec<String> = degenerate.map(str::to_owned).collect();
    if facts.link_type == Some(Type::ChangePoint) {
        list.push(
            "change point: all links can lie on one line, where the motion is not determined"
                .into(),
        );
    }
    let elsewhere = facts.circuit.as_deref().and_then(others);
    if let Some((named, many)) = elsewhere {
        let verb = if many { "need" } else { "needs" };
        list.push(format!("{named} {verb} the other assembly"));
        return list;
    }
    for (driven, link) in facts.drives.iter().zip(["first", "second"]) {
        if let Some((named, many)) = driven.branch.as_deref().and_then(others) {
            let verb = if many { "lie" } else { "lies" };
            list.push(format!(
                "driven at the {link} pair, {named} {verb} beyond a dead centre"
            ));
        }
    }
    list
}

/// The positions that are not reached, and whether they are many; `None` where there are none.
fn others(reached: &[bool]) -> Option<(String, bool)> {
    let numbers: Vec<String> = reached
        .iter()
        .enumerate()
        .filter(|(_, reached)| !**reached)
        .map(|(place, _)| (place + 1).to_string())
        .collect();
    match numbers.as_slice() {
        [] => None,
        [one] => Some((format!("position {one}"), false)),
        many => Some((format!("positions {}", many.join(", ")), true)),
    }
}
