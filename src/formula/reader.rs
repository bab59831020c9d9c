//! The reader: from text to [`Formula`], by precedence climbing (Pratt).
//!
//! It is total: whatever stands in the text, it answers with a formula or an error, in linear
//! memory, and its recursion is bounded by [`NESTING_LIMIT`], that of the tree by [`DEPTH_LIMIT`].

use rug::{Integer, Rational, ops::Pow};

use super::cis;
use super::error::ReadError;
use super::function::{Arity, Function};
use super::level::Level;
use super::lexer::{Token, Word, words};
use super::tree::{Connective, Formula, Node, Operator, Relation, Span, Tree};

/// The longest formula that is read, in bytes.
pub const LENGTH_LIMIT: usize = 20_000;

/// How many levels a tree may have: a sum of so many terms is a tree of so many levels, and what
/// walks a tree recurses.
pub const DEPTH_LIMIT: usize = 400;

/// How many constructs may be open at one place: every level of a tree, and the parentheses that it has
/// where the tree is shown, so that whatever was read reads back.
pub const NESTING_LIMIT: usize = 2 * DEPTH_LIMIT + 2;

/// Words that are no names.
const KEYWORDS: [&str; 11] = [
    "for", "in", "iff", "if", "or", "and", "not", "mod", "where", "assume", "deg",
];

/// The word before the terms of a sum.
const SUM: &str = "sum";

/// Reads a formula.
pub fn read(text: &str) -> Result<Formula, ReadError> {
    if text.len() > LENGTH_LIMIT {
        return Err(ReadError::new(
            format!(
                "a formula of {} bytes; at most {LENGTH_LIMIT} are read",
                text.len()
            ),
            0..0,
        ));
    }
    let mut reader = Reader {
        words: words(text)?,
        at: 0,
        nesting: 0,
        bars: 0,
    };
    reader.formula()
}

/// Whether a canonical name may stand for a quantity: it is no word of the language.
pub(super) fn is_free_name(name: &str) -> bool {
    !KEYWORDS.contains(&name)
        && !matches!(name, "i" | "pi" | SUM)
        && Function::named(name).is_none()
}

/// A tree while it grows, with the number of its levels.
struct Part {
    tree: Tree,
    depth: usize,
}

struct Reader {
    words: Vec<Word>,
    at: usize,
    /// Constructs that are open here.
    nesting: usize,
    /// Bars `|` that are open since the last bracket.
    bars: usize,
}

/// What may be applied between two parts.
enum Infix {
    Binary(Operator),
    Relation,
    Ratio,
    Logic(Connective),
    For,
}

impl Infix {
    fn level(&self) -> Level {
        match self {
            Infix::Binary(operator) => operator.level(),
            Infix::Relation => Level::Relation,
            Infix::Ratio => Level::Ratio,
            Infix::Logic(connective) => connective.level(),
            Infix::For => Level::For,
        }
    }
}

/// Words.
impl Reader {
    fn word(&self) -> &Word {
        self.word_after(0)
    }

    /// The word so many places on. The list always ends with [`Token::End`], so the last word
    /// stands for all beyond.
    #[expect(clippy::indexing_slicing, reason = "the list is never empty")]
    fn word_after(&self, count: usize) -> &Word {
        &self.words[(self.at + count).min(self.words.len() - 1)]
    }

