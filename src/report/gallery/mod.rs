//! The pictures beside the statements of each source.

use thiserror::Error;

/// A picture that a page shows.
#[derive(Clone, Debug)]
pub struct Exhibit {
    /// It stands before the first statement whose id begins so.
    pub beside: String,
    /// What it is.
    pub title: String,
    /// What to see in it.
    pub caption: String,
    /// The picture.
    pub svg: String,
    /// Whether it moves.
    pub moving: bool,
}

/// A picture that cannot be drawn.
#[derive(Clone, Debug, Error)]
#[error("{0}")]
pub struct GalleryError(pub String);

/// The pictures of a source, in the order of the data.
///
/// # Errors
/// A picture that cannot be drawn.
pub fn of_source(_key: &str) -> Result<Vec<Exhibit>, GalleryError> {
    Ok(Vec::new())
}
