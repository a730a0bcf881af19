//! Names of objects: names that OpenSim accepts, patterns of names, misspelled names, and the side of the body in a name.

use std::borrow::Cow;
use std::cell::LazyCell;
use std::fmt;
use std::str::FromStr;

use globset::{GlobBuilder, GlobSet, GlobSetBuilder};

use crate::messages::{is_visible, named};
use crate::model::fault::{Fault, Result};

/// Letters in a name for which OpenSim refuses a whole model.
const REFUSED_LETTERS: &str = "\\*+/ \t\r\n\u{b}\u{c}";
/// The advice at the end of each error about a name.
const NAME_ADVICE: &str = "choose letters, digits, '_' or '-'";

/// Refuses a name that OpenSim would refuse, and a name with invisible letters.
///
/// ```
/// assert!(osim_model::refuse_name("heel_r").is_ok());
/// let fault = osim_model::refuse_name("right heel").unwrap_err();
/// assert!(fault.to_string().contains("has a blank in it"), "{fault}");
/// ```
///
/// # Errors
/// The name is empty, is a step in OpenSim's paths (such as `..`), or has a letter that OpenSim or XML refuses or that is invisible.
pub fn refuse_name(name: &str) -> Result<()> {
    refuse_name_in_paths(name)?;
    match name.chars().find(|&letter| !is_visible(letter)) {
        Some(letter) => Err(Fault::refused(format!(
            "the name '{name}' has an invisible letter in it (U+{:04X}), perhaps from copying: {NAME_ADVICE}",
            u32::from(letter)
        ))),
        None => Ok(()),
    }
}

/// Refuses a name that cannot be part of a path in OpenSim.
pub fn refuse_name_in_paths(name: &str) -> Result<()> {
    if name.is_empty() {
        return Err(Fault::refused(
            "a contact has no name: OpenSim finds contacts by their names, so give it one",
        ));
    }
    if [".", ".."].contains(&name) {
        return Err(Fault::refused(format!(
            "the name '{name}' is a step in OpenSim's paths, so that nothing would find what has it: {NAME_ADVICE}"
        )));
    }
    match name.chars().find(|&letter| REFUSED_LETTERS.contains(letter)) {
        Some(letter) => Err(Fault::refused(format!(
            "the name '{name}' has {} in it, with which OpenSim refuses the model: {NAME_ADVICE}",
            match letter {
                ' ' => "a blank".to_owned(),
                '\t' => "a tab".to_owned(),
                letter if letter.is_control() => "a line break".to_owned(),
                letter => format!("'{letter}'"),
            }
        ))),
        None => Ok(()),
    }
}

/// A pattern of names: `*` means any text, `?` for one letter, `[rl]` for one of these letters, `{heel,toe}*` for one of these words.
/// Upper and lower case differ.
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

/// Why a text is not a pattern of names.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct PatternError(String);

impl Pattern {
    pub fn matches(&self, name: &str) -> bool {
        self.matcher.is_match(name)
    }

    pub fn as_str(&self) -> &str {
        &self.text
    }
}

pub(crate) fn any_pattern_matches(patterns: &[Pattern], name: &str) -> bool {
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

/// The names that were probably meant by `written`: of `known`, those with the fewest wrong letters. These are at most `most_wrong`, and
/// fewer than half of the letters of either name. Upper and lower case, blanks, `-` and `_` do not count.
///
/// ```
/// use osim_model::nearest_names;
///
/// assert_eq!(nearest_names("Calcn-R", ["calcn_l", "calcn_r"], 2), ["calcn_r"]);
/// // Short names are near to everything.
/// assert!(nearest_names("sex", ["yes"], 2).is_empty());
/// ```
pub fn nearest_names<'n>(
    written: &str,
    known: impl IntoIterator<Item = &'n str>,
    most_wrong: usize,
) -> Vec<&'n str> {
    let flat = |name: &str| name.to_lowercase().replace([' ', '-', '_'], "");
    let letters = |name: &str| {
        let ascii = name.bytes().filter(u8::is_ascii_alphanumeric);
        ascii.fold(0_u32, |all, letter| all | (1_u32 << (letter % 32)))
    };
    let (own_letters, written) = (letters(written), LazyCell::new(|| flat(written)));
    let wrong_letters = |name: &'n str| {
        // Each wrong letter changes at most two of the letters that a name has. Most names differ in more; the distance takes much longer.
        let differing = (own_letters ^ letters(name)).count_ones() as usize;
        let other = (differing <= 2 * most_wrong).then(|| flat(name))?;
        let half = written.len().min(other.len()).saturating_sub(1) / 2;
        let most_wrong = most_wrong.min(half);
        let (own_count, count) = (written.chars().count(), other.chars().count());
        let wrong =
            (own_count.abs_diff(count) <= most_wrong).then(|| strsim::osa_distance(&written, &other))?;
        (wrong <= most_wrong).then_some((wrong, name))
    };
    let near: Vec<(usize, &str)> = known.into_iter().filter_map(wrong_letters).collect();
    let fewest = near.iter().map(|(wrong, _)| *wrong).min();
    near.into_iter().filter(|(wrong, _)| Some(*wrong) == fewest).map(|(_, name)| name).collect()
}

// Left and right in names.

