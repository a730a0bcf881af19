//! The feet of a model, as figures show them.

use std::collections::HashSet;
use std::path::Path;

use osim_inspect::misplaced_spheres;
use osim_model::feet::{AttachedBones, DefaultPose, FeetFault, Foot, FootBodies, MeshFolders};
use osim_model::files::{Failure, Files, OpenModel};
use osim_model::{Anatomy, Fault, Finding, ForceId, Model, Selection, SphereId};

/// Spheres and bodies that a model may have at most for its feet to be on a page.
const MOST_SPHERES: usize = 200;
const MOST_BODIES: usize = 1000;

/// The feet of one state of a model.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct ModelFeet {
    /// The name that figures show.
    pub name: String,
    /// Its feet.
    pub feet: Vec<Foot>,
    /// What says that spheres are where they should not be.
    pub misplaced: Option<Finding>,
    /// Bones that could not be read, each with what is wrong.
    pub missing: Vec<FeetFault>,
    anatomy: Anatomy,
    pose: DefaultPose,
    bodies: Vec<FootBodies>,
}

impl ModelFeet {
    /// The feet of a model without their bones: with all moving spheres where `selection` chooses nothing, else with those of the
    /// chosen forces.
    ///
    /// # Errors
    /// A number that cannot be read, no force that is chosen, or no feet.
    pub fn of(name: &str, opened: &OpenModel, selection: &Selection) -> Result<Self, Failure> {
        let found = Self::find(name, &opened.model, selection).map_err(|fault| opened.failure(fault))?;
        if found.feet.is_empty() {
            let why = "there are no feet to draw: the model has no contact sphere that moves, and no body near the ground has \
                       a side in its name, such as calcn_r";
            return Err(opened.failure(Fault::refused(why)));
        }
        Ok(found)
    }

    /// The same for a page: `None` without feet, or with more spheres or bodies than a page should show.
    #[must_use]
    pub fn for_page(name: &str, opened: &OpenModel, selection: &Selection) -> Option<Self> {
        let model = &opened.model;
        let few = model.spheres().len() <= MOST_SPHERES && model.bodies().len() <= MOST_BODIES;
        few.then(|| Self::of(name, opened, selection).ok()).flatten()
    }

    fn find(name: &str, model: &Model, selection: &Selection) -> Result<Self, Fault> {
        let anatomy = Anatomy::of(model)?;
        let pose = DefaultPose::of(model);
        let (spheres, forces) = chosen(model, selection)?;
        let bodies = FootBodies::find(model, &anatomy, &spheres, &forces, &pose);
        let mut feet = Foot::all(model, &anatomy, &bodies, &pose);
        let misplaced = misplaced_spheres(model);
        mark(&mut feet, misplaced.as_ref());
        Ok(Self { name: name.to_owned(), feet, misplaced, missing: Vec::new(), anatomy, pose, bodies })
    }

    /// Adds the bones whose meshes are there: in the folder of the model, in its `Geometry`, or in `geometry_dir`.
    pub fn add_bones(&mut self, model: &Model, path: &Path, geometry_dir: Option<&Path>, files: &dyn Files) {
        let mut folders = MeshFolders::of_model(path);
        if let Some(folder) = geometry_dir {
            folders = folders.and(folder);
        }
        let attached = AttachedBones::of(model);
        for (foot, bodies) in self.feet.iter_mut().zip(&self.bodies) {
            let mut found = Vec::new();
            for body in foot.bodies_with_bones(&self.anatomy, bodies) {
                match attached.bones(&body, &folders, files) {
                    Ok(bones) => found.extend(bones),
                    Err(FeetFault::NoMesh { .. }) => {}
                    Err(fault) => self.missing.push(fault),
                }
            }
            foot.add_bones(&self.anatomy, bodies, &found, &self.pose);
        }
    }

    /// The same feet with spheres of other radii: all multiplied by `ratio`, the centres where they are.
    #[must_use]
    pub fn with_radii(&self, name: String, ratio: f64) -> Self {
        let mut scaled = Self { name, ..self.clone() };
        for sphere in scaled.feet.iter_mut().flat_map(|foot| &mut foot.spheres) {
            sphere.radius_m *= ratio;
        }
        scaled
    }

    /// Whether there are spheres at all.
    #[must_use]
    pub fn has_spheres(&self) -> bool {
        self.feet.iter().any(|foot| !foot.spheres.is_empty())
    }

    /// Whether both have the same spheres in the same places.
    #[must_use]
    pub fn has_same_spheres(&self, other: &Self) -> bool {
        let spheres = |feet: &Self| -> Vec<_> { feet.feet.iter().map(|foot| foot.spheres.clone()).collect() };
        spheres(self) == spheres(other)
    }
}

/// The spheres to draw, and the forces by which limbs are found.
fn chosen(model: &Model, selection: &Selection) -> Result<(Vec<SphereId>, Vec<ForceId>), Fault> {
    let moving = |id: &SphereId| model.sphere(*id).is_some_and(|sphere| !sphere.fixed);
    if *selection == Selection::default() {
        let spheres = model.spheres().iter().map(|sphere| sphere.id).filter(moving).collect();
        return Ok((spheres, model.force_ids()));
    }
    let forces = selection.apply(model)?.forces;
    let held = forces.iter().filter_map(|&id| model.force(id)).flat_map(osim_model::Force::spheres);
    let mut spheres: Vec<SphereId> = held.filter(moving).collect();
    spheres.sort_unstable();
    spheres.dedup();
    Ok((spheres, forces))
}

fn mark(feet: &mut [Foot], finding: Option<&Finding>) {
    let Some(finding) = finding else { return };
    let misplaced: HashSet<&String> = finding.spheres.iter().collect();
    for sphere in feet.iter_mut().flat_map(|foot| &mut foot.spheres) {
        sphere.misplaced = misplaced.is_empty() || misplaced.contains(&sphere.name);
    }
}
