//! From the text of a formula to its words: numbers, names and signs, each with its place.

use super::error::ReadError;
use super::greek;
use super::symbol;
use super::tree::Span;

/// The longest number that is read, in digits.
pub(super) const DIGIT_LIMIT: usize = 1000;

/// The largest power of ten in a number, up or down.
pub(super) const EXPONENT_LIMIT: i64 = 1000;

/// A word of the language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Token {
    /// Digits, as written.
    Number(String),
    /// A name in canonical spelling.
    Name {
        /// Greek spelled out, index without needless braces, primes last.
        name: String,
        /// Whether a bar stands over it.
        barred: bool,
    },
    /// Anything else, in canonical spelling.
    Sign(&'static str),
    /// After the last word.
    End,
}

impl Token {
    /// The word as it is named in a message.
    pub(super) fn described(&self) -> String {
        match self {
            Token::Number(text) => format!("the number `{}`", shortened(text)),
            Token::Name { name, .. } => format!("`{}`", shortened(name)),
            Token::Sign(sign) => format!("`{sign}`"),
            Token::End => "the end of the formula".to_string(),
        }
    }
}

/// A message must stay readable whatever stands in the text.
fn shortened(text: &str) -> String {
    let start: String = text.chars().take(40).collect();
    if start.len() < text.len() {
        format!("{start}…")
    } else {
        start
    }
}

/// A word and its place.
#[derive(Clone, Debug)]
pub(super) struct Word {
    /// The word.
    pub token: Token,
    /// Where it stands.
    pub span: Span,
}

/// All spellings of all signs, longer ones first, and the canonical one.
const SIGNS: [(&str, &str); 45] = [
    ("==", "≡"),
    ("!=", "≠"),
    ("<=", "≤"),
    (">=", "≥"),
    ("><", "≷"),
    ("<>", "≶"),
    ("+-", "±"),
    ("-+", "∓"),
    ("+", "+"),
    ("-", "-"),
    ("−", "-"),
    ("±", "±"),
    ("∓", "∓"),
    ("*", "*"),
    ("·", "*"),
    ("⋅", "*"),
    ("×", "*"),
    ("/", "/"),
    ("^", "^"),
    ("=", "="),
    ("≠", "≠"),
    ("<", "<"),
    ("≤", "≤"),
    (">", ">"),
    ("≥", "≥"),
    ("≷", "≷"),
    ("≶", "≶"),
    ("≡", "≡"),
    ("~", "~"),
    (":", ":"),
    (";", ";"),
    (",", ","),
    ("(", "("),
    (")", ")"),
    ("[", "["),
    ("]", "]"),
    ("{", "{"),
    ("}", "}"),
    ("|", "|"),
    ("°", "deg"),
    // Other signs that look the same or nearly so.
    ("≦", "≤"),
    ("≧", "≥"),
    ("∼", "~"),
    ("∶", ":"),
    ("∣", "|"),
];

/// Signs that look right and are not of the language, and what to write.
const ADVICE: [(&str, &str); 18] = [
    ("**", "a power is written `x^2`"),
    (
        "=>",
        "write `≥` or `>=` for a relation, `P if Q` for a claim",
    ),
    ("=<", "write `≤` or `<=`"),
    (":=", "a definition is written `where x = …`"),
    ("&&", "write `and`"),
    ("÷", "write `/`"),
    ("√", "write `sqrt(x)`"),
    ("²", "a power is written `x^2`"),
    ("³", "a power is written `x^3`"),
    ("∠", "write `angle(A, B, C)`"),
    ("–", "this is a dash; write the minus `-` or `−`"),
    ("—", "this is a dash; write the minus `-` or `−`"),
    ("≈", "a formula is exact; a rounded value is no formula"),
    ("∞", "infinity is no number"),
    ("∥", "write `parallel(…, …)`"),
    ("⊥", "write `perpendicular(…, …)`"),
    (".", "a number begins with a digit: `0.5`"),
    ("!", "write `not P`, or `!=` for `≠`"),
];

/// Cuts a text into words. The last one is always [`Token::End`].
pub(super) fn words(text: &str) -> Result<Vec<Word>, ReadError> {
    let mut lexer = Lexer { text, at: 0 };
    let mut words = Vec::new();
    loop {
        lexer.skip_space();
        let start = lexer.at;
        let token = lexer.token()?;
        let last = token == Token::End;
        words.push(Word {
            token,
            span: start..lexer.at,
        });
        if last {
            return Ok(words);
        }
    }
}

/// A name while it is read.
#[derive(Default)]
struct Name {
    stem: String,
    index: Option<String>,
    primes: usize,
    barred: bool,
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
}

