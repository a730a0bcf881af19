//! Scale factors of bodies with spheres, in models whose bones have other names or that are not scaled copies of the generic model.

use serde_json::{Value, json};

use super::{
    CALL_OF_TRANSFER, assert_close, assert_close_place, assert_refused, assert_stderr_has, dry_run_plan,
    finding_codes, generic_and_scaled, parse_json, planned_value, replace_in_file, set_mesh_factors,
};
use crate::support::{TestDir, corpus_folder};

/// The place of the heel sphere after scaling by (1.02, 0.9, 0.95), the factors of the foot in the fixture.
const SCALED_HEEL_PLACE: [f64; 3] = [-0.0102, -0.036, 0.00475];
/// The distance from the origin of calcn_r to the joint of its toes, scaled over generic:
/// |(0.1734, -0.0108, 0.0019)| / |(0.17, -0.012, 0.002)|, with 30 digits by Python's decimal.
const RATIO_OF_FOOT_LENGTHS: f64 = 1.019_430_647_983_430_4;

/// The distance from `calcn_r` to `mtp_r` in D'Hondt's model over that in Falisse's. In D'Hondt's model two welded bodies are between
/// them, and the offsets add up to (0.162178658, -0.003036671, 0.001099361) m.
const RATIO_OF_DHONDT_TO_FALISSE: f64 = 0.992_583_223_313_156_7;

/// Moves the knee in the scaled model to a place that no scale factor of the thigh explains within a millimetre.
fn move_knee(dir: &TestDir) {
    replace_in_file(
        dir,
        "scaled.osim",
        "0.0038 -0.37200000000000005 0.0028500000000000001",
        "-0 -0.38 0.0028500000000000001",
    );
}

fn remarks_of_report(report: &Value) -> String {
    report["remarks"].to_string()
}

fn findings_of_report(report: &Value) -> String {
    report["findings"].to_string()
}

fn body_factors(inspection: &Value, body: &str) -> Value {
    let all = inspection["body_factors"].as_array().unwrap().iter();
    let foot = all.clone().find(|foot| foot["body"] == body);
    foot.unwrap_or_else(|| panic!("no factors of {body}")).clone()
}

#[test]
fn a_moved_joint_of_a_body_without_spheres_is_only_a_warning() {
    let dir = generic_and_scaled("smooth");
    assert!(!finding_codes(&dry_run_plan(&dir, "--radius follow")).contains(&"not-a-scaled-copy"));
    // A factor of -0 along x: SCONE's femurs against Falisse's.
    move_knee(&dir);
    let report = dry_run_plan(&dir, "--radius follow");
    assert!(finding_codes(&report).contains(&"not-a-scaled-copy"), "{}", findings_of_report(&report));
    assert!(
        findings_of_report(&report).contains("joint tibia_r_joint is at x = 0.00000 m on femur_r"),
        "{}",
        findings_of_report(&report)
    );
    // The meshes still give the factors of the feet.
    assert_close_place(&planned_value(&report, "heel_r", "location"), SCALED_HEEL_PLACE);
    assert_close(&planned_value(&report, "heel_r", "radius"), 0.030_573_048_163_784_02);
    dir.run("inspect scaled.osim --from generic.osim").succeeded().says(&["not-a-scaled-copy"]);
}

#[test]
fn meshes_of_one_bone_match_under_other_names() {
    let dir = generic_and_scaled("smooth");
    replace_in_file(&dir, "scaled.osim", ">toes_r.vtp<", ">Geometry/R_Toes.VTP<");
    replace_in_file(&dir, "scaled.osim", ">toes_l.vtp<", ">toes_lv.stl<");
    replace_in_file(&dir, "generic.osim", ">toes_l.vtp<", ">bones/toes.obj<");
    let report = dry_run_plan(&dir, "--radius follow");
    assert!(
        !finding_codes(&report).contains(&"not-a-scaled-copy")
            && !finding_codes(&report).contains(&"factors-disagree")
    );
    assert_close(&planned_value(&report, "toe_r", "radius"), 0.030_573_048_163_784_02);
    assert_close(&planned_value(&report, "toe_l", "radius"), 0.030_573_048_163_784_02);
}

