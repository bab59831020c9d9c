//! The floors of the house: a lower one never imports a higher one, rooms of one floor never in a
//! circle, subject code knows nothing of papers, and what must not share a formula does not import it.
//! The lints stand as strict as they are said to.
#![expect(
    clippy::unwrap_used,
    clippy::panic,
    clippy::string_slice,
    reason = "a test that cannot read what it tests has failed"
)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The rooms by floor, from the ground up.
const FLOORS: [&[&str]; 7] = [
    &["number"],
    &["plane"],
    &["formula", "linkage", "finite", "curvature"],
    &["straight_line"],
    &["scenes"],
    &["ledger", "oracle"],
    &["report", "testing"],
];

fn floor(room: &str) -> usize {
    FLOORS
        .iter()
        .position(|rooms| rooms.contains(&room))
        .unwrap_or_else(|| panic!("the room `{room}` has no floor; give it one in FLOORS"))
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(files_below(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// Code without comments and what stands in them.
fn code(file: &Path) -> String {
    fs::read_to_string(file)
        .unwrap()
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default())
        .collect::<Vec<_>>()
        .join("\n")
}

/// Rooms that a file names by `crate::room`, also in `use crate::{…}`.
fn imports(code: &str) -> BTreeSet<String> {
    let mut rooms = BTreeSet::new();
    for (place, _) in code.match_indices("crate::") {
        let after = code.get(place + "crate::".len()..).unwrap();
        if let Some(list) = after.strip_prefix('{') {
            let mut depth = 0;
            let mut item = String::new();
            for character in list.chars() {
                match character {
                    '{' => depth += 1,
                    '}' if depth == 0 => break,
                    '}' => depth -= 1,
                    ',' if depth == 0 => {
                        rooms.insert(first_word(&item));
                        item.clear();
                    }
                    _ if depth == 0 => item.push(character),
                    _ => {}
                }
            }
            rooms.insert(first_word(&item));
        } else {
            rooms.insert(first_word(after));
        }
    }
    rooms.remove("");
    rooms
}

fn first_word(text: &str) -> String {
    text.trim()
        .chars()
        .take_while(|character| character.is_alphanumeric() || *character == '_')
        .collect()
}

/// What comes after every occurrence of a word.
fn after<'a>(code: &'a str, word: &str) -> Vec<&'a str> {
    let places = code.match_indices(word);
    places
        .map(|(place, _)| &code[place + word.len()..])
        .collect()
}

type Rooms = BTreeMap<String, BTreeSet<String>>;

fn rooms() -> Rooms {
    let mut imported = Rooms::new();
    for entry in fs::read_dir("src").unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        if !path.is_dir() || name == "cli" {
            continue;
        }
        let of_room = imported.entry(name.clone()).or_default();
        for file in files_below(&path) {
            of_room.extend(imports(&code(&file)));
        }
        of_room.remove(&name);
    }
    imported
}

/// Rooms as they would be found.
fn planted(rooms: &[(&str, &[&str])]) -> Rooms {
    let owned = |names: &[&str]| names.iter().map(ToString::to_string).collect();
    let rooms = rooms.iter();
    rooms
        .map(|(room, others)| (room.to_string(), owned(others)))
        .collect()
}

fn upwards(rooms: &Rooms) -> Vec<String> {
    let pairs = rooms
        .iter()
        .flat_map(|(room, others)| others.iter().map(move |other| (room, other)));
    pairs
        .filter(|(room, other)| floor(other) > floor(room))
        .map(|(room, other)| format!("{room} imports {other}"))
        .collect()
}

#[test]
fn no_floor_imports_a_higher_one() {
    let rooms = rooms();
    assert!(rooms.len() >= 7, "only {} rooms found", rooms.len());
    assert_eq!(upwards(&rooms), [""; 0]);
    let wrong = planted(&[("plane", &["number", "ledger"]), ("ledger", &["plane"])]);
    assert_eq!(upwards(&wrong), ["plane imports ledger"]);
}

