//! `add --feet`: spheres under the meshes of bones, and feet for which that is impossible.

use serde_json::Value;

use crate::add_table::{HUMAN, assert_refused, human_with_meshes, inspect_model, spheres_by_name};
use crate::support::TestDir;

#[test]
fn spheres_are_placed_under_the_bones() {
    let dir = human_with_meshes();
    let call = "add human.osim --feet calcn_r,toes_r,calcn_l,toes_l --count 4 --pad 0.01";
    dir.run(&format!("{call} --from falisse2022 -o out.osim")).succeeded();
    let inspection = inspect_model(&dir, "out.osim");
    let placed = spheres_by_name(&inspection);
    let names: Vec<&str> = placed.keys().map(String::as_str).collect();
    assert_eq!(names.len(), 8);
    for (name, (place, radius)) in &placed {
        // As large against the body as the reference's: both weigh 62 kg.
        assert_eq!(*radius, 0.032, "{name}");
        if let Some(right) = name.strip_suffix("_l") {
            let (other, _) = placed[&format!("{right}_r")];
            let difference = [place[0] - other[0], place[1] - other[1], place[2] + other[2]];
            assert!(
                difference.iter().all(|difference| difference.abs() < 1e-12),
                "{name}: {place:?}, {other:?}"
            );
        }
    }
    // The bodies hang without a turn about x or z: all bottoms of one foot are in a plane of its frame.
    let heights = placed.iter().filter(|(name, _)| name.ends_with("_r"));
    let heights: Vec<f64> = heights
        .map(|(name, (place, radius))| {
            place[1] - radius + if name.starts_with("toes") { -0.002 } else { 0.0 }
        })
        .collect();
    assert!(heights.iter().all(|height| (height - heights[0]).abs() < 1e-12), "{names:?}: {heights:?}");
    dir.run("remove out.osim -o back.osim").succeeded();
    assert_eq!(dir.read("back.osim"), dir.read("human.osim"));

    // A given radius is used for all spheres.
    dir.run(&format!("{call} --indentation 0.1 --class smooth --radius 0.02 -o made.osim")).succeeded();
    assert!(spheres_by_name(&inspect_model(&dir, "made.osim")).values().all(|(_, radius)| *radius == 0.02));
}

#[test]
fn feet_without_usable_meshes_or_options_are_refused() {
    let dir = human_with_meshes();
    let feet = "add human.osim --from falisse2022 --feet";
    let usage = [
        ("calcn_r --count 4", "--pad METRES is missing: bones have no skin"),
        ("calcn_r --count 4", "0.033 under a human heel"),
        ("calcn_r --pad 0.01", "--count N is missing"),
        ("calcn_r", "under each foot? --pad METRES is missing: bones have no skin"),
        ("calcn_r --pad -0.01 --count 4", "--pad '-0.01': expected"),
        ("calcn_r --count 0 --pad 0.01", "expected a whole number from 1 to 60"),
        ("calcn_r --count 4 --pad 0.01 --radius follow", "--radius follow has no effect here"),
    ];
    for (call, words) in usage {
        assert_refused(&dir, &format!("{feet} {call}"), true, &[words]);
    }
    for (call, words) in [
        ("calcn_r,foot_r --count 4 --pad 0.01", "there is no body foot_r, the model has pelvis"),
        ("pelvis --count 4 --pad 0.01", "no mesh is attached to body pelvis"),
        ("pelvis --count 4 --pad 0.01", "--contacts TABLE"),
    ] {
        assert_refused(&dir, &format!("{feet} {call}"), false, &[words]);
    }
    let mesh = crate::support::fixture("feet/Geometry/r_human_foot.vtp");
    for (name, bytes) in [("cut off", &mesh[..mesh.len() / 2]), ("empty", b"")] {
        dir.write("Geometry/r_human_foot.vtp", bytes);
        let run = dir.run(&format!("{feet} calcn_r --count 4 --pad 0.01 --format json")).failed();
        let error: Value = serde_json::from_str(&run.out()).unwrap();
        assert_eq!(error["error"]["code"], "bad-mesh", "{name}: {error}");
    }
    // Three points, and four in a line.
    for points in ["v 0 0 0\nv 1 0 0\nv 0 1 0\n", "v 0 0 0\nv 1 1 1\nv 2 2 2\nv 3 3 3\n"] {
        let text = dir.text("human.osim").replace("r_human_foot.vtp", "bone.obj");
        dir.write("bone.osim", text);
        dir.write("Geometry/bone.obj", points);
        let call = "add bone.osim --from falisse2022 --feet calcn_r --count 2 --pad 0.01";
        let words =
            ["mesh bone.obj of body calcn_r", "expected", "give the places in a table: --contacts TABLE"];
        assert_refused(&dir, call, false, &words);
    }

    let other =
        TestDir::with(&[(HUMAN, "human.osim"), ("feet/Geometry/r_human_foot.vtp", "bones/r_human_foot.vtp")]);
    let call = format!("{feet} calcn_r --count 4 --pad 0.01");
    assert_refused(
        &other,
        &call,
        false,
        &["shows mesh r_human_foot.vtp, which is in none of the folders", "--geometry-dir DIR"],
    );
    other.run(&format!("{call} --geometry-dir bones -o out.osim")).succeeded();
}

