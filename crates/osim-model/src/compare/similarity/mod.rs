//! Compares numbers of a model that should change with body size, such as muscle forces: the factor that geometric similarity expects, and
//! the factor by which each number changed. Also the bounds in an optimisation problem of OpenSim Moco whose units contain length or
//! time.

mod ratios;

use std::collections::{BTreeSet, HashMap};

use crate::model::{
    BoneLengths, Document, ElementId, Fault, MassRequest, Model, NotRead, Result, SizedKind, SizedValue,
    SizedValues, opensim_text,
};
use ratios::SAME_NUMBER_TOLERANCE;

pub use ratios::{SizeRatios, SizeVerdict, Spread, similarity_formula};

/// What the ratio of lengths of two models was computed from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LengthFrom {
    /// From the distances between joints, summed over this many bodies.
    Joints(usize),
    /// From the cube root of the ratio of masses.
    Mass,
}

/// The factors by which the numbers of one kind changed.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedFactors {
    /// Number of values that both models have.
    pub pairs: usize,
    /// Number of values that are equal in both models, also values of 0.
    pub same: usize,
    /// Median and range of the factors. Values of 0 in the original have no factor; `None` if no value has one.
    pub factors: Option<Spread>,
}

/// The numbers of one kind in a model, beside the factor that geometric similarity expects.
#[derive(Debug, Clone, PartialEq)]
pub struct SimilarityRow {
    pub kind: SizedKind,
    pub count: usize,
    /// Median and range of the numbers, in the unit of their kind.
    pub values: Spread,
    /// The factor that geometric similarity expects; `None` if the masses are not known.
    pub similar: Option<f64>,
    /// The factors by which the numbers changed; `None` without an original model.
    pub compared: Option<ComparedFactors>,
    /// Whether the numbers changed as similarity expects; `None` without an original model.
    pub verdict: Option<SizeVerdict>,
}

/// Numbers of a model that should change with body size, their factors of change, and the factors that similarity expects.
#[derive(Debug, Clone, PartialEq)]
pub struct Similarity {
    /// The masses of the original and of the model, kg. For a planned mass: the masses of the model and of the planned body.
    pub masses_kg: [Option<f64>; 2],
    /// How much larger the second of the two bodies is; `None` if a mass is not known.
    pub ratios: Option<SizeRatios>,
    pub length_from: LengthFrom,
    /// One row for each kind of number in the model.
    pub rows: Vec<SimilarityRow>,
    /// Names of objects whose numbers are in the model and not in the original.
    pub only_in_model: Vec<String>,
    pub only_in_original: Vec<String>,
    pub not_read: Vec<NotRead>,
}

impl Similarity {
    /// Compares `model` with its `original`. Two numbers are compared if they have the same kind and the names of their objects are equal.
    pub fn between(model: &ModelSize, original: &ModelSize) -> Self {
        let length = model.joint_distances.ratio_to(&original.joint_distances);
        let length_from = length.map_or(LengthFrom::Mass, |(_, bodies)| LengthFrom::Joints(bodies));
        let ratio = |new: Option<f64>, old: Option<f64>| {
            let ratio = new? / old?;
            (ratio.is_finite() && ratio > 0.0).then_some(ratio)
        };
        let mass = ratio(model.mass_kg, original.mass_kg);
        let gravity = ratio(model.gravity_m_s2, original.gravity_m_s2).unwrap_or(1.0);
        let length = |mass: f64| length.map_or_else(|| libm::cbrt(mass), |(ratio, _)| ratio);
        let ratios = mass.map(|mass| SizeRatios { mass, length: length(mass), gravity });
        let others = values_by_identity(&original.values.values);
        let rows = similarity_rows(model, ratios, |values| Some(compared_with_original(values, &others)));
        let owners = |size: &ModelSize| -> BTreeSet<String> {
            let in_model = size.values.values.iter().filter(|one| !one.kind.is_of_moco());
            in_model.map(|one| one.owner.clone()).collect()
        };
        let (here, there) = (owners(model), owners(original));
        Self {
            masses_kg: [original.mass_kg, model.mass_kg],
            ratios,
            length_from,
            rows,
            only_in_model: here.difference(&there).cloned().collect(),
            only_in_original: there.difference(&here).cloned().collect(),
            not_read: model.values.not_read.clone(),
        }
    }

