//! `add` with places from a table, in MuSkeMo's format too; the class of the forces, friction and mirror images. What is laid
//! under bones is in `laid`.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::support::Bench;

pub(crate) const HUMAN: &str = "feet/human_40000.osim";
const TABLE: &str = "contact_tables/own.csv";
/// The same as in `fixtures/contact_tables/make_contact_tables.py`: heel and ball of both feet in the frame of their body, m.
const PLACES: [(&str, [f64; 3]); 4] = [
    ("ball_l", [0.16, 0.005, -0.02]),
    ("ball_r", [0.16, 0.005, 0.02]),
    ("heel_l", [0.02, 0.01, 0.005]),
    ("heel_r", [0.02, 0.01, -0.005]),
];
/// What twelve digits of a table leave, m.
const OF_TABLE: f64 = 1e-12;
/// What a few products leave, relative.
const OF_PRODUCTS: f64 = 1e-14;

pub(crate) fn human() -> Bench {
    let meshes = ["l_human_foot", "l_human_toes", "r_human_foot", "r_human_toes"];
    let meshes = meshes.map(|mesh| (format!("feet/Geometry/{mesh}.vtp"), format!("Geometry/{mesh}.vtp")));
    let mut all = vec![(HUMAN, "human.osim"), (TABLE, "own.csv")];
    all.extend(meshes.iter().map(|(from, to)| (from.as_str(), to.as_str())));
    Bench::with(&all)
}

/// A model as `inspect` shows it.
pub(crate) fn inspected(bench: &Bench, model: &str) -> Value {
    serde_json::from_str(&bench.run(&format!("inspect {model} --format json")).done().out()).unwrap()
}

/// Centres and radii by name, m.
pub(crate) fn spheres(seen: &Value) -> BTreeMap<String, ([f64; 3], f64)> {
    let of = |sphere: &Value| {
        let at: Vec<f64> =
            sphere["location_m"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        let place = [at[0], at[1], at[2]];
        (sphere["name"].as_str().unwrap().to_owned(), (place, sphere["radius_m"].as_f64().unwrap()))
    };
    seen["spheres"].as_array().unwrap().iter().map(of).collect()
}

/// A parameter of the force called `name`; NaN where its class does not have it.
fn parameter(seen: &Value, name: &str, property: &str) -> f64 {
    let mut forces = seen["forces"].as_array().unwrap().iter();
    let force = forces.find(|force| force["name"] == name).unwrap_or_else(|| panic!("{name}: {seen}"));
    force["parameters"][property].as_f64().unwrap_or(f64::NAN)
}

#[track_caller]
fn is_close(value: f64, expected: f64) {
    assert!((value / expected - 1.0).abs() <= OF_PRODUCTS, "{value}, not {expected}");
}

/// The spheres are where the table's generator put them.
#[track_caller]
fn are_placed(seen: &Value, tolerance: f64) {
    let spheres = spheres(seen);
    let names: Vec<&str> = spheres.keys().map(String::as_str).collect();
    assert_eq!(names, PLACES.map(|(name, _)| name));
    for (name, expected) in PLACES {
        let (place, _) = spheres[name];
        let apart = place.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart <= tolerance, "{name}: {place:?}");
    }
}

/// One line, this status, nothing written.
#[track_caller]
pub(crate) fn refused(bench: &Bench, call: &str, usage: bool, words: &[&str]) {
    let ran = bench.run(call).wrote_nothing().says(words);
    assert_eq!(ran.err().lines().filter(|line| line.starts_with("error: ")).count(), 1, "{}", ran.err());
    let _ = if usage { ran.usage() } else { ran.failed() };
}

