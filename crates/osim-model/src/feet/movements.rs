//! How bodies can move against each other, by the free coordinates of joints; and the values of coordinates at the default pose, from
//! default values and constraints.

use std::sync::Arc;

use foldhash::{HashMap, HashMapExt, HashSet};
use glam::DVec3;

use crate::feet::fault::PoseFault;
use crate::model::{
    CoordinateFunction, Document, ElementId, FileId, JointCoordinate, Model, ModelJoint, Placement,
};
use crate::xml::opensim_text;

/// The change of a coordinate, rad or m, that tests how the coordinate moves bodies.
const TRIAL_COORDINATE_STEP: f64 = 0.1;
/// Two rotations or translations are equal if their components differ by at most this.
const EQUAL_MOVEMENT_TOLERANCE: f64 = 1e-9;
/// The largest number of bodies on a path to ground.
const MOST_JOINTS: usize = 64;

/// The relative movements that joints allow between two bodies.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Mobility {
    /// Whether a coordinate turns one of the bodies against the other.
    pub turns: bool,
    /// Whether a coordinate shifts one of the bodies against the other without turning it.
    pub slides: bool,
}

/// The joint above a body: its parent body, and the movements that it allows.
#[derive(Debug, Clone)]
struct JointAbove {
    /// The parent body of the joint; `None` is ground.
    parent: Option<String>,
    mobility: Mobility,
}

/// The possible movements of the bodies of a model. Locked and prescribed coordinates, and those that a coupler constraint determines, are
/// not free. A joint that is not supported counts as free in all directions.
#[derive(Debug, Clone)]
pub struct Movements(Arc<PathsToGround>);

/// The chains of joints from bodies to ground.
#[derive(Debug, Clone)]
struct PathsToGround {
    above: HashMap<String, JointAbove>,
    ends: HashMap<String, PathEnd>,
}

/// The last body on the path from a body to ground, and whether a joint on the path can move.
#[derive(Debug, Clone)]
struct PathEnd {
    /// The last body on the path, which is joined to ground or has no joint above.
    top: String,
    /// Whether a joint on the path can move.
    moves: bool,
}

impl Mobility {
    /// Rotations and translations.
    const ALL: Self = Self { turns: true, slides: true };

    /// Whether any movement is possible.
    pub const fn is_any(self) -> bool {
        self.turns || self.slides
    }

    /// The movements that one or the other allows.
    fn or(self, other: Self) -> Self {
        Self { turns: self.turns || other.turns, slides: self.slides || other.slides }
    }
}

impl Movements {
    /// The movements of the bodies of `model`, which are computed once for each model.
    pub fn of(model: &Model) -> Self {
        Self(Arc::clone(model.derived_from_bodies(|model| Arc::new(PathsToGround::of(model)))))
    }

    /// Whether `body` can move relative to ground.
    pub fn can_move(&self, body: &str) -> bool {
        // A body without a parent moves freely.
        self.0.ends.get(body).is_none_or(|end| end.moves)
    }

    /// The topmost body above `body`; `body` itself if no body is above it.
    pub fn top<'b>(&'b self, body: &'b str) -> &'b str {
        self.0.ends.get(body).map_or(body, |end| end.top.as_str())
    }

    /// The free relative movements of two bodies; `None` if only ground connects them.
    pub fn between(&self, one: &str, other: &str) -> Option<Mobility> {
        let (one, other) = (self.0.path(one), self.0.path(other));
        let (mut here, mut there) = (one.len(), other.len());
        // From the top down, as long as both ways are one.
        while here > 0
            && there > 0
            && one.get(here - 1).map(|path| path.0) == other.get(there - 1).map(|path| path.0)
        {
            here -= 1;
            there -= 1;
        }
        let steps = one.iter().take(here).chain(other.iter().take(there));
        (here < one.len()).then(|| steps.fold(Mobility::default(), |all, (_, mobility)| all.or(*mobility)))
    }
}

impl PathsToGround {
    /// Finds the joint above each body of `model`.
    fn of(model: &Model) -> Self {
        let states = CoordinateStates::of(model);
        let mut above = HashMap::new();
        for joint in model.joints() {
            let (body, parent) = match (&joint.child, &joint.parent) {
                (Some(child), parent) => (child, parent.clone()),
                // A joint written the other way round, from the body to ground.
                (None, Some(body)) => (body, None),
                (None, None) => continue,
            };
            above
                .entry(body.clone())
                .or_insert_with(|| JointAbove { parent, mobility: states.mobility_of(joint) });
        }
        Self { ends: path_ends(&above), above }
    }

