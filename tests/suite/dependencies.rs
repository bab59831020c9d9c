//! What the project depends on: `docs/dependencies.md` has every package of the lock file with its
//! licence and with the Rust that it asks for. `BURMESTER_WRITE=1` writes it anew, which may download
//! packages of other systems; else nothing is downloaded.
#![expect(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test that cannot read what it tests has failed"
)]

use std::collections::{BTreeMap, BTreeSet};
use std::process::Command;
use std::sync::LazyLock;

use serde_json::Value;

const LIST: &str = "docs/dependencies.md";

/// Licences that ask for no more than their text beside a copy.
const FREE: [&str; 7] = [
    "Apache-2.0",
    "BSD-2-Clause",
    "MIT",
    "MIT-0",
    "Unicode-3.0",
    "Unlicense",
    "Zlib",
];

/// Packages under another licence.
const OTHERS: [(&str, &str); 2] = [("gmp-mpfr-sys", "LGPL-3.0+"), ("rug", "LGPL-3.0+")];

/// A package of a version.
type Package = (String, String);

#[derive(Clone, Debug, PartialEq, Eq)]
struct Row {
    licence: String,
    /// The least version of Rust; empty where none is declared.
    rust: String,
    needed: Needed,
}

/// What a package is needed for, the first of these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Needed {
    Library,
    Command,
    Tests,
}

impl Needed {
    const ALL: [Self; 3] = [Self::Library, Self::Command, Self::Tests];

    fn word(self) -> &'static str {
        match self {
            Needed::Library => "library",
            Needed::Command => "command",
            Needed::Tests => "tests",
        }
    }
}

type Table = BTreeMap<Package, Row>;

fn run_cargo(arguments: &[&str]) -> String {
    let cargo = Command::new(env!("CARGO"))
        .args(arguments)
        .output()
        .unwrap();
    let errors = String::from_utf8_lossy(&cargo.stderr);
    assert!(cargo.status.success(), "cargo {arguments:?}: {errors}");
    String::from_utf8(cargo.stdout).unwrap()
}

/// What Cargo knows, for one system or all.
fn metadata(system: &[&str], features: &[&str]) -> Value {
    let start = ["metadata", "--locked", "--format-version", "1"];
    let arguments = [&start, system, features].concat();
    serde_json::from_str(&run_cargo(&arguments)).unwrap()
}

