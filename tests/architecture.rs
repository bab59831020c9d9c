//! The floors of the house: a lower one never imports a higher one, rooms of one floor never in a
//! circle, and subject code knows nothing of papers.
#![expect(
    clippy::unwrap_used,
    clippy::panic,
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

fn rooms() -> BTreeMap<String, BTreeSet<String>> {
    let mut imported: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
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

#[test]
fn no_floor_imports_a_higher_one() {
    let rooms = rooms();
    assert!(rooms.len() >= 7, "only {} rooms found", rooms.len());
    for (room, imported) in &rooms {
        for other in imported {
            assert!(
                floor(other) <= floor(room),
                "{room} (floor {}) imports {other} (floor {})",
                floor(room) + 1,
                floor(other) + 1
            );
        }
    }
}

#[test]
fn no_rooms_import_each_other_in_a_circle() {
    let mut left = rooms();
    while !left.is_empty() {
        let free: Vec<String> = left
            .iter()
            .filter(|(_, imported)| imported.iter().all(|other| !left.contains_key(other)))
            .map(|(room, _)| room.clone())
            .collect();
        assert!(!free.is_empty(), "a circle among {:?}", left.keys());
        for room in free {
            left.remove(&room);
        }
    }
}

#[test]
fn subject_code_knows_no_paper() {
    let keys: Vec<String> = fs::read_dir("data/papers")
        .unwrap()
        .map(|entry| {
            entry
                .unwrap()
                .path()
                .file_stem()
                .unwrap()
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    for room in [
        "number",
        "plane",
        "formula",
        "linkage",
        "finite",
        "curvature",
        "straight_line",
    ] {
        let folder = Path::new("src").join(room);
        if !folder.exists() {
            continue;
        }
        for file in files_below(&folder) {
            let code = code(&file);
            for key in &keys {
                assert!(
                    !code.contains(key.as_str()),
                    "{} names {key}",
                    file.display()
                );
            }
        }
    }
}

#[test]
fn the_walls_can_be_seen() {
    let sample = "use crate::number::{Ball, Kind};\nuse crate::{plane::Angle, scenes::{a, b}};";
    let found: Vec<String> = imports(sample).into_iter().collect();
    assert_eq!(found, ["number", "plane", "scenes"]);
}

#[test]
fn routes_of_one_quantity_do_not_import_each_other() {
    let folder = Path::new("src/finite/four_positions");
    let routes: Vec<PathBuf> = files_below(folder)
        .into_iter()
        .filter(|file| !file.ends_with("mod.rs"))
        .collect();
    assert_eq!(routes.len(), 4, "{routes:?}");
    for file in &routes {
        let code = code(file);
        for other in routes.iter().filter(|other| *other != file) {
            let name = other.file_stem().unwrap().to_string_lossy();
            assert!(
                !code.contains(&*name),
                "{} names the route {name}",
                file.display()
            );
        }
    }
}