#[test]
fn places_and_radii_of_a_table_are_taken_as_they_are() {
    let bench = human();
    bench.run("add human.osim --contacts own.csv --from falisse2022 -o out.osim").done().wrote(&["out.osim"]);
    let seen = inspected(&bench, "out.osim");
    are_placed(&seen, 0.0);
    assert_eq!(spheres(&seen)["ball_l"].1, 0.025);
    // (10) from 62 kg on 6 spheres of 0.032 m with 1e6 N/m2, to 62 kg on 2 spheres a limb; (14), (C.2), (C.5).
    for (name, radius) in [("force_heel_r", 0.03), ("force_ball_l", 0.025)] {
        let ratio: f64 = radius / 0.032;
        is_close(parameter(&seen, name, "stiffness"), 1e6 * (6.0 / 2.0) / (ratio * ratio));
        is_close(parameter(&seen, name, "dissipation"), 2.0 / ratio.sqrt());
        is_close(parameter(&seen, name, "constant_contact_force"), 1e-5 * ratio * ratio);
        is_close(parameter(&seen, name, "hertz_smoothing"), 300.0 / ratio);
        // Falisse's frictions.
        assert_eq!(parameter(&seen, name, "static_friction"), 0.8);
        assert_eq!(parameter(&seen, name, "viscous_friction"), 0.5);
    }
    // Out again, the file is what it was.
    bench.run("remove out.osim -o back.osim").done();
    assert_eq!(bench.read("back.osim"), bench.read("human.osim"));
}

#[test]
fn a_spreadsheet_of_another_country_says_the_same() {
    let bench = human();
    bench.write("german.csv", crate::support::fixture("contact_tables/own_german.csv"));
    for table in ["own", "german"] {
        bench
            .run(&format!("add human.osim --contacts {table}.csv --from falisse2022 -o {table}.osim"))
            .done();
    }
    // The notes name the tables.
    assert_eq!(bench.text("own.osim").replace("own.csv", "german.csv"), bench.text("german.osim"));
}

#[test]
fn an_export_of_muskemo_is_read_in_both_of_its_modes() {
    let bench = human();
    for name in ["muskemo_local.csv", "muskemo_global.csv", "global_mode.osim", "bad/places_differ.csv"] {
        bench.write(name, crate::support::fixture(&format!("contact_tables/{name}")));
    }
    // Bodies with frames of their own: the local columns, which agree with where ground has them.
    bench.run("add human.osim --contacts muskemo_local.csv --from falisse2022 -o local.osim").done();
    are_placed(&inspected(&bench, "local.osim"), 0.0);
    // Radii as large against the body as the reference's: here for 8 times the mass. Their size is said.
    bench
        .run("add human.osim --contacts muskemo_local.csv --from falisse2022 --mass 496 --dry-run")
        .done()
        // 0.032 m times the cube root of 496/62.
        .says(&["radii are the reference's, times the cube root of the masses' ratio (8): 0.064 m"]);
    // And for the same mass.
    assert!(spheres(&inspected(&bench, "local.osim")).values().all(|(_, radius)| *radius == 0.032));

    // Bodies in ground: the global ones.
    bench.run("add global_mode.osim --contacts muskemo_global.csv --from falisse2022 -o global.osim").done();
    let (heel, _) = spheres(&inspected(&bench, "global.osim"))["heel_r"];
    assert_eq!(heel, [-0.090_545_266_246_5, 0.02, 0.088_430_200_966_5]);

    // Global ones alone, where bodies are elsewhere: only at the default pose, and that is said.
    let alone = "add human.osim --contacts muskemo_global.csv --from falisse2022";
    refused(
        &bench,
        alone,
        false,
        &["muskemo_global.csv, line 2: heel_r has a place in ground only", "--default-pose"],
    );
    bench
        .run(&format!("{alone} --default-pose -o posed.osim"))
        .done()
        .says(&["at the default pose: heel_r, ball_r, heel_l, ball_l"]);
    are_placed(&inspected(&bench, "posed.osim"), OF_TABLE);

    let differ = "add human.osim --contacts bad/places_differ.csv --from falisse2022";
    refused(
        &bench,
        differ,
        false,
        &["line 2: heel_r has two places, and in this model they are 2.5 mm apart"],
    );
    let other = "add global_mode.osim --contacts muskemo_local.csv --from falisse2022";
    refused(&bench, other, false, &["line 2: heel_r has two places"]);
}