    /// The factors for a body of `target_mass_kg` with the same shape as `model`: lengths grow with the cube root of the mass.
    pub fn at_mass(model: &ModelSize, target_mass_kg: f64) -> Self {
        let mass =
            model.mass_kg.map(|kg| target_mass_kg / kg).filter(|ratio| ratio.is_finite() && *ratio > 0.0);
        let ratios = mass.map(|mass| SizeRatios { mass, length: libm::cbrt(mass), gravity: 1.0 });
        Self {
            masses_kg: [model.mass_kg, Some(target_mass_kg)],
            ratios,
            length_from: LengthFrom::Mass,
            rows: similarity_rows(model, ratios, |_| None),
            only_in_model: Vec::new(),
            only_in_original: Vec::new(),
            not_read: model.values.not_read.clone(),
        }
    }
}

type NumberIdentity<'v> = (SizedKind, &'v str, (&'static str, usize));

fn values_by_identity(values: &[SizedValue]) -> HashMap<NumberIdentity<'_>, f64> {
    let mut value_by_identity = HashMap::new();
    for one in values {
        // Of two objects of one name the first counts, as for OpenSim.
        value_by_identity.entry((one.kind, one.owner.as_str(), one.part)).or_insert(one.value);
    }
    value_by_identity
}

fn similarity_rows(
    model: &ModelSize,
    ratios: Option<SizeRatios>,
    compare: impl Fn(&[&SizedValue]) -> Option<(ComparedFactors, Vec<f64>)>,
) -> Vec<SimilarityRow> {
    let mut by_kind: Vec<Vec<&SizedValue>> = vec![Vec::new(); SizedKind::ALL.len()];
    for one in &model.values.values {
        if let Some(of_kind) = by_kind.get_mut(one.kind.order()) {
            of_kind.push(one);
        }
    }
    let row = |(kind, values): (&SizedKind, Vec<&SizedValue>)| {
        let similar =
            ratios.map(|ratios| ratios.factor(kind.dimension())).filter(|factor| factor.is_finite());
        let found = compare(&values);
        let changed = |(compared, factors): &(ComparedFactors, Vec<f64>)| {
            let same = factors.iter().filter(|&&factor| is_unchanged(factor)).count();
            match (compared.pairs, compared.pairs - compared.same) {
                (1.., 0) if factors.is_empty() => SizeVerdict::Undecided,
                (_, 1..) if factors.is_empty() => SizeVerdict::Other,
                _ => SizeVerdict::of(factors, same, similar),
            }
        };
        Some(SimilarityRow {
            kind: *kind,
            count: values.len(),
            values: Spread::of(values.iter().map(|one| one.value))?,
            similar,
            verdict: found.as_ref().map(changed),
            compared: found.map(|(compared, _)| compared),
        })
    };
    SizedKind::ALL.iter().zip(by_kind).filter_map(row).collect()
}

fn is_unchanged(factor: f64) -> bool {
    (factor - 1.0).abs() <= SAME_NUMBER_TOLERANCE
}

/// Compares `values` with the `others`, the numbers of the original. Returns a summary and each factor.
fn compared_with_original(
    values: &[&SizedValue],
    others: &HashMap<NumberIdentity<'_>, f64>,
) -> (ComparedFactors, Vec<f64>) {
    let other = |one: &&&SizedValue| others.get(&(one.kind, one.owner.as_str(), one.part)).copied();
    let pairs: Vec<(f64, f64)> = values.iter().filter_map(|one| Some((one.value, other(&one)?))).collect();
    let factors: Vec<f64> = pairs
        .iter()
        .filter(|(_, old)| *old != 0.0)
        .map(|(new, old)| new / old)
        .filter(|factor| factor.is_finite())
        .collect();
    let both_zero = pairs.iter().filter(|(new, old)| *new == 0.0 && *old == 0.0).count();
    let same = factors.iter().filter(|&&factor| is_unchanged(factor)).count() + both_zero;
    let spread = Spread::of(factors.iter().copied());
    (ComparedFactors { pairs: pairs.len(), same, factors: spread }, factors)
}

/// The size of a model: its mass, its gravity, its joint distances, and the numbers that may change with body size.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelSize {
    /// Mass of the model, kg; `None` if it is not known.
    pub mass_kg: Option<f64>,
    /// Gravity of the model, m/s²; `None` if it is not known.
    pub gravity_m_s2: Option<f64>,
    joint_distances: BoneLengths,
    values: SizedValues,
}

impl ModelSize {
    /// The size of `model`, and its numbers that may change with size. `masses` are the masses that the caller gave.
    pub fn of(model: &Model, masses: &MassRequest) -> Self {
        Self {
            mass_kg: masses.model_mass(model).ok().map(|mass| mass.kg),
            gravity_m_s2: model.gravity().filter(|gravity| *gravity > 0.0),
            joint_distances: model.joint_distances().clone(),
            values: SizedValues::of(model),
        }
    }

