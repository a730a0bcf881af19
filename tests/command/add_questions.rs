//! Questions that `add` asks before it writes: about feet that do not lie flat, and about numbers that are probably in another unit.

use crate::support::TestDir;

const MESHES: [&str; 4] = ["l_human_foot", "l_human_toes", "r_human_foot", "r_human_toes"];
const UNDER_BONES: &str = "--feet calcn_r,toes_r,calcn_l,toes_l --from falisse2022";

fn human_with_meshes() -> TestDir {
    let dir =
        TestDir::with(&[("feet/human_40000.osim", "human.osim"), ("contact_tables/own.csv", "own.csv")]);
    for mesh in MESHES {
        let file = format!("Geometry/{mesh}.vtp");
        dir.write(&file, crate::support::fixture(&format!("feet/{file}")));
    }
    dir
}

/// `human.osim` with other default values of some coordinates.
fn write_posed_model(dir: &TestDir, name: &str, values: &[(&str, f64)]) {
    let mut text = dir.text("human.osim");
    for (coordinate, value) in values {
        let (before, after) = text.split_once(&format!("<Coordinate name=\"{coordinate}\">")).unwrap();
        let after = after.replacen(
            "<default_value>0</default_value>",
            &format!("<default_value>{value}</default_value>"),
            1,
        );
        text = format!("{before}<Coordinate name=\"{coordinate}\">{after}");
    }
    dir.write(name, text);
}

/// Asserts that the call asks in one line with all of `words`, ends with exit status 1, and writes nothing.
#[track_caller]
fn assert_asks(dir: &TestDir, call: &str, words: &[&str]) {
    let run = dir.run(call).failed().wrote_nothing().says(words);
    assert_eq!(run.err().lines().filter(|line| line.starts_with("error: ")).count(), 1, "{}", run.err());
}

/// With ankles at 0.2 rad only the heel is near a level plane. 0.2 rad are 11.5 degrees, and the bones' own sole rises by nearly 1 degree.
#[test]
fn add_asks_about_a_foot_that_is_not_flat() {
    let dir = human_with_meshes();
    write_posed_model(&dir, "ankles.osim", &[("calcn_r_angle", 0.2), ("calcn_l_angle", 0.2)]);
    let call = format!("add ankles.osim {UNDER_BONES} --count 6 --pad 0.02");
    assert_asks(
        &dir,
        &call,
        &[
            "the foot of calcn_r, toes_r does not lie flat at the default pose: its front is 12.1 degrees up",
            "bones near the ground cover 25 % of its length and 40 % of its width, expected at most 10 degrees, and 80 % or more",
            "set default values of its joints at which it does, such as 0 (now calcn_r_angle = 0.2 rad)",
            "if it is correct, confirm it with --yes tilted-foot",
        ],
    );
    dir.run(&format!("{call} --yes tilted-foot -o meant.osim")).succeeded();
    // Turning both feet about the vertical (pelvis_list), lifting them or turning them level again causes no question.
    write_posed_model(&dir, "turned.osim", &[("pelvis_list", 0.4), ("pelvis_tx", 0.1)]);
    dir.run(&format!("add turned.osim {UNDER_BONES} --count 6 --pad 0.02 --dry-run")).succeeded();
    write_posed_model(
        &dir,
        "bent.osim",
        &[("tibia_r_angle", -0.3), ("calcn_r_angle", 0.3), ("tibia_l_angle", -0.3), ("calcn_l_angle", 0.3)],
    );
    dir.run(&format!("add bent.osim {UNDER_BONES} --count 6 --pad 0.02 --dry-run")).succeeded();
    // A tilt of 0.05 rad is accepted.
    write_posed_model(&dir, "nearly.osim", &[("calcn_r_angle", 0.05), ("calcn_l_angle", 0.05)]);
    dir.run(&format!("add nearly.osim {UNDER_BONES} --count 6 --pad 0.02 --dry-run")).succeeded();
}

/// The left foot is flat and the right foot is tilted, so both feet would get different spheres.
#[test]
fn add_asks_if_only_one_foot_is_tilted() {
    let dir = human_with_meshes();
    write_posed_model(
        &dir,
        "right.osim",
        &[("calcn_r_angle", 0.4), ("toes_r_angle", -0.4), ("pelvis_list", 0.1), ("pelvis_rotation", 0.01)],
    );
    assert_asks(
        &dir,
        &format!("add right.osim {UNDER_BONES} --count 4 --pad 0.01"),
        &[
            "the foot of calcn_r, toes_r does not lie flat",
            // In the order from the foot up; a coordinate about the vertical tilts nothing.
            "(now calcn_r_angle = 0.4 rad, toes_r_angle = -0.4 rad, pelvis_rotation = 0.01 rad)",
        ],
    );
}

