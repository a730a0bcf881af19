//! `add`: references that it refuses, old contacts that stay beside new contacts, and the note about new contacts.

use serde_json::Value;

use crate::support::{TestDir, corpus_folder};

const HUMAN: &str = "feet/human_40000.osim";
const TABLE_OF_PLACES: &str = "contact_tables/own.csv";
/// XML of a contact force between a ball and the floor.
const BALL_CONTACT: &str = "\
    <SmoothSphereHalfSpaceForce name=\"ball_ground\">\
    <socket_sphere>/contactgeometryset/ball</socket_sphere>\
    <socket_half_space>/contactgeometryset/floor</socket_half_space>\
    <stiffness>100000</stiffness></SmoothSphereHalfSpaceForce>";

fn bare_human() -> TestDir {
    TestDir::with(&[(HUMAN, "bare.osim"), (TABLE_OF_PLACES, "own.csv")])
}

/// The human after `add` of contacts at the places of the table, made for 62 kg.
fn human_with_contacts() -> TestDir {
    let dir = bare_human();
    dir.run("add bare.osim --from falisse2022 --contacts own.csv -o with.osim").succeeded();
    dir
}

/// The human with contacts, and a ball on the floor beside it.
fn human_with_contacts_and_ball() -> TestDir {
    let dir = human_with_contacts();
    let body = "<Body name=\"ball\"><mass>0.4</mass><mass_center>0 0 0</mass_center>\
                <inertia>0.001 0.001 0.001 0 0 0</inertia></Body>";
    let joint = "<FreeJoint name=\"ground_ball\"><socket_parent_frame>/ground</socket_parent_frame>\
                 <socket_child_frame>/bodyset/ball</socket_child_frame></FreeJoint>";
    let sphere = "<ContactSphere name=\"ball\"><socket_frame>/bodyset/ball</socket_frame>\
                  <location>0 0 0</location><radius>0.11</radius></ContactSphere>";
    let mut text = dir.text("with.osim");
    for (set, inside) in
        [("BodySet", body), ("JointSet", joint), ("ContactGeometrySet", sphere), ("ForceSet", BALL_CONTACT)]
    {
        let start = text.find(&format!("<{set}")).unwrap();
        let at = start + text[start..].find("<objects>").unwrap() + "<objects>".len();
        text.insert_str(at, inside);
    }
    dir.write("with.osim", text);
    dir
}

