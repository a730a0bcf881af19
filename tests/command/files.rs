//! Tests where results are written, and which files and permissions stay as they are.

use std::process::Stdio;

use crate::support::{HUMAN, TestDir, fixture};

#[test]
fn the_input_is_changed_only_on_request() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190").succeeded().wrote(&["human.scaled.osim"]);
    dir.run("human.osim --target-mass 1190").failed().wrote_nothing().says(&["exists already", "--force"]);
    dir.run("human.osim --target-mass 500 --force").succeeded().wrote(&["human.scaled.osim"]);
    dir.run("human.osim --target-mass 500 --dry-run --force").succeeded().wrote_nothing();
    assert_eq!(dir.read("human.osim"), fixture(HUMAN.0));
}

#[test]
fn in_place_keeps_a_backup_and_never_loses_an_older_one() {
    let dir = TestDir::with_human();
    dir.write("human.osim.bak", "precious");
    dir.run("human.osim --target-mass 1190 --in-place").succeeded().wrote(&["human.osim", "human.osim.bak2"]);
    assert_eq!(dir.read("human.osim.bak"), b"precious");
    assert_eq!(dir.read("human.osim.bak2"), fixture(HUMAN.0));
    let first = dir.read("human.osim");
    dir.run("human.osim --target-mass 500 --in-place").succeeded().wrote(&["human.osim", "human.osim.bak3"]);
    assert_eq!(dir.read("human.osim.bak3"), first);
    dir.run("human.osim --target-mass 100 --in-place --no-backup").succeeded().wrote(&["human.osim"]);
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 --in-place").succeeded().wrote(&["human.osim", "human.osim.bak"]);
    assert_eq!(dir.read("human.osim.bak"), fixture(HUMAN.0));
}

#[cfg(unix)]
#[test]
fn a_symlink_stays_a_symlink() {
    use std::os::unix::fs::symlink;
    let dir = TestDir::with(&[(HUMAN.0, "store/real.osim")]);
    symlink("store/real.osim", dir.path("human.osim")).unwrap();
    dir.run("human.osim --target-mass 1190 --in-place").succeeded();
    assert!(dir.path("human.osim").symlink_metadata().unwrap().is_symlink());
    assert_eq!(dir.read("human.osim"), dir.read("store/real.osim"));
    assert_ne!(dir.read("store/real.osim"), fixture(HUMAN.0));
    assert_eq!(dir.read("store/real.osim.bak"), fixture(HUMAN.0));
    // An output that links to the input counts as the input.
    let dir = TestDir::with_human();
    symlink("human.osim", dir.path("link.osim")).unwrap();
    dir.run("human.osim --target-mass 1190 -o link.osim --force")
        .usage_error()
        .wrote_nothing()
        .says(&["is an input of this run"]);
    // A link that leads nowhere is not replaced.
    symlink("nowhere.osim", dir.path("dangling.osim")).unwrap();
    dir.run("human.osim --target-mass 1190 -o dangling.osim");
    assert!(
        dir.path("dangling.osim").symlink_metadata().unwrap().is_symlink(),
        "the link was replaced by a file"
    );
}

/// The model is in a folder whose new files get another group.
#[cfg(unix)]
#[test]
fn a_changed_model_keeps_owner_and_group() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
    let dir = TestDir::with_human();
    let change_group = |name: &str, group| chown(dir.path(name), None, Some(group)).is_ok();
    if !change_group("human.osim", 54321) || !change_group(".", 12345) {
        crate::support::report_skip(
            "a_changed_model_keeps_owner_and_group",
            "this user may not give files to groups",
        );
        return;
    }
    std::fs::set_permissions(dir.path("."), PermissionsExt::from_mode(0o2775)).unwrap();
    std::fs::set_permissions(dir.path("human.osim"), PermissionsExt::from_mode(0o2664)).unwrap();
    dir.run("human.osim --target-mass 1190 --in-place").succeeded();
    let metadata = dir.path("human.osim").metadata().unwrap();
    assert_eq!((metadata.gid(), metadata.mode() & 0o7777), (54321, 0o2664));
}

#[cfg(unix)]
#[test]
fn a_changed_model_keeps_its_permissions() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt};
    let dir = TestDir::with_human();
    let mode = |name: &str| dir.path(name).metadata().unwrap().mode() & 0o7777;
    for bits in [0o640, 0o600, 0o444] {
        std::fs::set_permissions(dir.path("human.osim"), PermissionsExt::from_mode(bits)).unwrap();
        dir.run(&format!("human.osim --target-mass 1190 -o {bits:o}.osim")).succeeded();
        assert_eq!(mode(&format!("{bits:o}.osim")), bits, "{bits:o}");
    }
    std::fs::set_permissions(dir.path("human.osim"), PermissionsExt::from_mode(0o640)).unwrap();
    dir.run("human.osim --target-mass 1190 --in-place").succeeded();
    assert_eq!((mode("human.osim"), mode("human.osim.bak")), (0o640, 0o640));
    for (kg, bits) in [(1500, 0o2664), (1600, 0o2660)] {
        std::fs::set_permissions(dir.path("human.osim"), PermissionsExt::from_mode(bits)).unwrap();
        dir.run(&format!("human.osim --target-mass {kg} --in-place")).succeeded();
        assert_eq!(mode("human.osim"), bits);
        // A copy is another file: its group got no right from anybody.
        dir.run(&format!("human.osim --target-mass 70 -o {kg}.osim")).succeeded();
        assert_eq!(mode(&format!("{kg}.osim")), bits & 0o777);
    }
    // Replacing a file keeps that file's permissions.
    dir.write("out.osim", "old");
    std::fs::set_permissions(dir.path("out.osim"), PermissionsExt::from_mode(0o604)).unwrap();
    dir.run("human.osim --target-mass 2000 -o out.osim --force").succeeded();
    assert_eq!(mode("out.osim"), 0o604);
}

