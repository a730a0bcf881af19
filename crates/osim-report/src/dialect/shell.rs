//! Words as a shell takes them.

/// `text` as a shell takes it for one word: in quotes where it has to be.
#[must_use]
pub fn shell_quoted(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "_-./:,+=@%".contains(c) || (cfg!(windows) && c == '\\');
    if !text.is_empty() && text.chars().all(plain) {
        return text.to_owned();
    }
    if cfg!(windows) { format!("\"{text}\"") } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_one_word() {
        assert_eq!(shell_quoted("models/a_1.osim"), "models/a_1.osim");
        if !cfg!(windows) {
            assert_eq!(shell_quoted("my model.osim"), "'my model.osim'");
            assert_eq!(shell_quoted("it's"), r"'it'\''s'");
        }
    }
}
