//! Reads contact spheres and contact forces from all spellings in model files.

use foldhash::{HashSet, HashSetExt};

use crate::model::components::{Carrier, ComponentId, Components, Connectee};
use crate::model::contacts::force::{
    Force, ForceId, ForceKind, ParameterSet, SetId, Sphere, SphereId, location_tag, radius_tag,
};
use crate::model::document::Document;
use crate::model::fault::{Fault, FaultKind, Result};
use crate::model::property::{Class, Property, Value};
use crate::model::skeleton::Skeleton;
use crate::xml::opensim_text::{self, is_disabled};
use crate::xml::{ElementId, TextPosition};

/// The frame to which a contact geometry is attached.
struct GeometryFrame {
    path: String,
    base: Carrier,
    component: Option<ComponentId>,
}

/// The contact geometry that a force names: a sphere, a half-space, or another class.
#[derive(Clone, Copy)]
enum ContactGeometry {
    Sphere(SphereId),
    HalfSpace(ComponentId, Carrier),
    Other(ComponentId),
}

/// Reads the contact spheres and forces of all components.
pub(crate) struct ContactReader<'r> {
    pub components: &'r Components,
    pub skeleton: &'r Skeleton,
    pub spheres: Vec<Sphere>,
    pub forces: Vec<Force>,
    pub irregularities: Vec<Irregularity>,
    sphere_components: Vec<ComponentId>,
    /// Objects with the elements and the paths that were resolved by name. Several forces may use one half-space.
    pub(super) taken_by_name: HashSet<(ComponentId, ElementId, String)>,
}

impl<'r> ContactReader<'r> {
    pub(crate) fn new(components: &'r Components, skeleton: &'r Skeleton) -> Self {
        Self {
            components,
            skeleton,
            spheres: vec![],
            forces: vec![],
            irregularities: vec![],
            sphere_components: vec![],
            taken_by_name: HashSet::new(),
        }
    }

    /// Reads all spheres, then all forces, each in file order.
    pub(crate) fn read(&mut self) -> Result<()> {
        self.components.refuse_broken_texts()?;
        self.record_needed_sockets();
        for (id, _) in self.components.tree.iter() {
            match self.components.tag(id) {
                "ContactSphere" => self.add_sphere(id, Class::ContactSphere)?,
                "ContactEllipsoid" => self.add_sphere(id, Class::ContactEllipsoid)?,
                _ => {}
            }
        }
        for (id, _) in self.components.tree.iter() {
            match self.components.tag(id) {
                "SmoothSphereHalfSpaceForce" => self.add_smooth_force(id)?,
                "HuntCrossleyForce" => self.add_hunt_crossley_force(id)?,
                _ => {}
            }
        }
        self.record_other_sockets();
        self.record_surfaces_of_foundations();
        Ok(())
    }

    fn add_sphere(&mut self, id: ComponentId, class: Class) -> Result<()> {
        let (document, element) = (self.components.document_of(id), self.components.element(id));
        let frame = self.frame_of_geometry(id, "frame", &["body_name"])?;
        let radius = document.value(element, class, Property::Radius, radius_tag(class));
        let location =
            document.whole_triple(element, "location").map_err(|fault| self.with_place(id, fault))?;
        let location_m = location.unwrap_or([0.0; 3]);
        let name = self.components.name(id).into_owned();
        self.push_sphere(id, name, radius, location_m, frame, class);
        self.sphere_components.push(id);
        if class == Class::ContactEllipsoid
            && let Some(ellipsoid) = self.spheres.last_mut()
        {
            ellipsoid.set_radii(document.triple(element, radius_tag(class)).unwrap_or_default());
        }
        Ok(())
    }

