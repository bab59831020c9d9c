//! JSON that a schema of `data/schema` describes, drawn by bytes. What a schema cannot say (cosine and
//! sine that belong together) is often wrong, which is as good.

use serde_json::{Map, Value, json};

use super::bytes::Bytes;

/// Numbers as people and programs write them, and some that are hard.
const NUMBERS: [&str; 26] = [
    "0",
    "1",
    "-1",
    "2",
    "3",
    "-4",
    "5",
    "1/2",
    "-3/7",
    "3/5",
    "4/5",
    "12/13",
    "-5/13",
    "0.1",
    "-2.50",
    "90",
    "30",
    "60",
    "180",
    "-45",
    "1e-9",
    "1e30",
    "-1e-30",
    "1000000007",
    "0.70710678",
    "1/3",
];

/// Deeper than any problem.
const DEEPEST: usize = 24;

fn document(id: &str) -> Option<&'static str> {
    macro_rules! documents {
        ($($name:literal),*) => {
            match id {
                $($name => Some(include_str!(concat!("../../../data/schema/", $name, ".json"))),)*
                _ => None,
            }
        };
    }
    documents!(
        "number",
        "geometry",
        "centerpoint-curve.problem",
        "curvature.problem",
        "deviation.problem",
        "five-positions.problem",
        "focal-mechanism.problem",
        "four-bar.problem",
        "hart.problem",
        "mixed-positions.problem",
        "poles.problem",
        "slider-crank-alternates.problem",
        "straight-line.problem",
        "three-positions.problem"
    )
}

/// A document of JSON that follows a schema, named as in `$ref` without the scheme.
pub struct Schema {
    name: String,
    root: Value,
}

impl Schema {
    pub fn named(name: &str) -> Option<Schema> {
        let root = serde_json::from_str(document(name)?).ok()?;
        Some(Schema {
            name: name.to_owned(),
            root,
        })
    }

    /// Something that follows the schema.
    pub fn draw(&self, bytes: &mut Bytes<'_>) -> Value {
        self.value(&self.root, bytes, 0)
    }

    fn value(&self, schema: &Value, bytes: &mut Bytes<'_>, depth: usize) -> Value {
        if depth > DEEPEST {
            return Value::Null;
        }
        if let Some(reference) = schema["$ref"].as_str() {
            return self.referred(reference, bytes, depth);
        }
        if let Some(constant) = schema.get("const") {
            return constant.clone();
        }
        if let Some(value) = schema["enum"].as_array().and_then(|all| bytes.of(all)) {
            return value.clone();
        }
        let form = schema["oneOf"].as_array().and_then(|all| bytes.of(all));
        if let (Some(form), None) = (form, schema.get("properties")) {
            return self.value(form, bytes, depth + 1);
        }
        match schema["type"].as_str() {
            Some("object") => self.object(schema, form, bytes, depth),
            Some("array") => self.array(schema, bytes, depth),
            Some("string") if schema.get("pattern").is_some() => number(bytes),
            Some("string") => json!("x"),
            Some("number" | "integer") => json!(bytes.below(40)),
            Some("boolean") => json!(bytes.below(2) == 1),
            _ => Value::Null,
        }
    }

    fn referred(&self, reference: &str, bytes: &mut Bytes<'_>, depth: usize) -> Value {
        let (id, path) = reference.split_once('#').unwrap_or((reference, ""));
        let name = id.strip_prefix("burmester:").unwrap_or(&self.name);
        if name == self.name {
            let part = self.root.pointer(path).unwrap_or(&Value::Null);
            return self.value(part, bytes, depth + 1);
        }
        let Some(other) = Schema::named(name) else {
            return Value::Null;
        };
        let part = other.root.pointer(path).unwrap_or(&Value::Null);
        other.value(part, bytes, depth + 1)
    }

    /// With the fields that one of its forms asks for.
    fn object(
        &self,
        schema: &Value,
        form: Option<&Value>,
        bytes: &mut Bytes<'_>,
        depth: usize,
    ) -> Value {
        let lists = [Some(schema), form].into_iter().flatten();
        let required: Vec<&str> = lists
            .filter_map(|one| one["required"].as_array())
            .flatten()
            .filter_map(Value::as_str)
            .collect();
        let mut made = Map::new();
        for (name, part) in schema["properties"].as_object().into_iter().flatten() {
            let remark = ["id", "kind", "flags", "note", "claims"].contains(&name.as_str());
            if required.contains(&name.as_str()) || !remark && bytes.below(3) == 1 {
                made.insert(name.clone(), self.value(part, bytes, depth + 1));
            }
        }
        Value::Object(made)
    }

    fn array(&self, schema: &Value, bytes: &mut Bytes<'_>, depth: usize) -> Value {
        let bound = |word: &str| {
            let found = schema[word].as_u64();
            found.and_then(|count| usize::try_from(count).ok())
        };
        let least = bound("minItems").unwrap_or(0);
        let most = bound("maxItems").unwrap_or(least + 5);
        let count = least + bytes.below(most - least + 1);
        (0..count)
            .map(|_| self.value(&schema["items"], bytes, depth + 1))
            .collect()
    }
}

fn number(bytes: &mut Bytes<'_>) -> Value {
    let text = match bytes.below(4) {
        0 => format!("{}", i64::from(bytes.next()) - 128),
        1 => format!(
            "{}/{}",
            i64::from(bytes.next()) - 128,
            1 + u16::from(bytes.next())
        ),
        _ => bytes.of(&NUMBERS).copied().unwrap_or("0").to_owned(),
    };
    Value::String(text)
}
