//! Effective numbers: what OpenSim uses, and where it is.

use std::ops::Range;

use crate::model::fault::{Fault, FaultKind};
use crate::model::property::Property;
use crate::xml::opensim_text::NumberFault;

/// Where an effective value comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Origin {
    /// The object's own element.
    Element,
    /// The class's object in the document's `<defaults>`.
    Defaults,
    /// OpenSim's class default.
    ClassDefault,
}

impl Origin {
    /// As in the JSON.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Element => "element",
            Self::Defaults => "defaults",
            Self::ClassDefault => "class default",
        }
    }
}

/// An effective number: what OpenSim uses, where it is and whether its text is one plain number.
///
/// ```
/// use osim_model::{Model, Origin, Property, SetId};
///
/// # let text = include_str!("../../tests/data/one_foot.osim");
/// let model = Model::parse(text)?;
/// let force = &model.forces()[0];
/// // <stiffness>1000000</stiffness>
/// let stiffness = force.value(SetId::FIRST, Property::Stiffness).expect("every force has it");
/// assert_eq!((stiffness.checked()?, stiffness.origin), (1e6, Origin::Element));
/// assert_eq!(stiffness.span.clone().map(|span| &text[span]), Some("1000000"));
/// // There is no <static_friction>: OpenSim uses 0.
/// let friction = force.value(SetId::FIRST, Property::StaticFriction).expect("every force has it");
/// assert_eq!((friction.number, friction.origin), (0.0, Origin::ClassDefault));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Value {
    /// Which property.
    pub property: Property,
    /// What OpenSim reads, in the unit of `property`.
    pub number: f64,
    /// Where it comes from.
    pub origin: Origin,
    /// The number's bytes in its file, where the object's own element has it.
    pub span: Option<Range<usize>>,
    /// Why the text is not a plain number, if it is not; then `number` is still what OpenSim reads.
    pub fault: Option<NumberFault>,
    /// As written (empty for a class default).
    pub text: String,
    /// First byte to point at, from 0: the number, or the object that lacks it.
    pub offset: usize,
}

impl Value {
    /// The number, if it can be scaled: one plain number within its domain.
    ///
    /// # Errors
    /// The fault, over the bytes of the number.
    pub fn checked(&self) -> Result<f64, Fault> {
        let over = |kind: FaultKind| match &self.span {
            Some(span) => Fault::over(kind, span.clone()),
            None => Fault::at(kind, self.offset),
        };
        if let Some(fault) = &self.fault {
            let (property, text) = (self.property.name().to_owned(), self.text.clone());
            return Err(over(FaultKind::Number { property, text, fault: fault.clone() }));
        }
        if !self.property.allows(self.number) {
            return Err(over(FaultKind::Domain {
                property: self.property.name().to_owned(),
                value: self.number,
                expected: self.property.domain(),
            }));
        }
        Ok(self.number)
    }
}
