//! Designs contact parameters from the wanted behaviour of the contacts, and writes them into a model: (11), (A.5), (13), (C.2),
//! (C.8), (C.10).

use contact_scaling::{
    Contact, ContactValues, DomainError, Law, Ratios, SharedLoad, SmoothingValues, Spheres,
    design as dimensioned, equilibrium, modulus, patch, restitution, smoothing,
};
use osim_model::messages::{Phrase, counted, four_significant, phrase, readable};
use osim_model::{
    DissipationBy, Fault, Force, ForceKind, GravityFor, Mass, MissingFact, Model, Note, Property,
    PropertySet, RadiusRule, Result, Selected, SetId, are_equal_gravities, is_at_target, moving_spheres,
};

use crate::builder::{NewNumber, PlanBuilder, change_composite, scale_with_radius};
use crate::change::{ChangedBy, property_factor};
use crate::new_radii::{Radii, SphereRadiusRule};
use crate::note_edits::NotedMass;
use crate::plan::{Masses, NoteFacts, Plan};
use crate::rules::{self, REMARK_PLACES_STAY, remark_on_equilibrium, remark_on_moved_bottoms};

/// The relative indentation at which the mean contact stress is `stress_n_m2`, under a force on each sphere: (15) gives x̂ of a stress as
/// it gives the stress of x̂.
///
/// # Errors
/// Numbers outside the domain of (15), or spheres deeper than their radius.
pub fn indentation_of_stress(stress_n_m2: f64, per_sphere_n: f64, radius_m: f64) -> Result<f64, String> {
    let x = patch::mean_stress(per_sphere_n, radius_m, stress_n_m2).map_err(|error| error.to_string())?;
    let [stress, depth, most] = [stress_n_m2, x, x * stress_n_m2].map(readable);
    let text = format!("a mean stress of {stress} N/m2 needs x/R = {depth}, which is at most 1");
    let text = format!("{text}: give {most} N/m2 or more, a larger radius or more spheres");
    if x > 1.0 { Err(text) } else { Ok(x) }
}

/// How E₁* is determined: see [`Design`] for an example.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DesignModulus {
    /// A relative indentation x̂ under the load, by (11). For a smoothed force, the modulus is larger: (C.9) leaves only a
    /// share of the Hertz force at speed 0, and that share must carry the load.
    Indentation(f64),
    /// A mean stress (N/m²) on the contact patch under the load, which gives x̂ by (15).
    Stress(f64),
    /// E₁* is known, N/m²: it does not follow the radius.
    Known(f64),
    /// By (A.1) and (A.5), a Young's modulus (N/m²) and Poisson's ratio on rigid ground.
    Young { young_n_m2: f64, poisson: f64 },
}

/// The wanted behaviour of contacts. A property whose field is `None` stays, or is scaled with a changed radius.
///
/// ```
/// use contact_scaling::SharedLoad;
/// use osim_model::{Model, Property, Selection};
/// use osim_patch::{Design, DesignModulus, design};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
/// let model = Model::parse(bytes)?;
/// let selected = Selection::default().apply(&model)?;
///
/// // The sphere of 0.03 m is to sink in by 0.16 R under 98.1 N, and to keep 0.75 of its speed from 0.5 m/s.
/// let mut wanted = Design::default();
/// wanted.modulus = Some(DesignModulus::Indentation(0.16));
/// wanted.load = Some(SharedLoad::new(98.1, 1.0)?);
/// wanted.restitution = Some((0.75, Some(0.5)));
/// let plan = design(&model, &selected, &wanted)?;
/// let to = |property| plan.changes.iter().find(|change| change.property == property).unwrap().to;
///
/// // (11): E* = 3 F / (4 R² x̂^{3/2}); (A.4): two equal surfaces have 2^{3/2} E*.
/// let stiffness = 2_f64.powf(1.5) * 3.0 * 98.1 / (4.0 * 0.03 * 0.03 * 0.064);
/// assert!((to(Property::Stiffness) / stiffness - 1.0).abs() < 1e-12);
/// // (13): α = (1 - 0.75) / 0.5 m/s.
/// assert_eq!(to(Property::Dissipation), 0.5);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Design {
    /// How the modulus E₁* (N/m²) is determined.
    pub modulus: Option<DesignModulus>,
    /// Total load (N) and the spheres that share it; needed for [`DesignModulus::Indentation`].
    pub load: Option<SharedLoad>,
    /// Coefficient of restitution (13), and the impact speed in m/s at which it holds (`None`: √(gR/2)).
    pub restitution: Option<(f64, Option<f64>)>,
    /// Wanted constant indentation x̂_c of (C.2).
    pub constant_indentation: Option<f64>,
    /// Threshold t and width Δx̂ of (C.8), both without a unit.
    pub state_width: Option<(f64, f64)>,
    /// Threshold t, without a unit, and width Δv in m/s of (C.10).
    pub speed_width: Option<(f64, f64)>,
    /// Wanted b_x̂ of (C.5), without a unit.
    pub state_smoothing: Option<f64>,
    /// Wanted b_ẋ of (C.10), in s/√m.
    pub speed_smoothing: Option<f64>,
    /// The rule for the radii, unless a contact stiffness is wanted.
    pub radius: RadiusRule,
    /// Wanted stiffness of one sphere at the wanted indentation and load, N/m. It determines the radius (11, B.2); `radius`
    /// is ignored then.
    pub contact_stiffness_n_m: Option<f64>,
    /// Mass that the designed contacts are made for, if the load is body weight.
    pub target_mass: Option<Mass>,
    /// The mass that the contacts were made for before the design, if it is certain. Properties that are not designed stay
    /// made for it.
    pub contacts_mass: Option<Mass>,
    /// Gravity, m/s², if it is not the model's.
    pub gravity_m_s2: Option<f64>,
}

