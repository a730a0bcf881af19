//! `add`: what it refuses of references, what stays beside new contacts, and what their note says.

use serde_json::Value;

use crate::support::{Bench, corpus};

const HUMAN: &str = "feet/human_40000.osim";
const TABLE: &str = "contact_tables/own.csv";
/// Two feet and a ball, each of them on the floor.
const BALL: &str = "\
    <SmoothSphereHalfSpaceForce name=\"ball_ground\">\
    <socket_sphere>/contactgeometryset/ball</socket_sphere>\
    <socket_half_space>/contactgeometryset/floor</socket_half_space>\
    <stiffness>100000</stiffness></SmoothSphereHalfSpaceForce>";

fn bench() -> Bench {
    Bench::with(&[(HUMAN, "bare.osim"), (TABLE, "own.csv")])
}

/// With contacts at the places of the table, for 62 kg.
fn added() -> Bench {
    let bench = bench();
    bench.run("add bare.osim --from falisse2022 --contacts own.csv -o with.osim").done();
    bench
}

/// The same with a ball beside the human, on the same floor.
fn with_ball() -> Bench {
    let bench = added();
    let body = "<Body name=\"ball\"><mass>0.4</mass><mass_center>0 0 0</mass_center>\
                <inertia>0.001 0.001 0.001 0 0 0</inertia></Body>";
    let joint = "<FreeJoint name=\"ground_ball\"><socket_parent_frame>/ground</socket_parent_frame>\
                 <socket_child_frame>/bodyset/ball</socket_child_frame></FreeJoint>";
    let sphere = "<ContactSphere name=\"ball\"><socket_frame>/bodyset/ball</socket_frame>\
                  <location>0 0 0</location><radius>0.11</radius></ContactSphere>";
    let mut text = bench.text("with.osim");
    for (set, inside) in
        [("BodySet", body), ("JointSet", joint), ("ContactGeometrySet", sphere), ("ForceSet", BALL)]
    {
        let start = text.find(&format!("<{set}")).unwrap();
        let at = start + text[start..].find("<objects>").unwrap() + "<objects>".len();
        text.insert_str(at, inside);
    }
    bench.write("with.osim", text);
    bench
}