/// The right heel is turned on its leg, without a coordinate that could be set.
#[test]
fn add_proposes_a_table_if_no_coordinate_tilts_the_foot() {
    let dir = human_with_meshes();
    let text = dir.text("human.osim");
    let (before, after) = text.split_once("<PinJoint name=\"calcn_r_joint\">").unwrap();
    let after =
        after.replacen("<orientation>0 -0.12 0</orientation>", "<orientation>-0.3 -0.12 0</orientation>", 1);
    dir.write("turned.osim", format!("{before}<PinJoint name=\"calcn_r_joint\">{after}"));
    assert_asks(
        &dir,
        &format!("add turned.osim {UNDER_BONES} --count 4 --pad 0.01"),
        &[
            "does not lie flat at the default pose: its outer side is",
            "name the bodies that touch the ground with --feet BODY,BODY, or give the places in a table, --contacts TABLE",
        ],
    );
}

#[test]
fn names_and_sizes_that_opensim_cannot_use_are_refused() {
    let dir = human_with_meshes();
    for (name, words) in [
        (".", "the name '.' is a step in OpenSim's paths"),
        ("..", "the name '..' is a step in OpenSim's paths"),
        ("heel\u{1b}[31m_r", "(U+001B)"),
        ("heel\u{202e}_r", "(U+202E)"),
    ] {
        dir.write("t.csv", format!("name,body,x,y,z,radius\n{name},calcn_r,0,0,0,0.03\n"));
        let call = "add human.osim --contacts t.csv --from falisse2022 --spheres 2";
        assert_asks(&dir, call, &["t.csv:2:1", "column 'name'", words, "choose letters, digits, '_' or '-'"]);
    }
    dir.write("t.csv", "name,body,x,y,z,radius\na,calcn_r,1e308,0,0,0.03\n");
    assert_asks(
        &dir,
        "add human.osim --contacts t.csv --from falisse2022",
        &["t.csv:2:3", "column 'x': '1e308' is beyond 1e9, expected metres"],
    );
    for (call, words) in [
        (
            format!("add human.osim {UNDER_BONES} --count 2 --pad 1e300"),
            "--pad 1e300: expected metres, at most 1e9",
        ),
        (
            format!("add human.osim {UNDER_BONES} --count 2 --pad 0 --radius 1e300"),
            "a radius in metres, at most 1e9",
        ),
        ("add human.osim --from falisse2022 --body-scale calcn_r=1e300".to_owned(), "each from 1e-9 to 1e9"),
    ] {
        dir.run(&call).usage_error().wrote_nothing().says(&[words]);
    }
}

/// The ball is 0.16, 0.005, 0.02 m from the heel's origin and its joint: 0.1613 m; in millimetres that would be 161.3 m, in centimetres
/// 16.13 m, and the shank is less than half a metre long.
#[test]
fn add_asks_about_places_in_another_unit() {
    let dir = human_with_meshes();
    let table = |name: &str, x: f64| {
        let [x, y, z] = [x, x / 32.0, x / 8.0];
        dir.write(
            name,
            format!("name,body,x,y,z,radius\nheel_r,calcn_r,0,0,0,0.03\nball_r,calcn_r,{x},{y},{z},0.03\n"),
        );
    };
    for (name, x, says) in [
        ("mm.csv", 160.0, "places are in m, divide them by 1000 if they are in mm; if"),
        ("cm.csv", 16.0, "places are in m, divide them by 100 if they are in cm; if"),
    ] {
        table(name, x);
        let call = format!("add human.osim --contacts {name} --from falisse2022");
        let far =
            format!("{name}, line 3: ball_r would be {} m from the nearest joint of calcn_r", x * 1.00828);
        let far = far.split_once('.').unwrap().0.to_owned();
        assert_asks(&dir, &call, &[&far, says, "confirm it with --yes implausible-place"]);
        dir.run(&format!("{call} --yes implausible-place -o out.osim --force")).succeeded();
    }
    table("metres.csv", 0.16);
    dir.run("add human.osim --contacts metres.csv --from falisse2022 --dry-run").succeeded();
    // Radii of new spheres: 30 is in millimetres, 3 in centimetres, 10 may be in both.
    for (radius, says) in [
        ("30", "write 0.03 if it is in mm; if"),
        ("3", "write 0.03 if it is in cm; if"),
        ("10", "write 0.01 if it is in mm, or 0.1 if it is in cm; if"),
    ] {
        dir.write("r.csv", format!("name,body,x,y,z,radius\nheel_r,calcn_r,0,0,0,{radius}\n"));
        assert_asks(&dir, "add human.osim --contacts r.csv --from falisse2022", &["radii are in m", says]);
    }
}