    /// The word so many places back; the first word stands for all before.
    #[expect(
        clippy::indexing_slicing,
        reason = "the place is never beyond the last word"
    )]
    fn word_before(&self, count: usize) -> &Word {
        &self.words[self.at.saturating_sub(count)]
    }

    fn token(&self) -> &Token {
        &self.word().token
    }

    fn span(&self) -> Span {
        self.word().span.clone()
    }

    fn advance(&mut self) {
        self.at = (self.at + 1).min(self.words.len() - 1);
    }

    /// Where the last word ends that has been read.
    fn end(&self) -> usize {
        self.word_before(1).span.end
    }

    fn is_sign(&self, sign: &str) -> bool {
        is_sign(self.token(), sign)
    }

    fn is_keyword(&self, keyword: &str) -> bool {
        is_keyword(self.token(), keyword)
    }

    fn take_sign(&mut self, sign: &str) -> bool {
        let found = self.is_sign(sign);
        if found {
            self.advance();
        }
        found
    }

    fn take_keyword(&mut self, keyword: &str) -> bool {
        let found = self.is_keyword(keyword);
        if found {
            self.advance();
        }
        found
    }

    fn expected(&self, what: &str) -> ReadError {
        ReadError::new(
            format!("found {}, expected {what}", self.token().described()),
            self.span(),
        )
    }

    fn node(&self, node: Node, span: Span, depth_below: usize) -> Result<Part, ReadError> {
        let depth = depth_below + 1;
        if depth > DEPTH_LIMIT {
            return Err(ReadError::new(
                format!(
                    "more than {DEPTH_LIMIT} levels: name a part of it by `where`, or put \
                     parentheses around half of a long sum or product"
                ),
                span,
            ));
        }
        Ok(Part {
            tree: Tree::new(node, span),
            depth,
        })
    }
}

fn is_sign(token: &Token, sign: &str) -> bool {
    matches!(token, Token::Sign(found) if *found == sign)
}

fn is_keyword(token: &Token, keyword: &str) -> bool {
    match token {
        Token::Name { name, .. } => name == keyword,
        // The degree sign is the same word.
        Token::Sign(sign) => *sign == keyword,
        _ => false,
    }
}

/// The whole formula.
impl Reader {
    fn formula(&mut self) -> Result<Formula, ReadError> {
        let mut claims = vec![self.parse(Level::For)?.tree];
        while self.take_sign(";") {
            claims.push(self.parse(Level::For)?.tree);
        }
        let mut definitions = Vec::new();
        if self.take_keyword("where") {
            definitions.push(self.definition()?);
            while self.take_sign(",") {
                definitions.push(self.definition()?);
            }
        }
        let mut assumptions = Vec::new();
        if self.take_keyword("assume") {
            assumptions.push(self.parse(Level::For)?.tree);
            while self.take_sign(",") {
                assumptions.push(self.parse(Level::For)?.tree);
            }
        }
        self.finish(&definitions, &assumptions)?;
        Ok(Formula {
            claims,
            definitions,
            assumptions,
        })
    }

    fn finish(&self, definitions: &[(String, Tree)], assumed: &[Tree]) -> Result<(), ReadError> {
        if *self.token() == Token::End {
            return Ok(());
        }
        if self.is_keyword("where") && !assumed.is_empty() {
            return Err(self.error("`where` stands before `assume`"));
        }
        if self.is_keyword("where") || self.is_keyword("assume") {
            return Err(self
                .error("a formula has one `where` and one `assume`; separate their parts by `,`"));
        }
        if self.is_sign(";") {
            return Err(self.error("all claims stand before `where` and `assume`"));
        }
        if self.is_sign("=") && !definitions.is_empty() {
            return Err(self.error("a definition has one `=`"));
        }
        for closing in [")", "]", "}"] {
            if self.is_sign(closing) {
                return Err(self.error(format!("this `{closing}` closes nothing")));
            }
        }
        Err(self.expected("an operator, a relation, `;` or the end"))
    }

    fn error(&self, message: impl Into<String>) -> ReadError {
        ReadError::new(message, self.span())
    }

    fn definition(&mut self) -> Result<(String, Tree), ReadError> {
        let name = self.free_name("a name to define")?;
        if !self.take_sign("=") {
            return Err(self.expected(&format!("`=` after the name `{name}` to define")));
        }
        let value = self.parse(Level::Ratio)?.tree;
        Ok((name, value))
    }