    fn push_sphere(
        &mut self,
        id: ComponentId,
        name: String,
        radius: Value,
        location_m: [f64; 3],
        frame: GeometryFrame,
        class: Class,
    ) {
        let GeometryFrame { path: frame, base, component: frame_component } = frame;
        let document = self.components.document_of(id);
        let location = document.tree().child(self.components.element(id), location_tag(class));
        let location_span = location.map(|element| document.span_of_value(element));
        let body = match base {
            Carrier::Body(body) => Some(self.components.name(body).into_owned()),
            Carrier::Ground | Carrier::Unknown => None,
        };
        let element = self.components.element(id);
        self.spheres.push(Sphere {
            id: SphereId(self.spheres.len()),
            name,
            path: self.components.tree.path(id),
            radius,
            radii_m: None,
            location_m,
            frame,
            body,
            fixed: self.skeleton.is_fixed(base),
            position: self.components.position_of(id),
            file: self.components.file_of(id),
            element,
            start: document.tree().span(element).start,
            base,
            class,
            frame_component,
            location_span,
        });
    }

    /// The frame to which a contact geometry is attached: its path and the body that carries it.
    fn frame_of_geometry(&mut self, id: ComponentId, socket: &str, legacy: &[&str]) -> Result<GeometryFrame> {
        let Some(connectee) = self.components.connectee(id, socket, legacy) else {
            return Err(self.components.unresolved(id, "", "frame it is attached to"));
        };
        let Some(found) = self.components.frame_of(id, &connectee) else {
            // A geometry set that stands alone points into a model that may not have been read.
            let is_standalone_set = self.components.tag(self.components.tree.root_of(id)) != "Model";
            return if is_standalone_set {
                Ok(GeometryFrame {
                    path: connectee.text.into_owned(),
                    base: Carrier::Unknown,
                    component: None,
                })
            } else {
                Err(self.components.unresolved(id, &connectee.text, "frame it is attached to"))
            };
        };
        if found.by_name {
            self.record_component_taken_by_name(id, &connectee, found.component);
        }
        let path =
            found.component.map_or_else(|| "/ground".to_owned(), |object| self.components.tree.path(object));
        Ok(GeometryFrame { path, base: self.components.base(found.component)?, component: found.component })
    }

    /// The contact geometry to which `text` of `force` refers. `socket` is the class that the geometry must have; `None` in a `<geometry>`
    /// list.
    fn surface(
        &mut self,
        force: ComponentId,
        text: &str,
        element: ElementId,
        socket: Option<&str>,
    ) -> Result<ContactGeometry> {
        let accept = |id: ComponentId| {
            let tag = self.components.tag(id);
            socket.map_or_else(|| GEOMETRY_CLASSES.contains(&tag), |class| class == tag)
        };
        let (id, by_name) = match socket {
            // In a `<geometry>` list: a path from the model, then a member of its geometry set.
            None => self.geometry_in_model(text, accept).map(|id| (id, false)),
            Some(_) => None,
        }
        .or_else(|| self.components.resolve(force, text, accept))
        .ok_or_else(|| self.surface_of_other_class(force, text, socket))?;
        if by_name {
            let connectee = Connectee { text: text.into(), element, legacy: false };
            self.record_component_taken_by_name(force, &connectee, Some(id));
        }
        match self.components.tag(id) {
            "ContactSphere" | "ContactEllipsoid" => {
                let index = self.sphere_components.binary_search(&id).unwrap_or_default();
                Ok(ContactGeometry::Sphere(SphereId(index)))
            }
            "ContactHalfSpace" => {
                Ok(ContactGeometry::HalfSpace(id, self.frame_of_geometry(id, "frame", &["body_name"])?.base))
            }
            _ => Ok(ContactGeometry::Other(id)),
        }
    }

