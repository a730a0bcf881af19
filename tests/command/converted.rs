//! `convert` and `remove`: what is said of what they do, and of what they leave.

use crate::support::Bench;

const HUNT: (&str, &str) = ("table1/human_62kg_hunt_crossley.osim", "hunt.osim");

/// A model that `add` gave contacts: `with.osim`, and what it was: `bare.osim`.
fn added(bench: &Bench) {
    bench.write("bare.osim", crate::support::fixture("feet/human_40000.osim"));
    bench.write("own.csv", crate::support::fixture("contact_tables/own.csv"));
    bench.run("add bare.osim --contacts own.csv --from falisse2022 -o with.osim").done();
}

/// A model with a force that holds a half-space alone beside the others.
fn with_floor_only() -> Bench {
    let bench = Bench::with(&[HUNT]);
    let text = bench.text("hunt.osim");
    let set = "<HuntCrossleyForce::ContactParameters><geometry>floor</geometry></HuntCrossleyForce::ContactParameters>";
    let force = format!(
        "<HuntCrossleyForce name=\"floor_only\"><HuntCrossleyForce::ContactParametersSet name=\"contact_parameters\"><objects>{set}\
         </objects></HuntCrossleyForce::ContactParametersSet></HuntCrossleyForce>"
    );
    let at = text.find("<HuntCrossleyForce ").unwrap();
    bench.write("odd.osim", format!("{}{force}{}", &text[..at], &text[at..]));
    bench
}

#[test]
fn a_force_without_a_sphere_stays_and_is_named() {
    let bench = with_floor_only();
    bench
        .run("convert odd.osim --to smooth -o out.osim")
        .done()
        .says(&["remark: /forceset/floor_only holds no sphere that moves, and stays as it is"]);
    assert!(bench.text("out.osim").contains("<HuntCrossleyForce name=\"floor_only\">"));
    // Where nothing else is chosen, nothing changes.
    let none = bench
        .run("convert odd.osim --to smooth --select floor_only -o none.osim")
        .done()
        .says(&["/forceset/floor_only holds no sphere that moves, and stays as it is", "no force changes"]);
    assert!(!none.out().contains("already"), "{}", none.out());
}

#[test]
fn a_force_that_cannot_be_divided_is_refused_with_the_way_out() {
    let bench = Bench::with(&[HUNT]);
    let text = bench.text("hunt.osim");
    bench.write("kick.osim", text.replacen("<geometry>floor s1_r<", "<geometry>s1_r<", 1));
    bench
        .run("convert kick.osim --to smooth -o out.osim")
        .failed()
        .says(&["contact_s1_r has no half-space", "--exclude contact_s1_r"]);
    bench.run("convert kick.osim --to smooth --exclude contact_s1_r -o out.osim").done();
    // What is said is about the chosen forces.
    bench
        .run("convert kick.osim --to hunt-crossley --exclude contact_s1_r --dry-run")
        .done()
        .says(&["every chosen force is a HuntCrossleyForce for one sphere already"]);
}

#[test]
fn what_was_made_is_known_while_a_part_of_it_is_left() {
    let bench = Bench::new();
    added(&bench);
    bench
        .run("remove with.osim --select force_heel* -o half.osim")
        .done()
        .says(&["remark: contacts are left, and so is the note in the file", "--contacts-mass 62"]);
    bench.run("half.osim --target-mass 80 --dry-run").failed().says(&["62 kg", "--contacts-mass"]);
    let rest = bench.run("remove half.osim -o first.osim").done();
    assert!(!rest.out().contains("note:"), "{}", rest.out());
    assert_eq!(bench.read("first.osim"), bench.read("bare.osim"));

    // Without a note, that what was made is not known is said.
    bench
        .run("remove with.osim --select force_heel* --no-note -o unknown.osim")
        .done()
        .says(&["the note is removed"]);
}

#[test]
fn objects_that_name_what_went_are_named() {
    let bench = Bench::new();
    added(&bench);
    let group = "<ObjectGroup name=\"feet\"><members>force_heel_r force_ball_r force_heel_l force_ball_l other</members></ObjectGroup>";
    let spheres = "<ObjectGroup name=\"heels\"><members> heel_r\n\theel_l </members></ObjectGroup>";
    let reporter = "<TableReporter name=\"loads\"><input_inputs>/forceset/force_ball_r|power /bodyset/calcn_r|mass_center</input_inputs>\
                    </TableReporter>";
    let text = bench.text("with.osim");
    let (forces, geometry) = text.split_once("<ContactGeometrySet").unwrap();
    let (forces, rest) = forces.rsplit_once("</ForceSet>").unwrap();
    let forces = forces.replace("<groups />", "").replace("<groups/>", "");
    let geometry = geometry.replacen(
        "</ContactGeometrySet>",
        &format!("<groups>{spheres}</groups></ContactGeometrySet>"),
        1,
    );
    let geometry = geometry.replacen("<groups />", "", 1);
    bench.write(
        "named.osim",
        format!("{forces}<groups>{group}</groups></ForceSet>{rest}<ContactGeometrySet{geometry}")
            .replace("\n\t</Model>", &format!("\n\t\t<components>{reporter}</components>\n\t</Model>")),
    );
    let ran = bench.run("remove named.osim -o all.osim").done().says(&[
        "remark: ObjectGroup feet still names force_heel_r, force_ball_r, force_heel_l and 1 more, gone from this model",
        "remark: ObjectGroup heels still names heel_r, heel_l, gone from this model",
        "remark: TableReporter loads still names force_ball_r, gone from this model",
    ]);
    assert_eq!(ran.out().matches("still names").count(), 3, "{}", ran.out());
    // What stays may be named.
    let ran = bench.run("remove named.osim --select force_heel_l -o some.osim").done();
    assert_eq!(ran.out().matches("still names").count(), 2, "{}", ran.out());
    let ran = bench.run("remove with.osim -o none.osim").done();
    assert!(!ran.out().contains("still names"), "{}", ran.out());
}

