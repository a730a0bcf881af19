//! `add` with places from a table (also in MuSkeMo's format), the class of the forces, friction and mirror images. Spheres under
//! bones are tested in `add_feet`.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::support::TestDir;

pub(crate) const HUMAN: &str = "feet/human_40000.osim";
const TABLE_OF_PLACES: &str = "contact_tables/own.csv";
/// Heel and ball of both feet in the frame of their body, m, as `fixtures/contact_tables/make_contact_tables.py` writes them.
const PLACES_IN_TABLE: [(&str, [f64; 3]); 4] = [
    ("ball_l", [0.16, 0.005, -0.02]),
    ("ball_r", [0.16, 0.005, 0.02]),
    ("heel_l", [0.02, 0.01, 0.005]),
    ("heel_r", [0.02, 0.01, -0.005]),
];
/// Rounding error of twelve digits in a table, m.
const TABLE_TOLERANCE: f64 = 1e-12;
/// Relative rounding error of a few products.
const PRODUCT_TOLERANCE: f64 = 1e-14;

pub(crate) fn human_with_meshes() -> TestDir {
    let meshes = ["l_human_foot", "l_human_toes", "r_human_foot", "r_human_toes"];
    let meshes = meshes.map(|mesh| (format!("feet/Geometry/{mesh}.vtp"), format!("Geometry/{mesh}.vtp")));
    let mut all = vec![(HUMAN, "human.osim"), (TABLE_OF_PLACES, "own.csv")];
    all.extend(meshes.iter().map(|(from, to)| (from.as_str(), to.as_str())));
    TestDir::with(&all)
}

/// The JSON of `inspect` for a model.
pub(crate) fn inspect_model(dir: &TestDir, model: &str) -> Value {
    serde_json::from_str(&dir.run(&format!("inspect {model} --format json")).succeeded().out()).unwrap()
}

