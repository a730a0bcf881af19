//! `check`: whether a floor is a floor, and gravity points into it.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::support::{Bench, HUMAN, corpus, fixture, root};

/// What is said of floors and gravity.
const CODES: [&str; 8] = [
    "angle-in-degrees",
    "gravity-too-large",
    "gravity-not-down",
    "floor-upside-down",
    "floor-upright",
    "floor-on-limb",
    "floor-slopes",
    "no-gravity",
];
const LEVEL: &str = "<orientation>0 0 -1.5707963267948966</orientation>";
const FRAME: &str = "<socket_frame>/ground</socket_frame>";
const GRAVITY: &str = "<gravity>0 -9.8100000000000005 0</gravity>";

fn edited(text: &str, edits: &[(&str, &str)]) -> String {
    edits.iter().fold(text.to_owned(), |text, (old, new)| {
        assert!(text.contains(old), "the model has no {old}");
        text.replacen(old, new, 1)
    })
}

/// The findings about floors and gravity in a model.
fn found(text: &str) -> Vec<Value> {
    let bench = Bench::new();
    bench.write("model.osim", text);
    let out = bench.run("check model.osim --format json").wrote_nothing().out();
    let report: Value = serde_json::from_str(&out).unwrap_or_else(|error| panic!("{error}: {out}"));
    let all = report["findings"].as_array().unwrap().iter();
    all.filter(|finding| CODES.contains(&finding["code"].as_str().unwrap())).cloned().collect()
}

fn codes(found: &[Value]) -> BTreeSet<&str> {
    found.iter().map(|finding| finding["code"].as_str().unwrap()).collect()
}

fn human() -> String {
    String::from_utf8(fixture(HUMAN.0)).unwrap()
}

/// The model with what its finding says to write, on the line that it names.
fn mended(text: &str, finding: &Value) -> Option<String> {
    let message = finding["message"].as_str().unwrap();
    let (_, written) = message.split_once("write <")?;
    let (tag, rest) = written.split_once('>').unwrap();
    let (value, _) = rest.split_once("</").unwrap();
    let line = usize::try_from(finding["line"].as_u64().unwrap()).unwrap() - 1;
    let lines = text.lines().enumerate().map(|(index, own)| {
        if index != line {
            return own.to_owned();
        }
        assert!(own.contains(&format!("<{tag}>")), "line {}: {own}, expected <{tag}>", line + 1);
        format!("<{tag}>{value}</{tag}>")
    });
    Some(lines.collect::<Vec<_>>().join("\n"))
}

#[test]
fn each_damage_is_named_and_what_is_said_mends_it() {
    for (old, new, code, says) in [
        (LEVEL, "<orientation>0 0 0</orientation>", "floor-upright", "90 degrees away from up"),
        (
            LEVEL,
            "<orientation>0 1.5707963267948966 0</orientation>",
            "floor-upright",
            "90 degrees away from up",
        ),
        (
            LEVEL,
            "<orientation>0 0 1.5707963267948966</orientation>",
            "floor-upside-down",
            "180 degrees away from up",
        ),
        (
            LEVEL,
            "<orientation>0 0 -90</orientation>",
            "angle-in-degrees",
            "<orientation>0 0 -1.5707963</orientation>",
        ),
        (FRAME, "<socket_frame>/bodyset/pelvis</socket_frame>", "floor-on-limb", "hangs on pelvis"),
        (FRAME, "<socket_frame>/bodyset/tibia_l</socket_frame>", "floor-on-limb", "hangs on tibia_l"),
        (GRAVITY, "<gravity>0 9.81 0</gravity>", "gravity-not-down", "out of the floor"),
        (GRAVITY, "<gravity>9.81 0 0</gravity>", "gravity-not-down", "along the floor"),
        (GRAVITY, "<gravity>0 -9810 0</gravity>", "gravity-too-large", "<gravity>0 -9.81 0</gravity>"),
        (GRAVITY, "<gravity>0 -981 0</gravity>", "gravity-too-large", "<gravity>0 -9.81 0</gravity>"),
        (GRAVITY, "<gravity>0 0 0</gravity>", "no-gravity", "has no gravity"),
    ] {
        let damaged = edited(&human(), &[(old, new)]);
        let seen = found(&damaged);
        assert_eq!(codes(&seen), BTreeSet::from([code]), "{new}: {seen:#?}");
        let [finding] = seen.as_slice() else { panic!("{new}: {seen:#?}") };
        assert_eq!(finding["severity"], "error", "{new}");
        let message = finding["message"].as_str().unwrap();
        assert!(message.contains(says), "{new}: {message}");
        // Without gravity only its owner knows which is meant.
        if let Some(mended) = mended(&damaged, finding) {
            let left = found(&mended);
            assert!(left.is_empty(), "{message}: {left:#?}");
        } else {
            assert_eq!(code, "no-gravity");
        }
    }
}

