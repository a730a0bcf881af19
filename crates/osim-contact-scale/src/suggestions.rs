//! Suggestions for arguments that are neither verbs nor files, or stand where others are expected.

use std::path::{Path, PathBuf};

use osim_library::report_page::Words;
use osim_library::{Disk, SplitName};
use osim_model::messages::{Input, Phrase, Verb, phrase};
use osim_model::{Property, nearest_names};
use osim_planning::may_be_file;
use osim_requests::register::{List, option_named};
use osim_requests::{AxisName, Kilograms, PlotKind, no_fig1};

use crate::args::{PROGRAM_NAME, begins_alike, verb_names};

/// Verbs of other programs, and what is copied along with a command, with what to say instead of `did you mean`.
const VERBS_OF_OTHER_PROGRAMS: [(&[&str], &str); 7] = [
    (&["$", ">", "%"], "leave out the sign of the terminal"),
    (&[PROGRAM_NAME], "the name of the program is typed once"),
    (&["info", "show", "view"], "the contacts of a model are shown by 'inspect'"),
    (&["lint", "validate", "verify"], "a model is checked by 'check'"),
    (&["fix"], "'check --fix' corrects a model"),
    (&["/?", "/h", "/help"], "the help is printed by 'help'"),
    (&["scale"], "OpenSim scales bodies; 'rescale' scales contacts"),
];

/// The message that suggests another call instead of `words` (the arguments beside the options); `None` if no call fits. With
/// `may_be_mass`, a bare number can only be the target mass.
pub(crate) fn suggest(words: &[PathBuf], may_be_mass: bool, terms: Words) -> Option<String> {
    let first = words.first()?;
    let is_known = |word: &Path| word.exists() || word.as_os_str() == "-";
    let is_first = |verb: &&str| first.as_os_str().eq_ignore_ascii_case(verb);
    if let Some((_, text)) = VERBS_OF_OTHER_PROGRAMS.iter().find(|(verbs, _)| verbs.iter().any(is_first))
        && (!is_known(first) || is_first(&PROGRAM_NAME))
    {
        return Some(format!("'{}' is neither a verb nor a file: {text}", first.display()));
    }
    let mut others = words.iter().filter(|word| !is_known(word));
    if let Some(call) = others.find_map(|word| call_with_verb(word.to_str()?, words, terms)) {
        return Some(call);
    }
    let verb = Some(first).filter(|word| !is_known(word)).and_then(|word| similar_verb(word));
    let split = SplitName::find(words);
    // What looks like a verb is hardly the begin of a name that is not there.
    if let Some(split) = split.filter(|split| split.exists || split.words.start > 0 || verb.is_none()) {
        return Some(split.message(words.get(split.words.start)?));
    }
    let mass = words.iter().find(|word| may_be_mass && !is_known(word) && typed_kilograms(word).is_some());
    if let Some((word, kg)) = mass.and_then(|word| Some((word, typed_kilograms(word)?))) {
        let text: Phrase = phrase![
            "'{}' is neither a verb nor a file: did you mean {}?";
            word.display().to_string(), Input::TargetMass.with_value(kg)
        ];
        return Some(text.spelled(terms));
    }
    Some(format!("'{}' is neither a verb nor a file: did you mean '{}'?", first.display(), verb?))
}

/// The message that suggests the call with its verb first, if `word` of `words` is a verb, or says what to set.
fn call_with_verb(word: &str, words: &[PathBuf], terms: Words) -> Option<String> {
    let is_value = Property::changeable().any(|known| word.starts_with(&format!("{}=", known.as_str())));
    let verb = if is_value { Verb::Set.name() } else { verb_names().find(|name| *name == word)? };
    let rest = words.iter().filter(|other| is_value || other.as_os_str() != word);
    let rest: String = rest.map(|word| format!(" {}", terms.word(&word.display().to_string()))).collect();
    Some(match rest.as_str() {
        "" => format!("'{word}' is not a file; as a verb it would be the first word"),
        rest => format!("'{word}' is not a file: did you mean '{verb}{rest}'?"),
    })
}

