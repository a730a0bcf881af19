//! A model's spheres as CSV: one row per sphere that stands, numbers in full.

use osim_inspect::{Figure, InspectedForce, Inspection, LimbFigures, LoadFigures, SphereFigures};
use osim_model::{Property, shortest};

use crate::layout::csv_text;

/// Where a value comes from: the model, the limb, the sphere, and the force that presses it.
struct Place<'p> {
    model: &'p Inspection,
    limb: &'p LimbFigures,
    sphere: &'p SphereFigures,
    force: Option<&'p InspectedForce>,
}

type Column = (&'static str, fn(&Place<'_>) -> String);

fn text(value: Option<f64>) -> String {
    value.map(shortest).unwrap_or_default()
}

fn parameter(place: &Place<'_>, property: Property) -> String {
    text(place.force.and_then(|force| force.parameters.get(property)))
}

fn load(place: &Place<'_>, body_weights: f64, of: fn(&LoadFigures) -> Option<f64>) -> String {
    text(place.sphere.load(body_weights).and_then(of))
}

fn is_within(place: &Place<'_>, figure: Figure) -> String {
    place.sphere.is_within(figure).map(|within| within.to_string()).unwrap_or_default()
}

/// `docs/json.md` explains the columns; they have the names of the JSON fields.
const COLUMNS: [Column; 45] = [
    ("model", |p| p.model.model.clone()),
    ("name", |p| p.model.name.clone()),
    ("mass_kg", |p| text(p.model.mass_kg)),
    ("contacts_mass_kg", |p| text(p.model.contacts_mass_kg.as_ref().map(|mass| mass.value))),
    ("gravity_m_s2", |p| text(p.model.gravity_m_s2)),
    ("impact_speed_m_s", |p| text(p.model.figures.impact_speed_m_s)),
    ("limb", |p| p.limb.limb.clone().unwrap_or_default()),
    ("side", |p| p.limb.side.unwrap_or_default().to_owned()),
    ("sphere_count", |p| text(p.limb.sphere_count)),
    ("sphere", |p| p.sphere.sphere.clone()),
    ("path", |p| p.sphere.path.clone()),
    ("forces", |p| p.sphere.forces.join(" ")),
    ("radius_m", |p| shortest(p.sphere.radius_m)),
    ("stiffness", |p| parameter(p, Property::Stiffness)),
    ("composite_modulus_n_m2", |p| shortest(p.sphere.composite_modulus_n_m2)),
    ("dissipation", |p| parameter(p, Property::Dissipation)),
    ("static_friction", |p| parameter(p, Property::StaticFriction)),
    ("dynamic_friction", |p| parameter(p, Property::DynamicFriction)),
    ("viscous_friction", |p| parameter(p, Property::ViscousFriction)),
    ("transition_velocity", |p| parameter(p, Property::TransitionVelocity)),
    ("constant_contact_force", |p| parameter(p, Property::ConstantContactForce)),
    ("hertz_smoothing", |p| parameter(p, Property::HertzSmoothing)),
    ("hunt_crossley_smoothing", |p| parameter(p, Property::HuntCrossleySmoothing)),
    ("load_n", |p| load(p, 1.0, |l| Some(l.load_n))),
    ("hertz", |p| load(p, 1.0, |l| l.hertz)),
    ("own", |p| load(p, 1.0, |l| l.own)),
    ("level_hertz", |p| load(p, 1.0, |l| l.level_hertz)),
    ("level_own", |p| load(p, 1.0, |l| l.level_own)),
    ("hertz_at_two", |p| load(p, 2.0, |l| l.hertz)),
    ("own_at_two", |p| load(p, 2.0, |l| l.own)),
    ("level_hertz_at_two", |p| load(p, 2.0, |l| l.level_hertz)),
    ("level_own_at_two", |p| load(p, 2.0, |l| l.level_own)),
    ("contact_stiffness_n_m", |p| text(p.sphere.contact_stiffness_n_m)),
    ("dimensionless_stiffness", |p| text(p.sphere.dimensionless_stiffness)),
    ("natural_frequency_hz", |p| text(p.sphere.natural_frequency_hz)),
    ("mean_contact_stress_n_m2", |p| text(p.sphere.mean_contact_stress_n_m2)),
    ("restitution_exact", |p| text(p.sphere.restitution_exact)),
    ("restitution_approximate", |p| text(p.sphere.restitution_approximate)),
    ("constant_indentation", |p| text(p.sphere.constant_indentation)),
    ("transition_width", |p| text(p.sphere.transition_width)),
    ("force_just_touching_n", |p| text(p.sphere.force_just_touching_n)),
    ("touching_share", |p| text(p.sphere.touching_share)),
    ("hertz_holds", |p| is_within(p, Figure::Hertz)),
    ("restitution_holds", |p| is_within(p, Figure::Restitution)),
    ("warnings", |p| {
        p.model.warnings.iter().map(|warning| warning.code.as_str()).collect::<Vec<_>>().join(" ")
    }),
];

/// The rows of one model, behind a header where `header`.
///
/// # Errors
/// None in practice: the rows are written into memory.
pub fn csv_rows(inspected: &Inspection, header: bool) -> Result<String, csv::Error> {
    let header = header.then(|| COLUMNS.map(|(name, _)| name.to_owned()).to_vec());
    let spheres =
        inspected.figures.limbs.iter().flat_map(|limb| limb.spheres.iter().map(move |sphere| (limb, sphere)));
    let rows = spheres.map(|(limb, sphere)| {
        let presses = |force: &&InspectedForce| {
            sphere.forces.contains(&force.name) && force.spheres.contains(&sphere.sphere)
        };
        let place = Place { model: inspected, limb, sphere, force: inspected.forces.iter().find(presses) };
        COLUMNS.map(|(_, value)| value(&place)).to_vec()
    });
    csv_text(header.into_iter().chain(rows))
}
