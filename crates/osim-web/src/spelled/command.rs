//! The words of the command line.

use std::borrow::Cow;

use super::fields::{FieldValue, Fields};

/// Name of the program.
const PROGRAM: &str = "osim-contact-scale";

/// Options that take all values of a list in one word, separated by commas. Others are repeated.
const WITH_COMMAS: [&str; 3] = ["feet", "keep", "only"];

/// The line for a terminal.
pub(super) fn command(fields: &Fields) -> String {
    line(fields, quoted)
}

/// The same line with the quotation marks that `quoted` sets.
pub(super) fn line(fields: &Fields, quoted: fn(&str) -> String) -> String {
    let mut words = vec![PROGRAM.to_owned(), fields.verb.name().to_owned()];
    words.extend(fields.models.iter().map(|model| quoted(&model_word(model))));
    for (name, value) in &fields.options {
        match value {
            FieldValue::Map(properties) if name == "set" => {
                words.extend(properties.iter().map(|entry| quoted(&assigned(entry))));
            }
            value => words.extend(option(&format!("--{}", name.replace('_', "-")), (name, value), quoted)),
        }
    }
    words.join(" ")
}

/// An option with what it says, in one or several words.
fn option(option: &str, (name, value): (&str, &FieldValue), quoted: fn(&str) -> String) -> Vec<String> {
    let said = |text: String| match text.starts_with('-') {
        true => format!("{option}={}", quoted(&text)),
        false => format!("{option} {}", quoted(&text)),
    };
    match value {
        FieldValue::Flag => vec![option.to_owned()],
        FieldValue::List(items) if !WITH_COMMAS.contains(&name) => {
            items.iter().map(|item| said(item.text())).collect()
        }
        FieldValue::Map(entries) => entries.iter().map(|entry| said(assigned(entry))).collect(),
        value => vec![said(value.text())],
    }
}

/// `stiffness=x2`, `calcn_r=1.1,1.05,1.1`.
fn assigned((name, value): &(String, FieldValue)) -> String {
    format!("{name}={}", value.text())
}

/// The name of a file as a word that is not an option.
fn model_word(name: &str) -> Cow<'_, str> {
    if name.starts_with('-') && name != "-" { format!("./{name}").into() } else { name.into() }
}

/// `word` as shells take it: without quotation marks where all shells agree on it, else in double ones, which cmd and PowerShell know,
/// too; in single ones where a POSIX shell would find something to expand. cmd puts a variable in for `%NAME%` whatever is around it.
fn quoted(word: &str) -> String {
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
    use osim_requests::Request;
    use serde_json::{Value, json};

    use super::*;

    #[track_caller]
    fn is_spelled(request: &Value, expected: &str) {
        let request = Request::from_json(request.to_string().as_bytes()).unwrap();
        assert_eq!(command(&Fields::of(&request)), format!("{PROGRAM} {expected}"));
    }

    #[test]
    fn words_are_quoted_where_shells_ask_for_it() {
        for (word, expected) in [
            ("human_62kg.osim", "human_62kg.osim"),
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
            assert_eq!(quoted(word), expected);
        }
    }

    #[test]
    fn what_begins_with_a_hyphen_is_not_an_option() {
        is_spelled(
            &json!({"verb": "rescale", "models": ["-x.osim", "-"], "level": true, "level_axis": "-y", "output": "-o.osim"}),
            "rescale ./-x.osim - --level --level-axis=-y --output=-o.osim",
        );
    }

    #[test]
    fn lists_and_maps_are_as_each_option_takes_them() {
        is_spelled(
            &json!({"verb": "transfer", "models": "a.osim", "from": "falisse2022", "follow_bodies": true,
                "body_scale": {"calcn_r": [1.1, 1.05, 1.1], "foot l": 2}, "only": ["stiffness", "radius"], "select": ["*_r", "toe"]}),
            "transfer a.osim --from falisse2022 --follow-bodies --body-scale \"calcn_r=1.1,1.05,1.1\" \
             --body-scale \"foot l=2,2,2\" --only \"stiffness,radius\" --select \"*_r\" --select toe",
        );
        is_spelled(
            &json!({"verb": "set", "models": "a.osim", "set": {"stiffness": "x2", "dissipation": 1.5}, "in_place": true}),
            "set a.osim stiffness=x2 dissipation=1.5 --in-place",
        );
    }
}
