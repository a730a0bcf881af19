//! Makes the elements of contact objects for each document version, also from the spheres and half-spaces inside forces of Moco
//! 0.1 to 0.3.

use foldhash::{HashMap, HashSet};
use osim_model::{
    Class, Document, Fault, FileId, Force, ForceKind, HalfSpace, Model, Orientation, Property, Result, Sphere,
};

use crate::insert::{NewElement, escaped_attribute};
use crate::objects::rebuilt::{ObjectAction, ObjectChange, TakenNames, refuse_non_utf8_name};
use crate::{NewContact, change};

/// The first document version in which geometry has a `socket_frame`. OpenSim refuses `socket_frame` in earlier versions, and
/// `body_name` from this version on.
const FIRST_WITH_SOCKET_FRAME: u32 = 30505;

/// The element that attaches contact geometry to `body`, a body or ground, or to the frame with this component `path` on it, in the form
/// of the document's version.
pub(super) fn frame_element(document: &Document, body: &str, path: &str) -> NewElement {
    if document.version() < FIRST_WITH_SOCKET_FRAME {
        NewElement::leaf("body_name", escaped_attribute(body))
    } else {
        NewElement::leaf("socket_frame", escaped_attribute(path))
    }
}

/// An element with three numbers; `name` is the object's name in the error message.
fn triple_element(tag: &str, values: [f64; 3], name: &str) -> Result<NewElement> {
    // The mirror image of 0 is 0, without a minus.
    let values = values.map(|value| value + 0.0);
    let text = change::triple_text(values, tag, || format!("the place that {name} is to have"));
    Ok(NewElement::leaf(tag, text.map_err(|fault| fault.at_element(name))?))
}

/// The element `<ContactSphere>` of a new contact.
pub(super) fn sphere_element(frame: NewElement, contact: &NewContact) -> Result<NewElement> {
    let name = contact.sphere.as_str();
    let place = triple_element("location", contact.location_m, name)?;
    let radius = change::number_text(contact.radius_m, Property::Radius, || {
        format!("the radius that {name} is to have")
    });
    let radius = NewElement::leaf("radius", radius.map_err(|fault| fault.at_element(name))?);
    let properties = vec![frame, place, radius];
    Ok(NewElement::object(Class::ContactSphere.as_str(), name, properties))
}

/// The element `<ContactHalfSpace>` with a location (m) and three angles (rad).
fn half_space_element(
    frame: NewElement,
    name: &str,
    [location_m, angles_rad]: [[f64; 3]; 2],
) -> Result<NewElement> {
    let place = triple_element("location", location_m, name)?;
    let turned = triple_element("orientation", angles_rad, name)?;
    Ok(NewElement::object("ContactHalfSpace", name, vec![frame, place, turned]))
}

/// The element `<ContactHalfSpace>` through the origin of ground; its normal points along `up`.
pub(super) fn floor(document: &Document, name: &str, up: [f64; 3]) -> Result<NewElement> {
    let ground = frame_element(document, "ground", "/ground");
    half_space_element(ground, name, [[0.0; 3], Orientation::facing(up)])
}

