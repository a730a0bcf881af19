//! The properties of contacts that are read and changed, the OpenSim classes that have them, and their effective values.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

use contact_scaling::SmoothingValues;

use crate::messages::named;
use crate::model::fault::{Fault, FaultKind, Result};
use crate::model::names_and_sides::nearest_names;
use crate::xml::opensim_text::NumberFault;

named! {
    /// A numeric property of a contact force or contact sphere.
    ///
    /// ```
    /// use osim_model::Property;
    ///
    /// let property: Property = "constant_contact_force".parse().unwrap();
    /// assert_eq!((property, property.unit()), (Property::ConstantContactForce, "m2"));
    /// ```
    pub enum Property {
        /// `stiffness`, the plane strain modulus E₁* in N/m².
        Stiffness = "stiffness",
        /// `dissipation`, α in s/m.
        Dissipation = "dissipation",
        /// `static_friction`, dimensionless.
        StaticFriction = "static_friction",
        /// `dynamic_friction`, dimensionless.
        DynamicFriction = "dynamic_friction",
        /// `viscous_friction` in s/m.
        ViscousFriction = "viscous_friction",
        /// `transition_velocity` in m/s.
        TransitionVelocity = "transition_velocity",
        /// `constant_contact_force`, cf: a squared indentation in m².
        ConstantContactForce = "constant_contact_force",
        /// `hertz_smoothing`, bd in 1/m.
        HertzSmoothing = "hertz_smoothing",
        /// `hunt_crossley_smoothing`, bv in s/m.
        HuntCrossleySmoothing = "hunt_crossley_smoothing",
        /// `radius` of a `ContactSphere`, in m.
        Radius = "radius",
        /// `mass` of a `Body`, in kg: read, never written.
        Mass = "mass",
    }
}

impl Property {
    /// Every property that can be changed, in the order in which reports list them: first the parameters of a `ContactParameters`, then the
    /// others of a smooth force.
    pub fn changeable() -> impl Iterator<Item = Self> {
        Self::ALL.iter().copied().filter(|property| *property != Self::Mass)
    }

    /// SI unit of the property, in the spelling of tables: `N/m2`.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Stiffness => "N/m2",
            Self::Dissipation | Self::ViscousFriction | Self::HuntCrossleySmoothing => "s/m",
            Self::StaticFriction | Self::DynamicFriction => "",
            Self::TransitionVelocity => "m/s",
            Self::ConstantContactForce => "m2",
            Self::HertzSmoothing => "1/m",
            Self::Radius => "m",
            Self::Mass => "kg",
        }
    }

    /// Whether `value` is in the domain in which the contact laws hold. Checked before any scaling.
    pub fn allows(self, value: f64) -> bool {
        value.is_finite() && if self.may_be_zero() { value >= 0.0 } else { value > 0.0 }
    }

    pub const fn domain(self) -> &'static str {
        if self.may_be_zero() { "a finite number, 0 or more" } else { "a finite number above 0" }
    }

    const fn may_be_zero(self) -> bool {
        !matches!(self, Self::Stiffness | Self::HertzSmoothing | Self::HuntCrossleySmoothing | Self::Radius)
    }
}

impl fmt::Display for Property {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl FromStr for Property {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::changeable().find(|property| property.as_str() == text).ok_or_else(|| {
            match probable_names(text) {
                names if names.is_empty() => {
                    let names: Vec<&str> = Self::changeable().map(Self::as_str).collect();
                    format!("there is no property '{text}', expected one of {}", names.join(", "))
                }
                names => format!("there is no property '{text}': did you mean {}?", names.join(" or ")),
            }
        })
    }
}

