//! The options of a transfer, and its reference: the preset or model from which contacts are taken.

use contact_scaling::{Contact, ContactValues, Preset, RatioValues, Ratios, SmoothingValues};
use osim_model::compare::Follow;
use osim_model::{
    Class, DissipationBy, Fault, FaultKind, ForceKind, LevelAxis, Mass, MassSource, Model, Property,
    PropertySet, RadiusRule, Result, Selected, Surfaces, contact_of_set, root_mean_square, sphere_sets,
};

use crate::change::{ChangedBy, property_factor};
use crate::objects::{ContactLayout, NewContact};

/// A contact of a reference, and the spheres that use this contact.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceContact {
    /// Names of the spheres with this contact.
    pub spheres: Vec<String>,
    /// Radius of each sphere in `spheres`, m.
    pub radii_m: Vec<f64>,
    /// Common radius of the spheres, m; the root mean square if their radii differ.
    pub radius_m: f64,
    /// E₁* (N/m²) of two equal surfaces, α (s/m), and the smoothing if the force class has any.
    pub contact: Contact,
    /// `transition_velocity` in m/s and `viscous_friction` in s/m.
    pub friction: Option<(f64, f64)>,
}

/// The source of contacts: another model ([`reference_of_model`]) or a preset.
///
/// ```
/// use osim_model::{MassRequest, Model, Selection};
/// use osim_patch::{Reference, reference_of_model};
///
/// // The published contacts of Falisse et al. (2022): 62 kg on 6 spheres of 0.032 m.
/// let human = Reference::from(&contact_scaling::falisse2022());
/// assert_eq!((human.mass.kg, human.sphere_count, human.contacts[0].radius_m), (62.0, 6.0, 0.032));
///
/// # let bytes: &[u8] = include_bytes!("../../../osim-model/tests/data/one_foot.osim");
/// // A model of 10 kg on one sphere.
/// let model = Model::parse(bytes)?;
/// let selected = Selection::default().apply(&model)?;
/// let mass = MassRequest::default().model_mass(&model)?;
/// let own = reference_of_model(&model, &selected, mass, 1.0)?;
/// assert_eq!((own.name.as_str(), own.gravity_m_s2), ("one_foot", Some(9.81)));
/// assert_eq!((own.contacts[0].spheres[0].as_str(), own.contacts[0].radii_m[0]), ("heel_r", 0.03));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// Name of the model or preset, for reports.
    pub name: String,
    pub mass: Mass,
    /// Number n of spheres that share the body weight of the reference.
    pub sphere_count: f64,
    /// Gravity that the contacts were made for, m/s², if known.
    pub gravity_m_s2: Option<f64>,
    pub contacts: Vec<ReferenceContact>,
}

impl Reference {
    /// The fault that the reference has no contacts.
    pub fn without_contacts(&self) -> Fault {
        Fault::refused(format!("the reference {} has no contacts to take", self.name))
    }

    /// The fault if no contact of the reference has the chosen `sphere`.
    pub fn without_sphere(&self, sphere: &str) -> Fault {
        let known = self.contacts.iter().flat_map(|contact| &contact.spheres).cloned().collect();
        let (sphere, reference) = (sphere.to_owned(), self.name.clone());
        Fault::new(FaultKind::UnknownReferenceSphere { sphere, reference, known })
    }
}

impl From<&Preset> for Reference {
    fn from(preset: &Preset) -> Self {
        let mass = Mass { kg: preset.scale.mass_kg(), source: MassSource::Preset(preset.name.to_string()) };
        Self {
            name: preset.name.to_string(),
            mass,
            sphere_count: preset.scale.sphere_count(),
            gravity_m_s2: Some(preset.scale.gravity_m_s2()),
            contacts: vec![ReferenceContact {
                spheres: vec![],
                radii_m: vec![],
                radius_m: preset.scale.radius_m(),
                contact: preset.contact,
                friction: None,
            }],
        }
    }
}

