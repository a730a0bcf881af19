//! Contacts that follow bodies after OpenSim scaled the bodies (`transfer --follow-bodies`, `inspect --from`).
//!
//! Expected numbers are literals computed by a few lines of Python from the rule and from c' = RᵀSR (c − R e) + R' e; the real
//! OpenSim judges the same models in `tests/oracle/test_follow.py`.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stderr,
    dead_code,
    reason = "a test fails by panicking; the shared support has more than this file uses"
)]

#[path = "follow/different_models.rs"]
mod different_models;
#[path = "follow/matching_spheres.rs"]
mod matching_spheres;
#[path = "follow/numbers.rs"]
mod numbers;
#[path = "command/support.rs"]
mod support;

use serde_json::Value;
use support::{CommandRun, TestDir};

const ROUNDING_ERROR: f64 = 1e-12;
const CALL_OF_TRANSFER: &str = "transfer scaled.osim --from generic.osim --follow-bodies";

/// The generic and the scaled model of the fixtures, with contacts of one class.
fn generic_and_scaled(kind: &str) -> TestDir {
    TestDir::with(&[
        (&format!("scale_tool/generic_{kind}.osim"), "generic.osim"),
        (&format!("scale_tool/scaled_{kind}.osim"), "scaled.osim"),
        ("scale_tool/applied_scale_set.xml", "applied.xml"),
    ])
}

/// Replaces every `from` in a file of the folder by `to`. The file must contain `from`.
#[track_caller]
fn replace_in_file(dir: &TestDir, name: &str, from: &str, to: &str) {
    let text = dir.text(name);
    assert!(text.contains(from), "{name} has no {from}");
    dir.write(name, text.replace(from, to));
}

/// Changes the scale factors of the mesh of one body.
#[track_caller]
fn set_mesh_factors(dir: &TestDir, name: &str, body: &str, factors: &str) {
    let text = dir.text(name);
    let mesh = text.find(&format!("<Mesh name=\"{body}_geom_1\">")).expect("the body has a mesh");
    let start = mesh + text[mesh..].find("<scale_factors>").unwrap() + "<scale_factors>".len();
    let end = start + text[start..].find('<').unwrap();
    dir.write(name, format!("{}{factors}{}", &text[..start], &text[end..]));
}

/// Removes the meshes and their scale factors from both models.
fn remove_meshes(dir: &TestDir) {
    for name in ["generic.osim", "scaled.osim"] {
        replace_in_file(dir, name, "<Mesh name=", "<Brick name=");
        replace_in_file(dir, name, "</Mesh>", "</Brick>");
    }
}

/// Asserts that the call is refused with a message that has all of `words`, and writes nothing.
#[track_caller]
fn assert_refused(dir: &TestDir, call: &str, words: &[&str]) {
    let run = dir.run(call).failed();
    assert!(run.changed.is_empty(), "written: {:?}", run.changed);
    let (codes, words): (Vec<&str>, Vec<&str>) = words.iter().partition(|word| word.starts_with('['));
    assert_stderr_has(&run, &words);
    for code in codes {
        let report = parse_json(&dir.run(&format!("{call} --format json")).failed());
        assert_eq!(format!("[{}]", report["error"]["code"].as_str().unwrap()), code);
    }
}

#[track_caller]
fn assert_stderr_has(run: &CommandRun, words: &[&str]) {
    for word in words {
        assert!(run.err().contains(word), "no '{word}' in {}", run.err());
    }
}

fn parse_json(run: &CommandRun) -> Value {
    serde_json::from_str(&run.out()).unwrap()
}

/// The new value in the plan of a dry run for `property` of the force or sphere whose path ends with `name`.
#[track_caller]
fn planned_value(report: &Value, name: &str, property: &str) -> Value {
    let changes = report["changes"].as_array().unwrap();
    let change = changes.iter().find(|change| {
        change["property"] == property && change["path"].as_str().unwrap().ends_with(&format!("/{name}"))
    });
    change.unwrap_or_else(|| panic!("no {property} of {name}"))["to"].clone()
}

#[track_caller]
fn assert_close(value: &Value, expected: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - expected).abs() <= ROUNDING_ERROR * expected.abs(), "{value} is not {expected}");
}

