//! A model's spheres as CSV: one row per sphere that stands, numbers in full.

use std::collections::{HashMap, HashSet};

use osim_inspect::{Figure, InspectedForce, Inspection, LimbFigures, SphereFigures};
use osim_model::{Property, shortest};

use crate::layout::csv_text;

/// Where a value comes from: the model, the limb, the sphere, and the force that presses it.
struct Place<'p> {
    model: &'p Inspection,
    limb: &'p LimbFigures,
    sphere: &'p SphereFigures,
    force: Option<&'p InspectedForce>,
    /// The codes of the model's warnings.
    warnings: &'p str,
}

type Column = (&'static str, fn(&Place<'_>) -> String);

fn text(value: Option<f64>) -> String {
    value.map(shortest).unwrap_or_default()
}

fn parameter(place: &Place<'_>, property: Property) -> String {
    text(place.force.and_then(|force| force.parameters.get(property)))
}

/// `docs/json.md` explains the columns; they have the names of the JSON fields.
const COLUMNS: [Column; 21] = [
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
    ("stiffness", |p| parameter(p, Property::Stiffness)),
    ("dissipation", |p| parameter(p, Property::Dissipation)),
    ("static_friction", |p| parameter(p, Property::StaticFriction)),
    ("dynamic_friction", |p| parameter(p, Property::DynamicFriction)),
    ("viscous_friction", |p| parameter(p, Property::ViscousFriction)),
    ("transition_velocity", |p| parameter(p, Property::TransitionVelocity)),
    ("constant_contact_force", |p| parameter(p, Property::ConstantContactForce)),
    ("hertz_smoothing", |p| parameter(p, Property::HertzSmoothing)),
    ("hunt_crossley_smoothing", |p| parameter(p, Property::HuntCrossleySmoothing)),
];

/// After the figures: the names of those that are beyond their limits, and the codes of warnings.
const LAST: [&str; 2] = ["outside_limits", "warnings"];

fn header() -> Vec<String> {
    let figures = Figure::ALL.iter().map(|figure| figure.info().name);
    let columns = COLUMNS.iter().map(|(name, _)| *name);
    columns.chain(figures).chain(LAST).map(str::to_owned).collect()
}

fn cells(place: &Place<'_>) -> Vec<String> {
    let figures = Figure::ALL.iter().map(|&figure| text(place.sphere.value(figure)));
    let outside = place.sphere.limits().filter(|check| !check.within_limit).map(|check| check.figure);
    let last = [outside.collect::<Vec<_>>().join(" "), place.warnings.to_owned()];
    COLUMNS.iter().map(|(_, value)| value(place)).chain(figures).chain(last).collect()
}

/// The codes of a model's warnings, each once: every row repeats them.
fn codes(inspected: &Inspection) -> String {
    let mut seen = HashSet::new();
    let codes = inspected.warnings.iter().map(|warning| warning.code.as_str());
    codes.filter(|code| seen.insert(*code)).collect::<Vec<_>>().join(" ")
}

/// The rows of one model, after a header where `header`.
///
/// # Errors
/// None in practice: the rows are written into memory.
pub fn csv_rows(inspected: &Inspection, header: bool) -> Result<String, csv::Error> {
    let header = header.then(self::header);
    let spheres =
        inspected.figures.limbs.iter().flat_map(|limb| limb.spheres.iter().map(move |sphere| (limb, sphere)));
    // The first force of each name that presses a sphere of each name.
    let mut pressing: HashMap<(&str, &str), usize> = HashMap::new();
    for (at, force) in inspected.forces.iter().enumerate() {
        for sphere in &force.spheres {
            pressing.entry((&force.name, sphere)).or_insert(at);
        }
    }
    let warnings = codes(inspected);
    let rows = spheres.map(|(limb, sphere)| {
        let presses = |force: &String| pressing.get(&(force.as_str(), sphere.sphere.as_str())).copied();
        let first = sphere.forces.iter().filter_map(presses).min();
        let force = first.and_then(|at| inspected.forces.get(at));
        cells(&Place { model: inspected, limb, sphere, force, warnings: &warnings })
    });
    csv_text(header.into_iter().chain(rows))
}
