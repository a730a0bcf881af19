//! Which forces a change is about.

use globset::GlobSet;

use crate::error::{Fault, FaultKind};
use crate::model::{Base, Model};

/// The user's choice of forces, by name.
#[derive(Debug, Clone, Default)]
pub struct Selection {
    /// Only forces whose name matches; empty for the default choice.
    pub select: GlobSet,
    /// Never forces whose name matches.
    pub exclude: GlobSet,
    /// Leave out forces that are switched off.
    pub skip_disabled: bool,
}

/// The chosen forces.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Selected {
    /// Indices into [`Model::forces`].
    pub forces: Vec<usize>,
    /// `false` when a force of the default choice is missing.
    pub complete: bool,
}

impl Selection {
    /// Applies the choice to `model`: by default every force in which a moving sphere meets a half-space.
    ///
    /// # Errors
    /// No force at all, no force that matches, or forces of several animals and no choice among them.
    pub fn apply(&self, model: &Model<'_, '_>) -> Result<Selected, Fault> {
        let default: Vec<usize> = (0..model.forces.len())
            .filter(|&i| model.forces.get(i).is_some_and(|f| model.meets_half_space(f)))
            .collect();
        let explicit = !self.select.is_empty();
        let candidates: Vec<usize> = if explicit {
            (0..model.forces.len()).filter(|&i| has_moving_sphere(model, i)).collect()
        } else {
            default.clone()
        };
        if candidates.is_empty() {
            return Err(no_contacts(model));
        }
        let wanted = |index: &usize| {
            model.forces.get(*index).is_some_and(|force| {
                (!explicit || self.select.is_match(&force.name))
                    && !self.exclude.is_match(&force.name)
                    && (force.applies || !self.skip_disabled)
            })
        };
        let forces: Vec<usize> = candidates.iter().copied().filter(wanted).collect();
        if forces.is_empty() {
            return Err(Fault::refused(format!(
                "no contact force is left by --select, --exclude and --skip-disabled; the model has {}",
                names(model, &candidates)
            )));
        }
        if !explicit {
            refuse_several_trees(model, &forces)?;
        }
        let complete = default.iter().all(|index| forces.binary_search(index).is_ok());
        Ok(Selected { forces, complete })
    }
}

fn has_moving_sphere(model: &Model<'_, '_>, force: usize) -> bool {
    let spheres = model.forces.get(force).map(crate::model::Force::spheres).unwrap_or_default();
    spheres.into_iter().any(|sphere| model.spheres.get(sphere).is_some_and(|sphere| !sphere.fixed))
}

fn no_contacts(model: &Model<'_, '_>) -> Fault {
    let detail = if model.forces.is_empty() {
        "there is no HuntCrossleyForce and no SmoothSphereHalfSpaceForce in it".to_owned()
    } else {
        format!("in none of its {} contact forces a moving sphere meets a half-space", model.forces.len())
    };
    Fault::new(FaultKind::NoContacts { detail })
}

/// Up to six names, so that a message stays readable.
pub(crate) fn names(model: &Model<'_, '_>, forces: &[usize]) -> String {
    const SHOWN: usize = 6;
    let named: Vec<&str> =
        forces.iter().filter_map(|&i| model.forces.get(i)).map(|force| force.name.as_str()).collect();
    let shown = named.iter().take(SHOWN).copied().collect::<Vec<_>>().join(", ");
    if named.len() > SHOWN { format!("{shown} and {} more", named.len() - SHOWN) } else { shown }
}

/// Player and ball: bodies joined only through ground are not one animal, and only the user knows which is meant.
fn refuse_several_trees(model: &Model<'_, '_>, forces: &[usize]) -> Result<(), Fault> {
    let mut trees: Vec<(String, Vec<usize>)> = Vec::new();
    for &index in forces {
        let Some(force) = model.forces.get(index) else { continue };
        for sphere in force.spheres().into_iter().filter_map(|sphere| model.spheres.get(sphere)) {
            let Base::Body(body) = sphere.base else { continue };
            if sphere.fixed {
                continue;
            }
            let top =
                model.skeleton().chain(body).last().map(|&id| model.files().name(id)).unwrap_or_default();
            match trees.iter_mut().find(|(name, _)| *name == top) {
                Some((_, forces)) if forces.contains(&index) => {}
                Some((_, forces)) => forces.push(index),
                None => trees.push((top, vec![index])),
            }
        }
    }
    if trees.len() < 2 {
        return Ok(());
    }
    let described: Vec<_> =
        trees.iter().map(|(top, forces)| format!("{top} (forces {})", names(model, forces))).collect();
    Err(Fault::new(FaultKind::NeedsAnswer {
        code: "several-trees",
        question: format!(
            "contact spheres stand on bodies that are joined only through ground: {}",
            described.join("; ")
        ),
        way_out: "say which forces are meant with --select GLOB".to_owned(),
    }))
}
