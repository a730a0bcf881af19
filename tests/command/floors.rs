//! `check`: whether the floor is level, and whether gravity points into it.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::support::{HUMAN, TestDir, corpus_folder, fixture, root};

/// The codes of findings about floors and gravity.
const CODES_ABOUT_FLOORS: [&str; 8] = [
    "angle-in-degrees",
    "gravity-too-large",
    "gravity-not-down",
    "floor-upside-down",
    "floor-upright",
    "floor-on-limb",
    "floor-slopes",
    "no-gravity",
];
const LEVEL_ORIENTATION: &str = "<orientation>0 0 -1.5707963267948966</orientation>";
const GROUND_FRAME: &str = "<socket_frame>/ground</socket_frame>";
const GRAVITY: &str = "<gravity>0 -9.8100000000000005 0</gravity>";

fn with_edits(text: &str, edits: &[(&str, &str)]) -> String {
    edits.iter().fold(text.to_owned(), |text, (old, new)| {
        assert!(text.contains(old), "the model has no {old}");
        text.replacen(old, new, 1)
    })
}

/// The findings about floors and gravity in a model with this text.
fn floor_findings(text: &str) -> Vec<Value> {
    let dir = TestDir::new();
    dir.write("model.osim", text);
    let out = dir.run("check model.osim --format json").wrote_nothing().out();
    let report: Value = serde_json::from_str(&out).unwrap_or_else(|error| panic!("{error}: {out}"));
    let findings = report["findings"].as_array().unwrap().iter();
    findings
        .filter(|finding| CODES_ABOUT_FLOORS.contains(&finding["code"].as_str().unwrap()))
        .cloned()
        .collect()
}

fn codes_of(findings: &[Value]) -> BTreeSet<&str> {
    findings.iter().map(|finding| finding["code"].as_str().unwrap()).collect()
}

fn human_text() -> String {
    String::from_utf8(fixture(HUMAN.0)).unwrap()
}

/// The text of the model after the finding's proposed line replaced the line that the finding names.
fn corrected_text(text: &str, finding: &Value) -> Option<String> {
    let message = finding["message"].as_str().unwrap();
    let (_, written) = message.split_once("write <")?;
    let (tag, rest) = written.split_once('>').unwrap();
    let (value, _) = rest.split_once("</").unwrap();
    let line = usize::try_from(finding["line"].as_u64().unwrap()).unwrap() - 1;
    let lines = text.lines().enumerate().map(|(index, line_text)| {
        if index != line {
            return line_text.to_owned();
        }
        assert!(line_text.contains(&format!("<{tag}>")), "line {}: {line_text}, expected <{tag}>", line + 1);
        format!("<{tag}>{value}</{tag}>")
    });
    Some(lines.collect::<Vec<_>>().join("\n"))
}

#[test]
fn each_floor_error_is_named_and_its_proposal_corrects_it() {
    for (old, new, code, says) in [
        (LEVEL_ORIENTATION, "<orientation>0 0 0</orientation>", "floor-upright", "90 degrees away from up"),
        (
            LEVEL_ORIENTATION,
            "<orientation>0 1.5707963267948966 0</orientation>",
            "floor-upright",
            "90 degrees away from up",
        ),
        (
            LEVEL_ORIENTATION,
            "<orientation>0 0 1.5707963267948966</orientation>",
            "floor-upside-down",
            "180 degrees away from up",
        ),
        (
            LEVEL_ORIENTATION,
            "<orientation>0 0 -90</orientation>",
            "angle-in-degrees",
            "<orientation>0 0 -1.5707963</orientation>",
        ),
        (GROUND_FRAME, "<socket_frame>/bodyset/pelvis</socket_frame>", "floor-on-limb", "is fixed to pelvis"),
        (
            GROUND_FRAME,
            "<socket_frame>/bodyset/tibia_l</socket_frame>",
            "floor-on-limb",
            "is fixed to tibia_l",
        ),
        (GRAVITY, "<gravity>0 9.81 0</gravity>", "gravity-not-down", "out of the floor"),
        (GRAVITY, "<gravity>9.81 0 0</gravity>", "gravity-not-down", "along the floor"),
        (GRAVITY, "<gravity>0 -9810 0</gravity>", "gravity-too-large", "<gravity>0 -9.81 0</gravity>"),
        (GRAVITY, "<gravity>0 -981 0</gravity>", "gravity-too-large", "<gravity>0 -9.81 0</gravity>"),
        (GRAVITY, "<gravity>0 0 0</gravity>", "no-gravity", "has no gravity"),
    ] {
        let damaged = with_edits(&human_text(), &[(old, new)]);
        let findings = floor_findings(&damaged);
        assert_eq!(codes_of(&findings), BTreeSet::from([code]), "{new}: {findings:#?}");
        let [finding] = findings.as_slice() else { panic!("{new}: {findings:#?}") };
        assert_eq!(finding["severity"], "error", "{new}");
        let message = finding["message"].as_str().unwrap();
        assert!(message.contains(says), "{new}: {message}");
        // For a model without gravity there is no proposal.
        if let Some(corrected) = corrected_text(&damaged, finding) {
            let remaining = floor_findings(&corrected);
            assert!(remaining.is_empty(), "{message}: {remaining:#?}");
        } else {
            assert_eq!(code, "no-gravity");
        }
    }
}

