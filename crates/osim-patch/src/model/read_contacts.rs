//! Reading contacts: every spelling of spheres, forces and their connections becomes the same typed values.

use super::contacts::{Dialect, Force, ForceKind, ParameterSet, Sphere};
use super::files::{Base, Files};
use super::objects::ObjectId;
use super::skeleton::Skeleton;
use crate::document::{Document, Value};
use crate::error::Fault;
use crate::property::{Class, Property};
use crate::warning::{Warning, WarningCode};
use crate::xml::ElementId;

/// The frame a geometry is attached to.
struct Attachment {
    path: String,
    base: Base,
    object: Option<ObjectId>,
}

/// A surface named by a force.
#[derive(Clone, Copy)]
enum Surface {
    Sphere(usize),
    HalfSpace(Base),
    Other,
}

/// Reads spheres and forces of all files.
pub(crate) struct ContactReader<'r, 'd, 'a> {
    pub files: &'r Files<'d, 'a>,
    pub skeleton: &'r Skeleton,
    pub spheres: Vec<Sphere>,
    pub forces: Vec<Force>,
    pub warnings: Vec<Warning>,
    sphere_objects: Vec<ObjectId>,
}

impl<'r, 'd, 'a> ContactReader<'r, 'd, 'a> {
    pub(crate) fn new(files: &'r Files<'d, 'a>, skeleton: &'r Skeleton) -> Self {
        Self { files, skeleton, spheres: vec![], forces: vec![], warnings: vec![], sphere_objects: vec![] }
    }

    /// All spheres first, then all forces, each in file order.
    pub(crate) fn read(&mut self) -> Result<(), Fault> {
        for (id, _) in self.files.objects.iter() {
            if self.files.tag(id) == "ContactSphere" {
                self.add_sphere(id)?;
            }
        }
        for (id, _) in self.files.objects.iter() {
            match self.files.tag(id) {
                "SmoothSphereHalfSpaceForce" => self.add_smooth(id)?,
                "HuntCrossleyForce" => self.add_hunt_crossley(id)?,
                _ => {}
            }
        }
        Ok(())
    }

    fn add_sphere(&mut self, id: ObjectId) -> Result<(), Fault> {
        let (document, element) = (self.files.doc(id), self.files.element(id));
        let frame = self.attachment(id, "frame", &["body_name"])?;
        let radius = document.value(element, Class::ContactSphere, Property::Radius, "radius");
        let location_m = document.triple(element, "location").unwrap_or([0.0; 3]);
        let name = self.files.name(id);
        self.push_sphere(id, name, radius, location_m, frame, Dialect::ContactSphere);
        self.sphere_objects.push(id);
        Ok(())
    }

    fn push_sphere(
        &mut self,
        id: ObjectId,
        name: String,
        radius: Value,
        location_m: [f64; 3],
        frame: Attachment,
        dialect: Dialect,
    ) {
        let Attachment { path: frame, base, object: frame_object } = frame;
        let document = self.files.doc(id);
        let location = document.tree().child(self.files.element(id), dialect.location_tag());
        let location_span = location.map(|element| {
            let raw = document.tree().raw_text(element);
            if raw.span.is_empty() { document.tree().span(element) } else { raw.span }
        });
        let body = match base {
            Base::Body(body) => Some(self.files.name(body)),
            Base::Ground | Base::Unknown => None,
        };
        self.spheres.push(Sphere {
            name,
            path: self.files.objects.path(id),
            radius,
            location_m,
            frame,
            body,
            fixed: self.skeleton.is_fixed(base),
            line: self.files.line(id),
            file: self.files.file_of(id),
            element: self.files.element(id),
            base,
            dialect,
            frame_object,
            location_span,
        });
    }

    /// The frame a geometry is attached to: its path and the body behind it.
    fn attachment(&mut self, id: ObjectId, socket: &str, legacy: &[&str]) -> Result<Attachment, Fault> {
        let Some(connectee) = self.files.connectee(id, socket, legacy) else {
            return Err(self.files.unresolved(id, "", "frame it is attached to"));
        };
        let Some(found) = self.files.frame(id, &connectee) else {
            // A geometry set that stands alone points into a model that may not be at hand.
            let alone = self.files.tag(self.files.objects.root_of(id)) != "Model";
            return if alone {
                Ok(Attachment { path: connectee.text, base: Base::Unknown, object: None })
            } else {
                Err(self.files.unresolved(id, &connectee.text, "frame it is attached to"))
            };
        };
        if found.by_name {
            self.say_by_name(id, &connectee.text, connectee.element, found.object);
        }
        let path =
            found.object.map_or_else(|| "/ground".to_owned(), |object| self.files.objects.path(object));
        Ok(Attachment { path, base: self.files.base(found.object)?, object: found.object })
    }