/// The message that `plot fig1` cannot be drawn, even if other arguments are missing, too; or that a figure is missing before a model.
pub(crate) fn suggested_figure(words: &[String], terms: Words) -> Option<String> {
    let [verb, kind, ..] = words else { return None };
    if verb != Verb::Plot.name() {
        return None;
    }
    if kind == PlotKind::Fig1.as_str() {
        return Some(no_fig1().spelled(terms));
    }
    let is_model = !kind.starts_with('-') && Path::new(kind).extension().is_some();
    let call = |kind: &str| format!("plot force {}", terms.word(kind));
    is_model.then(|| format!("'{kind}' is not a figure: name one before the model, as in '{}'", call(kind)))
}

/// The message that the plates of `motion` have no option before them.
pub(crate) fn suggested_plates(words: &[String], terms: Words) -> Option<String> {
    let [verb, model, motion, plates, ..] = words else { return None };
    let is_table = |word: &String| word.ends_with(".mot") || word.ends_with(".sto");
    let is_motion = verb == Verb::Motion.name() && !model.starts_with('-');
    let are_names = is_motion && is_table(motion) && is_table(plates);
    let meant: Phrase = phrase!["did you mean {}?"; Input::Plates.with_value(plates.as_str())];
    are_names.then(|| format!("'{plates}' is a third name after motion: {}", meant.spelled(terms)))
}

/// The message that a blank is in a list of values, as in `--feet toes_r toes_l`, whose second body would be taken for a model.
pub(crate) fn suggested_list(words: &[String]) -> Option<String> {
    let verb = words.first().and_then(|word| Verb::find(word)).unwrap_or(Verb::Rescale);
    let takes_list = |word: &str| {
        let name = word.strip_prefix("--").unwrap_or_default().replace('-', "_");
        option_named(verb, &name).is_some_and(|option| option.list == List::Commas)
    };
    let is_word = |word: &str| !word.starts_with('-') && !word.contains('=');
    let is_value = |word: &str| is_word(word) && !may_be_file(Path::new(word), &Disk);
    words.windows(3).find_map(|typed| match typed {
        [option, first, next] if takes_list(option) && is_value(first) && is_value(next) => {
            let first = first.trim_end_matches(',');
            Some(format!("'{next}' is not a file: did you mean {option} {first},{next}? (see --help)"))
        }
        _ => None,
    })
}

/// The kilograms in an argument such as `20`, `20kg` or `20000g`.
fn typed_kilograms(word: &Path) -> Option<String> {
    Kilograms::with_unit(word.to_str()?).map(|kg| kg.to_string())
}

/// The message about an axis of a sweep that was not typed as a value of `--grid`, but as an assignment or as another option.
pub(crate) fn suggested_axis(words: &[String], terms: Words) -> Option<String> {
    let (verb, rest) = words.split_first()?;
    if verb != Verb::Sweep.name() {
        return None;
    }
    let grid = terms.input(Input::Grid, None);
    let pairs = || std::iter::once(verb).chain(rest).zip(rest).filter(|(before, _)| **before != grid);
    let assigned = pairs().find_map(|(_, word)| {
        let (name, values) = word.trim_start_matches("--").split_once('=')?;
        Some((word.clone(), AxisName::suggested_axis(name, values)?))
    });
    let of_option = || {
        pairs().find_map(|(option, values)| {
            let axis = AxisName::suggested_axis(option.strip_prefix("--")?, values)?;
            Some((format!("{option} {values}"), axis))
        })
    };
    let (word, axis) = assigned.or_else(of_option)?;
    let text: Phrase =
        phrase![format!("'{word}' is not how an axis is written: write "), Input::Grid.with_value(axis)];
    Some(text.spelled(terms))
}

/// A verb that is spelled almost like `word`, or that begins like it. If two verbs are equally near, the verb that a call without a verb
/// means comes first.
fn similar_verb(word: &Path) -> Option<String> {
    let rescale = Verb::Rescale.name();
    let names = || std::iter::once(rescale).chain(verb_names().filter(|name| *name != rescale));
    let word = word.to_str()?;
    let is_part = |name: &&str| word.len() >= 4 && begins_alike(name, word);
    nearest_names(word, names(), 2).first().copied().or_else(|| names().find(is_part)).map(str::to_owned)
}
