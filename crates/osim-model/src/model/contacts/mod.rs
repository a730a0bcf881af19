//! Contact spheres and contact forces. All their spellings in files become the same types; [`loaded_spheres`] gives the data for contact
//! laws.

mod force;
mod half_space;
mod irregularity;
mod planes;
mod read;

use std::collections::BTreeMap;

use contact_scaling::modulus::{self, SurfaceValues};
use contact_scaling::{Contact, ContactValues, SmoothingValues};
use foldhash::{HashMap, HashMapExt};

use crate::model::components::{Carrier, ComponentId};
use crate::model::{Fault, Model, Property, Result};
use crate::xml::opensim_text;
pub use force::{Force, ForceId, ForceKind, ParameterSet, SetId, Slot, Sphere, SphereId};
pub use half_space::{FrameProperty, HalfSpace, Orientation};
pub use planes::GroundPlane;
pub(crate) use read::ContactReader;
pub use read::{GEOMETRY_CLASSES, Irregularity, LAST_VERSION_WITH_IS_DISABLED, radius_of_equal_volume};

/// One sphere that a force presses on a surface, with the data for the contact laws: from [`loaded_spheres`].
///
/// ```
/// use osim_model::{Model, Selection};
/// use osim_model::loaded_spheres;
///
/// # let bytes: &[u8] = include_bytes!("../../../tests/data/one_foot.osim");
/// let model = Model::parse(bytes)?;
/// let selected = Selection::default().apply(&model)?;
/// let spheres = loaded_spheres(&model, &selected.forces)?;
/// // The file says <radius>0.03</radius>, <stiffness>1000000</stiffness> and <dissipation>2</dissipation>.
/// let sphere = &spheres[0];
/// assert_eq!(model.sphere(sphere.sphere).map(|sphere| sphere.name.as_str()), Some("heel_r"));
/// assert_eq!((sphere.radius_m, sphere.contact.dissipation()), (0.03, 2.0));
/// assert!((sphere.contact.plane_strain_modulus() - 1e6).abs() < 1e-6);
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedSphere {
    pub sphere: SphereId,
    /// The force that presses the sphere on a surface.
    pub force: ForceId,
    /// Parameter set of the sphere in the force.
    pub set: SetId,
    pub radius_m: f64,
    /// The contact of two equal surfaces that are together as stiff as sphere and plane (A.3, A.4): E₁* (N/m²), α (s/m), and smoothing
    /// parameters if the class has them.
    pub contact: Contact,
}

/// Every moving sphere that a switched-on force among `forces` presses on a half-space. A sphere under two forces appears twice.
///
/// # Errors
/// A value that is not a plain number or outside its domain, with its place; or an ellipsoid.
pub fn loaded_spheres(model: &Model, forces: &[ForceId]) -> Result<Vec<LoadedSphere>> {
    loaded_spheres_where(model, forces, |_| true)
}

/// The spheres of [`loaded_spheres`], but without ellipsoids.
pub fn loaded_round_spheres(model: &Model, forces: &[ForceId]) -> Result<Vec<LoadedSphere>> {
    loaded_spheres_where(model, forces, |sphere| sphere.radii_m.is_none())
}

fn loaded_spheres_where(
    model: &Model,
    forces: &[ForceId],
    wanted: impl Fn(&Sphere) -> bool,
) -> Result<Vec<LoadedSphere>> {
    let mut loaded = Vec::new();
    for &id in forces {
        let Some(force) = model.force(id).filter(|force| force.applies) else { continue };
        if !model.meets_half_space(force) {
            continue;
        }
        let surfaces = Surfaces::of(force)?;
        for set in &force.sets {
            let spheres = set.spheres.iter().filter_map(|&id| model.sphere(id));
            let mut moving = spheres.filter(|sphere| !sphere.fixed).peekable();
            if moving.peek().is_none() {
                continue;
            }
            let contact = contact_of_set(force, &surfaces, set.id)?;
            for sphere in moving.filter(|sphere| wanted(sphere)) {
                let (set, radius_m) = (set.id, sphere.round_radius_m()?);
                loaded.push(LoadedSphere { sphere: sphere.id, force: id, set, radius_m, contact });
            }
        }
    }
    Ok(loaded)
}

/// The contact between the spheres of parameter set `set` and the plane of the force.
///
/// # Errors
/// A value is not a plain number or is outside its domain. The error has the place in the file.
pub fn contact_of_set(force: &Force, surfaces: &Surfaces, set: SetId) -> Result<Contact> {
    contact_of_pair(force, surfaces, set, surfaces.plane.unwrap_or(set))
}

