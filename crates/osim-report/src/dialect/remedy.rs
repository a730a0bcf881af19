//! The inputs of a remedy, in the order in which they are written.

use osim_model::Assignment;
use osim_model::wording::{Input, Verb};
use osim_model::{Pattern, Property};
use osim_model::{Remedy, RemedyChange, RemedyDesign, RemedyLoad};

/// The value of an input.
pub(super) enum InputValue {
    Number(f64),
    Text(String),
    /// One or more patterns.
    Patterns(Vec<String>),
    /// The input alone says it.
    Flag,
}

/// A remedy, taken apart.
pub(super) struct RemedyParts<'r> {
    pub(super) verb: Verb,
    /// Properties and what happens to them.
    pub(super) assignments: &'r [(Property, Assignment)],
    pub(super) inputs: Vec<(Input, InputValue)>,
}

impl<'r> RemedyParts<'r> {
    /// `None` for a change that this version does not know.
    pub(super) fn of(remedy: &'r Remedy) -> Option<Self> {
        let mut inputs = Vec::new();
        let mut assignments: &[(Property, Assignment)] = &[];
        let verb = match &remedy.change {
            RemedyChange::Rescale { contacts_mass_kg, target_mass_kg } => {
                inputs.push((Input::ContactsMass, InputValue::Number(*contacts_mass_kg)));
                inputs.push((Input::TargetMass, InputValue::Number(*target_mass_kg)));
                Verb::Rescale
            }
            RemedyChange::Transfer { from } => {
                inputs.push((Input::From, InputValue::Text((*from).to_owned())));
                Verb::Transfer
            }
            RemedyChange::Design(wanted) => {
                inputs.extend(design(wanted));
                Verb::Design
            }
            RemedyChange::Set { assignments: set } => {
                assignments = set;
                Verb::Set
            }
            _ => return None,
        };
        inputs.extend(remedy.load.iter().flat_map(load));
        inputs.extend(choice(remedy));
        Some(Self { verb, assignments, inputs })
    }
}

fn number((input, value): (Input, Option<f64>)) -> Option<(Input, InputValue)> {
    Some((input, InputValue::Number(value?)))
}

fn design(wanted: &RemedyDesign) -> impl Iterator<Item = (Input, InputValue)> {
    let numbers = [
        (Input::Indentation, wanted.indentation),
        (Input::BodyWeights, wanted.body_weights),
        (Input::ConstantIndentation, wanted.constant_indentation),
        (Input::Restitution, wanted.restitution),
        (Input::ImpactSpeed, wanted.impact_speed_m_s),
        (Input::StateWidth, wanted.state_width),
    ];
    numbers.into_iter().filter_map(number)
}

fn load(load: &RemedyLoad) -> Vec<(Input, InputValue)> {
    let mut inputs: Vec<_> = [(Input::Mass, load.mass_kg), (Input::Gravity, load.gravity_m_s2)]
        .into_iter()
        .filter_map(number)
        .collect();
    inputs.extend(patterns(Input::ExcludeBody, &load.exclude_bodies));
    let counts = [(Input::Spheres, load.spheres), (Input::StanceLimbs, load.stance_limbs)];
    inputs.extend(counts.into_iter().filter_map(number));
    inputs
}

/// Which forces, and in which further files.
fn choice(remedy: &Remedy) -> Vec<(Input, InputValue)> {
    let selection = &remedy.selection;
    let mut inputs = Vec::new();
    inputs.extend(patterns(Input::Select, &selection.select));
    inputs.extend(patterns(Input::Exclude, &selection.exclude));
    inputs.extend(selection.skip_disabled.then_some((Input::SkipDisabled, InputValue::Flag)));
    for (input, path) in [(Input::Geometry, &remedy.geometry), (Input::Model, &remedy.set_model)] {
        inputs.extend(path.as_ref().map(|path| (input, InputValue::Text(path.display().to_string()))));
    }
    inputs
}

fn patterns(input: Input, patterns: &[Pattern]) -> Option<(Input, InputValue)> {
    let texts: Vec<String> = patterns.iter().map(|pattern| pattern.as_str().to_owned()).collect();
    (!texts.is_empty()).then_some((input, InputValue::Patterns(texts)))
}
