//! One section about a model.

use serde::Serialize;

/// One section, without its heading.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct Section {
    /// Its name, such as `plots`.
    pub id: &'static str,
    /// Its heading.
    pub title: &'static str,
    /// Its body.
    pub html: String,
}
