//! Values of coordinates at the default pose: their defaults, and what constraints make of them.

use std::collections::{HashMap, HashSet};

use osim_model::{Document, ElementId, FileId, Model, ModelJoint, opensim_text};

use crate::pose_fault::PoseFault;

/// OpenSim leaves coordinates that are this close to what a constraint says.
const ASSEMBLED: f64 = 1e-10;
/// How often constraints that depend on each other are followed, at most.
const PASSES: usize = 8;
/// From this version on, a constraint says whether it is enforced, not whether it is disabled.
const ENFORCED: u32 = 30509;

/// One coordinate that is a function of another.
struct Coupler<'m> {
    document: &'m Document,
    function: ElementId,
    factor: f64,
    independent: String,
    dependent: String,
}

/// Values of all coordinates whose value is known, and the first constraint that is not understood.
pub(crate) fn coordinate_values(
    model: &Model,
    joints: &[ModelJoint],
) -> (HashMap<String, f64>, Option<PoseFault>) {
    let mut values = HashMap::new();
    for joint in joints {
        let document = model.file(joint.file);
        for coordinate in &joint.coordinates {
            let value = prescribed(document, coordinate.element).unwrap_or(coordinate.default);
            if let Some(value) = value {
                values.entry(coordinate.name.clone()).or_insert(value);
            }
        }
    }
    let mut couplers = Vec::new();
    let mut doubt = None;
    for (document, constraint) in constraints(model) {
        match coupler(document, constraint) {
            Some(coupler) => couplers.push(coupler),
            None => {
                let tree = document.tree();
                doubt = doubt.or_else(|| {
                    Some(PoseFault::Constraint {
                        constraint: tree.attribute(constraint, "name").unwrap_or_default().into_owned(),
                        class: tree.name(constraint).to_owned(),
                    })
                });
            }
        }
    }
    let unknown = couple(&mut values, &couplers);
    for dependent in unknown {
        // Its joint says that it has no value.
        values.remove(&dependent);
    }
    (values, doubt)
}

/// The names of the coordinates that an enforced coupler makes depend on another.
pub(crate) fn dependent_coordinates(model: &Model) -> HashSet<String> {
    let couplers = constraints(model).into_iter().filter_map(|(document, id)| coupler(document, id));
    couplers.map(|coupler| coupler.dependent).collect()
}

/// The value at time 0 of a coordinate that is prescribed: `Some(None)` where its function is not known.
fn prescribed(document: &Document, coordinate: ElementId) -> Option<Option<f64>> {
    let function = prescribing(document, coordinate)?;
    Some(document.function_value(function, 0.0))
}

/// The function that prescribes a coordinate, if one does.
fn prescribing(document: &Document, coordinate: ElementId) -> Option<ElementId> {
    let is_prescribed = matches!(document.flag(coordinate, "prescribed"), Ok(Some(true)));
    let tree = document.tree();
    let function = tree.children(tree.child(coordinate, "prescribed_function")?).next()?;
    is_prescribed.then_some(function)
}

/// Whether a function of time sets a coordinate.
pub(crate) fn is_prescribed(document: &Document, coordinate: ElementId) -> bool {
    prescribing(document, coordinate).is_some()
}

/// Enforced constraints of all files of the model.
fn constraints(model: &Model) -> Vec<(&Document, ElementId)> {
    let files = [FileId::MAIN].into_iter().chain(model.companions().map(|(file, _)| file));
    let mut found = Vec::new();
    for document in files.map(|file| model.file(file)) {
        let tree = document.tree();
        let root = document.data_root();
        let own = (tree.name(root) == "ConstraintSet").then_some(root);
        let set = own.or_else(|| tree.child(root, "ConstraintSet"));
        let members = set.and_then(|set| tree.child(set, "objects"));
        let members = members.into_iter().flat_map(|members| tree.children(members));
        found.extend(members.filter(|&id| is_enforced(document, id)).map(|id| (document, id)));
    }
    found
}

fn is_enforced(document: &Document, constraint: ElementId) -> bool {
    if document.version() >= ENFORCED {
        return !matches!(document.flag(constraint, "isEnforced"), Ok(Some(false)));
    }
    let tree = document.tree();
    let disabled = tree.child(constraint, "isDisabled").map(|flag| tree.text_of(flag));
    !disabled.is_some_and(|text| opensim_text::is_disabled(&text))
}

fn coupler(document: &Document, constraint: ElementId) -> Option<Coupler<'_>> {
    let tree = document.tree();
    if tree.name(constraint) != "CoordinateCouplerConstraint" {
        return None;
    }
    let text = |tag| tree.child(constraint, tag).map(|child| tree.text_of(child)).unwrap_or_default();
    let (independent, dependent) = (text("independent_coordinate_names"), text("dependent_coordinate_name"));
    let [independent] = opensim_text::list(&independent).collect::<Vec<_>>()[..] else { return None };
    let function = tree.children(tree.child(constraint, "coupled_coordinates_function")?).next()?;
    // OpenSim moves the other coordinate then.
    if tree.name(function) == "Constant" {
        return None;
    }
    let factor = opensim_text::numbers(&text("scale_factor")).and_then(|values| values.first().copied());
    Some(Coupler {
        document,
        function,
        factor: factor.unwrap_or(1.0),
        independent: independent.to_owned(),
        dependent: opensim_text::trimmed(&dependent).to_owned(),
    })
}

/// Sets dependent coordinates to the values that follow. Returns the names of those whose values are not known.
fn couple(values: &mut HashMap<String, f64>, couplers: &[Coupler<'_>]) -> Vec<String> {
    let mut unknown = Vec::new();
    for pass in 0..PASSES {
        let mut changed = false;
        for coupler in couplers {
            let Some(&independent) = values.get(&coupler.independent) else { continue };
            let Some(value) = coupler.document.function_value(coupler.function, independent) else {
                if pass == 0 {
                    unknown.push(coupler.dependent.clone());
                }
                continue;
            };
            let value = coupler.factor * value;
            if let Some(dependent) = values.get_mut(&coupler.dependent)
                && (*dependent - value).abs() > ASSEMBLED
            {
                *dependent = value;
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
    unknown
}