    /// A name that may be bound here.
    fn free_name(&mut self, what: &str) -> Result<String, ReadError> {
        match self.token().clone() {
            Token::Name {
                name,
                barred: false,
            } if is_free_name(&name) => {
                self.advance();
                Ok(name)
            }
            Token::Name { barred: true, .. } => {
                Err(self.expected(&format!("{what}, without a bar")))
            }
            Token::Name { .. } => {
                Err(self.expected(&format!("{what}; this is a word of the language")))
            }
            _ => Err(self.expected(what)),
        }
    }
}

/// Between two parts.
impl Reader {
    /// Everything from here on that binds at least as tightly as `level`.
    fn parse(&mut self, level: Level) -> Result<Part, ReadError> {
        self.nesting += 1;
        if self.nesting > NESTING_LIMIT {
            return Err(self.error(format!(
                "more than {NESTING_LIMIT} constructs inside one another"
            )));
        }
        let mut part = self.prefix(level)?;
        while let Some(infix) = self.infix() {
            if infix.level() < level {
                break;
            }
            part = self.apply(infix, part)?;
        }
        self.nesting -= 1;
        Ok(part)
    }

    fn infix(&self) -> Option<Infix> {
        match self.token() {
            Token::Sign(sign) => match *sign {
                ":" => Some(Infix::Ratio),
                _ => operator(sign)
                    .map(Infix::Binary)
                    .or_else(|| Relation::named(sign).map(|_| Infix::Relation)),
            },
            Token::Name { name, .. } if name == "for" => Some(Infix::For),
            Token::Name { name, .. } => Connective::named(name).map(Infix::Logic),
            _ => None,
        }
        .or_else(|| {
            self.starts_factor()
                .then_some(Infix::Binary(Operator::Juxtapose))
        })
    }

    fn apply(&mut self, infix: Infix, left: Part) -> Result<Part, ReadError> {
        match infix {
            Infix::Binary(Operator::Juxtapose) => {
                self.two_numbers()?;
                self.binary(Operator::Juxtapose, left, Level::Power)
            }
            Infix::Binary(operator) => {
                self.advance();
                let right = match operator {
                    Operator::Mul => Level::Juxtaposition,
                    Operator::Div => {
                        self.fraction_below()?;
                        Level::Juxtaposition
                    }
                    Operator::Pow => return self.power(left),
                    _ => Level::Negative,
                };
                self.binary(operator, left, right)
            }
            Infix::Relation => self.chain(left),
            Infix::Ratio => self.ratio(left),
            Infix::Logic(connective) => self.logic(connective, left),
            Infix::For => self.for_each(left),
        }
    }

    fn binary(&mut self, operator: Operator, left: Part, right: Level) -> Result<Part, ReadError> {
        let right = self.parse(right)?;
        self.joined(operator, left, right)
    }

    fn joined(&self, operator: Operator, left: Part, right: Part) -> Result<Part, ReadError> {
        let span = left.tree.span.start..right.tree.span.end;
        let depth = left.depth.max(right.depth);
        let node = Node::Binary(operator, Box::new(left.tree), Box::new(right.tree));
        self.node(node, span, depth)
    }

    fn two_numbers(&self) -> Result<(), ReadError> {
        let (before, here) = (self.word_before(1), self.word());
        match (&before.token, &here.token) {
            (Token::Number(left), Token::Number(right)) => Err(ReadError::new(
                format!("two numbers side by side: write `{left} * {right}` for a product"),
                before.span.start..here.span.end,
            )),
            _ => Ok(()),
        }
    }

    /// `x/2/5 y`: the fraction 2/5, or divided twice?
    fn fraction_below(&self) -> Result<(), ReadError> {
        if !self.fraction_ahead() {
            return Ok(());
        }
        Err(ReadError::new(
            "ambiguous: `2/5 y` is the fraction times y, but stands after `/`; put parentheses",
            self.word().span.start..self.word_after(2).span.end,
        ))
    }

