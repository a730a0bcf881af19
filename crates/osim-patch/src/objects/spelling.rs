//! How contact objects are written in documents of each version.

use std::collections::HashSet;

use osim_messages::shortest;
use osim_model::{Class, Document, ForceKind, Model, Orientation, Property};

use super::layout::NewContact;
use crate::node::Node;

/// The first version in which geometry has a `socket_frame`; before, OpenSim refuses it, and afterwards `body_name`.
const FIRST_WITH_SOCKET_FRAME: u32 = 30505;

/// Where a geometry is attached to.
pub(super) struct Carrier<'c> {
    /// Name of the body, or `ground`.
    pub(super) name: &'c str,
    /// Component path.
    pub(super) path: &'c str,
}

/// Ground.
pub(super) const GROUND: Carrier<'static> = Carrier { name: "ground", path: "/ground" };

impl Carrier<'_> {
    fn node(&self, version: u32) -> Node {
        if version < FIRST_WITH_SOCKET_FRAME {
            Node::leaf("body_name", crate::node::escaped(self.name))
        } else {
            Node::leaf("socket_frame", crate::node::escaped(self.path))
        }
    }
}

pub(super) fn triple(values: [f64; 3]) -> String {
    // The mirror image of 0 is 0, without a minus.
    values.map(|value| shortest(value + 0.0)).join(" ")
}

/// A `ContactSphere`.
pub(super) fn sphere(version: u32, carrier: &Carrier<'_>, contact: &NewContact) -> Node {
    let place = Node::leaf("location", triple(contact.location_m));
    let radius = Node::leaf("radius", shortest(contact.radius_m));
    Node::object(Class::ContactSphere.tag(), &contact.sphere, vec![carrier.node(version), place, radius])
}

/// A `ContactHalfSpace` on ground through its origin, that faces `up`.
pub(super) fn floor(version: u32, name: &str, up: [f64; 3]) -> Node {
    let place = Node::leaf("location", triple([0.0; 3]));
    let turned = Node::leaf("orientation", triple(Orientation::facing(up)));
    Node::object("ContactHalfSpace", name, vec![GROUND.node(version), place, turned])
}

/// The two surfaces of a force.
pub(super) struct Surfaces<'s> {
    /// Component path of the sphere.
    pub(super) sphere: &'s str,
    /// Component path of the half-space.
    pub(super) plane: &'s str,
}

/// A force of `kind` between one sphere and one half-space, with these values. What `document` has in its `<defaults>` does not
/// change it: what is not in `values` is then written as OpenSim has it without them.
pub(super) fn force(
    document: &Document,
    kind: ForceKind,
    name: &str,
    surfaces: &Surfaces<'_>,
    values: &[(Property, f64)],
    applies: bool,
) -> Node {
    let escaped = crate::node::escaped;
    let values_of = |class: Class| {
        let value = |property: Property| {
            let given = values.iter().find(|(known, _)| *known == property).map(|(_, value)| *value);
            given.or_else(|| has_default(document, class, property.name()).then(|| class.default(property)))
        };
        let leaf = |&property: &Property| Some(Node::leaf(property.name(), shortest(value(property)?)));
        class.parameters().iter().filter_map(leaf).collect::<Vec<_>>()
    };
    let on_or_off = |class: Class| {
        let is_changed = ["appliesForce", "isDisabled"].iter().any(|tag| has_default(document, class, tag));
        (!applies || is_changed).then(|| Node::leaf("appliesForce", applies.to_string()))
    };
    match kind {
        ForceKind::HuntCrossley => {
            let geometry = format!("{} {}", escaped(surfaces.sphere), escaped(surfaces.plane));
            let mut parameters = vec![Node::leaf("geometry", geometry)];
            parameters.extend(values_of(Class::ContactParameters));
            let list =
                Node::parent("objects", vec![Node::parent(Class::ContactParameters.tag(), parameters)]);
            let set =
                Node::object("HuntCrossleyForce::ContactParametersSet", "contact_parameters", vec![list]);
            let mut children: Vec<Node> = on_or_off(Class::HuntCrossleyForce).into_iter().collect();
            children.push(set);
            children.extend(values_of(Class::HuntCrossleyForce));
            Node::object(kind.as_str(), name, children)
        }
        _ => {
            let mut children = vec![
                Node::leaf("socket_sphere", escaped(surfaces.sphere)),
                Node::leaf("socket_half_space", escaped(surfaces.plane)),
            ];
            children.extend(on_or_off(Class::SmoothSphereHalfSpaceForce));
            children.extend(values_of(Class::SmoothSphereHalfSpaceForce));
            Node::object(kind.as_str(), name, children)
        }
    }
}

/// Whether `<defaults>` give objects of `class` a property, which they then have unless they say otherwise.
fn has_default(document: &Document, class: Class, tag: &str) -> bool {
    let tree = document.tree();
    let object = document.defaults().and_then(|defaults| tree.child(defaults, class.tag()));
    object.is_some_and(|object| tree.child(object, tag).is_some())
}

/// How the list of a HuntCrossleyForce calls geometry: members of the geometry set by their names, except those that have the
/// name of a component of the model itself, which OpenSim would find first.
pub(super) struct InList(HashSet<String>);

impl InList {
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

    pub(super) fn call<'p>(&self, path: &'p str) -> &'p str {
        let name = path.strip_prefix("/contactgeometryset/");
        name.filter(|name| !self.0.contains(*name)).unwrap_or(path)
    }
}