#[test]
fn standard_input_goes_to_standard_output() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 -o file.osim").succeeded();
    let piped = dir.run_with_stdin("- --target-mass 1190", &fixture(HUMAN.0)).succeeded().wrote_nothing();
    assert_eq!(piped.stdout, dir.read("file.osim"));
    assert!(
        piped.err().contains("contacts taken as made for 62 kg"),
        "the table goes to standard error: {}",
        piped.err()
    );
    let to_stdout = dir.run("human.osim --target-mass 1190 -o -").succeeded().wrote_nothing();
    assert_eq!(to_stdout.stdout, dir.read("file.osim"));
    let quiet = dir.run("human.osim --target-mass 1190 -o - --quiet").succeeded();
    assert!(quiet.stderr.is_empty(), "{}", quiet.err());
    dir.run_with_stdin("- --target-mass 1190 -o other.osim", &fixture(HUMAN.0))
        .succeeded()
        .wrote(&["other.osim"]);
    assert_eq!(dir.read("other.osim"), dir.read("file.osim"));
    let metadata = dir.run_with_stdin("inspect - --format json", &fixture(HUMAN.0)).succeeded();
    assert!(metadata.out().contains("\"contacts_mass_kg\":{\"value\":62"), "{}", metadata.out());
    dir.run_with_stdin("- --target-mass 1190", b"").failed();
}

#[test]
fn json_is_not_mixed_into_the_model_on_standard_output() {
    // Standard input defaults to standard output, so JSON there is a usage error as with -o -.
    let dir = TestDir::new();
    let run = dir.run_with_stdin("- --target-mass 1190 --format json", &fixture(HUMAN.0));
    let models = run.out().matches("<OpenSimDocument").count();
    assert!(models == 0 || !run.out().starts_with('{'), "JSON and a model on one stream");
    let run = dir.run_with_stdin("- --target-mass 1190 --diff", &fixture(HUMAN.0));
    assert!(
        !(run.out().contains("<OpenSimDocument") && run.out().contains("@@")),
        "a diff and a model on one stream"
    );
}

fn folder_of_models() -> TestDir {
    TestDir::with(&[
        ("format/v40000.osim", "lib/right/foot.osim"),
        ("format/v30000.osim", "lib/left/foot.osim"),
        ("format/v20001.osim", "lib/UPPER.OSIM"),
        ("bad/no_contacts.osim", "lib/none.osim"),
        ("format/v40000.osim", "lib/before.scaled.osim"),
        ("bad/not_xml.osim", "lib/notes.txt"),
    ])
}

#[test]
fn a_folder_keeps_its_structure_and_earlier_outputs_are_skipped() {
    let dir = folder_of_models();
    dir.run("lib --target-mass 492 -d out")
        .succeeded()
        .wrote(&["out/UPPER.OSIM", "out/left/foot.osim", "out/right/foot.osim"])
        .says(&["outputs of this tool (*.scaled.osim) skipped: 1", "1 skipped (no contacts)"]);
    // The output folder inside the walked one is not walked.
    let dir = folder_of_models();
    dir.run("lib --target-mass 492 -d lib/out").succeeded();
    dir.run("lib --target-mass 492 -d lib/out --force").succeeded();
    assert!(!dir.has("lib/out/out"));
    let own = dir.run("lib --target-mass 492 -d lib").failed().wrote_nothing();
    own.says(&["would be written over its models: name another folder with -d DIR"]);
    // Beside the models, run twice: no copies of copies.
    let dir = folder_of_models();
    dir.run("lib --target-mass 492").succeeded();
    dir.run("lib --target-mass 492 --force").succeeded();
    assert!(dir.files().keys().all(|name| !name.contains("scaled.scaled")));
}

#[test]
fn two_equal_outputs_are_refused_before_anything_is_written() {
    let dir = TestDir::with(&[
        ("format/v40000.osim", "a/foot.osim"),
        ("format/v30000.osim", "b/FOOT.osim"),
        ("format/v30000.osim", "c/foot.osim"),
        ("format/v20001.osim", "a/other.osim"),
    ]);
    dir.run("a/other.osim a/foot.osim c/foot.osim --target-mass 5 -d out")
        .usage_error()
        .wrote_nothing()
        .says(&["a/foot.osim", "c/foot.osim"]);
    dir.run("a/other.osim a/foot.osim b/FOOT.osim --target-mass 5 -d out")
        .usage_error()
        .wrote_nothing()
        .says(&["b/FOOT.osim"]);
    assert!(!dir.has("out"));
}

