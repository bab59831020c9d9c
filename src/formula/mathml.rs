//! A formula as presentation MathML (Core), for pages.

use super::function::Function;
use super::greek;
use super::level::Level;
use super::setting::{self, Style};
use super::symbol;

use super::tree::{Formula, Operator, Relation, Span, Tree};

/// The formula as a `<math>` element, its canonical text as the alternative.
pub fn mathml(formula: &Formula) -> String {
    let style = MathMl { marked: &[] };
    element_of(&formula.to_string(), &setting::formula(&style, formula))
}

/// One claim, definition or assumption as a `<math>` element; parts at these places are marked by the
/// class `differs`.
pub fn tree_mathml(tree: &Tree, marked: &[Span]) -> String {
    let set = setting::tree(&MathMl { marked }, tree, Level::For);
    element_of(&tree.to_string(), &set)
}

/// What a formula itself calls by a name, in the same way.
pub fn definition_mathml(name: &str, value: &Tree, marked: &[Span]) -> String {
    let set = setting::definition(&MathMl { marked }, name, value);
    element_of(&format!("{name} = {value}"), &set)
}

fn element_of(text: &str, set: &str) -> String {
    format!(
        "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\" \
         alttext=\"{}\"><mrow>{set}</mrow></math>",
        escaped(text)
    )
}

struct MathMl<'a> {
    marked: &'a [Span],
}

/// A text as XML takes it, in attributes too.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            _ => escaped.push(character),
        }
    }
    escaped
}

fn element(name: &str, text: &str) -> String {
    format!("<{name}>{}</{name}>", escaped(text))
}

fn upright(text: &str) -> String {
    format!("<mi mathvariant=\"normal\">{}</mi>", escaped(text))
}

fn operator(sign: &str) -> String {
    element("mo", sign)
}

/// One element, whatever is inside: scripts and fractions count their children.
fn row(inner: &str) -> String {
    format!("<mrow>{inner}</mrow>")
}

/// A stem or an index, a spelled Greek letter as its sign.
fn letters(text: &str) -> String {
    if let Some(sign) = greek::sign(text) {
        return element("mi", &sign.to_string());
    }
    if text.bytes().all(|byte| byte.is_ascii_digit()) {
        return element("mn", text);
    }
    element("mi", text)
}

/// The name of a function as it is printed.
fn function_name(function: Function) -> String {
    match function {
        Function::Angle => operator("∠"),
        Function::Re => element("mi", "Re"),
        Function::Im => element("mi", "Im"),
        Function::Sign => element("mi", "sgn"),
        // Names of several letters are set upright by themselves.
        _ => element("mi", function.name()),
    }
}

/// The sign between a function and its argument, which is heard and not seen.
const APPLICATION: &str = "<mo>\u{2061}</mo>";

/// Between the name of a function and what stands beside it without parentheses.
const THIN_SPACE: &str = "<mspace width=\"0.17em\"/>";