fn force_names(dir: &TestDir, model: &str) -> Vec<String> {
    let run = dir.run(&format!("inspect {model} --mass 62 --spheres 2 --format json")).succeeded();
    let inspection: Value = serde_json::from_str(&run.out()).unwrap();
    let names = inspection["forces"].as_array().unwrap().iter();
    names.map(|force| force["name"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn a_constant_contact_force_of_0_is_not_copied_from_a_reference() {
    let dir = human_with_contacts();
    let text = dir.text("with.osim");
    let (before, options) = text.split_once("<constant_contact_force>").unwrap();
    let (_, after) = options.split_once("</constant_contact_force>").unwrap();
    dir.write("zero.osim", format!("{before}<constant_contact_force>0</constant_contact_force>{after}"));
    for call in
        ["add bare.osim --from zero.osim", "add bare.osim --from zero.osim --contacts own.csv --spheres 2"]
    {
        let expected = ["zero.osim", "constant_contact_force is 0", "NaN"];
        dir.run(&format!("{call} --reference-mass 62 -o out.osim")).wrote_nothing().says(&expected);
    }
    // A class that does not have this number takes the others.
    dir.run("add bare.osim --from zero.osim --reference-mass 62 --class hunt-crossley -o out.osim")
        .succeeded()
        .wrote(&["out.osim"]);
}

#[test]
fn a_model_with_one_leg_is_told_which_forces_to_choose() {
    let dir = TestDir::with(&[
        (HUMAN, "bare.osim"),
        ("scale_tool/generic_smooth.osim", "smooth.osim"),
        ("scale_tool/generic_hunt_crossley.osim", "feet.osim"),
    ]);
    dir.write("one.osim", dir.text("bare.osim").replace("calcn_l", "stump").replace("toes_l", "tip"));
    let renamed = |text: String, [right, left]: [&str; 2], now: [&str; 2]| {
        ["heel", "ball", "toe"].iter().fold(text, |text, part| {
            let name = |pattern: &str| pattern.replace("PART", part);
            text.replace(&name(right), &name(now[0])).replace(&name(left), &name(now[1]))
        })
    };
    let with_forces = |now| renamed(dir.text("smooth.osim"), ["contact_PART_r", "contact_PART_l"], now);
    for (reference, pattern) in [
        (with_forces(["contact_PART_r", "contact_PART_l"]), "*_r"),
        (with_forces(["grf_r_PART", "grf_l_PART"]), "*_r*"),
        (with_forces(["r_PART", "l_PART"]), "r_*"),
        (with_forces(["RightPART", "LeftPART"]), "*[Rr]ight*"),
        (with_forces(["PART1", "PART2"]), "{heel1,ball1,toe1}"),
        // The force of a foot presses three spheres whose names do not end with the side.
        (renamed(dir.text("feet.osim"), ["PART_r", "PART_l"], ["r_PART", "l_PART"]), "*_r"),
    ] {
        dir.write("reference.osim", reference);
        let call = "add one.osim --from reference.osim";
        let hint = format!("or leave them out with --reference-select \"{pattern}\"");
        dir.run(&format!("{call} -o out.osim")).failed().wrote_nothing().says(&[hint.as_str()]);
        dir.run(&format!("{call} --reference-select {pattern} -o out.osim --force")).succeeded();
    }
}

#[test]
fn add_keeps_contacts_of_other_bodies() {
    let dir = human_with_contacts_and_ball();
    let call = "add with.osim --from falisse2022 --contacts own.csv --spheres 2 -o out.osim";
    dir.run(call).failed().wrote_nothing().says(&["has contacts already", "--replace"]);
    let refused = dir.run(&format!("{call} --replace")).failed().wrote_nothing();
    refused.says(&["ball (forces ball_ground)", "--select"]);
    // A typing mistake does not put contacts beside those that the model has.
    dir.run(&format!("{call} --select nobody*")).failed().wrote_nothing().says(&["--select"]);
    dir.run(&format!("{call} --replace --exclude ball_*")).succeeded().wrote(&["out.osim"]);
    let names = force_names(&dir, "out.osim");
    assert_eq!(names.len(), 5, "{names:?}");
    assert!(names.contains(&"ball_ground".to_owned()), "{names:?}");
    // Only a ball on the floor: feet may come beside it.
    dir.run("remove with.osim --select force_* -o ball.osim").succeeded();
    assert_eq!(force_names(&dir, "ball.osim"), ["ball_ground"]);
    let call =
        "add ball.osim --from falisse2022 --contacts own.csv --spheres 2 --exclude ball_* -o both.osim";
    dir.run(call).succeeded().wrote(&["both.osim"]);
    assert_eq!(force_names(&dir, "both.osim").len(), 5);
}

#[test]
fn feet_that_keep_contacts_get_no_second_ones() {
    let dir = human_with_contacts();
    let call = "add with.osim --from falisse2022 --contacts own.csv --spheres 2 --replace -o out.osim";
    for options in ["--exclude *_r", "--select force_heel*"] {
        let run = dir.run(&format!("{call} {options}")).failed().wrote_nothing();
        run.says(&["has contacts already", "_r"]);
    }
}

#[test]
fn add_refuses_to_rewrite_names_that_are_not_utf_8() {
    let dir = bare_human();
    let with_floor = {
        dir.run("add bare.osim --from falisse2022 --contacts own.csv --no-note -o with.osim").succeeded();
        let text = dir.text("with.osim").replace("floor", "boden").replace("heel_r", "hael_r");
        let bytes = text.into_bytes();
        // The letters o of boden and a of hael, as Windows writes ö and ä.
        let mut odd = Vec::new();
        for (index, &byte) in bytes.iter().enumerate() {
            let before = &bytes[index.saturating_sub(1)..index];
            let after = &bytes[index + 1..(index + 3).min(bytes.len())];
            odd.push(match (before, byte, after) {
                (b"b", b'o', b"de") => 0xF6,
                (b"h", b'a', b"el") => 0xE4,
                _ => byte,
            });
        }
        odd
    };
    dir.write("odd.osim", with_floor);
    for call in [
        "convert odd.osim --to hunt-crossley -o out.osim",
        "add odd.osim --from falisse2022 --contacts own.csv --replace --spheres 2 -o out.osim",
    ] {
        dir.run(call).failed().wrote_nothing().says(&["not UTF-8", "text editor"]);
    }
    // Rescaling keeps such names.
    dir.run("rescale odd.osim --contacts-mass 62 --target-mass 70 -o out.osim")
        .succeeded()
        .wrote(&["out.osim"]);
    assert!(dir.read("out.osim").contains(&0xE4));
}

#[test]
fn known_contacts_on_a_reference_of_another_mass_need_its_mass() {
    let dir = TestDir::with(&[
        (HUMAN, "bare.osim"),
        (TABLE_OF_PLACES, "own.csv"),
        ("check/contacts_of_another_mass.osim", "known.osim"),
        ("table1/human_62kg_smooth_sphere.osim", "human.osim"),
    ]);
    for call in
        ["add bare.osim --from known.osim --contacts own.csv", "transfer human.osim --from known.osim"]
    {
        let expected = ["known.osim", "the contacts of the reference are those of", "--reference-mass"];
        dir.run(&format!("{call} -o out.osim")).wrote_nothing().says(&expected);
    }
}

#[test]
fn the_question_for_the_mass_of_a_reference_names_its_option() {
    let dir = human_with_contacts();
    let text = dir.text("with.osim");
    dir.write("edited.osim", text.replacen("<radius>0.03</radius>", "<radius>0.031</radius>", 1));
    for verb in ["add bare.osim", "transfer with.osim"] {
        let run = dir.run(&format!("{verb} --from edited.osim -o out.osim")).wrote_nothing();
        let expected = format!("{}{}", run.out(), run.err());
        assert!(
            expected.contains("--reference-mass KG") && !expected.contains("--contacts-mass"),
            "{expected}"
        );
    }
}

#[test]
fn designed_contacts_are_made_for_the_mass_of_the_model() {
    let dir = bare_human();
    let call =
        "add bare.osim --contacts own.csv --class smooth --indentation 0.15 --restitution 0.8 -o made.osim";
    dir.run(call).succeeded();
    dir.run("made.osim --target-mass 70 -o larger.osim").succeeded().wrote(&["larger.osim"]);
    dir.run("transfer made.osim --from made.osim -o same.osim").succeeded();
    let inspection = dir.run("inspect made.osim --format json").succeeded().out();
    let inspection: Value = serde_json::from_str(&inspection).unwrap();
    assert_eq!(inspection["contacts_mass_kg"]["source"], "note", "{inspection}");
}

#[test]
fn a_map_of_absent_bodies_is_refused_by_its_option() {
    let dir = bare_human();
    let refused = |options: &str, words: &[&str]| {
        let call = format!("add bare.osim --from falisse2022 {options} -o out.osim");
        let run = dir.run(&call).wrote_nothing();
        let text = format!("{}{}", run.out(), run.err());
        assert!(words.iter().all(|word| text.contains(word)), "{text}");
        assert!(!text.contains("--body-scale"), "{text}");
    };
    refused("--body-map nope_r=calcn_r", &["--body-map nope_r=calcn_r", "calcn_r", "toes_r"]);
    refused("--body-map toes_r=nope", &["--body-map toes_r=nope", "no body nope", "it has pelvis"]);
    refused(
        "--body-map toes_r=calcn_r --body-map toes_r=toes_r",
        &["--body-map toes_r=toes_r", "already assigned"],
    );
}

#[test]
fn planes_that_new_contacts_do_not_touch_are_named() {
    let dir = bare_human();
    dir.run("add bare.osim --from falisse2022 --contacts own.csv --no-note -o with.osim").succeeded();
    let text = dir.text("with.osim");
    let (before, options) = text.split_once("<ContactHalfSpace name=\"floor\">").unwrap();
    let (plane, after) = options.split_once("</ContactHalfSpace>").unwrap();
    let level = "<orientation>0 0 -1.5707963267948966</orientation>";
    let leaning = plane.replace(level, "<orientation>0 0 -1.5</orientation>");
    assert_ne!(leaning, plane);
    dir.write(
        "leaning.osim",
        format!("{before}<ContactHalfSpace name=\"ramp\">{leaning}</ContactHalfSpace>{after}")
            .replace("contactgeometryset/floor", "contactgeometryset/ramp"),
    );
    let call = "add leaning.osim --from falisse2022 --contacts own.csv --spheres 2 --replace -o out.osim";
    let run = dir.run(call).succeeded().wrote(&["out.osim"]);
    // 1.5707963 - 1.5 rad are 4.05634 degrees.
    run.says(&["ramp (by 4.0563", "the new forces meet floor", "met ramp, which is not a level floor"]);
    let run = dir.run(&format!("{} --dry-run", call.replace("leaning", "with"))).succeeded();
    assert!(!format!("{}{}", run.out(), run.err()).contains("tilted"));
}

#[test]
fn a_class_newer_than_the_document_is_named() {
    let dir = TestDir::with(&[
        ("feet/human_30000.osim", "old.osim"),
        (HUMAN, "new.osim"),
        (TABLE_OF_PLACES, "own.csv"),
    ]);
    let text = |model: &str, more: &str| {
        let call = format!("add {model} --from falisse2022 --contacts own.csv --dry-run {more}");
        dir.run(&call).succeeded().out()
    };
    assert!(text("old.osim", "").contains("came with OpenSim 4.1"));
    assert!(!text("old.osim", "--class hunt-crossley").contains("OpenSim 4.1"));
    assert!(!text("new.osim", "").contains("OpenSim 4.1"));
}

/// The presets were written from published models, so a preset and its model give the same contacts.
#[test]
fn presets_with_places_equal_the_published_models() {
    let test = "presets_with_places_equal_the_published_models";
    let Some(folder) = corpus_folder(test) else { return };
    let two_segments = ["v40000_gait2392_without_contacts", "v40000_rajagopal_2016_without_contacts"];
    for (preset, original, spheres, models) in [
        ("falisse2022", "v40000_falisse_2022_human", 12, &two_segments[..]),
        ("moco-2d-gait", "v40000_moco_2d_gait", 4, &two_segments),
        // No other model has feet of three segments.
        ("dhondt2024", "v40000_dhondt_2024_3seg_human", 10, &["v40000_dhondt_2024_3seg_human"]),
    ] {
        for model in models {
            let dir = TestDir::new();
            let planned_numbers = |from: &str, reference: &str| -> Vec<(String, Vec<f64>)> {
                let model = folder.join(format!("{model}.osim"));
                let call = format!(
                    "add {} --from {from} {reference} --replace --format json --dry-run",
                    model.display()
                );
                let plan: Value = serde_json::from_str(&dir.run(&call).succeeded().out()).unwrap();
                let mut numbers_by_name = Vec::new();
                for object in plan["objects"].as_array().unwrap() {
                    if let Some(place) = object["location_m"].as_array() {
                        let mut numbers: Vec<f64> = place.iter().map(|x| x.as_f64().unwrap()).collect();
                        numbers.push(object["radius_m"].as_f64().unwrap());
                        numbers_by_name.push((object["name"].as_str().unwrap().to_owned(), numbers));
                    }
                }
                assert_eq!(numbers_by_name.len(), spheres, "{from}");
                for change in plan["changes"].as_array().unwrap() {
                    if let (Some(force), Some(to)) = (change["force"].as_str(), change["to"].as_f64()) {
                        let property = change["property"].as_str().unwrap();
                        numbers_by_name.push((format!("{force} {property}"), vec![to]));
                    }
                }
                numbers_by_name.sort_by(|a, b| a.0.cmp(&b.0));
                numbers_by_name
            };
            let file = folder.join(format!("{original}.osim"));
            let (from_preset, from_model) = (
                planned_numbers(preset, ""),
                planned_numbers(&file.display().to_string(), "--reference-mass 62"),
            );
            assert_eq!(from_preset.len(), from_model.len(), "{preset}");
            for ((name, from_preset), (other, from_model)) in from_preset.iter().zip(&from_model) {
                assert_eq!(name, other);
                for (from_preset, from_model) in from_preset.iter().zip(from_model) {
                    // The paper prints Falisse's numbers with fewer digits than the model has.
                    assert!(
                        (from_preset - from_model).abs() <= 1e-6 * from_model.abs().max(1e-3),
                        "{name}: {from_preset}, {from_model}"
                    );
                }
            }
        }
    }
}