    pub fn with_values(mut self, more: SizedValues) -> Self {
        self.values.values.extend(more.values);
        self.values.not_read.extend(more.not_read);
        self
    }
}

/// Reads the bounds in a setup file of Moco (`.omoco`): of time, and of the values and speeds of coordinates. `model` says which
/// coordinates are angles. Activations, controls and normalised tendon forces have no unit and are left out.
pub fn moco_bounds(setup: &Document, model: &Model) -> SizedValues {
    let tree = setup.tree();
    let angles = model.coordinates_are_angles();
    let (mut found, mut phases) = (SizedValues::default(), 0_usize);
    let mut patterns = 0_usize;
    tree.walk(setup.data_root(), |id| {
        match tree.name(id) {
            "MocoPhase" => phases += 1,
            // The problem has its model in it.
            "ModelProcessor" => return false,
            "MocoInitialBounds" | "MocoFinalBounds" => {
                let name = tree.attribute(id, "name").unwrap_or_default();
                if let Some(part) =
                    ["time_initial_bounds", "time_final_bounds"].into_iter().find(|one| *one == name)
                {
                    let owner = format!("phase {phases}");
                    push_bounds(&mut found, setup, id, ("bounds", part), SizedKind::MocoTime, &owner);
                }
            }
            "MocoVariableInfo" => {
                let list = tree.parent(id).map(|list| tree.name(list)).unwrap_or_default();
                let name = tree.attribute(id, "name").unwrap_or_default();
                match list {
                    "state_infos" => {
                        if let Some(kind) = state_kind(&name, &angles) {
                            let owner = format!("phase {phases} {name}");
                            for part in ["bounds", "initial_bounds", "final_bounds"] {
                                push_bounds(&mut found, setup, id, (part, part), kind, &owner);
                            }
                        }
                    }
                    "state_infos_pattern" => patterns += 1,
                    _ => {}
                }
            }
            _ => {}
        }
        true
    });
    if patterns > 0 {
        found.not_read.push(NotRead::new("state_infos_pattern", patterns, "states of several dimensions"));
    }
    found
}

pub fn refuse_without_moco_phase(setup: &Document) -> Result<()> {
    let tree = setup.tree();
    if tree.elements().any(|id| tree.name(id) == "MocoPhase") {
        return Ok(());
    }
    let tag = tree.name(setup.data_root());
    Err(Fault::refused(format!("the document holds a {tag}, expected a MocoStudy with a MocoPhase")))
}

/// The kind of number that a bound of a state has: the state's path names the value or the speed of a coordinate.
fn state_kind(path: &str, angles: &HashMap<&str, Option<bool>>) -> Option<SizedKind> {
    let mut segments = path.rsplit('/');
    let (what, coordinate) = (segments.next()?, segments.next()?);
    let is_angle = angles.get(coordinate).copied().flatten()?;
    match (what, is_angle) {
        ("value", false) => Some(SizedKind::MocoTranslation),
        ("speed", false) => Some(SizedKind::MocoSpeed),
        ("speed", true) => Some(SizedKind::MocoAngularSpeed),
        _ => None,
    }
}