#[track_caller]
fn assert_close_place(value: &Value, expected: [f64; 3]) {
    for (value, expected) in value.as_array().unwrap().iter().zip(expected) {
        assert!((value.as_f64().unwrap() - expected).abs() <= 1e-15, "{value} is not {expected}");
    }
}

/// The plan of a dry run of the transfer with more `options`.
fn dry_run_plan(dir: &TestDir, options: &str) -> Value {
    parse_json(&dir.run(&format!("{CALL_OF_TRANSFER} --dry-run --format json {options}")).succeeded())
}

fn finding_codes(report: &Value) -> Vec<&str> {
    report["findings"].as_array().unwrap().iter().map(|finding| finding["code"].as_str().unwrap()).collect()
}

// Factors.

#[test]
fn factors_that_are_not_positive_numbers_are_refused() {
    for bad in ["0", "-1", "nan", "inf"] {
        let dir = generic_and_scaled("smooth");
        let run = dir.run(&format!("{CALL_OF_TRANSFER} --body-scale calcn_r=1,{bad},1")).usage_error();
        assert!(run.changed.is_empty());
        assert_stderr_has(&run, &["--body-scale", "calcn_r"]);
    }
    for bad in ["0", "-0.9", "NaN", "inf", "1e400"] {
        let file = generic_and_scaled("smooth");
        replace_in_file(&file, "applied.xml", " 1.02 0.9 0.95", &format!(" 1.02 {bad} 0.95"));
        assert_refused(&file, &format!("{CALL_OF_TRANSFER} --body-scale-file applied.xml"), &["calcn_r"]);
        // A mesh with a factor below 0 is drawn as its mirror image, and shows a bone of the same size.
        if bad.starts_with('-') {
            continue;
        }
        let mesh = generic_and_scaled("smooth");
        set_mesh_factors(&mesh, "scaled.osim", "calcn_r", &format!("1.02 {bad} 0.95"));
        assert_refused(&mesh, CALL_OF_TRANSFER, &["calcn_r"]);
        let generic = generic_and_scaled("smooth");
        if bad != "0" {
            set_mesh_factors(&generic, "generic.osim", "calcn_r", &format!("1 {bad} 1"));
            assert_refused(&generic, CALL_OF_TRANSFER, &["calcn_r"]);
        }
    }
    let dir = generic_and_scaled("smooth");
    assert_refused(&dir, &format!("{CALL_OF_TRANSFER} --body-scale hoof=1,1,1"), &["hoof"]);
    assert_refused(
        &dir,
        &format!("{CALL_OF_TRANSFER} --body-scale-file generic.osim"),
        &["generic.osim", "ScaleSet"],
    );
}

#[test]
fn an_undetermined_factor_must_be_given() {
    let dir = generic_and_scaled("smooth");
    remove_meshes(&dir);
    // No joint follows the toes, so nothing gives their factors.
    assert_refused(
        &dir,
        CALL_OF_TRANSFER,
        &["toes_r", "x, y and z", "--body-scale toes_r=x,y,z", "[body-scale]"],
    );
    let inspection =
        parse_json(&dir.run("inspect scaled.osim --from generic.osim --format json").succeeded());
    let toes =
        inspection["body_factors"].as_array().unwrap().iter().find(|body| body["body"] == "toes_r").unwrap();
    assert_eq!(toes["factors"], serde_json::json!([null, null, null]));
    // Offsets below a micrometre give no factor.
    replace_in_file(&dir, "generic.osim", "0.12 -0.01 0.01<", "0.12 -0.01 0.0000001<");
    replace_in_file(&dir, "generic.osim", "-0.012 0.002<", "-0.012 0.0000005<");
    replace_in_file(
        &dir,
        "scaled.osim",
        "-0.010800000000000001 0.0019<",
        "-0.010800000000000001 0.000000475<",
    );
    let with_toes =
        format!("{CALL_OF_TRANSFER} --body-scale toes_r=1.02,0.9,0.95 --body-scale toes_l=1.02,0.9,0.95");
    assert_refused(&dir, &with_toes, &["calcn_r", "along z"]);
    let options = "--body-scale toes_r=1.02,0.9,0.95 --body-scale toes_l=1.02,0.9,0.95 --body-scale calcn_r=1.02,0.9,0.95 --radius follow";
    assert_close_place(
        &planned_value(&dry_run_plan(&dir, options), "heel_r", "location"),
        [-0.0102, -0.036, 0.00475],
    );
}

