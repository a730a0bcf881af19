//! Data for a three-dimensional view of a model: bodies, spheres, floors and forces; bones; frames of a recording; falls.

use std::collections::{HashMap, HashSet};
use std::path::Path;

use contact_scaling::drop_test::{DropError, DropReport, DropTest, Sample};
use contact_scaling::table1::{Animal, animals};
use contact_scaling::{Contact, falisse2022};
use osim_inspect::InspectOptions;
use osim_inspect::series::{self, ContactBody};
use osim_model::feet::{
    ContactPlane, DefaultPose, FeetFault, MeshFolders, Standing, ViewAxes, attached_surface,
};
use osim_model::files::{Failure, Files};
use osim_model::messages::Dialect;
use osim_model::{Anatomy, DVec3, ForceId, MassRequest, Model, Placement, Side, SphereId};
use osim_motion::{FootSummary, Poses, TOUCH_DOWN_BW, Wrench};
use osim_requests::{DropHeight, MotionRequest};
use serde::Serialize;

use crate::motion::MotionResult;

/// A model at its default pose, in ground, m.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Scene {
    /// The directions forward, up (against gravity) and to the right of the scene, each of length 1.
    pub axes: [[f64; 3]; 3],
    pub bodies: Vec<PlacedBody>,
    /// Contact spheres that move and whose bodies have a place, in file order.
    pub spheres: Vec<SceneSphere>,
    /// Planes that spheres press on.
    pub planes: Vec<PlacedPlane>,
    /// Lines from joint to joint, which are drawn for bodies without bones.
    pub lines: Vec<BodyLine>,
    pub why_not_placed: Option<String>,
}

/// A body at its place in ground.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlacedBody {
    pub name: String,
    /// Axes x, y and z of the body, and its origin, in ground.
    pub frame: [[f64; 3]; 4],
}

/// A contact sphere at its place in ground.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneSphere {
    pub name: String,
    /// Component path of the sphere.
    pub path: String,
    /// The body that carries the sphere.
    pub body: String,
    /// Side of the sphere, `right` or `left`.
    pub side: Option<&'static str>,
    pub centre_m: [f64; 3],
    pub radius_m: f64,
    /// Force of the sphere, in body weights, if the body stands on all its spheres.
    pub force_bw: Option<f64>,
    /// Indentation of the sphere, in radii, if the body stands on all its spheres.
    pub relative_indentation: Option<f64>,
}

/// The surface of a floor or wall in ground.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PlacedPlane {
    pub point_m: [f64; 3],
    /// Outward normal of the plane.
    pub normal: [f64; 3],
}

impl Scene {
    /// The scene of `model`, whose contacts carry the weight that `options` give.
    pub fn of(model: &Model, options: &InspectOptions) -> Self {
        let pose = DefaultPose::of(model);
        let forces = options.selection.apply(model).map(|selected| selected.forces);
        let forces = forces.unwrap_or_else(|_| model.force_ids());
        let axes = ViewAxes::of(model);
        let planes = ContactPlane::all(model, &forces, &pose);
        let surfaces = planes.iter().filter_map(|plane| plane.surface);
        let placed = |name: &str| pose.placement(name).ok().map(axes_and_origin);
        let bodies = model
            .bodies()
            .iter()
            .filter_map(|body| Some(PlacedBody { name: body.name.clone(), frame: placed(&body.name)? }));
        let mut faults = model.bodies().iter().filter_map(|body| pose.placement(&body.name).err());
        Self {
            axes: [axes.forward, axes.up, axes.right].map(DVec3::into),
            bodies: bodies.collect(),
            spheres: placed_spheres(model, &forces, &pose, &loads_at_rest(model, &forces, options)),
            planes: surfaces
                .map(|one| PlacedPlane { point_m: one.point_m.into(), normal: one.normal.into() })
                .collect(),
            lines: body_lines(model),
            why_not_placed: faults.next().map(|fault| fault.to_string()),
        }
    }
}

