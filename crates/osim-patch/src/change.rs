//! Changes of single numbers and of places, the texts that are written for them, and the factors by which properties are scaled.
//! A number that is not finite never becomes text.

use contact_scaling::Ratios;
use osim_model::messages::{Input, four_significant, readable, shortest};
use osim_model::{
    DissipationBy, Fault, FaultKind, FileId, GravityFor, MissingFact, Property, Result, Slot, ValueKey,
};

/// A number that changes, in the unit of its [`Property`].
///
/// ```
/// # use osim_model::{MassRequest, Model, Property, Selection};
/// # use osim_patch::{NumberChange, ChangedBy, Plan, Rescale, rescale};
/// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
/// # let model = Model::parse(bytes)?;
/// # let selected = Selection::default().apply(&model)?;
/// # let (mass, _) = MassRequest::default().contacts_mass(&model)?;
/// // One sphere of 0.03 m, scaled from 10 to 80 kg.
/// let plan = rescale(&model, &selected, &Rescale::new(80.0, mass))?;
/// let find = |property| plan.changes.iter().find(|change| change.property == property).unwrap();
///
/// // <radius>0.03</radius> stands on line 21.
/// let radius = find(Property::Radius);
/// assert_eq!((radius.sphere.as_deref(), radius.line), (Some("heel_r"), 21));
/// // (10): 8 times the mass on 4 times R².
/// let stiffness = find(Property::Stiffness);
/// assert_eq!((stiffness.from, stiffness.to, stiffness.by), (1e6, 2e6, ChangedBy::Equation("10")));
/// // The file has no <constant_contact_force>: OpenSim's 1e-5 m² is scaled by R² (C.2) and written as a new element.
/// let constant = find(Property::ConstantContactForce);
/// assert_eq!((constant.from, constant.to, constant.inserted), (1e-5, 4e-5, true));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct NumberChange {
    /// Name of the force; `None` for a sphere's radius.
    pub force: Option<String>,
    /// Component path of the force or sphere.
    pub path: String,
    /// Index of the `ContactParameters` within the force, from 0, for reports; `None` for a property without
    /// `ContactParameters`.
    pub set: Option<usize>,
    /// Name of the sphere whose radius changes.
    pub sphere: Option<String>,
    /// The present and the new radii of an ellipsoid, m; all are multiplied by one factor.
    pub radii_m: Option<[[f64; 3]; 2]>,
    pub property: Property,
    /// Present effective value, as OpenSim reads it.
    pub from: f64,
    pub to: f64,
    /// The factor by which the value was multiplied; `None` if it was set.
    pub factor: Option<f64>,
    pub by: ChangedBy,
    /// Line of the number in the file, from 1; of the object, if the number is inserted.
    pub line: usize,
    /// Whether the file has no element for the number, so that the element is inserted.
    pub inserted: bool,
    pub(crate) slot: Slot,
}

/// A sphere centre or half-space that moves.
///
/// ```
/// # use osim_model::{LevelAxis, MassRequest, Model, Selection};
/// # use osim_patch::{Rescale, rescale};
/// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
/// # let model = Model::parse(bytes)?;
/// # let selected = Selection::default().apply(&model)?;
/// # let (mass, _) = MassRequest::default().contacts_mass(&model)?;
/// // From 10 to 80 kg, and the bottoms of the spheres stay where they are.
/// let mut wanted = Rescale::new(80.0, mass);
/// wanted.level = Some(LevelAxis::of_gravity(model.gravity_m_s2));
/// let plan = rescale(&model, &selected, &wanted)?;
/// // The radius grows from 0.03 to 0.06 m, so the centre rises by 0.03 m.
/// let place = &plan.moves[0];
/// assert_eq!((place.from, place.to), ([0.0, 0.0, 0.0], [0.0, 0.03, 0.0]));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PlaceChange {
    /// Name of the sphere or half-space that moves.
    pub geometry: String,
    /// Component path of the object that changes.
    pub path: String,
    /// Present location in the frame of the sphere or half-space, m.
    pub from: [f64; 3],
    pub to: [f64; 3],
    pub by: ChangedBy,
    /// Line of the location in the file, from 1; of the sphere, if the location is inserted.
    pub line: usize,
    /// Whether the file has no element for the location, so that the element is inserted.
    pub inserted: bool,
    pub(crate) slot: Slot,
}

