//! With free symbols a claim holds only if it does for all their values.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot read what it tests has failed"
)]

use burmester::formula::{Bindings, evaluate, read};
use burmester::number::{Fraction, Ring, Truth};

fn truth(text: &str) -> Truth {
    let ring = Ring::free(&["a", "b"]).unwrap();
    let ring = ring.with_positive("p").unwrap();
    let [a, b, p] = ring.numbers();
    let mut bindings = Bindings::<Fraction>::new(());
    for (name, number) in [("a", a), ("b", b), ("p", p)] {
        bindings.bind(name, number);
    }
    evaluate(&read(text).unwrap(), &bindings).unwrap().holds
}

#[test]
fn an_identity_holds() {
    for text in ["(a + b)^2 = a^2 + 2 a b + b^2", "p ≥ 0", "a^2 + p ≥ 0"] {
        assert_eq!(truth(text), Truth::Yes, "{text}");
    }
}

/// What is true but for some values is no identity, and neither is what follows from something that
/// is false but for some values.
#[test]
fn what_fails_for_some_values_is_no_identity() {
    for text in [
        "a != b",
        "not a = b",
        "a = 1 if a = b",
        "a = 1 iff b = 1",
        "a = b or a != b",
        "a^2 > 0",
        "p > 1",
        "not (a < b)",
        "not collinear(0, a, b + i)",
    ] {
        assert_ne!(truth(text), Truth::Yes, "{text}");
    }
}