/// Plans a design onto the forces `selected` of `model`, by (11), (A.5), (13), (C.2), (C.8) and (C.10): see [`Design`] for an
/// example.
///
/// # Errors
/// - A quantity outside its domain ([`FaultKind::Quantity`](osim_model::FaultKind::Quantity)).
/// - An indentation without a load ([`MissingFact::Load`]), or a restitution without an impact speed in a model without gravity
///   ([`MissingFact::Gravity`]).
/// - The errors of [`rescale`](crate::rescale) that are about values and shared spheres.
pub fn design(model: &Model, selected: &Selected, wanted: &Design) -> Result<Plan> {
    let mut plan = PlanBuilder::new(model);
    let properties = PropertySet::default();
    let rule = wanted.radius_rule()?;
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        if !model.sphere_pairs(force).is_empty() {
            wanted.refuse_for_pairs(force)?;
        }
    }
    // The laws of a design hold for spheres.
    moving_spheres(model, &selected.forces)
        .into_iter()
        .try_for_each(|id| model.round_radius_m(id).map(drop))?;
    let radii = Radii::plan(&mut plan, &selected.forces, |_| rule, 1.0, &properties)?;
    plan.findings.extend(model.remarks_on(&selected.forces));
    let mut rests = Vec::new();
    let shared = !model.spheres_in_several_forces().is_empty();
    let by = DissipationBy::Radius;
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        let own_ratios = radii.own_ratios(model, force)?;
        let radius_m = radii.rms_pressed_radius(model, force);
        let sphere = DesignedForce { force, radius_m, own_ratios };
        // If two forces share a sphere, the rest of one force alone means nothing.
        rests.extend(wanted.equilibrium_indentation(&plan, &sphere)?.filter(|_| !shared));
        for property in Property::changeable().filter(|&property| properties.contains(property)) {
            match wanted.value(&plan, &sphere, property)? {
                Some((to, by)) => change_composite(&mut plan, force.id, property, to, by)?,
                None => scale_with_radius(&mut plan, force, property, &sphere.own_ratios, by)?,
            }
        }
    }
    let mut remarks: Vec<Phrase> = vec![REMARK_PLACES_STAY.into()];
    remarks.extend(remark_on_moved_bottoms(&radii));
    remarks.extend(remark_on_equilibrium(&rests));
    let PlanBuilder { changes, moves, mut findings, .. } = plan;
    if changes.is_empty() {
        findings.push(rules::nothing_to_change(
            "nothing that is wanted applies to these forces, or every value is already as wanted",
        ));
    }
    let smooth = selected.forces.iter().filter_map(|&id| model.force(id)).any(is_smooth);
    let masses = wanted.target_mass.clone().map(Masses::unchanged);
    let gravity_m_s2 = wanted.load.and(wanted.gravity_m_s2.or(model.gravity())).or(model.contacts_gravity());
    let made = wanted.mass_for_note(model, wanted.is_complete(smooth) && selected.complete);
    Ok(Plan::new(
        model,
        Plan { changes, moves, masses, taken: wanted.describe(), findings, remarks, ..Plan::default() },
        &NoteFacts { made, gravity_m_s2, operation: "design", followed: None },
    ))
}

