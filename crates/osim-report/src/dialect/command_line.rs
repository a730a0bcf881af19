//! The words of the command line.

use std::borrow::Cow;

use osim_messages::{Call, Dialect, Example, Input, Verb, shortest};
use osim_model::Assignment;
use osim_requests::{Request, Speller};

use super::front_end::FrontEnd;
use super::remedy::{InputValue, RemedyParts, is_assignment};
use super::shell::shell_quoted;

/// Name of the program.
const PROGRAM: &str = "osim-contact-scale";

/// The command line: `--mass KG`, `design MODEL --indentation 0.16`.
///
/// ```
/// use osim_messages::{Input, phrase};
/// use osim_report::dialect::CommandLine;
///
/// let way_out = phrase!["say what the model weighs with ", Input::Mass.like("KG")];
/// assert_eq!(way_out.spelled(&CommandLine), "say what the model weighs with --mass KG");
/// ```
#[derive(Debug, Clone, Copy, Default)]
pub struct CommandLine;

impl Dialect for CommandLine {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        let name = match (input, example) {
            _ if is_positional(input) => {
                return example.map_or_else(|| input.name().to_ascii_uppercase(), ToString::to_string);
            }
            (Input::Output, None | Some(Example::Placeholder(_))) => "-o".to_owned(),
            (Input::OutputDir, None | Some(Example::Placeholder(_))) => "-d".to_owned(),
            _ => option(input),
        };
        example.map_or_else(|| name.clone(), |example| format!("{name} {example}"))
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
        words.extend(call.with_model.then(|| "MODEL".to_owned()));
        let assignments = call.inputs.iter().filter(|(input, _)| is_assignment(call, *input));
        words.extend(assignments.map(|(input, example)| match example {
            Some(example) => format!("{}={example}", input.name()),
            None => input.name().to_owned(),
        }));
        words.extend(arguments(false));
        words.join(" ")
    }
}

impl Speller for CommandLine {
    fn request(&self, request: &Request) -> String {
        let parts = RemedyParts::of(request);
        let mut words = vec![PROGRAM.to_owned()];
        if parts.verb != Verb::Rescale {
            words.push(parts.verb.name().to_owned());
        }
        words.push(shell_quoted(&model_word(&parts.model)));
        words.extend(parts.assignments.iter().map(|(property, assignment)| match assignment {
            Assignment::Factor(factor) => format!("{property}=x{}", shortest(*factor)),
            Assignment::Value(value) => format!("{property}={}", shortest(*value)),
        }));
        for (input, value) in &parts.inputs {
            let mut say = |value: &str| match value.starts_with('-') {
                true => words.push(format!("{}={}", option(*input), shell_quoted(value))),
                false => words.extend([option(*input), shell_quoted(value)]),
            };
            match value {
                InputValue::Number(value) => say(&shortest(*value)),
                InputValue::Text(text) => say(text),
                InputValue::Patterns(patterns) => patterns.iter().for_each(|pattern| say(pattern)),
                InputValue::Flag => words.push(option(*input)),
            }
        }
        words.join(" ")
    }
}

impl FrontEnd for CommandLine {
    fn command(&self, call: &Call) -> String {
        format!("{PROGRAM} {}", self.call(call))
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

/// What is written without the name of an option.
fn is_positional(input: Input) -> bool {
    matches!(input, Input::Kind | Input::Topics)
}

/// The name of a file as a word that is neither an option nor a verb.
fn model_word(name: &str) -> Cow<'_, str> {
    let is_option = name.starts_with('-') && name != "-";
    let may_be_verb = !name.contains(['.', '/', '\\']) && name != "-";
    if is_option || may_be_verb { format!("./{name}").into() } else { name.into() }
}

fn option(input: Input) -> String {
    format!("--{}", input.name().replace('_', "-"))
}

#[cfg(test)]
mod tests {
    use osim_messages::Phrase;
    use osim_model::FindingCode;

    use super::*;

    fn spelled(template: &'static str) -> String {
        Phrase::template(template).spelled(&CommandLine)
    }

    #[test]
    fn a_model_is_never_an_option_or_a_verb() {
        let words = ["-y.osim", "set", "foot.osim", "a/b", "-"].map(model_word);
        assert_eq!(words, ["./-y.osim", "./set", "foot.osim", "a/b", "-"]);
    }

    #[test]
    fn outputs_are_short_unless_they_have_a_value() {
        assert_eq!(spelled("`output` or `output_dir`"), "-o or -d");
        assert_eq!(spelled("`output=FILE`, `output_dir=DIR`"), "-o FILE, -d DIR");
        assert_eq!(spelled("`output=a.svg`"), "--output a.svg");
    }

    #[test]
    fn a_model_alone_is_rescaled() {
        assert_eq!(spelled("`rescale MODEL target_mass=KG`"), "MODEL --target-mass KG");
        assert_eq!(spelled("`rescale`"), "rescale");
        let call = Verb::Rescale.of_model().with(Input::TargetMass, "KG");
        assert_eq!(CommandLine.command(&call), "osim-contact-scale MODEL --target-mass KG");
    }

    #[test]
    fn what_is_positional_stands_before_the_model() {
        let call = "`plot MODEL output=FILE.svg kind=force`, `explain topics=FINDING`";
        assert_eq!(spelled(call), "plot force MODEL -o FILE.svg, explain FINDING");
    }

    #[test]
    fn the_register_reads_as_it_always_did() {
        for (code, why, remedy) in [
            (
                FindingCode::AlreadyAtTarget,
                "else --mass, else the sum of the bodies.",
                "Say what the contacts were made for with --contacts-mass KG, or take those of a known model with \
                 transfer --from MODEL",
            ),
            (
                FindingCode::ZeroConstantContactForce,
                "even without friction.",
                "Give it a small value, for example design MODEL --constant-indentation 0.05",
            ),
            (FindingCode::DisabledForce, "", "Nothing, if that is meant; else --skip-disabled"),
            (
                FindingCode::FactorsDisagree,
                "",
                "Look at inspect --from, and say --body-scale BODY=x,y,z where another source is right",
            ),
            (
                FindingCode::BeyondHertzAtTwo,
                "",
                "Nothing, if the model only walks; else design MODEL --indentation 0.16 --body-weights 2",
            ),
            (
                FindingCode::SunkIn,
                "",
                "Scale the contacts to this body with MODEL --contacts-mass KG --target-mass KG, or design MODEL \
                 --indentation 0.16",
            ),
        ] {
            assert!(code.why().spelled(&CommandLine).contains(why), "{code}");
            assert_eq!(code.advice().spelled(&CommandLine), remedy);
        }
    }
}