/// The rooms that are left when all are taken away that import none that are left.
fn in_circles(rooms: &Rooms) -> Vec<String> {
    let mut left = rooms.clone();
    loop {
        let free: Vec<String> = left
            .iter()
            .filter(|(_, imported)| imported.iter().all(|other| !left.contains_key(other)))
            .map(|(room, _)| room.clone())
            .collect();
        if free.is_empty() {
            return left.into_keys().collect();
        }
        for room in free {
            left.remove(&room);
        }
    }
}

#[test]
fn no_rooms_import_each_other_in_a_circle() {
    assert_eq!(in_circles(&rooms()), [""; 0]);
    let wrong = planted(&[
        ("finite", &["linkage", "plane"]),
        ("linkage", &["curvature"]),
        ("curvature", &["finite"]),
        ("plane", &[]),
    ]);
    assert_eq!(in_circles(&wrong), ["curvature", "finite", "linkage"]);
}

/// How far a path with `super` climbs at most.
fn climbs(code: &str) -> usize {
    let steps = |path: &str| {
        let mut rest = path;
        let mut steps = 1;
        while let Some(after) = rest.strip_prefix("super::") {
            rest = after;
            steps += 1;
        }
        steps
    };
    after(code, "super::")
        .into_iter()
        .map(steps)
        .max()
        .unwrap_or(0)
}

/// `src/room/a/b.rs` and `src/room/a/b/mod.rs` are three modules deep.
fn depth(file: &Path) -> usize {
    let below = file.strip_prefix("src").unwrap().components().count();
    below - usize::from(file.ends_with("mod.rs"))
}

#[test]
fn no_path_climbs_out_of_its_room() {
    for room in rooms().keys() {
        for file in files_below(&Path::new("src").join(room)) {
            assert!(
                climbs(&code(&file)) < depth(&file),
                "{} climbs out of its room, where imports are not seen",
                file.display()
            );
        }
    }
    assert_eq!(climbs("use super::a;\nuse super::super::{scenes};"), 2);
    assert_eq!(depth(Path::new("src/plane/angle.rs")), 2);
    assert_eq!(depth(Path::new("src/plane/mod.rs")), 1);
}

fn named<'a>(code: &str, words: &'a [String]) -> Vec<&'a str> {
    let words = words.iter().map(String::as_str);
    words.filter(|word| code.contains(word)).collect()
}

fn papers() -> Vec<String> {
    let keys = fs::read_dir("data/papers").unwrap();
    keys.map(|entry| {
        let path = entry.unwrap().path();
        path.file_stem().unwrap().to_string_lossy().into_owned()
    })
    .collect()
}

#[test]
fn subject_code_knows_no_paper() {
    let keys = papers();
    assert!(keys.len() >= 4, "{keys:?}");
    let subjects = FLOORS.iter().take_while(|rooms| !rooms.contains(&"scenes"));
    for room in subjects.copied().flatten() {
        for file in files_below(&Path::new("src").join(room)) {
            let named = named(&code(&file), &keys);
            assert!(named.is_empty(), "{} names {named:?}", file.display());
        }
    }
    assert_eq!(named("let key = \"kaufman\";", &keys), ["kaufman"]);
}

#[test]
fn the_walls_can_be_seen() {
    let sample = "use crate::number::{Ball, Kind};\nuse crate::{plane::Angle, scenes::{a, b}};";
    let found: Vec<String> = imports(sample).into_iter().collect();
    assert_eq!(found, ["number", "plane", "scenes"]);
}

/// What a scene takes from the language of formulas: only that to which it binds its symbols.
const OF_FORMULAS: [&str; 2] = ["Bindings", "Value"];

/// By what a scene could come to know the formula that is judged on it.
fn ways_to_statements(code: &str) -> Vec<String> {
    let words = ["include_str", "include_bytes", "std::fs", "data/papers"];
    let words = words.into_iter().filter(|word| code.contains(word));
    let of_formulas = after(code, "crate::formula").into_iter().flat_map(|path| {
        let path = path.split([';', ')']).next().unwrap_or_default();
        path.split([':', '{', '}', ',', ' ', '\n'])
            .map(first_word)
            .filter(|name| !name.is_empty() && !OF_FORMULAS.contains(&name.as_str()))
            .collect::<Vec<_>>()
    });
    words.map(ToOwned::to_owned).chain(of_formulas).collect()
}