#[test]
fn a_slope_is_a_remark_and_carries_part_of_the_weight() {
    // 80 degrees from x, 10 from y; cos 10° = 0.984808.
    let slope = with_edits(
        &human_text(),
        &[(LEVEL_ORIENTATION, "<orientation>0 0 -1.3962634015954636</orientation>")],
    );
    let findings = floor_findings(&slope);
    assert_eq!(codes_of(&findings), BTreeSet::from(["floor-slopes"]), "{findings:#?}");
    assert_eq!(findings[0]["severity"], "remark");
    assert_eq!(findings[0]["message"], "floor is tilted by 10 degrees: 0.9848 of the weight presses on it");
    let load = |text: &str| {
        let dir = TestDir::new();
        dir.write("model.osim", text);
        let out = dir.run("inspect model.osim --format json").succeeded().out();
        let inspected: Value = serde_json::from_str(&out).unwrap();
        inspected["figures"]["limbs"][0]["spheres"][0]["load_n"].as_f64().unwrap()
    };
    let share = load(&slope) / load(&human_text());
    assert!((share - 10.0_f64.to_radians().cos()).abs() < 1e-12, "{share}");
    // Half a degree is level.
    let level = with_edits(
        &human_text(),
        &[(LEVEL_ORIENTATION, "<orientation>0 0 -1.5620696805349398</orientation>")],
    );
    assert_eq!((floor_findings(&level).len(), load(&level)), (0, load(&human_text())));
}

#[test]
fn a_design_on_a_slope_uses_the_weight_that_presses_on_it() {
    let dir = TestDir::new();
    dir.write(
        "model.osim",
        with_edits(
            &human_text(),
            &[(LEVEL_ORIENTATION, "<orientation>0 0 -1.1344640137963142</orientation>")],
        ),
    );
    dir.run("design model.osim --indentation 0.1 -o designed.osim").succeeded();
    let out = dir.run("inspect designed.osim --format json").succeeded().out();
    let inspected: Value = serde_json::from_str(&out).unwrap();
    let x = inspected["figures"]["limbs"][0]["spheres"][0]["relative_indentation_hertz"].as_f64().unwrap();
    assert!((x - 0.1).abs() < 1e-12, "{x}");
}

#[test]
fn a_drop_test_on_a_slope_uses_gravity_along_its_normal() {
    let dir = TestDir::new();
    dir.write(
        "slope.osim",
        with_edits(
            &human_text(),
            &[(LEVEL_ORIENTATION, "<orientation>0 0 -1.3962634015954636</orientation>")],
        ),
    );
    dir.write("level.osim", human_text());
    let gravity = |model: &str| {
        let out = dir.run(&format!("drop-test {model} --format json")).succeeded().out();
        serde_json::from_str::<Value>(&out).unwrap()["gravity_m_s2"].as_f64().unwrap()
    };
    let share = gravity("slope.osim") / gravity("level.osim");
    assert!((share - 10.0_f64.to_radians().cos()).abs() < 1e-12, "{share}");
}

const NET_PLANE: &str = "<ContactHalfSpace name=\"net\"><socket_frame>/ground</socket_frame><location>8 0 0</location>\
                   <orientation>0 0 0</orientation></ContactHalfSpace>";
const HAND_SPHERE: &str = "<ContactSphere name=\"palm_r\"><socket_frame>/bodyset/hand_r</socket_frame><location>0 0 0</location>\
                    <radius>0.03</radius></ContactSphere>";

fn force_element(name: &str, sphere: &str, plane: &str) -> String {
    format!(
        "<SmoothSphereHalfSpaceForce name=\"{name}\"><socket_sphere>/contactgeometryset/{sphere}</socket_sphere>\
         <socket_half_space>/contactgeometryset/{plane}</socket_half_space><stiffness>1e6</stiffness>\
         </SmoothSphereHalfSpaceForce>"
    )
}