#[test]
fn different_factors_of_meshes_on_one_body_are_refused() {
    let dir = generic_and_scaled("smooth");
    for (name, factors) in [("generic.osim", "1 1 1"), ("scaled.osim", "1.1 0.9 0.95")] {
        let mesh = format!(
            "<Mesh name=\"more\"><scale_factors>{factors}</scale_factors><mesh_file>talus.vtp</mesh_file></Mesh>"
        );
        replace_in_file(
            &dir,
            name,
            "<Mesh name=\"calcn_r_geom_1\">",
            &format!("{mesh}<Mesh name=\"calcn_r_geom_1\">"),
        );
    }
    let words = [
        "calcn_r.vtp gives 1.0200, 0.9000, 0.9500",
        "talus.vtp gives 1.1000",
        "--body-scale calcn_r=x,y,z",
        "[body-scale]",
    ];
    assert_refused(&dir, CALL_OF_TRANSFER, &words);
    // The answer, with one factor for all axes.
    let report = dry_run_plan(&dir, "--radius follow --body-scale calcn_r=1.5");
    assert_close_place(&planned_value(&report, "heel_r", "location"), [-0.015, -0.06, 0.0075]);
    // Meshes of a body without spheres cause no question.
    let other = generic_and_scaled("smooth");
    for (name, factors) in [("generic.osim", "1 1 1"), ("scaled.osim", "1.1 0.9 0.95")] {
        let mesh = format!(
            "<Mesh name=\"more\"><scale_factors>{factors}</scale_factors><mesh_file>patella.vtp</mesh_file></Mesh>"
        );
        replace_in_file(
            &other,
            name,
            "<Mesh name=\"femur_r_geom_1\">",
            &format!("{mesh}<Mesh name=\"femur_r_geom_1\">"),
        );
    }
    assert_close_place(
        &planned_value(&dry_run_plan(&other, "--radius follow"), "heel_r", "location"),
        SCALED_HEEL_PLACE,
    );
}

#[test]
fn both_sides_use_the_same_source_of_factors() {
    let dir = generic_and_scaled("smooth");
    move_knee(&dir);
    // Only the left foot still has a mesh in common: both feet use the distance to their toes.
    replace_in_file(&dir, "scaled.osim", ">calcn_r.vtp<", ">hoof.vtp<");
    let inspection =
        parse_json(&dir.run("inspect scaled.osim --from generic.osim --format json").succeeded());
    for body in ["calcn_r", "calcn_l"] {
        let factors = body_factors(&inspection, body);
        assert_eq!(factors["sources"], json!(["joint distance", "joint distance", "joint distance"]));
        for axis in factors["factors"].as_array().unwrap() {
            assert_close(axis, RATIO_OF_FOOT_LENGTHS);
        }
    }
    let report = dry_run_plan(&dir, "--radius follow");
    assert_close_place(
        &planned_value(&report, "heel_r", "location"),
        [-0.01 * RATIO_OF_FOOT_LENGTHS, -0.04 * RATIO_OF_FOOT_LENGTHS, 0.005 * RATIO_OF_FOOT_LENGTHS],
    );
    // In a scaled copy both use joint offsets, axis by axis.
    let scaled_copy = generic_and_scaled("smooth");
    replace_in_file(&scaled_copy, "scaled.osim", ">calcn_r.vtp<", ">hoof.vtp<");
    let inspection =
        parse_json(&scaled_copy.run("inspect scaled.osim --from generic.osim --format json").succeeded());
    for body in ["calcn_r", "calcn_l"] {
        assert_eq!(
            body_factors(&inspection, body)["sources"],
            json!(["joint offset", "joint offset", "joint offset"])
        );
    }
}

#[test]
fn the_last_body_gets_the_factors_of_its_parent() {
    let dir = generic_and_scaled("smooth");
    move_knee(&dir);
    replace_in_file(&dir, "scaled.osim", ">toes_r.vtp<", ">hoof.vtp<");
    let report = dry_run_plan(&dir, "--radius follow");
    for (body, foot) in [("toes_r", "calcn_r"), ("toes_l", "calcn_l")] {
        let remark = format!("{body} takes the factors of {foot}, its parent body: 1.0200, 0.9000, 0.9500");
        assert!(remarks_of_report(&report).contains(&remark), "{}", remarks_of_report(&report));
    }
    assert_close(&planned_value(&report, "toe_r", "radius"), 0.030_573_048_163_784_02);
    let inspection =
        parse_json(&dir.run("inspect scaled.osim --from generic.osim --format json").succeeded());
    assert_eq!(
        body_factors(&inspection, "toes_l")["sources"],
        json!(["body above", "body above", "body above"])
    );
}

