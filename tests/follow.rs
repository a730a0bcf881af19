//! Contacts that follow bodies which OpenSim has scaled (`transfer --follow-bodies`, `inspect --from`).
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
    reason = "a test fails by panicking; the shared bench has more than this file uses"
)]

#[path = "follow/different.rs"]
mod different;
#[path = "follow/matched.rs"]
mod matched;
#[path = "command/support.rs"]
mod support;

use serde_json::Value;
use support::{Bench, Ran};

const TOLERANCE: f64 = 1e-12;
const CALL: &str = "transfer scaled.osim --from generic.osim --follow-bodies";

/// The fixture's pair of one class.
fn bench(kind: &str) -> Bench {
    Bench::with(&[
        (&format!("scale_tool/generic_{kind}.osim"), "generic.osim"),
        (&format!("scale_tool/scaled_{kind}.osim"), "scaled.osim"),
        ("scale_tool/applied_scale_set.xml", "applied.xml"),
    ])
}

/// Replaces every `from` in a file of the bench; there must be one.
#[track_caller]
fn edit(bench: &Bench, name: &str, from: &str, to: &str) {
    let text = bench.text(name);
    assert!(text.contains(from), "{name} has no {from}");
    bench.write(name, text.replace(from, to));
}

/// Changes the scale factors of one body's mesh.
#[track_caller]
fn set_mesh(bench: &Bench, name: &str, body: &str, factors: &str) {
    let text = bench.text(name);
    let mesh = text.find(&format!("<Mesh name=\"{body}_geom_1\">")).expect("the body has a mesh");
    let start = mesh + text[mesh..].find("<scale_factors>").unwrap() + "<scale_factors>".len();
    let end = start + text[start..].find('<').unwrap();
    bench.write(name, format!("{}{factors}{}", &text[..start], &text[end..]));
}

/// Takes the meshes and their factors out of both models.
fn without_meshes(bench: &Bench) {
    for name in ["generic.osim", "scaled.osim"] {
        edit(bench, name, "<Mesh name=", "<Brick name=");
        edit(bench, name, "</Mesh>", "</Brick>");
    }
}

/// A refusal that says each of `words` and leaves nothing behind.
#[track_caller]
fn refuses(bench: &Bench, call: &str, words: &[&str]) {
    let ran = bench.run(call).failed();
    assert!(ran.changed.is_empty(), "written: {:?}", ran.changed);
    let (codes, words): (Vec<&str>, Vec<&str>) = words.iter().partition(|word| word.starts_with('['));
    says(&ran, &words);
    for code in codes {
        let report = json(&bench.run(&format!("{call} --format json")).failed());
        assert_eq!(format!("[{}]", report["error"]["code"].as_str().unwrap()), code);
    }
}

#[track_caller]
fn says(ran: &Ran, words: &[&str]) {
    for word in words {
        assert!(ran.err().contains(word), "no '{word}' in {}", ran.err());
    }
}

fn json(ran: &Ran) -> Value {
    serde_json::from_str(&ran.out()).unwrap()
}

/// What a dry run plans for `property` of the force or sphere whose path ends with `name`.
#[track_caller]
fn planned(report: &Value, name: &str, property: &str) -> Value {
    let changes = report["changes"].as_array().unwrap();
    let found = changes.iter().find(|change| {
        change["property"] == property && change["path"].as_str().unwrap().ends_with(&format!("/{name}"))
    });
    found.unwrap_or_else(|| panic!("no {property} of {name}"))["to"].clone()
}

#[track_caller]
fn close(value: &Value, expected: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - expected).abs() <= TOLERANCE * expected.abs(), "{value} is not {expected}");
}

#[track_caller]
fn close_place(value: &Value, expected: [f64; 3]) {
    for (value, expected) in value.as_array().unwrap().iter().zip(expected) {
        assert!((value.as_f64().unwrap() - expected).abs() <= 1e-15, "{value} is not {expected}");
    }
}

/// The plan of a dry run with further options.
fn plan(bench: &Bench, more: &str) -> Value {
    json(&bench.run(&format!("{CALL} --dry-run --format json {more}")).done())
}

