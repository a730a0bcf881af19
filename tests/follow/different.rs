//! Factors where it matters: bodies that carry spheres, bones of other names, and models that are not scaled copies.

use serde_json::{Value, json};

use super::{
    CALL, bench, close, close_place, codes, edit, json as read, plan, planned, refuses, says, set_mesh,
};
use crate::support::{Bench, corpus};

/// Where the heel goes by (1.02, 0.9, 0.95), the factors of the foot in the fixture.
const HEEL: [f64; 3] = [-0.0102, -0.036, 0.00475];
/// The distance from the origin of calcn_r to the joint of its toes, scaled over generic:
/// |(0.1734, -0.0108, 0.0019)| / |(0.17, -0.012, 0.002)|, with 30 digits by Python's decimal.
const DISTANCE: f64 = 1.019_430_647_983_430_4;

/// The same from D'Hondt's calcn_r to mtp_r, through two welded bodies, over Falisse's: the offsets add up to
/// (0.162178658, -0.003036671, 0.001099361) m.
const DHONDT: f64 = 0.992_583_223_313_156_7;

/// A knee that was moved in the scaled model: no factor of the thigh explains where it is, to its last millimetre.
fn move_knee(bench: &Bench) {
    edit(
        bench,
        "scaled.osim",
        "0.0038 -0.37200000000000005 0.0028500000000000001",
        "-0 -0.38 0.0028500000000000001",
    );
}

fn remarks(report: &Value) -> String {
    report["remarks"].to_string()
}

fn warnings(report: &Value) -> String {
    report["warnings"].to_string()
}

fn factors(seen: &Value, body: &str) -> Value {
    let all = seen["body_factors"].as_array().unwrap().iter();
    let found = all.clone().find(|found| found["body"] == body);
    found.unwrap_or_else(|| panic!("no factors of {body}")).clone()
}

#[test]
fn a_body_without_spheres_stops_nothing() {
    let bench = bench("smooth");
    assert!(!codes(&plan(&bench, "")).contains(&"not-a-scaled-copy"));
    // A factor of -0 along x: SCONE's femurs against Falisse's.
    move_knee(&bench);
    let report = plan(&bench, "");
    assert!(codes(&report).contains(&"not-a-scaled-copy"), "{}", warnings(&report));
    assert!(
        warnings(&report).contains("joint tibia_r_joint is at x = 0.00000 m on femur_r"),
        "{}",
        warnings(&report)
    );
    // The feet are as they were: their meshes say it.
    close_place(&planned(&report, "heel_r", "location"), HEEL);
    close(&planned(&report, "heel_r", "radius"), 0.030_573_048_163_784_02);
    bench.run("inspect scaled.osim --from generic.osim").done().says(&["not-a-scaled-copy"]);
}

#[test]
fn meshes_of_one_bone_are_found_under_its_other_names() {
    let bench = bench("smooth");
    edit(&bench, "scaled.osim", ">toes_r.vtp<", ">Geometry/R_Toes.VTP<");
    edit(&bench, "scaled.osim", ">toes_l.vtp<", ">toes_lv.stl<");
    edit(&bench, "generic.osim", ">toes_l.vtp<", ">bones/toes.obj<");
    let report = plan(&bench, "");
    assert!(!codes(&report).contains(&"not-a-scaled-copy") && !codes(&report).contains(&"factors-disagree"));
    close(&planned(&report, "toe_r", "radius"), 0.030_573_048_163_784_02);
    close(&planned(&report, "toe_l", "radius"), 0.030_573_048_163_784_02);
}

#[test]
fn meshes_of_one_body_that_differ_are_asked_about() {
    let bench = bench("smooth");
    for (name, factors) in [("generic.osim", "1 1 1"), ("scaled.osim", "1.1 0.9 0.95")] {
        let more = format!(
            "<Mesh name=\"more\"><scale_factors>{factors}</scale_factors><mesh_file>talus.vtp</mesh_file></Mesh>"
        );
        edit(
            &bench,
            name,
            "<Mesh name=\"calcn_r_geom_1\">",
            &format!("{more}<Mesh name=\"calcn_r_geom_1\">"),
        );
    }
    let words = [
        "calcn_r.vtp says 1.0200, 0.9000, 0.9500",
        "talus.vtp says 1.1000",
        "--body-scale calcn_r=x,y,z",
        "[body-scale]",
    ];
    refuses(&bench, CALL, &words);
    // The answer, with one factor for all axes.
    let report = plan(&bench, "--body-scale calcn_r=1.5");
    close_place(&planned(&report, "heel_r", "location"), [-0.015, -0.06, 0.0075]);
    // Another body's meshes are nobody's question.
    let other = super::bench("smooth");
    for (name, factors) in [("generic.osim", "1 1 1"), ("scaled.osim", "1.1 0.9 0.95")] {
        let more = format!(
            "<Mesh name=\"more\"><scale_factors>{factors}</scale_factors><mesh_file>patella.vtp</mesh_file></Mesh>"
        );
        edit(
            &other,
            name,
            "<Mesh name=\"femur_r_geom_1\">",
            &format!("{more}<Mesh name=\"femur_r_geom_1\">"),
        );
    }
    close_place(&planned(&plan(&other, ""), "heel_r", "location"), HEEL);
}