#[test]
fn a_table_that_is_wrong_is_refused_with_its_line() {
    let bench = human();
    for (table, words) in [
        ("no_column", "no column 'z' in the first row"),
        ("other_column", "the column 'radus' is not known"),
        ("millimetres", "the column 'x [mm]' is not in metres"),
        ("no_number", "table.csv:3:4: column 'y': 'O.005' is not a number"),
        ("no_radius", "table.csv:3:6: column 'radius': the cell is empty, expected a number"),
        ("blank_in_name", "table.csv:3:1: column 'name': the name 'right ball' has a blank in it"),
        ("twice", "table.csv:3:1: column 'name': the name 'heel_r' is in line 2 already"),
        ("not_assigned", "table.csv:2:5: column 'parent_body': 'not_assigned' is not a body"),
        ("empty", "there are no rows"),
        ("no_such_body", "line 3: there is no body calcaneus_r, the model has pelvis, femur_r"),
    ] {
        bench.write("table.csv", crate::support::fixture(&format!("contact_tables/bad/{table}.csv")));
        let call = "add human.osim --contacts table.csv --from falisse2022";
        refused(&bench, call, false, &["table.csv", words]);
    }
    refused(
        &bench,
        "add human.osim --contacts nowhere.csv --from falisse2022",
        false,
        &["nowhere.csv: there is no such file"],
    );
    // Millimetres in the cells.
    bench.write("mm.csv", "name,body,x,y,z,radius\nheel_r,calcn_r,0.02,0.01,0,30\n");
    let call = "add human.osim --contacts mm.csv --from falisse2022";
    refused(&bench, call, false, &["the radius of heel_r would be 30 m", "--yes implausible-radius"]);
}

#[test]
fn numbers_may_follow_from_what_is_wanted() {
    let bench = human();
    let call = "add human.osim --contacts own.csv --class hunt-crossley --indentation 0.1 --restitution 0.5 --impact-speed 0.5 \
                --static-friction 0.7 -o out.osim";
    bench.run(call).done().says(&[
        "so OpenSim's defaults are written: dynamic_friction 0, viscous_friction 0, transition_velocity 0.01",
    ]);
    let seen = inspected(&bench, "out.osim");
    // (11): E* = 3 F / (4 R^2 x^1.5), (A.4): two equal surfaces have 2^1.5 E*; 62 kg on two spheres a limb, at 9.81 m/s2.
    let force = 62.0 * 9.81 / 2.0;
    for (name, radius) in [("force_heel_r", 0.03), ("force_ball_r", 0.025)] {
        let composite = 3.0 * force / (4.0 * radius * radius * 0.1_f64.powf(1.5));
        is_close(parameter(&seen, name, "stiffness"), 2_f64.powf(1.5) * composite);
        // (13): (1 - 0.5) / 0.5 m/s.
        is_close(parameter(&seen, name, "dissipation"), 1.0);
        assert_eq!(parameter(&seen, name, "static_friction"), 0.7);
        assert!(parameter(&seen, name, "hertz_smoothing").is_nan());
    }
    bench.run("remove out.osim -o back.osim").done();
    assert_eq!(bench.read("back.osim"), bench.read("human.osim"));
}

