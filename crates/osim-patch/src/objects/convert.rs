//! Converts forces to the other class, one force for each sphere.

use contact_scaling::{RatioValues, Ratios, falisse2022};
use foldhash::{HashMap, HashSet};
use osim_model::messages::{readable, shown};
use osim_model::{
    Class, ElementId, Fault, FaultKind, Finding, Force, ForceKind, Model, PieceKind, Property, Result,
    Selected, Sphere, Tree, moving_spheres,
};

use crate::builder::refuse_included;
use crate::edit::{Edit, model_with_edits};
use crate::insert::{indentation_unit, white_space_before};
use crate::objects::layout::{ContactLayout, NewContact, SpherePlanePair, sphere_plane_pairs};
use crate::objects::nodes::{self, NamesInList, SurfacesInsideForces};
use crate::objects::rebuilt::{ObjectAction, ObjectChange, RebuiltModel, TakenNames, refuse_non_utf8_name};
use crate::objects::sets::{GEOMETRY_SET, refuse_partial_model};
use crate::rules;

/// The properties that only smoothed forces have.
const SMOOTHING_PROPERTIES: [Property; 3] =
    [Property::ConstantContactForce, Property::HertzSmoothing, Property::HuntCrossleySmoothing];

/// The options for the conversion of forces to another class.
#[derive(Debug, Clone, PartialEq)]
pub struct Convert {
    pub to: ForceKind,
    /// `constant_contact_force` of new smoothed forces, m². A smoothing parameter that is `None` is computed from the
    /// dimensionless smoothing of Falisse et al. (2022) and the radius of each sphere: (C.2), (C.5), (C.10).
    pub constant_contact_force: Option<f64>,
    /// Hertz smoothing of new forces, 1/m.
    pub hertz_smoothing: Option<f64>,
    /// Hunt–Crossley smoothing of new forces, s/m.
    pub hunt_crossley_smoothing: Option<f64>,
    /// Whether a sphere and a half-space with different parameters are an error instead of a warning.
    pub strict: bool,
}

impl Convert {
    /// A conversion to the class `to`, in which all smoothing is computed.
    pub const fn new(to: ForceKind) -> Self {
        Self {
            to,
            constant_contact_force: None,
            hertz_smoothing: None,
            hunt_crossley_smoothing: None,
            strict: false,
        }
    }
}

/// A model with converted forces, and the remarks for the user.
#[derive(Debug, Clone, PartialEq)]
pub struct Converted {
    pub rebuilt: RebuiltModel,
    pub findings: Vec<Finding>,
    /// Names of forces that became several forces: the old name, and the new names.
    pub renamed: Vec<(String, Vec<String>)>,
    /// Paths of forces without a moving sphere; these forces stay as they are.
    pub without_sphere: Vec<String>,
    /// Paths of forces with content that their new forces do not have, and a description of it.
    pub dropped: Vec<(String, String)>,
}

