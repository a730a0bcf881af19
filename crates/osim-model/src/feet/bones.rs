//! Reads the bones of a model's bodies: the mesh files that are attached to the bodies.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use foldhash::HashMap;
use glam::DVec3;

use super::fault::{FeetFault, Result};
use super::mesh::{MeshFault, MeshSurface, is_length, length, mesh_points, mesh_surface};
use crate::messages::{shown, three_significant};
use crate::model::files::Files;
use crate::model::{AttachedMesh, Model, Side, probable_units};

/// A mesh that is attached to a body, with its points in the body's frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Bone {
    pub body: String,
    /// Name of the mesh file, as the model writes it.
    pub mesh: String,
    /// Points of the mesh in the body's frame, with the model's scale factors, m.
    pub points_m: Vec<[f64; 3]>,
    /// The mesh file that was read; empty if the points do not come from a file.
    pub file: PathBuf,
    /// Whether the file is the mesh of the other side; its points were then mirrored in z.
    pub mirrored: bool,
}

impl Bone {
    /// A bone whose points are already in the body's frame, m.
    pub fn new(body: impl Into<String>, mesh: impl Into<String>, points_m: Vec<[f64; 3]>) -> Self {
        Self { body: body.into(), mesh: mesh.into(), points_m, file: PathBuf::new(), mirrored: false }
    }
}

/// The meshes that are attached to the bodies of a model, listed by body.
pub struct AttachedBones<'m> {
    model: &'m Model,
    attached: HashMap<&'m str, Vec<AttachedMesh>>,
}

impl<'m> AttachedBones<'m> {
    /// The meshes that are attached to each body of `model`.
    pub fn of(model: &'m Model) -> Self {
        let bodies = model.bodies().iter().map(|body| (body.name.as_str(), Vec::new()));
        let mut attached: HashMap<&str, Vec<AttachedMesh>> = bodies.collect();
        for mesh in model.attached_meshes() {
            if let Some(of_body) = attached.get_mut(mesh.body.as_str()) {
                of_body.push(mesh);
            }
        }
        Self { model, attached }
    }

    /// The bones of `body`, in the order of the model file. Points are in the body's frame, after the model's scale factors and frames.
    ///
    /// # Errors
    /// The body does not exist or has no mesh, or a mesh file is missing or broken. The error names the body, the mesh and the searched
    /// folders.
    pub fn bones(&self, body: &str, folders: &MeshFolders, files: &dyn Files) -> Result<Vec<Bone>> {
        let Some(meshes) = self.attached.get(body) else {
            let bodies = self.model.bodies().iter().map(|known| known.name.clone()).collect();
            return Err(FeetFault::NoBody { body: body.to_owned(), bodies });
        };
        if meshes.is_empty() {
            return Err(FeetFault::NoMesh { body: body.to_owned() });
        }
        meshes.iter().map(|mesh| read_bone(mesh, folders, files)).collect()
    }
}

/// The bones of several bodies, in the order of `bodies`.
pub fn bones(model: &Model, bodies: &[&str], folders: &MeshFolders, files: &dyn Files) -> Result<Vec<Bone>> {
    let attached = AttachedBones::of(model);
    let mut all = Vec::new();
    for body in bodies {
        all.extend(attached.bones(body, folders, files)?);
    }
    Ok(all)
}

pub(crate) fn read_bone(attached: &AttachedMesh, folders: &MeshFolders, files: &dyn Files) -> Result<Bone> {
    let (points, file, mirrored) = read_mesh(attached, folders, files, mesh_points)?;
    let points = points.into_iter().map(|point| point_on_body(attached, mirrored, point)).collect();
    Ok(Bone { file, mirrored, ..Bone::new(attached.body.clone(), attached.file.clone(), points) })
}

/// The surface of one mesh. Its points are in the frame of the body, m.
pub fn attached_surface(
    attached: &AttachedMesh,
    folders: &MeshFolders,
    files: &dyn Files,
) -> Result<MeshSurface> {
    let (mut surface, _, mirrored) = read_mesh(attached, folders, files, mesh_surface)?;
    surface.points.iter_mut().for_each(|point| *point = point_on_body(attached, mirrored, *point));
    Ok(surface)
}

