#![doc = include_str!("grammar.md")]

mod bindings;
mod cis;
mod compare;
mod consequence;
mod difference;
mod error;
mod evaluate;
pub mod function;
mod greek;
mod latex;
mod level;
mod lexer;
mod mathml;
mod mutant;
mod normal_form;
mod operate;
mod reader;
mod running;
mod setting;
mod symbol;
mod text;
pub mod tree;
mod value;

pub use bindings::Bindings;
pub use consequence::follows;
pub use difference::{Difference, difference};
pub use error::ReadError;
pub use evaluate::{Failure, Outcome, evaluate, evaluate_expression};
pub use function::Function;
pub use latex::{latex, tree_latex};
pub use mathml::{definition_mathml, mathml, tree_mathml};
pub use mutant::{Mutant, mutants};
pub use normal_form::normal_form;
pub use reader::{DEPTH_LIMIT, LENGTH_LIMIT, NESTING_LIMIT, read};
pub use tree::{Formula, Node, Relation, Tree};
pub use value::Value;
