//! A formula as LaTeX, for math mode with the commands of amsmath.

use super::function::Function;
use super::greek;
use super::level::Level;
use super::setting::{self, Style};
use super::symbol;
use super::tree::{Formula, Operator, Relation, Tree};

/// The formula as LaTeX, without the signs that open math mode.
pub fn latex(formula: &Formula) -> String {
    setting::formula(&Latex, formula)
}

/// A part of a formula as LaTeX.
pub fn tree_latex(tree: &Tree) -> String {
    setting::tree(&Latex, tree, Level::For)
}

struct Latex;

/// A stem or an index: one letter slanted, a spelled Greek letter as its sign, several letters as
/// one word.
fn letters(text: &str) -> String {
    if let Some(command) = greek::command(text) {
        return command;
    }
    if text.len() > 1 && text.bytes().all(|byte| byte.is_ascii_alphabetic()) {
        return format!("\\mathit{{{text}}}");
    }
    text.to_string()
}

/// The name of a function as a command.
fn function_command(function: Function) -> String {
    match function {
        Function::Sin
        | Function::Cos
        | Function::Tan
        | Function::Cot
        | Function::Arcsin
        | Function::Arccos
        | Function::Arctan
        | Function::Min
        | Function::Max
        | Function::Arg
        | Function::Det => format!("\\{}", function.name()),
        Function::Angle => "\\angle".to_string(),
        Function::Re => "\\operatorname{Re}".to_string(),
        Function::Im => "\\operatorname{Im}".to_string(),
        Function::Sign => "\\operatorname{sgn}".to_string(),
        _ => format!("\\operatorname{{{}}}", function.name()),
    }
}

impl Style for Latex {
    const SHAPED: bool = true;

    fn number(&self, text: &str) -> String {
        match text.split_once(['e', 'E']) {
            Some((mantissa, power)) => format!("{mantissa} \\cdot 10^{{{power}}}"),
            None => text.to_string(),
        }
    }

    fn pi(&self) -> String {
        "\\pi".to_string()
    }

    fn imaginary_unit(&self) -> String {
        "\\mathrm{i}".to_string()
    }

    fn euler(&self) -> String {
        "\\mathrm{e}".to_string()
    }

    fn symbol(&self, name: &str) -> String {
        let parts = symbol::parts(name);
        let mut set = letters(parts.stem);
        if let Some(index) = parts.index {
            set += &format!("_{{{}}}", letters(index));
        }
        set + &"'".repeat(parts.primes)
    }

    fn negative(&self, inner: &str) -> String {
        format!("-{inner}")
    }

    fn binary(&self, operator: Operator, left: &str, right: &str) -> String {
        match operator {
            Operator::Add => format!("{left} + {right}"),
            Operator::Sub => format!("{left} - {right}"),
            Operator::Mul => format!("{left} \\cdot {right}"),
            Operator::Juxtapose => format!("{left} \\, {right}"),
            Operator::Div => format!("\\frac{{{left}}}{{{right}}}"),
            Operator::Pow => self.power(left, right),
            Operator::PlusMinus => format!("{left} \\pm {right}"),
            Operator::MinusPlus => format!("{left} \\mp {right}"),
        }
    }

    fn power(&self, base: &str, exponent: &str) -> String {
        // A prime is a superscript already; braces keep a second one apart.
        if base.contains(['\'', '^']) {
            return format!("{{{base}}}^{{{exponent}}}");
        }
        format!("{base}^{{{exponent}}}")
    }

    fn degrees(&self, inner: &str) -> String {
        format!("{inner}^{{\\circ}}")
    }

    fn call(&self, function: Function, arguments: &[String]) -> String {
        let inner = arguments.join(", ");
        match function {
            Function::Abs => format!("\\left| {inner} \\right|"),
            Function::Sqrt => format!("\\sqrt{{{inner}}}"),
            Function::Conj => format!("\\overline{{{inner}}}"),
            _ => format!(
                "{}{}",
                function_command(function),
                self.fenced("(", arguments, ")")
            ),
        }
    }

    fn bare_call(&self, function: Function, exponent: Option<&str>, argument: &str) -> String {
        let exponent = exponent.map_or(String::new(), |exponent| format!("^{{{exponent}}}"));
        format!("{}{exponent} {argument}", function_command(function))
    }

    fn fenced(&self, open: &str, parts: &[String], close: &str) -> String {
        let brace = |fence: &str| match fence {
            "{" | "}" => format!("\\{fence}"),
            _ => fence.to_string(),
        };
        format!(
            "\\left{} {} \\right{}",
            brace(open),
            parts.join(", "),
            brace(close)
        )
    }

    fn sum(&self, body: &str, name: &str, values: &str, bounds: Option<(&str, &str)>) -> String {
        match bounds {
            Some((first, last)) => format!("\\sum_{{{name} = {first}}}^{{{last}}} {body}"),
            None => format!("\\sum_{{{name} \\in {values}}} {body}"),
        }
    }

    fn ratio(&self, parts: &[String]) -> String {
        parts.join(" : ")
    }

    fn relation(&self, relation: Relation) -> String {
        let command = match relation {
            Relation::Equal => "=",
            Relation::NotEqual => "\\ne",
            Relation::Less => "<",
            Relation::LessOrEqual => "\\le",
            Relation::Greater => ">",
            Relation::GreaterOrEqual => "\\ge",
            Relation::Alike => "\\gtrless",
            Relation::Opposite => "\\lessgtr",
            Relation::Congruent => "\\equiv",
            Relation::Proportional => "\\sim",
        };
        format!(" {command} ")
    }

    fn word(&self, word: &str) -> String {
        format!(" \\;\\text{{{word}}}\\; ")
    }

    fn separator(&self, sign: &str) -> String {
        match sign {
            ";" => "; \\quad ".to_string(),
            _ => format!("{sign} \\; "),
        }
    }

    fn sign(&self, sign: &str) -> String {
        match sign {
            "in" => " \\in ".to_string(),
            _ => format!(" {sign} "),
        }
    }
}
