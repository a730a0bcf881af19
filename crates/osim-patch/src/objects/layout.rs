//! Layouts of new contacts: spheres on bodies with their places and parameters, from a preset, from a model, or mirrored.

use contact_scaling::modulus::SurfaceValues;
use foldhash::{HashMap, HashMapExt, HashSet};
use indexmap::IndexMap;
use osim_model::messages::counted;
use osim_model::{
    Anatomy, AnatomyJoint, AnatomySphere, Fault, FaultKind, Force, ForceKind, HalfSpace, Model, ParameterSet,
    Property, Result, Rotation, Selected, SetId, Side, Sphere, SphereId, Surfaces,
};

/// A contact to add to a model: a sphere, and the force between the sphere and the floor.
#[derive(Debug, Clone, PartialEq)]
pub struct NewContact {
    pub force: String,
    pub sphere: String,
    /// Name of the body to which the sphere is attached.
    pub body: String,
    /// Centre of the sphere in the frame of its body, m.
    pub location_m: [f64; 3],
    pub radius_m: f64,
    pub kind: ForceKind,
    /// Parameters of the force in their own units; a missing parameter has OpenSim's default.
    pub values: Vec<(Property, f64)>,
}

impl NewContact {
    /// A contact with a force of `kind`, with OpenSim's defaults for all parameters.
    pub fn new(kind: ForceKind, force: impl Into<String>, sphere: impl Into<String>) -> Self {
        Self {
            force: force.into(),
            sphere: sphere.into(),
            body: String::new(),
            location_m: [0.0; 3],
            radius_m: 0.0,
            kind,
            values: Vec::new(),
        }
    }
}

/// Contacts to add to a model: spheres, a force for each of them, and the name of a floor.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ContactLayout {
    /// The contacts, in the order in which they are written.
    pub contacts: Vec<NewContact>,
    /// Name of a new floor, if the model has none; an empty name means `floor`.
    pub floor: String,
}

impl ContactLayout {
    /// The contacts of the forces `selected` of `model`: one for each pair of a sphere and a half-space, with centres in the
    /// frames of bodies.
    ///
    /// # Errors
    /// A value that is not a plain number, or a sphere whose place cannot be read.
    pub fn of(model: &Model, selected: &Selected) -> Result<Self> {
        let mut layout = Self::default();
        for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
            let pairs = sphere_plane_pairs(model, force)?;
            let several = pairs.len() > 1;
            for SpherePlanePair { sphere, plane, values, .. } in pairs {
                let Some(own) = model.sphere(sphere) else { continue };
                let Some(body) = own.body.clone() else { continue };
                let place = model.centre_m(sphere).ok_or_else(|| {
                    Fault::refused(format!("the place of {} on its body cannot be read", own.path))
                        .at_element(own.path.clone())
                })?;
                if layout.floor.is_empty() {
                    layout.floor = plane.name.clone();
                }
                layout.contacts.push(NewContact {
                    force: if several { format!("{}_{}", force.name, own.name) } else { force.name.clone() },
                    sphere: own.name.clone(),
                    body,
                    location_m: place.into(),
                    radius_m: own.round_radius_m()?,
                    kind: force.kind,
                    values,
                });
            }
        }
        Ok(layout)
    }

    /// Refuses values that must not be written into another file.
    ///
    /// # Errors
    /// A `constant_contact_force` of 0 ([`FaultKind::ZeroConstantContactForce`]), with the name of its force.
    pub fn check(&self) -> Result<()> {
        let zero = |contact: &&NewContact| contact.values.contains(&(Property::ConstantContactForce, 0.0));
        let Some(contact) = self.contacts.iter().find(zero) else { return Ok(()) };
        Err(Fault::new(FaultKind::ZeroConstantContactForce).at_element(contact.force.clone()))
    }

    /// `anatomy` with the spheres of this layout instead of its own spheres.
    pub fn anatomy(&self, anatomy: Anatomy) -> Anatomy {
        let spheres = self.contacts.iter().map(|contact| {
            AnatomySphere::new(
                contact.sphere.clone(),
                Some(contact.body.clone()),
                (contact.location_m, contact.radius_m),
                Rotation::IDENTITY,
            )
        });
        anatomy.with_spheres(spheres.collect())
    }

    // Contacts of one side, on the other side too.

    /// The contacts and their mirror images in z: names of objects and bodies get `_l` for `_r`, or the other way round. A
    /// contact on a body without a side in its name gets no mirror image.
    ///
    /// # Errors
    /// Contacts on both sides, or on none.
    pub fn mirrored(mut self) -> Result<Self> {
        let sides: Vec<Side> =
            self.contacts.iter().filter_map(|contact| Side::of_name(&contact.body)).collect();
        let Some(&side) = sides.first() else {
            let text = "no body that carries a contact of the reference has a side in its name (_r or _l): nothing can be mirrored";
            return Err(Fault::refused(text));
        };
        if sides.iter().any(|&other| other != side) {
            return Err(Fault::refused(
                "the reference has contacts on both sides: nothing has to be mirrored",
            ));
        }
        let of_side = self.contacts.iter().filter(|contact| Side::of_name(&contact.body) == Some(side));
        let images = of_side.map(|contact| mirrored_contact(contact, side)).collect::<Result<Vec<_>, _>>()?;
        self.contacts.extend(images);
        Ok(self)
    }

    /// `anatomy` with the missing bodies of this layout: each is the mirror image of the body of the other side.
    pub fn mirrored_anatomy(&self, mut anatomy: Anatomy) -> Anatomy {
        for contact in &self.contacts {
            let other = name_of_other_side(&contact.body).filter(|other| anatomy.has_body(other));
            if let Some(other) = other.filter(|_| !anatomy.has_body(&contact.body)) {
                add_mirrored_body(&mut anatomy, &other, &contact.body);
                // Its names are looked up in an index, which is made with the spheres.
                let spheres = anatomy.spheres.clone();
                anatomy = anatomy.with_spheres(spheres);
            }
        }
        anatomy
    }
}