/// `model` with the forces `selected` converted to the wanted class: one force for each pair of a sphere and a half-space.
/// Stiffness, dissipation, friction and transition velocity stay bit for bit if the surfaces of a force share their parameters.
///
/// # Errors
/// - A file that is a set and no model, or a model with a set in another file.
/// - A force without a half-space, a sphere on the half-space's own body, or a pair that is pressed several times: by name.
/// - Values that are not plain numbers.
/// - Surfaces with different parameters, if [`Convert::strict`] is set.
pub fn convert(model: &Model, selected: &Selected, wanted: &Convert) -> Result<Converted> {
    refuse_partial_model(model)?;
    let document = model.document();
    let tree = document.tree();
    let (mut names, list) = (TakenNames::of(model), NamesInList::of(model));
    let (mut findings, mut renamed) = (Vec::new(), Vec::new());
    let (mut without_sphere, mut dropped) = (Vec::new(), Vec::new());
    let (mut edits, mut objects, mut inside) = (Vec::new(), Vec::new(), SurfacesInsideForces::default());
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        refuse_included(model, force.file, &force.path)?;
        if moving_spheres(model, &[force.id]).is_empty() && has_half_space(force) {
            without_sphere.push(force.path.clone());
            continue;
        }
        let pairs = checked_pairs(model, force, wanted.to)?;
        let is_one = pairs.len() == 1 && moving_spheres(model, &[force.id]).len() == 1;
        if force.kind == wanted.to && is_one && !keeps_sphere_inside(model, force) {
            continue;
        }
        let mut content = dropped_content(tree, force.element);
        if force.kind != wanted.to && wanted.to == ForceKind::HuntCrossley {
            content.extend(dropped_smoothing(model, force, &pairs));
        }
        if !content.is_empty() {
            dropped.push((force.path.clone(), content.join(", ")));
        }
        if let Some(pair) = pairs.iter().find(|pair| pair.is_composite) {
            let sphere = model.sphere(pair.sphere).map_or("", |sphere| sphere.name.as_str());
            let text = rules::composite_surfaces_message(force, sphere, &pair.plane.name);
            if wanted.strict {
                let kind = FaultKind::StrictlyRefused { text };
                return Err(Fault::new(kind).at_element(force.path.clone()));
            }
            let remark = Finding::at(&rules::COMPOSITE_SURFACES, force.position, text);
            findings.push(remark.with_place(&force.path));
        }
        let (edit, new) = divide_force(model, force, &pairs, wanted, (&mut names, &list, &mut inside))?;
        edits.push(edit);
        let own: Vec<String> = new.iter().map(|object| object.name.clone()).collect();
        if own != [force.name.clone()] {
            renamed.push((force.name.clone(), own));
        }
        let removed = [force.name.as_str(), &force.path];
        objects.push(ObjectChange::new(ObjectAction::Removed, force.kind.as_str(), removed, None));
        objects.extend(new);
    }
    edits.extend(renamed_members(tree, document.data_root(), &renamed));
    if !inside.geometry.is_empty() {
        let root = document.data_root();
        edits.extend(GEOMETRY_SET.add(tree, root, &inside.geometry, &mut String::new()));
        objects.splice(0..0, inside.objects);
    }
    let rebuilt = RebuiltModel::new(model_with_edits(model, edits)?, objects, String::new());
    Ok(Converted { rebuilt, findings, renamed, without_sphere, dropped })
}

fn has_half_space(force: &Force) -> bool {
    force.sets.iter().any(|set| set.half_spaces > 0)
}

/// The pairs of sphere and half-space of a force; refuses a force that cannot be converted.
fn checked_pairs(model: &Model, force: &Force, to: ForceKind) -> Result<Vec<SpherePlanePair>> {
    let leave_out = |text: String, otherwise: &'static str| {
        let kind = FaultKind::ForceCannotChange { text, force: force.name.clone(), otherwise };
        Fault::new(kind).at_element(force.path.clone())
    };
    if !has_half_space(force) {
        let text = format!(
            "{} has no half-space among its surfaces, and a force of one sphere needs one",
            force.path
        );
        return Err(leave_out(text, "give it a half-space in OpenSim"));
    }
    let pairs = sphere_plane_pairs(model, force)?;
    let own: HashSet<_> = pairs.iter().map(|pair| pair.sphere).collect();
    let mut moving = moving_spheres(model, &[force.id]).into_iter();
    if let Some(sphere) = moving.find(|sphere| !own.contains(sphere)).and_then(|id| model.sphere(id)) {
        let text = format!(
            "{} is on the same body as the half-space of {}, so that they never meet",
            sphere.path, force.path
        );
        return Err(leave_out(text, "take the sphere out of it in OpenSim first"));
    }
    let mut spheres = pairs.iter().filter_map(|pair| model.sphere(pair.sphere));
    if to == ForceKind::SmoothSphereHalfSpace
        && let Some(ellipsoid) = spheres.find(|sphere| sphere.radii_m.is_some())
    {
        let text = format!("{} is an ellipsoid, and a {} needs a sphere", ellipsoid.path, to.as_str());
        return Err(leave_out(text, "make it a sphere in OpenSim first"));
    }
    Ok(pairs)
}