/// A force whose parameters are computed from what is wanted of the contact.
struct DesignedForce<'f> {
    force: &'f Force,
    radius_m: f64,
    /// Scaling ratios of the force that follow from its old and new radii.
    own_ratios: Ratios,
}

fn is_smooth(force: &Force) -> bool {
    force.kind == ForceKind::SmoothSphereHalfSpace
}

impl Design {
    /// The mass and scope of the note after the design. `complete`: every property of every force was designed.
    ///
    /// | wanted behaviour | mass before the design | note after the design |
    /// |---|---|---|
    /// | nothing that depends on a load | any | as in [`NotedMass::of`] |
    /// | an indentation under the weight of M | M | M, all |
    /// | an indentation under the weight of M | another mass, or in doubt | M, partial; all if the design is `complete` |
    /// | an indentation under a load in N | any | no mass, partial |
    fn mass_for_note(&self, model: &Model, complete: bool) -> NotedMass {
        let Some(target) = &self.target_mass else {
            let kept = || NotedMass::of(model, None);
            return self.load.map_or_else(kept, |_| NotedMass::new(None, false));
        };
        let noted = model.note.as_ref();
        let agrees = self.contacts_mass.as_ref().is_some_and(|before| is_at_target(before.kg, target.kg))
            && self.is_under_gravity_of_note(noted, model);
        let kg = noted.and_then(|note| note.contacts_mass_kg).filter(|_| agrees).unwrap_or(target.kg);
        NotedMass::new(Some(kg), agrees || complete)
    }

    /// Whether the gravity of the design is the gravity in the note; true if the note has none.
    fn is_under_gravity_of_note(&self, note: Option<&Note>, model: &Model) -> bool {
        let (noted, own) = (note.and_then(|note| note.gravity_m_s2), self.gravity_m_s2.or(model.gravity()));
        noted.zip(own).is_none_or(|(noted, own)| are_equal_gravities(noted, own))
    }

    /// The rule for the radii; with a wanted contact stiffness, the radius comes from (11) and (B.2).
    fn radius_rule(&self) -> Result<SphereRadiusRule> {
        match (self.contact_stiffness_n_m, self.modulus, &self.load) {
            (Some(k), Some(DesignModulus::Indentation(x)), Some(load)) => {
                let radius = dimensioned::radius_for_stiffness(k, x, load).map_err(Fault::new)?;
                Ok(SphereRadiusRule::Designed(radius))
            }
            _ => Ok(SphereRadiusRule::Rule(self.radius)),
        }
    }

    /// Refuses what a force on pairs of spheres has no number for.
    fn refuse_for_pairs(&self, force: &Force) -> Result<()> {
        let needed = if self.contact_stiffness_n_m.is_some() {
            "give radii in metres: a contact stiffness gives one radius, and a pair has two"
        } else if self.target_mass.is_some() {
            "give a load in newtons: a pair carries no body weight"
        } else if self.restitution.is_some_and(|(_, speed)| speed.is_none()) {
            "give an impact speed: the spheres do not fall on each other"
        } else {
            return Ok(());
        };
        let fault = Fault::refused(format!("{} presses spheres on each other: {needed}", force.path));
        Err(fault.at_element(force.path.clone()).in_file(force.file))
    }

    /// Whether the design gives every property that the paper scales. A `HuntCrossleyForce` has no smoothing.
    fn is_complete(&self, smooth: bool) -> bool {
        let state = self.state_width.is_some() || self.state_smoothing.is_some();
        let speed = self.speed_width.is_some() || self.speed_smoothing.is_some();
        let smoothing = self.constant_indentation.is_some() && state && speed;
        self.modulus.is_some() && self.restitution.is_some() && (smoothing || !smooth)
    }