/// Adds objects to the sets of a model: bodies, joints, forces and geometry.
fn with_objects(text: &str, [bodies, joints, forces, geometry]: [&str; 4]) -> String {
    with_edits(
        text,
        &[
            ("<Body name=\"ball\">", &format!("{bodies}<Body name=\"ball\">")),
            ("<FreeJoint name=\"ground_ball\">", &format!("{joints}<FreeJoint name=\"ground_ball\">")),
            ("<HuntCrossleyForce name=\"kick\">", &format!("{forces}<HuntCrossleyForce name=\"kick\">")),
            ("<ContactHalfSpace name=\"floor\">", &format!("{geometry}<ContactHalfSpace name=\"floor\">")),
        ],
    )
}

fn player_text() -> String {
    String::from_utf8(fixture("format/player_and_ball.osim")).unwrap()
}

fn body_element(name: &str) -> String {
    format!("<Body name=\"{name}\"><mass>1</mass></Body>")
}

/// The XML of a joint of `class`, at `place` on `parent`, that carries `child`. Its coordinate contains the XML `inside`.
fn joint_element(class: &str, (parent, place): (&str, &str), child: &str, inside: &str) -> String {
    format!(
        "<{class} name=\"{child}_joint\"><socket_parent_frame>p</socket_parent_frame><socket_child_frame>/bodyset/{child}\
         </socket_child_frame><coordinates><Coordinate name=\"{child}_q\">{inside}</Coordinate></coordinates><frames>\
         <PhysicalOffsetFrame name=\"p\"><socket_parent>{parent}</socket_parent><translation>{place}</translation>\
         </PhysicalOffsetFrame></frames></{class}>"
    )
}

#[test]
fn walls_and_platforms_cause_no_floor_errors() {
    let free = "<default_value>0</default_value>";
    let platform = |class, inside| {
        let moved =
            with_edits(&player_text(), &[(GROUND_FRAME, "<socket_frame>/bodyset/platform</socket_frame>")]);
        with_objects(
            &moved,
            [
                &body_element("platform"),
                &joint_element(class, ("/ground", "0 0 0"), "platform", inside),
                "",
                "",
            ],
        )
    };
    let net = with_objects(&player_text(), ["", "", &force_element("ball_net", "ball", "net"), NET_PLANE]);
    let hand_joint = joint_element("PinJoint", ("/bodyset/pelvis", "0.4 0.3 0.2"), "hand_r", free);
    let hand = [
        &body_element("hand_r"),
        &hand_joint,
        &force_element("palm_wall", "palm_r", "net"),
        &format!("{NET_PLANE}{HAND_SPHERE}"),
    ];
    // A rock on the platform does not move in ground while both are locked, nor against the platform's plane.
    let locked = format!("{free}<locked>true</locked>");
    let rock = HAND_SPHERE.replace("palm_r", "rock").replace("hand_r", "rock");
    let rocky = with_objects(
        &platform("SliderJoint", &locked),
        [
            &body_element("rock"),
            &joint_element("PinJoint", ("/bodyset/platform", "1 0 0"), "rock", &locked),
            &force_element("rock_floor", "rock", "floor"),
            &rock,
        ],
    );
    for (what, text) in [
        ("a player and a ball", player_text()),
        ("a net that a ball meets", net.clone()),
        (
            "a net and a ball that never touches the floor",
            with_edits(
                &net,
                &[(
                    "<socket_half_space>/contactgeometryset/floor</socket_half_space>\n\t\t\t\t\t<stiffness>50000<",
                    "<socket_half_space>/contactgeometryset/net</socket_half_space><stiffness>50000<",
                )],
            ),
        ),
        ("a wall for a hand", with_objects(&player_text(), hand.map(String::as_str))),
        ("a platform that slides", platform("SliderJoint", free)),
        ("a rock on the platform", rocky),
    ] {
        let findings = floor_findings(&text);
        assert!(findings.is_empty(), "{what}: {findings:#?}");
    }
    // A platform that tilts about z by 0.2 rad, 11.46 degrees, is a slope.
    let tilted = floor_findings(&platform("PinJoint", "<default_value>0.2</default_value>"));
    assert_eq!(codes_of(&tilted), BTreeSet::from(["floor-slopes"]));
    assert!(tilted[0]["message"].as_str().unwrap().contains("11.5 degrees"), "{tilted:#?}");
}