/// The rule that gives the new value of a number or a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ChangedBy {
    /// Equations of the paper, by their numbers: `10`, `C.2`, `11, B.2`.
    Equation(&'static str),
    Given,
    /// The scaled size of the body to which the sphere is attached.
    Follow,
    /// The value comes from a fit to a recording.
    Fit,
    /// The lowest point of the sphere stays at its height, or moves to the height of the lowest sphere of its foot.
    Level,
    Friction,
    PredSim,
}

impl ChangedBy {
    /// The text for this rule in the column `equation` of reports and JSON.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Equation(numbers) => numbers,
            Self::Given => "given",
            Self::Follow => "follow",
            Self::Fit => "fit",
            Self::Level => "level",
            Self::Friction => "friction",
            Self::PredSim => "predsim",
        }
    }

    /// The rule in words, for messages.
    fn in_words(self) -> String {
        match self {
            Self::Equation(numbers) => format!("equation ({numbers})"),
            Self::Given => "what the request says".to_owned(),
            Self::Follow => "the sizes of the bodies".to_owned(),
            rule => format!("the rule '{}'", rule.as_str()),
        }
    }
}

impl NumberChange {
    /// The key of the number in digests of the note, and the new value.
    pub(crate) fn key_and_value(&self) -> (ValueKey, f64) {
        (ValueKey::from((&self.slot, self.property)), self.to)
    }

    /// Checks that the new number may be written.
    ///
    /// # Errors
    /// The number is not finite, or outside the domain in which the contact laws hold. The fault has its place and its
    /// origin.
    pub(crate) fn check(&self) -> Result<()> {
        refuse_bad_number(self.to, self.property, || self.origin_of_value()).map_err(|fault| self.at(fault))
    }

    /// The text that is written for the new number.
    pub(crate) fn text(&self) -> Result<String> {
        let text = match self.radii_m {
            None => number_text(self.to, self.property, || self.origin_of_value()),
            Some([_, new]) => triple_text(new, self.slot.tag, || self.origin_of_value()),
        };
        text.map_err(|fault| self.at(fault))
    }

    /// OpenSim's name of the property that changes.
    pub fn name(&self) -> &'static str {
        if self.radii_m.is_some() { "radii" } else { self.property.as_str() }
    }

    /// The present and the new value, or the three radii of an ellipsoid, each number written by `number`.
    pub fn values(&self, number: impl Fn(f64) -> String) -> [String; 2] {
        match self.radii_m {
            Some(radii) => radii.map(|radii| radii.map(&number).join(" ")),
            None => [self.from, self.to].map(number),
        }
    }

    /// `fault` with the line and path of the number.
    pub(crate) fn at(&self, fault: Fault) -> Fault {
        Fault::at(fault.kind, self.slot.offset).at_element(self.path.clone()).in_file(self.slot.file)
    }

    /// How the new value was computed, in words.
    fn origin_of_value(&self) -> String {
        match self.factor {
            Some(factor) => {
                format!("{} times {}, {}", readable(self.from), readable(factor), self.by.in_words())
            }
            None => format!("{}, in the place of {}", self.by.in_words(), readable(self.from)),
        }
    }
    /// The file that has the number.
    pub fn file(&self) -> FileId {
        self.slot.file
    }
}

impl PlaceChange {
    /// The text that is written for the new place.
    ///
    /// # Errors
    /// A coordinate is not finite. The fault has the place of the element and the origin of the value.
    pub(crate) fn text(&self) -> Result<String> {
        let from = || self.from.map(readable).join(" ");
        let origin = || format!("{}, in the place of {}", self.by.in_words(), from());
        triple_text(self.to, self.slot.tag, origin).map_err(|fault| {
            Fault::at(fault.kind, self.slot.offset).at_element(self.path.clone()).in_file(self.slot.file)
        })
    }

    /// The file that has the place.
    pub fn file(&self) -> FileId {
        self.slot.file
    }
}

