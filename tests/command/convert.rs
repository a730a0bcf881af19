//! `convert` and `remove`: messages about changes, and about contacts that stay.

use crate::support::TestDir;

const HUNT_CROSSLEY_MODEL: (&str, &str) = ("table1/human_62kg_hunt_crossley.osim", "hunt.osim");

/// Writes `bare.osim`, a human without contacts, and `with.osim`, the human after `add`.
fn write_human_with_contacts(dir: &TestDir) {
    dir.write("bare.osim", crate::support::fixture("feet/human_40000.osim"));
    dir.write("own.csv", crate::support::fixture("contact_tables/own.csv"));
    dir.run("add bare.osim --contacts own.csv --from falisse2022 -o with.osim").succeeded();
}

/// A model that has one more force, with a half-space but without a sphere.
fn model_with_force_without_sphere() -> TestDir {
    let dir = TestDir::with(&[HUNT_CROSSLEY_MODEL]);
    let text = dir.text("hunt.osim");
    let set = "<HuntCrossleyForce::ContactParameters><geometry>floor</geometry></HuntCrossleyForce::ContactParameters>";
    let force = format!(
        "<HuntCrossleyForce name=\"floor_only\"><HuntCrossleyForce::ContactParametersSet name=\"contact_parameters\"><objects>{set}\
         </objects></HuntCrossleyForce::ContactParametersSet></HuntCrossleyForce>"
    );
    let at = text.find("<HuntCrossleyForce ").unwrap();
    dir.write("odd.osim", format!("{}{force}{}", &text[..at], &text[at..]));
    dir
}

#[test]
fn a_force_without_a_moving_sphere_stays_and_is_named() {
    let dir = model_with_force_without_sphere();
    dir.run("convert odd.osim --to smooth -o out.osim")
        .succeeded()
        .says(&["remark: /forceset/floor_only holds no sphere that moves, and stays as it is"]);
    assert!(dir.text("out.osim").contains("<HuntCrossleyForce name=\"floor_only\">"));
    // If only this force is selected, nothing changes.
    let none = dir
        .run("convert odd.osim --to smooth --select floor_only -o none.osim")
        .succeeded()
        .says(&["/forceset/floor_only holds no sphere that moves, and stays as it is", "no force changes"]);
    assert!(!none.out().contains("already"), "{}", none.out());
}

#[test]
fn a_force_without_a_half_space_is_refused_with_a_way_out() {
    let dir = TestDir::with(&[HUNT_CROSSLEY_MODEL]);
    let text = dir.text("hunt.osim");
    dir.write("kick.osim", text.replacen("<geometry>floor s1_r<", "<geometry>s1_r<", 1));
    dir.run("convert kick.osim --to smooth -o out.osim")
        .failed()
        .says(&["contact_s1_r has no half-space", "--exclude contact_s1_r"]);
    dir.run("convert kick.osim --to smooth --exclude contact_s1_r -o out.osim").succeeded();
    // The message is about the selected forces.
    dir.run("convert kick.osim --to hunt-crossley --exclude contact_s1_r --dry-run")
        .succeeded()
        .says(&["every chosen force is a HuntCrossleyForce for one sphere already"]);
}

#[test]
fn the_note_stays_while_some_contacts_are_left() {
    let dir = TestDir::new();
    write_human_with_contacts(&dir);
    dir.run("remove with.osim --select force_heel* -o half.osim").succeeded().says(&[
        "remark: some contacts are left, and the note in the file now counts as one about a part",
        "--contacts-mass 62",
    ]);
    dir.run("half.osim --target-mass 80 --dry-run").failed().says(&["62 kg", "--contacts-mass"]);
    dir.run("remove half.osim -o first.osim").succeeded().says_not(&["contacts are left"]);
    assert_eq!(dir.read("first.osim"), dir.read("bare.osim"));

    // If the note is removed, the program says so.
    dir.run("remove with.osim --select force_heel* --no-note -o unknown.osim")
        .succeeded()
        .says(&["the note is removed"]);
}