/// This holds also in the cell of a manifest, where semicolons separate the values of other lists.
#[test]
fn lists_of_bodies_may_have_spaces_paths_or_semicolons() {
    let dir = human_with_meshes();
    let add = |feet: &str, to: &str| {
        let (call, feet_option) =
            ("add human.osim --count 2 --pad 0.01 --from falisse2022 -o", ["--feet", feet]);
        let words: Vec<&str> = call.split(' ').chain([to]).chain(feet_option).collect();
        let run = dir.run_words(&words);
        (run.status.code(), String::from_utf8(run.stderr).unwrap())
    };
    assert_eq!(add("calcn_r,calcn_l", "one.osim").0, Some(0));
    for (number, feet) in [
        "calcn_r, calcn_l",
        "calcn_r,calcn_l,calcn_r",
        "/bodyset/calcn_r,/bodyset/calcn_l",
        "calcn_r;calcn_l",
    ]
    .iter()
    .enumerate()
    {
        let name = format!("as{number}.osim");
        assert_eq!(add(feet, &name).0, Some(0), "{feet}");
        assert_eq!(
            without_feet_in_note(&dir.text(&name)),
            without_feet_in_note(&dir.text("one.osim")),
            "{feet}"
        );
    }
    for feet in ["calcn_r,", "", ",calcn_r"] {
        let (status, error) = add(feet, "none.osim");
        assert_eq!(status, Some(2), "{feet}: {error}");
        assert!(
            error.contains("--feet: a name is missing") && error.contains("--feet calcn_r,calcn_l"),
            "{error}"
        );
    }
    let (status, error) = add("Calcn_r,calcn_l", "none.osim");
    assert_eq!(status, Some(1));
    assert!(
        error.contains("there is no body Calcn_r") && error.contains(": did you mean calcn_r?"),
        "{error}"
    );
    dir.write(
        "m.csv",
        "model,verb,feet,count,pad,from,output\nhuman.osim,add,\"calcn_r,calcn_l\",2,0.01,falisse2022,a.osim\n\
         human.osim,add,calcn_r;calcn_l,2,0.01,falisse2022,b.osim\n",
    );
    dir.run("batch m.csv").succeeded();
    for name in ["a.osim", "b.osim"] {
        assert_eq!(dir.read(name), dir.read("one.osim"), "{name}");
    }
    dir.write("t.csv", "name,body,x,y,z,radius\nheel_r,/bodyset/calcn_r,0,0,0,0.03\n");
    dir.run("add human.osim --contacts t.csv --from falisse2022 --spheres 1 -o t.osim").succeeded();
    dir.write("t.csv", "name,body,x,y,z,radius\nheel_r,calcn_R,0,0,0,0.03\n");
    let call = "add human.osim --contacts t.csv --from falisse2022 --spheres 1";
    assert_refused(&dir, call, false, &["there is no body calcn_R", ": did you mean calcn_r?"]);
}

#[test]
fn a_missing_folder_of_meshes_is_named() {
    let dir = human_with_meshes();
    let call =
        "add human.osim --feet calcn_r --count 2 --pad 0.01 --from falisse2022 --dry-run --geometry-dir";
    dir.run(&format!("{call} nowhere"))
        .succeeded()
        .says(&["--geometry-dir nowhere: there is no such folder"]);
    let quiet = dir.run(&format!("{call} Geometry")).succeeded();
    assert!(!quiet.out().contains("no such folder") && !quiet.err().contains("no such folder"));
    let text = dir.text("human.osim");
    let two = text.replace("<scale_factors>1 1 1</scale_factors>", "<scale_factors>1 1</scale_factors>");
    assert_ne!(text, two);
    dir.write("two.osim", two);
    let call = "add two.osim --feet calcn_r --count 2 --pad 0.01 --from falisse2022";
    assert_refused(
        &dir,
        call,
        false,
        &["scale factors of mesh", "of body calcn_r are not three numbers, expected three"],
    );
}

/// The text of a model without the list of feet in its note, which keeps the user's spelling.
fn without_feet_in_note(text: &str) -> String {
    let (before, list) = text.split_once(" with feet=").unwrap();
    format!("{before}{}", list.split_once(' ').unwrap().1)
}
