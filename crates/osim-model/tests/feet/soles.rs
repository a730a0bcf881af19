//! Tests of spheres that stand on soles. `tests/oracle/test_feet.py` computes the same with NumPy, for these models and many others.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::path::Path;

use osim_model::feet::{Bone, FeetFault, MeshFolders, Sole, SoleRequest, bones, soles};
use osim_model::files::{Files, InMemory};
use osim_model::{DVec3, Model, Side};

use crate::fixture_folder::Folder;

const HUMAN: &[&str] = &["calcn_r", "toes_r", "calcn_l", "toes_l"];
const ANIMALS: &[(&str, &[&str])] =
    &[("human", HUMAN), ("bird", &["toes_r", "toes_l"]), ("hoof", &["hoof_r", "hoof_l"])];

fn text_of_model(name: &str) -> String {
    String::from_utf8(Folder.read(Path::new(name)).unwrap()).unwrap()
}

fn soles_in_text(text: &str, bodies: &[&str], count: usize) -> Result<Vec<Sole>, FeetFault> {
    let model = Model::parse(text).unwrap();
    let bones = bones(&model, bodies, &MeshFolders::of_model(Path::new("m.osim")), &Folder)?;
    soles(&model, &bones, &SoleRequest { count, radius_m: 0.03, pad_m: 0.01 })
}

fn soles_of_fixture(name: &str, bodies: &[&str], count: usize) -> Vec<Sole> {
    soles_in_text(&text_of_model(name), bodies, count).unwrap()
}

/// Coordinates along the ground, for a model in which up is y: forward and to the right.
fn forward_and_right(place: DVec3) -> [f64; 2] {
    [place.x, place.z]
}

/// Whether a point is inside a convex outline, whatever its first corner and its direction.
fn is_inside(outline: &[DVec3], point: [f64; 2]) -> bool {
    let outline: Vec<[f64; 2]> = outline.iter().map(|&corner| forward_and_right(corner)).collect();
    let turns = |index: usize| {
        let (a, b) = (outline[index], outline[(index + 1) % outline.len()]);
        (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])
    };
    let turns: Vec<f64> = (0..outline.len()).map(turns).collect();
    turns.iter().all(|&turn| turn > -1e-10) || turns.iter().all(|&turn| turn < 1e-10)
}

#[test]
fn spheres_stand_in_the_outline_and_are_mirror_images() {
    for &(animal, bodies) in ANIMALS {
        for version in ["30000", "40000"] {
            for count in 1..=8 {
                let soles = soles_of_fixture(&format!("{animal}_{version}.osim"), bodies, count);
                let [right, left] = &soles[..] else { panic!("two feet") };
                assert_eq!((right.side, left.side), (Some(Side::Right), Some(Side::Left)));
                for sole in &soles {
                    assert_eq!((sole.up, sole.spheres.len()), (DVec3::Y, count));
                    for sphere in &sole.spheres {
                        assert!((sphere.bottom_m[1] - sole.height_m).abs() < 1e-12);
                        assert!(
                            is_inside(&sole.outline_m, forward_and_right(sphere.bottom_m)),
                            "{animal} {count}"
                        );
                        assert!(sole.bodies.contains(&sphere.body));
                    }
                }
                for (right, left) in right.spheres.iter().zip(&left.spheres) {
                    assert_eq!(right.body.replace("_r", "_l"), left.body);
                    let image = right.centre_m * DVec3::new(1.0, 1.0, -1.0);
                    assert!(left.centre_m.abs_diff_eq(image, 1e-9), "{animal} {count}");
                }
            }
        }
    }
}

/// The heel's body is at a height of 0.93 - 0.06 - 0.40 - 0.46 m, and the lowest y in its mesh is 0.008 - 0.024 = -0.016 m.
/// - 0.40 - 0.46.
#[test]
fn the_plane_of_a_sole_is_below_the_lowest_point_by_the_pad() {
    let expected = -0.016 + (0.93 - 0.06 - 0.40 - 0.46) - 0.01;
    for sole in soles_of_fixture("human_40000.osim", HUMAN, 4) {
        assert!((sole.height_m - expected).abs() < 1e-12, "{}", sole.height_m);
    }
}

#[test]
fn a_human_stands_on_heel_toe_and_both_sides_of_the_forefoot() {
    let soles = soles_of_fixture("human_40000.osim", HUMAN, 4);
    let spheres: Vec<(&str, [f64; 2])> =
        soles[0].spheres.iter().map(|sphere| (&*sphere.body, forward_and_right(sphere.bottom_m))).collect();
    // In the order in which they are laid: toe tip, heel, outside, inside; the foot is 0.26 m long and turned out by 7 degrees.
    let bodies: Vec<&str> = spheres.iter().map(|(body, _)| *body).collect();
    assert_eq!(bodies, ["toes_r", "calcn_r", "toes_r", "calcn_r"]);
    let [toe, heel, outer, inner] = [0, 1, 2, 3].map(|index| spheres[index].1);
    assert!(toe[0] - heel[0] > 0.24);
    assert!(outer[1] - inner[1] > 0.07 && outer[0].min(inner[0]) > heel[0] + 0.15);
}

