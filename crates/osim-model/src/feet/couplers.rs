//! Values of coordinates at the default pose: their defaults, or what constraints make of them; and whether each is free.

use foldhash::{HashMap, HashMapExt, HashSet};

use super::fault::PoseFault;
use crate::model::{CoordinateFunction, Document, ElementId, FileId, JointCoordinate, Model, ModelJoint};
use crate::xml::opensim_text;

/// OpenSim leaves coordinates that are this close to what a constraint says.
const ASSEMBLY_TOLERANCE: f64 = 1e-10;
/// How often constraints that depend on each other are followed, at most.
const MOST_COUPLER_PASSES: usize = 8;
/// The first version in which a constraint says whether it is enforced, not whether it is disabled.
const FIRST_WITH_IS_ENFORCED: u32 = 30509;

/// A coordinate that an enforced CoordinateCouplerConstraint makes a function of another one.
#[derive(Debug, Clone, PartialEq)]
pub struct Coupler {
    /// The coordinate that determines the dependent one.
    pub independent: String,
    pub dependent: String,
    factor: f64,
    /// `None` for one that is not known.
    function: Option<CoordinateFunction>,
}

impl Coupler {
    /// The dependent coordinate where the independent one has this value, and by how much it changes with it; `None` where the
    /// function is not known.
    pub fn value_and_slope(&self, independent: f64) -> Option<(f64, f64)> {
        let function = self.function.as_ref()?;
        Some((self.factor * function.value(independent), self.factor * function.slope(independent)))
    }
}

/// The enforced constraints of a model that make coordinates functions of others.
#[derive(Debug, Clone, PartialEq)]
pub struct Couplers {
    /// Coordinates that are functions of others, in file order.
    pub couplers: Vec<Coupler>,
    /// Constraints that this program cannot evaluate.
    pub unknown: Vec<PoseFault>,
}

impl Couplers {
    pub fn of(model: &Model) -> Self {
        let mut couplers = Self { couplers: Vec::new(), unknown: Vec::new() };
        for (document, constraint) in constraints(model) {
            match coupler(document, constraint) {
                Some(coupler) => couplers.couplers.push(coupler),
                None => couplers.unknown.push(unknown_constraint(document, constraint)),
            }
        }
        couplers
    }
}

fn unknown_constraint(document: &Document, constraint: ElementId) -> PoseFault {
    let tree = document.tree();
    PoseFault::Constraint {
        constraint: tree.attribute(constraint, "name").unwrap_or_default().into_owned(),
        class: tree.name(constraint).to_owned(),
    }
}

/// The values of the coordinates of a model at its default pose.
#[derive(Debug)]
pub(crate) struct CoordinateValues {
    /// Values of coordinates that are known, by name, rad or m.
    pub(crate) values: HashMap<String, f64>,
    /// The first constraint that is not understood.
    pub(crate) doubt: Option<PoseFault>,
}

impl CoordinateValues {
    pub(crate) fn at_default_pose(model: &Model) -> &Self {
        model.derived_from_bodies(coordinate_values)
    }
}

fn coordinate_values(model: &Model) -> CoordinateValues {
    let mut values = HashMap::new();
    for joint in model.joints() {
        let document = model.file(joint.file);
        for coordinate in &joint.coordinates {
            let value = prescribed_value(document, coordinate.element).unwrap_or(coordinate.default);
            if let Some(value) = value {
                values.entry(coordinate.name.clone()).or_insert(value);
            }
        }
    }
    let couplers = Couplers::of(model);
    let doubt = couplers.unknown.first().cloned();
    let unknown = apply_couplers(&mut values, &couplers.couplers);
    for dependent in unknown {
        // Its joint says that it has no value.
        values.remove(&dependent);
    }
    CoordinateValues { values, doubt }
}

/// The names of the coordinates that an enforced coupler makes depend on another.
fn dependent_coordinates(model: &Model) -> HashSet<String> {
    let couplers = constraints(model).into_iter().filter_map(|(document, id)| coupler(document, id));
    couplers.map(|coupler| coupler.dependent).collect()
}

/// The value at time 0 of a coordinate that is prescribed: `Some(None)` where its function is not known.
fn prescribed_value(document: &Document, coordinate: ElementId) -> Option<Option<f64>> {
    Some(prescribed_function(document, coordinate)?.map(|function| function.value(0.0)))
}

/// The function of time that sets a coordinate, if one does: `Some(None)` for a function that is not known.
pub fn prescribed_function(document: &Document, coordinate: ElementId) -> Option<Option<CoordinateFunction>> {
    Some(CoordinateFunction::read(document, prescribing_element(document, coordinate)?))
}

