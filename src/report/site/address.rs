//! Addresses of statements and other things, that stay as long as their ids.

use std::fmt::Write;

/// An id as a part of an address. Different ids have different addresses, also where capitals are not
/// told from small letters: a capital has a `+` before it, `/` is `~`, and what is neither letter nor
/// digit nor one of `-_.` is written as `=` with its number.
pub fn encoded(id: &str) -> String {
    let mut address = String::with_capacity(id.len());
    for byte in id.bytes() {
        match byte {
            b'a'..=b'z' | b'0'..=b'9' | b'-' | b'_' | b'.' => address.push(char::from(byte)),
            b'A'..=b'Z' => {
                address.push('+');
                address.push(char::from(byte));
            }
            b'/' => address.push('~'),
            _ => {
                // Writing to a string cannot fail.
                let _ = write!(address, "={byte:02x}");
            }
        }
    }
    address
}

/// The page of a source.
pub fn of_source(key: &str) -> String {
    format!("{}.html", encoded(key))
}

/// A statement's place on the page of its source.
pub fn fragment(id: &str) -> String {
    encoded(id.split_once('/').map_or(id, |(_, rest)| rest))
}

/// A statement's page and place.
pub fn of_statement(id: &str) -> String {
    let key = id.split('/').next().unwrap_or(id);
    format!("{}#{}", of_source(key), fragment(id))
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;
    use crate::ledger::built_in;

    #[test]
    fn addresses_differ_even_without_capitals() {
        let papers = built_in().unwrap();
        let ids = papers.iter().flat_map(|paper| &paper.statements);
        let mut seen = HashSet::new();
        for statement in ids {
            let address = of_statement(&statement.id);
            assert!(address.is_ascii() && !address.contains([' ', '"', '<']));
            assert!(
                seen.insert(address.to_lowercase()),
                "{address} stands twice"
            );
        }
        assert_eq!(of_statement("filemon1970/eq/G1"), "filemon1970.html#eq~+G1");
        assert_eq!(fragment("tesar1964/fig/37/L@0.01"), "fig~37~+L=400.01");
    }
}
