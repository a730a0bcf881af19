//! Contacts that are not spheres on a floor: ellipsoids, shapes that press nothing, and forces of other classes.

use crate::cases::{check_json, codes_of_severity, dir_of_case, finding_with_code};
use crate::support::TestDir;

const TABLE_OF_PLACES: &str = "name,body,x,y,z,radius\nheel_r,calcn_r,0,0,0,0.03\n";

fn dir_of_shapes(models: &[&str]) -> TestDir {
    let files: Vec<_> = models.iter().map(|name| (format!("shapes/{name}"), *name)).collect();
    TestDir::with(&files.iter().map(|(from, to)| (from.as_str(), *to)).collect::<Vec<_>>())
}

#[test]
fn an_ellipsoid_is_scaled_as_the_spheres_beside_it() {
    let Some(dir) = dir_of_case("ellipsoid-ignored") else { return };
    let report = check_json(&dir, "model.osim");
    assert_eq!(finding_with_code(&report, "ellipsoid")["spheres"][0], "s1_r");
    assert!(!report.to_string().contains("left-right-missing"), "{report}");
    dir.run("model.osim --target-mass 30 -o out.osim").succeeded();
    let text = dir.text("out.osim");
    let radii = text.split("<radii>").nth(1).unwrap().split("</radii>").next().unwrap();
    let radii: Vec<f64> = radii.split(' ').map(|radius| radius.parse().unwrap()).collect();
    let factor = radii[0] / 0.04;
    assert!(factor < 0.9 && (radii[1] / 0.032 / factor - 1.0).abs() < 1e-14, "{radii:?}");
    let radius: f64 = text.split("<radius>").nth(1).unwrap().split('<').next().unwrap().parse().unwrap();
    assert!((radius / 0.032 / factor - 1.0).abs() < 1e-14, "{radius}, {factor}");
    assert!(!text.contains("<stiffness>1000000</stiffness>"));
}

#[test]
fn all_radii_of_an_ellipsoid_are_multiplied_by_one_factor() {
    let dir = dir_of_shapes(&["ellipsoid.osim"]);
    dir.run("ellipsoid.osim --target-mass 492 --yes implausible-mass -o out.osim").succeeded();
    let text = dir.text("out.osim");
    assert!(
        text.contains("<radii>0.08 0.065 0.06</radii>") && text.contains("<stiffness>2469135.6</stiffness>")
    );
    dir.run("set ellipsoid.osim radius=x2 -o double.osim").succeeded();
    assert!(dir.text("double.osim").contains("<radii>0.08 0.065 0.06</radii>"));
}

#[test]
fn what_needs_a_sphere_names_the_ellipsoid() {
    let dir = dir_of_shapes(&["ellipsoid.osim"]);
    for call in [
        "set ellipsoid.osim radius=0.03 -o out.osim",
        "ellipsoid.osim --target-mass 80 --level -o out.osim",
        "drop-test ellipsoid.osim",
        "design ellipsoid.osim --indentation 0.1 --mass 80 -o out.osim",
    ] {
        dir.run(call).failed().wrote_nothing().says(&["this needs a sphere; heel_r is an ellipsoid"]);
    }
    dir.run("convert ellipsoid.osim --to smooth -o out.osim")
        .failed()
        .wrote_nothing()
        .says(&["heel_r is an ellipsoid, and a SmoothSphereHalfSpaceForce needs a sphere"]);
    let run = dir.run("inspect ellipsoid.osim").succeeded();
    run.says_not(&["NaN"]).says(&["Standing:\n  the height of its spheres over a floor is not known"]);
}

#[test]
fn shapes_that_press_nothing_cause_a_warning() {
    let dir = dir_of_shapes(&["torus_and_cylinder.osim"]);
    let report = check_json(&dir, "torus_and_cylinder.osim");
    let found = finding_with_code(&report, "shape-presses-nothing");
    assert_eq!(found["severity"], "warning");
    assert!(found["message"].as_str().unwrap().contains("names ring, a ContactTorus"), "{found}");
}

#[test]
fn contacts_of_another_class_are_named_and_not_doubled() {
    let dir = dir_of_shapes(&["elastic_foundation.osim"]);
    dir.write("table.csv", TABLE_OF_PLACES);
    let report = check_json(&dir, "elastic_foundation.osim");
    let found = finding_with_code(&report, "not-hertz")["message"].as_str().unwrap();
    let stands = "the body stands on ElasticFoundationForce, which this program does not scale: ";
    assert_eq!(found, format!("{stands}mesh"));
    assert!(!codes_of_severity(&report, "remark").contains("bare-model"));
    // As in OpenSim's tugOfWar_model.osim.
    let unnamed = dir.text("elastic_foundation.osim").replace("Force name=\"mesh\">", "Force>");
    dir.write("unnamed.osim", unnamed);
    let report = check_json(&dir, "unnamed.osim");
    let found = finding_with_code(&report, "not-hertz")["message"].as_str().unwrap();
    assert_eq!(found, format!("{stands}elasticfoundationforce"));
    let add = "add elastic_foundation.osim --contacts table.csv --from falisse2022 --yes implausible-mass -o out.osim";
    dir.run(add).failed().wrote_nothing().says(&["the model has contacts already: mesh", "--replace"]);
    dir.run(&format!("{add} --replace")).succeeded();
    let text = dir.text("out.osim");
    assert!(
        !text.contains("ElasticFoundation") && !text.contains("ContactMesh") && text.contains("\"floor\"")
    );
    dir.run("elastic_foundation.osim --target-mass 80 -o scaled.osim")
        .failed()
        .says(&["which this program does not scale: mesh: replace them with", "--replace"]);
}

#[test]
fn elastic_foundations_under_feet_are_replaced() {
    let Some(dir) = dir_of_case("elastic-foundation-doubled") else { return };
    dir.write("generic.osim", crate::support::fixture("scale_tool/generic_smooth.osim"));
    let report = check_json(&dir, "model.osim");
    let found = finding_with_code(&report, "not-hertz")["message"].as_str().unwrap();
    assert!(found.ends_with("which this program does not scale: sole_r, sole_l"), "{found}");
    assert!(!report.to_string().contains("bare-model"), "{report}");
    let add = "add model.osim --from generic.osim -o out.osim";
    dir.run(add).failed().wrote_nothing().says(&["sole_r, sole_l"]);
    dir.run(&format!("{add} --replace")).succeeded();
    assert!(
        !dir.text("out.osim").contains("ElasticFoundation") && !dir.text("out.osim").contains("sole_mesh")
    );
}
