//! How far spheres reach along the bones of a foot, and whether that is further than in any published model. These measures are used:
//!
//! - towards the next joint: the sphere's centre is projected on the line from its body's origin, or from the joint above, to the body's
//!   farthest next joint, and divided by their distance. Published models reach 1.341. A joint that is welded does not end the bone.
//! - along the foot: where the foremost centre is between the heel (0) and the tip of the toes (1) of OpenSim's standard foot, by the
//!   extents of the bones' meshes. Published models have 0.691 to 1.007. If the model has no toes, their tip is where toes of the foot's size
//!   would end, because the foot may carry their spheres.
//! - below the ankle: where bottoms of spheres on OpenSim's standard foot end, between its ankle (0) and the sole of its bones (1).
//!   Published models have 1.00 to 1.98; a thick shoe adds 0.8.
//! - behind the heel, along the foot, and beside the middle of the foot, in half widths of its bones. The rearmost centres of published
//!   models are at 0.037 or more, the ones nearest to the middle at most 0.36 beside it.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use osim_model::messages::four_significant;
use osim_model::{DVec3, Model, SphereId};

use crate::body_bones::{BodyBones, StandardFoot};

/// A sphere that reaches at most this far towards the next joint is usual.
const LARGEST_TOWARDS_JOINT: f64 = 1.4;
/// A sphere that reaches at least this far towards the next joint is usual. The number is negative, because some spheres are nearer to the
/// heel than the origin of their body, or than the ankle where no talus is.
const LEAST_TOWARDS_JOINT: f64 = -0.5;
/// The middle of the usual reach towards the next joint.
const MIDDLE_TOWARDS_JOINT: f64 = 0.45;
/// Usual reach of the foremost sphere along the foot, between heel (0) and tip of the toes (1).
const USUAL_ALONG_FOOT: RangeInclusive<f64> = 0.65..=1.05;
/// Usual reach of a foot's bottoms below the ankle, between the ankle (0) and the sole of the bones (1).
const USUAL_BELOW_ANKLE: RangeInclusive<f64> = 0.6..=2.85;
/// The middle of this range.
const MIDDLE_BELOW_ANKLE: f64 = 1.725;
/// Usual reach of the rearmost sphere along the foot.
const USUAL_FROM_HEEL: RangeInclusive<f64> = -0.15..=f64::INFINITY;
/// Usual reach of the sphere that is nearest to the middle of the foot, beside it.
const USUAL_BESIDE_FOOT: RangeInclusive<f64> = 0.0..=1.5;

/// How far one sphere reaches, towards the next joint or along the foot.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Reach {
    pub sphere: SphereId,
    pub value: f64,
    /// Name of the next joint, or of the body that is the hind part of the foot.
    pub towards: String,
    measure: ReachMeasure,
    /// The usual reach of this sphere.
    usual: RangeInclusive<f64>,
}

/// The length to which the reach of a sphere is compared: the distance to the next joint, the length of the foot from its heel, the height
/// of the ankle over the sole of the bones, or half the width of the foot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ReachMeasure {
    TowardsJoint,
    AlongFoot,
    FromHeel,
    BelowAnkle,
    BesideFoot,
}

impl Reach {
    /// Whether no published sphere reaches this far.
    pub(crate) fn is_odd(&self) -> bool {
        self.excess() > 0.0
    }

    /// How far outside the usual reach it is; not above 0 within it.
    pub(crate) fn excess(&self) -> f64 {
        (self.usual.start() - self.value).max(self.value - self.usual.end())
    }

    /// The reach in words, to follow the name of the sphere in a sentence.
    pub(crate) fn describe(&self) -> String {
        let (value, towards) = (four_significant(self.value), &self.towards);
        match self.measure {
            ReachMeasure::TowardsJoint if self.value < 0.0 => {
                format!(
                    "lies at {value} of the way to the next joint, {towards}: on the other side of its body"
                )
            }
            ReachMeasure::TowardsJoint => format!(
                "lies at {value} of the way to the next joint, {towards}; no published sphere is beyond 1.34"
            ),
            ReachMeasure::AlongFoot => format!(
                "is the foremost of {towards} and lies at {value} of the foot's length, published ones at 0.69 to 1.01"
            ),
            ReachMeasure::FromHeel => format!(
                "lies behind the heel of {towards}: at {value} of the foot's length, published ones at 0.037 or more"
            ),
            ReachMeasure::BesideFoot => format!(
                "lies beside {towards}: {value} half widths from its middle, published ones at most 0.36"
            ),
            ReachMeasure::BelowAnkle => format!(
                "ends at {value} of the way from the ankle of {towards} down to the sole of the bones, published ones at 1.00 to 1.98"
            ),
        }
    }
}