impl Style for MathMl<'_> {
    const SHAPED: bool = true;

    fn number(&self, text: &str) -> String {
        match text.split_once(['e', 'E']) {
            Some((mantissa, power)) => format!(
                "<mrow><mn>{mantissa}</mn><mo>·</mo><msup><mn>10</mn><mn>{}</mn></msup></mrow>",
                power.replace('-', "−")
            ),
            None => element("mn", text),
        }
    }

    fn pi(&self) -> String {
        upright("π")
    }

    fn imaginary_unit(&self) -> String {
        upright("i")
    }

    fn euler(&self) -> String {
        upright("e")
    }

    fn symbol(&self, name: &str) -> String {
        let parts = symbol::parts(name);
        let stem = letters(parts.stem);
        let primes = operator(&"′".repeat(parts.primes));
        match (parts.index.map(letters), parts.primes) {
            (None, 0) => stem,
            (None, _) => format!("<msup>{stem}{primes}</msup>"),
            (Some(index), 0) => format!("<msub>{stem}{index}</msub>"),
            (Some(index), _) => format!("<msubsup>{stem}{index}{primes}</msubsup>"),
        }
    }

    fn negative(&self, inner: &str) -> String {
        format!("{}{inner}", operator("−"))
    }

    fn binary(&self, binary: Operator, left: &str, right: &str) -> String {
        let sign = match binary {
            Operator::Add => "+",
            Operator::Sub => "−",
            Operator::Mul => "·",
            // The sign of a product that is heard and not seen.
            Operator::Juxtapose => "\u{2062}",
            Operator::PlusMinus => "±",
            Operator::MinusPlus => "∓",
            Operator::Div => return format!("<mfrac>{}{}</mfrac>", row(left), row(right)),
            Operator::Pow => return self.power(left, right),
        };
        format!("{left}{}{right}", operator(sign))
    }

    fn power(&self, base: &str, exponent: &str) -> String {
        format!("<msup>{}{}</msup>", row(base), row(exponent))
    }

    fn degrees(&self, inner: &str) -> String {
        format!("{inner}{}", operator("°"))
    }

    fn call(&self, function: Function, arguments: &[String]) -> String {
        match function {
            Function::Abs => self.fenced("|", arguments, "|"),
            Function::Sqrt => format!("<msqrt>{}</msqrt>", arguments.concat()),
            Function::Conj => format!(
                "<mover accent=\"true\">{}<mo stretchy=\"true\">¯</mo></mover>",
                row(&arguments.concat())
            ),
            _ => format!(
                "{}{APPLICATION}{}",
                function_name(function),
                self.fenced("(", arguments, ")")
            ),
        }
    }

    fn bare_call(&self, function: Function, exponent: Option<&str>, argument: &str) -> String {
        let name = function_name(function);
        let name = match exponent {
            Some(exponent) => format!("<msup>{name}{}</msup>", row(exponent)),
            None => name,
        };
        format!("{THIN_SPACE}{name}{APPLICATION}{THIN_SPACE}{argument}")
    }

    fn fenced(&self, open: &str, parts: &[String], close: &str) -> String {
        let fence = |sign: &str, form: &str| {
            format!("<mo fence=\"true\" stretchy=\"true\" form=\"{form}\">{sign}</mo>")
        };
        row(&format!(
            "{}{}{}",
            fence(open, "prefix"),
            parts.join(&operator(",")),
            fence(close, "postfix")
        ))
    }

    fn sum(&self, body: &str, name: &str, values: &str, bounds: Option<(&str, &str)>) -> String {
        let sign = operator("∑");
        let sign = match bounds {
            Some((first, last)) => format!(
                "<munderover>{sign}{}{}</munderover>",
                row(&format!("{name}{}{}", operator("="), element("mn", first))),
                element("mn", last)
            ),
            None => format!(
                "<munder>{sign}{}</munder>",
                row(&format!("{name}{}{values}", operator("∈")))
            ),
        };
        format!("{sign}{body}")
    }

    fn ratio(&self, parts: &[String]) -> String {
        parts.join(&operator(":"))
    }

    fn relation(&self, relation: Relation) -> String {
        operator(match relation {
            Relation::Proportional => "∼",
            _ => relation.sign(),
        })
    }

    fn word(&self, word: &str) -> String {
        format!("<mtext>\u{a0}{word}\u{a0}</mtext>")
    }

    fn separator(&self, sign: &str) -> String {
        format!("{}<mspace width=\"1em\"/>", operator(sign))
    }

    fn sign(&self, sign: &str) -> String {
        operator(match sign {
            "in" => "∈",
            _ => sign,
        })
    }

    fn marked(&self, part: &Tree, set: String) -> String {
        if self.marked.contains(&part.span) {
            return format!("<mrow class=\"differs\">{set}</mrow>");
        }
        set
    }
}