/// The contact of parameter set `set` with a plane in the set `plane`, which has its own parameters.
pub fn contact_of_pair(force: &Force, surfaces: &Surfaces, set: SetId, plane: SetId) -> Result<Contact> {
    let SurfaceValues { plane_strain_modulus, dissipation } = surfaces.mixed(set, plane)?;
    let get = |property| force.checked(set, property);
    let smoothing = match (
        get(Property::ConstantContactForce)?,
        get(Property::HertzSmoothing)?,
        get(Property::HuntCrossleySmoothing)?,
    ) {
        (Some(constant_contact_force), Some(hertz_smoothing), Some(hunt_crossley_smoothing)) => {
            Some(SmoothingValues { constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })
        }
        _ => None,
    };
    Contact::new(ContactValues { plane_strain_modulus, dissipation, smoothing })
        .map_err(|error| Fault::new(error).at_element(force.path.clone()))
}

// Surfaces with parameters of their own, and their mixture (A.3).

/// The parameter sets of `force` that contain moving spheres, with these spheres.
pub fn sphere_sets(model: &Model, force: &Force) -> Vec<(SetId, Vec<SphereId>)> {
    let moving = |sphere: &SphereId| model.sphere(*sphere).is_some_and(|sphere| !sphere.fixed);
    let sets = force.sets.iter();
    sets.map(|set| (set.id, set.spheres.iter().copied().filter(moving).collect::<Vec<_>>()))
        .filter(|(_, spheres)| !spheres.is_empty())
        .collect()
}

/// Modulus and dissipation of every parameter set of a force, and the set that contains the plane.
pub struct Surfaces {
    sets: Vec<SurfaceValues>,
    /// The parameter set that contains the first plane.
    plane: Option<SetId>,
}

impl Surfaces {
    /// Reads modulus and dissipation of every parameter set of `force`.
    pub fn of(force: &Force) -> Result<Self> {
        let mut sets = Vec::with_capacity(force.sets.len());
        for set in force.sets.iter().map(|set| set.id) {
            let plane_strain_modulus = force.checked(set, Property::Stiffness)?.unwrap_or(f64::NAN);
            let dissipation = force.checked(set, Property::Dissipation)?.unwrap_or(0.0);
            sets.push(SurfaceValues { plane_strain_modulus, dissipation });
        }
        Ok(Self { sets, plane: force.sets.iter().find(|set| set.half_spaces > 0).map(|set| set.id) })
    }

    /// E₁* and α of the contact between parameter set `set` and the plane, as values of two equal surfaces: (A.3), (A.4).
    pub fn with_plane(&self, set: SetId) -> Result<SurfaceValues> {
        self.mixed(set, self.plane.unwrap_or(set))
    }

    /// E₁* and α of two equal surfaces that touch like the surfaces of the sets `set` and `plane`: (A.3), (A.4).
    pub fn mixed(&self, set: SetId, plane: SetId) -> Result<SurfaceValues> {
        const NO_SURFACE: SurfaceValues = SurfaceValues { plane_strain_modulus: f64::NAN, dissipation: 0.0 };
        let surface = self.sets.get(set.index()).copied().unwrap_or(NO_SURFACE);
        let plane = self.sets.get(plane.index()).copied().unwrap_or(surface);
        if surface == plane {
            return Ok(surface);
        }
        let composite = modulus::composite_sherman(surface.plane_strain_modulus, plane.plane_strain_modulus)
            .map_err(Fault::new)?;
        let plane_strain_modulus =
            modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman).map_err(Fault::new)?;
        let dissipation = modulus::mixed_dissipation(surface, plane).map_err(Fault::new)?;
        Ok(SurfaceValues { plane_strain_modulus, dissipation })
    }
}

// Spheres that move, and their radii.

/// Root of the mean of the squared radii; exactly the common radius if all are equal.
pub fn root_mean_square(radii: impl Iterator<Item = f64> + Clone) -> f64 {
    let mut others = radii.clone();
    match others.next() {
        None => f64::NAN,
        Some(first) if others.all(|other| other == first) => first,
        Some(_) => {
            let add = |(sum, count), radius: f64| (sum + radius * radius, count + 1.0);
            let (sum, count) = radii.fold((0.0, 0.0), add);
            (sum / count).sqrt()
        }
    }
}

/// The spheres of `forces` that are neither on ground nor on a body welded to ground, each once, in file order. Only their radii may
/// change.
pub fn moving_spheres(model: &Model, forces: &[ForceId]) -> Vec<SphereId> {
    let mut spheres: Vec<SphereId> =
        forces.iter().filter_map(|&id| model.force(id)).flat_map(Force::spheres).copied().collect();
    spheres.sort_unstable();
    spheres.dedup();
    spheres.retain(|&index| model.sphere(index).is_some_and(|sphere| !sphere.fixed));
    spheres
}

impl Model {
    /// The pairs of spheres that `force` can press on each other: on different bodies, and not both fixed. Empty if the force has a
    /// surface that is not a sphere.
    pub fn sphere_pairs(&self, force: &Force) -> Vec<[&Sphere; 2]> {
        let mut pairs = Vec::new();
        if force.sets.iter().any(|set| set.half_spaces > 0 || !set.other_surfaces.is_empty()) {
            return pairs;
        }
        let spheres: Vec<&Sphere> = force.spheres().iter().filter_map(|&id| self.sphere(id)).collect();
        for (index, &one) in spheres.iter().enumerate() {
            let is_other = |other: &&Sphere| {
                (one.base != other.base || one.base == Carrier::Unknown) && !(one.fixed && other.fixed)
            };
            pairs.extend(spheres.iter().skip(index + 1).copied().filter(is_other).map(|other| [one, other]));
        }
        pairs
    }

