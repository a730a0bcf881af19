//! Rescales the contacts of a model to another mass: multiplies each parameter by its ratio.

use contact_scaling::{RatioValues, Ratios};
use osim_model::compare::ScaleFile;
use osim_model::messages::{Input, four_significant, readable};
use osim_model::{
    DissipationBy, Fault, GravityFor, LevelAxis, Mass, MissingFact, Model, Property, PropertySet, RadiusRule,
    Result, Selected, is_at_target, positive_mass,
};

use crate::builder::{NewNumber, PlanBuilder};
use crate::change::{GravityChange, property_factor};
use crate::new_radii::{Radii, SphereRadiusRule};
use crate::note_edits::NotedMass;
use crate::plan::{Masses, NoteFacts, Plan};
use crate::rules::{self, warn_forces};

/// The note's name for a rescaling that moved spheres with their bodies by a `ScaleSet`.
pub const OPERATION_FOLLOWING_SCALE_FILE: &str = "rescale body-scale-file";
/// The note's name for a rescaling that moved spheres with their bodies by the body sizes in the note.
pub const OPERATION_FOLLOWING_NOTE: &str = "rescale follow-bodies";
/// The note's name for a transfer whose spheres move with their bodies.
pub const OPERATION_FOLLOWING_BODIES: &str = "transfer follow-bodies";

/// The options of a rescaling of a model's contacts to another mass.
///
/// ```
/// use osim_model::{MassRequest, Model, Property, Selection};
/// use osim_model::RadiusRule;
/// use osim_patch::{Rescale, rescale};
///
/// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
/// let model = Model::parse(bytes)?;
/// let selected = Selection::default().apply(&model)?;
/// let (contacts_mass, _) = MassRequest::default().contacts_mass(&model)?;
///
/// // From 10 to 80 kg, with the spheres as they are.
/// let mut wanted = Rescale::new(80.0, contacts_mass);
/// wanted.radius = RadiusRule::Keep;
/// let plan = rescale(&model, &selected, &wanted)?;
/// // By (10), E* is 8 times as large; α and the smoothing follow the radius (14, C.2, C.5, C.10) and stay.
/// let changes: Vec<_> = plan.changes.iter().map(|change| (change.property, change.to)).collect();
/// assert_eq!(changes, [(Property::Stiffness, 8e6)]);
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Rescale {
    /// The mass to scale the contacts to, kg.
    pub target_mass_kg: f64,
    pub contacts_mass: Mass,
    /// The rule for the radii.
    ///
    /// ```
    /// use osim_model::{MassRequest, Model, Property, RadiusRule, Selection};
    /// use osim_patch::{Rescale, rescale};
    ///
    /// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
    /// # let model = Model::parse(bytes)?;
    /// # let selected = Selection::default().apply(&model)?;
    /// # let (mass, _) = MassRequest::default().contacts_mass(&model)?;
    /// // One sphere of 0.03 m, scaled from 10 to 80 kg.
    /// let mut wanted = Rescale::new(80.0, mass);
    /// for (rule, radius_m) in [
    ///     (RadiusRule::Isometric, Some(0.06)),
    ///     (RadiusRule::Keep, None),
    ///     (RadiusRule::Metres(0.05), Some(0.05)),
    ///     (RadiusRule::Factor(1.5), Some(0.045)),
    /// ] {
    ///     wanted.radius = rule;
    ///     let plan = rescale(&model, &selected, &wanted)?;
    ///     let radius = plan.changes.iter().find(|change| change.property == Property::Radius);
    ///     assert_eq!(radius.map(|change| change.to), radius_m);
    /// }
    /// # Ok::<(), osim_model::Fault>(())
    /// ```
    pub radius: RadiusRule,
    pub properties: PropertySet,
    /// Whether α follows the radius or the mass (14).
    ///
    /// ```
    /// use osim_model::{DissipationBy, MassRequest, Model, Property, RadiusRule, Selection};
    /// use osim_patch::{Rescale, rescale};
    ///
    /// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
    /// # let model = Model::parse(bytes)?;
    /// # let selected = Selection::default().apply(&model)?;
    /// # let (mass, _) = MassRequest::default().contacts_mass(&model)?;
    /// // <dissipation>2</dissipation>, from 10 to 640 kg, with spheres that stay.
    /// let mut wanted = Rescale::new(640.0, mass);
    /// wanted.radius = RadiusRule::Keep;
    /// wanted.dissipation_by = DissipationBy::Mass;
    /// let plan = rescale(&model, &selected, &wanted)?;
    /// let dissipation = plan.changes.iter().find(|change| change.property == Property::Dissipation).unwrap();
    /// // 64^{-1/6} is a half. By the radius, which stays, α would stay too.
    /// assert!((dissipation.to - 1.0).abs() < 1e-12);
    /// # Ok::<(), osim_model::Fault>(())
    /// ```
    pub dissipation_by: DissipationBy,
    /// Gravity to scale to, m/s², if it differs from the gravity that the contacts were made for.
    pub target_gravity_m_s2: Option<f64>,
    /// Gravity that the contacts were made for, m/s², if it is neither the note's nor the model's.
    pub contacts_gravity_m_s2: Option<f64>,
    /// Move sphere centres along this axis so that the lowest points of the spheres stay where they are.
    pub level: Option<LevelAxis>,
    /// The factors by which OpenSim scaled the bodies, if the spheres are to move and grow with them.
    pub bodies: Option<ScaleFile>,
}