/// The centre and radius of each sphere of an inspected model by its name, m.
pub(crate) fn spheres_by_name(inspection: &Value) -> BTreeMap<String, ([f64; 3], f64)> {
    let place_and_radius = |sphere: &Value| {
        let at: Vec<f64> =
            sphere["location_m"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        let place = [at[0], at[1], at[2]];
        (sphere["name"].as_str().unwrap().to_owned(), (place, sphere["radius_m"].as_f64().unwrap()))
    };
    inspection["spheres"].as_array().unwrap().iter().map(place_and_radius).collect()
}

/// A parameter of the force called `name`; NaN if the class of the force does not have the parameter.
fn parameter_of_force(inspection: &Value, name: &str, property: &str) -> f64 {
    let mut forces = inspection["forces"].as_array().unwrap().iter();
    let force = forces.find(|force| force["name"] == name).unwrap_or_else(|| panic!("{name}: {inspection}"));
    force["parameters"][property].as_f64().unwrap_or(f64::NAN)
}

#[track_caller]
fn assert_close(value: f64, expected: f64) {
    assert!((value / expected - 1.0).abs() <= PRODUCT_TOLERANCE, "{value}, not {expected}");
}

/// Asserts that the spheres have the places that the table's generator wrote.
#[track_caller]
fn assert_spheres_at_table_places(inspection: &Value, tolerance: f64) {
    let spheres = spheres_by_name(inspection);
    let names: Vec<&str> = spheres.keys().map(String::as_str).collect();
    assert_eq!(names, PLACES_IN_TABLE.map(|(name, _)| name));
    for (name, expected) in PLACES_IN_TABLE {
        let (place, _) = spheres[name];
        let distance = place.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(distance <= tolerance, "{name}: {place:?}");
    }
}

/// Asserts that the call prints one line of error, ends with the exit status for wrong usage or failure, and writes nothing.
#[track_caller]
pub(crate) fn assert_refused(dir: &TestDir, call: &str, usage: bool, words: &[&str]) {
    let run = dir.run(call).wrote_nothing().says(words);
    assert_eq!(run.err().lines().filter(|line| line.starts_with("error: ")).count(), 1, "{}", run.err());
    let _ = if usage { run.usage_error() } else { run.failed() };
}

#[test]
fn places_and_radii_of_a_table_are_used_unchanged() {
    let dir = human_with_meshes();
    dir.run("add human.osim --contacts own.csv --from falisse2022 -o out.osim")
        .succeeded()
        .wrote(&["out.osim"]);
    let inspection = inspect_model(&dir, "out.osim");
    assert_spheres_at_table_places(&inspection, 0.0);
    assert_eq!(spheres_by_name(&inspection)["ball_l"].1, 0.025);
    // (10) from 62 kg on 6 spheres of 0.032 m with 1e6 N/m2, to 62 kg on 2 spheres a limb; (14), (C.2), (C.5).
    for (name, radius) in [("force_heel_r", 0.03), ("force_ball_l", 0.025)] {
        let ratio: f64 = radius / 0.032;
        assert_close(parameter_of_force(&inspection, name, "stiffness"), 1e6 * (6.0 / 2.0) / (ratio * ratio));
        assert_close(parameter_of_force(&inspection, name, "dissipation"), 2.0 / ratio.sqrt());
        assert_close(parameter_of_force(&inspection, name, "constant_contact_force"), 1e-5 * ratio * ratio);
        assert_close(parameter_of_force(&inspection, name, "hertz_smoothing"), 300.0 / ratio);
        // Falisse's frictions.
        assert_eq!(parameter_of_force(&inspection, name, "static_friction"), 0.8);
        assert_eq!(parameter_of_force(&inspection, name, "viscous_friction"), 0.5);
    }
    // After `remove` the file is as before.
    dir.run("remove out.osim -o back.osim").succeeded();
    assert_eq!(dir.read("back.osim"), dir.read("human.osim"));
}

#[test]
fn a_table_with_german_numbers_gives_the_same_model() {
    let dir = human_with_meshes();
    dir.write("german.csv", crate::support::fixture("contact_tables/own_german.csv"));
    for table in ["own", "german"] {
        dir.run(&format!("add human.osim --contacts {table}.csv --from falisse2022 -o {table}.osim"))
            .succeeded();
    }
    // The notes name the tables.
    assert_eq!(dir.text("own.osim").replace("own.csv", "german.csv"), dir.text("german.osim"));
}

#[test]
fn a_muskemo_export_is_read_in_both_modes() {
    let dir = human_with_meshes();
    for name in ["muskemo_local.csv", "muskemo_global.csv", "global_mode.osim", "bad/places_differ.csv"] {
        dir.write(name, crate::support::fixture(&format!("contact_tables/{name}")));
    }
    // Bodies with frames of their own: the local columns, which agree with where ground has them.
    dir.run("add human.osim --contacts muskemo_local.csv --from falisse2022 -o local.osim").succeeded();
    assert_spheres_at_table_places(&inspect_model(&dir, "local.osim"), 0.0);
    // Radii follow the mass of the body, here 8 times that of the reference, and a remark gives them.
    dir.run("add human.osim --contacts muskemo_local.csv --from falisse2022 --mass 496 --dry-run")
        .succeeded()
        // 0.032 m times the cube root of 496/62.
        .says(&["radii are the reference's, times the cube root of the masses' ratio (8): 0.064 m"]);
    // With equal masses the radii are those of the reference.
    assert!(spheres_by_name(&inspect_model(&dir, "local.osim")).values().all(|(_, radius)| *radius == 0.032));

    // Bodies in ground: the global ones.
    dir.run("add global_mode.osim --contacts muskemo_global.csv --from falisse2022 -o global.osim")
        .succeeded();
    let (heel, _) = spheres_by_name(&inspect_model(&dir, "global.osim"))["heel_r"];
    assert_eq!(heel, [-0.090_545_266_246_5, 0.02, 0.088_430_200_966_5]);

    // Places in ground alone need `--default-pose` if the bodies have other frames, and a remark says so.
    let alone = "add human.osim --contacts muskemo_global.csv --from falisse2022";
    assert_refused(
        &dir,
        alone,
        false,
        &["muskemo_global.csv, line 2: heel_r has a place in ground only", "--default-pose"],
    );
    dir.run(&format!("{alone} --default-pose -o posed.osim"))
        .succeeded()
        .says(&["at the default pose: heel_r, ball_r, heel_l, ball_l"]);
    assert_spheres_at_table_places(&inspect_model(&dir, "posed.osim"), TABLE_TOLERANCE);

    let differ = "add human.osim --contacts bad/places_differ.csv --from falisse2022";
    assert_refused(
        &dir,
        differ,
        false,
        &["line 2: heel_r has two places, and in this model they are 2.5 mm apart"],
    );
    let other = "add global_mode.osim --contacts muskemo_local.csv --from falisse2022";
    assert_refused(&dir, other, false, &["line 2: heel_r has two places"]);
}

#[test]
fn a_wrong_table_is_refused_with_its_line() {
    let dir = human_with_meshes();
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
        dir.write("table.csv", crate::support::fixture(&format!("contact_tables/bad/{table}.csv")));
        let call = "add human.osim --contacts table.csv --from falisse2022";
        assert_refused(&dir, call, false, &["table.csv", words]);
    }
    assert_refused(
        &dir,
        "add human.osim --contacts nowhere.csv --from falisse2022",
        false,
        &["nowhere.csv: there is no such file"],
    );
    // Millimetres in the cells.
    dir.write("mm.csv", "name,body,x,y,z,radius\nheel_r,calcn_r,0.02,0.01,0,30\n");
    let call = "add human.osim --contacts mm.csv --from falisse2022";
    assert_refused(&dir, call, false, &["the radius of heel_r would be 30 m", "--yes implausible-radius"]);
}