#[test]
fn the_first_source_of_factors_is_used_and_disagreement_is_reported() {
    let dir = generic_and_scaled("smooth");
    set_mesh_factors(&dir, "scaled.osim", "calcn_r", "1.02 0.95 0.95");
    let report = dry_run_plan(&dir, "--body-scale-file applied.xml --radius follow");
    assert!(finding_codes(&report).contains(&"factors-disagree"));
    assert_close_place(&planned_value(&report, "heel_r", "location"), [-0.0102, -0.036, 0.00475]);
    // Without the file, no factor explains mesh and joint.
    set_mesh_factors(&dir, "scaled.osim", "calcn_l", "1.02 0.95 0.95");
    assert!(finding_codes(&dry_run_plan(&dir, "")).contains(&"not-a-scaled-copy"));
    let inspection =
        parse_json(&dir.run("inspect scaled.osim --from generic.osim --format json").succeeded());
    assert!(finding_codes(&inspection).contains(&"not-a-scaled-copy"));
    // In a scaled copy, sources that differ by 1 % do not disagree: files may have two digits.
    let scaled_copy = generic_and_scaled("smooth");
    assert!(
        !finding_codes(&dry_run_plan(&scaled_copy, "--body-scale calcn_r=1.02,0.908,0.95"))
            .contains(&"factors-disagree")
    );
    let report = dry_run_plan(&scaled_copy, "--body-scale calcn_r=1.02,0.91,0.95 --radius follow");
    assert!(finding_codes(&report).contains(&"factors-disagree"), "1.1 %");
    assert_close_place(&planned_value(&report, "heel_r", "location"), [-0.0102, -0.0364, 0.00475]);
    for body in ["calcn_r", "calcn_l"] {
        set_mesh_factors(&dir, "scaled.osim", body, "1.0302 0.905 0.969");
    }
    assert!(!finding_codes(&dry_run_plan(&dir, "")).contains(&"factors-disagree"));
}

// Spheres that were moved before.

#[test]
fn moved_or_resized_spheres_need_keep_or_replace() {
    for (from, to) in [
        ("-0.01 -0.040000000000000001 0.0050000000000000001", "-0.012 -0.04 0.005"),
        ("<radius>0.032", "<radius>0.03"),
    ] {
        let dir = generic_and_scaled("smooth");
        replace_in_file(&dir, "scaled.osim", from, to);
        assert_refused(
            &dir,
            CALL_OF_TRANSFER,
            &["heel_r", "--moved-spheres keep", "--moved-spheres replace", "[moved-spheres]"],
        );
        let replaced = dry_run_plan(&dir, "--moved-spheres replace --radius follow");
        assert_close_place(&planned_value(&replaced, "heel_r", "location"), [-0.0102, -0.036, 0.00475]);
        assert_close(&planned_value(&replaced, "heel_r", "radius"), 0.030_573_048_163_784_02);
        let plan_with_kept = dry_run_plan(&dir, "--moved-spheres keep");
        let touched =
            plan_with_kept["changes"].as_array().unwrap().iter().any(|change| change["sphere"] == "heel_r");
        assert!(!touched, "heel_r stays as it is");
    }
    // A kept radius counts: (10) with the 0.03 m that stay in the file.
    let dir = generic_and_scaled("smooth");
    replace_in_file(&dir, "scaled.osim", "<radius>0.032", "<radius>0.03");
    let expected = 2e6 * (52.0 / 62.0) * (0.032 / 0.03) * (0.032 / 0.03);
    assert_close(
        &planned_value(&dry_run_plan(&dir, "--moved-spheres keep"), "contact_heel_r", "stiffness"),
        expected,
    );
}

/// Somebody multiplied places by factors of three digits.
#[test]
fn a_sphere_that_is_nearly_where_it_belongs_has_followed() {
    for (place, is_accused) in [("-0.01019 -0.03603 0.004752", false), ("-0.0103 -0.0363 0.0048", true)] {
        let dir = generic_and_scaled("smooth");
        replace_in_file(&dir, "scaled.osim", "-0.01 -0.040000000000000001 0.0050000000000000001", place);
        // The other spheres are left behind.
        let out = dir.run("check scaled.osim --from generic.osim --format json").failed().out();
        assert_eq!(out.contains("were moved, but not to where"), is_accused, "{out}");
    }
}