impl Lexer<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn advance(&mut self) {
        self.at += self.peek().map_or(0, char::len_utf8);
    }

    fn skip_space(&mut self) {
        while self.peek().is_some_and(char::is_whitespace) {
            self.advance();
        }
    }

    /// An error about what stands between `start` and here, or about the character here.
    fn error(&self, message: impl Into<String>, start: usize) -> ReadError {
        let end = if self.at > start {
            self.at
        } else {
            start + self.peek().map_or(0, char::len_utf8)
        };
        ReadError::new(message, start..end)
    }

    fn token(&mut self) -> Result<Token, ReadError> {
        let Some(character) = self.peek() else {
            return Ok(Token::End);
        };
        if character.is_ascii_digit() {
            return self.number();
        }
        if letter(character).is_some() {
            return self.name();
        }
        self.sign(character)
    }

    fn sign(&mut self, character: char) -> Result<Token, ReadError> {
        let advice = ADVICE
            .iter()
            .find(|(sign, _)| self.rest().starts_with(sign));
        let long = SIGNS
            .iter()
            .find(|(sign, _)| sign.len() == 2 && self.rest().starts_with(sign));
        if let (None, Some((sign, advice))) = (long, advice) {
            let start = self.at;
            self.at += sign.len();
            return Err(self.error(format!("found `{sign}`: {advice}"), start));
        }
        let sign = SIGNS.iter().find(|(sign, _)| self.rest().starts_with(sign));
        match sign {
            Some((sign, canonical)) => {
                self.at += sign.len();
                Ok(Token::Sign(canonical))
            }
            None => Err(self.error(
                format!(
                    "found `{}`, which is no sign of the language",
                    character.escape_debug()
                ),
                self.at,
            )),
        }
    }

    fn digits(&mut self) -> usize {
        let start = self.at;
        while self
            .peek()
            .is_some_and(|character| character.is_ascii_digit())
        {
            self.advance();
        }
        self.at - start
    }

    fn number(&mut self) -> Result<Token, ReadError> {
        let start = self.at;
        let mut digits = self.digits();
        if self.peek() == Some('.') {
            self.advance();
            let decimals = self.digits();
            if decimals == 0 {
                return Err(self.error("a digit must follow the decimal point", start));
            }
            digits += decimals;
        }
        if digits > DIGIT_LIMIT {
            return Err(self.error(
                format!("a number of {digits} digits; at most {DIGIT_LIMIT} are read"),
                start,
            ));
        }
        self.power_of_ten(start)?;
        if self.peek() == Some('.') {
            return Err(self.error("a number has one decimal point", self.at));
        }
        let number = self.text.get(start..self.at).unwrap_or_default();
        Ok(Token::Number(number.to_string()))
    }

    /// `e-7`; an `e` without digits is the symbol `e` and stays where it is.
    fn power_of_ten(&mut self, start: usize) -> Result<(), ReadError> {
        let before = self.at;
        if !matches!(self.peek(), Some('e' | 'E')) {
            return Ok(());
        }
        self.advance();
        if matches!(self.peek(), Some('+' | '-')) {
            self.advance();
        }
        if self.digits() == 0 {
            self.at = before;
            return Ok(());
        }
        let exponent = self.text.get(before + 1..self.at).map(str::parse::<i64>);
        match exponent {
            Some(Ok(exponent)) if exponent.abs() <= EXPONENT_LIMIT => Ok(()),
            // What does not fit in 64 bits is beyond the limit too.
            _ => Err(self.error(
                format!("a power of ten beyond {EXPONENT_LIMIT} is not read"),
                start,
            )),
        }
    }

    fn name(&mut self) -> Result<Token, ReadError> {
        let start = self.at;
        let mut name = Name::default();
        self.stem(&mut name)?;
        let single = name.stem.chars().count() == 1 || greek::sign(&name.stem).is_some();
        while let Some(character) = self.peek() {
            match character {
                '_' => self.index(&mut name, start)?,
                '\u{304}' | '\u{305}' => {
                    self.advance();
                    if name.barred || !single {
                        return Err(self.error(
                            "a bar stands over one letter, once; write `conj(…)` instead",
                            start,
                        ));
                    }
                    name.barred = true;
                }
                '\'' | '′' | '’' => name.primes += self.primes(1),
                '″' => name.primes += self.primes(2),
                '‴' => name.primes += self.primes(3),
                _ => break,
            }
        }
        self.end_of_name(&name, start)?;
        Ok(name.token())
    }

    fn primes(&mut self, count: usize) -> usize {
        self.advance();
        count
    }

    /// The letters before index and primes. A Greek sign stands alone: `αβ` would otherwise become
    /// one long name, where a paper means a product.
    fn stem(&mut self, name: &mut Name) -> Result<(), ReadError> {
        let start = self.at;
        let mut letters = 0;
        let mut greek_sign = false;
        while let Some(spelling) = self.peek().and_then(letter) {
            letters += 1;
            greek_sign |= spelling.greek;
            self.advance();
            name.stem.push_str(&spelling.text);
            if spelling.barred {
                name.barred = true;
            }
        }
        if letters > 1 && greek_sign {
            return Err(self.error(
                "a Greek letter side by side with another letter: put a space between for a \
                 product, or `_` for an index",
                start,
            ));
        }
        if letters > 1 && name.barred {
            return Err(self.error(
                "a bar over one letter of a longer name: write `conj(…)`, or a space for a product",
                start,
            ));
        }
        Ok(())
    }

    fn index(&mut self, name: &mut Name, start: usize) -> Result<(), ReadError> {
        if name.index.is_some() {
            return Err(self.error(
                "a name has one index; put several into braces: `x_{a,b}`",
                self.at,
            ));
        }
        self.advance();
        let braced = self.peek() == Some('{');
        if braced {
            self.advance();
        }
        let mut index = String::new();
        while let Some(character) = self.peek() {
            match index_part(character, braced) {
                Some(part) => index.push_str(&part),
                None => break,
            }
            self.advance();
        }
        if index.is_empty() {
            return Err(self.error("an index must follow `_`: `x_1`, `x_{a,b}`", start));
        }
        if braced {
            if self.peek() != Some('}') {
                return Err(self.error(
                    "the index in braces is not closed, or holds more than letters, digits, `,`, \
                     `+`, `-` and primes",
                    start,
                ));
            }
            self.advance();
        }
        name.index = Some(index);
        Ok(())
    }

    /// `a2` may mean an index or a product: neither is guessed.
    fn end_of_name(&self, name: &Name, start: usize) -> Result<(), ReadError> {
        let stem = &name.stem;
        match self.peek() {
            Some(digit) if digit.is_ascii_digit() => {
                let span = start..self.at + 1;
                Err(ReadError::new(
                    format!(
                        "a digit right after a name: write `{stem}_{digit}` for an index, `{stem} \
                         {digit}` for a product"
                    ),
                    span,
                ))
            }
            Some(character) if letter(character).is_some() => Err(self.error(
                "a letter right after the end of a name: put a space between for a product",
                self.at,
            )),
            _ => Ok(()),
        }
    }
}