#[test]
fn parameters_can_follow_from_indentation_and_restitution() {
    let dir = human_with_meshes();
    let call = "add human.osim --contacts own.csv --class hunt-crossley --indentation 0.1 --restitution 0.5 --impact-speed 0.5 \
                --static-friction 0.7 -o out.osim";
    dir.run(call).succeeded().says(&[
        "so OpenSim's defaults are written: dynamic_friction 0, viscous_friction 0, transition_velocity 0.01",
    ]);
    let inspection = inspect_model(&dir, "out.osim");
    // (11): E* = 3 F / (4 R^2 x^1.5), (A.4): two equal surfaces have 2^1.5 E*; 62 kg on two spheres a limb, at 9.81 m/s2.
    let force = 62.0 * 9.81 / 2.0;
    for (name, radius) in [("force_heel_r", 0.03), ("force_ball_r", 0.025)] {
        let composite = 3.0 * force / (4.0 * radius * radius * 0.1_f64.powf(1.5));
        assert_close(parameter_of_force(&inspection, name, "stiffness"), 2_f64.powf(1.5) * composite);
        // (13): (1 - 0.5) / 0.5 m/s.
        assert_close(parameter_of_force(&inspection, name, "dissipation"), 1.0);
        assert_eq!(parameter_of_force(&inspection, name, "static_friction"), 0.7);
        assert!(parameter_of_force(&inspection, name, "hertz_smoothing").is_nan());
    }
    dir.run("remove out.osim -o back.osim").succeeded();
    assert_eq!(dir.read("back.osim"), dir.read("human.osim"));
}

