//! Choices taken from bytes, so that a fuzzer steers them.

/// Bytes that are used up one after the other; zeros when there are none left.
pub struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Bytes(bytes)
    }

    pub fn next(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else {
            return 0;
        };
        self.0 = rest;
        *first
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Below `count`; 0 where there is no choice.
    pub fn below(&mut self, count: usize) -> usize {
        usize::from(self.next()) % count.max(1)
    }

    /// One of `what`.
    pub fn of<'b, T>(&mut self, what: &'b [T]) -> Option<&'b T> {
        what.get(self.below(what.len()))
    }
}