/// Axes x, y, z and origin of a placement, in ground.
fn axes_and_origin(placement: &Placement) -> [[f64; 3]; 4] {
    let [x, y, z] = DVec3::AXES.map(|axis| placement.rotation.to_body(axis));
    [x, y, z, placement.translation_m].map(DVec3::into)
}

/// The force in body weights and the relative indentation of each sphere.
type SphereLoads = HashMap<SphereId, (f64, f64)>;

/// Computes the loads of the spheres of a body that stands on all of them.
fn loads_at_rest(model: &Model, forces: &[ForceId], options: &InspectOptions) -> SphereLoads {
    let mut loads = HashMap::new();
    // The contacts may be made for another mass than the bodies have before they are scaled.
    let mass_kg = options.masses.model_mass(model).ok().map(|mass| mass.kg);
    let share = mass_kg.zip(MassRequest::default().bodies_kg(model)).map_or(1.0, |(kg, bodies)| kg / bodies);
    for standing in Standing::all(model, forces).unwrap_or_default() {
        let all: Vec<SphereId> = standing.spheres.iter().map(|over| over.sphere).collect();
        let Some(Ok(rest)) = standing.rest_on_floor(&all, share) else { continue };
        for one in &rest.spheres {
            let (force_bw, indentation) = (one.force_n / rest.load_n, one.relative_indentation);
            if force_bw.is_finite() && indentation.is_finite() {
                loads.insert(one.sphere, (force_bw, indentation));
            }
        }
    }
    loads
}

/// The moving spheres of a model at their places in ground, with their sides and their loads.
fn placed_spheres(
    model: &Model,
    forces: &[ForceId],
    pose: &DefaultPose,
    loads: &SphereLoads,
) -> Vec<SceneSphere> {
    let limbs = model.limbs(forces);
    let limbs = limbs.if_known().unwrap_or_default().iter();
    let sides = limbs.flat_map(|limb| limb.spheres.iter().map(|&sphere| (sphere, limb.side)));
    let sides: HashMap<SphereId, Side> = sides.collect();
    let moving = model.spheres().iter().filter(|sphere| !sphere.fixed);
    let placed = moving.filter_map(|sphere| {
        let body = sphere.body.clone()?;
        let (force_bw, relative_indentation) = loads.get(&sphere.id).copied().unzip();
        let radius_m = sphere.round_radius_m().ok()?;
        let centre_m = pose.placement(&body).ok()?.point(model.centre_m(sphere.id)?);
        Some(SceneSphere {
            name: sphere.name.clone(),
            path: sphere.path.clone(),
            side: sides.get(&sphere.id).copied().map(Side::as_str),
            body,
            centre_m: centre_m.into(),
            radius_m,
            force_bw,
            relative_indentation,
        })
    });
    placed.filter(|sphere| sphere.centre_m.iter().all(|value| value.is_finite())).collect()
}

/// A line on a body, from its joint to the body above to a joint with a body below, in the frame of the body, m.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BodyLine {
    pub body: String,
    /// Place of the joint above the body, where its line begins, m.
    pub from_m: [f64; 3],
    /// Place of a joint below the body, where its line ends, m.
    pub to_m: [f64; 3],
}

/// The lines between the joints of all bodies; none if the skeleton cannot be read.
fn body_lines(model: &Model) -> Vec<BodyLine> {
    let Ok(anatomy) = Anatomy::of(model) else { return Vec::new() };
    let line = |below: &osim_model::AnatomyJoint| {
        let above = anatomy.joint_above(&below.parent)?;
        let (from, to) = (above.in_child_m, below.in_parent_m);
        (from.is_finite() && to.is_finite() && from != to).then(|| BodyLine {
            body: below.parent.clone(),
            from_m: from.into(),
            to_m: to.into(),
        })
    };
    anatomy.joints.iter().filter_map(line).collect()
}

/// The largest number of triangles of all bones together. A view with more triangles is too slow to turn.
const MOST_TRIANGLES: usize = 600_000;

/// The surfaces of all bones of a model, and the meshes that could not be read.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct BoneSurfaces {
    pub surfaces: Vec<BoneSurface>,
    /// Meshes whose files do not exist, as the model spells them, each once.
    pub missing: Vec<String>,
    pub broken: Vec<String>,
}