/// The element of a force of `kind` between one sphere and one half-space, which are given by their component paths, with the given
/// values; `origin` says in words where each comes from. The `<defaults>` of `document` must not change the force: for a property that is
/// in the defaults and not in `values`, OpenSim's own default is written. The list of a `HuntCrossleyForce` calls the surfaces by `names`.
///
/// # Errors
/// A value that is not finite, or outside the domain in which the contact laws hold.
pub(super) fn force(
    document: &Document,
    kind: ForceKind,
    name: &str,
    [sphere, plane]: [&str; 2],
    (values, origin): (&[(Property, f64)], impl Fn(Property) -> String),
    applies: bool,
    names: &NamesInList,
) -> Result<NewElement> {
    let values_of = |class: Class| {
        let value = |property: Property| {
            let given = values.iter().find(|(known, _)| *known == property).map(|(_, value)| *value);
            given.or_else(|| has_default(document, class, property.as_str()).then(|| class.default(property)))
        };
        let leaf = |&property: &Property| {
            let text = change::number_text(value(property)?, property, || origin(property));
            let leaf = text.map(|text| NewElement::leaf(property.as_str(), text));
            Some(leaf.map_err(|fault| fault.at_element(name)))
        };
        class.parameters().iter().filter_map(leaf).collect::<Result<Vec<_>, _>>()
    };
    let on_or_off = |class: Class| {
        let is_changed = ["appliesForce", "isDisabled"].iter().any(|tag| has_default(document, class, tag));
        (!applies || is_changed).then(|| NewElement::leaf("appliesForce", applies.to_string()))
    };
    Ok(match kind {
        ForceKind::HuntCrossley => {
            let geometry = [sphere, plane].map(|path| escaped_attribute(names.name_of(path)));
            let mut parameters = vec![NewElement::leaf("geometry", geometry.join(" "))];
            parameters.extend(values_of(Class::ContactParameters)?);
            let parameters = NewElement::parent(Class::ContactParameters.as_str(), parameters);
            let list = NewElement::parent("objects", vec![parameters]);
            let set = "HuntCrossleyForce::ContactParametersSet";
            let set = NewElement::object(set, "contact_parameters", vec![list]);
            let mut children: Vec<NewElement> = on_or_off(Class::HuntCrossleyForce).into_iter().collect();
            children.push(set);
            children.extend(values_of(Class::HuntCrossleyForce)?);
            NewElement::object(kind.as_str(), name, children)
        }
        _ => {
            let mut children = vec![
                NewElement::leaf("socket_sphere", escaped_attribute(sphere)),
                NewElement::leaf("socket_half_space", escaped_attribute(plane)),
            ];
            children.extend(on_or_off(Class::SmoothSphereHalfSpaceForce));
            children.extend(values_of(Class::SmoothSphereHalfSpaceForce)?);
            NewElement::object(kind.as_str(), name, children)
        }
    })
}

/// Whether the `<defaults>` give objects of `class` a value for the element `tag`.
fn has_default(document: &Document, class: Class, tag: &str) -> bool {
    document.default_property(class.as_str(), tag).is_some()
}

/// The names by which the list of a `HuntCrossleyForce` refers to geometry. It uses the name of a member of the geometry set; if
/// a component of the model has the same name, OpenSim would find that component first, so the path is used.
pub(super) struct NamesInList(HashSet<String>);

impl NamesInList {
    /// The names of components of `model` that OpenSim would find before geometry with these names.
    pub(super) fn of(model: &Model) -> Self {
        let document = model.document();
        let tree = document.tree();
        let components = tree.child(document.data_root(), "components");
        let written = components.into_iter().flat_map(|list| tree.children(list));
        let written = written.filter_map(|id| Some(tree.attribute(id, "name")?.into_owned()));
        // Such a component may also be in another file.
        let planes = model.half_spaces().into_iter().map(|plane| plane.path);
        let geometry = model.spheres().iter().map(|sphere| sphere.path.clone()).chain(planes);
        let own = |path: String| path.strip_prefix('/').filter(|name| !name.contains('/')).map(str::to_owned);
        Self(written.chain(geometry.filter_map(own)).collect())
    }

    /// What the list calls the geometry at `path`: its name, or its path if the name is taken.
    pub(super) fn name_of<'p>(&self, path: &'p str) -> &'p str {
        let name = path.strip_prefix("/contactgeometryset/");
        name.filter(|name| !self.0.contains(*name)).unwrap_or(path)
    }
}

// Spheres and half-spaces that forces of Moco 0.1 to 0.3 keep inside themselves, as objects of the geometry set.

/// Spheres and half-spaces that are moved from inside forces into the geometry set.
#[derive(Default)]
pub(super) struct SurfacesInsideForces {
    /// New elements of the contact geometry set.
    pub(super) geometry: Vec<NewElement>,
    pub(super) objects: Vec<ObjectChange>,
    /// The new path of each half-space that is already a new element, by its frame, location and angles.
    planes: HashMap<(String, [[u64; 3]; 2]), String>,
    /// The paths of all bodies, after they were needed.
    body_paths: HashSet<String>,
}

