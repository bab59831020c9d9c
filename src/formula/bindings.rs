//! What the symbols of a formula stand for.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::fmt;
use std::rc::Rc;

use super::value::Value;
use crate::number::{Number, Real};

/// What the symbols of a formula stand for.
#[derive(Clone, Debug)]
pub struct Bindings<K: Real> {
    values: BTreeMap<String, Bound<K>>,
    precision: K::Precision,
}

#[derive(Clone, Debug)]
enum Bound<K> {
    Now(Value<K>),
    /// One of several numbers that are computed together, by its place among them.
    Later(Rc<Later<K>>, usize),
}

/// Numbers that are computed when one of them is asked for.
struct Later<K> {
    compute: Box<dyn Fn() -> Option<Vec<Number<K>>>>,
    values: OnceCell<Option<Vec<Value<K>>>>,
    none: Value<K>,
}

impl<K: Real> Later<K> {
    fn values(&self) -> Option<&Vec<Value<K>>> {
        let compute = || {
            let numbers = (self.compute)()?.into_iter();
            Some(numbers.map(Value::Number).collect())
        };
        self.values.get_or_init(compute).as_ref()
    }

    fn value(&self, place: usize) -> &Value<K> {
        let value = self.values().and_then(|values| values.get(place));
        value.unwrap_or(&self.none)
    }
}

impl<K: fmt::Debug> fmt::Debug for Later<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Later").field(&self.values).finish()
    }
}

impl<K: Real> Bindings<K> {
    /// No symbols yet; constants of formulas are taken to this precision.
    pub fn new(precision: K::Precision) -> Self {
        Bindings {
            values: BTreeMap::new(),
            precision,
        }
    }

    /// Binds a name.
    pub fn bind(&mut self, name: &str, value: impl Into<Value<K>>) {
        let value = Bound::Now(value.into());
        self.values.insert(name.to_owned(), value);
    }

    /// Binds names to numbers that cost much, and that are computed when one of them is asked for. Where
    /// that fails, they have no value.
    pub fn bind_later(
        &mut self,
        names: impl IntoIterator<Item = String>,
        compute: impl Fn() -> Option<Vec<Number<K>>> + 'static,
    ) {
        let later = Rc::new(Later {
            compute: Box::new(compute),
            values: OnceCell::new(),
            none: Value::Number(Number::zero().inverse()),
        });
        for (place, name) in names.into_iter().enumerate() {
            self.values.insert(name, Bound::Later(later.clone(), place));
        }
    }

    /// What a name stands for.
    pub fn get(&self, name: &str) -> Option<&Value<K>> {
        Some(match self.values.get(name)? {
            Bound::Now(value) => value,
            Bound::Later(later, place) => later.value(*place),
        })
    }

    /// Whether nothing that is computed later fails.
    pub fn is_complete(&self) -> bool {
        self.values.values().all(|bound| match bound {
            Bound::Now(_) => true,
            Bound::Later(later, _) => later.values().is_some(),
        })
    }

    /// All names, in alphabetical order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.values.keys().map(String::as_str)
    }

    /// To what constants are rounded.
    pub fn precision(&self) -> &K::Precision {
        &self.precision
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;
    use crate::number::Exact;

    #[test]
    fn what_is_bound_later_is_computed_once_and_when_it_is_asked_for() {
        let asked = Rc::new(Cell::new(0));
        let mut bindings = Bindings::<Exact>::new(());
        let names = ["x", "y", "z"].map(str::to_owned);
        let counter = asked.clone();
        bindings.bind_later(names, move || {
            counter.set(counter.get() + 1);
            Some(vec![Number::one(), Number::from(2)])
        });
        bindings.bind("w", Number::<Exact>::zero());
        assert!(bindings.get("w").is_some());
        assert_eq!(asked.get(), 0);
        let is = |name: &str, i: i64| match bindings.get(name) {
            Some(Value::Number(number)) => number.equals(&i.into()).is_yes(),
            _ => false,
        };
        assert!(is("x", 1) && is("y", 2) && is("x", 1));
        assert_eq!(asked.get(), 1);
        assert!(!bindings.get("z").unwrap().has_value());
        assert!(bindings.is_complete());
        assert_eq!(bindings.names().collect::<String>(), "wxyz");
    }

    #[test]
    fn what_fails_has_no_value() {
        let mut bindings = Bindings::<Exact>::new(());
        bindings.bind_later(["x".to_owned()], || None);
        assert!(!bindings.get("x").unwrap().has_value());
        assert!(!bindings.is_complete());
    }
}