#[test]
fn different_factors_left_and_right_are_refused() {
    let dir = generic_and_scaled("smooth");
    move_knee(&dir);
    set_mesh_factors(&dir, "scaled.osim", "calcn_l", "1.1009 0.9 0.969");
    // 1.09 along x against 1.02: 6.9 %.
    assert_refused(
        &dir,
        CALL_OF_TRANSFER,
        &[
            "calcn_r 1.0200, 0.9000, 0.9500",
            "calcn_l 1.0900, 0.9000, 0.9500",
            "--body-scale calcn_r=x,y,z",
            "[body-scale]",
        ],
    );
    dry_run_plan(&dir, "--radius follow --body-scale calcn_l=1.02,0.9,0.95");
    // A difference of 4.9 % is accepted.
    set_mesh_factors(&dir, "scaled.osim", "calcn_l", "1.0807 0.9 0.969");
    dry_run_plan(&dir, "--radius follow");
    // A scaled copy may have different sides: mesh and joint of the left foot both give exactly 1.09.
    let scaled_copy = generic_and_scaled("smooth");
    set_mesh_factors(&scaled_copy, "scaled.osim", "calcn_l", "1.1009 0.9 0.969");
    replace_in_file(
        &scaled_copy,
        "scaled.osim",
        "0.17340000000000003 -0.010800000000000001 -0.0019",
        "0.1853 -0.0108 -0.0019",
    );
    let report = dry_run_plan(&scaled_copy, "--radius follow");
    assert!(!finding_codes(&report).contains(&"not-a-scaled-copy"), "{}", findings_of_report(&report));
    assert_close_place(&planned_value(&report, "heel_l", "location"), [-0.0109, -0.036, -0.00475]);
    assert_close_place(&planned_value(&report, "heel_r", "location"), SCALED_HEEL_PLACE);
}

#[test]
fn disagreeing_sources_are_reported_with_both_values() {
    let dir = generic_and_scaled("smooth");
    move_knee(&dir);
    for body in ["calcn_r", "calcn_l"] {
        // 1.2 along x where the joints say 1.02: Moco's 3D walking model, whose joints were never scaled.
        set_mesh_factors(&dir, "scaled.osim", body, "1.212 0.9 0.969");
    }
    let report = dry_run_plan(&dir, "--radius follow");
    let text = findings_of_report(&report);
    for body in ["calcn_r", "calcn_l"] {
        assert!(text.contains(&format!("body {body}: mesh gives 1.19")), "{text}");
    }
    assert!(text.contains("but the distance is 1.019 of the reference's; the first was used"), "{text}");
    assert_close_place(&planned_value(&report, "heel_r", "location"), [-0.012, -0.036, 0.00475]);
    // A difference of 4 % from the joint is no disagreement.
    for body in ["calcn_r", "calcn_l"] {
        set_mesh_factors(&dir, "scaled.osim", body, "1.0706 0.9 0.969");
    }
    assert!(!finding_codes(&dry_run_plan(&dir, "--radius follow")).contains(&"factors-disagree"));
}

#[test]
fn a_mesh_of_another_animal_with_the_same_name_is_refused() {
    let dir = generic_and_scaled("smooth");
    move_knee(&dir);
    // 1.0194 by the joint of the toes. The reference's mesh is at 1.01: 2.101 of it is 2.08 times, more than twice that; 2.02 is not.
    for (factors, asks) in [("2.101 1.854 1.957", true), ("2.02 1.8 1.9", false)] {
        for body in ["calcn_r", "calcn_l"] {
            set_mesh_factors(&dir, "scaled.osim", body, factors);
        }
        let words =
            ["mesh of body calcn_r", "toes_r_joint", "another animal's bone", "--body-scale calcn_r=x,y,z"];
        if asks {
            assert_refused(&dir, CALL_OF_TRANSFER, &words);
        } else {
            assert!(
                findings_of_report(&dry_run_plan(&dir, "--radius follow")).contains("the first was used")
            );
        }
    }
}