    fn power(&mut self, base: Part) -> Result<Part, ReadError> {
        if matches!(base.tree.node, Node::Binary(Operator::Pow, ..)) && !self.closed_before_hat() {
            return Err(ReadError::new(
                "ambiguous: a power of a power; put parentheses",
                base.tree.span,
            ));
        }
        let euler = matches!(&base.tree.node, Node::Symbol(name) if name == "e")
            && !self.closed_before_hat();
        let exponent = self.parse(Level::Power)?;
        if self.is_keyword("deg") {
            return Err(self.error("ambiguous: write `(x^2) deg` or `x^(2 deg)`"));
        }
        if !euler {
            return self.joined(Operator::Pow, base, exponent);
        }
        self.euler(base, exponent)
    }

    /// Whether the base of the power just entered ended with a parenthesis.
    fn closed_before_hat(&self) -> bool {
        self.at >= 2 && is_sign(&self.word_before(2).token, ")")
    }

    /// `e^(i γ)` is the point of the unit circle; other powers of `e` are those of a symbol.
    fn euler(&self, base: Part, exponent: Part) -> Result<Part, ReadError> {
        let span = base.tree.span.start..exponent.tree.span.end;
        let bare = match &exponent.tree.node {
            Node::Negative(inner) => inner,
            _ => &exponent.tree,
        };
        if bare.node == Node::ImaginaryUnit {
            return Err(ReadError::new(
                "write the whole exponent in parentheses: `e^(i x)`",
                span,
            ));
        }
        match cis::without_unit(&exponent.tree) {
            Some(angle) => self.node(Node::Call(Function::Cis, vec![angle]), span, exponent.depth),
            None => self.joined(Operator::Pow, base, exponent),
        }
    }

    fn chain(&mut self, first: Part) -> Result<Part, ReadError> {
        let mut depth = first.depth;
        let mut rest = Vec::new();
        while let Some(relation) = self.relation() {
            self.advance();
            let side = self.parse(Level::Ratio)?;
            depth = depth.max(side.depth);
            rest.push((relation, side.tree));
        }
        let modulus = self.modulus(&rest)?;
        let modulus = modulus.map(|part| {
            depth = depth.max(part.depth);
            Box::new(part.tree)
        });
        let span = first.tree.span.start..self.end();
        let node = Node::Chain {
            first: Box::new(first.tree),
            rest,
            modulus,
        };
        self.node(node, span, depth)
    }

    fn relation(&self) -> Option<Relation> {
        match self.token() {
            Token::Sign(sign) => Relation::named(sign),
            _ => None,
        }
    }

    fn modulus(&mut self, rest: &[(Relation, Tree)]) -> Result<Option<Part>, ReadError> {
        let parenthesis = self.is_sign("(") && is_keyword(&self.word_after(1).token, "mod");
        if !parenthesis && !self.is_keyword("mod") {
            return Ok(None);
        }
        if !rest
            .iter()
            .any(|(relation, _)| *relation == Relation::Congruent)
        {
            return Err(self.error("`mod` needs the relation `≡` (or `==`)"));
        }
        if parenthesis {
            self.advance();
        }
        self.advance();
        let modulus = self.parse(Level::Sum)?;
        if parenthesis && !self.take_sign(")") {
            return Err(self.expected("`)` after the modulus"));
        }
        Ok(Some(modulus))
    }

    fn ratio(&mut self, first: Part) -> Result<Part, ReadError> {
        let start = first.tree.span.start;
        let mut depth = first.depth;
        let mut parts = vec![first.tree];
        while self.take_sign(":") {
            let part = self.parse(Level::Sum)?;
            depth = depth.max(part.depth);
            parts.push(part.tree);
        }
        self.node(Node::Ratio(parts), start..self.end(), depth)
    }

    fn logic(&mut self, connective: Connective, left: Part) -> Result<Part, ReadError> {
        self.advance();
        let right = self.parse(connective.sides().1)?;
        let single = matches!(connective, Connective::If | Connective::Iff);
        if single && self.is_keyword(connective.word()) {
            return Err(self.error(format!(
                "ambiguous: a second `{}`; put parentheses",
                connective.word()
            )));
        }
        let span = left.tree.span.start..right.tree.span.end;
        let depth = left.depth.max(right.depth);
        let node = Node::Logic(connective, Box::new(left.tree), Box::new(right.tree));
        self.node(node, span, depth)
    }

