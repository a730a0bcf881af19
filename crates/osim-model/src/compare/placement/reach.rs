//! Spheres that reach further than in any published model: J and L.
//!
//! J: a sphere's centre is projected on the line from its body's origin to the farthest joint of that body to a next one, and
//! divided by their distance. Published models reach 1.206 (Moco's running). L: how far along the standard foot, from the heel (0)
//! to the tip of the toes (1) by the extents of the bones' meshes, the foremost centre is. Published: 0.691 to 1.007.

use std::collections::BTreeMap;

use crate::messages::four_significant;
use crate::model::{Model, SphereId};

use super::bones::Bones;

/// Largest J that is not odd.
const LARGEST_J: f64 = 1.25;
/// Least and largest L that is not odd.
const LEAST_L: f64 = 0.65;
const LARGEST_L: f64 = 1.05;

/// One J or L, and the sphere of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Reach {
    /// The sphere.
    pub sphere: SphereId,
    /// J or L.
    pub value: f64,
    /// The next joint, or the bone.
    pub of: String,
    measure: Measure,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Measure {
    J,
    L,
}

impl Reach {
    /// Whether published models stay within.
    pub(super) fn is_odd(&self) -> bool {
        match self.measure {
            Measure::J => self.value > LARGEST_J,
            Measure::L => !(LEAST_L..=LARGEST_L).contains(&self.value),
        }
    }

    /// In words, after the name of the sphere.
    pub(crate) fn describe(&self) -> String {
        let (value, of) = (four_significant(self.value), &self.of);
        match self.measure {
            Measure::J => format!(
                "lies at {value} of the way to the next joint, {of}, and no published sphere beyond 1.21"
            ),
            Measure::L => format!(
                "is the foremost of {of} and lies at {value} of the foot's length, published ones at 0.69 to 1.01"
            ),
        }
    }
}

/// J of each sphere of a foot, and L of each foot.
pub(super) fn reaches(model: &Model, bones: &Bones) -> Vec<Reach> {
    let mut found = Vec::new();
    let mut foremost: BTreeMap<String, (SphereId, f64)> = BTreeMap::new();
    for id in model.loaded_spheres(&model.force_ids()) {
        let (Some(sphere), Some(centre)) = (model.sphere(id), model.centre_m(id)) else { continue };
        let Some(body) = sphere.body.as_deref().filter(|body| bones.is_foot(body)) else { continue };
        found.extend(reach_to_joint(bones, body, id, centre, sphere.radius.number));
        let hind = |body: &str| bones.standard_foot(body).map(|ends| (body.to_owned(), ends));
        let above = || {
            let joint = bones.joint_above(body)?;
            let (hind, ends) = hind(&joint.parent)?;
            Some((hind, ends, joint.in_parent_m[0] - joint.in_child_m[0]))
        };
        let of_foot = hind(body).map(|(hind, ends)| (hind, ends, 0.0)).or_else(above);
        if let Some((hind, [heel, tip], origin)) = of_foot {
            let along = (origin + centre[0] - heel) / (tip - heel);
            let most = foremost.entry(hind).or_insert((id, along));
            if along > most.1 {
                *most = (id, along);
            }
        }
    }
    let lengths =
        foremost.into_iter().map(|(of, (sphere, value))| Reach { sphere, value, of, measure: Measure::L });
    found.extend(lengths);
    found
}

/// J of a sphere with its centre and radius, for the next joint that is farthest from the body's origin.
///
/// `None` without a next joint, or where it is nearer than a radius: such a joint says nothing about the length of the bone.
fn reach_to_joint(
    bones: &Bones,
    body: &str,
    sphere: SphereId,
    centre: [f64; 3],
    radius_m: f64,
) -> Option<Reach> {
    let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (squared, joint) = bones.farthest_joint(body)?;
    let value = dot(centre, joint.in_parent_m) / squared;
    (squared > radius_m * radius_m).then(|| Reach {
        sphere,
        value,
        of: joint.name.clone(),
        measure: Measure::J,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest J, and the least and largest L, of a model of the corpus, from files `names`.
    fn measured(names: &[&str]) -> Option<(f64, f64, f64)> {
        use crate::model::files::{Beside, InMemory, ModelFiles};
        let folder = std::env::var_os("OSIM_CORPUS").map(std::path::PathBuf::from)?;
        let read = |name: &str| std::fs::read(folder.join(name)).unwrap();
        let mut files = InMemory::default();
        names.iter().for_each(|name| files.add(name, read(name)));
        let beside = match names {
            [_, geometry, model] => Beside { geometry: Some(geometry.as_ref()), model: Some(model.as_ref()) },
            _ => Beside::default(),
        };
        let opened =
            ModelFiles::read(names[0].as_ref(), read(names[0]), beside, &files).unwrap().open().unwrap();
        let bones = Bones::of(&opened.model).unwrap();
        let found = reaches(&opened.model, bones);
        let of = |measure| found.iter().filter(move |one| one.measure == measure).map(|one| one.value);
        Some((
            of(Measure::J).fold(f64::NAN, f64::max),
            of(Measure::L).fold(f64::NAN, f64::min),
            of(Measure::L).fold(f64::NAN, f64::max),
        ))
    }

    /// Each from OpenSim 4.6's own frames and the meshes' extents, in NumPy (four digits).
    #[test]
    fn published_models_reach_as_far_as_measured() {
        let moco = [
            "v40600_moco_3d_walking_ContactForceSet.xml",
            "v40600_moco_3d_walking_ContactGeometrySet.xml",
            "v40600_moco_3d_walking_model_without_contacts.osim",
        ];
        let none = f64::NAN;
        for (names, j, least, most) in [
            (&["v40000_toy_landing.osim"][..], 0.0551, 0.6915, 0.6915),
            (&["v40000_scone_h0914m.osim"], none, 1.0061, 1.0061),
            (&["v30000_scone_h0914m.osim"], none, 1.0061, 1.0061),
            (&["v40000_moco_2d_gait.osim"], 1.0868, 0.7680, 0.7680),
            (&["v40000_falisse_2022_human.osim"], 0.9075, 0.9576, 0.9576),
            (&["v30000_osim_rl_gait9dof18musc_crlf.osim"], 0.1653, 0.8233, 0.8233),
            (&["v20302_dynamic_jumper.osim"], 1.0325, 0.9777, 0.9777),
            (&["v40000_dhondt_2024_3seg_human.osim"], 1.0249, none, none),
            (&moco, 1.1374, 0.9551, 0.9551),
        ] {
            let Some(found) = measured(names) else {
                eprintln!(
                    "skipped: reach of published models: OSIM_CORPUS is not set to the folder of real models"
                );
                return;
            };
            for (value, expected) in [(found.0, j), (found.1, least), (found.2, most)] {
                let both_absent = value.is_nan() && expected.is_nan();
                assert!(
                    both_absent || (value - expected).abs() < 6e-5,
                    "{names:?}: {value}, expected {expected}"
                );
            }
        }
    }
}
