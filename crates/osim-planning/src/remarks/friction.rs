//! A remark on speeds of friction that stay those of another size.

use contact_scaling::Ratios;
use osim_model::messages::{Input, Phrase, phrase, three_significant};
use osim_model::{Force, Model, Property};
use osim_patch::Plan;

/// A factor of speeds so close to 1 (masses within 1.8) changes little.
const SAME: f64 = 0.1;

/// What it costs that the contacts of `built` keep their reference's speeds of friction; `None` where the body is as large as the
/// reference, or has no friction. The slip speed at which friction is full goes with √R (isometric: M^(1/6)), as all speeds of a body do.
pub(crate) fn friction_stays(plan: &Plan, built: &Model) -> Option<Phrase> {
    let masses = plan.masses.as_ref()?;
    let ratios = Ratios::isometric(masses.target_mass_kg / masses.contacts_mass.kg).ok()?;
    let factor = ratios.transition_velocity();
    if (factor - 1.0).abs() <= SAME || !built.forces().iter().any(has_friction) {
        return None;
    }
    let text = format!(
        "transition_velocity and viscous_friction stay the reference's, but speeds of this body are {} times as high: in trials from a \
         mouse to a giraffe, feet that were pushed then slid 0.6 to 3.8 times as far (docs/studies/falls.md); scale them too with ",
        three_significant(factor)
    );
    Some(phrase![text, Input::Friction])
}

fn has_friction(force: &Force) -> bool {
    const FRICTION: [Property; 3] =
        [Property::StaticFriction, Property::DynamicFriction, Property::ViscousFriction];
    let value = |set, property| force.checked(set, property).ok().flatten();
    force
        .sets
        .iter()
        .any(|set| FRICTION.iter().any(|&one| value(set.id, one).is_some_and(|value| value > 0.0)))
}