#[test]
fn a_class_that_is_not_the_references_is_converted() {
    let bench = human();
    bench.write("reference.osim", crate::support::fixture("table1/human_62kg_hunt_crossley.osim"));
    bench.run("add human.osim --contacts own.csv --from reference.osim --class smooth -o smooth.osim").done();
    let seen = inspected(&bench, "smooth.osim");
    assert_eq!(seen["forces"][0]["type"], "SmoothSphereHalfSpaceForce");
    // The smoothing of Falisse et al. at 0.032 m: 1e-5 m2, 300/m, 50 s/m; (C.2), (C.5), (C.10).
    let ratio: f64 = 0.025 / 0.032;
    is_close(parameter(&seen, "force_ball_r", "constant_contact_force"), 1e-5 * ratio * ratio);
    is_close(parameter(&seen, "force_ball_r", "hertz_smoothing"), 300.0 / ratio);
    is_close(parameter(&seen, "force_ball_r", "hunt_crossley_smoothing"), 50.0 / ratio.sqrt());
    is_close(parameter(&seen, "force_ball_r", "stiffness"), 1e6 * (6.0 / 2.0) / (ratio * ratio));

    bench.write("reference.osim", crate::support::fixture("table1/human_62kg_smooth_sphere.osim"));
    for call in ["", "--contacts own.csv"] {
        bench
            .run(&format!(
                "add human.osim {call} --from reference.osim --class hunt-crossley -o hard.osim --force"
            ))
            .done();
        let seen = inspected(&bench, "hard.osim");
        let force = &seen["forces"][0];
        assert_eq!(force["type"], "HuntCrossleyForce");
        assert!(!bench.text("hard.osim").contains("hertz_smoothing"));
    }
}

#[test]
fn a_reference_whose_contacts_differ_is_asked_about() {
    let bench = human();
    let text = String::from_utf8(crate::support::fixture("table1/human_62kg_smooth_sphere.osim")).unwrap();
    // The first of its spheres is smaller.
    let radius = "<radius>0.032000000000000001</radius>";
    bench.write("reference.osim", text.replacen(radius, "<radius>0.02</radius>", 1));
    bench.write("bare.csv", "name,body,x,y,z\nheel_r,calcn_r,0,0,0\nheel_l,calcn_l,0,0,0\n");
    let table = "add human.osim --contacts bare.csv --from reference.osim";
    refused(
        &bench,
        table,
        false,
        &["radii differ in reference.osim", "--radius METRES", "--reference-sphere NAME"],
    );
    refused(
        &bench,
        &format!("{table} --radius 0.03"),
        false,
        &["the contacts of reference.osim differ from each other", "heel_r, heel_l"],
    );
    refused(
        &bench,
        &format!("{table} --reference-sphere nobody"),
        false,
        &["--reference-sphere nobody is not in reference.osim"],
    );
    let feet = "add human.osim --feet calcn_r,calcn_l --count 1 --pad 0.01 --from reference.osim";
    for call in [table, feet] {
        bench
            .run(&format!("{call} --reference-sphere s2_r --static-friction 0.4 -o out.osim --force"))
            .done();
        let seen = inspected(&bench, "out.osim");
        assert!(
            spheres(&seen).values().all(|(_, radius)| (radius / 0.032 - 1.0).abs() < OF_PRODUCTS),
            "{seen}"
        );
        let force = seen["forces"][0]["name"].as_str().unwrap();
        // What is said counts for more than the reference's 0.8.
        assert_eq!(parameter(&seen, force, "static_friction"), 0.4);
    }
    // By its name, each has its own: (8) with equal masses.
    bench.write("named.csv", "name,body,x,y,z\ns1_r,calcn_r,0,0,0\ns2_r,calcn_r,0.1,0,0\n");
    bench.run("add human.osim --contacts named.csv --from reference.osim -o named.osim").done();
    let found = spheres(&inspected(&bench, "named.osim"));
    assert_eq!((found["s1_r"].1, found["s2_r"].1), (0.02, 0.032));
}

