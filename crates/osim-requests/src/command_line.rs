//! Requests from the arguments of a command line: makes the parser of a verb from the register of options, and reads its results.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use osim_model::Property;
use osim_model::messages::{Phrase, Verb, shortest};
use serde_json::{Map, Value};

use crate::fault::{Relation, RequestFault};
use crate::register::{Entry, List, OptionValue, option_named};
use crate::request::{Request, check_value, relations_of, silent_fields, verb_entry};
use crate::spell::CommandLine;
use crate::values::{assignment, path};

/// Name of the argument list of `set`, which has models and assignments.
const MODELS_AND_ASSIGNMENTS: &str = "items";

/// Position in the help of rarely used options: after the usual options under the same heading.
const ORDER_OF_LAST: usize = 1000;

/// Adds the options of `verb` to the parser, with their help texts if the parser has a help.
///
/// The parser checks required options and options that exclude each other. [`read`] checks the options that need another option,
/// because clap ignores this condition if a third option excludes the other one.
pub fn with_options(command: Command, verb: Verb) -> Command {
    let has_help = !command.is_disable_help_flag_set();
    let fields = silent_fields(verb);
    let has_items = fields.contains_key("set");
    let command = if has_items { command.arg(models_and_assignments()) } else { command };
    let options = fields.into_iter().filter_map(|(name, silent)| Some((option_named(verb, &name)?, silent)));
    let options = options.filter(|(option, _)| !has_items || !["models", "set"].contains(&option.name));
    let relations = relations_of(verb);
    command.args(options.map(|(option, silent)| {
        let argument = with_conditions(argument_of_option(verb, &option), &relations);
        if has_help { with_texts(argument, &option, &silent) } else { argument }
    }))
}

fn models_and_assignments() -> Arg {
    Arg::new(MODELS_AND_ASSIGNMENTS)
        .value_name("MODEL|PROPERTY=VALUE|PROPERTY=xFACTOR")
        .required(true)
        .num_args(1..)
        .value_parser(value_parser!(OsString))
        .help("Models, and what to set: PROPERTY=VALUE or PROPERTY=xFACTOR")
}

fn argument_of_option(verb: Verb, option: &Entry) -> Arg {
    let name = option.name;
    let is_positional = verb_entry(verb).positional.contains(&name);
    let argument = Arg::new(name).short(option.short).allow_hyphen_values(option.is_signed);
    let argument = if is_positional { argument } else { argument.long(name.replace('_', "-")) };
    if option.takes == OptionValue::Flag {
        return argument.action(ArgAction::SetTrue);
    }
    let argument = match option.value_name {
        "" => argument.value_name(name.to_uppercase()),
        value_name => argument.value_name(value_name),
    };
    let argument = match option.list {
        List::One => argument,
        List::Repeated if is_positional => argument.num_args(1..).action(ArgAction::Append),
        List::Repeated => argument.action(ArgAction::Append),
        List::Commas => argument.action(ArgAction::Append).value_delimiter(','),
    };
    match option.takes {
        OptionValue::Choice(words) => {
            argument.value_parser(PossibleValuesParser::new(words.iter().map(possible_value)))
        }
        _ if option.is_path() => argument.value_parser(value_parser!(PathBuf)),
        _ => argument
            .value_parser(move |word: &str| check_value(verb, name, word.into()).map(|()| word.to_owned())),
    }
}

fn possible_value((word, meaning): &(&'static str, &'static str)) -> PossibleValue {
    let word = PossibleValue::new(*word);
    if meaning.is_empty() { word } else { word.help(*meaning) }
}

/// The argument with its conditions: options that it requires or excludes.
fn with_conditions(argument: Arg, relations: &[Relation]) -> Arg {
    let name = argument.get_id().clone();
    let relations = relations.iter().filter(|relation| name == relation.field());
    relations.fold(argument, |argument, relation| match *relation {
        Relation::Required(_) => argument.required(true),
        Relation::Expected(_) | Relation::ExpectedUnless(..) | Relation::Needs(..) => argument,
        Relation::RequiredUnless(_, other) => argument.required_unless_present(other),
        Relation::Excludes(_, other) => argument.conflicts_with(other),
    })
}