    /// The moving spheres that several switched-on forces press on ground, with these forces, in file order.
    pub fn spheres_in_several_forces(&self) -> Vec<(&Sphere, Vec<&Force>)> {
        let mut users: BTreeMap<SphereId, Vec<&Force>> = BTreeMap::new();
        for force in self.forces().iter().filter(|force| force.applies && self.meets_half_space(force)) {
            for sphere in moving_spheres(self, &[force.id]) {
                users.entry(sphere).or_default().push(force);
            }
        }
        let shared = users.into_iter().filter(|(_, forces)| forces.len() > 1);
        shared.filter_map(|(id, forces)| Some((self.sphere(id)?, forces))).collect()
    }
}

// Contact forces of other classes.

/// Classes of contact forces that do not follow the Hertz law. They are not scaled.
pub static OTHER_CONTACT_CLASSES: [&str; 3] =
    ["ElasticFoundationForce", "ExponentialContactForce", "MeyerFregly2016Force"];
/// The tag of the parameters of an `ElasticFoundationForce`.
const ELASTIC_FOUNDATION_PARAMETERS: &str = "ElasticFoundationForce::ContactParameters";

impl Model {
    /// The forces of other contact classes that use a contact sphere, by the sphere's name.
    pub fn forces_of_other_classes(&self) -> HashMap<String, Vec<String>> {
        let mut users: HashMap<String, Vec<String>> = HashMap::new();
        for (force, surface) in self.surfaces_of_foundations() {
            users.entry(surface).or_default().push(self.components().name(force).into_owned());
        }
        users
    }

    /// Each `ElasticFoundationForce`, with the name of each of its surfaces.
    fn surfaces_of_foundations(&self) -> Vec<(ComponentId, String)> {
        let components = self.components();
        let mut surfaces = Vec::new();
        let foundations =
            components.tree.iter().filter(|(id, _)| components.tag(*id) == ELASTIC_FOUNDATION_PARAMETERS);
        for (id, _) in foundations {
            let tree = components.document_of(id).tree();
            let Some(geometry) = tree.child(components.element(id), "geometry") else { continue };
            let mut at = components.tree.get(id).and_then(|object| object.parent);
            while let Some(force) = at.filter(|&force| components.tag(force) != "ElasticFoundationForce") {
                at = components.tree.get(force).and_then(|object| object.parent);
            }
            let Some(force) = at else { continue };
            for name in opensim_text::list_words(&tree.text_of(geometry)) {
                surfaces.push((force, name.rsplit('/').next().unwrap_or(name).to_owned()));
            }
        }
        surfaces
    }

    /// The contact geometry of forces of other classes, by force.
    pub fn surfaces_of_other_classes(&self) -> HashMap<ComponentId, Vec<ComponentId>> {
        let components = self.components();
        let all = components.tree.iter().map(|(id, _)| id);
        let mut by_name = HashMap::new();
        for id in all.filter(|&id| GEOMETRY_CLASSES.contains(&components.tag(id))) {
            by_name.entry(components.name(id).into_owned()).or_insert(id);
        }
        let mut by_force: HashMap<ComponentId, Vec<ComponentId>> = HashMap::new();
        for (force, name) in self.surfaces_of_foundations() {
            by_force.entry(force).or_default().extend(by_name.get(&name));
        }
        by_force
    }

    /// The switched-on forces of other contact classes that press a moving body on ground.
    pub fn carriers_of_other_classes(&self) -> Vec<ComponentId> {
        let components = self.components();
        let is_on = |id: ComponentId| {
            let flag = components.document_of(id).flag(components.element(id), "appliesForce");
            flag.ok().flatten().unwrap_or(true)
        };
        let is_fixed = |surface: ComponentId| {
            let frame = components.frame_at(surface, "frame", &["body_name"])?;
            Some(self.skeleton().is_fixed(components.base(frame.component).ok()?))
        };
        let by_force = self.surfaces_of_other_classes();
        let meets_ground = |id: ComponentId| {
            let own = by_force.get(&id).into_iter().flatten();
            let surfaces: Vec<bool> = own.filter_map(|&surface| is_fixed(surface)).collect();
            components.tag(id) != "ElasticFoundationForce"
                || (surfaces.contains(&true) && surfaces.contains(&false))
        };
        let all = components.tree.iter().map(|(id, _)| id);
        let others = all.filter(|&id| OTHER_CONTACT_CLASSES.contains(&components.tag(id)));
        others.filter(|&id| is_on(id) && meets_ground(id)).collect()
    }
}
