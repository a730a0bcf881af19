//! Where mesh files are looked for, and under which names.

use std::path::{Path, PathBuf};

use crate::model::Side;
use crate::model::files::Files;

/// Marks of the right and the left side in names of bones that are common: before and after the name.
const RIGHT: ([&str; 1], [&str; 2]) = (["r_"], ["_r", "_rv"]);
const LEFT: ([&str; 1], [&str; 2]) = (["l_"], ["_l", "_lv"]);

/// The folders in which meshes are looked for, in this order: that of the model, its `Geometry`, and others.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct MeshFolders(Vec<PathBuf>);

impl MeshFolders {
    /// For the model at `path`.
    ///
    /// ```
    /// use std::path::Path;
    /// use osim_model::feet::MeshFolders;
    ///
    /// let folders = MeshFolders::of_model(Path::new("models/walker.osim")).and("bones");
    /// let names: Vec<_> = folders.iter().collect();
    /// assert_eq!(names, [Path::new("models"), Path::new("models/Geometry"), Path::new("bones")]);
    /// ```
    #[must_use]
    pub fn of_model(path: &Path) -> Self {
        let folder = path.parent().unwrap_or(Path::new(""));
        Self(vec![folder.to_owned(), folder.join("Geometry")])
    }

    /// And another one, after those before.
    #[must_use]
    pub fn and(mut self, folder: impl Into<PathBuf>) -> Self {
        self.0.push(folder.into());
        self
    }

    /// The folders, in order.
    pub fn iter(&self) -> impl Iterator<Item = &Path> {
        self.0.iter().map(PathBuf::as_path)
    }

    /// Returns the file that `mesh` names, as a model spells it, and whether it is that of the other side: first the name itself
    /// in each folder, then each of its other names.
    pub(crate) fn find(&self, mesh: &str, files: &dyn Files) -> Option<(PathBuf, bool)> {
        let as_written = Some((mesh.to_owned(), false));
        let names = as_written.into_iter().chain(aliases(mesh));
        let places =
            names.flat_map(|(name, mirrored)| self.iter().map(move |folder| (folder.join(&name), mirrored)));
        places.into_iter().find(|(path, _)| files.exists(path))
    }
}

/// Other names of the file `mesh`, and whether each is that of the other side: without its folder, in small letters, with the
/// marks of its side or (a bone without a mark is the right one) without; then those of the other side, which is its mirror image
/// in z.
fn aliases(mesh: &str) -> Vec<(String, bool)> {
    let name = mesh.rsplit(['/', '\\']).next().unwrap_or(mesh);
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let (bone, side) = without_mark(&stem.to_lowercase());
    let other = if side == Side::Right { Side::Left } else { Side::Right };
    let own = spellings(&bone, side).into_iter().map(|stem| (stem, false));
    let mirrored = spellings(&bone, other).into_iter().map(|stem| (stem, true));
    let mut stems = vec![(stem.to_owned(), false), (stem.to_lowercase(), false)];
    stems.extend(own.chain(mirrored));
    let lower = ending.to_lowercase();
    let file = |(stem, mirrored)| {
        let endings = [ending, lower.as_str()].into_iter().take(if ending == lower { 1 } else { 2 });
        endings.map(move |ending| (format!("{stem}.{ending}"), mirrored)).collect::<Vec<_>>()
    };
    stems.into_iter().flat_map(file).collect()
}

/// The name of a bone without the mark of its side; without one it is the right one.
fn without_mark(stem: &str) -> (String, Side) {
    for (side, (before, behind)) in [(Side::Left, LEFT), (Side::Right, RIGHT)] {
        let bare = before.iter().find_map(|mark| stem.strip_prefix(mark));
        let bare = bare.or_else(|| behind.iter().find_map(|mark| stem.strip_suffix(mark)));
        if let Some(bare) = bare.filter(|bare| !bare.is_empty()) {
            return (bare.to_owned(), side);
        }
    }
    (stem.to_owned(), Side::Right)
}

/// The names of files of a bone of one side.
fn spellings(bone: &str, side: Side) -> Vec<String> {
    let (before, behind) = if side == Side::Right { RIGHT } else { LEFT };
    let marked = before.iter().map(|mark| format!("{mark}{bone}"));
    let marked = marked.chain(behind.iter().map(|mark| format!("{bone}{mark}")));
    // An unmarked bone is the right one.
    let bare = (side == Side::Right).then(|| bone.to_owned());
    marked.chain(bare).collect()
}

#[cfg(test)]
mod tests {
    use crate::model::files::InMemory;

    use super::*;

    #[track_caller]
    fn found(there: &[&str], mesh: &str) -> Option<(String, bool)> {
        let files = InMemory::from_iter(there.iter().map(|path| (*path, "")));
        let folders = MeshFolders::of_model(Path::new("models/m.osim")).and("bones");
        let (path, mirrored) = folders.find(mesh, &files)?;
        Some((path.to_string_lossy().replace('\\', "/"), mirrored))
    }

    #[track_caller]
    fn finds(there: &[&str], mesh: &str, path: &str, mirrored: bool) {
        assert_eq!(found(there, mesh), Some((path.to_owned(), mirrored)));
    }

    #[test]
    fn the_name_itself_comes_first_and_then_its_other_names() {
        finds(&["bones/foot.vtp", "models/Geometry/r_foot.vtp"], "foot.vtp", "bones/foot.vtp", false);
        finds(&["models/Geometry/r_foot.vtp"], "foot.vtp", "models/Geometry/r_foot.vtp", false);
        finds(&["models/foot.vtp"], "r_foot.vtp", "models/foot.vtp", false);
        finds(&["bones/talus_rv.vtp"], "talus.vtp", "bones/talus_rv.vtp", false);
        finds(&["bones/l_foot.vtp", "bones/r_foot.vtp"], "foot_l.vtp", "bones/l_foot.vtp", false);
        finds(&["bones/foot.vtp"], "Geometry\\FOOT.VTP", "bones/foot.vtp", false);
        finds(&["models/Geometry/sub/a.vtp"], "sub/a.vtp", "models/Geometry/sub/a.vtp", false);
    }

    #[test]
    fn a_bone_of_the_other_side_is_its_mirror_image() {
        finds(&["bones/r_foot.vtp"], "l_foot.vtp", "bones/r_foot.vtp", true);
        finds(&["bones/l_foot.vtp"], "foot.vtp", "bones/l_foot.vtp", true);
        finds(&["bones/foot.vtp"], "foot_lv.vtp", "bones/foot.vtp", true);
    }

    #[test]
    fn other_bones_are_not_taken() {
        assert_eq!(found(&["bones/bofoot.vtp", "bones/foot.stl"], "foot.vtp"), None);
    }
}
