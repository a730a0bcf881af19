//! Which options the help of a verb shows: those that it takes, the usual ones first; rare ones under `--help` alone.

use clap::Command;
use osim_model::messages::{Input, Verb};

/// After all usual ones under its heading.
const LAST: usize = 1000;

/// Options that groups bring along and that this verb refuses, or that change nothing for it: each is answered where it is typed,
/// and the help does not offer it.
fn refused(verb: Verb) -> &'static [Input] {
    match verb {
        Verb::Transfer => &[Input::ContactsMass, Input::ContactsGravity],
        Verb::Add | Verb::Design | Verb::DropTest => &[Input::ContactsMass],
        Verb::Remove | Verb::Convert => &[Input::GeometryOutput],
        Verb::Batch => &[Input::Output, Input::GeometryOutput],
        Verb::Sweep => &[Input::Stiffness],
        _ => &[],
    }
}

/// Options that few calls need.
fn rare(verb: Verb) -> &'static [Input] {
    match verb {
        Verb::Rescale => {
            &[Input::Exclude, Input::Diff, Input::Only, Input::Keep, Input::BodyScaleFile, Input::Format]
        }
        Verb::Set => &[Input::Exclude, Input::Diff, Input::Only, Input::Keep],
        Verb::Transfer => &[
            Input::Exclude,
            Input::Diff,
            Input::Only,
            Input::Keep,
            Input::StanceLimbs,
            Input::ReferenceSphere,
            Input::BodyScale,
            Input::MovedSpheres,
            Input::Rule,
        ],
        Verb::Add => &[
            Input::Diff,
            Input::StanceLimbs,
            Input::ReferenceSphere,
            Input::Young,
            Input::Poisson,
            Input::Load,
            Input::BodyWeights,
            Input::Gravity,
        ],
        Verb::Design => &[
            Input::Exclude,
            Input::Diff,
            Input::StanceLimbs,
            Input::ContactStiffness,
            Input::Young,
            Input::Poisson,
            Input::Threshold,
            Input::StateWidth,
            Input::SpeedWidth,
        ],
        Verb::Sweep => &[
            Input::Exclude,
            Input::StanceLimbs,
            Input::Soft,
            Input::Quiet,
            Input::Load,
            Input::BodyWeights,
            Input::Gravity,
            Input::ContactStiffness,
            Input::Young,
            Input::Poisson,
            Input::Threshold,
            Input::StateWidth,
            Input::SpeedWidth,
            Input::ConstantIndentation,
            Input::ContactsMass,
        ],
        Verb::Batch => &[Input::Diff],
        Verb::Inspect | Verb::Check => {
            &[Input::Exclude, Input::StanceLimbs, Input::ImpactSpeed, Input::Gravity, Input::BodyScaleFile]
        }
        Verb::DropTest => &[Input::Exclude, Input::StanceLimbs, Input::Samples, Input::CompareSpheres],
        Verb::Plot => &[
            Input::Exclude,
            Input::StanceLimbs,
            Input::Duration,
            Input::ContactsMass,
            Input::XColumn,
            Input::YColumn,
            Input::ValueRange,
        ],
        Verb::Motion => &[Input::Exclude, Input::ContactsMass],
        Verb::Fit => &[
            Input::SpeedColumn,
            Input::TimeColumn,
            Input::SpeedUnit,
            Input::TimeUnit,
            Input::Branch,
            Input::Exclude,
            Input::ContactsMass,
            Input::Diff,
            Input::Format,
            Input::OutputDir,
            Input::InPlace,
        ],
        _ => &[],
    }
}

/// What an option is for this verb, where the help of its group is about another.
fn reworded(verb: Verb, name: &str) -> Option<&'static str> {
    let is_radius_of_transfer = verb == Verb::Transfer && name == Input::Radius.name();
    is_radius_of_transfer.then_some(
        "Radii: keep, isometric (as large against the body as the reference's), a radius in metres, or a factor like x1.5 \
         [default: keep]",
    )
}

/// The parser of `verb` with a help of what it takes.
pub(super) fn with_usual_first(command: Command, verb: Verb) -> Command {
    let is_in = |inputs: &[Input], name: &str| inputs.iter().any(|input| input.name() == name);
    command.mut_args(|argument| {
        let name = argument.get_id().as_str().to_owned();
        let is_rare = is_in(rare(verb), &name) || argument.is_hide_short_help_set();
        let argument = if is_rare { argument.hide_short_help(true).display_order(LAST) } else { argument };
        let argument = match reworded(verb, &name) {
            Some(help) => argument.help(help).long_help(help),
            None => argument,
        };
        if is_in(refused(verb), &name) { argument.hide(true) } else { argument }
    })
}
