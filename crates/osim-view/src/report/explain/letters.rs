//! Letters that a reader can see.

use super::ascii::ascii;

/// Which letters a text may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Letters {
    /// All of them.
    #[default]
    Unicode,
    /// Only those of old consoles: `alpha`, `sqrt(R)`.
    Ascii,
}

impl Letters {
    /// `text` in these letters. It is done before the layout, since spellings differ in length.
    pub(super) fn spelled(self, text: &str) -> String {
        match self {
            Self::Unicode => text.to_owned(),
            Self::Ascii => ascii(text),
        }
    }
}