/// A mass that was corrected later changed the radii around centres that stayed.
#[test]
fn a_sphere_that_is_where_a_radius_between_would_have_it_has_followed() {
    let dir = generic_and_scaled("smooth");
    dir.run(&format!("{CALL_OF_TRANSFER} --level --mass 60 -o first.osim")).succeeded();
    dir.run("first.osim --target-mass 52 -o second.osim").succeeded();
    let out = dir.run("check second.osim --from generic.osim --format json").succeeded().out();
    assert!(!out.contains("spheres-misplaced"), "{out}");
}

#[test]
fn a_model_after_follow_bodies_is_recognised() {
    let dir = generic_and_scaled("smooth");
    dir.run(&format!("{CALL_OF_TRANSFER} -o done.osim")).succeeded();
    let again = CALL_OF_TRANSFER.replace("scaled.osim", "done.osim");
    let out = dir.run(&format!("{again} -o again.osim")).succeeded().out();
    assert!(out.contains("every value is already as the reference wants it"), "{out}");
    // Only the sphere that was moved since is asked about.
    dir.run("set done.osim radius=x1.1 --select contact_toe_r -o other.osim").succeeded();
    let again = again.replace("done.osim", "other.osim");
    assert_refused(&dir, &again, &["moved or resized already: toe_r: ", "[moved-spheres]"]);
}

#[test]
fn spheres_that_followed_are_not_moved_by_a_radius_that_changes_later() {
    let dir = generic_and_scaled("smooth");
    dir.run(&format!("{CALL_OF_TRANSFER} -o done.osim")).succeeded();
    for call in ["done.osim --target-mass 60 -o later.osim", "set done.osim radius=x1.1 -o later.osim"] {
        dir.run(&format!("{call} --force")).succeeded().wrote(&["later.osim"]);
        let out = dir.run("check later.osim --from generic.osim --format json").out();
        assert!(!out.contains("spheres-misplaced") && !out.contains("spheres-left-behind"), "{out}");
    }
}

