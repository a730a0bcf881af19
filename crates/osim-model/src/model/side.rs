//! Left and right, as names say it.

use std::borrow::Cow;

/// Side of the body, read from names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Side {
    /// `_r`, `right`, …
    Right,
    /// `_l`, `left`, …
    Left,
}

impl Side {
    /// As in the JSON.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Left => "left",
        }
    }

    /// The opposite one.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Right => Self::Left,
            Self::Left => Self::Right,
        }
    }

    /// Reads a side from a name such as `calcn_r`, `RFoot`, `left_toe` or `footL`; `None` where it has none or both.
    #[must_use]
    pub fn of_name(name: &str) -> Option<Self> {
        let lower = in_lower_case(name);
        let word = |long: &str, short: &str| {
            has(&lower, long) || lower.split(|c: char| !c.is_alphanumeric()).any(|token| token == short)
        };
        let camel = |letter: char| {
            let (first, last) = (first_three(name), last_two(name));
            let leading = first.is_some_and(|[a, b, c]| a == letter && b.is_uppercase() && c.is_lowercase());
            leading || last.is_some_and(|[a, b]| b == letter && a.is_lowercase())
        };
        match (word("right", "r") || camel('R'), word("left", "l") || camel('L')) {
            (true, false) => Some(Self::Right),
            (false, true) => Some(Self::Left),
            _ => None,
        }
    }
}

fn first_three(name: &str) -> Option<[char; 3]> {
    let mut letters = name.chars();
    Some([letters.next()?, letters.next()?, letters.next()?])
}

fn last_two(name: &str) -> Option<[char; 2]> {
    let mut letters = name.chars().rev();
    let last = letters.next()?;
    Some([letters.next()?, last])
}

/// Most names are so already.
fn in_lower_case(name: &str) -> Cow<'_, str> {
    let stays = |byte: u8| byte.is_ascii() && !byte.is_ascii_uppercase();
    if name.bytes().all(stays) { Cow::Borrowed(name) } else { Cow::Owned(name.to_lowercase()) }
}

/// Whether `word` is in `text`: quicker than `contains`, which prepares itself for long texts.
fn has(text: &str, word: &str) -> bool {
    let (text, word) = (text.as_bytes(), word.as_bytes());
    text.windows(word.len()).any(|part| part.first() == word.first() && part == word)
}

/// The name with everything that says left or right made equal.
///
/// ```
/// use osim_model::without_side;
///
/// assert_eq!(without_side("calcn_r"), without_side("calcn_l"));
/// assert_ne!(without_side("calcn_r"), without_side("toes_r"));
/// ```
#[must_use]
pub fn without_side(name: &str) -> String {
    let mut lower = in_lower_case(name);
    for side in ["right", "left"] {
        if has(&lower, side) {
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
    match (first_three(name), last_two(name)) {
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
    fn names_of_both_sides_become_equal() {
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