/// The options of a transfer, which scales the contacts of a reference to the size of this model.
///
/// ```
/// use osim_model::{MassRequest, Model, Property, Selection};
/// use osim_patch::{Reference, Transfer, transfer};
///
/// # let bytes: &[u8] = include_bytes!("../../../osim-model/tests/data/one_foot.osim");
/// let model = Model::parse(bytes)?;
/// let selected = Selection::default().apply(&model)?;
/// let mass = MassRequest::default().model_mass(&model)?;
///
/// // 62 kg on 6 spheres of 0.032 m with E₁* = 1e6 N/m², to 10 kg on one sphere of 0.03 m.
/// let human = Reference::from(&contact_scaling::falisse2022());
/// let plan = transfer(&model, &selected, &Transfer::new(human, mass, 1.0))?;
/// let stiffness = plan.changes.iter().find(|change| change.property == Property::Stiffness).unwrap();
/// // (10): E*_b = (M_b / M_a) (n_a / n_b) (R_a² / R_b²) E*_a.
/// let expected = (10.0 / 62.0) * (6.0 / 1.0) * (0.032 * 0.032) / (0.03 * 0.03) * 1e6;
/// assert!((stiffness.to / expected - 1.0).abs() < 1e-12);
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Transfer {
    /// The model or preset from which the contacts are taken.
    pub reference: Reference,
    /// Name of the sphere of the reference whose contact all spheres get. `None`: the common contact of all spheres of the
    /// reference, else that of the sphere with the same name.
    pub reference_sphere: Option<String>,
    /// Mass of this model: the mass that the contacts are scaled to.
    pub target_mass: Mass,
    /// Number n of spheres that share this model's weight.
    pub sphere_count: f64,
    /// Whether each sphere has a sphere of the same name in the reference and the number of spheres that share the weight is
    /// not known: only the ratio of the two numbers then matters.
    pub counts_cancel: bool,
    /// The rule for the new radii of the spheres.
    pub radius: RadiusRule,
    pub properties: PropertySet,
    /// Whether α follows the radius or the mass (14).
    pub dissipation_by: DissipationBy,
    /// Gravity of this model, m/s², if the contacts are scaled to it; `None`: the reference's gravity stays.
    pub target_gravity_m_s2: Option<f64>,
    /// New locations and radii of the spheres that move and grow with their bodies. For these spheres, `radius` only decides
    /// which equation is named.
    pub follow: Option<Follow>,
    /// The ratio of this model's bones to those of the reference, if both are known, for a remark.
    pub length_ratio: Option<f64>,
    /// Move the centres of the other spheres along this axis so that the lowest points of these spheres stay where they are.
    pub level: Option<LevelAxis>,
    /// The rule that E₁* and α follow.
    pub rule: ScalingRule,
    /// Whether different scale factors for spheres of one force are an error instead of a warning.
    pub strict: bool,
}

impl Transfer {
    /// A transfer of everything that the paper scales, with unchanged radii; `target_mass` and `sphere_count` belong to the
    /// changed model.
    pub fn new(reference: Reference, target_mass: Mass, sphere_count: f64) -> Self {
        Self {
            reference,
            reference_sphere: None,
            target_mass,
            sphere_count,
            counts_cancel: false,
            radius: RadiusRule::Keep,
            properties: PropertySet::default(),
            dissipation_by: DissipationBy::default(),
            target_gravity_m_s2: None,
            follow: None,
            length_ratio: None,
            level: None,
            rule: ScalingRule::Paper,
            strict: false,
        }
    }

    /// The ratios of this model to the reference, if their radii have the ratio `radius` and their gravities the ratio `gravity`.
    pub(super) fn ratios(&self, radius: f64, gravity: f64) -> Result<Ratios> {
        let mass = self.target_mass.kg / self.reference.mass.kg;
        let sphere_count = self.sphere_count / self.reference.sphere_count;
        Ratios::new(RatioValues { mass, sphere_count, radius, gravity }).map_err(Fault::new)
    }

    /// The factor of a property by the rule of the transfer, and who gives the factor.
    pub(super) fn factor(&self, property: Property, ratios: &Ratios) -> Option<(f64, ChangedBy)> {
        let ScalingRule::PredSim { height_ratio } = self.rule else {
            return property_factor(property, ratios, self.dissipation_by);
        };
        let factor = match property {
            Property::Stiffness => ratios.mass() / (height_ratio * height_ratio),
            Property::Dissipation => 1.0 / height_ratio,
            // PredSim does not scale the smoothing.
            Property::ConstantContactForce | Property::HertzSmoothing | Property::HuntCrossleySmoothing => {
                1.0
            }
            _ => return None,
        };
        Some((factor, ChangedBy::PredSim))
    }
}