    fn for_each(&mut self, body: Part) -> Result<Part, ReadError> {
        let name = self.bound_name()?;
        if !self.is_sign("{") && !self.is_sign("[") {
            return Err(self.expected("a set `{…}` or a list `[…]` after `in`"));
        }
        let values = self.parse(Level::Atom)?;
        let span = body.tree.span.start..values.tree.span.end;
        let depth = body.depth.max(values.depth);
        let node = Node::For {
            body: Box::new(body.tree),
            name,
            values: Box::new(values.tree),
        };
        self.node(node, span, depth)
    }

    /// `for k in`
    fn bound_name(&mut self) -> Result<String, ReadError> {
        self.advance();
        let name = self.free_name("a name after `for`")?;
        if !self.take_keyword("in") {
            return Err(self.expected(&format!("`in` after `for {name}`")));
        }
        Ok(name)
    }
}

fn operator(sign: &str) -> Option<Operator> {
    match sign {
        "+" => Some(Operator::Add),
        "-" => Some(Operator::Sub),
        "±" => Some(Operator::PlusMinus),
        "∓" => Some(Operator::MinusPlus),
        "*" => Some(Operator::Mul),
        "/" => Some(Operator::Div),
        "^" => Some(Operator::Pow),
        _ => None,
    }
}

/// Where a part begins.
impl Reader {
    /// Whether a factor of a product without sign begins here.
    fn starts_factor(&self) -> bool {
        match self.token() {
            Token::Number(_) => true,
            Token::Name { name, .. } => !KEYWORDS.contains(&name.as_str()),
            Token::Sign("(") => !is_keyword(&self.word_after(1).token, "mod"),
            Token::Sign("[" | "{") => true,
            Token::Sign("|") => self.bars == 0,
            _ => false,
        }
    }

    fn prefix(&mut self, level: Level) -> Result<Part, ReadError> {
        match self.token().clone() {
            Token::Sign("-") => self.negative(level),
            Token::Name {
                name,
                barred: false,
            } if name == "not" && level <= Level::Not => self.not(),
            Token::Number(_) if level <= Level::Juxtaposition && self.fraction_ahead() => {
                self.fraction()
            }
            _ => self.primary(),
        }
    }

    /// A sign before a product is that of the whole product; in an exponent, of the next power.
    fn negative(&mut self, level: Level) -> Result<Part, ReadError> {
        if level == Level::Atom {
            return Err(self.expected("a quantity"));
        }
        let start = self.span().start;
        self.advance();
        let inner = self.parse(level.max(Level::Product))?;
        let span = start..inner.tree.span.end;
        self.node(Node::Negative(Box::new(inner.tree)), span, inner.depth)
    }

    fn not(&mut self) -> Result<Part, ReadError> {
        let start = self.span().start;
        self.advance();
        let inner = self.parse(Level::Not)?;
        let span = start..inner.tree.span.end;
        self.node(Node::Not(Box::new(inner.tree)), span, inner.depth)
    }

    /// Whether `2/5 x` stands here: the quotient of two whole numbers and a factor.
    fn fraction_ahead(&self) -> bool {
        let whole = |count: usize| matches!(&self.word_after(count).token, Token::Number(text) if is_whole(text));
        if !(whole(0) && is_sign(&self.word_after(1).token, "/") && whole(2)) {
            return false;
        }
        match &self.word_after(3).token {
            Token::Name { name, .. } => !KEYWORDS.contains(&name.as_str()) || name == "deg",
            Token::Sign("(") => !is_keyword(&self.word_after(4).token, "mod"),
            Token::Sign("[" | "{" | "deg") => true,
            Token::Sign("|") => self.bars == 0,
            _ => false,
        }
    }