impl Rescale {
    /// A rescaling of everything that the paper scales, with isometric radii (R ∝ M^{1/3}).
    pub fn new(target_mass_kg: f64, contacts_mass: Mass) -> Self {
        Self {
            target_mass_kg,
            contacts_mass,
            radius: RadiusRule::Isometric,
            properties: PropertySet::default(),
            dissipation_by: DissipationBy::default(),
            target_gravity_m_s2: None,
            contacts_gravity_m_s2: None,
            level: None,
            bodies: None,
        }
    }
}

/// Plans a rescaling of the forces `selected` of `model` by (10), (14), (C.2), (C.5) and (C.10): see [`Rescale`] for an
/// example.
///
/// # Errors
/// - A value of the model that cannot be scaled, with its place ([`FaultKind::Number`](osim_model::FaultKind::Number),
///   [`FaultKind::Domain`](osim_model::FaultKind::Domain)), or that is in an included file or in `<defaults>`.
/// - A sphere whose radius would change while a force outside `selected` also uses it ([`MissingFact::SharedSphere`]).
/// - A mass or gravity that is not above 0, or that is not known ([`MissingFact::Gravity`], [`MissingFact::ContactsGravity`]).
pub fn rescale(model: &Model, selected: &Selected, wanted: &Rescale) -> Result<Plan> {
    let target_mass_kg = positive_mass(Input::TargetMass, wanted.target_mass_kg)?;
    let contacts_mass_kg = wanted.contacts_mass.kg;
    let mut plan = PlanBuilder::new(model);
    let gravity = contacts_gravity(model, wanted)?;
    let change = GravityChange::new(gravity, wanted.target_gravity_m_s2, GravityFor::Contacts)?;
    let gravity = change.ratio;
    let other_radius = matches!(wanted.radius, RadiusRule::Metres(_) | RadiusRule::Factor(_));
    let is_there = is_at_target(contacts_mass_kg, target_mass_kg);
    if is_there && gravity == 1.0 && !other_radius && wanted.bodies.is_none() {
        plan.findings.push(rules::already_at_target(&wanted.contacts_mass));
        return Ok(plan_with_note_and_remarks(plan, wanted, selected, None, change));
    }
    // A mass within a thousandth is the same: numbers stay, and only spheres move.
    let mass = if is_there && wanted.bodies.is_some() { 1.0 } else { target_mass_kg / contacts_mass_kg };
    let isometric = Ratios::isometric(mass).map_err(Fault::new)?.radius();
    let rule = |_| SphereRadiusRule::Rule(wanted.radius);
    let radii = Radii::plan(&mut plan, &selected.forces, rule, isometric, &wanted.properties)?;
    match (&wanted.bodies, wanted.level) {
        (Some(bodies), level) => radii.follow_bodies(&mut plan, &selected.forces, bodies, level)?,
        (None, Some(axis)) => radii.keep_bottoms(&mut plan, axis)?,
        (None, None) => {}
    }
    warn_forces(&mut plan, &selected.forces, &wanted.properties);
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        let values = RatioValues { mass, sphere_count: 1.0, radius: radii.ratio(model, force), gravity };
        let ratios = Ratios::new(values).map_err(Fault::new)?;
        for set in &force.sets {
            for property in Property::changeable().filter(|&one| wanted.properties.contains(one)) {
                let scaled = property_factor(property, &ratios, wanted.dissipation_by);
                let Some((factor, by)) = scaled else { continue };
                let Some(from) = model.parameter(force.id, set.id, property)? else { continue };
                if property == Property::Dissipation {
                    rules::remark_on_dissipation(&mut plan.remarks, &ratios, from, None);
                }
                plan.change_parameter(force.id, set.id, property, NewNumber::multiplied(from, factor, by))?;
            }
        }
    }
    if plan.changes.is_empty() && plan.moves.is_empty() {
        let text = "every factor is exactly 1: the radius stays, so what follows the radius stays too";
        plan.findings.push(rules::nothing_to_change(text));
    }
    Ok(plan_with_note_and_remarks(plan, wanted, selected, Some(&radii), change))
}