#[test]
fn only_the_expected_fixtures_have_floor_findings() {
    let mut findings = BTreeSet::new();
    let mut models = 0;
    for folder in ["check", "format", "table1", "scale_tool", "drawn_feet", "feet", "walks"] {
        for entry in std::fs::read_dir(root().join("fixtures").join(folder)).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            let dir = TestDir::new();
            if !name.ends_with(".osim") {
                continue;
            }
            dir.write("model.osim", fixture(&format!("{folder}/{name}")));
            let out = dir.run("check model.osim --format json").out();
            // Some cannot be read alone, or have no contacts.
            let Ok(report) = serde_json::from_str::<Value>(&out) else { continue };
            models += 1;
            let codes =
                report["findings"].as_array().into_iter().flatten().map(|one| one["code"].as_str().unwrap());
            findings.extend(
                codes
                    .filter(|code| CODES_ABOUT_FLOORS.contains(code))
                    .map(|code| format!("{folder}/{name} {code}")),
            );
        }
    }
    assert!(models > 100, "{models}");
    let expected = [
        "check/angle_in_degrees.osim angle-in-degrees",
        "check/floor_on_limb.osim floor-on-limb",
        "check/floor_slopes.osim floor-slopes",
        "check/floor_upright.osim floor-upright",
        "check/floor_upside_down.osim floor-upside-down",
        "check/gravity_in_millimetres.osim gravity-too-large",
        "check/gravity_sideways.osim gravity-not-down",
        "check/gravity_up.osim gravity-not-down",
        // Gravity along z over a floor that faces y; a plane on the pelvis, which is called a wall and is the only one.
        "format/gravity_sideways.osim gravity-not-down",
        "format/no_gravity.osim no-gravity",
        "format/only_wall.osim floor-on-limb",
    ];
    assert_eq!(findings, expected.map(str::to_owned).into());
}

#[test]
fn no_published_model_has_a_floor_error() {
    let Some(folder) = corpus_folder("no_published_model_has_a_floor_error") else { return };
    let mut models = 0;
    let mut slopes = BTreeSet::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|end| end != "osim") {
            continue;
        }
        let dir = TestDir::new();
        dir.write("model.osim", std::fs::read(&path).unwrap());
        let out = dir.run("check model.osim --format json").out();
        let report: Value = serde_json::from_str(&out).unwrap_or(Value::Null);
        for finding in report["findings"].as_array().into_iter().flatten() {
            let code = finding["code"].as_str().unwrap();
            if code == "floor-slopes" {
                slopes.insert(finding["message"].as_str().unwrap().to_owned());
            } else {
                assert!(!CODES_ABOUT_FLOORS.contains(&code), "{}: {finding:#}", path.display());
            }
        }
        let findings = report["findings"].as_array();
        let has_contacts = |findings: &Vec<Value>| findings.iter().all(|one| one["code"] != "bare-model");
        models += usize::from(findings.is_some_and(has_contacts));
    }
    // Of 26 models eight have no contacts, so there is nothing to judge, and one has an ElasticFoundationForce. Two platforms are turned: by a coordinate of 0.349066 rad, which
    // is 20 degrees, and by one of 10 degrees.
    assert_eq!(models, 18);
    let expected = [
        "PlatformContact is tilted by 10 degrees: 0.9848 of the weight presses on it",
        "platform_surface is tilted by 20 degrees: 0.9397 of the weight presses on it",
    ];
    assert_eq!(slopes, expected.map(str::to_owned).into());
}

/// The only body of the model is a ball without limbs.
#[test]
fn a_ball_without_a_level_floor_is_an_error() {
    let ball = String::from_utf8(fixture("check/within_limits.osim")).unwrap();
    let ball = ball
        .replace("calcn_r", "ball")
        .replace("heel_r", "ball_surface")
        .replace("0.01 -0.02 0.003", "0 0 0");
    for (old, new, expected) in [
        (LEVEL_ORIENTATION, LEVEL_ORIENTATION, None),
        (LEVEL_ORIENTATION, "<orientation>0 0 0</orientation>", Some("floor-upright")),
        (LEVEL_ORIENTATION, "<orientation>0 0 1.5707963267948966</orientation>", Some("floor-upside-down")),
        ("<gravity>0 -9.81 0</gravity>", "<gravity>0 9.81 0</gravity>", Some("gravity-not-down")),
    ] {
        let findings = floor_findings(&with_edits(&ball, &[(old, new)]));
        assert_eq!(codes_of(&findings), expected.into_iter().collect(), "{new}: {findings:#?}");
    }
}

