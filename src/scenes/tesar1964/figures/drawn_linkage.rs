//! Linkages of the figures in floats, for pictures: those that no problem asks for.

use rug::Rational;

use super::super::sense::sense;
use super::super::symmetric_linkage::central_position;
use super::results::COARSE;
use super::{evans, precision_points};
use crate::number::Number;
use crate::scenes::{Free, Unbuilt};
use crate::straight_line::design::Design;

/// A linkage with the levels up to which its deviation counts.
pub type DrawnLinkage = Result<(Design<f64>, Vec<f64>), Unbuilt>;

/// The linkage of a scene of the figures, with these parameters; `None` for other scenes.
pub fn drawn_linkage(scene: &str, free: &mut dyn Free<f64>) -> Option<DrawnLinkage> {
    let design = match scene {
        "tesar1964/evans-figure" => rolling(free),
        "tesar1964/symmetric-figure" => symmetric(free),
        "tesar1964/burmester-figure" => precision_points::measured(free).map(|(design, _)| design),
        _ => return None,
    };
    let levels = COARSE.map(|ratio| Rational::from(ratio).to_f64());
    Some(design.map(|design| (design, levels.to_vec())))
}

fn rolling(free: &mut dyn Free<f64>) -> Result<Design<f64>, Unbuilt> {
    let omega = free.angle("omega")?;
    let (rho, k) = (free.number("rho")?, free.number("k")?);
    evans::design(&omega, &rho, &k).map_err(|reason| Unbuilt::NotReal(reason.to_string()))
}

fn symmetric(free: &mut dyn Free<f64>) -> Result<Design<f64>, Unbuilt> {
    let half = free.length("|a|")?;
    let sense = sense(free, "sign of a")?;
    let (c, d) = (free.number("c")?, free.number("d")?);
    Ok(Design {
        linkage: central_position(&half, &sense, &c, &d),
        direction: Number::one(),
    })
}
