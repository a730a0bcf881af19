//! Contacts for a model that has none.

use foldhash::HashMap;
use osim_model::{Body, Document, Fault, FaultKind, HalfSpace, Model, Note, Property};

use super::floor::floor;
use super::layout::{Layout, NewContact};
use super::names::{Names, refuse_misread};
use super::rebuilt::{Deed, EarlierNote, ObjectChange, Rebuilt};
use super::sets::{FORCE_SET, GEOMETRY_SET};
use super::spelling::{self, Carrier, InList, Surfaces, Values};
use super::whole::refuse_parts;
use crate::edit::edited;
use crate::node::Node;

/// A letter in a note's list of what was made: the floor.
pub(super) const MADE_FLOOR: char = 'h';
const FLOOR: &str = "floor";

/// `model` with the contacts of `layout`: spheres, one force for each, and a floor where it has none. Every other byte stays.
/// Names that are taken get a number; `layout` says the names that were given.
///
/// ```
/// use osim_model::{ForceKind, Model};
/// use osim_patch::{Layout, NewContact, add_contacts};
///
/// let text = r#"<OpenSimDocument Version="40000"><Model name="leg"><BodySet><objects>
///   <Body name="foot_r"><mass>1</mass></Body></objects></BodySet></Model></OpenSimDocument>"#;
/// let model = Model::parse(text)?;
/// let mut heel = NewContact::new(ForceKind::SmoothSphereHalfSpace, "heel_force", "heel");
/// heel.body = "foot_r".into();
/// heel.radius_m = 0.03;
/// let mut layout = Layout::default();
/// layout.contacts.push(heel);
///
/// let rebuilt = add_contacts(&model, &mut layout)?;
/// let force = &rebuilt.model().forces()[0];
/// assert_eq!((force.name.as_str(), rebuilt.model().spheres()[0].radius_m()?), ("heel_force", 0.03));
/// # Ok::<(), osim_model::Fault>(())
/// ```
///
/// # Errors
/// - A set that stands alone, or one in another file.
/// - A body that the model does not have ([`FaultKind::UnknownBody`]), or that is welded to ground.
/// - A `constant_contact_force` of 0, a name that OpenSim refuses, a radius that is not above 0, or several half-spaces that could be the floor.
pub fn add_contacts(model: &Model, layout: &mut Layout) -> Result<Rebuilt, Fault> {
    refuse_parts(model)?;
    layout.check()?;
    let (mut names, list) = (Names::of(model), InList::of(model));
    let version = model.document().version();
    let own = floor(model)?;
    let made_floor = match &own {
        Some(_) => None,
        None => Some(names.take(if layout.floor.is_empty() { FLOOR } else { &layout.floor })?),
    };
    let plane = plane_path(own.as_ref(), made_floor.as_deref());
    refuse_misread(model, &plane)?;
    let bodies: HashMap<&str, &Body> =
        model.bodies().iter().rev().map(|body| (body.name.as_str(), body)).collect();
    let (mut geometry, mut forces, mut objects) = (Vec::new(), Vec::new(), Vec::new());
    if let Some(name) = &made_floor {
        geometry.push(spelling::floor(version, name, model.up())?);
        objects.push(added("ContactHalfSpace", name, &plane, None));
    }
    let mut force_objects = Vec::new();
    for contact in &mut layout.contacts {
        let Some(body) = bodies.get(contact.body.as_str()) else {
            return Err(Fault::new(FaultKind::UnknownBody { body: contact.body.clone() }));
        };
        refuse_scenery(body)?;
        refuse_misread(model, &body.path)?;
        contact.sphere = names.take(&contact.sphere)?;
        contact.force = names.take(&contact.force)?;
        let sphere = format!("/contactgeometryset/{}", contact.sphere);
        let carrier = Carrier { name: &body.name, path: &body.path };
        geometry.push(spelling::sphere(version, &carrier, contact)?);
        objects.push(added("ContactSphere", &contact.sphere, &sphere, Some(&contact.body)));
        forces.push(force(model.document(), &list, contact, &Surfaces { sphere: &sphere, plane: &plane })?);
        let path = format!("/forceset/{}", contact.force);
        force_objects.push(added(contact.kind.as_str(), &contact.force, &path, Some(&contact.body)));
    }
    objects.extend(force_objects);
    let document = model.document();
    let (tree, root) = (document.tree(), document.data_root());
    let mut made: String = made_floor.iter().map(|_| MADE_FLOOR).collect();
    let mut edits = FORCE_SET.add(tree, root, &forces, &mut made);
    edits.extend(GEOMETRY_SET.add(tree, root, &geometry, &mut made));
    let beside_others = !model.forces().is_empty();
    if !beside_others {
        made.push(Note::ALL_ADDED);
    }
    let mut rebuilt = Rebuilt::new(edited(model, edits)?, objects, made);
    rebuilt.earlier_note = EarlierNote::OfOthers;
    if beside_others {
        rebuilt.added = layout.contacts.iter().map(|contact| Note::operation_text(&contact.force)).collect();
    }
    Ok(rebuilt)
}

/// Refuses contacts on what does not move: they would carry nobody.
fn refuse_scenery(body: &Body) -> Result<(), Fault> {
    if !body.fixed {
        return Ok(());
    }
    let text = format!(
        "only WeldJoints are between body {} and ground, so that its spheres would be scenery and carry nobody: put them on a \
         body that moves, or give this one another joint in OpenSim",
        body.name
    );
    Err(Fault::refused(text).of(body.path.clone()))
}

fn force(
    document: &Document,
    list: &InList,
    contact: &NewContact,
    paths: &Surfaces<'_>,
) -> Result<Node, Fault> {
    // In the list of a HuntCrossleyForce, members of the geometry set are called by their names.
    let surfaces = match contact.kind {
        osim_model::ForceKind::HuntCrossley => {
            Surfaces { sphere: list.call(paths.sphere), plane: list.call(paths.plane) }
        }
        _ => Surfaces { sphere: paths.sphere, plane: paths.plane },
    };
    let origin = |_: Property| format!("the numbers that {} is to have", contact.force);
    let values = Values { numbers: &contact.values, origin: &origin };
    spelling::force(document, contact.kind, &contact.force, &surfaces, &values, true)
}

fn plane_path(own: Option<&HalfSpace>, made: Option<&str>) -> String {
    own.map(|plane| plane.path.clone())
        .unwrap_or_else(|| format!("/contactgeometryset/{}", made.unwrap_or(FLOOR)))
}

fn added(class: &'static str, name: &str, path: &str, body: Option<&str>) -> ObjectChange {
    ObjectChange {
        deed: Deed::Added,
        class,
        name: name.to_owned(),
        path: path.to_owned(),
        body: body.map(str::to_owned),
        parameters: Vec::new(),
    }
}
