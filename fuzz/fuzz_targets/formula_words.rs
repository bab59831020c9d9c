#![no_main]

#[allow(dead_code)]
#[path = "../../tests/suite/fuzz/mod.rs"]
mod fuzz;

libfuzzer_sys::fuzz_target!(|data: &[u8]| fuzz::formula_words(data));
