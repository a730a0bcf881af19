//! The values of coordinates at the default pose, from default values and constraints; and whether each coordinate can move.

use foldhash::{HashMap, HashMapExt, HashSet};

use super::fault::PoseFault;
use crate::model::{CoordinateFunction, Document, ElementId, FileId, JointCoordinate, Model, ModelJoint};
use crate::xml::opensim_text;

/// OpenSim does not change a coordinate that is this close to the value that a constraint gives.
const ASSEMBLY_TOLERANCE: f64 = 1e-10;
/// Constraints can depend on each other: they are applied at most this many times.
const MOST_COUPLER_PASSES: usize = 8;
/// The first document version with the element `isEnforced`; older documents have `isDisabled`.
const FIRST_VERSION_WITH_IS_ENFORCED: u32 = 30509;

/// A coordinate whose value is a function of another coordinate, by an enforced `CoordinateCouplerConstraint`.
#[derive(Debug, Clone, PartialEq)]
pub struct Coupler {
    /// The coordinate that determines the dependent coordinate.
    pub independent: String,
    pub dependent: String,
    factor: f64,
    /// The function; `None` if its class is not supported.
    function: Option<CoordinateFunction>,
}

impl Coupler {
    /// The value of the dependent coordinate for this value of the independent one, and the derivative of the function there; `None` if the
    /// function is not supported.
    pub fn value_and_slope(&self, independent: f64) -> Option<(f64, f64)> {
        let function = self.function.as_ref()?;
        Some((self.factor * function.value(independent), self.factor * function.slope(independent)))
    }
}

/// The enforced constraints of a model that make one coordinate a function of another.
#[derive(Debug, Clone, PartialEq)]
pub struct Couplers {
    /// The constraints that can be computed, in file order.
    pub couplers: Vec<Coupler>,
    /// The enforced constraints that this program cannot compute.
    pub unknown: Vec<PoseFault>,
}

impl Couplers {
    /// Reads the coupler constraints of `model`.
    pub fn of(model: &Model) -> Self {
        let mut couplers = Self { couplers: Vec::new(), unknown: Vec::new() };
        for (document, constraint) in enforced_constraints(model) {
            match read_coupler(document, constraint) {
                Some(coupler) => couplers.couplers.push(coupler),
                None => {
                    let tree = document.tree();
                    couplers.unknown.push(PoseFault::Constraint {
                        constraint: tree.attribute(constraint, "name").unwrap_or_default().into_owned(),
                        class: tree.name(constraint).to_owned(),
                    });
                }
            }
        }
        couplers
    }
}

/// The values of all coordinates of a model at the default pose.
pub(crate) struct CoordinateValues {
    /// The known values of coordinates by name, rad or m.
    pub(crate) values: HashMap<String, f64>,
    /// The first constraint that cannot be computed: it may move the bodies elsewhere.
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
            let value = match prescribed_function(document, coordinate.element) {
                Some(function) => function.map(|function| function.value(0.0)),
                None => coordinate.default,
            };
            if let Some(value) = value {
                values.entry(coordinate.name.clone()).or_insert(value);
            }
        }
    }
    let couplers = Couplers::of(model);
    let doubt = couplers.unknown.first().cloned();
    for dependent in apply_couplers(&mut values, &couplers.couplers) {
        // Its joint says that it has no value.
        values.remove(&dependent);
    }
    CoordinateValues { values, doubt }
}

/// The function of time that prescribes a coordinate; `None` if the coordinate is not prescribed, `Some(None)` if the function is not
/// supported.
pub fn prescribed_function(document: &Document, coordinate: ElementId) -> Option<Option<CoordinateFunction>> {
    Some(CoordinateFunction::read(document, prescribing_element(document, coordinate)?))
}

/// The element of the function that prescribes a coordinate.
fn prescribing_element(document: &Document, coordinate: ElementId) -> Option<ElementId> {
    let is_prescribed = matches!(document.flag(coordinate, "prescribed"), Ok(Some(true)));
    let tree = document.tree();
    let function = tree.children(tree.child(coordinate, "prescribed_function")?).next()?;
    is_prescribed.then_some(function)
}

/// The enforced constraints in all files of the model.
fn enforced_constraints(model: &Model) -> Vec<(&Document, ElementId)> {
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

pub(super) fn is_enforced(document: &Document, constraint: ElementId) -> bool {
    if document.version() >= FIRST_VERSION_WITH_IS_ENFORCED {
        return !matches!(document.flag(constraint, "isEnforced"), Ok(Some(false)));
    }
    let tree = document.tree();
    let disabled = tree.child(constraint, "isDisabled").map(|flag| tree.text_of(flag));
    !disabled.is_some_and(|text| opensim_text::is_disabled(&text))
}

fn read_coupler(document: &Document, constraint: ElementId) -> Option<Coupler> {
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

/// Sets each dependent coordinate to the value of its function. Returns the names of dependent coordinates whose function is not supported.
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

/// Whether a coordinate can change, or what fixes it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CoordinateState {
    /// Neither a lock, a coupler nor a function fixes the value of the coordinate.
    Free,
    Locked,
    /// A function of time or another coordinate determines the value.
    Driven,
}

/// Finds for each coordinate of a model whether it is free, locked or determined by something else.
pub(crate) struct CoordinateStates<'m> {
    model: &'m Model,
    dependent: HashSet<String>,
}

impl<'m> CoordinateStates<'m> {
    /// Finds which coordinates of `model` couplers determine.
    pub(crate) fn of(model: &'m Model) -> Self {
        let couplers = Couplers::of(model).couplers.into_iter();
        Self { model, dependent: couplers.map(|coupler| coupler.dependent).collect() }
    }

    pub(crate) fn state_of(&self, joint: &ModelJoint, coordinate: &JointCoordinate) -> CoordinateState {
        let document = self.model.file(joint.file);
        if matches!(document.flag(coordinate.element, "locked"), Ok(Some(true))) {
            CoordinateState::Locked
        } else if self.dependent.contains(&coordinate.name)
            || prescribing_element(document, coordinate.element).is_some()
        {
            CoordinateState::Driven
        } else {
            CoordinateState::Free
        }
    }
}