    fn fraction(&mut self) -> Result<Part, ReadError> {
        let numerator = self.number()?;
        self.advance();
        let denominator = self.number()?;
        if self.is_keyword("deg") {
            return Err(ReadError::new(
                "ambiguous: write `(1/2) deg` or `1/(2 deg)`",
                numerator.tree.span.start..self.span().end,
            ));
        }
        self.joined(Operator::Div, numerator, denominator)
    }

    fn primary(&mut self) -> Result<Part, ReadError> {
        let span = self.span();
        let start = span.start;
        match self.token().clone() {
            Token::Number(_) => {
                let number = self.number()?;
                self.degrees(number, start)
            }
            Token::Name { name, barred } => self.named(&name, barred),
            Token::Sign("(") => {
                let inner = self.parenthesis()?;
                self.degrees(inner, start)
            }
            Token::Sign("[") => {
                let (parts, depth) = self.sequence("]")?;
                self.node(Node::List(parts), start..self.end(), depth)
            }
            Token::Sign("{") => {
                let (parts, depth) = self.sequence("}")?;
                self.node(Node::Set(parts), start..self.end(), depth)
            }
            Token::Sign("|") => self.absolute(),
            Token::Sign("±" | "∓") => {
                Err(self.error("a sign of both values needs a left side: write `0 ± x`"))
            }
            _ => Err(self.expected("a quantity")),
        }
    }

    fn number(&mut self) -> Result<Part, ReadError> {
        let Token::Number(text) = self.token().clone() else {
            return Err(self.expected("a number"));
        };
        let span = self.span();
        let Some(value) = exact_value(&text) else {
            return Err(self.expected("a number"));
        };
        self.advance();
        self.node(Node::Number { text, value }, span, 0)
    }

    /// `deg` after a number or a parenthesis.
    fn degrees(&mut self, inner: Part, start: usize) -> Result<Part, ReadError> {
        if !self.take_keyword("deg") {
            return Ok(inner);
        }
        let span = start..self.end();
        self.node(Node::Degrees(Box::new(inner.tree)), span, inner.depth)
    }

    fn parenthesis(&mut self) -> Result<Part, ReadError> {
        let open = self.span();
        self.advance();
        let bars = std::mem::take(&mut self.bars);
        let mut inner = self.parse(Level::For)?;
        self.close(")", &open)?;
        self.bars = bars;
        // The parentheses belong to the place: what is shown of it must be balanced.
        inner.tree.span = open.start..self.end();
        Ok(inner)
    }

    fn close(&mut self, closing: &str, open: &Span) -> Result<(), ReadError> {
        if self.take_sign(closing) {
            return Ok(());
        }
        if *self.token() == Token::End {
            return Err(ReadError::new(
                format!("nothing closes this: expected `{closing}`"),
                open.clone(),
            ));
        }
        if closing == ")" && self.is_sign(",") {
            return Err(self.error(
                "found `,` in parentheses that are no call: a list is written `[a, b]`, a set \
                 `{a, b}`",
            ));
        }
        Err(self.expected(&format!("an operator or `{closing}`")))
    }

    /// Parts between brackets, separated by `,`.
    fn sequence(&mut self, closing: &str) -> Result<(Vec<Tree>, usize), ReadError> {
        let open = self.span();
        self.advance();
        let bars = std::mem::take(&mut self.bars);
        let mut parts = Vec::new();
        let mut depth = 0;
        if !self.is_sign(closing) {
            loop {
                let part = self.parse(Level::For)?;
                depth = depth.max(part.depth);
                parts.push(part.tree);
                if !self.take_sign(",") {
                    break;
                }
            }
        }
        self.close(closing, &open)?;
        self.bars = bars;
        Ok((parts, depth))
    }

    fn absolute(&mut self) -> Result<Part, ReadError> {
        let open = self.span();
        self.advance();
        self.bars += 1;
        let inner = self.parse(Level::Sum)?;
        self.bars -= 1;
        self.close("|", &open)?;
        let span = open.start..self.end();
        self.node(
            Node::Call(Function::Abs, vec![inner.tree]),
            span,
            inner.depth,
        )
    }
}