fn codes(report: &Value) -> Vec<&str> {
    report["warnings"].as_array().unwrap().iter().map(|warning| warning["code"].as_str().unwrap()).collect()
}

// Factors.

#[test]
fn factors_that_are_no_sizes_are_refused() {
    for bad in ["0", "-1", "nan", "inf"] {
        let bench = bench("smooth");
        let ran = bench.run(&format!("{CALL} --body-scale calcn_r=1,{bad},1")).usage();
        assert!(ran.changed.is_empty());
        says(&ran, &["--body-scale", "calcn_r"]);
    }
    for bad in ["0", "-0.9", "NaN", "inf", "1e400"] {
        let file = bench("smooth");
        edit(&file, "applied.xml", " 1.02 0.9 0.95", &format!(" 1.02 {bad} 0.95"));
        refuses(&file, &format!("{CALL} --body-scale-file applied.xml"), &["calcn_r"]);
        let mesh = bench("smooth");
        set_mesh(&mesh, "scaled.osim", "calcn_r", &format!("1.02 {bad} 0.95"));
        refuses(&mesh, CALL, &["calcn_r"]);
        let generic = bench("smooth");
        if bad != "0" {
            set_mesh(&generic, "generic.osim", "calcn_r", &format!("1 {bad} 1"));
            refuses(&generic, CALL, &["calcn_r"]);
        }
    }
    let bench = bench("smooth");
    refuses(&bench, &format!("{CALL} --body-scale hoof=1,1,1"), &["hoof"]);
    refuses(&bench, &format!("{CALL} --body-scale-file generic.osim"), &["generic.osim", "ScaleSet"]);
}

#[test]
fn an_undetermined_axis_is_asked_for_and_never_1() {
    let bench = bench("smooth");
    without_meshes(&bench);
    // The toes end in no joint: nothing says how they were scaled.
    refuses(&bench, CALL, &["toes_r", "x, y and z", "--body-scale toes_r=x,y,z", "[body-scale]"]);
    let seen = json(&bench.run("inspect scaled.osim --from generic.osim --format json").done());
    let toes = seen["body_factors"].as_array().unwrap().iter().find(|body| body["body"] == "toes_r").unwrap();
    assert_eq!(toes["factors"], serde_json::json!([null, null, null]));
    // Offsets below a micrometre say nothing.
    edit(&bench, "generic.osim", "0.12 -0.01 0.01<", "0.12 -0.01 0.0000001<");
    edit(&bench, "generic.osim", "-0.012 0.002<", "-0.012 0.0000005<");
    edit(&bench, "scaled.osim", "-0.010800000000000001 0.0019<", "-0.010800000000000001 0.000000475<");
    let with_toes = format!("{CALL} --body-scale toes_r=1.02,0.9,0.95 --body-scale toes_l=1.02,0.9,0.95");
    refuses(&bench, &with_toes, &["calcn_r", "along z"]);
    let told = "--body-scale toes_r=1.02,0.9,0.95 --body-scale toes_l=1.02,0.9,0.95 --body-scale calcn_r=1.02,0.9,0.95";
    close_place(&planned(&plan(&bench, told), "heel_r", "location"), [-0.0102, -0.036, 0.00475]);
}

#[test]
fn the_first_source_counts_and_a_disagreement_is_said() {
    let bench = bench("smooth");
    set_mesh(&bench, "scaled.osim", "calcn_r", "1.02 0.95 0.95");
    let report = plan(&bench, "--body-scale-file applied.xml");
    assert!(codes(&report).contains(&"factors-disagree"));
    close_place(&planned(&report, "heel_r", "location"), [-0.0102, -0.036, 0.00475]);
    // Without the file, no factor explains mesh and joint.
    set_mesh(&bench, "scaled.osim", "calcn_l", "1.02 0.95 0.95");
    assert!(codes(&plan(&bench, "")).contains(&"not-a-scaled-copy"));
    let seen = json(&bench.run("inspect scaled.osim --from generic.osim --format json").done());
    assert!(codes(&seen).contains(&"not-a-scaled-copy"));
    // In a scaled copy, one per cent is no disagreement: a file of two digits, and what the caller says.
    let copy = self::bench("smooth");
    assert!(!codes(&plan(&copy, "--body-scale calcn_r=1.02,0.908,0.95")).contains(&"factors-disagree"));
    let report = plan(&copy, "--body-scale calcn_r=1.02,0.91,0.95");
    assert!(codes(&report).contains(&"factors-disagree"), "1.1 %");
    close_place(&planned(&report, "heel_r", "location"), [-0.0102, -0.0364, 0.00475]);
    for body in ["calcn_r", "calcn_l"] {
        set_mesh(&bench, "scaled.osim", body, "1.0302 0.905 0.969");
    }
    assert!(!codes(&plan(&bench, "")).contains(&"factors-disagree"));
}

