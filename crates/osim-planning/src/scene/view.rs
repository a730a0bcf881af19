//! Where everything of a model is at the default pose.

use std::collections::HashMap;

use osim_inspect::InspectOptions;
use osim_model::feet::{ContactPlane, DefaultPose, Standing, ViewAxes};
use osim_model::{ForceId, MassRequest, Model, Placement, Side, SphereId};
use serde::Serialize;

use super::lines::{BodyLine, lines};

/// A model at its default pose, in ground, m.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Scene {
    /// Forward, up (against gravity) and to the right, of length 1.
    pub axes: [[f64; 3]; 3],
    /// Bodies that have a place.
    pub bodies: Vec<PlacedBody>,
    /// Contact spheres that move and whose bodies have a place, in file order.
    pub spheres: Vec<PlacedSphere>,
    /// Planes that spheres press on.
    pub planes: Vec<PlacedPlane>,
    /// Lines from joint to joint, for bodies without bones.
    pub lines: Vec<BodyLine>,
    /// Why bodies have no place, where one has none.
    pub why_not_placed: Option<String>,
}

/// Where a body is.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PlacedBody {
    /// Its name.
    pub name: String,
    /// Its axes x, y and z, and its origin.
    pub frame: [[f64; 3]; 4],
}

/// A contact sphere.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PlacedSphere {
    /// Its name.
    pub name: String,
    /// Its component path.
    pub path: String,
    /// The body that carries it.
    pub body: String,
    /// `right` or `left`.
    pub side: Option<&'static str>,
    /// Its centre, m.
    pub centre_m: [f64; 3],
    /// Its radius, m.
    pub radius_m: f64,
    /// What it carries, in body weights, where the body stands on all its spheres with the weight that they are to carry.
    pub force_bw: Option<f64>,
    /// How deep it is then, in its radius.
    pub relative_indentation: Option<f64>,
}

/// A plane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PlacedPlane {
    /// A point of it, m.
    pub point_m: [f64; 3],
    /// Its outward normal.
    pub normal: [f64; 3],
}

impl Scene {
    /// A model as it is inspected by `options`, which say what its contacts carry.
    #[must_use]
    pub fn of(model: &Model, options: &InspectOptions) -> Self {
        let pose = DefaultPose::of(model);
        let forces = options.selection.apply(model).map(|selected| selected.forces);
        let forces = forces.unwrap_or_else(|_| model.force_ids());
        let axes = ViewAxes::of(model);
        let planes = ContactPlane::all(model, &forces, &pose);
        let surfaces = planes.iter().filter_map(|plane| plane.surface);
        let placed = |name: &str| pose.placement(name).ok().map(frame);
        let bodies = model
            .bodies()
            .iter()
            .filter_map(|body| Some(PlacedBody { name: body.name.clone(), frame: placed(&body.name)? }));
        let mut faults = model.bodies().iter().filter_map(|body| pose.placement(&body.name).err());
        Self {
            axes: [axes.forward, axes.up, axes.right],
            bodies: bodies.collect(),
            spheres: spheres(model, &forces, &pose, &loads(model, &forces, options)),
            planes: surfaces.map(|one| PlacedPlane { point_m: one.point_m, normal: one.normal }).collect(),
            lines: lines(model),
            why_not_placed: faults.next().map(|fault| fault.to_string()),
        }
    }
}

/// The axes of a placement, and its origin.
pub(super) fn frame(placement: &Placement) -> [[f64; 3]; 4] {
    let axis = |axis| placement.rotation.to_body(axis);
    [axis([1.0, 0.0, 0.0]), axis([0.0, 1.0, 0.0]), axis([0.0, 0.0, 1.0]), placement.translation_m]
}

/// What a sphere carries.
struct Load {
    force_bw: f64,
    relative_indentation: f64,
}

/// What each sphere carries under the weight that the contacts are to carry.
fn loads(model: &Model, forces: &[ForceId], options: &InspectOptions) -> HashMap<SphereId, Load> {
    let mut found = HashMap::new();
    // Contacts may be for a body that the bodies of the model still have to become.
    let weighs = options.masses.of_model(model).ok().map(|mass| mass.kg);
    let share = weighs.zip(MassRequest::default().bodies_kg(model)).map_or(1.0, |(kg, bodies)| kg / bodies);
    for standing in Standing::all(model, forces).unwrap_or_default() {
        let all: Vec<SphereId> = standing.spheres.iter().map(|over| over.sphere).collect();
        let Some(Ok(rest)) = standing.rest(&all, share) else { continue };
        for one in &rest.spheres {
            let load =
                Load { force_bw: one.force_n / rest.load_n, relative_indentation: one.relative_indentation };
            if load.force_bw.is_finite() && load.relative_indentation.is_finite() {
                found.insert(one.sphere, load);
            }
        }
    }
    found
}

fn spheres(
    model: &Model,
    forces: &[ForceId],
    pose: &DefaultPose,
    loads: &HashMap<SphereId, Load>,
) -> Vec<PlacedSphere> {
    let limbs = model.limbs(forces);
    let limbs = limbs.known().unwrap_or_default().iter();
    let sides = limbs.flat_map(|limb| limb.spheres.iter().map(|&sphere| (sphere, limb.side)));
    let sides: HashMap<SphereId, Side> = sides.collect();
    let moving = model.spheres().iter().filter(|sphere| !sphere.fixed);
    let placed = moving.filter_map(|sphere| {
        let body = sphere.body.clone()?;
        let load = loads.get(&sphere.id);
        let radius_m = sphere.radius_m().ok()?;
        let centre_m = pose.placement(&body).ok()?.point(model.centre_m(sphere.id)?);
        Some(PlacedSphere {
            name: sphere.name.clone(),
            path: sphere.path.clone(),
            side: sides.get(&sphere.id).copied().map(Side::as_str),
            body,
            centre_m,
            radius_m,
            force_bw: load.map(|load| load.force_bw),
            relative_indentation: load.map(|load| load.relative_indentation),
        })
    });
    placed.filter(|sphere| sphere.centre_m.iter().all(|value| value.is_finite())).collect()
}