#[test]
fn a_slope_is_a_remark_and_carries_a_part_of_the_weight() {
    // 80 degrees from x, 10 from y; cos 10° = 0.984808.
    let slope = edited(&human(), &[(LEVEL, "<orientation>0 0 -1.3962634015954636</orientation>")]);
    let seen = found(&slope);
    assert_eq!(codes(&seen), BTreeSet::from(["floor-slopes"]), "{seen:#?}");
    assert_eq!(seen[0]["severity"], "remark");
    assert_eq!(seen[0]["message"], "floor leans by 10 degrees: 0.9848 of the weight presses on it");
    let load = |text: &str| {
        let bench = Bench::new();
        bench.write("model.osim", text);
        let out = bench.run("inspect model.osim --format json").done().out();
        let inspected: Value = serde_json::from_str(&out).unwrap();
        inspected["figures"]["limbs"][0]["spheres"][0]["load_n"].as_f64().unwrap()
    };
    let share = load(&slope) / load(&human());
    assert!((share - 10.0_f64.to_radians().cos()).abs() < 1e-12, "{share}");
    // Half a degree is level.
    let level = edited(&human(), &[(LEVEL, "<orientation>0 0 -1.5620696805349398</orientation>")]);
    assert_eq!((found(&level).len(), load(&level)), (0, load(&human())));
}

#[test]
fn a_design_on_a_slope_is_for_the_part_of_the_weight_that_presses() {
    let bench = Bench::new();
    bench.write(
        "model.osim",
        edited(&human(), &[(LEVEL, "<orientation>0 0 -1.1344640137963142</orientation>")]),
    );
    bench.run("design model.osim --indentation 0.1 -o designed.osim").done();
    let out = bench.run("inspect designed.osim --format json").done().out();
    let inspected: Value = serde_json::from_str(&out).unwrap();
    let x = inspected["figures"]["limbs"][0]["spheres"][0]["relative_indentation_hertz"].as_f64().unwrap();
    assert!((x - 0.1).abs() < 1e-12, "{x}");
}

#[test]
fn a_body_falls_on_a_slope_by_the_part_of_gravity_along_its_normal() {
    let bench = Bench::new();
    bench.write(
        "slope.osim",
        edited(&human(), &[(LEVEL, "<orientation>0 0 -1.3962634015954636</orientation>")]),
    );
    bench.write("level.osim", human());
    let gravity = |model: &str| {
        let out = bench.run(&format!("drop-test {model} --format json")).done().out();
        serde_json::from_str::<Value>(&out).unwrap()["gravity_m_s2"].as_f64().unwrap()
    };
    let share = gravity("slope.osim") / gravity("level.osim");
    assert!((share - 10.0_f64.to_radians().cos()).abs() < 1e-12, "{share}");
}

const NET: &str = "<ContactHalfSpace name=\"net\"><socket_frame>/ground</socket_frame><location>8 0 0</location>\
                   <orientation>0 0 0</orientation></ContactHalfSpace>";
const HAND: &str = "<ContactSphere name=\"palm_r\"><socket_frame>/bodyset/hand_r</socket_frame><location>0 0 0</location>\
                    <radius>0.03</radius></ContactSphere>";

fn force(name: &str, sphere: &str, plane: &str) -> String {
    format!(
        "<SmoothSphereHalfSpaceForce name=\"{name}\"><socket_sphere>/contactgeometryset/{sphere}</socket_sphere>\
         <socket_half_space>/contactgeometryset/{plane}</socket_half_space><stiffness>1e6</stiffness>\
         </SmoothSphereHalfSpaceForce>"
    )
}

/// Adds objects to the sets of a model: bodies, joints, forces and geometry.
fn with(text: &str, [bodies, joints, forces, geometry]: [&str; 4]) -> String {
    edited(
        text,
        &[
            ("<Body name=\"ball\">", &format!("{bodies}<Body name=\"ball\">")),
            ("<FreeJoint name=\"ground_ball\">", &format!("{joints}<FreeJoint name=\"ground_ball\">")),
            ("<HuntCrossleyForce name=\"kick\">", &format!("{forces}<HuntCrossleyForce name=\"kick\">")),
            ("<ContactHalfSpace name=\"floor\">", &format!("{geometry}<ContactHalfSpace name=\"floor\">")),
        ],
    )
}