/// Names that the caller probably meant by `text`: names with nearly the same spelling, else names that contain it or have the same ending.
fn probable_names(text: &str) -> Vec<&'static str> {
    /// The fewest letters of a text that is searched inside the names of properties.
    const FEWEST_LETTERS_OF_PART: usize = 5;

    let flat = |text: &str| text.to_lowercase().replace(['-', '_', ' '], "");
    let end = |text: &str| flat(text.rsplit(['-', '_', ' ']).next().unwrap_or_default());
    let (typed, ending) = (flat(text), end(text));
    let names = || Property::changeable().map(Property::as_str);
    let nearest = nearest_names(text, names(), 2);
    if !nearest.is_empty() {
        return nearest;
    }
    let is_part = |name: &&str| {
        (typed.len() >= FEWEST_LETTERS_OF_PART && flat(name).contains(&typed))
            || (ending.len() >= FEWEST_LETTERS_OF_PART && end(name) == ending)
    };
    names().filter(is_part).collect()
}

// The OpenSim classes whose numbers are read and written: their defaults, and the order of their elements.

named! {
    /// An OpenSim class of which this program reads numbers.
    pub enum Class {
        HuntCrossleyForce = "HuntCrossleyForce",
        ContactParameters = "HuntCrossleyForce::ContactParameters",
        SmoothSphereHalfSpaceForce = "SmoothSphereHalfSpaceForce",
        ContactSphere = "ContactSphere",
        ContactEllipsoid = "ContactEllipsoid",
        ContactHalfSpace = "ContactHalfSpace",
        Body = "Body",
    }
}

/// A list of tags in one row.
macro_rules! tags {
    ($($tag:literal)*) => { &[$($tag),*] };
}

impl Class {
    /// The value that OpenSim 4.6 uses if neither the object nor `<defaults>` has the property.
    pub const fn default(self, property: Property) -> f64 {
        match (self, property) {
            (Self::SmoothSphereHalfSpaceForce, Property::Stiffness) => 1.0,
            (_, Property::Mass) => f64::NAN,
            (_, Property::TransitionVelocity) => 0.01,
            (_, Property::ConstantContactForce) => SmoothingValues::OPENSIM_DEFAULT.constant_contact_force,
            (_, Property::HertzSmoothing) => SmoothingValues::OPENSIM_DEFAULT.hertz_smoothing,
            (_, Property::HuntCrossleySmoothing) => SmoothingValues::OPENSIM_DEFAULT.hunt_crossley_smoothing,
            _ => 0.0,
        }
    }

    /// The names of all child elements of this class, in the order in which OpenSim writes them. A missing element is inserted in this
    /// order.
    pub const fn element_order(self) -> &'static [&'static str] {
        match self {
            Self::HuntCrossleyForce => tags![
                "isDisabled" "appliesForce" "HuntCrossleyForce::ContactParametersSet" "transition_velocity"
            ],
            Self::ContactParameters => tags![
                "geometry" "stiffness" "dissipation" "static_friction" "dynamic_friction"
                "viscous_friction"
            ],
            Self::SmoothSphereHalfSpaceForce => tags![
                "socket_sphere" "socket_half_space" "socket_sphere_frame" "socket_half_space_frame"
                "appliesForce" "contact_sphere_radius" "contact_sphere_location"
                "contact_half_space_location" "contact_half_space_orientation" "stiffness" "dissipation"
                "static_friction" "dynamic_friction" "viscous_friction" "transition_velocity"
                "constant_contact_force" "derivative_smoothing" "hertz_smoothing" "hunt_crossley_smoothing"
                "force_visualization_radius" "force_visualization_scale_factor"
            ],
            Self::ContactSphere => tags![
                "socket_frame" "socket_frame_connectee_name" "connector_frame_connectee_name" "connectors"
                "body_name" "location" "orientation" "display_preference" "color" "Appearance" "radius"
            ],
            Self::ContactEllipsoid => tags![
                "socket_frame" "location" "orientation" "Appearance" "radii"
            ],
            Self::ContactHalfSpace => tags![
                "socket_frame" "socket_frame_connectee_name" "connector_frame_connectee_name" "connectors"
                "body_name" "location" "orientation" "display_preference" "color" "Appearance"
            ],
            Self::Body => &[],
        }
    }

    /// Numeric properties of a contact force of this class, in OpenSim's order.
    pub const fn parameters(self) -> &'static [Property] {
        match self {
            Self::HuntCrossleyForce => &[Property::TransitionVelocity],
            Self::ContactParameters => Property::ALL.split_at(5).0,
            Self::SmoothSphereHalfSpaceForce => Property::ALL.split_at(9).0,
            Self::ContactSphere | Self::ContactEllipsoid => &[Property::Radius],
            Self::ContactHalfSpace => &[],
            Self::Body => &[Property::Mass],
        }
    }
}