#[test]
fn a_model_that_is_named_twice_is_changed_once() {
    for second_name in ["human.osim", "./human.osim", "."] {
        let dir = TestDir::with_human();
        let call = format!("set human.osim {second_name} stiffness=x2 --in-place");
        dir.run(&call).succeeded().wrote(&["human.osim", "human.osim.bak"]);
        assert!(dir.text("human.osim").contains("<stiffness>2000000</stiffness>"), "{second_name}");
        assert_eq!(dir.read("human.osim.bak"), fixture(HUMAN.0), "{second_name}");
    }
}

#[test]
fn a_closed_pipe_is_not_a_failure() {
    let dir = TestDir::with_human();
    for arguments in
        ["human.osim --target-mass 1190 -o -", "inspect human.osim --format json", "--help", "explain"]
    {
        let mut child = dir.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // Closed before anything is written: the first write meets a broken pipe.
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{arguments}: {stderr}");
        assert!(!stderr.contains("error") && !stderr.contains("panicked"), "{arguments}: {stderr}");
    }
}

#[test]
fn a_force_set_and_its_geometry_are_written_together() {
    let pair = [
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ("format/standalone_model_without_contacts.osim", "model.osim"),
    ];
    let dir = TestDir::with(&pair);
    dir.run("forces.xml --geometry geometry.xml --model model.osim --target-mass 492")
        .succeeded()
        .wrote(&["forces.scaled.xml", "geometry.scaled.xml"])
        .says(&["contacts taken as made for 61.5 kg"]);
    assert!(dir.text("forces.scaled.xml").contains("<stiffness>2469135.6</stiffness>"));
    assert!(dir.text("geometry.scaled.xml").contains("<radius>0.065</radius>"));
    dir.run("forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 -o f.xml --geometry-output g.xml").succeeded().wrote(&["f.xml", "g.xml"]);
    // The note is about both files, and a mixed pair is refused.
    dir.run("f.xml --geometry g.xml --target-mass 61.5 -d back")
        .succeeded()
        .says(&["contacts made for 492 kg (note"]);
    dir.run("f.xml --geometry geometry.xml --target-mass 100 -d mixed").failed().wrote_nothing();
    // Where one of the two cannot be written, neither is.
    let dir = TestDir::with(&pair);
    dir.write("geometry.scaled.xml", "precious");
    dir.run("forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492")
        .failed()
        .wrote_nothing();
    let dir = TestDir::with(&pair);
    dir.run("forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 --in-place")
        .succeeded()
        .wrote(&["forces.xml", "forces.xml.bak", "geometry.xml", "geometry.xml.bak"]);
}

#[test]
fn a_compiled_model_beside_the_output_causes_a_warning() {
    let dir = TestDir::with_human();
    dir.write("F_human.scaled.so", "compiled");
    dir.run("human.osim --target-mass 1190")
        .succeeded()
        .says(&["F_human.scaled.so", "compiled-model-beside"]);
    let dir = TestDir::with_human();
    dir.write("F_human.dll", "compiled");
    dir.run("human.osim --target-mass 1190 --in-place").succeeded().says(&["F_human.dll"]);
    let dir = TestDir::with_human();
    dir.write("F_human2.dll", "compiled");
    let run = dir.run("human.osim --target-mass 1190 --in-place").succeeded();
    assert!(!run.out().contains("compiled-model-beside"));
}

#[test]
fn no_run_leaves_a_temporary_file() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 --in-place").succeeded();
    dir.run("human.osim --target-mass 5 -d out/deep").succeeded().wrote(&["out/deep/human.osim"]);
    dir.run("human.osim --target-mass 7 -d out/deep").failed();
    assert!(
        dir.files().keys().all(|name| !name.contains(".osim-contact-scale-")),
        "{:?}",
        dir.files().keys()
    );
}

/// A folder has a model and the force set of the same model. The contacts count once.
#[test]
fn contacts_of_a_set_and_its_model_count_once() {
    let dir = TestDir::with(&[("format/v40000.osim", "model.osim")]);
    let text = dir.text("model.osim");
    let (start, end) = (text.find("<ForceSet").unwrap(), text.find("</ForceSet>").unwrap());
    let set =
        format!("<OpenSimDocument Version=\"40000\">{}</ForceSet></OpenSimDocument>", &text[start..end]);
    dir.write("forces.xml", set);
    let metadata = |call: &str| -> serde_json::Value {
        serde_json::from_str(&dir.run(&format!("inspect {call} --format json")).succeeded().out()).unwrap()
    };
    let alone = metadata("model.osim");
    for beside in ["--model model.osim", "--geometry model.osim", "--geometry model.osim --model model.osim"]
    {
        let with = metadata(&format!("forces.xml {beside}"));
        for field in ["mass_kg", "spheres_per_limb", "standing", "figures"] {
            assert_eq!(with[field], alone[field], "{beside}: {field}");
        }
        assert_eq!(with["spheres"].as_array().unwrap().len(), 4, "{beside}");
    }
}
