//! Which mesh of one model shows the same bone as which of the other.

use std::cell::OnceCell;
use std::collections::BTreeMap;

use crate::model::Anatomy;
use foldhash::{HashMap, HashMapExt};

/// Folders, extensions and side marks that say nothing about the bone.
const SIDE_BEFORE: [&str; 2] = ["r_", "l_"];
const SIDE_AFTER: [&str; 4] = ["_rv", "_lv", "_r", "_l"];

/// Two meshes of one bone.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BonePair {
    /// The mesh of the scaled model.
    pub(super) mesh: String,
    /// New over old factors along x, y and z.
    pub(super) factors: [Option<f64>; 3],
}

/// The meshes of `body` that show the same bone in both models, in the order of their names.
pub(super) fn pairs(scaled: &Anatomy, reference: &Anatomy, body: &str) -> Vec<BonePair> {
    let (Some(new), Some(old)) = (scaled.meshes.get(body), reference.meshes.get(body)) else {
        return Vec::new();
    };
    let bones = OnceCell::new();
    let pair = |(mesh, new): (&String, &[f64; 3])| {
        let alike = || bones.get_or_init(|| Bones::of(old)).alike(mesh);
        let same_file = old.get(mesh);
        let old = same_file.or_else(alike)?;
        let factors = std::array::from_fn(|axis| {
            let ratio = (old[axis] != 0.0).then(|| new[axis] / old[axis])?;
            // A mirrored mesh of the other side may have a negative factor.
            Some(if same_file.is_some() { ratio } else { ratio.abs() })
        });
        Some(BonePair { mesh: mesh.clone(), factors })
    };
    new.iter().filter_map(pair).collect()
}

/// The factors of one body's meshes by what they show; where several show the same, those of the first.
struct Bones<'a> {
    by_bone: HashMap<String, &'a [f64; 3]>,
    by_side: HashMap<(String, Option<char>), &'a [f64; 3]>,
}

impl<'a> Bones<'a> {
    fn of(meshes: &'a BTreeMap<String, [f64; 3]>) -> Self {
        let mut bones = Self { by_bone: HashMap::new(), by_side: HashMap::new() };
        for (mesh, factors) in meshes {
            let bone = bone_of_mesh(mesh);
            bones.by_bone.entry(bone.clone()).or_insert(factors);
            bones.by_side.entry((bone, side(mesh))).or_insert(factors);
        }
        bones
    }

    /// The same file says more than the same bone, and a mesh of the same side more than its mirror.
    fn alike(&self, mesh: &str) -> Option<&'a [f64; 3]> {
        let sided = (bone_of_mesh(mesh), side(mesh));
        self.by_side.get(&sided).or_else(|| self.by_bone.get(&sided.0)).copied()
    }
}

/// The bone that a mesh shows: its file's name without folder, extension, case and side mark.
///
/// ```
/// assert_eq!(osim_model::compare::bone_of_mesh("Geometry/R_Foot.VTP"), osim_model::compare::bone_of_mesh("foot_lv.obj"));
/// ```
#[must_use]
pub fn bone_of_mesh(file: &str) -> String {
    let name = bare(file);
    let name = SIDE_BEFORE.iter().find_map(|mark| name.strip_prefix(mark)).unwrap_or(&name);
    let name = SIDE_AFTER.iter().find_map(|mark| name.strip_suffix(mark)).unwrap_or(name);
    name.to_owned()
}

/// Its side mark, as one letter.
fn side(file: &str) -> Option<char> {
    let name = bare(file);
    let before = SIDE_BEFORE.iter().find(|mark| name.starts_with(**mark));
    let after = SIDE_AFTER.iter().find(|mark| name.ends_with(**mark));
    before.or(after).and_then(|mark| mark.chars().find(|c| *c != '_'))
}

fn bare(file: &str) -> String {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    let name = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    name.to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_bone_has_many_names() {
        for name in [
            "foot.vtp",
            "r_foot.vtp",
            "l_foot.vtp",
            "foot_r.stl",
            "Geometry/R_Foot.VTP",
            "bones\\foot_lv.obj",
            "foot.vtp #2",
        ] {
            assert_eq!(bone_of_mesh(name), "foot", "{name}");
        }
        for name in ["bofoot.vtp", "footprint.vtp", "l_bofoot.vtp", "talus_rv.vtp"] {
            assert_ne!(bone_of_mesh(name), "foot", "{name}");
        }
        assert_eq!(
            (side("r_foot.vtp"), side("talus_lv.vtp"), side("foot.vtp")),
            (Some('r'), Some('l'), None)
        );
    }
}
