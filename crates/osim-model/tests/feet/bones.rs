//! Tests of bones: mesh files with the scale factors and frames that the model gives them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::path::Path;

use osim_model::Model;
use osim_model::feet::{Bone, FeetFault, MeshFolders, bones, mesh_points};
use osim_model::files::{Files, InMemory};

use crate::fixture_folder::Folder;

fn fixture_model(name: &str) -> Model {
    Model::parse(Folder.read(Path::new(name)).unwrap()).unwrap()
}

fn read_bones(name: &str, bodies: &[&str]) -> Vec<Bone> {
    bones(&fixture_model(name), bodies, &MeshFolders::of_model(Path::new(name)), &Folder).unwrap()
}

fn points_of_mesh(name: &str) -> Vec<[f64; 3]> {
    mesh_points(name, &Folder.read(&Path::new("Geometry").join(name)).unwrap()).unwrap()
}

#[test]
fn a_bone_without_scale_factors_has_the_points_of_its_mesh() {
    for model in ["human_30000.osim", "human_40000.osim"] {
        let found = read_bones(model, &["calcn_r", "toes_r", "calcn_l"]);
        let said: Vec<(&str, &str)> = found.iter().map(|bone| (&*bone.body, &*bone.mesh)).collect();
        let expected = [
            ("calcn_r", "r_human_foot.vtp"),
            ("toes_r", "r_human_toes.vtp"),
            ("calcn_l", "l_human_foot.vtp"),
        ];
        assert_eq!(said, expected);
        for bone in &found {
            assert_eq!(bone.points_m, points_of_mesh(&bone.mesh));
        }
    }
}

/// The toes of the bird: factors 1.1, 1, 1.2, then a turn by 0.1 rad about y (x to -z), then 2 mm forward.
#[test]
fn meshes_are_scaled_before_their_frame_moves_them() {
    let (s, c) = 0.1_f64.sin_cos();
    let expected: Vec<[f64; 3]> = points_of_mesh("r_bird_toes.vtp")
        .into_iter()
        .map(|[x, y, z]| (1.1 * x, y, 1.2 * z))
        .map(|(x, y, z)| [c * x + s * z + 0.002, y, c * z - s * x])
        .collect();
    for model in ["bird_30000.osim", "bird_40000.osim"] {
        let found = read_bones(model, &["toes_r", "toes_l"]);
        for (bone, side) in found.iter().zip([1.0, -1.0]) {
            assert_eq!(bone.points_m.len(), expected.len());
            for ([x, y, z], [a, b, c]) in bone.points_m.iter().zip(&expected) {
                assert!((x - a).abs().max((y - b).abs()).max((z - side * c).abs()) < 1e-15);
            }
        }
    }
}

#[test]
fn an_error_about_a_missing_mesh_names_the_searched_folders() {
    let model = fixture_model("human_40000.osim");
    let folders = MeshFolders::of_model(Path::new("models/human.osim")).with_folder("bones");
    let fault = |bodies: &[&str], files: &InMemory| bones(&model, bodies, &folders, files).unwrap_err();
    let missing = fault(&["calcn_r"], &InMemory::default());
    assert_eq!(
        missing.to_string().replace('\\', "/"),
        "body calcn_r shows mesh r_human_foot.vtp, which is in none of the folders models, models/Geometry, bones: copy it there, \
         or name the folder that has it"
    );
    assert_eq!(missing.code(), "mesh-missing");
    let broken = InMemory::from_iter([("bones/human_foot.vtp", "<VTKFile/>")]);
    assert_eq!(
        fault(&["calcn_r"], &broken).to_string().replace('\\', "/"),
        "mesh r_human_foot.vtp of body calcn_r, bones/human_foot.vtp: it has no <Points> in a <Piece> of <PolyData>"
    );
    assert!(matches!(fault(&["pelvis"], &broken), FeetFault::NoMesh { body } if body == "pelvis"));
    assert_eq!(
        fault(&["foot"], &broken).to_string(),
        "there is no body foot, the model has pelvis, femur_r, tibia_r, calcn_r, toes_r, femur_l, tibia_l, calcn_l, toes_l"
    );
}

#[test]
fn a_bone_of_the_other_side_is_mirrored() {
    let right = Folder.read(Path::new("Geometry/r_human_foot.vtp")).unwrap();
    let files = InMemory::from_iter([("Geometry/human_foot.vtp", right)]);
    let found = bones(
        &fixture_model("human_40000.osim"),
        &["calcn_l"],
        &MeshFolders::of_model(Path::new("m.osim")),
        &files,
    );
    let bone = &found.unwrap()[0];
    assert!(bone.mirrored);
    assert_eq!(bone.points_m, points_of_mesh("l_human_foot.vtp"));
}

#[test]
fn scale_factors_of_meshes_must_be_numbers() {
    let text = String::from_utf8(Folder.read(Path::new("bird_40000.osim")).unwrap()).unwrap();
    let broken = text.replace("<scale_factors>1.1000000000000001 1 1.2", "<scale_factors>1.1 0 nan");
    let model = Model::parse(broken).unwrap();
    let fault = bones(&model, &["toes_r"], &MeshFolders::of_model(Path::new("m.osim")), &Folder).unwrap_err();
    assert_eq!(
        fault.to_string(),
        "scale factors of mesh r_bird_toes.vtp of body toes_r are 1.1, 0, NaN, expected three numbers other than 0, at most 1e9"
    );
}

#[test]
fn names_from_outside_cannot_steer_a_terminal() {
    let text = String::from_utf8(Folder.read(Path::new("human_40000.osim")).unwrap()).unwrap();
    let model = Model::parse(text.replace("r_human_foot.vtp", "\u{9}a&#27;[2J\nb.vtp")).unwrap();
    let fault =
        bones(&model, &["calcn_r"], &MeshFolders::of_model(Path::new("m.osim")), &Folder).unwrap_err();
    let said = fault.phrase().to_string();
    assert!(!said.contains(['\u{1b}', '\n', '\t']) && said.contains("b.vtp"), "{said}");
}
