//! The tests of the public functions of `osim-inspect`, in one program, because linking each program takes a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

#[allow(dead_code, unreachable_pub, reason = "osim-planning has these feet, too")]
mod feet;
mod figures;
mod fixed_to_ground;
mod load_sharing;
mod loops;
mod names;
mod places;
#[allow(dead_code, reason = "other tests need more of it")]
#[path = "../../../osim-planning/tests/planning/random.rs"]
mod random;
mod register;
mod rules;
mod sides;
mod skeleton;
mod unread;

use std::io::Write;
use std::path::{Path, PathBuf};

use osim_model::Model;
use osim_model::files::{CompanionPaths, Files, InMemory, ModelFiles};

/// The folder of published models; `None` if it is absent, which is said for `what`.
fn corpus_folder(what: &str) -> Option<PathBuf> {
    let folder = std::env::var_os("OSIM_CORPUS").map(PathBuf::from).filter(|folder| folder.is_dir());
    if folder.is_none() {
        // Straight to the terminal: the test harness keeps what a passing test prints to itself.
        let line = format!("skipped: {what}: OSIM_CORPUS is not set to the folder of real models\n");
        std::io::stderr().write_all(line.as_bytes()).unwrap();
    }
    folder
}

/// Moco's 3D walking model: two sets, with the model that they are for.
fn moco_3d_walking(folder: &Path) -> Model {
    let moco = |end: &str| folder.join(format!("v40600_moco_3d_walking_{end}"));
    let (forces, geometry, body) =
        (moco("ContactForceSet.xml"), moco("ContactGeometrySet.xml"), moco("model_without_contacts.osim"));
    let files: InMemory =
        [&forces, &geometry, &body].into_iter().map(|path| (path, std::fs::read(path).unwrap())).collect();
    let beside = CompanionPaths { geometry: Some(&geometry), model: Some(&body) };
    ModelFiles::read(&forces, files.read(&forces).unwrap(), beside, &files).unwrap().open().unwrap().model
}