impl SurfacesInsideForces {
    /// The new paths of the sphere and of the half-space inside `force`. Forces on the same plane get one half-space
    /// together.
    ///
    /// # Errors
    /// A number that cannot be written, a name that OpenSim refuses, or a frame whose offset the first version of the class ignored.
    pub(super) fn add_surfaces(
        &mut self,
        model: &Model,
        force: &Force,
        (sphere, plane): (&Sphere, &HalfSpace),
        names: &mut TakenNames,
    ) -> Result<(String, String)> {
        self.refuse_ignored_offset(model, force, [&sphere.frame, &plane.frame_path])
            .map_err(|fault| fault.at_element(force.path.clone()))?;
        for frame in [&sphere.frame, &plane.frame_path] {
            refuse_non_utf8_name(model, frame).map_err(|fault| fault.at_element(force.path.clone()))?;
        }
        Ok((self.add_sphere(model, force, sphere, names)?, self.add_plane(model, force, plane, names)?))
    }

    /// Moves the sphere inside a force to the geometry set, and returns its new path.
    fn add_sphere(
        &mut self,
        model: &Model,
        force: &Force,
        sphere: &Sphere,
        names: &mut TakenNames,
    ) -> Result<String> {
        let mut contact = NewContact::new(force.kind, force.name.clone(), "");
        contact.sphere = names.reserve(&format!("{}_sphere", force.name))?;
        contact.location_m = sphere.location_m;
        contact.radius_m = sphere.radius_m()?;
        let body = sphere.body.as_deref();
        let frame = frame_element(model.document(), body.unwrap_or("ground"), &sphere.frame);
        self.geometry.push(sphere_element(frame, &contact)?);
        Ok(self.record_added("ContactSphere", &contact.sphere, body))
    }

    /// Moves the half-space inside a force to the geometry set, and returns its new path.
    fn add_plane(
        &mut self,
        model: &Model,
        force: &Force,
        plane: &HalfSpace,
        names: &mut TakenNames,
    ) -> Result<String> {
        let unread =
            || Fault::refused(format!("the place of the half-space of {} cannot be read", force.path));
        let place = [plane.location_m, plane.orientations.first().and_then(|own| own.angles_rad)];
        let [Some(location_m), Some(angles_rad)] = place else { return Err(unread()) };
        let bits = [location_m, angles_rad].map(|values| values.map(f64::to_bits));
        let key = (plane.frame_path.clone(), bits);
        if let Some(path) = self.planes.get(&key) {
            return Ok(path.clone());
        }
        let name = names.reserve(if plane.on_ground { "floor" } else { "half_space" })?;
        let body = plane.body.as_deref();
        let frame = frame_element(model.document(), body.unwrap_or("ground"), &plane.frame_path);
        self.geometry.push(half_space_element(frame, &name, [location_m, angles_rad])?);
        let path = self.record_added("ContactHalfSpace", &name, body);
        self.planes.insert(key, path.clone());
        Ok(path)
    }

    /// Records a new object of the geometry set and returns its path.
    fn record_added(&mut self, class: &'static str, name: &str, body: Option<&str>) -> String {
        let path = format!("/contactgeometryset/{name}");
        self.objects.push(ObjectChange::new(ObjectAction::Added, class, [name, &path], body));
        path
    }

    /// Refuses an offset frame: the first version of the class, which had a `derivative_smoothing`, used a location in the frame as
    /// if it were one in the body.
    fn refuse_ignored_offset(&mut self, model: &Model, force: &Force, frames: [&String; 2]) -> Result<()> {
        let tree = model.file(FileId::MAIN).tree();
        if tree.child(force.element, "derivative_smoothing").is_none() {
            return Ok(());
        }
        if self.body_paths.is_empty() {
            self.body_paths.extend(model.bodies().iter().map(|body| body.path.clone()));
        }
        let is_offset = |frame: &&String| *frame != "/ground" && !self.body_paths.contains(*frame);
        match frames.into_iter().find(is_offset) {
            None => Ok(()),
            Some(frame) => Err(Fault::refused(format!(
                "{} has a derivative_smoothing, as the first version of its class, which ignored where frame {frame} is on its body: \
                 name the body itself in the force, and its place on that body",
                force.path
            ))),
        }
    }
}