// Spheres that were moved before.

#[test]
fn moved_or_resized_spheres_are_refused_kept_or_replaced() {
    for (from, to) in [
        ("-0.01 -0.040000000000000001 0.0050000000000000001", "-0.012 -0.04 0.005"),
        ("<radius>0.032", "<radius>0.03"),
    ] {
        let bench = bench("smooth");
        edit(&bench, "scaled.osim", from, to);
        refuses(
            &bench,
            CALL,
            &["heel_r", "--moved-spheres keep", "--moved-spheres replace", "[moved-spheres]"],
        );
        let replaced = plan(&bench, "--moved-spheres replace");
        close_place(&planned(&replaced, "heel_r", "location"), [-0.0102, -0.036, 0.00475]);
        close(&planned(&replaced, "heel_r", "radius"), 0.030_573_048_163_784_02);
        let kept = plan(&bench, "--moved-spheres keep");
        let touched = kept["changes"].as_array().unwrap().iter().any(|change| change["sphere"] == "heel_r");
        assert!(!touched, "heel_r stays as it is");
    }
    // A kept radius counts: (10) with the 0.03 m that stay in the file.
    let bench = bench("smooth");
    edit(&bench, "scaled.osim", "<radius>0.032", "<radius>0.03");
    let expected = 2e6 * (52.0 / 62.0) * (0.032 / 0.03) * (0.032 / 0.03);
    close(&planned(&plan(&bench, "--moved-spheres keep"), "contact_heel_r", "stiffness"), expected);
}

#[test]
fn a_followed_model_is_recognised() {
    let bench = bench("smooth");
    bench.run(&format!("{CALL} -o done.osim")).done();
    refuses(&bench, &CALL.replace("scaled.osim", "done.osim"), &["[moved-spheres]"]);
}

// Numbers.

#[test]
fn parameters_follow_the_paper() {
    let report = plan(&bench("smooth"), "");
    for (property, expected) in [
        ("stiffness", 1_837_655.613_115_876_4),
        ("dissipation", 2.046_141_267_854_657_6),
        ("constant_contact_force", 9.128_039_785_400_951e-6),
        ("hertz_smoothing", 314.002_056_601_339_86),
        ("hunt_crossley_smoothing", 51.153_531_696_366_436),
    ] {
        close(&planned(&report, "contact_ball_r", property), expected);
    }
    close_place(
        &planned(&report, "ball_r", "location"),
        [0.011_190_745_890_090_035, -0.027_914_656_364_983_893, 0.018_338_133_644_451_395],
    );
}

#[test]
fn bottoms_stay_on_the_scaled_sole() {
    let bench = bench("smooth");
    for (more, heel, ball, toe) in [
        (
            "--level",
            [-0.0102, -0.034_226_951_836_215_99, 0.00475],
            [0.012_659_574_174_317_836, -0.027_034_738_136_372_95, 0.017_727_474_783_552_12],
            [0.0306, -0.023_426_951_836_215_98, -0.0038],
        ),
        (
            "--level --level-axis z",
            [-0.0102, -0.036_000_000_000_000_004, 0.004_923_048_163_784_02],
            [0.011_385_132_268_790_465, -0.028_525_315_225_883_172, 0.018_556_986_496_414_053],
            [0.0306, -0.0252, -0.003_626_951_836_215_981_7],
        ),
    ] {
        let report = plan(&bench, more);
        for (name, place) in [("heel_r", heel), ("ball_r", ball), ("toe_r", toe)] {
            close_place(&planned(&report, name, "location"), place);
        }
    }
    let alone = bench.run("transfer scaled.osim --from generic.osim --level").usage();
    says(&alone, &["--level says nothing here: radii stay", "--radius isometric", "--follow-bodies"]);
}