fn point_on_body(attached: &AttachedMesh, mirrored: bool, [x, y, z]: [f64; 3]) -> [f64; 3] {
    attached.on_body([x, y, if mirrored { -z } else { z }]).to_array()
}

/// Finds the file of a mesh, and reads it with `read`. Also gives the file, and whether it is the bone of the other side.
fn read_mesh<T>(
    attached: &AttachedMesh,
    folders: &MeshFolders,
    files: &dyn Files,
    read: fn(&str, &[u8]) -> Result<T, MeshFault>,
) -> Result<(T, PathBuf, bool)> {
    let (body, mesh, factors) = (attached.body.clone(), attached.file.clone(), attached.factors);
    if factors.iter().any(|factor| !is_length(*factor) || *factor == 0.0) {
        return Err(FeetFault::Factors { body, mesh, factors });
    }
    let Some((file, mirrored)) = folders.find(&mesh, files) else {
        let folders = folders.iter().map(PathBuf::from).collect();
        return Err(FeetFault::MeshMissing { body, mesh, folders });
    };
    let bytes = match files.read_included(&file) {
        Ok(bytes) => bytes,
        Err(fault) => return Err(FeetFault::Unreadable { body, mesh, file, fault }),
    };
    match read(&file.to_string_lossy(), &bytes) {
        Ok(mesh) => Ok((mesh, file, mirrored)),
        Err(fault) => Err(FeetFault::Mesh { body, mesh, file, fault }),
    }
}

// Where mesh files are looked for, and under which names.

/// Marks of the right side in names of bone files: those before the name of the bone, and those after the name.
const RIGHT_SIDE_MARKS: ([&str; 1], [&str; 2]) = (["r_"], ["_r", "_rv"]);
/// Marks of the left side in names of bone files: those before the name of the bone, and those after the name.
const LEFT_SIDE_MARKS: ([&str; 1], [&str; 2]) = (["l_"], ["_l", "_lv"]);

/// The folders in which mesh files are searched, in this order: the folder of the model, its subfolder `Geometry`, then folders that the
/// caller adds.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct MeshFolders(Vec<PathBuf>);

impl MeshFolders {
    /// The folders in which OpenSim looks for meshes of the model at `path`.
    ///
    /// ```
    /// use std::path::Path;
    /// use osim_model::feet::MeshFolders;
    ///
    /// let folders = MeshFolders::of_model(Path::new("models/walker.osim")).with_folder("bones");
    /// let names: Vec<_> = folders.iter().collect();
    /// assert_eq!(names, [Path::new("models"), Path::new("models/Geometry"), Path::new("bones")]);
    /// ```
    pub fn of_model(path: &Path) -> Self {
        let folder = path.parent().unwrap_or(Path::new(""));
        Self(vec![folder.to_owned(), folder.join("Geometry")])
    }

    /// Adds a folder in which meshes are searched after those in all other folders.
    pub fn with_folder(mut self, folder: impl Into<PathBuf>) -> Self {
        self.0.push(folder.into());
        self
    }

    /// The folders in the order of the search.
    pub fn iter(&self) -> impl Iterator<Item = &Path> {
        self.0.iter().map(PathBuf::as_path)
    }

    /// Finds the file of `mesh`, a name in the model, and whether the file is of the other side. The name as written is searched in all
    /// folders first, then each of the other names.
    pub(crate) fn find(&self, mesh: &str, files: &dyn Files) -> Option<(PathBuf, bool)> {
        let as_written = Some((mesh.to_owned(), false));
        let names = as_written.into_iter().chain(other_names(mesh));
        let places =
            names.flat_map(|(name, mirrored)| self.iter().map(move |folder| (folder.join(&name), mirrored)));
        places.into_iter().find(|(path, _)| files.exists(path))
    }
}

