//! `add --feet`: spheres under the meshes of bones, and feet that cannot be laid.

use serde_json::Value;

use crate::placed::{HUMAN, human, inspected, refused, spheres};
use crate::support::Bench;

#[test]
fn spheres_are_laid_under_bones() {
    let bench = human();
    let call = "add human.osim --feet calcn_r,toes_r,calcn_l,toes_l --count 4 --pad 0.01";
    bench.run(&format!("{call} --from falisse2022 -o out.osim")).done();
    let seen = inspected(&bench, "out.osim");
    let found = spheres(&seen);
    let names: Vec<&str> = found.keys().map(String::as_str).collect();
    assert_eq!(names.len(), 8);
    for (name, (place, radius)) in &found {
        // As large against the body as the reference's: both weigh 62 kg.
        assert_eq!(*radius, 0.032, "{name}");
        if let Some(right) = name.strip_suffix("_l") {
            let (other, _) = found[&format!("{right}_r")];
            let apart = [place[0] - other[0], place[1] - other[1], place[2] + other[2]];
            assert!(apart.iter().all(|apart| apart.abs() < 1e-12), "{name}: {place:?}, {other:?}");
        }
    }
    // The bodies hang without a turn about x or z: all bottoms of one foot are in a plane of its frame.
    let heights = found.iter().filter(|(name, _)| name.ends_with("_r"));
    let heights: Vec<f64> = heights
        .map(|(name, (place, radius))| {
            place[1] - radius + if name.starts_with("toes") { -0.002 } else { 0.0 }
        })
        .collect();
    assert!(heights.iter().all(|height| (height - heights[0]).abs() < 1e-12), "{names:?}: {heights:?}");
    bench.run("remove out.osim -o back.osim").done();
    assert_eq!(bench.read("back.osim"), bench.read("human.osim"));

    // The same numbers as for a table of these places; a radius that is said.
    bench.run(&format!("{call} --indentation 0.1 --class smooth --radius 0.02 -o made.osim")).done();
    assert!(spheres(&inspected(&bench, "made.osim")).values().all(|(_, radius)| *radius == 0.02));
}

#[test]
fn feet_that_cannot_be_laid_are_refused() {
    let bench = human();
    let feet = "add human.osim --from falisse2022 --feet";
    let usage = [
        ("calcn_r --count 4", "--pad METRES is missing: bones have no skin"),
        ("calcn_r --count 4", "0.033 under a human heel"),
        ("calcn_r --pad 0.01", "--count N is missing"),
        ("calcn_r --pad -0.01 --count 4", "--pad '-0.01': expected"),
        ("calcn_r --count 0 --pad 0.01", "expected a whole number from 1 to 60"),
        ("calcn_r --count 4 --pad 0.01 --radius follow", "--radius follow says nothing here"),
    ];
    for (call, words) in usage {
        refused(&bench, &format!("{feet} {call}"), true, &[words]);
    }
    for (call, words) in [
        ("calcn_r,foot_r --count 4 --pad 0.01", "there is no body foot_r, the model has pelvis"),
        ("pelvis --count 4 --pad 0.01", "no mesh is attached to body pelvis"),
        ("pelvis --count 4 --pad 0.01", "--contacts TABLE"),
    ] {
        refused(&bench, &format!("{feet} {call}"), false, &[words]);
    }
    let mesh = crate::support::fixture("feet/Geometry/r_human_foot.vtp");
    for (name, bytes) in [("cut off", &mesh[..mesh.len() / 2]), ("empty", b"")] {
        bench.write("Geometry/r_human_foot.vtp", bytes);
        let ran = bench.run(&format!("{feet} calcn_r --count 4 --pad 0.01 --format json")).failed();
        let error: Value = serde_json::from_str(&ran.out()).unwrap();
        assert_eq!(error["error"]["code"], "bad-mesh", "{name}: {error}");
    }
    // Three points, and four in a line.
    for points in ["v 0 0 0\nv 1 0 0\nv 0 1 0\n", "v 0 0 0\nv 1 1 1\nv 2 2 2\nv 3 3 3\n"] {
        let text = bench.text("human.osim").replace("r_human_foot.vtp", "bone.obj");
        bench.write("bone.osim", text);
        bench.write("Geometry/bone.obj", points);
        let call = "add bone.osim --from falisse2022 --feet calcn_r --count 2 --pad 0.01";
        let words =
            ["mesh bone.obj of body calcn_r", "expected", "give the places in a table: --contacts TABLE"];
        refused(&bench, call, false, &words);
    }

    let other =
        Bench::with(&[(HUMAN, "human.osim"), ("feet/Geometry/r_human_foot.vtp", "bones/r_human_foot.vtp")]);
    let call = format!("{feet} calcn_r --count 4 --pad 0.01");
    refused(
        &other,
        &call,
        false,
        &["shows mesh r_human_foot.vtp, which is in none of the folders", "--geometry-dir DIR"],
    );
    other.run(&format!("{call} --geometry-dir bones -o out.osim")).done();
}

