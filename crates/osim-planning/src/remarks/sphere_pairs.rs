//! Contacts between spheres, which end when a force is divided into forces of one sphere each.

use osim_model::feet::{DefaultPose, SpherePair, sphere_pairs};
use osim_model::messages::Phrase;
use osim_model::{Fault, FaultKind, Force, Model, Selected, SphereId};

/// Pairs that are named; more are counted.
const NAMED: usize = 3;

/// Remarks about contacts between spheres that end, one sentence for each force.
///
/// # Errors
/// Two spheres touch at the default pose, or it is not known whether they do: what keeps them apart now would be gone.
pub(crate) fn dropped_pairs(model: &Model, selected: &Selected) -> Result<Vec<Phrase>, Fault> {
    let pose = DefaultPose::of(model);
    let mut said = Vec::new();
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        let pairs = sphere_pairs(model, &pose, force);
        let names: Vec<String> =
            pairs.iter().map(|pair| apart(model, force, pair)).collect::<Result<_, _>>()?;
        if names.is_empty() {
            continue;
        }
        let more = names.len().saturating_sub(NAMED);
        let named: Vec<&str> = names.iter().take(NAMED).map(String::as_str).collect();
        let more = if more == 0 { String::new() } else { format!(", and {more} more") };
        let named = named.join("; ");
        said.push(
            format!(
                "{} acts between spheres of different bodies, too, and the new forces do not: {named}{more}",
                force.path
            )
            .into(),
        );
    }
    Ok(said)
}

/// The names of two spheres that do not touch.
fn apart(model: &Model, force: &Force, pair: &SpherePair) -> Result<String, Fault> {
    let name = |id: SphereId| model.sphere(id).map_or("", |sphere| sphere.name.as_str());
    let (one, other) = (name(pair.one), name(pair.other));
    let refused = |text: String, otherwise: &'static str| {
        let kind = FaultKind::LeaveOut { text, force: force.name.clone(), otherwise };
        Fault::new(kind).of(force.path.clone())
    };
    match &pair.gap_m {
        Err(why) => {
            let text = format!(
                "{} also lets {one} and {other} touch each other, which forces of one sphere do not, and whether they touch is not \
                 known ({why})",
                force.path
            );
            Err(refused(text, ""))
        }
        Ok(gap) if *gap > 0.0 => Ok(format!("{one} and {other}")),
        Ok(_) => {
            let text = format!(
                "in {}, {one} and {other} touch each other at the default pose, which forces of one sphere do not",
                force.path
            );
            Err(refused(text, "take one of them out of it in OpenSim"))
        }
    }
}