impl Name {
    fn token(self) -> Token {
        let name = match self.index {
            Some(index) => symbol::with_index(&self.stem, &index, self.primes),
            None => self.stem + &"'".repeat(self.primes),
        };
        Token::Name {
            name,
            barred: self.barred,
        }
    }
}

/// How a letter is spelled in a canonical name.
struct Spelling {
    text: String,
    greek: bool,
    barred: bool,
}

/// Letters that editors compose with the bar over them.
const BARRED: [(char, char); 14] = [
    ('ā', 'a'),
    ('ē', 'e'),
    ('ī', 'i'),
    ('ō', 'o'),
    ('ū', 'u'),
    ('ȳ', 'y'),
    ('ḡ', 'g'),
    ('Ā', 'A'),
    ('Ē', 'E'),
    ('Ī', 'I'),
    ('Ō', 'O'),
    ('Ū', 'U'),
    ('Ȳ', 'Y'),
    ('Ḡ', 'G'),
];

fn letter(character: char) -> Option<Spelling> {
    if character.is_ascii_alphabetic() {
        return Some(Spelling {
            text: character.to_string(),
            greek: false,
            barred: false,
        });
    }
    if let Some((_, base)) = BARRED.iter().find(|(barred, _)| *barred == character) {
        return Some(Spelling {
            text: base.to_string(),
            greek: false,
            barred: true,
        });
    }
    greek::spelled(character).map(|name| Spelling {
        text: name.to_string(),
        greek: true,
        barred: false,
    })
}

/// What a character adds to an index, if it may stand there.
fn index_part(character: char, braced: bool) -> Option<String> {
    if character.is_ascii_alphanumeric() {
        return Some(character.to_string());
    }
    if let Some(name) = greek::spelled(character) {
        return Some(name.to_string());
    }
    match character {
        ',' | '+' | '-' | '\'' if braced => Some(character.to_string()),
        '−' if braced => Some("-".to_string()),
        '′' | '’' if braced => Some("'".to_string()),
        ' ' if braced => Some(String::new()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(text: &str) -> Vec<String> {
        words(text)
            .unwrap()
            .into_iter()
            .filter_map(|word| match word.token {
                Token::Name { name, .. } => Some(name),
                _ => None,
            })
            .collect()
    }

    #[test]
    fn spellings_of_one_name_become_one() {
        assert_eq!(names("α_a alpha_a alpha_{a}"), ["alpha_a"; 3]);
        assert_eq!(names("O'_12 O_12' O_{12}′"), ["O_12'"; 3]);
        assert_eq!(names("x'' x″ x_{a, b}"), ["x''", "x''", "x_{a,b}"]);
        assert_eq!(names("φ ϕ phi"), ["phi"; 3]);
    }

    #[test]
    fn an_e_without_digits_is_a_symbol() {
        let tokens: Vec<Token> = words("2e 2e3 2e-x")
            .unwrap()
            .into_iter()
            .map(|word| word.token)
            .collect();
        assert_eq!(tokens[0], Token::Number("2".into()));
        assert_eq!(tokens[2], Token::Number("2e3".into()));
        assert_eq!(tokens[3], Token::Number("2".into()));
    }
}
