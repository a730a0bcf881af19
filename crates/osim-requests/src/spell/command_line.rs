//! Spells requests for a command line, quoted for shells.

use std::borrow::Cow;

use osim_model::messages::{Call, Dialect, Example, Input, Verb, is_visible};

use crate::register::{Entry, List, OptionValue, option_for, option_named};
use crate::request::Request;
use crate::spell::speller::{Field, FieldValue, Fields, FrontEnd, is_assignment, is_positional};

/// Name of the program.
const PROGRAM_NAME: &str = "osim-contact-scale";

/// The command line: `--mass KG`, `design MODEL --indentation 0.16`.
///
/// ```
/// use osim_model::messages::{Input, phrase};
/// use osim_requests::spell::CommandLine;
///
/// let way_out = phrase!["give the mass of the model with ", Input::Mass.with_placeholder("KG")];
/// assert_eq!(way_out.spelled(&CommandLine), "give the mass of the model with --mass KG");
/// ```
#[derive(Debug, Clone, Copy, Default)]
pub struct CommandLine;

impl Dialect for CommandLine {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        if is_positional(input) {
            return example.map_or_else(|| input.name().to_ascii_uppercase(), ToString::to_string);
        }
        let name = match option_for(input).filter(|option| option.takes != OptionValue::Flag) {
            Some(Entry { short: Some(letter), .. }) => format!("-{letter}"),
            _ => option_name(input.name()),
        };
        match example {
            Some(Example::Value(value)) => {
                // Within a sentence, lists read better without quotation marks.
                let rest = value.replace(',', "");
                let is_plain = shell_quoted(&rest) == rest;
                let between = if value.starts_with('-') { '=' } else { ' ' };
                format!("{name}{between}{}", if is_plain { value.clone() } else { shell_quoted(value) })
            }
            Some(placeholder) => format!("{name} {placeholder}"),
            None => name,
        }
    }

    fn call(&self, call: &Call) -> String {
        let arguments = |positional: bool| {
            let inputs = call.inputs.iter().filter(move |(input, _)| {
                !is_assignment(call, *input) && is_positional(*input) == positional
            });
            inputs.map(|(input, example)| self.input(*input, example.as_ref()))
        };
        let mut words = Vec::new();
        // What a model alone means is rescale: its name may be left out.
        if call.verb != Verb::Rescale || !call.with_model {
            words.push(call.verb.name().to_owned());
        }
        words.extend(arguments(true));
        words.extend(call.models_or("MODEL").map(|name| shell_quoted(&file_word(name))));
        let assignments = call.inputs.iter().filter(|(input, _)| is_assignment(call, *input));
        words.extend(assignments.map(|(input, example)| match example {
            Some(example) => format!("{}={example}", input.name()),
            None => input.name().to_owned(),
        }));
        words.extend(arguments(false));
        words.join(" ")
    }
}

impl FrontEnd for CommandLine {
    /// The line for a terminal. It is valid in POSIX shells, and also in PowerShell and cmd if it has no characters that a
    /// POSIX shell expands.
    fn request(&self, request: &Request) -> String {
        let fields = Fields::of(request);
        let mut words = vec![PROGRAM_NAME.to_owned(), fields.verb.name().to_owned()];
        let positional = fields.positional.iter().flat_map(|(_, value)| value.items());
        words.extend(positional.map(|item| shell_quoted(&file_word(&item.text()))));
        words.extend(fields.options.iter().flat_map(|field| option_words(fields.verb, field)));
        words.join(" ")
    }

    fn command(&self, call: &Call) -> String {
        format!("{PROGRAM_NAME} {}", self.call(call))
    }

    fn word(&self, name: &str) -> String {
        shell_quoted(name)
    }

    fn prompt(&self) -> &'static str {
        "$ "
    }

    fn see_also(&self) -> &'static str {
        " (see --help)"
    }
}

/// An option with its value, as one or several arguments.
fn option_words(verb: Verb, (name, value): &Field) -> Vec<String> {
    let registered = option_named(verb, name);
    let is_one_word = registered.is_some_and(|option| option.list == List::Commas);
    let option = option_name(name);
    let short = registered.and_then(|option| Some(format!("-{}", option.short?)));
    let valued = |text: String| match text.starts_with('-') {
        true => format!("{option}={}", shell_quoted(&text)),
        false => format!("{} {}", short.as_deref().unwrap_or(&option), shell_quoted(&text)),
    };
    match value {
        FieldValue::Map(properties) if name == "set" => {
            properties.iter().map(|entry| shell_quoted(&spelled_assignment(entry))).collect()
        }
        FieldValue::Map(entries) => entries.iter().map(|entry| valued(spelled_assignment(entry))).collect(),
        FieldValue::Flag => vec![option],
        FieldValue::List(items) if !is_one_word => items.iter().map(|item| valued(item.text())).collect(),
        value => vec![valued(value.text())],
    }
}

/// An assignment as one argument, such as `stiffness=x2` or `calcn_r=1.1,1.05,1.1`.
fn spelled_assignment((name, value): &Field) -> String {
    format!("{name}={}", value.text())
}