/// The surface of one bone, as triangles.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BoneSurface {
    pub body: String,
    /// The mesh, as the model spells it.
    pub mesh: String,
    /// x, y and z of one point after the other in the frame of the body, in hundredths of a millimetre.
    pub points: Vec<i32>,
    /// Three indices of points for each triangle.
    pub triangles: Vec<u32>,
}

impl BoneSurfaces {
    /// The bones of `model`, which was read from `path`.
    pub fn of(model: &Model, path: &Path, files: &dyn Files) -> Self {
        let folders = MeshFolders::of_model(path);
        let mut bones = Self::default();
        let (mut count, mut known) = (0, HashSet::new());
        for attached in model.attached_meshes() {
            let (body, mesh) = (attached.body.clone(), attached.file.clone());
            match attached_surface(&attached, &folders, files) {
                Err(FeetFault::MeshMissing { .. }) => {
                    if known.insert(mesh.clone()) {
                        bones.missing.push(mesh);
                    }
                }
                Err(fault) => bones.broken.push(fault.phrase().to_string()),
                Ok(surface) => {
                    count += surface.triangles.len();
                    if count > MOST_TRIANGLES {
                        bones.broken.push(format!("{mesh}: not drawn, because it has too many triangles"));
                        continue;
                    }
                    let points = surface.points.iter().flatten().map(|&value| in_view_units(value)).collect();
                    let triangles = surface.triangles.concat();
                    bones.surfaces.push(BoneSurface { body, mesh, points, triangles });
                }
            }
        }
        bones
    }
}

/// Units in a metre: lengths are whole numbers of hundredths of a millimetre.
const COORDINATE_UNITS_PER_M: f64 = 1e5;

/// A length in whole hundredths of a millimetre; or a component of an axis in hundred-thousandths.
fn in_view_units(metres: f64) -> i32 {
    (metres * COORDINATE_UNITS_PER_M).round() as i32
}

/// The largest number of frames that are shown. Of a longer recording every second, third, ... frame is shown.
const MOST_PLAYED_FRAMES: usize = 600;

/// A model along a recording, frame by frame: its bodies, and the forces of its contacts and of plates.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlayedRecording {
    pub time_s: Vec<f64>,
    /// Names of the bodies whose places are known in all frames of the recording.
    pub bodies: Vec<String>,
    /// Axes x, y and z and the origin of each body in ground, frame by frame, in hundred-thousandths.
    pub poses: Vec<i32>,
    pub feet: Vec<PlayedFoot>,
    /// Remarks on the recording.
    pub remarks: Vec<String>,
}

/// The forces on one foot along a recording, of the model and of the plates.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlayedFoot {
    pub name: String,
    /// Side of the foot, `right` or `left`.
    pub side: Option<&'static str>,
    pub model: PlayedForce,
    /// The forces that plates measured; `None` without plates.
    pub plates: Option<PlayedForce>,
}

/// A force on a foot and its centre of pressure, frame by frame.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlayedForce {
    /// Forces in each frame, body weights, in ground; `None` where one is not known.
    pub forces_bw: Vec<Option<[f64; 3]>>,
    /// The centre of pressure on the floor in each frame, m; `None` where the force is too small, or the point is not known.
    pub points_m: Vec<Option<[f64; 3]>>,
}

