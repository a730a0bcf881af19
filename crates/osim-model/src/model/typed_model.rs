//! The type [`Model`]: bodies, limbs, contact spheres and contact forces with their effective values.

use std::any::Any;
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

use crate::model::anatomy::bone_sizes::{BoneLengths, TriplesByBody, frame_offsets, mesh_factors};
use crate::model::anatomy::joints::{AnatomyJoint, Joints};
use crate::model::{
    Body, Companion, ComponentId, Components, Document, Fault, FileId, Finding, Force, ForceId, HalfSpace,
    Irregularity, Note, NoteDoubt, Property, Result, SetId, Skeleton, Sphere, SphereId,
};
use crate::xml::TextPosition;

/// A model with its bodies, contact spheres and contact forces.
///
/// ```
/// # let bytes: &[u8] = include_bytes!("../../tests/data/one_foot.osim");
/// let model = osim_model::Model::parse(bytes)?;
/// let sphere = &model.spheres()[0];
/// assert_eq!((sphere.name.as_str(), sphere.radius_m()?), ("heel_r", 0.03));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone)]
pub struct Model {
    /// The components, shared with copies of this model that have other numbers of contacts.
    pub(crate) components: Arc<Components>,
    pub(crate) skeleton: Arc<Skeleton>,
    pub(crate) body_facts: Arc<BodyFacts>,
    pub(crate) half_spaces: OnceLock<BTreeMap<ComponentId, Arc<HalfSpace>>>,
    pub(crate) spheres: Vec<Sphere>,
    pub(crate) forces: Vec<Force>,
    /// Why the note is in doubt: a comment begins like a note and cannot be read, or the notes of two sets differ.
    pub(crate) note_fault: Option<NoteDoubt>,
    /// For each companion file, the text of the `file="…"` that includes it; `None` if the caller gave the file.
    pub(crate) included: Vec<Option<String>>,
    pub name: String,
    /// Gravity vector, m/s²; `None` if its text is not three numbers.
    pub gravity_m_s2: Option<[f64; 3]>,
    /// The note that an earlier change wrote into the file.
    pub note: Option<Note>,
    /// Elements that were read although they are written wrongly, in the order of reading.
    pub irregularities: Vec<Irregularity>,
    /// The reason not to trust the note. It is found once, because digests take time.
    pub(crate) doubt_about_note: OnceLock<Option<NoteDoubt>>,
    /// The findings of all rules about one model. Computed once.
    pub(crate) findings: OnceLock<Vec<Finding>>,
}

impl Model {
    /// Gravity that OpenSim uses if a model gives none, m/s².
    pub(crate) const DEFAULT_GRAVITY: [f64; 3] = [0.0, -9.80665, 0.0];

    /// Place of `gravity` in its file; `None` if the file has no gravity and OpenSim's default is used, or if it has only sets.
    pub fn gravity_position(&self) -> Option<TextPosition> {
        let document = self.file(self.components.model_file()?);
        let gravity = document.property_element(document.data_root(), "gravity")?;
        Some(document.position_of(gravity))
    }

    /// Magnitude of gravity, m/s²; `None` if it is not a number. Without gravity, or with 0, forces cannot be given in body weights.
    pub fn gravity(&self) -> Option<f64> {
        self.gravity_m_s2.map(|[x, y, z]| (x * x + y * y + z * z).sqrt()).filter(|size| size.is_finite())
    }

    /// Gravity for which the contacts were made, m/s²: from the note, else that of the model.
    pub fn contacts_gravity(&self) -> Option<f64> {
        self.note.as_ref().and_then(|note| note.gravity_m_s2).or(self.gravity())
    }

    /// The contact spheres, in file order.
    pub fn spheres(&self) -> &[Sphere] {
        &self.spheres
    }

    /// The contact forces, in file order.
    pub fn forces(&self) -> &[Force] {
        &self.forces
    }

    /// The contact sphere `id`; `None` if the handle belongs to another model.
    pub fn sphere(&self, id: SphereId) -> Option<&Sphere> {
        self.spheres.get(id.index())
    }

    /// The contact force `id`; `None` if the handle belongs to another model.
    pub fn force(&self, id: ForceId) -> Option<&Force> {
        self.forces.get(id.index())
    }

    /// The effective value of a force's property, if it can be scaled; `None` if the class has no such property.
    pub fn parameter(&self, force: ForceId, set: SetId, property: Property) -> Result<Option<f64>> {
        self.force(force).map_or(Ok(None), |force| force.checked(set, property))
    }

    /// The effective radius of a sphere, m, if it can be scaled.
    pub fn radius_m(&self, sphere: SphereId) -> Result<f64> {
        self.required_sphere(sphere)?.radius_m()
    }

    pub fn round_radius_m(&self, sphere: SphereId) -> Result<f64> {
        self.required_sphere(sphere)?.round_radius_m()
    }

    fn required_sphere(&self, id: SphereId) -> Result<&Sphere> {
        let unknown = || Fault::refused(format!("there is no sphere number {}", id.index()));
        self.sphere(id).ok_or_else(unknown)
    }

