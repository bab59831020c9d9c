//! The canonical text of a formula: it reads back as the same tree.

use std::fmt;

use super::function::Function;
use super::level::Level;
use super::setting::{self, Style};
use super::tree::{Formula, Operator, Relation, Tree};

impl fmt::Display for Formula {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&setting::formula(&Text, self))
    }
}

impl fmt::Display for Tree {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&setting::tree(&Text, self, Level::For))
    }
}

/// The canonical text.
struct Text;

impl Style for Text {
    const SHAPED: bool = false;

    fn number(&self, text: &str) -> String {
        text.to_string()
    }

    fn pi(&self) -> String {
        "pi".to_string()
    }

    fn imaginary_unit(&self) -> String {
        "i".to_string()
    }

    fn euler(&self) -> String {
        "e".to_string()
    }

    fn symbol(&self, name: &str) -> String {
        name.to_string()
    }

    fn negative(&self, inner: &str) -> String {
        format!("-{inner}")
    }

    fn binary(&self, operator: Operator, left: &str, right: &str) -> String {
        let sign = match operator {
            Operator::Add => " + ",
            Operator::Sub => " - ",
            Operator::Mul => " * ",
            Operator::Juxtapose => " ",
            Operator::Div => "/",
            Operator::Pow => "^",
            Operator::PlusMinus => " ± ",
            Operator::MinusPlus => " ∓ ",
        };
        format!("{left}{sign}{right}")
    }

    fn power(&self, base: &str, exponent: &str) -> String {
        format!("{base}^{exponent}")
    }

    fn degrees(&self, inner: &str) -> String {
        format!("{inner} deg")
    }

    fn call(&self, function: Function, arguments: &[String]) -> String {
        format!("{}({})", function.name(), arguments.join(", "))
    }

    fn bare_call(&self, function: Function, exponent: Option<&str>, argument: &str) -> String {
        let exponent = exponent.map_or(String::new(), |exponent| format!("^{exponent}"));
        format!("{}{exponent} {argument}", function.name())
    }

    fn fenced(&self, open: &str, parts: &[String], close: &str) -> String {
        format!("{open}{}{close}", parts.join(", "))
    }

    fn sum(&self, body: &str, name: &str, values: &str, _: Option<(&str, &str)>) -> String {
        format!("sum({body} for {name} in {values})")
    }

    fn ratio(&self, parts: &[String]) -> String {
        parts.join(" : ")
    }

    fn relation(&self, relation: Relation) -> String {
        format!(" {} ", relation.sign())
    }

    fn word(&self, word: &str) -> String {
        format!(" {word} ")
    }

    fn separator(&self, sign: &str) -> String {
        format!("{sign} ")
    }

    fn sign(&self, sign: &str) -> String {
        format!(" {sign} ")
    }
}
