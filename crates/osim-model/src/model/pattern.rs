//! Patterns of names, such as `*_r`.

use std::fmt;
use std::str::FromStr;

use globset::{GlobBuilder, GlobSet, GlobSetBuilder};

/// A pattern of names: `*` is anything, `?` one letter, `[rl]` one of some, `{heel,toe}*` one of several. Upper and lower case
/// differ.
///
/// ```
/// use osim_model::Pattern;
///
/// let right: Pattern = "*_r".parse()?;
/// assert!(right.matches("heel_r") && !right.matches("heel_l"));
/// # Ok::<(), osim_model::PatternError>(())
/// ```
#[derive(Clone)]
pub struct Pattern {
    text: String,
    matcher: GlobSet,
}

/// Why a text is not a pattern, in words.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct PatternError(String);

impl Pattern {
    /// Whether `name` is as the pattern says.
    #[must_use]
    pub fn matches(&self, name: &str) -> bool {
        self.matcher.is_match(name)
    }

    /// The pattern as it was written.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.text
    }
}

/// Whether `name` is as one of `patterns` says.
pub(crate) fn any_matches(patterns: &[Pattern], name: &str) -> bool {
    patterns.iter().any(|pattern| pattern.matches(name))
}

impl FromStr for Pattern {
    type Err = PatternError;

    fn from_str(text: &str) -> Result<Self, PatternError> {
        let failed = |error: &globset::Error| PatternError(error.kind().to_string());
        let glob = GlobBuilder::new(text).literal_separator(false).build().map_err(|error| failed(&error))?;
        let mut matcher = GlobSetBuilder::new();
        matcher.add(glob);
        Ok(Self { text: text.to_owned(), matcher: matcher.build().map_err(|error| failed(&error))? })
    }
}

impl fmt::Display for Pattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl fmt::Debug for Pattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.text)
    }
}

impl PartialEq for Pattern {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl Eq for Pattern {}