#[test]
fn a_frame_lying_on_its_side_is_levelled_along_what_is_up() {
    // A quarter turn about z: the frame's x points up, and the offset across the sole is along its -y.
    let bench = bench("smooth");
    for name in ["generic.osim", "scaled.osim"] {
        let text = bench.text(name);
        let turned = text.match_indices("<orientation>0.").map(|(at, _)| at).collect::<Vec<_>>();
        let mut text = text.clone();
        for at in turned.into_iter().rev() {
            let end = at + text[at..].find("</orientation>").unwrap();
            text.replace_range(at..end, "<orientation>0 0 1.5707963267948966");
        }
        bench.write(name, text);
    }
    // x: 0.9 (0.01 - 0.032) + R'; y: 1.02 (-0.03); z: 0.95 (0.02).
    let place = planned(&plan(&bench, "--level"), "ball_r", "location");
    close_place(&place, [0.010_773_048_163_784_02, -0.0306, 0.019]);
}

#[test]
fn radii_follow_the_axis_that_is_asked_for() {
    let bench = bench("smooth");
    for (axis, radius) in [
        ("x", 0.03264),
        ("y", 0.0288),
        ("z", 0.0304),
        ("min", 0.0288),
        ("max", 0.03264),
        ("geomean", 0.030_573_048_163_784_02),
    ] {
        let report = plan(&bench, &format!("--radius-axis {axis}"));
        close(&planned(&report, "toe_l", "radius"), radius);
        let ratio: f64 = radius / 0.032;
        close(&planned(&report, "contact_toe_l", "stiffness"), 2e6 * (52.0 / 62.0) / (ratio * ratio));
    }
    let kept = plan(&bench, "--keep radius --level");
    assert!(!kept["changes"].as_array().unwrap().iter().any(|change| change["property"] == "radius"));
    close(&planned(&kept, "contact_toe_l", "stiffness"), 2e6 * (52.0 / 62.0));
    // The bottom of the sphere as it is: 0.9 (-0.028 - 0.032) + 0.032.
    close_place(&planned(&kept, "toe_r", "location"), [0.0306, -0.022, -0.0038]);
}

#[test]
fn predsim_scales_otherwise() {
    let bench = bench("smooth");
    let report = plan(&bench, "--rule predsim");
    close(&planned(&report, "contact_toe_l", "stiffness"), 1_837_655.613_115_876_4);
    close(&planned(&report, "contact_toe_l", "dissipation"), 2.093_347_044_008_932_6);
    let report = plan(&bench, "--rule predsim --height-ratio 0.93");
    close(&planned(&report, "contact_toe_l", "stiffness"), 1_939_437.339_390_345_2);
    close(&planned(&report, "contact_toe_l", "dissipation"), 2.150_537_634_408_602);
    let smoothing =
        report["changes"].as_array().unwrap().iter().any(|change| change["property"] == "hertz_smoothing");
    assert!(!smoothing, "PredSim leaves the smoothing");
    let remarks = report["remarks"].to_string();
    for number in ["0.3533", "0.3408", "0.5494", "0.5363"] {
        assert!(remarks.contains(number), "{number}: {remarks}");
    }
    let alone = bench.run("transfer scaled.osim --from generic.osim --rule predsim").failed();
    says(&alone, &["--height-ratio"]);
    // The paper's rule has no heights.
    says(&bench.run(&format!("{CALL} --height-ratio 0.93")).usage(), &["--rule"]);
}