#[test]
fn contacts_are_converted_to_the_requested_class() {
    let dir = human_with_meshes();
    dir.write("reference.osim", crate::support::fixture("table1/human_62kg_hunt_crossley.osim"));
    dir.run("add human.osim --contacts own.csv --from reference.osim --class smooth -o smooth.osim")
        .succeeded();
    let inspection = inspect_model(&dir, "smooth.osim");
    assert_eq!(inspection["forces"][0]["type"], "SmoothSphereHalfSpaceForce");
    // The smoothing of Falisse et al. at 0.032 m: 1e-5 m2, 300/m, 50 s/m; (C.2), (C.5), (C.10).
    let ratio: f64 = 0.025 / 0.032;
    assert_close(
        parameter_of_force(&inspection, "force_ball_r", "constant_contact_force"),
        1e-5 * ratio * ratio,
    );
    assert_close(parameter_of_force(&inspection, "force_ball_r", "hertz_smoothing"), 300.0 / ratio);
    assert_close(
        parameter_of_force(&inspection, "force_ball_r", "hunt_crossley_smoothing"),
        50.0 / ratio.sqrt(),
    );
    assert_close(
        parameter_of_force(&inspection, "force_ball_r", "stiffness"),
        1e6 * (6.0 / 2.0) / (ratio * ratio),
    );

    dir.write("reference.osim", crate::support::fixture("table1/human_62kg_smooth_sphere.osim"));
    for call in ["", "--contacts own.csv"] {
        dir.run(&format!(
            "add human.osim {call} --from reference.osim --class hunt-crossley -o hard.osim --force"
        ))
        .succeeded();
        let inspection = inspect_model(&dir, "hard.osim");
        let force = &inspection["forces"][0];
        assert_eq!(force["type"], "HuntCrossleyForce");
        assert!(!dir.text("hard.osim").contains("hertz_smoothing"));
    }
}

#[test]
fn add_asks_which_contact_of_a_mixed_reference_to_use() {
    let dir = human_with_meshes();
    let text = String::from_utf8(crate::support::fixture("table1/human_62kg_smooth_sphere.osim")).unwrap();
    // The first of its spheres is smaller.
    let radius = "<radius>0.032000000000000001</radius>";
    dir.write("reference.osim", text.replacen(radius, "<radius>0.02</radius>", 1));
    dir.write("bare.csv", "name,body,x,y,z\nheel_r,calcn_r,0,0,0\nheel_l,calcn_l,0,0,0\n");
    let table = "add human.osim --contacts bare.csv --from reference.osim";
    assert_refused(
        &dir,
        table,
        false,
        &["the spheres of reference.osim have different radii", "--radius METRES", "--reference-sphere NAME"],
    );
    assert_refused(
        &dir,
        &format!("{table} --radius 0.03"),
        false,
        &["the contacts of reference.osim differ from each other", "heel_r, heel_l"],
    );
    assert_refused(
        &dir,
        &format!("{table} --reference-sphere nobody"),
        false,
        &["--reference-sphere nobody is not in reference.osim"],
    );
    let feet = "add human.osim --feet calcn_r,calcn_l --count 1 --pad 0.01 --from reference.osim";
    for call in [table, feet] {
        dir.run(&format!("{call} --reference-sphere s2_r --static-friction 0.4 -o out.osim --force"))
            .succeeded();
        let inspection = inspect_model(&dir, "out.osim");
        assert!(
            spheres_by_name(&inspection)
                .values()
                .all(|(_, radius)| (radius / 0.032 - 1.0).abs() < PRODUCT_TOLERANCE),
            "{inspection}"
        );
        let force = inspection["forces"][0]["name"].as_str().unwrap();
        // A given value has priority over the reference's 0.8.
        assert_eq!(parameter_of_force(&inspection, force, "static_friction"), 0.4);
    }
    // Spheres with the names of the reference get its radii: (8) with equal masses.
    dir.write("named.csv", "name,body,x,y,z\ns1_r,calcn_r,0,0,0\ns2_r,calcn_r,0.1,0,0\n");
    dir.run("add human.osim --contacts named.csv --from reference.osim -o named.osim").succeeded();
    let placed = spheres_by_name(&inspect_model(&dir, "named.osim"));
    assert_eq!((placed["s1_r"].1, placed["s2_r"].1), (0.02, 0.032));
}