    fn say_by_name(&mut self, owner: ObjectId, text: &str, element: ElementId, found: Option<ObjectId>) {
        let path = found.map(|id| self.files.objects.path(id)).unwrap_or_default();
        let line = self.files.doc(owner).line(self.files.doc(owner).tree().span(element).start);
        let whose = self.files.objects.path(owner);
        let text = format!("'{text}' of {whose} leads nowhere; took {path}, the only one of that name");
        self.warnings.push(Warning::at(WarningCode::ConnecteeByName, line, text).about(&whose));
    }

    fn surface(
        &mut self,
        force: ObjectId,
        text: &str,
        element: ElementId,
        list: bool,
    ) -> Result<Surface, Fault> {
        let is_geometry = |id: ObjectId| self.files.tag(id).starts_with("Contact");
        let (id, by_name) = match list {
            // In a `<geometry>` list: a path from the model, then a member of its geometry set.
            true => self.in_model(text, is_geometry).map(|id| (id, false)),
            false => None,
        }
        .or_else(|| self.files.resolve(force, text, is_geometry))
        .ok_or_else(|| self.files.unresolved(force, text, "contact geometry of that name"))?;
        if by_name {
            self.say_by_name(force, text, element, Some(id));
        }
        match self.files.tag(id) {
            "ContactSphere" => {
                let index = self.sphere_objects.binary_search(&id).unwrap_or_default();
                Ok(Surface::Sphere(index))
            }
            "ContactHalfSpace" => Ok(Surface::HalfSpace(self.attachment(id, "frame", &["body_name"])?.base)),
            _ => Ok(Surface::Other),
        }
    }

    fn in_model(&self, name: &str, accept: impl Fn(ObjectId) -> bool) -> Option<ObjectId> {
        let root = self.files.objects.first()?;
        let from_root = self.files.objects.at_path(root, name).filter(|&id| accept(id));
        let in_set = || self.files.objects.at_path(root, &format!("/contactgeometryset/{name}"));
        from_root.or_else(|| in_set().filter(|&id| accept(id)))
    }

    fn applies(&self, id: ObjectId) -> bool {
        let (document, element) = (self.files.doc(id), self.files.element(id));
        // Up to 30508 a force is switched off by `isDisabled`; later documents ignore that.
        let disabled = match document.version() {
            ..=LAST_VERSION_WITH_IS_DISABLED => document.flag(element, "isDisabled"),
            _ => None,
        };
        disabled.map(|disabled| !disabled).or_else(|| document.flag(element, "appliesForce")).unwrap_or(true)
    }

    fn add_smooth(&mut self, id: ObjectId) -> Result<(), Fault> {
        let class = Class::SmoothSphereHalfSpaceForce;
        let (document, element) = (self.files.doc(id), self.files.element(id));
        let mut set = self.parameter_set(document, element, class, None);
        if self.files.connectee(id, "sphere_frame", &[]).is_some() {
            let sphere = self.add_sphere_inside(id)?;
            set.spheres.push(sphere);
            let base = self.attachment(id, "half_space_frame", &[]).map_or(Base::Unknown, |plane| plane.base);
            set.half_space_bases.push(base);
        } else {
            for socket in ["sphere", "half_space"] {
                let Some(connectee) = self.files.connectee(id, socket, &[]) else {
                    return Err(self.files.unresolved(id, "", "contact geometry of its socket"));
                };
                let surface = self.surface(id, &connectee.text, connectee.element, false)?;
                set.add(surface);
            }
        }
        set.half_spaces = set.half_space_bases.len();
        let transition_velocity =
            document.value(element, class, Property::TransitionVelocity, Property::TransitionVelocity.name());
        self.push_force(id, ForceKind::SmoothSphereHalfSpace, vec![set], transition_velocity);
        Ok(())
    }

    /// Moco 0.1 to 0.3: the sphere's frame, radius and location stand in the force.
    fn add_sphere_inside(&mut self, id: ObjectId) -> Result<usize, Fault> {
        let (document, element) = (self.files.doc(id), self.files.element(id));
        let frame = self.attachment(id, "sphere_frame", &[])?;
        let tag = Dialect::InsideForce.radius_tag();
        let radius = document.value(element, Class::SmoothSphereHalfSpaceForce, Property::Radius, tag);
        let location = document.triple(element, "contact_sphere_location").unwrap_or([0.0; 3]);
        let name = self.files.name(id);
        self.push_sphere(id, name, radius, location, frame, Dialect::InsideForce);
        Ok(self.spheres.len() - 1)
    }