impl PlayedRecording {
    /// The frames of `result`, with the remarks for `request` in the words of `dialect`.
    pub fn of(result: &MotionResult, request: &MotionRequest, dialect: &dyn Dialect) -> Self {
        let states = &result.states;
        let step = states.frames().div_ceil(MOST_PLAYED_FRAMES).max(1);
        let frames: Vec<usize> = (0..states.frames()).step_by(step).collect();
        let poses = Poses::of(&result.opened.model, &result.recording, &frames);
        let feet = result.summary.feet.iter().enumerate().map(|(index, foot)| {
            let measured = result.measured.as_ref();
            let has_points = measured.is_some_and(|measured| measured.has_points.get(index) == Some(&true));
            let plates = measured.and_then(|measured| measured.feet.get(index));
            PlayedFoot {
                name: foot.foot.name.clone(),
                side: foot.foot.side.map(Side::as_str),
                model: played_force((result, foot), &frames, |frame| foot.wrenches.get(frame).copied(), true),
                plates: plates.map(|plates| {
                    let wrench_at = |frame: usize| plates.get(frame).copied().flatten();
                    played_force((result, foot), &frames, wrench_at, has_points)
                }),
            }
        });
        let placements = (0..frames.len()).flat_map(|number| poses.frame(number));
        Self {
            time_s: frames.iter().filter_map(|&frame| states.time_s.get(frame).copied()).collect(),
            poses: placements.flat_map(axes_and_origin).flatten().map(in_view_units).collect(),
            bodies: poses.bodies,
            feet: feet.collect(),
            remarks: result.remarks(request).iter().map(|remark| remark.message.spelled(dialect)).collect(),
        }
    }
}

/// The force on a foot in each frame, in body weights, from `wrench_at`, and where it acts on the floor, if plates or contacts know it.
fn played_force(
    (result, foot): (&MotionResult, &FootSummary),
    frames: &[usize],
    wrench_at: impl Fn(usize) -> Option<Wrench>,
    has_points: bool,
) -> PlayedForce {
    let weight_n = result.summary.weight_n;
    let force = |&frame: &usize| Some((wrench_at(frame)?.force_n / weight_n).into());
    // The centre of pressure on the floor below the foot.
    let point = |&frame: &usize| {
        let first = *foot.foot.pairs.first()?;
        let (state, pair) = (result.states.frame(frame).get(first)?, result.states.pairs.get(first)?);
        let (on_surface_m, least_n) = (state.on_surface_m(pair.radius_m), TOUCH_DOWN_BW * weight_n);
        let centre = wrench_at(frame)?.centre_of_pressure(state.normal, on_surface_m, least_n)?;
        Some(centre.point_m.into()).filter(|_| has_points)
    };
    PlayedForce {
        forces_bw: frames.iter().map(force).collect(),
        points_m: frames.iter().map(point).collect(),
    }
}

/// Bodies fall from a quarter of the radius, as in the paper's drop tests.
const HEIGHT_OF_FALLS: DropHeight = DropHeight::Radii(0.25);
/// The number of moments of a fall that are shown.
const MOMENTS_OF_FALL: usize = 361;
/// The duration of a fall, in √(R/g). A body that bounces like feet is at rest before. In this unit, bodies of all sizes fall alike.
const DURATION_IN_TIME_UNITS: f64 = 12.0;

/// A body that falls on its contacts.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct BodyFall {
    /// Name of the body.
    pub name: String,
    /// Time from one moment to the next, s.
    pub step_s: f64,
    /// Root of the mean R² of the body's spheres, √(Σ R²/n), m.
    pub radius_m: f64,
    /// Height of the spheres' bottoms over the ground at each moment, m; below 0 in contact.
    pub heights_m: Vec<f64>,
    /// Force of all spheres at each moment, body weights.
    pub forces_bw: Vec<f64>,
    /// Why the fall cannot be calculated; then there are no moments.
    pub why_not: Option<String>,
}

impl BodyFall {
    /// The falls of `bodies`, all with the same duration.
    pub fn all(bodies: &[ContactBody]) -> Vec<Self> {
        let radii = bodies.iter().filter_map(|body| {
            let weight = body.weight().ok()?;
            let largest = body.kinds.iter().map(|kind| kind.radius_m).fold(0.0, f64::max);
            Some((largest / weight.gravity_m_s2).sqrt())
        });
        let duration_s = DURATION_IN_TIME_UNITS * radii.fold(0.0, f64::max);
        bodies.iter().map(|body| Self::of_body(body, duration_s)).collect()
    }

