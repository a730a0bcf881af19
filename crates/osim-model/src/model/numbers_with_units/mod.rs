//! Numbers of a model with mass, length or time in their unit, without those of contacts: muscles, ligaments, springs, bushings, actuators
//! and bodies.

mod kind;

use std::collections::{BTreeMap, HashMap};

use crate::model::numbers_with_units::kind::{SizedKindRule, SizedProperty, sized_properties, why_not_read};
use crate::model::{ComponentId, Document, Model};
use crate::xml::{ElementId, opensim_text};
pub use kind::{Dimension, SizedKind};

/// A number of a model that changes with body size, and the object that has it.
#[derive(Debug, Clone, PartialEq)]
pub struct SizedValue {
    pub kind: SizedKind,
    /// The name of the object that has the number.
    pub owner: String,
    /// The property of the object and the index in the property, for an object with several numbers of one kind.
    pub part: (&'static str, usize),
    /// The number in the unit of its kind; finite.
    pub value: f64,
}

/// Objects of one class whose numbers are not read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotRead {
    /// The OpenSim class, or a part of a file.
    pub class: String,
    pub count: usize,
    /// Why their numbers are not read.
    pub why: &'static str,
}

impl NotRead {
    /// The record that the numbers of `count` objects of `class` are not read, and `why`.
    pub fn new(class: &str, count: usize, why: &'static str) -> Self {
        Self { class: class.to_owned(), count, why }
    }
}

/// All numbers of a model with mass, length or time in their unit, except those of contacts.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SizedValues {
    pub values: Vec<SizedValue>,
    pub not_read: Vec<NotRead>,
}

impl SizedValues {
    /// The numbers of `model` that change with body size, as OpenSim reads them: from the object, else `<defaults>`, else the default of
    /// the class. Numbers that are not finite are left out.
    ///
    /// ```
    /// use osim_model::{Model, SizedKind, SizedValues};
    ///
    /// let text = r#"<OpenSimDocument Version="40000"><Model><ForceSet><objects>
    ///     <Thelen2003Muscle name="soleus_r"><max_isometric_force>3549</max_isometric_force></Thelen2003Muscle>
    /// </objects></ForceSet></Model></OpenSimDocument>"#;
    /// let found = SizedValues::of(&Model::parse(text)?);
    /// let first = &found.values[0];
    /// assert_eq!((first.kind, first.owner.as_str(), first.value), (SizedKind::MaxIsometricForce, "soleus_r", 3549.0));
    /// # Ok::<(), osim_model::Fault>(())
    /// ```
    pub fn of(model: &Model) -> Self {
        let mut reader = SizedValueReader { model, angles: None, not_read: BTreeMap::new() };
        let components = model.components();
        let mut values = Vec::new();
        for (id, _) in components.tree.iter() {
            reader.add(id, &mut values);
        }
        let not_read =
            reader.not_read.into_iter().map(|((class, why), count)| NotRead { class, count, why }).collect();
        Self { values, not_read }
    }
}

/// Why the numbers of a force on a coordinate are not read.
const FORCE_ON_UNKNOWN_COORDINATE: &str = "coordinates that are missing, or neither an angle nor a length";

/// Reads the numbers of a model that change with body size, one object after the other.
struct SizedValueReader<'m> {
    model: &'m Model,
    /// Whether each coordinate is an angle. Read when the first force on a coordinate is found.
    angles: Option<HashMap<&'m str, Option<bool>>>,
    not_read: BTreeMap<(String, &'static str), usize>,
}

impl SizedValueReader<'_> {
    /// Adds the numbers of one component.
    fn add(&mut self, id: ComponentId, values: &mut Vec<SizedValue>) {
        let components = self.model.components();
        let class = components.tag(id);
        if class == "Body" {
            values.extend(inertia_value(self.model, id));
            return;
        }
        if let Some(why) = why_not_read(class) {
            *self.not_read.entry((class.to_owned(), why)).or_default() += 1;
        }
        let properties = sized_properties(class);
        if properties.is_empty() {
            return;
        }
        let (document, element) = (components.document_of(id), components.element(id));
        let acts_on_coordinate =
            properties.iter().any(|one| matches!(one.kind, SizedKindRule::ByCoordinate(..)));
        let is_angle = acts_on_coordinate.then(|| self.is_angle(document, element)).flatten();
        if acts_on_coordinate && is_angle.is_none() {
            *self.not_read.entry((class.to_owned(), FORCE_ON_UNKNOWN_COORDINATE)).or_default() += 1;
        }
        let owner = components.name(id).into_owned();
        for property in properties {
            let Some(kind) = kind_of_property(property.kind, is_angle) else { continue };
            let found = numbers(document, element, property).into_iter().enumerate();
            for (place, value) in found.filter(|(_, value)| value.is_finite()) {
                values.push(SizedValue { kind, owner: owner.clone(), part: (property.tag, place), value });
            }
        }
    }

    /// Whether the coordinate of a force is an angle; `None` if it is not known, or is neither an angle nor a length.
    fn is_angle(&mut self, document: &Document, force: ElementId) -> Option<bool> {
        let named = document.tree().text_of(document.property_element(force, "coordinate")?);
        let name = opensim_text::trimmed(&named).rsplit('/').next()?;
        let model = self.model;
        let angles = self.angles.get_or_insert_with(|| model.coordinates_are_angles());
        angles.get(name).copied().flatten()
    }
}

fn kind_of_property(rule: SizedKindRule, is_angle: Option<bool>) -> Option<SizedKind> {
    match rule {
        SizedKindRule::Always(kind) => Some(kind),
        SizedKindRule::ByCoordinate(turning, _) if is_angle? => turning,
        SizedKindRule::ByCoordinate(_, shifting) => Some(shifting),
    }
}

fn inertia_value(model: &Model, body: ComponentId) -> Option<SizedValue> {
    let components = model.components();
    let value = crate::model::body_sizes::inertia_trace(components, body)?;
    let owner = components.name(body).into_owned();
    (!components.is_ground(body) && value.is_finite()).then_some(SizedValue {
        kind: SizedKind::Inertia,
        owner,
        part: ("inertia", 0),
        value,
    })
}

/// The numbers of a property, up to the number that it should have.
fn numbers(document: &Document, object: ElementId, property: &SizedProperty) -> Vec<f64> {
    let tree = document.tree();
    let read = |element| {
        if property.count == 1 {
            return match opensim_text::number(&tree.raw_text(element)) {
                Ok(number) | Err(opensim_text::NumberFault::Prefix { opensim_reads: number }) => {
                    Some(vec![number])
                }
                Err(_) => None,
            };
        }
        opensim_text::triple(&tree.text_of(element)).map(|found| found.to_vec())
    };
    let own = tree.child(object, property.tag).and_then(read);
    let inherited = || document.inherited_element(object, property.tag).and_then(read);
    own.or_else(inherited).unwrap_or_else(|| vec![property.default; property.count])
}
