//! `explain`: what an equation says, and what a warning or an error means and asks for.

mod ascii;
mod errors;
mod json;
mod rules;
mod text;
mod uses;

use anyhow::{Result, bail};
use contact_scaling::Equation;
use osim_patch::WarningCode;

use crate::args::{ExplainArgs, Format};
use crate::terminal::Terminal;
pub(crate) use errors::ErrorCode;

/// Something that can be explained.
#[derive(Clone, Copy)]
enum Topic {
    Equation(&'static Equation),
    Warning(WarningCode),
    Error(&'static ErrorCode),
}

/// Equations of the paper and beyond, then the tool's own rules.
pub(crate) fn equations() -> impl Iterator<Item = &'static Equation> {
    contact_scaling::equations::all().chain(rules::ALL)
}

fn all() -> Vec<Topic> {
    let warnings = WarningCode::ALL.iter().copied().map(Topic::Warning);
    equations().map(Topic::Equation).chain(warnings).chain(errors::ALL.iter().map(Topic::Error)).collect()
}

/// Explains what `args` names, or lists everything.
///
/// # Errors
/// Something that is neither an equation nor a code.
pub(crate) fn run(args: &ExplainArgs, terminal: &mut Terminal) -> Result<()> {
    let named = args.topics.join(" ");
    let topics = if named.is_empty() { all() } else { find(&named)? };
    let plain = args.ascii || !Terminal::shows_unicode();
    let spelled: text::Spelling = if plain { ascii::ascii } else { str::to_owned };
    let text = match args.format {
        Format::Json => topics.into_iter().map(json::of).collect(),
        Format::Table if named.is_empty() => text::list(&topics, spelled),
        Format::Table => {
            topics.into_iter().map(|topic| text::of(topic, spelled)).collect::<Vec<_>>().join("\n")
        }
    };
    terminal.print(&text)?;
    Ok(())
}

/// All topics of `named`: one name, or several as the column "equation" has them (`11, B.2`).
fn find(named: &str) -> Result<Vec<Topic>> {
    let by_comma: Vec<&str> = named.split(',').map(str::trim).filter(|name| !name.is_empty()).collect();
    let by_blank: Vec<&str> = named.split([',', ' ']).filter(|name| !name.is_empty()).collect();
    for names in [&[named][..], &by_comma, &by_blank] {
        let found: Vec<Vec<Topic>> = names.iter().map(|name| called(name)).collect();
        if found.iter().all(|topics| !topics.is_empty()) {
            return Ok(found.concat());
        }
    }
    let unknown = by_comma.into_iter().find(|name| called(name).is_empty()).unwrap_or(named);
    bail!("'{unknown}' is no equation and no code{}", way_out(unknown))
}

/// The equation or rule of this name.
pub(crate) fn equation(name: &str) -> Option<&'static Equation> {
    let rule = || rules::ALL.iter().find(|rule| rule.label.eq_ignore_ascii_case(name));
    contact_scaling::equations::find(name).or_else(rule)
}

/// The error of this code.
pub(crate) fn error(code: &str) -> Option<&'static ErrorCode> {
    errors::ALL.iter().find(|error| error.code == code)
}

/// Everything called so: a code may be both a warning's and an error's.
fn called(name: &str) -> Vec<Topic> {
    let is_code = |code: &str| code == name.trim_matches(['[', ']', ' ']);
    let equation = equation(name).map(Topic::Equation);
    let warning = WarningCode::ALL.iter().copied().find(|code| is_code(code.as_str())).map(Topic::Warning);
    let error = errors::ALL.iter().find(|known| is_code(known.code)).map(Topic::Error);
    [equation, warning, error].into_iter().flatten().collect()
}

/// Names like `unknown`, if there are any.
fn way_out(unknown: &str) -> String {
    let known: Vec<&str> = all().into_iter().map(Topic::name).collect();
    match similar::get_close_matches(unknown, &known, 1, 0.7).first() {
        Some(near) => format!(", expected one like '{near}': `osim-contact-scale explain` lists them"),
        None => ": `osim-contact-scale explain` lists them".to_owned(),
    }
}

impl Topic {
    fn name(self) -> &'static str {
        match self {
            Self::Equation(equation) => equation.label,
            Self::Warning(code) => code.as_str(),
            Self::Error(error) => error.code,
        }
    }
}