/// Gravity that the contacts were made for. If a factor depends on it and the note is in doubt, the note's gravity is not used.
fn contacts_gravity(model: &Model, wanted: &Rescale) -> Result<Option<f64>> {
    let noted = model.note.as_ref().and_then(|note| note.gravity_m_s2);
    let differs = noted.is_some() && noted != model.gravity();
    match (wanted.contacts_gravity_m_s2, model.doubt_about_note()) {
        (Some(given), _) => Ok(Some(given)),
        (None, Some(doubt)) if wanted.target_gravity_m_s2.is_some() && differs => {
            Err(Fault::new(MissingFact::ContactsGravity { doubt }))
        }
        _ => Ok(model.contacts_gravity()),
    }
}

/// The plan of a rescaling, with its note and its remarks.
fn plan_with_note_and_remarks(
    plan: PlanBuilder<'_>,
    wanted: &Rescale,
    selected: &Selected,
    radii: Option<&Radii>,
    gravity: GravityChange,
) -> Plan {
    let PlanBuilder { model, changes, moves, findings, mut remarks, .. } = plan;
    let nothing = changes.is_empty() && moves.is_empty();
    if !nothing {
        if moves.is_empty() {
            remarks.push(rules::REMARK_PLACES_STAY.into());
            rules::remark_on_bottoms(&mut remarks, radii);
        } else if wanted.bodies.is_some() {
            remarks.push("body masses stay as they are; spheres follow their bodies".into());
        } else {
            remarks.push(rules::REMARK_LEVEL.into());
        }
        remarks.extend(rules::remark_on_gravity(model, wanted.target_gravity_m_s2));
    }
    let target_mass_kg = if nothing { wanted.contacts_mass.kg } else { wanted.target_mass_kg };
    let contacts_mass = wanted.contacts_mass.clone();
    let mut taken = contacts_mass.contacts_made_for();
    if !nothing {
        let ratio = four_significant(target_mass_kg / contacts_mass.kg);
        taken.push(format!("; scaled to {} kg (mass x{ratio})", readable(target_mass_kg)));
        taken.push(gravity.words);
    }
    let all = selected.complete && wanted.properties.is_complete();
    let masses = Some(Masses { contacts_mass, target_mass_kg });
    Plan::new(
        model,
        Plan { changes, moves, masses, taken, findings, remarks, ..Plan::default() },
        &NoteFacts {
            followed: radii.filter(|_| wanted.bodies.is_some()).map(Radii::spheres).as_ref(),
            made: NotedMass::new(Some(wanted.target_mass_kg), all),
            gravity_m_s2: wanted.target_gravity_m_s2.or(model.contacts_gravity()),
            operation: if wanted.bodies.is_some() { OPERATION_FOLLOWING_SCALE_FILE } else { "rescale" },
        },
    )
}
