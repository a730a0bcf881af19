//! How joint trees stand on their floors at the default pose: heights of spheres, the coordinate that lowers the spheres to the floor, and
//! the depths at which they carry the weight.

mod heights_over_floor;
mod level;
mod lift;

use std::collections::BTreeSet;

use contact_scaling::DomainError;
use foldhash::{HashMap, HashMapExt, HashSet};
use glam::DVec3;
use indexmap::IndexMap;

use super::contact_planes::{ContactPlane, PlaneSurface};
use super::default_pose::DefaultPose;
use super::fault::PoseFault;
use crate::model::angle_between;
use crate::model::{ForceId, Model, SphereId, loaded_spheres};
use heights_over_floor::{FloorContact, SphereFloors};
pub use heights_over_floor::{RestLaw, RestOnFloor, RestingSphere, SphereOverFloor};
pub use level::{LevelledSphere, MOST_LEAN_RAD, NotLevelled, levelled_spheres};
use lift::{JointTree, LiftingCoordinateSearch};
pub use lift::{LiftingCoordinate, NotLifted, held_roots};

/// Floors have one direction if the angle between their normals is at most this, rad.
const SAME_DIRECTION_RAD: f64 = 1e-6;

/// A joint tree above or on its floor, with its joints at the default pose.
#[derive(Debug, Clone, PartialEq)]
pub struct Standing {
    /// The topmost body of the tree, which is joined to ground.
    pub top: String,
    /// Spheres of the tree that press on floors, in file order.
    pub spheres: Vec<SphereOverFloor>,
    /// The coordinate that lifts all these spheres from the floor; the error says why there is none.
    pub lift: Result<LiftingCoordinate, NotLifted>,
    /// Mass of the bodies that the lifting coordinate moves, kg: bodies above its joint do not count. `None` if a mass cannot be read.
    pub mass_kg: Option<f64>,
    /// The part of the weight of these bodies along the floor's normal, N; `None` without mass or gravity.
    pub load_n: Option<f64>,
    floor_contacts: Vec<FloorContact>,
}

impl Standing {
    /// The joint trees of `model` with moving spheres of `forces` that press on a floor, in the order of the first sphere of each tree.
    pub fn all(model: &Model, forces: &[ForceId]) -> Result<Vec<Self>, PoseFault> {
        let joints = model.joints();
        let pose = DefaultPose::of(model);
        let floors = SphereFloors::of(model, forces, &pose);
        let tree = JointTree::of(joints);
        let lifting = LiftingCoordinateSearch::of(model, &pose);
        let bodies = model.bodies().iter().enumerate();
        let masses = bodies.map(|(place, body)| (body.name.as_str(), (place, body.mass_kg().ok()))).collect();
        let mut standings = Vec::new();
        for (top, spheres) in spheres_by_tree(model, &floors, &tree, &pose)? {
            let tree = StandingTree { model, floors: &floors, tree: &tree, masses: &masses, top };
            standings.push(tree.standing_on(&spheres, &pose, &lifting)?);
        }
        add_floor_contacts(model, forces, &floors, &pose, &mut standings)?;
        Ok(standings)
    }

    /// The equilibrium of the tree on the `chosen` spheres alone, which carry `share` of its weight by the contact laws of the file. `None`
    /// if the weight or a contact is not known, or no sphere is chosen.
    ///
    /// # Errors
    /// No depth of the spheres carries the load.
    pub fn rest_on_floor(&self, chosen: &[SphereId], share: f64) -> Option<Result<RestOnFloor, DomainError>> {
        self.rest_under(chosen, share * self.load_n?, RestLaw::OfFile)
    }

