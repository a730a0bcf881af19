//! A model's spheres as CSV: one row per sphere that stands, numbers in full.

use std::collections::{HashMap, HashSet};

use osim_inspect::{Figure, InspectedForce, Inspection, LimbFigures, Quantity, SphereFigures};
use osim_model::Property;
use osim_model::messages::shortest;

use crate::report::layout::csv_text;

/// Where a value comes from: the model, the limb, the sphere, and the force that presses it.
struct Place<'p> {
    model: &'p Inspection,
    limb: &'p LimbFigures,
    sphere: &'p SphereFigures,
    force: Option<&'p InspectedForce>,
    /// The codes of the model's warnings.
    warnings: &'p str,
}

fn text(value: Option<f64>) -> String {
    value.map(shortest).unwrap_or_default()
}

/// What gives a cell.
type Cell = fn(&Place<'_>) -> String;

/// What says which model, limb and sphere a row is about.
const PLACE: [(&str, Cell); 12] = [
    ("model_file", |p| p.model.model.clone()),
    ("model_name", |p| p.model.name.clone()),
    ("mass_kg", |p| text(p.model.mass_kg)),
    ("mass_contacts_were_made_for_kg", |p| text(p.model.contacts_mass_kg.as_ref().map(|mass| mass.value))),
    ("gravity_m_per_s2", |p| text(p.model.gravity_m_s2)),
    ("impact_speed_m_per_s", |p| text(p.model.figures.impact_speed_m_s)),
    ("limb", |p| p.limb.limb.clone().unwrap_or_default()),
    ("side", |p| p.limb.side.unwrap_or_default().to_owned()),
    ("spheres_sharing_body_weight", |p| text(p.limb.sphere_count)),
    ("sphere", |p| p.sphere.sphere.clone()),
    ("sphere_path", |p| p.sphere.path.clone()),
    ("force_names", |p| p.sphere.forces.join(" ")),
];

/// The parameters of the first force that presses the sphere.
const PARAMETERS: [Property; 9] = [
    Property::Stiffness,
    Property::Dissipation,
    Property::StaticFriction,
    Property::DynamicFriction,
    Property::ViscousFriction,
    Property::TransitionVelocity,
    Property::ConstantContactForce,
    Property::HertzSmoothing,
    Property::HuntCrossleySmoothing,
];

/// After the figures: the columns of those that are beyond their limits, and the codes of warnings.
const LAST: [&str; 2] = ["outside_limits", "warnings"];

/// The names of all columns. `docs/reference/json.md` explains them.
fn header() -> Vec<String> {
    let place = PLACE.iter().map(|(name, _)| (*name).to_owned());
    let parameters = PARAMETERS.iter().map(|&property| Quantity::property(property).column());
    let figures = Figure::ALL.iter().map(|figure| figure.info().column());
    place.chain(parameters).chain(figures).chain(LAST.map(str::to_owned)).collect()
}

fn cells(place: &Place<'_>) -> Vec<String> {
    let parameter = |property| text(place.force.and_then(|force| force.parameters.get(property)));
    let figures = Figure::ALL.iter().map(|&figure| text(place.sphere.value(figure)));
    let is_outside = |figure: &&Figure| place.sphere.is_within(**figure) == Some(false);
    let outside: Vec<String> =
        Figure::ALL.iter().filter(is_outside).map(|figure| figure.info().column()).collect();
    let last = [outside.join(" "), place.warnings.to_owned()];
    let before = PLACE.iter().map(|(_, cell)| cell(place)).chain(PARAMETERS.map(parameter));
    before.chain(figures).chain(last).collect()
}

/// The codes of a model's warnings, each once: every row repeats them.
fn codes(inspected: &Inspection) -> String {
    let mut seen = HashSet::new();
    let codes = inspected.warnings.iter().map(|warning| warning.code().as_str());
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