/// The function that prescribes a coordinate, if one does.
fn prescribing_element(document: &Document, coordinate: ElementId) -> Option<ElementId> {
    let is_prescribed = matches!(document.flag(coordinate, "prescribed"), Ok(Some(true)));
    let tree = document.tree();
    let function = tree.children(tree.child(coordinate, "prescribed_function")?).next()?;
    is_prescribed.then_some(function)
}

/// Whether a function of time sets a coordinate.
fn is_prescribed(document: &Document, coordinate: ElementId) -> bool {
    prescribing_element(document, coordinate).is_some()
}

/// Enforced constraints of all files of the model.
fn constraints(model: &Model) -> Vec<(&Document, ElementId)> {
    let files = [FileId::MAIN].into_iter().chain(model.companions().map(|(file, _)| file));
    let mut enforced = Vec::new();
    for document in files.map(|file| model.file(file)) {
        let tree = document.tree();
        let root = document.data_root();
        let standalone_set = (tree.name(root) == "ConstraintSet").then_some(root);
        let set = standalone_set.or_else(|| tree.child(root, "ConstraintSet"));
        let members = set.and_then(|set| tree.child(set, "objects"));
        let members = members.into_iter().flat_map(|members| tree.children(members));
        enforced.extend(members.filter(|&id| is_enforced(document, id)).map(|id| (document, id)));
    }
    enforced
}

fn is_enforced(document: &Document, constraint: ElementId) -> bool {
    if document.version() >= FIRST_WITH_IS_ENFORCED {
        return !matches!(document.flag(constraint, "isEnforced"), Ok(Some(false)));
    }
    let tree = document.tree();
    let disabled = tree.child(constraint, "isDisabled").map(|flag| tree.text_of(flag));
    !disabled.is_some_and(|text| opensim_text::is_disabled(&text))
}

fn coupler(document: &Document, constraint: ElementId) -> Option<Coupler> {
    let tree = document.tree();
    if tree.name(constraint) != "CoordinateCouplerConstraint" {
        return None;
    }
    let text = |tag| tree.child(constraint, tag).map(|child| tree.text_of(child)).unwrap_or_default();
    let (independent, dependent) = (text("independent_coordinate_names"), text("dependent_coordinate_name"));
    let [independent] = opensim_text::list_words(&independent).collect::<Vec<_>>()[..] else { return None };
    let function = tree.children(tree.child(constraint, "coupled_coordinates_function")?).next()?;
    // OpenSim moves the other coordinate then.
    if tree.name(function) == "Constant" {
        return None;
    }
    let factor = opensim_text::numbers(&text("scale_factor")).and_then(|values| values.first().copied());
    Some(Coupler {
        function: CoordinateFunction::read(document, function),
        factor: factor.unwrap_or(1.0),
        independent: independent.to_owned(),
        dependent: opensim_text::trimmed(&dependent).to_owned(),
    })
}

/// Sets dependent coordinates to the values that follow. Returns the names of those whose values are not known.
fn apply_couplers(values: &mut HashMap<String, f64>, couplers: &[Coupler]) -> Vec<String> {
    let mut unknown = Vec::new();
    for pass in 0..MOST_COUPLER_PASSES {
        let mut changed = false;
        for coupler in couplers {
            let Some(&independent) = values.get(&coupler.independent) else { continue };
            let Some((value, _)) = coupler.value_and_slope(independent) else {
                if pass == 0 {
                    unknown.push(coupler.dependent.clone());
                }
                continue;
            };
            if let Some(dependent) = values.get_mut(&coupler.dependent)
                && (*dependent - value).abs() > ASSEMBLY_TOLERANCE
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

// Whether a coordinate is free, locked or driven.

/// Whether a coordinate can change, and if not, why.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CoordinateState {
    /// Nothing fixes the coordinate.
    Free,
    Locked,
    /// A function of time, or another coordinate, sets it.
    Driven,
}

/// Finds the states of the coordinates of a model.
pub(crate) struct CoordinateStates<'m> {
    model: &'m Model,
    dependent: HashSet<String>,
}

impl<'m> CoordinateStates<'m> {
    pub(crate) fn of(model: &'m Model) -> Self {
        Self { model, dependent: dependent_coordinates(model) }
    }

    pub(crate) fn state(&self, joint: &ModelJoint, coordinate: &JointCoordinate) -> CoordinateState {
        let document = self.model.file(joint.file);
        if matches!(document.flag(coordinate.element, "locked"), Ok(Some(true))) {
            CoordinateState::Locked
        } else if self.dependent.contains(&coordinate.name) || is_prescribed(document, coordinate.element) {
            CoordinateState::Driven
        } else {
            CoordinateState::Free
        }
    }
}