    /// The fault for a path that leads to no contact geometry, or to one that the `socket` does not take.
    fn surface_of_other_class(&self, force: ComponentId, text: &str, socket: Option<&str>) -> Fault {
        let is_geometry = |id: ComponentId| GEOMETRY_CLASSES.contains(&self.components.tag(id));
        let other = socket.and_then(|_| self.components.resolve(force, text, is_geometry));
        let mut fault = self.components.unresolved(force, text, "contact geometry of that name");
        if let (Some(expected), Some((other, _))) = (socket, other) {
            let (owner, connectee) = (self.components.tree.path(force), text.to_owned());
            let (class, expected) = (self.components.tag(other).to_owned(), expected.to_owned());
            // The socket of the sphere is read first.
            let of_plane = self.components.connectee(force, "half_space", &[]);
            let is_sphere = |id| self.components.tag(id) == "ContactSphere";
            let are_exchanged = expected == "ContactSphere"
                && of_plane.is_some_and(|of| self.components.resolve(force, &of.text, is_sphere).is_some());
            fault.kind = FaultKind::OtherSurface { owner, connectee, class, expected, are_exchanged };
        }
        fault
    }

    pub(super) fn geometry_in_model(
        &self,
        name: &str,
        accept: impl Fn(ComponentId) -> bool,
    ) -> Option<ComponentId> {
        let root = self.components.tree.data_root()?;
        let from_root = self.components.tree.at_path(root, name).filter(|&id| accept(id));
        let in_set = || self.components.tree.at_path(root, &format!("/contactgeometryset/{name}"));
        from_root.or_else(|| in_set().filter(|&id| accept(id)))
    }

    /// Whether a force is switched on. In documents up to 30508, `isDisabled` also switches a force off; the first of both elements counts.
    /// Later documents ignore `isDisabled`.
    fn applies(&self, id: ComponentId) -> Result<bool> {
        let (document, element) = (self.components.document_of(id), self.components.element(id));
        let tree = document.tree();
        let is_enabled = |element| -> Result<bool> { Ok(!is_disabled(&document.whole_text(element)?)) };
        if document.version() <= LAST_VERSION_WITH_IS_DISABLED {
            for object in std::iter::once(element).chain(document.defaults_of(element)) {
                let first =
                    tree.children(object).find(|&id| ["isDisabled", "appliesForce"].contains(&tree.name(id)));
                match first.map(|id| (tree.name(id), id)) {
                    Some(("isDisabled", disabled)) => return is_enabled(disabled),
                    Some(_) => break,
                    None => {}
                }
            }
        }
        Ok(document.flag(element, "appliesForce")?.unwrap_or(true))
    }

    fn add_smooth_force(&mut self, id: ComponentId) -> Result<()> {
        let class = Class::SmoothSphereHalfSpaceForce;
        let (document, element) = (self.components.document_of(id), self.components.element(id));
        let mut set = self.parameter_set(document, element, class, None);
        if self.components.connectee(id, "sphere_frame", &[]).is_some() {
            let sphere = self.add_sphere_inside(id)?;
            set.spheres.push(sphere);
            let base = self
                .frame_of_geometry(id, "half_space_frame", &[])
                .map_or(Carrier::Unknown, |plane| plane.base);
            set.half_space_bases.push(base);
            set.half_space_inside = Some(id);
            self.read_old_constant(&mut set, document, element);
        } else {
            for (socket, class) in [("sphere", "ContactSphere"), ("half_space", "ContactHalfSpace")] {
                let Some(connectee) = self.components.connectee(id, socket, &[]) else {
                    return Err(self.components.unresolved(id, "", "contact geometry of its socket"));
                };
                let surface = self.surface(id, &connectee.text, connectee.element, Some(class))?;
                set.add(surface);
            }
        }
        set.half_spaces = set.half_space_bases.len();
        let velocity = Property::TransitionVelocity;
        let transition_velocity = document.value(element, class, velocity, velocity.as_str());
        self.push_force(id, ForceKind::SmoothSphereHalfSpace, vec![set], transition_velocity)
    }

    /// Reads `constant_contact_force` under the other name that it had in the first version of the class.
    fn read_old_constant(&self, set: &mut ParameterSet, document: &Document, element: ElementId) {
        let has = |tag: &str| document.tree().child(element, tag).is_some();
        let constant = Property::ConstantContactForce;
        if has(OLD_CONSTANT_TAG) && !has(constant.as_str()) {
            let values = set.values.iter_mut().filter(|value| value.property == constant);
            values.for_each(|value| *value = document.value(element, set.class, constant, OLD_CONSTANT_TAG));
        }
    }