/// The name of a file as an argument that does not look like an option.
fn file_word(name: &str) -> Cow<'_, str> {
    if name.starts_with('-') && name != "-" { format!("./{name}").into() } else { name.into() }
}

fn option_name(field: &str) -> String {
    format!("--{}", field.replace('_', "-"))
}

// Words as shells take them.

/// `word` quoted for shells: without quotation marks if no shell needs them, else in double ones, which cmd and PowerShell also
/// know; in single ones if a POSIX shell would expand something. cmd replaces `%NAME%` within any quotation marks. Line ends, tabs and
/// other letters that cannot be seen, which no name has on Windows, are escaped as in bash and zsh: `$'a\nb'`.
pub fn shell_quoted(word: &str) -> String {
    // PowerShell makes a list of what has commas, and zsh looks for a program after an equals sign.
    let plain = |letter: char| letter.is_alphanumeric() || "_-./:+=%".contains(letter);
    if !word.is_empty() && !word.starts_with('=') && word.chars().all(plain) {
        word.to_owned()
    } else if !word.chars().all(is_visible) {
        format!("$'{}'", word.chars().map(escaped_for_shell).collect::<String>())
    } else if !expands_in_double_quotes(word) {
        format!("\"{word}\"")
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

fn escaped_for_shell(letter: char) -> String {
    match letter {
        '\n' => r"\n".to_owned(),
        '\t' => r"\t".to_owned(),
        '\'' | '\\' => format!("\\{letter}"),
        visible if is_visible(visible) => visible.to_string(),
        other => other.to_string().bytes().map(|byte| format!(r"\{byte:03o}")).collect(),
    }
}

/// Whether a shell changes a part of `word` between double quotation marks. PowerShell takes curly quotation marks for straight
/// ones.
fn expands_in_double_quotes(word: &str) -> bool {
    let is_special = |letter: char| "$`\"!\u{201c}\u{201d}\u{201e}".contains(letter);
    word.contains(is_special) || word.contains(r"\\") || word.ends_with('\\')
}

#[cfg(test)]
mod tests {
    use osim_model::messages::Phrase;
    use serde_json::{Value, json};

    use super::*;

    fn spelled(template: &'static str) -> String {
        Phrase::template(template).spelled(&CommandLine)
    }

    #[track_caller]
    fn assert_spelled(request: &Value, expected: &str) {
        let request = Request::from_json(request.to_string().as_bytes()).unwrap();
        assert_eq!(CommandLine.request(&request), format!("{PROGRAM_NAME} {expected}"));
    }

    #[test]
    fn a_name_with_a_leading_hyphen_is_not_an_option() {
        assert_spelled(
            &json!({"verb": "rescale", "models": ["-x.osim", "-"], "level": true, "level_axis": "-y", "output": "-o.osim"}),
            "rescale ./-x.osim - --level --level-axis=-y --output=-o.osim",
        );
        assert_eq!(spelled("`exclude=-heel`"), "--exclude=-heel");
    }

    #[test]
    fn lists_and_maps_have_the_form_of_their_option() {
        assert_spelled(
            &json!({"verb": "transfer", "models": "a.osim", "from": "falisse2022", "follow_bodies": true,
            "body_scale": {"calcn_r": [1.1, 1.05, 1.1], "foot l": 2}, "only": ["stiffness", "radius"], "select": ["*_r", "toe"]}),
            "transfer a.osim --from falisse2022 --follow-bodies --body-scale \"calcn_r=1.1,1.05,1.1\" \
         --body-scale \"foot l=2,2,2\" --only \"stiffness,radius\" --select \"*_r\" --select toe",
        );
        assert_spelled(
            &json!({"verb": "set", "models": "a.osim", "set": {"stiffness": "x2", "dissipation": 1.5}, "in_place": true}),
            "set a.osim stiffness=x2 dissipation=1.5 --in-place",
        );
        assert_spelled(&json!({"verb": "set", "models": "a.osim", "level": true}), "set a.osim --level");
    }

    #[test]
    fn outputs_are_short() {
        assert_eq!(spelled("`output` or `output_dir`"), "-o or -d");
        assert_eq!(spelled("`output=FILE`, `output_dir=DIR`"), "-o FILE, -d DIR");
        assert_eq!(spelled("`output=a.svg`"), "-o a.svg");
    }

    #[test]
    fn a_model_alone_is_rescaled() {
        assert_eq!(spelled("`rescale MODEL target_mass=KG`"), "MODEL --target-mass KG");
        assert_eq!(spelled("`rescale`"), "rescale");
        let call = Verb::Rescale.call_with_model().with_placeholder(Input::TargetMass, "KG");
        assert_eq!(CommandLine.command(&call), "osim-contact-scale MODEL --target-mass KG");
    }

    #[test]
    fn positional_fields_come_before_the_model() {
        let call = "`plot MODEL output=FILE.svg kind=force`, `explain topics=FINDING`";
        assert_eq!(spelled(call), "plot force MODEL -o FILE.svg, explain FINDING");
    }

    #[test]
    fn words_are_quoted_if_a_shell_needs_it() {
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
            ("it's\t5\n\\$\u{202e}", r"$'it\'s\t5\n\\$\342\200\256'"),
        ] {
            assert_eq!(shell_quoted(word), expected);
        }
    }
}