/// `text` with another value in the first element `tag` after `from`; `None` if there is none.
fn with_element_replaced(text: &str, from: &str, tag: &str, value: &str) -> Option<String> {
    let (open, close) = (format!("<{tag}>"), format!("</{tag}>"));
    let begin = text.find(from)?;
    let start = begin + text[begin..].find(&open)? + open.len();
    let end = start + text[start..].find(&close)?;
    Some(format!("{}{value}{}", &text[..start], &text[end..]))
}

#[test]
fn each_floor_error_in_a_published_model_is_named() {
    let Some(folder) = corpus_folder("each_floor_error_in_a_published_model_is_named") else { return };
    let mut damaged = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let is_model = path.extension().is_some_and(|end| end == "osim");
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        let has_contacts =
            ["<HuntCrossleyForce ", "<SmoothSphereHalfSpaceForce "].iter().any(|tag| text.contains(tag));
        if !is_model || !has_contacts {
            continue;
        }
        let unchanged = floor_findings(&text);
        let plane = "<ContactHalfSpace name";
        let turned = |angles| with_element_replaced(&text, plane, "orientation", angles);
        let gravity = |vector| with_element_replaced(&text, "<Model", "gravity", vector);
        let on_pelvis = || {
            text.contains("<Body name=\"pelvis\">").then_some(())?;
            let old = text[text.find(plane)?..].split("</ContactHalfSpace>").next()?.contains("<body_name>");
            let (tag, value) =
                if old { ("body_name", "pelvis") } else { ("socket_frame", "/bodyset/pelvis") };
            with_element_replaced(&text, plane, tag, value)
        };
        for (what, model, code) in [
            ("upright", turned("0 0 0"), "floor-upright"),
            ("upright to the side", turned("0 1.5707963 0"), "floor-upright"),
            ("upside down", turned("0 0 1.5707963"), "floor-upside-down"),
            ("in degrees", turned("0 0 -90"), "angle-in-degrees"),
            ("10 degrees", turned("0 0 -1.7453293"), "floor-slopes"),
            ("on the pelvis", on_pelvis(), "floor-on-limb"),
            ("gravity up", gravity("0 9.80665 0"), "gravity-not-down"),
            ("gravity ahead", gravity("9.80665 0 0"), "gravity-not-down"),
            ("gravity to the side", gravity("0 0 -9.80665"), "gravity-not-down"),
            ("gravity in mm/s2", gravity("0 -9810 0"), "gravity-too-large"),
            ("no gravity", gravity("0 0 0"), "no-gravity"),
        ] {
            let Some(model) = model else { continue };
            let mut findings = floor_findings(&model);
            // Two platforms have slopes without these errors.
            findings.retain(|finding| {
                finding["code"] == code || !codes_of(&unchanged).contains(finding["code"].as_str().unwrap())
            });
            assert_eq!(
                codes_of(&findings),
                BTreeSet::from([code]),
                "{}, {what}: {findings:#?}",
                path.display()
            );
            damaged += 1;
        }
    }
    // 17 models in 11 ways; a pelvis is in 12 of them, and a <gravity> in 16.
    assert_eq!(damaged, 177);
}

#[test]
fn nothing_is_levelled_along_a_gravity_that_points_out_of_the_floor() {
    let dir = TestDir::with(&[
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
    ]);
    let scaled = dir.text("scaled.osim");
    let (before, rest) = scaled.split_once("<gravity>").unwrap();
    let (_, after) = rest.split_once("</gravity>").unwrap();
    dir.write("up.osim", format!("{before}<gravity>0 9.81 0</gravity>{after}"));
    let report = dir.run("check up.osim --from generic.osim --format json").out();
    let report: Value = serde_json::from_str(&report).unwrap();
    assert_eq!(report["commands"], Value::Array(Vec::new()));
    // Gravity is down again: the command is there.
    let right = dir.run("check scaled.osim --from generic.osim").out();
    assert!(right.contains("transfer scaled.osim --from generic.osim --follow-bodies --level"), "{right}");
    for call in [
        "rescale up.osim --target-mass 70 --contacts-mass 62",
        "transfer up.osim --from generic.osim --follow-bodies",
    ] {
        let run = dir.run(&format!("{call} --level -o out.osim")).failed().wrote_nothing();
        assert!(run.err().contains("points out of the floor, not into it"), "{}", run.err());
        // Without the option, spheres that follow bodies keep their lowest points, too.
        let follows = call.contains("--follow-bodies");
        assert_eq!(dir.run(&format!("{call} --dry-run")).err().contains("points out of"), follows);
        dir.run(&format!("{call} --level --level-axis y -o out.osim")).succeeded();
        std::fs::remove_file(dir.path("out.osim")).unwrap();
    }
}