#[test]
fn scenes_do_not_know_what_is_judged_on_them() {
    // Each source has a folder. That of the example, which is no source, is compiled in tests only.
    for key in papers() {
        let folder = Path::new("src/scenes").join(&key);
        let files = files_below(&folder);
        assert!(!files.is_empty(), "{key} has no scenes");
        for file in files {
            let ways = ways_to_statements(&code(&file));
            assert!(ways.is_empty(), "{} uses {ways:?}", file.display());
        }
    }
    let fair = "use crate::formula::{Bindings, Value};\nfn a() -> crate::formula::Value {}";
    assert_eq!(ways_to_statements(fair), [""; 0]);
    let wrong = "use crate::formula::{Bindings, read};\nlet print = include_str!(\"a\");";
    assert_eq!(ways_to_statements(wrong), ["include_str", "read"]);
}

/// Routes to one quantity, with the judge of their results where there is one: none names another.
const ROUTES: [(&str, &[&str]); 2] = [
    (
        "src/finite/four_positions",
        &[
            "circle_conditions",
            "isotropic",
            "loop_closure",
            "viewing_angles",
        ],
    ),
    (
        "src/finite/five_positions",
        &["circlepoint_curves", "conics", "krawczyk", "loop_closure"],
    ),
];

/// The other routes to the same quantity that are imported from its folder.
fn other_routes<'a>(code: &str, route: &str, (folder, routes): (&str, &[&'a str])) -> Vec<&'a str> {
    let own = format!("{}::", folder.rsplit('/').next().unwrap());
    let paths = ["super::", &own].map(|path| after(code, path)).concat();
    let lists = paths.iter().filter_map(|path| path.split(';').next());
    let is_no_name = |c: char| !(c.is_alphanumeric() || c == '_');
    let names: Vec<&str> = lists.flat_map(|list| list.split(is_no_name)).collect();
    let others = routes.iter().filter(|other| **other != route);
    others
        .copied()
        .filter(|other| names.contains(other))
        .collect()
}

#[test]
fn routes_of_one_quantity_do_not_import_each_other() {
    for quantity in ROUTES {
        let (folder, routes) = quantity;
        for route in routes {
            let file = Path::new(folder).join(format!("{route}.rs"));
            let others = other_routes(&code(&file), route, quantity);
            assert!(others.is_empty(), "{} imports {others:?}", file.display());
        }
    }
    let [curves @ (folder, routes), pairs] = ROUTES;
    let files = files_below(Path::new(folder));
    assert_eq!(files.len(), routes.len() + 1, "{files:?}");
    // A route to the pairs may use one to the curves.
    let wrong = "use crate::finite::four_positions::{isotropic, loop_closure};\nuse super::conics;";
    assert_eq!(other_routes(wrong, "krawczyk", pairs), ["conics"]);
    let both = ["isotropic", "loop_closure"];
    assert_eq!(other_routes(wrong, "viewing_angles", curves), both);
}

/// What the checker of answers takes from floors that solve too: how a problem is read, and one route
/// that no solver takes.
const OF_SOLVERS: [&str; 6] = [
    "finite::four_positions::loop_closure",
    "finite::positions",
    "oracle::ProblemError",
    "oracle::input",
    "oracle::positions",
    "oracle::certificate",
];

fn shared_with_solvers(code: &str) -> Vec<String> {
    let paths = after(code, "crate::").into_iter();
    let paths = paths.filter(|path| !["number", "plane"].contains(&first_word(path).as_str()));
    let shared = paths.filter(|path| !OF_SOLVERS.iter().any(|fair| path.starts_with(fair)));
    shared
        .map(|path| path.lines().next().unwrap_or_default().to_owned())
        .collect()
}

#[test]
fn checkers_of_answers_do_not_call_the_solvers() {
    for file in files_below(Path::new("src/oracle/certificate")) {
        let code = code(&file);
        let shared = shared_with_solvers(&code);
        assert!(shared.is_empty(), "{} uses {shared:?}", file.display());
        assert!(climbs(&code) < 2, "{} climbs", file.display());
    }
    for file in files_below(Path::new("src/oracle")) {
        let own_route = code(&file).contains("four_positions::loop_closure");
        let checks = file.starts_with("src/oracle/certificate");
        assert!(checks || !own_route, "{} solves by it", file.display());
    }
    let wrong = "use crate::finite::five_positions::conics;\nuse crate::plane::Point;";
    assert_eq!(
        shared_with_solvers(wrong),
        ["finite::five_positions::conics;"]
    );
}

