//! Each kind of damage to the places of spheres in published models gives a finding.

use std::collections::BTreeSet;

use osim_inspect::{find_misplaced_spheres, model_findings};
use osim_model::{Finding, FindingCode, Model, Side};

use crate::{corpus_folder, moco_3d_walking};

/// Published models with spheres on bodies of both sides, with their names; empty if the corpus is absent.
fn published_models() -> Vec<(String, String)> {
    let Some(folder) = corpus_folder("damaged places") else { return Vec::new() };
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut found: Vec<(String, String)> = paths
        .filter_map(|path| {
            let text = std::fs::read_to_string(&path).ok()?;
            let model = Model::parse(text.as_str()).ok()?;
            let has = |side| {
                let spheres = model.loaded_spheres(&model.force_ids());
                let mut bodies = spheres.iter().filter_map(|&id| model.sphere(id)?.body.as_deref());
                bodies.any(|body| Side::of_name(body) == Some(side))
            };
            (has(Side::Right) && has(Side::Left))
                .then(|| (path.file_stem().unwrap().to_string_lossy().into_owned(), text))
        })
        .collect();
    found.sort();
    assert!(found.len() >= 12, "{} models with spheres on both sides", found.len());
    found
}

/// The model `text` with the place of each sphere changed. `change` gets the name and the place of the sphere.
fn with_moved_spheres(text: &str, change: impl Fn(&str, [f64; 3]) -> [f64; 3]) -> String {
    let mut new = String::new();
    for (number, part) in text.split("<ContactSphere ").enumerate() {
        if number > 0 {
            new.push_str("<ContactSphere ");
        }
        let end = part.find("</ContactSphere>").unwrap_or(0);
        let Some(start) = part[..end].find("<location>").map(|at| at + "<location>".len()) else {
            new.push_str(part);
            continue;
        };
        let stop = start + part[start..].find('<').unwrap();
        let place: Vec<f64> =
            part[start..stop].split_whitespace().map(|value| value.parse().unwrap()).collect();
        let name = part.split('"').nth(1).unwrap_or_default();
        let [x, y, z] = change(name, place.try_into().unwrap());
        new.push_str(&format!("{}{x} {y} {z}{}", &part[..start], &part[stop..]));
    }
    new
}

/// The model `text` with all lengths of its skeleton times 0.6. Spheres and meshes stay.
fn with_shorter_bones(text: &str) -> String {
    let shorter = |text: String, tag: &str| {
        let open = format!("<{tag}>");
        let mut parts = text.split(&open);
        let mut new = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let (place, rest) = part.split_once('<').unwrap();
            let place = place.split_whitespace().map(|value| 0.6 * value.parse::<f64>().unwrap());
            let place: Vec<String> = place.map(|value| value.to_string()).collect();
            new.push_str(&format!("{open}{}<{rest}", place.join(" ")));
        }
        new
    };
    let mut new = String::new();
    for (number, part) in text.split("<ContactSphere ").enumerate() {
        let end = if number == 0 { 0 } else { part.find("</ContactSphere>").unwrap_or(0) };
        new.push_str(if number == 0 { "" } else { "<ContactSphere " });
        new.push_str(&part[..end]);
        let tags = ["translation", "location_in_parent", "location"];
        new.push_str(&tags.into_iter().fold(part[end..].to_owned(), shorter));
    }
    new
}

fn finding_codes(text: &str) -> BTreeSet<FindingCode> {
    model_findings(&Model::parse(text).unwrap()).iter().map(Finding::code).collect()
}

/// Asserts that each published model has the finding `code` after a change of all places, except the models `spared`.
#[track_caller]
fn assert_found_in_models(code: FindingCode, spared: &[&str], change: impl Fn(&str, [f64; 3]) -> [f64; 3]) {
    let models = published_models();
    let not_named =
        models.iter().filter(|(_, text)| !finding_codes(&with_moved_spheres(text, &change)).contains(&code));
    let not_named: Vec<&str> = not_named.map(|(name, _)| name.as_str()).collect();
    let expected: Vec<&str> = if models.is_empty() { Vec::new() } else { spared.to_vec() };
    assert_eq!(not_named, expected, "of {} models", models.len());
}

#[test]
fn places_that_are_as_published_are_not_named() {
    let judged = [FindingCode::OddPlace, FindingCode::CrowdedSpheres, FindingCode::LeftRightSwapped];
    for (name, text) in published_models() {
        assert!(finding_codes(&text).is_disjoint(&judged.into()), "{name}");
        assert_eq!(
            finding_codes(&with_moved_spheres(&text, |_, place| place)),
            finding_codes(&text),
            "{name}"
        );
    }
}

#[test]
fn places_in_millimetres_and_centimetres_are_named() {
    assert_found_in_models(FindingCode::OddPlace, &[], |_, place| place.map(|value| 1000.0 * value));
    assert_found_in_models(FindingCode::OddPlace, &[], |_, place| place.map(|value| 100.0 * value));
}

#[test]
fn places_in_thousandths_are_named_where_a_body_has_several() {
    // One has a sphere at the end of each body.
    let alone = ["v30000_osim_rl_gait9dof18musc_crlf"];
    assert_found_in_models(FindingCode::CrowdedSpheres, &alone, |_, place| place.map(|value| 0.001 * value));
    assert_found_in_models(FindingCode::CrowdedSpheres, &alone, |_, place| place.map(|value| 0.01 * value));
}

#[test]
fn places_a_fifth_of_a_metre_aside_are_named() {
    // A robot whose spheres are at the ends of its shanks, 1 m long, with a radius of gyration of 0.11 m.
    let robot = ["v40000_walker_terrain_46_spheres_crlf"];
    let out = |name: &str| if Side::of_name(name) == Some(Side::Left) { -0.2 } else { 0.2 };
    assert_found_in_models(FindingCode::OddPlace, &robot, |name, [x, y, z]| [x, y, z + out(name)]);
    assert_found_in_models(FindingCode::OddPlace, &robot, |name, [x, y, z]| [x, y, z - out(name)]);
}

/// Without meshes, or where these stay, joints show the size of bones.
#[test]
fn shorter_bones_under_published_spheres_are_named() {
    // The right foot of a kicker has spheres on its toes alone, and the robot's are at places that nobody published.
    let spared = ["v40000_soccer_kick_sphere_pairs", "v40000_walker_terrain_46_spheres_crlf"];
    let dhondt = include_str!("../../../osim-patch/src/objects/presets/dhondt2024.osim");
    let dhondt = ("dhondt2024".to_owned(), dhondt.to_owned());
    for (name, text) in published_models().into_iter().chain([dhondt]) {
        let found = |text: &str| find_misplaced_spheres(&Model::parse(text).unwrap());
        assert_eq!(found(&text), None, "{name}");
        let message = found(&with_shorter_bones(&text)).map(|one| one.message.to_string());
        let is_named = message.as_ref().is_some_and(|message| message.contains("is 60 % of the bone in"));
        assert_eq!(is_named, !spared.contains(&name.as_str()), "{name}: {message:?}");
    }
}

#[test]
fn a_published_toe_joint_that_does_not_follow_its_meshes_is_of_no_other_size() {
    let Some(folder) = corpus_folder("Moco's toe joint") else { return };
    // Its meshes are 1.156 times as long as OpenSim's foot, its toe joint is where OpenSim's is.
    assert_eq!(find_misplaced_spheres(&moco_3d_walking(&folder)), None);
}
