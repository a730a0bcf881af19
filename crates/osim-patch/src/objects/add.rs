//! Adds contacts to a model.

use foldhash::HashMap;
use osim_model::{Body, Fault, FaultKind, HalfSpace, Model, Note, Property, Result, SphereId};

use crate::edit::model_with_edits;
use crate::objects::nodes::{self, NamesInList};
use crate::objects::rebuilt::{
    EarlierNote, ObjectAction, ObjectChange, RebuiltModel, TakenNames, refuse_non_utf8_name,
};
use crate::objects::sets::{FORCE_SET, GEOMETRY_SET, refuse_partial_model};
use crate::{ContactLayout, Plan};

/// The letter for the floor in a note's list of elements that the program made.
pub(super) const MARK_OF_MADE_FLOOR: char = 'h';
/// The name of a floor that the program adds.
const NAME_OF_FLOOR: &str = "floor";

/// `model` with the contacts of `layout`: spheres, one force for each sphere, and a floor if the model has none. Every other byte
/// stays. A name that the model already uses gets a number; `layout` then has the new names.
///
/// ```
/// use osim_model::{ForceKind, Model};
/// use osim_patch::{ContactLayout, NewContact, add_contacts};
///
/// let text = r#"<OpenSimDocument Version="40000"><Model name="leg"><BodySet><objects>
///   <Body name="foot_r"><mass>1</mass></Body></objects></BodySet></Model></OpenSimDocument>"#;
/// let model = Model::parse(text)?;
/// let mut heel = NewContact::new(ForceKind::SmoothSphereHalfSpace, "heel_force", "heel");
/// heel.body = "foot_r".into();
/// heel.radius_m = 0.03;
/// let mut layout = ContactLayout::default();
/// layout.contacts.push(heel);
///
/// let rebuilt = add_contacts(&model, &mut layout)?;
/// let force = &rebuilt.model().forces()[0];
/// assert_eq!((force.name.as_str(), rebuilt.model().spheres()[0].radius_m()?), ("heel_force", 0.03));
/// # Ok::<(), osim_model::Fault>(())
/// ```
///
/// # Errors
/// - A file that is a set and no model, or a model with a set in another file.
/// - A body that the model does not have ([`FaultKind::UnknownBody`]), or that is welded to ground.
/// - A `constant_contact_force` of 0, a name that OpenSim refuses, a radius that is not above 0, or several half-spaces that could
///   be the floor.
pub fn add_contacts(model: &Model, layout: &mut ContactLayout) -> Result<RebuiltModel> {
    refuse_partial_model(model)?;
    layout.check()?;
    let (mut names, list) = (TakenNames::of(model), NamesInList::of(model));
    let document = model.document();
    let (made_floor, plane) = match find_floor(model)? {
        Some(own) => (None, own.path),
        None => {
            let name = names.reserve(if layout.floor.is_empty() { NAME_OF_FLOOR } else { &layout.floor })?;
            let path = format!("/contactgeometryset/{name}");
            (Some(name), path)
        }
    };
    refuse_non_utf8_name(model, &plane)?;
    let bodies: HashMap<&str, &Body> =
        model.bodies().iter().rev().map(|body| (body.name.as_str(), body)).collect();
    let (mut geometry, mut forces, mut objects) = (Vec::new(), Vec::new(), Vec::new());
    let added =
        |class, of: [&str; 2], body: Option<&str>| ObjectChange::new(ObjectAction::Added, class, of, body);
    if let Some(name) = &made_floor {
        geometry.push(nodes::floor(document, name, model.up().into())?);
        objects.push(added("ContactHalfSpace", [name, &plane], None));
    }
    let mut force_objects = Vec::new();
    for contact in &mut layout.contacts {
        let Some(body) = bodies.get(contact.body.as_str()) else {
            return Err(Fault::new(FaultKind::UnknownBody { body: contact.body.clone() }));
        };
        if body.fixed {
            // The contacts would carry nothing.
            let text = format!(
                "only WeldJoints are between body {} and ground, so that its spheres would be scenery and carry nothing: put them on \
                 a body that moves, or give this one another joint in OpenSim",
                body.name
            );
            return Err(Fault::refused(text).at_element(body.path.clone()));
        }
        refuse_non_utf8_name(model, &body.path)?;
        contact.sphere = names.reserve(&contact.sphere)?;
        contact.force = names.reserve(&contact.force)?;
        let sphere = format!("/contactgeometryset/{}", contact.sphere);
        let frame = nodes::frame_element(document, &body.name, &body.path);
        geometry.push(nodes::sphere_element(frame, contact)?);
        objects.push(added("ContactSphere", [&contact.sphere, &sphere], Some(&contact.body)));
        let origin = |_: Property| format!("the numbers that {} is to have", contact.force);
        let values = (contact.values.as_slice(), &origin as &dyn Fn(Property) -> String);
        let surfaces: [&str; 2] = [&sphere, &plane];
        forces.push(nodes::force(document, contact.kind, &contact.force, surfaces, values, true, &list)?);
        let path = format!("/forceset/{}", contact.force);
        force_objects.push(added(contact.kind.as_str(), [&contact.force, &path], Some(&contact.body)));
    }
    objects.extend(force_objects);
    let (tree, root) = (document.tree(), document.data_root());
    let mut made: String = made_floor.iter().map(|_| MARK_OF_MADE_FLOOR).collect();
    let mut edits = FORCE_SET.add(tree, root, &forces, &mut made);
    edits.extend(GEOMETRY_SET.add(tree, root, &geometry, &mut made));
    let beside_others = !model.forces().is_empty();
    if !beside_others {
        made.push(Note::ALL_ADDED_MARK);
    }
    let mut rebuilt = RebuiltModel::new(model_with_edits(model, edits)?, objects, made);
    rebuilt.earlier_note = EarlierNote::KeptBeside;
    if beside_others {
        rebuilt.added = layout.contacts.iter().map(|contact| Note::operation_text(&contact.force)).collect();
    }
    Ok(rebuilt)
}