fn push_bounds(
    found: &mut SizedValues,
    setup: &Document,
    owner: ElementId,
    (tag, part): (&str, &'static str),
    kind: SizedKind,
    name: &str,
) {
    let tree = setup.tree();
    let text = tree.child(owner, tag).map(|element| tree.text_of(element)).unwrap_or_default();
    let numbers = opensim_text::numbers(&text).unwrap_or_default();
    // One number is both bounds.
    for (place, value) in numbers.into_iter().take(2).enumerate().filter(|(_, value)| value.is_finite()) {
        found.values.push(SizedValue { kind, owner: name.to_owned(), part: (part, place), value });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{MassRequest, Model};

    /// A model of a thigh and a shank, joined at the knee, with a muscle, a spring on the knee, and a limit that is 0.
    fn sizes_of_leg(masses: [f64; 2], thigh_m: f64, force: f64, fiber: f64, more: &str) -> ModelSize {
        let text = format!(
            r#"<OpenSimDocument Version="40000"><Model><BodySet><objects>
        <Body name="thigh"><mass>{}</mass></Body><Body name="shank"><mass>{}</mass></Body></objects></BodySet>
        <JointSet><objects>
        <PinJoint name="hip"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/thigh</socket_child_frame></PinJoint>
        <PinJoint name="knee"><socket_parent_frame>low</socket_parent_frame><socket_child_frame>/bodyset/shank</socket_child_frame>
        <coordinates><Coordinate name="knee_angle"/></coordinates>
        <frames><PhysicalOffsetFrame name="low"><socket_parent>/bodyset/thigh</socket_parent>
        <translation>0 -{thigh_m} 0</translation></PhysicalOffsetFrame></frames></PinJoint>
        <PinJoint name="patella"><socket_parent_frame>/bodyset/thigh</socket_parent_frame><socket_child_frame>/bodyset/shank</socket_child_frame></PinJoint>
        </objects></JointSet><ForceSet><objects><Thelen2003Muscle name="vasti">
        <max_isometric_force>{force}</max_isometric_force><optimal_fiber_length>{fiber}</optimal_fiber_length></Thelen2003Muscle>
        <CoordinateLimitForce name="limit"><coordinate>knee_angle</coordinate><damping>0</damping></CoordinateLimitForce>
        {more}</objects></ForceSet></Model></OpenSimDocument>"#,
            masses[0], masses[1]
        );
        ModelSize::of(&Model::parse(text).unwrap(), &MassRequest::default())
    }

    fn row_of_kind(found: &Similarity, kind: SizedKind) -> &SimilarityRow {
        found.rows.iter().find(|row| row.kind == kind).unwrap()
    }

    /// 2 kg and 1 kg become 16 kg and 8 kg, M = 24/3 = 8; the thigh of 0.4 m becomes 0.8 m long, L = 2. The force was made 4 times as
    /// large, as areas grow, and fibers twice as long: similarity expects 8 for the force and 2 for the fibers.
    #[test]
    fn factors_verdicts_and_names_without_a_counterpart() {
        let old = sizes_of_leg([2.0, 1.0], 0.4, 1000.0, 0.1, "<Thelen2003Muscle name='gone'/>");
        let new = sizes_of_leg([16.0, 8.0], 0.8, 4000.0, 0.2, "<PathActuator name='come'/>");
        let found = Similarity::between(&new, &old);
        let ratios = found.ratios.unwrap();
        assert_eq!((ratios.mass, ratios.length, found.length_from), (8.0, 2.0, LengthFrom::Joints(1)));
        let of = |kind| {
            let row = row_of_kind(&found, kind);
            (
                row.similar.unwrap(),
                row.compared.clone().unwrap().factors.map(|one| one.median),
                row.verdict.unwrap(),
            )
        };
        assert_eq!(of(SizedKind::MaxIsometricForce), (8.0, Some(4.0), SizeVerdict::Other));
        assert_eq!(of(SizedKind::OptimalFiberLength), (2.0, Some(2.0), SizeVerdict::Follows));
        assert_eq!(of(SizedKind::ActivationTime), (2.0_f64.sqrt(), Some(1.0), SizeVerdict::Left));
        // N m s = M L^(3/2) = 8 · 2.83; it is 0 in both.
        let (similar, factor, verdict) = of(SizedKind::LimitRotationalDamping);
        assert!((similar - 8.0 * 2.0_f64.powf(1.5)).abs() < 1e-12);
        assert_eq!((factor, verdict), (None, SizeVerdict::Undecided));
        assert_eq!(of(SizedKind::ActuatorForce).2, SizeVerdict::NotCompared);
        assert_eq!(
            (found.only_in_model, found.only_in_original),
            (vec!["come".to_owned()], vec!["gone".to_owned()])
        );
    }

    /// A body with an eighth of the mass is half as long: fiber lengths change by 0.5, times by √0.5.
    #[test]
    fn a_target_mass_gives_expected_factors() {
        let found = Similarity::at_mass(&sizes_of_leg([2.0, 1.0], 0.4, 1000.0, 0.1, ""), 3.0 / 8.0);
        assert!((row_of_kind(&found, SizedKind::OptimalFiberLength).similar.unwrap() - 0.5).abs() < 1e-15);
        assert!(
            (row_of_kind(&found, SizedKind::ActivationTime).similar.unwrap() - 0.5_f64.sqrt()).abs() < 1e-15
        );
        assert!(found.rows.iter().all(|row| row.verdict.is_none() && row.compared.is_none()));
        // Its bodies have no mass: there is no ratio, and the numbers are listed all the same.
        let unknown = Similarity::at_mass(&sizes_of_leg([0.0, 0.0], 0.4, 1000.0, 0.1, ""), 3.0);
        assert_eq!(
            (unknown.ratios, row_of_kind(&unknown, SizedKind::MaxIsometricForce).similar),
            (None, None)
        );
    }

    #[test]
    fn a_change_from_zero_does_not_follow_similarity() {
        let spring = |stiffness: &str| {
            let spring = format!(
                "<PointToPointSpring name='s'><stiffness>{stiffness}</stiffness></PointToPointSpring>"
            );
            sizes_of_leg([2.0, 1.0], 0.4, 1000.0, 0.1, &spring)
        };
        let mut new = spring("5");
        new.mass_kg = Some(24.0);
        let found = Similarity::between(&new, &spring("0"));
        assert_eq!(row_of_kind(&found, SizedKind::SpringStiffness).verdict, Some(SizeVerdict::Other));
        // Numbers in six digits are the same.
        let found = Similarity::between(&new, &spring("5.000001"));
        assert_eq!(row_of_kind(&found, SizedKind::SpringStiffness).verdict, Some(SizeVerdict::Left));
    }

    const MODEL: &str = r#"<OpenSimDocument Version="40000"><Model><BodySet><objects><Body name="b"><mass>1</mass></Body></objects></BodySet>
        <JointSet><objects><PlanarJoint name="j"><socket_parent_frame>/ground</socket_parent_frame>
        <socket_child_frame>/bodyset/b</socket_child_frame><coordinates><Coordinate name="turn"/><Coordinate name="x"/>
        <Coordinate name="y"/></coordinates></PlanarJoint></objects></JointSet></Model></OpenSimDocument>"#;
    // The elements are those that `MocoStudy.printToXML` of OpenSim 4.6 writes; the model in it has a state of its own name.
    const SETUP: &str = r#"<OpenSimDocument Version="40600"><MocoStudy><MocoProblem name="problem"><MocoPhase name="phases">
        <ModelProcessor name="model"><model><MocoVariableInfo name="/jointset/j/y/value"><bounds>9 9</bounds></MocoVariableInfo></model></ModelProcessor>
        <MocoInitialBounds name="time_initial_bounds"><bounds>0</bounds></MocoInitialBounds>
        <MocoFinalBounds name="time_final_bounds"><bounds>0.4 0.6</bounds></MocoFinalBounds>
        <state_infos>
            <MocoVariableInfo name="/jointset/j/turn/value"><bounds>-1 1</bounds></MocoVariableInfo>
            <MocoVariableInfo name="/jointset/j/turn/speed"><bounds>-20 20</bounds></MocoVariableInfo>
            <MocoVariableInfo name="/jointset/j/y/value"><bounds>0.8 1.1</bounds><initial_bounds>0.9</initial_bounds></MocoVariableInfo>
            <MocoVariableInfo name="/jointset/j/x/speed"><bounds>0 2</bounds></MocoVariableInfo>
            <MocoVariableInfo name="/forceset/vasti/activation"><bounds>0 1</bounds></MocoVariableInfo>
        </state_infos>
        <state_infos_pattern><MocoVariableInfo name="/jointset/.*/speed"><bounds>-30 30</bounds></MocoVariableInfo></state_infos_pattern>
        <control_infos><MocoVariableInfo name="/y/value"><bounds>-50 50</bounds></MocoVariableInfo></control_infos>
        </MocoPhase></MocoProblem></MocoStudy></OpenSimDocument>"#;

    #[test]
    fn bounds_with_a_length_or_a_time_are_read() {
        let setup = Document::parse(SETUP).unwrap();
        let found = moco_bounds(&setup, &Model::parse(MODEL).unwrap());
        let of = |kind| -> Vec<f64> {
            found.values.iter().filter(|one| one.kind == kind).map(|one| one.value).collect()
        };
        assert_eq!(of(SizedKind::MocoTime), [0.0, 0.4, 0.6]);
        assert_eq!(of(SizedKind::MocoTranslation), [0.8, 1.1, 0.9]);
        assert_eq!(of(SizedKind::MocoSpeed), [0.0, 2.0]);
        assert_eq!(of(SizedKind::MocoAngularSpeed), [-20.0, 20.0]);
        assert_eq!(found.values.len(), 10);
        assert_eq!(found.not_read, [NotRead::new("state_infos_pattern", 1, "states of several dimensions")]);
    }

    #[test]
    fn a_document_without_a_problem_is_refused() {
        let model = Document::parse(MODEL).unwrap();
        assert!(refuse_without_moco_phase(&model).unwrap_err().to_string().contains("holds a Model"));
        assert!(refuse_without_moco_phase(&Document::parse(SETUP).unwrap()).is_ok());
    }
}