    /// The equilibrium of the `chosen` spheres under the load `load_n` along the normal.
    pub fn rest_under(
        &self,
        chosen: &[SphereId],
        load_n: f64,
        law: RestLaw,
    ) -> Option<Result<RestOnFloor, DomainError>> {
        let chosen: BTreeSet<SphereId> = chosen.iter().copied().collect();
        let mut floor_contacts: Vec<&FloorContact> = Vec::with_capacity(self.floor_contacts.len());
        for sphere in chosen {
            let start = self.floor_contacts.partition_point(|one| one.contact.sphere < sphere);
            let own = self.floor_contacts.iter().skip(start);
            floor_contacts.extend(own.take_while(|one| one.contact.sphere == sphere));
            floor_contacts.last().filter(|one| one.contact.sphere == sphere)?;
        }
        (!floor_contacts.is_empty()).then(|| RestOnFloor::of(&floor_contacts, load_n, law))
    }

    /// The value of the lifting coordinate at which the tree is `down_m` lower than at the default pose; `None` without such a coordinate.
    pub fn coordinate_at(&self, down_m: f64) -> Option<f64> {
        let lift = self.lift.as_ref().ok()?;
        Some(lift.default_m - down_m / lift.rise)
    }

    pub fn lowest(&self) -> Option<&SphereOverFloor> {
        self.spheres.iter().min_by(|a, b| a.gap_m.total_cmp(&b.gap_m))
    }
}

/// Groups the spheres on floors by the topmost body of their joint tree, in the order of the first sphere of each tree.
fn spheres_by_tree<'j>(
    model: &Model,
    floors: &SphereFloors,
    tree: &JointTree<'j>,
    pose: &DefaultPose,
) -> Result<IndexMap<&'j str, Vec<SphereId>>, PoseFault> {
    let mut tops: HashMap<&str, Option<&str>> = HashMap::new();
    let mut groups: IndexMap<&str, Vec<SphereId>> = IndexMap::new();
    for id in floors.spheres() {
        let Some(body) = model.sphere(id).and_then(|sphere| sphere.body.as_deref()) else { continue };
        pose.placement(body)?;
        let Some(top) = *tops.entry(body).or_insert_with(|| tree.top(body)) else { continue };
        groups.entry(top).or_default().push(id);
    }
    Ok(groups)
}

/// One joint tree and the data that describe how it stands.
struct StandingTree<'t, 'j> {
    model: &'t Model,
    floors: &'t SphereFloors,
    tree: &'t JointTree<'j>,
    /// Index in the file and mass (kg) of each body.
    masses: &'t HashMap<&'t str, (usize, Option<f64>)>,
    top: &'j str,
}