/// Other names under which the file `mesh` may exist, and whether each is of the other side. First come names of the same side: without a
/// folder, in small letters, with and without marks of the side. A bone without a mark is a right one. Then come names of the other side,
/// whose mesh is the mirror image in z.
fn other_names(mesh: &str) -> Vec<(String, bool)> {
    let name = mesh.rsplit(['/', '\\']).next().unwrap_or(mesh);
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let (bone, side) = without_mark(&stem.to_lowercase());
    let same_side = names_of_side(&bone, side).into_iter().map(|stem| (stem, false));
    let mirrored = names_of_side(&bone, side.other()).into_iter().map(|stem| (stem, true));
    let mut stems = vec![(stem.to_owned(), false), (stem.to_lowercase(), false)];
    stems.extend(same_side.chain(mirrored));
    let lower = ending.to_lowercase();
    let file = |(stem, mirrored)| {
        let endings = [ending, lower.as_str()].into_iter().take(if ending == lower { 1 } else { 2 });
        endings.map(move |ending| (format!("{stem}.{ending}"), mirrored)).collect::<Vec<_>>()
    };
    stems.into_iter().flat_map(file).collect()
}

/// The name of a bone without its side mark, and the side. A name without a mark is of the right side.
fn without_mark(stem: &str) -> (String, Side) {
    for (side, (before, behind)) in [(Side::Left, LEFT_SIDE_MARKS), (Side::Right, RIGHT_SIDE_MARKS)] {
        let bare = before.iter().find_map(|mark| stem.strip_prefix(mark));
        let bare = bare.or_else(|| behind.iter().find_map(|mark| stem.strip_suffix(mark)));
        if let Some(bare) = bare.filter(|bare| !bare.is_empty()) {
            return (bare.to_owned(), side);
        }
    }
    (stem.to_owned(), Side::Right)
}

/// The names that a file of the bone may have on one side.
fn names_of_side(bone: &str, side: Side) -> Vec<String> {
    let (before, behind) = if side == Side::Right { RIGHT_SIDE_MARKS } else { LEFT_SIDE_MARKS };
    let marked = before.iter().map(|mark| format!("{mark}{bone}"));
    let marked = marked.chain(behind.iter().map(|mark| format!("{bone}{mark}")));
    // An unmarked bone is the right one.
    let bare = (side == Side::Right).then(|| bone.to_owned());
    marked.chain(bare).collect()
}

// Meshes that do not fit the skeleton that shows them: in another unit, of another animal, or with a broken vertex.

/// The longest plausible mesh, as a multiple of the longest bone of its limb. Meshes of feet, toes and tali in real models are 0.136 to 0.6
/// of that bone. A foot alone, without a limb, is 1.2 times its own longest distance between joints.
const MOST_BONE_LENGTHS: f64 = 3.0;
/// The shortest plausible mesh, as a part of the longest bone of its limb: a toe bone of a hoofed animal has 0.03.
const LEAST_BONE_LENGTHS: f64 = 0.01;
/// The usual length of a mesh of a foot, as a part of the longest bone of its limb. Used to guess the unit of a mesh.
const USUAL_BONE_LENGTHS: f64 = 0.5;

/// A mesh that does not fit the skeleton: its length is implausible, or a vertex is broken.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OddMesh {
    pub body: String,
    /// Name of the mesh file, as the model writes it.
    pub mesh: String,
    /// The message for the user about the mesh that is odd.
    pub text: String,
}

/// Meshes of `bodies` that do not fit the skeleton, in file order: those that are far too long or too short, and those with a broken
/// vertex. Missing or unreadable meshes are left out.
pub fn odd_meshes(
    model: &Model,
    bodies: &HashSet<&str>,
    folders: &MeshFolders,
    files: &dyn Files,
) -> Vec<OddMesh> {
    let attached = model.attached_meshes();
    let shown = attached.iter().filter(|mesh| bodies.contains(mesh.body.as_str()));
    let odd = |mesh| match read_bone(mesh, folders, files) {
        Ok(bone) => odd_size(model, &bone),
        Err(fault) => odd_vertex(&fault),
    };
    shown.filter_map(odd).collect()
}

/// Compares the length of a bone with the longest distance between two joints of a body on its limb. Returns a message if the bone is far
/// too long or too short.
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
pub fn odd_size(model: &Model, bone: &Bone) -> Option<OddMesh> {
    let distances = model.joint_distances();
    let longest_m =
        distances.longest_in_limb(&bone.body).or_else(|| distances.longest_around_body(&bone.body))?;
    let length_of_bone_m = length_of_bone_m(bone);
    let times = length_of_bone_m / longest_m;
    if !times.is_finite() || (LEAST_BONE_LENGTHS..=MOST_BONE_LENGTHS).contains(&times) {
        return None;
    }
    let text = format!(
        "mesh {} on {} is {} m long, {} times the longest bone of its limb ({} m between its joints), expected {LEAST_BONE_LENGTHS} to {MOST_BONE_LENGTHS} \
         times{}",
        shown(&bone.mesh),
        shown(&bone.body),
        three_significant(length_of_bone_m),
        three_significant(times),
        three_significant(longest_m),
        repair_advice(times)
    );
    Some(OddMesh { body: bone.body.clone(), mesh: bone.mesh.clone(), text })
}