    fn add_hunt_crossley(&mut self, id: ObjectId) -> Result<(), Fault> {
        let (document, element) = (self.files.doc(id), self.files.element(id));
        let mut sets = Vec::new();
        let own = parameter_sets_of(document, element);
        let inherited = own.is_none();
        let container = own.or_else(|| parameter_sets_of(document, document.defaults_of(element)?));
        match container {
            Some(container) => {
                let tree = document.tree();
                let items =
                    tree.child(container, "objects").into_iter().flat_map(|objects| tree.children(objects));
                for item in items.filter(|&item| tree.name(item) == Class::ContactParameters.tag()) {
                    let mut set =
                        self.parameter_set(document, item, Class::ContactParameters, Some(sets.len()));
                    set.inherited = inherited;
                    if let Some(geometry) = document.property_element(item, "geometry") {
                        let names = tree.whole_text(geometry).map_err(|fault| {
                            fault.of(self.files.objects.path(id)).in_file(self.files.file_of(id))
                        })?;
                        for name in names.split_ascii_whitespace() {
                            let surface = self.surface(id, name, geometry, true)?;
                            set.add(surface);
                        }
                    }
                    set.half_spaces = set.half_space_bases.len();
                    sets.push(set);
                }
            }
            None => self.warn_misnamed_set(id, document, element),
        }
        let class = Class::HuntCrossleyForce;
        let transition_velocity =
            document.value(element, class, Property::TransitionVelocity, Property::TransitionVelocity.name());
        self.push_force(id, ForceKind::HuntCrossley, sets, transition_velocity);
        Ok(())
    }

    fn warn_misnamed_set(&mut self, id: ObjectId, document: &Document<'_>, element: ElementId) {
        let tree = document.tree();
        let set = tree.children(element).find(|&child| tree.name(child) == CONTACT_PARAMETERS_SET);
        if let Some(set) = set {
            let name = tree.attribute(set, "name").unwrap_or_default();
            let whose = self.files.objects.path(id);
            let text = format!(
                "{whose}: the parameter set is called '{name}', so OpenSim reads no parameters at all; call it contact_parameters"
            );
            let line = document.line(tree.span(set).start);
            self.warnings.push(Warning::at(WarningCode::MisnamedParameterSet, line, text).about(&whose));
        }
    }

    fn parameter_set(
        &self,
        document: &Document<'_>,
        element: ElementId,
        class: Class,
        index: Option<usize>,
    ) -> ParameterSet {
        let value = |&property: &Property| document.value(element, class, property, property.name());
        ParameterSet {
            index,
            spheres: vec![],
            half_spaces: 0,
            other_surfaces: 0,
            values: class.parameters().iter().map(value).collect(),
            line: document.line(document.tree().span(element).start),
            element,
            class,
            half_space_bases: vec![],
            inherited: false,
        }
    }

    fn push_force(
        &mut self,
        id: ObjectId,
        kind: ForceKind,
        sets: Vec<ParameterSet>,
        transition_velocity: Value,
    ) {
        self.forces.push(Force {
            name: self.files.name(id),
            path: self.files.objects.path(id),
            kind,
            applies: self.applies(id),
            sets,
            transition_velocity,
            line: self.files.line(id),
            file: self.files.file_of(id),
            element: self.files.element(id),
        });
    }
}

impl ParameterSet {
    fn add(&mut self, surface: Surface) {
        match surface {
            Surface::Sphere(sphere) => self.spheres.push(sphere),
            Surface::HalfSpace(base) => self.half_space_bases.push(base),
            Surface::Other => self.other_surfaces += 1,
        }
    }
}

const LAST_VERSION_WITH_IS_DISABLED: u32 = 30508;
const CONTACT_PARAMETERS_SET: &str = "HuntCrossleyForce::ContactParametersSet";

/// The list of parameter sets, in any of its three spellings. OpenSim prefers the wrapper `<contact_parameters>`, then
/// the set of that name, then one without a name (documents of version 2), wherever they stand.
fn parameter_sets_of(document: &Document<'_>, force: ElementId) -> Option<ElementId> {
    let tree = document.tree();
    if let Some(wrapper) = tree.child(force, "contact_parameters") {
        return tree.child(wrapper, CONTACT_PARAMETERS_SET);
    }
    let called = |accept: fn(&str) -> bool| {
        tree.children(force).find(|&child| {
            tree.name(child) == CONTACT_PARAMETERS_SET
                && accept(&tree.attribute(child, "name").unwrap_or_default())
        })
    };
    called(|name| name == "contact_parameters").or_else(|| called(str::is_empty))
}