fn text(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

/// The packages that are reached from this one, over its own dependencies of tests or not.
fn reached(metadata: &Value, with_tests: bool) -> BTreeSet<String> {
    let resolved = &metadata["resolve"];
    let nodes = resolved["nodes"].as_array().unwrap().iter();
    let nodes: BTreeMap<String, &Value> = nodes.map(|node| (text(&node["id"]), node)).collect();
    let root = text(&resolved["root"]);
    let mut reached = BTreeSet::new();
    let mut waiting = vec![root.clone()];
    while let Some(id) = waiting.pop() {
        let with_tests = with_tests && id == root;
        for dependency in nodes.get(&id).unwrap()["deps"].as_array().unwrap() {
            let kinds = dependency["dep_kinds"].as_array().unwrap();
            if with_tests || kinds.iter().any(|kind| kind["kind"] != "dev") {
                waiting.extend(
                    [text(&dependency["pkg"])]
                        .into_iter()
                        .filter(|next| !reached.contains(next)),
                );
            }
        }
        reached.insert(id);
    }
    reached
}

/// The table as it is, for one system or all.
fn found(system: &[&str]) -> Table {
    let whole = metadata(system, &[]);
    let library = reached(&metadata(system, &["--no-default-features"]), false);
    let command = reached(&whole, false);
    let all = reached(&whole, true);
    let own = text(&whole["resolve"]["root"]);
    let packages = whole["packages"].as_array().unwrap().iter();
    let packages =
        packages.filter(|package| package["id"] != *own && all.contains(&text(&package["id"])));
    packages
        .map(|package| {
            let id = text(&package["id"]);
            let needed = if library.contains(&id) {
                Needed::Library
            } else if command.contains(&id) {
                Needed::Command
            } else {
                Needed::Tests
            };
            let row = Row {
                licence: text(&package["license"]),
                rust: text(&package["rust_version"]),
                needed,
            };
            ((text(&package["name"]), text(&package["version"])), row)
        })
        .collect()
}

fn written(table: &Table) -> String {
    let mut lines = vec![
        "| package | version | licence | Rust | needed for |".to_owned(),
        "| --- | --- | --- | --- | --- |".to_owned(),
    ];
    lines.extend(table.iter().map(|((name, version), row)| {
        let Row {
            licence,
            rust,
            needed,
        } = row;
        let rust = if rust.is_empty() { "—" } else { rust };
        format!(
            "| {name} | {version} | {licence} | {rust} | {} |",
            needed.word()
        )
    }));
    lines.join("\n") + "\n"
}

fn read(list: &str) -> Table {
    let lines = list.lines().filter(|line| line.starts_with("| ")).skip(2);
    lines
        .map(|line| {
            let cells: Vec<String> = line.split('|').map(|cell| cell.trim().to_owned()).collect();
            let [_, name, version, licence, rust, needed, _] = cells.try_into().unwrap();
            let row = Row {
                licence,
                rust: rust.replace('—', ""),
                needed: *Needed::ALL.iter().find(|one| one.word() == needed).unwrap(),
            };
            ((name, version), row)
        })
        .collect()
}

static TABLE: LazyLock<Table> = LazyLock::new(list);

/// The list, which is written first where that is asked for.
fn list() -> Table {
    let list = std::fs::read_to_string(LIST).unwrap();
    if std::env::var("BURMESTER_WRITE").is_err() {
        return read(&list);
    }
    let table = found(&[]);
    let start = list.find("| package").unwrap_or(list.len());
    let (prose, _) = list.split_at(start);
    std::fs::write(LIST, prose.to_owned() + &written(&table)).unwrap();
    table
}

fn locked() -> BTreeSet<Package> {
    let lock: toml::Table = std::fs::read_to_string("Cargo.lock")
        .unwrap()
        .parse()
        .unwrap();
    let packages = lock["package"].as_array().unwrap().iter();
    let packages = packages.map(|package| {
        let field = |name: &str| package[name].as_str().unwrap().to_owned();
        (field("name"), field("version"))
    });
    packages
        .filter(|(name, _)| name != env!("CARGO_PKG_NAME"))
        .collect()
}

/// Whether one of the alternatives is free in every part of an expression.
fn is_free(licence: &str) -> bool {
    let parts = licence.split(" AND ");
    parts.into_iter().all(|part| {
        let part = part.trim_matches(['(', ')']).replace('/', " OR ");
        part.split(" OR ").any(|one| FREE.contains(&one))
    })
}

fn is_allowed((name, _): &Package, licence: &str) -> bool {
    is_free(licence) || OTHERS.contains(&(name.as_str(), licence))
}

fn version(text: &str) -> [u32; 3] {
    let mut numbers = text.split('.').map(|number| number.parse().unwrap());
    std::array::from_fn(|_| numbers.next().unwrap_or(0))
}

#[test]
fn the_list_is_complete_and_true() {
    let listed: BTreeSet<Package> = TABLE.keys().cloned().collect();
    let locked = locked();
    let difference: Vec<&Package> = locked.symmetric_difference(&listed).collect();
    assert!(
        difference.is_empty(),
        "{LIST} and Cargo.lock: {difference:?}"
    );
    let system = run_cargo(&["-vV"]);
    let system = system
        .lines()
        .find_map(|line| line.strip_prefix("host: "))
        .unwrap();
    let here = found(&["--offline", "--filter-platform", system]);
    assert!(here.len() > 100, "{}", here.len());
    for (package, row) in here {
        let listed = TABLE.get(&package).unwrap();
        assert_eq!(
            (&listed.licence, &listed.rust),
            (&row.licence, &row.rust),
            "{package:?}"
        );
        // On another system it may be needed for more.
        assert!(listed.needed <= row.needed, "{package:?}: {row:?}");
    }
    assert_eq!(read(&written(&TABLE)), *TABLE);
}

#[test]
fn all_licences_are_allowed() {
    for (package, row) in TABLE.iter() {
        assert!(
            is_allowed(package, &row.licence),
            "{package:?}: {}",
            row.licence
        );
    }
    let of = |name: &str| (name.to_owned(), "1.0.0".to_owned());
    for (name, licence, expected) in [
        ("a", "MIT/Apache-2.0", true),
        ("a", "MIT OR Apache-2.0 OR LGPL-2.1-or-later", true),
        ("a", "(MIT OR Apache-2.0) AND Unicode-3.0", true),
        ("rug", "LGPL-3.0+", true),
        ("a", "LGPL-3.0+", false),
        ("a", "MIT AND GPL-3.0", false),
        ("a", "", false),
    ] {
        assert_eq!(
            is_allowed(&of(name), licence),
            expected,
            "{name}: {licence}"
        );
    }
}

#[test]
fn none_asks_for_a_newer_rust() {
    let own = version(env!("CARGO_PKG_RUST_VERSION"));
    for (package, row) in TABLE.iter().filter(|(_, row)| !row.rust.is_empty()) {
        assert!(version(&row.rust) <= own, "{package:?}: {}", row.rust);
    }
    assert!(version("1.88") < version("1.88.1") && version("1.9") < version("1.88"));
}