#[test]
fn where_radii_by_mass_and_by_bones_part_a_remark_says_what_each_keeps() {
    // The bones are x (1.02 · 0.9 · 0.95)^(1/3) = x0.955. 75 kg are x (75/62)^(1/3) = x1.07; 1.1 times the bones are 71.97 kg.
    let dir = generic_and_scaled("smooth");
    let remarks = |options: &str| {
        let report = dry_run_plan(&dir, options);
        let remarks = report["remarks"].as_array().unwrap().iter().map(|remark| remark.as_str().unwrap());
        remarks.filter(|remark| remark.starts_with("radii follow")).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(
        remarks("--mass 75 --radius follow"),
        [
            "radii follow the bones (x0.955), and mass^(1/3) is x1.07: this keeps depth and pressure under the foot; \
          --radius isometric keeps the peak force of falls from heights in proportion to mass^(1/3)"
        ]
    );
    assert_eq!(
        remarks("--mass 75 --radius isometric"),
        [
            "radii follow mass^(1/3) (x1.07), and the bones are x0.955: this keeps the peak force of falls from heights in \
          proportion to mass^(1/3); --radius follow keeps depth and pressure under the foot"
        ]
    );
    assert_eq!(remarks("--mass 75"), remarks("--mass 75 --radius isometric"));
    for radius in ["--radius follow", "--radius isometric"] {
        assert_eq!(remarks(&format!("{radius} --mass 72.1")).len(), 1);
        assert_eq!(remarks(&format!("{radius} --mass 71.9")).len(), 0);
    }
    for rule in ["--radius keep", "--radius 0.03", "--keep radius", "--rule predsim"] {
        assert_eq!(remarks(&format!("--mass 75 {rule}")).len(), 0, "{rule}");
    }
}

#[test]
fn the_predsim_rule_scales_stiffness_and_dissipation() {
    let dir = generic_and_scaled("smooth");
    let report = dry_run_plan(&dir, "--rule predsim");
    assert_close(&planned_value(&report, "contact_toe_l", "stiffness"), 1_837_655.613_115_876_4);
    assert_close(&planned_value(&report, "contact_toe_l", "dissipation"), 2.093_347_044_008_932_6);
    let report = dry_run_plan(&dir, "--rule predsim --height-ratio 0.93");
    assert_close(&planned_value(&report, "contact_toe_l", "stiffness"), 1_939_437.339_390_345_2);
    assert_close(&planned_value(&report, "contact_toe_l", "dissipation"), 2.150_537_634_408_602);
    let smoothing =
        report["changes"].as_array().unwrap().iter().any(|change| change["property"] == "hertz_smoothing");
    assert!(!smoothing, "PredSim leaves the smoothing");
    let remarks = report["remarks"].to_string();
    for number in ["0.353", "0.341", "0.549", "0.536"] {
        assert!(remarks.contains(number), "{number}: {remarks}");
    }
    let run_without_follow = dir.run("transfer scaled.osim --from generic.osim --rule predsim").failed();
    assert_stderr_has(&run_without_follow, &["--height-ratio"]);
    // The paper's rule has no heights.
    assert_stderr_has(
        &dir.run(&format!("{CALL_OF_TRANSFER} --height-ratio 0.93")).usage_error(),
        &["--rule"],
    );
}

#[test]
fn one_force_over_bodies_of_different_factors_gets_one_modulus() {
    let dir = generic_and_scaled("hunt_crossley");
    let options = "--body-scale toes_r=1.1,1.1,1.1 --radius follow";
    let report = dry_run_plan(&dir, options);
    assert!(finding_codes(&report).contains(&"factor-spread"));
    assert_close(&planned_value(&report, "toe_r", "radius"), 0.0352);
    assert_close(&planned_value(&report, "contact_foot_r", "stiffness"), 1_657_743.073_435_748_5);
    assert_close(&planned_value(&report, "contact_foot_r", "dissipation"), 1.994_108_977_545_730_6);
    assert_close(&planned_value(&report, "contact_foot_l", "stiffness"), 1_837_655.613_115_876_4);
    assert_refused(
        &dir,
        &format!("{CALL_OF_TRANSFER} {options} --strict"),
        &["contact_foot_r", "15.1 %", "--strict"],
    );
    let strict_plan = dry_run_plan(&dir, "--strict --radius follow");
    assert!(!finding_codes(&strict_plan).contains(&"factor-spread"));
    // If each sphere has a force, each force follows one body.
    let one_force_each = TestDir::with(&[
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
    ]);
    assert!(!finding_codes(&dry_run_plan(&one_force_each, options)).contains(&"factor-spread"));
}

#[test]
fn spheres_of_several_materials_keep_their_ratios() {
    let dir = TestDir::with(&[
        ("format/three_materials.osim", "generic.osim"),
        ("format/three_materials.osim", "scaled.osim"),
    ]);
    let text = dir.text("scaled.osim");
    let bodies: Vec<&str> = ["calcn_r", "calcn_l", "toes_r", "toes_l"]
        .into_iter()
        .filter(|name| text.contains(&format!("<Body name=\"{name}\">")))
        .collect();
    let options: String = bodies.iter().map(|body| format!(" --body-scale {body}=2,2,2")).collect();
    let options = format!("{options} --radius follow");
    let report = dry_run_plan(&dir, &options);
    let changes_of = |property: &str| {
        let changes = report["changes"].as_array().unwrap().iter();
        changes.filter(|change| change["property"] == property).cloned().collect::<Vec<_>>()
    };
    // The same mass on twice the radius: a quarter of the modulus, for floor, heel and toe alike.
    assert!(changes_of("stiffness").len() >= 3);
    for change in changes_of("stiffness") {
        assert_close(&change["to"], change["from"].as_f64().unwrap() / 4.0);
    }
    assert!(!changes_of("dissipation").is_empty());
    for change in changes_of("dissipation") {
        assert_close(&change["to"], change["from"].as_f64().unwrap() * 0.5_f64.sqrt());
    }
    // If the floor was made harder, heel and toe would need different factors.
    let moduli = text.match_indices("<stiffness>").map(|(at, tag)| at + tag.len()).collect::<Vec<_>>();
    let end = moduli[0] + text[moduli[0]..].find('<').unwrap();
    dir.write("scaled.osim", format!("{}9e6{}", &text[..moduli[0]], &text[end..]));
    assert_refused(&dir, &format!("{CALL_OF_TRANSFER}{options}"), &["stiffness", "materials"]);
}

// Documents of version 3.

/// A foot of a version 3 document: joints inside bodies, `VisibleObject` factors.
fn version_3_model(foot_scale: &str, offset: &str, location: &str) -> String {
    let body = |name: &str, inner: &str, scale: &str| {
        format!(
            "<Body name=\"{name}\"><mass>5</mass><mass_center>0 0 0</mass_center>{inner}<VisibleObject name=\"\"><GeometrySet><objects>\
             <DisplayGeometry><geometry_file>{name}.vtp</geometry_file><scale_factors> 1 1 1</scale_factors></DisplayGeometry></objects>\
             </GeometrySet><scale_factors> {scale}</scale_factors></VisibleObject></Body>"
        )
    };
    let joint = |name: &str, parent: &str, there: &str, here: &str| {
        format!(
            "<Joint><WeldOrPin/><PinJoint name=\"{name}\"><parent_body>{parent}</parent_body><location_in_parent>{there}</location_in_parent>\
             <location>{here}</location></PinJoint></Joint>"
        )
        .replace("<WeldOrPin/>", "")
    };
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenSimDocument Version=\"30000\">\n<Model name=\"old\"><gravity> 0 -9.81 0</gravity>\
         <BodySet><objects><Body name=\"ground\"><mass>0</mass></Body>{}{}</objects></BodySet>\n<ForceSet><objects>\
         <HuntCrossleyForce name=\"contact_r\"><isDisabled>false</isDisabled><HuntCrossleyForce::ContactParametersSet name=\"contact_parameters\">\
         <objects><HuntCrossleyForce::ContactParameters><geometry>floor heel</geometry><stiffness>1000000</stiffness><dissipation>2</dissipation>\
         </HuntCrossleyForce::ContactParameters></objects></HuntCrossleyForce::ContactParametersSet></HuntCrossleyForce></objects></ForceSet>\n\
         <ContactGeometrySet><objects><ContactHalfSpace name=\"floor\"><body_name>ground</body_name></ContactHalfSpace>\
         <ContactSphere name=\"heel\"><body_name>calcn_r</body_name><location>{location}</location><radius>0.04</radius></ContactSphere>\
         </objects></ContactGeometrySet></Model>\n</OpenSimDocument>\n",
        body("tibia_r", &joint("root", "ground", "0 0 0", "0 0 0"), "1 1 1"),
        body("calcn_r", &joint("ankle_r", "tibia_r", "0 -0.4 0", offset), foot_scale),
    )
}