/// Bodies below a listed body belong to the same foot, in any order of the list. A body without a side is a foot of its own.
#[test]
fn bodies_are_grouped_into_feet() {
    let soles = soles_of_fixture("human_40000.osim", &["toes_l", "calcn_r", "toes_r", "calcn_l"], 2);
    let bodies: Vec<Vec<&str>> =
        soles.iter().map(|sole| sole.bodies.iter().map(String::as_str).collect()).collect();
    assert_eq!(bodies, [["toes_l", "calcn_l"], ["calcn_r", "toes_r"]]);
    let alone = soles_of_fixture("human_40000.osim", &["toes_r"], 2);
    assert_eq!((alone.len(), alone[0].side), (1, Some(Side::Right)));
}

/// The animal lies on its back: up is opposite to its usual direction.
#[test]
fn up_is_opposite_to_gravity() {
    let turned = text_of_model("human_40000.osim")
        .replace("<gravity>0 -9.8100000000000005 0</gravity>", "<gravity>0 9.81 0</gravity>");
    for sole in soles_in_text(&turned, HUMAN, 4).unwrap() {
        assert_eq!(sole.up, DVec3::NEG_Y);
        // Above what was the highest point of the foot.
        assert!(sole.spheres.iter().all(|sphere| (sphere.bottom_m[1] + sole.height_m).abs() < 1e-12));
        assert!(sole.spheres[0].bottom_m[1] > 0.05);
    }
    let sideways = text_of_model("human_40000.osim")
        .replace("<gravity>0 -9.8100000000000005 0</gravity>", "<gravity>0 0 -9.81</gravity>");
    for sole in soles_in_text(&sideways, HUMAN, 2).unwrap() {
        assert!(sole.spheres.iter().all(|sphere| (sphere.bottom_m[2] - sole.height_m).abs() < 1e-12));
    }
    let none = text_of_model("human_40000.osim")
        .replace("<gravity>0 -9.8100000000000005 0</gravity>", "<gravity>0 0 0</gravity>");
    assert_eq!(soles_in_text(&none, HUMAN, 4).unwrap_err(), FeetFault::NoGravity);
}

#[test]
fn requests_that_make_no_sense_are_refused() {
    let model = Model::parse(text_of_model("human_40000.osim")).unwrap();
    let bones = bones(&model, HUMAN, &MeshFolders::of_model(Path::new("m.osim")), &Folder).unwrap();
    let refused = |count, radius_m, pad_m| {
        soles(&model, &bones, &SoleRequest { count, radius_m, pad_m }).unwrap_err().to_string()
    };
    assert_eq!(refused(0, 0.03, 0.0), "number of spheres is 0, expected a whole number from 1 to 60");
    assert_eq!(refused(61, 0.03, 0.0), "number of spheres is 61, expected a whole number from 1 to 60");
    assert_eq!(refused(4, -0.03, 0.0), "radius is -0.03, expected a number above 0 m");
    assert_eq!(refused(4, 0.03, f64::NAN), "pad is NaN, expected a finite number of m");
}

/// On a bone of 3 mm, four spheres fit, five do not.
#[test]
fn bottoms_are_at_least_a_millimetre_apart() {
    let bone =
        "v 0 0 0\nv 0.003 0 0\nv 0.0015 0 0.001\nv 0.0015 0 -0.001\nv 0.0015 0 0.0005\nv 0.0015 0.01 0\n";
    let files = InMemory::from_iter([("r_human_foot.vtp", ""), ("r_human_foot.obj", bone)]);
    let model =
        Model::parse(text_of_model("human_40000.osim").replace("r_human_foot.vtp", "r_human_foot.obj"))
            .unwrap();
    let bones = bones(&model, &["calcn_r"], &MeshFolders::of_model(Path::new("m.osim")), &files).unwrap();
    let lay_spheres = |count| soles(&model, &bones, &SoleRequest { count, radius_m: 0.001, pad_m: 0.0 });
    assert_eq!(lay_spheres(4).unwrap()[0].spheres.len(), 4);
    assert_eq!(
        lay_spheres(5).unwrap_err().to_string(),
        "of 5 spheres under calcn_r some would be closer than 1 mm, expected at most 4: ask for fewer"
    );
}