    /// Adds the sphere inside a force of Moco 0.1 to 0.3: its frame, radius and location are elements of the force.
    fn add_sphere_inside(&mut self, id: ComponentId) -> Result<SphereId> {
        let (document, element) = (self.components.document_of(id), self.components.element(id));
        let frame = self.frame_of_geometry(id, "sphere_frame", &[])?;
        let class = Class::SmoothSphereHalfSpaceForce;
        let radius = document.value(element, class, Property::Radius, radius_tag(class));
        let location = document.triple(element, "contact_sphere_location").unwrap_or([0.0; 3]);
        let name = self.components.name(id).into_owned();
        self.push_sphere(id, name, radius, location, frame, class);
        Ok(SphereId(self.spheres.len() - 1))
    }

    fn add_hunt_crossley_force(&mut self, id: ComponentId) -> Result<()> {
        let (document, element) = (self.components.document_of(id), self.components.element(id));
        let mut sets = Vec::new();
        let own_sets = parameter_sets_of(document, element);
        let inherited = own_sets.is_none();
        let container = own_sets.or_else(|| parameter_sets_of(document, document.defaults_of(element)?));
        match container {
            Some(container) => {
                let tree = document.tree();
                let items =
                    tree.child(container, "objects").into_iter().flat_map(|objects| tree.children(objects));
                for item in items.filter(|&item| tree.name(item) == Class::ContactParameters.as_str()) {
                    let mut set =
                        self.parameter_set(document, item, Class::ContactParameters, Some(sets.len()));
                    set.inherited = inherited;
                    if let Some(geometry) = document.property_element(item, "geometry") {
                        let names =
                            document.whole_text(geometry).map_err(|fault| self.with_place(id, fault))?;
                        for name in opensim_text::list_words(&names) {
                            let surface = self.surface(id, name, geometry, None)?;
                            set.add(surface);
                        }
                    }
                    set.half_spaces = set.half_space_bases.len();
                    sets.push(set);
                }
            }
            None => self.record_misnamed_set(id, document, element),
        }
        let class = Class::HuntCrossleyForce;
        let velocity = Property::TransitionVelocity;
        let transition_velocity = document.value(element, class, velocity, velocity.as_str());
        self.push_force(id, ForceKind::HuntCrossley, sets, transition_velocity)
    }

    fn parameter_set(
        &self,
        document: &Document,
        element: ElementId,
        class: Class,
        number: Option<usize>,
    ) -> ParameterSet {
        let value = |&property: &Property| document.value(element, class, property, property.as_str());
        ParameterSet {
            id: SetId(number.unwrap_or_default()),
            number,
            spheres: vec![],
            half_spaces: 0,
            other_surfaces: vec![],
            values: class.parameters().iter().map(value).collect(),
            position: document.position_of(element),
            element,
            class,
            half_space_bases: vec![],
            half_space_components: vec![],
            half_space_inside: None,
            inherited: false,
        }
    }

    fn push_force(
        &mut self,
        id: ComponentId,
        kind: ForceKind,
        sets: Vec<ParameterSet>,
        transition_velocity: Value,
    ) -> Result<()> {
        let applies = self.applies(id).map_err(|fault| self.with_place(id, fault))?;
        let (all, mut seen) = (sets.iter().flat_map(|set| &set.spheres).copied(), HashSet::new());
        self.forces.push(Force {
            id: ForceId(self.forces.len()),
            name: self.components.name(id).into_owned(),
            path: self.components.tree.path(id),
            kind,
            applies,
            spheres: all.filter(|&sphere| seen.insert(sphere)).collect(),
            sets,
            transition_velocity,
            position: self.components.position_of(id),
            file: self.components.file_of(id),
            element: self.components.element(id),
        });
        Ok(())
    }

    fn with_place(&self, id: ComponentId, fault: Fault) -> Fault {
        fault.at_element(self.components.tree.path(id)).in_file(self.components.file_of(id))
    }
}