/// A sphere that a plan adds, with the numbers that are written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewSphere<'p> {
    pub name: &'p str,
    pub path: &'p str,
    /// Name of the body to which the sphere is attached.
    pub body: &'p str,
    /// Centre of the new sphere in the frame of its body, m.
    pub centre_m: [f64; 3],
    pub radius_m: f64,
}

impl Plan {
    /// The spheres that the plan adds, with the locations and radii that are written.
    pub fn new_spheres(&self) -> Vec<NewSphere<'_>> {
        let Some(rebuilt) = &self.rebuilt else { return Vec::new() };
        let built = rebuilt.model();
        let ids: HashMap<&str, SphereId> =
            built.spheres().iter().map(|sphere| (sphere.path.as_str(), sphere.id)).collect();
        let moved: HashMap<&str, [f64; 3]> =
            self.moves.iter().map(|place| (place.path.as_str(), place.to)).collect();
        let radii = self.changes.iter().filter(|change| change.property == Property::Radius);
        let radii: HashMap<&str, f64> = radii.map(|change| (change.path.as_str(), change.to)).collect();
        let added = rebuilt.objects.iter().filter(|object| object.action == ObjectAction::Added);
        let spheres = added.filter_map(|object| {
            let id = *ids.get(object.path.as_str())?;
            let path = object.path.as_str();
            Some(NewSphere {
                name: &object.name,
                path,
                body: object.body.as_deref()?,
                // New spheres are placed in the frames of bodies.
                centre_m: moved.get(path).copied().or_else(|| Some(built.centre_m(id)?.into()))?,
                radius_m: radii.get(path).copied().or_else(|| built.sphere(id)?.radius_m().ok())?,
            })
        });
        spheres.collect()
    }
}

/// The floor of `model`: its only half-space on ground that faces straight up; `None` if it has none.
pub(super) fn find_floor(model: &Model) -> Result<Option<HalfSpace>> {
    let mut floors = model.floors().into_iter();
    let Some(first) = floors.next() else { return Ok(None) };
    let others: Vec<String> = floors.map(|plane| plane.name).collect();
    if others.is_empty() {
        return Ok(model.half_spaces().into_iter().find(|plane| plane.name == first.name));
    }
    Err(Fault::refused(format!(
        "{} and {} both could be the floor (on ground, facing up): remove or turn all but one in OpenSim, then do this again",
        first.name,
        others.join(", ")
    )))
}