/// Two toes of one foot are separate bodies, joined to a body of the same side without a mesh. The other foot is far away.
#[test]
fn toes_of_one_foot_are_one_foot() {
    let body = |name: &str| {
        format!(
            "<Body name=\"{name}\"><mass>1</mass><attached_geometry><Mesh><mesh_file>toe.obj</mesh_file></Mesh></attached_geometry></Body>"
        )
    };
    let joint = |parent: &str, child: &str, at: &str| {
        format!(
            "<WeldJoint name=\"{child}_joint\"><socket_parent_frame>p</socket_parent_frame><socket_child_frame>/bodyset/{child}\
             </socket_child_frame><frames><PhysicalOffsetFrame name=\"p\"><socket_parent>{parent}</socket_parent><translation>{at}\
             </translation></PhysicalOffsetFrame></frames></WeldJoint>"
        )
    };
    let names = ["pelvis", "tarsus_r", "toe1_r", "toe2_r", "tarsus_l", "toe1_l", "toe2_l"];
    let mut joints = joint("/ground", "pelvis", "0 1 0");
    for (side, z) in [("r", "0.2"), ("l", "-0.2")] {
        joints += &joint("/bodyset/pelvis", &format!("tarsus_{side}"), &format!("0 -0.9 {z}"));
        for (toe, z) in [("toe1", "0.02"), ("toe2", "-0.02")] {
            let tarsus = format!("/bodyset/tarsus_{side}");
            joints += &joint(&tarsus, &format!("{toe}_{side}"), &format!("0 -0.1 {z}"));
        }
    }
    let text = format!(
        "<OpenSimDocument Version=\"40000\"><Model><gravity>0 -9.81 0</gravity><BodySet><objects>{}</objects></BodySet><JointSet>\
         <objects>{joints}</objects></JointSet></Model></OpenSimDocument>",
        names.map(body).concat()
    );
    let files = InMemory::from_iter([("toe.obj", "v 0 0 0\nv 0.1 0 0.005\nv 0.1 0 -0.005\nv 0.05 0.02 0\n")]);
    let model = Model::parse(text).unwrap();
    let listed = ["toe1_r", "toe1_l", "toe2_r", "toe2_l"];
    let bones = bones(&model, &listed, &MeshFolders::of_model(Path::new("m.osim")), &files).unwrap();
    let soles = soles(&model, &bones, &SoleRequest { count: 4, radius_m: 0.01, pad_m: 0.002 }).unwrap();
    let feet: Vec<(Option<Side>, &[String])> = soles.iter().map(|sole| (sole.side, &*sole.bodies)).collect();
    let expected = [["toe1_r", "toe2_r"], ["toe1_l", "toe2_l"]].map(|names| names.map(str::to_owned));
    assert_eq!(feet, [(Some(Side::Right), &expected[0][..]), (Some(Side::Left), &expected[1][..])]);
    // Both toes carry some.
    assert!(expected[0].iter().all(|toe| soles[0].spheres.iter().any(|sphere| sphere.body == *toe)));
}

/// A box of 200 by 50 by 80 mm with points at each millimetre of its length and height, whose front is raised by 15 degrees. Points are
/// near the ground if they are lower than N, a tenth of the length seen from above: these are N/tan of the sole's length, and N tan of the
/// back, which leans to the rear.
#[test]
fn the_footprint_of_a_tilted_box_is_as_computed_by_hand() {
    let tilt = 15_f64.to_radians();
    let model = format!(
        "<OpenSimDocument Version=\"40000\"><Model><gravity>0 -9.81 0</gravity><BodySet><objects><Body name=\"foot\">\
         <mass>1</mass></Body></objects></BodySet><JointSet><objects><PinJoint name=\"ankle\"><socket_parent_frame>/ground\
         </socket_parent_frame><socket_child_frame>/bodyset/foot</socket_child_frame><coordinates>\
         <Coordinate name=\"ankle_angle\"><default_value>{tilt}</default_value></Coordinate></coordinates></PinJoint>\
         </objects></JointSet></Model></OpenSimDocument>"
    );
    let model = Model::parse(model).unwrap();
    let mut points = Vec::new();
    for side in [0.0, 0.08] {
        for along in 0..=200 {
            points.extend([0.0, 0.05].map(|up| [f64::from(along) * 1e-3, up, side]));
        }
        for up in 1..50 {
            points.extend([0.0, 0.2].map(|along| [along, f64::from(up) * 1e-3, side]));
        }
    }
    let bone = Bone::new("foot", "box.stl", points);
    let sole =
        soles(&model, &[bone], &SoleRequest { count: 1, radius_m: 0.03, pad_m: 0.0 }).unwrap().remove(0);
    let print = sole.footprint;
    let length = 0.2 * tilt.cos() + 0.05 * tilt.sin();
    let near = 0.1 * length;
    let covered = (near / tilt.tan() + near * tilt.tan()) / length;
    assert!((print.length_m - length).abs() < 1e-9, "{print:?}");
    // A point each millimetre.
    assert!(
        (print.share_of_length - covered).abs() < 0.01 && (print.share_of_width - 1.0).abs() < 1e-9,
        "{print:?} {covered}"
    );
    assert!((print.pitch_rad - tilt).abs() < 1e-6 && print.roll_rad.abs() < 1e-6, "{print:?}");
    assert!(!print.is_flat());
    let tilting: Vec<(String, f64)> =
        sole.tilting_coordinates(&model).into_iter().map(|one| (one.name, one.value)).collect();
    assert_eq!(tilting, [("ankle_angle".to_owned(), tilt)]);
    assert!(sole.describe_tilt().unwrap().contains("its front is 15.0 degrees up"));
}