/// Adds `image`, the mirror image of the body `of` with its meshes and the joints around it.
fn add_mirrored_body(anatomy: &mut Anatomy, of: &str, image: &str) {
    anatomy.bodies.push(image.to_owned());
    if let Some(meshes) = anatomy.meshes.get(of).cloned() {
        anatomy.meshes.insert(image.to_owned(), meshes);
    }
    let swapped = |name: &str| name_of_other_side(name).unwrap_or_else(|| name.to_owned());
    if let Some(offsets) = anatomy.offsets.get(of) {
        let offsets = offsets.iter().map(|(name, &place)| (swapped(name), mirrored_place(place))).collect();
        anatomy.offsets.insert(image.to_owned(), offsets);
    }
    let around = |joint: &&AnatomyJoint| joint.child == of || joint.parent == of;
    let images = anatomy.joints.iter().filter(around).filter_map(|joint| {
        let mut joint = joint.clone();
        joint.name = name_of_other_side(&joint.name)?;
        joint.parent = swapped(&joint.parent);
        joint.child = swapped(&joint.child);
        joint.in_parent_m = mirrored_place(joint.in_parent_m.into()).into();
        joint.in_child_m = mirrored_place(joint.in_child_m.into()).into();
        Some(joint)
    });
    let known: HashSet<String> = anatomy.joints.iter().map(|joint| joint.name.clone()).collect();
    let images: Vec<AnatomyJoint> = images.filter(|joint| !known.contains(&joint.name)).collect();
    anatomy.joints.extend(images);
}

/// The mirror image of a place in z.
fn mirrored_place([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, y, if z == 0.0 { z } else { -z }]
}

/// The mirror image of a contact, on the body of the other side.
fn mirrored_contact(contact: &NewContact, side: Side) -> Result<NewContact> {
    let body = name_of_other_side(&contact.body).ok_or_else(|| {
        Fault::refused(format!(
            "{} says its side otherwise than with _r or _l: what is mirrored is found by these letters",
            contact.body
        ))
    })?;
    let mark = if side == Side::Right { "_l" } else { "_r" };
    let name = |own: &str| name_of_other_side(own).unwrap_or_else(|| format!("{own}{mark}"));
    Ok(NewContact {
        force: name(&contact.force),
        sphere: name(&contact.sphere),
        body,
        location_m: mirrored_place(contact.location_m),
        ..contact.clone()
    })
}

/// The name with `_l` for `_r`, or the other way round, if these letters end a word; `None` if the name has neither.
fn name_of_other_side(name: &str) -> Option<String> {
    let mut letters: Vec<char> = name.chars().collect();
    let mut found = false;
    for at in 1..letters.len() {
        let is_end = letters.get(at + 1).is_none_or(|next| !next.is_alphanumeric());
        let other = match letters.get(at - 1..=at) {
            Some(['_', 'r']) if is_end => 'l',
            Some(['_', 'l']) if is_end => 'r',
            _ => continue,
        };
        if let Some(letter) = letters.get_mut(at) {
            *letter = other;
            found = true;
        }
    }
    found.then(|| letters.into_iter().collect())
}

