//! Forces with the same parameters together.

use std::collections::HashMap;

use osim_inspect::{InspectedForce, Inspection};
use osim_model::Property;
use osim_model::messages::{four_significant, readable};

/// Forces with the same parameters.
pub struct ForceGroup<'m> {
    /// The parameters, in the order of the table.
    pub cells: Vec<String>,
    /// The forces, in the order of the file.
    pub forces: Vec<&'m InspectedForce>,
}

/// The forces of a model, those with the same parameters together.
pub fn groups(inspected: &Inspection) -> Vec<ForceGroup<'_>> {
    let mut groups: Vec<ForceGroup<'_>> = Vec::new();
    let (mut places, mut exact) = (HashMap::new(), HashMap::new());
    for force in &inspected.forces {
        let how = (force.kind, force.applies, force.selected);
        let found = || *places.entry((parameters(force), how)).or_insert(groups.len());
        let place = *exact.entry((exact_parameters(force), how)).or_insert_with(found);
        match groups.get_mut(place) {
            Some(group) => group.forces.push(force),
            None => groups.push(ForceGroup { cells: parameters(force), forces: vec![force] }),
        }
    }
    groups
}

/// Whether a number of the force is not in the object itself.
pub fn has_default(force: &InspectedForce) -> bool {
    Property::ALL.iter().any(|&property| force.origin.is_default(property))
}

/// How many forces of which class, and their names.
pub fn described(members: &[&InspectedForce]) -> String {
    const SHOWN: usize = 6;
    let Some(first) = members.first() else { return String::new() };
    let name = |force: &&InspectedForce| match force.set {
        Some(set) if set > 0 => format!("{} (set {set})", force.name),
        _ => force.name.clone(),
    };
    let mut names: Vec<String> = members.iter().take(SHOWN).map(name).collect();
    if members.len() > SHOWN {
        names.push(format!("{} more", members.len() - SHOWN));
    }
    let mut text = format!("{} x {}: {}", members.len(), first.kind, names.join(", "));
    if !first.applies {
        text.push_str(" (disabled)");
    }
    if !first.selected {
        text.push_str(" (not ground contact)");
    }
    text
}

fn parameters(force: &InspectedForce) -> Vec<String> {
    let one = |property: Property| match force.parameters.get(property) {
        Some(value) => {
            format!("{}{}", short(value), if force.origin.is_default(property) { "*" } else { "" })
        }
        None => "-".to_owned(),
    };
    let friction = [Property::StaticFriction, Property::DynamicFriction, Property::ViscousFriction].map(one);
    vec![
        one(Property::Stiffness),
        force.composite_modulus_n_m2.map_or_else(|| "-".to_owned(), four_significant),
        one(Property::Dissipation),
        friction.join("/"),
        one(Property::TransitionVelocity),
        one(Property::ConstantContactForce),
        one(Property::HertzSmoothing),
        one(Property::HuntCrossleySmoothing),
    ]
}

/// What the cells are made from: if it is equal, so are they.
fn exact_parameters(force: &InspectedForce) -> (Vec<(Option<u64>, bool)>, Option<u64>) {
    let one = |&property: &Property| {
        (force.parameters.get(property).map(f64::to_bits), force.origin.is_default(property))
    };
    (Property::ALL.iter().map(one).collect(), force.composite_modulus_n_m2.map(f64::to_bits))
}

/// A number of the file: exact if the exact text is short.
fn short(value: f64) -> String {
    let exact = readable(value);
    if exact.len() <= 8 { exact } else { four_significant(value) }
}