/// The text of the new `value` of `property`; `origin` describes the source of the value, for the error message.
///
/// # Errors
/// A value that is not finite, or outside the domain of the contact laws ([`FaultKind::NewValue`]).
pub(crate) fn number_text(value: f64, property: Property, origin: impl FnOnce() -> String) -> Result<String> {
    refuse_bad_number(value, property, origin)?;
    Ok(shortest(value))
}

/// Whether the new `value` of `property` may be written.
fn refuse_bad_number(value: f64, property: Property, origin: impl FnOnce() -> String) -> Result<()> {
    if property.allows(value) {
        return Ok(());
    }
    Err(refused_number(property.as_str(), value, property.domain(), origin()))
}

/// The text of three numbers, a place or an orientation; `name` is their name in the error message.
///
/// # Errors
/// One of the numbers is not finite ([`FaultKind::NewValue`]).
pub(crate) fn triple_text(values: [f64; 3], name: &str, origin: impl FnOnce() -> String) -> Result<String> {
    match values.into_iter().find(|value| !value.is_finite()) {
        Some(value) => Err(refused_number(name, value, "three finite numbers", origin())),
        None => Ok(values.map(shortest).join(" ")),
    }
}

/// The fault that a new value may not be written.
fn refused_number(property: &str, value: f64, expected: &'static str, origin: String) -> Fault {
    Fault::new(FaultKind::NewValue { property: property.to_owned(), value, expected, origin })
}

/// The factor of a property by the paper's rules, and the number of the equation.
pub(crate) fn property_factor(
    property: Property,
    ratios: &Ratios,
    by: DissipationBy,
) -> Option<(f64, ChangedBy)> {
    let by_mass = by == DissipationBy::Mass;
    Some(match property {
        Property::Stiffness => (ratios.plane_strain_modulus(), ChangedBy::Equation("10")),
        Property::Dissipation if by_mass => (ratios.dissipation_by_mass(), ChangedBy::Equation("14")),
        Property::Dissipation => (ratios.dissipation(), ChangedBy::Equation("14")),
        Property::ConstantContactForce => (ratios.constant_contact_force(), ChangedBy::Equation("C.2")),
        Property::HertzSmoothing => (ratios.hertz_smoothing(), ChangedBy::Equation("C.5")),
        // (C.9) keeps its shape if bv and α both follow the same speed.
        Property::HuntCrossleySmoothing if by_mass => {
            (ratios.dissipation_by_mass(), ChangedBy::Equation("C.10"))
        }
        Property::HuntCrossleySmoothing => (ratios.hunt_crossley_smoothing(), ChangedBy::Equation("C.10")),
        Property::TransitionVelocity => (ratios.transition_velocity(), ChangedBy::Friction),
        Property::ViscousFriction => (ratios.viscous_friction(), ChangedBy::Friction),
        _ => return None,
    })
}

/// The change from the gravity that contacts were made for to the gravity that they are scaled to.
pub(crate) struct GravityChange {
    /// γ = g_b/g_a; 1 without a target.
    pub(crate) ratio: f64,
    pub(crate) words: String,
}

impl GravityChange {
    /// The change from gravity `now` to `target`; `now_for` is for the error if `now` is not known.
    ///
    /// # Errors
    /// `target` is not above 0, or `target` is given and `now` is not known.
    pub(crate) fn new(now: Option<f64>, target: Option<f64>, now_for: GravityFor) -> Result<Self> {
        let Some(target) = target else { return Ok(Self { ratio: 1.0, words: String::new() }) };
        if !(target.is_finite() && target > 0.0) {
            return Err(Fault::new(FaultKind::BadInput {
                input: Input::TargetGravity,
                value: target,
                expected: "an acceleration in m/s2 above 0",
            }));
        }
        match now {
            Some(now) if now.is_finite() && now > 0.0 => {
                let ratio = target / now;
                let ([from, to], factor) = ([now, target].map(readable), four_significant(ratio));
                Ok(Self { ratio, words: format!("; gravity {from} -> {to} m/s2 (x{factor})") })
            }
            _ => Err(Fault::new(MissingFact::Gravity { purpose: now_for })),
        }
    }
}
