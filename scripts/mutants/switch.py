"""Puts many mutants into one program, each behind a switch.

A mutant of cargo-mutants is a place and a text that takes its place. Here the changed expression stands
beside the one it replaces, `if mutated(17) { changed } else { original }`, so that one build holds all.
"""

import dataclasses

import tree_sitter_rust
from tree_sitter import Language, Parser

PARSER = Parser(Language(tree_sitter_rust.language()))
SWITCH = "crate::mutated::mutated"

MODULE = """//! Which mutant is switched on: the number in BURMESTER_MUTANT. With BURMESTER_REACHED set to a
//! file, the numbers of all that are reached are appended to it instead.
use std::io::Write;
use std::sync::{LazyLock, Mutex};
static CHOSEN: LazyLock<Option<usize>> =
    LazyLock::new(|| std::env::var("BURMESTER_MUTANT").ok()?.parse().ok());
static REACHED: LazyLock<Option<String>> = LazyLock::new(|| std::env::var("BURMESTER_REACHED").ok());
static SEEN: Mutex<Vec<usize>> = Mutex::new(Vec::new());
/// Whether this one is.
pub fn mutated(number: usize) -> bool {
    if let Some(file) = &*REACHED {
        let mut seen = SEEN.lock().unwrap();
        if !seen.contains(&number) {
            seen.push(number);
            let mut file = std::fs::OpenOptions::new().create(true).append(true).open(file).unwrap();
            file.write_all(format!("{number}\\n").as_bytes()).unwrap();
        }
        return false;
    }
    *CHOSEN == Some(number)
}
"""


@dataclasses.dataclass
class Edit:
    """Bytes from..to of a file become `text`; `lines` is what an error of the compiler may point at."""

    start: int
    end: int
    text: str
    lines: range
    number: int = 0


class NoSwitch(Exception):
    """The mutant cannot stand beside the original."""


def one_line(text):
    """Line numbers must stay, so that errors of the compiler can be told apart."""
    if "//" in text or "\\\n" in text or '"' in text and "\n" in text:
        raise NoSwitch("a comment or a text over several lines")
    return " ".join(text.split("\n"))


class File:
    """A source file and the places in it."""

    def __init__(self, source):
        self.source = source
        self.lines = source.split(b"\n")
        self.tree = PARSER.parse(source)

    def offset(self, place):
        line = self.lines[place["line"] - 1].decode()
        before = sum(len(l) + 1 for l in self.lines[: place["line"] - 1])
        return before + len(line[: place["column"] - 1].encode())

    def text(self, start, end):
        return self.source[start:end].decode()

    def edit(self, mutant):
        """The edit that brings a mutant in, `{n}` standing for its number."""
        start, end = (self.offset(mutant["span"][side]) for side in ("start", "end"))
        change = {
            "FnValue": self.value,
            "BinaryOperator": self.operator,
            "UnaryOperator": self.operator,
            "MatchArm": self.arm,
            "MatchArmGuard": self.guard,
            "StructField": self.field,
        }[mutant["genre"]]
        return change(start, end, mutant["replacement"])

    def node(self, start, end):
        return self.tree.root_node.descendant_for_byte_range(start, end)

    def made(self, start, end, text):
        first = self.source.count(b"\n", 0, start) + 1
        last = self.source.count(b"\n", 0, end) + 1
        return Edit(start, end, text, range(first, last + 1))

    def value(self, start, end, replacement):
        function = self.node(start, end)
        while function and function.type != "function_item":
            function = function.parent
        modifiers = self.text(function.start_byte, function.child_by_field_name("name").start_byte)
        if "const" in modifiers.split():
            raise NoSwitch("a constant function")
        edit = self.made(start, start, f"if {SWITCH}({{n}}) {{{{ return {braced(replacement)}; }}}} ")
        last = self.source.count(b"\n", 0, end) + 1
        edit.lines = range(function.start_point[0] + 1, last + 1)
        return edit

    def operator(self, start, end, replacement):
        node = self.node(start, end)
        while node.type not in ("binary_expression", "unary_expression", "compound_assignment_expr"):
            if node.parent is None:
                raise NoSwitch("no expression")
            node = node.parent
        while node.parent is not None and node.parent.type == "binary_expression":
            node = node.parent
        changed = self.text(node.start_byte, start) + replacement + self.text(end, node.end_byte)
        original = self.text(node.start_byte, node.end_byte)
        text = f"(if {SWITCH}({{n}}) {{{{ {braced(one_line(changed))} }}}} else {{{{ {braced(original)} }}}})"
        return self.made(node.start_byte, node.end_byte, text)

    def exchange(self, old, new):
        """The edit that makes of the whole old text the new one."""
        before = next(i for i, (a, b) in enumerate(zip(old, new)) if a != b)
        rest = min(len(old), len(new)) - before
        after = next((i for i in range(rest) if old[-1 - i] != new[-1 - i]), rest)
        node = self.node(before, max(before, len(old) - after))
        # An expression whose neighbours stay as they are.
        while not node.type.endswith("_expression") or node.parent.type == "binary_expression" or node.start_byte > before:
            node = node.parent
        tail = len(old) - node.end_byte
        changed = new[node.start_byte : len(new) - tail].decode()
        original = self.text(node.start_byte, node.end_byte)
        text = f"(if {SWITCH}({{n}}) {{{{ {braced(changed)} }}}} else {{{{ {braced(original)} }}}})"
        return self.made(node.start_byte, node.end_byte, text)

    def arm(self, start, end, _):
        arm = self.node(start, start + 1)
        while arm.type != "match_arm":
            arm = arm.parent
        pattern = arm.child_by_field_name("pattern")
        condition = pattern.child_by_field_name("condition")
        if condition is None:
            return self.made(pattern.end_byte, pattern.end_byte, f" if !{SWITCH}({{n}})")
        if condition.type in ("let_condition", "let_chain"):
            raise NoSwitch("a guard that binds")
        text = f"!{SWITCH}({{n}}) && ({braced(self.text(condition.start_byte, condition.end_byte))})"
        return self.made(condition.start_byte, condition.end_byte, text)

    def guard(self, start, end, replacement):
        original = self.text(start, end)
        return self.made(start, end, f"(if {SWITCH}({{n}}) {{{{ {replacement} }}}} else {{{{ {braced(original)} }}}})")

    def field(self, start, end, _):
        field = self.node(start, start + 1)
        while field.type not in ("field_initializer", "shorthand_field_initializer"):
            field = field.parent
        bases = [n for n in field.parent.children if n.type == "base_field_initializer"]
        if not bases:
            raise NoSwitch("no base")
        base = one_line(self.text(bases[0].start_byte, bases[0].end_byte).removeprefix(".."))
        original = self.text(field.start_byte, field.end_byte)
        name, colon, value = original.partition(":")
        text = f"{name}: if {SWITCH}({{n}}) {{{{ ({braced(base)}).{name} }}}} else {{{{ {braced(value if colon else name)} }}}}"
        return self.made(field.start_byte, field.end_byte, text)


def braced(text):
    """For `str.format`."""
    return text.replace("{", "{{").replace("}", "}}")


def disjoint(edit, others):
    return all(edit.end < other.start or other.end < edit.start for other in others)


def applied(source, edits):
    """The source with all these switches."""
    for edit in sorted(edits, key=lambda edit: edit.start, reverse=True):
        text = edit.text.format(n=edit.number).encode()
        source = source[: edit.start] + text + source[edit.end :]
    return source
