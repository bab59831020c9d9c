//! Files that are there whole or not at all.

use std::io;
use std::path::{Path, PathBuf};

/// Writes a file whole or not at all: beside its place first, then into it.
pub fn write_whole(file: &Path, text: &str) -> io::Result<()> {
    let mut beside = file.as_os_str().to_owned();
    beside.push(format!(".{}.part", std::process::id()));
    let beside = PathBuf::from(beside);
    let written = std::fs::write(&beside, text).and_then(|()| std::fs::rename(&beside, file));
    if written.is_err() {
        // Nothing more can be done about a leftover that cannot be removed.
        let _ = std::fs::remove_file(&beside);
    }
    written
}
