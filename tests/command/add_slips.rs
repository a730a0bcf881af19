//! What `add` asks about before it does it: feet that do not lie flat, places and lengths that are probably in another unit.

use crate::support::Bench;

const MESHES: [&str; 4] = ["l_human_foot", "l_human_toes", "r_human_foot", "r_human_toes"];
const UNDER_BONES: &str = "--feet calcn_r,toes_r,calcn_l,toes_l --from falisse2022";

fn human() -> Bench {
    let bench =
        Bench::with(&[("feet/human_40000.osim", "human.osim"), ("contact_tables/own.csv", "own.csv")]);
    for mesh in MESHES {
        let file = format!("Geometry/{mesh}.vtp");
        bench.write(&file, crate::support::fixture(&format!("feet/{file}")));
    }
    bench
}

/// `human.osim` with other default values of some coordinates.
fn posed(bench: &Bench, name: &str, values: &[(&str, f64)]) {
    let mut text = bench.text("human.osim");
    for (coordinate, value) in values {
        let (before, after) = text.split_once(&format!("<Coordinate name=\"{coordinate}\">")).unwrap();
        let after = after.replacen(
            "<default_value>0</default_value>",
            &format!("<default_value>{value}</default_value>"),
            1,
        );
        text = format!("{before}<Coordinate name=\"{coordinate}\">{after}");
    }
    bench.write(name, text);
}

/// One line, exit status 1, nothing written.
#[track_caller]
fn asks(bench: &Bench, call: &str, words: &[&str]) {
    let ran = bench.run(call).failed().wrote_nothing().says(words);
    assert_eq!(ran.err().lines().filter(|line| line.starts_with("error: ")).count(), 1, "{}", ran.err());
}

/// With ankles at 0.2 rad only the heel is near a level plane. 0.2 rad are 11.5 degrees, and the bones' own sole rises by nearly 1 degree.
#[test]
fn a_foot_that_does_not_lie_flat_is_asked_about() {
    let bench = human();
    posed(&bench, "ankles.osim", &[("calcn_r_angle", 0.2), ("calcn_l_angle", 0.2)]);
    let call = format!("add ankles.osim {UNDER_BONES} --count 6 --pad 0.02");
    asks(
        &bench,
        &call,
        &[
            "the foot of calcn_r, toes_r does not lie flat at the default pose: its front is 12.1 degrees up",
            "bones near the ground cover 25 % of its length and 40 % of its width, expected at most 10 degrees, and 80 % or more",
            "set default values of its joints at which it does, such as 0 (now calcn_r_angle = 0.2 rad)",
            "if it is meant, say --yes tilted-foot",
        ],
    );
    bench.run(&format!("{call} --yes tilted-foot -o meant.osim")).done();
    // The pelvis turns about x, y and z, in this order: its list is about the vertical. What turns both feet in their plane, lifts them or turns them level again is no question.
    posed(&bench, "turned.osim", &[("pelvis_list", 0.4), ("pelvis_tx", 0.1)]);
    bench.run(&format!("add turned.osim {UNDER_BONES} --count 6 --pad 0.02 --dry-run")).done();
    posed(
        &bench,
        "bent.osim",
        &[("tibia_r_angle", -0.3), ("calcn_r_angle", 0.3), ("tibia_l_angle", -0.3), ("calcn_l_angle", 0.3)],
    );
    bench.run(&format!("add bent.osim {UNDER_BONES} --count 6 --pad 0.02 --dry-run")).done();
    // 0.05 rad are no tilt that matters.
    posed(&bench, "nearly.osim", &[("calcn_r_angle", 0.05), ("calcn_l_angle", 0.05)]);
    bench.run(&format!("add nearly.osim {UNDER_BONES} --count 6 --pad 0.02 --dry-run")).done();
}

/// The left foot is flat, the right one is not: its spheres would be others.
#[test]
fn one_tilted_foot_of_two_is_enough() {
    let bench = human();
    posed(
        &bench,
        "right.osim",
        &[("calcn_r_angle", 0.4), ("toes_r_angle", -0.4), ("pelvis_list", 0.1), ("pelvis_rotation", 0.01)],
    );
    asks(
        &bench,
        &format!("add right.osim {UNDER_BONES} --count 4 --pad 0.01"),
        &[
            "the foot of calcn_r, toes_r does not lie flat",
            // From the foot up; toes tilt a part of it; what turns about the vertical tilts nothing.
            "(now calcn_r_angle = 0.4 rad, toes_r_angle = -0.4 rad, pelvis_rotation = 0.01 rad)",
        ],
    );
}