#[test]
fn objects_that_refer_to_removed_contacts_are_named() {
    let dir = TestDir::new();
    write_human_with_contacts(&dir);
    let group = "<ObjectGroup name=\"feet\"><members>force_heel_r force_ball_r force_heel_l force_ball_l other</members></ObjectGroup>";
    let spheres = "<ObjectGroup name=\"heels\"><members> heel_r\n\theel_l </members></ObjectGroup>";
    let reporter = "<TableReporter name=\"loads\"><input_inputs>/forceset/force_ball_r|power /bodyset/calcn_r|mass_center</input_inputs>\
                    </TableReporter>";
    let text = dir.text("with.osim");
    let (forces, geometry) = text.split_once("<ContactGeometrySet").unwrap();
    let (forces, rest) = forces.rsplit_once("</ForceSet>").unwrap();
    let forces = forces.replace("<groups />", "").replace("<groups/>", "");
    let geometry = geometry.replacen(
        "</ContactGeometrySet>",
        &format!("<groups>{spheres}</groups></ContactGeometrySet>"),
        1,
    );
    let geometry = geometry.replacen("<groups />", "", 1);
    dir.write(
        "named.osim",
        format!("{forces}<groups>{group}</groups></ForceSet>{rest}<ContactGeometrySet{geometry}")
            .replace("\n\t</Model>", &format!("\n\t\t<components>{reporter}</components>\n\t</Model>")),
    );
    let run = dir.run("remove named.osim -o all.osim").succeeded().says(&[
        "remark: ObjectGroup feet still names force_heel_r, force_ball_r, force_heel_l and 1 more, gone from this model",
        "remark: ObjectGroup heels still names heel_r, heel_l, gone from this model",
        "remark: TableReporter loads still names force_ball_r, gone from this model",
    ]);
    assert_eq!(run.out().matches("still names").count(), 3, "{}", run.out());
    // References to objects that stay are not reported.
    let run = dir.run("remove named.osim --select force_heel_l -o some.osim").succeeded();
    assert_eq!(run.out().matches("still names").count(), 2, "{}", run.out());
    let run = dir.run("remove with.osim -o none.osim").succeeded();
    assert!(!run.out().contains("still names"), "{}", run.out());
}

fn parse_json(run: &crate::support::CommandRun) -> serde_json::Value {
    serde_json::from_str(&run.out()).unwrap()
}

#[test]
fn convert_reports_the_smoothing_parameters() {
    let dir = TestDir::with(&[HUNT_CROSSLEY_MODEL]);
    // (C.2), (C.5), (C.10) from 1e-5 m2, 300 1/m and 50 s/m at 0.032 m, which is this human's radius.
    let remark = "remark: smoothing of 12 forces: constant_contact_force 0.00001 m2, hertz_smoothing 300 1/m, hunt_crossley_smoothing 50 s/m";
    let defaults = "about 90 times the force of a HuntCrossleyForce at 0.1 mm";
    dir.run("convert hunt.osim --to smooth -o out.osim").succeeded().says(&[
        remark,
        "(C.2), (C.5), (C.10)",
        defaults,
    ]);
    // Given numbers are reported as given, without the remark about OpenSim's defaults.
    let given = "convert hunt.osim --to smooth --constant-contact-force 1e-7 --hertz-smoothing 500 --hunt-crossley-smoothing 60";
    let run = dir
        .run(&format!("{given} -o given.osim"))
        .succeeded()
        .says(&["constant_contact_force 1e-7 m2, hertz_smoothing 500 1/m, hunt_crossley_smoothing 60 s/m"]);
    assert!(!run.out().contains("90 times") && !run.out().contains("(C.2)"), "{}", run.out());
    // In JSON each new force has its parameters; a removed one has none.
    let record = parse_json(&dir.run(&format!("{given} --dry-run --format json")).succeeded());
    for object in record["objects"].as_array().unwrap() {
        let parameters = &object["parameters"];
        if object["change"] == "removed" {
            assert!(parameters.is_null());
            continue;
        }
        assert_eq!(parameters["constant_contact_force"], 1e-7);
        assert_eq!(
            (&parameters["hertz_smoothing"], &parameters["hunt_crossley_smoothing"]),
            (&500.0.into(), &60.0.into())
        );
        assert_eq!(parameters["stiffness"], 1e6);
    }
    // In the other direction nothing is smoothed.
    let run = dir.run("convert out.osim --to hunt-crossley -o back.osim").succeeded();
    assert!(!run.out().contains("smoothing of"), "{}", run.out());
}