    /// `body` and the bodies above it, each with the mobility of the joint above it.
    fn path<'b>(&'b self, body: &'b str) -> Vec<(&'b str, Mobility)> {
        let mut path = Vec::new();
        let mut at = Some(body);
        while let Some(body) = at.filter(|_| path.len() < MOST_JOINTS) {
            let above = self.above.get(body);
            path.push((body, above.map_or(Mobility::ALL, |above| above.mobility)));
            at = above.and_then(|above| above.parent.as_deref());
        }
        path
    }
}

/// The path ends of all joined bodies. Each joint is visited once.
fn path_ends(above: &HashMap<String, JointAbove>) -> HashMap<String, PathEnd> {
    let mut ends: HashMap<String, PathEnd> = HashMap::new();
    for body in above.keys() {
        let (mut path, mut at) = (Vec::new(), Some(body.as_str()));
        // Joints in a circle end where they have all been passed.
        while let Some((name, joint)) = at.and_then(|name| Some((name, above.get(name)?))) {
            if ends.contains_key(name) || path.len() > above.len() {
                break;
            }
            path.push((name, joint.mobility));
            at = joint.parent.as_deref();
        }
        let known = at.and_then(|name| ends.get(name).cloned());
        let last = at.or(path.last().map(|(name, _)| *name)).unwrap_or(body);
        let alone = || PathEnd { top: last.to_owned(), moves: at.is_some() };
        let mut end = known.unwrap_or_else(alone);
        for (name, mobility) in path.into_iter().rev() {
            end.moves |= mobility.is_any();
            ends.insert(name.to_owned(), end.clone());
        }
    }
    ends
}

impl CoordinateStates<'_> {
    /// The movements that the free coordinates of a joint allow.
    fn mobility_of(&self, joint: &ModelJoint) -> Mobility {
        if joint.coordinates.is_empty() {
            return mobility_of_class(&joint.class);
        }
        let known = &CoordinateValues::at_default_pose(self.model).values;
        let own = joint.coordinates.iter().map(|coordinate| known.get(&coordinate.name).copied());
        let Some(values) = own.collect::<Option<Vec<f64>>>() else { return Mobility::ALL };
        let Some(here) = joint.placement(self.model, &values) else { return Mobility::ALL };
        let is_free = |coordinate| self.state_of(joint, coordinate) == CoordinateState::Free;
        let free = joint.coordinates.iter().enumerate().filter(|(_, coordinate)| is_free(coordinate));
        free.fold(Mobility::default(), |all, (index, _)| {
            let mut moved = values.clone();
            moved.iter_mut().skip(index).take(1).for_each(|value| *value += TRIAL_COORDINATE_STEP);
            all.or(joint
                .placement(self.model, &moved)
                .map_or(Mobility::ALL, |there| mobility_between(&here, &there)))
        })
    }
}

/// The mobility of a joint whose coordinates are not in the file, by the joint's class.
fn mobility_of_class(class: &str) -> Mobility {
    match class {
        "WeldJoint" | "CustomJoint" => Mobility::default(),
        "PinJoint" | "UniversalJoint" | "BallJoint" | "GimbalJoint" => {
            Mobility { turns: true, slides: false }
        }
        _ => Mobility::ALL,
    }
}

/// The movements by which two placements differ.
fn mobility_between(here: &Placement, there: &Placement) -> Mobility {
    let differ = |a: DVec3, b: DVec3| (a - b).abs().cmpgt(DVec3::splat(EQUAL_MOVEMENT_TOLERANCE)).any();
    let turned = |axis| differ(here.rotation.to_body(axis), there.rotation.to_body(axis));
    let turns = DVec3::AXES.into_iter().any(turned);
    Mobility { turns, slides: !turns && differ(here.translation_m, there.translation_m) }
}

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
    /// The coupler constraints of `model`, which are read once for all models that share its bodies.
    pub fn of(model: &Model) -> &Self {
        model.derived_from_bodies(Self::read)
    }

    fn read(model: &Model) -> Self {
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
    dependent: HashSet<&'m str>,
}

impl<'m> CoordinateStates<'m> {
    /// Finds which coordinates of `model` couplers determine.
    pub(crate) fn of(model: &'m Model) -> Self {
        let couplers = Couplers::of(model).couplers.iter();
        Self { model, dependent: couplers.map(|coupler| coupler.dependent.as_str()).collect() }
    }

    pub(crate) fn state_of(&self, joint: &ModelJoint, coordinate: &JointCoordinate) -> CoordinateState {
        let document = self.model.file(joint.file);
        if matches!(document.flag(coordinate.element, "locked"), Ok(Some(true))) {
            CoordinateState::Locked
        } else if self.dependent.contains(coordinate.name.as_str())
            || prescribing_element(document, coordinate.element).is_some()
        {
            CoordinateState::Driven
        } else {
            CoordinateState::Free
        }
    }
}
