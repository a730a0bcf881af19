//! Meshes that do not fit the skeleton that shows them: in another unit, of another animal, or with a broken vertex.

use std::collections::HashSet;

use crate::messages::{shown, three_significant};
use crate::model::files::Files;
use crate::model::{Model, probable_units};

use crate::feet::bone::Bone;
use crate::feet::bones::bone;
use crate::feet::fault::FeetFault;
use crate::feet::folders::MeshFolders;
use crate::feet::mesh::MeshFault;

/// A mesh is at most this many times as long as the longest bone of its limb. Feet, toes and tali on the models of the corpus, with the
/// files of its Geometry, are 0.136 to 0.6 of it; a foot without a limb, whose longest bone is its own, is 1.2.
const LONGEST: f64 = 3.0;
/// And at least this part of it: a bone in the toe of a hoofed animal is 0.03.
const SHORTEST: f64 = 0.01;
/// What is usual for a foot, for guesses about units.
const USUAL: f64 = 0.5;

/// A mesh that does not fit the skeleton.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct OddMesh {
    /// Name of the body.
    pub body: String,
    /// Name of the mesh file as the model spells it.
    pub mesh: String,
    /// What is wrong with it, in words.
    pub text: String,
}

/// Meshes of `bodies` that do not fit the skeleton, in file order: those with a broken vertex, and those that are far too long or too
/// short. Meshes that are not there, or cannot be read, say nothing.
#[must_use]
pub fn odd_meshes(
    model: &Model,
    bodies: &HashSet<&str>,
    folders: &MeshFolders,
    files: &dyn Files,
) -> Vec<OddMesh> {
    let attached = model.attached_meshes();
    let shown = attached.iter().filter(|mesh| bodies.contains(mesh.body.as_str()));
    let odd = |mesh| match bone(mesh, folders, files) {
        Ok(bone) => odd_size(model, &bone),
        Err(fault) => of_fault(&fault),
    };
    shown.filter_map(odd).collect()
}

/// The bone, if it is far too long or too short for its limb: for the longest distance between two joints of one body.
///
/// ```
/// use osim_model::feet::{Bone, odd_size};
///
/// let text = include_bytes!("../../../../fixtures/feet/human_40000.osim");
/// let model = osim_model::Model::parse(text)?;
/// let foot = |unit: f64| Bone::new("calcn_r", "foot.vtp", vec![[0.0; 3], [0.25 * unit, 0.0, 0.0]]);
/// assert_eq!(odd_size(&model, &foot(1.0)), None);
/// let in_millimetres = odd_size(&model, &foot(1000.0)).map(|odd| odd.text).unwrap_or_default();
/// assert!(in_millimetres.starts_with("mesh foot.vtp on calcn_r is 250 m long"));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[must_use]
pub fn odd_size(model: &Model, bone: &Bone) -> Option<OddMesh> {
    let distances = model.joint_distances();
    let longest_m = distances.of_limb(&bone.body).or_else(|| distances.around_body(&bone.body))?;
    let length_m = length_m(bone);
    let times = length_m / longest_m;
    if !times.is_finite() || (SHORTEST..=LONGEST).contains(&times) {
        return None;
    }
    let text = format!(
        "mesh {} on {} is {} m long, {} times the longest bone of its limb ({} m between its joints), expected {SHORTEST} to {LONGEST} \
         times{}",
        shown(&bone.mesh),
        shown(&bone.body),
        three_significant(length_m),
        three_significant(times),
        three_significant(longest_m),
        way_out(times)
    );
    Some(OddMesh { body: bone.body.clone(), mesh: bone.mesh.clone(), text })
}

/// The diagonal of the box around the points, m.
fn length_m(bone: &Bone) -> f64 {
    let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| {
        let along = || bone.points_m.iter().map(|point| point[axis]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    });
    x.hypot(y).hypot(z)
}

/// Factors that would fit, or another bone.
fn way_out(times: f64) -> String {
    let (verb, units) = match times > LONGEST {
        true => ("divide", probable_units(times / USUAL)),
        false => ("multiply", probable_units(USUAL / times)),
    };
    // A file in mm with the factors of one in metres is too long; one in metres with those of mm is too short.
    let file = |unit: &str| if times > LONGEST { unit.to_owned() } else { format!("m and not in {unit}") };
    let ways: Vec<String> = units
        .iter()
        .map(|(unit, per_metre)| {
            format!("{verb} its scale factors by {per_metre} if the file is in {}", file(unit))
        })
        .collect();
    match ways.as_slice() {
        [] => ": it is another animal's bone of this name, or its scale factors are wrong".to_owned(),
        ways => format!(": {}", ways.join(", or ")),
    }
}

/// A file with a broken vertex; other files that cannot be read show nothing of sizes.
fn of_fault(fault: &FeetFault) -> Option<OddMesh> {
    let FeetFault::Mesh { body, mesh, fault: MeshFault::StrayPoint { .. }, .. } = fault else { return None };
    Some(OddMesh { body: body.clone(), mesh: mesh.clone(), text: fault.phrase().to_string() })
}
