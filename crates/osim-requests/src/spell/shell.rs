//! Words as shells take them.

/// `word` as shells take it: without quotation marks where all shells agree on it, else in double ones, which cmd and PowerShell know,
/// too; in single ones where a POSIX shell would find something to expand. cmd puts a variable in for `%NAME%` whatever is around it.
#[must_use]
pub fn shell_quoted(word: &str) -> String {
    // PowerShell makes a list of what has commas, and zsh looks for a program after an equals sign.
    let plain = |letter: char| letter.is_alphanumeric() || "_-./:+=%".contains(letter);
    if !word.is_empty() && !word.starts_with('=') && word.chars().all(plain) {
        word.to_owned()
    } else if !expands_in_double_quotes(word) {
        format!("\"{word}\"")
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

/// Whether a shell would change something of `word` between double quotation marks. To PowerShell the curly ones are the same.
fn expands_in_double_quotes(word: &str) -> bool {
    let is_special = |letter: char| "$`\"!\u{201c}\u{201d}\u{201e}".contains(letter) || letter.is_control();
    word.contains(is_special) || word.contains(r"\\") || word.ends_with('\\')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_quoted_where_shells_ask_for_it() {
        for (word, expected) in [
            ("human_62kg.osim", "human_62kg.osim"),
            ("models/a_1.osim", "models/a_1.osim"),
            ("Fuß.osim", "Fuß.osim"),
            ("my model.osim", r#""my model.osim""#),
            ("*_r", r#""*_r""#),
            ("it's", r#""it's""#),
            ("~/a", r#""~/a""#),
            ("a,b", r#""a,b""#),
            (r"C:\my models\a.osim", r#""C:\my models\a.osim""#),
            ("", r#""""#),
            ("$HOME", "'$HOME'"),
            ("`id`", "'`id`'"),
            ("wow!", "'wow!'"),
            (r#"12" foot"#, r#"'12" foot'"#),
            (r"a\", r"'a\'"),
            (r"\\server\a", r"'\\server\a'"),
            ("it's $5", r"'it'\''s $5'"),
        ] {
            assert_eq!(shell_quoted(word), expected);
        }
    }
}
