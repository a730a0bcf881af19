//! A usage error in one line.

use clap::error::{ContextKind, ContextValue, ErrorKind};
use osim_model::messages::{Phrase, shown};

/// A usage error in one line: what is wrong and what was expected.
pub(crate) fn usage_line(error: &clap::Error) -> String {
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.clone()),
        _ => None,
    };
    let from_parser = std::error::Error::source(error).map(ToString::to_string);
    if error.kind() == ErrorKind::ValueValidation
        && let (Some(value), Some(option), Some(reason)) =
            (context(ContextKind::InvalidValue), context(ContextKind::InvalidArg), from_parser)
    {
        let option = option.split(' ').next().unwrap_or_default().to_owned();
        return format!("{option} '{}': {reason}", shown(&value));
    }
    if let (ErrorKind::InvalidValue, Some(value), Some(option), Some(near)) = (
        error.kind(),
        context(ContextKind::InvalidValue),
        context(ContextKind::InvalidArg),
        context(ContextKind::SuggestedValue),
    ) {
        // A value without an option is named by what it is alone.
        let option = match option.split(' ').next() {
            Some(name) if name.starts_with('-') => format!("{name} "),
            _ => String::new(),
        };
        return format!("{option}'{}': did you mean '{near}'?", shown(&value));
    }
    let text = error.render().to_string();
    let mut lines = text.lines().map(str::trim_ascii).filter(|line| !line.is_empty());
    let first = lines.next().unwrap_or_default().trim_start_matches("error: ").to_owned();
    let rest: Vec<&str> = lines
        .take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"))
        .map(|line| line.trim_start_matches("tip: "))
        // Nobody who misspells an option wants it to be a file.
        .filter(|line| !line.contains("as a value, use '--"))
        .collect();
    let joint = if first.ends_with(':') { " " } else { "; " };
    let line = if rest.is_empty() { first } else { format!("{first}{joint}{}", rest.join(", ")) };
    Phrase::from(line).to_string()
}