/// Names and calls.
impl Reader {
    fn named(&mut self, name: &str, barred: bool) -> Result<Part, ReadError> {
        let span = self.span();
        if KEYWORDS.contains(&name) {
            return Err(self.expected("a quantity"));
        }
        if let Some(function) = Function::named(name) {
            self.advance();
            return self.call(function, span);
        }
        self.advance();
        if name == SUM {
            return self.sum(span.start);
        }
        let node = match name {
            "i" => Node::ImaginaryUnit,
            "pi" => Node::Pi,
            _ => Node::Symbol(name.to_string()),
        };
        self.no_call(name, &span)?;
        let part = self.node(node, span.clone(), 0)?;
        if barred {
            return self.node(
                Node::Call(Function::Conj, vec![part.tree]),
                span,
                part.depth,
            );
        }
        Ok(part)
    }

    /// After `sum`. Its members may be equal, which those of a set are not.
    fn sum(&mut self, start: usize) -> Result<Part, ReadError> {
        let open = self.span();
        if !self.take_sign("(") {
            return Err(self.expected(&format!("`(` after `{SUM}`")));
        }
        let bars = std::mem::take(&mut self.bars);
        let body = self.parse(Level::Sum)?;
        if !self.is_keyword("for") {
            return Err(self.expected("`for` after the terms of a sum"));
        }
        let name = self.bound_name()?;
        if !self.is_sign("[") {
            return Err(self.expected("a list `[…]` after `in`"));
        }
        let values = self.parse(Level::Atom)?;
        self.close(")", &open)?;
        self.bars = bars;
        let depth = body.depth.max(values.depth);
        let node = Node::Sum {
            body: Box::new(body.tree),
            name,
            values: Box::new(values.tree),
        };
        self.node(node, start..self.end(), depth)
    }

    /// `foo(x, y)` where `foo` is no function: say so, before `,` becomes the complaint.
    fn no_call(&self, name: &str, span: &Span) -> Result<(), ReadError> {
        if !self.is_sign("(") {
            return Ok(());
        }
        let mut open = 0_usize;
        for word in self.words.iter().skip(self.at) {
            match word.token {
                Token::Sign("(" | "[" | "{") => open += 1,
                Token::Sign(")" | "]" | "}") => open = open.saturating_sub(1),
                Token::Sign(",") if open == 1 => {
                    return Err(ReadError::new(
                        format!(
                            "`{name}` is no function of the language, and a product has no `,`"
                        ),
                        span.clone(),
                    ));
                }
                _ => {}
            }
            if open == 0 {
                break;
            }
        }
        Ok(())
    }

    /// After the name of a function.
    fn call(&mut self, function: Function, name: Span) -> Result<Part, ReadError> {
        if self.is_sign("^") {
            return self.power_of_call(function, name);
        }
        if self.is_sign("(") {
            let (arguments, depth) = self.sequence(")")?;
            let span = name.start..self.end();
            check_arity(function, arguments.len(), &span)?;
            return self.node(Node::Call(function, arguments), span, depth);
        }
        self.call_without_parentheses(function, name)
    }

    /// `f^2 x` is `(f x)^2`.
    fn power_of_call(&mut self, function: Function, name: Span) -> Result<Part, ReadError> {
        let spelled = function.name();
        if function.arity() != Arity::Exactly(1) {
            return Err(self.error(format!(
                "`{spelled}` takes several arguments: write `{spelled}(…)^2`"
            )));
        }
        self.advance();
        if self.is_sign("-") {
            return Err(ReadError::new(
                inverse_advice(function),
                name.start..self.word_after(1).span.end,
            ));
        }
        let exponent = self.parse(Level::Atom)?;
        if self.is_sign("^") {
            return Err(self.expected(&format!("the argument of `{spelled}`")));
        }
        let call = self.call(function, name)?;
        if self.is_sign("^") {
            return Err(self.error("ambiguous: a second power; put parentheses"));
        }
        let span = call.tree.span.start..call.tree.span.end.max(exponent.tree.span.end);
        let mut power = self.joined(Operator::Pow, call, exponent)?;
        // The exponent stands before the argument, the whole ends with the argument.
        power.tree.span = span;
        Ok(power)
    }