#[test]
fn both_sides_take_the_same_source() {
    let bench = bench("smooth");
    move_knee(&bench);
    // The right foot has no mesh in common any more, the left one has: both take the distance to their toes.
    edit(&bench, "scaled.osim", ">calcn_r.vtp<", ">hoof.vtp<");
    let seen = read(&bench.run("inspect scaled.osim --from generic.osim --format json").done());
    for body in ["calcn_r", "calcn_l"] {
        let factors = factors(&seen, body);
        assert_eq!(factors["sources"], json!(["joint distance", "joint distance", "joint distance"]));
        for axis in factors["factors"].as_array().unwrap() {
            close(axis, DISTANCE);
        }
    }
    let report = plan(&bench, "");
    close_place(
        &planned(&report, "heel_r", "location"),
        [-0.01 * DISTANCE, -0.04 * DISTANCE, 0.005 * DISTANCE],
    );
    // In a scaled copy too, axis by axis: offsets say what meshes say there.
    let copy = super::bench("smooth");
    edit(&copy, "scaled.osim", ">calcn_r.vtp<", ">hoof.vtp<");
    let seen = read(&copy.run("inspect scaled.osim --from generic.osim --format json").done());
    for body in ["calcn_r", "calcn_l"] {
        assert_eq!(factors(&seen, body)["sources"], json!(["joint offset", "joint offset", "joint offset"]));
    }
}

#[test]
fn the_last_body_takes_the_factors_of_the_one_it_hangs_on() {
    let bench = bench("smooth");
    move_knee(&bench);
    edit(&bench, "scaled.osim", ">toes_r.vtp<", ">hoof.vtp<");
    let report = plan(&bench, "");
    for (body, foot) in [("toes_r", "calcn_r"), ("toes_l", "calcn_l")] {
        let told = format!("{body} takes the factors of {foot}, on which it hangs: 1.0200, 0.9000, 0.9500");
        assert!(remarks(&report).contains(&told), "{}", remarks(&report));
    }
    close(&planned(&report, "toe_r", "radius"), 0.030_573_048_163_784_02);
    let seen = read(&bench.run("inspect scaled.osim --from generic.osim --format json").done());
    assert_eq!(factors(&seen, "toes_l")["sources"], json!(["body above", "body above", "body above"]));
}

#[test]
fn left_and_right_that_differ_are_asked_about() {
    let bench = bench("smooth");
    move_knee(&bench);
    set_mesh(&bench, "scaled.osim", "calcn_l", "1.1009 0.9 0.969");
    // 1.09 along x against 1.02: 6.9 %.
    refuses(
        &bench,
        CALL,
        &[
            "calcn_r 1.0200, 0.9000, 0.9500",
            "calcn_l 1.0900, 0.9000, 0.9500",
            "--body-scale calcn_r=x,y,z",
            "[body-scale]",
        ],
    );
    plan(&bench, "--body-scale calcn_l=1.02,0.9,0.95");
    // 4.9 % is what people are.
    set_mesh(&bench, "scaled.osim", "calcn_l", "1.0807 0.9 0.969");
    plan(&bench, "");
    // A scaled copy may have sides of its own: mesh and joint of the left foot say 1.09, exactly.
    let copy = super::bench("smooth");
    set_mesh(&copy, "scaled.osim", "calcn_l", "1.1009 0.9 0.969");
    edit(&copy, "scaled.osim", "0.17340000000000003 -0.010800000000000001 -0.0019", "0.1853 -0.0108 -0.0019");
    let report = plan(&copy, "");
    assert!(!codes(&report).contains(&"not-a-scaled-copy"), "{}", warnings(&report));
    close_place(&planned(&report, "heel_l", "location"), [-0.0109, -0.036, -0.00475]);
    close_place(&planned(&report, "heel_r", "location"), HEEL);
}

#[test]
fn sources_that_disagree_between_different_models_are_told_with_both_values() {
    let bench = bench("smooth");
    move_knee(&bench);
    for body in ["calcn_r", "calcn_l"] {
        // 1.2 along x where the joints say 1.02: Moco's 3D walking model, whose joints were never scaled.
        set_mesh(&bench, "scaled.osim", body, "1.212 0.9 0.969");
    }
    let report = plan(&bench, "");
    let said = warnings(&report);
    for body in ["calcn_r", "calcn_l"] {
        assert!(said.contains(&format!("body {body}: mesh says 1.19")), "{said}");
    }
    assert!(said.contains("but the distance is 1.019431 of the reference's; took the first"), "{said}");
    close_place(&planned(&report, "heel_r", "location"), [-0.012, -0.036, 0.00475]);
    // 4 % more than the joint's is no disagreement.
    for body in ["calcn_r", "calcn_l"] {
        set_mesh(&bench, "scaled.osim", body, "1.0706 0.9 0.969");
    }
    assert!(!codes(&plan(&bench, "")).contains(&"factors-disagree"));
}

