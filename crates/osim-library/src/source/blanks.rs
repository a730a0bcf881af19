//! Names with blanks that came without quotes, so that each part became a word of its own.

use std::ffi::OsString;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// More words than this are not one name.
const MOST: usize = 12;

/// Words that are one name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SplitName {
    /// Which of the words.
    pub words: Range<usize>,
    /// The name that they make with blanks between them.
    pub name: PathBuf,
    /// Whether it is there.
    pub exists: bool,
}

impl SplitName {
    /// The first run of words that are files only together, or look like one: the last is the first with the ending of a model.
    #[must_use]
    pub fn find(words: &[PathBuf]) -> Option<Self> {
        (0..words.len()).find_map(|start| Self::at(words, start))
    }

    /// The same where it begins with word `start`.
    pub(super) fn at(words: &[PathBuf], start: usize) -> Option<Self> {
        let rest = words.get(start..)?;
        let parts = rest.iter().skip(1).take_while(|word| word.as_os_str() != "-").take(MOST).count() + 1;
        let mut name = rest.first().filter(|word| !word.exists() && !is_model(word))?.as_os_str().to_owned();
        let mut likely = None;
        let mut are_parts = true;
        for end in 1..parts {
            let word = rest.get(end)?;
            name = joined(name, word);
            let path = PathBuf::from(&name);
            let exists = path.exists();
            // What is there by itself is a part only of what is there as a whole.
            are_parts = are_parts && !word.exists();
            let found = Self { words: start..start + end + 1, name: path, exists };
            if exists {
                return Some(found);
            }
            likely = likely.or_else(|| (are_parts && is_model(&found.name)).then_some(found));
        }
        likely
    }

    /// What is wrong, and what to write.
    #[must_use]
    pub fn message(&self, first: &Path) -> String {
        format!("'{}' is {}", first.display(), self.reason())
    }

    /// The same after the name of the first word.
    #[must_use]
    pub fn reason(&self) -> String {
        let name = self.name.display();
        let there = if self.exists { format!(", but '{name}' is") } else { String::new() };
        format!("not there{there}: a name with a blank needs quotes, \"{name}\"")
    }
}

fn joined(mut name: OsString, word: &Path) -> OsString {
    name.push(" ");
    name.push(word);
    name
}

fn is_model(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("osim"))
}