fn player() -> String {
    String::from_utf8(fixture("format/player_and_ball.osim")).unwrap()
}

fn body(name: &str) -> String {
    format!("<Body name=\"{name}\"><mass>1</mass></Body>")
}

/// A joint of `class` above `child`, which is at `place` on `parent`; its coordinate has this `inside`.
fn joint(class: &str, (parent, place): (&str, &str), child: &str, inside: &str) -> String {
    format!(
        "<{class} name=\"{child}_joint\"><socket_parent_frame>p</socket_parent_frame><socket_child_frame>/bodyset/{child}\
         </socket_child_frame><coordinates><Coordinate name=\"{child}_q\">{inside}</Coordinate></coordinates><frames>\
         <PhysicalOffsetFrame name=\"p\"><socket_parent>{parent}</socket_parent><translation>{place}</translation>\
         </PhysicalOffsetFrame></frames></{class}>"
    )
}

#[test]
fn walls_and_platforms_are_what_they_should_be() {
    let free = "<default_value>0</default_value>";
    let platform = |class, inside| {
        let moved = edited(&player(), &[(FRAME, "<socket_frame>/bodyset/platform</socket_frame>")]);
        with(&moved, [&body("platform"), &joint(class, ("/ground", "0 0 0"), "platform", inside), "", ""])
    };
    let net = with(&player(), ["", "", &force("ball_net", "ball", "net"), NET]);
    let hand_joint = joint("PinJoint", ("/bodyset/pelvis", "0.4 0.3 0.2"), "hand_r", free);
    let hand = [&body("hand_r"), &hand_joint, &force("palm_wall", "palm_r", "net"), &format!("{NET}{HAND}")];
    // A rock on the platform does not move in ground while both are locked, nor against the platform's plane.
    let locked = format!("{free}<locked>true</locked>");
    let rock = HAND.replace("palm_r", "rock").replace("hand_r", "rock");
    let rocky = with(
        &platform("SliderJoint", &locked),
        [
            &body("rock"),
            &joint("PinJoint", ("/bodyset/platform", "1 0 0"), "rock", &locked),
            &force("rock_floor", "rock", "floor"),
            &rock,
        ],
    );
    for (what, text) in [
        ("a player and a ball", player()),
        ("a net that a ball meets", net.clone()),
        (
            "a net and a ball that never touches the floor",
            edited(
                &net,
                &[(
                    "<socket_half_space>/contactgeometryset/floor</socket_half_space>\n\t\t\t\t\t<stiffness>50000<",
                    "<socket_half_space>/contactgeometryset/net</socket_half_space><stiffness>50000<",
                )],
            ),
        ),
        ("a wall for a hand", with(&player(), hand.map(String::as_str))),
        ("a platform that slides", platform("SliderJoint", free)),
        ("a rock on the platform", rocky),
    ] {
        let seen = found(&text);
        assert!(seen.is_empty(), "{what}: {seen:#?}");
    }
    // A platform that tilts about z by 0.2 rad, 11.46 degrees, is a slope.
    let tilted = found(&platform("PinJoint", "<default_value>0.2</default_value>"));
    assert_eq!(codes(&tilted), BTreeSet::from(["floor-slopes"]));
    assert!(tilted[0]["message"].as_str().unwrap().contains("11.5 degrees"), "{tilted:#?}");
}