/// The program asks about a pad that is thicker than the foot is long, which is 0.25 m.
#[test]
fn add_asks_about_a_sole_far_below_the_bones() {
    let dir = human_with_meshes();
    let call = format!("add human.osim {UNDER_BONES} --count 4 --pad");
    for (pad, says) in [
        ("20", "it is in m, write 0.02 if it is in mm; if"),
        ("1.3", "it is in m, write 0.013 if it is in cm; if"),
        ("5", "it is in m, write 0.005 if it is in mm, or 0.05 if it is in cm; if"),
        ("0.27", "it is in m; if"),
    ] {
        let words =
            [&format!("--pad {pad} is more than the length of the foot of calcn_r, toes_r, 0.25"), says];
        assert_asks(
            &dir,
            &format!("{call} {pad}"),
            &[words[0], words[1], "confirm it with --yes implausible-place"],
        );
    }
    dir.run(&format!("{call} 0.25 --dry-run")).succeeded();
    dir.run(&format!("{call} 5 --yes implausible-place --dry-run")).succeeded();
}

#[test]
fn add_asks_about_implausible_scale_factors() {
    let dir = human_with_meshes();
    let call = "add human.osim --from falisse2022 --body-scale";
    assert_asks(
        &dir,
        &format!("{call} calcn_r=95"),
        &[
            "--body-scale calcn_r=95,95,95",
            "if it is in percent, write 0.95",
            "confirm it with --yes implausible-scale",
        ],
    );
    assert_asks(
        &dir,
        &format!("{call} calcn_r=1,1,0.019"),
        &["0.019 times as long as the reference's", "38 times; if it is correct"],
    );
    dir.run(&format!("{call} calcn_r=0.021 --body-scale toes_r=49 --yes implausible-radius --dry-run"))
        .says(&[]);
    dir.run(&format!("{call} calcn_r=60 --body-scale calcn_l=60 --yes implausible-scale --dry-run"))
        .succeeded();
}

/// 0.05 rad are 2.9 degrees: the foot counts as flat, but it would get other spheres than the left foot.
#[test]
fn add_asks_about_feet_with_different_poses() {
    let dir = human_with_meshes();
    write_posed_model(&dir, "one.osim", &[("calcn_r_angle", 0.05)]);
    let call = format!("add one.osim {UNDER_BONES} --count 6 --pad 0.02");
    assert_asks(
        &dir,
        &call,
        &[
            "calcn_r and calcn_l are not posed as mirror images at the default pose, by 2.9 degrees",
            "give the coordinates of both legs the same default values (now calcn_r_angle = 0.05 rad and 0)",
            "if it is correct, confirm it with --yes unequal-feet",
        ],
    );
    dir.run(&format!("{call} --yes unequal-feet -o meant.osim")).succeeded();
    // Equal angles in both legs cause no question.
    write_posed_model(&dir, "both.osim", &[("calcn_r_angle", 0.05), ("calcn_l_angle", 0.05)]);
    dir.run(&format!("add both.osim {UNDER_BONES} --count 6 --pad 0.02 --dry-run")).succeeded();
}

#[test]
fn add_names_parts_of_feet_without_spheres() {
    let dir = human_with_meshes();
    let numbers = "--from falisse2022 --count 4 --pad 0.02 --dry-run";
    dir.run(&format!("add human.osim --feet calcn_r,toes_r {numbers}"))
        .succeeded()
        .says(&["one side alone gets spheres: the other side has calcn_l, toes_l"]);
    dir.run(&format!("add human.osim --feet calcn_r,calcn_l {numbers} --yes tilted-foot")).succeeded().says(
        &["no spheres under toes_r, toes_l: part of the foot, but not among the bodies that were given"],
    );
    dir.run(&format!("add human.osim {UNDER_BONES} --count 6 --pad 0.02 --dry-run"))
        .succeeded()
        .says_not(&["one side alone", "no spheres under"]);
}

/// Speeds go with M^(1/6): 8 times the mass, 1.41 times the speed.
#[test]
fn add_names_friction_speeds_that_stay_unless_they_are_scaled() {
    let dir = human_with_meshes();
    let call = format!("add human.osim {UNDER_BONES} --count 6 --pad 0.02 --mass 496");
    let words = "transition_velocity and viscous_friction stay the reference's, but speeds of this body are 1.41 times as high";
    dir.run(&format!("{call} -o stays.osim")).succeeded().says(&[words, "--friction"]);
    dir.run(&format!("{call} --friction -o scaled.osim")).succeeded().says_not(&[words]);
    assert!(dir.text("stays.osim").contains("<transition_velocity>0.2</transition_velocity>"));
    let scaled = dir.text("scaled.osim");
    let (_, after) = scaled.split_once("<transition_velocity>").unwrap();
    let value: f64 = after.split_once('<').unwrap().0.parse().unwrap();
    // 0.2 m/s times the square root of 2.
    assert!((value - 0.282_842_712_474_619).abs() < 1e-12, "{value}");
    dir.run(&format!("{call} --friction --viscous-friction 0.5 --dry-run"))
        .usage_error()
        .says(&["--viscous-friction"]);
}