/// Beginnings of the comments that OpenSim itself writes into contact forces.
const COMMENTS_OF_OPENSIM: &str = "Path to a Component that satisfies|Flag indicating whether the force is|All properties of this object|\
     Material properties.|Names of geometry objects affected|Slip velocity (creep) at which|The stiffness constant (i.e.|\
     The dissipation coefficient, default|The coefficient of |The transition velocity, default|The constant that enforces|\
     The parameter that determines the smoothness|List of components that this component owns";

/// Adds the comments and elements inside a force that its new forces do not have, except comments that OpenSim writes.
fn add_dropped_content(tree: &Tree, parent: ElementId, dropped: &mut Vec<String>) {
    for child in tree.children(parent) {
        match tree.name(child) {
            "objects"
            | "contact_parameters"
            | "HuntCrossleyForce::ContactParametersSet"
            | "HuntCrossleyForce::ContactParameters" => add_dropped_content(tree, child, dropped),
            tag @ ("groups" | "components") => {
                dropped.extend(tree.children(child).next().map(|_| format!("<{tag}>")));
            }
            "appliesForce" | "isDisabled" | "geometry" | "connectors" | "derivative_smoothing" => {}
            tag if tag.starts_with("socket_") || tag.starts_with("contact_") => {}
            tag if tag.parse::<Property>().is_ok() => {}
            tag => dropped.push(format!("<{tag}>")),
        }
    }
}

/// The comments, processing instructions, attributes and elements of a force that its new forces do not have.
fn dropped_content(tree: &Tree, force: ElementId) -> Vec<String> {
    let own = tree.content(force).filter_map(|piece| match piece.kind {
        PieceKind::Comment => {
            let text = piece.text.trim_start_matches("<!--").trim_end_matches("-->").trim_ascii();
            let is_own = !COMMENTS_OF_OPENSIM.split('|').any(|start| text.starts_with(start));
            is_own.then(|| format!("the comment '{}'", shown(text)))
        }
        PieceKind::Other => Some(format!("the instruction {}", shown(piece.text))),
        _ => None,
    });
    let mut dropped: Vec<String> = own.collect();
    tree.walk(force, |id| {
        let names = tree.attribute_names(id).filter(|&name| name != "name");
        dropped.extend(names.map(|name| format!("the attribute {}", shown(name))));
        tree.name(id) != "components"
    });
    add_dropped_content(tree, force, &mut dropped);
    dropped
}

/// The smoothing that is written in a force and that a conversion back to its class would not compute again.
fn dropped_smoothing(model: &Model, force: &Force, pairs: &[SpherePlanePair]) -> Vec<String> {
    let tree = model.file(force.file).tree();
    let sphere = pairs.first().and_then(|pair| model.sphere(pair.sphere));
    let mut computed = Vec::new();
    let radius_m = sphere.and_then(|sphere| sphere.radius_m().ok()).unwrap_or(f64::NAN);
    if add_smoothing(&mut computed, radius_m, &Convert::new(force.kind)).is_err() {
        return Vec::new();
    }
    let values = pairs.first().map(|pair| pair.values.as_slice()).unwrap_or_default();
    let lost = computed.into_iter().filter_map(|(property, value)| {
        let &(_, own) = values.iter().find(|(known, _)| *known == property)?;
        let is_lost =
            (own - value).abs() > 1e-6 * value && tree.child(force.element, property.as_str()).is_some();
        is_lost.then(|| format!("{property} {}", readable(own)))
    });
    lost.collect()
}

/// Whether `force` contains its sphere as an element, as in Moco 0.1 to 0.3.
pub(crate) fn keeps_sphere_inside(model: &Model, force: &Force) -> bool {
    force.spheres().iter().filter_map(|&id| model.sphere(id)).any(Sphere::is_inside_force)
}