/// The right heel is turned on its leg, without a coordinate that could be set.
#[test]
fn a_foot_that_no_coordinate_tilts_goes_into_a_table() {
    let bench = human();
    let text = bench.text("human.osim");
    let (before, after) = text.split_once("<PinJoint name=\"calcn_r_joint\">").unwrap();
    let after =
        after.replacen("<orientation>0 -0.12 0</orientation>", "<orientation>-0.3 -0.12 0</orientation>", 1);
    bench.write("turned.osim", format!("{before}<PinJoint name=\"calcn_r_joint\">{after}"));
    asks(
        &bench,
        &format!("add turned.osim {UNDER_BONES} --count 4 --pad 0.01"),
        &[
            "does not lie flat at the default pose: its outer side is",
            "name the bodies that touch the ground with --feet BODY,BODY, or give the places in a table, --contacts TABLE",
        ],
    );
}

#[test]
fn names_and_sizes_that_no_model_has_are_refused() {
    let bench = human();
    for (name, words) in [
        (".", "the name '.' is a step in OpenSim's paths"),
        ("..", "the name '..' is a step in OpenSim's paths"),
        ("heel\u{1b}[31m_r", "(U+001B)"),
        ("heel\u{202e}_r", "(U+202E)"),
    ] {
        bench.write("t.csv", format!("name,body,x,y,z,radius\n{name},calcn_r,0,0,0,0.03\n"));
        let call = "add human.osim --contacts t.csv --from falisse2022 --spheres 2";
        asks(&bench, call, &["t.csv:2:1", "column 'name'", words, "choose letters, digits, '_' or '-'"]);
    }
    bench.write("t.csv", "name,body,x,y,z,radius\na,calcn_r,1e308,0,0,0.03\n");
    asks(
        &bench,
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
        bench.run(&call).usage().wrote_nothing().says(&[words]);
    }
}