    /// The findings of all rules about one model. `find` computes them at the first call.
    pub fn findings(&self, find: impl FnOnce(&Self) -> Vec<Finding>) -> &[Finding] {
        self.findings.get_or_init(|| find(self))
    }

    /// The distances between the joints of each body, a measure of the size of bones.
    pub fn joint_distances(&self) -> &BoneLengths {
        self.derived_from_bodies(|model| BoneLengths::from_joints(model.joints_between_bodies()))
    }

    /// The joints between two bodies, with their places.
    pub fn joints_between_bodies(&self) -> &[AnatomyJoint] {
        self.body_facts.joints.between_bodies(&self.components)
    }

    /// The scale factors of the meshes of each body, by mesh file.
    pub fn mesh_factors(&self) -> &TriplesByBody {
        self.body_facts.mesh_factors(&self.components)
    }

    /// The value that `make` computes from this model. It is computed once for each type, and shared with models that differ only in
    /// numbers of contacts. It must therefore depend only on bodies, joints and constraints, and on names and on texts other than numbers
    /// of contacts.
    pub fn derived_from_bodies<T: Any + Send + Sync>(&self, make: impl FnOnce(&Self) -> T) -> &T {
        self.body_facts.derived.get_or_make(|| make(self))
    }

    /// Handles of all contact forces, in file order.
    pub fn force_ids(&self) -> Vec<ForceId> {
        self.forces.iter().map(|force| force.id).collect()
    }

    /// The name under which the model includes `file`; `None` if it does not include it.
    pub fn included_file(&self, file: FileId) -> Option<&str> {
        self.included.get(file.companion_index()?)?.as_deref()
    }

    pub fn document(&self) -> &Document {
        self.components.main()
    }

    /// The document of a file of this model. A handle of another model gives the main document.
    pub fn file(&self, file: FileId) -> &Document {
        self.components.document(file)
    }

    /// The files beside the main file, with their handles.
    pub fn companions(&self) -> impl Iterator<Item = (FileId, &Companion)> {
        let companions = self.components.companions().iter().enumerate();
        companions.map(|(index, companion)| (FileId::companion(index), companion))
    }

    /// Bodies in file order, without ground.
    pub fn bodies(&self) -> &[Body] {
        &self.skeleton.bodies
    }

    pub fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// The components in all files of the model.
    pub fn components(&self) -> &Components {
        &self.components
    }
}

// Facts about bodies and joints, which do not depend on the numbers of contacts.

/// Facts about the bodies of a model, each computed once, at its first use.
#[derive(Debug, Default)]
pub(crate) struct BodyFacts {
    pub(crate) joints: Joints,
    mesh_factors: OnceLock<TriplesByBody>,
    frame_offsets: OnceLock<TriplesByBody>,
    /// Values that other modules computed from bodies and joints.
    derived: DerivedValues,
}

impl BodyFacts {
    pub(crate) fn mesh_factors(&self, components: &Components) -> &TriplesByBody {
        self.mesh_factors.get_or_init(|| mesh_factors(components))
    }

    pub(crate) fn frame_offsets(&self, components: &Components) -> &TriplesByBody {
        self.frame_offsets.get_or_init(|| frame_offsets(components))
    }
}

/// A linked list of values of different types. Values are never removed, so references to them stay valid as long as the list.
#[derive(Debug, Default)]
struct DerivedValues(OnceLock<Box<DerivedValue>>);

/// A value that was computed from a model, and the list of further values.
#[derive(Debug)]
struct DerivedValue {
    value: Box<dyn Any + Send + Sync>,
    next: DerivedValues,
}

impl DerivedValues {
    /// The value of type `T`, computed by `make` if there is none yet. If two threads compute one, the first is kept.
    fn get_or_make<T: Any + Send + Sync>(&self, make: impl FnOnce() -> T) -> &T {
        if let Some(value) = self.get() {
            return value;
        }
        // `make` may ask for other values meanwhile.
        let mut new = Some(Box::new(DerivedValue { value: Box::new(make()), next: Self::default() }));
        let mut at = self;
        loop {
            new = new.and_then(|link| at.0.set(link).err());
            if let Some(value) = self.get() {
                return value;
            }
            if let Some(link) = at.0.get() {
                at = &link.next;
            }
        }
    }

    /// The value of type `T`, if it was computed already.
    fn get<T: Any>(&self) -> Option<&T> {
        let links = std::iter::successors(self.0.get(), |link| link.next.0.get());
        links.into_iter().find_map(|link| link.value.downcast_ref())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_derived_value_is_made_once() {
        let derived = DerivedValues::default();
        let number = derived.get_or_make(|| {
            assert_eq!(derived.get_or_make(|| "made meanwhile"), &"made meanwhile");
            1_i32
        });
        assert_eq!((number, derived.get_or_make(|| 2_i32)), (&1, &1));
        assert_eq!(
            (derived.get_or_make(|| "another"), derived.get_or_make(|| 3_u8)),
            (&"made meanwhile", &3)
        );
    }
}