// A force as pairs of one sphere and one half-space, with the values that such a pair alone would need.

/// A sphere and a half-space of one force.
pub(crate) struct SpherePlanePair {
    pub(crate) sphere: SphereId,
    pub(crate) plane: HalfSpace,
    /// Parameters of both surfaces together, as a force between only these two has them, with the transition velocity.
    pub(crate) values: Vec<(Property, f64)>,
    /// Whether sphere and half-space have different parameters. The values are then composite values (A.3).
    pub(crate) is_composite: bool,
}

/// The sphere and half-space pairs of `force`, in the order of the force; a sphere never touches a half-space on its own body.
///
/// # Errors
/// - A value that is not a plain number or outside its domain, with its place.
/// - A pair that the force presses several times: by name.
pub(crate) fn sphere_plane_pairs(model: &Model, force: &Force) -> Result<Vec<SpherePlanePair>> {
    refuse_repeated_pair(model, force)?;
    let surfaces = Surfaces::of(force)?;
    let planes: Vec<(&ParameterSet, HalfSpace)> = force
        .sets
        .iter()
        .flat_map(|set| model.planes_of_set(set).into_iter().map(move |plane| (set, plane)))
        .collect();
    let mut pairs = Vec::new();
    for set in &force.sets {
        for &sphere in &set.spheres {
            let Some(own) = model.sphere(sphere).filter(|sphere| !sphere.fixed) else { continue };
            for (plane_set, plane) in &planes {
                if !can_meet(own, plane) {
                    continue;
                }
                let of = |id| values_of_set(force, id);
                let (here, there) = (of(set.id)?, of(plane_set.id)?);
                let is_composite = here != there;
                let values = if is_composite {
                    composite_values(surfaces.mixed(set.id, plane_set.id)?, &here, &there)
                } else {
                    here
                };
                pairs.push(SpherePlanePair { sphere, plane: plane.clone(), values, is_composite });
            }
        }
    }
    Ok(pairs)
}

/// Whether a sphere and a half-space are on different bodies.
fn can_meet(sphere: &Sphere, plane: &HalfSpace) -> bool {
    plane.body.is_none() || plane.body != sphere.body
}

/// Refuses a force that names a sphere or a half-space several times: OpenSim presses each sphere on each half-space every time, which
/// forces of one sphere do not do. Nothing here grows with the number of pairs.
fn refuse_repeated_pair(model: &Model, force: &Force) -> Result<()> {
    let mut times_of_sphere: HashMap<SphereId, usize> = HashMap::new();
    for &sphere in force.sets.iter().flat_map(|set| &set.spheres) {
        *times_of_sphere.entry(sphere).or_default() += 1;
    }
    let mut planes: IndexMap<String, (HalfSpace, usize)> = IndexMap::new();
    for plane in force.sets.iter().flat_map(|set| model.planes_of_set(set)) {
        planes.entry(plane.path.clone()).or_insert((plane, 0)).1 += 1;
    }
    let mut planes: Vec<(HalfSpace, usize)> = planes.into_values().collect();
    planes.sort_by_key(|(_, times)| std::cmp::Reverse(*times));
    let most = planes.first().map_or(0, |(_, times)| *times);
    for sphere in force.spheres().iter().filter_map(|&id| model.sphere(id)) {
        let times = times_of_sphere.get(&sphere.id).copied().unwrap_or_default();
        if sphere.fixed || times * most <= 1 {
            continue;
        }
        let Some((plane, of_plane)) = planes.iter().find(|(plane, _)| can_meet(sphere, plane)) else {
            continue;
        };
        if times * of_plane > 1 {
            let text = format!(
                "{} names {} {} and {} {}, so that OpenSim presses this pair {} times, which forces of one sphere do not",
                force.path,
                sphere.name,
                counted(times, "time"),
                plane.name,
                counted(of_plane, "time"),
                times * of_plane
            );
            let otherwise = "name each of its surfaces once in OpenSim";
            let kind = FaultKind::ForceCannotChange { text, force: force.name.clone(), otherwise };
            return Err(Fault::new(kind).at_element(force.path.clone()));
        }
    }
    Ok(())
}