/// The reach of each foot sphere towards the next joint; and of the sphere of each foot that is foremost, rearmost, most usual below the
/// ankle, and nearest to the middle. Only if the last two are unusual, all spheres of the foot were moved.
pub(crate) fn reaches(model: &Model, bones: &BodyBones) -> Vec<Reach> {
    let reach = |sphere, value, towards, measure, usual| Reach { sphere, value, towards, measure, usual };
    let mut reaches = Vec::new();
    // For each foot the most usual reach along it, and of each sphere the reaches along it, below the ankle and beside the middle.
    let mut feet: BTreeMap<String, (f64, Vec<(SphereId, DVec3)>)> = BTreeMap::new();
    for id in model.loaded_spheres(&model.force_ids()) {
        let (Some(sphere), Some(centre)) = (model.sphere(id), model.centre_m(id)) else { continue };
        let Some(body) = sphere.body.as_deref().filter(|body| bones.is_foot(body)) else { continue };
        // Of several next joints, the one that is farthest from the body's origin. A joint nearer than a radius does not show how long
        // the bone is.
        let radius_m = sphere.radius.number;
        let next = bones.farthest_joint(body).filter(|joint| joint.in_parent_m.length() > radius_m);
        reaches.extend(next.map(|joint| {
            let along = |from_m: DVec3| {
                let way_m = joint.in_parent_m - from_m;
                (centre - from_m).dot(way_m) / way_m.length_squared()
            };
            let of_origin = along(DVec3::ZERO);
            // The origin of a body can be far from the joint above it, for example at the centre of mass.
            let of_joint = bones.joint_above(body).map_or(f64::NAN, |above| along(above.in_child_m));
            let off = |value: f64| (value - MIDDLE_TOWARDS_JOINT).abs();
            let value = if off(of_joint) < off(of_origin) { of_joint } else { of_origin };
            let most = if joint.is_weld { f64::INFINITY } else { LARGEST_TOWARDS_JOINT };
            reach(id, value, joint.name.clone(), ReachMeasure::TowardsJoint, LEAST_TOWARDS_JOINT..=most)
        }));
        let as_hind_part = |body: &str| bones.standard_foot(body).map(|foot| (body.to_owned(), foot));
        let as_toes = || {
            let joint = bones.joint_above(body)?;
            let (hind, foot) = as_hind_part(&joint.parent)?;
            Some((hind, foot, joint.in_parent_m - joint.in_child_m))
        };
        let foot = as_hind_part(body).map(|(hind, foot)| (hind, foot, DVec3::ZERO)).or_else(as_toes);
        if let Some((hind, foot, origin)) = foot {
            let StandardFoot { heel, tip, longest_tip, ankle_to_sole, half_width } = foot;
            let (place, ankle) = (origin + centre, bones.ankle_and_forward(&hind));
            let ankle_y = ankle.map_or(f64::NAN, |(ankle, _)| ankle[1]);
            let below = (ankle_y - place[1] + radius_m) / ankle_to_sole;
            let most = USUAL_ALONG_FOOT.end() * (longest_tip - heel) / (tip - heel);
            let value = DVec3::new((place[0] - heel) / (tip - heel), below, place[2].abs() / half_width);
            feet.entry(hind).or_insert((most, Vec::new())).1.push((id, value));
        }
    }
    for (hind, (most, spheres)) in feet {
        // Each measure is the axis of the sphere for which `order` gives the least number.
        let mut add = |measure, axis: usize, order: fn(f64) -> f64, usual| {
            let values = spheres.iter().map(|(id, value)| (*id, value[axis]));
            let least = values.min_by(|a, b| order(a.1).total_cmp(&order(b.1)));
            reaches.extend(least.map(|(id, value)| reach(id, value, hind.clone(), measure, usual)));
        };
        add(ReachMeasure::AlongFoot, 0, |along| -along, *USUAL_ALONG_FOOT.start()..=most);
        add(ReachMeasure::FromHeel, 0, |along| along, USUAL_FROM_HEEL);
        add(ReachMeasure::BelowAnkle, 1, |below| (below - MIDDLE_BELOW_ANKLE).abs(), USUAL_BELOW_ANKLE);
        add(ReachMeasure::BesideFoot, 2, |beside| beside, USUAL_BESIDE_FOOT);
    }
    reaches
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest reach towards a joint, the least and largest reach along the foot, the most usual one below the ankle, the rearmost one,
    /// and the one nearest to the middle of the foot, in the model of the corpus with these file names.
    fn measured_reaches(names: &[&str]) -> Option<[f64; 6]> {
        use osim_model::files::{CompanionPaths, InMemory, ModelFiles};
        let folder = std::env::var_os("OSIM_CORPUS").map(std::path::PathBuf::from)?;
        let read = |name: &str| std::fs::read(folder.join(name)).unwrap();
        let mut files = InMemory::default();
        names.iter().for_each(|name| files.add(name, read(name)));
        let beside = match names {
            [_, geometry, model] => {
                CompanionPaths { geometry: Some(geometry.as_ref()), model: Some(model.as_ref()) }
            }
            _ => CompanionPaths::default(),
        };
        let opened =
            ModelFiles::read(names[0].as_ref(), read(names[0]), beside, &files).unwrap().open().unwrap();
        let bones = BodyBones::of(&opened.model).unwrap();
        let reaches = reaches(&opened.model, bones);
        let values = |measure| reaches.iter().filter(move |one| one.measure == measure).map(|one| one.value);
        Some([
            values(ReachMeasure::TowardsJoint).fold(f64::NAN, f64::max),
            values(ReachMeasure::AlongFoot).fold(f64::NAN, f64::min),
            values(ReachMeasure::AlongFoot).fold(f64::NAN, f64::max),
            values(ReachMeasure::BelowAnkle).fold(f64::NAN, f64::max),
            values(ReachMeasure::FromHeel).fold(f64::NAN, f64::max),
            values(ReachMeasure::BesideFoot).fold(f64::NAN, f64::max),
        ])
    }

    const FALISSE: &str = include_str!("../../../fixtures/check/known_contacts.osim");

    /// The reach of the heel of the right foot of `text` towards the toes.
    fn heel_towards_joint(text: &str) -> Reach {
        let model = Model::parse(text).unwrap();
        let mut all = reaches(&model, BodyBones::of(&model).unwrap()).into_iter();
        let is_heel = |id| model.sphere(id).unwrap().name == "s1_r";
        all.find(|one| one.measure == ReachMeasure::TowardsJoint && is_heel(one.sphere)).unwrap()
    }

    #[test]
    fn the_origin_of_a_foot_may_be_elsewhere() {
        let heel = heel_towards_joint(FALISSE);
        // The origin is at the centre of mass, 90 mm ahead.
        let frame = "<frames><PhysicalOffsetFrame name=\"heel\"><socket_parent>/bodyset/calcn_r</socket_parent>\
             <translation>-0.09 0 0</translation></PhysicalOffsetFrame>";
        let moved = FALISSE
            .replace("<socket_child_frame>/bodyset/calcn_r<", "<socket_child_frame>heel<")
            .replacen("<frames>", frame, 1)
            .replace("0.16341 -0.00183 0.00099", "0.07341 -0.00183 0.00099")
            .replace("0.00190115 -0.01 -0.0038263", "-0.08809885 -0.01 -0.0038263");
        let of_moved = heel_towards_joint(&moved);
        assert!((of_moved.value - heel.value).abs() < 1e-9 && !of_moved.is_odd(), "{of_moved:?}");
        // The origin is at the ankle, and the heel is 65 mm behind it: (-0.065 0.125 + 0.045 0.04)/(0.125^2 + 0.04^2).
        let at_ankle = FALISSE
            .replace("0.16341 -0.00183 0.00099", "0.125 -0.04 0")
            .replace("0.00190115 -0.01 -0.0038263", "-0.065 -0.045 0");
        let at_ankle = heel_towards_joint(&at_ankle);
        assert!((at_ankle.value + 0.3672).abs() < 5e-5 && !at_ankle.is_odd(), "{at_ankle:?}");
    }

    /// Expected values were computed with NumPy from OpenSim 4.6's frames and the meshes' extents, with four digits.
    #[test]
    fn published_models_reach_as_far_as_measured() {
        let moco = [
            "v40600_moco_3d_walking_ContactForceSet.xml",
            "v40600_moco_3d_walking_ContactGeometrySet.xml",
            "v40600_moco_3d_walking_model_without_contacts.osim",
        ];
        let none = f64::NAN;
        for (names, expected) in [
            (&["v40000_toy_landing.osim"][..], [0.0551, 0.6915, 0.6915, 1.1962, 0.0746, 0.1178]),
            (&["v40000_scone_h0914m.osim"], [none, 1.0061, 1.0061, 1.0997, 0.1281, 0.0]),
            (&["v30000_scone_h0914m.osim"], [none, 1.0061, 1.0061, 1.0997, 0.1281, 0.0]),
            (&["v40000_moco_2d_gait.osim"], [1.0868, 0.7680, 0.7680, 1.4577, 0.1659, 0.0]),
            (&["v40000_falisse_2022_human.osim"], [0.9075, 0.9576, 0.9576, 1.7360, 0.0447, 0.0987]),
            (&["v30000_osim_rl_gait9dof18musc_crlf.osim"], [0.1653, 0.8233, 0.8233, 1.0417, 0.1499, 0.0]),
            (&["v20302_dynamic_jumper.osim"], [1.0325, 0.9777, 0.9777, 1.0041, 0.0369, 0.3535]),
            (&["v40000_dhondt_2024_3seg_human.osim"], [1.0249, none, none, none, none, none]),
            (&moco, [1.1374, 0.9551, 0.9551, 1.6126, 0.0938, 0.2217]),
        ] {
            let Some(found) = measured_reaches(names) else {
                eprintln!(
                    "skipped: reach of published models: OSIM_CORPUS is not set to the folder of real models"
                );
                return;
            };
            for (value, expected) in found.into_iter().zip(expected) {
                let both_absent = value.is_nan() && expected.is_nan();
                assert!(
                    both_absent || (value - expected).abs() < 6e-5,
                    "{names:?}: {value}, expected {expected}"
                );
            }
        }
    }
}