#[test]
fn convert_asks_if_the_body_would_float() {
    let dir = TestDir::with(&[HUNT_CROSSLEY_MODEL]);
    let call = "convert hunt.osim --to smooth --constant-contact-force 1e-2";
    let question = "the model would be wrong afterwards [floats]: body weight is carried ";
    let advice = "until the spheres touch the floor, with --constant-contact-force and --hertz-smoothing, or confirm this";
    dir.run(call).failed().wrote_nothing().says(&[question, advice, "--yes wrong-afterwards"]);
    let floats = dir.run(&format!("{call} -o floats.osim --yes wrong-afterwards")).succeeded();
    let floats = floats.says(&["error: in the new model: ", "[floats]", "[force-before-contact]"]);
    // `check` reports the same about the result.
    let check =
        dir.run("check floats.osim").says(&["[floats; ", "force-before-contact", "design floats.osim "]);
    let above = |text: String| text.split("carried ").nth(1).unwrap().split(" R").next().unwrap().to_owned();
    assert_eq!(above(floats.out()), above(check.out()));
    // With Falisse's smoothing there is no warning.
    let run = dir.run("convert hunt.osim --to smooth -o out.osim").succeeded();
    assert!(!run.out().contains("warning"), "{}", run.out());
}

#[test]
fn convert_refuses_options_without_effect() {
    let dir = TestDir::with(&[HUNT_CROSSLEY_MODEL]);
    for option in ["--constant-contact-force 1e-6", "--hertz-smoothing 5", "--hunt-crossley-smoothing 5"] {
        let name = option.split(' ').next().unwrap();
        dir.run(&format!("convert hunt.osim --to hunt-crossley {option} -o out.osim"))
            .usage_error()
            .wrote_nothing()
            .says(&[name, "--to smooth"]);
    }
    for verb in ["remove hunt.osim", "convert hunt.osim --to smooth"] {
        dir.run(&format!("{verb} --geometry-output set.xml -o out.osim"))
            .usage_error()
            .wrote_nothing()
            .says(&["--geometry-output", "needs a whole model"]);
        let help = dir.run(&format!("{} --help", verb.split(' ').next().unwrap())).succeeded().out();
        assert!(!help.contains("geometry-output"), "{help}");
    }
}

#[test]
fn convert_reports_names_with_the_old_class() {
    let dir = TestDir::with(&[HUNT_CROSSLEY_MODEL]);
    let text = dir.text("hunt.osim").replace("\"contact_s1_r\"", "\"HuntCrossleyForce_s1_r\"");
    dir.write("named.osim", text);
    dir.run("convert named.osim --to smooth -o out.osim").succeeded().says(&[
        "remark: names stay, also where they contain the name of the other class: HuntCrossleyForce_s1_r",
    ]);
}

#[test]
fn convert_and_remove_name_a_class_they_cannot_change() {
    let dir = TestDir::with(&[HUNT_CROSSLEY_MODEL]);
    let other = "<ElasticFoundationForce name=\"plate\"/>";
    let text = dir.text("hunt.osim");
    let (before, rest) = text.split_once("<HuntCrossleyForce ").unwrap();
    let (_, after) = rest.rsplit_once("</HuntCrossleyForce>").unwrap();
    dir.write("elastic.osim", format!("{before}{other}{after}"));
    for call in ["convert elastic.osim --to smooth", "remove elastic.osim"] {
        dir.run(call)
            .failed()
            .says(&["the model has no contacts", "an ElasticFoundationForce cannot be changed"]);
    }
}

#[test]
fn convert_connects_sockets_and_changes_no_other_byte() {
    let text = String::from_utf8(crate::support::fixture("format/v40000.osim")).unwrap();
    let bare = text.replace(">/bodyset/", ">").replace(">/ground<", "> ground <");
    let dir = TestDir::new();
    dir.write("bare.osim", &bare);
    dir.run("convert bare.osim --sockets -o right.osim").succeeded().says(&["no other byte changes"]);
    assert_eq!(dir.text("right.osim"), text.replace(">/ground<", "> /ground <"));
    // A second time there is nothing to do.
    dir.run("convert right.osim --sockets -o again.osim").succeeded();
    assert_eq!(dir.text("again.osim"), dir.text("right.osim"));
    dir.run("convert bare.osim --sockets --to smooth -o both.osim").usage_error();
    dir.run("convert bare.osim -o neither.osim").usage_error();
}
