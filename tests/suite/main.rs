//! All tests, one file a subject, as one program: linked once, run on all cores.

mod fuzz;
mod support;

mod architecture;
mod ball_soundness;
mod certificates;
#[cfg(feature = "command")]
mod chart;
#[cfg(feature = "command")]
mod command;
mod conditions;
mod crank_drive;
mod curvature;
mod curvature_problem;
mod degenerate_kinds;
mod dependencies;
mod deviation;
#[cfg(feature = "command")]
mod examples;
mod finite_constructions;
mod finite_pole_four_bar;
mod five_positions;
mod five_positions_routes;
mod floats;
mod focal_mechanism;
mod formula_evaluation;
mod formula_mutants;
mod formula_syntax;
mod four_bar;
mod four_positions;
mod fuzzed;
mod gallery;
mod identities;
mod laws;
mod linkages;
mod mixed_positions;
mod passage;
mod plane;
mod plane_curves;
mod poly;
#[cfg(feature = "command")]
mod robustness;
mod scenes;
#[cfg(feature = "command")]
mod schemas;
#[cfg(feature = "command")]
mod score;
mod setting;
mod straight_line;
mod stretches;
mod tables;
mod univariate;
mod vectors;
mod verdicts;