/// The edit that replaces `force` by one force for each pair, and the new objects.
fn divide_force(
    model: &Model,
    force: &Force,
    pairs: &[SpherePlanePair],
    wanted: &Convert,
    (names, list, inside): (&mut TakenNames, &NamesInList, &mut SurfacesInsideForces),
) -> Result<(Edit, Vec<ObjectChange>)> {
    let document = model.document();
    let tree = document.tree();
    let span = tree.span(force.element);
    let space = white_space_before(tree, span.start);
    let unit = indentation_unit(tree, force.element);
    let (mut text, mut objects) = (String::new(), Vec::new());
    for pair in pairs {
        let Some(sphere) = model.sphere(pair.sphere) else { continue };
        let name = match pairs.len() {
            1 => force.name.clone(),
            _ => names.reserve(&format!("{}_{}", force.name, sphere.name))?,
        };
        let (sphere_path, plane_path) = match sphere.is_inside_force() {
            true => inside.add_surfaces(model, force, (sphere, &pair.plane), names)?,
            false => (sphere.path.clone(), pair.plane.path.clone()),
        };
        for used in [&name, &sphere_path, &plane_path] {
            refuse_non_utf8_name(model, used).map_err(|fault| fault.at_element(force.path.clone()))?;
        }
        let mut values = pair.values.clone();
        match wanted.to {
            ForceKind::HuntCrossley => {
                values.retain(|(property, _)| !SMOOTHING_PROPERTIES.contains(property));
            }
            _ => add_smoothing(&mut values, sphere.radius_m()?, wanted)?,
        }
        let surfaces: [&str; 2] = [&sphere_path, &plane_path];
        let origin = |property: Property| value_origin(property, sphere, pair);
        let written = (values.as_slice(), &origin as &dyn Fn(Property) -> String);
        let node = nodes::force(document, wanted.to, &name, surfaces, written, force.applies, list);
        let node = node.map_err(|fault| Fault::at(fault.kind, span.start).at_element(force.path.clone()))?;
        text.push_str(&node.text(&space, unit));
        let path = format!("{}/{name}", force.path.rsplit_once('/').map_or("", |(set, _)| set));
        let body = sphere.body.as_deref();
        let made = ObjectChange::new(ObjectAction::Added, wanted.to.as_str(), [&name, &path], body);
        objects.push(ObjectChange { parameters: values, ..made });
    }
    // The first begins where the old one did.
    let text = text.strip_prefix(space.as_str()).unwrap_or(&text).to_owned();
    Ok((Edit { span, text }, objects))
}

/// Source of the value of `property` in a new force, in words.
fn value_origin(property: Property, sphere: &Sphere, pair: &SpherePlanePair) -> String {
    let (radius, path) = (readable(sphere.radius.number), &sphere.path);
    let by_radius = |equation: &str| format!("the radius {radius} m of {path} by equation ({equation})");
    match property {
        Property::ConstantContactForce => by_radius("C.2"),
        Property::HertzSmoothing => by_radius("C.5"),
        Property::HuntCrossleySmoothing => by_radius("C.10"),
        _ if pair.is_composite => format!("the numbers of {path} and {} by equation (A.3)", pair.plane.path),
        _ => format!("the force that presses {path}"),
    }
}

/// Adds smoothing parameters to a force that has none.
fn add_smoothing(values: &mut Vec<(Property, f64)>, radius_m: f64, wanted: &Convert) -> Result<()> {
    let human = falisse2022();
    let radius = radius_m / human.scale.radius_m();
    let ratios = Ratios::new(RatioValues { mass: 1.0, sphere_count: 1.0, radius, gravity: 1.0 });
    let ratios = ratios.map_err(Fault::new)?;
    let Some(scaled) = human.contact.scaled(&ratios).smoothing() else { return Ok(()) };
    let own = [
        (Property::ConstantContactForce, wanted.constant_contact_force, scaled.constant_contact_force),
        (Property::HertzSmoothing, wanted.hertz_smoothing, scaled.hertz_smoothing),
        (Property::HuntCrossleySmoothing, wanted.hunt_crossley_smoothing, scaled.hunt_crossley_smoothing),
    ];
    for (property, given, scaled) in own {
        let value = given.unwrap_or(scaled);
        if property == Property::ConstantContactForce && value == 0.0 {
            return Err(Fault::new(FaultKind::ZeroConstantContactForce));
        }
        match values.iter_mut().find(|(known, _)| *known == property) {
            // Divided forces of the smooth class keep theirs.
            Some((_, old)) => *old = given.unwrap_or(*old),
            None => values.push((property, value)),
        }
    }
    Ok(())
}