/// What no code outside of tests does without a reason that it states.
const LINTS: [(&str, &[&str]); 2] = [
    ("rust", &["missing_docs", "unsafe_code"]),
    (
        "clippy",
        &[
            "allow_attributes",
            "allow_attributes_without_reason",
            "as_conversions",
            "expect_used",
            "incompatible_msrv",
            "indexing_slicing",
            "panic",
            "string_slice",
            "todo",
            "unimplemented",
            "unreachable",
            "unwrap_used",
        ],
    ),
];

/// Those that do not stand in the manifest, or not as warnings at least.
fn missing_lints(manifest: &str) -> Vec<String> {
    let manifest: toml::Table = manifest.parse().unwrap();
    let level = |tool: &str, lint: &str| {
        let lint = manifest.get("lints")?.get(tool)?.get(lint)?;
        lint.as_str()
            .or_else(|| lint.get("level")?.as_str())
            .map(ToOwned::to_owned)
    };
    let strict = |level: String| ["warn", "deny", "forbid"].contains(&level.as_str());
    let all = LINTS
        .iter()
        .flat_map(|(tool, lints)| lints.iter().map(move |lint| (*tool, *lint)));
    all.filter(|(tool, lint)| !level(tool, lint).is_some_and(strict))
        .map(|(tool, lint)| format!("{tool}::{lint}"))
        .collect()
}

#[test]
fn the_lints_are_as_strict_as_they_are_said_to_be() {
    let manifest = fs::read_to_string("Cargo.toml").unwrap();
    assert_eq!(missing_lints(&manifest), [""; 0]);
    let lenient = manifest
        .replace("missing_docs = \"warn\"", "missing_docs = \"allow\"")
        .replace("panic = \"warn\"", "");
    assert_eq!(
        missing_lints(&lenient),
        ["rust::missing_docs", "clippy::panic"]
    );
    // What Clippy lets pass, it lets pass in tests only.
    let settings: toml::Table = fs::read_to_string("clippy.toml").unwrap().parse().unwrap();
    for setting in settings.keys() {
        assert!(setting.ends_with("-in-tests"), "{setting}");
    }
    let checks = fs::read_to_string(".ci/run").unwrap();
    assert!(checks.contains("cargo clippy --all-targets -- -D warnings"));
}

/// Exceptions from lints that are wider than an item, have no reason, or stay when they are idle.
fn bad_exceptions(code: &str) -> Vec<String> {
    let attributes = after(code, "#").into_iter();
    let attributes = attributes.filter_map(|text| {
        let attribute = text.trim_start_matches('!');
        let (name, rest) = attribute.strip_prefix('[')?.split_once('(')?;
        let is_exception =
            ["allow", "expect"].contains(&name) || rest.contains("allow(") && name == "cfg_attr";
        is_exception.then(|| text.split_once(")]").map_or(text, |(one, _)| one))
    });
    attributes
        .filter(|one| !one.starts_with("[expect(") || !one.contains("reason = \""))
        .map(ToOwned::to_owned)
        .collect()
}

#[test]
fn exceptions_from_lints_are_narrow_and_have_reasons() {
    for file in files_below(Path::new("src")) {
        let bad = bad_exceptions(&code(&file));
        assert!(bad.is_empty(), "{}: {bad:?}", file.display());
    }
    let fair = "#[expect(clippy::panic, reason = \"a\")]\n#[derive(Debug)]";
    assert_eq!(bad_exceptions(fair), [""; 0]);
    for wrong in [
        "#![expect(clippy::panic, reason = \"a\")]",
        "#[expect(clippy::panic)]",
        "#[allow(clippy::panic, reason = \"a\")]",
        "#[cfg_attr(unix, allow(clippy::panic))]",
    ] {
        assert_eq!(bad_exceptions(wrong).len(), 1, "{wrong}");
    }
}