    /// The designed value of `property` and what it follows from; `None` if it is not designed.
    fn value(
        &self,
        plan: &PlanBuilder<'_>,
        sphere: &DesignedForce<'_>,
        property: Property,
    ) -> Result<Option<(f64, ChangedBy)>> {
        let (radius_m, smooth, model) = (sphere.radius_m, is_smooth(sphere.force), plan.model);
        let (to, equation) = match property {
            Property::Stiffness => {
                let Some(modulus) = self.modulus else { return Ok(None) };
                let state = self.speed_state(plan, sphere)?;
                return self.designed_modulus(modulus, radius_m, state).map(Some);
            }
            Property::Dissipation => {
                let Some((restitution, speed)) = self.restitution else { return Ok(None) };
                let gravity = self.gravity_m_s2.or(model.gravity());
                let speed = speed.map_or_else(|| default_impact_speed(gravity, radius_m), Ok)?;
                (restitution::dissipation(restitution, speed).map_err(Fault::new)?, "13")
            }
            Property::ConstantContactForce if smooth => {
                let Some(x) = self.constant_indentation else { return Ok(None) };
                (smoothing::constant_contact_force(x, radius_m).map_err(Fault::new)?, "C.2")
            }
            Property::HertzSmoothing if smooth => match (self.state_smoothing, self.state_width) {
                (Some(b), _) => (smoothing::hertz_smoothing(b, radius_m).map_err(Fault::new)?, "C.5"),
                (None, Some((t, width))) => {
                    (smoothing::hertz_smoothing_for_width(t, width, radius_m).map_err(Fault::new)?, "C.8")
                }
                (None, None) => return Ok(None),
            },
            Property::HuntCrossleySmoothing if smooth => {
                let bv = match (self.speed_smoothing, self.speed_width) {
                    (Some(b), _) => smoothing::hunt_crossley_smoothing(b, radius_m),
                    (None, Some((t, width))) => smoothing::hunt_crossley_smoothing_for_speed_width(t, width),
                    (None, None) => return Ok(None),
                };
                (bv.map_err(Fault::new)?, "C.10")
            }
            _ => return Ok(None),
        };
        Ok(Some((to, ChangedBy::Equation(equation))))
    }

    /// The value of `property` after the design: designed, or scaled with the radius.
    fn value_after(
        &self,
        plan: &PlanBuilder<'_>,
        sphere: &DesignedForce<'_>,
        property: Property,
    ) -> Result<Option<f64>> {
        if let Some((to, _)) = self.value(plan, sphere, property)? {
            return Ok(Some(to));
        }
        let from = sphere.force.checked(SetId::FIRST, property)?;
        let carried = from.zip(property_factor(property, &sphere.own_ratios, DissipationBy::Radius));
        Ok(carried.map(|(from, (factor, by))| NewNumber::multiplied(from, factor, by).to))
    }

    /// The factor on the Hertz force at speed 0, the second factor of (C.9), with the α and bv of the force; 1 without
    /// smoothing.
    fn speed_state(&self, plan: &PlanBuilder<'_>, sphere: &DesignedForce<'_>) -> Result<f64> {
        if !is_smooth(sphere.force) {
            return Ok(1.0);
        }
        let dissipation = self.value_after(plan, sphere, Property::Dissipation)?;
        match dissipation.zip(self.value_after(plan, sphere, Property::HuntCrossleySmoothing)?) {
            Some((alpha, bv)) => smoothing::speed_state_at_rest(alpha, bv).map_err(Fault::new),
            None => Ok(1.0),
        }
    }

    /// x/R at which a smoothed force carries the load at speed 0; `None` if no load is known, or if no indentation carries
    /// it.
    fn equilibrium_indentation(
        &self,
        plan: &PlanBuilder<'_>,
        sphere: &DesignedForce<'_>,
    ) -> Result<Option<f64>> {
        let Some(load) = self.load.filter(|_| is_smooth(sphere.force)) else { return Ok(None) };
        let after =
            |property| self.value_after(plan, sphere, property).map(|value| value.unwrap_or(f64::NAN));
        let values = ContactValues {
            plane_strain_modulus: after(Property::Stiffness)?,
            dissipation: after(Property::Dissipation)?,
            smoothing: Some(SmoothingValues {
                constant_contact_force: after(Property::ConstantContactForce)?,
                hertz_smoothing: after(Property::HertzSmoothing)?,
                hunt_crossley_smoothing: after(Property::HuntCrossleySmoothing)?,
            }),
        };
        let indentation = || -> Result<f64, DomainError> {
            let law = Law::of(&Contact::new(values)?, sphere.radius_m)?;
            equilibrium::indentation(&[Spheres::new(law, 1.0)?], load.per_sphere_n())
        };
        Ok(indentation().ok().map(|x| x / sphere.radius_m))
    }