/// The radius of the sphere that has the volume of an ellipsoid, m.
pub fn radius_of_equal_volume(radii_m: [f64; 3]) -> f64 {
    libm::cbrt(radii_m.iter().product())
}

impl Sphere {
    /// Makes the sphere an ellipsoid. Its radius is that of a sphere of equal volume; or that of its radii which cannot be scaled, if there
    /// is one.
    fn set_radii(&mut self, radii_m: [f64; 3]) {
        let wrong = radii_m.into_iter().find(|&radius| !Property::Radius.allows(radius));
        self.radius.number = wrong.unwrap_or_else(|| radius_of_equal_volume(radii_m));
        self.radius.fault = None;
        self.radii_m = Some(radii_m);
    }
}

impl ParameterSet {
    /// Adds a contact geometry to the surfaces of this set.
    fn add(&mut self, surface: ContactGeometry) {
        match surface {
            ContactGeometry::Sphere(sphere) => self.spheres.push(sphere),
            ContactGeometry::HalfSpace(id, base) => {
                self.half_space_bases.push(base);
                self.half_space_components.push(id);
            }
            ContactGeometry::Other(id) => self.other_surfaces.push(id),
        }
    }
}

pub static GEOMETRY_CLASSES: [&str; 6] = [
    "ContactSphere",
    "ContactHalfSpace",
    "ContactMesh",
    "ContactEllipsoid",
    "ContactCylinder",
    "ContactTorus",
];
/// The name of the element `constant_contact_force` in the first version of Moco's class.
pub(super) const OLD_CONSTANT_TAG: &str = "derivative_smoothing";
/// The last document version in which `isDisabled` switches a force off. Later documents ignore it.
pub const LAST_VERSION_WITH_IS_DISABLED: u32 = 30508;
/// The name of the list of parameter sets in a `HuntCrossleyForce`.
pub(super) const CONTACT_PARAMETERS_SET: &str = "HuntCrossleyForce::ContactParametersSet";

/// The list of parameter sets of a force, in any of its three spellings. OpenSim prefers the element `<contact_parameters>`, then the set
/// with this name, then a set without a name (documents of version 2), in any order in the file.
fn parameter_sets_of(document: &Document, force: ElementId) -> Option<ElementId> {
    let tree = document.tree();
    if let Some(wrapper) = tree.child(force, "contact_parameters") {
        return tree.child(wrapper, CONTACT_PARAMETERS_SET);
    }
    let with_name = |accept: fn(&str) -> bool| {
        tree.children(force).find(|&child| {
            tree.name(child) == CONTACT_PARAMETERS_SET
                && accept(&tree.attribute(child, "name").unwrap_or_default())
        })
    };
    with_name(|name| name == "contact_parameters").or_else(|| with_name(str::is_empty))
}

/// A part of the model that was read although it is written wrongly. OpenSim may read it differently.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Irregularity {
    /// The path `text` in the component `owner` leads to no component. The only component with its last name was taken instead.
    TakenByName {
        /// Component path of the object that contains the path.
        owner: String,
        /// Class of the object that contains the path.
        class: String,
        /// The path as the file writes it.
        text: String,
        /// The text that OpenSim finds: the component path of the object that was taken, or its name in documents that name bodies.
        taken: String,
        /// The element of the main file whose whole text is the path, if a new text can replace it.
        socket: Option<ElementId>,
        position: TextPosition,
    },
    /// The socket of an object leads to no component.
    LeadsNowhere {
        /// Component path of the object that has the socket.
        owner: String,
        /// Name of the socket, such as `parent_frame`.
        socket: String,
        /// The path as the file writes it; empty if there is none.
        text: String,
        position: TextPosition,
    },
    /// The parameter set of a force has a `name` for which OpenSim does not look.
    MisnamedSet {
        /// Component path of the force.
        force: String,
        /// Name of the parameter set.
        name: String,
        position: TextPosition,
    },
}