named! {
    /// Where OpenSim finds the value of a property.
    pub enum ValueOrigin {
        /// The element of the property in the object itself.
        Element = "element",
        /// The object of the same class in the document's `<defaults>`.
        Defaults = "defaults",
        /// The default of the OpenSim class.
        ClassDefault = "class default",
    }
}

/// An effective number of a property: the number that OpenSim uses, its place, and whether its text is one plain number.
///
/// ```
/// use osim_model::{Model, ValueOrigin, Property, SetId};
///
/// # let text = include_str!("../../tests/data/one_foot.osim");
/// let model = Model::parse(text)?;
/// let force = &model.forces()[0];
/// // <stiffness>1000000</stiffness>
/// let stiffness = force.value(SetId::FIRST, Property::Stiffness).expect("every force has it");
/// assert_eq!((stiffness.checked()?, stiffness.origin), (1e6, ValueOrigin::Element));
/// assert_eq!(stiffness.span.clone().map(|span| &text[span]), Some("1000000"));
/// // There is no <static_friction>: OpenSim uses 0.
/// let friction = force.value(SetId::FIRST, Property::StaticFriction).expect("every force has it");
/// assert_eq!((friction.number, friction.origin), (0.0, ValueOrigin::ClassDefault));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    pub property: Property,
    /// The number that OpenSim reads, in the unit of `property`.
    pub number: f64,
    pub origin: ValueOrigin,
    /// The bytes of the number in its file; `None` if the object has no such element.
    pub span: Option<Range<usize>>,
    /// Why the text is not a plain number; `None` if it is. `number` is still what OpenSim reads.
    pub fault: Option<NumberFault>,
    /// The number as the file writes it; empty for the default of a class.
    pub text: String,
    /// First byte to show in an error, from 0: that of the number, or of the object without the number.
    pub offset: usize,
}

impl Value {
    /// The number, if scaling can use it: one plain number in the domain of the property.
    pub fn checked(&self) -> Result<f64> {
        let at_value = |kind: FaultKind| match &self.span {
            Some(span) => Fault::at_span(kind, span.clone()),
            None => Fault::at(kind, self.offset),
        };
        if let Some(fault) = &self.fault {
            let (property, text) = (self.property.as_str().to_owned(), self.text.clone());
            return Err(at_value(FaultKind::Number { property, text, fault: fault.clone() }));
        }
        if !self.property.allows(self.number) {
            return Err(at_value(FaultKind::Domain {
                property: self.property.as_str().to_owned(),
                value: self.number,
                expected: self.property.domain(),
            }));
        }
        Ok(self.number)
    }
}

#[cfg(test)]
mod tests {
    use super::probable_names;

    #[test]
    fn a_misspelled_property_suggests_the_right_one() {
        let smoothing = ["hertz_smoothing", "hunt_crossley_smoothing"];
        assert_eq!(probable_names("hertz_smothing"), ["hertz_smoothing"]);
        assert_eq!(probable_names("hertz-smoothing"), ["hertz_smoothing"]);
        assert_eq!(probable_names("HertzSmoothing"), ["hertz_smoothing"]);
        assert_eq!(probable_names("smoothing"), smoothing);
        assert_eq!(probable_names("derivative_smoothing"), smoothing);
        assert_eq!(probable_names("friction"), ["static_friction", "dynamic_friction", "viscous_friction"]);
        assert_eq!(probable_names("stifness"), ["stiffness"]);
        assert!(
            probable_names("k").is_empty()
                && probable_names("damping").is_empty()
                && probable_names("").is_empty()
        );
    }
}