impl<'j> StandingTree<'_, 'j> {
    fn standing_on(
        &self,
        spheres: &[SphereId],
        pose: &DefaultPose,
        lifting: &LiftingCoordinateSearch<'_>,
    ) -> Result<Standing, PoseFault> {
        let planes = self.floors.floors_under(spheres);
        let normal = planes.first().map(|(_, surface)| surface.normal);
        let before_lying = normal.and_then(|normal| pose.before_lying(self.model, normal));
        let mut over = Vec::new();
        for &sphere in spheres {
            let gaps = self.floors.heights_over_floors(self.model, sphere, pose)?;
            let least = gaps.iter().map(|(_, gap)| *gap).reduce(f64::min);
            let body = self.model.sphere(sphere).and_then(|sphere| sphere.body.as_deref());
            let tilt_rad = match (body, normal) {
                (Some(body), Some(normal)) => heights_over_floor::tilt((pose, before_lying), body, normal)?,
                _ => 0.0,
            };
            let centre = heights_over_floor::centre_and_radius(self.model, sphere, pose)?;
            let at_zero = DefaultPose::at_zero(self.model);
            let at_zero = heights_over_floor::centre_and_radius(self.model, sphere, at_zero).ok().flatten();
            let height = |((centre, radius), axis): ((DVec3, f64), DVec3)| centre.dot(axis) - radius;
            let height_at_zero_m = at_zero.zip(normal.map(heights_over_floor::nearest_axis)).map(height);
            let over_floor = |(gap_m, (centre_m, _))| SphereOverFloor {
                sphere,
                gap_m,
                tilt_rad,
                centre_m,
                height_at_zero_m,
            };
            over.extend(least.zip(centre).map(over_floor));
        }
        let (lift, mass_kg) = self.lift(spheres, &planes, lifting);
        let gravity = self.model.gravity().filter(|gravity| *gravity > 0.0 && gravity.is_finite());
        let along = normal.map(|normal| normal.dot(self.model.up()));
        let load_n = mass_kg.zip(gravity).zip(along).map(|((mass, gravity), along)| mass * gravity * along);
        let top = self.top.to_owned();
        Ok(Standing { top, spheres: over, lift, mass_kg, load_n, floor_contacts: Vec::new() })
    }

    /// The coordinate that lifts `spheres` from `planes`, and the mass of the bodies that it moves.
    fn lift(
        &self,
        spheres: &[SphereId],
        planes: &[&(ContactPlane, PlaneSurface)],
        lifting: &LiftingCoordinateSearch<'_>,
    ) -> (Result<LiftingCoordinate, NotLifted>, Option<f64>) {
        let bodies: Vec<&str> =
            spheres.iter().filter_map(|&id| self.model.sphere(id)?.body.as_deref()).collect();
        let mut path = self.tree.common_path_to_ground(&bodies);
        // What moves the floor along moves nothing against it.
        for plane in planes.iter().filter_map(|(plane, _)| plane.body.as_deref()) {
            let of_plane: HashSet<&str> =
                self.tree.path_to_ground(plane).iter().map(|other| other.body).collect();
            path.retain(|parent_joint| !of_plane.contains(parent_joint.body));
        }
        let normals: Vec<DVec3> = planes.iter().map(|(_, surface)| surface.normal).collect();
        let lift = match normals.first() {
            Some(&first)
                if normals.iter().all(|&other| angle_between(first, other) <= SAME_DIRECTION_RAD) =>
            {
                lifting.find(&path, first)
            }
            _ => Err(NotLifted::SeveralFloors),
        };
        let place = lift.as_ref().map_or(path.len().saturating_sub(1), |(place, _)| *place);
        let mass_kg = path.get(place).and_then(|parent_joint| self.mass_below(parent_joint.body));
        (lift.map(|(_, lift)| lift), mass_kg)
    }

    /// The mass of `body` and all bodies below it, kg.
    fn mass_below(&self, body: &'j str) -> Option<f64> {
        let below = self.tree.with_all_below(body);
        let mut masses: Vec<(usize, Option<f64>)> =
            below.into_iter().filter_map(|body| self.masses.get(body)).copied().collect();
        // A sum is the same in every run only in one order.
        masses.sort_unstable_by_key(|(place, _)| *place);
        masses.into_iter().map(|(_, mass)| mass).sum()
    }
}

fn paths_of_planes(model: &Model, force: ForceId) -> HashSet<String> {
    let planes = model.force(force).map(|force| model.planes_of(force)).unwrap_or_default();
    planes.into_iter().map(|plane| plane.path.clone()).collect()
}

/// Adds to each joint tree the contacts of its spheres, in their order. Adds none if a number of a contact cannot be read.
fn add_floor_contacts(
    model: &Model,
    forces: &[ForceId],
    floors: &SphereFloors,
    pose: &DefaultPose,
    standing: &mut [Standing],
) -> Result<(), PoseFault> {
    let Ok(mut loaded) = loaded_spheres(model, forces) else { return Ok(()) };
    loaded.sort_by_key(|one| one.sphere);
    let places = standing.iter().enumerate();
    let places: HashMap<SphereId, usize> =
        places.flat_map(|(place, one)| one.spheres.iter().map(move |over| (over.sphere, place))).collect();
    let mut planes: HashMap<ForceId, HashSet<String>> = HashMap::new();
    for one in &loaded {
        let Some(own) = places.get(&one.sphere).and_then(|&place| standing.get_mut(place)) else { continue };
        let gaps = floors.heights_over_floors(model, one.sphere, pose)?;
        let planes = planes.entry(one.force).or_insert_with(|| paths_of_planes(model, one.force));
        let gaps = gaps.iter().filter(|(plane, _)| planes.contains(&plane.path));
        own.floor_contacts
            .extend(gaps.map(|(_, gap_m)| FloorContact { contact: one.clone(), gap_m: *gap_m }));
    }
    Ok(())
}