    /// The fall of one body from a quarter of its radius.
    fn of_body(body: &ContactBody, duration_s: f64) -> Self {
        let none = |failure: Failure| Self {
            name: body.name.clone(),
            why_not: Some(failure.message.to_string()),
            ..Self::default()
        };
        let report = match series::run_drop_test(body, HEIGHT_OF_FALLS, duration_s, MOMENTS_OF_FALL) {
            Ok(report) => report,
            Err(failure) => return none(failure),
        };
        let of = |value: &dyn Fn(&Sample) -> f64| report.series.iter().map(value).collect();
        let intervals = (MOMENTS_OF_FALL - 1) as f64;
        Self {
            name: body.name.clone(),
            step_s: duration_s / intervals,
            radius_m: report.reference_radius_m,
            heights_m: of(&|sample| sample.height_m),
            forces_bw: of(&|sample| sample.force_n / report.body_weight_n),
            why_not: None,
        }
    }
}

/// The height from which animals of the paper's Table 1 fall, in radii, as in the drop tests of the paper.
const ANIMAL_DROP_HEIGHT_RADII: f64 = 0.25;
/// The number of moments of an animal's fall that are shown.
const ANIMAL_MOMENTS: usize = 181;
/// The animals of Table 1 whose falls are shown, from the smallest to the largest.
const ANIMALS_SHOWN: [&str; 3] = ["mouse", "human", "giraffe"];

/// An animal that falls on two kinds of contacts. Heights are those of its spheres' bottoms over the ground in radii, at equal times
/// in √(R/g).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnimalFall {
    pub name: &'static str,
    pub mass_kg: f64,
    /// Heights on the contacts of the paper's human, left as they are.
    pub left_behind: Vec<f64>,
    /// Heights on contacts that are scaled to the animal.
    pub scaled: Vec<f64>,
}

impl AnimalFall {
    /// The falls of a mouse, a human and a giraffe.
    ///
    /// # Errors
    /// None with the numbers of the table.
    pub fn all() -> Result<Vec<Self>, DropError> {
        let human = falisse2022().contact;
        let first = |name: &&str| animals().find(|animal| animal.taxon() == *name);
        let of = |animal: Animal| {
            Ok(Self {
                name: animal.taxon(),
                mass_kg: animal.scale().mass_kg(),
                left_behind: heights_in_radii(&human, &animal)?,
                scaled: heights_in_radii(&animal.contact()?, &animal)?,
            })
        };
        ANIMALS_SHOWN.iter().filter_map(first).map(of).collect()
    }
}

/// The heights of an animal's sphere bottoms in radii while it falls on `contact`, at equal times.
fn heights_in_radii(contact: &Contact, animal: &Animal) -> Result<Vec<f64>, DropError> {
    let scale = animal.scale();
    let radius_m = scale.radius_m();
    let duration_s = DURATION_IN_TIME_UNITS * (radius_m / scale.gravity_m_s2()).sqrt();
    let report: DropReport = DropTest::of(contact, &scale, ANIMAL_DROP_HEIGHT_RADII, duration_s)?.run()?;
    let last = report.series.len().saturating_sub(1);
    let moment = |index: usize| report.series.get(index * last / (ANIMAL_MOMENTS - 1));
    Ok((0..ANIMAL_MOMENTS).filter_map(moment).map(|sample| sample.height_m / radius_m).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn animals_of_all_sizes_fall_alike_on_their_own_contacts_and_not_on_those_of_a_human() {
        let falls = AnimalFall::all().unwrap();
        let end = |heights: &[f64]| *heights.last().unwrap();
        let scaled: Vec<f64> = falls.iter().map(|fall| end(&fall.scaled)).collect();
        assert!(scaled.iter().all(|height| (height / scaled[1] - 1.0).abs() < 1e-3), "{scaled:?}");
        let left: Vec<f64> = falls.iter().map(|fall| end(&fall.left_behind) / scaled[1]).collect();
        // Table 1: the mouse needs a quarter of the human's modulus, the giraffe sixteen times it.
        assert!(left[0] < 0.6 && (left[1] - 1.0).abs() < 1e-6 && left[2] > 3.0, "{left:?}");
    }
}