fn forces(bench: &Bench, model: &str) -> Vec<String> {
    let ran = bench.run(&format!("inspect {model} --mass 62 --spheres 2 --format json")).done();
    let seen: Value = serde_json::from_str(&ran.out()).unwrap();
    let names = seen["forces"].as_array().unwrap().iter();
    names.map(|force| force["name"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn a_constant_contact_force_of_0_is_not_taken_from_a_reference() {
    let bench = added();
    let text = bench.text("with.osim");
    let (before, rest) = text.split_once("<constant_contact_force>").unwrap();
    let (_, after) = rest.split_once("</constant_contact_force>").unwrap();
    bench.write("zero.osim", format!("{before}<constant_contact_force>0</constant_contact_force>{after}"));
    for call in
        ["add bare.osim --from zero.osim", "add bare.osim --from zero.osim --contacts own.csv --spheres 2"]
    {
        let said = ["zero.osim", "constant_contact_force is 0", "NaN"];
        bench.run(&format!("{call} --reference-mass 62 -o out.osim")).wrote_nothing().says(&said);
    }
    // A class without it takes the rest.
    bench
        .run("add bare.osim --from zero.osim --reference-mass 62 --class hunt-crossley -o out.osim")
        .done()
        .wrote(&["out.osim"]);
}

#[test]
fn contacts_that_are_no_feet_stay() {
    let bench = with_ball();
    let call = "add with.osim --from falisse2022 --contacts own.csv --spheres 2 -o out.osim";
    bench.run(call).failed().wrote_nothing().says(&["has contacts already", "--replace"]);
    let asked = bench.run(&format!("{call} --replace")).failed().wrote_nothing();
    asked.says(&["ball (forces ball_ground)", "--select"]);
    // A slip of the pen does not put contacts beside those that are there.
    bench.run(&format!("{call} --select nobody*")).failed().wrote_nothing().says(&["--select"]);
    bench.run(&format!("{call} --replace --exclude ball_*")).done().wrote(&["out.osim"]);
    let names = forces(&bench, "out.osim");
    assert_eq!(names.len(), 5, "{names:?}");
    assert!(names.contains(&"ball_ground".to_owned()), "{names:?}");
    // Only a ball on the floor: feet may come beside it.
    bench.run("remove with.osim --select force_* -o ball.osim").done();
    assert_eq!(forces(&bench, "ball.osim"), ["ball_ground"]);
    let call =
        "add ball.osim --from falisse2022 --contacts own.csv --spheres 2 --exclude ball_* -o both.osim";
    bench.run(call).done().wrote(&["both.osim"]);
    assert_eq!(forces(&bench, "both.osim").len(), 5);
}

#[test]
fn contacts_that_stay_are_not_doubled() {
    let bench = added();
    let call = "add with.osim --from falisse2022 --contacts own.csv --spheres 2 --replace -o out.osim";
    for rest in ["--exclude *_r", "--select force_heel*"] {
        let ran = bench.run(&format!("{call} {rest}")).failed().wrote_nothing();
        ran.says(&["has contacts already", "_r"]);
    }
}

#[test]
fn names_that_are_not_utf_8_are_not_written_otherwise() {
    let bench = bench();
    let with_floor = {
        bench.run("add bare.osim --from falisse2022 --contacts own.csv --no-note -o with.osim").done();
        let text = bench.text("with.osim").replace("floor", "boden").replace("heel_r", "hael_r");
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
    bench.write("odd.osim", with_floor);
    for call in [
        "convert odd.osim --to hunt-crossley -o out.osim",
        "add odd.osim --from falisse2022 --contacts own.csv --replace --spheres 2 -o out.osim",
    ] {
        bench.run(call).failed().wrote_nothing().says(&["not UTF-8", "text editor"]);
    }
    // What is there stays as it is.
    bench.run("rescale odd.osim --contacts-mass 62 --target-mass 70 -o out.osim").done().wrote(&["out.osim"]);
    assert!(bench.read("out.osim").contains(&0xE4));
}

#[test]
fn a_reference_of_known_contacts_under_another_mass_is_asked_about() {
    let bench = Bench::with(&[
        (HUMAN, "bare.osim"),
        (TABLE, "own.csv"),
        ("check/contacts_of_another_mass.osim", "known.osim"),
        ("table1/human_62kg_smooth_sphere.osim", "human.osim"),
    ]);
    for call in
        ["add bare.osim --from known.osim --contacts own.csv", "transfer human.osim --from known.osim"]
    {
        let said = ["known.osim", "the contacts of the reference are those of", "--reference-mass"];
        bench.run(&format!("{call} -o out.osim")).wrote_nothing().says(&said);
    }
}

#[test]
fn the_mass_of_a_reference_is_asked_for_by_its_own_name() {
    let bench = added();
    let text = bench.text("with.osim");
    bench.write("edited.osim", text.replacen("<radius>0.03</radius>", "<radius>0.031</radius>", 1));
    for verb in ["add bare.osim", "transfer with.osim"] {
        let ran = bench.run(&format!("{verb} --from edited.osim -o out.osim")).wrote_nothing();
        let said = format!("{}{}", ran.out(), ran.err());
        assert!(said.contains("--reference-mass KG") && !said.contains("--contacts-mass"), "{said}");
    }
}

#[test]
fn contacts_by_design_are_made_for_the_mass_of_the_model() {
    let bench = bench();
    let call =
        "add bare.osim --contacts own.csv --class smooth --indentation 0.15 --restitution 0.8 -o made.osim";
    bench.run(call).done();
    bench.run("made.osim --target-mass 70 -o larger.osim").done().wrote(&["larger.osim"]);
    bench.run("transfer made.osim --from made.osim -o same.osim").done();
    let seen = bench.run("inspect made.osim --format json").done().out();
    let seen: Value = serde_json::from_str(&seen).unwrap();
    assert_eq!(seen["contacts_mass_kg"]["source"], "note", "{seen}");
}

#[test]
fn a_map_of_bodies_that_are_not_there_is_refused_by_its_name() {
    let bench = bench();
    let refused = |maps: &str, words: &[&str]| {
        let call = format!("add bare.osim --from falisse2022 {maps} -o out.osim");
        let ran = bench.run(&call).wrote_nothing();
        let text = format!("{}{}", ran.out(), ran.err());
        assert!(words.iter().all(|word| text.contains(word)), "{text}");
        assert!(!text.contains("--body-scale"), "{text}");
    };
    refused("--body-map nope_r=calcn_r", &["--body-map nope_r=calcn_r", "calcn_r", "toes_r"]);
    refused("--body-map toes_r=nope", &["--body-map toes_r=nope", "no body nope", "it has pelvis"]);
    refused("--body-map toes_r=calcn_r --body-map toes_r=toes_r", &["--body-map toes_r=toes_r", "before"]);
}

#[test]
fn planes_that_new_contacts_do_not_meet_are_named() {
    let bench = bench();
    bench.run("add bare.osim --from falisse2022 --contacts own.csv --no-note -o with.osim").done();
    let text = bench.text("with.osim");
    let (before, rest) = text.split_once("<ContactHalfSpace name=\"floor\">").unwrap();
    let (plane, after) = rest.split_once("</ContactHalfSpace>").unwrap();
    let level = "<orientation>0 0 -1.5707963267948966</orientation>";
    let leaning = plane.replace(level, "<orientation>0 0 -1.5</orientation>");
    assert_ne!(leaning, plane);
    bench.write(
        "leaning.osim",
        format!("{before}<ContactHalfSpace name=\"ramp\">{leaning}</ContactHalfSpace>{after}")
            .replace("contactgeometryset/floor", "contactgeometryset/ramp"),
    );
    let call = "add leaning.osim --from falisse2022 --contacts own.csv --spheres 2 --replace -o out.osim";
    let ran = bench.run(call).done().wrote(&["out.osim"]);
    // 1.5707963 - 1.5 rad are 4.05634 degrees.
    ran.says(&["ramp (by 4.0563", "the new forces meet floor", "met ramp, which is not a level floor"]);
    let ran = bench.run(&format!("{} --dry-run", call.replace("leaning", "with"))).done();
    assert!(!format!("{}{}", ran.out(), ran.err()).contains("leans"));
}

#[test]
fn a_class_that_the_opensim_of_the_document_lacks_is_named() {
    let bench =
        Bench::with(&[("feet/human_30000.osim", "old.osim"), (HUMAN, "new.osim"), (TABLE, "own.csv")]);
    let text = |model: &str, more: &str| {
        let call = format!("add {model} --from falisse2022 --contacts own.csv --dry-run {more}");
        bench.run(&call).done().out()
    };
    assert!(text("old.osim", "").contains("came with OpenSim 4.1"));
    assert!(!text("old.osim", "--class hunt-crossley").contains("OpenSim 4.1"));
    assert!(!text("new.osim", "").contains("OpenSim 4.1"));
}

/// The presets were written from published models: contacts of both are the same ones.
#[test]
fn presets_with_places_are_the_models_that_they_come_from() {
    let test = "presets_with_places_are_the_models_that_they_come_from";
    let Some(folder) = corpus(test) else { return };
    for (preset, original, spheres) in
        [("falisse2022", "v40000_falisse_2022_human", 12), ("moco-2d-gait", "v40000_moco_2d_gait", 4)]
    {
        for model in ["v40000_gait2392_without_contacts", "v40000_rajagopal_2016_without_contacts"] {
            let bench = Bench::new();
            let made = |from: &str, reference: &str| -> Vec<(String, Vec<f64>)> {
                let model = folder.join(format!("{model}.osim"));
                let call =
                    format!("add {} --from {from} {reference} --format json --dry-run", model.display());
                let plan: Value = serde_json::from_str(&bench.run(&call).done().out()).unwrap();
                let mut found = Vec::new();
                for object in plan["objects"].as_array().unwrap() {
                    if let Some(place) = object["location_m"].as_array() {
                        let mut numbers: Vec<f64> = place.iter().map(|x| x.as_f64().unwrap()).collect();
                        numbers.push(object["radius_m"].as_f64().unwrap());
                        found.push((object["name"].as_str().unwrap().to_owned(), numbers));
                    }
                }
                assert_eq!(found.len(), spheres, "{from}");
                for change in plan["changes"].as_array().unwrap() {
                    if let (Some(force), Some(to)) = (change["force"].as_str(), change["to"].as_f64()) {
                        let property = change["property"].as_str().unwrap();
                        found.push((format!("{force} {property}"), vec![to]));
                    }
                }
                found.sort_by(|a, b| a.0.cmp(&b.0));
                found
            };
            let file = folder.join(format!("{original}.osim"));
            let (ours, theirs) = (made(preset, ""), made(&file.display().to_string(), "--reference-mass 62"));
            assert_eq!(ours.len(), theirs.len(), "{preset}");
            for ((name, ours), (other, theirs)) in ours.iter().zip(&theirs) {
                assert_eq!(name, other);
                for (ours, theirs) in ours.iter().zip(theirs) {
                    // The paper prints Falisse's numbers with fewer digits than the model has.
                    assert!(
                        (ours - theirs).abs() <= 1e-6 * theirs.abs().max(1e-3),
                        "{name}: {ours}, {theirs}"
                    );
                }
            }
        }
    }
}