#[test]
fn what_is_not_said_is_asked_for() {
    let bench = human();
    let table = "add human.osim --contacts own.csv";
    refused(&bench, "add human.osim", true, &["--from MODEL|PRESET", "--contacts TABLE", "--feet BODY,BODY"]);
    refused(&bench, table, true, &["--from MODEL|PRESET", "--indentation X"]);
    refused(&bench, &format!("{table} --restitution 0.5"), true, &["--indentation X"]);
    refused(
        &bench,
        &format!("{table} --indentation 0.1"),
        true,
        &["--class smooth|hunt-crossley is missing"],
    );
    refused(&bench, &format!("{table} --from falisse2022 --indentation 0.1"), true, &["--indentation"]);
    refused(&bench, &format!("{table} --from falisse2022 --radius 0.03"), true, &["leave one out"]);
    refused(&bench, &format!("{table} --feet calcn_r --count 2 --pad 0"), true, &["--feet"]);
    refused(
        &bench,
        "add human.osim --from falisse2022 --count 2",
        true,
        &["--count says nothing without --feet"],
    );
    // Bones without skin stand on the ground themselves: 0 is a pad, and what is below it is none.
    let feet = "add human.osim --feet calcn_r --count 2 --from falisse2022 --pad";
    refused(&bench, &format!("{feet} -0.1"), true, &["--pad '-0.1': expected metres, 0 or more"]);
    refused(&bench, &format!("{feet} 5mm"), true, &["type 0.005"]);
    bench.run(&format!("{feet} 0 --dry-run")).done();
    bench.write("bare.csv", "name,body,x,y,z\nheel_r,calcn_r,0,0,0\n");
    let bare = "add human.osim --contacts bare.csv --class smooth --indentation 0.1";
    refused(&bench, bare, true, &["--radius METRES is missing"]);
}

#[test]
fn a_model_that_weighs_nothing_is_refused() {
    let bench = human();
    let text = bench.text("human.osim");
    let weightless: String = text
        .split_inclusive('\n')
        .map(|line| match line.contains("<mass>") {
            true => "<mass>0</mass>\n".to_owned(),
            false => line.to_owned(),
        })
        .collect();
    bench.write("zero.osim", weightless);
    bench.write("reference.osim", crate::support::fixture("table1/human_62kg_smooth_sphere.osim"));
    for call in [
        "--from reference.osim",
        "--contacts own.csv --from falisse2022",
        "--contacts own.csv --class smooth --indentation 0.1",
        "--feet calcn_r --count 2 --pad 0.01 --from falisse2022",
    ] {
        refused(
            &bench,
            &format!("add zero.osim {call}"),
            false,
            &["the 9 bodies weigh 0 kg in all: say what the model weighs with --mass KG\n"],
        );
        bench.run(&format!("add zero.osim {call} --mass 62 -o out.osim --force")).done();
    }
}

#[test]
fn a_reference_of_one_side_is_mirrored() {
    let bench = human();
    bench.write("both.osim", crate::support::fixture("table1/human_62kg_smooth_sphere.osim"));
    bench.run("remove both.osim --select *_l* -o right.osim").done();
    bench.run("add human.osim --from both.osim -o of_both.osim").done();
    bench.run("add human.osim --from right.osim --mirror z -o of_right.osim").done();
    let (both, right) = (inspected(&bench, "of_both.osim"), inspected(&bench, "of_right.osim"));
    // Its spheres are mirror images of each other, called by other numbers.
    let places = |seen: &Value| {
        let mut all: Vec<String> = spheres(seen).values().map(|sphere| format!("{sphere:?}")).collect();
        all.sort();
        all
    };
    assert_eq!(places(&both), places(&right));
    assert_eq!(spheres(&right).len(), 12);

    refused(&bench, "add human.osim --from both.osim --mirror z", false, &["has contacts on both sides"]);
    refused(&bench, "add human.osim --contacts own.csv --from right.osim --mirror z", true, &["--mirror"]);
    let text = bench.text("human.osim").replace("calcn_l", "stump");
    bench.write("stump.osim", text);
    refused(&bench, "add stump.osim --from right.osim --mirror z", false, &["the model lacks body calcn_l"]);
}