#[test]
fn version_3_models_have_factors_in_visible_objects_and_joints() {
    let dir = TestDir::new();
    dir.write("generic.osim", version_3_model("1 1 1", "0.1 0.05 0.02", "0.01 -0.02 0.03"));
    dir.write("scaled.osim", version_3_model("2 1.5 1", "0.2 0.075 0.02", "0.01 -0.02 0.03"));
    let inspection =
        parse_json(&dir.run("inspect scaled.osim --from generic.osim --format json").succeeded());
    let foot =
        inspection["body_factors"].as_array().unwrap().iter().find(|body| body["body"] == "calcn_r").unwrap();
    assert_eq!(foot["by_source"]["mesh"], serde_json::json!([2.0, 1.5, 1.0]));
    for (value, expected) in foot["by_source"]["joint offset"].as_array().unwrap().iter().zip([2.0, 1.5, 1.0])
    {
        assert_close(value, expected);
    }
    let report = dry_run_plan(&dir, "--spheres 1 --reference-spheres 1 --radius follow");
    assert_close_place(&planned_value(&report, "heel", "location"), [0.02, -0.03, 0.03]);
    assert_close(&planned_value(&report, "heel", "radius"), 0.04 * 3.0_f64.cbrt());
}

// Output.

#[test]
fn follow_bodies_output_matches_its_snapshots() {
    let dir = generic_and_scaled("smooth");
    dir.run(&format!("{CALL_OF_TRANSFER} --level --dry-run")).succeeded().matches_snapshot("follow");
    dir.run(&format!("{CALL_OF_TRANSFER} --rule predsim --dry-run"))
        .succeeded()
        .matches_snapshot("follow_predsim");
    dir.run("inspect scaled.osim --from generic.osim").succeeded().matches_snapshot("follow_inspect");
    let call = format!("{CALL_OF_TRANSFER} --level --body-scale-file applied.xml --dry-run --format json");
    dir.run(&call).succeeded().matches_snapshot("follow_json");
}