/// How E₁* and α follow from the reference.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum ScalingRule {
    /// The paper's equations (10) and (14).
    #[default]
    Paper,
    /// PredSim's rule: stiffness ∝ mass / height², dissipation ∝ 1 / height; smoothing stays. The ratio is that of this model's height to the reference's.
    PredSim { height_ratio: f64 },
}

// The contacts of a model, as a reference for others.

/// Reads the contacts of the forces `selected` of a reference model. They were made for `mass` on `sphere_count` spheres that
/// share its weight: see [`Reference`] for an example.
pub fn reference_of_model(
    model: &Model,
    selected: &Selected,
    mass: Mass,
    sphere_count: f64,
) -> Result<Reference> {
    let mut contacts = Vec::new();
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        let surfaces = Surfaces::of(force)?;
        for (set, spheres) in sphere_sets(model, force) {
            let radii_m: Result<Vec<f64>> = spheres.iter().map(|&id| model.radius_m(id)).collect();
            let radii_m = radii_m?;
            let radius_m = root_mean_square(radii_m.iter().copied());
            let contact = contact_of_set(force, &surfaces, set)?;
            let get = |property| force.checked(set, property);
            let friction = get(Property::TransitionVelocity)?.zip(get(Property::ViscousFriction)?);
            let names = spheres.iter().filter_map(|&s| model.sphere(s)).map(|s| s.name.clone()).collect();
            contacts.push(ReferenceContact { spheres: names, radii_m, radius_m, contact, friction });
        }
    }
    let (name, gravity_m_s2) = (model.name.clone(), model.contacts_gravity().filter(|&g| g > 0.0));
    Ok(Reference { name, mass, sphere_count, gravity_m_s2, contacts })
}

/// The contacts of `layout` as a reference called `name`. They were made for `mass` on `sphere_count` spheres that share its
/// weight, and for a gravity if known.
///
/// ```
/// use osim_model::{ForceKind, Mass, MassSource, Property};
/// use osim_patch::{ContactLayout, NewContact, reference_of_layout};
///
/// let mut heel = NewContact::new(ForceKind::HuntCrossley, "force_heel", "heel");
/// heel.radius_m = 0.03;
/// heel.values = vec![(Property::Stiffness, 1e6), (Property::Dissipation, 2.0)];
/// let mut layout = ContactLayout::default();
/// layout.contacts.push(heel);
///
/// let mass = Mass { kg: 62.0, source: MassSource::ReferenceMass };
/// let reference = reference_of_layout("human", &layout, mass, 6.0, Some(9.81))?;
/// assert_eq!(reference.contacts[0].contact.plane_strain_modulus(), 1e6);
/// assert_eq!(reference.contacts[0].radius_m, 0.03);
/// # Ok::<(), osim_model::Fault>(())
/// ```
pub fn reference_of_layout(
    name: &str,
    layout: &ContactLayout,
    mass: Mass,
    sphere_count: f64,
    gravity_m_s2: Option<f64>,
) -> Result<Reference> {
    let contacts = layout.contacts.iter().map(contact_of_new).collect::<Result<_>>()?;
    Ok(Reference { name: name.to_owned(), mass, sphere_count, gravity_m_s2, contacts })
}

/// A new contact as a contact of a reference.
fn contact_of_new(new: &NewContact) -> Result<ReferenceContact> {
    let smooth = new.kind == ForceKind::SmoothSphereHalfSpace;
    let class = if smooth { Class::SmoothSphereHalfSpaceForce } else { Class::ContactParameters };
    let value = |property| {
        let given = new.values.iter().find(|(known, _)| *known == property);
        given.map_or_else(|| class.default(property), |(_, value)| *value)
    };
    let smoothing = SmoothingValues {
        constant_contact_force: value(Property::ConstantContactForce),
        hertz_smoothing: value(Property::HertzSmoothing),
        hunt_crossley_smoothing: value(Property::HuntCrossleySmoothing),
    };
    let values = ContactValues {
        plane_strain_modulus: value(Property::Stiffness),
        dissipation: value(Property::Dissipation),
        smoothing: smooth.then_some(smoothing),
    };
    Ok(ReferenceContact {
        spheres: vec![new.sphere.clone()],
        radii_m: vec![new.radius_m],
        radius_m: new.radius_m,
        contact: Contact::new(values).map_err(|fault| Fault::new(fault).at_element(new.force.clone()))?,
        friction: Some((value(Property::TransitionVelocity), value(Property::ViscousFriction))),
    })
}