/// The diagonal of the box around the bone's points, m.
fn length_of_bone_m(bone: &Bone) -> f64 {
    let points = || bone.points_m.iter().copied().map(DVec3::from);
    length(points().fold(DVec3::NEG_INFINITY, DVec3::max) - points().fold(DVec3::INFINITY, DVec3::min))
}

/// Advice on a mesh that is longer than usual by the factor `times`: change its scale factors, or choose another bone.
fn repair_advice(times: f64) -> String {
    let (verb, units) = match times > MOST_BONE_LENGTHS {
        true => ("divide", probable_units(times / USUAL_BONE_LENGTHS)),
        false => ("multiply", probable_units(USUAL_BONE_LENGTHS / times)),
    };
    // A file in mm with the factors of one in metres is too long; one in metres with those of mm is too short.
    let file =
        |unit: &str| if times > MOST_BONE_LENGTHS { unit.to_owned() } else { format!("m and not in {unit}") };
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

/// A message about a mesh with a broken vertex; `None` for other faults, which do not show the size of the mesh.
fn odd_vertex(fault: &FeetFault) -> Option<OddMesh> {
    let FeetFault::Mesh { body, mesh, fault: MeshFault::StrayPoint { .. }, .. } = fault else { return None };
    Some(OddMesh { body: body.clone(), mesh: mesh.clone(), text: fault.phrase().to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::files::InMemory;

    #[track_caller]
    fn file_found(there: &[&str], mesh: &str) -> Option<(String, bool)> {
        let files = InMemory::from_iter(there.iter().map(|path| (*path, "")));
        let folders = MeshFolders::of_model(Path::new("models/m.osim")).with_folder("bones");
        let (path, mirrored) = folders.find(mesh, &files)?;
        Some((path.to_string_lossy().replace('\\', "/"), mirrored))
    }

    #[track_caller]
    fn assert_file_found(there: &[&str], mesh: &str, path: &str, mirrored: bool) {
        assert_eq!(file_found(there, mesh), Some((path.to_owned(), mirrored)));
    }

    #[test]
    fn a_mesh_file_is_found_by_its_own_name_first() {
        assert_file_found(
            &["bones/foot.vtp", "models/Geometry/r_foot.vtp"],
            "foot.vtp",
            "bones/foot.vtp",
            false,
        );
        assert_file_found(&["models/Geometry/r_foot.vtp"], "foot.vtp", "models/Geometry/r_foot.vtp", false);
        assert_file_found(&["models/foot.vtp"], "r_foot.vtp", "models/foot.vtp", false);
        assert_file_found(&["bones/talus_rv.vtp"], "talus.vtp", "bones/talus_rv.vtp", false);
        assert_file_found(&["bones/l_foot.vtp", "bones/r_foot.vtp"], "foot_l.vtp", "bones/l_foot.vtp", false);
        assert_file_found(&["bones/foot.vtp"], "Geometry\\FOOT.VTP", "bones/foot.vtp", false);
        assert_file_found(&["models/Geometry/sub/a.vtp"], "sub/a.vtp", "models/Geometry/sub/a.vtp", false);
    }

    #[test]
    fn a_bone_of_the_other_side_is_its_mirror_image() {
        assert_file_found(&["bones/r_foot.vtp"], "l_foot.vtp", "bones/r_foot.vtp", true);
        assert_file_found(&["bones/l_foot.vtp"], "foot.vtp", "bones/l_foot.vtp", true);
        assert_file_found(&["bones/foot.vtp"], "foot_lv.vtp", "bones/foot.vtp", true);
    }

    #[test]
    fn meshes_of_other_bones_are_not_taken() {
        assert_eq!(file_found(&["bones/bofoot.vtp", "bones/foot.stl"], "foot.vtp"), None);
    }
}