#[test]
fn add_names_missing_options() {
    let dir = human_with_meshes();
    let table = "add human.osim --contacts own.csv";
    assert_refused(
        &dir,
        "add human.osim",
        true,
        &["--from MODEL|PRESET", "--contacts TABLE", "--feet BODY,BODY"],
    );
    assert_refused(&dir, table, true, &["--from MODEL|PRESET", "--indentation X"]);
    assert_refused(&dir, &format!("{table} --restitution 0.5"), true, &["--indentation X"]);
    assert_refused(
        &dir,
        &format!("{table} --indentation 0.1"),
        true,
        &["--class smooth|hunt-crossley is missing"],
    );
    assert_refused(&dir, &format!("{table} --from falisse2022 --indentation 0.1"), true, &["--indentation"]);
    assert_refused(&dir, &format!("{table} --from falisse2022 --radius 0.03"), true, &["leave one out"]);
    assert_refused(&dir, &format!("{table} --feet calcn_r --count 2 --pad 0"), true, &["--feet"]);
    assert_refused(&dir, "add human.osim --from falisse2022 --count 2", true, &["--count needs --feet"]);
    // Bones without skin touch the ground, so a pad may be 0, but not negative.
    let feet = "add human.osim --feet calcn_r --count 2 --from falisse2022 --pad";
    assert_refused(&dir, &format!("{feet} -0.1"), true, &["--pad '-0.1': expected metres, 0 or more"]);
    assert_refused(&dir, &format!("{feet} 5mm"), true, &["type 0.005"]);
    dir.run(&format!("{feet} 0 --dry-run")).succeeded();
    dir.write("bare.csv", "name,body,x,y,z\nheel_r,calcn_r,0,0,0\n");
    let bare = "add human.osim --contacts bare.csv --class smooth --indentation 0.1";
    assert_refused(&dir, bare, true, &["--radius METRES is missing"]);
}

#[test]
fn a_model_without_mass_is_refused() {
    let dir = human_with_meshes();
    let text = dir.text("human.osim");
    let weightless: String = text
        .split_inclusive('\n')
        .map(|line| match line.contains("<mass>") {
            true => "<mass>0</mass>\n".to_owned(),
            false => line.to_owned(),
        })
        .collect();
    dir.write("zero.osim", weightless);
    dir.write("reference.osim", crate::support::fixture("table1/human_62kg_smooth_sphere.osim"));
    for call in [
        "--from reference.osim",
        "--contacts own.csv --from falisse2022",
        "--contacts own.csv --class smooth --indentation 0.1",
        "--feet calcn_r --count 2 --pad 0.01 --from falisse2022",
    ] {
        assert_refused(
            &dir,
            &format!("add zero.osim {call}"),
            false,
            &["the 9 bodies weigh 0 kg in all: give the mass of the model with --mass KG\n"],
        );
        dir.run(&format!("add zero.osim {call} --mass 62 -o out.osim --force")).succeeded();
    }
}

#[test]
fn a_reference_of_one_side_is_mirrored() {
    let dir = human_with_meshes();
    dir.write("both.osim", crate::support::fixture("table1/human_62kg_smooth_sphere.osim"));
    dir.run("remove both.osim --select *_l* -o right.osim").succeeded();
    dir.run("add human.osim --from both.osim -o of_both.osim").succeeded();
    dir.run("add human.osim --from right.osim --mirror z -o of_right.osim").succeeded();
    let (both, right) = (inspect_model(&dir, "of_both.osim"), inspect_model(&dir, "of_right.osim"));
    // Its spheres are mirror images of each other, called by other numbers.
    let places = |inspection: &Value| {
        let mut all: Vec<String> =
            spheres_by_name(inspection).values().map(|sphere| format!("{sphere:?}")).collect();
        all.sort();
        all
    };
    assert_eq!(places(&both), places(&right));
    assert_eq!(spheres_by_name(&right).len(), 12);

    assert_refused(
        &dir,
        "add human.osim --from both.osim --mirror z",
        false,
        &["has contacts on both sides"],
    );
    assert_refused(
        &dir,
        "add human.osim --contacts own.csv --from right.osim --mirror z",
        true,
        &["--mirror"],
    );
    let text = dir.text("human.osim").replace("calcn_l", "stump");
    dir.write("stump.osim", text);
    assert_refused(
        &dir,
        "add stump.osim --from right.osim --mirror z",
        false,
        &["the model lacks body calcn_l"],
    );
}
