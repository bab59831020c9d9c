//! Greek letters: their spelled names, their signs, their LaTeX commands.

/// Spelled name and sign. The first sign of a name is the one that is set.
const LETTERS: [(&str, char); 52] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("epsilon", 'ϵ'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("theta", 'ϑ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("mu", 'µ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("omicron", 'ο'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("phi", 'ϕ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Alpha", 'Α'),
    ("Beta", 'Β'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Epsilon", 'Ε'),
    ("Zeta", 'Ζ'),
    ("Eta", 'Η'),
    ("Theta", 'Θ'),
    ("Iota", 'Ι'),
    ("Kappa", 'Κ'),
    ("Lambda", 'Λ'),
    ("Mu", 'Μ'),
    ("Nu", 'Ν'),
    ("Xi", 'Ξ'),
    ("Omicron", 'Ο'),
    ("Pi", 'Π'),
    ("Rho", 'Ρ'),
    ("Sigma", 'Σ'),
    ("Tau", 'Τ'),
    ("Upsilon", 'Υ'),
    ("Phi", 'Φ'),
    ("Chi", 'Χ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
];

/// Names that LaTeX has no command for because the letter looks like a Latin one.
const LATIN_LOOK: [(&str, &str); 14] = [
    ("omicron", "o"),
    ("Alpha", "A"),
    ("Beta", "B"),
    ("Epsilon", "E"),
    ("Zeta", "Z"),
    ("Eta", "H"),
    ("Iota", "I"),
    ("Kappa", "K"),
    ("Mu", "M"),
    ("Nu", "N"),
    ("Omicron", "O"),
    ("Rho", "P"),
    ("Tau", "T"),
    ("Chi", "X"),
];

/// The spelled name of a Greek letter.
pub(super) fn spelled(letter: char) -> Option<&'static str> {
    LETTERS
        .iter()
        .find(|(_, sign)| *sign == letter)
        .map(|(name, _)| *name)
}

/// The sign of a spelled Greek letter.
pub(super) fn sign(name: &str) -> Option<char> {
    LETTERS
        .iter()
        .find(|(spelled, _)| *spelled == name)
        .map(|(_, sign)| *sign)
}

/// The LaTeX command of a spelled Greek letter.
pub(super) fn command(name: &str) -> Option<String> {
    sign(name)?;
    let latin = LATIN_LOOK.iter().find(|(spelled, _)| *spelled == name);
    Some(match (latin, name) {
        (Some((_, letter)), _) => format!("\\mathrm{{{letter}}}"),
        (_, "epsilon") => "\\varepsilon".to_string(),
        (_, "phi") => "\\varphi".to_string(),
        _ => format!("\\{name}"),
    })
}
