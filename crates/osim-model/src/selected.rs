//! Which forces a change is about.

use std::collections::HashMap;

use crate::components::Base;
use crate::contacts::{Force, ForceId};
use crate::fault::{Fault, FaultKind, Needed, TreeOfForces};
use crate::model::Model;
use crate::pattern::any_matches;
use crate::selection::Selection;
use crate::wording::Input;

/// The forces chosen by [`Selection::apply`]; none by default.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Selected {
    /// Their handles, in file order.
    pub forces: Vec<ForceId>,
    /// `false` when a force of the default choice is missing.
    pub complete: bool,
}

impl Selection {
    /// Applies the choice to `model`: by default every force in which a moving sphere meets a half-space.
    ///
    /// # Errors
    /// No force at all, no force that matches, or forces of several animals and no choice among them.
    pub fn apply(&self, model: &Model) -> Result<Selected, Fault> {
        let ids = |of: &dyn Fn(&Force) -> bool| -> Vec<ForceId> {
            model.forces().iter().filter(|force| of(force)).map(|force| force.id).collect()
        };
        let default = ids(&|force| model.meets_half_space(force));
        let explicit = !self.select.is_empty();
        let candidates =
            if explicit { ids(&|force| has_moving_sphere(model, force)) } else { default.clone() };
        if candidates.is_empty() {
            return Err(no_contacts(model));
        }
        let wanted = |id: &ForceId| {
            model.force(*id).is_some_and(|force| {
                (!explicit || any_matches(&self.select, &force.name))
                    && !any_matches(&self.exclude, &force.name)
                    && (force.applies || !self.skip_disabled)
            })
        };
        let forces: Vec<ForceId> = candidates.iter().copied().filter(wanted).collect();
        if forces.is_empty() {
            return Err(Fault::new(FaultKind::NothingSelected { forces: model.names_of(&candidates) }));
        }
        if !explicit {
            refuse_several_trees(model, &forces)?;
        }
        let complete = default.iter().all(|id| forces.binary_search(id).is_ok());
        Ok(Selected { forces, complete })
    }
}

impl Model {
    /// Up to six names of forces, so that a message stays readable.
    #[must_use]
    pub fn names_of(&self, forces: &[ForceId]) -> String {
        const SHOWN: usize = 6;
        let named: Vec<&str> =
            forces.iter().filter_map(|&id| self.force(id)).map(|force| force.name.as_str()).collect();
        let shown = named.iter().take(SHOWN).copied().collect::<Vec<_>>().join(", ");
        if named.len() > SHOWN { format!("{shown} and {} more", named.len() - SHOWN) } else { shown }
    }
}

fn has_moving_sphere(model: &Model, force: &Force) -> bool {
    force.spheres().into_iter().any(|id| model.sphere(id).is_some_and(|sphere| !sphere.fixed))
}

fn no_contacts(model: &Model) -> Fault {
    let detail = if model.forces().is_empty() {
        "there is no HuntCrossleyForce and no SmoothSphereHalfSpaceForce in it".to_owned()
    } else {
        format!("in none of its {} contact forces a moving sphere meets a half-space", model.forces().len())
    };
    Fault::new(FaultKind::NoContacts { detail })
}

/// Player and ball: bodies joined only through ground are not one animal, and only the user knows which is meant.
fn refuse_several_trees(model: &Model, forces: &[ForceId]) -> Result<(), Fault> {
    let mut trees: Vec<(String, Vec<ForceId>)> = Vec::new();
    let mut by_name: HashMap<String, usize> = HashMap::new();
    for force in forces.iter().filter_map(|&id| model.force(id)) {
        for sphere in force.spheres().into_iter().filter_map(|sphere| model.sphere(sphere)) {
            let Base::Body(body) = sphere.base else { continue };
            if sphere.fixed {
                continue;
            }
            let top = model.components().name(model.skeleton().top(body));
            let known = *by_name.entry(top.clone()).or_insert(trees.len());
            match trees.get_mut(known) {
                Some((_, forces)) if forces.last() == Some(&force.id) => {}
                Some((_, forces)) => forces.push(force.id),
                None => trees.push((top, vec![force.id])),
            }
        }
    }
    if trees.len() < 2 {
        return Ok(());
    }
    let tree = |(top, forces): (String, Vec<ForceId>)| TreeOfForces { top, forces: model.names_of(&forces) };
    let trees = trees.into_iter().map(tree).collect();
    Err(Fault::new(Needed::Selection { trees, input: Input::Select }))
}