#[test]
fn one_modulus_for_bodies_of_different_factors() {
    let bench = bench("hunt_crossley");
    let more = "--body-scale toes_r=1.1,1.1,1.1";
    let report = plan(&bench, more);
    assert!(codes(&report).contains(&"factor-spread"));
    close(&planned(&report, "toe_r", "radius"), 0.0352);
    close(&planned(&report, "contact_foot_r", "stiffness"), 1_657_743.073_435_748_5);
    close(&planned(&report, "contact_foot_r", "dissipation"), 1.994_108_977_545_730_6);
    close(&planned(&report, "contact_foot_l", "stiffness"), 1_837_655.613_115_876_4);
    refuses(&bench, &format!("{CALL} {more} --strict"), &["contact_foot_r", "15.1 %", "--strict"]);
    let even = plan(&bench, "--strict");
    assert!(!codes(&even).contains(&"factor-spread"));
    // Spheres with a force each: every one follows its own body, there is nothing to mix.
    let apart = Bench::with(&[
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
    ]);
    assert!(!codes(&plan(&apart, more)).contains(&"factor-spread"));
}

#[test]
fn spheres_of_several_materials_keep_what_tells_them_apart() {
    let bench = Bench::with(&[
        ("format/three_materials.osim", "generic.osim"),
        ("format/three_materials.osim", "scaled.osim"),
    ]);
    let text = bench.text("scaled.osim");
    let bodies: Vec<&str> = ["calcn_r", "calcn_l", "toes_r", "toes_l"]
        .into_iter()
        .filter(|name| text.contains(&format!("<Body name=\"{name}\">")))
        .collect();
    let told: String = bodies.iter().map(|body| format!(" --body-scale {body}=2,2,2")).collect();
    let report = plan(&bench, &told);
    let of = |property: &str| {
        let changes = report["changes"].as_array().unwrap().iter();
        changes.filter(|change| change["property"] == property).cloned().collect::<Vec<_>>()
    };
    // The same mass on twice the radius: a quarter of the modulus, for floor, heel and toe alike.
    assert!(of("stiffness").len() >= 3);
    for change in of("stiffness") {
        close(&change["to"], change["from"].as_f64().unwrap() / 4.0);
    }
    assert!(!of("dissipation").is_empty());
    for change in of("dissipation") {
        close(&change["to"], change["from"].as_f64().unwrap() * 0.5_f64.sqrt());
    }
    // A floor made harder since then: heel and toe would need different factors.
    let moduli = text.match_indices("<stiffness>").map(|(at, tag)| at + tag.len()).collect::<Vec<_>>();
    let end = moduli[0] + text[moduli[0]..].find('<').unwrap();
    bench.write("scaled.osim", format!("{}9e6{}", &text[..moduli[0]], &text[end..]));
    refuses(&bench, &format!("{CALL}{told}"), &["stiffness", "materials"]);
}

// Documents of version 3.

/// A foot of a version 3 document: joints inside bodies, `VisibleObject` factors.
fn old(foot_scale: &str, offset: &str, location: &str) -> String {
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
fn version_3_says_factors_in_visible_objects_and_joints() {
    let bench = Bench::new();
    bench.write("generic.osim", old("1 1 1", "0.1 0.05 0.02", "0.01 -0.02 0.03"));
    bench.write("scaled.osim", old("2 1.5 1", "0.2 0.075 0.02", "0.01 -0.02 0.03"));
    let seen = json(&bench.run("inspect scaled.osim --from generic.osim --format json").done());
    let foot =
        seen["body_factors"].as_array().unwrap().iter().find(|body| body["body"] == "calcn_r").unwrap();
    assert_eq!(foot["by_source"]["mesh"], serde_json::json!([2.0, 1.5, 1.0]));
    for (said, expected) in foot["by_source"]["joint offset"].as_array().unwrap().iter().zip([2.0, 1.5, 1.0])
    {
        close(said, expected);
    }
    let report = plan(&bench, "--spheres 1 --reference-spheres 1");
    close_place(&planned(&report, "heel", "location"), [0.02, -0.03, 0.03]);
    close(&planned(&report, "heel", "radius"), 0.04 * 3.0_f64.cbrt());
}

// What it looks like.

#[test]
fn tables_and_json() {
    let bench = bench("smooth");
    bench.run(&format!("{CALL} --level --dry-run")).done().looks_like("follow");
    bench.run(&format!("{CALL} --rule predsim --dry-run")).done().looks_like("follow_predsim");
    bench.run("inspect scaled.osim --from generic.osim").done().looks_like("follow_inspect");
    let call = format!("{CALL} --level --body-scale-file applied.xml --dry-run --format json");
    bench.run(&call).done().looks_like("follow_json");
}