#[test]
fn a_bone_of_another_animal_in_a_mesh_of_the_same_name_is_asked_about() {
    let bench = bench("smooth");
    move_knee(&bench);
    // 1.0194 by the joint of the toes. The reference's mesh is at 1.01: 2.101 of it is 2.08 times, more than twice that; 2.02 is not.
    for (factors, asks) in [("2.101 1.854 1.957", true), ("2.02 1.8 1.9", false)] {
        for body in ["calcn_r", "calcn_l"] {
            set_mesh(&bench, "scaled.osim", body, factors);
        }
        let words =
            ["mesh of body calcn_r", "toes_r_joint", "another animal's bone", "--body-scale calcn_r=x,y,z"];
        if asks {
            refuses(&bench, CALL, &words);
        } else {
            assert!(warnings(&plan(&bench, "")).contains("took the first"));
        }
    }
}

#[test]
fn a_joint_near_the_origin_says_nothing() {
    let bench = bench("smooth");
    move_knee(&bench);
    for name in ["generic.osim", "scaled.osim"] {
        edit(&bench, name, "<Mesh name=", "<Brick name=");
        edit(&bench, name, "</Mesh>", "</Brick>");
    }
    // 170 mm: the distance counts, and the toes hang on it.
    close(&planned(&plan(&bench, ""), "toe_l", "radius"), 0.032 * DISTANCE);
    for (name, from) in [("generic.osim", "0.17000000000000001 "), ("scaled.osim", "0.17340000000000003 ")] {
        edit(&bench, name, from, "0.0149 ");
    }
    // |(0.0149, 0.012, 0.002)| is 19.2 mm.
    refuses(&bench, CALL, &["calcn_r", "20 mm", "--body-scale calcn_r=x,y,z", "[body-scale]"]);
}

#[test]
fn a_scale_set_counts_only_for_the_model_that_it_was_applied_to() {
    let bench = bench("smooth");
    let call = format!("{CALL} --body-scale-file applied.xml");
    bench.run(&format!("{call} --dry-run")).done();
    // Another generic model: its feet were longer, so that they were scaled by 0.867 along x and not by 1.02.
    edit(&bench, "generic.osim", "0.17000000000000001 ", "0.2 ");
    refuses(
        &bench,
        &call,
        &["toes_r_joint on calcn_r", "--body-scale-file", "another model than the reference", "[body-scale]"],
    );
}

#[test]
fn what_is_said_of_different_models() {
    let bench = bench("smooth");
    move_knee(&bench);
    edit(&bench, "scaled.osim", ">toes_r.vtp<", ">hoof.vtp<");
    bench.run(&format!("{CALL} --dry-run")).done().looks_like("follow_different");
}

/// Models of other people against Falisse's: what no scaled copy can say.
#[test]
fn real_models_that_are_no_copies() {
    let Some(folder) = corpus("real_models_that_are_no_copies") else { return };
    let bench = Bench::new();
    let seen = |model: &str| {
        bench.write("falisse.osim", std::fs::read(folder.join("v40000_falisse_2022_human.osim")).unwrap());
        bench.write("model.osim", std::fs::read(folder.join(format!("{model}.osim"))).unwrap());
        let ran = bench.run("inspect model.osim --from falisse.osim --format json").done();
        says(&ran, &[]);
        read(&ran)
    };
    let moco = seen("v40600_moco_3d_walking_model_without_contacts");
    assert!(codes(&moco).contains(&"not-a-scaled-copy"));
    // Mesh factors of Moco's feet (r_foot.vtp, l_foot.vtp) over 0.913924 of Falisse's (foot.vtp, l_foot.vtp).
    let base = 0.913_924_377_931_762_4;
    for body in ["calcn_r", "calcn_l"] {
        let found = factors(&moco, body);
        for (axis, expected) in [1.155_608_663, 1.117_084_823_9, 1.305_252_785_8].into_iter().enumerate() {
            close(&found["factors"][axis], expected / base);
        }
        assert_eq!(found["sources"][0], "mesh");
        let told = format!("body {body}: mesh says 1.264");
        assert!(warnings(&moco).contains(&told) && warnings(&moco).contains("1.094"), "{}", warnings(&moco));
    }
    // SCONE's one-piece foot shows foot.vtp at its full size, among other bones.
    for model in ["v30000_scone_h0914m", "v40000_scone_h0914m"] {
        let scone = seen(model);
        for body in ["calcn_r", "calcn_l"] {
            close(&factors(&scone, body)["factors"][0], 1.0 / base);
        }
    }
    // D'Hondt's calcn has bones of other names.
    let dhondt = seen("v40000_dhondt_2024_3seg_human");
    for body in ["calcn_r", "calcn_l"] {
        let found = factors(&dhondt, body);
        assert_eq!(found["sources"][0], "joint distance");
        assert!((found["factors"][0].as_f64().unwrap() - DHONDT).abs() < 1e-12, "{found}");
    }
}