    fn call_without_parentheses(
        &mut self,
        function: Function,
        name: Span,
    ) -> Result<Part, ReadError> {
        let spelled = function.name();
        if function.arity() != Arity::Exactly(1) {
            return Err(self.expected(&format!("`(` after `{spelled}`")));
        }
        if !self.starts_factor() {
            return Err(self.expected(&format!("the argument of `{spelled}`")));
        }
        let lone_number = matches!(self.token(), Token::Number(_)) && self.fraction_ahead();
        let mut argument = self.parse(Level::Power)?;
        while function.is_trigonometric() && self.starts_bare_factor() {
            self.two_numbers()?;
            argument = self.binary(Operator::Juxtapose, argument, Level::Power)?;
        }
        if self.starts_factor() && !self.starts_call() {
            return Err(ReadError::new(
                format!(
                    "ambiguous: where does the argument of `{spelled}` end? Put parentheses \
                     around it"
                ),
                name.start..self.span().end,
            ));
        }
        if function.is_trigonometric() && lone_number && self.is_sign("/") {
            return Err(ReadError::new(
                format!("ambiguous: put the argument of `{spelled}` into parentheses"),
                name.start..self.span().end,
            ));
        }
        let span = name.start..argument.tree.span.end;
        self.node(
            Node::Call(function, vec![argument.tree]),
            span,
            argument.depth,
        )
    }

    /// Whether the name of a function, or a sum, stands here.
    fn starts_call(&self) -> bool {
        matches!(self.token(), Token::Name { name, .. } if name == SUM || Function::named(name).is_some())
    }

    /// Whether a number or a symbol stands here.
    fn starts_bare_factor(&self) -> bool {
        matches!(self.token(), Token::Number(_) | Token::Name { .. })
            && self.starts_factor()
            && !self.starts_call()
    }
}

fn inverse_advice(function: Function) -> String {
    let name = function.name();
    let inverse = match function {
        Function::Sin => Some("arcsin"),
        Function::Cos => Some("arccos"),
        Function::Tan => Some("arctan"),
        _ => None,
    };
    match inverse {
        Some(inverse) => format!(
            "ambiguous: write `{inverse}(x)` for the inverse function, `1/{name}(x)` for the \
             reciprocal"
        ),
        None => format!("ambiguous: write `1/{name}(x)` for the reciprocal"),
    }
}

fn check_arity(function: Function, count: usize, span: &Span) -> Result<(), ReadError> {
    if function.arity().admits(count) {
        return Ok(());
    }
    let expected = match function.arity() {
        Arity::Exactly(1) => "1 argument".to_string(),
        Arity::Exactly(number) => format!("{number} arguments"),
        Arity::AtLeast(number) => format!("{number} or more arguments"),
    };
    let entry = function.entry();
    Err(ReadError::new(
        format!(
            "found {count}, expected {expected} of `{}` ({})",
            entry.name, entry.arguments
        ),
        span.clone(),
    ))
}

fn is_whole(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit())
}

/// The value of a number as the lexer passes it; the lexer has bounded digits and power.
pub(super) fn exact_value(text: &str) -> Option<Rational> {
    let (mantissa, power) = match text.split_once(['e', 'E']) {
        Some((mantissa, power)) => (mantissa, power.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: Integer = format!("{whole}{decimals}").parse().ok()?;
    let shift = power - i32::try_from(decimals.len()).ok()?;
    let scale = Integer::from(10).pow(shift.unsigned_abs());
    Some(if shift < 0 {
        Rational::from((digits, scale))
    } else {
        Rational::from(digits * scale)
    })
}
