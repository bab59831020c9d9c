//! The pages of scenes and checks: what the symbols mean, and the code that says so.

use std::collections::BTreeMap;

use include_dir::{Dir, include_dir};
use maud::{Markup, html};

use super::{File, address, layout};
use crate::ledger::{Decided, Judged};
use crate::scenes::check::Check;
use crate::scenes::{self, Scene};

/// The code of all scenes and checks.
static SCENES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/src/scenes");
/// Where that is in the repository.
const FOLDER: &str = "src/scenes/";

/// Where a scene is explained.
pub fn of_scene(scene: &Scene) -> String {
    format!(
        "{}#{}",
        page_of(within(scene.file)),
        anchor("scene", scene.name)
    )
}

/// Where a check is explained; the page itself where its code is not found.
pub fn of_check(name: &str) -> String {
    match file_that_says(name) {
        Some((file, _)) => format!("{}#{}", page_of(&file), anchor("check", name)),
        None => String::new(),
    }
}

fn anchor(kind: &str, name: &str) -> String {
    format!("{kind}-{}", address::encoded(name))
}

/// A file below the folder of scenes.
fn within(file: &str) -> &str {
    file.split_once(FOLDER).map_or(file, |(_, rest)| rest)
}

fn page_of(file: &str) -> String {
    let name = file.trim_end_matches(".rs").replace('/', ".");
    format!("code/{}.html", address::encoded(&name))
}

/// All files with their code.
fn files() -> Vec<(String, &'static str)> {
    fn collect(dir: &'static Dir<'static>, files: &mut Vec<(String, &'static str)>) {
        for file in dir.files() {
            if let (Some(path), Some(code)) = (file.path().to_str(), file.contents_utf8()) {
                files.push((path.replace('\\', "/"), code));
            }
        }
        for dir in dir.dirs() {
            collect(dir, files);
        }
    }
    let mut all = Vec::new();
    collect(&SCENES, &mut all);
    all.sort();
    all
}

/// The file that holds the check or table of this name.
fn file_that_says(name: &str) -> Option<(String, &'static str)> {
    let said = format!("name: \"{name}\"");
    files().into_iter().find(|(_, code)| code.contains(&said))
}

/// A page for each file that holds a scene or a check.
pub fn pages(sources: &[Judged<'_>]) -> Vec<File> {
    let mut used: BTreeMap<&str, Vec<Decided<'_>>> = BTreeMap::new();
    for decided in sources.iter().flat_map(Judged::decided) {
        used.entry(decided.statement.scene.name)
            .or_default()
            .push(decided);
    }
    let pages = files().into_iter().filter_map(|(file, code)| {
        let scenes: Vec<&Scene> = scenes::scenes()
            .iter()
            .filter(|scene| within(scene.file) == file)
            .collect();
        let checks: Vec<&Check> = scenes::checks()
            .iter()
            .filter(|check| code.contains(&format!("name: \"{}\"", check.name)))
            .collect();
        let is_empty = scenes.is_empty() && checks.is_empty();
        (!is_empty).then(|| page(&file, code, &scenes, &checks, &used))
    });
    pages.collect()
}

fn page(
    file: &str,
    code: &str,
    scenes: &[&Scene],
    checks: &[&Check],
    used: &BTreeMap<&str, Vec<Decided<'_>>>,
) -> File {
    let content = html! {
        h1 { code { (FOLDER) (file) } }
        @for scene in scenes { (scene_of(scene, used.get(scene.name).map_or(&[], Vec::as_slice))) }
        @for check in checks {
            section aria-labelledby=(anchor("check", check.name)) {
                h2 #(anchor("check", check.name)) { "Check " (check.name) }
                p { (check.summary) }
            }
        }
        section aria-labelledby="code" {
            h2 #code { "Code" }
            pre tabindex="0" { code { (code) } }
        }
    };
    layout::page(&page_of(file), file, &content)
}

fn scene_of(scene: &Scene, used: &[Decided<'_>]) -> Markup {
    html! {
        section aria-labelledby=(anchor("scene", scene.name)) {
            h2 #(anchor("scene", scene.name)) { "Scene " (scene.name) }
            p { (scene.summary) }
            dl.words {
                @for symbol in scene.symbols {
                    dt { code { (symbol.name) } }
                    dd { (symbol.meaning) }
                }
            }
            @if !used.is_empty() {
                details {
                    summary { (used.len()) " statements are judged on it" }
                    ul.kinds {
                        @for decided in used {
                            li {
                                a href={ "../" (address::of_statement(&decided.statement.id)) } {
                                    (decided.statement.id)
                                }
                                " " (layout::verdict(decided.judgement.verdict))
                            }
                        }
                    }
                }
            }
        }
    }
}