#[test]
fn floors_of_fixtures_are_floors() {
    let mut seen = BTreeSet::new();
    let mut models = 0;
    for folder in ["check", "format", "table1", "scale_tool", "drawn_feet", "feet", "walks"] {
        for entry in std::fs::read_dir(root().join("fixtures").join(folder)).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            let bench = Bench::new();
            if !name.ends_with(".osim") {
                continue;
            }
            bench.write("model.osim", fixture(&format!("{folder}/{name}")));
            let out = bench.run("check model.osim --format json").out();
            // Some cannot be read alone, or have no contacts.
            let Ok(report) = serde_json::from_str::<Value>(&out) else { continue };
            models += 1;
            let codes =
                report["findings"].as_array().into_iter().flatten().map(|one| one["code"].as_str().unwrap());
            seen.extend(
                codes.filter(|code| CODES.contains(code)).map(|code| format!("{folder}/{name} {code}")),
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
    assert_eq!(seen, expected.map(str::to_owned).into());
}

#[test]
fn no_real_model_has_a_floor_that_is_none() {
    let Some(folder) = corpus("no_real_model_has_a_floor_that_is_none") else { return };
    let mut models = 0;
    let mut slopes = BTreeSet::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|end| end != "osim") {
            continue;
        }
        let bench = Bench::new();
        bench.write("model.osim", std::fs::read(&path).unwrap());
        let out = bench.run("check model.osim --format json").out();
        let report: Value = serde_json::from_str(&out).unwrap_or(Value::Null);
        for finding in report["findings"].as_array().into_iter().flatten() {
            let code = finding["code"].as_str().unwrap();
            if code == "floor-slopes" {
                slopes.insert(finding["message"].as_str().unwrap().to_owned());
            } else {
                assert!(!CODES.contains(&code), "{}: {finding:#}", path.display());
            }
        }
        let findings = report["findings"].as_array();
        let has_contacts = |all: &Vec<Value>| all.iter().all(|one| one["code"] != "bare-model");
        models += usize::from(findings.is_some_and(has_contacts));
    }
    // Of 26 models nine have no contacts, so there is nothing to judge. Two platforms are turned: by a coordinate of 0.349066 rad, which
    // is 20 degrees, and by one of 10 degrees.
    assert_eq!(models, 17);
    let expected = [
        "PlatformContact leans by 10 degrees: 0.9848 of the weight presses on it",
        "platform_surface leans by 20 degrees: 0.9397 of the weight presses on it",
    ];
    assert_eq!(slopes, expected.map(str::to_owned).into());
}

/// A ball alone: it has no limb, but nothing else has a floor either.
#[test]
fn a_ball_without_any_floor_falls_for_ever() {
    let ball = String::from_utf8(fixture("check/within_limits.osim")).unwrap();
    let ball = ball
        .replace("calcn_r", "ball")
        .replace("heel_r", "ball_surface")
        .replace("0.01 -0.02 0.003", "0 0 0");
    for (old, new, expected) in [
        (LEVEL, LEVEL, None),
        (LEVEL, "<orientation>0 0 0</orientation>", Some("floor-upright")),
        (LEVEL, "<orientation>0 0 1.5707963267948966</orientation>", Some("floor-upside-down")),
        ("<gravity>0 -9.81 0</gravity>", "<gravity>0 9.81 0</gravity>", Some("gravity-not-down")),
    ] {
        let seen = found(&edited(&ball, &[(old, new)]));
        assert_eq!(codes(&seen), expected.into_iter().collect(), "{new}: {seen:#?}");
    }
}

/// `text` with what is between the first `<tag>` after `from` and its end replaced; `None` where there is none.
fn replaced(text: &str, from: &str, tag: &str, value: &str) -> Option<String> {
    let (open, close) = (format!("<{tag}>"), format!("</{tag}>"));
    let begin = text.find(from)?;
    let start = begin + text[begin..].find(&open)? + open.len();
    let end = start + text[start..].find(&close)?;
    Some(format!("{}{value}{}", &text[..start], &text[end..]))
}

#[test]
fn each_damage_of_a_real_model_is_named() {
    let Some(folder) = corpus("each_damage_of_a_real_model_is_named") else { return };
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
        let own = found(&text);
        let plane = "<ContactHalfSpace name";
        let turned = |angles| replaced(&text, plane, "orientation", angles);
        let gravity = |vector| replaced(&text, "<Model", "gravity", vector);
        let on_pelvis = || {
            text.contains("<Body name=\"pelvis\">").then_some(())?;
            let old = text[text.find(plane)?..].split("</ContactHalfSpace>").next()?.contains("<body_name>");
            let (tag, value) =
                if old { ("body_name", "pelvis") } else { ("socket_frame", "/bodyset/pelvis") };
            replaced(&text, plane, tag, value)
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
            let mut seen = found(&model);
            // Two platforms are slopes as they are.
            seen.retain(|finding| {
                finding["code"] == code || !codes(&own).contains(finding["code"].as_str().unwrap())
            });
            assert_eq!(codes(&seen), BTreeSet::from([code]), "{}, {what}: {seen:#?}", path.display());
            damaged += 1;
        }
    }
    // 17 models in 11 ways; a pelvis is in 12 of them, and a <gravity> in 16.
    assert_eq!(damaged, 177);
}