/// In the cell of a manifest, too, where semicolons are between the values of other lists.
#[test]
fn bodies_are_listed_as_people_write_them() {
    let bench = human();
    let add = |feet: &str, to: &str| {
        let (of, with) = ("add human.osim --count 2 --pad 0.01 --from falisse2022 -o", ["--feet", feet]);
        let words: Vec<&str> = of.split(' ').chain([to]).chain(with).collect();
        let ran = bench.run_words(&words);
        (ran.status.code(), String::from_utf8(ran.stderr).unwrap())
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
        assert_eq!(without_list(&bench.text(&name)), without_list(&bench.text("one.osim")), "{feet}");
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
    bench.write(
        "m.csv",
        "model,verb,feet,count,pad,from,output\nhuman.osim,add,\"calcn_r,calcn_l\",2,0.01,falisse2022,a.osim\n\
         human.osim,add,calcn_r;calcn_l,2,0.01,falisse2022,b.osim\n",
    );
    bench.run("batch m.csv").done();
    for name in ["a.osim", "b.osim"] {
        assert_eq!(bench.read(name), bench.read("one.osim"), "{name}");
    }
    bench.write("t.csv", "name,body,x,y,z,radius\nheel_r,/bodyset/calcn_r,0,0,0,0.03\n");
    bench.run("add human.osim --contacts t.csv --from falisse2022 --spheres 1 -o t.osim").done();
    bench.write("t.csv", "name,body,x,y,z,radius\nheel_r,calcn_R,0,0,0,0.03\n");
    let call = "add human.osim --contacts t.csv --from falisse2022 --spheres 1";
    refused(&bench, call, false, &["there is no body calcn_R", ": did you mean calcn_r?"]);
}

#[test]
fn a_folder_of_meshes_that_is_not_there_is_named() {
    let bench = human();
    let call =
        "add human.osim --feet calcn_r --count 2 --pad 0.01 --from falisse2022 --dry-run --geometry-dir";
    bench.run(&format!("{call} nowhere")).done().says(&["--geometry-dir nowhere: there is no such folder"]);
    let quiet = bench.run(&format!("{call} Geometry")).done();
    assert!(!quiet.out().contains("no such folder") && !quiet.err().contains("no such folder"));
    let text = bench.text("human.osim");
    let two = text.replace("<scale_factors>1 1 1</scale_factors>", "<scale_factors>1 1</scale_factors>");
    assert_ne!(text, two);
    bench.write("two.osim", two);
    let call = "add two.osim --feet calcn_r --count 2 --pad 0.01 --from falisse2022";
    refused(
        &bench,
        call,
        false,
        &["scale factors of mesh", "of body calcn_r are not three numbers, expected three"],
    );
}

/// A model without the list of feet in its note, which is as somebody wrote it.
fn without_list(text: &str) -> String {
    let (before, list) = text.split_once(" with feet=").unwrap();
    format!("{before}{}", list.split_once(' ').unwrap().1)
}