fn values_of_set(force: &Force, set: SetId) -> Result<Vec<(Property, f64)>> {
    let value = |property| Some(force.checked(set, property).transpose()?.map(|value| (property, value)));
    Property::changeable().filter_map(value).collect()
}

/// Modulus and α of two surfaces by (A.3) and (A.4); for each coefficient of friction the value that Simbody uses, 2ab/(a + b).
fn composite_values(
    together: SurfaceValues,
    here: &[(Property, f64)],
    there: &[(Property, f64)],
) -> Vec<(Property, f64)> {
    let both = here.iter().filter_map(|&(property, a)| {
        let (_, b) = there.iter().find(|(known, _)| *known == property)?;
        let value = match property {
            Property::Stiffness => together.plane_strain_modulus,
            Property::Dissipation => together.dissipation,
            Property::StaticFriction | Property::DynamicFriction | Property::ViscousFriction if a != *b => {
                2.0 * a * b / (a + b)
            }
            _ => a,
        };
        Some((property, value))
    });
    both.collect()
}

// Presets whose places are published, too: each is a small model of our own that says so.

/// Names of presets, each with the text of its model.
const PRESET_MODELS: [(&str, &str); 3] = [
    ("falisse2022", include_str!("presets/falisse2022.osim")),
    ("dhondt2024", include_str!("presets/dhondt2024.osim")),
    ("moco-2d-gait", include_str!("presets/moco-2d-gait.osim")),
];

/// The text of a model with the contacts of the preset `name`, if the locations of its spheres are known.
///
/// ```
/// use osim_model::Model;
///
/// let text = osim_patch::preset_model("falisse2022").expect("its places are published");
/// let model = Model::parse(text)?;
/// assert_eq!((model.spheres().len(), model.spheres()[0].radius_m()?), (12, 0.032));
/// # Ok::<(), osim_model::Fault>(())
/// ```
pub fn preset_model(name: &str) -> Option<&'static str> {
    PRESET_MODELS.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
}

/// Names of the presets whose sphere locations are known.
pub fn presets_with_places() -> impl Iterator<Item = &'static str> {
    PRESET_MODELS.iter().map(|(name, _)| *name)
}

#[cfg(test)]
mod tests {
    use osim_model::ForceKind;

    use super::*;

    fn new_contact(force: &str, sphere: &str, body: &str) -> NewContact {
        let mut contact = NewContact::new(ForceKind::HuntCrossley, force, sphere);
        contact.body = body.to_owned();
        contact.location_m = [0.1, -0.2, 0.03];
        contact
    }

    fn layout_of_contacts(contacts: Vec<NewContact>) -> ContactLayout {
        ContactLayout { contacts, ..ContactLayout::default() }
    }

    #[test]
    fn the_image_is_on_the_other_side() {
        let both = layout_of_contacts(vec![
            new_contact("f_heel_r", "heel", "calcn_r"),
            new_contact("f", "s", "pelvis"),
        ])
        .mirrored()
        .unwrap();
        assert_eq!(both.contacts.len(), 3);
        let image = &both.contacts[2];
        assert_eq!(
            (image.force.as_str(), image.sphere.as_str(), image.body.as_str()),
            ("f_heel_l", "heel_l", "calcn_l")
        );
        assert_eq!(image.location_m, [0.1, -0.2, -0.03]);
    }

    #[test]
    fn both_sides_or_none_are_refused() {
        for contacts in [
            vec![new_contact("f", "s", "pelvis")],
            vec![new_contact("f", "s", "a_r"), new_contact("g", "t", "a_l")],
        ] {
            assert!(layout_of_contacts(contacts).mirrored().is_err());
        }
        let camel = layout_of_contacts(vec![new_contact("f", "s", "RFoot")]).mirrored().unwrap_err();
        assert!(camel.to_string().contains("otherwise than with _r or _l"), "{camel}");
    }

    #[test]
    fn sides_are_words_of_a_name() {
        assert_eq!(name_of_other_side("s1_r_a").as_deref(), Some("s1_l_a"));
        assert_eq!(name_of_other_side("calcn_l").as_deref(), Some("calcn_r"));
        assert_eq!(
            name_of_other_side("/jointset/mtp_r/calcn_r_offset").as_deref(),
            Some("/jointset/mtp_l/calcn_l_offset")
        );
        assert_eq!(name_of_other_side("mtp_r parent").as_deref(), Some("mtp_l parent"));
        assert_eq!(name_of_other_side("rotor_left"), None);
        assert_eq!(name_of_other_side("l"), None);
    }
}