    /// E₁* and what it follows from; `speed_state` is the factor on the Hertz force at speed 0.
    fn designed_modulus(
        &self,
        modulus: DesignModulus,
        radius_m: f64,
        speed_state: f64,
    ) -> Result<(f64, ChangedBy)> {
        match modulus {
            DesignModulus::Known(n_m2) => Ok((n_m2, ChangedBy::Given)),
            DesignModulus::Young { young_n_m2, poisson } => {
                let stiffness = modulus::stiffness_on_rigid_ground(young_n_m2, poisson);
                Ok((stiffness.map_err(Fault::new)?, ChangedBy::Equation("A.5")))
            }
            DesignModulus::Indentation(x) | DesignModulus::Stress(x) => {
                let load = self.load.as_ref().ok_or_else(|| Fault::new(MissingFact::Load))?;
                let is_stress = matches!(modulus, DesignModulus::Stress(_));
                let stressed = || indentation_of_stress(x, load.per_sphere_n(), radius_m);
                let x = if is_stress { stressed().map_err(Fault::refused)? } else { x };
                let composite = dimensioned::composite_modulus(radius_m, x, load).map_err(Fault::new)?;
                let composite = composite / speed_state;
                let equation = match (is_stress, speed_state == 1.0) {
                    (false, true) => "11",
                    (false, false) => "11, C.9",
                    (true, true) => "15, 11",
                    (true, false) => "15, 11, C.9",
                };
                let equal = modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman);
                Ok((equal.map_err(Fault::new)?, ChangedBy::Equation(equation)))
            }
        }
    }

    /// What the design wants, as the first line of a report.
    fn describe(&self) -> Phrase {
        let mut parts: Vec<Phrase> = Vec::new();
        if let Some(load) = &self.load {
            let spheres = counted(load.sphere_count(), "sphere");
            parts.push(format!("{} N on {spheres}", four_significant(load.load_n())).into());
        }
        if let Some(mass) = &self.target_mass {
            let weighs = format!("model weighs {} kg (", readable(mass.kg));
            parts.push(phrase![weighs, &mass.source.describe(), ")"]);
        }
        parts.extend(self.wanted_in_words().into_iter().map(Phrase::from));
        Phrase::joined(parts, "; ").unwrap_or_else(|| "another radius".into())
    }

    /// Each wanted quantity in words.
    fn wanted_in_words(&self) -> Vec<String> {
        let modulus = self.modulus.map(|modulus| match modulus {
            DesignModulus::Indentation(x) => format!("relative indentation {}", readable(x)),
            DesignModulus::Stress(stress) => {
                format!("mean stress {} N/m2, 1.5 times that at the middle", readable(stress))
            }
            DesignModulus::Known(n_m2) => format!("stiffness {} N/m2", readable(n_m2)),
            DesignModulus::Young { young_n_m2, poisson } => {
                format!("Young's modulus {} N/m2, Poisson's ratio {poisson}", readable(young_n_m2))
            }
        });
        let restitution =
            self.restitution.map(|(restitution, _)| format!("restitution {}", readable(restitution)));
        let constant = self.constant_indentation.map(|x| format!("constant indentation {}", readable(x)));
        let state = self
            .state_width
            .map(|(t, width)| format!("contact transition over {} radii (threshold {t})", readable(width)));
        let speed = self
            .speed_width
            .map(|(t, width)| format!("speed transition over {} m/s (threshold {t})", readable(width)));
        let state =
            state.or(self.state_smoothing.map(|b| format!("Hertz smoothing times radius {}", readable(b))));
        let root = |b| format!("Hunt-Crossley smoothing times root of radius {} s/m^(1/2)", readable(b));
        let speed = speed.or(self.speed_smoothing.map(root));
        [modulus, restitution, constant, state, speed].into_iter().flatten().collect()
    }
}

/// √(gR/2), the impact speed after a fall from a quarter of the radius, as in the paper's drop test.
fn default_impact_speed(gravity: Option<f64>, radius_m: f64) -> Result<f64> {
    match gravity.filter(|&gravity| gravity > 0.0) {
        Some(gravity) => restitution::drop_speed(gravity, radius_m).map_err(Fault::new),
        None => Err(Fault::new(MissingFact::Gravity { purpose: GravityFor::ImpactSpeed })),
    }
}