/// The ball is 0.16, 0.005, 0.02 m from the heel's origin and its joint: 0.1613 m; in millimetres that would be 161.3 m, in centimetres
/// 16.13 m, and the shank is less than half a metre long.
#[test]
fn places_in_another_unit_are_asked_about() {
    let bench = human();
    let table = |name: &str, x: f64| {
        let [x, y, z] = [x, x / 32.0, x / 8.0];
        bench.write(
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
        asks(&bench, &call, &[&far, says, "say --yes implausible-place"]);
        bench.run(&format!("{call} --yes implausible-place -o out.osim --force")).done();
    }
    table("metres.csv", 0.16);
    bench.run("add human.osim --contacts metres.csv --from falisse2022 --dry-run").done();
    // Radii of new spheres: 30 is in millimetres, 3 in centimetres, 10 may be in both.
    for (radius, says) in [
        ("30", "write 0.03 if it is in mm; if"),
        ("3", "write 0.03 if it is in cm; if"),
        ("10", "write 0.01 if it is in mm, or 0.1 if it is in cm; if"),
    ] {
        bench.write("r.csv", format!("name,body,x,y,z,radius\nheel_r,calcn_r,0,0,0,{radius}\n"));
        asks(&bench, "add human.osim --contacts r.csv --from falisse2022", &["radii are in m", says]);
    }
}

/// The foot is a quarter of a metre long.
#[test]
fn a_sole_far_below_the_bones_is_asked_about() {
    let bench = human();
    let call = format!("add human.osim {UNDER_BONES} --count 4 --pad");
    for (pad, says) in [
        ("20", "it is in m, write 0.02 if it is in mm; if"),
        ("1.3", "it is in m, write 0.013 if it is in cm; if"),
        ("5", "it is in m, write 0.005 if it is in mm, or 0.05 if it is in cm; if"),
        ("0.27", "it is in m; if"),
    ] {
        let words =
            [&format!("--pad {pad} is more than the length of the foot of calcn_r, toes_r, 0.25"), says];
        asks(&bench, &format!("{call} {pad}"), &[words[0], words[1], "say --yes implausible-place"]);
    }
    bench.run(&format!("{call} 0.25 --dry-run")).done();
    bench.run(&format!("{call} 5 --yes implausible-place --dry-run")).done();
}

#[test]
fn factors_that_no_animals_differ_by_are_asked_about() {
    let bench = human();
    let call = "add human.osim --from falisse2022 --body-scale";
    asks(
        &bench,
        &format!("{call} calcn_r=95"),
        &["--body-scale calcn_r=95,95,95", "if it is in percent, write 0.95", "say --yes implausible-scale"],
    );
    asks(
        &bench,
        &format!("{call} calcn_r=1,1,0.019"),
        &["0.019 times as long as the reference's", "38 times; if it is meant"],
    );
    bench
        .run(&format!("{call} calcn_r=0.021 --body-scale toes_r=49 --yes implausible-radius --dry-run"))
        .says(&[]);
    bench.run(&format!("{call} calcn_r=60 --body-scale calcn_l=60 --yes implausible-scale --dry-run")).done();
}

/// 0.05 rad are 2.9 degrees: the foot counts as flat, but its spheres would be others than those of the left foot.
#[test]
fn feet_that_are_not_posed_alike_are_asked_about() {
    let bench = human();
    posed(&bench, "one.osim", &[("calcn_r_angle", 0.05)]);
    let call = format!("add one.osim {UNDER_BONES} --count 6 --pad 0.02");
    asks(
        &bench,
        &call,
        &[
            "calcn_r and calcn_l are not posed as mirror images at the default pose, by 2.9 degrees",
            "give the coordinates of both legs the same default values (now calcn_r_angle = 0.05 rad and 0)",
            "if it is meant, say --yes unequal-feet",
        ],
    );
    bench.run(&format!("{call} --yes unequal-feet -o meant.osim")).done();
    // Both legs alike.
    posed(&bench, "both.osim", &[("calcn_r_angle", 0.05), ("calcn_l_angle", 0.05)]);
    bench.run(&format!("add both.osim {UNDER_BONES} --count 6 --pad 0.02 --dry-run")).done();
}

#[test]
fn parts_of_feet_that_get_nothing_are_named() {
    let bench = human();
    let numbers = "--from falisse2022 --count 4 --pad 0.02 --dry-run";
    bench
        .run(&format!("add human.osim --feet calcn_r,toes_r {numbers}"))
        .done()
        .says(&["one side alone gets spheres: the other side has calcn_l, toes_l"]);
    bench.run(&format!("add human.osim --feet calcn_r,calcn_l {numbers} --yes tilted-foot")).done().says(&[
        "no spheres under toes_r, toes_l: part of the foot, but not among the bodies that were given",
    ]);
    bench
        .run(&format!("add human.osim {UNDER_BONES} --count 6 --pad 0.02 --dry-run"))
        .done()
        .says_not(&["one side alone", "no spheres under"]);
}

/// Speeds go with M^(1/6): 8 times the mass, 1.41 times the speed.
#[test]
fn speeds_of_friction_that_stay_are_named_or_scaled() {
    let bench = human();
    let call = format!("add human.osim {UNDER_BONES} --count 6 --pad 0.02 --mass 496");
    let words = "transition_velocity and viscous_friction stay the reference's, but speeds of this body are 1.41 times as high";
    bench.run(&format!("{call} -o stays.osim")).done().says(&[words, "--friction"]);
    bench.run(&format!("{call} --friction -o scaled.osim")).done().says_not(&[words]);
    assert!(bench.text("stays.osim").contains("<transition_velocity>0.2</transition_velocity>"));
    let scaled = bench.text("scaled.osim");
    let (_, after) = scaled.split_once("<transition_velocity>").unwrap();
    let value: f64 = after.split_once('<').unwrap().0.parse().unwrap();
    // 0.2 m/s times the square root of 2.
    assert!((value - 0.282_842_712_474_619).abs() < 1e-12, "{value}");
    bench
        .run(&format!("{call} --friction --viscous-friction 0.5 --dry-run"))
        .usage()
        .says(&["--viscous-friction"]);
}