/// Edits of object groups: members that are forces get the new names of these forces.
fn renamed_members(tree: &Tree, model: ElementId, renamed: &[(String, Vec<String>)]) -> Vec<Edit> {
    let groups = tree
        .child(model, crate::objects::sets::FORCE_SET_TAG)
        .and_then(|set| tree.child(set, "groups"))
        .into_iter()
        .flat_map(|groups| tree.children(groups))
        .filter_map(|group| tree.child(group, "members"));
    let new_names: HashMap<&str, &[String]> =
        renamed.iter().rev().map(|(old, new)| (old.as_str(), new.as_slice())).collect();
    let edit = |members: ElementId| {
        let raw = tree.raw_text(members);
        let text = tree.text_of(members);
        let mut changed = false;
        let words = osim_model::opensim_text::list_words(&text).flat_map(|word| match new_names.get(word) {
            Some(new) => {
                changed = true;
                new.to_vec()
            }
            None => vec![word.to_owned()],
        });
        let words = words.collect::<Vec<_>>().join(" ");
        changed.then(|| Edit { span: raw.span, text: crate::insert::escaped_attribute(&words) })
    };
    groups.filter_map(edit).collect()
}

impl ContactLayout {
    /// The contacts with forces of the class `kind`, as [`convert`](crate::objects::convert()) makes them. Parameters that
    /// `kind` does not have are removed. Missing smoothing parameters are computed from the dimensionless smoothing of
    /// Falisse et al. (2022) and the radius of each sphere.
    ///
    /// # Errors
    /// A radius outside its domain.
    pub fn into_class(mut self, kind: ForceKind) -> Result<Self> {
        for contact in self.contacts.iter_mut().filter(|contact| contact.kind != kind) {
            contact.set_class(kind)?;
        }
        Ok(self)
    }
}

impl NewContact {
    /// Gives the contact another class of force; parameters that it lacks are computed.
    fn set_class(&mut self, kind: ForceKind) -> Result<()> {
        self.kind = kind;
        if kind == ForceKind::SmoothSphereHalfSpace {
            return add_smoothing(&mut self.values, self.radius_m, &Convert::new(kind));
        }
        self.values.retain(|(property, _)| !SMOOTHING_PROPERTIES.contains(property));
        Ok(())
    }

    /// Adds a value for each missing parameter of the force class: OpenSim's default, except for the smoothing. OpenSim's
    /// default smoothing suits no size, so it is computed from the dimensionless smoothing of Falisse et al. (2022) and the
    /// radius of the sphere.
    ///
    /// ```
    /// use osim_model::{ForceKind, Property};
    /// use osim_patch::NewContact;
    ///
    /// let mut heel = NewContact::new(ForceKind::SmoothSphereHalfSpace, "force_heel", "heel");
    /// heel.radius_m = 0.032;
    /// let heel = heel.with_defaults()?;
    /// let of = |wanted| heel.values.iter().find(|(property, _)| *property == wanted).map(|(_, value)| *value);
    /// assert_eq!((of(Property::StaticFriction), of(Property::TransitionVelocity)), (Some(0.0), Some(0.01)));
    /// assert_eq!(of(Property::HertzSmoothing), Some(300.0));
    /// # Ok::<(), osim_model::Fault>(())
    /// ```
    pub fn with_defaults(mut self) -> Result<Self> {
        self.set_class(self.kind)?;
        let classes: &[Class] = match self.kind {
            ForceKind::SmoothSphereHalfSpace => &[Class::SmoothSphereHalfSpaceForce],
            _ => &[Class::ContactParameters, Class::HuntCrossleyForce],
        };
        for &class in classes {
            for &property in class.parameters() {
                if !self.values.iter().any(|(known, _)| *known == property) {
                    self.values.push((property, class.default(property)));
                }
            }
        }
        Ok(self)
    }

    /// Gives the contact a value of a parameter.
    pub fn set_value(&mut self, property: Property, value: f64) {
        match self.values.iter_mut().find(|(known, _)| *known == property) {
            Some((_, old)) => *old = value,
            None => self.values.push((property, value)),
        }
    }
}
