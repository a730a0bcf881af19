//! How contact objects are written in documents of each version.

use foldhash::HashSet;
use osim_model::{Class, Document, Fault, ForceKind, Model, Orientation, Property};

use crate::change;
use crate::insert::Node;
use crate::objects::layout::NewContact;

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
const GROUND: Carrier<'static> = Carrier { name: "ground", path: "/ground" };

impl Carrier<'_> {
    fn node(&self, version: u32) -> Node {
        if version < FIRST_WITH_SOCKET_FRAME {
            Node::leaf("body_name", crate::insert::escaped(self.name))
        } else {
            Node::leaf("socket_frame", crate::insert::escaped(self.path))
        }
    }
}

/// Three numbers of the object called `name`.
fn triple(tag: &str, values: [f64; 3], name: &str) -> Result<Node, Fault> {
    // The mirror image of 0 is 0, without a minus.
    let values = values.map(|value| value + 0.0);
    let text = change::triple_text(values, tag, || format!("the place that {name} is to have"));
    Ok(Node::leaf(tag, text.map_err(|fault| fault.of(name))?))
}

/// A `ContactSphere`.
///
/// # Errors
/// A place that is not finite, or a radius that is not above 0.
pub(super) fn sphere(version: u32, carrier: &Carrier<'_>, contact: &NewContact) -> Result<Node, Fault> {
    let name = contact.sphere.as_str();
    let place = triple("location", contact.location_m, name)?;
    let radius = change::number_text(contact.radius_m, Property::Radius, || {
        format!("the radius that {name} is to have")
    });
    let radius = Node::leaf("radius", radius.map_err(|fault| fault.of(name))?);
    Ok(Node::object(Class::ContactSphere.tag(), name, vec![carrier.node(version), place, radius]))
}

/// A `ContactHalfSpace` with this place and these angles.
///
/// # Errors
/// A number that is not finite.
pub(super) fn half_space(
    version: u32,
    carrier: &Carrier<'_>,
    name: &str,
    [location_m, angles_rad]: [[f64; 3]; 2],
) -> Result<Node, Fault> {
    let place = triple("location", location_m, name)?;
    let turned = triple("orientation", angles_rad, name)?;
    Ok(Node::object("ContactHalfSpace", name, vec![carrier.node(version), place, turned]))
}

/// A `ContactHalfSpace` on ground through its origin, that faces `up`.
///
/// # Errors
/// A direction that is not finite.
pub(super) fn floor(version: u32, name: &str, up: [f64; 3]) -> Result<Node, Fault> {
    half_space(version, &GROUND, name, [[0.0; 3], Orientation::facing(up)])
}

/// Parameters of a new force, and what each comes from.
pub(super) struct Values<'v> {
    pub(super) numbers: &'v [(Property, f64)],
    pub(super) origin: &'v dyn Fn(Property) -> String,
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
///
/// # Errors
/// A value that is not finite, or outside the domain in which the contact laws hold.
pub(super) fn force(
    document: &Document,
    kind: ForceKind,
    name: &str,
    surfaces: &Surfaces<'_>,
    values: &Values<'_>,
    applies: bool,
) -> Result<Node, Fault> {
    let escaped = crate::insert::escaped;
    let values_of = |class: Class| {
        let value = |property: Property| {
            let given = values.numbers.iter().find(|(known, _)| *known == property).map(|(_, value)| *value);
            given.or_else(|| has_default(document, class, property.name()).then(|| class.default(property)))
        };
        let leaf = |&property: &Property| {
            let text = change::number_text(value(property)?, property, || (values.origin)(property));
            Some(text.map(|text| Node::leaf(property.name(), text)).map_err(|fault| fault.of(name)))
        };
        class.parameters().iter().filter_map(leaf).collect::<Result<Vec<_>, _>>()
    };
    let on_or_off = |class: Class| {
        let is_changed = ["appliesForce", "isDisabled"].iter().any(|tag| has_default(document, class, tag));
        (!applies || is_changed).then(|| Node::leaf("appliesForce", applies.to_string()))
    };
    Ok(match kind {
        ForceKind::HuntCrossley => {
            let geometry = format!("{} {}", escaped(surfaces.sphere), escaped(surfaces.plane));
            let mut parameters = vec![Node::leaf("geometry", geometry)];
            parameters.extend(values_of(Class::ContactParameters)?);
            let list =
                Node::parent("objects", vec![Node::parent(Class::ContactParameters.tag(), parameters)]);
            let set =
                Node::object("HuntCrossleyForce::ContactParametersSet", "contact_parameters", vec![list]);
            let mut children: Vec<Node> = on_or_off(Class::HuntCrossleyForce).into_iter().collect();
            children.push(set);
            children.extend(values_of(Class::HuntCrossleyForce)?);
            Node::object(kind.as_str(), name, children)
        }
        _ => {
            let mut children = vec![
                Node::leaf("socket_sphere", escaped(surfaces.sphere)),
                Node::leaf("socket_half_space", escaped(surfaces.plane)),
            ];
            children.extend(on_or_off(Class::SmoothSphereHalfSpaceForce));
            children.extend(values_of(Class::SmoothSphereHalfSpaceForce)?);
            Node::object(kind.as_str(), name, children)
        }
    })
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