/// The argument with its help text, in the words of the command line, and its default. Usual options come first.
fn with_texts(argument: Arg, option: &Entry, silent: &Value) -> Arg {
    let spelled = |text: &'static str| Phrase::template(text).spelled(&CommandLine);
    let argument = argument.help(spelled(option.help)).hide(option.is_refused);
    let argument = match option.heading {
        "" => argument,
        heading => argument.help_heading(spelled(heading)),
    };
    let argument = match silent {
        Value::String(text) => argument.default_value(text.clone()),
        Value::Number(number) => argument.default_value(number.as_f64().map(shortest).unwrap_or_default()),
        _ => argument,
    };
    if option.is_rare { argument.hide_short_help(true).display_order(ORDER_OF_LAST) } else { argument }
}

/// The request from the arguments for `verb`. `is_file` decides which arguments of `set` are names of files although they contain
/// `=`.
///
/// # Errors
/// An option without another option that it needs; for `set`, an unknown property or a value that is not a number.
pub fn read(verb: Verb, matches: &ArgMatches, is_file: fn(&Path) -> bool) -> Result<Request, RequestFault> {
    let is_typed = |name: &str| matches.value_source(name) == Some(ValueSource::CommandLine);
    let mut fields = Map::new();
    let mut words: Vec<&OsString> = Vec::new();
    for name in matches.ids().map(clap::Id::as_str).filter(|name| is_typed(name)) {
        match option_named(verb, name) {
            Some(option) => drop(fields.insert(name.to_owned(), typed_value(&option, matches))),
            None if name == MODELS_AND_ASSIGNMENTS => {
                words.extend(matches.get_many::<OsString>(name).into_iter().flatten());
            }
            // An argument of the command alone.
            None => {}
        }
    }
    // The parser has already checked required fields and fields that exclude each other.
    let request = Request::read_checking(verb, fields, |relation| matches!(relation, Relation::Needs(..)))?;
    match request {
        Request::Set(mut request) => {
            let mut words = words.into_iter();
            while let Some(word) = words.next() {
                let is_property = |word: &str| Property::changeable().any(|known| known.as_str() == word);
                let property = word.to_str().filter(|word| is_property(word) && !is_file(Path::new(word)));
                if let Some(name) = property {
                    let value = words.find(|other| *other != "=").and_then(|value| value.to_str());
                    let value = value.unwrap_or("VALUE");
                    let message = format!("a property and its value are one word: write {name}={value}");
                    return Err(RequestFault::general(message));
                }
                // A name that is not UTF-8 is no assignment.
                match word.to_str().and_then(|word| word.split_once('=')) {
                    Some((name, value)) if !is_file(Path::new(word)) => {
                        let added = assignment(name, value).and_then(|new| request.set.add(new));
                        added.map_err(RequestFault::general)?;
                    }
                    _ => request.models.push(PathBuf::from(word)),
                }
            }
            Ok(Request::Set(request))
        }
        request => Ok(request),
    }
}

/// The value of an option on the command line, as a value in JSON.
fn typed_value(option: &Entry, matches: &ArgMatches) -> Value {
    let name = option.name;
    if option.takes == OptionValue::Flag {
        return true.into();
    }
    let mut values: Vec<Value> = if option.is_path() {
        matches.get_many::<PathBuf>(name).into_iter().flatten().map(|file| path::to_value(file)).collect()
    } else {
        matches.get_many::<String>(name).into_iter().flatten().map(|text| text.as_str().into()).collect()
    };
    if option.list == List::One { values.pop().unwrap_or_default() } else { values.into() }
}