named! {
    /// A side of the body, as read from names.
    pub enum Side {
        /// The right side: `_r`, `right`, …
        Right = "right",
        /// The left side: `_l`, `left`, …
        Left = "left",
    }
}

impl Side {
    pub const fn other(self) -> Self {
        match self {
            Self::Right => Self::Left,
            Self::Left => Self::Right,
        }
    }

    /// Reads the side from a name such as `calcn_r`, `RFoot`, `left_toe` or `footL`; `None` if the name has no side or both.
    pub fn of_name(name: &str) -> Option<Self> {
        let is_alone = |at: usize| {
            let [before, behind] = [name.get(..at), name.get(at + 1..)];
            !before.is_some_and(|text| text.ends_with(char::is_alphanumeric))
                && !behind.is_some_and(|text| text.starts_with(char::is_alphanumeric))
        };
        let word = |long: &str, short: [u8; 2]| {
            let mut letters = name.bytes().enumerate();
            has_word(name, long) || letters.any(|(at, letter)| short.contains(&letter) && is_alone(at))
        };
        let camel = |letter: char| {
            let (first, last) = (first_three_letters(name), last_two_letters(name));
            let leading = first.is_some_and(|[a, b, c]| a == letter && b.is_uppercase() && c.is_lowercase());
            leading || last.is_some_and(|[a, b]| b == letter && a.is_lowercase())
        };
        match (word("right", *b"rR") || camel('R'), word("left", *b"lL") || camel('L')) {
            (true, false) => Some(Self::Right),
            (false, true) => Some(Self::Left),
            _ => None,
        }
    }
}

fn first_three_letters(name: &str) -> Option<[char; 3]> {
    let mut letters = name.chars();
    Some([letters.next()?, letters.next()?, letters.next()?])
}

fn last_two_letters(name: &str) -> Option<[char; 2]> {
    let mut letters = name.chars().rev();
    let last = letters.next()?;
    Some([letters.next()?, last])
}

/// `name` in lower case; not copied if it already is.
fn in_lower_case(name: &str) -> Cow<'_, str> {
    let stays = |byte: u8| byte.is_ascii() && !byte.is_ascii_uppercase();
    if name.bytes().all(stays) { Cow::Borrowed(name) } else { Cow::Owned(name.to_lowercase()) }
}

/// Whether a name has the letters `word` in it, in upper or lower case.
pub fn has_word(name: &str, word: &str) -> bool {
    let (name, word) = (name.as_bytes(), word.as_bytes());
    let Some(first) = word.first() else { return false };
    // Most places are excluded by the first letter.
    let first = [first.to_ascii_lowercase(), first.to_ascii_uppercase()];
    let begins = |part: &[u8]| part.first().is_some_and(|letter| first.contains(letter));
    name.windows(word.len()).any(|part| begins(part) && part.eq_ignore_ascii_case(word))
}

/// The name with all marks of left and right replaced by the same mark.
///
/// ```
/// use osim_model::without_side;
///
/// assert_eq!(without_side("calcn_r"), without_side("calcn_l"));
/// assert_ne!(without_side("calcn_r"), without_side("toes_r"));
/// ```
pub fn without_side(name: &str) -> String {
    let mut lower = in_lower_case(name);
    for side in ["right", "left"] {
        if has_word(&lower, side) {
            lower = Cow::Owned(lower.replace(side, "#"));
        }
    }
    let mut joined = String::with_capacity(lower.len());
    for (place, token) in lower.split(|c: char| !c.is_alphanumeric() && c != '#').enumerate() {
        if place > 0 {
            joined.push('_');
        }
        joined.push_str(if token == "r" || token == "l" { "#" } else { token });
    }
    // LFoot and RFoot, footL and footR.
    match (first_three_letters(name), last_two_letters(name)) {
        (Some(['R' | 'L', second, third]), _) if second.is_uppercase() && third.is_lowercase() => {
            format!("#{}", joined.get(1..).unwrap_or_default())
        }
        (_, Some([before, 'R' | 'L'])) if before.is_lowercase() => {
            format!("{}#", joined.get(..joined.len().saturating_sub(1)).unwrap_or_default())
        }
        _ => joined,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_are_read_from_names_as_people_write_them() {
        for name in ["calcn_r", "r_foot", "RFoot", "right_toe", "footR", "toes.r", "calcn_r_2", "RightFoot"] {
            assert_eq!(Side::of_name(name), Some(Side::Right), "{name}");
        }
        for name in ["calcn_l", "LFoot", "leftHeel", "hind_l", "foot_left"] {
            assert_eq!(Side::of_name(name), Some(Side::Left), "{name}");
        }
        for name in ["ball", "trunk", "tail", "Roller", "Leg", "r_to_l", "lateral"] {
            assert_eq!(Side::of_name(name), None, "{name}");
        }
    }

    #[test]
    fn names_without_side_are_equal_for_left_and_right() {
        for (right, left) in [
            ("heel_r", "heel_l"),
            ("RFoot", "LFoot"),
            ("footR", "footL"),
            ("right_toe", "left_toe"),
            ("s1_r_a", "s1_l_a"),
        ] {
            assert_eq!(without_side(right), without_side(left));
        }
        assert_ne!(without_side("heel_r"), without_side("toe_l"));
    }
}