#[test]
fn a_joint_near_the_origin_gives_no_factor() {
    let dir = generic_and_scaled("smooth");
    move_knee(&dir);
    for name in ["generic.osim", "scaled.osim"] {
        replace_in_file(&dir, name, "<Mesh name=", "<Brick name=");
        replace_in_file(&dir, name, "</Mesh>", "</Brick>");
    }
    // 170 mm: the distance counts, and the toes hang on it.
    assert_close(
        &planned_value(&dry_run_plan(&dir, "--radius follow"), "toe_l", "radius"),
        0.032 * RATIO_OF_FOOT_LENGTHS,
    );
    for (name, from) in [("generic.osim", "0.17000000000000001 "), ("scaled.osim", "0.17340000000000003 ")] {
        replace_in_file(&dir, name, from, "0.0149 ");
    }
    // |(0.0149, 0.012, 0.002)| is 19.2 mm.
    assert_refused(
        &dir,
        CALL_OF_TRANSFER,
        &["calcn_r", "20 mm", "--body-scale calcn_r=x,y,z", "[body-scale]"],
    );
}

#[test]
fn a_scale_set_of_another_model_is_refused() {
    let dir = generic_and_scaled("smooth");
    let call = format!("{CALL_OF_TRANSFER} --body-scale-file applied.xml");
    dir.run(&format!("{call} --dry-run")).succeeded();
    // Another generic model: its feet were longer, so that they were scaled by 0.867 along x and not by 1.02.
    replace_in_file(&dir, "generic.osim", "0.17000000000000001 ", "0.2 ");
    assert_refused(
        &dir,
        &call,
        &["toes_r_joint on calcn_r", "--body-scale-file", "another model than the reference", "[body-scale]"],
    );
}

#[test]
fn remarks_about_different_models_match_the_snapshot() {
    let dir = generic_and_scaled("smooth");
    move_knee(&dir);
    replace_in_file(&dir, "scaled.osim", ">toes_r.vtp<", ">hoof.vtp<");
    dir.run(&format!("{CALL_OF_TRANSFER} --dry-run")).succeeded().matches_snapshot("follow_different");
}

/// Compares published models with Falisse's model, although they are not scaled copies of it.
#[test]
fn published_models_that_are_not_copies_get_factors() {
    let Some(folder) = corpus_folder("published_models_that_are_not_copies_get_factors") else { return };
    let dir = TestDir::new();
    let inspection = |model: &str| {
        dir.write("falisse.osim", std::fs::read(folder.join("v40000_falisse_2022_human.osim")).unwrap());
        dir.write("model.osim", std::fs::read(folder.join(format!("{model}.osim"))).unwrap());
        let run = dir.run("inspect model.osim --from falisse.osim --format json").succeeded();
        assert_stderr_has(&run, &[]);
        parse_json(&run)
    };
    let moco = inspection("v40600_moco_3d_walking_model_without_contacts");
    assert!(finding_codes(&moco).contains(&"not-a-scaled-copy"));
    // Mesh factors of Moco's feet (r_foot.vtp, l_foot.vtp) over 0.913924 of Falisse's (foot.vtp, l_foot.vtp).
    let base = 0.913_924_377_931_762_4;
    for body in ["calcn_r", "calcn_l"] {
        let foot = body_factors(&moco, body);
        for (axis, expected) in [1.155_608_663, 1.117_084_823_9, 1.305_252_785_8].into_iter().enumerate() {
            assert_close(&foot["factors"][axis], expected / base);
        }
        assert_eq!(foot["sources"][0], "mesh");
        let remark = format!("body {body}: mesh gives 1.264");
        assert!(
            findings_of_report(&moco).contains(&remark) && findings_of_report(&moco).contains("1.094"),
            "{}",
            findings_of_report(&moco)
        );
    }
    // SCONE's one-piece foot shows foot.vtp at its full size, among other bones.
    for model in ["v30000_scone_h0914m", "v40000_scone_h0914m"] {
        let scone = inspection(model);
        for body in ["calcn_r", "calcn_l"] {
            assert_close(&body_factors(&scone, body)["factors"][0], 1.0 / base);
        }
    }
    // D'Hondt's calcn has bones of other names.
    let dhondt = inspection("v40000_dhondt_2024_3seg_human");
    for body in ["calcn_r", "calcn_l"] {
        let foot = body_factors(&dhondt, body);
        assert_eq!(foot["sources"][0], "joint distance");
        assert!((foot["factors"][0].as_f64().unwrap() - RATIO_OF_DHONDT_TO_FALISSE).abs() < 1e-12, "{foot}");
    }
}