fn json(ran: &crate::support::Ran) -> serde_json::Value {
    serde_json::from_str(&ran.out()).unwrap()
}

#[test]
fn numbers_of_the_smoothed_law_are_told() {
    let bench = Bench::with(&[HUNT]);
    // (C.2), (C.5), (C.10) from 1e-5 m2, 300 1/m and 50 s/m at 0.032 m, which is this human's radius.
    let told = "remark: smoothing of 12 forces: constant_contact_force 0.00001 m2, hertz_smoothing 300 1/m, hunt_crossley_smoothing 50 s/m";
    let defaults = "about 90 times the force of a HuntCrossleyForce at 0.1 mm";
    bench.run("convert hunt.osim --to smooth -o out.osim").done().says(&[
        told,
        "(C.2), (C.5), (C.10)",
        defaults,
    ]);
    // What is given is told as it is, and what OpenSim's defaults do is not said of other numbers.
    let given = "convert hunt.osim --to smooth --constant-contact-force 1e-7 --hertz-smoothing 500 --hunt-crossley-smoothing 60";
    let ran = bench
        .run(&format!("{given} -o given.osim"))
        .done()
        .says(&["constant_contact_force 1e-7 m2, hertz_smoothing 500 1/m, hunt_crossley_smoothing 60 s/m"]);
    assert!(!ran.out().contains("90 times") && !ran.out().contains("(C.2)"), "{}", ran.out());
    // In JSON each force has its numbers; what goes has none.
    let record = json(&bench.run(&format!("{given} --dry-run --format json")).done());
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
    // The other way nothing is smoothed.
    let ran = bench.run("convert out.osim --to hunt-crossley -o back.osim").done();
    assert!(!ran.out().contains("smoothing of"), "{}", ran.out());
}

#[test]
fn a_body_that_would_float_is_warned_of() {
    let bench = Bench::with(&[HUNT]);
    let floats = "convert hunt.osim --to smooth --constant-contact-force 1e-2 -o floats.osim";
    bench.run(floats).done().says(&["[floats]", "[force-before-contact]", "--constant-contact-force"]);
    // `check` says the same of the result.
    let found = bench.run("check floats.osim").says(&["error floats", "force-before-contact"]);
    let above = |text: String| text.split("carried ").nth(1).unwrap().split(" R").next().unwrap().to_owned();
    assert_eq!(
        above(bench.run("convert hunt.osim --to smooth --constant-contact-force 1e-2 --dry-run").out()),
        above(found.out())
    );
    // With Falisse's own smoothing nothing is said.
    let ran = bench.run("convert hunt.osim --to smooth -o out.osim").done();
    assert!(!ran.out().contains("warning"), "{}", ran.out());
}

#[test]
fn options_that_would_do_nothing_are_refused() {
    let bench = Bench::with(&[HUNT]);
    for option in ["--constant-contact-force 1e-6", "--hertz-smoothing 5", "--hunt-crossley-smoothing 5"] {
        let name = option.split(' ').next().unwrap();
        bench
            .run(&format!("convert hunt.osim --to hunt-crossley {option} -o out.osim"))
            .usage()
            .wrote_nothing()
            .says(&[name, "--to smooth"]);
    }
    for verb in ["remove hunt.osim", "convert hunt.osim --to smooth"] {
        bench
            .run(&format!("{verb} --geometry-output set.xml -o out.osim"))
            .usage()
            .wrote_nothing()
            .says(&["--geometry-output", "whole models"]);
        let help = bench.run(&format!("{} --help", verb.split(' ').next().unwrap())).done().out();
        assert!(!help.contains("geometry-output"), "{help}");
    }
}

#[test]
fn names_that_say_the_old_class_are_told() {
    let bench = Bench::with(&[HUNT]);
    let text = bench.text("hunt.osim").replace("\"contact_s1_r\"", "\"HuntCrossleyForce_s1_r\"");
    bench.write("named.osim", text);
    bench
        .run("convert named.osim --to smooth -o out.osim")
        .done()
        .says(&["remark: names stay, also where they say the other class: HuntCrossleyForce_s1_r"]);
}

#[test]
fn a_class_that_is_not_changed_is_named() {
    let bench = Bench::with(&[HUNT]);
    let other = "<ElasticFoundationForce name=\"plate\"/>";
    let text = bench.text("hunt.osim");
    let (before, rest) = text.split_once("<HuntCrossleyForce ").unwrap();
    let (_, after) = rest.rsplit_once("</HuntCrossleyForce>").unwrap();
    bench.write("elastic.osim", format!("{before}{other}{after}"));
    for call in ["convert elastic.osim --to smooth", "remove elastic.osim"] {
        bench
            .run(call)
            .failed()
            .says(&["the model has no contacts", "an ElasticFoundationForce cannot be changed"]);
    }
}
